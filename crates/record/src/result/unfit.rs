use std::fmt::Display;

/// A value of a record that a surface cannot be made from.
#[derive(Debug)]
pub(crate) enum Unfit {
    /// The key that is needed, from the root.
    Missing(String),
    /// The key, from the root, and what is wrong with its value.
    Value { key: String, why: String },
}

pub(super) fn unfit(key: &str, why: impl Display) -> Unfit {
    Unfit::Value { key: key.into(), why: why.to_string() }
}

/// The value of a key that a family needs.
pub(super) fn needed<T>(value: Option<T>, key: &str) -> Result<T, Unfit> {
    value.ok_or_else(|| Unfit::Missing(key.into()))
}
