//! The room that points take.

/// The diagonal of the least box around points.
pub fn diagonal(points: impl Iterator<Item = [f64; 3]>) -> f64 {
    let [low, high] = extent(points);
    (0..3).map(|k| (high[k] - low[k]).powi(2)).sum::<f64>().sqrt()
}

/// The least box around points: its least and its greatest corner.
pub(super) fn extent(points: impl Iterator<Item = [f64; 3]>) -> [[f64; 3]; 2] {
    points.fold([[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]], |[low, high], p| {
        [std::array::from_fn(|k| low[k].min(p[k])), std::array::from_fn(|k| high[k].max(p[k]))]
    })
}
