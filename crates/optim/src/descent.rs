//! One descent of the polish: iterates, line search, when to stop.

use std::mem::swap;

use crate::bounds::Bounds;
use crate::box_model::BoxModel;
use crate::hessian::{Hessian, dot};
use crate::objective::Smooth;
use crate::polish::Polish;
use crate::report::{Bound, PolishReason, Polished};

/// Fraction of the predicted decrease that a step must achieve (Armijo).
const SUFFICIENT: f64 = 1e-4;
/// A step after which the slope is still steeper than this fraction of the first one was too short.
const STEEP: f64 = 0.9;
/// Decreases below this, relative to the value, cannot be told from rounding.
const NOISE: f64 = 16.0 * f64::EPSILON;
/// Within this, relative to the value or to that of the start, a step is judged by the gradient
/// alone, which still points the way where cancellation within the objective blurs the value.
const BLUR: f64 = 1e-12;
/// Blurred steps in a row that need not halve the residual.
const PATIENCE: usize = 4;
/// Trials of one line search.
const TRIALS: usize = 20;
/// A step longer than this, relative to the box, ends where old curvature may not hold any more.
const FAR: f64 = 0.03;
/// Length of the first step, relative to the box.
const FIRST_STEP: f64 = 0.3;

struct Iterate {
    point: Vec<f64>,
    gradient: Vec<f64>,
    value: f64,
}

impl Iterate {
    fn new(dimension: usize) -> Self {
        Self { point: vec![0.0; dimension], gradient: vec![0.0; dimension], value: f64::NAN }
    }

    fn copy_from(&mut self, other: &Self) {
        self.point.copy_from_slice(&other.point);
        self.gradient.copy_from_slice(&other.gradient);
        self.value = other.value;
    }

    fn is_finite(&self) -> bool {
        self.value.is_finite() && self.gradient.iter().all(|g| g.is_finite())
    }

    /// Differences of values below this are rounding.
    fn noise(&self) -> f64 {
        NOISE * self.value.abs()
    }
}

/// How a line search ended.
enum Search {
    /// `trial` is the next iterate.
    Found,
    /// No decrease was seen.
    Failed,
    /// The evaluations ran out.
    Budget,
}

pub(crate) struct Descent<'a, S: ?Sized> {
    polish: &'a Polish,
    objective: &'a S,
    bounds: &'a Bounds,
    widths: Vec<f64>,
    hessian: Hessian,
    model: BoxModel,
    /// The iterate.
    at: Iterate,
    /// The point under trial on the line.
    trial: Iterate,
    /// The longest step of the line search known to be too short, with sufficient decrease.
    short: Iterate,
    /// What no later iterate may exceed: the start's value, up to rounding.
    ceiling: f64,
    /// The least value of an iterate; later ones may exceed it by [`BLUR`].
    lowest: f64,
    /// The iterate of least residual since the value last fell noticeably, and that residual.
    calmest: Iterate,
    calm: f64,
    /// Steps since that residual was halved.
    idle: usize,
    target: Vec<f64>,
    step: Vec<f64>,
    change: Vec<f64>,
    evaluations: usize,
    iterations: usize,
}

impl<'a, S: Smooth + ?Sized> Descent<'a, S> {
    pub(crate) fn new(polish: &'a Polish, objective: &'a S, bounds: &'a Bounds, start: &[f64]) -> Self {
        let n = start.len();
        let mut descent = Self {
            polish,
            objective,
            bounds,
            widths: (0..n).map(|i| bounds.width(i)).collect(),
            hessian: Hessian::new(n),
            model: BoxModel::new(n),
            at: Iterate::new(n),
            trial: Iterate::new(n),
            short: Iterate::new(n),
            ceiling: f64::INFINITY,
            lowest: f64::INFINITY,
            calmest: Iterate::new(n),
            calm: f64::INFINITY,
            idle: 0,
            target: vec![0.0; n],
            step: vec![0.0; n],
            change: vec![0.0; n],
            evaluations: 0,
            iterations: 0,
        };
        descent.trial.point.copy_from_slice(start);
        descent.evaluate_trial();
        swap(&mut descent.at, &mut descent.trial);
        descent.ceiling = descent.at.value + descent.at.noise();
        descent
    }

    /// Descends to the end and reports.
    pub(crate) fn finish(mut self) -> Polished {
        let reason = if self.at.is_finite() { self.descend() } else { PolishReason::NotFinite };
        // Where values are blurred the last iterate need not be the best one: that of the least residual is.
        if self.calm < self.residual(&self.at) {
            swap(&mut self.at, &mut self.calmest);
        }
        let residual = self.residual(&self.at);
        let active = (0..self.widths.len()).map(|i| self.active(i)).collect();
        Polished {
            value: self.at.value,
            point: self.at.point,
            gradient: self.at.gradient,
            residual,
            active,
            evaluations: self.evaluations,
            iterations: self.iterations,
            reason,
        }
    }

    fn descend(&mut self) -> PolishReason {
        let mut curvature = self.first_curvature();
        // Whether B still is the multiple of the identity it began as.
        let mut fresh = true;
        self.hessian.reset(curvature, &self.widths);
        loop {
            let residual = self.residual(&self.at);
            self.remember(residual);
            // Widths times gradient have the unit of the value: the quotient has none.
            if residual <= self.polish.tolerance * self.at.value.abs() {
                return PolishReason::Stationary;
            }
            let solved = self.model.minimize(
                &self.hessian,
                &self.at.gradient,
                &self.at.point,
                self.bounds,
                &mut self.target,
            );
            for i in 0..self.step.len() {
                self.step[i] = self.target[i] - self.at.point[i];
            }
            let slope = dot(&self.at.gradient, &self.step);
            let search =
                // A model that was not solved, or whose step does not fall, is as useless as a search that found nothing.
                if solved && slope < 0.0 { self.search_line(slope, residual) } else { Search::Failed };
            match search {
                Search::Budget => return PolishReason::Budget,
                // With a fresh B the step was one of steepest descent in units of the box: nothing else is left to try.
                Search::Failed if fresh || (solved && -slope <= self.at.noise()) => {
                    return PolishReason::Flat;
                }
                // Old curvature may have misled the step: forget it and try once more.
                Search::Failed => {
                    fresh = true;
                    self.hessian.reset(curvature, &self.widths);
                }
                Search::Found => {
                    self.iterations += 1;
                    self.learn(&mut curvature, &mut fresh);
                    swap(&mut self.at, &mut self.trial);
                }
            }
        }
    }

    /// Keeps the calmest iterate and the least value.
    fn remember(&mut self, residual: f64) {
        let fell = self.lowest - self.at.value > self.at.noise();
        self.lowest = self.lowest.min(self.at.value);
        self.idle = if fell || residual <= 0.5 * self.calm { 0 } else { self.idle + 1 };
        if fell || residual < self.calm {
            self.calm = residual;
            self.calmest.copy_from(&self.at);
        }
    }

    /// Curvature for which the first step has a sensible length: the change of the value across the
    /// box over the value, but not above [`FIRST_STEP`].
    fn first_curvature(&self) -> f64 {
        let steepest = self.residual(&self.at);
        let curvature = (steepest / FIRST_STEP).max(self.at.value.abs());
        if curvature > 0.0 { curvature } else { 1.0 }
    }

    /// BFGS from the pair s = trial − at, y = its change of gradient.
    fn learn(&mut self, curvature: &mut f64, fresh: &mut bool) {
        let (mut ss, mut yy) = (0.0, 0.0);
        for i in 0..self.step.len() {
            let (s, y) =
                (self.trial.point[i] - self.at.point[i], self.trial.gradient[i] - self.at.gradient[i]);
            (self.step[i], self.change[i]) = (s, y);
            ss += (s / self.widths[i]).powi(2);
            yy += (y * self.widths[i]).powi(2);
        }
        let sy = dot(&self.step, &self.change);
        // B stays positive definite only with positive curvature along the step; below rounding the pair teaches nothing.
        if sy.is_nan() || sy <= f64::EPSILON * (ss * yy).sqrt() {
            return;
        }
        // The first pair sets the scale of B before it is updated: as a multiple of the identity it was a guess.
        if *fresh {
            *curvature = yy / sy;
            self.hessian.reset(*curvature, &self.widths);
        }
        // An update that is refused leaves the multiple of the identity, which is as fresh as before.
        *fresh = !self.hessian.update(&self.step, &self.change, ss > FAR * FAR) && *fresh;
    }

    /// Searches along x(a) = x + a (target − x), put into the box, from a = 1.
    fn search_line(&mut self, slope: f64, residual: f64) -> Search {
        // The interval that holds acceptable steps: [a, value, slope] of its short end, its long end.
        let mut low = [0.0, self.at.value, slope];
        let mut high = f64::INFINITY;
        let mut a = 1.0;
        for _ in 0..TRIALS {
            if self.evaluations == self.polish.evaluations {
                return self.settle(low[0], Search::Budget);
            }
            if !self.place_trial(a) {
                return self.settle(low[0], Search::Failed);
            }
            self.evaluate_trial();
            // Where the objective is not finite nothing is known but that the step was too long.
            if !self.trial.is_finite() {
                high = a;
                a = low[0] + 0.25 * (high - low[0]);
                continue;
            }
            let decrease = self.at.value - self.trial.value;
            let predicted = -self.slope_to_trial();
            let steepness = self.slope_at_trial(a);
            // Values that cannot be told apart do not count here: the gradient must have become gentler.
            if self.is_blurred() {
                let halved = self.residual(&self.trial) <= 0.5 * residual;
                let gentler = steepness.abs() <= STEEP * slope.abs();
                let patient = self.idle < PATIENCE;
                if halved || (gentler && patient) {
                    return Search::Found;
                }
                // The slope has turned: the next trial is its zero, by the secant from the short end, which is not left behind.
                if steepness > 0.0 && patient {
                    self.idle += 1;
                    a = low[0] + (a - low[0]) * (low[2] / (low[2] - steepness));
                    continue;
                }
            }
            // Armijo's condition, then Wolfe's on one side: the slope must have risen, so that the pair has positive curvature.
            if decrease > 0.0 && decrease >= SUFFICIENT * predicted {
                if steepness >= STEEP * slope {
                    return Search::Found;
                }
                let next = if high.is_finite() { 0.5 * (a + high) } else { 4.0 * a };
                low = [a, self.trial.value, steepness];
                swap(&mut self.short, &mut self.trial);
                a = next;
            } else {
                high = a;
                // The first trial still promises less than rounding: shorter ones would promise even less.
                if low[0] == 0.0 && -slope * a <= self.at.noise() {
                    return Search::Failed;
                }
                // The cubic through both ends, but never so near an end that the interval hardly shrinks.
                let width = high - low[0];
                let guess = cubic_minimum(low, [a, self.trial.value, steepness]);
                a = guess.clamp(low[0] + 0.05 * width, high - 0.2 * width);
            }
        }
        self.settle(low[0], Search::Failed)
    }

    /// Takes the longest step with sufficient decrease, if there was one; otherwise `or`.
    fn settle(&mut self, longest: f64, or: Search) -> Search {
        if longest == 0.0 {
            return or;
        }
        swap(&mut self.short, &mut self.trial);
        Search::Found
    }

    /// Puts the trial at x(a); false if that is no new point.
    fn place_trial(&mut self, a: f64) -> bool {
        let (lower, upper) = (self.bounds.lower(), self.bounds.upper());
        for i in 0..self.step.len() {
            // The target itself, so that a component on its bound is there to the last bit and counts as held.
            self.trial.point[i] = if a == 1.0 {
                self.target[i]
            } else {
                (self.at.point[i] + a * self.step[i]).clamp(lower[i], upper[i])
            };
        }
        // Beyond a = 1 all components may be clamped where they were for the last step: then longer steps change nothing.
        self.trial.point != self.at.point && (a <= 1.0 || self.trial.point != self.short.point)
    }

    /// Whether the trial's value differs from the iterate's by no more than may be the objective's
    /// own error.
    fn is_blurred(&self) -> bool {
        let (before, after) = (self.at.value, self.trial.value);
        let blur = BLUR * before.abs().max(self.ceiling.abs());
        (before - after).abs() <= blur && after - self.lowest <= blur && after <= self.ceiling
    }

    fn evaluate_trial(&mut self) {
        self.evaluations += 1;
        self.trial.gradient.fill(f64::NAN);
        self.trial.value = self.objective.value_and_gradient(&self.trial.point, &mut self.trial.gradient);
    }

    /// gᵀ(x(a) − x), the decrease to first order.
    fn slope_to_trial(&self) -> f64 {
        let moves = self.trial.point.iter().zip(&self.at.point);
        let terms = moves.zip(&self.at.gradient).map(|((t, x), g)| (t - x) * g);
        terms.sum()
    }

    /// The derivative of f(x(a)) at the trial: components held at a bound beyond a = 1 are still.
    fn slope_at_trial(&self, a: f64) -> f64 {
        let mut slope = 0.0;
        for i in 0..self.step.len() {
            let x = self.trial.point[i];
            let held = x == self.bounds.lower()[i] || x == self.bounds.upper()[i];
            if !(held && a >= 1.0) {
                slope += self.trial.gradient[i] * self.step[i];
            }
        }
        slope
    }

    /// The largest `widthᵢ |gᵢ|` over the projected gradient: components whose bound forbids the
    /// descent do not count.
    fn residual(&self, iterate: &Iterate) -> f64 {
        let mut residual = 0.0_f64;
        for i in 0..self.widths.len() {
            let (x, g) = (iterate.point[i], iterate.gradient[i]);
            let blocked =
                (x == self.bounds.lower()[i] && g >= 0.0) || (x == self.bounds.upper()[i] && g <= 0.0);
            if !blocked {
                // f64::max would lose a NaN.
                let size = self.widths[i] * g.abs();
                residual = if size > residual || size.is_nan() { size } else { residual };
            }
        }
        residual
    }

    fn active(&self, i: usize) -> Bound {
        let (x, g) = (self.at.point[i], self.at.gradient[i]);
        if x == self.bounds.lower()[i] && g > 0.0 {
            Bound::Lower
        } else if x == self.bounds.upper()[i] && g < 0.0 {
            Bound::Upper
        } else {
            Bound::Free
        }
    }
}

/// The minimum of the cubic through two points `[a, value, slope]`; where it has none, the middle.
fn cubic_minimum([a0, f0, s0]: [f64; 3], [a1, f1, s1]: [f64; 3]) -> f64 {
    let width = a1 - a0;
    let d1 = s0 + s1 - 3.0 * (f1 - f0) / width;
    let d2 = (d1 * d1 - s0 * s1).sqrt();
    // The root is NaN where the cubic has no minimum.
    let minimum = a1 - width * (s1 + d2 - d1) / (s1 - s0 + 2.0 * d2);
    if minimum.is_finite() { minimum } else { 0.5 * (a0 + a1) }
}
