//! A run of a search in a checkpoint. Numbers are kept as their bits: exactly, also those that are not finite.

use optim::{Best, Bound, PolishReason, Polished, Reason};
use serde::{Deserialize, Serialize};

use plateau::{SearchRun, Swarm};

#[derive(Serialize, Deserialize)]
pub(super) struct RunRecord {
    method: usize,
    seed: u64,
    run: usize,
    swarm: Option<SwarmRecord>,
    /// The best of the swarm, where no descent followed it.
    best: Option<BestRecord>,
    polish: Option<PolishRecord>,
}

#[derive(Serialize, Deserialize)]
struct SwarmRecord {
    reason: String,
    evaluations: u64,
    nan_evaluations: u64,
    history: Vec<u64>,
}

#[derive(Serialize, Deserialize)]
struct BestRecord {
    value: u64,
    point: Vec<u64>,
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
        let best = || BestRecord { value: run.value().to_bits(), point: bits(run.shape()) };
        Self {
            method,
            seed: run.seed(),
            run: run.index(),
            swarm: run.swarm().map(SwarmRecord::new),
            best: run.polish().is_none().then(best),
            polish: run.polish().map(PolishRecord::new),
        }
    }

    /// The run with the indices of its method and its own; none if the record is of no run that this program makes.
    pub(super) fn run(&self) -> Option<((usize, usize), SearchRun)> {
        let number = (self.seed, self.run);
        let swarm = match &self.swarm {
            Some(swarm) => Some(swarm.swarm()?),
            None => None,
        };
        let run = match (&self.best, &self.polish) {
            (Some(best), None) => {
                let best = Best { value: f64::from_bits(best.value), point: numbers(&best.point) };
                SearchRun::of_swarm(number, swarm?, best)
            }
            (None, Some(polish)) => SearchRun::of_descent(number, swarm, polish.polished()?),
            (Some(_), Some(_)) | (None, None) => return None,
        };
        Some(((self.method, self.run), run))
    }
}

impl SwarmRecord {
    fn new(swarm: &Swarm) -> Self {
        Self {
            reason: swarm.reason.name().to_owned(),
            evaluations: swarm.evaluations,
            nan_evaluations: swarm.nan_evaluations,
            history: bits(&swarm.history),
        }
    }

    fn swarm(&self) -> Option<Swarm> {
        Some(Swarm {
            reason: Reason::ALL.into_iter().find(|reason| reason.name() == self.reason)?,
            evaluations: self.evaluations,
            nan_evaluations: self.nan_evaluations,
            history: numbers(&self.history),
        })
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

    /// None if its lists are not of one length.
    fn polished(&self) -> Option<Polished> {
        let bound = |side: &i8| match side {
            -1 => Some(Bound::Lower),
            0 => Some(Bound::Free),
            1 => Some(Bound::Upper),
            _ => None,
        };
        if [self.gradient.len(), self.active.len()] != [self.point.len(); 2] {
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
    fn a_run_comes_back_whatever_the_number_of_its_parameters_and_however_it_ended() {
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
            let best = Best { value: f64::NEG_INFINITY, point: vec![0.5; parameters] };
            for reason in Reason::ALL {
                let (history, nan_evaluations) = (vec![f64::INFINITY, 2.0], 1);
                let swarm = Swarm { reason, evaluations: 40, nan_evaluations, history };
                for run in [
                    SearchRun::of_swarm((7, 3), swarm.clone(), best.clone()),
                    SearchRun::of_descent((7, 3), Some(swarm), polished.clone()),
                    SearchRun::of_descent((7, 3), None, polished.clone()),
                ] {
                    assert_eq!(RunRecord::new(2, &run).run(), Some(((2, 3), run)));
                }
            }
            let mut record = PolishRecord::new(&polished);
            record.gradient.push(0);
            assert!(record.polished().is_none());
        }
    }
}
