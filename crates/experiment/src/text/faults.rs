//! The faults of a text, collected while it is read.

use std::cell::RefCell;
use std::ops::Range;

use crate::diagnostic::{Diagnostic, Fault};

/// Faults met so far, and the text they are about.
pub(crate) struct Faults<'a> {
    text: &'a str,
    found: RefCell<Vec<Diagnostic>>,
}

impl<'a> Faults<'a> {
    pub(crate) fn new(text: &'a str) -> Self {
        Self { text, found: RefCell::default() }
    }

    /// What the text says at `span`.
    pub(crate) fn excerpt(&self, span: &Range<usize>) -> &'a str {
        self.text.get(span.clone()).unwrap_or_default()
    }

    /// The whole text.
    pub(crate) fn text(&self) -> &'a str {
        self.text
    }

    pub(crate) fn report(&self, diagnostic: Diagnostic) {
        self.found.borrow_mut().push(diagnostic);
    }

    /// A value outside its admissible set.
    pub(crate) fn inadmissible(
        &self,
        span: Range<usize>,
        message: impl Into<String>,
        label: impl Into<String>,
        help: impl Into<String>,
    ) {
        self.report(Diagnostic::at(Fault::Inadmissible, span, message, label).help(help));
    }

    /// A key that does not fit to what the rest of the file says.
    pub(crate) fn clash(
        &self,
        (span, label): (Range<usize>, &str),
        message: impl Into<String>,
        help: impl Into<String>,
    ) {
        self.report(Diagnostic::at(Fault::Conflict, span, message, label).help(help));
    }

    /// `span` and `other` do not fit together.
    pub(crate) fn conflict(
        &self,
        (span, label): (Range<usize>, &str),
        (other, other_label): (Range<usize>, &str),
        message: impl Into<String>,
        help: impl Into<String>,
    ) {
        self.report(
            Diagnostic::at(Fault::Conflict, span, message, label).beside(other, other_label).help(help),
        );
    }

    pub(crate) fn finish(self) -> Vec<Diagnostic> {
        self.found.into_inner()
    }
}
