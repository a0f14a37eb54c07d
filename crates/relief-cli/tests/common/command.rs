//! Runs the `relief` command as its users do: in a folder, by a line.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use serde_json::Value;

/// A folder of its own for one test, removed at the end.
pub struct Folder(tempfile::TempDir);

/// Result of a command.
#[derive(Debug)]
pub struct Ran {
    pub line: String,
    /// None after a signal.
    pub code: Option<i32>,
    pub stdout: String,
    pub stderr: String,
}

impl Folder {
    pub fn new() -> Self {
        Self(tempfile::tempdir().expect("a temporary folder"))
    }

    pub fn path(&self, name: impl AsRef<Path>) -> PathBuf {
        self.0.path().join(name)
    }

    /// Writes a file, in a folder that is made if it is missing.
    pub fn write(&self, name: &str, bytes: impl AsRef<[u8]>) {
        let path = self.path(name);
        std::fs::create_dir_all(path.parent().expect("a folder")).expect("the temporary folder is writable");
        std::fs::write(path, bytes).expect("the temporary folder is writable");
    }

    /// The command in this folder, without arguments. It keeps baked maps in a folder of the test's
    /// own.
    pub fn command(&self) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_relief"));
        command.current_dir(self.0.path()).env("RELIEF_CACHE", self.path(".cache")).stdin(Stdio::null());
        command
    }

    /// Runs the command with the words of a line as arguments.
    pub fn relief(&self, line: &str) -> Ran {
        self.with(line, line.split_ascii_whitespace())
    }

    /// Runs the command with arguments of any kind.
    pub fn with<A: AsRef<OsStr>>(&self, line: &str, arguments: impl IntoIterator<Item = A>) -> Ran {
        let output = self.command().args(arguments).output().expect("the command starts");
        Ran::new(line, &output)
    }
}

impl Ran {
    pub fn new(line: &str, output: &Output) -> Self {
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        let (stdout, stderr) = (text(&output.stdout), text(&output.stderr));
        Self { line: line.to_owned(), code: output.status.code(), stdout, stderr }
    }

    /// Fails unless the command succeeded without a word on standard error.
    pub fn fine(self) -> Self {
        assert_eq!((self.code, self.stderr.as_str()), (Some(0), ""), "relief {}", self.line);
        self
    }
}

/// The JSON that a command has answered.
pub fn json_of(ran: &Ran) -> Value {
    serde_json::from_str(&ran.stdout).unwrap_or_else(|error| panic!("relief {}: {error}", ran.line))
}
