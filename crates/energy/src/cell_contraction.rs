//! Sums of fields times products of four functions of one variable each: first over v, then over u.

use bases::Matrix;

use crate::panel::{Left, Right, product};

/// A range of functions of one variable.
pub(crate) type Range = std::ops::Range<usize>;

/// Pairs of functions of u whose sums are formed at once: their factor stays in the nearest memory.
const AT_ONCE: usize = 32;

/// Weighted fields at the points of a product rule: for every line of constant u, component after component, at all its points.
/// `uu` and `vv` have `symmetric` components, those of products of two derivatives by u, or by v; `uv` has `full`, those of a
/// derivative by u times one by v.
pub(crate) struct Fields {
    pub(crate) symmetric: usize,
    pub(crate) full: usize,
    pub(crate) uu: Vec<f64>,
    pub(crate) vv: Vec<f64>,
    pub(crate) uv: Vec<f64>,
}

impl Fields {
    /// Fields of zeros over `lines` lines of `points` points.
    pub(crate) fn zeros(symmetric: usize, full: usize, lines: usize, points: usize) -> Self {
        let zeros = |components: usize| vec![0.0; components * lines * points];
        Self { symmetric, full, uu: zeros(symmetric), vv: zeros(symmetric), uv: zeros(full) }
    }
}

/// Values and derivatives of functions of one variable: points × functions.
#[derive(Clone, Copy)]
pub(crate) struct Samples<'a> {
    pub(crate) values: &'a Matrix,
    pub(crate) slopes: &'a Matrix,
}

/// The sums for one pair of functions of u and all pairs (j, l) of functions of v.
pub(crate) struct Sums<'a> {
    columns: usize,
    symmetric: &'a [f64],
    full: &'a [f64],
}

impl Sums<'_> {
    /// `Σ uu_c f_i' g_j f_k' g_l + vv_c f_i g_j' f_k g_l'` for all j, l fixed.
    pub(crate) fn symmetric(&self, component: usize, l: usize) -> &[f64] {
        let n = self.columns;
        &self.symmetric[(component * n + l) * n..][..n]
    }

    /// `Σ uv_c f_i' g_j f_k g_l' + uv_t f_i g_j' f_k' g_l` for all j, l fixed, t the transposed component.
    pub(crate) fn full(&self, component: usize, l: usize) -> &[f64] {
        let n = self.columns;
        &self.full[(component * n + l) * n..][..n]
    }
}

/// Products of pairs of functions over a window of them: what is the same for all fields.
#[derive(Debug, Clone)]
pub(crate) struct Pairs {
    window: [Range; 2],
    lines: usize,
    /// Products of two values and of two derivatives of functions l, j ≥ l of v, and of a value of j and a derivative of l, all l, j.
    of_v: [Right; 3],
    of_u: Vec<Chunk>,
}

/// Pairs (i, k), k ≤ i, of functions of u, with the products that belong to `uu` above those to `vv`, and to `uv` above its
/// transpose.
type Chunk = (Vec<(usize, usize)>, [Left; 2]);

impl Pairs {
    pub(crate) fn new([u, v]: [Samples<'_>; 2], window: [Range; 2]) -> Self {
        let [rows, columns] = &window;
        let half: Vec<(usize, usize)> =
            columns.clone().flat_map(|l| (l..columns.end).map(move |j| (j, l))).collect();
        let all: Vec<(usize, usize)> =
            columns.clone().flat_map(|l| columns.clone().map(move |j| (j, l))).collect();
        let lines = u.values.rows();
        // One product over twice as many lines sums f_i' f_k' uu and f_i f_k vv at once.
        let stacked = |pairs: &[(usize, usize)], first: [&Matrix; 2], second: [&Matrix; 2]| {
            let mut left = Left::new(2 * lines, pairs.len());
            left.set_pairs(0, first[0], first[1], pairs);
            left.set_pairs(lines, second[0], second[1], pairs);
            left
        };
        let pairs: Vec<(usize, usize)> =
            rows.clone().flat_map(|i| (rows.start..=i).map(move |k| (i, k))).collect();
        let of_chunk = |pairs: &[(usize, usize)]| {
            let same = stacked(pairs, [u.slopes, u.slopes], [u.values, u.values]);
            let mixed = stacked(pairs, [u.slopes, u.values], [u.values, u.slopes]);
            (pairs.to_vec(), [same, mixed])
        };
        Self {
            lines,
            of_v: [
                Right::of_pairs(v.values, v.values, &half),
                Right::of_pairs(v.slopes, v.slopes, &half),
                Right::of_pairs(v.values, v.slopes, &all),
            ],
            of_u: pairs.chunks(AT_ONCE).map(of_chunk).collect(),
            window,
        }
    }

    pub(crate) fn window(&self) -> &[Range; 2] {
        &self.window
    }

    /// Sums the fields over the window and shows the result for every pair (i, k), k ≤ i, of places in its rows.
    pub(crate) fn contract(&self, fields: &Fields, mut show: impl FnMut(usize, usize, &Sums<'_>)) {
        let [rows, columns] = &self.window;
        let n = columns.len();
        // What depends on v alone is summed first: then only lines are left, and pairs of functions of u meet no points.
        let (halved, full) = self.along_v(fields);
        let mut sums = vec![0.0; AT_ONCE * halved.columns()];
        let mut mixed = vec![0.0; AT_ONCE * full.columns()];
        let mut symmetric = vec![0.0; fields.symmetric * n * n];
        for (pairs, [same, other]) in &self.of_u {
            let sums = &mut sums[..pairs.len() * halved.columns()];
            product(same, &halved, sums);
            let mixed = &mut mixed[..pairs.len() * full.columns()];
            product(other, &full, mixed);
            for (at, &(i, k)) in pairs.iter().enumerate() {
                expand(&sums[at * halved.columns()..][..halved.columns()], n, &mut symmetric);
                let full = &mixed[at * full.columns()..][..full.columns()];
                show(i - rows.start, k - rows.start, &Sums { columns: n, symmetric: &symmetric, full });
            }
        }
    }

    /// The sums over v, over twice the lines of constant u: of `uu` above `vv`, columns (component, l, j ≥ l), and of `uv` above
    /// its transpose, columns (component, l, j).
    fn along_v(&self, fields: &Fields) -> (Right, Right) {
        let (lines, n) = (self.lines, self.window[1].len());
        let [of_uu, of_vv, of_uv] = &self.of_v;
        let sum = |field: &[f64], right: &Right| {
            let left = Left::of_columns(right.points(), field);
            let mut out = vec![0.0; left.columns() * right.columns()];
            product(&left, right, &mut out);
            out
        };
        // Halved, because uu and vv are symmetric in (j, l); uv is not.
        let mut halved = Right::new(2 * lines, fields.symmetric * of_uu.columns());
        let width = halved.columns();
        for (first, field, right) in [(0, &fields.uu, of_uu), (lines, &fields.vv, of_vv)] {
            for (a, line) in sum(field, right).chunks_exact(width.max(1)).enumerate() {
                halved.set_point(first + a, line);
            }
        }
        let mut full = Right::new(2 * lines, fields.full * n * n);
        let width = full.columns();
        // Components are those of a square matrix, row by row.
        let side = fields.full.isqrt();
        let mut turned = vec![0.0; width];
        for (a, line) in sum(&fields.uv, of_uv).chunks_exact(width.max(1)).enumerate() {
            full.set_point(a, line);
            // Swapping the two functions of uv swaps its coordinates (α, β) and its (j, l): the transpose of both is the other half.
            for c in 0..side * side {
                let part = &line[(c % side * side + c / side) * n * n..][..n * n];
                transpose(n, part, &mut turned[c * n * n..][..n * n]);
            }
            full.set_point(lines + a, &turned);
        }
        (halved, full)
    }
}

fn transpose(n: usize, matrix: &[f64], out: &mut [f64]) {
    for (l, row) in out.chunks_exact_mut(n.max(1)).enumerate() {
        for (j, out) in row.iter_mut().enumerate() {
            *out = matrix[j * n + l];
        }
    }
}

/// From columns (component, l, j ≥ l) to (component, l, j).
fn expand(halved: &[f64], n: usize, all: &mut [f64]) {
    let parts = halved.chunks_exact((n * (n + 1) / 2).max(1));
    for (part, all) in parts.zip(all.chunks_exact_mut((n * n).max(1))) {
        let mut at = 0;
        for l in 0..n {
            for j in l..n {
                all[l * n + j] = part[at];
                all[j * n + l] = part[at];
                at += 1;
            }
        }
    }
}
