//! The search for the steepest falling points.

use pulp::Simd;
use relief::{HeightMap, Wrap};

use super::super::cone::{
    Apexes, Block, CELLS_AROUND, Group, LANES, Lanes, Look, Region, Search, Seen, Sort, State, is_in_block,
    is_inside_block, most, steepest_in_quarter,
};
use super::falling::{ROUNDING, falling_slope2};
use super::own::own_bound;

/// The most images of the map that are looked at. Tiles a hundred times longer than wide need more; larger, and such a map
/// takes hours for cones that hardly differ.
const MOST_IMAGES: i64 = 4096;

/// Cones that a falling ray leaves after one entry at most.
pub(super) struct Relaxed {
    /// How many tiles away, along either axis, a point may be nearer than the highest point of the nearest tiles.
    tiles: [i64; 2],
}

impl Relaxed {
    /// For that map; none where too many images would have to be looked at.
    pub fn new(map: &HeightMap, texel_m: [f64; 2]) -> Option<Self> {
        if map.wrap() == Wrap::Clamp {
            return Some(Self { tiles: [0; 2] });
        }
        // Some image of the highest point is in the tile around an apex, and so not farther than a tile's diagonal. A patch that
        // rises in the nearest image may fall in another.
        let tile_m = [texel_m[0] * f64::from(map.width()), texel_m[1] * f64::from(map.height())];
        let diagonal = tile_m[0].hypot(tile_m[1]);
        let tiles = tile_m.map(|side| ((diagonal / side).ceil() + 1.0).min(1e6) as i64);
        let images: i64 = tiles.iter().map(|tiles| 2 * tiles + 1).product();
        (images <= MOST_IMAGES).then_some(Self { tiles })
    }

    /// What the four cells around the centre ask for, which hold the apexes: the least of two bounds.
    #[inline(always)]
    fn own_slope2<S: Simd>(
        &self,
        simd: S,
        search: &Search,
        block: &Block,
        lane: usize,
        apexes: &Apexes,
    ) -> f64 {
        let around = block.around(lane);
        let (texel_m, half) = (search.places.texel_m, search.places.region.half());
        let bound = own_bound(&around, texel_m, half);
        let per_side = texel_m.map(|side| 1.0 / side);
        let mut whole = 0.0f64;
        for offset in CELLS_AROUND {
            let (column, row) = ((offset[0] + 1) as usize, (offset[1] + 1) as usize);
            let [above, below] = [around[row], around[row + 1]];
            let heights = [above[column], above[column + 1], below[column], below[column + 1]];
            let [aside, ahead] = [around[1][2 * column], around[2 * row][1]];
            let quarter = [around[1][1], aside, ahead, around[2 * row][2 * column]];
            whole = whole.max(steepest_in_quarter(quarter, per_side));
            whole = search.to_cell(simd, apexes, &Seen { offset, heights }, whole);
        }
        whole.min(bound * bound)
    }

    /// Raises `best` to what the falling part of a cell asks for.
    #[inline(always)]
    fn raise<S: Simd>(&self, simd: S, search: &Search, apexes: &Apexes, seen: &Seen, best: &mut f64) {
        let places = &search.places;
        let from = seen.offset.map(|offset| offset as f64);
        let distance2 = places.distance2(from, [from[0] + 1.0, from[1] + 1.0]);
        let highest =
            seen.heights.iter().fold(0.0, |most, &height| if height > most { height } else { most });
        let rise = (highest - apexes.low).max(0.0);
        let half = places.region.half();
        if rise * rise <= *best * distance2 || !may_fall(seen, half) {
            return;
        }
        if places.region == Region::Centre {
            *best = falling_slope2(&places.patch(apexes, 0, seen)).max(*best);
            return;
        }
        let bound = falling_bound2(&places.grid(apexes), half, seen, distance2);
        if bound > *best {
            *best = search.to_cell(simd, apexes, seen, *best).min(bound).max(*best);
        }
    }
}

impl Sort for Relaxed {
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
        let region = search.places.region;
        let block = Block::new(&search.field, texel);
        let apexes = block.apexes(texel, region);
        let mut best = [0.0; LANES];
        let (group, seeds) = (&mut state.group, &mut state.seeds[texel[0] as usize..]);
        group.begin(texel);
        let mut falling = Falling { relaxed: self, search, apexes: &apexes, best: &mut best, seeds };
        for lane in 0..count {
            let apexes = &apexes[lane];
            if region == Region::Footprint {
                falling.best[lane] = self.own_slope2(simd, search, &block, lane, apexes);
            }
            if let Some(seed) = falling.seeds[lane] {
                let by = [0, 1].map(|axis| seed[axis] - apexes.texel[axis]);
                for offset in around(by) {
                    let seen = search.field.cell(apexes.texel, offset);
                    falling.raise(simd, lane, &seen);
                }
            }
            for seen in block.cells(lane) {
                falling.raise(simd, lane, &seen);
            }
            search.walk.lower(group, lane, apexes.low);
            search.walk.raise_bar(group, lane, falling.best[lane]);
        }
        search.walk.walk(simd, group, self.tiles, &mut falling);
        best
    }
}

/// Looks for what is steepest for each lane.
struct Falling<'a, 'b> {
    relaxed: &'b Relaxed,
    search: &'b Search<'a>,
    apexes: &'b [Apexes; LANES],
    best: &'b mut Lanes,
    seeds: &'b mut [Option<[i64; 2]>],
}

impl Falling<'_, '_> {
    /// Raises a lane to what a cell asks for; with a footprint its own cells are bounded otherwise.
    #[inline(always)]
    fn raise<S: Simd>(&mut self, simd: S, lane: usize, seen: &Seen) {
        let is_own = seen.offset.iter().all(|&x| x == 0 || x == -1);
        if !is_own || self.search.places.region == Region::Centre {
            self.relaxed.raise(simd, self.search, &self.apexes[lane], seen, &mut self.best[lane]);
        }
    }
}

impl Look for Falling<'_, '_> {
    #[inline(always)]
    fn look<S: Simd>(&mut self, simd: S, group: &mut Group, lane: usize, vertex: [i64; 2], height: f64) {
        let (search, apexes) = (self.search, &self.apexes[lane]);
        let by = [0, 1].map(|axis| vertex[axis] - apexes.texel[axis]);
        if is_inside_block(by) {
            return;
        }
        let before = self.best[lane];
        let steepest = most(&search.places.to_vertex(simd, apexes, by, height));
        if !search.may_be_steeper_around(by, steepest, before) {
            return;
        }
        for offset in around(by) {
            if is_in_block(offset) {
                continue;
            }
            self.raise(simd, lane, &search.field.cell(apexes.texel, offset));
        }
        if self.best[lane] > before {
            self.seeds[lane] = Some(vertex);
            search.walk.raise_bar(group, lane, self.best[lane]);
        }
    }
}

/// Offsets of the cells around a vertex.
fn around(by: [i64; 2]) -> [[i64; 2]; 4] {
    CELLS_AROUND.map(|[x, y]| [by[0] + x, by[1] + y])
}

/// Whether the patch falls at some point of it, or is level, in the direction from some apex.
#[inline(always)]
fn may_fall(seen: &Seen, half: f64) -> bool {
    let [h00, h10, h01, h11] = seen.heights;
    let [x, y] = seen.offset.map(|offset| offset as f64);
    let falls = |u: f64, v: f64, along_x: f64, along_y: f64| {
        let terms = [along_x * (x + u), along_y * (y + v), along_x.abs() * half, along_y.abs() * half];
        let size = terms[0].abs() + terms[1].abs() + terms[2] + terms[3];
        terms[0] + terms[1] - terms[2] - terms[3] <= ROUNDING * size
    };
    let (top, bottom, left, right) = (h10 - h00, h11 - h01, h01 - h00, h11 - h10);
    falls(0.0, 0.0, top, left)
        | falls(1.0, 0.0, top, right)
        | falls(0.0, 1.0, bottom, left)
        | falls(1.0, 1.0, bottom, right)
}

/// The square of what `A - Dxy` over the distance is at most: the last bound of the proof.
#[inline(always)]
fn falling_bound2(grid: &[[f64; 3]; 3], half: f64, seen: &Seen, distance2: f64) -> f64 {
    let [h00, h10, h01, h11] = seen.heights;
    let [x0, y0] = seen.offset.map(|offset| offset as f64);
    let (bx, by, d) = (h10 - h00, h01 - h00, (h00 - h10) + (h11 - h01));
    let mut extended = f64::NEG_INFINITY;
    for (row, heights) in grid.iter().enumerate() {
        for (column, height) in heights.iter().enumerate() {
            let u = (column as f64 - 1.0) * half - x0;
            let v = (row as f64 - 1.0) * half - y0;
            extended = extended.max(h00 + bx * u + (by + d * u) * v - height);
        }
    }
    let (left, right) = (x0 - half, x0 + 1.0 + half);
    let (top, bottom) = (y0 - half, y0 + 1.0 + half);
    let bent = (-d * left * top).max(-d * left * bottom).max(-d * right * top).max(-d * right * bottom);
    let rounding = ROUNDING * (1.0 + x0.abs() + y0.abs() + d.abs() * (x0 * y0).abs());
    let rise = (extended + bent + rounding).max(0.0);
    if rise == 0.0 { 0.0 } else { rise * rise / distance2 }
}
