//! What a material for an engine is made from: a height map, or a folder of textures.

use std::collections::BTreeSet;
use std::fs::File;
use std::path::{Path, PathBuf};

use relief_core::{HeightMap, Metric};
use relief_io::{
    Convention, GreenSign, Remark, TextureRole, TextureSet, find_textures, material_name, omissions,
    read_height_file, read_normal_map,
};
use relief_scene::engine_material::EngineMaterial;
use relief_scene::green_remark;

use super::super::Arguments;
use super::super::job::metric;
use crate::advice;
use crate::commands::maps::{self, By, Note};
use crate::failure::Failure;
use crate::file_kind::FileKind;

/// Number of the way in which textures are packed and named. Files of other numbers are out of date.
const REVISION: u32 = 1;

/// Height map or folder of textures.
pub struct MaterialSource {
    /// Name of the material.
    pub name: String,
    /// Textures, if it is a folder.
    pub set: Option<TextureSet>,
    /// File of the heights.
    pub height: PathBuf,
    is_depth: bool,
}

impl MaterialSource {
    /// Finds what the command line names, and checks that it can be written to the output.
    pub fn find(arguments: &Arguments) -> Result<Self, Failure> {
        let Arguments { height: path, output, engine, .. } = arguments;
        let folder = &engine.folder;
        if arguments.file().is_some() {
            let name = output.display();
            let what = "an engine gets several files: give the name of a folder";
            return Err(Failure::Usage(format!("--output {name}: {what}")));
        }
        if output.exists() && !output.is_dir() {
            let folder = output.display();
            return Err(Failure::Work(format!("{folder}: this is not a folder: give another --output")));
        }
        if !path.is_dir() {
            if folder.udim.is_some() || (folder.green.is_some() && folder.maps.first().is_none()) {
                let what = "--udim and --green are for folders of textures: leave them out";
                return Err(Failure::usage(what));
            }
            let name = material_name(path);
            let is_depth = arguments.reading.depth;
            if folder.maps.height().is_some() {
                let what = "--height: the height map is named already: leave one out";
                return Err(Failure::usage(what));
            }
            let named = TextureSet { name: name.clone(), textures: Vec::new(), left: Vec::new() };
            let set = folder.maps.first().map(|_| folder.maps.over(named));
            return Ok(Self { name, set, height: path.clone(), is_depth });
        }
        if FileKind::of(path)? == FileKind::Object {
            let name = path.display();
            return Err(Failure::Work(format!(
                "{name}: this is a depth object, which engines have no material for: give a folder of \
                 textures"
            )));
        }
        // Links are followed. An output that is missing is no folder yet.
        if path.canonicalize().ok() == output.canonicalize().ok() {
            let folder = output.display();
            let what = "the files would be taken for textures of the set: give another --output";
            return Err(Failure::Usage(format!("{folder}: {what}")));
        }
        let set = find_textures(path, folder.udim)
            .map_err(|error| Failure::Work(advice::with_flag(&error, advice::of_textures(&error))))?;
        let set = folder.maps.over(set);
        let found = set.height();
        let found =
            found.map_err(|error| Failure::Work(advice::with_flag(&error, advice::of_textures(&error))))?;
        let is_depth = arguments.reading.depth || found.role == TextureRole::Depth;
        Ok(Self { name: set.name.clone(), height: found.path.clone(), is_depth, set: Some(set) })
    }

    /// Reads the heights. Returns them with their displacement, and notes on everything that is read.
    pub fn heights(&self, arguments: &Arguments) -> Result<(HeightMap, Metric, BTreeSet<Note>), Failure> {
        let mut options = arguments.reading.options(arguments.max_memory);
        options.convention = self.is_depth.then_some(Convention::Depth);
        let file = read_height_file(&self.height, &options).map_err(Failure::of_map)?;
        let mut notes = maps::of_file_read_as(&self.height, &file, &arguments.reading, self.is_depth);
        let map = file.map;
        let metric = metric(arguments, &map)?;
        // Heights of a mesh have a level of their own.
        let stated = map.stated_displacement_m().filter(|_| arguments.scale.is_none());
        let [low, high] = stated.unwrap_or([-metric.scale_m, 0.0]);
        let map = map.with_displacement(high - low, low).map_err(Failure::usage)?;
        notes.extend(maps::of_depth(&self.height, &map, metric));
        Ok((map, metric, notes))
    }

    /// Returns the direction of green in the set's normal map.
    pub fn green(&self, arguments: &Arguments) -> GreenSign {
        let texture = self.set.as_ref().and_then(|set| set.texture(TextureRole::Normal));
        let of_name = texture.and_then(|texture| texture.green);
        arguments.engine.folder.green.or(of_name).unwrap_or_default()
    }
}

/// Returns notes on a set: what is taken and what is left, and what its pictures say that is not
/// followed.
pub fn notes_on(set: &TextureSet, material: &EngineMaterial, height: &Path, folder: &Path) -> BTreeSet<Note> {
    let name = |path: &Path| path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
    let of_heights = set.textures.iter().find(|texture| texture.path == height);
    let taken: Vec<_> = of_heights.into_iter().chain(material.files()).collect();
    let each: Vec<String> =
        taken.iter().map(|texture| format!("{} from {}", texture.role, name(&texture.path))).collect();
    let text = format!("the textures {}: {}", set.name, each.join(", "));
    let mut remarks = vec![Remark::new(&omissions::TEXTURE_SET, text)];
    let unread = material.unread().into_iter();
    let unread = unread.map(|texture| format!("{} ({} is not written)", name(&texture.path), texture.role));
    let left = set.left.iter().map(|(path, why)| format!("{} ({why})", name(path)));
    let left: Vec<String> = unread.chain(left).collect();
    if !left.is_empty() {
        let text = format!("left out of the textures {}: {}", set.name, left.join(", "));
        remarks.push(Remark::new(&omissions::LEFT_TEXTURES, text));
    }
    let of_set = remarks.into_iter().map(|remark| By::Flags.note(&remark.of(folder)));
    let of_pictures = taken.iter().filter(|texture| texture.path != height);
    of_set.chain(of_pictures.flat_map(|texture| maps::of_picture(&texture.path))).collect()
}

/// Returns a note if a normal map whose name does not tell its green fits the heights better with
/// the other green.
pub fn other_green(
    arguments: &Arguments,
    set: &TextureSet,
    map: &HeightMap,
) -> Result<Option<Note>, Failure> {
    let unclear = set.texture(TextureRole::Normal).filter(|texture| texture.green.is_none());
    let (Some(texture), None) = (unclear, arguments.engine.folder.green) else { return Ok(None) };
    let max_bytes = arguments.max_memory.map_or(relief_io::DEFAULT_MAX_BYTES, |size| size.0);
    let normals = read_normal_map(&texture.path, GreenSign::PlusY, max_bytes).map_err(Failure::of_picture)?;
    Ok(green_remark(map, &normals).map(|remark| By::Flags.note(&remark.of(&texture.path))))
}

/// Returns a hash of everything that decides the bytes of the files.
pub fn key(
    material: &EngineMaterial,
    source: &MaterialSource,
    arguments: &Arguments,
    map: &HeightMap,
    metric: Metric,
) -> Result<String, Failure> {
    let mut hasher = blake3::Hasher::new();
    let about = format!(
        "{} {REVISION} {} {} {:?} {:?} {} {} {}x{} {}",
        env!("CARGO_PKG_VERSION"),
        material.engine().name,
        source.name,
        metric,
        [map.scale_m(), map.bias_m()],
        map.wrap().name(),
        map.heights_hash(),
        map.width(),
        map.height(),
        source.green(arguments)
    );
    hasher.update(about.as_bytes());
    for texture in material.files() {
        let path = &texture.path;
        let mut hash_file = || {
            hasher.update(format!("\n{:?} {:?} ", texture.role, path.file_name()).as_bytes());
            hasher.update_reader(File::open(path)?).map(drop)
        };
        hash_file().map_err(|error| Failure::Work(format!("{}: cannot be read: {error}", path.display())))?;
    }
    Ok(hasher.finalize().to_hex().to_string())
}
