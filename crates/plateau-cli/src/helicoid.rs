//! Helicoid experiments: surfaces from exact nets (AHT, AT), their figures, and how far they lie from the closed form.

use rayon::prelude::*;
use surfaces::{Mesh, Patch, Pieces, SurfaceError};

use crate::run::{Done, MethodResult};
use crate::{
    ClosedForm, Expected, Family, Figures, Helicoid, MethodError, Progress, Quantity, Solved, Surface,
    TrapeziumHelicoid,
};

/// Share of the bound of a basis beyond which control points of a single patch lose digits.
const BESIDE_THE_BOUND: f64 = 0.95;

/// The helicoid (a, b), then the frames of the deformation, if there is one. A surface that fails takes none of the others
/// with it.
pub(crate) fn helicoids(plan: &Helicoid, mesh: usize, progress: &dyn Progress) -> Vec<MethodResult> {
    let (u, v) = (plan.u_span, plan.v_span);
    let spans = || -> Vec<String> {
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
    let mut surfaces = vec![result("helicoid".into(), exact(), plan.expect.clone())];
    let Some(crate::Deformation { frames, path }) = plan.deformation else { return surfaces };

    let shared: Vec<Expected> = plan.expect.iter().filter(|e| is_shared(e.quantity)).cloned().collect();
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
    surfaces.extend(done.into_iter().enumerate().map(|(k, done)| result(named(k), done, shared.clone())));
    surfaces
}

/// The helicoid over a trapezium.
pub(crate) fn trapezium(plan: &TrapeziumHelicoid, mesh: usize) -> MethodResult {
    let exact = || -> Result<Done, MethodError> {
        let helicoid = surfaces::TrapeziumHelicoid::new(plan.span, plan.gamma, plan.beta)?;
        let bound = bases::At::SUPREMUM;
        let piece = [surfaces::TrapeziumHelicoid::LARGEST_WHOLE, surfaces::TrapeziumHelicoid::LARGEST_PIECE];
        let warnings = span_warning("span", plan.span, bound, piece, "AT").into_iter().collect();
        finish(
            (helicoid.pieces()?, Family::At),
            mesh,
            None,
            |patch| helicoid.deviation(patch, mesh),
            warnings,
        )
    };
    result("trapezium helicoid".into(), exact(), plan.expect.clone())
}

/// Whether a figure is the same for all surfaces of a deformation: then it is expected of every frame.
fn is_shared(quantity: Quantity) -> bool {
    matches!(
        quantity,
        Quantity::Deviation
            | Quantity::ConformalityGap
            | Quantity::MeanCurvatureMax
            | Quantity::MeanCurvatureRms
    )
}

fn result(name: String, outcome: Result<Done, MethodError>, expect: Vec<Expected>) -> MethodResult {
    MethodResult { name, outcome: outcome.map(Box::new), expect, published: Vec::new() }
}

fn finish(
    (pieces, family): (Pieces, Family),
    subdivisions: usize,
    weights: Option<[f64; 2]>,
    deviation: impl Fn(&dyn Patch) -> f64,
    mut warnings: Vec<String>,
) -> Result<Done, MethodError> {
    let closed_form = Some(ClosedForm { deviation: deviation(&pieces), weights });
    let mesh = Mesh::of(&pieces, subdivisions);
    let figures = Figures::of(&pieces, &mesh)?;
    let surface = Surface::Pieces(pieces);
    let solved = Solved { surface, family, shape: None, solve: None, area: None, search: None };
    warnings.extend(crate::report::warnings(&solved, &figures, &crate::Search::default()));
    Ok(Done { solved, mesh, figures, boundary: None, closed_form, warnings })
}

/// What is to be said of an interval that one patch holds badly or not at all.
fn span_warning(name: &str, span: f64, bound: f64, [whole, piece]: [f64; 2], basis: &str) -> Option<String> {
    if span > whole {
        let count = (span / piece).ceil();
        return Some(format!(
            "{name} = {span} is cut into {count} equal parts: one patch holds spans below {bound:.4}, the bound of the {basis} basis"
        ));
    }
    let share = 100.0 * (1.0 - span / bound);
    (span > BESIDE_THE_BOUND * bound).then(|| {
        format!(
            "{name} = {span} lies within {share:.1} % of the bound {bound:.4} of the {basis} basis: the control points grow \
             and lose digits"
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spans_are_warned_about_close_to_the_bound_and_beyond() {
        let warning = |span| span_warning("v-span", span, 10.0, [9.9, 9.0], "AHT");
        assert_eq!(warning(9.5), None);
        let says = |span: f64, words: &str| {
            let text = warning(span).unwrap();
            assert!(text.contains(words), "{text}");
        };
        says(9.6, "within 4.0 % of the bound");
        says(10.0, "2 equal parts: one patch holds spans below 10");
        says(27.5, "4 equal parts");
    }
}
