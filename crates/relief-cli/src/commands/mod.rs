//! The subcommands, one file each.

pub mod bake;
pub mod height;
pub mod inspect;
pub mod maps;
pub mod methods;
pub mod render;
