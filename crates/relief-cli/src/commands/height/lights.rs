//! TOML file that lists photographs and their lights.

use std::fs::File;
use std::io::Read;
use std::ops::Range;
use std::path::{Path, PathBuf};

use relief_bake::photometric::{Exposure, PhotometricError, check_lights};
use relief_io::{Curve, decode_text};
use serde::Deserialize;
use toml::Spanned;

use crate::failure::Failure;

/// Greatest length of the file in bytes: longer files are something else.
const MAX_FILE_BYTES: u64 = 1 << 20;

/// Default of `shadow`: samples at or below it are in shadow; 28 of 255 in sRGB.
const DEFAULT_SHADOW: f32 = 0.01;

/// Default of `overexposed`: samples at or above it are overexposed; white in files of integers.
const DEFAULT_OVEREXPOSED: f32 = 1.0;

/// Photographs and their lights, from one file.
pub struct Lights {
    /// Path of the file.
    pub path: PathBuf,
    text: String,
    /// Curve from light to integer samples; none if each picture's file says it.
    pub curve: Option<Curve>,
    pub exposure: Exposure,
    pub photos: Vec<LitPhoto>,
}

/// Photograph and its light.
pub struct LitPhoto {
    /// Path of the picture.
    pub file: PathBuf,
    pub to_light: [f64; 3],
    pub intensity: f64,
    /// Places of the picture's and the light's entries in the text.
    file_at: Range<usize>,
    light_at: Range<usize>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Text {
    linear: Option<bool>,
    shadow: Option<Spanned<f32>>,
    overexposed: Option<Spanned<f32>>,
    #[serde(default)]
    photo: Vec<PhotoText>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PhotoText {
    file: Spanned<PathBuf>,
    light: Spanned<[f64; 3]>,
    intensity: Option<Spanned<f64>>,
}

impl Lights {
    /// Reads the file and checks all that needs no picture. Relative names in it start at the
    /// folder of the file.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let text = read_text(path).map_err(|what| Failure::Work(format!("{}: {what}", path.display())))?;
        let found: Text = toml::from_str(&text).map_err(|error| {
            Failure::Work(format!("{}: {}", path.display(), error.to_string().trim_end()))
        })?;
        let folder = path.parent().unwrap_or(Path::new(""));
        let mut lights = Self {
            path: path.to_owned(),
            curve: found.linear.map(|linear| if linear { Curve::Linear } else { Curve::Srgb }),
            exposure: Exposure { shadow: DEFAULT_SHADOW, overexposed: DEFAULT_OVEREXPOSED },
            photos: Vec::new(),
            text,
        };
        let number = |value: &Spanned<f32>, must: &str, fits: bool| {
            let what = format!("{} must be {must}", value.as_ref());
            if fits { Ok(*value.as_ref()) } else { Err(lights.failure(&value.span(), &what)) }
        };
        let mut exposure = lights.exposure;
        if let Some(shadow) = &found.shadow {
            exposure.shadow = number(shadow, "from 0 to 1e9", (0.0..=1e9).contains(shadow.as_ref()))?;
        }
        if let Some(overexposed) = &found.overexposed {
            let fits = *overexposed.as_ref() > exposure.shadow;
            exposure.overexposed = number(overexposed, "above 'shadow' (inf for never)", fits)?;
        }
        lights.exposure = exposure;
        for PhotoText { file, light, intensity } in found.photo {
            if let Some(intensity) = &intensity
                && !(1e-12..=1e12).contains(intensity.as_ref())
            {
                let what =
                    format!("the intensity {} must be above 0, from 1e-12 to 1e12", intensity.as_ref());
                return Err(lights.failure(&intensity.span(), &what));
            }
            lights.photos.push(LitPhoto {
                file_at: file.span(),
                light_at: light.span(),
                file: folder.join(file.into_inner()),
                to_light: light.into_inner(),
                intensity: intensity.map_or(1.0, Spanned::into_inner),
            });
        }
        lights.check()?;
        Ok(lights)
    }

    fn check(&self) -> Result<(), Failure> {
        let lights: Vec<_> = self.photos.iter().map(|photo| (photo.to_light, photo.intensity)).collect();
        check_lights(&lights).map_err(|error| match error {
            PhotometricError::BadLight(photo) => {
                let what = "the light needs a direction of finite numbers that are not all 0";
                self.failure(&self.photos[photo].light_at, what)
            }
            PhotometricError::TooFew(count) => Failure::Work(format!(
                "{}: three or more photographs are needed, each under [[photo]], and {count} are listed: add \
                 more",
                self.path.display()
            )),
            other => Failure::Work(format!("{}: {other}", self.path.display())),
        })?;
        // A light below the surface, or along it, lights nothing that the camera sees.
        match self.photos.iter().find(|photo| photo.to_light[2] <= 0.0) {
            Some(photo) => {
                let what = "the light is not above the surface: its third number, towards the camera, must \
                            be above 0";
                Err(self.failure(&photo.light_at, what))
            }
            None => Ok(()),
        }
    }

    /// Returns a failure about the file of a photograph, with its line in the list.
    pub fn of_photo(&self, photo: usize, what: &str) -> Failure {
        self.failure(&self.photos[photo].file_at, what)
    }

    fn failure(&self, at: &Range<usize>, what: &str) -> Failure {
        let line = self.text[..at.start.min(self.text.len())].matches('\n').count() + 1;
        Failure::Work(format!("{}, line {line}: {what}", self.path.display()))
    }
}

fn read_text(path: &Path) -> Result<String, String> {
    let mut bytes = Vec::new();
    let read = File::open(path).and_then(|file| file.take(MAX_FILE_BYTES + 1).read_to_end(&mut bytes));
    read.map_err(|error| format!("cannot be read: {error}"))?;
    let no_list = "it is no list of lights, which is a short TOML file (--help shows one)";
    if bytes.len() as u64 > MAX_FILE_BYTES {
        return Err(format!("is too long: {no_list}"));
    }
    decode_text(bytes).ok_or_else(|| format!("holds no text: {no_list}"))
}
