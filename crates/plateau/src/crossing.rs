//! Where a closed chain of straight segments that lies in a plane crosses itself.

use surfaces::{Point, extent};

/// Distances below this share of the extent are rounding: a chain so near a plane lies in it, and what only touches does not cross.
const ROUNDING: f64 = 1e-12;

/// Two segments that cross.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Crossing {
    /// The segments, from 0: segment k runs from point k to the next.
    pub(crate) segments: [usize; 2],
    /// Where.
    pub(crate) at: Point,
}

/// The first crossing of the closed chain through `around`, which may repeat points; none if it lies in no plane.
pub(crate) fn crossing(around: &[Point]) -> Option<Crossing> {
    let plane = Plane::of(around)?;
    let count = around.len();
    let flat: Vec<[f64; 2]> = around.iter().map(|&p| plane.seen(p)).collect();
    let segment = |k: usize| [flat[k], flat[(k + 1) % count]];
    let reach = |k: usize| {
        let [a, b] = segment(k);
        (a[0].min(b[0]), a[0].max(b[0]))
    };
    // Only segments whose shadows overlap can cross.
    let mut by_start: Vec<usize> = (0..count).collect();
    by_start.sort_by(|&i, &j| reach(i).0.total_cmp(&reach(j).0));
    let mut first: Option<([usize; 2], [f64; 2])> = None;
    for (place, &k) in by_start.iter().enumerate() {
        let end = reach(k).1;
        for &l in by_start[place + 1..].iter().take_while(|&&l| reach(l).0 <= end) {
            let pair = [k.min(l), k.max(l)];
            if pair[1] - pair[0] >= 2
                && first.is_none_or(|(found, _)| pair < found)
                && let Some(at) = met(segment(pair[0]), segment(pair[1]), ROUNDING * plane.extent)
            {
                first = Some((pair, at));
            }
        }
    }
    first.map(|(segments, [x, y])| Crossing {
        segments,
        at: plane.origin + plane.axes[0] * x + plane.axes[1] * y,
    })
}

/// Where two open chains in one plane cross, without a care for which of their segments do.
pub(crate) fn meet(plane_of: &[Point], first: &[Point], second: &[Point]) -> Option<Point> {
    let plane = Plane::of(plane_of)?;
    let flat = |chain: &[Point]| chain.iter().map(|&p| plane.seen(p)).collect::<Vec<_>>();
    let (first, second) = (flat(first), flat(second));
    let at = first.windows(2).find_map(|p| {
        second.windows(2).find_map(|q| met([p[0], p[1]], [q[0], q[1]], ROUNDING * plane.extent))
    });
    at.map(|[x, y]| plane.origin + plane.axes[0] * x + plane.axes[1] * y)
}

/// A plane with all points of a chain in it.
struct Plane {
    origin: Point,
    axes: [Point; 2],
    extent: f64,
}

impl Plane {
    /// None for points on one line, or in no plane.
    fn of(points: &[Point]) -> Option<Self> {
        let &origin = points.first()?;
        let extent = extent(points);
        let farthest = |of: &dyn Fn(Point) -> Point| {
            let all = points.iter().map(|&p| of(p - origin));
            all.reduce(|q, p| if p.norm() > q.norm() { p } else { q })
        };
        let along = farthest(&|d| d)?.unit()?;
        let across = farthest(&|d| d - along * d.dot(along))?;
        if across.norm() <= ROUNDING * extent {
            return None;
        }
        let across = across.unit()?;
        let normal = along.cross(across);
        let lies_in = |p: &Point| (*p - origin).dot(normal).abs() <= ROUNDING * extent;
        points.iter().all(lies_in).then_some(Self { origin, axes: [along, across], extent })
    }

    fn seen(&self, p: Point) -> [f64; 2] {
        self.axes.map(|axis| (p - self.origin).dot(axis))
    }
}

/// Where two segments cross, each end of either farther than `tiny` from the line of the other.
fn met(p: [[f64; 2]; 2], q: [[f64; 2]; 2], tiny: f64) -> Option<[f64; 2]> {
    let turn =
        |[a, b]: [[f64; 2]; 2], c: [f64; 2]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    let length = |[a, b]: [[f64; 2]; 2]| libm::hypot(b[0] - a[0], b[1] - a[1]);
    let apart = |x: f64, y: f64, length: f64| x * y < 0.0 && x.abs().min(y.abs()) > tiny * length;
    let (of_q, of_p) = ([turn(p, q[0]), turn(p, q[1])], [turn(q, p[0]), turn(q, p[1])]);
    if !(apart(of_q[0], of_q[1], length(p)) && apart(of_p[0], of_p[1], length(q))) {
        return None;
    }
    let t = of_p[0] / (of_p[0] - of_p[1]);
    Some([0, 1].map(|k| p[0][k] + t * (p[1][k] - p[0][k])))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chain(points: &[[f64; 2]]) -> Vec<Point> {
        // In a plane that is none of the coordinates.
        points.iter().map(|&[x, y]| Point::new(x, 0.6 * y, 0.8 * y) + Point::new(1.0, 2.0, 3.0)).collect()
    }

    #[test]
    fn a_crossing_is_found_where_it_is() {
        let eight = chain(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]]);
        let found = crossing(&eight).unwrap();
        assert_eq!(found.segments, [1, 3]);
        assert!(found.at.distance(chain(&[[0.5, 0.5]])[0]) < 1e-15);
    }

    #[test]
    fn what_touches_or_lies_in_space_does_not_cross() {
        let square = chain(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
        assert_eq!(crossing(&square), None);
        // A vertex on another side, and a seam run there and back.
        assert_eq!(crossing(&chain(&[[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 0.0], [0.0, 1.0]])), None);
        let seam = [
            [0.0, 0.0],
            [3.0, 0.0],
            [3.0, 3.0],
            [2.0, 2.0],
            [2.0, 1.0],
            [1.0, 1.0],
            [2.0, 2.0],
            [3.0, 3.0],
            [0.0, 3.0],
        ];
        assert_eq!(crossing(&chain(&seam)), None);
        let mut eight = chain(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]]);
        eight[0].x -= 1e-9;
        eight[0].z += 1e-9;
        assert_eq!(crossing(&eight), None);
    }
}
