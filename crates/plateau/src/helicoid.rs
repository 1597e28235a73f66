//! Helicoid experiments: surfaces from exact nets (AHT, AT), their figures, and how far they lie from the closed form.

use rayon::prelude::*;
use surfaces::{Deformation, Mesh, Patch, Pieces, SurfaceError, TrapeziumHelicoid};

use crate::{
    ClosedForm, Done, Family, Figures, MethodError, MethodResult, Progress, Search, Solved, Surface, Warning,
    trust,
};

pub use surfaces::DeformationPath;

/// A helicoid, and the frames of the deformation that it may be shown with.
///
/// ```
/// use plateau::{DeformationPath, Helicoid, helicoids};
/// let catenoid = Helicoid::new(surfaces::Helicoid::new(0.0, 1.0, 1.5, 6.0)?);
/// let bent = catenoid.deformed(5, DeformationPath::Trigonometric)?;
/// assert_eq!(helicoids(&bent, 16, &()).len(), 6);
/// # Ok::<(), surfaces::SurfaceError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Helicoid {
    form: surfaces::Helicoid,
    frames: Option<(usize, Deformation)>,
}

/// Equal helicoids with as many frames on the same path: what is made of them is equal.
impl PartialEq for Helicoid {
    fn eq(&self, other: &Self) -> bool {
        let [ours, theirs] =
            [self, other].map(|it| (it.form, it.frames(), it.deformation().map(Deformation::path)));
        ours == theirs
    }
}

impl Helicoid {
    /// Most frames of a deformation.
    pub const MOST_FRAMES: usize = 1000;

    /// The helicoid alone. Where a span exceeds `bases::Aht::SUPREMUM`, it is cut into several patches.
    #[must_use]
    pub fn new(form: surfaces::Helicoid) -> Self {
        Self { form, frames: None }
    }

    /// With so many frames, 2 to [`Self::MOST_FRAMES`], of the deformation from (a, b) = (1, 0), the right helicoid, to (0, 1), the
    /// catenoid, both ends included; [`DeformationPath::Trigonometric`] is an isometric bending. Others are taken for the nearest.
    ///
    /// # Errors
    /// As for [`surfaces::Deformation::new`].
    pub fn deformed(self, frames: usize, path: DeformationPath) -> Result<Self, SurfaceError> {
        let [u, v] = self.form.spans();
        let deformation = Deformation::new(path, u, v)?;
        Ok(Self { frames: Some((frames.clamp(2, Self::MOST_FRAMES), deformation)), ..self })
    }

    /// The helicoid.
    #[must_use]
    pub fn form(&self) -> &surfaces::Helicoid {
        &self.form
    }

    /// How many frames there are; none without a deformation.
    #[must_use]
    pub fn frames(&self) -> usize {
        self.frames.as_ref().map_or(0, |(frames, _)| *frames)
    }

    /// The deformation.
    #[must_use]
    pub fn deformation(&self) -> Option<&Deformation> {
        self.frames.as_ref().map(|(_, deformation)| deformation)
    }
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
    let helicoid = plan.form;
    let spans = || -> Vec<Warning> {
        let bound = bases::Aht::SUPREMUM;
        let piece = [surfaces::Helicoid::LARGEST_WHOLE, surfaces::Helicoid::LARGEST_PIECE];
        ["u-span", "v-span"]
            .into_iter()
            .zip(helicoid.spans())
            .filter_map(|(name, span)| span_warning(name, span, bound, piece, "AHT"))
            .collect()
    };
    let exact = || -> Result<Done, MethodError> {
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
    let Some((frames, deformation)) = &plan.frames else { return surfaces };
    let frames = *frames;

    let digits = frames.to_string().len();
    let named = |k: usize| format!("frame {:0digits$} of {frames}", k + 1);
    progress.begin("deformation", Some(frames as u64));
    let frame = |k: usize| -> Result<Done, MethodError> {
        if progress.cancelled() {
            return Err(MethodError::Interrupted);
        }
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

/// The helicoid over a trapezium; where its span exceeds 2π, it is cut into several patches.
pub fn trapezium(helicoid: &TrapeziumHelicoid, construction: Construction, mesh: usize) -> MethodResult {
    let exact = || -> Result<Done, MethodError> {
        let bound = bases::At::SUPREMUM;
        let piece = [TrapeziumHelicoid::LARGEST_WHOLE, TrapeziumHelicoid::LARGEST_PIECE];
        let warnings = span_warning("span", helicoid.span(), bound, piece, "AT").into_iter().collect();
        let pieces = match construction {
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
    let solved = Solved::given(Surface::Pieces(pieces), family)?;
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
