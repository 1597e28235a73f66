//! An energy of the extremal of another, as a function of the shape.

use bases::Matrix;
use energy::{Functional, ShapeForm, area_with_gradient};
use optim::{Objective, Smooth};
use solve::{Cholesky, Partition, solve_partitioned};
use surfaces::{Net, ShapedFamily, TensorPatch};

use super::at_shapes::Coordinates;
use super::least_area::{LeastArea, derivatives};
use crate::{Energy, MethodError, SearchEnergy};

/// `F(x(α), α)`, where x(α) minimises another energy E over the free points at shape α: what a search asks whose energy is not
/// that of the extremal.
///
/// With `E = Xᵀ Q X` the net follows the shape by `Q_ff ∂x = −(∂Q X)_f`. One more solve, `Q_ff λ = F_x`, gives the gradient
/// `∂F − λ · (∂Q X)_f` in all parameters.
pub(super) struct Composed<'a> {
    net: Net,
    family: ShapedFamily,
    inner: Inner<'a>,
    outer: Outer,
}

/// The energy whose extremal is taken.
pub(super) enum Inner<'a> {
    /// A quadratic energy.
    Quadratic(ShapeForm),
    /// The area. Its extremal follows the shape by no linear system of full rank: points move along the surface at no cost.
    Area(LeastArea<'a>),
}

enum Outer {
    Quadratic(ShapeForm),
    Area,
    /// (D − A)/A, with the form of D.
    Conformality(ShapeForm),
}

/// The net of the extremal at one shape, and the matrix Q there, over all points.
struct Extremal {
    patch: TensorPatch,
    matrix: Matrix,
}

/// A value with its derivatives by the points, and by the coordinates of the shape with the points held.
struct Varied {
    value: f64,
    by_points: Vec<f64>,
    held: Coordinates,
}

impl Varied {
    /// Its excess over another value, as a share of that.
    fn over(self, other: &Self) -> Self {
        let ratio = self.value / other.value;
        let by = |a: f64, b: f64| (a - ratio * b) / other.value;
        Self {
            value: ratio - 1.0,
            by_points: self.by_points.iter().zip(&other.by_points).map(|(a, b)| by(*a, *b)).collect(),
            held: std::array::from_fn(|k| by(self.held[k], other.held[k])),
        }
    }
}

/// Half the distance of the two shapes whose values make a derivative where there is no formula for it.
const STEP: f64 = 1e-3;

/// The form of a quadratic energy over a net.
pub(super) fn form(
    functional: Functional,
    family: ShapedFamily,
    net: &Net,
) -> Result<ShapeForm, MethodError> {
    Ok(ShapeForm::of(functional, family, net.degrees())?)
}

impl<'a> Composed<'a> {
    /// The energy `outer` of the extremal of `inner`.
    pub(super) fn new(
        net: &Net,
        family: ShapedFamily,
        inner: Inner<'a>,
        outer: SearchEnergy,
    ) -> Result<Self, MethodError> {
        let outer = match outer {
            SearchEnergy::Energy(Energy::Quadratic(functional)) => {
                Outer::Quadratic(form(functional, family, net)?)
            }
            SearchEnergy::Energy(Energy::Area) => Outer::Area,
            SearchEnergy::Conformality => Outer::Conformality(form(Functional::Dirichlet, family, net)?),
        };
        Ok(Self { net: net.clone(), family, inner, outer })
    }

    fn extremal(&self, form: &ShapeForm, shape: &[f64]) -> Result<Extremal, MethodError> {
        let (matrix, partition) =
            (form.matrix(self.family.coordinates(shape)?), Partition::new(self.net.fixed()));
        let solution =
            solve_partitioned(matrix.rows(), matrix.as_slice(), &partition, 3, &self.net.coordinates())?;
        let net = self.net.with_coordinates(&solution.x)?;
        Ok(Extremal { patch: self.family.patch(net, shape)?, matrix })
    }

    /// F of a patch at a shape.
    fn outer_value(&self, patch: &TensorPatch, shape: &[f64]) -> Result<f64, MethodError> {
        let quadratic = |form: &ShapeForm| -> Result<f64, MethodError> {
            let x = patch.net().coordinates();
            Ok(dot(&x, &applied(&form.matrix(self.family.coordinates(shape)?), &x)))
        };
        Ok(match &self.outer {
            Outer::Quadratic(form) => quadratic(form)?,
            Outer::Area => energy::area(patch)?.value,
            Outer::Conformality(dirichlet) => quadratic(dirichlet)? / energy::area(patch)?.value - 1.0,
        })
    }

    /// F of a patch at the coordinates of a shape, with its derivatives.
    fn outer_varied(&self, patch: &TensorPatch, at: Coordinates) -> Result<Varied, MethodError> {
        let quadratic = |form: &ShapeForm| {
            let x = patch.net().coordinates();
            let image = applied(&form.matrix(at), &x);
            let held = std::array::from_fn(|k| dot(&x, &applied(&form.derivative(at, k), &x)));
            Varied { value: dot(&x, &image), by_points: image.iter().map(|c| 2.0 * c).collect(), held }
        };
        let area = || -> Result<Varied, MethodError> {
            let (area, by_points) = area_with_gradient(patch)?;
            let held = derivatives(self.family, patch, area.points)?;
            Ok(Varied { value: area.value, by_points, held })
        };
        Ok(match &self.outer {
            Outer::Quadratic(form) => quadratic(form),
            Outer::Area => area()?,
            Outer::Conformality(dirichlet) => quadratic(dirichlet).over(&area()?),
        })
    }

    fn value(&self, shape: &[f64]) -> Result<f64, MethodError> {
        let patch = match &self.inner {
            Inner::Quadratic(form) => self.extremal(form, shape)?.patch,
            Inner::Area(area) => area.extremal(shape)?.0,
        };
        self.outer_value(&patch, shape)
    }

    fn gradient(&self, shape: &[f64]) -> Result<(f64, Vec<f64>), MethodError> {
        match &self.inner {
            Inner::Quadratic(form) => self.by_adjoint(form, shape),
            Inner::Area(_) => self.by_differences(shape),
        }
    }

    fn by_adjoint(&self, form: &ShapeForm, shape: &[f64]) -> Result<(f64, Vec<f64>), MethodError> {
        let Extremal { patch, matrix } = self.extremal(form, shape)?;
        let (x, at) = (patch.net().coordinates(), self.family.coordinates(shape)?);
        let Varied { value, by_points, held } = self.outer_varied(&patch, at)?;
        let partition = Partition::new(self.net.fixed());
        let free = partition.free();
        let rhs: Vec<f64> = free.iter().flat_map(|&k| by_points[3 * k..3 * k + 3].to_vec()).collect();
        let factor = Cholesky::new(free.len(), &partition.free_block(matrix.as_slice())?)?;
        let adjoint = factor.solve(3, &rhs)?.x;
        let mut gradient = held;
        for (k, g) in gradient.iter_mut().enumerate() {
            let moved = applied(&form.derivative(at, k), &x);
            let along = free
                .iter()
                .enumerate()
                .map(|(row, &k)| dot(&adjoint[3 * row..3 * row + 3], &moved[3 * k..3 * k + 3]));
            *g -= along.sum::<f64>();
        }
        Ok((value, self.family.by_parameters(gradient)))
    }

    /// Central differences, one-sided ones at the ends of the admissible shapes.
    fn by_differences(&self, shape: &[f64]) -> Result<(f64, Vec<f64>), MethodError> {
        let (value, (least, most)) = (self.value(shape)?, self.family.range());
        let mut gradient = vec![0.0; shape.len()];
        for (k, g) in gradient.iter_mut().enumerate() {
            let (mut below, mut above) = (shape.to_vec(), shape.to_vec());
            (below[k], above[k]) = ((shape[k] - STEP).max(least), (shape[k] + STEP).min(most));
            *g = (self.value(&above)? - self.value(&below)?) / (above[k] - below[k]);
        }
        Ok((value, gradient))
    }
}

/// The symmetric matrix over the points, applied to each coordinate.
fn applied(matrix: &Matrix, x: &[f64]) -> Vec<f64> {
    let mut image = vec![0.0; x.len()];
    for (i, image) in image.chunks_exact_mut(3).enumerate() {
        for (q, point) in matrix.row(i).iter().zip(x.chunks_exact(3)) {
            image.iter_mut().zip(point).for_each(|(sum, c)| *sum += q * c);
        }
    }
    image
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

impl Objective for Composed<'_> {
    fn dimension(&self) -> usize {
        self.family.parameters().len()
    }

    fn evaluate(&self, points: &[f64], values: &mut [f64]) {
        for (shape, value) in points.chunks_exact(Objective::dimension(self)).zip(values) {
            *value = self.value(shape).unwrap_or(f64::NAN);
        }
    }
}

impl Smooth for Composed<'_> {
    fn dimension(&self) -> usize {
        self.family.parameters().len()
    }

    fn value_and_gradient(&self, point: &[f64], gradient: &mut [f64]) -> f64 {
        match self.gradient(point) {
            Ok((value, by_shape)) => {
                gradient.copy_from_slice(&by_shape);
                value
            }
            Err(_) => f64::NAN,
        }
    }
}

#[cfg(test)]
mod tests {
    use surfaces::Point;

    use super::*;
    /// The net of GT Example 5.1.
    fn net() -> Net {
        let points = |rows: [[f64; 3]; 4]| rows.map(Point::from);
        Net::from_boundary(
            &points([[0.0, 0.0, 0.0], [2.0, 0.0, 2.0], [4.0, 0.0, -2.0], [6.0, 0.0, 0.0]]),
            &points([[0.0, 6.0, 0.0], [2.0, 6.0, 2.0], [4.0, 6.0, -2.0], [6.0, 6.0, 0.0]]),
            &points([[0.0, 0.0, 0.0], [0.0, 2.0, 2.0], [0.0, 4.0, -2.0], [0.0, 6.0, 0.0]]),
            &points([[6.0, 0.0, 0.0], [6.0, 2.0, 2.0], [6.0, 4.0, -2.0], [6.0, 6.0, 0.0]]),
        )
        .expect("a sound boundary")
    }

    fn composed(family: ShapedFamily, inner: Energy, outer: impl Into<SearchEnergy>) -> Composed<'static> {
        let net = net();
        let inner = match inner {
            Energy::Quadratic(functional) => {
                Inner::Quadratic(form(functional, family, &net).expect("offered"))
            }
            Energy::Area => Inner::Area(LeastArea::new(&net, family, 1e-11, &())),
        };
        Composed::new(&net, family, inner, outer.into()).expect("offered")
    }

    #[test]
    fn the_gradient_is_that_of_the_value() {
        let shape = [0.7, 1.9, 1.2, 2.6];
        for family in ShapedFamily::ALL {
            for (inner, outer) in [
                (Functional::Dirichlet, Energy::Quadratic(Functional::Laplacian).into()),
                (Functional::Bending, Energy::Quadratic(Functional::Dirichlet).into()),
                (Functional::Laplacian, Energy::Area.into()),
                (Functional::Dirichlet, Energy::Area.into()),
                (Functional::Coons, Energy::Quadratic(Functional::Bending).into()),
                (Functional::Dirichlet, SearchEnergy::Conformality),
                (Functional::Bending, SearchEnergy::Conformality),
            ] {
                let composed = composed(family, Energy::Quadratic(inner), outer);
                let (value, gradient) = composed.gradient(&shape).expect("solvable");
                assert_eq!(value, composed.value(&shape).expect("solvable"));
                let scale = gradient.iter().fold(0.0_f64, |m, g| m.max(g.abs()));
                for (k, g) in gradient.into_iter().enumerate() {
                    let at = |h: f64| {
                        let mut moved = shape;
                        moved[k] += h;
                        composed.value(&moved).expect("solvable")
                    };
                    let h = 1e-4;
                    let difference = (8.0 * (at(h) - at(-h)) - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h);
                    assert!(
                        (g - difference).abs() < 1e-7 * (scale + value.abs()),
                        "{inner:?} {outer:?} {k}: {g} {difference}"
                    );
                }
            }
        }
    }

    #[test]
    fn the_energy_of_its_own_extremal_is_its_minimum() {
        let shape = [1.1, 0.6, 2.4, 3.1];
        let energies =
            [Functional::Dirichlet, Functional::Laplacian, Functional::Bending].map(Energy::Quadratic);
        for energy in energies {
            let least = composed(ShapedFamily::Gt, energy, energy).value(&shape).expect("solvable");
            for other in energies {
                let of_other = composed(ShapedFamily::Gt, other, energy).value(&shape).expect("solvable");
                assert!(least <= of_other * (1.0 + 1e-13), "{energy:?} of the extremal of {other:?}");
            }
        }
    }
}
