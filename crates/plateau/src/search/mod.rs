//! The search for shape parameters: a swarm over the reduced energy, a polish of what it found.

mod at_shapes;
mod composed;
mod least_area;
mod minima;
mod options;
mod outcome;
mod reduced;
mod reduced_energy;
mod run;
mod runs;

pub use options::{MAX_SEARCH_BUDGET, Search, SearchFault, SearchMode, Variant};
pub use outcome::SearchOutcome;
pub use reduced_energy::ReducedEnergy;
pub use run::{SearchRun, Swarm};
pub(crate) use runs::search;
