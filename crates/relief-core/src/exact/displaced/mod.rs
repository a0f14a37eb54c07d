//! The exact first hit of a displaced mesh: the judge of methods for curved surfaces.
//!
//! Nothing is tessellated. The shell over a base triangle is halved until its parts are decided, each bounded
//! by a convex hull that holds the sheet: see `shell.rs` and `bezier.rs` for why it does.

mod bezier;
mod clearance;
mod hierarchy;
mod hull;
mod ray_space;
mod relief;
mod search;
mod shell;

use crate::HeightMap;
use crate::exact::MAX_START;
use crate::mesh::{BasePoint, Mesh, Vertex};
use hierarchy::{Bounds, Hierarchy};
use ray_space::RaySpace;
use relief::Relief;
use search::{Crossing, Search};

/// A mesh that is displaced by a height map, and the exact first hit of a ray with it, in `f64`.
///
/// Over each triangle with corner positions `p_k`, normals `n_k` and texture coordinates `uv_k` the displaced
/// surface, the *sheet*, is
///
/// `X(w) = Σ w_k p_k + (bias_m + scale_m H(Σ w_k uv_k)) Σ w_k n_k`,
///
/// with barycentric weights `w_k >= 0` that add up to 1 and the bilinear height `H` of
/// [`HeightMap::height_at`]. The interpolated normal is *not* normalised; with that, neighbours that share
/// two corners share the side between them.
///
/// # Guarantee
///
/// Let the size of the scene be the diagonal of [`Self::bounds`].
///
/// * A hit lies on the sheet to rounding, and on the ray to within 2⁻⁴⁴ of the largest of its distances from
///   the triangle's corners (which is what rounding of the inputs amounts to), unless it is
///   [`grazing`](DisplacedHit::grazing): then to within [`Self::TOLERANCE`] of the scene's size.
/// * No crossing before it is passed over, however near to tangency, but for those at the same depth to
///   rounding (and at most [`Self::TOLERANCE`] of the scene's size before). What counts as a touch is a ray
///   within the same rounding of the sheet.
///
/// # Cost
///
/// [`Self::new`] builds a maximum and a minimum pyramid of the map and a hierarchy over the triangles. It
/// keeps a copy of the mesh and shares the map's texels. A ray takes some sixty nodes where it crosses a few
/// cells before its hit, and in proportion to the cells that it crosses inside shells where there are many.
///
/// # Source
///
/// Shells over triangles, whose sides neighbours share: Hirche, Ehlert, Guthe and Doggett 2004 ("Hardware
/// accelerated per-pixel displacement mapping"). Halving until a hull is missed: Lane and Riesenfeld 1980 ("A
/// theoretical development for the computer generation and display of piecewise polynomial surfaces").
///
/// ```
/// use relief_core::exact::{DisplacedMesh, Sides};
/// use relief_core::{HeightMap, Wrap, mesh};
///
/// // The unit square, raised by half of 0.2 m everywhere.
/// let map = HeightMap::from_fn(8, 8, Wrap::Repeat, |_, _| 0.5)?;
/// let displaced = DisplacedMesh::new(&mesh::square(2)?, &map, 0.2, 0.0)?;
/// let hit = displaced.first_hit([0.2, 3.0, -0.1], [0.0, -2.0, 0.0], Sides::Front).expect("a hit");
/// assert!((hit.t - 1.45).abs() < 1e-12 && hit.height == 0.5);
/// assert!((hit.uv[0] - 0.7).abs() < 1e-12 && (hit.uv[1] - 0.4).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct DisplacedMesh {
    mesh: Mesh,
    relief: Relief,
    hierarchy: Hierarchy,
}

/// Why a mesh cannot be displaced.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum DisplacedMeshError {
    /// The scale or the bias is no usable length.
    #[error("{what} is {value} m: it must be a number of at most 1e9 m")]
    BadLength {
        /// The scale or the bias.
        what: &'static str,
        /// The length given, in metres.
        value: f64,
    },
    /// Texture coordinates are too far from the origin to tell cells apart.
    #[error("triangle {triangle} lies {cells:e} cells from the origin of the texture, too far to be exact")]
    TooFar {
        /// Number of the first such triangle.
        triangle: u32,
        /// Its distance in cells along one axis.
        cells: f64,
    },
}

/// Which crossings of a sheet count.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Sides {
    /// Only those from above.
    #[default]
    Front,
    /// Those from above and from below.
    Both,
}

/// From which side a sheet is crossed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Side {
    /// From above: the ray's height over the sheet, along the interpolated normal, falls.
    Front,
    /// From below: it rises.
    Back,
}

/// Where a ray meets a displaced mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DisplacedHit {
    /// Parameter along the ray: the hit is at `origin + t * direction`. Never negative.
    pub t: f64,
    /// Number of the base triangle. A hit on a side or a corner names one of those that meet there.
    pub triangle: u32,
    /// Barycentric weights of the triangle's corners; they are in `[0, 1]` and add up to 1, both to rounding.
    pub weights: [f64; 3],
    /// Texture coordinates, not wrapped.
    pub uv: [f64; 2],
    /// Height of the map there, a texel value in `[0, 1]`.
    pub height: f64,
    /// The point of the sheet with these weights, in metres.
    pub position: [f64; 3],
    /// The side on which the sheet is crossed. A touch counts as a crossing from above.
    pub side: Side,
    /// Whether the shell is turned inside out there: displaced beyond the centre of curvature, or with
    /// normals against the winding of the triangle. The sheet's own winding then says the opposite of `side`.
    pub folded: bool,
    /// Whether ray and sheet are so nearly tangent that the crossing is not told from a touch, and is known
    /// to [`DisplacedMesh::TOLERANCE`] only.
    pub grazing: bool,
}

/// What was found along a ray, and what it took.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DisplacedTrace {
    /// The first hit; `None` for a miss.
    pub hit: Option<DisplacedHit>,
    /// How many boxes of the hierarchy and hulls of parts of shells were looked at.
    pub nodes: u64,
}

/// The largest scale and bias, in metres.
const MAX_METRES: f64 = 1e9;

impl DisplacedMesh {
    /// How large a part of a sheet may be that is no longer halved where it grazes the ray, as a part of the
    /// scene's size.
    pub const TOLERANCE: f64 = 1e-9;

    /// Displaces a mesh by a map: texel 0 by `bias_m` metres and texel 1 by `bias_m + scale_m`, times the
    /// normals' lengths. Either may be negative. The map's own lengths are not looked at.
    ///
    /// # Errors
    ///
    /// When a length is not finite or above 1e9 m, or a triangle lies [`MAX_START`] or more cells from the
    /// origin of the texture.
    pub fn new(mesh: &Mesh, map: &HeightMap, scale_m: f64, bias_m: f64) -> Result<Self, DisplacedMeshError> {
        for (what, value) in [("the scale", scale_m), ("the bias", bias_m)] {
            // NaN is not below anything.
            let fits = value.abs() <= MAX_METRES;
            if !fits {
                return Err(DisplacedMeshError::BadLength { what, value });
            }
        }
        let relief = Relief::new(map, scale_m, bias_m);
        let mut boxes = Vec::with_capacity(mesh.triangles().len());
        for triangle in 0..mesh.triangles().len() as u32 {
            boxes.push(shell_box(&relief, triangle, mesh.corners(triangle))?);
        }
        Ok(Self { mesh: mesh.clone(), relief, hierarchy: Hierarchy::new(&boxes) })
    }

    /// The box around the shells of all triangles, least and greatest corner in metres: infinitely small, the
    /// least above the greatest, for a mesh without triangles.
    pub fn bounds(&self) -> [[f64; 3]; 2] {
        let Bounds { least, greatest } = self.hierarchy.bounds();
        [least.to_array(), greatest.to_array()]
    }

    /// The first point at which a ray meets the displaced mesh on one of `sides`.
    ///
    /// `origin` is in metres; the ray is `origin + t * direction` with `t >= 0`. There is no hit when a
    /// number is NaN, infinite or beyond [`MAX_RATE`](crate::exact::MAX_RATE), or the direction is shorter
    /// than 1e-90.
    pub fn first_hit(&self, origin: [f64; 3], direction: [f64; 3], sides: Sides) -> Option<DisplacedHit> {
        self.trace(origin, direction, sides).hit
    }

    /// [`Self::first_hit`], with what it took.
    pub fn trace(&self, origin: [f64; 3], direction: [f64; 3], sides: Sides) -> DisplacedTrace {
        self.search(origin, direction, sides, |ray, search| {
            self.hierarchy.walk(ray, |triangle| {
                search.triangle(triangle, self.mesh.corners(triangle));
                search.limit()
            })
        })
    }

    /// The first point at which a ray meets the sheet over one triangle, as if there were no other. A miss
    /// when there is no such triangle.
    pub fn trace_triangle(
        &self,
        triangle: u32,
        origin: [f64; 3],
        direction: [f64; 3],
        sides: Sides,
    ) -> DisplacedTrace {
        self.search(origin, direction, sides, |_, search| {
            if (triangle as usize) < self.mesh.triangles().len() {
                search.triangle(triangle, self.mesh.corners(triangle));
            }
            0
        })
    }

    /// What a search finds; it says how many boxes it looked at.
    fn search(
        &self,
        origin: [f64; 3],
        direction: [f64; 3],
        sides: Sides,
        search_in: impl FnOnce(&RaySpace, &mut Search) -> u64,
    ) -> DisplacedTrace {
        let Some(ray) = RaySpace::new(origin, direction) else {
            return DisplacedTrace { hit: None, nodes: 0 };
        };
        let mut search = Search::new(&self.relief, &ray, sides, self.tolerance());
        let boxes = search_in(&ray, &mut search);
        let hit = search.first.map(|crossing| self.hit(&crossing, &ray));
        DisplacedTrace { hit, nodes: boxes + search.nodes }
    }

    /// The tolerance in metres.
    fn tolerance(&self) -> f64 {
        Self::TOLERANCE * self.hierarchy.bounds().diagonal()
    }

    fn hit(&self, crossing: &Crossing, ray: &RaySpace) -> DisplacedHit {
        let Crossing { depth, triangle, weights, height, side, folded, grazing } = *crossing;
        let corners = self.mesh.corners(triangle);
        let base = BasePoint::weighted(corners.map(BasePoint::from), weights.to_array());
        DisplacedHit {
            t: depth / ray.length,
            triangle,
            weights: weights.to_array(),
            uv: base.uv.to_array(),
            height: height.clamp(0.0, 1.0),
            position: base.displaced(self.relief.metres(height)).to_array(),
            side,
            folded,
            grazing,
        }
    }
}

/// The box around the shell of one triangle.
fn shell_box(relief: &Relief, triangle: u32, vertices: [&Vertex; 3]) -> Result<Bounds, DisplacedMeshError> {
    let places = vertices.map(|vertex| relief.place(vertex.uv.as_dvec2()));
    let cells = places.iter().map(|place| place.abs().max_element()).fold(0.0, f64::max);
    if cells >= MAX_START {
        return Err(DisplacedMeshError::TooFar { triangle, cells });
    }
    let [a, b, c] = places;
    let (least, greatest) = (a.min(b).min(c), a.max(b).max(c));
    let [columns, rows] = [0, 1].map(|axis| relief.cells(axis, least[axis], greatest[axis]));
    let bounds = relief.bounds([columns[0], rows[0]], [columns[1], rows[1]]);
    let points = vertices.into_iter().flat_map(|vertex| {
        let base = BasePoint::from(vertex);
        bounds.map(|metres| base.displaced(metres))
    });
    Ok(Bounds::around(points))
}
