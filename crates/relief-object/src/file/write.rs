//! Writing of objects to files.

use std::fmt::Write as _;
use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

use glam::DVec3;
use relief_core::HeightMap;
use relief_io::file_set::{FileSet, FileSetError};
use relief_io::{
    Metadata, PngTexture, WriteError, WriteProblem, linear_to_srgb, read_metadata, write_exr_rows,
    write_png_rows,
};

use super::{Measured, read_description};
use crate::{Captured, CapturedImage, ViewSpec};

/// Name of an object's description.
pub const OBJECT_FILE: &str = "object.toml";

const DEPTH_EXR: &str = "depth.exr";
const DEPTH_PNG: &str = "depth.png";
const COLOR: &str = "color.png";
const NORMAL: &str = "normal.png";
const NORMAL_DEPTH: &str = "normal-depth.png";

/// Why an object cannot be written. No file has changed then.
#[derive(Debug, thiserror::Error)]
pub enum WriteObjectError {
    /// The folder cannot be written into, or a file cannot be replaced.
    #[error(transparent)]
    Set(#[from] FileSetError),
    /// A file with this name exists that was not written by a capture.
    #[error("{}: exists already and was not written by a capture", .0.display())]
    Stranger(PathBuf),
    /// A picture cannot be written.
    #[error(transparent)]
    Picture(#[from] WriteError),
    /// The description cannot be written.
    #[error("{OBJECT_FILE} cannot be written: {0}")]
    Io(#[from] io::Error),
}

/// All possible names of an object's files.
const NAMES: [&str; 6] = [DEPTH_EXR, DEPTH_PNG, COLOR, NORMAL, NORMAL_DEPTH, OBJECT_FILE];

/// Metadata key that marks a captured picture and names its content.
const MARK: &str = "relief.object";

/// Set of an object's files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ObjectFiles {
    /// Bits of a depth: 8, 16 or 32.
    pub bits: u32,
    /// Whether the mesh has colours.
    pub has_colors: bool,
    /// Whether the images are the frames of an octahedral grid.
    pub is_grid: bool,
}

impl ObjectFiles {
    const fn depth(self) -> &'static str {
        if self.bits == 32 { DEPTH_EXR } else { DEPTH_PNG }
    }

    fn color(self) -> Option<&'static str> {
        self.has_colors.then_some(COLOR)
    }

    /// Names of the files, in the order in which they are written.
    pub fn names(self) -> Vec<&'static str> {
        let grid = self.is_grid.then_some(NORMAL_DEPTH);
        [Some(self.depth()), self.color(), Some(NORMAL), grid, Some(OBJECT_FILE)]
            .into_iter()
            .flatten()
            .collect()
    }

    /// Files in a folder that are replaced or removed when this set is written: files with the same
    /// names, and files of an earlier capture.
    pub fn changed(self, folder: &Path) -> Vec<PathBuf> {
        let names = self.names();
        let is_changed = |name: &&str| names.contains(name) || is_captured(folder, name);
        NAMES.into_iter().filter(is_changed).map(|name| folder.join(name)).collect()
    }
}

/// Whether a capture has written a file of a folder: an object's description, pictures named there,
/// and pictures marked by their metadata.
fn is_captured(folder: &Path, name: &str) -> bool {
    let description = || read_description(&folder.join(OBJECT_FILE)).ok();
    if name == OBJECT_FILE {
        return description().is_some();
    }
    let says = read_metadata(&folder.join(name)).is_ok_and(|found| found.get(MARK).is_some());
    says || description().is_some_and(|object| {
        [Some(&object.depth), object.color.as_ref(), object.normal.as_ref()]
            .into_iter()
            .flatten()
            .any(|named| named == Path::new(name))
    })
}

/// A folder into which an object is written, completely or not at all.
#[derive(Debug)]
pub struct ObjectWriter {
    folder: PathBuf,
    files: ObjectFiles,
    set: FileSet,
    force: bool,
}

/// Positions of the images in the pictures, in rows of `columns` images.
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

    /// Fills a row with values computed from image and texel; 0 where there is no image.
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
    /// Begins to write into a folder, which is created if it is missing. While another process
    /// writes there, `wait` is called every few milliseconds with the time since the beginning. It
    /// returns whether to wait any longer.
    ///
    /// With `force`, files that no capture has written are replaced.
    ///
    /// # Errors
    ///
    /// When the folder cannot be written into, a file of another program would be replaced, or
    /// `wait` returns false.
    pub fn open(
        folder: &Path,
        files: ObjectFiles,
        force: bool,
        wait: &mut dyn FnMut(Duration) -> bool,
    ) -> Result<Self, WriteObjectError> {
        let set = FileSet::open(folder, "object", wait)?;
        let mut writer = Self { folder: folder.to_owned(), files, set, force };
        for name in files.names() {
            writer.check(name)?;
        }
        Ok(writer)
    }

    /// Checks that a file with this name can be written, and was not written by another program.
    fn check(&mut self, name: &str) -> Result<(), WriteObjectError> {
        let path = self.folder.join(name);
        self.set.check(&path)?;
        if self.force || !path.exists() || is_captured(&self.folder, name) {
            return Ok(());
        }
        Err(WriteObjectError::Stranger(path))
    }

    /// Writes the captured images, and the measured differences from the mesh if there are any.
    /// Returns the files. All of them get their final names at the end. Files of an earlier capture
    /// that are not in this set are removed.
    ///
    /// * `object.toml`, which [`read_object`](crate::read_object) reads;
    /// * `depth.exr` of 32-bit floats, or `depth.png` of 8 or 16 bits;
    /// * `color.png`, if the mesh has colours: 8 bits in sRGB, with an opacity of 0 for texels that
    ///   show nothing;
    /// * `normal.png`: 8 bits if depths have 8, otherwise 16;
    /// * `normal-depth.png` for octahedral grids, as the impostors of game engines use it. It has 8
    ///   bits of the normal in the mesh's axes in red, green and blue, and of the height in the
    ///   opacity. `color.png` has the same frames.
    ///
    /// Images are placed side by side without gaps. The frames of a grid keep their order, the
    /// first in the upper left corner. Other images form rows; there are about as many rows as
    /// images per row.
    ///
    /// # Errors
    ///
    /// When a file cannot be written or replaced, the captured images need other files than
    /// declared, or the pictures are too large.
    pub fn write(
        mut self,
        captured: &Captured,
        measured: Option<&Measured>,
    ) -> Result<Vec<PathBuf>, WriteObjectError> {
        let images = captured.images.as_slice();
        let side = images.first().map_or(1, |image| image.heights.width());
        let columns = captured.grid.unwrap_or_else(|| (images.len() as f64).sqrt().ceil() as u32).max(1);
        let sheet = Sheet { images, columns, side };
        if captured.files() != self.files {
            let what = io::Error::new(
                io::ErrorKind::InvalidInput,
                "the captured images need other files than declared",
            );
            return Err(what.into());
        }
        let names = self.files.names();
        // Files that belong to no object may have any owner.
        let others = NAMES.into_iter().filter(|name| !names.contains(name));
        let left: Vec<&str> = others.filter(|name| is_captured(&self.folder, name)).collect();
        let mut files = Vec::new();
        for name in names.iter().copied().filter(|name| *name != OBJECT_FILE) {
            // The file may have appeared since the first check.
            self.check(name)?;
            let place = self.folder.join(name);
            let aside = self.set.put(&place)?;
            let [width, height] = sheet.size();
            let png = |channels: usize, bits: u32| PngTexture { width, height, channels, bits };
            let mark = mark(name).map_err(|problem| WriteError { path: place.clone(), problem })?;
            match name {
                DEPTH_EXR => write_exr_rows(&aside, width, height, &["Y"], &mark, &mut |row, texels| {
                    sheet.row(row.row, texels, |image, at| images[image].heights.texels()[at]);
                    Ok(())
                }),
                DEPTH_PNG => write_png_rows(&aside, &png(1, captured.bits), &mark, &mut |row, texels| {
                    sheet.row(row.row, texels, |image, at| images[image].heights.texels()[at]);
                    Ok(())
                }),
                COLOR => write_png_rows(&aside, &png(4, 8), &mark, &mut |row, texels| {
                    sheet.row(row.row, texels, |image, at| color_of(&images[image], row.channel, at));
                    Ok(())
                }),
                NORMAL => {
                    let bits = if captured.bits == 8 { 8 } else { 16 };
                    write_png_rows(&aside, &png(3, bits), &mark, &mut |row, texels| {
                        let part = |image: usize, at: usize| images[image].normals[at][row.channel];
                        sheet.row(row.row, texels, |image, at| 0.5 * part(image, at) + 0.5);
                        Ok(())
                    })
                }
                _ => write_png_rows(&aside, &png(4, 8), &mark, &mut |row, texels| {
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
        self.check(OBJECT_FILE)?;
        let place = self.folder.join(OBJECT_FILE);
        let text = text(captured, measured, &sheet, self.files.depth(), self.files.color());
        std::fs::write(self.set.put(&place)?, text)?;
        files.push(place);
        left.into_iter().try_for_each(|name| self.set.remove(name))?;
        self.set.commit()?;
        Ok(files)
    }
}

/// Metadata of a picture of an object.
fn mark(name: &str) -> Result<Metadata, WriteProblem> {
    let generator = concat!("relief ", env!("CARGO_PKG_VERSION"));
    let holds = name.split('.').next().unwrap_or_default();
    Metadata::new(
        [(MARK, holds), ("relief.generator", generator)]
            .map(|(key, value)| (key.into(), value.into()))
            .into(),
    )
}

/// Component of the colour in sRGB, or the opacity.
fn color_of(image: &CapturedImage, channel: usize, at: usize) -> f32 {
    match (channel, &image.colors) {
        (3, _) => f32::from(image.heights.texels()[at] > 0.0),
        (_, Some(colors)) => linear_to_srgb(f64::from(colors[at][channel])) as f32,
        (_, None) => 0.0,
    }
}

/// Normal in the axes of the mesh.
fn in_space(captured: &Captured, image: usize, at: usize) -> DVec3 {
    let [right, down, toward] = captured.views[image].axes();
    let [x, y, z] = captured.images[image].normals[at].map(f64::from);
    right * x - down * y + toward * z
}

fn vector(at: DVec3) -> String {
    // Adding 0 removes the minus sign of a negative zero.
    let [x, y, z] = at.to_array().map(|part| part + 0.0);
    format!("[{x}, {y}, {z}]")
}

/// Text of the description. Numbers are written with the fewest digits that restore them exactly.
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
    // Writing into a string cannot fail.
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
        "# Compared with the mesh in {views} pictures of {size} x {size} pixels. 'iou': pixels that show \
         both,\n\
         # divided by pixels that show either. 'depth-error': mean distance where both are visible, in\n\
         # percent of the ball's diameter.\n\
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

/// Checks that the pictures of `count` images with this side are not too large.
///
/// # Errors
///
/// When they are larger than a height map may be.
pub fn check_sheet(count: usize, grid: Option<u32>, side: u32) -> Result<(), relief_core::HeightMapError> {
    let columns = grid.unwrap_or_else(|| (count as f64).sqrt().ceil() as u32).max(1);
    let rows = (count as u32).div_ceil(columns);
    HeightMap::check_size(columns.saturating_mul(side), rows.saturating_mul(side))
}
