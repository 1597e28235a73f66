//! How a boundary is filled.

use std::ops::RangeInclusive;

use crate::{Cutting, MethodError, TOLERANCES, Way};

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
    pub(super) degree: Option<usize>,
    pub(super) energy: FillEnergy,
    pub(super) tolerance: f64,
    pub(super) rim_tolerance: Option<f64>,
    pub(super) corner_angle: f64,
    pub(super) way: Option<Way>,
    pub(super) layers: usize,
    pub(super) accuracy: Option<f64>,
    pub(super) bound: bool,
    pub(super) mesh: Meshing,
}

/// How fine the mesh of a film is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Meshing {
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

impl Fill {
    /// The relative decrease of the area that counts as none.
    pub const TOLERANCE: f64 = 1e-9;

    /// Share of the size of the boundary by which its rim may deviate from curves that cannot be met exactly.
    pub const RIM_TOLERANCE: f64 = 1e-6;

    /// The shares of the least area that [`with_accuracy`](Self::with_accuracy) is for.
    pub const ACCURACIES: RangeInclusive<f64> = TOLERANCES;

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
    pub fn with_rim_tolerance(mut self, tolerance: impl Into<Option<f64>>) -> Self {
        self.rim_tolerance = tolerance.into();
        self
    }

    /// See [`with_rim_tolerance`](Self::with_rim_tolerance).
    #[must_use]
    pub fn rim_tolerance(&self) -> Option<f64> {
        self.rim_tolerance
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
    /// because of odd corners, they get a layer of smaller patches. Curves that cannot be met exactly are met within a tenth of this share of the size, if
    /// twice as many edges are enough for it; samples keep the tolerance of theirs.
    #[must_use]
    pub fn with_accuracy(mut self, accuracy: impl Into<Option<f64>>) -> Self {
        self.accuracy = accuracy.into();
        self
    }

    /// Whether a lower bound of the area is to be proved, see [`lower_bound`](crate::lower_bound()).
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

    /// What no boundary is filled with.
    ///
    /// # Errors
    /// [`MethodError::Setting`] for a degree of 0 and lengths, shares and angles that are not above 0.
    pub(super) fn check(&self) -> Result<(), MethodError> {
        let given = [
            ("degree", self.degree.map(|degree| degree as f64)),
            ("tolerance", Some(self.tolerance)),
            ("tolerance of the rim", self.rim_tolerance),
            ("corner angle", Some(self.corner_angle)),
            ("accuracy", self.accuracy),
        ];
        let wrong = |value: f64| !(value > 0.0 && value.is_finite());
        match given.into_iter().find_map(|(name, value)| Some((name, value.filter(|&value| wrong(value))?))) {
            Some((name, value)) => Err(MethodError::Setting { name, value }),
            None => Ok(()),
        }
    }
}
