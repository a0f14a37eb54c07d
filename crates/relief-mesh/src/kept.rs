//! What is left of a mesh some of whose triangles are left out: over holes, or since nothing sees them.

/// Vertices of a bit set's word.
const WORD: u32 = u64::BITS;

/// The vertices that triangles have which are not left out, numbered without the others.
#[derive(Debug)]
pub struct Kept {
    /// A bit for each vertex.
    words: Vec<u64>,
    /// How many vertices are kept before each word.
    before: Vec<u32>,
    triangles: u64,
}

impl Kept {
    /// What is left of so many vertices, which are no more than 32-bit numbers count, before any triangle.
    pub fn of_none(vertices: u64) -> Self {
        Self { words: vec![0; vertices.div_ceil(WORD.into()) as usize], before: Vec::new(), triangles: 0 }
    }

    /// Keeps some triangles with their corners.
    pub fn add(&mut self, triangles: &[[u32; 3]]) {
        self.triangles += triangles.len() as u64;
        for corner in triangles.as_flattened() {
            self.words[(corner / WORD) as usize] |= 1 << (corner % WORD);
        }
    }

    /// Keeps more vertices, with the numbers after those of the first `vertices`.
    pub fn add_vertices(&mut self, vertices: u64, more: u32) {
        let end = vertices + u64::from(more);
        self.words.resize(end.div_ceil(WORD.into()) as usize, 0);
        for vertex in vertices..end {
            self.words[(vertex / u64::from(WORD)) as usize] |= 1 << (vertex % u64::from(WORD));
        }
    }

    /// Numbers what was kept.
    pub fn count(&mut self) {
        self.before.clear();
        let mut sum = 0;
        for word in &self.words {
            self.before.push(sum);
            sum += word.count_ones();
        }
    }

    /// Whether a vertex is kept.
    pub fn contains(&self, vertex: u32) -> bool {
        self.words[(vertex / WORD) as usize] >> (vertex % WORD) & 1 == 1
    }

    /// The number of a vertex among those that are kept.
    pub fn number(&self, vertex: u32) -> u32 {
        let word = (vertex / WORD) as usize;
        let earlier = self.words[word] & ((1 << (vertex % WORD)) - 1);
        self.before[word] + earlier.count_ones()
    }

    /// How many vertices are kept.
    pub fn vertices(&self) -> u64 {
        self.words.iter().map(|word| u64::from(word.count_ones())).sum()
    }

    /// How many triangles.
    pub fn triangles(&self) -> u64 {
        self.triangles
    }

    /// Bytes that are held of so many vertices.
    pub fn bytes(vertices: u64) -> u64 {
        vertices.div_ceil(WORD.into()) * (size_of::<u64>() + size_of::<u32>()) as u64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vertices_are_numbered_without_those_that_are_left_out() {
        let mut kept = Kept::of_none(200);
        let triangles = [[0, 63, 64], [64, 65, 199], [7, 63, 128]];
        kept.add(&triangles[..2]);
        kept.add(&triangles[2..]);
        kept.count();
        let all: Vec<u32> = (0..200).filter(|&vertex| kept.contains(vertex)).collect();
        assert_eq!(all, [0, 7, 63, 64, 65, 128, 199]);
        let numbers: Vec<u32> = all.iter().map(|&vertex| kept.number(vertex)).collect();
        assert_eq!(numbers, [0, 1, 2, 3, 4, 5, 6]);
        assert_eq!((kept.vertices(), kept.triangles()), (7, 3));
        kept.add_vertices(200, 3);
        kept.count();
        assert_eq!([200, 201, 202].map(|vertex| kept.number(vertex)), [7, 8, 9]);
        assert_eq!(kept.vertices(), 10);
    }
}
