//! How an experiment or a sweep ended.

/// What became of an experiment or of a sweep.
pub(crate) enum Outcome {
    /// All of it succeeded and met what its file expects.
    Sound,
    /// Something did not; it has been told.
    Unsound,
    /// It was not finished; what is kept of it.
    Interrupted(String),
}

impl Outcome {
    pub(crate) fn of(sound: bool) -> Self {
        if sound { Self::Sound } else { Self::Unsound }
    }
}
