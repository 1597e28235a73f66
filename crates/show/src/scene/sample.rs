use plateau::{Done, Mode, Seams, Surface};
use surfaces::{Complex, Patch, Point};

use super::Field;
use super::chart::Chart;

/// Fewest and most subdivisions of the sides of the faces of a complex.
const PER_FACE: [usize; 2] = [4, 48];

/// Most points of a surface: the viewer counts the corners of its lines in 16 bits.
const MOST: usize = 30_000;

/// A kink of more than this is one to see, radians: a degree.
const KINK: f64 = 0.017;

/// What a line on a surface is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum LineKind {
    /// Where the surface ends.
    Rim,
    /// A border between patches across which the surface is smooth.
    Border,
    /// A border across which it is not, or where more than two patches meet.
    Kink,
}

/// A line along points of a sample.
pub(crate) struct Line {
    pub(crate) kind: LineKind,
    pub(crate) points: Vec<usize>,
}

/// A surface at points of it: one chart, or one for each face of a complex.
pub(crate) struct Sample {
    /// The points, each once.
    pub(crate) points: Vec<Point>,
    /// The grids over them.
    pub(crate) charts: Vec<Chart>,
    /// The rim, and the borders of the patches of a complex.
    pub(crate) lines: Vec<Line>,
    fields: [Vec<Option<f64>>; 5],
}

impl Sample {
    /// Samples a surface at about `budget` vertices; none if it has more faces than can be shown.
    pub(super) fn of(done: &Done, budget: usize) -> Option<Self> {
        let mut sample = match done.solved.surface() {
            Surface::Tensor(patch) => Self::of_patch(patch, None, budget),
            Surface::Triangle(patch) => Self::of_patch(patch, None, budget),
            Surface::Pieces(pieces) => Self::of_patch(pieces, Some(pieces.shape()), budget),
            Surface::Complex(complex) => Self::of_complex(complex, budget)?,
        };
        let mode = done.solved.area().and_then(|found| found.mode.as_ref());
        if let Some(values) = mode.and_then(|mode| sample.displacement(mode, done.solved.surface(), budget)) {
            sample.fields[Field::Mode as usize] = values;
        }
        Some(sample)
    }

    /// The displacement of a mode of the surface at the points of its sample of about `budget` vertices, in units of the largest.
    fn displacement(&self, mode: &Mode, surface: &Surface, budget: usize) -> Option<Vec<Option<f64>>> {
        let functions = mode.functions(surface).ok()??;
        let mut values = vec![0.0; self.points.len()];
        for (function, chart) in functions.iter().zip(&self.charts) {
            let of_chart = match chart.places() {
                None => Self::of_patch(function.as_ref(), None, budget).points,
                Some(_) => {
                    let at: Vec<f64> =
                        (0..=chart.steps[0]).map(|k| k as f64 / chart.steps[0] as f64).collect();
                    function.jets(&at, &at).into_iter().map(|jet| jet.point).collect()
                }
            };
            for (k, point) in of_chart.into_iter().enumerate() {
                values[chart.places().map_or(k, |places| places[k] as usize)] = point.x;
            }
        }
        let largest = values.iter().fold(0.0f64, |largest, f| largest.max(f.abs()));
        (largest > 0.0).then(|| values.into_iter().map(|f| Some(f / largest)).collect())
    }

    /// Samples a surface of one domain, of so many pieces in u and v.
    pub(super) fn of_patch(patch: &dyn Patch, pieces: Option<[usize; 2]>, budget: usize) -> Self {
        let (chart, jets) = Chart::of(patch, pieces, budget);
        let fields = Field::ALL.map(|field| jets.iter().map(|jet| field.of(jet)).collect());
        let mut outline: Vec<usize> = chart.outline().into_iter().map(|at| chart.at(at)).collect();
        outline.push(outline[0]);
        Self {
            points: jets.iter().map(|jet| jet.point).collect(),
            charts: vec![chart],
            lines: vec![Line { kind: LineKind::Rim, points: outline }],
            fields,
        }
    }

    /// Samples the faces of a complex, points on edges once. Fields of a chart have no meaning where there are many.
    fn of_complex(complex: &Complex, budget: usize) -> Option<Self> {
        let faces = complex.faces().len().max(1);
        let [fewest, most] = PER_FACE;
        let steps = ((budget / faces) as f64).sqrt() as usize;
        let steps = (steps.saturating_sub(1) / 4 * 4).clamp(fewest, most);
        let sampled = complex.mesh(steps).ok()?;
        // Measured here, not taken from the figures: what was read from a record is drawn as what was computed.
        let kinks = Seams::of(complex).ok()?.kinks;
        let mesh = sampled.mesh;
        if mesh.points.len() > MOST {
            return None;
        }
        let kind = |edge: usize| {
            let uses = complex.edges()[edge].uses().len();
            match kinks[edge] {
                _one if uses < 2 => LineKind::Rim,
                Some(kink) if kink <= KINK => LineKind::Border,
                Some(_) | None => LineKind::Kink,
            }
        };
        let lines = sampled
            .edges
            .iter()
            .enumerate()
            .map(|(edge, run)| Line { kind: kind(edge), points: run.iter().map(|&k| k as usize).collect() });
        let none = vec![None; mesh.points.len()];
        let fields = Field::ALL.map(|field| match field {
            Field::Mean => mesh.mean_curvature.clone(),
            Field::Gauss => mesh.gauss_curvature.clone(),
            Field::Laplacian | Field::Conformality | Field::Mode => none.clone(),
        });
        let orientation = complex.orientation();
        let grids = sampled.grids.into_iter().zip(orientation.flipped());
        Some(Self {
            lines: lines.collect(),
            charts: grids.map(|(places, &flipped)| Chart::of_face(steps, places, flipped)).collect(),
            points: mesh.points,
            fields,
        })
    }

    /// The values of a field at the points; none where it does not exist.
    pub(crate) fn values(&self, field: Field) -> &[Option<f64>] {
        &self.fields[field as usize]
    }

    /// The chart of a surface that has one.
    pub(crate) fn chart(&self) -> Option<&Chart> {
        match &self.charts[..] {
            [chart] => Some(chart),
            _several => None,
        }
    }

    /// The corners of the faces of `stride` cells a side of all charts, as places among the points.
    pub(crate) fn faces(&self, stride: usize) -> impl Iterator<Item = Vec<usize>> {
        self.charts.iter().flat_map(move |chart| {
            let corners = |face: Vec<[usize; 2]>| face.into_iter().map(|at| chart.at(at)).collect();
            chart.faces(stride).into_iter().map(corners).collect::<Vec<_>>()
        })
    }
}
