//! The text of an experiment: a document read once, key by key, with every fault in it.
//!
//! A [`Key`] says what may stand under its name; a [`Table`] of the document is asked for keys and answers with sound values.
//! What it holds besides is unknown. The JSON Schema and the lists of keys in the book are made of the same keys.

mod depth;
mod document;
mod faults;
mod form;
mod given;
mod head;
mod inner;
mod interval;
mod key;
mod kind;
mod name;
mod number;
mod place;
mod points;
mod reals;
mod size;
mod syntax;
mod table;
mod value;
mod vector;
mod whole;
mod words;

pub(crate) use depth::depth_after;
pub(crate) use document::parse;
pub(crate) use faults::Faults;
pub(crate) use form::Form;
pub(crate) use given::Given;
pub(crate) use inner::{Inner, OneOrSeveral, Several};
pub(crate) use interval::Interval;
pub(crate) use key::{Entry, Key, Section, Ways, sentence};
pub(crate) use kind::{Flag, Kind, Text};
pub(crate) use name::{List, Name, Names};
pub(crate) use number::{half_unit_of_last_digit, shown, shown_point};
pub(crate) use place::Place;
pub(crate) use points::{PointList, Points};
pub(crate) use reals::Reals;
pub(crate) use table::{Table, Tables};
pub(crate) use value::{Value, finite};
pub(crate) use vector::Vector;
pub(crate) use whole::Whole;
