//! The displacement of the second variation's smallest value.

use bases::GaussLegendre;
use surfaces::{Domain, Face, Jet, Net, Patch, Point, TensorPatch, TrianglePatch};

use crate::{MethodError, Surface};

/// Share of the largest coefficient from which on another counts as being as large: rounding must not choose the sign.
const AS_LARGE: f64 = 1e-6;

/// Points of the rule of the quotient in each direction, beside twice the degree.
const POINTS: usize = 16;

/// A displacement f along the unit normal, in the functions of a surface: one coefficient a control point, in the order of the
/// net or the complex, 0 at those that stay. The largest size of a coefficient is 1, and the first that has it is positive.
///
/// The unit normal is x_u × x_v of a patch; on a complex those of its faces turned round as [`surfaces::Orientation`] says.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    coefficients: Vec<f64>,
}

impl Mode {
    /// The displacement with coefficients in these proportions; none if they are all 0, or one is not finite.
    #[must_use]
    pub fn new(mut coefficients: Vec<f64>) -> Option<Self> {
        if coefficients.iter().any(|c| !c.is_finite()) {
            return None;
        }
        let largest = coefficients.iter().fold(0.0f64, |largest, c| largest.max(c.abs()));
        let first = *coefficients.iter().find(|c| c.abs() >= (1.0 - AS_LARGE) * largest)?;
        if largest == 0.0 {
            return None;
        }
        let scale = largest.copysign(first);
        // Not −0 where nothing moves.
        coefficients.iter_mut().for_each(|c| *c = if *c == 0.0 { 0.0 } else { *c / scale });
        Some(Self { coefficients })
    }

    /// One number a control point.
    #[must_use]
    pub fn coefficients(&self) -> &[f64] {
        &self.coefficients
    }

    /// The function f as surfaces over the parameters of `surface`: one of a patch, one a face of a complex. The first
    /// coordinate of their points is f, the others are 0. None if `surface` has another number of control points, or is one of several
    /// pieces.
    ///
    /// # Errors
    /// [`MethodError`] if a patch cannot be made.
    pub fn functions(&self, surface: &Surface) -> Result<Option<Vec<Box<dyn Patch>>>, MethodError> {
        let points: Vec<Point> = self.coefficients.iter().map(|&f| Point::new(f, 0.0, 0.0)).collect();
        let all = || points.iter().flat_map(|&p| <[f64; 3]>::from(p)).collect::<Vec<f64>>();
        Ok(match surface {
            Surface::Tensor(patch) if patch.net().points().len() == points.len() => {
                let net = patch.net().with_coordinates(&all())?;
                Some(vec![Box::new(patch.with_net(net)?)])
            }
            Surface::Triangle(patch) if patch.net().points().len() == points.len() => {
                Some(vec![Box::new(TrianglePatch::new(patch.net().with_coordinates(&all())?)?)])
            }
            Surface::Complex(complex) if complex.points().len() == points.len() => {
                let count = complex.degree() + 1;
                let of_face = |face: &Face| -> Result<Box<dyn Patch>, MethodError> {
                    let net = Net::new(count, count, face.nodes().iter().map(|&k| points[k]).collect())?;
                    Ok(Box::new(TensorPatch::bernstein(net)?))
                };
                Some(complex.faces().iter().map(of_face).collect::<Result<_, _>>()?)
            }
            Surface::Tensor(_) | Surface::Triangle(_) | Surface::Complex(_) | Surface::Pieces(_) => None,
        })
    }

    /// `∫ (|∇f|² + 2 K f²) dA / ∫ |∇f|² dA` over a surface: the second variation of its area along f, by a rule of its own. None
    /// where [`Self::functions`] are none, or the surface is singular at a point of the rule.
    ///
    /// # Errors
    /// As [`Self::functions`].
    pub fn second_variation(&self, surface: &Surface) -> Result<Option<f64>, MethodError> {
        let Some(functions) = self.functions(surface)? else { return Ok(None) };
        let patches: Vec<Box<dyn Patch>> = match surface {
            Surface::Tensor(patch) => vec![Box::new(patch.clone())],
            Surface::Triangle(patch) => vec![Box::new(patch.clone())],
            Surface::Complex(complex) => {
                let patch = |face| Ok::<_, MethodError>(Box::new(complex.patch(face)?) as Box<dyn Patch>);
                (0..complex.faces().len()).map(patch).collect::<Result<_, _>>()?
            }
            Surface::Pieces(_) => return Ok(None),
        };
        let (m, n) = surface.degrees();
        let rule = GaussLegendre::new(2 * m.max(n) + POINTS)?;
        let (mut whole, mut gradient) = (0.0, 0.0);
        for (patch, function) in patches.iter().zip(&functions) {
            for ([u, v], weight) in points(patch.domain(), &rule) {
                let Some([of_gradient, of_curvature]) = densities(&patch.jet(u, v), &function.jet(u, v))
                else {
                    return Ok(None);
                };
                gradient += weight * of_gradient;
                whole += weight * (of_gradient + of_curvature);
            }
        }
        Ok((gradient > 0.0).then_some(whole / gradient))
    }
}

/// The points of a rule over a domain with their weights.
fn points(domain: Domain, rule: &GaussLegendre) -> Vec<([f64; 2], f64)> {
    let on = |(start, end): (f64, f64)| rule.clone().on(start, end).iter().collect::<Vec<_>>();
    match domain {
        Domain::Rectangle { u, v } => {
            let of_v = on(v);
            on(u).into_iter().flat_map(|(u, a)| of_v.iter().map(move |&(v, b)| ([u, v], a * b))).collect()
        }
        // A square with one side drawn into a corner.
        Domain::Triangle => {
            let unit = on((0.0, 1.0));
            let line = |&(s, a): &(f64, f64)| {
                unit.iter().map(move |&(t, b)| ([s, (1.0 - s) * t], a * b * (1.0 - s))).collect::<Vec<_>>()
            };
            unit.iter().flat_map(line).collect()
        }
    }
}

/// `|∇f|² dA` and `2 K f² dA` at a point of a surface.
fn densities(jet: &Jet, function: &Jet) -> Option<[f64; 2]> {
    let form = jet.first_form();
    let density = jet.area_density();
    let (f, f_u, f_v) = (function.point.x, function.u.x, function.v.x);
    let square = form.g * f_u * f_u - 2.0 * form.f * f_u * f_v + form.e * f_v * f_v;
    Some([square / density, 2.0 * jet.gauss_curvature()? * f * f * density])
}
