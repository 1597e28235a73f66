/// What is left open by a file of curves.
#[derive(Debug, Clone, PartialEq)]
pub struct AssemblyOptions {
    /// Ends of curves that lie at most this far apart are one point; by default [`Self::WELD`] of the size.
    pub weld: Option<f64>,
    /// A polyline has a corner where its direction turns by more than this, in degrees from 1 to 179.
    pub corner_angle: f64,
}

impl AssemblyOptions {
    /// Share of the size (the diagonal of the box around all curves) within which ends are welded: other programs write ends to few
    /// digits, or have them picked by hand. What is written for plateau itself is held to [`plateau::Loop::WELD`].
    pub const WELD: f64 = 1e-4;
    /// Turn in degrees above which a polyline has a corner, as samples have wherever they come from.
    pub const CORNER_ANGLE: f64 = surfaces::Samples::CORNER_DEGREES;
}

impl Default for AssemblyOptions {
    fn default() -> Self {
        Self { weld: None, corner_angle: Self::CORNER_ANGLE }
    }
}
