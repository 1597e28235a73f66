//! Whether the mode of a record has the second variation that the record says.

use serde::Deserialize;
use serde_json::Value;

use super::{Difference, Level};
use crate::result::ModeEntry;
use crate::stored::method;

/// The difference between the second variation of a stored method and that of its stored mode over its stored surface; none if
/// it has no mode, or they agree within [`Level::SEARCHED`].
pub(super) fn contradiction(stored: &Value) -> Option<Difference> {
    let mode = stored.pointer("/area_extremal/mode")?;
    let said = stored.pointer("/area_extremal/second_variation").and_then(Value::as_f64);
    let found = quotient(stored, mode);
    let agree = said.zip(found).is_some_and(|(said, found)| (said - found).abs() <= Level::SEARCHED);
    (!agree).then(|| Difference {
        key: "area_extremal.mode".into(),
        stored: said.map(|said| format!("of the second variation {said}")),
        computed: found.map(|found| format!("of {found}")),
    })
}

/// The second variation of a mode over the surface of a method.
fn quotient(stored: &Value, mode: &Value) -> Option<f64> {
    let (_, made) = method(stored.clone(), "method").ok()?;
    let (surface, _) = made.ok()?;
    ModeEntry::deserialize(mode).ok()?.of_surface(&surface)?.second_variation(&surface).ok()?
}
