//! What the survey claims about the methods' order, and that more steps come nearer the truth.

use relief_core::registry::RayClass;
use relief_testing::RAYS_PER_MAP;
use relief_tests::accuracy::{case, maps, mean_error, report_with};
use relief_tests::baked::{maps_for, slots};
use relief_tests::claims::verdicts;
use relief_tests::pairs;

/// Rays a map and angle: every claim traces four times the five maps.
const RAYS: usize = RAYS_PER_MAP / 10;

#[test]
fn every_claim_is_borne_out_or_recorded_as_refuted() {
    for verdict in verdicts(&maps(), RAYS) {
        let claim = verdict.claim;
        assert_eq!(
            verdict.holds(),
            claim.holds,
            "section {}: {}: {} has {}, {} has {}",
            claim.section,
            claim.text,
            claim.better,
            verdict.better,
            claim.worse,
            verdict.worse
        );
    }
}

#[test]
fn relief_and_occlusion_come_nearer_with_every_doubling_of_their_steps() {
    let maps = maps();
    for method in ["relief", "occlusion"] {
        let errors: Vec<(f64, f64)> = [8, 16, 32, 64, 128, 256]
            .into_iter()
            .map(|steps| mean_error(&maps, method, steps, RAYS).expect("the method has steps"))
            .collect();
        for pair in errors.windows(2) {
            assert!(pair[1].0 < pair[0].0, "{method}: mean errors in texels {errors:?}");
            assert!(pair[1].1 < pair[0].1, "{method}: shares that pass the first hit {errors:?}");
        }
    }
}

#[test]
fn the_exact_pairs_of_stages_find_every_first_hit() {
    for exact in pairs::exact_for(RayClass::View) {
        for named in &maps() {
            let baked = maps_for(&named.map, &exact);
            let maps = slots(&named.map, &exact, &baked);
            for degrees in [10.0, 60.0, 85.0] {
                let report = report_with(&case(&named.map, degrees, RAYS), &exact, &maps);
                let name = format!("{}, {} at {degrees} degrees", pairs::name(&exact), named.name);
                // Rays that graze within the rounding of f32 may be judged either way.
                let wrong = report.missed + report.false_hits + report.late + report.early + report.exhausted;
                assert!(wrong <= 1e-3, "{name}: {report:?}");
                assert!(report.distance_texels.median < 1e-3, "{name}: {report:?}");
            }
        }
    }
}
