use std::borrow::Cow;

/// What is said of a key: as it is written, or made of what others say of themselves.
#[derive(Clone, Copy)]
pub(crate) enum Words {
    Written(&'static str),
    Made(fn() -> String),
}

impl Words {
    /// As a phrase; empty if nothing is said.
    pub(crate) fn phrase(self) -> Cow<'static, str> {
        match self {
            Self::Written(phrase) => phrase.into(),
            Self::Made(make) => make().into(),
        }
    }
}
