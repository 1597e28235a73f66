//! What a sweep consists of, kept beside its cells: by it the folders of all shards are merged.

use std::path::Path;

use experiment::{Options, Refusal, Sweep};
use record::{Manifest, ReadError, own_contents};
use serde::{Deserialize, Serialize};

/// The name of the file in the folder of a sweep.
pub const OUTLINE_FILE: &str = "sweep.json";

/// The version of its layout.
pub const OUTLINE_SCHEMA: &str = "plateau-sweep/1";

/// The axes and cells of a sweep. It is the same for all shards.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Outline {
    pub(crate) schema: String,
    pub(crate) title: String,
    /// The figure that is compared, by its name in experiment files.
    pub(crate) figure: String,
    pub(crate) gap: bool,
    pub(crate) axes: Vec<AxisEntry>,
    pub(crate) cells: Vec<CellEntry>,
    /// The file of the sweep.
    pub(crate) text: String,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct AxisEntry {
    pub(crate) name: String,
    /// The axis it goes in step with.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) with: Option<String>,
    /// Whether each of its values has a boundary of its own.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub(crate) moves_the_boundary: bool,
    pub(crate) values: Vec<SettingEntry>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct SettingEntry {
    pub(crate) label: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) number: Option<f64>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct CellEntry {
    pub(crate) name: String,
    /// For every axis the place of its value.
    pub(crate) at: Vec<usize>,
    /// The seed its experiment is run with.
    pub(crate) seed: u64,
    /// The SHA-256 of its experiment.
    pub(crate) sha256: String,
}

impl Outline {
    /// The outline of a sweep that is run with `options`.
    pub(crate) fn of(sweep: &Sweep, options: Options) -> Result<Self, Refusal> {
        let axes = sweep.axes();
        let entry = |index: usize| {
            let manifest = Manifest::new(&sweep.plan(index)?, options);
            let cell = sweep.cell(index);
            Ok(CellEntry { name: cell.name, at: cell.at, seed: manifest.seed, sha256: manifest.sha256 })
        };
        Ok(Self {
            schema: OUTLINE_SCHEMA.to_owned(),
            title: sweep.title().to_owned(),
            figure: sweep.figure().name().to_owned(),
            gap: sweep.gap(),
            axes: axes
                .iter()
                .map(|axis| AxisEntry {
                    name: axis.name().to_owned(),
                    with: axis.with().map(|other| axes[other].name().to_owned()),
                    moves_the_boundary: axis.moves_the_boundary(),
                    values: axis
                        .settings()
                        .iter()
                        .map(|setting| SettingEntry {
                            label: setting.label().to_owned(),
                            number: setting.number(),
                        })
                        .collect(),
                })
                .collect(),
            cells: (0..sweep.cells()).map(entry).collect::<Result<_, Refusal>>()?,
            text: sweep.text().to_owned(),
        })
    }

    /// The outline in the folder of a sweep.
    pub(crate) fn read(folder: &Path) -> Result<Self, ReadError> {
        let bytes = own_contents(&folder.join(OUTLINE_FILE))?;
        let json = |source| ReadError::Json { place: String::new(), source };
        let outline: Self = serde_json::from_slice(&bytes).map_err(json)?;
        if outline.schema != OUTLINE_SCHEMA {
            return Err(unfit(
                "schema",
                format!("is {:?}, this program reads {OUTLINE_SCHEMA:?}", outline.schema),
            ));
        }
        let fits = |cell: &CellEntry| {
            cell.at.len() == outline.axes.len()
                && cell.at.iter().zip(&outline.axes).all(|(&at, axis)| at < axis.values.len())
        };
        match outline.cells.iter().position(|cell| !fits(cell)) {
            Some(k) => Err(unfit(&format!("cells[{k}].at"), "leads to no values of the axes".to_owned())),
            None => Ok(outline),
        }
    }

    /// The text of the file.
    ///
    /// # Errors
    /// Never in fact: every part of it has a JSON form.
    pub(crate) fn to_json(&self) -> serde_json::Result<String> {
        let mut text = serde_json::to_string_pretty(self)?;
        text.push('\n');
        Ok(text)
    }

    /// The axes that are directions of their own, by their places.
    pub(crate) fn directions(&self) -> Vec<usize> {
        (0..self.axes.len()).filter(|&k| self.axes[k].with.is_none()).collect()
    }

    /// Whether the cells of a panel, which differ along the last direction, have boundaries of their own.
    pub(crate) fn is_of_boundaries(&self) -> bool {
        let Some(&last) = self.directions().last() else { return false };
        let goes_with = |axis: &&AxisEntry| axis.with.as_ref() == Some(&self.axes[last].name);
        self.axes[last].moves_the_boundary
            || self.axes.iter().filter(goes_with).any(|axis| axis.moves_the_boundary)
    }

    /// The value of an axis in a cell.
    pub(crate) fn value(&self, cell: &CellEntry, axis: usize) -> &SettingEntry {
        &self.axes[axis].values[cell.at[axis]]
    }
}

fn unfit(key: &str, why: String) -> ReadError {
    ReadError::Unfit { key: key.to_owned(), why }
}
