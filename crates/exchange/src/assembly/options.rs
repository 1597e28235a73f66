/// What is left open by a file of curves.
#[derive(Debug, Clone, PartialEq)]
pub struct AssemblyOptions {
    /// Ends of curves that lie at most this far apart are one point; by default as [`Self::reach`] says.
    pub weld: Option<f64>,
    /// A polyline has a corner where its direction turns by more than this, in degrees from 1 to 179.
    pub corner_angle: f64,
}

impl AssemblyOptions {
    /// Share of the size (the diagonal of the box around all curves) within which ends are welded: other programs write ends to few
    /// digits, or have them picked by hand. What is written for plateau itself is held to [`plateau::Loop::WELD`].
    pub const WELD: f64 = 1e-4;
    /// Share of the shortest edge near a gap above which the gap may be a side that is left out, or the last of a closed polygon.
    pub const SHORT: f64 = 0.25;
    /// Turn in degrees above which a polyline has a corner, as samples have wherever they come from.
    pub const CORNER_ANGLE: f64 = surfaces::Samples::CORNER_DEGREES;

    /// How far apart two ends may lie that are made one (a length): what was asked for; else [`Self::WELD`] of the size, but no more than
    /// [`Self::SHORT`] of the shortest edge of the curves that end there.
    pub fn reach(&self, size: f64, shortest_edge: f64) -> f64 {
        self.weld.unwrap_or_else(|| f64::min(Self::WELD * size, Self::SHORT * shortest_edge))
    }
}

impl Default for AssemblyOptions {
    fn default() -> Self {
        Self { weld: None, corner_angle: Self::CORNER_ANGLE }
    }
}
