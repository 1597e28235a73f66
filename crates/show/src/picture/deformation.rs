//! A deformation as a strip of frames.

use super::camera::Camera;
use super::svg::{Anchor, Font, Svg};
use super::view::{CORNERS, axes, surface};
use super::{Picture, colour_bar};
use crate::scene::{Field, Scene, Shown, spread};
use plateau::{Notation, Results};

/// Most frames of a strip.
const FRAMES: usize = 6;
/// Width and height of a frame.
const CELL: [f64; 2] = [190.0, 220.0];
/// Height of the title above it.
const HEAD: f64 = 42.0;
/// Space for the colour bar.
const BAR: f64 = 110.0;

/// The surfaces of the scene that are frames of a deformation: all but the first, if they have weights.
pub(super) fn frames<'a, 'b>(results: &Results, scene: &'b Scene<'a>) -> Option<Vec<&'b Shown<'a>>> {
    if results.methods().len() < 3 || scene.surfaces.len() < 3 {
        return None;
    }
    let frames: Vec<&Shown<'_>> = scene.surfaces[1..].iter().collect();
    frames.iter().all(|s| s.done.closed_form.is_some_and(|form| form.weights.is_some())).then_some(frames)
}

/// Frames side by side, coloured by Gauss curvature, which a bending does not change.
pub(super) fn picture(scene: &Scene<'_>, frames: &[&Shown<'_>]) -> Option<Picture> {
    let chosen: Vec<&Shown<'_>> = spread(frames.len(), FRAMES).into_iter().map(|k| frames[k]).collect();
    let full = scene.full_scale(Field::Gauss);
    let bar = if full.is_some() { BAR } else { 0.0 };
    let mut svg = Svg::new(CELL[0] * chosen.len() as f64 + bar, CELL[1] + HEAD, "Frames of the deformation");
    let camera = Camera::fitting(scene, &chosen, false, CELL);
    for (k, shown) in chosen.iter().enumerate() {
        let x = CELL[0] * k as f64;
        let weights = shown.done.closed_form.and_then(|form| form.weights).unwrap_or_default();
        svg.text([x + 14.0, 18.0], Anchor::Start, Font::TITLE, shown.name);
        let caption = format!("a = {}, b = {}", short(weights[0]), short(weights[1]));
        svg.text([x + 14.0, 35.0], Anchor::Start, Font::SMALL, &caption);
        let at = [x + 0.5 * CELL[0], HEAD + 0.5 * CELL[1]];
        surface(
            &mut svg,
            scene,
            shown,
            &camera,
            at,
            full.map(|full| (Field::Gauss, full)),
            CORNERS / chosen.len(),
        );
    }
    axes(&mut svg, &camera, [30.0, CELL[1] + HEAD - 24.0]);
    if let (Some(full), Some(largest)) = (full, scene.largest(Field::Gauss)) {
        let at = [CELL[0] * chosen.len() as f64 + 12.0, HEAD + 20.0, CELL[1] - 50.0];
        colour_bar::draw(&mut svg, at, Field::Gauss, full, largest);
    }
    let caption =
        "Frames of the deformation from the right helicoid to the catenoid, from one direction and on one \
                   scale, coloured by Gauss curvature K."
            .into();
    Some(Picture { name: "deformation", caption, svg: svg.finish() })
}

/// A weight; what is only rounding is 0.
fn short(weight: f64) -> String {
    if weight.abs() < 1e-12 { "0".into() } else { Notation::Digits(4).of(weight) }
}
