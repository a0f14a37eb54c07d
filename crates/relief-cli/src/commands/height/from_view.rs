//! `relief height from-view`: converts an image of a depth object into a height map.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Args;
use relief_core::object::{ImageObject, View};
use relief_core::{ByteSize, Wrap};
use relief_io::{DEFAULT_MAX_BYTES, HeightNote};
use relief_object::{ObjectFile, ObjectOptions, read_object};
use serde_json::json;

use super::annotated_heights::{AnnotatedHeights, SURVEYED};
use super::check_memory;
use super::output::{
    Content, Format, NORMAL_SPACE, Output, check_distinct, coded, color_space, encoded, metadata,
};
use crate::commands::staged::Staged;
use crate::failure::Failure;
use crate::progress::Progress;
use crate::streams::{Files, Written, tell_written};
use crate::{interrupt, values};

/// Bytes per texel of the outputs.
const BYTES_PER_TEXEL: u64 = 28;

/// Arguments of `relief height from-view`.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// Depth object: an object.toml of `relief capture`
    object: PathBuf,
    /// Number of the image, counted from 1 in the file's order; a grid counts row by row
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    view: usize,
    /// Height map to write
    #[arg(short, long, value_name = "FILE.png|exr")]
    output: PathBuf,
    /// Also write the image's normals: 16-bit PNG, or EXR
    #[arg(long, value_name = "FILE.png|exr")]
    normals: Option<PathBuf>,
    /// Also write the image's colours: 8-bit PNG in sRGB, or EXR in linear light
    #[arg(long, value_name = "FILE.png|exr")]
    albedo: Option<PathBuf>,
    /// Leave texels that see nothing without a value [default: their height is 0]
    #[arg(long)]
    holes: bool,
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
    relief height from-view spot/object.toml --view 5 -o front.exr --albedo front.png\n  \
    relief height from-view spot/object.toml --view 5 --holes -o front.exr\n\n\
    The map is as deep as it is wide, and lies below its plane. On the built-in `plane`, which is 1 m long, \
    `relief render --height front.exr --wrap clamp` shows what the image saw. On a plane of another size, \
    scale and bias grow with it.\n\n\
    Where the image saw nothing, the map has its floor, or with --holes no value. `relief render --holes` \
    shows such texels as openings; only EXR holds them.";

/// Reads the object and writes the height map.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let started = Instant::now();
    let outputs = arguments.outputs()?;
    let max_bytes = arguments.max_memory.map_or(DEFAULT_MAX_BYTES, |size| size.0);
    let file = {
        let _reading = Progress::spinner("reading", arguments.json);
        let options = ObjectOptions { max_bytes, ..ObjectOptions::default() };
        read_object(&arguments.object, &options).map_err(Failure::work)?
    };
    let image = arguments.image(&file.object)?;
    check_memory(image.view.size(), BYTES_PER_TEXEL, max_bytes)?;
    let cancel = interrupt::catch()?;
    let named = [Some(&outputs.heights), outputs.normals.as_ref(), outputs.albedo.as_ref()];
    let paths: Vec<&Path> = named.into_iter().flatten().map(|output| output.path.as_path()).collect();
    let mut staged = Staged::open(&paths, arguments.json, cancel)?;
    let (texels, note) = image.heights(arguments.holes);
    let content = arguments.heights(&image, texels, note, &outputs.heights)?;
    outputs.heights.write(&mut staged, &content, cancel)?;
    if let Some(output) = &outputs.normals {
        output.write(&mut staged, &arguments.normals(&file, &image, output)?, cancel)?;
    }
    if let Some(output) = &outputs.albedo {
        let content = encoded(arguments.albedo(&file, &image, output)?, output.format);
        output.write(&mut staged, &content, cancel)?;
    }
    staged.finish()?;
    let seconds = started.elapsed().as_secs_f64();
    let HeightNote { tile_m, scale_m, bias_m, .. } = note;
    let [width, height] = image.view.size();
    let seen = image.texels().filter(|texel| *texel > 0.0).count();
    tell_written(arguments.json, |out| {
        if arguments.json {
            let name = |path: &Option<PathBuf>| path.as_ref().map(|path| path.display().to_string());
            let about = json!({
                "object": arguments.object.display().to_string(), "view": arguments.view,
                "output": outputs.heights.path.display().to_string(), "normals": name(&arguments.normals),
                "albedo": name(&arguments.albedo), "width": width, "height": height, "seen": seen,
                "width_m": image.width_m(), "scale_m": scale_m, "bias_m": bias_m, "tile_m": tile_m,
                "from": image.view.axes()[2].to_array(), "seconds": seconds,
            });
            writeln!(out, "{about:#}")?;
            return Ok(());
        }
        let path = outputs.heights.path.display();
        writeln!(out, "{path}: {width}x{height} heights in {seconds:.2} s, {seen} of them seen")?;
        let [scale, bias] = [scale_m, bias_m].map(values::six_digits);
        writeln!(
            out,
            "  relief      --scale {scale} --bias {bias} on a plane of 1 m, as the file says, --wrap clamp"
        )?;
        let width = values::six_digits(image.width_m());
        writeln!(out, "  width       {width} m of the object, and as deep")?;
        Ok(())
    })
}

/// Output files.
struct Outputs {
    heights: Output,
    normals: Option<Output>,
    albedo: Option<Output>,
}

/// One image of a depth object.
struct Image<'a> {
    object: &'a ImageObject,
    view: &'a View,
    /// First texel of the image in the texture of all images.
    origin: [u32; 2],
}

impl Image<'_> {
    /// Returns the place of each of its texels in the texture of all images, row by row.
    fn places(&self) -> impl Iterator<Item = [u32; 2]> {
        let ([columns, rows], [left, top]) = (self.view.size(), self.origin);
        (0..rows).flat_map(move |row| (0..columns).map(move |column| [left + column, top + row]))
    }

    fn texels(&self) -> impl Iterator<Item = f32> {
        self.places().map(|[x, y]| self.object.heights().texel(i64::from(x), i64::from(y)))
    }

    /// Returns the image's part of data that lies as the heights do: three planes of numbers.
    fn planes(&self, of_all: impl Fn(usize) -> [f32; 3]) -> [Vec<f32>; 3] {
        let width = self.object.layout().size()[0] as usize;
        let texels: Vec<[f32; 3]> =
            self.places().map(|[x, y]| of_all(y as usize * width + x as usize)).collect();
        [0, 1, 2].map(|part| texels.iter().map(|texel| texel[part]).collect())
    }

    /// Returns the image's width in metres, which is its depth, too.
    fn width_m(&self) -> f64 {
        2.0 * self.view.ball().1
    }

    /// Returns the texels from 0 to 1, with scale and bias on a plane whose longer side is 1 m, as
    /// the built-in plane's is. The plane lies above all texels. With holes, texels that see
    /// nothing have no value.
    fn heights(&self, has_holes: bool) -> (Vec<f32>, HeightNote) {
        let is_valued = |texel: &f32| !has_holes || *texel > 0.0;
        let valued = || self.texels().filter(is_valued);
        let [low, high] = [valued().fold(1.0, f32::min), valued().fold(0.0, f32::max)];
        let span = (high - low).max(0.0);
        let part = |texel: f32| if span > 0.0 { (texel - low) / span } else { 0.0 };
        let texel = |texel: f32| if is_valued(&texel) { part(texel) } else { f32::NAN };
        let [columns, rows] = self.view.size().map(f64::from);
        let tile_m = [columns, rows].map(|side| side / columns.max(rows));
        let [scale_m, bias_m] = [span, low - 1.0].map(|part| tile_m[0] * f64::from(part));
        (self.texels().map(texel).collect(), HeightNote { tile_m, scale_m, bias_m, of_mesh: true })
    }
}

impl Arguments {
    /// Returns the files that may be standard streams.
    pub fn files(&mut self) -> Files<'_> {
        let format = self.format.map(Format::ending);
        let heights = Written { flag: "--output", path: &mut self.output, format };
        let normals = self.normals.as_mut().map(|path| Written { flag: "--normals", path, format: None });
        let albedo = self.albedo.as_mut().map(|path| Written { flag: "--albedo", path, format: None });
        Files {
            written: [Some(heights), normals, albedo].into_iter().flatten().collect(),
            ..Files::default()
        }
    }

    fn outputs(&self) -> Result<Outputs, Failure> {
        let inputs = [self.object.as_path()];
        let heights = Output::new("--output", &self.output, &inputs)?;
        if self.holes && heights.format == Format::Png {
            return Err(Failure::usage(
                "--holes leaves texels without a value, which a PNG cannot hold: write an EXR",
            ));
        }
        check_distinct([Some(&self.output), self.normals.as_ref(), self.albedo.as_ref()])?;
        let optional = |flag: &str, path: &Option<PathBuf>| {
            path.as_ref().map(|path| Output::new(flag, path, &inputs)).transpose()
        };
        Ok(Outputs {
            heights,
            normals: optional("--normals", &self.normals)?,
            albedo: optional("--albedo", &self.albedo)?,
        })
    }

    /// Returns the image that is asked for.
    fn image<'a>(&self, object: &'a ImageObject) -> Result<Image<'a>, Failure> {
        let place = self.view.checked_sub(1);
        let found = place.and_then(|at| Some((object.views().get(at)?, *object.layout().places().get(at)?)));
        let Some((view, place)) = found else {
            let (view, count) = (self.view, object.views().len());
            return Err(Failure::Usage(format!(
                "--view {view}: the object has images 1 to {count}: choose one of them"
            )));
        };
        if view.eye().is_some() {
            return Err(Failure::Work(format!(
                "{}: image {} is perspective, so its depths are not linear: choose an orthographic image, or \
                 capture the object without `--perspective`",
                self.object.display(),
                self.view
            )));
        }
        Ok(Image { object, view, origin: place })
    }

    fn heights(
        &self,
        image: &Image,
        texels: Vec<f32>,
        note: HeightNote,
        output: &Output,
    ) -> Result<Content, Failure> {
        let annotated = AnnotatedHeights {
            size: image.view.size(),
            texels,
            wrap: Wrap::Clamp,
            note,
            origin: self.origin(),
            published: Some(SURVEYED),
            guarantee: None,
            more: vec![("width_m", image.width_m().to_string())],
        };
        annotated.content(output)
    }

    /// Returns the origin that all files state.
    fn origin(&self) -> Vec<(&'static str, String)> {
        vec![("object", self.object.display().to_string()), ("view", self.view.to_string())]
    }

    fn normals(&self, file: &ObjectFile, image: &Image, output: &Output) -> Result<Content, Failure> {
        let Some(all) = &file.normal else { return Err(self.has_none("normals", "--normals")) };
        let size = image.view.size();
        let metadata = metadata("view-normal", self.origin(), size, NORMAL_SPACE, SURVEYED)?;
        let planes = coded(image.planes(|at| all.normals[at]), output.format);
        Ok(Content { size, names: &["R", "G", "B"], planes, bits: 16, metadata })
    }

    fn albedo(&self, file: &ObjectFile, image: &Image, output: &Output) -> Result<Content, Failure> {
        let Some(all) = &file.color else { return Err(self.has_none("colours", "--albedo")) };
        let size = image.view.size();
        let metadata = metadata("albedo", self.origin(), size, color_space(output.format), SURVEYED)?;
        let color = |at: usize| {
            let [red, green, blue, _] = all.texels[at];
            [red, green, blue]
        };
        Ok(Content { size, names: &["R", "G", "B"], planes: image.planes(color).into(), bits: 8, metadata })
    }

    fn has_none(&self, what: &str, flag: &str) -> Failure {
        Failure::Work(format!("{}: the object has no {what}: leave out {flag}", self.object.display()))
    }
}
