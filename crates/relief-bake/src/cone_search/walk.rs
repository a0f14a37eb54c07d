//! A walk down a maximum pyramid, shared by texels side by side, to the vertices that may matter to them.

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

/// Lowers squared slopes, so that in `f32`, with some twelve roundings of 2⁻²⁴, no node that matters is
/// passed over.
const CAUTION: f64 = 1.0 - 1.0 / (1u64 << 19) as f64;

/// Nodes that a walk looks into before it asks for planes: natural ground mostly takes fewer.
const PATIENCE: u32 = 32;

/// The map's pyramid and the shape of its texels.
pub(crate) struct Walk<'a> {
    levels: TexelPyramid<'a>,
    planes: UpperPlanes,
    size: [i64; 2],
    wrap: Wrap,
    /// Sides of a texel over the longer one.
    sides: [f32; 2],
    /// The longer side in metres.
    side_m: f64,
    texel_m: [f64; 2],
    /// Half the side of the box of apexes, in texels.
    half: f32,
    /// How many apexes a texel has.
    apexes: usize,
}

use self::towards::Profile;
pub(crate) use self::towards::{Bilinear, ProfileVertex};

/// Texels side by side, what they have found so far, and the nodes that are still to be looked into.
pub(crate) struct Group {
    /// The first texel.
    texel: [i64; 2],
    /// The lowest apex of each, rounded down; infinite for lanes without a texel.
    low: [f32; LANES],
    /// The steepest squared slope so far, lowered, in heights per longer side.
    bar: [f32; LANES],
    /// The steepest slope so far, raised, in heights per metre.
    slope: Lanes,
    /// The heights of the apexes, and of the texels' centres.
    apexes: [Lanes; APEXES],
    centres: Lanes,
    pending: Vec<Node>,
}

impl Group {
    /// No texels.
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

    /// Begins with the texels from the one given; none of them takes part yet.
    #[inline(always)]
    pub fn begin(&mut self, texel: [i64; 2]) {
        self.texel = texel;
        self.low = [f32::INFINITY; LANES];
    }
}

/// What is done with a vertex that may matter. Its methods must be `inline(always)`, so that they are
/// compiled for the machine's vectors; a closure would not be.
pub(crate) trait Look {
    /// Whether cells are looked at from their highest corner alone. Then a vertex is looked at where its
    /// rise, over the distance of the cells around it, is above the bar; else where it, or a point of these
    /// cells, may be steeper.
    const HIGHEST_CORNERS: bool;

    /// Whether anything around the vertices of a node may matter. From the apexes of all lanes to these
    /// vertices and the cells around them it is at least `from` and at most `to` columns and rows of the map.
    fn may_matter(&self, level: u32, at: [u32; 2], from: [f32; 2], to: [f32; 2]) -> bool;

    /// The upper hull of all that may matter in a node, along an axis; `None` where that is not known.
    fn profile(&self, _level: u32, _at: [u32; 2], _axis: usize) -> Option<&[ProfileVertex]> {
        None
    }

    /// The lanes, a bit each, to which a node may matter by more than its highest vertex says. Its first and
    /// last columns and rows are counted from the group's first texel.
    fn may_matter_to(&self, _level: u32, _at: [u32; 2], _spans: [[f32; 2]; 2], lanes: u64) -> u64 {
        lanes
    }

    /// Looks at a vertex of that height for the lanes whose excess is positive.
    fn look<S: Simd>(
        &mut self,
        simd: S,
        group: &mut Group,
        excess: &[f32; LANES],
        vertex: [i64; 2],
        height: f64,
    );
}

/// A node that is still to be looked into.
#[derive(Clone, Copy)]
struct Node {
    level: u32,
    at: [u32; 2],
    sight: Sight,
    /// The lanes, a bit each, that may look into it.
    lanes: u64,
}

/// Where the vertices of a node are from a group, and the height of the highest.
#[derive(Clone, Copy)]
struct Sight {
    /// The first and the last column from the group's first texel.
    columns: [f32; 2],
    rows: Rows,
    highest: f32,
}

/// Rows of vertices, as far away as they are from all texels of a group.
#[derive(Clone, Copy)]
struct Rows {
    /// The last row is ahead of the group, not behind.
    is_ahead: bool,
    /// Squared distance along `v` from the apexes to the nearest row, and to the cells before it, in units of
    /// a texel's longer side.
    near2: [f32; 2],
    /// Vertices of these rows fewer columns away from a texel have only cells of its block around them.
    block: f32,
}

/// An image of the map as seen from a group.
#[derive(Clone, Copy)]
struct Image {
    /// Where it begins.
    begin: [i64; 2],
    is_mirrored: [bool; 2],
}

impl<'a> Walk<'a> {
    /// The pyramid of a map, for apexes there.
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

    /// The longer side of a texel in metres.
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

    /// Sets the squared slope, in heights per metre, above which a lane still looks.
    #[inline(always)]
    pub fn raise_bar(&self, group: &mut Group, lane: usize, slope2: f64) {
        group.bar[lane] = (slope2 * self.side_m * self.side_m * CAUTION) as f32;
        group.slope[lane] = raised(slope2, self.texel_m);
    }

    /// Looks, for each lane, at every vertex that may be steeper than its bar, or be a corner of a cell that
    /// holds a steeper point, unless all cells around it are in the lane's block. Vertices are those of the
    /// map and of its images at most so many tiles away. Images are gone through outward, until their highest
    /// point is too far to matter to any lane.
    ///
    /// A cell is hardly steeper than its corners. A segment of length `a`, at least the distance `g` away, is
    /// seen under an angle of at most `a / g`, and the slope falls with the cosine of the angle from where it
    /// is greatest. So one end has at least `cos(a / 2g)` of the greatest slope, and at least `1 - a²/4g²` of
    /// its square. Every point of a cell is on a line between two edges, so one corner has at least the
    /// square of that factor.
    ///
    /// On inclined ground that passes over nothing uphill, where all is equally steep. So a node is passed
    /// over as well where a plane above the cells around its vertices is not above the lane's cone: see
    /// [`Self::above_plane`]. What is lost to a tie is at most what slopes are raised by.
    #[inline(always)]
    pub fn walk<S: Simd>(&self, simd: S, group: &mut Group, tiles: [i64; 2], look: &mut impl Look) {
        for y in 0..=tiles[1] {
            let mut is_row_open = false;
            for y in signs(y) {
                for x in 0..=tiles[0] {
                    let mut is_open = false;
                    for x in signs(x) {
                        is_open |= self.walk_tile(simd, group, [x, y], look);
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

    /// Walks one image of the map; whether it is near enough to matter.
    #[inline(always)]
    fn walk_tile<S: Simd, L: Look>(&self, simd: S, group: &mut Group, tile: [i64; 2], look: &mut L) -> bool {
        let image = Image {
            begin: [0, 1].map(|axis| tile[axis] * self.size[axis] - group.texel[axis]),
            is_mirrored: tile.map(|tile| self.wrap == Wrap::Mirror && tile & 1 != 0),
        };
        let level = self.levels.top();
        let sight = Sight {
            columns: self.span(&image, 0, 0, level),
            rows: self.rows(self.span(&image, 1, 0, level)),
            highest: self.levels.level(level).highest([0, 0]),
        };
        if self.worth::<S, L>(simd, group, &sight).is_none() {
            return false;
        }
        let mut pending = std::mem::take(&mut group.pending);
        pending.clear();
        pending.push(Node { level, at: [0, 0], sight, lanes: ALL_LANES });
        let mut looked_into = 0;
        while let Some(node) = pending.pop() {
            let Node { level, at, sight, mut lanes } = node;
            let Some(mut excess) = self.worth::<S, L>(simd, group, &sight) else { continue };
            looked_into += 1;
            if looked_into > PATIENCE {
                lanes = self.above_plane(simd, group, &image, &node);
                for axis in 0..2 {
                    if lanes != 0
                        && let Some(hull) = look.profile(level, at, axis)
                    {
                        lanes &= self.above_profile(simd, group, &image, &node, (axis, hull));
                    }
                }
                for (excess, bit) in excess.iter().zip(LANE_BITS) {
                    lanes &= if *excess > 0.0 { !0 } else { !bit };
                }
                if lanes != 0 {
                    let spans = [sight.columns, self.span(&image, 1, at[1], level)];
                    lanes = look.may_matter_to(level, at, spans, lanes);
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
                look.look(simd, group, &excess, vertex, f64::from(sight.highest));
                continue;
            }
            let level = level - 1;
            let nodes = self.levels.level(level);
            let size = nodes.size();
            // The last one pushed is looked at first: that is to be the nearest.
            let is_ahead = [sight.columns[0] + sight.columns[1] > 0.0, sight.rows.is_ahead];
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
                    let sight = Sight { columns, rows, highest: nodes.highest([column, row]) };
                    let [[left, right], [top, bottom]] = [
                        self.around(columns, LANES - 1, image.is_mirrored[0]),
                        self.around(span, 0, image.is_mirrored[1]),
                    ];
                    if look.may_matter(level, [column, row], [left, top], [right, bottom])
                        && self.worth::<S, L>(simd, group, &sight).is_some()
                    {
                        pending.push(Node { level, at: [column, row], sight, lanes });
                    }
                }
            }
        }
        group.pending = pending;
        true
    }

    /// The lanes, a bit each, for which a node may matter by a profile of what may matter in it.
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

    /// A column or row of an image, from the group's first texel.
    #[inline(always)]
    fn place(&self, image: &Image, axis: usize, at: u32) -> i64 {
        let at = i64::from(at);
        image.begin[axis] + if image.is_mirrored[axis] { self.size[axis] - 1 - at } else { at }
    }

    /// The first and last column or row of a node; rounded beyond what `f32` counts exactly.
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

    /// The least and the most columns or rows, along the map, from all apexes to the cells around
    /// `from..=to`. These are counted from the first texel; the last texel is `lanes` after it.
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

    /// For each lane a positive number if a vertex in sight may matter to it; nothing if to none.
    #[inline(always)]
    fn worth<S: Simd, L: Look>(&self, simd: S, group: &Group, sight: &Sight) -> Option<[f32; LANES]> {
        let (zero, quarter) = (simd.splat_f32s(0.0), simd.splat_f32s(0.25));
        let [square_s, square_g] = sight.rows.near2;
        let (square_s, square_g) = (simd.splat_f32s(square_s), simd.splat_f32s(square_g));
        let (from, to) = (simd.splat_f32s(sight.columns[0]), simd.splat_f32s(sight.columns[1]));
        let block = simd.splat_f32s(sight.rows.block);
        let (highest, ax) = (simd.splat_f32s(sight.highest), simd.splat_f32s(self.sides[0]));
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

/// The larger one, in the form that compiles to one instruction.
#[inline(always)]
fn at_least(x: f32, least: f32) -> f32 {
    if x > least { x } else { least }
}

/// A number and its opposite, zero once.
fn signs(n: i64) -> impl Iterator<Item = i64> {
    std::iter::once(n).chain((n != 0).then_some(-n))
}
