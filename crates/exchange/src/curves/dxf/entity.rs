//! Pairs of a code and a value, and the entities they make.

use surfaces::Point;

use super::{LARGEST_COORDINATE, MOST_RECORDS};
use crate::LengthUnit;
use crate::curves::{CurveFileError, limits, text};

/// A value with its code and line.
type Pair<'a> = (i32, &'a str, usize);

/// An entity of a drawing.
pub(super) struct Entity<'a> {
    pub(super) kind: String,
    pub(super) line: usize,
    pairs: Vec<Pair<'a>>,
}

/// The plane of an entity that is given in coordinates of its own.
pub(super) struct Plane {
    pub(super) axes: [Point; 2],
    normal: Point,
}

/// What `$INSUNITS` says: a unit, or the number of one that is not known.
type StatedUnit<'a> = Option<Result<LengthUnit, &'a str>>;

/// What a drawing holds.
#[derive(Default)]
pub(super) struct Drawing<'a> {
    /// The entities of the section ENTITIES.
    pub(super) entities: Vec<Entity<'a>>,
    /// Those of the section BLOCKS.
    pub(super) blocks: Vec<Entity<'a>>,
    pub(super) unit: StatedUnit<'a>,
}

impl<'a> Drawing<'a> {
    /// The list of the entities of a section, if it has such.
    fn section(&mut self, name: &str) -> Option<&mut Vec<Entity<'a>>> {
        match name {
            "ENTITIES" => Some(&mut self.entities),
            "BLOCKS" => Some(&mut self.blocks),
            _other => None,
        }
    }
}

/// The entities of a drawing, and its unit.
pub(super) fn drawing(text: &str) -> Result<Drawing<'_>, CurveFileError> {
    let mut drawing = Drawing::default();
    let (mut section, mut variable) = ("", "");
    let (mut count, mut last_kind) = (0, "");
    for pair in pairs(text) {
        let (code, value, line) = pair?;
        match code {
            0 if value == "EOF" => return Ok(drawing),
            0 => {
                last_kind = value;
                if value == "ENDSEC" {
                    section = "";
                } else if let Some(entities) = drawing.section(section) {
                    limits::count(&mut count, 1, MOST_RECORDS, "properties of entities", line)?;
                    entities.push(Entity {
                        kind: limits::name(value).to_uppercase(),
                        line,
                        pairs: Vec::new(),
                    });
                }
            }
            2 if last_kind == "SECTION" && section.is_empty() => section = value,
            9 => variable = value,
            70 if variable == "$INSUNITS" && section == "HEADER" => drawing.unit = unit_of(value),
            _other => {
                if let Some(entity) = drawing.section(section).and_then(|entities| entities.last_mut()) {
                    limits::count(&mut count, 1, 4 * MOST_RECORDS, "properties of entities", line)?;
                    entity.pairs.push((code, value, line));
                }
            }
        }
    }
    let last = text::lines(text).map(|(number, _)| number).last().unwrap_or(1);
    Err(CurveFileError::at(last, "the file ends without EOF: it is cut short; export it again"))
}

fn pairs(text: &str) -> impl Iterator<Item = Result<Pair<'_>, CurveFileError>> {
    let mut lines = text::lines(text);
    std::iter::from_fn(move || {
        let (line, code) = lines.next()?;
        // A blank line at the end of a file.
        let Some((_, value)) = lines.next() else {
            return (!code.is_empty()).then(|| {
                Err(CurveFileError::at(line, "the file ends between a code and its value: it is cut short"))
            });
        };
        Some(match code.parse::<i32>() {
            Ok(code) => Ok((code, value, line)),
            Err(_) => Err(CurveFileError::at(
                line,
                format!("{:?} is not a code of DXF: those are whole numbers", limits::name(code)),
            )),
        })
    })
}

fn unit_of(value: &str) -> StatedUnit<'_> {
    Some(Ok(match value {
        // Without unit.
        "0" | "" => return None,
        "1" => LengthUnit::Inch,
        "2" => LengthUnit::Foot,
        "4" => LengthUnit::Millimetre,
        "5" => LengthUnit::Centimetre,
        "6" => LengthUnit::Metre,
        "7" => LengthUnit::Kilometre,
        "10" => LengthUnit::Yard,
        "13" => LengthUnit::Micrometre,
        "14" => LengthUnit::Decimetre,
        "21" => LengthUnit::SurveyFoot,
        other => return Some(Err(other)),
    }))
}

impl<'a> Entity<'a> {
    pub(super) fn wrong(&self, why: &str) -> CurveFileError {
        CurveFileError::at(self.line, format!("{}: {why}", self.kind))
    }

    pub(super) fn pairs(&self) -> &[Pair<'a>] {
        &self.pairs
    }

    pub(super) fn text(&self, code: i32) -> Option<&'a str> {
        self.pairs.iter().find(|pair| pair.0 == code).map(|pair| pair.1)
    }

    /// A finite number.
    pub(super) fn parsed(&self, pair: &Pair<'_>) -> Result<f64, CurveFileError> {
        let number = pair.1.parse::<f64>().ok().filter(|x| x.is_finite() && x.abs() <= LARGEST_COORDINATE);
        number.ok_or_else(|| {
            CurveFileError::at(
                pair.2 + 1,
                format!("{}: {:?} is not a number", self.kind, limits::name(pair.1)),
            )
        })
    }

    pub(super) fn number(&self, code: i32) -> Result<Option<f64>, CurveFileError> {
        self.pairs.iter().find(|pair| pair.0 == code).map(|pair| self.parsed(pair)).transpose()
    }

    /// A number that must be there.
    pub(super) fn need(&self, code: i32) -> Result<f64, CurveFileError> {
        self.number(code)?.ok_or_else(|| self.wrong(&format!("it has no value of code {code}")))
    }

    /// All numbers of a code, in order.
    pub(super) fn numbers(&self, code: i32) -> Result<Vec<f64>, CurveFileError> {
        self.pairs.iter().filter(|pair| pair.0 == code).map(|pair| self.parsed(pair)).collect()
    }

    /// Bits of the flags, code 70.
    pub(super) fn has_flag(&self, bit: i32) -> bool {
        self.text(70).and_then(|value| value.parse::<i32>().ok()).is_some_and(|flags| flags & bit != 0)
    }

    /// The point with x of the given code, y of that plus 10, z plus 20; z is 0 where it is missing.
    pub(super) fn point(&self, code: i32) -> Result<Point, CurveFileError> {
        Ok(Point::new(self.need(code)?, self.need(code + 10)?, self.number(code + 20)?.unwrap_or(0.0)))
    }

    /// All points of a code: x begins one, y and z that follow belong to it.
    pub(super) fn points(&self, code: i32) -> Result<Vec<Point>, CurveFileError> {
        let mut points: Vec<Point> = Vec::new();
        for pair in &self.pairs {
            if pair.0 == code {
                points.push(Point::new(self.parsed(pair)?, 0.0, 0.0));
            } else if let (10 | 20, Some(point)) = (pair.0 - code, points.last_mut()) {
                *(if pair.0 - code == 10 { &mut point.y } else { &mut point.z }) = self.parsed(pair)?;
            }
        }
        Ok(points)
    }

    pub(super) fn vector(&self, code: i32) -> Result<Option<Point>, CurveFileError> {
        if self.text(code).is_none() { Ok(None) } else { self.point(code).map(Some) }
    }
}

impl Plane {
    /// The plane perpendicular to the extrusion, its axes by DXF's arbitrary axis algorithm.
    pub(super) fn of(entity: &Entity<'_>) -> Result<Self, CurveFileError> {
        let given = entity.vector(210)?.unwrap_or(Point::new(0.0, 0.0, 1.0));
        let normal = given.unit().ok_or_else(|| entity.wrong("its extrusion has length 0"))?;
        let near = 1.0 / 64.0;
        let aside = if normal.x.abs() < near && normal.y.abs() < near {
            Point::new(0.0, 1.0, 0.0)
        } else {
            Point::new(0.0, 0.0, 1.0)
        };
        let first = aside.cross(normal).unit().ok_or_else(|| entity.wrong("its extrusion has no plane"))?;
        Ok(Self { axes: [first, normal.cross(first)], normal })
    }

    /// A point of the plane's coordinates in space.
    pub(super) fn placed(&self, p: Point) -> Point {
        if self.normal == Point::new(0.0, 0.0, 1.0) {
            return p;
        }
        self.axes[0] * p.x + self.axes[1] * p.y + self.normal * p.z
    }
}
