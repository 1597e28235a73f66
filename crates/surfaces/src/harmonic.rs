//! The linear relations of the control nets of harmonic Bézier patches (GT §6, corrected).

/// One relation `Σ weight · P_point = 0`, points numbered row by row.
pub type Relation = Vec<(usize, f64)>;

/// The relations that a Bernstein–Bézier net of bidegree (m, n) satisfies exactly if its patch is harmonic, one for each
/// 0 ≤ i ≤ m, 0 ≤ j ≤ n (GT (6.5)):
///
/// `a_i Δ²⁰P_ij + b_{i−1} Δ²⁰P_{i−1,j} + c_{i−2} Δ²⁰P_{i−2,j} + (the same in j) = 0` with `a_k = (d−k)(d−k−1)`,
/// `b_k = 2(k+1)(d−k−1)`, `c_k = (k+1)(k+2)`, d the degree of that direction, and second differences that reach outside the net
/// taken as 0. The factors m(m−1), n(n−1) printed before the two brackets must be dropped: a, b, c already hold them.
///
/// The left sides are the coefficients of `S_uu + S_vv` in the Bernstein basis of bidegree (m, n).
pub fn harmonic_relations(m: usize, n: usize) -> Vec<Relation> {
    let mut relations = Vec::with_capacity((m + 1) * (n + 1));
    for i in 0..=m {
        for j in 0..=n {
            let mut weights = vec![0.0; (m + 1) * (n + 1)];
            for (k, w) in second_derivative(m, i) {
                weights[k * (n + 1) + j] += w;
            }
            for (k, w) in second_derivative(n, j) {
                weights[i * (n + 1) + k] += w;
            }
            relations.push(weights.into_iter().enumerate().filter(|(_, w)| *w != 0.0).collect());
        }
    }
    relations
}

/// The i-th coefficient, in the basis of the same degree d, of the second derivative of `Σ P_k B_{k,d}`, as weights of the
/// P_k.
fn second_derivative(d: usize, i: usize) -> Vec<(usize, f64)> {
    let mut weights = Vec::new();
    for back in 0..=2 {
        // The second difference at k = i − back, if it lies in the net.
        let Some(k) = i.checked_sub(back).filter(|k| k + 2 <= d) else { continue };
        let (kf, df) = (k as f64, d as f64);
        let factor = match back {
            0 => (df - kf) * (df - kf - 1.0),
            1 => 2.0 * (kf + 1.0) * (df - kf - 1.0),
            _ => (kf + 1.0) * (kf + 2.0),
        };
        weights.extend([(k, factor), (k + 1, -2.0 * factor), (k + 2, factor)]);
    }
    weights
}
