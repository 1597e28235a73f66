//! What a single patch over a slender border would gain by being cut across.

use surfaces::{Complex, Net};

use crate::cutting::{cut_slender, slenderness};
use crate::{AreaEnd, AreaExtremal, Displacement, MethodError, Progress, least_area_complex_near};

/// Control points up to which the least area of all pieces is looked for unasked.
const FEW: usize = 2500;

/// Share of the area below which nothing is gained.
const GAIN: f64 = 1e-9;

/// What cutting the patch of least area on `net` gains, if its border is slender and anything is to be gained: by computing it, where
/// that takes no time to speak of.
///
/// # Errors
/// [`MethodError::Interrupted`]; whatever else goes wrong loses the figure alone.
pub(crate) fn gain_of_cutting(
    net: &Net,
    found: &AreaExtremal,
    tolerance: f64,
    progress: &dyn Progress,
) -> Result<Option<Slender>, MethodError> {
    let Ok(whole) = Complex::of_net(net) else { return Ok(None) };
    let Some(ratio) = slenderness(&whole) else { return Ok(None) };
    let cut = match cut_gain(&whole, found, tolerance, progress) {
        Err(MethodError::Interrupted) => return Err(MethodError::Interrupted),
        found => found.unwrap_or_default(),
    };
    let gains = |cut: &CutGain| cut.gained > GAIN.max(tolerance) * found.area.value;
    Ok(cut.as_ref().is_none_or(gains).then_some(Slender { ratio, cut }))
}

/// What cutting gains; none where that is too much to compute, or was not found.
fn cut_gain(
    whole: &Complex,
    found: &AreaExtremal,
    tolerance: f64,
    progress: &dyn Progress,
) -> Result<Option<CutGain>, MethodError> {
    let complex = cut_slender(whole)?;
    let (pieces, degree) = (complex.faces().len(), complex.degree());
    // Pieces are sought as a whole, at whatever degree.
    if pieces * (degree + 1).pow(2) > FEW || degree > Displacement::WHOLE {
        return Ok(None);
    }
    let (_, cut) = least_area_complex_near(&complex, tolerance, progress)?;
    let (area, gained) = (cut.area.value, found.area.value - cut.area.value);
    let is_known = cut.end == AreaEnd::Stationary && cut.area.settled;
    Ok(is_known.then_some(CutGain { pieces, degree, area, gained }))
}

/// A border many times as long as wide.
pub(crate) struct Slender {
    /// How many times.
    pub(crate) ratio: f64,
    /// What cutting gains; none where that was not computed.
    pub(crate) cut: Option<CutGain>,
}

/// What a patch that is cut across gains.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CutGain {
    /// The number of pieces.
    pub pieces: usize,
    /// Their degree.
    pub degree: usize,
    /// Their least area together.
    pub area: f64,
    /// What that is less than the least area of one patch.
    pub gained: f64,
}
