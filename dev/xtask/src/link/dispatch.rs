//! The dispatch modules, one a stage, written from the registry's table of stages: a `switch` over the variants. A stage
//! may call another one's without a circle of modules.
//!
//! On a GPU the choice is a pipeline-overridable constant, so that the driver compiles the chosen variant alone; on a CPU,
//! where such constants do not translate, it is a field of the settings.

use std::fmt::Write as _;

use relief_shaders::{STAGES, Stage};

/// Names and sources of the modules.
pub fn modules() -> impl Iterator<Item = (String, String)> {
    STAGES.iter().enumerate().map(|(place, stage)| (format!("dispatch/{}", stage.key), module(place, stage)))
}

fn module(place: usize, stage: &Stage) -> String {
    let Stage { key, entries, inputs, returns, .. } = stage;
    let declared: Vec<String> = inputs.iter().map(|(name, kind)| format!("{name}: {kind}")).collect();
    let passed: Vec<&str> = inputs.iter().map(|(name, _)| *name).collect();
    let (declared, passed) = (declared.join(", "), passed.join(", "));
    let mut text = String::from(
        "import package::shared::types::{PixelIn, Entered, Path, Found, Hit};\n\
         import package::shared::settings::settings;\n",
    );
    let mut arms = String::new();
    for (number, entry) in entries.iter().enumerate() {
        let stem = entry.name.replace('-', "_");
        let function = format!("{key}_{stem}");
        let _ = writeln!(text, "import package::{key}::{stem}::{function};");
        let label =
            if number + 1 == entries.len() { "default".to_owned() } else { format!("case {number}u") };
        let _ = writeln!(
            arms,
            "        {label}: {{ return {function}({passed}, settings.choices[{place}].params); }}"
        );
    }
    let constant = key.to_uppercase();
    let _ = write!(
        text,
        "\n@if(gpu) override {constant}: u32 = 0u;\n\
         @if(gpu) fn chosen_{key}() -> u32 {{ return {constant}; }}\n\
         @if(!gpu) fn chosen_{key}() -> u32 {{ return settings.choices[{place}].number; }}\n\
         \nfn {key}_stage({declared}) -> {returns} {{\n    switch (chosen_{key}()) {{\n{arms}    }}\n}}\n"
    );
    text
}
