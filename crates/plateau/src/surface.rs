//! Patches of any kind.

use surfaces::{Complex, Mesh, Patch, Pieces, Point, SurfaceError, TensorPatch, TrianglePatch};

use crate::{MethodError, memory};

/// A patch of any kind.
#[derive(Debug, Clone)]
pub enum Surface {
    /// On a rectangular net.
    Tensor(TensorPatch),
    /// On a triangular net.
    Triangle(TrianglePatch),
    /// On several rectangular nets that meet, or one.
    Pieces(Pieces),
    /// On faces that share edges.
    Complex(Complex),
}

impl Surface {
    /// The patch as such; none of a complex, which has one for each face.
    pub fn patch(&self) -> Option<&dyn Patch> {
        match self {
            Self::Tensor(patch) => Some(patch),
            Self::Triangle(patch) => Some(patch),
            Self::Pieces(pieces) => Some(pieces),
            Self::Complex(_) => None,
        }
    }

    /// What it lies on, in words.
    pub(crate) fn kind(&self) -> &'static str {
        match self {
            Self::Tensor(_) => "a rectangular net",
            Self::Triangle(_) => "a triangular net",
            Self::Pieces(_) => "a surface in pieces",
            Self::Complex(_) => "a surface of faces that share edges",
        }
    }

    /// Share of the size of the boundary that rounding takes of the points of the surface: where free control points lie far
    /// beyond the boundary, the surface is what their differences leave.
    pub fn cancellation(&self) -> f64 {
        let share = |fixed: &[bool], points: &[Point]| {
            let border = || fixed.iter().zip(points).filter(|(fixed, _)| **fixed).map(|(_, &p)| p);
            let Some(origin) = border().next() else { return 0.0 };
            let size = border().map(|p| p.distance(origin)).fold(0.0, f64::max);
            let reach = points.iter().map(|p| p.distance(origin)).fold(0.0, f64::max);
            if size > 0.0 { f64::EPSILON * reach / size } else { 0.0 }
        };
        match self {
            Self::Tensor(patch) => {
                let (rows, cols) = (patch.net().rows(), patch.net().cols());
                // Constructed nets have all points fixed.
                let on_border = |k: usize| {
                    let (i, j) = (k / cols, k % cols);
                    i == 0 || j == 0 || i + 1 == rows || j + 1 == cols
                };
                share(&(0..rows * cols).map(on_border).collect::<Vec<_>>(), patch.net().points())
            }
            Self::Triangle(patch) => {
                let on_border = |index: [usize; 3]| index.contains(&0);
                share(&patch.net().indices().map(on_border).collect::<Vec<_>>(), patch.net().points())
            }
            Self::Pieces(_) => 0.0,
            Self::Complex(complex) => share(complex.fixed(), complex.points()),
        }
    }

    /// The degrees in u and v; twice the same of a triangular patch, 0 of several pieces.
    pub(crate) fn degrees(&self) -> (usize, usize) {
        match self {
            Self::Tensor(patch) => patch.net().degrees(),
            Self::Triangle(patch) => (patch.net().degree(), patch.net().degree()),
            Self::Pieces(_) => (0, 0),
            Self::Complex(complex) => (complex.degree(), complex.degree()),
        }
    }

    /// The surface moved.
    pub(crate) fn moved(self, by: Point) -> Result<Self, MethodError> {
        if by == Point::ZERO {
            return Ok(self);
        }
        let all =
            |points: &[Point]| points.iter().flat_map(|&p| <[f64; 3]>::from(p + by)).collect::<Vec<_>>();
        let tensor = |patch: TensorPatch| {
            let net = patch.net().with_coordinates(&all(patch.net().points()))?;
            patch.with_net(net)
        };
        Ok(match self {
            Self::Tensor(patch) => Self::Tensor(tensor(patch)?),
            Self::Triangle(patch) => {
                let net = patch.net();
                Self::Triangle(TrianglePatch::new(net.with_coordinates(&all(net.points()))?)?)
            }
            Self::Pieces(pieces) => {
                let [u, v] = pieces.cuts().map(<[f64]>::to_vec);
                let patches =
                    pieces.patches().iter().cloned().map(tensor).collect::<Result<_, SurfaceError>>()?;
                Self::Pieces(Pieces::from_patches(u, v, patches)?)
            }
            Self::Complex(complex) => Self::Complex(complex.moved(by)?),
        })
    }

    /// Its triangle mesh, of `subdivisions` steps of each parameter; of a complex, with about as many vertices in all.
    ///
    /// # Errors
    /// [`MethodError::OutOfMemory`] if there is no room for it, [`MethodError::Complex`] for a complex of more faces than a mesh holds.
    pub fn mesh(&self, subdivisions: usize) -> Result<Mesh, MethodError> {
        memory::holds(memory::of_mesh(subdivisions))?;
        match self {
            Self::Tensor(patch) => Ok(Mesh::of(patch, subdivisions)),
            Self::Triangle(patch) => Ok(Mesh::of(patch, subdivisions)),
            Self::Pieces(pieces) => Ok(Mesh::of(pieces, subdivisions)),
            Self::Complex(complex) => Ok(complex.mesh(per_face(complex, subdivisions))?.mesh),
        }
    }
}

/// Subdivisions of the sides of the faces of a complex that make about as many vertices as one patch of so many.
pub(crate) fn per_face(complex: &Complex, subdivisions: usize) -> usize {
    const FEWEST: usize = 4;
    const MOST: usize = 100;
    let faces = complex.faces().len() as f64;
    ((subdivisions as f64 / faces.sqrt()).ceil() as usize).clamp(FEWEST, MOST)
}
