//! Extremals at degrees whose control points are no good unknowns: the free part of the surface in functions that vanish on the
//! border and stay well conditioned.
//!
//! With F the patch over the discrete Coons net of the sides, the extremal is `F + Σ c_kl f_k(u) g_l(v)`, f and g the bubbles of
//! the family ([`ShapedFamily::bubbles`](surfaces::ShapedFamily::bubbles)); the control points of `f_k` are exact, so the interior of the net is that of
//! F plus `M c Mᵀ`.

use std::sync::Arc;

use bases::{Basis, Lobatto, Matrix};
use energy::Functional;
use solve::{ProductSystem, ProductTerm, SampledFunctions};
use surfaces::{Patch as _, Product, TensorPatch, discrete_coons, polynomial_bubbles};

use crate::{FixedShape, MethodError, SolveFigures};

/// Largest loss at which a part of the extremal is kept: rounding of its control points as a share of the part itself.
const LARGEST_LOSS: f64 = 1e-2;

/// `patch` with its interior at the extremal of `functional`; `shape` is that of its functions.
pub(crate) fn extremal(
    patch: &TensorPatch,
    functional: Functional,
    shape: Option<&FixedShape>,
) -> Result<(TensorPatch, SolveFigures), MethodError> {
    let net = patch.net();
    let (m, n) = net.degrees();
    let [u0, u1, v0, v1] = net.boundary();
    let start = patch.with_net(discrete_coons(&u0, &u1, &v0, &v1)?)?;
    let products = match shape {
        Some(shape) => shape.family().bubbles((m, n), shape.parameters())?,
        None => vec![Product { u: polynomial_bubbles(m)?, v: polynomial_bubbles(n)? }],
    };
    let u = sampled(products.iter().map(|p| &p.u), m, functional)?;
    let v = sampled(products.iter().map(|p| &p.v), n, functional)?;
    let terms: Vec<ProductTerm> = functional
        .terms()
        .iter()
        .map(|term| ProductTerm { coefficient: term.coefficient, u: term.u, v: term.v })
        .collect();
    let pairs: Vec<[SampledFunctions; 2]> =
        u.families.iter().cloned().zip(v.families.iter().cloned()).map(|(f, g)| [f, g]).collect();
    let system = ProductSystem::new([&u.weights, &v.weights], &pairs, &terms)?;
    let jets = start.jets(&u.nodes, &v.nodes);
    let solution =
        system.solve(|a, b| jets.iter().flat_map(|jet| <[f64; 3]>::from(jet.derivative(a, b))).collect())?;
    let (interior, left_out) = control_points(&solution.x, &u, &v)?;
    let mut coordinates = start.net().coordinates();
    for (x, free) in coordinates.iter_mut().zip(&interior) {
        *x += free;
    }
    let figures = SolveFigures {
        solver: "conjugate-gradients",
        residual: solution.residual,
        condition: solution.condition,
        basis_condition: None,
        certified: None,
        left_out: Some(if left_out > 0.0 { left_out / start.net().size() } else { 0.0 }),
        metric: None,
    };
    Ok((patch.with_net(net.with_coordinates(&coordinates)?)?, figures))
}

/// The bubbles of one direction at the points of a rule, with their control points.
struct Direction {
    nodes: Vec<f64>,
    weights: Vec<f64>,
    families: Vec<SampledFunctions>,
    /// (degree + 1) × (degree − 1).
    points: Matrix,
}

impl Direction {
    /// The largest control point of each bubble over its largest value.
    fn growth(&self) -> Vec<f64> {
        let values = &self.families[0];
        let largest = |k: usize| {
            values.orders[0].iter().skip(k).step_by(values.functions).fold(0.0f64, |a, x| a.max(x.abs()))
        };
        let reach = |k: usize| (0..self.points.rows()).fold(0.0f64, |a, i| a.max(self.points[(i, k)].abs()));
        (0..values.functions).map(|k| reach(k) / largest(k)).collect()
    }
}

fn sampled<'a>(
    families: impl Iterator<Item = &'a Arc<dyn Basis>>,
    degree: usize,
    functional: Functional,
) -> Result<Direction, MethodError> {
    let rule = bases::Samples::points_for(degree + 1);
    let samples = families
        .map(|family| bases::Samples::new(family.as_ref(), rule, functional.order()))
        .collect::<Result<Vec<_>, _>>()?;
    let orders = |samples: &bases::Samples| {
        let orders = (0..=functional.order()).map(|r| samples.order(r).as_slice().to_vec()).collect();
        SampledFunctions { functions: degree - 1, orders }
    };
    Ok(Direction {
        nodes: samples[0].nodes().to_vec(),
        weights: samples[0].weights().to_vec(),
        families: samples.iter().map(orders).collect(),
        points: Lobatto::bernstein_coefficients(degree)?,
    })
}

/// `M c Mᵀ` for each coordinate, of the parts whose control points doubles can hold; and the largest distance that the others
/// would have moved a point.
///
/// Control points of a bubble are up to 2ⁿ times as large as its values. A part whose rounding would be more than a hundredth of
/// the part itself brings less than it costs; at degrees to 25 there is none.
fn control_points(c: &[f64], u: &Direction, v: &Direction) -> Result<(Vec<f64>, f64), MethodError> {
    let (rows, cols) = (u.points.rows(), v.points.rows());
    let (of_u, of_v) = (u.growth(), v.growth());
    let kept = |k: usize, l: usize| f64::EPSILON * of_u[k] * of_v[l] <= LARGEST_LOSS;
    let mut interior = vec![0.0; 3 * rows * cols];
    let mut distance = vec![0.0f64; u.nodes.len() * v.nodes.len()];
    for d in 0..3 {
        let part = |wanted: bool| {
            Matrix::from_fn(rows - 2, cols - 2, |k, l| {
                if kept(k, l) == wanted { c[3 * (k * (cols - 2) + l) + d] } else { 0.0 }
            })
        };
        let net = u.points.times(&part(true)).times(&v.points.transpose());
        net.as_slice().iter().enumerate().for_each(|(k, x)| interior[3 * k + d] = *x);
        let left = part(false);
        if left.max_abs() > 0.0 {
            let mut moved = Matrix::zeros(u.nodes.len(), v.nodes.len());
            for (f, g) in u.families.iter().zip(&v.families) {
                let part = values(f).times(&left).times(&values(g).transpose());
                moved.as_mut_slice().iter_mut().zip(part.as_slice()).for_each(|(sum, x)| *sum += x);
            }
            distance.iter_mut().zip(moved.as_slice()).for_each(|(a, x)| *a += x * x);
        }
    }
    Ok((interior, distance.iter().fold(0.0f64, |a, x| a.max(*x)).sqrt()))
}

/// Values: points × functions.
fn values(family: &SampledFunctions) -> Matrix {
    let points = family.orders[0].len() / family.functions;
    Matrix::from_fn(points, family.functions, |p, k| family.orders[0][p * family.functions + k])
}
