//! Every vertex that may matter to a few texels side by side, and few others: a shared descent of a maximum pyramid.

use pulp::Simd;
use relief::{HeightMap, Wrap};

use super::super::levels::Levels;

/// Texels of a row that are searched for at once. They share the walk through the pyramid, and the compiler compares them
/// together; more of them share fewer of their nodes.
pub(in crate::kind) const LANES: usize = 8;

/// What lowers a squared slope so that in `f32` a node is passed over only if it surely can be: some twelve roundings of
/// 2⁻²⁴.
const CAUTION: f64 = 1.0 - 1.0 / (1u64 << 19) as f64;

/// The map's pyramid and the shape of its texels.
pub(in crate::kind) struct Walk<'a> {
    levels: Levels<'a>,
    size: [i64; 2],
    wrap: Wrap,
    /// Sides of a texel over the longer one.
    sides: [f32; 2],
    /// The longer side in metres.
    side_m: f64,
    /// Half the side of the box of apexes, in texels.
    half: f32,
}

/// Texels side by side, what they have found so far, and the nodes that are still to be looked into.
pub(in crate::kind) struct Group {
    /// The first texel.
    texel: [i64; 2],
    /// The lowest apex of each, rounded down; infinite for lanes without a texel.
    low: [f32; LANES],
    /// The steepest squared slope so far, lowered, in heights per longer side.
    bar: [f32; LANES],
    pending: Vec<(Node, Sight)>,
}

impl Group {
    /// No texels.
    pub fn new() -> Self {
        Self {
            texel: [0; 2],
            low: [f32::INFINITY; LANES],
            bar: [0.0; LANES],
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

/// What is done with a vertex that may matter. It is to be inlined always, so that it is compiled for the vectors that the
/// machine has; a closure would not be.
pub(in crate::kind) trait Look {
    /// Looks at a vertex of that height for a lane.
    fn look<S: Simd>(&mut self, simd: S, group: &mut Group, lane: usize, vertex: [i64; 2], height: f64);
}

#[derive(Clone, Copy)]
struct Node {
    level: u32,
    at: [u32; 2],
}

/// A rectangle of vertices, from the first texel of a group, and the height of the highest.
#[derive(Clone, Copy)]
struct Sight {
    from: [i64; 2],
    to: [i64; 2],
    highest: f32,
}

impl<'a> Walk<'a> {
    /// The pyramid of a map, for apexes in the box of that half side.
    pub fn new(map: &'a HeightMap, texel_m: [f64; 2], half: f64) -> Self {
        let side_m = texel_m[0].max(texel_m[1]);
        Self {
            levels: Levels::new(map),
            size: [i64::from(map.width()), i64::from(map.height())],
            wrap: map.wrap(),
            sides: texel_m.map(|side| (side / side_m) as f32),
            side_m,
            half: half as f32,
        }
    }

    /// The longer side of a texel in metres.
    pub fn side_m(&self) -> f64 {
        self.side_m
    }

    /// Lets a lane take part, with its lowest apex.
    #[inline(always)]
    pub fn lower(&self, group: &mut Group, lane: usize, low: f64) {
        let near = low as f32;
        group.low[lane] = if f64::from(near) > low { near.next_down() } else { near };
    }

    /// Sets the squared slope, in heights per metre, above which a lane still looks.
    #[inline(always)]
    pub fn raise_bar(&self, group: &mut Group, lane: usize, slope2: f64) {
        group.bar[lane] = (slope2 * self.side_m * self.side_m * CAUTION) as f32;
    }

    /// Looks for a lane at every vertex that may itself be steeper for the lane than its
    /// bar, or may be a corner of a cell that holds a steeper point. In the map and in its images at most so many
    /// tiles away; images are looked at outward until their highest point is too far to matter to any lane.
    ///
    /// A cell that is steeper than all of its corners at their distance is so by little: a segment of length `a` at least the
    /// distance `g` away is seen under an angle of at most `a / g`, and the slope falls with the cosine of the angle from where it
    /// is greatest. So an edge has a corner not below `cos(a / 2g) ≥ 1 - a²/4g²` of its slope (that factor, squared, is not above
    /// the square of the cosine), and a cell, whose every point is on a line between two edges, a corner not below the square of that.
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
    fn walk_tile<S: Simd>(&self, simd: S, group: &mut Group, tile: [i64; 2], look: &mut impl Look) -> bool {
        let mut pending = std::mem::take(&mut group.pending);
        pending.clear();
        let root = Node { level: self.levels.top(), at: [0, 0] };
        let sight = self.sight(group, tile, root);
        let is_open = self.worth(simd, group, &sight).is_some();
        if is_open {
            pending.push((root, sight));
        }
        while let Some((node, sight)) = pending.pop() {
            let Some(excess) = self.worth(simd, group, &sight) else { continue };
            if node.level == 0 {
                let vertex = [0, 1].map(|axis| group.texel[axis] + sight.from[axis]);
                for lane in (0..LANES).filter(|lane| excess[*lane] > 0.0) {
                    look.look(simd, group, lane, vertex, f64::from(sight.highest));
                }
                continue;
            }
            let level = node.level - 1;
            let [columns, rows] = self.levels.level(level).size();
            // The last one pushed is looked at first: that is to be the nearest.
            let order = |axis: usize| {
                let first = 2 * node.at[axis];
                let is_ahead = sight.from[axis] + sight.to[axis] > 0;
                let is_mirrored = self.wrap == Wrap::Mirror && tile[axis] & 1 != 0;
                if is_ahead != is_mirrored { [first + 1, first] } else { [first, first + 1] }
            };
            let (across, down) = (order(0), order(1));
            for row in down {
                for column in across {
                    if column < columns && row < rows {
                        let child = Node { level, at: [column, row] };
                        let sight = self.sight(group, tile, child);
                        if self.worth(simd, group, &sight).is_some() {
                            pending.push((child, sight));
                        }
                    }
                }
            }
        }
        group.pending = pending;
        is_open
    }

    /// Where a node of an image is.
    #[inline(always)]
    fn sight(&self, group: &Group, tile: [i64; 2], node: Node) -> Sight {
        let (mut from, mut to) = ([0; 2], [0; 2]);
        for axis in 0..2 {
            let size = self.size[axis];
            let first = i64::from(node.at[axis]) << node.level;
            let last = (first + (1 << node.level)).min(size) - 1;
            let begin = tile[axis] * size - group.texel[axis];
            (from[axis], to[axis]) = if self.wrap == Wrap::Mirror && tile[axis] & 1 != 0 {
                (begin + size - 1 - last, begin + size - 1 - first)
            } else {
                (begin + first, begin + last)
            };
        }
        Sight { from, to, highest: self.levels.level(node.level).highest(node.at) }
    }

    /// For each lane a positive number if a vertex in sight may matter to it; nothing if to none.
    #[inline(always)]
    fn worth<S: Simd>(&self, simd: S, group: &Group, sight: &Sight) -> Option<[f32; LANES]> {
        let [ax, ay] = self.sides;
        // Beyond what `f32` counts exactly, distances are rounded as all else is.
        let (from, to) = (sight.from, sight.to);
        let (from, to) = ([from[0] as f32, from[1] as f32], [to[0] as f32, to[1] as f32]);
        let away_y = at_least(at_least(from[1], -to[1]), 0.0) - self.half;
        let (sy, gy) = (at_least(away_y, 0.0) * ay, at_least(away_y - 1.0, 0.0) * ay);
        let (zero, quarter) = (simd.splat_f32s(0.0), simd.splat_f32s(0.25));
        let (square_s, square_g) = (simd.splat_f32s(sy * sy), simd.splat_f32s(gy * gy));
        let (from, to) = (simd.splat_f32s(from[0]), simd.splat_f32s(to[0]));
        let (highest, ax) = (simd.splat_f32s(sight.highest), simd.splat_f32s(ax));
        let (half, reach) = (simd.splat_f32s(self.half), simd.splat_f32s(self.half + 1.0));
        let mut excess = [0.0; LANES];
        let mut any = false;
        for (part, excess) in S::as_mut_simd_f32s(&mut excess).0.iter_mut().enumerate() {
            let by = S::as_simd_f32s(&COLUMNS).0[part];
            let away = simd.max_f32s(simd.sub_f32s(from, by), simd.sub_f32s(by, to));
            let sx = simd.mul_f32s(simd.max_f32s(simd.sub_f32s(away, half), zero), ax);
            let gx = simd.mul_f32s(simd.max_f32s(simd.sub_f32s(away, reach), zero), ax);
            let s2 = simd.add_f32s(simd.mul_f32s(sx, sx), square_s);
            let g2 = simd.add_f32s(simd.mul_f32s(gx, gx), square_g);
            let open = simd.max_f32s(simd.sub_f32s(g2, quarter), zero);
            let rise = simd.max_f32s(simd.sub_f32s(highest, S::as_simd_f32s(&group.low).0[part]), zero);
            let rise = simd.mul_f32s(rise, simd.max_f32s(g2, quarter));
            let bar = simd.mul_f32s(S::as_simd_f32s(&group.bar).0[part], s2);
            *excess = simd.sub_f32s(simd.mul_f32s(rise, rise), simd.mul_f32s(bar, simd.mul_f32s(open, open)));
            any |= simd.reduce_max_f32s(*excess) > 0.0;
        }
        any.then_some(excess)
    }
}

/// How far each lane's texel is from the first.
const COLUMNS: [f32; LANES] = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0];

/// The larger one, in the form that compiles to one instruction.
#[inline(always)]
fn at_least(x: f32, least: f32) -> f32 {
    if x > least { x } else { least }
}

/// A number and its opposite, zero once.
fn signs(n: i64) -> impl Iterator<Item = i64> {
    std::iter::once(n).chain((n != 0).then_some(-n))
}
