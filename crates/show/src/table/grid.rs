use super::cells::Cells;
use super::column::Column;
use crate::Printable;
use crate::printable::columns as columns_of;

/// Headings, units, a rule and the rows, aligned. Words are made printable and cut to [`Printable::NAME`].
pub fn grid(Cells { columns, rows }: &Cells) -> String {
    let shown = |(cell, column): (&String, &Column)| match column.is_words {
        true => Printable(cell).cut(Printable::NAME),
        false => cell.clone(),
    };
    let rows: Vec<Vec<String>> =
        rows.iter().map(|row| row.cells.iter().zip(columns).map(shown).collect()).collect();
    let has_units = columns.iter().any(|column| !column.unit.is_empty());
    let width = |k: usize| {
        let cells = rows.iter().map(|row| row[k].as_str());
        cells.chain([columns[k].heading, columns[k].unit]).map(columns_of).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..columns.len()).map(width).collect();
    let line = |cells: &mut dyn Iterator<Item = &str>| {
        let mut text = String::new();
        for ((cell, column), width) in cells.zip(columns).zip(&widths) {
            let pad = " ".repeat(width - columns_of(cell));
            let [left, right] = if column.is_words { [cell, pad.as_str()] } else { [pad.as_str(), cell] };
            text.extend([left, right, "   "]);
        }
        text.truncate(text.trim_end().len());
        text + "\n"
    };
    let mut text = line(&mut columns.iter().map(|column| column.heading));
    if has_units {
        text += &line(&mut columns.iter().map(|column| column.unit));
    }
    let rules: Vec<String> = widths.iter().map(|width| "─".repeat(*width)).collect();
    text += &line(&mut rules.iter().map(String::as_str));
    for row in &rows {
        text += &line(&mut row.iter().map(String::as_str));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_aligned_as_a_terminal_shows_them() {
        let columns = vec![Column::words("name", ""), Column::number("κ", "1/length")];
        let rows =
            vec![vec!["最小\u{7}".to_owned(), "1.5".to_owned()], vec!["long".to_owned(), String::new()]];
        let expected = "name                κ\n             1/length\n──────────   ────────\n最小\\u0007        1.5\nlong\n";
        assert_eq!(grid(&Cells::new(columns, rows)), expected);
    }
}
