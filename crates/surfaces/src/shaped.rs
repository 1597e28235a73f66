//! Families of tensor patches with shape parameters: one table of them, which whatever builds, searches, reads or names them follows.

use std::borrow::Cow;
use std::ops::Range;
use std::sync::Arc;

use bases::{Basis, BasisError, BasisFamily, Gt, GtBubbles, GtParts, Lobatto, Matrix, Stacked};

use crate::{Net, Product, SurfaceError, TensorPatch, bernstein_less_blend, end_blend, tb_coons};

/// The enum, the list of its variants, which none can be left out of, and their titles.
macro_rules! shaped_families {
    ($($(#[$meaning:meta])* $variant:ident = $title:literal;)*) => {
        /// A family of tensor patches whose functions have shape parameters.
        ///
        /// What a family is, is said here and nowhere else: its words, its parameters, its patch, how the shape moves its functions, its
        /// functions that vanish on the border.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum ShapedFamily {
            $($(#[$meaning])* $variant,)*
        }

        impl ShapedFamily {
            /// Every family.
            pub const ALL: [Self; [$($title),*].len()] = [$(Self::$variant),*];

            /// What a sentence calls its functions.
            #[must_use]
            pub const fn title(self) -> &'static str {
                match self {
                    $(Self::$variant => $title,)*
                }
            }
        }
    };
}

shaped_families! {
    /// Tensor products of generalized trigonometric functions (GT (3.2)).
    Gt = "the GT basis";
    /// The Bernstein–GT Coons blend (GT §7).
    TbCoons = "the TB–Coons blend";
}

/// How the shape moves a family of N functions in one direction.
#[derive(Debug, Clone)]
pub enum ShapeFactor {
    /// Affine in two coordinates: 3N functions, the constant parts, then those of the first and of the second coordinate.
    Affine(Arc<dyn Basis>),
    /// Not at all: the N functions.
    Constant(Arc<dyn Basis>),
}

impl ShapeFactor {
    /// The 3N functions of the affine layout; those of the coordinates vanish if the shape does not move the family.
    ///
    /// # Errors
    /// [`BasisError`] never in fact: the map has as many columns as the family functions.
    pub fn affine(&self) -> Result<Arc<dyn Basis>, BasisError> {
        match self {
            Self::Affine(parts) => Ok(parts.clone()),
            Self::Constant(basis) => {
                let n = basis.count();
                let map = Matrix::from_fn(3 * n, n, |i, j| f64::from(u8::from(i == j)));
                Ok(Arc::new(Stacked::new(vec![basis.clone()], map)?))
            }
        }
    }

    /// The derivative by coordinate `k` (0 or 1): N functions; none if the shape does not move the family.
    fn derivative(&self, k: usize) -> Result<Option<Arc<dyn Basis>>, BasisError> {
        let Self::Affine(parts) = self else { return Ok(None) };
        let n = parts.count() / 3;
        let map = Matrix::from_fn(n, 3 * n, |i, j| f64::from(u8::from(j == (k + 1) * n + i)));
        Ok(Some(Arc::new(Stacked::new(vec![parts.clone()], map)?)))
    }
}

impl ShapedFamily {
    /// The word of tensor products.
    pub const TENSOR: &'static str = "tensor";

    /// The words of the kinds of tensor patches; those of blends with their families.
    pub const PATCHES: [(&'static str, Option<Self>); 2] =
        [(Self::TENSOR, None), (Self::TbCoons.names().0, Some(Self::TbCoons))];

    /// The words of the bases of tensor products; all but Bernstein polynomials with their families.
    pub const BASES: [(&'static str, Option<Self>); 2] =
        [(BasisFamily::Bernstein.name(), None), (Self::Gt.names().1, Some(Self::Gt))];

    /// The words of the kind of patch and of the basis.
    #[must_use]
    pub const fn names(self) -> (&'static str, &'static str) {
        match self {
            Self::Gt => (Self::TENSOR, BasisFamily::Gt.name()),
            Self::TbCoons => ("tb-coons", BasisFamily::Gt.name()),
        }
    }

    /// Whether a patch is a sum of several products of families.
    #[must_use]
    pub const fn is_blend(self) -> bool {
        match self {
            Self::Gt => false,
            Self::TbCoons => true,
        }
    }

    /// The names of its shape parameters, those in u before those in v.
    #[must_use]
    pub const fn parameters(self) -> &'static [&'static str] {
        match self {
            Self::Gt | Self::TbCoons => &["α1", "α2", "β1", "β2"],
        }
    }

    /// The range of each parameter.
    #[must_use]
    pub const fn range(self) -> (f64, f64) {
        match self {
            Self::Gt | Self::TbCoons => Gt::SHAPES,
        }
    }

    /// The smallest range that holds the parameters of every family.
    pub const WIDEST_RANGE: (f64, f64) = {
        let (mut least, mut most) = Self::ALL[0].range();
        let mut k = 1;
        while k < Self::ALL.len() {
            let (from, to) = Self::ALL[k].range();
            (least, most) = (least.min(from), most.max(to));
            k += 1;
        }
        (least, most)
    };

    /// The least degree in each direction.
    #[must_use]
    pub const fn least_degree(self) -> usize {
        match self {
            Self::Gt | Self::TbCoons => 2,
        }
    }

    /// The patch of `net` with a shape, one number for each of [`parameters`](Self::parameters).
    ///
    /// # Errors
    /// [`SurfaceError::ShapeCount`] for another number of them, [`SurfaceError::Basis`] for a degree too low or a shape out of range.
    pub fn patch(self, net: Net, shape: &[f64]) -> Result<TensorPatch, SurfaceError> {
        let shape = self.coordinates(shape)?;
        match self {
            Self::Gt => TensorPatch::gt(net, shape),
            Self::TbCoons => tb_coons(net, shape),
        }
    }

    /// What is wrong with a shape, whatever the degree, and which of its parameters are at fault: the first fault that there is.
    ///
    /// ```
    /// use bases::BasisError;
    /// use surfaces::ShapedFamily;
    ///
    /// assert_eq!(ShapedFamily::Gt.fault(&[1.0, 2.0, 0.0, 0.0]), Some((2..4, BasisError::Dependent)));
    /// assert_eq!(ShapedFamily::Gt.fault(&[1.0, 0.0, 0.0, 3.0]), None);
    /// ```
    #[must_use]
    pub fn fault(self, shape: &[f64]) -> Option<(Range<usize>, BasisError)> {
        match self {
            Self::Gt | Self::TbCoons => shape.chunks_exact(2).enumerate().find_map(|(k, pair)| {
                Gt::check_shape([pair[0], pair[1]]).err().map(|error| (2 * k..2 * k + 2, error))
            }),
        }
    }

    /// How many [`coordinates`](Self::coordinates) there are: two in u, then two in v.
    pub const COORDINATES: usize = 4;

    /// Which of the [`coordinates`](Self::coordinates) each parameter is.
    const fn places(self) -> &'static [usize] {
        match self {
            Self::Gt | Self::TbCoons => &[0, 1, 2, 3],
        }
    }

    /// The shape in the coordinates in which the functions are affine, two in u and two in v, whatever its parameters are; those that no
    /// parameter is are 0.
    ///
    /// # Errors
    /// [`SurfaceError::ShapeCount`] unless there is one number for each parameter.
    pub fn coordinates(self, shape: &[f64]) -> Result<[f64; Self::COORDINATES], SurfaceError> {
        self.has_whole_shapes(shape, 1)?;
        let mut coordinates = [0.0; Self::COORDINATES];
        self.places().iter().zip(shape).for_each(|(&place, &parameter)| coordinates[place] = parameter);
        Ok(coordinates)
    }

    /// The coordinates of many shapes, one after the other.
    ///
    /// # Errors
    /// [`SurfaceError::ShapeCount`] unless `shapes` holds whole shapes.
    pub fn coordinates_of_all(self, shapes: &[f64]) -> Result<Cow<'_, [f64]>, SurfaceError> {
        let count = self.places().len();
        self.has_whole_shapes(shapes, shapes.len() / count)?;
        if count == Self::COORDINATES {
            return Ok(Cow::Borrowed(shapes));
        }
        let mut all = Vec::with_capacity(Self::COORDINATES * (shapes.len() / count));
        for shape in shapes.chunks_exact(count) {
            all.extend(self.coordinates(shape)?);
        }
        Ok(Cow::Owned(all))
    }

    fn has_whole_shapes(self, shapes: &[f64], count: usize) -> Result<(), SurfaceError> {
        let expected = self.places().len();
        if shapes.len() == count * expected {
            return Ok(());
        }
        Err(SurfaceError::ShapeCount { family: self.title(), expected, found: shapes.len() })
    }

    /// A derivative by the [`coordinates`](Self::coordinates) as one by the parameters: the transpose of their Jacobian matrix.
    #[must_use]
    pub fn by_parameters(self, by_coordinates: [f64; Self::COORDINATES]) -> Vec<f64> {
        self.places().iter().map(|&place| by_coordinates[place]).collect()
    }

    /// The products whose sum is a patch of degrees `(m, n)`, in the order of its [`products`](TensorPatch::products), each factor as
    /// far as the shape moves it.
    ///
    /// # Errors
    /// [`SurfaceError::Basis`] for a degree that is not offered.
    pub fn factors(self, (m, n): (usize, usize)) -> Result<Vec<[ShapeFactor; 2]>, SurfaceError> {
        let gt =
            |degree| -> Result<_, BasisError> { Ok(ShapeFactor::Affine(Arc::new(GtParts::new(degree)?))) };
        let less = |degree| -> Result<_, SurfaceError> {
            Ok(ShapeFactor::Constant(Arc::new(bernstein_less_blend(degree)?)))
        };
        let ends =
            |degree| -> Result<_, SurfaceError> { Ok(ShapeFactor::Constant(Arc::new(end_blend(degree)?))) };
        Ok(match self {
            Self::Gt => vec![[gt(m)?, gt(n)?]],
            Self::TbCoons => vec![[less(m)?, gt(n)?], [gt(m)?, less(n)?], [ends(m)?, ends(n)?]],
        })
    }

    /// The derivatives of `patch`, one of this family, by its [`coordinates`](Self::coordinates), the net held: patches of their own.
    ///
    /// # Errors
    /// [`SurfaceError::Size`] if `patch` is none of this family.
    pub fn derivatives(self, patch: &TensorPatch) -> Result<[TensorPatch; Self::COORDINATES], SurfaceError> {
        let factors = self.factors(patch.net().degrees())?;
        let by = |k: usize| -> Result<TensorPatch, SurfaceError> {
            let mut products = Vec::new();
            for ([u, v], whole) in factors.iter().zip(patch.products()) {
                let moved = if k < 2 { u.derivative(k)? } else { v.derivative(k - 2)? };
                products.extend(moved.map(|moved| match k < 2 {
                    true => Product { u: moved, v: whole.v.clone() },
                    false => Product { u: whole.u.clone(), v: moved },
                }));
            }
            TensorPatch::new(products, patch.net().clone())
        };
        Ok([by(0)?, by(1)?, by(2)?, by(3)?])
    }

    /// The products of well-conditioned functions that span what the free points of a patch of degrees `(m, n)` move: as many as there
    /// are free points, with the control points of [`Lobatto`] functions in each direction.
    ///
    /// # Errors
    /// [`SurfaceError::ShapeCount`], [`SurfaceError::Basis`].
    pub fn bubbles(self, (m, n): (usize, usize), shape: &[f64]) -> Result<Vec<Product>, SurfaceError> {
        let [a1, a2, b1, b2] = self.coordinates(shape)?;
        let gt = |degree, shape| -> Result<Arc<dyn Basis>, BasisError> {
            Ok(Arc::new(GtBubbles::new(degree, shape)?))
        };
        Ok(match self {
            Self::Gt => vec![Product { u: gt(m, [a1, a2])?, v: gt(n, [b1, b2])? }],
            // B − ℓ is B in the interior, and ℓ ⊗ ℓ nothing.
            Self::TbCoons => vec![
                Product { u: polynomial_bubbles(m)?, v: gt(n, [b1, b2])? },
                Product { u: gt(m, [a1, a2])?, v: polynomial_bubbles(n)? },
            ],
        })
    }
}

/// The polynomials of degree `degree` that vanish at 0 and 1, as integrals of Legendre polynomials.
///
/// # Errors
/// [`BasisError::Degree`] for a degree that is not offered.
pub fn polynomial_bubbles(degree: usize) -> Result<Arc<dyn Basis>, BasisError> {
    Ok(Arc::new(Lobatto::new(degree.saturating_sub(1), (0.0, 1.0))?))
}
