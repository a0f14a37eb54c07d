//! Outlines of what pictures show: masks of covered pixels, and how far the outlines of two are apart.

/// Holes of fewer pixels are no outline: at a silhouette, light passes between two bumps of a relief or does
/// not by a hair.
pub const SMALL_HOLE: usize = 80;

/// Which pixels of a picture show something.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mask {
    size: [usize; 2],
    covered: Vec<bool>,
}

impl Mask {
    /// Mask of a picture of the given columns and rows, from the top row on.
    ///
    /// # Panics
    ///
    /// When there are not as many pixels.
    pub fn new([columns, rows]: [u32; 2], covered: Vec<bool>) -> Self {
        let size = [columns as usize, rows as usize];
        assert_eq!(size[0] * size[1], covered.len(), "a picture of {columns}x{rows} pixels");
        Self { size, covered }
    }

    /// Whether a pixel is covered; beyond the picture's edges, what its nearest pixel is.
    pub fn at(&self, x: i64, y: i64) -> bool {
        let [x, y] = [(x, self.size[0]), (y, self.size[1])].map(|(at, side)| at.clamp(0, side as i64 - 1));
        self.covered[y as usize * self.size[0] + x as usize]
    }

    /// Returns the number of covered pixels.
    pub fn area(&self) -> usize {
        self.covered.iter().filter(|covered| **covered).count()
    }

    /// Mask moved to the right by a number of pixels.
    #[must_use]
    pub fn moved(&self, by: i64) -> Self {
        let covered = self.places().map(|[x, y]| self.at(x - by, y)).collect();
        Self { covered, ..self.clone() }
    }

    /// Returns the mask without the pixels beside uncovered ones, corners included.
    #[must_use]
    pub fn eroded(&self) -> Self {
        let around = |[x, y]: [i64; 2]| (-1..=1).all(|dy| (-1..=1).all(|dx| self.at(x + dx, y + dy)));
        Self { covered: self.places().map(around).collect(), ..self.clone() }
    }

    /// The mask with its holes of fewer pixels than [`SMALL_HOLE`] filled: sets of uncovered pixels that
    /// sides connect.
    #[must_use]
    pub fn filled(&self) -> Self {
        let [columns, _] = self.size;
        let mut filled = self.clone();
        let mut seen = self.covered.clone();
        for first in 0..seen.len() {
            if seen[first] {
                continue;
            }
            seen[first] = true;
            let mut hole = vec![first];
            let mut next = 0;
            while let Some(&place) = hole.get(next) {
                next += 1;
                let x = place % columns;
                let beside = [
                    (x > 0).then(|| place - 1),
                    (x + 1 < columns).then_some(place + 1),
                    place.checked_sub(columns),
                    (place + columns < seen.len()).then_some(place + columns),
                ];
                for other in beside.into_iter().flatten() {
                    if !seen[other] {
                        seen[other] = true;
                        hole.push(other);
                    }
                }
            }
            if hole.len() < SMALL_HOLE {
                hole.into_iter().for_each(|place| filled.covered[place] = true);
            }
        }
        filled
    }

    /// The covered pixels that have an uncovered one at one of their sides.
    fn boundary(&self) -> Vec<[i64; 2]> {
        let is_open = |&[x, y]: &[i64; 2]| {
            let sides = [[x - 1, y], [x + 1, y], [x, y - 1], [x, y + 1]];
            self.at(x, y) && sides.into_iter().any(|[x, y]| !self.at(x, y))
        };
        self.places().filter(is_open).collect()
    }

    /// The same, where what is beside is among others.
    fn boundary_within(&self, others: &Mask) -> Vec<[i64; 2]> {
        let is_open = |&[x, y]: &[i64; 2]| {
            let sides = [[x - 1, y], [x + 1, y], [x, y - 1], [x, y + 1]];
            self.at(x, y) && sides.into_iter().any(|[x, y]| !self.at(x, y) && others.at(x, y))
        };
        self.places().filter(is_open).collect()
    }

    /// The pixels, row by row.
    fn places(&self) -> impl Iterator<Item = [i64; 2]> + use<> {
        let [columns, rows] = self.size.map(|side| side as i64);
        (0..rows).flat_map(move |y| (0..columns).map(move |x| [x, y]))
    }
}

/// For each boundary pixel of either mask the distance in pixels to the nearest one of the other: infinite
/// where that has none.
pub fn distances(a: &Mask, b: &Mask) -> Vec<f64> {
    distances_between(&a.boundary(), &b.boundary())
}

/// Distances of the lines within what both cover, such as edges of shadows. Outlines against what is not
/// covered are left out.
pub fn distances_of_lines(a: &Mask, b: &Mask, covered: &Mask) -> Vec<f64> {
    distances_between(&a.boundary_within(covered), &b.boundary_within(covered))
}

/// The distances of the outlines, with the columns and rows of their pixels.
pub fn places_and_distances(a: &Mask, b: &Mask) -> Vec<([i64; 2], f64)> {
    between(&a.boundary(), &b.boundary())
}

fn distances_between(a: &[[i64; 2]], b: &[[i64; 2]]) -> Vec<f64> {
    between(a, b).into_iter().map(|(_, distance)| distance).collect()
}

fn between(a: &[[i64; 2]], b: &[[i64; 2]]) -> Vec<([i64; 2], f64)> {
    let to = |from: &[[i64; 2]], to: &[[i64; 2]]| -> Vec<([i64; 2], f64)> {
        let squared = |[x, y]: [i64; 2], [u, v]: [i64; 2]| (x - u).pow(2) + (y - v).pow(2);
        let nearest = |from: &[i64; 2]| to.iter().map(|to| squared(*from, *to)).min();
        let distance = |from| nearest(from).map_or(f64::INFINITY, |least| (least as f64).sqrt());
        from.iter().map(|from| (*from, distance(from))).collect()
    };
    [to(a, b), to(b, a)].concat()
}

/// Returns the number of pixels that both cover, and that either covers.
pub fn overlap(a: &Mask, b: &Mask) -> [usize; 2] {
    let pairs = || a.covered.iter().zip(&b.covered);
    [pairs().filter(|(a, b)| **a && **b).count(), pairs().filter(|(a, b)| **a || **b).count()]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A disc in a picture of 80x60 pixels, with a round hole.
    fn disc(radius: f64, hole: f64) -> Mask {
        let places = (0..60).flat_map(|y| (0..80).map(move |x| [x, y]));
        let from_middle = |[x, y]: [i32; 2]| f64::from(x - 40).hypot(f64::from(y - 30));
        let covered = places.map(|place| (hole..=radius).contains(&from_middle(place))).collect();
        Mask::new([80, 60], covered)
    }

    #[test]
    fn small_holes_are_filled_and_large_ones_are_not() {
        let whole = disc(20.0, 0.0);
        assert_eq!(disc(20.0, 4.0).filled(), whole);
        assert_eq!(disc(20.0, 6.0).filled(), disc(20.0, 6.0));
        // What surrounds a disc is large.
        assert_eq!(whole.filled(), whole);
    }

    #[test]
    fn discs_are_as_far_apart_as_their_radii() {
        let (small, large) = (disc(20.0, 0.0), disc(24.0, 0.0));
        let apart = distances(&small, &large);
        assert!(apart.iter().all(|apart| (3.0..=5.0).contains(apart)));
        assert!(distances(&small, &small).iter().all(|apart| *apart == 0.0));
        assert_eq!(overlap(&small, &large), [small.area(), large.area()]);
        assert!(distances(&small, &disc(0.0, 1.0)).iter().all(|apart| apart.is_infinite()));
    }

    #[test]
    fn erosion_takes_off_the_boundary_and_its_corners() {
        let whole = disc(20.0, 0.0);
        let inside = whole.eroded();
        assert!(inside.area() < whole.area() && overlap(&inside, &whole) == [inside.area(), whole.area()]);
        let is_apart = |&[x, y]: &[i64; 2]| !inside.at(x, y);
        assert!(whole.boundary().iter().all(is_apart));
        assert!(inside.at(40, 12) && !inside.at(40, 11));
    }

    #[test]
    fn a_mask_moves_within_the_picture() {
        let whole = disc(20.0, 0.0);
        assert_eq!(whole.moved(3).moved(-3), whole);
        assert!(distances(&whole, &whole.moved(3)).into_iter().fold(0.0, f64::max) == 3.0);
    }
}
