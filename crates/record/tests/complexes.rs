//! Surfaces of several faces, read back.

use plateau::{Fill, Loop, MethodResult, Surface};
use record::{SCHEMA, StoredMethod, StoredResult, method_record};
use surfaces::{Complex, Point};

/// A loop of five corners, filled.
fn pentagon() -> MethodResult {
    let corners: Vec<Point> = (0..5)
        .map(|k| {
            let angle = std::f64::consts::TAU * f64::from(k) / 5.0;
            Point::new(angle.cos(), angle.sin(), 0.2 * f64::from(k % 2))
        })
        .collect();
    let film = Fill::default().with_degree(3).loops(&[Loop::polygon(&corners).unwrap()], &()).unwrap();
    MethodResult { name: "film".into(), outcome: Ok(Box::new(film.into_done())) }
}

fn parsed(entry: &str) -> Result<StoredMethod, String> {
    let text = format!(r#"{{"schema": "{SCHEMA}", "title": "", "methods": [{entry}]}}"#);
    StoredResult::parse(text.as_bytes()).map(|mut read| read.methods.remove(0)).map_err(|e| e.to_string())
}

fn complex(method: StoredMethod) -> Complex {
    match method.surface.unwrap().0 {
        Surface::Complex(complex) => complex,
        Surface::Tensor(_) | Surface::Triangle(_) | Surface::Pieces(_) => panic!("a complex"),
    }
}

#[test]
fn points_and_meshes_keep_their_order() {
    let result = pentagon();
    let entry = method_record(&result).unwrap();
    let (made, read) = (complex(StoredMethod::of(&result)), complex(parsed(&entry).unwrap()));
    assert_eq!(made.points(), read.points());
    let [made, read] = [made, read].map(|complex| complex.mesh(5).unwrap().mesh);
    assert_eq!((made.points, made.triangles), (read.points, read.triangles));
}

#[test]
fn an_order_names_every_vertex_once() {
    let entry = method_record(&pentagon()).unwrap();
    let changed = |change: fn(&mut Vec<serde_json::Value>)| {
        let mut entry: serde_json::Value = serde_json::from_str(&entry).unwrap();
        change(entry["vertices"].as_array_mut().unwrap());
        parsed(&entry.to_string()).unwrap_err()
    };
    assert!(changed(|names| drop(names.pop())).contains("is missing"));
    assert!(changed(|names| names.push(names[0].clone())).contains("stands twice"));
    assert!(changed(|names| names[0] = "elsewhere".into()).contains("\"elsewhere\" is no vertex"));
    // Without an order the surface is the same, its points are numbered as the faces name them.
    let mut bare: serde_json::Value = serde_json::from_str(&entry).unwrap();
    bare.as_object_mut().unwrap().remove("vertices");
    let sorted = |complex: Complex| {
        let mut points: Vec<[f64; 3]> = complex.points().iter().map(|&p| p.into()).collect();
        points.sort_by(|a, b| a.partial_cmp(b).unwrap());
        points
    };
    let [ordered, bare] = [entry, bare.to_string()].map(|entry| sorted(complex(parsed(&entry).unwrap())));
    assert_eq!(ordered, bare);
}
