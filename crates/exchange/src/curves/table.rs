//! Tables of points: CSV and its relatives.

use std::collections::HashMap;

use surfaces::Point;

use crate::unit::Commented;
use crate::{LengthUnit, Sentence};

use super::limits::{self, LARGEST_COORDINATE, MOST_CURVES, MOST_POINTS};
use super::{CurveFile, CurveFileError, FileCurve, Kind, Shape, text};

mod columns;
mod number;
mod row;

use columns::Columns;
use row::{Row, Separator};

/// The sides of a table, in the order of their first rows, points in the order of theirs. One separator (tab, semicolon, bar, comma
/// or blanks) divides the whole file; where it is no comma, decimals may have one. Columns are found by the heading, or stand as
/// side, x, y, z. Lines that begin with # are passed over. A table without a column of sides is one loop, or one for each block
/// between blank lines; so is one in which every row has a name of its own, as surveys have: these are names of points. A column called
/// `ring` or `loop` names closed curves, which need not come back to their first point.
pub(super) fn read(text: &str) -> Result<CurveFile, CurveFileError> {
    let separator = Separator::of(text);
    let mut rows = row::rows(text, separator);
    let mut notes = Vec::new();
    let Some(first) = rows.next() else {
        return Err(CurveFileError::File(
            "holds no rows: a row is a side and three coordinates, as in u0,1.5,0,2".into(),
        ));
    };
    let (columns, rest) = if first.is_heading() {
        let second = rows.next();
        (Columns::named(&first, second.as_ref(), &mut notes)?, second)
    } else {
        let is_counted = |place| row::are_counted(text, separator, place);
        (Columns::by_position(&first, &is_counted, &mut notes)?, Some(first))
    };
    let mut sides = Sides::default();
    for row in rest.into_iter().chain(rows) {
        sides.add(&row, &columns, separator)?;
    }
    sides.finish(&columns, unit(&columns, text)?, notes)
}

/// The unit of the numbers with what says so, if something does.
fn unit(columns: &Columns, text: &str) -> Result<Option<(LengthUnit, &'static str)>, CurveFileError> {
    let mut comments = Commented::default();
    text::lines(text)
        .filter_map(|(_, line)| line.strip_prefix('#'))
        .for_each(|comment| comments.hear(comment));
    match (columns.unit, comments.unit()) {
        (Some(heading), Some(comment)) if heading != comment => Err(CurveFileError::File(format!(
            "its heading names {} and a comment {}: leave one out, for numbers are not converted",
            heading.plural(),
            comment.plural()
        ))),
        (Some(unit), _) => Ok(Some((unit, "the heading"))),
        (None, unit) => Ok(unit.map(|unit| (unit, "a comment of the file"))),
    }
}

#[derive(Default)]
struct Sides {
    curves: Vec<FileCurve>,
    places: HashMap<String, usize>,
    /// The block in which each curve begins.
    blocks: Vec<usize>,
    points: usize,
    /// The block of the last row.
    block: Option<usize>,
    /// The line of the first number with a decimal comma, and of the first with a point.
    decimals: [Option<usize>; 2],
}

impl Sides {
    fn add(&mut self, row: &Row<'_>, columns: &Columns, separator: Separator) -> Result<(), CurveFileError> {
        let line = row.line;
        if row.cells.len() != columns.count {
            return Err(columns.short_row(row, separator));
        }
        let mut coordinates = [0.0; 3];
        for (coordinate, place) in coordinates.iter_mut().zip(columns.coordinates) {
            if let Some(place) = place {
                *coordinate = self.coordinate(&row.cells[place], line, separator)?;
            }
        }
        limits::count(&mut self.points, 1, MOST_POINTS, "points", line)?;
        let point = Point::from(coordinates);
        let place = match columns.side {
            Some(column) => self.place_of(&row.cells[column], row)?,
            None if self.block == Some(row.block) => self.curves.len() - 1,
            None => self.begin(String::new(), row)?,
        };
        self.block = Some(row.block);
        if let Shape::Polyline(points) = &mut self.curves[place].shape {
            points.push(point);
        }
        Ok(())
    }

    fn place_of(&mut self, cell: &str, row: &Row<'_>) -> Result<usize, CurveFileError> {
        let name = limits::name(cell);
        if let Some(place) = self.places.get(&name) {
            return Ok(*place);
        }
        let place = self.begin(name.clone(), row)?;
        self.places.insert(name, place);
        Ok(place)
    }

    fn begin(&mut self, name: String, row: &Row<'_>) -> Result<usize, CurveFileError> {
        let line = row.line;
        let mut counter = self.curves.len();
        limits::count(&mut counter, 1, MOST_CURVES, "sides", line)?;
        self.blocks.push(row.block);
        self.curves.push(FileCurve {
            name,
            line,
            shape: Shape::Polyline(Vec::new()),
            closes: false,
            joints: Vec::new(),
        });
        Ok(self.curves.len() - 1)
    }

    fn coordinate(&mut self, cell: &str, line: usize, separator: Separator) -> Result<f64, CurveFileError> {
        let no_coordinate =
            |why: &str| CurveFileError::at(line, format!("{:?} is no coordinate{why}", limits::name(cell)));
        let has_comma = cell.contains(',');
        if has_comma && (separator == Separator::Comma || cell.contains('.') || cell.matches(',').count() > 1)
        {
            return Err(no_coordinate(": write numbers without separators of thousands"));
        }
        if has_comma || cell.contains('.') {
            self.decimals[usize::from(!has_comma)].get_or_insert(line);
            if let [Some(comma), Some(point)] = self.decimals {
                return Err(CurveFileError::at(
                    comma.max(point),
                    format!(
                        "decimals have a comma in line {comma} and a point in line {point}: write all of them one way"
                    ),
                ));
            }
        }
        let plain = number::plain(cell);
        let number = if has_comma { plain.replace(',', ".").parse::<f64>() } else { plain.parse() };
        let number = number.map_err(|_| no_coordinate(&number::obstacle(cell)))?;
        if number.is_finite() && number.abs() <= LARGEST_COORDINATE {
            Ok(number)
        } else if number.is_finite() {
            Err(no_coordinate(&format!(": the largest is {LARGEST_COORDINATE:e}")))
        } else {
            Err(no_coordinate(
                ": a point needs three finite numbers; leave the row out, or measure the point again",
            ))
        }
    }

    fn finish(
        mut self,
        columns: &Columns,
        unit: Option<(LengthUnit, &str)>,
        mut notes: Vec<String>,
    ) -> Result<CurveFile, CurveFileError> {
        if self.curves.is_empty() {
            return Err(CurveFileError::File("holds a heading and no points below it".into()));
        }
        let names_points = self.join_points(columns)?;
        if names_points {
            notes.push(
                "every row has a name of its own: they are names of points, which are one loop, closed from the last to the first".into(),
            );
        }
        let is_nameless = columns.side.is_none();
        for curve in &mut self.curves {
            let Shape::Polyline(points) = &curve.shape else { continue };
            if points.len() < 2 {
                let side = if curve.name.is_empty() {
                    "a curve".to_owned()
                } else {
                    format!("side {:?}", curve.name)
                };
                return Err(CurveFileError::at(
                    curve.line,
                    format!("{side} has a single point; at least two are needed"),
                ));
            }
            curve.closes = is_nameless || names_points || columns.are_rings;
        }
        if columns.are_rings {
            notes.push(
                "the curves of the table are rings: each is closed from its last point to its first".into(),
            );
        }
        if is_nameless {
            let count = self.curves.len();
            notes.push(if count == 1 {
                "the table has no column of sides: its points are one loop, closed from the last to the first".into()
            } else {
                format!("the table has no column of sides: its {count} blocks between blank lines are a curve each")
            });
        }
        if let Some((unit, said_by)) = unit {
            notes.push(format!("lengths are in {}, as {said_by} says", unit.plural()));
        }
        let notes = notes.into_iter().map(Sentence::from).collect();
        let unit = unit.map(|(unit, _)| unit);
        Ok(CurveFile { kind: Kind::Table, curves: self.curves, unit, notes })
    }

    /// Joins sides of one point each, three or more, to one curve a block: their names are those of the points. Whether they were such.
    fn join_points(&mut self, columns: &Columns) -> Result<bool, CurveFileError> {
        let is_point =
            |curve: &FileCurve| matches!(&curve.shape, Shape::Polyline(points) if points.len() == 1);
        if columns.side.is_none() || self.curves.len() < 3 || !self.curves.iter().all(is_point) {
            return Ok(false);
        }
        let number = |curve: &FileCurve| curve.name.replacen(',', ".", 1).parse::<f64>().ok();
        let is_measured = self.curves.iter().all(|curve| number(curve).is_some())
            && self.curves.iter().filter_map(number).any(|x| x.fract() != 0.0);
        if is_measured && !columns.is_named {
            return Err(CurveFileError::at(
                self.curves[0].line,
                "four numbers a row: which of them are the coordinates? Write a heading above them, such as point,x,y,z or x,y,z,point",
            ));
        }
        let mut joined: Vec<FileCurve> = Vec::new();
        let mut last = None;
        for (mut curve, block) in self.curves.drain(..).zip(self.blocks.drain(..)) {
            match joined.last_mut() {
                Some(loop_) if last == Some(block) => {
                    if let (Shape::Polyline(points), Shape::Polyline(more)) = (&mut loop_.shape, curve.shape)
                    {
                        points.extend(more);
                    }
                }
                _ => {
                    curve.name.clear();
                    joined.push(curve);
                }
            }
            last = Some(block);
        }
        self.curves = joined;
        Ok(true)
    }
}
