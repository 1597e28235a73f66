use thiserror::Error;

/// Why a family of functions or a quadrature rule could not be made.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum BasisError {
    /// The degree lies outside what the family is defined, or accurate, for.
    #[error("degree {degree} of the {family} basis is not offered: {min} to {max} are")]
    Degree {
        /// Name of the family.
        family: &'static str,
        /// The degree asked for.
        degree: usize,
        /// Smallest degree of the family.
        min: usize,
        /// Largest degree supported.
        max: usize,
    },
    /// A shape parameter of the GT basis makes a function negative or is not a number.
    #[error("GT shape parameter θ{index} = {value:?} is outside [{}, {}], where the basis is nonnegative", range.0, range.1)]
    Shape {
        /// 1 for θ1 (acts at t = 0), 2 for θ2 (acts at t = 1).
        index: usize,
        /// The value given.
        value: f64,
        /// Where it would be.
        range: (f64, f64),
    },
    /// Both GT shape parameters are zero: G₁ of degree 2 vanishes and the functions are dependent.
    #[error(
        "GT shape parameters θ1 and θ2 are both 0: the functions are linearly dependent; make one positive"
    )]
    Dependent,
    /// The span of an AHT or AT basis is too short, not a number, or at or beyond the sharp bound.
    #[error(
        "span α = {span:?} of the {family} basis is outside {min:?} ≤ α < {supremum:?} ({meaning}), where its functions are \
         positive; split longer intervals into equal pieces"
    )]
    Span {
        /// Name of the family.
        family: &'static str,
        /// The span asked for.
        span: f64,
        /// Smallest span offered.
        min: f64,
        /// The sharp bound, itself not admissible.
        supremum: f64,
        /// What the bound is.
        meaning: &'static str,
    },
    /// A family has no subdivision: restricted to a part of its domain it is not of its own kind.
    #[error(
        "this family of functions cannot be subdivided: restricted to a part of its domain it is another family; \
         Bernstein, AHT and AT can"
    )]
    NotSubdivisible,
    /// A family cannot be cut at an end of its domain, outside it or at what is not a number.
    #[error("cannot subdivide at {cut:?}: it must lie strictly between {start:?} and {end:?}")]
    Cut {
        /// The parameter asked for.
        cut: f64,
        /// Start of the domain.
        start: f64,
        /// End of the domain.
        end: f64,
    },
    /// A Gauss rule of that many points is not offered.
    #[error("a Gauss–Legendre rule has 1 to {max} points, not {points}")]
    Points {
        /// The number of points asked for.
        points: usize,
        /// Largest rule supported.
        max: usize,
    },
    /// The matrix of a [`Stacked`](crate::Stacked) family does not fit its parts.
    #[error("the map of a stacked family needs {expected} columns (functions of its parts), got {found}")]
    Map {
        /// Number of functions of all parts together.
        expected: usize,
        /// Columns of the matrix given.
        found: usize,
    },
    /// Parts of one family live on different intervals.
    #[error("part {part} of a stacked family lives on another interval than part 0")]
    Domain {
        /// Index of the first part that differs.
        part: usize,
    },
    /// An interval is empty or not finite.
    #[error("an interval needs start < end, both finite; got [{start:?}, {end:?}]")]
    Interval {
        /// Its start.
        start: f64,
        /// Its end.
        end: f64,
    },
}
