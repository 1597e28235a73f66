//! Quadratic forms and areas of triangular patches: two ways to every entry, the papers' formulas, the papers' tables.

mod interior;

use bases::Matrix;
use energy::{
    DenseForm, EnergyError, Functional, MetricForm, ReferenceTriangle, TangentSamples, area, integrate,
    triangle_area_with_gradient,
};
use interior::{enneper, extremal, masked, ni};
use proptest::prelude::*;
use surfaces::{
    Patch, Point, TriangleBasis, TriangleMask, TriangleNet, TrianglePatch, discrete_coons_triangle,
};

fn form(functional: Functional, n: usize) -> DenseForm {
    DenseForm::of_triangle(functional, n).expect("offered")
}

fn area_of(net: &TriangleNet) -> f64 {
    let area = area(&TrianglePatch::new(net.clone()).unwrap()).unwrap();
    assert!(area.settled, "{area:?}");
    area.value
}

fn random_net() -> impl Strategy<Value = TriangleNet> {
    (1usize..=8).prop_flat_map(|n| {
        let count = (n + 1) * (n + 2) / 2;
        prop::collection::vec([-1.0..1.0f64, -1.0..1.0, -1.0..1.0].prop_map(Point::from), count)
            .prop_map(move |points| TriangleNet::new(n, points).unwrap())
    })
}

/// A border of random bumps around the flat triangle, interior free.
fn border() -> impl Strategy<Value = TriangleNet> {
    (3usize..=5).prop_flat_map(|n| {
        prop::collection::vec([-0.05..0.05f64, -0.05..0.05, -0.2..0.2], 3 * n).prop_map(move |bumps| {
            let flat = TriangleNet::new(n, vec![Point::ZERO; (n + 1) * (n + 2) / 2]).unwrap();
            let points: Vec<f64> = flat
                .indices()
                .flat_map(|[i, j, _]| [i as f64 / n as f64, j as f64 / n as f64, 0.0])
                .collect();
            let [mut ab, mut bc, mut ca] = flat.with_coordinates(&points).unwrap().boundary();
            for s in 0..n {
                let bump = |k: usize| Point::from(bumps[k * n + s]);
                (ab[s], bc[s], ca[s]) = (ab[s] + bump(0), bc[s] + bump(1), ca[s] + bump(2));
            }
            (ab[n], bc[n], ca[n]) = (bc[0], ca[0], ab[0]);
            TriangleNet::from_boundary(&ab, &bc, &ca).unwrap()
        })
    })
}

/// The net read with its corners in another order: corner k of the result is corner `order[k]` of the net.
fn permuted(net: &TriangleNet, order: [usize; 3]) -> TriangleNet {
    let points: Vec<Point> = net
        .indices()
        .map(|index| {
            let mut old = [0; 3];
            (0..3).for_each(|k| old[order[k]] = index[k]);
            net.point(old[0], old[1])
        })
        .collect();
    TriangleNet::new(net.degree(), points).unwrap()
}

#[test]
fn the_flat_equilateral_triangle_is_conformal_over_its_like() {
    let corners = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [1.0, 3f64.sqrt(), 0.0]].map(Point::from);
    let net = TriangleNet::from_boundary(&corners[..2], &corners[1..], &[corners[2], corners[0]]).unwrap();
    let over = |reference| {
        DenseForm::of_triangle_over(reference, Functional::Dirichlet, 1).unwrap().value(&net.coordinates())
    };
    let area = 3f64.sqrt();
    assert!((over(ReferenceTriangle::Equilateral) - area).abs() < 1e-15);
    assert!(over(ReferenceTriangle::Right) > 1.1 * area);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn forms_integrate_their_densities(net in random_net()) {
        let patch = TrianglePatch::new(net.clone()).unwrap();
        for functional in Functional::ALL {
            let [direct] = integrate(&patch, 1e-12, [1e-300], |jet| [match functional {
                Functional::Dirichlet => jet.dirichlet_density(),
                Functional::Laplacian => jet.laplacian().dot(jet.laplacian()),
                Functional::Bending => jet.uu.dot(jet.uu) + 2.0 * jet.uv.dot(jet.uv) + jet.vv.dot(jet.vv),
                Functional::Coons => jet.uv.dot(jet.uv),
            }]).unwrap();
            let form = form(functional, net.degree());
            let x = net.coordinates();
            let value = form.value(&x);
            let scale = form.matrix().max_abs() * x.iter().map(|x| x * x).sum::<f64>();
            prop_assert!((value - direct.value).abs() <= 1e-13 * scale, "{functional:?}: {value} {direct:?}");
            // Euler: the gradient of a quadratic form along the net is twice its value.
            let along: f64 = form.gradient(&x).iter().zip(&x).map(|(g, x)| g * x).sum();
            prop_assert!((along - 2.0 * value).abs() <= 1e-13 * scale);
        }
    }

    #[test]
    fn area_never_exceeds_the_dirichlet_energy(net in random_net()) {
        // Point by point, hence for every rule with positive weights that is exact for the Dirichlet energy.
        let mut area = 0.0;
        for batch in TangentSamples::of_triangle(net.degree(), net.degree() + 4).unwrap() {
            for ([x_u, x_v], w) in batch.tangents(net.points()).into_iter().zip(batch.weights()) {
                area += w * x_u.cross(x_v).norm();
            }
        }
        let dirichlet = form(Functional::Dirichlet, net.degree()).value(&net.coordinates());
        prop_assert!(area <= dirichlet * (1.0 + 1e-13), "{area} {dirichlet}");
        prop_assert!(area > 0.0);
    }

    #[test]
    fn over_the_equilateral_triangle_no_corner_is_apart(net in random_net()) {
        let n = net.degree();
        for functional in Functional::ALL {
            let form = DenseForm::of_triangle_over(ReferenceTriangle::Equilateral, functional, n).unwrap();
            let x = net.coordinates();
            let (value, scale) = (form.value(&x), form.matrix().max_abs() * x.iter().map(|x| x * x).sum::<f64>());
            for order in [[1, 2, 0], [1, 0, 2], [2, 1, 0]] {
                let turned = permuted(&net, order);
                let other = form.value(&turned.coordinates());
                prop_assert!((value - other).abs() <= 1e-13 * scale, "{functional:?}, {order:?}: {value} {other}");
            }
        }
    }

    #[test]
    fn energies_over_the_equilateral_triangle_are_those_of_orthonormal_coordinates(net in random_net()) {
        let patch = TrianglePatch::new(net.clone()).unwrap();
        // Corners (0, 0), (a, 0), (a/2, a √3/2) of area 1/2: u = (x − y/√3)/a, v = 2y/(√3 a).
        let (a, root) = ((2.0 / 3f64.sqrt()).sqrt(), 3f64.sqrt());
        let [[ux, vx], [uy, vy]] = [[1.0 / a, 0.0], [-1.0 / (root * a), 2.0 / (root * a)]];
        let second = |jet: &surfaces::Jet, [p, q]: [f64; 2], [r, s]: [f64; 2]| {
            jet.uu * (p * r) + jet.uv * (p * s + q * r) + jet.vv * (q * s)
        };
        let direct = integrate(&patch, 1e-13, [0.0; 3], |jet| {
            let (x, y) = (jet.u * ux + jet.v * vx, jet.u * uy + jet.v * vy);
            let [xx, xy, yy] = [([ux, vx], [ux, vx]), ([ux, vx], [uy, vy]), ([uy, vy], [uy, vy])]
                .map(|(p, q)| second(jet, p, q));
            let laplacian = xx + yy;
            [0.5 * (x.dot(x) + y.dot(y)), laplacian.dot(laplacian), xx.dot(xx) + 2.0 * xy.dot(xy) + yy.dot(yy)]
        })
        .unwrap();
        for (functional, direct) in Functional::ALL.into_iter().zip(direct) {
            let form = DenseForm::of_triangle_over(ReferenceTriangle::Equilateral, functional, net.degree()).unwrap();
            let x = net.coordinates();
            let scale = form.matrix().max_abs() * x.iter().map(|x| x * x).sum::<f64>();
            prop_assert!((form.value(&x) - direct.value).abs() <= 1e-12 * scale, "{functional:?}");
        }
    }

    #[test]
    fn extremals_are_minimal(net in border(), step in -0.5..0.5f64, at in 0usize..1000) {
        for functional in Functional::ALL {
            let form = form(functional, net.degree());
            let best = extremal(&form, &net);
            let mut x = best.coordinates();
            let value = form.value(&x);
            let free: Vec<usize> = (0..net.points().len()).filter(|&p| !net.fixed()[p]).collect();
            let gradient = form.gradient(&x);
            let scale = form.matrix().max_abs() * 1e-11;
            prop_assert!(free.iter().all(|p| gradient[3 * p..3 * p + 3].iter().all(|g| g.abs() <= scale)), "{functional:?}");
            x[3 * free[at % free.len()] + at % 3] += step;
            prop_assert!(form.value(&x) >= value - 1e-13 * form.matrix().max_abs());
        }
    }

}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn gradients_are_those_of_the_area(net in border(), at in 0usize..1000) {
        let net = extremal(&form(Functional::Dirichlet, net.degree()), &net);
        let patch = |x: &[f64]| TrianglePatch::new(net.with_coordinates(x).unwrap()).unwrap();
        let x = net.coordinates();
        let (integral, gradient) = triangle_area_with_gradient(&patch(&x)).unwrap();
        prop_assert_eq!(integral, area(&patch(&x)).unwrap());
        let at = at % x.len();
        let h = 1e-4;
        let shifted = |d: f64| {
            let mut y = x.clone();
            y[at] += d;
            area(&patch(&y)).unwrap().value
        };
        let difference = (shifted(-2.0 * h) - shifted(2.0 * h) + 8.0 * (shifted(h) - shifted(-h))) / (12.0 * h);
        prop_assert!((gradient[at] - difference).abs() <= 1e-8, "{} {difference}", gradient[at]);
        // Translations and rotations do not change the area.
        for d in 0..3 {
            let sum: f64 = gradient.iter().skip(d).step_by(3).sum();
            prop_assert!(sum.abs() <= 1e-12, "{sum}");
        }
    }
}

#[test]
fn quadrature_gives_the_same_entries() {
    for functional in Functional::ALL {
        for n in [1, 2, 3, 4, 7, 12] {
            let (closed, gauss) =
                (form(functional, n), DenseForm::of_triangle_by_quadrature(functional, n).unwrap());
            let scale = closed.matrix().max_abs();
            for (a, b) in closed.matrix().as_slice().iter().zip(gauss.matrix().as_slice()) {
                assert!((a - b).abs() <= 1e-14 * scale, "{functional:?} {n}: {a} {b}");
            }
        }
    }
}

/// n!/(i! j! k!) for small n.
fn multinomial(index: [usize; 3]) -> f64 {
    let factorial = |m: usize| (1..=m).map(|s| s as f64).product::<f64>();
    factorial(index.iter().sum()) / index.iter().map(|&s| factorial(s)).product::<f64>()
}

/// Entries `(n!/I)(n!/J)/((2n)!/(I+J)) · c(I, J)` over all pairs of multi-indices.
fn by_formula(n: usize, c: impl Fn([usize; 3], [usize; 3]) -> f64) -> Matrix {
    let indices: Vec<[usize; 3]> = TriangleBasis::new(n).unwrap().indices().collect();
    Matrix::from_fn(indices.len(), indices.len(), |p, q| {
        let (i, j) = (indices[p], indices[q]);
        multinomial(i) * multinomial(j) / multinomial([i[0] + j[0], i[1] + j[1], i[2] + j[2]]) * c(i, j)
    })
}

fn proportional(ours: &Matrix, formula: &Matrix, factor: f64, name: &str) {
    let scale = ours.max_abs();
    for (a, b) in ours.as_slice().iter().zip(formula.as_slice()) {
        assert!((a - factor * b).abs() <= 1e-13 * scale, "{name}: {a} {}", factor * b);
    }
}

#[test]
fn dirichlet_entries_are_those_of_proposition_2() {
    // TRI Prop. 2 with binomial(n, I) where (n − 1, I) is printed; twice D is the sum.
    let ratio =
        |a: usize, b: usize| if a * b == 0 { 0.0 } else { (a * b) as f64 / ((a + b) * (a + b - 1)) as f64 };
    let mixed = |a: (usize, usize), b: (usize, usize)| {
        let below = (a.0 + a.1) * (b.0 + b.1);
        if below == 0 { 0.0 } else { (a.0 * b.1 + b.0 * a.1) as f64 / below as f64 }
    };
    for n in 1..=8 {
        let formula = by_formula(n, |i, j| {
            let [u, v, w] = [0, 1, 2].map(|s| (i[s], j[s]));
            ratio(u.0, u.1) + ratio(v.0, v.1) + 2.0 * ratio(w.0, w.1) - mixed(u, w) - mixed(v, w)
        });
        proportional(form(Functional::Dirichlet, n).matrix(), &formula, 0.5, "TRI Prop. 2");
    }
}

#[test]
fn coons_entries_are_those_of_proposition_2() {
    // COONS (6), (7): b(r,s; t,l) is the integral of the product of two second derivatives by the products of the
    // falling powers of its own indices, summed over both orders of the factors.
    let falling = |x: usize, k: usize| (0..k).map(|s| x as f64 - s as f64).product::<f64>();
    let b = |[i, j]: [[usize; 3]; 2], first: [usize; 2], second: [usize; 2]| {
        let count = |pair: [usize; 2], s: usize| pair.iter().filter(|&&t| t == s).count();
        let up =
            |x: [usize; 3], pair: [usize; 2]| (0..3).map(|s| falling(x[s], count(pair, s))).product::<f64>();
        let below: f64 = (0..3).map(|s| falling(i[s] + j[s], count(first, s) + count(second, s))).product();
        if below == 0.0 { 0.0 } else { (up(i, first) * up(j, second) + up(j, first) * up(i, second)) / below }
    };
    for n in 2..=7 {
        let formula = by_formula(n, |i, j| {
            let b = |r: usize, s: usize, t: usize, l: usize| b([i, j], [r - 1, s - 1], [t - 1, l - 1]);
            // The coefficients of (6) belong to half of these sums, and all diagonal ones have the factor ½.
            0.5 * (b(1, 2, 1, 2) + b(1, 3, 1, 3) + b(2, 3, 2, 3) + b(3, 3, 3, 3))
                - b(1, 2, 1, 3)
                - b(1, 2, 2, 3)
                + b(1, 2, 3, 3)
                + b(1, 3, 2, 3)
                - b(1, 3, 3, 3)
                - b(2, 3, 3, 3)
        });
        // n² (n−1)² (binomials of n−2) / (binomials of 2n−4) / ((2n−3)(2n−2)) = 2n(2n−1) (binomials of n)/(of 2n).
        let nf = n as f64;
        proportional(
            form(Functional::Coons, n).matrix(),
            &formula,
            2.0 * nf * (2.0 * nf - 1.0),
            "COONS Prop. 2",
        );
    }
}

#[test]
fn forms_vanish_on_what_their_density_vanishes_on() {
    for n in 1..=10 {
        let affine: Vec<f64> = TriangleBasis::new(n)
            .unwrap()
            .indices()
            .flat_map(|[i, j, _]| [i as f64, j as f64, 1.0])
            .collect();
        for functional in Functional::ALL {
            let form = form(functional, n);
            let value = form.value(&affine);
            let scale = form.matrix().max_abs() * (n * n * n * n) as f64;
            let expected = if functional == Functional::Dirichlet { 0.5 * (n * n) as f64 } else { 0.0 };
            assert!((value - expected).abs() <= 1e-13 * scale, "{functional:?} {n}: {value}");
        }
    }
    assert_eq!(form(Functional::Bending, 1).matrix(), &Matrix::zeros(3, 3));
    assert!(matches!(DenseForm::of_triangle(Functional::Coons, 65), Err(EnergyError::Basis(_))));
    assert!(matches!(
        DenseForm::new(Matrix::zeros(2, 3)),
        Err(EnergyError::Shape { expected: 2, found: 3, .. })
    ));
}

#[test]
fn the_cubic_extremals_are_their_masks() {
    for (functional, mask) in
        [(Functional::Dirichlet, TriangleMask::Dirichlet), (Functional::Coons, TriangleMask::Coons)]
    {
        for net in [enneper(), ni([true, false, false], 3)] {
            let (a, b) = (extremal(&form(functional, 3), &net), masked(&mask.system(&net).unwrap(), &net));
            assert!(a.point(1, 1).distance(b.point(1, 1)) <= 1e-14, "{functional:?}");
        }
    }
}

#[test]
fn symmetric_mask_minus_two_thirds_is_the_cubic_coons_patch() {
    let quadratic = ni([true, true, false], 2);
    let [ab, bc, ca] = quadratic.boundary();
    let coons = discrete_coons_triangle(&ab, &bc, &ca).unwrap();
    let raised = quadratic.raised(1).unwrap();
    let net = masked(&TriangleMask::Symmetric(-2.0 / 3.0).system(&raised).unwrap(), &raised);
    assert!(net.point(1, 1).distance(coons.point(1, 1)) <= 1e-15);
}

#[test]
fn enneper_is_found_exactly() {
    let net = extremal(&form(Functional::Dirichlet, 3), &enneper());
    assert!(net.point(1, 1).distance(Point::new(2.0 / 3.0, 1.0, 5.0 / 3.0)) <= 1e-12);
    // The chart is conformal: area = Dirichlet energy = ∫∫ (1 + (u + 1)² + v²)² over the triangle = 421/90.
    let (area, dirichlet) = (area_of(&net), form(Functional::Dirichlet, 3).value(&net.coordinates()));
    assert!((area - 421.0 / 90.0).abs() <= 1e-13 * area, "{area}");
    assert!((dirichlet - area).abs() <= 1e-13 * area);
}

/// The cubic net of Enneper's surface `(u − u³/3 + uv², v − v³/3 + u²v, u² − v²)` over the triangle with these corners: `P_ijk` is the
/// symmetric trilinear form of each coordinate at i times A, j times B, k times C. Its interior is free.
fn enneper_piece(corners: [[f64; 2]; 3]) -> TriangleNet {
    let polar = |args: [[f64; 2]; 3]| {
        let [p, q, r] = args;
        let (sum, all) = (|k: usize| (p[k] + q[k] + r[k]) / 3.0, |k: usize| p[k] * q[k] * r[k]);
        let two = |k: usize| (p[k] * q[k] + p[k] * r[k] + q[k] * r[k]) / 3.0;
        let mixed = |k: usize, l: usize| (p[k] * q[l] * r[l] + p[l] * q[k] * r[l] + p[l] * q[l] * r[k]) / 3.0;
        Point::new(sum(0) - all(0) / 3.0 + mixed(0, 1), sum(1) - all(1) / 3.0 + mixed(1, 0), two(0) - two(1))
    };
    let empty = TriangleNet::new(3, vec![Point::ZERO; 10]).unwrap();
    let points: Vec<Point> = empty
        .indices()
        .map(|index| {
            let all: Vec<usize> = (0..3).flat_map(|s| vec![s; index[s]]).collect();
            polar([corners[all[0]], corners[all[1]], corners[all[2]]])
        })
        .collect();
    let whole = TriangleNet::new(3, points).unwrap();
    let [ab, bc, ca] = whole.boundary();
    let border = TriangleNet::from_boundary(&ab, &bc, &ca).unwrap();
    border.with_coordinates(&whole.coordinates()).unwrap()
}

#[test]
fn only_conformal_pieces_of_enneper_come_back() {
    // TRI §1 (3) and §6 say every triangular piece. The chart over a right isosceles triangle with the right angle at C is conformal; over
    // others it is not, and the extremal is another surface.
    let found = |corners, form: &DenseForm| {
        let exact = enneper_piece(corners);
        let net = extremal(form, &exact);
        (net.point(1, 1).distance(exact.point(1, 1)), area_of(&net), area_of(&exact))
    };
    let right = form(Functional::Dirichlet, 3);
    let isosceles = [[1.2, 0.3], [0.2, 1.3], [0.2, 0.3]];
    assert!(found(isosceles, &right).0 < 1e-13);
    let scalene = [[1.3, 0.2], [0.1, 0.9], [-0.4, -0.3]];
    let (distance, area, exact) = found(scalene, &right);
    assert!((distance - 0.501131).abs() < 1e-6, "{distance}");
    assert!((area - 1.794793).abs() < 5e-7 && (exact - 1.778093).abs() < 5e-7, "{area} {exact}");
    // Over the equilateral triangle it is the mask without edges, and the energy over that triangle, that are exact.
    let equilateral = [[0.9, 0.1], [0.0, 0.1], [0.45, 0.1 + 0.45 * 3f64.sqrt()]];
    assert!(found(equilateral, &right).0 > 1e-2);
    let over = DenseForm::of_triangle_over(ReferenceTriangle::Equilateral, Functional::Dirichlet, 3).unwrap();
    assert!(found(equilateral, &over).0 < 1e-13);
    let exact = enneper_piece(equilateral);
    let net = masked(&TriangleMask::Symmetric(1.0 / 3.0).system(&exact).unwrap(), &exact);
    assert!(net.point(1, 1).distance(exact.point(1, 1)) < 1e-13);
}

#[test]
fn raised_harmonic_borders_span_the_same_surface() {
    // Tolerances grow with the condition of the system, not with that of the net.
    let cubic = extremal(&form(Functional::Dirichlet, 3), &enneper());
    for (n, tolerance) in [(4, 1e-14), (7, 2e-14), (10, 2e-13), (15, 5e-12), (20, 2e-10)] {
        let net = extremal(&form(Functional::Dirichlet, n), &cubic.raised(n - 3).unwrap());
        let (low, high) = (TrianglePatch::new(cubic.clone()).unwrap(), TrianglePatch::new(net).unwrap());
        for [u, v] in [[0.2, 0.3], [0.5, 0.25], [0.1, 0.8], [1.0 / 3.0, 1.0 / 3.0]] {
            let error = low.point(u, v).distance(high.point(u, v));
            assert!(error <= tolerance, "degree {n}: {error}");
        }
    }
}

#[test]
fn the_best_symmetric_mask_for_enneper() {
    let at = |alpha: f64| {
        let net = enneper();
        area_of(&masked(&TriangleMask::Symmetric(alpha).system(&net).unwrap(), &net))
    };
    // Golden section.
    let (mut low, mut high) = (0.0, 0.3);
    for _ in 0..40 {
        let (a, b) = (low + 0.382 * (high - low), low + 0.618 * (high - low));
        if at(a) < at(b) { high = b } else { low = a }
    }
    let best = 0.5 * (low + high);
    assert!((best - 0.12822).abs() <= 5e-6, "{best}");
    assert!((at(best) - 4.678350).abs() <= 5e-7, "{}", at(best));
}

/// The seven rows of the tables of TRI for one border.
fn table(net: &TriangleNet) -> [f64; 7] {
    let by_mask = |mask: TriangleMask| area_of(&masked(&mask.system(net).unwrap(), net));
    let first = extremal(&form(Functional::Dirichlet, net.degree()), net);
    let step = |net: &TriangleNet| {
        let metric =
            MetricForm::of_triangle(&TrianglePatch::new(net.clone()).unwrap(), net.degree()).unwrap();
        assert!(metric.settled);
        extremal(&metric.form, net)
    };
    let second = step(&first);
    [
        by_mask(TriangleMask::Symmetric(0.0)),
        by_mask(TriangleMask::Symmetric(1.0 / 9.0)),
        by_mask(TriangleMask::Symmetric(1.0 / 3.0)),
        by_mask(TriangleMask::Dirichlet),
        area_of(&first),
        area_of(&second),
        area_of(&step(&second)),
    ]
}

#[test]
fn the_tables_of_the_paper() {
    for (name, net, expected) in [
        ("Enneper", enneper(), [4.67858, 4.67835, 4.67899, 4.67778, 4.67778, 4.67778, 4.67778]),
        (
            "NI1, 3",
            ni([true, false, false], 3),
            [0.99686, 0.99631, 0.99564, 0.99793, 0.99793, 0.99547, 0.99546],
        ),
        ("NI2, 3", ni([true; 3], 3), [1.21350, 1.20844, 1.20275, 1.20277, 1.20277, 1.20216, 1.20216]),
        ("NI2, 10", ni([true; 3], 10), [1.34247, 1.34009, 1.33864, 1.33961, 1.33963, 1.33621, 1.33620]),
    ] {
        for (found, expected) in table(&net).into_iter().zip(expected) {
            assert!((found - expected).abs() <= 5.000_001e-6, "{name}: {found} {expected}");
        }
    }
}
