//! Products of factors packed once and used often: the kernel of the second derivatives of areas.

use bases::Matrix;
use pulp::{Arch, Simd, WithSimd};

/// Columns of the left and of the right factor that are summed in registers.
const LEFT: usize = 4;
const RIGHT: usize = 8;

/// A left or a right factor: columns of numbers, one for every point, in groups that are read point by point.
#[derive(Debug, Clone)]
pub(crate) struct Panels<const W: usize> {
    points: usize,
    columns: usize,
    data: Vec<f64>,
}

pub(crate) type Left = Panels<LEFT>;
pub(crate) type Right = Panels<RIGHT>;

impl<const W: usize> Panels<W> {
    /// `columns` columns over `points` points, still to be filled in.
    pub(crate) fn new(points: usize, columns: usize) -> Self {
        Self { points, columns, data: vec![0.0; points * columns.next_multiple_of(W)] }
    }

    /// Columns given one after the other.
    pub(crate) fn of_columns(points: usize, numbers: &[f64]) -> Self {
        let mut panels = Self::new(points, numbers.len() / points.max(1));
        for (k, column) in numbers.chunks_exact(points.max(1)).enumerate() {
            panels.set(k, 0, column.iter().copied());
        }
        panels
    }

    /// Products `f_i g_k` of functions sampled at the points, a column for every (i, k).
    pub(crate) fn of_pairs(f: &Matrix, g: &Matrix, pairs: &[(usize, usize)]) -> Self {
        let mut panels = Self::new(f.rows(), pairs.len());
        panels.set_pairs(0, f, g, pairs);
        panels
    }

    /// Writes such products from a point on.
    pub(crate) fn set_pairs(&mut self, first: usize, f: &Matrix, g: &Matrix, pairs: &[(usize, usize)]) {
        for (column, &(i, k)) in pairs.iter().enumerate() {
            self.set(column, first, (0..f.rows()).map(|p| f[(p, i)] * g[(p, k)]));
        }
    }

    /// Writes a column from a point on.
    fn set(&mut self, column: usize, first: usize, numbers: impl Iterator<Item = f64>) {
        let start = (column / W * self.points + first) * W + column % W;
        let column = self.data.get_mut(start..).unwrap_or_default();
        column.iter_mut().step_by(W).zip(numbers).for_each(|(out, x)| *out = x);
    }

    /// Writes the numbers of all columns at one point.
    pub(crate) fn set_point(&mut self, point: usize, numbers: &[f64]) {
        debug_assert_eq!(numbers.len(), self.columns);
        let (groups, rest) = numbers.as_chunks::<W>();
        let mut start = point * W;
        for group in groups {
            self.data[start..start + W].copy_from_slice(group);
            start += self.points * W;
        }
        if !rest.is_empty() {
            self.data[start..start + rest.len()].copy_from_slice(rest);
        }
    }

    pub(crate) fn points(&self) -> usize {
        self.points
    }

    pub(crate) fn columns(&self) -> usize {
        self.columns
    }
}

/// `leftᵀ right`, summed over the points: row by row into `out`, a number for every pair of columns. Where the processor has
/// fused arithmetic it is used: the last bits depend on the machine.
pub(crate) fn product(left: &Left, right: &Right, out: &mut [f64]) {
    out.fill(0.0);
    add_panels(left, right, out, false);
}

/// Adds `leftᵀ right` to `out`; if only the `upper` triangle counts, what lies below it is any.
pub(crate) fn add_panels(left: &Left, right: &Right, out: &mut [f64], upper: bool) {
    assert_eq!((left.points, out.len()), (right.points, left.columns * right.columns), "sizes of a product");
    Arch::new().dispatch(Blocks { left, right, out, upper });
}

struct Blocks<'a> {
    left: &'a Left,
    right: &'a Right,
    out: &'a mut [f64],
    upper: bool,
}

/// Whether a vector unit of this machine fuses: all that are chosen here, but for those of WebAssembly.
const FUSES: bool = cfg!(any(target_arch = "x86_64", target_arch = "aarch64"));

impl WithSimd for Blocks<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        if FUSES && S::F64_LANES > 1 {
            self.sum(|x, y, sum| x.mul_add(y, sum));
        } else {
            self.sum(|x, y, sum| x * y + sum);
        }
    }
}

impl Blocks<'_> {
    #[inline(always)]
    fn sum(self, multiply_add: impl Fn(f64, f64, f64) -> f64) {
        let Self { left, right, out, upper } = self;
        let columns = right.columns;
        for (group, b) in right.data.chunks_exact((RIGHT * right.points).max(1)).enumerate() {
            let column = group * RIGHT;
            let width = RIGHT.min(columns - column);
            for (rows, a) in left.data.chunks_exact((LEFT * left.points).max(1)).enumerate() {
                if upper && column + RIGHT <= rows * LEFT {
                    continue;
                }
                let mut block = [[0.0; RIGHT]; LEFT];
                for (x, y) in a.as_chunks::<LEFT>().0.iter().zip(b.as_chunks::<RIGHT>().0) {
                    for i in 0..LEFT {
                        for j in 0..RIGHT {
                            block[i][j] = multiply_add(x[i], y[j], block[i][j]);
                        }
                    }
                }
                for (i, line) in block.iter().enumerate().take(left.columns - rows * LEFT) {
                    let start = (rows * LEFT + i) * columns + column;
                    out[start..start + width].iter_mut().zip(line).for_each(|(out, x)| *out += x);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panels_of_every_size_multiply() {
        for (points, rows, columns) in [(0, 3, 2), (1, 1, 1), (3, 4, 8), (5, 7, 9), (2, 8, 17)] {
            let f = Matrix::from_fn(points, rows, |p, k| (p + 2 * k) as f64);
            let g = Matrix::from_fn(points, columns, |p, k| (3 * p) as f64 - k as f64);
            let ones = Matrix::from_fn(points, 1, |_, _| 1.0);
            let single = |count: usize| (0..count).map(|k| (k, 0)).collect::<Vec<_>>();
            let left = Left::of_pairs(&f, &ones, &single(rows));
            let mut right = Right::new(points, columns);
            (0..points).for_each(|p| right.set_point(p, g.row(p)));
            let mut out = vec![f64::NAN; rows * columns];
            product(&left, &right, &mut out);
            assert_eq!(out, f.transpose().times(&g).as_slice());
            if points > 0 {
                let again = Right::of_columns(points, g.transpose().as_slice());
                assert_eq!((again.columns(), again.data), (columns, right.data));
            }
        }
    }
}
