//! Search for the steepest falling points.

use pulp::Simd;
use relief_core::{HeightMap, Wrap};

use super::directions::Directions;
use super::extrusions::{Extrusions, GroupSlopes};
use super::fall::{ROUNDING, falls};
use super::falling::falling_slope2;
use super::hulls::FallingHulls;
use super::own::own_bound;
use crate::cone_search::{
    Apexes, Bilinear, Block, COLUMNS, ConeType, Group, LANE_BITS, LANES, Lanes, ProfileVertex, Region,
    RelativeCell, Search, State, VertexVisitor, bits_of, cells_of_block, is_in_block, offset_of,
    steepest_in_quarter,
};

/// Most images of the map that are visited. Tiles a hundred times longer than wide need more. With
/// a greater limit, such a map would take hours for cones that hardly differ.
const MOST_IMAGES: i64 = 4096;

/// Slopes below the best by no more than this are not known to be below it.
const CAUTION: f64 = 1.0 - 1e-12;

/// Cones that a falling ray leaves after one entry at most.
pub(super) struct Relaxed {
    /// Distance in tiles, along either axis, within which images may matter.
    tiles: [i64; 2],
    directions: Directions,
    hulls: FallingHulls,
    extrusions: Extrusions,
    /// The longest way inside of a texel's square.
    diagonal_m: f64,
}

impl Relaxed {
    /// Prepares a map; none where too many images would have to be visited.
    pub fn new(map: &HeightMap, texel_m: [f64; 2]) -> Option<Self> {
        let of = |tiles| Self {
            tiles,
            directions: Directions::new(map),
            hulls: FallingHulls::new(map),
            extrusions: Extrusions::new(map),
            diagonal_m: texel_m[0].hypot(texel_m[1]),
        };
        if map.wrap() == Wrap::Clamp {
            return Some(of([0; 2]));
        }
        // Some image of the highest point is in the tile around an apex, and so not farther than a
        // tile's diagonal. A patch that rises in the nearest image may fall in another.
        let tile_m = [texel_m[0] * f64::from(map.width()), texel_m[1] * f64::from(map.height())];
        let diagonal = tile_m[0].hypot(tile_m[1]);
        let tiles = tile_m.map(|side| ((diagonal / side).ceil() + 1.0).min(1e6) as i64);
        let images: i64 = tiles.iter().map(|tiles| 2 * tiles + 1).product();
        (images <= MOST_IMAGES).then(|| of(tiles))
    }

    /// Prepares a map, but visits all cells of ground that is alike along an axis.
    #[cfg(test)]
    pub fn without_extrusions(map: &HeightMap, texel_m: [f64; 2]) -> Option<Self> {
        Self::new(map, texel_m).map(|relaxed| Self { extrusions: Extrusions::none(), ..relaxed })
    }

    /// Returns two squared slopes. The first is required by the four cells around the centre, which
    /// hold the apexes, by the lesser of two bounds. The second is the slope of the surface itself
    /// in the square.
    #[inline(always)]
    fn own_slopes2<S: Simd>(
        &self,
        simd: S,
        search: &Search,
        block: &Block,
        lane: usize,
        apexes: &Apexes,
    ) -> [f64; 2] {
        let around = block.around(lane);
        let (texel_m, half) = (search.geometry.texel_m, search.geometry.region.half());
        let bound = own_bound(&around, texel_m, half);
        let per_side = texel_m.map(|side| 1.0 / side);
        let cells = RelativeCell::around([0, 0], &around);
        let mut gradient2 = 0.0f64;
        for cell in &cells {
            let [column, row] = [usize::from(cell.offset[0] == 0) * 2, usize::from(cell.offset[1] == 0) * 2];
            let quarter = [around[1][1], around[1][column], around[row][1], around[row][column]];
            gradient2 = gradient2.max(steepest_in_quarter(quarter, per_side));
        }
        let mut whole = gradient2;
        for cell in &cells {
            if whole >= bound * bound {
                break;
            }
            whole = search.to_cell(simd, apexes, cell, whole);
        }
        [whole.min(bound * bound), gradient2]
    }

    /// Raises `best` to the slope that the falling part of a cell requires, when the cell falls
    /// anywhere.
    #[inline(always)]
    fn raise<S: Simd>(
        &self,
        simd: S,
        search: &Search,
        apexes: &Apexes,
        gradient2: f64,
        cell: &RelativeCell,
        best: &mut f64,
    ) {
        let geometry = &search.geometry;
        let from = cell.offset.map(|offset| offset as f64);
        let distance2 = geometry.distance2(from, [from[0] + 1.0, from[1] + 1.0]);
        let highest =
            cell.heights.iter().fold(0.0, |most, &height| if height > most { height } else { most });
        let rise = (highest - apexes.low).max(0.0);
        let half = geometry.region.half();
        if rise * rise <= *best * distance2 {
            return;
        }
        let falls = falls(cell, half);
        if geometry.region == Region::Centre {
            *best = falling_slope2(&geometry.patch(apexes, 0, cell), falls).max(*best);
            return;
        }
        if falls.iter().all(|fall| *fall >= 0.0) {
            return;
        }
        let bound = falling_bound2(&geometry.grid(apexes), half, cell, distance2, *best);
        if bound > *best {
            // From inside the square the way leads over the rim: its slope is a mean of the slopes
            // before and behind. The first part is no longer than the square's diagonal.
            let (gradient, far) = (gradient2.sqrt(), distance2.sqrt());
            let inside = self.diagonal_m / (self.diagonal_m + far);
            // Below this slope from the rim the way is not steeper than the best, whatever is
            // inside.
            let steepest = best.sqrt();
            let least = ((steepest - gradient.max(steepest) * inside) / (1.0 - inside)).max(0.0) * CAUTION;
            let rim = search.to_cell(simd, apexes, cell, least * least).sqrt();
            if rim <= least {
                return;
            }
            let within = rim + (gradient - rim).max(0.0) * inside;
            *best = (within * within).min(bound).min(rise * rise / distance2).max(*best);
        }
    }
}

impl ConeType for Relaxed {
    const NEAR: bool = false;

    #[inline(always)]
    fn slopes2<S: Simd>(
        &self,
        simd: S,
        search: &Search,
        texel: [i64; 2],
        count: usize,
        _: Lanes,
        state: &mut State,
    ) -> Lanes {
        let region = search.geometry.region;
        let block = Block::new(&search.field, texel);
        let apexes = block.apexes(texel, region);
        let mut best = [0.0; LANES];
        let (before, seeds) = state.seeds.split_at_mut(texel[0] as usize);
        let group = &mut state.group;
        group.begin(texel);
        let (lows, gradients2) = (apexes.each_ref().map(|apexes| apexes.low), [0.0; LANES]);
        let mut falling =
            Falling { relaxed: self, search, apexes: &apexes, lows, gradients2, best: &mut best, seeds };
        for lane in 0..count {
            let apexes = &apexes[lane];
            if region == Region::Footprint {
                [falling.best[lane], falling.gradients2[lane]] =
                    self.own_slopes2(simd, search, &block, lane, apexes);
            }
            search.walk.lower(group, lane, apexes);
        }
        for lane in 0..count {
            search.walk.raise_bar(group, lane, falling.best[lane]);
        }
        // The points that were steepest for the texel before and in the row above come first, then
        // the nearest cells. After these, little is steeper.
        let lanes = (1 << count) - 1;
        let of_row_above: [_; LANES] = std::array::from_fn(|lane| falling.seeds.get(lane).copied().flatten());
        let of_texel_before = before.last().copied().flatten().map(|seed| (lanes, seed));
        let of_row_above =
            LANE_BITS.into_iter().zip(of_row_above).filter_map(|(lane, seed)| Some((lane, seed?)));
        for (lanes, seed) in of_texel_before.into_iter().chain(of_row_above) {
            let mut only = [0.0; LANES];
            for (only, lane) in only.iter_mut().zip(LANE_BITS) {
                *only = if lanes & lane == 0 { 0.0 } else { 1.0 };
            }
            falling.visit(simd, group, &only, seed, f64::from(search.field.map.texel(seed[0], seed[1])));
        }
        for first in cells_of_block() {
            for lane in bits_of(lanes & falling.may_matter_in_block(simd, &block, first)) {
                falling.raise(simd, lane, &block.cell(lane, first));
            }
        }
        for lane in 0..count {
            search.walk.raise_bar(group, lane, falling.best[lane]);
        }
        search.walk.walk(simd, group, self.tiles, &mut falling);
        best
    }
}

#[cfg(test)]
thread_local! {
    static VISITS: std::cell::Cell<u64> = const { std::cell::Cell::new(0) };
}

/// Returns the number of vertices that this thread has visited.
#[cfg(test)]
pub(super) fn visits() -> u64 {
    VISITS.get()
}

/// Visitor that finds the steepest falling point for each lane.
struct Falling<'a, 'b> {
    relaxed: &'b Relaxed,
    search: &'b Search<'a>,
    apexes: &'b [Apexes; LANES],
    /// Lowest apexes.
    lows: Lanes,
    /// Squared slopes of the surface itself in the squares.
    gradients2: Lanes,
    best: &'b mut Lanes,
    seeds: &'b mut [Option<[i64; 2]>],
}

impl Falling<'_, '_> {
    /// Raises a lane to the slope that a cell requires; with a footprint its own cells are bounded
    /// otherwise.
    #[inline(always)]
    fn raise<S: Simd>(&mut self, simd: S, lane: usize, cell: &RelativeCell) {
        let is_own = cell.offset.iter().all(|&x| x == 0 || x == -1);
        if !is_own || self.search.geometry.region == Region::Centre {
            let (apexes, gradient2) = (&self.apexes[lane], self.gradients2[lane]);
            self.relaxed.raise(simd, self.search, apexes, gradient2, cell, &mut self.best[lane]);
        }
    }
}

impl Falling<'_, '_> {
    /// Returns the lanes, a bit each, whose cell at a vertex of the block may fall and be steeper
    /// than the best.
    #[inline(always)]
    fn may_matter_in_block<S: Simd>(&self, simd: S, block: &Block, first: usize) -> u64 {
        let corners = block.corners(first);
        let [x, y] = offset_of(first).map(|offset| offset as f64);
        let distance2 = simd.splat_f64s(self.search.geometry.distance2([x, y], [x + 1.0, y + 1.0]));
        let (x, y) = (simd.splat_f64s(x), simd.splat_f64s(y));
        let half = simd.splat_f64s(self.search.geometry.region.half());
        let zero = simd.splat_f64s(0.0);
        let mut may = [0; LANES];
        for (part, may) in S::as_mut_simd_u64s(&mut may).0.iter_mut().enumerate() {
            let [h00, h10, h01, h11] = [
                S::as_simd_f64s(corners[0]).0[part],
                S::as_simd_f64s(corners[1]).0[part],
                S::as_simd_f64s(corners[2]).0[part],
                S::as_simd_f64s(corners[3]).0[part],
            ];
            let falls = may_fall(simd, [h00, h10, h01, h11], x, y, half);
            let highest = simd.max_f64s(simd.max_f64s(h00, h10), simd.max_f64s(h01, h11));
            let rise = simd.max_f64s(simd.sub_f64s(highest, S::as_simd_f64s(&self.lows).0[part]), zero);
            let least = simd.mul_f64s(S::as_simd_f64s(self.best).0[part], distance2);
            let matters = simd.and_m64s(falls, simd.less_than_f64s(least, simd.mul_f64s(rise, rise)));
            *may = simd.select_u64s(matters, S::as_simd_u64s(&LANE_BITS).0[part], simd.splat_u64s(0));
        }
        may.into_iter().fold(0, |all, bit| all | bit)
    }

    /// Returns the lanes, a bit each, for which a cell, relative to the first lane, may fall.
    #[inline(always)]
    fn may_fall<S: Simd>(&self, simd: S, cell: &RelativeCell) -> u64 {
        let [h00, h10, h01, h11] = cell.heights;
        let corners =
            [simd.splat_f64s(h00), simd.splat_f64s(h10), simd.splat_f64s(h01), simd.splat_f64s(h11)];
        let (x, y) = (simd.splat_f64s(cell.offset[0] as f64), simd.splat_f64s(cell.offset[1] as f64));
        let half = simd.splat_f64s(self.search.geometry.region.half());
        let mut may = [0; LANES];
        for (part, may) in S::as_mut_simd_u64s(&mut may).0.iter_mut().enumerate() {
            let x = simd.sub_f64s(x, S::as_simd_f64s(&COLUMNS).0[part]);
            let falls = may_fall(simd, corners, x, y, half);
            *may = simd.select_u64s(falls, S::as_simd_u64s(&LANE_BITS).0[part], simd.splat_u64s(0));
        }
        may.into_iter().fold(0, |all, bit| all | bit)
    }
}

impl VertexVisitor for Falling<'_, '_> {
    const HIGHEST_CORNERS: bool = true;

    #[inline(always)]
    fn may_matter(&self, level: u32, at: [u32; 2], from: [f32; 2], to: [f32; 2]) -> bool {
        self.relaxed.directions.may_fall(level, at, from, to)
    }

    #[inline(always)]
    fn profile(&self, level: u32, at: [u32; 2], axis: usize) -> Option<&[ProfileVertex]> {
        self.relaxed.hulls.hull(level, at, axis)
    }

    #[inline(always)]
    fn may_matter_to(&self, level: u32, at: [u32; 2], spans: [[f32; 2]; 2], lanes: u64) -> u64 {
        let Some(node) = self.relaxed.extrusions.node(level, at, spans) else { return lanes };
        node.may_matter(self.search, &GroupSlopes { apexes: self.apexes, best: self.best }, lanes)
    }

    #[inline(always)]
    fn visit<S: Simd>(
        &mut self,
        simd: S,
        group: &mut Group,
        excess: &[f32; LANES],
        vertex: [i64; 2],
        height: f64,
    ) {
        #[cfg(test)]
        VISITS.set(VISITS.get() + 1);
        let first = self.apexes[0].texel;
        let by = [vertex[0] - first[0], vertex[1] - first[1]];
        let wanted =
            excess.iter().zip(LANE_BITS).fold(0, |all, (&x, bit)| all | if x > 0.0 { bit } else { 0 });
        for cell in RelativeCell::around(by, &self.search.field.around(vertex)) {
            // A cell is visited from its highest corner: once, but where corners are equally high.
            let [h00, h10, h01, h11] = cell.heights;
            if (h00 > height) | (h10 > height) | (h01 > height) | (h11 > height) {
                continue;
            }
            let from = cell.offset.map(|offset| offset as f64);
            let bounds = Bilinear { from, to: [from[0] + 1.0, from[1] + 1.0], heights: cell.heights };
            let mut lanes = wanted & self.may_fall(simd, &cell);
            if lanes != 0 {
                lanes &= self.search.walk.may_be_steeper(simd, group, &bounds);
            }
            for lane in bits_of(lanes) {
                let offset = [cell.offset[0] - lane as i64, cell.offset[1]];
                let before = self.best[lane];
                if !is_in_block(offset) {
                    self.raise(simd, lane, &RelativeCell { offset, heights: cell.heights });
                }
                if self.best[lane] > before {
                    self.seeds[lane] = Some(vertex);
                    self.search.walk.raise_bar(group, lane, self.best[lane]);
                }
            }
        }
    }
}

/// Returns the lanes in which a patch may fall at some point of it as seen from some apex. These
/// are all lanes in which it falls, and none in which it is level. Its corner `h00` is `(x, y)`
/// texels from the centre of the apexes, which are up to `half` texels from there along each axis.
#[inline(always)]
fn may_fall<S: Simd>(
    simd: S,
    [h00, h10, h01, h11]: [S::f64s; 4],
    x: S::f64s,
    y: S::f64s,
    half: S::f64s,
) -> S::m64s {
    let one = simd.splat_f64s(1.0);
    let (right, down) = (simd.add_f64s(x, one), simd.add_f64s(y, one));
    let (above, below) = (simd.sub_f64s(h10, h00), simd.sub_f64s(h11, h01));
    let (left, beyond) = (simd.sub_f64s(h01, h00), simd.sub_f64s(h11, h10));
    let upper = simd.or_m64s(
        may_fall_towards(simd, [above, left], [x, y], half),
        may_fall_towards(simd, [above, beyond], [right, y], half),
    );
    let lower = simd.or_m64s(
        may_fall_towards(simd, [below, left], [x, down], half),
        may_fall_towards(simd, [below, beyond], [right, down], half),
    );
    simd.or_m64s(upper, lower)
}

/// Returns the lanes in which the slope at a corner, towards it, may be negative from some apex.
#[inline(always)]
fn may_fall_towards<S: Simd>(simd: S, along: [S::f64s; 2], place: [S::f64s; 2], half: S::f64s) -> S::m64s {
    let size = [simd.abs_f64s(along[0]), simd.abs_f64s(along[1])];
    let centre = simd.add_f64s(simd.mul_f64s(along[0], place[0]), simd.mul_f64s(along[1], place[1]));
    let least = simd.sub_f64s(centre, simd.mul_f64s(half, simd.add_f64s(size[0], size[1])));
    let far = [simd.add_f64s(simd.abs_f64s(place[0]), half), simd.add_f64s(simd.abs_f64s(place[1]), half)];
    let most = simd.add_f64s(simd.mul_f64s(size[0], far[0]), simd.mul_f64s(size[1], far[1]));
    simd.less_than_f64s(least, simd.mul_f64s(most, simd.splat_f64s(ROUNDING)))
}

/// Returns the square of a falling pair's greatest rise over the distance: the last bound of the
/// proof. It is 0 where it is not above `best`.
#[inline(always)]
fn falling_bound2(grid: &[[f64; 3]; 3], half: f64, cell: &RelativeCell, distance2: f64, best: f64) -> f64 {
    let [h00, h10, h01, h11] = cell.heights;
    let highest = h00.max(h10).max(h01).max(h11);
    let [x0, y0] = cell.offset.map(|offset| offset as f64);
    let (bx, by, d) = (h10 - h00, h01 - h00, (h00 - h10) + (h11 - h01));
    let (mut over, mut extended) = ([[0.0; 3]; 3], f64::NEG_INFINITY);
    for (row, (over, heights)) in over.iter_mut().zip(grid).enumerate() {
        for (column, (over, height)) in over.iter_mut().zip(heights).enumerate() {
            let u = (column as f64 - 1.0) * half - x0;
            let v = (row as f64 - 1.0) * half - y0;
            *over = h00 + bx * u + (by + d * u) * v - height;
            extended = extended.max(*over);
        }
    }
    let (left, right) = (x0 - half, x0 + 1.0 + half);
    let (top, bottom) = (y0 - half, y0 + 1.0 + half);
    let bent = (-d * left * top).max(-d * left * bottom).max(-d * right * top).max(-d * right * bottom);
    let rounding = ROUNDING * (1.0 + x0.abs() + y0.abs() + d.abs() * (x0 * y0).abs());
    let most = (extended + bent + rounding).max(0.0);
    if most * most <= best * distance2 {
        return 0.0;
    }
    let mut rise = 0.0f64;
    for row in 0..2 {
        for column in 0..2 {
            let (mut extended, mut low) = (f64::NEG_INFINITY, f64::INFINITY);
            for [i, j] in [[0, 0], [1, 0], [0, 1], [1, 1]] {
                extended = extended.max(over[row + j][column + i]);
                low = low.min(grid[row + j][column + i]);
            }
            rise = rise.max((extended + bent + rounding).min(highest - low));
        }
    }
    rise * rise / distance2
}
