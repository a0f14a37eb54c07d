//! Motifs as trees of boxes: triangles that repeat with the tiles, in the texture that shaders walk through.

use std::collections::HashSet;
use std::fmt;
use std::sync::Arc;

use glam::{DVec2, DVec3, Vec3};
use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;

use crate::encoding::code::Codes;
use crate::hierarchy::collapsed;
use crate::{BakedMap, MapFormat, MapIdentity, MapLayout, MapTexels};

/// Triangle of a motif: places `(u, v, height)`, tiles and heights from 0 to 1, and normals along the same
/// axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TileTriangle {
    /// The corners.
    pub corners: [DVec3; 3],
    /// Normals at the corners, of any length above 0. They turn as gradients do.
    pub normals: [Vec3; 3],
}

/// Reason why triangles make no tree.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MotifTreeError {
    /// No triangle lies between the heights 0 and 1.
    #[error("nothing of the motif lies between the heights 0 and 1 of its tile")]
    Nothing,
    /// A corner is not finite, or too far away.
    #[error("triangle {0} of the motif lies more than {FARTHEST_TILE} tiles away from its tile")]
    Far(usize),
    /// There are too many triangles in a tile.
    #[error(
        "the motif has more than {MOST_IN_A_TILE} triangles in a tile, with those that reach in from tiles \
            beside it: give a simpler one"
    )]
    TooMany,
}

/// Most triangles in a tile, with those that reach in from other tiles: `f32` counts all their texels.
pub const MOST_IN_A_TILE: u64 = 1 << 21;

/// Most memory for a triangle of a tile while a tree is made, in bytes.
pub const BYTES_PER_TILE_TRIANGLE: u64 = 700;

/// Number of triangles up to which a better tree is built.
const SMALL: usize = 1 << 17;

/// Farthest tile in which a corner may lie.
const FARTHEST_TILE: f64 = 16.0;

/// Columns of the texture, as a power of two.
pub const TREE_SHIFT: u32 = 10;

/// Steps of places in a tile: in `f32` they stay exact when they are moved by whole tiles.
const STEPS: f64 = (1u64 << 19) as f64;

/// Tiles by which boxes are larger than what is in them, and by which triangles beside a tile still count as
/// in it. Less, and rounding of places far from the first tile loses triangles; more, and rays visit more
/// boxes.
const BESIDE: f64 = 1e-4;

/// Texels of a node, of the corners of a triangle, and of its normals.
const NODE_TEXELS: u32 = 2;
const TRIANGLE_TEXELS: u32 = 3;

/// Motif that repeats with the tiles of a surface, as a tree of boxes for rays in `(u, v, height)`.
///
/// The tree holds one tile. Triangles that reach into other tiles are in it once for each, moved back, so
/// that a ray that walks from tile to tile meets all of them. Places are rounded to 2⁻¹⁹ of a tile. Clones
/// share it.
///
/// Porumbescu, Budge, Feng and Joy 2005, "Shell maps"; Szirmay-Kalos and Umenhoffer 2008, section 5.2.
#[derive(Clone, PartialEq)]
pub struct MotifTree {
    map: Arc<BakedMap>,
    triangles: u32,
    is_closed: bool,
}

impl fmt::Debug for MotifTree {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "MotifTree({} triangles)", self.triangles)
    }
}

impl MotifTree {
    /// Makes the tree of triangles in the space of a tile. Those outside of the heights 0 to 1, and those
    /// without area, are left out.
    ///
    /// ```
    /// use glam::{DVec3, Vec3};
    /// use relief_core::{MotifTree, TileTriangle};
    ///
    /// // A triangle at half the height that reaches into the next tile.
    /// let corners = [[0.5, 0.2, 0.5], [1.5, 0.2, 0.5], [0.5, 0.8, 0.5]].map(DVec3::from);
    /// let tree = MotifTree::new(&[TileTriangle { corners, normals: [Vec3::Z; 3] }])?;
    /// assert_eq!(tree.triangles(), 2);
    /// # Ok::<(), relief_core::MotifTreeError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// When nothing remains, a corner is far away, or there are too many triangles.
    pub fn new(triangles: &[TileTriangle]) -> Result<Self, MotifTreeError> {
        let all = in_the_tile(triangles)?;
        if all.is_empty() {
            return Err(MotifTreeError::Nothing);
        }
        let boxes: Vec<Aabb> = all.iter().map(InTile::bounds).collect();
        // Each ray walks through all of it, so it may take longer to make while it is small.
        let is_small = boxes.len() <= SMALL;
        let params = if is_small { BvhBuildParams::slow_build() } else { BvhBuildParams::medium_build() };
        let is_closed = is_closed(triangles);
        let map = texture(&all, &collapsed(&boxes, &params), is_closed).ok_or(MotifTreeError::TooMany)?;
        Ok(Self { map: Arc::new(map), triangles: all.len() as u32, is_closed })
    }

    /// Returns the texture, four numbers a texel, in rows of 2¹⁰.
    ///
    /// * Texel 0: the texels from a triangle's corners to its normals, the number of nodes, and 1 for a
    ///   closed motif, whose triangles are seen from the outside alone.
    /// * From texel 1 on the nodes, each before its children: a box's least corner and the first texel of the
    ///   node behind all of its children, 0 for none; the greatest corner, and the first texel of a leaf's
    ///   triangles, 0 for other nodes.
    /// * Then the triangles: three corners; behind the first the number of triangles that follow in the leaf.
    /// * Then the normals of the triangles' corners, in the same order.
    pub fn map(&self) -> &Arc<BakedMap> {
        &self.map
    }

    /// Returns the number of triangles in a tile; one that reaches into several tiles counts in each.
    pub fn triangles(&self) -> u32 {
        self.triangles
    }

    /// Whether every edge has an even number of triangles, also across the edges of tiles.
    pub fn is_closed(&self) -> bool {
        self.is_closed
    }
}

/// A triangle with a part in the first tile.
struct InTile {
    corners: [Vec3; 3],
    normals: [Vec3; 3],
}

impl InTile {
    /// The box around the part in the tile, made larger.
    fn bounds(&self) -> Aabb {
        let [a, b, c] = self.corners;
        let beside = Vec3::splat(BESIDE as f32);
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        let (low, high) = (low.clamp(Vec3::ZERO, Vec3::ONE), high.clamp(Vec3::ZERO, Vec3::ONE));
        Aabb::new((low - beside).into(), (high + beside).into())
    }
}

/// The triangles that are in the first tile, moved there from all tiles.
fn in_the_tile(triangles: &[TileTriangle]) -> Result<Vec<InTile>, MotifTreeError> {
    let mut all = Vec::new();
    for (number, triangle) in triangles.iter().enumerate() {
        let is_near = |at: &DVec3| at.is_finite() && at.abs().max_element() <= FARTHEST_TILE;
        if !triangle.corners.iter().all(is_near) {
            return Err(MotifTreeError::Far(number));
        }
        let corners = triangle.corners.map(|at| (at * STEPS).round() / STEPS);
        let [a, b, c] = corners;
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        let has_area = (b - a).cross(c - a) != DVec3::ZERO;
        if !has_area || high.z < 0.0 || low.z > 1.0 {
            continue;
        }
        let tiles = |axis: usize| (low[axis] - BESIDE).floor() as i32..=(high[axis] + BESIDE).floor() as i32;
        for j in tiles(1) {
            for i in tiles(0) {
                let tile = DVec3::new(f64::from(i), f64::from(j), 0.0);
                let moved = corners.map(|at| at - tile);
                if !touches_tile(moved.map(DVec3::truncate)) {
                    continue;
                }
                if all.len() as u64 == MOST_IN_A_TILE {
                    return Err(MotifTreeError::TooMany);
                }
                all.push(InTile { corners: moved.map(|at| at.as_vec3()), normals: triangle.normals });
            }
        }
    }
    Ok(all)
}

/// Whether every edge has an even number of triangles, also across the edges of tiles.
fn is_closed(triangles: &[TileTriangle]) -> bool {
    let place = |at: DVec3| (at * STEPS).round().to_array().map(|step| step as i64);
    let from_tile_of = |first: [i64; 3], second: [i64; 3]| {
        let tile = [0, 1].map(|axis| first[axis].div_euclid(STEPS as i64) * STEPS as i64);
        [first, second].map(|[u, v, height]| [u - tile[0], v - tile[1], height])
    };
    let mut odd: HashSet<[[i64; 3]; 2]> = HashSet::new();
    for TileTriangle { corners, .. } in triangles {
        let places = corners.map(place);
        for (from, to) in [(0, 1), (1, 2), (2, 0)].map(|(from, to)| (places[from], places[to])) {
            let edge = from_tile_of(from, to).min(from_tile_of(to, from));
            if !odd.remove(&edge) {
                odd.insert(edge);
            }
        }
    }
    odd.is_empty()
}

/// Whether a triangle, seen from above, touches the first tile: no line along a side of either parts them.
fn touches_tile(corners: [DVec2; 3]) -> bool {
    let half = 0.5 + BESIDE;
    let from_middle = corners.map(|at| at - 0.5);
    let [a, b, c] = from_middle;
    let across = |along: DVec2| DVec2::new(-along.y, along.x);
    let axes = [DVec2::X, DVec2::Y, across(b - a), across(c - b), across(a - c)];
    axes.iter().all(|axis| {
        let places = from_middle.map(|at| at.dot(*axis));
        let reach = half * (axis.x.abs() + axis.y.abs());
        let [low, high] = [places.map(|place| place <= reach), places.map(|place| place >= -reach)];
        low.contains(&true) && high.contains(&true)
    })
}

/// The texture of a tree; `None` if it is too large for one.
fn texture(all: &[InTile], tree: &Bvh2, is_closed: bool) -> Option<BakedMap> {
    let (order, ends) = in_order(tree);
    let texel_of = |place: usize| if place < order.len() { 1 + NODE_TEXELS * place as u32 } else { 0 };
    let first_triangle = 1 + NODE_TEXELS * order.len() as u32;
    let to_normals = TRIANGLE_TEXELS * all.len() as u32;
    let mut texels = vec![[to_normals as f32, order.len() as f32, f32::from(u8::from(is_closed)), 0.0]];
    let mut listed: Vec<(u32, u32)> = Vec::with_capacity(all.len());
    for (node, end) in order.iter().zip(ends) {
        let node = tree.nodes.get(*node as usize)?;
        let (low, high) = (Vec3::from(node.aabb.min), Vec3::from(node.aabb.max));
        let mut first = 0;
        if node.is_leaf() {
            first = first_triangle + TRIANGLE_TEXELS * listed.len() as u32;
            for at in 0..node.prim_count {
                let number = *tree.primitive_indices.get((node.first_index + at) as usize)?;
                listed.push((number, node.prim_count - 1 - at));
            }
        }
        texels.push(low.extend(texel_of(end) as f32).to_array());
        texels.push(high.extend(first as f32).to_array());
    }
    for (number, left) in &listed {
        let [a, b, c] = all.get(*number as usize)?.corners;
        texels.extend([a.extend(*left as f32), b.extend(0.0), c.extend(0.0)].map(|at| at.to_array()));
    }
    for (number, _) in &listed {
        let normals = all.get(*number as usize)?.normals;
        texels.extend(normals.map(|normal| normal.normalize_or_zero().extend(0.0).to_array()));
    }
    let columns = 1 << TREE_SHIFT;
    let rows = (texels.len() as u32).div_ceil(columns);
    texels.resize((columns * rows) as usize, [0.0; 4]);
    let layout =
        MapLayout { size: [columns, rows], levels: 1, layers: 1, channels: 4, format: MapFormat::F32 };
    let codes = [Codes { low: 0.0, step: 0.0 }; 4];
    let values = MapTexels::F32(texels.into_flattened());
    BakedMap::new(MapIdentity::without_heights("motif"), layout, codes, values).ok()
}

/// The nodes of a tree, each before its children, and for each the place behind all of its children.
///
/// Of two children the higher one comes first: rays come from above.
fn in_order(tree: &Bvh2) -> (Vec<u32>, Vec<usize>) {
    let (mut order, mut ends) = (Vec::new(), Vec::new());
    // A node, or the end of one that is listed.
    let mut waiting = vec![(0u32, None)];
    while let Some((number, listed)) = waiting.pop() {
        if let Some(place) = listed {
            ends[place] = order.len();
            continue;
        }
        let Some(node) = tree.nodes.get(number as usize) else { continue };
        waiting.push((number, Some(order.len())));
        order.push(number);
        ends.push(0);
        if !node.is_leaf() {
            let middle = |child: u32| {
                tree.nodes.get(child as usize).map_or(0.0, |node| node.aabb.min.z + node.aabb.max.z)
            };
            let [first, second] = [node.first_index, node.first_index + 1];
            let [lower, higher] =
                if middle(first) < middle(second) { [first, second] } else { [second, first] };
            waiting.extend([(lower, None), (higher, None)]);
        }
    }
    (order, ends)
}
