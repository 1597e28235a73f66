//! Proved lower bounds, held against areas known in closed form.

use plateau::{Competitors, Fill, Loop, NoBound, least_area_raised, lower_bound, lower_bound_of_net};
use surfaces::{Bezier, Complex, FixedEdge, Net, Point, Vertex};

/// The quadrilateral with straight sides, as one face of degree p in its Coons start.
fn quadrilateral(corners: [[f64; 3]; 4], degree: usize) -> Complex {
    let corners = corners.map(Point::from);
    let vertices = corners.map(Vertex::Fixed);
    let edges: Vec<FixedEdge> = (0..4)
        .map(|k| {
            let ends = [k, (k + 1) % 4];
            FixedEdge { ends, curve: Bezier::new(ends.map(|v| corners[v]).to_vec()).expect("two points") }
        })
        .collect();
    Complex::new(degree, &vertices, &[[0, 1, 2, 3]], &edges).expect("a sound complex")
}

#[test]
fn the_skew_quadrilateral_has_at_least_its_area() {
    // K(¾)/K(¼), complete elliptic integrals by parameter.
    let least = 1.279261571171006;
    let mut gaps = Vec::new();
    for degree in [2, 4, 6] {
        let frame = [[0., 0., 0.], [1., 0., 0.], [1., 1., 1.], [0., 1., 0.]];
        let bound = lower_bound(&quadrilateral(frame, degree)).expect("a graph over a convex region");
        assert_eq!(bound.competitors, Competitors::Surfaces);
        assert!(bound.value <= least, "{degree}: {}", bound.value);
        gaps.push(least - bound.value);
    }
    // From degree 4 on what is left is the rounding that is taken off.
    assert!(gaps[0] > gaps[1] && gaps[1].max(gaps[2]) < 1e-11, "{gaps:?}");
}

/// The gap to the least area of the saddle frame over one patch: cut in four, the potential follows its corners.
#[test]
fn one_patch_bounds_the_saddle_as_four_do() {
    let side = |a: [f64; 3], b: [f64; 3], c: [f64; 3]| [a, b, c].map(Point::from);
    let least = 7.383505602602;
    for (degree, most) in [(4, 2.6e-6), (6, 3.8e-8), (8, 5.4e-9)] {
        let border = Net::from_boundary(
            &side([-1., -1., 0.], [-1., 0., 2.], [-1., 1., 0.]),
            &side([1., -1., 0.], [1., 0., 2.], [1., 1., 0.]),
            &side([-1., -1., 0.], [0., -1., -2.], [1., -1., 0.]),
            &side([-1., 1., 0.], [0., 1., -2.], [1., 1., 0.]),
        )
        .expect("four sides");
        let surface = border.raised(degree - 2);
        let bound = lower_bound_of_net(&border, &surface).expect("a graph");
        assert_eq!((bound.competitors, bound.faces.len()), (Competitors::Surfaces, 4));
        assert!((0.0..most).contains(&(least - bound.value)), "{degree}: {}", bound.value);
    }
}

/// Around small patches the system of the potential is singular to working precision: it is solved a little beside, and bounds all the same.
#[test]
fn a_layer_of_small_patches_at_high_degree_is_bounded_too() {
    let side = |points: [[f64; 3]; 3]| points.map(Point::from).to_vec();
    let sides = vec![
        side([[-1., -1., 0.], [0., -1., -2.], [1., -1., 0.]]),
        side([[1., -1., 0.], [1., 0., 2.], [1., 1., 0.]]),
        side([[1., 1., 0.], [0., 1., -2.], [-1., 1., 0.]]),
        side([[-1., 1., 0.], [-1., 0., 2.], [-1., -1., 0.]]),
    ];
    let fill = Fill::default().with_degree(9).with_layers(1).with_bound(true);
    let film = fill.loops(&[Loop::sides(sides).expect("a loop")], &()).expect("a film");
    let bound = film.bound.expect("a graph");
    let gap = film.figures.area.value - bound.value;
    assert_eq!(bound.competitors, Competitors::Surfaces);
    assert!((0.0..1e-9).contains(&gap), "{gap:e}");
}

#[test]
fn a_rim_that_is_not_convex_bounds_graphs_only() {
    let corners = [[0., 0., 0.], [1., 0., 0.2], [1., 1., 0.], [0., 1., 0.2]].map(Point::from);
    let edges: Vec<FixedEdge> = (0..4)
        .map(|k| {
            let ends = [k, (k + 1) % 4];
            // The first side dips into the square.
            let middle = (corners[ends[0]] + corners[ends[1]]) * 0.5
                + Point::new(0.0, if k == 0 { 0.2 } else { 0.0 }, 0.0);
            let curve = Bezier::new(vec![corners[ends[0]], middle, corners[ends[1]]]).expect("three points");
            FixedEdge { ends, curve }
        })
        .collect();
    let frame =
        Complex::new(4, &corners.map(Vertex::Fixed), &[[0, 1, 2, 3]], &edges).expect("a sound complex");
    let bound = lower_bound(&frame).expect("a graph");
    assert_eq!(bound.competitors, Competitors::Graphs);
}

#[test]
fn a_surface_that_turns_over_is_no_graph() {
    // A band round a cylinder: its normals point everywhere.
    let at = |k: usize, radius: f64, height: f64| {
        let angle = (k % 6) as f64 * std::f64::consts::TAU / 6.0;
        Point::new(radius * angle.cos(), radius * angle.sin(), height)
    };
    let corner = |v: usize| at(2 * (v % 3), 1.0, f64::from(u8::from(v >= 3)));
    let vertices: Vec<Vertex> = (0..6).map(|v| Vertex::Fixed(corner(v))).collect();
    let faces = [[0, 1, 4, 3], [1, 2, 5, 4], [2, 0, 3, 5]];
    let edges: Vec<FixedEdge> = (0..6)
        .map(|v| {
            let ends = [v, 3 * (v / 3) + (v + 1) % 3];
            let middle = at(2 * (v % 3) + 1, 2.0, f64::from(u8::from(v >= 3)));
            let curve = Bezier::new(vec![corner(ends[0]), middle, corner(ends[1])]).expect("three points");
            FixedEdge { ends, curve }
        })
        .collect();
    let band = Complex::new(3, &vertices, &faces, &edges).expect("a sound complex");
    assert_eq!(lower_bound(&band), Err(NoBound::NoGraph));
}

/// A net of degree (2, 2) over a quadrilateral near the square [−1, 1]², its heights from a generator of small numbers.
fn random_frame(random: &mut impl FnMut() -> f64) -> Net {
    let mut points: Vec<Point> =
        (0..9).map(|k| Point::new(f64::from(k / 3) - 1.0, f64::from(k % 3) - 1.0, 0.8 * random())).collect();
    for corner in [0, 2, 6, 8] {
        points[corner] += Point::new(0.25 * random(), 0.25 * random(), 0.0);
    }
    for (middle, ends) in [(1, [0, 2]), (3, [0, 6]), (5, [2, 8]), (7, [6, 8])] {
        let [a, b] = ends.map(|k| points[k]);
        (points[middle].x, points[middle].y) = (0.5 * (a.x + b.x), 0.5 * (a.y + b.y));
    }
    Net::new(3, 3, points).expect("nine points").with_all_fixed()
}

#[test]
fn no_bound_of_two_hundred_graphs_is_above_their_least_area() {
    let mut state = 1_u64;
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        2.0 * (state >> 11) as f64 / (1_u64 << 53) as f64 - 1.0
    };
    let mut proved = 0;
    for frame in 0..200 {
        let border = random_frame(&mut random);
        let (near, _) = least_area_raised(&border, 1, &[], 1e-6, &()).expect("a least area");
        let Ok(bound) = lower_bound_of_net(&border, near.net()) else { continue };
        proved += 1;
        let (_, least) = least_area_raised(&border, 5, &[], 1e-9, &()).expect("a least area");
        let gap = least.area.value - bound.value;
        // At degree 7 the area is itself above the least; the bound is not above even that, and close to it.
        assert!(
            gap >= 0.0 && gap < 1e-3 * bound.value,
            "frame {frame}: {} {}",
            bound.value,
            least.area.value
        );
    }
    assert!(proved >= 190, "{proved}");
}
