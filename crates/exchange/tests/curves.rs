//! Small files of every dialect: what is read of them, and what is said of those that are not.

use exchange::{CurveFile, CurveFileError, Kind, Shape, read_curves};
use surfaces::Point;

fn read(name: &str, text: &str) -> CurveFile {
    read_curves(text.as_bytes(), name).unwrap_or_else(|error| panic!("{name}: {error}\n{text}"))
}

fn refused(name: &str, text: &[u8]) -> String {
    match read_curves(text, name) {
        Err(error) => error.to_string(),
        Ok(file) => panic!("{name} was read: {file:?}"),
    }
}

fn points(file: &CurveFile, curve: usize) -> Vec<[f64; 3]> {
    let Shape::Polyline(points) = &file.curves[curve].shape else {
        panic!("no polyline: {:?}", file.curves[curve])
    };
    points.iter().map(|p| (*p).into()).collect()
}

fn names(file: &CurveFile) -> Vec<&str> {
    file.curves.iter().map(|curve| curve.name.as_str()).collect()
}

#[test]
fn tables_of_many_dialects_hold_the_same_points() {
    let right = [[0.5, 1.0, 2.0], [1.5, 1.0, 2.0]];
    for text in [
        "side,x,y,z\nrim,0.5,1,2\nrim,1.5,1,2\nw,1,1,1\nw,2,2,2\n",
        "rim,0.5,1,2\nrim,1.5,1,2\nw,1,1,1\nw,2,2,2\n",
        "\u{feff}\"Side\",\"X\",\"Y\",\"Z\"\r\n\"rim\",\"0.5\",\"1\",\"2\"\r\n\"rim\",1.5,1,2\r\nw,1,1,1\r\nw,2,2,2\r\n",
        "side,z,y,x\nrim,2,1,0.5\nrim,2,1,1.5\nw,1,1,1\nw,2,2,2\n",
        "x;y;z;Seite\n0,5;1,0;2\u{3b}rim\n1,5;1;2;rim\n1;1;1;w\n2;2;2;w\n",
        "Seite\tx [mm]\ty [mm]\tz [mm]\nrim\t0,5\t1\t2\nrim\t1,5\t1\t2\nw\t1\t1\t1\nw\t2\t2\t2",
        "# a remark\nrim 0.5 1 2\nrim   1.5 1 2\n\nw 1 1 1\nw 2 2 2\n",
        "rim 0,5 1 2\nrim 1,5 1,0 2\nw 1 1 1\nw 2 2 2\n",
        "sep=;\nside;x;y;z\nrim;0.5;1;2;\nrim;1.5;1;2;\nw;1;1;1;\nw;2;2;2;\n",
        "no,Point_X,Point_Y,Point_Z,curve,remark\n1,0.5,1,2,rim,first\n2,1.5,1,2,rim,second\n3,1,1,1,w,a\n4,2,2,2,w,b\n",
        "0.5,1,2,rim\n1.5,1,2,rim\n1,1,1,w\n2,2,2,w\n",
        "side\tX\tY\tZ\rrim\t0.5\t1\t2\rrim\t1.5\t1\t2\rw\t1\t1\t1\rw\t2\t2\t2\r",
        "Easting,Northing,Elevation,name\n0.5,1,2,rim\n1.5,1,2,rim\n1,1,1,w\n2,2,2,w\n",
        "side|x|y|z\nrim|0.5|1|2\nrim|1.5|1|2\nw|1|1|1\nw|2|2|2\n",
        "| side | x | y | z |\n|------|:---|---|---:|\n| rim | 0,5 | 1 | 2 |\n| rim | 1,5 | 1 | 2 |\n| w | 1 | 1 | 1 |\n| w | 2 | 2 | 2 |\n",
        "rim,0.5D+00,1.0D0,2.0d+00\nrim,15.0D-01,1,2\nw,1,1,1\nw,2,2,2\n",
        "rim;0,5D+00;\u{a0}1\u{a0};2\nrim;1,5;1\u{202f};2\nw;1;1;1\nw;2;2;2\n",
    ] {
        let file = read("t.csv", text);
        assert_eq!((points(&file, 0), names(&file)), (right.to_vec(), vec!["rim", "w"]), "{text}");
        assert_eq!(file.kind, Kind::Table);
    }
    let utf16: Vec<u8> = "\u{feff}side\tx\ty\tz\r\nrim\t0,5\t1\t2\r\nrim\t1,5\t1\t2\r\n"
        .encode_utf16()
        .flat_map(u16::to_le_bytes)
        .collect();
    assert_eq!(points(&read_curves(&utf16, "-").unwrap(), 0), right);
    let latin = b"side;x;y;z\nK\xFCste;0,5;1;2\nK\xFCste;1,5;1;2\n";
    assert_eq!(names(&read_curves(latin, "k.csv").unwrap()), ["Küste"]);
}

#[test]
fn minus_signs_of_typesetters_are_read_and_names_with_a_d_are_names() {
    let file = read("t.csv", "x,y,z\n\u{2212}1.5,0,0\n1,\u{2212}2.5e\u{2212}1,0\n1,1,0\n");
    assert_eq!(points(&file, 0)[..2], [[-1.5, 0.0, 0.0], [1.0, -0.25, 0.0]]);
    let file = read("t.csv", "1d2,0,0\n1d2,1,0\n2d2,1,0\n2d2,1,1\n");
    assert_eq!(names(&file), ["1d2", "2d2"]);
}

/// What keeps a cell from being a number is named, and what to do.
#[test]
fn characters_in_the_way_are_named() {
    for (cell, words) in [
        ("1'000.5", ["apostrophe", "separators of thousands"]),
        ("1\u{2019}000", ["apostrophe", "separators of thousands"]),
        ("1 000.5", ["U+0020", "separators of thousands"]),
        ("1\u{a0}000", ["U+00A0", "separators of thousands"]),
        ("\u{2013}1.5", ["U+2013", "U+002D"]),
        ("\u{ff11}.5", ["U+FF11", "digits 0 to 9"]),
        ("1.5mm", ["character m (U+006D)", "the number alone"]),
        ("1.5D", ["character D (U+0044)", "the number alone"]),
        ("1.5\u{200b}", ["U+200B", "the number alone"]),
    ] {
        for text in
            [format!("x;y;z\n0;0;0\n{cell};0;0\n1;1;0\n"), format!("x,y,z\n0,0,0\n{cell},0,0\n1,1,0\n")]
        {
            let message = refused("t.csv", text.as_bytes());
            assert!(
                message.starts_with("line 3") && words.iter().all(|word| message.contains(word)),
                "{message}"
            );
        }
    }
    assert!(
        refused("t.csv", b"x:y:z\n0:0:0\n1:0:0\n").contains("tabs, semicolons, bars (|), commas or blanks")
    );
    for bytes in [u32::to_le_bytes, u32::to_be_bytes] {
        let utf32: Vec<u8> = "\u{feff}x,y,z\n0,0,0\n1,0,0\n".chars().flat_map(|c| bytes(c.into())).collect();
        assert!(refused("t.csv", &utf32).contains("UTF-32: save it as text in UTF-8"));
    }
}

#[test]
fn names_keep_their_blanks_and_quotes() {
    let file = read(
        "t.csv",
        "side,x,y,z\nwall upper,0,0,0\nwall upper,1,0,0\n\"a, \"\"b\"\"\",0,0,0\n\"a, \"\"b\"\"\",1,0,0\n",
    );
    assert_eq!(names(&file), ["wall upper", "a, \"b\""]);
    let file = read("t.txt", "\"wall upper\" 0 0 0\n\"wall upper\" 1 0 0\n");
    assert_eq!(names(&file), ["wall upper"]);
}

#[test]
fn tables_without_sides_are_loops() {
    for text in
        ["x,y,z\n0,0,0\n1,0,0\n1,1,0\n", "0 0 0\n1 0 0\n1 1 0\n", "i,x,y,z\n1,0,0,0\n2,1,0,0\n3,1,1,0\n"]
    {
        let file = read("t.csv", text);
        assert!(file.curves.len() == 1 && file.curves[0].closes && file.curves[0].name.is_empty(), "{text}");
        assert_eq!(points(&file, 0), [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.]]);
        assert!(file.notes.iter().any(|note| note.to_string().contains("one loop")), "{:?}", file.notes);
    }
    let flat = read("t.csv", "x;y\n0;0\n1;0,5\n");
    assert!(
        points(&flat, 0) == [[0., 0., 0.], [1., 0.5, 0.]]
            && flat.notes.iter().any(|note| note.to_string().contains("z = 0"))
    );
    assert_eq!(read("t.dat", "0 0 0\n1 0 0\n\n0 0 1\n1 0 1\n").curves.len(), 2);
}

#[test]
fn rows_that_are_none_have_a_line() {
    for (text, word) in [
        ("u,0,0,0\nu,1,nan,0\n", "line 2: \"nan\" is no coordinate"),
        ("u,0,0,0\nu,1,inf,0\n", "line 2: \"inf\""),
        ("u,0,0,0\nu,1,1e70,0\n", "line 2: \"1e70\""),
        ("u,0,0,0\nu,1,0\n", "line 2: here are 3 cells"),
        ("u;0,0;0;0\nu;1.5;0;0\n", "comma in line 1 and a point in line 2"),
        ("u;1.000,5;0;0\nu;1;0;0\n", "thousands"),
        ("side,x,x,z\nu,0,0,0\n", "both x"),
        ("side,x,z\nu,0,0\n", "not x and y"),
        ("a b 0 0 0\na b 1 0 0\n", "are 5 cells"),
        ("u,0,0,0\nv,0,0,0\nv,1,0,0\n", "line 1: side \"u\" has a single point"),
        ("side,x,y,z\n", "no points"),
        ("", "is empty"),
    ] {
        let message = refused("t.csv", text.as_bytes());
        assert!(message.contains(word), "{message}\ninstead of {word}");
    }
}

#[test]
fn lines_of_obj_files() {
    let text = "# vertices below what names them\no rim\nl 1 2 \\\n 3\nv 0 0 0\nv 1 0 0 0.5 0.5 0.5\nl -1/1 4\nv 1 1 0 1.0\nv 0 1 0\nf 1 2 3\ng back\nl 4 1\n";
    let file = read("rim.obj", text);
    assert_eq!((file.curves.len(), names(&file), file.curves[2].line), (3, vec!["rim", "rim", "back"], 12));
    assert_eq!(points(&file, 0), [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.]]);
    // Counted from where it stands: the last vertex then was the second.
    assert_eq!(points(&file, 1), [[1., 0., 0.], [0., 1., 0.]]);
    assert!(file.notes[0].to_string().contains("1 faces of a mesh"));
    // What it is follows from its content.
    assert_eq!(read("-", "v 0 0 0\nv 1 0 0\nl 1 2\n").kind, Kind::Obj);
    for (text, word) in [
        ("v 0 0 0\nl 1 2\n", "line 2: there is no vertex \"2\": the file has 1"),
        ("l 0 1\n", "line 1"),
        ("v 0 0 0\nl -2 1\n", "line 2"),
        ("v 0 nan 0", "line 1: \"nan\""),
        ("v 1 2", "three coordinates; here are 2"),
        ("v 0 0 0\nl 1\n", "two or more"),
        ("v 0 0 0\nv 1 0 0 2\nl 1 2\n", "line 2: this vertex of a line (`l`) has the weight 2"),
        ("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n", "mesh of 1 faces without lines"),
        ("v 0 0 0\n", "no lines"),
    ] {
        let message = refused("t.obj", text.as_bytes());
        assert!(message.contains(word), "{message}\ninstead of {word}");
    }
}

const QUARTER: &str = "v 1 0 0 1\nv 1 1 0 0.70710678118654752\nv 0 1 0 1\n";

#[test]
fn free_form_curves_of_obj_files() {
    let check = |text: &str, radius: f64| {
        let file = read("c.obj", text);
        let Shape::Spline(spline) = &file.curves[0].shape else { panic!("{file:?}") };
        for k in 0..=10 {
            assert!((spline.jet(f64::from(k) / 10.0).point.norm() - radius).abs() < 1e-14);
        }
        file
    };
    check(&format!("{QUARTER}cstype rat bezier\ndeg 2\ncurv 0 1 1 2 3\nparm u 0 1\nend\n"), 1.0);
    check(&format!("{QUARTER}cstype rat bspline\ndeg 2\ncurv 0 1 1 2 3\nparm u 0 0 0 1 1 1\nend\n"), 1.0);
    // Only a part of it.
    let file = check(
        &format!("{QUARTER}cstype rat bspline\ndeg 2\ncurv 0.25 1 -3 -2 -1\nparm u 0 0 0 \\\n1 1 1\nend\n"),
        1.0,
    );
    let [start, end] = file.curves[0].shape.ends();
    assert!(start.y > 0.3 && end.distance(Point::new(0.0, 1.0, 0.0)) < 1e-15);
    // Two Bézier pieces in one.
    let text = "v 0 0 0\nv 1 1 0\nv 2 0 0\nv 3 -1 0\nv 4 0 0\ncstype bezier\ndeg 2\ncurv 0 2 1 2 3 4 5\nparm u 0 1 2\nend\n";
    let Shape::Spline(spline) = &read("c.obj", text).curves[0].shape else { panic!() };
    assert_eq!((spline.knots().len(), spline.bezier_pieces().unwrap().len()), (8, 2));
    for (text, word) in [
        ("cstype cardinal\n", "\"cardinal\" are not read"),
        ("deg 3\ncurv 0 1 1 2\n", "needs its kind"),
        ("cstype bezier\ncurv 0 1 1 2\n", "needs its degree"),
        (
            "v 0 0 0\nv 1 0 0\nv 2 0 0\ncstype bspline\ndeg 2\ncurv 0 1 1 2 3\nparm u 0 0 1 1\nend\n",
            "has 6 knots, got 4",
        ),
        ("v 0 0 0\nv 1 0 0\nv 2 0 0\ncstype bezier\ndeg 3\ncurv 0 1 1 2 3\nend\n", "multiple"),
        ("cstype bezier\ndeg 3\ncurv 0\n", "first and last parameter"),
    ] {
        let message = refused("t.obj", text.as_bytes());
        assert!(message.contains(word), "{message}\ninstead of {word}");
    }
}

#[test]
fn files_of_other_kinds_are_named() {
    let mut stl = vec![b' '; 80];
    stl.extend(1_u32.to_le_bytes());
    stl.extend([0; 50]);
    let zip = |inside: &str| [b"PK\x03\x04".as_slice(), inside.as_bytes()].concat();
    for (bytes, word) in [
        (b"solid a\nfacet normal 0 0 1\n".to_vec(), "STL"),
        (stl, "STL"),
        (b"ply\nformat ascii 1.0\n".to_vec(), "PLY"),
        (b"glTF\x02\0\0\0".to_vec(), "glTF"),
        (b"{\"asset\": {\"version\": \"2.0\"}}".to_vec(), "glTF"),
        (b"{\"schema\": \"plateau-result/1\"}".to_vec(), "plateau export"),
        (b"title = \"a\"\n[boundary]\n".to_vec(), "plateau run"),
        (b"\x89PNG\r\n\x1a\n".to_vec(), "PNG"),
        (b"\xFF\xD8\xFF\xE0".to_vec(), "JPEG"),
        (b"%PDF-1.7".to_vec(), "PDF"),
        (zip("xl/workbook.xml"), "Excel"),
        (zip("anything"), "zip"),
        (b"3D Geometry File Format        70".to_vec(), "Rhino"),
        (b"AutoCAD Binary DXF\r\n\x1a\0".to_vec(), "ASCII DXF"),
        (b"AC1032\0\0".to_vec(), "DWG"),
        (b"<svg xmlns='http://www.w3.org/2000/svg'>".to_vec(), "SVG"),
        (b"<?xml version='1.0'?><VTKFile>".to_vec(), "VTK"),
        (format!("{:72}S      1\n", "x").into_bytes(), "IGES"),
        (b"\x1F\x8B\x08".to_vec(), "gzip"),
        (b"a,0,0\0,0".to_vec(), "no text"),
    ] {
        for name in ["-", "a.obj", "a.csv"] {
            let message = refused(name, &bytes);
            assert!(message.contains(word), "{message}\ninstead of {word}");
        }
    }
    assert!(matches!(read_curves(&vec![b' '; (16 << 20) + 1], "-"), Err(CurveFileError::TooLarge { .. })));
    let many: String = (0..20_000).map(|k| format!("s{k},0,0,0\n")).collect();
    assert!(refused("many.csv", many.as_bytes()).contains("the sides become more than"));
}
