//! A quadratic energy, minimised over the interior, as a function of the shape parameters.

use energy::{Functional, GramPolynomial, ShapeForm};
use optim::{Objective, Smooth};
use solve::{Parametric, ParametricProblem, Path, PolynomialMatrix, Term};
use surfaces::{Net, ShapedFamily, TensorPatch};

use super::at_shapes::AtShapes;
use crate::MethodError;

/// `J(α) = min_P E(P; α)`: a quadratic energy of patches of a family over a net, minimised over its free points, as a function of
/// the shape α of the family. What joins the energies, the linear systems and the searches: `optim` minimises it, values by
/// the batch, gradients by the envelope theorem.
///
/// ```
/// use energy::Functional;
/// use optim::{Bounds, Pso};
/// use plateau::ReducedEnergy;
/// use surfaces::{Net, Patch, Point, ShapedFamily};
///
/// // The boundary of GT Example 5.1.
/// let row = |y: f64| [[0., y, 0.], [2., y, 2.], [4., y, -2.], [6., y, 0.]].map(Point::from);
/// let column = |x: f64| [[x, 0., 0.], [x, 2., 2.], [x, 4., -2.], [x, 6., 0.]].map(Point::from);
/// let net = Net::from_boundary(&row(0.), &row(6.), &column(0.), &column(6.))?;
///
/// let energy = ReducedEnergy::new(Functional::Dirichlet, ShapedFamily::Gt, &net)?;
/// let swarm = Pso { particles: 50, iterations: 100, ..Pso::new(7) };
/// let best = swarm.run(&energy, &Bounds::cube(4, 0.5, 3.5)?, 0, &())?.best.expect("J is finite in the box");
/// assert!((best.value - 37.4395612).abs() < 1e-4);
/// let patch = energy.extremal(&best.point)?;
/// assert!((patch.point(0.5, 0.5).x - 3.0).abs() < 1e-2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct ReducedEnergy {
    reduced: AtShapes<Parametric>,
    net: Net,
}

impl ReducedEnergy {
    /// Contracts the fixed points of the net once; the path of the arithmetic is [`Path::detect`].
    ///
    /// # Errors
    /// [`MethodError::Energy`] for degrees below 2, [`MethodError::Solve`] for more than 400 free points.
    pub fn new(functional: Functional, family: ShapedFamily, net: &Net) -> Result<Self, MethodError> {
        let form = ShapeForm::of(functional, family, net.degrees())?;
        let minimum = Parametric::new(&problem(&form, net))?;
        Ok(Self { reduced: AtShapes { minimum, family }, net: net.clone() })
    }

    /// The same, evaluated on a chosen path.
    ///
    /// # Errors
    /// [`MethodError::Solve`] if this machine does not have it.
    pub fn with_path(self, path: Path) -> Result<Self, MethodError> {
        let AtShapes { minimum, family } = self.reduced;
        Ok(Self { reduced: AtShapes { minimum: minimum.with_path(path)?, family }, ..self })
    }

    /// The path that evaluations take: results repeat bit for bit on the same one only.
    pub fn path(&self) -> Path {
        self.system().path()
    }

    /// The linear systems behind it.
    pub fn system(&self) -> &Parametric {
        &self.reduced.minimum
    }

    /// The patch of least energy at a shape.
    ///
    /// # Errors
    /// [`MethodError::Surface`] for a shape that the family does not have, [`MethodError::Solve`] where the energy is not positive definite to
    /// working precision.
    pub fn extremal(&self, shape: &[f64]) -> Result<TensorPatch, MethodError> {
        let family = self.reduced.family;
        let solution = self.system().solve(&family.coordinates(shape)?)?;
        Ok(family.patch(self.net.with_coordinates(&solution.x)?, shape)?)
    }
}

/// The numbers of a form over a net. If no point is free, J is the energy itself.
fn problem(form: &ShapeForm, net: &Net) -> ParametricProblem {
    let matrix = |gram: &GramPolynomial| PolynomialMatrix {
        rows: gram.coefficients[0].rows(),
        cols: gram.coefficients[0].cols(),
        coefficients: gram.coefficients.each_ref().map(|c| c.as_slice().to_vec()),
    };
    let solved_for = net.fixed().contains(&false);
    let interior = |degree: usize| if solved_for { (1..degree).collect() } else { Vec::new() };
    let (m, n) = net.degrees();
    ParametricProblem {
        left: form.left.iter().map(matrix).collect(),
        right: form.right.iter().map(matrix).collect(),
        terms: form
            .terms
            .iter()
            .map(|t| Term { coefficient: t.coefficient, left: t.left, right: t.right })
            .collect(),
        free_left: interior(m),
        free_right: interior(n),
        values: net.coordinates(),
    }
}

impl Objective for ReducedEnergy {
    fn dimension(&self) -> usize {
        Objective::dimension(&self.reduced)
    }

    fn evaluate(&self, points: &[f64], values: &mut [f64]) {
        self.reduced.evaluate(points, values);
    }
}

impl Smooth for ReducedEnergy {
    fn dimension(&self) -> usize {
        Smooth::dimension(&self.reduced)
    }

    fn value_and_gradient(&self, point: &[f64], gradient: &mut [f64]) -> f64 {
        self.reduced.value_and_gradient(point, gradient)
    }
}
