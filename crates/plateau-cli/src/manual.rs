//! What a shell and `man` are told of the command.

use std::io::Write;

use clap::CommandFactory;
use clap_complete::Shell;
use clap_mangen::Man;

use crate::command::{Arguments, EXIT_STATUS};
use crate::failure::Failure;

/// `completions`.
pub(crate) fn completions(shell: Shell, stdout: &mut impl Write) -> Result<(), Failure> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Arguments::command(), "plateau", &mut script);
    Ok(stdout.write_all(&script)?)
}

/// `man`: one page for the command and all its subcommands.
pub(crate) fn man(stdout: &mut impl Write) -> Result<(), Failure> {
    let mut command = Arguments::command();
    command.build();
    let mut page = Vec::new();
    let whole = Man::new(command.clone());
    whole.render_title(&mut page)?;
    whole.render_name_section(&mut page)?;
    whole.render_synopsis_section(&mut page)?;
    whole.render_description_section(&mut page)?;
    whole.render_options_section(&mut page)?;
    for subcommand in command.get_subcommands().filter(|subcommand| subcommand.get_name() != "help") {
        let mut section = Vec::new();
        let part = Man::new(subcommand.clone());
        part.render_description_section(&mut section)?;
        part.render_synopsis_section(&mut section)?;
        part.render_options_section(&mut section)?;
        writeln!(page, ".SH \"PLATEAU {}\"", subcommand.get_name().to_uppercase())?;
        page.extend(
            String::from_utf8_lossy(&section).replace(".SH DESCRIPTION\n", "").replace(".SH", ".SS").bytes(),
        );
    }
    writeln!(page, ".SH \"EXIT STATUS\"\n{}", EXIT_STATUS.trim_start_matches("Exit status: "))?;
    whole.render_version_section(&mut page)?;
    Ok(stdout.write_all(&page)?)
}
