//! ASCII DXF: the curves among the entities of a drawing.

use std::f64::consts::{PI, TAU};

use surfaces::{EllipseArc, Point, SplineCurve};

use super::limits::{self, LARGEST_COORDINATE, MOST_CURVES, MOST_POINTS, MOST_RECORDS};
use super::{CurveFile, CurveFileError, FileCurve, Kind, Shape, trim};
use crate::{LengthUnit, Sentence, Setting};

mod block;
mod entity;
mod polyline;

use block::{Blocks, Placement};
use entity::{Entity, Plane};

/// The curves SPLINE, LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE and POLYLINE of the section ENTITIES, and of the blocks that INSERT sets, named by
/// their layers.
pub(super) fn read(text: &str) -> Result<CurveFile, CurveFileError> {
    let drawing = entity::drawing(text)?;
    let blocks = Blocks::of(drawing.blocks)?;
    let mut reader = Reader::new(&blocks);
    reader.entities(&drawing.entities, None)?;
    let (mut file, unit) = (reader.file, drawing.unit);
    file.unit = unit.and_then(Result::ok);
    file.notes.extend(unit.map(said_of_unit));
    if reader.inserted > 0 {
        file.notes.push(format!("curves of blocks (INSERT) that are set: {}", reader.inserted).into());
    }
    file.notes.extend(said_of(&reader.passed_over).map(Sentence::from));
    if file.curves.is_empty() {
        let found = file.notes.last().map_or_else(String::new, |note| format!(" ({note})"));
        return Err(CurveFileError::File(format!(
            "holds no curves among its entities{found}: SPLINE, LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE and POLYLINE are read, and those of blocks"
        )));
    }
    Ok(file)
}

/// Where the entities of a block are set, and on which layer those of layer 0 are.
#[derive(Clone, Copy)]
struct Set<'s> {
    placement: Placement,
    layer: &'s str,
    depth: usize,
}

/// A drawing as it is read.
struct Reader<'r, 'a> {
    blocks: &'r Blocks<'a>,
    file: CurveFile,
    passed_over: Vec<(String, usize)>,
    points: usize,
    /// Entities of blocks, as often as they are set.
    visited: usize,
    /// Curves of blocks.
    inserted: usize,
}

impl<'r, 'a> Reader<'r, 'a> {
    fn new(blocks: &'r Blocks<'a>) -> Self {
        let file = CurveFile { kind: Kind::Dxf, curves: Vec::new(), unit: None, notes: Vec::new() };
        Self { blocks, file, passed_over: Vec::new(), points: 0, visited: 0, inserted: 0 }
    }

    /// Entities of the drawing, or of a block that is set.
    fn entities(&mut self, entities: &[Entity<'a>], set: Option<Set<'_>>) -> Result<(), CurveFileError> {
        let mut at = 0;
        while at < entities.len() {
            let entity = &entities[at];
            at += 1;
            if set.is_some() {
                limits::count(
                    &mut self.visited,
                    1,
                    MOST_RECORDS,
                    "entities of blocks that are set",
                    entity.line,
                )?;
            }
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
                            pass_over(&mut self.passed_over, "mesh (POLYLINE)");
                            continue;
                        }
                    }
                }
                "INSERT" => {
                    self.insert(entity, set)?;
                    continue;
                }
                "SEQEND" | "VERTEX" | "VIEWPORT" => continue,
                kind => {
                    pass_over(&mut self.passed_over, kind);
                    continue;
                }
            };
            self.keep(entity, shapes, set)?;
        }
        Ok(())
    }

    fn keep(
        &mut self,
        entity: &Entity<'_>,
        shapes: Vec<Shape>,
        set: Option<Set<'_>>,
    ) -> Result<(), CurveFileError> {
        for shape in shapes {
            let shape = match set {
                Some(set) => set
                    .placement
                    .shape(shape)
                    .map_err(|why| entity.wrong(&format!("set by INSERT, {why}")))?,
                None => shape,
            };
            limits::count(&mut self.points, 2, MOST_POINTS, "points", entity.line)?;
            let mut counter = self.file.curves.len();
            limits::count(&mut counter, 1, MOST_CURVES, "curves", entity.line)?;
            let layer = entity.text(8).filter(|layer| layer.trim() != "0");
            let name = limits::name(layer.or(set.map(|set| set.layer)).unwrap_or_default());
            self.file.curves.push(FileCurve {
                name,
                line: entity.line,
                shape,
                closes: false,
                joints: Vec::new(),
            });
            self.inserted += usize::from(set.is_some());
        }
        Ok(())
    }

    /// Sets a block as often as an INSERT says, and the blocks in it.
    fn insert(&mut self, insert: &Entity<'a>, set: Option<Set<'_>>) -> Result<(), CurveFileError> {
        let Some(block) = self.blocks.named_by(insert) else {
            pass_over(&mut self.passed_over, "INSERT of a block that is not in the file");
            return Ok(());
        };
        let depth = set.map_or(1, |set| set.depth + 1);
        if depth > block::DEEPEST {
            return Err(
                insert.wrong("blocks lie deeper in one another than 16, or in themselves: explode them")
            );
        }
        let own = insert.text(8).filter(|layer| layer.trim() != "0");
        let layer = own.or(set.map(|set| set.layer)).unwrap_or_default();
        for placement in Placement::all(insert, block)? {
            limits::count(
                &mut self.visited,
                1,
                MOST_RECORDS,
                "entities of blocks that are set",
                insert.line,
            )?;
            let placement = set.map_or(placement, |set| set.placement.after(&placement));
            self.entities(&block.entities, Some(Set { placement, layer, depth }))?;
        }
        Ok(())
    }
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
    (!kinds.is_empty()).then(|| format!("passed over: {}", kinds.join(", ")))
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
