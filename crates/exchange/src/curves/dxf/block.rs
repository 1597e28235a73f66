//! Blocks, and where they are inserted.

use std::collections::HashMap;

use surfaces::{EllipseArc, Point, SplineCurve};

use super::entity::{Entity, Plane};
use crate::curves::limits::LARGEST_COORDINATE;
use crate::curves::{CurveFileError, Shape, limits};

/// Most blocks within blocks.
pub(super) const DEEPEST: usize = 16;

/// Most copies of a block that one INSERT sets.
const MOST_COPIES: usize = 10_000;

/// Entities that an INSERT sets as a whole.
#[derive(Default)]
pub(super) struct Block<'a> {
    base: Point,
    pub(super) entities: Vec<Entity<'a>>,
}

/// The blocks of a drawing by their names, which capitals do not tell apart.
#[derive(Default)]
pub(super) struct Blocks<'a>(HashMap<String, Block<'a>>);

impl<'a> Blocks<'a> {
    /// The entities of the section BLOCKS: each block begins with BLOCK and ends with ENDBLK.
    pub(super) fn of(entities: Vec<Entity<'a>>) -> Result<Self, CurveFileError> {
        let (mut blocks, mut open) = (HashMap::new(), None);
        for entity in entities {
            match (entity.kind.as_str(), &mut open) {
                ("BLOCK", _) => {
                    let base = entity.vector(10)?.unwrap_or_default();
                    open = Some((named(&entity), Block { base, entities: Vec::new() }));
                }
                ("ENDBLK", _) => blocks.extend(open.take()),
                (_entity, Some((_, block))) => block.entities.push(entity),
                (_entity, None) => {}
            }
        }
        Ok(Self(blocks))
    }

    /// The block that an INSERT names.
    pub(super) fn named_by(&self, insert: &Entity<'_>) -> Option<&Block<'a>> {
        self.0.get(&named(insert))
    }
}

fn named(entity: &Entity<'_>) -> String {
    entity.text(2).map(limits::name).unwrap_or_default().to_uppercase()
}

/// An affine map: `origin + x axes₀ + y axes₁ + z axes₂`.
#[derive(Clone, Copy)]
pub(super) struct Placement {
    origin: Point,
    axes: [Point; 3],
}

impl Placement {
    /// Where an INSERT sets a block: scaled, turned about the normal of its plane, moved; in rows and columns where it says so.
    pub(super) fn all(insert: &Entity<'_>, block: &Block<'_>) -> Result<Vec<Self>, CurveFileError> {
        let plane = Plane::of(insert)?;
        let scale = |code| Ok::<_, CurveFileError>(insert.number(code)?.unwrap_or(1.0));
        let turn = insert.number(50)?.unwrap_or(0.0) % 360.0;
        let (s, c) = right_angle(turn).unwrap_or_else(|| {
            let turn = turn.to_radians();
            (libm::sin(turn), libm::cos(turn))
        });
        let [x, y, z] = [Point::new(c, s, 0.0), Point::new(-s, c, 0.0), Point::new(0.0, 0.0, 1.0)];
        let axes = [x * scale(41)?, y * scale(42)?, z * scale(43)?].map(|axis| plane.placed(axis));
        let at = insert.point(10)?;
        let count = |code| match insert.number(code)? {
            Some(count) if count >= 1.0 && count <= MOST_COPIES as f64 => Ok(count as usize),
            None | Some(0.0) => Ok(1),
            Some(count) => Err(insert.wrong(&format!("{count} rows or columns are none, or too many"))),
        };
        let (columns, rows) = (count(70)?, count(71)?);
        if columns * rows > MOST_COPIES {
            return Err(insert.wrong(&format!("{columns} × {rows} copies are more than {MOST_COPIES}")));
        }
        let (across, along) = (insert.number(44)?.unwrap_or(0.0), insert.number(45)?.unwrap_or(0.0));
        let copies = (0..rows).flat_map(|row| (0..columns).map(move |column| (row as f64, column as f64)));
        let placed = copies.map(|(row, column)| {
            let place = Self { origin: plane.placed(at + x * (column * across) + y * (row * along)), axes };
            Self { origin: place.point(-block.base), ..place }
        });
        Ok(placed.collect())
    }

    /// This after another.
    pub(super) fn after(&self, inner: &Self) -> Self {
        Self { origin: self.point(inner.origin), axes: inner.axes.map(|axis| self.vector(axis)) }
    }

    fn vector(&self, p: Point) -> Point {
        self.axes[0] * p.x + self.axes[1] * p.y + self.axes[2] * p.z
    }

    fn point(&self, p: Point) -> Point {
        self.origin + self.vector(p)
    }

    /// The image of a curve, which is of its own kind: circles become ellipses.
    pub(super) fn shape(&self, shape: Shape) -> Result<Shape, String> {
        let all = |points: &[Point]| read(points.iter().map(|&p| self.point(p)).collect());
        match shape {
            Shape::Polyline(points) => Ok(Shape::Polyline(all(&points)?)),
            Shape::Spline(spline) => {
                let (knots, weights) = (spline.knots().to_vec(), spline.weights().map(<[f64]>::to_vec));
                let image = SplineCurve::new(spline.degree(), knots, all(spline.points())?, weights);
                image.map(Shape::Spline).map_err(|error| error.to_string())
            }
            Shape::Arc(arc) => {
                let arc = self.arc(&arc)?;
                let ([a, b], [r, s]) = (arc.axes(), arc.radii());
                read(vec![arc.center() + a * r, arc.center() + b * s])?;
                Ok(Shape::Arc(arc))
            }
        }
    }

    /// The images of the half axes of an ellipse are conjugate half diameters a, b of its image; turned by t they are its half axes, where
    /// `tan 2t = 2ab/(a² − b²)`.
    fn arc(&self, arc: &EllipseArc) -> Result<EllipseArc, String> {
        let ([first, second], [r, s]) = (arc.axes(), arc.radii());
        let (a, b) = (self.vector(first * r), self.vector(second * s));
        let (skew, difference) = (2.0 * a.dot(b), a.dot(a) - b.dot(b));
        let is_skew = skew.abs() > 1e-14 * (a.dot(a) + b.dot(b));
        let t = if is_skew { 0.5 * libm::atan2(skew, difference) } else { 0.0 };
        let (sin, cos) = (libm::sin(t), libm::cos(t));
        let half = [a * cos + b * sin, b * cos - a * sin];
        let ([Some(first), Some(second)], radii) = (half.map(Point::unit), half.map(Point::norm)) else {
            return Err("its scale of 0 leaves no plane of this arc".into());
        };
        let [from, to] = arc.angles();
        EllipseArc::new(self.point(arc.center()), [first, second], radii, from - t, to - t)
            .map_err(|error| error.to_string())
    }
}

/// Points within what is read.
fn read(points: Vec<Point>) -> Result<Vec<Point>, String> {
    let is_read = |p: &Point| [p.x, p.y, p.z].iter().all(|x| x.abs() <= LARGEST_COORDINATE);
    let all = points.iter().all(is_read);
    all.then_some(points).ok_or_else(|| format!("it has coordinates above {LARGEST_COORDINATE:e}"))
}

/// Sine and cosine of multiples of right angles, without rounding.
fn right_angle(degrees: f64) -> Option<(f64, f64)> {
    let exact = [(0.0, (0.0, 1.0)), (90.0, (1.0, 0.0)), (180.0, (0.0, -1.0)), (270.0, (-1.0, 0.0))];
    exact.into_iter().find(|(angle, _)| (degrees - angle) % 360.0 == 0.0).map(|(_, value)| value)
}
