//! The state of a swarm and its four steps: scatter, advance, evaluate, remember.

use rayon::prelude::*;

use crate::bounds::Bounds;
use crate::objective::Objective;
use crate::pso::Pso;
use crate::stream::{Purpose, Source, Stream, unit};
use crate::topology::{Informants, arg_min};

/// N particles in d dimensions. Points, velocities, walls are row-major, N × d, so that a step of the
/// whole swarm is one loop without branches.
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
    /// The own bests of the informants.
    informing_points: Vec<f64>,
    /// The bounds, repeated for every particle.
    lower: Vec<f64>,
    upper: Vec<f64>,
    streams: Vec<Stream>,
    /// r₁, r₂ of each component in turn, N × d × 2, and the random bytes they are made of.
    draws: Vec<f64>,
    bytes: Vec<u8>,
    best: usize,
    pub(crate) nan_evaluations: u64,
}

impl<'a> Swarm<'a> {
    /// Uniform positions in the box, uniform velocities in ±`initial_velocity` × box.
    pub(crate) fn scatter(pso: &Pso, bounds: &'a Bounds, run: usize) -> Self {
        let (particles, dimension) = (pso.particles, bounds.dimension());
        let coordinates = particles * dimension;
        let source = Source::new(Purpose::Swarm, pso.seed, run as u64);
        let mut positions = Vec::with_capacity(coordinates);
        let mut velocities = Vec::with_capacity(coordinates);
        let mut streams = Vec::with_capacity(particles);
        // The order of the draws is part of what a seed means: position, then velocity, particle after particle.
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
            informing_points: vec![0.0; coordinates],
            lower: bounds.lower().repeat(particles),
            upper: bounds.upper().repeat(particles),
            draws: vec![0.0; 2 * coordinates],
            bytes: vec![0; 16 * coordinates],
            positions,
            velocities,
            streams,
            best: 0,
            nan_evaluations: 0,
        }
    }

    /// Moves every particle by the bests of the previous iteration.
    pub(crate) fn advance(&mut self, pso: &Pso) {
        let d = self.bounds.dimension();
        // All informants are copied before anyone moves: iterations are synchronous.
        self.informants.update(&self.own_values);
        for (i, point) in self.informing_points.chunks_exact_mut(d).enumerate() {
            let j = self.informants.of(i);
            point.copy_from_slice(&self.own_points[j * d..(j + 1) * d]);
        }
        // A particle's bytes in one piece: its stream advances by the same number whatever the loops below look like.
        let bytes = self.bytes.chunks_exact_mut(16 * d);
        for (stream, bytes) in self.streams.iter_mut().zip(bytes) {
            stream.fill_bytes(bytes);
        }
        for (draw, bytes) in self.draws.iter_mut().zip(self.bytes.as_chunks().0) {
            *draw = unit(u64::from_le_bytes(*bytes));
        }
        fly(
            pso,
            &mut self.positions,
            &mut self.velocities,
            &self.draws,
            [&self.informing_points, &self.own_points],
            [&self.lower, &self.upper],
        );
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
            // Until something finite is seen the own best stays with the particle.
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

/// `v ← w v + c₁ r₁ (informant − x) + c₂ r₂ (own best − x)`, `x ← x + v`, for each coordinate; one
/// that leaves the box stops at the wall.
///
/// A function of its own because slices that are arguments are known not to overlap, without which
/// the loop is not vectorised.
#[inline(never)]
fn fly(
    pso: &Pso,
    x: &mut [f64],
    v: &mut [f64],
    draws: &[f64],
    [informant, own]: [&[f64]; 2],
    [lower, upper]: [&[f64]; 2],
) {
    let n = x.len();
    let (v, draws) = (&mut v[..n], &draws[..2 * n]);
    let (informant, own) = (&informant[..n], &own[..n]);
    let (lower, upper) = (&lower[..n], &upper[..n]);
    let (w, c1, c2) = (pso.inertia, pso.social, pso.cognitive);
    for k in 0..n {
        let (r1, r2) = (draws[2 * k], draws[2 * k + 1]);
        let velocity = w * v[k] + c1 * r1 * (informant[k] - x[k]) + c2 * r2 * (own[k] - x[k]);
        let free = x[k] + velocity;
        // Comparisons that select, since f64::clamp branches and walls are hard to predict.
        let above = if free < lower[k] { lower[k] } else { free };
        let inside = if above > upper[k] { upper[k] } else { above };
        x[k] = inside;
        v[k] = if inside == free { velocity } else { 0.0 };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wall_stops_the_component_that_meets_it() {
        let pso = Pso { inertia: 1.0, ..Pso::new(0) };
        let (mut x, mut v) = ([0.9, 0.1, 0.5], [0.3, -0.3, 0.25]);
        let here = x;
        fly(&pso, &mut x, &mut v, &[0.5; 6], [&here, &here], [&[0.0; 3], &[1.0; 3]]);
        assert_eq!(x, [1.0, 0.0, 0.75]);
        assert_eq!(v, [0.0, 0.0, 0.25]);
    }

    #[test]
    fn a_step_follows_the_formula() {
        let pso = Pso { inertia: 0.5, social: 2.0, cognitive: 4.0, ..Pso::new(0) };
        let (mut x, mut v) = ([1.0], [0.25]);
        // v = 0.5·0.25 + 2·0.25·(3 − 1) + 4·0.5·(0.5 − 1), all exact.
        fly(&pso, &mut x, &mut v, &[0.25, 0.5], [&[3.0], &[0.5]], [&[-9.0], &[9.0]]);
        assert_eq!((x, v), ([1.125], [0.125]));
    }
}
