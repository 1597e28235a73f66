//! What an experiment file may be at most.

/// Largest size in bytes of an experiment file.
///
/// Four sides of degree 64 with 17 digits a number take 20 kB, a thousand expected numbers 60 kB, 40 000 samples of a
/// curve 1 MB.
pub const MAX_FILE_SIZE: u64 = 1024 * 1024;

/// Most keys, dots of dotted keys, headers and inline tables of an experiment file, all together.
pub const MAX_KEYS: usize = 10_000;

/// Most tokens (names, numbers, texts, commas, brackets, line ends, …) of an experiment file.
pub const MAX_TOKENS: usize = 300_000;
