//! Scenes whose files are in memory.

use relief_core::Volume;
use relief_io::{Files, MemoryFiles, TexelFormat, VolumeFormat, write_exr, write_volume};

use super::*;
use crate::SceneReader;

/// A triangle with texture coordinates, a buffer of its own and a picture.
const GLTF: &str = r#"{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
  "nodes": [{"mesh": 0}],
  "buffers": [{"uri": "parts/triangle%20one.bin", "byteLength": 60}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 24}],
  "accessors": [
    {"bufferView": 0, "count": 3, "componentType": 5126, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
    {"bufferView": 1, "count": 3, "componentType": 5126, "type": "VEC2"}],
  "images": [{"uri": "parts/picture.png"}], "textures": [{"source": 0}],
  "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}, "extras": {"relief":
    {"height": "parts/heights.exr", "scale": 0.02}}}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}]}"#;

const OBJECT: &str = r#"kind = "orthographic"
centre = [0, 0, 0]
radius = 1.0
depth = "images/depth.exr"
color = "color.png"
[[view]]
from = [1, 0, 0]
rect = [0, 0, 4, 4]
"#;

const TABLE: &str = "0% 10 20 30\n100% 200 210 220\n";

/// Scenes, and files that they read and that must exist.
const SCENES: [(&str, &[&str]); 10] = [
    (
        "height = 'maps/noise.png'\ncolor = '../there/maps/color.png'\nnormal = 'maps/color.png'",
        &["maps/noise.png"],
    ),
    ("height = 'maps/heights.exr'\nramp = 'table.txt'", &["maps/heights.exr", "table.txt"]),
    ("height = 'maps/ground.pgm'\nraw = '4x2,le'", &["maps/ground.pgm"]),
    (
        "height = 'maps/noise.png'\nmesh = 'mesh/triangle.gltf'",
        &["mesh/parts/triangle one.bin", "mesh/triangle.gltf"],
    ),
    ("mesh = 'mesh/triangle.gltf'", &["mesh/parts/picture.png", "mesh/parts/heights.exr"]),
    ("textures = 'set'", &[]),
    ("object = 'object/object.toml'", &["object/object.toml", "object/images/depth.exr", "object/color.png"]),
    ("volume = 'volume.ktx2'\nmesh = 'sphere'", &["volume.ktx2"]),
    ("motif = 'ring.obj'", &["ring.obj"]),
    (
        "height = 'maps/noise.png'\nenvironment = 'maps/heights.exr'\nbackground = 'environment'",
        &["maps/heights.exr"],
    ),
];

/// Writes all files of the scenes.
fn write_files(folder: &Path) {
    for part in ["maps", "mesh/parts", "set", "object/images"] {
        fs::create_dir_all(folder.join(part)).expect("a folder");
    }
    let copy = |from: &str, to: &str| fs::copy(shipped(from), folder.join(to)).map(drop).expect("a copy");
    copy("data/noise.png", "maps/noise.png");
    copy("data/piebald.png", "maps/color.png");
    copy("data/piebald.png", "mesh/parts/picture.png");
    copy("data/noise.png", "set/wall_height.png");
    copy("data/piebald.png", "set/wall_color.png");
    copy("data/column.obj", "ring.obj");
    let heights: Vec<f32> = (0..32).map(|at| (at * at % 7) as f32 / 7.0).collect();
    let exr = |name: &str| write_exr(&folder.join(name), 8, 4, &[("Y", &heights)]).expect("an EXR file");
    ["maps/heights.exr", "mesh/parts/heights.exr", "object/images/depth.exr"]
        .iter()
        .for_each(|name| exr(name));
    let picture: Vec<u8> = (0..96).collect();
    relief_io::write_png8(&folder.join("object/color.png"), 8, 4, relief_io::PngColour::Rgb, &picture)
        .expect("a PNG file");
    let volume = Volume::new([3, 3, 2], &heights[..18], Wrap::Repeat).expect("a volume");
    let format = VolumeFormat { texel: TexelFormat::R32F, ..VolumeFormat::default() };
    write_volume(&folder.join("volume.ktx2"), &volume, &format).expect("a KTX2 file");
    let numbers = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0f32];
    let bytes: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
    let texts = [
        ("mesh/parts/triangle one.bin", &bytes[..]),
        ("mesh/triangle.gltf", GLTF.as_bytes()),
        ("object/object.toml", OBJECT.as_bytes()),
        ("table.txt", TABLE.as_bytes()),
        ("maps/ground.pgm", &bytes[..16]),
    ];
    texts.iter().for_each(|(name, bytes)| fs::write(folder.join(name), bytes).expect("a file"));
}

/// Reads all files below a folder into memory, under the paths from `root`.
fn in_memory(root: &Path, folder: &Path, memory: &mut MemoryFiles) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        match path.is_dir() {
            true => in_memory(root, &path, memory),
            false => {
                let name = path.strip_prefix(root).expect("inside");
                memory.insert(name, fs::read(&path).expect("a file")).expect("a path");
            }
        }
    }
}

/// A folder on disk with all files, and the same files in memory, both in the folder `there`.
fn both() -> (tempfile::TempDir, MemoryFiles) {
    let root = tempfile::tempdir().expect("a folder");
    write_files(&root.path().join("there"));
    let mut memory = MemoryFiles::new();
    in_memory(root.path(), root.path(), &mut memory);
    (root, memory)
}

#[test]
fn scenes_in_memory_are_those_on_disk() {
    let (root, mut memory) = both();
    for (text, needed) in SCENES {
        let path = Path::new("there/scene.toml");
        fs::write(root.path().join(path), text).expect("a scene");
        memory.insert(path, text.as_bytes()).expect("a path");
        let files = Files::Memory(memory.clone());
        let on_disk = read_scene(&root.path().join(path)).and_then(|spec| spec.load()).expect(text);
        let spec = read_scene(files.source(path)).expect(text);
        let here = spec.load_from(&files).expect(text);
        // Notes name files.
        let from_root = format!("{}/", root.path().display());
        assert!(format!("{on_disk:?}").replace(&from_root, "") == format!("{here:?}"), "{text}");
        for name in needed {
            let mut fewer = memory.clone();
            fewer.remove(Path::new("there").join(name)).expect("a file of the scene");
            let error = spec.load_from(&Files::Memory(fewer)).expect_err(name).to_string();
            assert!(error.contains(name) && error.contains("not among the files"), "{text}: {error}");
        }
    }
}

#[test]
fn files_that_changed_in_memory_are_read_again() {
    let (_root, memory) = both();
    for (text, needed) in SCENES {
        let spec = parse_scene(text, Path::new("there/scene.toml")).expect(text);
        let mut reader = SceneReader::of_files(Files::Memory(memory.clone()));
        let first = reader.load(&spec).expect(text);
        let is_same =
            |scene: &Scene| Arc::ptr_eq(first.surfaces()[0].height_map(), scene.surfaces()[0].height_map());
        assert!(is_same(&reader.load(&spec).expect(text)), "{text}");
        for name in needed {
            let Files::Memory(files) = reader.files_mut() else { panic!("in memory") };
            let path = Path::new("there").join(name);
            let bytes = files.remove(&path).expect("a file of the scene");
            assert!(reader.load(&spec).is_err(), "{text} without {name}");
            let Files::Memory(files) = reader.files_mut() else { panic!("in memory") };
            files.insert(&path, bytes).expect("a path");
            assert!(!is_same(&reader.load(&spec).expect(text)), "{text} with {name}");
        }
    }
}
