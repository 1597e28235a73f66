//! Commented experiment files to begin with.

/// The experiments for which there is a template.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Template {
    /// Patches over a tensor boundary.
    Tensor,
    /// TB–Coons patches.
    TbCoons,
    /// Harmonic patches from two rows.
    Harmonic,
    /// Triangular patches.
    Triangle,
    /// Surfaces in loops.
    Loops,
    /// Surfaces of faces between curves.
    Faces,
    /// Generalized helicoids.
    Helicoid,
    /// Helicoids over a trapezium.
    TrapeziumHelicoid,
    /// Nets of one's own.
    Net,
    /// Curves.
    Curve,
}

impl Template {
    /// Every template.
    pub const ALL: [Self; 10] = [
        Self::Tensor,
        Self::TbCoons,
        Self::Harmonic,
        Self::Triangle,
        Self::Loops,
        Self::Faces,
        Self::Helicoid,
        Self::TrapeziumHelicoid,
        Self::Net,
        Self::Curve,
    ];

    /// The name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Tensor => "tensor",
            Self::TbCoons => "tb-coons",
            Self::Harmonic => "harmonic",
            Self::Triangle => "triangle",
            Self::Loops => "loops",
            Self::Faces => "faces",
            Self::Helicoid => "helicoid",
            Self::TrapeziumHelicoid => "trapezium-helicoid",
            Self::Net => "net",
            Self::Curve => "curve",
        }
    }

    /// What the template is about, in one line.
    #[must_use]
    pub fn summary(self) -> &'static str {
        match self {
            Self::Tensor => "Patches over four boundary rows: GT and Bernstein extremals, Coons, masks",
            Self::TbCoons => "TB–Coons patches, whose boundary curves do not move with the shape parameters",
            Self::Harmonic => "Harmonic patches from two opposite rows",
            Self::Triangle => "Triangular patches over three sides: extremals, masks, metric correction",
            Self::Loops => "Surfaces in one loop of any curves, or between two",
            Self::Faces => "Surfaces of several faces between curves: frames, tents, soap films",
            Self::Helicoid => "Generalized helicoids, exact in the AHT basis, and their deformation",
            Self::TrapeziumHelicoid => "Helicoids over a trapezium, exact in the AT basis",
            Self::Net => "The surface of a net of one's own, in any of the bases",
            Self::Curve => "One curve with its derivatives and curvature",
        }
    }

    /// The file: a sound experiment with comments that explain every key.
    ///
    /// ```
    /// for template in experiment::Template::ALL {
    ///     assert!(experiment::Plan::parse(template.name(), template.text()).is_ok());
    /// }
    /// ```
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::Tensor => include_str!("../templates/tensor.toml"),
            Self::TbCoons => include_str!("../templates/tb-coons.toml"),
            Self::Harmonic => include_str!("../templates/harmonic.toml"),
            Self::Triangle => include_str!("../templates/triangle.toml"),
            Self::Loops => include_str!("../templates/loops.toml"),
            Self::Faces => include_str!("../templates/faces.toml"),
            Self::Helicoid => include_str!("../templates/helicoid.toml"),
            Self::TrapeziumHelicoid => include_str!("../templates/trapezium-helicoid.toml"),
            Self::Net => include_str!("../templates/net.toml"),
            Self::Curve => include_str!("../templates/curve.toml"),
        }
    }
}
