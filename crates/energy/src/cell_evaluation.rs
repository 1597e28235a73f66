//! Tangents at the points of a product rule from values at nodes, and their transpose.

use bases::Matrix;
use surfaces::Point;

use crate::cell_contraction::Samples;
use crate::panel::{Left, Right, product};

/// The factors of both, packed once. Sums go over v first, then over u: O(q m n + q² m) for m × n nodes and q² points.
#[derive(Debug, Clone)]
pub(crate) struct Evaluation {
    /// Functions of u and of v, and lines of constant u and points on each.
    functions: [usize; 2],
    points: [usize; 2],
    /// Over the functions, a column a line: derivatives, and values.
    of_u: [Left; 2],
    /// Over the functions, a column a point of a line: values, and derivatives.
    of_v: [Right; 2],
    /// Over the lines, derivatives above values: a column a function.
    to_u: Left,
    /// Over the points of a line, a column a function: values, and derivatives.
    to_v: [Right; 2],
}

/// Coordinates of a point.
const AXES: usize = 3;

impl Evaluation {
    pub(crate) fn new([u, v]: [Samples<'_>; 2]) -> Self {
        let [lines, q] = [u, v].map(|samples| samples.values.rows());
        let [m, n] = [u, v].map(|samples| samples.values.cols());
        let by_function = |table: &Matrix| Left::of_columns(table.cols(), table.as_slice());
        let by_point = |table: &Matrix| Right::of_columns(table.cols(), table.as_slice());
        let column_wise = |table: &Matrix| Right::of_columns(table.rows(), table.transpose().as_slice());
        let mut to_u = Left::new(2 * lines, m);
        for a in 0..lines {
            to_u.set_point(a, u.slopes.row(a));
            to_u.set_point(lines + a, u.values.row(a));
        }
        Self {
            functions: [m, n],
            points: [lines, q],
            of_u: [by_function(u.slopes), by_function(u.values)],
            of_v: [by_point(v.values), by_point(v.slopes)],
            to_u,
            to_v: [column_wise(v.values), column_wise(v.slopes)],
        }
    }

    /// `(x_u, x_v)` at the points.
    pub(crate) fn tangents(&self, x: &[Point]) -> Vec<[Point; 2]> {
        let ([m, n], [lines, q]) = (self.functions, self.points);
        // Over the n functions of v, columns (function of u, coordinate): one product serves all three coordinates.
        let (mut left, mut column) = (Left::new(n, AXES * m), vec![0.0; AXES * m]);
        for j in 0..n {
            for (i, numbers) in column.as_chunks_mut::<AXES>().0.iter_mut().enumerate() {
                *numbers = x[i * n + j].into();
            }
            left.set_point(j, &column);
        }
        let width = AXES * q;
        let (mut across, mut right) = (vec![0.0; m * width], Right::new(m, width));
        let mut sums = [vec![0.0; lines * width], vec![0.0; lines * width]];
        // x_u = Σ f_i' g_j, x_v = Σ f_i g_j': of_u and of_v stand in that order.
        for ((of_u, of_v), sums) in self.of_u.iter().zip(&self.of_v).zip(&mut sums) {
            product(&left, of_v, &mut across);
            for (i, line) in across.chunks_exact(width.max(1)).enumerate() {
                right.set_point(i, line);
            }
            product(of_u, &right, sums);
        }
        let mut tangents = Vec::with_capacity(lines * q);
        for (u, v) in sums[0].chunks_exact(width.max(1)).zip(sums[1].chunks_exact(width.max(1))) {
            let at = |line: &[f64], b: usize| Point::new(line[b], line[q + b], line[2 * q + b]);
            tangents.extend((0..q).map(|b| [at(u, b), at(v, b)]));
        }
        tangents
    }

    /// `Σ_p ∂uψ_k a_p + ∂vψ_k b_p` for every node k.
    pub(crate) fn adjoint(&self, pairs: &[[Point; 2]]) -> Vec<Point> {
        let ([m, n], [lines, q]) = (self.functions, self.points);
        let width = AXES * n;
        let mut right = Right::new(2 * lines, width);
        let (mut fields, mut sums) = (vec![0.0; AXES * lines * q], vec![0.0; lines * width]);
        // The transpose of `tangents`, in the opposite order: over the points of a line first, then over the lines.
        for (part, to_v) in self.to_v.iter().enumerate() {
            for (k, pair) in pairs.iter().enumerate() {
                let (a, b) = (k / q, k % q);
                for (c, x) in <[f64; 3]>::from(pair[part]).into_iter().enumerate() {
                    fields[(AXES * a + c) * q + b] = x;
                }
            }
            product(&Left::of_columns(q, &fields), to_v, &mut sums);
            for (a, line) in sums.chunks_exact(width.max(1)).enumerate() {
                right.set_point(part * lines + a, line);
            }
        }
        let mut nodes = vec![0.0; m * width];
        // In to_u derivatives stand above values, in `right` the sums of a above those of b: ∂u meets a and ∂v meets b.
        product(&self.to_u, &right, &mut nodes);
        let point = |row: &[f64], j: usize| Point::new(row[j], row[n + j], row[2 * n + j]);
        nodes.chunks_exact(width.max(1)).flat_map(|row| (0..n).map(move |j| point(row, j))).collect()
    }
}
