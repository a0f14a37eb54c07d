//! Base triangles that are filled with as few triangles as a tolerance allows.

use std::sync::atomic::{AtomicU64, Ordering};

use rayon::prelude::*;
use relief_core::Watch;
use relief_core::mesh::Mesh;

use super::profile::turning;
use super::{Triangles, counted};
use crate::error::MOST;
use crate::filling::{FillBudget, Filling};
use crate::interior::{Cut, Facet, Filled, Gap, Ground, Turning};
use crate::patch::PatchPoint;
use crate::surface::Relief;
use crate::{BaseSurface, Certificate, Directions, MeshSettings, MesherError, Side};

/// Patches that one task fills.
const PATCHES_PER_TASK: usize = 64;

/// Greatest difference of heights at a seam that counts as rounding, as a part of the tolerance.
const SEAMS: f64 = 1e-3;

/// Base of filled triangles.
#[derive(Debug)]
pub struct Adapted {
    base: Triangles,
    /// Points within patches, on the lattice of each, and their heights.
    inner: Vec<([u16; 2], f32)>,
    /// Triangles by the points of their patch: first the border's points, then its own.
    triangles: Vec<[u32; 3]>,
    /// Indices of each patch's first point and first triangle in these lists, and of the ends.
    first: Vec<[u32; 2]>,
    certificate: Certificate,
}

/// Fillings of several patches.
struct Fillings {
    inner: Vec<([u16; 2], f32)>,
    triangles: Vec<[u32; 3]>,
    counts: Vec<[u32; 2]>,
    error: Errors,
}

/// Errors of several patches.
#[derive(Clone, Copy)]
struct Errors {
    error_m: f64,
    uv: [f64; 2],
    sum_m: f64,
    count: u64,
    seams_m: f64,
}

impl Errors {
    const NONE: Self = Self { error_m: 0.0, uv: [0.0; 2], sum_m: 0.0, count: 0, seams_m: 0.0 };

    fn with(self, other: Self) -> Self {
        let worse = if other.error_m > self.error_m { other } else { self };
        Self {
            sum_m: self.sum_m + other.sum_m,
            count: self.count + other.count,
            seams_m: self.seams_m.max(other.seams_m),
            ..worse
        }
    }
}

impl Adapted {
    /// Fills the triangles of a mesh.
    pub fn new(
        mesh: &Mesh,
        relief: &Relief,
        settings: &MeshSettings,
        filling: Filling,
        watch: &Watch,
    ) -> Result<Self, MesherError> {
        let refused = [
            ("directions by their angles", settings.directions == Directions::Angle),
            (
                "one side over a cubic base or along directions of length 1",
                settings.side != Side::Both
                    && (settings.base == BaseSurface::Pn || settings.directions != Directions::Raw),
            ),
        ];
        if let Some((what, _)) = refused.into_iter().find(|(_, is_asked)| *is_asked) {
            return Err(MesherError::OnPlanesAlone { what });
        }
        let base = Triangles::new(mesh, relief, settings, filling.most, watch)?;
        let (budget, done) = (FillBudget::new(settings, filling.most, *watch), AtomicU64::new(0));
        let patches: Vec<u32> = (0..base.count()).collect();
        let fillings: Result<Vec<Fillings>, MesherError> = patches
            .par_chunks(PATCHES_PER_TASK)
            .map(|patches| {
                watch.check()?;
                let mut filling_of_task = Fillings {
                    inner: Vec::new(),
                    triangles: Vec::new(),
                    counts: Vec::with_capacity(patches.len()),
                    error: Errors::NONE,
                };
                for &patch in patches {
                    base.fill(relief, patch, settings, (&filling, &budget), &mut filling_of_task)?;
                }
                let count = patches.len() as u64;
                let before = done.fetch_add(count, Ordering::Relaxed);
                watch.at((before + count) as f32 / base.count() as f32)?;
                Ok(filling_of_task)
            })
            .collect();
        let mut adapted = Self {
            base,
            inner: Vec::new(),
            triangles: Vec::new(),
            first: Vec::with_capacity(patches.len() + 1),
            certificate: Certificate::exact(settings.judge),
        };
        let mut errors = Errors::NONE;
        for several in fillings? {
            let (mut inner, mut triangles) = (adapted.inner.len() as u64, adapted.triangles.len() as u64);
            for [points, own] in several.counts {
                adapted.first.push([counted(inner)?, counted(triangles)?]);
                (inner, triangles) = (inner + u64::from(points), triangles + u64::from(own));
            }
            adapted.inner.extend(several.inner);
            adapted.triangles.extend(several.triangles);
            errors = errors.with(several.error);
        }
        let (inner, triangles) = (adapted.inner.len() as u64, adapted.triangles.len() as u64);
        adapted.first.push([counted(inner)?, counted(triangles)?]);
        let vertices = adapted.vertices();
        if vertices > MOST {
            return Err(MesherError::TooLarge { vertices, triangles });
        }
        let Errors { error_m, uv, sum_m, count, seams_m } = errors;
        if adapted.base.one_side.is_some() && seams_m > SEAMS * settings.error_m {
            return Err(MesherError::SideOfSeams { seams_m });
        }
        let mean_m = sum_m / count.max(1) as f64;
        adapted.certificate = Certificate { error_m, uv, mean_m, seams_m, ..adapted.certificate };
        adapted.certificate.check(settings.error_m)?;
        Ok(adapted)
    }

    /// Returns the certificate.
    pub fn certificate(&self) -> &Certificate {
        &self.certificate
    }

    /// Returns the base.
    pub fn base(&self) -> &Triangles {
        &self.base
    }

    /// Returns the number of vertices of all patches.
    pub fn vertices(&self) -> u64 {
        self.base.border_count() + self.inner.len() as u64
    }

    /// Returns the numbers of vertices within a patch, and of its triangles.
    pub fn counts(&self, patch: u32) -> [u32; 2] {
        let [from, to] = [0, 1].map(|more| self.first[patch as usize + more]);
        [to[0] - from[0], to[1] - from[1]]
    }

    /// Returns the filling of a patch: the points of its border, then its own, and triangles
    /// between them.
    pub fn cut(&self, patch: u32) -> Cut {
        let [from, to] = [0, 1].map(|more| self.first[patch as usize + more]);
        let border = self.base.border_of(patch).map(|[side, at]| PatchPoint::Border { side, at });
        let inner = &self.inner[from[0] as usize..to[0] as usize];
        let inner = (0..).zip(inner).map(|(number, (lattice, _))| PatchPoint::Inner {
            number,
            weights: self.base.weights(patch, *lattice),
        });
        let triangles = self.triangles[from[1] as usize..to[1] as usize].to_vec();
        Cut { points: border.chain(inner).collect(), triangles }
    }

    /// Returns the number of the first vertex within a patch.
    pub fn first_of_patch(&self, patch: u32) -> u32 {
        // All vertices were counted.
        (self.base.border_count() + u64::from(self.first[patch as usize][0])) as u32
    }

    /// Returns the height of the map at a vertex within a patch.
    pub fn inner_height(&self, patch: u32, at: u32) -> f64 {
        let (_, height) = self.inner[(self.first[patch as usize][0] + at) as usize];
        f64::from(height)
    }

    /// Returns the number of bytes in use.
    pub fn bytes(&self) -> u64 {
        (size_of_val(&self.inner[..]) + size_of_val(&self.triangles[..]) + size_of_val(&self.first[..]))
            as u64
    }
}

impl Triangles {
    /// Returns the number of steps of a patch's lattice along a side, a multiple of the steps of
    /// all its sides.
    fn size(&self, patch: u32) -> u32 {
        self.edges.sides(patch).map(|edge| self.edges.size(edge)).into_iter().fold(1, u32::max)
    }

    /// Returns the barycentric weights of the second and the third corner at a point of a patch's
    /// lattice.
    fn weights(&self, patch: u32, lattice: [u16; 2]) -> [f64; 2] {
        let size = f64::from(self.size(patch));
        lattice.map(|steps| f64::from(steps) / size)
    }

    /// Returns the points of a patch's border by their sides: its corners, then the points along
    /// each side.
    fn border_of(&self, patch: u32) -> impl Iterator<Item = [u32; 2]> + use<'_> {
        let sides = self.edges.sides(patch);
        let along = move |side: u32| (1..self.edges.parts(sides[side as usize])).map(move |at| [side, at]);
        (0..3).map(|side| [side, 0]).chain((0..3).flat_map(along))
    }

    /// Returns a point of a patch's border on the patch's lattice.
    fn on_lattice(&self, patch: u32, [side, at]: [u32; 2]) -> [i32; 2] {
        let size = self.size(patch) as i32;
        let steps = match at {
            0 => 0,
            _ => {
                let (_, is_forth) = self.side(patch, side);
                let (edge, at) = self.on_side(patch, side, at);
                let [before, all] = self.edges.place(edge, at);
                let before = if is_forth { before } else { all - before };
                before as i32 * (size / all as i32)
            }
        };
        match side {
            0 => [steps, 0],
            1 => [size - steps, steps],
            _ => [0, size - steps],
        }
    }

    /// Returns a patch as ground for triangulation, and the length of its longest direction of
    /// displacement.
    fn facet(&self, relief: &Relief, patch: u32, error_m: f64) -> (Facet, f64) {
        let corners = self.triangles[patch as usize].map(|vertex| self.corners.base(vertex));
        let places = corners.map(|corner| relief.place(corner.uv));
        let map = relief.map();
        let normals = corners.map(|corner| corner.normal);
        let longest = match self.one_side {
            // On one side all patches have the same distance from the relief.
            Some(_) => self.corners.longest(),
            None => normals.iter().map(|normal| normal.length()).fold(0.0, f64::max),
        };
        let height_m = relief.height_m(error_m, longest);
        let (shape, part) = self.shape(patch);
        let factor = self.one_side.as_ref().map_or(1.0, |side| side.of_patch(patch));
        let turning = turning(relief, normals, (longest, height_m), shape);
        let turning = Turning { factor, part: part.unwrap_or(turning.part), ..turning };
        let facet = Facet::new(self.size(patch), places, turning, |[i, j]| map.texel(i, j));
        let facet = if relief.has_holes() { facet.with_holes(|[i, j]| map.is_hole(i, j)) } else { facet };
        (facet, longest)
    }

    /// Returns the difference in metres between a patch's own height at a point of its border and
    /// the height of the side of the seam that defines the point.
    fn apart_m(&self, relief: &Relief, patch: u32, [side, at]: [u32; 2], own: f64) -> f64 {
        if !self.is_welded {
            return 0.0;
        }
        let leader = match at {
            0 => self.at_corner(self.triangles[patch as usize][side as usize]),
            _ => {
                let (edge, at) = self.on_side(patch, side, at);
                self.on_edge(edge, at)
            }
        };
        let apart = relief.height_at_uv(leader.base.uv) - own;
        apart.abs() * relief.map().scale_m() * relief.reach(leader.base.normal.length())
    }

    /// Fills a patch.
    fn fill(
        &self,
        relief: &Relief,
        patch: u32,
        settings: &MeshSettings,
        (filling, budget): (&Filling, &FillBudget<'_>),
        into: &mut Fillings,
    ) -> Result<(), MesherError> {
        let error_m = settings.side.part() * settings.error_m;
        let (facet, longest) = self.facet(relief, patch, error_m);
        let mut seams_m = 0.0_f64;
        let border: Vec<([i32; 2], f32)> = self
            .border_of(patch)
            .map(|point| {
                let at = self.on_lattice(patch, point);
                let height = facet.height(at);
                seams_m = seams_m.max(self.apart_m(relief, patch, point, height));
                (at, height as f32)
            })
            .collect();
        let tolerance = relief.tolerance(error_m, longest);
        let filled = budget.admit((filling.fill.facet)(&facet, &border, budget.request(tolerance)))?;
        let Filled { points, heights, triangles, distances } = filled;
        let metres = relief.height_m(error_m, longest);
        let raise = self.raise_m() * longest / metres;
        let gap = [distances.above, distances.below].map(|gap| Gap { height: gap.height - raise, ..gap });
        let gap = if gap[0].height.abs() >= gap[1].height.abs() { gap[0] } else { gap[1] };
        // On one side all distances have the same sign.
        let sum = if raise == 0.0 {
            distances.sum
        } else {
            (raise * distances.count as f64 - distances.signed).abs()
        };
        let uv = {
            let corners = self.triangles[patch as usize].map(|vertex| self.corners.base(vertex).uv);
            let [a, b, c] = facet.weights(gap.place);
            (corners[0] * a + corners[1] * b + corners[2] * c).to_array()
        };
        into.error = into.error.with(Errors {
            error_m: gap.height.abs() * metres,
            uv,
            sum_m: sum * metres,
            count: distances.count,
            seams_m,
        });
        into.counts.push([(points.len() - border.len()) as u32, triangles.len() as u32]);
        into.inner.extend(points.into_iter().zip(heights).skip(border.len()));
        into.triangles.extend(triangles);
        Ok(())
    }
}
