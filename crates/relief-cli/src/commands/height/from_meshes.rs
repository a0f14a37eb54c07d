//! `relief height from-meshes`: computes the height map that displaces a simple mesh onto a
//! detailed one.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Args;
use relief_bake::from_meshes::{
    FromMeshesError, Layer, MeshPair, PairedHeights, heights_from_meshes, normals_from_meshes,
};
use relief_core::mesh::{Mesh, UvProjection};
use relief_core::raycast::RayCaster;
use relief_core::{ByteSize, HeightMap, Watch, Wrap};
use relief_io::{DEFAULT_MAX_BYTES, HeightNote, MeshOptions, read_mesh, read_raw_mesh};
use relief_scene::MeshChoice;
use serde_json::json;

use super::annotated_heights::{AnnotatedHeights, SURVEYED};
use super::output::{Content, Format, NORMAL_SPACE, Output, check_distinct, coded, metadata};
use super::{check_memory, of_unwrapped};
use crate::commands::staged::Staged;
use crate::failure::Failure;
use crate::interrupt::{self, cancelled};
use crate::progress::Progress;
use crate::streams::{Files, Written, tell_written};
use crate::{say, units, values};

/// Bytes per texel: the computed heights and the written texels.
const BYTES_PER_TEXEL: u64 = MeshPair::BYTES_PER_TEXEL + 8;

/// Further bytes per texel of a normal map.
const BYTES_OF_NORMALS: u64 = 24;

/// Arguments of `relief height from-meshes`.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// Simple mesh with texture coordinates, which the map is for: a file, or a built-in mesh
    #[arg(long, value_name = "NAME|FILE")]
    low: MeshChoice,
    /// Detailed mesh in the same place, with or without texture coordinates: a file, or a built-in
    /// mesh
    #[arg(long, value_name = "NAME|FILE")]
    high: MeshChoice,
    /// Columns and rows of the height map, as in 2048x2048
    #[arg(long, value_name = "WxH", value_parser = values::size, allow_hyphen_values = true)]
    size: [u32; 2],
    /// Height map to write
    #[arg(short, long, value_name = "FILE.png|exr")]
    output: PathBuf,
    /// Also write a normal map of the detailed mesh on the simple one. Normals derived from the
    /// heights would count the simple mesh's facets twice
    #[arg(long, value_name = "FILE.png|exr")]
    normals: Option<PathBuf>,
    /// Greatest distance searched from the simple mesh, outward and inward, in metres or with a
    /// unit, as in 2cm [default: a tenth of the diagonal of its box]
    #[arg(long, value_name = "M", value_parser = units::length, allow_hyphen_values = true)]
    cage: Option<f64>,
    /// Layer of the detailed mesh that counts if there are several: nearest to the simple mesh, or
    /// outermost, which is seen from outside
    #[arg(long, value_name = "nearest|outermost", default_value_t)]
    layer: Layer,
    /// Also accept faces that look the other way
    #[arg(long)]
    two_sided: bool,
    /// Continuation of the map beyond its edges: repeat, clamp or mirror
    #[arg(long, value_name = "WRAP", default_value_t)]
    wrap: Wrap,
    /// Leave texels without a value if they lie more than N texels outside the simple mesh's charts
    /// [default: fill all]
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    gutter: Option<u32>,
    /// Format of a height map on standard output, as in -o - --format exr
    #[arg(long, value_enum, value_name = "png|exr", hide_short_help = true)]
    format: Option<Format>,
    /// Print the result as one JSON object
    #[arg(long)]
    pub(super) json: bool,
    /// Memory limit, as in 512MiB; work that needs more is refused [default: 4GiB]
    #[arg(long, value_name = "SIZE", allow_hyphen_values = true)]
    max_memory: Option<ByteSize>,
}

const AFTER_HELP: &str = "Examples:\n  \
    relief height from-meshes --low low.glb --high scan.ply --size 2048x2048 --normals n.png -o h.exr\n  \
    relief height from-meshes --low column.obj --high cylinder --size 512x256 --cage 5cm -o column.exr\n\n\
    Each texel searches along the interpolated normal of the simple mesh, both ways. The file states its \
    scale and bias: `relief render --height h.exr --normal n.png --mesh low.glb` and `relief mesh h.exr \
    --mesh low.glb` show the detailed mesh without further flags.\n\n\
    Of several faces that look outward the nearest counts, so a cage may be wide. With --layer outermost it \
    must be narrower than the gaps between parts. Texels without a hit are counted and filled from their \
    surroundings. The output's ending chooses 32-bit float EXR or 16-bit PNG.";

/// Reads both meshes, computes the heights and writes them.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let started = Instant::now();
    let output = Output::new("--output", &arguments.output, &arguments.inputs())?;
    let normals = arguments.normals_output()?;
    arguments.check(&output)?;
    let Meshes { low, high, caster } = {
        let _reading = Progress::spinner("reading", arguments.json);
        arguments.read()?
    };
    // Until here nothing exists that an interrupted program would leave behind.
    let cancel = interrupt::catch()?;
    let paths: Vec<&Path> = [Some(&output), normals.as_ref()].into_iter().flatten().map(path_of).collect();
    let mut staged = Staged::open(&paths, arguments.json, cancel)?;
    let heights = {
        let bar = Progress::bar("searching", arguments.json);
        let tell = |_: &str, part: f32| bar.show(part);
        let watch = Watch::new(&tell, cancel);
        heights_from_meshes(&low, &caster, &arguments.pair(), &watch)
    };
    let heights = heights.map_err(|error| arguments.of_search(error))?;
    let [bias_m, top_m] = heights.displacement_m();
    let note = HeightNote { tile_m: low.tile_m(), scale_m: top_m - bias_m, bias_m, of_mesh: true };
    let content = arguments.content(&heights, note, &output)?;
    output.write(&mut staged, &content, cancel)?;
    drop(content);
    if let (Some(output), Some(high)) = (&normals, &high) {
        let bar = Progress::bar("normals", arguments.json);
        let tell = |_: &str, part: f32| bar.show(part);
        let watch = Watch::new(&tell, cancel);
        let planes = normals_from_meshes(&low, high, &caster, &arguments.pair(), &watch)
            .map_err(|error| arguments.of_search(error))?;
        output.write(&mut staged, &arguments.normals_content(planes, output)?, cancel)?;
    }
    staged.finish()?;
    let seconds = started.elapsed().as_secs_f64();
    if heights.overlaps > 0 && !arguments.json {
        say::note(format!(
            "{}: {} lie on several triangles at different places; they have the heights of one of them",
            arguments.low,
            share(heights.overlaps, heights.covered)
        ));
    }
    tell_written(arguments.json, |out| Ok(arguments.tell(&heights, note, &output, seconds, out)?))
}

fn path_of(output: &Output) -> &Path {
    &output.path
}

/// Meshes that were read.
struct Meshes {
    low: Mesh,
    /// Detailed mesh with its normals, if a normal map is asked for.
    high: Option<Mesh>,
    caster: RayCaster,
}

impl Arguments {
    /// Returns the files that may be standard streams.
    pub fn files(&mut self) -> Files<'_> {
        let format = self.format.map(Format::ending);
        let heights = Written { flag: "--output", path: &mut self.output, format };
        let normals = self.normals.as_mut().map(|path| Written { flag: "--normals", path, format: None });
        Files { written: [Some(heights), normals].into_iter().flatten().collect(), ..Files::default() }
    }

    /// Returns the output of the normal map.
    fn normals_output(&self) -> Result<Option<Output>, Failure> {
        let Some(path) = &self.normals else { return Ok(None) };
        check_distinct([Some(&self.output), Some(path)])?;
        Output::new("--normals", path, &self.inputs()).map(Some)
    }

    /// Returns the bytes per texel.
    fn bytes_per_texel(&self) -> u64 {
        BYTES_PER_TEXEL + if self.normals.is_some() { BYTES_OF_NORMALS } else { 0 }
    }

    /// Returns the files that are read.
    fn inputs(&self) -> Vec<&Path> {
        let files = [&self.low, &self.high].map(|mesh| match mesh {
            MeshChoice::File(file) => Some(file.as_path()),
            MeshChoice::Builtin(_) => None,
        });
        files.into_iter().flatten().collect()
    }

    fn max_bytes(&self) -> u64 {
        self.max_memory.map_or(DEFAULT_MAX_BYTES, |size| size.0)
    }

    /// Checks the arguments before anything is read.
    fn check(&self, output: &Output) -> Result<(), Failure> {
        let [width, height] = self.size;
        HeightMap::check_size(width, height)
            .map_err(|error| Failure::Usage(format!("--size {width}x{height}: {error}")))?;
        if let Some(cage) = self.cage.filter(|cage| !(1e-12..=1e9).contains(cage)) {
            return Err(Failure::Usage(format!(
                "--cage: {cage} cannot be used: it must be above 0, from 1e-12 to 1e9 metres"
            )));
        }
        if self.gutter.is_some() && output.format == Format::Png {
            return Err(Failure::usage(
                "--gutter leaves texels without a value, which a PNG cannot hold: write an EXR",
            ));
        }
        check_memory(self.size, self.bytes_per_texel(), self.max_bytes())
    }

    fn pair(&self) -> MeshPair {
        let &Self { size, wrap, cage, layer, two_sided, gutter, .. } = self;
        MeshPair { size, wrap, cage_m: cage, layer, two_sided, gutter }
    }

    /// Reads both meshes, within the memory that the map leaves.
    fn read(&self) -> Result<Meshes, Failure> {
        let [width, height] = self.size.map(u64::from);
        let left = self.max_bytes().saturating_sub(width * height * self.bytes_per_texel());
        let proportions = self.size.map(f64::from);
        let low = match &self.low {
            MeshChoice::File(file) => {
                let options = MeshOptions { max_bytes: left, ..MeshOptions::default() };
                read_mesh(file, &options).map_err(of_unwrapped)?.mesh
            }
            MeshChoice::Builtin(builtin) => builtin.build(proportions).map_err(Failure::work)?,
        };
        let enough = |triangles: usize| {
            let needed = triangles as u64 * RayCaster::BYTES_PER_TRIANGLE;
            if needed <= left {
                return Ok(());
            }
            Err(Failure::Work(format!(
                "{}: {triangles} triangles need {} MiB of memory for their BVH, {} MiB are left: raise \
                 --max-memory",
                self.high,
                needed.div_ceil(1 << 20),
                left >> 20
            )))
        };
        let of_mesh = |high: Mesh| {
            enough(high.triangles().len())?;
            let caster = RayCaster::new(&high);
            Ok::<_, Failure>((self.normals.is_some().then_some(high), caster))
        };
        let (high, caster) = match &self.high {
            MeshChoice::File(file) if self.normals.is_some() => {
                // The texture coordinates are not used here, and the file need not have any.
                let projection = Some(UvProjection::Box);
                let options = MeshOptions { max_bytes: left, projection, ..MeshOptions::default() };
                of_mesh(read_mesh(file, &options).map_err(Failure::of_mesh)?.mesh)?
            }
            MeshChoice::File(file) => {
                let raw = read_raw_mesh(file, left).map_err(Failure::of_mesh)?;
                enough(raw.triangles.len())?;
                let positions = raw.triangle_positions();
                let positions =
                    positions.map_err(|error| Failure::Work(format!("{}: {error}", self.high)))?;
                (None, RayCaster::of_corners(positions))
            }
            MeshChoice::Builtin(builtin) => of_mesh(builtin.build(proportions).map_err(Failure::work)?)?,
        };
        Ok(Meshes { low, high, caster })
    }

    /// Turns an error of the search into a failure, with the flag that helps.
    fn of_search(&self, error: FromMeshesError) -> Failure {
        let advice = match &error {
            FromMeshesError::Cancelled(_) => return cancelled(),
            FromMeshesError::NothingFound { behind: 0, .. } => ": --cage searches farther",
            FromMeshesError::NothingFound { .. } => " (--two-sided)",
            FromMeshesError::Outside { .. } => " (--wrap)",
            FromMeshesError::NoTexel => " (--size)",
            _ => "",
        };
        Failure::Work(format!("{} and {}: {error}{advice}", self.low, self.high))
    }

    fn content(
        &self,
        heights: &PairedHeights,
        note: HeightNote,
        output: &Output,
    ) -> Result<Content, Failure> {
        let annotated = AnnotatedHeights {
            size: heights.size,
            texels: heights.texels(),
            wrap: self.wrap,
            note,
            origin: vec![
                ("mesh", self.low.to_string()),
                ("detailed_mesh", self.high.to_string()),
                (
                    "settings",
                    format!("cage={} layer={} two_sided={}", heights.cage_m, self.layer, self.two_sided),
                ),
            ],
            published: Some(SURVEYED),
            guarantee: None,
            more: Vec::new(),
        };
        annotated.content(output)
    }

    fn normals_content(&self, planes: [Vec<f32>; 3], output: &Output) -> Result<Content, Failure> {
        let meshes = vec![("mesh", self.low.to_string()), ("detailed_mesh", self.high.to_string())];
        let metadata = metadata("mesh-normal", meshes, self.size, NORMAL_SPACE, SURVEYED)?;
        let planes = coded(planes, output.format);
        Ok(Content { size: self.size, names: &["R", "G", "B"], planes, bits: 16, metadata })
    }

    fn tell(
        &self,
        heights: &PairedHeights,
        note: HeightNote,
        output: &Output,
        seconds: f64,
        out: &mut dyn Write,
    ) -> io::Result<()> {
        let [width, height] = heights.size;
        let [least, greatest] = heights.range_m;
        let HeightNote { scale_m, bias_m, tile_m, .. } = note;
        let PairedHeights { covered, holes, behind, overlaps, without_area, without_value, .. } = *heights;
        if self.json {
            let about = json!({
                "low": self.low.to_string(), "high": self.high.to_string(),
                "output": output.path.display().to_string(),
                "normals": self.normals.as_ref().map(|path| path.display().to_string()),
                "width": width, "height": height,
                "covered": covered, "holes": holes, "holes_behind": behind, "overlaps": overlaps,
                "triangles_without_area": without_area, "without_value": without_value,
                "least_m": least, "greatest_m": greatest, "mean_abs_m": heights.mean_abs_m,
                "scale_m": scale_m, "bias_m": bias_m, "tile_m": tile_m, "cage_m": heights.cage_m,
                "layer": self.layer.name(), "wrap": self.wrap.name(), "seconds": seconds,
            });
            return writeln!(out, "{about:#}");
        }
        writeln!(out, "{}: {width}x{height} heights in {seconds:.2} s", output.path.display())?;
        let [least, greatest, mean] = [least, greatest, heights.mean_abs_m].map(values::six_digits);
        writeln!(out, "  heights     {least} m to {greatest} m, on the mean {mean} m off the simple mesh")?;
        let [scale, bias] = [scale_m, bias_m].map(values::six_digits);
        let wrap =
            if self.wrap == Wrap::default() { String::new() } else { format!(" --wrap {}", self.wrap) };
        writeln!(out, "  relief      --scale {scale} --bias {bias}, as the file says{wrap}")?;
        let texels = u64::from(width) * u64::from(height);
        writeln!(out, "  covered     {} of the map", share(covered, texels))?;
        if holes > 0 {
            let cage = values::six_digits(heights.cage_m);
            writeln!(
                out,
                "  holes       {} have no hit within {cage} m, filled from their surroundings",
                share(holes, covered)
            )?;
        }
        for (count, what) in [
            (behind, "of these texels hit faces that look the other way (--two-sided)"),
            (without_value, "texels have no value, beyond the gutter"),
            (without_area, "triangles of the simple mesh have no area in the texture"),
        ] {
            if count > 0 {
                writeln!(out, "              {count} {what}")?;
            }
        }
        Ok(())
    }
}

/// Formats `count` texels and their share of `all`.
fn share(count: u64, all: u64) -> String {
    format!("{count} texels ({:.3} %)", 100.0 * count as f64 / all.max(1) as f64)
}
