//! Whether a rim bounds no more than graphs.

use energy::Plane;
use surfaces::{Complex, Point, Side};

/// Whether the rim is one loop that projects to a convex curve: its control polygons, end to end, turn left all the way, once.
pub(super) fn is_convex(complex: &Complex, plane: &Plane) -> bool {
    let Some(polygon) = rim_polygon(complex) else { return false };
    let flat: Vec<[f64; 2]> = polygon.iter().map(|&p| plane.coordinates(p)).map(|[x, y, _]| [x, y]).collect();
    let steps: Vec<[f64; 2]> = (0..flat.len())
        .map(|k| (flat[k], flat[(k + 1) % flat.len()]))
        .map(|(a, b)| [b[0] - a[0], b[1] - a[1]])
        .filter(|s| s[0] != 0.0 || s[1] != 0.0)
        .collect();
    // A convex curve turns left by 2π in all; more would be a curve that winds twice.
    let mut turned = 0.0;
    for (k, a) in steps.iter().enumerate() {
        let b = steps[(k + 1) % steps.len()];
        // The control polygon of a Bézier curve turns at least as much as the curve: if it never turns right, nor does the curve.
        let (cross, along) = (a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
        let rounding = 64.0 * f64::EPSILON * complex.size() * (a[0].hypot(a[1]) + b[0].hypot(b[1]));
        if cross < -rounding {
            return false;
        }
        turned += cross.max(0.0).atan2(along);
    }
    (turned - std::f64::consts::TAU).abs() < 1e-6
}

/// The control points of the rim in order, with the surface on the left; none if it is not one loop.
fn rim_polygon(complex: &Complex) -> Option<Vec<Point>> {
    let mut runs: Vec<Vec<usize>> = Vec::new();
    for (number, edge) in complex.edges().iter().enumerate() {
        let [only] = edge.uses() else { continue };
        let mut nodes = complex.edge_nodes(number);
        if only.reversed == Side::runs_round(only.side) {
            nodes.reverse();
        }
        runs.push(nodes);
    }
    let mut current = runs.pop()?;
    let (first, mut polygon) = (current[0], Vec::new());
    loop {
        let end = *current.last()?;
        polygon.extend(current[..current.len() - 1].iter().map(|&node| complex.points()[node]));
        if end == first {
            return runs.is_empty().then_some(polygon);
        }
        let next = runs.iter().position(|run| run[0] == end)?;
        current = runs.swap_remove(next);
    }
}
