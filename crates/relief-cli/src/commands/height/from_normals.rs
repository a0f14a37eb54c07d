//! `relief height from-normals`: a normal map to a height map.

use std::io::{self, Write};
use std::path::PathBuf;
use std::time::Instant;

use clap::{Args, ValueEnum};
use relief_bake::Progress as BakeProgress;
use relief_bake::from_normals::{
    GreenFit, Integration, NormalFaults, NormalSlopes, heights_from_either_green, heights_from_slopes,
};
use relief_bake::kind::normal::Axes;
use relief_io::{Metadata, NormalVectors, read_metadata, read_normal_vectors};
use serde_json::{Value, json};

use super::output::{Format, Output};
use super::{Common, Relief, WRITTEN, of_integration};
use crate::commands::staged::Staged;
use crate::failure::Failure;
use crate::interrupt;
use crate::progress::Progress;
use crate::streams::{Files, Written, answer};

/// Bytes a texel that reading and integrating take at their peak.
const BYTES_PER_TEXEL: u64 = 32;

/// The damping for normals that come from elsewhere: those that `relief bake` made are inverted as they were
/// made.
const DEFAULT_DAMPING: f64 = 0.1;

/// What `relief height from-normals` is given.
#[derive(Args)]
#[command(after_help = after_help())]
pub struct Arguments {
    /// Tangent-space normal map: PNG, JPEG, EXR, TIFF, HDR or PGM with red, green and blue, or EXR with x, y
    /// and z
    normals: PathBuf,
    /// Height map to write
    #[arg(short, long, value_name = "FILE.png|exr")]
    output: PathBuf,
    /// Where green points: up in the picture (+y: OpenGL, glTF, Blender), down (-y: DirectX, Unreal), or as
    /// the normals fit a relief better
    #[arg(long, value_enum, value_name = "up|down|auto", default_value = "auto", allow_hyphen_values = true)]
    green: Green,
    /// Fill texels without a direction (NaN, or shorter than 0.1) from their surroundings
    /// [default: they are an error]
    #[arg(long)]
    fill: bool,
    #[command(flatten)]
    pub(super) common: Common,
}

fn after_help() -> String {
    format!(
        "Example:\n  relief height from-normals rock_normal.png -o rock.exr\n  relief bake rock.exr --kind cone,horizon -o .\n\n\
         A file that `relief bake --kind normal` wrote says its own wrap, tile and green; for others --wrap is repeat, and \
         --damping 0.1. {WRITTEN}\n\n\
         Normals do not say which way is out: where a relief comes back turned inside out, red and green are both the other \
         way, and the height map is one of depth (--depth in other commands)."
    )
}

/// Where green points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Green {
    #[value(alias = "+y")]
    Up,
    #[value(alias = "-y")]
    Down,
    Auto,
}

/// What the axes of the normals are, and who says so.
enum Known {
    /// The command line or the file.
    Axes(Axes, &'static str),
    /// Nobody.
    Unknown,
}

/// Reads, integrates and writes.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let started = Instant::now();
    let Arguments { normals: path, common, .. } = arguments;
    common.check()?;
    let output = Output::new("--output", &arguments.output, &[path])?;
    let NormalVectors { width, height, vectors, .. } = {
        let _reading = Progress::spinner("reading", common.json);
        read_normal_vectors(path, common.max_bytes()).map_err(Failure::of_picture)?.with_zero_centred()
    };
    common.check_memory([width, height], BYTES_PER_TEXEL)?;
    let from_bake = FromBake::of(read_metadata(path).ok());
    let known = arguments.axes(&from_bake)?;
    let axes = if let Known::Axes(axes, _) = known { axes } else { Axes::Tangent };
    let source = source_hash([width, height], &vectors);
    let slopes = NormalSlopes::of_normals([width, height], &vectors, axes, common.steepest)
        .map_err(|error| Failure::Work(format!("{}: {error}", path.display())))?;
    drop(vectors);
    arguments.judge(&slopes)?;
    let how = Integration {
        axes,
        texel_m: from_bake.texel_m(common.texel_size, [width, height]),
        wrap: common.wrap.or(from_bake.wrap).unwrap_or_default(),
        damping: common.damping.unwrap_or(if from_bake.is_exact { 0.0 } else { DEFAULT_DAMPING }),
        steepest: common.steepest,
    };
    // Until here nothing exists that an interrupted program would leave behind.
    let cancel = interrupt::catch()?;
    let mut staged = Staged::open(&[&output.path], common.json, cancel)?;
    let (heights, slopes, fit) = {
        let bar = Progress::bar("integrating", common.json);
        let report = |part: f32| bar.show(part);
        let progress = BakeProgress::new(&report, cancel);
        match known {
            Known::Axes(..) => {
                let planes = [&slopes.along[0][..], &slopes.along[1]];
                (
                    heights_from_slopes(slopes.size, planes, &how, &progress).map_err(of_integration)?,
                    slopes,
                    None,
                )
            }
            Known::Unknown => {
                let (heights, slopes, fit) =
                    heights_from_either_green(slopes, &how, &progress).map_err(of_integration)?;
                (heights, slopes, Some(fit))
            }
        }
    };
    let (steepness, faults) = (slopes.steepness(), slopes.faults);
    drop(slopes);
    let green = GreenAnswer::new(&known, fit);
    let more = vec![
        ("source", format!("blake3:{source}")),
        ("source_size", format!("{width} {height}")),
        ("source_green", green.way.to_owned()),
    ];
    let relief = Relief::new(heights, steepness, how, &output, more)?;
    output.write(&mut staged, &relief.content, cancel)?;
    staged.finish()?;
    let seconds = started.elapsed().as_secs_f64();
    answer(|out| {
        if common.json {
            let mut about = relief.as_json(&output, seconds);
            about["input"] = path.display().to_string().into();
            about["green"] = green.as_json();
            about["normals"] = faults_as_json(&faults);
            writeln!(out, "{about:#}")?;
            return Ok(());
        }
        relief.print(out, &output, seconds)?;
        writeln!(out, "  green       {}", green.text())?;
        print_faults(out, &faults)?;
        Ok(())
    })
}

impl Arguments {
    /// The files that may be standard streams.
    pub fn files(&mut self) -> Files<'_> {
        let format = self.common.format.map(Format::ending);
        let heights = Written { flag: "--output", path: &mut self.output, format };
        Files { read: vec![&mut self.normals], written: vec![heights], ..Files::default() }
    }

    fn axes(&self, from_bake: &FromBake) -> Result<Known, Failure> {
        match (self.green, from_bake.axes) {
            (Green::Up | Green::Down, Some(Axes::World)) => {
                let name = self.normals.display();
                Err(Failure::Usage(format!("--green: {name} has its normals in world space: leave it out")))
            }
            (Green::Up, _) => Ok(Known::Axes(Axes::Tangent, "the command line")),
            (Green::Down, _) => Ok(Known::Axes(Axes::TangentGreenDown, "the command line")),
            (Green::Auto, Some(axes)) => Ok(Known::Axes(axes, "the file")),
            (Green::Auto, None) => Ok(Known::Unknown),
        }
    }

    /// Refuses normals that no relief has.
    fn judge(&self, slopes: &NormalSlopes) -> Result<(), Failure> {
        let name = self.normals.display();
        let NormalFaults { without_direction, first_without_direction, below_horizon, .. } = slopes.faults;
        if let Some([column, row]) = first_without_direction.filter(|_| !self.fill) {
            return Err(Failure::Work(format!(
                "{name}: {without_direction} of its normals have no direction (NaN, infinite or shorter than 0.1), the first \
                 at ({column}, {row}): give --fill to fill them from their surroundings"
            )));
        }
        let texels = slopes.along[0].len();
        if 2 * below_horizon > texels {
            let percent = 100.0 * below_horizon as f64 / texels as f64;
            return Err(Failure::Work(format!(
                "{name}: {percent:.0} % of its normals point along the surface or into it (blue at or below the middle): give \
                 a tangent-space normal map with blue, not one in object space or of two channels"
            )));
        }
        Ok(())
    }
}

/// What a file that `relief bake` wrote says of its normals.
struct FromBake {
    /// Whether they are slopes of heights and nothing else.
    is_exact: bool,
    axes: Option<Axes>,
    wrap: Option<relief_core::Wrap>,
    tile_m: Option<[f64; 2]>,
}

impl FromBake {
    fn of(metadata: Option<Metadata>) -> Self {
        let kinds = [Some("normal"), Some("photometric-normal")];
        let metadata = metadata.filter(|metadata| kinds.contains(&metadata.get("relief.kind")));
        let get = |name: &str| metadata.as_ref()?.get(name);
        let axes = get("relief.note.space").and_then(|space| match space {
            "tangent, +y up in the picture" => Some(Axes::Tangent),
            "tangent, +y down in the picture" => Some(Axes::TangentGreenDown),
            "world of the built-in plane" => Some(Axes::World),
            _ => None,
        });
        let side = |text: &str| text.parse::<f64>().ok().filter(|side| (1e-12..=1e12).contains(side));
        let tile = get("relief.tile_m").and_then(|tile| tile.split_once(' '));
        Self {
            is_exact: get("relief.kind") == Some("normal"),
            axes,
            wrap: get("relief.wrap").and_then(|wrap| wrap.parse().ok()),
            tile_m: tile.and_then(|(u, v)| Some([side(u)?, side(v)?])),
        }
    }

    /// The size of a texel: what is asked for, what the file says, or square texels of a map 1 m wide.
    fn texel_m(&self, asked: Option<[f64; 2]>, [width, height]: [u32; 2]) -> [f64; 2] {
        let (width, height) = (f64::from(width), f64::from(height));
        let of_file = self.tile_m.map(|[u, v]| [u / width, v / height]);
        asked.or(of_file).unwrap_or([1.0 / width, 1.0 / width])
    }
}

/// Where green was taken to point, and why.
struct GreenAnswer {
    way: &'static str,
    said_by: Option<&'static str>,
    fit: Option<GreenFit>,
}

impl GreenAnswer {
    fn new(known: &Known, fit: Option<GreenFit>) -> Self {
        let (way, said_by) = match (known, &fit) {
            (Known::Axes(Axes::World, by), _) => ("none", Some(*by)),
            (Known::Axes(Axes::TangentGreenDown, by), _) => ("down", Some(*by)),
            (Known::Axes(Axes::Tangent, by), _) => ("up", Some(*by)),
            (Known::Unknown, Some(GreenFit { is_down: true, .. })) => ("down", None),
            (Known::Unknown, _) => ("up", None),
        };
        Self { way, said_by, fit }
    }

    fn text(&self) -> String {
        let Self { way, said_by, fit } = self;
        match (said_by, fit) {
            (Some(by), _) if *way == "none" => format!("none: normals in world space, says {by}"),
            (Some(by), _) => format!("{way}, says {by}"),
            (None, Some(fit)) if fit.is_sure() => {
                format!(
                    "{way}, as the normals fit a relief better, confidence {:.0} %",
                    100.0 * fit.confidence
                )
            }
            _ => format!(
                "taken to point {way}: the normals fit a relief as well either way (--green up or down says it)"
            ),
        }
    }

    fn as_json(&self) -> Value {
        json!({
            "way": self.way, "said_by": self.said_by, "confidence": self.fit.map(|fit| fit.confidence),
            "misfits": self.fit.map(|fit| fit.misfits),
        })
    }
}

fn faults_as_json(faults: &NormalFaults) -> Value {
    json!({
        "without_direction": faults.without_direction, "not_unit": faults.not_unit, "below_horizon": faults.below_horizon,
        "too_steep": faults.too_steep,
    })
}

fn print_faults(out: &mut impl Write, faults: &NormalFaults) -> io::Result<()> {
    for (count, what) in [
        (faults.without_direction, "without a direction, filled in from their surroundings"),
        (faults.not_unit, "of a length more than 0.1 off from 1, of which the direction was used"),
        (
            faults.below_horizon,
            "that point along the surface or into it, taken for the steepest slope accepted",
        ),
        (faults.too_steep, "steeper than --steepest, taken for that slope"),
    ] {
        if count > 0 {
            writeln!(out, "  normals     {count} {what}")?;
        }
    }
    Ok(())
}

/// The hash of a normal map: BLAKE3 of width and height as `u32` and the vectors as `f32`, all little-endian.
fn source_hash([width, height]: [u32; 2], vectors: &[[f32; 3]]) -> String {
    let mut hasher = blake3::Hasher::new();
    hasher.update(&width.to_le_bytes());
    hasher.update(&height.to_le_bytes());
    let mut bytes = Vec::with_capacity(1 << 16);
    for vectors in vectors.chunks(1 << 12) {
        bytes.clear();
        bytes.extend(vectors.iter().flatten().flat_map(|value| value.to_le_bytes()));
        hasher.update(&bytes);
    }
    hasher.finalize().to_hex().to_string()
}
