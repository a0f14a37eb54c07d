//! Differences of pictures of curved surfaces from the judge's.

use super::{Curved, Judged, Met, Picture};
use relief_testing::outline::{distances, overlap};

/// Difference of hits in texels from which they are tested for lying at a silhouette.
const LOOKED_AT_TEXELS: f64 = 0.05;

/// How far three depths in a row may be beside a straight line where there is no silhouette, in scales of the
/// displacement.
const JUMP_SCALES: f64 = 0.03;

/// Differences of hits, in units of their own.
#[derive(Clone, Debug, Default)]
pub struct Differences {
    /// Difference of texture coordinates, in texels, whole tiles aside.
    pub texels: Vec<f64>,
    /// Difference of depths, in scales of the displacement.
    pub depths: Vec<f64>,
}

/// Differences of pictures from the judge's, over any number of views.
#[derive(Clone, Debug, Default)]
pub struct Comparison {
    /// Distances in pixels of the outlines' pixels to the other outline.
    pub outline: Vec<f64>,
    /// Pixels that both cover, and that either does, small holes filled.
    pub overlap: [usize; 2],
    /// Pixels that both cover.
    pub both: usize,
    /// Hits, where the judge's count; not those that differ and lie at a silhouette, where a ray that is
    /// hardly another one hits something else.
    pub inside: Differences,
    /// All hits.
    pub all: Differences,
    /// Pixels without a hit though the judge has one there, which counts, at no silhouette, and on all pixels
    /// around.
    pub open: usize,
    /// Of all pixels without a hit those where the judge has one there and on all pixels around.
    pub all_open: usize,
    /// Hits of those that lie more than a displacement behind the judge's.
    pub behind: usize,
    /// Of all hits.
    pub all_behind: usize,
}

impl Comparison {
    /// Adds a view: a picture, what the judge sees, and what both see of this relief.
    pub fn add(&mut self, picture: &Picture, judged: &Judged, of: &Curved) {
        self.add_outline(picture, &judged.picture);
        self.add_cracks(picture, judged, of);
        self.add_all_hits(picture, judged, of);
        self.add_hits_inside(picture, judged, of);
    }

    /// Adds a view's outlines alone, which takes less time where most hits differ.
    pub fn add_outline(&mut self, picture: &Picture, judged: &Picture) {
        let [a, b] = [picture, judged].map(|picture| picture.mask().filled());
        self.outline.extend(distances(&a, &b));
        let [both, either] = overlap(&a, &b);
        self.overlap = [self.overlap[0] + both, self.overlap[1] + either];
    }

    /// Adds what a view shows through the relief alone: what is open, and what lies behind.
    pub fn add_cracks(&mut self, picture: &Picture, judged: &Judged, of: &Curved) {
        let (inner, columns) = (judged.picture.mask().eroded(), picture.size[0]);
        let jump_m = JUMP_SCALES * of.map().scale_m().abs();
        for (pixel, drawn, truth) in truths(picture, judged) {
            let counts = || truth.counts && !judged.is_at_silhouette(pixel, jump_m);
            match drawn {
                Some(drawn) => {
                    let is_behind = of.behind(drawn, truth) > 1.0;
                    self.both += 1;
                    self.all_behind += usize::from(is_behind);
                    self.behind += usize::from(is_behind && counts());
                }
                None => {
                    let is_inner = inner.at((pixel % columns).into(), (pixel / columns).into());
                    self.all_open += usize::from(is_inner);
                    self.open += usize::from(is_inner && counts());
                }
            }
        }
    }

    /// Adds how far a view's hits are from the judge's, silhouettes or not, which takes less time.
    pub fn add_all_hits(&mut self, picture: &Picture, judged: &Judged, of: &Curved) {
        for (_, drawn, truth) in truths(picture, judged) {
            let Some(drawn) = drawn else { continue };
            self.all.add(of.texels(drawn.uv, truth.uv), of.behind(drawn, truth).abs());
        }
    }

    fn add_hits_inside(&mut self, picture: &Picture, judged: &Judged, of: &Curved) {
        let jump_m = JUMP_SCALES * of.map().scale_m().abs();
        for (pixel, drawn, truth) in truths(picture, judged) {
            let Some(drawn) = drawn else { continue };
            let (texels, behind) = (of.texels(drawn.uv, truth.uv), of.behind(drawn, truth));
            let differs = texels >= LOOKED_AT_TEXELS || behind > 1.0;
            if truth.counts && !(differs && judged.is_at_silhouette(pixel, jump_m)) {
                self.inside.add(texels, behind.abs());
            }
        }
    }

    /// That part of the outlines' distances is not larger.
    pub fn outline_at(&self, part: f64) -> f64 {
        quantile(&self.outline, part)
    }

    /// Pixels that both cover over those that either does.
    pub fn overlap(&self) -> f64 {
        self.overlap[0] as f64 / self.overlap[1].max(1) as f64
    }
}

/// The pixels where the judge sees something, with what a picture shows there.
fn truths<'a>(
    picture: &'a Picture,
    judged: &'a Judged,
) -> impl Iterator<Item = (u32, Option<&'a Met>, &'a Met)> {
    let pairs = (0..).zip(picture.met.iter().zip(&judged.picture.met));
    pairs.filter_map(|(pixel, (drawn, truth))| Some((pixel, drawn.as_ref(), truth.as_ref()?)))
}

impl Differences {
    fn add(&mut self, texels: f64, depth: f64) {
        self.texels.push(texels);
        self.depths.push(depth);
    }

    /// That part of the hits is not farther from the judge's, in texels.
    pub fn texels_at(&self, part: f64) -> f64 {
        quantile(&self.texels, part)
    }

    /// That part of the hits is not deeper or less deep by more scales.
    pub fn depths_at(&self, part: f64) -> f64 {
        quantile(&self.depths, part)
    }

    /// The share of the hits that are more than half a texel from the judge's.
    pub fn beyond_half(&self) -> f64 {
        let beyond = self.texels.iter().filter(|texels| **texels > 0.5).count();
        beyond as f64 / self.texels.len().max(1) as f64
    }
}

/// The least number that that part of them is not above; 0 where there are none.
pub fn quantile(numbers: &[f64], part: f64) -> f64 {
    let mut numbers = numbers.to_vec();
    numbers.sort_unstable_by(f64::total_cmp);
    let place = (numbers.len() as f64 * part) as usize;
    numbers.get(place.min(numbers.len().saturating_sub(1))).copied().unwrap_or(0.0)
}
