//! The boundary of a patch: the control points that are given.

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

/// The fixed control points of a net.
#[derive(Clone, Debug, PartialEq)]
pub enum Boundary {
    /// All four sides of a tensor net of degree (m, n), corners repeated and equal.
    Tensor {
        /// Row `P_{0,j}`, n + 1 points, n ≥ 1.
        u0: Vec<[f64; 3]>,
        /// Row `P_{m,j}`, n + 1 points.
        u1: Vec<[f64; 3]>,
        /// Column `P_{i,0}`, m + 1 points, m ≥ 1.
        v0: Vec<[f64; 3]>,
        /// Column `P_{i,n}`, m + 1 points.
        v1: Vec<[f64; 3]>,
    },
    /// The rows i = 0 and i = m only, for harmonic nets.
    Rows {
        /// Row `P_{0,j}`, n + 1 points, n ≥ 1.
        u0: Vec<[f64; 3]>,
        /// Row `P_{m,j}`, n + 1 points.
        u1: Vec<[f64; 3]>,
        /// The degree m in u, in 1..=[`MAX_DEGREE`].
        degree: usize,
    },
    /// The columns j = 0 and j = n only, for harmonic nets.
    Columns {
        /// Column `P_{i,0}`, m + 1 points, m ≥ 1.
        v0: Vec<[f64; 3]>,
        /// Column `P_{i,n}`, m + 1 points.
        v1: Vec<[f64; 3]>,
        /// The degree n in v, in 1..=[`MAX_DEGREE`].
        degree: usize,
    },
    /// All three sides of a triangular net of degree n ≥ 1, corners repeated and equal;
    /// A = `P_{n,0,0}`, B = `P_{0,n,0}`, C = `P_{0,0,n}`.
    Triangle {
        /// Side from A to B, n + 1 points.
        ab: Vec<[f64; 3]>,
        /// Side from B to C, n + 1 points.
        bc: Vec<[f64; 3]>,
        /// Side from C to A, n + 1 points.
        ca: Vec<[f64; 3]>,
    },
}

impl Boundary {
    /// Degrees (m, n) of a tensor net, or (n, n) of a triangular one, before any `raise`.
    #[must_use]
    pub fn degrees(&self) -> (usize, usize) {
        match self {
            Self::Tensor { u0, v0, .. } => (v0.len() - 1, u0.len() - 1),
            Self::Rows { u0, degree, .. } => (*degree, u0.len() - 1),
            Self::Columns { v0, degree, .. } => (v0.len() - 1, *degree),
            Self::Triangle { ab, .. } => (ab.len() - 1, ab.len() - 1),
        }
    }
}
