//! A view-dependent map as a sum of products: a factor of the texel times a factor of the view.
//!
//! A view is a direction and a bend. The texture has four terms a layer, and the factors of texels lie
//! in it as the texels do. Below them, row after row, lie the factors of the views, then the term's
//! scale in two texels, for each group of texels in turn. With groups, a first layer has the number of
//! each texel's group. All values are 0 to 1.

use rayon::prelude::*;
use relief_core::Watch;

use super::Axes;
use super::clusters::clusters;
use super::matrix::Matrix;
use super::non_negative::non_negative_factors;
use super::svd::truncated_svd;
use crate::{BakeError, Channel, Sink, quantise};

/// Number in the place of a way that meets nothing. Sums above the middle of it and 1 are misses.
const MISSED: f32 = 1.25;

/// Greatest scale of a term: the square root of its scale is a part of the root of this.
///
/// A term is a singular value times an entry of two unit vectors, so at most the length of a row of
/// the matrix: 1.25, a miss, times the root of 16,384 views. Terms of non-negative factors are at most
/// twice as much, since a row of zeros would leave out less than a greater one.
pub const MOST_SCALE: f32 = 512.0;

/// Texels of a term's scale.
const OF_SCALE: usize = 2;

/// Rounds in which non-negative factors come to rest.
const ROUNDS: usize = 40;

/// Beginning of the names of the channels of compressed maps.
pub const FACTORS: &str = "term";

/// Terms and groups of a compressed map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Compression {
    /// Terms of each texel's sum, at least 1.
    pub rank: u32,
    /// Groups of texels with factors of their own, which are not negative; 0 for one group, whose
    /// factors have both signs.
    pub clusters: u32,
}

impl Compression {
    /// Returns the layers of the texture.
    pub fn layers(&self) -> u32 {
        self.rank.div_ceil(4) + u32::from(self.clusters > 0)
    }

    /// Returns the rows below the factors of the texels of a map with these columns.
    pub fn rows_of_views(&self, axes: &Axes, columns: u32) -> u32 {
        let group = u64::from(axes.layers()) * u64::from(axes.bends) + OF_SCALE as u64;
        let texels = group * u64::from(self.clusters.max(1));
        u32::try_from(texels.div_ceil(u64::from(columns.max(1)))).unwrap_or(u32::MAX)
    }
}

/// Factors of all texels and views.
struct Compressed {
    /// The group of each texel.
    groups: Vec<usize>,
    /// A row for each texel, a column for each term; 0 to 1, or -1 to 1 without groups.
    of_texels: Matrix,
    /// The same for each view, for each group.
    of_views: Vec<Matrix>,
    /// The scale of each term, as its two codes of 8 bits, for each group.
    scales: Vec<Vec<[u32; 2]>>,
}

/// Compresses ways, a row for each view and a column for each texel, and hands the layers to the
/// sink. A way of 1 meets nothing.
pub(crate) fn write_compressed(
    mut ways: Matrix,
    compression: Compression,
    columns: u32,
    (channels, bits): (&[Channel; 4], u32),
    watch: &Watch,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    ways.values.par_iter_mut().filter(|way| **way >= 1.0).for_each(|way| *way = MISSED);
    let compressed = match compression.clusters {
        0 => by_svd(&ways, compression.rank as usize, watch)?,
        _ => by_groups(&ways, compression, watch)?,
    };
    let views = ways.rows();
    drop(ways);
    let texels = compressed.groups.len();
    let below = compressed.of_views.len() * (views + OF_SCALE);
    let size = texels + below.div_ceil(columns as usize) * columns as usize;
    let mut planes = [(); 4].map(|()| vec![0.0_f32; size]);
    if compression.clusters > 0 {
        for (value, &group) in planes[0].iter_mut().zip(&compressed.groups) {
            *value = group as f32 / 255.0;
        }
        write_layer(&mut planes, channels, bits, sink)?;
    }
    let is_signed = compression.clusters == 0;
    for first in (0..compression.rank as usize).step_by(4) {
        for (channel, plane) in planes.iter_mut().enumerate() {
            compressed.write_term(first + channel, is_signed, views, plane);
        }
        write_layer(&mut planes, channels, bits, sink)?;
    }
    Ok(())
}

/// Rounds the planes of a layer and hands them on.
fn write_layer(
    planes: &mut [Vec<f32>; 4],
    channels: &[Channel; 4],
    bits: u32,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    for (plane, channel) in planes.iter_mut().zip(channels) {
        quantise::to_nearest(plane, channel.range, bits);
    }
    sink.slice(&planes.each_ref().map(|plane| plane.as_slice()))?;
    Ok(())
}

impl Compressed {
    /// Sets a channel's plane to a term's factors.
    fn write_term(&self, term: usize, is_signed: bool, views: usize, plane: &mut [f32]) {
        let stored = |value: f32| if is_signed { 0.5 + 0.5 * value } else { value };
        let is_there = term < self.of_texels.columns;
        let factor = |matrix: &Matrix, row: usize| if is_there { stored(matrix.row(row)[term]) } else { 0.0 };
        let (above, below) = plane.split_at_mut(self.groups.len());
        for (row, value) in above.iter_mut().enumerate() {
            *value = factor(&self.of_texels, row);
        }
        let of_groups = below.chunks_exact_mut(views + OF_SCALE);
        for ((below, of_views), scales) in of_groups.zip(&self.of_views).zip(&self.scales) {
            for (row, value) in below[..views].iter_mut().enumerate() {
                *value = factor(of_views, row);
            }
            let codes = scales.get(term).copied().unwrap_or_default();
            below[views] = codes[0] as f32 / 255.0;
            below[views + 1] = codes[1] as f32 / 255.0;
        }
    }
}

/// Compresses by a singular value decomposition.
fn by_svd(ways: &Matrix, rank: usize, watch: &Watch) -> Result<Compressed, BakeError> {
    let svd = truncated_svd(ways, rank, watch)?;
    let (mut of_texels, mut of_views) = (svd.of_columns, svd.of_rows);
    let groups = vec![0; ways.columns];
    let scales = scale(&mut of_texels, &groups, std::slice::from_mut(&mut of_views));
    Ok(Compressed { groups, of_texels, of_views: vec![of_views], scales })
}

/// Compresses groups of texels that are alike by non-negative factors, each.
fn by_groups(ways: &Matrix, compression: Compression, watch: &Watch) -> Result<Compressed, BakeError> {
    const OF_CLUSTERS: f32 = 0.4;
    let [count, terms] = [compression.clusters, compression.rank].map(|count| count as usize);
    let groups = clusters(ways, count, &watch.piece(0.0, OF_CLUSTERS))?;
    let watch = watch.piece(OF_CLUSTERS, 1.0);
    let done = std::sync::atomic::AtomicUsize::new(0);
    let made: Vec<(Vec<usize>, Matrix, Matrix)> = (0..count)
        .into_par_iter()
        .map(|group| {
            let texels: Vec<usize> = (0..groups.len()).filter(|&texel| groups[texel] == group).collect();
            let views = ways.rows();
            let mut of_group = Matrix::zero(texels.len(), views);
            for view in 0..views {
                let row = ways.row(view);
                for (to, &from) in texels.iter().enumerate() {
                    of_group.values[to * views + view] = row[from];
                }
            }
            let factors = non_negative_factors(&of_group, terms, ROUNDS, &watch)?;
            let done = done.fetch_add(1, std::sync::atomic::Ordering::Relaxed) + 1;
            watch.at(done as f32 / count as f32)?;
            Ok((texels, factors.of_rows, factors.of_columns))
        })
        .collect::<Result<_, BakeError>>()?;
    let mut of_texels = Matrix::zero(groups.len(), terms);
    let mut of_views = Vec::with_capacity(count);
    for (texels, of_rows, of_columns) in made {
        for (row, texel) in texels.into_iter().enumerate() {
            of_texels.values[texel * terms..(texel + 1) * terms].copy_from_slice(of_rows.row(row));
        }
        of_views.push(of_columns);
    }
    let scales = scale(&mut of_texels, &groups, &mut of_views);
    Ok(Compressed { groups, of_texels, of_views, scales })
}

/// Divides factors by scales, so that each is at most 1 and uses all codes. Returns the codes of each
/// group's scales.
fn scale(of_texels: &mut Matrix, groups: &[usize], of_views: &mut [Matrix]) -> Vec<Vec<[u32; 2]>> {
    let terms = of_texels.columns;
    let mut most = vec![vec![0.0_f32; terms]; of_views.len()];
    for (row, &group) in of_texels.values.chunks(terms.max(1)).zip(groups) {
        most[group].iter_mut().zip(row).for_each(|(most, value)| *most = most.max(value.abs()));
    }
    let scales: Vec<Vec<[u32; 2]>> = of_views
        .iter_mut()
        .zip(&most)
        .map(|(of_views, most)| {
            (0..terms)
                .map(|term| {
                    let values = of_views.values.iter().skip(term).step_by(terms);
                    let of_view = values.fold(0.0_f32, |most, value| most.max(value.abs()));
                    let codes = scale_codes(most[term] * of_view);
                    let divisor = scale_of(codes) / most[term];
                    let values = of_views.values.iter_mut().skip(term).step_by(terms);
                    values
                        .for_each(|value| *value = if divisor.is_normal() { *value / divisor } else { 0.0 });
                    codes
                })
                .collect()
        })
        .collect();
    for (row, &group) in of_texels.values.chunks_mut(terms.max(1)).zip(groups) {
        for (value, &most) in row.iter_mut().zip(&most[group]) {
            *value = if most.is_normal() { *value / most } else { 0.0 };
        }
    }
    scales
}

/// Returns the codes of the least scale that is at least so large.
fn scale_codes(scale: f32) -> [u32; 2] {
    let code = ((scale / MOST_SCALE).sqrt() * (255.0 * 255.0)).ceil().min(255.0 * 255.0 + 254.0) as u32;
    // Rounding may have taken the code below.
    let code = code + u32::from(scale_of([code / 255, code % 255]) < scale);
    [code / 255, code % 255]
}

/// Returns the scale of two codes.
fn scale_of([high, low]: [u32; 2]) -> f32 {
    let root = high as f32 / 255.0 + low as f32 / (255.0 * 255.0);
    MOST_SCALE * root * root
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scales_are_at_least_what_they_stand_for() {
        let mut scale = 1e-6_f32;
        while scale < 500.0 {
            let codes = scale_codes(scale);
            let found = scale_of(codes);
            assert!(codes[0] <= 255 && codes[1] < 255, "{codes:?}");
            assert!(found >= scale && found < scale * 1.001 + 2e-4, "{found} for {scale}");
            scale *= 1.01;
        }
        assert_eq!(scale_codes(0.0), [0, 0]);
    }
}
