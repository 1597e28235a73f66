//! The values of an axis: a list, or a range.

use std::ops::Range;

use serde_spanned::Spanned;

use crate::keys::sweep::axis::{BY, COUNT, FROM, SPACING, TO, VALUES};
use crate::keys::sweep::{MOST_CELLS, Spacing, Written};
use crate::text::{Faults, Given, Table, shown};

/// What a table says of its values.
pub(super) struct Taken {
    values: Given<Vec<Spanned<Written>>>,
    ends: [Given<f64>; 2],
    count: Given<usize>,
    by: Given<f64>,
    spacing: Given<Spacing>,
}

impl Taken {
    pub(super) fn of(table: &Table<'_>) -> Self {
        Self {
            values: table.take(&VALUES),
            ends: [table.take(&FROM), table.take(&TO)],
            count: table.take(&COUNT),
            by: table.take(&BY),
            spacing: table.take(&SPACING),
        }
    }

    /// The values of an axis over keys: a list, or a range.
    pub(super) fn values(self, table: &Table<'_>) -> Option<Vec<Spanned<Written>>> {
        let Self { values, ends: [from, to], count, by, spacing } = self;
        let Some(values) = values.known()? else {
            let (from, to) = (from.known()?, to.known()?);
            let (Some(from), Some(to)) = (from, to) else {
                table.missing("values", "write values = [0, 2, 4], or a range: from = 0, to = 4, by = 2");
                return None;
            };
            return range(table, (from, to), count.known()?, by.known()?, spacing.known()?);
        };
        let range = [from.span(), to.span(), count.span(), by.span(), spacing.span()];
        if let Some(stray) = range.into_iter().flatten().next() {
            let message = "an axis has `values` or a range, not both";
            let help = "take one of them out";
            table.faults().conflict((stray, "of a range"), (values.span(), "the values"), message, help);
            return None;
        }
        Some(values.into_inner())
    }
}

/// The values of a range.
fn range(
    table: &Table<'_>,
    (from, to): (Spanned<f64>, Spanned<f64>),
    count: Option<Spanned<usize>>,
    by: Option<Spanned<f64>>,
    spacing: Option<Spanned<Spacing>>,
) -> Option<Vec<Spanned<Written>>> {
    let faults = table.faults();
    let span = from.span().start.min(to.span().start)..from.span().end.max(to.span().end);
    let ends = [from.into_inner(), to.into_inner()];
    let numbers = match (count, by, spacing) {
        (Some(count), Some(by), _) => {
            let message = "a range has `count` or `by`, not both";
            faults.conflict(
                (by.span(), "the second"),
                (count.span(), "the first"),
                message,
                "take one of them out",
            );
            return None;
        }
        (Some(count), None, spacing) => match spacing.map(Spanned::into_inner) {
            Some(Spacing::Logarithmic) => logarithmic(faults, ends, *count.get_ref(), &span)?,
            Some(Spacing::Linear) | None => linear(ends, *count.get_ref()),
        },
        (None, Some(by), Some(spacing)) => {
            let message = "`by` steps by equal distances";
            let help = "write `count` instead of `by`, or take `spacing` out";
            faults.conflict((spacing.span(), "with `by`"), (by.span(), "the step"), message, help);
            return None;
        }
        (None, Some(by), None) => stepped(faults, ends, &by)?,
        (None, None, _) => {
            table.missing("count", "say how many values the range has, count = 5, or their distance, by = 2");
            return None;
        }
    };
    let written = |number: f64| {
        let number = tidy(number);
        let whole = number.fract() == 0.0 && number.abs() < 9e15;
        let text = if whole { format!("{}", number as i64) } else { format!("{number:?}") };
        Spanned::new(span.clone(), Written { text, number: Some(number), word: None })
    };
    Some(numbers.into_iter().map(written).collect())
}

/// A number without the rounding of its last digit: 0.3, not 0.30000000000000004.
fn tidy(number: f64) -> f64 {
    format!("{number:.14e}").parse().unwrap_or(number)
}

fn linear([from, to]: [f64; 2], count: usize) -> Vec<f64> {
    let last = (count - 1) as f64;
    // Weights of both ends: their difference may overflow.
    (0..count).map(|k| from * ((last - k as f64) / last) + to * (k as f64 / last)).collect()
}

fn logarithmic(
    faults: &Faults<'_>,
    [from, to]: [f64; 2],
    count: usize,
    span: &Range<usize>,
) -> Option<Vec<f64>> {
    if from <= 0.0 || to <= 0.0 {
        faults.inadmissible(
            span.clone(),
            "a logarithmic range begins and ends above 0",
            format!("this is {} to {}", shown(from), shown(to)),
            "give positive ends, or take `spacing` out",
        );
        return None;
    }
    // By powers of ten, which their logarithms hold exactly: between 1e-6 and 1e-10 lies 1e-8 and no neighbour of it.
    let ends = [libm::log10(from), libm::log10(to)];
    let mut numbers: Vec<f64> = linear(ends, count).into_iter().map(libm::exp10).collect();
    // The ends as they are written.
    if let [first, .., last] = numbers.as_mut_slice() {
        (*first, *last) = (from, to);
    }
    Some(numbers)
}

fn stepped(faults: &Faults<'_>, [from, to]: [f64; 2], by: &Spanned<f64>) -> Option<Vec<f64>> {
    let step = *by.get_ref() * if to < from { -1.0 } else { 1.0 };
    // A step that ends a rounding short of the end reaches it.
    let steps = ((to - from) / step + 1e-9).floor();
    if steps < MOST_CELLS as f64 {
        return Some((0..=steps as usize).map(|k| from + k as f64 * step).collect());
    }
    faults.inadmissible(
        by.span(),
        format!("the range has more than {MOST_CELLS} values"),
        format!("from {} to {} by {}", shown(from), shown(to), shown(*by.get_ref())),
        "take a larger step",
    );
    None
}
