/// Highest degree of a control net, in each direction, after `raise`.
///
/// Gram matrices of Bernstein-like bases are singular in `f64` long before this degree; the limit
/// keeps the time and memory of a solve bounded, it promises no accuracy.
pub const MAX_DEGREE: usize = 64;

/// Largest admissible |coordinate| of a control point.
///
/// Areas are roots of products of four lengths, curvatures quotients of such products: within the limits all of them are
/// finite, at any degree, and none is lost to underflow.
pub const MAX_COORDINATE: f64 = 1e60;

/// Least admissible size of a boundary: the largest |coordinate| of its control points, unless all are 0.
pub const MIN_SIZE: f64 = 1e-60;
