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
    pub fn name(self) -> &'static str {
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
