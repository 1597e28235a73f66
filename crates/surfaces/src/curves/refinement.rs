//! Least squares of the distances from a curve, whatever its parameter.

use bases::{Basis, Lobatto};

use super::Bezier;
use super::interpolation::Interpolation;
use crate::Point;
use crate::conjugate_gradients::conjugate_gradients;

/// Weight of the squared way along the curve beside that across it: small, so that the samples may slide along the
/// curve; not zero, so that it stays evenly run through.
const ALONG: f64 = 1e-5;

/// A curve with the parameters of its points that are nearest to given samples.
#[derive(Debug, Clone)]
pub(super) struct Paired {
    pub(super) curve: Bezier,
    pub(super) parameters: Vec<f64>,
}

impl Paired {
    /// The largest distance of a sample from the point it is paired with: an upper bound of those from the curve.
    pub(super) fn largest(&self, samples: &[Point]) -> f64 {
        let distance = |(p, &t): (&Point, &f64)| p.distance(self.curve.point(t));
        samples.iter().zip(&self.parameters).map(distance).fold(0.0, f64::max)
    }

    /// A Gauss–Newton step: the ends stay, and the squares of the distances across the curve become least to first order,
    /// because samples may slide along it. Approximation of plane curves by degree n comes as near as the 2n-th power of
    /// their length in this way, at fixed parameters as the (n + 1)-st only.
    pub(super) fn stepped(&self, samples: &[Point], interpolation: &Interpolation) -> Option<Self> {
        let count = interpolation.degree() - 1;
        let last = samples.len() - 1;
        if count == 0 || last < 2 {
            return None;
        }
        let lobatto = Lobatto::new(count, (0.0, 1.0)).ok()?;
        let inner = 1..last;
        let mut table: Vec<Vec<f64>> =
            inner.clone().map(|i| lobatto.evaluate(self.parameters[i], 0).row(0).to_vec()).collect();
        let scale: Vec<f64> = (0..count)
            .map(|k| table.iter().map(|row| row[k] * row[k]).sum::<f64>().sqrt().recip())
            .map(|scale| if scale.is_finite() { scale } else { 0.0 })
            .collect();
        table.iter_mut().for_each(|row| row.iter_mut().zip(&scale).for_each(|(f, s)| *f *= s));
        let tangents: Vec<Point> = inner
            .clone()
            .map(|i| self.curve.derivative(self.parameters[i]).unit().unwrap_or_default())
            .collect();
        let across = |i: usize, x: Point| x - tangents[i] * (x.dot(tangents[i]) * (1.0 - ALONG));
        let gathered = |ways: &dyn Fn(usize) -> Point| -> Vec<Point> {
            let mut sums = vec![Point::ZERO; count];
            for (i, row) in table.iter().enumerate() {
                let way = across(i, ways(i));
                row.iter().zip(&mut sums).for_each(|(&f, sum)| *sum += way * f);
            }
            sums
        };
        let rhs = gathered(&|i| samples[i + 1] - self.curve.point(self.parameters[i + 1]));
        let way =
            |x: &[Point], i: usize| table[i].iter().zip(x).fold(Point::ZERO, |sum, (&f, &x)| sum + x * f);
        let x = conjugate_gradients(|x| gathered(&|i| way(x, i)), &rhs);
        let change = interpolation.curve(Point::ZERO, Point::ZERO, |t| {
            let row = lobatto.evaluate(t, 0);
            (0..count).fold(Point::ZERO, |sum, k| sum + x[k] * (row[(0, k)] * scale[k]))
        });
        let raised = self.curve.raised(interpolation.degree());
        let points = raised.points.iter().zip(&change.points).map(|(&p, &d)| p + d).collect();
        let mut next = Self { curve: Bezier { points }, parameters: self.parameters.clone() };
        next.pair(samples);
        Some(next)
    }

    /// Newton steps of every inner parameter towards the nearest point of the curve, if all stay in order.
    pub(super) fn pair(&mut self, samples: &[Point]) {
        for _ in 0..2 {
            let mut corrected = self.parameters.clone();
            for k in 1..samples.len() - 1 {
                let t = corrected[k];
                let (off, d1) = (self.curve.point(t) - samples[k], self.curve.derivative(t));
                let bend = d1.dot(d1) + off.dot(self.curve.second_derivative(t));
                if bend > 0.0 {
                    corrected[k] -= off.dot(d1) / bend;
                }
            }
            if corrected.windows(2).all(|pair| pair[0] < pair[1]) {
                self.parameters = corrected;
            }
        }
    }
}
