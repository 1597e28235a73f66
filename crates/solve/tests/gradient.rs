//! The envelope gradient ∂J/∂θ, which comes with the solve, against differences of J in 31 digits: J assembled, solved and
//! differenced apart from the crate.
//!
//! The figure: `cargo test --release -p plateau-solve --test gradient -- --nocapture`.
#![allow(clippy::print_stdout, reason = "the figure is the point")]

#[path = "../../bases/tests/extended/mod.rs"]
mod extended;
mod families;

use extended::{Extended, ZERO};
use families::{Random, gauss, gt_dirichlet, gt_samples, interior, smooth_net};
use solve::{Parametric, Path, SeparableParametric};

type Square = Vec<Vec<Extended>>;

/// ∫φ'φ'ᵀ and ∫φφᵀ of the GT functions, by the rule that the families of these tests use.
fn grams(degree: usize, theta: [f64; 2]) -> [Square; 2] {
    let (nodes, weights) = gauss(degree + 14);
    let mut grams = [vec![vec![ZERO; degree + 1]; degree + 1], vec![vec![ZERO; degree + 1]; degree + 1]];
    for (t, w) in nodes.into_iter().zip(weights) {
        let table = extended::gt(degree, theta, t).pop().unwrap();
        for (gram, r) in grams.iter_mut().zip([1, 0]) {
            for i in 0..=degree {
                for j in 0..=degree {
                    gram[i][j] = gram[i][j] + Extended::of(w) * table[i][r] * table[j][r];
                }
            }
        }
    }
    grams
}

/// `J = c − Σ_d b_dᵀ Q_ff⁻¹ b_d` of the Dirichlet energy, by Gauss elimination.
fn reduced([m, n]: [usize; 2], shape: [f64; 4], net: &[f64]) -> Extended {
    let ([ku, mu], [kv, mv]) = (grams(m, [shape[0], shape[1]]), grams(n, [shape[2], shape[3]]));
    let half = Extended::of(0.5);
    let q = |p: usize, r: usize| {
        let ([i, j], [k, l]) = ([p / (n + 1), p % (n + 1)], [r / (n + 1), r % (n + 1)]);
        half * (ku[i][k] * mv[j][l] + mu[i][k] * kv[j][l])
    };
    let all = 0..(m + 1) * (n + 1);
    let is_free = |p: usize| (1..m).contains(&(p / (n + 1))) && (1..n).contains(&(p % (n + 1)));
    let (free, fixed): (Vec<usize>, Vec<usize>) = all.partition(|&p| is_free(p));
    let value = |p: usize, d: usize| Extended::of(net[3 * p + d]);
    let mut a: Square = free.iter().map(|&p| free.iter().map(|&r| q(p, r)).collect()).collect();
    let mut b: Square = (0..3)
        .map(|d| free.iter().map(|&p| fixed.iter().fold(ZERO, |s, &r| s + q(p, r) * value(r, d))).collect())
        .collect();
    let mut j = ZERO;
    for d in 0..3 {
        for &p in &fixed {
            for &r in &fixed {
                j = j + value(p, d) * q(p, r) * value(r, d);
            }
        }
    }
    // Elimination leaves b = L⁻¹ b and the pivots: bᵀ Q⁻¹ b = Σ b²/pivot.
    for k in 0..free.len() {
        for i in k + 1..free.len() {
            let factor = a[i][k] / a[k][k];
            for l in k..free.len() {
                a[i][l] = a[i][l] - factor * a[k][l];
            }
            for b in &mut b {
                b[i] = b[i] - factor * b[k];
            }
        }
        for b in &b {
            j = j - b[k] * b[k] / a[k][k];
        }
    }
    j
}

#[test]
fn the_envelope_gradient_is_the_derivative() {
    // At this step the difference is in error by h² = 3.6e-15, rounding by 1e-23.
    const STEP: f64 = 1.0 / (1u64 << 24) as f64;
    let mut random = Random(1);
    let mut largest = [0.0f64; 2];
    for degrees @ [m, n] in [[2, 2], [2, 4], [3, 3], [3, 5], [4, 4], [5, 5], [6, 4]] {
        let mut worst = [0.0f64; 2];
        for _ in 0..3 {
            let net = smooth_net(&mut random, degrees);
            // On a grid, so that shapes a step away are exact.
            let shape: [f64; 4] =
                [0.0; 4].map(|_: f64| 2.0 + (1.5 * random.signed() * 1024.0).round() / 1024.0);
            let known: Vec<f64> = (0..4)
                .map(|k| {
                    let at = |step: f64| {
                        let mut moved = shape;
                        moved[k] += step;
                        reduced(degrees, moved, &net)
                    };
                    ((at(STEP) - at(-STEP)) / Extended::of(2.0 * STEP)).value()
                })
                .collect();
            let size = known.iter().fold(0.0f64, |s, g| s.max(g.abs()));
            let error = |found: [f64; 4]| {
                known.iter().zip(found).fold(0.0f64, |e, (known, found)| e.max((found - known).abs() / size))
            };
            let value = reduced(degrees, shape, &net).value();
            let tables = Parametric::new(&gt_dirichlet(degrees, net.clone())).unwrap();
            for path in [Path::Portable, Path::detect()] {
                let mut found = [0.0; 4];
                let j = tables.clone().with_path(path).unwrap().value_and_gradient(&shape, &mut found);
                assert!((j - value).abs() <= 1e-11 * value, "{j} {value}");
                worst[0] = worst[0].max(error(found));
            }
            let samples =
                SeparableParametric::new(gt_samples(m), gt_samples(n), &interior(m), &interior(n), &net)
                    .unwrap();
            let mut found = [0.0; 4];
            samples.value_and_gradient(&shape, &mut found);
            worst[1] = worst[1].max(error(found));
        }
        println!(
            "degrees {m} x {n}: gradient by tables {:.1e}, by samples {:.1e} relatively",
            worst[0], worst[1]
        );
        (0..2).for_each(|k| largest[k] = largest[k].max(worst[k]));
    }
    assert!(largest.iter().all(|e| *e <= 1e-11), "{largest:?}");
}
