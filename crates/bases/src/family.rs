//! The families by their names: one table, which whatever reads, draws or writes them follows.

use std::ops::{Range, RangeInclusive};

use crate::{Aht, At, Bernstein};

/// The enum, its list, which no variant can be left out of, and the names.
macro_rules! basis_families {
    ($($(#[$meaning:meta])* $variant:ident = $name:literal, $title:literal;)*) => {
        /// A family of functions of one variable, without its degree and parameters.
        ///
        /// ```
        /// use bases::BasisFamily;
        ///
        /// assert_eq!(BasisFamily::Gt.name(), "gt");
        /// assert!(BasisFamily::ALL.iter().all(|family| family.spans().is_some() == family.is_of_order_six()));
        /// ```
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum BasisFamily {
            $($(#[$meaning])* $variant,)*
        }

        impl BasisFamily {
            /// Every family.
            pub const ALL: [Self; [$($name),*].len()] = [$(Self::$variant),*];

            /// Every family with its name.
            pub const NAMES: [(&'static str, Self); Self::ALL.len()] = [$(($name, Self::$variant)),*];

            /// Its name in files and on command lines.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name,)*
                }
            }

            /// What a sentence calls it.
            #[must_use]
            pub const fn title(self) -> &'static str {
                match self {
                    $(Self::$variant => $title,)*
                }
            }
        }
    };
}

basis_families! {
    /// [`Bernstein`] polynomials of any degree.
    Bernstein = "bernstein", "Bernstein";
    /// The [`Gt`](crate::Gt) functions of any degree from 2 on, with two shape parameters.
    Gt = "gt", "GT";
    /// The six [`Aht`] functions on an interval.
    Aht = "aht", "AHT";
    /// The six [`At`] functions on an interval.
    At = "at", "AT";
}

impl BasisFamily {
    /// The degrees it has: one less than its functions.
    #[must_use]
    pub const fn degrees(self) -> RangeInclusive<usize> {
        match self {
            Self::Bernstein => 1..=Bernstein::MAX_DEGREE,
            Self::Gt => 2..=Bernstein::MAX_DEGREE,
            Self::Aht | Self::At => 5..=5,
        }
    }

    /// Whether it has six functions on an interval that is its parameter.
    #[must_use]
    pub const fn is_of_order_six(self) -> bool {
        match self {
            Self::Bernstein | Self::Gt => false,
            Self::Aht | Self::At => true,
        }
    }

    /// The names of its shape parameters, each in [`Gt::SHAPES`](crate::Gt::SHAPES); none of a family without.
    #[must_use]
    pub const fn parameters(self) -> &'static [&'static str] {
        match self {
            Self::Gt => &["θ1", "θ2"],
            Self::Bernstein | Self::Aht | Self::At => &[],
        }
    }

    /// Whether it has shape parameters.
    #[must_use]
    pub const fn has_shape(self) -> bool {
        !self.parameters().is_empty()
    }

    /// The lengths of the intervals [0, span] on which it is nonnegative; none of a family that lives on [0, 1].
    #[must_use]
    pub const fn spans(self) -> Option<Range<f64>> {
        match self {
            Self::Bernstein | Self::Gt => None,
            Self::Aht => Some(Aht::MIN_SPAN..Aht::SUPREMUM),
            Self::At => Some(At::MIN_SPAN..At::SUPREMUM),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Gt;

    #[test]
    fn a_family_has_the_degrees_and_spans_it_says() {
        for family in BasisFamily::ALL {
            assert_eq!(BasisFamily::NAMES.iter().filter(|(name, _)| *name == family.name()).count(), 1);
            let of_degree = |degree| match family {
                BasisFamily::Bernstein => Bernstein::new(degree).map(drop),
                BasisFamily::Gt => Gt::new(degree, [1.0, 2.0]).map(drop),
                BasisFamily::Aht | BasisFamily::At => Ok(()),
            };
            let of_span = |span| match family {
                BasisFamily::Bernstein | BasisFamily::Gt => Ok(()),
                BasisFamily::Aht => Aht::new(span).map(drop),
                BasisFamily::At => At::new(span).map(drop),
            };
            let (least, most) = (*family.degrees().start(), *family.degrees().end());
            assert!(of_degree(least).is_ok() && of_degree(most).is_ok());
            assert!(family.is_of_order_six() || of_degree(most + 1).is_err());
            if let Some(spans) = family.spans() {
                assert!(of_span(spans.start).is_ok() && of_span(spans.end).is_err());
            }
        }
        assert!(Gt::new(BasisFamily::Gt.degrees().start() - 1, [1.0, 2.0]).is_err());
    }
}
