//! The text of an experiment: a document read once, key by key, with every fault in it.
//!
//! A [`Key`] says what may stand under its name; a [`Table`] of the document is asked for keys and answers with sound values.
//! What it holds besides is unknown. The JSON Schema and the lists of keys in the book are made of the same keys.

mod document;
mod faults;
mod given;
mod interval;
mod key;
mod kind;
mod number;
mod points;
mod size;
mod syntax;
mod table;
mod value;

pub(crate) use document::parse;
pub(crate) use faults::Faults;
pub(crate) use given::Given;
pub(crate) use interval::Interval;
pub(crate) use key::{Entry, Key, Section, Ways};
pub(crate) use kind::{Flag, Form, Kind, List, Name, Names, Place, Reals, Text, Whole};
pub(crate) use number::{counted, half_unit_of_last_digit, shown, shown_point};
pub(crate) use points::{PointList, Points};
pub(crate) use table::{Inner, OneOrSeveral, Several, Table, Tables};
pub(crate) use value::Value;
