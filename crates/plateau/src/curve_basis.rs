//! The basis of a curve.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use bases::{Aht, At, Basis, BasisFamily, Bernstein, Gt};

use crate::MethodError;
use crate::curve_function::CurveEnd;

/// The basis of a curve: a family with parameters that it has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurveBasis(Of);

/// A family with its parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Of {
    Bernstein,
    Gt { shape: [f64; 2] },
    Aht { span: f64 },
    At { span: f64 },
}

impl CurveBasis {
    /// Bernstein polynomials on [0, 1].
    pub const BERNSTEIN: Self = Self(Of::Bernstein);

    /// GT functions on [0, 1] with the shape parameters (θ1, θ2), each in [0, 4], not both zero (GT).
    ///
    /// # Errors
    /// [`MethodError::Basis`] for others.
    pub fn gt(shape: [f64; 2]) -> Result<Self, MethodError> {
        Gt::check_shape(shape)?;
        Ok(Self(Of::Gt { shape }))
    }

    /// Algebraic–hyperbolic–trigonometric functions of order 6 on [0, `span`], below [`Aht::SUPREMUM`](bases::Aht::SUPREMUM) (AHT).
    ///
    /// # Errors
    /// [`MethodError::Basis`] for another span.
    pub fn aht(span: f64) -> Result<Self, MethodError> {
        Aht::new(span)?;
        Ok(Self(Of::Aht { span }))
    }

    /// Algebraic–trigonometric functions of order 6 on [0, `span`], below [`At::SUPREMUM`](bases::At::SUPREMUM), 2π (AT).
    ///
    /// # Errors
    /// [`MethodError::Basis`] for another span.
    pub fn at(span: f64) -> Result<Self, MethodError> {
        At::new(span)?;
        Ok(Self(Of::At { span }))
    }

    /// The shape parameters of GT functions; none of other families.
    #[must_use]
    pub fn shape(&self) -> Option<[f64; 2]> {
        match self.0 {
            Of::Gt { shape } => Some(shape),
            Of::Bernstein | Of::Aht { .. } | Of::At { .. } => None,
        }
    }

    /// The interval on which the basis lives.
    #[must_use]
    pub fn domain(&self) -> [f64; 2] {
        match self.0 {
            Of::Bernstein | Of::Gt { .. } => [0.0, 1.0],
            Of::Aht { span } | Of::At { span } => [0.0, span],
        }
    }

    /// Its functions of degree `degree`, one more than the degree; AHT and AT have six whatever it is.
    ///
    /// # Errors
    /// [`MethodError::Basis`] for a degree that the family does not have.
    pub fn functions(&self, degree: usize) -> Result<Arc<dyn Basis>, MethodError> {
        Ok(match self.0 {
            Of::Bernstein => Arc::new(Bernstein::new(degree)?),
            Of::Gt { shape } => Arc::new(Gt::new(degree, shape)?),
            Of::Aht { span } => Arc::new(Aht::new(span)?),
            Of::At { span } => Arc::new(At::new(span)?),
        })
    }

    /// In words, with its parameters: `GT, degree 3, θ = (1, 2)`.
    #[must_use]
    pub fn described(&self, degree: usize) -> String {
        let title = self.family().title();
        match self.0 {
            Of::Bernstein => format!("{title}, degree {degree}"),
            Of::Gt { shape: [first, second] } => {
                format!("{title}, degree {degree}, θ = ({first}, {second})")
            }
            Of::Aht { span } | Of::At { span } => format!("{title}, span {span}"),
        }
    }

    /// The bases of a family with these parameters, one for each shape of GT functions or span of AHT and AT functions; with parameters that
    /// the papers draw where none is given.
    ///
    /// ```
    /// use plateau::{BasisFamily, CurveBasis};
    ///
    /// let bases = CurveBasis::of_family(BasisFamily::Gt, &[[0.5, 0.5], [1.0, 2.0]], &[])?;
    /// assert_eq!(bases[1].shape(), Some([1.0, 2.0]));
    /// assert!(CurveBasis::of_family(BasisFamily::At, &[[0.5, 0.5]], &[]).is_err());
    /// # Ok::<(), plateau::MethodError>(())
    /// ```
    ///
    /// # Errors
    /// [`MethodError::Parameters`] for shapes or spans that are no parameters of the family, [`MethodError::Basis`] for values that it does
    /// not have.
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
        match family {
            BasisFamily::Bernstein => Ok(vec![Self::BERNSTEIN]),
            BasisFamily::Gt => shapes.iter().copied().map(Self::gt).collect(),
            BasisFamily::Aht => spans(TAU).into_iter().map(Self::aht).collect(),
            BasisFamily::At => spans(PI).into_iter().map(Self::at).collect(),
        }
    }

    /// The family, without parameters.
    #[must_use]
    pub fn family(&self) -> BasisFamily {
        match self.0 {
            Of::Bernstein => BasisFamily::Bernstein,
            Of::Gt { .. } => BasisFamily::Gt,
            Of::Aht { .. } => BasisFamily::Aht,
            Of::At { .. } => BasisFamily::At,
        }
    }

    /// The six control points of the one curve in the space of the AHT or AT functions that has these ends. None for Bernstein and GT, whose
    /// spaces depend on the degree.
    #[must_use]
    pub fn control_points(&self, [start, end]: [CurveEnd; 2]) -> Option<Vec<[f64; 3]>> {
        let coordinate = |d: usize| -> Option<[f64; 6]> {
            let jets = [start.map(|p| p[d]), end.map(|p| p[d])];
            match self.0 {
                Of::Aht { span } => Aht::new(span).ok().map(|basis| basis.control_values(jets)),
                Of::At { span } => At::new(span).ok().map(|basis| basis.control_values(jets)),
                Of::Bernstein | Of::Gt { .. } => None,
            }
        };
        let (x, y, z) = (coordinate(0)?, coordinate(1)?, coordinate(2)?);
        Some((0..6).map(|k| [x[k], y[k], z[k]]).collect())
    }
}
