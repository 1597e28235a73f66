use surfaces::{Net, Point, SurfaceError};

/// The net of GT Example 5.1, with P30 = (0, 6, 0): sides over a square of width 6, each with the heights 0, 2, −2, 0.
///
/// # Errors
/// None but those of [`Net::from_boundary`].
pub fn example_5_1() -> Result<Net, SurfaceError> {
    over_square(&[0.0, 2.0, -2.0, 0.0])
}

/// The net of GT Example 5.2, with P30 = (0, 6, 0): the heights 0, 2, 2, 0.
///
/// # Errors
/// None but those of [`Net::from_boundary`].
pub fn example_5_2() -> Result<Net, SurfaceError> {
    over_square(&[0.0, 2.0, 2.0, 0.0])
}

/// A net like that of Example 5.1 of any degree ≥ 2: heights `27 s (1 − s) (1 − 2s)` at s = k / degree, which for
/// degree 3 are its 0, 2, −2, 0.
///
/// # Errors
/// Those of [`Net::from_boundary`], for degrees below 1.
pub fn wave(degree: usize) -> Result<Net, SurfaceError> {
    let height = |k: usize| {
        let s = k as f64 / degree as f64;
        27.0 * s * (1.0 - s) * (1.0 - 2.0 * s)
    };
    over_square(&(0..=degree).map(height).collect::<Vec<_>>())
}

/// Four sides over [0, 6]², all with the same heights, the first and the last of them 0.
fn over_square(heights: &[f64]) -> Result<Net, SurfaceError> {
    let last = heights.len().saturating_sub(1).max(1);
    let side = |at: &dyn Fn(f64) -> [f64; 2]| -> Vec<Point> {
        heights
            .iter()
            .enumerate()
            .map(|(k, &z)| {
                let [x, y] = at((6 * k) as f64 / last as f64);
                Point::new(x, y, z)
            })
            .collect()
    };
    let (u0, u1) = (side(&|s| [s, 0.0]), side(&|s| [s, 6.0]));
    let (v0, v1) = (side(&|s| [0.0, s]), side(&|s| [6.0, s]));
    Net::from_boundary(&u0, &u1, &v0, &v1)
}
