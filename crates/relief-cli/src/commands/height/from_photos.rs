//! `relief height from-photos`: photometric stereo, from photographs under known lights to a height
//! map.

use std::collections::BTreeSet;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Args;
use relief_bake::from_normals::{Integration, NormalSlopes, heights_from_slopes};
use relief_bake::kind::normal::Axes;
use relief_bake::photometric::{ColourAlbedo, Photo, PhotometricError, Photometry, normals_from_photos};
use relief_core::Watch;
use relief_io::{Picture, read_picture, read_picture_as};

use super::lights::Lights;
use super::output::{
    Content, Format, NORMAL_SPACE, Output, check_distinct, coded, color_space, encoded, metadata,
};
use super::{Common, Relief, WRITTEN, of_integration, of_photos};
use crate::advice;
use crate::commands::maps::{self, Note};
use crate::commands::staged::Staged;
use crate::failure::Failure;
use crate::interrupt;
use crate::progress::Progress;
use crate::say;
use crate::streams::{Files, Written, tell_written};

/// Bytes per texel that a photograph keeps: its brightness.
const BYTES_PER_PHOTO: u64 = 4;

/// Peak of the bytes per texel beside the brightnesses: a colour picture, then normals, albedo and
/// heights.
const BYTES_PER_TEXEL: u64 = 60;

/// Default damping of normals from photographs, which have noise.
const DEFAULT_DAMPING: f64 = 0.1;

/// Arguments of `relief height from-photos`.
#[derive(Args)]
#[command(after_help = after_help())]
pub struct Arguments {
    /// TOML file that lists the photographs and their lights
    lights: PathBuf,
    /// Height map to write
    #[arg(short, long, value_name = "FILE.png|exr")]
    output: PathBuf,
    /// Also write the normals, with green up (+y): 16-bit PNG or EXR
    #[arg(long, value_name = "FILE.png|exr")]
    normals: Option<PathBuf>,
    /// Also write the albedo, the colour without light and shadow: 8-bit PNG in sRGB, or EXR in
    /// linear light
    #[arg(long, value_name = "FILE.png|exr")]
    albedo: Option<PathBuf>,
    #[command(flatten)]
    pub(super) common: Common,
}

fn after_help() -> String {
    format!(
        "A file of lights:\n\n  \
         # Photographs of one matt object from straight above, each with one distant light on.\n  \
         [[photo]]\n  file = \"left.png\"         # from the folder of this file\n  \
         light = [-0.5, 0.0, 0.8]  # toward the light: right, up, toward the camera; of any length\n  \
         [[photo]]\n  file = \"right.png\"\n  light = [0.5, 0.0, 0.8]\n  \
         intensity = 1.2           # brightness of a white surface that faces it [default: 1]\n  \
         [[photo]]\n  file = \"top.png\"\n  light = [0.0, 0.5, 0.8]\n\n\
         Three lights or more are needed, not in one plane with the surface. Above the list the file may \
         set:\n\n  \
         linear = true       # integer samples are proportional to light [default: as a PNG says, else they \
         are sRGB; floats are linear]\n  \
         shadow = 0.01       # samples up to this linear brightness are in shadow, and left out\n  \
         overexposed = 1.0   # samples from this linear brightness on are left out; inf for never\n\n\
         Example:\n  \
         relief height from-photos lights.toml -o coin.exr --normals normal.png --albedo albedo.png\n\n\
         Slopes that fewer than three lights reach are filled from their surroundings. The default of --wrap \
         is clamp, of --damping 0.1. {WRITTEN}"
    )
}

/// Reads the photographs, solves for normals, integrates them and writes the results.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let started = Instant::now();
    let common = &arguments.common;
    common.check()?;
    let lights = Lights::read(&arguments.lights)?;
    let outputs = arguments.outputs(&lights)?;
    let notes: BTreeSet<Note> =
        lights.photos.iter().flat_map(|photo| maps::of_picture(&photo.file)).collect();
    if !common.json {
        notes.iter().for_each(say::note);
    }
    let (size, pixels) = {
        let _reading = Progress::spinner("reading", common.json);
        read_all(&lights, common)?
    };
    let how = Integration {
        axes: Axes::Tangent,
        texel_m: common.texel_size.unwrap_or([1.0 / f64::from(size[0]); 2]),
        wrap: common.wrap.unwrap_or(relief_core::Wrap::Clamp),
        damping: common.damping.unwrap_or(DEFAULT_DAMPING),
        steepest: common.steepest,
    };
    // Until here nothing exists that an interrupted program would leave behind.
    let cancel = interrupt::catch()?;
    let named = [Some(&outputs.height), outputs.normals.as_ref(), outputs.albedo.as_ref()];
    let named: Vec<&Path> = named.into_iter().flatten().map(|output| output.path.as_path()).collect();
    let mut staged = Staged::open(&named, common.json, cancel)?;
    let photos = with_lights(&lights, &pixels);
    let bar = Progress::bar("solving", common.json);
    let tell = |_: &str, part: f32| bar.show(part);
    let watch = Watch::new(&tell, cancel);
    let found = normals_from_photos(size, &photos, lights.exposure, &watch.piece(0.0, 0.5));
    let found = found.map_err(|error| of_solving(error, &lights))?;
    let mut brightest = None;
    if let Some(albedo) = &outputs.albedo {
        let content = colours(&lights, &photos, &found, size, albedo, common, &watch.piece(0.5, 1.0))?;
        brightest = content.planes.iter().flatten().copied().reduce(f32::max);
        albedo.write(&mut staged, &encoded(content, albedo.format), cancel)?;
    }
    drop(pixels);
    let unknown = found.known.iter().filter(|known| !**known).count();
    let photo_misfit = found.misfit;
    let (slopes, steepness) = {
        let Photometry { normals: [x, y, z], .. } = found;
        let vectors: Vec<[f32; 3]> = x.iter().zip(&y).zip(&z).map(|((&x, &y), &z)| [x, y, z]).collect();
        if let Some(normals) = &outputs.normals {
            normals.write(&mut staged, &normal_map([x, y, z], size, normals.format)?, cancel)?;
        }
        let slopes =
            NormalSlopes::of_normals(size, &vectors, how.axes, how.steepest).map_err(of_integration)?;
        let steepness = slopes.steepness();
        (slopes, steepness)
    };
    let [along_u, along_v] = &slopes.along;
    let heights = heights_from_slopes(size, [along_u, along_v], &how, &watch.piece(0.6, 1.0));
    let heights = heights.map_err(of_integration)?;
    drop(slopes);
    drop(bar);
    let more = vec![("photographs", lights.photos.len().to_string())];
    let relief = Relief::new(heights, None, steepness, how, &outputs.height, more)?;
    outputs.height.write(&mut staged, &relief.content, cancel)?;
    staged.finish()?;
    let seconds = started.elapsed().as_secs_f64();
    tell_written(common.json, |out| {
        if common.json {
            let mut about = relief.as_json(&outputs.height, seconds);
            let name =
                |output: &Option<Output>| output.as_ref().map(|output| output.path.display().to_string());
            about["notes"] = maps::as_json(&notes);
            about["photographs"] = lights.photos.len().into();
            about["normals"] = name(&outputs.normals).into();
            about["albedo"] = name(&outputs.albedo).into();
            about["filled_in"] = unknown.into();
            about["brightness_misfit"] = photo_misfit.into();
            writeln!(out, "{about:#}")?;
            return Ok(());
        }
        relief.print(out, &outputs.height, seconds)?;
        writeln!(out, "  brightness  {photo_misfit:.4} off from what matt normals give (root mean square)")?;
        if unknown > 0 {
            writeln!(
                out,
                "  normals     {unknown} seen under fewer than three lights, filled from their surroundings"
            )?;
        }
        for output in [&outputs.normals, &outputs.albedo].into_iter().flatten() {
            writeln!(out, "  wrote       {}", output.path.display())?;
        }
        if let (Some(brightest), Some(Output { format: Format::Png, .. })) = (brightest, &outputs.albedo)
            && brightest > 1.0
        {
            writeln!(
                out,
                "  albedo      up to {brightest:.2}, clipped to 1 in the PNG: scale the intensities by that, \
                 or write an EXR"
            )?;
        }
        Ok(())
    })
}

struct Outputs {
    height: Output,
    normals: Option<Output>,
    albedo: Option<Output>,
}

impl Arguments {
    /// Returns the files that may be standard streams.
    pub fn files(&mut self) -> Files<'_> {
        let format = self.common.format.map(Format::ending);
        let heights = Written { flag: "--output", path: &mut self.output, format };
        Files { read: Vec::new(), written: vec![heights], ..Files::default() }
    }

    /// Returns the outputs. None of them is another or an input.
    fn outputs(&self, lights: &Lights) -> Result<Outputs, Failure> {
        let photos = lights.photos.iter().map(|photo| photo.file.as_path());
        let inputs: Vec<&Path> = photos.chain([self.lights.as_path()]).collect();
        let optional = |flag: &str, path: &Option<PathBuf>| {
            path.as_deref().map(|path| Output::new(flag, path, &inputs)).transpose()
        };
        let outputs = Outputs {
            height: Output::new("--output", &self.output, &inputs)?,
            normals: optional("--normals", &self.normals)?,
            albedo: optional("--albedo", &self.albedo)?,
        };
        check_distinct([Some(&self.output), self.normals.as_ref(), self.albedo.as_ref()])?;
        Ok(outputs)
    }
}

fn read_photo(lights: &Lights, photo: usize, max_bytes: u64) -> Result<Picture, Failure> {
    let file = &lights.photos[photo].file;
    let picture = match lights.curve {
        Some(curve) => read_picture_as(file, curve, max_bytes),
        None => read_picture(file, max_bytes),
    };
    picture.map_err(|error| {
        lights.of_photo(photo, &advice::with_flag(&error, advice::of_picture(&error.problem)))
    })
}

/// Reads all photographs: their size, and the brightness of each.
fn read_all(lights: &Lights, common: &Common) -> Result<([u32; 2], Vec<Vec<f32>>), Failure> {
    let mut size = None;
    let mut pixels = Vec::with_capacity(lights.photos.len());
    let kept = BYTES_PER_PHOTO * lights.photos.len() as u64;
    for photo in 0..lights.photos.len() {
        let picture = read_photo(lights, photo, common.max_bytes())?;
        let given = [picture.width, picture.height];
        let [width, height] = *size.get_or_insert(given);
        if given != [width, height] {
            let [first, here] = [0, photo].map(|photo| lights.photos[photo].file.display());
            let what = format!(
                "{here} has {}x{} pixels, {first} has {width}x{height}: photographs must have one size",
                given[0], given[1]
            );
            return Err(lights.of_photo(photo, &what));
        }
        common.check_memory(given, BYTES_PER_TEXEL + kept)?;
        let overexposed = lights.exposure.overexposed;
        pixels.push(picture.texels.iter().map(|&texel| brightness(texel, overexposed)).collect());
    }
    Ok((size.unwrap_or([0, 0]), pixels))
}

/// Returns the luminance of a colour (BT.709), or at least `overexposed` if one of its channels is.
fn brightness([r, g, b, _]: [f32; 4], overexposed: f32) -> f32 {
    let luminance = 0.2126 * r + 0.7152 * g + 0.0722 * b;
    if r.max(g).max(b) >= overexposed { luminance.max(overexposed) } else { luminance }
}

fn with_lights<'a>(lights: &Lights, pixels: &'a [Vec<f32>]) -> Vec<Photo<'a>> {
    let photo = |(photo, pixels): (&super::lights::LitPhoto, &'a Vec<f32>)| Photo {
        pixels,
        to_light: photo.to_light,
        intensity: photo.intensity,
    };
    lights.photos.iter().zip(pixels).map(photo).collect()
}

fn of_solving(error: PhotometricError, lights: &Lights) -> Failure {
    match error {
        PhotometricError::BadPixel { photo, column, row, value } => {
            let what = format!(
                "{}: pixel ({column}, {row}) has the brightness {value}, which is below 0",
                lights.photos[photo].file.display()
            );
            lights.of_photo(photo, &what)
        }
        PhotometricError::NothingKnown => Failure::Work(format!(
            "{}: no pixel is lit in three photographs whose lights are well spread: samples count from \
             'shadow' = {} to 'overexposed' = {}: lower the first or raise the second",
            lights.path.display(),
            lights.exposure.shadow,
            lights.exposure.overexposed
        )),
        other => of_photos(other),
    }
}

/// Computes the albedo. Photographs are read once more, one at a time.
fn colours(
    lights: &Lights,
    photos: &[Photo],
    found: &Photometry,
    size: [u32; 2],
    output: &Output,
    common: &Common,
    watch: &Watch,
) -> Result<Content, Failure> {
    let mut albedo = ColourAlbedo::new(found, lights.exposure);
    for (index, photo) in photos.iter().enumerate() {
        watch.at(0.0)?;
        let picture = read_photo(lights, index, common.max_bytes())?;
        albedo.add(photo, &picture.texels);
    }
    let planes = albedo.finish(size).into();
    let metadata = metadata("albedo", Vec::new(), size, color_space(output.format), PUBLISHED)?;
    Ok(Content { size, names: &["R", "G", "B"], planes, bits: 8, metadata })
}

fn normal_map(planes: [Vec<f32>; 3], size: [u32; 2], format: Format) -> Result<Content, Failure> {
    let metadata = metadata("photometric-normal", Vec::new(), size, NORMAL_SPACE, PUBLISHED)?;
    Ok(Content { size, names: &["R", "G", "B"], planes: coded(planes, format), bits: 16, metadata })
}

/// Publication of the albedo and the normals of photographs.
const PUBLISHED: &str = "Woodham 1980";
