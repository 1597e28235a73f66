//! Tables of points that have names: surveys.

use exchange::{Shape, read_curves};
use proptest::prelude::*;

type Points = Vec<[f64; 3]>;

/// The points of the curves of a table, and whether they are closed.
fn loops(text: &str) -> Vec<(Points, bool)> {
    let file = read_curves(text.as_bytes(), "survey.csv").unwrap_or_else(|error| panic!("{error}\n{text}"));
    file.curves
        .iter()
        .map(|curve| {
            let Shape::Polyline(points) = &curve.shape else { panic!("{curve:?}") };
            (points.iter().map(|&p| p.into()).collect(), curve.closes)
        })
        .collect()
}

proptest! {
    /// A column that names every point changes nothing: before the coordinates or behind them, words or numbers, with a heading or none.
    #[test]
    fn names_of_points_are_no_sides(
        points in prop::collection::vec([-100.0..100.0, -100.0..100.0, -9.0..9.0], 3..12),
        start in 0_i64..2000,
    ) {
        // What is whole by accident would be a number of a point.
        prop_assume!(points.iter().any(|p: &[f64; 3]| p[0].fract() != 0.0));
        let bare = |p: &[f64; 3]| format!("{:?},{:?},{:?}", p[0], p[1], p[2]);
        let table = |heading: &str, row: &dyn Fn(i64, String) -> String| {
            let rows = points.iter().zip(start..).map(|(p, k)| row(k, bare(p)) + "\n");
            heading.to_owned() + &rows.collect::<String>()
        };
        let wanted = loops(&table("x,y,z\n", &|_, row| row));
        prop_assert_eq!(&wanted, &vec![(points.clone(), true)]);
        for text in [
            table("", &|k, row| format!("P{k},{row}")),
            table("", &|k, row| format!("{row},P{k}")),
            table("", &|k, row| format!("{k},{row}")),
            table("", &|k, row| format!("{row},{k}")),
            table("point,x,y,z\n", &|k, row| format!("P{k},{row}")),
            table("id,x,y,z\n", &|k, row| format!("{k},{row}")),
            table("Punkt,E,N,H\n", &|k, row| format!("P{k},{row}")),
        ] {
            prop_assert_eq!(&loops(&text), &wanted, "{}", text);
        }
    }
}

#[test]
fn north_before_east_is_read_by_its_heading_and_codes_are_sides() {
    let wanted = vec![(vec![[4.0, 9.0, 1.0], [5.0, 8.0, 2.0], [6.0, 7.0, 3.0]], true)];
    assert_eq!(loops("Pt,Northing,Easting,Elev\nA,9,4,1\nB,8,5,2\nC,7,6,3\n"), wanted);
    assert_eq!(loops("Pt;Hochwert;Rechtswert;Höhe\nA;9;4;1\nB;8;5;2\nC;7;6;3\n"), wanted);
    // Number, three coordinates, what was measured.
    let coded = loops("1,0,0,0,kerb\n2,1,0,0,kerb\n3,1,1,1,wall\n4,0,1,0,wall\n");
    assert_eq!(coded, [(vec![[0.0; 3], [1.0, 0.0, 0.0]], false), (vec![[1.0; 3], [0.0, 1.0, 0.0]], false)]);
}

#[test]
fn what_a_table_leaves_open_is_asked() {
    for (text, said) in [
        ("0.5 0 0 7\n1.5 0 0 9\n1 1 1 8\n", "which of them are the coordinates"),
        ("name,lat,lon\na,52.5,13.4\nb,52.6,13.4\nc,52.6,13.5\n", "project the points to metres"),
    ] {
        let error = read_curves(text.as_bytes(), "a.txt").unwrap_err().to_string();
        assert!(error.contains(said), "{error}");
    }
    for (name, text, what) in [
        ("a.geojson", "{\"type\": \"LineString\", \"coordinates\": [[13.4, 52.5]]}", "a GeoJSON file"),
        ("a.kml", "<?xml version=\"1.0\"?><kml/>", "a KML file"),
        ("a.gpx", "<?xml version=\"1.0\"?><gpx version=\"1.1\"/>", "a GPX file"),
        ("a.ifc", "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('IFC4'));\nENDSEC;\nDATA;\n", "an IFC file"),
    ] {
        let error = read_curves(text.as_bytes(), name).unwrap_err().to_string();
        assert!(error.starts_with(&format!("is {what}")), "{error}");
    }
}
