//! The quadrant frustum map: for every dual cell the widest empty frustum in each of four
//! quadrants.
//!
//! Published here first. It stands between pyramids (boxes of empty space; Tevs, Ihrke and Seidel
//! 2008) and cone maps (Dummer 2006). A frustum is as wide as a cone, and depends on the direction
//! by its quadrant. Its step takes one division an axis.
//!
//! # What is stored
//!
//! For dual cell `c = (i, j)`, the map holds its *top* `z`, the greatest of its four heights. For
//! each quadrant it holds the *least slope* `S ≥ 0`, in heights a texel, such that over all of the
//! quadrant the surface `f` is
//!
//! ```text
//! f(x, y) ≤ z + S d(x, y),   d = max(distance of x from the cell's columns, distance of y from its rows)
//! ```
//!
//! in texels. The quadrant that goes forward along both axes is `x ≥ i, y ≥ j`; backward along `x`
//! it is `x ≤ i + 1`. A ray that is somewhere over the cell stays in the quadrant of its direction.
//! Along an axis on which it does not move, either side will do. Metres do not appear: the map is
//! valid in any metric.
//!
//! # How a ray uses it
//!
//! While the ray is over the cell and above `z`, it is above the surface. Where it sinks below `z`
//! there, the cell's patch is solved. Otherwise let its height be `h0 + h1 t`, let it move `v`
//! texels along an axis a unit of `t`, and leave the cell along that axis at `t_v`. It is above the
//! surface as far as it is above `z + S d`: until the least, over the axes, of
//!
//! ```text
//! t = (h0 - z + S |v| t_v) / (S |v| - h1)
//! ```
//!
//! An axis whose denominator is not positive sets no limit. For `d` is the greatest `|v| (t - t_v)`
//! of the axes along which the ray has left the cell. This `d` is convex in `t`, and the ray is
//! linear (or bends down). So the gap is concave and does not close before. For a ray that bends
//! up, with `h2 t²`, the limit is the first root of each axis' quadratic.
//!
//! # Guarantee
//!
//! *The inequality holds everywhere on the bilinear surface, in any wrap, for the values stored. In
//! floats, `S` exceeds the least such slope by less than 2⁻¹⁶ of it, and two of its last bits; in
//! `bits`, by a step more.*
//!
//! Proof, for the quadrant forward along both axes; the others are its mirror images. Let `p, q`
//! count columns and rows of texels from the cell's near corner, `d(p, q) = max(p, q, 1) - 1`, and
//! call `h - z ≤ S d` the demand of a texel.
//!
//! 1. *Off the diagonal.* Over the cell `[p, p+1] x [q, q+1]` with `p > q`, `d` is `x - i - 1`, and
//!    with `p < q` it is `y - j - 1`: linear over the cell. `f - z - S d` is then bilinear, so it
//!    is greatest at a corner. It is nowhere positive just when the corners' demands are met.
//! 2. *On the diagonal*, over `[k, k+1]²` with `k ≥ 1`, `d = k - 1 + max(u, v)` with `u, v` in
//!    `[0, 1]` is not bilinear, and corners are not enough. The patch through corners that just
//!    meet their demands can exceed it by `S/4`. On the triangle `u ≥ v`, `d` is linear, and
//!    `f - z - S d` is `α + β u + γ v + δ u v`. Its second derivatives have the determinant
//!    `-δ² ≤ 0`: it has no maximum inside, so it is greatest on an edge. Along the two outer edges
//!    it is linear, so the corners' demands settle them. Along `u = v` it is a quadratic. The least
//!    `S` for which this quadratic is nowhere positive has a closed form: see `diagonal.rs`. The
//!    triangle `u ≤ v` shares that edge. So these two kinds of demand together are met just when
//!    the surface is below the frustum.
//! 3. *The cell itself.* Over it `d` is 0 and `f ≤ z`, as for every patch (see the kind `pyramid`).
//! 4. *The quadrant is infinite, but its nearest images suffice.* The surface is the same at a
//!    point and at its images. Under `repeat`, images are moved by whole tiles along either axis.
//!    Under `mirror`, they are also mirrored at the tiles' edges. Under `clamp`, points beyond the
//!    outermost texels are images moved along the axis. Each move is independent for the two axes,
//!    and `d` does not fall as a point moves away along one. So of the images of a point that lie
//!    in the quadrant, the one nearest along both axes has the least `d`. Where `f ≤ z + S d` holds
//!    there, it holds at all images, as `S ≥ 0`. Under `repeat` the nearest images lie in
//!    `[i, i + W] x [j, j + H]`. Under `mirror` they lie in `[i, 2W - 1]` along `x`, which holds
//!    every column ahead and then the columns behind, mirrored. Under `clamp` they lie in
//!    `[i, W - 1]`; rows likewise. Only the demands of the texels and the diagonal cells in these
//!    ranges are searched.
//! 5. *Squares.* Most slopes are found by the greatest heights of squares that grow;
//!    `growing_squares.rs` explains why they require the same slope. The others are searched in a
//!    pyramid of maxima.
//! 6. *Rounding.* A corner's demand is a difference and a quotient in `f64`, below the true one by
//!    less than 2⁻⁵¹ of it; a diagonal's is never below the true one. The greatest is raised by
//!    2⁻⁵⁰ of it and rounded up to `f32`. A square is skipped only where its bound is below the
//!    slope so far by more than the rounding of the comparison. The same holds for a node of the
//!    pyramid. A node is also skipped where, without any rounding, a hull or a plane above it is
//!    not above the frustum found. So the result is the greatest of all demands, with one
//!    exception: nodes whose hull or plane is above that frustum, but not above one steeper by
//!    2⁻¹⁶. Where the search skipped such a node it raises the slope by this amount. Heights and
//!    tops are not rounded. With `bits`, heights are decoded from that many bits first, so the top
//!    is stored exactly. Slopes are rounded up, to steps of a power of two over `2^bits - 1`.
//!
//! [`FrustumMap::at`] returns the half cells before texel 0 of a clamped or mirrored map, and all
//! cells outside. The proof is there.

mod ahead;
mod diagonal;
mod growing_squares;
mod least_slopes;
mod map;
mod rounding;

use std::sync::LazyLock;

use rayon::prelude::*;
use relief_core::registry::{Param, Publication};
use relief_core::{Cancelled, HeightMap, MaxPyramid, Rounding, Watch};

use self::growing_squares::slopes_by_squares;
use self::least_slopes::{Nodes, least_slopes};
use super::{BITS, Kind, Reach};
use crate::{BakeError, BakeInput, Channel, Settings, Shape, Sink, Texture, quantise};

pub use map::{Frustum, FrustumMap, FrustumMapError, quadrant};

/// The kind `frustum`.
pub const KIND: Kind = Kind {
    name: "frustum",
    summary: "for every dual cell its top, and in each quadrant the least slope of an empty frustum on it",
    revision: 3,
    publication: Publication { paper: "Relief", section: "kind `frustum`" },
    params: PARAMS,
    guarantee: "In each quadrant the bilinear surface is nowhere above top + slope * Chebyshev distance from \
        the cell, in texels; the stored slope is the least such, at most 2^-16 of it more, rounded up.",
    is_picture: false,
    of_volume: false,
    shapes: |size, _| vec![Shape::slices("top", size, 1, 1), Shape::slices("slopes", size, 1, 4)],
    reach: |_| Reach::Everything,
    working_maps: |_| super::WORKING_MAPS,
    bake,
};

/// Index of the parameter `bits`.
const BITS_PLACE: usize = 0;

const PARAMS: &[Param] = &[BITS];

/// Quadrants in the order of the channels: whether they go forward along `u` and `v`.
const QUADRANTS: [[bool; 2]; 4] = [[true, true], [false, true], [true, false], [false, false]];

/// Computes the frustum map of a height map. It is valid in any metric: tops are in heights, slopes
/// in heights per texel.
///
/// It takes five times the memory of the height map, and 4/3 more during the bake.
///
/// # Errors
///
/// When it is cancelled.
pub fn frustum_map(map: &HeightMap, watch: &Watch) -> Result<FrustumMap, Cancelled> {
    let top = MaxPyramid::watched(map, &watch.piece(0.0, 0.02))?.nodes(0).to_vec();
    let found = slopes_by_squares(map, &top, QUADRANTS, &watch.piece(0.02, 0.5))?;
    let nodes = LazyLock::new(|| Nodes::new(map));
    let mut slopes = [const { Vec::new() }; 4];
    for (place, (slopes, found)) in slopes.iter_mut().zip(found).enumerate() {
        let part = |place: usize| 0.5 + 0.125 * place as f32;
        let watch = watch.piece(part(place), part(place + 1));
        *slopes = if found.patience.is_empty() {
            found.slopes
        } else {
            least_slopes(map, &top, &nodes, QUADRANTS[place], found, &watch)?
        };
    }
    Ok(FrustumMap::of_map(map, top, slopes))
}

fn bake(
    source: &BakeInput,
    settings: &Settings,
    watch: &Watch,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    let bits = settings.count(BITS_PLACE);
    let (top, mut slopes) = frustum_map(source.map, watch)?.into_planes();
    let steepest = slopes.iter().flatten().copied().fold(0.0, f32::max);
    let range = range_for(steepest);
    if bits > 0 {
        for plane in &mut slopes {
            plane.par_iter_mut().for_each(|slope| {
                *slope = quantise::unorm(*slope / range, bits, Rounding::Up) * range;
            });
        }
    }
    let size = [source.map.width(), source.map.height(), 1];
    let texels = "dual cells: texel (i, j) lies between the heights (i, j) and (i + 1, j + 1)".to_owned();
    sink.begin(&Texture {
        name: "top",
        size,
        mips: Vec::new(),
        channels: vec![Channel { name: "top", unit: "heights", range: [0.0, 1.0], rounding: Rounding::Up }],
        notes: vec![("texels", texels.clone())],
    })?;
    sink.slice(&[&top])?;
    let channel = |name| Channel { name, unit: "heights/texel", range: [0.0, range], rounding: Rounding::Up };
    sink.begin(&Texture {
        name: "slopes",
        size,
        mips: Vec::new(),
        channels: ["right_down", "left_down", "right_up", "left_up"].map(channel).to_vec(),
        notes: vec![
            ("texels", texels),
            ("slopes", "heights a texel, in the quadrant toward that side".to_owned()),
        ],
    })?;
    sink.slice(&slopes.each_ref().map(Vec::as_slice))?;
    Ok(())
}

/// Returns the least power of two that is not below the steepest slope; 1 without a slope. Dividing
/// by it and multiplying again is exact, so values rounded to the safe side stay there.
fn range_for(steepest: f32) -> f32 {
    let mut range = 2.0;
    while range * 0.5 >= steepest && range > f32::MIN_POSITIVE {
        range *= 0.5;
    }
    if steepest > 0.0 { range } else { 1.0 }
}
