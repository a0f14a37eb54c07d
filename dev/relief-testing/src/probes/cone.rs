//! Pairs of surface points that a cone map must keep apart.

use relief_core::HeightMap;

use relief_core::rng::Rng;

/// An apex, and a point of the surface that limits the cone there.
#[derive(Clone, Copy, Debug)]
pub struct Contact {
    /// The texel whose square holds the apex.
    pub texel: [i64; 2],
    /// The apex in texels, from the centre of texel `(0, 0)`.
    pub apex: [f64; 2],
    /// The point, likewise.
    pub point: [f64; 2],
    /// The widest ratio that keeps the point out, in metres per height; infinite where the point is not above
    /// the apex.
    pub limit: f64,
}

/// Endless deterministic probes of a map: each a texel, an apex in its square (or its centre) and a point.
#[derive(Clone, Debug)]
pub struct Probes<'a> {
    map: &'a HeightMap,
    texel_m: [f64; 2],
    footprint: bool,
    rng: Rng,
    last: Option<Contact>,
}

impl<'a> Probes<'a> {
    /// The probes of a map for a seed: of apexes anywhere in a texel with `footprint`, else of centres.
    pub fn new(map: &'a HeightMap, texel_m: [f64; 2], footprint: bool, seed: u64) -> Self {
        Self { map, texel_m, footprint, rng: Rng::new(seed), last: None }
    }

    fn surface(&self, [x, y]: [f64; 2]) -> f64 {
        self.map.height_at((x + 0.5) / f64::from(self.map.width()), (y + 0.5) / f64::from(self.map.height()))
    }

    fn contact(&self, texel: [i64; 2], apex: [f64; 2], point: [f64; 2]) -> Contact {
        let far = ((point[0] - apex[0]) * self.texel_m[0]).hypot((point[1] - apex[1]) * self.texel_m[1]);
        // Rises that rounding may have made are no contact.
        let rise = self.surface(point) - self.surface(apex) - 1e-14;
        Contact { texel, apex, point, limit: if rise > 0.0 { far / rise } else { f64::INFINITY } }
    }

    fn apex(&mut self, texel: [i64; 2]) -> [f64; 2] {
        texel.map(|k| {
            let within = match self.rng.below(4) {
                0 => self.rng.between(-0.5, 0.5),
                1 => self.rng.pick(&[-0.5, 0.5]),
                2 => self.rng.pick(&[-0.5, -0.4999, -1e-9, 0.0, 1e-9, 0.4999, 0.5]),
                _ => 0.0,
            };
            k as f64 + if self.footprint { within } else { 0.0 }
        })
    }
}

impl Iterator for Probes<'_> {
    type Item = Contact;

    fn next(&mut self) -> Option<Contact> {
        let size = [self.map.width(), self.map.height()];
        // Half of the probes are driven uphill from the last contact, towards steeper pairs.
        if let Some(last) = self.last
            && self.rng.below(2) == 0
        {
            let step = self.rng.between(-12.0, 0.0).exp2();
            let mut moved = [last.apex, last.point].map(|at| at.map(|x| x + self.rng.between(-step, step)));
            for (axis, &texel) in last.texel.iter().enumerate() {
                let half = if self.footprint { 0.5 } else { 0.0 };
                moved[0][axis] = moved[0][axis].clamp(texel as f64 - half, texel as f64 + half);
            }
            let contact = self.contact(last.texel, moved[0], moved[1]);
            if contact.limit < last.limit {
                self.last = Some(contact);
            }
            return Some(contact);
        }
        let texel = size.map(|side| i64::from(self.rng.below(side)));
        let apex = self.apex(texel);
        let reach = f64::from(size[0].max(size[1])).log2() + 1.0;
        let mut best: Option<Contact> = None;
        for _ in 0..4 {
            let span = self.rng.between(-6.0, reach).exp2();
            let mut point = apex.map(|x| x + self.rng.between(-span, span));
            match self.rng.below(4) {
                // At a vertex, on an edge, or anywhere.
                0 => point = point.map(f64::round),
                1 => point[0] = point[0].round(),
                2 => point[1] = point[1].round(),
                _ => {}
            }
            let contact = self.contact(texel, apex, point);
            if best.is_none_or(|best| contact.limit < best.limit) {
                best = Some(contact);
            }
        }
        self.last = best;
        best
    }
}

/// Returns how many of `count` probes find a point inside the cone of their texel, and the contact that comes
/// nearest to it: the one with the least limit over ratio. `ratio` is asked for the ratio that a search would
/// use at an apex of a texel.
pub fn attack(probes: Probes<'_>, count: usize, ratio: impl Fn(&Contact) -> f64) -> (usize, Option<Contact>) {
    let mut violations = 0;
    let mut tightest: Option<(f64, Contact)> = None;
    for contact in probes.take(count) {
        let room = contact.limit / ratio(&contact);
        violations += usize::from(room < 1.0);
        if tightest.is_none_or(|(least, _)| room < least) {
            tightest = Some((room, contact));
        }
    }
    (violations, tightest.map(|(_, contact)| contact))
}
