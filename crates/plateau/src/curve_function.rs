//! Curves by formula: functions of the AHT and AT spaces, whose control points follow from their ends.

use bases::BasisFamily;

/// The enum, its list, which no variant can be left out of, and the names.
macro_rules! curve_functions {
    ($($(#[$meaning:meta])* $variant:ident = $name:literal;)*) => {
        /// A curve by its name, over 0 ≤ t ≤ span.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum CurveFunction {
            $($(#[$meaning])* $variant,)*
        }

        impl CurveFunction {
            /// Every curve with its name.
            pub const NAMES: [(&'static str, Self); [$($name),*].len()] = [$(($name, Self::$variant)),*];

            /// Its name in files.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name,)*
                }
            }
        }
    };
}

curve_functions! {
    /// (cos t, sin t).
    Circle = "circle";
    /// (cos t, sin t, t).
    Helix = "helix";
    /// (t − sin t, 1 − cos t).
    Cycloid = "cycloid";
    /// (t cos t, t sin t), the spiral of Archimedes.
    Spiral = "spiral";
    /// (t cos t, t sin t, t), AT Figure 1.
    ConicalSpiral = "conical-spiral";
    /// (t, cosh t).
    Catenary = "catenary";
    /// (cosh t, sinh t), a branch of a hyperbola.
    Hyperbola = "hyperbola";
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

    /// The families in whose space it lies, so that they give it exactly.
    #[must_use]
    pub const fn families(self) -> &'static [BasisFamily] {
        match self {
            Self::Circle | Self::Helix | Self::Cycloid => &[BasisFamily::Aht, BasisFamily::At],
            Self::Spiral | Self::ConicalSpiral => &[BasisFamily::At],
            Self::Catenary | Self::Hyperbola => &[BasisFamily::Aht],
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

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::{Curve, CurveBasis, sample};

    proptest! {
        #[test]
        fn the_control_points_give_the_function_where_it_is_in_the_space(span in 0.01..6.0f64, share in 0.0..1.0f64) {
            let mut exact = 0;
            for basis in [CurveBasis::aht(span).unwrap(), CurveBasis::at(span).unwrap()] {
                for (_, function) in CurveFunction::NAMES {
                    let points = basis.control_points([function.jet(0.0), function.jet(span)]).unwrap();
                    let points = points.into_iter().map(surfaces::Point::from).collect();
                    let curve = Curve::new(basis, points, vec![share * span]).unwrap();
                    let found = sample(&curve).unwrap().samples()[0].jet;
                    let [point, d1, d2] = function.jet(share * span);
                    let scale = span.exp();
                    let near = |a: surfaces::Point, b: [f64; 3], by: f64| a.distance(b.into()) <= by * scale;
                    if function.families().contains(&basis.family()) {
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
            (CurveFunction::Spiral, CurveBasis::aht(5.0).unwrap()),
            (CurveFunction::Catenary, CurveBasis::at(5.0).unwrap()),
        ] {
            let points = basis.control_points([function.jet(0.0), function.jet(5.0)]).unwrap();
            let points = points.into_iter().map(surfaces::Point::from).collect();
            let curve = Curve::new(basis, points, vec![2.5]).unwrap();
            let found = sample(&curve).unwrap().samples()[0].jet;
            assert!(
                !function.families().contains(&basis.family())
                    && found.point.distance(function.jet(2.5)[0].into()) > 1e-3
            );
        }
        assert!(CurveBasis::BERNSTEIN.control_points([CurveFunction::Circle.jet(0.0); 2]).is_none());
    }
}
