//! Loops and faces from the text of an experiment to their surfaces.

use experiment::{Finished, Options, Plan, run};
use plateau::{Done, Fill, Loop, Surface};
use surfaces::Point;

fn finished(text: &str) -> Finished {
    let plan = Plan::parse("film.toml", text).unwrap_or_else(|refusal| panic!("{refusal}"));
    run(&plan, Options::default(), &()).expect("it runs")
}

/// The surface of the one method of a text.
fn done(text: &str) -> Done {
    let [method] = <[_; 1]>::try_from(finished(text).results.into_methods()).expect("one method");
    *method.outcome.unwrap_or_else(|error| panic!("{error}"))
}

fn area(text: &str) -> f64 {
    done(text).figures.area.value
}

fn points(done: &Done) -> &[Point] {
    let Surface::Complex(complex) = done.solved.surface() else { panic!("a complex") };
    complex.points()
}

/// Six edges of a cube.
const HEXAGON: [[f64; 3]; 6] =
    [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [1., 1., 1.], [0., 1., 1.], [0., 0., 1.]];

fn boundary(of: &str, degree: usize) -> String {
    format!(
        "title = \"x\"\n[boundary]\n{of}\n[[method]]\nname = \"a\"\nenergy = \"area\"\ndegree = {degree}\n"
    )
}

/// Loops over straight curves, one for each corner of the hexagon, from it to the next.
fn of_curves(loops: &str) -> String {
    let curve = |k: usize| {
        let next = (k + 1) % 6;
        format!(
            "[[curve]]\nname = \"c{k}\"\nends = [\"v{k}\", \"v{next}\"]\npolyline = [{:?}, {:?}]\n",
            HEXAGON[k], HEXAGON[next]
        )
    };
    boundary(&format!("loops = [{loops}]"), 6) + &(0..6).map(curve).collect::<String>()
}

#[test]
fn a_polygon_is_the_loop_of_its_sides() {
    let polygon = done(&boundary(&format!("polygon = {HEXAGON:?}"), 6));
    let sides: Vec<[[f64; 3]; 2]> = (0..6).map(|k| [HEXAGON[k], HEXAGON[(k + 1) % 6]]).collect();
    let sides = done(&boundary(&format!("sides = {sides:?}"), 6));
    let curves = done(&of_curves("[\"c0\", \"c1\", \"c2\", \"c3\", \"c4\", \"c5\"]"));
    assert_eq!(points(&polygon), points(&sides));
    assert_eq!(points(&polygon), points(&curves));
}

#[test]
fn an_experiment_finds_what_the_engine_fills() {
    let text = boundary(&format!("polygon = {HEXAGON:?}"), 5) + "tolerance = 1e-9\n";
    let around = Loop::polygon(&HEXAGON.map(Point::from)).unwrap();
    let film = Fill::default().with_degree(5).loops(&[around], &()).unwrap();
    assert_eq!(points(&done(&text)), film.complex().points());
}

#[test]
fn the_sense_of_a_loop_and_where_it_begins_change_nothing() {
    let forward = area(&of_curves("[\"c0\", \"c1\", \"c2\", \"c3\", \"c4\", \"c5\"]"));
    for walked in [
        "[\"-c5\", \"-c4\", \"-c3\", \"-c2\", \"-c1\", \"-c0\"]",
        "[\"c2\", \"c3\", \"c4\", \"c5\", \"c0\", \"c1\"]",
    ] {
        assert!((area(&of_curves(walked)) / forward - 1.0).abs() < 1e-13, "{walked}");
    }
    // Curves that are written down the other way.
    let turned = of_curves("[\"c0\", \"-c1\", \"c2\", \"c3\", \"c4\", \"c5\"]").replace(
        "ends = [\"v1\", \"v2\"]\npolyline = [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0]]",
        "ends = [\"v2\", \"v1\"]\npolyline = [[1.0, 1.0, 0.0], [1.0, 0.0, 0.0]]",
    );
    assert!(turned.contains("[\"v2\", \"v1\"]"));
    assert!((area(&turned) / forward - 1.0).abs() < 1e-13);
}

#[test]
fn the_edges_of_a_cube_have_the_area_that_schwarz_found() {
    // 3K(¾)/(2K(¼)).
    let exact = 1.918_892_356_756_509;
    let text = boundary(&format!("polygon = {HEXAGON:?}"), 8);
    let done = done(&text);
    assert!((done.figures.area.value / exact - 1.0).abs() < 1e-13, "{:?}", done.figures.area);
    let film = done.film.expect("what is known of films");
    assert_eq!((film.rim().largest, film.one_by_one()), (0.0, None));
    assert!(film.seams().kink.is_some_and(|kink| kink.max < 1e-6));
    // What the file expects is compared.
    assert!(finished(&format!("{text}expect.area = 1.9188923568\n")).missed().is_empty());
    assert_eq!(finished(&format!("{text}expect.area = 1.9188923578\n")).missed().len(), 1);
}

/// Two circles of radius 1 at a distance.
fn rings(distance: f64) -> String {
    let ring = |name: &str, z: f64| {
        format!(
            "[[curve]]\nname = \"{name}\"\ncircle = {{ center = [0, 0, {z}], normal = [0, 0, 1], radius = 1 }}\n"
        )
    };
    boundary("loops = [[\"low\"], [\"high\"]]", 8) + &ring("low", 0.0) + &ring("high", distance)
}

#[test]
fn two_rings_span_a_catenoid_or_two_discs() {
    let catenoid = done(&rings(0.6));
    // π c (2h + c sinh(2h/c)) with c cosh(h/c) = 1, the larger c, by iteration.
    let h: f64 = 0.3;
    let mut c: f64 = 1.0;
    (0..200).for_each(|_| c = 1.0 / (h / c).cosh());
    let exact = std::f64::consts::PI * c * (2.0 * h + c * (2.0 * h / c).sinh());
    assert!((catenoid.figures.area.value / exact - 1.0).abs() < 1e-12, "{:?}", catenoid.figures.area);
    let discs = |done: &Done| done.film.as_ref().and_then(|film| film.one_by_one()).expect("two loops");
    assert!((discs(&catenoid) / std::f64::consts::TAU - 1.0).abs() < 1e-8);
    // From 2h = 1.0554 on the discs together have less area, and it is said.
    let says = |done: &Done| done.warnings.iter().any(|warning| warning.to_string().contains("by itself"));
    let apart = done(&rings(1.1));
    assert!(!says(&catenoid) && says(&apart), "{:?}", apart.warnings);
    assert!(discs(&apart) < apart.figures.area.value);
}

#[test]
fn soap_films_meet_inside_a_cube() {
    let corner = |k: usize| [(k & 1) as f64, (k >> 1 & 1) as f64, (k >> 2) as f64];
    let mut text = String::from("title = \"x\"\n");
    for (a, b) in (0..8).flat_map(|a| [1, 2, 4].map(|bit| (a, a | bit))).filter(|(a, b)| a != b) {
        let (from, to) = (corner(a), corner(b));
        text += &format!(
            "[[curve]]\nname = \"{a}{b}\"\nends = [\"v{a}\", \"v{b}\"]\npolyline = [{from:?}, {to:?}]\n"
        );
    }
    let mut face = |vertices: &[String]| text += &format!("[[face]]\nvertices = {vertices:?}\n");
    // A square in the middle, halfway up; its corners hang at the upright edges.
    let around = [0, 1, 3, 2];
    let (low, high, inner) =
        (|k: usize| format!("v{k}"), |k: usize| format!("v{}", k + 4), |k: usize| format!("s{k}"));
    face(&around.map(inner));
    for k in 0..4 {
        let (a, b) = (around[k], around[(k + 1) % 4]);
        face(&[low(a), high(a), inner(a)]);
        face(&[low(a), low(b), inner(b), inner(a)]);
        face(&[high(a), high(b), inner(b), inner(a)]);
    }
    text += "[[method]]\nname = \"a\"\nenergy = \"area\"\ndegree = 4\n";
    for k in 0..4 {
        let [x, y, _] = corner(k).map(|x| 0.5 + 0.1 * (2.0 * x - 1.0));
        text += &format!("[[vertex]]\nname = \"s{k}\"\npoint = [{x}, {y}, 0.5]\n");
    }
    let done = done(&text);
    assert!((done.figures.area.value / 4.239_563_1 - 1.0).abs() < 1e-7, "{:?}", done.figures.area);
    let Surface::Complex(complex) = done.solved.surface() else { panic!("a complex") };
    // Three films at a line, four lines at a point.
    assert!(complex.edges().iter().all(|edge| [1, 2, 3].contains(&edge.uses().len())));
    assert!(complex.edges().iter().any(|edge| edge.uses().len() == 3));
}
