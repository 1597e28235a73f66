//! The proof of a calibration's bound.

use surfaces::{Complex, Side};
use thiserror::Error;

use crate::Plane;
use crate::bernstein_form::{BernsteinForm, interpolate};

/// Why a bound could not be proved.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum Unproved {
    /// The projection of a face to the plane could not be shown to keep its orientation.
    #[error("face {face} could not be shown to be a graph over the plane")]
    NoGraph {
        /// The face.
        face: usize,
    },
    /// |∇ψ| could not be shown to be at most 1.
    #[error("on face {face} the potential could not be shown to rise by at most 1")]
    Steep {
        /// The face.
        face: usize,
    },
    /// The list of coefficients does not belong to the complex raised to the degree, or the complex has edges of three and more faces.
    #[error("the potential does not belong to this surface")]
    Mismatch,
}

/// How often a face is cut into quarters to prove a sign.
const DEEPEST: usize = 6;

/// Degree of the polynomial that stands for the inverse of the integrand.
const INVERSE_DEGREE: usize = 10;

/// A face is cut further while the integrand times that polynomial is further from 1 than this: the bound loses 3/8 of its square.
const LOOSE: f64 = 3e-7;

/// A lower bound of the area of every graph over the region below `complex` in `plane` with its rim, by the potential ψ of degree
/// `degree` with the coefficients `psi` (see [`Calibration`](crate::Calibration)). *Proved*, that is: true of the control points as given,
/// whatever rounding did.
///
/// - The planar map keeps its orientation and |∇ψ| ≤ 1 because the Bernstein coefficients of its Jacobian D and of
///   `q = D² − |ψ_u y_v − ψ_v y_u|² − |ψ_v x_u − ψ_u x_v|²` are positive, on each face or on the parts it is cut into.
/// - `√q ≥ q y (3 − q y²) / 2` for every y with q y² ≤ 3; with a polynomial y ≈ 1/√q the right-hand side is a polynomial, whose
///   integral is the mean of its coefficients. What this loses is of second order in `q y² − 1`.
/// - Every coefficient carries a bound of its rounding, which is taken off.
///
/// # Errors
/// [`Unproved`] with the face where a sign could not be shown.
pub fn certify(complex: &Complex, plane: &Plane, degree: usize, psi: &[f64]) -> Result<f64, Unproved> {
    let raised = complex.with_degree(degree).map_err(|_| Unproved::Mismatch)?;
    let films_meet = complex.edges().iter().any(|edge| edge.uses().len() > 2);
    if psi.len() != raised.points().len() || films_meet {
        return Err(Unproved::Mismatch);
    }
    let places: Vec<[f64; 3]> = complex.points().iter().map(|&p| plane.coordinates(p)).collect();
    let reach = complex.points().iter().map(|p| p.distance(plane.origin)).fold(0.0, f64::max);
    // Three products, two sums, a difference, and axes that are orthonormal to a few roundings.
    let error = 16.0 * f64::EPSILON * reach;
    let form = |nodes: &[usize], c: usize| {
        let p = complex.degree();
        BernsteinForm::new([p, p], nodes.iter().map(|&k| places[k][c]).collect(), error)
    };
    let mut bound = 0.0;
    for (number, (face, fine)) in complex.faces().iter().zip(raised.faces()).enumerate() {
        let [x, y] = [0, 1].map(|c| form(face.nodes(), c));
        let psi = fine.nodes().iter().map(|&k| psi[k]).collect();
        // ψ carries no error: it is a polynomial by its coefficients, and any polynomial with |∇ψ| ≤ 1 proves a bound.
        let psi = BernsteinForm::new([degree, degree], psi, 0.0);
        let jacobian = jacobian(&x, &y);
        if !positive(&jacobian, 0) {
            return Err(Unproved::NoGraph { face: number });
        }
        let square = radicand(&jacobian, &x, &y, &psi);
        // √q = D √(1 − |∇ψ|²) is the integrand over the parameters: no division by D, so that everything stays polynomial.
        bound += root_integral(&square, 0).ok_or(Unproved::Steep { face: number })?;
        let z = form(face.nodes(), 2);
        for side in rim_sides(complex, number) {
            bound += rim_integral(&z, &psi, side);
        }
    }
    // The frame turns space up to a relative error of its axes, areas by twice that; the sum over the faces rounds, too.
    let count = complex.faces().len() as f64;
    Ok(bound - f64::EPSILON * (64.0 + count) * bound.abs())
}

/// `f_u g_v − f_v g_u`.
fn jacobian(f: &BernsteinForm, g: &BernsteinForm) -> BernsteinForm {
    f.derivative(0).times(&g.derivative(1)).plus(-1.0, &f.derivative(1).times(&g.derivative(0)))
}

/// The square of the integrand: `D² (1 − |∇ψ|²)`.
fn radicand(
    determinant: &BernsteinForm,
    x: &BernsteinForm,
    y: &BernsteinForm,
    psi: &BernsteinForm,
) -> BernsteinForm {
    // D ∇ψ = (ψ_u y_v − ψ_v y_u, ψ_v x_u − ψ_u x_v).
    let (by_x, by_y) = (jacobian(psi, y), jacobian(x, psi));
    let slopes = by_x.times(&by_x).plus(1.0, &by_y.times(&by_y));
    // Slopes have a higher degree than D² when ψ does: sums are taken between forms of equal degrees.
    determinant.times(determinant).raised(slopes.degrees()).plus(-1.0, &slopes)
}

/// Whether a polynomial is shown to be positive on the square.
fn positive(form: &BernsteinForm, depth: usize) -> bool {
    // The least coefficient is a lower bound of the polynomial, and each cut brings it nearer to the least value by a factor of 4.
    form.least() > 0.0 || (depth < DEEPEST && form.quarters().iter().all(|part| positive(part, depth + 1)))
}

/// A lower bound of `∫ √q` over the square; none if q is not shown to be positive.
fn root_integral(q: &BernsteinForm, depth: usize) -> Option<f64> {
    // A part in the unit square has a quarter of the area.
    let cut = |q: &BernsteinForm| {
        q.quarters().iter().map(|part| root_integral(part, depth + 1).map(|i| 0.25 * i)).sum::<Option<f64>>()
    };
    if q.least() <= 0.0 {
        return if depth < DEEPEST { cut(q) } else { None };
    }
    // The interpolation need not be accurate for the proof, only for a good bound: the inequality holds for every y.
    let inverse = interpolate(INVERSE_DEGREE, |u, v| 1.0 / q.value(u, v).sqrt());
    let first = q.times(&inverse);
    let product = first.times(&inverse);
    let away = (product.largest() - 1.0).max(1.0 - product.least());
    if away > LOOSE && depth < DEEPEST {
        return cut(q);
    }
    if product.largest() > 3.0 {
        // Nothing is known of the root but that it is positive.
        return Some(0.0);
    }
    let three = BernsteinForm::one(product.degrees());
    // (3/2) q y (1 − q y²/3).
    Some(first.times(&three.plus(-1.0 / 3.0, &product)).least_integral() * 1.5)
}

/// The sides of a face on the rim.
fn rim_sides(complex: &Complex, face: usize) -> impl Iterator<Item = Side> + '_ {
    let edges = complex.faces()[face].edges();
    Side::ALL
        .into_iter()
        .zip(edges)
        .filter(|&(_, edge)| complex.edges()[edge].uses().len() == 1)
        .map(|(side, _)| side)
}

/// A lower bound of `∫ z dψ` along a side, with the face on the left.
fn rim_integral(z: &BernsteinForm, psi: &BernsteinForm, side: Side) -> f64 {
    let slope = psi.side(side).derivative(0);
    // Sides that do not run round the face are run through backwards: the sign turns.
    z.side(side).times(&slope).signed(!side.runs_round()).least_integral()
}
