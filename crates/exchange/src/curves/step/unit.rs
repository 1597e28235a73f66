//! Units: of length for the user to see, of angles because parameters of circles are angles.

use super::part21::{Part21, Value};
use crate::curves::CurveFileError;

/// Says the unit of length; gives the angle unit in radians.
pub(super) fn said(file: &Part21<'_>, notes: &mut Vec<String>) -> Result<f64, CurveFileError> {
    let mut lengths: Vec<String> = Vec::new();
    let mut angle = 1.0;
    let mut used = Vec::new();
    // Only units that a context assigns count: degrees are made of radians, which stand in the file, too.
    for context in file.named(&["GLOBAL_UNIT_ASSIGNED_CONTEXT"]) {
        for entity in file.get(context)? {
            if let ("GLOBAL_UNIT_ASSIGNED_CONTEXT", Some(Value::List(units))) =
                (entity.name.as_str(), entity.values.first())
            {
                used.extend(units.iter().filter_map(|unit| match unit {
                    Value::Reference(id) => Some(*id),
                    Value::Number(_)
                    | Value::Text(_)
                    | Value::Word(_)
                    | Value::Absent
                    | Value::List(_)
                    | Value::Typed(..) => None,
                }));
            }
        }
    }
    used.sort_unstable();
    used.dedup();
    for id in used {
        let entities = file.get(id)?;
        let has = |name: &str| entities.iter().any(|entity| entity.name == name);
        let values = |name: &str| {
            entities.iter().find(|entity| entity.name == name).map(|entity| entity.values.as_slice())
        };
        if has("LENGTH_UNIT") {
            let name = match (values("SI_UNIT"), values("CONVERSION_BASED_UNIT")) {
                (Some([Value::Word(prefix), ..]), _) => format!("{}metres", prefix.to_lowercase()),
                (Some(_), _) => "metres".into(),
                (None, Some([Value::Text(name), ..])) => {
                    format!("units named {}", crate::curves::limits::name(name))
                }
                (None, _) => continue,
            };
            if !lengths.contains(&name) {
                lengths.push(name);
            }
        } else if has("PLANE_ANGLE_UNIT")
            && let Some([_, Value::Reference(measure), ..]) = values("CONVERSION_BASED_UNIT")
        {
            angle = number(file, *measure)?.filter(|x| *x > 0.0).unwrap_or(1.0);
        }
    }
    match lengths.as_slice() {
        [] => {}
        [one] => notes.push(format!("lengths are in {one}, as in the file")),
        several => {
            return Err(CurveFileError::File(format!(
                "measures lengths in several units ({}): export it in one",
                several.join(", ")
            )));
        }
    }
    Ok(angle)
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
