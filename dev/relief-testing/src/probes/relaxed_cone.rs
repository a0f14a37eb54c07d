//! Falling rays that must not come out of the surface inside a relaxed cone.

use relief_core::HeightMap;

use relief_core::rng::Rng;

/// A ray over an apex, and where it comes out of the surface for the first time.
#[derive(Clone, Copy, Debug)]
pub struct Exit {
    /// The texel whose square holds the apex.
    pub texel: [i64; 2],
    /// The apex in texels, from the centre of texel `(0, 0)`.
    pub apex: [f64; 2],
    /// Height of the ray over the apex, and at the place where it comes out.
    pub heights: [f64; 2],
    /// That place, in texels.
    pub place: [f64; 2],
    /// The widest ratio whose cone the ray leaves before, in metres per height; infinite where it never comes
    /// out above the apex.
    pub limit: f64,
}

/// Depth by which a ray must have been below, and height by which it must be above again, to have come out.
const CLEAR: f64 = 1e-11;
/// Number of cells through which a ray is followed.
const CELLS: usize = 200;

/// Endless deterministic rays over the texels of a map.
#[derive(Clone, Debug)]
pub struct Probes<'a> {
    map: &'a HeightMap,
    texel_m: [f64; 2],
    footprint: bool,
    rng: Rng,
}

impl<'a> Probes<'a> {
    /// The probes of a map for a seed: over apexes anywhere in a texel with `footprint`, else over centres.
    pub fn new(map: &'a HeightMap, texel_m: [f64; 2], footprint: bool, seed: u64) -> Self {
        Self { map, texel_m, footprint, rng: Rng::new(seed) }
    }

    fn surface(&self, [x, y]: [f64; 2]) -> f64 {
        self.map.height_at((x + 0.5) / f64::from(self.map.width()), (y + 0.5) / f64::from(self.map.height()))
    }

    /// Where the ray from `height` over the apex, falling to `to` at `aim`, comes out.
    fn trace(&self, texel: [i64; 2], apex: [f64; 2], aim: [f64; 2], height: f64, to: f64) -> Exit {
        let step = [aim[0] - apex[0], aim[1] - apex[1]];
        let ground = self.surface(apex);
        let at = |t: f64| [apex[0] + step[0] * t, apex[1] + step[1] * t];
        let z = |t: f64| height + (to - height) * t;
        let mut exit = Exit { texel, apex, heights: [height, 0.0], place: apex, limit: f64::INFINITY };
        let (mut t, mut is_below) = (0.0f64, false);
        for _ in 0..CELLS {
            let crossing = |axis: usize| {
                let x = apex[axis] + step[axis] * t;
                let line = if step[axis] > 0.0 { (x + 1e-9).floor() + 1.0 } else { (x - 1e-9).ceil() - 1.0 };
                if step[axis] == 0.0 { f64::INFINITY } else { (line - apex[axis]) / step[axis] }
            };
            let end = crossing(0).min(crossing(1));
            if !end.is_finite() {
                break;
            }
            // The gap is a quadratic of the cell: from its ends and its middle.
            let gap = |t: f64| z(t) - self.surface(at(t));
            let (a, m, b) = (gap(t), gap(0.5 * (t + end)), gap(end));
            let (bend, slope) = (2.0 * (a + b - 2.0 * m), 4.0 * m - 3.0 * a - b);
            let turn = (-slope / (2.0 * bend)).clamp(0.0, 1.0);
            let turn = if turn.is_finite() { turn } else { 0.0 };
            let mut before = t;
            for share in [0.0, turn, 1.0] {
                let t = t + (end - t) * share;
                if is_below && gap(t) > CLEAR {
                    let out = first_out(&gap, before, t);
                    if z(out) > ground {
                        let far = (step[0] * out * self.texel_m[0]).hypot(step[1] * out * self.texel_m[1]);
                        exit.place = at(out);
                        exit.heights[1] = z(out);
                        exit.limit = far / (z(out) - ground);
                    }
                    return exit;
                }
                is_below |= gap(t) < -CLEAR;
                before = t;
            }
            t = end;
            if z(t) <= ground {
                break;
            }
        }
        exit
    }
}

/// The first place at which a gap, which grows from `below` to `above`, has come out.
fn first_out(gap: &impl Fn(f64) -> f64, mut below: f64, mut above: f64) -> f64 {
    // As often as `f64` can be halved between two places that are no farther apart than a cell.
    for _ in 0..60 {
        let middle = 0.5 * (below + above);
        if gap(middle) > CLEAR {
            above = middle;
        } else {
            below = middle;
        }
    }
    above
}

impl Iterator for Probes<'_> {
    type Item = Exit;

    fn next(&mut self) -> Option<Exit> {
        let size = [self.map.width(), self.map.height()];
        let texel = size.map(|side| i64::from(self.rng.below(side)));
        let apex = texel.map(|k| {
            let within = match self.rng.below(3) {
                0 => self.rng.between(-0.5, 0.5),
                1 => self.rng.pick(&[-0.5, -0.4999, 0.4999, 0.5]),
                _ => 0.0,
            };
            k as f64 + if self.footprint { within } else { 0.0 }
        });
        let reach = f64::from(size[0].max(size[1])).log2();
        let span = self.rng.between(-1.0, reach).exp2();
        let mut aim = apex.map(|x| x + self.rng.between(-span, span));
        match self.rng.below(4) {
            0 | 1 => aim = aim.map(f64::round),
            2 => aim[self.rng.below(2) as usize] = apex[0].round(),
            _ => {}
        }
        // Through a point at or barely under the surface, hardly falling: so a ray cuts off the top of a
        // peak.
        let to = self.surface(aim) - self.rng.pick(&[1e-9, 1e-6, 1e-4, 1e-2]);
        let ground = self.surface(apex);
        let fall = match self.rng.below(3) {
            0 => 1e-9,
            1 => self.rng.between(-16.0, 0.0).exp2(),
            _ => self.rng.unit() * 2.0,
        };
        let height = (to + fall).max(ground).max(to + 1e-9);
        Some(self.trace(texel, apex, aim, height, to))
    }
}

/// Returns how many of `count` rays come out inside the cone of their texel, and the ray
/// that comes nearest to it.
pub fn attack(probes: Probes<'_>, count: usize, ratio: impl Fn(&Exit) -> f64) -> (usize, Option<Exit>) {
    let mut violations = 0;
    let mut tightest: Option<(f64, Exit)> = None;
    for exit in probes.take(count) {
        let room = exit.limit / ratio(&exit);
        violations += usize::from(room < 1.0);
        if tightest.is_none_or(|(least, _)| room < least) {
            tightest = Some((room, exit));
        }
    }
    (violations, tightest.map(|(_, exit)| exit))
}
