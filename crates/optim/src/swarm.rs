//! The state of a swarm and its four steps: scatter, advance, evaluate, remember.

use rayon::prelude::*;

use crate::bounds::Bounds;
use crate::objective::Objective;
use crate::pso::Pso;
use crate::stream::{Purpose, Source, Stream};
use crate::topology::{Informants, arg_min};

/// N particles in d dimensions; points are row-major, N × d.
pub(crate) struct Swarm<'a> {
    bounds: &'a Bounds,
    positions: Vec<f64>,
    velocities: Vec<f64>,
    values: Vec<f64>,
    /// The best point each particle has visited itself; it follows the particle, and so exerts no
    /// pull, while the particle has seen nothing finite.
    own_points: Vec<f64>,
    /// Never NaN; `+∞` while nothing finite was seen.
    own_values: Vec<f64>,
    informants: Informants,
    streams: Vec<Stream>,
    /// The random numbers of one particle's step: r1, then r2.
    draws: Vec<f64>,
    best: usize,
    pub(crate) nan_evaluations: u64,
}

impl<'a> Swarm<'a> {
    /// Uniform positions in the box, uniform velocities in ±`initial_velocity` × box.
    pub(crate) fn scatter(pso: &Pso, bounds: &'a Bounds, run: usize) -> Self {
        let (particles, dimension) = (pso.particles, bounds.dimension());
        let source = Source::new(Purpose::Swarm, pso.seed, run as u64);
        let mut positions = Vec::with_capacity(particles * dimension);
        let mut velocities = Vec::with_capacity(particles * dimension);
        let mut streams = Vec::with_capacity(particles);
        for particle in 0..particles {
            let mut stream = source.stream(particle);
            positions.extend((0..dimension).map(|c| bounds.at(c, stream.uniform())));
            velocities.extend(
                (0..dimension)
                    .map(|c| pso.initial_velocity * bounds.width(c) * (2.0 * stream.uniform() - 1.0)),
            );
            streams.push(stream);
        }
        Self {
            bounds,
            own_points: positions.clone(),
            own_values: vec![f64::INFINITY; particles],
            values: vec![f64::NAN; particles],
            informants: Informants::new(pso.topology, particles),
            draws: vec![0.0; 2 * dimension],
            positions,
            velocities,
            streams,
            best: 0,
            nan_evaluations: 0,
        }
    }

    /// Moves every particle by the bests of the previous iteration:
    /// `v ← w v + c₁ r₁∘(informant − x) + c₂ r₂∘(own best − x)`, `x ← x + v`; a component that
    /// leaves the box stops at the wall.
    pub(crate) fn advance(&mut self, pso: &Pso) {
        let d = self.bounds.dimension();
        let (lower, upper) = (self.bounds.lower(), self.bounds.upper());
        self.informants.update(&self.own_values);
        let (r1, r2) = self.draws.split_at_mut(d);
        let flock = self
            .positions
            .chunks_exact_mut(d)
            .zip(self.velocities.chunks_exact_mut(d))
            .zip(self.own_points.chunks_exact(d))
            .zip(&mut self.streams);
        for (i, (((x, v), own), stream)) in flock.enumerate() {
            stream.fill(r1);
            stream.fill(r2);
            let j = self.informants.of(i);
            let informant =
                if self.own_values[j] < f64::INFINITY { &self.own_points[j * d..(j + 1) * d] } else { own };
            for c in 0..d {
                v[c] = pso.inertia * v[c]
                    + pso.social * r1[c] * (informant[c] - x[c])
                    + pso.cognitive * r2[c] * (own[c] - x[c]);
                x[c] += v[c];
                if x[c] < lower[c] {
                    (x[c], v[c]) = (lower[c], 0.0);
                } else if x[c] > upper[c] {
                    (x[c], v[c]) = (upper[c], 0.0);
                }
            }
        }
    }

    /// Values of all positions, `batch` particles a call; a value is written by its own particle
    /// only, so neither the batches nor the threads show in the result.
    pub(crate) fn evaluate(&mut self, objective: &(impl Objective + ?Sized), batch: usize) {
        // What an objective forgets to write counts as NaN, not as the value before.
        self.values.fill(f64::NAN);
        if batch >= self.values.len() {
            objective.evaluate(&self.positions, &mut self.values);
        } else {
            self.positions
                .par_chunks(batch * self.bounds.dimension())
                .zip(self.values.par_chunks_mut(batch))
                .for_each(|(points, values)| objective.evaluate(points, values));
        }
    }

    /// Own bests and the best of all, the arg min with ties to the smaller index.
    pub(crate) fn remember(&mut self) {
        let d = self.bounds.dimension();
        for (i, &value) in self.values.iter().enumerate() {
            self.nan_evaluations += u64::from(value.is_nan());
            // A NaN compares as not less.
            if value < self.own_values[i] {
                self.own_values[i] = value;
            } else if self.own_values[i] < f64::INFINITY {
                continue;
            }
            let here = i * d..(i + 1) * d;
            self.own_points[here.clone()].copy_from_slice(&self.positions[here]);
        }
        self.best = arg_min(&self.own_values);
    }

    pub(crate) fn best_value(&self) -> f64 {
        self.own_values[self.best]
    }

    pub(crate) fn best_point(&self) -> Option<&[f64]> {
        let d = self.bounds.dimension();
        let found = self.best_value() < f64::INFINITY;
        found.then(|| &self.own_points[self.best * d..(self.best + 1) * d])
    }

    /// The largest extent of the positions along a component, relative to the box.
    pub(crate) fn diameter(&self) -> f64 {
        let d = self.bounds.dimension();
        let extent = |c: usize| {
            let component = self.positions[c..].iter().step_by(d);
            let (least, greatest) =
                component.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), &x| (a.min(x), b.max(x)));
            (greatest - least) / self.bounds.width(c)
        };
        (0..d).map(extent).fold(0.0, f64::max)
    }
}
