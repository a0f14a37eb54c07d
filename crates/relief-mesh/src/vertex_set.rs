//! Set of the vertices that remain where triangles are left out: over holes, or because no camera
//! sees them.

/// Vertices per word of the bit set.
const WORD: u32 = u64::BITS;

/// Set of the vertices of remaining triangles, with consecutive numbers.
#[derive(Debug)]
pub struct VertexSet {
    /// One bit for each vertex.
    words: Vec<u64>,
    /// Number of the set's vertices before each word.
    before: Vec<u32>,
    triangles: u64,
}

impl VertexSet {
    /// Creates an empty set over `vertices` vertices, at most 2^32.
    pub fn empty(vertices: u64) -> Self {
        Self { words: vec![0; vertices.div_ceil(WORD.into()) as usize], before: Vec::new(), triangles: 0 }
    }

    /// Adds triangles and their corners.
    pub fn add(&mut self, triangles: &[[u32; 3]]) {
        self.triangles += triangles.len() as u64;
        for corner in triangles.as_flattened() {
            self.words[(corner / WORD) as usize] |= 1 << (corner % WORD);
        }
    }

    /// Adds `more` vertices, numbered after the first `vertices`.
    pub fn add_vertices(&mut self, vertices: u64, more: u32) {
        let end = vertices + u64::from(more);
        self.words.resize(end.div_ceil(WORD.into()) as usize, 0);
        for vertex in vertices..end {
            self.words[(vertex / u64::from(WORD)) as usize] |= 1 << (vertex % u64::from(WORD));
        }
    }

    /// Numbers the set's vertices.
    pub fn count(&mut self) {
        self.before.clear();
        let mut sum = 0;
        for word in &self.words {
            self.before.push(sum);
            sum += word.count_ones();
        }
    }

    /// Returns whether the set has a vertex.
    pub fn contains(&self, vertex: u32) -> bool {
        self.words[(vertex / WORD) as usize] >> (vertex % WORD) & 1 == 1
    }

    /// Returns the consecutive number of a vertex of the set.
    pub fn number(&self, vertex: u32) -> u32 {
        let word = (vertex / WORD) as usize;
        let earlier = self.words[word] & ((1 << (vertex % WORD)) - 1);
        self.before[word] + earlier.count_ones()
    }

    /// Returns the number of vertices in the set.
    pub fn vertices(&self) -> u64 {
        self.words.iter().map(|word| u64::from(word.count_ones())).sum()
    }

    /// Returns the number of triangles that were added.
    pub fn triangles(&self) -> u64 {
        self.triangles
    }

    /// Returns the size in bytes of a set over `vertices` vertices.
    pub fn bytes(vertices: u64) -> u64 {
        vertices.div_ceil(WORD.into()) * (size_of::<u64>() + size_of::<u32>()) as u64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vertices_are_numbered_without_those_that_are_left_out() {
        let mut used = VertexSet::empty(200);
        let triangles = [[0, 63, 64], [64, 65, 199], [7, 63, 128]];
        used.add(&triangles[..2]);
        used.add(&triangles[2..]);
        used.count();
        let all: Vec<u32> = (0..200).filter(|&vertex| used.contains(vertex)).collect();
        assert_eq!(all, [0, 7, 63, 64, 65, 128, 199]);
        let numbers: Vec<u32> = all.iter().map(|&vertex| used.number(vertex)).collect();
        assert_eq!(numbers, [0, 1, 2, 3, 4, 5, 6]);
        assert_eq!((used.vertices(), used.triangles()), (7, 3));
        used.add_vertices(200, 3);
        used.count();
        assert_eq!([200, 201, 202].map(|vertex| used.number(vertex)), [7, 8, 9]);
        assert_eq!(used.vertices(), 10);
    }
}
