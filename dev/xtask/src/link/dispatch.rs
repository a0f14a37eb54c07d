//! The dispatch module: a `switch` a stage, written from the registry's lists.
//!
//! On a GPU the choice is a pipeline-overridable constant, so that the driver compiles the chosen variant alone; on a CPU,
//! where such constants do not translate, it is a field of the settings.

use std::fmt::Write as _;

use relief_core::registry::Entry;
use relief_shaders::{refine, search, shade, surface};

struct Stage {
    /// Folder and function prefix.
    name: &'static str,
    entries: &'static [Entry],
    /// Parameters of the stage's function, as declared and as passed on.
    declared: &'static str,
    passed: &'static str,
    returns: &'static str,
}

const STAGES: [Stage; 4] = [
    Stage {
        name: "surface",
        entries: surface::ENTRIES,
        declared: "pixel: PixelIn",
        passed: "pixel",
        returns: "Entered",
    },
    Stage {
        name: "search",
        entries: search::ENTRIES,
        declared: "path: Path",
        passed: "path, settings.search_params",
        returns: "Found",
    },
    Stage {
        name: "refine",
        entries: refine::ENTRIES,
        declared: "path: Path, found: Found",
        passed: "path, found, settings.refine_params",
        returns: "Hit",
    },
    Stage {
        name: "shade",
        entries: shade::ENTRIES,
        declared: "position: vec3f, normal: vec3f, view: vec3f, color: vec3f",
        passed: "position, normal, view, color",
        returns: "vec3f",
    },
];

/// The module's source.
pub fn module() -> String {
    let mut imports = String::from(
        "import package::shared::types::{PixelIn, Entered, Path, Found, Hit};\n\
         import package::shared::settings::settings;\n",
    );
    let mut body = String::new();
    for stage in &STAGES {
        write_stage(&mut imports, &mut body, stage);
    }
    imports + &body
}

fn write_stage(imports: &mut String, body: &mut String, stage: &Stage) {
    let Stage { name, entries, declared, passed, returns } = stage;
    let constant = name.to_uppercase();
    let mut arms = String::new();
    for (place, entry) in entries.iter().enumerate() {
        let stem = entry.name.replace('-', "_");
        let function = format!("{name}_{stem}");
        let _ = writeln!(imports, "import package::{name}::{stem}::{function};");
        let label = if place + 1 == entries.len() { "default".to_owned() } else { format!("case {place}u") };
        let _ = writeln!(arms, "        {label}: {{ return {function}({passed}); }}");
    }
    let _ = write!(
        body,
        "\n@if(gpu) override {constant}: u32 = 0u;\n\
         @if(gpu) fn chosen_{name}() -> u32 {{ return {constant}; }}\n\
         @if(!gpu) fn chosen_{name}() -> u32 {{ return settings.{name}; }}\n\
         \nfn {name}_stage({declared}) -> {returns} {{\n    switch (chosen_{name}()) {{\n{arms}    }}\n}}\n"
    );
}
