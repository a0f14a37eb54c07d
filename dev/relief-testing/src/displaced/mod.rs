//! The exact judge of displaced meshes beside a tessellation whose error is bounded.

pub mod compare;
pub mod rays;
pub mod scenes;
pub mod sheet;
pub mod tessellation;

use rayon::prelude::*;
use relief_core::exact::{DisplacedHit, DisplacedMesh, Sides};

use compare::{Fault, crossings, fault};
use rays::{KINDS, Ray, ray};
use relief_core::rng::Rng;
use scenes::Scene;
use sheet::Sheet;
use tessellation::Group;

/// Triangles on each side of a triangle of a cell's polygon.
pub const DIVISIONS: usize = 6;

/// The judge of a sheet.
///
/// # Panics
///
/// When a sheet's lengths are none.
pub fn judge_of(sheet: &Sheet) -> DisplacedMesh {
    DisplacedMesh::new(&sheet.mesh, &sheet.map, sheet.scale_m, sheet.bias_m).expect("a displaced mesh")
}

/// Rays of one kind.
#[derive(Clone, Copy, Default, Debug)]
pub struct Counts {
    /// Number of rays.
    pub rays: usize,
    /// Rays that hit a side.
    pub hits: usize,
    /// Rays whose crossing the tessellation proves.
    pub proved: usize,
    /// Rays whose hit cannot be distinguished from a touch.
    pub grazing: usize,
}

/// Results of a comparison.
#[derive(Clone, Default, Debug)]
pub struct Tally {
    /// Counts of each of the [`KINDS`].
    pub kinds: [Counts; KINDS.len()],
    /// Faults, each with its kind of ray.
    pub faults: Vec<(&'static str, Sides, Fault)>,
}

impl Counts {
    fn plus(self, other: Self) -> Self {
        Self {
            rays: self.rays + other.rays,
            hits: self.hits + other.hits,
            proved: self.proved + other.proved,
            grazing: self.grazing + other.grazing,
        }
    }
}

impl Tally {
    /// Sums over all kinds.
    pub fn all(&self) -> Counts {
        self.kinds.into_iter().fold(Counts::default(), Counts::plus)
    }

    /// The sum of two.
    #[must_use]
    pub fn plus(mut self, mut other: Self) -> Self {
        self.faults.append(&mut other.faults);
        let kinds = std::array::from_fn(|kind| self.kinds[kind].plus(other.kinds[kind]));
        Self { kinds, faults: self.faults }
    }
}

/// A first hit by any means.
pub type Judge<'a> = &'a (dyn Fn(&Ray, Sides) -> Option<DisplacedHit> + Sync);

/// Returns the given number of rays, of all kinds in turn.
pub fn rays_of(sheet: &Sheet, count: usize) -> Vec<Ray> {
    let mut rng = Rng::new(99);
    (0..count).map(|kind| ray(sheet, kind, &mut rng)).collect()
}

/// Compares a judge of a scene with its tessellation along the given number of rays.
pub fn compare(scene: &Scene, groups: &[Group], count: usize, judge: Judge) -> Tally {
    let rays = rays_of(&scene.sheet, count);
    let one = |mut tally: Tally, (number, ray): (usize, &Ray)| {
        let kind = number % KINDS.len();
        let certain = crossings(groups, ray);
        for sides in [Sides::Front, Sides::Both] {
            let hit = judge(ray, sides);
            let found = fault(&scene.sheet, &certain, ray, sides, hit.as_ref(), scene.unfolded);
            tally.faults.extend(found.map(|fault| (KINDS[kind], sides, fault)));
            if sides == Sides::Both {
                let counts = Counts {
                    rays: 1,
                    hits: usize::from(hit.is_some()),
                    proved: usize::from(!certain.is_empty()),
                    grazing: usize::from(hit.is_some_and(|hit| hit.grazing)),
                };
                tally.kinds[kind] = tally.kinds[kind].plus(counts);
            }
        }
        tally
    };
    rays.par_iter().enumerate().fold(Tally::default, one).reduce(Tally::default, Tally::plus)
}

/// The first hits of the judge itself.
pub fn first_hit(judge: &DisplacedMesh) -> impl Fn(&Ray, Sides) -> Option<DisplacedHit> + Sync {
    |ray, sides| judge.first_hit(ray.origin.to_array(), ray.direction.to_array(), sides)
}
