//! What a reader must know before trusting a figure.

use crate::{
    AreaEnd, AreaExtremal, Figures, Search, SearchOutcome, SolveFigures, Solved, ValleyEnd, Warning,
};

/// Condition beyond which the last digits printed are no longer certain.
const ILL_CONDITIONED: f64 = 1e10;

/// Residual that LAPACK's tests call a failure.
const FAILED: f64 = 30.0;

/// Share of the size lost to the cancellation of control points beyond which it is said.
const CANCELLING: f64 = 1e-11;

/// Share of the width of a search box within which a shape lies on its wall.
const ON_THE_WALL: f64 = 1e-9;

/// The warnings of one method.
pub(crate) fn warnings(solved: &Solved, figures: &Figures, search: &Search) -> Vec<Warning> {
    let mut warnings = Vec::new();
    if let Some(outcome) = solved.search() {
        of_search(outcome, solved.family().parameters(), search, &mut warnings);
    }
    if let Some(solve) = solved.solve() {
        of_solve(solve, &mut warnings);
        if let Some(share) = solve.left_out.filter(|share| *share > CANCELLING) {
            warnings.push(Warning::LeftOut { share });
        }
    }
    let share = solved.surface().cancellation();
    if share > CANCELLING {
        warnings.push(Warning::Cancellation { share });
    }
    if let Some(found) = solved.area() {
        of_least_area(found, &mut warnings);
    }
    of_figures(figures, &mut warnings);
    warnings
}

/// The warnings of a surface of several patches.
pub(crate) fn of_film(extremal: Option<&AreaExtremal>, figures: &Figures, warnings: &mut Vec<Warning>) {
    if let Some(found) = extremal {
        of_least_area(found, warnings);
    }
    of_figures(figures, warnings);
}

fn of_search(outcome: &SearchOutcome, names: &[&'static str], search: &Search, warnings: &mut Vec<Warning>) {
    let [lower, upper] = search.bounds();
    for bound in [lower, upper] {
        let parameters: Vec<&str> = names
            .iter()
            .copied()
            .zip(outcome.shape())
            .filter(|(_, x)| (*x - bound).abs() <= ON_THE_WALL * (upper - lower))
            .map(|(name, _)| name)
            .collect();
        if !parameters.is_empty() {
            warnings.push(Warning::BoxBinds { parameters, bound });
        }
    }
    let of = outcome.runs().len();
    let runs = outcome.runs().iter().filter(|run| run.polish().is_some() && !run.is_stationary()).count();
    if runs > 0 {
        warnings.push(Warning::NotStationary { runs, of });
    }
    let runs = outcome.runs().iter().filter(|run| run.on_budget()).count();
    if runs > 0 {
        warnings.push(Warning::Budget { runs, of, spread: outcome.spread() });
    }
    if outcome.nan_evaluations() > 0 {
        let (failed, of) = (outcome.nan_evaluations(), outcome.evaluations());
        warnings.push(Warning::FailedEvaluations { failed, of });
    }
}

fn of_solve(solve: &SolveFigures, warnings: &mut Vec<Warning>) {
    let condition = solve.condition.max(solve.basis_condition.unwrap_or(0.0));
    if condition > ILL_CONDITIONED {
        warnings.push(Warning::IllConditioned { condition });
    }
    if let Some(metric) = solve.metric.filter(|metric| !metric.settled) {
        warnings.push(Warning::MetricUnsettled { points: metric.points, error: metric.error });
    }
    if solve.residual > FAILED {
        warnings.push(Warning::Residual { residual: solve.residual });
    }
}

fn of_least_area(found: &AreaExtremal, warnings: &mut Vec<Warning>) {
    if found.end != AreaEnd::Stationary {
        warnings.push(Warning::AreaNotReached { end: found.end, gradient: found.gradient });
    }
    if !found.area.settled {
        let (points, error, gradient) = (found.area.points, found.area.error, found.gradient);
        warnings.push(Warning::AreaRule { points, error, gradient });
    }
    if found.valley == ValleyEnd::Far {
        warnings.push(Warning::FarNet);
    }
    if let Some(displacement) = found.displacement.filter(|displacement| !displacement.has_converged()) {
        warnings.push(Warning::Displaced(displacement));
    }
    if found.second_variation.is_some_and(|smallest| smallest < 0.0) {
        warnings.push(Warning::Unstable);
    }
}

/// What is uncertain about the figures of a patch, and why some are left out.
fn of_figures(figures: &Figures, warnings: &mut Vec<Warning>) {
    let area = &figures.area;
    let Some(square) = figures.mean_curvature_square else {
        warnings.push(Warning::NoArea { area: area.value });
        return;
    };
    if !area.settled {
        let (value, error, points) = (area.value, area.error, area.points);
        warnings.push(Warning::AreaUnsettled { area: value, error, points });
    }
    if figures.mean_curvature_max.is_none() {
        warnings.push(Warning::SingularMesh);
    }
    if figures.mean_curvature_rms.is_none() {
        let (value, error, points) = (square.value, square.error, square.points);
        warnings.push(Warning::CurvatureUnsettled { square: value, error, points });
    }
}
