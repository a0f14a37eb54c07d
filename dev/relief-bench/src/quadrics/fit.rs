//! Changes of the vertices' quadrics when the vertices move a little.

use comfy_table::Table;
use glam::{DMat2, DVec2, DVec3};
use relief_core::mesh::{Mesh, QuadricCoefficients, Vertex};
use relief_core::rng::Rng;
use relief_tests::curved::quantile;

use crate::surfaces::bases::{Base, NAMES};
use crate::table::table;

/// How far vertices are moved, in distances of their nearest neighbours.
const MOVED: f64 = 1e-3;

/// The determinant of the normal matrix, over the square of its mean diagonal, below which the two
/// coefficients cannot be told from each other in single precision.
const SINGULAR: f64 = 1e-6;

/// The three fits.
const FITS: [&str; 3] = ["two, as published", "two", "three"];

/// How far the base rises by a quadric at each of a star's points.
type Rises = Vec<f64>;

/// What lies around a vertex.
#[derive(Clone, Default)]
struct Star {
    /// From the vertex to its neighbours.
    neighbours: Vec<DVec3>,
    /// To where the triangles around it end: neighbours, and the middles between them.
    ends: Vec<DVec3>,
    /// Metres to the nearest neighbour.
    nearest: f64,
}

/// Star of every vertex that is the first one at its place; empty for other vertices.
fn stars(mesh: &Mesh) -> Vec<Star> {
    let welded = mesh.welded();
    let mut stars = vec![Star::default(); mesh.vertices().len()];
    for corners in mesh.triangles() {
        let corners = corners.map(|corner| welded[corner as usize]);
        let places = corners.map(|corner| mesh.vertices()[corner as usize].position.as_dvec3());
        for [at, left, right] in [[0, 1, 2], [1, 2, 0], [2, 0, 1]] {
            let [left, right] = [left, right].map(|corner| places[corner] - places[at]);
            let star = &mut stars[corners[at] as usize];
            star.neighbours.extend([left, right].into_iter().filter(|offset| *offset != DVec3::ZERO));
            star.ends.extend([left, right, 0.5 * (left + right)]);
        }
    }
    for star in &mut stars {
        // Both triangles of an edge name its other end.
        let key = |offset: &DVec3| offset.to_array().map(f64::to_bits);
        star.neighbours.sort_unstable_by_key(key);
        star.neighbours.dedup();
        let lengths = star.neighbours.iter().map(|offset| offset.length());
        star.nearest = lengths.fold(f64::INFINITY, f64::min);
    }
    stars
}

/// Prints how stable the fits are.
pub fn measured() -> Result<Table, String> {
    let mut rows =
        table(&["mesh", "coefficients", "vertices", "change p50", "p99", "greatest", "not told apart"]);
    for name in NAMES {
        let Some(base) = Base::of(name)? else { continue };
        let around = stars(&base.mesh);
        let moved = moved(&base.mesh, &around)?;
        let around_moved = stars(&moved);
        for fit in FITS {
            let before = fitted(&base.mesh, &around, &around, fit);
            let after = fitted(&moved, &around_moved, &around, fit);
            let (mut changes, mut singular) = (Vec::new(), 0);
            for ((star, before), after) in around.iter().zip(before).zip(after) {
                if star.neighbours.is_empty() {
                    continue;
                }
                let Some((before, after)) = before.zip(after) else {
                    singular += 1;
                    continue;
                };
                let apart = before.iter().zip(&after).map(|(before, after)| (after - before).abs());
                changes.push(apart.fold(0.0, f64::max) / (MOVED * star.nearest));
            }
            let greatest = changes.iter().copied().fold(0.0, f64::max);
            rows.add_row([
                base.name.to_owned(),
                fit.to_owned(),
                changes.len().to_string(),
                format!("{:.2}", quantile(&changes, 0.5)),
                format!("{:.2}", quantile(&changes, 0.99)),
                format!("{greatest:.2}"),
                singular.to_string(),
            ]);
        }
    }
    Ok(rows)
}

/// The mesh with every place moved in a random direction; normals and tangents stay.
fn moved(mesh: &Mesh, stars: &[Star]) -> Result<Mesh, String> {
    let (welded, mut rng) = (mesh.welded(), Rng::new(7));
    let far = |star: &Star| if star.neighbours.is_empty() { 0.0 } else { MOVED * star.nearest };
    let moves: Vec<DVec3> = stars.iter().map(|star| rng.direction() * far(star)).collect();
    let vertices = mesh.vertices().iter().zip(&welded).map(|(vertex, first)| {
        let position = vertex.position.as_dvec3() + moves[*first as usize];
        Vertex { position: position.as_vec3(), ..*vertex }
    });
    Mesh::new(vertices.collect(), mesh.triangles().to_vec()).map_err(|error| error.to_string())
}

/// The quadrics of all vertices, from their stars, where those end in `read_at`; `None` where the
/// coefficients cannot be told from each other.
fn fitted(mesh: &Mesh, stars: &[Star], read_at: &[Star], fit: &str) -> Vec<Option<Rises>> {
    let coefficients = if fit == FITS[1] { QuadricCoefficients::Two } else { QuadricCoefficients::Three };
    let ours = if fit == FITS[0] { Vec::new() } else { mesh.quadrics(coefficients) };
    let rises = |(vertex, at): (usize, &Vertex)| {
        let normal = at.normal.as_dvec3();
        let flat = |vector: DVec3| vector - normal * normal.dot(vector);
        let tangent = flat(at.tangent.as_dvec3()).normalize_or_zero();
        let axes = [tangent, normal.cross(tangent)];
        let seen = |offset: DVec3| DVec2::from_array(axes.map(|axis| axis.dot(offset)));
        let form: Box<dyn Fn(DVec2) -> f64> = if let Some(quadric) = ours.get(vertex) {
            let [a, b, c] = quadric.map(f64::from);
            let tiles = [at.tangent, at.bitangent].map(|axis| seen(axis.as_dvec3()));
            let to_tiles = DMat2::from_cols(tiles[0], tiles[1]).inverse();
            Box::new(move |point| {
                let DVec2 { x, y } = to_tiles * point;
                a * x * x + b * x * y + c * y * y
            })
        } else {
            let [a, b] = published(stars[vertex].neighbours.iter().map(|offset| {
                let DVec2 { x, y } = seen(*offset);
                DVec3::new(x, y, normal.dot(*offset))
            }))?;
            Box::new(move |DVec2 { x, y }| a * x * x + b * y * y)
        };
        Some(read_at[vertex].ends.iter().map(|end| form(seen(*end))).collect())
    };
    mesh.vertices().iter().enumerate().map(rises).collect()
}

/// The two coefficients of a vertex by equations 1 and 2: heights of the neighbours over squares in the
/// vertex's own tangent space, by the inverse of a normal matrix of 2 by 2. None where there is no such
/// inverse.
fn published(neighbours: impl Iterator<Item = DVec3>) -> Option<[f64; 2]> {
    let [mut xx, mut xy, mut yy, mut xz, mut yz] = [0.0; 5];
    for DVec3 { x, y, z } in neighbours {
        let [x, y] = [x * x, y * y];
        xx += x * x;
        xy += x * y;
        yy += y * y;
        xz += x * z;
        yz += y * z;
    }
    let determinant = xx * yy - xy * xy;
    let is_singular = determinant <= SINGULAR * (0.5 * (xx + yy)).powi(2);
    (!is_singular).then(|| [(xz * yy - yz * xy) / determinant, (yz * xx - xz * xy) / determinant])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quadric_is_found_in_its_own_points_unless_they_lie_on_diagonals() {
        let on = |x: f64, y: f64| DVec3::new(x, y, 3.0 * x * x - 2.0 * y * y);
        let [a, b] = published([on(1.0, 0.2), on(-0.3, 1.0), on(-0.7, -0.6)].into_iter()).expect("a fit");
        assert!((a - 3.0).abs() < 1e-12 && (b + 2.0).abs() < 1e-12, "{a} {b}");
        let diagonal = [on(1.0, 1.0), on(-1.0, 1.0), on(-1.0, -1.0), on(1.0, -1.0)];
        assert_eq!(published(diagonal.into_iter()), None);
    }
}
