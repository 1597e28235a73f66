//! A sweep and its cells.

use std::collections::HashSet;
use std::path::Path;

use plateau::Quantity;

use super::axis::{Action, Axis, Setting};
use super::base::{Base, Cause, Edited, Origin};
use super::read::{Parts, parts};
use crate::diagnostic::{Diagnostic, Refusal, position};
use crate::plan::{Plan, stem};

/// Faults of cells after which no more are looked for.
const MOST_FAULTS: usize = 10;

/// Many experiments of one file: all of them were read and are sound.
///
/// The cells are counted from 0, the last axis varies fastest. What a cell is called, its seed and its text depend on the
/// values of the axes alone.
#[derive(Clone, Debug)]
pub struct Sweep {
    file: String,
    text: String,
    parts: Parts,
}

/// One experiment of a sweep.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cell {
    /// The axes with their values, `height=0.5,degree=4`: the name of its folder.
    pub name: String,
    /// For every axis the place of its value.
    pub at: Vec<usize>,
}

impl Sweep {
    /// Checks the text of a sweep and every one of its cells; `file` names it in messages, folders of boundaries are seen from
    /// `folder`.
    ///
    /// ```
    /// let text = r#"
    /// title = "Half a turn of a helicoid"
    /// [trapezium-helicoid]
    /// span = 3.14159
    /// gamma = [0.0, 1.0]
    /// beta = [0.0, 0.0]
    /// [[sweep.axis]]
    /// name = "turn"
    /// key = "trapezium-helicoid.span"
    /// values = [1.5, 3.0]
    /// "#;
    /// let sweep = experiment::Sweep::parse("turns.toml", text, ".".as_ref()).unwrap();
    /// assert_eq!((sweep.cells(), sweep.cell(1).name.as_str()), (2, "turn=3"));
    /// assert!(sweep.plan(1)?.text.contains("span = 3.0"));
    /// # Ok::<(), experiment::Refusal>(())
    /// ```
    ///
    /// # Errors
    /// A [`Refusal`]; a fault in a cell is told at the value of the axis that makes it.
    pub fn parse(file: &str, text: &str, folder: &Path) -> Result<Self, Refusal> {
        let parts = parts(text, folder).map_err(|faults| Refusal::new(file, text, faults))?;
        let sweep = Self { file: file.to_owned(), text: text.to_owned(), parts };
        let faults = sweep.faults();
        if faults.is_empty() { Ok(sweep) } else { Err(Refusal::new(file, text, faults)) }
    }

    /// The name of its folder: the file name without its last extension.
    #[must_use]
    pub fn stem(&self) -> String {
        stem(&self.file)
    }

    /// The file name as it was given, for messages.
    #[must_use]
    pub fn file(&self) -> &str {
        &self.file
    }

    /// The file as read, byte for byte.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The title that the cells have in common.
    #[must_use]
    pub fn title(&self) -> &str {
        &self.parts.title
    }

    /// The figure that is compared.
    #[must_use]
    pub fn figure(&self) -> Quantity {
        self.parts.figure
    }

    /// Whether plots show how far it lies above the least.
    #[must_use]
    pub fn gap(&self) -> bool {
        self.parts.gap
    }

    /// Its axes in the order of the file, at least one.
    #[must_use]
    pub fn axes(&self) -> &[Axis] {
        &self.parts.axes
    }

    /// How many cells there are, at least one.
    #[must_use]
    pub fn cells(&self) -> usize {
        self.parts.cells
    }

    /// A cell; `index` is below [`Self::cells`].
    #[must_use]
    pub fn cell(&self, index: usize) -> Cell {
        let at = self.at(index);
        Cell { name: self.name(&at, "=", ","), at }
    }

    /// The experiment of a cell.
    ///
    /// # Errors
    /// Never in fact: all cells were sound when the sweep was read.
    pub fn plan(&self, index: usize) -> Result<Plan, Refusal> {
        let at = self.at(index);
        Plan::parse(&format!("{}.toml", self.name(&at, "=", ",")), &self.edited(&at).text)
    }

    /// The place of every axis' value in a cell: directions as the digits of its number, the last one fastest.
    fn at(&self, index: usize) -> Vec<usize> {
        let axes = &self.parts.axes;
        let mut at = vec![0; axes.len()];
        let mut rest = index;
        for (k, axis) in axes.iter().enumerate().rev().filter(|(_, axis)| axis.with().is_none()) {
            at[k] = rest % axis.settings().len();
            rest /= axis.settings().len();
        }
        for (k, axis) in axes.iter().enumerate() {
            if let Some(with) = axis.with() {
                at[k] = at[with];
            }
        }
        at
    }

    /// The directions with their labels.
    fn name(&self, at: &[usize], is: &str, and: &str) -> String {
        let directions = self.parts.axes.iter().zip(at).filter(|(axis, _)| axis.with().is_none());
        let parts: Vec<String> = directions
            .map(|(axis, &k)| format!("{}{is}{}", axis.name(), axis.settings()[k].label()))
            .collect();
        parts.join(and)
    }

    fn base(&self, at: &[usize]) -> &Base {
        let frames = |axis: &Axis| matches!(axis.action, Action::Boundaries(_));
        let of_frames = self.parts.axes.iter().position(frames);
        &self.parts.bases[of_frames.map_or(0, |axis| at[axis])]
    }

    fn edited(&self, at: &[usize]) -> Edited {
        let setting = |axis: usize| -> &Setting { &self.parts.axes[axis].settings()[at[axis]] };
        self.base(at).edited(setting, &self.name(at, " = ", ", "))
    }

    /// What is wrong with the cells, each fault once.
    fn faults(&self) -> Vec<Diagnostic> {
        let (mut faults, mut known) = (Vec::new(), HashSet::new());
        for index in 0..self.cells() {
            let at = self.at(index);
            let edited = self.edited(&at);
            let Err(refusal) = Plan::parse("cell.toml", &edited.text) else { continue };
            for fault in refusal.diagnostics() {
                let fault = self.told(&at, &edited, fault);
                if known.insert((fault.span(), fault.message().to_owned())) {
                    faults.push(fault);
                }
            }
            if faults.len() >= MOST_FAULTS {
                break;
            }
        }
        faults
    }

    /// A fault of a cell at its place in the file of the sweep.
    fn told(&self, at: &[usize], edited: &Edited, fault: &Diagnostic) -> Diagnostic {
        let name = self.name(at, " = ", ", ");
        let cause = fault.span().map(|span| {
            let axis = |byte| match self.base(at).cause(edited, byte) {
                Cause::Axis(axis) => Some(axis),
                Cause::Kept(_) => None,
            };
            // The place itself, or else one beside it that is the value of an axis.
            let of_axis = axis(span.start).or(fault.related().find_map(|span| axis(span.start)));
            (of_axis.map_or_else(|| self.base(at).cause(edited, span.start), Cause::Axis), span.len())
        });
        let (span, message, label) = match cause {
            Some((Cause::Axis(k), _)) => {
                let axis = &self.parts.axes[k];
                let setting = &axis.settings()[at[k]];
                let message = format!("{} = {}: {}", axis.name(), setting.label(), fault.message());
                (setting.span.clone(), message, fault.label().to_owned())
            }
            Some((Cause::Kept(Origin::File(byte)), length)) => {
                (byte..byte + length, fault.message().to_owned(), fault.label().to_owned())
            }
            Some((Cause::Kept(Origin::Frame(byte)), _)) => self.in_frame(at, byte, fault),
            None => (self.parts.span.clone(), fault.message().to_owned(), String::new()),
        };
        let end = self.text.len();
        let mut told = Diagnostic::at(fault.fault(), span.start.min(end)..span.end.min(end), message, label);
        for help in fault.remedies() {
            told = told.help(help.clone());
        }
        told.help(format!("this is the cell {name}"))
    }

    /// A fault in the file of a boundary, told at the axis.
    fn in_frame(
        &self,
        at: &[usize],
        byte: usize,
        fault: &Diagnostic,
    ) -> (std::ops::Range<usize>, String, String) {
        for (axis, &k) in self.parts.axes.iter().zip(at) {
            if let Action::Boundaries(frames) = &axis.action {
                let (line, column) = position(&frames[k].text, byte);
                let message = format!("{}:{line}:{column}: {}", frames[k].file, fault.message());
                return (axis.settings()[k].span.clone(), message, "in this folder".to_owned());
            }
        }
        (self.parts.span.clone(), fault.message().to_owned(), String::new())
    }
}
