//! Files that a viewer saves. Their bytes are the same that `relief render` writes.

use std::io::{self, Cursor};

use relief_core::{Cancelled, Watch};
use relief_io::{
    LineSink, Metadata, PictureFormat, PictureSink, WriteProblem, encode_exr_lines, encode_picture,
};
use relief_render::picture::{AOV_CHANNELS, Display, aov_of, srgb};
use relief_scene::tone::Tone;
use relief_scene::{Scene, SceneSpec};
use relief_shaders::cpu::PixelOut;
use serde_json::{Value, json};

use crate::{Drawing, NotDrawn};

/// A file that can be saved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Saved {
    /// The picture.
    Picture(PictureFormat),
    /// Values of each pixel besides its colour, as EXR.
    Aov,
    /// The scene, as TOML.
    Scene,
}

/// Name and label of each file.
const ALL: [(&str, &str, Saved); 5] = [
    ("picture.png", "Picture, PNG", Saved::Picture(PictureFormat::Png8)),
    ("picture.jpg", "Picture, JPEG", Saved::Picture(PictureFormat::Jpeg)),
    ("picture.exr", "Picture in linear light, EXR", Saved::Picture(PictureFormat::Exr)),
    ("aov.exr", "Hits, positions, normals and costs (AOVs), EXR", Saved::Aov),
    ("scene.toml", "Scene, TOML", Saved::Scene),
];

/// Reason why a file cannot be saved.
#[derive(Debug, thiserror::Error)]
pub enum SaveError {
    /// No file has this name.
    #[error("'{0}' is nothing that can be saved")]
    Unknown(String),
    /// There is no such view.
    #[error("there is no view {0}")]
    NoView(usize),
    /// The scene has a tone curve, and the file linear light.
    #[error("an EXR holds linear light, without a tone curve: leave tone out")]
    Tone,
    /// There is no picture.
    #[error(transparent)]
    NotDrawn(#[from] NotDrawn),
    /// The picture cannot be written in this format.
    #[error(transparent)]
    Write(#[from] WriteProblem),
}

impl Saved {
    /// Returns the files that can be saved, as JSON: their names and labels, and whether they are of one
    /// view.
    pub fn offered() -> Vec<Value> {
        let each = ALL.iter().map(|(what, label, saved)| {
            json!({ "what": what, "label": label, "of_surface": false, "of_view": *saved != Saved::Scene })
        });
        each.collect()
    }

    /// Returns the file with this name.
    ///
    /// # Errors
    ///
    /// When there is none.
    pub fn named(what: &str) -> Result<Self, SaveError> {
        let known = ALL.iter().find(|(known, ..)| *known == what);
        known.map(|(.., saved)| *saved).ok_or_else(|| SaveError::Unknown(what.to_owned()))
    }
}

impl Drawing {
    /// Returns the bytes of a picture in a format.
    ///
    /// # Errors
    ///
    /// See [`Drawing::draw`]. Also when the format cannot hold the picture.
    pub async fn picture(
        &mut self,
        spec: &SceneSpec,
        format: PictureFormat,
        watch: &Watch<'_>,
    ) -> Result<Vec<u8>, SaveError> {
        if format.is_linear() && spec.tone.is_some_and(|tone| tone != Tone::None) {
            return Err(SaveError::Tone);
        }
        let scene = self.load(spec).map_err(NotDrawn::from)?;
        let display = Display::of(&scene);
        let display = if format.is_linear() { display.without_tone() } else { display };
        let mut out = Cursor::new(Vec::new());
        self.written(&scene, false, watch, |render| {
            encode_picture(&mut out, scene.size(), format, |sink: &mut PictureSink<'_>| {
                render(&mut |row, line| {
                    let mut colours = display.linear_row(row, line);
                    if !format.is_linear() {
                        let shown = |colour: [f32; 3]| srgb(colour.map(|part| part.clamp(0.0, 1.0)));
                        colours.iter_mut().for_each(|colour| *colour = shown(*colour));
                    }
                    sink(&colours)
                })
            })
        })
        .await?;
        Ok(out.into_inner())
    }

    /// Returns the bytes of the file of all values of the pixels.
    ///
    /// # Errors
    ///
    /// See [`Drawing::draw`].
    pub async fn aov(&mut self, spec: &SceneSpec, watch: &Watch<'_>) -> Result<Vec<u8>, SaveError> {
        let scene = self.load(spec).map_err(NotDrawn::from)?;
        let mut out = Cursor::new(Vec::new());
        self.written(&scene, true, watch, |render| {
            let metadata = Metadata::default();
            encode_exr_lines(&mut out, scene.size(), &AOV_CHANNELS, &metadata, |sink: &mut LineSink<'_>| {
                let mut planes = AOV_CHANNELS.map(|_| Vec::new());
                render(&mut |_, line| {
                    planes.iter_mut().for_each(Vec::clear);
                    for pixel in line {
                        planes.iter_mut().zip(aov_of(pixel)).for_each(|(plane, number)| plane.push(number));
                    }
                    sink(&planes.each_ref().map(Vec::as_slice))
                })
            })
        })
        .await?;
        Ok(out.into_inner())
    }

    /// Runs an encoder, which gets a function that renders the rows for it. Of two errors the renderer's is
    /// the cause. A GPU renders the whole picture first, since an encoder does not wait.
    async fn written(
        &mut self,
        scene: &Scene,
        numbers: bool,
        watch: &Watch<'_>,
        encode: impl FnOnce(&mut Render<'_>) -> Result<(), WriteProblem>,
    ) -> Result<(), SaveError> {
        let whole = match self.draws_on_cpu(scene) {
            true => None,
            false => Some(self.pixels(scene, numbers, watch).await?),
        };
        let mut not_drawn = None;
        let encoded = encode(&mut |sink| {
            let mut failed = None;
            let (width, mut next) = (scene.size()[0].max(1) as usize, 0);
            let mut rows = |band: &[PixelOut]| {
                band.chunks(width).try_for_each(|line| {
                    next += 1;
                    sink(next - 1, line).map_err(|error| {
                        failed = Some(error);
                        Cancelled
                    })
                })
            };
            let rendered = match &whole {
                Some(pixels) => rows(pixels).map_err(NotDrawn::from),
                None => self.bands_on_cpu(scene, numbers, watch, &mut rows),
            };
            match (failed, rendered) {
                (Some(error), _) => Err(error),
                (None, Ok(())) => Ok(()),
                (None, Err(error)) => {
                    not_drawn = Some(error);
                    Err(io::ErrorKind::Interrupted.into())
                }
            }
        });
        match not_drawn {
            Some(error) => Err(error.into()),
            None => Ok(encoded?),
        }
    }
}

/// Receiver of a row of pixels with its number.
type Sink<'a> = dyn FnMut(u32, &[PixelOut]) -> io::Result<()> + 'a;

/// Function that renders into a receiver.
type Render<'a> = dyn FnMut(&mut Sink<'_>) -> io::Result<()> + 'a;

/// Returns the scene of one of the views, from 0 on.
///
/// # Errors
///
/// When there is no such view.
pub fn of_view(spec: &SceneSpec, view: usize) -> Result<SceneSpec, SaveError> {
    let found = spec.views().into_iter().nth(view);
    found.map(|(_, spec)| spec).ok_or(SaveError::NoView(view))
}
