//! Wavefront OBJ: lines and free-form curves.

use surfaces::Point;

use super::limits::{self, MOST_CURVES, MOST_POINTS};
use super::{CurveFile, CurveFileError, FileCurve, Kind, Shape, text};
use crate::Sentence;
use crate::unit::Commented;

mod free_form;

use free_form::{Family, FreeForm, family};

/// An index of a vertex: counted from 0; vertices may stand below the line that names them.
struct Index {
    vertex: usize,
    line: usize,
    /// As it is written.
    cell: String,
}

/// A curve whose vertices are not looked up yet.
struct Draft {
    name: String,
    line: usize,
    indices: Vec<Index>,
    /// Where one of its lines ends and the next begins, unless they are single segments.
    joints: Vec<usize>,
    free_form: Option<FreeForm>,
}

#[derive(Default)]
struct Reader {
    vertices: Vec<(Point, f64, usize)>,
    drafts: Vec<Draft>,
    name: String,
    family: Option<(Family, bool)>,
    degree: Option<usize>,
    /// Whether a `curv` waits for its `parm` and `end`.
    is_open: bool,
    faces: usize,
    references: usize,
    passed_over: Vec<&'static str>,
    /// Whether the last curve is made of single segments.
    is_chain: bool,
    comments: Commented,
}

/// The lines (`l`) and curves (`curv`) of an OBJ file, named by the last `o` or `g` before them. Lines that go on where the one
/// before in the same object ended are one.
pub(super) fn read(text: &str) -> Result<CurveFile, CurveFileError> {
    let mut reader = Reader::default();
    let mut joined = String::new();
    let mut begin = 0;
    for (number, line) in text::lines(text) {
        // A backslash joins a line to the next.
        let (part, goes_on) = line.strip_suffix('\\').map_or((line, false), |part| (part, true));
        if joined.is_empty() {
            begin = number;
        }
        if joined.is_empty() && !goes_on {
            reader.statement(part, number)?;
            continue;
        }
        joined.push_str(part);
        joined.push(' ');
        if !goes_on {
            reader.statement(&joined, begin)?;
            joined.clear();
        }
    }
    if !joined.is_empty() {
        reader.statement(&joined, begin)?;
    }
    reader.finish()
}

impl Reader {
    fn statement(&mut self, line: &str, number: usize) -> Result<(), CurveFileError> {
        let (line, comment) = line.split_once('#').unwrap_or((line, ""));
        self.comments.hear(comment);
        let mut cells = line.split_whitespace();
        let Some(word) = cells.next() else { return Ok(()) };
        match word {
            "v" => self.vertex(cells, number)?,
            "o" | "g" => self.name = limits::name(&cells.collect::<Vec<_>>().join(" ")),
            "l" => {
                let indices = self.indices(cells, number)?;
                if indices.len() < 2 {
                    return Err(CurveFileError::at(
                        number,
                        "a line joins two or more vertices, as in `l 1 2 3`",
                    ));
                }
                let name = self.name.clone();
                self.draft(Draft { name, line: number, indices, joints: Vec::new(), free_form: None })?;
            }
            "cstype" => self.family = Some(family(&cells.collect::<Vec<_>>(), number)?),
            "deg" => {
                let degree = cells.next().and_then(|cell| cell.parse().ok());
                self.degree = Some(degree.ok_or_else(|| {
                    CurveFileError::at(number, "`deg` is followed by a degree, as in `deg 3`")
                })?);
            }
            "curv" => self.curve(cells, number)?,
            "parm" => self.parameters(cells, number)?,
            "end" => self.is_open = false,
            "f" | "fo" => self.faces += 1,
            "curv2" => self.pass_over("curves in parameter spaces (`curv2`)"),
            "surf" => self.pass_over("free-form surfaces (`surf`)"),
            _ => {}
        }
        Ok(())
    }

    fn pass_over(&mut self, what: &'static str) {
        if !self.passed_over.contains(&what) {
            self.passed_over.push(what);
        }
    }

    fn vertex<'a>(
        &mut self,
        cells: impl Iterator<Item = &'a str>,
        line: usize,
    ) -> Result<(), CurveFileError> {
        let mut numbers = [0.0, 0.0, 0.0, 1.0];
        let mut count = 0;
        for (k, cell) in cells.enumerate() {
            // Six numbers are a point and a colour.
            if k < 4 {
                numbers[k] = if k < 3 { coordinate(cell, line)? } else { number(cell, line)? };
            }
            count = k + 1;
        }
        if count < 3 {
            return Err(CurveFileError::at(
                line,
                format!("a vertex has three coordinates; here are {count}"),
            ));
        }
        let mut counter = self.vertices.len();
        limits::count(&mut counter, 1, MOST_POINTS, "vertices", line)?;
        let weight = if count == 4 { numbers[3] } else { 1.0 };
        self.vertices.push((Point::new(numbers[0], numbers[1], numbers[2]), weight, line));
        Ok(())
    }

    fn indices<'a>(
        &mut self,
        cells: impl Iterator<Item = &'a str>,
        line: usize,
    ) -> Result<Vec<Index>, CurveFileError> {
        let mut indices = Vec::new();
        for cell in cells {
            limits::count(&mut self.references, 1, MOST_POINTS, "vertices of curves", line)?;
            indices.push(self.index(cell, line)?);
        }
        Ok(indices)
    }

    /// Counted from 1, or backwards from the last vertex so far.
    fn index(&self, cell: &str, line: usize) -> Result<Index, CurveFileError> {
        let number = cell.split('/').next().and_then(|id| id.parse::<i64>().ok());
        let vertex = number.and_then(|id| match id {
            0 => None,
            1.. => usize::try_from(id - 1).ok(),
            _ => usize::try_from(i64::try_from(self.vertices.len()).ok()?.checked_add(id)?).ok(),
        });
        let vertex = vertex.ok_or_else(|| {
            CurveFileError::at(line, format!("there is no vertex {cell:?} above this line"))
        })?;
        Ok(Index { vertex, line, cell: cell.chars().take(24).collect() })
    }

    fn draft(&mut self, draft: Draft) -> Result<(), CurveFileError> {
        let is_segment = draft.free_form.is_none() && draft.indices.len() == 2;
        // Segments written one by one are joined as they come; the assembly joins the others.
        if let Some(last) = self.drafts.last_mut()
            && draft.free_form.is_none()
            && last.free_form.is_none()
            && last.name == draft.name
            && last.indices.last().map(|index| index.vertex)
                == draft.indices.first().map(|index| index.vertex)
            && last.indices.first().map(|index| index.vertex) != last.indices.last().map(|index| index.vertex)
        {
            self.is_chain &= is_segment;
            if !self.is_chain {
                last.joints.push(last.indices.len() - 1);
            }
            last.indices.extend(draft.indices.into_iter().skip(1));
            return Ok(());
        }
        self.is_chain = is_segment;
        // Segments are joined by the assembly: more of them than curves may stand in a file.
        let mut counter = self.drafts.len();
        limits::count(
            &mut counter,
            1,
            if draft.indices.len() == 2 { 10 * MOST_CURVES } else { MOST_CURVES },
            "curves",
            draft.line,
        )?;
        self.drafts.push(draft);
        Ok(())
    }

    fn curve<'a>(
        &mut self,
        mut cells: impl Iterator<Item = &'a str>,
        line: usize,
    ) -> Result<(), CurveFileError> {
        let Some((family, is_rational)) = self.family else {
            return Err(CurveFileError::at(
                line,
                "a curve needs its kind before it, as in `cstype bspline`, and `deg 3`",
            ));
        };
        let Some(degree) = self.degree else {
            return Err(CurveFileError::at(line, "a curve needs its degree before it, as in `deg 3`"));
        };
        let mut end = || cells.next().map(|cell| number(cell, line));
        let (Some(from), Some(to)) = (end(), end()) else {
            return Err(CurveFileError::at(
                line,
                "a curve is `curv`, its first and last parameter, and its vertices: `curv 0 1 1 2 3 4`",
            ));
        };
        let ends = [from?, to?];
        let indices = self.indices(cells, line)?;
        let free_form = FreeForm { family, is_rational, degree, ends, parameters: Vec::new() };
        let name = self.name.clone();
        self.draft(Draft { name, line, indices, joints: Vec::new(), free_form: Some(free_form) })?;
        self.is_open = true;
        Ok(())
    }

    fn parameters<'a>(
        &mut self,
        mut cells: impl Iterator<Item = &'a str>,
        line: usize,
    ) -> Result<(), CurveFileError> {
        if cells.next() != Some("u") || !self.is_open {
            return Ok(());
        }
        let Some(free_form) = self.drafts.last_mut().and_then(|draft| draft.free_form.as_mut()) else {
            return Ok(());
        };
        for cell in cells {
            limits::count(&mut self.references, 1, MOST_POINTS, "vertices and parameters of curves", line)?;
            free_form.parameters.push(number(cell, line)?);
        }
        Ok(())
    }

    fn finish(self) -> Result<CurveFile, CurveFileError> {
        if self.drafts.is_empty() {
            return Err(nothing(&self));
        }
        let curves = self.drafts.iter().map(|draft| {
            let shape = self.shape(draft)?;
            let (name, joints) = (draft.name.clone(), draft.joints.clone());
            Ok(FileCurve { name, line: draft.line, shape, closes: false, joints })
        });
        let curves = curves.collect::<Result<Vec<_>, CurveFileError>>()?;
        let mut notes: Vec<String> =
            self.passed_over.iter().map(|what| format!("{what} were passed over")).collect();
        if self.faces > 0 {
            notes.push(format!(
                "{} faces of a mesh were passed over; the curves are the file's lines",
                self.faces
            ));
        }
        let unit = self.comments.unit();
        if let Some(unit) = unit {
            notes.push(format!("lengths are in {}, as a comment of the file says", unit.plural()));
        }
        let notes = notes.into_iter().map(Sentence::from).collect();
        Ok(CurveFile { kind: Kind::Obj, curves, unit, notes })
    }

    fn shape(&self, draft: &Draft) -> Result<Shape, CurveFileError> {
        let mut found = Vec::with_capacity(draft.indices.len());
        for index in &draft.indices {
            let vertex = self.vertices.get(index.vertex).ok_or_else(|| {
                CurveFileError::at(
                    index.line,
                    format!("there is no vertex {:?}: the file has {}", index.cell, self.vertices.len()),
                )
            })?;
            found.push(*vertex);
        }
        let Some(free_form) = &draft.free_form else {
            // A weight is no part of a straight line; whoever wrote one meant a rational curve.
            if let Some((_, weight, line)) = found.iter().find(|(_, weight, _)| *weight != 1.0) {
                return Err(CurveFileError::at(
                    *line,
                    format!(
                        "this vertex of a line (`l`) has the weight {weight}, and a line has none: leave the weight out, or write a \
                         rational curve (`cstype rat bspline`, `curv`)"
                    ),
                ));
            }
            return Ok(Shape::Polyline(found.into_iter().map(|(point, _, _)| point).collect()));
        };
        let weights = free_form.is_rational.then(|| found.iter().map(|(_, weight, _)| *weight).collect());
        let points = found.into_iter().map(|(point, _, _)| point).collect();
        free_form
            .spline(points, weights)
            .map(Shape::Spline)
            .map_err(|why| CurveFileError::at(draft.line, format!("this curve cannot be read: {why}")))
    }
}

fn nothing(reader: &Reader) -> CurveFileError {
    CurveFileError::File(if reader.faces > 0 {
        format!(
            "is a mesh of {} faces without lines (elements `l`) or curves (`curv`): export the rim as curves or edges, in Blender by selecting \
             the edges of the rim, separating them and exporting the selection, then `plateau fill rim.obj -o surface.step`",
            reader.faces
        )
    } else {
        "the file has no lines (elements `l`) and no curves (`curv`): export the sides of the boundary as curves or edges".into()
    })
}

fn number(cell: &str, line: usize) -> Result<f64, CurveFileError> {
    cell.parse::<f64>()
        .ok()
        .filter(|x| x.is_finite())
        .ok_or_else(|| CurveFileError::at(line, format!("{:?} is not a number", limits::name(cell))))
}

/// A coordinate within what is read.
pub(super) fn coordinate(cell: &str, line: usize) -> Result<f64, CurveFileError> {
    cell.parse::<f64>()
        .ok()
        .filter(|x| x.is_finite() && x.abs() <= limits::LARGEST_COORDINATE)
        .ok_or_else(|| CurveFileError::at(line, format!("{:?} is no coordinate", limits::name(cell))))
}
