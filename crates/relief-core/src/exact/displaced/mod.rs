//! Exact first hits on a displaced mesh, by which methods for curved surfaces are judged.
//!
//! Nothing is tessellated. The shell over a base triangle is halved until every part is decided. A
//! convex hull that holds the sheet bounds each part: see `shell.rs` and `bezier.rs` for the
//! proofs.

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

/// A mesh displaced by a height map, and the exact first hit of a ray with it, in `f64`.
///
/// A triangle has corner positions `p_k`, normals `n_k` and texture coordinates `uv_k`. The
/// displaced surface over it, the *sheet*, is
///
/// `X(w) = Σ w_k p_k + (bias_m + scale_m H(Σ w_k uv_k)) Σ w_k n_k`,
///
/// with barycentric weights `w_k >= 0` that add up to 1 and the bilinear height `H` of
/// [`HeightMap::height_at`]. The interpolated normal is *not* normalised. Therefore neighbours that
/// share two corners share the side between them.
///
/// # Guarantee
///
/// Let the size of the scene be the diagonal of [`Self::bounds`].
///
/// * A hit lies on the sheet, except for rounding. It lies on the ray to within 2⁻⁴⁴ of the largest
///   distance between the ray's origin and the triangle's corners, which is the effect of rounding
///   the inputs. A [`grazing`](DisplacedHit::grazing) hit lies on the ray to within
///   [`Self::TOLERANCE`] of the scene's size.
/// * No crossing before the hit is missed, however near to tangency. Exceptions are crossings at
///   the same depth, to rounding (and at most [`Self::TOLERANCE`] of the scene's size before). A
///   ray that passes the sheet within the same rounding counts as touching it.
///
/// # Cost
///
/// [`Self::new`] builds a maximum and a minimum pyramid of the map and a BVH over the triangles. It
/// keeps a copy of the mesh and shares the map's texels. A ray visits about sixty nodes if it
/// crosses a few cells before its hit. If it crosses many cells inside shells, the cost is
/// proportional to their number.
///
/// # Source
///
/// Shells over triangles whose sides neighbours share: Hirche, Ehlert, Guthe and Doggett 2004
/// ("Hardware accelerated per-pixel displacement mapping"). Halving until a hull is missed: Lane
/// and Riesenfeld 1980 ("A theoretical development for the computer generation and display of
/// piecewise polynomial surfaces").
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
    /// The scale or the bias is not a usable length.
    #[error("{what} is {value} m: it must be a number of at most 1e9 m")]
    BadLength {
        /// The scale or the bias.
        what: &'static str,
        /// The length given, in metres.
        value: f64,
    },
    /// Texture coordinates are too far from the origin to distinguish cells.
    #[error("triangle {triangle} lies {cells:e} cells from the origin of the texture, too far to be exact")]
    TooFar {
        /// Number of the first such triangle.
        triangle: u32,
        /// Distance in cells along one axis.
        cells: f64,
    },
}

/// Crossings of a sheet that count as hits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Sides {
    /// Only crossings from above.
    #[default]
    Front,
    /// Crossings from above and from below.
    Both,
}

/// Side from which a sheet is crossed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Side {
    /// From above: the ray's height over the sheet, along the interpolated normal, falls.
    Front,
    /// From below: the ray's height over the sheet rises.
    Back,
}

/// A hit of a ray with a displaced mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DisplacedHit {
    /// Parameter along the ray: the hit is at `origin + t * direction`. Never negative.
    pub t: f64,
    /// Number of the base triangle. For a hit on a side or a corner it is one of the adjacent
    /// triangles.
    pub triangle: u32,
    /// Barycentric weights of the triangle's corners; they are in `[0, 1]` and add up to 1, both to
    /// rounding.
    pub weights: [f64; 3],
    /// Texture coordinates, not wrapped.
    pub uv: [f64; 2],
    /// Height of the map at the hit, a texel value in `[0, 1]`.
    pub height: f64,
    /// Point of the sheet with these weights, in metres.
    pub position: [f64; 3],
    /// Side from which the sheet is crossed. A touch counts as a crossing from above.
    pub side: Side,
    /// Whether the shell is turned inside out at the hit: displaced beyond the centre of curvature,
    /// or with normals against the winding of the triangle. The winding of the sheet is then
    /// opposite to `side`.
    pub folded: bool,
    /// Whether ray and sheet are so nearly tangent that the hit may be a crossing or a touch. It is
    /// then known only to [`DisplacedMesh::TOLERANCE`].
    pub grazing: bool,
}

/// Result of tracing a ray, with its cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DisplacedTrace {
    /// First hit; `None` for a miss.
    pub hit: Option<DisplacedHit>,
    /// Number of boxes of the BVH and hulls of parts of shells that were tested.
    pub nodes: u64,
}

/// Largest scale and bias, in metres.
const MAX_METRES: f64 = 1e9;

impl DisplacedMesh {
    /// Size, as a part of the scene's size, below which parts of a sheet that graze the ray are no
    /// longer halved.
    pub const TOLERANCE: f64 = 1e-9;

    /// Displaces a mesh by a map: texel 0 by `bias_m` metres and texel 1 by `bias_m + scale_m`,
    /// times the normals' lengths. Both may be negative. The map's own scale and bias are ignored.
    ///
    /// # Errors
    ///
    /// When a length is not finite or above 1e9 m, or a triangle lies [`MAX_START`] or more cells
    /// from the origin of the texture.
    pub fn new(mesh: &Mesh, map: &HeightMap, scale_m: f64, bias_m: f64) -> Result<Self, DisplacedMeshError> {
        for (what, value) in [("the scale", scale_m), ("the bias", bias_m)] {
            // NaN is not below any number.
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

    /// Box around the shells of all triangles, as least and greatest corner in metres. For a mesh
    /// without triangles it is empty: the least corner is above the greatest.
    pub fn bounds(&self) -> [[f64; 3]; 2] {
        let Bounds { least, greatest } = self.hierarchy.bounds();
        [least.to_array(), greatest.to_array()]
    }

    /// Returns the first point at which a ray hits the displaced mesh on one of `sides`.
    ///
    /// `origin` is in metres; the ray is `origin + t * direction` with `t >= 0`. Returns `None` if
    /// a number is NaN, infinite or beyond [`MAX_RATE`](crate::exact::MAX_RATE), or if the
    /// direction is shorter than 1e-90.
    pub fn first_hit(&self, origin: [f64; 3], direction: [f64; 3], sides: Sides) -> Option<DisplacedHit> {
        self.trace(origin, direction, sides).hit
    }

    /// Returns the hit as [`Self::first_hit`], with the cost of finding it.
    pub fn trace(&self, origin: [f64; 3], direction: [f64; 3], sides: Sides) -> DisplacedTrace {
        self.search(origin, direction, sides, |ray, search| {
            self.hierarchy.walk(ray, |triangle| {
                search.triangle(triangle, self.mesh.corners(triangle));
                search.limit()
            })
        })
    }

    /// Returns the first point at which a ray hits the sheet over one triangle, ignoring all
    /// others. A miss if there is no such triangle.
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

    /// Runs a search and returns its result. `search_in` returns the number of boxes that it
    /// tested.
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

    /// Tolerance in metres.
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

/// Box around the shell of one triangle.
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
