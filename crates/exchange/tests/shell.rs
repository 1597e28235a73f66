//! Complexes as STEP files: every edge once, sewn.

use std::collections::HashMap;

use exchange::{Format, Subject, SurfaceFile};
use surfaces::{Complex, Point, Vertex};

fn text(complex: &Complex) -> String {
    let mesh = complex.mesh(2).unwrap().mesh;
    let subject = Subject { name: "sewn", mesh: &mesh, colours: None, unit: None };
    let mut out = Vec::new();
    SurfaceFile::of_complex(Format::Step, subject, complex).unwrap().write(&mut out).unwrap();
    String::from_utf8(out).unwrap()
}

fn entities<'a>(text: &'a str, kind: &'a str) -> impl Iterator<Item = (&'a str, &'a str)> {
    text.split(";\n")
        .filter_map(move |entity| entity.split_once('='))
        .filter_map(move |(number, rest)| Some((number, rest.strip_prefix(kind)?.strip_prefix('(')?)))
}

/// How often each edge is run with and against its sense.
fn senses(text: &str) -> HashMap<&str, [usize; 2]> {
    let mut senses: HashMap<&str, [usize; 2]> = HashMap::new();
    for (_, rest) in entities(text, "ORIENTED_EDGE") {
        let mut words = rest.trim_end_matches(')').split(',').skip(3);
        let (edge, sense) = (words.next().unwrap(), words.next().unwrap());
        senses.entry(edge).or_default()[usize::from(sense == ".F.")] += 1;
    }
    senses
}

fn complex(points: &[[f64; 3]], faces: &[[usize; 4]]) -> Complex {
    let vertices: Vec<Vertex> = points.iter().map(|&p| Vertex::Fixed(Point::from(p))).collect();
    Complex::new(3, &vertices, faces, &[]).unwrap()
}

const SIX: [[f64; 3]; 6] =
    [[0., 0., 0.], [1., 0., 0.], [2., 0., 1.], [0., 1., 0.], [1., 1., 1.], [2., 1., 0.]];

#[test]
fn neighbours_share_an_edge_and_run_it_in_opposite_senses() {
    // The second face is given in both senses: it comes out on the side of the first.
    for second in [[1, 2, 5, 4], [1, 4, 5, 2], [5, 2, 1, 4]] {
        let text = text(&complex(&SIX, &[[0, 1, 4, 3], second]));
        let senses = senses(&text);
        assert_eq!((senses.len(), entities(&text, "VERTEX_POINT").count()), (7, 6), "{second:?}");
        assert_eq!(senses.values().filter(|count| **count == [1, 1]).count(), 1, "{second:?}");
        assert_eq!(senses.values().filter(|[a, b]| a + b == 1).count(), 6, "{second:?}");
        assert_eq!(entities(&text, "OPEN_SHELL").count(), 1);
    }
}

#[test]
fn films_that_meet_in_threes_are_shells_of_one_model() {
    let mut points = SIX.to_vec();
    points.extend([[1., 0., 2.], [1., 1., 2.]]);
    let text = text(&complex(&points, &[[0, 1, 4, 3], [1, 2, 5, 4], [1, 6, 7, 4]]));
    assert_eq!(entities(&text, "OPEN_SHELL").count(), 3);
    let (_, model) = entities(&text, "SHELL_BASED_SURFACE_MODEL").next().unwrap();
    assert_eq!(model.matches('#').count(), 3);
    assert_eq!(senses(&text).values().filter(|[a, b]| a + b == 3).count(), 1);
}

#[test]
fn a_surface_without_a_rim_is_closed() {
    let cube: Vec<[f64; 3]> =
        (0..8).map(|k| [f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2)]).collect();
    let faces = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
    let text = text(&complex(&cube, &faces));
    assert_eq!((entities(&text, "CLOSED_SHELL").count(), entities(&text, "OPEN_SHELL").count()), (1, 0));
    assert!(senses(&text).values().all(|count| *count == [1, 1]));
}

#[test]
fn a_band_with_one_side_is_faces_by_themselves() {
    let corner = |k: i32| {
        let (s, c) = (f64::from(k % 3) * 2.0 * std::f64::consts::FRAC_PI_3).sin_cos();
        let (h, r) = (f64::from(k % 3) * std::f64::consts::FRAC_PI_3).sin_cos();
        let side = if k < 3 { 0.3 } else { -0.3 };
        [c * (1.0 + side * r), s * (1.0 + side * r), side * h]
    };
    let points: Vec<[f64; 3]> = (0..6).map(corner).collect();
    let text = text(&complex(&points, &[[0, 1, 4, 3], [1, 2, 5, 4], [2, 3, 0, 5]]));
    assert_eq!(entities(&text, "OPEN_SHELL").count(), 3);
}

#[test]
fn what_cad_programs_cannot_read_is_refused() {
    let tiny: Vec<[f64; 3]> = SIX.iter().map(|p| p.map(|x| 1e-9 * x)).collect();
    for complex in [
        complex(&tiny, &[[0, 1, 4, 3], [1, 2, 5, 4]]),
        complex(&SIX, &[[0, 1, 4, 3], [1, 2, 5, 4]]).with_degree(26).unwrap(),
    ] {
        let mesh = complex.mesh(2).unwrap().mesh;
        let subject = Subject { name: "", mesh: &mesh, colours: None, unit: None };
        assert!(SurfaceFile::of_complex(Format::Step, subject, &complex).is_err());
    }
}
