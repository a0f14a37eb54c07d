//! Failures of a command: the message and the exit code.

use std::io;
use std::process::ExitCode;

use relief_io::ReadError;

use crate::cut::cut;
use crate::{advice, streams};

/// Reason that a command did not do its work.
#[derive(Debug)]
pub enum Failure {
    /// The command line is wrong: exit code 2.
    Usage(String),
    /// The work failed: exit code 1.
    Work(String),
    /// The reader of the output has gone, as in `relief methods | head`: no message, exit code 0.
    ReaderGone,
}

impl Failure {
    /// Creates the failure of a command line that cannot be carried out.
    pub fn usage(message: impl ToString) -> Self {
        Failure::Usage(message.to_string())
    }

    /// Creates the failure of work.
    pub fn work(message: impl ToString) -> Self {
        Failure::Work(message.to_string())
    }

    /// Creates the failure of a height map that cannot be read.
    pub fn of_map(error: ReadError) -> Self {
        Failure::Work(advice::with_flag(&error, advice::of_read(&error.problem)))
    }

    /// Creates the failure of a picture or a normal map that cannot be read.
    pub fn of_picture(error: ReadError) -> Self {
        Failure::Work(advice::with_flag(&error, advice::of_picture(&error.problem)))
    }

    /// Creates the failure of a mesh that cannot be read.
    pub fn of_mesh(error: ReadError) -> Self {
        Failure::Work(advice::with_flag(&error, advice::of_mesh(&error.problem)))
    }

    /// Creates the failure of a command line that clap refused: what is wrong, without clap's
    /// advice on usage.
    pub fn unparsed(error: &clap::Error) -> Self {
        let text = error.render().to_string();
        let text = text.strip_prefix("error: ").unwrap_or(&text);
        let end =
            ["\n\nUsage:", "\n\nFor more information"].into_iter().filter_map(|end| text.find(end)).min();
        Failure::usage(&text[..end.unwrap_or(text.len())])
    }

    /// Prints the message on standard error and returns the exit code.
    pub fn report(self, json: bool) -> ExitCode {
        let (message, code) = match &self {
            Failure::Usage(message) => (message, 2),
            Failure::Work(message) => (message, 1),
            Failure::ReaderGone => return ExitCode::SUCCESS,
        };
        let message = cut(&streams::named(message.trim_end()));
        if json {
            eprintln!("{}", serde_json::json!({ "error": message, "exit": code }));
        } else {
            eprintln!("error: {message}");
        }
        ExitCode::from(code)
    }
}

impl From<io::Error> for Failure {
    /// Turns an error of writing to standard output into a failure.
    fn from(error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Failure::ReaderGone,
            _ => Failure::Work(format!("standard output cannot be written: {error}")),
        }
    }
}
