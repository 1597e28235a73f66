//! Laws of every method: what is done to a boundary without changing its shape changes no figure but by the unit of length; raising
//! the degree never enlarges what is minimised; no surface has less area than the least.

#![allow(clippy::print_stdout)] // the figures are worth reading

mod subjects;

use plateau::{Done, Energy};
use subjects::{
    FILM_METHODS, Map, ROWS_METHODS, TENSOR, TENSOR_AREAS, TENSOR_METHODS, TRIANGLE, TRIANGLE_METHODS,
    figures, polygon, results, rings, sides, stay, wings,
};

/// A boundary and what fills it.
struct Subject {
    name: &'static str,
    boundary: fn(Map<'_>) -> String,
    methods: Vec<&'static str>,
    /// A point that is given once, whose last digit may be touched.
    inner: [f64; 3],
    /// The boundary under other names of its sides.
    renamed: Vec<Renamed>,
}

/// What was done to the names, the boundary under the others, and what becomes of a method.
type Renamed = (&'static str, String, fn(&str) -> String);

const TURNED: [[f64; 3]; 3] = [[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]];

fn turned(p: [f64; 3]) -> [f64; 3] {
    TURNED.map(|row| row[0] * p[0] + row[1] * p[1] + row[2] * p[2])
}

fn mirrored([x, y, z]: [f64; 3]) -> [f64; 3] {
    [x, -y, z]
}

fn tripled(p: [f64; 3]) -> [f64; 3] {
    p.map(|x| 3.0 * x)
}

fn back(points: &[[f64; 3]]) -> Vec<[f64; 3]> {
    points.iter().rev().copied().collect()
}

fn named(all: &[(&str, Vec<[f64; 3]>)]) -> String {
    all.iter().map(|(name, points)| format!("{name} = {points:?}\n")).collect()
}

fn same(method: &str) -> String {
    method.to_owned()
}

/// All there is: whoever adds a method adds it to one of these lists.
fn subjects() -> Vec<Subject> {
    let [u0, u1, v0, v1] = TENSOR.map(|(_, points)| points);
    let [ab, bc, ca] = TRIANGLE.map(|(_, points)| points);
    let tensor = vec![
        (
            "reversed in u",
            named(&[("u0", u1.to_vec()), ("u1", u0.to_vec()), ("v0", back(v0)), ("v1", back(v1))]),
            (|method| method.replace("[1, 2, 0.5, 3]", "[2, 1, 0.5, 3]")) as fn(&str) -> String,
        ),
        (
            "reversed in v",
            named(&[("u0", back(u0)), ("u1", back(u1)), ("v0", v1.to_vec()), ("v1", v0.to_vec())]),
            |method| method.replace("[1, 2, 0.5, 3]", "[1, 2, 3, 0.5]"),
        ),
        (
            "exchanged",
            named(&[("u0", v0.to_vec()), ("u1", v1.to_vec()), ("v0", u0.to_vec()), ("v1", u1.to_vec())]),
            |method| method.replace("[1, 2, 0.5, 3]", "[0.5, 3, 1, 2]"),
        ),
    ];
    let rows = vec![
        (
            "reversed in u",
            named(&[("u0", u1.to_vec()), ("u1", u0.to_vec())]) + "u-degree = 3\n",
            same as fn(&str) -> String,
        ),
        ("reversed in v", named(&[("u0", back(u0)), ("u1", back(u1))]) + "u-degree = 3\n", same),
        ("exchanged", named(&[("v0", u0.to_vec()), ("v1", u1.to_vec())]) + "v-degree = 3\n", same),
    ];
    // The right angle of the domain stays at the same corner.
    let triangle = vec![(
        "exchanged",
        named(&[("ab", back(ab)), ("bc", back(ca)), ("ca", back(bc))]),
        same as fn(&str) -> String,
    )];
    // Corners of the domain that are all alike may be listed from any.
    let cyclic = named(&[("ab", bc.to_vec()), ("bc", ca.to_vec()), ("ca", ab.to_vec())]);
    let symmetric: Vec<&str> = TRIANGLE_METHODS
        .iter()
        .copied()
        .filter(|m| m.contains("equilateral") || m.contains("area"))
        .collect();
    let [p, q, r, s, t] = subjects::LOOP;
    let around = vec![
        ("begun elsewhere", format!("polygon = {:?}\n", [r, s, t, p, q]), same as fn(&str) -> String),
        ("reversed", format!("polygon = {:?}\n", [t, s, r, q, p]), same),
    ];
    let inner = [2.0, 0.0, 3.0];
    vec![
        Subject {
            name: "tensor",
            boundary: |map| sides(&TENSOR, map),
            methods: [TENSOR_METHODS, TENSOR_AREAS].concat(),
            inner,
            renamed: tensor,
        },
        Subject {
            name: "two rows",
            boundary: |map| sides(&TENSOR[..2], map),
            methods: ROWS_METHODS.to_vec(),
            inner,
            renamed: rows,
        },
        Subject {
            name: "triangle",
            boundary: |map| sides(&TRIANGLE, map),
            methods: TRIANGLE_METHODS.to_vec(),
            inner: [2.0, -1.0, 3.0],
            renamed: triangle,
        },
        Subject {
            name: "symmetric triangle",
            boundary: |map| sides(&TRIANGLE, map),
            methods: symmetric,
            inner: [2.0, -1.0, 3.0],
            renamed: vec![("begun elsewhere", cyclic, same)],
        },
        Subject {
            name: "loop",
            boundary: polygon,
            methods: FILM_METHODS.to_vec(),
            inner: [4.0, 0.0, 1.0],
            renamed: around,
        },
        Subject {
            name: "two loops",
            boundary: rings,
            methods: FILM_METHODS[..2].to_vec(),
            inner: [0.0, 0.0, 0.5],
            renamed: Vec::new(),
        },
        Subject {
            name: "faces",
            boundary: wings,
            methods: FILM_METHODS[..2].to_vec(),
            inner: [4.5, 1.5, 0.75],
            renamed: Vec::new(),
        },
    ]
}

/// The figures that rounding of the boundary leaves as they are, and how far. Points of a least area slide within the surface; a search
/// ends at the least energy, and the place where it is least is certain to the root of that.
fn figures_held(method: &str, done: &Done) -> Vec<(&'static str, i32, f64)> {
    let all = figures(done);
    let of = |names: &[&str]| all.iter().copied().filter(|(name, ..)| names.contains(name)).collect();
    if method.contains("search") {
        of(&["minimum"])
    } else if method.contains("\"area\"") {
        of(&["A"])
    } else if method.contains("equilateral") {
        // Energies are given over the right-angled domain, which begins at a corner.
        of(&["A", "largest |H|", "rms of H"])
    } else {
        all
    }
}

/// The largest relative change of the figures held when a boundary becomes another `unit` times as large.
fn changes(subject: &Subject, law: &str, changed: &str, methods: &[String], unit: f64, tolerance: f64) {
    let names: Vec<&str> = methods.iter().map(String::as_str).collect();
    let (before, after) = (results(&(subject.boundary)(&stay), &subject.methods), results(changed, &names));
    for ((before, after), method) in
        before.results.methods().iter().zip(after.results.methods()).zip(&subject.methods)
    {
        let done = |result: &plateau::MethodResult| -> Vec<(&'static str, i32, f64)> {
            let done = result
                .outcome
                .as_ref()
                .unwrap_or_else(|error| panic!("{}, {law}: {method}: {error}", subject.name));
            figures_held(method, done)
        };
        let mut worst = (0.0f64, "");
        for ((name, power, a), (_, _, b)) in done(before).into_iter().zip(done(after)) {
            let b = b / unit.powi(power);
            let change = (a - b).abs() / a.abs().max(1e-3);
            worst = if change > worst.0 { (change, name) } else { worst };
            assert!(
                change <= tolerance || a.is_nan() && b.is_nan(),
                "{}, {law}: {method}: {name} {a} becomes {b}",
                subject.name
            );
        }
        println!("{}, {law}: {}: {:.0e} {}", subject.name, method.replace('\n', ", "), worst.0, worst.1);
    }
}

fn plain(subject: &Subject) -> Vec<String> {
    subject.methods.iter().map(|method| (*method).to_owned()).collect()
}

#[test]
fn figures_do_not_change_when_the_boundary_is_turned_or_mirrored() {
    for subject in subjects() {
        for (law, map) in [("turned", turned as fn([f64; 3]) -> [f64; 3]), ("mirrored", mirrored)] {
            changes(&subject, law, &(subject.boundary)(&map), &plain(&subject), 1.0, 1e-10);
        }
    }
}

#[test]
fn figures_change_by_the_unit_of_length_alone_when_it_is_scaled() {
    for subject in subjects() {
        changes(&subject, "scaled", &(subject.boundary)(&tripled), &plain(&subject), 3.0, 1e-10);
    }
}

#[test]
fn figures_do_not_change_with_the_last_digit_of_a_coordinate() {
    for subject in subjects() {
        let touched = |p: [f64; 3]| if p == subject.inner { [p[0], p[1], p[2].next_up()] } else { p };
        let changed = (subject.boundary)(&touched);
        assert_ne!(changed, (subject.boundary)(&stay), "{}: nothing was touched", subject.name);
        changes(&subject, "touched", &changed, &plain(&subject), 1.0, 1e-10);
    }
}

#[test]
fn figures_do_not_change_with_the_names_of_the_sides() {
    for subject in subjects() {
        for (law, changed, renamed) in &subject.renamed {
            let methods: Vec<String> = subject.methods.iter().map(|method| renamed(method)).collect();
            changes(&subject, law, changed, &methods, 1.0, 1e-10);
        }
    }
}

/// What a method minimised.
fn minimised(done: &Done) -> Option<f64> {
    match done.solved.minimised()? {
        Energy::Area => Some(done.figures.area.value),
        Energy::Quadratic(functional) => Some(done.figures.quadratic(functional)?.value),
    }
}

#[test]
fn raising_the_degree_never_enlarges_what_is_minimised() {
    let energies = ["dirichlet", "laplacian", "bending", "coons", "area"];
    let [tensor, triangle] = [sides(&TENSOR, &stay), sides(&TRIANGLE, &stay)];
    let mut ladders: Vec<(&str, String, usize)> = Vec::new();
    for energy in energies {
        for boundary in [&tensor, &triangle] {
            ladders.push((boundary, format!("energy = \"{energy}\"\nraise = "), 0));
        }
    }
    let films = [polygon(&stay), wings(&stay)];
    for boundary in &films {
        for energy in ["dirichlet", "area"] {
            ladders.push((boundary, format!("energy = \"{energy}\"\ndegree = "), 4));
        }
    }
    for (boundary, method, lowest) in &ladders {
        let steps: Vec<String> = (*lowest..lowest + 5).map(|k| format!("{method}{k}")).collect();
        let finished = results(boundary, &steps.iter().map(String::as_str).collect::<Vec<_>>());
        let values: Vec<f64> = finished
            .results
            .methods()
            .iter()
            .map(|result| minimised(result.outcome.as_ref().unwrap()).unwrap())
            .collect();
        println!("{}: {values:?}", method.replace('\n', ", "));
        assert!(values.windows(2).all(|pair| pair[1] <= pair[0] * (1.0 + 1e-9)), "{method}: {values:?}");
        assert!(values[4] < values[0] * (1.0 + 1e-12), "{method}: {values:?}");
    }
}

#[test]
fn no_surface_over_the_same_boundary_has_less_area_than_the_least() {
    for subject in subjects() {
        let mut methods = subject.methods.clone();
        let in_faces = subject.name.contains("loop") || subject.name == "faces";
        let least = if in_faces { "energy = \"area\"\ndegree = 8" } else { "energy = \"area\"\nraise = 6" };
        if subject.name == "two rows" {
            continue;
        }
        methods.push(least);
        let finished = results(&(subject.boundary)(&stay), &methods);
        let done = |k: usize| finished.results.methods()[k].outcome.as_ref().unwrap();
        let least = done(methods.len() - 1).figures.area.value;
        let mut compared = 0;
        for k in 0..subject.methods.len() {
            // Other functions have other boundary curves.
            let moved = done(k).boundary.as_ref().is_some_and(|boundary| boundary.deviation > 1e-12);
            let area = done(k).figures.area.value;
            compared += usize::from(!moved);
            assert!(
                moved || least <= area * (1.0 + 1e-9),
                "{}: {}: {area} below {least}",
                subject.name,
                methods[k]
            );
        }
        println!("{}: {compared} surfaces, none below {least}", subject.name);
        assert!(compared >= 2, "{}", subject.name);
    }
}
