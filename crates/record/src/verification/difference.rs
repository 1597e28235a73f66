use serde::Serialize;

/// How closely a result is compared with its repetition.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(tag = "level", rename_all = "kebab-case")]
pub enum Level {
    /// Every number and text of the record, bit for bit: program and processor are those that wrote it.
    Bits,
    /// The figures and nets, within [`Level::TOLERANCE`] of themselves; where a search or Newton steps led to them, only the
    /// energy that was minimised is as well determined, everything else within [`Level::SEARCHED`].
    Figures {
        /// In what the program or the processor differs from the one that wrote the result.
        because: Vec<&'static str>,
    },
}

impl Level {
    /// Relative, and a thousandth of it times the size of the net for numbers that are zero but for rounding.
    pub const TOLERANCE: f64 = 1e-9;
    /// The same for what is only as well determined as the place of a flat minimum: to the root of its energy's accuracy.
    pub const SEARCHED: f64 = 1e-5;
}

/// One part of a result, compared.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct Verified {
    /// The name of the method, `curve` or `record`.
    pub name: String,
    /// How many numbers and texts were compared.
    pub compared: usize,
    /// Where the two differ, in the order of the record.
    pub differences: Vec<Difference>,
    /// Whether they differ bit for bit, but not as [`Level::Figures`] compares: another model of the processor may do that to
    /// large systems.
    pub differs_in_bits_only: bool,
    /// Whether the record itself says that the area is all but constant along what remains of the gradient: the points may lie
    /// elsewhere within the same surface, and figures that depend on where they lie were not compared as [`Level::Figures`].
    pub slides: bool,
}

/// A place where a result and its repetition differ.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[non_exhaustive]
pub struct Difference {
    /// The key, from the method, the curve or the root of the record.
    pub key: String,
    /// What the file says; none if it has no such key.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stored: Option<String>,
    /// What was computed; none if there is no such key.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub computed: Option<String>,
}
