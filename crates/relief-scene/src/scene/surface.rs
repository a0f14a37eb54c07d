//! Surfaces of a scene: a base mesh with a height map, colours, a material and a method.

use super::SceneObject;
use super::color_place::ColorPlace;
use super::surface_colors::{DrawnMaterial, SurfaceColors};
use super::surface_scale::stated_scale_m;
use crate::material::Material;
use crate::material_maps::MaterialMaps;
use relief_core::mesh::Mesh;
use relief_core::{HeightMap, HeightMapError, Metric, MotifTree, Volume, Wrap};
use relief_io::{MaterialValues, MeshColors, MeshMaterial, NormalMap, Picture};
use relief_shaders::Selection;
use relief_shaders::field::Solids;
use std::sync::Arc;

/// Surface: a base mesh with a height map, colours, a material, and the method that finds its
/// relief.
///
/// Maps and mesh are shared, so clones cost nothing. A renderer that gets the same [`Arc`] again
/// neither uploads nor prepares it again.
#[derive(Clone, Debug)]
pub struct Surface {
    mesh: Arc<Mesh>,
    /// Size of the mesh's tiles in metres, along `u` and `v`.
    tile_m: [f64; 2],
    height_map: Arc<HeightMap>,
    color: Option<Arc<Picture>>,
    normal_map: Option<Arc<Picture>>,
    material_maps: Option<Arc<MaterialMaps>>,
    selection: Selection,
    material: Material,
    two_sided: bool,
    has_holes: bool,
    has_creases: bool,
    object: Option<SceneObject>,
    volume: Option<Arc<Volume>>,
    motif: Option<MotifTree>,
    color_place: ColorPlace,
    cutoff: f32,
    colors: Option<Arc<SurfaceColors>>,
    file_colors: Option<Arc<MeshColors>>,
    file_values: Option<Arc<MaterialValues>>,
}

impl Surface {
    /// Creates a grey, one-sided surface that is traced by the method `exact`. The mesh is in world
    /// space, with its tile factors applied.
    pub fn new(mesh: impl Into<Arc<Mesh>>, height_map: impl Into<Arc<HeightMap>>) -> Self {
        let mesh = mesh.into();
        Self {
            tile_m: mesh.tile_m(),
            mesh,
            height_map: height_map.into(),
            color: None,
            normal_map: None,
            material_maps: None,
            selection: Selection::exact(),
            material: Material::default(),
            two_sided: false,
            has_holes: false,
            has_creases: false,
            object: None,
            volume: None,
            motif: None,
            color_place: ColorPlace::default(),
            cutoff: 0.0,
            colors: None,
            file_colors: None,
            file_values: None,
        }
    }

    /// Sets the materials of the mesh's triangles.
    pub(super) fn with_colors(self, colors: Arc<SurfaceColors>) -> Self {
        Self { colors: Some(colors), ..self }
    }

    /// Returns the materials of the triangles if there are several. `None` means that all triangles
    /// share [`Self::material`].
    pub fn colors(&self) -> Option<&Arc<SurfaceColors>> {
        self.colors.as_ref()
    }

    /// Sets the colours of the mesh's file, triangle by triangle, whether they are drawn or not.
    pub(super) fn with_file_colors(self, file_colors: Option<Arc<MeshColors>>) -> Self {
        Self { file_colors, ..self }
    }

    /// Shows the only material of the mesh's file: its values, maps and normals, and its colours unless
    /// `keeps_color`.
    pub(super) fn with_file_material(self, drawn: DrawnMaterial, keeps_color: bool) -> Self {
        self.of_material(&if keeps_color { self.with_own_color(drawn) } else { drawn })
    }

    /// Returns a drawn material with this surface's colours in place of its own.
    pub(super) fn with_own_color(&self, drawn: DrawnMaterial) -> DrawnMaterial {
        DrawnMaterial {
            diffuse: self.material.diffuse(),
            picture: self.color.clone(),
            place: if self.color.is_some() { self.color_place } else { drawn.place },
            cutoff: self.cutoff,
            ..drawn
        }
    }

    /// Returns the colours of the mesh's file, triangle by triangle, if the surface has them.
    /// Material and colour picture define how they are drawn.
    pub fn file_colors(&self) -> Option<&Arc<MeshColors>> {
        self.file_colors.as_ref()
    }

    /// Returns the drawn materials of the mesh's file, and the index of each triangle's material.
    /// The indices are empty if all triangles have the first material. Returns `None` if no colours
    /// of the file are drawn.
    pub fn file_materials(&self) -> Option<(Vec<MeshMaterial>, Vec<u32>)> {
        let of_file = self.file_colors.as_ref().filter(|colors| colors.colored() > 0)?;
        if let Some(colors) = &self.colors {
            let drawn = |drawn: &DrawnMaterial| self.of_material(drawn).as_material(drawn.name.clone());
            return Some((colors.materials.iter().map(drawn).collect(), colors.of_triangles.clone()));
        }
        // Several materials that are not drawn give no material at all.
        let is_drawn = self.color.is_some() || of_file.materials.len() == 1;
        let name = of_file.materials.first().and_then(|material| material.name.clone());
        is_drawn.then(|| (vec![self.as_material(name)], Vec::new()))
    }

    /// Returns colour, picture, mask and values of the file as a material called `name`.
    fn as_material(&self, name: Option<Arc<str>>) -> MeshMaterial {
        let [red, green, blue] = self.material.diffuse().to_array();
        let factor = [red, green, blue, 1.0];
        let cutoff = Some(self.cutoff).filter(|cutoff| *cutoff > 0.0);
        let values = self.file_values.as_deref().cloned().unwrap_or_default();
        let mut plain = MeshMaterial { cutoff, ..MeshMaterial::default() };
        if let ColorPlace { rows, wrap: Some(wrap) } = self.color_place
            && values.textures.has_maps()
        {
            (plain.transform, plain.wrap) = (rows, wrap);
        }
        MeshMaterial { name, factor, values, ..self.color_material().unwrap_or(plain) }
    }

    /// Returns this surface with one material for all of its triangles: its colour, picture, placement
    /// and cutoff, and its values, maps and normals.
    pub fn of_material(&self, drawn: &DrawnMaterial) -> Self {
        let DrawnMaterial { picture, place, cutoff, values, maps, normals, .. } = drawn.clone();
        let material = drawn.material.unwrap_or_else(|| self.material.with_diffuse(drawn.diffuse));
        Self {
            color: picture,
            color_place: place,
            material,
            cutoff,
            colors: None,
            material_maps: maps.or_else(|| self.material_maps.clone()),
            normal_map: normals.or_else(|| self.normal_map.clone()),
            file_values: Some(values),
            ..self.clone()
        }
    }

    /// Replaces the mesh. The object and the colours of the old mesh are dropped.
    #[must_use]
    pub fn with_mesh(self, mesh: impl Into<Arc<Mesh>>) -> Self {
        let mesh = mesh.into();
        Self {
            tile_m: mesh.tile_m(),
            mesh,
            object: None,
            colors: None,
            file_colors: None,
            file_values: None,
            ..self
        }
    }

    /// Replaces the height map. The object, the volume or the motif is dropped.
    #[must_use]
    pub fn with_height_map(self, height_map: impl Into<Arc<HeightMap>>) -> Self {
        Self { height_map: height_map.into(), object: None, volume: None, motif: None, ..self }
    }

    /// Replaces the height map by a volume, with the volume's scale and bias. [`Self::height_map`] then holds
    /// its slices side by side. The object is dropped.
    ///
    /// The method must find volumes: `voxels`, or a pair of stages such as `linear` and `binary`.
    #[must_use]
    pub fn with_volume(self, volume: impl Into<Arc<Volume>>) -> Self {
        let volume = volume.into();
        let height_map = Arc::new(volume.atlas().clone());
        let selection = self.selection.with_solids(Solids::Volumes).with_volume_size(volume.size());
        Self { height_map, volume: Some(volume), motif: None, object: None, selection, ..self }
    }

    /// Replaces the height map by a motif, which repeats with the tiles. [`Self::height_map`] then says its
    /// scale and bias: it is level, has one texel, and repeats. The object is dropped.
    ///
    /// The method must find motifs: `shell-map`.
    ///
    /// # Errors
    ///
    /// When the scale or the bias is not finite.
    pub fn with_motif(self, motif: MotifTree, scale_m: f64, bias_m: f64) -> Result<Self, HeightMapError> {
        let level = HeightMap::new(1, 1, vec![0.0], Wrap::Repeat)?.with_displacement(scale_m, bias_m)?;
        let selection = self.selection.with_solids(Solids::Motifs).with_volume_size([0; 3]);
        let height_map = Arc::new(level);
        Ok(Self { height_map, motif: Some(motif), volume: None, object: None, selection, ..self })
    }

    /// Sets a colour picture, which multiplies the material's diffuse colour. It has the height
    /// map's texture coordinates and wrap. The colours of the mesh's file are dropped.
    #[must_use]
    pub fn with_color(self, color: impl Into<Arc<Picture>>) -> Self {
        let color = Some(color.into());
        Self {
            color,
            color_place: ColorPlace::default(),
            colors: None,
            file_colors: None,
            file_values: None,
            ..self
        }
    }

    /// Sets the placement and the wrap of the colour picture. By default they follow the height map.
    #[must_use]
    pub fn with_color_place(self, color_place: ColorPlace) -> Self {
        Self { color_place, ..self }
    }

    /// Returns the placement of the colour picture.
    pub fn color_place(&self) -> ColorPlace {
        self.color_place
    }

    /// Returns the colour picture with its placement as a material of a mesh. `None` without a
    /// picture.
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

    /// Sets the least opacity of the colour picture that is visible. 0, the default, shows all of
    /// it; a value above 1 shows nothing. A surface without a picture is opaque.
    #[must_use]
    pub fn with_cutoff(self, cutoff: f32) -> Self {
        Self { cutoff, ..self }
    }

    /// Returns the least opacity of the colour picture that is visible. 0 shows all of it.
    pub fn cutoff(&self) -> f32 {
        self.cutoff
    }

    /// Sets a tangent-space normal map, in place of normals derived from the height map.
    #[must_use]
    pub fn with_normal_map(self, map: &NormalMap) -> Self {
        // Four numbers a texel, as the shaders take them.
        let texels = map.normals.iter().map(|&[x, y, z]| [x, y, z, 0.0]).collect();
        let picture = Picture { width: map.width, height: map.height, texels };
        Self { normal_map: Some(Arc::new(picture)), ..self }
    }

    /// Sets maps that multiply the material's values. They have the colour picture's coordinates and
    /// wrap. Shadings other than `metallic-roughness` ignore them.
    #[must_use]
    pub fn with_material_maps(self, maps: impl Into<Arc<MaterialMaps>>) -> Self {
        Self { material_maps: Some(maps.into()), ..self }
    }

    /// Sets the variants of all stages: how the first hit is found and how it is shaded.
    #[must_use]
    pub fn with_selection(self, selection: Selection) -> Self {
        let volume_size = self.volume.as_ref().map_or([0; 3], |volume| volume.size());
        Self { selection: selection.with_volume_size(volume_size), ..self }
    }

    /// Sets the material.
    #[must_use]
    pub fn with_material(self, material: Material) -> Self {
        Self { material, ..self }
    }

    /// Sets whether triangles seen from behind are drawn. Default: `false`.
    #[must_use]
    pub fn with_two_sided(self, two_sided: bool) -> Self {
        Self { two_sided, ..self }
    }

    /// Sets whether the [holes](HeightMap::holes) of the height map are open. Default: `false`.
    ///
    /// A ray passes a dual cell with a texel that is a hole, and the picture shows what is behind.
    /// Shadows, ambient light and baked maps ignore holes: they use the heights with which holes
    /// are filled.
    #[must_use]
    pub fn with_holes(self, has_holes: bool) -> Self {
        Self { has_holes, ..self }
    }

    /// Sets whether normals that are derived from the height map end at creases. Default: `false`,
    /// normals are smooth across creases.
    ///
    /// The normals come from central differences of the heights (Szirmay-Kalos and Umenhoffer 2008,
    /// equation 9). At a crease, the slope of the own dual cell replaces the neighbouring cell's
    /// part. A crease is where both slopes are some 27 to 45 degrees apart. Normal maps and levels
    /// of detail beyond the finest do not change.
    #[must_use]
    pub fn with_creases(self, has_creases: bool) -> Self {
        Self { has_creases, ..self }
    }

    /// Sets the object that the surface shows.
    pub(super) fn showing(self, object: SceneObject) -> Self {
        Self { object: Some(object), ..self }
    }

    /// Returns the depth object that the surface shows, if any.
    pub fn object(&self) -> Option<&SceneObject> {
        self.object.as_ref()
    }

    /// Returns the volume that the surface shows, if any.
    pub fn volume(&self) -> Option<&Arc<Volume>> {
        self.volume.as_ref()
    }

    /// Returns the motif that the surface shows, if any.
    pub fn motif(&self) -> Option<&MotifTree> {
        self.motif.as_ref()
    }

    /// Returns what the surface shows, whichever method is chosen: heights, a volume or a motif. Objects are
    /// images of heights.
    pub fn solids(&self) -> Solids {
        match (&self.volume, &self.motif) {
            (Some(_), _) => Solids::Volumes,
            (None, Some(_)) => Solids::Motifs,
            (None, None) => Solids::Heights,
        }
    }

    /// Returns the base mesh in world space, with its tiles.
    pub fn mesh(&self) -> &Arc<Mesh> {
        &self.mesh
    }

    /// Returns the height map with its wrap and displacement.
    pub fn height_map(&self) -> &Arc<HeightMap> {
        &self.height_map
    }

    /// Returns the colour picture, if there is one.
    pub fn color(&self) -> Option<&Arc<Picture>> {
        self.color.as_ref()
    }

    /// Returns the normal map, if there is one. Without one, normals are derived from the height
    /// map.
    ///
    /// Each texel holds a unit normal in tangent space and a 0: `x` along growing `u`, `y` along
    /// falling `v`, `z` out of the surface.
    pub fn normal_map(&self) -> Option<&Arc<Picture>> {
        self.normal_map.as_ref()
    }

    /// Returns the maps of the material, if there are any.
    pub fn material_maps(&self) -> Option<&Arc<MaterialMaps>> {
        self.material_maps.as_ref()
    }

    /// Returns the variants of all stages: how the first hit is found and how it is shaded.
    pub fn selection(&self) -> &Selection {
        &self.selection
    }

    /// Returns the material. [`Self::colors`] replaces its diffuse colour triangle by triangle.
    pub fn material(&self) -> &Material {
        &self.material
    }

    /// Returns whether triangles seen from behind are drawn.
    pub fn two_sided(&self) -> bool {
        self.two_sided
    }

    /// Returns whether holes of the height map are open.
    pub fn has_holes(&self) -> bool {
        self.has_holes
    }

    /// Returns whether derived normals end at creases.
    pub fn has_creases(&self) -> bool {
        self.has_creases
    }

    /// Returns the displacement in metres between heights 0 and 1 that matches the lengths stated
    /// in the height map's file. `None` if the file states no lengths.
    pub fn true_scale_m(&self) -> Option<f64> {
        stated_scale_m(&self.height_map, &self.mesh)
    }

    /// Returns the lengths of the surface in metres: the mean size of a tile over the mesh, and the
    /// scale.
    pub fn metric(&self) -> Metric {
        Metric { tile_m: self.tile_m, scale_m: self.height_map.scale_m() }
    }
}
