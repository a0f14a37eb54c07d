//! Triangle order for a GPU's vertex cache, in which most corners are still in the cache.
//!
//! Source: Sander, Nehab and Barczak 2007, Fast Triangle Reordering for Vertex Locality and Reduced
//! Overdraw, section 4 (Tipsify).

use std::collections::VecDeque;

/// Vertices in the cache that the order is made for. Larger caches hit more often, smaller ones
/// hardly less often.
const CACHE: u32 = 16;

/// Time at which the first vertex enters the cache. Vertices that never entered count as evicted
/// long ago.
const BEGIN: u32 = CACHE + 1;

/// No vertex.
const NONE: u32 = u32::MAX;

/// The triangles around each vertex.
struct Around {
    /// Index of each vertex's first triangle in `triangles`, and the end of the last list.
    first: Vec<u32>,
    triangles: Vec<u32>,
}

impl Around {
    fn new(triangles: &[[u32; 3]], vertices: usize) -> Self {
        let mut first = vec![0_u32; vertices + 1];
        for &corner in triangles.as_flattened() {
            first[corner as usize] += 1;
        }
        let mut sum = 0;
        for at in &mut first {
            sum += *at;
            *at = sum;
        }
        // Backward, so that each vertex has its triangles in their own order.
        let mut around = vec![0; sum as usize];
        for (triangle, corners) in triangles.iter().enumerate().rev() {
            for &corner in corners.iter().rev() {
                let at = &mut first[corner as usize];
                *at -= 1;
                around[*at as usize] = triangle as u32;
            }
        }
        Self { first, triangles: around }
    }

    fn of(&self, vertex: u32) -> &[u32] {
        let [from, to] = [vertex, vertex + 1].map(|vertex| self.first[vertex as usize] as usize);
        &self.triangles[from..to]
    }
}

/// A cache that holds the last vertices that were fetched.
struct Cache {
    /// Time at which each vertex entered the cache.
    entered: Vec<u32>,
    now: u32,
}

impl Cache {
    fn new(vertices: usize) -> Self {
        Self { entered: vec![0; vertices], now: BEGIN }
    }

    /// Returns the number of vertices that entered after `vertex`.
    fn age(&self, vertex: u32) -> u32 {
        self.now - self.entered[vertex as usize]
    }

    fn fetch(&mut self, vertex: u32) {
        if self.age(vertex) > CACHE {
            self.entered[vertex as usize] = self.now;
            self.now += 1;
        }
    }

    /// Returns the time after all `triangles` are fetched in order: [`BEGIN`] plus the misses.
    fn misses(triangles: &[[u32; 3]], vertices: usize) -> u32 {
        let mut cache = Self::new(vertices);
        triangles.as_flattened().iter().for_each(|&corner| cache.fetch(corner));
        cache.now
    }
}

/// Returns an order of `triangles` in which a cache holds more of their corners, as triangle
/// numbers.
///
/// The order is made of fans: all triangles around one vertex, then around another. The next vertex
/// is one that stays in the cache until its fan is whole. Returns `None` where the given order has
/// no more misses, as in grids whose rows are no longer than the cache. `vertices` is the number of
/// vertices.
pub fn cache_order(triangles: &[[u32; 3]], vertices: usize) -> Option<Vec<u32>> {
    let (order, misses) = fans(triangles, vertices);
    (misses < Cache::misses(triangles, vertices)).then_some(order)
}

/// Returns fans around vertices, and the cache's time after them: see [`Cache::misses`].
fn fans(triangles: &[[u32; 3]], vertices: usize) -> (Vec<u32>, u32) {
    let around = Around::new(triangles, vertices);
    // Triangles around each vertex that are not in the order yet.
    let mut live: Vec<u32> = around.first.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let mut cache = Cache::new(vertices);
    let mut is_done = vec![false; triangles.len()];
    let mut order = Vec::with_capacity(triangles.len());
    let (mut recent, mut ring): (Vec<u32>, Vec<u32>) = (Vec::new(), Vec::new());
    let (mut fan, mut next_unseen) = (if vertices == 0 { NONE } else { 0 }, 0);
    while fan != NONE {
        ring.clear();
        for &triangle in around.of(fan) {
            if std::mem::replace(&mut is_done[triangle as usize], true) {
                continue;
            }
            order.push(triangle);
            for corner in triangles[triangle as usize] {
                recent.push(corner);
                ring.push(corner);
                live[corner as usize] -= 1;
                cache.fetch(corner);
            }
        }
        // The oldest vertex of the ring that stays in the cache until its fan is whole.
        let mut best = (NONE, 0);
        for &vertex in &ring {
            let count = live[vertex as usize];
            if count == 0 {
                continue;
            }
            let age = cache.age(vertex);
            let rank = 1 + if age + 2 * count <= CACHE { age } else { 0 };
            if rank > best.1 {
                best = (vertex, rank);
            }
        }
        fan = best.0;
        // A dead end: takes the latest vertex with triangles left, else the first one.
        while fan == NONE {
            if let Some(vertex) = recent.pop() {
                if live[vertex as usize] > 0 {
                    fan = vertex;
                }
            } else if next_unseen < vertices {
                if live[next_unseen] > 0 {
                    fan = next_unseen as u32;
                }
                next_unseen += 1;
            } else {
                break;
            }
        }
    }
    (order, cache.now)
}

/// Returns the vertices that a cache fetches per triangle on average (average cache miss ratio).
///
/// The cache holds the last `cache` vertices that it fetched. About 0.5 is the least for large
/// meshes, 3 the most.
///
/// ```
/// use relief_mesh::cache_misses;
///
/// assert_eq!(cache_misses([[0, 1, 2], [2, 1, 3]], 16), 2.0);
/// ```
pub fn cache_misses(triangles: impl IntoIterator<Item = [u32; 3]>, cache: usize) -> f64 {
    let (mut held, mut fetched, mut count) = (VecDeque::with_capacity(cache + 1), 0_u64, 0_u64);
    for corners in triangles {
        count += 1;
        for corner in corners {
            if !held.contains(&corner) {
                fetched += 1;
                held.push_back(corner);
                if held.len() > cache {
                    held.pop_front();
                }
            }
        }
    }
    fetched as f64 / count.max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(across: u32, down: u32) -> Vec<[u32; 3]> {
        let cell = |i: u32, j: u32| {
            let [here, below] = [j * (across + 1) + i, (j + 1) * (across + 1) + i];
            [[here, below, below + 1], [here, below + 1, here + 1]]
        };
        (0..down).flat_map(|j| (0..across).flat_map(move |i| cell(i, j))).collect()
    }

    #[test]
    fn every_triangle_comes_once_and_few_vertices_twice() {
        let triangles = grid(100, 80);
        let order = cache_order(&triangles, 101 * 81).expect("rows are longer than the cache");
        let mut sorted = order.clone();
        sorted.sort_unstable();
        assert!(sorted.into_iter().eq(0..triangles.len() as u32));
        let ordered = || order.iter().map(|&at| triangles[at as usize]);
        let [before, after] = [cache_misses(triangles.iter().copied(), 16), cache_misses(ordered(), 16)];
        assert!(before > 0.99 && after < 0.75, "{before} {after}");
        assert!(cache_misses(ordered(), 32) <= after);
        let again: Vec<[u32; 3]> = ordered().collect();
        let misses = cache_misses(again.iter().copied(), CACHE as usize) * again.len() as f64;
        assert_eq!(Cache::misses(&again, 101 * 81) - BEGIN, misses.round() as u32);
        // Rows that are shorter than the cache are as good as can be.
        assert!(cache_order(&grid(5, 400), 6 * 401).is_none());
    }

    #[test]
    fn every_triangle_comes_back_once() {
        assert!(cache_order(&[], 0).is_none() && cache_order(&[], 5).is_none());
        // A triangle without an area, one twice, vertices of none, and pieces apart.
        let triangles = [[7, 7, 7], [1, 2, 3], [1, 2, 3], [9, 8, 9], [3, 2, 5]];
        let (mut order, _) = fans(&triangles, 12);
        order.sort_unstable();
        assert_eq!(order, [0, 1, 2, 3, 4]);
    }
}
