use crate::{Domain, Jet, Patch, Point};

/// How many rows of vertices are evaluated at a time.
const ROWS: usize = 64;

/// A triangle mesh of a patch with what was known of the surface at each vertex.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mesh {
    /// Vertices.
    pub points: Vec<Point>,
    /// Unit normals; where the patch is singular, that of the triangles around the vertex.
    pub normals: Vec<Point>,
    /// Parameters (u, v) of the vertices.
    pub parameters: Vec<[f64; 2]>,
    /// Mean curvature, where it exists.
    pub mean_curvature: Vec<Option<f64>>,
    /// Gauss curvature, where it exists.
    pub gauss_curvature: Vec<Option<f64>>,
    /// Vertex indices, counter-clockwise seen against the normal.
    pub triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// The mesh of `patch` with `subdivisions` equal steps of each parameter: (N+1)² vertices and 2N² triangles over a
    /// rectangle, (N+1)(N+2)/2 vertices and N² triangles over a triangle.
    pub fn of(patch: &dyn Patch, subdivisions: usize) -> Self {
        let n = subdivisions.max(1);
        let step = |(start, end): (f64, f64), k: usize| {
            if k == n { end } else { start + (end - start) * (k as f64 / n as f64) }
        };
        match patch.domain() {
            Domain::Rectangle { u, v } => {
                let us: Vec<f64> = (0..=n).map(|k| step(u, k)).collect();
                let vs: Vec<f64> = (0..=n).map(|k| step(v, k)).collect();
                let parameters = us.iter().flat_map(|&u| vs.iter().map(move |&v| [u, v])).collect();
                let at = |a: usize, b: usize| (a * (n + 1) + b) as u32;
                let cells = (0..n).flat_map(|a| (0..n).map(move |b| (a, b)));
                let triangles = cells
                    .flat_map(|(a, b)| {
                        [
                            [at(a, b), at(a + 1, b), at(a + 1, b + 1)],
                            [at(a, b), at(a + 1, b + 1), at(a, b + 1)],
                        ]
                    })
                    .collect();
                // A jet is three times as large as what is kept of it.
                let jets = us.chunks(ROWS).flat_map(|us| patch.jets(us, &vs));
                Self::new(jets, parameters, triangles)
            }
            Domain::Triangle => {
                // Row a holds the n − a + 1 vertices with u = a/n.
                let start = |a: usize| a * (n + 1) - a * (a + 1) / 2 + a;
                let at = |a: usize, b: usize| (start(a) + b) as u32;
                let unit = (0.0, 1.0);
                let parameters: Vec<[f64; 2]> =
                    (0..=n).flat_map(|a| (0..=n - a).map(move |b| [step(unit, a), step(unit, b)])).collect();
                let mut triangles = Vec::with_capacity(n * n);
                for a in 0..n {
                    for b in 0..n - a {
                        triangles.push([at(a, b), at(a + 1, b), at(a, b + 1)]);
                        if b + 1 < n - a {
                            triangles.push([at(a + 1, b), at(a + 1, b + 1), at(a, b + 1)]);
                        }
                    }
                }
                let jets = parameters.clone().into_iter().map(|[u, v]| patch.jet(u, v));
                Self::new(jets, parameters, triangles)
            }
        }
    }

    fn new(jets: impl Iterator<Item = Jet>, parameters: Vec<[f64; 2]>, triangles: Vec<[u32; 3]>) -> Self {
        let count = parameters.len();
        let mut mesh = Self {
            points: Vec::with_capacity(count),
            normals: Vec::with_capacity(count),
            parameters,
            mean_curvature: Vec::with_capacity(count),
            gauss_curvature: Vec::with_capacity(count),
            triangles,
        };
        let mut singular = Vec::new();
        for jet in jets {
            let normal = jet.normal();
            if normal.is_none() {
                singular.push(mesh.points.len());
            }
            mesh.points.push(jet.point);
            mesh.normals.push(normal.unwrap_or(Point::new(0.0, 0.0, 1.0)));
            mesh.mean_curvature.push(jet.mean_curvature());
            mesh.gauss_curvature.push(jet.gauss_curvature());
        }
        mesh.mend_normals(&singular);
        mesh
    }

    /// Where the patch is singular, the normal is that of the triangles around the vertex, if they have one.
    fn mend_normals(&mut self, singular: &[usize]) {
        if singular.is_empty() {
            return;
        }
        let mut around = vec![Point::ZERO; self.points.len()];
        for &[a, b, c] in &self.triangles {
            let [p, q, r] = [a, b, c].map(|k| self.points[k as usize]);
            let normal = (q - p).cross(r - p);
            for k in [a, b, c] {
                around[k as usize] += normal;
            }
        }
        for &k in singular {
            if let Some(normal) = around[k].unit() {
                self.normals[k] = normal;
            }
        }
    }

    /// The sum of the areas of the triangles: a lower accuracy check of the patch's area.
    pub fn area(&self) -> f64 {
        let area = |&[a, b, c]: &[u32; 3]| {
            let [p, q, r] = [a, b, c].map(|k| self.points[k as usize]);
            0.5 * (q - p).cross(r - p).norm()
        };
        self.triangles.iter().map(area).sum()
    }
}
