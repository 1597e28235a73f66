//! The unit of length that STEP files declare, and how near they hold a surface.

/// Largest distance of a fitted surface from the patch where none is asked for, as a share of the size.
pub const DEFAULT_TOLERANCE: f64 = 1e-6;

/// What a STEP file says its numbers are; they are written unchanged.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LengthUnit {
    /// Millimetres, for which CAD programs take numbers of no unit.
    #[default]
    Millimetre,
    /// Centimetres.
    Centimetre,
    /// Metres.
    Metre,
    /// Inches of 25.4 mm.
    Inch,
    /// Feet of 304.8 mm.
    Foot,
}

impl LengthUnit {
    /// Every unit with the name it is asked for by.
    pub const NAMED: [(&'static str, Self); 5] = [
        ("mm", Self::Millimetre),
        ("cm", Self::Centimetre),
        ("m", Self::Metre),
        ("inch", Self::Inch),
        ("ft", Self::Foot),
    ];

    /// Many of it, in words.
    #[must_use]
    pub fn plural(self) -> &'static str {
        match self {
            Self::Millimetre => "millimetres",
            Self::Centimetre => "centimetres",
            Self::Metre => "metres",
            Self::Inch => "inches",
            Self::Foot => "feet",
        }
    }
}

/// How STEP holds a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepForm {
    /// Largest distance of a fitted surface from the patch, as a share of the size.
    pub tolerance: f64,
    /// The unit of length.
    pub unit: LengthUnit,
}

impl Default for StepForm {
    fn default() -> Self {
        DEFAULT_TOLERANCE.into()
    }
}

impl From<f64> for StepForm {
    /// A fit within this share of the size, in millimetres.
    fn from(tolerance: f64) -> Self {
        Self { tolerance, unit: LengthUnit::default() }
    }
}
