//! Images with depth of a mesh, by exact rays.

mod cover;
mod error;
mod gutter;
mod highest;
mod looks;

use std::sync::atomic::{AtomicU64, Ordering};

use glam::DVec3;
use rayon::prelude::*;
use relief_core::camera::Ray;
use relief_core::mesh::Mesh;
use relief_core::object::{EMPTY_HEIGHT, ImageObject, JumpCells, MAX_VIEWS, ObjectError, View, ViewError};
use relief_core::raycast::{RayCaster, Sides, SurfaceHit};
use relief_core::{Cancelled, HeightMap, Watch, Wrap};
use relief_io::{DEFAULT_MAX_BYTES, MeshColors};

pub use self::cover::Cover;
pub use self::error::CaptureError;
use self::highest::Highest;
use self::looks::Place;
use crate::arrangement::MAX_GRID;
use crate::file::check_sheet;
use crate::verify::{self, Verification};
use crate::{Arrangement, Measured, ObjectFiles, ViewKind, ViewSpec};

/// The least side of an image, in texels.
pub const MIN_IMAGE_SIDE: u32 = 8;
/// The longest side of an image, in texels.
pub const MAX_IMAGE_SIDE: u32 = 16_384;

/// How a mesh is captured.
#[derive(Clone, Debug, PartialEq)]
pub struct CaptureSettings {
    /// From where.
    pub arrangement: Arrangement,
    /// The field of view in degrees of images from eyes that are as far away as it takes; none for parallel
    /// rays.
    pub fov_degrees: Option<f64>,
    /// Texels of a side of each image, from [`MIN_IMAGE_SIDE`] to [`MAX_IMAGE_SIDE`].
    pub size: u32,
    /// Bits of a depth: 8 or 16, integers, or 32, floats.
    pub bits: u32,
    /// The most memory that it may take, in bytes, with the mesh made ready for rays.
    pub max_bytes: u64,
}

impl Default for CaptureSettings {
    /// Six images of 209 x 209 texels along the axes, by parallel rays, in floats.
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

/// Memory of a texel: what it shows while images are made, all at once where threads are many; heights,
/// colours and normals in both covers, and heights as an object.
const BYTES_PER_TEXEL: u64 = 256;

/// A mesh that is ready to be captured.
pub struct Capturer<'a> {
    mesh: &'a Mesh,
    colors: Option<&'a MeshColors>,
    caster: RayCaster,
    settings: CaptureSettings,
    specs: Vec<ViewSpec>,
    views: Vec<View>,
}

/// Images with depth of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Captured {
    /// What a texel's height is.
    pub cover: Cover,
    /// Bits of a depth.
    pub bits: u32,
    /// Frames along a side, where the images make an octahedral grid.
    pub grid: Option<u32>,
    /// From where each image looks.
    pub specs: Vec<ViewSpec>,
    /// The same as views.
    pub views: Vec<View>,
    /// The images.
    pub images: Vec<CapturedImage>,
    /// Texels that show something, of all images.
    pub seen: u64,
    /// Those of them that show the back of a triangle.
    pub backs: u64,
}

/// An image with depth.
#[derive(Clone, Debug, PartialEq)]
pub struct CapturedImage {
    /// Heights, as they are stored: 0 where nothing is.
    pub heights: HeightMap,
    /// Linear colours, row by row from the top; beside what is seen they go on. None of a mesh without.
    pub colors: Option<Vec<[f32; 3]>>,
    /// Unit normals: `x` to the right, `y` up, `z` toward the viewer; beside what is seen they go on.
    pub normals: Vec<[f32; 3]>,
}

impl<'a> Capturer<'a> {
    /// Makes a mesh ready, with its colours if it has any.
    ///
    /// All images look at a ball around the middle of the mesh's box, which holds the mesh and a texel more
    /// on each side.
    ///
    /// # Errors
    ///
    /// When there are no views or too many, images too small or too large, or views cannot be; when one does
    /// not show all of the mesh; when more memory is needed than allowed.
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

    /// The ball that all images look at: its centre, and its radius in metres.
    pub fn ball(&self) -> (DVec3, f64) {
        self.views.first().map_or((DVec3::ZERO, 1.0), View::ball)
    }

    /// The files that an object of its images has.
    pub fn files(&self) -> ObjectFiles {
        ObjectFiles {
            bits: self.settings.bits,
            has_colors: self.colors.is_some(),
            is_grid: self.settings.arrangement.grid().is_some(),
        }
    }

    /// How many images there are to be.
    pub fn views(&self) -> &[View] {
        &self.views
    }

    /// Makes the images.
    ///
    /// Heights are exact but for their rounding to what is stored: to the nearest, with `Cover::Pixel` up.
    /// What is seen of both sides of triangles counts. A texel has the colour and the normal of what its
    /// centre shows, or of its highest point where the centre shows nothing. What the mask of a material
    /// leaves out is not there, and of triangles with a mask the centres decide, whatever the cover.
    ///
    /// # Errors
    ///
    /// When it is cancelled.
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

    /// How far what was captured is from the mesh; none where no picture is to be compared.
    ///
    /// # Errors
    ///
    /// When the jump cannot be, when pictures are too many or too large, or when it is cancelled.
    pub fn verify(
        &self,
        captured: &Captured,
        verification: &Verification,
        watch: &Watch,
    ) -> Result<Option<Measured>, CaptureError> {
        let object = captured.object(verification.cells, verification.jump_texels)?;
        verify::measure(
            &|ray| self.first_seen(ray).map(|hit| hit.t),
            &object,
            self.ball(),
            verification,
            watch,
        )
    }

    /// An image, and how many of its texels show backs.
    fn image(&self, view: &View, cover: Cover, watch: &Watch) -> Result<(CapturedImage, u64), CaptureError> {
        let [columns, rows] = view.size();
        let row = |y: u32| -> Result<_, Cancelled> {
            watch.check()?;
            Ok((0..columns).map(|x| self.centre(view, x, y)).collect::<Vec<_>>())
        };
        let lines = (0..rows).into_par_iter().map(row).collect::<Result<Vec<_>, _>>()?;
        let mut seen: Vec<Option<(f64, Place)>> = lines.into_iter().flatten().collect();
        if cover == Cover::Pixel {
            let texels = DVec3::new(f64::from(columns), f64::from(rows), 1.0);
            let corners = (0..self.mesh.triangles().len() as u32).map(|triangle| {
                let corners = self.mesh.corners(triangle).map(|corner| corner.position.as_dvec3());
                // All of the mesh is before the eye.
                corners.map(|corner| view.see(corner).unwrap_or_default() * texels)
            });
            let mut raised: Vec<Option<Highest>> = vec![None; seen.len()];
            // Of what has a mask centres decide: its highest point may be cut out.
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
        let backs = seen.iter().flatten().filter(|(_, place)| !place.front).count() as u64;
        let heights = seen.iter().map(|texel| texel.map_or(0.0, |(height, _)| self.stored(height, cover)));
        let heights = HeightMap::new(columns, rows, heights.collect(), Wrap::Clamp)?;
        let known: Vec<bool> = seen.iter().map(Option::is_some).collect();
        let fill = |empty: [f32; 3], of: &(dyn Fn(&Place) -> [f32; 3] + Sync)| {
            let value = |texel: &Option<(f64, Place)>| texel.as_ref().map_or(empty, |(_, place)| of(place));
            let mut values: Vec<[f32; 3]> = seen.par_iter().map(value).collect();
            gutter::fill(columns as usize, &mut values, known.clone());
            values
        };
        let colors = self.colors.map(|colors| fill([0.0; 3], &|place| place.color(self.mesh, colors)));
        let mut normals = fill([0.0, 0.0, 1.0], &|place| place.normal(self.mesh, view));
        normals.par_iter_mut().for_each(|normal| *normal = looks::unit(*normal));
        Ok((CapturedImage { heights, colors, normals }, backs))
    }

    /// What the ray through a texel's centre meets first: its height, and where it is.
    fn centre(&self, view: &View, x: u32, y: u32) -> Option<(f64, Place)> {
        let [columns, rows] = view.size().map(f64::from);
        let ray = view.ray((f64::from(x) + 0.5) / columns, (f64::from(y) + 0.5) / rows);
        let hit = self.first_seen(&ray)?;
        let place = Place::of_hit(&hit);
        Some((view.see(ray.at(hit.t))?.z, place))
    }

    /// What a ray meets first of what is not cut out.
    fn first_seen(&self, ray: &Ray) -> Option<SurfaceHit> {
        let is_seen =
            |hit: &SurfaceHit| self.colors.is_none_or(|colors| Place::of_hit(hit).is_seen(self.mesh, colors));
        self.caster.hits(ray, Sides::Both).find(is_seen)
    }

    /// Where a point of a triangle is, by its texture coordinates and height.
    fn beside(&self, view: &View, at: DVec3, triangle: u32) -> Place {
        let corners = self.mesh.corners(triangle).map(|corner| corner.position.as_dvec3());
        Place::of(corners, view.point(at), view.toward(view.point(at)), triangle)
    }

    /// The height that is stored for one.
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
        // What is there is not stored as nothing.
        (code.max(1.0) / most) as f32
    }
}

impl Captured {
    /// The files that an object of these images has.
    pub fn files(&self) -> ObjectFiles {
        ObjectFiles {
            bits: self.bits,
            has_colors: self.images.iter().all(|image| image.colors.is_some()),
            is_grid: self.grid.is_some(),
        }
    }

    /// By which rays the images were made.
    pub fn kind(&self) -> ViewKind {
        self.specs.first().map_or(ViewKind::Orthographic, ViewSpec::kind)
    }

    /// The object of these images, in which cells jump as they are told.
    ///
    /// # Errors
    ///
    /// When the jump is negative or NaN, or all images together have more texels than a map may have.
    pub fn object(&self, cells: JumpCells, jump_texels: f64) -> Result<ImageObject, ObjectError> {
        let maps: Vec<HeightMap> = self.images.iter().map(|image| image.heights.clone()).collect();
        ImageObject::new(self.views.clone(), &maps, cells, jump_texels)
    }
}

/// The ball that holds a mesh and a texel more on each side of an image that is so many texels wide.
fn ball(mesh: &Mesh, size: u32) -> (DVec3, f64) {
    let places = || mesh.vertices().iter().map(|vertex| vertex.position.as_dvec3());
    let [low, high] =
        places().fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], at| [low.min(at), high.max(at)]);
    let centre = 0.5 * (low + high);
    let radius = places().map(|at| at.distance(centre)).fold(0.0, f64::max);
    (centre, radius * f64::from(size) / f64::from(size - 2))
}

/// From where images look: as they are arranged, or from eyes in these directions.
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
