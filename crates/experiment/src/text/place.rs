//! The key that is being read, and what is wrong with its value.

use toml::de::DeValue;

use super::faults::Faults;
use super::form::Form;
use super::head::Head;
use super::interval::Interval;
use super::number::shown;
use super::value::{self, TooLarge, Value};
use crate::diagnostic::{Diagnostic, Fault, nearest, shorten};
use plateau::counted;

/// The key that is being read.
pub(crate) struct Place<'p> {
    pub(super) faults: &'p Faults<'p>,
    /// Its table as the file heads it; empty for the file itself.
    pub(super) header: &'p str,
    /// Its table as messages call it; empty for the file itself.
    pub(super) called: &'p str,
    pub(super) key: &'p Head,
    pub(super) form: &'p dyn Form,
}

impl Place<'_> {
    pub(crate) fn faults(&self) -> &Faults<'_> {
        self.faults
    }

    /// `mesh` in [output].
    fn named(&self, table: &str) -> String {
        if table.is_empty() {
            format!("`{}`", self.key.name)
        } else {
            format!("`{}` in {table}", self.key.name)
        }
    }

    /// The key as messages call it.
    pub(crate) fn name(&self) -> String {
        self.named(self.called)
    }

    /// A value of another type than the key takes.
    pub(crate) fn wrong_type(&self, value: &Value<'_>, expected: &str) {
        let found = value::noun(value.get_ref());
        let message = format!("{} has a value of the wrong type", self.named(self.header));
        let help = match (value.get_ref(), expected) {
            (DeValue::String(_), "a number" | "a whole number") => {
                "take the quotes away: numbers stand without them".to_owned()
            }
            (DeValue::Float(_), "a whole number") => "write it without a decimal point".to_owned(),
            (found, _) => self.form.remedy(self.key, found).unwrap_or_else(|| self.key.remedy()),
        };
        let label = format!("expected {expected}; this is {found}");
        self.faults().report(Diagnostic::at(Fault::WrongType, value.span(), message, label).help(help));
    }

    /// A number beyond its type.
    pub(crate) fn too_large(&self, value: &Value<'_>) {
        self.faults().inadmissible(
            value.span(),
            format!("{} holds a number too large to be represented", self.named(self.header)),
            "too large",
            "whole numbers end at 2^63 - 1 and others at 1.8e308; coordinates are admitted up to 1e60: choose a larger unit",
        );
    }

    /// A value outside the admissible set: what the key must do, and what this is.
    pub(crate) fn inadmissible(&self, value: &Value<'_>, must: &str, label: impl Into<String>) {
        let message = format!("{} must {must}", self.name());
        self.faults().inadmissible(value.span(), message, label, self.key.remedy());
    }

    /// Whether a list is as long as is admitted.
    pub(super) fn has_length(
        &self,
        value: &Value<'_>,
        count: usize,
        (least, most): (usize, usize),
        noun: &str,
    ) -> bool {
        if (least..=most).contains(&count) {
            return true;
        }
        let wanted = match (count < least, least == most) {
            (_, true) => least.to_string(),
            (true, false) => format!("at least {least}"),
            (false, false) => format!("at most {most}"),
        };
        let found = counted(count, noun);
        let message = format!("{} has {found} instead of {wanted}", self.name());
        self.faults().inadmissible(value.span(), message, found, self.key.remedy());
        false
    }

    /// A number that is not too large; not yet judged.
    pub(super) fn real(&self, value: &Value<'_>) -> Option<f64> {
        match value::real(value.get_ref()) {
            Some(Ok(number)) => Some(number),
            Some(Err(TooLarge)) => {
                self.too_large(value);
                None
            }
            None => {
                self.wrong_type(value, "a number");
                None
            }
        }
    }

    /// A number in an interval.
    pub(crate) fn real_in(&self, value: &Value<'_>, interval: Interval) -> Option<f64> {
        let number = self.real(value)?;
        if interval.holds(number) {
            return Some(number);
        }
        let must = if number.is_finite() { interval } else { Interval::FINITE };
        self.inadmissible(value, &must.to_string(), format!("this is {}", shown(number)));
        None
    }

    /// One of several names.
    pub(crate) fn one_of<T: Copy>(&self, word: &str, value: &Value<'_>, names: &[(&str, T)]) -> Option<T> {
        if let Some((_, meant)) = names.iter().find(|(name, _)| *name == word) {
            return Some(*meant);
        }
        let message = format!("{} cannot be \"{}\"", self.name(), shorten(word));
        let label = format!("expected {}", alternatives(names));
        let help = match nearest(word, names.iter().map(|(name, _)| *name)) {
            Some(near) => format!("did you mean \"{near}\"?"),
            None => format!("write one of these names, as in {} = {}", self.key.name, self.key.example()),
        };
        self.faults().inadmissible(value.span(), message, label, help);
        None
    }
}

/// `"a"`, `"a" or "b"`, `"a", "b" or "c"`.
pub(super) fn alternatives<T>(names: &[(&str, T)]) -> String {
    let quoted: Vec<String> = names.iter().map(|(name, _)| format!("\"{name}\"")).collect();
    match quoted.as_slice() {
        [] => String::new(),
        [one] => one.clone(),
        [most @ .., last] => format!("{} or {last}", most.join(", ")),
    }
}
