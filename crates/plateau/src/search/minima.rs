//! The reduced energy of large nets: the extremal itself at every shape.

use bases::GaussLegendre;
use energy::Functional;
use optim::{Objective, Smooth};
use surfaces::{Jet, Net, Patch as _, Point, TensorPatch};

use super::shape_derivative::ShapeDerivatives;
use crate::interior::{bubbles, with_shape};
use crate::{Method, MethodError};

/// `J(α) = min E(P; α)` over the free points, E a quadratic energy: solved for in bubbles and integrated over the patch found.
///
/// Some milliseconds a shape at degree 30, where tables of Gram matrices have lost all digits. The gradient is the partial derivative by
/// the shape, the net held (the envelope theorem): `2 Σ c ∫ ∂S · ∂(∂S/∂α_k)`.
pub(super) struct Minima {
    net: Net,
    method: Method,
    functional: Functional,
    derivatives: ShapeDerivatives,
}

impl Minima {
    pub(super) fn new(net: &Net, method: &Method, functional: Functional) -> Result<Self, MethodError> {
        let derivatives = ShapeDerivatives::new(method.patch, net.degrees())?;
        Ok(Self { net: net.clone(), method: method.clone(), functional, derivatives })
    }

    fn extremal(&self, shape: [f64; 4]) -> Result<TensorPatch, MethodError> {
        let patch = with_shape(self.net.clone(), &self.method, Some(shape))?;
        Ok(bubbles::extremal(&patch, self.functional, &self.method, Some(shape))?.0)
    }

    /// The energy as a form of two patches of these families: `Σ c ∫ ∂^a S · ∂^b T`.
    fn form(&self, s: &TensorPatch, t: &TensorPatch) -> Result<f64, MethodError> {
        let (m, n) = self.net.degrees();
        let [u, v] = s.rectangle();
        let rule = |degree: usize, (start, end): (f64, f64)| -> Result<_, MethodError> {
            Ok(GaussLegendre::new(bases::Samples::points_for(degree + 1))?.on(start, end))
        };
        let (rule_u, rule_v) = (rule(m, u)?, rule(n, v)?);
        let nodes = |rule: &GaussLegendre| rule.iter().map(|(t, _)| t).collect::<Vec<_>>();
        let (us, vs) = (nodes(&rule_u), nodes(&rule_v));
        let mut sum = 0.0;
        for (k, (s, t)) in s.jets(&us, &vs).iter().zip(&t.jets(&us, &vs)).enumerate() {
            let density: f64 = self
                .functional
                .terms()
                .iter()
                .map(|term| {
                    let part = |jet: &Jet, a, b| -> Point { bubbles::derivative(jet, a, b) };
                    term.coefficient * part(s, term.u.0, term.v.0).dot(part(t, term.u.1, term.v.1))
                })
                .sum();
            sum += rule_u.weight(k / vs.len()) * rule_v.weight(k % vs.len()) * density;
        }
        Ok(sum)
    }
}

impl Objective for Minima {
    fn dimension(&self) -> usize {
        4
    }

    fn evaluate(&self, points: &[f64], values: &mut [f64]) {
        for (point, value) in points.chunks_exact(4).zip(values) {
            let found =
                self.extremal(std::array::from_fn(|k| point[k])).and_then(|patch| self.form(&patch, &patch));
            *value = found.unwrap_or(f64::NAN);
        }
    }
}

impl Smooth for Minima {
    fn dimension(&self) -> usize {
        4
    }

    fn value_and_gradient(&self, point: &[f64], gradient: &mut [f64]) -> f64 {
        let found = self.extremal(std::array::from_fn(|k| point[k])).and_then(|patch| {
            for (k, g) in gradient.iter_mut().enumerate() {
                *g = 2.0 * self.form(&patch, &self.derivatives.of(&patch, k)?)?;
            }
            self.form(&patch, &patch)
        });
        found.unwrap_or(f64::NAN)
    }
}

#[cfg(test)]
mod tests {
    use energy::ShapedPatch;

    use super::*;
    use crate::search::ReducedEnergy;
    use crate::{Basis, Energy, Interior, Patch, ReferenceTriangle, SearchMode, Shape, SolverChoice};

    fn net() -> Net {
        let points = |rows: [[f64; 3]; 4]| rows.map(Point::from);
        Net::from_boundary(
            &points([[0.0, 0.0, 0.0], [2.0, 0.0, 2.0], [4.0, 0.0, -2.0], [6.0, 0.0, 0.0]]),
            &points([[0.0, 6.0, 0.0], [2.0, 6.0, 2.0], [4.0, 6.5, -1.0], [6.0, 6.0, 0.0]]),
            &points([[0.0, 0.0, 0.0], [0.0, 2.0, 2.0], [0.0, 4.0, -2.0], [0.0, 6.0, 0.0]]),
            &points([[6.0, 0.0, 0.0], [6.0, 2.0, 2.0], [6.0, 4.0, -2.0], [6.0, 6.0, 0.0]]),
        )
        .expect("a sound boundary")
    }

    fn method(patch: Patch, energy: Energy) -> Method {
        Method {
            name: "minima".into(),
            patch,
            basis: Basis::Gt,
            shape: Shape::Search(SearchMode::Polish),
            interior: Interior::Extremal { energy, metric_steps: 0 },
            search_energy: energy,
            raise: 0,
            solver: SolverChoice::Auto,
            domain: ReferenceTriangle::Right,
            tolerance: 1e-10,
            bound: false,
        }
    }

    #[test]
    fn minima_are_those_of_the_parametric_system() {
        let shape = [0.7, 1.9, 1.2, 2.6];
        for (patch, kind) in [(Patch::Tensor, ShapedPatch::Gt), (Patch::TbCoons, ShapedPatch::TbCoons)] {
            for energy in [Energy::Dirichlet, Energy::Laplacian, Energy::Bending, Energy::Coons] {
                let functional = energy.functional().expect("a quadratic energy");
                for raise in [0, 3] {
                    let net = net().raised(raise);
                    let minima = Minima::new(&net, &method(patch, energy), functional).expect("offered");
                    let tables = ReducedEnergy::new(functional, kind, &net).expect("offered");
                    let (mut ours, mut theirs) = ([0.0; 4], [0.0; 4]);
                    let value = minima.value_and_gradient(&shape, &mut ours);
                    let known = tables.value_and_gradient(&shape, &mut theirs);
                    assert!((value / known - 1.0).abs() < 1e-11, "{patch:?} {energy:?}: {value} {known}");
                    for (a, b) in ours.iter().zip(theirs) {
                        assert!((a - b).abs() < 1e-9 * known, "{patch:?} {energy:?}: {ours:?} {theirs:?}");
                    }
                    let mut batch = [0.0; 2];
                    minima.evaluate(&[shape, [1.0; 4]].concat(), &mut batch);
                    assert_eq!(batch[0], value);
                }
            }
        }
    }

    #[test]
    fn gradients_hold_at_high_degrees() {
        let shape = [0.7, 1.9, 1.2, 2.6];
        for (patch, energy, raise) in [
            (Patch::Tensor, Energy::Bending, 20),
            (Patch::TbCoons, Energy::Dirichlet, 20),
            (Patch::Tensor, Energy::Dirichlet, 45),
        ] {
            let net = net().raised(raise);
            let functional = energy.functional().expect("a quadratic energy");
            let minima = Minima::new(&net, &method(patch, energy), functional).expect("offered");
            let mut gradient = [0.0; 4];
            let value = minima.value_and_gradient(&shape, &mut gradient);
            let scale = gradient.iter().fold(0.0f64, |m, g| m.max(g.abs()));
            for (k, g) in gradient.into_iter().enumerate() {
                let at = |h: f64| {
                    let (mut moved, mut out) = (shape, [0.0]);
                    moved[k] += h;
                    minima.evaluate(&moved, &mut out);
                    out[0]
                };
                let h = 1e-3;
                let difference = (8.0 * (at(h) - at(-h)) - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h);
                assert!(
                    (g - difference).abs() < 1e-7 * (scale + value),
                    "{patch:?} {energy:?} {k}: {g} {difference}"
                );
            }
        }
    }
}
