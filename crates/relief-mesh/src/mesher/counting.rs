//! Counting of a mesh: its plan, the triangles that are left out, and a solid around holes.

use std::collections::HashMap;

use rayon::prelude::*;
use relief_core::Watch;
use relief_core::mesh::{Mesh, Vertex};

use super::outline::{Outline, ShiftLimits, Sides};
use super::solid::{self, Solid};
use super::{BLOCKS_PER_THREAD, Base, Mesher};
use crate::cull::{self, ViewVolume};
use crate::edge::Divides;
use crate::error::MOST;
use crate::filling::Filling;
use crate::interior::Fills;
use crate::plan::{Plan, Work};
use crate::plane::{Adapted, Grid, Rectangle};
use crate::surface::Relief;
use crate::triangles::{self, Triangles};
use crate::vertex_set::VertexSet;
use crate::{MeshSettings, MesherError, Part, Shading, Spacing, Weights, check_pair, smooth};

/// Bytes of a vertex or triangle of a block, whichever takes more, while it is made and tested.
const BYTES_IN_A_BLOCK: u64 = 480;
impl Mesher {
    pub(super) fn of_relief(
        mesh: &Mesh,
        relief: Relief,
        settings: &MeshSettings,
        most: u64,
        watch: &Watch,
    ) -> Result<Self, MesherError> {
        check_pair(settings.edges, settings.interior)?;
        if settings.texels == 0 {
            return Err(MesherError::NoTexels);
        }
        if mesh.triangles().is_empty() {
            return Err(MesherError::Empty);
        }
        let rectangle = Rectangle::of_mesh(mesh);
        if rectangle.is_none() && settings.part != Part::WHOLE {
            return Err(MesherError::PartOfNoPlane);
        }
        if let Some(solid_m) = settings.solid_m.filter(|solid_m| !(*solid_m > 0.0 && solid_m.is_finite())) {
            return Err(MesherError::BadSolid { solid_m });
        }
        if matches!(settings.edges.divides, Divides::Voxels(_)) && settings.solid_m.is_some() {
            return Err(MesherError::SolidOfView);
        }
        if settings.solid_m.is_some() && relief.has_holes() && rectangle.is_none() {
            return Err(MesherError::SolidOfHoles);
        }
        cull::check(settings)?;
        settings.weights.check()?;
        let interior = settings.interior;
        if settings.weights != Weights::NONE && !interior.takes.contains(&Spacing::Even) {
            return Err(MesherError::Weighted { interior: interior.name, why: interior.why });
        }
        let mut patches = mesh.triangles().len();
        let base = match (settings.interior.fills, settings.edges.divides, rectangle) {
            (Fills::Patch(pattern), Divides::Evenly(evenly), Some(rectangle)) => {
                Base::Grid(Grid::new(rectangle, &relief, &evenly, settings)?, pattern)
            }
            (Fills::Patch(pattern), Divides::Voxels(_), rectangle) => {
                let tiles = rectangle.map(|plane| plane.tiles(&relief, settings.part)).transpose()?;
                let mesh = tiles.as_ref().unwrap_or(mesh);
                let base = Triangles::new(mesh, &relief, settings, most, watch)?;
                // Including triangles that are halved, or left out.
                patches = base.count() as usize;
                Base::Triangles(base.culled(&relief, settings, watch)?, pattern)
            }
            (Fills::Patch(pattern), _, None) => {
                Base::Triangles(Triangles::new(mesh, &relief, settings, most, watch)?, pattern)
            }
            (Fills::Ground(fill), Divides::Along(side), rectangle) => {
                if !(settings.error_m > 0.0 && settings.error_m.is_finite()) {
                    return Err(MesherError::BadTolerance { error_m: settings.error_m });
                }
                let filling = Filling { fill, side, most };
                match rectangle {
                    Some(plane) => Base::Adapted(Adapted::new(plane, &relief, settings, filling, watch)?),
                    None => Base::Filled(triangles::Adapted::new(mesh, &relief, settings, filling, watch)?),
                }
            }
            (Fills::Patch(_), Divides::Along(_), Some(_)) | (Fills::Ground(_), ..) => {
                // Pairs were checked, and spacings agree with the methods that divide.
                let (edges, interior) = (settings.edges.name, settings.interior.name);
                return Err(MesherError::Pair { edges, interior, why: settings.interior.why });
            }
        };
        let mut plan = Plan::default();
        match &base {
            Base::Triangles(triangles, pattern) => plan.triangles(triangles, pattern)?,
            Base::Grid(grid, pattern) => plan.grid(grid, pattern)?,
            Base::Filled(filled) => plan.filled(filled),
            Base::Adapted(plane) => plan.adapted(plane),
        }
        let solid = Solid::planned(&base, &relief, settings, &mut plan)?;
        let Plan { blocks, vertices, triangles, largest } = plan;
        // Triangles of a solid were not counted while patches were filled.
        let is_outlined = settings.solid_m.is_some() && relief.has_holes();
        if triangles > most && !is_outlined {
            return Err(MesherError::MoreThan { most });
        }
        let at_hand = 2 * rayon::current_num_threads() * BLOCKS_PER_THREAD;
        let of_normals =
            if settings.shading == Shading::Mesh { vertices * smooth::BYTES_PER_VERTEX } else { 0 };
        let of_tiles = match &base {
            Base::Triangles(..) | Base::Grid(..) => 0,
            Base::Filled(filled) => filled.bytes(),
            Base::Adapted(plane) => plane.bytes(),
        };
        let cull = settings.cull.filter(|cull| cull.leaves_out());
        let unseen = settings.view.as_ref().map(ViewVolume::new).zip(cull);
        let is_left_out = relief.has_holes() || unseen.is_some();
        let bytes = patches as u64 * Self::BYTES_PER_TRIANGLE
            + (blocks.len() * size_of::<Work>()) as u64
            + of_normals
            + of_tiles
            + if is_left_out { VertexSet::bytes(vertices) } else { 0 }
            + if is_outlined { Sides::BYTES_PER_TRIANGLE * triangles } else { 0 }
            + solid.as_ref().map_or(0, Solid::bytes)
            + at_hand as u64 * largest * BYTES_IN_A_BLOCK;
        let all_vertices = vertices;
        let shading = settings.shading;
        let mesher = Self {
            base,
            solid,
            relief,
            shading,
            pose: settings.pose,
            blocks,
            unseen,
            used: None,
            all_vertices,
            vertices,
            triangles,
            bytes,
        };
        if !is_left_out {
            return Ok(mesher);
        }
        if is_outlined && bytes > settings.max_bytes {
            return Err(MesherError::NoMemory { limit: settings.max_bytes });
        }
        let mesher = mesher.without_hidden(watch)?;
        let outlined = settings.solid_m.filter(|_| is_outlined);
        match outlined {
            Some(solid_m) => mesher.outlined(solid_m, settings.error_m, most, watch),
            None => Ok(mesher),
        }
    }

    /// Leaves out triangles over holes and unseen ones. They follow from the positions of points,
    /// so all triangles are made for it and discarded.
    fn without_hidden(self, watch: &Watch) -> Result<Self, MesherError> {
        let mut used = VertexSet::empty(self.vertices);
        for group in self.blocks.chunks(rayon::current_num_threads() * BLOCKS_PER_THREAD) {
            watch.check()?;
            let remaining: Vec<Vec<[u32; 3]>> =
                group.par_iter().map(|work| self.remaining_triangles(work)).collect();
            for triangles in remaining {
                used.add(&triangles);
            }
        }
        if self.relief.has_holes() && used.triangles() == 0 {
            return Err(MesherError::AllHoles);
        }
        used.count();
        Ok(Self { vertices: used.vertices(), triangles: used.triangles(), used: Some(used), ..self })
    }

    /// Adds walls along the outline of a plane with holes, and a bottom.
    fn outlined(
        mut self,
        solid_m: f64,
        tolerance_m: f64,
        most: u64,
        watch: &Watch,
    ) -> Result<Self, MesherError> {
        let (Some(rectangle), Some(mut used)) = (self.base.rectangle(), self.used.take()) else {
            return Err(MesherError::SolidOfHoles);
        };
        if used.triangles() > u64::from(u32::MAX / 3) {
            return Err(MesherError::TooLarge { vertices: self.vertices, triangles: 2 * used.triangles() });
        }
        let depth_m = solid::lowest_m(&self.relief) - solid::error_m(&self.base) - solid_m;
        let bottom = rectangle.bottom(&self.relief, depth_m);
        let exact = self.base.certificate().is_none();
        let tolerance_m = if exact { f64::INFINITY } else { tolerance_m };
        let limits = ShiftLimits { texel_m: rectangle.texel_m(&self.relief), tolerance_m };
        let sides = {
            let mut triangles = Vec::with_capacity(used.triangles() as usize);
            for group in self.groups() {
                watch.check()?;
                let remaining: Vec<Vec<[u32; 3]>> =
                    group.par_iter().map(|work| self.remaining_triangles(work)).collect();
                triangles.extend(remaining.into_iter().flatten());
            }
            Sides::of(&triangles)
        };
        let wanted = sides.wanted();
        let mut found: HashMap<u32, Vertex> = HashMap::with_capacity(wanted.len());
        for group in self.groups() {
            watch.check()?;
            let vertices: Vec<Vec<(u32, Vertex)>> =
                group.par_iter().map(|work| self.find_vertices(work, &wanted)).collect();
            found.extend(vertices.into_iter().flatten());
        }
        let mut outline = Outline::new(sides, &found, self.all_vertices as u32, bottom, limits);
        used.add_vertices(self.all_vertices, outline.copy_count());
        used.count();
        let (above, walls) = (used.vertices(), u64::from(outline.wall_count()));
        let (vertices, triangles) = (2 * above, 2 * used.triangles() + 2 * walls);
        if vertices.max(triangles) > MOST {
            return Err(MesherError::TooLarge { vertices, triangles });
        }
        if triangles > most {
            return Err(MesherError::MoreThan { most });
        }
        outline.first_below = above as u32;
        let closing = Plan::closing(&self.blocks, outline.copy_count(), outline.wall_count());
        self.blocks.extend(closing);
        let bytes = self.bytes + outline.bytes();
        let solid = Some(Solid::Outline(outline));
        Ok(Self { vertices, triangles, used: Some(used), solid, bytes, ..self })
    }

    /// Returns the blocks in groups that are made at once.
    fn groups(&self) -> impl Iterator<Item = &[Work]> {
        self.blocks.chunks(rayon::current_num_threads() * BLOCKS_PER_THREAD)
    }
}
