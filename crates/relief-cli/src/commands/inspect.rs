//! `relief inspect`: reports the contents of a height map, a mesh or a volume.

mod mesh;
mod textures;
mod volume;

use std::collections::BTreeSet;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use relief_core::ByteSize;
use relief_core::mesh::UvProjection;
use relief_io::{
    Convention, CoordinateSystem, DEFAULT_MAX_BYTES, Detection, Elevation, Georeference, GreenSign, Ground,
    HISTOGRAM_BINS, HeightNote, HeightOptions, MeshFormat, SourceInfo, Tiling, UnitOrigin, Up, Values,
    detect, guess_by_name, inspect, read_height, read_normal_map,
};
use serde_json::{Value, json};

use super::lengths;
use super::maps::{self, By, FileArguments, Note};
use crate::failure::Failure;
use crate::file_kind::FileKind;
use crate::progress::Progress;
use crate::streams::{Files, answer};
use crate::{say, values};

/// Arguments of `relief inspect`.
#[derive(Args)]
#[command(after_help = "Examples:\n  relief inspect dem.tif\n  \
    relief inspect rock.png --normal rock_normal.png    # height or depth, +y or -y\n  \
    relief inspect tree.obj --json\n  \
    relief inspect sponge.ktx2    # a volume\n  \
    relief inspect Bricks090    # a folder of textures")]
pub struct Arguments {
    /// Height map, mesh by its ending (.gltf, .glb, .obj, .ply, .stl), volume (.ktx2), or folder of
    /// textures; - for standard input
    file: PathBuf,
    /// Normal map of the height map. How the two fit tells height from depth and +y from -y
    #[arg(long, value_name = "FILE")]
    normal: Option<PathBuf>,
    /// For a mesh, replace its texture coordinates by a projection: box, cylinder or sphere
    #[arg(long, value_name = "NAME")]
    project: Option<UvProjection>,
    /// For a mesh, the axis of its file that points up: y or z [default: z in STL, y in others;
    /// files of `relief mesh` state it]
    #[arg(long, value_name = "y|z")]
    mesh_up: Option<Up>,
    /// For a folder of textures, UDIM tile whose textures are listed, as in 1001 [default: the only
    /// one]
    #[arg(long, value_name = "N")]
    udim: Option<u32>,
    /// Print the result as one JSON object
    #[arg(long)]
    pub json: bool,
    /// Memory limit, as in 512MiB; work that needs more is refused [default: 4GiB]
    #[arg(long, value_name = "SIZE", allow_hyphen_values = true)]
    max_memory: Option<ByteSize>,
    #[command(flatten)]
    reading: FileArguments,
}

impl Arguments {
    /// Returns the files that may be standard input.
    pub fn files(&mut self) -> Files<'_> {
        Files { read: [&mut self.file].into_iter().chain(&mut self.normal).collect(), ..Files::default() }
    }

    /// Refuses flags for height maps, where the file is something else.
    fn refuse_flags_of_maps(&self) -> Result<(), Failure> {
        let flag = self.normal.as_ref().map(|_| "--normal").or(self.reading.flag_of_heights());
        match flag {
            Some(flag) => Err(Failure::Usage(format!("{flag} is for height maps: leave it out"))),
            None => Ok(()),
        }
    }
}

/// Reads and prints.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    if MeshFormat::by_name(&arguments.file).is_some() {
        return mesh::run(arguments);
    }
    if arguments.project.is_some() {
        return Err(Failure::usage("--project is for meshes: leave it out"));
    }
    if arguments.mesh_up.is_some() {
        return Err(Failure::usage("--mesh-up is for meshes: leave it out"));
    }
    if arguments.file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("ktx2")) {
        return volume::run(arguments);
    }
    let is_textures = arguments.file.is_dir() && FileKind::of(&arguments.file)? == FileKind::Textures;
    if is_textures {
        return textures::run(arguments);
    }
    if arguments.udim.is_some() {
        return Err(Failure::usage("--udim is for folders of textures: leave it out"));
    }
    let is_description = || arguments.file.extension().is_some_and(|ending| ending == "toml");
    if arguments.file.is_dir() || (arguments.reading.raw.is_none() && is_description()) {
        let what = match FileKind::of(&arguments.file)? {
            FileKind::Object => "a depth object",
            _ => "a scene file",
        };
        let name = arguments.file.display();
        return Err(Failure::Work(format!(
            "{name}: this is {what}, not a height map or mesh: `relief render` renders it"
        )));
    }
    let options = HeightOptions {
        channel: arguments.reading.channel.clone(),
        unit: arguments.reading.unit,
        raw: arguments.reading.raw,
        nodata: arguments.reading.nodata,
        fill: arguments.reading.fill(),
        max_bytes: arguments.max_memory.map_or(DEFAULT_MAX_BYTES, |size| size.0),
        ..HeightOptions::default()
    };
    let (info, detection) = {
        let _reading = Progress::spinner("reading", arguments.json);
        let info = inspect(&arguments.file, &options).map_err(Failure::of_map)?;
        (info, arguments.normal.as_deref().map(|path| detection(arguments, &options, path)).transpose()?)
    };
    let mut notes: BTreeSet<Note> = info.notes.iter().map(|note| By::Flags.note(note)).collect();
    if let Some(normal) = &arguments.normal {
        let of_normals = maps::of_picture(normal);
        if !arguments.json {
            of_normals.iter().for_each(say::note);
        }
        notes.extend(of_normals);
    }
    answer(|out| {
        if arguments.json {
            writeln!(out, "{:#}", as_json(arguments, &info, detection.as_ref(), &notes))?;
            return Ok(());
        }
        Ok(print(out, arguments, &info, detection.as_ref())?)
    })
}

/// Compares the height map, read as stored, with its normal map.
fn detection(arguments: &Arguments, options: &HeightOptions, normal: &Path) -> Result<Detection, Failure> {
    let height = read_height(&arguments.file, options).map_err(Failure::of_map)?;
    let left = options.max_bytes.saturating_sub(4 * u64::from(height.width()) * u64::from(height.height()));
    let normals = read_normal_map(normal, GreenSign::PlusY, left).map_err(Failure::of_picture)?;
    Ok(detect(&height, &normals))
}

/// The most channels that are listed one by one.
const MOST_CHANNELS: usize = 24;

fn print(
    out: &mut impl Write,
    arguments: &Arguments,
    info: &SourceInfo,
    detection: Option<&Detection>,
) -> io::Result<()> {
    writeln!(
        out,
        "{}: {}, {}x{} texels",
        arguments.file.display(),
        info.format.name(),
        info.width,
        info.height
    )?;
    for channel in info.channels.iter().take(MOST_CHANNELS) {
        writeln!(out, "  channel     {} ({})", channel.name, channel.sample)?;
    }
    if let Some(more) = info.channels.len().checked_sub(MOST_CHANNELS).filter(|&more| more > 0) {
        writeln!(out, "  channel     and {more} more")?;
    }
    if let Some(georeference) = &info.georeference {
        writeln!(out, "  ground      {}", ground_text(georeference))?;
        if let Some(turned) = turned_over(georeference) {
            writeln!(
                out,
                "  turned      {turned} are turned over, so that north is at the top and east to the right"
            )?;
        }
    }
    if let Some(number) = info.orientation {
        writeln!(out, "  turned      by the orientation tag {number} of the file")?;
    }
    if let Some([u, v]) = info.texel_size_m {
        writeln!(out, "  texel       {u:.6} m x {v:.6} m")?;
    }
    if let Some(HeightNote { scale_m, bias_m, .. }) = info.note {
        let [zero, one, scale] = [bias_m, bias_m + scale_m, scale_m].map(values::six_digits);
        writeln!(out, "  relief      0 stands for {zero} m, 1 for {one} m: --scale {scale}")?;
    }
    if let Some(nodata) = info.nodata_value {
        writeln!(out, "  nodata      {nodata}")?;
    }
    match &info.values {
        Some(values) => print_values(out, info, values)?,
        None => writeln!(out, "  Several channels may hold the height: choose one with --channel.")?,
    }
    for note in lengths::notes(&ground_of(info)) {
        writeln!(out, "  units       {note}")?;
    }
    for note in &info.notes {
        writeln!(out, "  note        {}{}", note.remark.text, By::Flags.advice(note))?;
    }
    if let (None, Some(guess)) = (detection, guess_by_name(&arguments.file)) {
        let (kind, hint) = match guess.convention {
            Convention::Height => ("height", ""),
            Convention::Depth => ("depth", ": if so, read it with --depth"),
        };
        let percent = 100.0 * guess.confidence;
        writeln!(out, "  convention  {kind} by its name, confidence {percent:.0} %{hint}")?;
    }
    if let Some(detection) = detection {
        let percent = |confidence: f64| (confidence * 100.0).round();
        let (kind, hint) = match detection.convention {
            Convention::Height => ("height", ""),
            Convention::Depth => ("depth", ": read it with --depth"),
        };
        writeln!(
            out,
            "  convention  {kind}, confidence {} %{hint}",
            percent(detection.convention_confidence)
        )?;
        let sign = green_name(detection.green);
        writeln!(out, "  green       {sign}, confidence {} %", percent(detection.green_confidence))?;
    }
    Ok(())
}

/// Describes the coordinate system, with the reason if the texel size is not known.
fn ground_text(georeference: &Georeference) -> String {
    let mut text = format!("{} coordinates", georeference.system.name());
    if let Some(epsg) = georeference.epsg {
        text += &format!(" (EPSG:{epsg})");
    }
    let metres = georeference.metres_per_unit.filter(|_| georeference.system != CoordinateSystem::Geographic);
    if let Some(unit) = &georeference.unit {
        let per_unit = metres.filter(|_| georeference.system == CoordinateSystem::Projected);
        text += &format!(" in {}", lengths::with_metres(unit, per_unit.map(|[x, _]| x)));
        text += &match (&georeference.unit_origin, lengths::by(&georeference.unit_origin)) {
            (UnitOrigin::Shared, _) => ", the unit of the heights".to_owned(),
            (_, by) if by.is_empty() => by,
            (_, by) => format!(" ({by})"),
        };
    }
    if let Some(file) = &georeference.grid_file {
        text += &format!(", placed by {file}");
    }
    if let Err(reason) = &georeference.texel_size_m {
        text += &format!("; the texel size is not known: {reason}");
    }
    text
}

/// Returns the ground data of the file's header.
fn ground_of(info: &SourceInfo) -> Ground {
    let elevation = info.values.as_ref().filter(|_| info.note.is_none());
    let [width, height] = [info.width, info.height].map(f64::from);
    Ground {
        size: [info.width, info.height],
        tile_m: info.texel_size_m.map(|[u, v]| [u * width, v * height]),
        georeference: info.georeference.clone(),
        elevation: elevation.and_then(|values| values.elevation.clone()),
        format: info.format,
    }
}

/// Returns why values may not be metres of ground, if so. Metadata that Relief wrote are not
/// doubted.
fn doubt(info: &SourceInfo, elevation: &Elevation, range: Option<[f64; 2]>) -> Option<String> {
    let is_ground = info.note.is_none();
    lengths::doubt(elevation, range.filter(|_| is_ground), [info.width, info.height], info.texel_size_m)
}

/// Names the axes of the file that are turned over.
fn turned_over(georeference: &Georeference) -> Option<&'static str> {
    match georeference.turned_over {
        [false, false] => None,
        [true, false] => Some("columns"),
        [false, true] => Some("rows"),
        [true, true] => Some("columns and rows"),
    }
}

/// Describes how values become metres, with the least and the greatest in metres.
fn elevation_text(elevation: &Elevation, range: Option<[f64; 2]>) -> String {
    let Elevation { scale, offset, .. } = elevation;
    let value = if (*scale, *offset) == (1.0, 0.0) {
        "value".to_owned()
    } else {
        format!("value * {scale} + {offset}")
    };
    let by = match (&elevation.origin, lengths::by(&elevation.origin)) {
        (UnitOrigin::Shared, _) => ", the unit of the ground".to_owned(),
        (UnitOrigin::Assumed, by) => format!(", {by}"),
        (_, by) if by.is_empty() => by,
        (_, by) => format!(" ({by})"),
    };
    let downward = if elevation.downward { ", counted downward" } else { "" };
    let text = match (&elevation.unit, elevation.metres_per_unit) {
        (None, _) => {
            return format!("{value} in the ground's unit, as none is named{downward}: metres are not known");
        }
        (Some(unit), None) => {
            return format!(
                "{value} in {unit}{by}, which is no known length{downward}: metres are not known"
            );
        }
        (Some(unit), metres) => format!("{value} in {}{by}{downward}", lengths::with_metres(unit, metres)),
    };
    match range.and_then(|range| elevation.metres(range)) {
        Some([a, b]) => format!("{text}: {} m to {} m", a.min(b), a.max(b)),
        None => text,
    }
}

fn print_values(out: &mut impl Write, info: &SourceInfo, values: &Values) -> io::Result<()> {
    writeln!(out, "  height from {}", values.channel)?;
    if let Some([least, greatest]) = values.range {
        writeln!(out, "  range       {least} to {greatest}, {} levels used", values.levels)?;
    }
    if let Some(elevation) = &values.elevation {
        writeln!(out, "  elevation   {}", elevation_text(elevation, values.range))?;
        if let Some(doubt) = doubt(info, elevation, values.range) {
            writeln!(out, "  doubtful    {doubt}")?;
        }
        if elevation.downward {
            writeln!(out, "  convention  depth, by its vertical system")?;
        }
    }
    if let Some([zero, one]) = values.normalised_range {
        writeln!(out, "  heights     0 stands for {zero}, 1 for {one}")?;
    }
    if values.not_finite + values.nodata + values.masked > 0 {
        writeln!(
            out,
            "  missing     {} nodata, {} not finite, {} masked: --fill fills them",
            values.nodata, values.not_finite, values.masked
        )?;
    }
    writeln!(out, "  histogram   {}", bars(&values.histogram))?;
    if let Some(Tiling { seam, tiles }) = &values.tiling {
        for ((axis, seam), tiles) in ["u", "v"].iter().zip(seam).zip(tiles) {
            let answer = if *tiles { "tiles" } else { "does not tile" };
            writeln!(out, "  along {axis}     {answer} (step at the seam {seam:.2} times the steps inside)")?;
        }
    }
    Ok(())
}

/// A histogram in one line; the tallest bar is the fullest bin, and no filled bin is blank.
fn bars(histogram: &[u64; HISTOGRAM_BINS]) -> String {
    const BARS: [char; 8] = ['▁', '▂', '▃', '▄', '▅', '▆', '▇', '█'];
    let most = histogram.iter().copied().max().unwrap_or(0).max(1);
    histogram
        .iter()
        .map(|&count| match count {
            0 => ' ',
            _ => BARS[((count as f64 / most as f64) * 7.0).round() as usize],
        })
        .collect()
}

fn green_name(green: GreenSign) -> &'static str {
    match green {
        GreenSign::PlusY => "+y",
        GreenSign::MinusY => "-y",
    }
}

fn as_json(
    arguments: &Arguments,
    info: &SourceInfo,
    detection: Option<&Detection>,
    notes: &BTreeSet<Note>,
) -> Value {
    let channels: Vec<Value> = info
        .channels
        .iter()
        .map(|channel| json!({ "name": channel.name, "sample": channel.sample.to_string() }))
        .collect();
    let values = info.values.as_ref().map(|values| {
        let tiling =
            values.tiling.as_ref().map(|tiling| json!({ "seam": tiling.seam, "tiles": tiling.tiles }));
        let elevation = values.elevation.as_ref().map(|elevation| {
            let range_m = values.range.and_then(|range| elevation.metres(range));
            json!({
                "unit": elevation.unit, "metres_per_unit": elevation.metres_per_unit,
                "scale": elevation.scale,
                "offset": elevation.offset, "downward": elevation.downward,
                "unit_by": elevation.origin.to_string(),
                "range_m": range_m.map(|[a, b]| [a.min(b), a.max(b)]),
                "doubt": doubt(info, elevation, values.range),
            })
        });
        json!({
            "channel": values.channel, "range": values.range, "normalised_range": values.normalised_range,
            "levels": values.levels, "histogram": values.histogram.to_vec(), "nodata": values.nodata,
            "not_finite": values.not_finite, "masked": values.masked,
            "elevation": elevation, "tiling": tiling,
        })
    });
    let georeference = info.georeference.as_ref().map(|found| {
        let [columns, rows] = found.turned_over;
        json!({
            "system": found.system.name(), "epsg": found.epsg,
            "turned_over": { "columns": columns, "rows": rows },
            "unit": found.unit, "unit_by": found.unit_origin.to_string(), "placed_by": found.grid_file,
            "size_unknown": found.texel_size_m.as_ref().err(),
        })
    });
    let guess = guess_by_name(&arguments.file).map(|guess| {
        let convention = if guess.convention == Convention::Depth { "depth" } else { "height" };
        json!({ "convention": convention, "by": "name", "confidence": guess.confidence })
    });
    let detection = detection.map(|found| {
        json!({
            "convention": if found.convention == Convention::Depth { "depth" } else { "height" },
            "convention_confidence": found.convention_confidence,
            "green": green_name(found.green), "green_confidence": found.green_confidence,
        })
    });
    json!({
        "input": arguments.file.display().to_string(),
        "format": info.format.name(), "width": info.width, "height": info.height,
        "orientation": info.orientation.unwrap_or(1),
        "channels": channels, "nodata": info.nodata_value, "texel_m": info.texel_size_m,
        "georeference": georeference, "scale_m": info.note.map(|note| note.scale_m),
        "bias_m": info.note.map(|note| note.bias_m), "values": values,
        "detection": detection, "guess": guess,
        "notes": maps::as_json(notes),
    })
}
