//! The area over products of functions of one variable, by sum factorisation.

use bases::{Matrix, Samples};
use surfaces::{Patch, Point, TensorPatch};

use crate::area_hessian::Density;
use crate::product::add_product;
use crate::{EnergyError, TangentSamples};

/// The area of `x + Σ_ij c_ij s_ij f_i(u) g_j(v)` as a function of the vectors c_ij ∈ ℝ³, by a product Gauss rule: value,
/// gradient and Hessian.
///
/// f_i = Σ_k φ_k map_u[k, i] for the functions φ of a family that vanish at both ends, g_j likewise, s_ij any factors. The
/// c_ij are laid out one after the other, j running faster. For m × n functions and q² points a Hessian costs
/// O(q m² n²): the sum over v is formed once for every line of constant u, where the sum over all points
/// ([`AreaExpansion`](crate::AreaExpansion)) would cost O(q² m² n²).
#[derive(Debug, Clone)]
pub struct ProductArea {
    u: Line,
    v: Line,
    scale: Vec<f64>,
    base: Vec<[Point; 2]>,
    /// `f_i^(r) f_k^(s)` for i ≥ k: row (point, rs), column (i, k).
    pairs: Matrix,
}

/// Functions of one variable at the points of a rule: points × functions.
#[derive(Debug, Clone)]
struct Line {
    nodes: Vec<f64>,
    weights: Vec<f64>,
    values: Matrix,
    derivatives: Matrix,
}

impl Line {
    fn new(samples: &Samples, map: &Matrix) -> Self {
        let inner = |order: usize| {
            let all = samples.order(order);
            // The first and the last function do not vanish at the ends: they carry the rim, which stays.
            Matrix::from_fn(all.rows(), all.cols() - 2, |p, k| all[(p, k + 1)]).times(map)
        };
        Self {
            nodes: samples.nodes().to_vec(),
            weights: samples.weights().to_vec(),
            values: inner(0),
            derivatives: inner(1),
        }
    }

    fn points(&self) -> usize {
        self.nodes.len()
    }

    fn functions(&self) -> usize {
        self.values.cols()
    }
}

impl ProductArea {
    /// The area around `patch`, a patch of one product of families, at the rule of `points`² points. `map_u` has a row for
    /// each row of the net but the first and the last, `map_v` for each such column; `scale` is s_ij, j running faster.
    ///
    /// # Errors
    /// [`EnergyError::Shape`] if the sizes do not agree or the patch is a sum of products, [`EnergyError::Basis`] for a
    /// rule that is not offered.
    pub fn new(
        patch: &TensorPatch,
        map_u: &Matrix,
        map_v: &Matrix,
        scale: &[f64],
        points: usize,
    ) -> Result<Self, EnergyError> {
        let (m, n) = patch.net().degrees();
        for (what, expected, found) in [
            ("products of a patch with separated variables", 1, patch.products().len()),
            ("rows of the map of functions of u", m - 1, map_u.rows()),
            ("rows of the map of functions of v", n - 1, map_v.rows()),
            ("factors of products", map_u.cols() * map_v.cols(), scale.len()),
        ] {
            if expected != found {
                return Err(EnergyError::Shape { what, expected, found });
            }
        }
        let product = &patch.products()[0];
        let u = Line::new(&Samples::new(product.u.as_ref(), points, 1)?, map_u);
        let v = Line::new(&Samples::new(product.v.as_ref(), points, 1)?, map_v);
        let base = patch.jets(&u.nodes, &v.nodes).into_iter().map(|jet| [jet.u, jet.v]).collect();
        let columns: Vec<(usize, usize)> =
            (0..u.functions()).flat_map(|i| (0..=i).map(move |k| (i, k))).collect();
        // Row 4 a + rs: r is the derivative of the first function in rows 0 and 1, s that of the second in rows 0 and 2.
        let pairs = Matrix::from_fn(4 * points, columns.len(), |row, pair| {
            let (a, (i, k)) = (row / 4, columns[pair]);
            let of = |derivative: bool| if derivative { &u.derivatives } else { &u.values };
            of(row % 4 < 2)[(a, i)] * of(row % 2 == 0)[(a, k)]
        });
        Ok(Self { u, v, scale: scale.to_vec(), base, pairs })
    }

    /// Number of unknowns, 3 m n.
    pub fn unknowns(&self) -> usize {
        3 * self.scale.len()
    }

    /// The area at `c`; fills `gradient`.
    ///
    /// # Errors
    /// [`EnergyError::Singular`] where x_u and x_v are parallel at a point of the rule.
    ///
    /// # Panics
    /// If `c` or `gradient` does not hold 3 m n numbers.
    #[track_caller]
    pub fn value_and_gradient(&self, c: &[f64], gradient: &mut [f64]) -> Result<f64, EnergyError> {
        assert_eq!(gradient.len(), self.unknowns(), "length of a gradient");
        let tangents = self.tangents(c);
        let (q, m, n) = (self.v.points(), self.u.functions(), self.v.functions());
        let mut area = 0.0;
        let mut sums = vec![Point::ZERO; m * n];
        for (a, line) in tangents.chunks_exact(q).enumerate() {
            let (mut along_u, mut along_v) = (vec![Point::ZERO; n], vec![Point::ZERO; n]);
            let mut part = 0.0;
            for (b, &[x_u, x_v]) in line.iter().enumerate() {
                let (value, by_u, by_v) = Density::slope(x_u, x_v).ok_or(self.singular(a, b))?;
                let w = self.v.weights[b];
                part += w * value;
                for (j, (g, dg)) in self.v.values.row(b).iter().zip(self.v.derivatives.row(b)).enumerate() {
                    along_u[j] += by_u * (w * g);
                    along_v[j] += by_v * (w * dg);
                }
            }
            let w = self.u.weights[a];
            area += w * part;
            for (i, (f, df)) in self.u.values.row(a).iter().zip(self.u.derivatives.row(a)).enumerate() {
                for j in 0..n {
                    sums[i * n + j] += along_u[j] * (w * df) + along_v[j] * (w * f);
                }
            }
        }
        // s_ij multiplies the function, so it multiplies both its displacement (in `tangents`) and its slope here.
        for ((out, sum), s) in gradient.chunks_exact_mut(3).zip(sums).zip(&self.scale) {
            out.copy_from_slice(&<[f64; 3]>::from(sum * *s));
        }
        Ok(area)
    }

    /// Fills `hessian`, (3 m n)², with the second derivatives of the area at `c`: symmetric bit for bit.
    ///
    /// # Errors
    /// As [`Self::value_and_gradient`].
    ///
    /// # Panics
    /// If `c` does not hold 3 m n numbers or `hessian` the square of that.
    #[track_caller]
    pub fn hessian(&self, c: &[f64], hessian: &mut [f64]) -> Result<(), EnergyError> {
        let (m, n, size) = (self.u.functions(), self.v.functions(), self.unknowns());
        assert_eq!(hessian.len(), size * size, "length of a Hessian");
        if size == 0 {
            return Ok(());
        }
        let lines = self.lines(&self.tangents(c))?;
        // Block (i, k) = Σ_a Σ_rs f_i^(r) f_k^(s) lines[a, rs], for i ≥ k.
        let mut blocks = Matrix::zeros(self.pairs.cols(), 9 * n * n);
        // This product is where the time goes: pairs times lines, O(q m² n²).
        add_product(&mut blocks, &self.pairs, &lines);
        for (pair, (i, k)) in (0..m).flat_map(|i| (0..=i).map(move |k| (i, k))).enumerate() {
            let block = blocks.row(pair);
            for alpha in 0..3 {
                for j in 0..n {
                    let row = 3 * (i * n + j) + alpha;
                    let entries = &block[(alpha * n + j) * 3 * n..][..3 * n];
                    for beta in 0..3 {
                        for l in 0..n {
                            let column = 3 * (k * n + l) + beta;
                            let entry =
                                entries[beta * n + l] * (self.scale[i * n + j] * self.scale[k * n + l]);
                            // Blocks with i = k hold both halves: only the lower one is taken, so that the matrix is symmetric bit for bit.
                            if column <= row {
                                hessian[row * size + column] = entry;
                                hessian[column * size + row] = entry;
                            }
                        }
                    }
                }
            }
        }
        Ok(())
    }

    /// Row (a, rs): `Σ_b w h^(rs)_αβ g_j^(r) g_l^(s)` at column (α, j, β, l), with r, s the derivative, by u or by v, and
    /// h the second derivatives of the density; g^(u) = g and g^(v) = g'.
    fn lines(&self, tangents: &[[Point; 2]]) -> Result<Matrix, EnergyError> {
        let (q, n) = (self.v.points(), self.v.functions());
        let mut lines = Matrix::zeros(4 * self.u.points(), 9 * n * n);
        let symmetric: [(usize, usize); 6] = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)];
        let full: [(usize, usize); 9] = std::array::from_fn(|k| (k / 3, k % 3));
        for (a, line) in tangents.chunks_exact(q).enumerate() {
            // Columns of of_u: six symmetric components of h_uu with g_l, then nine of h_uv with g'_l; of of_v: six of h_vv with g'_l.
            let mut of_u = Matrix::zeros(q, 15 * n);
            let mut of_v = Matrix::zeros(q, 6 * n);
            for (b, &[x_u, x_v]) in line.iter().enumerate() {
                let density = Density::new(x_u, x_v).ok_or(self.singular(a, b))?;
                let w = self.u.weights[a] * self.v.weights[b];
                let (g, dg) = (self.v.values.row(b), self.v.derivatives.row(b));
                let fill = |out: &mut [f64], h: f64, g: &[f64]| {
                    out.iter_mut().zip(g).for_each(|(out, g)| *out = w * h * g);
                };
                for (at, out) in of_u.row_mut(b).chunks_exact_mut(n).enumerate() {
                    match at.checked_sub(6) {
                        None => fill(out, density.hessian[symmetric[at].0][symmetric[at].1], g),
                        Some(at) => fill(out, density.hessian[full[at].0][3 + full[at].1], dg),
                    }
                }
                for ((alpha, beta), out) in symmetric.into_iter().zip(of_v.row_mut(b).chunks_exact_mut(n)) {
                    fill(out, density.hessian[3 + alpha][3 + beta], dg);
                }
            }
            // g of the first function for rows uu and uv, g' for vv; vu is the transpose of uv and costs nothing.
            let (mut by_u, mut by_v) = (Matrix::zeros(n, 15 * n), Matrix::zeros(n, 6 * n));
            add_product(&mut by_u, &self.v.values, &of_u);
            add_product(&mut by_v, &self.v.derivatives, &of_v);
            let place =
                |alpha: usize, j: usize, beta: usize, l: usize| (alpha * n + j) * 3 * n + beta * n + l;
            for j in 0..n {
                for l in 0..n {
                    for (at, (alpha, beta)) in symmetric.into_iter().enumerate() {
                        // Equal coordinates: symmetric in (j, l); others: block (β, α) is the transpose of (α, β).
                        for (row, sum) in [(0, by_u[(j, at * n + l)]), (3, by_v[(j, at * n + l)])] {
                            lines[(4 * a + row, place(alpha, j, beta, l))] = sum;
                            lines[(4 * a + row, place(beta, l, alpha, j))] = sum;
                        }
                    }
                    for (at, (alpha, beta)) in full.into_iter().enumerate() {
                        let sum = by_u[(j, (6 + at) * n + l)];
                        lines[(4 * a + 1, place(alpha, j, beta, l))] = sum;
                        lines[(4 * a + 2, place(beta, l, alpha, j))] = sum;
                    }
                }
            }
        }
        Ok(lines)
    }

    /// The tangents at `c`, lines of constant u one after the other.
    fn tangents(&self, c: &[f64]) -> Vec<[Point; 2]> {
        assert_eq!(c.len(), self.unknowns(), "length of the coefficients");
        let (q, n) = (self.v.points(), self.v.functions());
        let coefficients: Vec<Point> =
            c.chunks_exact(3).zip(&self.scale).map(|(c, s)| Point::new(c[0], c[1], c[2]) * *s).collect();
        let mut tangents = self.base.clone();
        for (a, line) in tangents.chunks_exact_mut(q).enumerate() {
            let (mut along_u, mut along_v) = (vec![Point::ZERO; n], vec![Point::ZERO; n]);
            for (i, (f, df)) in self.u.values.row(a).iter().zip(self.u.derivatives.row(a)).enumerate() {
                for (j, &c) in coefficients[i * n..(i + 1) * n].iter().enumerate() {
                    along_u[j] += c * *df;
                    along_v[j] += c * *f;
                }
            }
            for (b, [x_u, x_v]) in line.iter_mut().enumerate() {
                for (j, (g, dg)) in self.v.values.row(b).iter().zip(self.v.derivatives.row(b)).enumerate() {
                    *x_u += along_u[j] * *g;
                    *x_v += along_v[j] * *dg;
                }
            }
        }
        tangents
    }

    /// The coefficients of the projection of the patch around which this is the area, against the Dirichlet product:
    /// `∫ ∇x · ∇ψ_ij` for the functions ψ_ij = s_ij f_i g_j, 3 m n numbers. If these are orthonormal, minus that leads to the
    /// Dirichlet extremal.
    pub fn dirichlet_projection(&self) -> Vec<f64> {
        let (q, n) = (self.v.points(), self.v.functions());
        let mut sums = vec![Point::ZERO; self.scale.len()];
        for (a, line) in self.base.chunks_exact(q).enumerate() {
            let (mut along_u, mut along_v) = (vec![Point::ZERO; n], vec![Point::ZERO; n]);
            for (b, &[x_u, x_v]) in line.iter().enumerate() {
                let w = self.u.weights[a] * self.v.weights[b];
                for (j, (g, dg)) in self.v.values.row(b).iter().zip(self.v.derivatives.row(b)).enumerate() {
                    along_u[j] += x_u * (w * g);
                    along_v[j] += x_v * (w * dg);
                }
            }
            for (i, (f, df)) in self.u.values.row(a).iter().zip(self.u.derivatives.row(a)).enumerate() {
                for j in 0..n {
                    sums[i * n + j] += along_u[j] * *df + along_v[j] * *f;
                }
            }
        }
        sums.into_iter().zip(&self.scale).flat_map(|(sum, s)| <[f64; 3]>::from(sum * *s)).collect()
    }

    /// The functions ψ_ij = s_ij f_i g_j at the points of the rule: derivatives, and values (points × functions).
    ///
    /// # Errors
    /// [`EnergyError::Shape`] never in fact.
    pub fn samples(&self) -> Result<(TangentSamples, Matrix), EnergyError> {
        let (q, n) = (self.v.points(), self.v.functions());
        let points = self.base.len();
        let table = |f: &Matrix, g: &Matrix| {
            Matrix::from_fn(points, self.scale.len(), |p, k| {
                self.scale[k] * f[(p / q, k / n)] * g[(p % q, k % n)]
            })
        };
        let (u, v) = (&self.u, &self.v);
        let parameters = (0..points).map(|p| [u.nodes[p / q], v.nodes[p % q]]).collect();
        let weights = (0..points).map(|p| u.weights[p / q] * v.weights[p % q]).collect();
        let by_u = table(&u.derivatives, &v.values);
        let samples = TangentSamples::new(parameters, weights, by_u, table(&u.values, &v.derivatives))?;
        Ok((samples, table(&u.values, &v.values)))
    }

    /// The nodes of the rule in u and in v.
    pub fn nodes(&self) -> [&[f64]; 2] {
        [&self.u.nodes, &self.v.nodes]
    }

    fn singular(&self, a: usize, b: usize) -> EnergyError {
        EnergyError::Singular { u: self.u.nodes[a], v: self.v.nodes[b] }
    }
}
