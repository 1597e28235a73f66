//! Layers of smaller patches around corners.

use plateau::{
    Boundary, Context, Fill, Film, Functions, Loop, Method, MethodFault, Surface, TensorBoundary,
    TensorInterior, Warning, estimate_complex, least_area_complex_near, odd_corners, solve,
};
use surfaces::{Bezier, BoundaryCurve, Point};

/// A hexagon with a re-entrant corner.
fn concave() -> Loop {
    let corners = [[0., 0., 0.], [2., 0., 0.5], [2., 1., 0.], [1., 1., 0.6], [1., 2., 0.], [0., 2., 0.5]]
        .map(Point::from);
    Loop::polygon(&corners).expect("a polygon")
}

/// Its least area: degree 8 within two layers gives these digits whether they take 0.1 or 0.25 of the patches, and a program of its own
/// (NumPy, other patches, Gauss–Lobatto points) agrees to 3e-12 at degree 8 within three layers.
const CONCAVE: f64 = 3.180_501_003_610;

/// The rim of z = x² − y² over [−1, 1]².
fn saddle() -> Loop {
    let side = |points: [[f64; 3]; 3]| {
        BoundaryCurve::Bezier(Bezier::new(points.map(Point::from).to_vec()).expect("a curve"))
    };
    let sides = vec![
        side([[-1., -1., 0.], [0., -1., -2.], [1., -1., 0.]]),
        side([[1., -1., 0.], [1., 0., 2.], [1., 1., 0.]]),
        side([[1., 1., 0.], [0., 1., -2.], [-1., 1., 0.]]),
        side([[-1., 1., 0.], [-1., 0., 2.], [-1., -1., 0.]]),
    ];
    Loop::new(sides, None).expect("a loop")
}

const SADDLE: f64 = 7.383_505_602_602;

fn filled(fill: Fill, rim: Loop) -> Film {
    fill.loops(&[rim], &()).expect("a film")
}

#[test]
fn the_least_area_of_the_concave_hexagon_depends_on_no_layer() {
    for share in [0.1, 0.25] {
        let mut film = filled(Fill::default().with_degree(8).with_tolerance(1e-11), concave()).into_complex();
        let corners = odd_corners(&film);
        assert_eq!(corners.len(), 6);
        let mut least = f64::INFINITY;
        for _ in 0..2 {
            let graded = film.graded(&corners, share).expect("a layer");
            let (finer, found) = least_area_complex_near(&graded, 1e-11, &()).expect("a least area");
            (film, least) = (finer, found.area.value);
        }
        assert!((least - CONCAVE).abs() < 3e-12, "{share}: {least}");
    }
}

#[test]
fn what_is_asked_for_is_reached_and_said() {
    // The hexagon's patches crowd towards its corners by themselves, and its degree is enough; the saddle's one patch cannot.
    for (rim, least, accuracy, layers) in [(concave(), CONCAVE, 3e-9, 0), (saddle(), SADDLE, 1e-11, 1)] {
        let film = filled(Fill::default().with_accuracy(accuracy), rim);
        let above = film.figures.area.value - least;
        let estimate = film.estimate.expect("an estimate");
        assert!(above < 1e-8 && estimate <= accuracy * least, "{above} {estimate}");
        // Both areas are known to 1e-12.
        assert!((0.7 * (above - 1e-12)..1.5 * (above + 1e-12)).contains(&estimate), "{estimate} of {above}");
        assert_eq!(film.layers, layers);
        let is_said = film.warnings.iter().any(|warning| matches!(warning, Warning::LayerSet { .. }));
        assert_eq!(is_said, layers > 0, "{:?}", film.warnings);
        assert!(!film.warnings.iter().any(|warning| matches!(warning, Warning::Inaccurate { .. })));
    }
}

#[test]
fn a_layer_brings_the_saddle_a_hundred_times_nearer() {
    for (degree, most) in [(4, 5e-9), (6, 5e-10), (8, 1e-11)] {
        let above = |layers: usize| {
            let film = filled(Fill::default().with_degree(degree).with_layers(layers), saddle());
            assert_eq!((film.layers, film.warnings.len()), (layers, 0), "{:?}", film.warnings);
            let found = film.extremal.as_ref().expect("a least area");
            let estimate = estimate_complex(film.complex(), found, &()).expect("an estimate");
            let above = film.figures.area.value - SADDLE;
            // The area is known to 1e-12.
            if above > 1e-10 {
                let effectivity = estimate.expect("one that falls") / above;
                assert!((0.7..1.5).contains(&effectivity), "degree {degree}, {layers}: {effectivity}");
            }
            above / SADDLE
        };
        let (without, with) = (above(0), above(1));
        assert!(with < most && with < 1e-2 * without, "degree {degree}: {without} to {with}");
    }
}

/// Reflections continue a surface across straight sides at 180°/k: there is nothing to refine.
#[test]
fn corners_between_straight_sides_at_parts_of_a_straight_angle_get_none() {
    let corners =
        [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [1., 1., 1.], [0., 1., 1.], [0., 0., 1.]].map(Point::from);
    let film = filled(Fill::default().with_layers(1), Loop::polygon(&corners).expect("a polygon"));
    assert_eq!((odd_corners(film.complex()), film.layers), (vec![], 0));
    assert!(matches!(film.warnings[..], [Warning::NoLayer { wanted: 1, set: 0 }]), "{:?}", film.warnings);
    // One of 60°, one of 72°, curved ones, re-entrant ones.
    assert_eq!(odd_corners(filled(Fill::default().with_degree(4), saddle()).complex()).len(), 4);
}

/// Around the corner that looks in, the surface turns within a fraction of a patch, though it meets the corner at 90°.
#[test]
fn a_corner_where_the_surface_turns_away_gets_one() {
    let corners =
        [[0., 0., 0.], [2., 0., 0.], [2., 1., 1.], [1., 1., 0.], [1., 2., 0.], [0., 2., 0.]].map(Point::from);
    let rim = || Loop::polygon(&corners).expect("a polygon");
    let (without, with) = (filled(Fill::default(), rim()), filled(Fill::default().with_layers(1), rim()));
    assert_eq!((odd_corners(without.complex()), with.layers), (vec![6], 1));
    // Degrees 6 and 8 are estimated to lie 2.0e-7 and 5.9e-8 above it, their areas differ by 1.4e-7.
    const LEAST: f64 = 3.264_333_138_1;
    let [without, with] = [without, with].map(|film| film.figures.area.value - LEAST);
    assert!((1e-7..3e-7).contains(&without) && (0.0..2e-8).contains(&with), "{without} {with}");
}

/// What a film with a layer tells of itself is as of any: one name a vertex, a watertight mesh, small kinks, the same rim.
#[test]
fn a_film_with_a_layer_is_a_film() {
    let without = filled(Fill::default(), concave());
    let film = filled(Fill::default().with_layers(1), concave());
    assert_eq!((film.layers, film.names().len()), (1, film.complex().vertices()));
    let mut names = film.names().to_vec();
    names.sort();
    names.dedup();
    assert_eq!(names.len(), film.names().len());
    assert_eq!(&film.names()[..without.names().len()], without.names());
    assert!(film.seams.folded.is_empty() && film.seams.kink.is_some_and(|kink| kink.max < 0.01));
    let (mesh, triangles) = (&film.mesh.mesh, film.mesh.mesh.triangles.len());
    assert_eq!(triangles, 2 * 16 * 16 * film.complex().faces().len());
    assert!((mesh.area() / film.figures.area.value - 1.0).abs() < 1e-3);
    assert!(film.figures.area.value < without.figures.area.value);
}

/// Sides of a net with a layer are the loop that they make.
#[test]
fn four_sides_with_a_layer_are_a_film() {
    let side = |points: [[f64; 3]; 3]| points.map(Point::from).to_vec();
    let frame = TensorBoundary::new(
        side([[-1., -1., 0.], [0., -1., -2.], [1., -1., 0.]]),
        side([[-1., 1., 0.], [0., 1., -2.], [1., 1., 0.]]),
        side([[-1., -1., 0.], [-1., 0., 2.], [-1., 1., 0.]]),
        side([[1., -1., 0.], [1., 0., 2.], [1., 1., 0.]]),
    );
    let area = |layers| TensorInterior::LeastArea { tolerance: 1e-9, bound: true, layers };
    let method = Method::tensor("a", Functions::Bernstein, area(1))
        .and_then(|method| method.raised(2))
        .expect("a method");
    let done = solve(&Boundary::Tensor(frame.expect("sides")), &method, &Context::new(0)).expect("a surface");
    let film = filled(Fill::default().with_degree(4).with_layers(1).with_bound(true), saddle());
    let Surface::Complex(complex) = done.solved.surface() else { panic!("several patches") };
    assert_eq!((complex.faces().len(), complex.degree()), (film.complex().faces().len(), 4));
    assert!((done.figures.area.value / film.figures.area.value - 1.0).abs() < 1e-14);
    assert!(done.bound.is_some_and(|bound| bound.value < SADDLE) && done.film.is_some());
    let gt = plateau::FixedShape::new(surfaces::ShapedFamily::Gt, vec![1.0; 4]).expect("a shape");
    assert_eq!(
        Method::tensor(
            "a",
            Functions::Shaped(gt),
            TensorInterior::LeastArea { tolerance: 1e-9, bound: false, layers: 1 }
        ),
        Err(MethodFault::Layers)
    );
}
