//! How pages look.

/// The style sheet.
pub(super) const STYLE: &str = include_str!("../../web/report.css");
