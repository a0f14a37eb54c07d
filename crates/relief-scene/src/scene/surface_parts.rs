//! Parts of a surface that need no file: completed and checked.

use super::error::{ValueError, ValueProblem};
use super::extinction::check_extinction;
use super::metres::{MAX_METRES, check_metres};
use super::surface_scale::{EXAGGERATIONS, LENGTHS_M, check_scale};
use super::surface_selection::SceneContext;
use super::{BaseThickness, MeshChoice, ObjectProblem, SceneObject, Surface, SurfaceSpec};
use crate::material::Material;
use glam::{DVec3, Vec3};
use relief_core::mesh::{Mesh, square};
use relief_core::{HeightMap, MotifTree, TileTriangle, Volume, Wrap};
use relief_io::HeightRange;
use relief_shaders::Selection;

/// Key that a projection needs.
const MESH_OF_FILE: &str = "mesh FILE";

/// Parts of a surface that need no file, completed and checked.
pub struct Parts {
    pub(super) mesh: Mesh,
    pub(super) material: Material,
    pub(super) selection: Selection,
    /// `None` stands for the height map's file or the default.
    pub(super) scale_m: Option<f64>,
    /// `None` stands for minus the scale.
    pub(super) bias_m: Option<f64>,
    /// Factor on the scale, and on the bias if it is not given.
    pub(super) exaggerate: f64,
    pub(super) two_sided: bool,
    pub(super) holes: bool,
    pub(super) creases: bool,
}

impl Parts {
    /// Returns the variants of all stages.
    pub fn selection(&self) -> &Selection {
        &self.selection
    }
}

impl SurfaceSpec {
    /// Returns the parts that need no file, completed and checked, for `samples` samples per pixel.
    pub(super) fn parts(&self, samples: u32, context: &SceneContext) -> Result<Parts, ValueError> {
        if let Some(key) = self.key_of_relief().filter(|_| self.object.is_some()) {
            return Err(ValueProblem::Excludes("object").of(key));
        }
        if let Some(key) = self.key_of_heights().filter(|_| self.volume.is_some()) {
            return Err(ValueProblem::Excludes("volume").of(key));
        }
        if self.motif.is_some() {
            if self.volume.is_some() {
                return Err(ValueProblem::Excludes("motif").of("volume"));
            }
            if let Some(key) = self.key_of_heights() {
                return Err(ValueProblem::Excludes("motif").of(key));
            }
            if let Some(wrap) = self.wrap.filter(|wrap| *wrap != Wrap::Repeat) {
                return Err(ValueProblem::WrapOfMotif(wrap).of("wrap"));
            }
            if self.scale == Some(0.0) {
                return Err(ValueProblem::Number { value: 0.0, must: "above 0" }.of("scale"));
            }
        } else if self.axes.is_some() {
            return Err(ValueProblem::Needs("motif").of("axes"));
        }
        self.scale.map_or(Ok(()), check_scale)?;
        check_metres("bias", self.bias.as_slice())?;
        self.extinction.map_or(Ok(()), check_extinction)?;
        if let Some(value) = self.exaggerate.filter(|factor| !EXAGGERATIONS.contains(factor)) {
            return Err(ValueProblem::Number { value, must: "from 1e-6 to 1e6" }.of("exaggerate"));
        }
        if let Some(&value) = self.tile_size.iter().flatten().find(|length| !LENGTHS_M.contains(length)) {
            return Err(ValueProblem::Number { value, must: "from 1e-9 to 1e9 metres" }.of("tile-size"));
        }
        if let Some([low, high]) = self.range.and_then(HeightRange::between)
            && !(low.is_finite() && high.is_finite() && low < high)
        {
            let (value, must) =
                if low.is_finite() { (high, "finite and above the first") } else { (low, "finite") };
            return Err(ValueProblem::Number { value, must }.of("range"));
        }
        if let Some([low, high]) = self.elevation {
            check_metres("elevation", &[low, high])?;
            if low >= high {
                let must = "above the first";
                return Err(ValueProblem::Number { value: high, must }.of("elevation"));
            }
        }
        if let Some(value) = self.nodata.filter(|value| !value.is_finite()) {
            let must = "finite, as texels that are NaN or infinite never have a value";
            return Err(ValueProblem::Number { value, must }.of("nodata"));
        }
        if self.project.is_some() && !matches!(self.mesh, Some(MeshChoice::File(_))) {
            return Err(ValueProblem::Needs(MESH_OF_FILE).of("project"));
        }
        if self.mesh_up.is_some() && !matches!(self.mesh, Some(MeshChoice::File(_))) {
            return Err(ValueProblem::Needs(MESH_OF_FILE).of("mesh-up"));
        }
        if self.ramp.is_some() && self.color.is_some() {
            return Err(ValueProblem::Excludes("color").of("ramp"));
        }
        if self.ramp.is_some() && self.is_mesh_alone() && self.textures.is_none() {
            return Err(ValueProblem::Needs("height").of("ramp"));
        }
        if self.base.is_some() && self.walls != Some(true) {
            return Err(ValueProblem::Needs("walls").of("base"));
        }
        let (metres, must) = match self.base.unwrap_or_default() {
            BaseThickness::Metres(metres) => (metres, "above 0 and at most 1e9 metres"),
            BaseThickness::Share(share) => (share, "above 0 and at most 1e9"),
        };
        if !(metres > 0.0 && metres <= MAX_METRES) {
            return Err(ValueProblem::Number { value: metres, must }.of("base"));
        }
        let selection = self.selection(samples, context)?;
        if self.has_walls() {
            self.check_walls(&selection)?;
        }
        Ok(Parts {
            mesh: self.placed(self.mesh_without_file([1.0, 1.0])?)?,
            material: self.material_of(None, &selection)?,
            selection,
            scale_m: self.scale,
            bias_m: self.bias,
            exaggerate: self.exaggerate.unwrap_or(1.0),
            two_sided: self.two_sided.unwrap_or_default(),
            holes: self.holes.unwrap_or_default(),
            creases: self.creases.unwrap_or_default(),
        })
    }

    /// Replaces the mesh of `parts` by a square.
    pub(super) fn on_a_square(&self, parts: Parts) -> Result<Parts, ValueError> {
        let mesh = square(1).map_err(|error| ValueProblem::from(error).of("mesh"))?;
        Ok(Parts { mesh: self.placed(mesh)?, ..parts })
    }

    /// Returns the surface with placeholders for the files of its relief or object, and no other
    /// maps.
    pub(super) fn stand_in(&self, parts: Parts) -> Result<Surface, ValueError> {
        if self.object.is_none() {
            let problem = |problem: relief_core::HeightMapError| ValueProblem::from(problem).of("height");
            let flat = HeightMap::new(1, 1, vec![0.0], self.wrap.unwrap_or_default()).map_err(problem)?;
            let surface = self.with_heights(parts, flat)?;
            if self.motif.is_some() {
                let corners = [DVec3::ZERO, DVec3::X, DVec3::Y];
                let triangle = TileTriangle { corners, normals: [Vec3::Z; 3] };
                let motif =
                    MotifTree::new(&[triangle]).map_err(|error| ValueProblem::from(error).of("motif"))?;
                let (scale_m, bias_m) = (surface.height_map().scale_m(), surface.height_map().bias_m());
                return surface.with_motif(motif, scale_m, bias_m).map_err(problem);
            }
            if self.volume.is_none() {
                return Ok(surface);
            }
            let volume = Volume::new([1; 3], &[0.0], self.wrap.unwrap_or_default());
            return Ok(surface.with_volume(volume.map_err(|error| ValueProblem::from(error).of("volume"))?));
        }
        let problem = |problem: ObjectProblem| ValueProblem::from(problem).of("object");
        let object = self.placed_object(&SceneObject::stand_in().map_err(problem)?)?;
        let surface = Surface::of_object(object).map_err(problem)?;
        Ok(surface.with_material(parts.material).with_selection(parts.selection))
    }
}
