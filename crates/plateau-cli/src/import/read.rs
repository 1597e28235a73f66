//! Points of sides from tables and OBJ files.

use std::collections::HashMap;

use surfaces::Point;

use super::{ImportError, MAX_COORDINATE};

/// A named polygon.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Side {
    pub(super) name: String,
    pub(super) points: Vec<Point>,
}

/// A table with the columns side, x, y, z, separated by commas, semicolons, tabs or blanks; sides in the order of their first
/// rows, points in the order of theirs. A heading and lines that begin with # are passed over.
pub(super) fn table(text: &str) -> Result<Vec<Side>, ImportError> {
    let mut sides: Vec<Side> = Vec::new();
    let mut places: HashMap<&str, usize> = HashMap::new();
    let mut first = true;
    for (number, line) in lines(text) {
        let cells: Vec<&str> = line
            .split([',', ';', '\t', ' '])
            .map(|cell| cell.trim().trim_matches('"'))
            .filter(|cell| !cell.is_empty())
            .collect();
        let is_heading = std::mem::take(&mut first)
            && cells.len() > 1
            && cells.iter().skip(1).all(|cell| cell.parse::<f64>().is_err());
        if is_heading {
            continue;
        }
        if line.contains(';') && line.contains(',') {
            let why = "both commas and semicolons stand here: separate by one of them, and write decimals with a point, 1.5";
            return Err(ImportError::Line { line: number, why: why.into() });
        }
        let [name, x, y, z] = cells[..] else {
            let why = format!(
                "a row is a side and three coordinates, as in u0,1.5,0,2; here are {} cells{}",
                cells.len(),
                if cells.len() == 3 {
                    ": the name of the side may be missing, or z, which is 0 in the plane"
                } else {
                    ""
                }
            );
            return Err(ImportError::Line { line: number, why });
        };
        let place = *places.entry(name).or_insert(sides.len());
        if place == sides.len() {
            sides.push(Side { name: name.to_owned(), points: Vec::new() });
        }
        sides[place].points.push(point([x, y, z], number)?);
    }
    Ok(sides)
}

/// The polygons of an OBJ file: elements `l`, joined where one begins with the vertex at which the one before it ended, named
/// by the last `o` or `g` before them.
pub(super) fn obj(text: &str) -> Result<Vec<Side>, ImportError> {
    let mut vertices: Vec<Point> = Vec::new();
    let mut sides: Vec<Side> = Vec::new();
    let (mut name, mut end): (String, Option<usize>) = (String::new(), None);
    for (number, line) in lines(text) {
        let mut cells = line.split_whitespace();
        match cells.next() {
            Some("v") => {
                let cells: Vec<&str> = cells.collect();
                let [x, y, z, ..] = cells[..] else {
                    return Err(ImportError::Line {
                        line: number,
                        why: "a vertex has three coordinates".into(),
                    });
                };
                vertices.push(point([x, y, z], number)?);
            }
            Some("o" | "g") => {
                name = cells.collect::<Vec<_>>().join(" ");
                end = None;
            }
            Some("l") => {
                let ids: Vec<usize> =
                    cells.map(|cell| vertex(cell, vertices.len(), number)).collect::<Result<_, _>>()?;
                let skip = usize::from(end.is_some() && end == ids.first().copied());
                if skip == 0 {
                    sides.push(Side { name: name.clone(), points: Vec::new() });
                }
                if let Some(side) = sides.last_mut() {
                    side.points.extend(ids.iter().skip(skip).map(|&id| vertices[id]));
                }
                end = ids.last().copied();
            }
            _ => {}
        }
    }
    if sides.is_empty() {
        let why = "the file has no lines (elements `l`), and faces are passed over: export the sides of the boundary as curves or edges";
        return Err(ImportError::Sides(why.into()));
    }
    Ok(sides)
}

/// Lines with something on them, and their numbers.
fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let numbered = text.trim_start_matches('\u{feff}').lines().enumerate();
    numbered
        .map(|(k, line)| (k + 1, line.trim()))
        .filter(|(_, line)| !line.is_empty() && !line.starts_with('#'))
}

/// The index of a vertex: counted from 1, or backwards from the last.
fn vertex(cell: &str, count: usize, line: usize) -> Result<usize, ImportError> {
    let number = cell.split('/').next().and_then(|id| id.parse::<i64>().ok());
    let index = number.and_then(|id| match id {
        1.. => usize::try_from(id - 1).ok(),
        _ => usize::try_from(i64::try_from(count).ok()?.checked_add(id)?).ok(),
    });
    index.filter(|&index| index < count && number != Some(0)).ok_or_else(|| ImportError::Line {
        line,
        why: format!("there is no vertex {cell:?} above this line"),
    })
}

fn point(cells: [&str; 3], line: usize) -> Result<Point, ImportError> {
    let mut coordinates = [0.0; 3];
    for (coordinate, cell) in coordinates.iter_mut().zip(cells) {
        *coordinate = cell
            .parse::<f64>()
            .ok()
            .filter(|x| x.is_finite() && x.abs() <= MAX_COORDINATE)
            .ok_or_else(|| ImportError::Line { line, why: format!("{cell:?} is no coordinate") })?;
    }
    Ok(coordinates.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn segments_of_one_line_are_joined() {
        let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\no a\nl 1 2\nl 2 3\no b\nl 3 -3\n";
        let sides = obj(text).unwrap();
        let sizes: Vec<(&str, usize)> = sides.iter().map(|s| (s.name.as_str(), s.points.len())).collect();
        assert_eq!(sizes, [("a", 3), ("b", 2)]);
        for wrong in ["l 1", "v 0 0 0\nl 1 2", "v 0 0 0\nl 0", "v 0 0 0\nl -2", "v 0 nan 0", "v 1 2"] {
            assert!(matches!(obj(wrong), Err(ImportError::Line { .. })), "{wrong}");
        }
    }

    #[test]
    fn tables_may_have_a_heading() {
        let text = "side,\"x [mm]\",\"y [mm]\",z,remark\n# the first\nu0, 0, 0, 0\nu0;1;0;0\nv0\t0\t0\t0\n";
        let sides = table(text).unwrap();
        assert_eq!(sides.iter().map(|side| side.points.len()).collect::<Vec<_>>(), [2, 1]);
        let Err(ImportError::Line { line, .. }) = table("u0,0,0,0\nu0,0,0") else { panic!("a short row") };
        assert_eq!(line, 2);
    }
}
