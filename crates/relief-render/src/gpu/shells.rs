//! BVH of a surface's shells on the GPU.

use std::sync::Arc;

use obvhs::bvh2::Bvh2;
use relief_shaders::cpu::ShellNode;
use relief_shaders::surface::Proposal;
use relief_shaders::wgsl::{SHELL_BOTH_SIDES, SHELL_TRIANGLE};
use wgpu::{BindGroup, BindGroupLayout, Buffer, BufferUsages};

use super::layouts::group;
use super::{Gpu, GpuError};
use crate::job::{JobSurface, Triangles};
use crate::shellcast::{Bounds, hierarchy};

/// Greatest number of triangles. A node stores its parent in 28 bits, and there are twice as many
/// nodes as triangles.
pub const MOST_TRIANGLES: u64 = 1 << 27;

/// Value in place of the axis of a leaf.
const LEAF: u32 = 3;

/// BVH of a surface's shells.
#[derive(Debug)]
pub struct Shells {
    triangles: Arc<Triangles>,
    bounds: Bounds,
    /// Group 2 of the passes that trace shells.
    pub group: BindGroup,
    /// The nodes, for passes that bind more beside them.
    pub nodes: Buffer,
}

/// Builds and uploads the BVH of a surface's shells, unless it is cached. For surfaces without
/// shells, it drops a cached one.
pub fn update(
    held: &mut Option<Shells>,
    gpu: &Gpu,
    surface: &JobSurface,
    layout: &BindGroupLayout,
) -> Result<(), GpuError> {
    if surface.selection.paths().proposal != Proposal::Shells {
        *held = None;
        return Ok(());
    }
    let (triangles, bounds) = (&surface.triangles, Bounds::of(surface));
    let is_there = |held: &Shells| Arc::ptr_eq(&held.triangles, triangles) && held.bounds == bounds;
    if held.as_ref().is_some_and(is_there) {
        return Ok(());
    }
    // The old one is dropped first, so that both need not fit into memory.
    *held = None;
    let nodes = nodes(&hierarchy(&bounds.boxes(triangles)), bounds.both_sides);
    let nodes = gpu.filled("shell_nodes", &nodes, BufferUsages::STORAGE)?;
    let group = group(gpu.device(), "shells", layout, &[("shell_nodes", nodes.as_entire_binding())]);
    *held = Some(Shells { triangles: Arc::clone(triangles), bounds, group, nodes });
    Ok(())
}

/// Converts a BVH to nodes for the shaders. `both_sides` marks the triangles as two-sided.
fn nodes(bvh: &Bvh2, both_sides: bool) -> Vec<ShellNode> {
    let sides = if both_sides { SHELL_BOTH_SIDES } else { 0 };
    let mut nodes = Vec::with_capacity(bvh.nodes.len());
    let empty = ShellNode { low: [0.0; 3].into(), first: 0, high: [0.0; 3].into(), above: 0 };
    // Nodes of `bvh`, their indices in `nodes`, and their data about the parent.
    let mut waiting = Vec::new();
    if !bvh.nodes.is_empty() {
        nodes.push(empty);
        waiting.push((0, 0, 0));
    }
    while let Some((number, place, above)) = waiting.pop() {
        let node = &bvh.nodes[number as usize];
        let bounds = node.aabb();
        let (first, axis) = if node.is_leaf() {
            (SHELL_TRIANGLE * bvh.primitive_indices[node.first_index as usize] + sides, LEAF)
        } else {
            let mut children = [node.first_index, node.first_index + 1];
            let [one, other] = children.map(|child| bvh.nodes[child as usize].aabb().center());
            let (axis, apart) = [0, 1, 2]
                .map(|axis| (axis, other[axis] - one[axis]))
                .into_iter()
                .fold((0, 0.0f32), |most, new| if new.1.abs() > most.1.abs() { new } else { most });
            if apart < 0.0 {
                children.reverse();
            }
            let first = nodes.len();
            nodes.extend([empty; 2]);
            let parent = ((place as u32) << 4) | ((axis as u32) << 2);
            waiting.extend([1, 0].map(|which| (children[which], first + which, parent)));
            (first as u32, axis as u32)
        };
        let [low, high] = [bounds.min, bounds.max].map(|end| end.to_array().into());
        nodes[place] = ShellNode { low, first, high, above: above | axis };
    }
    nodes
}

#[cfg(test)]
mod tests {
    use obvhs::aabb::Aabb;

    use super::*;

    #[test]
    fn every_triangle_is_below_the_root_and_every_node_knows_its_own() {
        for count in [0u32, 1, 2, 3, 100] {
            let boxes = (0..count).map(|number| {
                let place = |step: f32| (number as f32 * step).sin() * 10.0;
                let low = glam::Vec3::new(place(1.0), place(2.0), place(3.0));
                Aabb::new(low.into(), (low + glam::Vec3::ONE).into())
            });
            let boxes: Vec<_> = boxes.collect();
            let nodes = nodes(&hierarchy(&boxes), true);
            assert_eq!(nodes.len() as u32, (2 * count).saturating_sub(1));
            let mut seen = vec![0; count as usize];
            for (place, node) in nodes.iter().enumerate() {
                if node.above & 3 == LEAF {
                    assert_eq!(node.first % SHELL_TRIANGLE, SHELL_BOTH_SIDES);
                    let triangle = (node.first / SHELL_TRIANGLE) as usize;
                    seen[triangle] += 1;
                    assert_eq!(<[f32; 3]>::from(node.low), boxes[triangle].min.to_array());
                    continue;
                }
                assert_eq!(node.first % 2, 1);
                let axis = (node.above & 3) as usize;
                let children = [0, 1].map(|which| &nodes[(node.first + which) as usize]);
                let centres = children.map(|child| {
                    assert_eq!(child.above >> 2, ((place as u32) << 2) | axis as u32);
                    <[f32; 3]>::from(child.low)[axis] + <[f32; 3]>::from(child.high)[axis]
                });
                assert!(centres[0] <= centres[1], "{centres:?}");
            }
            assert!(seen.iter().all(|times| *times == 1), "{seen:?}");
        }
    }
}
