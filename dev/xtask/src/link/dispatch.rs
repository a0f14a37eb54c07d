//! The dispatch modules, one a stage and one of procedures, written from the registry's lists: a `switch`
//! over the variants. A stage may call another one's without a circle of modules.
//!
//! That is for the CPU. For GPUs the library assembles programs in which a stage calls the chosen variant and
//! no other.

use std::fmt::Write as _;

use relief_shaders::{Call, STAGES, Stage, procedure};

/// Names and sources of the modules.
pub fn modules() -> impl Iterator<Item = (String, String)> {
    STAGES
        .iter()
        .enumerate()
        .filter(|(_, stage)| !stage.calls.is_empty())
        .map(|(place, stage)| (format!("dispatch/{}", stage.key.replace('-', "_")), module(place, stage)))
        .chain([("dispatch/procedure".to_owned(), procedures())])
}

/// The function that calls the procedure of a number.
pub const PROCEDURE: &str = "procedure_height";

fn procedures() -> String {
    let (mut imports, mut arms) = (String::new(), String::new());
    for (number, entry) in procedure::ENTRIES.iter().enumerate() {
        let (stem, function) = (entry.name.replace('-', "_"), procedure::function_of(entry));
        let _ = writeln!(imports, "import package::procedure::{stem}::{function};");
        let label = label(number, number + 1 == procedure::ENTRIES.len());
        let _ = writeln!(arms, "        {label}: {{ return {function}(place, time, seed, params); }}");
    }
    let inputs = "number: u32, place: vec2f, time: f32, seed: u32, params: vec4f";
    format!("{imports}\nfn {PROCEDURE}({inputs}) -> f32 {{\n    switch (number) {{\n{arms}    }}\n}}\n")
}

/// Label of a `switch` for a number.
fn label(number: usize, is_last: bool) -> String {
    if is_last { "default".to_owned() } else { format!("case {number}u") }
}

fn module(place: usize, stage: &Stage) -> String {
    let mut text = String::from(
        "import package::shared::types::{PixelIn, Entered, Path, SearchResult, Hit, Toward};\n\
         import package::shared::types::{LightRay, Material, Mirrored};\n\
         import package::shared::seen_normals::SeenNormals;\n\
         import package::bindings::surface_settings;\n",
    );
    let mut functions = String::new();
    for call in stage.calls {
        for (_, entry) in stage.entries_with(call) {
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
    let declared: Vec<String> = call.inputs.iter().map(|(name, kind)| format!("{name}: {kind}")).collect();
    let passed: Vec<&str> = call.inputs.iter().map(|(name, _)| *name).collect();
    let (declared, passed) = (declared.join(", "), passed.join(", "));
    let mut arms = String::new();
    let mut entries = stage.entries_with(call).peekable();
    while let Some((number, entry)) = entries.next() {
        let function = stage.function_of(call, entry);
        let label = label(number, entries.peek().is_none());
        let _ = writeln!(
            arms,
            "        {label}: {{ return {function}({passed}, surface_settings.choices[{place}].params); }}"
        );
    }
    let number = format!("surface_settings.choices[{place}].number");
    let (name, returns) = (stage.function(call), call.returns);
    format!("\nfn {name}({declared}) -> {returns} {{\n    switch ({number}) {{\n{arms}    }}\n}}\n")
}
