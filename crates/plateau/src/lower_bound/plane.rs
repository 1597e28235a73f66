//! The plane over which a surface is a graph.

use bases::GaussLegendre;
use energy::{EnergyError, Plane};
use surfaces::{Complex, Point};

use super::NoBound;

/// A plane to which every normal of the surface leans, with its normal on their side; none if there is none. That across the mean
/// of the normals, which the rim determines, is turned towards the one furthest from it until all are on its side.
pub(super) fn plane(complex: &Complex) -> Result<Option<Plane>, NoBound> {
    // Where all normals lean to one side the projection to the plane across it keeps its orientation.
    let mut normals = Vec::new();
    let samples = complex.degree() + 2;
    for face in 0..complex.faces().len() {
        let patch = complex.patch(face)?;
        let at: Vec<f64> = (0..=samples).map(|k| k as f64 / samples as f64).collect();
        normals.extend(surfaces::Patch::jets(&patch, &at, &at).iter().map(|jet| jet.u.cross(jet.v)));
    }
    let mut sum = area_vector(complex)?;
    let directions: Vec<Point> = normals.into_iter().filter_map(Point::unit).collect();
    let centre =
        complex.points().iter().fold(Point::ZERO, |sum, &p| sum + p) * (1.0 / complex.points().len() as f64);
    for _ in 0..200 {
        let Some(plane) = Plane::with_normal(centre, sum) else { return Ok(None) };
        let lean = |d: &Point| d.dot(plane.axes[2]);
        let Some(worst) = directions.iter().min_by(|a, b| lean(a).total_cmp(&lean(b))) else {
            return Ok(None);
        };
        if lean(worst) > 1e-3 {
            return Ok(Some(plane));
        }
        // Turned towards the worst one until that leans by 0.2; others may then lean less, and are next.
        sum = plane.axes[2] + *worst * (0.2 - lean(worst));
    }
    Ok(None)
}

/// Twice `∫ N dA = ½ ∮ x × dx`, which only the rim decides.
fn area_vector(complex: &Complex) -> Result<Point, NoBound> {
    // The integrand has degree 2p − 1: exact with p points.
    let rule = GaussLegendre::new(complex.degree()).map_err(EnergyError::from)?.on(0.0, 1.0);
    let origin = complex.points()[0];
    let mut sum = Point::ZERO;
    for (number, edge) in complex.edges().iter().enumerate() {
        // Inner edges are run through in both senses and cancel.
        let [only] = edge.uses() else { continue };
        let curve = complex.edge_curve(number);
        let backwards = only.reversed == only.side.runs_round();
        for (t, weight) in rule.iter() {
            let swept = (curve.point(t) - origin).cross(curve.derivative(t)) * weight;
            sum = if backwards { sum - swept } else { sum + swept };
        }
    }
    Ok(sum)
}
