//! The gradient that comes with a solve is the derivative of the reduced energy: for both solvers, and for every form
//! that the energies hand to them. Errors are relative to J, whose rounding is what limits a difference.

use energy::Functional;
use plateau::ReducedEnergy;
use plateau_benches::{gt_dirichlet, separable_parametric};
use proptest::prelude::*;
use solve::Path;
use surfaces::{Net, Point, ShapedFamily};

/// A boundary over [0, m] × [0, n] whose points are moved by `noise`, one number a coordinate, used in turn.
fn net(m: usize, n: usize, noise: &[f64]) -> Net {
    let mut moves = noise.iter().cycle();
    let mut next = || *moves.next().unwrap();
    let points: Vec<Point> = (0..(m + 1) * (n + 1))
        .map(|k| {
            let (i, j) = ((k / (n + 1)) as f64, (k % (n + 1)) as f64);
            Point::new(i + 0.3 * next(), j + 0.3 * next(), next())
        })
        .collect();
    let at = |i: usize, j: usize| points[i * (n + 1) + j];
    let row = |i: usize| (0..=n).map(|j| at(i, j)).collect::<Vec<_>>();
    let column = |j: usize| (0..=m).map(|i| at(i, j)).collect::<Vec<_>>();
    Net::from_boundary(&row(0), &row(m), &column(0), &column(n)).unwrap()
}

/// Steps of the differences: wide enough that rounding in J weighs little.
const STEP: f64 = 2e-3;

/// `f'(x_k)` by the difference of fourth order.
fn difference(f: impl Fn(&[f64; 4]) -> f64, x: &[f64; 4], k: usize) -> f64 {
    let at = |steps: f64| {
        let mut moved = *x;
        moved[k] += steps * STEP;
        f(&moved)
    };
    (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * STEP)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn of_gram_polynomials(
        (m, n) in (2usize..7, 2usize..7),
        noise in prop::collection::vec(-1.0..1.0f64, 60),
        shape in prop::array::uniform4(0.6..3.4f64),
        functional in prop::sample::select(vec![
            Functional::Dirichlet, Functional::Laplacian, Functional::Bending, Functional::Coons,
        ]),
        patch in prop::sample::select(vec![ShapedFamily::Gt, ShapedFamily::TbCoons]),
    ) {
        let net = net(m, n, &noise);
        let parametric = ReducedEnergy::new(functional, patch, &net).unwrap().system().clone();
        // With nothing solved for, the energy of the boundary alone: the number that J is a difference from. Energies of
        // second derivatives cancel several digits of it.
        let boundary = ReducedEnergy::new(functional, patch, &net.with_all_fixed()).unwrap();
        let boundary = boundary.system().value(&shape);
        for path in [Path::Portable, Path::detect()] {
            let parametric = parametric.clone().with_path(path).unwrap();
            let mut gradient = [0.0; 4];
            let value = parametric.value_and_gradient(&shape, &mut gradient);
            let tolerance = 1e-9 * value.abs() + 4.0 * f64::EPSILON * boundary / STEP;
            for k in 0..4 {
                let known = difference(|x| parametric.value(x), &shape, k);
                prop_assert!((gradient[k] - known).abs() <= tolerance, "{k}: {} {known} {value}", gradient[k]);
            }
        }
    }

    #[test]
    fn of_samples(
        (m, n) in (2usize..21, 2usize..21),
        noise in prop::collection::vec(-1.0..1.0f64, 240),
        shape in prop::array::uniform4(0.6..3.4f64),
    ) {
        let system = separable_parametric(&net(m, n, &noise)).unwrap();
        let mut gradient = [0.0; 4];
        let value = system.value_and_gradient(&shape, &mut gradient);
        for k in 0..4 {
            let known = difference(|x| system.value(x), &shape, k);
            prop_assert!((gradient[k] - known).abs() <= 1e-10 * value, "{k}: {} {known} {value}", gradient[k]);
        }
    }

    #[test]
    fn both_solvers_see_the_same_energy(
        (m, n) in (2usize..9, 2usize..9),
        noise in prop::collection::vec(-1.0..1.0f64, 60),
        shape in prop::array::uniform4(0.6..3.4f64),
    ) {
        let net = net(m, n, &noise);
        let by_tables = gt_dirichlet(&net).unwrap().system().value(&shape);
        let by_samples = separable_parametric(&net).unwrap().value(&shape);
        prop_assert!((by_tables - by_samples).abs() <= 1e-9 * by_samples, "{by_tables} {by_samples}");
    }
}
