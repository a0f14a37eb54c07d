//! Counts of the words in a source tree: worn phrases in comments and literals, and the sentence
//! lengths of markdown prose.
//!
//! The test `house` holds this project to limits. `cargo xtask words FOLDER` prints the same counts
//! of any tree with Rust sources.

pub mod markdown;
pub mod phrases;
pub mod rust;
pub mod sentences;
pub mod tree;
