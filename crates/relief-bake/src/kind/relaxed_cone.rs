//! Relaxed cone maps: cones that a view ray leaves after at most one entry into the surface.
//!
//! * Policarpo and Oliveira, *Relaxed Cone Stepping for Relief Mapping*, GPU Gems 3, chapter 18,
//!   2007.
//! * Szirmay-Kalos and Umenhoffer, *Displacement Mapping on the GPU: State of the Art*, 2008,
//!   section 4.4.3.
//!
//! The published bake marches rays between pairs of texels, which misses the surface between the
//! samples. Here only falling patches limit a cone, and the bounds hold for the bilinear surface.
//! This is Relief's own.

mod directions;
mod extrusions;
mod fall;
mod falling;
mod hulls;
mod own;
mod search;

use relief_core::registry::{Param, Publication};
use relief_core::{Cancelled, HeightMap, Metric, Watch};

use self::search::Relaxed;
use super::{BITS, Kind, Reach};
use crate::cone_search::{Empty, Region, Search, texture};
use crate::{BakeError, BakeInput, Settings, Shape, Sink};

/// Places from which the relaxed cones of a map hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RelaxedApex {
    /// From the surface at the texel's centre, as published.
    Centre,
    /// From the surface at any place of the texel's square: for searches that move the apex to the
    /// ray and fetch the nearest texel.
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
    names: &[],
};

/// The kind `relaxed-cone`.
pub const KIND: Kind = Kind {
    name: "relaxed-cone",
    summary: "a wide cone that a view ray leaves after at most one entry into the surface",
    revision: 4,
    publication: Publication {
        paper: "Szirmay-Kalos and Umenhoffer 2008, Displacement Mapping on the GPU",
        section: "4.4.3",
    },
    params: &[APEX, BITS],
    guarantee: "a straight falling ray over the apex p (apex 1: any point of the surface in the texel's \
        square, apex 0: at its centre), at or above the surface there, that is below the surface anywhere \
        inside the cone at p stays below until it leaves the cone: it enters at most once. A ray that only \
        touches the surface, as one does that runs along level ground at its very height, has not entered. \
        Nothing is promised for rising or bent rays",
    is_picture: false,
    of_volume: false,
    shapes: |size, _| vec![Shape::slices("", size, 1, 1)],
    reach: |_| Reach::Everything,
    working_maps: |_| super::WORKING_MAPS,
    bake,
};

/// Returns the relaxed cone ratio of every texel, row by row: metres from the axis for a texel
/// height of 1 above the apex, in the metric of [`super::cone::cone_ratios`].
///
/// # Guarantee
///
/// Let `p` be a point of the bilinear surface `f` over an apex of the texel: its centre, or any
/// place of its closed square. Let a straight ray begin at or above `p`, on the vertical through
/// `p`, and fall or be level. If the ray is below the surface at some point inside the cone
/// `{z ≥ f(p) + r / ratio}` at `p`, it is below the surface from there until it leaves the cone.
/// Where it leaves, it is at or above the surface if it was nowhere below before, or below it after
/// exactly one entry. A search that steps from border to border brackets the *first* entry between
/// the last two points. Rays that rise or bend, as shadow rays do, may come out again: for them
/// nothing is promised.
///
/// A ray is below the surface where it is lower, not where it is as high. A level ray that reaches
/// level ground at its very height, such as the edge of a terrace, touches it and has not entered;
/// it may pass over it. A ray that enters a rise below the height of a terrace stays below until
/// the terrace ends. So level ground limits no cone; only the edge at which it falls off does.
///
/// # Proof
///
/// Let such a ray be below the surface and behind that, inside the cone, not below any more, for
/// the first time at `q`, at the distance `r > 0` from `p`. Then `q` is on the surface, and just
/// before it the gap from the ray up to the surface closes. So, as near to `q` as one likes, there
/// are points `q'` below which the ray runs and at which the gap gets less. The ray does not rise,
/// so at `q'` the surface falls along it: `∇f_X(q')·(q' - p) < 0`, with the patch `X` that holds
/// the way before `q`. And `q` is in the cone: `(f(q) - f(p)) / r ≥ 1 / ratio`. Hence the cone is
/// safe if its slope is above
///
/// ```text
/// sup (f(q) - f(p)) / |q - p|   over p in the apexes, q in a patch X with ∇f_X(q)·(q - p) < 0.
/// ```
///
/// This is also necessary: a nearly level ray through the surface at such a `q` is below it just
/// before, and comes out. Where the surface is level along the ray nothing comes out, so the
/// inequality is strict. It is strict without rounding; see the module `fall`. With
/// [`RelaxedApex::Centre`] the supremum is found in closed form, patch by patch, in the module
/// `falling`. The ratio is what it allows, less the rounding that `cone` allows for: no wider cone
/// holds.
///
/// With [`RelaxedApex::Footprint`] the apexes that suffice for `cone` do not, since the points `q`
/// that count depend on `p`. There the supremum is bounded, patch by patch, by the lesser of two
/// numbers. A patch where no pair falls does not count:
///
/// * `∇f_X(q)·(q - p)` is affine in each of `q.x, q.y, p.x, p.y`, so over a cell and the square it
///   has its least value at corners of both. Where this value is not negative, no pair falls.
/// * The slope from the rim of the square to the whole patch is found as in the kind `cone`. A way
///   from inside of the square leads over the rim, and its slope is a mean of both parts. So the
///   bound is moved towards the greatest slope in the square, as far as the first part, a diagonal
///   at most, may count.
/// * With the patch extended over `p` as `A + Bx + Cy + Dxy` over `f(p)`, `(x, y) = q - p`, a
///   falling pair has `Bx + Cy + 2Dxy ≤ 0` and so rises by at most `A - Dxy`. It rises by at most
///   the patch's highest corner over `f(p)` as well. In each quarter of the square, which lies in
///   one patch, `A` is greatest and `f(p)` least at corners. So the lesser of both bounds is found
///   for each quarter. `-Dxy` is greatest at a corner of the two boxes, and the distance is at
///   least the distance of the boxes.
///
/// For the four patches around the centre, which hold the apexes, the last bound is refined: see
/// the module `own`. So no relaxed cone is narrower than the cone of `cone` from the same apexes,
/// and none is wider than the supremum allows. Where a patch falls in part only, the relaxed cone
/// is somewhere between the two. Maps so much longer than wide that thousands of images are near
/// get the cones of `cone`.
///
/// # Errors
///
/// When it is cancelled.
pub fn relaxed_cone_ratios(
    map: &HeightMap,
    metric: &Metric,
    apex: RelaxedApex,
    watch: &Watch,
) -> Result<Vec<f32>, Cancelled> {
    let region = match apex {
        RelaxedApex::Centre => Region::Centre,
        RelaxedApex::Footprint => Region::Footprint,
    };
    let texel_m = metric.texel_m(map);
    let search = Search::new(map, texel_m, region);
    match Relaxed::new(map, texel_m) {
        Some(relaxed) => search.ratios(&relaxed, watch),
        // A ray leaves a cone that holds no surface after no entry at all. For such a cone, the
        // nearest images suffice.
        None => search.ratios(&Empty, watch),
    }
}

fn bake(
    source: &BakeInput,
    settings: &Settings,
    watch: &Watch,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    let (apex, bits) = (RelaxedApex::ALL[settings.count(0) as usize], settings.count(1));
    let ratios = relaxed_cone_ratios(source.map, &source.metric, apex, watch)?;
    texture(&source.metric, source.map, "relaxed_cone", ratios, bits, sink)
}
