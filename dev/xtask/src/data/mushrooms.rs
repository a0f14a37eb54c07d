//! Mushrooms on a flat ground, as a vector displacement map: caps that hang over their stems.

use std::path::Path;

use relief_io::{DEFAULT_MAX_BYTES, read_vector_map, write_exr};

use super::lattice::wrapped_difference;
use super::picture::Grid;

const SIDE: u32 = 64;

/// A mushroom: the middle of its foot, the radius of the disc of ground that becomes it, and how far
/// its cap leans, all in tiles.
struct Mushroom {
    centre: [f64; 2],
    radius: f64,
    lean: [f64; 2],
}

const MUSHROOMS: [Mushroom; 4] = [
    Mushroom { centre: [0.3, 0.3], radius: 0.25, lean: [0.05, -0.03] },
    Mushroom { centre: [0.74, 0.62], radius: 0.2, lean: [-0.05, 0.01] },
    Mushroom { centre: [0.78, 0.18], radius: 0.15, lean: [0.02, 0.04] },
    Mushroom { centre: [0.25, 0.76], radius: 0.19, lean: [-0.02, -0.05] },
];

/// Distances from the middle and heights, in radii: control points of a quadratic B-spline from the ground up
/// the stem, out under the cap and over it. It begins and ends between two of them.
const PROFILE: [[f64; 2]; 11] = [
    [1.1, 0.0],
    [0.9, 0.0],
    [0.4, 0.0],
    [0.25, 0.15],
    [0.2, 0.5],
    [0.2, 0.9],
    [0.55, 0.72],
    [0.82, 0.75],
    [0.68, 1.15],
    [0.2, 1.3],
    [-0.2, 1.3],
];

/// A point of the profile, at a part of the way from its beginning to its end.
fn profile(part: f64) -> [f64; 2] {
    let place = part * (PROFILE.len() - 2) as f64;
    let first = (place.floor() as usize).min(PROFILE.len() - 3);
    let t = place - first as f64;
    let [a, b, c] = [0, 1, 2].map(|next| PROFILE[first + next]);
    [0, 1].map(|axis| {
        let (ab, bc) = (0.5 * (a[axis] + b[axis]), 0.5 * (b[axis] + c[axis]));
        let (to_b, from_b) = (ab + (b[axis] - ab) * t, b[axis] + (bc - b[axis]) * t);
        to_b + (from_b - to_b) * t
    })
}

/// The parts of the vectors along tangent, normal and bitangent, in tiles; the
/// bitangent points up in the map.
pub fn vectors() -> Grid<[f64; 3]> {
    Grid::square(SIDE, |u, v| {
        for mushroom in &MUSHROOMS {
            let [du, dv] =
                [(mushroom.centre[0], u), (mushroom.centre[1], v)].map(|(a, b)| wrapped_difference(a, b));
            let distance = (du * du + dv * dv).sqrt();
            if distance < mushroom.radius {
                let [out, up] = profile(1.0 - distance / mushroom.radius);
                // How far a point moves outward, as a part of its distance.
                let outward = if distance > 0.0 { out * mushroom.radius / distance - 1.0 } else { 0.0 };
                let [lean_u, lean_v] = mushroom.lean.map(|lean| lean * up * up);
                return [du * outward + lean_u, up * mushroom.radius, -(dv * outward + lean_v)];
            }
        }
        [0.0; 3]
    })
}

/// The bytes of an EXR. Where a file of the same vectors is there already, its bytes: another version of the
/// compressor then changes nothing.
///
/// # Errors
///
/// When no file can be written in a temporary folder.
pub fn encoded(path: &Path) -> Result<Vec<u8>, String> {
    let Grid { width, height, texels } = vectors();
    let single: Vec<[f32; 3]> = texels.iter().map(|vector| vector.map(|part| part as f32)).collect();
    let there = read_vector_map(path, DEFAULT_MAX_BYTES).ok().filter(|there| there.vectors == single);
    if let (Some(_), Ok(bytes)) = (there, std::fs::read(path)) {
        return Ok(bytes);
    }
    let [tangents, normals, bitangents] =
        [0, 1, 2].map(|axis| single.iter().map(|vector| vector[axis]).collect::<Vec<_>>());
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let file = folder.path().join("vectors.exr");
    write_exr(&file, width, height, &[("R", &tangents), ("G", &normals), ("B", &bitangents)])
        .map_err(|error| error.to_string())?;
    std::fs::read(&file).map_err(|error| error.to_string())
}
