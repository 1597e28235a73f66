//! Curves, filled.

use std::collections::HashMap;

use exchange::{AssemblyOptions, CurveFile, Kind};
use experiment::{Filling, ImportOptions};
use numpy::PyReadonlyArray2;
use plateau::{CurveGraph, Fill, FillEnergy, Film, GraphCurve, MethodResult, Progress, Way};
use pyo3::prelude::*;
use surfaces::{BoundaryCurve, Vertex};

use crate::arrays::points;
use crate::curves::Given;
use crate::errors::{BoundaryError, of_method};
use crate::spelling::spelled;
use crate::surface::Surface;
use crate::watch::watched;

/// How a boundary is filled: the fields of `plateau_patches.filling.Options`.
#[derive(FromPyObject)]
pub(crate) struct Options {
    name: String,
    degree: Option<usize>,
    energy: String,
    tolerance: f64,
    rim_tolerance: Option<f64>,
    weld: Option<f64>,
    corner_angle: Option<f64>,
    bound: bool,
    layers: usize,
    accuracy: Option<f64>,
    way: Option<String>,
    mesh: usize,
}

/// The ways of cutting by name.
const WAYS: [(&str, Way); 5] = [
    ("grid", Way::Grid),
    ("midpoint", Way::Midpoint),
    ("ring", Way::Ring),
    ("turned-ring", Way::TurnedRing),
    ("parts", Way::Parts),
];

impl Options {
    fn energy(&self) -> FillEnergy {
        if self.energy == "dirichlet" { FillEnergy::Dirichlet } else { FillEnergy::Area }
    }

    /// How curves are taken.
    fn curves(&self) -> ImportOptions {
        ImportOptions {
            tolerance: self.rim_tolerance,
            assembly: AssemblyOptions {
                weld: self.weld,
                corner_angle: self.corner_angle.unwrap_or(AssemblyOptions::CORNER_ANGLE),
            },
            ..ImportOptions::default()
        }
    }

    fn fill(&self) -> PyResult<Fill> {
        let mut fill = Fill::default()
            .with_energy(self.energy())
            .with_tolerance(self.tolerance)
            .with_layers(self.layers)
            .with_accuracy(self.accuracy)
            .with_bound(self.bound)
            .with_mesh(self.mesh);
        if let Some(degree) = self.degree {
            fill = fill.with_degree(degree);
        }
        if let Some(name) = &self.way {
            let way = WAYS.iter().find(|(known, _)| known == name);
            let known = || WAYS.map(|(name, _)| name).join(", ");
            let (_, way) = way.ok_or_else(|| {
                BoundaryError::new_err(format!("there is no way {name:?}; give one of {}", known()))
            })?;
            fill = fill.with_way(*way);
        }
        Ok(fill)
    }

    /// The surface that `span` finds, and what it says.
    fn surface<S: Send + 'static>(
        self,
        py: Python<'_>,
        told: Option<&Py<PyAny>>,
        span: impl FnOnce(&Self, &Fill, &dyn Progress) -> PyResult<(Film, S)> + Send + 'static,
    ) -> PyResult<(Surface, S)> {
        let (fill, name) = (self.fill()?, self.name.clone());
        let (film, said) = watched(py, told, move |progress| {
            progress.begin(&format!("filling of {}", self.name), None);
            let film = span(&self, &fill, progress);
            progress.end();
            film
        })??;
        let outcome = Ok(Box::new(film.into_done()));
        Ok((Surface::of(&MethodResult { name, outcome })?, said))
    }
}

/// Fills the loops, or the graph, that curves make in whatever order; what is to be said of their assembling.
#[pyfunction]
#[pyo3(signature = (curves, options, told=None))]
pub(crate) fn fill_loops(
    py: Python<'_>,
    curves: Vec<Given<'_>>,
    options: Options,
    told: Option<Py<PyAny>>,
) -> PyResult<(Surface, Vec<String>)> {
    let curves =
        curves.iter().enumerate().map(|(k, curve)| curve.curve(k + 1)).collect::<PyResult<Vec<_>>>()?;
    let file = CurveFile { kind: Kind::Table, curves, unit: None, notes: Vec::new() };
    options.surface(py, told.as_ref(), move |options, fill, progress| {
        let filling = Filling::new(vec![file], &options.curves());
        let filling = filling.map_err(|error| BoundaryError::new_err(error.told(&spelled)))?;
        let film = filling.span(fill, progress).map_err(|error| of_method(&error))?;
        Ok((film, filling.notes().iter().map(|note| note.told(&spelled)).collect()))
    })
}

/// A vertex by name, its place or none, and whether it stays there.
type GivenVertex = (String, Option<[f64; 3]>, bool);

/// A Bézier curve between two vertices by name.
type GivenCurve<'py> = (String, String, PyReadonlyArray2<'py, f64>);

/// Fills the faces, given by the names of their vertices, of a graph of Bézier curves between vertices.
#[pyfunction]
#[pyo3(signature = (vertices, curves, faces, options, told=None))]
pub(crate) fn fill_faces(
    py: Python<'_>,
    vertices: Vec<GivenVertex>,
    curves: Vec<GivenCurve<'_>>,
    faces: Vec<Vec<String>>,
    options: Options,
    told: Option<Py<PyAny>>,
) -> PyResult<Surface> {
    let numbers: HashMap<String, usize> =
        vertices.iter().enumerate().map(|(k, (name, ..))| (name.clone(), k)).collect();
    let number = |name: &String| {
        let found = numbers.get(name).copied();
        found.ok_or_else(|| BoundaryError::new_err(format!("there is no vertex {name:?}")))
    };
    let between = curves
        .iter()
        .map(|(from, to, given)| {
            let curve = BoundaryCurve::bezier(points(given)?);
            let curve = curve.map_err(|error| {
                BoundaryError::new_err(format!("the curve from {from:?} to {to:?}: {error}"))
            })?;
            Ok(GraphCurve { ends: [number(from)?, number(to)?], curve })
        })
        .collect::<PyResult<Vec<_>>>()?;
    let faces = faces
        .iter()
        .map(|face| face.iter().map(number).collect::<PyResult<Vec<_>>>())
        .collect::<PyResult<Vec<_>>>()?;
    let vertices = vertices
        .into_iter()
        .map(|(name, place, fixed)| {
            let place = place.map(Into::into);
            (name, place.filter(|_| fixed).map_or(Vertex::Free(place), Vertex::Fixed))
        })
        .collect();
    let graph = CurveGraph::new(vertices, between, &faces, options.weld)
        .map_err(|error| BoundaryError::new_err(error.to_string()))?;
    let (surface, ()) = options.surface(py, told.as_ref(), move |_, fill, progress| {
        Ok((fill.graph(&graph, progress).map_err(|error| of_method(&error))?, ()))
    })?;
    Ok(surface)
}
