//! Tables of the report.

use std::fmt::Write;

use crate::picture::{Escaped, digits};
use plateau::Results;
use plateau::{CurveResult, MethodResult, Quantity};

/// Most rows of a table.
const ROWS: usize = 200;

/// Most rows of comparisons that are open at once, unless a number was missed.
const OPEN: usize = 20;

/// A column: heading, unit, its cell for a method.
type Column = (&'static str, &'static str, fn(&MethodResult) -> Option<String>);

const COLUMNS: [Column; 11] = [
    ("Dirichlet D", "length²", |m| energy(m, Quantity::Dirichlet)),
    ("bound of D", "length²", |m| energy(m, Quantity::HarmonicBound)),
    ("area A", "length²", |m| energy(m, Quantity::Area)),
    ("± of A", "length²", |m| Some(digits(m.outcome.as_ref().ok()?.figures.area.error, 2))),
    ("(D−A)/A", "", |m| {
        m.figure(Quantity::ConformalityGap).map(|gap| format!("{} %", digits(100.0 * gap, 5)))
    }),
    ("max |H|", "1/length", |m| m.figure(Quantity::MeanCurvatureMax).map(|h| digits(h, 5))),
    ("rms H", "1/length", |m| m.figure(Quantity::MeanCurvatureRms).map(|h| digits(h, 5))),
    ("∫‖ΔS‖²", "length²", |m| m.figure(Quantity::LaplacianDefect).map(|x| digits(x, 6))),
    ("boundary", "moved by", |m| m.figure(Quantity::BoundaryDeviation).map(moved)),
    ("closed form", "off by", |m| m.figure(Quantity::Deviation).map(|x| digits(x, 2))),
    ("shape", "α1 α2 β1 β2", shape),
];

fn energy(method: &MethodResult, quantity: Quantity) -> Option<String> {
    method.figure(quantity).map(|value| digits(value, 9))
}

fn moved(deviation: f64) -> String {
    if deviation < 1e-12 { "0".into() } else { digits(deviation, 4) }
}

fn shape(method: &MethodResult) -> Option<String> {
    let shape = method.outcome.as_ref().ok()?.solved.shape?;
    if shape.iter().all(|x| (x - shape[0]).abs() < 5e-6) {
        return Some(format!("{:.5} (all)", shape[0]));
    }
    Some(shape.map(|x| format!("{x:.5}")).join(" "))
}

/// One row a method; columns nobody fills are left out.
pub(super) fn methods(results: &Results) -> String {
    let rows: Vec<(&MethodResult, Vec<Option<String>>)> = results
        .methods
        .iter()
        .take(ROWS)
        .map(|m| (m, COLUMNS.map(|(_, _, cell)| cell(m)).to_vec()))
        .collect();
    let filled: Vec<usize> =
        (0..COLUMNS.len()).filter(|&k| rows.iter().any(|(_, row)| row[k].is_some())).collect();
    let mut html = String::from("<div class=\"wide\"><table><thead><tr><th scope=\"col\">method</th>");
    for &k in &filled {
        let (heading, unit, _) = COLUMNS[k];
        let _ = write!(html, "<th scope=\"col\">{heading}<span class=\"unit\">{unit}</span></th>");
    }
    html += "</tr></thead><tbody>\n";
    for (method, row) in &rows {
        let _ = write!(html, "<tr><td>{}</td>", Escaped(&method.name));
        match &method.outcome {
            Ok(_) => filled.iter().for_each(|&k| {
                let _ = write!(html, "<td>{}</td>", row[k].as_deref().unwrap_or(""));
            }),
            Err(error) => {
                let (span, error) = (filled.len().max(1), error.to_string());
                let _ = write!(
                    html,
                    "<td class=\"words bad\" colspan=\"{span}\">failed: {}</td>",
                    Escaped(&error)
                );
            }
        }
        html += "</tr>\n";
    }
    html += "</tbody></table></div>\n";
    left_out(&mut html, results.methods.len());
    html
}

/// The samples of a curve.
pub(super) fn curve(curve: &CurveResult) -> String {
    let names = &["x", "y", "z"][..curve.dimension];
    let mut html = format!(
        "<p>{}, length {}</p><div class=\"wide\"><table><thead><tr><th scope=\"col\">t</th>",
        Escaped(&curve.name),
        digits(curve.length[0], 9)
    );
    for name in names {
        let _ = write!(html, "<th scope=\"col\">{name}<span class=\"unit\">length</span></th>");
    }
    html += "<th scope=\"col\">curvature κ<span class=\"unit\">1/length</span></th></tr></thead><tbody>\n";
    for k in 0..curve.t.len().min(ROWS) {
        let _ = write!(html, "<tr><td>{}</td>", digits(curve.t[k], 6));
        for x in curve.coordinates(curve.jets[k].point) {
            let _ = write!(html, "<td>{}</td>", digits(x, 8));
        }
        let curvature = curve.curvature[k].map_or("none".into(), |x| digits(x, 8));
        let _ = writeln!(html, "<td>{curvature}</td></tr>");
    }
    html += "</tbody></table></div>\n";
    left_out(&mut html, curve.t.len());
    html
}

/// A number that is wanted of the results, beside ours.
pub(crate) struct Comparison<'a> {
    /// The row of the results.
    pub(crate) name: &'a str,
    /// Which figure.
    pub(crate) quantity: Quantity,
    /// The number as it was written.
    pub(crate) text: &'a str,
    /// Ours; none if there is no such figure.
    pub(crate) ours: Option<f64>,
    /// What comes of it.
    pub(crate) verdict: Verdict,
}

/// How a number compares with ours.
pub(crate) enum Verdict {
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
            c.ours.map_or("none".into(), |x| digits(x, 9)),
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
