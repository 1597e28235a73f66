//! The reduced energy `J = c − Σ_d b_dᵀ Q_ff⁻¹ b_d`, for as many points at a time as the arithmetic is wide.
//!
//! `Q_ff = L D Lᵀ` without square roots. With w_ij = l_ij d_j, every entry is one chain of `w_ij ← w_ij − w_ik l_jk`
//! in the order of k, whatever the width and the size: a point's bits depend on its path alone. The columns of
//! b are carried along as three more rows; their l and w give `J = c − Σ l w`.

use super::path::{Arithmetic, Kernel, MOST_LANES};
use super::table::{MONOMIALS, PRODUCTS, Tables, blocks};

/// Values of `tables` at `points` (four numbers each) into `out`.
pub(super) struct Values<'a> {
    pub(super) tables: &'a Tables,
    pub(super) points: &'a [[f64; 4]],
    pub(super) out: &'a mut [f64],
    pub(super) workspace: &'a mut [f64],
}

impl Kernel for Values<'_> {
    type Output = ();

    #[inline(always)]
    fn run<const W: usize, A: Arithmetic<W>>(self, arithmetic: A) {
        let mut workspace = Workspace::<W>::new(self.tables, self.workspace);
        for (points, out) in self.points.chunks(W).zip(self.out.chunks_mut(W)) {
            // The tail repeats its last point: every lane always holds a number that was asked for.
            let mut lanes = [[0.0; W]; 4];
            for lane in 0..W {
                for k in 0..4 {
                    lanes[k][lane] = points[lane.min(points.len() - 1)][k];
                }
            }
            let point = [
                arithmetic.load(&lanes[0]),
                arithmetic.load(&lanes[1]),
                arithmetic.load(&lanes[2]),
                arithmetic.load(&lanes[3]),
            ];
            let values = arithmetic.store(value(arithmetic, self.tables, point, &mut workspace));
            for (out, value) in out.iter_mut().zip(values) {
                *out = if value.is_finite() { value } else { f64::NAN };
            }
        }
    }
}

/// Value and gradient at one point.
pub(super) struct ValueAndGradient<'a> {
    pub(super) tables: &'a Tables,
    pub(super) point: &'a [f64; 4],
    pub(super) gradient: &'a mut [f64; 4],
    pub(super) workspace: &'a mut [f64],
}

impl Kernel for ValueAndGradient<'_> {
    type Output = f64;

    #[inline(always)]
    fn run<const W: usize, A: Arithmetic<W>>(self, arithmetic: A) -> f64 {
        let mut workspace = Workspace::<W>::new(self.tables, self.workspace);
        let mut point = [arithmetic.splat(0.0); 4];
        for k in 0..4 {
            point[k] = arithmetic.splat(self.point[k]);
        }
        let value = arithmetic.store(value(arithmetic, self.tables, point, &mut workspace))[0];
        let gradient = gradient(arithmetic, self.tables, point, &mut workspace);
        for k in 0..4 {
            self.gradient[k] = arithmetic.store(gradient[k])[0];
        }
        if value.is_finite() && self.gradient.iter().all(|g| g.is_finite()) {
            value
        } else {
            *self.gradient = [f64::NAN; 4];
            f64::NAN
        }
    }
}

/// Arrays of one evaluation, `W` points side by side.
struct Workspace<'a, const W: usize> {
    left: &'a mut [[f64; W]],
    right: &'a mut [[f64; W]],
    /// b, three a free unknown, and c.
    entries: &'a mut [[f64; W]],
    /// Rows of the free unknowns and the three of b: w_ij, and l_ij = w_ij / d_j.
    w: &'a mut [[f64; W]],
    l: &'a mut [[f64; W]],
    /// Three a free unknown.
    minimiser: &'a mut [[f64; W]],
    /// What the minimiser weighs each left and each right slot with.
    slot_weights: &'a mut [[f64; W]],
}

/// Lengths of the arrays of a [`Workspace`], in the order of its fields.
#[inline(always)]
fn lengths(tables: &Tables) -> [usize; 7] {
    let (free, left, right) = (tables.free, tables.left.len(), tables.right.len());
    [left, right, 3 * free + 1, (free + 3) * free, (free + 3) * free, 3 * free, left + right]
}

/// Numbers of memory that an evaluation needs, however many points it takes at a time.
pub(super) fn memory(tables: &Tables) -> usize {
    lengths(tables).iter().sum::<usize>() * MOST_LANES
}

impl<'a, const W: usize> Workspace<'a, W> {
    /// `memory` holds at least [`memory`] numbers, of any value.
    #[inline(always)]
    fn new(tables: &Tables, memory: &'a mut [f64]) -> Self {
        let lengths = lengths(tables);
        let (rest, _) = memory.as_chunks_mut::<W>();
        let (left, rest) = rest.split_at_mut(lengths[0]);
        let (right, rest) = rest.split_at_mut(lengths[1]);
        let (entries, rest) = rest.split_at_mut(lengths[2]);
        let (w, rest) = rest.split_at_mut(lengths[3]);
        let (l, rest) = rest.split_at_mut(lengths[4]);
        let (minimiser, rest) = rest.split_at_mut(lengths[5]);
        let slot_weights = &mut rest[..lengths[6]];
        Self { left, right, entries, w, l, minimiser, slot_weights }
    }
}

#[inline(always)]
fn value<const W: usize, A: Arithmetic<W>>(
    a: A,
    tables: &Tables,
    point: [A::V; 4],
    workspace: &mut Workspace<'_, W>,
) -> A::V {
    let x = monomials(a, point[0], point[1]);
    let y = monomials(a, point[2], point[3]);
    polynomials(a, &tables.left, &x, workspace.left);
    polynomials(a, &tables.right, &y, workspace.right);
    bilinear_forms(a, &tables.bilinear, &x, &y, workspace.entries);
    match tables.free {
        1 => factor_fixed::<W, A, 1>(a, tables, workspace),
        2 => factor_fixed::<W, A, 2>(a, tables, workspace),
        3 => factor_fixed::<W, A, 3>(a, tables, workspace),
        4 => factor_fixed::<W, A, 4>(a, tables, workspace),
        6 => factor_fixed::<W, A, 6>(a, tables, workspace),
        9 => factor_fixed::<W, A, 9>(a, tables, workspace),
        _ => factor_any(a, tables, workspace),
    }
}

#[inline(always)]
fn monomials<const W: usize, A: Arithmetic<W>>(a: A, s: A::V, t: A::V) -> [A::V; MONOMIALS] {
    [a.splat(1.0), s, t, a.mul(s, s), a.mul(s, t), a.mul(t, t)]
}

#[inline(always)]
fn polynomials<const W: usize, A: Arithmetic<W>>(
    a: A,
    coefficients: &[[f64; MONOMIALS]],
    x: &[A::V; MONOMIALS],
    out: &mut [[f64; W]],
) {
    for (out, c) in out.iter_mut().zip(coefficients) {
        let mut sum = a.splat(c[0]);
        for m in 1..MONOMIALS {
            sum = a.mul_add(x[m], a.splat(c[m]), sum);
        }
        *out = a.store(sum);
    }
}

#[inline(always)]
fn bilinear_forms<const W: usize, A: Arithmetic<W>>(
    a: A,
    tables: &[f64],
    x: &[A::V; MONOMIALS],
    y: &[A::V; MONOMIALS],
    out: &mut [[f64; W]],
) {
    let mut products = [x[0]; PRODUCTS];
    for m in 0..MONOMIALS {
        for n in 0..MONOMIALS {
            products[m * MONOMIALS + n] = a.mul(x[m], y[n]);
        }
    }
    for (start, size) in blocks(out.len()) {
        let table = &tables[start * PRODUCTS..(start + size) * PRODUCTS];
        let out = &mut out[start..start + size];
        match size {
            1 => block::<W, 1, A>(a, table, &products, out),
            2 => block::<W, 2, A>(a, table, &products, out),
            3 => block::<W, 3, A>(a, table, &products, out),
            4 => block::<W, 4, A>(a, table, &products, out),
            _ => block::<W, 5, A>(a, table, &products, out),
        }
    }
}

#[inline(always)]
fn block<const W: usize, const B: usize, A: Arithmetic<W>>(
    a: A,
    table: &[f64],
    products: &[A::V; PRODUCTS],
    out: &mut [[f64; W]],
) {
    let (rows, _) = table.as_chunks::<B>();
    // The first product is 1.
    let mut sums = [a.splat(0.0); B];
    for k in 0..B {
        sums[k] = a.splat(rows[0][k]);
    }
    for (product, row) in products[1..].iter().zip(&rows[1..]) {
        for k in 0..B {
            sums[k] = a.mul_add(*product, a.splat(row[k]), sums[k]);
        }
    }
    for k in 0..B {
        out[k] = a.store(sums[k]);
    }
}

/// The entry of `Q_ff` that `slots` make.
#[inline(always)]
fn entry<const W: usize, A: Arithmetic<W>>(
    a: A,
    slots: &[[u32; 2]],
    left: &[[f64; W]],
    right: &[[f64; W]],
) -> A::V {
    let mut sum = a.splat(0.0);
    for (t, [l, r]) in slots.iter().enumerate() {
        let (l, r) = (a.load(&left[*l as usize]), a.load(&right[*r as usize]));
        sum = if t == 0 { a.mul(l, r) } else { a.mul_add(l, r, sum) };
    }
    sum
}

/// `N` free unknowns, unrolled.
#[inline(always)]
fn factor_fixed<const W: usize, A: Arithmetic<W>, const N: usize>(
    a: A,
    tables: &Tables,
    workspace: &mut Workspace<'_, W>,
) -> A::V {
    let zero = a.splat(0.0);
    let bound = a.splat(tables.pivot_bound);
    let (mut w, mut l) = ([[zero; N]; N], [[zero; N]; N]);
    let (mut z, mut u) = ([[zero; N]; 3], [[zero; N]; 3]);
    let mut slots = tables.assembly.chunks_exact(tables.terms.max(1));
    for i in 0..N {
        for j in 0..=i {
            w[i][j] = entry(a, slots.next().unwrap_or(&[]), workspace.left, workspace.right);
        }
        for d in 0..3 {
            z[d][i] = a.load(&workspace.entries[3 * i + d]);
        }
    }
    let mut value = a.load(&workspace.entries[3 * N]);
    for j in 0..N {
        let diagonal = w[j][j];
        for k in 0..j {
            for i in j..N {
                w[i][j] = a.sub_mul(w[i][k], l[j][k], w[i][j]);
            }
            for d in 0..3 {
                z[d][j] = a.sub_mul(z[d][k], l[j][k], z[d][j]);
            }
        }
        let inverse = a.reciprocal_above(w[j][j], a.mul(bound, diagonal));
        for i in j + 1..N {
            l[i][j] = a.mul(w[i][j], inverse);
        }
        for d in 0..3 {
            u[d][j] = a.mul(z[d][j], inverse);
            value = a.sub_mul(u[d][j], z[d][j], value);
        }
    }
    if W == 1 {
        for j in (0..N).rev() {
            for d in 0..3 {
                let mut p = u[d][j];
                for i in j + 1..N {
                    p = a.sub_mul(l[i][j], u[d][i], p);
                }
                u[d][j] = p;
                workspace.minimiser[3 * j + d] = a.store(a.mul(p, a.splat(-1.0)));
            }
        }
    }
    value
}

/// Any number of free unknowns.
#[inline(always)]
fn factor_any<const W: usize, A: Arithmetic<W>>(
    a: A,
    tables: &Tables,
    workspace: &mut Workspace<'_, W>,
) -> A::V {
    let n = tables.free;
    // One point: columns are contiguous, so that their updates fill vectors. Many: rows are.
    let at = |i: usize, j: usize| if W == 1 { j * (n + 3) + i } else { i * n + j };
    let mut slots = tables.assembly.chunks_exact(tables.terms.max(1));
    for i in 0..n {
        for j in 0..=i {
            let sum = entry(a, slots.next().unwrap_or(&[]), workspace.left, workspace.right);
            workspace.w[at(i, j)] = a.store(sum);
        }
        for d in 0..3 {
            workspace.w[at(n + d, i)] = workspace.entries[3 * i + d];
        }
    }
    if W == 1 {
        factor_columns(a, n, tables.pivot_bound, workspace.w, workspace.l);
        for j in (0..n).rev() {
            for d in 0..3 {
                let mut p = a.load(&workspace.l[at(n + d, j)]);
                for i in j + 1..n {
                    p = a.mul_add(a.load(&workspace.l[at(i, j)]), a.load(&workspace.minimiser[3 * i + d]), p);
                }
                workspace.minimiser[3 * j + d] = a.store(a.mul(p, a.splat(-1.0)));
            }
        }
    } else {
        factor_rows(a, n, tables.pivot_bound, workspace.w, workspace.l);
    }
    let mut value = a.load(&workspace.entries[3 * n]);
    for j in 0..n {
        for d in 0..3 {
            let (u, z) = (a.load(&workspace.l[at(n + d, j)]), a.load(&workspace.w[at(n + d, j)]));
            value = a.sub_mul(u, z, value);
        }
    }
    value
}

/// `w` and `l` column by column (`n + 3` numbers each), every column subtracted from all later ones at once.
#[inline(always)]
fn factor_columns<const W: usize, A: Arithmetic<W>>(
    a: A,
    n: usize,
    pivot_bound: f64,
    w: &mut [[f64; W]],
    l: &mut [[f64; W]],
) {
    let rows = n + 3;
    for j in 0..n {
        // The diagonal as assembled, which the pivots are held against; l itself has ones there.
        l[j * rows + j] = w[j * rows + j];
    }
    for k in 0..n {
        let (done, later) = w.split_at_mut((k + 1) * rows);
        let column = &done[k * rows..];
        let bound = a.mul(a.splat(pivot_bound), a.load(&l[k * rows + k]));
        let inverse = a.reciprocal_above(a.load(&column[k]), bound);
        for i in k + 1..rows {
            l[k * rows + i] = a.store(a.mul(a.load(&column[i]), inverse));
        }
        for (j, target) in (k + 1..n).zip(later.chunks_exact_mut(rows)) {
            let factor = a.load(&l[k * rows + j]);
            for (target, source) in target[j..].iter_mut().zip(&column[j..]) {
                *target = a.store(a.sub_mul(a.load(source), factor, a.load(target)));
            }
        }
    }
}

/// `w` and `l` row by row (`n` numbers each), in tiles of two rows and two columns that stay in registers.
#[inline(always)]
fn factor_rows<const W: usize, A: Arithmetic<W>>(
    a: A,
    n: usize,
    pivot_bound: f64,
    w: &mut [[f64; W]],
    l: &mut [[f64; W]],
) {
    let rows = n + 3;
    let bound = a.splat(pivot_bound);
    let mut inverse = [bound; 2];
    for j in (0..n).step_by(2) {
        let columns = (n - j).min(2);
        for i in (j..rows).step_by(2) {
            let height = (rows - i).min(2);
            let diagonal = [a.load(&w[i * n + j]), a.load(&w[(i + height - 1) * n + j + columns - 1])];
            match (height, columns) {
                (2, 2) => tile::<W, 2, 2, A>(a, n, i, j, w, l),
                (1, 2) => tile::<W, 1, 2, A>(a, n, i, j, w, l),
                (2, 1) => tile::<W, 2, 1, A>(a, n, i, j, w, l),
                _ => tile::<W, 1, 1, A>(a, n, i, j, w, l),
            }
            for c in 0..columns {
                for r in 0..height {
                    let at = (i + r) * n + j;
                    if i == j && r < c {
                        continue;
                    }
                    let mut entry = a.load(&w[at + c]);
                    if c == 1 {
                        // The tile stopped before its own first column.
                        entry = a.sub_mul(a.load(&w[at]), a.load(&l[(j + 1) * n + j]), entry);
                        w[at + 1] = a.store(entry);
                    }
                    if i == j && r == c {
                        inverse[c] = a.reciprocal_above(entry, a.mul(bound, diagonal[c]));
                    } else {
                        l[at + c] = a.store(a.mul(entry, inverse[c]));
                    }
                }
            }
        }
    }
}

/// `w_ic ← w_ic − Σ_{k<j} w_ik l_ck` for rows from `i` and columns from `j`.
#[inline(always)]
fn tile<const W: usize, const R: usize, const C: usize, A: Arithmetic<W>>(
    a: A,
    n: usize,
    i: usize,
    j: usize,
    w: &mut [[f64; W]],
    l: &[[f64; W]],
) {
    let mut sums = [[a.splat(0.0); C]; R];
    for r in 0..R {
        for c in 0..C {
            sums[r][c] = a.load(&w[(i + r) * n + j + c]);
        }
    }
    let mut sources = [&w[..0]; R];
    let mut factors = [&l[..0]; C];
    for r in 0..R {
        sources[r] = &w[(i + r) * n..(i + r) * n + j];
    }
    for c in 0..C {
        factors[c] = &l[(j + c) * n..(j + c) * n + j];
    }
    for k in 0..j {
        for r in 0..R {
            for c in 0..C {
                sums[r][c] = a.sub_mul(a.load(&sources[r][k]), a.load(&factors[c][k]), sums[r][c]);
            }
        }
    }
    for r in 0..R {
        for c in 0..C {
            w[(i + r) * n + j + c] = a.store(sums[r][c]);
        }
    }
}

/// `∂J = Σ_d X_dᵀ (∂Q) X_d` at the minimiser that [`value`] left in the workspace.
///
/// First the minimiser is contracted with the tables, which leaves one polynomial in the four parameters: one
/// table for 2 b·p + c, and for pᵀ Q_ff p the weights of the slots.
#[inline(always)]
fn gradient<const W: usize, A: Arithmetic<W>>(
    a: A,
    tables: &Tables,
    point: [A::V; 4],
    workspace: &mut Workspace<'_, W>,
) -> [A::V; 4] {
    let zero = a.splat(0.0);
    let (x, y) = (monomials(a, point[0], point[1]), monomials(a, point[2], point[3]));
    let entries = 3 * tables.free;
    let mut table = [zero; PRODUCTS];
    for k in 0..PRODUCTS {
        table[k] = a.splat(tables.by_entry[entries][k]);
    }
    for (p, coefficients) in workspace.minimiser.iter().zip(&tables.by_entry) {
        let twice = a.mul(a.splat(2.0), a.load(p));
        for k in 0..PRODUCTS {
            table[k] = a.mul_add(twice, a.splat(coefficients[k]), table[k]);
        }
    }
    let (mut dx, mut dy) = ([zero; MONOMIALS], [zero; MONOMIALS]);
    for m in 0..MONOMIALS {
        for n in 0..MONOMIALS {
            dx[m] = a.mul_add(table[m * MONOMIALS + n], y[n], dx[m]);
            dy[n] = a.mul_add(table[m * MONOMIALS + n], x[m], dy[n]);
        }
    }

    let (left, right) = (&*workspace.left, &*workspace.right);
    let (of_left, rest) = workspace.slot_weights.split_at_mut(left.len());
    let of_right = &mut rest[..right.len()];
    of_left.fill([0.0; W]);
    of_right.fill([0.0; W]);
    let mut slots = tables.assembly.chunks_exact(tables.terms.max(1));
    for i in 0..tables.free {
        for j in 0..=i {
            let mut weight = zero;
            for d in 0..3 {
                let (p, q) =
                    (a.load(&workspace.minimiser[3 * i + d]), a.load(&workspace.minimiser[3 * j + d]));
                weight = a.mul_add(p, q, weight);
            }
            weight = a.mul(weight, a.splat(if i == j { 1.0 } else { 2.0 }));
            for [l, r] in slots.next().unwrap_or(&[]) {
                let (l, r) = (*l as usize, *r as usize);
                of_left[l] = a.store(a.mul_add(weight, a.load(&right[r]), a.load(&of_left[l])));
                of_right[r] = a.store(a.mul_add(weight, a.load(&left[l]), a.load(&of_right[r])));
            }
        }
    }
    for (derivatives, weights, coefficients) in
        [(&mut dx, &*of_left, &tables.left), (&mut dy, &*of_right, &tables.right)]
    {
        for (weight, c) in weights.iter().zip(coefficients) {
            for m in 1..MONOMIALS {
                derivatives[m] = a.mul_add(a.load(weight), a.splat(c[m]), derivatives[m]);
            }
        }
    }
    let two = a.splat(2.0);
    let by = |d: &[A::V; MONOMIALS], s: A::V, t: A::V| {
        let of_s = a.mul_add(a.mul(two, s), d[3], a.mul_add(t, d[4], d[1]));
        let of_t = a.mul_add(a.mul(two, t), d[5], a.mul_add(s, d[4], d[2]));
        [of_s, of_t]
    };
    let ([g0, g1], [g2, g3]) = (by(&dx, point[0], point[1]), by(&dy, point[2], point[3]));
    [g0, g1, g2, g3]
}
