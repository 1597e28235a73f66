//! Surfaces over loops and graphs of curves.

mod accuracy;
mod cone;
mod degree;
mod disc;
mod fill;
mod layers;
mod options;
mod pinch;
mod solution;
mod warned;

use energy::Functional;
use surfaces::{Complex, ComplexMesh, Deviation, Point};

pub use fill::fill;
pub use options::{Fill, FillEnergy};

use crate::{AreaExtremal, Done, Figures, FilmFigures, Interior, LowerBound, Seams, Solved, Warning, Way};

/// A surface of quadrilateral patches over loops or a graph of curves, with its figures.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Film {
    complex: Complex,
    /// One for each vertex of the complex.
    names: Vec<String>,
    /// How the boundary was cut.
    pub way: Way,
    /// Layers of smaller patches around corners, one in the other.
    pub layers: usize,
    /// How far its rim is from the curves that were given, and what that can mean for the area.
    pub rim: Deviation,
    /// The largest distance of ends of curves that were made one point.
    pub welded: f64,
    /// How the least area was reached, if it was asked for.
    pub extremal: Option<AreaExtremal>,
    /// Energies, area and curvature: sums over the patches.
    pub figures: Figures,
    /// How the patches meet.
    pub seams: Seams,
    /// For two loops and the least area: the area of the two surfaces that span each by itself.
    pub one_by_one: Option<f64>,
    /// What the area is above the least area of the boundary, where it was estimated.
    pub estimate: Option<f64>,
    /// An area that no surface, or no graph, with this rim is below, if it was asked for and proved.
    pub bound: Option<LowerBound>,
    /// Other ways of cutting that were tried, with what came of them; none unless the first left something to be desired.
    pub tried: Vec<Tried>,
    /// A watertight mesh of all patches.
    pub mesh: ComplexMesh,
    /// What a reader must know.
    pub warnings: Vec<Warning>,
}

/// A way of cutting that was tried and not kept.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tried {
    /// The way.
    pub way: Way,
    /// The area it led to, if it was minimised and the start was not singular.
    pub area: Option<f64>,
    /// The least over the mean of `|x_u × x_v|`.
    pub jacobian_ratio: f64,
    /// Whether some face folds.
    pub folds: bool,
}

/// A patch of a film.
#[derive(Debug, Clone, PartialEq)]
pub struct FilmFace<'a> {
    /// The names of its corners v00, v10, v11, v01.
    pub vertices: [&'a str; 4],
    /// Its control points `P_ij`, i with u.
    pub net: Vec<Vec<Point>>,
}

/// Share of the size below which ends that differ are not spoken of.
const ROUNDING: f64 = 1e-14;

impl Film {
    /// The patches.
    #[must_use]
    pub fn complex(&self) -> &Complex {
        &self.complex
    }

    /// The patches by themselves.
    #[must_use]
    pub fn into_complex(self) -> Complex {
        self.complex
    }

    /// The names of the vertices of the complex, see [`CutBoundary::names`](crate::CutBoundary::names).
    #[must_use]
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The film as the outcome of a method.
    #[must_use]
    pub fn into_done(self) -> Done {
        let Self {
            complex,
            names,
            way,
            rim,
            welded,
            extremal,
            figures,
            seams,
            one_by_one,
            estimate,
            bound,
            mesh,
            warnings,
            ..
        } = self;
        let size = complex.size();
        let mut all: Vec<Warning> = Vec::new();
        // What is no more than the rounding of points on arcs and splines nobody wrote.
        if welded > ROUNDING * size {
            all.push(Warning::Welded { distance: welded, share: welded / size });
        }
        all.extend(warnings);
        let interior = match extremal {
            Some(found) => Interior::LeastArea(Box::new(found)),
            None => Interior::Extremal(Functional::Dirichlet, None),
        };
        let film = FilmFigures::new(&complex, names, way, rim, (seams, one_by_one));
        Done {
            solved: Solved::complex(complex, interior),
            mesh: mesh.mesh,
            figures,
            boundary: None,
            closed_form: None,
            film: Some(film),
            estimate,
            bound,
            warnings: all,
        }
    }

    /// The patches with the names of their corners.
    pub fn faces(&self) -> impl Iterator<Item = FilmFace<'_>> {
        let count = self.complex.degree() + 1;
        self.complex.faces().iter().map(move |face| {
            let points: Vec<Point> = face.nodes().iter().map(|&k| self.complex.points()[k]).collect();
            FilmFace {
                vertices: face.vertices().map(|vertex| self.names[vertex].as_str()),
                net: points.chunks_exact(count).map(<[Point]>::to_vec).collect(),
            }
        })
    }

    /// The names of the ends of an edge of the complex.
    pub fn edge_name(&self, edge: usize) -> [&str; 2] {
        self.complex.edges()[edge].ends().map(|vertex| self.names[vertex].as_str())
    }
}
