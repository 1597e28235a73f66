//! Lists of points.

use std::ops::Range;

use serde_json::{Map, Value as Json, json};
use serde_spanned::Spanned;
use toml::de::DeValue;

use super::form::Form;
use super::head::Head;
use super::interval::Interval;
use super::kind::{Kind, MOST_OF_A_LIST};
use super::number::shown;
use super::place::Place;
use super::value::Value;
use plateau::counted;

/// Between two numbers of points, with coordinates up to a size.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Points {
    least: usize,
    most: usize,
    largest: f64,
    planar: bool,
    /// What they are, where their number is no matter of a degree.
    noun: Option<&'static str>,
}

/// Points with their places. Planar ones carry z = 0.
#[derive(Clone, Debug)]
pub(crate) struct PointList {
    pub(crate) points: Vec<Spanned<[f64; 3]>>,
    /// The places of their coordinates.
    pub(crate) coordinates: Vec<Vec<Range<usize>>>,
    /// Coordinates of each point as the file has them: 2 or 3.
    pub(crate) dimension: usize,
}

impl Points {
    /// Points of space.
    pub(crate) const fn between(least: usize, most: usize, largest: f64) -> Self {
        Self { least, most, largest, planar: false, noun: None }
    }

    /// Points of the plane are admitted, too, if all of them are.
    pub(crate) const fn or_planar(self) -> Self {
        Self { planar: true, ..self }
    }

    /// They are called so, and their number has nothing to do with a degree.
    pub(crate) const fn counting(self, noun: &'static str) -> Self {
        Self { noun: Some(noun), ..self }
    }

    /// Whether there are as many points as the kind asks for; the degree is one less than their number.
    fn has_length(&self, place: &Place<'_>, value: &Value<'_>, count: usize) -> bool {
        let (least, most) = (self.least, self.most);
        if (least..=most).contains(&count) {
            return true;
        }
        let help = if let Some(noun) = self.noun {
            if least == most {
                format!("give {least} {noun}")
            } else {
                format!("give {least} to {most} {noun}")
            }
        } else if count < least {
            format!("give at least {least} points: n + 1 points make degree n")
        } else {
            format!("give at most {most} points: the degree is limited to {}", most - 1)
        };
        let found = counted(count, "point");
        place.faults().inadmissible(value.span(), format!("{} has {found}", place.name()), found, help);
        false
    }

    /// The coordinates of the k-th point, planar ones completed, and their number. `None` if they are not numbers.
    fn point(&self, place: &Place<'_>, k: usize, value: &Value<'_>) -> Option<([f64; 3], usize)> {
        let Some(coordinates) = value.get_ref().as_array() else {
            place.wrong_type(value, "a point, like [0, 6, 2]");
            return None;
        };
        let mut point = [0.0; 3];
        for (c, coordinate) in coordinates.iter().enumerate() {
            let number = place.real(coordinate)?;
            if c < 3 {
                point[c] = number;
            }
        }
        let count = coordinates.len();
        if count == 3 || (count == 2 && self.planar) {
            return Some((point, count));
        }
        let (found, wanted) = (counted(count, "coordinate"), if self.planar { "2 or 3" } else { "3" });
        let called = place.name();
        let mut help = format!("write a point as [x, y, z]; this is point {k} of {called}, counted from 0");
        if count == 2 {
            help = format!("add the third coordinate, 0 for a planar boundary; {help}");
        }
        let message = format!("a point of {called} has {found} instead of {wanted}");
        place.faults().inadmissible(value.span(), message, found, help);
        None
    }

    /// Reports the coordinates of the k-th point that are not finite or too large.
    fn is_admissible(&self, place: &Place<'_>, k: usize, value: &Value<'_>, point: [f64; 3]) -> bool {
        let mut sound = true;
        for ((axis, x), coordinate) in
            ["x", "y", "z"].iter().zip(point).zip(value.get_ref().as_array().into_iter().flatten())
        {
            if Interval::between(-self.largest, self.largest).holds(x) {
                continue;
            }
            let (what, help) = if x.is_finite() {
                (
                    "too large",
                    format!(
                        "coordinates are admitted up to {:e}, so that every figure stays finite: choose a larger unit of length",
                        self.largest
                    ),
                )
            } else {
                ("not finite", "every coordinate must be an ordinary number: replace nan or inf".to_owned())
            };
            let message =
                format!("{axis} of point {k} of {} is {what} (points are counted from 0)", place.name());
            place.faults().inadmissible(coordinate.span(), message, shown(x), help);
            sound = false;
        }
        sound
    }

    /// Reports the first point that has not as many coordinates as the first one.
    fn have_one_dimension(place: &Place<'_>, list: &[Value<'_>], dimensions: &[usize]) -> bool {
        let Some(other) = dimensions.iter().position(|d| *d != dimensions[0]) else { return true };
        place.faults().conflict(
            (list[other].span(), &counted(dimensions[other], "coordinate")),
            (list[0].span(), &counted(dimensions[0], "coordinate")),
            format!("{} mixes planar and space points", place.name()),
            "give every point 2 coordinates, or every point 3",
        );
        false
    }
}

impl Form for Points {
    fn expected(&self) -> String {
        "a list of points, like [[0, 0, 0], [2, 0, 2]]".to_owned()
    }

    fn admits(&self) -> String {
        let noun = self.noun.unwrap_or("points");
        let plane = if self.planar { ", of the plane or of space" } else { "" };
        let count = match self.least == self.most {
            true => self.most.to_string(),
            false => format!("{} to {}", self.least, self.most),
        };
        format!("{count} {noun}{plane}")
    }

    fn schema(&self) -> Map<String, Json> {
        let mut list = json!({ "type": "array", "minItems": self.least, "maxItems": self.most });
        let coordinate = Json::Object(Interval::between(-self.largest, self.largest).schema());
        let least = if self.planar { 2 } else { 3 };
        list["items"] = json!({ "type": "array", "items": coordinate, "minItems": least, "maxItems": 3 });
        list.as_object().cloned().unwrap_or_default()
    }

    fn remedy(&self, key: &Head, _found: &DeValue<'_>) -> Option<String> {
        let name = key.name;
        Some(format!(
            "write `{name}` as a list of points, each a list of numbers: {name} = [[0, 0, 0], [2, 0, 2], [4, 0, -2]]"
        ))
    }
}

impl Kind for Points {
    type Value = PointList;

    fn read(&self, place: &Place<'_>, value: &Value<'_>) -> Option<PointList> {
        let Some(list) = value.get_ref().as_array() else {
            place.wrong_type(value, &self.expected());
            return None;
        };
        if !self.has_length(place, value, list.len()) {
            return None;
        }
        let mut points = Vec::with_capacity(list.len());
        let (mut coordinates, mut dimensions) = (Vec::new(), Vec::new());
        let mut faulty = 0;
        for (k, element) in list.iter().enumerate() {
            let (point, dimension) = self.point(place, k, element)?;
            faulty += usize::from(!self.is_admissible(place, k, element, point));
            if faulty == MOST_OF_A_LIST {
                return None;
            }
            points.push(Spanned::new(element.span(), point));
            coordinates.push(element.get_ref().as_array().into_iter().flatten().map(Spanned::span).collect());
            dimensions.push(dimension);
        }
        let dimension = *dimensions.first()?;
        (faulty == 0 && Self::have_one_dimension(place, list, &dimensions)).then_some(PointList {
            points,
            coordinates,
            dimension,
        })
    }
}
