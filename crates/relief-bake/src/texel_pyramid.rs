//! A maximum pyramid of texels, for searches of one direction or one vertex at a time: that of cones, and
//! that of the kind `frustum`.

use std::borrow::Cow;

use rayon::prelude::*;
use relief_core::HeightMap;

/// The highest texels of squares of texels, level by level; level 0 are the texels. Tighter than the maxima
/// over dual cells, which share their texels with their neighbours.
pub struct TexelPyramid<'a> {
    texels: TexelLevel<'a>,
    above: Vec<TexelLevel<'a>>,
}

/// The nodes of a level, row by row.
pub struct TexelLevel<'a> {
    nodes: Cow<'a, [f32]>,
    size: [u32; 2],
}

impl<'a> TexelPyramid<'a> {
    /// The levels of a map.
    pub fn new(map: &'a HeightMap) -> Self {
        let texels = TexelLevel { nodes: Cow::Borrowed(map.texels()), size: [map.width(), map.height()] };
        let mut above: Vec<TexelLevel> = Vec::new();
        while let Some(halved) = above.last().unwrap_or(&texels).halved() {
            above.push(halved);
        }
        Self { texels, above }
    }

    /// A level, up to [`Self::top`].
    #[inline]
    pub fn level(&self, level: u32) -> &TexelLevel<'a> {
        if level == 0 { &self.texels } else { &self.above[level as usize - 1] }
    }

    /// The level of a single node.
    pub fn top(&self) -> u32 {
        self.above.len() as u32
    }
}

impl TexelLevel<'_> {
    /// Columns and rows of nodes.
    #[inline]
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// The highest texel of a node.
    #[inline]
    pub fn highest(&self, [column, row]: [u32; 2]) -> f32 {
        self.nodes[row as usize * self.size[0] as usize + column as usize]
    }

    /// The level of half the size, rounded up; `None` above a single node.
    fn halved<'a>(&self) -> Option<TexelLevel<'a>> {
        let [width, height] = self.size;
        if self.nodes.len() == 1 {
            return None;
        }
        let size = [width.div_ceil(2), height.div_ceil(2)];
        let mut nodes = vec![0.0; size[0] as usize * size[1] as usize];
        let rows = self.nodes.par_chunks(2 * width as usize);
        nodes.par_chunks_mut(size[0] as usize).zip(rows).with_min_len(16).for_each(|(nodes, rows)| {
            for row in rows.chunks(width as usize) {
                for (node, pair) in nodes.iter_mut().zip(row.chunks(2)) {
                    *node = pair
                        .iter()
                        .fold(*node, |highest, &texel| if texel > highest { texel } else { highest });
                }
            }
        });
        Some(TexelLevel { nodes: Cow::Owned(nodes), size })
    }
}
