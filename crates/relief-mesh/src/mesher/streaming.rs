//! Streaming of a mesh, block by block or as a whole.

use std::convert::Infallible;

use glam::Vec2;
use rayon::prelude::*;
use relief_core::Watch;
use relief_core::mesh::{Mesh, MeshBlock};

use super::block::FinishedBlock;
use super::{BLOCKS_PER_THREAD, EMPTY, Mesher};
use crate::crack::CrackTest;
use crate::folds::{FoldedBase, Folds};
use crate::plan::Work;
use crate::smooth::Normals;
use crate::{Bounds, Rounded, Shading, Stream, StreamError, Streamed};

impl Mesher {
    /// Streams the mesh block by block. The order of blocks is always the same.
    ///
    /// # Errors
    ///
    /// Fails if the sink fails, when cancelled, or if a vertex lies beyond the range of `f32`. The
    /// blocks streamed until then are unusable.
    pub fn stream<E>(
        &self,
        how: &Stream,
        mut sink: impl FnMut(&MeshBlock) -> Result<(), E>,
    ) -> Result<Streamed, StreamError<E>> {
        let mut normals = None;
        // With normals of the triangles the mesh is made twice.
        let mut watch = how.watch;
        if self.shading == Shading::Mesh {
            watch = how.watch.piece(0.5, 1.0);
            let mut sums = Normals::new(self.all_vertices);
            let watch = how.watch.piece(0.0, 0.5);
            let plain = Stream { check: false, grid: None, cache_order: false, watch, ..*how };
            self.each_block(&plain, None, |finished| {
                sums.add(finished.block.positions(), &finished.smooth);
                Ok(())
            })?;
            normals = Some(sums);
        }
        let mut test = how.check.then(CrackTest::default);
        let (mut bounds_m, mut rounded) = (EMPTY, Rounded::default());
        let (mut folds, mut folds_below) = (Folds::default(), Folds::default());
        self.each_block(&Stream { watch, ..*how }, normals.as_ref(), |finished| {
            if let (Some(test), Some(part)) = (&mut test, finished.part.take()) {
                test.add(part);
            }
            let [least, greatest] = finished.bounds_m;
            bounds_m = [bounds_m[0].min(least), bounds_m[1].max(greatest)];
            for (folds, all) in [(&mut folds, &finished.folds), (&mut folds_below, &finished.folds_below)] {
                for found in all {
                    let middle_m = self.pose.position(found.middle_m, how.size);
                    folds.add(FoldedBase { middle_m, ..*found });
                }
            }
            rounded = rounded.with(finished.rounded);
            sink(&finished.block).map_err(StreamError::Sink)
        })?;
        Ok(Streamed {
            bounds_m,
            cracks: test.map(CrackTest::finish),
            folds,
            folds_below,
            rounded: how.grid.map(|_| rounded),
        })
    }

    /// Returns the bounds of the vertices, scaled by `size`. The whole mesh is made for it and
    /// discarded.
    ///
    /// # Errors
    ///
    /// Fails when cancelled, or if a vertex lies beyond the range of `f32`.
    pub fn bounds(&self, size: f64, watch: &Watch) -> Result<Bounds, StreamError<Infallible>> {
        let how = Stream { size, check: false, grid: None, cache_order: false, watch: *watch };
        let mut bounds = Bounds { positions_m: EMPTY, uvs: [Vec2::INFINITY, Vec2::NEG_INFINITY] };
        self.each_block(&how, None, |finished| {
            let ([least, greatest], [low, high]) = (finished.bounds_m, bounds.positions_m);
            bounds.positions_m = [low.min(least), high.max(greatest)];
            for vertex in &finished.block.vertices {
                bounds.uvs = [bounds.uvs[0].min(vertex.uv), bounds.uvs[1].max(vertex.uv)];
            }
            Ok(())
        })?;
        Ok(bounds)
    }

    /// Returns the whole mesh.
    ///
    /// # Errors
    ///
    /// Fails if a vertex lies beyond the range of `f32`, or if the mesh does not fit into memory.
    pub fn mesh(&self) -> Result<Mesh, StreamError<Infallible>> {
        let watch = Watch::none();
        let how = Stream { size: 1.0, check: false, grid: None, cache_order: false, watch };
        let mut vertices = reserved("vertices", self.vertices)?;
        let mut triangles = reserved("triangles", self.triangles)?;
        self.stream(&how, |block| {
            vertices.extend_from_slice(&block.vertices);
            triangles.extend_from_slice(&block.triangles);
            Ok(())
        })?;
        Ok(Mesh::new(vertices, triangles)?)
    }

    /// Makes a group of blocks in parallel. It does not depend on the sink's type, so that it is
    /// compiled here, once.
    fn finished_blocks(
        &self,
        group: &[Work],
        how: &Stream,
        normals: Option<&Normals>,
        into: Vec<MeshBlock>,
    ) -> Vec<Option<FinishedBlock>> {
        let each = group.par_iter().zip(into);
        each.map(|(work, block)| self.finished_block(work, how, normals, block)).collect()
    }

    /// Makes all blocks, a group at a time, and passes them to `take` one after the other.
    fn each_block<E>(
        &self,
        how: &Stream,
        normals: Option<&Normals>,
        mut take: impl FnMut(&mut FinishedBlock) -> Result<(), StreamError<E>>,
    ) -> Result<(), StreamError<E>> {
        let at_once = rayon::current_num_threads() * BLOCKS_PER_THREAD;
        let mut groups = self.blocks.chunks(at_once);
        let (mut done, mut ready) = (0, Vec::new());
        let mut spare: Vec<MeshBlock> = Vec::new();
        loop {
            how.watch.check()?;
            let group = groups.next().unwrap_or_default();
            let mut next: Vec<Option<FinishedBlock>> = Vec::new();
            spare.resize_with(group.len().max(spare.len()), MeshBlock::default);
            let into = spare.split_off(spare.len() - group.len());
            // Finished blocks are taken while the next ones are made.
            let taken: Result<(), StreamError<E>> = rayon::in_place_scope(|scope| {
                if !group.is_empty() {
                    scope.spawn(|_| next = self.finished_blocks(group, how, normals, into));
                }
                ready.drain(..).try_for_each(|finished: Option<FinishedBlock>| {
                    let mut finished = finished.ok_or(StreamError::NotFinite)?;
                    take(&mut finished)?;
                    done += 1;
                    spare.push(finished.block);
                    Ok(())
                })
            });
            taken?;
            // There may be none at all.
            how.watch.at(done as f32 / self.blocks.len().max(1) as f32)?;
            if group.is_empty() {
                return Ok(());
            }
            ready = next;
        }
    }
}

/// Returns an empty list with capacity for `count` items, if the memory can be had.
fn reserved<T>(what: &'static str, count: u64) -> Result<Vec<T>, StreamError<Infallible>> {
    let mut list = Vec::new();
    let result = usize::try_from(count).ok().and_then(|count| list.try_reserve_exact(count).ok());
    result.map(|()| list).ok_or(StreamError::OutOfMemory { count, what })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_that_no_memory_holds_is_refused() {
        assert!(reserved::<u64>("vertices", 3).is_ok_and(|list| list.capacity() >= 3));
        let refused = reserved::<u64>("vertices", u64::MAX / 4).map(drop);
        assert!(matches!(refused, Err(StreamError::OutOfMemory { what: "vertices", .. })), "{refused:?}");
    }
}
