//! The exact tracer of displaced meshes against a tessellation whose error is bounded.

mod clearance;
mod edge_cases;
mod mutations;
mod plane;
mod rates;

use relief_testing::displaced::tessellation::tessellate;
use relief_testing::displaced::{DIVISIONS, compare, first_hit, judge_of, scenes};

/// Rays of each scene.
const RAYS: usize = 4_500;

#[test]
fn the_judge_agrees_with_a_tessellation_wherever_that_can_tell() {
    for scene in scenes::all() {
        let judge = judge_of(&scene.sheet);
        let groups = tessellate(&scene.sheet, DIVISIONS);
        let tally = compare(&scene, &groups, RAYS, &first_hit(&judge));
        let all = tally.all();
        println!("{}: {} hits, {} proved, {} grazing", scene.name, all.hits, all.proved, all.grazing);
        assert!(tally.faults.is_empty(), "{}: {:?}", scene.name, &tally.faults[..tally.faults.len().min(5)]);
        assert!(all.proved * 3 > all.hits && all.hits * 4 > RAYS, "{}: {tally:?}", scene.name);
    }
}
