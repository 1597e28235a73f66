//! The page of many experiments: plots over their axes, a table, and the way to each.

use std::fmt::Write;

use super::address::address;
use super::style::STYLE;
use crate::picture::Escaped;

/// Most rows of the table that are shown.
const ROWS: usize = 2000;

/// What the page of many experiments shows.
#[derive(Debug, Clone, Default)]
pub struct Study {
    /// The heading.
    pub title: String,
    /// A line below it.
    pub about: String,
    /// What a reader must know, a sentence each.
    pub notes: Vec<String>,
    /// The plots, as SVG.
    pub picture: String,
    /// What they show, in a sentence or two.
    pub caption: String,
    /// The headings of the table.
    pub headings: Vec<String>,
    /// Its rows.
    pub rows: Vec<StudyRow>,
}

/// A row of the table.
#[derive(Debug, Clone, Default)]
pub struct StudyRow {
    /// One for each heading.
    pub cells: Vec<String>,
    /// The page or the record of the experiment, relative to this page: folders and a file.
    pub link: Vec<String>,
    /// Whether it is the best of those it is compared with.
    pub best: bool,
}

/// The whole page; it needs nothing but itself.
#[must_use]
pub fn study_page(study: &Study) -> String {
    let (title, about) = (Escaped(&study.title), Escaped(&study.about));
    let mut body = String::new();
    if !study.notes.is_empty() {
        body += "<section><ul class=\"notes\">\n";
        for note in &study.notes {
            let _ = writeln!(body, "<li>{}</li>", Escaped(note));
        }
        body += "</ul></section>\n";
    }
    let (picture, caption) = (&study.picture, Escaped(&study.caption));
    let _ = writeln!(
        body,
        "<section><h2>Plots</h2>\n<figure><div class=\"picture\" tabindex=\"0\">{picture}</div><figcaption>{caption}</figcaption></figure></section>"
    );
    body += &table(study);
    // Nothing is ever loaded: the policy makes the browser hold us to it.
    let policy = "default-src 'none'; style-src 'unsafe-inline'; img-src data:";
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{policy}\">\n\
         <title>{title}</title>\n<link rel=\"icon\" href=\"data:,\">\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <header><div><h1>{title}</h1><p class=\"faint\">{about}</p></div></header>\n\
         <main>\n{body}</main>\n\
         <footer class=\"faint\">Lengths carry the unit of the control points. All figures are in merged.csv and merged.json beside this page.</footer>\n\
         </body>\n</html>\n"
    )
}

fn table(study: &Study) -> String {
    let mut html = String::from("<section><h2>Cells</h2>\n<div class=\"wide\"><table>\n<thead><tr>");
    for heading in &study.headings {
        let _ = write!(html, "<th scope=\"col\">{}</th>", Escaped(heading));
    }
    html += "</tr></thead>\n<tbody>\n";
    for row in study.rows.iter().take(ROWS) {
        html += if row.best { "<tr class=\"best\">" } else { "<tr>" };
        for (k, cell) in row.cells.iter().enumerate() {
            let cell = Escaped(cell);
            let _ = match k {
                0 => write!(html, "<th scope=\"row\"><a href=\"{}\">{cell}</a></th>", address(&row.link)),
                _ => write!(html, "<td>{cell}</td>"),
            };
        }
        html += "</tr>\n";
    }
    html += "</tbody></table></div>\n";
    if study.rows.len() > ROWS {
        let _ = writeln!(html, "<p class=\"faint\">{} more rows in merged.csv.</p>", study.rows.len() - ROWS);
    }
    html + "</section>\n"
}
