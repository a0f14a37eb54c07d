//! Image-based objects that break what is only nearly right, rays at them, and the judge of where rays meet
//! them.
//!
//! Where a ray grazes, `t` and even hit or miss hang on the last bit. So an answer is accepted when its point
//! is in the solid of each image or at most about [`NEAR`] beside it, and when before it the ray is nowhere
//! deeper in all of them. Whether points are is found by arithmetic that is written here alone.

mod rays;

pub use rays::ObjectRays;

use glam::{DVec2, DVec3};
use relief_core::object::{EMPTY_HEIGHT, ImageObject, JumpCells, ObjectHit, View};
use relief_core::raycast::Ray;
use relief_core::{HeightMap, Wrap};

use crate::spheres::{CUBE, RADIUS, map_of_spheres};
use relief_core::rng::Rng;
use relief_testing::maps::{self, NamedMap};

/// How far beside, as a part of the radius of what images show, and how much later, as a part of the way
/// there, an answer may be.
pub const NEAR: f64 = 1e-9;

/// An object, and the maps that it was made of.
#[derive(Clone, Debug)]
pub struct Subject {
    /// Name of its pattern.
    pub name: String,
    /// The object.
    pub object: ImageObject,
    /// The maps of its images.
    pub maps: Vec<HeightMap>,
}

/// Which solid is asked about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Asked {
    /// The object.
    Object,
    /// The visual hull.
    Hull,
}

/// Allowed differences of answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// In nothing.
    Agree,
    /// As far as grazing allows.
    Grazing,
}

impl Subject {
    /// An object of maps and the views that they are of.
    ///
    /// # Panics
    ///
    /// When these make no object.
    pub fn new(
        name: String,
        views: Vec<View>,
        maps: Vec<HeightMap>,
        cells: JumpCells,
        jump_texels: f64,
    ) -> Self {
        let object = ImageObject::new(views, &maps, cells, jump_texels).expect("maps of their views");
        Self { name, object, maps }
    }

    /// Texture coordinates and height of a point in an image, by what its view says of itself; none behind
    /// the eye.
    pub fn see(&self, number: usize, point: DVec3) -> Option<DVec3> {
        let view = &self.object.views()[number];
        let ([right, down, toward], (centre, radius)) = (view.axes(), view.ball());
        let size = view.size().map(f64::from);
        let width = view.texel_m() * size[0];
        let aside = |from: DVec3| {
            let from = point - from;
            DVec2::new(from.dot(right) / width, from.dot(down) / (width * size[1] / size[0]))
        };
        let Some(eye) = view.eye() else {
            let at = aside(centre) + 0.5;
            return Some(at.extend((point - centre).dot(toward) / (2.0 * radius) + 0.5));
        };
        let (distance, depth) = ((eye - centre).length(), (eye - point).dot(toward));
        let at = aside(eye) * distance / depth + 0.5;
        let [near, far] = [distance - radius, distance + radius];
        // Inverse depths, from 0 at the far plane to 1 at the near one.
        let height = (1.0 / depth - 1.0 / far) / (1.0 / near - 1.0 / far);
        (depth > 0.0).then(|| at.extend(height))
    }

    /// Whether a point is in the solid of an image.
    pub fn is_in(&self, number: usize, point: DVec3, asked: Asked) -> bool {
        let Some(at) = self.see(number, point) else { return false };
        let map = &self.maps[number];
        let texel = |x: i64, y: i64| {
            let inside =
                (0..i64::from(map.width())).contains(&x) && (0..i64::from(map.height())).contains(&y);
            if inside { f64::from(map.texel(x, y)) } else { 0.0 }
        };
        let place = at.truncate() * DVec2::new(f64::from(map.width()), f64::from(map.height())) - 0.5;
        let (cell, share) = (place.floor(), place - place.floor());
        let [x, y] = cell.to_array().map(|at| at as i64);
        let corners = [texel(x, y), texel(x + 1, y), texel(x, y + 1), texel(x + 1, y + 1)];
        let between = |corners: [f64; 4]| {
            let weights = [1.0 - share.x, share.x].map(|x| [x * (1.0 - share.y), x * share.y]);
            let weights = [weights[0][0], weights[1][0], weights[0][1], weights[1][1]];
            weights.iter().zip(corners).map(|(weight, height)| weight * height).sum::<f64>()
        };
        if asked == Asked::Hull {
            let mask = between(corners.map(|height| if height > EMPTY_HEIGHT { 1.0 } else { 0.0 }));
            return mask >= 0.5 && at.z > EMPTY_HEIGHT && at.z <= 1.0;
        }
        let (least, most) =
            (corners.into_iter().fold(1.0, f64::min), corners.into_iter().fold(0.0, f64::max));
        let nearest = texel((place.x + 0.5).floor() as i64, (place.y + 0.5).floor() as i64);
        let jumps = most - least > self.object.jump();
        let height = match self.object.cells() {
            JumpCells::Nearest => nearest,
            JumpCells::Step if jumps => nearest,
            JumpCells::Highest if jumps => most,
            _ => between(corners),
        };
        at.z > EMPTY_HEIGHT && at.z <= height
    }

    /// Whether a point is in all solids.
    pub fn is_in_all(&self, point: DVec3, asked: Asked) -> bool {
        (0..self.maps.len()).all(|number| self.is_in(number, point, asked))
    }

    /// Whether about [`NEAR`] around a point there is something in the solid of an image, and something that
    /// is not.
    pub fn around(&self, number: usize, point: DVec3, asked: Asked) -> [bool; 2] {
        let view = &self.object.views()[number];
        let (radius, [right, down, _], toward) = (view.ball().1, view.axes(), view.toward(point));
        // By two distances on each axis, as where surfaces meet a solid may be sharp, or what is outside.
        let distances = [0.0, 1.0, -1.0, 1.0 / 256.0, -1.0 / 256.0];
        let mut found = [false; 2];
        for steps in 0..125 {
            let [x, y, z] = [steps % 5, steps / 5 % 5, steps / 25].map(|step| distances[step]);
            let aside = (right * x + down * y + toward * z) * (radius * NEAR);
            found[usize::from(!self.is_in(number, point + aside, asked))] = true;
            if found == [true; 2] {
                break;
            }
        }
        found
    }

    /// Whether about [`NEAR`] around a point there is something in each solid.
    pub fn is_near(&self, point: DVec3, asked: Asked) -> bool {
        (0..self.maps.len()).all(|number| self.around(number, point, asked)[0])
    }

    /// Whether all about [`NEAR`] around a point is in the object.
    pub fn is_deep(&self, point: DVec3, asked: Asked) -> bool {
        (0..self.maps.len()).all(|number| self.around(number, point, asked) == [true, false])
    }

    /// All parameters at which a ray is in the object.
    pub fn intervals(&self, ray: &Ray, asked: Asked) -> Vec<[f64; 2]> {
        match asked {
            Asked::Object => self.object.intervals(ray),
            Asked::Hull => self.object.hull_intervals(ray),
        }
    }

    /// The first hit by the images in turn.
    pub fn hit(&self, ray: &Ray, asked: Asked) -> Option<ObjectHit> {
        match asked {
            Asked::Object => self.object.first_hit(ray),
            Asked::Hull => self.object.hull_first_hit(ray),
        }
    }

    /// Returns the allowed difference of a ray's hits in its parameter: [`NEAR`] of the way.
    pub fn late(&self, ray: &Ray) -> f64 {
        let (centre, radius) = self.object.views()[0].ball();
        NEAR * (ray.origin.length() + centre.length() + radius) / ray.direction.length()
    }

    /// Judges where a ray is said to meet the object, by all intervals in which it is in it.
    ///
    /// # Errors
    ///
    /// What is wrong.
    pub fn judge(&self, ray: &Ray, asked: Asked, answer: Option<f64>) -> Result<Verdict, String> {
        let intervals = self.intervals(ray, asked);
        let (truth, late) = (intervals.first().map(|interval| interval[0]), self.late(ray));
        let agree = match (truth, answer) {
            (Some(truth), Some(answer)) => (truth - answer).abs() <= late,
            (None, None) => true,
            _ => false,
        };
        if agree {
            return Ok(Verdict::Agree);
        }
        let wrong =
            |what: &str| Err(format!("{what}: {answer:?}, truth {truth:?}\n{ray:?} at {}", self.name));
        let is_near = |t: f64| self.is_near(ray.at(t), asked);
        if truth.is_some_and(|t| !is_near(t)) {
            return wrong("the truth is not in the object");
        }
        if answer.is_some_and(|t| t.is_nan() || t < 0.0 || !is_near(t)) {
            return wrong("the hit is not in the object");
        }
        let far = answer.unwrap_or(f64::INFINITY);
        for [from, to] in intervals.into_iter().filter(|interval| interval[0] < far) {
            let length = to.min(far) - from;
            if (1..32).any(|part| self.is_deep(ray.at(from + length * f64::from(part) / 32.0), asked)) {
                return wrong("the hit is late, or missed");
            }
        }
        Ok(Verdict::Grazing)
    }
}

/// All adversarial objects with cells of a kind, of 1 to 17 images. Some are true views of an object, others
/// agree in nothing.
pub fn subjects(cells: JumpCells) -> Vec<Subject> {
    let mut rng = Rng::new(17 + cells as u64);
    let named = |name: &str| maps::ALL.iter().find(|map| map.name == name).expect("it is in the list");
    let mut all = Vec::new();
    // A quarter of all maps, as it comes, besides some that each kind of cells has to bear.
    let mut alone: Vec<&NamedMap> = ["white noise 37x53", "needles in a pit 64x64"].map(&named).to_vec();
    alone.extend(maps::ALL.iter().skip(cells as usize).step_by(4));
    for (turn, map) in alone.into_iter().enumerate() {
        let built = map.build(Wrap::Clamp);
        let views = vec![view(&mut rng, turn % 2 == 1, [built.width(), built.height()])];
        let name = format!("{}, one view, {cells:?}", map.name);
        all.push(Subject::new(name, views, vec![built], cells, rng.pick(&[0.0, 1.0, 4.0])));
    }
    let pair = [named("natural 101x67"), named("steps 61x40")].map(|map| map.build(Wrap::Clamp));
    let views = [0, 1].map(|turn| view(&mut rng, turn == 1, [pair[turn].width(), pair[turn].height()]));
    all.push(Subject::new(format!("two views, {cells:?}"), views.to_vec(), pair.to_vec(), cells, 2.0));
    let cube = |side: u32| {
        let view = |from| View::orthographic(DVec3::ZERO, RADIUS, from, None, [side; 2]).expect("a view");
        CUBE.map(view).to_vec()
    };
    for (name, views, seen) in [
        ("spheres in a cube", cube(24), true),
        ("noise in a cube", cube(23), false),
        ("spheres, 6 views", some_views(&mut rng, 6, 40), true),
        ("noise, 6 views", some_views(&mut rng, 6, 40), false),
        ("spheres, 17 views", some_views(&mut rng, 17, 31), true),
    ] {
        let maps =
            views.iter().map(|view| if seen { map_of_spheres(view) } else { high_noise(&mut rng, view) });
        let (maps, jump) = (maps.collect(), rng.pick(&[1.0, 4.0]));
        all.push(Subject::new(format!("{name}, {cells:?}"), views, maps, cells, jump));
    }
    all
}

/// A view of the ball that the spheres lie in, from anywhere.
fn view(rng: &mut Rng, perspective: bool, size: [u32; 2]) -> View {
    let (from, up) = (rng.direction(), Some(rng.direction()));
    let view = if perspective {
        let eye = from * rng.between(1.3, 6.0);
        View::perspective(DVec3::ZERO, RADIUS, eye, up, rng.between(30.0, 110.0), size)
    } else {
        View::orthographic(DVec3::ZERO, RADIUS, from, up, size)
    };
    view.expect("directions are not along each other")
}

fn some_views(rng: &mut Rng, count: usize, most: u32) -> Vec<View> {
    (0..count)
        .map(|turn| {
            let size = [0; 2].map(|_| most / 2 + rng.below(most / 2 + 1));
            view(rng, turn % 3 == 2, size)
        })
        .collect()
}

/// Noise that is high enough for images to have something in common, with holes.
fn high_noise(rng: &mut Rng, view: &View) -> HeightMap {
    let [width, height] = view.size();
    let texel = |_, _| if rng.below(12) == 0 { 0.0 } else { rng.between(0.6, 1.0) as f32 };
    HeightMap::from_fn(width, height, Wrap::Clamp, texel).expect("it has texels")
}
