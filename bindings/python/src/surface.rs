//! A surface that was found, for Python.

use std::io;
use std::path::PathBuf;
use std::sync::Arc;

use exchange::{Accuracy, Format, LengthUnit, StepForm, SurfaceForm, spline};
use numpy::{PyArray1, PyArray2, PyArray3, PyArrayDyn, PyReadonlyArray2, ToPyArray};
use plateau::{Done, Family, MethodResult, Progress, Surface as Geometry};
use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;
use rayon::prelude::*;
use record::{Destination, SCHEMA, StoredMethod, StoredResult};
use surfaces::{Complex, Domain, Jet, Knots, Mesh, Patch, Point, SplineSurface};

use crate::arrays::{array, coordinates, or_nan, parameters};
use crate::errors::{BoundaryError, FormatError, MethodError, of_export, of_method};
use crate::watch::{watched, watched_to_its_end};

/// Parameters that are evaluated at once by one thread.
const CHUNK: usize = 4096;

/// A surface and what `result.json` says of it. Work that is left to itself when it is interrupted shares it.
#[pyclass(frozen, module = "plateau_patches._engine")]
pub(crate) struct Surface(Arc<Found>);

/// What a [`Surface`] holds.
pub(crate) struct Found {
    stored: StoredMethod,
    geometry: Geometry,
    family: Family,
    record: String,
}

impl Surface {
    /// The surface of a method that found one.
    pub(crate) fn of(result: &MethodResult) -> PyResult<Self> {
        let stored = StoredMethod::of(result);
        let (geometry, family) = stored.surface.clone().map_err(MethodError::new_err)?;
        let record =
            record::method_record(result).map_err(|error| MethodError::new_err(error.to_string()))?;
        Ok(Self(Arc::new(Found { stored, geometry, family, record })))
    }

    pub(crate) fn found(&self) -> Arc<Found> {
        self.0.clone()
    }
}

impl Found {
    /// The surface with figures computed anew, for what shows them.
    pub(crate) fn shown(&self) -> PyResult<MethodResult> {
        let done = Done::of(self.geometry.clone(), self.family).map_err(|error| of_method(&error))?;
        Ok(MethodResult { name: self.stored.name.clone(), outcome: Ok(Box::new(done)) })
    }

    /// The jets of a face at parameters; some, if nobody waits for them any more.
    fn jets(&self, face: usize, at: &[[f64; 2]], progress: &dyn Progress) -> PyResult<Vec<Jet>> {
        let jets = |patch: &dyn Patch| {
            let chunks = at.par_chunks(CHUNK).take_any_while(|_| !progress.cancelled());
            chunks.flat_map_iter(|at| patch.jets_at(at)).collect()
        };
        self.with_patch(face, jets)
    }

    /// The points of a face at parameters, like [`Self::jets`].
    fn points(&self, face: usize, at: &[[f64; 2]], progress: &dyn Progress) -> PyResult<Vec<Point>> {
        let points = |patch: &dyn Patch| {
            let chunks = at.par_chunks(CHUNK).take_any_while(|_| !progress.cancelled());
            chunks.flat_map_iter(|at| patch.points_at(at)).collect()
        };
        self.with_patch(face, points)
    }

    fn with_patch<T>(&self, face: usize, of: impl FnOnce(&dyn Patch) -> T) -> PyResult<T> {
        let none = || PyIndexError::new_err(format!("there is no face {face}"));
        match (&self.geometry, face) {
            (Geometry::Complex(complex), face) if face < complex.faces().len() => {
                let patch = complex.patch(face).map_err(|error| MethodError::new_err(error.to_string()))?;
                Ok(of(&patch))
            }
            (geometry, 0) => geometry.patch().map(of).ok_or_else(none),
            _ => Err(none()),
        }
    }
}

/// Vertices, normals, parameters, mean and Gauss curvature, triangles, the face of every triangle.
type MeshArrays<'py> = (
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray1<f64>>,
    Bound<'py, PyArray1<f64>>,
    Bound<'py, PyArray2<u32>>,
    Option<Bound<'py, PyArray1<u32>>>,
);

/// Degree and knots of u and of v, and the control points of a spline.
type SplineArrays<'py> = ((usize, Vec<f64>), (usize, Vec<f64>), Bound<'py, PyArray3<f64>>);

/// Normals, mean and Gauss curvature.
type Curvatures<'py> = (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>);

#[pymethods]
impl Surface {
    /// The surface of a method's entry in a `result.json`.
    #[staticmethod]
    fn restore(record: &str) -> PyResult<Self> {
        let whole = format!(r#"{{"schema": "{SCHEMA}", "title": "", "methods": [{record}]}}"#);
        let read = StoredResult::parse(whole.as_bytes())
            .map_err(|error| FormatError::new_err(format!("the record of a surface: {error}")))?;
        let stored = read.methods.into_iter().next();
        let stored = stored.ok_or_else(|| FormatError::new_err("the record holds no surface"))?;
        let (geometry, family) = stored.surface.clone().map_err(MethodError::new_err)?;
        Ok(Self(Arc::new(Found { stored, geometry, family, record: record.to_owned() })))
    }

    /// What `result.json` says of it, as JSON.
    #[getter]
    fn record(&self) -> &str {
        &self.0.record
    }

    /// `tensor`, `triangle`, `pieces` or `complex`.
    #[getter]
    fn kind(&self) -> &'static str {
        match &self.0.geometry {
            Geometry::Tensor(_) => "tensor",
            Geometry::Triangle(_) => "triangle",
            Geometry::Pieces(_) => "pieces",
            Geometry::Complex(_) => "complex",
        }
    }

    /// The control points: (m + 1, n + 1, 3) of every net, ((n + 1)(n + 2)/2, 3) of a triangular one.
    fn nets<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyArrayDyn<f64>>>> {
        let net = |net: &surfaces::Net| array(py, vec![net.rows(), net.cols(), 3], coordinates(net.points()));
        match &self.0.geometry {
            Geometry::Tensor(patch) => Ok(vec![net(patch.net())?]),
            Geometry::Triangle(patch) => {
                let points = patch.net().points();
                Ok(vec![array(py, vec![points.len(), 3], coordinates(points))?])
            }
            Geometry::Pieces(pieces) => pieces.patches().iter().map(|patch| net(patch.net())).collect(),
            Geometry::Complex(complex) => (0..complex.faces().len())
                .map(|face| {
                    net(&complex.net(face).map_err(|error| MethodError::new_err(error.to_string()))?)
                })
                .collect(),
        }
    }

    /// The indices (i, j, k) of the control points of a triangular net.
    fn indices<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyArray2<u32>>>> {
        let Geometry::Triangle(patch) = &self.0.geometry else { return Ok(None) };
        let all: Vec<Vec<u32>> =
            patch.net().indices().map(|index| index.map(|i| i as u32).to_vec()).collect();
        Ok(Some(PyArray2::from_vec2(py, &all)?))
    }

    /// The ranges of u and v of a rectangle; none of a triangle.
    fn domain(&self) -> PyResult<Option<[(f64, f64); 2]>> {
        self.0.with_patch(0, |patch| match patch.domain() {
            Domain::Rectangle { u, v } => Some([u, v]),
            Domain::Triangle => None,
        })
    }

    /// The points (k, 3) of a face at parameters (k, 2).
    fn points<'py>(
        &self,
        py: Python<'py>,
        face: usize,
        at: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let at = parameters(&at)?;
        let surface = self.found();
        let found = watched(py, None, move |progress| surface.points(face, &at, progress))??;
        array(py, [found.len(), 3], coordinates(&found))
    }

    /// The derivatives by u and by v (k, 3) of a face at parameters (k, 2).
    fn derivatives<'py>(
        &self,
        py: Python<'py>,
        face: usize,
        at: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<[Bound<'py, PyArray2<f64>>; 2]> {
        let at = parameters(&at)?;
        let surface = self.found();
        let jets = watched(py, None, move |progress| surface.jets(face, &at, progress))??;
        let of = |which: fn(&Jet) -> Point| {
            let points: Vec<Point> = jets.iter().map(which).collect();
            array(py, [points.len(), 3], coordinates(&points))
        };
        Ok([of(|jet| jet.u)?, of(|jet| jet.v)?])
    }

    /// Unit normals (k, 3), mean and Gauss curvature (k,) of a face at parameters (k, 2); not a number where it is singular.
    fn curvatures<'py>(
        &self,
        py: Python<'py>,
        face: usize,
        at: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Curvatures<'py>> {
        let at = parameters(&at)?;
        let surface = self.found();
        let jets = watched(py, None, move |progress| surface.jets(face, &at, progress))??;
        let none = Point::new(f64::NAN, f64::NAN, f64::NAN);
        let normals: Vec<Point> = jets.iter().map(|jet| jet.normal().unwrap_or(none)).collect();
        let mean: Vec<Option<f64>> = jets.iter().map(Jet::mean_curvature).collect();
        let gauss: Vec<Option<f64>> = jets.iter().map(Jet::gauss_curvature).collect();
        Ok((
            array(py, [normals.len(), 3], coordinates(&normals))?,
            array(py, [mean.len()], or_nan(&mean))?,
            array(py, [gauss.len()], or_nan(&gauss))?,
        ))
    }

    /// The triangle mesh with so many subdivisions of every side of a patch.
    fn mesh<'py>(&self, py: Python<'py>, subdivisions: usize) -> PyResult<MeshArrays<'py>> {
        let surface = self.found();
        let (mesh, faces) = watched(py, None, move |_| surface.triangles(subdivisions))??;
        // One array after the other: there is never twice as much of everything.
        let Mesh { points, normals, parameters, mean_curvature, gauss_curvature, triangles } = mesh;
        let three = |points: Vec<Point>| array(py, [points.len(), 3], coordinates(&points));
        let vertices = three(points)?;
        let normals = three(normals)?;
        let count = parameters.len();
        let parameters = array(py, [count, 2], parameters.into_flattened())?;
        let one = |numbers: Vec<Option<f64>>| array(py, [count], or_nan(&numbers));
        let mean = one(mean_curvature)?;
        let gauss = one(gauss_curvature)?;
        let corners =
            numpy::ndarray::Array2::from_shape_vec([triangles.len(), 3], triangles.into_flattened())
                .map_err(|error| MethodError::new_err(error.to_string()))?;
        let corners = numpy::IntoPyArray::into_pyarray(corners, py);
        Ok((vertices, normals, parameters, mean, gauss, corners, faces.map(|faces| faces.to_pyarray(py))))
    }

    /// The B-splines that are its patches, and how far they are from them, if they are not these: (degree, knots) in u and in v,
    /// control points.
    fn splines<'py>(
        &self,
        py: Python<'py>,
        tolerance: f64,
    ) -> PyResult<(Vec<SplineArrays<'py>>, Option<f64>)> {
        let surface = self.found();
        let (splines, accuracy) = watched(py, None, move |_| surface.splines(tolerance))??;
        let arrays = |spline: &SplineSurface| {
            let [u, v] = spline.knots().each_ref().map(|knots| (knots.degree(), knots.repeated()));
            let counts = spline.knots().each_ref().map(Knots::count);
            Ok((u, v, array(py, [counts[0], counts[1], 3], coordinates(spline.points()))?))
        };
        let deviation = match accuracy {
            Accuracy::Exact => None,
            Accuracy::Fitted { deviation, .. } => Some(deviation),
        };
        Ok((splines.iter().map(arrays).collect::<PyResult<_>>()?, deviation))
    }

    /// Writes the surface as a file. What the file holds, where that takes saying.
    fn write(
        &self,
        py: Python<'_>,
        path: PathBuf,
        format: &str,
        subdivisions: usize,
        tolerance: f64,
        unit: Option<&str>,
    ) -> PyResult<Option<String>> {
        let step = StepForm { tolerance, unit: unit.map(length_unit).transpose()? };
        let known = Format::named(format);
        let format = known.ok_or_else(|| FormatError::new_err(format!("{format}: no such format")))?;
        let to = Destination::named(&path)
            .map_err(|error| io::Error::new(error.kind(), format!("{}: {error}", path.display())))?;
        let surface = self.found();
        let written = watched_to_its_end(py, move |_| surface.write(format, subdivisions, step, &to))??;
        let lengths = step.unit.and_then(|unit| format.lengths().told(unit));
        let told: Vec<String> = written.map(|form| form.description).into_iter().chain(lengths).collect();
        Ok((!told.is_empty()).then(|| told.join("; ")))
    }
}

impl Found {
    /// A spline for every face.
    fn splines(&self, tolerance: f64) -> PyResult<(Vec<SplineSurface>, Accuracy)> {
        let of = |geometry: &Geometry| {
            spline(geometry, self.family, tolerance).map_err(|error| FormatError::new_err(error.to_string()))
        };
        let Geometry::Complex(complex) = &self.geometry else {
            let (whole, accuracy) = of(&self.geometry)?;
            return Ok((vec![whole], accuracy));
        };
        let face = |face| {
            let patch = complex.patch(face).map_err(|error| MethodError::new_err(error.to_string()))?;
            of(&Geometry::Tensor(patch)).map(|(patch, _)| patch)
        };
        Ok(((0..complex.faces().len()).map(face).collect::<PyResult<_>>()?, Accuracy::Exact))
    }

    fn write(
        &self,
        format: Format,
        subdivisions: usize,
        step: StepForm,
        to: &Destination,
    ) -> PyResult<Option<SurfaceForm>> {
        let written = match &self.geometry {
            Geometry::Complex(complex) => {
                let mesh =
                    complex.mesh(subdivisions).map_err(|error| FormatError::new_err(error.to_string()))?;
                record::export_complex(format, &self.stored.name, (complex, &mesh.mesh), step.unit, to)
            }
            Geometry::Tensor(_) | Geometry::Triangle(_) | Geometry::Pieces(_) => {
                self.stored.export(format, subdivisions, step, to)
            }
        };
        written.map_err(|error| of_export(&error))
    }

    /// Its mesh, of a complex with the face of every triangle.
    fn triangles(&self, subdivisions: usize) -> PyResult<(Mesh, Option<Vec<u32>>)> {
        let of_complex = |complex: &Complex| {
            let mesh =
                complex.mesh(subdivisions).map_err(|error| BoundaryError::new_err(error.to_string()))?;
            Ok((mesh.mesh, Some(mesh.faces.into_iter().map(|face| face as u32).collect())))
        };
        match &self.geometry {
            Geometry::Tensor(patch) => Ok((Mesh::of(patch, subdivisions), None)),
            Geometry::Triangle(patch) => Ok((Mesh::of(patch, subdivisions), None)),
            Geometry::Pieces(pieces) => Ok((Mesh::of(pieces, subdivisions), None)),
            Geometry::Complex(complex) => of_complex(complex),
        }
    }
}

/// A unit by its name.
fn length_unit(name: &str) -> PyResult<LengthUnit> {
    let found = LengthUnit::NAMED.into_iter().find(|(known, _)| *known == name);
    found.map(|(_, unit)| unit).ok_or_else(|| {
        let known = LengthUnit::NAMED.map(|(name, _)| name).join(", ");
        FormatError::new_err(format!("{name:?} is no unit of length; give one of {known}"))
    })
}

/// The format that a file of this name has; none if its ending is that of no format.
#[pyfunction]
pub(crate) fn format_of(name: &str) -> Option<&'static str> {
    Format::of_file(name).map(Format::name)
}

/// The formats surfaces are written in by name.
#[pyfunction]
pub(crate) fn formats() -> Vec<&'static str> {
    Format::ALL.iter().map(|format| format.name()).collect()
}
