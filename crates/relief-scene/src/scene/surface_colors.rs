//! Colours of surfaces whose mesh file has materials.

use std::sync::Arc;

use glam::Vec3;
use relief_core::mesh::Mesh;
use relief_io::{MaterialValues, MeshColors, MeshMaterial, Picture, Remark, omissions};

use super::color_place::{Affine, ColorPlace};
use crate::material::Material;
use crate::material_maps::MaterialMaps;

/// Most materials of a surface that are drawn. Each is drawn as a surface of its own.
const MOST_MATERIALS: usize = 64;

/// Material of a mesh's file as it is drawn.
#[derive(Clone, Debug)]
pub struct DrawnMaterial {
    /// Name in the mesh's file.
    pub name: Option<Arc<str>>,
    /// Linear diffuse colour, which multiplies the picture.
    pub diffuse: Vec3,
    /// Colour picture, in linear light.
    pub picture: Option<Arc<Picture>>,
    /// Placement of the picture on the mesh.
    pub place: ColorPlace,
    /// Least opacity of the picture that is visible. 0 shows all of it; a value above 1 shows
    /// nothing.
    pub cutoff: f32,
    /// Values and pictures beside the colour, as the file has them.
    pub values: Arc<MaterialValues>,
    /// Material that is shown. `None` stands for the surface's with the diffuse colour.
    pub material: Option<Material>,
    /// Maps that are shown. They lie as the colour picture does.
    pub maps: Option<Arc<MaterialMaps>>,
    /// Normals that are shown, as in [`Surface::normal_map`](super::Surface::normal_map).
    pub normals: Option<Arc<Picture>>,
}

/// Materials of a surface, and the material of each triangle.
#[derive(Clone, Debug)]
pub struct SurfaceColors {
    /// Materials, at least two.
    pub materials: Vec<DrawnMaterial>,
    /// Index into [`Self::materials`] for each triangle of the mesh, in the mesh's order.
    pub of_triangles: Vec<u32>,
}

/// DrawnColors colours of a surface.
#[derive(Clone, Debug)]
pub enum DrawnColors {
    /// All triangles have the same material.
    One(DrawnMaterial),
    /// The triangles have several materials.
    Several(SurfaceColors),
}

/// Triangles of the same colour.
struct Group {
    /// Index of the material.
    material: u32,
    /// Factors from the vertices' colours.
    tint: [f32; 4],
    /// Map from the mesh's to the picture's texture coordinates.
    own: Affine,
}

impl DrawnColors {
    /// Returns the drawn colours of a mesh's file, or `None` if none are drawn. Adds a note for
    /// everything that is left out.
    ///
    /// Several materials are drawn only if `splits` is true.
    pub fn of(colors: &MeshColors, mesh: &Mesh, splits: bool, notes: &mut Vec<Remark>) -> Option<Self> {
        let mut groups: Vec<Group> = Vec::new();
        let mut of_triangles = Vec::with_capacity(mesh.triangles().len());
        let mut is_uneven = false;
        for triangle in 0..mesh.triangles().len() as u32 {
            let material = colors.of_triangles.get(triangle as usize).copied().unwrap_or_default();
            let has_picture = colors.material(triangle).is_some_and(MeshMaterial::has_placed_pictures);
            let (tint, is_even) = tint_of(colors, triangle);
            is_uneven |= !is_even;
            let own = Some(Affine::SAME).filter(|_| !has_picture);
            let own = own.or_else(|| Affine::of_triangle(mesh, colors, triangle)).unwrap_or(Affine::SAME);
            let is =
                |group: &Group| group.material == material && group.tint == tint && group.own.is_near(&own);
            let place = groups.iter().rposition(is).unwrap_or_else(|| {
                groups.push(Group { material, tint, own });
                groups.len() - 1
            });
            if groups.len() > MOST_MATERIALS {
                let what =
                    format!("a surface shows at most {MOST_MATERIALS} colours and pictures of its mesh");
                let what = format!("the colours of its triangles are left out: {what}");
                notes.push(Remark::new(&omissions::LEFT_OUT_COLORS, what));
                return None;
            }
            of_triangles.push(place as u32);
        }
        if groups.len() > 1 && !splits {
            let what = "only the colours of a single material are shown on displaced triangles and slices";
            let what = format!("the colours of its {} materials are left out: {what}", groups.len());
            notes.push(Remark::new(&omissions::LEFT_OUT_COLORS, what));
            return None;
        }
        if is_uneven {
            let what = "the colours of its vertices are shown as their mean in each triangle";
            notes.push(Remark::new(&omissions::UNEVEN_COLORS, what));
        }
        let values: Vec<Arc<MaterialValues>> =
            colors.materials.iter().map(|material| Arc::new(material.values.clone())).collect();
        let mut materials: Vec<DrawnMaterial> = Vec::with_capacity(groups.len());
        for group in &groups {
            let material = colors.materials.get(group.material as usize)?;
            let [red, green, blue, opacity] = material.factor;
            let picture = material.picture.clone();
            let rows = group.own.then(material.transform).rows();
            let place = ColorPlace { rows, wrap: Some(material.wrap) };
            let [by_red, by_green, by_blue, by_opacity] = group.tint;
            let diffuse = Vec3::new(red, green, blue) * Vec3::new(by_red, by_green, by_blue);
            let cutoff = least_opacity(material.cutoff, opacity * by_opacity, picture.is_some());
            let name = material.name.clone();
            let values = Arc::clone(values.get(group.material as usize)?);
            materials.push(DrawnMaterial {
                name,
                diffuse,
                picture,
                place,
                cutoff,
                values,
                material: None,
                maps: None,
                normals: None,
            });
        }
        if materials.len() == 1 {
            return materials.pop().map(DrawnColors::One);
        }
        Some(DrawnColors::Several(SurfaceColors { materials, of_triangles }))
    }
}

impl DrawnColors {
    /// Returns the drawn materials.
    pub fn materials_mut(&mut self) -> &mut [DrawnMaterial] {
        match self {
            DrawnColors::One(material) => std::slice::from_mut(material),
            DrawnColors::Several(colors) => &mut colors.materials,
        }
    }
}

/// Returns the mean of the vertices' colours of a triangle, and whether all three are the same.
fn tint_of(colors: &MeshColors, triangle: u32) -> ([f32; 4], bool) {
    let Some(&[a, b, c]) = colors.tints.get(triangle as usize) else { return ([1.0; 4], true) };
    if a == b && b == c {
        return (a, true);
    }
    ([0, 1, 2, 3].map(|part| (a[part] + b[part] + c[part]) / 3.0), false)
}

/// Cutoff above any opacity.
const NOTHING: f32 = 2.0;

/// Returns the least visible opacity of a picture if `opacity` multiplies it.
fn least_opacity(cutoff: Option<f32>, opacity: f32, has_picture: bool) -> f32 {
    let Some(cutoff) = cutoff.filter(|cutoff| *cutoff > 0.0) else { return 0.0 };
    // A missing picture is opaque.
    match (has_picture, cutoff <= opacity) {
        (true, _) if opacity > 0.0 => (cutoff / opacity).min(NOTHING),
        (false, true) => 0.0,
        _ => NOTHING,
    }
}
