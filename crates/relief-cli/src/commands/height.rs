//! `relief height`: makes height maps from normal maps, photographs, pairs of meshes, depth objects
//! and formulas, for a mesh, and with slopes instead of steps.

mod annotated_heights;
mod deband;
mod for_mesh;
mod from_meshes;
mod from_normals;
mod from_photos;
mod from_shading;
mod from_view;
mod lights;
mod output;
mod procedure;

use clap::{Args, Subcommand};
use relief_bake::from_normals::{FromNormalsError, IntegratedHeights, Integration};
use relief_bake::photometric::PhotometricError;
use relief_core::{ByteSize, Wrap};
use relief_io::{DEFAULT_MAX_BYTES, HeightNote, ReadError};
use serde_json::{Value, json};

use self::annotated_heights::{AnnotatedHeights, SURVEYED};
use self::output::{Content, Format, Output};
use crate::failure::Failure;
use crate::interrupt::cancelled;
use crate::streams::Files;
use crate::{units, values};

/// Arguments of `relief height`.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    #[command(subcommand)]
    origin: Origin,
}

#[derive(Subcommand)]
enum Origin {
    /// Integrate a tangent-space normal map into a height map
    FromNormals(Box<from_normals::Arguments>),
    /// Make a height map from photographs of one view under at least three known lights
    FromPhotos(Box<from_photos::Arguments>),
    /// Guess a height map from the shading of one photograph under a known light
    FromShading(Box<from_shading::Arguments>),
    /// Compute the heights that displace a simple mesh onto a detailed one
    FromMeshes(Box<from_meshes::Arguments>),
    /// Convert one image of a depth object into a height map
    FromView(Box<from_view::Arguments>),
    /// Generate a height map from a formula: waves, fractal ground or bumps, one or an animation
    Procedure(Box<procedure::Arguments>),
    /// Adapt a height map to one mesh: add its smooth base, or leave out texels that it does not
    /// show
    ForMesh(Box<for_mesh::Arguments>),
    /// Turn the steps of a height map of few levels into slopes
    Deband(Box<deband::Arguments>),
}

const AFTER_HELP: &str = "Examples:\n  relief height from-normals rock_normal.png -o rock.exr\n  \
    relief height from-normals wall_dx.png --green down --wrap clamp --texel-size 0.002 -o wall.png\n  \
    relief height from-photos lights.toml -o coin.exr --normals normal.png --albedo albedo.png\n  \
    relief height from-shading photo.png --light -1,1,1 -o photo.exr\n  \
    relief height from-meshes --low rock_low.glb --high rock_scan.ply --size 2048x2048 -o rock.exr\n  \
    relief height from-view spot/object.toml --view 5 -o front.exr\n  \
    relief height procedure waves --frames 0..47 -o waves_%04d.png\n  \
    relief height deband wall.png -o wall.exr\n\n\
    `relief height from-photos --help` shows a file of lights.";

/// Description of the written files, at the end of several helps.
const WRITTEN: &str = "The height map has texels from 0 (lowest) to 1: 16-bit PNG or 32-bit float EXR, by \
    the output's ending. Its lengths in metres are printed and stored in the file: `relief inspect` shows \
    them, `relief bake` uses them. All files take their names at the end; Ctrl-C changes nothing (exit code \
    1).";

/// Flags of `from-normals` and `from-photos`.
#[derive(Args)]
struct Common {
    /// Continuation of the map beyond its edges: repeat, clamp or mirror [default: see below]
    #[arg(long, value_name = "WRAP", help_heading = "Integration")]
    wrap: Option<Wrap>,
    /// Texel size along u and v in metres, one number or two, or with a unit, as in 0.5mm [default:
    /// square texels, the map 1 m wide]
    #[arg(
        long,
        value_name = "U[,V]",
        value_parser = units::one_or_two_lengths,
        allow_hyphen_values = true,
        help_heading = "Integration"
    )]
    texel_size: Option<[f64; 2]>,
    /// Damping of waves of about two texels, 0 to 1. Central differences hardly see such waves, so
    /// noise grows there [default: 0.1; 0 for normal maps of `relief bake`]
    #[arg(long, value_name = "PART", allow_hyphen_values = true, help_heading = "Integration")]
    damping: Option<f64>,
    /// Steepest slope, in metres up per metre along; steeper normals are reduced to it
    #[arg(
        long,
        value_name = "SLOPE",
        default_value = "32",
        allow_hyphen_values = true,
        help_heading = "Integration"
    )]
    steepest: f64,
    /// Format of a height map on standard output, as in -o - --format exr
    #[arg(long, value_enum, value_name = "png|exr", hide_short_help = true)]
    format: Option<Format>,
    /// Print the result as one JSON object
    #[arg(long)]
    json: bool,
    /// Memory limit, as in 512MiB; work that needs more is refused [default: 4GiB]
    #[arg(long, value_name = "SIZE", allow_hyphen_values = true)]
    max_memory: Option<ByteSize>,
}

impl Common {
    fn max_bytes(&self) -> u64 {
        self.max_memory.map_or(DEFAULT_MAX_BYTES, |size| size.0)
    }

    /// Checks the numbers before any file is read.
    fn check(&self) -> Result<(), Failure> {
        let bad = |flag: &str, value: f64, must: &str| {
            Err(Failure::Usage(format!("--{flag}: {value} cannot be used: it must be {must}")))
        };
        if let Some(&side) = self.texel_size.iter().flatten().find(|side| !(1e-12..=1e9).contains(*side)) {
            return bad("texel-size", side, "from 1e-12 to 1e9 metres");
        }
        if let Some(damping) = self.damping.filter(|damping| !(0.0..=1.0).contains(damping)) {
            return bad("damping", damping, "from 0 to 1");
        }
        if !(self.steepest > 0.0 && self.steepest <= 1e6) {
            return bad("steepest", self.steepest, "above 0 and at most 1e6");
        }
        Ok(())
    }

    /// Checks that `size` texels of `bytes_per_texel` each fit into the memory limit.
    fn check_memory(&self, size: [u32; 2], bytes_per_texel: u64) -> Result<(), Failure> {
        check_memory(size, bytes_per_texel, self.max_bytes())
    }
}

/// Checks that `width` x `height` texels of `bytes_per_texel` each fit into `limit` bytes.
fn check_memory([width, height]: [u32; 2], bytes_per_texel: u64, limit: u64) -> Result<(), Failure> {
    let needed = (u64::from(width) * u64::from(height)).saturating_mul(bytes_per_texel);
    if needed <= limit {
        return Ok(());
    }
    Err(Failure::Work(format!(
        "{width}x{height} texels need {} MiB of memory to become heights, more than the {} MiB allowed: make \
         the pictures smaller or raise --max-memory",
        needed.div_ceil(1 << 20),
        limit >> 20
    )))
}

/// Turns an error of reading a mesh that needs unique texture coordinates into a failure. No flag
/// makes such coordinates.
fn of_unwrapped(error: ReadError) -> Failure {
    if error.problem.is_of_texture_coordinates() {
        return Failure::Work(format!(
            "{error}: unwrap the mesh in a modelling program, so that each place has its own"
        ));
    }
    Failure::of_mesh(error)
}

impl Arguments {
    /// Returns the files that may be standard streams.
    pub fn files(&mut self) -> Files<'_> {
        match &mut self.origin {
            Origin::FromNormals(arguments) => arguments.files(),
            Origin::FromPhotos(arguments) => arguments.files(),
            Origin::FromShading(arguments) => arguments.files(),
            Origin::FromMeshes(arguments) => arguments.files(),
            Origin::FromView(arguments) => arguments.files(),
            Origin::Procedure(arguments) => arguments.files(),
            Origin::ForMesh(arguments) => arguments.files(),
            Origin::Deband(arguments) => arguments.files(),
        }
    }

    /// Whether the answer is JSON.
    pub fn json(&self) -> bool {
        match &self.origin {
            Origin::FromNormals(arguments) => arguments.common.json,
            Origin::FromPhotos(arguments) => arguments.common.json,
            Origin::FromShading(arguments) => arguments.json,
            Origin::FromMeshes(arguments) => arguments.json,
            Origin::FromView(arguments) => arguments.json,
            Origin::Procedure(arguments) => arguments.json,
            Origin::ForMesh(arguments) => arguments.json,
            Origin::Deband(arguments) => arguments.json,
        }
    }
}

/// Reads, integrates and writes.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    match &arguments.origin {
        Origin::FromNormals(arguments) => from_normals::run(arguments),
        Origin::FromPhotos(arguments) => from_photos::run(arguments),
        Origin::FromShading(arguments) => from_shading::run(arguments),
        Origin::FromMeshes(arguments) => from_meshes::run(arguments),
        Origin::FromView(arguments) => from_view::run(arguments),
        Origin::Procedure(arguments) => procedure::run(arguments),
        Origin::ForMesh(arguments) => for_mesh::run(arguments),
        Origin::Deband(arguments) => deband::run(arguments),
    }
}

fn of_integration(error: FromNormalsError) -> Failure {
    match error {
        FromNormalsError::Cancelled(_) => cancelled(),
        other => Failure::work(other),
    }
}

fn of_photos(error: PhotometricError) -> Failure {
    match error {
        PhotometricError::Cancelled(_) => cancelled(),
        other => Failure::work(other),
    }
}

/// Heights and their metadata on the way to a file.
struct Relief {
    content: Content,
    note: HeightNote,
    how: Integration,
    /// Share of the slopes that fits no relief, root mean square; none of a level map.
    misfit: Option<f64>,
}

impl Relief {
    /// Creates the relief of integrated heights. `more` is metadata beside the entries of every
    /// height map. `steepness` is the root mean square of the slopes that the heights were made
    /// from. Texels that are not `known` get no height.
    fn new(
        mut heights: IntegratedHeights,
        known: Option<&[bool]>,
        steepness: f64,
        how: Integration,
        output: &Output,
        more: Vec<(&'static str, String)>,
    ) -> Result<Self, Failure> {
        let misfit = (steepness > 0.0).then(|| heights.misfit / steepness);
        let [width, height] = heights.size;
        if let Some(known) = known {
            // The range covers the known heights alone.
            let seen = heights.heights_m.iter().zip(known).filter(|(_, known)| **known);
            let [low, high] =
                seen.fold([f32::MAX, f32::MIN], |[low, high], (&h, _)| [low.min(h), high.max(h)]);
            heights.heights_m.iter_mut().for_each(|h| *h = h.max(low).min(high));
        }
        let map = heights.to_map(how.wrap).map_err(Failure::work)?;
        drop(heights);
        let mut texels = map.texels().to_vec();
        let known = known.into_iter().flatten();
        texels.iter_mut().zip(known).filter(|(_, known)| !**known).for_each(|(texel, _)| *texel = f32::NAN);
        let tile_m = [how.texel_m[0] * f64::from(width), how.texel_m[1] * f64::from(height)];
        let note = HeightNote { tile_m, scale_m: map.scale_m(), bias_m: map.bias_m(), of_mesh: false };
        let Integration { damping, steepest, .. } = how;
        let guarantee = if damping == 0.0 {
            "least squares: no other heights have slopes nearer to those given"
        } else {
            "least squares of the slopes, and of waves of about two texels by the damping"
        };
        let annotated = AnnotatedHeights {
            size: [width, height],
            texels,
            wrap: how.wrap,
            note,
            origin: vec![("settings", format!("damping={damping} steepest={steepest}"))],
            published: Some(SURVEYED),
            guarantee: Some(guarantee),
            more,
        };
        let content = annotated.content(output)?;
        Ok(Self { content, note, how, misfit })
    }

    /// Returns the entries that both commands' JSON answers share.
    fn as_json(&self, output: &Output, seconds: f64) -> Value {
        let [width, height] = self.content.size;
        json!({
            "output": output.path.display().to_string(), "width": width,
            "height": height, "scale_m": self.note.scale_m,
            "bias_m": self.note.bias_m, "tile_m": self.note.tile_m, "texel_m": self.how.texel_m,
            "wrap": self.how.wrap.name(), "damping": self.how.damping,
            "misfit": self.misfit, "seconds": seconds,
        })
    }

    /// Prints the lines that both commands' answers share.
    fn print(&self, out: &mut impl std::io::Write, output: &Output, seconds: f64) -> std::io::Result<()> {
        let HeightNote { tile_m: [tile_u, tile_v], scale_m, bias_m, .. } = self.note;
        let [width, height] = self.content.size;
        writeln!(out, "{}: {width}x{height} heights in {seconds:.2} s", output.path.display())?;
        if scale_m == 0.0 {
            writeln!(out, "  relief      none: all normals are alike, and every texel is 0")?;
        } else {
            let [zero, one, scale] = [bias_m, bias_m + scale_m, scale_m].map(values::six_digits);
            writeln!(out, "  relief      0 stands for {zero} m, 1 for {one} m: --scale {scale}")?;
        }
        let [tile_u, tile_v] = [tile_u, tile_v].map(values::six_digits);
        writeln!(out, "  tile        {tile_u} m x {tile_v} m, --wrap {}", self.how.wrap)?;
        if let Some(misfit) = self.misfit {
            writeln!(
                out,
                "  misfit      {:.2} % of the slopes fit no relief (root mean square)",
                100.0 * misfit
            )?;
        }
        Ok(())
    }
}
