//! What a reader must know before trusting a figure.

use solve::NewtonEnd;

use crate::{Figures, Search, Solved};

/// Why a search for the least area ended, as a sentence.
pub(crate) fn newton_end(end: NewtonEnd) -> &'static str {
    match end {
        NewtonEnd::Minimum => "the gradient vanishes and no curvature is negative",
        NewtonEnd::Flat => "the area is all but constant along what remains of the gradient",
        NewtonEnd::NoDecrease => "no step decreases the area any more",
        NewtonEnd::Budget => "all steps allowed were made",
        NewtonEnd::Stopped => "it was stopped",
        NewtonEnd::NotFinite => "the area is not finite at the start",
        _ => "the iteration ended",
    }
}

/// Condition beyond which the last digits printed are no longer certain.
const ILL_CONDITIONED: f64 = 1e10;

/// Share of the size lost to the cancellation of control points beyond which it is said.
const CANCELLING: f64 = 1e-11;

/// The warnings of one method.
pub(crate) fn warnings(solved: &Solved, figures: &Figures, search: &Search) -> Vec<String> {
    let mut warnings = Vec::new();
    if let Some(outcome) = &solved.search {
        let names = ["α1", "α2", "β1", "β2"];
        let width = search.upper - search.lower;
        let at = |wall: f64| -> Vec<&str> {
            let near = |x: &f64| (x - wall).abs() <= 1e-9 * width;
            (0..4).filter(|&k| near(&outcome.shape[k])).map(|k| names[k]).collect()
        };
        let (low, high) = (at(search.lower), at(search.upper));
        for (wall, bound) in [(low, search.lower), (high, search.upper)] {
            if !wall.is_empty() {
                warnings.push(format!(
                    "the search box binds: {} at {bound}; a wider box may hold a lower minimum",
                    wall.join(", ")
                ));
            }
        }
        let failed = outcome.runs.iter().filter(|run| run.polish.is_some() && !run.is_stationary()).count();
        if failed > 0 {
            warnings
                .push(format!("{failed} of {} runs did not end at a stationary point", outcome.runs.len()));
        }
        let budget = outcome.runs.iter().filter(|run| run.stopped_on_budget()).count();
        if budget > 0 {
            let runs = outcome.runs.len();
            let spread = match outcome.spread() {
                _ if runs == 1 => String::new(),
                0.0 => "; their best values are equal".to_owned(),
                spread => format!("; their best values spread by {spread:.1e}"),
            };
            warnings
                .push(format!("{budget} of {runs} runs stopped on budget, which is not convergence{spread}"));
        }
        if outcome.nan_evaluations > 0 {
            warnings.push(format!(
                "{} of {} evaluations of the search failed and were passed over",
                outcome.nan_evaluations, outcome.evaluations
            ));
        }
    }
    if let Some(solve) = &solved.solve {
        let condition = solve.condition.max(solve.basis_condition.unwrap_or(0.0));
        if condition > ILL_CONDITIONED {
            warnings.push(format!(
                "the control points are ill-conditioned (about {condition:.0e}): they lose digits, the surface fewer"
            ));
        }
        if solve.residual > 30.0 {
            warnings.push(format!(
                "the linear solve left a residual of {:.0} (30 is LAPACK's threshold of failure)",
                solve.residual
            ));
        }
    }
    let cancellation = solved.surface.cancellation();
    if cancellation > CANCELLING {
        warnings.push(format!(
            "the control points reach {:.0e} times as far out as the boundary: the surface is what their differences leave, and \
             is certain to about {cancellation:.0e} of its size",
            cancellation / f64::EPSILON
        ));
    }
    if let Some(found) = &solved.area {
        if matches!(found.end, NewtonEnd::Budget | NewtonEnd::NoDecrease | NewtonEnd::NotFinite) {
            warnings.push(format!(
                "the least area was not reached: {} after {} steps, gradient {:.1e} of the root of the area",
                newton_end(found.end),
                found.iterations,
                found.gradient
            ));
        }
        if !found.area.settled {
            warnings.push(format!(
                "the search for the least area ended on a rule of {0}² points that does not integrate it (± {1:.1e}): the net \
                 nearly folds, and its gradient is {2:.1e} of the root of the area",
                found.area.points, found.area.error, found.gradient
            ));
        }
        if found.second_variation.is_some_and(|smallest| smallest < 0.0) {
            warnings.push(
                "the surface is not a stable minimum: its second variation is negative along the normal; another \
                 surface over the same boundary has less area"
                    .to_owned(),
            );
        }
    }
    warnings.extend(of_figures(figures));
    warnings
}

/// What is uncertain about the figures of a patch, and why some are left out.
pub(crate) fn of_figures(figures: &Figures) -> Vec<String> {
    let mut warnings = Vec::new();
    let area = &figures.area;
    let Some(square) = figures.mean_curvature_square else {
        return vec![format!(
            "the patch has no area beyond rounding ({:.1e}): (D − A)/A and the mean curvature are left out",
            area.value
        )];
    };
    if !area.settled {
        warnings.push(format!(
            "the area has not settled: {} ± {:.1e} after {}² quadrature points; the patch folds or is singular somewhere",
            digits(area.value),
            area.error,
            area.points
        ));
    }
    if figures.mean_curvature_max.is_none() {
        warnings
            .push("the patch is singular at every vertex of its mesh: no mean curvature is given".to_owned());
    }
    if figures.mean_curvature_rms.is_none() {
        warnings.push(format!(
            "the root mean square of H is left out: ∫H² dA has not settled ({:.3e} ± {:.0e} after {}² quadrature points); the \
             patch is singular somewhere, or nearly, and the largest |H| depends on the mesh",
            square.value, square.error, square.points
        ));
    }
    warnings
}

/// A number with all its digits, in the form that is shorter.
fn digits(x: f64) -> String {
    if (1e-5..1e15).contains(&x.abs()) { x.to_string() } else { format!("{x:e}") }
}
