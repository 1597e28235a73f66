//! Surfaces as they stand in space, with their control nets: one camera and one scale for all methods.

use surfaces::Point;

use super::camera::Camera;
use super::cover::Cover;
use super::panels::arrange;
use super::svg::{ACCENT, Anchor, FAINT, Font, INK, Length, Svg, path};
use super::{Picture, colour_bar};
use crate::colour;
use crate::scene::{Field, LARGEST_NET, LineKind, MOST_NET_DEGREE, Sample, Scene, Shown, spread};
use plateau::Notation;

/// Most views in one picture.
pub(super) const PANELS: usize = 12;
/// Corners of the faces of all surfaces of a picture together: bounds its size.
pub(super) const CORNERS: usize = 13_900;
/// Width and height of one view.
pub(super) const CELL: [f64; 2] = [290.0, 290.0];
/// Height of the title above it.
pub(super) const HEAD: f64 = 42.0;
/// How far colours run into each other, as a share of half the diagonal of a face: no face is seen by itself, however large it is printed.
const SMOOTHING: f64 = 0.6;
/// Space for the colour bar.
pub(super) const BAR: f64 = 110.0;

/// Whether there is mean curvature to be seen: least areas have the little that their degree leaves of 0.
fn shows_mean_curvature(scene: &Scene<'_>) -> bool {
    let is_least = scene.surfaces.iter().all(Shown::is_least);
    scene.full_scale(Field::Mean).is_some() && !(is_least && scene.full_scale(Field::Gauss).is_some())
}

/// The views of all surfaces, coloured by mean curvature, or by Gauss curvature where they are all minimal.
pub(super) fn picture(scene: &Scene<'_>) -> Option<Picture> {
    let field = if shows_mean_curvature(scene) { Field::Mean } else { Field::Gauss };
    let full = scene.full_scale(field);
    let chosen: Vec<&Shown<'_>> =
        spread(scene.surfaces.len(), PANELS).into_iter().map(|k| &scene.surfaces[k]).collect();
    let [columns, rows] = arrange(chosen.len(), 4);
    let cell = [CELL[0], CELL[1] + HEAD];
    let bar = if full.is_some() { BAR } else { 0.0 };
    let has_net = chosen.iter().any(|shown| shown.sample.chart().is_some() && shown.has_clear_net());
    let has_patches = chosen.iter().any(|shown| shown.sample.chart().is_none());
    let title = match (has_net, has_patches) {
        (false, false) => "The surfaces",
        (true, false) => "The surfaces with their control nets",
        (false, true) => {
            "The surfaces with the vertices and borders of their patches, red where they meet at an angle"
        }
        (true, true) => {
            "The surfaces with their control nets, or the vertices and borders of their patches, red where they meet at an angle"
        }
    };
    let mut svg = Svg::new(cell[0] * columns as f64 + bar, cell[1] * rows as f64, title);
    let camera = Camera::fitting(scene, &chosen, true, CELL);
    for (k, shown) in chosen.iter().enumerate() {
        let (x, y) = (cell[0] * (k % columns) as f64, cell[1] * (k / columns) as f64);
        let mut caption = format!("area {} length²", Notation::Digits(7).of(shown.done.figures.area.value));
        let times = shown.net_size();
        if times > LARGEST_NET {
            caption += &format!("; net {}× larger", Notation::Digits(2).of(times));
        }
        svg.heading([x + 16.0, y], shown.name, 34, &caption);
        let clip = format!("view-{k}");
        svg.clip(&clip, [x, y + HEAD, x + CELL[0], y + HEAD + CELL[1]]);
        svg.open(format_args!(r#"clip-path="url(#{clip})""#));
        let at = [x + 0.5 * CELL[0], y + HEAD + 0.5 * CELL[1]];
        surface(&mut svg, scene, shown, &camera, at, full.map(|full| (field, full)), CORNERS / chosen.len());
        if shown.has_clear_net() {
            control_net(&mut svg, scene, shown, &camera, at);
        }
        svg.close();
    }
    axes(&mut svg, &camera, [30.0, cell[1] - 24.0]);
    if let (Some(full), Some(largest)) = (full, scene.largest(field)) {
        let at = [cell[0] * columns as f64 + 12.0, HEAD + 30.0, CELL[1] - 60.0];
        colour_bar::draw(&mut svg, at, field, full, largest);
    }
    let coloured = full.zip(scene.largest(field)).map_or(String::new(), |(full, largest)| {
        let clipped = colour_bar::clipped(field, full, largest);
        format!(", coloured by {} {}{clipped}", field.name(), field.symbol())
    });
    let undrawn = undrawn(&chosen);
    let caption = format!("{title}, from one direction and on one scale{coloured}{undrawn}.");
    Some(Picture { name: "surfaces", caption, svg: svg.finish() })
}

/// Which control nets are not drawn, if any.
fn undrawn(chosen: &[&Shown<'_>]) -> String {
    let is_large = |shown: &&Shown<'_>| shown.net_size() > LARGEST_NET;
    let is_dense = |shown: &&Shown<'_>| shown.net.degree > MOST_NET_DEGREE;
    let which = match (chosen.iter().any(is_large), chosen.iter().any(is_dense)) {
        (false, false) => return String::new(),
        (true, false) => "that would dwarf their surface".to_owned(),
        (false, true) => format!("above degree {MOST_NET_DEGREE}, which would hide their surface,"),
        (true, true) => format!("above degree {MOST_NET_DEGREE}, and those that would dwarf their surface,"),
    };
    format!("; nets {which} are not drawn")
}

/// Draws the faces of a surface, the farthest first; as fine as `most` corners of faces allow.
pub(super) fn surface(
    svg: &mut Svg,
    scene: &Scene<'_>,
    shown: &Shown<'_>,
    camera: &Camera,
    at: [f64; 2],
    scale: Option<(Field, f64)>,
    most: usize,
) {
    let sample = &shown.sample;
    let stride = [1, 2, 4]
        .into_iter()
        .find(|&s| sample.faces(s).map(|face| face.len()).sum::<usize>() <= most)
        .unwrap_or(4);
    let light = (camera.towards + camera.up * 0.7 - camera.right * 0.5).unit().unwrap_or(camera.towards);
    let mut size = 0.0;
    let mut faces: Vec<(f64, String)> = sample
        .faces(stride)
        .map(|corners| {
            let points: Vec<Point> = corners.iter().map(|&k| scene.local(sample.points[k])).collect();
            let share = 1.0 / corners.len() as f64;
            let middle = points.iter().fold(Point::ZERO, |sum, &p| sum + p) * share;
            // Twice the area of the face, as a vector.
            let normal = (points[2] - points[0]).cross(points[points.len() - 1] - points[1]);
            let bright = normal.unit().map_or(1.0, |n| 0.68 + 0.32 * n.dot(light).abs());
            let plain = scale.map_or([233, 236, 240], |(field, full)| {
                let values = sample.values(field);
                let sum: Option<f64> = corners.iter().map(|&k| values[k].map(|x| x / full)).sum();
                sum.map_or(colour::NONE, |sum| colour::diverging(sum * share))
            });
            let centre = camera.project(middle, at);
            let corner = camera.project(points[0], at);
            size += libm::hypot(corner[0] - centre[0], corner[1] - centre[1]);
            // A little larger, so that no gap shows between neighbours.
            let grown = points.iter().map(|&p| {
                let q = camera.project(p, at);
                let away = [q[0] - centre[0], q[1] - centre[1]];
                let grow = 1.0 + 0.35 / libm::hypot(away[0], away[1]).max(0.35);
                [centre[0] + grow * away[0], centre[1] + grow * away[1]]
            });
            let fill = colour::hex(colour::lit(plain, bright));
            (middle.dot(camera.towards), format!("<path fill=\"{fill}\" d=\"{}\"/>\n", path(grown, true)))
        })
        .collect();
    let size = size / faces.len().max(1) as f64;
    faces.sort_by(|a, b| a.0.total_cmp(&b.0));
    // Lines stay sharp, and faces hide what lies behind them.
    let cover = Cover::new(scene, sample, camera, stride);
    let rims: Vec<Vec<Point>> = rims(scene, sample).collect();
    rims.iter().for_each(|rim| rim_line(svg, rim, camera, at));
    svg.open_smooth(SMOOTHING * size);
    faces.iter().for_each(|(_, face)| svg.raw(face));
    svg.close();
    borders(scene, sample, (camera, &cover), at, stride).iter().for_each(|border| svg.raw(border));
    rims.iter().flat_map(|rim| seen(rim, &cover)).for_each(|part| rim_line(svg, part, camera, at));
}

/// The rims of a surface; closed ones end where they begin.
fn rims(scene: &Scene<'_>, sample: &Sample) -> impl Iterator<Item = Vec<Point>> {
    let rims = sample.lines.iter().filter(|line| line.kind == LineKind::Rim);
    rims.map(|line| line.points.iter().map(|&k| scene.local(sample.points[k])).collect())
}

fn rim_line(svg: &mut Svg, points: &[Point], camera: &Camera, at: [f64; 2]) {
    let is_closed = points.first() == points.last();
    let places = points[usize::from(is_closed)..].iter();
    let line = path(places.map(|&p| camera.project(p, at)), is_closed);
    svg.element(format_args!(
        r#"path d="{line}" fill="none" stroke="{INK}" stroke-width="0.9" stroke-linejoin="round" stroke-opacity="0.75""#
    ));
}

/// The parts of a rim that no face hides. What is hidden for the length of one piece only is at the edge of what is seen.
fn seen<'p>(rim: &'p [Point], cover: &Cover<'_>) -> Vec<&'p [Point]> {
    let hidden: Vec<bool> = rim.windows(2).map(|ends| cover.hides((ends[0] + ends[1]) * 0.5)).collect();
    let is_hidden = |k: usize| {
        let beside = [k.checked_sub(1), Some(k + 1)].into_iter().flatten();
        hidden[k] && beside.filter_map(|k| hidden.get(k)).any(|hidden| *hidden)
    };
    let mut parts = Vec::new();
    let mut from = 0;
    for k in 0..=hidden.len() {
        if k == hidden.len() || is_hidden(k) {
            if k > from {
                parts.push(&rim[from..=k]);
            }
            from = k + 1;
        }
    }
    parts
}

/// The borders of patches in pieces as long as faces, without those that lie behind a face.
fn borders(
    scene: &Scene<'_>,
    sample: &Sample,
    (camera, cover): (&Camera, &Cover<'_>),
    at: [f64; 2],
    stride: usize,
) -> Vec<String> {
    let mut pieces = Vec::new();
    if sample.chart().is_some() {
        return pieces;
    }
    for line in &sample.lines {
        let style = match line.kind {
            LineKind::Rim => continue,
            LineKind::Border => format!(r#"stroke="{INK}" stroke-width="0.5" stroke-opacity="0.6""#),
            LineKind::Kink => format!(r#"stroke="{ACCENT}" stroke-width="1.6" stroke-linecap="round""#),
        };
        for ends in line.points.chunks(stride).zip(line.points.chunks(stride).skip(1)) {
            let ends = [ends.0[0], ends.1[0]].map(|k| scene.local(sample.points[k]));
            if !cover.hides((ends[0] + ends[1]) * 0.5) {
                let d = path(ends.map(|p| camera.project(p, at)), false);
                pieces.push(format!("<path d=\"{d}\" fill=\"none\" {style}/>\n"));
            }
        }
    }
    pieces
}

fn control_net(svg: &mut Svg, scene: &Scene<'_>, shown: &Shown<'_>, camera: &Camera, at: [f64; 2]) {
    let net = &shown.net;
    let places: Vec<[f64; 2]> = net.points.iter().map(|&p| camera.project(scene.local(p), at)).collect();
    let lines: String = net.edges.iter().map(|&[p, q]| path([places[p], places[q]], false)).collect();
    let dense = net.points.len() > 64;
    let width = if dense { 0.4 } else { 0.8 };
    // Many lines would hide the surface.
    let opacity = 0.6 * (60.0 / net.edges.len().max(60) as f64).sqrt();
    svg.element(format_args!(
        r#"path d="{lines}" fill="none" stroke="{INK}" stroke-width="{width}" stroke-opacity="{opacity:.2}""#
    ));
    let radius = if dense { 1.2 } else { 2.3 };
    // Of a net all points are seen, of vertices those that no face hides.
    let cover = shown.sample.chart().is_none().then(|| Cover::new(scene, &shown.sample, camera, 1));
    let hidden = |k: usize| cover.as_ref().is_some_and(|cover| cover.hides(scene.local(net.points[k])));
    for (k, (&[x, y], &boundary)) in places.iter().zip(&net.on_boundary).enumerate() {
        if hidden(k) {
            continue;
        }
        let fill = if boundary { INK } else { "#ffffff" };
        let (x, y) = (Length(x), Length(y));
        svg.element(format_args!(
            r#"circle cx="{x}" cy="{y}" r="{radius}" fill="{fill}" stroke="{INK}" stroke-width="0.8""#
        ));
    }
}

/// The directions of x, y and z.
pub(super) fn axes(svg: &mut Svg, camera: &Camera, origin: [f64; 2]) {
    let units = [("x", [1.0, 0.0, 0.0]), ("y", [0.0, 1.0, 0.0]), ("z", [0.0, 0.0, 1.0])];
    for (name, unit) in units {
        let unit = Point::from(unit);
        let way = [unit.dot(camera.right), -unit.dot(camera.up)];
        let end = |length: f64| [origin[0] + length * way[0], origin[1] + length * way[1]];
        svg.line(origin, end(18.0), FAINT, 1.2);
        let [x, y] = end(25.0);
        svg.text([x, y + 4.0], Anchor::Middle, Font::SMALL, name);
    }
}
