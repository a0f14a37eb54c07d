//! Depth objects as surfaces of a scene.

use std::sync::Arc;

use glam::{DVec3, Vec3};
use relief_core::encoding::code::Codes;
use relief_core::object::{FrameGrid, GridMapping, ImageObject, JumpCells, View};
use relief_core::{BakedMap, HeightMap, MapFormat, MapIdentity, MapLayout, MapTexels, Wrap};
use relief_shaders::object::{IMAGE_TEXELS, MAX_IMAGES};
use relief_shaders::surface::AskedImages;
use relief_shaders::{SURFACE, Selection, Variants};

use super::Surface;
use super::builder::DEFAULT_METHOD_OF_OBJECTS;
use relief_core::mesh::{Mesh, Vertex, cube};

/// Depth object of a surface, with its images' views as the shaders read them.
#[derive(Clone, Debug)]
pub struct SceneObject {
    object: Arc<ImageObject>,
    images: Arc<BakedMap>,
}

/// Reason why a depth object cannot be shown.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ObjectProblem {
    /// The method would read all images in each step of a ray, and there are too many.
    #[error(
        "the object has {0} images, and the method reads all of them in each step: capture at most \
         {MAX_IMAGES}, or choose the surface {grid} or the method 'impostor-blend' for a grid of them",
        grid = Variants::of(SURFACE, |entry| entry.paths().images == Some(AskedImages::OfGrid)).or()
    )]
    TooMany(usize),
    /// The images are no octahedral grid of frames.
    #[error(
        "the method needs an octahedral grid of orthographic frames, row by row, and the images are none: \
         capture the object as a grid, or choose 'depth-object'"
    )]
    NoGrid,
    /// Images show balls of different sizes.
    #[error("image {0} shows a ball of another radius than image 0: capture all images of the same ball")]
    OtherBall(usize),
    /// No point is shown by all images.
    #[error(
        "no point is shown by all images, so the object has no solid, as with a thin card: for a grid of \
         frames choose the method 'impostor-blend'"
    )]
    Nothing,
    /// The box around the object is no valid mesh: it is not finite, or too small.
    #[error("the box around the object is too small or too large: scale the object")]
    Box,
    /// The ball's diameter is no valid scale.
    #[error(transparent)]
    HeightMap(#[from] relief_core::HeightMapError),
}

impl SceneObject {
    /// Returns a placeholder for an object whose file has not been read: a grid of images of one
    /// texel.
    pub(super) fn stand_in() -> Result<ImageObject, ObjectProblem> {
        let from = GridMapping::Octahedral.direction([0.0, 0.0]);
        let view = View::orthographic(DVec3::ZERO, 1.0, from, None, [1, 1]);
        let views = view.map_or(Vec::new(), |view| vec![view; 4]);
        let map = HeightMap::new(1, 1, vec![1.0], Wrap::Clamp)?;
        let maps = vec![map; views.len()];
        ImageObject::new(views, &maps, JumpCells::default(), 0.0).map_err(|_| ObjectProblem::Nothing)
    }

    /// Returns the object: its images with depth and their views.
    pub fn object(&self) -> &Arc<ImageObject> {
        &self.object
    }

    /// Returns the number of images that define the visual hull. They are the first rows of
    /// [`Self::images`].
    ///
    /// One of two opposite silhouettes is enough, as they are mirror images. A grid of frames keeps
    /// its order and needs all images.
    pub fn silhouettes(&self) -> usize {
        if self.object.grid().is_some() { self.object.views().len() } else { self.object.silhouettes().len() }
    }

    /// Returns the views of the images as the shaders read them: a texture with one row per image,
    /// of [`IMAGE_TEXELS`] texels with four numbers each.
    ///
    /// A row holds, in this order:
    ///
    /// 1. the maps from a point to `u`, to `v` and to a height, one texel each;
    /// 2. the image's rectangle in the texture of all images;
    /// 3. the direction against which the image looks, then 1 for a perspective view and 0 otherwise;
    /// 4. the map from a point to its depth;
    /// 5. the eye, then the depth at which the view begins.
    ///
    /// The last row is the grid of the images, or zeros without a grid: its three axes, one texel
    /// each. The fourth number of the first axis is the number of frames along a side. The fourth
    /// number of the second axis is 1 if only the upper half is mapped.
    pub fn images(&self) -> &Arc<BakedMap> {
        &self.images
    }

    /// Checks that the object has the images that a selection reads.
    ///
    /// # Errors
    ///
    /// When the selection reads all of more than [`MAX_IMAGES`] images, or a grid of frames that
    /// the object does not have.
    pub(super) fn check(&self, selection: &Selection) -> Result<(), ObjectProblem> {
        let count = self.object.views().len();
        if selection.asks_all_images() && count > MAX_IMAGES {
            return Err(ObjectProblem::TooMany(count));
        }
        if selection.needs_grid() && self.object.grid().is_none() {
            return Err(ObjectProblem::NoGrid);
        }
        Ok(())
    }
}

impl Surface {
    /// Creates a grey surface that shows a depth object by the method `depth-object`. The object is
    /// in world space.
    ///
    /// Its [mesh](Surface::mesh) is the object's bounding box. Its [height
    /// map](Surface::height_map) holds all images in one. A colour picture and a normal map have
    /// the same layout.
    ///
    /// # Errors
    ///
    /// When images show balls of different sizes, or no point is shown by all images.
    pub fn of_object(object: impl Into<Arc<ImageObject>>) -> Result<Self, ObjectProblem> {
        let object = object.into();
        let bounds = object.bounds().ok_or(ObjectProblem::Nothing)?;
        Self::of_object_in(object, bounds)
    }

    /// Creates a surface like [`Self::of_object`], with a box around the ball that all images show.
    /// The method `impostor-blend` needs it for images without a common solid.
    ///
    /// # Errors
    ///
    /// When images show balls of different sizes.
    pub fn of_object_in_ball(object: impl Into<Arc<ImageObject>>) -> Result<Self, ObjectProblem> {
        let object = object.into();
        let (centre, radius) = object.views()[0].ball();
        Self::of_object_in(object, [centre - radius, centre + radius])
    }

    fn of_object_in(object: Arc<ImageObject>, bounds: [DVec3; 2]) -> Result<Self, ObjectProblem> {
        let views = object.views();
        let (_, radius) = views[0].ball();
        let is_other = |view: &View| (view.ball().1 - radius).abs() > 1e-9 * radius;
        if let Some(number) = views.iter().position(is_other) {
            return Err(ObjectProblem::OtherBall(number));
        }
        let mesh = box_around(bounds).ok_or(ObjectProblem::Box)?;
        let heights = HeightMap::clone(object.heights()).with_displacement(2.0 * radius, 0.0)?;
        let images = Arc::new(images_of(&object).ok_or(ObjectProblem::Box)?);
        let selection = Selection::method(DEFAULT_METHOD_OF_OBJECTS).unwrap_or_default();
        Ok(Self::new(mesh, heights).with_selection(selection).showing(SceneObject { object, images }))
    }
}

/// Returns the box as a mesh. Each side has a tile of its own.
fn box_around([low, high]: [DVec3; 2]) -> Option<Mesh> {
    let (middle, extent) = ((0.5 * (low + high)).as_vec3(), (high - low).as_vec3());
    let unit = cube(1).ok()?;
    let place = |vertex: &Vertex| Vertex {
        position: middle + vertex.position * extent,
        tangent: vertex.tangent * extent,
        bitangent: vertex.bitangent * extent,
        ..*vertex
    };
    let is_solid = extent.cmpgt(Vec3::ZERO).all();
    let vertices = unit.vertices().iter().map(place).collect();
    is_solid.then(|| Mesh::new(vertices, unit.triangles().to_vec()).ok()).flatten()
}

/// Returns the images in the order of their rows. Silhouettes for the visual hull come first,
/// except in a grid, whose frames are known by their indices.
fn in_order(object: &ImageObject) -> Vec<usize> {
    let mut order: Vec<usize> = (0..object.views().len()).collect();
    if object.grid().is_none() {
        order.sort_by_key(|number| !object.silhouettes().contains(number));
    }
    order
}

/// Returns [`SceneObject::images`]: a row for the view of each image, then the grid.
fn images_of(object: &ImageObject) -> Option<BakedMap> {
    let all = object.layout().size().map(f64::from);
    let values = in_order(object).into_iter().flat_map(|number| {
        let (view, place) = (&object.views()[number], object.layout().places()[number]);
        let [u, v, height, depth] = view.rows().map(|row| row.to_array());
        let [x, y] = [0, 1].map(|axis| f64::from(place[axis]) / all[axis]);
        let [width, tall] = [0, 1].map(|axis| f64::from(view.size()[axis]) / all[axis]);
        let ([_, _, toward], (centre, radius)) = (view.axes(), view.ball());
        let nearest = view.rows()[3].dot((centre + toward * radius).extend(1.0));
        let has_eye = f64::from(view.eye().is_some());
        let eye = view.eye().unwrap_or_default().extend(nearest).to_array();
        [u, v, height, [x, y, width, tall], toward.extend(has_eye).to_array(), depth, eye]
    });
    let mut last = [[0.0; 4]; IMAGE_TEXELS as usize];
    if let Some(FrameGrid { side, mapping, axes }) = object.grid() {
        let behind = [f64::from(side), f64::from(mapping == GridMapping::HemiOctahedral), 0.0];
        for ((texel, axis), behind) in last.iter_mut().zip(axes).zip(behind) {
            *texel = axis.extend(behind).to_array();
        }
    }
    let values = values.chain(last).flatten().map(|value| value as f32).collect();
    let rows = object.views().len() as u32 + 1;
    let size = [IMAGE_TEXELS, rows];
    let layout = MapLayout { size, levels: 1, layers: 1, channels: 4, format: MapFormat::F32 };
    let codes = [Codes { low: 0.0, step: 0.0 }; 4];
    BakedMap::new(MapIdentity::without_heights("object"), layout, codes, MapTexels::F32(values)).ok()
}
