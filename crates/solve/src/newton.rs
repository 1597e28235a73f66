//! Newton's method for the minimum of a smooth function, globalised by a trust region.

use std::collections::VecDeque;
use std::ops::ControlFlow;

use crate::memory::{copy, zeros};
use crate::trust_region::TrustRegion;
use crate::{Place, SolveError, check};

/// A function of n unknowns with first and second derivatives.
pub trait SmoothFunction {
    /// Number of unknowns n.
    fn unknowns(&self) -> usize;

    /// The value at `x`; fills `gradient` (n). A value that is not finite says that the function is not defined
    /// (differentiable) at `x`: steps to such points are rejected.
    fn value_and_gradient(&mut self, x: &[f64], gradient: &mut [f64]) -> f64;

    /// Fills `hessian` (n², symmetric) with the second derivatives at `x`, a point where the value was finite.
    fn hessian(&mut self, x: &[f64], hessian: &mut [f64]);

    /// Called after every step tried, with the point reached so far; [`ControlFlow::Break`] ends the iteration there.
    fn watch(&mut self, _reached: &NewtonReport) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}

/// When to stop, how far to trust.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NewtonParams {
    /// The gradient norm that counts as 0.
    pub gradient_tolerance: f64,
    /// Radius of the first trust region, > 0: a distance over which the function is roughly quadratic.
    pub radius: f64,
    /// Curvature, relative to the largest of a coordinate, below which a direction counts as flat: it is added to every
    /// curvature of a step, so that steps along directions without curvature follow the gradient instead of dividing
    /// rounding by rounding; a stationary point whose curvatures are all above minus that is a minimum.
    pub flat: f64,
    /// The decrease over the last `patience` steps, relative to the value, that counts as none.
    pub value_tolerance: f64,
    /// Steps over which the value has to decrease, ≥ 1: more of them cross longer plateaus.
    pub patience: usize,
    /// Largest number of steps tried.
    pub iterations: usize,
}

impl NewtonParams {
    /// Tolerance and radius as given, curvatures below 10⁻¹¹ flat, decreases below 10⁻¹¹ over 8 steps none, at most 200
    /// steps.
    pub fn new(gradient_tolerance: f64, radius: f64) -> Self {
        Self { gradient_tolerance, radius, flat: 1e-11, value_tolerance: 1e-11, patience: 8, iterations: 200 }
    }
}

/// Why Newton's method ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum NewtonEnd {
    /// The gradient is at most the tolerance and no curvature is negative: a minimum to working precision.
    Minimum,
    /// The gradient is above the tolerance, but the last steps hardly decreased the value: what remains are directions
    /// along which it is all but constant.
    Flat,
    /// The gradient is above the tolerance, but no step decreases the value or the gradient any more: what remains is
    /// rounding, or the function is not smooth here.
    NoDecrease,
    /// All steps allowed were made.
    Budget,
    /// The function asked to stop.
    Stopped,
    /// The function is not finite at the start.
    NotFinite,
}

/// Where Newton's method ended and how it came there.
#[derive(Debug, Clone, PartialEq)]
pub struct NewtonReport {
    /// The point reached.
    pub x: Vec<f64>,
    /// The value there.
    pub value: f64,
    /// The Euclidean norm of the gradient there.
    pub gradient_norm: f64,
    /// The Hessian there, n²: its smallest eigenvalue says how stable a minimum is. Empty if the start was not finite.
    pub hessian: Vec<f64>,
    /// Steps tried, taken or not.
    pub iterations: usize,
    /// Evaluations of value and gradient.
    pub evaluations: usize,
    /// Evaluations of the Hessian.
    pub hessians: usize,
    /// Why it ended.
    pub end: NewtonEnd,
}

/// Steps whose predicted decrease is below this multiple of ε times the value are judged by the gradient: the value is
/// rounding there.
const BLUR: f64 = 64.0 * f64::EPSILON;

/// After a step that missed most of the decrease it promised: how many corrections bring it back to the floor of the
/// valley that the function is flat along, and the curvature, relative to the largest of a coordinate, that tells its
/// sides from its floor.
const CORRECTIONS: usize = 4;
const SIDES: f64 = 0.02;

/// Decrease over predicted decrease below which a step is not taken.
const ACCEPTED: f64 = 1e-4;

/// Smallest trust region, relative to the first.
const SMALLEST_REGION: f64 = 1e-14;

/// A local minimum of `function`, reached from `start` by trust-region steps (Moré and Sorensen; Conn, Gould and Toint,
/// *Trust-Region Methods*, algorithm 6.1.1): each minimises the quadratic model within a ball whose radius follows how well
/// the last ones predicted, so that indefinite and singular Hessians are as good as any. The value never increases
/// beyond rounding; a saddle point is left along its negative curvature; convergence is quadratic in all
/// directions that are not flat. A step that leaves the floor of a curved valley is corrected across it before it is judged,
/// which lets steps along the floor be several times as long. O(n³) a step.
///
/// ```
/// use solve::{NewtonEnd, NewtonParams, SmoothFunction, newton};
///
/// /// A circular valley of which every point is a minimum.
/// struct Valley;
/// impl SmoothFunction for Valley {
///     fn unknowns(&self) -> usize {
///         2
///     }
///     fn value_and_gradient(&mut self, x: &[f64], g: &mut [f64]) -> f64 {
///         let r = x[0] * x[0] + x[1] * x[1] - 1.0;
///         (0..2).for_each(|k| g[k] = r * x[k]);
///         0.25 * r * r
///     }
///     fn hessian(&mut self, x: &[f64], h: &mut [f64]) {
///         let r = x[0] * x[0] + x[1] * x[1] - 1.0;
///         (0..4).for_each(|k| h[k] = 2.0 * x[k / 2] * x[k % 2] + if k % 3 == 0 { r } else { 0.0 });
///     }
/// }
/// // The start is a maximum: no gradient, negative curvature only.
/// let report = newton(&mut Valley, &[0.0, 0.0], NewtonParams::new(1e-12, 0.5))?;
/// assert_eq!(report.end, NewtonEnd::Minimum);
/// assert!(report.value < 1e-24 && report.iterations < 20);
/// # Ok::<(), solve::SolveError>(())
/// ```
///
/// # Errors
/// [`SolveError::WrongShape`] if `start` does not hold n numbers, [`SolveError::NotFinite`] if it, a gradient or a
/// Hessian does not hold finite ones where the value is finite, [`SolveError::TooLarge`],
/// [`SolveError::OutOfMemory`].
pub fn newton(
    function: &mut dyn SmoothFunction,
    start: &[f64],
    params: NewtonParams,
) -> Result<NewtonReport, SolveError> {
    let n = function.unknowns();
    check::limit("number of unknowns", n, check::LARGEST_DENSE_ORDER)?;
    check::length("length of the start", n, start.len())?;
    check::finite(Place::Solution, 1, start)?;
    let (mut gradient, mut next, mut corrected) = (zeros(n)?, Trial::new(n)?, Trial::new(n)?);
    let value = function.value_and_gradient(start, &mut gradient);
    let mut report = NewtonReport {
        x: copy(start)?,
        value,
        gradient_norm: norm(&gradient),
        hessian: Vec::new(),
        iterations: 0,
        evaluations: 1,
        hessians: 0,
        end: NewtonEnd::NotFinite,
    };
    if !value.is_finite() {
        return Ok(report);
    }
    check::finite(Place::RightHandSide, 1, &gradient)?;
    report.hessian = zeros(check::product("size of the Hessian", n, n)?)?;
    let mut region = TrustRegion::new(n)?;
    let (mut radius, mut changed) = (params.radius, true);
    let mut values = VecDeque::new();
    loop {
        if changed {
            function.hessian(&report.x, &mut report.hessian);
            report.hessians += 1;
            check::finite(Place::Matrix, n.max(1), &report.hessian)?;
            region.begin(&report.hessian, params.flat);
        }
        let stationary = report.gradient_norm <= params.gradient_tolerance;
        if stationary && region.is_minimum() {
            report.end = NewtonEnd::Minimum;
            return Ok(report);
        }
        if report.iterations >= params.iterations {
            report.end = NewtonEnd::Budget;
            return Ok(report);
        }
        let step = region.step(&gradient, radius);
        report.iterations += 1;
        let (promised, length) = (step.decrease, norm(step.change));
        next.x.iter_mut().zip(&report.x).zip(step.change).for_each(|((next, x), d)| *next = x + d);
        next.evaluate(function);
        report.evaluations += 1;
        // Moving along a curved valley leaves its floor: what a step costs by that, steps across the valley regain.
        for _ in 0..CORRECTIONS {
            if !next.is_defined() || report.value - next.value > 0.9 * promised {
                break;
            }
            let Some(change) = region.correction(&next.gradient, SIDES) else { break };
            corrected.x.iter_mut().zip(&next.x).zip(change).for_each(|((to, x), d)| *to = x + d);
            corrected.evaluate(function);
            report.evaluations += 1;
            if !corrected.is_defined() || corrected.value >= next.value {
                break;
            }
            let gained = next.value - corrected.value;
            std::mem::swap(&mut next, &mut corrected);
            if gained < 0.1 * (report.value - next.value).abs().max(0.1 * promised) {
                break;
            }
        }
        let (decrease, blur) = (report.value - next.value, BLUR * report.value.abs());
        let blurred = promised <= blur;
        let quality = if !next.is_defined() {
            -1.0
        } else if !blurred {
            decrease / promised
        } else if decrease >= -blur && next.norm() < report.gradient_norm {
            1.0
        } else {
            -1.0
        };
        changed = quality > ACCEPTED;
        if changed {
            std::mem::swap(&mut report.x, &mut next.x);
            std::mem::swap(&mut gradient, &mut next.gradient);
            (report.value, report.gradient_norm) = (next.value, norm(&gradient));
        }
        if quality > 0.75 {
            radius = radius.max(2.5 * length);
        } else if quality < 0.25 {
            radius = if quality < 0.0 { 0.25 } else { 0.5 } * length.min(radius);
        }
        if function.watch(&report).is_break() {
            report.end = NewtonEnd::Stopped;
            return Ok(report);
        }
        values.push_back(report.value);
        let idle = values.len() > params.patience
            && values
                .pop_front()
                .is_some_and(|v| v - report.value <= params.value_tolerance * report.value.abs());
        let stuck = (blurred && !changed && next.is_defined()) || radius <= SMALLEST_REGION * params.radius;
        if stuck || idle {
            report.end = if stuck { NewtonEnd::NoDecrease } else { NewtonEnd::Flat };
            break;
        }
    }
    // The value is at rest; across the valley the gradient need not be.
    while report.gradient_norm > params.gradient_tolerance {
        let Some(change) = region.correction(&gradient, SIDES) else { break };
        next.x.iter_mut().zip(&report.x).zip(change).for_each(|((to, x), d)| *to = x + d);
        next.evaluate(function);
        report.evaluations += 1;
        let risen = next.value - report.value > BLUR * report.value.abs();
        if !next.is_defined() || risen || next.norm() > 0.8 * report.gradient_norm {
            break;
        }
        std::mem::swap(&mut report.x, &mut next.x);
        std::mem::swap(&mut gradient, &mut next.gradient);
        (report.value, report.gradient_norm) = (next.value, norm(&gradient));
    }
    function.hessian(&report.x, &mut report.hessian);
    report.hessians += 1;
    check::finite(Place::Matrix, n.max(1), &report.hessian)?;
    region.begin(&report.hessian, params.flat);
    if report.gradient_norm <= params.gradient_tolerance && region.is_minimum() {
        report.end = NewtonEnd::Minimum;
    }
    Ok(report)
}

/// A point with the value and the gradient there.
struct Trial {
    x: Vec<f64>,
    value: f64,
    gradient: Vec<f64>,
}

impl Trial {
    fn new(n: usize) -> Result<Self, SolveError> {
        Ok(Self { x: zeros(n)?, value: f64::NAN, gradient: zeros(n)? })
    }

    fn evaluate(&mut self, function: &mut dyn SmoothFunction) {
        self.value = function.value_and_gradient(&self.x, &mut self.gradient);
    }

    fn is_defined(&self) -> bool {
        self.value.is_finite() && self.gradient.iter().all(|g| g.is_finite())
    }

    fn norm(&self) -> f64 {
        norm(&self.gradient)
    }
}

fn norm(x: &[f64]) -> f64 {
    x.iter().map(|a| a * a).sum::<f64>().sqrt()
}
