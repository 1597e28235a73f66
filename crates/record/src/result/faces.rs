use std::collections::{HashMap, HashSet};

use serde::{Deserialize, Serialize};
use surfaces::{Bezier, Complex, Face, FixedEdge, Vertex};

use super::net::{Rows, net};
use super::unfit::{Unfit, unfit};

/// One patch of a complex: its vertices by name, in order round it, and its net.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct FaceEntry {
    vertices: [String; 4],
    net: Rows,
}

/// The faces of a complex whose vertices have these names.
pub(super) fn entries(complex: &Complex, names: &[String]) -> Vec<FaceEntry> {
    let count = complex.degree() + 1;
    let entry = |face: &Face| FaceEntry {
        vertices: face.vertices().map(|vertex| names[vertex].clone()),
        net: face
            .nodes()
            .chunks_exact(count)
            .map(|row| row.iter().map(|&k| complex.points()[k].into()).collect())
            .collect(),
    };
    complex.faces().iter().map(entry).collect()
}

/// The numbers of the vertices of faces: as `order`, which stands at `key`, lists their names, else as they are met.
pub(super) fn numbers(
    faces: &[FaceEntry],
    order: Option<Vec<String>>,
    key: &str,
) -> Result<HashMap<String, usize>, Unfit> {
    let (mut met, mut listed) = (HashMap::new(), HashMap::new());
    for name in faces.iter().flat_map(|face| &face.vertices) {
        let next = met.len();
        met.entry(name.clone()).or_insert(next);
    }
    let Some(order) = order else { return Ok(met) };
    for name in order {
        let next = listed.len();
        if !met.contains_key(&name) || listed.contains_key(&name) {
            return Err(unfit(key, format!("{name:?} is no vertex of a face, or stands twice")));
        }
        listed.insert(name, next);
    }
    match met.into_keys().find(|name| !listed.contains_key(name)) {
        Some(name) => Err(unfit(key, format!("{name:?} is missing, a vertex of a face"))),
        None => Ok(listed),
    }
}

/// The complex of faces, which stand at `key`, that share the edges between vertices of the same names.
pub(super) fn complex(
    faces: &[FaceEntry],
    numbers: &HashMap<String, usize>,
    key: &str,
) -> Result<Complex, Unfit> {
    let Some(first) = faces.first() else { return Err(unfit(key, "is empty")) };
    let degree = first.net.len().saturating_sub(1);
    let mut vertices = vec![Vertex::Free(None); numbers.len()];
    let (mut corners, mut edges, mut met) = (Vec::new(), Vec::new(), HashSet::new());
    for (k, face) in faces.iter().enumerate() {
        let here = format!("{key}[{k}].net");
        let net = net(&face.net, &here)?;
        if net.degrees() != (degree, degree) {
            return Err(unfit(&here, format!("has degrees {:?}, the first face {degree}", net.degrees())));
        }
        let [u0, u1, v0, v1] = net.boundary();
        let places = [u0[0], u1[0], u1[degree], u0[degree]];
        let quad: [usize; 4] = std::array::from_fn(|c| numbers[&face.vertices[c]]);
        for (vertex, place) in quad.into_iter().zip(places) {
            if let Vertex::Free(_) = vertices[vertex] {
                vertices[vertex] = Vertex::Fixed(place);
            }
        }
        for (ends, side) in [([0, 3], u0), ([1, 2], u1), ([0, 1], v0), ([3, 2], v1)] {
            let ends = ends.map(|c| quad[c]);
            if met.insert([ends[0].min(ends[1]), ends[0].max(ends[1])]) {
                let curve = Bezier::new(side).map_err(|error| unfit(&here, error))?;
                edges.push(FixedEdge { ends, curve });
            }
        }
        corners.push(quad);
    }
    let whole = Complex::new(degree, &vertices, &corners, &edges);
    let filled = whole.and_then(|whole| {
        let mut points = whole.points().to_vec();
        for (face, entry) in whole.faces().iter().zip(faces) {
            for (&node, &point) in face.nodes().iter().zip(entry.net.iter().flatten()) {
                points[node] = point.into();
            }
        }
        whole.with_points(points)
    });
    filled.map_err(|error| unfit(key, error))
}
