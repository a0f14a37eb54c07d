//! Fuzz targets: functions that take any bytes, with a small corpus for each and a seeded mutator.
//!
//! cargo-fuzz (the package in `fuzz/`), this crate's test and `relief-bench fuzz` run the same functions. A
//! target panics where the code that it calls breaks a promise; an error of that code is no failure.

// The makers of files come from the tests of `relief-io`.
#[path = "../../../crates/relief-io/tests/common/mod.rs"]
mod common;
mod mutator;
mod targets;

use std::panic::{AssertUnwindSafe, catch_unwind};

pub use targets::{
    BAKE, MESH, OBJECT, READ_HEIGHT, READ_MESH, READ_NORMALS, READ_PICTURE, READ_TEXTURE, READ_VOLUME, SCENE,
    TARGETS,
};

/// A fuzz target.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// The name, which is also the name of cargo-fuzz's target.
    pub name: &'static str,
    /// Takes any bytes. True where they are a valid input.
    ///
    /// # Panics
    ///
    /// When the code under test breaks a promise.
    pub run: fn(&[u8]) -> bool,
    /// Makes the corpus: small valid inputs, the same ones each time.
    pub make: fn() -> Vec<Vec<u8>>,
}

impl Target {
    /// Runs the target and catches its panic.
    ///
    /// # Errors
    ///
    /// When the target panics: the panic's message.
    pub fn attempt(&self, input: &[u8]) -> Result<bool, String> {
        catch_unwind(AssertUnwindSafe(|| (self.run)(input))).map_err(|panic| {
            let text = panic.downcast_ref::<String>().map(String::as_str);
            text.or(panic.downcast_ref::<&str>().copied()).unwrap_or("no message").to_owned()
        })
    }

    /// Makes the corpus.
    pub fn corpus(&self) -> Corpus {
        Corpus((self.make)())
    }
}

/// The valid inputs of a target, and what is made of them.
#[derive(Clone, Debug)]
pub struct Corpus(Vec<Vec<u8>>);

impl Corpus {
    /// The valid inputs.
    pub fn inputs(&self) -> &[Vec<u8>] {
        &self.0
    }

    /// One of the inputs after one or more mutations. The same seed gives the same bytes.
    pub fn mutated(&self, seed: u64) -> Vec<u8> {
        mutator::mutated(&self.0, seed)
    }
}

/// The bytes as text, up to the first that is no UTF-8.
fn text(bytes: &[u8]) -> &str {
    match str::from_utf8(bytes) {
        Ok(text) => text,
        Err(error) => str::from_utf8(&bytes[..error.valid_up_to()]).unwrap_or_default(),
    }
}

#[cfg(test)]
mod tests;
