//! A run of a search in a checkpoint. Numbers are kept as their bits: exactly, also those that are not finite.

use optim::{Bound, PolishReason, Polished};
use serde::{Deserialize, Serialize};

use plateau::SearchRun;

#[derive(Serialize, Deserialize)]
pub(super) struct RunRecord {
    method: usize,
    seed: u64,
    run: usize,
    value: u64,
    shape: Vec<u64>,
    reason: String,
    evaluations: u64,
    nan_evaluations: u64,
    history: Vec<u64>,
    on_budget: bool,
    polish: Option<PolishRecord>,
}

#[derive(Serialize, Deserialize)]
struct PolishRecord {
    value: u64,
    point: Vec<u64>,
    gradient: Vec<u64>,
    residual: u64,
    active: Vec<i8>,
    evaluations: usize,
    iterations: usize,
    reason: String,
}

impl RunRecord {
    pub(super) fn new(method: usize, run: &SearchRun) -> Self {
        Self {
            method,
            seed: run.seed,
            run: run.index,
            value: run.value.to_bits(),
            shape: bits(&run.shape),
            reason: run.reason.clone(),
            evaluations: run.evaluations,
            nan_evaluations: run.nan_evaluations,
            history: bits(&run.history),
            on_budget: run.on_budget,
            polish: run.polish.as_ref().map(PolishRecord::new),
        }
    }

    /// The run with the indices of its method and its own; none if the record is of no run that this program makes.
    pub(super) fn run(&self) -> Option<((usize, usize), SearchRun)> {
        let run = SearchRun {
            seed: self.seed,
            index: self.run,
            value: f64::from_bits(self.value),
            shape: numbers(&self.shape),
            reason: self.reason.clone(),
            evaluations: self.evaluations,
            nan_evaluations: self.nan_evaluations,
            history: numbers(&self.history),
            polish: match &self.polish {
                Some(polish) => Some(polish.polished(self.shape.len())?),
                None => None,
            },
            on_budget: self.on_budget,
        };
        Some(((self.method, self.run), run))
    }
}

impl PolishRecord {
    fn new(polished: &Polished) -> Self {
        let side = |bound: &Bound| match bound {
            Bound::Lower => -1,
            Bound::Free => 0,
            Bound::Upper => 1,
        };
        Self {
            value: polished.value.to_bits(),
            point: bits(&polished.point),
            gradient: bits(&polished.gradient),
            residual: polished.residual.to_bits(),
            active: polished.active.iter().map(side).collect(),
            evaluations: polished.evaluations,
            iterations: polished.iterations,
            reason: polished.reason.name().to_owned(),
        }
    }

    /// Over as many parameters; none if its lists are of another length.
    fn polished(&self, parameters: usize) -> Option<Polished> {
        let bound = |side: &i8| match side {
            -1 => Some(Bound::Lower),
            0 => Some(Bound::Free),
            1 => Some(Bound::Upper),
            _ => None,
        };
        if [self.point.len(), self.gradient.len(), self.active.len()] != [parameters; 3] {
            return None;
        }
        Some(Polished {
            value: f64::from_bits(self.value),
            point: numbers(&self.point),
            gradient: numbers(&self.gradient),
            residual: f64::from_bits(self.residual),
            active: self.active.iter().map(bound).collect::<Option<_>>()?,
            evaluations: self.evaluations,
            iterations: self.iterations,
            reason: PolishReason::ALL.into_iter().find(|reason| reason.name() == self.reason)?,
        })
    }
}

fn bits(numbers: &[f64]) -> Vec<u64> {
    numbers.iter().map(|x| x.to_bits()).collect()
}

fn numbers(bits: &[u64]) -> Vec<f64> {
    bits.iter().copied().map(f64::from_bits).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_comes_back_whatever_the_number_of_its_parameters() {
        for parameters in [1, 2, 4, 7] {
            let polished = Polished {
                value: 1.5,
                point: vec![0.25; parameters],
                gradient: vec![-0.0; parameters],
                residual: 1e-9,
                active: vec![Bound::Free; parameters],
                evaluations: 12,
                iterations: 3,
                reason: PolishReason::ALL[0],
            };
            let record = PolishRecord::new(&polished);
            assert_eq!(record.polished(parameters), Some(polished));
            assert!(record.polished(parameters + 1).is_none());
        }
    }
}
