//! What a search found, and why it ended.

use std::fmt;

/// An enum of reasons, the list of its variants, which none can be left out of, their words and their sentences.
macro_rules! reasons {
    ($(#[$about:meta])* $name:ident: $($(#[$meaning:meta])* $variant:ident = $word:literal, $sentence:literal;)*) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[non_exhaustive]
        pub enum $name {
            $($(#[$meaning])* $variant,)*
        }

        impl $name {
            /// Every reason.
            pub const ALL: [Self; [$($word),*].len()] = [$(Self::$variant),*];

            /// Its word, for files: sentences may be mended.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $word,)*
                }
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(match self {
                    $(Self::$variant => $sentence,)*
                })
            }
        }
    };
}

reasons! {
    /// Why a run of the swarm ended. None of these proves a minimum.
    Reason:
    /// All iterations were done; says nothing about convergence.
    Budget = "budget", "the iteration budget is spent";
    /// The best value did not improve noticeably over the given number of iterations.
    Stagnation = "stagnation", "the best value stopped improving";
    /// The swarm shrank below the given fraction of the box.
    Collapse = "collapse", "the swarm collapsed to a point";
    /// The observer ended the run.
    Observer = "observer", "the observer ended the run";
    /// Every value was NaN or `+∞`: there is no best point.
    NothingFinite = "nothing-finite", "every value was NaN or infinite";
    /// A value of `−∞` was found: nothing can be lower.
    Unbounded = "unbounded", "the objective took the value -inf";
}

reasons! {
    /// Why a polish ended.
    PolishReason:
    /// The projected gradient vanishes within the tolerance.
    Stationary = "stationary", "the projected gradient vanishes";
    /// The value cannot be lowered any further in rounding, though the tolerance is not met.
    Flat = "flat", "the value cannot be lowered further in rounding";
    /// The evaluation budget is spent.
    Budget = "budget", "the evaluation budget is spent";
    /// The start has no finite value and gradient.
    NotFinite = "not-finite", "the start has no finite value and gradient";
}

/// A point and its value.
#[derive(Clone, Debug, PartialEq)]
pub struct Best {
    /// The objective's value, finite or `−∞`; evaluating the point again gives the same bits.
    pub value: f64,
    /// The point, inside the box.
    pub point: Vec<f64>,
}

/// The report of one run of the swarm.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Run {
    /// The experiment's seed.
    pub seed: u64,
    /// Index of the run; seed and index together determine every random number.
    pub run: usize,
    /// The best point found; `None` if no value was finite.
    pub best: Option<Best>,
    /// The best value after the initialisation and after each iteration done; never rises,
    /// `+∞` while nothing finite was found.
    pub history: Vec<f64>,
    /// Objective evaluations.
    pub evaluations: u64,
    /// How many of them were NaN.
    pub nan_evaluations: u64,
    /// Why the run ended.
    pub reason: Reason,
    /// Final diameter of the swarm: the largest extent of its positions along a component,
    /// relative to the box, in `[0, 1]`.
    pub diameter: f64,
    /// The last iteration that lowered the best value; 0 if none did after the initialisation.
    pub last_improvement: usize,
}

impl Run {
    /// Iterations done, the initialisation not counted.
    #[must_use]
    pub fn iterations(&self) -> usize {
        self.history.len() - 1
    }

    /// The best value, `+∞` if no value was finite.
    #[must_use]
    pub fn value(&self) -> f64 {
        self.best.as_ref().map_or(f64::INFINITY, |best| best.value)
    }
}

impl fmt::Display for Run {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "run {} of seed {}: ", self.run, self.seed)?;
        match &self.best {
            Some(best) => writeln!(f, "best {:e} at {:?}", best.value, best.point)?,
            None => writeln!(f, "nothing found")?,
        }
        writeln!(
            f,
            "  {} evaluations ({} NaN), {} iterations, last improvement at {}",
            self.evaluations,
            self.nan_evaluations,
            self.iterations(),
            self.last_improvement,
        )?;
        write!(f, "  ended because {}; swarm diameter {:.1e} of the box", self.reason, self.diameter)
    }
}

/// The reports of several runs, by run index.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Search {
    /// One report per run.
    pub runs: Vec<Run>,
}

impl Search {
    /// The run with the least value, ties to the smaller index; `None` if no run found a finite value.
    #[must_use]
    pub fn best(&self) -> Option<&Run> {
        let found = self.runs.iter().filter(|run| run.best.is_some());
        found.reduce(|best, run| if run.value() < best.value() { run } else { best })
    }

    /// Objective evaluations of all runs.
    #[must_use]
    pub fn evaluations(&self) -> u64 {
        self.runs.iter().map(|run| run.evaluations).sum()
    }

    /// NaN evaluations of all runs.
    #[must_use]
    pub fn nan_evaluations(&self) -> u64 {
        self.runs.iter().map(|run| run.nan_evaluations).sum()
    }
}

/// The bound a component is held at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bound {
    /// At its lower bound, with positive derivative: beyond, the value would be lower.
    Lower,
    /// Held by none. A component may touch a bound without being held.
    Free,
    /// At its upper bound, with negative derivative.
    Upper,
}

/// The report of one polish. Plain numbers: whoever keeps them can make the report again.
#[derive(Clone, Debug, PartialEq)]
pub struct Polished {
    /// The objective's value at the point.
    pub value: f64,
    /// The point, inside the box, exactly on the bounds it is held at.
    pub point: Vec<f64>,
    /// The gradient at the point; where a bound is active, its multiplier up to sign.
    pub gradient: Vec<f64>,
    /// The KKT residual: the largest `widthᵢ |gᵢ|` over the components not held at a bound, that
    /// is the change of the value across the box to first order, in units of the value.
    pub residual: f64,
    /// The bounds that bind, one entry per component.
    pub active: Vec<Bound>,
    /// Value and gradient evaluations.
    pub evaluations: usize,
    /// Steps accepted.
    pub iterations: usize,
    /// Why the polish ended.
    pub reason: PolishReason,
}

impl Polished {
    /// Whether any bound of the box binds: the minimum of a larger box may be lower.
    #[must_use]
    pub fn binds(&self) -> bool {
        self.active.iter().any(|&bound| bound != Bound::Free)
    }
}

impl fmt::Display for Polished {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{:e} at {:?}", self.value, self.point)?;
        let bounds = self.active.iter().filter(|&&bound| bound != Bound::Free);
        writeln!(
            f,
            "  {} evaluations, {} iterations, KKT residual {:.1e}, {} bounds bind",
            self.evaluations,
            self.iterations,
            self.residual,
            bounds.count(),
        )?;
        write!(f, "  ended because {}", self.reason)
    }
}
