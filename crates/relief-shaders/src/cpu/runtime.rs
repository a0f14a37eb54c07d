//! What the translated shaders need at run time: the translator's library, the textures, and a function that it lacks.

pub use naga_rust_rt::*;

use texture::Read;

/// A height map as a texture: one number a texel, row by row from the top.
#[derive(Clone, Copy, Debug)]
pub struct HeightTexture<'a> {
    width: i32,
    texels: &'a [f32],
}

/// A colour, normal or baked map as a texture: four numbers a texel, row by row from the top.
#[derive(Clone, Copy, Debug)]
pub struct ColorTexture<'a> {
    width: i32,
    texels: &'a [[f32; 4]],
}

impl<'a> HeightTexture<'a> {
    /// A texture of rows of `width` texels.
    pub fn new(width: u32, texels: &'a [f32]) -> Self {
        Self { width: width as i32, texels }
    }
}

impl<'a> ColorTexture<'a> {
    /// A texture of rows of `width` texels.
    pub fn new(width: u32, texels: &'a [[f32; 4]]) -> Self {
        Self { width: width as i32, texels }
    }
}

/// A read outside the map gives 0, one of the results that WGSL allows; the shaders wrap before they read.
impl Read for HeightTexture<'_> {
    type Coordinates = Vec2<i32>;
    type Component = f32;

    #[inline(always)]
    fn read_texel(&self, at: Vec2<i32>, _layer: i32, _sample: i32, _level: i32) -> Vec4<f32> {
        let index = at.y as isize * self.width as isize + at.x as isize;
        let texel = self.texels.get(index as usize).copied().unwrap_or(0.0);
        Vec4 { x: texel, y: 0.0, z: 0.0, w: 1.0 }
    }
}

impl Read for ColorTexture<'_> {
    type Coordinates = Vec2<i32>;
    type Component = f32;

    #[inline(always)]
    fn read_texel(&self, at: Vec2<i32>, _layer: i32, _sample: i32, _level: i32) -> Vec4<f32> {
        let index = at.y as isize * self.width as isize + at.x as isize;
        let [x, y, z, w] = self.texels.get(index as usize).copied().unwrap_or([0.0; 4]);
        Vec4 { x, y, z, w }
    }
}

/// The square root, correctly rounded as on GPUs that the project is tested on.
pub(crate) trait SquareRoot {
    fn sqrt(self) -> Self;
}

impl SquareRoot for Scalar<f32> {
    #[inline(always)]
    fn sqrt(self) -> Self {
        Scalar(self.0.sqrt())
    }
}
