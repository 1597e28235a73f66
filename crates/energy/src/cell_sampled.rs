//! Cells of any functions, known by their samples.

use bases::Matrix;
use surfaces::Point;

use crate::EnergyError;
use crate::area_hessian::Density;
use crate::cell::{Cell, Freedom};
use crate::cell_product::numbered;
use crate::product::{add_product, add_upper_product, mirrored};

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
        Ok(Self { parameters, weights, values, u, v })
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

    fn hessian(&self, freedoms: &[Freedom], tangents: &[[Point; 2]]) -> Result<Matrix, EnergyError> {
        let points = self.weights.len();
        let unknowns: Vec<(usize, Point)> = freedoms
            .iter()
            .enumerate()
            .flat_map(|(node, freedom)| freedom.directions().iter().map(move |&d| (node, d)))
            .collect();
        // a'' = G ᵀG + N · (φ_u × ψ_v + ψ_u × φ_v), G the two tangential components of δ(x_u × x_v) over √a.
        let mut slopes = Matrix::zeros(2 * points, unknowns.len());
        let mut normals = Vec::with_capacity(points);
        for (p, (&[x_u, x_v], &w)) in tangents.iter().zip(&self.weights).enumerate() {
            let (density, _, _) = Density::slope(x_u, x_v).ok_or_else(|| self.singular(p))?;
            let frame = x_u.cross(x_v).unit().zip(x_u.unit());
            let Some((normal, first)) = frame else { return Err(self.singular(p)) };
            let root = (w / density).sqrt();
            for (t, tangent) in [first, normal.cross(first)].into_iter().enumerate() {
                // (d × x_v) · t = d · (x_v × t), (x_u × d) · t = d · (t × x_u).
                let (by_u, by_v) = (x_v.cross(tangent) * root, tangent.cross(x_u) * root);
                let row = slopes.row_mut(2 * p + t);
                for (out, &(node, d)) in row.iter_mut().zip(&unknowns) {
                    *out = by_u.dot(d) * self.u[(p, node)] + by_v.dot(d) * self.v[(p, node)];
                }
            }
            normals.push(normal * w);
        }
        let mut sum = Matrix::zeros(unknowns.len(), unknowns.len());
        add_upper_product(&mut sum, &slopes, &slopes);
        self.add_skew(&mut sum, &unknowns, freedoms, &normals);
        Ok(mirrored(sum))
    }
}

impl SampledCell {
    /// Adds `(d × e) · S_kl`, `S_kl = Σ_p N_p (∂uψ_k ∂vψ_l − ∂vψ_k ∂uψ_l)`, above the diagonal.
    fn add_skew(
        &self,
        sum: &mut Matrix,
        unknowns: &[(usize, Point)],
        freedoms: &[Freedom],
        normals: &[Point],
    ) {
        let moving: Vec<usize> = (0..freedoms.len()).filter(|&k| freedoms[k] != Freedom::Fixed).collect();
        let (place, _) = numbered(freedoms.iter().map(|f| usize::from(*f != Freedom::Fixed)));
        let (u, v) = (select(&self.u, &moving), select(&self.v, &moving));
        let skew = [0, 1, 2].map(|c| {
            let mut sum = Matrix::zeros(moving.len(), moving.len());
            add_product(&mut sum, &u, &weighted(&v, |p| <[f64; 3]>::from(normals[p])[c]));
            sum
        });
        for (a, &(k, d)) in unknowns.iter().enumerate() {
            for (b, &(l, e)) in unknowns.iter().enumerate().skip(a) {
                let (k, l) = (place[k], place[l]);
                let s = |c: usize| skew[c][(k, l)] - skew[c][(l, k)];
                sum[(a, b)] += d.cross(e).dot(Point::new(s(0), s(1), s(2)));
            }
        }
    }
}
