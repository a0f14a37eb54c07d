//! Cone maps: the widest empty cone over every texel.
//!
//! * Dummer, *Cone Step Mapping: An Iterative Ray-Heightfield Intersection Algorithm*, 2006.
//! * Szirmay-Kalos and Umenhoffer, *Displacement Mapping on the GPU: State of the Art*, 2008,
//!   section 4.3.5.
//!
//! Published cone maps bound the texels, not the bilinear surface between them. They are made for
//! texel centres, but searches move them to the ray. The cones here hold nothing of the bilinear
//! surface. The default ones are as wide as possible and stay at the centre. A search that leaves
//! them there, as the search of the shaders does, misses nothing. Other cones may be moved. These,
//! and the way all of them are found, are Relief's own.

use rayon::prelude::*;
use relief_core::registry::{Param, Publication};
use relief_core::{Cancelled, HeightMap, Metric, Watch};

use super::{BITS, Kind, Reach};
use crate::cone_search::{Empty, Region, Search, texture};
use crate::{BakeError, BakeInput, Settings, Shape, Sink};

/// Places from which the cones of a map are safe.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConeApex {
    /// From the surface at the texel's centre, as published. These cones are for searches that
    /// leave the cone there, wherever in the texel the ray is. Moved to the ray, the cone would cut
    /// the surface. Such a search misses nothing: in the cone a ray meets no surface. Where the ray
    /// is outside of its texel's cone, the texel's own patches are solved, as the shaders' search
    /// `cone` does. It takes a half to two thirds of the steps of a search that moves the apex.
    Centre,
    /// From the surface at any place of the texel's square: for searches that move the apex to the
    /// ray and fetch the nearest texel. No wider cones are safe for these. They are narrower than
    /// cones from the centres: on natural ground by a tenth, where walls are a texel wide by up to
    /// a third.
    Footprint,
    /// From the surface at any place of the squares of the texel and its eight neighbours: for
    /// searches that move the apex and fetch through a bilinear filter.
    Filtered,
}

impl ConeApex {
    /// Every choice, in the order of the parameter's numbers.
    pub const ALL: [ConeApex; 3] = [ConeApex::Centre, ConeApex::Footprint, ConeApex::Filtered];
}

const APEX: Param = Param {
    name: "apex",
    summary: "0 for searches that leave the cone on the texel; for those that move it to the ray 1, through \
              a bilinear filter 2",
    unit: "",
    min: 0.0,
    max: 2.0,
    default: 0.0,
    integer: true,
    names: &[],
};

/// The kind `cone`.
pub const KIND: Kind = Kind {
    name: "cone",
    summary: "the widest cone that stands on a texel and holds no surface",
    revision: 3,
    publication: Publication {
        paper: "Szirmay-Kalos and Umenhoffer 2008, Displacement Mapping on the GPU",
        section: "4.3.5",
    },
    params: &[APEX, BITS],
    guarantee: "for every point p of the surface in the texel's square (apex 0: at its centre) and every \
        point q of it, q rises over p by at most their horizontal distance over the ratio; with apex 2 the \
        same holds at every p for the stored values as a bilinear filter reads them there",
    is_picture: false,
    of_volume: false,
    shapes: |size, _| vec![Shape::slices("", size, 1, 1)],
    reach: |_| Reach::Everything,
    working_maps: |_| super::WORKING_MAPS,
    bake,
};

/// Returns the cone ratio of every texel, row by row: metres from the axis for a texel height of 1
/// above the apex.
///
/// Metres are measured in `metric.tile_m`. A height of 1 is the whole relief whatever
/// `metric.scale_m` is, so the ratio stays valid when the scale changes. It is finite and not
/// negative, and may exceed 1. Over peaks, where nothing limits the cone, it exceeds 1e12 texels.
///
/// # Guarantee
///
/// For every point `p` of the bilinear surface `f` over the apexes of a texel and every other point
/// `q`, also outside of the map, `f(q) - f(p) ≤ |q - p| / ratio`, with `|q - p|` in metres. With
/// [`ConeApex::Footprint`] the apexes of texel `(i, j)` are the closed square
/// `[i, i + 1] x [j, j + 1]` in texture coordinates times size. There, a fetch of the nearest texel
/// returns it; on a border between squares both texels' cones are safe. With [`ConeApex::Centre`]
/// the only apex is the centre. The ratio is the supremum less three small amounts: 2⁻¹⁶ of it,
/// 1e-6 of it, and the effect of adding 2⁻²³ of a height over a texel's shorter side to the slope.
/// But for these no wider cone is safe.
///
/// [`ConeApex::Filtered`] is the least ratio of [`ConeApex::Footprint`] in the 3 by 3 texels
/// around. At a place of a texel's square, a filter mixes four texels, and each has that texel
/// among its 3 by 3. So each of the four values is safe there, and so is any mean of them, or of an
/// increasing function of them. Filtering the ratios of [`ConeApex::Centre`] is not safe, whatever
/// function of them is filtered. For [`ConeApex::Footprint`] nothing is proven.
///
/// # Proof
///
/// Let `R` be the square and `p` a point of it.
///
/// 1. *`p` is on the rim.* The mean slope from `p` to `q` is a mean of the mean slopes before and
///    behind the point at which the segment leaves `R`. The first is at most the greatest `|∇f|` in
///    `R`. The square of `|∇f|` is convex in each of the four patches, so it is greatest at a
///    corner of the patch's part in `R`. So `p` may be taken on the rim.
/// 2. *`p` is one of eight ends, or `q` is a vertex.* The rim has eight pieces that lie within one
///    patch each. Move `p` along one of them, say along `y`, and `q` with it. `f(p)` is linear,
///    `f(q)` is linear while `q` stays between two lines of vertices, and their distance is fixed.
///    So the slope is greatest where `p` is an end of its piece or `q` is on an edge along `x`. On
///    the edge the rise is affine in `q.x` and `p.y`, and the distance is a norm of
///    `(q.x - p.x, q.y - p.y)`. The slope is stationary inside only where the rise is linear in
///    that vector; then it is the same towards the rim of the domain.
/// 3. *Closed forms.* From an end the supremum over a cell is at a vertex, on an edge, or at a
///    stationary point inside. For a vertex it is inside a piece of the rim, or at its end. All
///    have closed forms.
/// 4. *Skipped nodes.* A node of the maximum pyramid is skipped in two cases only. First, its
///    highest point is placed over the lowest apex at their least distance. The resulting slope is
///    below the best slope by more than a cell can exceed its corners. Second, a plane above the
///    node is not above a cone of the best slope, raised by the possible rounding of heights: see
///    the modules `cone_search::walk` and `tie`. All slopes are raised by the same amount in the
///    end. Otherwise, the rounding of heights would decide which of many equally steep points is
///    steepest.
/// 5. *Beyond the map.* Under repeat, all images that are near enough are visited. Under clamp and
///    mirror, folding the plane onto the map keeps heights and moves no two points farther apart,
///    so the steepest pairs are on the map itself.
///
/// # Errors
///
/// When it is cancelled.
pub fn cone_ratios(
    map: &HeightMap,
    metric: &Metric,
    apex: ConeApex,
    watch: &Watch,
) -> Result<Vec<f32>, Cancelled> {
    let region = if apex == ConeApex::Centre { Region::Centre } else { Region::Footprint };
    let search = Search::new(map, metric.texel_m(map), region);
    let ratios = search.ratios(&Empty, watch)?;
    Ok(if apex == ConeApex::Filtered { least_around(map, &ratios) } else { ratios })
}

/// Returns the least value of each texel's 3 by 3 neighbourhood.
fn least_around(map: &HeightMap, values: &[f32]) -> Vec<f32> {
    let (width, height, wrap) = (map.width(), map.height(), map.wrap());
    let mut least = vec![0.0; values.len()];
    least.par_chunks_mut(width as usize).enumerate().for_each(|(row, least)| {
        let rows = [-1, 0, 1].map(|by| wrap.index(row as i64 + by, height) as usize * width as usize);
        for (column, least) in least.iter_mut().enumerate() {
            let columns = [-1, 0, 1].map(|by| wrap.index(column as i64 + by, width) as usize);
            let around = rows.iter().flat_map(|row| columns.iter().map(move |column| values[row + column]));
            *least = around.fold(f32::INFINITY, f32::min);
        }
    });
    least
}

fn bake(
    source: &BakeInput,
    settings: &Settings,
    watch: &Watch,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    let (apex, bits) = (ConeApex::ALL[settings.count(0) as usize], settings.count(1));
    let ratios = cone_ratios(source.map, &source.metric, apex, watch)?;
    texture(&source.metric, source.map, "cone", ratios, bits, sink)
}
