//! Shadows that surfaces throw on each other, beside the exact judge: looked up in what the light sees, and
//! by rays through the whole scene.

use glam::DVec3;
use relief_scene::BackendChoice;
use relief_scene::light::Light;
use relief_testing::outline::{distances_of_lines, overlap};
use relief_tests::adapter::has_adapter;
use relief_tests::cast::{Meeting, Shown, agreement, mask};

/// The picture's size; a texel of what the light sees is as large beside a pixel as 2048 are in one of
/// 800x600.
const SIZE: [u32; 2] = [240, 180];
const TEXELS: f64 = 614.0;

/// Most of the pixels that both show.
const NEARLY_ALL: f64 = 0.999;

/// The given part of distances between lines in pixels.
fn at(distances: &[f64], part: f64) -> f64 {
    let mut sorted = distances.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted[(part * (sorted.len() - 1) as f64) as usize]
}

fn lines(a: &[Option<Shown>], b: &[Option<Shown>], of: impl Fn(Shown) -> bool) -> Vec<f64> {
    let covered = mask(a, SIZE, |_| true);
    distances_of_lines(&mask(a, SIZE, &of), &mask(b, SIZE, &of), &covered)
}

/// The same light a few degrees beside.
fn turned(light: Light) -> Light {
    match light {
        Light::Directional { toward, irradiance, .. } => {
            Light::directional(toward + DVec3::X * 0.1, irradiance).expect("a light")
        }
        Light::Point { position_m, intensity, .. } => {
            Light::point(position_m + DVec3::X * 0.1, intensity).expect("a light")
        }
    }
}

#[test]
fn edges_of_looked_up_shadows_are_those_of_the_judge() {
    let meeting = Meeting::new();
    let settings = [("shadow.size", TEXELS)];
    for light in Meeting::lights() {
        let judged = meeting.judged(light, SIZE);
        let drawn = meeting.rendered("map", &settings, light, SIZE, BackendChoice::Cpu);
        let apart = lines(&drawn, &judged, |shown| !shown.lit);
        let share = agreement(&drawn, &judged);
        println!(
            "map: {} pixels of edges, p50 {}, p95 {}, {share}",
            apart.len(),
            at(&apart, 0.5),
            at(&apart, 0.95)
        );
        assert!(apart.len() > 800 && at(&apart, 0.5) <= 1.5 && at(&apart, 0.95) <= 4.0);
        assert!(share > 0.97, "{share}");
        // Both see that the ring is sunk into the ground in the same line.
        let met = lines(&drawn, &judged, |shown| shown.surface == 1);
        assert!(met.len() > 100 && at(&met, 0.95) <= 1.5, "{}", at(&met, 0.95));
        // A light that is elsewhere throws others.
        let elsewhere = meeting.rendered("map", &settings, turned(light), SIZE, BackendChoice::Cpu);
        assert!(agreement(&elsewhere, &judged) < share - 0.01);
    }
}

#[test]
fn cascades_hold_what_the_camera_sees() {
    let meeting = Meeting::new();
    let [light, _] = Meeting::lights();
    let judged = meeting.judged(light, SIZE);
    let settings = [("shadow.size", TEXELS / 2.0), ("shadow.cascades", 3.0)];
    let share = agreement(&meeting.rendered("map", &settings, light, SIZE, BackendChoice::Cpu), &judged);
    println!("three cascades: {share}");
    assert!(share > 0.96, "{share}");
}

#[test]
fn rays_through_the_scene_agree_with_the_judge() {
    let meeting = Meeting::new();
    for light in Meeting::lights() {
        let judged = meeting.judged(light, SIZE);
        let traced = meeting.rendered("scene", &[], light, SIZE, BackendChoice::Cpu);
        let share = agreement(&traced, &judged);
        println!("scene: {share}");
        assert!(share >= NEARLY_ALL, "{share}");
        let elsewhere = meeting.rendered("scene", &[], turned(light), SIZE, BackendChoice::Cpu);
        assert!(agreement(&elsewhere, &judged) < NEARLY_ALL);
        // Without what others throw there is more light.
        let alone = meeting.rendered("ray", &[], light, SIZE, BackendChoice::Cpu);
        assert!(agreement(&alone, &judged) < NEARLY_ALL - 0.01);
    }
}

#[test]
fn both_backends_look_up_the_same_shadows() {
    if !has_adapter() {
        return;
    }
    let meeting = Meeting::new();
    for light in Meeting::lights() {
        let settings = [("shadow.size", 256.0), ("shadow.filter", 3.0)];
        let [cpu, gpu] = [BackendChoice::Cpu, BackendChoice::Gpu]
            .map(|backend| meeting.rendered("map", &settings, light, SIZE, backend));
        let covered = [&cpu, &gpu].map(|shown| mask(shown, SIZE, |_| true));
        let [both, either] = overlap(&covered[0], &covered[1]);
        assert!(both as f64 >= NEARLY_ALL * either as f64);
        let share = agreement(&cpu, &gpu);
        println!("both backends: {share}");
        assert!(share >= NEARLY_ALL, "{share}");
    }
}
