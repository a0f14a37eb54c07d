//! Slices at equal depths from a camera.
//!
//! Source: Kautz and Seidel 2001, section 3.3. The space over a triangle of the base is cut into
//! three tetrahedra. In each, heights and texture coordinates are linear. So the corners of a cut
//! by a plane define the whole cut. The diagonal of a side depends on the side's own ends, as in
//! the surface `tetrahedra`, so that neighbours agree.

use glam::DVec3;
use relief_core::SliceAxis;
use relief_core::camera::Camera;
use relief_core::mesh::Vertex;

use super::{SliceAnchor, SliceBlock, SliceError, SliceVertex, Slicer, between};

/// Corner of a tetrahedron: a point of the base with a height, its position, and its depth.
#[derive(Clone, Copy)]
struct Corner {
    base: Vertex,
    height: f64,
    position: DVec3,
    depth: f64,
}

impl Slicer<'_> {
    /// Returns the corners of the space over a triangle: on its floor, then above them.
    fn prism(&self, number: u32, camera: &Camera) -> [Corner; 6] {
        let mut corners = self.base.triangles()[number as usize];
        corners.sort_by_key(|corner| self.welded[*corner as usize]);
        std::array::from_fn(|place| {
            let base = self.base.vertices()[corners[place % 3] as usize];
            let height = (place / 3) as f64;
            let metres = self.bias_m + self.scale_m * height;
            let position = base.position.as_dvec3() + base.normal.as_dvec3() * metres;
            Corner { base, height, position, depth: camera.forward().dot(position - camera.eye()) }
        })
    }

    /// Returns the depth of plane 0.
    pub(super) fn first_depth(camera: &Camera, anchor: SliceAnchor) -> f64 {
        match anchor {
            SliceAnchor::Eye => 0.0,
            SliceAnchor::Object => camera.forward().dot(-camera.eye()),
        }
    }

    /// Returns the number before the first plane between some depths, and the number of planes
    /// there, all before the eye.
    pub(super) fn planes_between<const N: usize>(&self, depths: [f64; N], start: f64) -> (f64, u64) {
        let [low, high] = [f64::min, f64::max].map(|of| depths.into_iter().reduce(of).unwrap_or(0.0));
        let [before, last] =
            [low.max(0.0), high].map(|depth| (depth - start) / self.spacing_m).map(f64::floor);
        (before, (last - before).max(0.0) as u64)
    }

    /// Returns an upper bound on the number of planes over a triangle.
    pub(super) fn planes(&self, number: u32, camera: &Camera, anchor: SliceAnchor) -> u64 {
        let depths = self.prism(number, camera).map(|corner| corner.depth);
        self.planes_between(depths, Self::first_depth(camera, anchor)).1
    }

    /// Adds the slices over a triangle, at equal depths.
    pub(super) fn facing(
        &self,
        number: u32,
        camera: &Camera,
        anchor: SliceAnchor,
        block: &mut SliceBlock,
    ) -> Result<(), SliceError> {
        let start = Self::first_depth(camera, anchor);
        let prism = self.prism(number, camera);
        // Sides are cut from the lower end on the floor to the other end above it, in the order of
        // positions.
        for tetrahedron in [[0, 1, 2, 5], [0, 1, 4, 5], [0, 3, 4, 5]] {
            let corners = tetrahedron.map(|place: usize| prism[place]);
            let (before, count) = self.planes_between(corners.map(|corner| corner.depth), start);
            for plane in 1..=count {
                let depth = start + (before + plane as f64) * self.spacing_m;
                self.cut(&corners, depth, block)?;
            }
        }
        Ok(())
    }

    /// Adds the cut of a tetrahedron by a plane.
    fn cut(&self, corners: &[Corner; 4], depth: f64, block: &mut SliceBlock) -> Result<(), SliceError> {
        let is_behind = corners.map(|corner| corner.depth > depth);
        let (behind, before): (Vec<usize>, Vec<usize>) = (0..4).partition(|place| is_behind[*place]);
        let point = |a: usize, b: usize| self.at_depth(&corners[a], &corners[b], depth);
        match (&behind[..], &before[..]) {
            (&[one], &[a, b, c]) | (&[a, b, c], &[one]) => {
                block.push(&[point(one, a)?, point(one, b)?, point(one, c)?]);
            }
            (&[a, b], &[c, d]) => block.push(&[point(a, c)?, point(a, d)?, point(b, d)?, point(b, c)?]),
            _ => {}
        }
        Ok(())
    }

    /// Returns the point of an edge at a depth.
    fn at_depth(&self, a: &Corner, b: &Corner, depth: f64) -> Result<SliceVertex, SliceError> {
        let part = (depth - a.depth) / (b.depth - a.depth);
        let position = a.position.lerp(b.position, part).as_vec3();
        if !position.is_finite() {
            return Err(SliceError::NotFinite);
        }
        Ok(SliceVertex {
            vertex: Vertex { position, ..between(&a.base, &b.base, part) },
            height: (a.height + (b.height - a.height) * part) as f32,
            step: self.spacing_m as f32,
            axis: SliceAxis::Depth,
        })
    }
}
