//! Lines for a person, whatever names they quote.

use std::io::{self, IsTerminal, Write};

use experiment::Refusal;
use show::Printable;

/// A refusal on stderr, coloured only on a terminal that wants colours.
pub(crate) fn tell(refusal: &Refusal) {
    let wanted = std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty());
    let report = refusal.render(wanted && io::stderr().is_terminal());
    let _ = writeln!(io::stderr().lock(), "{report}");
}

/// A line on stderr, whatever names it quotes; if stderr is closed there is nobody left to tell.
pub(crate) fn say(message: &str) {
    let _ = writeln!(io::stderr().lock(), "{}", Printable(message));
}

/// A line on stdout, whatever names it quotes.
pub(crate) fn line(stdout: &mut impl Write, text: &str) -> io::Result<()> {
    writeln!(stdout, "{}", Printable(text))
}
