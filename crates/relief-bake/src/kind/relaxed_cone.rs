//! Relaxed cone maps: cones that a view ray may leave below the surface, but only after a single entry.
//!
//! * Policarpo and Oliveira, *Relaxed Cone Stepping for Relief Mapping*, GPU Gems 3, chapter 18, 2007.
//! * Szirmay-Kalos and Umenhoffer, *Displacement Mapping on the GPU: State of the Art*, 2008, section 4.4.3.
//!
//! The published bake marches rays between pairs of texels, which passes over what lies between the samples. Here a cone is
//! limited by falling patches only, and by bounds that hold for the bilinear surface; that is Relief's own.

mod own;

use relief::registry::{Param, Source as Publication};
use relief::{HeightMap, Wrap};

use self::own::own_bound;
use super::cone::{self, Apexes, Field, Node, OWN_CELLS, Region, Seen, each_texel, ratio, texture};
use super::{BITS, Kind, Reach};
use crate::{BakeError, Cancelled, Metric, Progress, Settings, Sink, Source};

/// From where the relaxed cones of a map hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RelaxedApex {
    /// From the surface at the texel's centre, as published.
    Centre,
    /// From the surface at any place of the texel's square: for searches that move the apex to the ray and fetch the
    /// nearest texel.
    Footprint,
}

impl RelaxedApex {
    /// Every choice, in the order of the parameter's numbers.
    pub const ALL: [RelaxedApex; 2] = [RelaxedApex::Centre, RelaxedApex::Footprint];
}

const APEX: Param = Param {
    name: "apex",
    summary: "where the cones hold from: 0 texel centre, 1 anywhere in the texel",
    unit: "",
    min: 0.0,
    max: 1.0,
    default: 1.0,
    integer: true,
};

/// The kind `relaxed-cone`.
pub const KIND: Kind = Kind {
    name: "relaxed-cone",
    summary: "a wide cone that a view ray leaves after at most one entry into the surface",
    source: Publication {
        paper: "Szirmay-Kalos and Umenhoffer 2008, Displacement Mapping on the GPU",
        section: "4.4.3",
    },
    params: &[APEX, BITS],
    guarantee: "a straight falling ray over the apex p (apex 1: any point of the surface in the texel's square, apex 0: \
        at its centre), at or above the surface there, that is below the surface anywhere inside the cone at p stays \
        below until it leaves the cone: it enters at most once. Nothing is promised for rising or bent rays",
    reach: |_| Reach::Everything,
    bake,
};

/// The relaxed cone ratio of every texel, row by row: metres from the axis for each unit of texel height above the apex, in
/// the metric of [`super::cone::cone_ratios`].
///
/// # Guarantee
///
/// Let `p` be a point of the bilinear surface `f` over an apex of the texel: its centre, or any place of its closed square.
/// Let a straight ray begin at or above `p`, on the vertical through `p`, and fall. If the ray is below the surface at some
/// point inside the cone `{z ≥ f(p) + r / ratio}` at `p`, it is below the surface from there until it leaves the cone. So
/// where it leaves, it is at or above the surface if it met none before, or below it after exactly one entry; a search that
/// steps from border to border brackets the *first* hit between the last two points. Rays that rise or bend, as shadow rays do,
/// may come out again: for them nothing is promised.
///
/// # Proof
///
/// Let such a ray come out of the surface at `q`, at the distance `r > 0` from `p`, inside the cone. Just before `q` it runs
/// below a patch `X` that holds `q`, and out of it although it falls itself: so `f` falls there along the ray,
/// `∇f_X(q)·(q - p) < 0`. And `q` is in the cone: `(f(q) - f(p)) / r ≥ 1 / ratio`. Hence the cone is safe if its slope is above
///
/// ```text
/// sup (f(q) - f(p)) / |q - p|   over p in the apexes, q in a patch X with ∇f_X(q)·(q - p) ≤ 0.
/// ```
///
/// That is also necessary: a nearly horizontal ray through the peak behind such a `q` comes out again. The supremum is bounded,
/// patch by patch, by the least of two numbers, and by none where no pair falls:
///
/// * `∇f_X(q)·(q - p)` is affine in each of `q.x, q.y, p.x, p.y`, so it has its least value over a cell and the square at corners
///   of both.
/// * The slope of the cone from the square to the whole patch, found as the kind `cone` does.
/// * With the patch extended over `p` as `A + Bx + Cy + Dxy` over `f(p)`, `(x, y) = q - p`, a falling pair has `Bx + Cy + 2Dxy ≤ 0`
///   and so rises by at most `A - Dxy`. `A` is greatest at a corner of the nine points of the square's patches,
///   `-Dxy` at a corner of the two boxes, and the distance is at least that of the boxes.
///
/// For the four patches around the centre, which hold the apexes, the last bound is refined: see the module `own`. So no
/// relaxed cone is narrower than that of `cone`. The bounds
/// overestimate the supremum where a patch falls in part only. Rounding takes the same slack as in `cone`.
///
/// # Errors
///
/// When it was cancelled.
pub fn relaxed_cone_ratios(
    map: &HeightMap,
    metric: &Metric,
    apex: RelaxedApex,
    progress: &Progress,
) -> Result<Vec<f32>, Cancelled> {
    let field = Field::new(map, metric.texel_m(map));
    let region = match apex {
        RelaxedApex::Centre => Region::Centre,
        RelaxedApex::Footprint => Region::Footprint,
    };
    each_texel(&field, progress, |texel, seed, stack| {
        let (slope2, next) = steepest(&field, texel, region, seed, stack);
        (ratio(slope2, field.texel_m), next)
    })
}

/// The most images of the map that are looked at. Tiles a hundred times longer than wide need more; larger, and such a map
/// takes hours for cones that hardly differ.
const MOST_IMAGES: i64 = 4096;

fn steepest(
    field: &Field,
    texel: [i64; 2],
    region: Region,
    seed: Option<[i64; 2]>,
    stack: &mut Vec<Node>,
) -> (f64, Option<[i64; 2]>) {
    if field.map.wrap() != Wrap::Clamp && field.most_images() > MOST_IMAGES {
        // A cone that holds no surface is left after no entry at all, and for it the nearest image suffices.
        return cone::steepest(field, texel, region, seed, stack);
    }
    let apexes = Apexes::new(field, texel, region);
    let own = own_bound(field, texel, apexes.viewer.half);
    let mut whole = 0.0f64;
    for offset in OWN_CELLS {
        let seen = field.cell(texel, offset);
        whole = whole.max(apexes.own_slope2(&seen));
        apexes.raise(&seen, true, &mut whole);
    }
    let mut best = whole.min(own * own);
    // A patch that rises in the nearest image may fall in another.
    let tiles = if field.map.wrap() == Wrap::Clamp { [0; 2] } else { field.most_tiles };
    let look = |seen: &Seen, best: &mut f64| {
        if OWN_CELLS.contains(&seen.offset) || !may_fall(seen, apexes.viewer.half) {
            return;
        }
        let bound = falling_bound2(&apexes, seen);
        if bound > *best {
            let mut slope2 = *best;
            apexes.raise(seen, true, &mut slope2);
            *best = slope2.min(bound);
        }
    };
    let found = field.visit(&apexes.viewer, tiles, &mut best, seed, stack, look);
    (best, found.or(seed))
}

/// Whether the patch falls at some point of it, or is level, in the direction from some apex.
fn may_fall(seen: &Seen, half: f64) -> bool {
    let [h00, h10, h01, h11] = seen.heights;
    let [x, y] = seen.offset.map(|offset| offset as f64);
    [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)].into_iter().any(|(u, v)| {
        let along_x = (h10 - h00) * (1.0 - v) + (h11 - h01) * v;
        let along_y = (h01 - h00) * (1.0 - u) + (h11 - h10) * u;
        let terms = [along_x * (x + u), along_y * (y + v), along_x.abs() * half, along_y.abs() * half];
        let size: f64 = terms.iter().map(|term| term.abs()).sum();
        terms[0] + terms[1] - terms[2] - terms[3] <= ROUNDING * size
    })
}

/// Rounding of a sum of a few products, relative to the sum of their sizes.
const ROUNDING: f64 = 1e-14;

/// The square of what `A - Dxy` over the distance is at most: the last bound of the proof.
fn falling_bound2(apexes: &Apexes, seen: &Seen) -> f64 {
    let [h00, h10, h01, h11] = seen.heights;
    let half = apexes.viewer.half;
    let [x0, y0] = seen.offset.map(|offset| offset as f64);
    let (bx, by, d) = (h10 - h00, h01 - h00, (h00 - h10) + (h11 - h01));
    let mut extended = f64::NEG_INFINITY;
    for (row, heights) in apexes.grid().iter().enumerate() {
        for (column, height) in heights.iter().enumerate() {
            let u = (column as f64 - 1.0) * half - x0;
            let v = (row as f64 - 1.0) * half - y0;
            extended = extended.max(h00 + bx * u + (by + d * u) * v - height);
        }
    }
    let ends = |from: f64| [from - half, from + 1.0 + half];
    let products = ends(x0).map(|x| ends(y0).map(|y| -d * x * y));
    let bent = products.iter().flatten().copied().fold(f64::NEG_INFINITY, f64::max);
    let rounding = ROUNDING * (1.0 + x0.abs() + y0.abs() + d.abs() * (x0 * y0).abs());
    let rise = (extended + bent + rounding).max(0.0);
    let distance2 = apexes.distance2([x0, y0], [x0 + 1.0, y0 + 1.0]);
    if rise == 0.0 { 0.0 } else { rise * rise / distance2 }
}

fn bake(
    source: &Source,
    settings: &Settings,
    progress: &Progress,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    let (apex, bits) = (RelaxedApex::ALL[settings.count(0) as usize], settings.count(1));
    let ratios = relaxed_cone_ratios(source.map, &source.metric, apex, progress)?;
    texture(&source.metric, source.map, "relaxed_cone", ratios, bits, sink)
}
