//! Tables of the report.

use std::fmt::Write;

use crate::picture::{Escaped, digits};
use crate::{CurveResult, Finished, MethodResult, Quantity};

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
pub(super) fn methods(finished: &Finished) -> String {
    let rows: Vec<(&MethodResult, Vec<Option<String>>)> = finished
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
    left_out(&mut html, finished.methods.len());
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

/// What the file expects and what was printed elsewhere, beside ours; empty if there is nothing.
pub(super) fn comparisons(finished: &Finished) -> String {
    let mut rows = String::new();
    let mut count = 0;
    for (name, expected, ours) in finished.comparisons() {
        count += 1;
        if count <= ROWS {
            let met = ours.is_some_and(|ours| expected.is_met_by(ours));
            let (class, verdict) = if met { ("good", "met") } else { ("bad", "missed") };
            let _ = writeln!(
                rows,
                "<tr><td>{}</td><td class=\"words\">{}</td><td>{}</td><td>{}</td><td class=\"words {class}\">{verdict}</td></tr>",
                Escaped(name),
                expected.quantity,
                Escaped(&expected.text),
                ours.map_or("none".into(), |x| digits(x, 9)),
            );
        }
    }
    for method in &finished.methods {
        for published in &method.published {
            count += 1;
            if count <= ROWS {
                let mut source = format!("printed in {}", published.source);
                if let Some(reason) = &published.reason {
                    source += &format!(" ({reason})");
                }
                let _ = writeln!(
                    rows,
                    "<tr><td>{}</td><td class=\"words\">{}</td><td>{}</td><td>{}</td><td class=\"words\">{}</td></tr>",
                    Escaped(&method.name),
                    published.quantity,
                    Escaped(&published.text),
                    method.figure(published.quantity).map_or("none".into(), |x| digits(x, 9)),
                    Escaped(&source),
                );
            }
        }
    }
    if count == 0 {
        return rows;
    }
    let missed = finished.missed().len();
    let open = if count <= OPEN || missed > 0 { " open" } else { "" };
    let expected = finished.expected();
    let mut html = format!(
        "<details{open}><summary>Expected numbers: {} of {expected} met</summary>\n\
         <div class=\"wide\"><table><thead><tr><th scope=\"col\">method</th><th scope=\"col\" class=\"words\">figure</th>\
         <th scope=\"col\">expected</th><th scope=\"col\">ours</th><th scope=\"col\" class=\"words\">verdict</th></tr></thead>\
         <tbody>\n{rows}</tbody></table></div>\n",
        expected - missed
    );
    left_out(&mut html, count);
    html + "</details>\n"
}

fn left_out(html: &mut String, rows: usize) {
    if rows > ROWS {
        let _ = writeln!(html, "<p class=\"faint\">{} more in result.json</p>", rows - ROWS);
    }
}
