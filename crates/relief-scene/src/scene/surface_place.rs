//! Place of a surface in the world: its mesh, tiles, position, rotation and size.

use super::error::{ValueError, ValueProblem};
use super::metres::check_metres;
use super::{MeshChoice, SurfaceSpec};
use glam::Vec2;
use relief_core::mesh::{Mesh, Placement, square};
use relief_core::object::ImageObject;

/// Most tiles along an axis; its inverse is the fewest. Beyond it, `f32` cannot distinguish the
/// texels of a tile, and much farther it overflows.
pub(super) const MAX_TILES: f32 = 1e6;

/// Largest factor on a mesh; its inverse is the smallest. Lengths in metres then stay within the
/// range of `f32` arithmetic.
pub(super) const MAX_SIZE: f64 = 1e6;

impl SurfaceSpec {
    /// Returns the number of tiles along `u` and `v`.
    fn tiles(&self) -> Result<[f32; 2], ValueError> {
        let tiles = self.tile.unwrap_or([1.0, 1.0]);
        let possible = 1.0 / MAX_TILES..=MAX_TILES;
        match tiles.iter().find(|tiles| !possible.contains(tiles)) {
            Some(&value) => {
                let must = "from 1e-6 to 1e6";
                Err(ValueProblem::Number { value: f64::from(value), must }.of("tile"))
            }
            None => Ok(tiles),
        }
    }

    /// Returns the built-in mesh for a height map with these proportions of its tile, or a square
    /// for a file's mesh.
    pub(super) fn mesh_without_file(&self, [u, v]: [f64; 2]) -> Result<Mesh, ValueError> {
        let [across, down] = self.tiles()?.map(f64::from);
        let mesh = match self.mesh.clone().unwrap_or_default() {
            MeshChoice::Builtin(builtin) => builtin.build([u * across, v * down]),
            MeshChoice::File(_) => square(1),
        };
        mesh.map_err(|error| ValueProblem::from(error).of("mesh"))
    }

    /// Returns a mesh in world space, with its tiles.
    pub(super) fn placed(&self, mesh: Mesh) -> Result<Mesh, ValueError> {
        let mesh =
            mesh.tiled(Vec2::from(self.tiles()?)).map_err(|error| ValueProblem::from(error).of("tile"))?;
        let placement = self.placement()?;
        mesh.placed(&placement).map_err(|error| ValueProblem::from(error).of("position"))
    }

    /// Returns the placement in world space.
    fn placement(&self) -> Result<Placement, ValueError> {
        let placement = Placement {
            position_m: self.position.unwrap_or_default().into(),
            rotation_degrees: self.rotation.unwrap_or_default().into(),
            size: self.mesh_scale.unwrap_or(1.0),
        };
        check_metres("position", self.position.as_ref().map_or(&[], |position| position))?;
        if let Some(&value) = self.rotation.iter().flatten().find(|turn| !turn.is_finite()) {
            return Err(ValueProblem::Number { value, must: "finite" }.of("rotation"));
        }
        if !(1.0 / MAX_SIZE..=MAX_SIZE).contains(&placement.size) {
            let (value, must) = (placement.size, "from 1e-6 to 1e6");
            return Err(ValueProblem::Number { value, must }.of("mesh-scale"));
        }
        Ok(placement)
    }

    pub(super) fn placed_object(&self, object: &ImageObject) -> Result<ImageObject, ValueError> {
        object.placed(&self.placement()?).map_err(|error| ValueProblem::from(error).of("position"))
    }
}
