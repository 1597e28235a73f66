//! Sentences that speak of settings, which whoever asks spells in his own way.

use std::fmt;

/// What may be set where curves are read, joined and fitted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Setting {
    /// How far apart ends may be that are made one.
    Weld,
    /// Turn in degrees above which polylines have corners.
    CornerAngle,
    /// How far curves may pass from samples.
    Tolerance,
    /// What the numbers of files are.
    Unit,
}

/// A sentence that may speak of settings.
///
/// As text it calls them by their names; [`told`](Self::told) has it in the words of a command line or of a program.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Sentence(Vec<Part>);

#[derive(Debug, Clone, PartialEq, Eq)]
enum Part {
    Text(String),
    Setting(Setting, Option<String>),
}

impl Setting {
    /// Its name in sentences.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Weld => "weld",
            Self::CornerAngle => "corner angle",
            Self::Tolerance => "tolerance",
            Self::Unit => "unit",
        }
    }
}

impl Sentence {
    /// The sentence with more text behind it.
    #[must_use]
    pub fn text(mut self, text: impl Into<String>) -> Self {
        self.0.push(Part::Text(text.into()));
        self
    }

    /// The sentence with a setting behind it.
    #[must_use]
    pub fn setting(mut self, setting: Setting) -> Self {
        self.0.push(Part::Setting(setting, None));
        self
    }

    /// The sentence with a setting and its value behind it.
    #[must_use]
    pub fn value(mut self, setting: Setting, value: impl Into<String>) -> Self {
        self.0.push(Part::Setting(setting, Some(value.into())));
        self
    }

    /// The sentence where settings, with a value or without, are spelled like this.
    ///
    /// ```
    /// use exchange::{Sentence, Setting};
    ///
    /// let sentence = Sentence::from("ends within ").value(Setting::Weld, "1e-4").text(" are one");
    /// assert_eq!(sentence.to_string(), "ends within weld 1e-4 are one");
    /// let spelled = |setting: Setting, value: Option<&str>| format!("--{} {}", setting.name(), value.unwrap_or_default());
    /// assert_eq!(sentence.told(&spelled), "ends within --weld 1e-4 are one");
    /// ```
    #[must_use]
    pub fn told(&self, spelled: &dyn Fn(Setting, Option<&str>) -> String) -> String {
        let part = |part: &Part| match part {
            Part::Text(text) => text.clone(),
            Part::Setting(setting, value) => spelled(*setting, value.as_deref()),
        };
        self.0.iter().map(part).collect()
    }
}

impl fmt::Display for Sentence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let spelled = |setting: Setting, value: Option<&str>| match value {
            Some(value) => format!("{} {value}", setting.name()),
            None => setting.name().to_owned(),
        };
        f.write_str(&self.told(&spelled))
    }
}

impl From<String> for Sentence {
    fn from(text: String) -> Self {
        Self::default().text(text)
    }
}

impl From<&str> for Sentence {
    fn from(text: &str) -> Self {
        Self::default().text(text)
    }
}
