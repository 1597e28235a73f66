//! The surfaces as the viewer of the report reads them.

use base64::prelude::{BASE64_STANDARD, Engine};
use serde_json::{Value, json};

use crate::colour;
use crate::scene::{Chart, Field, LARGEST_NET, Line, LineKind, MOST_NET_DEGREE, Scene, Shown};
use crate::table::standing::{Standing, standings};
use plateau::{Done, Notation};
use surfaces::Domain;

/// The data of the viewer as JSON that may stand inside a script element. Points are in the frame of the scene, values in
/// units of the full scale of their field, NaN where there is none; both little-endian `f32` in base64.
pub(super) fn json(scene: Option<&Scene<'_>>) -> String {
    let value = scene.map_or(Value::Null, scene_value);
    // No text can then end the element, whatever names are in it.
    value.to_string().replace('<', "\\u003c").replace('>', "\\u003e").replace('&', "\\u0026")
}

fn scene_value(scene: &Scene<'_>) -> Value {
    let fields: Vec<(Field, f64)> =
        Field::ALL.into_iter().filter_map(|field| Some((field, scene.full_scale(field)?))).collect();
    let described: Vec<Value> = fields
        .iter()
        .map(|&(field, full)| {
            json!({
                "symbol": field.symbol(),
                "name": field.name(),
                "label": match field {
                    Field::Mean | Field::Gauss | Field::Laplacian => field.symbol(),
                    Field::Conformality => "conformality",
                    Field::Mode => "mode",
                },
                "unit": field.unit(),
                "signed": field.is_signed(),
                "full": full,
                "largest": scene.largest(field),
            })
        })
        .collect();
    let scale = |colour: &dyn Fn(f64) -> [u8; 3]| {
        let colours: Vec<u8> = (0..=255u8).flat_map(|k| colour(f64::from(k) / 255.0)).collect();
        BASE64_STANDARD.encode(colours)
    };
    let place = |wanted: Field| fields.iter().position(|(field, _)| *field == wanted);
    let best = best(scene);
    json!({
        "fields": described,
        "field": opening(&scene.surfaces[best]).into_iter().find_map(place),
        "mode": place(Field::Mode),
        "scales": [scale(&|t| colour::diverging(2.0 * t - 1.0)), scale(&colour::sequential)],
        "none": colour::NONE,
        "deformation": is_deformation(scene),
        "best": best,
        "radius": scene.radius,
        "home": { "turn": scene.direction.azimuth, "tilt": scene.direction.elevation },
        "surfaces": scene.surfaces.iter().map(|shown| surface(scene, shown, &fields)).collect::<Vec<_>>(),
    })
}

/// Whether the surfaces are the frames of a deformation, to be played one after the other.
fn is_deformation(scene: &Scene<'_>) -> bool {
    let weighted = |shown: &Shown<'_>| shown.done.closed_form.is_some_and(|form| form.weights.is_some());
    scene.surfaces.len() > 1 && scene.surfaces.iter().all(weighted)
}

/// The surface to begin with: the one of least area, if they can be compared.
fn best(scene: &Scene<'_>) -> usize {
    let rows: Vec<Option<&Done>> = scene.surfaces.iter().map(|shown| Some(shown.done)).collect();
    standings(&rows).iter().position(|standing| *standing == Standing::Best).unwrap_or(0)
}

/// The colours to begin with, of which the first that there is is meant: mean curvature where it says something, which it does not of a
/// least area; plain there, unless the surface is none that lasts. Of minimal surfaces by formula the Gauss curvature is what there is to see.
fn opening(shown: &Shown<'_>) -> Vec<Field> {
    match (shown.is_unstable(), shown.is_least()) {
        (true, _) => vec![Field::Mode],
        (false, true) => Vec::new(),
        (false, false) => vec![Field::Mean, Field::Gauss],
    }
}

fn surface(scene: &Scene<'_>, shown: &Shown<'_>, fields: &[(Field, f64)]) -> Value {
    let points = |points: &[surfaces::Point]| {
        let local = points.iter().map(|&p| <[f64; 3]>::from(scene.local(p)));
        floats(local.flat_map(|p| p.map(|x| x as f32)))
    };
    let values: Vec<String> = fields
        .iter()
        .map(|&(field, full)| {
            let values = shown.sample.values(field).iter();
            floats(values.map(|value| value.map_or(f32::NAN, |x| (x / full) as f32)))
        })
        .collect();
    let net = &shown.net;
    let figures = &shown.done.figures;
    let mut caption = format!("area {} length²", Notation::Digits(9).of(figures.area.value));
    if let Some(largest) = figures.mean_curvature_max {
        caption += &format!(", max |H| {} 1/length", Notation::Digits(4).of(largest));
    }
    if let Some((_, smallest)) = shown.with_mode() {
        let stable = if shown.is_unstable() { "unstable" } else { "stable" };
        caption += &format!("; second variation {}: {stable}", Notation::Digits(3).of(smallest));
    }
    json!({
        "name": shown.name,
        "caption": caption,
        "swings": shown.with_mode().is_some(),
        "charts": shown.sample.charts.iter().map(chart).collect::<Vec<_>>(),
        "lines": shown.sample.lines.iter().map(line).collect::<Vec<_>>(),
        "points": points(&shown.sample.points),
        "values": values,
        "net": {
            "large": shown.net_size() > LARGEST_NET,
            "many": net.degree > MOST_NET_DEGREE,
            "points": points(&net.points),
            "boundary": net.on_boundary.iter().map(|&b| u8::from(b)).collect::<Vec<_>>(),
            "edges": numbers(net.edges.iter().flatten().copied()),
        },
    })
}

/// A grid of points: those of the surface in their order, or the places of those of a face.
fn chart(chart: &Chart) -> Value {
    let mut value = json!({ "steps": chart.steps, "triangle": chart.domain == Domain::Triangle });
    if chart.flipped {
        value["flipped"] = true.into();
    }
    if let Some(places) = chart.places() {
        value["places"] = numbers(places.iter().map(|&k| k as usize)).into();
    }
    value
}

fn line(line: &Line) -> Value {
    let kind = match line.kind {
        LineKind::Rim => "rim",
        LineKind::Border => "border",
        LineKind::Kink => "kink",
    };
    json!({ "kind": kind, "points": numbers(line.points.iter().copied()) })
}

/// Places among points, of which a scene has fewer than 2¹⁶ a surface.
fn numbers(places: impl Iterator<Item = usize>) -> String {
    BASE64_STANDARD.encode(places.flat_map(|k| (k as u16).to_le_bytes()).collect::<Vec<u8>>())
}

fn floats(values: impl Iterator<Item = f32>) -> String {
    BASE64_STANDARD.encode(values.flat_map(f32::to_le_bytes).collect::<Vec<u8>>())
}
