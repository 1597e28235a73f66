//! Curves of instances.

use surfaces::{EllipseArc, Point, SplineCurve};

use super::fields::Fields;
use super::part21::{Entity, Part21, Value};
use crate::curves::{CurveFileError, Shape, limits, trim};

/// A curve and the line of its instance.
type Placed = (usize, Shape);

/// Deepest nesting of curves made of curves.
const DEEPEST: usize = 16;

/// Reads curves of a file.
pub(super) struct Curves<'a> {
    file: &'a Part21<'a>,
    /// The unit of angles in radians.
    angle: f64,
}

/// What a curve is made of: bounded, or waiting for its ends.
enum Geometry {
    Bounded(Vec<Shape>),
    Line { point: Point, direction: Point },
}

impl<'a> Curves<'a> {
    pub(super) fn new(file: &'a Part21<'a>, angle: f64) -> Self {
        Self { file, angle }
    }

    /// The pieces of a bounded curve or an edge, in its order.
    pub(super) fn get(&self, id: u64) -> Result<Vec<Placed>, CurveFileError> {
        let line = self.file.line(id);
        match self.geometry(id, 0)? {
            Geometry::Bounded(shapes) => Ok(shapes.into_iter().map(|shape| (line, shape)).collect()),
            Geometry::Line { .. } => Ok(Vec::new()),
        }
    }

    fn geometry(&self, id: u64, depth: usize) -> Result<Geometry, CurveFileError> {
        if depth > DEEPEST {
            return Err(CurveFileError::at(
                self.file.line(id),
                format!("#{id} is a curve made of itself, or of too many others"),
            ));
        }
        let entities = self.file.get(id)?;
        let fields = |entity| Fields { entity, id, line: self.file.line(id) };
        if let Some(spline) = self.spline(&entities, id)? {
            return Ok(Geometry::Bounded(vec![Shape::Spline(spline)]));
        }
        let Some(entity) = entities.first() else {
            return Err(CurveFileError::at(self.file.line(id), format!("#{id} is empty")));
        };
        let f = fields(entity);
        match entity.name.as_str() {
            "POLYLINE" => Ok(Geometry::Bounded(vec![Shape::Polyline(self.points(&f, 1)?)])),
            "LINE" => {
                let vector = self.entity(f.reference(2)?)?;
                let vector = Fields { entity: &vector, id: f.reference(2)?, line: f.line };
                let direction = self.direction(vector.reference(1)?)? * vector.number(2)?;
                Ok(Geometry::Line { point: self.point(f.reference(1)?)?, direction })
            }
            "CIRCLE" | "ELLIPSE" => {
                let radius = f.number(2)?;
                let second = if entity.name == "CIRCLE" { radius } else { f.number(3)? };
                let (center, axes) = self.placement(f.reference(1)?)?;
                let arc = EllipseArc::new(center, axes, [radius, second], 0.0, std::f64::consts::TAU);
                Ok(Geometry::Bounded(vec![Shape::Arc(arc.map_err(|error| f.wrong(&error.to_string()))?)]))
            }
            "TRIMMED_CURVE" => self.trimmed(&f, depth),
            "COMPOSITE_CURVE" | "COMPOSITE_CURVE_ON_SURFACE" | "BOUNDARY_CURVE" | "OUTER_BOUNDARY_CURVE" => {
                self.composite(&f, depth)
            }
            "SURFACE_CURVE" | "SEAM_CURVE" | "INTERSECTION_CURVE" => {
                self.geometry(f.reference(1)?, depth + 1)
            }
            "EDGE_CURVE" => self.edge(&f, depth),
            "ORIENTED_EDGE" => self.geometry(f.reference(3)?, depth + 1),
            other => Err(f.wrong(&format!(
                "curves of the kind {} are not read: export splines, circles, ellipses or lines",
                limits::name(other)
            ))),
        }
    }

    fn entity(&self, id: u64) -> Result<Entity, CurveFileError> {
        self.file
            .get(id)?
            .into_iter()
            .next()
            .ok_or_else(|| CurveFileError::at(self.file.line(id), format!("#{id} is empty")))
    }

    /// A B-spline of any kind; none for other curves. Simple instances begin with their name, parts of complex ones do not.
    fn spline(&self, entities: &[Entity], id: u64) -> Result<Option<SplineCurve>, CurveFileError> {
        let line = self.file.line(id);
        let find = |name: &str| entities.iter().find(|entity| entity.name == name);
        let kinds = [
            "B_SPLINE_CURVE_WITH_KNOTS",
            "BEZIER_CURVE",
            "UNIFORM_CURVE",
            "QUASI_UNIFORM_CURVE",
            "B_SPLINE_CURVE",
        ];
        let Some(kind) = kinds.into_iter().find(|name| find(name).is_some()) else { return Ok(None) };
        let is_simple = entities.len() == 1;
        let offset = usize::from(is_simple);
        let Some(base) = find(if is_simple { kind } else { "B_SPLINE_CURVE" }) else { return Ok(None) };
        let f = Fields { entity: base, id, line };
        let degree = f.count(offset)?;
        let points = self.points(&f, offset + 1)?;
        let knots = match (kind, find("B_SPLINE_CURVE_WITH_KNOTS")) {
            ("B_SPLINE_CURVE_WITH_KNOTS", Some(entity)) => {
                let f = Fields { entity, id, line };
                let at = if is_simple { 6 } else { 0 };
                expanded(&f, f.numbers(at)?, &f.numbers(at + 1)?, points.len() + degree + 1)?
            }
            ("UNIFORM_CURVE", _) => {
                (0..points.len() + degree + 1).map(|k| k as f64 - degree as f64).collect()
            }
            ("BEZIER_CURVE", _) => even(points.len(), degree, degree.max(1)),
            _quasi_uniform => even(points.len(), degree, 1),
        };
        let weights = match find("RATIONAL_B_SPLINE_CURVE") {
            Some(entity) => Some(Fields { entity, id, line }.numbers(0)?),
            None => None,
        };
        // Equal weights are none.
        let weights = weights
            .filter(|weights| weights.iter().any(|w| *w != weights[0]) || weights.len() != points.len());
        let spline =
            SplineCurve::new(degree, knots, points, weights).map_err(|error| f.wrong(&error.to_string()))?;
        let [a, b] = trim::domain(&spline);
        trim::cut(&spline, a, b).map(Some).map_err(|why| f.wrong(&why))
    }

    /// A curve between two of its points or parameters.
    fn trimmed(&self, f: &Fields<'_>, depth: usize) -> Result<Geometry, CurveFileError> {
        let basis = self.geometry(f.reference(1)?, depth + 1)?;
        let ends = [self.trim(f, 2)?, self.trim(f, 3)?];
        let forward = f.flag(4).unwrap_or(true);
        let master = matches!(f.entity.values.get(5), Some(Value::Word(word)) if word == "CARTESIAN");
        let shape = match basis {
            Geometry::Line { point, direction } => {
                let at = |(point_of, parameter): (Option<Point>, Option<f64>)| match (point_of, parameter) {
                    (Some(p), _) if master => Some(p),
                    (_, Some(t)) => Some(point + direction * t),
                    (p, None) => p,
                };
                let (Some(a), Some(b)) = (at(ends[0]), at(ends[1])) else {
                    return Err(f.wrong("an end of it is missing"));
                };
                Shape::Polyline(vec![a, b])
            }
            Geometry::Bounded(shapes) => {
                let Some(shape) = shapes.into_iter().next() else { return Err(f.wrong("it has no curve")) };
                let at = |(p, t): (Option<Point>, Option<f64>)| match (&shape, p, t) {
                    (Shape::Arc(arc), Some(p), _) if master => Some(trim::angle(arc, p)),
                    (Shape::Arc(_), _, Some(t)) => Some(t * self.angle),
                    (Shape::Arc(arc), Some(p), None) => Some(trim::angle(arc, p)),
                    (Shape::Spline(spline), Some(p), _) if master => Some(trim::nearest(spline, p).0),
                    (Shape::Spline(_), _, Some(t)) => Some(t),
                    (Shape::Spline(spline), Some(p), None) => Some(trim::nearest(spline, p).0),
                    (Shape::Polyline(_), _, _) | (_, None, None) => None,
                };
                let (Some(a), Some(b)) = (at(ends[0]), at(ends[1])) else {
                    return Err(f.wrong("it is cut where its ends cannot be found"));
                };
                self.between(f, &shape, a, b, forward)?
            }
        };
        Ok(Geometry::Bounded(vec![shape]))
    }

    /// The piece from one parameter to another: `forward` says whether parameters grow on the way.
    fn between(
        &self,
        f: &Fields<'_>,
        shape: &Shape,
        from: f64,
        to: f64,
        forward: bool,
    ) -> Result<Shape, CurveFileError> {
        let (a, b) = if forward { (from, to) } else { (to, from) };
        let piece = match shape {
            Shape::Arc(arc) => trim::forward(arc, a, b).map(Shape::Arc),
            // Some write the ends in the order of parameters and the sense apart.
            Shape::Spline(spline) => trim::cut(spline, a.min(b), a.max(b)).map(Shape::Spline),
            Shape::Polyline(points) => Ok(Shape::Polyline(points.clone())),
        };
        let piece = piece.map_err(|why| f.wrong(&why))?;
        Ok(if forward { piece } else { piece.reversed() })
    }

    /// The point and the parameter by which a curve is cut; either may be missing.
    fn trim(&self, f: &Fields<'_>, place: usize) -> Result<(Option<Point>, Option<f64>), CurveFileError> {
        let (mut point, mut parameter) = (None, None);
        let Some(Value::List(values)) = f.entity.values.get(place) else {
            return Err(f.wrong("an end of it is missing"));
        };
        for value in values {
            match value {
                Value::Reference(id) => point = Some(self.point(*id)?),
                Value::Typed(_, inner) => {
                    if let Some(Value::Number(t)) = inner.first() {
                        parameter = Some(*t);
                    }
                }
                Value::Number(t) => parameter = Some(*t),
                Value::Text(_) | Value::Word(_) | Value::Absent | Value::List(_) => {}
            }
        }
        Ok((point, parameter))
    }

    fn composite(&self, f: &Fields<'_>, depth: usize) -> Result<Geometry, CurveFileError> {
        let mut shapes = Vec::new();
        for id in f.references(1)? {
            let segment = self.entity(id)?;
            let s = Fields { entity: &segment, id, line: self.file.line(id) };
            let Geometry::Bounded(parts) = self.geometry(s.reference(2)?, depth + 1)? else {
                return Err(s.wrong("an endless line is no part of a curve"));
            };
            if s.flag(1).unwrap_or(true) {
                shapes.extend(parts);
            } else {
                shapes.extend(parts.into_iter().rev().map(Shape::reversed));
            }
            if shapes.len() > limits::MOST_CURVES {
                return Err(f.wrong("it has too many pieces"));
            }
        }
        Ok(Geometry::Bounded(shapes))
    }

    /// An edge: its curve between its vertices.
    fn edge(&self, f: &Fields<'_>, depth: usize) -> Result<Geometry, CurveFileError> {
        let (first, second) = (f.reference(1)?, f.reference(2)?);
        let ends = [self.vertex(first)?, self.vertex(second)?];
        let forward = f.flag(4).unwrap_or(true);
        let basis = self.geometry(f.reference(3)?, depth + 1)?;
        let shapes = match basis {
            Geometry::Line { .. } => vec![Shape::Polyline(ends.to_vec())],
            Geometry::Bounded(shapes) if shapes.len() == 1 => {
                let shape = &shapes[0];
                // Ends that are those of the curve to this share of its size need no cut.
                let size = shape.ends()[0].distance(shape.ends()[1]).max(ends[0].distance(ends[1]));
                vec![match shape {
                    Shape::Arc(arc) => {
                        let [a, b] = ends.map(|p| trim::angle(arc, p));
                        let [a, b] = if first == second { [a, a] } else { [a, b] };
                        self.between(f, shape, a, b, forward)?
                    }
                    Shape::Spline(spline) => {
                        let oriented = if forward { shape.clone() } else { shape.clone().reversed() };
                        let off: f64 = oriented.ends().iter().zip(&ends).map(|(p, q)| p.distance(*q)).sum();
                        if first == second || off <= 1e-6 * size {
                            oriented
                        } else {
                            let [a, b] = ends.map(|p| trim::nearest(spline, p).0);
                            self.between(f, shape, a, b, forward)?
                        }
                    }
                    Shape::Polyline(_) if forward => shape.clone(),
                    Shape::Polyline(_) => shape.clone().reversed(),
                }]
            }
            Geometry::Bounded(shapes) if forward => shapes,
            Geometry::Bounded(shapes) => shapes.into_iter().rev().map(Shape::reversed).collect(),
        };
        Ok(Geometry::Bounded(shapes))
    }

    fn vertex(&self, id: u64) -> Result<Point, CurveFileError> {
        let vertex = self.entity(id)?;
        let f = Fields { entity: &vertex, id, line: self.file.line(id) };
        f.named("VERTEX_POINT")?;
        self.point(f.reference(1)?)
    }

    fn points(&self, f: &Fields<'_>, place: usize) -> Result<Vec<Point>, CurveFileError> {
        let points =
            f.references(place)?.into_iter().map(|id| self.point(id)).collect::<Result<Vec<_>, _>>()?;
        if points.len() < 2 { Err(f.wrong("it has fewer than two points")) } else { Ok(points) }
    }

    fn point(&self, id: u64) -> Result<Point, CurveFileError> {
        self.triple(id, "CARTESIAN_POINT")
    }

    fn direction(&self, id: u64) -> Result<Point, CurveFileError> {
        let direction = self.triple(id, "DIRECTION")?;
        direction
            .unit()
            .ok_or_else(|| CurveFileError::at(self.file.line(id), format!("#{id}: a direction of length 0")))
    }

    fn triple(&self, id: u64, name: &str) -> Result<Point, CurveFileError> {
        let entity = self.entity(id)?;
        let f = Fields { entity: &entity, id, line: self.file.line(id) };
        f.named(name)?;
        let numbers = f.numbers(1)?;
        let ([x, y, z], true) = (
            match numbers.as_slice() {
                [x, y, z] => [*x, *y, *z],
                [_, _] => return Err(f.wrong("it lies in a plane of parameters, not in space")),
                _other => return Err(f.wrong("three coordinates were expected")),
            },
            numbers.iter().all(|x| x.abs() <= limits::LARGEST_COORDINATE),
        ) else {
            return Err(f.wrong("a coordinate is too large"));
        };
        Ok(Point::new(x, y, z))
    }

    /// Origin and first two axes of a placement; a second axis is made perpendicular to the first.
    fn placement(&self, id: u64) -> Result<(Point, [Point; 2]), CurveFileError> {
        let entity = self.entity(id)?;
        let f = Fields { entity: &entity, id, line: self.file.line(id) };
        f.named("AXIS2_PLACEMENT_3D")?;
        let axis = |place: usize| match f.entity.values.get(place) {
            Some(Value::Reference(id)) => self.direction(*id).map(Some),
            _absent => Ok(None),
        };
        let normal = axis(2)?.unwrap_or(Point::new(0.0, 0.0, 1.0));
        let default =
            if normal.x.abs() < 0.9 { Point::new(1.0, 0.0, 0.0) } else { Point::new(0.0, 1.0, 0.0) };
        let reference = axis(3)?.unwrap_or(default);
        let first = (reference - normal * reference.dot(normal))
            .unit()
            .ok_or_else(|| f.wrong("its two axes are parallel"))?;
        Ok((self.point(f.reference(1)?)?, [first, normal.cross(first)]))
    }
}

/// Knots repeated by their multiplicities.
fn expanded(
    f: &Fields<'_>,
    counts: Vec<f64>,
    knots: &[f64],
    expected: usize,
) -> Result<Vec<f64>, CurveFileError> {
    if counts.len() != knots.len() {
        return Err(f.wrong(&format!("{} multiplicities for {} knots", counts.len(), knots.len())));
    }
    let sum: f64 = counts.iter().sum();
    if sum != expected as f64 || counts.iter().any(|count| *count < 1.0 || count.fract() != 0.0) {
        return Err(
            f.wrong(&format!("the multiplicities of its knots add up to {sum}, and should to {expected}"))
        );
    }
    Ok(counts
        .iter()
        .zip(knots)
        .flat_map(|(count, knot)| std::iter::repeat_n(*knot, *count as usize))
        .collect())
}

/// Clamped knots at equal distances, the inner ones `multiplicity` times.
fn even(points: usize, degree: usize, multiplicity: usize) -> Vec<f64> {
    let inner = points.saturating_sub(degree + 1);
    let pieces = inner / multiplicity + 1;
    let mut knots = vec![0.0; degree + 1];
    knots.extend((0..inner).map(|k| (k / multiplicity + 1) as f64));
    knots.extend(vec![pieces as f64; degree + 1]);
    knots
}
