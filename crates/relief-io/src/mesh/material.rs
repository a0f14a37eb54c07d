//! Materials and colours of a mesh's triangles.

use std::sync::Arc;

use relief_core::Wrap;
use relief_core::mesh::Mesh;

use super::MaterialValues;
use crate::Picture;

/// Material: its colour and mask, and the values of a metallic-roughness material.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshMaterial {
    /// Name, if the file gives one.
    pub name: Option<Arc<str>>,
    /// Linear red, green, blue and opacity, each from 0 to 1. They multiply the picture.
    pub factor: [f32; 4],
    /// Opacity below which a point is invisible; none if all points are visible. Above 1 all are
    /// invisible.
    pub cutoff: Option<f32>,
    /// Picture; white and opaque if there is none.
    pub picture: Option<Arc<Picture>>,
    /// Continuation of the picture beyond its sides, along `u` and `v`.
    pub wrap: [Wrap; 2],
    /// Two rows of a matrix that maps texture coordinates `(u, v, 1)` to the picture's coordinates.
    pub transform: [[f32; 3]; 2],
    /// Values and pictures beside the colour.
    pub values: MaterialValues,
}

impl MeshMaterial {
    /// Identity transform.
    pub const IDENTITY: [[f32; 3]; 2] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

    /// Returns the linear colour and opacity of the picture at texture coordinates, given before
    /// [`Self::transform`] is applied.
    pub fn picture_at(&self, [u, v]: [f64; 2]) -> [f32; 4] {
        let Some(picture) = &self.picture else { return [1.0; 4] };
        let along = |[x, y, one]: [f32; 3]| f64::from(x) * u + f64::from(y) * v + f64::from(one);
        bilinear(picture, self.wrap, self.transform.map(along))
    }
}

impl Default for MeshMaterial {
    /// Returns a white, opaque material.
    fn default() -> Self {
        Self {
            name: None,
            factor: [1.0; 4],
            cutoff: None,
            picture: None,
            wrap: [Wrap::Repeat; 2],
            transform: Self::IDENTITY,
            values: MaterialValues::default(),
        }
    }
}

/// Colours of a mesh, triangle by triangle.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshColors {
    /// Materials, at least one.
    pub materials: Vec<MeshMaterial>,
    /// Index of each triangle's material. Empty if all have the first one.
    pub of_triangles: Vec<u32>,
    /// Texture coordinates of each triangle's corners for pictures. Empty if they are the mesh's
    /// own.
    pub uvs: Vec<[[f32; 2]; 3]>,
    /// Linear red, green, blue and opacity of each triangle's corners, which multiply the material.
    /// Empty if all are 1.
    pub tints: Vec<[[f32; 4]; 3]>,
}

impl MeshColors {
    /// Creates a single opaque material for all triangles, with the mesh's own texture coordinates.
    pub fn of(factor: [f32; 3], picture: Option<Picture>) -> Self {
        let [red, green, blue] = factor;
        let picture = picture.map(Arc::new);
        MeshMaterial { factor: [red, green, blue, 1.0], picture, ..MeshMaterial::default() }.into()
    }

    /// Selects the colours of a framed mesh's triangles by their former numbers.
    pub(super) fn of_framed(self, mesh: &Mesh, numbers: &[u32]) -> Self {
        fn selected<T: Copy>(list: &[T], numbers: &[u32]) -> Vec<T> {
            numbers.iter().filter_map(|number| list.get(*number as usize).copied()).collect()
        }
        let Self { materials, of_triangles, uvs, tints } = self;
        let mut uvs = selected(&uvs, numbers);
        // NaN marks the mesh's own coordinates, which are filled in here.
        for (triangle, corners) in (0u32..).zip(&mut uvs) {
            if corners[0][0].is_nan() {
                *corners = mesh.corners(triangle).map(|corner| corner.uv.to_array());
            }
        }
        Self {
            materials,
            of_triangles: selected(&of_triangles, numbers),
            uvs,
            tints: selected(&tints, numbers),
        }
    }

    /// Number of materials that are not plain white and rough; colours of vertices count as one more.
    pub fn colored(&self) -> usize {
        let is_plain = |material: &MeshMaterial| {
            let is_white = material.factor == [1.0; 4] && material.values == MaterialValues::default();
            is_white && material.picture.is_none() && material.cutoff.is_none()
        };
        let of_materials = self.materials.iter().filter(|material| !is_plain(material)).count();
        of_materials + usize::from(!self.tints.is_empty())
    }

    /// Returns the material of a triangle. None, which means white, if it does not exist.
    pub fn material(&self, triangle: u32) -> Option<&MeshMaterial> {
        let number = self.of_triangles.get(triangle as usize).copied().unwrap_or_default();
        self.materials.get(number as usize)
    }

    /// Whether a triangle may be transparent in places: whether its material has a cut-off.
    pub fn has_mask(&self, triangle: u32) -> bool {
        self.material(triangle).is_some_and(|material| material.cutoff.is_some())
    }

    /// Returns the linear colour and opacity of a point of a triangle, given its barycentric
    /// weights and the mesh's own texture coordinates there.
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

    /// Whether a point of a triangle is visible: whether its opacity, as from [`Self::at`], reaches
    /// the material's cut-off.
    pub fn is_seen(&self, triangle: u32, weights: [f64; 3], uv: [f64; 2]) -> bool {
        let cutoff = self.material(triangle).and_then(|material| material.cutoff);
        cutoff.is_none_or(|cutoff| self.at(triangle, weights, uv)[3] >= cutoff)
    }
}

impl From<MeshMaterial> for MeshColors {
    /// Uses the material for all triangles, with the mesh's own texture coordinates.
    fn from(material: MeshMaterial) -> Self {
        Self { materials: vec![material], of_triangles: Vec::new(), uvs: Vec::new(), tints: Vec::new() }
    }
}

/// Samples a picture's colour and opacity bilinearly at its coordinates.
fn bilinear(picture: &Picture, wrap: [Wrap; 2], at: [f64; 2]) -> [f32; 4] {
    let size = [picture.width, picture.height];
    let along = |axis: usize| {
        let side = i64::from(size[axis]);
        // Whole periods are removed before numbers get too large for texels.
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
