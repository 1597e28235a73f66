//! An axis: what varies, and through which values.

use std::collections::HashSet;
use std::ops::Range;
use std::path::Path;

use serde_spanned::Spanned;

use super::address::Address;
use super::frame::{Frame, frames};
use super::range::Taken;
use crate::keys::GEOMETRY;
use crate::keys::sweep::axis::{
    BOUNDARIES, BY, COUNT, FROM, KEY, LABELS, NAME, SCALE, SPACING, TO, VALUES, WITH,
};
use crate::keys::sweep::{Stretch, Written};
use crate::text::{Faults, Given, Table, shown};
use plateau::counted;

/// Most characters of the name of an axis, and of a label.
const LONGEST: usize = 32;

/// An axis of a sweep.
#[derive(Clone, Debug)]
pub struct Axis {
    name: String,
    settings: Vec<Setting>,
    with: Option<usize>,
    pub(super) action: Action,
    /// The name of the axis it goes in step with, as the file says it.
    pub(super) partner: Option<Spanned<String>>,
    /// Where its table begins.
    pub(super) span: Range<usize>,
}

/// One value of an axis.
#[derive(Clone, Debug)]
pub struct Setting {
    label: String,
    number: Option<f64>,
    /// As the cell writes it.
    pub(super) text: String,
    /// Where the file says it.
    pub(super) span: Range<usize>,
}

/// What the values of an axis do.
#[derive(Clone, Debug)]
pub(super) enum Action {
    /// They stand in the place of what these lead to.
    Replace(Vec<Spanned<Address>>),
    /// They multiply coordinates of the boundary.
    Scale(Spanned<Stretch>),
    /// They are boundaries of other files.
    Boundaries(Vec<Frame>),
}

impl Axis {
    /// What varies.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its values, at least one.
    #[must_use]
    pub fn settings(&self) -> &[Setting] {
        &self.settings
    }

    /// The axis with which it goes in step, by its place among all; none for a direction of its own.
    #[must_use]
    pub fn with(&self) -> Option<usize> {
        self.with
    }

    /// Whether its values have boundaries of their own: what is least among them says nothing.
    #[must_use]
    pub fn moves_the_boundary(&self) -> bool {
        match &self.action {
            Action::Scale(_) | Action::Boundaries(_) => true,
            Action::Replace(addresses) => addresses
                .iter()
                .any(|address| address.get_ref().outermost().is_some_and(|table| GEOMETRY.contains(&table))),
        }
    }

    /// Goes in step with an axis from now on.
    pub(super) fn go_with(&mut self, other: usize) {
        self.with = Some(other);
    }
}

impl Setting {
    /// What it is called in names and tables; letters, digits and `-+._` and blanks alone.
    #[must_use]
    pub fn label(&self) -> &str {
        &self.label
    }

    /// Its number, if it is one.
    #[must_use]
    pub fn number(&self) -> Option<f64> {
        self.number
    }
}

/// An axis from its table; what is wrong with it is reported. `folder` is that of the file.
pub(super) fn axis(table: &Table<'_>, folder: &Path) -> Option<Axis> {
    let name = table.require(&NAME);
    let (keys, scale, boundaries) = (table.take(&KEY), table.take(&SCALE), table.take(&BOUNDARIES));
    let (written, labels, partner) = (Taken::of(table), table.take(&LABELS), table.take(&WITH));
    let (labels, partner) = (labels.known()?, partner.known()?);
    let faults = table.faults();
    let name = name?;
    if let Some(help) = unfit(name.get_ref()) {
        faults.inadmissible(
            name.span(),
            "the name of an axis begins the names of folders",
            "not in them",
            help,
        );
        return None;
    }
    let (action, written) = match (keys, scale, boundaries) {
        (Given::Sound(keys), Given::Absent, Given::Absent) => {
            let addresses = addresses(faults, keys.into_inner());
            let written = written.values(table);
            (Action::Replace(addresses?), written?)
        }
        (Given::Absent, Given::Sound(scale), Given::Absent) => {
            let written = written.values(table)?;
            factors(faults, &written)?;
            (Action::Scale(scale), written)
        }
        (Given::Absent, Given::Absent, Given::Sound(named)) => {
            without_values(table)?;
            let frames = frames(faults, &named, folder)?;
            let written = frames.iter().map(|frame| {
                let written = Written { text: String::new(), number: None, word: Some(frame.name.clone()) };
                Spanned::new(named.span(), written)
            });
            let written = written.collect();
            (Action::Boundaries(frames), written)
        }
        (Given::Faulty, _, _) | (_, Given::Faulty, _) | (_, _, Given::Faulty) => return None,
        (Given::Absent, Given::Absent, Given::Absent) => {
            table.missing(
                "key",
                "say what varies: key = \"method.*.raise\", scale = \"z\", or boundaries = \"folder\"",
            );
            return None;
        }
        (keys, scale, boundaries) => {
            two_kinds(faults, [keys.span(), scale.span(), boundaries.span()]);
            return None;
        }
    };
    let settings = settings(faults, written, labels)?;
    Some(Axis {
        name: name.into_inner().trim().to_owned(),
        settings,
        with: None,
        action,
        partner,
        span: table.span(),
    })
}

/// Says that an axis varies two things at once.
fn two_kinds(faults: &Faults<'_>, spans: [Option<Range<usize>>; 3]) {
    let spans: Vec<_> = spans.into_iter().flatten().collect();
    if let [first, second, ..] = spans.as_slice() {
        let message = "an axis has one of `key`, `scale` and `boundaries`";
        let help = "write an axis for each; with = \"…\" lets one go in step with another";
        faults.conflict((second.clone(), "the second"), (first.clone(), "the first"), message, help);
    }
}

/// What to do about a name or a label that could not stand in the name of a folder.
fn unfit(name: &str) -> Option<String> {
    let name = name.trim();
    let admitted = |c: char| c.is_alphanumeric() || "-+._ ".contains(c);
    if name.chars().count() > LONGEST {
        return Some(format!("take at most {LONGEST} characters"));
    }
    (!name.chars().all(admitted)).then(|| "take letters, digits, blanks and - + . _ alone".to_owned())
}

fn addresses(faults: &Faults<'_>, texts: Vec<Spanned<String>>) -> Option<Vec<Spanned<Address>>> {
    let mut sound = Vec::with_capacity(texts.len());
    for text in texts {
        match Address::parse(text.get_ref()) {
            Ok(address) => sound.push(Spanned::new(text.span(), address)),
            Err(lost) => {
                let message = format!("`key` leads to no key: {}", lost.why);
                faults.inadmissible(text.span(), message, "this key", lost.remedy);
                return None;
            }
        }
    }
    Some(sound)
}

/// Values that multiply must be numbers.
fn factors(faults: &Faults<'_>, written: &[Spanned<Written>]) -> Option<()> {
    let Some(other) = written.iter().find(|value| value.get_ref().number.is_none()) else { return Some(()) };
    faults.inadmissible(
        other.span(),
        "the values of an axis with `scale` multiply coordinates",
        "this is not a number",
        "write numbers: values = [0.5, 1, 2]",
    );
    None
}

/// Boundaries of files need no values.
fn without_values(table: &Table<'_>) -> Option<()> {
    let stray = [VALUES.name(), FROM.name(), TO.name(), COUNT.name(), BY.name(), SPACING.name()]
        .into_iter()
        .find_map(|key| Some((key, table.place(&[key])?)));
    let Some((key, span)) = stray else { return Some(()) };
    let message = format!("`{key}` stands beside `boundaries`");
    table.faults().clash(
        (span, "not needed"),
        message,
        "take it out: the files of the folder are the values",
    );
    None
}

/// The values with their labels, which must differ.
fn settings(
    faults: &Faults<'_>,
    written: Vec<Spanned<Written>>,
    labels: Option<Spanned<Vec<Spanned<String>>>>,
) -> Option<Vec<Setting>> {
    if let Some(labels) = labels.as_ref().filter(|labels| labels.get_ref().len() != written.len()) {
        faults.inadmissible(
            labels.span(),
            format!(
                "an axis of {} has {}",
                counted(written.len(), "value"),
                counted(labels.get_ref().len(), "label")
            ),
            "one for each value",
            "write as many labels as values, or take them out",
        );
        return None;
    }
    let mut taken = HashSet::new();
    let mut settings = Vec::with_capacity(written.len());
    for (k, value) in written.into_iter().enumerate() {
        let given = labels.as_ref().map(|labels| &labels.get_ref()[k]);
        if let Some((given, help)) = given.and_then(|given| Some((given, unfit(given.get_ref())?))) {
            faults.inadmissible(given.span(), "a label stands in the names of folders", "not in them", help);
            return None;
        }
        let span = given.map_or(value.span(), Spanned::span);
        let Written { text, number, word } = value.into_inner();
        let label = given.map(|given| given.get_ref().trim().to_owned());
        let label = label.unwrap_or_else(|| label_of(&text, number, word.as_deref(), k));
        // Some disks do not tell capitals apart.
        if !taken.insert(label.to_uppercase().to_lowercase()) {
            let message = format!("two values of an axis are called `{label}`");
            let help = "take one of them out, or give each a label: labels = [\"first\", \"second\"]";
            faults.inadmissible(span, message, "the second", help);
            return None;
        }
        settings.push(Setting { label, number, text, span });
    }
    Some(settings)
}

/// What a value without a label is called.
fn label_of(text: &str, number: Option<f64>, word: Option<&str>, k: usize) -> String {
    let whole = text.replace('_', "").parse::<i128>().ok().map(|whole| whole.to_string());
    let label = whole.or(number.map(shown)).or(word.map(|word| word.trim().to_owned()));
    label
        .filter(|label| !label.is_empty() && unfit(label).is_none())
        .unwrap_or_else(|| format!("no. {}", k + 1))
}
