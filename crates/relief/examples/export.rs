//! Exports a method as a shader, and says what a program has to bind.

use std::error::Error;

use relief::export::{Options, Profile, export};
use relief::shaders::Selection;

fn main() -> Result<(), Box<dyn Error>> {
    let selection = Selection::method("relief")?;
    let options = Options { profiles: vec![Profile::Core450, Profile::Spirv13], ..Options::default() };
    let exported = export(&selection, &options)?;
    for file in &exported.files {
        println!("{}: {} bytes", file.name, file.bytes.len());
    }
    for bound in &exported.manifest.bindings {
        println!("group {}, binding {}: {}, {}", bound.group, bound.binding, bound.name, bound.holds);
    }
    Ok(())
}
