/// The names of all pictures there are.
pub const PICTURES: [&str; 7] =
    ["surfaces", "deformation", "mean-curvature", "mode", "tb-coons", "convergence", "curvature"];

/// A picture with its name.
pub struct Picture {
    /// The name of its file, without `.svg`; one of [`PICTURES`].
    pub name: &'static str,
    /// What it shows, in a sentence.
    pub caption: String,
    /// The whole file.
    pub svg: String,
}

impl Picture {
    /// The width as the file states it.
    pub(crate) fn width(&self) -> f64 {
        let stated = self.svg.split_once("width=\"").and_then(|(_, rest)| rest.split_once('"'));
        stated.and_then(|(width, _)| width.parse().ok()).unwrap_or(f64::INFINITY)
    }
}
