//! Objects that are known from images, as surfaces of a scene.

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

/// An object of images, and how the shaders see these.
#[derive(Clone, Debug)]
pub struct SceneObject {
    object: Arc<ImageObject>,
    images: Arc<BakedMap>,
}

/// Why an object cannot be shown.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ObjectProblem {
    /// All of too many images would be asked at each step of a ray.
    #[error(
        "an object has at most {MAX_IMAGES} images where all of them are asked, this one {0}: capture fewer, \
         or choose the surface {grid} or the method 'impostor-blend' for a grid of them",
        grid = Variants::of(SURFACE, |entry| entry.paths().images == Some(AskedImages::OfGrid)).or()
    )]
    TooMany(usize),
    /// The images make no grid of frames.
    #[error(
        "its images make no octahedral grid of orthographic frames, row by row, from which three could be \
         taken: capture it with one, or choose 'depth-object'"
    )]
    NoGrid,
    /// Images show balls of other sizes.
    #[error("image {0} shows a ball of another radius than the first: all images show the same ball")]
    OtherBall(usize),
    /// There is nothing that all images see.
    #[error(
        "there is nothing that all images see: a thin card leaves no solid; of a grid of frames the method \
         'impostor-blend' shows it all the same"
    )]
    Nothing,
    /// The box around it is no mesh: it is not finite, or too small.
    #[error("the box around the object is too small or too large")]
    Box,
    /// Heights cannot be as deep as the ball.
    #[error(transparent)]
    HeightMap(#[from] relief_core::HeightMapError),
}

impl SceneObject {
    /// What stands for the object of a file that has not been read: a grid of images of one texel.
    pub(super) fn stand_in() -> Result<ImageObject, ObjectProblem> {
        let from = GridMapping::Octahedral.direction([0.0, 0.0]);
        let view = View::orthographic(DVec3::ZERO, 1.0, from, None, [1, 1]);
        let views = view.map_or(Vec::new(), |view| vec![view; 4]);
        let map = HeightMap::new(1, 1, vec![1.0], Wrap::Clamp)?;
        let maps = vec![map; views.len()];
        ImageObject::new(views, &maps, JumpCells::default(), 0.0).map_err(|_| ObjectProblem::Nothing)
    }

    /// The object.
    pub fn object(&self) -> &Arc<ImageObject> {
        &self.object
    }

    /// Returns the number of images that define its visual hull: the images of the first rows. One of two
    /// opposite silhouettes that are mirror images is enough. A grid of frames, whose rows keep its order, needs
    /// all.
    pub fn silhouettes(&self) -> usize {
        if self.object.grid().is_some() { self.object.views().len() } else { self.object.silhouettes().len() }
    }

    /// Returns the views of its images, as the shaders read them: a row for each. A row holds the map from a
    /// point to `u`, `v` and a height, the image's place among the others, the direction against which it
    /// looks, with 1 behind it for a perspective view, the map from a point to its depth, and the eye, with
    /// the depth at which it begins to see. The last row is the grid that the images make: its axes, with the
    /// frames of a side behind the first, and 1 behind the second if only the upper half is mapped. It is
    /// zeros without a grid.
    pub fn images(&self) -> &Arc<BakedMap> {
        &self.images
    }

    /// Whether it has the images that a selection asks for.
    ///
    /// # Errors
    ///
    /// When all of more than [`MAX_IMAGES`] images would be asked, or a grid of frames that there is not.
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
    /// An object of images where it lies in the world, shown by the method `depth-object`, grey. Its
    /// [mesh](Surface::mesh) is a box around it, its [height map](Surface::height_map) are all images in one;
    /// colours and normals lie as these do.
    ///
    /// # Errors
    ///
    /// When the object has images of balls of several sizes, or there is nothing that all of them see.
    pub fn of_object(object: impl Into<Arc<ImageObject>>) -> Result<Self, ObjectProblem> {
        let object = object.into();
        let bounds = object.bounds().ok_or(ObjectProblem::Nothing)?;
        Self::of_object_in(object, bounds)
    }

    /// The same with a box around the ball that all images show, whatever they see together: for the method
    /// `impostor-blend`, which shows images that leave no solid.
    ///
    /// # Errors
    ///
    /// When the object has images of balls of several sizes.
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

/// The box as a mesh: each side has a tile of its own.
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

/// Returns the images in the order of their rows. Silhouettes that a visual hull needs come first, except in a
/// grid, whose frames are known by their numbers.
fn in_order(object: &ImageObject) -> Vec<usize> {
    let mut order: Vec<usize> = (0..object.views().len()).collect();
    if object.grid().is_none() {
        order.sort_by_key(|number| !object.silhouettes().contains(number));
    }
    order
}

/// How the images look at the object, a row for each, and the grid that they make.
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
