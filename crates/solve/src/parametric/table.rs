use super::{ParametricProblem, PolynomialMatrix};
use crate::memory::{filled, zeros};
use crate::{Place, SolveError, check};

/// Number of monomials 1, θ₁, θ₂, θ₁², θ₁θ₂, θ₂².
pub(super) const MONOMIALS: usize = 6;

/// Number of products of a monomial in α and one in β.
pub(super) const PRODUCTS: usize = MONOMIALS * MONOMIALS;

/// Largest number of free unknowns: beyond it a Gram matrix is singular in doubles anyway.
const LARGEST_FREE: usize = 400;

/// A parametric system with the fixed values contracted away: what an evaluation reads, and no more.
///
/// - `left`, `right`: the different entries ("slots") of the free blocks of the univariate matrices, six
///   coefficients each; a left slot carries the factor of its term.
/// - `assembly`: for each entry of the lower triangle of `Q_ff`, row by row, one pair of slots a term.
/// - `bilinear`: for each entry of b (3 a free unknown) and for c, last, a 6 × 6 table B of xᵀ B y, in blocks
///   of entries that are summed side by side: block, product, entry. `by_entry`: the same, entry, product.
#[derive(Debug, Clone)]
pub(super) struct Tables {
    pub(super) free: usize,
    pub(super) terms: usize,
    pub(super) left: Vec<[f64; MONOMIALS]>,
    pub(super) right: Vec<[f64; MONOMIALS]>,
    pub(super) assembly: Vec<[u32; 2]>,
    pub(super) bilinear: Vec<f64>,
    pub(super) by_entry: Vec<[f64; PRODUCTS]>,
    /// A pivot up to this part of its diagonal entry is rounding noise.
    pub(super) pivot_bound: f64,
}

impl Tables {
    pub(super) fn new(problem: &ParametricProblem) -> Result<Self, SolveError> {
        let (rows, cols) = validated(problem)?;
        let (free_rows, free_cols) = (&problem.free_left, &problem.free_right);
        let free = free_rows.len() * free_cols.len();
        check::limit("number of free unknowns", free, LARGEST_FREE)?;

        let mut left = Slots::default();
        let mut right = Slots::default();
        // Of N free unknowns N (N + 1)/2 entries, a pair of slots for each term: the one array that grows with N².
        let mut assembly = Vec::new();
        let pairs = free * (free + 1) / 2;
        assembly.try_reserve_exact(pairs * problem.terms.len()).map_err(|_| SolveError::OutOfMemory {
            bytes: pairs * problem.terms.len() * size_of::<[u32; 2]>(),
        })?;
        let left_slots: Vec<Vec<u32>> = problem
            .terms
            .iter()
            .map(|t| left.of_block(t.left, t.coefficient, &problem.left[t.left], free_rows))
            .collect();
        let right_slots: Vec<Vec<u32>> = problem
            .terms
            .iter()
            .map(|t| right.of_block(t.right, 1.0, &problem.right[t.right], free_cols))
            .collect();
        let (m, n) = (free_rows.len(), free_cols.len());
        for a in 0..free {
            for b in 0..=a {
                for t in 0..problem.terms.len() {
                    assembly.push([left_slots[t][a / n * m + b / n], right_slots[t][a % n * n + b % n]]);
                }
            }
        }

        let by_entry = contracted(problem, rows, cols)?;
        let mut bilinear = zeros(by_entry.len() * PRODUCTS)?;
        for (start, size) in blocks(by_entry.len()) {
            for product in 0..PRODUCTS {
                for k in 0..size {
                    bilinear[start * PRODUCTS + product * size + k] = by_entry[start + k][product];
                }
            }
        }
        let (left, right) = (left.coefficients, right.coefficients);
        let tables = Self {
            free,
            terms: problem.terms.len(),
            left,
            right,
            assembly,
            bilinear,
            by_entry,
            // An entry is a sum of at most N products: its rounding against its diagonal entry is about N ε.
            pivot_bound: 4.0 * free as f64 * f64::EPSILON,
        };
        Ok(tables)
    }

    /// `Q_ff` (row-major) and b, c at a point, by plain sums.
    pub(super) fn at(&self, point: &[f64; 4]) -> (Vec<f64>, Vec<f64>, f64) {
        let (x, y) = (monomials(point[0], point[1]), monomials(point[2], point[3]));
        let dot =
            |a: &[f64; MONOMIALS], b: &[f64; MONOMIALS]| (0..MONOMIALS).map(|m| a[m] * b[m]).sum::<f64>();
        let left: Vec<f64> = self.left.iter().map(|s| dot(s, &x)).collect();
        let right: Vec<f64> = self.right.iter().map(|s| dot(s, &y)).collect();
        let mut matrix = vec![0.0; self.free * self.free];
        let mut entries = self.assembly.chunks_exact(self.terms.max(1));
        for a in 0..self.free {
            for b in 0..=a {
                let slots = entries.next().unwrap_or(&[]);
                let sum = slots.iter().map(|[l, r]| left[*l as usize] * right[*r as usize]).sum();
                (matrix[a * self.free + b], matrix[b * self.free + a]) = (sum, sum);
            }
        }
        let mut b: Vec<f64> = self
            .by_entry
            .iter()
            .map(|table| (0..PRODUCTS).map(|k| x[k / MONOMIALS] * y[k % MONOMIALS] * table[k]).sum())
            .collect();
        let c = b.pop().expect("the table of c stands behind those of b");
        (matrix, b, c)
    }
}

/// Entries of the bilinear tables that are summed side by side: enough of them to hide the latency of an
/// addition, few enough to stay in registers. All of four, but the rest of one is joined to a four.
pub(super) fn blocks(entries: usize) -> impl Iterator<Item = (usize, usize)> {
    let mut start = 0;
    std::iter::from_fn(move || {
        let rest = entries - start;
        let size = if rest == 5 { 5 } else { rest.min(4) };
        let block = (start, size);
        start += size;
        (size > 0).then_some(block)
    })
}

pub(super) fn monomials(a: f64, b: f64) -> [f64; MONOMIALS] {
    [1.0, a, b, a * a, a * b, b * b]
}

/// The different polynomials among the entries of blocks, numbered as they are met.
#[derive(Default)]
struct Slots {
    coefficients: Vec<[f64; MONOMIALS]>,
    known: Vec<(usize, f64, Vec<u32>)>,
}

impl Slots {
    /// The slot of each entry of `factor · matrix[free × free]`, row-major; equal mirror images share one.
    fn of_block(&mut self, index: usize, factor: f64, matrix: &PolynomialMatrix, free: &[usize]) -> Vec<u32> {
        // A matrix used by several terms with the same factor is tabulated once.
        if let Some((.., slots)) = self.known.iter().find(|(i, f, _)| (*i, *f) == (index, factor)) {
            return slots.clone();
        }
        let entry = |i: usize, j: usize| -> [f64; MONOMIALS] {
            std::array::from_fn(|m| factor * matrix.coefficients[m][free[i] * matrix.cols + free[j]])
        };
        let n = free.len();
        let mut slots = vec![0; n * n];
        for i in 0..n {
            for j in 0..=i {
                // (i, j) below the diagonal first: its mirror image above, looked at next, can then share the slot.
                for (i, j) in [(i, j), (j, i)] {
                    slots[i * n + j] = if i < j && entry(i, j) == entry(j, i) {
                        slots[j * n + i]
                    } else {
                        self.coefficients.push(entry(i, j));
                        self.coefficients.len() as u32 - 1
                    };
                    if i == j {
                        break;
                    }
                }
            }
        }
        self.known.push((index, factor, slots.clone()));
        slots
    }
}

/// The 6 × 6 tables of the entries of b, then of c.
///
/// With V = Q P_b (P_b zero at free unknowns), b are the free rows of V and c = P_bᵀ V; each is contracted for
/// every pair of monomials, along the columns of the net first.
fn contracted(
    problem: &ParametricProblem,
    rows: usize,
    cols: usize,
) -> Result<Vec<[f64; PRODUCTS]>, SolveError> {
    // Free points count as 0, whatever stands there: NaN is allowed.
    let (free_rows, free_cols) = (&problem.free_left, &problem.free_right);
    let mut fixed = crate::memory::copy(&problem.values)?;
    for &i in free_rows {
        for &j in free_cols {
            fixed[3 * (i * cols + j)..3 * (i * cols + j) + 3].fill(0.0);
        }
    }
    let mut tables = filled(3 * free_rows.len() * free_cols.len() + 1, [0.0; PRODUCTS])?;
    let mut along = zeros(3 * rows * cols)?;
    let mut across = zeros(3 * rows * cols)?;
    for term in &problem.terms {
        let (left, right) = (&problem.left[term.left], &problem.right[term.right]);
        // R is applied once for each of its monomials, then L for each of its own: six and six products in place of 36 pairs.
        for q in 0..MONOMIALS {
            along_rows(&right.coefficients[q], cols, &fixed, &mut along);
            for p in 0..MONOMIALS {
                down_columns(term.coefficient, &left.coefficients[p], (rows, cols), &along, &mut across);
                let product = p * MONOMIALS + q;
                let mut entry = 0;
                for &i in free_rows {
                    for &j in free_cols {
                        for d in 0..3 {
                            tables[entry][product] += across[3 * (i * cols + j) + d];
                            entry += 1;
                        }
                    }
                }
                // c = P_bᵀ V: at free points P_b is 0, so the sum over all of the net is right.
                tables[entry][product] += across.iter().zip(&fixed).map(|(v, x)| v * x).sum::<f64>();
            }
        }
    }
    for (row, table) in tables.iter().enumerate() {
        check::finite(Place::RightHandSide, PRODUCTS, table).map_err(|mut error| {
            if let SolveError::NotFinite { row: of_table, .. } = &mut error {
                *of_table = row;
            }
            error
        })?;
    }
    Ok(tables)
}

/// `along[k, j] = Σ_l R[j, l] P_b[k, l]`, R of order `cols`.
fn along_rows(r: &[f64], cols: usize, fixed: &[f64], along: &mut [f64]) {
    along.fill(0.0);
    for (along, fixed) in along.chunks_exact_mut(3 * cols).zip(fixed.chunks_exact(3 * cols)) {
        for j in 0..cols {
            for l in 0..cols {
                for d in 0..3 {
                    along[3 * j + d] += r[j * cols + l] * fixed[3 * l + d];
                }
            }
        }
    }
}

/// `across[i, j] = factor Σ_k L[i, k] along[k, j]`, L of order `rows`.
fn down_columns(factor: f64, l: &[f64], (rows, cols): (usize, usize), along: &[f64], across: &mut [f64]) {
    across.fill(0.0);
    for (i, across) in across.chunks_exact_mut(3 * cols).enumerate() {
        for (k, along) in along.chunks_exact(3 * cols).enumerate() {
            let l = factor * l[i * rows + k];
            across.iter_mut().zip(along).for_each(|(v, a)| *v += l * a);
        }
    }
}

/// The size of the net, after all of the problem has been looked at.
fn validated(problem: &ParametricProblem) -> Result<(usize, usize), SolveError> {
    let size = |matrices: &[PolynomialMatrix]| matrices.first().map_or(0, |m| m.rows);
    let (rows, cols) = (size(&problem.left), size(&problem.right));
    for (matrices, size) in [(&problem.left, rows), (&problem.right, cols)] {
        for matrix in matrices {
            check::length("rows of a polynomial matrix", size, matrix.rows)?;
            check::length("columns of a polynomial matrix", size, matrix.cols)?;
            let length = check::product("size of a polynomial matrix", size, size)?;
            for coefficients in &matrix.coefficients {
                check::length("length of a coefficient matrix", length, coefficients.len())?;
                check::finite(Place::Matrix, size.max(1), coefficients)?;
            }
        }
    }
    for term in &problem.terms {
        let within = |what, index: usize, bound: usize| {
            if index < bound { Ok(()) } else { Err(SolveError::WrongIndex { what, index, bound }) }
        };
        within("left matrix of a term", term.left, problem.left.len())?;
        within("right matrix of a term", term.right, problem.right.len())?;
        check::finite(Place::Matrix, 1, &[term.coefficient])?;
    }
    check::indices("free rows", &problem.free_left, rows)?;
    check::indices("free columns", &problem.free_right, cols)?;
    let order = check::product("number of unknowns", rows, cols)?;
    check::length(
        "length of the values",
        check::product("size of the values", order, 3)?,
        problem.values.len(),
    )?;
    for i in 0..rows {
        for j in 0..cols {
            if problem.free_left.binary_search(&i).is_ok() && problem.free_right.binary_search(&j).is_ok() {
                continue;
            }
            let row = i * cols + j;
            if let Some(column) = problem.values[3 * row..3 * row + 3].iter().position(|a| !a.is_finite()) {
                return Err(SolveError::NotFinite { place: Place::RightHandSide, row, column });
            }
        }
    }
    Ok((rows, cols))
}
