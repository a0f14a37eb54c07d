//! Conversion of scenes to jobs: settings of the shaders, triangles in world space and the camera's
//! matrix.

mod displaced;
mod heights_under;
mod parts;
mod pictures;
mod sliced;
mod tessellation;
mod triangle_cache;
mod triangles;

pub use displaced::GeometryError;
#[cfg(feature = "gpu")]
pub use tessellation::Capacity;
pub use tessellation::{TessellatedBase, Tessellation};
pub use triangles::Triangles;

use std::sync::Arc;

use glam::{DMat4, DVec3, Vec3};
use relief_core::object::JumpCells;
use relief_core::{BakedMap, Watch};
use relief_io::Picture;
use relief_maps::{Account, Maps, MapsError};
use relief_shaders::cpu::{Frame, Light as ShaderLight, SurfaceSettings};
use relief_shaders::object::{MASK_CELLS, ObjectCells, Solid};
use relief_shaders::{MapNeed, MapSlot, SHADE, SlotMaps};

use crate::error::RenderError;
use crate::job::{HOLES_OF_COLORS, HOLES_OF_HEIGHTS, Job, JobSurface};
use crate::light_views::{LightViews, corner_position, relief_points};
use crate::mipmaps::Mipmaps;
use displaced::Displaced;
use parts::Parts;
use pictures::Pictures;
use relief_scene::background::Background;
use relief_scene::environment::Environment;
use relief_scene::light::Light;
use relief_scene::{ColorPlace, Scene, Surface};
use triangle_cache::{TriangleCache, extent_m, moved_out_m};

/// Least distance of the near plane, as a part of the greatest depth. If it is smaller, the nearest
/// depths get more bits than they need. If it is larger, the eye cannot come close to a surface.
const NEAR_OVER_FAR: f64 = 1e-4;

/// Least thickness of shells, as a part of the mesh's extent. In thinner shells `f32` has no values
/// between the sides.
const LEAST_SHELL: f32 = 1e-5;

/// Converts scenes to jobs and caches what successive scenes share.
#[derive(Debug, Default)]
pub struct Preparer {
    triangles: TriangleCache,
    displaced: Displaced,
    /// Baked maps of each surface of the last scene.
    maps: Vec<Vec<(MapSlot, Arc<BakedMap>)>>,
    pictures: Pictures,
    parts: Parts,
}

/// State while a job is made.
struct JobBuilder<'a> {
    scene: &'a Scene,
    before: &'a Preparer,
    triangles: TriangleCache,
    pictures: Pictures,
}

impl JobBuilder<'_> {
    /// Creates a surface of a job with a number. `triangles` are drawn; without them, the triangles
    /// of its mesh.
    fn surface(
        &mut self,
        number: usize,
        surface: &Surface,
        maps: &[(MapSlot, Arc<BakedMap>)],
        triangles: Option<Arc<Triangles>>,
    ) -> JobSurface {
        let levels = surface.selection().has_levels();
        let before = &self.before.pictures;
        let color = surface.color().map(|picture| self.pictures.of(picture, levels, before));
        let normal_map = match surface.normal_map() {
            Some(normals) => Some(self.pictures.of_normals(normals, levels, before)),
            None if levels && surface.selection().has_normals_of_relief() => {
                self.pictures.derived(surface, before)
            }
            None => None,
        };
        let material_maps = surface.material_maps().filter(|_| reads_materials(surface));
        let material_maps = material_maps.map(|maps| self.pictures.of_materials(maps, levels, before));
        let mut maps = maps.to_vec();
        let behind = self.scene.environment_behind();
        if surface.selection().sees_environment() || behind.is_some() {
            let environment = self.scene.environment().map_or_else(Environment::sky, Arc::clone);
            maps.push((MapSlot::Environment, Arc::clone(environment.map())));
        }
        if let Some(object) = surface.object() {
            maps.push((MapSlot::Object, Arc::clone(object.images())));
        }
        if let Some(motif) = surface.motif() {
            maps.push((MapSlot::Object, Arc::clone(motif.map())));
        }
        let slots = maps.iter().map(|(slot, map)| (*slot, &**map)).collect();
        let settings = {
            let pictures = [&color, &normal_map, &material_maps].map(Option::as_deref);
            surface_settings(surface, &slots, pictures)
        };
        let settings = SurfaceSettings { number: number as u32, ..settings };
        let shell_m = [settings.shell_m.x, settings.shell_m.y];
        let triangles =
            triangles.unwrap_or_else(|| self.triangles.of(surface, shell_m, &self.before.triangles));
        JobSurface {
            settings,
            selection: *surface.selection(),
            triangles,
            height_map: Arc::clone(surface.height_map()),
            color,
            normal_map,
            material_maps,
            maps,
            // Slices have no back.
            two_sided: surface.two_sided() || surface.selection().paths().is_sliced(),
        }
    }
}

impl Job {
    /// Creates the job of a scene: all data that shaders bind to show it. Programs use it to draw a
    /// scene with their own shaders, such as exported ones. `maps` provides the baked maps that the
    /// methods read.
    ///
    /// # Errors
    ///
    /// When a baked map cannot be provided, the triangles of a surface cannot be made, or the work
    /// was cancelled.
    pub fn of_scene(scene: &Scene, maps: &mut Maps, watch: &Watch) -> Result<Self, RenderError> {
        let mut preparer = Preparer::default();
        preparer.provide(scene, maps, &|_| false, watch)?;
        preparer.job(scene, watch)
    }
}

impl Preparer {
    /// Gets the baked maps that a scene's surfaces read from `maps`, and returns the origin of
    /// each. Maps for which `built` is true are left to the backend, which builds them: see
    /// [`Maps::provide_except`].
    ///
    /// # Errors
    ///
    /// When a baked map cannot be provided.
    pub fn provide(
        &mut self,
        scene: &Scene,
        maps: &mut Maps,
        built: &dyn Fn(&MapNeed) -> bool,
        watch: &Watch,
    ) -> Result<Vec<Account>, MapsError> {
        let mut accounts = Vec::new();
        self.maps.clear();
        for surface in scene.surfaces() {
            let (selection, heights) = (surface.selection(), surface.height_map());
            let provided = maps.provide_except(selection, heights, surface.metric(), built, watch)?;
            let (maps, of_surface) = provided.into_parts();
            self.maps.push(maps);
            accounts.extend(of_surface);
        }
        Ok(accounts)
    }

    /// Creates the job of the scene whose maps were provided last.
    ///
    /// # Errors
    ///
    /// When the displaced triangles of a surface cannot be made, or the work was cancelled.
    pub fn job(&mut self, scene: &Scene, watch: &Watch) -> Result<Job, RenderError> {
        let displaced = self.displaced.of_scene(scene, watch)?;
        let mut builder = JobBuilder {
            scene,
            before: self,
            triangles: TriangleCache::default(),
            pictures: Pictures::default(),
        };
        let mut parts = Parts::default();
        let mut surfaces: Vec<JobSurface> = Vec::new();
        // The scene's surface of each of these, which may be a part of it.
        let mut owners = Vec::new();
        let none = Vec::new();
        let maps = self.maps.iter().chain(std::iter::repeat(&none));
        for ((surface, displaced), maps) in scene.surfaces().iter().zip(displaced).zip(maps) {
            let colors = surface.colors().filter(|_| displaced.is_none());
            let whole = builder.surface(surfaces.len(), surface, maps, displaced);
            match colors {
                None => surfaces.push(whole),
                Some(colors) => {
                    for part in parts.of(colors, &whole.triangles, &self.parts) {
                        let of_material = surface.of_material(&colors.materials[part.material]);
                        let triangles = Some(part.triangles);
                        surfaces.push(builder.surface(surfaces.len(), &of_material, maps, triangles));
                    }
                }
            }
            owners.resize(surfaces.len(), surface);
        }
        number_translucent(&mut surfaces);
        let JobBuilder { triangles, pictures, .. } = builder;
        (self.triangles, self.pictures, self.parts) = (triangles, pictures, parts);
        let [width, height] = scene.size();
        let light_views = LightViews::new(scene.lights(), scene.camera(), [width, height], &mut surfaces);
        let mut frame = frame(scene, &owners, &surfaces);
        light_views.write_into(&mut frame);
        Ok(Job { width, height, samples: scene.samples(), frame, light_views, surfaces })
    }
}

/// Tells each translucent surface its number among them, and how many there are.
fn number_translucent(surfaces: &mut [JobSurface]) {
    let mut translucent: Vec<&mut JobSurface> =
        surfaces.iter_mut().filter(|surface| surface.selection.is_translucent()).collect();
    let count = translucent.len() as u32;
    for (number, surface) in (0..).zip(&mut translucent) {
        surface.settings.translucent = [number, count].into();
    }
}

fn four(v: Vec3) -> [f32; 4] {
    [v.x, v.y, v.z, 0.0]
}

fn place(v: DVec3, w: f32) -> [f32; 4] {
    [v.x as f32, v.y as f32, v.z as f32, w]
}

/// Returns the data that changes with the frame: camera, lights and background.
fn frame(scene: &Scene, owners: &[&Surface], surfaces: &[JobSurface]) -> Frame {
    let mut lights = Frame::none().lights;
    for (slot, light) in lights.iter_mut().zip(scene.lights()) {
        *slot = match *light {
            Light::Directional { toward, irradiance, diameter_deg } => {
                let radius = (0.5 * diameter_deg).to_radians().tan();
                let color = irradiance.extend(radius as f32).to_array();
                ShaderLight::new(place(toward, 0.0), color, 0u32, 0u32)
            }
            Light::Point { position_m, intensity, radius_m } => {
                let color = intensity.extend(radius_m as f32).to_array();
                ShaderLight::new(place(position_m, 1.0), color, 0u32, 0u32)
            }
        };
    }
    let (view_projection, near) = view_projection(scene, owners, surfaces);
    Frame {
        view_projection: view_projection.as_mat4().to_cols_array_2d().map(Into::into),
        ambient: four(scene.ambient()).into(),
        sample_width: (1.0 / f64::from(scene.samples()).sqrt()) as f32,
        near: near as f32,
        clip: clip(scene, surfaces).into(),
        lights,
        light_count: scene.lights().len() as u32,
        ..view_of(scene)
    }
}

/// Returns a frame with a scene's camera and background alone.
pub(crate) fn view_of(scene: &Scene) -> Frame {
    let camera = scene.camera();
    let [columns, rows] = scene.size();
    let across = 2.0 * camera.half_height() / f64::from(rows);
    let (right, down) = (camera.right() * across, camera.up() * -across);
    let to_corner = |from: DVec3| from - right * (f64::from(columns) / 2.0) - down * (f64::from(rows) / 2.0);
    // From pixel to pixel, parallel rays change in their origin, and others in their direction.
    let [eye, forward] = [camera.eye(), camera.forward()];
    let none = DVec3::ZERO;
    let (eye, eye_right, eye_down, corner, right, down) = if camera.is_orthographic() {
        (to_corner(eye), right, down, forward, none, none)
    } else {
        (eye, none, none, to_corner(forward), right, down)
    };
    let [above, below] = scene.background().colours();
    let sees_environment = scene.background() == Background::Environment;
    Frame {
        eye: place(eye, 1.0).into(),
        eye_right: place(eye_right, 0.0).into(),
        eye_down: place(eye_down, 0.0).into(),
        forward: place(forward, 0.0).into(),
        corner: place(corner, 0.0).into(),
        right: place(right, 0.0).into(),
        down: place(down, 0.0).into(),
        background: above.extend(f32::from(u8::from(sees_environment))).to_array().into(),
        background_below: four(below).into(),
        ..Frame::none()
    }
}

/// Returns the coefficients by which shaders compute the values of the scene's depth buffer.
fn clip(scene: &Scene, surfaces: &[JobSurface]) -> [f32; 4] {
    let camera = scene.camera();
    let depths = surfaces.iter().flat_map(|surface| {
        let known = surface.triangles.depths_m();
        let points = relief_points(surface).take(if known.is_some() { 0 } else { usize::MAX });
        let depths = points.map(|point| camera.forward().dot(point - camera.eye()));
        depths.chain(known.into_iter().flatten())
    });
    let [near, far] =
        depths.fold([f64::INFINITY, 0.0], |[near, far], depth| [depth.min(near), depth.max(far)]);
    let (far, is_orthographic) = (if far > 0.0 { far * 1.01 } else { 1.0 }, camera.is_orthographic());
    let near = (near * 0.99).clamp(if is_orthographic { 0.0 } else { far * NEAR_OVER_FAR }, far * 0.5);
    let [always, over, times] = scene.depth_buffer().coefficients(is_orthographic, [near, far]);
    [always as f32, over as f32, times as f32, 0.0]
}

/// Returns the settings of a surface: maps, displacement, material and method.
fn surface_settings(
    surface: &Surface,
    maps: &SlotMaps,
    [color, normals, material_maps]: [Option<&Mipmaps>; 3],
) -> SurfaceSettings {
    let (material, height) = (surface.material(), surface.height_map());
    let size = |map: Option<&Mipmaps>| map.map_or([1, 1], Mipmaps::size);
    let levels = |map: Option<&Mipmaps>| map.map_or(1, Mipmaps::levels);
    // Texels of a picture beside one of the height map, along the axis where they are more.
    let beside = |size: [u32; 2]| {
        let [along_u, along_v] = [(size[0], height.width()), (size[1], height.height())];
        (along_u.0 as f32 / along_u.1 as f32).max(along_v.0 as f32 / along_v.1 as f32)
    };
    let texels = |map: Option<&Arc<Picture>>| map.map_or(1.0, |map| beside([map.width, map.height]));
    // Derived normals begin with the second level.
    let derived = u32::from(surface.normal_map().is_none() && normals.is_some());
    let ([images, solids], cells, jump) = images(surface);
    let ColorPlace { rows: [color_u, color_v], wrap } = surface.color_place();
    let color_wraps = wrap.unwrap_or([height.wrap(); 2]);
    // Texels of the picture are as many times closer along the axis where they are closest.
    let axis = |k: usize| color_u[k].abs().max(color_v[k].abs());
    let color_times = if surface.color_place() == ColorPlace::default() { 1.0 } else { axis(0).max(axis(1)) };
    let of_heights = if surface.has_holes() && height.holes().is_some() { HOLES_OF_HEIGHTS } else { 0 };
    let has_holes = of_heights + if surface.cutoff() > 0.0 { HOLES_OF_COLORS } else { 0 };
    let specular =
        if reads_materials(surface) { Vec3::splat(material.reflectance()) } else { material.specular() };
    let has_material = match surface.material_maps().filter(|_| material_maps.is_some()) {
        Some(maps) => u32::from(maps.has_surface()) + 2 * u32::from(maps.has_emission()),
        None => 0,
    };
    let tracing = SurfaceSettings::tracing(height, surface.selection(), maps);
    let tracing = match surface.volume() {
        Some(volume) => tracing.with_volume(volume.layout()),
        None => tracing,
    };
    SurfaceSettings {
        images,
        solids,
        cells,
        jump,
        diffuse: four(material.diffuse()).into(),
        specular: four(specular).into(),
        emission: four(material.emission()).into(),
        roughness: material.roughness(),
        metallic: material.metallic(),
        has_material,
        color_size: size(color).into(),
        normal_size: size(normals).into(),
        material_size: size(material_maps).into(),
        material_levels: levels(material_maps),
        material_texels: material_maps.map_or(1.0, |maps| beside(maps.size())) * color_times,
        color_levels: levels(color),
        normal_levels: levels(normals) + derived,
        color_u: [color_u[0], color_u[1], color_u[2], 0.0].into(),
        color_v: [color_v[0], color_v[1], color_v[2], 0.0].into(),
        color_wrap_u: color_wraps[0] as u32,
        color_wrap_v: color_wraps[1] as u32,
        color_texels: texels(surface.color()) * color_times,
        normal_texels: texels(surface.normal_map()),
        normal_tile_m: surface.metric().tile_m.map(|length| length as f32).into(),
        shininess: material.shininess(),
        has_color: u32::from(surface.color().is_some()),
        has_normal: u32::from(surface.normal_map().is_some()),
        has_holes,
        cutoff: surface.cutoff(),
        has_creases: u32::from(surface.has_creases()),
        transmission: material.transmission(),
        ior: material.ior(),
        ..tracing.with_least_shell(height, extent_m(surface.mesh()) * LEAST_SHELL)
    }
}

/// Whether the shading of a surface reads roughness, metalness and the material maps.
fn reads_materials(surface: &Surface) -> bool {
    surface.selection().choices[SHADE].entry.reads_materials()
}

/// Returns values of a surface's depth object: numbers of all images, and of the images that decide
/// what is solid; the kind of their cells; the height difference at a jump.
fn images(surface: &Surface) -> ([u32; 2], u32, f32) {
    match (surface.object(), surface.selection().object_cells()) {
        (Some(shown), Some(ObjectCells { cells, jump_texels, solid, .. })) => {
            let object = shown.object();
            let images = object.views().len();
            let (solids, cells) = match solid {
                Solid::Hull => (shown.silhouettes(), MASK_CELLS),
                _ => (images, cells as u32),
            };
            ([images, solids].map(|count| count as u32), cells, object.jump_of(jump_texels.into()) as f32)
        }
        _ => ([0; 2], JumpCells::Bilinear as u32, 0.0),
    }
}

/// Returns the matrix for the rasteriser, with planes that hold all meshes. The second value is the
/// depth below which keys are ordered less finely.
fn view_projection(scene: &Scene, owners: &[&Surface], surfaces: &[JobSurface]) -> (DMat4, f64) {
    let (camera, size) = (scene.camera(), scene.size());
    let depth = |point: DVec3| camera.forward().dot(point - camera.eye());
    let depths = |toward: f64| {
        owners.iter().zip(surfaces).flat_map(move |(surface, made)| {
            let moved = toward * f64::from(moved_out_m(surface));
            // The planes do not depend on what was culled.
            let known = made.triangles.depths_m();
            let is_displaced = surface.selection().geometry().is_some() && known.is_none();
            let displaced = made.triangles.corners().iter().map(corner_position);
            let displaced = displaced.filter(move |_| is_displaced);
            let base = surface.mesh().vertices().iter().map(|vertex| vertex.position.as_dvec3());
            let depths = base.chain(displaced).map(move |point| depth(point) + moved);
            depths.chain(known.into_iter().flatten())
        })
    };
    let farthest = depths(1.0).fold(0.0, f64::max);
    let nearest = depths(-1.0).fold(f64::INFINITY, f64::min);
    // A mesh behind the eye shows nothing, whatever the planes.
    let far = if farthest > 0.0 { farthest * 1.01 } else { 1.0 };
    let least = far * NEAR_OVER_FAR;
    let near = (nearest * 0.99).clamp(if camera.is_orthographic() { 0.0 } else { least }, far * 0.5);
    let aspect = f64::from(size[0]) / f64::from(size[1]);
    (camera.view_projection(aspect, near, far).unwrap_or(DMat4::IDENTITY), near.max(least))
}
