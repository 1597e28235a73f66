//! A comparison as text, for people and for programs.

use std::path::Path;

use plateau::counted;
use serde::Serialize;
use show::{Printable, width_of_names};

use super::{Level, Verification, Verified};

/// Most differences of a method that are printed.
const SHOWN: usize = 5;

/// The document of `verify --json`.
#[derive(Serialize)]
struct Document<'a> {
    #[serde(flatten)]
    verification: &'a Verification,
    schema: &'static str,
    result: String,
    equal: bool,
}

impl Verification {
    /// The layout of [`Self::to_json`].
    pub const SCHEMA: &'static str = "plateau-verification/1";

    /// The comparison of the result in the file `result` as JSON, with a line break at its end.
    ///
    /// # Errors
    /// Never in fact: there is nothing in it that JSON cannot hold.
    pub fn to_json(&self, result: &Path) -> serde_json::Result<String> {
        let equal = self.agrees();
        let result = result.to_string_lossy().into_owned();
        // Keys in the order of the alphabet, whatever wrote them.
        let document =
            serde_json::to_value(Document { verification: self, schema: Self::SCHEMA, result, equal })?;
        Ok(serde_json::to_string_pretty(&document)? + "\n")
    }

    /// The comparison of the result in the file `result` as lines for a terminal: how closely, then a line an entry with what differs
    /// below it.
    #[must_use]
    pub fn report(&self, result: &Path) -> String {
        let title = Printable(&self.title).cut(Printable::TITLE);
        let mut lines = vec![format!("{}: {}", result.display(), title), self.level.sentence()];
        let width = width_of_names(self.entries.iter().map(|entry| entry.name.as_str()));
        for entry in &self.entries {
            entry.tell(&self.level, width, &mut lines);
        }
        lines.iter().map(|line| format!("{}\n", Printable(line))).collect()
    }
}

impl Level {
    fn sentence(&self) -> String {
        let (tolerance, searched) = (Self::TOLERANCE, Self::SEARCHED);
        match self {
            Self::Bits => "compared bit for bit: this program and this kind of processor wrote it".into(),
            Self::Figures { because } => format!(
                "{} not what it was written with: figures and nets are compared within {tolerance:e}, those a search led to within \
                 {searched:e}",
                list(because)
            ),
        }
    }
}

impl Verified {
    fn tell(&self, level: &Level, width: usize, lines: &mut Vec<String>) {
        let in_bits = *level == Level::Bits;
        let (name, values) = (Printable(&self.name).fitted(width), counted(self.compared, "value"));
        lines.push(match self.differences.len() {
            0 => format!("  {name}  {}, {values}", if in_bits { "equal" } else { "agrees" }),
            differing => format!("  {name}  DIFFERS in {differing} of {values}"),
        });
        if self.slides {
            let only = if in_bits { "" } else { ": its area was compared, and what does not depend on them" };
            lines.push(format!(
                "      its points are not determined, for the area is all but constant where they move{only}"
            ));
        }
        for difference in self.differences.iter().take(SHOWN) {
            let [stored, computed] =
                [&difference.stored, &difference.computed].map(|value| value.as_deref().unwrap_or("nothing"));
            lines.push(format!("      {}: the file has {stored}, computed is {computed}", difference.key));
        }
        if self.differs_in_bits_only {
            let (tolerance, searched) = (Level::TOLERANCE, Level::SEARCHED);
            lines.push(format!(
                "      its figures and nets agree within {tolerance:e} ({searched:e} after a search)"
            ));
        }
        if let Some(more @ 1..) = self.differences.len().checked_sub(SHOWN) {
            lines.push(format!("      and {more} more"));
        }
    }
}

/// Words as a list that begins a sentence.
fn list(words: &[&str]) -> String {
    match words.split_last() {
        Some((last, [])) if !last.ends_with('s') => format!("{last} here is"),
        Some((last, [])) => format!("{last} here are"),
        Some((last, rest)) => format!("{} and {last} here are", rest.join(", ")),
        None => String::new(),
    }
}
