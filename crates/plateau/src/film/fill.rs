//! From loops or a graph of curves to the surface that spans them.

use surfaces::{BoundaryCurve, Complex, ComplexMesh, Point, anchor, extent};

use super::options::{Fill, FillEnergy, Meshing};
use super::solution::Solution;
use super::{Film, Tried, cone, degree};
use crate::degenerate::far;
use crate::excess::{estimated, told};
use crate::memory;
use crate::surface::per_face;
use crate::{
    CurveGraph, CutBoundary, Cutting, CuttingError, Family, Figures, Loop, MethodError, Progress, Seams,
    Surface, Warning, dirichlet_complex, least_area_complex, lower_bound,
};

/// Share of the accuracy that is asked for by which the rim may deviate, as a share of the size: where it runs around the surface, what
/// lies between it and the curves is then less than that accuracy.
const RIM_SHARE: f64 = 0.1;

/// How many times as many edges a rim may have to be that near.
const MORE_EDGES: usize = 2;

impl Fill {
    /// The surface between loops: one is spanned by a disc, two by an annulus. As [`solve`](crate::solve) does, all is computed relative to
    /// a point of the boundary: how far from the origin it lies changes no figure.
    ///
    /// Where the way of cutting was not asked for and leads to a surface that folds, nearly folds or is not stationary, others
    /// are tried as well, and the best is kept. Each of two loops is spanned by itself, too, and it is said if the two together
    /// have less area.
    ///
    /// # Errors
    /// [`MethodError::Apart`] for two loops so far apart that no surface of least area hangs together between them,
    /// [`MethodError::Cutting`] for what no surface can be laid out over, else as [`least_area`](crate::least_area).
    pub fn loops(&self, loops: &[Loop], progress: &dyn Progress) -> Result<Film, MethodError> {
        self.check()?;
        let given: Vec<Point> =
            loops.iter().flat_map(Loop::curves).flat_map(BoundaryCurve::given_points).collect();
        let origin = anchor(&given);
        let loops: Vec<Loop> = loops.iter().map(|around| around.moved(-origin)).collect();
        told_if_far(self.loops_near(&loops, origin, progress), &given, origin)
    }

    /// The surface between loops that were given `origin` away from where they lie.
    fn loops_near(
        &self,
        loops: &[Loop],
        origin: Point,
        progress: &dyn Progress,
    ) -> Result<Film, MethodError> {
        let cutting = self.cutting(loops.iter().flat_map(Loop::curves), |cutting| cutting.loops(loops))?;
        if let ([first, second], FillEnergy::Area) = (loops, self.energy)
            && let Some(cone) = cone::between(first, second)
        {
            let discs = self.one_by_one([first, second], cutting, progress)?;
            return Err(MethodError::Apart { apex: cone.apex.into(), axis: cone.axis.into(), discs });
        }
        let (best, tried) = match loops {
            [one] if self.way.is_none() => self.disc(one, cutting, progress)?,
            _ => (self.solved(&cutting.loops(loops)?, progress)?, Vec::new()),
        };
        let mut one_by_one = None;
        // The two discs are always solved: that they have less area is a figure of its own, whatever the annulus does.
        if let ([first, second], FillEnergy::Area) = (loops, self.energy) {
            one_by_one = self.one_by_one([first, second], cutting, progress)?;
        }
        self.film(best, tried, one_by_one, origin, progress)
    }

    /// The areas of two loops, each spanned by itself, together.
    fn one_by_one(
        &self,
        loops: [&Loop; 2],
        cutting: Cutting,
        progress: &dyn Progress,
    ) -> Result<Option<f64>, MethodError> {
        let cutting = cutting.with_way(None);
        let discs = loops.map(|one| self.disc(one, cutting, progress));
        let [first, second] = discs.map(|disc| disc.map(|(disc, _)| disc.area()));
        Ok(first?.zip(second?).map(|(first, second)| first + second))
    }

    /// The surface of the faces of a graph.
    ///
    /// # Errors
    /// As [`Self::loops`].
    pub fn graph(&self, graph: &CurveGraph, progress: &dyn Progress) -> Result<Film, MethodError> {
        self.check()?;
        let curves = || graph.curves().iter().map(|curve| &curve.curve);
        let given: Vec<Point> =
            curves().flat_map(BoundaryCurve::given_points).chain(graph.places()).collect();
        let origin = anchor(&given);
        let graph = graph.moved(-origin);
        let curves = graph.curves().iter().map(|curve| &curve.curve);
        let cutting = self.cutting(curves, |cutting| cutting.graph(&graph))?;
        let film = self
            .solved(&cutting.graph(&graph)?, progress)
            .and_then(|solution| self.film(solution, Vec::new(), None, origin, progress));
        told_if_far(film, &given, origin)
    }

    fn cutting<'a>(
        &self,
        curves: impl Iterator<Item = &'a BoundaryCurve> + Clone,
        cut: impl Fn(&Cutting) -> Result<CutBoundary, CuttingError>,
    ) -> Result<Cutting, CuttingError> {
        let points: Vec<_> =
            curves.clone().flat_map(|curve| (0..8).map(|k| curve.point(f64::from(k) / 8.0))).collect();
        // Points in one place have no size; whatever they are, they are met.
        let of_size =
            |share: f64| Some(share * extent(&points)).filter(|t| *t > 0.0).unwrap_or(f64::MIN_POSITIVE);
        let tolerance = self.rim_tolerance.unwrap_or_else(|| of_size(Self::RIM_TOLERANCE));
        let within = |tolerance: f64| {
            let cutting = |degree: usize| {
                let cutting = Cutting::new(degree, tolerance)?.with_corner_angle(self.corner_angle);
                Ok(cutting.with_way(self.way))
            };
            match self.degree {
                Some(degree) => cutting(degree),
                None => degree::raised(cutting, &cut, degree::usual(curves.clone())),
            }
        };
        let usual = within(tolerance)?;
        let nearer = self.accuracy.map(|accuracy| of_size(RIM_SHARE * accuracy));
        let Some(nearer) = nearer.filter(|nearer| *nearer < tolerance) else { return Ok(usual) };
        // A rim in many more pieces costs more than it is worth, and none may be as near: then it stays as it is, and what it costs is said.
        let edges = |cutting: &Cutting| degree::edges_of_rim(cutting, &cut);
        let most = MORE_EDGES * edges(&usual)?;
        let found = within(nearer).ok().filter(|found| edges(found).is_ok_and(|edges| edges <= most));
        Ok(found.unwrap_or(usual))
    }

    pub(super) fn solved(&self, cut: &CutBoundary, progress: &dyn Progress) -> Result<Solution, MethodError> {
        let (complex, extremal) = match self.energy {
            FillEnergy::Area => {
                let (degree, faces) = (cut.complex().degree(), cut.complex().faces().len());
                memory::holds(memory::of_faces(degree, faces))?;
                progress.tell(&format!("({faces} patches of degree {degree})"));
                let (complex, found) = least_area_complex(cut.complex(), &[], self.tolerance, progress)?;
                (complex, Some(found))
            }
            FillEnergy::Dirichlet => (dirichlet_complex(cut.complex(), progress)?, None),
        };
        let seams = Seams::of(&complex)?;
        let names = cut.names().to_vec();
        Ok(Solution { cut: cut.clone(), complex, names, layers: 0, extremal, seams })
    }

    fn film(
        &self,
        mut solution: Solution,
        tried: Vec<Tried>,
        one_by_one: Option<f64>,
        origin: Point,
        progress: &dyn Progress,
    ) -> Result<Film, MethodError> {
        // Layer after layer, until one does not lower the area: it leaves the solution as it is, and so would the next.
        for layer in 1..=self.layers {
            solution = self.layered(solution, progress)?;
            if solution.layers < layer {
                break;
            }
        }
        let mut notes = Vec::new();
        if solution.layers < self.layers {
            notes.push(Warning::NoLayer { wanted: self.layers, set: solution.layers });
        }
        let mut estimate = None;
        if let Some(accuracy) = self.accuracy {
            let reached = self.accurate(accuracy, solution, progress)?;
            (solution, estimate) = (reached.solution, reached.estimate);
            notes.extend(reached.note);
        }
        let mut film = self.with_figures(solution, (tried, one_by_one, notes), origin)?;
        film.warnings.extend(film.warned()?);
        let surface = Surface::Complex(film.complex.clone());
        let found = (&surface, Family::Complex, film.extremal.as_ref());
        film.estimate = match estimate {
            Some(estimate) => told(estimate, &mut film.warnings),
            None => estimated(found, &mut film.warnings, progress)?,
        };
        if let Some(accuracy) = self.accuracy
            && film.estimate.is_none_or(|estimate| estimate > accuracy * film.figures.area.value)
        {
            film.warnings.push(Warning::Inaccurate { accuracy, degree: film.complex.degree() });
        }
        // Figures are made near the origin, where nothing cancels; only then the film goes to where it was given.
        let mut film = film.moved(origin)?;
        // A proof speaks of the points as they are written.
        if self.bound {
            match lower_bound(&film.complex) {
                Ok(bound) => film.bound = Some(bound),
                Err(why) => film.warnings.push(Warning::NoBound(why)),
            }
        }
        Ok(film)
    }

    /// A film of a solution, with its figures and what is known of it already.
    fn with_figures(
        &self,
        solution: Solution,
        (tried, one_by_one, notes): (Vec<Tried>, Option<f64>, Vec<Warning>),
        origin: Point,
    ) -> Result<Film, MethodError> {
        let Solution { cut, complex, names, layers, extremal, seams } = solution;
        let (mesh, figures) = self.measured(&complex, origin)?;
        Ok(Film {
            names,
            layers,
            way: cut.way(),
            rim: cut.deviation(),
            welded: cut.welded(),
            complex,
            extremal,
            figures,
            seams,
            one_by_one,
            estimate: None,
            bound: None,
            tried,
            mesh,
            warnings: notes,
        })
    }

    /// The mesh of a surface that lies `origin` away from where its boundary was given, and its figures.
    fn measured(&self, complex: &Complex, origin: Point) -> Result<(ComplexMesh, Figures), MethodError> {
        let subdivisions = match self.mesh {
            Meshing::PerPatch(subdivisions) => subdivisions,
            Meshing::InAll(subdivisions) => per_face(complex, subdivisions),
        };
        memory::holds(memory::of_mesh(subdivisions).saturating_mul(complex.faces().len()))?;
        let mesh = complex.mesh(subdivisions)?;
        let patches =
            (0..complex.faces().len()).map(|face| complex.patch(face)).collect::<Result<Vec<_>, _>>()?;
        let patches: Vec<&dyn surfaces::Patch> = patches.iter().map(|patch| patch as _).collect();
        let figures = Figures::of_moved(&patches, &mesh.mesh, origin.norm())?;
        Ok((mesh, figures))
    }
}

/// The film of least area over loops in patches of a degree: [`Fill`] with everything else as usual.
///
/// # Errors
/// As [`Fill::loops`].
pub fn fill(loops: &[Loop], degree: usize) -> Result<Film, MethodError> {
    Fill::default().with_degree(degree).loops(loops, &())
}

/// What is said of a boundary that lies too far from the origin for its coordinates to tell much: first of all that.
fn told_if_far(film: Result<Film, MethodError>, given: &[Point], origin: Point) -> Result<Film, MethodError> {
    let far = far(extent(given), given.iter().map(|p| p.norm()).fold(0.0, f64::max));
    match (film, far) {
        (Ok(mut film), far) => {
            film.warnings.splice(0..0, far.map(Warning::Degenerate));
            Ok(film)
        }
        (Err(error), None) => Err(error.moved(origin)),
        (Err(error), Some(far)) => Err(MethodError::Far { far, error: Box::new(error.moved(origin)) }),
    }
}
