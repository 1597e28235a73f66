//! The basis of a curve.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use bases::{Aht, At, Basis, BasisFamily, Bernstein, Gt};

use crate::MethodError;
use crate::curve_function::CurveEnd;

/// The basis of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CurveBasis {
    /// Bernstein polynomials on [0, 1].
    Bernstein,
    /// GT functions on [0, 1] (GT).
    Gt {
        /// Shape parameters (θ1, θ2), each in [0, 4], not both zero.
        shape: [f64; 2],
    },
    /// Algebraic–hyperbolic–trigonometric functions of order 6 on [0, span] (AHT).
    Aht {
        /// Right end of the domain, below `bases::Aht::SUPREMUM`.
        span: f64,
    },
    /// Algebraic–trigonometric functions of order 6 on [0, span] (AT).
    At {
        /// Right end of the domain, below `bases::At::SUPREMUM`, 2π.
        span: f64,
    },
}

impl CurveBasis {
    /// The interval on which the basis lives.
    #[must_use]
    pub fn domain(&self) -> [f64; 2] {
        match *self {
            Self::Bernstein | Self::Gt { .. } => [0.0, 1.0],
            Self::Aht { span } | Self::At { span } => [0.0, span],
        }
    }

    /// Its functions of degree `degree`, one more than the degree; AHT and AT have six whatever it is.
    ///
    /// # Errors
    /// [`MethodError::Basis`] for a degree or parameters that the family does not have.
    pub fn functions(&self, degree: usize) -> Result<Arc<dyn Basis>, MethodError> {
        Ok(match *self {
            Self::Bernstein => Arc::new(Bernstein::new(degree)?),
            Self::Gt { shape } => Arc::new(Gt::new(degree, shape)?),
            Self::Aht { span } => Arc::new(Aht::new(span)?),
            Self::At { span } => Arc::new(At::new(span)?),
        })
    }

    /// In words, with its parameters: `GT, degree 3, θ = (1, 2)`.
    #[must_use]
    pub fn described(&self, degree: usize) -> String {
        let title = self.family().title();
        match *self {
            Self::Bernstein => format!("{title}, degree {degree}"),
            Self::Gt { shape: [first, second] } => {
                format!("{title}, degree {degree}, θ = ({first}, {second})")
            }
            Self::Aht { span } | Self::At { span } => format!("{title}, span {span}"),
        }
    }

    /// The bases of a family with these parameters, one for each shape of GT functions or span of AHT and AT functions; with parameters that
    /// the papers draw where none is given.
    ///
    /// ```
    /// use plateau::{BasisFamily, CurveBasis};
    ///
    /// let bases = CurveBasis::of_family(BasisFamily::Gt, &[[0.5, 0.5], [1.0, 2.0]], &[])?;
    /// assert_eq!(bases[1], CurveBasis::Gt { shape: [1.0, 2.0] });
    /// assert!(CurveBasis::of_family(BasisFamily::At, &[[0.5, 0.5]], &[]).is_err());
    /// # Ok::<(), plateau::MethodError>(())
    /// ```
    ///
    /// # Errors
    /// [`MethodError::Parameters`] for shapes or spans that are no parameters of the family.
    pub fn of_family(
        family: BasisFamily,
        shapes: &[[f64; 2]],
        spans: &[f64],
    ) -> Result<Vec<Self>, MethodError> {
        if (!shapes.is_empty() && !family.has_shape()) || (!spans.is_empty() && family.spans().is_none()) {
            return Err(MethodError::Parameters { family });
        }
        let spans = |default: f64| if spans.is_empty() { vec![default] } else { spans.to_vec() };
        let shapes = if shapes.is_empty() { &[[1.0, 1.0]] } else { shapes };
        Ok(match family {
            BasisFamily::Bernstein => vec![Self::Bernstein],
            BasisFamily::Gt => shapes.iter().map(|&shape| Self::Gt { shape }).collect(),
            BasisFamily::Aht => spans(TAU).into_iter().map(|span| Self::Aht { span }).collect(),
            BasisFamily::At => spans(PI).into_iter().map(|span| Self::At { span }).collect(),
        })
    }

    /// The family, without parameters.
    #[must_use]
    pub fn family(&self) -> BasisFamily {
        match self {
            Self::Bernstein => BasisFamily::Bernstein,
            Self::Gt { .. } => BasisFamily::Gt,
            Self::Aht { .. } => BasisFamily::Aht,
            Self::At { .. } => BasisFamily::At,
        }
    }

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
