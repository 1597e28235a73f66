/// How a surface with a closed form compares with it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClosedForm {
    /// Largest distance between the surface and its closed form at the vertices of the mesh, length.
    pub deviation: f64,
    /// The weights (a, b) of right helicoid and catenoid, for generalized helicoids.
    pub weights: Option<[f64; 2]>,
}
