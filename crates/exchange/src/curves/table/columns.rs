//! What the columns of a table mean.

use super::number::is_number;
use super::row::{Row, Separator};
use crate::LengthUnit;
use crate::curves::{CurveFileError, limits};

/// Where the side and the coordinates stand in a row.
pub(super) struct Columns {
    pub(super) side: Option<usize>,
    /// Whether the heading calls the sides rings: each is closed from its last point to its first.
    pub(super) are_rings: bool,
    /// Whether a heading says what they are.
    pub(super) is_named: bool,
    /// What the numbers are, where the heading says so: `X [mm]`.
    pub(super) unit: Option<LengthUnit>,
    /// x, y, z; without one it is 0.
    pub(super) coordinates: [Option<usize>; 3],
    /// Number of cells of a row.
    pub(super) count: usize,
}

/// What a word of a heading names.
#[derive(Clone, Copy, PartialEq)]
enum Role {
    Coordinate(usize),
    Side,
    Ring,
}

/// Names of columns of sides.
const SIDES: [&str; 20] = [
    "side", "name", "curve", "edge", "group", "id", "label", "part", "object", "layer", "line", "polyline",
    "segment", "seite", "kante", "kurve", "linie", "rand", "cote", "courbe",
];

/// Names of columns of closed curves.
const RINGS: [&str; 10] =
    ["ring", "rings", "loop", "loops", "contour", "contours", "hoop", "schleife", "boucle", "anneau"];

impl Role {
    /// What a cell of a heading names: `x`, `X [mm]`, `point_x`, `pos.x`, `Xcoord`, `"Easting (m)"`; a side or a closed curve by any of its names.
    fn of(cell: &str) -> Option<Self> {
        let cell = cell.to_lowercase();
        let cell = cell.split(['[', '(', '/', '{']).next().unwrap_or("");
        let words: Vec<&str> =
            cell.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty()).collect();
        let coordinate = words.iter().find_map(|word| {
            let word = word.trim_end_matches("coordinate").trim_end_matches("coord").trim_end_matches("pos");
            let word = word.trim_start_matches("coord").trim_start_matches("pos").trim_start_matches("point");
            match word {
                "x" | "px" | "easting" | "rechtswert" | "xmm" => Some(0),
                "y" | "py" | "northing" | "hochwert" | "ymm" => Some(1),
                "z" | "pz" | "elevation" | "elev" | "height" | "höhe" | "hoehe" | "altitude" | "zmm" => {
                    Some(2)
                }
                _ => None,
            }
        });
        if let Some(k) = coordinate {
            return Some(Self::Coordinate(k));
        }
        if words.iter().any(|word| RINGS.contains(word)) {
            return Some(Self::Ring);
        }
        words.iter().any(|word| SIDES.contains(word)).then_some(Self::Side)
    }
}

/// What every cell of a heading names; words of surveyors count where no other says which columns x and y are.
fn roles(heading: &Row<'_>) -> Result<Vec<Option<Role>>, CurveFileError> {
    let roles: Vec<Option<Role>> = heading.cells.iter().map(|cell| Role::of(cell)).collect();
    if roles.contains(&Some(Role::Coordinate(0))) || roles.contains(&Some(Role::Coordinate(1))) {
        return Ok(roles);
    }
    if let Some(cell) = heading.cells.iter().find(|cell| is_of_the_globe(cell)) {
        let name = limits::name(cell);
        let message = format!(
            "{name:?}: degrees of longitude and latitude are no lengths: project the points to metres, as GIS programs do"
        );
        return Err(CurveFileError::at(heading.line, message));
    }
    let of_survey: Vec<Option<usize>> = heading.cells.iter().map(|cell| survey(cell)).collect();
    if !of_survey.contains(&Some(0)) || !of_survey.contains(&Some(1)) {
        return Ok(roles);
    }
    let or = |(role, of_survey): (Option<Role>, Option<usize>)| role.or(of_survey.map(Role::Coordinate));
    Ok(roles.into_iter().zip(of_survey).map(or).collect())
}

impl Columns {
    /// By a heading.
    pub(super) fn named(
        heading: &Row<'_>,
        first: Option<&Row<'_>>,
        notes: &mut Vec<String>,
    ) -> Result<Self, CurveFileError> {
        let mut columns = Self {
            side: None,
            are_rings: false,
            is_named: true,
            unit: None,
            coordinates: [None; 3],
            count: heading.cells.len(),
        };
        let roles = roles(heading)?;
        for (place, role) in roles.iter().enumerate() {
            match role {
                Some(Role::Coordinate(k)) => {
                    if let Some(before) = columns.coordinates[*k].replace(place) {
                        let [a, b] = [before, place].map(|place| limits::name(&heading.cells[place]));
                        return Err(CurveFileError::at(
                            heading.line,
                            format!(
                                "the columns {a:?} and {b:?} are both {}: leave one out",
                                ["x", "y", "z"][*k]
                            ),
                        ));
                    }
                }
                Some(role @ (Role::Side | Role::Ring)) if columns.side.is_none() => {
                    (columns.side, columns.are_rings) = (Some(place), *role == Role::Ring);
                }
                Some(Role::Side | Role::Ring) | None => {}
            }
        }
        // No word of it is known: the columns stand in their usual order.
        if columns.coordinates == [None; 3]
            && let Some(first) = first
        {
            let mut columns = Self::by_position(first, &|_| false, notes)?;
            columns.count = columns.count.max(first.cells.len());
            let shown = limits::name(heading.text);
            notes.push(format!(
                "the heading {shown:?} names no columns x, y, z: they are taken in this order"
            ));
            return Ok(columns);
        }
        if let [Some(_), Some(_), _] = columns.coordinates {
            if columns.coordinates[2].is_none() {
                notes.push("the table has no column z: z = 0".into());
            }
        } else {
            return Err(CurveFileError::at(
                heading.line,
                "the heading names some of the columns x, y, z, not x and y: write side,x,y,z above them, in the order they have",
            ));
        }
        columns.look_at(heading, first, &roles, notes);
        columns.unit = columns.stated_unit(heading)?;
        Ok(columns)
    }

    /// The unit that all headings of coordinates name in brackets or behind an underscore, if they do.
    fn stated_unit(&self, heading: &Row<'_>) -> Result<Option<LengthUnit>, CurveFileError> {
        let of = |place: usize| {
            let cell = heading.cells[place].trim_end_matches([']', ')', '}']);
            let (_, word) = cell.rsplit_once(['[', '(', '/', '{', '_'])?;
            LengthUnit::of_word(word)
        };
        let stated = || self.coordinates.iter().flatten().map(|place| of(*place));
        let Some(unit) = stated().flatten().next() else { return Ok(None) };
        match stated().flatten().find(|other| *other != unit) {
            Some(other) => Err(CurveFileError::at(
                heading.line,
                format!(
                    "the headings of the coordinates name two units, {} and {}: write the numbers in one, they are not converted",
                    unit.plural(),
                    other.plural()
                ),
            )),
            None => Ok(Some(unit).filter(|_| stated().all(|other| other.is_some()))),
        }
    }

    /// Finds the column of sides where the heading does not name it: the first one that holds words. A cell more or fewer than
    /// the heading has is the row's matter, but for remarks left out.
    fn look_at(
        &mut self,
        heading: &Row<'_>,
        first: Option<&Row<'_>>,
        roles: &[Option<Role>],
        notes: &mut Vec<String>,
    ) {
        let Some(first) = first else { return };
        let is_word =
            |place: usize| first.cells.get(place).is_some_and(|cell| !cell.is_empty() && !is_number(cell));
        if self.side.is_none() {
            self.side = (0..roles.len()).find(|place| roles[*place].is_none() && is_word(*place));
        }
        let needed = self.coordinates.iter().flatten().chain(&self.side).max().map_or(0, |place| place + 1);
        if first.cells.len() < self.count && first.cells.len() >= needed {
            self.count = first.cells.len();
        }
        let used = |place: usize| self.side == Some(place) || self.coordinates.contains(&Some(place));
        let unused: Vec<String> = (0..self.count)
            .filter(|place| !used(*place))
            .map(|place| format!("{:?}", limits::name(&heading.cells[place])))
            .collect();
        if !unused.is_empty() {
            notes.push(format!("columns not used: {}", unused.join(", ")));
        }
    }

    /// Without a heading: side, x, y, z; side, x, y; x, y, z; x, y; or the side behind its coordinates, with the number of the point before
    /// them or not. `is_counted` says whether a column counts the rows.
    pub(super) fn by_position(
        row: &Row<'_>,
        is_counted: &dyn Fn(usize) -> bool,
        notes: &mut Vec<String>,
    ) -> Result<Self, CurveFileError> {
        let count = row.cells.len();
        let words: Vec<usize> = (0..count).filter(|place| !is_number(&row.cells[*place])).collect();
        let (side, coordinates) = match (count, words.as_slice()) {
            (5, [4] | [0, 4]) => {
                notes.push(
                    "the first column is not used, and the next ones are taken for x, y, z; where north stands before east, write a \
                     heading such as point,y,x,z,side"
                        .into(),
                );
                (Some(4), [Some(1), Some(2), Some(3)])
            }
            (4, [3]) => (Some(3), [Some(0), Some(1), Some(2)]),
            (4, []) if is_counted(3) && !is_counted(0) => (Some(3), [Some(0), Some(1), Some(2)]),
            (4, _) => (Some(0), [Some(1), Some(2), Some(3)]),
            (3, [0]) => (Some(0), [Some(1), Some(2), None]),
            (3, [2]) => (Some(2), [Some(0), Some(1), None]),
            (3, _) => (None, [Some(0), Some(1), Some(2)]),
            (2, _) => (None, [Some(0), Some(1), None]),
            _ => {
                return Err(CurveFileError::at(
                    row.line,
                    format!(
                        "a row is a side and three coordinates, as in u0,1.5,0,2, or x,y,z; here {}: write a heading such as \
                         side,x,y,z above the columns",
                        if count == 1 {
                            "is 1 cell (tabs, semicolons, bars (|), commas or blanks separate cells)".into()
                        } else {
                            format!("are {count} cells")
                        }
                    ),
                ));
            }
        };
        if coordinates[2].is_none() {
            notes.push("the rows have two coordinates: z = 0".into());
        }
        Ok(Self { side, are_rings: false, is_named: false, unit: None, coordinates, count })
    }

    /// Why a row is not one of this table.
    pub(super) fn short_row(&self, row: &Row<'_>, separator: Separator) -> CurveFileError {
        let cells =
            if row.cells.len() == 1 { "is 1 cell".into() } else { format!("are {} cells", row.cells.len()) };
        let hint = if row.cells.len() < self.count {
            ": a coordinate or the name of the side may be missing"
        } else {
            match separator {
                Separator::Blanks => ": names with blanks need quotes",
                Separator::Comma => ": names with commas need quotes, decimals a point",
                Separator::Tab | Separator::Semicolon | Separator::Bar => "",
            }
        };
        CurveFileError::at(
            row.line,
            format!(
                "here {cells} and the rows above have {}; {} separate them in this file{hint}",
                self.count,
                separator.name()
            ),
        )
    }
}

/// The coordinate that a heading of surveyors names: east, north, height.
fn survey(cell: &str) -> Option<usize> {
    let cell = cell.to_lowercase();
    match cell.split(['[', '(', '/', '{', '_']).next().unwrap_or("").trim() {
        "e" | "east" | "ost" => Some(0),
        "n" | "north" | "nord" => Some(1),
        "h" | "alt" => Some(2),
        _ => None,
    }
}

/// Whether a heading names degrees on the globe.
fn is_of_the_globe(cell: &str) -> bool {
    ["lat", "lon", "lng", "latitude", "longitude"].contains(&cell.trim().to_lowercase().as_str())
}
