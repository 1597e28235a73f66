//! The table of a sweep in all its forms, and their files.

use std::path::Path;

use record::{DeliverError, Destination, write_text};
use show::multiples;

use crate::csv::csv;
use crate::document::document;
use crate::merged::Merged;
use crate::page::{page, plots};
use crate::table::table;

/// The files of a merged sweep.
const FILES: [&str; 4] = ["merged.json", "merged.csv", "plots.svg", "index.html"];

impl Merged {
    /// The whole table as JSON: indented, with a final line break. The same bytes for any shards.
    ///
    /// # Errors
    /// Never in fact: every part of it has a JSON form.
    pub fn to_json(&self) -> serde_json::Result<String> {
        document(self)
    }

    /// One row a method of every cell, as RFC 4180 has it: cell, axes, method, figures at full precision, error. The same bytes for
    /// any shards.
    #[must_use]
    pub fn csv(&self) -> String {
        csv(self)
    }

    /// The rows on a terminal of so many columns.
    #[must_use]
    pub fn table(&self, room: usize) -> String {
        table(self, room)
    }

    /// A page with plots over the axes and all figures, in which the best cells are marked; it links the cells as they are seen from
    /// the folder `seen_from`.
    #[must_use]
    pub fn page(&self, seen_from: &Path) -> String {
        page(self, seen_from)
    }

    /// The plots of the page: the compared figure over the last axis, a panel for each combination of the others, as SVG.
    #[must_use]
    pub fn plots(&self) -> String {
        multiples(&plots(self))
    }

    /// Writes `merged.json`, `merged.csv`, `plots.svg` and the page `index.html` into a folder, each whole or not at all.
    ///
    /// # Errors
    /// [`DeliverError`] names the file that could not be written.
    pub fn write(&self, folder: &Path) -> Result<(), DeliverError> {
        let [json, table, drawn, site] = FILES.map(|name| folder.join(name));
        let failed = |error| DeliverError { path: json.clone(), source: std::io::Error::other(error) };
        write_text(&self.to_json().map_err(failed)?, &Destination::own(json.clone()))?;
        write_text(&self.csv(), &Destination::own(table))?;
        write_text(&self.plots(), &Destination::own(drawn))?;
        write_text(&self.page(folder), &Destination::own(site))
    }
}
