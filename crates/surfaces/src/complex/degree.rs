//! Raising the degree.

use super::{Complex, ComplexError};
use crate::Point;
use crate::curves::raised_once;

impl Complex {
    /// The same surface with patches of degree `degree`, at least its own: exact but for rounding. Points on fixed edges
    /// and fixed vertices are fixed, all others free.
    ///
    /// # Errors
    /// [`ComplexError::Lowered`] for a lower degree than its own, [`ComplexError::Degree`] for one above [`Bezier::MAX_DEGREE`](crate::Bezier::MAX_DEGREE),
    /// [`ComplexError::TooLarge`].
    pub fn with_degree(&self, degree: usize) -> Result<Self, ComplexError> {
        if degree < self.degree() {
            return Err(ComplexError::Lowered { degree, own: self.degree() });
        }
        let layout = self.layout.with_degree(degree)?;
        let mut points = vec![Point::ZERO; layout.count()];
        let mut fixed = vec![false; layout.count()];
        for (old, new) in self.layout.faces.iter().zip(&layout.faces) {
            let net: Vec<Point> = old.nodes().iter().map(|&k| self.points[k]).collect();
            for (&node, point) in new.nodes().iter().zip(raised_net(net, self.degree(), degree)) {
                points[node] = point;
            }
        }
        // Edges once more, each by itself: two faces at an edge round in different order.
        for (number, edge) in layout.edges.iter().enumerate() {
            let curve: Vec<Point> = self.edge_nodes(number).iter().map(|&k| self.points[k]).collect();
            let run = layout.run(number, edge.ends());
            for (&node, &point) in run.iter().zip(&raised_row(curve, degree)) {
                (points[node], fixed[node]) = (point, edge.fixed);
            }
        }
        fixed[..layout.vertices].copy_from_slice(&self.fixed[..layout.vertices]);
        Ok(Self { layout, points, fixed })
    }
}

fn raised_row(mut row: Vec<Point>, degree: usize) -> Vec<Point> {
    while row.len() <= degree {
        row = raised_once(&row);
    }
    row
}

/// The net of degree n along its rows, row by row, raised to (q, q).
pub(super) fn raised_net(net: Vec<Point>, n: usize, q: usize) -> Vec<Point> {
    let rows: Vec<Vec<Point>> = net.chunks_exact(n + 1).map(|row| raised_row(row.to_vec(), q)).collect();
    let columns: Vec<Vec<Point>> =
        (0..=q).map(|j| raised_row(rows.iter().map(|row| row[j]).collect(), q)).collect();
    (0..=q).flat_map(|i| columns.iter().map(move |column| column[i])).collect()
}
