//! Nodes that a plane above them proves to be no steeper than the best slope.

use pulp::Simd;

use super::super::apexes::RIM;
use super::super::lanes::{COLUMNS, LANE_BITS, LANES};
use super::{Bilinear, CAUTION, Group, Image, Node, Walk};

impl Walk<'_> {
    /// Returns the lanes, a bit each, for which a node may matter by the plane above it; all where
    /// there is none.
    ///
    /// Let the plane be `A ≥ 0` above an apex and have the slope `b`. Then a point below the plane
    /// and at least `d` away is at most as steep as `b + A / d`. Where `A` is negative, it is at
    /// most as steep as `b`. Over a piece of the rim on which the surface is linear, `A` is
    /// greatest at an end. From inside of the square it is greatest at the centre or on the rim.
    /// This bound takes the plane to be equally steep in all directions. Points aside of its
    /// inclination are skipped by [`Self::may_be_steeper`].
    #[inline(always)]
    pub(super) fn above_plane<S: Simd>(&self, simd: S, group: &Group, image: &Image, node: &Node) -> u64 {
        let Node { level, at, ref extent, lanes: among } = *node;
        let Some(plane) = self.planes.plane(level, at) else { return among };
        // In columns and rows from the group's first texel.
        let mut along = plane.along.map(f64::from);
        let mut above = plane.height;
        for axis in 0..2 {
            along[axis] = if image.is_mirrored[axis] { -along[axis] } else { along[axis] };
            above -= along[axis] * self.place(image, axis, at[axis] << level) as f64;
        }
        let height = above;
        let slopes = [along[0] / self.texel_m[0], along[1] / self.texel_m[1]];
        let slope = simd.splat_f64s((slopes[0] * slopes[0] + slopes[1] * slopes[1]).sqrt());
        let half = f64::from(self.half);
        let (zero, above, along_u) =
            (simd.splat_f64s(0.0), simd.splat_f64s(above), simd.splat_f64s(along[0]));
        let (from, to) = (f64::from(extent.columns[0]), f64::from(extent.columns[1]));
        let (from, to) = (simd.splat_f64s(from - half - 1.0), simd.splat_f64s(to + half + 1.0));
        let side = simd.splat_f64s(self.texel_m[0]);
        let rows2 = f64::from(extent.rows.near2[1]) * self.side_m * self.side_m * CAUTION;
        let rows2 = simd.splat_f64s(rows2);
        let mut lanes = [0u64; LANES];
        for (part, lanes) in S::as_mut_simd_u64s(&mut lanes).0.iter_mut().enumerate() {
            let by = S::as_simd_f64s(&COLUMNS).0[part];
            let mut most = simd.sub_f64s(zero, S::as_simd_f64s(&group.centres).0[part]);
            for (apex, heights) in group.apexes.iter().enumerate().take(self.apexes) {
                let [column, row] = RIM[apex];
                let place = half * (along[0] * f64::from(column) + along[1] * f64::from(row));
                let over = simd.sub_f64s(simd.splat_f64s(place), S::as_simd_f64s(heights).0[part]);
                most = simd.max_f64s(most, over);
            }
            let most = simd.add_f64s(simd.add_f64s(above, most), simd.mul_f64s(along_u, by));
            let gap = simd.max_f64s(simd.max_f64s(simd.sub_f64s(from, by), simd.sub_f64s(by, to)), zero);
            let gap = simd.mul_f64s(gap, side);
            let distance = simd.sqrt_f64s(simd.add_f64s(simd.mul_f64s(gap, gap), rows2));
            let best = S::as_simd_f64s(&group.slope).0[part];
            let is_above = simd.less_than_f64s(simd.mul_f64s(simd.sub_f64s(best, slope), distance), most);
            let is_steeper = simd.less_than_f64s(best, slope);
            let may = simd.or_m64s(is_above, is_steeper);
            *lanes = simd.select_u64s(may, S::as_simd_u64s(&LANE_BITS).0[part], simd.splat_u64s(0));
        }
        let may = lanes.into_iter().fold(0, |all, bit| all | bit) & among;
        if may == 0 {
            return 0;
        }
        let [left, right] = [extent.columns[0] - 1.0, extent.columns[1] + 1.0].map(f64::from);
        let [top, bottom] = self.span(image, 1, at[1], level).map(f64::from);
        let (top, bottom) = (top - 1.0, bottom + 1.0);
        let corner = |u: f64, v: f64| height + along[0] * u + along[1] * v;
        let bounds = Bilinear {
            from: [left, top],
            to: [right, bottom],
            heights: [corner(left, top), corner(right, top), corner(left, bottom), corner(right, bottom)],
        };
        may & self.may_be_steeper(simd, group, &bounds)
    }
}

#[cfg(test)]
mod tests {
    use pulp::{Scalar, Simd};
    use relief_core::{HeightMap, Wrap};

    use super::super::super::apexes::{Apexes, Region};
    use super::super::VertexVisitor;
    use super::*;

    /// Counts the visited vertices.
    struct Count(usize);

    impl VertexVisitor for Count {
        const HIGHEST_CORNERS: bool = false;

        fn may_matter(&self, _: u32, _: [u32; 2], _: [f32; 2], _: [f32; 2]) -> bool {
            true
        }

        fn visit<S: Simd>(&mut self, _: S, _: &mut Group, excess: &[f32; LANES], _: [i64; 2], _: f64) {
            self.0 += excess.iter().filter(|excess| **excess > 0.0).count();
        }
    }

    /// Slope found in a column, in heights a texel.
    type Slope = fn(i64) -> f64;

    /// Counts the vertices that texels inside of a map visit, when `slope` gives the slopes found
    /// in their columns, in heights a texel.
    fn looks(map: &HeightMap, slope: Slope) -> usize {
        let walk = Walk::new(map, [1.0; 2], Region::Centre);
        let mut group = Group::new();
        let first = [map.width() / 4, map.height() / 2].map(i64::from);
        group.begin(first);
        for lane in 0..LANES {
            let texel = [first[0] + lane as i64, first[1]];
            let height = f64::from(map.texel(texel[0], texel[1]));
            walk.lower(&mut group, lane, &Apexes::new(texel, [height; 8], height));
            walk.raise_bar(&mut group, lane, slope(texel[0]).powi(2));
        }
        let mut count = Count(0);
        walk.walk(Scalar::new(), &mut group, [0; 2], &mut count);
        count.0
    }

    #[test]
    fn only_near_vertices_of_inclined_ground_are_visited() {
        for side in [128u32, 512] {
            let ground = |height: &dyn Fn(f64, f64) -> f64| {
                let height = |i: u32, j: u32| height(f64::from(i), f64::from(j)) as f32;
                HeightMap::from_fn(side, side, Wrap::Clamp, height).expect("a valid map")
            };
            let last = f64::from(side - 1);
            let cases: [(HeightMap, Slope); 4] = [
                (ground(&|x, _| x / 1024.0), |_| 1.0 / 1024.0),
                // Heights are rounded, so vertices near by may be a little steeper.
                (ground(&|x, y| (0.6 * x + 0.8 * y) / 1024.0), |_| 1.0 / 1024.0),
                (ground(&|x, _| (x / 4.0).floor() / 256.0), |i| 1.0 / (256.0 * (4 - i % 4) as f64)),
                (ground(&|x, y| 1.0 - (x - last).abs().max((y - 0.5 * last).abs()) / 1024.0), |_| {
                    1.0 / 1024.0
                }),
            ];
            for (place, (map, slope)) in cases.into_iter().enumerate() {
                let looks = looks(&map, slope);
                // Without planes some hundreds at the smaller side, and thousands at the larger.
                assert!(looks < 40 * LANES, "case {place} at {side}: {looks}");
            }
        }
    }
}
