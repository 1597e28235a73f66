//! Lists of numbers.

use serde_json::{Map, Value as Json, json};
use serde_spanned::Spanned;

use super::form::{Form, keywords};
use super::interval::Interval;
use super::kind::{Kind, MOST_OF_A_LIST};
use super::number::shown;
use super::place::Place;
use super::value::Value;

/// A list of numbers in an interval.
#[derive(Clone, Copy)]
pub(crate) struct Reals {
    pub(crate) least: usize,
    pub(crate) most: usize,
    pub(crate) each: Interval,
}

impl Reals {
    /// Exactly `count` numbers.
    pub(crate) const fn exactly(count: usize, each: Interval) -> Self {
        Self { least: count, most: count, each }
    }
}

impl Form for Reals {
    fn expected(&self) -> String {
        "a list of numbers, like [1.0, 2.0]".to_owned()
    }

    fn admits(&self) -> String {
        let count = if self.least == self.most {
            self.least.to_string()
        } else {
            format!("{} to {}", self.least, self.most)
        };
        format!("{count} numbers, each {}", self.each.words())
    }

    fn schema(&self) -> Map<String, Json> {
        let lengths = [("minItems", json!(self.least)), ("maxItems", json!(self.most))];
        let list = [("type", json!("array")), ("items", Json::Object(self.each.schema()))];
        keywords(list).into_iter().chain(keywords(lengths)).collect()
    }
}

impl Kind for Reals {
    type Value = Vec<Spanned<f64>>;

    fn read(&self, place: &Place<'_>, value: &Value<'_>) -> Option<Self::Value> {
        let Some(list) = value.get_ref().as_array() else {
            place.wrong_type(value, &self.expected());
            return None;
        };
        if !place.has_length(value, list.len(), (self.least, self.most), "number") {
            return None;
        }
        numbers(place, list, self.each)
    }
}

/// The numbers of a list; all that lie outside are reported, of other types the first.
fn numbers(place: &Place<'_>, list: &[Value<'_>], each: Interval) -> Option<Vec<Spanned<f64>>> {
    let mut numbers = Vec::with_capacity(list.len());
    let mut faulty = 0;
    for element in list {
        let number = place.real(element)?;
        if !each.holds(number) {
            let must = if number.is_finite() { each } else { Interval::FINITE };
            let message =
                format!("{} holds {}: each of its numbers must {must}", place.name(), shown(number));
            place.faults().inadmissible(
                element.span(),
                message,
                format!("this is {}", shown(number)),
                place.key.remedy(),
            );
            faulty += 1;
        }
        if faulty == MOST_OF_A_LIST {
            return None;
        }
        numbers.push(Spanned::new(element.span(), number));
    }
    (faulty == 0).then_some(numbers)
}
