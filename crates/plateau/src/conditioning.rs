//! How well extremals are determined, over the shapes of a family.

use energy::{Functional, ShapeForm};
use solve::{Partition, eigen_symmetric};
use surfaces::{Net, Point, ShapedFamily};

use crate::{FixedShape, MethodError};

/// The matrix A(α) of extremals of a quadratic energy over nets of degree (n, n) whose border is fixed, as a function of the shape α of a family: what the
/// interior is solved with, (n − 1)² by (n − 1)², symmetric, positive definite.
///
/// ```
/// use plateau::{Conditioning, Functional, ShapedFamily};
///
/// let bicubic = Conditioning::new(Functional::Dirichlet, ShapedFamily::Gt, 3)?;
/// let [small, large] = [0.5, 3.5].map(|theta| bicubic.condition(&[theta; 4]));
/// assert!(small? > 5.0 * large?);
/// # Ok::<(), plateau::MethodError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Conditioning {
    form: ShapeForm,
    family: ShapedFamily,
    partition: Partition,
}

impl Conditioning {
    /// Largest degree: beyond, the condition leaves no digit of its smallest eigenvalue.
    pub const MAX_DEGREE: usize = 10;

    /// Of the extremals of `functional` over nets of degree (`degree`, `degree`).
    ///
    /// # Errors
    /// [`MethodError::Energy`] for a degree that the family does not have.
    pub fn new(functional: Functional, family: ShapedFamily, degree: usize) -> Result<Self, MethodError> {
        let side = vec![Point::ZERO; degree + 1];
        let net = Net::from_boundary(&side, &side, &side, &side)?;
        let form = ShapeForm::of(functional, family, (degree, degree))?;
        Ok(Self { form, family, partition: Partition::new(net.fixed()) })
    }

    /// The condition number of A in the 2-norm at a shape: the largest over the smallest eigenvalue; infinite where the smallest is none.
    ///
    /// # Errors
    /// [`MethodError::Surface`] for a shape that the family does not have, [`MethodError::Solve`] if the eigenvalues are not found.
    pub fn condition(&self, shape: &[f64]) -> Result<f64, MethodError> {
        let shape = FixedShape::new(self.family, shape.to_vec())?;
        let matrix = self.form.matrix(self.family.coordinates(shape.parameters())?);
        let block = self.partition.free_block(matrix.as_slice())?;
        let values = eigen_symmetric(self.partition.free().len(), &block)?.values;
        let (Some(&least), Some(&largest)) = (values.first(), values.last()) else { return Ok(1.0) };
        Ok(if least > 0.0 { largest / least } else { f64::INFINITY })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_condition_has_the_symmetries_of_the_family() {
        for functional in Functional::ALL {
            for degree in 3..=5 {
                let conditioning = Conditioning::new(functional, ShapedFamily::Gt, degree).unwrap();
                let of = |shape: [f64; 4]| conditioning.condition(&shape).unwrap();
                let at = of([0.7, 1.9, 1.2, 2.6]);
                assert!(at.is_finite() && at > 1.0);
                for other in [[1.2, 2.6, 0.7, 1.9], [1.9, 0.7, 1.2, 2.6], [0.7, 1.9, 2.6, 1.2]] {
                    assert!((of(other) / at - 1.0).abs() < 1e-7, "{functional:?} {degree} {other:?}");
                }
            }
        }
    }

    #[test]
    fn bad_degrees_and_shapes_are_refused() {
        assert!(Conditioning::new(Functional::Dirichlet, ShapedFamily::Gt, 1).is_err());
        let conditioning = Conditioning::new(Functional::Dirichlet, ShapedFamily::Gt, 3).unwrap();
        assert!(conditioning.condition(&[5.0; 4]).is_err());
        assert!(conditioning.condition(&[1.0; 3]).is_err());
    }
}
