//! Surfaces: a mesh with a height map on it, and what else belongs to it.

use super::SceneObject;
use super::color_place::ColorPlace;
use super::load_surface::stated_scale_m;
use super::surface_colors::{DrawnMaterial, SurfaceColors};
use crate::material::Material;
use relief_core::mesh::Mesh;
use relief_core::{HeightMap, Metric};
use relief_io::{MeshColors, MeshMaterial, NormalMap, Picture};
use relief_shaders::Selection;
use std::sync::Arc;

/// A mesh with a height map on it, its colours, its material, and how its relief is found.
///
/// Maps and mesh are shared, so that clones cost nothing and renderers know what they have seen before: one
/// that is given the same [`Arc`] again neither uploads nor prepares it again.
#[derive(Clone, Debug)]
pub struct Surface {
    mesh: Arc<Mesh>,
    /// Metres for each tile of the mesh, along `u` and `v`.
    tile_m: [f64; 2],
    height_map: Arc<HeightMap>,
    color: Option<Arc<Picture>>,
    normal_map: Option<Arc<Picture>>,
    selection: Selection,
    material: Material,
    two_sided: bool,
    has_holes: bool,
    has_creases: bool,
    object: Option<SceneObject>,
    color_place: ColorPlace,
    cutoff: f32,
    colors: Option<Arc<SurfaceColors>>,
    file_colors: Option<Arc<MeshColors>>,
}

impl Surface {
    /// A height map on a mesh that is placed in the world, with its tile factors applied: traced by the
    /// method `exact`, grey, seen from its front.
    pub fn new(mesh: impl Into<Arc<Mesh>>, height_map: impl Into<Arc<HeightMap>>) -> Self {
        let mesh = mesh.into();
        Self {
            tile_m: mesh.tile_m(),
            mesh,
            height_map: height_map.into(),
            color: None,
            normal_map: None,
            selection: Selection::exact(),
            material: Material::default(),
            two_sided: false,
            has_holes: false,
            has_creases: false,
            object: None,
            color_place: ColorPlace::default(),
            cutoff: 0.0,
            colors: None,
            file_colors: None,
        }
    }

    /// The same with the materials of its mesh's triangles.
    pub(super) fn with_colors(self, colors: Arc<SurfaceColors>) -> Self {
        Self { colors: Some(colors), ..self }
    }

    /// The materials of its triangles where there are several.
    pub fn colors(&self) -> Option<&Arc<SurfaceColors>> {
        self.colors.as_ref()
    }

    /// The same with the colours that its mesh's file has, triangle by triangle, however they are drawn.
    pub(super) fn with_file_colors(self, file_colors: Option<Arc<MeshColors>>) -> Self {
        Self { file_colors, ..self }
    }

    /// The colours of its mesh's file, triangle by triangle, where these are its own. How they are drawn, its
    /// material and colour picture say.
    pub fn file_colors(&self) -> Option<&Arc<MeshColors>> {
        self.file_colors.as_ref()
    }

    /// The materials of its mesh's file as they are drawn, and the number of each triangle's: none where all
    /// have the first one. None where the file has none that are drawn.
    pub fn file_materials(&self) -> Option<(Vec<MeshMaterial>, Vec<u32>)> {
        let of_file = self.file_colors.as_ref().filter(|colors| colors.colored() > 0)?;
        if let Some(colors) = &self.colors {
            let drawn = |drawn: &DrawnMaterial| self.of_material(drawn).as_material(drawn.name.clone());
            return Some((colors.materials.iter().map(drawn).collect(), colors.of_triangles.clone()));
        }
        // Several that are not drawn leave nothing.
        let is_drawn = self.color.is_some() || of_file.materials.len() == 1;
        let name = of_file.materials.first().and_then(|material| material.name.clone());
        is_drawn.then(|| (vec![self.as_material(name)], Vec::new()))
    }

    /// Its colour, picture and mask as a material of that name.
    fn as_material(&self, name: Option<Arc<str>>) -> MeshMaterial {
        let [red, green, blue] = self.material.diffuse().to_array();
        let factor = [red, green, blue, 1.0];
        let cutoff = Some(self.cutoff).filter(|cutoff| *cutoff > 0.0);
        let plain = MeshMaterial { cutoff, ..MeshMaterial::default() };
        MeshMaterial { name, factor, ..self.color_material().unwrap_or(plain) }
    }

    /// The same, all of that material.
    pub fn of_material(&self, drawn: &DrawnMaterial) -> Self {
        let material = self.material.with_diffuse(drawn.diffuse);
        let DrawnMaterial { picture, place, cutoff, .. } = drawn.clone();
        Self { color: picture, color_place: place, material, cutoff, colors: None, ..self.clone() }
    }

    /// The same with another mesh.
    #[must_use]
    pub fn with_mesh(self, mesh: impl Into<Arc<Mesh>>) -> Self {
        let mesh = mesh.into();
        Self { tile_m: mesh.tile_m(), mesh, object: None, colors: None, file_colors: None, ..self }
    }

    /// The same with another height map.
    #[must_use]
    pub fn with_height_map(self, height_map: impl Into<Arc<HeightMap>>) -> Self {
        Self { height_map: height_map.into(), object: None, ..self }
    }

    /// The same with a colour picture, which multiplies the material's diffuse colour. It is laid out and
    /// wrapped as the height map is.
    #[must_use]
    pub fn with_color(self, color: impl Into<Arc<Picture>>) -> Self {
        let color = Some(color.into());
        Self { color, color_place: ColorPlace::default(), colors: None, file_colors: None, ..self }
    }

    /// The same with the colour picture in another place, or with another wrap than the height map's.
    #[must_use]
    pub fn with_color_place(self, color_place: ColorPlace) -> Self {
        Self { color_place, ..self }
    }

    /// Where the colour picture lies.
    pub fn color_place(&self) -> ColorPlace {
        self.color_place
    }

    /// The colour picture in its place, as a material of a mesh.
    pub fn color_material(&self) -> Option<MeshMaterial> {
        let picture = self.color.clone()?;
        let ColorPlace { rows, wrap } = self.color_place;
        let wrap = wrap.unwrap_or([self.height_map.wrap(); 2]);
        let cutoff = Some(self.cutoff).filter(|cutoff| *cutoff > 0.0);
        Some(MeshMaterial {
            picture: Some(picture),
            wrap,
            transform: rows,
            cutoff,
            ..MeshMaterial::default()
        })
    }

    /// The same, seen only where the opacity of its colour picture is at least `cutoff`: 0, the default,
    /// shows all of it, and what is above 1 nothing. A surface without a picture is opaque.
    #[must_use]
    pub fn with_cutoff(self, cutoff: f32) -> Self {
        Self { cutoff, ..self }
    }

    /// The least opacity of its colour picture that is seen; 0 where all of it is.
    pub fn cutoff(&self) -> f32 {
        self.cutoff
    }

    /// The same with a tangent-space normal map in place of normals that are derived from the height map.
    #[must_use]
    pub fn with_normal_map(self, map: &NormalMap) -> Self {
        // Four numbers a texel, as the shaders take them.
        let texels = map.normals.iter().map(|&[x, y, z]| [x, y, z, 0.0]).collect();
        let picture = Picture { width: map.width, height: map.height, texels };
        Self { normal_map: Some(Arc::new(picture)), ..self }
    }

    /// The same with another choice of what is run: how the first hit is found, and how it is shaded.
    #[must_use]
    pub fn with_selection(self, selection: Selection) -> Self {
        Self { selection, ..self }
    }

    /// The same of another material.
    #[must_use]
    pub fn with_material(self, material: Material) -> Self {
        Self { material, ..self }
    }

    /// The same with triangles seen from behind drawn or not.
    #[must_use]
    pub fn with_two_sided(self, two_sided: bool) -> Self {
        Self { two_sided, ..self }
    }

    /// The same with the [holes](HeightMap::holes) of its height map seen or not: a ray that hits a dual cell
    /// with a texel that is a hole passes it, and shows nothing of the surface or what is behind. Shadows,
    /// light from all around and baked maps know of no holes: they see the heights that holes are filled
    /// with.
    #[must_use]
    pub fn with_holes(self, has_holes: bool) -> Self {
        Self { has_holes, ..self }
    }

    /// The same with normals that are derived from the height map taken across creases or not: of the central
    /// differences of the heights (Szirmay-Kalos and Umenhoffer 2008, equation 9) the part of a neighbouring
    /// dual cell is left to the own one where the slopes of both are some 27 to 45 degrees apart. Normal maps
    /// and levels of detail beyond the finest are as they are.
    #[must_use]
    pub fn with_creases(self, has_creases: bool) -> Self {
        Self { has_creases, ..self }
    }

    /// The same as what stands for that object.
    pub(super) fn showing(self, object: SceneObject) -> Self {
        Self { object: Some(object), ..self }
    }

    /// The object of images that it shows, if it shows one.
    pub fn object(&self) -> Option<&SceneObject> {
        self.object.as_ref()
    }

    /// The base mesh, placed in the world and tiled.
    pub fn mesh(&self) -> &Arc<Mesh> {
        &self.mesh
    }

    /// The height map with its wrap and displacement.
    pub fn height_map(&self) -> &Arc<HeightMap> {
        &self.height_map
    }

    /// The colour picture, if there is one.
    pub fn color(&self) -> Option<&Arc<Picture>> {
        self.color.as_ref()
    }

    /// The normal map, if there is one: in each texel a unit normal in tangent space, `x` along growing `u`,
    /// `y` along falling `v`, `z` out of the surface, and a 0. Without one, normals are derived from the
    /// height map.
    pub fn normal_map(&self) -> Option<&Arc<Picture>> {
        self.normal_map.as_ref()
    }

    /// What is run: how the first hit is found, and how it is shaded.
    pub fn selection(&self) -> &Selection {
        &self.selection
    }

    /// The material.
    pub fn material(&self) -> &Material {
        &self.material
    }

    /// Whether triangles seen from behind are drawn.
    pub fn two_sided(&self) -> bool {
        self.two_sided
    }

    /// Whether holes of the height map, where it has any, are seen.
    pub fn has_holes(&self) -> bool {
        self.has_holes
    }

    /// Whether normals end at creases.
    pub fn has_creases(&self) -> bool {
        self.has_creases
    }

    /// The displacement in metres between heights 0 and 1 that is true to the lengths that the height map's
    /// file states; `None` where it states none.
    pub fn true_scale_m(&self) -> Option<f64> {
        stated_scale_m(&self.height_map, &self.mesh)
    }

    /// The metres of the surface: of a tile on the mean over the mesh, and of the relief.
    pub fn metric(&self) -> Metric {
        Metric { tile_m: self.tile_m, scale_m: self.height_map.scale_m() }
    }
}
