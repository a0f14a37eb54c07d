//! What a kit writes beside the textures of a material: functions, the maps that they read, a mesh, and
//! the engine's own files.

use std::io;
use std::path::{Path, PathBuf};

use relief_bake::{BakeError, Collected, Kind, Settings, kind};
use relief_core::mesh::Mesh;
use relief_core::{ByteSize, HeightMap, Metric, Watch};
use relief_export::{ExportedFunctions, FunctionOptions, FunctionsManifest, Placement, Profile, functions};
use relief_io::{Row, RowSource, TextureContent, WriteError, write_atomically};
use relief_scene::engine_material::EngineMaterial;
use relief_shaders::{METHODS, Selection};

use crate::commands::bake::for_engine::{Kit, KitInput, Outputs, ReadMaterial};
use crate::commands::bake::{MIPS, early};
use crate::commands::shader::{bake_line, of_export};
use crate::failure::Failure;
use crate::interrupt::cancelled;

/// Number of the way in which kits are written. Files of other numbers are out of date.
const REVISION: u32 = 1;

/// The name of the functions' files, which the kits' own files name.
const FUNCTIONS: &str = "relief";

/// Writes a texture of floats: the file, its columns and rows, its channels, and the rows.
pub type WriteMap = fn(&Path, [u32; 2], usize, &mut RowSource<'_>) -> Result<(), WriteError>;

/// The kit of an engine.
pub struct EngineKit {
    /// Name of the engine.
    pub engine: &'static str,
    /// The engine in prose.
    pub title: &'static str,
    /// The languages of its functions.
    pub profiles: &'static [Profile],
    /// The place of their textures, where it is not theirs to choose.
    pub placement: Option<Placement>,
    /// Whether the functions' description is written, too.
    pub has_manifest: bool,
    /// The textures of a material that it takes.
    pub takes: fn(TextureContent) -> bool,
    /// The ending of maps, in a format that keeps floats, and how they are written.
    pub map_ending: &'static str,
    pub write_map: WriteMap,
    /// Files that are the same for every material, with their contents.
    pub files: &'static [(&'static str, &'static str)],
    /// The names of the files that are made for a material.
    pub made: fn(&str) -> Vec<String>,
    /// Writes these to places of the same order.
    pub make: fn(&Sheet, &[PathBuf]) -> Result<(), WriteError>,
    /// What the user does next.
    pub next: fn(&str, &Path) -> String,
}

/// What a kit's own files say of a material.
pub struct Sheet<'a> {
    pub name: &'a str,
    pub mesh: &'a Mesh,
    /// The length from the height 0 to the height 1, in metres.
    pub scale_m: f64,
    /// The lengths of a tile that maps of the surface were baked with, in metres.
    pub tile_m: [f64; 2],
    /// Columns and rows of the height map.
    pub size: [u32; 2],
    pub functions: &'a FunctionsManifest,
    /// The maps that functions read: names in shaders, without the prefix, and files.
    pub maps: Vec<(String, String)>,
    pub material: &'a EngineMaterial<'a>,
    pub facts: &'a relief_scene::engine_material::WrittenFacts,
}

impl Sheet<'_> {
    /// The file of a texture, if there is one.
    pub fn texture(&self, is_meant: fn(TextureContent) -> bool) -> Option<String> {
        let found = self.material.textures().into_iter().find(|texture| is_meant(texture.content));
        found.map(|texture| self.material.file_name(texture))
    }
}

/// A baked map that functions read.
struct Baked {
    /// The name in shaders, without the prefix.
    name: String,
    kind: &'static Kind,
    settings: Settings,
    /// The texture's name among the kind's.
    texture: &'static str,
    /// Whether it is baked in the metres of the surface, not in units of the texture.
    is_of_surface: bool,
}

/// A kit on its way to a folder.
pub struct KitJob {
    kit: &'static EngineKit,
    name: String,
    mesh: Mesh,
    exported: ExportedFunctions,
    has_heights: bool,
    baked: Vec<Baked>,
    output: PathBuf,
}

impl KitJob {
    /// Checks that the kit can be written.
    pub fn new(
        kit: &'static EngineKit,
        material: &ReadMaterial,
        mesh: Mesh,
        selection: &Selection,
        max_memory: Option<ByteSize>,
        output: &Path,
    ) -> Result<Self, Failure> {
        if mesh.triangles().is_empty() {
            return Err(Failure::usage("--mesh: the mesh has no triangles: give another"));
        }
        let options = FunctionOptions {
            name: Some(FUNCTIONS.to_owned()),
            wrap: Some(material.map.wrap()),
            profiles: kit.profiles.to_vec(),
            placement: kit.placement,
            bake: Some(bake_line),
            ..FunctionOptions::default()
        };
        let exported = functions(selection, &options).map_err(of_export)?;
        let baked = maps_of(&exported.manifest).ok_or_else(|| of_maps(kit, &options))?;
        let size = [material.map.width(), material.map.height()];
        for map in &baked {
            let shapes = (map.kind.shapes)(size, &map.settings);
            early::check_memory(&shapes, size, true, max_memory).map_err(Failure::Work)?;
        }
        let has_heights = exported
            .manifest
            .bindings
            .iter()
            .any(|bound| own_name(&exported.manifest, &bound.name) == HEIGHTS);
        let (name, output) = (material.name.to_owned(), output.to_owned());
        Ok(Self { kit, name, mesh, exported, has_heights, baked, output })
    }

    fn map_file(&self, name: &str) -> String {
        format!("{}_{name}.{}", self.name, self.kit.map_ending)
    }

    /// The functions' files that are written.
    fn functions(&self) -> impl Iterator<Item = &relief_export::File> {
        let manifest = format!("{FUNCTIONS}.json");
        let is_written = move |file: &&relief_export::File| self.kit.has_manifest || file.name != manifest;
        self.exported.files.iter().filter(is_written)
    }

    /// The names of all maps that functions read.
    fn map_names(&self) -> Vec<String> {
        let heights = self.has_heights.then(|| HEIGHTS.to_owned());
        heights.into_iter().chain(self.baked.iter().map(|map| map.name.clone())).collect()
    }
}

/// The name of the height map in shaders, without the prefix.
const HEIGHTS: &str = "height_map";

impl Kit for KitJob {
    fn part(&self) -> String {
        format!("engine.{}", self.kit.engine)
    }

    fn takes(&self, content: TextureContent) -> bool {
        (self.kit.takes)(content)
    }

    fn names(&self) -> Vec<String> {
        let maps = self.map_names();
        let maps = maps.iter().map(|name| self.map_file(name));
        let functions = self.functions().map(|file| file.name.clone());
        let own = self.kit.files.iter().map(|(name, _)| (*name).to_owned());
        functions.chain(maps).chain(own).chain((self.kit.made)(&self.name)).collect()
    }

    fn key(&self) -> String {
        let mut hasher = blake3::Hasher::new();
        hasher.update(format!("{REVISION} {}", self.kit.engine).as_bytes());
        for file in &self.exported.files {
            hasher.update(&file.bytes);
        }
        for (_, text) in self.kit.files {
            hasher.update(text.as_bytes());
        }
        for map in &self.baked {
            hasher.update(format!("{} {}", map.kind.name, map.kind.revision).as_bytes());
        }
        for vertex in self.mesh.vertices() {
            let [along_u, along_v] = [vertex.tangent, vertex.bitangent];
            for part in [vertex.position, vertex.normal, along_u, along_v, vertex.uv.extend(0.0)] {
                part.to_array().iter().for_each(|number| _ = hasher.update(&number.to_le_bytes()));
            }
        }
        for corner in self.mesh.triangles().as_flattened() {
            hasher.update(&corner.to_le_bytes());
        }
        hasher.finalize().to_hex().to_string()
    }

    fn write(
        &self,
        input: &KitInput,
        outputs: &mut Outputs,
        watch: &Watch,
    ) -> Result<Vec<(String, PathBuf)>, Failure> {
        let mut files = Vec::new();
        let own = self.kit.files.iter().map(|(name, text)| (*name, text.as_bytes()));
        let texts = self.functions().map(|file| (file.name.as_str(), file.bytes.as_slice())).chain(own);
        for (name, bytes) in texts {
            let place = outputs.place(name)?;
            let written = write_atomically(&place, |out| out.write_all(bytes));
            written.map_err(|error| self.of_write(&error, name))?;
            files.push((name.to_owned(), place));
        }
        let size = [input.map.width(), input.map.height()];
        if self.has_heights {
            let texels = input.map.texels();
            files.push(self.write_map(HEIGHTS, size, &[texels], outputs)?);
        }
        for (number, map) in self.baked.iter().enumerate() {
            let part = |done: usize| done as f32 / self.baked.len() as f32;
            let baked = bake(map, input.map, input.metric, &watch.piece(part(number), part(number + 1)))?;
            let planes: Vec<&[f32]> = baked.planes.iter().map(Vec::as_slice).collect();
            files.push(self.write_map(&map.name, baked.size, &planes, outputs)?);
        }
        let names = (self.kit.made)(&self.name);
        let places = names.iter().map(|name| outputs.place(name)).collect::<Result<Vec<_>, _>>()?;
        let maps = self.map_names().into_iter().map(|name| {
            let file = self.map_file(&name);
            (name, file)
        });
        let sheet = Sheet {
            name: &self.name,
            mesh: &self.mesh,
            scale_m: input.map.scale_m(),
            tile_m: input.metric.tile_m,
            size,
            functions: &self.exported.manifest,
            maps: maps.collect(),
            material: input.material,
            facts: input.facts,
        };
        (self.kit.make)(&sheet, &places).map_err(|error| self.of_write(&error, &names[0]))?;
        files.extend(names.into_iter().zip(places));
        Ok(files)
    }

    fn next(&self) -> String {
        (self.kit.next)(&self.name, &self.output)
    }
}

impl KitJob {
    fn write_map(
        &self,
        name: &str,
        size: [u32; 2],
        planes: &[&[f32]],
        outputs: &mut Outputs,
    ) -> Result<(String, PathBuf), Failure> {
        let file = self.map_file(name);
        let place = outputs.place(&file)?;
        let width = size[0] as usize;
        let mut rows = |row: Row, texels: &mut [f32]| -> io::Result<()> {
            let begin = row.row as usize * width;
            texels.copy_from_slice(&planes[row.channel][begin..begin + width]);
            Ok(())
        };
        let written = (self.kit.write_map)(&place, size, planes.len(), &mut rows);
        written.map_err(|error| self.of_write(&error, &file))?;
        Ok((file, place))
    }

    /// The failure of a file, whose error names the place where it was prepared.
    fn of_write(&self, error: &WriteError, name: &str) -> Failure {
        Failure::Work(format!("{}: {}", self.output.join(name).display(), error.problem))
    }
}

/// A binding's name without the prefix.
fn own_name<'a>(manifest: &FunctionsManifest, name: &'a str) -> &'a str {
    name.strip_prefix(&manifest.prefix).map_or(name, |rest| rest.trim_start_matches('_'))
}

/// The baked maps that functions read. None if a kit cannot give them: one needs more than a texture of
/// one layer, or no height map at all.
fn maps_of(manifest: &FunctionsManifest) -> Option<Vec<Baked>> {
    let mut maps = Vec::new();
    for bound in &manifest.bindings {
        let name = own_name(manifest, &bound.name);
        if name == HEIGHTS {
            continue;
        }
        let need = bound.texture.as_ref().filter(|need| need.dimension == "2d" && need.layers == "1")?;
        let bake = need.bake.as_ref().filter(|bake| bake.side.is_none())?;
        let kind = kind(bake.kind).ok().filter(|kind| !kind.of_volume)?;
        let mut settings = kind.defaults();
        for (name, value) in &bake.settings {
            settings.set(name, f64::from(*value)).ok()?;
        }
        if kind.params.iter().any(|param| param.name == MIPS) {
            settings.set(MIPS, 0.0).ok()?;
        }
        let is_of_surface = bake.metric != "texture";
        maps.push(Baked { name: name.to_owned(), kind, settings, texture: bake.texture, is_of_surface });
    }
    Some(maps)
}

/// The failure of a method whose maps a kit cannot give, with those that go.
fn of_maps(kit: &EngineKit, options: &FunctionOptions) -> Failure {
    let goes = |name: &str| -> Option<()> {
        let mut selection = Selection::method(name).ok()?;
        selection.choose("surface", "plane").ok()?;
        selection.choose("shadow", "none").ok()?;
        maps_of(&functions(&selection, options).ok()?.manifest).map(drop)
    };
    let names = METHODS.iter().map(|method| method.name).filter(|name| goes(name).is_some());
    Failure::Usage(format!(
        "--method: it reads maps of more than one layer, or a volume, which the kit for {} does not write: \
         choose {}, or write the functions alone with `relief shader --entry functions`",
        kit.title,
        names.collect::<Vec<_>>().join(", ")
    ))
}

/// A baked texture.
struct BakedTexture {
    size: [u32; 2],
    planes: Vec<Vec<f32>>,
}

fn bake(map: &Baked, heights: &HeightMap, metric: Metric, watch: &Watch) -> Result<BakedTexture, Failure> {
    let metric = if map.is_of_surface { metric } else { Metric::UNIT };
    let heights =
        heights.clone().with_displacement(metric.scale_m, -metric.scale_m).map_err(Failure::work)?;
    let mut baked = Collected::default();
    let done = relief_bake::bake(map.kind, &heights, metric, &map.settings, watch, &mut baked);
    done.map_err(|error| match error {
        BakeError::Cancelled(_) => cancelled(),
        other => Failure::work(other),
    })?;
    let found = baked.textures.into_iter().find(|texture| texture.texture.name == map.texture);
    let found = found.and_then(|texture| {
        let [width, height, _] = texture.texture.size;
        let planes = texture.levels.into_iter().next()?;
        Some(BakedTexture { size: [width, height], planes })
    });
    found.ok_or_else(|| Failure::Work(format!("{}: the bake has no such texture", map.kind.name)))
}
