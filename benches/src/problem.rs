use energy::{Functional, GramPolynomial, ShapeForm, ShapedPatch};
use solve::{ParametricProblem, PolynomialMatrix, Term};
use surfaces::Net;

use crate::FixtureError;

/// The Dirichlet energy of GT patches over `net`, its interior free.
///
/// # Errors
/// Those of [`ShapeForm::of`]: degrees below 2 or too large.
pub fn gt_dirichlet(net: &Net) -> Result<ParametricProblem, FixtureError> {
    let form = ShapeForm::of(Functional::Dirichlet, ShapedPatch::Gt, net.degrees())?;
    Ok(parametric_problem(&form, net))
}

/// The numbers of a shape form over a net, its interior free, as [`solve::Parametric`] takes them.
pub fn parametric_problem(form: &ShapeForm, net: &Net) -> ParametricProblem {
    let matrix = |gram: &GramPolynomial| PolynomialMatrix {
        rows: gram.coefficients[0].rows(),
        cols: gram.coefficients[0].cols(),
        coefficients: gram.coefficients.each_ref().map(|c| c.as_slice().to_vec()),
    };
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

/// Indices 1 … degree − 1 of the functions that vanish at both ends.
pub fn interior(degree: usize) -> Vec<usize> {
    (1..degree).collect()
}
