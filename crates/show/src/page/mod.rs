//! `report.html`: everything about an experiment on one page that needs nothing but itself, to look at and to send round.

mod address;
mod data;
mod figures;
mod study;
mod style;

use std::collections::BTreeSet;
use std::fmt::Write;

use crate::picture::{Escaped, Picture};
use crate::scene::Scene;
use address::address;
use plateau::{MethodResult, Results};
use style::STYLE;

pub use figures::{Comparison, Verdict};
pub use study::{Study, StudyRow, study_page};

const VIEWER: &str = include_str!("../../web/viewer.js");

/// Most bytes of the experiment file that are shown.
const SHOWN: usize = 64 * 1024;

/// Most files that are listed.
const FILES: usize = 60;

/// Pictures of at most this width are read on a phone without being moved to and fro.
const NARROW: f64 = 420.0;

/// Most notes that are shown.
const NOTES: usize = 100;

/// What results were made from.
#[derive(Debug, Clone, Copy)]
pub enum Source<'a> {
    /// An experiment file of this name.
    Experiment(&'a str),
    /// Curves of files of these names; the experiment was made of them.
    Curves(&'a str),
}

/// What the page says beside the results.
pub struct About<'a> {
    /// What the results were made from.
    pub source: Source<'a>,
    /// The text of the experiment.
    pub text: &'a str,
    /// The seed used.
    pub seed: u64,
    /// Numbers that are wanted of the results.
    pub comparisons: Vec<Comparison<'a>>,
    /// Files beside the page that hold its surfaces and its numbers.
    pub files: Vec<String>,
    /// What the numbers depend on: names and values.
    pub origin: Vec<(&'static str, String)>,
}

/// The whole page.
pub fn page(results: &Results, about: &About<'_>, scene: Option<&Scene<'_>>, pictures: &[Picture]) -> String {
    let title = Escaped(results.title());
    let mut body = String::new();
    body += &view(scene);
    body += &section("Figures", &(figures_of(results) + &notes(results)));
    body += &downloads(&about.files);
    let mut drawn = String::new();
    for picture in pictures {
        let (svg, caption) = (&picture.svg, Escaped(&picture.caption));
        let narrow = if picture.width() <= NARROW { " narrow" } else { "" };
        let _ = writeln!(
            drawn,
            "<figure><div class=\"picture{narrow}\" tabindex=\"0\">{svg}</div><figcaption>{caption}</figcaption></figure>"
        );
    }
    if !drawn.is_empty() {
        body += &section("Pictures", &drawn);
    }
    let comparisons = figures::comparisons(&about.comparisons);
    if !comparisons.is_empty() {
        let _ = writeln!(body, "<section>{comparisons}</section>");
    }
    body += &experiment(about);
    let _ = writeln!(
        body,
        "<section><details><summary>Origin</summary>\n{}</details></section>",
        origin(results, about)
    );
    // Nothing is ever loaded: the policy makes the browser hold us to it.
    let policy = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:";
    let made = made(results, about);
    let surfaces = data::json(scene);
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{policy}\">\n\
         <title>{title}</title>\n<link rel=\"icon\" href=\"data:,\">\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <header><div><h1>{title}</h1><p class=\"faint\">{made}</p></div>\
         <button type=\"button\" id=\"theme\">Light or dark</button></header>\n\
         <main>\n{body}</main>\n\
         <footer class=\"faint\">Lengths carry the unit of the control points.</footer>\n\
         <script type=\"application/json\" id=\"surfaces\">{surfaces}</script>\n\
         <script>\n{VIEWER}</script>\n</body>\n</html>\n"
    )
}

/// What the results were made from; the seed where a search used it.
fn made(results: &Results, about: &About<'_>) -> String {
    let is_searched =
        |method: &MethodResult| method.outcome.as_ref().is_ok_and(|done| done.solved.search().is_some());
    let seed = match results.methods().iter().any(is_searched) {
        true => format!(", seed {}", about.seed),
        false => String::new(),
    };
    match about.source {
        Source::Experiment(file) => format!("{}{seed}", Escaped(file)),
        Source::Curves(files) => format!("The surface over the curves of {}{seed}", Escaped(files)),
    }
}

/// The files beside the page; empty if there are none.
fn downloads(files: &[String]) -> String {
    if files.is_empty() {
        return String::new();
    }
    let mut html = String::from("<section><h2>Files</h2>\n<ul class=\"downloads\">\n");
    for file in files.iter().take(FILES) {
        let (address, name) = (address(std::slice::from_ref(file)), Escaped(file));
        let _ = writeln!(html, "<li><a href=\"{address}\" download>{name}</a></li>");
    }
    html += "</ul>\n";
    if files.len() > FILES {
        let _ =
            writeln!(html, "<p class=\"faint\">{} more in the folder of this page.</p>", files.len() - FILES);
    }
    html + "<p class=\"faint\">They lie in the folder of this page; a copy of the page alone does not hold them.</p></section>\n"
}

fn section(heading: &str, content: &str) -> String {
    format!("<section><h2>{heading}</h2>\n{content}</section>\n")
}

/// The interactive view; empty without surfaces.
fn view(scene: Option<&Scene<'_>>) -> String {
    let Some(scene) = scene else { return String::new() };
    let left_out = match scene.left_out {
        0 => String::new(),
        more => {
            format!("<p class=\"faint\">{more} more surfaces of this experiment are not shown here.</p>\n")
        }
    };
    let has_nets = scene.surfaces.iter().any(|shown| shown.sample.chart().is_some());
    let points = if has_nets { "control net" } else { "vertices" };
    format!(
        "<section><h2>Surfaces</h2>\n<noscript><p>The interactive view needs JavaScript; the pictures below do not.</p></noscript>\n\
         <p id=\"no-webgl\" hidden>This browser offers no WebGL, so there is no interactive view; the pictures below show \
         the same surfaces.</p>\n\
         <div id=\"stage\">\n\
         <fieldset class=\"choices\" id=\"methods\"><legend>Surface</legend></fieldset>\n\
         <div class=\"choices\"><label class=\"beside\" hidden><span>Beside</span><select id=\"compare\">\
         <option value=\"-1\">no other surface</option></select></label></div>\n\
         <fieldset class=\"choices\" id=\"fields\"><legend>Colour</legend></fieldset>\n\
         <canvas id=\"view\" tabindex=\"0\" role=\"img\"></canvas>\n\
         <p id=\"caption\" aria-live=\"polite\"></p>\n\
         <div id=\"legend\"><div id=\"bar\"></div><div class=\"ends\"><span id=\"low\"></span><span id=\"middle\"></span>\
         <span id=\"high\"></span></div><div class=\"faint\" id=\"quantity\"></div></div>\n\
         <div class=\"choices\">\
         <label class=\"switch\"><input type=\"checkbox\" id=\"net\"> {points}</label>\
         <label class=\"switch\"><input type=\"checkbox\" id=\"wires\"> wireframe</label>\
         <button type=\"button\" id=\"reset\">Reset the view</button>\
         <button type=\"button\" id=\"swing\" aria-pressed=\"false\" hidden>Swing by the mode</button></div>\n\
         <p class=\"faint notice\" id=\"help\">Drag or arrow keys turn, two fingers or + and − zoom, Shift-drag moves, \
         0 resets; the wheel zooms once the view is selected.</p>\n\
         {left_out}</div></section>\n"
    )
}

fn figures_of(results: &Results) -> String {
    match results.curves() {
        [] => figures::methods(results),
        curves => figures::curves(curves),
    }
}

/// What a reader must know.
fn notes(results: &Results) -> String {
    let notes = crate::table::notes(results);
    if notes.is_empty() {
        return String::new();
    }
    let mut html = String::from("<ul class=\"notes\">\n");
    for note in notes.iter().take(NOTES) {
        let _ = writeln!(html, "<li>{}</li>", Escaped(note));
    }
    if notes.len() > NOTES {
        let _ = writeln!(html, "<li>{} more in result.json</li>", notes.len() - NOTES);
    }
    html + "</ul>\n"
}

fn experiment(about: &About<'_>) -> String {
    let text = about.text;
    let heading = match about.source {
        Source::Experiment(_) => "Experiment file",
        Source::Curves(_) => "As an experiment file",
    };
    let end = text.floor_char_boundary(SHOWN);
    let rest = match text.len() - end {
        0 => String::new(),
        more => format!("<p class=\"faint\">{more} more bytes are not shown.</p>\n"),
    };
    format!(
        "<section><details><summary>{heading}</summary>\n<pre tabindex=\"0\">{}</pre>\n{rest}</details></section>\n",
        Escaped(&text[..end])
    )
}

/// What the numbers depend on.
fn origin(results: &Results, about: &About<'_>) -> String {
    let searches: BTreeSet<String> = results
        .methods()
        .iter()
        .filter_map(|method| method.outcome.as_ref().ok()?.solved.search())
        .map(|search| format!("{} evaluation, {} arithmetic", search.engine(), search.arithmetic()))
        .collect();
    let mut entries = about.origin.clone();
    if !searches.is_empty() {
        entries.push(("searches", searches.into_iter().collect::<Vec<_>>().join("; ")));
    }
    let mut html = String::from("<dl>\n");
    for (name, value) in entries {
        let _ = writeln!(html, "<dt>{name}</dt><dd>{}</dd>", Escaped(&value));
    }
    html + "</dl>\n<p class=\"faint\">The same file, seed and arithmetic give the same numbers on any number of threads.</p>\n"
}
