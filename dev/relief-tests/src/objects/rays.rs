//! Rays at objects that break what is only nearly right.

use glam::DVec3;
use relief_core::object::EMPTY_HEIGHT;
use relief_core::raycast::Ray;

use super::Subject;
use crate::spheres::CUBE;
use relief_core::rng::Rng;
use relief_testing::rays::{RayKind, Rays};

/// An endless, deterministic stream of adversarial rays at an object.
#[derive(Debug)]
pub struct ObjectRays<'a> {
    subject: &'a Subject,
    paths: Vec<Rays<'a>>,
    rng: Rng,
    turn: usize,
}

impl<'a> ObjectRays<'a> {
    /// The stream for an object and a seed.
    pub fn new(subject: &'a Subject, seed: u64) -> Self {
        let paths = subject.maps.iter().map(|map| Rays::new(map, seed)).collect();
        Self { subject, paths, rng: Rng::new(seed), turn: 0 }
    }

    /// From outside toward somewhere in the ball.
    pub fn random(&mut self) -> Ray {
        let (centre, radius) = self.subject.object.views()[0].ball();
        let origin = centre + self.rng.direction() * (radius * self.rng.between(1.0, 4.0));
        let to = centre + self.rng.direction() * (radius * 0.8 * self.rng.unit());
        Ray { origin, direction: (to - origin) * self.rng.between(0.1, 2.0) }
    }

    /// From somewhere in the ball, every other time along an axis of the world.
    fn inside(&mut self) -> Ray {
        let (centre, radius) = self.subject.object.views()[0].ball();
        let origin = centre + self.rng.direction() * (radius * self.rng.unit());
        let direction = if self.rng.below(2) == 0 { self.rng.pick(&CUBE) } else { self.rng.direction() };
        Ray { origin, direction }
    }

    /// Through places of an image at which something begins: a texel, its centre, a corner of the image.
    fn exactly(&mut self) -> Ray {
        let number = self.rng.below(self.subject.maps.len() as u32) as usize;
        let view = &self.subject.object.views()[number];
        let map = &self.subject.maps[number];
        let mut place = || {
            let [x, y] = view
                .size()
                .map(|side| (f64::from(self.rng.below(2 * side + 3)) - 1.0) / (2.0 * f64::from(side)));
            let texel = map.texel(
                (x * f64::from(map.width())).floor() as i64,
                (y * f64::from(map.height())).floor() as i64,
            );
            DVec3::new(x, y, self.rng.pick(&[f64::from(texel), 0.0, 0.5, 1.0, EMPTY_HEIGHT]))
        };
        let (one, mut other) = (place(), place());
        match self.rng.below(4) {
            // Along a ray of the image, along its rows or columns, at one height.
            0 => other = DVec3::new(one.x, one.y, other.z),
            1 => other = DVec3::new(one.x, other.y, one.z),
            2 => other.z = one.z,
            _ => {}
        }
        let [one, other] = [one, other].map(|at| view.point(at));
        self.through(one, other)
    }

    /// A path through an image's map, kind by kind in turn.
    fn path(&mut self) -> Ray {
        let number = self.rng.below(self.paths.len() as u32) as usize;
        let kind = RayKind::ALL[self.turn / 4 % RayKind::ALL.len()];
        let path = self.paths[number].of_kind(kind);
        let view = &self.subject.object.views()[number];
        let end = if path.exit.is_finite() { path.exit } else { 1.0 };
        let [one, other] = [0.0, end].map(|t| view.point(DVec3::from(path.at(t))));
        self.through(one, other)
    }

    /// A ray from a point, or from before it, to another.
    fn through(&mut self, one: DVec3, other: DVec3) -> Ray {
        let back = self.rng.pick(&[0.0, 0.0, 1.0, 3.0]);
        let way = other - one;
        // In a perspective image there is no point at heights far below 0.
        if !(way.is_finite() && way.length() > 1e-6 && one.length() < 1e3 && way.length() < 1e3) {
            return self.random();
        }
        let ray = Ray { origin: one - way * back, direction: way };
        if self.rng.below(4) == 0 { Ray { origin: ray.at(1.0 + back), direction: -way } } else { ray }
    }
}

impl Iterator for ObjectRays<'_> {
    type Item = Ray;

    fn next(&mut self) -> Option<Ray> {
        self.turn += 1;
        Some(match self.turn % 4 {
            0 => self.path(),
            1 => self.exactly(),
            2 => self.random(),
            _ if self.turn % 8 == 3 => self.inside(),
            _ => self.path(),
        })
    }
}
