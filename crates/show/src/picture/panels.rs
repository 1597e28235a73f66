/// Columns and rows for so many panels, at most `most` in a row and rows as even as possible.
pub(super) fn arrange(panels: usize, most: usize) -> [usize; 2] {
    let rows = panels.div_ceil(most).max(1);
    [panels.div_ceil(rows).max(1), rows]
}
