//! The check of a file: where a [`Plan`](super::Plan) is made or the faults are collected.

use std::ops::{Range, RangeInclusive};

use serde_spanned::Spanned;

use super::number::shown;
use crate::diagnostic::{Diagnostic, Fault, nearest};
use crate::spec::{Integer, Key, Number, Step, Text, shorten};

/// Faults met so far, and the text they are about.
pub(super) struct Check<'a> {
    pub(super) text: &'a str,
    diagnostics: Vec<Diagnostic>,
    removed: Vec<Vec<Step>>,
}

/// A table of the file, as messages name it.
#[derive(Clone, Debug)]
pub(super) struct Table {
    /// `[boundary]`, or `method "GT"`.
    pub(super) name: String,
    /// Its header.
    pub(super) span: Range<usize>,
    path: Vec<Step>,
    /// Whether some entry could not be read: then what seems missing may be that entry.
    pub(super) damaged: bool,
}

impl<'a> Check<'a> {
    pub(super) fn new(text: &'a str, diagnostics: Vec<Diagnostic>, removed: Vec<Vec<Step>>) -> Self {
        Self { text, diagnostics, removed }
    }

    pub(super) fn finish(self) -> Vec<Diagnostic> {
        self.diagnostics
    }

    pub(super) fn report(&mut self, diagnostic: Diagnostic) {
        self.diagnostics.push(diagnostic);
    }

    /// The table at `path`, whose header is at `span`.
    pub(super) fn table(&self, name: impl Into<String>, span: Range<usize>, path: &[Step]) -> Table {
        let damaged =
            self.removed.iter().any(|removed| removed.len() == path.len() + 1 && removed.starts_with(path));
        Table { name: name.into(), span, path: path.to_vec(), damaged }
    }

    /// A table inside another one.
    pub(super) fn inner(
        &self,
        outer: &Table,
        name: impl Into<String>,
        span: Range<usize>,
        steps: &[Step],
    ) -> Table {
        self.table(name, span, &[outer.path.as_slice(), steps].concat())
    }

    /// Whether the entry at exactly `path` could not be read.
    pub(super) fn was_removed(&self, path: &[Step]) -> bool {
        self.removed.iter().any(|removed| removed == path)
    }

    /// The value of a key that must be there.
    pub(super) fn required<'s, T>(
        &mut self,
        table: &Table,
        name: &str,
        key: &'s Key<T>,
        help: &str,
    ) -> Option<&'s Spanned<T>> {
        if key.is_none() {
            self.missing(table, name, help);
        }
        key.as_ref()
    }

    pub(super) fn missing(&mut self, table: &Table, name: &str, help: &str) {
        if !table.damaged {
            self.report(
                Diagnostic::at(
                    Fault::Missing,
                    table.span.clone(),
                    format!("{} lacks `{name}`", table.name),
                    format!("`{name}` is needed here"),
                )
                .help(help),
            );
        }
    }

    pub(super) fn inadmissible(
        &mut self,
        span: Range<usize>,
        message: impl Into<String>,
        label: impl Into<String>,
        help: impl Into<String>,
    ) {
        self.report(Diagnostic::at(Fault::Inadmissible, span, message, label).help(help));
    }

    /// `span` and `other` do not fit together.
    pub(super) fn conflict(
        &mut self,
        (span, label): (Range<usize>, &str),
        (other, other_label): (Range<usize>, &str),
        message: impl Into<String>,
        help: impl Into<String>,
    ) {
        self.report(
            Diagnostic::at(Fault::Conflict, span, message, label).beside(other, other_label).help(help),
        );
    }

    /// A whole number in an interval.
    pub(super) fn count(
        &mut self,
        table: &Table,
        name: &str,
        key: &Spanned<Integer>,
        admitted: RangeInclusive<usize>,
        help: &str,
    ) -> Option<usize> {
        let value = key.get_ref().0;
        match usize::try_from(value) {
            Ok(count) if admitted.contains(&count) => Some(count),
            _ => {
                let (least, most) = admitted.into_inner();
                self.inadmissible(
                    key.span(),
                    format!("`{name}` in {} must lie between {least} and {most}", table.name),
                    format!("this is {value}"),
                    help,
                );
                None
            }
        }
    }

    /// A finite number that satisfies `admitted`, which `set` describes ("in [0, 1]").
    pub(super) fn number(
        &mut self,
        table: &Table,
        name: &str,
        key: &Spanned<Number>,
        (admitted, set): (impl Fn(f64) -> bool, &str),
        help: &str,
    ) -> Option<f64> {
        let value = key.get_ref().0;
        if value.is_finite() && admitted(value) {
            return Some(value);
        }
        let set = if value.is_finite() { set } else { "finite" };
        self.inadmissible(
            key.span(),
            format!("`{name}` in {} must be {set}", table.name),
            format!("this is {}", shown(value)),
            help,
        );
        None
    }

    /// One of several names.
    pub(super) fn choice<T: Copy>(
        &mut self,
        table: &Table,
        name: &str,
        key: &Spanned<Text>,
        names: &[(&str, T)],
    ) -> Option<T> {
        self.named(table, name, &key.get_ref().0, key.span(), names)
    }

    /// One of several names, given as text and place.
    pub(super) fn named<T: Copy>(
        &mut self,
        table: &Table,
        name: &str,
        word: &str,
        span: Range<usize>,
        names: &[(&str, T)],
    ) -> Option<T> {
        if let Some((_, value)) = names.iter().find(|(candidate, _)| *candidate == word) {
            return Some(*value);
        }
        let all: Vec<String> = names.iter().map(|(candidate, _)| format!("\"{candidate}\"")).collect();
        let mut diagnostic = Diagnostic::at(
            Fault::Inadmissible,
            span,
            format!("`{name}` in {} cannot be \"{}\"", table.name, shorten(word)),
            format!("expected {}", one_of(&all)),
        );
        diagnostic = match nearest(word, names.iter().map(|(candidate, _)| *candidate)) {
            Some(near) => diagnostic.help(format!("did you mean \"{near}\"?")),
            None => {
                let first = all.first().map_or("", String::as_str);
                // The one key that holds a list of names.
                let example = if name == "formats" { format!("[{first}]") } else { first.to_owned() };
                diagnostic.help(format!("write one of these names, as in {name} = {example}"))
            }
        };
        self.report(diagnostic);
        None
    }

    /// A text that is not blank.
    pub(super) fn name(
        &mut self,
        table: &Table,
        name: &str,
        key: &Spanned<Text>,
        help: &str,
    ) -> Option<String> {
        let text = &key.get_ref().0;
        if text.trim().is_empty() {
            self.inadmissible(
                key.span(),
                format!("`{name}` of {} is empty", table.name),
                "no name in it",
                help,
            );
            return None;
        }
        Some(text.clone())
    }
}

/// `a`, `a or b`, `a, b or c`.
pub(super) fn one_of(names: &[String]) -> String {
    match names {
        [] => String::new(),
        [one] => one.clone(),
        [most @ .., last] => format!("{} or {last}", most.join(", ")),
    }
}

/// The path of a top-level table.
pub(super) fn top(name: &str) -> Vec<Step> {
    vec![Step::Key(name.to_owned())]
}
