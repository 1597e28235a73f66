//! Tables of the report.

use std::fmt::Write;

use crate::picture::Escaped;
use crate::table::Column;
use crate::table::cells::{Cells, cells};
use crate::table::curve_table::{samples, summary};
use crate::table::figure::Place;
use crate::table::standing::Standing;
use plateau::{CurveResult, Notation, Quantity, Results};

/// Most rows of a table.
const ROWS: usize = 200;

/// Most rows of comparisons that are open at once, unless a number was missed.
const OPEN: usize = 20;

/// One row a method.
pub(super) fn methods(results: &Results) -> String {
    let mut html = table(&cells(results, Place::Page, ROWS));
    left_out(&mut html, results.methods().len());
    html
}

/// The curves and the samples of each.
pub(super) fn curves(curves: &[CurveResult]) -> String {
    let mut html = table(&summary(curves));
    for curve in curves {
        if curves.len() > 1 {
            let _ = writeln!(html, "<h3>{}</h3>", Escaped(curve.name()));
        }
        html += &table(&samples(curve, ROWS));
        left_out(&mut html, curve.samples().len());
    }
    html
}

/// A table as the terminal shows it; a row that failed says why.
fn table(Cells { columns, rows }: &Cells) -> String {
    let mut html = String::from("<div class=\"wide\"><table><thead><tr>");
    for Column { heading, unit, key, .. } in columns {
        let figure = if key.is_empty() { String::new() } else { format!(" data-figure=\"{key}\"") };
        let _ = write!(html, "<th scope=\"col\"{figure}>{heading}");
        if !unit.is_empty() {
            let _ = write!(html, "<span class=\"unit\">{unit}</span>");
        }
        html += "</th>";
    }
    html += "</tr></thead><tbody>\n";
    for row in rows {
        let shown = if row.failure.is_some() { 1 } else { columns.len() };
        let class = match row.standing {
            Standing::Best => " class=\"best\"",
            Standing::Apart => " class=\"apart\"",
            Standing::Above(_) | Standing::Alone => "",
        };
        let _ = write!(html, "<tr data-row=\"{}\"{class}>", row.index);
        for (k, cell) in row.cells[..shown].iter().enumerate() {
            let marks = if k == 0 && !row.marks.is_empty() {
                format!(" <sup>{}</sup>", row.marks)
            } else {
                String::new()
            };
            let class = if k > 0 && columns[k].is_words { " class=\"parameters\"" } else { "" };
            let _ = write!(html, "<td{class}>{}{marks}</td>", Escaped(cell));
        }
        if let Some(failure) = &row.failure {
            let (span, failure) = (columns.len() - 1, Escaped(failure));
            let _ = write!(html, "<td class=\"words bad\" colspan=\"{span}\">failed: {failure}</td>");
        }
        html += "</tr>\n";
    }
    html + "</tbody></table></div>\n"
}

/// A number that is wanted of the results, beside ours.
pub struct Comparison<'a> {
    /// The row of the results.
    pub name: &'a str,
    /// Which figure.
    pub quantity: Quantity,
    /// The number as it was written.
    pub text: &'a str,
    /// Ours; none if there is no such figure.
    pub ours: Option<f64>,
    /// What comes of it.
    pub verdict: Verdict,
}

/// How a number compares with ours.
pub enum Verdict {
    /// It was expected and is met.
    Met,
    /// It was expected and is not met.
    Missed,
    /// It was printed elsewhere; where, and why ours differs.
    Printed(String),
}

/// What is expected and what was printed elsewhere, beside ours; empty if there is nothing.
pub(super) fn comparisons(comparisons: &[Comparison<'_>]) -> String {
    if comparisons.is_empty() {
        return String::new();
    }
    let count = |wanted: fn(&Verdict) -> bool| comparisons.iter().filter(|c| wanted(&c.verdict)).count();
    let met = count(|verdict| matches!(verdict, Verdict::Met));
    let missed = count(|verdict| matches!(verdict, Verdict::Missed));
    let open = if comparisons.len() <= OPEN || missed > 0 { " open" } else { "" };
    let mut html = format!(
        "<details{open}><summary>Expected numbers: {met} of {} met</summary>\n\
         <div class=\"wide\"><table><thead><tr><th scope=\"col\">method</th><th scope=\"col\" class=\"words\">figure</th>\
         <th scope=\"col\">expected</th><th scope=\"col\">ours</th><th scope=\"col\" class=\"words\">verdict</th></tr></thead>\
         <tbody>\n",
        met + missed
    );
    for c in comparisons.iter().take(ROWS) {
        let (class, verdict) = match &c.verdict {
            Verdict::Met => (" good", "met"),
            Verdict::Missed => (" bad", "missed"),
            Verdict::Printed(source) => ("", source.as_str()),
        };
        let _ = writeln!(
            html,
            "<tr><td>{}</td><td class=\"words\">{}</td><td>{}</td><td>{}</td><td class=\"words{class}\">{}</td></tr>",
            Escaped(c.name),
            c.quantity,
            Escaped(c.text),
            c.ours.map_or("none".into(), |x| Notation::Digits(9).of(x)),
            Escaped(verdict),
        );
    }
    html += "</tbody></table></div>\n";
    left_out(&mut html, comparisons.len());
    html + "</details>\n"
}

fn left_out(html: &mut String, rows: usize) {
    if rows > ROWS {
        let _ = writeln!(html, "<p class=\"faint\">{} more in result.json</p>", rows - ROWS);
    }
}
