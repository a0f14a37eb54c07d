//! Edge rule `pixels`: a point in every voxel of grid space.
//!
//! Source: Gumhold and Hüttner 1999, section 3.4, definition 1: an edge is divided along its *main
//! direction*, the axis along which its ends are most voxels apart.

use relief_core::registry::Publication;

use super::{Divides, EdgeRule, Spacing};

pub const RULE: EdgeRule = EdgeRule {
    name: "pixels",
    summary: "a point every P pixels of a view, also along the line of sight",
    publication: Publication {
        paper: "Gumhold and Hüttner 1999, Multiresolution Rendering With Displacement Mapping",
        section: "3.1",
    },
    spacing: Spacing::Voxels,
    divides: Divides::Voxels(parts),
};

fn parts([from, to]: [[i32; 3]; 2]) -> u64 {
    (0..3).map(|axis| u64::from(to[axis].abs_diff(from[axis]))).fold(1, u64::max)
}

#[cfg(test)]
mod tests {
    use super::parts;

    #[test]
    fn edges_have_a_part_for_every_voxel_along_their_main_direction() {
        assert_eq!(parts([[3, -4, 7], [3, -4, 7]]), 1);
        assert_eq!(parts([[3, -4, 7], [5, -9, 8]]), 5);
        assert_eq!(parts([[i32::MIN, 0, 0], [i32::MAX, 0, 1]]), u64::from(u32::MAX));
    }
}
