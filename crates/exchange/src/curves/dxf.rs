//! ASCII DXF: the curves among the entities of a drawing.

use std::f64::consts::{PI, TAU};

use surfaces::{EllipseArc, Point, SplineCurve};

use super::limits::{self, LARGEST_COORDINATE, MOST_CURVES, MOST_POINTS, MOST_RECORDS};
use super::{CurveFile, CurveFileError, FileCurve, Kind, Shape, trim};
use crate::{LengthUnit, Sentence, Setting};

mod entity;
mod polyline;

use entity::{Entity, Plane};

/// The curves SPLINE, LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE and POLYLINE of the section ENTITIES, named by their layers.
pub(super) fn read(text: &str) -> Result<CurveFile, CurveFileError> {
    let (entities, unit) = entity::entities(text)?;
    let mut file = CurveFile { kind: Kind::Dxf, curves: Vec::new(), unit: None, notes: Vec::new() };
    let mut passed_over: Vec<(String, usize)> = Vec::new();
    let mut points = 0;
    let mut at = 0;
    while at < entities.len() {
        let entity = &entities[at];
        at += 1;
        let shapes = match entity.kind.as_str() {
            "LINE" => vec![Shape::Polyline(vec![entity.point(10)?, entity.point(11)?])],
            "ARC" => vec![arc(entity, true)?],
            "CIRCLE" => vec![arc(entity, false)?],
            "ELLIPSE" => vec![ellipse(entity)?],
            "SPLINE" => vec![spline(entity)?],
            "LWPOLYLINE" => polyline::light(entity)?,
            "POLYLINE" => {
                let count = entities[at..].iter().take_while(|entity| entity.kind == "VERTEX").count();
                let vertices = &entities[at..at + count];
                at += count;
                match polyline::heavy(entity, vertices)? {
                    Some(shapes) => shapes,
                    None => {
                        pass_over(&mut passed_over, "mesh (POLYLINE)");
                        continue;
                    }
                }
            }
            "SEQEND" | "VERTEX" | "VIEWPORT" => continue,
            kind => {
                pass_over(&mut passed_over, kind);
                continue;
            }
        };
        for shape in shapes {
            limits::count(&mut points, 2, MOST_POINTS, "points", entity.line)?;
            let mut counter = file.curves.len();
            limits::count(&mut counter, 1, MOST_CURVES, "curves", entity.line)?;
            let name = entity.text(8).map(limits::name).filter(|layer| layer != "0").unwrap_or_default();
            file.curves.push(FileCurve { name, line: entity.line, shape, closes: false, joints: Vec::new() });
        }
    }
    file.unit = unit.and_then(Result::ok);
    file.notes.extend(unit.map(said_of_unit));
    file.notes.extend(said_of(&passed_over).map(Sentence::from));
    if file.curves.is_empty() {
        let found = file.notes.last().map_or_else(String::new, |note| format!(" ({note})"));
        return Err(CurveFileError::File(format!(
            "holds no curves among its entities{found}: SPLINE, LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE and POLYLINE are read"
        )));
    }
    Ok(file)
}

/// What is said of the unit of lengths, or of the number of one that is not known.
fn said_of_unit(unit: Result<LengthUnit, &str>) -> Sentence {
    match unit {
        Ok(unit) => format!("lengths are in {}, as in the file", unit.plural()).into(),
        Err(code) => Sentence::from(format!(
            "lengths are in the unit of number {} ($INSUNITS), which is none of those that are known; ",
            limits::name(code)
        ))
        .setting(Setting::Unit)
        .text(" says what they are"),
    }
}

/// What is said of the kinds of entities that were passed over.
fn said_of(passed_over: &[(String, usize)]) -> Option<String> {
    let kinds: Vec<String> =
        passed_over.iter().take(8).map(|(kind, count)| format!("{count} {kind}")).collect();
    let has_blocks = passed_over.iter().any(|(kind, _)| kind == "INSERT");
    let hint = if has_blocks { "; explode blocks (INSERT) to have their curves" } else { "" };
    (!kinds.is_empty()).then(|| format!("passed over: {}{hint}", kinds.join(", ")))
}

fn pass_over(passed_over: &mut Vec<(String, usize)>, kind: &str) {
    let kind = limits::name(kind);
    if let Some((_, count)) = passed_over.iter_mut().find(|(known, _)| *known == kind) {
        *count += 1;
    } else if passed_over.len() < 100 {
        passed_over.push((kind, 1));
    }
}

/// Center and radius in the plane of the entity; angles in degrees, counter-clockwise.
fn arc(entity: &Entity<'_>, is_part: bool) -> Result<Shape, CurveFileError> {
    let plane = Plane::of(entity)?;
    let radius = entity.need(40)?;
    let whole = EllipseArc::new(plane.placed(entity.point(10)?), plane.axes, [radius; 2], 0.0, TAU)
        .map_err(|error| entity.wrong(&error.to_string()))?;
    if !is_part {
        return Ok(Shape::Arc(whole));
    }
    let [from, to] = [entity.need(50)?, entity.need(51)?].map(|degrees| degrees % 360.0 / 180.0 * PI);
    trim::forward(&whole, from, to).map(Shape::Arc).map_err(|why| entity.wrong(&why))
}

/// Center and end of the major axis in space; the ends are parameters.
fn ellipse(entity: &Entity<'_>) -> Result<Shape, CurveFileError> {
    let major = entity.point(11)?;
    let normal = entity.vector(210)?.unwrap_or(Point::new(0.0, 0.0, 1.0));
    let (Some(first), Some(normal)) = (major.unit(), normal.unit()) else {
        return Err(entity.wrong("its axis or its normal has length 0"));
    };
    let Some(second) = normal.cross(first).unit() else {
        return Err(entity.wrong("its axis is parallel to its normal"));
    };
    let radii = [major.norm(), major.norm() * entity.need(40)?];
    let whole = EllipseArc::new(entity.point(10)?, [first, second], radii, 0.0, TAU)
        .map_err(|error| entity.wrong(&error.to_string()))?;
    let (from, to) = (entity.number(41)?.unwrap_or(0.0), entity.number(42)?.unwrap_or(TAU));
    trim::forward(&whole, from, to).map(Shape::Arc).map_err(|why| entity.wrong(&why))
}

/// Control points with knots, or points to pass through where there are no control points.
fn spline(entity: &Entity<'_>) -> Result<Shape, CurveFileError> {
    let points = entity.points(10)?;
    if points.is_empty() {
        let through = entity.points(11)?;
        return if through.len() < 2 {
            Err(entity.wrong("it has no points"))
        } else {
            Ok(Shape::Polyline(through))
        };
    }
    let degree = entity.need(71)?;
    if !(1.0..=30.0).contains(&degree) || degree.fract() != 0.0 {
        return Err(entity.wrong(&format!("{degree} is not a degree")));
    }
    let weights = entity.numbers(41)?;
    let weights = (weights.iter().any(|w| *w != weights[0])).then_some(weights);
    let spline = SplineCurve::new(degree as usize, entity.numbers(40)?, points, weights)
        .map_err(|error| entity.wrong(&error.to_string()))?;
    let [a, b] = trim::domain(&spline);
    trim::cut(&spline, a, b).map(Shape::Spline).map_err(|why| entity.wrong(&why))
}
