//! The dispatch modules, one a stage, written from the registry's table of stages: a `switch` over the
//! variants. A stage may call another one's without a circle of modules.
//!
//! That is for the CPU. For GPUs the library assembles programs in which a stage calls the chosen variant and
//! no other.

use std::fmt::Write as _;

use relief_shaders::{Call, STAGES, Stage};

/// Names and sources of the modules.
pub fn modules() -> impl Iterator<Item = (String, String)> {
    STAGES
        .iter()
        .enumerate()
        .filter(|(_, stage)| !stage.calls.is_empty())
        .map(|(place, stage)| (format!("dispatch/{}", stage.key.replace('-', "_")), module(place, stage)))
}

fn module(place: usize, stage: &Stage) -> String {
    let mut text = String::from(
        "import package::shared::types::{PixelIn, Entered, Path, Found, Hit, Toward};\n\
         import package::bindings::surface_settings;\n",
    );
    let mut functions = String::new();
    for call in stage.calls {
        for entry in stage.entries {
            let stem = entry.name.replace('-', "_");
            let _ = writeln!(
                text,
                "import package::{}::{stem}::{};",
                stage.folder,
                stage.function_of(call, entry)
            );
        }
        functions.push_str(&function(place, stage, call));
    }
    text + &functions
}

/// The function that calls the variant of the number that the settings hold.
fn function(place: usize, stage: &Stage, call: &Call) -> String {
    let Stage { entries, .. } = stage;
    let declared: Vec<String> = call.inputs.iter().map(|(name, kind)| format!("{name}: {kind}")).collect();
    let passed: Vec<&str> = call.inputs.iter().map(|(name, _)| *name).collect();
    let (declared, passed) = (declared.join(", "), passed.join(", "));
    let mut arms = String::new();
    for (number, entry) in entries.iter().enumerate() {
        let function = stage.function_of(call, entry);
        let label =
            if number + 1 == entries.len() { "default".to_owned() } else { format!("case {number}u") };
        let _ = writeln!(
            arms,
            "        {label}: {{ return {function}({passed}, surface_settings.choices[{place}].params); }}"
        );
    }
    let number = format!("surface_settings.choices[{place}].number");
    let (name, returns) = (stage.function(call), call.returns);
    format!("\nfn {name}({declared}) -> {returns} {{\n    switch ({number}) {{\n{arms}    }}\n}}\n")
}
