//! Sweeps: many experiments of one file, run by one process or by many, and merged into one table.
//!
//! [`experiment::Sweep`] says what the cells are. [`run()`] runs those of a [`Shard`], each into an ordinary folder of results below
//! that of the sweep: what is there already is kept. [`merge()`] reads the folders of all shards into one [`Merged`] table: its
//! bytes do not depend on how the cells were shared out, nor on the order of the folders. Which cells are missing is said.
//!
//! ```
//! use experiment::{Options, Sweep};
//! use sweep::{Order, Shard, merge, run};
//!
//! let text = r#"
//!     title = "Half a turn of a helicoid"
//!     [trapezium-helicoid]
//!     span = 3.14159
//!     gamma = [0.0, 1.0]
//!     beta = [0.0, 0.0]
//!     [output]
//!     pictures = false
//!     mesh = 2
//!     [[sweep.axis]]
//!     name = "turn"
//!     key = "trapezium-helicoid.span"
//!     values = [1.5, 3.0]
//! "#;
//! let turns = Sweep::parse("turns.toml", text, ".".as_ref())?;
//! let out = std::env::temp_dir().join(format!("sweep-{}", std::process::id()));
//! for k in 1..=2 {
//!     let order = Order::new(&turns, Shard::new(k, 2).expect("1 and 2 of 2"), &out);
//!     assert_eq!(run(&order, &(), &|_| ())?.done, 1);
//! }
//! let merged = merge(&[out.join("turns")])?;
//! assert!(merged.is_whole() && merged.csv().starts_with("cell,turn,method,"));
//! # std::fs::remove_dir_all(&out)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # What is here
//!
//! | noun | here |
//! |---|---|
//! | a share of the cells | [`Shard`], [`Asked`] for in words, [`shard()`] with the variables of a scheduler, [`ShardError`] |
//! | running it | [`Order`], [`run()`], [`Tally`]; [`OUTLINE_FILE`], [`OUTLINE_SCHEMA`] |
//! | one table of all | [`merge()`], [`Merged`], [`MERGED_SCHEMA`], [`MergeError`] |

#![warn(clippy::wildcard_enum_match_arm)]

mod csv;
mod document;
mod figures;
mod files;
mod merge;
mod merged;
mod order;
mod outline;
mod page;
mod run;
mod shard;
mod stored;
mod table;

pub use document::MERGED_SCHEMA;
pub use merge::{MergeError, merge};
pub use merged::Merged;
pub use order::Order;
pub use outline::{OUTLINE_FILE, OUTLINE_SCHEMA};
pub use run::{Tally, run};
pub use shard::{Asked, Shard, ShardError, shard};
