//! What is built of a table as a whole.

use std::fmt::Display;
use std::ops::Range;

use crate::text::Table;

/// What was made of sound keys of a table; what the geometry refuses beyond their limits is reported at `place`.
pub(super) fn built<T>(table: &Table<'_>, place: Range<usize>, made: Result<T, impl Display>) -> Option<T> {
    made.map_err(|error| {
        let message = format!("{} cannot be used as it is: {error}", table.name());
        table.faults().inadmissible(place, message, "all of it together", "change its numbers");
    })
    .ok()
}
