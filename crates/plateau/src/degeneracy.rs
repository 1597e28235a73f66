use surfaces::Point;
use thiserror::Error;

/// What is wrong with a boundary although patches over it exist.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum Degeneracy {
    /// All points are one.
    #[error(
        "all points of the boundary coincide at {}: every patch over it is that point, without area and curvature",
        Self::shown(*at)
    )]
    OnePoint {
        /// The point.
        at: Point,
    },
    /// All points are on one straight line.
    #[error(
        "all points of the boundary lie on one straight line: every patch over it is folded onto that line and has no area"
    )]
    Straight,
    /// Small, and far from the origin.
    #[error(
        "the boundary is {extent:.1e} across and {distance:.1e} away from the origin: its coordinates have lost {:.0} of \
         their 16 digits to that distance; move it to the origin",
        (distance / extent).log10()
    )]
    Far {
        /// Largest distance of a point from the first one.
        extent: f64,
        /// Largest distance of a point from the origin.
        distance: f64,
    },
    /// A side without length.
    #[error("the side `{side}` is one point, {}: every patch over the boundary is singular along it", Self::shown(*at))]
    PointSide {
        /// The side.
        side: &'static str,
        /// The point.
        at: Point,
    },
    /// Two corners that no side without length joins are one point.
    #[error("the corners {first} and {second} coincide at {}: patches over the boundary are pinched there", Self::shown(*at))]
    Pinched {
        /// One corner.
        first: &'static str,
        /// The other.
        second: &'static str,
        /// The point.
        at: Point,
    },
    /// Two sides are the same curve.
    #[error(
        "the sides `{first}` and `{second}` are the same curve: the boundary runs back on itself, and patches over it fold \
         or touch themselves"
    )]
    SameSides {
        /// One side.
        first: &'static str,
        /// The other.
        second: &'static str,
    },
    /// The first two control points of a side from a corner are one.
    #[error(
        "points {} and {} of `{side}` coincide: every patch over the boundary is singular at the corner {corner}",
        points[0], points[1]
    )]
    NoTangent {
        /// Indices of the points.
        points: [usize; 2],
        /// The side.
        side: &'static str,
        /// The corner.
        corner: &'static str,
    },
    /// Two sides meet under 0° or 180°.
    #[error(
        "the sides `{}` and `{}` meet at the corner {corner} under {angle}°: every patch over the boundary is singular there",
        sides[0], sides[1]
    )]
    NoAngle {
        /// The sides.
        sides: [&'static str; 2],
        /// The corner.
        corner: &'static str,
        /// 0 or 180.
        angle: u16,
    },
    /// A side turns back on itself.
    #[error("the side `{side}` turns back on itself near {}: patches over it fold there", Self::shown(*at))]
    TurnsBack {
        /// The side.
        side: &'static str,
        /// Where.
        at: Point,
    },
    /// The boundary lies in a plane and crosses itself.
    #[error("the boundary is planar and crosses itself near {}: patches over it fold", Self::shown(*at))]
    Crossed {
        /// Where.
        at: Point,
    },
}

impl Degeneracy {
    /// The degeneracy of a boundary that was given `by` away from where it lay.
    pub(crate) fn moved(mut self, by: Point) -> Self {
        match &mut self {
            Self::OnePoint { at }
            | Self::PointSide { at, .. }
            | Self::Pinched { at, .. }
            | Self::TurnsBack { at, .. }
            | Self::Crossed { at } => *at += by,
            Self::Straight
            | Self::Far { .. }
            | Self::SameSides { .. }
            | Self::NoTangent { .. }
            | Self::NoAngle { .. } => {}
        }
        self
    }

    /// A point as its sentences show it.
    pub(crate) fn shown(p: Point) -> String {
        let digits = |x: f64| {
            if x == 0.0 || (1e-3..1e6).contains(&x.abs()) {
                format!("{}", (x * 1e4).round() / 1e4)
            } else {
                format!("{x:.4e}")
            }
        };
        format!("[{}, {}, {}]", digits(p.x), digits(p.y), digits(p.z))
    }
}
