//! Difference between two meshes: heights that displace a simple mesh onto a detailed one.
//!
//! Source: Szirmay-Kalos and Umenhoffer 2008, section 2.2, which makes height maps from the details
//! that surface simplification removes. The map also corrects the facets of the simple mesh.
//! Gumhold and Hüttner 1999, section 5, correct a map in the same way for the difference between a
//! mesh and a perfect cylinder.
//!
//! # What is computed
//!
//! By its texture coordinates, the centre of a texel lies on a triangle of the simple mesh. The
//! base point and the normal are interpolated there. The normal is *not* normalised, just as in
//! [`BasePoint`](relief_core::mesh::BasePoint), from which displaced meshes and their judge are
//! computed. A line along the normal, outward and inward, is intersected with the detailed mesh.
//! The height is the displacement that takes the base point to the intersection. Lines are
//! intersected in `f64` and slip through no edge ([`RayCaster`]).
//!
//! # Which of several hits
//!
//! * Hits farther than [`MeshPair::cage_m`] along the line, in metres, do not count.
//! * Only faces turned the way of the normal count, by the order of their corners. A thin part of a
//!   closed mesh is thus hit on its own side. The nearest face of all would often be its back.
//!   Meshes wound the other way round, or open sheets seen from both sides, need
//!   [`MeshPair::two_sided`]. Texels that hit only back faces are counted.
//! * The nearest of these hits counts, outward or inward. Where layers lie over one another (a
//!   strap on a shoulder), [`Layer::Outermost`] takes the layer seen from outside. This is the
//!   farthest hit outward, or the nearest inward where there is none. It needs a cage narrower than
//!   the gaps between parts that do not belong together, such as an arm and the body.
//!
//! # Between and beside the texels
//!
//! A texel less than one and a half texels beside a triangle is read where the surface is
//! interpolated near the border of a chart. Its height continues the straight line through two
//! points inside of the chart. The points lie on the way from the texel's centre over the nearest
//! point of the border. Where that way leaves the chart at a sharp corner, the height continues a
//! plane instead. The interpolated surface is thus right at the border, to the second order of a
//! texel. No line is cast outside of the chart: beside a hard edge it would hit the sides of the
//! parts beyond. All other texels are filled from coarse to fine. Holes, where no line hit
//! anything, are filled as well.
//!
//! # Accuracy
//!
//! At the centres of texels, heights match the flat triangles of the detailed mesh to the precision
//! of the stored `f32`. Between them the displaced surface is bilinear: details finer than a texel
//! are sampled, not averaged. A simple mesh displaced by its map lies within half a texel of the
//! detailed one on 98 % of the texels of a coarse control cage. It does so on all texels where the
//! normals of a triangle are less than some 60° apart.

mod charts;
mod error;
mod gutter;
mod line;
mod normals;

use glam::DVec3;
use rayon::prelude::*;
use relief_core::mesh::Mesh;
use relief_core::raycast::RayCaster;
use relief_core::registry::UnknownName;
use relief_core::{HeightMap, HeightMapError, Watch, Wrap};
use std::fmt;
use std::str::FromStr;
use std::sync::atomic::{AtomicUsize, Ordering};

use self::charts::{Charts, OFF_BORDER, Owner};
pub use self::error::{FromMeshesError, MAX_TILES};
use self::line::{Line, LineHit};
pub use self::normals::normals_from_meshes;
use crate::fill::fill;

/// Default cage, as a part of the diagonal of the simple mesh's box.
const CAGE_PART: f64 = 0.1;

/// Heights within this part of the greatest length in play are 0: rounding of the intersection.
const ROUNDING: f64 = 1e-13;

/// Progress at the end of finding charts and of casting lines; filling follows.
const CHARTED: f32 = 0.15;
const CAST: f32 = 0.95;

/// Choice among several layers of the detailed mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Layer {
    /// The layer nearest to the simple mesh.
    #[default]
    Nearest,
    /// The layer farthest outward, which is seen from outside.
    Outermost,
}

impl Layer {
    /// Every layer.
    pub const ALL: [Layer; 2] = [Layer::Nearest, Layer::Outermost];

    /// Returns the name of this layer, as files and the command spell it: `nearest` or `outermost`.
    pub const fn name(self) -> &'static str {
        match self {
            Layer::Nearest => "nearest",
            Layer::Outermost => "outermost",
        }
    }
}

impl fmt::Display for Layer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Layer {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let known = Layer::ALL.into_iter().find(|layer| layer.name() == name);
        known.ok_or_else(|| UnknownName::new("layer", name, Layer::ALL.map(Layer::name)))
    }
}

/// Settings for heights between two meshes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshPair {
    /// Columns and rows of the map.
    pub size: [u32; 2],
    /// Continuation of the map beyond its edges, where triangles may lie, too.
    pub wrap: Wrap,
    /// Greatest distance of a hit to either side, in metres. Default: a tenth of the diagonal of
    /// the simple mesh's box.
    pub cage_m: Option<f64>,
    /// Choice among several layers.
    pub layer: Layer,
    /// Whether faces count that are turned against the normal.
    pub two_sided: bool,
    /// Width of the gutter in texels. Texels farther than this from the texels read on the charts
    /// are NaN. Default: all texels have a value.
    pub gutter: Option<u32>,
}

impl MeshPair {
    /// Most memory in bytes for a texel, with the result.
    pub const BYTES_PER_TEXEL: u64 = 48;

    /// Creates the default settings for a map of `size`: tiled, the nearest layer, faces turned
    /// outward.
    pub fn new(size: [u32; 2]) -> Self {
        let (wrap, layer) = (Wrap::default(), Layer::default());
        Self { size, wrap, cage_m: None, layer, two_sided: false, gutter: None }
    }
}

/// Heights between two meshes.
#[derive(Clone, Debug, PartialEq)]
pub struct PairedHeights {
    /// Columns and rows.
    pub size: [u32; 2],
    /// Displacements along the interpolated normals in metres, row by row from the top. NaN beyond
    /// the gutter, and nowhere without one.
    pub metres: Vec<f32>,
    /// Greatest distance of a hit, in metres.
    pub cage_m: f64,
    /// Texels whose centres lie on the simple mesh.
    pub covered: u64,
    /// Covered texels without a hit, filled from their surroundings.
    pub holes: u64,
    /// Holes whose lines hit only faces turned the other way.
    pub behind: u64,
    /// Texels that lie on several triangles at different places. They have the heights of the
    /// triangle with the lowest number.
    pub overlaps: u64,
    /// Triangles of the simple mesh without an area in the texture, on which no texel lies.
    pub without_area: u64,
    /// Texels without a value, beyond the gutter.
    pub without_value: u64,
    /// Least and greatest height found on the charts, in metres.
    pub range_m: [f64; 2],
    /// Mean of the absolute heights found on the charts, in metres.
    pub mean_abs_m: f64,
}

impl PairedHeights {
    /// Returns the displacement of texels 0 and 1, in metres: the least and the greatest of all
    /// heights, gutters included.
    pub fn displacement_m(&self) -> [f64; 2] {
        let valued = self.metres.iter().filter(|metres| !metres.is_nan()).map(|&metres| f64::from(metres));
        valued.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], m| [low.min(m), high.max(m)])
    }

    /// Returns the texels from 0 to 1 between the two ends of
    /// [`displacement_m`](Self::displacement_m). Texels without a value are NaN.
    pub fn texels(&self) -> Vec<f32> {
        let [low, high] = self.displacement_m();
        let span = high - low;
        let texel = |&metres: &f32| {
            let part = if span > 0.0 { (f64::from(metres) - low) / span } else { 0.0 };
            // NaN stays.
            if metres.is_nan() { metres } else { part.clamp(0.0, 1.0) as f32 }
        };
        self.metres.iter().map(texel).collect()
    }

    /// Returns the height map, with its displacement in metres.
    ///
    /// # Errors
    ///
    /// When texels have no value.
    pub fn to_map(&self, wrap: Wrap) -> Result<HeightMap, HeightMapError> {
        HeightMap::new(self.size[0], self.size[1], self.texels(), wrap)?
            .with_stated_displacement_m(self.displacement_m())
    }
}

/// Finds the heights that displace the simple mesh `low` onto the detailed mesh `high`.
///
/// ```
/// use relief_bake::from_meshes::{MeshPair, heights_from_meshes};
/// use relief_core::Watch;
/// use relief_core::mesh::sphere;
/// use relief_core::raycast::RayCaster;
///
/// let (low, high) = (sphere(16, 8)?, sphere(256, 128)?);
/// let pair = MeshPair::new([64, 32]);
/// let heights = heights_from_meshes(&low, &RayCaster::new(&high), &pair, &Watch::none())?;
/// // At the poles of a sphere triangles leave corners of the map bare.
/// assert_eq!((heights.covered, heights.holes), (64 * 28, 0));
/// // The facets lie inside of the sphere of half a metre, by less than 4 cm.
/// assert!(heights.range_m[0] > -1e-4 && heights.range_m[1] < 0.04);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// The result has the same bytes with any number of threads. Memory: [`MeshPair::BYTES_PER_TEXEL`]
/// for each texel.
///
/// # Errors
///
/// When the size is invalid for a height map, a mesh has no triangles, or the cage is not a finite
/// length above 0. When texture coordinates lie outside of a clamped map, a triangle spans too many
/// tiles, or no texel lies on the simple mesh. When no line hits the detailed mesh, or when it is
/// cancelled.
pub fn heights_from_meshes(
    low: &Mesh,
    high: &RayCaster,
    pair: &MeshPair,
    watch: &Watch,
) -> Result<PairedHeights, FromMeshesError> {
    let (charts, line) = prepare(low, high, pair, &watch.piece(0.0, CHARTED))?;
    let cage_m = line.cage_m;
    let texels = cast(low, &charts, &line, &watch.piece(CHARTED, CAST))?;
    let stats = HeightStats::of(&charts, &texels);
    if stats.heights == 0 {
        let HeightStats { holes: texels, behind, .. } = stats;
        return Err(FromMeshesError::NothingFound { texels, cage_m, behind });
    }
    let (mut metres, known): (Vec<f32>, Vec<bool>) = texels
        .iter()
        .map(|hit| if let LineHit::At(metres) = *hit { (metres as f32, true) } else { (0.0, false) })
        .unzip();
    drop(texels);
    fill(pair.size.map(|side| side as usize), &mut metres, &known);
    let without_value = match pair.gutter {
        Some(gutter) => gutter::leave_out(&mut metres, &charts, gutter),
        None => 0,
    };
    watch.at(1.0)?;
    Ok(PairedHeights {
        size: pair.size,
        metres,
        cage_m,
        covered: stats.heights + stats.holes,
        holes: stats.holes,
        behind: stats.behind,
        overlaps: charts.overlaps,
        without_area: charts.without_area,
        without_value,
        range_m: stats.range_m,
        mean_abs_m: stats.sum_abs_m / stats.heights as f64,
    })
}

/// Returns the charts of the simple mesh, and the settings of the lines.
fn prepare<'a>(
    low: &Mesh,
    high: &'a RayCaster,
    pair: &MeshPair,
    watch: &Watch,
) -> Result<(Charts, Line<'a>), FromMeshesError> {
    HeightMap::check_size(pair.size[0], pair.size[1])?;
    if low.triangles().is_empty() {
        return Err(FromMeshesError::NothingToLieOn);
    }
    if high.triangles() == 0 {
        return Err(FromMeshesError::NothingToFind);
    }
    let (diagonal, farthest) = extents_m(low);
    let cage_m = pair.cage_m.unwrap_or(CAGE_PART * diagonal);
    if pair.cage_m.is_some() && !(cage_m > 0.0 && cage_m.is_finite()) {
        return Err(FromMeshesError::BadCage(cage_m));
    }
    let charts = Charts::new(low, pair, diagonal, watch)?;
    let (layer, two_sided) = (pair.layer, pair.two_sided);
    Ok((charts, Line { high, cage_m, layer, two_sided, rounding: ROUNDING * farthest }))
}

/// Returns the diagonal of the box around a mesh, and the greatest of this and the coordinates, in
/// metres.
fn extents_m(mesh: &Mesh) -> (f64, f64) {
    let used = mesh.triangles().iter().flatten();
    let bounds = used.fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], &index| {
        let at = mesh.vertices()[index as usize].position.as_dvec3();
        [low.min(at), high.max(at)]
    });
    let diagonal = (bounds[1] - bounds[0]).length();
    let farthest = bounds.iter().fold(diagonal, |farthest, corner| farthest.max(corner.abs().max_element()));
    (diagonal, farthest)
}

/// Casts the lines through all texels, row by row.
fn cast(low: &Mesh, charts: &Charts, line: &Line, watch: &Watch) -> Result<Vec<LineHit>, FromMeshesError> {
    let width = charts.size[0] as usize;
    let rows = charts.owners.len() / width;
    let mut texels = vec![LineHit::Miss; charts.owners.len()];
    let done = AtomicUsize::new(0);
    texels.par_chunks_mut(width).zip(charts.owners.par_chunks(width)).try_for_each(|(row, owners)| {
        for (texel, owner) in row.iter_mut().zip(owners) {
            if let Some(owner) = owner.on() {
                *texel = if owner.is_inside() {
                    line.cast(&charts.base(low, owner.triangle, owner.centre()))
                } else {
                    beside(low, charts, line, owner)
                };
            }
        }
        let done = done.fetch_add(1, Ordering::Relaxed) + 1;
        watch.at(done as f32 / rows as f32)
    })?;
    Ok(texels)
}

/// Height of a texel beside a chart: the straight line through the heights at two points inside.
fn beside(low: &Mesh, charts: &Charts, line: &Line, owner: &Owner) -> LineHit {
    let border = charts.nearest(low, owner);
    let distance = f64::from(owner.distance);
    let cast = |beyond: f64| {
        let base = charts.base_at(low, owner, owner.inside(border, beyond));
        base.map_or(LineHit::Miss, |base| line.cast(&base))
    };
    let (near, far) = (OFF_BORDER, distance.max(0.5));
    match (cast(near), cast(far)) {
        (LineHit::At(at_near), LineHit::At(at_far)) => {
            let slope = (at_near - at_far) / (far - near);
            LineHit::At(at_near + slope * (distance + near))
        }
        (at_near, at_far) => match of_plane(low, charts, line, owner, border) {
            LineHit::At(metres) => LineHit::At(metres),
            _ => [at_near, at_far]
                .into_iter()
                .find(|hit| matches!(hit, LineHit::At(_)))
                .unwrap_or(LineHit::Miss),
        },
    }
}

/// Height of a texel beside a sharp corner, where no straight line continues inside. It continues
/// the plane through the heights at three points of the triangle, near its corner but not on its
/// border.
fn of_plane(low: &Mesh, charts: &Charts, line: &Line, owner: &Owner, border: [f64; 2]) -> LineHit {
    let Some((points, weights)) = charts.around(low, owner, border) else { return LineHit::Miss };
    let mut height = 0.0;
    for (point, weight) in points.into_iter().zip(weights) {
        match line.cast(&charts.base(low, owner.triangle, point)) {
            LineHit::At(metres) => height += weight * metres,
            other => return other,
        }
    }
    LineHit::At(height)
}

/// Statistics of the heights on the charts.
struct HeightStats {
    heights: u64,
    holes: u64,
    behind: u64,
    range_m: [f64; 2],
    sum_abs_m: f64,
}

impl HeightStats {
    fn of(charts: &Charts, texels: &[LineHit]) -> Self {
        let range_m = [f64::INFINITY, f64::NEG_INFINITY];
        let mut stats = Self { heights: 0, holes: 0, behind: 0, range_m, sum_abs_m: 0.0 };
        for (owner, hit) in charts.owners.iter().zip(texels) {
            if !owner.is_inside() {
                continue;
            }
            match *hit {
                LineHit::At(metres) => {
                    stats.heights += 1;
                    let [low, high] = stats.range_m;
                    stats.range_m = [low.min(metres), high.max(metres)];
                    stats.sum_abs_m += metres.abs();
                }
                LineHit::BackFace => {
                    stats.holes += 1;
                    stats.behind += 1;
                }
                LineHit::Miss => stats.holes += 1,
            }
        }
        stats
    }
}

#[cfg(test)]
mod tests;
