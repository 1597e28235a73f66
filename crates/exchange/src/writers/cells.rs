//! The surface itself as Bézier cells of VTK: their control points are those of the patches, and neighbours have them in common.
//!
//! VTK numbers the control points of a cell from outside in: corners, then sides, then the inside, of a triangle ring by ring. A file
//! says in `HigherOrderDegrees` which degrees its cells have.

use std::io::{self, Write};

use plateau::{Family, MAX_COORDINATE, Surface, counted};
use surfaces::{Complex, Net, Point, SplineSurface, TriangleNet};
use thiserror::Error;

use super::spline::{SplineError, described, is_polynomial, spline};
use super::vtk::{self, doubles};

/// The cell types of Bézier triangles and quadrilaterals in VTK.
const TRIANGLE: u8 = 76;
const QUADRILATERAL: u8 = 77;

/// Why there are no cells of a surface.
#[derive(Debug, Clone, PartialEq, Error)]
pub(crate) enum CellError {
    /// It is no polynomial, and there is no spline.
    #[error(transparent)]
    Spline(#[from] SplineError),
    /// Readers would compute with numbers beyond their range.
    #[error(
        "it has coordinates up to {largest:.1e}: scale its control points to at most {MAX_COORDINATE:.0e}"
    )]
    TooLarge {
        /// The largest coordinate of a control point.
        largest: f64,
    },
}

/// A surface as it goes into the file.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct CellFile {
    points: Vec<Point>,
    cells: Vec<Cell>,
    deviation: Option<f64>,
    description: String,
}

/// A cell with the numbers of its control points in the order of VTK.
#[derive(Debug, Clone, PartialEq)]
struct Cell {
    kind: u8,
    degrees: [usize; 2],
    nodes: Vec<u32>,
}

impl CellFile {
    /// The cells of a surface: exact if it is polynomial, otherwise those of a spline within `tolerance` times its size.
    ///
    /// # Errors
    /// [`CellError`].
    pub(crate) fn new(surface: &Surface, family: Family, tolerance: f64) -> Result<Self, CellError> {
        match surface {
            Surface::Complex(complex) => Self::of_complex(complex),
            Surface::Triangle(patch) => Self::of_triangle(patch.net()),
            Surface::Tensor(patch) if is_polynomial(patch, family) => Self::of_net(patch.net()),
            Surface::Tensor(_) | Surface::Pieces(_) => {
                let (spline, accuracy) = spline(surface, family, tolerance)?;
                let mut file = Self::of_spline(&spline.bezier_form())?;
                let cells = counted(file.cells.len(), "Bézier cell");
                file.description = format!("{cells} of {}", described(&spline, accuracy));
                file.deviation = accuracy.deviation();
                Ok(file)
            }
        }
    }

    /// One cell a face; u and v change places where its normal would point to the other side than its neighbours'.
    ///
    /// # Errors
    /// [`CellError::TooLarge`].
    pub(crate) fn of_complex(complex: &Complex) -> Result<Self, CellError> {
        let degree = complex.degree();
        let orientation = complex.orientation();
        let cells = complex.faces().iter().zip(orientation.flipped()).map(|(face, &turned)| {
            let at = |(i, j): (usize, usize)| {
                let (i, j) = if turned { (j, i) } else { (i, j) };
                face.nodes()[(degree + 1) * i + j] as u32
            };
            Cell::quadrilateral([degree; 2], at)
        });
        let cells: Vec<Cell> = cells.collect();
        let count = counted(cells.len(), "Bézier cell");
        let description = format!("exact: {count} of degree ({degree}, {degree}) with points in common");
        Self::checked(complex.points().to_vec(), cells, description)
    }

    fn of_net(net: &Net) -> Result<Self, CellError> {
        let (m, n) = net.degrees();
        let cell = Cell::quadrilateral([m, n], |(i, j)| ((n + 1) * i + j) as u32);
        Self::checked(
            net.points().to_vec(),
            vec![cell],
            format!("exact: one Bézier cell of degree ({m}, {n})"),
        )
    }

    fn of_triangle(net: &TriangleNet) -> Result<Self, CellError> {
        let degree = net.degree();
        let cell = Cell::triangle(degree, |[i, j, _]| net.position(i, j) as u32);
        let description = format!("exact: one triangular Bézier cell of degree {degree}");
        Self::checked(net.points().to_vec(), vec![cell], description)
    }

    /// A cell between neighbouring knots of a spline in Bézier form.
    fn of_spline(spline: &SplineSurface) -> Result<Self, CellError> {
        let [m, n] = spline.knots().each_ref().map(surfaces::Knots::degree);
        let [rows, cols] = spline.knots().each_ref().map(|knots| knots.values().len() - 1);
        let cells = (0..rows * cols).map(|k| {
            let (first, second) = (m * (k / cols), n * (k % cols));
            Cell::quadrilateral([m, n], |(i, j)| ((first + i) * spline.cols() + second + j) as u32)
        });
        Self::checked(spline.points().to_vec(), cells.collect(), String::new())
    }

    fn checked(points: Vec<Point>, cells: Vec<Cell>, description: String) -> Result<Self, CellError> {
        let largest = points.iter().flat_map(|p| [p.x, p.y, p.z]).fold(0.0, |m: f64, x| m.max(x.abs()));
        if largest > MAX_COORDINATE {
            return Err(CellError::TooLarge { largest });
        }
        Ok(Self { points, cells, deviation: None, description })
    }

    /// The largest distance from the patch that the file states; none if the surface is the patch itself.
    pub(crate) fn deviation(&self) -> Option<f64> {
        self.deviation
    }

    /// What the surface is, for people.
    pub(crate) fn description(&self) -> &str {
        &self.description
    }

    /// Writes the whole file.
    pub(crate) fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let cells = self.cells.iter().map(|cell| vtk::Cell { kind: cell.kind, nodes: &cell.nodes });
        let degrees = self.cells.iter().flat_map(|cell| {
            let [m, n] = cell.degrees;
            [m as f64, n as f64, 0.0]
        });
        let data = |out: &mut dyn Write| {
            writeln!(out, "<CellData HigherOrderDegrees=\"HigherOrderDegrees\">")?;
            doubles("HigherOrderDegrees", [self.cells.len(), 3], degrees, out)?;
            writeln!(out, "</CellData>")
        };
        vtk::grid(&self.points, cells, data, out)
    }
}

impl Cell {
    /// Corners (0, 0), (m, 0), (m, n), (0, n); the sides between them, each with its parameter; the inside, i faster than j.
    fn quadrilateral([m, n]: [usize; 2], number: impl Fn((usize, usize)) -> u32) -> Self {
        let corners = [(0, 0), (m, 0), (m, n), (0, n)].into_iter();
        let along = |j| (1..m).map(move |i| (i, j));
        let across = |i| (1..n).map(move |j| (i, j));
        let sides = along(0).chain(across(m)).chain(along(n)).chain(across(0));
        let inside = (1..n).flat_map(along);
        let nodes = corners.chain(sides).chain(inside).map(number).collect();
        Self { kind: QUADRILATERAL, degrees: [m, n], nodes }
    }

    /// Corners A, B, C; the sides AB, BC, CA between them; the same of the triangle within, of a degree lower by three.
    fn triangle(degree: usize, number: impl Fn([usize; 3]) -> u32) -> Self {
        let rings = (0..=degree / 3).flat_map(|ring| {
            let (far, steps) = (degree - 2 * ring, degree - 3 * ring);
            let corners = [[far, ring, ring], [ring, far, ring], [ring, ring, far]];
            let sides = (0..3).flat_map(move |side| {
                (1..steps).map(move |k| {
                    let mut index = [ring; 3];
                    (index[side], index[(side + 1) % 3]) = (far - k, ring + k);
                    index
                })
            });
            // The last triangle within may be one point.
            corners.into_iter().take(if steps == 0 { 1 } else { 3 }).chain(sides)
        });
        Self { kind: TRIANGLE, degrees: [degree; 2], nodes: rings.map(number).collect() }
    }
}
