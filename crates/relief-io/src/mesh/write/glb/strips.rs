//! Triangles as one strip.
//!
//! Source: Gumhold and Hüttner 1999, section 2.2, the stripping unit: a strip that is sequential, in which a
//! vertex that is at hand is named again to turn (`ref`), and which begins anew (`init`) where it ends. Which
//! triangle comes next is theirs to know from the sweep; here it is found by how many others a triangle still
//! touches, after Akeley, Haeberli and Burns 1990 (tomesh).

/// No triangle.
const NONE: u32 = u32::MAX;

/// The indices of a strip as it grows. Three in a row are a triangle, every second one turned over; one that
/// has an index twice is none, and joins what is beside it.
#[derive(Debug, Default)]
pub struct Strip {
    /// How many indices there are so far, and the last of them.
    count: u64,
    last: Option<u32>,
}

/// Triangles, and which of them touch.
struct Triangles {
    corners: Vec<[u32; 3]>,
    /// For each side, which goes from a corner to the next, the side of the other triangle there, as
    /// `3 * triangle + side`.
    beside: Vec<u32>,
    is_done: Vec<bool>,
    /// How many that are not done each touches.
    free: Vec<u8>,
}

/// A way through triangles that touch.
#[derive(Default)]
struct Way {
    triangles: Vec<u32>,
    indices: Vec<u32>,
}

impl Strip {
    /// The indices that go on with those triangles: all that have three corners, each as it turns.
    pub fn extended(&mut self, triangles: &[[u32; 3]]) -> Vec<u32> {
        let mut all = Triangles::new(triangles);
        let mut waiting = Waiting::new(&all.free);
        let mut indices = Vec::with_capacity(2 * triangles.len());
        let mut ways = [(); 3].map(|()| Way::default());
        let mut is_taken = vec![false; all.corners.len()];
        while let Some(start) = waiting.next(&all) {
            let is_odd = (self.count + indices.len() as u64) % 2 == 1;
            let last = indices.last().copied().or(self.last);
            for (corner, way) in ways.iter_mut().enumerate() {
                all.walk(start, corner, is_odd, way, &mut is_taken);
            }
            // The longest; of these that which names fewest, and of these that which is at hand.
            let rank = |way: &Way| {
                let is_far = way.indices.first().copied() != last;
                (way.triangles.len(), usize::MAX - way.indices.len(), !is_far)
            };
            let best = (0..3).rev().max_by_key(|&corner| rank(&ways[corner])).unwrap_or(0);
            let way = &ways[best];
            // Two indices more part what follows from what is before, one where they have the last in common;
            // then every second triangle is turned over as the way has it.
            if let (Some(last), Some(&first)) = (last, way.indices.first())
                && last != first
            {
                indices.extend([last, first]);
            }
            indices.extend(&way.indices);
            all.finish(&way.triangles, &mut waiting);
        }
        self.count += indices.len() as u64;
        self.last = indices.last().copied().or(self.last);
        indices
    }
}

impl Triangles {
    fn new(triangles: &[[u32; 3]]) -> Self {
        let has_corners = |[a, b, c]: &&[u32; 3]| a != b && b != c && c != a;
        let corners: Vec<[u32; 3]> = triangles.iter().filter(has_corners).copied().collect();
        // Sides by their ends, the lesser first, and whether they run that way.
        let side = |number: u32| {
            let of = corners[number as usize / 3];
            let (from, to) = (of[number as usize % 3], of[(number as usize + 1) % 3]);
            ([from.min(to), from.max(to)], from > to, number)
        };
        let mut sides: Vec<([u32; 2], bool, u32)> = (0..3 * corners.len() as u32).map(side).collect();
        sides.sort_unstable();
        let mut beside = vec![NONE; sides.len()];
        for seam in sides.chunk_by(|a, b| a.0 == b.0) {
            let forth = seam.partition_point(|side| !side.1);
            for (&(.., a), &(.., b)) in seam[..forth].iter().zip(&seam[forth..]) {
                (beside[a as usize], beside[b as usize]) = (b, a);
            }
        }
        let touches = |sides: &[u32]| sides.iter().filter(|side| **side != NONE).count() as u8;
        let free = beside.chunks_exact(3).map(touches).collect();
        Self { is_done: vec![false; corners.len()], corners, beside, free }
    }

    /// The way from a triangle across the side that faces one of its corners, up to where no triangle is
    /// left. `is_odd` says whether the first one is turned over.
    fn walk(&self, start: u32, corner: usize, is_odd: bool, way: &mut Way, is_taken: &mut [bool]) {
        let Way { triangles, indices } = way;
        triangles.clear();
        indices.clear();
        let of = self.corners[start as usize];
        let [mut first, b, c] = [0, 1, 2].map(|k| of[(corner + k) % 3]);
        let [mut second, mut third] = if is_odd { [c, b] } else { [b, c] };
        indices.extend([first, second, third]);
        let mut at = start;
        loop {
            is_taken[at as usize] = true;
            triangles.push(at);
            let ahead = self.across(at, first, is_taken);
            let aside = self.across(at, second, is_taken).filter(|_| at != start);
            let free = |side: u32| self.free[side as usize / 3];
            // Where both are left, to that which has less to go on to.
            let turns = match (ahead, aside) {
                (Some(ahead), Some(aside)) => free(aside) < free(ahead),
                (None, Some(_)) => true,
                _ => false,
            };
            let Some(side) = (if turns { aside } else { ahead }) else { break };
            if turns {
                // The first corner once more, before the last: the triangle is the same, turned over twice.
                indices.pop();
                indices.extend([first, third]);
                second = first;
            }
            let (next, place) = (side / 3, side as usize % 3);
            let last = self.corners[next as usize][(place + 2) % 3];
            indices.push(last);
            (first, second, third, at) = (second, third, last, next);
        }
        for &triangle in triangles.iter() {
            is_taken[triangle as usize] = false;
        }
    }

    /// The side of the triangle that is left beside another one, across from one of its corners.
    fn across(&self, triangle: u32, corner: u32, is_taken: &[bool]) -> Option<u32> {
        let place = self.corners[triangle as usize].iter().position(|of| *of == corner)?;
        let side = self.beside[3 * triangle as usize + (place + 1) % 3];
        let is_left = |side: &u32| {
            let other = *side as usize / 3;
            *side != NONE && !self.is_done[other] && !is_taken[other]
        };
        Some(side).filter(is_left)
    }

    /// Takes triangles out.
    fn finish(&mut self, triangles: &[u32], waiting: &mut Waiting) {
        for &triangle in triangles {
            self.is_done[triangle as usize] = true;
        }
        for &triangle in triangles {
            for &side in &self.beside[3 * triangle as usize..][..3] {
                let other = side as usize / 3;
                if side != NONE && !self.is_done[other] {
                    self.free[other] -= 1;
                    waiting.add(side / 3, self.free[other]);
                }
            }
        }
    }
}

/// Triangles that are left, by how many others they touch.
struct Waiting([Vec<u32>; 4]);

impl Waiting {
    fn new(free: &[u8]) -> Self {
        let mut waiting = Self(Default::default());
        for (triangle, &free) in free.iter().enumerate().rev() {
            waiting.add(triangle as u32, free);
        }
        waiting
    }

    fn add(&mut self, triangle: u32, free: u8) {
        self.0[usize::from(free)].push(triangle);
    }

    /// One that touches fewest others: of these that which came last.
    fn next(&mut self, all: &Triangles) -> Option<u32> {
        for (free, triangles) in self.0.iter_mut().enumerate() {
            while let Some(triangle) = triangles.pop() {
                // It may have been taken since, or touch fewer.
                let at = triangle as usize;
                if !all.is_done[at] && usize::from(all.free[at]) == free {
                    return Some(triangle);
                }
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use relief_core::mesh::square;

    use super::*;

    /// The triangles of a strip, each with its least corner first, in order.
    fn decoded(indices: &[u32]) -> Vec<[u32; 3]> {
        let triangles = indices.windows(3).enumerate().filter_map(|(at, window)| {
            let [a, b, c] = [window[0], window[1 + at % 2], window[2 - at % 2]];
            (a != b && b != c && c != a).then_some([a, b, c])
        });
        sorted(&triangles.collect::<Vec<_>>())
    }

    fn sorted(triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
        let turned = |[a, b, c]: &[u32; 3]| [[*a, *b, *c], [*b, *c, *a], [*c, *a, *b]].into_iter().min();
        let mut all: Vec<[u32; 3]> = triangles.iter().filter_map(turned).collect();
        all.sort_unstable();
        all
    }

    /// Rows of so many cells.
    fn grid(cells: u32) -> Vec<[u32; 3]> {
        square(cells).expect("a mesh").triangles().to_vec()
    }

    #[test]
    fn a_strip_has_the_very_triangles() {
        let mut fan: Vec<[u32; 3]> = (1..9).map(|k| [0, k, k + 1]).collect();
        fan.push([0, 9, 1]);
        let lists = [
            grid(35),
            fan,
            // Pieces apart, one twice, sides that run the same way, and three at an edge.
            vec![[9, 7, 8], [1, 2, 3], [1, 2, 3], [2, 3, 5], [3, 2, 6], [3, 2, 4], [10, 11, 12]],
            vec![[0, 1, 2]],
            Vec::new(),
        ];
        for triangles in &lists {
            for size in [1, 2, 7, usize::MAX] {
                let mut strip = Strip::default();
                let mut indices = Vec::new();
                for part in triangles.chunks(size.min(triangles.len().max(1))) {
                    indices.extend(strip.extended(part));
                    assert_eq!(strip.count, indices.len() as u64);
                }
                assert_eq!(decoded(&indices), sorted(triangles), "{size}");
                // One index less, and all that follow are turned over.
                if triangles.len() > 1 {
                    assert_ne!(decoded(&indices[1..]), sorted(triangles), "{size}");
                }
            }
        }
    }

    #[test]
    fn rows_take_little_more_than_an_index_a_triangle() {
        let triangles = grid(90);
        let count = Strip::default().extended(&triangles).len();
        assert!(count * 100 < triangles.len() * 105, "{count}");
        // Around one corner each triangle but the first turns.
        let fan: Vec<[u32; 3]> = (1..100).map(|k| [0, k, k + 1]).collect();
        assert!(Strip::default().extended(&fan).len() <= 200);
    }

    #[test]
    fn triangles_without_three_corners_are_left_out() {
        assert!(Strip::default().extended(&[[3, 3, 4], [5, 6, 5], [7, 7, 7]]).is_empty());
        let mut strip = Strip::default();
        let indices = [strip.extended(&[[0, 1, 2], [2, 2, 1]]), strip.extended(&[[3, 3, 3]])].concat();
        assert_eq!((decoded(&indices), indices.len()), (vec![[0, 1, 2]], 3));
    }
}
