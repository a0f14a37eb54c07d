//! The motif on a lattice of whole numbers, with places that are the same in every tile.

use std::collections::HashMap;

use glam::{DVec3, Vec3};
use relief_core::mesh::{RawCorner, RawMesh};

use super::ShellMapError;
use super::predicates::Point;

/// Steps of the motif's lattice along a tile, and of all points: a motif may be moved by parts of its steps.
const COARSE: i64 = 1 << 24;
pub const STEPS: i64 = 1 << 32;

/// Steps by which heights 0 and 1 lie inside of the shells, and by which a motif is moved at most.
const INSET: i64 = 64;

/// Tiles from which a motif may be.
const FAR: f64 = 16.0;

/// A vertex of a triangle: the number of its place in a tile, and the tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Place {
    pub number: u32,
    pub tile: [i32; 2],
}

/// A triangle of the motif.
#[derive(Clone, Copy, Debug)]
pub struct MotifTriangle {
    pub places: [Place; 3],
    pub points: [Point; 3],
    /// Normals at the corners, along `u`, `v` and the height.
    pub normals: [DVec3; 3],
}

/// The motif.
pub struct Lattice {
    /// By their least `u`, without triangles that lie on their opposite.
    pub triangles: Vec<MotifTriangle>,
    /// The greatest extent of one along `u`.
    widest: i64,
    /// Least and greatest coordinates.
    pub extent: [Point; 2],
    pub beyond: f64,
    pub doubled: u64,
}

impl Lattice {
    /// Rounds a motif. It is moved by a way of its own for every attempt, so that no point lies on a face.
    pub fn new(motif: &RawMesh, attempt: u32) -> Result<Self, ShellMapError> {
        let turned = |at: Vec3| DVec3::new(at.x.into(), at.z.into(), at.y.into());
        let moved = moved(attempt);
        let mut numbers: HashMap<Point, u32> = HashMap::new();
        let mut places = Vec::with_capacity(motif.positions.len());
        let mut beyond = 0u64;
        for (at, position) in motif.positions.iter().enumerate() {
            let position = turned(*position);
            if !position.is_finite() || position.abs().max_element() > FAR {
                return Err(ShellMapError::FarMotif(at));
            }
            let [u, v, height] = (position * COARSE as f64).round().to_array().map(|part| part as i64);
            beyond += u64::from(!(0..=COARSE).contains(&height));
            let first = [u.rem_euclid(COARSE), v.rem_euclid(COARSE), height];
            let count = numbers.len() as u32;
            let number = *numbers.entry(first).or_insert(count);
            let tile = [u, v].map(|part| part.div_euclid(COARSE) as i32);
            let [u, v] = [u, v].map(|part| part * (STEPS / COARSE));
            // Heights 0 and 1 lie inside, wherever the motif is moved, so that nothing is cut off there.
            let height = i128::from(height) * i128::from(STEPS - 2 * INSET) / i128::from(COARSE);
            let point = [u, v, height as i64 + INSET];
            places.push((Place { number, tile }, [0, 1, 2].map(|axis| point[axis] + moved[axis])));
        }
        let mut triangles = Vec::new();
        for corners in &motif.triangles {
            let of = corners.map(|corner| places[corner.position as usize]);
            let [a, b, c] = corners.map(|corner| motif.positions[corner.position as usize]);
            let of_face = (b - a).cross(c - a).normalize_or_zero();
            let normal = |corner: RawCorner| {
                let own = motif.normals.get(corner.normal as usize).copied().filter(|own| own.is_finite());
                turned(own.filter(|own| *own != Vec3::ZERO).unwrap_or(of_face))
            };
            let (places, points) = (of.map(|(place, _)| place), of.map(|(_, point)| point));
            if has_area(points) {
                triangles.push(MotifTriangle { places, points, normals: corners.map(normal) });
            }
        }
        let count = triangles.len();
        let mut triangles = without_doubled(triangles);
        let doubled = (count - triangles.len()) as u64;
        triangles.sort_by_key(|triangle| triangle.span(0)[0]);
        let widest = triangles.iter().map(|triangle| triangle.span(0)).map(|[low, high]| high - low).max();
        let all = || triangles.iter().flat_map(|triangle| triangle.points);
        let extent = [
            all().fold([i64::MAX; 3], |low, at| [0, 1, 2].map(|axis| low[axis].min(at[axis]))),
            all().fold([i64::MIN; 3], |high, at| [0, 1, 2].map(|axis| high[axis].max(at[axis]))),
        ];
        let beyond = beyond as f64 / motif.positions.len().max(1) as f64;
        Ok(Self { triangles, widest: widest.unwrap_or_default(), extent, beyond, doubled })
    }

    /// The triangles that may lie in a box.
    pub fn within(&self, low: [i64; 2], high: [i64; 2]) -> impl Iterator<Item = &MotifTriangle> {
        let first = self.triangles.partition_point(|triangle| triangle.span(0)[0] < low[0] - self.widest);
        let near = self.triangles[first..].iter().take_while(move |triangle| triangle.span(0)[0] <= high[0]);
        near.filter(move |triangle| {
            let is_beside = |axis: usize, from: i64, to: i64| {
                let [least, greatest] = triangle.span(axis);
                greatest < from || least > to
            };
            !(is_beside(0, low[0], high[0]) || is_beside(1, low[1], high[1]) || is_beside(2, 0, STEPS))
        })
    }
}

impl MotifTriangle {
    /// Its least and greatest coordinate along an axis.
    fn span(&self, axis: usize) -> [i64; 2] {
        let [a, b, c] = self.points.map(|point| point[axis]);
        [a.min(b).min(c), a.max(b).max(c)]
    }
}

/// Whether a triangle's corners lie on no line.
fn has_area([a, b, c]: [Point; 3]) -> bool {
    let way = |to: Point| [0, 1, 2].map(|axis| i128::from(to[axis] - a[axis]));
    let ([bx, by, bz], [cx, cy, cz]) = (way(b), way(c));
    [by * cz - bz * cy, bz * cx - bx * cz, bx * cy - by * cx].iter().any(|part| *part != 0)
}

/// The way by which the motif is moved, in steps: less than half a step of its own lattice.
fn moved(attempt: u32) -> Point {
    let part = |factor: u64| {
        let turned = (u64::from(attempt) + 1).wrapping_mul(factor) >> 32;
        (turned % 127) as i64 - 63
    };
    [part(0x9e37_79b9_7f4a_7c15), part(0xbf58_476d_1ce4_e5b9), part(0x94d0_49bb_1331_11eb)]
}

/// Takes out pairs of triangles with the same corners that look opposite ways.
fn without_doubled(triangles: Vec<MotifTriangle>) -> Vec<MotifTriangle> {
    let mut waiting: HashMap<[Place; 3], [Vec<usize>; 2]> = HashMap::new();
    let mut is_out = vec![false; triangles.len()];
    for (at, triangle) in triangles.iter().enumerate() {
        let (places, is_turned) = in_first_tile(triangle.places);
        let sides = waiting.entry(places).or_default();
        match sides[usize::from(!is_turned)].pop() {
            Some(opposite) => (is_out[opposite], is_out[at]) = (true, true),
            None => sides[usize::from(is_turned)].push(at),
        }
    }
    let mut is_out = is_out.into_iter();
    triangles.into_iter().filter(|_| !is_out.next().unwrap_or_default()).collect()
}

/// The corners in order, moved by whole tiles so that the first one's tile is 0. True if they turn
/// the other way then.
fn in_first_tile(places: [Place; 3]) -> ([Place; 3], bool) {
    let least = places.iter().map(|place| (place.number, place.tile)).min().unwrap_or_default().1;
    let mut places =
        places.map(|place| Place { tile: [0, 1].map(|axis| place.tile[axis] - least[axis]), ..place });
    let mut is_turned = false;
    for (a, b) in [(0, 1), (1, 2), (0, 1)] {
        if places[b] < places[a] {
            places.swap(a, b);
            is_turned = !is_turned;
        }
    }
    (places, is_turned)
}
