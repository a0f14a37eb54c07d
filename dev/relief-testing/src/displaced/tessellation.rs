//! Small triangles in place of the sheet, each inside one cell, with a bound of their distance from it.
//!
//! Over a small triangle inside one cell, with corner displacements `D_k`, normals `N_k` and places `(x_k,
//! y_k)`, `X` and the flat triangle `T` with the same corners differ by `D N - Σ λ_k D_k N_k`. With the
//! linear interpolation `L` of the `D_k` that is `(D - L) N + (L N - Σ λ_k D_k N_k)`. The first bracket is
//! `-s d Σ_{i<j} λ_i λ_j (x_i - x_j)(y_i - y_j)`, with the cell's twist `d` and the scale `s`; the second is
//! `-Σ_{i<j} λ_i λ_j (D_i - D_j)(N_i - N_j)`. As `Σ_{i<j} λ_i λ_j <= 1/3`, each is at most a third of its
//! largest product.

use glam::{DVec2, DVec3};

use super::sheet::Sheet;

/// A flat triangle with the corners of the sheet.
pub struct Flat {
    /// Number of the base triangle.
    pub triangle: u32,
    /// Weights of its corners there.
    pub weights: [[f64; 3]; 3],
    /// The corners, in metres.
    pub points: [DVec3; 3],
    /// No point of the sheet is further from the point of the flat triangle with the same weights.
    pub error: f64,
}

/// Flat triangles, and a ball that holds them and their part of the sheet.
pub struct Group {
    /// The triangles.
    pub flats: Vec<Flat>,
    /// The ball's middle.
    pub centre: DVec3,
    /// The ball's radius, in metres.
    pub radius: f64,
}

/// Tessellates a sheet with `divisions` of each side of each triangle of each cell's polygon.
pub fn tessellate(sheet: &Sheet, divisions: usize) -> Vec<Group> {
    let mut groups = Vec::new();
    for triangle in 0..sheet.triangles() {
        let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let mut columns = Vec::new();
        slabs(sheet, triangle, corners.to_vec(), 0, &mut columns);
        let mut cells = Vec::new();
        columns.into_iter().for_each(|column| slabs(sheet, triangle, column, 1, &mut cells));
        for polygon in cells {
            for k in 2..polygon.len() {
                groups.push(group(sheet, triangle, [polygon[0], polygon[k - 1], polygon[k]], divisions));
            }
        }
    }
    groups
}

/// The parts of a polygon of weights between neighbouring whole places on an axis.
fn slabs(sheet: &Sheet, triangle: u32, polygon: Vec<[f64; 3]>, axis: usize, parts: &mut Vec<Vec<[f64; 3]>>) {
    let place = |w: &[f64; 3]| sheet.place(triangle, *w)[axis];
    let least = polygon.iter().map(place).fold(f64::INFINITY, f64::min);
    let greatest = polygon.iter().map(place).fold(f64::NEG_INFINITY, f64::max);
    let mut rest = polygon;
    for line in (least.floor() as i64 + 1)..=(greatest.floor() as i64) {
        let line = line as f64;
        let (mut below, mut above) = (Vec::new(), Vec::new());
        for k in 0..rest.len() {
            let (a, b) = (rest[k], rest[(k + 1) % rest.len()]);
            let (at, next) = (place(&a) - line, place(&b) - line);
            if at <= 0.0 {
                below.push(a);
            }
            if at >= 0.0 {
                above.push(a);
            }
            if at * next < 0.0 {
                let s = at / (at - next);
                let cut = std::array::from_fn(|k| a[k] + s * (b[k] - a[k]));
                below.push(cut);
                above.push(cut);
            }
        }
        parts.push(below);
        rest = above;
    }
    parts.push(rest);
}

fn group(sheet: &Sheet, triangle: u32, corners: [[f64; 3]; 3], n: usize) -> Group {
    let at = |i: usize, j: usize| -> [f64; 3] {
        let (a, b) = (i as f64 / n as f64, j as f64 / n as f64);
        std::array::from_fn(|k| (1.0 - a - b) * corners[0][k] + a * corners[1][k] + b * corners[2][k])
    };
    let middle: [f64; 3] = std::array::from_fn(|k| (corners[0][k] + corners[1][k] + corners[2][k]) / 3.0);
    let cell = sheet.place(triangle, middle).floor();
    let mut flats = Vec::new();
    for i in 0..n {
        for j in 0..n - i {
            flats.push(flat(sheet, triangle, [at(i, j), at(i + 1, j), at(i, j + 1)], cell));
            if i + j + 2 <= n {
                flats.push(flat(sheet, triangle, [at(i + 1, j + 1), at(i, j + 1), at(i + 1, j)], cell));
            }
        }
    }
    let centre = sheet.point(triangle, middle);
    let reach = |flat: &Flat| flat.points.iter().map(|p| p.distance(centre)).fold(0.0, f64::max) + flat.error;
    let radius = flats.iter().map(reach).fold(0.0, f64::max);
    Group { flats, centre, radius }
}

fn flat(sheet: &Sheet, triangle: u32, weights: [[f64; 3]; 3], cell: DVec2) -> Flat {
    let [h00, h10, h01, h11] = sheet.map.cell(cell.x as i64, cell.y as i64).map(f64::from);
    let twist = h00 - h10 - h01 + h11;
    let places = weights.map(|w| sheet.place(triangle, w));
    let normals = weights.map(|w| sheet.normal(triangle, w));
    let metres = weights.map(|w| sheet.bias_m + sheet.scale_m * sheet.height(triangle, w));
    let longest = normals.iter().map(|normal| normal.length()).fold(0.0, f64::max);
    let (mut of_places, mut of_normals) = (0.0f64, 0.0f64);
    for (i, j) in [(0, 1), (1, 2), (2, 0)] {
        let step = places[i] - places[j];
        of_places = of_places.max((step.x * step.y).abs());
        of_normals = of_normals.max((metres[i] - metres[j]).abs() * normals[i].distance(normals[j]));
    }
    let error = (longest * (sheet.scale_m * twist).abs() * of_places + of_normals) / 3.0;
    let points = weights.map(|w| sheet.point(triangle, w));
    Flat { triangle, weights, points, error: error + 1e-13 * sheet.size() }
}
