//! B-spline surfaces, the form in which CAD programs hold a patch.

use super::Knots;
use crate::curves::{joined_pieces, raised_once};
use crate::{Net, Point, TriangleNet};

/// A tensor product B-spline surface over the rectangle of its first and last knots.
#[derive(Debug, Clone, PartialEq)]
pub struct SplineSurface {
    pub(super) knots: [Knots; 2],
    /// Row by row, with u.
    pub(super) points: Vec<Point>,
}

impl SplineSurface {
    /// The Bézier patch of a net, which is one over [0, 1]².
    pub fn bernstein(net: &Net) -> Self {
        let (m, n) = net.degrees();
        Self { knots: [Knots::bernstein(m), Knots::bernstein(n)], points: net.points().to_vec() }
    }

    /// The triangular patch as a rectangular one whose side u = 0 is the corner A: with barycentric coordinates
    /// `1 − s`, `s (1 − t)`, `s t` the functions are `B^n_ijk = B^n_{j+k}(s) B^{j+k}_k(t)`, so row a is a curve of degree a
    /// in t, raised to degree n.
    pub fn triangle(net: &TriangleNet) -> Self {
        let n = net.degree();
        let rows = (0..=n).flat_map(|a| {
            let mut row: Vec<Point> = (0..=a).map(|k| net.point(n - a, a - k)).collect();
            if a == 0 {
                // Exactly one point, whatever rounding makes of it.
                row.resize(n + 1, row[0]);
            }
            while row.len() <= n {
                row = raised_once(&row);
            }
            row
        });
        Self { knots: [Knots::bernstein(n), Knots::bernstein(n)], points: rows.collect() }
    }

    /// The same surface, exact but for rounding, with every inner knot as often as the degree says: between neighbouring knots lie
    /// (d + 1) × (e + 1) control points, which are those of a Bézier patch, and the outer ones are those of its neighbours, too.
    #[must_use]
    pub fn bezier_form(&self) -> Self {
        let [u, v] = &self.knots;
        let refined = |knots: &Knots, line: &[Point]| joined_pieces(knots.degree(), &knots.repeated(), line);
        let rows: Vec<Vec<Point>> = self.points.chunks(self.cols()).map(|row| refined(v, row)).collect();
        let cols = rows.first().map_or(0, Vec::len);
        let column = |j: usize| rows.iter().map(|row| row[j]).collect::<Vec<_>>();
        let columns: Vec<Vec<Point>> = (0..cols).map(|j| refined(u, &column(j))).collect();
        let count = columns.first().map_or(0, Vec::len);
        let points = (0..count).flat_map(|i| columns.iter().map(move |column| column[i])).collect();
        Self { knots: [u.bezier_form(), v.bezier_form()], points }
    }

    /// The knots in u and in v.
    pub fn knots(&self) -> &[Knots; 2] {
        &self.knots
    }

    /// The control points, row by row with u.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// Columns of the net: functions in v.
    pub fn cols(&self) -> usize {
        self.knots[1].count()
    }

    /// The points at `us × vs`, all v of the first u first.
    pub fn points_at(&self, us: &[f64], vs: &[f64]) -> Vec<Point> {
        let cols = self.cols();
        let in_v: Vec<(usize, Vec<f64>)> = vs.iter().map(|&v| self.knots[1].functions(v)).collect();
        let mut points = Vec::with_capacity(us.len() * vs.len());
        for &u in us {
            let (first, f) = self.knots[0].functions(u);
            let curve: Vec<Point> = (0..cols)
                .map(|j| sum(f.iter().enumerate().map(|(i, f)| self.points[(first + i) * cols + j] * *f)))
                .collect();
            points.extend(
                in_v.iter().map(|(first, g)| sum(g.iter().enumerate().map(|(j, g)| curve[first + j] * *g))),
            );
        }
        points
    }
}

pub(super) fn sum(points: impl Iterator<Item = Point>) -> Point {
    points.fold(Point::ZERO, |sum, p| sum + p)
}
