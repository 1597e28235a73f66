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

/// Gauss points and weights, and the values and derivatives of the GT basis at them: three constant parts.
pub(crate) struct GtSamples {
    pub(crate) points: usize,
    pub(crate) functions: usize,
    pub(crate) weights: Vec<f64>,
    pub(crate) values: [Vec<f64>; 3],
    pub(crate) derivatives: [Vec<f64>; 3],
}

impl GtSamples {
    pub(crate) fn new(degree: usize) -> Self {
        let points = degree + 14;
        let (nodes, weights) = gauss(points);
        let mut samples = Self {
            points,
            functions: degree + 1,
            weights,
            values: Default::default(),
            derivatives: Default::default(),
        };
        for t in nodes {
            for (k, (values, derivatives)) in gt(degree, t).into_iter().enumerate() {
                samples.values[k].extend(values);
                samples.derivatives[k].extend(derivatives);
            }
        }
        samples
    }

    /// The samples at one parameter.
    pub(crate) fn at(&self, theta: [f64; 2]) -> (Vec<f64>, Vec<f64>) {
        let mix = |parts: &[Vec<f64>; 3]| {
            (0..parts[0].len())
                .map(|k| parts[0][k] + theta[0] * parts[1][k] + theta[1] * parts[2][k])
                .collect()
        };
        (mix(&self.values), mix(&self.derivatives))
    }

    /// The Gram matrices of derivatives and of values as quadratic polynomials: coefficients of 1, θ₁, θ₂, θ₁², …
    pub(crate) fn grams(&self) -> [[Vec<f64>; 6]; 2] {
        [&self.derivatives, &self.values].map(|parts| {
            let product = |p: usize, q: usize| -> Vec<f64> {
                let n = self.functions;
                let mut sum = vec![0.0; n * n];
                for (k, w) in self.weights.iter().enumerate() {
                    for i in 0..n {
                        for j in 0..n {
                            let (a, b) = (&parts[p][k * n..(k + 1) * n], &parts[q][k * n..(k + 1) * n]);
                            sum[i * n + j] += w * (a[i] * b[j] + if p == q { 0.0 } else { a[j] * b[i] });
                        }
                    }
                }
                sum
            };
            [product(0, 0), product(0, 1), product(0, 2), product(1, 1), product(1, 2), product(2, 2)]
        })
    }
}

/// The Dirichlet problem ½(K⊗M + M⊗K) of a GT net of m × n degrees, the interior free.
pub(crate) fn gt_dirichlet(degrees: [usize; 2], values: Vec<f64>) -> solve::ParametricProblem {
    let matrices = |degree: usize| -> Vec<solve::PolynomialMatrix> {
        let size = degree + 1;
        let grams = GtSamples::new(degree).grams();
        grams
            .into_iter()
            .map(|coefficients| solve::PolynomialMatrix { rows: size, cols: size, coefficients })
            .collect()
    };
    solve::ParametricProblem {
        left: matrices(degrees[0]),
        right: matrices(degrees[1]),
        terms: vec![
            solve::Term { coefficient: 0.5, left: 0, right: 1 },
            solve::Term { coefficient: 0.5, left: 1, right: 0 },
        ],
        free_left: interior(degrees[0]),
        free_right: interior(degrees[1]),
        values,
    }
}

/// The net of GT Example 5.1, with P₃₀ = (0, 6, 0); interior points are not given.
pub(crate) fn example_5_1() -> Vec<f64> {
    let mut net = vec![f64::NAN; 48];
    let mut put =
        |i: usize, j: usize, p: [f64; 3]| net[3 * (4 * i + j)..3 * (4 * i + j) + 3].copy_from_slice(&p);
    for (k, (at, height)) in [(0.0, 0.0), (2.0, 2.0), (4.0, -2.0), (6.0, 0.0)].into_iter().enumerate() {
        put(0, k, [at, 0.0, height]);
        put(3, k, [at, 6.0, height]);
        put(k, 0, [0.0, at, height]);
        put(k, 3, [6.0, at, height]);
    }
    net
}

/// A net that follows a smooth surface with a little noise: boundary data of every size of energy.
pub(crate) fn smooth_net(random: &mut Random, degrees: [usize; 2]) -> Vec<f64> {
    let [m, n] = degrees;
    let mut net = Vec::new();
    for i in 0..=m {
        for j in 0..=n {
            let (u, v) = (i as f64 / m as f64, j as f64 / n as f64);
            net.extend([
                u + 0.1 * random.signed(),
                v + 0.1 * random.signed(),
                (3.0 * u).sin() * v + 0.1 * random.signed(),
            ]);
        }
    }
    net
}

/// The Bernstein basis of a degree at `degree + 1` Gauss points, exact for products of its functions.
pub(crate) fn bernstein_samples(degree: usize) -> solve::Samples {
    let (nodes, weights) = gauss(degree + 1);
    let (mut values, mut derivatives) = (Vec::new(), Vec::new());
    for t in nodes {
        let (value, derivative) = bernstein(degree, t);
        values.extend(value);
        derivatives.extend(derivative);
    }
    solve::Samples { points: degree + 1, functions: degree + 1, weights, values, derivatives }
}

/// The samples of a GT basis, as the separable solver takes them.
pub(crate) fn gt_samples(degree: usize) -> solve::AffineSamples {
    let GtSamples { points, functions, weights, values, derivatives } = GtSamples::new(degree);
    solve::AffineSamples { points, functions, weights, values, derivatives }
}

/// Bernstein control points of degree `degree` of the Taylor polynomial `Σ a_k t^k`.
///
/// `c_i = Σ_k C(i,k)/C(n,k) a_k`: the weights lie between 0 and 1, so for a_k like 1/k! no digit is lost.
pub(crate) fn bernstein_points(degree: usize, coefficient: impl Fn(usize) -> f64) -> Vec<f64> {
    (0..=degree)
        .map(|i| {
            let mut weight = 1.0;
            let mut sum = 0.0;
            for k in 0..=i {
                sum += weight * coefficient(k);
                weight *= (i - k) as f64 / (degree - k).max(1) as f64;
            }
            sum
        })
        .collect()
}

/// The net (x, y, eˣ cos y) of degree n × n over the unit square, u along x: its boundary is exact to rounding, its
/// interior is not given.
pub(crate) fn exponential_net(degree: usize) -> Vec<f64> {
    let factorial = |k: usize| (1..=k).map(|j| j as f64).product::<f64>();
    let exponential = bernstein_points(degree, |k| 1.0 / factorial(k));
    let cosine = bernstein_points(degree, |k| match k % 4 {
        0 => 1.0 / factorial(k),
        2 => -1.0 / factorial(k),
        _ => 0.0,
    });
    let mut net = Vec::new();
    for i in 0..=degree {
        for j in 0..=degree {
            let inner = (1..degree).contains(&i) && (1..degree).contains(&j);
            let point = [i as f64 / degree as f64, j as f64 / degree as f64, exponential[i] * cosine[j]];
            net.extend(if inner { [f64::NAN; 3] } else { point });
        }
    }
    net
}

/// The point of a Bernstein patch of degree n × n.
pub(crate) fn bernstein_patch(degree: usize, net: &[f64], s: f64, t: f64) -> [f64; 3] {
    let ((u, _), (v, _)) = (bernstein(degree, s), bernstein(degree, t));
    let mut point = [0.0; 3];
    for i in 0..=degree {
        for j in 0..=degree {
            (0..3).for_each(|d| point[d] += u[i] * v[j] * net[3 * (i * (degree + 1) + j) + d]);
        }
    }
    point
}
