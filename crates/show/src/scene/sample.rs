use surfaces::{Complex, Domain, Jet, Patch, Point};

use super::Field;
use plateau::Surface;

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

/// Most vertices of a surface of several patches: a picture of more would show nothing but borders.
const MOST: usize = 60_000;

/// A surface on a grid of its domain, or on as many equal grids as it has patches.
pub(crate) struct Sample {
    /// The domain; of a surface of several patches that of each.
    pub(crate) domain: Domain,
    /// How many patches have a grid of their own; 1 for surfaces over one domain.
    pub(crate) charts: usize,
    /// Subdivisions in u and v; the same for triangles. Multiples of 4.
    pub(crate) steps: [usize; 2],
    /// Points, patch by patch. Over a rectangle all v of the first u first; over a triangle row a holds n − a + 1 points with u = a/n.
    pub(crate) points: Vec<Point>,
    fields: [Vec<Option<f64>>; 4],
}

impl Sample {
    /// Samples a surface at about `budget` vertices, at most 49² of a single patch; none of one of very many patches.
    pub(super) fn of(surface: &Surface, budget: usize) -> Option<Self> {
        match surface {
            Surface::Tensor(patch) => Some(Self::of_patch(patch, steps([1, 1], budget))),
            Surface::Triangle(patch) => {
                Some(Self::of_patch(patch, steps([1, 1], (2 * budget).min(TRIANGLE))))
            }
            Surface::Pieces(pieces) => Some(Self::of_patch(pieces, steps(pieces.shape(), budget))),
            Surface::Complex(complex) => Self::of_complex(complex, budget),
        }
    }

    /// One grid after the other, of the patches as they are numbered.
    fn of_complex(complex: &Complex, budget: usize) -> Option<Self> {
        let count = complex.faces().len();
        // Of the subdivisions of a single patch about as many in all.
        let share = libm::sqrt(budget.min((FINE + 1) * (FINE + 1)) as f64 / count.max(1) as f64);
        let side = (share as usize / STEP * STEP).max(STEP);
        if count * (side + 1) * (side + 1) > MOST {
            return None;
        }
        let patch = |face: usize| Some(Self::of_patch(&complex.patch(face).ok()?, [side; 2]));
        let mut whole = patch(0)?;
        for face in 1..count {
            let next = patch(face)?;
            whole.points.extend(next.points);
            for (field, more) in whole.fields.iter_mut().zip(next.fields) {
                field.extend(more);
            }
        }
        whole.charts = count;
        Some(whole)
    }

    fn of_patch(patch: &dyn Patch, steps: [usize; 2]) -> Self {
        let domain = patch.domain();
        let jets: Vec<Jet> = match domain {
            Domain::Rectangle { u, v } => patch.jets(&even(u, steps[0]), &even(v, steps[1])),
            Domain::Triangle => {
                let at = even((0.0, 1.0), steps[0]);
                let rows = (0..=steps[0]).flat_map(|a| (0..=steps[0] - a).map(move |b| (a, b)));
                rows.map(|(a, b)| patch.jet(at[a], at[b])).collect()
            }
        };
        let fields = Field::ALL.map(|field| jets.iter().map(|jet| field.of(jet)).collect());
        Self { domain, charts: 1, steps, points: jets.iter().map(|jet| jet.point).collect(), fields }
    }

    /// The values of a field at the points; none where it does not exist.
    pub(crate) fn values(&self, field: Field) -> &[Option<f64>] {
        &self.fields[field as usize]
    }

    /// The index of the point (a, b) of the first grid.
    pub(crate) fn at(&self, a: usize, b: usize) -> usize {
        match self.domain {
            Domain::Rectangle { .. } => a * (self.steps[1] + 1) + b,
            // Row a starts after rows of n + 1, n, … points.
            Domain::Triangle => a * (self.steps[0] + 1) - a * a.saturating_sub(1) / 2 + b,
        }
    }

    /// The points at the corners of all faces of `stride` cells a side: rectangles of a rectangle, triangles of a triangle.
    /// `stride` divides the steps.
    pub(crate) fn faces(&self, stride: usize) -> Vec<Vec<usize>> {
        self.on_all(&self.cells(stride))
    }

    /// The closed polygons of the boundaries of all patches.
    pub(crate) fn outlines(&self) -> Vec<Vec<usize>> {
        self.on_all(&[self.outline()])
    }

    /// The points of every grid at the same places of each.
    fn on_all(&self, places: &[Vec<[usize; 2]>]) -> Vec<Vec<usize>> {
        let size = self.points.len() / self.charts;
        let of_one = |chart: usize| {
            places.iter().map(move |list| list.iter().map(|&[a, b]| chart * size + self.at(a, b)).collect())
        };
        (0..self.charts).flat_map(of_one).collect()
    }

    /// The corners in one grid of the faces of `stride` cells a side.
    pub(crate) fn cells(&self, stride: usize) -> Vec<Vec<[usize; 2]>> {
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

    /// The closed polygon of the boundary of one grid.
    fn outline(&self) -> Vec<[usize; 2]> {
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
                let value = |a, b| values[self.at(a, b)];
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
                let value = |a, b| values[self.at(a, b)];
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
    use surfaces::{TriangleNet, TrianglePatch};

    fn triangle() -> Sample {
        let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.0]].map(Point::from);
        let net = TriangleNet::new(1, corners.into()).unwrap();
        Sample::of(&Surface::Triangle(TrianglePatch::new(net).unwrap()), 400).unwrap()
    }

    #[test]
    fn triangular_grids_are_numbered_without_gaps() {
        let sample = triangle();
        let n = sample.steps[0];
        let numbers: Vec<usize> =
            (0..=n).flat_map(|a| (0..=n - a).map(move |b| (a, b))).map(|(a, b)| sample.at(a, b)).collect();
        assert_eq!(numbers, (0..sample.points.len()).collect::<Vec<_>>());
        assert_eq!((sample.faces(1).len(), sample.outlines().len()), (n * n, 1));
        assert_eq!(sample.faces(4).len(), n * n / 16);
        assert_eq!(sample.outline().len(), 3 * n);
    }

    #[test]
    fn interpolation_reproduces_linear_functions() {
        let sample = triangle();
        let n = sample.steps[0];
        let linear = |s: f64, t: f64| 3.0 + 2.0 * s - 5.0 * t;
        let grid = (0..=n).flat_map(|a| (0..=n - a).map(move |b| (a as f64 / n as f64, b as f64 / n as f64)));
        let values: Vec<Option<f64>> = grid.map(|(s, t)| Some(linear(s, t))).collect();
        for (s, t) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (0.31, 0.27), (0.05, 0.94), (0.5, 0.5)] {
            let found = sample.interpolate(&values, s, t).unwrap();
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
