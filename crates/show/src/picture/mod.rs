//! Pictures of an experiment as SVG, one kind a file. All are light, small, and need nothing but themselves.

mod axis;
pub(crate) mod colour_bar;
mod convergence;
mod curvature;
mod deformation;
mod map;
mod svg;
mod view;

pub(crate) use svg::Escaped;

use crate::scene::Scene;
use plateau::Results;

/// The names of all pictures there are.
pub const PICTURES: [&str; 5] = ["surfaces", "deformation", "mean-curvature", "convergence", "curvature"];

/// A picture with its name.
pub struct Picture {
    /// The name of its file, without `.svg`; one of [`PICTURES`].
    pub name: &'static str,
    /// What it shows, in a sentence.
    pub caption: String,
    /// The whole file.
    pub svg: String,
}

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
    }
    pictures.extend(convergence::picture(results));
    pictures.extend(results.curve.as_ref().and_then(curvature::picture));
    pictures
}

/// Columns and rows for so many panels, at most `most` in a row and rows as even as possible.
fn arrange(panels: usize, most: usize) -> [usize; 2] {
    let rows = panels.div_ceil(most).max(1);
    [panels.div_ceil(rows).max(1), rows]
}
