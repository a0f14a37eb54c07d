//! `relief man`: prints or writes manual pages.

use std::io::{self, Write};
use std::path::PathBuf;

use clap::{Args, Command};
use clap_mangen::Man;
use relief_core::registry::UnknownName;
use relief_io::write_atomically;

use crate::failure::Failure;

/// Arguments of `relief man`.
#[derive(Args)]
#[command(after_help = "Examples:\n  relief man render | man -l -\n  \
    relief man --output DIR    # for packagers: a page for each command")]
pub struct Arguments {
    /// Command whose page is printed, such as render or height-from-photos [default: relief itself]
    #[arg(value_name = "COMMAND", conflicts_with = "output")]
    page: Option<String>,
    /// Folder for all pages: relief.1, relief-render.1 and so on
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
}

/// Prints a page, or writes all of them.
pub fn run(arguments: &Arguments, command: &Command) -> Result<(), Failure> {
    let mut whole = command.clone();
    whole.build();
    let mut pages = Vec::new();
    collect(&whole, whole.get_name().to_owned(), &mut pages)?;
    if let Some(folder) = &arguments.output {
        std::fs::create_dir_all(folder).map_err(|error| {
            Failure::Work(format!("{}: the folder cannot be made: {error}", folder.display()))
        })?;
        for (name, text) in pages {
            let path = folder.join(format!("{name}.1"));
            write_atomically(&path, |out| out.write_all(&text)).map_err(Failure::work)?;
        }
        return Ok(());
    }
    let wanted = match &arguments.page {
        Some(page) => format!("{}-{page}", whole.get_name()),
        None => whole.get_name().to_owned(),
    };
    let (_, text) = pages.iter().find(|(name, _)| *name == wanted).ok_or_else(|| {
        let prefix = format!("{}-", whole.get_name());
        let known = pages.iter().filter_map(|(name, _)| name.strip_prefix(&prefix));
        Failure::usage(UnknownName::new("command", wanted.trim_start_matches(&prefix), known))
    })?;
    Ok(io::stdout().lock().write_all(text)?)
}

/// Collects the page of a command, and the pages of its subcommands.
fn collect(command: &Command, name: String, pages: &mut Vec<(String, Vec<u8>)>) -> Result<(), Failure> {
    let mut text = Vec::new();
    Man::new(command.clone().name(name.clone())).render(&mut text)?;
    let below = command.get_subcommands().filter(|below| below.get_name() != "help");
    for below in below {
        collect(below, format!("{name}-{}", below.get_name()), pages)?;
    }
    pages.push((name, text));
    Ok(())
}
