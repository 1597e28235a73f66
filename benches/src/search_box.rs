use optim::{Bounds, BoundsError};

/// The box of the searches of GT §5: every shape parameter in [0.5, 3.5].
///
/// # Errors
/// None but those of [`Bounds::cube`].
pub fn search_box() -> Result<Bounds, BoundsError> {
    Bounds::cube(4, 0.5, 3.5)
}

/// `count` points of the box of the searches, four numbers each, spread by the fractional parts of multiples of
/// irrational numbers: the same ones every time, no two alike.
pub fn shapes(count: usize) -> Vec<f64> {
    let steps = [2.0, 3.0, 5.0, 7.0].map(f64::sqrt);
    (1..=count).flat_map(|i| steps.map(|step| 0.5 + 3.0 * (i as f64 * step).fract())).collect()
}
