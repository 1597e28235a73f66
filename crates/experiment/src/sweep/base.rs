//! The file without its [sweep]: the text that all cells have in common, and where they differ.

use std::ops::Range;

use serde_json::Value as Json;
use toml::de::{DeTable, DeValue};

use super::address::Lost;
use super::axis::{Action, Axis, Setting};
use super::frame::{Frame, is_of_boundary};
use super::segment::segments;
use super::stretch::{Unstretched, stretched};
use crate::diagnostic::{Diagnostic, Fault};
use crate::keys::EXPERIMENT;
use crate::text::parse;

/// A text and its places that differ from cell to cell.
#[derive(Clone, Debug)]
pub(super) struct Base {
    text: String,
    /// Where in the text each part begins, in order, and where that stood.
    origins: Vec<(usize, Origin)>,
    /// In order, apart from one another.
    edits: Vec<Edit>,
}

/// Where something stood.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Origin {
    /// At this byte of the file of the sweep.
    File(usize),
    /// At this byte of the file of the boundary.
    Frame(usize),
}

/// A place that differs.
#[derive(Clone, Debug)]
struct Edit {
    range: Range<usize>,
    change: Change,
}

#[derive(Clone, Debug)]
enum Change {
    /// The value of an axis.
    Value(usize),
    /// This number times the value of an axis.
    Times(usize, f64),
    /// The title, to which the name of the cell is added.
    Title(String),
}

/// The text of a cell.
pub(super) struct Edited {
    pub(super) text: String,
    /// The places that were written anew, in order, with the index of the edit.
    spans: Vec<(Range<usize>, usize)>,
}

/// What stands at a place of a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Cause {
    /// The value of an axis.
    Axis(usize),
    /// What was there before.
    Kept(Origin),
}

impl Base {
    /// The text without its [sweep]; with the boundary of `frame` instead of its own, if there is one.
    pub(super) fn of(text: &str, frame: Option<&Frame>) -> Self {
        let mut base =
            Self { text: String::with_capacity(text.len()), origins: Vec::new(), edits: Vec::new() };
        for segment in segments(text) {
            if segment.table != "sweep" && !(frame.is_some() && is_of_boundary(&segment.table)) {
                base.add(text, segment.range, Origin::File);
            }
        }
        for segment in frame.iter().flat_map(|frame| segments(&frame.text)) {
            if is_of_boundary(&segment.table) {
                base.add(frame.map_or("", |frame| &frame.text), segment.range, Origin::Frame);
            }
        }
        base
    }

    fn add(&mut self, text: &str, range: Range<usize>, origin: fn(usize) -> Origin) {
        if !self.text.is_empty() && !self.text.ends_with('\n') {
            self.text.push('\n');
        }
        self.origins.push((self.text.len(), origin(range.start)));
        self.text.push_str(&text[range]);
    }

    /// How many bytes it has.
    pub(super) fn len(&self) -> usize {
        self.text.len()
    }

    /// Finds the places that the axes change.
    ///
    /// # Errors
    /// What is wrong with an axis, at its place in the file of the sweep.
    pub(super) fn prepare(&mut self, axes: &[Axis]) -> Result<(), Box<Diagnostic>> {
        let text = std::mem::take(&mut self.text);
        let found = parse(&text, &EXPERIMENT)
            .map_err(|faults| Box::new(self.unfit(axes, faults.into_iter().next())))
            .and_then(|document| edits(document.get_ref(), &text, axes));
        self.text = text;
        self.edits = found?;
        self.edits.sort_by_key(|edit| (edit.range.start, edit.range.end));
        self.are_apart(axes)
    }

    /// The text of a file and a boundary that do not go together, or of a file that is none without its [sweep].
    fn unfit(&self, axes: &[Axis], fault: Option<Diagnostic>) -> Diagnostic {
        let why = fault.map_or(String::new(), |fault| fault.message().to_owned());
        let span = axes.first().map_or(0..0, |axis| axis.span.clone());
        Diagnostic::at(Fault::Conflict, span, format!("without [sweep] the file is no experiment: {why}"), "")
            .help("write the tables of the experiment and of [sweep] under headers of their own")
    }

    fn are_apart(&self, axes: &[Axis]) -> Result<(), Box<Diagnostic>> {
        let Some(pair) = self.edits.windows(2).find(|pair| pair[1].range.start < pair[0].range.end) else {
            return Ok(());
        };
        let spans = [0, 1].map(|k| pair[k].change.axis().map_or(0..0, |axis| axes[axis].span.clone()));
        let names = [0, 1].map(|k| pair[k].change.axis().map_or("", |axis| axes[axis].name()));
        let [first, second] = spans;
        let message = if names[0] == names[1] {
            format!("the axis `{}` changes the same place twice", names[0])
        } else {
            format!("the axes `{}` and `{}` change the same place", names[0], names[1])
        };
        let fault = Diagnostic::at(Fault::Conflict, second, message, "this axis")
            .beside(first, "the other")
            .help("let one axis alone replace a value, or multiply it; with = \"…\" lets axes go in step");
        Err(Box::new(fault))
    }

    /// The text of a cell: `setting` is the value of every axis there, `name` what is added to the title.
    pub(super) fn edited<'a>(&self, setting: impl Fn(usize) -> &'a Setting, name: &str) -> Edited {
        let mut text = String::with_capacity(self.text.len() + 64);
        let (mut spans, mut at) = (Vec::with_capacity(self.edits.len()), 0);
        for (k, edit) in self.edits.iter().enumerate() {
            text.push_str(&self.text[at..edit.range.start]);
            let start = text.len();
            match &edit.change {
                Change::Value(axis) => text.push_str(&setting(*axis).text),
                Change::Times(axis, number) => {
                    let product = number * setting(*axis).number().unwrap_or(1.0);
                    text.push_str(&format!("{product:?}"));
                }
                Change::Title(title) => text.push_str(&quoted(&format!("{title} ({name})"))),
            }
            spans.push((start..text.len(), k));
            at = edit.range.end;
        }
        text.push_str(&self.text[at..]);
        Edited { text, spans }
    }

    /// What stands at a byte of a cell.
    pub(super) fn cause(&self, cell: &Edited, byte: usize) -> Cause {
        let before = cell.spans.iter().take_while(|(range, _)| range.start <= byte).last();
        let kept = match before {
            Some((range, k)) if byte < range.end.max(range.start + 1) => {
                let edit = &self.edits[*k];
                match edit.change.axis() {
                    Some(axis) => return Cause::Axis(axis),
                    None => edit.range.start,
                }
            }
            Some((range, k)) => self.edits[*k].range.end + (byte - range.end),
            None => byte,
        };
        let origin = self.origins.iter().take_while(|(start, _)| *start <= kept).last();
        Cause::Kept(match origin {
            Some((start, Origin::File(at))) => Origin::File(at + (kept - start)),
            Some((start, Origin::Frame(at))) => Origin::Frame(at + (kept - start)),
            None => Origin::File(kept),
        })
    }
}

impl Change {
    fn axis(&self) -> Option<usize> {
        match self {
            Self::Value(axis) | Self::Times(axis, _) => Some(*axis),
            Self::Title(_) => None,
        }
    }
}

/// A text in quotes, as TOML has it.
fn quoted(text: &str) -> String {
    // JSON escapes what TOML does, but for one character.
    Json::from(text).to_string().replace('\u{7f}', "\\u007f")
}

/// Every place that some axis changes, and the title.
fn edits(document: &DeTable<'_>, text: &str, axes: &[Axis]) -> Result<Vec<Edit>, Box<Diagnostic>> {
    let mut edits = Vec::new();
    for (k, axis) in axes.iter().enumerate() {
        match &axis.action {
            Action::Replace(addresses) => {
                for address in addresses {
                    let found = address.get_ref().resolve(document, text);
                    let found = found.map_err(|lost| Box::new(nothing_there(axis, address.span(), lost)))?;
                    edits.extend(found.into_iter().map(|range| Edit { range, change: Change::Value(k) }));
                }
            }
            Action::Scale(stretch) => {
                let numbers = stretched(document, *stretch.get_ref());
                let numbers = numbers.map_err(|why| Box::new(not_scaled(axis, stretch.span(), &why)))?;
                let times = |(range, number)| Edit { range, change: Change::Times(k, number) };
                edits.extend(numbers.into_iter().map(times));
            }
            Action::Boundaries(_) => {}
        }
    }
    if let Some(title) = document.get("title")
        && let DeValue::String(words) = title.get_ref()
        && !edits.iter().any(|edit| edit.range == title.span())
    {
        edits.push(Edit { range: title.span(), change: Change::Title(words.to_string()) });
    }
    Ok(edits)
}

fn nothing_there(axis: &Axis, span: Range<usize>, lost: Lost) -> Diagnostic {
    let message = format!("the axis `{}` has nothing to replace: {}", axis.name(), lost.why);
    Diagnostic::at(Fault::Inadmissible, span, message, "leads nowhere").help(lost.remedy)
}

fn not_scaled(axis: &Axis, span: Range<usize>, why: &Unstretched) -> Diagnostic {
    let message = format!("the axis `{}` cannot scale the boundary: {why}", axis.name());
    let help = "scale = \"size\" multiplies circles, too; `key` replaces single values";
    Diagnostic::at(Fault::Conflict, span, message, "this scale").help(help)
}
