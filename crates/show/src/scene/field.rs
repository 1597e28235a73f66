use surfaces::Jet;

/// A number at every point of a surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Field {
    /// Mean curvature H.
    Mean,
    /// Gauss curvature K.
    Gauss,
    /// ‖x_uu + x_vv‖: 0 for harmonic charts.
    Laplacian,
    /// ½(E + G)/√(EG − F²) − 1: 0 where the chart is conformal.
    Conformality,
    /// The displacement of the mode of the second variation, 1 where it is largest: known of least areas.
    Mode,
}

impl Field {
    /// All fields, in the order of the report.
    pub(crate) const ALL: [Self; 5] =
        [Self::Mean, Self::Gauss, Self::Laplacian, Self::Conformality, Self::Mode];

    /// Its symbol.
    pub(crate) fn symbol(self) -> &'static str {
        match self {
            Self::Mean => "H",
            Self::Gauss => "K",
            Self::Laplacian => "|ΔS|",
            Self::Conformality => "½(E+G)/√(EG−F²) − 1",
            Self::Mode => "f",
        }
    }

    /// Its name.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Mean => "mean curvature",
            Self::Gauss => "Gauss curvature",
            Self::Laplacian => "Laplacian of the chart",
            Self::Conformality => "conformality defect",
            Self::Mode => "displacement of the mode",
        }
    }

    /// Its unit; empty for pure numbers.
    pub(crate) fn unit(self) -> &'static str {
        match self {
            Self::Mean => "1/length",
            Self::Gauss => "1/length²",
            Self::Laplacian => "length",
            Self::Conformality | Self::Mode => "",
        }
    }

    /// Whether it has both signs.
    pub(crate) fn is_signed(self) -> bool {
        matches!(self, Self::Mean | Self::Gauss | Self::Mode)
    }

    /// It scales as this power of a length.
    pub(crate) fn length_exponent(self) -> i32 {
        match self {
            Self::Mean => -1,
            Self::Gauss => -2,
            Self::Laplacian => 1,
            Self::Conformality | Self::Mode => 0,
        }
    }

    /// What rounding may leave of it on a surface of unit size where it vanishes, if `flat` remains of H.
    pub(crate) fn rounding(self, flat: f64) -> f64 {
        match self {
            Self::Gauss => flat * flat,
            Self::Mean | Self::Laplacian | Self::Conformality | Self::Mode => flat,
        }
    }

    /// Its value; none where the surface is singular or the value is not finite, and of what a jet does not tell.
    pub(crate) fn of(self, jet: &Jet) -> Option<f64> {
        let value = match self {
            Self::Mean => jet.mean_curvature()?,
            Self::Gauss => jet.gauss_curvature()?,
            Self::Laplacian => jet.laplacian().norm(),
            Self::Conformality => {
                jet.normal()?;
                jet.dirichlet_density() / jet.area_density() - 1.0
            }
            Self::Mode => return None,
        };
        value.is_finite().then_some(value)
    }
}
