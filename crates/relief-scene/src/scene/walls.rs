//! Blocks: walls and a bottom that close the relief of a plane.

use std::fmt;
use std::str::FromStr;

use glam::{DVec3, Vec2};
use relief_core::mesh::{Mesh, MeshError, Vertex};
use relief_core::{HeightMap, Wrap};
use relief_io::LengthError;

use super::Surface;

/// Shortest part of a wall in texels. `f32` rounds the ends of planes with parts of tiles.
const SHORTEST_PART: f64 = 1e-3;

/// Thickness of a block's base, below the lowest texel of its relief.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BaseThickness {
    /// Thickness in metres, above 0.
    Metres(f64),
    /// Thickness as a part of the plane's shorter side, above 0.
    Share(f64),
}

impl Default for BaseThickness {
    /// A twentieth of the plane's shorter side.
    fn default() -> Self {
        BaseThickness::Share(0.05)
    }
}

impl BaseThickness {
    /// Returns the thickness in metres for a plane whose shorter side has that length in metres.
    pub fn metres(self, shorter_side_m: f64) -> f64 {
        match self {
            BaseThickness::Metres(metres) => metres,
            BaseThickness::Share(share) => share * shorter_side_m,
        }
    }
}

impl fmt::Display for BaseThickness {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BaseThickness::Metres(metres) => write!(f, "{metres}m"),
            BaseThickness::Share(share) => write!(f, "{}%", 100.0 * share),
        }
    }
}

/// Error for a text that is no thickness of a base.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BadBase {
    /// The text before a percent sign is no number.
    #[error("'{0}' is no percentage: give a part of the plane's shorter side, as in 5%")]
    Share(
        /// The text.
        String,
    ),
    /// The text is no length.
    #[error("{0}; a part of the plane's shorter side is given as in 5%")]
    Length(#[from] LengthError),
}

impl FromStr for BaseThickness {
    type Err = BadBase;

    fn from_str(text: &str) -> Result<Self, BadBase> {
        let Some(percent) = text.trim().strip_suffix('%') else {
            return Ok(BaseThickness::Metres(relief_io::metres(text)?));
        };
        let percent: f64 = percent.trim().parse().map_err(|_| BadBase::Share(text.to_owned()))?;
        Ok(BaseThickness::Share(percent / 100.0))
    }
}

/// Rectangle of a block: a flat mesh with its tiles.
struct Plan {
    /// Place of texture coordinates 0.
    origin: DVec3,
    /// Derivatives of the place by `u` and `v`.
    along: [DVec3; 2],
    /// Unit normal.
    up: DVec3,
    /// Greatest texture coordinates that show the relief.
    end: [f64; 2],
}

impl Plan {
    fn of(mesh: &Mesh, wrap: Wrap) -> Option<Self> {
        let first = mesh.vertices().first()?;
        let along = [first.tangent, first.bitangent].map(|along| along.as_dvec3());
        let [u, v] = [first.uv.x, first.uv.y].map(f64::from);
        let end = mesh.vertices().iter().fold(Vec2::ZERO, |end, vertex| end.max(vertex.uv));
        // A clamped map is shown once.
        let most = if wrap == Wrap::Clamp { 1.0 } else { f64::INFINITY };
        Some(Self {
            origin: first.position.as_dvec3() - along[0] * u - along[1] * v,
            along,
            up: first.normal.as_dvec3(),
            end: [end.x, end.y].map(|end| f64::from(end).min(most)),
        })
    }

    fn at(&self, [u, v]: [f64; 2], displacement_m: f64) -> DVec3 {
        self.origin + self.along[0] * u + self.along[1] * v + self.up * displacement_m
    }

    /// Returns the lengths of both sides in metres.
    fn sides_m(&self) -> [f64; 2] {
        [0, 1].map(|axis| self.along[axis].length() * self.end[axis])
    }
}

/// Returns the number of triangles of a block's walls and bottom.
pub(super) fn triangles_of_walls(surface: &Surface) -> u64 {
    let map = surface.height_map();
    let Some(plan) = Plan::of(surface.mesh(), map.wrap()) else { return 0 };
    let cells = [map.width(), map.height()].map(f64::from);
    let parts: f64 = (0..2).map(|axis| (plan.end[axis] * cells[axis]).ceil() + 2.0).sum();
    6 * parts as u64
}

/// Returns the coordinates along an axis between which the bilinear surface is straight.
fn stations(end: f64, texels: u32) -> Vec<f64> {
    let texels = f64::from(texels);
    let count = (end * texels).ceil() as u64;
    let is_inside = |place: &f64| (end - place) * texels > SHORTEST_PART;
    let centres = (0..count).map(|texel| (texel as f64 + 0.5) / texels).filter(is_inside);
    [0.0].into_iter().chain(centres).chain([end]).collect()
}

/// Returns the walls and the bottom that close a surface's relief to a block, `base` below its
/// lowest texel. The upper edge of the walls follows the bilinear surface exactly. The surface's
/// mesh must be a flat rectangle.
///
/// # Errors
///
/// When numbers are too large for a mesh.
pub(super) fn walls(surface: &Surface, base: BaseThickness) -> Result<Mesh, MeshError> {
    let map: &HeightMap = surface.height_map();
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    let Some(plan) = Plan::of(surface.mesh(), map.wrap()) else { return Mesh::new(vertices, triangles) };
    let [across, down] = plan.sides_m();
    let low_m = map.displacement_m(f64::from(map.extremes()[0])) - base.metres(across.min(down));
    let [u_end, v_end] = plan.end;
    let [us, vs] = [stations(u_end, map.width()), stations(v_end, map.height())];
    // Each wall runs to the right for those who face it from outside.
    let sides: [Vec<[f64; 2]>; 4] = [
        us.iter().map(|&u| [u, v_end]).collect(),
        vs.iter().rev().map(|&v| [u_end, v]).collect(),
        us.iter().rev().map(|&u| [u, 0.0]).collect(),
        vs.iter().map(|&v| [0.0, v]).collect(),
    ];
    for places in &sides {
        let [start, end] = [places[0], places[places.len() - 1]].map(|place| plan.at(place, low_m));
        let right = (end - start).normalize_or_zero();
        let normal = right.cross(plan.up);
        let first = vertices.len() as u32;
        for &[u, v] in places {
            let height_m = map.displacement_m(map.height_at(u, v));
            for displacement_m in [height_m, low_m] {
                let position = plan.at([u, v], displacement_m);
                let uv = [(position - start).dot(right), -displacement_m];
                vertices.push(vertex(position, normal, right, -plan.up, uv));
            }
        }
        for station in 0..places.len() as u32 - 1 {
            let [top, bottom] = [first + 2 * station, first + 2 * station + 1];
            triangles.extend([[top, bottom, bottom + 2], [top, bottom + 2, top + 2]]);
        }
    }
    // The bottom is a fan, whose border has the vertices of the walls.
    let middle = vertices.len() as u32;
    let [right, forward] = plan.along.map(DVec3::normalize_or_zero);
    let border = sides.iter().flat_map(|places| &places[..places.len() - 1]).copied();
    for place in [plan.end.map(|end| 0.5 * end)].into_iter().chain(border) {
        let uv = [0, 1].map(|axis| place[axis] * plan.along[axis].length());
        vertices.push(vertex(plan.at(place, low_m), -plan.up, right, forward, uv));
    }
    let [first, count] = [middle + 1, vertices.len() as u32 - middle - 1];
    triangles.extend((0..count).map(|at| [first + (at + 1) % count, first + at, middle]));
    Mesh::new(vertices, triangles)
}

fn vertex(position: DVec3, normal: DVec3, tangent: DVec3, bitangent: DVec3, [u, v]: [f64; 2]) -> Vertex {
    let [position, normal, tangent, bitangent] =
        [position, normal, tangent, bitangent].map(|vector| vector.as_vec3());
    Vertex { position, normal, tangent, bitangent, uv: Vec2::new(u as f32, v as f32) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use relief_core::mesh::{Placement, rectangle};

    /// Returns a surface of a plane of 2 m by 1 m with 5 x 3 texels, turned and moved.
    fn plane(wrap: Wrap, tile: Vec2) -> Surface {
        let height = |i: u32, j: u32| (0.2 + 0.1 * i as f32 + 0.15 * j as f32).min(1.0);
        let map = HeightMap::from_fn(5, 3, wrap, height).expect("a map");
        let map = map.with_displacement(0.4, -0.1).expect("a displacement");
        let placement = Placement {
            position_m: DVec3::new(3.0, -2.0, 1.0),
            rotation_degrees: DVec3::new(20.0, 75.0, -10.0),
            size: 1.5,
        };
        let mesh = rectangle([2.0, 1.0], 1).and_then(|mesh| mesh.tiled(tile)?.placed(&placement));
        Surface::new(mesh.expect("a mesh"), map)
    }

    #[test]
    fn walls_are_upright_and_end_on_the_relief() {
        for (wrap, tile) in [
            (Wrap::Clamp, Vec2::ONE),
            (Wrap::Repeat, Vec2::new(2.5, 1.0)),
            (Wrap::Mirror, Vec2::new(0.3, 1.7)),
            (Wrap::Clamp, Vec2::new(3.0, 0.5)),
        ] {
            let surface = plane(wrap, tile);
            let (map, plan) = (surface.height_map(), Plan::of(surface.mesh(), wrap).expect("a plane"));
            let mesh = walls(&surface, BaseThickness::Metres(0.25)).expect("walls");
            assert!(mesh.triangles().len() as u64 <= triangles_of_walls(&surface), "{wrap:?} {tile}");
            let low_m = map.displacement_m(f64::from(map.extremes()[0])) - 0.25;
            let middle = plan.at(plan.end.map(|end| 0.5 * end), low_m + 0.1);
            for triangle in 0..mesh.triangles().len() as u32 {
                let corners = mesh.corners(triangle);
                let [a, b, c] = corners.map(|corner| corner.position.as_dvec3());
                let normal = (b - a).cross(c - a).normalize();
                // The front looks away from the block, and so does the normal of the corners.
                assert!(normal.dot(a - middle) > 0.0, "{wrap:?} {tile} {triangle}");
                assert!(corners.iter().all(|corner| normal.dot(corner.normal.as_dvec3()) > 0.999));
                let is_bottom = normal.dot(plan.up) < -0.999;
                assert!(is_bottom || normal.dot(plan.up).abs() < 1e-3);
                for corner in [a, b, c] {
                    let of_plane = corner - plan.origin;
                    let place = plan.along.map(|along| of_plane.dot(along) / along.length_squared());
                    let displacement = of_plane.dot(plan.up);
                    let relief = map.displacement_m(map.height_at(place[0], place[1]));
                    let [on_relief, on_bottom] = [relief, low_m].map(|at| (displacement - at).abs() < 1e-4);
                    assert!(on_bottom || (on_relief && !is_bottom), "{wrap:?} {tile}: {place:?}");
                }
            }
        }
    }

    #[test]
    fn walls_are_open_only_along_the_border_of_the_relief() {
        let surface = plane(Wrap::Clamp, Vec2::ONE);
        let mesh = walls(&surface, BaseThickness::default()).expect("walls");
        let key = |index: u32| {
            mesh.vertices()[index as usize].position.to_array().map(|part| (part * 1e4).round() as i64)
        };
        let mut open = std::collections::BTreeMap::new();
        for corners in mesh.triangles() {
            for (a, b) in [(0, 1), (1, 2), (2, 0)] {
                let [a, b] = [key(corners[a]), key(corners[b])];
                *open.entry((a.min(b), a.max(b))).or_insert(0) += if a < b { 1 } else { -1 };
            }
        }
        // Five columns and three rows of texels: six and four straight parts a side.
        let left = open.values().filter(|count| **count != 0).count();
        assert_eq!(left, 2 * (6 + 4));
    }

    #[test]
    fn thicknesses_are_lengths_or_shares() {
        let read = |text: &str| text.parse::<BaseThickness>();
        assert_eq!(read("5cm"), Ok(BaseThickness::Metres(0.05)));
        assert_eq!(read("0.2"), Ok(BaseThickness::Metres(0.2)));
        assert_eq!(read("25 %"), Ok(BaseThickness::Share(0.25)));
        assert_eq!(read("25%").map(|base| base.metres(2.0)), Ok(0.5));
        for text in ["", "%", "thick", "5 parsecs"] {
            assert!(read(text).is_err_and(|error| error.to_string().contains("5%")), "{text}");
        }
        for base in [BaseThickness::Metres(0.125), BaseThickness::Share(0.25)] {
            assert_eq!(read(&base.to_string()), Ok(base));
        }
    }
}
