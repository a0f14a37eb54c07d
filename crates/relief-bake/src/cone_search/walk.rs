//! Walk down a maximum pyramid, shared by texels side by side, to the vertices that may matter to
//! them.

mod above_plane;
mod towards;

use pulp::Simd;
use relief_core::{HeightMap, Wrap};

use super::apexes::{APEXES, Apexes, Region};
use super::block::REACH;
use super::lanes::{COLUMNS_F32, LANE_BITS, LANES, Lanes};
use super::tie::raised;
use crate::texel_pyramid::TexelPyramid;
use crate::upper_planes::UpperPlanes;

/// Factor that lowers squared slopes. With some twelve roundings of 2⁻²⁴ in `f32`, no node that
/// matters is skipped.
const CAUTION: f64 = 1.0 - 1.0 / (1u64 << 19) as f64;

/// Nodes that a walk visits before it tests planes: natural ground mostly takes fewer.
const PATIENCE: u32 = 32;

/// Pyramid of a map, and the shape of its texels.
pub(crate) struct Walk<'a> {
    levels: TexelPyramid<'a>,
    planes: UpperPlanes,
    size: [i64; 2],
    wrap: Wrap,
    /// Sides of a texel over the longer one.
    sides: [f32; 2],
    /// Longer side in metres.
    side_m: f64,
    texel_m: [f64; 2],
    /// Half the side of the box of apexes, in texels.
    half: f32,
    /// Apexes of a texel.
    apexes: usize,
}

use self::towards::Profile;
pub(crate) use self::towards::{Bilinear, ProfileVertex};

/// Texels side by side, their steepest slopes so far, and the nodes yet to be visited.
pub(crate) struct Group {
    /// The first texel.
    texel: [i64; 2],
    /// Lowest apex of each, rounded down; infinite for lanes without a texel.
    low: [f32; LANES],
    /// Steepest squared slope so far, lowered, in heights per longer side.
    bar: [f32; LANES],
    /// Steepest slope so far, raised, in heights per metre.
    slope: Lanes,
    /// Heights of the apexes, and of the texels' centres.
    apexes: [Lanes; APEXES],
    centres: Lanes,
    pending: Vec<Node>,
}

impl Group {
    /// Creates a group without texels.
    pub fn new() -> Self {
        Self {
            texel: [0; 2],
            low: [f32::INFINITY; LANES],
            bar: [0.0; LANES],
            slope: [0.0; LANES],
            apexes: [[0.0; LANES]; APEXES],
            centres: [0.0; LANES],
            pending: Vec::with_capacity(64),
        }
    }

    /// Begins with the texels from `texel` on; none of them takes part yet.
    #[inline(always)]
    pub fn begin(&mut self, texel: [i64; 2]) {
        self.texel = texel;
        self.low = [f32::INFINITY; LANES];
    }
}

/// Visitor of the vertices that may matter. Its methods must be `inline(always)`, so that they are
/// compiled for the machine's vectors; a closure would not be.
pub(crate) trait VertexVisitor {
    /// Whether cells are tested from their highest corner alone. A vertex is then visited if its
    /// rise, over the distance of the cells around it, is above the bar. Otherwise it is visited if
    /// it, or a point of these cells, may be steeper.
    const HIGHEST_CORNERS: bool;

    /// Returns whether anything around the vertices of a node may matter. From the apexes of all
    /// lanes to these vertices and the cells around them it is at least `from` and at most `to`
    /// columns and rows of the map.
    fn may_matter(&self, level: u32, at: [u32; 2], from: [f32; 2], to: [f32; 2]) -> bool;

    /// Returns the upper hull of all that may matter in a node, along an axis; `None` where it is
    /// unknown.
    fn profile(&self, _level: u32, _at: [u32; 2], _axis: usize) -> Option<&[ProfileVertex]> {
        None
    }

    /// Returns the lanes, a bit each, to which a node may matter beyond its highest vertex.
    /// `_spans` are its first and last columns and rows, from the group's first texel.
    fn may_matter_to(&self, _level: u32, _at: [u32; 2], _spans: [[f32; 2]; 2], lanes: u64) -> u64 {
        lanes
    }

    /// Visits a vertex of that height for the lanes whose excess is positive.
    fn visit<S: Simd>(
        &mut self,
        simd: S,
        group: &mut Group,
        excess: &[f32; LANES],
        vertex: [i64; 2],
        height: f64,
    );
}

/// Node yet to be visited.
#[derive(Clone, Copy)]
struct Node {
    level: u32,
    at: [u32; 2],
    extent: NodeExtent,
    /// Lanes, a bit each, that may visit it.
    lanes: u64,
}

/// Columns and rows of a node relative to a group, and its highest vertex.
#[derive(Clone, Copy)]
struct NodeExtent {
    /// First and last column, from the group's first texel.
    columns: [f32; 2],
    rows: Rows,
    highest: f32,
}

/// Rows of vertices, at their distance from the texels of a group.
#[derive(Clone, Copy)]
struct Rows {
    /// Whether the last row is ahead of the group, not behind.
    is_ahead: bool,
    /// Squared distances along `v` from the apexes to the nearest row, and to the cells before it.
    /// The unit is a texel's longer side.
    near2: [f32; 2],
    /// Vertices of these rows fewer columns away from a texel have only cells of its block around
    /// them.
    block: f32,
}

/// Image of the map relative to a group.
#[derive(Clone, Copy)]
struct Image {
    /// First column and row.
    begin: [i64; 2],
    is_mirrored: [bool; 2],
}

impl<'a> Walk<'a> {
    /// Builds the pyramid of a map, for apexes in `region`.
    pub fn new(map: &'a HeightMap, texel_m: [f64; 2], region: Region) -> Self {
        let side_m = texel_m[0].max(texel_m[1]);
        Self {
            levels: TexelPyramid::new(map),
            planes: UpperPlanes::new(map),
            size: [i64::from(map.width()), i64::from(map.height())],
            wrap: map.wrap(),
            sides: texel_m.map(|side| (side / side_m) as f32),
            side_m,
            texel_m,
            half: region.half() as f32,
            apexes: region.count(),
        }
    }

    /// Returns the longer side of a texel in metres.
    pub fn side_m(&self) -> f64 {
        self.side_m
    }

    /// Lets a lane take part, with its apexes.
    #[inline(always)]
    pub fn lower(&self, group: &mut Group, lane: usize, apexes: &Apexes) {
        let near = apexes.low as f32;
        group.low[lane] = if f64::from(near) > apexes.low { near.next_down() } else { near };
        for (lanes, height) in group.apexes.iter_mut().zip(apexes.heights) {
            lanes[lane] = height;
        }
        group.centres[lane] = apexes.centre;
    }

    /// Sets the squared slope, in heights per metre, above which a lane still searches.
    #[inline(always)]
    pub fn raise_bar(&self, group: &mut Group, lane: usize, slope2: f64) {
        group.bar[lane] = (slope2 * self.side_m * self.side_m * CAUTION) as f32;
        group.slope[lane] = raised(slope2, self.texel_m);
    }

    /// Visits every vertex that may be steeper than a lane's bar, or may be a corner of a cell that
    /// holds a steeper point. Vertices with only cells of the lane's block around them are left
    /// out. Vertices belong to the map and to its images at most `tiles` tiles away. Images are
    /// visited outward, until their highest point is too far to matter to any lane.
    ///
    /// A cell is hardly steeper than its corners. A segment of length `a`, at least the distance
    /// `g` away, is seen under an angle of at most `a / g`. The slope falls with the cosine of the
    /// angle from where it is greatest. So one end has at least `cos(a / 2g)` of the greatest
    /// slope, and at least `1 - a²/4g²` of its square. Every point of a cell is on a line between
    /// two edges, so one corner has at least the square of that factor.
    ///
    /// On inclined ground this bound skips nothing uphill, where all is equally steep. So a node is
    /// also skipped where a plane above the cells around its vertices is not above the lane's cone:
    /// see [`Self::above_plane`]. The loss by a tie is at most the amount by which slopes are
    /// raised.
    #[inline(always)]
    pub fn walk<S: Simd>(
        &self,
        simd: S,
        group: &mut Group,
        tiles: [i64; 2],
        visitor: &mut impl VertexVisitor,
    ) {
        for y in 0..=tiles[1] {
            let mut is_row_open = false;
            for y in signs(y) {
                for x in 0..=tiles[0] {
                    let mut is_open = false;
                    for x in signs(x) {
                        is_open |= self.walk_tile(simd, group, [x, y], visitor);
                    }
                    if !is_open {
                        break;
                    }
                    is_row_open = true;
                }
            }
            if !is_row_open {
                break;
            }
        }
    }

    /// Walks one image of the map. Returns whether it is near enough to matter.
    #[inline(always)]
    fn walk_tile<S: Simd, L: VertexVisitor>(
        &self,
        simd: S,
        group: &mut Group,
        tile: [i64; 2],
        visitor: &mut L,
    ) -> bool {
        let image = Image {
            begin: [0, 1].map(|axis| tile[axis] * self.size[axis] - group.texel[axis]),
            is_mirrored: tile.map(|tile| self.wrap == Wrap::Mirror && tile & 1 != 0),
        };
        let level = self.levels.top();
        let extent = NodeExtent {
            columns: self.span(&image, 0, 0, level),
            rows: self.rows(self.span(&image, 1, 0, level)),
            highest: self.levels.level(level).highest([0, 0]),
        };
        if self.excess_of::<S, L>(simd, group, &extent).is_none() {
            return false;
        }
        let mut pending = std::mem::take(&mut group.pending);
        pending.clear();
        pending.push(Node { level, at: [0, 0], extent, lanes: ALL_LANES });
        let mut looked_into = 0;
        while let Some(node) = pending.pop() {
            let Node { level, at, extent, mut lanes } = node;
            let Some(mut excess) = self.excess_of::<S, L>(simd, group, &extent) else { continue };
            looked_into += 1;
            if looked_into > PATIENCE {
                lanes = self.above_plane(simd, group, &image, &node);
                for axis in 0..2 {
                    if lanes != 0
                        && let Some(hull) = visitor.profile(level, at, axis)
                    {
                        lanes &= self.above_profile(simd, group, &image, &node, (axis, hull));
                    }
                }
                for (excess, bit) in excess.iter().zip(LANE_BITS) {
                    lanes &= if *excess > 0.0 { !0 } else { !bit };
                }
                if lanes != 0 {
                    let spans = [extent.columns, self.span(&image, 1, at[1], level)];
                    lanes = visitor.may_matter_to(level, at, spans, lanes);
                }
                let mut any = false;
                for (excess, bit) in excess.iter_mut().zip(LANE_BITS) {
                    *excess = if lanes & bit == 0 { 0.0 } else { *excess };
                    any |= *excess > 0.0;
                }
                if !any {
                    continue;
                }
            }
            if level == 0 {
                let vertex = [0, 1].map(|axis| group.texel[axis] + self.place(&image, axis, at[axis]));
                visitor.visit(simd, group, &excess, vertex, f64::from(extent.highest));
                continue;
            }
            let level = level - 1;
            let nodes = self.levels.level(level);
            let size = nodes.size();
            // The last one pushed is visited first: it should be the nearest.
            let is_ahead = [extent.columns[0] + extent.columns[1] > 0.0, extent.rows.is_ahead];
            let first = [2 * at[0], 2 * at[1]];
            let flip = [0, 1].map(|axis| u32::from(is_ahead[axis] != image.is_mirrored[axis]));
            for row in [first[1] + flip[1], first[1] + 1 - flip[1]] {
                if row >= size[1] {
                    continue;
                }
                let span = self.span(&image, 1, row, level);
                let rows = self.rows(span);
                for column in [first[0] + flip[0], first[0] + 1 - flip[0]] {
                    if column >= size[0] {
                        continue;
                    }
                    let columns = self.span(&image, 0, column, level);
                    let extent = NodeExtent { columns, rows, highest: nodes.highest([column, row]) };
                    let [[left, right], [top, bottom]] = [
                        self.around(columns, LANES - 1, image.is_mirrored[0]),
                        self.around(span, 0, image.is_mirrored[1]),
                    ];
                    if visitor.may_matter(level, [column, row], [left, top], [right, bottom])
                        && self.excess_of::<S, L>(simd, group, &extent).is_some()
                    {
                        pending.push(Node { level, at: [column, row], extent, lanes });
                    }
                }
            }
        }
        group.pending = pending;
        true
    }

    /// Returns the lanes, a bit each, for which a node may matter by its profile.
    #[inline(always)]
    fn above_profile<S: Simd>(
        &self,
        simd: S,
        group: &Group,
        image: &Image,
        node: &Node,
        (axis, hull): (usize, &[ProfileVertex]),
    ) -> u64 {
        let sides = [0, 1].map(|axis| {
            let [from, to] = self.span(image, axis, node.at[axis], node.level).map(f64::from);
            [from - 1.0, to + 1.0]
        });
        let first = self.place(image, axis, node.at[axis] << node.level) as f64;
        let step = if image.is_mirrored[axis] { -1.0 } else { 1.0 };
        self.may_be_steeper(simd, group, &Profile { sides, axis, hull, first, step })
    }

    /// Returns a column or row of an image, from the group's first texel.
    #[inline(always)]
    fn place(&self, image: &Image, axis: usize, at: u32) -> i64 {
        let at = i64::from(at);
        image.begin[axis] + if image.is_mirrored[axis] { self.size[axis] - 1 - at } else { at }
    }

    /// Returns the first and last column or row of a node; rounded beyond what `f32` counts
    /// exactly.
    #[inline(always)]
    fn span(&self, image: &Image, axis: usize, at: u32, level: u32) -> [f32; 2] {
        let first = i64::from(at) << level;
        let last = (first + (1 << level)).min(self.size[axis]) - 1;
        let ends = if image.is_mirrored[axis] {
            [self.size[axis] - 1 - last, self.size[axis] - 1 - first]
        } else {
            [first, last]
        };
        [(image.begin[axis] + ends[0]) as f32, (image.begin[axis] + ends[1]) as f32]
    }

    /// Returns the least and the most columns or rows, along the map, from all apexes to the cells
    /// around `from..=to`. These are counted from the first texel; the last texel is `lanes` after
    /// it.
    #[inline(always)]
    fn around(&self, [from, to]: [f32; 2], lanes: usize, is_mirrored: bool) -> [f32; 2] {
        let around = [from - lanes as f32 - 1.0 - self.half, to + 1.0 + self.half];
        if is_mirrored { [-around[1], -around[0]] } else { around }
    }

    #[inline(always)]
    fn rows(&self, [from, to]: [f32; 2]) -> Rows {
        let away = at_least(at_least(from, -to), 0.0) - self.half;
        let (vertex, cell) = (at_least(away, 0.0) * self.sides[1], at_least(away - 1.0, 0.0) * self.sides[1]);
        let block = if at_least(to, -from) < REACH as f32 { REACH as f32 } else { 0.0 };
        Rows { is_ahead: from + to > 0.0, near2: [vertex * vertex, cell * cell], block }
    }

    /// Returns a positive number for each lane to which a vertex of the node may matter; `None`
    /// without such a lane.
    #[inline(always)]
    fn excess_of<S: Simd, L: VertexVisitor>(
        &self,
        simd: S,
        group: &Group,
        extent: &NodeExtent,
    ) -> Option<[f32; LANES]> {
        let (zero, quarter) = (simd.splat_f32s(0.0), simd.splat_f32s(0.25));
        let [square_s, square_g] = extent.rows.near2;
        let (square_s, square_g) = (simd.splat_f32s(square_s), simd.splat_f32s(square_g));
        let (from, to) = (simd.splat_f32s(extent.columns[0]), simd.splat_f32s(extent.columns[1]));
        let block = simd.splat_f32s(extent.rows.block);
        let (highest, ax) = (simd.splat_f32s(extent.highest), simd.splat_f32s(self.sides[0]));
        let (half, reach) = (simd.splat_f32s(self.half), simd.splat_f32s(self.half + 1.0));
        let mut excess = [0.0; LANES];
        let mut any = false;
        for (part, excess) in S::as_mut_simd_f32s(&mut excess).0.iter_mut().enumerate() {
            let by = S::as_simd_f32s(&COLUMNS_F32).0[part];
            let away = simd.max_f32s(simd.sub_f32s(from, by), simd.sub_f32s(by, to));
            let sx = simd.mul_f32s(simd.max_f32s(simd.sub_f32s(away, half), zero), ax);
            let gx = simd.mul_f32s(simd.max_f32s(simd.sub_f32s(away, reach), zero), ax);
            let s2 = simd.add_f32s(simd.mul_f32s(sx, sx), square_s);
            let g2 = simd.add_f32s(simd.mul_f32s(gx, gx), square_g);
            let open = simd.max_f32s(simd.sub_f32s(g2, quarter), zero);
            let rise = simd.max_f32s(simd.sub_f32s(highest, S::as_simd_f32s(&group.low).0[part]), zero);
            let bar = S::as_simd_f32s(&group.bar).0[part];
            let farthest = simd.max_f32s(simd.sub_f32s(by, from), simd.sub_f32s(to, by));
            let is_done = simd.less_than_f32s(farthest, block);
            let over = if L::HIGHEST_CORNERS {
                simd.sub_f32s(simd.mul_f32s(rise, rise), simd.mul_f32s(bar, g2))
            } else {
                let rise = simd.mul_f32s(rise, simd.max_f32s(g2, quarter));
                let bar = simd.mul_f32s(simd.mul_f32s(bar, s2), simd.mul_f32s(open, open));
                simd.sub_f32s(simd.mul_f32s(rise, rise), bar)
            };
            *excess = simd.select_f32s(is_done, zero, over);
            any |= simd.first_true_m32s(simd.less_than_f32s(zero, *excess)) < S::F32_LANES;
        }
        any.then_some(excess)
    }
}

/// All lanes, a bit each.
const ALL_LANES: u64 = (1 << LANES) - 1;

/// Returns the larger number, in the form that compiles to one instruction.
#[inline(always)]
fn at_least(x: f32, least: f32) -> f32 {
    if x > least { x } else { least }
}

/// Returns a number and its opposite, zero once.
fn signs(n: i64) -> impl Iterator<Item = i64> {
    std::iter::once(n).chain((n != 0).then_some(-n))
}
