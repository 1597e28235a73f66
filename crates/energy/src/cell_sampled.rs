//! Cells of any functions, known by their samples.

use bases::Matrix;
use surfaces::Point;

use crate::EnergyError;
use crate::area_hessian::Density;
use crate::cell::{Cell, Freedom, numbered};
use crate::panel::{Left, Right, add_panels};
use crate::product::{add_upper_product, mirror, mirrored};

/// A cell whose functions do not separate, with their values and derivatives at every point of its rule. O(q² N²) a Hessian
/// of N nodes at q² points.
#[derive(Debug, Clone)]
pub struct SampledCell {
    parameters: Vec<[f64; 2]>,
    weights: Vec<f64>,
    values: Matrix,
    u: Matrix,
    v: Matrix,
}

impl SampledCell {
    /// The cell with these values and derivatives (by u, by v): points × nodes.
    ///
    /// # Errors
    /// [`EnergyError::Shape`] if the sizes do not agree.
    pub fn new(
        parameters: Vec<[f64; 2]>,
        weights: Vec<f64>,
        values: Matrix,
        [u, v]: [Matrix; 2],
    ) -> Result<Self, EnergyError> {
        let points = parameters.len();
        for (what, expected, found) in [
            ("weights of a cell", points, weights.len()),
            ("rows of the values of a cell", points, values.rows()),
            ("rows of the u-derivatives of a cell", points, u.rows()),
            ("rows of the v-derivatives of a cell", points, v.rows()),
            ("columns of the u-derivatives of a cell", values.cols(), u.cols()),
            ("columns of the v-derivatives of a cell", values.cols(), v.cols()),
        ] {
            if expected != found {
                return Err(EnergyError::Shape { what, expected, found });
            }
        }
        Ok(Self::of(parameters, weights, values, [u, v]))
    }

    /// The same, of sizes that agree.
    pub(crate) fn of(
        parameters: Vec<[f64; 2]>,
        weights: Vec<f64>,
        values: Matrix,
        [u, v]: [Matrix; 2],
    ) -> Self {
        Self { parameters, weights, values, u, v }
    }
}

/// The columns wanted.
fn select(table: &Matrix, wanted: &[usize]) -> Matrix {
    Matrix::from_fn(table.rows(), wanted.len(), |p, k| table[(p, wanted[k])])
}

fn chosen(wanted: &[bool]) -> Vec<usize> {
    (0..wanted.len()).filter(|&k| wanted[k]).collect()
}

/// Rows of `table` times numbers.
fn weighted(table: &Matrix, factor: impl Fn(usize) -> f64) -> Matrix {
    Matrix::from_fn(table.rows(), table.cols(), |p, k| factor(p) * table[(p, k)])
}

impl Cell for SampledCell {
    fn nodes(&self) -> usize {
        self.u.cols()
    }

    fn weights(&self) -> &[f64] {
        &self.weights
    }

    fn parameters(&self) -> Vec<[f64; 2]> {
        self.parameters.clone()
    }

    fn tangents(&self, x: &[Point]) -> Vec<[Point; 2]> {
        let sum = |row: &[f64]| x.iter().zip(row).fold(Point::ZERO, |sum, (&x, &b)| sum + x * b);
        (0..self.weights.len()).map(|p| [sum(self.u.row(p)), sum(self.v.row(p))]).collect()
    }

    fn adjoint(&self, pairs: &[[Point; 2]]) -> Vec<Point> {
        let mut sums = vec![Point::ZERO; self.nodes()];
        for (p, &[by_u, by_v]) in pairs.iter().enumerate() {
            for (sum, (du, dv)) in sums.iter_mut().zip(self.u.row(p).iter().zip(self.v.row(p))) {
                *sum += by_u * *du + by_v * *dv;
            }
        }
        sums
    }

    fn stiffness(&self, wanted: &[bool], forms: &[[f64; 3]]) -> Matrix {
        let wanted = chosen(wanted);
        let (u, v) = (select(&self.u, &wanted), select(&self.v, &wanted));
        // (∂u, ∂v) form (∂u, ∂v)ᵀ = ∂uᵀ (f₀ ∂u + f₁ ∂v) + ∂vᵀ (f₁ ∂u + f₂ ∂v): two products in place of four.
        let mix = |a: usize, b: usize| {
            Matrix::from_fn(u.rows(), u.cols(), |p, k| forms[p][a] * u[(p, k)] + forms[p][b] * v[(p, k)])
        };
        let mut sum = Matrix::zeros(wanted.len(), wanted.len());
        add_upper_product(&mut sum, &u, &mix(0, 1));
        add_upper_product(&mut sum, &v, &mix(1, 2));
        mirrored(sum)
    }

    fn mass(&self, wanted: &[bool], factors: &[f64]) -> Matrix {
        let values = select(&self.values, &chosen(wanted));
        let mut sum = Matrix::zeros(values.cols(), values.cols());
        add_upper_product(&mut sum, &values, &weighted(&values, |p| factors[p]));
        mirrored(sum)
    }

    fn hessian_into(
        &self,
        freedoms: &[Freedom],
        tangents: &[[Point; 2]],
        hessian: &mut Matrix,
    ) -> Result<(), EnergyError> {
        let of_node = |(node, freedom): (usize, &Freedom)| {
            freedom.directions().iter().map(move |&d| (node, d)).collect::<Vec<_>>()
        };
        // Node after node, its directions one after the other: the order of rows and columns.
        let unknowns: Vec<(usize, Point)> = freedoms.iter().enumerate().flat_map(of_node).collect();
        let moving = chosen(&freedoms.iter().map(|f| *f != Freedom::Fixed).collect::<Vec<_>>());
        // The Hessian is kept from step to step: memory is asked for once.
        if (hessian.rows(), hessian.cols()) != (unknowns.len(), unknowns.len()) {
            *hessian = Matrix::zeros(unknowns.len(), unknowns.len());
        }
        hessian.as_mut_slice().fill(0.0);
        // The skew part depends on nodes alone, not on directions: it is summed over N² nodes and then spread over (3N)².
        let mut skew = vec![0.0; AXES * moving.len() * moving.len()];
        for first in (0..tangents.len()).step_by(BATCH) {
            let batch = first..(first + BATCH).min(tangents.len());
            self.add_batch(batch, tangents, &unknowns, &moving, [hessian.as_mut_slice(), &mut skew])?;
        }
        add_skew(hessian, &unknowns, freedoms, &skew);
        mirror(hessian);
        Ok(())
    }
}

/// Points whose share of a Hessian is summed at once: their factors stay in near memory.
const BATCH: usize = 128;

/// Coordinates of a point.
const AXES: usize = 3;

impl SampledCell {
    /// Adds what points give to a Hessian and to its skew part `S_kl = Σ_p N_p ∂uψ_k ∂vψ_l`, nodes × (coordinate, nodes).
    fn add_batch(
        &self,
        batch: std::ops::Range<usize>,
        tangents: &[[Point; 2]],
        unknowns: &[(usize, Point)],
        moving: &[usize],
        [hessian, skew]: [&mut [f64]; 2],
    ) -> Result<(), EnergyError> {
        let count = batch.len();
        // a'' = G ᵀG + N · (φ_u × ψ_v + ψ_u × φ_v), G the two tangential components of δ(x_u × x_v) over √a.
        // GᵀG is positive semidefinite: all that is indefinite in the area comes from the second part.
        let (mut left, mut right) =
            (Left::new(2 * count, unknowns.len()), Right::new(2 * count, unknowns.len()));
        let (mut by_u, mut by_v) = (Left::new(count, moving.len()), Right::new(count, AXES * moving.len()));
        for (at, p) in batch.enumerate() {
            let ([x_u, x_v], w) = (tangents[p], self.weights[p]);
            let (density, _, _) = Density::slope(x_u, x_v).ok_or_else(|| self.singular(p))?;
            // Any frame of the tangent plane gives the same GᵀG: x_u, turned by a right angle about the normal.
            let frame = x_u.cross(x_v).unit().zip(x_u.unit());
            let Some((normal, first)) = frame else { return Err(self.singular(p)) };
            let root = (w / density).sqrt();
            let (f_u, f_v) = (self.u.row(p), self.v.row(p));
            for (t, tangent) in [first, normal.cross(first)].into_iter().enumerate() {
                // (d × x_v) · t = d · (x_v × t), (x_u × d) · t = d · (t × x_u).
                let (of_u, of_v) = (x_v.cross(tangent) * root, tangent.cross(x_u) * root);
                let slope = |&(node, d): &(usize, Point)| of_u.dot(d) * f_u[node] + of_v.dot(d) * f_v[node];
                let slopes: Vec<f64> = unknowns.iter().map(slope).collect();
                left.set_point(2 * at + t, &slopes);
                right.set_point(2 * at + t, &slopes);
            }
            let of_u: Vec<f64> = moving.iter().map(|&node| f_u[node]).collect();
            by_u.set_point(at, &of_u);
            // The normal is weighted on one side only, as it enters once.
            let weighted = <[f64; 3]>::from(normal * w);
            let of_v: Vec<f64> =
                weighted.iter().flat_map(|n| moving.iter().map(move |&node| n * f_v[node])).collect();
            by_v.set_point(at, &of_v);
        }
        add_panels(&left, &right, hessian, true);
        add_panels(&by_u, &by_v, skew, false);
        Ok(())
    }
}

/// Adds `(d × e) · (S_kl − S_lk)` above the diagonal.
fn add_skew(hessian: &mut Matrix, unknowns: &[(usize, Point)], freedoms: &[Freedom], skew: &[f64]) {
    let (place, count) = numbered(freedoms.iter().map(|f| usize::from(*f != Freedom::Fixed)));
    let at = |k: usize, l: usize, c: usize| skew[(k * AXES + c) * count + l];
    for (a, &(k, d)) in unknowns.iter().enumerate() {
        let row = &mut hessian.row_mut(a)[a..];
        for (entry, &(l, e)) in row.iter_mut().zip(&unknowns[a..]) {
            let (k, l) = (place[k], place[l]);
            let s = |c: usize| at(k, l, c) - at(l, k, c);
            *entry += d.cross(e).dot(Point::new(s(0), s(1), s(2)));
        }
    }
}
