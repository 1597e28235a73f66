//! STEP: curves, edges and wires of AP203, AP214, AP242 and their like.

use std::collections::{HashMap, HashSet};

use super::limits::{self, MOST_CURVES, MOST_POINTS};
use super::{CurveFile, CurveFileError, FileCurve, Kind};
use crate::Sentence;

mod curve;
mod fields;
mod part21;
mod unit;

use curve::Curves;
use part21::{Entity, Part21, Value};

/// The curves of a file: the edges of its wires; of shells the free ones, which belong to one face; the items of sets of curves;
/// without any of these, all bounded curves that no other instance is made of.
pub(super) fn read(text: &str) -> Result<CurveFile, CurveFileError> {
    let file = Part21::new(text)?;
    let mut notes = Vec::new();
    let (unit, degrees) = unit::said(&file, &mut notes)?;
    let curves = Curves::new(&file, degrees);
    let mut found: Vec<FileCurve> = Vec::new();
    let mut points = 0;
    for (id, name) in chosen(&file, &mut notes)? {
        for (line, shape) in curves.get(id)? {
            limits::count(&mut points, shape.sampled().len().min(1000), MOST_POINTS, "points", line)?;
            let mut counter = found.len();
            limits::count(&mut counter, 1, MOST_CURVES, "curves", line)?;
            found.push(FileCurve { name: name.clone(), line, shape, closes: false, joints: Vec::new() });
        }
    }
    if found.is_empty() {
        return Err(CurveFileError::File(
            "holds no edges and no bounded curves: export the edges of the boundary, or a wire of them"
                .into(),
        ));
    }
    let notes = notes.into_iter().map(Sentence::from).collect();
    Ok(CurveFile { kind: Kind::Step, curves: found, unit, notes })
}

/// Entities that say where a part of an assembly lies.
const PLACED: [&str; 3] = [
    "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION",
    "MAPPED_ITEM",
    "CONTEXT_DEPENDENT_SHAPE_REPRESENTATION",
];

/// Bounded curves that may stand alone.
const BOUNDED: [&str; 11] = [
    "TRIMMED_CURVE",
    "COMPOSITE_CURVE",
    "POLYLINE",
    "B_SPLINE_CURVE_WITH_KNOTS",
    "B_SPLINE_CURVE",
    "BEZIER_CURVE",
    "UNIFORM_CURVE",
    "QUASI_UNIFORM_CURVE",
    "CIRCLE",
    "ELLIPSE",
    "RATIONAL_B_SPLINE_CURVE",
];

/// The instances to read, with their names.
fn chosen(file: &Part21<'_>, notes: &mut Vec<String>) -> Result<Vec<(u64, String)>, CurveFileError> {
    if file.named(&PLACED).next().is_some() {
        notes.push("the file places parts in an assembly; its curves are read as they are, where they stand in their parts".into());
    }
    let edges: Vec<u64> = file.named(&["EDGE_CURVE"]).collect();
    let mut chosen = Vec::new();
    if !edges.is_empty() {
        for id in free_edges(file, &edges, notes)? {
            chosen.push((id, name_of(&file.get(id)?)));
        }
    }
    let mut taken = HashSet::new();
    for set in file.named(&["GEOMETRIC_CURVE_SET", "GEOMETRIC_SET"]) {
        let entities = file.get(set)?;
        let name = name_of(&entities);
        for value in entities.iter().flat_map(|entity| &entity.values) {
            let Value::List(items) = value else { continue };
            for item in items {
                let Value::Reference(id) = item else { continue };
                let entities = file.get(*id)?;
                let is_curve = entities.iter().any(|entity| BOUNDED.contains(&entity.name.as_str()));
                if is_curve && taken.insert(*id) {
                    let own = name_of(&entities);
                    chosen.push((*id, if own.is_empty() { name.clone() } else { own }));
                }
            }
        }
    }
    if chosen.is_empty() {
        chosen = alone(file)?;
    }
    Ok(chosen)
}

/// The edges of wires, and those of faces that belong to one face: in the order in which their wires have them.
fn free_edges(file: &Part21<'_>, edges: &[u64], notes: &mut Vec<String>) -> Result<Vec<u64>, CurveFileError> {
    let faces = file.named(&["ADVANCED_FACE", "FACE_SURFACE", "FACE"]).count();
    let mut uses: HashMap<u64, usize> = HashMap::new();
    let mut in_order = Vec::new();
    for oriented in file.named(&["ORIENTED_EDGE"]) {
        for value in file.get(oriented)?.iter().flat_map(|entity| &entity.values) {
            if let Value::Reference(id) = value {
                let count = uses.entry(*id).or_default();
                *count += 1;
                if *count == 1 {
                    in_order.push(*id);
                }
            }
        }
    }
    let known: HashSet<u64> = edges.iter().copied().collect();
    in_order.retain(|id| known.contains(id));
    in_order.extend(edges.iter().filter(|id| !uses.contains_key(id)));
    if faces == 0 {
        return Ok(in_order);
    }
    let free: Vec<u64> =
        in_order.iter().copied().filter(|id| uses.get(id).is_some_and(|count| *count == 1)).collect();
    if free.is_empty() {
        return Err(CurveFileError::File(format!(
            "is a closed body of {faces} faces, every edge belongs to two: there is no rim to fill; export the edges of the boundary, or a wire"
        )));
    }
    notes.push(format!(
        "of the {} edges of {faces} faces the {} that belong to one face are the boundary",
        edges.len(),
        free.len()
    ));
    Ok(free)
}

/// Bounded curves that no other instance refers to.
fn alone(file: &Part21<'_>) -> Result<Vec<(u64, String)>, CurveFileError> {
    let makers = [
        "TRIMMED_CURVE",
        "COMPOSITE_CURVE_SEGMENT",
        "SURFACE_CURVE",
        "SEAM_CURVE",
        "PCURVE",
        "INTERSECTION_CURVE",
        "DEFINITIONAL_REPRESENTATION",
    ];
    let mut parts = HashSet::new();
    for id in file.named(&makers) {
        let mut values: Vec<Value> = file.get(id)?.into_iter().flat_map(|entity| entity.values).collect();
        while let Some(value) = values.pop() {
            match value {
                Value::Reference(id) => {
                    parts.insert(id);
                }
                Value::List(inner) | Value::Typed(_, inner) => values.extend(inner),
                Value::Number(_) | Value::Text(_) | Value::Word(_) | Value::Absent => {}
            }
        }
    }
    let alone: Vec<u64> = file.named(&BOUNDED).filter(|id| !parts.contains(id)).collect();
    alone.into_iter().map(|id| Ok((id, name_of(&file.get(id)?)))).collect()
}

/// The name of an instance: its first text. Exporters write `NONE` for none.
fn name_of(entities: &[Entity]) -> String {
    let text = entities.iter().flat_map(|entity| entity.values.first()).find_map(|value| match value {
        Value::Text(text) => Some(limits::name(text)),
        Value::Reference(_)
        | Value::Number(_)
        | Value::Word(_)
        | Value::Absent
        | Value::List(_)
        | Value::Typed(..) => None,
    });
    text.filter(|name| !name.eq_ignore_ascii_case("none")).unwrap_or_default()
}
