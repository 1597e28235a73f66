//! The deformation of a right helicoid into a catenoid (AHT §5).

use std::f64::consts::FRAC_PI_2;

use crate::{Helicoid, Pieces, SurfaceError};

/// How (a, b) moves from (1, 0), the right helicoid, to (0, 1), the catenoid, for λ from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DeformationPath {
    /// `(1 − λ, λ)`.
    Linear,
    /// `(cos(λπ/2), sin(λπ/2))`: an isometric bending, the metric `cosh² u (du² + dv²)` is constant. (AHT Fig. 5 prints 2/π.)
    Trigonometric,
    /// The outer Bernstein polynomials `((1 − λ)ⁿ, λⁿ)`, n ≥ 1.
    Bernstein {
        /// The degree n.
        degree: u32,
    },
}

impl DeformationPath {
    /// (a, b) at λ; exactly (1, 0) at 0 and (0, 1) at 1, and λ → 1 − λ swaps them.
    pub fn weights(self, lambda: f64) -> [f64; 2] {
        let weight = |x: f64| match self {
            Self::Linear => x,
            Self::Trigonometric => libm::sin(FRAC_PI_2 * x),
            Self::Bernstein { degree } => libm::pow(x, f64::from(degree)),
        };
        [weight(1.0 - lambda), weight(lambda)]
    }
}

/// The deformation of the right helicoid over `[0, u_span] × [0, v_span]` into the catenoid: every surface between is a
/// generalized helicoid, hence minimal, and its net is linear in (a, b).
///
/// ```
/// use surfaces::{Deformation, DeformationPath, Mesh};
/// let deformation = Deformation::new(DeformationPath::Trigonometric, 1.5, 6.0)?;
/// for surface in deformation.frames(5) {
///     assert_eq!(Mesh::of(&surface?, 8).triangles.len(), 128);
/// }
/// # Ok::<(), surfaces::SurfaceError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Deformation {
    path: DeformationPath,
    spans: [f64; 2],
    helicoid: Pieces,
    catenoid: Pieces,
}

impl Deformation {
    /// The deformation along `path`; spans beyond [`Helicoid::LARGEST_PIECE`] are cut into pieces.
    ///
    /// # Errors
    /// As for [`Helicoid::new`] and [`Helicoid::pieces`]; [`SurfaceError::Basis`] for a Bernstein path of degree 0.
    pub fn new(path: DeformationPath, u_span: f64, v_span: f64) -> Result<Self, SurfaceError> {
        if path == (DeformationPath::Bernstein { degree: 0 }) {
            let max = bases::Bernstein::MAX_DEGREE;
            return Err(bases::BasisError::Degree { family: "Bernstein", degree: 0, min: 1, max }.into());
        }
        let end = |a: f64, b: f64| Helicoid::new(a, b, u_span, v_span)?.pieces();
        Ok(Self { path, spans: [u_span, v_span], helicoid: end(1.0, 0.0)?, catenoid: end(0.0, 1.0)? })
    }

    /// The path.
    pub fn path(&self) -> DeformationPath {
        self.path
    }

    /// The closed form of the surface at λ.
    ///
    /// # Errors
    /// [`SurfaceError::Weights`] if (a, b) is not finite or vanishes.
    pub fn closed_form(&self, lambda: f64) -> Result<Helicoid, SurfaceError> {
        let [a, b] = self.path.weights(lambda);
        Helicoid::new(a, b, self.spans[0], self.spans[1])
    }

    /// The surface at λ, its nets interpolated between those of helicoid and catenoid.
    ///
    /// # Errors
    /// [`SurfaceError::Weights`] if (a, b) is not finite or vanishes (λⁿ may underflow), [`SurfaceError::NotFinite`] on
    /// overflow.
    pub fn surface(&self, lambda: f64) -> Result<Pieces, SurfaceError> {
        let [a, b] = self.closed_form(lambda)?.weights();
        self.helicoid.combined(a, &self.catenoid, b)
    }

    /// The surfaces at `count` equally spaced λ from 0 to 1; one frame is the helicoid. Each is made when asked for.
    pub fn frames(&self, count: usize) -> impl Iterator<Item = Result<Pieces, SurfaceError>> + '_ {
        let last = count.saturating_sub(1).max(1);
        (0..count).map(move |k| self.surface(k as f64 / last as f64))
    }
}
