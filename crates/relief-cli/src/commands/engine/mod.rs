//! `relief engine`: all that an engine needs to show a relief. To the textures of `relief bake --for` it adds
//! functions, the maps that they read, a mesh, and a page, a scene or a program.

mod bevy;
mod godot;
mod kit;
mod three;
mod unreal;
mod viewed;

use std::path::PathBuf;

use clap::Args;
use relief_core::ByteSize;
use relief_core::mesh::{Builtin, Mesh, UvProjection, rectangle};
use relief_core::registry::UnknownName;
use relief_io::{ENGINES, MeshFile, MeshOptions, Up, read_mesh};
use relief_scene::MeshChoice;
use relief_shaders::{SHADOW, SURFACE, Selection};

use self::kit::{EngineKit, KitJob};
use super::bake::MaterialJob;
use super::bake::for_engine::{self, FolderArguments, Kit, ReadMaterial};
use super::maps::{By, HeightArguments};
use super::shader::choose;
use crate::failure::Failure;
use crate::streams::Files;
use crate::{say, units, values};

/// All kits.
const KITS: [&EngineKit; 4] = [&three::KIT, &godot::KIT, &bevy::KIT, &unreal::KIT];

const EXAMPLES: &str = "Examples:\n  relief engine three bricks.png -o page          # a page to open\n  \
    relief engine godot Bricks090 --mesh sphere --tile 4,2 -o project/bricks\n  \
    relief engine three rock.png --mesh lamp.glb --method cone --scale 2cm -o lamp\n  \
    relief engine bevy bricks.png --mesh torus --tile 6,2 -o program\n  \
    relief engine unreal bricks.png --mesh sphere --tile 4,2 -o bricks\n\n\
    `relief bake --for ENGINE` writes the textures alone. `relief shader --entry \
    functions` writes the functions alone, for other engines and for shaders of your own. Give each relief a \
    folder of its own.";

/// Arguments of `relief engine`.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// Engine: three (three.js, a page), godot (Godot 4, a scene), bevy (a program) or unreal (Unreal Engine
    /// 5, includes and a node for a material)
    #[arg(value_name = "ENGINE")]
    engine: String,
    /// Height map, or a folder of textures
    #[arg(value_name = "HEIGHT|FOLDER")]
    height: PathBuf,
    /// Folder for the files, created if missing
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// Mesh: plane (one tile), square, cube, cylinder, sphere or torus; or a file: glTF, GLB, OBJ, PLY
    /// or STL [default: plane]
    #[arg(long, value_name = "NAME|FILE")]
    mesh: Option<MeshChoice>,
    /// Number of tiles along u and v [default: 1,1]
    #[arg(long, value_name = "U,V", value_parser = values::pair, allow_hyphen_values = true)]
    tile: Option<[f64; 2]>,
    /// Replace a mesh file's texture coordinates by a projection: box, cylinder or sphere
    #[arg(long, value_name = "box|cylinder|sphere")]
    project: Option<UvProjection>,
    /// Up axis in the mesh's file: y or z [default: z in STL, y in others]
    #[arg(long, value_name = "y|z")]
    mesh_up: Option<Up>,
    /// Method, as in `relief methods`
    #[arg(long, value_name = "NAME", default_value = "relief")]
    method: String,
    /// Surface [default: plane on a flat mesh, else quadric-vertical, with silhouettes]
    #[arg(long, value_name = "NAME")]
    surface: Option<String>,
    /// The relief's shadow on itself: ray, soft, horizon and others, or none
    #[arg(long, value_name = "NAME", default_value = "ray")]
    shadow: String,
    /// Displacement in metres between heights 0 and 1, or with a unit, as in 5cm [default: the range of a
    /// georeferenced elevation model, else 0.05]
    #[arg(long, value_name = "M", value_parser = units::length)]
    scale: Option<f64>,
    /// Tile size along u and v in metres, or with units, as in 30cm,20cm: the size of a plane [default: a
    /// georeferenced file's, else square texels and 1 m for the longer side]
    #[arg(long, value_name = "U,V", value_parser = units::two_lengths)]
    tile_size: Option<[f64; 2]>,
    /// Write again even if the files are up to date, and replace files of other programs or that you changed
    #[arg(long)]
    force: bool,
    /// Print the result as one JSON object
    #[arg(long)]
    pub json: bool,
    /// Memory limit, as in 512MiB; work that needs more is refused [default: 4GiB to read the map]
    #[arg(long, value_name = "SIZE", hide_short_help = true)]
    max_memory: Option<ByteSize>,
    #[command(flatten)]
    folder: FolderArguments,
    #[command(flatten)]
    reading: HeightArguments,
}

/// Reads, bakes and writes.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let kit = kit_of(&arguments.engine)?;
    let selection = arguments.selection()?;
    let job = MaterialJob {
        height: arguments.height.clone(),
        folder: arguments.folder.clone(),
        output: arguments.output.clone(),
        scale: arguments.scale,
        tile_size: arguments.tile_size,
        force: arguments.force,
        json: arguments.json,
        max_memory: arguments.max_memory,
        reading: arguments.reading.clone(),
    };
    for_engine::run_with(&job.into(), kit.engine, |material| {
        let mesh = arguments.mesh(material)?;
        let job = KitJob::new(kit, material, mesh, &selection, arguments.max_memory, &arguments.output)?;
        Ok(Some(Box::new(job) as Box<dyn Kit>))
    })
}

/// The kit of an engine.
fn kit_of(name: &str) -> Result<&'static EngineKit, Failure> {
    if let Some(kit) = KITS.into_iter().find(|kit| kit.engine == name) {
        return Ok(kit);
    }
    let known = KITS.map(|kit| kit.engine);
    if ENGINES.iter().any(|engine| engine.name == name) {
        return Err(Failure::Usage(format!(
            "{name}: there is no kit for it, only for {}: `relief bake --for {name}` writes its textures, \
             and `relief shader --entry functions` a method for its shaders",
            known.join(", ")
        )));
    }
    Err(Failure::usage(UnknownName::new("engine with a kit", name, known)))
}

impl Arguments {
    /// Returns the file that may be standard input.
    pub fn files(&mut self) -> Files<'_> {
        Files { read: vec![&mut self.height], ..Files::default() }
    }

    fn is_flat(&self) -> bool {
        matches!(
            self.mesh,
            None | Some(MeshChoice::Builtin(Builtin::Plane | Builtin::Square | Builtin::Cube))
        )
    }

    fn selection(&self) -> Result<Selection, Failure> {
        let mut selection =
            Selection::method(&self.method).map_err(|error| Failure::Usage(format!("--method: {error}")))?;
        let usual = if self.is_flat() { "plane" } else { "quadric-vertical" };
        choose(&mut selection, SURFACE, self.surface.as_deref().unwrap_or(usual))?;
        choose(&mut selection, SHADOW, &self.shadow)?;
        match selection.check() {
            // The surface came with the mesh.
            Err(error) if self.surface.is_none() && !self.is_flat() => Err(Failure::Usage(format!(
                "--method {}: {error}: add --surface plane, which has no silhouettes",
                self.method
            ))),
            _ => Ok(selection),
        }
    }

    /// The mesh, with its tiles.
    fn mesh(&self, material: &ReadMaterial) -> Result<Mesh, Failure> {
        let is_file = matches!(self.mesh, Some(MeshChoice::File(_)));
        if !is_file && (self.project.is_some() || self.mesh_up.is_some()) {
            let what =
                "--project and --mesh-up are for meshes from files: give one with --mesh, or leave them out";
            return Err(Failure::usage(what));
        }
        let mesh = match self.mesh.clone().unwrap_or_default() {
            MeshChoice::Builtin(Builtin::Plane) => rectangle(material.metric.tile_m, 1),
            MeshChoice::Builtin(builtin) => builtin.build([1.0, 1.0]),
            MeshChoice::File(path) => {
                let mut options =
                    MeshOptions { projection: self.project, up: self.mesh_up, ..MeshOptions::default() };
                if let Some(max) = self.max_memory {
                    options.max_bytes = max.0;
                }
                let MeshFile { mesh, notes, .. } = read_mesh(&path, &options).map_err(Failure::of_mesh)?;
                if !self.json {
                    notes.into_iter().for_each(|remark| say::note(By::Flags.note(&remark.of(&path))));
                }
                Ok(mesh)
            }
        };
        let tiles = self.tile.unwrap_or([1.0, 1.0]).map(|count| count as f32);
        mesh.and_then(|mesh| mesh.tiled(tiles.into())).map_err(Failure::usage)
    }
}
