//! `relief mesh --motif`: a closed mesh in the space of a tile, repeated in the shells of another mesh.

use std::io::Write;
use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use glam::Vec2;
use relief_core::Watch;
use relief_core::mesh::{Mesh, MeshBlock, RawCorner, RawMesh};
use relief_io::{MeshCounts, MeshFormat, MeshSink, read_raw_mesh, write_mesh};
use relief_mesh::shell_map::{BYTES_PER_TRIANGLE, ShellMap, ShellMapError, ShellMapSettings, map_shells};
use relief_scene::motif::{MotifFile, MotifFileError, MotifOptions, MotifProblem, VectorAxes, read_motif};
use relief_scene::{MeshChoice, NO_MAP, SceneSpec, SurfaceSpec};
use serde_json::json;

use super::{Arguments, FORMATS};
use crate::commands::motif::missing_motif;
use crate::commands::scene_arguments::of_scene;
use crate::commands::staged::{Staged, format_of};
use crate::failure::Failure;
use crate::file_kind::is_volume;
use crate::interrupt::{self, cancelled};
use crate::progress::Progress;
use crate::streams::tell_written;
use crate::{advice, say, units, values};

/// Depth of a motif over the length of its tile beyond which a unit was probably mistaken.
const DEEP: f64 = 10.0;

/// Most numbers of triangles that a note lists.
const MOST_NUMBERS: usize = 5;

/// Reads the motif and the mesh, and writes the motif on all of the mesh.
pub fn run(arguments: &Arguments, motif: &Path) -> Result<(), Failure> {
    let started = Instant::now();
    let inputs: Vec<&Path> = [motif].into_iter().chain(arguments.inputs()).collect();
    let (_, format) = format_of("--output", &arguments.output, &FORMATS, &inputs)?;
    arguments.refuse_with_motif()?;
    if let Some(missing) = missing_motif(motif) {
        return Err(missing);
    }
    if motif.is_dir() {
        let folder = motif.display();
        return Err(Failure::Usage(format!("--motif: {folder} is a folder: give a mesh or a map in it")));
    }
    if is_volume(motif) {
        let file = motif.display();
        return Err(Failure::Usage(format!(
            "--motif: {file} is a volume: give the mesh that it was made from"
        )));
    }
    let bias_m = arguments.placement.bias.unwrap_or(0.0);
    let (base, given) = {
        let _reading = Progress::spinner("reading", arguments.json);
        let base = arguments.base()?;
        let given = arguments.given(motif, base.tile_m())?;
        (base, given)
    };
    let settings = ShellMapSettings {
        scale_m: given.scale_m,
        bias_m: bias_m + given.low_m,
        triangles: arguments.limit() / BYTES_PER_TRIANGLE,
    };
    let cancel = interrupt::catch()?;
    let mut staged = Staged::open(&[&arguments.output], arguments.json, cancel)?;
    let map = made(&base, &given.mesh, &settings, arguments.json, cancel)?;
    let mut notes = notes_on(motif, &map);
    if given.is_coarse {
        let name = motif.display();
        notes.push(format!(
            "{name} has 8 bits a channel, whose steps show as terraces: export floats or 16 bits"
        ));
    }
    let longest_m = base.tile_m().into_iter().fold(0.0, f64::max);
    if settings.scale_m > DEEP * longest_m {
        let [deep, long] = [settings.scale_m, longest_m].map(units::in_words);
        notes.push(format!("the motif is {deep} deep, but its tile only {long} long: check --scale"));
    }
    if !arguments.json {
        notes.iter().for_each(say::note);
    }
    let counts = MeshCounts {
        vertices: map.mesh.vertices().len() as u64,
        triangles: map.mesh.triangles().len() as u64,
    };
    format.check(counts).map_err(Failure::work)?;
    let aside = staged.aside(&arguments.output)?;
    let bytes = written(&aside, format, counts, &map.mesh)
        .map_err(|error| Failure::Work(format!("{}: {error}", arguments.output.display())))?;
    staged.finish()?;
    let seconds = started.elapsed().as_secs_f64();
    tell_written(arguments.json, |out| {
        let output = arguments.output.display().to_string();
        let MeshCounts { vertices, triangles } = counts;
        if arguments.json {
            let about = json!({
                "output": output, "motif": motif, "triangles": triangles, "vertices": vertices,
                "scale_m": given.unit_m, "bias_m": bias_m, "axes": given.axes.map(VectorAxes::name),
                "open_edges": map.open_edges, "folded": map.folded,
                "without_area": map.without_area, "beyond": map.beyond, "bytes": bytes, "notes": notes,
                "seconds": seconds,
            });
            return Ok(writeln!(out, "{about:#}")?);
        }
        writeln!(
            out,
            "{output}: {triangles} triangles, {vertices} vertices, {bytes} bytes, in {seconds:.2} s"
        )?;
        let unit =
            if given.axes.is_some() { "for a vector of length 1" } else { "between the heights 0 and 1" };
        writeln!(out, "  scale       {} m {unit}", values::six_digits(given.unit_m))?;
        if let Some(axes) = given.axes {
            writeln!(out, "  axes        {}: R, G and B are {}", axes.name(), axes.in_words())?;
        }
        writeln!(out, "  open edges  {}", map.open_edges)?;
        Ok(())
    })
}

fn made(
    base: &Mesh,
    motif: &RawMesh,
    settings: &ShellMapSettings,
    is_quiet: bool,
    cancel: &AtomicBool,
) -> Result<ShellMap, Failure> {
    let bar = Progress::bar("cutting", is_quiet);
    let tell = |_: &str, part: f32| bar.show(part);
    map_shells(base, motif, settings, &Watch::new(&tell, cancel)).map_err(|error| match error {
        ShellMapError::Cancelled(_) => cancelled(),
        ShellMapError::Lengths { .. } => Failure::Usage(format!("--scale: {error}")),
        ShellMapError::FarMotif(_) => Failure::Work(format!("--motif: {error}")),
        ShellMapError::TooWide { .. } => Failure::Work(format!("--tile: {error}")),
        ShellMapError::TooLarge { expected, most } => Failure::Work(format!(
            "the mesh would have about {expected} triangles, more than {most}: give fewer tiles with --tile, \
             a motif of fewer triangles or a map of fewer texels, or more memory with --max-memory"
        )),
        error => Failure::work(error),
    })
}

fn written(path: &Path, format: MeshFormat, counts: MeshCounts, mesh: &Mesh) -> std::io::Result<u64> {
    let block = MeshBlock {
        vertices: mesh.vertices().to_vec(),
        triangles: mesh.triangles().to_vec(),
        points: mesh.vertices().iter().map(|vertex| vertex.position).collect(),
        corners: mesh.triangles().to_vec(),
        owners: Vec::new(),
    };
    write_mesh(path, format, counts, |sink: &mut MeshSink| sink(&block))
        .map_err(|error| std::io::Error::other(error.problem.to_string()))?;
    Ok(std::fs::metadata(path)?.len())
}

/// Refuses a mesh with triangles that have no texture coordinates, which tiles follow.
fn require_coordinates(file: &Path, limit: u64) -> Result<(), Failure> {
    let mesh = read_raw_mesh(file, limit).map_err(Failure::of_mesh)?;
    let has_none = |corners: &&[RawCorner; 3]| corners.iter().any(|corner| corner.uv == RawCorner::NONE);
    match mesh.triangles.iter().filter(has_none).count() {
        0 => Ok(()),
        missing => Err(Failure::Work(format!(
            "{}: {missing} of {} triangles have no texture coordinates, which the tiles of the motif follow: \
             give --project box, cylinder or sphere",
            file.display(),
            mesh.triangles.len()
        ))),
    }
}

/// What a user should know of the result.
fn notes_on(motif: &Path, map: &ShellMap) -> Vec<String> {
    let name = motif.display();
    let mut notes = Vec::new();
    if map.beyond > 0.0 {
        notes.push(format!(
            "{name}: {} % of its vertices lie below height 0 or above height 1, where it is cut off",
            values::six_digits((1000.0 * map.beyond).round() / 10.0)
        ));
    }
    if !map.folded.is_empty() {
        let numbers: Vec<String> = map.folded.iter().take(MOST_NUMBERS).map(u32::to_string).collect();
        let more = if map.folded.len() > MOST_NUMBERS { ", ..." } else { "" };
        notes.push(format!(
            "the shells of {} triangles of the mesh fold, as they are deeper than its curvature allows \
             ({}{more}): give more tiles with --tile, a smaller --scale, or another --bias",
            map.folded.len(),
            numbers.join(", ")
        ));
    }
    if map.without_area > 0 {
        notes.push(format!(
            "{} triangles of the mesh have no area in texture coordinates, and carry nothing: --project \
             makes coordinates",
            map.without_area
        ));
    }
    if map.open_edges > 0 {
        notes.push(format!(
            "the result has {} open edges: where motif, mesh or texture coordinates have a border, or where \
             it is cut off; a closed motif leaves none on a closed mesh with whole numbers of tiles whose \
             texture coordinates join at their seams",
            map.open_edges
        ));
    }
    notes
}

impl Arguments {
    /// Reads the motif, for tiles of that size in metres.
    fn given(&self, motif: &Path, tile_m: [f64; 2]) -> Result<MotifFile, Failure> {
        let scale_m = self.placement.scale.map(|scale| scale.metres);
        // As everywhere in the command, though the library can grow a motif inward.
        if let Some(scale_m) = scale_m.filter(|scale_m| *scale_m <= 0.0) {
            return Err(Failure::Usage(format!("--scale: {scale_m} cannot be used: it must be above 0")));
        }
        let options = MotifOptions { axes: self.axes, tile_m, scale_m, max_bytes: self.limit() };
        read_motif(motif, &options).map_err(|error| match &error {
            MotifFileError::Invalid { problem: MotifProblem::AxesOfMesh, .. } => {
                Failure::Usage(format!("--axes: {error}: leave it out"))
            }
            error => Failure::Work(advice::with_flag(error, advice::of_motif(error))),
        })
    }

    /// Refuses flags that are about height maps.
    fn refuse_with_motif(&self) -> Result<(), Failure> {
        let placement = &self.placement;
        let given = [
            ("a height map", self.height != Path::new(NO_MAP)),
            ("--exaggerate", placement.exaggerate.is_some()),
            ("--tile-size", placement.tile_size.is_some()),
            ("--wrap", self.reading.wrap.is_some()),
            (self.reading.flag_of_heights().unwrap_or_default(), self.reading.flag_of_heights().is_some()),
        ];
        match given.into_iter().find(|(_, given)| *given) {
            Some((what, _)) => Err(Failure::Usage(format!(
                "--motif: {what} is of no use here, as the motif has the relief: leave it out"
            ))),
            None => Ok(()),
        }
    }

    /// Returns the mesh that the motif is put on, with its tiles.
    fn base(&self) -> Result<Mesh, Failure> {
        let placement = &self.placement;
        let tile = placement.tile.unwrap_or([1.0; 2]).map(|count| count as f32);
        let builtin = match &placement.mesh {
            Some(MeshChoice::File(_)) => None,
            Some(MeshChoice::Builtin(builtin)) => Some(*builtin),
            None => Some(relief_core::mesh::Builtin::Plane),
        };
        if let Some(builtin) = builtin {
            let of_files = [
                ("--project", placement.project.is_some()),
                ("--mesh-up", placement.mesh_up.is_some()),
                ("--mesh-scale", placement.mesh_scale.is_some()),
            ];
            if let Some((flag, _)) = of_files.into_iter().find(|(_, given)| *given) {
                return Err(Failure::Usage(format!("{flag} is for files of meshes: leave it out")));
            }
            let base = builtin.build([1.0, 1.0]).and_then(|mesh| mesh.tiled(Vec2::from_array(tile)));
            return base.map_err(|error| Failure::Usage(format!("--tile: {error}")));
        }
        if let (Some(MeshChoice::File(file)), None) = (&placement.mesh, placement.project) {
            require_coordinates(file, self.limit())?;
        }
        // The scale of the motif is no scale of the mesh.
        let surface = SurfaceSpec { scale: None, bias: None, ..placement.surface(&self.reading) };
        let spec = SceneSpec {
            size: Some([1, 1].into()),
            samples: Some(1),
            max_memory: self.max_memory,
            ..SceneSpec::of_surface(surface)
        };
        Ok(spec.load().map_err(of_scene)?.surfaces()[0].mesh().as_ref().clone())
    }
}
