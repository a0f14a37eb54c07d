//! Capture of a mesh into images with depth, by exact ray casting.

mod appearance;
mod cover;
mod error;
mod gutter;
mod highest;

use std::sync::atomic::{AtomicU64, Ordering};

use glam::DVec3;
use rayon::prelude::*;
use relief_core::camera::Ray;
use relief_core::mesh::Mesh;
use relief_core::object::{EMPTY_HEIGHT, ImageObject, JumpCells, MAX_VIEWS, ObjectError, View, ViewError};
use relief_core::raycast::{RayCaster, Sides, SurfaceHit};
use relief_core::{Cancelled, HeightMap, Watch, Wrap};
use relief_io::{DEFAULT_MAX_BYTES, MeshColors};

use self::appearance::VisiblePoint;
pub use self::cover::Cover;
pub use self::error::CaptureError;
use self::highest::Highest;
use crate::arrangement::MAX_GRID;
use crate::file::check_sheet;
use crate::verify::{self, Verification};
use crate::{Arrangement, Measured, ObjectFiles, ViewKind, ViewSpec};

/// Least side of an image, in texels.
pub const MIN_IMAGE_SIDE: u32 = 8;
/// Longest side of an image, in texels.
pub const MAX_IMAGE_SIDE: u32 = 16_384;

/// Settings of a capture.
#[derive(Clone, Debug, PartialEq)]
pub struct CaptureSettings {
    /// Directions of the views.
    pub arrangement: Arrangement,
    /// Field of view in degrees, for perspective images whose eyes are as far away as necessary.
    /// `None` for parallel rays.
    pub fov_degrees: Option<f64>,
    /// Texels of a side of each image, from [`MIN_IMAGE_SIDE`] to [`MAX_IMAGE_SIDE`].
    pub size: u32,
    /// Bits of a depth: 8 or 16 for integers, 32 for floats.
    pub bits: u32,
    /// Most memory that the capture may take, in bytes, including the ray caster of the mesh.
    pub max_bytes: u64,
}

impl Default for CaptureSettings {
    /// Returns settings for six images of 209 x 209 texels along the axes, with parallel rays, in
    /// floats.
    fn default() -> Self {
        Self {
            arrangement: Arrangement::default(),
            fov_degrees: None,
            size: 209,
            bits: 32,
            max_bytes: DEFAULT_MAX_BYTES,
        }
    }
}

/// Memory per texel in bytes. It counts the visible points while images are captured, of all images
/// if there are many threads. It also counts heights, colours and normals for both covers, and the
/// heights of the object.
const BYTES_PER_TEXEL: u64 = 256;

/// A mesh prepared for capture.
pub struct Capturer<'a> {
    mesh: &'a Mesh,
    colors: Option<&'a MeshColors>,
    caster: RayCaster,
    settings: CaptureSettings,
    specs: Vec<ViewSpec>,
    views: Vec<View>,
}

/// Captured images with depth of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Captured {
    /// Point of the mesh whose height a texel stores.
    pub cover: Cover,
    /// Bits of a depth.
    pub bits: u32,
    /// Frames per side, if the images form an octahedral grid.
    pub grid: Option<u32>,
    /// Specification of each view.
    pub specs: Vec<ViewSpec>,
    /// Views of the images.
    pub views: Vec<View>,
    /// The images.
    pub images: Vec<CapturedImage>,
    /// Number of texels in all images that show something.
    pub seen: u64,
    /// Number of texels that show the back of a triangle.
    pub backs: u64,
}

/// An image with depth.
#[derive(Clone, Debug, PartialEq)]
pub struct CapturedImage {
    /// Heights as they are stored; 0 for texels that show nothing.
    pub heights: HeightMap,
    /// Linear colours, row by row from the top. They are extrapolated beyond the visible part.
    /// `None` for a mesh without colours.
    pub colors: Option<Vec<[f32; 3]>>,
    /// Unit normals: `x` to the right, `y` up, `z` toward the viewer. They are extrapolated beyond
    /// the visible part.
    pub normals: Vec<[f32; 3]>,
}

impl<'a> Capturer<'a> {
    /// Prepares a mesh for capture, with its colours if it has any.
    ///
    /// All images show a ball around the middle of the mesh's bounding box. The ball holds the mesh
    /// and a texel more on each side.
    ///
    /// # Errors
    ///
    /// When there are no views or too many, images are too small or too large, or more memory is
    /// needed than allowed. Also when a view is impossible or does not show all of the mesh.
    pub fn new(
        mesh: &'a Mesh,
        colors: Option<&'a MeshColors>,
        settings: CaptureSettings,
    ) -> Result<Self, CaptureError> {
        let size = settings.size;
        if !(MIN_IMAGE_SIDE..=MAX_IMAGE_SIDE).contains(&size) {
            return Err(CaptureError::BadSize(size));
        }
        if let Some(grid) = settings.arrangement.grid().filter(|grid| !(2..=MAX_GRID).contains(grid)) {
            return Err(CaptureError::BadGrid(grid));
        }
        if ![8, 16, 32].contains(&settings.bits) {
            return Err(CaptureError::BadBits(settings.bits));
        }
        let count = settings.arrangement.count();
        if count == 0 || count > MAX_VIEWS {
            return Err(CaptureError::BadCount(count));
        }
        let texels = count as u64 * u64::from(size) * u64::from(size);
        let triangles = mesh.triangles().len() as u64;
        let needed = texels * BYTES_PER_TEXEL + triangles * RayCaster::BYTES_PER_TRIANGLE;
        if needed > settings.max_bytes {
            let limit = settings.max_bytes;
            return Err(CaptureError::TooMuchMemory { views: count, size, needed, limit });
        }
        check_sheet(count, settings.arrangement.grid(), size)?;
        let (centre, radius) = ball(mesh, size);
        let specs = specs(&settings, centre, radius)?;
        let view = |(number, spec): (usize, &ViewSpec)| {
            let view = spec.view(centre, radius, [size, size]);
            view.map_err(|problem| CaptureError::View { number: number + 1, problem })
        };
        let views = specs.iter().enumerate().map(view).collect::<Result<Vec<_>, _>>()?;
        let shows = |view: &View| {
            let inside = |place: DVec3| [place.x, place.y].iter().all(|at| (0.0..=1.0).contains(at));
            mesh.vertices().par_iter().all(|vertex| view.see(vertex.position.as_dvec3()).is_some_and(inside))
        };
        if let Some(at) = views.iter().position(|view| !shows(view)) {
            return Err(CaptureError::CutOff { number: at + 1 });
        }
        Ok(Self { mesh, colors, caster: RayCaster::new(mesh), settings, specs, views })
    }

    /// Centre of the ball that all images show, and its radius in metres.
    pub fn ball(&self) -> (DVec3, f64) {
        self.views.first().map_or((DVec3::ZERO, 1.0), View::ball)
    }

    /// Returns the names of the files that such an object has, and what they hold. Nothing is written.
    pub fn files(&self) -> ObjectFiles {
        ObjectFiles {
            bits: self.settings.bits,
            has_colors: self.colors.is_some(),
            is_grid: self.settings.arrangement.grid().is_some(),
        }
    }

    /// Views of the images.
    pub fn views(&self) -> &[View] {
        &self.views
    }

    /// Captures the images.
    ///
    /// Heights are exact except for rounding to the stored format: to the nearest, or up with
    /// [`Cover::Pixel`]. Both sides of triangles are visible. A texel has the colour and the normal
    /// of the point at its centre, or of its highest point if the centre shows nothing. Parts
    /// outside a material's mask are invisible. For triangles with a mask the centres decide, with
    /// either cover.
    ///
    /// # Errors
    ///
    /// When the work is cancelled.
    pub fn capture(&self, cover: Cover, watch: &Watch) -> Result<Captured, CaptureError> {
        let (done, backs) = (AtomicU64::new(0), AtomicU64::new(0));
        let image = |view: &View| {
            let (image, of_backs) = self.image(view, cover, watch)?;
            backs.fetch_add(of_backs, Ordering::Relaxed);
            let part = done.fetch_add(1, Ordering::Relaxed) + 1;
            watch.at(part as f32 / self.views.len() as f32)?;
            Ok(image)
        };
        let images = self.views.par_iter().map(image).collect::<Result<Vec<_>, CaptureError>>()?;
        let of_image = |image: &CapturedImage| image.heights.texels().iter().filter(|h| **h > 0.0).count();
        Ok(Captured {
            cover,
            bits: self.settings.bits,
            grid: self.settings.arrangement.grid(),
            specs: self.specs.clone(),
            views: self.views.clone(),
            seen: images.iter().map(|image| of_image(image) as u64).sum(),
            images,
            backs: backs.into_inner(),
        })
    }

    /// Compares the captured images with the mesh. `None` if no picture is requested.
    ///
    /// # Errors
    ///
    /// When the jump is negative or NaN, pictures are too many or too large, or the work is
    /// cancelled.
    pub fn verify(
        &self,
        captured: &Captured,
        verification: &Verification,
        watch: &Watch,
    ) -> Result<Option<Measured>, CaptureError> {
        let object = captured.object(verification.cells, verification.jump_texels)?;
        verify::measure(
            &|ray| self.first_visible(ray).map(|hit| hit.t),
            &object,
            self.ball(),
            verification,
            watch,
        )
    }

    /// Captures an image. Also returns the number of its texels that show backs.
    fn image(&self, view: &View, cover: Cover, watch: &Watch) -> Result<(CapturedImage, u64), CaptureError> {
        let [columns, rows] = view.size();
        let row = |y: u32| -> Result<_, Cancelled> {
            watch.check()?;
            Ok((0..columns).map(|x| self.centre(view, x, y)).collect::<Vec<_>>())
        };
        let lines = (0..rows).into_par_iter().map(row).collect::<Result<Vec<_>, _>>()?;
        let mut seen: Vec<Option<(f64, VisiblePoint)>> = lines.into_iter().flatten().collect();
        if cover == Cover::Pixel {
            let texels = DVec3::new(f64::from(columns), f64::from(rows), 1.0);
            let corners = (0..self.mesh.triangles().len() as u32).map(|triangle| {
                let corners = self.mesh.corners(triangle).map(|corner| corner.position.as_dvec3());
                // All of the mesh is in front of the eye.
                corners.map(|corner| view.see(corner).unwrap_or_default() * texels)
            });
            let mut raised: Vec<Option<Highest>> = vec![None; seen.len()];
            // Triangles with a mask are decided at the centres: their highest point may be masked
            // out.
            let has_mask = |triangle: u32| self.colors.is_some_and(|colors| colors.has_mask(triangle));
            highest::raise([columns, rows], corners, has_mask, &mut raised);
            watch.check()?;
            for (texel, highest) in seen.iter_mut().zip(raised) {
                let Some(Highest { at, triangle }) = highest else { continue };
                match texel {
                    Some((height, _)) => *height = height.max(at.z),
                    None => *texel = Some((at.z, self.beside(view, at / texels, triangle))),
                }
            }
        }
        let backs = seen.iter().flatten().filter(|(_, point)| !point.front).count() as u64;
        let heights = seen.iter().map(|texel| texel.map_or(0.0, |(height, _)| self.stored(height, cover)));
        let heights = HeightMap::new(columns, rows, heights.collect(), Wrap::Clamp)?;
        let known: Vec<bool> = seen.iter().map(Option::is_some).collect();
        let fill = |empty: [f32; 3], of: &(dyn Fn(&VisiblePoint) -> [f32; 3] + Sync)| {
            let value =
                |texel: &Option<(f64, VisiblePoint)>| texel.as_ref().map_or(empty, |(_, point)| of(point));
            let mut values: Vec<[f32; 3]> = seen.par_iter().map(value).collect();
            gutter::fill(columns as usize, &mut values, known.clone());
            values
        };
        let colors = self.colors.map(|colors| fill([0.0; 3], &|point| point.color(self.mesh, colors)));
        let mut normals = fill([0.0, 0.0, 1.0], &|point| point.normal(self.mesh, view));
        normals.par_iter_mut().for_each(|normal| *normal = appearance::unit(*normal));
        Ok((CapturedImage { heights, colors, normals }, backs))
    }

    /// Height and point of the first hit of the ray through a texel's centre.
    fn centre(&self, view: &View, x: u32, y: u32) -> Option<(f64, VisiblePoint)> {
        let [columns, rows] = view.size().map(f64::from);
        let ray = view.ray((f64::from(x) + 0.5) / columns, (f64::from(y) + 0.5) / rows);
        let hit = self.first_visible(&ray)?;
        let point = VisiblePoint::of_hit(&hit);
        Some((view.see(ray.at(hit.t))?.z, point))
    }

    /// First visible hit of a ray.
    fn first_visible(&self, ray: &Ray) -> Option<SurfaceHit> {
        let is_visible = |hit: &SurfaceHit| {
            self.colors.is_none_or(|colors| VisiblePoint::of_hit(hit).is_visible(self.mesh, colors))
        };
        self.caster.hits(ray, Sides::Both).find(is_visible)
    }

    /// Point of a triangle at texture coordinates and height in a view.
    fn beside(&self, view: &View, at: DVec3, triangle: u32) -> VisiblePoint {
        let corners = self.mesh.corners(triangle).map(|corner| corner.position.as_dvec3());
        VisiblePoint::of(corners, view.point(at), view.toward(view.point(at)), triangle)
    }

    /// Rounds a height to the stored format.
    fn stored(&self, height: f64, cover: Cover) -> f32 {
        let height = height.clamp(2.0 * EMPTY_HEIGHT, 1.0);
        if self.settings.bits == 32 {
            return height as f32;
        }
        let most = f64::from((1u32 << self.settings.bits) - 1);
        let code = match cover {
            Cover::Centre => (height * most).round(),
            Cover::Pixel => (height * most).ceil(),
        };
        // A visible texel is never stored as empty.
        (code.max(1.0) / most) as f32
    }
}

impl Captured {
    /// Returns the names of the files that such an object has, and what they hold. Nothing is written.
    pub fn files(&self) -> ObjectFiles {
        ObjectFiles {
            bits: self.bits,
            has_colors: self.images.iter().all(|image| image.colors.is_some()),
            is_grid: self.grid.is_some(),
        }
    }

    /// Kind of the images' rays.
    pub fn kind(&self) -> ViewKind {
        self.specs.first().map_or(ViewKind::Orthographic, ViewSpec::kind)
    }

    /// Creates an object from the images, with this treatment of cells whose heights jump.
    ///
    /// # Errors
    ///
    /// When the jump is negative or NaN, or all images together have more texels than a map may
    /// have.
    pub fn object(&self, cells: JumpCells, jump_texels: f64) -> Result<ImageObject, ObjectError> {
        let maps: Vec<HeightMap> = self.images.iter().map(|image| image.heights.clone()).collect();
        ImageObject::new(self.views.clone(), &maps, cells, jump_texels)
    }
}

/// Ball that holds a mesh and a texel more on each side of an image of `size` texels.
fn ball(mesh: &Mesh, size: u32) -> (DVec3, f64) {
    let places = || mesh.vertices().iter().map(|vertex| vertex.position.as_dvec3());
    let [low, high] =
        places().fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], at| [low.min(at), high.max(at)]);
    let centre = 0.5 * (low + high);
    let radius = places().map(|at| at.distance(centre)).fold(0.0, f64::max);
    (centre, radius * f64::from(size) / f64::from(size - 2))
}

/// Specifications of the views: as arranged, or perspective from the same directions.
fn specs(settings: &CaptureSettings, centre: DVec3, radius: f64) -> Result<Vec<ViewSpec>, CaptureError> {
    let specs = settings.arrangement.specs();
    let Some(fov_degrees) = settings.fov_degrees else { return Ok(specs) };
    if !(fov_degrees > 0.0 && fov_degrees < 180.0) {
        return Err(CaptureError::View { number: 1, problem: ViewError::BadFov(fov_degrees) });
    }
    // The ball fills the image from edge to edge.
    let distance = radius / (fov_degrees.to_radians() / 2.0).sin();
    let from_eye = |spec: ViewSpec| match spec {
        ViewSpec::Orthographic { from, up } => {
            let eye = centre + from.normalize_or_zero() * distance;
            Ok(ViewSpec::Perspective { eye, up, fov_degrees })
        }
        ViewSpec::Perspective { .. } => Err(CaptureError::OwnFov),
    };
    specs.into_iter().map(from_eye).collect()
}
