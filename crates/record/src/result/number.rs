/// The number, if JSON has it.
pub(super) fn finite(x: f64) -> Option<f64> {
    x.is_finite().then_some(x)
}
