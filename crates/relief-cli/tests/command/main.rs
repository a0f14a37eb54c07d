//! Common parts of all commands (command line, streams, errors), and `inspect` and `shader`.

#[path = "../common/mod.rs"]
mod common;

mod any_file;
mod bad_input;
mod command_line;
mod contract;
mod engine;
mod examples;
mod explain;
mod inspect;
mod shader;
mod streams;
