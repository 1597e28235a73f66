//! What a table holds under a key.

use std::ops::Range;

use serde_spanned::Spanned;

/// A key's value as far as it is known. Relations between keys are judged only where all of them are known: a value that
/// could not be read makes no further faults.
#[derive(Clone, Debug)]
pub(crate) enum Given<T> {
    /// The table does not have the key.
    Absent,
    /// The key or its value is faulty, which has been reported; or a key that nobody knows may have been meant for it.
    Faulty,
    /// Sound, with the place of the value.
    Sound(Spanned<T>),
}

impl<T> Given<T> {
    /// The sound value.
    pub(crate) fn value(&self) -> Option<&T> {
        match self {
            Self::Sound(value) => Some(value.get_ref()),
            Self::Absent | Self::Faulty => None,
        }
    }

    /// The place of the sound value.
    pub(crate) fn span(&self) -> Option<Range<usize>> {
        match self {
            Self::Sound(value) => Some(value.span()),
            Self::Absent | Self::Faulty => None,
        }
    }

    /// The sound value with its place, by value.
    pub(crate) fn sound(self) -> Option<Spanned<T>> {
        match self {
            Self::Sound(value) => Some(value),
            Self::Absent | Self::Faulty => None,
        }
    }

    /// `None` if faulty, `Some(None)` if absent.
    pub(crate) fn known(self) -> Option<Option<Spanned<T>>> {
        match self {
            Self::Absent => Some(None),
            Self::Faulty => None,
            Self::Sound(value) => Some(Some(value)),
        }
    }

    /// The same with another value.
    pub(crate) fn map<U>(self, change: impl FnOnce(T) -> U) -> Given<U> {
        match self {
            Self::Absent => Given::Absent,
            Self::Faulty => Given::Faulty,
            Self::Sound(value) => {
                let span = value.span();
                Given::Sound(Spanned::new(span, change(value.into_inner())))
            }
        }
    }

    pub(crate) fn is_absent(&self) -> bool {
        matches!(self, Self::Absent)
    }

    pub(crate) fn is_faulty(&self) -> bool {
        matches!(self, Self::Faulty)
    }
}
