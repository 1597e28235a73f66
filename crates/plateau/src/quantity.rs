//! The figures of a result by name.

use std::fmt;

/// A figure of a result, named as in `result.json` but in kebab-case.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Quantity {
    /// `dirichlet`.
    Dirichlet,
    /// `area`.
    Area,
    /// `laplacian-defect`.
    LaplacianDefect,
    /// `bending`.
    Bending,
    /// `conformality-gap`.
    ConformalityGap,
    /// `mean-curvature-max`: `mean_curvature.max_abs` of the result.
    MeanCurvatureMax,
    /// `mean-curvature-rms`: `mean_curvature.rms` of the result.
    MeanCurvatureRms,
    /// `residual`.
    Residual,
    /// `boundary-deviation`.
    BoundaryDeviation,
    /// `harmonic-bound`.
    HarmonicBound,
    /// `deviation`, of helicoids.
    Deviation,
    /// `shape`: the shape parameter of this index, in α1, α2, β1, β2.
    Shape(usize),
    /// `search-minimum`: the least best value of the search's runs.
    SearchMinimum,
    /// `curvature`, of curves: at the sample of this index.
    Curvature(usize),
}

impl Quantity {
    /// The name in experiment files (the same for every index).
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Dirichlet => "dirichlet",
            Self::Area => "area",
            Self::LaplacianDefect => "laplacian-defect",
            Self::Bending => "bending",
            Self::ConformalityGap => "conformality-gap",
            Self::MeanCurvatureMax => "mean-curvature-max",
            Self::MeanCurvatureRms => "mean-curvature-rms",
            Self::Residual => "residual",
            Self::BoundaryDeviation => "boundary-deviation",
            Self::HarmonicBound => "harmonic-bound",
            Self::Deviation => "deviation",
            Self::Shape(_) => "shape",
            Self::SearchMinimum => "search-minimum",
            Self::Curvature(_) => "curvature",
        }
    }

    /// The same figure at an index, if it has one.
    #[must_use]
    pub fn at(self, index: usize) -> Self {
        match self {
            Self::Shape(_) => Self::Shape(index),
            Self::Curvature(_) => Self::Curvature(index),
            Self::Dirichlet
            | Self::Area
            | Self::LaplacianDefect
            | Self::Bending
            | Self::ConformalityGap
            | Self::MeanCurvatureMax
            | Self::MeanCurvatureRms
            | Self::Residual
            | Self::BoundaryDeviation
            | Self::HarmonicBound
            | Self::Deviation
            | Self::SearchMinimum => self,
        }
    }
}

impl fmt::Display for Quantity {
    /// The name, with the index where there is one: `shape[2]`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Shape(k) | Self::Curvature(k) => write!(f, "{}[{k}]", self.name()),
            _ => f.write_str(self.name()),
        }
    }
}
