//! `relief height for-mesh`: adapts a height map to one mesh with unique texture coordinates.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Args;
use relief_core::mesh::Mesh;
use relief_core::{ByteSize, HeightMap};
use relief_io::{DEFAULT_MAX_BYTES, HeightNote, MeshOptions, read_height_file, read_mesh};
use relief_scene::{MeshChoice, Surface};
use serde_json::json;

use super::annotated_heights::AnnotatedHeights;
use super::output::{Content, Format, Output};
use super::{check_memory, of_unwrapped};
use crate::commands::maps::{self, HeightArguments};
use crate::commands::staged::Staged;
use crate::failure::Failure;
use crate::progress::Progress;
use crate::streams::{Files, Written, tell_written};
use crate::{interrupt, say, units, values};

/// Default displacement in metres between heights 0 and 1, the same as in `relief render`.
const DEFAULT_SCALE_M: f64 = 0.05;

/// Bytes per texel that are taken besides the map.
const BYTES_PER_TEXEL: u64 = 24;

/// Arguments of `relief height for-mesh`.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// Height map: PNG, JPEG, EXR, TIFF, GeoTIFF, HDR, PGM or headerless 16-bit raw
    height: PathBuf,
    /// Height map to write
    #[arg(short, long, value_name = "FILE.png|exr")]
    output: PathBuf,
    /// Mesh whose texture coordinates lie from 0 to 1 without overlaps: a file, or a built-in mesh
    #[arg(long, value_name = "NAME|FILE")]
    mesh: MeshChoice,
    /// Add the height of the smooth base (the curved surface of the mesh's normals) above the flat
    /// triangles
    #[arg(long)]
    lift: bool,
    /// Leave texels without a value if they lie more than N texels outside the mesh's charts
    /// [default: keep all]
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    gutter: Option<u32>,
    /// Displacement in metres between heights 0 and 1, or with a unit, as in 5cm [default: true to
    /// the tile where the height map's file states metres, else 0.05]
    #[arg(long, value_name = "M", value_parser = units::length, allow_hyphen_values = true)]
    scale: Option<f64>,
    /// Displacement of height 0 in metres [default: -scale, carved into the surface]
    #[arg(long, value_name = "M", value_parser = units::length, allow_hyphen_values = true)]
    bias: Option<f64>,
    /// Format of a height map on standard output, as in -o - --format exr
    #[arg(long, value_enum, value_name = "png|exr", hide_short_help = true)]
    format: Option<Format>,
    /// Print the result as one JSON object
    #[arg(long)]
    pub(super) json: bool,
    /// Memory limit, as in 512MiB; work that needs more is refused [default: 4GiB]
    #[arg(long, value_name = "SIZE", allow_hyphen_values = true)]
    max_memory: Option<ByteSize>,
    #[command(flatten)]
    reading: HeightArguments,
}

const AFTER_HELP: &str = "Examples:\n  relief height for-mesh bark.png --mesh tree.glb --lift -o tree.exr\n  \
    relief height for-mesh wall.exr --mesh hall.obj --gutter 4 -o hall.exr\n\n\
    With --lift the map shows over flat triangles what the given map shows with `--set surface.lift=1`, up \
    to its resolution. The file states its scale and bias, which are printed, too. Light it by a normal map \
    of the given map (`relief bake --kind normal`), since the mesh's own normals bend with its smooth \
    base.\n\n\
    --fill fills texels without a value; `relief render --holes` shows them as openings. Only EXR holds \
    them.";

/// Reads the map and the mesh, adapts the map and writes it.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let started = Instant::now();
    let Arguments { height: path, lift, gutter, json, .. } = arguments;
    if !lift && gutter.is_none() {
        return Err(Failure::usage("the map would not change: give --lift, --gutter N, or both"));
    }
    let file = match &arguments.mesh {
        MeshChoice::File(file) => Some(file.as_path()),
        MeshChoice::Builtin(_) => None,
    };
    let inputs: Vec<&Path> = [Some(path.as_path()), file].into_iter().flatten().collect();
    let output = Output::new("--output", &arguments.output, &inputs)?;
    if gutter.is_some() && output.format == Format::Png {
        return Err(Failure::usage(
            "--gutter leaves texels without a value, which a PNG cannot hold: write an EXR",
        ));
    }
    let max_bytes = arguments.max_memory.map_or(DEFAULT_MAX_BYTES, |size| size.0);
    let (map, notes, mesh) = {
        let _reading = Progress::spinner("reading", *json);
        let file = read_height_file(path, &arguments.reading.options(arguments.max_memory));
        let file = file.map_err(Failure::of_map)?;
        let notes = maps::of_file(path, &file, &arguments.reading);
        let map = file.map;
        let mesh = match &arguments.mesh {
            MeshChoice::File(file) => {
                let options = MeshOptions { max_bytes, ..MeshOptions::default() };
                read_mesh(file, &options).map_err(of_unwrapped)?.mesh
            }
            MeshChoice::Builtin(builtin) => builtin.build(map.proportions()).map_err(Failure::work)?,
        };
        (map, notes, mesh)
    };
    if !json {
        notes.iter().for_each(say::note);
    }
    check_memory([map.width(), map.height()], BYTES_PER_TEXEL, max_bytes)?;
    let map = arguments.displaced(map, &mesh)?;
    let cancel = interrupt::catch()?;
    let mut staged = Staged::open(&[&output.path], *json, cancel)?;
    let adapted = AdaptedMap::new(&map, &mesh, *lift, *gutter)
        .map_err(|error| Failure::Work(format!("{}: {error}", arguments.mesh)))?;
    let content = adapted.content(&map, &output, &arguments.mesh)?;
    output.write(&mut staged, &content, cancel)?;
    staged.finish()?;
    let seconds = started.elapsed().as_secs_f64();
    tell_written(*json, |out| {
        let HeightNote { tile_m, scale_m, bias_m, .. } = adapted.note;
        let [width, height] = content.size;
        if *json {
            let about = json!({
                "input": path.display().to_string(), "mesh": arguments.mesh.to_string(),
                "output": output.path.display().to_string(),
                "width": width, "height": height, "scale_m": scale_m,
                "bias_m": bias_m, "tile_m": tile_m, "lift_m": adapted.lift_m,
                "without_value": adapted.without_value,
                "seconds": seconds, "notes": maps::as_json(&notes),
            });
            writeln!(out, "{about:#}")?;
            return Ok(());
        }
        writeln!(out, "{}: {width}x{height} heights in {seconds:.2} s", output.path.display())?;
        adapted.print(out)?;
        Ok(())
    })
}

impl Arguments {
    /// Returns the files that may be standard streams.
    pub fn files(&mut self) -> Files<'_> {
        let format = self.format.map(Format::ending);
        let heights = Written { flag: "--output", path: &mut self.output, format };
        Files { read: vec![&mut self.height], written: vec![heights], ..Files::default() }
    }

    /// Returns the map with its displacement on `mesh`.
    fn displaced(&self, map: HeightMap, mesh: &Mesh) -> Result<HeightMap, Failure> {
        if map.stated_displacement_m().is_some() && self.scale.is_none() && self.bias.is_none() {
            return Ok(map);
        }
        let surface = Surface::new(mesh.clone(), map.clone());
        let scale_m = self.scale.or(surface.true_scale_m()).unwrap_or(DEFAULT_SCALE_M);
        map.with_displacement(scale_m, self.bias.unwrap_or(-scale_m)).map_err(Failure::usage)
    }
}

/// Height map adapted to a mesh.
struct AdaptedMap {
    /// Heights from 0 to 1, NaN where there is no value.
    texels: Vec<f32>,
    note: HeightNote,
    /// Least and greatest lift in metres.
    lift_m: [f32; 2],
    without_value: u64,
}

impl AdaptedMap {
    fn new(
        map: &HeightMap,
        mesh: &Mesh,
        is_lifted: bool,
        gutter: Option<u32>,
    ) -> Result<Self, relief_core::mesh::ChartError> {
        let charts = mesh.chart_texels([map.width(), map.height()])?;
        let lifts = if is_lifted { charts.lifts_m(mesh) } else { vec![0.0; map.texels().len()] };
        let kept = gutter.map(|gutter| charts.with_gutter(gutter));
        let width = map.width() as usize;
        let is_kept = |at: usize| {
            let [column, row] = [at % width, at / width].map(|place| place as u32);
            kept.as_ref().is_none_or(|kept| kept.contains(column, row))
        };
        let metres = |at: usize| map.displacement_m(f64::from(map.texels()[at])) + f64::from(lifts[at]);
        let valued = || (0..lifts.len()).filter(|at| is_kept(*at));
        let [low, high] = valued()
            .map(metres)
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], m| [low.min(m), high.max(m)]);
        let span = high - low;
        let texel = |at: usize| {
            let part = if span > 0.0 { (metres(at) - low) / span } else { 0.0 };
            if is_kept(at) { part.clamp(0.0, 1.0) as f32 } else { f32::NAN }
        };
        let texels: Vec<f32> = (0..lifts.len()).map(texel).collect();
        let note = HeightNote { tile_m: mesh.tile_m(), scale_m: span.max(0.0), bias_m: low, of_mesh: true };
        let lift_m = valued()
            .map(|at| lifts[at])
            .fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], m| [low.min(m), high.max(m)]);
        let without_value = (lifts.len() - valued().count()) as u64;
        Ok(Self { texels, note, lift_m, without_value })
    }

    fn content(&self, map: &HeightMap, output: &Output, mesh: &MeshChoice) -> Result<Content, Failure> {
        let annotated = AnnotatedHeights {
            size: [map.width(), map.height()],
            texels: self.texels.clone(),
            wrap: map.wrap(),
            note: self.note,
            origin: vec![("mesh", mesh.to_string()), ("source", map.heights_hash().to_string())],
            published: None,
            guarantee: None,
            more: Vec::new(),
        };
        annotated.content(output)
    }

    fn print(&self, out: &mut impl Write) -> io::Result<()> {
        let HeightNote { scale_m, bias_m, .. } = self.note;
        let [scale, bias] = [scale_m, bias_m].map(values::six_digits);
        writeln!(out, "  relief      --scale {scale} --bias {bias}")?;
        let [low, high] = self.lift_m.map(|lift| values::six_digits(f64::from(lift)));
        writeln!(out, "  lift        {low} m to {high} m")?;
        if self.without_value > 0 {
            writeln!(out, "  gutter      {} texels have no value", self.without_value)?;
        }
        Ok(())
    }
}
