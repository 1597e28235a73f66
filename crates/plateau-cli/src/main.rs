//! The `plateau` command: a list of steps; everything they do lives in the library.

#![warn(clippy::wildcard_enum_match_arm)]

use std::io::{self, ErrorKind, Write};
use std::process::ExitCode;

use clap::Parser;

use command::{Arguments, Command};
use failure::Failure;
use show::Printable;
use terminal::say;

mod bars;
mod batch;
mod check;
mod command;
mod conversion;
mod descriptors;
mod drawing;
mod failure;
mod fill;
mod interrupt;
mod manual;
mod outcome;
mod outlet;
mod sources;
mod spelling;
mod sweeps;
mod terminal;
mod threads;
mod values;
mod verify;

fn main() -> ExitCode {
    interrupt::hold_file_sizes();
    let arguments = Arguments::try_parse().unwrap_or_else(|error| refused(error));
    let mut stdout = io::stdout().lock();
    let outcome = perform(arguments.command, &mut stdout).and_then(|()| Ok(stdout.flush()?));
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(Failure::Input) => ExitCode::from(2),
        Err(Failure::Result) => ExitCode::from(1),
        Err(Failure::Interrupted) => ExitCode::from(130),
        // Whoever closed our output (`| head -1`) has seen enough.
        Err(Failure::Output(error)) if error.kind() == ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Err(Failure::Output(error)) => {
            say(&format!("error: the output cannot be written: {error}"));
            ExitCode::from(1)
        }
    }
}

/// Says why arguments are refused, which it quotes: controls in them are shown, not sent to the terminal.
fn refused(error: clap::Error) -> ! {
    let shown = std::env::args_os().map(|argument| Printable(&argument.to_string_lossy()).to_string());
    Arguments::try_parse_from(shown).err().unwrap_or(error).exit()
}

fn perform(command: Command, stdout: &mut impl Write) -> Result<(), Failure> {
    match command {
        Command::Run(arguments) => batch::run(&arguments, stdout),
        Command::Check { files } => check::check(&files, stdout),
        Command::Reproduce { json, quiet } => batch::reproduce(json, quiet, stdout),
        Command::Merge(arguments) => sweeps::merge_folders(&arguments, stdout),
        Command::Verify(arguments) => verify::results(&arguments, stdout),
        Command::Fill(arguments) => fill::fill(&arguments, stdout),
        Command::Import(arguments) => conversion::import(&arguments, stdout),
        Command::Export(arguments) => conversion::export(&arguments, stdout),
        Command::New { kind } => Ok(stdout.write_all(kind.text().as_bytes())?),
        Command::Draw(drawing) => drawing::draw(&drawing, stdout),
        Command::Completions { shell } => manual::completions(shell, stdout),
        Command::Man => manual::man(stdout),
        Command::Schema => Ok(stdout.write_all(experiment::experiment_schema().as_bytes())?),
    }
}
