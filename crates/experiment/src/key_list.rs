//! The list of all keys, for the book.

use std::fmt::Write;

use crate::keys::{self, EXPERIMENT, boundary_curve, expect, face, helicoid};
use crate::text::{Section, sentence};

/// A chapter of the book in Markdown: every table and key of experiment files with what it admits, its default and what it
/// means, from the same description as the reader.
///
/// ```
/// assert!(experiment::key_list().contains("| `mesh` | a whole number, 2 to 2000 | `48` |"));
/// ```
#[must_use]
pub fn key_list() -> String {
    let mut page = String::from(
        "# Every key of experiment files\n\n<!-- Made by `cargo run -p plateau-experiment --example key_list`; a test holds it to the \
         program. -->\n\nA key without a default may be left out, unless it is **needed**. Numbers may be written with or without a \
         point. Tables in the list are described by what follows.\n",
    );
    let tables: [(&str, &Section); 19] = [
        ("The file", &EXPERIMENT),
        ("[boundary]", &keys::boundary::SECTION),
        ("[[curve]]", &boundary_curve::SECTION),
        ("spline = { … }", &boundary_curve::spline::SECTION),
        ("through = { … }", &boundary_curve::through::SECTION),
        ("circle = { … }", &boundary_curve::circle::SECTION),
        ("[[face]]", &face::SECTION),
        ("[[vertex]]", &face::vertex::SECTION),
        ("[[method]]", &keys::method::SECTION),
        ("[method.expect], [expect]", &expect::SECTION),
        ("[method.published]", &expect::PUBLISHED),
        ("[search]", &keys::search::SECTION),
        ("[helicoid]", &helicoid::SECTION),
        ("[trapezium-helicoid]", &helicoid::trapezium::SECTION),
        ("[net]", &keys::net::SECTION),
        ("[curve]", &keys::curve::SECTION),
        ("[output]", &keys::output::SECTION),
        ("[sweep]", &keys::sweep::SECTION),
        ("[[sweep.axis]]", &keys::sweep::axis::SECTION),
    ];
    for (header, section) in tables {
        let code = if header.contains('[') || header.contains('{') { "`" } else { "" };
        let header = header.replace(", ", &format!("{code}, {code}"));
        let doc = sentence(section.doc);
        let _ = write!(
            page,
            "\n## {code}{header}{code}\n\n{doc}\n\n| key | admits | default | is |\n|---|---|---|---|\n"
        );
        for key in section.keys {
            let (head, admits) = (key.head(), key.form().admits());
            let default = match (head.default, head.required) {
                (Some(default), _) => format!("`{default}`"),
                (None, true) => "**needed**".to_owned(),
                (None, false) => String::new(),
            };
            let over = if head.over.is_empty() {
                String::new()
            } else {
                format!(" ({} only)", head.over.join(", "))
            };
            let doc = head.doc.phrase();
            let doc = if doc.is_empty() { "see below" } else { &doc };
            let row =
                format!("| `{}` | {admits} | {default} | {}{over} |", head.name, doc.replace('|', "\\|"));
            let _ = writeln!(page, "{row}");
        }
    }
    page
}
