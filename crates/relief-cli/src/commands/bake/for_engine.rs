//! `relief bake --for`: textures of a material, as an engine takes them.

mod given_maps;
mod report;
mod source;

use std::collections::BTreeSet;
use std::io::{self, Write};
use std::path::PathBuf;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use clap::Args;
use relief_bake::{BakeError, Collected, Settings, kind};
use relief_core::{HeightMap, Metric, Watch};
use relief_io::{
    ENGINES, Engine, EngineTexture, GreenSign, HeightNote, Metadata, TextureContent, WriteError,
    write_atomically, write_engine_model,
};
use relief_scene::engine_material::{EngineMaterial, EngineMaterialError, WrittenFacts};

use self::given_maps::GivenMaps;
use self::source::MaterialSource;
use super::Arguments;
use super::identity::KEY;
pub use super::outputs::Outputs;
use crate::commands::maps::Note;
use crate::failure::Failure;
use crate::interrupt::{self, cancelled};
use crate::progress::Progress;
use crate::say;
use crate::streams::tell_written;

/// Share of the progress bar that baking normals takes.
const NORMALS_PART: f32 = 0.3;

/// Share after which textures are written, and a kit is left.
const TEXTURES_PART: f32 = 0.6;

/// Flags for textures of an engine.
#[derive(Args)]
pub struct EngineArguments {
    /// Engine for which all textures of a material are written, in place of kinds: unreal, unity,
    /// godot, three, bevy or gltf
    #[arg(id = "engine", long = "for", value_name = "ENGINE")]
    pub name: Option<String>,
    #[command(flatten)]
    pub folder: FolderArguments,
}

/// Flags for a folder of textures.
#[derive(Args, Clone)]
pub struct FolderArguments {
    /// UDIM tile whose textures are taken from a folder, as in 1001 [default: the only one]
    #[arg(long, value_name = "N", hide_short_help = true)]
    pub udim: Option<u32>,
    /// Direction of green in the folder's normal map: +y (up) or -y (down) [default: as
    /// its name says, else +y]
    #[arg(long, value_name = "SIGN", allow_hyphen_values = true, hide_short_help = true)]
    pub green: Option<GreenSign>,
    #[command(flatten)]
    pub maps: GivenMaps,
}

/// Describes what is written for engines.
pub fn long_help() -> String {
    let names: Vec<String> =
        ENGINES.iter().map(|engine| format!("{} ({})", engine.name, engine.title)).collect();
    format!(
        "--for takes a folder of textures or a height map, and writes base colour, normals, packed \
         occlusion, roughness and metalness, heights and emission with the names, channels, green and bits \
         of an engine: {}. Normals are baked where the folder has none. A text file says where each file and \
         the scale go; for three, bevy and gltf there is a glTF of a plane, too. `relief render DIR` shows \
         the result. `relief engine` writes the same with shaders of a method, a mesh, and a page or scene.",
        names.join(", ")
    )
}

/// What an engine gets beside the textures of a material.
pub trait Kit {
    /// The name in the manifest.
    fn part(&self) -> String;
    /// The names of its files.
    fn names(&self) -> Vec<String>;
    /// Whether it takes that texture of a material.
    fn takes(&self, content: TextureContent) -> bool;
    /// Hash of everything that decides the bytes of its files, beside the material.
    fn key(&self) -> String;
    /// Writes its files to places that get their names later.
    fn write(
        &self,
        input: &KitInput,
        outputs: &mut Outputs,
        watch: &Watch,
    ) -> Result<Vec<(String, PathBuf)>, Failure>;
    /// What the user does next.
    fn next(&self) -> String;
}

/// What a kit is written from, once the textures are.
pub struct KitInput<'a> {
    pub material: &'a EngineMaterial<'a>,
    pub facts: &'a WrittenFacts,
    pub map: &'a HeightMap,
    pub metric: Metric,
}

/// A material whose heights have been read.
pub struct ReadMaterial<'a> {
    /// Name of the material.
    pub name: &'a str,
    pub map: &'a HeightMap,
    pub metric: Metric,
}

/// Reads and writes.
pub fn run(arguments: &Arguments, name: &str) -> Result<(), Failure> {
    run_with(arguments, name, |_| Ok(None))
}

/// Reads and writes, with a kit in place of the plane.
pub fn run_with(
    arguments: &Arguments,
    name: &str,
    kit: impl FnOnce(&ReadMaterial) -> Result<Option<Box<dyn Kit>>, Failure>,
) -> Result<(), Failure> {
    let engine = Engine::named(name).map_err(Failure::usage)?;
    let source = MaterialSource::find(arguments)?;
    let (map, metric, notes) = source.heights(arguments)?;
    let mut material = EngineMaterial::new(engine, &source.name, &map, metric);
    if let Some(max) = arguments.max_memory {
        material = material.with_max_bytes(max.0);
    }
    if let Some(set) = &source.set {
        material = material.with_textures(set, source.green(arguments));
    }
    let kit = kit(&ReadMaterial { name: &source.name, map: &map, metric })?;
    let job = EngineJob::new(arguments, &source, material, &map, metric, notes, kit)?;
    // Until here nothing exists that an interrupted program would leave behind.
    let cancel = interrupt::catch()?;
    tell_written(arguments.json, |out| job.run(cancel, out))
}

/// Material that is written.
struct EngineJob<'a> {
    arguments: &'a Arguments,
    material: EngineMaterial<'a>,
    map: &'a HeightMap,
    metric: Metric,
    /// Name of the material.
    name: &'a str,
    /// Hash of everything that decides the bytes of the files.
    key: String,
    notes: BTreeSet<Note>,
    /// Notes that are not about reading a file.
    said: Vec<String>,
    kit: Option<Box<dyn Kit>>,
}

/// Endings of the plane's files.
const PLANE: [&str; 2] = ["gltf", "bin"];

impl<'a> EngineJob<'a> {
    fn new(
        arguments: &'a Arguments,
        source: &'a MaterialSource,
        material: EngineMaterial<'a>,
        map: &'a HeightMap,
        metric: Metric,
        mut notes: BTreeSet<Note>,
        kit: Option<Box<dyn Kit>>,
    ) -> Result<Self, Failure> {
        let mut said = Vec::new();
        if let Some(set) = &source.set {
            notes.extend(source::notes_on(set, &material, &source.height, &arguments.height));
            notes.extend(source::other_green(arguments, set, map)?);
            let missing = material.missing();
            if !missing.is_empty() {
                said.push(format!("the textures {} have no map of: {}", set.name, missing.join(", ")));
            }
        }
        if source.set.is_some() && material.normal_map().is_none() && kit.is_none() {
            said.push("normals are baked from the heights".to_owned());
        }
        let mut key = source::key(&material, source, arguments, map, metric)?;
        if let Some(kit) = &kit {
            key += &format!(" {}", kit.key());
        }
        Ok(Self { arguments, material, map, metric, name: &source.name, key, notes, said, kit })
    }

    fn part(&self) -> String {
        self.kit.as_ref().map_or_else(|| part_of(self.material.engine()), |kit| kit.part())
    }

    /// The textures that are written.
    fn textures(&self) -> Vec<&'static EngineTexture> {
        let is_taken = |texture: &&EngineTexture| self.takes(texture.content);
        self.material.textures().into_iter().filter(is_taken).collect()
    }

    fn takes(&self, content: TextureContent) -> bool {
        self.kit.as_ref().is_none_or(|kit| kit.takes(content))
    }

    fn text_name(&self) -> String {
        format!("{}.{}.txt", self.name, self.material.engine().name)
    }

    /// Returns the names of all files: textures, the plane's, and the text.
    fn names(&self) -> Vec<String> {
        let textures = self.textures().into_iter().map(|texture| self.material.file_name(texture));
        let has_plane = self.kit.is_none() && self.material.engine().plane_cells.is_some();
        let plane = PLANE.iter().filter(|_| has_plane).map(|ending| format!("{}.{ending}", self.name));
        let of_kit = self.kit.iter().flat_map(|kit| kit.names());
        let text = self.kit.is_none().then(|| self.text_name());
        textures.chain(plane).chain(of_kit).chain(text).collect()
    }

    fn run(&self, cancel: &AtomicBool, out: &mut dyn Write) -> Result<(), Failure> {
        let started = Instant::now();
        let Arguments { output, force, json, .. } = self.arguments;
        if !json {
            self.notes.iter().for_each(say::note);
            self.said.iter().for_each(say::note);
        }
        let mut outputs = Outputs::open(output, self.name, true, *force, *json, cancel)?;
        if !force && let Some(files) = outputs.earlier().whole(&self.part(), &self.key) {
            return self.tell(&files, None, started, out);
        }
        if let Some(other) = ENGINES.iter().find(|other| {
            other.name != self.material.engine().name && outputs.earlier().has_part(&part_of(other))
        }) {
            return Err(Failure::Work(format!(
                "{}: has the textures of '{}' for {}: give each engine a folder of its own",
                output.display(),
                self.name,
                other.name
            )));
        }
        let manifest = outputs.earlier().name().to_owned();
        for name in self.names().iter().chain([&manifest]) {
            outputs.check(name)?;
        }
        for name in self.kit.iter().flat_map(|kit| kit.names()) {
            outputs.check_unchanged(&name)?;
        }
        let bar = Progress::bar(self.material.engine().name, *json);
        let tell = |_: &str, part: f32| bar.show(part);
        let (files, facts) = self.write(&mut outputs, &Watch::new(&tell, cancel))?;
        drop(bar);
        let in_folder =
            |error: io::Error| Failure::Work(format!("{}: cannot write into it: {error}", output.display()));
        outputs.add(&self.part(), &self.key, &files).map_err(in_folder)?;
        let changed = outputs.finish(cancel)?;
        if !json {
            for name in changed {
                let path = output.join(name);
                say::note(format_args!(
                    "{} stays: an earlier bake wrote it, this one does not, and it has been changed since",
                    path.display()
                ));
            }
        }
        let names: Vec<String> = files.into_iter().map(|(name, _)| name).collect();
        self.tell(&names, Some(&facts), started, out)
    }

    /// Writes all files, which take their names later.
    fn write(
        &self,
        outputs: &mut Outputs,
        watch: &Watch,
    ) -> Result<(Vec<(String, PathBuf)>, WrittenFacts), Failure> {
        let mut facts = WrittenFacts::default();
        let mut files = Vec::new();
        let baked = match self.material.normal_map() {
            Some(_) => None,
            None if !self.takes(TextureContent::Normal) => None,
            None => Some(self.baked_normals(&watch.piece(0.0, NORMALS_PART))?),
        };
        let start = if baked.is_some() { NORMALS_PART } else { 0.0 };
        let normals = baked.as_ref().and_then(planes);
        let textures = self.textures();
        let end = if self.kit.is_some() { TEXTURES_PART } else { 1.0 };
        let part = |done: usize| start + (end - start) * done as f32 / textures.len() as f32;
        for (number, texture) in textures.iter().enumerate() {
            let name = self.material.file_name(texture);
            let place = outputs.place(&name)?;
            let metadata = self.metadata(texture)?;
            let watch = watch.piece(part(number), part(number + 1));
            let written = self.material.write(texture, normals, &place, &metadata, &mut facts, &watch);
            written.map_err(|error| self.of_material(error, &name))?;
            files.push((name, place));
        }
        if let Some(kit) = &self.kit {
            let Self { material, map, metric, .. } = self;
            let input = KitInput { material, facts: &facts, map, metric: *metric };
            files.extend(kit.write(&input, outputs, &watch.piece(end, 1.0))?);
        } else if let Some(plane) = self.material.plane(&facts) {
            let names = PLANE.map(|ending| format!("{}.{ending}", self.name));
            let places = [outputs.place(&names[0])?, outputs.place(&names[1])?];
            let written = write_engine_model(&plane, &places[0], &places[1], &names[1]);
            written.map_err(|error| self.of_write(&error, &names[0]))?;
            files.extend(names.into_iter().zip(places));
        }
        // What a kit writes says itself where things go.
        if self.kit.is_none() {
            let (name, text) = (self.text_name(), self.material.note(&facts));
            let place = outputs.place(&name)?;
            let written = write_atomically(&place, |out| out.write_all(text.as_bytes()));
            written.map_err(|error| self.of_write(&error, &name))?;
            files.push((name, place));
        }
        Ok((files, facts))
    }

    fn baked_normals(&self, watch: &Watch) -> Result<Collected, Failure> {
        let kind = kind("normal").map_err(Failure::work)?;
        let mut settings: Settings = kind.defaults();
        settings.set(super::MIPS, 0.0).map_err(Failure::work)?;
        let mut baked = Collected::default();
        let done = relief_bake::bake(kind, self.map, self.metric, &settings, watch, &mut baked);
        done.map_err(|error| match error {
            BakeError::Cancelled(_) => cancelled(),
            other => Failure::work(other),
        })?;
        Ok(baked)
    }

    /// Returns the metadata of a texture's file. A height map says how deep it is.
    fn metadata(&self, texture: &EngineTexture) -> Result<Metadata, Failure> {
        let engine = self.material.engine().name.to_owned();
        let own = KEY.strip_prefix("relief.").unwrap_or(KEY);
        let more = vec![(own, self.key.clone()), ("engine", engine), ("holds", texture.content.name())];
        let metadata = match texture.content {
            TextureContent::Height(_) => {
                let note = HeightNote {
                    tile_m: self.metric.tile_m,
                    scale_m: self.map.scale_m(),
                    bias_m: self.map.bias_m(),
                    of_mesh: self.map.stated_displacement_m().is_some(),
                };
                note.metadata(more)
            }
            _ => {
                let entries = more.into_iter().map(|(name, value)| (format!("relief.{name}"), value));
                Metadata::new(entries.collect())
            }
        };
        metadata.map_err(Failure::work)
    }

    fn of_material(&self, error: EngineMaterialError, name: &str) -> Failure {
        match error {
            EngineMaterialError::Cancelled(_) => cancelled(),
            EngineMaterialError::Picture(error) => Failure::of_picture(error),
            EngineMaterialError::Write(error) => self.of_write(&error, name),
            other @ EngineMaterialError::Map { .. } => Failure::work(other),
        }
    }

    /// Returns the failure of a file, whose error names the place where it was prepared.
    fn of_write(&self, error: &WriteError, name: &str) -> Failure {
        Failure::Work(format!("{}: {}", self.arguments.output.join(name).display(), error.problem))
    }
}

/// Returns the name of an engine's files in the manifest.
fn part_of(engine: &Engine) -> String {
    format!("for.{}", engine.name)
}

/// Returns the planes of baked normals.
fn planes(baked: &Collected) -> Option<[&[f32]; 3]> {
    let [x, y, z, ..] = baked.textures.first()?.levels.first()?.as_slice() else { return None };
    Some([x, y, z])
}
