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
