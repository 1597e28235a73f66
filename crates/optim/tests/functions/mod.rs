//! Functions with known minima, the usual ones of global optimisation; every minimum is 0.
#![allow(dead_code)] // each test file uses some of them

use libm::{cos, exp};
use optim::Bounds;
use std::f64::consts::{E, TAU};

/// Name, function, cube.
pub(crate) type Problem = (&'static str, fn(&[f64]) -> f64, [f64; 2]);

pub(crate) const PROBLEMS: [Problem; 5] = [
    ("sphere", sphere, [-5.0, 5.0]),
    ("Rosenbrock", rosenbrock, [-2.0, 2.0]),
    ("Rastrigin", rastrigin, [-5.12, 5.12]),
    ("Ackley", ackley, [-30.0, 30.0]),
    ("Griewank", griewank, [-100.0, 100.0]),
];

pub(crate) fn cube(dimension: usize, [lower, upper]: [f64; 2]) -> Bounds {
    Bounds::cube(dimension, lower, upper).expect("a cube")
}

pub(crate) fn sphere(x: &[f64]) -> f64 {
    x.iter().map(|x| x * x).sum()
}

pub(crate) fn rosenbrock(x: &[f64]) -> f64 {
    let terms = x.windows(2).map(|w| {
        let (a, b) = (1.0 - w[0], w[1] - w[0] * w[0]);
        a * a + 100.0 * b * b
    });
    terms.sum()
}

pub(crate) fn rastrigin(x: &[f64]) -> f64 {
    x.iter().map(|x| x * x + 10.0 * (1.0 - cos(TAU * x))).sum()
}

pub(crate) fn ackley(x: &[f64]) -> f64 {
    let n = x.len() as f64;
    let root = (sphere(x) / n).sqrt();
    let wave = x.iter().map(|x| cos(TAU * x)).sum::<f64>() / n;
    20.0 * (1.0 - exp(-0.2 * root)) + E - exp(wave)
}

pub(crate) fn griewank(x: &[f64]) -> f64 {
    let wave: f64 = (1..).zip(x).map(|(i, x)| cos(x / f64::from(i).sqrt())).product();
    1.0 + sphere(x) / 4000.0 - wave
}

pub(crate) fn rosenbrock_with_gradient(x: &[f64], gradient: &mut [f64]) -> f64 {
    gradient.fill(0.0);
    for i in 0..x.len() - 1 {
        let (a, b) = (1.0 - x[i], x[i + 1] - x[i] * x[i]);
        gradient[i] -= 2.0 * a + 400.0 * b * x[i];
        gradient[i + 1] += 200.0 * b;
    }
    rosenbrock(x)
}
