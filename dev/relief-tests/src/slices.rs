//! Planes by slices, beside the truth.

use std::sync::Arc;

use glam::DVec3;
use relief_core::camera::Camera;
use relief_core::mesh::{Mesh, square};
use relief_core::raycast::{RayCaster, Sides};
use relief_core::{HeightMap, Watch};
use relief_maps::Maps;
use relief_mesh::{SliceAnchor, SliceDirection, SliceSettings, Slicer};
use relief_render::render;
use relief_scene::{BackendChoice, Scene, Surface};
use relief_shaders::Selection;
use relief_shaders::cpu::PixelOut;

/// How far around its middle the plane is looked at, in tiles: rays there stay over it.
const MIDDLE: f32 = 0.22;

/// Plane of a metre under a map, seen at the given angle from its normal, in degrees.
#[derive(Clone, Copy, Debug)]
pub struct PlaneView<'a> {
    /// The map.
    pub map: &'a Arc<HeightMap>,
    /// Degrees from the normal.
    pub degrees: f64,
    /// Metres from the eye to its middle.
    pub away_m: f64,
    /// Columns and rows of the picture.
    pub size: u32,
}

/// Error of slices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SliceErrors {
    /// The share of pixels that show nothing, or what lies farther behind the truth than slices are apart.
    pub see_through: f64,
    /// The share of those beside these that show a point more than half a texel behind the truth.
    pub late: f64,
    /// Median error in texels.
    pub median: f64,
    /// Error of the worst in a hundred, in texels.
    pub p99: f64,
}

impl PlaneView<'_> {
    /// The camera.
    ///
    /// # Panics
    ///
    /// When the eye is no positive number of metres away.
    pub fn camera(&self) -> Camera {
        let (sine, cosine) = self.degrees.to_radians().sin_cos();
        let eye = DVec3::new(0.3 * sine, cosine, 0.95 * sine) * self.away_m;
        Camera::new(eye, DVec3::ZERO, 24.0).expect("a camera")
    }

    /// The picture by a method, on the CPU or a GPU.
    ///
    /// # Panics
    ///
    /// When there is no such method, setting or picture.
    pub fn pixels(&self, method: &str, set: &[(&str, f64)], backend: BackendChoice) -> Vec<PixelOut> {
        let mut selection = Selection::method(method).expect("a method");
        for (key, value) in set {
            selection.set(key, *value).expect("a setting");
        }
        let surface = Surface::new(Arc::<Mesh>::new(square(1).expect("a mesh")), Arc::clone(self.map));
        let scene = Scene::builder(surface.with_selection(selection)).size(self.size, self.size).samples(1);
        let scene = scene.camera(self.camera()).backend(backend).build().expect("a scene");
        render(&scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture").rendering.pixels
    }

    /// Slices of the given number over the displacement.
    pub fn settings(&self, method: &str, count: u32) -> SliceSettings {
        let direction = direction_of(method, self.camera());
        SliceSettings { count, direction }
    }

    /// Returns the mean number of slices that rays of the pixels in the middle cross.
    ///
    /// # Panics
    ///
    /// When they cannot be made.
    pub fn fragments(&self, truth: &[PixelOut], settings: SliceSettings) -> f64 {
        let middle = (0..self.size * self.size).zip(truth).filter(|(_, pixel)| is_in_middle(pixel));
        self.crossed(middle.map(|(number, _)| number), settings)
    }

    /// Returns the mean number of slices of all pixels, whether they show the plane or not.
    ///
    /// # Panics
    ///
    /// When they cannot be made.
    pub fn fragments_of_all(&self, settings: SliceSettings) -> f64 {
        self.crossed(0..self.size * self.size, settings)
    }

    /// How many slices the rays of some pixels cross, on the mean.
    fn crossed(&self, pixels: impl Iterator<Item = u32>, settings: SliceSettings) -> f64 {
        let base = square(1).expect("a mesh");
        let all = crossings(&base, self.map, settings, &self.camera(), self.size);
        let crossed = pixels.map(|number| all[number as usize]);
        let (sum, count) = crossed.fold((0, 0), |(sum, count), crossed| (sum + crossed, count + 1));
        sum as f64 / f64::from(count.max(1))
    }

    /// Returns the distance along a ray of slices that are `spacing` heights apart.
    pub fn along_m(&self, method: &str, spacing: f64) -> f64 {
        let (sine, cosine) = self.degrees.to_radians().sin_cos();
        let faces = match method {
            "slices-surface" => cosine,
            "slices-orthogonal" => cosine.max(0.95 * sine),
            _ => 1.0,
        };
        spacing * self.map.scale_m() / faces
    }

    /// Error of slices that are the given metres apart along the rays.
    pub fn errors(&self, truth: &[PixelOut], slices: &[PixelOut], along_m: f64) -> SliceErrors {
        let pairs = || truth.iter().zip(slices).filter(|(truth, _)| is_in_middle(truth));
        let mut apart: Vec<f64> = pairs().map(|(a, b)| self.texels_apart(a, b)).collect();
        let behind = |a: &PixelOut, b: &PixelOut| f64::from(b.depth - a.depth);
        let is_through = |a: &PixelOut, b: &PixelOut| b.hit == 0 || behind(a, b) > 1.25 * along_m;
        let is_late = |a: &PixelOut, b: &PixelOut| behind(a, b) > 0.0 && self.texels_apart(a, b) > 0.5;
        let share = |count: usize| count as f64 / apart.len().max(1) as f64;
        let see_through = share(pairs().filter(|(a, b)| is_through(a, b)).count());
        let late = share(pairs().filter(|(a, b)| !is_through(a, b) && is_late(a, b)).count());
        apart.sort_unstable_by(f64::total_cmp);
        let at = |part: f64| apart.get((apart.len() as f64 * part) as usize).copied().unwrap_or(0.0);
        SliceErrors { see_through, late, median: at(0.5), p99: at(0.99) }
    }

    /// The share of pixels whose slices jump between two pictures: how far behind the truth they lie
    /// changes by more than a quarter of what slices are apart along the rays.
    pub fn jumps(
        &self,
        [truth, slices]: [&[PixelOut]; 2],
        [truth_after, after]: [&[PixelOut]; 2],
        along_m: f64,
    ) -> f64 {
        let behind = truth.iter().zip(slices).zip(truth_after.iter().zip(after));
        let seen =
            behind.filter(|((a, b), (c, d))| is_in_middle(a) && is_in_middle(c) && b.hit == 1 && d.hit == 1);
        let (mut jumps, mut count) = (0, 0u32);
        for ((a, b), (c, d)) in seen {
            let change = f64::from(b.depth - a.depth) - f64::from(d.depth - c.depth);
            jumps += u32::from(change.abs() > 0.25 * along_m);
            count += 1;
        }
        f64::from(jumps) / f64::from(count.max(1))
    }

    /// Returns the distance of two hits in texels; infinite for misses.
    pub fn texels_apart(&self, a: &PixelOut, b: &PixelOut) -> f64 {
        let [x, y] = [a.uv.x - b.uv.x, a.uv.y - b.uv.y].map(f64::from);
        let apart = (x * f64::from(self.map.width())).hypot(y * f64::from(self.map.height()));
        if b.hit == 1 { apart } else { f64::INFINITY }
    }

    /// Share of the pixels in the middle that another picture shows within the given texels.
    ///
    /// # Panics
    ///
    /// When hardly anything is there to be compared.
    pub fn share_within(&self, of: &[PixelOut], other: &[PixelOut], texels: f64) -> f64 {
        let pairs = of.iter().zip(other).filter(|(of, _)| is_in_middle(of));
        let apart: Vec<f64> = pairs.map(|(a, b)| self.texels_apart(a, b)).collect();
        assert!(apart.len() > 1000, "hardly anything is seen: {} pixels", apart.len());
        apart.iter().filter(|apart| **apart <= texels).count() as f64 / apart.len() as f64
    }
}

/// Returns the direction of a method's slices.
pub fn direction_of(method: &str, camera: Camera) -> SliceDirection {
    match method {
        "slices-surface" => SliceDirection::Surface,
        "slices-orthogonal" => SliceDirection::Facing(camera),
        _ => SliceDirection::Screen(camera, SliceAnchor::Eye),
    }
}

/// Number of slices that each pixel's ray crosses, drawn or not, in a picture of the given columns and rows.
///
/// # Panics
///
/// When they cannot be made.
pub fn crossings(
    base: &Mesh,
    map: &HeightMap,
    settings: SliceSettings,
    camera: &Camera,
    size: u32,
) -> Vec<usize> {
    let mut corners = Vec::new();
    let slicer = Slicer::new(base, map, settings).expect("slices");
    let take = |block: &relief_mesh::SliceBlock| {
        let corner = |at: u32| block.vertices[at as usize].vertex.position;
        corners.extend(block.triangles.iter().map(|triangle| triangle.map(corner)));
    };
    slicer.each(&Watch::none(), take).expect("slices");
    let caster = RayCaster::of_corners(corners.into_iter());
    let crossed = |number: u32| {
        let ray = camera.ray(number % size, number / size, size, size);
        caster.hits(&ray, Sides::Both).count()
    };
    (0..size * size).map(crossed).collect()
}

/// Whether a pixel shows the middle of the plane.
pub fn is_in_middle(pixel: &PixelOut) -> bool {
    pixel.hit == 1 && (pixel.uv.x - 0.5).abs() < MIDDLE && (pixel.uv.y - 0.5).abs() < MIDDLE
}
