//! The page of a sweep.

use std::path::{Component, Path};

use plateau::{Notation, Quantity};
use record::{REPORT_FILE, RESULT_FILE, folder_of};
use show::{Multiples, Panel, Study, StudyRow, multiples, study_page};

use crate::figures::{columns, failure, name, value};
use crate::merged::{Kept, Merged};

/// Most lines in one panel.
const MOST_SERIES: usize = 6;

/// Most figures beside the compared one in the table of the page.
const MOST_FIGURES: usize = 8;

/// Most faults that are told on the page.
const MOST_FAULTS: usize = 100;

/// The whole page, as it is seen from a folder.
pub(crate) fn page(merged: &Merged, seen_from: &Path) -> String {
    let (there, all) = merged.counts();
    let axes: Vec<&str> = merged.outline.axes.iter().map(|axis| axis.name.as_str()).collect();
    let mut notes = merged.faults();
    if notes.len() > MOST_FAULTS {
        let more = notes.len() - MOST_FAULTS;
        notes.truncate(MOST_FAULTS);
        notes.push(format!("and {more} more cells"));
    }
    notes.extend(merged.notes());
    let (headings, rows) = table(merged, seen_from);
    study_page(&Study {
        title: merged.outline.title.clone(),
        about: format!("{there} of {all} cells, over {}", axes.join(" × ")),
        notes,
        picture: multiples(&plots(merged)),
        caption: caption(merged),
        headings,
        rows,
    })
}

fn caption(merged: &Merged) -> String {
    let figure = &merged.outline.figure;
    let (of, ring) = if merged.outline.is_of_boundaries() {
        (
            "over its boundary",
            "Rings are the least values over one boundary: those over different ones are not compared.",
        )
    } else {
        ("of its panel", "The ring is the least value of the panel, whose cells have the same boundary.")
    };
    let drawn = if merged.outline.gap {
        format!("How far the figure {figure} lies above the least {of}, on a logarithmic axis")
    } else {
        format!("The figure {figure}")
    };
    format!("{drawn}; one line a method. {ring}")
}

/// The plots: the last axis below, a panel for each combination of the others, a line for each method.
pub(crate) fn plots(merged: &Merged) -> Multiples {
    let outline = &merged.outline;
    let key = merged.key();
    let last = outline.directions().last().copied().unwrap_or(0);
    let is_of_numbers = outline.axes[last].values.iter().all(|setting| setting.number.is_some());
    let mut names: Vec<String> = Vec::new();
    for (_, method) in merged.rows() {
        if names.len() < MOST_SERIES && !names.iter().any(|known| known == name(method)) {
            names.push(name(method).to_owned());
        }
    }
    let mut panels: Vec<(Vec<usize>, Panel)> = Vec::new();
    for (kept, method) in merged.rows() {
        let place = merged.panel(kept);
        if panels.last().is_none_or(|(of, _)| *of != place) {
            let series = vec![Vec::new(); names.len()];
            panels.push((place, Panel { title: panel_title(merged, kept), series }));
        }
        let series = names.iter().position(|known| known == name(method));
        let (Some(y), Some(series), Some((_, panel))) = (value(method, key), series, panels.last_mut())
        else {
            continue;
        };
        let at = merged.cell(kept).at[last];
        let x = outline.axes[last].values[at].number.filter(|_| is_of_numbers);
        panel.series[series].push([x.unwrap_or(at as f64), y]);
    }
    let mut panels: Vec<Panel> = panels.into_iter().map(|(_, panel)| panel).collect();
    for series in panels.iter_mut().flat_map(|panel| &mut panel.series) {
        series.sort_by(|a, b| a[0].total_cmp(&b[0]));
    }
    let words = || outline.axes[last].values.iter().map(|setting| setting.label.clone()).collect();
    let above = if outline.gap { " above the least" } else { "" };
    Multiples {
        title: outline.title.clone(),
        x_label: outline.axes[last].name.clone(),
        y_label: format!("{}{above}{}", outline.figure, unit(merged)),
        words: (!is_of_numbers).then(words),
        gap: outline.gap,
        by_place: outline.is_of_boundaries(),
        names,
        panels,
    }
}

fn unit(merged: &Merged) -> String {
    let found = Quantity::ALL.iter().find(|quantity| quantity.key() == merged.key());
    // What a search minimises may have a unit or none: its energy says which.
    match found.and_then(|quantity| quantity.power()).or_else(|| merged.searched_power()).unwrap_or(0) {
        0 => String::new(),
        1 => " (length)".to_owned(),
        2 => " (length²)".to_owned(),
        power => format!(" (length^{power})"),
    }
}

/// What the cells of a panel have in common.
fn panel_title(merged: &Merged, kept: &Kept) -> String {
    let outline = &merged.outline;
    let directions = outline.directions();
    let outer = directions.split_last().map_or(&[][..], |(_, outer)| outer);
    let cell = merged.cell(kept);
    let parts = outer
        .iter()
        .map(|&axis| format!("{} = {}", outline.axes[axis].name, outline.value(cell, axis).label));
    parts.collect::<Vec<_>>().join(", ")
}

/// The table: cells, axes, methods, figures.
fn table(merged: &Merged, seen_from: &Path) -> (Vec<String>, Vec<StudyRow>) {
    let outline = &merged.outline;
    let key = merged.key();
    let of_key = |figure: &str| figure == key || figure.strip_suffix("_error") == Some(key);
    let all = columns(merged.rows().map(|(_, method)| method));
    // The compared figure and its error come first.
    let (first, others): (Vec<String>, Vec<String>) = all.into_iter().partition(|figure| of_key(figure));
    let figures: Vec<String> = first.into_iter().chain(others.into_iter().take(MOST_FIGURES)).collect();
    let axes = outline.axes.iter().map(|axis| axis.name.clone());
    let headings =
        ["cell".to_owned()].into_iter().chain(axes).chain(["method".to_owned()]).chain(figures.clone());
    let least = merged.least();
    let rows = merged.rows().map(|(kept, method)| {
        let cell = merged.cell(kept);
        let labels = (0..outline.axes.len()).map(|axis| outline.value(cell, axis).label.clone());
        let shown = figures.iter().map(|figure| match (value(method, figure), failure(method)) {
            (Some(value), _) if figure.ends_with("_error") || figure.ends_with("_estimate") => {
                Notation::Order.of(value)
            }
            (Some(value), _) => Notation::Digits(10).of(value),
            (None, Some(_)) if figure == key => "failed".to_owned(),
            (None, _) => String::new(),
        });
        let found = value(method, key);
        StudyRow {
            cells: [cell.name.clone()]
                .into_iter()
                .chain(labels)
                .chain([name(method).to_owned()])
                .chain(shown)
                .collect(),
            link: link(kept, &cell.name, seen_from),
            best: found.is_some() && found == least.get(&merged.comparable(kept)).copied(),
        }
    });
    (headings.collect(), rows.collect())
}

/// The way to the page of a cell, or to its record where there is none.
fn link(kept: &Kept, cell: &str, seen_from: &Path) -> Vec<String> {
    let folder = folder_of(cell, &kept.folder);
    let file = if folder.join(REPORT_FILE).is_file() { REPORT_FILE } else { RESULT_FILE };
    relative(&folder.join(file), seen_from)
}

/// A path as it is seen from a folder; from the root where one of both cannot be found.
fn relative(path: &Path, folder: &Path) -> Vec<String> {
    let [path, folder] =
        [path, folder].map(|path| std::path::absolute(path).unwrap_or_else(|_| path.to_owned()));
    let (path, folder) = (parts(&path), parts(&folder));
    let shared = path.iter().zip(&folder).take_while(|(a, b)| a == b).count();
    let up = folder.len() - shared;
    std::iter::repeat_n("..".to_owned(), up).chain(path[shared..].iter().cloned()).collect()
}

fn parts(path: &Path) -> Vec<String> {
    let plain = path.components().filter_map(|component| match component {
        Component::Normal(name) => Some(name.to_string_lossy().into_owned()),
        Component::ParentDir => Some("..".to_owned()),
        Component::Prefix(_) | Component::RootDir | Component::CurDir => None,
    });
    plain.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_lead_from_the_page_to_the_cell() {
        for (path, folder, expected) in [
            ("out/s/c/report.html", "out/s", "c/report.html"),
            ("b/s/c/report.html", "a/s", "../../b/s/c/report.html"),
            ("./out/s/c/x", "out", "s/c/x"),
        ] {
            assert_eq!(relative(Path::new(path), Path::new(folder)).join("/"), expected);
        }
    }
}
