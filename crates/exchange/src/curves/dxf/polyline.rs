//! Polylines, whose segments may be arcs.

use surfaces::{EllipseArc, Point};

use super::entity::{Entity, Plane};
use crate::curves::{CurveFileError, Shape};

/// A vertex in the plane of its polyline, and the bulge of the segment behind it: tan of a quarter of the arc's angle.
type Vertex = (Point, f64);

/// LWPOLYLINE: a polyline in a plane.
pub(super) fn light(entity: &Entity<'_>) -> Result<Vec<Shape>, CurveFileError> {
    let elevation = entity.number(38)?.unwrap_or(0.0);
    let mut vertices: Vec<Vertex> = Vec::new();
    for pair in entity.pairs() {
        match (pair.0, vertices.last_mut()) {
            (10, _) => vertices.push((Point::new(entity.parsed(pair)?, 0.0, elevation), 0.0)),
            (20, Some(vertex)) => vertex.0.y = entity.parsed(pair)?,
            (42, Some(vertex)) => vertex.1 = entity.parsed(pair)?,
            _other => {}
        }
    }
    let plane = Plane::of(entity)?;
    segments(entity, &vertices, entity.has_flag(1), Some(&plane))
}

/// POLYLINE with its vertices; none for meshes.
pub(super) fn heavy(entity: &Entity<'_>, parts: &[Entity<'_>]) -> Result<Option<Vec<Shape>>, CurveFileError> {
    if entity.has_flag(16) || entity.has_flag(64) {
        return Ok(None);
    }
    let in_space = entity.has_flag(8);
    let mut vertices: Vec<Vertex> = Vec::new();
    for part in parts {
        // Control points of the frame of a spline are not on it.
        if !part.has_flag(16) {
            let bulge = if in_space { 0.0 } else { part.number(42)?.unwrap_or(0.0) };
            vertices.push((part.point(10)?, bulge));
        }
    }
    let plane = if in_space { None } else { Some(Plane::of(entity)?) };
    segments(entity, &vertices, entity.has_flag(1), plane.as_ref()).map(Some)
}

/// Straight runs as polylines, bulges as arcs between them.
fn segments(
    entity: &Entity<'_>,
    vertices: &[Vertex],
    is_closed: bool,
    plane: Option<&Plane>,
) -> Result<Vec<Shape>, CurveFileError> {
    if vertices.len() < 2 {
        return Err(entity.wrong("it has fewer than two vertices"));
    }
    let place = |p: Point| plane.map_or(p, |plane| plane.placed(p));
    let (mut shapes, mut run) = (Vec::new(), vec![place(vertices[0].0)]);
    let finish = |run: &mut Vec<Point>, next: Point, shapes: &mut Vec<Shape>| {
        let done = std::mem::replace(run, vec![next]);
        if done.len() > 1 {
            shapes.push(Shape::Polyline(done));
        }
    };
    let count = if is_closed { vertices.len() } else { vertices.len() - 1 };
    for k in 0..count {
        let ((start, bulge), (end, _)) = (vertices[k], vertices[(k + 1) % vertices.len()]);
        match plane {
            Some(plane) if bulge != 0.0 && start != end => {
                finish(&mut run, place(end), &mut shapes);
                shapes.push(arc(start, end, bulge, plane).map_err(|why| entity.wrong(&why))?);
            }
            _straight => run.push(place(end)),
        }
    }
    finish(&mut run, Point::ZERO, &mut shapes);
    Ok(shapes)
}

/// The arc over the chord from `start` to `end` that turns by 4 atan(bulge), counter-clockwise for a positive one.
fn arc(start: Point, end: Point, bulge: f64, plane: &Plane) -> Result<Shape, String> {
    let chord = end - start;
    // Center: from the middle of the chord along its normal by (1 − b²) / (4 b) of its length.
    let shift = (1.0 - bulge * bulge) / (4.0 * bulge);
    let center = (start + end) * 0.5 + Point::new(-chord.y, chord.x, 0.0) * shift;
    let radius = center.distance(start);
    let from = libm::atan2(start.y - center.y, start.x - center.x);
    let to = from + 4.0 * libm::atan(bulge);
    EllipseArc::new(plane.placed(center), plane.axes, [radius; 2], from, to)
        .map(Shape::Arc)
        .map_err(|error| error.to_string())
}
