//! The figures of a surface, written and read where their table puts them.

use std::collections::BTreeMap;
use std::fmt;

use plateau::{Bearer, Done, Quantity};
use serde::de::{Error, IgnoredAny, MapAccess, Visitor};
use serde::ser::SerializeMap;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::number::finite;

/// Energies, area and curvature.
pub(super) const SHAPE: u8 = 0;
/// The distance from a closed form.
pub(super) const EXACT: u8 = 1;
/// How well a system was solved.
pub(super) const SYSTEM: u8 = 2;
/// How far borders and rims moved.
pub(super) const RIM: u8 = 3;
/// How even the parametrisation is.
pub(super) const EVEN: u8 = 4;
/// How near the least area is.
pub(super) const LEAST: u8 = 5;
/// What other surfaces and maps over the same boundary have.
pub(super) const OTHERS: u8 = 6;

/// The figures of one part of a method's entry, each with its error if it has one: by their places in the entry, in the order of their
/// table. The order of the parts, and what stands between them, has been the same since there are records.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Figures<const PART: u8>(Vec<(String, f64)>);

/// The part in which a figure stands; none of one that an entry of its own tells with what belongs to it: `kink`, `shape`, `search`, `curve`.
fn part(quantity: Quantity) -> Option<u8> {
    match quantity.bearer() {
        _ if quantity == Quantity::Kink => None,
        _ if quantity == Quantity::HarmonicBound => Some(OTHERS),
        Bearer::Surface | Bearer::Extremal(_) | Bearer::Corrected => Some(SHAPE),
        Bearer::Closed => Some(EXACT),
        Bearer::Solved => Some(SYSTEM),
        Bearer::FourSides | Bearer::Film => Some(RIM),
        Bearer::Even => Some(EVEN),
        Bearer::Spanning | Bearer::Bounded => Some(LEAST),
        Bearer::TwoLoops => Some(OTHERS),
        Bearer::Shaped | Bearer::Searched | Bearer::Curve => None,
    }
}

/// Where the error of the figure stands that is at `key`.
fn error_of(key: &str) -> String {
    format!("{key}_error")
}

impl<const PART: u8> Figures<PART> {
    fn quantities() -> impl Iterator<Item = Quantity> {
        Quantity::ALL.iter().copied().filter(|quantity| part(*quantity) == Some(PART))
    }

    /// Those that the surface has and JSON can hold.
    pub(super) fn of(done: &Done) -> Self {
        let both = |quantity: Quantity| {
            let (key, figure) = (quantity.key(), quantity.of(done));
            let value = figure.map(|figure| (key.to_owned(), figure.value));
            value.into_iter().chain(figure.and_then(|figure| Some((error_of(key), figure.error?))))
        };
        Self(Self::quantities().flat_map(both).filter(|(_, value)| finite(*value).is_some()).collect())
    }
}

/// The object that holds the figure at a place, if one does.
fn object(place: &str) -> Option<&str> {
    place.split_once('.').map(|(object, _)| object)
}

impl<const PART: u8> Serialize for Figures<PART> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for together in self.0.chunk_by(|(a, _), (b, _)| object(a).is_some() && object(a) == object(b)) {
            match object(&together[0].0) {
                None => map.serialize_entry(&together[0].0, &together[0].1)?,
                Some(object) => map.serialize_entry(object, &Inside(object, together))?,
            }
        }
        map.end()
    }
}

/// The figures in an object.
struct Inside<'a>(&'a str, &'a [(String, f64)]);

impl Serialize for Inside<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.1.iter().map(|(place, value)| (&place[self.0.len() + 1..], value)))
    }
}

impl<'de, const PART: u8> Deserialize<'de> for Figures<PART> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let places =
            Self::quantities().flat_map(|quantity| [quantity.key().to_owned(), error_of(quantity.key())]);
        deserializer.deserialize_map(Places(places.collect())).map(Self)
    }
}

/// What reads the figures at these places of an entry, and passes over all else.
struct Places(Vec<String>);

impl<'de> Visitor<'de> for Places {
    type Value = Vec<(String, f64)>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the entry of a method")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut entry: A) -> Result<Self::Value, A::Error> {
        let mut found = BTreeMap::new();
        while let Some(key) = entry.next_key::<String>()? {
            if self.0.contains(&key) {
                found.insert(key, entry.next_value::<Option<f64>>()?);
            } else if self.0.iter().any(|place| object(place) == Some(&key)) {
                for (inner, value) in entry.next_value::<BTreeMap<String, serde_json::Value>>()? {
                    let place = format!("{key}.{inner}");
                    if self.0.contains(&place) {
                        found.insert(place, Option::deserialize(value).map_err(A::Error::custom)?);
                    }
                }
            } else {
                entry.next_value::<IgnoredAny>()?;
            }
        }
        Ok(self.0.into_iter().filter_map(|place| found.remove(&place)?.map(|value| (place, value))).collect())
    }
}
