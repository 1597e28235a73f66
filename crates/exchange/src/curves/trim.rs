//! Pieces of splines and ellipses.

use std::f64::consts::TAU;

use surfaces::{EllipseArc, Point, SplineCurve};

use super::Shape;

/// A point with its weight, `(w x, w y, w z, w)`.
type Homogeneous = [f64; 4];

/// Ends of the domain of a spline, in its knots.
pub(super) fn domain(spline: &SplineCurve) -> [f64; 2] {
    [spline.knots()[spline.degree()], spline.knots()[spline.points().len()]]
}

/// Whether a spline ends in its first and last control point.
fn is_clamped(spline: &SplineCurve) -> bool {
    let ([a, b], knots) = (domain(spline), spline.knots());
    knots[0] == a && knots[knots.len() - 1] == b
}

/// The piece of a spline between two knots, `from` < `to`, clamped at both; exact.
///
/// # Errors
/// In words, where nothing lies between them.
pub(super) fn cut(spline: &SplineCurve, from: f64, to: f64) -> Result<SplineCurve, String> {
    let [a, b] = domain(spline);
    let close = 1e-12 * (b - a);
    let (from, to) = (if from - a <= close { a } else { from }, if b - to <= close { b } else { to });
    if from == a && to == b && is_clamped(spline) {
        return Ok(spline.clone());
    }
    if (to - from).partial_cmp(&close) != Some(std::cmp::Ordering::Greater) {
        return Err("no piece between its ends".into());
    }
    let degree = spline.degree();
    let mut points: Vec<Homogeneous> = (0..spline.points().len()).map(|i| homogeneous(spline, i)).collect();
    let mut knots = spline.knots().to_vec();
    for t in [from, to] {
        // Knots that are equal to rounding become equal, or pieces of no length would be left.
        for knot in &mut knots {
            if (*knot - t).abs() <= close {
                *knot = t;
            }
        }
        let present = knots.iter().filter(|knot| **knot == t).count();
        for _ in present..degree {
            insert(&mut knots, &mut points, degree, t);
        }
    }
    let first = knots.iter().position(|t| *t == from).unwrap_or(0);
    let run = knots[first..].iter().take_while(|t| **t == from).count();
    let end = knots.iter().position(|t| *t == to).unwrap_or(knots.len());
    // The curve passes through the control point before the innermost `degree` of the repeated knots.
    let start = (first + run).saturating_sub(degree + 1);
    let inner = &knots[first + run..end];
    let kept = points.get(start..start + inner.len() + degree + 1).ok_or("no piece between its ends")?;
    let knots = [vec![from; degree + 1], inner.to_vec(), vec![to; degree + 1]].concat();
    let weights = spline.weights().is_some().then(|| kept.iter().map(|p| p[3]).collect());
    SplineCurve::new(degree, knots, kept.iter().map(|p| plain(*p)).collect(), weights)
        .map_err(|error| error.to_string())
}

/// The knot value of the point nearest to `p`, and the distance: samples, then golden sections around the best.
pub(super) fn nearest(spline: &SplineCurve, p: Point) -> (f64, f64) {
    let [a, b] = domain(spline);
    let count = (8 * (spline.points().len() - spline.degree())).clamp(32, 2000);
    let distance = |t: f64| spline.jet(t).point.distance(p);
    let at = |k: usize| k as f64 / count as f64;
    let best = (0..=count).min_by(|&i, &j| distance(at(i)).total_cmp(&distance(at(j)))).unwrap_or(0);
    let (mut low, mut high) = (at(best.saturating_sub(1)), at((best + 1).min(count)));
    for _ in 0..80 {
        let (s, t) = (low + 0.381_966 * (high - low), high - 0.381_966 * (high - low));
        if distance(s) <= distance(t) {
            high = t;
        } else {
            low = s;
        }
    }
    let candidates = [0.0, 1.0, at(best), 0.5 * (low + high)];
    let t = candidates.into_iter().min_by(|s, t| distance(*s).total_cmp(&distance(*t))).unwrap_or(0.0);
    (a * (1.0 - t) + b * t, distance(t))
}

/// The angle of an ellipse at which it passes nearest to `p`, for a point on it; in [0, 2π).
pub(super) fn angle(arc: &EllipseArc, p: Point) -> f64 {
    let off = p - arc.center();
    let [x, y] = [0, 1].map(|k| off.dot(arc.axes()[k]) / arc.radii()[k]);
    let angle = libm::atan2(y, x);
    if angle < 0.0 { angle + TAU } else { angle }
}

/// The arc of an ellipse from one angle on to another, full turns taken away; equal angles make a full turn.
pub(super) fn forward(arc: &EllipseArc, from: f64, to: f64) -> Result<EllipseArc, String> {
    let from = from % TAU;
    let mut span = (to - from) % TAU;
    if span <= 1e-9 {
        span += TAU;
    }
    arc.between(from, from + span).map_err(|error| error.to_string())
}

/// The two halves of a curve, by its own parameter; of a polyline by its points, none where it has two.
pub(crate) fn halved(shape: &Shape) -> Option<[Shape; 2]> {
    match shape {
        Shape::Polyline(points) if points.len() < 3 => None,
        Shape::Polyline(points) => {
            let middle = points.len() / 2;
            Some([points[..=middle].to_vec(), points[middle..].to_vec()].map(Shape::Polyline))
        }
        Shape::Spline(spline) => {
            let [a, b] = domain(spline);
            let middle = 0.5 * (a + b);
            Some([Shape::Spline(cut(spline, a, middle).ok()?), Shape::Spline(cut(spline, middle, b).ok()?)])
        }
        Shape::Arc(arc) => {
            let [a, b] = arc.angles();
            let middle = 0.5 * (a + b);
            Some([Shape::Arc(arc.between(a, middle).ok()?), Shape::Arc(arc.between(middle, b).ok()?)])
        }
    }
}

fn homogeneous(spline: &SplineCurve, i: usize) -> Homogeneous {
    let w = spline.weights().map_or(1.0, |weights| weights[i]);
    let p = spline.points()[i];
    [w * p.x, w * p.y, w * p.z, w]
}

/// Inserts the knot t once (Boehm).
fn insert(knots: &mut Vec<f64>, points: &mut Vec<Homogeneous>, degree: usize, t: f64) {
    let k = knots.partition_point(|knot| *knot <= t).saturating_sub(1).min(points.len() - 1);
    let next = (0..=points.len()).map(|i| {
        let share = if i + degree <= k {
            1.0
        } else if i > k {
            0.0
        } else {
            let width = knots[i + degree] - knots[i];
            if width > 0.0 { (t - knots[i]) / width } else { 0.0 }
        };
        mixed(points[i.saturating_sub(1)], points[i.min(points.len() - 1)], share)
    });
    *points = next.collect();
    knots.insert(k + 1, t);
}

/// Either end comes out digit for digit.
fn mixed(a: Homogeneous, b: Homogeneous, t: f64) -> Homogeneous {
    if t == 0.0 {
        a
    } else if t == 1.0 {
        b
    } else {
        std::array::from_fn(|i| a[i] * (1.0 - t) + b[i] * t)
    }
}

fn plain([x, y, z, w]: Homogeneous) -> Point {
    if w == 1.0 { Point::new(x, y, z) } else { Point::new(x / w, y / w, z / w) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(count: usize) -> Vec<Point> {
        (0..count).map(|k| k as f64).map(|k| Point::new(k, (k * 1.3).sin(), (k * 0.7).cos())).collect()
    }

    #[test]
    fn pieces_lie_on_the_curve() {
        let clamped = vec![0., 0., 0., 0., 1., 1., 2.5, 4., 4., 4., 4.];
        let open: Vec<f64> = (-3..8).map(f64::from).collect();
        let weights = vec![1.0, 2.0, 0.5, 1.0, 3.0, 1.0, 1.0];
        for (knots, weights) in
            [(&clamped, None), (&clamped, Some(weights.clone())), (&open, None), (&open, Some(weights))]
        {
            let spline = SplineCurve::new(3, knots.clone(), points(7), weights).unwrap();
            assert_eq!(domain(&spline), [0.0, 4.0]);
            for (from, to) in [(0.0, 4.0), (0.3, 3.7), (1.0, 2.5), (0.0, 0.5), (2.6, 4.0), (0.9, 1.1)] {
                let piece = cut(&spline, from, to).unwrap();
                for k in 0..=20 {
                    let s = f64::from(k) / 20.0;
                    let t = from + (to - from) * s;
                    assert!(
                        piece.jet(s).point.distance(spline.jet(t / 4.0).point) < 1e-13,
                        "{from} {to} {t}"
                    );
                }
                assert!(is_clamped(&piece));
            }
            let (t, distance) = nearest(&spline, spline.jet(0.3).point);
            assert!(distance < 1e-7 && (t - 1.2).abs() < 1e-6);
            assert!(cut(&spline, 1.0, 1.0).is_err() && cut(&spline, f64::NAN, 1.0).is_err());
        }
    }
}
