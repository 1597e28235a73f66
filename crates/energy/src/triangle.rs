//! Quadratic energies of triangular Bézier patches.
//!
//! Every derivative of order r of a patch of degree n is a Bernstein polynomial of degree n − r whose coefficients are
//! differences of the net, and products of Bernstein polynomials integrate in closed form. This assembles TRI Prop. 2
//! (Dirichlet) and COONS Prop. 2 (Coons functional), and the two energies that the papers leave out.

use bases::Matrix;
use surfaces::TriangleBasis;

use crate::product::add_product;
use crate::tangent::Collapsed;
use crate::{DenseForm, DensityTerm, EnergyError, Functional, ReferenceTriangle};

impl DenseForm {
    /// The form of `functional` for triangular Bézier patches of degree `degree`, in closed form: entries within 4u of
    /// the largest (u = 2⁻⁵³). O(n⁴) operations, about a millisecond at degree 20.
    ///
    /// Q is (n+1)(n+2)/2 squared, positive semidefinite, and positive definite on the interior points. Its condition there
    /// grows like 4ⁿ (Dirichlet 1.6e4 at degree 10, 1.4e10 at 20; Coons 1e5 and 3e11), but the surface is
    /// better determined than its net: a harmonic cubic raised to degree 20 is found again to 1e-11.
    ///
    /// ```
    /// use energy::{DenseForm, Functional};
    /// use surfaces::{Point, TriangleNet};
    /// // Half the unit square has area, and Dirichlet energy, ½.
    /// let [a, b, c] = [[1., 0., 0.], [0., 1., 0.], [0., 0., 0.]].map(Point::from);
    /// let net = TriangleNet::from_boundary(&[a, b], &[b, c], &[c, a])?;
    /// let dirichlet = DenseForm::of_triangle(Functional::Dirichlet, 1)?;
    /// assert_eq!(dirichlet.value(&net.coordinates()), 0.5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`EnergyError::Basis`] for a degree above 64.
    pub fn of_triangle(functional: Functional, degree: usize) -> Result<Self, EnergyError> {
        Self::of_triangle_over(ReferenceTriangle::Right, functional, degree)
    }

    /// As [`Self::of_triangle`], with the derivatives taken over `reference`. Over the equilateral triangle the form does not change
    /// when the corners of a net are permuted.
    ///
    /// # Errors
    /// [`EnergyError::Basis`] for a degree above 64.
    pub fn of_triangle_over(
        reference: ReferenceTriangle,
        functional: Functional,
        degree: usize,
    ) -> Result<Self, EnergyError> {
        let terms = reference.terms(functional);
        let basis = TriangleBasis::new(degree)?;
        let mut half = Matrix::zeros(basis.count(), basis.count());
        let order = total_order(terms);
        if order > degree {
            return Self::new(half);
        }
        // The density is xᵀ local x with x the points around a multi-index J of degree n − r, at J + offset.
        let offsets: Vec<[usize; 3]> = TriangleBasis::new(order)?.indices().collect();
        let local = local_form(terms, degree, &offsets);
        let level = degree - order;
        let lower: Vec<[usize; 3]> = TriangleBasis::new(level)?.indices().collect();
        let around: Vec<Vec<usize>> = lower
            .iter()
            .map(|[i, j, _]| offsets.iter().map(|[a, b, _]| basis.position(i + a, j + b)).collect())
            .collect();
        let choose = Choose::new(level);
        for (p, &left) in lower.iter().enumerate() {
            for (q, &right) in lower.iter().enumerate().skip(p) {
                // Each pair J ≠ K once: the transposed half is added by the symmetric part.
                let weight = choose.integral(left, right) * if p == q { 1.0 } else { 2.0 };
                for (a, &row) in around[p].iter().enumerate() {
                    for (b, &column) in around[q].iter().enumerate() {
                        half[(row, column)] += weight * local[(a, b)];
                    }
                }
            }
        }
        Self::new(half)
    }

    /// The same form as [`Self::of_triangle`] by a Gauss rule of the square collapsed onto the triangle, exact for these
    /// integrands: the second way to the same entries, O(n⁶).
    ///
    /// # Errors
    /// [`EnergyError::Basis`] for a degree above 64.
    pub fn of_triangle_by_quadrature(functional: Functional, degree: usize) -> Result<Self, EnergyError> {
        let basis = TriangleBasis::new(degree)?;
        let mut matrix = Matrix::zeros(basis.count(), basis.count());
        for line in Collapsed::new(degree + 1)?.lines() {
            let tables: Vec<Matrix> = line.iter().map(|&(u, v, _)| basis.evaluate(u, v, 2)).collect();
            let sampled = |[u, v]: [usize; 2], factor: &dyn Fn(usize) -> f64| {
                // Rows of the table: 1 | u v | uu uv vv.
                let row = (u + v) * (u + v + 1) / 2 + v;
                Matrix::from_fn(line.len(), basis.count(), |p, k| factor(p) * tables[p][(row, k)])
            };
            for DensityTerm { coefficient, u, v } in functional.terms() {
                let left = sampled([u.0, v.0], &|_| 1.0);
                let right = sampled([u.1, v.1], &|p| coefficient * line[p].2);
                add_product(&mut matrix, &left, &right);
            }
        }
        Self::new(matrix)
    }
}

/// The number of derivatives in each factor of the density, the same for all its terms.
fn total_order(terms: &[DensityTerm]) -> usize {
    terms.iter().map(|term| term.u.0 + term.v.0).max().unwrap_or(0)
}

/// The density as a form of the points at J + offset: `Σ coefficient · (difference) (difference)ᵀ · (n!/(n−r)!)²`.
fn local_form(terms: &[DensityTerm], degree: usize, offsets: &[[usize; 3]]) -> Matrix {
    let order = total_order(terms);
    let factor: f64 = (0..order).map(|s| (degree - s) as f64).product();
    // ∂u is E1 − E3 and ∂v is E2 − E3, with E_s the step in index s: the coefficient at each offset.
    let difference = |u: usize, v: usize| -> Vec<f64> {
        let signed = |k: usize, of: usize| {
            let choose: f64 = (0..k).map(|s| (of - s) as f64 / (s + 1) as f64).product();
            if (of - k).is_multiple_of(2) { choose } else { -choose }
        };
        offsets
            .iter()
            .map(|&[a, b, _]| if a <= u && b <= v { signed(a, u) * signed(b, v) } else { 0.0 })
            .collect()
    };
    let mut local = Matrix::zeros(offsets.len(), offsets.len());
    for DensityTerm { coefficient, u, v } in terms {
        let (left, right) = (difference(u.0, v.0), difference(u.1, v.1));
        for a in 0..offsets.len() {
            for b in 0..offsets.len() {
                local[(a, b)] += coefficient * factor * factor * left[a] * right[b];
            }
        }
    }
    local
}

/// Binomials C(a + b, a) for a, b ≤ N, and the integrals of products of Bernstein polynomials of degree N.
struct Choose {
    table: Matrix,
    /// `1 / (C(2N, N) (2N + 1) (2N + 2))`.
    scale: f64,
}

impl Choose {
    fn new(level: usize) -> Self {
        // Exact in 128 bits up to C(128, 64) ≈ 2.4e37.
        let mut exact = vec![1u128; (level + 1) * (level + 1)];
        for a in 1..=level {
            for b in 1..=level {
                exact[a * (level + 1) + b] =
                    exact[(a - 1) * (level + 1) + b] + exact[a * (level + 1) + b - 1];
            }
        }
        let table = Matrix::from_fn(level + 1, level + 1, |a, b| exact[a * (level + 1) + b] as f64);
        let scale = 1.0 / (table[(level, level)] * ((2 * level + 1) * (2 * level + 2)) as f64);
        Self { table, scale }
    }

    /// `∫_T B^N_J B^N_K = C(j1+k1, j1) C(j2+k2, j2) C(j3+k3, j3) / (C(2N, N) (2N+1)(2N+2))`.
    fn integral(&self, left: [usize; 3], right: [usize; 3]) -> f64 {
        let c = |s: usize| self.table[(left[s], right[s])];
        c(0) * c(1) * (c(2) * self.scale)
    }
}
