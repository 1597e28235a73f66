/// Which arithmetic evaluates the reduced energy in searches.
///
/// The two round differently in the last digits, so that swarms take different paths; results are the same bit for bit
/// only on the same one, which every result names.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Arithmetic {
    /// The faster one of this machine.
    #[default]
    Auto,
    /// Separate multiplications and additions: the same bits on every machine.
    Portable,
    /// Fused multiply-add in vectors; an error where the machine does not have it.
    Fma,
}

impl Arithmetic {
    /// Every arithmetic.
    pub const ALL: [Self; 3] = [Self::Auto, Self::Portable, Self::Fma];

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::Portable => "portable",
            Self::Fma => "fma",
        }
    }
}
