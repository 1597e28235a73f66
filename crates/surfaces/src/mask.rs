//! Masks: each free point as a fixed combination of its neighbours, a sparse linear system for the interior of a net.

use crate::triangle_basis::indices;
use crate::{Net, SurfaceError, TriangleNet};

/// The linear system `Σ_c weight(r, c) P_c = 0`, one equation r for each free point of a net, over all its points c.
///
/// The weight of the free point itself is 1 and those of its neighbours are minus the mask, so each row sums to 0 and
/// every mask reproduces constants. With columns split into free and fixed ones the system reads
/// `A_f P_f = −A_b P_b`; A_f is square of size [`Self::rows`], sparse, not symmetric in general and singular
/// for some masks and degrees ([`TriangleMask::is_singular`]).
#[derive(Debug, Clone, PartialEq)]
pub struct MaskSystem {
    /// Number of equations: free points of the net, in the order of its points.
    pub rows: usize,
    /// Number of points of the net.
    pub cols: usize,
    /// `(row, column, weight)`, row by row, no pair twice, no weight 0.
    pub triplets: Vec<(usize, usize, f64)>,
}

/// A mask for triangular nets: the point `P_I` from the other nine of the cubic net around it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TriangleMask {
    /// `M_α`: weight α for the three corners, β = (1 − 3α)/6 for the six others (TRI §4). M_0 is the discrete Laplacian;
    /// α = 1/9 keeps quadrilaterals close to parallelograms; α = 1/3 has β = 0; α = −2/3 gives the interior point of
    /// the discrete triangular Coons net of degree 3 (COONS §4; the minus is lost in print).
    Symmetric(f64),
    /// The cubic Dirichlet extremal as a mask (TRI Prop. 3; §4 prints it with i and k exchanged). Condition of its system
    /// 12 at degree 10, 48 at degree 16.
    Dirichlet,
    /// The cubic extremal of the Coons functional as a mask (COONS Prop. 4). Its system is exactly singular for every even
    /// degree from 6; at odd degrees its condition is 31 at 7 and 159 at 15.
    Coons,
}

impl TriangleMask {
    /// The system of this mask for the free points of `net`, which are interior points.
    ///
    /// # Errors
    /// [`SurfaceError::Mask`] if α is not a finite number or too large.
    pub fn system(self, net: &TriangleNet) -> Result<MaskSystem, SurfaceError> {
        let stencil = self.stencil()?;
        let free = net.indices().zip(net.fixed()).filter(|(_, fixed)| !**fixed).map(|(index, _)| index);
        Ok(MaskSystem::new(
            net.points().len(),
            free.map(|[i, j, _]| {
                let to = |&(a, b, weight): &(usize, usize, f64)| {
                    // The stencil is stored from (i−1, j−1): free points have i, j, k ≥ 1.
                    (net.position(i + a - 1, j + b - 1), weight)
                };
                (net.position(i, j), stencil.iter().map(to).collect())
            }),
        ))
    }

    /// Whether the system of a net of this degree, its whole interior free, is singular although its data are finite:
    /// the Coons mask at even degrees from 6.
    ///
    /// The Coons mask annihilates every net f(i) + g(j) + (−1)ⁱ h(k). At even n one of these vanishes on
    /// the border but not inside whenever h(0) = h(n) = 0, h(n−i) = −(−1)ⁱ h(i), g(j) = −h(n−j) and
    /// f(i) = −(−1)ⁱ h(n−i); for n = 4 all of them vanish everywhere. Symmetric masks are singular at isolated α
    /// that this does not know of.
    pub fn is_singular(self, degree: usize) -> bool {
        self == Self::Coons && degree >= 6 && degree.is_multiple_of(2)
    }

    /// The nonzero weights of `P_{I+(a−1, b−1, 2−a−b)}`, a, b ≥ 0, as (a, b, weight).
    fn stencil(self) -> Result<Vec<(usize, usize, f64)>, SurfaceError> {
        // By rows a = 0 … 3 of the cubic net, b = 0 … 3 − a within each.
        let weights: [f64; 10] = match self {
            Self::Symmetric(a) => {
                let b = edge_weight(a, 3.0, 6.0)?;
                [a, b, b, a, b, 0.0, b, b, b, a]
            }
            Self::Dirichlet => [0.5, 0.0, -0.25, 0.25, 0.0, 0.0, 0.25, -0.25, 0.25, 0.25],
            Self::Coons => [0.0, 0.5, -0.5, 0.0, 0.5, 0.0, 0.5, -0.5, 0.5, 0.0],
        };
        let weighted = indices(3).zip(weights).map(|([a, b, _], weight)| (a, b, weight));
        Ok(weighted.filter(|w| w.2 != 0.0).collect())
    }
}

/// The corner weight of the rectangular mask that the discrete Coons net satisfies (COONS (10); the minus is lost in
/// print).
pub const COONS_CORNER_WEIGHT: f64 = -0.25;

/// The system of the rectangular mask with weight α for the four corners and β = (1 − 4α)/4 for the four edge
/// neighbours (COONS §4), for the free points of `net`, which are interior points.
///
/// α = 0 is the discrete Laplacian; [`COONS_CORNER_WEIGHT`] gives the discrete Coons net.
///
/// # Errors
/// [`SurfaceError::Mask`] if α is not a finite number or too large.
pub fn rectangular_mask(alpha: f64, net: &Net) -> Result<MaskSystem, SurfaceError> {
    let beta = edge_weight(alpha, 4.0, 4.0)?;
    let cols = net.cols();
    let free = net.fixed().iter().enumerate().filter(|(_, fixed)| !**fixed).map(|(p, _)| p);
    Ok(MaskSystem::new(
        net.points().len(),
        free.map(|p| {
            let (above, below) = (p - cols, p + cols);
            let corners = [above - 1, above + 1, below - 1, below + 1].map(|q| (q, alpha));
            let edges = [above, p - 1, p + 1, below].map(|q| (q, beta));
            (p, corners.into_iter().chain(edges).filter(|(_, w)| *w != 0.0).collect())
        }),
    ))
}

/// β with `corners · α + edges · β = 1`.
fn edge_weight(alpha: f64, corners: f64, edges: f64) -> Result<f64, SurfaceError> {
    let beta = (1.0 - corners * alpha) / edges;
    if beta.is_finite() { Ok(beta) } else { Err(SurfaceError::Mask { alpha }) }
}

impl MaskSystem {
    /// From each free point with its weighted neighbours.
    fn new(cols: usize, points: impl Iterator<Item = (usize, Vec<(usize, f64)>)>) -> Self {
        let mut triplets = Vec::new();
        let mut rows = 0;
        for (centre, mut neighbours) in points {
            neighbours.iter_mut().for_each(|(_, weight)| *weight = -*weight);
            neighbours.push((centre, 1.0));
            neighbours.sort_unstable_by_key(|&(column, _)| column);
            triplets.extend(neighbours.into_iter().map(|(column, weight)| (rows, column, weight)));
            rows += 1;
        }
        Self { rows, cols, triplets }
    }
}
