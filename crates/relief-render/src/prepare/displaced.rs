//! Displaced triangles, which geometries make from base meshes and height maps.

use std::sync::Arc;

use relief_core::camera::Camera;
use relief_core::mesh::{Mesh, Vertex};
use relief_core::object::ImageObject;
use relief_core::{Cancelled, HeightMap, Watch};
use relief_mesh::{
    Cull, MeshSettings, Mesher, MesherError, Outside, SliceError, SliceSettings, Stream, StreamError, View,
};
use relief_shaders::Selection;
use relief_shaders::cpu::{Corner, Shell};
use relief_shaders::geometry::{Geometry, Tessellated};

use super::sliced;
use super::tessellation::{Capacity, Division, TessellatedBase, Tessellation};
use crate::error::RenderError;
use crate::light_views;
use crate::prepare::Triangles;
use relief_core::raycast::RayCaster;
use relief_scene::light::Light;
use relief_scene::{Scene, Surface};

/// Bytes that a vertex takes: for the shaders, for its upload to a GPU, and for the bounds of
/// shadow maps.
pub const BYTES_PER_VERTEX: u64 = 2 * size_of::<Corner>() as u64 + 24;

/// Bytes that a triangle takes: for the shaders, and in the BVH.
pub const BYTES_PER_TRIANGLE: u64 = 48 + RayCaster::BYTES_PER_TRIANGLE;

/// Least distance of vertices in a view's tessellation, in texels. A patch between four texels
/// bends only smoothly.
const FINEST_TEXELS: f64 = 0.25;

/// Reason why a surface has no displaced triangles.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum GeometryError {
    /// The triangles cannot be made. The text names a setting that makes fewer.
    #[error("its displaced triangles cannot be made: {0}; choose {1} for fewer triangles")]
    Mesh(MesherError, &'static str),
    /// The surface cannot be sliced.
    #[error("it cannot be sliced: {0}")]
    Slices(SliceError),
    /// The triangles take more memory than is allowed.
    #[error(
        "its {triangles} triangles need {} MiB of memory, {} MiB are left for them: choose {setting}, or \
         allow more memory",
        needed.div_ceil(1 << 20), left >> 20
    )]
    Memory {
        /// Number of triangles.
        triangles: u64,
        /// Bytes that the triangles take, with their BVH.
        needed: u64,
        /// Bytes that are allowed and that other surfaces do not take.
        left: u64,
        /// Setting that makes fewer triangles.
        setting: &'static str,
    },
    /// A vertex is displaced beyond the range of 32-bit numbers.
    #[error("a vertex is displaced beyond what 32-bit numbers hold: choose a smaller displacement or mesh")]
    NotFinite,
    /// The work was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// Source of displaced triangles: base mesh, height map and division.
#[derive(Clone, Debug)]
struct DisplacedSource {
    mesh: Arc<Mesh>,
    map: Arc<HeightMap>,
    /// The depth object that is sliced, if any.
    object: Option<Arc<ImageObject>>,
    cut: Cut,
}

/// Division of a base into triangles or slices.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Cut {
    Texels(u32),
    /// By the voxels of a view, with a number of mip levels of the height map, and culled.
    Voxels(View, u32, Option<Cull>),
    /// By the voxels of a view or by texels, on the backend itself.
    Tessellated(View, u32, Cull, Tessellated),
    /// By slices through the relief.
    Sliced(SliceSettings),
    /// By slices through the box around an object. With a camera, they are sorted from front to
    /// back.
    SlicedBox(SliceSettings, Option<Camera>),
}

impl DisplacedSource {
    /// Returns the source of a surface's displaced triangles, or `None` if it has none.
    fn of(surface: &Surface, scene: &Scene) -> Option<Self> {
        let (map, selection) = (surface.height_map(), surface.selection());
        let cut = match selection.geometry()? {
            Geometry::Texels(texels) => Cut::Texels(texels),
            Geometry::Pixels(pixels) => {
                let view = view(pixels, surface, scene);
                Cut::Voxels(view, selection.levels_of(map), cull(scene, surface, &view))
            }
            Geometry::Tessellated(by) => {
                let view = view(by.pixels, surface, scene);
                let cull = cull(scene, surface, &view).unwrap_or_default();
                // Vertices a number of texels apart have the heights of these.
                let levels = if by.texels.is_some() { 1 } else { selection.levels_of(map) };
                Cut::Tessellated(view, levels, cull, by)
            }
            Geometry::Slices(slices) => Cut::Sliced(sliced::settings(slices, scene)),
            Geometry::ObjectSlices(slices) => {
                let is_in_order = selection.counts_in_stencil();
                Cut::SlicedBox(sliced::settings(slices, scene), is_in_order.then(|| *scene.camera()))
            }
        };
        let object = surface.object().map(|object| Arc::clone(object.object()));
        Some(Self { mesh: Arc::clone(surface.mesh()), map: Arc::clone(map), object, cut })
    }

    fn is(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.mesh, &other.mesh) && Arc::ptr_eq(&self.map, &other.map) && self.cut == other.cut
    }

    /// Whether backends tessellate the same base for both.
    fn has_base_of(&self, other: &Self) -> bool {
        let levels = |cut: &Cut| if let Cut::Tessellated(_, levels, ..) = cut { Some(*levels) } else { None };
        Arc::ptr_eq(&self.mesh, &other.mesh)
            && Arc::ptr_eq(&self.map, &other.map)
            && levels(&self.cut).is_some_and(|own| levels(&other.cut) == Some(own))
    }

    /// Returns the setting that makes fewer triangles.
    fn setting(&self) -> &'static str {
        match self.cut {
            Cut::Texels(_) | Cut::Tessellated(.., Tessellated { texels: Some(_), .. }) => {
                "a larger 'geometry.texels'"
            }
            Cut::Voxels(..) | Cut::Tessellated(..) => "a larger 'geometry.pixels'",
            Cut::Sliced(_) | Cut::SlicedBox(..) => sliced::FEWER,
        }
    }

    /// Returns the first `levels` levels of the map, without level 0.
    fn coarser(&self, levels: u32) -> Vec<HeightMap> {
        (1..levels).map(|level| self.map.level(level)).collect()
    }

    /// Converts an error of the mesher.
    fn error(&self, error: MesherError) -> GeometryError {
        match error {
            MesherError::Cancelled(cancelled) => cancelled.into(),
            error => GeometryError::Mesh(error, self.setting()),
        }
    }
}

/// Returns the view of a scene, with voxels of the given size in pixels, or larger where that is
/// too fine for a surface.
fn view(pixels: f32, surface: &Surface, scene: &Scene) -> View {
    no_finer(View { pixels: pixels.into(), ..View::new(*scene.camera(), scene.size()) }, surface)
}

/// Returns the culling of a surface's triangles for the camera, or `None` if all are made, even
/// behind the eye.
///
/// Triangles that cast shadows are made, whether the camera sees them or not. Shadow maps need the
/// triangles near the paths to the centres of lights. Rays through the scene go to all of the
/// lights' discs.
fn cull(scene: &Scene, surface: &Surface, view: &View) -> Option<Cull> {
    let (lights, surfaces) = (scene.lights(), scene.surfaces());
    let any = |of: fn(&Selection) -> bool| surfaces.iter().any(|surface| of(surface.selection()));
    if !lights.is_empty() && any(|selection| selection.rays_through_scene().is_some()) {
        return None;
    }
    let are_seen = !lights.is_empty() && any(|selection| selection.light_views().is_some());
    if !scene.culls() {
        return Some(Cull::default());
    }
    if !are_seen {
        return Some(Cull { outside: Outside::ALL, backs: !surface.two_sided() });
    }
    let beside_m = light_views::beside_m(scene);
    let places = lights.iter().map(|light| match *light {
        Light::Directional { toward, .. } => toward.extend(0.0),
        Light::Point { position_m, .. } => position_m.extend(1.0),
    });
    // What is no number leaves nothing out.
    let outside = Outside::of_light_paths(places, view, beside_m);
    let outside = if beside_m.is_finite() { outside } else { Outside::NOTHING };
    Some(Cull { outside, backs: false })
}

/// Returns the view with voxels that are nowhere smaller than [`FINEST_TEXELS`].
fn no_finer(view: View, surface: &Surface) -> View {
    let (map, [u, v]) = (surface.height_map(), surface.metric().tile_m);
    let texel_m = (u / f64::from(map.width())).min(v / f64::from(map.height()));
    let [voxel_m, least_m] =
        [view.pixels * 2.0 * view.camera.half_height() / f64::from(view.size[1]), FINEST_TEXELS * texel_m];
    if !(least_m.is_finite() && least_m > 0.0) {
        return view;
    }
    if view.camera.is_orthographic() {
        View { pixels: view.pixels * (least_m / voxel_m).max(1.0), ..view }
    } else {
        // Nearer voxels are as large as those at `near_m`.
        View { near_m: view.near_m.max(least_m / voxel_m), ..view }
    }
}

/// Displaced triangles, and the memory that they take.
#[derive(Debug)]
struct CachedTriangles {
    of: DisplacedSource,
    triangles: Arc<Triangles>,
    bytes: u64,
}

/// Base that backends tessellate, the same for all views.
#[derive(Debug)]
struct CachedBase {
    of: DisplacedSource,
    base: Arc<TessellatedBase>,
}

/// Cache of the displaced triangles of a scene's surfaces, from one picture to the next.
#[derive(Debug, Default)]
pub struct Displaced {
    known: Vec<CachedTriangles>,
    bases: Vec<CachedBase>,
}

impl Displaced {
    /// Returns the displaced triangles of each surface, or `None` if it has none. Cached ones are
    /// reused for the same mesh, map and, if it matters, view. Others are dropped before any are
    /// made.
    pub fn of_scene(
        &mut self,
        scene: &Scene,
        watch: &Watch,
    ) -> Result<Vec<Option<Arc<Triangles>>>, RenderError> {
        let watch = watch.quiet();
        let asked: Vec<Option<DisplacedSource>> =
            scene.surfaces().iter().map(|surface| DisplacedSource::of(surface, scene)).collect();
        self.known.retain(|known| asked.iter().flatten().any(|of| of.is(&known.of)));
        self.bases.retain(|known| asked.iter().flatten().any(|of| of.has_base_of(&known.of)));
        let each = asked.into_iter().enumerate().map(|(surface, of)| {
            let Some(of) = of else { return Ok(None) };
            if let Some(known) = self.known.iter().find(|known| known.of.is(&of)) {
                return Ok(Some(Arc::clone(&known.triangles)));
            }
            let taken = self.known.iter().map(|known| known.bytes).sum::<u64>();
            let left = scene.geometry_memory().0.saturating_sub(taken);
            let made = match of.cut {
                Cut::Texels(texels) => {
                    let settings = MeshSettings { texels, ..MeshSettings::default() };
                    let mesher = Mesher::watched(&of.mesh, &of.map, &settings, &watch);
                    mesher
                        .map_err(|error| of.error(error))
                        .and_then(|mesher| make_triangles(&of, &mesher, left, watch))
                }
                Cut::Voxels(view, levels, cull) => {
                    let settings = MeshSettings { cull, ..MeshSettings::seen_by(view) };
                    let coarser = of.coarser(levels);
                    let mesher = Mesher::with_levels(&of.mesh, &of.map, &coarser, &settings, &watch);
                    mesher
                        .map_err(|error| of.error(error))
                        .and_then(|mesher| make_triangles(&of, &mesher, left, watch))
                }
                Cut::Sliced(settings) => sliced::triangles(&of.mesh, &of.map, settings, left, &watch),
                Cut::SlicedBox(settings, camera) => match &of.object {
                    Some(object) => {
                        sliced::triangles_of_object(&of.mesh, object, (settings, camera), left, &watch)
                    }
                    None => Err(GeometryError::Slices(SliceError::NoSpacing)),
                },
                Cut::Tessellated(view, levels, cull, by) => {
                    let known = self.bases.iter().find(|known| known.of.has_base_of(&of));
                    let base = match known.map(|known| Arc::clone(&known.base)) {
                        Some(base) => Ok(base),
                        None => {
                            TessellatedBase::new(&of.mesh, &of.map, &of.coarser(levels), &watch).map(|base| {
                                let base = Arc::new(base);
                                self.bases.push(CachedBase { of: of.clone(), base: Arc::clone(&base) });
                                base
                            })
                        }
                    };
                    base.map_err(|error| of.error(error))
                        .and_then(|base| to_be_made(&of, base, (&view, levels, &cull), by, left))
                }
            };
            let (triangles, bytes) = made.map_err(|why| match why {
                GeometryError::Cancelled(cancelled) => cancelled.into(),
                source => RenderError::Geometry { surface, source },
            })?;
            self.known.push(CachedTriangles { of, triangles: Arc::clone(&triangles), bytes });
            Ok(Some(triangles))
        });
        each.collect()
    }
}

/// Returns the triangles that a backend will make for a view, and the bytes that they may take.
fn to_be_made(
    of: &DisplacedSource,
    base: Arc<TessellatedBase>,
    (view, levels, cull): (&View, u32, &Cull),
    by: Tessellated,
    left: u64,
) -> Result<(Arc<Triangles>, u64), GeometryError> {
    let of_base = base.vertices.len() as u64 * BYTES_PER_VERTEX;
    let parts_of_uv = by.texels.map(|texels| {
        let size = [of.map.width(), of.map.height()];
        size.map(|texels_of_map| f64::from(texels_of_map) / f64::from(texels))
    });
    let division = Division { parts_of_uv, is_swept: by.is_swept };
    let bytes = |capacity: Capacity| {
        u64::from(capacity.triangles) * BYTES_PER_TRIANGLE + u64::from(capacity.points) * BYTES_PER_VERTEX
    };
    let each = BYTES_PER_TRIANGLE + BYTES_PER_VERTEX * 5 / 8;
    let (patches, memory) = (base.patches.len() as u64, left.saturating_sub(of_base));
    if memory / each < patches {
        let needed = of_base.saturating_add(patches.saturating_mul(each));
        return Err(GeometryError::Memory { triangles: patches, needed, left, setting: of.setting() });
    }
    // The numbers of three corners each fit 32 bits.
    let most = u64::from(u32::MAX / 3);
    let wanted = base.capacity(view, &division).within(Capacity::of_triangles(most as u32));
    let capacity = if bytes(wanted) <= memory {
        wanted
    } else {
        wanted.within(Capacity::of_triangles((memory / each).min(most) as u32))
    };
    let grid = base.grid(view, cull, levels, &division, capacity).map_err(|error| of.error(error))?;
    let everything = base.everything(view);
    let triangles = Triangles::to_be_made(Tessellation { base, grid }, everything);
    Ok((Arc::new(triangles), of_base + bytes(capacity)))
}

/// Displaced triangles and the memory that they take.
fn make_triangles(
    of: &DisplacedSource,
    mesher: &Mesher,
    left: u64,
    watch: Watch,
) -> Result<(Arc<Triangles>, u64), GeometryError> {
    let bytes = mesher.vertices() * BYTES_PER_VERTEX + mesher.triangles() * BYTES_PER_TRIANGLE;
    let needed = bytes.saturating_add(mesher.bytes());
    if needed > left {
        return Err(GeometryError::Memory {
            triangles: mesher.triangles(),
            needed,
            left,
            setting: of.setting(),
        });
    }
    let mut corners: Vec<Corner> = Vec::with_capacity(mesher.vertices() as usize);
    let mut faces: Vec<[u32; 3]> = Vec::with_capacity(mesher.triangles() as usize);
    let how = Stream { size: 1.0, check: false, grid: None, cache_order: false, watch };
    let streamed = mesher.stream(&how, |block| {
        corners.extend(block.vertices.iter().map(corner));
        faces.extend_from_slice(&block.triangles);
        Ok::<(), std::convert::Infallible>(())
    });
    match streamed {
        Ok(_) => {}
        Err(StreamError::Cancelled(cancelled)) => return Err(cancelled.into()),
        Err(_) => return Err(GeometryError::NotFinite),
    }
    let faces = faces.into_iter().zip(std::iter::repeat(Shell::whole()));
    Ok((Arc::new(Triangles::new(corners, faces).among(mesher.full_bounds().cloned())), bytes))
}

/// A vertex as the shaders have it.
pub fn corner(vertex: &Vertex) -> Corner {
    Corner::new(
        vertex.position.to_array(),
        vertex.normal.to_array(),
        vertex.tangent.to_array(),
        vertex.bitangent.to_array(),
        vertex.uv.to_array(),
        [0.0; 3],
    )
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicBool;

    use glam::DVec3;
    use relief_core::Wrap;
    use relief_core::camera::Camera;
    use relief_core::mesh::torus;

    use super::*;

    #[test]
    fn triangles_are_made_again_where_what_they_are_made_of_is_another() {
        let map = HeightMap::from_fn(32, 32, Wrap::Repeat, |i, j| ((i ^ j) & 4) as f32 / 4.0);
        let map = Arc::new(map.expect("a map").with_displacement(0.02, 0.0).expect("lengths"));
        let mesh = Arc::new(torus(12, 6).expect("a mesh"));
        let of = |method: &str| {
            let selection = Selection::method(method).expect("a method");
            Surface::new(Arc::clone(&mesh), Arc::clone(&map)).with_selection(selection)
        };
        let surfaces = vec![of("vertex"), of("remesh"), of("exact"), of("vertex")];
        let camera = |x: f64| Camera::new(DVec3::new(x, 1.0, 1.0), DVec3::ZERO, 40.0).expect("a camera");
        let scene = Scene::builder(of("exact")).surfaces(surfaces).size(90, 60).camera(camera(0.5));
        let mut scene = scene.build().expect("a scene");
        let mut displaced = Displaced::default();
        let mut made = |scene: &Scene| displaced.of_scene(scene, &Watch::none()).expect("triangles");
        let is_same = |a: &Option<Arc<Triangles>>, b: &Option<Arc<Triangles>>| {
            a.as_ref().zip(b.as_ref()).is_some_and(|(a, b)| Arc::ptr_eq(a, b))
        };
        let first = made(&scene);
        assert!(first[2].is_none() && is_same(&first[0], &first[3]));
        let again = made(&scene);
        assert!(is_same(&first[0], &again[0]) && is_same(&first[1], &again[1]));
        scene.set_camera(camera(0.6));
        let moved = made(&scene);
        assert!(is_same(&first[0], &moved[0]) && !is_same(&first[1], &moved[1]));
        let other = scene.to_builder().size(120, 60).build().expect("a scene");
        assert!(!is_same(&moved[1], &made(&other)[1]));
        // Shadows are looked up in all triangles, and without lights there are none.
        let len = |made: &[Option<Arc<Triangles>>]| made[1].as_ref().map_or(0, |triangles| triangles.len());
        let dark = scene.to_builder().lights(Vec::new()).build().expect("a scene");
        let seen = made(&dark);
        assert!(!is_same(&moved[1], &seen[1]) && len(&seen) < len(&moved));
        let whole = made(&dark.to_builder().culls(false).build().expect("a scene"));
        assert!(!is_same(&seen[1], &whole[1]) && len(&whole) == len(&moved));
        // Another displacement is another map, and what was cancelled is not there.
        let map = HeightMap::with_displacement((*map).clone(), 0.03, 0.0).expect("lengths");
        let surface = of("vertex").with_height_map(map);
        let other = scene.to_builder().surfaces(vec![surface]).build().expect("a scene");
        assert!(!is_same(&first[0], &made(&other)[0]));
        let cancel = AtomicBool::new(true);
        let stopped = displaced.of_scene(&scene, &Watch::cancelled_by(&cancel));
        assert!(matches!(stopped, Err(RenderError::Cancelled(_))));
    }
}
