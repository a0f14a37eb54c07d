//! The materials of a mesh's triangles.

use std::sync::Arc;

use relief_core::Wrap;
use relief_core::mesh::Mesh;

use crate::Picture;

/// A material, as far as its colour goes.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshMaterial {
    /// Its name.
    pub name: Option<Arc<str>>,
    /// Linear red, green, blue and opacity, each from 0 to 1, which multiply the picture.
    pub factor: [f32; 4],
    /// The opacity below which nothing is seen; everything is where there is none. Above 1 nothing is seen.
    pub cutoff: Option<f32>,
    /// The picture; white and opaque where there is none.
    pub picture: Option<Arc<Picture>>,
    /// How the picture goes on beyond its sides, along `u` and `v`.
    pub wrap: [Wrap; 2],
    /// Two rows that make the picture's coordinates of texture coordinates `(u, v, 1)`.
    pub transform: [[f32; 3]; 2],
}

impl MeshMaterial {
    /// The transform that changes nothing.
    pub const SAME: [[f32; 3]; 2] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

    /// The linear colour and the opacity of the picture at texture coordinates, before they are transformed.
    pub fn picture_at(&self, [u, v]: [f64; 2]) -> [f32; 4] {
        let Some(picture) = &self.picture else { return [1.0; 4] };
        let along = |[x, y, one]: [f32; 3]| f64::from(x) * u + f64::from(y) * v + f64::from(one);
        bilinear(picture, self.wrap, self.transform.map(along))
    }
}

impl Default for MeshMaterial {
    /// White and opaque.
    fn default() -> Self {
        Self {
            name: None,
            factor: [1.0; 4],
            cutoff: None,
            picture: None,
            wrap: [Wrap::Repeat; 2],
            transform: Self::SAME,
        }
    }
}

/// The colours of a mesh, triangle by triangle.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshColors {
    /// The materials, at least one.
    pub materials: Vec<MeshMaterial>,
    /// The number of each triangle's material. Empty where all have the first one.
    pub of_triangles: Vec<u32>,
    /// Texture coordinates of each triangle's corners by which pictures lie. Empty where they are the mesh's
    /// own.
    pub uvs: Vec<[[f32; 2]; 3]>,
    /// Linear red, green, blue and opacity of each triangle's corners, which multiply the material. Empty
    /// where all are 1.
    pub tints: Vec<[[f32; 4]; 3]>,
}

impl MeshColors {
    /// A single opaque material for all triangles, by the mesh's own texture coordinates.
    pub fn of(factor: [f32; 3], picture: Option<Picture>) -> Self {
        let [red, green, blue] = factor;
        let picture = picture.map(Arc::new);
        MeshMaterial { factor: [red, green, blue, 1.0], picture, ..MeshMaterial::default() }.into()
    }

    /// The colours of a framed mesh's triangles, by the numbers that the triangles had before.
    pub(super) fn of_framed(self, mesh: &Mesh, numbers: &[u32]) -> Self {
        fn kept<T: Copy>(list: &[T], numbers: &[u32]) -> Vec<T> {
            numbers.iter().filter_map(|number| list.get(*number as usize).copied()).collect()
        }
        let Self { materials, of_triangles, uvs, tints } = self;
        let mut uvs = kept(&uvs, numbers);
        // Where there are no others they are the mesh's own.
        for (triangle, corners) in (0u32..).zip(&mut uvs) {
            if corners[0][0].is_nan() {
                *corners = mesh.corners(triangle).map(|corner| corner.uv.to_array());
            }
        }
        Self { materials, of_triangles: kept(&of_triangles, numbers), uvs, tints: kept(&tints, numbers) }
    }

    /// How many materials show something else than white, with colours of vertices as one more.
    pub fn colored(&self) -> usize {
        let is_plain = |material: &MeshMaterial| {
            material.picture.is_none() && material.cutoff.is_none() && material.factor == [1.0; 4]
        };
        let of_materials = self.materials.iter().filter(|material| !is_plain(material)).count();
        of_materials + usize::from(!self.tints.is_empty())
    }

    /// The material of a triangle. One that is not there is white.
    pub fn material(&self, triangle: u32) -> Option<&MeshMaterial> {
        let number = self.of_triangles.get(triangle as usize).copied().unwrap_or_default();
        self.materials.get(number as usize)
    }

    /// Whether a triangle may be seen through: whether its material has a mask.
    pub fn has_mask(&self, triangle: u32) -> bool {
        self.material(triangle).is_some_and(|material| material.cutoff.is_some())
    }

    /// The linear colour and the opacity of a point of a triangle, by its barycentric weights and the mesh's
    /// own texture coordinates there.
    pub fn at(&self, triangle: u32, weights: [f64; 3], uv: [f64; 2]) -> [f32; 4] {
        let Some(material) = self.material(triangle) else { return [1.0; 4] };
        let mut color = material.factor;
        if let Some(tints) = self.tints.get(triangle as usize) {
            for (part, color) in color.iter_mut().enumerate() {
                let tint: f64 =
                    tints.iter().zip(weights).map(|(tint, weight)| f64::from(tint[part]) * weight).sum();
                *color *= tint as f32;
            }
        }
        if material.picture.is_some() {
            let uv = match self.uvs.get(triangle as usize) {
                Some(corners) => [0, 1].map(|axis| {
                    corners.iter().zip(weights).map(|(corner, weight)| f64::from(corner[axis]) * weight).sum()
                }),
                None => uv,
            };
            for (color, texel) in color.iter_mut().zip(material.picture_at(uv)) {
                *color *= texel;
            }
        }
        color
    }

    /// Whether a point of a triangle is seen: as with [`Self::at`], where its opacity reaches the material's
    /// cut-off.
    pub fn is_seen(&self, triangle: u32, weights: [f64; 3], uv: [f64; 2]) -> bool {
        let cutoff = self.material(triangle).and_then(|material| material.cutoff);
        cutoff.is_none_or(|cutoff| self.at(triangle, weights, uv)[3] >= cutoff)
    }
}

impl From<MeshMaterial> for MeshColors {
    /// That material for all triangles, by the mesh's own texture coordinates.
    fn from(material: MeshMaterial) -> Self {
        Self { materials: vec![material], of_triangles: Vec::new(), uvs: Vec::new(), tints: Vec::new() }
    }
}

/// A picture's colour and opacity at its coordinates.
fn bilinear(picture: &Picture, wrap: [Wrap; 2], at: [f64; 2]) -> [f32; 4] {
    let size = [picture.width, picture.height];
    let along = |axis: usize| {
        let side = i64::from(size[axis]);
        // Whole periods are left out before there is a number too large for texels.
        let at = match wrap[axis] {
            Wrap::Clamp => at[axis].clamp(-1.0, 2.0),
            Wrap::Repeat => at[axis].rem_euclid(1.0),
            Wrap::Mirror => at[axis].rem_euclid(2.0),
        };
        let at = if at.is_finite() { at * side as f64 - 0.5 } else { 0.0 };
        let first = at.floor();
        let place = |at: i64| match wrap[axis] {
            Wrap::Clamp => at.clamp(0, side - 1),
            Wrap::Repeat => at.rem_euclid(side),
            Wrap::Mirror => {
                let folded = at.rem_euclid(2 * side);
                folded.min(2 * side - 1 - folded)
            }
        };
        ([place(first as i64), place(first as i64 + 1)].map(|at| at as usize), (at - first) as f32)
    };
    let (([left, right], x), ([top, bottom], y)) = (along(0), along(1));
    let texel = |column: usize, row: usize| picture.texels[row * size[0] as usize + column];
    let mix = |a: f32, b: f32, at: f32| a + (b - a) * at;
    [0, 1, 2, 3].map(|part| {
        let upper = mix(texel(left, top)[part], texel(right, top)[part], x);
        mix(upper, mix(texel(left, bottom)[part], texel(right, bottom)[part], x), y)
    })
}
