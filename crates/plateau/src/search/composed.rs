//! An energy of the extremal of another, as a function of the shape.

use bases::Matrix;
use energy::{Functional, ShapeForm, ShapedPatch, area_with_gradient};
use optim::{Objective, Smooth};
use solve::{Cholesky, Partition, solve_partitioned};
use surfaces::{Net, TensorPatch};

use super::least_area::LeastArea;
use crate::interior::with_shape;
use crate::{Method, MethodError, Patch, Progress};

/// `F(x(α), α)`, where x(α) minimises another energy E over the free points at shape α: what a search asks whose energy is not
/// that of the extremal.
///
/// With `E = Xᵀ Q X` the net follows the shape by `Q_ff ∂x = −(∂Q X)_f`. One more solve, `Q_ff λ = F_x`, gives the gradient
/// `∂F − λ · (∂Q X)_f` in all parameters.
pub(super) struct Composed<'a> {
    net: Net,
    method: Method,
    inner: Inner,
    outer: Outer,
    area: LeastArea<'a>,
}

enum Inner {
    /// A quadratic energy.
    Quadratic(ShapeForm),
    /// The area. Its extremal follows the shape by no linear system of full rank: points move along the surface at no cost.
    Area,
}

enum Outer {
    Quadratic(ShapeForm),
    Area,
}

/// The net of the extremal at one shape, and the matrix Q there, over all points.
struct Extremal {
    patch: TensorPatch,
    matrix: Matrix,
}

/// Half the distance of the two shapes whose values make a derivative where there is no formula for it.
const STEP: f64 = 1e-3;

impl<'a> Composed<'a> {
    /// The energy `outer` of the extremal of `inner`; none stands for the area.
    pub(super) fn new(
        net: &Net,
        method: &Method,
        inner: Option<Functional>,
        outer: Option<Functional>,
        progress: &'a dyn Progress,
    ) -> Result<Self, MethodError> {
        let kind = match method.patch {
            Patch::TbCoons => ShapedPatch::TbCoons,
            Patch::Tensor | Patch::Triangle => ShapedPatch::Gt,
        };
        let form = |functional| ShapeForm::of(functional, kind, net.degrees());
        Ok(Self {
            net: net.clone(),
            method: method.clone(),
            inner: inner.map(form).transpose()?.map_or(Inner::Area, Inner::Quadratic),
            outer: outer.map(form).transpose()?.map_or(Outer::Area, Outer::Quadratic),
            area: LeastArea::new(net, method, progress)?,
        })
    }

    fn extremal(&self, form: &ShapeForm, shape: [f64; 4]) -> Result<Extremal, MethodError> {
        let (matrix, partition) = (form.matrix(shape), Partition::new(self.net.fixed()));
        let solution =
            solve_partitioned(matrix.rows(), matrix.as_slice(), &partition, 3, &self.net.coordinates())?;
        let net = self.net.with_coordinates(&solution.x)?;
        Ok(Extremal { patch: with_shape(net, &self.method, Some(shape))?, matrix })
    }

    /// F of a patch at a shape.
    fn outer_value(&self, patch: &TensorPatch, shape: [f64; 4]) -> Result<f64, MethodError> {
        Ok(match &self.outer {
            Outer::Quadratic(form) => {
                let x = patch.net().coordinates();
                dot(&x, &applied(&form.matrix(shape), &x))
            }
            Outer::Area => energy::area(patch)?.value,
        })
    }

    fn value(&self, shape: [f64; 4]) -> Result<f64, MethodError> {
        let patch = match &self.inner {
            Inner::Quadratic(form) => self.extremal(form, shape)?.patch,
            Inner::Area => self.area.extremal(shape)?.0,
        };
        self.outer_value(&patch, shape)
    }

    fn gradient(&self, shape: [f64; 4]) -> Result<(f64, [f64; 4]), MethodError> {
        match &self.inner {
            Inner::Quadratic(form) => self.by_adjoint(form, shape),
            Inner::Area => self.by_differences(shape),
        }
    }

    fn by_adjoint(&self, form: &ShapeForm, shape: [f64; 4]) -> Result<(f64, [f64; 4]), MethodError> {
        let Extremal { patch, matrix } = self.extremal(form, shape)?;
        let x = patch.net().coordinates();
        // The value, its derivatives by the points, and by the shape with the points held.
        let (value, by_points, held) = match &self.outer {
            Outer::Quadratic(outer) => {
                let image = applied(&outer.matrix(shape), &x);
                let held = std::array::from_fn(|k| dot(&x, &applied(&outer.derivative(shape, k), &x)));
                (dot(&x, &image), image.iter().map(|c| 2.0 * c).collect(), held)
            }
            Outer::Area => {
                let (area, gradient) = area_with_gradient(&patch)?;
                let mut held = [0.0; 4];
                for (k, held) in held.iter_mut().enumerate() {
                    *held = self.area.derivative(&patch, k, area.points)?;
                }
                (area.value, gradient, held)
            }
        };
        let partition = Partition::new(self.net.fixed());
        let free = partition.free();
        let rhs: Vec<f64> = free.iter().flat_map(|&k| by_points[3 * k..3 * k + 3].to_vec()).collect();
        let factor = Cholesky::new(free.len(), &partition.free_block(matrix.as_slice())?)?;
        let adjoint = factor.solve(3, &rhs)?.x;
        let mut gradient = held;
        for (k, g) in gradient.iter_mut().enumerate() {
            let moved = applied(&form.derivative(shape, k), &x);
            let along = free
                .iter()
                .enumerate()
                .map(|(row, &k)| dot(&adjoint[3 * row..3 * row + 3], &moved[3 * k..3 * k + 3]));
            *g -= along.sum::<f64>();
        }
        Ok((value, gradient))
    }

    /// Central differences, one-sided ones at the ends of the admissible shapes.
    fn by_differences(&self, shape: [f64; 4]) -> Result<(f64, [f64; 4]), MethodError> {
        let value = self.value(shape)?;
        let mut gradient = [0.0; 4];
        for (k, g) in gradient.iter_mut().enumerate() {
            let (mut below, mut above) = (shape, shape);
            (below[k], above[k]) = ((shape[k] - STEP).max(0.0), (shape[k] + STEP).min(4.0));
            *g = (self.value(above)? - self.value(below)?) / (above[k] - below[k]);
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
        4
    }

    fn evaluate(&self, points: &[f64], values: &mut [f64]) {
        for (point, value) in points.chunks_exact(4).zip(values) {
            *value = self.value(std::array::from_fn(|k| point[k])).unwrap_or(f64::NAN);
        }
    }
}

impl Smooth for Composed<'_> {
    fn dimension(&self) -> usize {
        4
    }

    fn value_and_gradient(&self, point: &[f64], gradient: &mut [f64]) -> f64 {
        match self.gradient(std::array::from_fn(|k| point[k])) {
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
    use crate::{Basis, Energy, Interior, SearchMode, Shape, SolverChoice};

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

    fn method(patch: Patch, energy: Energy, search_energy: Energy) -> Method {
        Method {
            name: "composed".into(),
            patch,
            basis: Basis::Gt,
            shape: Shape::Search(SearchMode::Polish),
            interior: Interior::Extremal { energy, metric_steps: 0 },
            search_energy,
            raise: 0,
            solver: SolverChoice::Auto,
            domain: energy::ReferenceTriangle::Right,
            tolerance: 1e-11,
            bound: false,
        }
    }

    fn composed(method: &Method) -> Composed<'_> {
        let inner = method.extremal_energy().and_then(Energy::functional);
        Composed::new(&net(), method, inner, method.search_energy.functional(), &()).expect("offered")
    }

    #[test]
    fn the_gradient_is_that_of_the_value() {
        let shape = [0.7, 1.9, 1.2, 2.6];
        for patch in [Patch::Tensor, Patch::TbCoons] {
            for (inner, outer) in [
                (Energy::Dirichlet, Energy::Laplacian),
                (Energy::Bending, Energy::Dirichlet),
                (Energy::Laplacian, Energy::Area),
                (Energy::Dirichlet, Energy::Area),
                (Energy::Coons, Energy::Bending),
            ] {
                let method = method(patch, inner, outer);
                let composed = composed(&method);
                let (value, gradient) = composed.gradient(shape).expect("solvable");
                assert_eq!(value, composed.value(shape).expect("solvable"));
                let scale = gradient.iter().fold(0.0_f64, |m, g| m.max(g.abs()));
                for (k, g) in gradient.into_iter().enumerate() {
                    let at = |h: f64| {
                        let mut moved = shape;
                        moved[k] += h;
                        composed.value(moved).expect("solvable")
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
        for energy in [Energy::Dirichlet, Energy::Laplacian, Energy::Bending] {
            let own = method(Patch::Tensor, energy, energy);
            let least = composed(&own).value(shape).expect("solvable");
            for other in [Energy::Dirichlet, Energy::Laplacian, Energy::Bending] {
                let of_other =
                    composed(&method(Patch::Tensor, other, energy)).value(shape).expect("solvable");
                assert!(least <= of_other * (1.0 + 1e-13), "{energy:?} of the extremal of {other:?}");
            }
        }
    }
}
