use crate::{Domain, Jet, Patch, Point};

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
                Self::new(&patch.jets(&us, &vs), parameters, triangles)
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
                let jets: Vec<Jet> = parameters.iter().map(|&[u, v]| patch.jet(u, v)).collect();
                Self::new(&jets, parameters, triangles)
            }
        }
    }

    fn new(jets: &[Jet], parameters: Vec<[f64; 2]>, triangles: Vec<[u32; 3]>) -> Self {
        let points: Vec<Point> = jets.iter().map(|jet| jet.point).collect();
        let mut around = vec![Point::ZERO; points.len()];
        for &[a, b, c] in &triangles {
            let [p, q, r] = [a, b, c].map(|k| points[k as usize]);
            let normal = (q - p).cross(r - p);
            for k in [a, b, c] {
                around[k as usize] += normal;
            }
        }
        let normals = jets
            .iter()
            .zip(&around)
            .map(|(jet, around)| jet.normal().or(around.unit()).unwrap_or(Point::new(0.0, 0.0, 1.0)))
            .collect();
        Self {
            normals,
            parameters,
            mean_curvature: jets.iter().map(Jet::mean_curvature).collect(),
            gauss_curvature: jets.iter().map(Jet::gauss_curvature).collect(),
            points,
            triangles,
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
