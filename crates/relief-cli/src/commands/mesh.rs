//! `relief mesh`: displaces a mesh by a height map and writes the triangles to a file.

mod accuracy;
mod baked_maps;
mod ground;
mod level_filter;
mod motif;
mod parts;
mod refused;
mod report;
mod settings;
mod texture_set;
mod write;

use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::builder::ArgPredicate;
use clap::{Args, ValueEnum};
use relief_core::ByteSize;
use relief_core::registry::UnknownName;
use relief_io::omissions::{self, OTHER_PICTURES, UNDECLARED_NODATA, UNSHOWN_MATERIAL};
use relief_io::{DEFAULT_MAX_BYTES, GlbMaterials, MeshFormat, MeshMaterial, Remark, Up, material_name};
use relief_mesh::{
    BaseSurface, Directions, EDGE_RULES, EdgeRule, Fit, INTERIORS, Interior, Judge, Mesher, Seams, Shading,
    Side, View,
};
use relief_scene::motif::VectorAxes;
use relief_scene::{MeshChoice, NO_MAP, Scene, SceneSpec, Surface, SurfaceSpec, read_scene};
use relief_shaders::field::Solids;

use self::accuracy::Tolerance;
use self::baked_maps::MeshMap;
use self::ground::Metres;
use self::level_filter::LevelFilter;
use self::refused::COARSER;
use self::write::Source;
use super::lengths;
use super::maps::{self, By, HeightArguments};
use super::placement::PlacementArguments;
use super::scene_arguments::of_scene;
use super::staged::{Staged, format_of};
use crate::failure::Failure;
use crate::file_kind::is_volume;
use crate::progress::Progress;
use crate::streams::{Files, Written, tell_written};
use crate::units::Length;
use crate::{interrupt, say, units, values};

/// Memory for blocks between making and writing them.
const BYTES_TO_WRITE: u64 = 32 << 20;

/// Materials, and the index of each base triangle's; no indices if all have the first.
type Materials = (Vec<MeshMaterial>, Vec<u32>);

/// Arguments of `relief mesh`.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// Height map: PNG, JPEG, EXR, TIFF, GeoTIFF, HDR, PGM or headerless 16-bit raw; or a folder of
    /// textures, whose heights are displaced and whose material goes into a GLB
    #[arg(
        required = false,
        required_unless_present = "motif",
        default_value_if("motif", ArgPredicate::IsPresent, NO_MAP),
        hide_default_value = true
    )]
    height: PathBuf,
    /// Closed mesh in the space of a tile, in place of a height map: chain mail, cloth or grass of
    /// `relief motif`, or one's own. It is repeated over the mesh, on top of it, in the shells that
    /// --surface tetrahedra shows. x and z go from 0 to 1 along the tile, y from 0 to 1 along the
    /// height. Or a vector displacement map (EXR, PNG or TIFF with R, G and B), which moves the points
    /// of a sheet along three axes. A vector of length 1 is then as long as --scale, or as a tile
    #[arg(
        long,
        value_name = "FILE",
        conflicts_with_all = [
            "error", "triangles", "texels", "view", "level_filter", "judge", "fit", "side", "solid", "tiles",
            "edges", "interior", "base", "directions", "shading", "maps", "textures", "udim", "seams", "holes",
            "print_size", "quantize", "strips", "lods", "place", "up", "invert"
        ],
        help_heading = "Maps and mesh"
    )]
    motif: Option<PathBuf>,
    /// What R, G and B of a vector displacement map are: tnb, tangent, normal, bitangent, as Mudbox
    /// and Blender's node take them; or tbn, tangent, bitangent, normal, as in Blender's brushes.
    /// Bitangents point up in the map [default: tnb]
    #[arg(long, value_name = "tnb|tbn", help_heading = "Maps and mesh")]
    axes: Option<VectorAxes>,
    /// Mesh to write: GLB, PLY and OBJ in metres with y up, STL in millimetres with z up; - for
    /// standard output
    #[arg(short, long, value_name = "FILE.glb|ply|obj|stl")]
    output: PathBuf,
    /// Format of a mesh on standard output, as in -o - --format stl
    #[arg(long, value_enum, value_name = "glb|ply|obj|stl", hide_short_help = true)]
    format: Option<Format>,
    /// Tolerance: use as few triangles as keep the relief within this distance of them everywhere.
    /// A length of the written mesh, as in 2mm or 0.5m, or a part of the scale, as in 1% [default:
    /// 0.5%, on a plane]
    #[arg(
        long,
        value_name = "LENGTH|PART%",
        value_parser = accuracy::tolerance,
        allow_hyphen_values = true,
        help_heading = "Triangles"
    )]
    error: Option<Tolerance>,
    /// Most triangles to use; the mesh gets the least error that they allow
    #[arg(
        long,
        value_name = "N",
        allow_hyphen_values = true,
        conflicts_with_all = ["error", "tiles"],
        help_heading = "Triangles"
    )]
    triangles: Option<u64>,
    /// Spacing of vertices in texels: on a plane at the centres of every N-th one, elsewhere along
    /// the mesh's edges [default: 1, where the mesh is no plane]
    #[arg(
        long,
        value_name = "N",
        allow_hyphen_values = true,
        conflicts_with_all = ["error", "triangles"],
        help_heading = "Triangles"
    )]
    texels: Option<u32>,
    /// Scene file whose camera and picture size set the fineness: one vertex every --pixels
    #[arg(
        long,
        value_name = "SCENE.toml",
        conflicts_with_all = ["error", "triangles", "texels"],
        help_heading = "Triangles"
    )]
    view: Option<PathBuf>,
    /// Spacing of vertices in pixels of the --view, along the mesh's edges and inside, and as far
    /// apart along the line of sight [default: 1]
    #[arg(
        long,
        value_name = "N",
        value_parser = values::positive,
        allow_hyphen_values = true,
        requires = "view",
        help_heading = "Triangles"
    )]
    pixels: Option<f64>,
    /// Weights of the number of vertices along an edge of a --view: (1 - S f) (1 + G s + V v). f:
    /// how much the edge faces the camera, from 0 at the silhouette to 1; s: mean slope of the
    /// relief along it; v: share of the relief's range along it. Needs the interior dice [default:
    /// 0,0,0]
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
    /// Filter of the height map's coarser levels, used where vertices of a --view are farther apart
    /// than texels: average; max or min, nowhere below or above the relief; least-squares;
    /// variational, the nearest by volume, which is slow; or none, the map itself [default:
    /// least-squares]
    #[arg(long, value_name = "NAME", requires = "view", help_heading = "Triangles", hide_short_help = true)]
    level_filter: Option<LevelFilter>,
    /// Where --error and --triangles measure: surface, everywhere on the relief between the texels;
    /// or texels, at their centres alone, as other programs do [default: surface]
    #[arg(long, value_name = "surface|texels", help_heading = "Triangles", hide_short_help = true)]
    judge: Option<Judge>,
    /// Heights of the vertices of --error and --triangles: heights, fitted so that fewer triangles
    /// suffice, or none, the relief's own [default: heights]
    #[arg(long, value_name = "heights|none", help_heading = "Triangles", hide_short_help = true)]
    fit: Option<Fit>,
    /// Side of the relief on which the triangles of --error and --triangles lie: both; above, so
    /// that objects on them do not sink into the relief; or below [default: both]
    #[arg(long, value_name = "both|above|below", help_heading = "Triangles")]
    side: Option<Side>,
    /// Close an open mesh with walls and an underside, at least this thick: millimetres of the
    /// file, or a length as in 1cm. Under a plane the underside is flat, elsewhere it is the mesh,
    /// displaced evenly. All triangles share their vertices. With --holes a plane gets walls along
    /// its outline. A mesh longer than 2 m needs --print-size
    #[arg(
        long,
        value_name = "MM",
        value_parser = units::millimetres,
        allow_hyphen_values = true,
        help_heading = "Triangles"
    )]
    solid: Option<f64>,
    /// Cut a plane into columns and rows, one file each: FILE-0-0.glb, FILE-1-0.glb and so on.
    /// Neighbours share the vertices on their common edge
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
    /// Base that is displaced: flat, the triangles of the mesh; lift, the smooth base of its
    /// normals; or pn, cubic triangles at right angles to the normals [default: flat]
    #[arg(long, value_name = "flat|lift|pn", help_heading = "Triangles")]
    base: Option<BaseSurface>,
    /// Directions of displacement: raw, the interpolated normals; unit, these normalised; or angle,
    /// normals interpolated by their angles [default: raw]
    #[arg(long, value_name = "raw|unit|angle", help_heading = "Triangles", hide_short_help = true)]
    directions: Option<Directions>,
    /// Normals of the vertices: exact, of the relief between the texels; derivative, as if the mesh
    /// were level; rotation, the mesh's normals turned by two angles; mesh, of the triangles; or base,
    /// of the base mesh [default: exact, with --maps normal base]
    #[arg(long, value_name = "exact|derivative|rotation|mesh|base", help_heading = "Triangles")]
    shading: Option<Shading>,
    /// Maps of the relief to bake into the GLB, in the texels of the height map: normal, which shows
    /// the detail that few triangles lose; occlusion; or both, as in normal,occlusion. They replace
    /// the material's
    #[arg(
        long,
        value_enum,
        value_delimiter = ',',
        value_name = "normal|occlusion",
        help_heading = "Triangles"
    )]
    maps: Vec<MeshMap>,
    /// Folder of textures whose material goes into the GLB: colour, occlusion, roughness, metalness and
    /// emission. Its normal map is left out, as the triangles show the relief; --maps normal bakes one
    /// [default: the folder of the heights, if they come from one]
    #[arg(long, value_name = "FOLDER", help_heading = "Maps and mesh")]
    textures: Option<PathBuf>,
    /// UDIM tile whose maps are taken from the folder, as in 1001 [default: the only one]
    #[arg(long, value_name = "N", help_heading = "Maps and mesh", hide_short_help = true)]
    udim: Option<u32>,
    /// Displacement at hard edges and seams of the texture: weld gives a position one displacement,
    /// so that a closed mesh stays closed; keep gives each side its own, which leaves gaps
    /// [default: weld]
    #[arg(long, value_name = "weld|keep", help_heading = "Triangles")]
    seams: Option<Seams>,
    /// Leave out the triangles over holes (texels without a value). With --error the outlines are
    /// within a texel, else as fine as the triangles [default: holes are filled]
    #[arg(long, help_heading = "Triangles")]
    holes: bool,
    /// Length of the mesh's longest side in millimetres, or with a unit, as in 12cm [default: as
    /// large as the base mesh; a plane as large as the ground if the map's metres are known]
    #[arg(
        long,
        value_name = "MM",
        value_parser = units::millimetres,
        allow_hyphen_values = true,
        help_heading = "Triangles"
    )]
    print_size: Option<f64>,
    /// Store a GLB in integers (KHR_mesh_quantization), with this many bits per coordinate, 8 to
    /// 16: about a third smaller. Cracks do not open. The answer says how far vertices moved and
    /// how many triangles lost their area
    #[arg(
        long,
        value_name = "BITS",
        value_parser = clap::value_parser!(u32).range(8..=16),
        allow_hyphen_values = true,
        help_heading = "Triangles"
    )]
    quantize: Option<u32>,
    /// Store the triangles of a GLB as strips: 1 to 1.5 indices per triangle instead of three,
    /// files a fifth smaller. Triangles without area join the strips; some programs count them
    #[arg(long, help_heading = "Triangles")]
    strips: bool,
    /// Levels of detail in one GLB, 2 to 8. The first is as asked for, each next one twice as
    /// coarse: --texels, --pixels and --error doubled, --triangles quartered. Programs that know
    /// MSFT_lod choose a level, others show the first
    #[arg(
        long,
        value_name = "N",
        value_parser = clap::value_parser!(u32).range(2..=8),
        allow_hyphen_values = true,
        help_heading = "Triangles"
    )]
    lods: Option<u32>,
    /// Move the node of a GLB to its map's place on the ground, x east and z south, in metres.
    /// Programs that compute in 32 bits may show it shaking. Without this flag the file's extras
    /// state the place
    #[arg(long, help_heading = "Triangles", hide_short_help = true)]
    place: bool,
    /// Up axis of the file: y or z; a GLB always has y up [default: z in STL, y in others]
    #[arg(long, value_name = "y|z", help_heading = "Triangles")]
    up: Option<Up>,
    /// Turn the relief inside out: high becomes low
    #[arg(long, help_heading = "Triangles")]
    invert: bool,
    #[command(flatten)]
    placement: PlacementArguments,
    #[command(flatten)]
    reading: HeightArguments,
    /// Print the result as one JSON object
    #[arg(long)]
    pub json: bool,
    /// Memory limit, as in 512MiB; work that needs more is refused [default: 4GiB]
    #[arg(long, value_name = "SIZE", allow_hyphen_values = true)]
    max_memory: Option<ByteSize>,
}

const AFTER_HELP: &str = "Examples:\n  \
    relief mesh dem.tif -o dem.glb                                # to half a percent of the scale\n  \
    relief mesh dem.tif --error 2m --tiles 4x4 -o dem.glb         # to 2 m of the ground, in 16 files\n  \
    relief mesh dem.tif --exaggerate 2 -o dem.glb                 # twice as high\n  \
    relief mesh dem.tif --print-size 150 --solid 3 -o dem.stl     # 15 cm long, to print\n  \
    relief mesh island.tif --holes --solid 3 --print-size 150 -o island.stl  # the outline cut out\n  \
    relief mesh bark.png --mesh panel.obj --scale 1mm --solid 2 -o panel.stl  # a curved sheet\n  \
    relief mesh dem.tif --texels 1 -o dem.glb                     # one vertex per texel\n  \
    relief mesh dem.tif --error 2m --quantize 12 -o dem.glb       # a third smaller, in integers\n  \
    relief mesh dem.tif --error 2m --strips -o dem.glb            # a fifth smaller, as strips\n  \
    relief mesh dem.tif --error 5% --maps normal -o dem.glb       # few triangles, all of the shading\n  \
    relief mesh Bricks090 --scale 2cm --error 5% --maps normal -o bricks.glb  # with a folder's material\n  \
    relief mesh dem.tif --error 1m --lods 4 -o dem.glb            # and three coarser levels\n  \
    relief mesh dem.tif --view flight.toml --pixels 2 -o dem.glb  # one vertex per two pixels\n  \
    relief mesh bark.png --mesh tree.obj --scale 2cm -o tree.glb  # on a textured mesh\n  \
    relief mesh bark.png --mesh tree.obj --scale 2cm --error 1% -o tree.glb  # with few triangles\n  \
    relief mesh wall.png --mesh sphere --tile 8,4 --base lift -o ball.ply\n  \
    relief mesh --motif mail.glb --mesh torus --tile 9,3 -o armour.glb  # chain mail of `relief motif`\n  \
    relief mesh --motif data/mushrooms.exr --mesh panel.obj --tile 2,2 -o grown.glb  # a vector displacement map\n\n\
    The triangles show the same relief as `relief render` with the same --scale and --bias. By default it is \
    carved into the mesh; --bias 0 puts it on top.\n\n\
    A plane whose map knows its metres (by its file or --tile-size) is as long as the ground. Its lowest height \
    is then at y = 0, x is east and z south. --scale, --bias and --error are lengths of it, and --exaggerate N \
    makes heights N times as high. Other planes are 1 m long.\n\n\
    On planes, and with --error elsewhere, triangles are as large as the tolerance allows. No point of the \
    relief is farther from them, measured from the same point of the mesh; the answer says how far it is and \
    where. --shading mesh smooths the effect on normals of texels much finer than the triangles.\n\n\
    Without --seams keep the file has no cracks where the mesh has none. The answer counts open edges (a \
    sheet's border is open) and folded triangles, with the numbers of the mesh's triangles, from 0, that they \
    belong to. Look at the file with `relief render --mesh FILE`, `relief inspect FILE`, or any viewer of \
    glTF.";

/// File format, by the ending of the output's name.
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
    listed("Edge rule, which divides the mesh's edges", rows)
}

fn interior_help() -> String {
    let rows = INTERIORS.iter().map(|interior| (interior.name, interior.summary));
    listed("Interior, which fills the mesh's triangles", rows)
}

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
                "{file}: is a mesh, and a height map is asked for here: to repeat it over another mesh give it with \
                 --motif"
            )));
        }
        if is_volume(&self.height) {
            return Err(Failure::Usage(format!(
                "{file}: is a volume, which only `relief render` shows: give a height map, or with --motif the mesh \
                 that it was made from"
            )));
        }
        Ok(())
    }

    /// Returns the files that may be standard streams.
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

    /// Returns the files that are read.
    fn inputs(&self) -> Vec<&Path> {
        let mesh = match &self.placement.mesh {
            Some(MeshChoice::File(file)) => Some(file.as_path()),
            _ => None,
        };
        [Some(self.height.as_path()), mesh, self.view.as_deref()].into_iter().flatten().collect()
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

    /// Returns the memory limit in bytes.
    fn limit(&self) -> u64 {
        self.max_memory.map_or(DEFAULT_MAX_BYTES, |size| size.0)
    }

    /// Returns the scene of the height map on its mesh: seen by the camera of --view, or in the
    /// smallest of pictures.
    ///
    /// A scene's plane is 1 m long, so lengths of the written mesh are converted.
    fn spec(&self, metres: &Metres) -> Result<SceneSpec, Failure> {
        let surface = self.placement.surface(&self.reading);
        let in_scene = |length_m: Option<f64>| length_m.map(|length_m| length_m / metres.factor);
        let (scale, bias) = (in_scene(surface.scale), in_scene(surface.bias));
        let surface = SurfaceSpec { scale, bias, ..surface };
        // A file may itself state that it holds depths.
        let of_file = || {
            let surface = SurfaceSpec { height: Some(self.height_file().into_owned()), ..surface.clone() };
            self.is_set_of_depths() || maps::ground_of(&surface).is_some_and(|ground| maps::is_depth(&ground))
        };
        let depth = if self.invert { Some(!(self.reading.depth || of_file())) } else { surface.depth };
        let holes = self.holes.then_some(true);
        let textures = self.textures().map(Path::to_owned);
        // The triangles show the relief.
        let normal = textures.is_some().then(|| PathBuf::from(NO_MAP));
        let height = (!self.is_set()).then(|| self.height.clone());
        let surface = SurfaceSpec { height, textures, udim: self.udim, normal, depth, holes, ..surface };
        let viewed = match &self.view {
            Some(file) => read_scene(file).map_err(Failure::work)?,
            None => SceneSpec { size: Some([1, 1].into()), ..SceneSpec::default() },
        };
        let SceneSpec { view, eye, target, projection, fov, view_height, near, far, size, .. } = viewed;
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

    /// Returns the view of --view.
    fn view_of(&self, spec: &SceneSpec, scene: &Scene) -> Option<View> {
        self.view.as_ref()?;
        let view = View::new(*scene.camera(), scene.size());
        // An orthographic camera shows near things no larger than others.
        let near_m = spec.near.filter(|_| !view.camera.is_orthographic()).unwrap_or(view.near_m);
        Some(View { pixels: self.pixels.unwrap_or(view.pixels), near_m, ..view })
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
