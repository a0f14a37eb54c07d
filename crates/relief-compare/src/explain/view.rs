//! The window of a cut: from metres along the ray's ground and heights to places of a drawing.

use relief_core::{HeightMap, Path};

use crate::figure::Place;

/// Width of the window in units.
pub const WIDTH: f64 = 900.0;

/// The least and the greatest height of the window in units.
const HEIGHTS: [f64; 2] = [260.0, 460.0];

/// What is left and above of the window, in units.
pub const MARGIN: [f64; 2] = [84.0, 62.0];

/// Least part of a tile's longer side, in texels, that is shown.
const LEAST_TEXELS: f64 = 6.0;

/// Part of the heights' range that is shown below and above it.
const AROUND: f64 = 0.07;

/// Units by which a line may leave its places out.
const SIMPLER: f64 = 0.08;

/// A plane that holds the ray and the normal, and the window on it.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// Texture coordinates where the ray enters.
    origin: [f64; 2],
    /// Change of the texture coordinates with a metre along the ground.
    along: [f64; 2],
    /// Metres along the ground with a unit of `t`.
    pub speed: f64,
    /// Metres along the ground that a step of one tile in the ray's direction takes.
    pub tile_m: f64,
    /// Metres along the ground that are shown.
    pub ground: [f64; 2],
    /// Heights that are shown.
    pub heights: [f64; 2],
    /// Units of a metre along the ground.
    across: f64,
    /// Units of a height.
    up: f64,
    /// Metres of a height.
    pub scale_m: f64,
}

impl View {
    /// The window on a path over a map that shows the path up to `last`.
    pub fn new(map: &HeightMap, path: &Path, last: f64) -> Self {
        let metric = path.metric;
        let long = |[u, v]: [f64; 2]| {
            (metric.uu * u * u + 2.0 * metric.uv * u * v + metric.vv * v * v).max(0.0).sqrt()
        };
        let speed = long(path.duv);
        let is_upright = speed <= 0.0;
        // A ray along the normal is cut along u.
        let step = if is_upright { [1.0, 0.0] } else { path.duv };
        let step_m = long(step);
        let along = step.map(|part| part / step_m);
        let texel_m = 1.0 / (along[0] * f64::from(map.width())).hypot(along[1] * f64::from(map.height()));
        let end = speed * last;
        let margin = (0.06 * end).max(0.5 * (LEAST_TEXELS * texel_m - end)).max(texel_m);
        let ground = [-margin, end + margin];
        let highest =
            (0..=32).map(|k| path.at(path.exit.min(last) * f64::from(k) / 32.0)[2]).fold(1.0, f64::max);
        let heights = [-AROUND, highest + AROUND];
        let across = WIDTH / (ground[1] - ground[0]);
        let true_up = across * metric.scale_m;
        let tall = (true_up * (heights[1] - heights[0])).clamp(HEIGHTS[0], HEIGHTS[1]);
        Self {
            origin: path.uv,
            along,
            speed,
            tile_m: 1.0 / along[0].hypot(along[1]),
            ground,
            heights,
            across,
            up: tall / (heights[1] - heights[0]),
            scale_m: metric.scale_m,
        }
    }

    /// How much heights are drawn larger than lengths along the ground.
    pub fn exaggeration(&self) -> f64 {
        self.up / (self.across * self.scale_m)
    }

    /// Texture coordinates at metres along the ground.
    pub fn uv(&self, ground: f64) -> [f64; 2] {
        [0, 1].map(|axis| self.origin[axis] + self.along[axis] * ground)
    }

    /// Change of a texture coordinate with a metre along the ground.
    pub fn along(&self) -> [f64; 2] {
        self.along
    }

    /// The place of metres along the ground and a height.
    pub fn place(&self, ground: f64, height: f64) -> Place {
        let [_, top] = self.heights;
        [MARGIN[0] + (ground - self.ground[0]) * self.across, MARGIN[1] + (top - height) * self.up]
    }

    /// Half the width and half the height of a ball, in units, with a radius in tiles and heights.
    pub fn radii(&self, radius: f64) -> [f64; 2] {
        [radius * self.tile_m * self.across, radius * self.up]
    }

    /// The corners of the window.
    pub fn frame(&self) -> [Place; 2] {
        [self.place(self.ground[0], self.heights[1]), self.place(self.ground[1], self.heights[0])]
    }

    /// Places along the ground, in metres, a unit of the drawing apart, over all of the window or a part.
    pub fn grounds(&self, from: f64, to: f64) -> impl Iterator<Item = f64> + use<> {
        let (from, to) = (from.max(self.ground[0]), to.min(self.ground[1]));
        let count = (((to - from) * self.across).ceil().max(1.0)) as usize;
        (0..=if to > from { count } else { 0 }).map(move |k| from + (to - from) * k as f64 / count as f64)
    }

    /// The line of a height that depends on metres along the ground.
    pub fn line(&self, from: f64, to: f64, height: impl Fn(f64) -> f64) -> Vec<Place> {
        // Numbers of any size are drawn at the window's edges.
        let far = self.heights[1] - self.heights[0];
        let seen = |height: f64| height.clamp(self.heights[0] - far, self.heights[1] + far);
        let places: Vec<Place> =
            self.grounds(from, to).map(|ground| self.place(ground, seen(height(ground)))).collect();
        simpler(&places)
    }

    /// The same line as an area, closed at the window's upper or lower edge.
    pub fn area(&self, from: f64, to: f64, is_above: bool, height: impl Fn(f64) -> f64) -> Vec<Place> {
        let edge = if is_above { self.heights[1] } else { self.heights[0] };
        let (from, to) = (from.max(self.ground[0]), to.min(self.ground[1]));
        let mut corners = self.line(from, to, height);
        corners.extend([self.place(to, edge), self.place(from, edge)]);
        corners
    }
}

/// The line without the places that are nearly on the straight line between others.
fn simpler(places: &[Place]) -> Vec<Place> {
    let mut kept = vec![false; places.len()];
    let mut waiting = vec![(0, places.len().saturating_sub(1))];
    while let Some((first, last)) = waiting.pop() {
        let (Some(&from), Some(&to)) = (places.get(first), places.get(last)) else { continue };
        (kept[first], kept[last]) = (true, true);
        // Places go to the right: how far one is above the straight line says enough.
        let off = |&at: &usize| {
            let part = (places[at][0] - from[0]) / (to[0] - from[0]);
            (places[at][1] - from[1] - (to[1] - from[1]) * part).abs()
        };
        let farthest = (first + 1..last).max_by(|a, b| off(a).total_cmp(&off(b)));
        if let Some(at) = farthest.filter(|at| off(at) > SIMPLER) {
            waiting.extend([(first, at), (at, last)]);
        }
    }
    places.iter().zip(kept).filter(|(_, kept)| *kept).map(|(place, _)| *place).collect()
}

#[cfg(test)]
mod tests {
    use relief_core::{PathMetric, Wrap};

    use super::*;

    /// A view on a ray of 45 degrees over a relief of 0.2 m, in a tile of 1 m.
    fn view() -> View {
        let map = HeightMap::from_fn(16, 16, Wrap::Repeat, |i, _| if i < 8 { 0.5 } else { 0.25 });
        let path = Path {
            uv: [0.25, 0.5],
            duv: [0.5f64.sqrt(), 0.0],
            h: [1.0, -0.5f64.sqrt() / 0.2, 0.0],
            exit: 0.2 * 2f64.sqrt(),
            base: 0.0,
            metric: PathMetric { uu: 1.0, uv: 0.0, vv: 1.0, scale_m: 0.2 },
        };
        View::new(&map.expect("a valid map"), &path, path.exit)
    }

    #[test]
    fn lengths_along_the_ground_and_heights_have_one_scale_if_they_can() {
        let view = view();
        let [a, b] = [view.place(0.0, 0.0), view.place(0.1, 0.5)];
        let factor = view.exaggeration();
        assert!(((a[1] - b[1]) / (b[0] - a[0]) - factor).abs() < 1e-9, "{a:?} {b:?}");
        assert!((0.1..10.0).contains(&factor));
        assert_eq!(view.uv(0.25), [0.5, 0.5]);
        let [[left, top], [right, bottom]] = view.frame();
        assert!((right - left - WIDTH).abs() < 1e-9 && bottom - top >= HEIGHTS[0] - 1e-9);
    }

    #[test]
    fn lines_keep_their_corners() {
        let view = view();
        let line = view.line(-1.0, 1.0, |ground| if ground < 0.1 { 0.2 } else { 0.2 + ground });
        assert!((4..12).contains(&line.len()), "{line:?}");
        let peak = simpler(&[[0.0, 0.0], [1.0, 5.0], [2.0, 0.0], [3.0, 0.0], [4.0, 0.0]]);
        assert_eq!(peak, [[0.0, 0.0], [1.0, 5.0], [2.0, 0.0], [4.0, 0.0]]);
        assert!(simpler(&[]).is_empty());
    }
}
