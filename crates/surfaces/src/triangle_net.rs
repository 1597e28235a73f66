use crate::net::extent;
use crate::triangle_basis::{check_degree, count, indices, position};
use crate::{Point, SurfaceError};

/// A triangular control net `P_ijk`, i + j + k = n, in which every point is either fixed (prescribed) or free (to be
/// determined).
///
/// (i, j, k) belong to the parameters (u, v, w) (TRI §2.1). The linear order is that of
/// [`TriangleBasis`](crate::TriangleBasis): i ascending, then j ascending. The corners are A = P_{n,0,0}, B = P_{0,n,0}
/// and C = P_{0,0,n}.
#[derive(Debug, Clone, PartialEq)]
pub struct TriangleNet {
    degree: usize,
    points: Vec<Point>,
    fixed: Vec<bool>,
}

impl TriangleNet {
    /// The net of (n + 1)(n + 2)/2 points given in linear order, all of them fixed; 1 ≤ n ≤ 64.
    ///
    /// # Errors
    /// [`SurfaceError::Basis`] for a degree that is not offered, [`SurfaceError::TriangleSize`] if the number of points is
    /// another one, [`SurfaceError::NotFinite`].
    pub fn new(degree: usize, points: Vec<Point>) -> Result<Self, SurfaceError> {
        check_degree(degree, 1)?;
        if points.len() != count(degree) {
            return Err(SurfaceError::TriangleSize { degree, expected: count(degree), found: points.len() });
        }
        if let Some(index) = points.iter().position(|p| !p.is_finite()) {
            return Err(SurfaceError::NotFinite { index });
        }
        Ok(Self { degree, fixed: vec![true; points.len()], points })
    }

    /// The net with the three given border polygons fixed and its interior free (and 0).
    ///
    /// `ab` runs from A to B (w = 0), `bc` from B to C (u = 0), `ca` from C to A (v = 0), n + 1 points each; every corner
    /// appears in two of them.
    ///
    /// # Errors
    /// [`SurfaceError::TooShort`], [`SurfaceError::TriangleRow`], [`SurfaceError::Corner`],
    /// [`SurfaceError::Basis`] for a degree above 64, [`SurfaceError::NotFinite`].
    pub fn from_boundary(ab: &[Point], bc: &[Point], ca: &[Point]) -> Result<Self, SurfaceError> {
        for (name, row) in [("ab", ab), ("bc", bc), ("ca", ca)] {
            if row.len() < 2 {
                return Err(SurfaceError::TooShort { name, found: row.len() });
            }
            if row.len() != ab.len() {
                return Err(SurfaceError::TriangleRow { name, expected: ab.len(), found: row.len() });
            }
        }
        let n = ab.len() - 1;
        check_degree(n, 1)?;
        for (first, second, a, b) in [
            ("the start of ab (A)", "the end of ca (A)", ab[0], ca[n]),
            ("the end of ab (B)", "the start of bc (B)", ab[n], bc[0]),
            ("the end of bc (C)", "the start of ca (C)", bc[n], ca[0]),
        ] {
            // A comparison that coordinates which are not numbers fail as well: those are reported by position below.
            if a != b && a.is_finite() && b.is_finite() {
                return Err(SurfaceError::Corner { first, second, a: a.into(), b: b.into() });
            }
        }
        let mut points = vec![Point::ZERO; count(n)];
        for s in 0..=n {
            points[position(n, n - s, s)] = ab[s];
            points[position(n, 0, n - s)] = bc[s];
            points[position(n, s, 0)] = ca[s];
        }
        let mut net = Self::new(n, points)?;
        net.free_interior();
        Ok(net)
    }

    fn free_interior(&mut self) {
        for (fixed, index) in self.fixed.iter_mut().zip(indices(self.degree)) {
            *fixed = index.contains(&0);
        }
    }

    /// The degree n.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The multi-indices (i, j, k) in linear order.
    pub fn indices(&self) -> impl Iterator<Item = [usize; 3]> + use<> {
        indices(self.degree)
    }

    /// Position of (i, j, n − i − j) in the linear order.
    pub fn position(&self, i: usize, j: usize) -> usize {
        position(self.degree, i, j)
    }

    /// `P_ijk` with k = n − i − j.
    pub fn point(&self, i: usize, j: usize) -> Point {
        self.points[self.position(i, j)]
    }

    /// All points in linear order.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// For every point, in linear order, whether it is fixed.
    pub fn fixed(&self) -> &[bool] {
        &self.fixed
    }

    /// The coordinates, one point (x, y, z) after the other in linear order: the (points × 3) array of linear systems.
    pub fn coordinates(&self) -> Vec<f64> {
        self.points.iter().flat_map(|&p| <[f64; 3]>::from(p)).collect()
    }

    /// The same net with all points replaced by `coordinates` (as [`Self::coordinates`] gives them).
    ///
    /// # Errors
    /// [`SurfaceError::TriangleSize`] for another number of points, [`SurfaceError::NotFinite`].
    pub fn with_coordinates(&self, coordinates: &[f64]) -> Result<Self, SurfaceError> {
        if coordinates.len() != 3 * self.points.len() {
            return Err(SurfaceError::TriangleSize {
                degree: self.degree,
                expected: self.points.len(),
                found: coordinates.len() / 3,
            });
        }
        let points = coordinates.chunks_exact(3).map(|c| Point::new(c[0], c[1], c[2])).collect();
        let mut net = Self::new(self.degree, points)?;
        net.fixed.clone_from(&self.fixed);
        Ok(net)
    }

    /// The three border polygons ab, bc, ca.
    pub fn boundary(&self) -> [Vec<Point>; 3] {
        let n = self.degree;
        [
            (0..=n).map(|s| self.point(n - s, s)).collect(),
            (0..=n).map(|s| self.point(0, n - s)).collect(),
            (0..=n).map(|s| self.point(s, 0)).collect(),
        ]
    }

    /// The length of the diagonal of the bounding box: the size errors are measured against.
    pub fn size(&self) -> f64 {
        extent(&self.points)
    }

    /// The net of the same patch with the degree raised by `k`: exact, its border fixed and its interior free.
    ///
    /// # Errors
    /// [`SurfaceError::Basis`] if the degree would exceed 64.
    pub fn raised(&self, k: usize) -> Result<Self, SurfaceError> {
        check_degree(self.degree.saturating_add(k), 1)?;
        let mut net = self.clone();
        for _ in 0..k {
            net = net.raised_once();
        }
        Ok(net)
    }

    /// `(n+1) P_ijk = i P_{i−1,j,k} + j P_{i,j−1,k} + k P_{i,j,k−1}`.
    fn raised_once(&self) -> Self {
        let degree = self.degree + 1;
        let share = |index: usize| index as f64 / degree as f64;
        let points = indices(degree)
            .map(|[i, j, k]| {
                let mut point = Point::ZERO;
                for (index, neighbour) in
                    [(i, (i.wrapping_sub(1), j)), (j, (i, j.wrapping_sub(1))), (k, (i, j))]
                {
                    if index == degree {
                        return self.point(neighbour.0, neighbour.1);
                    }
                    if index > 0 {
                        point += self.point(neighbour.0, neighbour.1) * share(index);
                    }
                }
                point
            })
            .collect();
        let mut net = Self { degree, points, fixed: vec![true; count(degree)] };
        net.free_interior();
        net
    }
}
