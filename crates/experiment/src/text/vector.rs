//! Single points and directions.

use serde_json::{Map, Value as Json, json};

use super::form::{Form, keywords};
use super::interval::Interval;
use super::kind::Kind;
use super::place::Place;
use super::value::Value;
use plateau::counted;

/// Three numbers up to a size.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Vector {
    each: Interval,
}

impl Vector {
    pub(crate) const fn up_to(largest: f64) -> Self {
        Self { each: Interval::between(-largest, largest) }
    }
}

impl Form for Vector {
    fn expected(&self) -> String {
        "a point, like [0, 6, 2]".to_owned()
    }

    fn admits(&self) -> String {
        "`[x, y, z]`".to_owned()
    }

    fn schema(&self) -> Map<String, Json> {
        let items = Json::Object(self.each.schema());
        keywords([("type", json!("array")), ("items", items), ("minItems", json!(3)), ("maxItems", json!(3))])
    }
}

impl Kind for Vector {
    type Value = [f64; 3];

    fn read(&self, place: &Place<'_>, value: &Value<'_>) -> Option<[f64; 3]> {
        let Some(list) = value.get_ref().as_array() else {
            place.wrong_type(value, &self.expected());
            return None;
        };
        let [x, y, z] = &list[..] else {
            let found = counted(list.len(), "coordinate");
            let message = format!("{} has {found} instead of 3", place.name());
            place.faults().inadmissible(value.span(), message, found, "write it as [x, y, z]");
            return None;
        };
        let [x, y, z] = [x, y, z].map(|coordinate| place.real_in(coordinate, self.each));
        Some([x?, y?, z?])
    }
}
