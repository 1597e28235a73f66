//! What is wrong with an experiment file, where, and what to do about it.
//!
//! Nothing here prints: a [`Refusal`] renders to a `String`, plain or coloured.

use std::fmt;
use std::ops::Range;

use annotate_snippets::{Annotation, AnnotationKind, Group, Level, Renderer, Snippet};

use show::{Printable, stand_ins};

mod nearest;

pub(crate) use nearest::{nearest, shorten};

/// Diagnostics shown for one file; further ones are only counted.
const MOST_SHOWN: usize = 10;

/// The kind of fault a [`Diagnostic`] reports.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Fault {
    /// The file could not be read.
    File,
    /// The text is not TOML.
    Syntax,
    /// A key that this table does not have.
    UnknownKey,
    /// A value of the wrong type.
    WrongType,
    /// A table or key that is needed.
    Missing,
    /// A value outside its admissible set.
    Inadmissible,
    /// Keys that are sound one by one but do not fit together.
    Conflict,
}

/// One fault of an experiment file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    fault: Fault,
    message: String,
    span: Option<Range<usize>>,
    label: String,
    related: Vec<(Range<usize>, String)>,
    help: Vec<String>,
}

impl Diagnostic {
    /// A fault that concerns the file as a whole.
    pub(crate) fn whole_file(fault: Fault, message: impl Into<String>) -> Self {
        Self {
            fault,
            message: message.into(),
            span: None,
            label: String::new(),
            related: Vec::new(),
            help: Vec::new(),
        }
    }

    /// A fault at `span` (bytes of the text), which `label` explains beside the snippet.
    pub(crate) fn at(
        fault: Fault,
        span: Range<usize>,
        message: impl Into<String>,
        label: impl Into<String>,
    ) -> Self {
        Self { span: Some(span), label: label.into(), ..Self::whole_file(fault, message) }
    }

    /// Adds a second place that explains the first.
    pub(crate) fn beside(mut self, span: Range<usize>, label: impl Into<String>) -> Self {
        self.related.push((span, label.into()));
        self
    }

    /// Adds what to do.
    pub(crate) fn help(mut self, help: impl Into<String>) -> Self {
        self.help.push(help.into());
        self
    }

    /// The kind of fault.
    #[must_use]
    pub fn fault(&self) -> Fault {
        self.fault
    }

    /// What is wrong, in one sentence.
    #[must_use]
    pub fn message(&self) -> &str {
        &self.message
    }

    /// What was expected, or found, at the place itself; may be empty.
    #[must_use]
    pub fn label(&self) -> &str {
        &self.label
    }

    /// What to do, one sentence or two each.
    #[must_use]
    pub fn remedies(&self) -> &[String] {
        &self.help
    }

    /// The place in the text, in bytes; `None` if the whole file is meant.
    #[must_use]
    pub fn span(&self) -> Option<Range<usize>> {
        self.span.clone()
    }

    /// The places that explain the first.
    pub(crate) fn related(&self) -> impl Iterator<Item = &Range<usize>> {
        self.related.iter().map(|(span, _)| span)
    }

    /// Line and column of the place in `text`, from 1, columns in characters.
    #[must_use]
    pub fn position(&self, text: &str) -> Option<(usize, usize)> {
        self.span.as_ref().map(|span| position(text, span.start))
    }

    /// Names and values that the words quote are made printable, and so are the lines of the file.
    fn render(&self, renderer: &Renderer, file: &str, text: &str) -> String {
        let printable = |words: &String| Printable(words).to_string();
        let (message, label, file) =
            (printable(&self.message), printable(&self.label), Printable(file).to_string());
        let labels: Vec<String> = self.related.iter().map(|(_, label)| printable(label)).collect();
        let help: Vec<String> = self.help.iter().map(printable).collect();
        let excerpt = self.span.as_ref().map(|span| {
            let related = self.related.iter().map(|(span, _)| span);
            let excerpt = Excerpt::around(text, std::iter::once(span).chain(related));
            (span, stand_ins(&text[excerpt.range.clone()]), excerpt)
        });
        let mut group: Group<'_> =
            Level::ERROR.primary_title(message).elements(None::<Snippet<'_, Annotation<'_>>>);
        if let Some((span, lines, excerpt)) = &excerpt {
            let primary = AnnotationKind::Primary.span(excerpt.local(text, span)).label(label);
            let mut snippet =
                Snippet::source(lines.as_str()).path(file).line_start(excerpt.first_line).annotation(primary);
            for ((span, _), label) in self.related.iter().zip(&labels) {
                let context = AnnotationKind::Context.span(excerpt.local(text, span)).label(label.as_str());
                snippet = snippet.annotation(context);
            }
            group = group.element(snippet);
        }
        for help in &help {
            group = group.element(Level::HELP.message(help.as_str()));
        }
        renderer.render(&[group])
    }
}

/// The whole lines of a text that hold some spans.
struct Excerpt {
    range: Range<usize>,
    first_line: usize,
}

impl Excerpt {
    fn around<'a>(text: &str, spans: impl Iterator<Item = &'a Range<usize>>) -> Self {
        let (start, end) =
            spans.fold((text.len(), 0), |(start, end), span| (start.min(span.start), end.max(span.end)));
        let start = floor(text, start);
        let end = floor(text, end).max(start);
        let start = text[..start].rfind('\n').map_or(0, |k| k + 1);
        let end = text[end..].find('\n').map_or(text.len(), |k| end + k);
        Self { range: start..end, first_line: 1 + text[..start].matches('\n').count() }
    }

    fn local(&self, text: &str, span: &Range<usize>) -> Range<usize> {
        let start = floor(text, span.start).min(self.range.end) - self.range.start;
        let end = floor(text, span.end).min(self.range.end) - self.range.start;
        start..end.max(start)
    }
}

/// The largest character boundary of `text` not above `offset`.
fn floor(text: &str, offset: usize) -> usize {
    text.floor_char_boundary(offset)
}

/// Line and column of a byte offset, from 1; columns count characters.
pub(crate) fn position(text: &str, offset: usize) -> (usize, usize) {
    let before = &text[..floor(text, offset)];
    let line_start = before.rfind('\n').map_or(0, |k| k + 1);
    (1 + before.matches('\n').count(), 1 + before[line_start..].chars().count())
}

/// An experiment file that was refused, with every fault that was found.
///
/// `Display` is the plain rendering; [`Refusal::render`] can colour it.
#[derive(Clone, Debug)]
pub struct Refusal {
    file: String,
    text: String,
    diagnostics: Vec<Diagnostic>,
    omitted: usize,
}

impl Refusal {
    /// Orders the diagnostics by their place and keeps the first ten.
    ///
    /// `diagnostics` holds at least one.
    pub(crate) fn new(file: &str, text: &str, mut diagnostics: Vec<Diagnostic>) -> Self {
        diagnostics.sort_by_key(|d| d.span.as_ref().map_or(0, |span| span.start));
        let omitted = diagnostics.len().saturating_sub(MOST_SHOWN);
        diagnostics.truncate(MOST_SHOWN);
        Self { file: file.to_owned(), text: text.to_owned(), diagnostics, omitted }
    }

    /// The file's name as it was given.
    #[must_use]
    pub fn file(&self) -> &str {
        &self.file
    }

    /// The faults in the order of the file, at least one and at most ten.
    #[must_use]
    pub fn diagnostics(&self) -> &[Diagnostic] {
        &self.diagnostics
    }

    /// The number of further faults that were found but are not listed.
    #[must_use]
    pub fn omitted(&self) -> usize {
        self.omitted
    }

    /// Line and column of a diagnostic of this refusal, from 1, columns in characters.
    #[must_use]
    pub fn position(&self, diagnostic: &Diagnostic) -> Option<(usize, usize)> {
        diagnostic.position(&self.text)
    }

    /// The report: each fault with `file:line:column`, the lines concerned and what to do; coloured
    /// with ANSI sequences if `colour`. Ends without a newline.
    #[must_use]
    pub fn render(&self, colour: bool) -> String {
        let renderer = if colour { Renderer::styled() } else { Renderer::plain() };
        let mut report = String::new();
        for (k, diagnostic) in self.diagnostics.iter().enumerate() {
            if k > 0 {
                report.push_str("\n\n");
            }
            report.push_str(&diagnostic.render(&renderer, &self.file, &self.text));
        }
        if self.omitted > 0 {
            let more = format!("correct these first: {} or more further errors are not shown", self.omitted);
            let note = [Level::NOTE.primary_title(more).elements(None::<Snippet<'_, Annotation<'_>>>)];
            report.push_str("\n\n");
            report.push_str(&renderer.render(&note));
        }
        report
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.render(false))
    }
}

impl std::error::Error for Refusal {}
