//! The minimum of a strictly convex quadratic in a box: the step of the polish.

use crate::bounds::Bounds;
use crate::hessian::{Hessian, dot};

#[derive(Clone, Copy, PartialEq)]
enum State {
    Free,
    Lower,
    Upper,
}

/// Workspace of the primal active set method for `min gᵀd + ½ dᵀB d`, `lower ≤ x + d ≤ upper`.
pub(crate) struct BoxModel {
    state: Vec<State>,
    free: Vec<usize>,
    step: Vec<f64>,
    /// Lower triangle of the Cholesky factor of the free submatrix, row-major, |free| × |free|.
    factor: Vec<f64>,
    /// The unconstrained minimum over the free components.
    wish: Vec<f64>,
}

impl BoxModel {
    pub(crate) fn new(dimension: usize) -> Self {
        Self {
            state: vec![State::Free; dimension],
            free: Vec::with_capacity(dimension),
            step: vec![0.0; dimension],
            factor: vec![0.0; dimension * dimension],
            wish: vec![0.0; dimension],
        }
    }

    /// Puts into `target` the model's minimum over the box: `x + d`, at a bound exactly where it
    /// ends at one. Returns false if B is not positive definite in rounding.
    ///
    /// Every pass lowers the model or adds a bound, so even a stop at the pass limit leaves a
    /// direction of descent.
    pub(crate) fn minimize(
        &mut self,
        hessian: &Hessian,
        gradient: &[f64],
        point: &[f64],
        bounds: &Bounds,
        target: &mut [f64],
    ) -> bool {
        let n = point.len();
        let (lower, upper) = (bounds.lower(), bounds.upper());
        self.step.fill(0.0);
        for i in 0..n {
            self.state[i] = if point[i] == lower[i] && gradient[i] > 0.0 {
                State::Lower
            } else if point[i] == upper[i] && gradient[i] < 0.0 {
                State::Upper
            } else {
                State::Free
            };
        }
        for _ in 0..4 * n + 8 {
            if !self.solve_free(hessian, gradient) {
                return false;
            }
            match self.blocking(point, bounds) {
                Some((i, side, fraction)) => {
                    self.go_towards_wish(fraction);
                    self.state[i] = side;
                    self.step[i] = match side {
                        State::Lower => lower[i] - point[i],
                        State::Upper => upper[i] - point[i],
                        // What blocks is a bound.
                        State::Free => self.step[i],
                    };
                }
                None => {
                    self.go_towards_wish(1.0);
                    match self.wrong_multiplier(hessian, gradient) {
                        Some(i) => self.state[i] = State::Free,
                        None => break,
                    }
                }
            }
        }
        for i in 0..n {
            target[i] = match self.state[i] {
                State::Lower => lower[i],
                State::Upper => upper[i],
                State::Free => (point[i] + self.step[i]).clamp(lower[i], upper[i]),
            };
        }
        true
    }

    /// `B_FF wish_F = −(g_F + B_FA d_A)` by Cholesky, F the free and A the fixed components.
    fn solve_free(&mut self, hessian: &Hessian, gradient: &[f64]) -> bool {
        let n = gradient.len();
        self.free.clear();
        self.free.extend((0..n).filter(|&i| self.state[i] == State::Free));
        let m = self.free.len();
        for (a, &i) in self.free.iter().enumerate() {
            let row = hessian.row(i);
            for (b, &j) in self.free[..=a].iter().enumerate() {
                let mut sum = row[j];
                for k in 0..b {
                    sum -= self.factor[a * m + k] * self.factor[b * m + k];
                }
                if b < a {
                    self.factor[a * m + b] = sum / self.factor[b * m + b];
                } else if sum > 0.0 && sum.is_finite() {
                    self.factor[a * m + a] = sum.sqrt();
                } else {
                    return false;
                }
            }
            let mut rhs = -gradient[i];
            for j in 0..n {
                if self.state[j] != State::Free {
                    rhs -= row[j] * self.step[j];
                }
            }
            for k in 0..a {
                rhs -= self.factor[a * m + k] * self.wish[k];
            }
            self.wish[a] = rhs / self.factor[a * m + a];
        }
        for a in (0..m).rev() {
            let mut sum = self.wish[a];
            for k in a + 1..m {
                sum -= self.factor[k * m + a] * self.wish[k];
            }
            self.wish[a] = sum / self.factor[a * m + a];
        }
        true
    }

    /// The first bound met on the way from the step to the wish, and the fraction of the way.
    fn blocking(&self, point: &[f64], bounds: &Bounds) -> Option<(usize, State, f64)> {
        let mut first = None;
        let mut least = 1.0;
        for (&i, &wish) in self.free.iter().zip(&self.wish) {
            let way = wish - self.step[i];
            let (side, room) = if way < 0.0 {
                (State::Lower, bounds.lower()[i] - point[i] - self.step[i])
            } else {
                (State::Upper, bounds.upper()[i] - point[i] - self.step[i])
            };
            if room.abs() < least * way.abs() {
                least = room / way;
                first = Some((i, side, least));
            }
        }
        first
    }

    fn go_towards_wish(&mut self, fraction: f64) {
        for (&i, &wish) in self.free.iter().zip(&self.wish) {
            if fraction == 1.0 {
                self.step[i] = wish;
            } else {
                self.step[i] += fraction * (wish - self.step[i]);
            }
        }
    }

    /// The fixed component whose multiplier `(g + B d)ᵢ` most pulls it off its bound.
    fn wrong_multiplier(&self, hessian: &Hessian, gradient: &[f64]) -> Option<usize> {
        let mut worst = None;
        let mut most = 0.0;
        for i in 0..gradient.len() {
            let multiplier = gradient[i] + dot(hessian.row(i), &self.step);
            let pull = match self.state[i] {
                State::Free => 0.0,
                State::Lower => -multiplier,
                State::Upper => multiplier,
            };
            if pull > most {
                (worst, most) = (Some(i), pull);
            }
        }
        worst
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(512))]

        /// One call finds the minimum: free components have no slope, multipliers their signs.
        #[test]
        fn the_model_is_minimised_over_the_box(
            (n, pairs, gradient, start) in (1..7_usize).prop_flat_map(|n| (
                Just(n),
                prop::collection::vec((-1.0..1.0_f64, 0.3..3.0_f64), n * n),
                prop::collection::vec(-2.0..2.0_f64, n),
                prop::collection::vec(prop_oneof![Just(0.0), Just(1.0), 0.0..1.0_f64], n),
            )),
        ) {
            let bounds = Bounds::cube(n, 0.0, 1.0).expect("a cube");
            let mut hessian = Hessian::new(n);
            hessian.reset(1.0, &vec![1.0; n]);
            for row in pairs.chunks_exact(n) {
                // y = diag(p) s with p > 0 has positive curvature along s.
                let s: Vec<f64> = row.iter().map(|p| p.0).collect();
                let y: Vec<f64> = row.iter().map(|p| p.0 * p.1).collect();
                hessian.update(&s, &y, false);
            }
            let mut model = BoxModel::new(n);
            let mut target = vec![f64::NAN; n];
            prop_assert!(model.minimize(&hessian, &gradient, &start, &bounds, &mut target));
            let step: Vec<f64> = target.iter().zip(&start).map(|(t, x)| t - x).collect();
            for i in 0..n {
                let slope = gradient[i] + dot(hessian.row(i), &step);
                let size: f64 = hessian.row(i).iter().map(|b| b.abs()).sum();
                prop_assert!((0.0..=1.0).contains(&target[i]));
                prop_assert!(target[i] == 0.0 || slope <= 1e-10 * (1.0 + size));
                prop_assert!(target[i] == 1.0 || slope >= -1e-10 * (1.0 + size));
            }
        }
    }
}
