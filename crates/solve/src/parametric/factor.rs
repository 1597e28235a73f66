//! `Q_ff = L D Lᵀ` without square roots, and `J = c − Σ l w`.
//!
//! With w_ij = l_ij d_j, every entry is one chain of `w_ij ← w_ij − w_ik l_jk` in the order of k, whatever the width and
//! the size: a point's bits depend on its path alone. The columns of b are carried along as three more rows,
//! whose l and w give J.

use super::lanes::Workspace;
use super::path::Arithmetic;
use super::table::Tables;

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
pub(super) fn factor_fixed<const W: usize, A: Arithmetic<W>, const N: usize>(
    a: A,
    tables: &Tables,
    workspace: &mut Workspace<'_, W>,
) -> A::V {
    let zero = a.splat(0.0);
    let bound = a.splat(tables.pivot_bound);
    // z are the rows of b, u = z D⁻¹: the last three rows of w and l.
    let (mut w, mut l) = ([[zero; N]; N], [[zero; N]; N]);
    let (mut z, mut u) = ([[zero; N]; 3], [[zero; N]; 3]);
    let mut slots = tables.assembly.chunks_exact(tables.terms.max(1));
    for i in 0..N {
        // The lower triangle row by row, as the table of assembly lists it.
        for j in 0..=i {
            w[i][j] = entry(a, slots.next().unwrap_or(&[]), workspace.left, workspace.right);
        }
        for d in 0..3 {
            z[d][i] = a.load(&workspace.entries[3 * i + d]);
        }
    }
    let mut value = a.load(&workspace.entries[3 * N]);
    for j in 0..N {
        // The diagonal before anything was subtracted: what is left of it measures cancellation.
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
            // J = c − bᵀ Q⁻¹ b = c − Σ_j z_j² / d_j: the columns of b give it without solving backwards.
            u[d][j] = a.mul(z[d][j], inverse);
            value = a.sub_mul(u[d][j], z[d][j], value);
        }
    }
    // The minimiser is wanted only with a gradient, which is taken one point at a time.
    if W == 1 {
        for j in (0..N).rev() {
            for d in 0..3 {
                // Lᵀ p = −D⁻¹ L⁻¹ b: u is already D⁻¹ L⁻¹ b, so that only the backward half is left.
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
pub(super) fn factor_any<const W: usize, A: Arithmetic<W>>(
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
    // Right-looking for one point, left-looking in tiles for many: both apply the products of an entry in the order of k, so that
    // the bits agree.
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
    // The inverse pivots of the two columns at hand: set by the first tile of the columns, used by all tiles below it.
    let mut inverse = [bound; 2];
    for j in (0..n).step_by(2) {
        let columns = (n - j).min(2);
        for i in (j..rows).step_by(2) {
            let height = (rows - i).min(2);
            // Both diagonal entries as assembled, before the tile overwrites them. Only the first tile, i = j, reads them.
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
                    // Above the diagonal: no entry of L.
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
