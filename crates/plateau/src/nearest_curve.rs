//! Bernstein curves nearest to samples.

use bases::{Basis, Bernstein};
use surfaces::Point;
use thiserror::Error;

use crate::MAX_DEGREE;

/// Most samples of a side that is fitted.
const MOST_SAMPLES: usize = 5000;

/// Most corrections of the parameters of the samples.
const CORRECTIONS: usize = 50;

/// Why samples determine no curve.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum NearestCurveError {
    /// The degree.
    #[error("degree {degree} is not offered; 1 to {MAX_DEGREE} are")]
    Degree {
        /// The degree asked for.
        degree: usize,
    },
    /// More samples than are taken.
    #[error("{count} samples are too many; {MOST_SAMPLES} are the most")]
    TooMany {
        /// Number of samples.
        count: usize,
    },
    /// Fewer samples than control points.
    #[error(
        "{count} samples do not determine a curve of degree {degree}: give {} or more, or lower the degree",
        degree + 1
    )]
    TooFew {
        /// Number of samples.
        count: usize,
        /// The degree asked for.
        degree: usize,
    },
    /// Two samples in a row are one point.
    #[error("samples {index} and {} are the same point: leave one out", index + 1)]
    Coincident {
        /// The first of the two.
        index: usize,
    },
    /// Control points that no sample speaks of.
    #[error("the samples leave {count} control points undetermined: lower the degree or spread the samples")]
    Undetermined {
        /// How many.
        count: usize,
    },
    /// Distances that overflow.
    #[error("distances between the samples are beyond double precision: scale them")]
    NotFinite,
    /// The least squares.
    #[error(transparent)]
    Solve(#[from] solve::SolveError),
    /// The functions of the degree.
    #[error(transparent)]
    Basis(#[from] bases::BasisError),
}

/// A Bernstein curve through the first and the last of some samples, as near to the others as least squares make it.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct NearestCurve {
    /// Its control points, degree + 1 of them.
    pub points: Vec<Point>,
    /// Largest distance of a sample from the point of the curve it is paired with: an upper bound of its distance from the
    /// curve.
    pub largest: f64,
    /// Root of the mean square of these distances.
    pub root_mean_square: f64,
}

impl NearestCurve {
    /// Samples get parameters in proportion to the chords between them, and in a second attempt equal steps, which are then
    /// corrected, in turn with the curve, towards those of the nearest points; the best curve on the way is kept.
    ///
    /// # Errors
    /// [`NearestCurveError`].
    pub fn new(samples: &[Point], degree: usize) -> Result<Self, NearestCurveError> {
        if !(1..=MAX_DEGREE).contains(&degree) {
            return Err(NearestCurveError::Degree { degree });
        }
        if samples.len() > MOST_SAMPLES {
            return Err(NearestCurveError::TooMany { count: samples.len() });
        }
        if samples.len() <= degree {
            return Err(NearestCurveError::TooFew { count: samples.len(), degree });
        }
        let basis = Bernstein::new(degree)?;
        let last = (samples.len() - 1) as f64;
        let equal = (0..samples.len()).map(|k| k as f64 / last).collect();
        let chords = chords(samples)?;
        let mut best: Option<Self> = None;
        for mut parameters in [chords, equal] {
            let mut reached = f64::INFINITY;
            for _ in 0..CORRECTIONS {
                let points = nearest(samples, &parameters, &basis)?;
                let fit = Self::measured(samples, &parameters, points, &basis);
                // Progress below a thousandth is not worth another step.
                if fit.root_mean_square > 0.999 * reached {
                    break;
                }
                reached = fit.root_mean_square;
                correct(samples, &mut parameters, &fit.points, &basis);
                if best.as_ref().is_none_or(|best| reached < best.root_mean_square) {
                    best = Some(fit);
                }
            }
        }
        best.ok_or(NearestCurveError::NotFinite)
    }

    fn measured(samples: &[Point], parameters: &[f64], points: Vec<Point>, basis: &Bernstein) -> Self {
        let distances = samples.iter().zip(parameters).map(|(p, &t)| jet(&points, basis, t)[0].distance(*p));
        let (largest, squares) =
            distances.fold((0.0, 0.0), |(largest, squares), d| (f64::max(largest, d), squares + d * d));
        let root_mean_square = (squares / samples.len() as f64).sqrt();
        Self { points, largest, root_mean_square }
    }
}

/// Parameters in proportion to the chords, from 0 to 1.
fn chords(samples: &[Point]) -> Result<Vec<f64>, NearestCurveError> {
    let mut length = 0.0;
    let mut lengths = vec![0.0];
    for (k, pair) in samples.windows(2).enumerate() {
        let chord = pair[0].distance(pair[1]);
        if chord == 0.0 {
            return Err(NearestCurveError::Coincident { index: k });
        }
        length += chord;
        lengths.push(length);
    }
    Ok(lengths.into_iter().map(|part| part / length).collect())
}

/// The control points with the least sum of squares, the ends given: `min ‖B_i p − (s − B_0 s_0 − B_n s_k)‖` over the
/// samples between the ends.
fn nearest(
    samples: &[Point],
    parameters: &[f64],
    basis: &Bernstein,
) -> Result<Vec<Point>, NearestCurveError> {
    let (n, last) = (basis.degree(), samples.len() - 1);
    let (start, end) = (samples[0], samples[last]);
    let (mut matrix, mut rhs) = (Vec::new(), Vec::new());
    for k in 1..last {
        let table = basis.evaluate(parameters[k], 0);
        let values = table.row(0);
        matrix.extend_from_slice(&values[1..n]);
        rhs.extend(<[f64; 3]>::from(samples[k] - start * values[0] - end * values[n]));
    }
    let solution = solve::solve_rank(last - 1, n - 1, &matrix, 3, &rhs, 0.0)?;
    if solution.nullity > 0 {
        return Err(NearestCurveError::Undetermined { count: solution.nullity });
    }
    let interior = solution.x.chunks_exact(3).map(|p| Point::new(p[0], p[1], p[2]));
    Ok(std::iter::once(start).chain(interior).chain([end]).collect())
}

/// A Newton step of every inner parameter towards the nearest point of the curve, if all stay in order.
fn correct(samples: &[Point], parameters: &mut [f64], points: &[Point], basis: &Bernstein) {
    let last = samples.len() - 1;
    let mut corrected = parameters.to_vec();
    for k in 1..last {
        let [c, d1, d2] = jet(points, basis, parameters[k]);
        let off = c - samples[k];
        let curvature = d1.dot(d1) + off.dot(d2);
        if curvature > 0.0 {
            corrected[k] -= off.dot(d1) / curvature;
        }
    }
    if corrected.windows(2).all(|pair| pair[0] < pair[1]) {
        parameters.copy_from_slice(&corrected);
    }
}

/// Point, first and second derivative.
fn jet(points: &[Point], basis: &Bernstein, t: f64) -> [Point; 3] {
    let table = basis.evaluate(t, 2);
    [0, 1, 2].map(|r| points.iter().zip(table.row(r)).fold(Point::ZERO, |sum, (&p, &f)| sum + p * f))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(points: &[Point], parameters: impl Iterator<Item = f64>) -> Vec<Point> {
        let basis = Bernstein::new(points.len() - 1).unwrap();
        parameters.map(|t| jet(points, &basis, t)[0]).collect()
    }

    #[test]
    fn samples_of_a_curve_of_the_degree_are_met() {
        let points = [[0., 0., 0.], [1., 2., 0.], [3., 1., 1.], [4., 0., 0.]].map(Point::from);
        let samples = curve(&points, (0..=40).map(|k| f64::from(k) / 40.0));
        let fit = NearestCurve::new(&samples, 3).unwrap();
        assert!(fit.largest < 1e-13, "{}", fit.largest);
        // At other parameters the way to the curve is long.
        let uneven = curve(&points, (0..=40).map(|k| f64::from(k) / 40.0).map(|t| t * (0.7 + 0.3 * t)));
        let fit = NearestCurve::new(&uneven, 3).unwrap();
        assert!(fit.largest < 0.01, "{}", fit.largest);
        assert_eq!((fit.points[0], fit.points[3]), (samples[0], samples[40]));
        let straight =
            NearestCurve::new(&curve(&[points[0], points[3]], (0..=7).map(|k| f64::from(k) / 7.0)), 4)
                .unwrap();
        assert!(straight.largest < 1e-14);
    }

    #[test]
    fn higher_degrees_come_nearer() {
        let samples: Vec<Point> = (0..=60)
            .map(|k| f64::from(k) / 20.0)
            .map(|t| Point::new(libm::cos(t), libm::sin(t), libm::exp(0.3 * t)))
            .collect();
        let errors: Vec<f64> =
            [2, 4, 6, 8].iter().map(|&n| NearestCurve::new(&samples, n).unwrap().largest).collect();
        assert!(errors.windows(2).all(|pair| pair[1] < 0.2 * pair[0]), "{errors:?}");
    }

    #[test]
    fn what_determines_no_curve_is_told() {
        let p = |x: f64| Point::new(x, 0.0, 0.0);
        assert!(
            NearestCurve::new(&[p(0.0), p(1.0), p(2.0)], 3)
                .unwrap_err()
                .to_string()
                .contains("give 4 or more")
        );
        assert!(
            NearestCurve::new(&[p(0.0), p(1.0), p(1.0), p(2.0)], 2)
                .unwrap_err()
                .to_string()
                .contains("samples 1 and 2")
        );
        assert!(
            NearestCurve::new(&[p(0.0); 5], 2).is_err() && NearestCurve::new(&[p(0.0), p(1.0)], 0).is_err()
        );
    }
}
