//! A maximum pyramid of texels, for searches of one direction or one vertex at a time. The cone
//! search and the kind `frustum` use it.

use std::borrow::Cow;

use rayon::prelude::*;
use relief_core::HeightMap;

/// Highest texels of squares of texels, level by level. Level 0 holds the texels. These maxima are
/// tighter than maxima over dual cells, which share their texels with their neighbours.
pub struct TexelPyramid<'a> {
    texels: TexelLevel<'a>,
    above: Vec<TexelLevel<'a>>,
}

/// Nodes of a level, row by row.
pub struct TexelLevel<'a> {
    nodes: Cow<'a, [f32]>,
    size: [u32; 2],
}

impl<'a> TexelPyramid<'a> {
    /// Builds the levels of a map.
    pub fn new(map: &'a HeightMap) -> Self {
        let texels = TexelLevel { nodes: Cow::Borrowed(map.texels()), size: [map.width(), map.height()] };
        let mut above: Vec<TexelLevel> = Vec::new();
        while let Some(halved) = above.last().unwrap_or(&texels).halved() {
            above.push(halved);
        }
        Self { texels, above }
    }

    /// Returns a level, up to [`Self::top`].
    #[inline]
    pub fn level(&self, level: u32) -> &TexelLevel<'a> {
        if level == 0 { &self.texels } else { &self.above[level as usize - 1] }
    }

    /// Returns the level of a single node.
    pub fn top(&self) -> u32 {
        self.above.len() as u32
    }
}

impl TexelLevel<'_> {
    /// Returns columns and rows of nodes.
    #[inline]
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Returns the highest texel of a node.
    #[inline]
    pub fn highest(&self, [column, row]: [u32; 2]) -> f32 {
        self.nodes[row as usize * self.size[0] as usize + column as usize]
    }

    /// Builds the level of half the size, rounded up; `None` above a single node.
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
