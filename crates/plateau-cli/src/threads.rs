use crate::failure::Failure;
use crate::terminal::say;

/// The threads that were asked for.
pub(crate) fn start_threads(threads: Option<u16>) -> Result<(), Failure> {
    let Some(threads) = threads else { return Ok(()) };
    rayon::ThreadPoolBuilder::new().num_threads(threads.into()).build_global().map_err(|error| {
        say(&format!("error: {threads} threads cannot be started: {error}"));
        Failure::Input
    })
}
