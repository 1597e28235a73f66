//! Bases, quadrature and assembled energies for the laws: written from the formulas, no crate involved.
#![allow(dead_code)] // every test file takes what it needs

use std::f64::consts::FRAC_PI_2;

/// SplitMix64: reproducible numbers for matrices and nets.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in [−1, 1).
    pub(crate) fn signed(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    pub(crate) fn vector(&mut self, length: usize) -> Vec<f64> {
        (0..length).map(|_| self.signed()).collect()
    }

    /// A well-conditioned symmetric positive definite matrix.
    pub(crate) fn spd(&mut self, n: usize) -> Vec<f64> {
        let a = self.vector(n * n);
        let mut q = vec![0.0; n * n];
        for i in 0..n {
            for j in 0..n {
                q[i * n + j] = (0..n).map(|k| a[i * n + k] * a[j * n + k]).sum::<f64>();
            }
            q[i * n + i] += 0.5;
        }
        q
    }
}

/// Gauss–Legendre nodes and weights on [0, 1].
pub(crate) fn gauss(points: usize) -> (Vec<f64>, Vec<f64>) {
    let mut nodes = vec![0.0; points];
    let mut weights = vec![0.0; points];
    for k in 0..points {
        let mut x = (std::f64::consts::PI * (k as f64 + 0.75) / (points as f64 + 0.5)).cos();
        let mut slope = 0.0;
        for _ in 0..100 {
            let (mut p, mut q) = (1.0, 0.0);
            for j in 0..points {
                (p, q) = (((2 * j + 1) as f64 * x * p - j as f64 * q) / (j + 1) as f64, p);
            }
            slope = points as f64 * (x * p - q) / (x * x - 1.0);
            let step = p / slope;
            x -= step;
            if step.abs() < 1e-16 {
                break;
            }
        }
        nodes[k] = (1.0 - x) / 2.0;
        weights[k] = 1.0 / ((1.0 - x * x) * slope * slope);
    }
    (nodes, weights)
}

/// Values and derivatives of the Bernstein basis at t.
pub(crate) fn bernstein(n: usize, t: f64) -> (Vec<f64>, Vec<f64>) {
    let values = |n: usize| {
        let mut b = vec![1.0];
        for k in 1..=n {
            let mut raised = vec![0.0; k + 1];
            for (j, value) in b.iter().enumerate() {
                raised[j] += (1.0 - t) * value;
                raised[j + 1] += t * value;
            }
            b = raised;
        }
        b
    };
    if n == 0 {
        return (vec![1.0], vec![0.0]);
    }
    let lower = values(n - 1);
    let at = |k: isize| if k < 0 || k as usize >= n { 0.0 } else { lower[k as usize] };
    let slopes = (0..=n as isize).map(|k| n as f64 * (at(k - 1) - at(k))).collect();
    (values(n), slopes)
}

/// Values and derivatives of the GT basis as the three constant parts a, b, c of a + θ₁ b + θ₂ c.
pub(crate) fn gt(n: usize, t: f64) -> [(Vec<f64>, Vec<f64>); 3] {
    let (s, c) = ((FRAC_PI_2 * t).sin(), (FRAC_PI_2 * t).cos());
    let (ds, dc) = (FRAC_PI_2 * c, -FRAC_PI_2 * s);
    // Functions of degree 2 and their derivatives: constant, θ₁ and θ₂ part.
    let first = |s: f64| -0.5 * s * (1.0 - s);
    let slope = |s: f64, ds: f64| -0.5 * ds * (1.0 - 2.0 * s);
    let mut parts = [
        (vec![1.0 - s * s, 0.0, 1.0 - c * c], vec![-2.0 * s * ds, 0.0, -2.0 * c * dc]),
        (vec![first(s), -first(s), 0.0], vec![slope(s, ds), -slope(s, ds), 0.0]),
        (vec![0.0, -first(c), first(c)], vec![0.0, -slope(c, dc), slope(c, dc)]),
    ];
    for _ in 3..=n {
        for (values, slopes) in &mut parts {
            let k = values.len();
            let at = |v: &[f64], i: isize| if i < 0 || i as usize >= k { 0.0 } else { v[i as usize] };
            let (old, old_slopes) = (values.clone(), slopes.clone());
            let rows = 0..=k as isize;
            *values = rows.clone().map(|i| (1.0 - t) * at(&old, i) + t * at(&old, i - 1)).collect();
            *slopes = rows
                .map(|i| {
                    (1.0 - t) * at(&old_slopes, i) + t * at(&old_slopes, i - 1) + at(&old, i - 1)
                        - at(&old, i)
                })
                .collect();
        }
    }
    parts
}

/// Rows of the Kronecker product `left ⊗ right` of square matrices, times `factor`, added to `sum`.
pub(crate) fn add_kronecker(sum: &mut [f64], factor: f64, left: &[f64], m: usize, right: &[f64], n: usize) {
    let order = m * n;
    for i in 0..m {
        for k in 0..m {
            for j in 0..n {
                for l in 0..n {
                    sum[(i * n + j) * order + k * n + l] += factor * left[i * m + k] * right[j * n + l];
                }
            }
        }
    }
}

/// Gram matrices ∫φφᵀ and ∫φ'φ'ᵀ of sampled functions (rows: points).
pub(crate) fn gram(weights: &[f64], functions: usize, samples: &[f64]) -> Vec<f64> {
    let mut gram = vec![0.0; functions * functions];
    for (w, row) in weights.iter().zip(samples.chunks_exact(functions)) {
        for i in 0..functions {
            for j in 0..functions {
                gram[i * functions + j] += w * row[i] * row[j];
            }
        }
    }
    gram
}

/// `Σ_d X_dᵀ Q X_d` for three columns.
pub(crate) fn energy(order: usize, matrix: &[f64], x: &[f64]) -> f64 {
    let mut sum = 0.0;
    for i in 0..order {
        for j in 0..order {
            for d in 0..3 {
                sum += matrix[i * order + j] * x[3 * i + d] * x[3 * j + d];
            }
        }
    }
    sum
}

/// The indices 1 … n − 1 of the interior functions of degree n.
pub(crate) fn interior(degree: usize) -> Vec<usize> {
    (1..degree).collect()
}
