//! What a reader must know of a film.

use surfaces::Point;

use super::{Film, pinch};
use crate::trust::of_film;
use crate::{AreaEnd, MethodError, Warning, Way};

/// An annulus that did not become stationary is pinching where it is thinner than this share of its thinner rim.
const PINCHING: f64 = 0.2;

impl Film {
    /// The film moved.
    pub(super) fn moved(mut self, by: Point) -> Result<Self, MethodError> {
        if by == Point::ZERO {
            return Ok(self);
        }
        self.complex = self.complex.moved(by)?;
        self.mesh.mesh.points.iter_mut().for_each(|p| *p += by);
        for warning in &mut self.warnings {
            if let Warning::Pinches { at, .. } = warning {
                *at = (Point::from(*at) + by).into();
            }
        }
        Ok(self)
    }

    /// What a reader must know.
    pub(super) fn warned(&self) -> Result<Vec<Warning>, MethodError> {
        let mut warnings = Vec::new();
        match self.pinches()? {
            // What else is wrong comes of that.
            Some(pinches) => warnings.push(pinches),
            None => {
                of_film(self.extremal.as_ref(), &self.figures, &mut warnings);
                self.warn_of_folds(&mut warnings);
            }
        }
        let area = self.figures.area.value;
        if let Some(discs) = self.one_by_one.filter(|discs| *discs < area) {
            warnings.push(Warning::OneByOne { discs, area });
        }
        Ok(warnings)
    }

    fn warn_of_folds(&self, warnings: &mut Vec<Warning>) {
        if self.seams.folds() {
            let (faces, of) = (self.seams.folded.len(), self.complex.faces().len());
            warnings.push(Warning::Folded { faces, of, kink: self.seams.kink.map_or(0.0, |kink| kink.max) });
        }
        if let Some(edge) = self.seams.singular_edge {
            let ends = self.edge_name(edge).map(str::to_owned);
            warnings.push(Warning::KinkUndefined { ends });
        }
    }

    /// That an annulus pinches: it is unstable, or was left thin and not stationary. With layers around corners its faces are no rings; it
    /// had none unless it was a minimum without.
    fn pinches(&self) -> Result<Option<Warning>, MethodError> {
        let (Some(found), Way::Annulus, 0) = (&self.extremal, self.way, self.layers) else { return Ok(None) };
        let Some(waist) = pinch::thinnest(&self.complex)? else { return Ok(None) };
        let is_stuck = found.end != AreaEnd::Stationary && waist.length < PINCHING * waist.rim;
        let is_unstable = found.second_variation.is_some_and(|smallest| smallest < 0.0);
        let pinches = Warning::Pinches { length: waist.length, at: waist.middle.into() };
        Ok((is_stuck || is_unstable).then_some(pinches))
    }
}
