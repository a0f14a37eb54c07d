//! Triangles that the displacement folded over.

use glam::{DVec3, Vec3};

/// What a rounded position may be off by, as a part of its largest coordinate, with room to spare.
const ROUNDING: f64 = 1.0 / (1 << 22) as f64;

/// What was folded over of a mesh.
///
/// A triangle is folded over where its normal, by its corners, points against the direction of displacement
/// there, which is the sum of those of its corners: it was turned round on the way, and shows its back.
/// Where rounded positions could do so, it does not count, and neither does a triangle without an area. What
/// moves along one direction, as a plane does, does not fold. How far a mesh can be displaced before it folds
/// anywhere is said by [`Mesh::fold_range`](relief_core::mesh::Mesh::fold_range).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Folds {
    /// Triangles that are folded over.
    pub triangles: u64,
    /// Triangles of the base that they are pieces of.
    pub base_triangles: u64,
    /// The first of these by their numbers, at most [`Folds::FIRST`].
    pub first: Vec<FoldedBase>,
    /// The last one that was counted.
    last: Option<u32>,
}

/// A triangle of the base, pieces of which are folded over.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoldedBase {
    /// Its number in the base, from 0.
    pub triangle: u32,
    /// Pieces that are folded over.
    pub pieces: u64,
    /// Its middle before it is displaced, in metres; that of its first patch where it is filled in several.
    pub middle_m: DVec3,
}

impl Folds {
    /// How many triangles of the base are named.
    pub const FIRST: usize = 8;

    /// Counts pieces of a triangle of the base. They come in the order of its triangles.
    pub(crate) fn add(&mut self, found: FoldedBase) {
        self.triangles += found.pieces;
        if self.last == Some(found.triangle) {
            if let Some(known) = self.first.last_mut().filter(|known| known.triangle == found.triangle) {
                known.pieces += found.pieces;
            }
            return;
        }
        self.last = Some(found.triangle);
        self.base_triangles += 1;
        if self.first.len() < Self::FIRST {
            self.first.push(found);
        }
    }
}

/// Whether a triangle may be folded over where directions are sums of these.
#[inline(always)]
pub fn may_be_folded([a, b, c]: [Vec3; 3], directions: &[DVec3; 3]) -> bool {
    let a = a.as_dvec3();
    let normal = (b.as_dvec3() - a).cross(c.as_dvec3() - a);
    let [along_a, along_b, along_c] = directions;
    // Without a branch between them.
    (normal.dot(*along_a) < 0.0) | (normal.dot(*along_b) < 0.0) | (normal.dot(*along_c) < 0.0)
}

/// Whether a triangle is folded over, by the directions in which its corners were displaced.
pub fn is_folded(corners: [Vec3; 3], directions: [DVec3; 3]) -> bool {
    let [a, b, c] = corners.map(|corner| corner.as_dvec3());
    let along = directions[0] + directions[1] + directions[2];
    let way = (b - a).cross(c - a).dot(along);
    if way >= 0.0 {
        return false;
    }
    let largest = [a, b, c].map(|at| at.abs().max_element()).into_iter().fold(0.0, f64::max);
    let longest = (b - a).length().max((c - a).length());
    -way > ROUNDING * largest * longest * along.length()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(triangle: u32, pieces: u64) -> FoldedBase {
        FoldedBase { triangle, pieces, middle_m: DVec3::ZERO }
    }

    #[test]
    fn a_triangle_in_several_parts_is_counted_once() {
        let mut folds = Folds::default();
        [found(3, 2), found(3, 5), found(4, 1)].into_iter().for_each(|part| folds.add(part));
        assert_eq!((folds.triangles, folds.base_triangles), (8, 2));
        assert_eq!(folds.first, [found(3, 7), found(4, 1)]);
        // Also when it is not named any more.
        (10..30).flat_map(|triangle| [found(triangle, 1); 2]).for_each(|part| folds.add(part));
        assert_eq!((folds.triangles, folds.base_triangles, folds.first.len()), (48, 22, Folds::FIRST));
        assert!(folds.first.iter().skip(2).all(|base| base.pieces == 2));
    }

    #[test]
    fn turned_triangles_fold_and_rounded_ones_do_not() {
        let corners = [Vec3::ZERO, Vec3::X, Vec3::Y];
        let turned = [corners[0], corners[2], corners[1]];
        assert!(!is_folded(corners, [DVec3::Z; 3]) && is_folded(turned, [DVec3::Z; 3]));
        assert!(is_folded(corners, [-DVec3::Z; 3]) && !is_folded(corners, [DVec3::X; 3]));
        // The next float, far from the origin: nothing but rounding.
        let far = 1000.0_f32;
        let sliver = [Vec3::new(far, 0.0, 0.0), Vec3::new(far, 1.0, 0.0), Vec3::new(far.next_up(), 0.5, 0.0)];
        assert!(!is_folded(sliver, [DVec3::Z; 3]) && !is_folded(sliver, [-DVec3::Z; 3]));
        assert!(!is_folded([corners[0]; 3], [DVec3::Z; 3]));
    }
}
