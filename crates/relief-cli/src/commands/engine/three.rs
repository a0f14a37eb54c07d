//! The kit of three.js: a page that shows the mesh.

use std::path::{Path, PathBuf};

use relief_export::Profile;
use relief_io::{
    EngineShape, Ktx2Texture, Metadata, RowSource, TexelFormat, TextureContent, WriteError, write_atomically,
    write_engine_model, write_ktx2,
};
use serde_json::{Map, Value, json};

use super::kit::{EngineKit, Sheet};

pub const KIT: EngineKit = EngineKit {
    engine: "three",
    title: "three.js",
    profiles: &[Profile::Wgsl, Profile::Es300],
    placement: None,
    has_manifest: true,
    // Other programs show the glTF with normals; heights they have no slot for.
    takes: |content| !matches!(content, TextureContent::Height(_)),
    map_ending: "ktx2",
    write_map,
    files: &[
        ("relief.js", include_str!("../../../engines/three/relief.js")),
        ("relief.d.ts", include_str!("../../../engines/three/relief.d.ts")),
        ("package.json", include_str!("../../../engines/three/page_package.json")),
    ],
    made: |name| vec![format!("{name}.gltf"), format!("{name}.bin"), "index.html".to_owned()],
    make,
    next: |_, folder| {
        let folder = folder.display();
        format!("  open it: cd '{folder}', then npm install, then npm start")
    },
};

const PAGE: &str = include_str!("../../../engines/three/page.html");

/// What stands in the page in place of the material's facts.
const FACTS: &str = "id=\"relief\">{}<";

/// KTX2 with floats, which three.js' loader keeps.
pub fn write_map(
    path: &Path,
    [width, height]: [u32; 2],
    channels: usize,
    rows: &mut RowSource<'_>,
) -> Result<(), WriteError> {
    let format = match channels {
        1 => TexelFormat::R32F,
        2 => TexelFormat::Rg32F,
        _ => TexelFormat::Rgba32F,
    };
    let size = [width, height, 1];
    let metadata = Metadata::default();
    write_ktx2(path, &Ktx2Texture { format, size, levels: 1, channels, zstd: false, metadata }, rows)
}

fn make(sheet: &Sheet, places: &[PathBuf]) -> Result<(), WriteError> {
    let [gltf, buffer, page] = places else { return Ok(()) };
    let model = sheet.material.model(sheet.facts, EngineShape::Mesh(sheet.mesh.clone()));
    write_engine_model(&model, gltf, buffer, &format!("{}.bin", sheet.name))?;
    let maps: Map<String, Value> =
        sheet.maps.iter().map(|(name, file)| (name.clone(), address(file).into())).collect();
    let facts = json!({
        "functions": "relief.json",
        "mesh": address(&format!("{}.gltf", sheet.name)),
        "maps": maps,
        "scale": sheet.scale_m,
    });
    // No text within a page's script may end it.
    let facts = facts.to_string().replace('<', "\\u003c");
    let text = PAGE.replace(FACTS, &format!("id=\"relief\">{facts}<"));
    write_atomically(page, |out| out.write_all(text.as_bytes()))
}

/// A file's name as an address beside the page.
fn address(name: &str) -> String {
    format!("./{}", relief_io::percent_encoded(name))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_has_a_place_for_facts() {
        assert_eq!(PAGE.matches(FACTS).count(), 1);
    }
}
