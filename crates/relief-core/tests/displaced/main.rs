//! The exact judge of displaced meshes against a tessellation whose error is bounded.

mod clearance;
mod compare;
mod edge_cases;
mod mutations;
mod plane;
mod rates;
mod rays;
mod rng;
mod scenes;
mod sheet;
mod tessellation;

use compare::{Fault, crossings, fault};
use rayon::prelude::*;
use rays::{KINDS, Ray, ray};
use relief_core::exact::{DisplacedHit, DisplacedMesh, Sides};
use rng::Rng;
use scenes::Scene;
use sheet::Sheet;
use tessellation::{Group, tessellate};

/// Rays of each scene.
const RAYS: usize = 4_500;

/// Triangles on each side of a triangle of a cell's polygon.
const DIVISIONS: usize = 6;

fn judge_of(sheet: &Sheet) -> DisplacedMesh {
    DisplacedMesh::new(&sheet.mesh, &sheet.map, sheet.scale_m, sheet.bias_m).expect("a displaced mesh")
}

/// What a comparison found.
#[derive(Default, Debug)]
struct Tally {
    hits: usize,
    /// Rays whose first crossing the tessellation proves.
    proved: usize,
    grazing: usize,
    /// The kind of ray with each.
    faults: Vec<(usize, Sides, Fault)>,
}

/// A first hit by any means.
type Judge<'a> = &'a (dyn Fn(&Ray, Sides) -> Option<DisplacedHit> + Sync);

fn rays_of(sheet: &Sheet, count: usize) -> Vec<Ray> {
    let mut rng = Rng(99);
    (0..count).map(|kind| ray(sheet, kind, &mut rng)).collect()
}

fn compare(scene: &Scene, groups: &[Group], count: usize, judge: Judge) -> Tally {
    let rays = rays_of(&scene.sheet, count);
    let one = |(number, ray): (usize, &Ray)| {
        let mut tally = Tally::default();
        let certain = crossings(groups, ray);
        for sides in [Sides::Front, Sides::Both] {
            let hit = judge(ray, sides);
            let found = fault(&scene.sheet, &certain, ray, sides, hit.as_ref(), scene.unfolded);
            tally.faults.extend(found.map(|fault| (number % KINDS, sides, fault)));
            if sides == Sides::Both {
                tally.hits += usize::from(hit.is_some());
                tally.proved += usize::from(!certain.is_empty());
                tally.grazing += usize::from(hit.is_some_and(|hit| hit.grazing));
            }
        }
        tally
    };
    let sum = |mut a: Tally, mut b: Tally| {
        a.faults.append(&mut b.faults);
        Tally { hits: a.hits + b.hits, proved: a.proved + b.proved, grazing: a.grazing + b.grazing, ..a }
    };
    rays.par_iter().enumerate().map(one).reduce(Tally::default, sum)
}

fn first_hit(judge: &DisplacedMesh) -> impl Fn(&Ray, Sides) -> Option<DisplacedHit> + Sync {
    |ray, sides| judge.first_hit(ray.origin.to_array(), ray.direction.to_array(), sides)
}

#[test]
fn the_judge_agrees_with_a_tessellation_wherever_that_can_tell() {
    for scene in scenes::all() {
        let judge = judge_of(&scene.sheet);
        let groups = tessellate(&scene.sheet, DIVISIONS);
        let tally = compare(&scene, &groups, RAYS, &first_hit(&judge));
        println!("{}: {} hits, {} proved, {} grazing", scene.name, tally.hits, tally.proved, tally.grazing);
        assert!(tally.faults.is_empty(), "{}: {:?}", scene.name, &tally.faults[..tally.faults.len().min(5)]);
        assert!(tally.proved * 3 > tally.hits && tally.hits * 4 > RAYS, "{}: {tally:?}", scene.name);
    }
}
