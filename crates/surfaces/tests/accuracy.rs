//! Errors of the triangular Bernstein polynomials in u = 2⁻⁵³ against references of 31 digits.
//!
//! The table with 10⁴ points a degree: `cargo test --release -p plateau-surfaces --test accuracy -- --ignored --nocapture`.
#![allow(clippy::print_stdout, reason = "the table is the point")]

#[path = "../../bases/tests/extended/mod.rs"]
mod extended;

use extended::{Extended, ONE, ZERO, exact_sum};
use surfaces::TriangleBasis;

const U: f64 = f64::EPSILON / 2.0;

/// `n!/(i! j! k!) uⁱ vʲ wᵏ` with its derivatives u, v, uu, uv, vv at the exact w = 1 − u − v.
fn polynomial([i, j, k]: [usize; 3], u: f64, v: f64) -> [Extended; 6] {
    let choose = |n: usize, k: usize| (1..=k).fold(1u128, |c, s| c * (n + 1 - s) as u128 / s as u128);
    let factor = Extended::integer(choose(i + j + k, i) * choose(j + k, j));
    let w = exact_sum(1.0, -u) + Extended::of(-v);
    let (u, v) = (Extended::of(u), Extended::of(v));
    // The r-th derivative of x^m by x.
    let power = |x: Extended, m: usize, r: usize| {
        if r > m {
            ZERO
        } else {
            Extended::integer((m - r + 1..=m).product::<usize>() as u128) * x.powi(m - r)
        }
    };
    let term = |a: usize, b: usize, c: usize| factor * power(u, i, a) * power(v, j, b) * power(w, k, c);
    let two = Extended::of(2.0);
    [
        term(0, 0, 0),
        term(1, 0, 0) - term(0, 0, 1),
        term(0, 1, 0) - term(0, 0, 1),
        term(2, 0, 0) - two * term(1, 0, 1) + term(0, 0, 2),
        term(1, 1, 0) - term(1, 0, 1) - term(0, 1, 1) + term(0, 0, 2),
        term(0, 2, 0) - two * term(0, 1, 1) + term(0, 0, 2),
    ]
}

fn table(points: usize) {
    println!(
        "{:<24}{:>8}{:>9}{:>9}{:>9}{:>9}",
        "errors in u = 2^-53", "points", "value", "first", "second", "sum - 1"
    );
    for n in 1..=20usize {
        let basis = TriangleBasis::new(n).unwrap();
        let mut worst = [0.0f64; 3];
        let mut sums = 0.0f64;
        for k in 0..points {
            let fill = |k: usize, step: f64| (0.5 + k as f64 * step).fract();
            let (mut u, mut v) = (fill(k, 0.754_877_666_246_692_7), fill(k, 0.569_840_290_998_053_2));
            if u + v > 1.0 {
                (u, v) = (1.0 - u, 1.0 - v);
            }
            if k % 16 == 0 {
                u *= 1e-6;
            }
            let ours = basis.evaluate(u, v, 2);
            let exact: Vec<[Extended; 6]> = basis.indices().map(|index| polynomial(index, u, v)).collect();
            for r in 0..6 {
                let order = [0, 1, 1, 2, 2, 2][r];
                let scale = if r == 0 { 1.0 } else { exact.iter().fold(0.0f64, |m, b| m.max(b[r].hi.abs())) };
                for (ours, exact) in ours.row(r).iter().zip(&exact) {
                    let error = exact[r].distance(*ours);
                    worst[order] = worst[order].max(if error == 0.0 { 0.0 } else { error / scale / U });
                }
            }
            let sum = ours.row(0).iter().fold(ZERO, |sum, &b| sum + Extended::of(b));
            sums = sums.max((sum - ONE).value().abs() / U);
        }
        println!(
            "{:<24}{points:>8}{:>9.2}{:>9.2}{:>9.2}{sums:>9.2}",
            format!("triangular, degree {n}"),
            worst[0],
            worst[1],
            worst[2]
        );
        assert!(
            worst[0] <= 8.0 && worst[1] <= 80.0 && worst[2] <= 80.0 && sums <= 8.0,
            "{n}: {worst:?} {sums}"
        );
    }
}

#[test]
fn triangular_polynomials_within_8u() {
    table(100);
}

#[test]
#[ignore = "half a minute: the whole table"]
fn the_whole_table() {
    table(10_000);
}
