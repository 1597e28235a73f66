//! Patches as Bézier cells of VTK, read back by the numbering that VTK states for them.

use base64::prelude::{BASE64_STANDARD, Engine};
use exchange::{Format, Subject, SurfaceFile, SurfaceForm};
use plateau::{Family, Surface};
use surfaces::{
    Complex, Mesh, Net, Patch, Point, ShapedFamily, TensorPatch, TriangleNet, TrianglePatch, Vertex,
};

/// A cell as it is read: type, degrees, control points in the order of the file.
struct Cell {
    kind: u8,
    degrees: [usize; 2],
    points: Vec<Point>,
    nodes: Vec<i64>,
}

fn written(surface: &Surface, family: Family) -> (String, SurfaceForm) {
    let mesh = Mesh::default();
    let subject = Subject { name: "cells", mesh: &mesh, colours: None, unit: None };
    let file = SurfaceFile::new(Format::VtuBezier, subject, (surface, family), 1e-8).unwrap();
    let mut out = Vec::new();
    file.write(&mut out).unwrap();
    (String::from_utf8(out).unwrap(), file.form().unwrap())
}

/// The numbers of an array, eight bytes each.
fn array(text: &str, name: &str) -> Vec<[u8; 8]> {
    let (_, rest) = text.split_once(&format!("Name=\"{name}\"")).unwrap();
    let coded = rest.lines().nth(1).unwrap();
    let bytes = BASE64_STANDARD.decode(coded).unwrap();
    let (length, bytes) = bytes.split_at(8);
    assert_eq!(u64::from_le_bytes(length.try_into().unwrap()), bytes.len() as u64, "{name}");
    let words = bytes.chunks(8);
    words.map(|word| std::array::from_fn(|k| word.get(k).copied().unwrap_or(0))).collect()
}

fn cells(text: &str) -> Vec<Cell> {
    let doubles = |name| array(text, name).into_iter().map(f64::from_le_bytes).collect::<Vec<_>>();
    let whole = |name| array(text, name).into_iter().map(i64::from_le_bytes).collect::<Vec<_>>();
    let points: Vec<Point> = doubles("points").chunks(3).map(|p| Point::new(p[0], p[1], p[2])).collect();
    let (nodes, ends, degrees) = (whole("connectivity"), whole("offsets"), doubles("HigherOrderDegrees"));
    let kinds: Vec<u8> = array(text, "types").into_iter().flatten().collect();
    let mut start = 0;
    let cells = ends.iter().zip(kinds).zip(degrees.chunks(3)).map(|((&end, kind), degrees)| {
        let nodes = nodes[std::mem::replace(&mut start, end as usize)..end as usize].to_vec();
        let points = nodes.iter().map(|&k| points[k as usize]).collect();
        Cell { kind, degrees: [degrees[0] as usize, degrees[1] as usize], points, nodes }
    });
    cells.collect()
}

fn binomial(n: usize, k: usize) -> f64 {
    (0..k).map(|i| (n - i) as f64 / (i + 1) as f64).product()
}

fn bernstein(n: usize, k: usize, t: f64) -> f64 {
    binomial(n, k) * t.powi(k as i32) * (1.0 - t).powi((n - k) as i32)
}

impl Cell {
    /// Where VTK keeps control point (i, j): corners, then the sides j = 0, i = m, j = n, i = 0, then the inside.
    fn place(&self, i: usize, j: usize) -> usize {
        let [m, n] = self.degrees;
        let (at_i, at_j) = (i == 0 || i == m, j == 0 || j == n);
        match (at_i, at_j) {
            (true, true) => [[0, 3], [1, 2]][usize::from(i == m)][usize::from(j == n)],
            (false, true) => 4 + (i - 1) + if j == 0 { 0 } else { m - 1 + n - 1 },
            (true, false) => 4 + (j - 1) + if i == 0 { 2 * (m - 1) + n - 1 } else { m - 1 },
            (false, false) => 4 + 2 * (m - 1 + n - 1) + (i - 1) + (m - 1) * (j - 1),
        }
    }

    /// The point of a quadrilateral.
    fn at(&self, u: f64, v: f64) -> Point {
        let [m, n] = self.degrees;
        assert_eq!((self.kind, self.points.len()), (77, (m + 1) * (n + 1)));
        let grid = (0..=m).flat_map(|i| (0..=n).map(move |j| (i, j)));
        grid.fold(Point::ZERO, |sum, (i, j)| {
            sum + self.points[self.place(i, j)] * (bernstein(m, i, u) * bernstein(n, j, v))
        })
    }
}

fn wave(rows: usize, cols: usize) -> Vec<Point> {
    let at = |i: usize, j: usize| {
        let (x, y) = (i as f64, j as f64);
        Point::new(x + 0.1 * y * y, y - 0.05 * x * y, 0.3 * x * x - 0.2 * x * y + 0.01 * y * y * y)
    };
    (0..rows).flat_map(|i| (0..cols).map(move |j| at(i, j))).collect()
}

const PARAMETERS: [f64; 5] = [0.0, 0.13, 0.5, 0.8, 1.0];

#[test]
fn a_net_is_one_cell_of_its_degrees() {
    for (rows, cols) in [(2, 2), (2, 5), (4, 3), (7, 7), (31, 2)] {
        let patch = TensorPatch::bernstein(Net::new(rows, cols, wave(rows, cols)).unwrap()).unwrap();
        let (text, form) = written(&Surface::Tensor(patch.clone()), Family::Bernstein);
        let cells = cells(&text);
        assert_eq!((cells.len(), cells[0].degrees, form.deviation), (1, [rows - 1, cols - 1], None));
        for (u, v) in PARAMETERS.into_iter().flat_map(|u| PARAMETERS.map(|v| (u, v))) {
            let off = cells[0].at(u, v).distance(patch.jet(u, v).point);
            assert!(off < 1e-11, "{rows} x {cols}: {off:e}");
        }
    }
}

#[test]
fn faces_share_the_points_of_their_common_edge_and_lie_on_one_side() {
    let corners: [[f64; 3]; 6] =
        [[0., 0., 0.], [1., 0., 0.], [2., 0., 1.], [0., 1., 0.], [1., 1., 1.], [2., 1., 0.]];
    let vertices = corners.map(|p| Vertex::Fixed(Point::from(p)));
    for second in [[1, 2, 5, 4], [1, 4, 5, 2]] {
        let complex = Complex::new(4, &vertices, &[[0, 1, 4, 3], second], &[]).unwrap();
        let (text, form) = written(&Surface::Complex(complex.clone()), Family::Complex);
        let cells = cells(&text);
        assert!(form.description.starts_with("exact: 2 Bézier cells of degree (4, 4)"), "{form:?}");
        let common = cells[0].nodes.iter().filter(|node| cells[1].nodes.contains(node)).count();
        assert_eq!(common, 5);
        for (face, cell) in cells.iter().enumerate() {
            let turned = complex.orientation().flipped()[face];
            let patch = complex.patch(face).unwrap();
            for (u, v) in PARAMETERS.into_iter().flat_map(|u| PARAMETERS.map(|v| (u, v))) {
                let (s, t) = if turned { (v, u) } else { (u, v) };
                assert!(cell.at(u, v).distance(patch.jet(s, t).point) < 1e-14);
            }
            // Seen from above, both run round to the left.
            let [a, b, _, d] = [0, 1, 2, 3].map(|k| cell.points[k]);
            assert!((b - a).cross(d - a).z > 0.0);
        }
    }
}

#[test]
fn a_triangle_is_written_ring_by_ring() {
    for degree in [1, 2, 3, 4, 6, 11] {
        let count = (degree + 1) * (degree + 2) / 2;
        let net = TriangleNet::new(degree, wave(count, 1)).unwrap();
        let surface = Surface::Triangle(TrianglePatch::new(net.clone()).unwrap());
        let (text, _) = written(&surface, Family::Triangle);
        let [cell] = cells(&text).try_into().map_err(|_| "one cell").unwrap();
        // The rings from outside in, each walked from corner A to B, C and back, corners first.
        let mut expected = Vec::new();
        let (mut inner, mut left) = (0, degree as i64);
        while left >= 0 {
            let corner = |k: usize| {
                let mut index = [inner; 3];
                index[k] += left as usize;
                index
            };
            if left == 0 {
                expected.push(corner(0));
            } else {
                expected.extend([0, 1, 2].map(corner));
                for side in 0..3 {
                    for step in 1..left as usize {
                        let mut index = corner(side);
                        index[side] -= step;
                        index[(side + 1) % 3] += step;
                        expected.push(index);
                    }
                }
            }
            (inner, left) = (inner + 1, left - 3);
        }
        assert_eq!((cell.kind, cell.degrees, cell.points.len()), (76, [degree; 2], count));
        let found: Vec<Point> = expected.iter().map(|index| net.point(index[0], index[1])).collect();
        assert_eq!(cell.points, found, "degree {degree}");
    }
}

#[test]
fn what_is_no_polynomial_is_a_fit_in_cells_within_what_is_stated() {
    let patch = TensorPatch::gt(Net::new(4, 4, wave(4, 4)).unwrap(), [0.3, 2.0, 3.5, 1.0]).unwrap();
    let (text, form) = written(&Surface::Tensor(patch.clone()), Family::Shaped(ShapedFamily::Gt));
    let (cells, deviation) = (cells(&text), form.deviation.unwrap());
    assert!(form.description.contains("Bézier cells of a B-spline fit of degree (5, 5)"), "{form:?}");
    let [(u0, u1), (v0, v1)] = patch.rectangle();
    let (_, counts) = form.description.split_once("(5, 5) in ").unwrap();
    let mut counts = counts.split([' ', 'x']).filter_map(|word| word.parse::<usize>().ok());
    let [rows, cols] = [counts.next().unwrap(), counts.next().unwrap()];
    assert_eq!(rows * cols, cells.len());
    for (k, cell) in cells.iter().enumerate() {
        for (s, t) in PARAMETERS.into_iter().flat_map(|u| PARAMETERS.map(|v| (u, v))) {
            let (a, b) = (((k / cols) as f64 + s) / rows as f64, ((k % cols) as f64 + t) / cols as f64);
            let point = patch.jet(u0 + (u1 - u0) * a, v0 + (v1 - v0) * b).point;
            assert!(cell.at(s, t).distance(point) <= deviation, "{k}");
        }
    }
}

#[test]
fn coordinates_beyond_what_readers_compute_with_are_refused() {
    let mut points = wave(2, 2);
    points[1].x = 1e200;
    let surface = Surface::Tensor(TensorPatch::bernstein(Net::new(2, 2, points).unwrap()).unwrap());
    let mesh = Mesh::default();
    let subject = Subject { name: "far", mesh: &mesh, colours: None, unit: None };
    let file = SurfaceFile::new(Format::VtuBezier, subject, (&surface, Family::Bernstein), 1e-6);
    assert!(file.err().unwrap().to_string().contains("scale"));
}
