//! Where an annulus is thinnest.

use surfaces::{Complex, Patch, Point, Side};

use crate::MethodError;

/// Steps of each face in which its lines across are measured.
const STEPS: usize = 16;

/// A closed line around an annulus.
pub(super) struct Waist {
    /// Its length.
    pub(super) length: f64,
    /// The mean of its points.
    pub(super) middle: Point,
    /// The length of the shorter rim.
    pub(super) rim: f64,
}

/// The shortest closed line around an annulus at one parameter of its faces. None if the faces are no rows around from one
/// rim to the other.
pub(super) fn thinnest(complex: &Complex) -> Result<Option<Waist>, MethodError> {
    let steps: Vec<f64> = (0..=STEPS).map(|k| k as f64 / STEPS as f64).collect();
    let mut lines: Vec<(f64, Point)> = Vec::new();
    for ring in rings(complex) {
        // One polyline across every face at each step away from the edge it was entered by.
        let start = lines.len();
        lines.resize(start + STEPS + 1, (0.0, Point::ZERO));
        for &(face, side) in &ring {
            let patch = complex.patch(face)?;
            for (line, &away) in lines[start..].iter_mut().zip(&steps) {
                let at = |t: f64| match side {
                    Side::V0 => patch.point(t, away),
                    Side::V1 => patch.point(t, 1.0 - away),
                    Side::U0 => patch.point(away, t),
                    Side::U1 => patch.point(1.0 - away, t),
                };
                let points: Vec<Point> = steps.iter().map(|&t| at(t)).collect();
                line.0 += points.windows(2).map(|ends| ends[0].distance(ends[1])).sum::<f64>();
                let mean = points[..STEPS].iter().fold(Point::ZERO, |sum, &p| sum + p) * (1.0 / STEPS as f64);
                line.1 += mean * (1.0 / ring.len() as f64);
            }
        }
    }
    let (Some(first), Some(last)) = (lines.first(), lines.last()) else { return Ok(None) };
    let rim = first.0.min(last.0);
    let waist = lines.iter().min_by(|a, b| a.0.total_cmp(&b.0));
    Ok(waist.map(|&(length, middle)| Waist { length, middle, rim }))
}

/// Rows of faces side by side around the annulus, each with the side it is entered by from the rim the rows begin at.
fn rings(complex: &Complex) -> Vec<Vec<(usize, Side)>> {
    let opposite = |side: Side| match side {
        Side::V0 => Side::V1,
        Side::V1 => Side::V0,
        Side::U0 => Side::U1,
        Side::U1 => Side::U0,
    };
    // The rim that the first rim edge belongs to.
    let edges = complex.edges();
    let rim: Vec<usize> = (0..edges.len()).filter(|&e| edges[e].uses().len() == 1).collect();
    let Some(&first) = rim.first() else { return Vec::new() };
    let mut around = vec![first];
    let mut vertices: Vec<usize> = edges[first].ends().to_vec();
    while let Some(&next) =
        rim.iter().find(|e| !around.contains(e) && edges[**e].ends().iter().any(|v| vertices.contains(v)))
    {
        around.push(next);
        vertices.extend(edges[next].ends());
    }
    let mut rows: Vec<Vec<(usize, Side)>> = Vec::new();
    for edge in around {
        let (mut edge, mut row) = (edge, 0);
        let mut from = usize::MAX;
        while let Some(here) = edges[edge].uses().iter().find(|here| here.face != from) {
            if row > complex.faces().len() {
                return Vec::new();
            }
            if rows.len() <= row {
                rows.push(Vec::new());
            }
            rows[row].push((here.face, here.side));
            let place = Side::ALL.iter().position(|side| *side == opposite(here.side)).unwrap_or(0);
            (from, edge, row) = (here.face, complex.faces()[here.face].edges()[place], row + 1);
        }
    }
    rows
}
