//! Generalized helicoids from control nets, whole, in pieces and deformed.

use std::collections::HashMap;

use bases::BasisError;
use proptest::prelude::*;
use surfaces::{
    Deformation, DeformationPath, Domain, Helicoid, Jet, Mesh, Patch, Pieces, Point, SurfaceError,
    TensorPatch,
};

const U: f64 = f64::EPSILON / 2.0;

/// The largest distance of a point from the origin: what coordinates are rounded against.
fn reach(jets: &[Jet]) -> f64 {
    jets.iter().fold(0.0, |m: f64, j| m.max(j.point.norm()))
}

fn grid(patch: &dyn Patch, n: usize) -> (Vec<f64>, Vec<f64>) {
    let Domain::Rectangle { u, v } = patch.domain() else { panic!("a rectangle") };
    let steps = |(s, e): (f64, f64)| {
        (0..=n).map(|k| if k == n { e } else { s + (e - s) * k as f64 / n as f64 }).collect()
    };
    (steps(u), steps(v))
}

fn jets(patch: &dyn Patch, n: usize) -> Vec<Jet> {
    let (us, vs) = grid(patch, n);
    patch.jets(&us, &vs)
}

/// Spans of one patch: from 10⁻⁶ to 0.9 of the bound.
fn span() -> impl Strategy<Value = f64> {
    prop_oneof![1 => (-6.0..0.0f64).prop_map(|x| 10f64.powf(x)), 2 => 0.1..Helicoid::LARGEST_PIECE]
}

fn weights() -> impl Strategy<Value = [f64; 2]> {
    let w = || prop_oneof![4 => -3.0..3.0f64, 1 => Just(0.0), 1 => Just(1.0)];
    [w(), w()].prop_filter("not both 0", |w| *w != [0.0, 0.0])
}

/// How often each undirected edge occurs among the triangles.
fn edges(triangles: &[[u32; 3]]) -> HashMap<(u32, u32), usize> {
    let mut edges = HashMap::new();
    for &[a, b, c] in triangles {
        for (p, q) in [(a, b), (b, c), (c, a)] {
            *edges.entry((p.min(q), p.max(q))).or_insert(0) += 1;
        }
    }
    edges
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn the_patch_is_the_closed_form([a, b] in weights(), us in span(), vs in span()) {
        let helicoid = Helicoid::new(a, b, us, vs).unwrap();
        let patch = helicoid.patch().unwrap();
        let size = reach(&jets(&helicoid, 6));
        let deviation = helicoid.deviation(&patch, 6);
        prop_assert!(deviation <= 1e-12 * size, "{deviation} of {size}");
    }

    #[test]
    fn it_is_minimal_and_isothermal([a, b] in weights(), us in span(), vs in span()) {
        let helicoid = Helicoid::new(a, b, us, vs).unwrap();
        let (exact, ours) = (jets(&helicoid, 5), jets(&helicoid.patch().unwrap(), 5));
        let reach = reach(&exact);
        let h = us.min(vs);
        for (exact, ours) in exact.iter().zip(&ours) {
            let speed = exact.u.norm();
            // Coordinates are rounded to u · reach, which first and second derivatives see divided by h and h².
            let (first, second) = (64.0 * U * reach / h, 1024.0 * U * reach / (h * h));
            for (a, b) in [(ours.u, exact.u), (ours.v, exact.v)] {
                prop_assert!(a.distance(b) <= 1e-12 * speed + first, "{a:?} {b:?}");
            }
            for (a, b) in [(ours.uu, exact.uu), (ours.uv, exact.uv), (ours.vv, exact.vv)] {
                prop_assert!(a.distance(b) <= 1e-12 * speed.max(reach) + second, "{a:?} {b:?}");
            }
            let f = ours.first_form();
            prop_assert!((f.e - f.g).abs() <= speed * (1e-12 * speed + first), "E − G = {}", f.e - f.g);
            prop_assert!(f.f.abs() <= speed * (1e-12 * speed + first), "F = {}", f.f);
            let bending = (exact.uu.norm() + exact.uv.norm()) / (speed * speed);
            // Where tangents are lost in rounding there is no normal to speak of.
            if let Some(mean) = ours.mean_curvature().filter(|_| first < 0.01 * speed) {
                prop_assert!(mean.abs() <= 1e-11 * bending + second / (speed * speed), "H = {mean} of {bending}");
            }
        }
    }

    #[test]
    fn the_closed_form_is_minimal_and_isothermal([a, b] in weights(), u in -4.0..4.0f64, v in -20.0..20.0f64) {
        let jet = Helicoid::over(a, b, (-4.0, 4.0), (-20.0, 20.0)).unwrap().jet(u, v);
        let f = jet.first_form();
        let metric = (a * a + b * b) * u.cosh().powi(2);
        prop_assert!((f.e - metric).abs() <= 64.0 * U * metric && (f.g - metric).abs() <= 64.0 * U * metric);
        prop_assert!(f.f.abs() <= 64.0 * U * metric);
        prop_assert!(jet.mean_curvature().unwrap().abs() <= 64.0 * U / metric.sqrt() * u.cosh());
        // K = −1/((a² + b²) cosh⁴ u): the same for all (a, b) of one length.
        let gauss = jet.gauss_curvature().unwrap() * (a * a + b * b) * u.cosh().powi(4);
        prop_assert!((gauss + 1.0).abs() <= 1e-12, "{gauss}");
    }

    #[test]
    fn pieces_are_the_closed_form([a, b] in weights(), u0 in -10.0..5.0f64, us in 0.1..15.0f64, v0 in -50.0..50.0f64, vs in 0.1..100.0f64) {
        let helicoid = Helicoid::over(a, b, (u0, u0 + us), (v0, v0 + vs)).unwrap();
        let pieces = helicoid.pieces().unwrap();
        let deviation = helicoid.deviation(&pieces, 23);
        let size = reach(&jets(&helicoid, 10));
        prop_assert!(deviation <= 1e-12 * size, "{deviation} of {size}");
    }

    #[test]
    fn neighbours_share_their_edges_bit_for_bit([a, b] in weights(), u0 in -10.0..5.0f64, v0 in -50.0..50.0f64) {
        let helicoid = Helicoid::over(a, b, (u0, u0 + 17.0), (v0, v0 + 16.0)).unwrap();
        let pieces = helicoid.pieces().unwrap();
        let [rows, cols] = pieces.shape();
        prop_assert_eq!([rows, cols], [3, 3]);
        let edge = |patch: &TensorPatch, end_u: bool, end: bool| {
            let (us, vs) = grid(patch, 7);
            let at = |ts: &[f64]| if end { ts[7] } else { ts[0] };
            let jets = if end_u { patch.jets(&[at(&us)], &vs) } else { patch.jets(&us, &[at(&vs)]) };
            jets.iter().map(|j| j.point).collect::<Vec<Point>>()
        };
        for i in 0..rows {
            for j in 0..cols {
                let here = &pieces.patches()[i * cols + j];
                if i + 1 < rows {
                    prop_assert_eq!(edge(here, true, true), edge(&pieces.patches()[(i + 1) * cols + j], true, false));
                }
                if j + 1 < cols {
                    prop_assert_eq!(edge(here, false, true), edge(&pieces.patches()[i * cols + j + 1], false, false));
                }
            }
        }
    }

    #[test]
    fn subdivision_gives_the_nets_of_the_parts([a, b] in weights(), us in span(), vs in span(), x in 0.05..0.95f64) {
        let helicoid = Helicoid::new(a, b, us, vs).unwrap();
        let patch = helicoid.patch().unwrap();
        let reach = reach(&jets(&helicoid, 6));
        let (cu, cv) = (x * us, x * vs);
        let [left, right] = patch.subdivide_u(cu).unwrap();
        let [low, high] = patch.subdivide_v(cv).unwrap();
        prop_assert_eq!(&left.net().points()[30..], &right.net().points()[..6]);
        for i in 0..6 {
            prop_assert_eq!(low.net().point(i, 5), high.net().point(i, 0));
        }
        for (part, u, v) in [
            (&left, (0.0, cu), (0.0, vs)),
            (&right, (cu, us), (0.0, vs)),
            (&low, (0.0, us), (0.0, cv)),
            (&high, (0.0, us), (cv, vs)),
        ] {
            let exact = Helicoid::over(a, b, u, v).unwrap().patch().unwrap();
            // Control points lie within a few times the surface's reach of it.
            let scale = exact.net().points().iter().fold(reach, |m, p| m.max(p.norm()));
            for (ours, exact) in part.net().points().iter().zip(exact.net().points()) {
                prop_assert!(ours.distance(*exact) <= 1e-12 * scale, "{ours:?} {exact:?}");
            }
        }
    }

    #[test]
    fn nets_are_linear_in_the_weights([a, b] in weights(), us in span(), vs in span()) {
        let net = |a: f64, b: f64| Helicoid::new(a, b, us, vs).unwrap().patch().unwrap().net().clone();
        let (whole, right, catenoid) = (net(a, b), net(1.0, 0.0), net(0.0, 1.0));
        for k in 0..36 {
            let sum = right.points()[k] * a + catenoid.points()[k] * b;
            let scale = right.points()[k].norm() * a.abs() + catenoid.points()[k].norm() * b.abs();
            prop_assert!(whole.points()[k].distance(sum) <= 8.0 * U * scale);
        }
    }

    #[test]
    fn every_frame_is_a_minimal_surface(lambda in 0.0..=1.0f64, us in 0.3..2.0f64, vs in 0.3..16.0f64, path in 0..3usize) {
        let path = [DeformationPath::Linear, DeformationPath::Trigonometric, DeformationPath::Bernstein { degree: 3 }][path];
        let deformation = Deformation::new(path, us, vs).unwrap();
        let surface = deformation.surface(lambda).unwrap();
        let exact = deformation.closed_form(lambda).unwrap();
        let [a, b] = path.weights(lambda);
        let size = a.hypot(b) * (us.cosh() + us + vs);
        prop_assert!(exact.deviation(&surface, 9) <= 1e-12 * size);
        for jet in jets(&surface, 5) {
            let f = jet.first_form();
            prop_assert!(jet.mean_curvature().unwrap().abs() * f.e.sqrt() <= 1e-10);
        }
    }
}

#[test]
fn bending_along_the_circle_keeps_every_length() {
    let deformation = Deformation::new(DeformationPath::Trigonometric, 1.5, 6.0).unwrap();
    let start = jets(&deformation.surface(0.0).unwrap(), 12);
    let linear = Deformation::new(DeformationPath::Linear, 1.5, 6.0).unwrap();
    for surface in deformation.frames(7) {
        for (jet, start) in jets(&surface.unwrap(), 12).iter().zip(&start) {
            let (f, g) = (jet.first_form(), start.first_form());
            assert!(
                (f.e - g.e).abs() <= 1e-12 * g.e
                    && (f.g - g.g).abs() <= 1e-12 * g.e
                    && f.f.abs() <= 1e-12 * g.e
            );
        }
    }
    // The linear path shrinks the surface half-way to √½.
    let half = jets(&linear.surface(0.5).unwrap(), 1)[0].u.norm();
    assert!((half - 0.5f64.sqrt()).abs() < 1e-13, "{half}");
}

#[test]
fn a_deformation_starts_at_the_helicoid_and_ends_at_the_catenoid() {
    for path in
        [DeformationPath::Linear, DeformationPath::Trigonometric, DeformationPath::Bernstein { degree: 5 }]
    {
        assert_eq!(path.weights(0.0), [1.0, 0.0]);
        assert_eq!(path.weights(1.0), [0.0, 1.0]);
        let frames: Vec<Pieces> =
            Deformation::new(path, 1.5, 20.0).unwrap().frames(3).collect::<Result<_, _>>().unwrap();
        assert_eq!(frames.len(), 3);
        let two: Vec<Pieces> =
            Deformation::new(path, 1.5, 20.0).unwrap().frames(2).collect::<Result<_, _>>().unwrap();
        let net = |p: &Pieces| p.patches().iter().map(|p| p.net().clone()).collect::<Vec<_>>();
        for (frame, a, b) in
            [(&frames[0], 1.0, 0.0), (&frames[2], 0.0, 1.0), (&two[0], 1.0, 0.0), (&two[1], 0.0, 1.0)]
        {
            assert_eq!(net(frame), net(&Helicoid::new(a, b, 1.5, 20.0).unwrap().pieces().unwrap()));
        }
    }
    assert_eq!(Deformation::new(DeformationPath::Linear, 1.0, 1.0).unwrap().frames(0).count(), 0);
    assert_eq!(Deformation::new(DeformationPath::Linear, 1.0, 1.0).unwrap().frames(1).count(), 1);
}

#[test]
fn deformations_without_a_surface_are_errors() {
    let none = Deformation::new(DeformationPath::Bernstein { degree: 0 }, 1.0, 1.0).unwrap_err();
    assert!(matches!(none, SurfaceError::Basis(BasisError::Degree { degree: 0, min: 1, .. })));
    let steep = Deformation::new(DeformationPath::Bernstein { degree: 3000 }, 1.0, 1.0).unwrap();
    assert!(matches!(steep.surface(0.5), Err(SurfaceError::Weights { .. })));
    assert!(matches!(steep.surface(f64::NAN), Err(SurfaceError::Weights { .. })));
    assert!(matches!(steep.closed_form(0.5), Err(SurfaceError::Weights { .. })));
}

#[test]
fn the_right_helicoid_and_the_catenoid() {
    // b = 0: rulings through the axis at height v. a = 0: a surface of revolution with meridian cosh.
    let right = Helicoid::new(2.0, 0.0, 1.5, 6.0).unwrap().patch().unwrap();
    let catenoid = Helicoid::over(0.0, 1.0, (-1.5, 1.5), (0.0, 6.0)).unwrap().patch().unwrap();
    for k in 0..=10 {
        let v = 0.6 * f64::from(k);
        let p = right.point(0.9, v);
        assert!((p.x * v.sin() - p.y * v.cos()).abs() < 1e-14 && (p.z - 2.0 * v).abs() < 1e-14);
        let p = catenoid.point(1.0, v);
        assert!((p.x.hypot(p.y) - 0.5f64.cosh()).abs() < 1e-14 && (p.z + 0.5).abs() < 1e-14);
    }
}

#[test]
fn ten_turns_are_one_watertight_mesh() {
    let turns = Helicoid::over(1.0, 0.5, (-2.0, 2.0), (0.0, 20.0 * std::f64::consts::PI)).unwrap();
    assert!(matches!(turns.patch(), Err(SurfaceError::Basis(BasisError::Span { .. }))));
    let pieces = turns.pieces().unwrap();
    assert_eq!(pieces.shape(), [1, 9]);

    let n = 60;
    let mesh = Mesh::of(&pieces, n);
    let edges = edges(&mesh.triangles);
    assert!(edges.values().all(|count| *count <= 2));
    let boundary: Vec<_> = edges.iter().filter(|(_, count)| **count == 1).map(|(edge, _)| *edge).collect();
    assert_eq!(boundary.len(), 4 * n);
    let [(u0, u1), (v0, v1)] = [(-2.0, 2.0), (0.0, 20.0 * std::f64::consts::PI)];
    for (p, q) in boundary {
        let ([up, vp], [uq, vq]) = (mesh.parameters[p as usize], mesh.parameters[q as usize]);
        let on = |a: f64, b: f64, ends: [f64; 2]| a == b && ends.contains(&a);
        assert!(on(up, uq, [u0, u1]) || on(vp, vq, [v0, v1]), "an open edge inside");
    }
    // Euler characteristic of a disk.
    assert_eq!(mesh.points.len() as i64 - edges.len() as i64 + mesh.triangles.len() as i64, 1);
    let size = mesh.points.iter().fold(0.0, |m: f64, p| m.max(p.norm()));
    for (p, [u, v]) in mesh.points.iter().zip(&mesh.parameters) {
        assert!(p.distance(turns.point(*u, *v)) <= 1e-13 * size);
    }
}

#[test]
fn meshes_of_the_pieces_weld_into_one() {
    let pieces = Helicoid::over(1.0, 2.0, (-8.0, 8.0), (0.0, 30.0)).unwrap().pieces().unwrap();
    let mut places: HashMap<[u64; 3], u32> = HashMap::new();
    let mut triangles = Vec::new();
    let n = 6;
    for patch in pieces.patches() {
        let mesh = Mesh::of(patch, n);
        let welded: Vec<u32> = mesh
            .points
            .iter()
            .map(|p| {
                let next = places.len() as u32;
                // Adding 0 makes −0 and 0 one.
                *places.entry([p.x, p.y, p.z].map(|c| (c + 0.0).to_bits())).or_insert(next)
            })
            .collect();
        triangles.extend(mesh.triangles.iter().map(|t| t.map(|k| welded[k as usize])));
    }
    let [rows, cols] = pieces.shape();
    assert_eq!(places.len(), (rows * n + 1) * (cols * n + 1));
    let open = edges(&triangles).values().filter(|count| **count == 1).count();
    assert_eq!(open, 2 * n * (rows + cols));
}

#[test]
fn bad_helicoids_are_errors() {
    assert_eq!(Helicoid::new(0.0, 0.0, 1.0, 1.0).unwrap_err(), SurfaceError::Weights { a: 0.0, b: 0.0 });
    assert!(matches!(Helicoid::new(f64::NAN, 1.0, 1.0, 1.0), Err(SurfaceError::Weights { .. })));
    for span in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(Helicoid::new(1.0, 1.0, span, 1.0), Err(SurfaceError::Interval { name: "u", .. })));
        assert!(matches!(Helicoid::new(1.0, 1.0, 1.0, span), Err(SurfaceError::Interval { name: "v", .. })));
    }
    let endless = Helicoid::new(1.0, 1.0, 1.0, 1e9).unwrap();
    assert!(matches!(endless.pieces(), Err(SurfaceError::TooManyPieces { name: "v", .. })));
    let huge = Helicoid::new(1.0, 1.0, 800.0, 1.0).unwrap();
    assert!(matches!(huge.pieces(), Err(SurfaceError::NotFinite { .. })));
    let message = Helicoid::new(1.0, 1.0, 1.0, 8.0).unwrap().patch().unwrap_err().to_string();
    assert!(message.contains("7.853204624095837"), "{message}");
}

#[test]
fn pieces_are_their_patches_and_cuts() {
    let whole = Helicoid::new(1.0, 2.0, 1.0, 20.0).unwrap().pieces().unwrap();
    let [u, v] = whole.cuts().map(<[f64]>::to_vec);
    let patches = whole.patches().to_vec();
    let [rows, cols] = whole.shape();
    assert_eq!((rows, cols), (1, 3));
    let again = Pieces::from_patches(u.clone(), v.clone(), patches.clone()).unwrap();
    assert_eq!(jets(&again, 40), jets(&whole, 40));
    let refused = |u: &[f64], v: &[f64], patches: &[TensorPatch]| {
        Pieces::from_patches(u.to_vec(), v.to_vec(), patches.to_vec()).unwrap_err()
    };
    let interval = |error: SurfaceError, axis: &str| {
        assert!(matches!(error, SurfaceError::Interval { name, .. } if name == axis), "{error}");
    };
    interval(refused(&[], &v, &patches), "u");
    interval(refused(&u, &[v[0]], &patches), "v");
    interval(refused(&u, &[v[1], v[0]], &patches[..1]), "v");
    interval(refused(&u, &[v[0], f64::NAN], &patches[..1]), "v");
    interval(refused(&[u[0], 2.0 * u[1]], &v, &patches), "u");
    let error = refused(&u, &v, &patches[1..]);
    assert!(matches!(error, SurfaceError::Size { rows: 1, cols: 3, found: 2 }), "{error}");
    let many: Vec<f64> = (0..Pieces::MAX_PIECES + 2).map(|k| k as f64).collect();
    let error = refused(&u, &many, &patches);
    assert!(matches!(error, SurfaceError::TooManyPieces { name: "v", .. }), "{error}");
}
