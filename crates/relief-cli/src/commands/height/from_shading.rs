//! `relief height from-shading`: guesses a height map from the shading of one photograph.

use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

use clap::Args;
use relief_bake::from_shading::{
    BYTES_PER_TEXEL, FromShadingError, ShadedHeights, Shading, heights_from_shading,
};
use relief_core::{ByteSize, Watch, Wrap};
use relief_io::{DEFAULT_MAX_BYTES, HeightNote, read_picture};
use serde_json::json;

use super::annotated_heights::{AnnotatedHeights, SURVEYED};
use super::check_memory;
use super::output::{Content, Format, Output};
use crate::commands::maps;
use crate::commands::staged::Staged;
use crate::failure::Failure;
use crate::interrupt::{self, cancelled};
use crate::progress::Progress;
use crate::streams::{Files, Written, tell_written};
use crate::{say, units, values};

/// Samples from here on are overexposed; white in files of integers.
const OVEREXPOSED: f32 = 1.0;

/// Bytes per texel of a colour picture and its brightness.
const BYTES_OF_PICTURE: u64 = 20;

/// Share of dark pixels in percent from which cast shadows are likely.
const SHADOWED_PERCENT: f64 = 1.0;

/// Arguments of `relief height from-shading`.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// Photograph from straight above: PNG, JPEG, EXR, TIFF, HDR or PGM, colour or grey; - for
    /// standard input
    photo: PathBuf,
    /// Direction to the light: right in the picture, up in the picture, towards the camera; of any
    /// length, the third number above 0
    #[arg(long, value_name = "X,Y,Z", value_parser = direction, allow_hyphen_values = true)]
    light: [f64; 3],
    /// Linear brightness of the surface where it faces the light, above 0 and at most 1 [default:
    /// the larger of the brightness that 99.9 % of the pixels do not exceed and the albedo that
    /// makes flat ground as bright as the photograph's mean]
    #[arg(long, value_name = "A", allow_hyphen_values = true)]
    albedo: Option<f64>,
    /// Height map to write
    #[arg(short, long, value_name = "FILE.exr|png")]
    output: PathBuf,
    /// Continuation of the map beyond its edges: repeat, clamp or mirror
    #[arg(long, value_name = "WRAP", default_value = "clamp")]
    wrap: Wrap,
    /// Texel size along u and v in metres, one number or two, or with a unit, as in 0.5mm [default:
    /// square texels, the map 1 m wide]
    #[arg(long, value_name = "U[,V]", value_parser = units::one_or_two_lengths, allow_hyphen_values = true)]
    texel_size: Option<[f64; 2]>,
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

const AFTER_HELP: &str = "Examples:\n  relief height from-shading photo.png --light -1,1,1 -o photo.exr\n  \
    relief height from-shading photo.png --light 0.87,0,0.5 --albedo 0.6 --wrap repeat -o photo.exr\n\n\
    The result is a guess, and the file says so. One brightness does not determine a slope: slopes across \
    the light hardly show, and some hollows look like hills. The heights that explain the photograph are \
    found coarse to fine, with small slopes where nothing is seen. If the photograph tiles, give `--wrap \
    repeat`: the opposite edges then say more about the slopes across the light.\n\n\
    The surface should be matt and of one colour, under one distant light. Cast shadows, gloss and painted \
    patterns become false relief. A light 60 degrees from straight above shows more than a high one. With \
    three photographs or more under different lights, use `relief height from-photos`.\n\n\
    Colours become luminance in linear light: integer samples are read as sRGB unless the file says \
    otherwise. The file states the heights in metres: `relief inspect` shows them.";

/// Reads three numbers.
fn direction(text: &str) -> Result<[f64; 3], String> {
    let numbers: Option<Vec<f64>> = text.split(',').map(|part| part.trim().parse().ok()).collect();
    let numbers = numbers.and_then(|numbers| <[f64; 3]>::try_from(numbers).ok());
    numbers.ok_or_else(|| format!("'{text}' is no direction: give three numbers, as in -1,1,1"))
}

/// Reads the photograph, guesses its heights and writes them.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let started = Instant::now();
    let Arguments { photo: path, json, .. } = arguments;
    let mut how = Shading {
        to_light: arguments.light,
        albedo: arguments.albedo,
        overexposed: OVEREXPOSED,
        texel_m: arguments.texel_size.unwrap_or([1.0; 2]),
        wrap: arguments.wrap,
    };
    how.check().map_err(of_flags)?;
    let output = Output::new("--output", &arguments.output, &[path])?;
    let notes = maps::of_picture(path);
    if !json {
        notes.iter().for_each(say::note);
    }
    let max_bytes = arguments.max_memory.map_or(DEFAULT_MAX_BYTES, |size| size.0);
    let (size, pixels) = {
        let _reading = Progress::spinner("reading", *json);
        let picture = read_picture(path, max_bytes).map_err(Failure::of_picture)?;
        let size = [picture.width, picture.height];
        check_memory(size, BYTES_PER_TEXEL + BYTES_OF_PICTURE, max_bytes)?;
        (size, picture.texels.iter().map(|&texel| brightness(texel)).collect::<Vec<f32>>())
    };
    how.texel_m = arguments.texel_size.unwrap_or([1.0 / f64::from(size[0]); 2]);
    // Until here nothing exists that an interrupted program would leave behind.
    let cancel = interrupt::catch()?;
    let mut staged = Staged::open(&[&output.path], *json, cancel)?;
    let found = {
        let bar = Progress::bar("solving", *json);
        let tell = |_: &str, part: f32| bar.show(part);
        heights_from_shading(size, &pixels, &how, &Watch::new(&tell, cancel)).map_err(
            |error| match error {
                FromShadingError::Cancelled(_) => cancelled(),
                other => Failure::Work(format!("{}: {other}", path.display())),
            },
        )?
    };
    drop(pixels);
    let (content, note) = content(&found, &how, &output)?;
    output.write(&mut staged, &content, cancel)?;
    staged.finish()?;
    let percent = |count: usize| 100.0 * count as f64 / found.heights_m.len() as f64;
    let seconds = started.elapsed().as_secs_f64();
    let [width, height] = size;
    tell_written(*json, |out| {
        if *json {
            let about = json!({
                "input": path.display().to_string(), "output": output.path.display().to_string(),
                "width": width, "height": height, "scale_m": note.scale_m, "bias_m": note.bias_m,
                "tile_m": note.tile_m, "texel_m": how.texel_m, "wrap": how.wrap.name(), "light": how.to_light,
                "albedo": found.albedo, "brightness_misfit": found.misfit,
                "overexposed_percent": percent(found.overexposed),
                "brighter_than_albedo_percent": percent(found.too_bright),
                "dark_percent": percent(found.dark), "seconds": seconds, "notes": maps::as_json(&notes),
            });
            writeln!(out, "{about:#}")?;
            return Ok(());
        }
        writeln!(out, "{}: {width}x{height} guessed heights in {seconds:.2} s", output.path.display())?;
        if note.scale_m == 0.0 {
            writeln!(out, "  relief      none: the photograph looks like flat ground, and every texel is 0")?;
        } else {
            let [zero, one, scale] =
                [note.bias_m, note.bias_m + note.scale_m, note.scale_m].map(values::six_digits);
            writeln!(out, "  relief      0 stands for {zero} m, 1 for {one} m: --scale {scale}")?;
        }
        let [tile_u, tile_v] = note.tile_m.map(values::six_digits);
        writeln!(out, "  tile        {tile_u} m x {tile_v} m, --wrap {}", how.wrap)?;
        let origin = if arguments.albedo.is_some() { "given" } else { "estimated" };
        writeln!(out, "  albedo      {} ({origin})", values::six_digits(found.albedo))?;
        writeln!(
            out,
            "  brightness  {:.4} off from what these heights give (root mean square)",
            found.misfit
        )?;
        Ok(())
    })?;
    if !json {
        tell_doubts(&found, percent);
    }
    Ok(())
}

/// Says what in the photograph no heights explain.
fn tell_doubts(found: &ShadedHeights, percent: impl Fn(usize) -> f64) {
    if found.overexposed > 0 {
        say::note(format!(
            "{:.1} % of the pixels are overexposed: their slopes are lost; take a darker photograph",
            percent(found.overexposed)
        ));
    }
    if found.too_bright > 0 {
        say::note(format!(
            "{:.1} % of the pixels are brighter than the albedo {}, which no slope explains: give a larger \
             --albedo, or none",
            percent(found.too_bright),
            values::six_digits(found.albedo)
        ));
    }
    if percent(found.dark) >= SHADOWED_PERCENT {
        say::note(format!(
            "{:.1} % of the pixels are black: cast shadows become false relief; photographs under three \
             lights or more (`relief height from-photos`) can leave shadows out",
            percent(found.dark)
        ));
    }
}

/// Turns an error about the numbers into one about the flags.
fn of_flags(error: FromShadingError) -> Failure {
    let flag = match error {
        FromShadingError::BadAlbedo(_) => "--albedo",
        FromShadingError::BadTexel(..) => "--texel-size",
        _ => "--light",
    };
    Failure::Usage(format!("{flag}: {error}"))
}

/// Returns the luminance of a colour (BT.709), or at least white if one of its channels is.
fn brightness([r, g, b, _]: [f32; 4]) -> f32 {
    let luminance = 0.2126 * r + 0.7152 * g + 0.0722 * b;
    if r.max(g).max(b) >= OVEREXPOSED { luminance.max(OVEREXPOSED) } else { luminance }
}

fn content(found: &ShadedHeights, how: &Shading, output: &Output) -> Result<(Content, HeightNote), Failure> {
    let map = found.to_map(how.wrap).map_err(Failure::work)?;
    let [width, height] = found.size;
    let tile_m = [how.texel_m[0] * f64::from(width), how.texel_m[1] * f64::from(height)];
    let note = HeightNote { tile_m, scale_m: map.scale_m(), bias_m: map.bias_m(), of_mesh: false };
    let [x, y, z] = how.to_light;
    let annotated = AnnotatedHeights {
        size: found.size,
        texels: map.texels().to_vec(),
        wrap: how.wrap,
        note,
        origin: vec![("settings", format!("light={x},{y},{z} albedo={}", found.albedo))],
        published: Some(SURVEYED),
        guarantee: Some("none: a guess from the shading of one photograph, which fits many reliefs"),
        more: vec![("photographs", "1".to_owned())],
    };
    Ok((annotated.content(output)?, note))
}

impl Arguments {
    /// Returns the files that may be standard streams.
    pub fn files(&mut self) -> Files<'_> {
        let format = self.format.map(Format::ending);
        let heights = Written { flag: "--output", path: &mut self.output, format };
        Files { read: vec![&mut self.photo], written: vec![heights], ..Files::default() }
    }
}
