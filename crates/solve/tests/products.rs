//! Laws of the solver for sums of products of functions.

mod families;

use families::{Random, add_kronecker, gauss};
use solve::{Place, ProductSystem, ProductTerm, SampledFunctions, SolveError, solve_spd};

const fn term(coefficient: f64, u: (usize, usize), v: (usize, usize)) -> ProductTerm {
    ProductTerm { coefficient, u, v }
}

const DIRICHLET: [ProductTerm; 2] = [term(0.5, (1, 1), (0, 0)), term(0.5, (0, 0), (1, 1))];
const COONS: [ProductTerm; 1] = [term(1.0, (1, 1), (1, 1))];
const BENDING: [ProductTerm; 3] =
    [term(1.0, (2, 2), (0, 0)), term(1.0, (0, 0), (2, 2)), term(2.0, (1, 1), (1, 1))];
const LAPLACIAN: [ProductTerm; 4] = [
    term(1.0, (2, 2), (0, 0)),
    term(1.0, (0, 0), (2, 2)),
    term(1.0, (2, 0), (0, 2)),
    term(1.0, (0, 2), (2, 0)),
];
const ENERGIES: [&[ProductTerm]; 4] = [&DIRICHLET, &COONS, &BENDING, &LAPLACIAN];

/// `P_{k+1} − P_{k−1}` of 2t − 1 for k = 1 … n and two derivatives, times `1 + tilt t`.
fn bubbles(n: usize, nodes: &[f64], tilt: f64) -> SampledFunctions {
    let mut orders = vec![Vec::new(); 3];
    for &t in nodes {
        let x = 2.0 * t - 1.0;
        let (mut p, mut d) = (vec![1.0, x], vec![0.0, 1.0]);
        for k in 2..=n + 1 {
            let kf = k as f64;
            p.push(((2.0 * kf - 1.0) * x * p[k - 1] - (kf - 1.0) * p[k - 2]) / kf);
            d.push(d[k - 2] + (2.0 * kf - 1.0) * p[k - 1]);
        }
        for k in 1..=n {
            let slope = (4 * k + 2) as f64;
            let (f, df, ddf) = (p[k + 1] - p[k - 1], slope * p[k], 2.0 * slope * d[k]);
            let factor = 1.0 + tilt * t;
            orders[0].push(factor * f);
            orders[1].push(factor * df + tilt * f);
            orders[2].push(factor * ddf + 2.0 * tilt * df);
        }
    }
    SampledFunctions { functions: n, orders }
}

/// `∂_u^a ∂_v^b` of the monomial uᵖ v^q.
fn monomial([p, q]: [usize; 2], [a, b]: [usize; 2], u: f64, v: f64) -> f64 {
    let along = |power: usize, order: usize, t: f64| -> f64 {
        if order > power {
            return 0.0;
        }
        let factor: f64 = (0..order).map(|s| (power - s) as f64).product();
        factor * t.powi((power - order) as i32)
    };
    along(p, a, u) * along(q, b, v)
}

fn grid(nodes: &[f64], f: impl Fn(f64, f64) -> [f64; 3]) -> Vec<f64> {
    nodes.iter().flat_map(|&u| nodes.iter().flat_map(|&v| f(u, v)).collect::<Vec<_>>()).collect()
}

/// Coordinates of a fixed part that no energy annihilates.
fn fixed(nodes: &[f64], a: usize, b: usize) -> Vec<f64> {
    grid(nodes, |u, v| {
        let of = |powers| monomial(powers, [a, b], u, v);
        [of([1, 0]) + of([3, 1]), of([0, 1]) - of([2, 3]), of([4, 2]) + 0.3 * of([1, 1])]
    })
}

#[test]
fn conjugate_gradients_agree_with_the_dense_solver() {
    for n in [1, 2, 5, 9] {
        let (nodes, weights) = gauss(n + 8);
        let (f, g) = (bubbles(n, &nodes, 0.0), bubbles(n, &nodes, 0.7));
        let one = [[f.clone(), g.clone()]];
        let two = [[f.clone(), g.clone()], [g, f]];
        for (terms, products) in ENERGIES.iter().flat_map(|&t| [(t, &one[..]), (t, &two[..])]) {
            let system = ProductSystem::new([&weights, &weights], products, terms).unwrap();
            let found = system.solve(|a, b| fixed(&nodes, a, b)).unwrap();
            let order = n * n;
            let (mut matrix, mut rhs) = (vec![0.0; order * order], vec![0.0; 3 * order]);
            let gram = |left: &[f64], right: &[f64]| {
                let mut sum = vec![0.0; n * n];
                for (p, w) in weights.iter().enumerate() {
                    for i in 0..n {
                        for k in 0..n {
                            sum[i * n + k] += w * left[p * n + i] * right[p * n + k];
                        }
                    }
                }
                sum
            };
            for term in terms {
                let values = fixed(&nodes, term.u.1, term.v.1);
                for [f, g] in products {
                    for [other_f, other_g] in products {
                        let left = gram(&f.orders[term.u.0], &other_f.orders[term.u.1]);
                        let right = gram(&g.orders[term.v.0], &other_g.orders[term.v.1]);
                        add_kronecker(&mut matrix, term.coefficient, &left, n, &right, n);
                    }
                    for (k, value) in values.iter().enumerate() {
                        let (p, q, d) = (k / 3 / nodes.len(), k / 3 % nodes.len(), k % 3);
                        for i in 0..n {
                            for j in 0..n {
                                let test = f.orders[term.u.0][p * n + i] * g.orders[term.v.0][q * n + j];
                                rhs[3 * (i * n + j) + d] -=
                                    term.coefficient * weights[p] * weights[q] * test * value;
                            }
                        }
                    }
                }
            }
            let dense = solve_spd(order, &matrix, 3, &rhs).unwrap();
            let size = dense.x.iter().fold(0.0f64, |a, x| a.max(x.abs()));
            for (a, b) in found.x.iter().zip(&dense.x) {
                assert!((a - b).abs() < 1e-11 * size, "{n} functions, {terms:?}: {a} {b}");
            }
            assert!(found.residual < 30.0 && found.steps <= 25, "{found:?}");
            assert!((1.0..50.0).contains(&found.condition), "{found:?}");
        }
    }
}

#[test]
fn a_harmonic_polynomial_is_found_again_at_every_degree() {
    // Re (u + iv)^5 has no Laplacian defect; the fixed part is that and a function that vanishes on the border.
    let harmonic = [([5, 0], 1.0), ([3, 2], -10.0), ([1, 4], 5.0)];
    for n in [6, 15, 30, 63] {
        let (nodes, weights) = gauss(n + 18);
        let f = bubbles(n, &nodes, 0.0);
        let system = ProductSystem::new([&weights, &weights], &[[f.clone(), f.clone()]], &LAPLACIAN).unwrap();
        let bump = |[a, b]: [usize; 2], u: f64, v: f64| {
            // (u − u⁴)(v² − v³)
            [([1, 2], 1.0), ([1, 3], -1.0), ([4, 2], -1.0), ([4, 3], 1.0)]
                .map(|(powers, c)| c * monomial(powers, [a, b], u, v))
                .iter()
                .sum::<f64>()
        };
        let found = system
            .solve(|a, b| {
                grid(&nodes, |u, v| {
                    let exact: f64 =
                        harmonic.map(|(powers, c)| c * monomial(powers, [a, b], u, v)).iter().sum();
                    [
                        exact + bump([a, b], u, v),
                        monomial([1, 0], [a, b], u, v),
                        1e-8 * (exact + bump([a, b], u, v)),
                    ]
                })
            })
            .unwrap();
        let mut worst = [0.0f64; 3];
        for (p, &u) in nodes.iter().enumerate() {
            for (q, &v) in nodes.iter().enumerate() {
                let mut sum = [0.0; 3];
                for i in 0..n {
                    for j in 0..n {
                        let product = f.orders[0][p * n + i] * f.orders[0][q * n + j];
                        (0..3).for_each(|d| sum[d] += product * found.x[3 * (i * n + j) + d]);
                    }
                }
                let bump = bump([0, 0], u, v);
                let wrong = [sum[0] + bump, sum[1], sum[2] + 1e-8 * bump];
                (0..3).for_each(|d| worst[d] = worst[d].max(wrong[d].abs()));
            }
        }
        // A coordinate that is small beside the others keeps its own digits.
        assert!(worst[0] < 1e-13 && worst[1] == 0.0 && worst[2] < 1e-21, "{n} functions: {worst:?}");
        assert!(
            found.steps <= 15 && found.residual < 30.0 && found.condition < 4.0,
            "{n} functions: {found:?}"
        );
    }
}

#[test]
fn nothing_to_do_is_done() {
    let (nodes, weights) = gauss(5);
    let f = bubbles(3, &nodes, 0.0);
    let system = ProductSystem::new([&weights, &weights], &[[f.clone(), f.clone()]], &BENDING).unwrap();
    assert_eq!(system.free(), 9);
    let found = system.solve(|_, _| vec![0.0; 75]).unwrap();
    assert!(found.x.iter().all(|x| *x == 0.0) && found.residual == 0.0 && found.steps == 0);
    // Degree 1 in one direction: no functions.
    let none = bubbles(0, &nodes, 0.0);
    let system = ProductSystem::new([&weights, &weights], &[[none, f]], &BENDING).unwrap();
    assert!(system.solve(|_, _| vec![1.0; 75]).unwrap().x.is_empty());
}

#[test]
fn what_cannot_be_solved_is_named() {
    let (nodes, weights) = gauss(6);
    let f = bubbles(3, &nodes, 0.0);
    let new = |weights: [&[f64]; 2], f: &SampledFunctions| {
        ProductSystem::new(weights, &[[f.clone(), f.clone()]], &BENDING).err()
    };
    let mut twice = f.clone();
    for samples in &mut twice.orders {
        samples.chunks_exact_mut(3).for_each(|row| row[2] = row[0]);
    }
    let dependent = new([&weights, &weights], &twice);
    assert!(
        matches!(dependent, Some(SolveError::NotPositiveDefinite { pivot: Some(2), .. })),
        "{dependent:?}"
    );
    let mut short = f.clone();
    short.orders.pop();
    assert!(matches!(new([&weights, &weights], &short), Some(SolveError::WrongShape { .. })));
    assert!(matches!(new([&weights[1..], &weights], &f), Some(SolveError::WrongShape { .. })));
    let mut nan = f.clone();
    nan.orders[1][0] = f64::NAN;
    let refused = new([&weights, &weights], &nan);
    assert!(matches!(refused, Some(SolveError::NotFinite { place: Place::Matrix, .. })), "{refused:?}");
    let system = ProductSystem::new([&weights, &weights], &[[f.clone(), f.clone()]], &BENDING).unwrap();
    assert!(matches!(system.solve(|_, _| vec![0.0; 3]), Err(SolveError::WrongShape { .. })));
    let refused = system.solve(|_, _| vec![f64::INFINITY; 108]);
    assert!(matches!(refused, Err(SolveError::NotFinite { place: Place::RightHandSide, .. })));
    // An energy with a negative part: its diagonal is not positive.
    let saddle = [term(1.0, (1, 1), (0, 0)), term(-1.0, (0, 0), (1, 1))];
    let refused = ProductSystem::new([&weights, &weights], &[[f.clone(), f.clone()]], &saddle).err();
    assert!(matches!(refused, Some(SolveError::NotPositiveDefinite { .. })), "{refused:?}");
}

#[test]
fn random_starts_end_in_the_same_minimum() {
    // The fixed part moved by functions that are free: S is the same.
    let mut random = Random(5);
    let n = 12;
    let (nodes, weights) = gauss(n + 18);
    let f = bubbles(n, &nodes, 0.0);
    let system = ProductSystem::new([&weights, &weights], &[[f.clone(), f.clone()]], &BENDING).unwrap();
    let first = system.solve(|a, b| fixed(&nodes, a, b)).unwrap().x;
    let moved = random.vector(3 * n * n);
    let second = system
        .solve(|a, b| {
            let mut values = fixed(&nodes, a, b);
            for p in 0..nodes.len() {
                for q in 0..nodes.len() {
                    for i in 0..n {
                        for j in 0..n {
                            let product = f.orders[a][p * n + i] * f.orders[b][q * n + j];
                            let (to, from) = (3 * (p * nodes.len() + q), 3 * (i * n + j));
                            (0..3).for_each(|d| values[to + d] += product * moved[from + d]);
                        }
                    }
                }
            }
            values
        })
        .unwrap()
        .x;
    for ((a, b), c) in first.iter().zip(&second).zip(&moved) {
        assert!((a - (b + c)).abs() < 1e-11, "{a} {b} {c}");
    }
}
