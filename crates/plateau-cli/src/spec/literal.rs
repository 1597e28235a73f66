//! Values of keys: one small type for each thing a key may hold.
//!
//! TOML tells integers from floats and lists from scalars; a key that takes several of them (a count
//! or a list, a number or a name) gets a type here whose visitor takes exactly those.

use std::fmt;
use std::marker::PhantomData;
use std::ops::Deref;

use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Deserialize, Deserializer, Error, MapAccess, SeqAccess, Unexpected, Visitor};
use serde_spanned::Spanned;

use super::{PublishedSpec, TolerancedSpec};

/// A table, and only a table: serde's derived structs would take a list of their fields as well.
#[derive(Debug, Default)]
pub(crate) struct Section<T>(T);

impl<T> Deref for Section<T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.0
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Section<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(SectionVisitor(PhantomData))
    }
}

struct SectionVisitor<T>(PhantomData<T>);

impl<'de, T: Deserialize<'de>> Visitor<'de> for SectionVisitor<T> {
    type Value = Section<T>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a table of keys")
    }

    fn visit_map<A: MapAccess<'de>>(self, table: A) -> Result<Section<T>, A::Error> {
        T::deserialize(MapAccessDeserializer::new(table)).map(Section)
    }
}

/// What a value may be; everything not overridden is a wrong type.
trait Literal: Sized {
    /// What the key takes, for "expected …".
    const EXPECTED: &'static str;

    fn truth(_: bool) -> Option<Self> {
        None
    }
    fn integer(_: i128) -> Option<Self> {
        None
    }
    fn float(_: f64) -> Option<Self> {
        None
    }
    fn text(_: &str) -> Option<Self> {
        None
    }
    fn list<'de, A: SeqAccess<'de>>(_: A) -> Result<Option<Self>, A::Error> {
        Ok(None)
    }
    fn table<'de, A: MapAccess<'de>>(_: A) -> Result<Option<Self>, A::Error> {
        Ok(None)
    }
}

struct LiteralVisitor<T>(PhantomData<T>);

impl<'de, T: Literal> Visitor<'de> for LiteralVisitor<T> {
    type Value = T;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(T::EXPECTED)
    }

    fn visit_bool<E: Error>(self, value: bool) -> Result<T, E> {
        T::truth(value).ok_or_else(|| E::invalid_type(Unexpected::Bool(value), &self))
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<T, E> {
        T::integer(i128::from(value)).ok_or_else(|| E::invalid_type(Unexpected::Signed(value), &self))
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<T, E> {
        T::integer(i128::from(value)).ok_or_else(|| E::invalid_type(Unexpected::Unsigned(value), &self))
    }

    fn visit_i128<E: Error>(self, value: i128) -> Result<T, E> {
        T::integer(value).ok_or_else(|| E::invalid_type(Unexpected::Other("an integer"), &self))
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<T, E> {
        T::float(value).ok_or_else(|| E::invalid_type(Unexpected::Float(value), &self))
    }

    fn visit_str<E: Error>(self, value: &str) -> Result<T, E> {
        T::text(value).ok_or_else(|| E::invalid_type(Unexpected::Other("a text"), &self))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<T, A::Error> {
        T::list(list)?.ok_or_else(|| A::Error::invalid_type(Unexpected::Seq, &self))
    }

    fn visit_map<A: MapAccess<'de>>(self, table: A) -> Result<T, A::Error> {
        T::table(table)?.ok_or_else(|| A::Error::invalid_type(Unexpected::Map, &self))
    }
}

macro_rules! deserialize_literals {
    ($($literal:ty),*) => {$(
        impl<'de> Deserialize<'de> for $literal {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                deserializer.deserialize_any(LiteralVisitor(PhantomData))
            }
        }
    )*};
}

deserialize_literals!(
    Text,
    Integer,
    Switch,
    Number,
    NumberList,
    Coordinates,
    PointList,
    TextList,
    SearchKey,
    MaskKey,
    Samples,
    ExpectValue,
    Published
);

fn elements<'de, A: SeqAccess<'de>, T: Deserialize<'de>>(list: A) -> Result<Vec<T>, A::Error> {
    Vec::deserialize(SeqAccessDeserializer::new(list))
}

/// A text.
#[derive(Debug)]
pub(crate) struct Text(pub(crate) String);

impl Literal for Text {
    const EXPECTED: &'static str = "a text in quotes";

    fn text(value: &str) -> Option<Self> {
        Some(Self(value.to_owned()))
    }
}

/// A whole number of any sign.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Integer(pub(crate) i128);

impl Literal for Integer {
    const EXPECTED: &'static str = "a whole number";

    fn integer(value: i128) -> Option<Self> {
        Some(Self(value))
    }
}

/// Yes or no.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Switch(pub(crate) bool);

impl Literal for Switch {
    const EXPECTED: &'static str = "true or false";

    fn truth(value: bool) -> Option<Self> {
        Some(Self(value))
    }
}

/// A number, written with or without a point; may be NaN or infinite.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Number(pub(crate) f64);

impl Literal for Number {
    const EXPECTED: &'static str = "a number";

    fn integer(value: i128) -> Option<Self> {
        Some(Self(value as f64))
    }

    fn float(value: f64) -> Option<Self> {
        Some(Self(value))
    }
}

/// Numbers, each with its place.
#[derive(Debug)]
pub(crate) struct NumberList(pub(crate) Vec<Spanned<Number>>);

impl Literal for NumberList {
    const EXPECTED: &'static str = "a list of numbers, like [1.0, 2.0]";

    fn list<'de, A: SeqAccess<'de>>(list: A) -> Result<Option<Self>, A::Error> {
        elements(list).map(|numbers| Some(Self(numbers)))
    }
}

/// The coordinates of a point, of any number.
#[derive(Debug)]
pub(crate) struct Coordinates(pub(crate) Vec<Spanned<Number>>);

impl Literal for Coordinates {
    const EXPECTED: &'static str = "a point, like [0, 6, 2]";

    fn list<'de, A: SeqAccess<'de>>(list: A) -> Result<Option<Self>, A::Error> {
        elements(list).map(|numbers| Some(Self(numbers)))
    }
}

/// Points, each with its place.
#[derive(Debug)]
pub(crate) struct PointList(pub(crate) Vec<Spanned<Coordinates>>);

impl Literal for PointList {
    const EXPECTED: &'static str = "a list of points, like [[0, 0, 0], [2, 0, 2]]";

    fn list<'de, A: SeqAccess<'de>>(list: A) -> Result<Option<Self>, A::Error> {
        elements(list).map(|points| Some(Self(points)))
    }
}

/// Texts, each with its place.
#[derive(Debug)]
pub(crate) struct TextList(pub(crate) Vec<Spanned<Text>>);

impl Literal for TextList {
    const EXPECTED: &'static str = "a list of texts, like [\"obj\", \"ply\"]";

    fn list<'de, A: SeqAccess<'de>>(list: A) -> Result<Option<Self>, A::Error> {
        elements(list).map(|texts| Some(Self(texts)))
    }
}

/// The `search` of a method.
#[derive(Debug)]
pub(crate) enum SearchKey {
    Truth(bool),
    Name(String),
}

impl Literal for SearchKey {
    const EXPECTED: &'static str = "true, false, \"pso\", \"polish\" or \"pso-polish\"";

    fn truth(value: bool) -> Option<Self> {
        Some(Self::Truth(value))
    }

    fn text(value: &str) -> Option<Self> {
        Some(Self::Name(value.to_owned()))
    }
}

/// The `mask` of a method.
#[derive(Debug)]
pub(crate) enum MaskKey {
    Alpha(f64),
    Name(String),
}

impl Literal for MaskKey {
    const EXPECTED: &'static str = "the corner weight, a number, or \"dirichlet\" or \"coons\"";

    fn integer(value: i128) -> Option<Self> {
        Some(Self::Alpha(value as f64))
    }

    fn float(value: f64) -> Option<Self> {
        Some(Self::Alpha(value))
    }

    fn text(value: &str) -> Option<Self> {
        Some(Self::Name(value.to_owned()))
    }
}

/// The `samples` of a curve.
#[derive(Debug)]
pub(crate) enum Samples {
    Count(i128),
    Parameters(Vec<Spanned<Number>>),
}

impl Literal for Samples {
    const EXPECTED: &'static str = "a list of parameters, or how many";

    fn integer(value: i128) -> Option<Self> {
        Some(Self::Count(value))
    }

    fn list<'de, A: SeqAccess<'de>>(list: A) -> Result<Option<Self>, A::Error> {
        elements(list).map(|parameters| Some(Self::Parameters(parameters)))
    }
}

/// An expected number, or several.
#[derive(Debug)]
pub(crate) enum ExpectValue {
    Number(f64),
    Toleranced(TolerancedSpec),
    List(Vec<Spanned<Number>>),
}

impl Literal for ExpectValue {
    const EXPECTED: &'static str = "a number, a list of numbers, or { value = …, tolerance = … }";

    fn integer(value: i128) -> Option<Self> {
        Some(Self::Number(value as f64))
    }

    fn float(value: f64) -> Option<Self> {
        Some(Self::Number(value))
    }

    fn list<'de, A: SeqAccess<'de>>(list: A) -> Result<Option<Self>, A::Error> {
        elements(list).map(|numbers| Some(Self::List(numbers)))
    }

    fn table<'de, A: MapAccess<'de>>(table: A) -> Result<Option<Self>, A::Error> {
        TolerancedSpec::deserialize(MapAccessDeserializer::new(table))
            .map(|spec| Some(Self::Toleranced(spec)))
    }
}

/// The printed numbers of a method: one table `[method.published]` or several `[[method.published]]`.
#[derive(Debug)]
pub(crate) enum Published {
    One(PublishedSpec),
    Several(Vec<Spanned<Section<PublishedSpec>>>),
}

impl Literal for Published {
    const EXPECTED: &'static str = "a table [method.published], or several [[method.published]]";

    fn list<'de, A: SeqAccess<'de>>(list: A) -> Result<Option<Self>, A::Error> {
        elements(list).map(|specs| Some(Self::Several(specs)))
    }

    fn table<'de, A: MapAccess<'de>>(table: A) -> Result<Option<Self>, A::Error> {
        PublishedSpec::deserialize(MapAccessDeserializer::new(table)).map(|spec| Some(Self::One(spec)))
    }
}
