//! `cargo xtask link`: WESL modules in, plain WGSL and its Rust translation out.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use crate::output::Generated;

mod constants;
mod dispatch;
mod layout;
mod modules;
mod naga_check;
mod rust;
mod wgsl;

/// A program to link: its root module and what of it is kept.
struct Program {
    /// Name of the generated file, without the sampling.
    name: &'static str,
    /// Path of the root module below the crate's `src`.
    root: &'static str,
    /// Declarations of the root to keep; empty keeps the entry points.
    keep: &'static [&'static str],
}

/// What GPUs run, each in both samplings.
const GPU_PROGRAMS: [Program; 2] = [
    Program { name: "render", root: "roots/render", keep: &[] },
    Program { name: "probe", root: "roots/probe", keep: &[] },
];

/// What is translated to Rust, in exact sampling.
const CPU_PROGRAM: Program =
    Program { name: "cpu", root: "shared/pixel", keep: &["shade_pixel", "pixel_of"] };

/// All generated files.
pub fn files(workspace: &Path) -> Result<Vec<Generated>, String> {
    let modules = modules::Modules::read(&workspace.join("crates/relief-shaders/src"))?;
    let folder = PathBuf::from("crates/relief-shaders/generated");
    let mut files = Vec::new();
    let mut shared = Vec::new();
    for program in &GPU_PROGRAMS {
        for (sampling, fast) in [("exact", false), ("fast", true)] {
            let text = wgsl::link(&modules, program, true, fast)?;
            let (module, _) = naga_check::validate(&text)
                .map_err(|error| format!("{} ({sampling}): {error}", program.name))?;
            shared.push(module);
            let header = wgsl::header(program.name, sampling);
            let path = folder.join(format!("{}_{sampling}.wgsl", program.name));
            files.push(Generated { path, bytes: format!("{header}\n{text}").into_bytes() });
        }
    }
    let text = wgsl::link(&modules, &CPU_PROGRAM, false, false)?;
    let (module, info) = naga_check::validate(&text).map_err(|error| format!("cpu: {error}"))?;
    naga_check::refuse_untranslatable(&module, &info, &text, &modules)?;
    let rust = rust::translate(&module, &info)?;
    files.push(Generated { path: folder.join("cpu.rs"), bytes: rust.into_bytes() });
    let translated: BTreeSet<String> = module.types.iter().filter_map(|(_, ty)| ty.name.clone()).collect();
    let layout = layout::write(&shared.iter().collect::<Vec<_>>(), &translated)?;
    files.push(Generated { path: folder.join("layout.rs"), bytes: layout.into_bytes() });
    Ok(files)
}
