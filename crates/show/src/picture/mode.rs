//! How surfaces that are unstable give way: the displacement of the second variation's smallest value as colour.

use super::camera::Camera;
use super::panels::arrange;
use super::svg::Svg;
use super::view::{self, BAR, CELL, CORNERS, HEAD, PANELS};
use super::{Picture, colour_bar};
use crate::scene::{Field, Scene, Shown};
use plateau::Notation;

/// The views of the unstable surfaces; none if there is none.
pub(super) fn picture(scene: &Scene<'_>) -> Option<Picture> {
    let unstable = scene.surfaces.iter().filter(|shown| shown.is_unstable());
    let chosen: Vec<(&Shown<'_>, f64)> =
        unstable.filter_map(|shown| Some((shown, shown.with_mode()?.1))).take(PANELS).collect();
    if chosen.is_empty() {
        return None;
    }
    let [columns, rows] = arrange(chosen.len(), 4);
    let cell = [CELL[0], CELL[1] + HEAD];
    let title = "The unstable surfaces, coloured by the displacement that lowers their area";
    let mut svg = Svg::new(cell[0] * columns as f64 + BAR, cell[1] * rows as f64, title);
    let shown: Vec<&Shown<'_>> = chosen.iter().map(|(shown, _)| *shown).collect();
    let camera = Camera::fitting(scene, &shown, false, CELL);
    for (k, (shown, smallest)) in chosen.iter().enumerate() {
        let (x, y) = (cell[0] * (k % columns) as f64, cell[1] * (k / columns) as f64);
        let caption = format!("unstable: second variation {}", Notation::Digits(4).of(*smallest));
        svg.heading([x + 16.0, y], shown.name, 34, &caption);
        let at = [x + 0.5 * CELL[0], y + HEAD + 0.5 * CELL[1]];
        view::surface(&mut svg, scene, shown, &camera, at, Some((Field::Mode, 1.0)), CORNERS / chosen.len());
    }
    view::axes(&mut svg, &camera, [30.0, cell[1] - 24.0]);
    let bar = [cell[0] * columns as f64 + 12.0, HEAD + 30.0, CELL[1] - 60.0];
    colour_bar::draw(&mut svg, bar, Field::Mode, 1.0, 1.0);
    let caption = format!("{title}, along their normals, the largest 1; it keeps the border.");
    Some(Picture { name: "mode", caption, svg: svg.finish() })
}
