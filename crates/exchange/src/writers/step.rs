//! STEP (ISO 10303-21, AP214): a patch as one face on a B-spline surface.
//!
//! STEP wants a unit of length; experiments have none. The numbers are written unchanged, as what is asked for, else as millimetres.

use std::io::{self, Write};

use surfaces::{Knots, Point, SplineSurface};
use thiserror::Error;

use super::spline::{Accuracy, LARGEST_DEGREE, SplineError, described, spline};
use crate::LengthUnit;
use plateau::{Family, Surface};

/// Share of the size below which points of the border are one point and curves of it one curve.
const SAME: f64 = 1e-10;

/// Smallest distance CAD programs tell apart, in the unit of the file.
pub(super) const SMALLEST_TOLERANCE: f64 = 1e-7;

/// Lengths from which on CAD programs take a coordinate for infinite.
const INFINITE: f64 = 1e99;

/// Why STEP cannot hold a surface.
#[derive(Debug, Clone, PartialEq, Error)]
pub(crate) enum StepError {
    /// There is no spline.
    #[error(transparent)]
    Spline(#[from] SplineError),
    /// It is one point to whoever reads it.
    #[error(
        "{part} is {length:.1e} across, and points of STEP are told apart from 1e-7 on: scale the boundary"
    )]
    TooSmall {
        /// What is too small.
        part: &'static str,
        /// The diagonal of the box around its control points.
        length: f64,
    },
    /// Coordinates that mean nothing to CAD programs.
    #[error(
        "it has coordinates up to {largest:.1e}, and CAD programs take those above 1e99 for infinite: scale the boundary"
    )]
    TooLarge {
        /// The largest coordinate of a control point.
        largest: f64,
    },
    /// Polynomials of high degree are refused by the programs that read the file.
    #[error(
        "its patches have degree {degree}, and OpenCASCADE reads degrees up to {LARGEST_DEGREE}: lower the degree, or write a mesh (glb, ply)"
    )]
    Degree {
        /// Degree of the patches.
        degree: usize,
    },
}

/// A surface as it goes into the file.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct StepFile {
    spline: SplineSurface,
    accuracy: Accuracy,
    size: f64,
}

/// One side of the face: from one corner to another along a curve of the net.
struct Side {
    knots: usize,
    points: Vec<Point>,
    ends: [usize; 2],
    /// Whether the border follows it, in the sense that leaves the face on the left.
    forward: bool,
}

impl StepFile {
    /// The file of a surface, the spline exact or within `tolerance` times its size.
    ///
    /// # Errors
    /// [`StepError`] if there is no such spline, or none that CAD programs can read.
    pub(crate) fn new(surface: &Surface, family: Family, tolerance: f64) -> Result<Self, StepError> {
        let (spline, accuracy) = spline(surface, family, tolerance)?;
        let size = checked_size(spline.points())?;
        let file = Self { spline, accuracy, size };
        // In the order of `sides`.
        let names = ["its side v = start", "its side u = end", "its side v = end", "its side u = start"];
        for (side, part) in file.sides().iter().zip(names) {
            let length = super::extent::diagonal(side.points.iter().map(|p| [p.x, p.y, p.z]));
            // A side in one point, up to rounding, has no edge.
            if length < 2.0 * SMALLEST_TOLERANCE && !file.is_point(side) {
                return Err(StepError::TooSmall { part, length });
            }
        }
        Ok(file)
    }

    fn is_point(&self, side: &Side) -> bool {
        side.points.iter().all(|&p| self.same(p, side.points[0]))
    }

    /// The largest distance from the patch that the file states; none if the surface is the patch itself.
    pub(crate) fn deviation(&self) -> Option<f64> {
        self.accuracy.deviation()
    }

    /// What the surface is, for people.
    pub(crate) fn description(&self) -> String {
        described(&self.spline, self.accuracy)
    }

    /// Writes the whole file.
    pub(crate) fn write(&self, name: &str, unit: LengthUnit, out: &mut dyn Write) -> io::Result<()> {
        document((name, &self.description()), (self.size, unit), out, |title, entities| {
            let face = self.face(title, entities)?;
            Ok(vec![entities.add(format_args!("OPEN_SHELL('',(#{face}))"))?])
        })
    }

    /// The surface, bounded by the four curves of its border. Sides that are one point have no edge; opposite sides that
    /// coincide are one edge, run through twice.
    fn face(&self, title: &str, entities: &mut Entities<'_>) -> io::Result<usize> {
        let surface = surface(self.spline.points(), self.spline.knots(), entities)?;
        let corners = self.corners();
        let mut vertices: Vec<(Point, usize)> = Vec::new();
        let mut edges: Vec<(Vec<Point>, usize)> = Vec::new();
        let mut border = Vec::new();
        for side in self.sides() {
            // STEP has no edges without length: the loop goes on from the one vertex.
            if self.is_point(&side) {
                continue;
            }
            let mut ends = [0; 2];
            for (end, corner) in ends.iter_mut().zip(side.ends.map(|k| corners[k])) {
                *end = match vertices.iter().find(|(p, _)| self.same(*p, corner)) {
                    Some((_, vertex)) => *vertex,
                    None => {
                        let point = entities.point(corner)?;
                        let vertex = entities.add(format_args!("VERTEX_POINT('',#{point})"))?;
                        vertices.push((corner, vertex));
                        vertex
                    }
                };
            }
            // Closed surfaces meet themselves: readers sew a seam only if both sides name one edge.
            let twin = |points: &[Point]| {
                points.len() == side.points.len()
                    && points.iter().zip(&side.points).all(|(&p, &q)| self.same(p, q))
            };
            let edge = match edges.iter().find(|(points, _)| twin(points)) {
                Some((_, edge)) => *edge,
                None => {
                    let curve = curve(&side.points, &self.spline.knots()[side.knots], entities)?;
                    let [start, end] = ends;
                    entities.add(format_args!("EDGE_CURVE('',#{start},#{end},#{curve},.T.)"))?
                }
            };
            let sense = if side.forward { ".T." } else { ".F." };
            border.push(entities.add(format_args!("ORIENTED_EDGE('',*,*,#{edge},{sense})"))?);
            edges.push((side.points, edge));
        }
        let border = references(&border);
        let border = entities.add(format_args!("EDGE_LOOP('',({border}))"))?;
        let border = entities.add(format_args!("FACE_OUTER_BOUND('',#{border},.T.)"))?;
        entities.add(format_args!("ADVANCED_FACE({title},(#{border}),#{surface},.T.)"))
    }

    /// (u, v) at (start, start), (end, start), (end, end), (start, end).
    fn corners(&self) -> [Point; 4] {
        let (points, cols) = (&self.spline.points(), self.spline.cols());
        [points[0], points[points.len() - cols], points[points.len() - 1], points[cols - 1]]
    }

    /// The border, in the sense in which it runs around the face.
    fn sides(&self) -> [Side; 4] {
        // Points stand row by row with u: a column is a side v = constant, a row one u = constant.
        let (points, cols) = (&self.spline.points(), self.spline.cols());
        let column = |j: usize| points.iter().skip(j).step_by(cols).copied().collect();
        let last = points.len() - cols;
        [
            Side { knots: 0, points: column(0), ends: [0, 1], forward: true },
            Side { knots: 1, points: points[last..].to_vec(), ends: [1, 2], forward: true },
            Side { knots: 0, points: column(cols - 1), ends: [3, 2], forward: false },
            Side { knots: 1, points: points[..cols].to_vec(), ends: [0, 3], forward: false },
        ]
    }

    fn same(&self, p: Point, q: Point) -> bool {
        p.distance(q) <= SAME * self.size
    }
}

/// Checks the control points of a surface. Gives its size.
pub(super) fn checked_size(points: &[Point]) -> Result<f64, StepError> {
    let coordinates = || points.iter().flat_map(|p| [p.x, p.y, p.z]);
    if !coordinates().all(|x| x.abs() <= INFINITE) {
        let largest = coordinates().fold(0.0, |m: f64, x| m.max(x.abs()));
        return Err(StepError::TooLarge { largest });
    }
    let size = super::extent::diagonal(points.iter().map(|p| [p.x, p.y, p.z]));
    if size < 2.0 * SMALLEST_TOLERANCE {
        return Err(StepError::TooSmall { part: "it", length: size });
    }
    Ok(size)
}

/// A whole file around shells: `shells` writes them, given the name as a string of the file, and gives their numbers.
pub(super) fn document(
    (name, description): (&str, &str),
    (size, unit): (f64, LengthUnit),
    out: &mut dyn Write,
    shells: impl FnOnce(&str, &mut Entities<'_>) -> io::Result<Vec<usize>>,
) -> io::Result<()> {
    let (title, version) = (text(name), concat!("plateau ", env!("CARGO_PKG_VERSION")));
    writeln!(out, "ISO-10303-21;\nHEADER;")?;
    writeln!(out, "FILE_DESCRIPTION(({title},{}),'2;1');", text(description))?;
    writeln!(out, "FILE_NAME({title},'',(''),(''),'{version}','{version}','');")?;
    writeln!(out, "FILE_SCHEMA(('AUTOMOTIVE_DESIGN {{ 1 0 10303 214 1 1 1 1 }}'));\nENDSEC;\nDATA;")?;
    // Entities are numbered as they are written, so that what is referred to comes first.
    let mut entities = Entities { out, count: 0 };
    let context = context(size, unit, &mut entities)?;
    let shape = product(&title, &mut entities)?;
    let shells = references(&shells(&title, &mut entities)?);
    let model = entities.add(format_args!("SHELL_BASED_SURFACE_MODEL('',({shells}))"))?;
    let origin = entities.point(Point::ZERO)?;
    let axes = entities.add(format_args!("AXIS2_PLACEMENT_3D('',#{origin},$,$)"))?;
    let model = entities
        .add(format_args!("MANIFOLD_SURFACE_SHAPE_REPRESENTATION({title},(#{axes},#{model}),#{context})"))?;
    entities.add(format_args!("SHAPE_DEFINITION_REPRESENTATION(#{shape},#{model})"))?;
    writeln!(out, "ENDSEC;\nEND-ISO-10303-21;")
}

/// Units and the accuracy of the geometry.
fn context(size: f64, unit: LengthUnit, entities: &mut Entities<'_>) -> io::Result<usize> {
    let length = length_unit(unit, entities)?;
    let angle = entities.add(format_args!("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))"))?;
    let solid = entities.add(format_args!("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())"))?;
    // What STEP readers may take for one point: never below what they tell apart.
    let accuracy = real(SMALLEST_TOLERANCE.max(SAME * size));
    let accuracy = entities.add(format_args!(
        "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE({accuracy}),#{length},'distance_accuracy_value',\
         'points closer than this are one')"
    ))?;
    entities.add(format_args!(
        "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#{accuracy}))\
         GLOBAL_UNIT_ASSIGNED_CONTEXT((#{length},#{angle},#{solid}))REPRESENTATION_CONTEXT('',''))"
    ))
}

/// The unit of length: of the metric system, or so many millimetres.
fn length_unit(unit: LengthUnit, entities: &mut Entities<'_>) -> io::Result<usize> {
    let mut metric =
        |prefix: &str| entities.add(format_args!("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT({prefix},.METRE.))"));
    let name = match unit {
        LengthUnit::Micrometre => return metric(".MICRO."),
        LengthUnit::Millimetre => return metric(".MILLI."),
        LengthUnit::Centimetre => return metric(".CENTI."),
        LengthUnit::Decimetre => return metric(".DECI."),
        LengthUnit::Metre => return metric("$"),
        LengthUnit::Kilometre => return metric(".KILO."),
        LengthUnit::Inch => "INCH",
        LengthUnit::Foot => "FOOT",
        LengthUnit::Yard => "YARD",
        LengthUnit::SurveyFoot => "US SURVEY FOOT",
    };
    let one = metric(".MILLI.")?;
    let measure = real(unit.millimetres());
    let measure = entities.add(format_args!("LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE({measure}),#{one})"))?;
    let exponents = entities.add(format_args!("DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)"))?;
    entities.add(format_args!(
        "(CONVERSION_BASED_UNIT('{name}',#{measure})LENGTH_UNIT()NAMED_UNIT(#{exponents}))"
    ))
}

/// The administration around a shape.
fn product(title: &str, entities: &mut Entities<'_>) -> io::Result<usize> {
    let application = entities
        .add(format_args!("APPLICATION_CONTEXT('core data for automotive mechanical design processes')"))?;
    entities.add(format_args!(
        "APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#{application})"
    ))?;
    let context = entities.add(format_args!("PRODUCT_CONTEXT('',#{application},'mechanical')"))?;
    let product = entities.add(format_args!("PRODUCT({title},{title},'',(#{context}))"))?;
    let formation = entities.add(format_args!("PRODUCT_DEFINITION_FORMATION('','',#{product})"))?;
    let stage = entities
        .add(format_args!("PRODUCT_DEFINITION_CONTEXT('part definition',#{application},'design')"))?;
    let definition = entities.add(format_args!("PRODUCT_DEFINITION('design','',#{formation},#{stage})"))?;
    entities.add(format_args!("PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,(#{product}))"))?;
    entities.add(format_args!("PRODUCT_DEFINITION_SHAPE('','',#{definition})"))
}

pub(super) fn curve(points: &[Point], knots: &Knots, entities: &mut Entities<'_>) -> io::Result<usize> {
    let ids: Vec<usize> = points.iter().map(|&p| entities.point(p)).collect::<io::Result<_>>()?;
    entities.add(format_args!(
        "B_SPLINE_CURVE_WITH_KNOTS('',{},({}),.UNSPECIFIED.,.F.,.F.,({}),({}),.UNSPECIFIED.)",
        knots.degree(),
        references(&ids),
        list(knots.multiplicities(), usize::to_string),
        list(knots.values(), |x| real(*x)),
    ))
}

/// A surface by its net, row by row with u, and its knots in u and v.
pub(super) fn surface(
    points: &[Point],
    [u, v]: &[Knots; 2],
    entities: &mut Entities<'_>,
) -> io::Result<usize> {
    let ids: Vec<usize> = points.iter().map(|&p| entities.point(p)).collect::<io::Result<_>>()?;
    let rows: Vec<String> = ids.chunks(v.count()).map(|row| format!("({})", references(row))).collect();
    entities.add(format_args!(
        "B_SPLINE_SURFACE_WITH_KNOTS('',{},{},({}),.UNSPECIFIED.,.F.,.F.,.F.,({}),({}),({}),({}),.UNSPECIFIED.)",
        u.degree(),
        v.degree(),
        rows.join(",\n"),
        list(u.multiplicities(), usize::to_string),
        list(v.multiplicities(), usize::to_string),
        list(u.values(), |x| real(*x)),
        list(v.values(), |x| real(*x)),
    ))
}

/// The entities written so far.
pub(super) struct Entities<'a> {
    out: &'a mut dyn Write,
    count: usize,
}

impl Entities<'_> {
    /// Writes an entity; its number.
    pub(super) fn add(&mut self, entity: std::fmt::Arguments<'_>) -> io::Result<usize> {
        self.count += 1;
        writeln!(self.out, "#{}={entity};", self.count)?;
        Ok(self.count)
    }

    pub(super) fn point(&mut self, p: Point) -> io::Result<usize> {
        self.add(format_args!("CARTESIAN_POINT('',({},{},{}))", real(p.x), real(p.y), real(p.z)))
    }
}

pub(super) fn references(ids: &[usize]) -> String {
    list(ids, |id| format!("#{id}"))
}

fn list<T>(items: &[T], shown: impl Fn(&T) -> String) -> String {
    items.iter().map(shown).collect::<Vec<_>>().join(",")
}

/// A real of ISO 10303-21, all digits: the mantissa must have a point.
fn real(x: f64) -> String {
    // The shortest digits that read back as the same number.
    let digits = format!("{x:E}");
    match digits.split_once('E') {
        Some((mantissa, exponent)) => {
            let point = if mantissa.contains('.') { "" } else { "." };
            let exponent = if exponent == "0" { String::new() } else { format!("E{exponent}") };
            format!("{mantissa}{point}{exponent}")
        }
        None => digits,
    }
}

/// A string of ISO 10303-21: quotes and backslashes doubled, what is not printable ASCII as UTF-16 in hexadecimal. A quote
/// before what would follow the end of a string is taken for that end by OpenCASCADE: the typographic one stands for it.
fn text(words: &str) -> String {
    let mut coded = String::from("'");
    for (k, c) in words.char_indices() {
        match c {
            '\'' if words[k + 1..].trim_start().starts_with([')', ',', ';']) => coded += "\\X2\\2019\\X0\\",
            '\'' | '\\' => coded.extend([c, c]),
            ' '..='~' => coded.push(c),
            c if c.is_control() => coded.push(' '),
            c => {
                let units: String =
                    c.encode_utf16(&mut [0; 2]).iter().map(|unit| format!("{unit:04X}")).collect();
                // \X2\ holds the basic plane, \X4\ the others by code point.
                coded += &if units.len() == 4 {
                    format!("\\X2\\{units}\\X0\\")
                } else {
                    format!("\\X4\\{:08X}\\X0\\", u32::from(c))
                };
            }
        }
    }
    coded.push('\'');
    coded
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reals_have_a_point() {
        let cases = [(1.0, "1."), (0.0, "0."), (-2.5, "-2.5"), (1e-7, "1.E-7"), (6.25e20, "6.25E20")];
        for (x, expected) in cases {
            assert_eq!(real(x), expected);
        }
        for x in [1.0 / 3.0, f64::MIN_POSITIVE, 5e-324, f64::MAX, -0.1] {
            assert_eq!(real(x).parse::<f64>().unwrap(), x);
        }
    }

    #[test]
    fn strings_are_coded() {
        assert_eq!(text("'); ' )"), "'\\X2\\2019\\X0\\); \\X2\\2019\\X0\\ )'");
        assert_eq!(text("it's \\ α\n𝔸"), "'it''s \\\\ \\X2\\03B1\\X0\\ \\X4\\0001D538\\X0\\'");
    }
}
