use super::cells::{Cells, Row};
use super::standing::Standing;
use crate::Printable;
use crate::printable::columns as columns_of;

/// What stands between two columns where there is room, and where there is not.
const GAPS: [&str; 2] = ["   ", "  "];

/// Fewest columns of a terminal for the names of the rows.
const NARROW: usize = 12;

/// Stands above the rows whose areas cannot be compared with those of the others.
pub(crate) const APART: &str = "the boundary moved: not over the same curves as the rows above";

/// Headings, units, a rule and the rows, aligned, in lines of at most `room` columns of a terminal: columns are left out by
/// their rank until they fit, then names are cut. Names are never longer than [`Printable::NAME`]. Also the headings of what
/// was left out.
pub fn grid(table: &Cells, room: usize) -> (String, Vec<&'static str>) {
    let Cells { columns, rows } = table;
    let mut kept: Vec<usize> = (0..columns.len()).collect();
    let mut widths = widths(table);
    let total = |kept: &[usize], widths: &[usize], gap: &str| -> usize {
        kept.iter().map(|&k| widths[k]).sum::<usize>() + gap.len() * kept.len().saturating_sub(1)
    };
    let gap = if total(&kept, &widths, GAPS[0]) <= room { GAPS[0] } else { GAPS[1] };
    let mut left_out = Vec::new();
    while total(&kept, &widths, gap) > room {
        let last = kept.iter().copied().max_by_key(|&k| columns[k].rank).filter(|&k| columns[k].rank > 0);
        let Some(last) = last else { break };
        kept.retain(|&k| k != last);
        left_out.push(last);
    }
    left_out.sort_unstable();
    if let Some(&first) = kept.first() {
        let excess = total(&kept, &widths, gap).saturating_sub(room);
        widths[first] = widths[first].saturating_sub(excess).max(NARROW.min(widths[first]));
    }
    let line = |cells: &dyn Fn(usize) -> String| {
        let shown = kept.iter().map(|&k| {
            let cell = cells(k);
            let pad = " ".repeat(widths[k].saturating_sub(columns_of(&cell)));
            if columns[k].is_words { cell + &pad } else { pad + &cell }
        });
        shown.collect::<Vec<_>>().join(gap).trim_end().to_owned() + "\n"
    };
    let mut text = line(&|k| columns[k].heading.into());
    if kept.iter().any(|&k| !columns[k].unit.is_empty()) {
        text += &line(&|k| columns[k].unit.clone().into_owned());
    }
    text += &line(&|k| "─".repeat(widths[k]));
    let mut before = Standing::Alone;
    for row in rows {
        if row.standing == Standing::Apart && !matches!(before, Standing::Apart | Standing::Alone) {
            text += &format!("{}\n", Printable(APART).cut(room.max(NARROW)));
        }
        before = row.standing;
        text += &line(&|k| row.shown(k, columns[k].is_words, widths[k]));
    }
    (text, left_out.into_iter().map(|k| columns[k].heading).collect())
}

fn widths(Cells { columns, rows }: &Cells) -> Vec<usize> {
    let width = |k: usize| {
        let headings = [columns[k].heading, &columns[k].unit].map(columns_of);
        let cells = rows.iter().map(|row| columns_of(&row.shown(k, columns[k].is_words, Printable::NAME)));
        headings.into_iter().chain(cells).max().unwrap_or(0)
    };
    (0..columns.len()).map(width).collect()
}

impl Row {
    /// A cell; words are made printable and cut, the marks of the notes kept.
    fn shown(&self, k: usize, is_words: bool, most: usize) -> String {
        match (is_words, k) {
            (false, _) => self.cells[k].clone(),
            (true, 0) if !self.marks.is_empty() => {
                let marks = format!(" [{}]", self.marks);
                Printable(&self.cells[0]).cut(most.saturating_sub(marks.len()).max(1)) + &marks
            }
            (true, _) => Printable(&self.cells[k]).cut(most),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::column::Column;
    use super::*;

    fn table(names: [&str; 2], columns: &[(&'static str, u8)]) -> Cells {
        let number =
            |&(heading, rank): &(&'static str, u8)| Column { rank, ..Column::number(heading, "1/length") };
        let all = std::iter::once(Column::words("name", "")).chain(columns.iter().map(number)).collect();
        let rows = names.map(|name| {
            std::iter::once(name.to_owned()).chain(columns.iter().map(|_| "1.5".into())).collect()
        });
        Cells::new(all, rows.to_vec())
    }

    #[test]
    fn columns_are_aligned_as_a_terminal_shows_them() {
        let (text, left_out) = grid(&table(["最小\u{7}", "long"], &[("κ", 0)]), 80);
        let expected = "name                κ\n             1/length\n──────────   ────────\n\
                        最小\\u0007        1.5\nlong              1.5\n";
        assert_eq!((text.as_str(), left_out.len()), (expected, 0));
    }

    #[test]
    fn no_line_is_longer_than_the_room_and_the_first_rank_stays() {
        let long = "a name that is longer than many a terminal is wide".repeat(3);
        let table = table([&long, "short"], &[("area", 0), ("error", 1), ("bound", 3), ("gap", 2)]);
        for room in 24..140 {
            let (text, left_out) = grid(&table, room);
            assert!(text.lines().all(|line| columns_of(line) <= room), "{room}\n{text}");
            assert!(text.contains("area") && text.contains("short"), "{text}");
            let order: &[&str] = &["bound", "gap", "error"];
            assert!(
                order[..left_out.len()].iter().all(|name| left_out.contains(name)),
                "{room}: {left_out:?}"
            );
        }
    }
}
