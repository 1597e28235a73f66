use surfaces::{Domain, Jet, Patch};

/// Subdivisions of a side where the budget allows.
const FINE: usize = 48;

/// Vertices of the square grid that the grid of a triangle is half of: 40 subdivisions of a side.
const TRIANGLE: usize = 41 * 41;

/// Fewest subdivisions of a side.
const COARSE: usize = 12;

/// Subdivisions wanted of each of several pieces: about as many of a turn of a helicoid.
const PER_PIECE: usize = 24;

/// Most subdivisions of a side.
const LONGEST: usize = 216;

/// Most faces wanted of one surface, and the fewest subdivisions across a long one for their sake: a picture of it alone
/// draws them all.
const FACES: usize = 3456;
const ACROSS: usize = 16;

/// All subdivisions are multiples of this, so that coarser faces fit.
const STEP: usize = 4;

/// A grid of a domain, whose points are some of those of a sample.
pub(crate) struct Chart {
    /// The domain.
    pub(crate) domain: Domain,
    /// Subdivisions in u and v; the same for triangles. Multiples of 4.
    pub(crate) steps: [usize; 2],
    /// The points of the grid among those of the sample; none if they are all of them, in the order of the grid.
    places: Option<Vec<u32>>,
    /// Whether its normal x_u × x_v points to the other side than those of its neighbours.
    pub(crate) flipped: bool,
}

impl Chart {
    /// The whole of a surface at about `budget` vertices, at most 49² of a single patch: the grid and the jets at its points. Over a
    /// rectangle all v of the first u come first; over a triangle row a holds n − a + 1 points with u = a/n.
    pub(super) fn of(patch: &dyn Patch, pieces: Option<[usize; 2]>, budget: usize) -> (Self, Vec<Jet>) {
        let domain = patch.domain();
        let (steps, jets) = match domain {
            Domain::Rectangle { u, v } => {
                let steps = steps(pieces.unwrap_or([1, 1]), budget);
                (steps, patch.jets(&even(u, steps[0]), &even(v, steps[1])))
            }
            Domain::Triangle => {
                let steps = steps([1, 1], (2 * budget).min(TRIANGLE));
                let at = even((0.0, 1.0), steps[0]);
                let rows = (0..=steps[0]).flat_map(|a| (0..=steps[0] - a).map(move |b| (a, b)));
                (steps, rows.map(|(a, b)| patch.jet(at[a], at[b])).collect())
            }
        };
        (Self { domain, steps, places: None, flipped: false }, jets)
    }

    /// A face of a complex with its (steps + 1)² vertices among those of a mesh.
    pub(super) fn of_face(steps: usize, places: Vec<u32>, flipped: bool) -> Self {
        let domain = Domain::Rectangle { u: (0.0, 1.0), v: (0.0, 1.0) };
        Self { domain, steps: [steps; 2], places: Some(places), flipped }
    }

    /// The points of the grid among those of the sample; none if they are all of them, in the order of the grid.
    pub(crate) fn places(&self) -> Option<&[u32]> {
        self.places.as_deref()
    }

    /// The point (a, b) of the grid among those of the sample.
    pub(crate) fn at(&self, [a, b]: [usize; 2]) -> usize {
        let place = self.place(a, b);
        self.places.as_ref().map_or(place, |places| places[place] as usize)
    }

    /// The index of the point (a, b) in the grid.
    fn place(&self, a: usize, b: usize) -> usize {
        match self.domain {
            Domain::Rectangle { .. } => a * (self.steps[1] + 1) + b,
            // Row a starts after rows of n + 1, n, … points.
            Domain::Triangle => a * (self.steps[0] + 1) - a * a.saturating_sub(1) / 2 + b,
        }
    }

    /// The corners in the grid of the faces of `stride` cells a side: rectangles of a rectangle, triangles of a triangle.
    /// `stride` divides the steps.
    pub(crate) fn faces(&self, stride: usize) -> Vec<Vec<[usize; 2]>> {
        let [nu, nv] = self.steps;
        let s = stride;
        let mut faces = Vec::new();
        match self.domain {
            Domain::Rectangle { .. } => {
                for a in (0..nu).step_by(s) {
                    for b in (0..nv).step_by(s) {
                        faces.push(vec![[a, b], [a + s, b], [a + s, b + s], [a, b + s]]);
                    }
                }
            }
            Domain::Triangle => {
                for a in (0..nu).step_by(s) {
                    for b in (0..nu - a).step_by(s) {
                        faces.push(vec![[a, b], [a + s, b], [a, b + s]]);
                        if a + b + 2 * s <= nu {
                            faces.push(vec![[a + s, b], [a + s, b + s], [a, b + s]]);
                        }
                    }
                }
            }
        }
        faces
    }

    /// The closed polygon of the boundary, as points of the grid.
    pub(crate) fn outline(&self) -> Vec<[usize; 2]> {
        let [nu, nv] = self.steps;
        match self.domain {
            Domain::Rectangle { .. } => {
                let (there, up) = ((0..nu).map(|a| [a, 0]), (0..nv).map(move |b| [nu, b]));
                let (back, down) = ((1..=nu).rev().map(move |a| [a, nv]), (1..=nv).rev().map(|b| [0, b]));
                there.chain(up).chain(back).chain(down).collect()
            }
            Domain::Triangle => {
                let (there, slope) = ((0..nu).map(|a| [a, 0]), (1..=nu).rev().map(move |a| [a, nu - a]));
                there.chain(slope).chain((1..=nu).rev().map(|b| [0, b])).collect()
            }
        }
    }

    /// The bilinear interpolant (linear over triangles) of `values` at (s, t) ∈ [0, 1]² of the domain; over a triangle,
    /// points beyond the slanted side are drawn back to it. None where a neighbour has no value.
    pub(crate) fn interpolate(&self, values: &[Option<f64>], s: f64, t: f64) -> Option<f64> {
        let [nu, nv] = self.steps.map(|n| n as f64);
        match self.domain {
            Domain::Rectangle { .. } => {
                let (x, y) = (s * nu, t * nv);
                let a = (x as usize).min(self.steps[0] - 1);
                let b = (y as usize).min(self.steps[1] - 1);
                let (p, q) = (x - a as f64, y - b as f64);
                let value = |a, b| values[self.at([a, b])];
                let low = value(a, b)? * (1.0 - q) + value(a, b + 1)? * q;
                let high = value(a + 1, b)? * (1.0 - q) + value(a + 1, b + 1)? * q;
                Some(low * (1.0 - p) + high * p)
            }
            Domain::Triangle => {
                let beyond = (s + t).max(1.0);
                let (x, y) = (s / beyond * nu, t / beyond * nu);
                let n = self.steps[0];
                let a = (x as usize).min(n - 1);
                let b = (y as usize).min(n - 1 - a);
                let (p, q) = (x - a as f64, y - b as f64);
                let value = |a, b| values[self.at([a, b])];
                if p + q <= 1.0 || a + b + 2 > n {
                    Some(value(a, b)? * (1.0 - p - q) + value(a + 1, b)? * p + value(a, b + 1)? * q)
                } else {
                    let corner = value(a + 1, b + 1)? * (p + q - 1.0);
                    Some(corner + value(a + 1, b)? * (1.0 - q) + value(a, b + 1)? * (1.0 - p))
                }
            }
        }
    }
}

/// Subdivisions of both sides of a surface of so many pieces, within a budget of vertices where the coarsest grid allows.
fn steps(pieces: [usize; 2], budget: usize) -> [usize; 2] {
    let mut wanted = pieces.map(|count| (count * PER_PIECE).clamp(FINE, LONGEST));
    let short = usize::from(wanted[1] < wanted[0]);
    wanted[short] = wanted[short].min((FACES / wanted[1 - short]).max(ACROSS));
    let wanted = wanted.map(|n| n as f64);
    let vertices = (wanted[0] + 1.0) * (wanted[1] + 1.0);
    let shrink = (budget as f64 / vertices).sqrt().min(1.0);
    wanted.map(|n| ((n * shrink) as usize / STEP * STEP).max(COARSE))
}

fn even((start, end): (f64, f64), steps: usize) -> Vec<f64> {
    let at = |k: usize| if k == steps { end } else { start + (end - start) * (k as f64 / steps as f64) };
    (0..=steps).map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use surfaces::{Point, TriangleNet, TrianglePatch};

    fn triangle() -> (Chart, usize) {
        let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.0]].map(Point::from);
        let patch = TrianglePatch::new(TriangleNet::new(1, corners.into()).unwrap()).unwrap();
        let (chart, jets) = Chart::of(&patch, None, 400);
        (chart, jets.len())
    }

    #[test]
    fn triangular_grids_are_numbered_without_gaps() {
        let (chart, points) = triangle();
        let n = chart.steps[0];
        let numbers: Vec<usize> =
            (0..=n).flat_map(|a| (0..=n - a).map(move |b| [a, b])).map(|at| chart.at(at)).collect();
        assert_eq!(numbers, (0..points).collect::<Vec<_>>());
        assert_eq!(chart.faces(1).len(), n * n);
        assert_eq!(chart.faces(4).len(), n * n / 16);
        assert_eq!(chart.outline().len(), 3 * n);
    }

    #[test]
    fn interpolation_reproduces_linear_functions() {
        let (chart, _) = triangle();
        let n = chart.steps[0];
        let linear = |s: f64, t: f64| 3.0 + 2.0 * s - 5.0 * t;
        let grid = (0..=n).flat_map(|a| (0..=n - a).map(move |b| (a as f64 / n as f64, b as f64 / n as f64)));
        let values: Vec<Option<f64>> = grid.map(|(s, t)| Some(linear(s, t))).collect();
        for (s, t) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (0.31, 0.27), (0.05, 0.94), (0.5, 0.5)] {
            let found = chart.interpolate(&values, s, t).unwrap();
            assert!((found - linear(s, t)).abs() < 1e-12, "{s} {t} {found}");
        }
    }

    #[test]
    fn long_surfaces_get_more_steps_along_their_length() {
        assert_eq!(steps([1, 1], 10_000), [48, 48]);
        let [u, v] = steps([1, 20], 14_000);
        assert!(v >= 200 && u >= ACROSS && u * v <= FACES, "{u} {v}");
        let [u, v] = steps([1, 1], 583);
        assert!((u + 1) * (v + 1) <= 583 && u == v, "{u} {v}");
    }
}
