//! Deliberate mistakes of an exact tracer. The comparison must notice each of them.

use glam::{DMat3, DVec3};
use relief_core::Wrap;
use relief_core::exact::{DisplacedHit, DisplacedMesh, Sides};

use relief_testing::displaced::rays::Ray;
use relief_testing::displaced::scenes::{self, Scene};
use relief_testing::displaced::sheet::Sheet;
use relief_testing::displaced::tessellation::tessellate;
use relief_testing::displaced::{DIVISIONS, Judge, compare, first_hit, judge_of};

const RAYS: usize = 4_500;

fn scene(name: &str) -> Scene {
    scenes::all().into_iter().find(|scene| scene.name.starts_with(name)).expect("a scene of that name")
}

/// Number of answers that are found to be wrong.
fn faults(scene: &Scene, judge: Judge) -> usize {
    compare(scene, &tessellate(&scene.sheet, DIVISIONS), RAYS, judge).faults.len()
}

/// The first hit that is not overlooked.
fn overlooking(
    judge: &DisplacedMesh,
    ray: &Ray,
    sides: Sides,
    overlooked: impl Fn(&DisplacedHit) -> bool,
) -> Option<DisplacedHit> {
    let mut from = 0.0;
    for _ in 0..50 {
        let origin = (ray.origin + from * ray.direction).to_array();
        let mut hit = judge.first_hit(origin, ray.direction.to_array(), sides)?;
        hit.t += from;
        if !overlooked(&hit) {
            return Some(hit);
        }
        from = hit.t + 1e-7 / ray.direction.length();
    }
    None
}

/// The crossing of another sheet near a hit, by Newton's method, or the hit itself if that fails.
fn moved_to(sheet: &Sheet, ray: &Ray, hit: &DisplacedHit) -> DisplacedHit {
    let weights = |at: DVec3| [1.0 - at.x - at.y, at.x, at.y];
    let gap = |at: DVec3| sheet.point(hit.triangle, weights(at)) - (ray.origin + at.z * ray.direction);
    let mut at = DVec3::new(hit.weights[1], hit.weights[2], hit.t);
    for _ in 0..20 {
        let columns = DVec3::AXES.map(|axis| (gap(at + 1e-7 * axis) - gap(at - 1e-7 * axis)) / 2e-7);
        at -= DMat3::from_cols(columns[0], columns[1], columns[2]).inverse() * gap(at);
    }
    let (w, t) = (weights(at), at.z);
    let is_there = gap(at).length() < 1e-13 && w.iter().all(|w| (0.0..=1.0).contains(w)) && t >= 0.0;
    if !is_there {
        return *hit;
    }
    let position = sheet.point(hit.triangle, w).to_array();
    let (uv, height) = (sheet.uv(hit.triangle, w).to_array(), sheet.height(hit.triangle, w));
    DisplacedHit { t, weights: w, uv, height, position, ..*hit }
}

#[test]
fn normalised_normals_are_noticed() {
    let scene = scene("torus, noise");
    let judge = judge_of(&scene.sheet);
    let first = first_hit(&judge);
    let wrong = Sheet { normalised: true, ..scene.sheet.clone() };
    let moved = |sheet: &Sheet, ray: &Ray, sides| first(ray, sides).map(|hit| moved_to(sheet, ray, &hit));
    assert_eq!(faults(&scene, &|ray, sides| moved(&scene.sheet, ray, sides)), 0);
    assert!(faults(&scene, &|ray, sides| moved(&wrong, ray, sides)) > RAYS / 2);
}

#[test]
fn bounds_of_the_corners_heights_alone_are_noticed() {
    let scene = scene("torus, noise");
    let (sheet, judge) = (&scene.sheet, judge_of(&scene.sheet));
    let outside = |hit: &DisplacedHit| {
        let heights = DVec3::AXES.map(|corner| sheet.height(hit.triangle, corner.to_array()));
        heights.iter().all(|height| *height < hit.height) || heights.iter().all(|height| *height > hit.height)
    };
    assert!(faults(&scene, &|ray, sides| overlooking(&judge, ray, sides, outside)) > 0);
}

#[test]
fn cracks_between_cells_and_triangles_are_noticed() {
    let scene = scene("sphere, noise");
    let (sheet, judge) = (&scene.sheet, judge_of(&scene.sheet));
    let between_cells = |hit: &DisplacedHit| {
        let place = sheet.place(hit.triangle, hit.weights);
        (place - place.round()).abs().min_element() < 1e-9
    };
    assert!(faults(&scene, &|ray, sides| overlooking(&judge, ray, sides, between_cells)) > 0);
    let on_a_side = |hit: &DisplacedHit| hit.weights.iter().any(|weight| *weight < 1e-9);
    assert!(faults(&scene, &|ray, sides| overlooking(&judge, ray, sides, on_a_side)) > 0);
}

#[test]
fn near_tangents_that_are_lost_are_noticed() {
    let scene = scene("torus, smooth");
    let (sheet, judge) = (&scene.sheet, judge_of(&scene.sheet));
    for least in [1e-2, 1e-3] {
        let along = |ray: &Ray, hit: &DisplacedHit| {
            let step = |k: usize| {
                let mut weights = hit.weights;
                weights[k] += 1e-7;
                weights[0] -= 1e-7;
                (sheet.point(hit.triangle, weights) - DVec3::from(hit.position)) / 1e-7
            };
            let normal = step(1).cross(step(2)).normalize();
            normal.dot(ray.direction.normalize()).abs() < least
        };
        let lost = faults(&scene, &|ray, sides| overlooking(&judge, ray, sides, |hit| along(ray, hit)));
        assert!(lost > 0, "{least}");
    }
}

#[test]
fn a_later_hit_a_wrong_side_and_a_wrong_map_are_noticed() {
    let scene = scene("torus, spikes");
    let sheet = &scene.sheet;
    let judge = judge_of(sheet);
    let second = |ray: &Ray, sides| {
        let first = first_hit(&judge)(ray, sides)?;
        overlooking(&judge, ray, sides, |hit| hit.t <= first.t)
    };
    assert!(faults(&scene, &second) > 0);
    assert!(faults(&scene, &|ray, _| first_hit(&judge)(ray, Sides::Both)) > 0);
    assert!(faults(&scene, &|_, _| None) > 0);
    let other = |map, scale_m: f64, bias_m: f64| {
        let judge = DisplacedMesh::new(&sheet.mesh, &map, scale_m, bias_m).expect("a displaced mesh");
        faults(&scene, &first_hit(&judge))
    };
    let (map, scale_m, bias_m) = (sheet.map.clone(), sheet.scale_m, sheet.bias_m);
    assert_eq!(other(map.clone(), scale_m, bias_m), 0);
    assert!(other(map.clone().with_wrap(Wrap::Clamp), scale_m, bias_m) > 0);
    assert!(other(map.clone(), scale_m * (1.0 + 1e-9), bias_m) > 0);
    assert!(other(map, scale_m, 0.0) > 0);
}
