//! Curves in any order become loops and graphs.

use exchange::{Assembly, AssemblyError, AssemblyOptions, Form, Shape, Walk, read_curves};
use proptest::prelude::*;
use surfaces::Point;

fn assembled(name: &str, text: &str, options: &AssemblyOptions) -> Result<Assembly, AssemblyError> {
    let file = read_curves(text.as_bytes(), name).unwrap_or_else(|error| panic!("{error}\n{text}"));
    Assembly::new(&file, options)
}

fn sound(name: &str, text: &str) -> Assembly {
    assembled(name, text, &AssemblyOptions::default()).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn loops(assembly: &Assembly) -> &[Vec<Walk>] {
    let Form::Loops(loops) = &assembly.form else { panic!("{:?}", assembly.form) };
    loops
}

/// Points of polylines one after the other round a loop, the last of each left out.
fn round(assembly: &Assembly, walks: &[Walk]) -> Vec<[f64; 3]> {
    let side = |walk: &Walk| {
        let mut points = assembly.sides[walk.side].shape.sampled();
        if !walk.forward {
            points.reverse();
        }
        points.pop();
        points
    };
    walks.iter().flat_map(side).map(<[f64; 3]>::from).collect()
}

#[test]
fn a_closed_polyline_is_cut_at_its_corners() {
    let text = "0,0,0\n1,0,0\n2,0,0\n2,0.7,0.2\n2,1.3,0.2\n2,2,0\n0,2,0\n";
    let assembly = sound("loop.csv", text);
    let walks = &loops(&assembly)[0];
    assert_eq!((loops(&assembly).len(), walks.len(), assembly.vertices.len()), (1, 4, 4));
    // Straight sides are two points.
    let counts: Vec<usize> =
        walks.iter().map(|walk| assembly.sides[walk.side].shape.sampled().len()).collect();
    assert_eq!(counts, [2, 4, 2, 2]);
    // A sharper limit makes the bends in the second side corners, a wider one leaves the loop smooth.
    for (corner_angle, sides) in [(10.0, 6), (120.0, 1)] {
        let assembly =
            assembled("loop.csv", text, &AssemblyOptions { corner_angle, ..AssemblyOptions::default() })
                .unwrap();
        assert_eq!(loops(&assembly)[0].len(), sides);
    }
}

/// Nobody samples a curve by its middle: the ridge of a gable is a corner, however flat the roof.
#[test]
fn a_point_alone_between_two_corners_is_one() {
    let gable = |height: f64| format!("v 0 0 3\nv 4 0 {height}\nv 8 0 3\nv 8 6 3\nv 0 6 3\nl 1 2 3 4 5 1\n");
    let sides = |height: f64| sound("gable.obj", &gable(height)).sides.len();
    // Turns of 41°, 13° and 6°.
    assert_eq!([4.5, 3.46, 3.2].map(sides), [5, 5, 4]);
    // A polyline of its own, with a name, is a side, whatever it passes.
    let side = "v 0 0 3\nv 4 0 4.5\nv 8 0 3\nv 8 6 3\nv 0 6 3\ng arc\nl 1 2 3\ng rest\nl 3 4 5 1\n";
    assert_eq!(sound("side.obj", side).sides.len(), 4);
    // Two points between corners are samples.
    let arch = "v 0 0 0\nv 3 0 1\nv 6 0 1\nv 9 0 0\nv 9 6 0\nv 0 6 0\nl 1 2 3 4 5 6 1\n";
    assert_eq!(sound("arch.obj", arch).sides.len(), 4);
}

#[test]
fn smooth_rings_have_no_vertices() {
    let ring = |z: f64, text: &mut String, first: usize| {
        for k in 0..24 {
            let t = f64::from(k) * std::f64::consts::TAU / 24.0;
            text.push_str(&format!("v {:?} {:?} {z}\n", t.cos(), t.sin()));
        }
        for k in 0..24 {
            text.push_str(&format!("l {} {}\n", first + k, first + (k + 1) % 24));
        }
    };
    let mut text = String::new();
    ring(0.0, &mut text, 1);
    ring(1.0, &mut text, 25);
    let assembly = sound("rings.obj", &text);
    assert!(assembly.vertices.is_empty() && loops(&assembly).len() == 2);
    for side in &assembly.sides {
        let points = side.shape.sampled();
        assert_eq!((side.ends, points.len(), points[0]), (None, 25, points[24]));
    }
    ring(2.0, &mut text, 49);
    let error = assembled("rings.obj", &text, &AssemblyOptions::default()).unwrap_err();
    assert!(error.to_string().contains("3 loops"), "{error}");
}

#[test]
fn sides_of_a_table_stay_sides_where_they_join_smoothly() {
    let assembly = sound("s.csv", "a,0,0,0\na,1,0,0\nb,1,0,0\nb,2,0,0\nc,2,0,0\nc,2,2,0\nc,0,0,0\n");
    let names: Vec<&str> =
        loops(&assembly)[0].iter().map(|walk| assembly.sides[walk.side].name.as_str()).collect();
    assert_eq!(names, ["a", "b", "c-1", "c-2"]);
}

#[test]
fn gaps_are_welded_or_named() {
    let text = |gap: f64| format!("a,0,0,0\na,1,0,0\nb,{},0,0\nb,1,1,0\nc,1,1,0\nc,0,0,0\n", 1.0 + gap);
    let assembly = sound("g.csv", &text(1e-5));
    assert_eq!((assembly.weld.count, assembly.vertices.len()), (1, 3));
    assert!(
        (assembly.weld.largest - 1e-5).abs() < 1e-9
            && assembly.notes[0].to_string().contains("1 end of curves welded")
    );
    let error = assembled("g.csv", &text(0.02), &AssemblyOptions::default()).unwrap_err().to_string();
    for word in ["a ends at (1, 0, 0)", "b begins at (1.02, 0, 0)", "a gap of 0.02. Ends", "weld 0.021"] {
        assert!(error.contains(word), "{error}\ninstead of {word}");
    }
    let wide = AssemblyOptions { weld: Some(0.021), ..AssemblyOptions::default() };
    let assembly = assembled("g.csv", &text(0.02), &wide).unwrap();
    assert_eq!(assembly.vertices.len(), 3);
    // Ends agree digit for digit.
    for side in &assembly.sides {
        assert_eq!(side.shape.ends(), side.ends.unwrap().map(|vertex| assembly.vertices[vertex]));
    }
    for weld in [-1.0, f64::NAN, 5.0] {
        assert!(
            assembled("g.csv", &text(0.0), &AssemblyOptions { weld: Some(weld), ..wide.clone() }).is_err()
        );
    }
}

/// A gap as long as a side is one: the last edge of a polygon, or a side that is missing.
#[test]
fn short_sides_are_no_gaps() {
    for length in [10.0, 11_000.0, 1e6, 1e9] {
        for start in 0..4 {
            let corners = [[0.0, 0.0], [length, 0.0], [length, 1.0], [0.0, 1.0]];
            let row = |k: usize| format!("{:?},{:?},0\n", corners[k % 4][0], corners[k % 4][1]);
            let assembly = sound("strip.csv", &(start..start + 4).map(row).collect::<String>());
            assert_eq!((loops(&assembly)[0].len(), assembly.weld.count), (4, 0), "{length} from {start}");
            // The first point again, within rounding, is welded all the same.
            let again = row(start).replacen(",0\n", ",1e-12\n", 1);
            let text = (start..start + 4).map(row).collect::<String>() + &again;
            let assembly = sound("again.csv", &text);
            assert_eq!((loops(&assembly)[0].len(), assembly.weld.count), (4, 1), "{length} from {start}");
        }
    }
    // Near the long side, but no junction with it.
    let assembly = sound("skew.csv", "0,0,0\n11000,0,0\n11000,1,0\n5,1,0\n");
    assert_eq!((loops(&assembly).len(), assembly.sides.len()), (1, 4));
    // Of separate sides one is missing, which is as short as its opposite one.
    let sides = "a,0,0,0\na,11000,0,0\nb,11000,0,0\nb,11000,1,0\nc,11000,1,0\nc,0,1,0\n";
    let error = assembled("three.csv", sides, &AssemblyOptions::default()).unwrap_err().to_string();
    for word in ["a gap of 1.", "a quarter of the shortest edge", "a side may be missing", "weld 1"] {
        assert!(error.contains(word), "{error}\ninstead of {word}");
    }
    // What was asked for is done.
    let asked = AssemblyOptions { weld: Some(1.0), ..AssemblyOptions::default() };
    assert_eq!(assembled("three.csv", sides, &asked).unwrap().sides.len(), 3);
    // Samples that stand twice within rounding are no short edges.
    let twice = "0,0,0\n1,0,0\n1,1e-17,0\n1,1,1\n1,1.0000000000000002,1\n0,1,0\n1e-5,0,0\n";
    let assembly = sound("twice.csv", twice);
    assert_eq!(assembly.weld.count, 1);
}

/// The unit skew square, each corner times a scale, from an offset on.
fn skew(scale: f64, offset: f64) -> String {
    let corner =
        |[x, y, z]: [f64; 3]| format!("{:?},{:?},{:?}\n", x * scale + offset, y * scale + offset, z * scale);
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 1.0], [0.0, 1.0, 0.0]];
    corners.into_iter().map(corner).collect()
}

/// How far the origin is, is no matter of shape, until rounding has moved the points themselves.
#[test]
fn far_curves_are_what_they_are_near() {
    for power in [0, 20, 40, 44, 46] {
        let assembly = sound("far.csv", &skew(1.0, 2f64.powi(power)));
        assert_eq!((loops(&assembly)[0].len(), assembly.weld.count), (4, 0), "2^{power}");
    }
    // A side of three samples, bent by a hundredth, at a distance at which a millionth of a millionth is more than that.
    let bent = |x: f64| {
        format!(
            "a,{x:?},0,0\na,{:?},0.015625,0\na,{:?},0,0\nb,{:?},0,0\nb,{x:?},1,0\nb,{x:?},0,0\n",
            x + 0.5,
            x + 1.0,
            x + 1.0
        )
    };
    for x in [0.0, 2f64.powi(36)] {
        let assembly = sound("bent.csv", &bent(x));
        assert_eq!(assembly.sides[0].shape.sampled().len(), 3, "{x}");
    }
    for offset in [1e17, 1e20] {
        let error = assembled("far.csv", &skew(1.0, offset), &AssemblyOptions::default()).unwrap_err();
        assert!(matches!(error, AssemblyError::Far { .. }), "{error}");
        assert!(error.to_string().contains("from the origin"), "{error}");
    }
}

#[test]
fn points_that_are_too_near_or_the_same_are_told_apart() {
    let error = |text: &str| assembled("near.csv", text, &AssemblyOptions::default()).unwrap_err();
    for scale in [1e-320, 1e-200, 1e-80] {
        let error = error(&skew(scale, 0.0));
        assert!(matches!(error, AssemblyError::TooNear { extent } if extent == scale), "{error}");
        assert!(error.to_string().contains("too near"), "{error}");
    }
    assert_eq!(error("1,2,3\n1,2,3\n1,2,3\n"), AssemblyError::NoSize);
}

/// A loop that comes back to a point of its own is two that share it, wherever it begins.
#[test]
fn loops_that_touch_themselves_are_told() {
    let points = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [2.0, 2.0], [0.0, 2.0], [1.0, 1.0]];
    for turned in [false, true] {
        for start in 0..6 {
            let row = |k: usize| {
                let [x, y] = points[if turned { 11 - start - k } else { start + k } % 6];
                format!("{x:?},{y:?},0\n")
            };
            let assembly = sound("touch.csv", &(0..6).map(row).collect::<String>());
            let Form::Faces(faces) = &assembly.form else { panic!("{start}: {:?}", assembly.form) };
            assert!(faces.len() == 2 && faces.iter().all(|face| face.len() == 3), "{start}: {faces:?}");
            let note = "the curve of line 1 touches itself at (1, 1, 0)";
            assert!(
                assembly.notes.iter().any(|said| said.to_string().starts_with(note)),
                "{:?}",
                assembly.notes
            );
        }
    }
    // Twice round an axis, once through the same point.
    let round = |k: i32| {
        let (s, c) = (f64::from(k % 40) * std::f64::consts::PI / 20.0).sin_cos();
        format!("{c:?},{s:?},{:?}\n", if k % 40 == 0 { 0.0 } else { 0.1 * f64::from(k / 40) + 0.1 })
    };
    for start in [0, 7, 40] {
        let assembly = sound("twice.csv", &(start..start + 80).map(|k| round(k % 80)).collect::<String>());
        assert!(matches!(&assembly.form, Form::Faces(faces) if faces.len() == 2), "{start}");
        assert!(assembly.notes.iter().any(|note| note.to_string().contains("touches itself at (1, 0, 0)")));
    }
    // Where it is open which cycles are meant, that is why.
    let star = "0,0,0\n1,0,0\n2,0,0\n2,2,0\n1,0,0\n1,2,0\n2,2,0\n0,2,0\n1,2,0\n";
    match assembled("star.csv", star, &AssemblyOptions::default()) {
        Ok(assembly) => assert!(matches!(assembly.form, Form::Faces(_)), "{assembly:?}"),
        Err(error) => assert!(error.to_string().contains("touches itself at"), "{error}"),
    }
    // What another curve joins is no loop of its own.
    let error = assembled("net.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3 2\n", &AssemblyOptions::default());
    assert!(matches!(error, Err(AssemblyError::Gap(_))), "{error:?}");
}

#[test]
fn splines_and_arcs_end_in_their_vertices() {
    // A half circle and a line whose ends are rounded to five digits.
    let dxf = "0\nSECTION\n2\nENTITIES\n0\nARC\n10\n0\n20\n0\n40\n1\n50\n10\n51\n190\n0\nLINE\n10\n0.98481\n20\n0.17365\n11\n-0.98481\n21\n-0.17365\n0\nENDSEC\n0\nEOF\n";
    let assembly = sound("half.dxf", dxf);
    assert_eq!((loops(&assembly)[0].len(), assembly.weld.count), (2, 2));
    let Shape::Spline(spline) = &assembly.sides[0].shape else { panic!("{:?}", assembly.sides[0]) };
    assert_eq!(spline.points()[0], assembly.vertices[0]);
    for k in 0..=8 {
        assert!((spline.jet(f64::from(k) / 8.0).point.norm() - 1.0).abs() < 1e-5);
    }
}

#[test]
fn equal_samples_are_all_named() {
    let assembly = sound("d.csv", "0,0,0\n0,0,0\n1,0,0\n1,0,0\n1,1,0\n1,1,0\n");
    assert!(
        assembly.notes[0].to_string().starts_with("3 samples are equal")
            && assembly.notes[0].to_string().contains(": 1, 3, 5"),
        "{:?}",
        assembly.notes
    );
    assert_eq!(loops(&assembly)[0].len(), 3);
}

#[test]
fn a_graph_has_its_smallest_cycles_as_faces() {
    // A tent: a square and four ridges to a mast; one ridge ends on the middle of a segment of a fifth rope.
    let tent = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 1 1\nl 1 2 3\nl 1 4 3\nl 5 1\nl 5 2\nl 3 5 4\n";
    let assembly = sound("tent.obj", tent);
    let Form::Faces(faces) = &assembly.form else { panic!("{:?}", assembly.form) };
    assert!(faces.len() == 4 && faces.iter().all(|face| face.len() == 3), "{faces:?}");
    // A bar across a rectangle whose ends lie on straight sides.
    let bar = "v 0 0 0\nv 4 0 0\nv 4 2 0\nv 0 2 0\nv 1 0 0\nv 1 2 0\nl 1 2 3 4 1\nl 5 6\n";
    let assembly = sound("bar.obj", bar);
    let Form::Faces(faces) = &assembly.form else { panic!("{:?}", assembly.form) };
    assert_eq!((faces.len(), assembly.vertices.len()), (2, 6));
    // A cube: which five of its six faces?
    let cube = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nl 1 2 3 4 1\nl 5 6 7 8 5\nl 1 5\nl 2 6\nl 3 7\nl 4 8\n";
    let error = assembled("cube.obj", cube, &AssemblyOptions::default()).unwrap_err();
    assert!(matches!(&error, AssemblyError::Ambiguous(text) if text.contains("[[face]]")), "{error}");
    let bridge = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nl 1 2 3 1\nl 4 5 6 4\nl 2 4\n";
    let error = assembled("bridge.obj", bridge, &AssemblyOptions::default()).unwrap_err().to_string();
    assert!(error.contains("bounds no face"), "{error}");
}

#[test]
fn curves_that_stand_twice_count_once() {
    let assembly = sound("twice.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\nl 2 3\nl 3 1\nl 2 1\n");
    assert!(
        loops(&assembly)[0].len() == 3
            && assembly.notes.iter().any(|note| note.to_string().contains("twice"))
    );
}

/// A closed zigzag in space of at least four vertices, corner at each.
fn zigzag() -> impl Strategy<Value = Vec<[f64; 3]>> {
    prop::collection::vec((0.5..1.0_f64, -1.0..1.0_f64), 4..12).prop_map(|radii| {
        let count = radii.len() as f64;
        radii
            .iter()
            .enumerate()
            .map(|(k, (r, z))| {
                let t = k as f64 * std::f64::consts::TAU / count;
                [r * t.cos(), r * t.sin(), *z]
            })
            .collect()
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn shuffled_and_reversed_segments_are_the_same_loop(rim in zigzag(), order in prop::collection::vec(any::<u32>(), 12), turned in prop::collection::vec(any::<bool>(), 12)) {
        let count = rim.len();
        let mut places: Vec<usize> = (0..count).collect();
        places.sort_by_key(|k| order[*k]);
        let mut text: String = rim.iter().map(|[x, y, z]| format!("v {x:?} {y:?} {z:?}\n")).collect();
        for k in places {
            let (a, b) = (k + 1, (k + 1) % count + 1);
            text += &if turned[k] { format!("l {b} {a}\n") } else { format!("l {a} {b}\n") };
        }
        let assembly = sound("shuffled.obj", &text);
        prop_assert_eq!(loops(&assembly).len(), 1);
        let mut found = round(&assembly, &loops(&assembly)[0]);
        prop_assert!(found.len() <= count);
        // Begun at the same point and run the same way, it is the rim but for points inside straight or nearly straight sides.
        let start = found.iter().position(|p| *p == rim[0]).unwrap_or(0);
        found.rotate_left(start);
        let places: Vec<usize> = found.iter().map(|p| rim.iter().position(|q| q == p).unwrap()).collect();
        let ascends = places.windows(2).filter(|pair| pair[0] < pair[1]).count();
        prop_assert!(ascends + 2 >= places.len() || ascends <= 1, "{:?}", places);
        // Every end of a side is a vertex, and each loop closes.
        let walks = &loops(&assembly)[0];
        for k in 0..walks.len() {
            let (one, next) = (walks[k], walks[(k + 1) % walks.len()]);
            if let (Some(ends), Some(begins)) = (assembly.sides[one.side].ends, assembly.sides[next.side].ends) {
                prop_assert_eq!(ends[usize::from(one.forward)], begins[usize::from(!next.forward)]);
            }
        }
    }

    #[test]
    fn where_the_file_begins_does_not_matter(rim in zigzag(), shift in 0..12_usize, moved in -1e-6..1e-6_f64) {
        // Pieces with ends of their own, one moved by less than is welded.
        let count = rim.len();
        let mut text = String::new();
        for k in 0..count {
            let k = (k + shift) % count;
            let (a, b) = (rim[k], rim[(k + 1) % count]);
            text += &format!("s{k},{:?},{:?},{:?}\ns{k},{:?},{:?},{:?}\n", a[0] + if k == 0 { moved } else { 0.0 }, a[1], a[2], b[0], b[1], b[2]);
        }
        let assembly = sound("moved.csv", &text);
        prop_assert_eq!((loops(&assembly).len(), assembly.sides.len(), assembly.vertices.len()), (1, count, count));
        let far = assembly.vertices.iter().map(|v| rim.iter().map(|p| v.distance(Point::from(*p))).fold(f64::INFINITY, f64::min)).fold(0.0, f64::max);
        prop_assert!(far <= 1e-6);
    }
}
