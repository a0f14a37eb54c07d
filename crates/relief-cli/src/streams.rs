//! Standard input and output as files: an argument names them by `-`.
//!
//! Readers go back and forth in a file, and nobody wants half a picture in a pipe. So the input is
//! copied to a temporary file first. The output is written to a temporary file and copied when all
//! is done. All other messages then go to standard error.

use std::fs::File;
use std::io::{self, IsTerminal, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::sync::atomic::Ordering;

use tempfile::TempDir;

use crate::failure::Failure;
use crate::interrupt;
use crate::say::{self, Verbosity};

/// Name of a standard stream in arguments.
const STREAM: &str = "-";

/// Name of standard input in messages.
pub const INPUT: &str = "standard input";

/// Temporary files of the streams.
struct StreamFiles {
    input: Option<PathBuf>,
    output: Option<PathBuf>,
}

static FILES: OnceLock<StreamFiles> = OnceLock::new();

/// Files that a command reads and writes.
#[derive(Default)]
pub struct Files<'a> {
    pub read: Vec<&'a mut PathBuf>,
    pub written: Vec<Written<'a>>,
    /// Flag on the command line that writes several files instead of one.
    pub split: Option<&'static str>,
}

/// File that a command writes.
pub struct Written<'a> {
    /// Argument that names it.
    pub flag: &'static str,
    pub path: &'a mut PathBuf,
    /// Format that --format names, as a file ending.
    pub format: Option<&'a str>,
}

/// Temporary files behind the standard streams. Dropping it removes them.
pub struct Streams {
    folder: Option<TempDir>,
}

impl Streams {
    /// Replaces the names of streams by names of temporary files, and copies standard input to its
    /// file.
    pub fn open(files: Files) -> Result<Self, Failure> {
        let mut streams = Self { folder: None };
        // Errors of the output come before anybody waits for the input.
        let output = streams.output(files.written, files.split)?;
        let input = streams.input(files.read)?;
        FILES.get_or_init(|| StreamFiles { input, output });
        Ok(streams)
    }

    fn input(&mut self, files: Vec<&mut PathBuf>) -> Result<Option<PathBuf>, Failure> {
        let mut named = files.into_iter().filter(|path| path.as_os_str() == STREAM);
        let Some(first) = named.next() else { return Ok(None) };
        if named.next().is_some() {
            return Err(Failure::usage("standard input can be read only once: name a file for the other -"));
        }
        let mut input = io::stdin().lock();
        if input.is_terminal() {
            return Err(Failure::usage("-: standard input is a terminal: give a file, or pipe one in"));
        }
        let path = self.folder()?.join("stdin");
        let cancel = interrupt::catch()?;
        let failed = |error| Failure::Work(format!("{INPUT}: cannot be copied to a temporary file: {error}"));
        let mut copy = File::create(&path).map_err(failed)?;
        let mut buffer = vec![0; 1 << 16];
        loop {
            if cancel.load(Ordering::Relaxed) {
                return Err(interrupt::cancelled());
            }
            match input.read(&mut buffer) {
                Ok(0) => break,
                Ok(count) => copy.write_all(&buffer[..count]).map_err(failed)?,
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                Err(error) => return Err(Failure::Work(format!("{INPUT}: cannot be read: {error}"))),
            }
        }
        first.clone_from(&path);
        Ok(Some(path))
    }

    fn output(&mut self, files: Vec<Written>, split: Option<&str>) -> Result<Option<PathBuf>, Failure> {
        let (mut streams, named): (Vec<_>, Vec<_>) =
            files.into_iter().partition(|file| file.path.as_os_str() == STREAM);
        if let Some(Written { flag, .. }) = named.iter().find(|file| file.format.is_some()) {
            return Err(Failure::Usage(format!(
                "--format is for {flag} - only: a file's ending chooses its format: leave --format out"
            )));
        }
        let Some(Written { flag, path, format }) = streams.pop() else { return Ok(None) };
        if !streams.is_empty() {
            return Err(Failure::usage("only one file can go to standard output: name the others"));
        }
        if let Some(split) = split {
            return Err(Failure::Usage(format!(
                "{split} writes several files, and {flag} - is one: give them a name"
            )));
        }
        let Some(format) = format else {
            return Err(Failure::Usage(format!("{flag} -: the format is not known: give --format")));
        };
        if io::stdout().is_terminal() {
            return Err(Failure::Usage(format!(
                "{flag} -: standard output is a terminal: redirect it, or give a file"
            )));
        }
        // From here on an interrupted program has a folder to remove.
        interrupt::catch()?;
        *path = self.folder()?.join(format!("stdout.{format}"));
        Ok(Some(path.clone()))
    }

    /// Copies the written file to standard output.
    pub fn finish(self) -> Result<(), Failure> {
        let Some(path) = FILES.get().and_then(|files| files.output.as_ref()) else { return Ok(()) };
        let mut file = File::open(path).map_err(Failure::work)?;
        let mut out = io::stdout().lock();
        io::copy(&mut file, &mut out)?;
        Ok(out.flush()?)
    }

    fn folder(&mut self) -> Result<&Path, Failure> {
        if self.folder.is_none() {
            let folder = tempfile::Builder::new().prefix("relief-").tempdir();
            self.folder = Some(folder.map_err(|error| {
                Failure::Work(format!(
                    "no folder can be made for temporary files: {error}: check the free space"
                ))
            })?);
        }
        Ok(self.folder.as_ref().map_or(Path::new(""), TempDir::path))
    }
}

/// Whether a path names the copy of standard input.
pub fn is_input(path: &Path) -> bool {
    FILES.get().is_some_and(|files| files.input.as_deref() == Some(path))
}

/// Returns a text with the names of streams in place of their temporary files' names.
pub fn named(text: &str) -> String {
    let mut text = text.to_owned();
    if let Some(files) = FILES.get() {
        for (path, name) in [(&files.input, INPUT), (&files.output, "standard output")] {
            if let Some(path) = path {
                text = text.replace(&path.display().to_string(), name);
            }
        }
    }
    text
}

/// Prints the answer to a command: on standard output, or on standard error if a file goes to
/// standard output.
pub fn answer(write: impl FnOnce(&mut Vec<u8>) -> Result<(), Failure>) -> Result<(), Failure> {
    say_answer(write, true)
}

/// Prints which files a command wrote. With `--quiet` it prints nothing, unless `json` was asked
/// for: the files are the result.
pub fn tell_written(
    json: bool,
    write: impl FnOnce(&mut Vec<u8>) -> Result<(), Failure>,
) -> Result<(), Failure> {
    say_answer(write, json || say::verbosity() != Verbosity::Quiet)
}

fn say_answer(
    write: impl FnOnce(&mut Vec<u8>) -> Result<(), Failure>,
    is_printed: bool,
) -> Result<(), Failure> {
    let mut text = Vec::new();
    write(&mut text)?;
    if !is_printed {
        return Ok(());
    }
    let text = named(&String::from_utf8_lossy(&text));
    match FILES.get() {
        Some(StreamFiles { output: Some(_), .. }) => Ok(io::stderr().lock().write_all(text.as_bytes())?),
        _ => Ok(io::stdout().lock().write_all(text.as_bytes())?),
    }
}
