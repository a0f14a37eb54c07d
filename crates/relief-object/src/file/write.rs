//! Objects to files.

use std::fmt::Write as _;
use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

use glam::DVec3;
use relief_core::HeightMap;
use relief_io::file_set::{FileSet, FileSetError};
use relief_io::{Metadata, PngTexture, WriteError, linear_to_srgb, write_exr_rows, write_png_rows};

use super::Measured;
use crate::{Captured, CapturedImage, ViewSpec};

/// The name of an object's description.
pub const OBJECT_FILE: &str = "object.toml";

const DEPTH_EXR: &str = "depth.exr";
const DEPTH_PNG: &str = "depth.png";
const COLOR: &str = "color.png";
const NORMAL: &str = "normal.png";
const NORMAL_DEPTH: &str = "normal-depth.png";

/// Why an object cannot be written. Nothing has changed then.
#[derive(Debug, thiserror::Error)]
pub enum WriteObjectError {
    /// The folder cannot be written into, or a file cannot be replaced.
    #[error(transparent)]
    Set(#[from] FileSetError),
    /// A picture cannot be written.
    #[error(transparent)]
    Picture(#[from] WriteError),
    /// The description cannot be written.
    #[error("{OBJECT_FILE} cannot be written: {0}")]
    Io(#[from] io::Error),
}

/// A folder that an object is written into, as a whole or not at all.
#[derive(Debug)]
pub struct ObjectWriter {
    folder: PathBuf,
    set: FileSet,
}

/// Where images lie in the pictures: so many side by side.
struct Sheet<'a> {
    images: &'a [CapturedImage],
    columns: u32,
    side: u32,
}

impl Sheet<'_> {
    fn size(&self) -> [u32; 2] {
        let rows = (self.images.len() as u32).div_ceil(self.columns);
        [self.columns * self.side, rows * self.side]
    }

    fn place(&self, image: usize) -> [u32; 2] {
        let image = image as u32;
        [image % self.columns * self.side, image / self.columns * self.side]
    }

    /// Fills a row with what is asked for by image and texel; 0 where there is no image.
    fn row(&self, row: u32, texels: &mut [f32], of: impl Fn(usize, usize) -> f32) {
        let (line, inner) = (row / self.side, (row % self.side) as usize);
        let side = self.side as usize;
        for (column, part) in texels.chunks_exact_mut(side).enumerate() {
            let image = line as usize * self.columns as usize + column;
            for (x, texel) in part.iter_mut().enumerate() {
                *texel = if image < self.images.len() { of(image, inner * side + x) } else { 0.0 };
            }
        }
    }
}

impl ObjectWriter {
    /// Begins to write into a folder, which is made if it is missing. While another process writes there,
    /// `wait` is asked every few milliseconds whether to go on waiting, with the time since the beginning.
    ///
    /// # Errors
    ///
    /// When the folder cannot be written into, or `wait` says no.
    pub fn open(folder: &Path, wait: &mut dyn FnMut(Duration) -> bool) -> Result<Self, WriteObjectError> {
        let mut set = FileSet::open(folder, "object", wait)?;
        for name in [OBJECT_FILE, DEPTH_EXR, DEPTH_PNG, COLOR, NORMAL, NORMAL_DEPTH] {
            set.check(&folder.join(name))?;
        }
        Ok(Self { folder: folder.to_owned(), set })
    }

    /// Writes what was captured, with how far it is from the mesh where that was measured, and returns the
    /// files. All of them get their names at the end. Of an object that was in the folder nothing is left.
    ///
    /// * `object.toml`, which [`read_object`](crate::read_object) reads;
    /// * `depth.exr` of 32-bit floats, or `depth.png` of 8 or 16 bits;
    /// * `color.png`, where the mesh has colours: 8 bits in sRGB, with an opacity of 0 where nothing is seen;
    /// * `normal.png`: 8 bits where depths have as many, else 16;
    /// * `normal-depth.png` of octahedral grids, as impostors of engines have it: 8 bits of the normal in the
    ///   axes of the mesh in red, green and blue, and of the height in the opacity. `color.png` has the same
    ///   frames.
    ///
    /// Images lie side by side without gaps: of a grid as its frames do, the first in the upper left corner;
    /// others in rows, about as many as there are in each.
    ///
    /// # Errors
    ///
    /// When a file cannot be written or replaced, or the pictures are larger than they may be.
    pub fn write(
        mut self,
        captured: &Captured,
        measured: Option<&Measured>,
    ) -> Result<Vec<PathBuf>, WriteObjectError> {
        let images = captured.images.as_slice();
        let side = images.first().map_or(1, |image| image.heights.width());
        let columns = captured.grid.unwrap_or_else(|| (images.len() as f64).sqrt().ceil() as u32).max(1);
        let sheet = Sheet { images, columns, side };
        let depth = if captured.bits == 32 { DEPTH_EXR } else { DEPTH_PNG };
        let color = images.iter().all(|image| image.colors.is_some()).then_some(COLOR);
        let grid = captured.grid.map(|_| NORMAL_DEPTH);
        let names = [Some(depth), color, Some(NORMAL), grid];
        let mut files = Vec::new();
        for name in names.into_iter().flatten() {
            let place = self.folder.join(name);
            let aside = self.set.put(&place)?;
            let [width, height] = sheet.size();
            let png = |channels: usize, bits: u32| PngTexture { width, height, channels, bits };
            let none = Metadata::default();
            match name {
                DEPTH_EXR => write_exr_rows(&aside, width, height, &["Y"], &none, &mut |row, texels| {
                    sheet.row(row.row, texels, |image, at| images[image].heights.texels()[at]);
                    Ok(())
                }),
                DEPTH_PNG => write_png_rows(&aside, &png(1, captured.bits), &none, &mut |row, texels| {
                    sheet.row(row.row, texels, |image, at| images[image].heights.texels()[at]);
                    Ok(())
                }),
                COLOR => write_png_rows(&aside, &png(4, 8), &none, &mut |row, texels| {
                    sheet.row(row.row, texels, |image, at| color_of(&images[image], row.channel, at));
                    Ok(())
                }),
                NORMAL => {
                    let bits = if captured.bits == 8 { 8 } else { 16 };
                    write_png_rows(&aside, &png(3, bits), &none, &mut |row, texels| {
                        let part = |image: usize, at: usize| images[image].normals[at][row.channel];
                        sheet.row(row.row, texels, |image, at| 0.5 * part(image, at) + 0.5);
                        Ok(())
                    })
                }
                _ => write_png_rows(&aside, &png(4, 8), &none, &mut |row, texels| {
                    sheet.row(row.row, texels, |image, at| match row.channel {
                        3 => images[image].heights.texels()[at],
                        axis => 0.5 * in_space(captured, image, at)[axis] as f32 + 0.5,
                    });
                    Ok(())
                }),
            }
            .map_err(|error| WriteError { path: place.clone(), problem: error.problem })?;
            files.push(place);
        }
        let place = self.folder.join(OBJECT_FILE);
        let text = text(captured, measured, &sheet, depth, color);
        std::fs::write(self.set.put(&place)?, text)?;
        files.push(place.clone());
        // What belongs to no object may be anybody's.
        if place.is_file() {
            let others = [DEPTH_EXR, DEPTH_PNG, COLOR, NORMAL, NORMAL_DEPTH];
            for name in others.into_iter().filter(|name| !names.contains(&Some(name))) {
                self.set.remove(name)?;
            }
        }
        self.set.commit()?;
        Ok(files)
    }
}

/// A part of the colour in sRGB, or the opacity.
fn color_of(image: &CapturedImage, channel: usize, at: usize) -> f32 {
    match (channel, &image.colors) {
        (3, _) => f32::from(image.heights.texels()[at] > 0.0),
        (_, Some(colors)) => linear_to_srgb(f64::from(colors[at][channel])) as f32,
        (_, None) => 0.0,
    }
}

/// A normal in the axes of the mesh.
fn in_space(captured: &Captured, image: usize, at: usize) -> DVec3 {
    let [right, down, toward] = captured.views[image].axes();
    let [x, y, z] = captured.images[image].normals[at].map(f64::from);
    right * x - down * y + toward * z
}

fn vector(at: DVec3) -> String {
    // There is no minus before a zero.
    let [x, y, z] = at.to_array().map(|part| part + 0.0);
    format!("[{x}, {y}, {z}]")
}

/// The description. Numbers are the shortest that are read as the same.
fn text(
    captured: &Captured,
    measured: Option<&Measured>,
    sheet: &Sheet,
    depth: &str,
    color: Option<&str>,
) -> String {
    let (centre, radius) = captured.views.first().map_or((DVec3::ZERO, 1.0), relief_core::object::View::ball);
    let mut text = format!(
        "kind = \"{}\"\ncentre = {}\nradius = {radius}\ndepth = \"{depth}\"\n",
        captured.kind(),
        vector(centre)
    );
    // Writing into a text cannot fail.
    if let Some(color) = color {
        let _ = writeln!(text, "color = \"{color}\"");
    }
    let _ = writeln!(text, "normal = \"{NORMAL}\"");
    for (number, spec) in captured.specs.iter().enumerate() {
        let _ = writeln!(text, "\n[[view]]");
        let up = match *spec {
            ViewSpec::Orthographic { from, up } => {
                let _ = writeln!(text, "from = {}", vector(from));
                up
            }
            ViewSpec::Perspective { eye, up, fov_degrees } => {
                let _ = writeln!(text, "eye = {}\nfov = {fov_degrees}", vector(eye));
                up
            }
        };
        if let Some(up) = up {
            let _ = writeln!(text, "up = {}", vector(up));
        }
        let [x, y] = sheet.place(number);
        let _ = writeln!(text, "rect = [{x}, {y}, {}, {}]", sheet.side, sheet.side);
    }
    if let Some(measured) = measured {
        let _ = write!(text, "\n{}", measured_text(measured));
    }
    text
}

fn measured_text(measured: &Measured) -> String {
    let Measured { views, size, cells, jump_texels, iou, worst_from, worst_iou, .. } = *measured;
    let mut text = format!(
        "# Beside the mesh, over so many views of so many pixels a side: pixels that show both of those that \
         show\n# either, and the mean distance where both are seen in percent of the ball's diameter.\n\
         [measured]\nviews = {views}\nsize = {size}\ncells = \"{cells}\"\njump = {jump_texels}\niou = {iou}\n"
    );
    if let Some(error) = measured.depth_error_percent {
        let _ = writeln!(text, "depth-error = {error}");
    }
    let _ = writeln!(text, "worst-from = {}\nworst-iou = {worst_iou}", vector(worst_from));
    if let Some(error) = measured.worst_depth_error_percent {
        let _ = writeln!(text, "worst-depth-error = {error}");
    }
    text
}

/// Whether the pictures of so many images of that side can be.
///
/// # Errors
///
/// When they are larger than a height map may be.
pub fn check_sheet(count: usize, grid: Option<u32>, side: u32) -> Result<(), relief_core::HeightMapError> {
    let columns = grid.unwrap_or_else(|| (count as f64).sqrt().ceil() as u32).max(1);
    let rows = (count as u32).div_ceil(columns);
    HeightMap::check_size(columns.saturating_mul(side), rows.saturating_mul(side))
}
