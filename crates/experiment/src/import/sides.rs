//! Three or four sides as an experiment lists them.

use std::fmt::Write;

use exchange::{Assembly, CurveFile, Form, Sentence, Setting, Shape};
use plateau::{DegreeLimit, NearestCurve};
use surfaces::{Bezier, Point};

use super::{CornerGap, ImportError, ImportOptions, printed};

/// Most points of a side that are taken as control points without a word.
pub(super) const MANY: usize = 13;

/// The largest tolerance of welding, as a share of the size.
const MOST_WELDED: f64 = 0.25;

/// Names of the sides, in the order in which they run around the boundary; whether the experiment has them in that sense.
const TENSOR: [(&str, bool); 4] = [("u0", true), ("v1", true), ("u1", false), ("v0", false)];
const TRIANGLE: [(&str, bool); 3] = [("ab", true), ("bc", true), ("ca", true)];

/// A side in the sense in which it runs around the boundary.
struct Curve {
    name: &'static str,
    /// What the file calls it.
    label: String,
    points: Vec<Point>,
    forward: bool,
    /// Said in a comment above it.
    comment: Option<String>,
}

/// The sides of a triangular or a tensor boundary.
pub(super) struct Sides {
    curves: Vec<Curve>,
    size: f64,
    /// Ends that were moved, and how far at most.
    welded: (usize, f64),
}

impl Sides {
    /// Three or four polylines of a file, one side each, by the names of sides of experiments or, where something is said of their
    /// points, chained by their ends; none for other files.
    pub(super) fn of_file(file: &CurveFile, options: &ImportOptions) -> Result<Option<Self>, ImportError> {
        if !options.says_what_points_are() && names(file).is_none() {
            return Ok(None);
        }
        let Some(polylines) = polylines(file) else { return Ok(None) };
        let names = match polylines.len() {
            3 => TRIANGLE.as_slice(),
            4 => TENSOR.as_slice(),
            _ => return Ok(None),
        };
        // A polyline that is closed by itself is no side.
        if polylines
            .iter()
            .any(|(_, points)| points.len() > 2 && points[0] == points[points.len() - 1] && !is_point(points))
        {
            return Ok(None);
        }
        let curves = around(names, &polylines);
        let mut sides = Self::welded(curves, options)?;
        match options.degree {
            Some(degree) => sides.fit(degree)?,
            None => sides.level(),
        }
        Ok(Some(sides))
    }

    /// The sides of one loop of three or four where a degree is given: straight lines and Bézier curves as they are, others fitted; none
    /// for other boundaries.
    pub(super) fn of_assembly(
        assembly: &Assembly,
        options: &ImportOptions,
    ) -> Result<Option<Self>, ImportError> {
        let Some(degree) = options.degree else { return Ok(None) };
        let Form::Loops(loops) = &assembly.form else { return Ok(None) };
        let [walks] = loops.as_slice() else { return Ok(None) };
        let names = match walks.len() {
            3 => TRIANGLE.as_slice(),
            4 => TENSOR.as_slice(),
            _ => return Ok(None),
        };
        let sides: Vec<_> = walks.iter().map(|walk| &assembly.sides[walk.side]).collect();
        let is_exact =
            |side: &exchange::Side| side.control_points().is_some_and(|points| points.len() <= MANY);
        let is_sampled = |side: &exchange::Side| matches!(side.shape, Shape::Polyline(_));
        if !sides.iter().all(|side| is_exact(side) || is_sampled(side)) {
            return Ok(None);
        }
        let curves = names.iter().zip(walks).map(|(&(name, forward), walk)| {
            let side = &assembly.sides[walk.side];
            let mut points = side.control_points().map_or_else(|| side.shape.sampled(), <[Point]>::to_vec);
            if !walk.forward {
                points.reverse();
            }
            Curve { name, label: side.name.clone(), points, forward, comment: None }
        });
        let mut found = Self { curves: curves.collect(), size: assembly.size, welded: (0, 0.0) };
        for (curve, side) in found.curves.iter_mut().zip(&sides) {
            if is_sampled(side) {
                curve.fit(degree, assembly.size)?;
            }
        }
        found.level();
        Ok(Some(found))
    }

    /// Joins the ends of neighbours that lie within the tolerance.
    fn welded(mut curves: Vec<Curve>, options: &ImportOptions) -> Result<Self, ImportError> {
        let size = exchange::diagonal(curves.iter().flat_map(|curve| &curve.points).map(|&p| p.into()));
        let tolerance = options.assembly.reach(size, f64::INFINITY);
        if !(tolerance >= 0.0 && (tolerance <= MOST_WELDED * size || size == 0.0)) {
            let why = format!(": it lies between 0 and a quarter of the size, {size:.3e}");
            let given = Sentence::default().value(Setting::Weld, tolerance.to_string());
            return Err(ImportError::Option(given.text(why)));
        }
        let mut welded = (0, 0.0);
        for k in 0..curves.len() {
            let next = (k + 1) % curves.len();
            let (end, begin) = (last(&curves[k].points), curves[next].points[0]);
            let gap = end.distance(begin);
            let shortest = [k, next].map(|k| exchange::shortest_edge(&curves[k].points));
            let reach = options.assembly.reach(size, f64::min(shortest[0], shortest[1]));
            if gap > reach {
                let named = curves.iter().all(|curve| curve.label == curve.name);
                let [first, second] = [k, next].map(|k| curves[k].label.clone());
                let wide = Some(1.1 * gap).filter(|wide| *wide <= 0.95 * MOST_WELDED * size);
                let wide = wide.map(|wide| format!("{wide:.1e}"));
                let (end, begin) = (end.into(), begin.into());
                let gap = CornerGap { first, second, end, begin, gap, tolerance: reach, wide, named };
                return Err(ImportError::Corner(Box::new(gap)));
            }
            if gap > 0.0 {
                welded = (welded.0 + 1, f64::max(welded.1, gap));
            }
            // Corners are repeated in an experiment and must agree digit for digit.
            curves[next].points[0] = end;
        }
        Ok(Self { curves, size, welded })
    }

    fn fit(&mut self, degree: usize) -> Result<(), ImportError> {
        let size = self.size;
        self.curves.iter_mut().try_for_each(|curve| curve.fit(degree, size))
    }

    /// Raises the degree of sides whose partner has a higher one, exactly: opposite ones of four, all of three.
    fn level(&mut self) {
        let counts: Vec<usize> = self.curves.iter().map(|curve| curve.points.len()).collect();
        for (k, curve) in self.curves.iter_mut().enumerate() {
            let partners = if counts.len() == 4 { vec![(k + 2) % 4] } else { vec![0, 1, 2] };
            let most = partners.iter().map(|partner| counts[*partner]).max().unwrap_or(0);
            if most <= curve.points.len() {
                continue;
            }
            if let Ok(raised) = Bezier::new(curve.points.clone()) {
                curve.comment =
                    Some(format!("raised from degree {} to {}, the same curve", counts[k] - 1, most - 1));
                curve.points = raised.raised(most - 1).points().to_vec();
            }
        }
    }

    /// The experiment.
    pub(super) fn printed(mut self, title: &str, notes: &[String]) -> String {
        let mut text = printed::head(title, notes);
        for curve in &mut self.curves {
            if !curve.forward {
                curve.points.reverse();
            }
        }
        let (count, largest) = self.welded;
        // Rounding of the file is not worth a word.
        if largest > 1e-6 * self.size {
            let what = if count == 1 { "1 corner".into() } else { format!("{count} corners") };
            let share = largest / self.size;
            let _ = writeln!(
                text,
                "# {what} welded: ends moved by at most {largest:.2e} ({share:.1e} of the size)"
            );
        }
        self.curves.sort_by_key(|curve| curve.name);
        for curve in &self.curves {
            if let Some(comment) = &curve.comment {
                let _ = writeln!(text, "# {}: {comment}", curve.name);
            }
            let _ = writeln!(text, "{} = {}", curve.name, printed::points(&curve.points));
        }
        let degree = self.curves.iter().map(|curve| curve.points.len() - 1).max().unwrap_or(0);
        text += &methods(degree, self.curves.len() == 3);
        text
    }
}

/// The methods that a boundary of this degree is offered.
fn methods(degree: usize, is_triangular: bool) -> String {
    let limit = DegreeLimit::TriangularLeastArea;
    if !is_triangular || degree <= limit.degree() {
        return "\n[[method]]\nname = \"Dirichlet\"\nenergy = \"dirichlet\"\n\n\
                [[method]]\nname = \"least area\"\nenergy = \"area\"\n"
            .into();
    }
    let left_out =
        format!("\n# no least area of degree {degree}: {limit}; `--degree 6` fits sides of a lower one\n");
    let is_extremal = degree <= DegreeLimit::Triangle.degree();
    let method = if is_extremal { "energy = \"dirichlet\"" } else { "mask = \"dirichlet\"" };
    left_out + &format!("[[method]]\nname = \"Dirichlet\"\n{method}\n")
}

impl Curve {
    /// Takes the points as samples of a curve of the degree; a straight line is raised exactly.
    fn fit(&mut self, degree: usize, size: f64) -> Result<(), ImportError> {
        let refuse = |why| ImportError::Fit { side: self.label.clone(), why };
        let mut samples = self.points.clone();
        samples.dedup();
        let equal = self.points.len() - samples.len();
        let omitted = match equal {
            0 => String::new(),
            1 => "; 1 sample equal to the one before it was left out".into(),
            count => format!("; {count} samples equal to the ones before them were left out"),
        };
        if exchange::is_straight(&samples, last(&samples).distance(samples[0])) {
            let line =
                Bezier::new(vec![samples[0], last(&samples)]).map_err(|error| refuse(error.to_string()))?;
            self.comment = Some(format!("a straight line, exact{omitted}"));
            self.points = line.raised(degree).points().to_vec();
            return Ok(());
        }
        let fit = NearestCurve::new(&samples, degree).map_err(|error| refuse(error.to_string()))?;
        self.comment = Some(format!(
            "fit of degree {degree} to {} samples; farthest {:.2e} ({:.1e} of the size), root mean square {:.2e}{omitted}",
            samples.len(),
            fit.largest,
            fit.largest / size,
            fit.root_mean_square,
        ));
        self.points = fit.points;
        Ok(())
    }
}

/// The sides in the order and the sense in which they run around the boundary.
fn around(names: &[(&'static str, bool)], sides: &[(&str, &[Point])]) -> Vec<Curve> {
    let curve = |(name, forward): (&'static str, bool), (label, points): (&str, &[Point]), turned: bool| {
        let mut points = points.to_vec();
        if turned {
            points.reverse();
        }
        // Lines of an OBJ file need no name.
        let label = if label.is_empty() { name.to_owned() } else { label.to_owned() };
        Curve { name, label, points, forward, comment: None }
    };
    let named: Option<Vec<Curve>> = names
        .iter()
        .map(|&(name, forward)| {
            let side = sides.iter().find(|side| side.0 == name)?;
            Some(curve((name, forward), *side, !forward))
        })
        .collect();
    if let Some(named) = named {
        return named;
    }
    // Without the names of experiments the sides are chained, each the one that begins or ends nearest to where the chain ends.
    let mut rest = sides.to_vec();
    let mut chain = vec![curve(names[0], rest.remove(0), false)];
    while let Some(end) = chain.last().map(|curve| last(&curve.points)) {
        let nearest = (0..rest.len())
            .flat_map(|k| [(k, false), (k, true)])
            .map(|(k, turned)| {
                let points = rest[k].1;
                (end.distance(if turned { last(points) } else { points[0] }), k, turned)
            })
            .min_by(|a, b| a.0.total_cmp(&b.0));
        let Some((_, k, turned)) = nearest else { break };
        chain.push(curve(names[chain.len()], rest.remove(k), turned));
    }
    chain
}

/// Whether all points are one: a side may be a point.
fn is_point(points: &[Point]) -> bool {
    points.iter().all(|p| *p == points[0])
}

fn last(points: &[Point]) -> Point {
    points.last().copied().unwrap_or_default()
}

/// The names of all sides of an experiment, if they are those of the polylines of a file.
pub(super) fn names(file: &CurveFile) -> Option<&'static [(&'static str, bool)]> {
    let polylines = polylines(file)?;
    let is_there = |name: &str| polylines.iter().any(|(label, _)| *label == name);
    let all = [TENSOR.as_slice(), TRIANGLE.as_slice()];
    all.into_iter()
        .find(|names| names.len() == polylines.len() && names.iter().all(|(name, _)| is_there(name)))
}

/// The polylines of a file, if it has nothing else.
fn polylines(file: &CurveFile) -> Option<Vec<(&str, &[Point])>> {
    file.curves
        .iter()
        .map(|curve| match &curve.shape {
            Shape::Polyline(points) if !curve.closes => Some((curve.name.as_str(), points.as_slice())),
            Shape::Polyline(_) | Shape::Spline(_) | Shape::Arc(_) => None,
        })
        .collect()
}
