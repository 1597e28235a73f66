//! STEP of a complex: faces on Bézier surfaces that share their edges and vertices, sewn in shells.
//!
//! A surface in which at most two faces meet at any edge is one shell for every part that hangs together. Where three and more
//! meet there, the parts between such lines are shells of one model, which share the edges of the lines: every reader takes
//! shells, few take faces that meet in threes within one. Faces that cannot be given one side are a shell each.

use plateau::counted;
use std::io::{self, Write};

use surfaces::{Complex, Knots, Orientation, Point};

use crate::LengthUnit;

use super::spline::LARGEST_DEGREE;
use super::step::{self, Entities, SMALLEST_TOLERANCE, StepError, references};

/// A complex as it goes into the file.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ShellFile<'a> {
    complex: &'a Complex,
    orientation: Orientation,
    /// The faces of every shell.
    shells: Vec<Vec<usize>>,
    size: f64,
}

impl<'a> ShellFile<'a> {
    /// The file of a complex, exact.
    ///
    /// # Errors
    /// [`StepError`] if CAD programs cannot read it.
    pub(crate) fn new(complex: &'a Complex) -> Result<Self, StepError> {
        let degree = complex.degree();
        if degree > LARGEST_DEGREE {
            return Err(StepError::Degree { degree });
        }
        let size = step::checked_size(complex.points())?;
        for edge in 0..complex.edges().len() {
            let curve = complex.edge_curve(edge);
            let length = super::extent::diagonal(curve.points().iter().map(|p| [p.x, p.y, p.z]));
            if length < 2.0 * SMALLEST_TOLERANCE {
                return Err(StepError::TooSmall { part: "one of its edges", length });
            }
        }
        let orientation = complex.orientation();
        let shells = shells(complex, &orientation);
        Ok(Self { complex, orientation, shells, size })
    }

    /// What the surface is, for people.
    pub(crate) fn description(&self) -> String {
        let (degree, faces) = (self.complex.degree(), self.complex.faces().len());
        let shells = match self.shells.len() {
            1 => "one shell".into(),
            count => format!("{count} shells with edges in common"),
        };
        format!("exact: {} of degree ({degree}, {degree}), {shells}", counted(faces, "polynomial face"))
    }

    /// Writes the whole file.
    pub(crate) fn write(&self, name: &str, unit: LengthUnit, out: &mut dyn Write) -> io::Result<()> {
        step::document((name, &self.description()), (self.size, unit), out, |title, entities| {
            let edges = self.edges(entities)?;
            let mut shells = Vec::new();
            for faces in &self.shells {
                let ids = faces.iter().map(|&face| self.face(face, title, &edges, entities));
                let ids = references(&ids.collect::<io::Result<Vec<_>>>()?);
                let kind = if self.is_closed(faces) { "CLOSED_SHELL" } else { "OPEN_SHELL" };
                shells.push(entities.add(format_args!("{kind}('',({ids}))"))?);
            }
            Ok(shells)
        })
    }

    /// Whether every edge of some faces belongs to two of them.
    fn is_closed(&self, faces: &[usize]) -> bool {
        let mut counts = vec![0; self.complex.edges().len()];
        faces.iter().flat_map(|&face| self.complex.faces()[face].edges()).for_each(|edge| counts[edge] += 1);
        counts.iter().all(|count| [0, 2].contains(count))
    }

    /// All edges, between all vertices.
    fn edges(&self, entities: &mut Entities<'_>) -> io::Result<Vec<usize>> {
        let knots = Knots::bernstein(self.complex.degree());
        let vertex = |&point: &Point, entities: &mut Entities<'_>| {
            let point = entities.point(point)?;
            entities.add(format_args!("VERTEX_POINT('',#{point})"))
        };
        let corners = &self.complex.points()[..self.complex.vertices()];
        let vertices = corners.iter().map(|p| vertex(p, entities)).collect::<io::Result<Vec<_>>>()?;
        let mut edges = Vec::new();
        for (number, edge) in self.complex.edges().iter().enumerate() {
            let curve = step::curve(self.complex.edge_curve(number).points(), &knots, entities)?;
            let [start, end] = edge.ends().map(|k| vertices[k]);
            edges.push(entities.add(format_args!("EDGE_CURVE('',#{start},#{end},#{curve},.T.)"))?);
        }
        Ok(edges)
    }

    /// A face; u and v change places where its normal would point to the other side than its neighbours'.
    fn face(
        &self,
        number: usize,
        title: &str,
        edges: &[usize],
        entities: &mut Entities<'_>,
    ) -> io::Result<usize> {
        let (face, degree) = (&self.complex.faces()[number], self.complex.degree());
        let turned = self.orientation.flipped()[number];
        let net: Vec<Point> = (0..=degree)
            .flat_map(|i| (0..=degree).map(move |j| if turned { (j, i) } else { (i, j) }))
            .map(|(i, j)| self.complex.points()[face.nodes()[(degree + 1) * i + j]])
            .collect();
        let surface = step::surface(&net, &[Knots::bernstein(degree), Knots::bernstein(degree)], entities)?;
        // Its border with the face on the left: v00, v10, v11, v01, or back.
        let mut border: Vec<(usize, bool)> = Vec::new();
        for edge in face.edges() {
            let here = self.complex.edges()[edge].uses().iter().find(|here| here.face == number);
            border.push((edges[edge], here.is_some_and(|here| here.runs_with_edge()) != turned));
        }
        if turned {
            border.reverse();
        }
        let sense = |forward: bool| if forward { ".T." } else { ".F." };
        let oriented = |(edge, forward): (usize, bool)| {
            entities.add(format_args!("ORIENTED_EDGE('',*,*,#{edge},{})", sense(forward)))
        };
        let border = references(&border.into_iter().map(oriented).collect::<io::Result<Vec<_>>>()?);
        let border = entities.add(format_args!("EDGE_LOOP('',({border}))"))?;
        let border = entities.add(format_args!("FACE_OUTER_BOUND('',#{border},.T.)"))?;
        entities.add(format_args!("ADVANCED_FACE({title},(#{border}),#{surface},.T.)"))
    }
}

/// The faces that hang together by edges of two faces; each by itself where they have no common side.
fn shells(complex: &Complex, orientation: &Orientation) -> Vec<Vec<usize>> {
    let count = complex.faces().len();
    let mut shells: Vec<Vec<usize>> = Vec::new();
    let mut is_done = vec![false; count];
    for first in 0..count {
        if std::mem::replace(&mut is_done[first], true) {
            continue;
        }
        let (mut shell, mut next) = (vec![first], 0);
        let mut is_torn = false;
        while next < shell.len() {
            for edge in complex.faces()[shell[next]].edges() {
                let uses = complex.edges()[edge].uses();
                is_torn |= orientation.torn().contains(&edge);
                if uses.len() == 2 {
                    for here in uses {
                        if !std::mem::replace(&mut is_done[here.face], true) {
                            shell.push(here.face);
                        }
                    }
                }
            }
            next += 1;
        }
        shell.sort_unstable();
        if is_torn {
            shells.extend(shell.into_iter().map(|face| vec![face]));
        } else {
            shells.push(shell);
        }
    }
    shells
}
