//! What is assembled, as the engine takes it.

use plateau::{CurveGraph, CuttingError, FaceSide, GraphCurve, Loop};
use surfaces::{BoundaryCurve, CurveError, Vertex};
use thiserror::Error;

use super::{Assembly, Form, Walk};

/// Loops or a graph of curves, ready to be filled.
#[derive(Debug, Clone, PartialEq)]
pub enum Frame {
    /// One loop or two.
    Loops(Vec<Loop>),
    /// A graph with its faces.
    Graph(CurveGraph),
}

/// Why an assembly cannot be filled.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum FrameError {
    /// A side is no curve.
    #[error("{side}, line {line}: {error}")]
    Curve {
        /// Its name.
        side: String,
        /// Its line in the file.
        line: usize,
        /// Why.
        error: CurveError,
    },
    /// The curves hang together in a way that is not spanned.
    #[error(transparent)]
    Cutting(#[from] CuttingError),
}

impl Assembly {
    /// The boundary with its sampled sides to be met within `tolerance` (a length).
    ///
    /// # Errors
    /// [`FrameError`].
    pub fn frame(&self, tolerance: f64) -> Result<Frame, FrameError> {
        match &self.form {
            Form::Loops(loops) => {
                let one = |walks: &Vec<Walk>| -> Result<Loop, FrameError> {
                    let curves = walks.iter().map(|walk| {
                        let curve = self.curve(walk.side, tolerance)?;
                        Ok(if walk.forward { curve } else { curve.reversed() })
                    });
                    Ok(Loop::new(curves.collect::<Result<_, FrameError>>()?, None)?)
                };
                Ok(Frame::Loops(loops.iter().map(one).collect::<Result<_, _>>()?))
            }
            Form::Faces(faces) => self.graph(faces, tolerance).map(Frame::Graph),
        }
    }

    fn graph(&self, faces: &[Vec<Walk>], tolerance: f64) -> Result<CurveGraph, FrameError> {
        let vertices = self
            .vertices
            .iter()
            .enumerate()
            .map(|(k, &point)| (self.vertex_name(k), Vertex::Fixed(point)))
            .collect();
        let ends_of = |side: usize| self.sides[side].ends.unwrap_or_default();
        let curves = (0..self.sides.len())
            .map(|k| Ok(GraphCurve { ends: ends_of(k), curve: self.curve(k, tolerance)? }))
            .collect::<Result<Vec<_>, FrameError>>()?;
        let side = |walk: &Walk| {
            let [from, to] = ends_of(walk.side);
            FaceSide { ends: if walk.forward { [from, to] } else { [to, from] }, curve: Some(walk.side) }
        };
        let faces = faces.iter().map(|walks| walks.iter().map(side).collect()).collect();
        Ok(CurveGraph::with_sides(vertices, curves, faces, None)?)
    }

    fn curve(&self, side: usize, tolerance: f64) -> Result<BoundaryCurve, FrameError> {
        let side = &self.sides[side];
        side.curve(tolerance, self.corner_angle).map_err(|error| FrameError::Curve {
            side: side.name.clone(),
            line: side.line,
            error,
        })
    }

    /// What a vertex is called: `p1`, `p2`, …
    pub fn vertex_name(&self, vertex: usize) -> String {
        format!("p{}", vertex + 1)
    }
}
