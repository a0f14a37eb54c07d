//! `relief mesh`: a height map and a mesh to displaced triangles in a file.

mod made;
mod report;

use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::{Args, ValueEnum};
use relief_core::ByteSize;
use relief_core::registry::UnknownName;
use relief_io::{DEFAULT_MAX_BYTES, MeshCounts, MeshFormat};
use relief_mesh::{
    BaseSurface, Directions, EDGE_RULES, EdgeRule, INTERIORS, Interior, MeshSettings, Mesher, MesherError,
    Seams, Shading,
};
use relief_render::scene::{MeshChoice, SceneSpec, Surface, SurfaceSpec};

use super::maps::{self, HeightArguments};
use super::placed::PlacedArguments;
use super::scene_arguments::of_scene;
use super::staged::{Staged, format_of};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::streams::{Files, Written, answer};
use crate::{interrupt, say, units};

/// Memory for what is held of blocks between making and writing them.
const BYTES_TO_WRITE: u64 = 32 << 20;

/// What `relief mesh` is given.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// Height map: PNG, JPEG, EXR, TIFF, GeoTIFF, HDR, PGM or headerless 16-bit raw
    height: PathBuf,
    /// Mesh to write: GLB, PLY and OBJ in metres with y up, STL in millimetres; - for the standard output
    #[arg(short, long, value_name = "FILE.glb|ply|obj|stl")]
    output: PathBuf,
    /// Format of a mesh that goes to the standard output, as in -o - --format stl
    #[arg(long, value_enum, value_name = "glb|ply|obj|stl", hide_short_help = true)]
    format: Option<Format>,
    /// A vertex every N texels: on a plane at the centres of every N-th one, elsewhere along the mesh's edges
    /// [default: 1]
    #[arg(long, value_name = "N", allow_hyphen_values = true, help_heading = "Triangles")]
    texels: Option<u32>,
    #[arg(
        long,
        value_name = "NAME",
        value_parser = edge_rule,
        help_heading = "Triangles",
        hide_short_help = true,
        help = edges_help(),
    )]
    edges: Option<&'static EdgeRule>,
    #[arg(
        long,
        value_name = "NAME",
        value_parser = interior,
        help_heading = "Triangles",
        hide_short_help = true,
        help = interior_help(),
    )]
    interior: Option<&'static Interior>,
    /// What is displaced: the flat triangles of the mesh, or lift, the smooth surface that its normals
    /// promise [default: flat]
    #[arg(long, value_name = "flat|lift", help_heading = "Triangles")]
    base: Option<BaseSurface>,
    /// Along what: raw, the interpolated normals as they are, or unit, these normalised [default: raw]
    #[arg(long, value_name = "raw|unit", help_heading = "Triangles", hide_short_help = true)]
    directions: Option<Directions>,
    /// Normals of the vertices: exact, of the relief between the texels, or mesh, of the triangles
    /// [default: exact]
    #[arg(long, value_name = "exact|mesh", help_heading = "Triangles")]
    shading: Option<Shading>,
    /// Hard edges and seams of the texture: weld gives a position one displacement, so that a closed mesh
    /// stays closed; keep gives each side its own, and gapes [default: weld]
    #[arg(long, value_name = "weld|keep", help_heading = "Triangles")]
    seams: Option<Seams>,
    /// Make the mesh as large as this along its longest side, in millimetres, or with a unit, as in 12cm
    /// [default: as large as the base mesh is]
    #[arg(
        long,
        value_name = "MM",
        value_parser = units::millimetres,
        allow_hyphen_values = true,
        help_heading = "Triangles"
    )]
    print_size: Option<f64>,
    /// Turn the relief inside out: what is high is low
    #[arg(long, help_heading = "Triangles")]
    invert: bool,
    #[command(flatten)]
    placed: PlacedArguments,
    #[command(flatten)]
    reading: HeightArguments,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
    /// Refuse to take more memory than this, as in 512MiB [default: 4GiB]
    #[arg(long, value_name = "SIZE", allow_hyphen_values = true)]
    max_memory: Option<ByteSize>,
}

const AFTER_HELP: &str = "Examples:\n  \
    relief mesh dem.tif -o dem.glb                                    # every texel of an elevation model\n  \
    relief mesh dem.tif --texels 4 --print-size 150 -o dem.stl        # coarser, 15 cm long, to print\n  \
    relief mesh bark.png --mesh tree.obj --scale 2cm -o tree.glb      # on a mesh with a texture\n  \
    relief mesh wall.png --mesh sphere --tile 8,4 --base lift -o ball.ply\n\n\
    The triangles are the relief that `relief render` shows, with the same --scale and --bias: carved into \
    the mesh unless a bias lifts it, --bias 0 puts it on top. A plane has the proportions of the height map, \
    its longer side 1 m. Without --seams keep the file has no cracks where the mesh has none: the answer \
    counts open edges, those of a sheet's border among them. Look at it with `relief render --mesh FILE`, \
    `relief inspect FILE`, or any viewer of glTF.";

/// A format, by the ending of the output's name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    Glb,
    Ply,
    Obj,
    Stl,
}

const FORMATS: [(&str, (Format, MeshFormat)); 4] = [
    ("glb", (Format::Glb, MeshFormat::Gltf)),
    ("ply", (Format::Ply, MeshFormat::Ply)),
    ("obj", (Format::Obj, MeshFormat::Obj)),
    ("stl", (Format::Stl, MeshFormat::Stl)),
];

fn edge_rule(name: &str) -> Result<&'static EdgeRule, UnknownName> {
    relief_mesh::edge_rule(name)
}

fn interior(name: &str) -> Result<&'static Interior, UnknownName> {
    relief_mesh::interior(name)
}

fn listed<'a>(what: &str, rows: impl Iterator<Item = (&'a str, &'a str)>) -> String {
    let rows: Vec<(&str, &str)> = rows.collect();
    let listed: Vec<String> = rows.iter().map(|(name, summary)| format!("{name} ({summary})")).collect();
    let default = rows.first().map_or("", |(name, _)| name);
    format!("{what}: {} [default: {default}]", listed.join(", "))
}

fn edges_help() -> String {
    let rows = EDGE_RULES.iter().map(|rule| (rule.name, rule.summary));
    listed("Where the mesh's edges are divided", rows)
}

fn interior_help() -> String {
    let rows = INTERIORS.iter().map(|interior| (interior.name, interior.summary));
    listed("What fills its triangles", rows)
}

/// Reads, makes and writes.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let started = Instant::now();
    let (_, format) = format_of("--output", &arguments.output, &FORMATS, &arguments.inputs())?;
    let settings = arguments.settings()?;
    let spec = arguments.spec();
    let scene = {
        let _reading = Progress::spinner("reading", arguments.json);
        spec.load().map_err(of_scene)?
    };
    if !arguments.json {
        maps::of_reading(&spec, &scene).into_iter().for_each(say::note);
    }
    let surface = scene.surfaces()[0].clone();
    drop(scene);
    let mesher = Mesher::new(surface.mesh(), surface.height_map(), &settings).map_err(of_mesher)?;
    let counts = MeshCounts { vertices: mesher.vertices(), triangles: mesher.triangles() };
    let name = arguments.output.display();
    format.check(counts).map_err(|problem| {
        Failure::Work(format!("{name}: {problem} (a larger --texels makes it coarser)"))
    })?;
    arguments.check_memory(&surface, &mesher)?;
    let cancel = interrupt::catch()?;
    let mut staged = Staged::open(&[&arguments.output], arguments.json, cancel)?;
    let aside = staged.aside(&arguments.output)?;
    let print_m = arguments.print_size.map(|mm| mm / 1000.0);
    let output = made::Output { path: &arguments.output, aside: &aside, format, counts };
    let streamed = output.write(&mesher, print_m, arguments.json, cancel)?;
    let bytes = std::fs::metadata(&aside).map_err(Failure::work)?.len();
    staged.finish()?;
    let seconds = started.elapsed().as_secs_f64();
    let about = report::About { format, counts, streamed, bytes, seconds, surface: &surface };
    answer(|out| about.tell(arguments, out))
}

impl Arguments {
    /// The files that may be standard streams.
    pub fn files(&mut self) -> Files<'_> {
        let of = |format: Format| FORMATS.iter().find(|(_, (known, _))| *known == format);
        let format = self.format.and_then(of).map(|(ending, _)| *ending);
        let mesh = Written { flag: "--output", path: &mut self.output, format };
        Files { read: vec![&mut self.height], written: vec![mesh] }
    }

    /// The files that are read.
    fn inputs(&self) -> Vec<&Path> {
        let mesh = match &self.placed.mesh {
            Some(MeshChoice::File(file)) => Some(file.as_path()),
            _ => None,
        };
        [Some(self.height.as_path()), mesh].into_iter().flatten().collect()
    }

    /// How the mesh is made.
    fn settings(&self) -> Result<MeshSettings, Failure> {
        if let Some(size) = self.print_size.filter(|size| !(1e-3..=1e9).contains(size)) {
            let must = "it must be from 0.001 to 1e9 millimetres";
            return Err(Failure::Usage(format!("--print-size: {size} cannot be used: {must}")));
        }
        let usual = MeshSettings::default();
        let settings = MeshSettings {
            edges: self.edges.unwrap_or(usual.edges),
            interior: self.interior.unwrap_or(usual.interior),
            texels: self.texels.unwrap_or(usual.texels),
            base: self.base.unwrap_or_default(),
            directions: self.directions.unwrap_or_default(),
            shading: self.shading.unwrap_or_default(),
            seams: self.seams.unwrap_or_default(),
        };
        if settings.texels == 0 {
            return Err(of_mesher(MesherError::NoTexels));
        }
        relief_mesh::check_pair(settings.edges, settings.interior).map_err(of_mesher)?;
        Ok(settings)
    }

    /// The height map on its mesh, as scenes have it, in the smallest of pictures.
    fn spec(&self) -> SceneSpec {
        let surface = self.placed.surface(&self.reading);
        let depth = if self.invert { Some(!self.reading.depth) } else { surface.depth };
        let surface = SurfaceSpec { height: Some(self.height.clone()), depth, ..surface };
        SceneSpec {
            size: Some([1, 1]),
            samples: Some(1),
            max_memory: self.max_memory,
            ..SceneSpec::of_surface(surface)
        }
    }

    /// Whether the mesh can be made within the memory that is allowed.
    fn check_memory(&self, surface: &Surface, mesher: &Mesher) -> Result<(), Failure> {
        let limit = self.max_memory.map_or(DEFAULT_MAX_BYTES, |size| size.0);
        let map = surface.height_map();
        let of_map = size_of::<f32>() as u64 * u64::from(map.width()) * u64::from(map.height());
        let needed = of_map + mesher.bytes() + BYTES_TO_WRITE;
        if needed <= limit {
            return Ok(());
        }
        let (mib, limit) = (needed.div_ceil(1 << 20), ByteSize(limit));
        Err(Failure::Work(format!(
            "a mesh of {} triangles takes {mib} MiB to make, more than the {limit} allowed: --max-memory \
             raises it, a larger --texels makes the mesh coarser",
            mesher.triangles()
        )))
    }
}

/// What there can be no mesh of.
fn of_mesher(error: MesherError) -> Failure {
    match error {
        MesherError::NoTexels => Failure::Usage(format!("--texels: {error}")),
        MesherError::Pair { .. } => Failure::usage(error),
        MesherError::TooLarge { .. } => {
            Failure::Work(format!("{error}: a larger --texels, or fewer tiles, make it coarser"))
        }
        other => Failure::work(other),
    }
}
