//! Curves by formula: functions of the AHT and AT spaces, whose control points follow from their ends.

use bases::{Aht, At};

use crate::CurveBasis;

/// A curve by its name, over 0 ≤ t ≤ span.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurveFunction {
    /// (cos t, sin t).
    Circle,
    /// (cos t, sin t, t).
    Helix,
    /// (t − sin t, 1 − cos t).
    Cycloid,
    /// (t cos t, t sin t), the spiral of Archimedes.
    Spiral,
    /// (t cos t, t sin t, t), AT Figure 1.
    ConicalSpiral,
    /// (t, cosh t).
    Catenary,
    /// (cosh t, sinh t), a branch of a hyperbola.
    Hyperbola,
}

/// Point, first and second derivative of a curve.
pub type CurveEnd = [[f64; 3]; 3];

impl CurveFunction {
    /// Coordinates of its points: 2 or 3.
    #[must_use]
    pub fn dimension(self) -> usize {
        match self {
            Self::Circle | Self::Cycloid | Self::Spiral | Self::Catenary | Self::Hyperbola => 2,
            Self::Helix | Self::ConicalSpiral => 3,
        }
    }

    /// Whether it lies in the space of the functions, so that they give it exactly.
    #[must_use]
    pub fn is_in(self, basis: &CurveBasis) -> bool {
        match (self, basis) {
            (_, CurveBasis::Bernstein | CurveBasis::Gt { .. }) => false,
            (Self::Circle | Self::Helix | Self::Cycloid, CurveBasis::Aht { .. } | CurveBasis::At { .. }) => {
                true
            }
            (Self::Spiral | Self::ConicalSpiral, basis) => matches!(basis, CurveBasis::At { .. }),
            (Self::Catenary | Self::Hyperbola, basis) => matches!(basis, CurveBasis::Aht { .. }),
        }
    }

    /// Point, first and second derivative at t.
    #[must_use]
    pub fn jet(self, t: f64) -> CurveEnd {
        let (s, c, sh, ch) = (libm::sin(t), libm::cos(t), libm::sinh(t), libm::cosh(t));
        match self {
            Self::Circle => [[c, s, 0.0], [-s, c, 0.0], [-c, -s, 0.0]],
            Self::Helix => [[c, s, t], [-s, c, 1.0], [-c, -s, 0.0]],
            Self::Cycloid => [[t - s, 1.0 - c, 0.0], [1.0 - c, s, 0.0], [s, c, 0.0]],
            Self::Spiral | Self::ConicalSpiral => {
                let z = if self == Self::Spiral { [0.0, 0.0] } else { [t, 1.0] };
                [[t * c, t * s, z[0]], [c - t * s, s + t * c, z[1]], [-2.0 * s - t * c, 2.0 * c - t * s, 0.0]]
            }
            Self::Catenary => [[t, ch, 0.0], [1.0, sh, 0.0], [0.0, ch, 0.0]],
            Self::Hyperbola => [[ch, sh, 0.0], [sh, ch, 0.0], [ch, sh, 0.0]],
        }
    }
}

impl CurveBasis {
    /// The six control points of the one curve in the space of the AHT or AT functions that has these ends. None for Bernstein and GT, whose
    /// spaces depend on the degree, and for a span that the family does not have.
    #[must_use]
    pub fn control_points(&self, [start, end]: [CurveEnd; 2]) -> Option<Vec<[f64; 3]>> {
        let coordinate = |d: usize| -> Option<[f64; 6]> {
            let jets = [start.map(|p| p[d]), end.map(|p| p[d])];
            match *self {
                Self::Aht { span } => Aht::new(span).ok().map(|basis| basis.control_values(jets)),
                Self::At { span } => At::new(span).ok().map(|basis| basis.control_values(jets)),
                Self::Bernstein | Self::Gt { .. } => None,
            }
        };
        let (x, y, z) = (coordinate(0)?, coordinate(1)?, coordinate(2)?);
        Some((0..6).map(|k| [x[k], y[k], z[k]]).collect())
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::{Curve, sample};

    const ALL: [CurveFunction; 7] = [
        CurveFunction::Circle,
        CurveFunction::Helix,
        CurveFunction::Cycloid,
        CurveFunction::Spiral,
        CurveFunction::ConicalSpiral,
        CurveFunction::Catenary,
        CurveFunction::Hyperbola,
    ];

    proptest! {
        #[test]
        fn the_control_points_give_the_function_where_it_is_in_the_space(span in 0.01..6.0f64, share in 0.0..1.0f64) {
            let mut exact = 0;
            for basis in [CurveBasis::Aht { span }, CurveBasis::At { span }] {
                for function in ALL {
                    let points = basis.control_points([function.jet(0.0), function.jet(span)]).unwrap();
                    let points = points.into_iter().map(surfaces::Point::from).collect();
                    let curve = Curve::new(basis, points, vec![share * span]).unwrap();
                    let found = sample(&curve).unwrap().jets[0];
                    let [point, d1, d2] = function.jet(share * span);
                    let scale = span.exp();
                    let near = |a: surfaces::Point, b: [f64; 3], by: f64| a.distance(b.into()) <= by * scale;
                    if function.is_in(&basis) {
                        exact += 1;
                        prop_assert!(near(found.point, point, 1e-13), "{function:?} {basis:?}");
                        prop_assert!(near(found.d1, d1, 1e-12 / span) && near(found.d2, d2, 1e-11 / span / span));
                    }
                }
            }
            prop_assert_eq!(exact, 10);
        }
    }

    #[test]
    fn what_is_not_in_the_space_is_not_given_by_it() {
        for (function, basis) in [
            (CurveFunction::Spiral, CurveBasis::Aht { span: 5.0 }),
            (CurveFunction::Catenary, CurveBasis::At { span: 5.0 }),
        ] {
            let points = basis.control_points([function.jet(0.0), function.jet(5.0)]).unwrap();
            let points = points.into_iter().map(surfaces::Point::from).collect();
            let curve = Curve::new(basis, points, vec![2.5]).unwrap();
            let found = sample(&curve).unwrap().jets[0];
            assert!(!function.is_in(&basis) && found.point.distance(function.jet(2.5)[0].into()) > 1e-3);
        }
        assert!(CurveBasis::Bernstein.control_points([CurveFunction::Circle.jet(0.0); 2]).is_none());
    }
}
