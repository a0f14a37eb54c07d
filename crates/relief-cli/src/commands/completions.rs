//! `relief completions`: prints or writes shell completions.

use std::io::{self, Write};
use std::path::PathBuf;

use clap::{Args, Command, ValueEnum};
use clap_complete::{Generator, Shell, generate};
use relief_io::write_atomically;

use crate::failure::Failure;

/// Arguments of `relief completions`.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
    relief completions bash > ~/.local/share/bash-completion/completions/relief\n  \
    relief completions fish > ~/.config/fish/completions/relief.fish\n  \
    relief completions --output DIR    # for packagers: a file for each shell")]
pub struct Arguments {
    /// Shell whose completions are printed
    #[arg(value_name = "SHELL", required_unless_present = "output", conflicts_with = "output")]
    shell: Option<Shell>,
    /// Folder for the completions of all shells, each file under its usual name
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
}

/// Prints the completions, or writes their files.
pub fn run(arguments: &Arguments, command: &Command) -> Result<(), Failure> {
    if let Some(shell) = arguments.shell {
        return Ok(io::stdout().lock().write_all(&completions(shell, command))?);
    }
    let Some(folder) = &arguments.output else { return Ok(()) };
    std::fs::create_dir_all(folder).map_err(|error| {
        Failure::Work(format!("{}: the folder cannot be made: {error}", folder.display()))
    })?;
    for shell in Shell::value_variants() {
        let path = folder.join(shell.file_name(command.get_name()));
        let written = write_atomically(&path, |out| out.write_all(&completions(*shell, command)));
        written.map_err(Failure::work)?;
    }
    Ok(())
}

fn completions(shell: Shell, command: &Command) -> Vec<u8> {
    let mut text = Vec::new();
    let name = command.get_name().to_owned();
    generate(shell, &mut command.clone(), name, &mut text);
    text
}
