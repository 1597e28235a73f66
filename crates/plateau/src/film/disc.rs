//! The disc in one loop, cut in whatever way leads to a sound one.

use energy::EnergyError;

use super::options::Fill;
use super::solution::Solution;
use super::{Tried, Way};
use crate::{CutBoundary, Cutting, Loop, MethodError, Progress, Seams};

/// What is tried besides the way that the corners of a loop suggest.
const OTHERS: [Way; 3] = [Way::Ring, Way::TurnedRing, Way::Parts];

/// Below this ratio of the least to the mean of `|x_u × x_v|` another way of cutting is tried.
const UNEVEN: f64 = 1e-2;

impl Fill {
    /// The disc in a loop: cut as its corners suggest, unless its Coons start folds and that of another cut does not, or the
    /// surface found folds, nearly folds or is not stationary.
    pub(super) fn disc(
        &self,
        around: &Loop,
        cutting: Cutting,
        progress: &dyn Progress,
    ) -> Result<(Solution, Vec<Tried>), MethodError> {
        let mut cuts = vec![cutting.loops(std::slice::from_ref(around))?];
        let suggested = cuts[0].way();
        // A loop that crosses itself has no parts; ways it does not admit are passed over.
        let others = || {
            OTHERS
                .into_iter()
                .filter(|way| *way != suggested)
                .filter_map(|way| cutting.with_way(way).loops(std::slice::from_ref(around)).ok())
        };
        let is_even = |cut: &CutBoundary| Seams::of(cut.complex()).map(|seams| seams.is_even(UNEVEN));
        let mut all = !is_even(&cuts[0])?;
        if all {
            cuts.extend(others());
            let mut even = cuts.iter().map(is_even).collect::<Result<Vec<_>, _>>()?.into_iter();
            // Stable: those that are even keep their order, and so do the others.
            cuts.sort_by_cached_key(|_| even.next().is_none_or(|even| !even));
        }
        let mut best = self.solved(&cuts[0], progress);
        let (mut way, mut tried, mut next) = (cuts[0].way(), Vec::new(), 1);
        // A start that is singular leads nowhere; another may.
        while match &best {
            Ok(best) => !best.is_sound(UNEVEN),
            Err(error) => matches!(error, MethodError::Energy(EnergyError::Singular { .. })),
        } {
            if next == cuts.len() && !std::mem::replace(&mut all, true) {
                cuts.extend(others());
            }
            let Some(cut) = cuts.get(next) else { break };
            let mut found = self.solved(cut, progress);
            let mut left = cut.way();
            let is_better = match (&found, &best) {
                (Ok(found), Ok(best)) => found.is_better(best),
                (found, Err(_)) => found.is_ok(),
                (Err(_), Ok(_)) => false,
            };
            if is_better {
                std::mem::swap(&mut found, &mut best);
                std::mem::swap(&mut left, &mut way);
            }
            let singular = Tried { way: left, area: None, jacobian_ratio: 0.0, folds: true };
            tried.push(found.map_or(singular, |found| found.tried()));
            next += 1;
        }
        best.map(|best| (best, tried))
    }
}
