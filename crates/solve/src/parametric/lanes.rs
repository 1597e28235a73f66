//! The reduced energy `J = c − Σ_d b_dᵀ Q_ff⁻¹ b_d` and its gradient, for as many points at a time as the arithmetic is
//! wide.

use super::factor::{factor_any, factor_fixed};
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
            // Infinity is no energy either: NaN is the one sign of a point without a value.
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
pub(super) struct Workspace<'a, const W: usize> {
    pub(super) left: &'a mut [[f64; W]],
    pub(super) right: &'a mut [[f64; W]],
    /// b, three a free unknown, and c.
    pub(super) entries: &'a mut [[f64; W]],
    /// Rows of the free unknowns and the three of b: w_ij, and l_ij = w_ij / d_j.
    pub(super) w: &'a mut [[f64; W]],
    pub(super) l: &'a mut [[f64; W]],
    /// Three a free unknown.
    pub(super) minimiser: &'a mut [[f64; W]],
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
    // The inner points of nets of degrees 2 to 4: unrolled, for these are what a swarm evaluates most.
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
    // All 36 products x_m y_n at once: the sum then runs down one table, its entries side by side.
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

/// The weights `Σ_d p_i p_j` of the minimiser with which the slots of Q_ff stand in pᵀ Q_ff p: for each left factor those of its right
/// ones together, and the other way round.
#[inline(always)]
fn weigh_slots<'a, const W: usize, A: Arithmetic<W>>(
    a: A,
    tables: &Tables,
    workspace: &'a mut Workspace<'_, W>,
) -> (&'a [[f64; W]], &'a [[f64; W]]) {
    let (left, right) = (&*workspace.left, &*workspace.right);
    let (of_left, rest) = workspace.slot_weights.split_at_mut(left.len());
    let of_right = &mut rest[..right.len()];
    of_left.fill([0.0; W]);
    of_right.fill([0.0; W]);
    let mut slots = tables.assembly.chunks_exact(tables.terms.max(1));
    for i in 0..tables.free {
        for j in 0..=i {
            let mut weight = a.splat(0.0);
            for d in 0..3 {
                let (p, q) =
                    (a.load(&workspace.minimiser[3 * i + d]), a.load(&workspace.minimiser[3 * j + d]));
                weight = a.mul_add(p, q, weight);
            }
            // Off the diagonal an entry stands twice in pᵀ Q p.
            weight = a.mul(weight, a.splat(if i == j { 1.0 } else { 2.0 }));
            for [l, r] in slots.next().unwrap_or(&[]) {
                let (l, r) = (*l as usize, *r as usize);
                of_left[l] = a.store(a.mul_add(weight, a.load(&right[r]), a.load(&of_left[l])));
                of_right[r] = a.store(a.mul_add(weight, a.load(&left[l]), a.load(&of_right[r])));
            }
        }
    }
    (&*of_left, &*of_right)
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
    // By the envelope theorem the minimiser is held: its own change is of first order in the gradient of J by p, which is 0.
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
    // Of Σ T_mn x_m y_n, the derivatives by the monomials x_m and y_n; below, those of the slots join them.
    let (mut dx, mut dy) = ([zero; MONOMIALS], [zero; MONOMIALS]);
    for m in 0..MONOMIALS {
        for n in 0..MONOMIALS {
            dx[m] = a.mul_add(table[m * MONOMIALS + n], y[n], dx[m]);
            dy[n] = a.mul_add(table[m * MONOMIALS + n], x[m], dy[n]);
        }
    }

    let (of_left, of_right) = weigh_slots(a, tables, workspace);
    for (derivatives, weights, coefficients) in
        [(&mut dx, of_left, &tables.left), (&mut dy, of_right, &tables.right)]
    {
        for (weight, c) in weights.iter().zip(coefficients) {
            // The constant (m = 0) has no derivative.
            for m in 1..MONOMIALS {
                derivatives[m] = a.mul_add(a.load(weight), a.splat(c[m]), derivatives[m]);
            }
        }
    }
    let two = a.splat(2.0);
    // The chain rule through (1, s, t, s², st, t²).
    let by = |d: &[A::V; MONOMIALS], s: A::V, t: A::V| {
        let of_s = a.mul_add(a.mul(two, s), d[3], a.mul_add(t, d[4], d[1]));
        let of_t = a.mul_add(a.mul(two, t), d[5], a.mul_add(s, d[4], d[2]));
        [of_s, of_t]
    };
    let ([g0, g1], [g2, g3]) = (by(&dx, point[0], point[1]), by(&dy, point[2], point[3]));
    [g0, g1, g2, g3]
}
