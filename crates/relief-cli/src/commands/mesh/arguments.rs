//! Flags of `relief mesh`, its formats, and the files that it reads and writes.

use std::path::{Path, PathBuf};

use clap::builder::ArgPredicate;
use clap::{Args, ValueEnum};
use relief_core::ByteSize;
use relief_core::registry::UnknownName;
use relief_io::{DEFAULT_MAX_BYTES, MeshFormat, Up};
use relief_mesh::{BaseSurface, Directions, EdgeRule, Fit, Interior, Judge, Seams, Shading, Side};
use relief_scene::motif::VectorAxes;
use relief_scene::{MeshChoice, NO_MAP};

use super::accuracy::Tolerance;
use super::baked_maps::MeshMap;
use super::help::{AFTER_HELP, edges_help, interior_help};
use super::level_filter::LevelFilter;
use super::{accuracy, parts};
use crate::commands::maps::HeightArguments;
use crate::commands::placement::PlacementArguments;
use crate::streams::{Files, Written};
use crate::{units, values};

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
    pub(super) height: PathBuf,
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
            "edges", "interior", "base", "directions", "shading", "maps", "textures", "udim", "seams",
            "holes", "print_size", "quantize", "strips", "lods", "place", "up", "invert"
        ],
        help_heading = "Maps and mesh"
    )]
    pub(super) motif: Option<PathBuf>,
    /// What R, G and B of a vector displacement map are: tnb, tangent, normal, bitangent, as Mudbox
    /// and Blender's node take them; or tbn, tangent, bitangent, normal, as in Blender's brushes.
    /// Bitangents point up in the map [default: tnb]
    #[arg(long, value_name = "tnb|tbn", help_heading = "Maps and mesh")]
    pub(super) axes: Option<VectorAxes>,
    /// Mesh to write: GLB, PLY and OBJ in metres with y up, STL in millimetres with z up; - for
    /// standard output
    #[arg(short, long, value_name = "FILE.glb|ply|obj|stl")]
    pub(super) output: PathBuf,
    /// Format of a mesh on standard output, as in -o - --format stl
    #[arg(long, value_enum, value_name = "glb|ply|obj|stl", hide_short_help = true)]
    pub(super) format: Option<Format>,
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
    pub(super) error: Option<Tolerance>,
    /// Most triangles to use; the mesh gets the least error that they allow
    #[arg(
        long,
        value_name = "N",
        allow_hyphen_values = true,
        conflicts_with_all = ["error", "tiles"],
        help_heading = "Triangles"
    )]
    pub(super) triangles: Option<u64>,
    /// Spacing of vertices in texels: on a plane at the centres of every N-th one, elsewhere along
    /// the mesh's edges [default: 1, where the mesh is no plane]
    #[arg(
        long,
        value_name = "N",
        allow_hyphen_values = true,
        conflicts_with_all = ["error", "triangles"],
        help_heading = "Triangles"
    )]
    pub(super) texels: Option<u32>,
    /// Scene file whose camera and picture size set the fineness: one vertex every --pixels
    #[arg(
        long,
        value_name = "SCENE.toml",
        conflicts_with_all = ["error", "triangles", "texels"],
        help_heading = "Triangles"
    )]
    pub(super) view: Option<PathBuf>,
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
    pub(super) pixels: Option<f64>,
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
    pub(super) weights: Option<[f64; 3]>,
    /// Filter of the height map's coarser levels, used where vertices of a --view are farther apart
    /// than texels: average; max or min, nowhere below or above the relief; least-squares;
    /// variational, the nearest by volume, which is slow; or none, the map itself [default:
    /// least-squares]
    #[arg(long, value_name = "NAME", requires = "view", help_heading = "Triangles", hide_short_help = true)]
    pub(super) level_filter: Option<LevelFilter>,
    /// Where --error and --triangles measure: surface, everywhere on the relief between the texels;
    /// or texels, at their centres alone, as other programs do [default: surface]
    #[arg(long, value_name = "surface|texels", help_heading = "Triangles", hide_short_help = true)]
    pub(super) judge: Option<Judge>,
    /// Heights of the vertices of --error and --triangles: heights, fitted so that fewer triangles
    /// suffice, or none, the relief's own [default: heights]
    #[arg(long, value_name = "heights|none", help_heading = "Triangles", hide_short_help = true)]
    pub(super) fit: Option<Fit>,
    /// Side of the relief on which the triangles of --error and --triangles lie: both; above, so
    /// that objects on them do not sink into the relief; or below [default: both]
    #[arg(long, value_name = "both|above|below", help_heading = "Triangles")]
    pub(super) side: Option<Side>,
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
    pub(super) solid: Option<f64>,
    /// Cut a plane into columns and rows, one file each: FILE-0-0.glb, FILE-1-0.glb and so on.
    /// Neighbours share the vertices on their common edge
    #[arg(
        long,
        value_name = "COLUMNSxROWS",
        value_parser = parts::columns_and_rows,
        allow_hyphen_values = true,
        help_heading = "Triangles"
    )]
    pub(super) tiles: Option<[u32; 2]>,
    #[arg(
        long,
        value_name = "NAME",
        value_parser = edge_rule,
        help_heading = "Triangles",
        hide_short_help = true,
        help = edges_help(),
    )]
    pub(super) edges: Option<&'static EdgeRule>,
    #[arg(
        long,
        value_name = "NAME",
        value_parser = interior,
        help_heading = "Triangles",
        hide_short_help = true,
        help = interior_help(),
    )]
    pub(super) interior: Option<&'static Interior>,
    /// Base that is displaced: flat, the triangles of the mesh; lift, the smooth base of its
    /// normals; or pn, cubic triangles at right angles to the normals [default: flat]
    #[arg(long, value_name = "flat|lift|pn", help_heading = "Triangles")]
    pub(super) base: Option<BaseSurface>,
    /// Directions of displacement: raw, the interpolated normals; unit, these normalised; or angle,
    /// normals interpolated by their angles [default: raw]
    #[arg(long, value_name = "raw|unit|angle", help_heading = "Triangles", hide_short_help = true)]
    pub(super) directions: Option<Directions>,
    /// Normals of the vertices: exact, of the relief between the texels; derivative, as if the mesh
    /// were level; rotation, the mesh's normals turned by two angles; mesh, of the triangles; or base,
    /// of the base mesh [default: exact, with --maps normal base]
    #[arg(long, value_name = "exact|derivative|rotation|mesh|base", help_heading = "Triangles")]
    pub(super) shading: Option<Shading>,
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
    pub(super) maps: Vec<MeshMap>,
    /// Folder of textures whose material goes into the GLB: colour, occlusion, roughness, metalness and
    /// emission. Its normal map is left out, as the triangles show the relief; --maps normal bakes one
    /// [default: the folder of the heights, if they come from one]
    #[arg(long, value_name = "FOLDER", help_heading = "Maps and mesh")]
    pub(super) textures: Option<PathBuf>,
    /// UDIM tile whose maps are taken from the folder, as in 1001 [default: the only one]
    #[arg(long, value_name = "N", help_heading = "Maps and mesh", hide_short_help = true)]
    pub(super) udim: Option<u32>,
    /// Displacement at hard edges and seams of the texture: weld gives a position one displacement,
    /// so that a closed mesh stays closed; keep gives each side its own, which leaves gaps
    /// [default: weld]
    #[arg(long, value_name = "weld|keep", help_heading = "Triangles")]
    pub(super) seams: Option<Seams>,
    /// Leave out the triangles over holes (texels without a value). With --error the outlines are
    /// within a texel, else as fine as the triangles [default: holes are filled]
    #[arg(long, help_heading = "Triangles")]
    pub(super) holes: bool,
    /// Length of the mesh's longest side in millimetres, or with a unit, as in 12cm [default: as
    /// large as the base mesh; a plane as large as the ground if the map's metres are known]
    #[arg(
        long,
        value_name = "MM",
        value_parser = units::millimetres,
        allow_hyphen_values = true,
        help_heading = "Triangles"
    )]
    pub(super) print_size: Option<f64>,
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
    pub(super) quantize: Option<u32>,
    /// Store the triangles of a GLB as strips: 1 to 1.5 indices per triangle instead of three,
    /// files a fifth smaller. Triangles without area join the strips; some programs count them
    #[arg(long, help_heading = "Triangles")]
    pub(super) strips: bool,
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
    pub(super) lods: Option<u32>,
    /// Move the node of a GLB to its map's place on the ground, x east and z south, in metres.
    /// Programs that compute in 32 bits may show it shaking. Without this flag the file's extras
    /// state the place
    #[arg(long, help_heading = "Triangles", hide_short_help = true)]
    pub(super) place: bool,
    /// Up axis of the file: y or z; a GLB always has y up [default: z in STL, y in others]
    #[arg(long, value_name = "y|z", help_heading = "Triangles")]
    pub(super) up: Option<Up>,
    /// Turn the relief inside out: high becomes low
    #[arg(long, help_heading = "Triangles")]
    pub(super) invert: bool,
    #[command(flatten)]
    pub(super) placement: PlacementArguments,
    #[command(flatten)]
    pub(super) reading: HeightArguments,
    /// Print the result as one JSON object
    #[arg(long)]
    pub json: bool,
    /// Memory limit, as in 512MiB; work that needs more is refused [default: 4GiB]
    #[arg(long, value_name = "SIZE", allow_hyphen_values = true)]
    pub(super) max_memory: Option<ByteSize>,
}

/// File format, by the ending of the output's name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    Glb,
    Ply,
    Obj,
    Stl,
}

pub(super) const FORMATS: [(&str, (Format, MeshFormat)); 4] = [
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

impl Arguments {
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
    pub(super) fn inputs(&self) -> Vec<&Path> {
        let mesh = match &self.placement.mesh {
            Some(MeshChoice::File(file)) => Some(file.as_path()),
            _ => None,
        };
        [Some(self.height.as_path()), mesh, self.view.as_deref()].into_iter().flatten().collect()
    }

    /// Returns the memory limit in bytes.
    pub(super) fn limit(&self) -> u64 {
        self.max_memory.map_or(DEFAULT_MAX_BYTES, |size| size.0)
    }
}
