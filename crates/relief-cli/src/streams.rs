//! The standard input and output where an argument names them: `-`.
//!
//! Readers go back and forth in a file, and nobody wants half a picture in a pipe. So the input is copied to
//! a temporary file first, and the output is written to one and copied when all is done. Whatever else is
//! said goes to the standard error then.

use std::fs::File;
use std::io::{self, IsTerminal, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::sync::atomic::Ordering;

use tempfile::TempDir;

use crate::failure::Failure;
use crate::interrupt;
use crate::say::{self, Loudness};

/// How an argument names a standard stream.
const STREAM: &str = "-";

/// The standard input as it is called in what is said.
pub const INPUT: &str = "standard input";

/// Where the streams' temporary files are.
struct Places {
    input: Option<PathBuf>,
    output: Option<PathBuf>,
}

static PLACES: OnceLock<Places> = OnceLock::new();

/// The files that a command reads and writes.
#[derive(Default)]
pub struct Files<'a> {
    pub read: Vec<&'a mut PathBuf>,
    pub written: Vec<Written<'a>>,
    /// A flag that was given and makes several files of one.
    pub split: Option<&'static str>,
}

/// A file that a command writes.
pub struct Written<'a> {
    /// The argument that names it.
    pub flag: &'static str,
    pub path: &'a mut PathBuf,
    /// The format that is asked for, by the ending of its files' names.
    pub format: Option<&'a str>,
}

/// The temporary files behind the standard streams. Dropped, they are gone.
pub struct Streams {
    folder: Option<TempDir>,
}

impl Streams {
    /// Replaces the streams' names by those of temporary files, and copies the standard input to its own.
    pub fn open(files: Files) -> Result<Self, Failure> {
        let mut streams = Self { folder: None };
        // What is wrong with the output is found before anybody waits for the input.
        let output = streams.output(files.written, files.split)?;
        let input = streams.input(files.read)?;
        PLACES.get_or_init(|| Places { input, output });
        Ok(streams)
    }

    fn input(&mut self, files: Vec<&mut PathBuf>) -> Result<Option<PathBuf>, Failure> {
        let mut named = files.into_iter().filter(|path| path.as_os_str() == STREAM);
        let Some(first) = named.next() else { return Ok(None) };
        if named.next().is_some() {
            return Err(Failure::usage("the standard input can be read once: give one of the files a name"));
        }
        let mut input = io::stdin().lock();
        if input.is_terminal() {
            return Err(Failure::usage("-: the standard input is a terminal: give a file, or pipe one in"));
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
                "--format is for {flag} -: a file's name says its format by its ending"
            )));
        }
        let Some(Written { flag, path, format }) = streams.pop() else { return Ok(None) };
        if !streams.is_empty() {
            return Err(Failure::usage("one file alone can go to the standard output: name the others"));
        }
        if let Some(split) = split {
            return Err(Failure::Usage(format!(
                "{split} makes several files, and {flag} - is one: give them a name"
            )));
        }
        let Some(format) = format else {
            return Err(Failure::Usage(format!("{flag} -: say with --format in which format")));
        };
        if io::stdout().is_terminal() {
            return Err(Failure::Usage(format!(
                "{flag} -: the standard output is a terminal: redirect it, or give a file"
            )));
        }
        // From here on an interrupted program has a folder to remove.
        interrupt::catch()?;
        *path = self.folder()?.join(format!("stdout.{format}"));
        Ok(Some(path.clone()))
    }

    /// Copies what was written to the standard output.
    pub fn finish(self) -> Result<(), Failure> {
        let Some(path) = PLACES.get().and_then(|places| places.output.as_ref()) else { return Ok(()) };
        let mut file = File::open(path).map_err(Failure::work)?;
        let mut out = io::stdout().lock();
        io::copy(&mut file, &mut out)?;
        Ok(out.flush()?)
    }

    fn folder(&mut self) -> Result<&Path, Failure> {
        if self.folder.is_none() {
            let folder = tempfile::Builder::new().prefix("relief-").tempdir();
            self.folder = Some(folder.map_err(|error| {
                Failure::Work(format!("a folder for temporary files cannot be made: {error}"))
            })?);
        }
        Ok(self.folder.as_ref().map_or(Path::new(""), TempDir::path))
    }
}

/// Whether a path is that of the standard input's copy.
pub fn is_input(path: &Path) -> bool {
    PLACES.get().is_some_and(|places| places.input.as_deref() == Some(path))
}

/// A text with the streams' names in place of their temporary files'.
pub fn named(text: &str) -> String {
    let mut text = text.to_owned();
    if let Some(places) = PLACES.get() {
        for (path, name) in [(&places.input, INPUT), (&places.output, "standard output")] {
            if let Some(path) = path {
                text = text.replace(&path.display().to_string(), name);
            }
        }
    }
    text
}

/// Says the answer to a command: on the standard output, or where a file goes there, on the standard error.
pub fn answer(write: impl FnOnce(&mut Vec<u8>) -> Result<(), Failure>) -> Result<(), Failure> {
    say_answer(write, true)
}

/// Says what a command wrote into files. With `--quiet` nothing is said, unless `json` was asked for: the files
/// are the result.
pub fn tell_written(
    json: bool,
    write: impl FnOnce(&mut Vec<u8>) -> Result<(), Failure>,
) -> Result<(), Failure> {
    say_answer(write, json || say::loudness() != Loudness::Quiet)
}

fn say_answer(
    write: impl FnOnce(&mut Vec<u8>) -> Result<(), Failure>,
    is_heard: bool,
) -> Result<(), Failure> {
    let mut text = Vec::new();
    write(&mut text)?;
    if !is_heard {
        return Ok(());
    }
    let text = named(&String::from_utf8_lossy(&text));
    match PLACES.get() {
        Some(Places { output: Some(_), .. }) => Ok(io::stderr().lock().write_all(text.as_bytes())?),
        _ => Ok(io::stdout().lock().write_all(text.as_bytes())?),
    }
}
