use crate::{Point, SurfaceError};

/// A rectangular control net `P_ij`, i = 0 … m by rows (with u), j = 0 … n by columns (with v), in which every point
/// is either fixed (prescribed) or free (to be determined).
#[derive(Debug, Clone, PartialEq)]
pub struct Net {
    rows: usize,
    cols: usize,
    points: Vec<Point>,
    fixed: Vec<bool>,
}

impl Net {
    /// The net of `rows · cols` points given row by row, all of them fixed.
    ///
    /// # Errors
    /// [`SurfaceError::Size`] if the number of points is another one, [`SurfaceError::NotFinite`].
    pub fn new(rows: usize, cols: usize, points: Vec<Point>) -> Result<Self, SurfaceError> {
        if rows * cols != points.len() {
            return Err(SurfaceError::Size { rows, cols, found: points.len() });
        }
        if let Some(index) = points.iter().position(|p| !p.is_finite()) {
            return Err(SurfaceError::NotFinite { index });
        }
        Ok(Self { rows, cols, fixed: vec![true; points.len()], points })
    }

    /// The net with the four given boundary polygons fixed and its interior free (and 0).
    ///
    /// `u0`, `u1` are the rows i = 0 and i = m (n + 1 points each), `v0`, `v1` the columns j = 0 and j = n (m + 1 points
    /// each); every corner appears in two of them.
    ///
    /// # Errors
    /// [`SurfaceError::TooShort`], [`SurfaceError::Length`], [`SurfaceError::Corner`], [`SurfaceError::NotFinite`].
    pub fn from_boundary(
        u0: &[Point],
        u1: &[Point],
        v0: &[Point],
        v1: &[Point],
    ) -> Result<Self, SurfaceError> {
        for (name, row, opposite) in [("u0", u0, u0), ("u1", u1, u0), ("v0", v0, v0), ("v1", v1, v0)] {
            if row.len() < 2 {
                return Err(SurfaceError::TooShort { name, found: row.len() });
            }
            if row.len() != opposite.len() {
                return Err(SurfaceError::Length { name, expected: opposite.len(), found: row.len() });
            }
        }
        let (rows, cols) = (v0.len(), u0.len());
        let (m, n) = (rows - 1, cols - 1);
        for (first, second, a, b) in [
            ("the start of u0", "the start of v0", u0[0], v0[0]),
            ("the end of u0", "the start of v1", u0[n], v1[0]),
            ("the start of u1", "the end of v0", u1[0], v0[m]),
            ("the end of u1", "the end of v1", u1[n], v1[m]),
        ] {
            if a != b {
                return Err(SurfaceError::Corner { first, second, a: a.into(), b: b.into() });
            }
        }
        let mut net = Self::new(rows, cols, vec![Point::ZERO; rows * cols])?;
        for j in 0..cols {
            net.points[j] = u0[j];
            net.points[m * cols + j] = u1[j];
        }
        for i in 0..rows {
            net.points[i * cols] = v0[i];
            net.points[i * cols + n] = v1[i];
        }
        if let Some(index) = net.points.iter().position(|p| !p.is_finite()) {
            return Err(SurfaceError::NotFinite { index });
        }
        for i in 1..m {
            for j in 1..n {
                net.fixed[i * cols + j] = false;
            }
        }
        Ok(net)
    }

    /// Number of rows, m + 1.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of columns, n + 1.
    pub fn cols(&self) -> usize {
        self.cols
    }

    /// The bidegree (m, n) of a Bézier-like patch on this net.
    pub fn degrees(&self) -> (usize, usize) {
        (self.rows - 1, self.cols - 1)
    }

    /// `P_ij`.
    pub fn point(&self, i: usize, j: usize) -> Point {
        self.points[i * self.cols + j]
    }

    /// All points, row by row.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// For every point, row by row, whether it is fixed.
    pub fn fixed(&self) -> &[bool] {
        &self.fixed
    }

    /// The coordinates, one point (x, y, z) after the other, row by row: the (points × 3) array of linear systems.
    pub fn coordinates(&self) -> Vec<f64> {
        self.points.iter().flat_map(|&p| <[f64; 3]>::from(p)).collect()
    }

    /// The same net with all points replaced by `coordinates` (as [`Self::coordinates`] gives them).
    ///
    /// # Errors
    /// [`SurfaceError::Size`] for another number of points, [`SurfaceError::NotFinite`].
    pub fn with_coordinates(&self, coordinates: &[f64]) -> Result<Self, SurfaceError> {
        let points = coordinates.chunks_exact(3).map(|c| Point::new(c[0], c[1], c[2])).collect();
        let mut net = Self::new(self.rows, self.cols, points)?;
        net.fixed.clone_from(&self.fixed);
        Ok(net)
    }

    /// The same net with every point fixed: nothing is left to determine.
    pub fn with_all_fixed(mut self) -> Self {
        self.fixed.fill(true);
        self
    }

    /// The four boundary polygons u0, u1, v0, v1.
    pub fn boundary(&self) -> [Vec<Point>; 4] {
        let (m, n) = self.degrees();
        let row = |i| (0..=n).map(|j| self.point(i, j)).collect();
        let col = |j| (0..=m).map(|i| self.point(i, j)).collect();
        [row(0), row(m), col(0), col(n)]
    }

    /// The length of the diagonal of the bounding box: the size errors are measured against.
    pub fn size(&self) -> f64 {
        extent(&self.points)
    }

    /// The net of the same Bernstein–Bézier patch with both degrees raised by `k`: exact, points that were interior
    /// stay free, boundary stays boundary.
    pub fn raised(&self, k: usize) -> Self {
        let mut net = self.clone();
        for _ in 0..k {
            net = net.raised_once();
        }
        net
    }

    fn raised_once(&self) -> Self {
        let (m, n) = (self.rows, self.cols); // the raised degrees
        let at = |i: usize, j: usize| self.points[i.min(m - 1) * self.cols + j.min(n - 1)];
        let mut points = Vec::with_capacity((m + 1) * (n + 1));
        let mut fixed = Vec::with_capacity((m + 1) * (n + 1));
        for i in 0..=m {
            let s = i as f64 / m as f64;
            for j in 0..=n {
                let t = j as f64 / n as f64;
                let (i0, j0) = (i.saturating_sub(1), j.saturating_sub(1));
                let here = at(i, j) * (1.0 - t) + at(i, j0) * t;
                let before = at(i0, j) * (1.0 - t) + at(i0, j0) * t;
                points.push(here * (1.0 - s) + before * s);
                fixed.push(i == 0 || i == m || j == 0 || j == n);
            }
        }
        Self { rows: m + 1, cols: n + 1, points, fixed }
    }
}

/// The diagonal of the bounding box of `points`; 0 for no points.
pub fn extent(points: &[Point]) -> f64 {
    let Some(&first) = points.first() else { return 0.0 };
    let (low, high) = points.iter().fold((first, first), |(l, h), p| {
        (
            Point::new(l.x.min(p.x), l.y.min(p.y), l.z.min(p.z)),
            Point::new(h.x.max(p.x), h.y.max(p.y), h.z.max(p.z)),
        )
    });
    low.distance(high)
}
