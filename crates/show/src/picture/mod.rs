//! Pictures of an experiment as SVG, one kind a file. All are light, small, and need nothing but themselves.

mod axis;
mod basis;
mod blend;
mod camera;
pub(crate) mod colour_bar;
mod conditioning;
mod construction;
mod convergence;
mod cover;
mod curvature;
mod deformation;
mod drawing;
mod map;
mod mode;
mod multiples;
mod panels;
mod region;
mod svg;
mod view;

pub use basis::basis_functions;
pub use conditioning::conditioning;
pub use construction::{AT_FIGURE_6, construction};
pub use drawing::{PICTURES, Picture};
pub use multiples::{Multiples, Panel, multiples};
pub use region::{REGION_DEGREES, nonnegativity_region};
pub(crate) use svg::Escaped;

use crate::scene::Scene;
use plateau::Results;

/// All pictures that an experiment gives rise to, in the order of a report. Those with nothing to show are left out: a
/// minimal surface has no mean curvature.
pub fn pictures(results: &Results, scene: Option<&Scene<'_>>) -> Vec<Picture> {
    let mut pictures = Vec::new();
    if let Some(scene) = scene {
        pictures.extend(match deformation::frames(results, scene) {
            Some(frames) => deformation::picture(scene, &frames),
            None => view::picture(scene),
        });
        pictures.extend(map::picture(scene));
        pictures.extend(mode::picture(scene));
    }
    pictures.extend(blend::picture(results));
    pictures.extend(convergence::picture(results));
    pictures.extend(curvature::picture(results.curves()));
    pictures
}
