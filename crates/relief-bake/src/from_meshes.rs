//! The difference between two meshes: heights that displace a simple mesh onto a detailed one.
//!
//! Source: Szirmay-Kalos and Umenhoffer 2008, section 2.2, which names what surface simplification leaves out
//! as a way to height maps. The map holds all that the simple mesh lacks, its facets too, as Gumhold and
//! Hüttner 1999, section 5, correct a map for the difference between a mesh and a perfect cylinder.
//!
//! # What is computed
//!
//! The centre of a texel lies on a triangle of the simple mesh, by the texture coordinates. There the base
//! point and the normal are interpolated and *not* normalised, just as
//! [`BasePoint`](relief_core::mesh::BasePoint) does, which displaced meshes and their judge are made of.
//! Along that line, outward and inward, lies the detailed mesh: the height is the displacement that takes the
//! base point there. Lines are intersected in `f64` and slip through no edge ([`RayCaster`]).
//!
//! # Which of several hits
//!
//! * Hits farther than [`MeshPair::cage_m`] do not count, in metres along the line.
//! * Only faces count that look the way of the normal, by the turn of their corners. So a thin part of a
//!   closed mesh is met on its own side: the nearest face of all would often be the back of it. Meshes that
//!   are wound the other way round, or open sheets seen from both sides, need [`MeshPair::two_sided`]; how
//!   many texels met nothing but backs is counted.
//! * Of those the nearest counts, outward or inward. Where layers lie over one another (a strap on a
//!   shoulder), [`Layer::Outermost`] takes the one that is seen from outside: the farthest outward, and the
//!   nearest inward where there is none. That wants a cage narrower than the gaps between parts that do
//!   not belong together, as between an arm and the body.
//!
//! # Between and beside the texels
//!
//! A texel that lies on no triangle but less than one and a half texels beside one is read where the
//! surface is interpolated near the border of a chart. It gets the height that goes on in a straight line
//! from two points inside of the chart, on the way from the texel's centre over the nearest point of the
//! border, or in a plane where that way leaves the chart at a sharp corner. So the interpolated surface is
//! right at the border, to the second order of a texel. No line is cast outside of the chart: beside a hard
//! edge it would hit the sides of what lies beyond. All other texels are filled from coarse to fine, and so
//! are holes, where no line found anything.
//!
//! # Accuracy
//!
//! At the centres of texels heights are those of the flat triangles of the detailed mesh, to the `f32` that
//! they are stored in. Between them the displaced surface is bilinear: details finer than a texel are
//! sampled, not averaged. A simple mesh displaced by its map lies within half a texel of the detailed one on
//! 98 % of the texels of a coarse control cage, and on all of them where normals of a triangle are less than
//! some 60° apart.

mod charts;
mod error;
mod gutter;
mod look;
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
use self::look::{Line, Seen};
pub use self::normals::normals_from_meshes;
use crate::fill::fill;

/// How far is looked unless something else is asked for, as a part of the diagonal of the simple mesh's box.
const CAGE_PART: f64 = 0.1;

/// Heights are 0 within this part of the greatest length in play: rounding of the intersection.
const ROUNDING: f64 = 1e-13;

/// The parts of the work: finding charts, casting lines, filling.
const CHARTED: f32 = 0.15;
const CAST: f32 = 0.95;

/// Which of several layers of the detailed mesh counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Layer {
    /// The one nearest to the simple mesh.
    #[default]
    Nearest,
    /// The one farthest outward, which is seen from outside.
    Outermost,
}

impl Layer {
    /// Every layer.
    pub const ALL: [Layer; 2] = [Layer::Nearest, Layer::Outermost];

    /// The name used on the command line.
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

/// How heights are found between two meshes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshPair {
    /// Columns and rows of the map.
    pub size: [u32; 2],
    /// How the map goes on beyond its edges, and where triangles lie that reach beyond them.
    pub wrap: Wrap,
    /// The farthest that is looked to either side, in metres. None: a tenth of the diagonal of the simple
    /// mesh's box.
    pub cage_m: Option<f64>,
    /// Which of several layers counts.
    pub layer: Layer,
    /// Whether faces count that look the other way, too.
    pub two_sided: bool,
    /// Texels farther than so many beside those that are read on the charts have no value: NaN. None: all
    /// have one.
    pub gutter: Option<u32>,
}

impl MeshPair {
    /// The most memory that a texel takes, in bytes, with what is made.
    pub const BYTES_PER_TEXEL: u64 = 48;

    /// The usual ones for a map of that size: tiled, the nearest layer, faces that look outward.
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
    /// Displacements along the interpolated normals in metres, row by row from the top. NaN beyond the
    /// gutter, and nowhere without one.
    pub metres: Vec<f32>,
    /// How far was looked, in metres.
    pub cage_m: f64,
    /// Texels whose centres lie on the simple mesh.
    pub covered: u64,
    /// Those of them where nothing was found, which are filled from their surroundings.
    pub holes: u64,
    /// Those of the holes where only faces lay that look the other way.
    pub behind: u64,
    /// Texels that lie on several triangles at different places. The map has the heights of the triangle with
    /// the lowest number there.
    pub overlaps: u64,
    /// Triangles of the simple mesh without an area in the texture, on which no texel lies.
    pub without_area: u64,
    /// Texels without a value, beyond the gutter.
    pub without_value: u64,
    /// The least and the greatest height that was found on the charts, in metres.
    pub range_m: [f64; 2],
    /// The mean of the absolute heights that were found on the charts, in metres.
    pub mean_abs_m: f64,
}

impl PairedHeights {
    /// The displacement of texels 0 and 1, in metres: the least and the greatest of all heights, gutters too.
    pub fn displacement_m(&self) -> [f64; 2] {
        let valued = self.metres.iter().filter(|metres| !metres.is_nan()).map(|&metres| f64::from(metres));
        valued.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], m| [low.min(m), high.max(m)])
    }

    /// The texels from 0 to 1 between [`displacement_m`](Self::displacement_m), NaN where there is no value.
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

    /// The height map, with its displacement in metres.
    ///
    /// # Errors
    ///
    /// When texels have no value.
    pub fn to_map(&self, wrap: Wrap) -> Result<HeightMap, HeightMapError> {
        HeightMap::new(self.size[0], self.size[1], self.texels(), wrap)?
            .with_stated_displacement_m(self.displacement_m())
    }
}

/// The heights that take a simple mesh to a detailed one.
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
/// The same bytes come of any number of threads. Memory: [`MeshPair::BYTES_PER_TEXEL`] a texel.
///
/// # Errors
///
/// When the size is none of a height map, a mesh has no triangles, the cage is no length, texture coordinates
/// lie outside of a clamped map or a triangle over many tiles, no texel lies on the simple mesh, no line
/// finds the detailed one, or it is cancelled.
pub fn heights_from_meshes(
    low: &Mesh,
    high: &RayCaster,
    pair: &MeshPair,
    watch: &Watch,
) -> Result<PairedHeights, FromMeshesError> {
    let (charts, line) = prepare(low, high, pair, &watch.piece(0.0, CHARTED))?;
    let cage_m = line.cage_m;
    let texels = cast(low, &charts, &line, &watch.piece(CHARTED, CAST))?;
    let found = Found::of(&charts, &texels);
    if found.heights == 0 {
        let Found { holes: texels, behind, .. } = found;
        return Err(FromMeshesError::NothingFound { texels, cage_m, behind });
    }
    let (mut metres, known): (Vec<f32>, Vec<bool>) = texels
        .iter()
        .map(|seen| if let Seen::At(metres) = *seen { (metres as f32, true) } else { (0.0, false) })
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
        covered: found.heights + found.holes,
        holes: found.holes,
        behind: found.behind,
        overlaps: charts.overlaps,
        without_area: charts.without_area,
        without_value,
        range_m: found.range_m,
        mean_abs_m: found.sum_abs_m / found.heights as f64,
    })
}

/// The charts of the simple mesh, and how lines are looked along.
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

/// The diagonal of the box around a mesh, and the greatest of it and the coordinates, in metres.
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

/// What the lines through all texels see, row by row.
fn cast(low: &Mesh, charts: &Charts, line: &Line, watch: &Watch) -> Result<Vec<Seen>, FromMeshesError> {
    let width = charts.size[0] as usize;
    let rows = charts.owners.len() / width;
    let mut texels = vec![Seen::Nothing; charts.owners.len()];
    let done = AtomicUsize::new(0);
    texels.par_chunks_mut(width).zip(charts.owners.par_chunks(width)).try_for_each(|(row, owners)| {
        for (texel, owner) in row.iter_mut().zip(owners) {
            if let Some(owner) = owner.on() {
                *texel = if owner.is_inside() {
                    line.look(&charts.base(low, owner.triangle, owner.centre()))
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

/// What a texel beside a chart gets: the straight line through the heights at two points inside.
fn beside(low: &Mesh, charts: &Charts, line: &Line, owner: &Owner) -> Seen {
    let border = charts.nearest(low, owner);
    let distance = f64::from(owner.distance);
    let look = |beyond: f64| {
        let base = charts.base_at(low, owner, owner.inside(border, beyond));
        base.map_or(Seen::Nothing, |base| line.look(&base))
    };
    let (near, far) = (OFF_BORDER, distance.max(0.5));
    match (look(near), look(far)) {
        (Seen::At(at_near), Seen::At(at_far)) => {
            let slope = (at_near - at_far) / (far - near);
            Seen::At(at_near + slope * (distance + near))
        }
        (at_near, at_far) => match of_plane(low, charts, line, owner, border) {
            Seen::At(metres) => Seen::At(metres),
            _ => [at_near, at_far]
                .into_iter()
                .find(|seen| matches!(seen, Seen::At(_)))
                .unwrap_or(Seen::Nothing),
        },
    }
}

/// The same at a sharp corner, where no straight line goes on inside: the plane through the heights at three
/// points of the triangle, near its corner but not on its border.
fn of_plane(low: &Mesh, charts: &Charts, line: &Line, owner: &Owner, border: [f64; 2]) -> Seen {
    let Some((points, weights)) = charts.around(low, owner, border) else { return Seen::Nothing };
    let mut height = 0.0;
    for (point, weight) in points.into_iter().zip(weights) {
        match line.look(&charts.base(low, owner.triangle, point)) {
            Seen::At(metres) => height += weight * metres,
            other => return other,
        }
    }
    Seen::At(height)
}

/// What was found on the charts.
struct Found {
    heights: u64,
    holes: u64,
    behind: u64,
    range_m: [f64; 2],
    sum_abs_m: f64,
}

impl Found {
    fn of(charts: &Charts, texels: &[Seen]) -> Self {
        let range_m = [f64::INFINITY, f64::NEG_INFINITY];
        let mut found = Self { heights: 0, holes: 0, behind: 0, range_m, sum_abs_m: 0.0 };
        for (owner, seen) in charts.owners.iter().zip(texels) {
            if !owner.is_inside() {
                continue;
            }
            match *seen {
                Seen::At(metres) => {
                    found.heights += 1;
                    let [low, high] = found.range_m;
                    found.range_m = [low.min(metres), high.max(metres)];
                    found.sum_abs_m += metres.abs();
                }
                Seen::Behind => {
                    found.holes += 1;
                    found.behind += 1;
                }
                Seen::Nothing => found.holes += 1,
            }
        }
        found
    }
}

#[cfg(test)]
mod tests;
