//! Conjugate gradients for small systems whose unknowns are points.

use crate::Point;

/// The solution x of `A x = rhs` for a symmetric positive definite A that is known by its products, one point an unknown:
/// until the residual is below 1e-14 of the right-hand side, or after twice as many steps as there are numbers. The end is
/// near the solution in any case, since every step diminishes the error.
pub(crate) fn conjugate_gradients(apply: impl Fn(&[Point]) -> Vec<Point>, rhs: &[Point]) -> Vec<Point> {
    let count = rhs.len();
    let mut x = vec![Point::ZERO; count];
    let mut residual = rhs.to_vec();
    let mut direction = residual.clone();
    let mut size = square(&residual);
    let end = 1e-28 * size;
    for _ in 0..6 * count {
        if size <= end {
            break;
        }
        let image = apply(&direction);
        let curvature: f64 = direction.iter().zip(&image).map(|(d, i)| d.dot(*i)).sum();
        if curvature <= 0.0 || !curvature.is_finite() {
            break;
        }
        let length = size / curvature;
        for k in 0..count {
            x[k] += direction[k] * length;
            residual[k] += image[k] * -length;
        }
        let next = square(&residual);
        for k in 0..count {
            direction[k] = residual[k] + direction[k] * (next / size);
        }
        size = next;
    }
    x
}

fn square(v: &[Point]) -> f64 {
    v.iter().map(|r| r.dot(*r)).sum()
}
