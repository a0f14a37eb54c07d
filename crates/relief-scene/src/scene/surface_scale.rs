//! Scale of a surface: metres of its tiles and of its heights.

use super::error::{ValueError, ValueProblem};
use super::metres::MAX_METRES;
use super::surface_parts::Parts;
use super::{MeshChoice, Surface, SurfaceSpec};
use relief_core::HeightMap;
use relief_core::mesh::{Builtin, Mesh};

/// Default displacement between heights 0 and 1 in metres, if neither the scene nor the height
/// map's file states one.
const DEFAULT_SCALE_M: f64 = 0.05;

/// Deepest relief that counts as ground, as a part of the longer side of a tile. No landscape is
/// nearly as deep. A deeper file is a model without a unit or with a wrong one.
const DEEPEST_GROUND: f64 = 0.75;

/// Deepest relief that counts as ground if the file names the unit of its heights, as a part of the
/// longer side of a tile. Cliffs are that steep.
const DEEPEST_NAMED: f64 = 2.0;

/// Depth at which a model that is no ground is shown, as a part of the shorter side of a tile. Much
/// deeper ones would hide their lowest parts.
const DEPTH_OF_NO_GROUND: f64 = 0.25;

/// Valid lengths of a tile in metres.
pub(super) const LENGTHS_M: std::ops::RangeInclusive<f64> = 1e-9..=MAX_METRES;

/// Valid factors on the scale.
pub(super) const EXAGGERATIONS: std::ops::RangeInclusive<f64> = 1e-6..=1e6;

impl SurfaceSpec {
    /// Returns the surface with a given height map, and no other maps.
    pub(super) fn with_heights(&self, parts: Parts, map: HeightMap) -> Result<Surface, ValueError> {
        let map = match self.tile_size {
            Some([u, v]) => {
                let size_m = [u / f64::from(map.width()), v / f64::from(map.height())];
                map.with_texel_size_m(size_m)
            }
            None => Ok(map),
        };
        let map = map.map_err(|error| ValueProblem::from(error).of("tile-size"))?;
        // All other meshes do not depend on the height map.
        let mesh = match self.mesh.clone().unwrap_or_default() {
            MeshChoice::Builtin(Builtin::Plane) => self.placed(self.mesh_without_file(map.proportions())?)?,
            _ => parts.mesh,
        };
        let stated_m = map.stated_displacement_m();
        // A volume or a motif keeps its proportions: in larger tiles it is as much deeper.
        let is_solid = self.volume.is_some() || self.motif.is_some();
        let stated_m = match map.stated_tile_m() {
            Some([u, v]) if is_solid => {
                let [tile_u, tile_v] = mesh.tile_m();
                let larger = (tile_u * tile_v / (u * v)).sqrt();
                stated_m.map(|[low, high]| [larger * low, larger * high])
            }
            _ => stated_m,
        };
        // The part of the scale that a volume lies above the surface. Heights of a given scale are carved.
        let low = stated_m.filter(|[low, high]| is_solid && high > low);
        let carved = if self.motif.is_some() { 0.0 } else { -1.0 };
        let low = low.map_or(carved, |[low, high]| low / (high - low));
        let stated_m = stated_m.filter(|_| parts.scale_m.is_none());
        let of_mesh_alone = self.is_mesh_alone().then_some(0.0);
        let scale_m =
            parts.scale_m.or(of_mesh_alone).or(stated_m.map(|[low, high]| high - low)).or_else(|| {
                let stated = stated_scale_m(&map, &mesh)?;
                let [u, v] = mesh.tile_m();
                let deepest = if map.has_named_heights() { DEEPEST_NAMED } else { DEEPEST_GROUND };
                let is_ground = stated <= deepest * u.max(v);
                Some(if is_ground { stated } else { DEPTH_OF_NO_GROUND * u.min(v) })
            });
        let scale_m = parts.exaggerate * scale_m.unwrap_or(DEFAULT_SCALE_M);
        check_scale(scale_m)?;
        let low_m = stated_m.map_or(low * scale_m, |[low, _]| parts.exaggerate * low);
        let map = map
            .with_displacement(scale_m, parts.bias_m.unwrap_or(low_m))
            .map_err(|error| ValueProblem::from(error).of("scale"))?;
        Ok(Surface::new(mesh, map)
            .with_material(parts.material)
            .with_selection(parts.selection)
            .with_two_sided(parts.two_sided)
            .with_holes(parts.holes)
            .with_creases(parts.creases))
    }
}

pub(super) fn check_scale(scale_m: f64) -> Result<(), ValueError> {
    if (0.0..=MAX_METRES).contains(&scale_m) {
        return Ok(());
    }
    Err(ValueProblem::Number { value: scale_m, must: "from 0 to 1e9 metres" }.of("scale"))
}

/// Returns the scale that gives the relief the proportions stated in the height map's file.
///
/// The ratio of depth to a tile's side is the same on the mesh as in the file, as the geometric
/// mean of both directions. On a plane both directions agree.
pub(super) fn stated_scale_m(map: &HeightMap, mesh: &Mesh) -> Option<f64> {
    let (tile, span) = map.stated_lengths()?;
    let [u, v] = mesh.tile_m();
    Some(span * (u / tile[0] * (v / tile[1])).sqrt())
}
