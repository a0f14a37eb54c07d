//! Culling of patches outside of a view.

use std::ops::Range;

use glam::{DVec2, DVec3};
use rayon::prelude::*;
use relief_core::{HeightBounds, Watch};

use super::Triangles;
use crate::cull::{FullBounds, Hull, ViewVolume};
use crate::surface::Relief;
use crate::view::log2;
use crate::{BaseSurface, MeshSettings, MesherError, cubic};

/// Rounding in texels of the place from which a point has its height.
const BESIDE_TEXELS: f64 = 1e-3;

/// Rounding of the level from which a point has its height.
const BESIDE_LEVELS: f64 = 1e-6;

/// Bounds on the heights of a relief, for each level that may be used.
pub struct Bounds<'a> {
    pub relief: &'a Relief,
    pub levels: Vec<HeightBounds>,
}

impl Triangles {
    /// Leaves out the patches outside of the view, and the points that belong to these alone.
    /// Nothing else changes: directions, levels, and the leaders of seams.
    pub fn culled(
        mut self,
        relief: &Relief,
        settings: &MeshSettings,
        watch: &Watch,
    ) -> Result<Self, MesherError> {
        let Some((cull, view)) = settings.cull.zip(settings.view) else { return Ok(self) };
        let volume = ViewVolume::new(&view);
        let bounds = Bounds { relief, levels: relief.levels().map(HeightBounds::new).collect() };
        let hull_of = |patch: u32| {
            watch.check()?;
            let hull = self.hull(&bounds, patch);
            Ok((volume.misses(&hull, &cull.outside), hull))
        };
        let hulls: Result<Vec<(bool, Hull)>, MesherError> =
            (0..self.count()).into_par_iter().map(hull_of).collect();
        let hulls = hulls?;
        let nothing = [f64::INFINITY, f64::NEG_INFINITY];
        let depths_m = hulls.iter().fold(nothing, |[near, far], (_, hull)| {
            let [from, to] = volume.depths_m(hull);
            [near.min(from), far.max(to)]
        });
        let around = hulls.iter().flat_map(|(_, hull)| hull.around()).collect();
        self.full_bounds = Some(FullBounds { depths_m, around });
        let kept: Vec<u32> = (0..self.count()).filter(|&patch| !hulls[patch as usize].0).collect();
        self.whole = kept.iter().map(|&patch| self.whole(patch)).collect();
        self.triangles = kept.iter().map(|&patch| self.triangles[patch as usize]).collect();
        self.corners.keep(&self.triangles);
        self.edges.keep(&kept, &self.corners)?;
        Ok(self)
    }

    /// Returns the bounds of all patches, including the ones left out. Returns `None` without
    /// culling.
    pub fn full_bounds(&self) -> Option<&FullBounds> {
        self.full_bounds.as_ref()
    }

    /// Returns the bound of a displaced patch.
    ///
    /// A point of a flat base that is displaced along interpolated directions, by a height between
    /// two others, lies in the hull of the corners at these two heights. Smooth bases and other
    /// directions make it wider.
    fn hull(&self, bounds: &Bounds, patch: u32) -> Hull {
        let corners = self.triangles[patch as usize];
        let sides = self.edges.sides(patch);
        let base = corners.map(|vertex| self.corners.base(vertex));
        let [mut low_m, mut high_m] = self.metres(bounds, patch);
        if self.base == BaseSurface::Lift {
            // The products of weights, two by two, sum to at most a third.
            let lifts = sides.map(|side| self.lift(self.leader(side)) / 3.0);
            low_m += lifts.into_iter().fold(0.0, f64::min);
            high_m += lifts.into_iter().fold(0.0, f64::max);
        }
        let farthest_m = low_m.abs().max(high_m.abs());
        let mut radius_m = 0.0;
        if self.base == BaseSurface::Pn {
            // A cubic triangle is no farther from the flat one than their control points are from
            // each other.
            let flat = (base[0].position + base[1].position + base[2].position) / 3.0;
            let mut sum = DVec3::ZERO;
            for side in sides {
                let [a, b] = self.edges.ends(self.leader(side)).map(|end| self.corners.base(end).position);
                let bent = self.bent(side);
                for (bent, flat) in bent.into_iter().zip([(a * 2.0 + b) / 3.0, (a + b * 2.0) / 3.0]) {
                    radius_m = bent.distance(flat).max(radius_m);
                    sum += bent;
                }
            }
            radius_m = cubic::middle(flat, sum).distance(flat).max(radius_m);
        }
        let mut points = [DVec3::ZERO; 6];
        let directions = bounds.relief.interpolated(base.map(|corner| corner.normal));
        if directions.is_none() {
            radius_m += farthest_m;
        }
        for (k, corner) in base.iter().enumerate() {
            let direction = directions.map_or(DVec3::ZERO, |directions| directions[k]);
            points[2 * k] = corner.position + direction * low_m;
            points[2 * k + 1] = corner.position + direction * high_m;
        }
        Hull { points, radius_m }
    }

    /// Returns the least and the greatest displacement of a patch in the levels that it uses, in
    /// metres.
    fn metres(&self, bounds: &Bounds, patch: u32) -> [f64; 2] {
        let corners = self.triangles[patch as usize];
        let ends = self.edges.sides(patch).map(|side| self.edges.ends(self.leader(side)));
        let leaders = corners.map(|vertex| self.corners.leader(vertex));
        let levels =
            self.levels(corners.iter().chain(&leaders).chain(ends.as_flattened()), bounds.levels.len());
        self.metres_of(bounds, patch, levels)
    }

    /// Returns the least and the greatest displacement of a patch in some levels, in metres. They
    /// bound the heights under the patch and, at seams with another leader, the heights under the
    /// leader.
    pub fn metres_of(&self, bounds: &Bounds, patch: u32, levels: Range<usize>) -> [f64; 2] {
        let corners = self.triangles[patch as usize];
        let ends = self.edges.sides(patch).map(|side| self.edges.ends(self.leader(side)));
        let leaders = corners.map(|vertex| self.corners.leader(vertex));
        let uv = |vertex: u32| self.corners.base(vertex).uv;
        let mut heights = [f32::INFINITY, f32::NEG_INFINITY];
        let mut add = |places: &[DVec2]| {
            let [least, greatest] = places
                .iter()
                .fold([DVec2::INFINITY, DVec2::NEG_INFINITY], |[a, b], at| [a.min(*at), b.max(*at)]);
            for level in &bounds.levels[levels.clone()] {
                let [low, high] = level.between(least, greatest, DVec2::splat(BESIDE_TEXELS));
                heights = [heights[0].min(low), heights[1].max(high)];
            }
        };
        add(&corners.map(uv));
        for leader in leaders.into_iter().filter(|leader| !corners.contains(leader)) {
            add(&[uv(leader)]);
        }
        for ends in ends.into_iter().filter(|ends| !ends.iter().all(|end| corners.contains(end))) {
            add(&ends.map(uv));
        }
        let [a, b] = heights.map(|height| bounds.relief.metres(height.into()));
        [a.min(b), a.max(b)]
    }

    /// Returns the levels that are used between some vertices, out of `count` levels.
    fn levels<'a>(&self, vertices: impl Iterator<Item = &'a u32>, count: usize) -> Range<usize> {
        if self.footprints.is_empty() {
            return 0..1;
        }
        // Texels and depth are weighted means of the vertices' values. Their product gives the
        // level.
        let nothing = [f64::INFINITY, f64::NEG_INFINITY];
        let (mut texels, mut depths) = (nothing, nothing);
        let add = |[least, greatest]: &mut [f64; 2], of: f64| {
            (*least, *greatest) = (least.min(of), greatest.max(of));
        };
        for &vertex in vertices {
            add(&mut texels, self.footprints[vertex as usize]);
            add(&mut depths, 1.0 / self.share(vertex));
        }
        let last = (count - 1) as f64;
        let level = |texels: f64, depth: f64| log2((texels * depth).max(1.0));
        let first = (level(texels[0], depths[0]) - BESIDE_LEVELS).floor().clamp(0.0, last);
        let end = (level(texels[1], depths[1]) + BESIDE_LEVELS).ceil().clamp(0.0, last);
        first as usize..end as usize + 1
    }
}

#[cfg(test)]
mod tests;
