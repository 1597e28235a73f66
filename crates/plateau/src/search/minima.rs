//! The reduced energy of large nets: the extremal itself at every shape.

use bases::GaussLegendre;
use energy::Functional;
use optim::{Objective, Smooth};
use surfaces::{Jet, Net, Patch as _, Point, ShapedFamily, TensorPatch};

use crate::interior::bubbles;
use crate::{FixedShape, MethodError};

/// `J(α) = min E(P; α)` over the free points, E a quadratic energy: solved for in bubbles and integrated over the patch found.
///
/// Some milliseconds a shape at degree 30, where tables of Gram matrices have lost all digits. The gradient is the partial derivative by
/// the shape, the net held (the envelope theorem): `2 Σ c ∫ ∂S · ∂(∂S/∂α_k)`.
pub(super) struct Minima {
    net: Net,
    family: ShapedFamily,
    functional: Functional,
}

impl Minima {
    pub(super) fn new(net: &Net, family: ShapedFamily, functional: Functional) -> Self {
        Self { net: net.clone(), family, functional }
    }

    fn extremal(&self, shape: &[f64]) -> Result<TensorPatch, MethodError> {
        let shape = FixedShape::new(self.family, shape.to_vec())?;
        let patch = self.family.patch(self.net.clone(), shape.parameters())?;
        Ok(bubbles::extremal(&patch, self.functional, Some(&shape))?.0)
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
                    let part = |jet: &Jet, a, b| -> Point { jet.derivative(a, b) };
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
        self.family.parameters().len()
    }

    fn evaluate(&self, points: &[f64], values: &mut [f64]) {
        for (shape, value) in points.chunks_exact(Objective::dimension(self)).zip(values) {
            let found = self.extremal(shape).and_then(|patch| self.form(&patch, &patch));
            *value = found.unwrap_or(f64::NAN);
        }
    }
}

impl Smooth for Minima {
    fn dimension(&self) -> usize {
        self.family.parameters().len()
    }

    fn value_and_gradient(&self, shape: &[f64], gradient: &mut [f64]) -> f64 {
        let found = self.extremal(shape).and_then(|patch| {
            let mut by_coordinates = [0.0; ShapedFamily::COORDINATES];
            for (derivative, direction) in by_coordinates.iter_mut().zip(&self.family.derivatives(&patch)?) {
                *derivative = 2.0 * self.form(&patch, direction)?;
            }
            gradient.copy_from_slice(&self.family.by_parameters(by_coordinates));
            self.form(&patch, &patch)
        });
        found.unwrap_or(f64::NAN)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::search::ReducedEnergy;

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

    #[test]
    fn minima_are_those_of_the_parametric_system() {
        let shape = [0.7, 1.9, 1.2, 2.6];
        for family in ShapedFamily::ALL {
            for functional in Functional::ALL {
                for raise in [0, 3] {
                    let net = net().raised(raise);
                    let minima = Minima::new(&net, family, functional);
                    let tables = ReducedEnergy::new(functional, family, &net).expect("offered");
                    let (mut ours, mut theirs) = ([0.0; 4], [0.0; 4]);
                    let value = minima.value_and_gradient(&shape, &mut ours);
                    let known = tables.value_and_gradient(&shape, &mut theirs);
                    assert!(
                        (value / known - 1.0).abs() < 1e-11,
                        "{family:?} {functional:?}: {value} {known}"
                    );
                    for (a, b) in ours.iter().zip(theirs) {
                        assert!(
                            (a - b).abs() < 1e-9 * known,
                            "{family:?} {functional:?}: {ours:?} {theirs:?}"
                        );
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
        for (family, functional, raise) in [
            (ShapedFamily::Gt, Functional::Bending, 20),
            (ShapedFamily::TbCoons, Functional::Dirichlet, 20),
            (ShapedFamily::Gt, Functional::Dirichlet, 45),
        ] {
            let net = net().raised(raise);
            let minima = Minima::new(&net, family, functional);
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
                    "{family:?} {functional:?} {k}: {g} {difference}"
                );
            }
        }
    }
}
