//! STEP and DXF files.

use exchange::{CurveFile, Kind, Shape, read_curves};
use proptest::prelude::*;
use surfaces::Point;

fn read(name: &str, text: &str) -> CurveFile {
    read_curves(text.as_bytes(), name).unwrap_or_else(|error| panic!("{name}: {error}\n{text}"))
}

fn step(data: &str) -> String {
    format!(
        "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('AP242'));\nENDSEC;\nDATA;\n{data}\nENDSEC;\nEND-ISO-10303-21;\n"
    )
}

/// Points and directions for the files below.
const BASE: &str = "#1=CARTESIAN_POINT('',(0.,0.,0.));\n#2=CARTESIAN_POINT('',(2.,0.,0.));\n#3=CARTESIAN_POINT('',(0.,2.,0.));\n\
                    #4=DIRECTION('',(0.,0.,1.));\n#5=DIRECTION('',(1.,0.,0.));\n#6=AXIS2_PLACEMENT_3D('',#1,#4,#5);\n\
                    #7=CIRCLE('',#6,2.);\n#8=VERTEX_POINT('',#2);\n#9=VERTEX_POINT('',#3);\n";

fn ends(file: &CurveFile) -> Vec<[[f64; 3]; 2]> {
    let round = |p: Point| [p.x, p.y, p.z].map(|x| (x * 1e9).round() / 1e9 + 0.0);
    file.curves.iter().map(|curve| curve.shape.ends().map(round)).collect()
}

fn radius(shape: &Shape) -> f64 {
    shape.sampled().iter().map(|p| p.norm()).fold(0.0, f64::max)
}

#[test]
fn edges_are_parts_of_their_curves() {
    let data = format!(
        "{BASE}#10=EDGE_CURVE('a',#8,#9,#7,.T.);\n#11=EDGE_CURVE('b',#8,#9,#7,.F.);\n#12=VECTOR('',#5,1.);\n#13=LINE('',#1,#12);\n\
         #14=VERTEX_POINT('',#1);\n#15=EDGE_CURVE('c',#14,#8,#13,.T.);\n#16=EDGE_CURVE('d',#8,#8,#7,.T.);\n"
    );
    let file = read("edges.step", &step(&data));
    assert_eq!(file.kind, Kind::Step);
    let quarter = [[2., 0., 0.], [0., 2., 0.]];
    assert_eq!(ends(&file), [quarter, quarter, [[0.; 3], [2., 0., 0.]], [[2., 0., 0.]; 2]]);
    let length = |k: usize| -> f64 {
        file.curves[k].shape.sampled().windows(2).map(|pair| pair[0].distance(pair[1])).sum()
    };
    let pi = std::f64::consts::PI;
    for (k, right) in [pi, 3.0 * pi, 2.0, 4.0 * pi].into_iter().enumerate() {
        assert!((length(k) / right - 1.0).abs() < 0.01, "{k}: {}", length(k));
    }
    assert_eq!(file.curves.iter().map(|curve| curve.name.as_str()).collect::<Vec<_>>(), ["a", "b", "c", "d"]);
}

#[test]
fn trims_by_points_and_by_parameters() {
    let degrees = "#30=(CONVERSION_BASED_UNIT('DEGREE',#31)NAMED_UNIT(*)PLANE_ANGLE_UNIT());\n#31=PLANE_ANGLE_MEASURE_WITH_UNIT(PLANE_ANGLE_MEASURE(0.017453292519943295),#32);\n\
                   #32=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));\n#33=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n\
                   #34=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#33,#30))REPRESENTATION_CONTEXT('',''));\n";
    let quarter = [[2., 0., 0.], [0., 2., 0.]];
    for (trim, units, right) in [
        ("(#2,PARAMETER_VALUE(0.)),(#3,PARAMETER_VALUE(1.5707963267948966)),.T.,.PARAMETER.", "", quarter),
        ("(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(90.)),.T.,.PARAMETER.", degrees, quarter),
        ("(#2),(#3),.T.,.CARTESIAN.", "", quarter),
        ("(#3),(#2),.F.,.CARTESIAN.", "", [quarter[1], quarter[0]]),
    ] {
        let data = format!(
            "{BASE}#10=TRIMMED_CURVE('arc',#7,{trim});\n#11=GEOMETRIC_CURVE_SET('set',(#10,#1));\n{units}"
        );
        let file = read("arc.stp", &step(&data));
        assert_eq!(ends(&file), [right], "{trim}");
        let middle = file.curves[0].shape.sampled()[16];
        assert!(middle.x > 1.4 && middle.y > 1.4 && (radius(&file.curves[0].shape) - 2.0).abs() < 1e-12);
        assert_eq!(file.notes.iter().any(|note| note.to_string().contains("millimetres")), !units.is_empty());
    }
}

#[test]
fn splines_composites_polylines_and_ellipses() {
    let rational = "#20=(BOUNDED_CURVE()B_SPLINE_CURVE(2,(#2,#21,#3),.UNSPECIFIED.,.F.,.F.)B_SPLINE_CURVE_WITH_KNOTS((3,3),(0.,1.),.UNSPECIFIED.)\n\
                    CURVE()GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE((1.,0.70710678118654752,1.))REPRESENTATION_ITEM('arc'));\n\
                    #21=CARTESIAN_POINT('',(2.,2.,0.));\n";
    let file = read("r.step", &step(&format!("{BASE}{rational}")));
    // The circle is bounded, too, and nothing refers to it.
    assert_eq!(file.curves.len(), 2);
    let spline = file.curves.iter().find(|curve| matches!(curve.shape, Shape::Spline(_))).unwrap();
    assert!(spline.name == "arc" && spline.shape.sampled().iter().all(|p| (p.norm() - 2.0).abs() < 1e-14));
    let composite = "#20=POLYLINE('',(#1,#2));\n#21=POLYLINE('',(#3,#2));\n#22=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#20);\n\
                     #23=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.F.,#21);\n#24=COMPOSITE_CURVE('rim',(#22,#23),.F.);\n#25=GEOMETRIC_SET('',(#24));\n\
                     #26=ELLIPSE('',#6,2.,1.);\n";
    let file = read("c.step", &step(&format!("{BASE}{composite}")));
    assert_eq!(ends(&file), [[[0.; 3], [2., 0., 0.]], [[2., 0., 0.], [0., 2., 0.]]]);
    let bezier = "#20=BEZIER_CURVE('',3,(#1,#2,#3,#1,#2,#3,#1),.UNSPECIFIED.,.F.,.F.);\n#21=QUASI_UNIFORM_CURVE('',2,(#1,#2,#3,#2),.UNSPECIFIED.,.F.,.F.);\n\
                  #22=UNIFORM_CURVE('',1,(#1,#2),.UNSPECIFIED.,.F.,.F.);\n#23=GEOMETRIC_CURVE_SET('',(#20,#21,#22));\n";
    let file = read("b.step", &step(&format!("{BASE}{bezier}")));
    let pieces = |k: usize| match &file.curves[k].shape {
        Shape::Spline(spline) => spline.bezier_pieces().unwrap().len(),
        other => panic!("{other:?}"),
    };
    assert_eq!(([0, 1, 2].map(pieces), ends(&file)[2]), ([2, 2, 1], [[0.; 3], [2., 0., 0.]]));
}

#[test]
fn of_a_shell_the_free_edges_are_read() {
    // Two triangles that share the edge 1–2.
    let mut data = String::from(BASE);
    data += "#50=CARTESIAN_POINT('',(2.,2.,0.));\n#51=VERTEX_POINT('',#50);\n#52=VERTEX_POINT('',#1);\n#53=VECTOR('',#5,1.);\n#54=LINE('',#1,#53);\n";
    for (id, a, b) in [(60, 8, 9), (61, 9, 52), (62, 52, 8), (63, 9, 51), (64, 51, 8)] {
        data += &format!("#{id}=EDGE_CURVE('',#{a},#{b},#54,.T.);\n");
    }
    for (id, edge) in [(70, 60), (71, 61), (72, 62), (73, 60), (74, 63), (75, 64)] {
        data += &format!("#{id}=ORIENTED_EDGE('',*,*,#{edge},.T.);\n");
    }
    data += "#80=EDGE_LOOP('',(#70,#71,#72));\n#81=EDGE_LOOP('',(#73,#74,#75));\n#82=FACE_OUTER_BOUND('',#80,.T.);\n#83=FACE_OUTER_BOUND('',#81,.T.);\n\
             #84=PLANE('',#6);\n#85=ADVANCED_FACE('',(#82),#84,.T.);\n#86=ADVANCED_FACE('',(#83),#84,.T.);\n";
    let file = read("shell.step", &step(&data));
    assert_eq!(file.curves.len(), 4);
    assert!(
        file.notes.iter().any(|note| note.to_string().contains("5 edges of 2 faces the 4")),
        "{:?}",
        file.notes
    );
}

#[test]
fn broken_step_files_have_lines() {
    let cut = step(&format!("{BASE}#10=EDGE_CURVE('a',#8,#9,#7,.T.);\n"));
    for (text, word) in [
        (cut[..cut.find(",#7,.T.").unwrap()].to_owned(), "line 15: the file breaks off"),
        (step(&format!("{BASE}#10=EDGE_CURVE('a',#8,#99,#7,.T.);\n")), "#99 is referred to"),
        (
            step(&format!("{BASE}#10=EDGE_CURVE('a',#8,#1,#7,.T.);\n")),
            "line 6: #1 (CARTESIAN_POINT): a VERTEX_POINT was expected",
        ),
        (
            step(&format!("{BASE}#10=EDGE_CURVE('a',#8,#9,#11,.T.);\n#11=HYPERBOLA('',#6,1.,1.);\n")),
            "HYPERBOLA are not read",
        ),
        (step("#1=CARTESIAN_POINT('',(0.,0.,0.));"), "no edges and no bounded curves"),
        (
            step(&format!(
                "{BASE}#10=B_SPLINE_CURVE_WITH_KNOTS('',2,(#1,#2,#3),.U.,.F.,.F.,(3,2),(0.,1.),.U.);\n"
            )),
            "add up to 5, and should to 6",
        ),
        (
            step(
                "#1=COMPOSITE_CURVE('',(#2),.F.);\n#2=COMPOSITE_CURVE_SEGMENT(.C.,.T.,#1);\n#3=GEOMETRIC_SET('',(#1));",
            ),
            "made of itself",
        ),
    ] {
        let message = read_curves(text.as_bytes(), "b.step").unwrap_err().to_string();
        assert!(message.contains(word), "{message}\ninstead of {word}");
    }
}

fn dxf(entities: &str) -> String {
    let pairs: Vec<&str> = entities.split_whitespace().collect();
    format!(
        "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n{}\n0\nENDSEC\n0\nEOF\n",
        pairs.join("\n")
    )
}

#[test]
fn entities_of_drawings() {
    for (entity, right) in [
        ("0 LINE 8 rim 10 0 20 0 30 0 11 2 21 0 31 1", [[0., 0., 0.], [2., 0., 1.]]),
        ("0 ARC 8 rim 10 0 20 0 30 0 40 2 50 0 51 90", [[2., 0., 0.], [0., 2., 0.]]),
        ("0 ARC 8 rim 10 0 20 0 30 0 40 2 50 270 51 0", [[0., -2., 0.], [2., 0., 0.]]),
        // Seen from below: x runs the other way.
        ("0 ARC 8 rim 10 0 20 0 30 1 40 2 50 0 51 90 210 0 220 0 230 -1", [[-2., 0., -1.], [0., 2., -1.]]),
        ("0 CIRCLE 8 rim 10 1 20 0 30 0 40 1", [[2., 0., 0.], [2., 0., 0.]]),
        (
            "0 ELLIPSE 8 rim 10 0 20 0 30 0 11 0 21 2 31 0 40 0.5 41 0 42 1.5707963267948966",
            [[0., 2., 0.], [-1., 0., 0.]],
        ),
        (
            "0 SPLINE 8 rim 70 8 71 2 72 6 73 3 40 0 40 0 40 0 40 1 40 1 40 1 10 0 20 0 30 0 10 1 20 1 30 0 10 2 20 0 30 5",
            [[0., 0., 0.], [2., 0., 5.]],
        ),
        ("0 SPLINE 8 rim 70 0 71 3 11 0 21 0 31 0 11 1 21 1 31 1", [[0., 0., 0.], [1., 1., 1.]]),
        ("0 LWPOLYLINE 8 rim 90 2 70 0 38 3 10 0 20 0 10 2 20 0", [[0., 0., 3.], [2., 0., 3.]]),
        ("0 LWPOLYLINE 8 rim 90 2 70 0 10 2 20 0 42 1 10 -2 20 0", [[2., 0., 0.], [-2., 0., 0.]]),
        (
            "0 POLYLINE 8 rim 66 1 70 8 0 VERTEX 10 0 20 0 30 1 0 VERTEX 10 1 20 1 30 1 0 SEQEND",
            [[0., 0., 1.], [1., 1., 1.]],
        ),
    ] {
        let file = read("d.dxf", &dxf(entity));
        assert_eq!((ends(&file), file.curves[0].name.as_str()), (vec![right], "rim"), "{entity}");
        assert!(file.notes[0].to_string().contains("millimetres"));
    }
    // A half circle by its bulge runs through the middle above.
    let file = read("-", &dxf("0 LWPOLYLINE 90 3 70 1 10 2 20 0 42 1 10 -2 20 0 10 0 20 -3"));
    assert!(
        file.curves.len() == 2
            && file.curves[0].shape.sampled()[16].distance(Point::new(0.0, 2.0, 0.0)) < 1e-12
    );
    for (text, word) in [
        (dxf("0 INSERT 2 block 10 0 20 0"), "block that is not in the file"),
        (dxf("0 LINE 10 0 20 0"), "no value of code 11"),
        (dxf("0 LINE 10 a 20 0 11 1 21 1"), "\"a\" is not a number"),
        (dxf("0 CIRCLE 10 0 20 0 40 -1"), "radius"),
        ("0\nSECTION\n2\nENTITIES\n0\nLINE\n10\n0\n".into(), "without EOF"),
        ("0\nSECTION\n2\nENTITIES\nLINE\n0\n".into(), "line 5: \"LINE\" is not a code"),
    ] {
        let message = read_curves(text.as_bytes(), "b.dxf").unwrap_err().to_string();
        assert!(message.contains(word), "{message}\ninstead of {word}");
    }
}

/// Files to be damaged.
fn seeds() -> Vec<(&'static str, String)> {
    vec![
        ("a.step", step(&format!("{BASE}#10=EDGE_CURVE('a',#8,#9,#7,.T.);\n#11=TRIMMED_CURVE('',#7,(#2),(#3),.T.,.CARTESIAN.);\n#12=GEOMETRIC_SET('',(#11));"))),
        ("b.step", step("#1=CARTESIAN_POINT('',(0.,0.,0.));\n#2=CARTESIAN_POINT('',(1.,0.,0.));\n#3=B_SPLINE_CURVE_WITH_KNOTS('',1,(#1,#2),.U.,.F.,.F.,(2,2),(0.,1.),.U.);")),
        ("a.dxf", dxf("0 LWPOLYLINE 90 3 70 1 10 2 20 0 42 1 10 -2 20 0 10 0 20 -3 0 ELLIPSE 10 0 20 0 11 0 21 2 40 0.5 0 LINE 10 0 20 0 11 2 21 0")),
        ("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0 2\no a\nl 1 2\ncstype rat bspline\ndeg 1\ncurv 0 1 2 3\nparm u 0 0 1 1\nend\nl -1 1\n".into()),
        ("a.csv", "side;x;y;z\na;0,5;1;2\nb;\"1\";2;3\na;0,6;1;2\nb;1e3;2;3\n".into()),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn damaged_files_never_panic(seed in 0..5_usize, cut in 0..2000_usize, places in prop::collection::vec((0..2000_usize, 0..=255_u8), 0..6)) {
        let (name, text) = seeds().swap_remove(seed);
        let mut bytes = text.into_bytes();
        for (place, byte) in places {
            let place = place % bytes.len();
            bytes[place] = byte;
        }
        bytes.truncate(cut.max(1));
        for name in [name, "-"] {
            if let Ok(file) = read_curves(&bytes, name) {
                let _ = exchange::Assembly::new(&file, &exchange::AssemblyOptions::default());
            }
        }
    }
}

/// A drawing with blocks.
fn with_blocks(blocks: &str, entities: &str) -> String {
    let section = format!("0 SECTION 2 BLOCKS {blocks} 0 ENDSEC 0 SECTION 2 ENTITIES");
    let pairs: Vec<&str> = section.split_whitespace().collect();
    dxf(entities).replacen("0\nSECTION\n2\nENTITIES", &pairs.join("\n"), 1)
}

#[test]
fn blocks_are_set_where_they_are_inserted() {
    let arm = "0 BLOCK 2 arm 10 1 20 0 0 LINE 8 0 10 1 20 0 11 3 21 0 0 ENDBLK";
    for (insert, right) in [
        ("10 5 20 0 30 2", [[5., 0., 2.], [7., 0., 2.]]),
        ("10 0 20 0 41 0.5", [[0., 0., 0.], [1., 0., 0.]]),
        ("10 0 20 0 41 2 50 90", [[0., 0., 0.], [0., 4., 0.]]),
        ("10 1 20 1 41 -1 50 30", [[1., 1., 0.], [1. - 3f64.sqrt(), 0., 0.]]),
        // Seen from below: x runs the other way.
        ("10 1 20 0 210 0 220 0 230 -1", [[-1., 0., 0.], [-3., 0., 0.]]),
    ] {
        let file = read("d.dxf", &with_blocks(arm, &format!("0 INSERT 8 rim 2 ARM {insert}")));
        let right = right.map(|p: [f64; 3]| p.map(|x| (x * 1e9).round() / 1e9));
        // What lies on layer 0 of a block is on the layer of the INSERT.
        assert_eq!((ends(&file), file.curves[0].name.as_str()), (vec![right], "rim"), "{insert}");
        assert!(
            file.notes.iter().any(|note| note.to_string() == "curves of blocks (INSERT) that are set: 1"),
            "{:?}",
            file.notes
        );
    }
    // Two by three copies, turned; and a block in a block.
    let file = read("d.dxf", &with_blocks(arm, "0 INSERT 2 arm 10 0 20 0 50 90 70 2 71 3 44 10 45 1"));
    let starts: Vec<[f64; 3]> = ends(&file).iter().map(|ends| ends[0]).collect();
    let expected =
        [[0., 0., 0.], [0., 10., 0.], [-1., 0., 0.], [-1., 10., 0.], [-2., 0., 0.], [-2., 10., 0.]];
    assert_eq!(starts, expected);
    let nested = format!(
        "{arm} 0 BLOCK 2 cross 10 0 20 0 0 INSERT 2 arm 10 1 20 0 0 INSERT 2 arm 10 0 20 1 50 90 0 ENDBLK"
    );
    let file = read("d.dxf", &with_blocks(&nested, "0 INSERT 2 cross 10 0 20 0 30 1 41 2 42 3"));
    assert_eq!(ends(&file), [[[2., 0., 1.], [6., 0., 1.]], [[0., 3., 1.], [0., 9., 1.]]]);
}

#[test]
fn circles_of_a_block_that_is_scaled_unevenly_are_ellipses() {
    let blocks = "0 BLOCK 2 a 10 0 20 0 0 CIRCLE 10 1 20 0 40 1 0 ARC 10 0 20 0 40 1 50 0 51 90 0 ENDBLK \
                  0 BLOCK 2 b 10 0 20 0 0 INSERT 2 a 10 0 20 0 50 30 0 ENDBLK";
    // Turned, then scaled: the half axes are none of those of the circle.
    let file = read("d.dxf", &with_blocks(blocks, "0 INSERT 2 b 10 0 20 0 41 3 42 1"));
    let (s, c) = (0.5, 0.75f64.sqrt());
    for (curve, centre) in file.curves.iter().zip([[c, s], [0.0, 0.0]]) {
        for p in curve.shape.sampled() {
            let off = libm::hypot(p.x / 3.0 - centre[0], p.y - centre[1]) - 1.0;
            assert!(off.abs() < 1e-14, "{p:?}");
        }
    }
    let [start, end] = file.curves[1].shape.ends();
    assert!(start.distance(Point::new(3.0 * c, s, 0.0)) < 1e-14, "{start:?}");
    assert!(end.distance(Point::new(-3.0 * s, c, 0.0)) < 1e-14, "{end:?}");
}

#[test]
fn blocks_without_end_are_refused() {
    let itself = "0 BLOCK 2 a 10 0 20 0 0 INSERT 2 a 10 1 20 0 0 ENDBLK";
    let mut many = String::from("0 BLOCK 2 b0 10 0 20 0 0 LINE 10 0 20 0 11 1 21 0 0 ENDBLK");
    for k in 1..12 {
        let inner = format!(" 0 INSERT 2 b{} 10 1 20 0", k - 1).repeat(10);
        many += &format!(" 0 BLOCK 2 b{k} 10 0 20 0{inner} 0 ENDBLK");
    }
    let far = "0 BLOCK 2 a 10 0 20 0 0 LINE 10 1e50 20 0 11 1 21 0 0 ENDBLK";
    for (blocks, entities, word) in [
        (itself, "0 INSERT 2 a 10 0 20 0", "in themselves"),
        (&many, "0 INSERT 2 b11 10 0 20 0", "the most that are read"),
        (itself, "0 INSERT 2 a 10 0 20 0 70 1000 71 1000", "more than 10000"),
        (itself, "0 INSERT 2 a 10 0 20 0 70 1e9", "rows or columns"),
        (far, "0 INSERT 2 a 10 0 20 0 41 1e20", "coordinates"),
        (
            "0 BLOCK 2 a 10 0 20 0 0 CIRCLE 10 1 20 0 40 1 0 ENDBLK",
            "0 INSERT 2 a 10 0 20 0 42 0",
            "leaves no plane",
        ),
    ] {
        let message = read_curves(with_blocks(blocks, entities).as_bytes(), "b.dxf").unwrap_err().to_string();
        assert!(message.contains(word), "{message}");
    }
}
