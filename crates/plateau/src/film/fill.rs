//! From loops or a graph of curves to the surface that spans them.

use surfaces::{BoundaryCurve, Complex, ComplexMesh, Point, anchor, extent};

use super::{Film, Tried, cone, degree, pinch};
use crate::degenerate::far;
use crate::excess::{estimated, told};
use crate::memory;
use crate::surface::per_face;
use crate::trust::of_film;
use crate::{
    AreaEnd, AreaExtremal, CurveGraph, CutBoundary, Cutting, CuttingError, Family, Figures, Loop,
    MethodError, Progress, Seams, Surface, Warning, Way, dirichlet_complex, least_area_complex, lower_bound,
};

/// What is minimised.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FillEnergy {
    /// The area.
    Area,
    /// The Dirichlet energy ½∫(E + G), every patch over a unit square.
    Dirichlet,
}

/// How a boundary is filled.
///
/// ```
/// use plateau::{Fill, Loop};
/// use surfaces::Point;
/// let corners = [[0., 0., 0.], [1., 0., 0.], [1., 1., 1.], [0., 1., 0.]].map(Point::from);
/// let film = Fill::default().with_degree(8).loops(&[Loop::polygon(&corners)?], &())?;
/// // K(¾)/K(¼)
/// assert!((film.figures.area.value - 1.279_261_571_171_006).abs() < 1e-9);
/// # Ok::<(), plateau::MethodError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fill {
    degree: Option<usize>,
    energy: FillEnergy,
    pub(super) tolerance: f64,
    rim_tolerance: Option<f64>,
    corner_angle: f64,
    way: Option<Way>,
    layers: usize,
    accuracy: Option<f64>,
    bound: bool,
    mesh: Meshing,
}

/// How fine the mesh of a film is.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Meshing {
    /// Subdivisions of every side of a patch.
    PerPatch(usize),
    /// Those of a single patch with as many vertices in all.
    InAll(usize),
}

impl Default for Fill {
    /// The least area in patches of degree 6, or that of the curves where it is higher, to [`Self::TOLERANCE`] of itself; curves that cannot be
    /// met exactly to 1e-6 of the size.
    fn default() -> Self {
        Self {
            degree: None,
            energy: FillEnergy::Area,
            tolerance: Self::TOLERANCE,
            rim_tolerance: None,
            corner_angle: Cutting::CORNER_ANGLE,
            way: None,
            layers: 0,
            accuracy: None,
            bound: false,
            mesh: Meshing::PerPatch(16),
        }
    }
}

/// An annulus that did not become stationary is pinching where it is thinner than this share of its thinner rim.
const PINCHING: f64 = 0.2;

impl Fill {
    /// The relative decrease of the area that counts as none.
    pub const TOLERANCE: f64 = 1e-9;

    /// Share of the size of the boundary by which its rim may deviate from curves that cannot be met exactly.
    pub const RIM_TOLERANCE: f64 = 1e-6;

    /// Most layers of smaller patches around corners.
    pub const MOST_LAYERS: usize = 4;

    /// Patches of this degree.
    #[must_use]
    pub fn with_degree(mut self, degree: usize) -> Self {
        self.degree = Some(degree);
        self
    }

    /// The degree that was asked for.
    #[must_use]
    pub fn degree(&self) -> Option<usize> {
        self.degree
    }

    /// See [`with_tolerance`](Self::with_tolerance).
    #[must_use]
    pub fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// See [`with_layers`](Self::with_layers).
    #[must_use]
    pub fn layers(&self) -> usize {
        self.layers
    }

    /// See [`with_accuracy`](Self::with_accuracy).
    #[must_use]
    pub fn accuracy(&self) -> Option<f64> {
        self.accuracy
    }

    /// See [`with_bound`](Self::with_bound).
    #[must_use]
    pub fn bound(&self) -> bool {
        self.bound
    }

    /// Minimises this energy.
    #[must_use]
    pub fn with_energy(mut self, energy: FillEnergy) -> Self {
        self.energy = energy;
        self
    }

    /// The relative decrease of the area that counts as none, see [`least_area`](crate::least_area).
    #[must_use]
    pub fn with_tolerance(mut self, tolerance: f64) -> Self {
        self.tolerance = tolerance;
        self
    }

    /// The rim may deviate by this length from curves that cannot be met exactly.
    #[must_use]
    pub fn with_rim_tolerance(mut self, tolerance: f64) -> Self {
        self.rim_tolerance = Some(tolerance);
        self
    }

    /// The turn of direction in radians above which curves meet in a corner; samples have their own.
    #[must_use]
    pub fn with_corner_angle(mut self, angle: f64) -> Self {
        self.corner_angle = angle;
        self
    }

    /// Cuts in this way, and tries no other.
    #[must_use]
    pub fn with_way(mut self, way: impl Into<Option<Way>>) -> Self {
        self.way = way.into();
        self
    }

    /// Sets layers of smaller patches around the corners of the rim where a surface of least area is not smooth ([`odd_corners`](crate::odd_corners)), one
    /// in the other, at most [`Self::MOST_LAYERS`]. A layer that does not lower the area is not kept; nor is any where the area is not minimised.
    #[must_use]
    pub fn with_layers(mut self, layers: usize) -> Self {
        self.layers = layers.min(Self::MOST_LAYERS);
        self
    }

    /// Raises the degree until the area is estimated to lie less than this share above the least, up to degree 14; where that gains little
    /// because of odd corners, they get a layer of smaller patches. The rim stays as it was met at first.
    #[must_use]
    pub fn with_accuracy(mut self, accuracy: impl Into<Option<f64>>) -> Self {
        self.accuracy = accuracy.into();
        self
    }

    /// Whether a lower bound of the area is to be proved, see [`lower_bound`].
    #[must_use]
    pub fn with_bound(mut self, bound: bool) -> Self {
        self.bound = bound;
        self
    }

    /// The mesh of the film has this many subdivisions of every side of a patch.
    #[must_use]
    pub fn with_mesh(mut self, subdivisions: usize) -> Self {
        self.mesh = Meshing::PerPatch(subdivisions);
        self
    }

    /// The mesh of the film has about as many vertices as that of a single patch of this many subdivisions.
    #[must_use]
    pub fn with_mesh_in_all(mut self, subdivisions: usize) -> Self {
        self.mesh = Meshing::InAll(subdivisions);
        self
    }

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
        let tolerance = self.rim_tolerance.unwrap_or_else(|| {
            // Points in one place have no size; whatever they are, they are met.
            Some(Self::RIM_TOLERANCE * extent(&points)).filter(|t| *t > 0.0).unwrap_or(f64::MIN_POSITIVE)
        });
        let cutting = |degree: usize| {
            let cutting = Cutting::new(degree, tolerance)?.with_corner_angle(self.corner_angle);
            Ok(cutting.with_way(self.way))
        };
        match self.degree {
            Some(degree) => cutting(degree),
            None => degree::raised(cutting, cut, degree::usual(curves)),
        }
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
        // Layer after layer: one that does not lower the area leaves the solution as it is.
        for _ in 0..self.layers {
            solution = self.layered(solution, progress)?;
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
        let Solution { cut, complex, names, layers, extremal, seams } = solution;
        let (mesh, figures) = self.measured(&complex, origin)?;
        let mut film = Film {
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
        };
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

/// A cut boundary with the surface over it.
pub(super) struct Solution {
    pub(super) cut: CutBoundary,
    pub(super) complex: Complex,
    /// The names of its vertices.
    pub(super) names: Vec<String>,
    /// Layers of smaller patches around its corners.
    pub(super) layers: usize,
    pub(super) extremal: Option<AreaExtremal>,
    pub(super) seams: Seams,
}

impl Solution {
    /// The area, where it was minimised.
    fn area(&self) -> Option<f64> {
        self.extremal.map(|found| found.area.value)
    }

    /// Whether there is no reason to cut in another way: stationary, and even to this ratio.
    pub(super) fn is_sound(&self, ratio: f64) -> bool {
        self.seams.is_even(ratio) && self.extremal.is_none_or(|found| found.end == AreaEnd::Stationary)
    }

    /// Whether it is to be preferred: it does not fold where the other does, else has less area, or is more even where no
    /// area was minimised.
    pub(super) fn is_better(&self, other: &Self) -> bool {
        match (self.seams.folds(), other.seams.folds(), self.area(), other.area()) {
            (false, true, _, _) => true,
            (true, false, _, _) => false,
            (_, _, Some(ours), Some(theirs)) => ours < theirs,
            (_, _, None, _) | (_, _, _, None) => self.seams.jacobian_ratio > other.seams.jacobian_ratio,
        }
    }

    pub(super) fn tried(&self) -> Tried {
        Tried {
            way: self.cut.way(),
            area: self.area(),
            jacobian_ratio: self.seams.jacobian_ratio,
            folds: self.seams.folds(),
        }
    }
}

impl Film {
    /// The film moved.
    fn moved(mut self, by: Point) -> Result<Self, MethodError> {
        if by == Point::ZERO {
            return Ok(self);
        }
        self.complex = self.complex.moved(by)?;
        self.mesh.mesh.points.iter_mut().for_each(|p| *p += by);
        for warning in &mut self.warnings {
            if let Warning::Pinches { at, .. } = warning {
                *at = (Point::from(*at) + by).into();
            }
        }
        Ok(self)
    }

    /// What a reader must know.
    fn warned(&self) -> Result<Vec<Warning>, MethodError> {
        let mut warnings = Vec::new();
        match self.pinches()? {
            // What else is wrong comes of that.
            Some(pinches) => warnings.push(pinches),
            None => {
                of_film(self.extremal.as_ref(), &self.figures, &mut warnings);
                self.warn_of_folds(&mut warnings);
            }
        }
        let area = self.figures.area.value;
        if let Some(discs) = self.one_by_one.filter(|discs| *discs < area) {
            warnings.push(Warning::OneByOne { discs, area });
        }
        Ok(warnings)
    }

    fn warn_of_folds(&self, warnings: &mut Vec<Warning>) {
        if self.seams.folds() {
            let (faces, of) = (self.seams.folded.len(), self.complex.faces().len());
            warnings.push(Warning::Folded { faces, of, kink: self.seams.kink.map_or(0.0, |kink| kink.max) });
        }
        if let Some(edge) = self.seams.singular_edge {
            let ends = self.edge_name(edge).map(str::to_owned);
            warnings.push(Warning::KinkUndefined { ends });
        }
    }

    /// That an annulus pinches: it is unstable, or was left thin and not stationary. With layers around corners its faces are no rings; it
    /// had none unless it was a minimum without.
    fn pinches(&self) -> Result<Option<Warning>, MethodError> {
        let (Some(found), Way::Annulus, 0) = (&self.extremal, self.way, self.layers) else { return Ok(None) };
        let Some(waist) = pinch::thinnest(&self.complex)? else { return Ok(None) };
        let is_stuck = found.end != AreaEnd::Stationary && waist.length < PINCHING * waist.rim;
        let is_unstable = found.second_variation.is_some_and(|smallest| smallest < 0.0);
        let pinches = Warning::Pinches { length: waist.length, at: waist.middle.into() };
        Ok((is_stuck || is_unstable).then_some(pinches))
    }
}
