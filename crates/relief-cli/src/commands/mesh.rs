//! `relief mesh`: displaces a mesh by a height map and writes the triangles to a file.

mod accuracy;
mod arguments;
mod baked_maps;
mod ground;
mod help;
mod level_filter;
mod motif;
mod parts;
mod refused;
mod report;
mod settings;
mod spec;
mod texture_set;
mod write;

pub use self::arguments::Arguments;

use std::path::Path;
use std::time::Instant;

use relief_core::ByteSize;
use relief_io::omissions::{self, OTHER_PICTURES, UNDECLARED_NODATA, UNSHOWN_MATERIAL};
use relief_io::{GlbMaterials, MeshFormat, MeshMaterial, Remark, material_name};
use relief_mesh::Mesher;
use relief_scene::{MeshChoice, Surface};
use relief_shaders::field::Solids;

use self::accuracy::Tolerance;
use self::arguments::FORMATS;
use self::ground::Metres;
use self::refused::COARSER;
use self::write::Source;
use super::lengths;
use super::maps::{self, By};
use super::scene_arguments::of_scene;
use super::staged::{Staged, format_of};
use crate::failure::Failure;
use crate::file_kind::is_volume;
use crate::progress::Progress;
use crate::streams::tell_written;
use crate::units::Length;
use crate::{interrupt, say, units, values};

/// Memory for blocks between making and writing them.
const BYTES_TO_WRITE: u64 = 32 << 20;

/// Materials, and the index of each base triangle's; no indices if all have the first.
type Materials = (Vec<MeshMaterial>, Vec<u32>);

/// Reads the map and the mesh, displaces and writes.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    if let Some(motif) = &arguments.motif {
        return motif::run(arguments, motif);
    }
    if arguments.axes.is_some() {
        return Err(Failure::Usage(
            "--axes: it is for vector displacement maps: give one with --motif, or leave it out".to_owned(),
        ));
    }
    arguments.refuse_what_has_no_heights()?;
    let started = Instant::now();
    let (_, format) = format_of("--output", &arguments.output, &FORMATS, &arguments.inputs())?;
    arguments.check(format)?;
    let metres = Metres::of(arguments);
    let spec = arguments.spec(&metres)?;
    let scene = {
        let _reading = Progress::spinner("reading", arguments.json);
        spec.load().map_err(of_scene)?
    };
    let surface = scene.surfaces()[0].clone();
    let mut notes = maps::of_reading(&spec, &scene, By::Flags);
    // Materials are written as they are, whether shown or not.
    notes.retain(|note| !note.is_about(&UNSHOWN_MATERIAL) && !note.is_about(&OTHER_PICTURES));
    let materials = match arguments.materials(&surface, format) {
        Ok(materials) => materials,
        Err(why) => {
            let what = format!("the colours, masks and pictures of its materials are not written: {why}");
            let file = match (arguments.textures(), &arguments.placement.mesh) {
                (Some(folder), _) => folder,
                (None, Some(MeshChoice::File(file))) => file.as_path(),
                _ => Path::new("mesh"),
            };
            notes.insert(By::Flags.note(&Remark::new(&omissions::UNWRITTEN_MATERIALS, what).of(file)));
            None
        }
    };
    if let Some(ground) = spec.each_surface().first().and_then(maps::ground_of)
        && let Some(doubt) = lengths::doubt_of(&ground, surface.height_map())
    {
        // An undeclared value of holes among the heights is to be named, not their unit.
        let no_value = notes.iter().find(|note| note.is_about(&UNDECLARED_NODATA));
        return Err(Failure::Work(match no_value {
            Some(note) => note.to_string(),
            None => format!("{}: {doubt}", arguments.height.display()),
        }));
    }
    if !arguments.json {
        notes.iter().for_each(say::note);
    }
    let view = arguments.view_of(&spec, &scene);
    if surface.object().is_some() {
        return Err(Failure::usage(
            "the surface is a depth object, which has no height map on a mesh: give a height map",
        ));
    }
    if surface.solids() != Solids::Heights {
        let shown = surface.solids().in_words();
        return Err(Failure::Usage(format!(
            "the surface is {shown}, which is no height map: give a height map"
        )));
    }
    drop(scene);
    let surface = metres.applied(arguments, surface)?;
    if !arguments.json {
        arguments.notes(&metres, &surface).into_iter().for_each(say::note);
    }
    let cancel = interrupt::catch()?;
    let materials = baked_maps::baked(arguments, &surface, materials, cancel)?;
    let of_glb = |(materials, of_base)| GlbMaterials::new(materials, of_base).map_err(Failure::work);
    let materials = materials.map(of_glb).transpose()?;
    let files = parts::files(&arguments.output, arguments.tiles)?;
    let paths: Vec<&Path> = files.iter().map(|file| file.path.as_path()).collect();
    let mut staged = Staged::open(&paths, arguments.json, cancel)?;
    let coarser = match view {
        Some(_) => {
            let memory = [bytes_of(&surface), arguments.limit()];
            let filter = arguments.level_filter.unwrap_or_default();
            filter.levels(surface.height_map(), memory, arguments.json, cancel)?
        }
        None => Vec::new(),
    };
    let source = Source { surface: &surface, view, coarser, metres: &metres, materials };
    let written = write::write(arguments, &source, format, &files, &mut staged, cancel)?;
    staged.finish()?;
    let seconds = started.elapsed().as_secs_f64();
    let about = report::MeshReport {
        format,
        written: &written,
        seconds,
        surface: &surface,
        metres: &metres,
        notes: &notes,
    };
    tell_written(arguments.json, |out| about.tell(arguments, out))
}

impl Arguments {
    /// Refuses a mesh or a volume in place of the height map.
    fn refuse_what_has_no_heights(&self) -> Result<(), Failure> {
        let file = self.height.display();
        if MeshFormat::by_name(&self.height).is_some() {
            return Err(Failure::Usage(format!(
                "{file}: is a mesh, and a height map is asked for here: to repeat it over another mesh give \
                 it with --motif"
            )));
        }
        if is_volume(&self.height) {
            return Err(Failure::Usage(format!(
                "{file}: is a volume, which only `relief render` shows: give a height map, or with --motif \
                 the mesh that it was made from"
            )));
        }
        Ok(())
    }

    /// Returns the materials of the base that are written.
    ///
    /// # Errors
    ///
    /// With the reason if they cannot be written.
    fn materials(&self, surface: &Surface, format: MeshFormat) -> Result<Option<Materials>, String> {
        if let Some(folder) = self.textures() {
            let folder = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
            return texture_set::material(surface, &material_name(&folder), format).map(Some);
        }
        if surface.file_colors().is_none_or(|colors| colors.colored() == 0) {
            return Ok(None);
        }
        if format != MeshFormat::Gltf {
            return Err(format!("{format} cannot hold them, a .glb can"));
        }
        let (materials, of_base) = surface
            .file_materials()
            .ok_or("there are too many to draw, or they lie on few triangles each")?;
        if self.strips && !of_base.is_empty() {
            return Err("--strips allow one material".to_owned());
        }
        if Mesher::is_plane(surface.mesh()) && !of_base.is_empty() {
            return Err("the base is a plane, which has one material".to_owned());
        }
        // A problem with a picture is known before the work.
        GlbMaterials::new(materials.clone(), of_base.clone()).map_err(|problem| problem.to_string())?;
        Ok(Some((materials, of_base)))
    }

    /// Returns notes on lengths that may be meant otherwise.
    fn notes(&self, metres: &Metres, surface: &Surface) -> Vec<String> {
        let map = surface.height_map();
        let [low, high] = map.extremes();
        let relief_m = f64::from(high - low) * map.scale_m() * metres.factor;
        let mut notes = Vec::new();
        if let Some(Tolerance::Metres(error_m)) = self.error
            && self.print_size.is_none()
            && error_m > relief_m
        {
            notes.push(format!(
                "--error {}: the whole relief is {} high, so it may be flattened",
                units::in_words(error_m),
                units::in_words(relief_m)
            ));
        }
        if let Some(Length { metres: scale_m, has_unit: false }) = self.placement.scale
            && metres.is_known()
        {
            let plane = units::in_words(metres.factor);
            notes.push(format!(
                "--scale {scale_m}: read as {scale_m} m of the mesh, which is {plane} long. To multiply \
                 heights, give --exaggerate N. `relief render` shows the same with --scale {}, as its plane \
                 is 1 m long. A unit, as in --scale {scale_m}m, silences this note",
                values::six_digits(scale_m / metres.factor)
            ));
        }
        notes
    }

    /// Checks that the mesh can be made within the memory limit.
    fn check_memory(&self, surface: &Surface, levels: &[Mesher]) -> Result<(), Failure> {
        let limit = self.limit();
        let needed = bytes_of(surface) + levels.iter().map(Mesher::bytes).sum::<u64>() + BYTES_TO_WRITE;
        if needed <= limit {
            return Ok(());
        }
        let (mib, limit) = (needed.div_ceil(1 << 20), ByteSize(limit));
        Err(Failure::Work(format!(
            "a mesh of {} triangles takes {mib} MiB to make, more than the {limit} allowed: \
             --max-memory raises the limit, {COARSER}",
            levels.iter().map(Mesher::triangles).sum::<u64>()
        )))
    }
}

/// Returns the memory of a surface's height map in bytes.
fn bytes_of(surface: &Surface) -> u64 {
    let map = surface.height_map();
    size_of::<f32>() as u64 * u64::from(map.width()) * u64::from(map.height())
}
