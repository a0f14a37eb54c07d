//! `relief height from-normals`: integrates a normal map into a height map.

use std::io::{self, Write};
use std::path::PathBuf;
use std::time::Instant;

use clap::{Args, ValueEnum};
use relief_bake::from_normals::{
    Evidence, FromNormalsError, GreenFit, Integration, NormalFaults, NormalSlopes, NormalSource,
    heights_from_either_green, heights_from_known_slopes,
};
use relief_bake::kind::normal::Axes;
use relief_core::Watch;
use relief_io::{Metadata, NormalVectors, read_metadata, read_normal_vectors};
use serde_json::{Value, json};

use super::output::{Format, Output};
use super::{Common, Relief, WRITTEN, of_integration};
use crate::commands::maps;
use crate::commands::staged::Staged;
use crate::failure::Failure;
use crate::interrupt;
use crate::progress::Progress;
use crate::say;
use crate::streams::{Files, Written, tell_written};

/// Peak of the bytes per texel that reading and integrating take.
const BYTES_PER_TEXEL: u64 = 32;

/// Peak of the bytes per texel if some texels hold no normal.
const BYTES_PER_TEXEL_WITH_HOLES: u64 = 72;

/// Default damping of normals from elsewhere. Normals of `relief bake` are inverted without any.
const DEFAULT_DAMPING: f64 = 0.1;

/// Arguments of `relief height from-normals`.
#[derive(Args)]
#[command(after_help = after_help())]
pub struct Arguments {
    /// Tangent-space normal map: PNG, JPEG, EXR, TIFF, HDR or PGM with red, green and blue, or EXR
    /// with x, y and z; - for standard input
    normals: PathBuf,
    /// Height map to write
    #[arg(short, long, value_name = "FILE.png|exr")]
    output: PathBuf,
    /// Direction of green: up in the picture (+y: OpenGL, glTF, Blender), down (-y: DirectX,
    /// Unreal), or auto, whichever fits a relief better
    #[arg(long, value_enum, value_name = "up|down|auto", default_value = "auto", allow_hyphen_values = true)]
    green: Green,
    /// Fill texels without a normal (black, white, middle grey, transparent, NaN) from their
    /// surroundings [default: they become holes of the height map, which EXR can hold and PNG
    /// cannot]
    #[arg(long)]
    fill: bool,
    /// Refuse the map if more than this percentage of its slopes fits no relief: then it is no
    /// tangent-space normal map. 100 accepts every map
    #[arg(
        long,
        value_name = "PERCENT",
        value_parser = percent,
        default_value = "60",
        allow_hyphen_values = true,
        help_heading = "Integration"
    )]
    max_misfit: f64,
    #[command(flatten)]
    pub(super) common: Common,
}

fn after_help() -> String {
    format!(
        "Example:\n  relief height from-normals rock_normal.png -o rock.exr\n  \
         relief bake rock.exr --kind cone,horizon -o .\n\n\
         Files of `relief bake --kind normal` state their own wrap, tile and green. For others the default \
         of --wrap is repeat, of --damping 0.1. Texels that are black, white, grey or transparent hold no \
         normal; heights beside them do not depend on them. {WRITTEN}\n\n\
         Normals do not say which way is out. If a relief comes back inside out, red and green both point \
         the other way: the height map is a depth map (use --depth in other commands)."
    )
}

/// Reads a percentage, with its sign or without.
fn percent(text: &str) -> Result<f64, String> {
    let number = text.strip_suffix('%').unwrap_or(text).trim_end().parse::<f64>();
    let number = number.map_err(|_| format!("'{text}' is not a number: give percent, as in 60"))?;
    if (0.0..=100.0).contains(&number) {
        return Ok(number);
    }
    Err(format!("{number} is out of range: it must be from 0 to 100 percent"))
}

/// Direction of the green channel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Green {
    #[value(alias = "+y")]
    Up,
    #[value(alias = "-y")]
    Down,
    Auto,
}

/// Axes of the normals, and their source.
enum StatedAxes {
    /// Axes that the command line or the file states.
    Axes(Axes, &'static str),
    /// No axes are stated.
    Unknown,
}

/// Reads the normals, integrates them and writes the heights.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let started = Instant::now();
    let Arguments { normals: path, common, .. } = arguments;
    common.check()?;
    let output = Output::new("--output", &arguments.output, &[path])?;
    let notes = maps::of_picture(path);
    if !common.json {
        notes.iter().for_each(say::note);
    }
    let NormalVectors { width, height, vectors, opacity, .. } = {
        let _reading = Progress::spinner("reading", common.json);
        read_normal_vectors(path, common.max_bytes()).map_err(Failure::of_picture)?.with_zero_centred()
    };
    common.check_memory([width, height], BYTES_PER_TEXEL)?;
    let from_bake = FromBake::of(read_metadata(path).ok());
    let known = arguments.axes(&from_bake)?;
    let axes = if let StatedAxes::Axes(axes, _) = known { axes } else { Axes::Tangent };
    let source = source_hash([width, height], &vectors);
    let suspects =
        if axes == Axes::World { Vec::new() } else { Evidence::of(&vectors, opacity.as_deref()).sources() };
    let slopes =
        NormalSlopes::of_picture([width, height], &vectors, opacity.as_deref(), axes, common.steepest)
            .map_err(|error| arguments.no_normals(&error, &suspects))?;
    drop((vectors, opacity));
    arguments.judge(&slopes, &suspects, output.format)?;
    if slopes.known.is_some() {
        common.check_memory([width, height], BYTES_PER_TEXEL_WITH_HOLES)?;
    }
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
    let mut other_misfit = None;
    let (heights, slopes, fit) = {
        let bar = Progress::bar("integrating", common.json);
        let tell = |_: &str, part: f32| bar.show(part);
        let watch = Watch::new(&tell, cancel);
        match known {
            StatedAxes::Axes(..) => {
                let heights = heights_from_known_slopes(&slopes, &how, &watch).map_err(of_integration)?;
                let steepness = slopes.steepness();
                let is_beyond = 100.0 * heights.misfit > arguments.max_misfit * steepness;
                if is_beyond && axes != Axes::World {
                    // They may fit a relief with green the other way.
                    let turned = slopes.turned_over();
                    let other = heights_from_known_slopes(&turned, &how, &watch).map_err(of_integration)?;
                    other_misfit = Some(other.misfit / steepness);
                    (heights, turned.turned_over(), None)
                } else {
                    (heights, slopes, None)
                }
            }
            StatedAxes::Unknown => {
                let (heights, slopes, fit) =
                    heights_from_either_green(slopes, &how, &watch).map_err(of_integration)?;
                (heights, slopes, Some(fit))
            }
        }
    };
    let (steepness, faults) = (slopes.steepness(), slopes.faults);
    let with_height = slopes.known.filter(|_| !arguments.fill);
    drop(slopes.along);
    let green = GreenAnswer::new(&known, fit);
    let more = vec![
        ("source", format!("blake3:{source}")),
        ("source_size", format!("{width} {height}")),
        ("source_green", green.way.to_owned()),
    ];
    let relief = Relief::new(heights, with_height.as_deref(), steepness, how, &output, more)?;
    let other_misfit = other_misfit.filter(|misfit| 100.0 * misfit <= arguments.max_misfit);
    if other_misfit.is_none() {
        arguments.judge_misfit(relief.misfit, &suspects)?;
    }
    output.write(&mut staged, &relief.content, cancel)?;
    staged.finish()?;
    let seconds = started.elapsed().as_secs_f64();
    tell_written(common.json, |out| {
        if common.json {
            let mut about = relief.as_json(&output, seconds);
            about["notes"] = maps::as_json(&notes);
            about["input"] = path.display().to_string().into();
            about["green"] = green.as_json();
            about["normals"] = faults_as_json(&faults);
            about["may_be"] = suspects.iter().map(ToString::to_string).collect::<Vec<String>>().into();
            writeln!(out, "{about:#}")?;
            return Ok(());
        }
        relief.print(out, &output, seconds)?;
        writeln!(out, "  green       {}", green.text())?;
        if let Some(misfit) = other_misfit {
            let percent = 100.0 * misfit;
            writeln!(out, "  green       the other way only {percent:.2} % of the slopes fit no relief")?;
        }
        print_faults(out, &faults, arguments.fill)?;
        Ok(())
    })?;
    if !common.json {
        let sure = suspects.iter().filter(|suspect| suspect.is_sure());
        sure.for_each(|suspect| say::note(format!("the normal map may be {suspect}")));
    }
    Ok(())
}

impl Arguments {
    /// Returns the files that may be standard streams.
    pub fn files(&mut self) -> Files<'_> {
        let format = self.common.format.map(Format::ending);
        let heights = Written { flag: "--output", path: &mut self.output, format };
        Files { read: vec![&mut self.normals], written: vec![heights], ..Files::default() }
    }

    fn axes(&self, from_bake: &FromBake) -> Result<StatedAxes, Failure> {
        match (self.green, from_bake.axes) {
            (Green::Up | Green::Down, Some(Axes::World)) => {
                let name = self.normals.display();
                Err(Failure::Usage(format!(
                    "--green: the normals of {name} are in world space: leave it out"
                )))
            }
            (Green::Up, _) => Ok(StatedAxes::Axes(Axes::Tangent, "the command line")),
            (Green::Down, _) => Ok(StatedAxes::Axes(Axes::TangentGreenDown, "the command line")),
            (Green::Auto, Some(axes)) => Ok(StatedAxes::Axes(axes, "the file")),
            (Green::Auto, None) => Ok(StatedAxes::Unknown),
        }
    }

    /// Refuses normals that no relief has, and holes if the output cannot hold them.
    fn judge(&self, slopes: &NormalSlopes, suspects: &[NormalSource], format: Format) -> Result<(), Failure> {
        let name = self.normals.display();
        let faults = slopes.faults;
        let texels = slopes.along[0].len() - faults.holes();
        if 2 * faults.below_horizon > texels {
            let percent = 100.0 * faults.below_horizon as f64 / texels as f64;
            return Err(Failure::Work(format!(
                "{name}: {percent:.0} % of its normals point along the surface or into it (blue at or below \
                 the middle): give a tangent-space normal map with blue, not one in object space or with two \
                 channels{}",
                may_be(suspects)
            )));
        }
        let Some([column, row]) = faults.first_hole.filter(|_| !self.fill && format == Format::Png) else {
            return Ok(());
        };
        let kinds = hole_kinds(&faults).map(|(count, kind)| format!("{count} {kind}"));
        Err(Failure::Work(format!(
            "{name}: {} of its texels hold no normal ({}), the first at ({column}, {row}): give --fill to \
             fill them from their surroundings, or write an EXR, which keeps them as holes",
            faults.holes(),
            kinds.collect::<Vec<String>>().join(", ")
        )))
    }

    /// Refuses a map whose slopes fit no relief.
    fn judge_misfit(&self, misfit: Option<f64>, suspects: &[NormalSource]) -> Result<(), Failure> {
        let Some(percent) = misfit.map(|misfit| 100.0 * misfit).filter(|percent| *percent > self.max_misfit)
        else {
            return Ok(());
        };
        let what = if suspects.is_empty() {
            ". No measure tells what it is: noise, cliffs everywhere, or no normal map".to_owned()
        } else {
            may_be(suspects)
        };
        Err(Failure::Work(format!(
            "{}: {percent:.0} % of its slopes fit no relief, more than --max-misfit {}{what}. Give a \
             tangent-space normal map, or --max-misfit 100 to take this one",
            self.normals.display(),
            self.max_misfit
        )))
    }

    /// The error of a map without any normal.
    fn no_normals(&self, error: &FromNormalsError, suspects: &[NormalSource]) -> Failure {
        Failure::Work(format!("{}: {error}{}", self.normals.display(), may_be(suspects)))
    }
}

/// Lists what a map may be, for the end of an error.
fn may_be(suspects: &[NormalSource]) -> String {
    let suspects: Vec<String> = suspects.iter().map(ToString::to_string).collect();
    if suspects.is_empty() { String::new() } else { format!(". It may be {}", suspects.join("; or ")) }
}

/// Metadata of a normal map that `relief bake` wrote.
struct FromBake {
    /// Whether the normals are slopes of heights and nothing else.
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

    /// Returns the texel size: the one asked for, the file's, or square texels of a map 1 m wide.
    fn texel_m(&self, asked: Option<[f64; 2]>, [width, height]: [u32; 2]) -> [f64; 2] {
        let (width, height) = (f64::from(width), f64::from(height));
        let of_file = self.tile_m.map(|[u, v]| [u / width, v / height]);
        asked.or(of_file).unwrap_or([1.0 / width, 1.0 / width])
    }
}

/// Direction that green was taken to have, with the reason.
struct GreenAnswer {
    way: &'static str,
    said_by: Option<&'static str>,
    fit: Option<GreenFit>,
}

impl GreenAnswer {
    fn new(known: &StatedAxes, fit: Option<GreenFit>) -> Self {
        let (way, said_by) = match (known, &fit) {
            (StatedAxes::Axes(Axes::World, by), _) => ("none", Some(*by)),
            (StatedAxes::Axes(Axes::TangentGreenDown, by), _) => ("down", Some(*by)),
            (StatedAxes::Axes(Axes::Tangent, by), _) => ("up", Some(*by)),
            (StatedAxes::Unknown, Some(GreenFit { is_down: true, .. })) => ("down", None),
            (StatedAxes::Unknown, _) => ("up", None),
        };
        Self { way, said_by, fit }
    }

    fn text(&self) -> String {
        let Self { way, said_by, fit } = self;
        match (said_by, fit) {
            (Some(by), _) if *way == "none" => format!("none: normals in world space, by {by}"),
            (Some(by), _) => format!("{way}, by {by}"),
            (None, Some(fit)) if fit.is_sure() => {
                format!("{way}, which fits a relief better, confidence {:.0} %", 100.0 * fit.confidence)
            }
            _ => format!(
                "taken to point {way}: the normals fit a relief as well either way (set it with --green up \
                 or down)"
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
        "without_direction": faults.without_direction, "background": faults.background,
        "transparent": faults.transparent, "mixed": faults.mixed,
        "holes": faults.holes(), "not_unit": faults.not_unit,
        "below_horizon": faults.below_horizon, "too_steep": faults.too_steep,
    })
}

/// Returns the kinds of holes that occur, with their numbers.
fn hole_kinds(faults: &NormalFaults) -> impl Iterator<Item = (usize, &'static str)> {
    let kinds = [
        (faults.background, "black, white or of another full colour"),
        (faults.transparent, "transparent"),
        (faults.without_direction, "without a direction: grey or NaN"),
        (faults.mixed, "mixed with those beside them"),
    ];
    kinds.into_iter().filter(|(count, _)| *count > 0)
}

fn print_faults(out: &mut impl Write, faults: &NormalFaults, is_filled: bool) -> io::Result<()> {
    for (count, kind) in hole_kinds(faults) {
        let what = if is_filled { "filled from their surroundings" } else { "holes in the height map" };
        writeln!(out, "  holes       {count} {kind}; {what}")?;
    }
    for (count, what) in [
        (faults.not_unit, "more than 0.1 off unit length; their direction was used"),
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

/// Returns the hash of a normal map: BLAKE3 of width and height as `u32` and the vectors as `f32`,
/// all little-endian.
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
