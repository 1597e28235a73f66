//! A share of the cells: which one, and of how many.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

/// Most shards.
const MOST: usize = 100_000;

/// The k-th of n shards, 1 ≤ k ≤ n: every n-th cell from the k-th on. Neighbours, which take alike long, go to different shards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    k: usize,
    of: usize,
}

/// Why there is no such shard.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum ShardError {
    /// Not of the form `K/N`.
    #[error(
        "a shard is written K/N, as in 3/8: the third of eight; /8 takes its place from the scheduler's task"
    )]
    Form,
    /// Not one of that many.
    #[error("there is no shard {k} of {of}: they are counted from 1, up to {MOST} of them")]
    Range {
        /// Which.
        k: usize,
        /// Of how many.
        of: usize,
    },
    /// `/N` where no scheduler says which.
    #[error(
        "/{0} says of how many, but neither SLURM_ARRAY_TASK_ID nor HQ_TASK_ID says which: write --shard K/{0}"
    )]
    Unknown(usize),
    /// What the scheduler says does not fit together.
    #[error("{variable}={value} cannot be made a shard: {why}; say it by --shard K/N")]
    Scheduler {
        /// The variable.
        variable: &'static str,
        /// What it says.
        value: String,
        /// What is wrong with it.
        why: String,
    },
}

impl Shard {
    /// All cells.
    pub const WHOLE: Self = Self { k: 1, of: 1 };

    /// The `k`-th of `of` shards.
    ///
    /// # Errors
    /// [`ShardError::Range`], if not 1 ≤ k ≤ of ≤ 100000.
    pub fn new(k: usize, of: usize) -> Result<Self, ShardError> {
        if k >= 1 && k <= of && of <= MOST { Ok(Self { k, of }) } else { Err(ShardError::Range { k, of }) }
    }

    /// Its cells among so many.
    pub fn cells(self, count: usize) -> impl Iterator<Item = usize> {
        (self.k - 1..count).step_by(self.of)
    }

    /// Whether it is all of them.
    #[must_use]
    pub fn is_whole(self) -> bool {
        self.of == 1
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} of {}", self.k, self.of)
    }
}

/// A shard as a person asks for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Asked {
    /// `K/N`.
    Shard(Shard),
    /// `/N`: which one is said by the scheduler.
    Of(usize),
}

impl FromStr for Asked {
    type Err = ShardError;

    fn from_str(text: &str) -> Result<Self, ShardError> {
        let (k, of) = text.trim().split_once('/').ok_or(ShardError::Form)?;
        let of = of.trim().parse().map_err(|_| ShardError::Form)?;
        if k.trim().is_empty() {
            return Shard::new(1, of).map(|_| Self::Of(of));
        }
        Shard::new(k.trim().parse().map_err(|_| ShardError::Form)?, of).map(Self::Shard)
    }
}

/// The shard of this process, and the variable of a scheduler that said so. `variable` is the environment: a person's word goes
/// before that of a Slurm job array (`SLURM_ARRAY_TASK_ID`, `…_MIN`, `…_STEP`, `…_COUNT`); HyperQueue's `HQ_TASK_ID` says which
/// one, but not of how many. None of them: all cells.
///
/// # Errors
/// [`ShardError`].
pub fn shard(
    asked: Option<Asked>,
    variable: impl Fn(&str) -> Option<String>,
) -> Result<(Shard, Option<&'static str>), ShardError> {
    const SLURM: &str = "SLURM_ARRAY_TASK_ID";
    const HYPERQUEUE: &str = "HQ_TASK_ID";
    let given = |name: &str| variable(name).filter(|value| !value.trim().is_empty());
    let asked = match asked {
        Some(Asked::Shard(shard)) => return Ok((shard, None)),
        Some(Asked::Of(of)) => Some(of),
        None => None,
    };
    let number = |name: &'static str| -> Result<Option<usize>, ShardError> {
        let Some(value) = given(name) else { return Ok(None) };
        let refused = |_| ShardError::Scheduler {
            variable: name,
            value: value.clone(),
            why: "it is not a number".into(),
        };
        value.trim().parse().map(Some).map_err(refused)
    };
    if let Some(task) = number(SLURM)? {
        let [least, step] = [number("SLURM_ARRAY_TASK_MIN")?, number("SLURM_ARRAY_TASK_STEP")?];
        let (least, step) = (least.unwrap_or(1), step.unwrap_or(1).max(1));
        let refused = |why: &str| {
            Err(ShardError::Scheduler { variable: SLURM, value: task.to_string(), why: why.to_owned() })
        };
        let Some(of) = asked.map_or_else(|| number("SLURM_ARRAY_TASK_COUNT"), |of| Ok(Some(of)))? else {
            return refused("SLURM_ARRAY_TASK_COUNT is not set");
        };
        let Some(place) = task.checked_sub(least).filter(|place| place % step == 0) else {
            return refused("it is not SLURM_ARRAY_TASK_MIN plus a multiple of SLURM_ARRAY_TASK_STEP");
        };
        return match Shard::new(place / step + 1, of) {
            Ok(shard) => Ok((shard, Some(SLURM))),
            Err(_) => refused(&format!("the tasks of the array are not {of} numbers in equal steps")),
        };
    }
    match (asked, number(HYPERQUEUE)?) {
        (Some(of), Some(task)) => match Shard::new(task, of) {
            Ok(shard) => Ok((shard, Some(HYPERQUEUE))),
            Err(_) => {
                let why = format!("tasks are counted from 1 to {of}, as in --array 1-{of}");
                Err(ShardError::Scheduler { variable: HYPERQUEUE, value: task.to_string(), why })
            }
        },
        (Some(of), None) => Err(ShardError::Unknown(of)),
        (None, Some(task)) => {
            let why = "HyperQueue does not say of how many: --shard /N does".to_owned();
            Err(ShardError::Scheduler { variable: HYPERQUEUE, value: task.to_string(), why })
        }
        (None, None) => Ok((Shard::WHOLE, None)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(asked: &str, variables: &[(&str, &str)]) -> Result<(Shard, Option<&'static str>), ShardError> {
        let asked = if asked.is_empty() { None } else { Some(asked.parse()?) };
        shard(asked, |name| {
            variables.iter().find(|(key, _)| *key == name).map(|(_, value)| (*value).to_owned())
        })
    }

    fn is(k: usize, of: usize) -> Shard {
        Shard::new(k, of).unwrap()
    }

    #[test]
    fn shards_are_all_cells_and_none_twice() {
        for (count, of) in [(10, 1), (10, 3), (2, 7), (200, 7), (0, 2)] {
            let mut cells: Vec<usize> = (1..=of).flat_map(|k| is(k, of).cells(count)).collect();
            cells.sort_unstable();
            assert!(cells.into_iter().eq(0..count), "{count} in {of}");
        }
    }

    #[test]
    fn schedulers_say_which_and_a_person_s_word_goes_before() {
        let array = [
            ("SLURM_ARRAY_TASK_ID", "7"),
            ("SLURM_ARRAY_TASK_MIN", "3"),
            ("SLURM_ARRAY_TASK_MAX", "9"),
            ("SLURM_ARRAY_TASK_STEP", "2"),
            ("SLURM_ARRAY_TASK_COUNT", "4"),
        ];
        assert_eq!(found("", &array), Ok((is(3, 4), Some("SLURM_ARRAY_TASK_ID"))));
        assert_eq!(found("2/5", &array), Ok((is(2, 5), None)));
        assert_eq!(found("/8", &array), Ok((is(3, 8), Some("SLURM_ARRAY_TASK_ID"))));
        assert_eq!(found("/8", &[("HQ_TASK_ID", "8")]), Ok((is(8, 8), Some("HQ_TASK_ID"))));
        assert_eq!(found("", &[]), Ok((Shard::WHOLE, None)));
        assert_eq!(found("", &[("HQ_TASK_ID", "")]), Ok((Shard::WHOLE, None)));
    }

    #[test]
    fn what_does_not_fit_together_is_refused() {
        // Tasks 1, 3 and 7 of an array: the third is not the third of three in a row.
        let gaps =
            [("SLURM_ARRAY_TASK_ID", "7"), ("SLURM_ARRAY_TASK_MIN", "1"), ("SLURM_ARRAY_TASK_COUNT", "3")];
        assert!(matches!(found("", &gaps), Err(ShardError::Scheduler { .. })));
        assert!(matches!(found("", &gaps[..2]), Err(ShardError::Scheduler { .. })));
        assert!(matches!(found("", &[("HQ_TASK_ID", "3")]), Err(ShardError::Scheduler { .. })));
        assert!(matches!(found("/4", &[("HQ_TASK_ID", "0")]), Err(ShardError::Scheduler { .. })));
        assert!(matches!(found("", &[("SLURM_ARRAY_TASK_ID", "x")]), Err(ShardError::Scheduler { .. })));
        assert_eq!(found("/4", &[]), Err(ShardError::Unknown(4)));
        for text in ["3", "a/b", "1/", "-1/3", "/"] {
            assert_eq!(text.parse::<Asked>(), Err(ShardError::Form), "{text}");
        }
        for text in ["0/3", "4/3", "1/0", "/0", "1/100001"] {
            assert!(matches!(text.parse::<Asked>(), Err(ShardError::Range { .. })), "{text}");
        }
    }
}
