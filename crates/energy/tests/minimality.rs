//! The extremal has the least energy of all nets over its boundary, and the area is never above the Dirichlet energy.
#![allow(clippy::print_stdout, reason = "figures worth seeing with --nocapture")]

mod extremals;

use std::sync::atomic::{AtomicU64, Ordering};

use bases::Matrix;
use energy::{DenseForm, Functional, QuadraticForm, area, integrate};
use extremals::{Random, extremal, separated, triangle_extremal};
use surfaces::{Helicoid, Net, Patch, Point, TensorPatch, TrapeziumHelicoid, TriangleNet, TrianglePatch};

const U: f64 = f64::EPSILON / 2.0;

/// What a form has to offer here.
struct Energy<'a> {
    value: &'a dyn Fn(&[f64]) -> f64,
    gradient: &'a dyn Fn(&[f64]) -> Vec<f64>,
    norm: f64,
}

fn norm(matrix: &Matrix) -> f64 {
    (0..matrix.rows()).map(|i| matrix.row(i).iter().map(|a| a.abs()).sum::<f64>()).fold(0.0, f64::max)
}

/// A thousand nets over the same boundary, near and far: none below, but for rounding; and the gradient vanishes.
fn check(name: &str, random: &mut Random, energy: &Energy<'_>, fixed: &[bool], x: &[f64]) {
    let least = (energy.value)(x);
    let points = fixed.len();
    let free: Vec<usize> = (0..points).filter(|&k| !fixed[k]).collect();
    let (mut lowest, mut strict) = (f64::INFINITY, 0);
    for k in 0..1000 {
        let size = 10f64.powi(-(k % 10));
        let mut other = x.to_vec();
        for &i in &free {
            (0..3).for_each(|d| other[3 * i + d] += size * random.signed());
        }
        let value = (energy.value)(&other);
        lowest = lowest.min((value - least) / least);
        strict += usize::from(value > least);
        assert!(value >= least * (1.0 - 30.0 * points as f64 * U), "{name}: {value} below {least}");
        // From a distance of 1e-5 on nothing is left to rounding.
        assert!(size < 5e-6 || value > least, "{name}: {value} not above {least} at distance {size}");
    }
    let gradient = (energy.gradient)(x);
    let largest = |v: &mut dyn Iterator<Item = f64>| v.fold(0.0f64, |m, a| m.max(a.abs()));
    let slope = largest(&mut free.iter().flat_map(|&i| [0, 1, 2].map(|d| gradient[3 * i + d])))
        / (energy.norm * largest(&mut x.iter().copied()));
    println!(
        "{name:<26} lowest {lowest:>9.1e} relative to D, {strict} of 1000 above, gradient {slope:.1e} |A||X|"
    );
    assert!(slope <= 1e-12, "{name}: gradient {slope:e}");
}

#[test]
fn no_net_over_the_same_boundary_has_less_energy() {
    let mut random = Random(1);
    let of_tensor = |name: &str, random: &mut Random, patch: &TensorPatch| {
        let form = QuadraticForm::of(Functional::Dirichlet, patch).unwrap();
        let (value, gradient) = (|x: &[f64]| form.value(x), |x: &[f64]| form.gradient(x));
        let energy = Energy { value: &value, gradient: &gradient, norm: norm(&form.matrix()) };
        check(name, random, &energy, patch.net().fixed(), &patch.net().coordinates());
    };
    for kind in ["Bernstein", "GT", "TB-Coons"] {
        for n in [3, 5, 8] {
            let patch = extremal(Functional::Dirichlet, &random.patch(kind, n));
            of_tensor(&format!("{kind}, degree {n}"), &mut random, &patch);
        }
    }
    for kind in ["Bernstein", "GT"] {
        let patch = separated(&random.patch(kind, 12));
        of_tensor(&format!("{kind}, separated, 12"), &mut random, &patch);
    }
    for n in [3, 6, 10] {
        let patch = triangle_extremal(Functional::Dirichlet, &random.triangle(n));
        let form = DenseForm::of_triangle(Functional::Dirichlet, n).unwrap();
        let (value, gradient) = (|x: &[f64]| form.value(x), |x: &[f64]| form.gradient(x));
        let energy = Energy { value: &value, gradient: &gradient, norm: norm(form.matrix()) };
        check(
            &format!("triangular, degree {n}"),
            &mut random,
            &energy,
            patch.net().fixed(),
            &patch.net().coordinates(),
        );
    }
}

/// The largest degree up to which all systems are proved positive definite, and the largest whose condition a dense
/// solve accepts. The proof does not mind how rows are scaled, the condition does: either may be the larger.
fn certified(free_block: impl Fn(usize) -> (usize, Vec<f64>)) -> [usize; 2] {
    let mut largest = [1, 1];
    for degree in 2..=24 {
        let (n, block) = free_block(degree);
        let proved = solve::proves_positive_definite(n, &block).unwrap();
        let accepted = solve::Cholesky::new(n, &block).is_ok();
        for (largest, holds) in largest.iter_mut().zip([proved, accepted]) {
            if holds && *largest + 1 == degree {
                *largest = degree;
            }
        }
        if !accepted && !proved {
            break;
        }
    }
    largest
}

#[test]
fn dense_systems_are_proved_positive_definite() {
    let of_tensor = |kind: &str, functional: Functional| {
        certified(|n| {
            let patch = Random(2).patch(kind, n);
            let partition = solve::Partition::new(patch.net().fixed());
            let matrix = QuadraticForm::of(functional, &patch).unwrap().matrix();
            (partition.free().len(), partition.free_block(matrix.as_slice()).unwrap())
        })
    };
    let mut rows = Vec::new();
    for functional in [Functional::Dirichlet, Functional::Bending, Functional::Coons] {
        for kind in ["Bernstein", "GT", "TB-Coons"] {
            rows.push((format!("{kind}, {functional:?}"), of_tensor(kind, functional)));
        }
        let of_triangle = certified(|n| {
            let net = Random(3).triangle(n.max(3));
            let partition = solve::Partition::new(net.fixed());
            let form = DenseForm::of_triangle(functional, net.degree()).unwrap();
            (partition.free().len(), partition.free_block(form.matrix().as_slice()).unwrap())
        });
        rows.push((format!("triangular, {functional:?}"), of_triangle));
    }
    for (name, [proved, accepted]) in rows {
        println!("{name:<24} proved definite to degree {proved:>2}, accepted to {accepted:>2}");
        assert!(proved >= 6, "{name}: {proved}");
    }
}

/// A random patch of one of four kinds with its Dirichlet energy: smooth or crumpled, near to conformal or far.
fn random_patch(random: &mut Random, k: usize) -> (Box<dyn Patch>, f64) {
    let n = 1 + k % 5;
    let bumps = 10f64.powi(-((k / 5 % 4) as i32));
    if k % 4 == 3 {
        let flat = TriangleNet::new(n, vec![Point::ZERO; (n + 1) * (n + 2) / 2]).unwrap();
        let points = flat
            .indices()
            .map(|[i, j, _]| Point::new(i as f64 / n as f64, j as f64 / n as f64, 0.0) + random.point(bumps))
            .collect();
        let patch = TrianglePatch::new(TriangleNet::new(n, points).unwrap()).unwrap();
        let form = DenseForm::of_triangle(Functional::Dirichlet, n).unwrap();
        let energy = form.value(&patch.net().coordinates());
        return (Box::new(patch), energy);
    }
    let n = n.max(2);
    let points = (0..(n + 1) * (n + 1))
        .map(|e| {
            let (u, v) = ((e / (n + 1)) as f64 / n as f64, (e % (n + 1)) as f64 / n as f64);
            Point::new(u, v, 0.0) + random.point(bumps)
        })
        .collect();
    let (net, shape) = (Net::new(n + 1, n + 1, points).unwrap(), random.shape());
    let patch = match k % 4 {
        0 => TensorPatch::bernstein(net),
        1 => TensorPatch::gt(net, shape),
        _ => surfaces::tb_coons(net, shape),
    }
    .unwrap();
    let energy = QuadraticForm::of(Functional::Dirichlet, &patch).unwrap().value(&patch.net().coordinates());
    (Box::new(patch), energy)
}

/// A ≤ D for `count` patches, on two threads; areas are integrated to 1e-4 and count less the bound of their error.
fn area_below_dirichlet(count: usize) {
    let (least_gap, unsettled) = (AtomicU64::new(u64::MAX), AtomicU64::new(0));
    std::thread::scope(|scope| {
        for half in 0..2 {
            let (least_gap, unsettled) = (&least_gap, &unsettled);
            scope.spawn(move || {
                for k in (half..count).step_by(2) {
                    let (patch, dirichlet) = random_patch(&mut Random(k as u64), k);
                    let [area] = integrate(patch.as_ref(), 1e-4, [0.0], |jet| [jet.area_density()]).unwrap();
                    let below = area.value - area.error <= dirichlet * (1.0 + 1000.0 * U);
                    assert!(below, "patch {k}: area {area:?} above {dirichlet}");
                    let gap = ((dirichlet - area.value) / dirichlet).max(0.0);
                    least_gap.fetch_min(gap.to_bits(), Ordering::Relaxed);
                    unsettled.fetch_add(u64::from(!area.settled), Ordering::Relaxed);
                }
            });
        }
    });
    let gap = f64::from_bits(least_gap.into_inner());
    println!(
        "{count} patches: no area above its energy, least gap {gap:.1e}; {} with folds",
        unsettled.into_inner()
    );
}

#[test]
fn the_area_of_random_patches_is_below_their_energy() {
    area_below_dirichlet(400);
}

#[test]
#[ignore = "half a minute: a hundred thousand patches"]
fn the_area_of_100_000_random_patches_is_below_their_energy() {
    area_below_dirichlet(100_000);
}

#[test]
fn conformal_patches_have_the_area_of_their_energy() {
    let mut worst = 0.0f64;
    let mut check = |name: &str, patch: &TensorPatch| {
        let dirichlet =
            QuadraticForm::of(Functional::Dirichlet, patch).unwrap().value(&patch.net().coordinates());
        let area = area(patch).unwrap();
        let gap = (area.value / dirichlet - 1.0).abs();
        worst = worst.max(gap);
        assert!(gap <= 1e-13, "{name}: {} {dirichlet}", area.value);
    };
    for k in 1..=10 {
        let (u, v) = (0.25 * f64::from(k), 0.6 * f64::from(k));
        check("catenoid", &Helicoid::new(0.0, 1.3, u, v).unwrap().patch().unwrap());
        check("right helicoid", &Helicoid::new(0.7, 0.0, u, v).unwrap().patch().unwrap());
        check("generalized helicoid", &Helicoid::new(0.7, 1.3, u, v).unwrap().patch().unwrap());
        check("Enneper", &enneper(u));
    }
    println!("conformal patches: |A/D - 1| at most {worst:.1e}");
    // And a chart that is not conformal has more energy than area.
    let strip = TrapeziumHelicoid::new(1.0, [0.0, 1.0], [0.0, 0.0]).unwrap().patch().unwrap();
    let dirichlet =
        QuadraticForm::of(Functional::Dirichlet, &strip).unwrap().value(&strip.net().coordinates());
    assert!(area(&strip).unwrap().value < 0.99 * dirichlet);
}

/// Enneper's surface over [0, a]²: a bicubic patch.
fn enneper(a: f64) -> TensorPatch {
    let power = [[1., 1., 1., 1.], [0., 1. / 3., 2. / 3., 1.], [0., 0., 1. / 3., 1.], [0., 0., 0., 1.]];
    let points = (0..16).map(|k| {
        let u = |e: usize| power[e][k / 4] * a.powi(e as i32);
        let v = |e: usize| power[e][k % 4] * a.powi(e as i32);
        Point::new(u(1) - u(3) / 3. + u(1) * v(2), v(1) - v(3) / 3. + v(1) * u(2), u(2) - v(2))
    });
    TensorPatch::bernstein(Net::new(4, 4, points.collect()).unwrap()).unwrap()
}
