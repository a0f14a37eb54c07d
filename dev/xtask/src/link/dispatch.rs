//! The dispatch modules, one a stage, written from the registry's table of stages: a `switch` over the
//! variants. A stage may call another one's without a circle of modules.
//!
//! That is for the CPU. For GPUs the library assembles programs in which a stage calls the chosen variant and
//! no other.

use std::fmt::Write as _;

use relief_shaders::{STAGES, Stage};

/// Names and sources of the modules.
pub fn modules() -> impl Iterator<Item = (String, String)> {
    STAGES
        .iter()
        .enumerate()
        .map(|(place, stage)| (format!("dispatch/{}", stage.key.replace('-', "_")), module(place, stage)))
}

fn module(place: usize, stage: &Stage) -> String {
    let Stage { folder, entries, inputs, returns, .. } = stage;
    let declared: Vec<String> = inputs.iter().map(|(name, kind)| format!("{name}: {kind}")).collect();
    let passed: Vec<&str> = inputs.iter().map(|(name, _)| *name).collect();
    let (declared, passed) = (declared.join(", "), passed.join(", "));
    let mut text = String::from(
        "import package::shared::types::{PixelIn, Entered, Path, Found, Hit, Toward};\n\
         import package::bindings::surface_settings;\n",
    );
    let mut arms = String::new();
    for (number, entry) in entries.iter().enumerate() {
        let stem = entry.name.replace('-', "_");
        let function = stage.function_of(entry);
        let _ = writeln!(text, "import package::{folder}::{stem}::{function};");
        let label =
            if number + 1 == entries.len() { "default".to_owned() } else { format!("case {number}u") };
        let _ = writeln!(
            arms,
            "        {label}: {{ return {function}({passed}, surface_settings.choices[{place}].params); }}"
        );
    }
    let number = format!("surface_settings.choices[{place}].number");
    let _ = write!(
        text,
        "\nfn {}({declared}) -> {returns} {{\n    switch ({number}) {{\n{arms}    }}\n}}\n",
        stage.function()
    );
    text
}
