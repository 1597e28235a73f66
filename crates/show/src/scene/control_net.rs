use surfaces::{Net, Point};

use plateau::Surface;

/// Most control points that are drawn; a denser net would hide its surface.
const MOST: usize = 1000;

/// Control points and the lines between neighbours.
#[derive(Default)]
pub(crate) struct ControlNet {
    /// The points; empty if there are too many to be seen.
    pub(crate) points: Vec<Point>,
    /// Whether a point lies on the boundary of the net.
    pub(crate) on_boundary: Vec<bool>,
    /// Pairs of neighbours.
    pub(crate) edges: Vec<[usize; 2]>,
    /// The highest degree of its patches.
    pub(crate) degree: usize,
}

impl ControlNet {
    /// The net of a surface.
    pub(super) fn of(surface: &Surface) -> Self {
        let mut net = Self::default();
        match surface {
            Surface::Tensor(patch) => net.add(patch.net()),
            Surface::Pieces(pieces) => {
                let count: usize = pieces.patches().iter().map(|p| p.net().points().len()).sum();
                if count <= MOST {
                    pieces.patches().iter().for_each(|patch| net.add(patch.net()));
                }
            }
            // Its patches would hide one another's nets: the graph of its vertices is what there is to see.
            Surface::Complex(complex) => {
                net.degree = 1;
                net.points = complex.points()[..complex.vertices()].to_vec();
                net.on_boundary = vec![false; complex.vertices()];
                for edge in complex.edges().iter().filter(|edge| edge.uses().len() < 2) {
                    edge.ends().into_iter().for_each(|vertex| net.on_boundary[vertex] = true);
                }
                net.edges = Vec::new();
            }
            Surface::Triangle(patch) => {
                let triangle = patch.net();
                let n = triangle.degree();
                net.degree = n;
                net.points = triangle.points().to_vec();
                net.on_boundary = triangle.indices().map(|index| index.contains(&0)).collect();
                for a in 0..n {
                    for b in 0..n - a {
                        // The small triangle of P_{a+1,b,c}, P_{a,b+1,c}, P_{a,b,c+1}, a + b + c = n − 1.
                        let corners = [(a + 1, b), (a, b + 1), (a, b)];
                        let [p, q, r] = corners.map(|(i, j)| triangle.position(i, j));
                        net.edges.extend([[p, q], [q, r], [r, p]]);
                    }
                }
            }
        }
        if net.points.len() > MOST || net.points.iter().any(|p| !p.is_finite()) {
            return Self::default();
        }
        net
    }

    fn add(&mut self, net: &Net) {
        let first = self.points.len();
        let (rows, cols) = (net.rows(), net.cols());
        self.degree = self.degree.max(rows.max(cols) - 1);
        self.points.extend_from_slice(net.points());
        for i in 0..rows {
            for j in 0..cols {
                let here = first + i * cols + j;
                self.on_boundary.push(i == 0 || j == 0 || i + 1 == rows || j + 1 == cols);
                if i + 1 < rows {
                    self.edges.push([here, here + cols]);
                }
                if j + 1 < cols {
                    self.edges.push([here, here + 1]);
                }
            }
        }
    }
}
