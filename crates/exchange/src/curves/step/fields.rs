//! Values of entities, read as what they should be.

use super::part21::{Entity, Value};
use crate::curves::{CurveFileError, limits};

/// Values of one entity, with the words for a refusal.
pub(super) struct Fields<'a> {
    pub(super) entity: &'a Entity,
    pub(super) id: u64,
    pub(super) line: usize,
}

impl Fields<'_> {
    pub(super) fn wrong(&self, why: &str) -> CurveFileError {
        CurveFileError::at(self.line, format!("#{} ({}): {why}", self.id, limits::name(&self.entity.name)))
    }

    pub(super) fn named(&self, name: &str) -> Result<(), CurveFileError> {
        if self.entity.name == name { Ok(()) } else { Err(self.wrong(&format!("a {name} was expected"))) }
    }

    pub(super) fn reference(&self, place: usize) -> Result<u64, CurveFileError> {
        match self.entity.values.get(place) {
            Some(Value::Reference(id)) => Ok(*id),
            _other => Err(self.wrong(&format!("parameter {} should refer to an instance", place + 1))),
        }
    }

    pub(super) fn number(&self, place: usize) -> Result<f64, CurveFileError> {
        match self.entity.values.get(place) {
            Some(Value::Number(x)) => Ok(*x),
            // POSITIVE_LENGTH_MEASURE(1.)
            Some(Value::Typed(_, inner)) => match inner.as_slice() {
                [Value::Number(x)] => Ok(*x),
                _other => Err(self.wrong(&format!("parameter {} should be a number", place + 1))),
            },
            _other => Err(self.wrong(&format!("parameter {} should be a number", place + 1))),
        }
    }

    pub(super) fn count(&self, place: usize) -> Result<usize, CurveFileError> {
        let x = self.number(place)?;
        if (0.0..=1000.0).contains(&x) && x.fract() == 0.0 {
            Ok(x as usize)
        } else {
            Err(self.wrong(&format!("{x} is not a degree")))
        }
    }

    pub(super) fn flag(&self, place: usize) -> Option<bool> {
        match self.entity.values.get(place) {
            Some(Value::Word(word)) if word == "T" || word == "TRUE" => Some(true),
            Some(Value::Word(word)) if word == "F" || word == "FALSE" => Some(false),
            _other => None,
        }
    }

    pub(super) fn list(&self, place: usize) -> Result<&[Value], CurveFileError> {
        match self.entity.values.get(place) {
            Some(Value::List(values)) => Ok(values),
            _other => Err(self.wrong(&format!("parameter {} should be a list", place + 1))),
        }
    }

    pub(super) fn references(&self, place: usize) -> Result<Vec<u64>, CurveFileError> {
        let wrong = || self.wrong(&format!("parameter {} should be a list of instances", place + 1));
        self.list(place)?.iter().map(|value| value.reference().ok_or_else(wrong)).collect()
    }

    pub(super) fn numbers(&self, place: usize) -> Result<Vec<f64>, CurveFileError> {
        let wrong = || self.wrong(&format!("parameter {} should be a list of numbers", place + 1));
        self.list(place)?.iter().map(|value| value.number().ok_or_else(wrong)).collect()
    }
}
