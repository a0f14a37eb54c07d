//! Determinants of points in whole numbers, without rounding.

/// A point on the lattice: `u`, `v` and height.
pub type Point = [i64; 3];

/// Six times the signed volume of a tetrahedron. Differences of the points have at most 40 bits, so that
/// the sum of the products has at most 123.
pub fn volume(a: Point, b: Point, c: Point, d: Point) -> i128 {
    let way = |to: Point| [0, 1, 2].map(|axis| i128::from(to[axis] - a[axis]));
    let ([bx, by, bz], [cx, cy, cz], [dx, dy, dz]) = (way(b), way(c), way(d));
    bx * (cy * dz - cz * dy) + by * (cz * dx - cx * dz) + bz * (cx * dy - cy * dx)
}
