//! `relief mesh`: a height map and a mesh to displaced triangles in a file.

mod accuracy;
mod ground;
mod made;
mod parts;
mod refused;
mod report;
mod seen;
mod settings;

use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::{Args, ValueEnum};
use relief_core::ByteSize;
use relief_core::registry::UnknownName;
use relief_io::omissions::{self, UNDECLARED_NODATA};
use relief_io::{DEFAULT_MAX_BYTES, GlbMaterials, MeshFormat, Remark, Up};
use relief_mesh::{
    BaseSurface, Directions, EDGE_RULES, EdgeRule, Fit, INTERIORS, Interior, Judge, Mesher, Seams, Shading,
    Side, View,
};
use relief_scene::{MeshChoice, Scene, SceneSpec, Surface, SurfaceSpec, read_scene};

use self::accuracy::Tolerance;
use self::ground::Metres;
use self::refused::COARSER;
use self::seen::{LevelFilter, Seen};
use super::lengths;
use super::maps::{self, By, HeightArguments};
use super::placed::PlacedArguments;
use super::scene_arguments::of_scene;
use super::staged::{Staged, format_of};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::streams::{Files, Written, tell_written};
use crate::units::Length;
use crate::{interrupt, say, units, values};

/// Memory for what is held of blocks between making and writing them.
const BYTES_TO_WRITE: u64 = 32 << 20;

/// What `relief mesh` is given.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// Height map: PNG, JPEG, EXR, TIFF, GeoTIFF, HDR, PGM or headerless 16-bit raw
    height: PathBuf,
    /// Mesh to write: GLB, PLY and OBJ in metres with y up, STL in millimetres with z up; - for the standard
    /// output
    #[arg(short, long, value_name = "FILE.glb|ply|obj|stl")]
    output: PathBuf,
    /// Format of a mesh that goes to the standard output, as in -o - --format stl
    #[arg(long, value_enum, value_name = "glb|ply|obj|stl", hide_short_help = true)]
    format: Option<Format>,
    /// As few triangles as keep the relief within this of them, everywhere: a length as in 2mm or 0.5m, of
    /// the mesh that is written, or a part of the scale, as in 1% [default: 0.5%, on a plane]
    #[arg(
        long,
        value_name = "LENGTH|PART%",
        value_parser = accuracy::tolerance,
        allow_hyphen_values = true,
        help_heading = "Triangles"
    )]
    error: Option<Tolerance>,
    /// The least error that so many triangles allow
    #[arg(
        long,
        value_name = "N",
        allow_hyphen_values = true,
        conflicts_with_all = ["error", "tiles"],
        help_heading = "Triangles"
    )]
    triangles: Option<u64>,
    /// A vertex every N texels: on a plane at the centres of every N-th one, elsewhere along the mesh's edges
    /// [default: 1, where the mesh is no plane]
    #[arg(
        long,
        value_name = "N",
        allow_hyphen_values = true,
        conflicts_with_all = ["error", "triangles"],
        help_heading = "Triangles"
    )]
    texels: Option<u32>,
    /// As fine as the camera of a scene file sees it, with the size of its picture: a vertex every --pixels
    #[arg(
        long,
        value_name = "SCENE.toml",
        conflicts_with_all = ["error", "triangles", "texels"],
        help_heading = "Triangles"
    )]
    view: Option<PathBuf>,
    /// A vertex every N pixels of the --view, along the mesh's edges and inside, and as far apart along the
    /// line of sight [default: 1]
    #[arg(
        long,
        value_name = "N",
        value_parser = values::positive,
        allow_hyphen_values = true,
        requires = "view",
        help_heading = "Triangles"
    )]
    pixels: Option<f64>,
    /// Times as many vertices along an edge of a --view: (1 - S f) (1 + G s + V v), by how much it faces the
    /// eye (f, 0 at the silhouette to 1), the mean slope of the relief along it (s) and how much of its range
    /// it has there (v); with the interior dice [default: 0,0,0]
    #[arg(
        long,
        value_name = "S,G,V",
        value_parser = values::point,
        allow_hyphen_values = true,
        requires = "view",
        help_heading = "Triangles",
        hide_short_help = true
    )]
    weights: Option<[f64; 3]>,
    /// Heights where vertices of a --view are farther apart than texels, by coarser levels of the map:
    /// average; max or min, nowhere below or above the relief; least-squares; variational, the nearest by
    /// volume, which takes a while; or none, those of the map [default: least-squares]
    #[arg(long, value_name = "NAME", requires = "view", help_heading = "Triangles", hide_short_help = true)]
    level_filter: Option<LevelFilter>,
    /// Where --error and --triangles look: surface, everywhere on the relief between the texels, or texels,
    /// at their centres alone, as other programs do [default: surface]
    #[arg(long, value_name = "surface|texels", help_heading = "Triangles", hide_short_help = true)]
    judge: Option<Judge>,
    /// Which heights the vertices of --error and --triangles have: heights, such that fewer triangles are
    /// enough, or none, those of the relief [default: heights]
    #[arg(long, value_name = "heights|none", help_heading = "Triangles", hide_short_help = true)]
    fit: Option<Fit>,
    /// On which side of the relief the triangles of --error and --triangles lie: both; above, so that nothing
    /// that stands on them sinks into it; or below [default: both]
    #[arg(long, value_name = "both|above|below", help_heading = "Triangles")]
    side: Option<Side>,
    /// Close an open mesh with walls and an underside, at least so many millimetres of the file thick, or
    /// with a unit, as in 1cm: under a plane a flat bottom, elsewhere the mesh itself, displaced by the same
    /// everywhere. All triangles share their vertices. With --holes a plane has walls along its outline. A mesh
    /// longer than 2 m needs --print-size
    #[arg(
        long,
        value_name = "MM",
        value_parser = units::millimetres,
        allow_hyphen_values = true,
        help_heading = "Triangles"
    )]
    solid: Option<f64>,
    /// Cut a plane into columns and rows, a file each: FILE-0-0.glb, FILE-1-0.glb and so on. Where they meet
    /// they have the same vertices
    #[arg(
        long,
        value_name = "COLUMNSxROWS",
        value_parser = parts::columns_and_rows,
        allow_hyphen_values = true,
        help_heading = "Triangles"
    )]
    tiles: Option<[u32; 2]>,
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
    /// What is displaced: the flat triangles of the mesh; lift, the smooth surface that its normals promise;
    /// or pn, cubic triangles at right angles to them [default: flat]
    #[arg(long, value_name = "flat|lift|pn", help_heading = "Triangles")]
    base: Option<BaseSurface>,
    /// Along what: raw, the interpolated normals as they are; unit, these normalised; or angle, normals
    /// interpolated by their angles [default: raw]
    #[arg(long, value_name = "raw|unit|angle", help_heading = "Triangles", hide_short_help = true)]
    directions: Option<Directions>,
    /// Normals of the vertices: exact, of the relief between the texels; derivative, the same as if the mesh
    /// were level; rotation, the mesh's normals turned by two angles; or mesh, of the triangles [default:
    /// exact]
    #[arg(long, value_name = "exact|derivative|rotation|mesh", help_heading = "Triangles")]
    shading: Option<Shading>,
    /// Hard edges and seams of the texture: weld gives a position one displacement, so that a closed mesh
    /// stays closed; keep gives each side its own, and gapes [default: weld]
    #[arg(long, value_name = "weld|keep", help_heading = "Triangles")]
    seams: Option<Seams>,
    /// Leave out the triangles over texels without a value, in place of filling them. With --error their
    /// outlines are within a texel, else as fine as the triangles
    #[arg(long, help_heading = "Triangles")]
    holes: bool,
    /// Make the mesh as large as this along its longest side, in millimetres, or with a unit, as in 12cm
    /// [default: as large as the base mesh is, a plane as large as the ground where the map says its metres]
    #[arg(
        long,
        value_name = "MM",
        value_parser = units::millimetres,
        allow_hyphen_values = true,
        help_heading = "Triangles"
    )]
    print_size: Option<f64>,
    /// Store a GLB in integers (KHR_mesh_quantization), positions in so many bits a coordinate, from 8 to 16:
    /// about a third smaller. Cracks do not open; the answer says how far vertices were moved, and how many
    /// triangles lost their area
    #[arg(
        long,
        value_name = "BITS",
        value_parser = clap::value_parser!(u32).range(8..=16),
        allow_hyphen_values = true,
        help_heading = "Triangles"
    )]
    quantize: Option<u32>,
    /// Store the triangles of a GLB as strips: 1 to 1.5 indices a triangle in place of three, files a fifth
    /// smaller. Triangles without an area join them, which some programs count
    #[arg(long, help_heading = "Triangles")]
    strips: bool,
    /// So many levels of detail in one GLB, 2 to 8, the first as asked for, each other one twice as coarse:
    /// --texels and --pixels twice as large, --error too, --triangles a quarter. Programs that know MSFT_lod
    /// show one or the other, others the first
    #[arg(
        long,
        value_name = "N",
        value_parser = clap::value_parser!(u32).range(2..=8),
        allow_hyphen_values = true,
        help_heading = "Triangles"
    )]
    lods: Option<u32>,
    /// Move the node of a GLB to where its map lies, x east and z south, in metres. Programs that reckon in
    /// 32 bits show it shaking: without it the file says in its extras where it lies
    #[arg(long, help_heading = "Triangles", hide_short_help = true)]
    place: bool,
    /// Axis of the file that points up: y or z. A GLB always has y up [default: z in STL, y in others]
    #[arg(long, value_name = "y|z", help_heading = "Triangles")]
    up: Option<Up>,
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
    relief mesh dem.tif -o dem.glb                                    # as fine as half a percent asks\n  \
    relief mesh dem.tif --error 2m --tiles 4x4 -o dem.glb             # to 2 m of the ground, in 16 files\n  \
    relief mesh dem.tif --exaggerate 2 -o dem.glb                     # twice as high\n  \
    relief mesh dem.tif --print-size 150 --solid 3 -o dem.stl         # 15 cm long, to print\n  \
    relief mesh island.tif --holes --solid 3 --print-size 150 -o island.stl  # cut out along its outline\n  \
    relief mesh bark.png --mesh panel.obj --scale 1mm --solid 2 -o panel.stl  # a curved sheet, to print\n  \
    relief mesh dem.tif --texels 1 -o dem.glb                         # every texel of it\n  \
    relief mesh dem.tif --error 2m --quantize 12 -o dem.glb           # a third smaller, in integers\n  \
    relief mesh dem.tif --error 2m --strips -o dem.glb                # a fifth smaller, as strips\n  \
    relief mesh dem.tif --error 1m --lods 4 -o dem.glb                # and three coarser levels\n  \
    relief mesh dem.tif --view flight.toml --pixels 2 -o dem.glb      # every second pixel of a picture\n  \
    relief mesh bark.png --mesh tree.obj --scale 2cm -o tree.glb      # on a mesh with a texture\n  \
    relief mesh bark.png --mesh tree.obj --scale 2cm --error 1% -o tree.glb   # with few triangles\n  \
    relief mesh wall.png --mesh sphere --tile 8,4 --base lift -o ball.ply\n\n\
    The triangles are the relief that `relief render` shows, with the same --scale and --bias: carved into \
    the mesh unless a bias lifts it, --bias 0 puts it on top. A plane whose map \
    knows its metres (by its file or --tile-size) is as long as the ground in place of that: its lowest height \
    is at y = 0, x is east and z south, --scale, --bias and --error are lengths of it, and --exaggerate N \
    makes heights N times as high. Other planes are 1 m long. On planes, and with --error elsewhere, \
    triangles are as large as that allows: no point \
    of the relief is farther from them, measured from the same point of the mesh, and the answer says how \
    far it is and where. --shading mesh smooths what texels much finer than the triangles do to normals. \
    Without \
    --seams keep the file has no cracks where the mesh has none: the answer counts open edges, those of a \
    sheet's border among them, and the triangles that are folded over, by those of the mesh (from 0) that \
    they are pieces of. Look at it with `relief render --mesh FILE`, `relief inspect FILE`, or any \
    viewer of glTF.";

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
    arguments.check(format)?;
    let metres = Metres::of(arguments);
    let spec = arguments.spec(&metres)?;
    let scene = {
        let _reading = Progress::spinner("reading", arguments.json);
        spec.load().map_err(of_scene)?
    };
    let surface = scene.surfaces()[0].clone();
    let mut notes = maps::of_reading(&spec, &scene, By::Flags);
    let materials = match arguments.materials(&surface, format) {
        Ok(materials) => materials,
        Err(why) => {
            let what = format!("the colours, masks and pictures of its materials are not written: {why}");
            let file = match &arguments.placed.mesh {
                Some(MeshChoice::File(file)) => file.as_path(),
                _ => Path::new("mesh"),
            };
            notes.insert(By::Flags.note(&Remark::new(&omissions::UNWRITTEN_MATERIALS, what).of(file)));
            None
        }
    };
    if let Some(ground) = spec.each_surface().first().and_then(maps::ground_of)
        && let Some(doubt) = lengths::doubt_of(&ground, surface.height_map())
    {
        // A value for none among heights is what is to be named, not their unit.
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
        return Err(Failure::usage("the surface is an object of images, which has no height map on a mesh"));
    }
    drop(scene);
    let surface = metres.applied(arguments, surface)?;
    if !arguments.json {
        arguments.notes(&metres, &surface).into_iter().for_each(say::note);
    }
    let cancel = interrupt::catch()?;
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
    let seen = Seen { surface: &surface, view, coarser, metres: &metres, materials };
    let written = made::write(arguments, &seen, format, &files, &mut staged, cancel)?;
    staged.finish()?;
    let seconds = started.elapsed().as_secs_f64();
    let about = report::About {
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
    /// The files that may be standard streams.
    pub fn files(&mut self) -> Files<'_> {
        let of = |format: Format| FORMATS.iter().find(|(_, (known, _))| *known == format);
        let format = self.format.and_then(of).map(|(ending, _)| *ending);
        let mesh = Written { flag: "--output", path: &mut self.output, format };
        Files {
            read: vec![&mut self.height],
            written: vec![mesh],
            split: self.tiles.is_some().then_some("--tiles"),
        }
    }

    /// The files that are read.
    fn inputs(&self) -> Vec<&Path> {
        let mesh = match &self.placed.mesh {
            Some(MeshChoice::File(file)) => Some(file.as_path()),
            _ => None,
        };
        [Some(self.height.as_path()), mesh, self.view.as_deref()].into_iter().flatten().collect()
    }

    /// The materials of the base that are written.
    ///
    /// # Errors
    ///
    /// With a reason where they cannot be.
    fn materials(&self, surface: &Surface, format: MeshFormat) -> Result<Option<GlbMaterials>, String> {
        if surface.file_colors().is_none_or(|colors| colors.colored() == 0) {
            return Ok(None);
        }
        if format != MeshFormat::Gltf {
            return Err(format!("{format} is written without, a .glb holds them"));
        }
        let (materials, of_base) =
            surface.file_materials().ok_or("they are more than are drawn, or lie on few triangles each")?;
        if self.strips && !of_base.is_empty() {
            return Err("--strips are of one material".to_owned());
        }
        if Mesher::is_plane(surface.mesh()) && !of_base.is_empty() {
            return Err("the base is a plane, which is made as a whole".to_owned());
        }
        GlbMaterials::new(materials, of_base).map(Some).map_err(|problem| problem.to_string())
    }

    /// The most memory.
    fn limit(&self) -> u64 {
        self.max_memory.map_or(DEFAULT_MAX_BYTES, |size| size.0)
    }

    /// The height map on its mesh, as scenes have it, seen by the camera of the view, or in the smallest of
    /// pictures.
    ///
    /// A scene's plane is 1 m long: lengths of the mesh that is written become lengths of that.
    fn spec(&self, metres: &Metres) -> Result<SceneSpec, Failure> {
        let surface = self.placed.surface(&self.reading);
        let in_scene = |length_m: Option<f64>| length_m.map(|length_m| length_m / metres.factor);
        let (scale, bias) = (in_scene(surface.scale), in_scene(surface.bias));
        let surface = SurfaceSpec { scale, bias, ..surface };
        // A file may say itself that it holds depths.
        let of_file = || {
            let surface = SurfaceSpec { height: Some(self.height.clone()), ..surface.clone() };
            maps::ground_of(&surface).is_some_and(|ground| maps::is_depth(&ground))
        };
        let depth = if self.invert { Some(!(self.reading.depth || of_file())) } else { surface.depth };
        let holes = self.holes.then_some(true);
        let surface = SurfaceSpec { height: Some(self.height.clone()), depth, holes, ..surface };
        let seen = match &self.view {
            Some(file) => read_scene(file).map_err(Failure::work)?,
            None => SceneSpec { size: Some([1, 1].into()), ..SceneSpec::default() },
        };
        let SceneSpec { view, eye, target, projection, fov, view_height, near, far, size, .. } = seen;
        Ok(SceneSpec {
            view,
            eye,
            target,
            projection,
            fov,
            view_height,
            near,
            far,
            size,
            samples: Some(1),
            max_memory: self.max_memory,
            ..SceneSpec::of_surface(surface)
        })
    }

    /// What may not be meant, of lengths.
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
                "--error {}: the whole relief is {} high, so that it may be left out",
                units::in_words(error_m),
                units::in_words(relief_m)
            ));
        }
        if let Some(Length { metres: scale_m, has_unit: false }) = self.placed.scale
            && metres.is_known()
        {
            let plane = units::in_words(metres.factor);
            notes.push(format!(
                "--scale {scale_m}: taken for {scale_m} m of the mesh, which is {plane} long; a factor on \
                 heights is --exaggerate N, and `relief render` shows the same with --scale {}, as its plane \
                 is 1 m long (with its unit, as in --scale {scale_m}m, this is not said)",
                values::six_digits(scale_m / metres.factor)
            ));
        }
        notes
    }

    /// From where the mesh is looked at.
    fn view_of(&self, spec: &SceneSpec, scene: &Scene) -> Option<View> {
        self.view.as_ref()?;
        let view = View::new(*scene.camera(), scene.size());
        // Parallel rays see what is near as large as anything.
        let near_m = spec.near.filter(|_| !view.camera.is_orthographic()).unwrap_or(view.near_m);
        Some(View { pixels: self.pixels.unwrap_or(view.pixels), near_m, ..view })
    }

    /// Whether the mesh can be made within the memory that is allowed.
    fn check_memory(&self, surface: &Surface, levels: &[Mesher]) -> Result<(), Failure> {
        let limit = self.limit();
        let needed = bytes_of(surface) + levels.iter().map(Mesher::bytes).sum::<u64>() + BYTES_TO_WRITE;
        if needed <= limit {
            return Ok(());
        }
        let (mib, limit) = (needed.div_ceil(1 << 20), ByteSize(limit));
        Err(Failure::Work(format!(
            "a mesh of {} triangles takes {mib} MiB to make, more than the {limit} allowed: --max-memory \
             raises it, {COARSER}",
            levels.iter().map(Mesher::triangles).sum::<u64>()
        )))
    }
}

/// The memory of a surface's map.
fn bytes_of(surface: &Surface) -> u64 {
    let map = surface.height_map();
    size_of::<f32>() as u64 * u64::from(map.width()) * u64::from(map.height())
}
