//! What shadows that are not exact make of it, beside rays of the exact search.

use relief_core::HeightMap;
use relief_core::mesh::Builtin;
use relief_scene::BackendChoice;
use relief_tests::accuracy::maps;
use relief_tests::shadows::{Lit, mean_error, squared_error, wrong};

const ELEVATIONS_DEG: [f64; 3] = [15.0, 30.0, 50.0];

/// The disc of lights with one, in degrees.
const DISC_DEG: f64 = 5.0;

fn named(name: &str) -> HeightMap {
    maps().into_iter().find(|named| named.name == name).expect("a sample map").map
}

fn lit(map: &HeightMap, mesh: Builtin, elevation_deg: f64, diameter_deg: f64) -> Lit<'_> {
    Lit { map, mesh, elevation_deg, diameter_deg, size: [100, 75], backend: BackendChoice::Cpu }
}

#[test]
fn horizons_and_the_lights_entry_come_near_and_more_azimuths_nearer() {
    let mut sums = [0.0; 2];
    for name in ["cobbles", "bricks", "ground"] {
        let map = named(name);
        for mesh in [Builtin::Plane, Builtin::Sphere, Builtin::Torus] {
            for elevation in ELEVATIONS_DEG {
                let [ray, none, entry, few, many] = lit(&map, mesh, elevation, 0.0).parts([
                    ("ray", &[]),
                    ("none", &[]),
                    ("entry", &[]),
                    ("horizon", &[]),
                    ("horizon", &[("shadow.azimuths", 32.0)]),
                ]);
                let case = format!("{name} {mesh} {elevation}");
                let [none, entry, few, many] = [none, entry, few, many].map(|parts| wrong(&parts, &ray));
                println!("{case}: none {none:.4}, entry {entry:.4}, horizon {few:.4} {many:.4}");
                assert!(entry <= 0.005, "{case}: entry {entry}");
                if mesh == Builtin::Plane {
                    assert!(few <= 0.04 && many <= 0.02, "{case}: horizon {few} {many}");
                }
                // A comparison that sees nothing would see nothing of missing shadows either.
                assert!(none > 4.0 * few.max(many).max(entry) || none < 0.001, "{case}: {none}");
                sums = [sums[0] + few, sums[1] + many];
            }
        }
    }
    assert!(sums[1] < 0.9 * sums[0], "{sums:?}");
}

#[test]
fn a_disc_is_the_better_seen_the_more_rays_there_are_and_by_horizons_well() {
    const SAMPLES: [f64; 7] = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0];
    let (mut horizons, mut errors) = (Vec::new(), [0.0; SAMPLES.len()]);
    for name in ["cobbles", "bricks"] {
        let map = named(name);
        for elevation in ELEVATIONS_DEG {
            let lit = lit(&map, Builtin::Plane, elevation, DISC_DEG);
            let truth = lit.truth();
            for (sum, samples) in errors.iter_mut().zip(SAMPLES) {
                let [parts] = lit.parts([("soft", &[("shadow.samples", samples)])]);
                *sum += squared_error(&parts, &truth);
            }
            let [parts] = lit.parts([("horizon", &[])]);
            horizons.push(mean_error(&parts, &truth));
        }
    }
    println!("squared errors {errors:.6?}");
    assert!(errors.windows(2).all(|pair| pair[1] <= 0.5 * pair[0]), "{errors:?}");
    println!("horizons: mean errors {horizons:.4?}");
    assert!(horizons.iter().sum::<f64>() / horizons.len() as f64 <= 0.03, "{horizons:?}");
}

#[test]
fn many_rays_see_the_disc_that_the_light_has() {
    let map = named("cobbles");
    let lit = lit(&map, Builtin::Plane, 30.0, DISC_DEG);
    let truth = lit.truth();
    let most: &[(&str, f64)] = &[("shadow.samples", 256.0)];
    let [right] = lit.parts([("soft", most)]);
    let [wider] = Lit { diameter_deg: 1.1 * DISC_DEG, ..lit }.parts([("soft", most)]);
    let [right, wider] = [right, wider].map(|parts| squared_error(&parts, &truth));
    println!("squared error {right:.2e}, of a disc a tenth wider {wider:.2e}");
    assert!(2.0 * right < wider, "{right} {wider}");
}

#[test]
fn three_directions_decide_better_than_the_nearest() {
    let (mut nearest_wrong, mut three_wrong) = (0.0, 0.0);
    for name in ["cobbles", "bricks"] {
        let map = named(name);
        for elevation in ELEVATIONS_DEG {
            let [ray, nearest, three] = lit(&map, Builtin::Plane, elevation, 0.0).parts([
                ("ray", &[]),
                ("visibility", &[("shadow.directions", 1.0)]),
                ("visibility", &[]),
            ]);
            nearest_wrong += wrong(&nearest, &ray);
            three_wrong += wrong(&three, &ray);
        }
    }
    assert!(three_wrong < 0.9 * nearest_wrong, "{three_wrong} {nearest_wrong}");
}
