//! Meshes made solid.

use super::Base;
use super::outline::Outline;
use crate::plan::Plan;
use crate::surface::Relief;
use crate::{MeshSettings, MesherError, plane, triangles};

/// What closes a mesh.
#[derive(Debug)]
pub enum Solid {
    /// Walls and a flat bottom under a plane.
    Plane(plane::Solid),
    /// Walls and an underside of the mesh's own triangles.
    Triangles(triangles::Solid),
    /// Walls around what holes leave of a plane, and its triangles at the bottom.
    Outline(Outline),
}

impl Solid {
    /// What closes the mesh of a base, if that is wanted, planned after everything else.
    pub fn planned(
        base: &Base,
        relief: &Relief,
        settings: &MeshSettings,
        plan: &mut Plan,
    ) -> Result<Option<Self>, MesherError> {
        // Around holes it is known when these are.
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

    /// Bytes that are held.
    pub fn bytes(&self) -> u64 {
        match self {
            Self::Plane(solid) => solid.bytes(),
            Self::Triangles(solid) => solid.bytes(),
            Self::Outline(outline) => outline.bytes(),
        }
    }
}

/// How far the relief may be from the triangles.
pub fn error_m(base: &Base) -> f64 {
    base.certificate().map_or(0.0, |certificate| certificate.error_m)
}

/// The lowest displacement.
pub fn lowest_m(relief: &Relief) -> f64 {
    relief.metres(f64::from(relief.map().extremes()[0]))
}
