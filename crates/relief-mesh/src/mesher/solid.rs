//! Solids: meshes that are closed by walls and a bottom.

use super::Base;
use super::outline::Outline;
use crate::plan::Plan;
use crate::surface::Relief;
use crate::{MeshSettings, MesherError, plane, triangles};

/// Parts that close a mesh.
#[derive(Debug)]
pub enum Solid {
    /// Walls and a flat bottom under a plane.
    Plane(plane::Solid),
    /// Walls and an underside of the mesh's own triangles.
    Triangles(triangles::Solid),
    /// Walls around the remaining triangles of a plane with holes, and these triangles at the
    /// bottom.
    Outline(Outline),
}

impl Solid {
    /// Plans the parts that close a mesh after everything else, if the settings ask for a solid.
    pub fn planned(
        base: &Base,
        relief: &Relief,
        settings: &MeshSettings,
        plan: &mut Plan,
    ) -> Result<Option<Self>, MesherError> {
        // Around holes the solid is planned once they are known.
        let Some(solid_m) = settings.solid_m.filter(|_| !relief.has_holes()) else { return Ok(None) };
        // Triangles may lie below the relief by their error.
        let error_m = error_m(base);
        let lowest_m = lowest_m(relief);
        let of_plane = |walls| plane::Solid::new(walls, lowest_m - error_m - solid_m);
        let solid = match base {
            Base::Grid(grid, _) => Self::Plane(of_plane(grid.walls(relief))),
            Base::Adapted(plane) => Self::Plane(of_plane(plane.walls(relief))),
            Base::Triangles(base, _) => Self::of_triangles(base, relief, [lowest_m, solid_m], plan)?,
            Base::Filled(filled) => {
                Self::of_triangles(filled.base(), relief, [lowest_m, solid_m + error_m], plan)?
            }
        };
        match &solid {
            Self::Outline(_) => {}
            Self::Plane(solid) => plan.solid(solid)?,
            Self::Triangles(solid) => {
                if let Some(base) = base.triangles() {
                    plan.underside(base, solid)?;
                }
            }
        }
        Ok(Some(solid))
    }

    fn of_triangles(
        base: &triangles::Triangles,
        relief: &Relief,
        metres: [f64; 2],
        plan: &Plan,
    ) -> Result<Self, MesherError> {
        Ok(Self::Triangles(triangles::Solid::new(base, relief, metres, plan.vertices)?))
    }

    /// Returns the number of bytes in use.
    pub fn bytes(&self) -> u64 {
        match self {
            Self::Plane(solid) => solid.bytes(),
            Self::Triangles(solid) => solid.bytes(),
            Self::Outline(outline) => outline.bytes(),
        }
    }
}

/// Returns the greatest distance of the relief from the triangles, in metres.
pub fn error_m(base: &Base) -> f64 {
    base.certificate().map_or(0.0, |certificate| certificate.error_m)
}

/// Returns the lowest displacement in metres.
pub fn lowest_m(relief: &Relief) -> f64 {
    relief.metres(f64::from(relief.map().extremes()[0]))
}
