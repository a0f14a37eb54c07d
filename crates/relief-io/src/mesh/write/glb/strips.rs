//! Conversion of triangles to one strip.
//!
//! Source: Gumhold and Hüttner 1999, section 2.2, the stripping unit: a sequential strip that
//! repeats a recent vertex to turn (`ref`), and starts again (`init`) where it ends. There the
//! sweep gives the next triangle. Here it is chosen by the number of other triangles that a
//! triangle still touches, after Akeley, Haeberli and Burns 1990 (tomesh).

/// Marks a side without a neighbour.
const NONE: u32 = u32::MAX;

/// State of a growing strip. Three indices in a row are a triangle, every second one reversed. A
/// triangle with a repeated index is degenerate, and joins its neighbours.
#[derive(Debug, Default)]
pub struct Strip {
    /// Number of indices so far, and the last of them.
    count: u64,
    last: Option<u32>,
}

/// Triangles with their adjacency.
struct Triangles {
    corners: Vec<[u32; 3]>,
    /// For each side, from a corner to the next, the side of the neighbouring triangle as `3 *
    /// triangle + side`.
    beside: Vec<u32>,
    is_done: Vec<bool>,
    /// Number of neighbours of each triangle that are not done.
    free: Vec<u8>,
}

/// Sequence of adjacent triangles, with the indices of its strip.
#[derive(Default)]
struct Walk {
    triangles: Vec<u32>,
    indices: Vec<u32>,
}

impl Strip {
    /// Returns the indices that extend the strip by all given triangles with three different
    /// corners, with their orientation.
    pub fn extended(&mut self, triangles: &[[u32; 3]]) -> Vec<u32> {
        let mut all = Triangles::new(triangles);
        let mut queue = StartQueue::new(&all.free);
        let mut indices = Vec::with_capacity(2 * triangles.len());
        let mut walks = [(); 3].map(|()| Walk::default());
        let mut is_taken = vec![false; all.corners.len()];
        while let Some(start) = queue.next(&all) {
            let is_odd = (self.count + indices.len() as u64) % 2 == 1;
            let last = indices.last().copied().or(self.last);
            for (corner, walk) in walks.iter_mut().enumerate() {
                all.walk(start, corner, is_odd, walk, &mut is_taken);
            }
            // The longest walk is best; then the one with the fewest indices; then one that begins
            // at the last index.
            let rank = |walk: &Walk| {
                let is_far = walk.indices.first().copied() != last;
                (walk.triangles.len(), usize::MAX - walk.indices.len(), !is_far)
            };
            let best = (0..3).rev().max_by_key(|&corner| rank(&walks[corner])).unwrap_or(0);
            let walk = &walks[best];
            // Two more indices separate the walk from the strip before it. If that strip ends with
            // the walk's first index, its repetition is enough; then every second triangle is
            // reversed as the walk has it.
            if let (Some(last), Some(&first)) = (last, walk.indices.first())
                && last != first
            {
                indices.extend([last, first]);
            }
            indices.extend(&walk.indices);
            all.finish(&walk.triangles, &mut queue);
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
        // Sides by their ends, the lesser first, and whether they run the other way.
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

    /// Walks from a triangle across the side that faces one of its corners, until no triangle is
    /// left. `is_odd` says whether the first one is reversed.
    fn walk(&self, start: u32, corner: usize, is_odd: bool, walk: &mut Walk, is_taken: &mut [bool]) {
        let Walk { triangles, indices } = walk;
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
            // If both neighbours are left, the walk goes to the one with fewer free neighbours.
            let turns = match (ahead, aside) {
                (Some(ahead), Some(aside)) => free(aside) < free(ahead),
                (None, Some(_)) => true,
                _ => false,
            };
            let Some(side) = (if turns { aside } else { ahead }) else { break };
            if turns {
                // The first corner is repeated before the last one: the triangle stays the same,
                // reversed twice.
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

    /// Returns the side of the remaining triangle that lies across from a triangle's corner.
    fn across(&self, triangle: u32, corner: u32, is_taken: &[bool]) -> Option<u32> {
        let place = self.corners[triangle as usize].iter().position(|of| *of == corner)?;
        let side = self.beside[3 * triangle as usize + (place + 1) % 3];
        let is_left = |side: &u32| {
            let other = *side as usize / 3;
            *side != NONE && !self.is_done[other] && !is_taken[other]
        };
        Some(side).filter(is_left)
    }

    /// Marks triangles as done.
    fn finish(&mut self, triangles: &[u32], queue: &mut StartQueue) {
        for &triangle in triangles {
            self.is_done[triangle as usize] = true;
        }
        for &triangle in triangles {
            for &side in &self.beside[3 * triangle as usize..][..3] {
                let other = side as usize / 3;
                if side != NONE && !self.is_done[other] {
                    self.free[other] -= 1;
                    queue.add(side / 3, self.free[other]);
                }
            }
        }
    }
}

/// Remaining triangles, by the number of others that they touch.
struct StartQueue([Vec<u32>; 4]);

impl StartQueue {
    fn new(free: &[u8]) -> Self {
        let mut queue = Self(Default::default());
        for (triangle, &free) in free.iter().enumerate().rev() {
            queue.add(triangle as u32, free);
        }
        queue
    }

    fn add(&mut self, triangle: u32, free: u8) {
        self.0[usize::from(free)].push(triangle);
    }

    /// Returns the triangle that touches the fewest others; of several, the one that was added
    /// last.
    fn next(&mut self, all: &Triangles) -> Option<u32> {
        for (free, triangles) in self.0.iter_mut().enumerate() {
            while let Some(triangle) = triangles.pop() {
                // It may have been done since, or touch fewer now.
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

    /// Triangles of a strip, each with its least corner first, in order.
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

    /// Grid with `cells` cells a side.
    fn grid(cells: u32) -> Vec<[u32; 3]> {
        square(cells).expect("a mesh").triangles().to_vec()
    }

    #[test]
    fn strips_have_the_same_triangles() {
        let mut fan: Vec<[u32; 3]> = (1..9).map(|k| [0, k, k + 1]).collect();
        fan.push([0, 9, 1]);
        let lists = [
            grid(35),
            fan,
            // Separate pieces, one twice, sides that run the same way, and three at an edge.
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
                // Without one index all later triangles are reversed.
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
