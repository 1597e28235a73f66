//! The `plateau` command: a list of steps; everything they do lives in the library.

use std::io::{self, ErrorKind, Write};
use std::process::ExitCode;

use clap::Parser;

use command::{Arguments, Command, Failure, RunArguments, say};

mod command;

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let mut stdout = io::stdout().lock();
    let outcome = perform(arguments.command, &mut stdout).and_then(|()| Ok(stdout.flush()?));
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(Failure::Input) => ExitCode::from(2),
        Err(Failure::Result) => ExitCode::from(1),
        // Whoever closed our output (`| head -1`) has seen enough.
        Err(Failure::Output(error)) if error.kind() == ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Err(Failure::Output(error)) => {
            say(&format!("error: the output cannot be written: {error}"));
            ExitCode::from(1)
        }
    }
}

fn perform(command: Command, stdout: &mut impl Write) -> Result<(), Failure> {
    match command {
        Command::Run(arguments) => run(&arguments),
        Command::Check { files } => command::check(&files, stdout),
        Command::New { kind } => Ok(stdout.write_all(kind.0.text().as_bytes())?),
        Command::Completions { shell } => command::completions(shell, stdout),
    }
}

fn run(arguments: &RunArguments) -> Result<(), Failure> {
    let mut plans = command::read_plans(&arguments.files)?;
    command::distinct_stems(&plans, &arguments.out)?;
    for plan in &mut plans {
        plan.seed = arguments.seed.unwrap_or(plan.seed);
    }
    say("error: this build cannot run experiments; `plateau check` validates them");
    Err(Failure::Result)
}
