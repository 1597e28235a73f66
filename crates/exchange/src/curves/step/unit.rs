//! Units: of length for the user to see, of angles because parameters of circles are angles.

use super::part21::{Part21, Value};
use crate::LengthUnit;
use crate::curves::CurveFileError;

/// Says the unit of length and gives it, where it is known; gives the angle unit in radians.
pub(super) fn said(
    file: &Part21<'_>,
    notes: &mut Vec<String>,
) -> Result<(Option<LengthUnit>, f64), CurveFileError> {
    let mut lengths: Vec<(Option<LengthUnit>, String)> = Vec::new();
    let mut angle = 1.0;
    for id in assigned(file)? {
        let entities = file.get(id)?;
        let has = |name: &str| entities.iter().any(|entity| entity.name == name);
        let values = |name: &str| {
            entities.iter().find(|entity| entity.name == name).map(|entity| entity.values.as_slice())
        };
        if has("LENGTH_UNIT") {
            let (unit, name) = match (values("SI_UNIT"), values("CONVERSION_BASED_UNIT")) {
                (Some([Value::Word(prefix), ..]), _) => {
                    let name = format!("{}metres", prefix.to_lowercase());
                    (LengthUnit::of_word(&name), name)
                }
                (Some(_), _) => (Some(LengthUnit::Metre), "metres".into()),
                (None, Some([Value::Text(name), Value::Reference(measure), ..])) => {
                    let unit = millimetres(file, *measure)?.and_then(LengthUnit::of_millimetres);
                    (unit, format!("units named {}", crate::curves::limits::name(name)))
                }
                (None, _) => continue,
            };
            let name = unit.map_or(name, |unit| unit.plural().to_owned());
            if !lengths.iter().any(|(_, known)| *known == name) {
                lengths.push((unit, name));
            }
        } else if has("PLANE_ANGLE_UNIT")
            && let Some([_, Value::Reference(measure), ..]) = values("CONVERSION_BASED_UNIT")
        {
            angle = number(file, *measure)?.filter(|x| *x > 0.0).unwrap_or(1.0);
        }
    }
    match lengths.as_slice() {
        [] => Ok((None, angle)),
        [(unit, name)] => {
            notes.push(format!("lengths are in {name}, as in the file"));
            Ok((*unit, angle))
        }
        several => {
            let names: Vec<&str> = several.iter().map(|(_, name)| name.as_str()).collect();
            Err(CurveFileError::File(format!(
                "measures lengths in several units ({}): export it in one",
                names.join(", ")
            )))
        }
    }
}

/// The units that a context assigns: they alone count, for degrees are made of radians, which stand in the file, too.
fn assigned(file: &Part21<'_>) -> Result<Vec<u64>, CurveFileError> {
    let mut used = Vec::new();
    for context in file.named(&["GLOBAL_UNIT_ASSIGNED_CONTEXT"]) {
        for entity in file.get(context)? {
            if let ("GLOBAL_UNIT_ASSIGNED_CONTEXT", Some(Value::List(units))) =
                (entity.name.as_str(), entity.values.first())
            {
                used.extend(units.iter().filter_map(Value::reference));
            }
        }
    }
    used.sort_unstable();
    used.dedup();
    Ok(used)
}

/// A measure of length in millimetres, where the unit it is told in is one of the metric system.
fn millimetres(file: &Part21<'_>, id: u64) -> Result<Option<f64>, CurveFileError> {
    let Some(count) = number(file, id)? else { return Ok(None) };
    let entities = file.get(id)?;
    let unit = entities.iter().flat_map(|entity| &entity.values).find_map(Value::reference);
    let Some(unit) = unit else { return Ok(None) };
    let of = file.get(unit)?.into_iter().find(|entity| entity.name == "SI_UNIT").and_then(|entity| {
        match entity.values.first() {
            Some(Value::Word(prefix)) => LengthUnit::of_word(&format!("{}metres", prefix.to_lowercase())),
            _none => Some(LengthUnit::Metre),
        }
    });
    Ok(of.map(|unit| count * unit.millimetres()))
}

/// The number of a measure with a unit.
fn number(file: &Part21<'_>, id: u64) -> Result<Option<f64>, CurveFileError> {
    let value = file.get(id)?.into_iter().flat_map(|entity| entity.values).find_map(|value| match value {
        Value::Typed(_, inner) => match inner.first() {
            Some(Value::Number(x)) => Some(*x),
            _absent_or_other => None,
        },
        Value::Number(x) => Some(x),
        Value::Reference(_) | Value::Text(_) | Value::Word(_) | Value::Absent | Value::List(_) => None,
    });
    Ok(value)
}
