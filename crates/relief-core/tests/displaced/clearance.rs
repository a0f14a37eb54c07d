//! Distance between a ray and a displaced mesh.

use glam::DVec3;
use relief_core::Wrap;
use relief_core::exact::DisplacedMesh;
use relief_core::mesh::square;

use relief_core::rng::Rng;
use relief_testing::displaced::scenes::{self, Heights, map};
use relief_testing::displaced::tessellation::tessellate;
use relief_testing::displaced::{judge_of, rays_of};

#[test]
fn level_rays_above_a_level_plane_are_as_far_as_they_are_high() {
    let map = map(Heights::Constant, [8, 8], Wrap::Repeat);
    let judge = DisplacedMesh::new(&square(2).expect("a mesh"), &map, 0.5, 0.0).expect("a displaced mesh");
    let height = 0.5 * f64::from(0.6f32);
    let clearance = |origin: [f64; 3], direction: [f64; 3]| judge.clearance(origin, direction);
    for above in [1e-3, 0.1, 3.0] {
        let level = clearance([-4.0, height + above, 0.1], [1.0, 0.0, 0.01]);
        assert!((level - above).abs() <= 1e-6 * above + 2e-9);
        // A ray that leaves is as far away as its origin.
        let leaving = clearance([0.1, height + above, 0.1], [0.1, 1.0, 0.3]);
        assert!((leaving - above).abs() <= 1e-6 * above + 2e-9);
    }
    assert_eq!(clearance([0.1, 4.0, 0.1], [0.0, -1.0, 0.0]), 0.0);
    assert_eq!(clearance([0.1, -4.0, 0.1], [0.0, 1.0, 0.0]), 0.0);
}

#[test]
fn no_point_of_the_sheet_is_nearer() {
    for scene in scenes::all().into_iter().step_by(3) {
        let judge = judge_of(&scene.sheet);
        let groups = tessellate(&scene.sheet, 6);
        let points: Vec<DVec3> =
            groups.iter().flat_map(|group| group.flats.iter().flat_map(|flat| flat.points)).collect();
        let longest = groups.iter().flat_map(|group| &group.flats).map(|flat| {
            let [a, b, c] = flat.points;
            a.distance(b).max(b.distance(c)).max(c.distance(a))
        });
        let longest = longest.fold(0.0, f64::max);
        let mut rng = Rng::new(3);
        let mut missed = 0;
        for mut ray in rays_of(&scene.sheet, 200) {
            ray.origin += 0.3 * rng.unit() * scene.sheet.size() * rng.direction();
            let clearance = judge.clearance(ray.origin.to_array(), ray.direction.to_array());
            let unit = ray.direction.normalize();
            let distance = |point: &DVec3| {
                let to = *point - ray.origin;
                (to - to.dot(unit).max(0.0) * unit).length()
            };
            let least = points.iter().map(distance).fold(f64::INFINITY, f64::min);
            assert!(clearance <= least * (1.0 + 1e-6) + 1e-8, "{}: {clearance}, {least}", scene.name);
            assert!(clearance >= least - 2.0 * longest, "{}: {clearance}, {least}", scene.name);
            missed += usize::from(clearance > 0.0);
        }
        assert!(missed > 20, "{}: {missed}", scene.name);
    }
}
