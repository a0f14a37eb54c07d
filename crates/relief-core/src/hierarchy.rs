//! Bounding volume hierarchies (BVHs), built by `obvhs`, in blocks if it would take too long.
//!
//! The builder joins pairs of neighbours in rounds. In some inputs the best neighbour always lies
//! to the same side: in even rows, in stacks of growing slices, and among boxes that coincide. Then
//! a round joins a single pair, and the time grows with the square of the number of boxes.
//!
//! Such boxes are sorted along a Morton curve and cut into blocks. Each block gets a hierarchy, and
//! another one is built above the blocks. The time then grows linearly. Other inputs get a single
//! hierarchy, in which rays visit about a tenth fewer boxes.

use glam::DVec3;
use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb;
use obvhs::bvh2::{Bvh2, leaf_collapser::collapse, reinsertion::ReinsertionOptimizer};
use obvhs::ploc::{PlocBuilder, morton::morton_encode_u64_unorm};

/// Number of boxes in a trial. Inputs up to this size are built without a trial.
const TRIAL: usize = 1024;

/// One in this number of possible trials is made before the boxes are accepted for rounds of pairs.
const TRIED: usize = 4;

/// Number of boxes in a block. The builder takes at most as many rounds for it.
const BLOCK: usize = 64;

/// A trial with more rounds joined about one pair per round. The builder takes 20 to 50 rounds for
/// usual boxes. Its `max_depth` is the number of rounds plus one, if they are more than 95.
const ROUNDS: usize = TRIAL / 8;

/// Builds a hierarchy with one box in each leaf, without any optimisation or collapsing. Without
/// boxes it is empty.
///
/// Equal boxes in equal order give equal hierarchies. `params` sets the builder's search distance
/// and sort precision. The later steps of `params` are left to the caller.
pub fn hierarchy(boxes: &[Aabb], params: &BvhBuildParams) -> Bvh2 {
    if boxes.is_empty() {
        return Bvh2::default();
    }
    let build = |boxes: &[Aabb]| {
        PlocBuilder::with_capacity(boxes.len()).build(
            params.ploc_search_distance,
            boxes,
            (0..boxes.len() as u32).collect(),
            params.sort_precision,
            params.search_depth_threshold,
        )
    };
    if boxes.len() <= TRIAL {
        return build(boxes);
    }
    let sorted = along_curve(boxes);
    let of_part = |part: &[u32]| part.iter().map(|&number| boxes[number as usize]).collect::<Vec<_>>();
    let around = |part: &[u32]| part.iter().map(|&number| boxes[number as usize]).reduce(|a, b| a.union(&b));
    let wide: Vec<Aabb> = sorted.chunks(TRIAL).filter_map(around).collect();
    let has_slow_rounds = |boxes: &[Aabb]| build(boxes).max_depth > ROUNDS;
    if !sorted.chunks(TRIAL).step_by(TRIED).any(|part| has_slow_rounds(&of_part(part)))
        && !wide.chunks(TRIAL).any(has_slow_rounds)
    {
        return build(boxes);
    }
    let blocks: Vec<Aabb> = sorted.chunks(BLOCK).filter_map(around).collect();
    let below: Vec<(&[u32], Bvh2)> =
        sorted.chunks(BLOCK).map(|block| (block, build(&of_part(block)))).collect();
    joined(hierarchy(&blocks, params), &below)
}

/// Builds a BVH with several boxes in a leaf where that is faster.
pub(crate) fn collapsed(boxes: &[Aabb], params: &BvhBuildParams) -> Bvh2 {
    let mut bvh = hierarchy(boxes, params);
    let mut optimizer = ReinsertionOptimizer::default();
    optimizer.run(&mut bvh, params.reinsertion_batch_ratio, None);
    collapse(&mut bvh, params.max_prims_per_leaf, params.collapse_traversal_cost);
    let again = params.reinsertion_batch_ratio * params.post_collapse_reinsertion_batch_ratio_multiplier;
    optimizer.run(&mut bvh, again, None);
    bvh
}

/// Numbers of the boxes, sorted by their middles along a Morton curve.
fn along_curve(boxes: &[Aabb]) -> Vec<u32> {
    let mut around = Aabb::empty();
    for of in boxes {
        around.extend(of.min);
        around.extend(of.max);
    }
    let scale = around.diagonal().as_dvec3().map(|side| if side > 0.0 { 1.0 / side } else { 0.0 });
    let code = |number: u32| {
        let of = &boxes[number as usize];
        let middle = (of.min.as_dvec3() + of.max.as_dvec3()) / 2.0 - around.min.as_dvec3();
        morton_encode_u64_unorm((middle * scale).clamp(DVec3::ZERO, DVec3::splat(LAST_STEP)))
    };
    let mut sorted: Vec<u32> = (0..boxes.len() as u32).collect();
    sorted.sort_by_cached_key(|&number| (code(number), number));
    sorted
}

/// End of a Morton curve's last step. A value of 1 would wrap to the curve's beginning.
const LAST_STEP: f64 = 1.0 - 1.0 / (1u64 << 22) as f64;

/// Joins a hierarchy of blocks with the hierarchies in the blocks: each replaces its block's leaf.
fn joined(mut all: Bvh2, below: &[(&[u32], Bvh2)]) -> Bvh2 {
    let mut leaf_of = vec![0; below.len()];
    for (index, node) in all.nodes.iter().enumerate().filter(|(_, node)| node.is_leaf()) {
        leaf_of[all.primitive_indices[node.first_index as usize] as usize] = index;
    }
    let mut numbers = Vec::with_capacity(below.iter().map(|(block, _)| block.len()).sum());
    for ((block, of_block), leaf) in below.iter().zip(leaf_of) {
        // A block's root replaces the leaf. The block's other nodes are appended, in pairs as
        // before.
        let (nodes, first_number) = (all.nodes.len() as u32 - 1, numbers.len() as u32);
        let mut moved = of_block.nodes.iter().map(|node| {
            let mut node = *node;
            node.first_index += if node.is_leaf() { first_number } else { nodes };
            node
        });
        if let Some(root) = moved.next() {
            all.nodes[leaf] = root;
        }
        all.nodes.extend(moved);
        numbers.extend(of_block.primitive_indices.iter().map(|&place| block[place as usize]));
    }
    all.primitive_indices = numbers;
    all.max_depth += below.iter().map(|(_, block)| block.max_depth).max().unwrap_or(0);
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3A;

    /// Boxes that are bad for rounds of pairs, and some that are not.
    fn kinds(count: usize) -> [(&'static str, Vec<Aabb>); 5] {
        let all = |of: &dyn Fn(f32) -> Aabb| (0..count).map(|number| of(number as f32)).collect::<Vec<_>>();
        let cube = |at: Vec3A, size: f32| Aabb::new(at, at + size);
        let scattered = |number: f32| {
            let at = [0.754_877_7, 0.569_840_3, 0.618_034].map(|step: f32| (number * step).fract());
            cube(Vec3A::from_array(at), 1e-3)
        };
        [
            ("row", all(&|number| cube(Vec3A::Z * number, 1.0))),
            ("growing", all(&|number| Aabb::new(Vec3A::new(-number, -number, number), Vec3A::splat(number)))),
            ("coinciding", all(&|_| cube(Vec3A::ZERO, 1.0))),
            ("flat", all(&|number| Aabb::new(Vec3A::X * number, Vec3A::X * number))),
            ("scattered", all(&scattered)),
        ]
    }

    #[test]
    fn hierarchies_hold_every_box_once_and_boxes_hold_what_is_below() {
        let params = BvhBuildParams::medium_build();
        for count in [1, 2, TRIAL, TRIAL + 1, 3 * TRIAL - 5] {
            for (name, boxes) in kinds(count) {
                let bvh = hierarchy(&boxes, &params);
                assert_eq!(bvh.nodes.len(), 2 * count - 1, "{name}");
                let mut seen = vec![0; count];
                for (index, node) in bvh.nodes.iter().enumerate() {
                    let holds = |inner: &Aabb| {
                        let outer = node.aabb();
                        outer.min.cmple(inner.min).all() && outer.max.cmpge(inner.max).all()
                    };
                    if node.is_leaf() {
                        let number = bvh.primitive_indices[node.first_index as usize] as usize;
                        seen[number] += 1;
                        assert!(
                            node.prim_count == 1 && holds(&boxes[number]),
                            "{name} {count}: leaf {index}"
                        );
                    } else {
                        let first = node.first_index as usize;
                        assert!(first > index && first % 2 == 1, "{name} {count}: node {index}");
                        assert!([first, first + 1].iter().all(|&child| holds(bvh.nodes[child].aabb())));
                    }
                }
                assert!(seen.iter().all(|&times| times == 1), "{name} {count}");
                assert!(bvh.max_depth >= bvh.depth(0), "{name} {count}");
            }
        }
    }

    #[test]
    fn rows_take_no_more_rounds_than_their_blocks() {
        // Without blocks there would be 8 times as many rounds.
        for (name, boxes) in kinds(8 * TRIAL) {
            let bvh = hierarchy(&boxes, &BvhBuildParams::medium_build());
            assert!(bvh.max_depth <= TRIAL, "{name}: {} rounds", bvh.max_depth);
        }
    }

    #[test]
    fn what_is_good_for_rounds_of_pairs_gets_one_hierarchy() {
        let (params, [.., (_, boxes)]) = (BvhBuildParams::medium_build(), kinds(8 * TRIAL));
        let all = (0..boxes.len() as u32).collect();
        let one = PlocBuilder::new().build(
            params.ploc_search_distance,
            &boxes,
            all,
            params.sort_precision,
            params.search_depth_threshold,
        );
        assert!(one.nodes.iter().zip(&hierarchy(&boxes, &params).nodes).all(|(a, b)| a.aabb() == b.aabb()));
    }
}
