//! `relief bake`: bakes a height map into the maps that methods read.
//!
//! A bake writes into a hidden folder inside the output folder: first raw texels, then finished
//! files. When all files of all kinds are whole, they take their names, with a manifest that lists
//! them. A bake that fails or is cancelled changes nothing.

mod arguments;
pub mod early;
mod files;
pub mod for_engine;
pub mod identity;
mod job;
mod outputs;
mod report;
mod source;
mod spool;
mod storage;
#[cfg(test)]
mod tests;

pub use self::arguments::{Arguments, MaterialJob};

use relief_bake::{Kind, Settings};
use relief_core::registry::UnknownName;

use self::job::Job;
use self::storage::FileFormat;
use crate::failure::Failure;
use crate::interrupt;
use crate::streams::tell_written;

/// Reads, bakes and writes.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    if let Some(name) = &arguments.engine.name {
        return for_engine::run(arguments, name);
    }
    arguments.refuse_folder()?;
    let kinds = choose(arguments, relief_bake::kind)?;
    let (job, map) = Job::new(arguments, kinds)?;
    // Until here nothing exists that an interrupted program would leave behind.
    let cancel = interrupt::catch()?;
    tell_written(arguments.json, |out| job.run(map, cancel, out))
}

/// The parameter that adds mip levels.
pub const MIPS: &str = "mips";

/// Returns the kinds of the given names, with their settings.
fn choose<'k>(
    arguments: &Arguments,
    kind_of: impl Fn(&str) -> Result<&'k Kind, UnknownName>,
) -> Result<Vec<(&'k Kind, Settings)>, Failure> {
    let mut kinds: Vec<(&Kind, Settings)> = Vec::new();
    for name in &arguments.kind {
        let kind = kind_of(name.trim()).map_err(Failure::usage)?;
        if !kinds.iter().any(|(known, _)| known.name == kind.name) {
            kinds.push((kind, kind.defaults()));
        }
    }
    for (key, value) in &arguments.set {
        let (name, param) = key.split_once('.').ok_or_else(|| {
            Failure::Usage(format!("--set {key}: write it as KIND.NAME=NUMBER, as in cone.bits=8"))
        })?;
        let names = kinds.iter().map(|(kind, _)| kind.name);
        let unknown = UnknownName::new("kind to bake", name, names);
        let name = kind_of(name).map_or(name, |kind| kind.name);
        let chosen = kinds.iter_mut().find(|(kind, _)| kind.name == name);
        let (_, settings) = chosen.ok_or_else(|| Failure::usage(unknown))?;
        settings.set(param, *value).map_err(Failure::usage)?;
    }
    // If each level is a file of its own, levels are written only when asked for.
    for (kind, settings) in &mut kinds {
        let is_given = |(key, _): &(String, f64)| {
            key.split_once('.').is_some_and(|(name, param)| {
                param == MIPS && kind_of(name).is_ok_and(|given| given.name == kind.name)
            })
        };
        let has_mips = kind.params.iter().any(|param| param.name == MIPS);
        if has_mips && !arguments.set.iter().any(is_given) {
            let mips = f64::from(u8::from(arguments.format_of(kind) == FileFormat::Ktx2));
            settings.set(MIPS, mips).map_err(Failure::usage)?;
        }
    }
    Ok(kinds)
}
