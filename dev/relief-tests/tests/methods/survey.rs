//! What the survey claims about the methods' order, and that more steps come nearer the truth.

use relief_core::Watch;
use relief_core::camera::Camera;
use relief_core::mesh::square;
use relief_core::registry::RayClass;
use relief_maps::Maps;
use relief_render::render;
use relief_scene::{BackendChoice, Scene, Surface};
use relief_shaders::Selection;
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

/// Oliveira and Policarpo 2005, section 2, say that view-dependent maps are for closed surfaces only.
#[test]
fn view_dependent_maps_err_at_an_open_edge_no_more_than_elsewhere() {
    let size = [256u32, 192];
    let cobbles = maps().into_iter().find(|named| named.name == "cobbles").expect("a map").map;
    let texels = f64::from(cobbles.width());
    let pixels = |method: &str| {
        let mut selection = Selection::method(method).expect("a method");
        selection.choose("shadow", "none").expect("a listed name");
        let square = square(1).expect("a mesh");
        let camera = Camera::new([0.9, 0.35, 0.9].into(), [0.0; 3].into(), 40.0).expect("a camera");
        let surface = Surface::new(square, cobbles.clone()).with_selection(selection);
        let builder = Scene::builder(surface).camera(camera).size(size[0], size[1]).samples(1);
        let scene = builder.backend(BackendChoice::Cpu).build().expect("a proper scene");
        render(&scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture").rendering.pixels
    };
    let (exact, shown) = (pixels("exact"), pixels("view-dependent"));
    let is_near_edge = |at: usize| {
        let [x, y] = [at as i64 % i64::from(size[0]), at as i64 / i64::from(size[0])];
        let around = (-3..=3).flat_map(|dy| (-3..=3).map(move |dx| [x + dx, y + dy]));
        around.into_iter().any(|[x, y]| {
            let is_inside = (0..i64::from(size[0])).contains(&x) && (0..i64::from(size[1])).contains(&y);
            is_inside && exact[(y * i64::from(size[0]) + x) as usize].hit == 0
        })
    };
    let (mut counts, mut off) = ([0.0; 2], [0.0; 2]);
    for (at, (a, b)) in exact.iter().zip(&shown).enumerate() {
        assert_eq!(a.hit, b.hit, "pixel {at}");
        if a.hit == 1 {
            let place = usize::from(is_near_edge(at));
            counts[place] += 1.0;
            let beside = f64::from((a.uv.x - b.uv.x).hypot(a.uv.y - b.uv.y)) * texels;
            off[place] += f64::from(u8::from(beside > 0.5));
        }
    }
    let [inside, near] = [0, 1].map(|place| off[place] / counts[place]);
    assert!(counts[1] > 500.0 && inside > 0.1, "{counts:?} {inside}");
    assert!(near < 1.1 * inside, "{near} near the edge, {inside} inside");
}
