//! Laws of triangular Bernstein polynomials, nets, patches and Coons nets.

use bases::{Basis, BasisError, Bernstein, GaussLegendre};
use proptest::prelude::*;
use surfaces::{
    Domain, Mesh, Net, Patch, Point, SurfaceError, TensorPatch, TriangleBasis, TriangleNet, TrianglePatch,
    discrete_coons, discrete_coons_triangle,
};

const U: f64 = f64::EPSILON / 2.0;

fn basis(n: usize) -> TriangleBasis {
    TriangleBasis::new(n).expect("offered")
}

/// Points of the triangle, its corners and sides included.
fn parameters() -> impl Strategy<Value = (f64, f64)> {
    let inside = (0.0..1.0f64, 0.0..1.0f64).prop_map(|(s, t)| (s, (1.0 - s) * t));
    prop_oneof![
        8 => inside.clone(),
        1 => inside.clone().prop_map(|(s, _)| (s, 0.0)),
        1 => inside.prop_map(|(s, _)| (0.0, s)),
        1 => prop_oneof![Just((0.0, 0.0)), Just((1.0, 0.0)), Just((0.0, 1.0))],
    ]
}

fn points(count: usize) -> impl Strategy<Value = Vec<Point>> {
    prop::collection::vec([-2.0..2.0f64, -2.0..2.0, -2.0..2.0].prop_map(Point::from), count)
}

/// Three border polygons of degree n that meet at the corners.
fn border(n: usize) -> impl Strategy<Value = [Vec<Point>; 3]> {
    points(3 * n).prop_map(move |p| {
        let mut closed = p.clone();
        closed.push(p[0]);
        [closed[..=n].to_vec(), closed[n..=2 * n].to_vec(), closed[2 * n..].to_vec()]
    })
}

fn any_net() -> impl Strategy<Value = TriangleNet> {
    (1usize..=12)
        .prop_flat_map(|n| points((n + 1) * (n + 2) / 2).prop_map(move |p| TriangleNet::new(n, p).unwrap()))
}

fn bezier(polygon: &[Point], t: f64) -> Point {
    let values = Bernstein::new(polygon.len() - 1).unwrap().evaluate(t, 0);
    polygon.iter().zip(values.row(0)).fold(Point::ZERO, |sum, (&p, &b)| sum + p * b)
}

/// A sum whose rounding errors are added up as well.
fn exact_sum(terms: &[f64]) -> f64 {
    let (mut sum, mut errors) = (0.0, 0.0);
    for &term in terms {
        let next: f64 = sum + term;
        let part = next - sum;
        errors += (sum - (next - part)) + (term - part);
        sum = next;
    }
    sum + errors
}

/// A nonnegative integer as limbs of 64 bits, least significant first.
struct Integer(Vec<u64>);

impl Integer {
    fn times(mut self, factor: u64) -> Self {
        let mut carry = 0u128;
        for limb in &mut self.0 {
            carry += u128::from(*limb) * u128::from(factor);
            *limb = carry as u64;
            carry >>= 64;
        }
        self.0.push(carry as u64);
        while self.0.last() == Some(&0) {
            self.0.pop();
        }
        self
    }

    /// `self / 2^bits` as a double and the rest, to twice the precision.
    fn scaled(&self, bits: usize) -> (f64, f64) {
        let (mut hi, mut lo) = (0.0, 0.0);
        for (place, &limb) in self.0.iter().enumerate().rev() {
            for (half, digits) in [(1, limb >> 32), (0, limb & 0xffff_ffff)] {
                let term = digits as f64 * 2f64.powi((64 * place + 32 * half) as i32 - bits as i32);
                // Terms descend, so this sum's error is exact.
                let sum = hi + term;
                lo += term - (sum - hi);
                hi = sum;
            }
        }
        (hi, lo)
    }
}

/// `B^n_ijk(a/2⁶⁰, b/2⁶⁰)` in integers, as a double and the rest.
fn exact(n: usize, [i, j, k]: [usize; 3], a: u64, b: u64) -> (f64, f64) {
    let mut c = 1u128;
    for (count, of) in [(j, n - i), (i, n)] {
        let mut binomial = 1u128;
        for s in 1..=count {
            binomial = binomial * (of + 1 - s) as u128 / s as u128;
        }
        c *= binomial;
    }
    let mut value = Integer(vec![c as u64, (c >> 64) as u64]);
    for (x, power) in [(a, i), (b, j), ((1 << 60) - a - b, k)] {
        for _ in 0..power {
            value = value.times(x);
        }
    }
    value.scaled(60 * n)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn values_sum_to_one_and_derivatives_to_zero(n in 0usize..=64, (u, v) in parameters()) {
        let table = basis(n).evaluate(u, v, 2);
        let sum = exact_sum(table.row(0));
        prop_assert!((sum - 1.0).abs() <= 8.0 * U, "sum {sum}");
        // The functions of a row of order r are differences of n!/(n−r)! B^{n−r}_J, whose sum is n!/(n−r)!.
        for (r, scale) in [2 * n, 2 * n, 4 * n * n, 4 * n * n, 4 * n * n].into_iter().enumerate() {
            let sum = exact_sum(table.row(r + 1));
            prop_assert!(sum.abs() <= 8.0 * U * scale as f64, "row {}: {sum}", r + 1);
        }
    }

    #[test]
    fn values_are_within_8u_of_exact_integer_arithmetic(
        n in prop_oneof![1usize..=20, 1usize..=64], s in 0.01..0.98f64, t in 0.0..1.0f64, flip in any::<bool>(),
    ) {
        // Doubles above 2⁻⁷ are integers of 2⁻⁶⁰.
        let (u, v) = (s, (0.99 - s) * t + 0.009);
        let (u, v) = if flip { (v, u) } else { (u, v) };
        let [a, b] = [u, v].map(|x| (x * 2f64.powi(60)) as u64);
        let table = basis(n).evaluate(u, v, 0);
        for (index, &value) in basis(n).indices().zip(table.row(0)) {
            let (hi, lo) = exact(n, index, a, b);
            if hi > 1e-290 {
                let error = (value - hi) - lo;
                prop_assert!(error.abs() <= 8.0 * U * hi, "{index:?}: {} u relative", error / hi / U);
            }
        }
    }

    #[test]
    fn derivatives_are_those_of_the_monomials(n in 0usize..=20, (u, v) in parameters()) {
        // x^p differentiated r times; 0 where nothing is left.
        let d = |x: f64, p: usize, r: usize| -> f64 {
            let factor: f64 = (0..r).map(|s| p as f64 - s as f64).product();
            if r > p { 0.0 } else { factor * x.powi((p - r) as i32) }
        };
        let w = 1.0 - u - v;
        let table = basis(n).evaluate(u, v, 2);
        // The monomials are the rough side: n roundings in each power, and w rounded.
        let scale = 80.0 * U * (1.0 + table.max_abs());
        for (p, [i, j, k]) in basis(n).indices().enumerate() {
            let factorial = |m: usize| (1..=m).map(|s| s as f64).product::<f64>();
            let c = factorial(n) / (factorial(i) * factorial(j) * factorial(k));
            let m = |a: usize, b: usize, e: usize| c * d(u, i, a) * d(v, j, b) * d(w, k, e);
            let expected = [
                m(1, 0, 0) - m(0, 0, 1),
                m(0, 1, 0) - m(0, 0, 1),
                m(2, 0, 0) - 2.0 * m(1, 0, 1) + m(0, 0, 2),
                m(1, 1, 0) - m(1, 0, 1) - m(0, 1, 1) + m(0, 0, 2),
                m(0, 2, 0) - 2.0 * m(0, 1, 1) + m(0, 0, 2),
            ];
            for (r, e) in expected.into_iter().enumerate() {
                prop_assert!((table[(r + 1, p)] - e).abs() <= scale, "{:?} row {}", [i, j, k], r + 1);
            }
        }
    }

    #[test]
    fn permuting_parameters_and_indices_changes_nothing(n in 0usize..=30, a in 0u64..=1 << 40, t in 0.0..=1.0f64) {
        // On this grid u, v and w are exact.
        let grid = (1u64 << 40) as f64;
        let b = ((grid - a as f64) * t) as u64;
        let [u, v, w] = [a, b, (1 << 40) - a - b].map(|x| x as f64 / grid);
        let family = basis(n);
        let value = |u, v, i, j| family.evaluate(u, v, 0)[(0, family.position(i, j))];
        for [i, j, k] in family.indices() {
            let here = value(u, v, i, j);
            for there in [value(v, u, j, i), value(w, v, k, j), value(u, w, i, k), value(v, w, j, k), value(w, u, k, i)] {
                prop_assert!((here - there).abs() <= 8.0 * U * here, "{here} {there}");
            }
        }
    }

    #[test]
    fn the_patch_is_the_sum_over_its_basis(net in any_net(), (u, v) in parameters()) {
        let n = net.degree() as f64;
        let patch = TrianglePatch::new(net).unwrap();
        let jet = patch.jet(u, v);
        let table = patch.basis().evaluate(u, v, 2);
        let rows = [jet.point, jet.u, jet.v, jet.uu, jet.uv, jet.vv];
        let order = [0, 1, 1, 2, 2, 2];
        for (r, got) in rows.into_iter().enumerate() {
            let sum = patch.net().points().iter().zip(table.row(r)).fold(Point::ZERO, |s, (&p, &b)| s + p * b);
            let scale = patch.net().size() * n.powi(order[r]);
            prop_assert!(got.distance(sum) <= 200.0 * U * scale.max(1.0), "row {r}: {got:?} {sum:?}");
        }
    }

    #[test]
    fn corners_and_sides_are_those_of_the_border(rows in (1usize..=12).prop_flat_map(border), t in 0.0..=1.0f64) {
        let [ab, bc, ca] = &rows;
        let net = TriangleNet::from_boundary(ab, bc, ca).unwrap();
        prop_assert_eq!(&net.boundary(), &rows);
        let patch = TrianglePatch::new(net).unwrap();
        prop_assert_eq!([patch.point(1.0, 0.0), patch.point(0.0, 1.0), patch.point(0.0, 0.0)], [ab[0], bc[0], ca[0]]);
        let close = |p: Point, q: Point| p.distance(q) <= 64.0 * U * patch.net().size();
        // Along AB the doubles 1 − t and t sum to 1 within one rounding, which moves w by as much.
        prop_assert!(patch.point(1.0 - t, t).distance(bezier(ab, t)) <= 1e3 * U * patch.net().size());
        prop_assert!(close(patch.point(0.0, 1.0 - t), bezier(bc, t)));
        prop_assert!(close(patch.point(t, 0.0), bezier(ca, t)));
    }

    #[test]
    fn scattered_points_and_jets_are_those_one_by_one(
        net in any_net(),
        parameters in prop::collection::vec(parameters(), 0..9),
    ) {
        let patch = TrianglePatch::new(net).unwrap();
        let parameters: Vec<[f64; 2]> = parameters.into_iter().map(|(u, v)| [u, v]).collect();
        let (points, jets) = (patch.points_at(&parameters), patch.jets_at(&parameters));
        for ((&[u, v], point), jet) in parameters.iter().zip(points).zip(jets) {
            prop_assert_eq!(jet, patch.jet(u, v));
            prop_assert_eq!((jet.point, patch.point(u, v)), (point, point));
        }
    }

    #[test]
    fn raising_the_degree_moves_nothing(net in any_net(), k in 0usize..=4, (u, v) in parameters()) {
        let (n, size) = (net.degree(), net.size());
        let raised = net.raised(k).unwrap();
        prop_assert_eq!(raised.degree(), n + k);
        let (low, high) = (TrianglePatch::new(net).unwrap(), TrianglePatch::new(raised).unwrap());
        prop_assert!(low.point(u, v).distance(high.point(u, v)) <= 64.0 * U * size);
        for (index, fixed) in high.net().indices().zip(high.net().fixed()) {
            prop_assert!(k == 0 || *fixed == index.contains(&0));
        }
    }

    #[test]
    fn the_discrete_coons_net_spans_the_coons_patch(rows in (1usize..=8).prop_flat_map(border), (u, v) in parameters()) {
        // COONS §3, the continuous definition, with the Bézier curves of the border.
        let [ab, bc, ca] = &rows;
        let along_u = |s: f64| bezier(ca, s); // x(s, 0)
        let along_v = |s: f64| bezier(bc, 1.0 - s); // x(0, s)
        let across = |s: f64| bezier(ab, 1.0 - s); // x(s, 1 − s)
        let [a, b, c] = [ab[0], bc[0], ca[0]];
        let w = 1.0 - u - v;
        let expected = (along_u(u) + along_v(v) - c) * w
            + (along_v(u + v) + across(u) - b) * v
            + (along_u(u + v) + across(1.0 - v) - a) * u;
        let net = discrete_coons_triangle(ab, bc, ca).unwrap();
        prop_assert_eq!(net.degree(), ab.len());
        let size = net.size();
        let border = TriangleNet::from_boundary(ab, bc, ca).unwrap().raised(1).unwrap();
        for (p, fixed) in border.fixed().iter().enumerate() {
            if *fixed {
                prop_assert!(net.points()[p].distance(border.points()[p]) <= 16.0 * U * size);
            }
        }
        let patch = TrianglePatch::new(net).unwrap();
        prop_assert!(patch.point(u, v).distance(expected) <= 1e3 * U * size, "{:?} {expected:?}", patch.point(u, v));
    }

    #[test]
    fn the_rectangular_coons_net_spans_the_coons_patch(
        p in points(16), m in 1usize..=4, n in 1usize..=4, u in 0.0..=1.0f64, v in 0.0..=1.0f64,
    ) {
        let corner = [p[12], p[13], p[14], p[15]]; // (0,0), (0,1), (1,0), (1,1)
        let row = |a: Point, inner: &[Point], b: Point, n: usize| {
            std::iter::once(a).chain(inner[..n - 1].iter().copied()).chain([b]).collect::<Vec<_>>()
        };
        let u0 = row(corner[0], &p[0..3], corner[1], n);
        let u1 = row(corner[2], &p[3..6], corner[3], n);
        let v0 = row(corner[0], &p[6..9], corner[2], m);
        let v1 = row(corner[1], &p[9..12], corner[3], m);
        let patch = TensorPatch::bernstein(discrete_coons(&u0, &u1, &v0, &v1).unwrap()).unwrap();
        let bilinear = (corner[0] * (1.0 - v) + corner[1] * v) * (1.0 - u)
            + (corner[2] * (1.0 - v) + corner[3] * v) * u;
        let expected = bezier(&u0, v) * (1.0 - u) + bezier(&u1, v) * u + bezier(&v0, u) * (1.0 - v)
            + bezier(&v1, u) * v - bilinear;
        prop_assert!(patch.point(u, v).distance(expected) <= 1e3 * U, "{:?} {expected:?}", patch.point(u, v));
    }
}

#[test]
fn integrals_of_all_functions_of_a_degree_are_equal() {
    for n in [0, 1, 2, 5, 13, 32, 64] {
        let family = basis(n);
        let mut integrals = vec![0.0; family.count()];
        let rule = GaussLegendre::new(n / 2 + 2).unwrap();
        for (s, ws) in rule.iter() {
            for (t, wt) in rule.iter() {
                let table = family.evaluate(s, (1.0 - s) * t, 0);
                for (sum, b) in integrals.iter_mut().zip(table.row(0)) {
                    *sum += ws * wt * (1.0 - s) * b;
                }
            }
        }
        let expected = 1.0 / ((n + 1) * (n + 2)) as f64;
        for integral in integrals {
            assert!((integral / expected - 1.0).abs() <= 1e-13, "degree {n}: {integral} {expected}");
        }
    }
}

#[test]
fn parameters_that_are_not_numbers_give_none() {
    assert!(basis(4).evaluate(0.1, f64::NAN, 2).as_slice().iter().all(|x| x.is_nan()));
    let net = TriangleNet::new(1, vec![Point::ZERO; 3]).unwrap();
    let jet = TrianglePatch::new(net).unwrap().jet(f64::INFINITY, 0.0);
    assert!(jet.point.x.is_nan() && jet.uv.z.is_nan());
}

#[test]
fn nets_hold_their_points_by_index() {
    let p = |x: usize, y: usize, z: usize| Point::new(x as f64, y as f64, z as f64);
    let n = 4;
    let all: Vec<Point> = basis(n).indices().map(|[i, j, k]| p(i, j, k)).collect();
    let net = TriangleNet::new(n, all).unwrap();
    assert_eq!(net.point(1, 2), p(1, 2, 1));
    let [ab, bc, ca] = net.boundary();
    assert_eq!((ab[1], bc[1], ca[1]), (p(3, 1, 0), p(0, 3, 1), p(1, 0, 3)));
    assert_eq!((ab[0], bc[0], ca[0]), (p(4, 0, 0), p(0, 4, 0), p(0, 0, 4)));
    let again = net.with_coordinates(&net.coordinates()).unwrap();
    assert_eq!(again, net);
    let free = TriangleNet::from_boundary(&ab, &bc, &ca).unwrap();
    let inner = free.indices().zip(free.fixed()).filter(|(_, fixed)| !**fixed).map(|(index, _)| index);
    assert_eq!(inner.collect::<Vec<_>>(), [[1, 1, 2], [1, 2, 1], [2, 1, 1]]);
    // Mapped by its own indices the patch is n (u, v, w).
    let at = TrianglePatch::new(net).unwrap().point(0.25, 0.5);
    assert!(at.distance(Point::new(1.0, 2.0, 1.0)) <= 64.0 * U);
}

#[test]
fn bad_borders_are_errors_that_name_the_row() {
    let [a, b, c] = [[1., 0., 0.], [0., 1., 0.], [0., 0., 1.]].map(Point::from);
    let mid = |p: Point, q: Point| vec![p, (p + q) * 0.5, q];
    let message = |ab: &[Point], bc: &[Point], ca: &[Point]| {
        TriangleNet::from_boundary(ab, bc, ca).unwrap_err().to_string()
    };
    let text = message(&mid(a, b), &[b, c], &mid(c, a));
    assert_eq!(text, "border row bc has 2 points and ab has 3; all three sides need the same number");
    assert!(message(&[a], &[b, c], &[c, a]).contains("row ab has 1 points"));
    let text = message(&[a, b], &[b, c], &[c, b]);
    assert!(text.contains("start of ab (A)") && text.contains("end of ca (A)"), "{text}");
    let text = message(&[a, c], &[b, c], &[c, a]);
    assert!(text.contains("end of ab (B)") && text.contains("start of bc (B)"), "{text}");
    let text = message(&[a, b], &[b, a], &[c, a]);
    assert!(text.contains("end of bc (C)") && text.contains("start of ca (C)"), "{text}");
    let nan = Point::new(f64::NAN, 0.0, 0.0);
    assert_eq!(
        TriangleNet::from_boundary(&[nan, b], &[b, c], &[c, nan]),
        Err(SurfaceError::NotFinite { index: 2 })
    );
    let long = vec![a; 66];
    assert!(matches!(
        TriangleNet::from_boundary(&long, &long, &long),
        Err(SurfaceError::Basis(BasisError::Degree { degree: 65, max: 64, .. }))
    ));
    let net = TriangleNet::from_boundary(&[a, b], &[b, c], &[c, a]).unwrap();
    assert!(net.raised(usize::MAX).is_err() && net.raised(64).is_err() && net.raised(63).is_ok());
    assert_eq!(
        net.with_coordinates(&[0.0; 10]),
        Err(SurfaceError::TriangleSize { degree: 1, expected: 3, found: 3 })
    );
    assert!(TriangleNet::new(0, vec![a]).is_err() && TriangleNet::new(2, vec![a; 5]).is_err());
    assert!(TriangleBasis::new(65).is_err());
}

#[test]
fn meshes_have_no_degenerate_triangles_and_converge() {
    // Stereographic-like cap: smooth and regular.
    let family = basis(3);
    let points =
        family.indices().map(|[i, j, k]| Point::new(i as f64, j as f64, (i * j * k) as f64)).collect();
    let patch = TrianglePatch::new(TriangleNet::new(3, points).unwrap()).unwrap();
    assert_eq!(patch.domain(), Domain::Triangle);
    let mut last = f64::NAN;
    for n in [1, 2, 7, 14, 28] {
        let mesh = Mesh::of(&patch, n);
        assert_eq!((mesh.points.len(), mesh.triangles.len()), ((n + 1) * (n + 2) / 2, n * n));
        for [a, b, c] in &mesh.triangles {
            let [p, q, r] = [a, b, c].map(|k| mesh.points[*k as usize]);
            let normal = (q - p).cross(r - p);
            assert!(normal.norm() >= 0.5 * 9.0 / (n * n) as f64, "subdivision {n}");
            assert!(normal.dot(mesh.normals[*a as usize]) > 0.0);
            let [s, t, m] = [a, b, c].map(|k| mesh.parameters[*k as usize]);
            let twice = (t[0] - s[0]) * (m[1] - s[1]) - (t[1] - s[1]) * (m[0] - s[0]);
            assert!(
                (twice * (n * n) as f64 - 1.0).abs() < 1e-9,
                "every triangle has its share of the domain"
            );
        }
        if n == 28 {
            assert!((mesh.area() / last - 1.0).abs() < 1e-3, "{} {last}", mesh.area());
        }
        last = mesh.area();
    }
}

#[test]
fn a_net_of_one_span_is_its_own_coons_net() {
    let p = |x: f64, y: f64| Point::new(x, y, x * y);
    let net = discrete_coons(
        &[p(0., 0.), p(0., 1.)],
        &[p(1., 0.), p(1., 1.)],
        &[p(0., 0.), p(1., 0.)],
        &[p(0., 1.), p(1., 1.)],
    );
    assert_eq!(net.unwrap(), Net::new(2, 2, vec![p(0., 0.), p(0., 1.), p(1., 0.), p(1., 1.)]).unwrap());
}
