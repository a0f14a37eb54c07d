//! Paths that break what is only nearly right. All tests and benchmarks take theirs from here.

use relief_core::{HeightMap, Path, Wrap};

use relief_core::rng::Rng;

/// A kind of adversarial path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RayKind {
    /// From anywhere on top to anywhere at the bottom.
    Random,
    /// Touches the surface in the inside of a cell, or passes it by as little as rounding.
    Tangent,
    /// Exactly through two texel centres, at or barely off their heights.
    Vertices,
    /// Exactly along a line between dual cells, on which two patches meet.
    Edge,
    /// Exactly through every corner on a diagonal of cells.
    Diagonal,
    /// At one height all the way, often a texel's own.
    Horizontal,
    /// Upward from the surface, or barely off it, like a shadow ray.
    Upward,
    /// So shallow that it crosses many tiles.
    Grazing,
    /// Straight down, or up, at one place; every other time through a texel centre.
    Vertical,
    /// Begins below the surface.
    Below,
    /// Goes nowhere.
    Point,
    /// With a height that is quadratic in `t`, curved either way.
    Bent,
    /// Never ends by itself.
    Endless,
}

impl RayKind {
    /// Every kind.
    pub const ALL: [RayKind; 13] = [
        RayKind::Random,
        RayKind::Tangent,
        RayKind::Vertices,
        RayKind::Edge,
        RayKind::Diagonal,
        RayKind::Horizontal,
        RayKind::Upward,
        RayKind::Grazing,
        RayKind::Vertical,
        RayKind::Below,
        RayKind::Point,
        RayKind::Bent,
        RayKind::Endless,
    ];

    /// Whether a path of this kind is straight, begins above the surface and falls, as view rays on a plane
    /// do.
    pub fn is_view(self) -> bool {
        matches!(
            self,
            RayKind::Random | RayKind::Vertices | RayKind::Edge | RayKind::Diagonal | RayKind::Grazing
        )
    }
}

/// How far paths pass by what they aim at, in heights: not at all, by rounding errors of `f64` and `f32`,
/// visibly.
const OFFSETS: [f64; 9] = [0.0, 0.0, 1e-15, -1e-15, 1e-9, -1e-9, 1e-6, -1e-6, 1e-3];

/// An endless, deterministic stream of adversarial paths through one map, kind by kind in turn.
///
/// Paths under [`Wrap::Clamp`] end at the edge of the footprint `[0, 1]²`; the others leave it on every side.
/// Every number of a path is finite, but for the exit of [`RayKind::Endless`].
#[derive(Clone, Debug)]
pub struct Rays<'a> {
    map: &'a HeightMap,
    rng: Rng,
    turn: usize,
}

impl<'a> Rays<'a> {
    /// The stream for a map and a seed.
    pub fn new(map: &'a HeightMap, seed: u64) -> Self {
        Self { map, rng: Rng::new(seed), turn: 0 }
    }

    /// The next path of that kind.
    pub fn of_kind(&mut self, kind: RayKind) -> Path {
        // A path that does not meet the footprint is replaced; one that stays at a texel always does.
        for _ in 0..100 {
            let path = self.draw(kind);
            if self.map.wrap() != Wrap::Clamp {
                return path;
            }
            if let Some(clipped) = clip_to_footprint(&path) {
                return clipped;
            }
        }
        Path::between([0.5, 0.5, 1.0], [0.5, 0.5, 0.0])
    }

    fn draw(&mut self, kind: RayKind) -> Path {
        match kind {
            RayKind::Random => self.random(),
            RayKind::Tangent => self.tangent(),
            RayKind::Vertices => self.vertices(),
            RayKind::Edge => self.edge(),
            RayKind::Diagonal => self.diagonal(),
            RayKind::Horizontal => self.horizontal(),
            RayKind::Upward => self.upward(),
            RayKind::Grazing => self.grazing(),
            RayKind::Vertical => self.vertical(),
            RayKind::Below => self.below(),
            RayKind::Point => self.point(),
            RayKind::Bent => self.bent(),
            RayKind::Endless => self.endless(),
        }
    }

    fn size(&self) -> [f64; 2] {
        [f64::from(self.map.width()), f64::from(self.map.height())]
    }

    /// Texture coordinates of a random place, in a neighbouring tile now and then.
    fn place(&mut self) -> [f64; 2] {
        let tile = |rng: &mut Rng| {
            if rng.below(4) == 0 { f64::from(rng.below(5)) - 2.0 } else { 0.0 }
        };
        [self.rng.unit() + tile(&mut self.rng), self.rng.unit() + tile(&mut self.rng)]
    }

    /// Column and row of a random texel.
    fn texel(&mut self) -> [i64; 2] {
        [i64::from(self.rng.below(self.map.width())), i64::from(self.rng.below(self.map.height()))]
    }

    /// Texture coordinates of a random texel's centre.
    fn any_centre(&mut self) -> [f64; 2] {
        let texel = self.texel();
        self.centre(texel)
    }

    /// Texture coordinates of a texel's centre.
    fn centre(&self, texel: [i64; 2]) -> [f64; 2] {
        let [w, h] = self.size();
        [(texel[0] as f64 + 0.5) / w, (texel[1] as f64 + 0.5) / h]
    }

    fn texel_height(&self, [i, j]: [i64; 2]) -> f64 {
        f64::from(self.map.texel(i, j))
    }

    /// A direction in texels, of unit length; along an axis or a diagonal every other time.
    fn direction(&mut self) -> [f64; 2] {
        let turn = if self.rng.below(2) == 0 { f64::from(self.rng.below(8)) / 8.0 } else { self.rng.unit() };
        let angle = turn * std::f64::consts::TAU;
        let exact = |x: f64| if x.abs() < 1e-12 { 0.0 } else { x };
        [exact(angle.cos()), exact(angle.sin())]
    }

    /// A length in texels: from less than a cell to more than a tile.
    fn reach(&mut self) -> f64 {
        let side = f64::from(self.map.width().max(self.map.height()));
        let most = (4.0 * side).log2();
        self.rng.between(-2.0, most).exp2()
    }

    /// A straight path through a point, from `back` texels before it to `ahead` texels behind it.
    fn through(&self, at: [f64; 3], direction: [f64; 2], rise: f64, back: f64, ahead: f64) -> Path {
        let [w, h] = self.size();
        let along = |d: f64| [at[0] + direction[0] * d / w, at[1] + direction[1] * d / h, at[2] + rise * d];
        Path::between(along(-back), along(ahead))
    }

    fn random(&mut self) -> Path {
        let from = self.place();
        let [w, h] = self.size();
        let (direction, reach) = (self.direction(), self.reach());
        let to = [from[0] + direction[0] * reach / w, from[1] + direction[1] * reach / h];
        Path::between(
            [from[0], from[1], self.rng.between(0.9, 1.2)],
            [to[0], to[1], self.rng.between(-0.2, 0.1)],
        )
    }

    fn tangent(&mut self) -> Path {
        let [w, h] = self.size();
        let ([i, j], offset) = (self.texel(), self.rng.pick(&OFFSETS));
        let (fx, fy) = (self.rng.unit(), self.rng.unit());
        let [h00, h10, h01, h11] = self.map.cell(i, j).map(f64::from);
        let slope_x = (h10 - h00) * (1.0 - fy) + (h11 - h01) * fy;
        let slope_y = (h01 - h00) * (1.0 - fx) + (h11 - h10) * fx;
        let [u, v] = [(i as f64 + 0.5 + fx) / w, (j as f64 + 0.5 + fy) / h];
        let direction = self.direction();
        let rise = slope_x * direction[0] + slope_y * direction[1];
        let (back, ahead) = (self.reach(), self.reach());
        self.through([u, v, self.map.height_at(u, v) + offset], direction, rise, back, ahead)
    }

    fn vertices(&mut self) -> Path {
        let (from, by) = (self.texel(), [self.rng.below(17), self.rng.below(17)].map(|n| i64::from(n) - 8));
        let to = [from[0] + by[0], from[1] + by[1]];
        let (a, b) = (self.centre(from), self.centre(to));
        let (high, low) = (self.texel_height(from), self.texel_height(to));
        let drop = self.rng.pick(&OFFSETS);
        match self.rng.below(3) {
            0 => Path::between([a[0], a[1], 1.0], [b[0], b[1], low + drop]),
            1 => Path::between([a[0], a[1], high + drop], [b[0], b[1], low + drop]),
            _ => {
                // Past the second centre by as much again.
                let beyond = [2.0 * b[0] - a[0], 2.0 * b[1] - a[1]];
                Path::between([a[0], a[1], 1.0], [beyond[0], beyond[1], 2.0 * (low + drop) - 1.0])
            }
        }
    }

    fn edge(&mut self) -> Path {
        let from = self.any_centre();
        let (axis, reach) = (self.rng.below(2) as usize, self.reach());
        let mut to = from;
        to[axis] += self.rng.pick(&[-1.0, 1.0]) * reach / self.size()[axis];
        let low = self.rng.between(-0.1, 0.6);
        Path::between([from[0], from[1], 1.0], [to[0], to[1], low])
    }

    fn diagonal(&mut self) -> Path {
        let from = self.texel();
        let (right, down) = (self.rng.pick(&[-1, 1]), self.rng.pick(&[-1, 1]));
        let cells = 1 + i64::from(self.rng.below(40));
        let (a, b) = (self.centre(from), self.centre([from[0] + right * cells, from[1] + down * cells]));
        Path::between([a[0], a[1], 1.0], [b[0], b[1], self.rng.between(-0.1, 0.5)])
    }

    fn horizontal(&mut self) -> Path {
        let texel = self.texel();
        let height = match self.rng.below(3) {
            0 => self.texel_height(texel) + self.rng.pick(&OFFSETS),
            1 => f64::from(self.map.texels().iter().copied().fold(0.0, f32::max)) + self.rng.pick(&OFFSETS),
            _ => self.rng.unit(),
        };
        let [u, v] = if self.rng.below(2) == 0 { self.centre(texel) } else { self.place() };
        let (direction, ahead) = (self.direction(), self.reach());
        self.through([u, v, height], direction, 0.0, 0.0, ahead)
    }

    fn upward(&mut self) -> Path {
        let [u, v] = if self.rng.below(4) == 0 { self.any_centre() } else { self.place() };
        let start = self.map.height_at(u, v) + self.rng.pick(&[1e-9, 1e-6, 1e-4, 1e-2, 0.0]);
        let (direction, reach) = (self.direction(), self.reach());
        let top = self.rng.between(1.0, 1.3);
        self.through([u, v, start], direction, (top - start) / reach, 0.0, reach)
    }

    fn grazing(&mut self) -> Path {
        let [u, v] = self.place();
        let side = f64::from(self.map.width().max(self.map.height()));
        let (direction, reach) = (self.direction(), side * self.rng.between(2.0, 12.0));
        let low = self.rng.between(-0.1, 0.9);
        self.through([u, v, 1.0], direction, (low - 1.0) / reach, 0.0, reach)
    }

    fn vertical(&mut self) -> Path {
        let [u, v] = if self.rng.below(2) == 0 { self.any_centre() } else { self.place() };
        match self.rng.below(3) {
            0 => Path::between([u, v, 1.1], [u, v, -0.1]),
            1 => Path::between([u, v, 1.0], [u, v, self.map.height_at(u, v) + self.rng.pick(&OFFSETS)]),
            _ => Path::between([u, v, self.map.height_at(u, v) + self.rng.pick(&OFFSETS)], [u, v, 1.0]),
        }
    }

    fn below(&mut self) -> Path {
        let [u, v] = self.place();
        let start = self.map.height_at(u, v) - self.rng.pick(&[1e-12, 1e-6, 0.1, 3.0]);
        let (direction, reach) = (self.direction(), self.reach());
        let rise = self.rng.between(-1.0, 1.0) / reach;
        self.through([u, v, start], direction, rise, 0.0, reach)
    }

    fn point(&mut self) -> Path {
        let [u, v] = self.place();
        let at = [u, v, self.map.height_at(u, v) + self.rng.pick(&OFFSETS)];
        Path::between(at, at)
    }

    fn bent(&mut self) -> Path {
        let mut path = match self.rng.below(4) {
            0 => self.random(),
            1 => self.grazing(),
            2 => self.tangent(),
            _ => self.upward(),
        };
        // Straight ends stay where they are, and the middle is moved up or down.
        let sag = self.rng.between(-1.0, 1.0);
        path.h[1] += sag;
        path.h[2] -= sag;
        path
    }

    fn endless(&mut self) -> Path {
        let mut path = match self.rng.below(4) {
            0 => self.random(),
            1 => self.upward(),
            2 => self.vertical(),
            _ => {
                let above = [1e-9, 1e-3, 0.5].map(|above| 1.0 + above);
                let [u, v] = self.place();
                let (height, direction) = (self.rng.pick(&above), self.direction());
                self.through([u, v, height], direction, 0.0, 0.0, 8.0)
            }
        };
        path.exit = f64::INFINITY;
        path
    }
}

impl Iterator for Rays<'_> {
    type Item = (RayKind, Path);

    fn next(&mut self) -> Option<Self::Item> {
        let kind = RayKind::ALL[self.turn % RayKind::ALL.len()];
        self.turn += 1;
        Some((kind, self.of_kind(kind)))
    }
}

/// The part of a path over the footprint `[0, 1]²`, with `t` beginning anew; `None` where it does not cross
/// it.
pub fn clip_to_footprint(path: &Path) -> Option<Path> {
    let (mut from, mut to) = (0.0f64, path.exit);
    for axis in 0..2 {
        let (start, step) = (path.uv[axis], path.duv[axis]);
        if step == 0.0 {
            if !(0.0..=1.0).contains(&start) {
                return None;
            }
            continue;
        }
        let (a, b) = (-start / step, (1.0 - start) / step);
        from = from.max(a.min(b));
        to = to.min(a.max(b));
    }
    if from > to {
        return None;
    }
    let [u, v, height] = path.at(from);
    let [_, h1, h2] = path.h;
    Some(Path {
        uv: [u.clamp(0.0, 1.0), v.clamp(0.0, 1.0)],
        h: [height, h1 + 2.0 * h2 * from, h2],
        exit: to - from,
        base: (path.base - from).clamp(0.0, to - from),
        ..*path
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::maps;

    #[test]
    fn streams_repeat_and_stay_finite() {
        for named in maps::ALL {
            for wrap in Wrap::ALL {
                let map = named.build(wrap);
                let draw = || Rays::new(&map, 5).take(130).collect::<Vec<_>>();
                assert_eq!(draw(), draw(), "{}", named.name);
                for (kind, path) in draw() {
                    let numbers =
                        [path.uv[0], path.uv[1], path.duv[0], path.duv[1], path.h[0], path.h[1], path.h[2]];
                    assert!(numbers.iter().all(|x| x.is_finite()), "{kind:?}: {path:?}");
                    assert!(path.exit >= 0.0 && (path.exit.is_finite() || kind == RayKind::Endless));
                }
            }
        }
    }

    #[test]
    fn clamped_paths_stay_over_the_footprint() {
        for named in maps::ALL {
            let map = named.build(Wrap::Clamp);
            for (kind, path) in Rays::new(&map, 9).take(1300) {
                for t in [0.0, if path.exit.is_finite() { path.exit } else { 0.0 }] {
                    let [u, v, _] = path.at(t);
                    let inside = -1e-12..=1.0 + 1e-12;
                    assert!(inside.contains(&u) && inside.contains(&v), "{kind:?} at {t}: {path:?}");
                }
            }
        }
    }

    #[test]
    fn the_clipped_path_is_the_same_path() {
        let mut path = Path::between([-1.0, 0.25, 1.0], [3.0, 0.5, 0.0]);
        path.h = [1.0, 0.5, -1.5];
        let clipped = clip_to_footprint(&path).expect("it crosses the footprint");
        for s in [0.0, 0.1, 0.2] {
            let (a, b) = (path.at(0.25 + s), clipped.at(s));
            assert!((0..3).all(|k| (a[k] - b[k]).abs() < 1e-15), "{a:?} and {b:?}");
        }
        assert_eq!(clipped.exit, 0.25);
    }
}
