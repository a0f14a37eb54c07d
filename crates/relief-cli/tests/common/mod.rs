//! Common parts of the tests.

// Each test binary compiles this module and uses a part of it.
#![allow(dead_code)]

pub mod aov;
pub mod command;
pub mod files;
pub mod maps;
pub mod meshes;
pub mod reference;
pub mod refused;
