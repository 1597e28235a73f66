//! Helicoid experiments: surfaces from exact nets (AHT, AT), their figures, and how far they lie from the closed form.

use rayon::prelude::*;
use surfaces::{Mesh, Patch, Pieces, SurfaceError};

use crate::{
    ClosedForm, Done, Family, Figures, MethodError, MethodResult, Progress, Search, Solved, Surface, Warning,
    trust,
};

pub use surfaces::DeformationPath;

/// The generalized helicoid `x = a sinh u cos v − b cosh u sin v`, `y = a sinh u sin v + b cosh u cos v`,
/// `z = a v + b u` over `[0, u_span] × [0, v_span]` (AHT, with the chart of spec §7).
#[derive(Clone, Debug, PartialEq)]
pub struct Helicoid {
    /// Weight of the right helicoid; finite, |a| ≤ 1e30; a and b are not both zero.
    pub a: f64,
    /// Weight of the catenoid; finite, |b| ≤ 1e30.
    pub b: f64,
    /// Length of the u interval, in [1e-6, 100]. May exceed `bases::Aht::SUPREMUM`: then several patches are needed.
    pub u_span: f64,
    /// Length of the v interval, in [1e-6, 1000]. May exceed `bases::Aht::SUPREMUM`: then several patches are needed.
    pub v_span: f64,
    /// The deformation from (a, b) = (1, 0) to (0, 1).
    pub deformation: Option<Deformation>,
}

/// A family of helicoids from (a, b) = (1, 0), the right helicoid, to (0, 1), the catenoid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Deformation {
    /// Number of frames, both ends included, in 2..=1000.
    pub frames: usize,
    /// How (a, b) moves with λ ∈ [0, 1]; [`DeformationPath::Trigonometric`] is an isometric bending.
    pub path: DeformationPath,
}

/// The right helicoid `(w cos v, w sin v, v)` over the trapezium `0 ≤ v ≤ span`,
/// `γ0 + β0 v ≤ w ≤ γ1 + β1 v` (AT, with the corrections of spec §7).
#[derive(Clone, Debug, PartialEq)]
pub struct TrapeziumHelicoid {
    /// Length α of the v interval, in [1e-6, 1000]. May exceed 2π: then several patches are needed.
    pub span: f64,
    /// Offsets (γ0, γ1) of the two sides.
    pub gamma: [f64; 2],
    /// Slopes (β0, β1) of the two sides, which do not cross inside (0, span).
    pub beta: [f64; 2],
    /// Where its control points come from.
    pub construction: Construction,
}

/// How the control points of a helicoid over a trapezium are found; the two ways agree to rounding.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Construction {
    /// From the values and derivatives at the ends (AT (0.2), (0.3), corrected).
    #[default]
    EndpointRule,
    /// By right angles and lengths in the plane, then each point lifted to its height (AT Theorems 1–3).
    Geometric,
}

/// Share of the bound of a basis beyond which control points of a single patch lose digits.
const BESIDE_THE_BOUND: f64 = 0.95;

/// The helicoid (a, b), then the frames of the deformation, if there is one. A surface that fails takes none of the others
/// with it.
pub fn helicoids(plan: &Helicoid, mesh: usize, progress: &dyn Progress) -> Vec<MethodResult> {
    let (u, v) = (plan.u_span, plan.v_span);
    let spans = || -> Vec<Warning> {
        let bound = bases::Aht::SUPREMUM;
        let piece = [surfaces::Helicoid::LARGEST_WHOLE, surfaces::Helicoid::LARGEST_PIECE];
        [("u-span", u), ("v-span", v)]
            .into_iter()
            .filter_map(|(name, span)| span_warning(name, span, bound, piece, "AHT"))
            .collect()
    };
    let exact = || -> Result<Done, MethodError> {
        let helicoid = surfaces::Helicoid::new(plan.a, plan.b, u, v)?;
        let weights = Some(helicoid.weights());
        finish(
            (helicoid.pieces()?, Family::Aht),
            mesh,
            weights,
            |patch| helicoid.deviation(patch, mesh),
            spans(),
        )
    };
    let mut surfaces = vec![result("helicoid".into(), exact())];
    let Some(Deformation { frames, path }) = plan.deformation else { return surfaces };

    let digits = frames.to_string().len();
    let named = |k: usize| format!("frame {:0digits$} of {frames}", k + 1);
    progress.begin("deformation", Some(frames as u64));
    let deformation = surfaces::Deformation::new(path, u, v);
    let frame = |k: usize| -> Result<Done, MethodError> {
        if progress.cancelled() {
            return Err(MethodError::Interrupted);
        }
        let deformation = deformation.as_ref().map_err(SurfaceError::clone)?;
        let lambda = k as f64 / (frames - 1) as f64;
        let closed = deformation.closed_form(lambda)?;
        let (surface, weights) = (deformation.surface(lambda)?, Some(closed.weights()));
        let done =
            finish((surface, Family::Aht), mesh, weights, |patch| closed.deviation(patch, mesh), Vec::new());
        progress.step();
        done
    };
    let done: Vec<_> = (0..frames).into_par_iter().map(frame).collect();
    progress.end();
    surfaces.extend(done.into_iter().enumerate().map(|(k, done)| result(named(k), done)));
    surfaces
}

/// The helicoid over a trapezium.
pub fn trapezium(plan: &TrapeziumHelicoid, mesh: usize) -> MethodResult {
    let exact = || -> Result<Done, MethodError> {
        let helicoid = surfaces::TrapeziumHelicoid::new(plan.span, plan.gamma, plan.beta)?;
        let bound = bases::At::SUPREMUM;
        let piece = [surfaces::TrapeziumHelicoid::LARGEST_WHOLE, surfaces::TrapeziumHelicoid::LARGEST_PIECE];
        let warnings = span_warning("span", plan.span, bound, piece, "AT").into_iter().collect();
        let pieces = match plan.construction {
            Construction::EndpointRule => helicoid.pieces()?,
            Construction::Geometric => helicoid.constructed_pieces()?,
        };
        finish((pieces, Family::At), mesh, None, |patch| helicoid.deviation(patch, mesh), warnings)
    };
    result("trapezium helicoid".into(), exact())
}

fn result(name: String, outcome: Result<Done, MethodError>) -> MethodResult {
    MethodResult { name, outcome: outcome.map(Box::new) }
}

fn finish(
    (pieces, family): (Pieces, Family),
    subdivisions: usize,
    weights: Option<[f64; 2]>,
    deviation: impl Fn(&dyn Patch) -> f64,
    mut warnings: Vec<Warning>,
) -> Result<Done, MethodError> {
    let closed_form = Some(ClosedForm { deviation: deviation(&pieces), weights });
    let mesh = Mesh::of(&pieces, subdivisions);
    let figures = Figures::of(&pieces, &mesh)?;
    let surface = Surface::Pieces(pieces);
    let solved =
        Solved { surface, family, minimised: None, shape: None, solve: None, area: None, search: None };
    warnings.extend(trust::warnings(&solved, &figures, &Search::default()));
    Ok(Done {
        solved,
        mesh,
        figures,
        boundary: None,
        closed_form,
        film: None,
        estimate: None,
        bound: None,
        warnings,
    })
}

/// What is to be said of an interval that one patch holds badly or not at all.
fn span_warning(
    name: &'static str,
    span: f64,
    bound: f64,
    [whole, piece]: [f64; 2],
    basis: &'static str,
) -> Option<Warning> {
    if span > whole {
        return Some(Warning::SpanCut { name, span, pieces: (span / piece).ceil(), bound, basis });
    }
    (span > BESIDE_THE_BOUND * bound).then_some(Warning::SpanNearBound { name, span, bound, basis })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spans_are_warned_about_close_to_the_bound_and_beyond() {
        let warning = |span| span_warning("v-span", span, 10.0, [9.9, 9.0], "AHT");
        assert_eq!(warning(9.5), None);
        let says = |span: f64, words: &str| {
            let text = warning(span).unwrap().to_string();
            assert!(text.contains(words), "{text}");
        };
        says(9.6, "within 4.0 % of the bound");
        says(10.0, "2 equal parts: one patch holds spans below 10");
        says(27.5, "4 equal parts");
    }
}
