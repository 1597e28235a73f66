//! From a text to a sweep, as far as it is read without its cells.

use std::ops::Range;
use std::path::Path;

use plateau::{Quantity, counted};
use serde_spanned::Spanned;

use super::axis::{Action, Axis, axis};
use super::base::Base;
use super::segment::segments;
use crate::diagnostic::{Diagnostic, Fault};
use crate::keys::sweep::{AXIS, FIGURE, GAP, MOST_AXES, MOST_CELLS};
use crate::keys::{EXPERIMENT, SWEEP};
use crate::text::{Faults, Table, parse};

/// Most bytes in the names of folders: file systems take 255.
const LONGEST_NAME: usize = 200;

/// Most bytes of all cells together: all of them are read before the first is run.
const MOST_BYTES: usize = 256 * 1024 * 1024;

/// What a sweep consists of.
#[derive(Clone, Debug)]
pub(super) struct Parts {
    pub(super) title: String,
    pub(super) figure: Quantity,
    pub(super) gap: bool,
    pub(super) axes: Vec<Axis>,
    pub(super) cells: usize,
    /// One, or one for every boundary of the axis that has some.
    pub(super) bases: Vec<Base>,
    /// Where [sweep] begins.
    pub(super) span: Range<usize>,
}

/// The parts of the sweep that a text describes.
pub(super) fn parts(text: &str, folder: &Path) -> Result<Parts, Vec<Diagnostic>> {
    let document = parse(text, &EXPERIMENT)?;
    let faults = Faults::new(text);
    let parts = of_root(&Table::root(&faults, &EXPERIMENT, &document), folder);
    let found = faults.finish();
    match parts {
        Some(parts) if found.is_empty() => Ok(parts),
        _ => Err(found),
    }
}

fn of_root(root: &Table<'_>, folder: &Path) -> Option<Parts> {
    let (faults, text) = (root.faults(), root.faults().text());
    let table = root.require_inner(&SWEEP)?;
    let span = table.span();
    if !segments(text).iter().any(|segment| segment.table == "sweep") {
        let message = "[sweep] has no header of its own";
        let help = "write [[sweep.axis]] on a line of its own, and the keys of the axis below";
        faults.clash((span, "inside of another table"), message, help);
        return None;
    }
    let (figure, gap) = (table.take_or_default(&FIGURE), table.take_or_default(&GAP));
    let tables = table.several(&AXIS).known()?;
    let tables = match tables {
        Some(tables) if !tables.get_ref().is_empty() => tables,
        Some(_) | None => {
            table.missing("axis", "write [[sweep.axis]] with two brackets for each thing that varies");
            return None;
        }
    };
    if tables.get_ref().len() > MOST_AXES {
        let found = counted(tables.get_ref().len(), "axis").replace("axiss", "axes");
        let message = format!("[sweep] has {found}, at most {MOST_AXES} are admitted");
        faults.inadmissible(
            tables.span(),
            message,
            found,
            "let axes go in step, or split the sweep into several files",
        );
        return None;
    }
    let axes: Vec<Option<Axis>> = tables.get_ref().iter().map(|table| axis(table, folder)).collect();
    let mut axes: Vec<Axis> = axes.into_iter().collect::<Option<_>>()?;
    are_distinct(faults, &axes)?;
    go_in_step(faults, &mut axes)?;
    let cells = cells(faults, &axes, &span)?;
    let bases = bases(faults, text, &axes, cells, &span)?;
    let title = root.take(&crate::keys::TITLE).sound().map(Spanned::into_inner).unwrap_or_default();
    Some(Parts { title, figure: figure?, gap: gap?, axes, cells, bases, span })
}

/// Every axis has a name of its own, and one at most has boundaries.
fn are_distinct(faults: &Faults<'_>, axes: &[Axis]) -> Option<()> {
    let is_of_boundaries = |axis: &Axis| matches!(axis.action, Action::Boundaries(_));
    for (k, axis) in axes.iter().enumerate() {
        for other in &axes[..k] {
            let spans = ((axis.span.clone(), "the second"), (other.span.clone(), "the first"));
            if axis.name().to_lowercase() == other.name().to_lowercase() {
                let message = format!("two axes are called `{}`", axis.name());
                faults.conflict(spans.0, spans.1, message, "give every axis a name of its own");
                return None;
            }
            if is_of_boundaries(axis) && is_of_boundaries(other) {
                let message = "two axes have `boundaries`: an experiment has one boundary";
                faults.conflict(spans.0, spans.1, message, "put all boundaries into one folder");
                return None;
            }
        }
    }
    Some(())
}

/// Sets for every axis with a partner which one that is.
fn go_in_step(faults: &Faults<'_>, axes: &mut [Axis]) -> Option<()> {
    for k in 0..axes.len() {
        let Some(partner) = axes[k].partner.clone() else { continue };
        let name = partner.get_ref().trim();
        let refuse = |message: String, help: &str| {
            faults.inadmissible(partner.span(), message, "this axis", help);
            None
        };
        let Some(other) = axes.iter().position(|axis| axis.name() == name).filter(|&other| other != k) else {
            let message = format!("there is no other axis `{name}` to go in step with");
            let names: Vec<&str> =
                axes.iter().enumerate().filter(|(j, _)| *j != k).map(|(_, axis)| axis.name()).collect();
            return refuse(message, &format!("the other axes are: {}", names.join(", ")));
        };
        if axes[other].partner.is_some() {
            let message = format!("the axis `{name}` itself goes in step with another");
            return refuse(message, "name the axis that both go with");
        }
        let [mine, theirs] = [k, other].map(|axis| axes[axis].settings().len());
        if mine != theirs {
            let message = format!("`{}` has {mine} values, `{name}` has {theirs}", axes[k].name());
            return refuse(message, "axes that go in step have equally many values");
        }
        axes[k].go_with(other);
    }
    Some(())
}

/// How many cells there are; not too many, and none with too long a name.
fn cells(faults: &Faults<'_>, axes: &[Axis], span: &Range<usize>) -> Option<usize> {
    let directions = || axes.iter().filter(|axis| axis.with().is_none());
    let counts: Vec<String> = directions().map(|axis| axis.settings().len().to_string()).collect();
    let cells = directions().try_fold(1_usize, |product, axis| product.checked_mul(axis.settings().len()));
    let Some(cells) = cells.filter(|cells| *cells <= MOST_CELLS) else {
        faults.inadmissible(
            span.clone(),
            format!("the sweep has {} cells, at most {MOST_CELLS} are admitted", counts.join(" × ")),
            "too many cells",
            "take fewer values, or let axes go in step by with = \"…\"",
        );
        return None;
    };
    let longest = |axis: &Axis| {
        let label = axis.settings().iter().map(|setting| setting.label().len()).max().unwrap_or(0);
        axis.name().len() + label + 2
    };
    if directions().map(longest).sum::<usize>() > LONGEST_NAME {
        faults.inadmissible(
            span.clone(),
            format!("the names of the cells would have more than {LONGEST_NAME} bytes"),
            "too long for folders",
            "shorten the names of the axes, or give their values `labels`",
        );
        return None;
    }
    Some(cells)
}

/// The texts that the cells are made of.
fn bases(
    faults: &Faults<'_>,
    text: &str,
    axes: &[Axis],
    cells: usize,
    span: &Range<usize>,
) -> Option<Vec<Base>> {
    let frames = axes.iter().find_map(|axis| match &axis.action {
        Action::Boundaries(frames) => Some(frames),
        Action::Replace(_) | Action::Scale(_) => None,
    });
    let mut bases = match frames {
        Some(frames) => frames.iter().map(|frame| Base::of(text, Some(frame))).collect(),
        None => vec![Base::of(text, None)],
    };
    let longest = bases.iter().map(Base::len).max().unwrap_or(0);
    if longest.saturating_mul(cells) > MOST_BYTES {
        let message = format!("{cells} cells of {longest} bytes are too much to be read beforehand");
        let help = "take fewer values, or shorter boundaries";
        faults
            .report(Diagnostic::at(Fault::Inadmissible, span.clone(), message, "256 MiB at most").help(help));
        return None;
    }
    for base in &mut bases {
        if let Err(fault) = base.prepare(axes) {
            faults.report(*fault);
            return None;
        }
    }
    Some(bases)
}
