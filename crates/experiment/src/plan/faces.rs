//! `[[face]]` and `[[vertex]]`: faces between curves.

use std::collections::HashMap;
use std::ops::Range;

use plateau::{CurveGraph, CuttingError, CuttingSite, GraphCurve};
use serde_spanned::Spanned;
use surfaces::{Point, Vertex};

use super::curves::NamedCurve;
use crate::diagnostic::{Diagnostic, Fault, nearest, shorten};
use crate::keys::face::vertex::{FIXED, NAME, POINT};
use crate::keys::face::{MOST_FACES, VERTICES};
use crate::text::{Faults, Table, shown};

/// The faces of a file as a graph of curves.
pub(super) fn faces(
    faults: &Faults<'_>,
    face_tables: &Spanned<Vec<Table<'_>>>,
    vertex_tables: &[Table<'_>],
    curves: &[NamedCurve],
) -> Option<CurveGraph> {
    if face_tables.get_ref().len() > MOST_FACES {
        let count = face_tables.get_ref().len();
        let message = format!("{count} faces are too many, at most {MOST_FACES} are admitted");
        faults.inadmissible(face_tables.span(), message, "here", "cut the surface into several experiments");
        return None;
    }
    let mut vertices = Vertices::default();
    let placed = vertex_tables.iter().map(|table| vertices.place(table)).fold(true, |all, one| all & one);
    let curves_known = curves.iter().map(|curve| vertices.curve(faults, curve)).collect::<Option<Vec<_>>>();
    let read: Vec<_> = face_tables.get_ref().iter().map(|table| table.require(&VERTICES)).collect();
    let lists: Vec<Spanned<Vec<Spanned<String>>>> = read.into_iter().collect::<Option<_>>()?;
    let (graph_curves, true) = (curves_known?, placed) else { return None };
    let known = vertices.names.len();
    let faces: Vec<Vec<usize>> =
        lists.iter().map(|list| list.get_ref().iter().map(|name| vertices.number(name)).collect()).collect();
    if !vertices.are_used(faults, &faces)
        || !are_edges_shared(faults, &vertices, known, &lists, &faces, &graph_curves)
    {
        return None;
    }
    let named = vertices.names.iter().cloned().zip(vertices.places.iter().copied()).collect();
    let place = |error: &CuttingError| match error.site() {
        CuttingSite::Face(face) => lists[face].span(),
        CuttingSite::Curve(curve) => curves[curve].span.clone(),
        CuttingSite::Boundary => face_tables.span(),
    };
    match CurveGraph::new(named, graph_curves, &faces, None) {
        Ok(graph) => Some(graph),
        Err(error) => {
            let (message, remedy) = in_names(&error, &vertices.names, curves);
            faults.inadmissible(place(&error), message, "here", remedy);
            None
        }
    }
}

/// The vertices by their names, in the order in which the file names them.
#[derive(Default)]
struct Vertices {
    names: Vec<String>,
    places: Vec<Vertex>,
    numbers: HashMap<String, usize>,
    /// Where `[[vertex]]` tables stand.
    tables: HashMap<usize, Range<usize>>,
}

impl Vertices {
    fn number(&mut self, name: &Spanned<String>) -> usize {
        if let Some(number) = self.numbers.get(name.get_ref()) {
            return *number;
        }
        let number = self.names.len();
        self.names.push(name.get_ref().clone());
        self.places.push(Vertex::Free(None));
        self.numbers.insert(name.get_ref().clone(), number);
        number
    }

    /// Reads a `[[vertex]]`.
    fn place(&mut self, table: &Table<'_>) -> bool {
        let (name, point, fixed) =
            (table.require(&NAME), table.require(&POINT), table.take_or_default(&FIXED));
        let (Some(name), Some(point), Some(fixed)) = (name, point, fixed) else { return false };
        let number = self.number(&name);
        if let Some(first) = self.tables.insert(number, name.span()) {
            table.faults().conflict(
                (name.span(), "the same name again"),
                (first, "first used here"),
                format!("two vertices are called \"{}\"", shorten(name.get_ref())),
                "give each [[vertex]] its own name",
            );
            return false;
        }
        let point = Point::from(point.into_inner());
        self.places[number] = if fixed { Vertex::Fixed(point) } else { Vertex::Free(Some(point)) };
        true
    }

    /// A curve between two vertices.
    fn curve(&mut self, faults: &Faults<'_>, curve: &NamedCurve) -> Option<GraphCurve> {
        let Some([from, to]) = &curve.ends else {
            faults.clash(
                (curve.span.clone(), "without `ends`"),
                format!("the curve \"{}\" has no `ends`, which faces need", shorten(&curve.name)),
                "cut a closed curve at its vertices into several, each with its `ends`",
            );
            return None;
        };
        Some(GraphCurve { ends: [self.number(from), self.number(to)], curve: curve.curve.clone() })
    }

    /// Whether every `[[vertex]]` is the corner of a face.
    fn are_used(&self, faults: &Faults<'_>, faces: &[Vec<usize>]) -> bool {
        let mut all = true;
        let mut unused: Vec<_> =
            self.tables.iter().filter(|(number, _)| !faces.iter().flatten().any(|v| v == *number)).collect();
        unused.sort_by_key(|(_, span)| span.start);
        for (&number, span) in unused {
            all = false;
            let message = format!("the vertex \"{}\" is the corner of no face", shorten(&self.names[number]));
            faults.clash((span.clone(), "in no [[face]]"), message, "name it in a [[face]], or take it out");
        }
        all
    }
}

/// Whether every free edge, between two corners that no curve joins, belongs to two faces or more: a vertex that is
/// misspelt would make one that belongs to a single face, where nothing holds the surface.
fn are_edges_shared(
    faults: &Faults<'_>,
    vertices: &Vertices,
    known: usize,
    lists: &[Spanned<Vec<Spanned<String>>>],
    faces: &[Vec<usize>],
    curves: &[GraphCurve],
) -> bool {
    let sorted = |a: usize, b: usize| [a.min(b), a.max(b)];
    let joined: Vec<[usize; 2]> = curves.iter().map(|curve| sorted(curve.ends[0], curve.ends[1])).collect();
    let mut uses: HashMap<[usize; 2], usize> = HashMap::new();
    let edges = |face: &[usize]| -> Vec<[usize; 2]> {
        (0..face.len()).map(|k| sorted(face[k], face[(k + 1) % face.len()])).collect()
    };
    for edge in faces.iter().flat_map(|face| edges(face)) {
        *uses.entry(edge).or_insert(0) += 1;
    }
    let open_sides = lists.iter().zip(faces).flat_map(|(list, face)| {
        let is_open = |edge: &[usize; 2]| uses[edge] == 1 && !joined.contains(edge);
        let sides = edges(face).into_iter().enumerate().filter(|(_, edge)| is_open(edge));
        sides.map(|(k, _)| (list, face, k)).collect::<Vec<_>>()
    });
    let open_sides: Vec<_> = open_sides.collect();
    // A corner that nothing else names is the likeliest slip.
    let corners = |face: &[usize], k: usize| [k, (k + 1) % face.len()];
    let slip = |face: &[usize], k| corners(face, k).into_iter().find(|&k| face[k] >= known);
    let likeliest = open_sides.iter().find(|(_, face, k)| slip(face, *k).is_some());
    if let Some(&(list, face, k)) = likeliest.or(open_sides.first()) {
        let (pair, slip) = (corners(face, k), slip(face, k).unwrap_or(k));
        let corner = &list.get_ref()[slip];
        let [from, to] = pair.map(|k| shorten(list.get_ref()[k].get_ref()));
        let message = format!(
            "nothing holds the side from \"{from}\" to \"{to}\" of a face: no curve joins them, and no other face has it"
        );
        let diagnostic =
            Diagnostic::at(Fault::Conflict, corner.span(), message, "the side at this corner is free");
        let others = vertices.names[..known].iter().map(String::as_str);
        let near = nearest(corner.get_ref(), others).filter(|_| face[slip] >= known);
        let diagnostic = match near {
            Some(near) => diagnostic.help(format!("did you mean \"{near}\"?")),
            None => diagnostic,
        };
        faults.report(diagnostic.help("add a [[curve]] with these `ends`, or the face on the other side"));
    }
    open_sides.is_empty()
}

/// The error in the names of the file, and what to do about it.
fn in_names(error: &CuttingError, vertices: &[String], curves: &[NamedCurve]) -> (String, &'static str) {
    let curve = |k: usize| format!("\"{}\"", shorten(&curves[k].name));
    let vertex = |k: usize| format!("\"{}\"", shorten(&vertices[k]));
    const COMPARE: &str = "compare it with a template: `plateau new faces` prints one";
    match error {
        CuttingError::Polygon { found, .. } => (
            format!(
                "a face has {found} corners that differ; it has three or more, each once, or two that two curves join"
            ),
            COMPARE,
        ),
        CuttingError::TwoCurves { ends, curves: [first, second] } => (
            format!(
                "the curves {} and {} both join the vertices {} and {}: faces by vertices cannot say which is meant",
                curve(*first),
                curve(*second),
                vertex(ends[0]),
                vertex(ends[1])
            ),
            "put a vertex on one of the two curves: two curves in its place, with a vertex between them",
        ),
        CuttingError::Apart { curve: k, vertex: at, gap, weld } => (
            format!(
                "the curve {} ends {} from the vertex {}; what differs by no more than {weld:.0e} is made one",
                curve(*k),
                shown(*gap),
                vertex(*at)
            ),
            "all curves that end in a vertex end at one point: move this end, or the [[vertex]]",
        ),
        CuttingError::ClosedCurve { curve: k } => {
            (format!("the curve {} is closed, but a side of a face joins two vertices", curve(*k)), COMPARE)
        }
        CuttingError::UnusedCurve { curve: k, ends } => (
            format!(
                "the curve {} joins the vertices {} and {}, which are neighbours in no face",
                curve(*k),
                vertex(ends[0]),
                vertex(ends[1])
            ),
            "add the [[face]] that it bounds, or take it out",
        ),
        CuttingError::Curve { curve: k, error } => (format!("the curve {}: {error}", curve(*k)), COMPARE),
        CuttingError::NoCurve
        | CuttingError::Gap { .. }
        | CuttingError::TooSmall { .. }
        | CuttingError::Crosses { .. }
        | CuttingError::TooManyPieces { .. }
        | CuttingError::Loops { .. }
        | CuttingError::Unsuitable { .. }
        | CuttingError::UnknownVertex { .. }
        | CuttingError::Complex(_)
        | CuttingError::Side { .. } => (format!("the faces make no surface: {error}"), COMPARE),
    }
}
