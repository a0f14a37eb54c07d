//! The kind `relaxed-cone`: no falling ray comes out inside a cone, and the cones are wider than those of `cone`.

use rayon::prelude::*;
use relief::{HeightMap, Wrap};
use relief_bake::kind::cone::{ConeApex, cone_ratios, decode};
use relief_bake::kind::relaxed_cone::{KIND, RelaxedApex, relaxed_cone_ratios};
use relief_bake::{Collected, Metric, Progress, bake, quantise};
use relief_tests::maps;
use relief_tests::probes::relaxed_cone::{Exit, Probes, attack};

/// Probes of each map in each form.
const PROBES: usize = 100_000;

/// The maps that are attacked.
const ATTACKED: [&str; 8] = [
    "white noise 37x53",
    "natural 128x128",
    "natural 101x67",
    "single spike 33x31",
    "needles in a pit 64x64",
    "ramp 32x17",
    "steps 61x40",
    "one row 1x29",
];

fn metric(k: usize) -> Metric {
    Metric::new([[1.0, 1.0], [3.0, 0.7]][k % 2], 0.1).expect("positive lengths")
}

fn attacked() -> Vec<HeightMap> {
    let named = maps::ALL.iter().filter(|map| ATTACKED.contains(&map.name));
    let built: Vec<HeightMap> =
        named.enumerate().map(|(k, map)| map.build(Wrap::ALL[k % Wrap::ALL.len()])).collect();
    assert_eq!(built.len(), ATTACKED.len());
    built
}

fn relaxed(map: &HeightMap, metric: &Metric, apex: RelaxedApex) -> Vec<f32> {
    relaxed_cone_ratios(map, metric, apex, &Progress::none()).expect("nobody cancels")
}

/// The stored map as a reader decodes it, and the heights that it was baked from.
fn stored(map: &HeightMap, metric: Metric, apex: u32, bits: u32) -> (Vec<f64>, HeightMap) {
    let mut settings = KIND.defaults();
    settings.set("apex", f64::from(apex)).expect("an apex");
    settings.set("bits", f64::from(bits)).expect("bits");
    let mut sink = Collected::default();
    bake(&KIND, map, metric, &settings, &Progress::none(), &mut sink).expect("the map can be baked");
    let half = metric.tile_m[0].min(metric.tile_m[1]) / 8.0;
    let decoded = sink.textures[0].levels[0][0].iter().map(|&value| decode(value, half)).collect();
    let heights = if bits == 0 { map.clone() } else { quantise::heights(map, bits).expect("a valid map") };
    (decoded, heights)
}

fn place(map: &HeightMap, [i, j]: [i64; 2]) -> usize {
    j as usize * map.width() as usize + i as usize
}

#[test]
fn no_falling_ray_comes_out_in_a_cone() {
    let cases: Vec<(usize, u32, u32)> = (0..ATTACKED.len())
        .flat_map(|k| [0, 8, 16].into_iter().flat_map(move |bits| [0, 1].map(move |apex| (k, bits, apex))))
        .collect();
    let maps = attacked();
    cases.into_par_iter().for_each(|(k, bits, apex)| {
        let (values, heights) = stored(&maps[k], metric(k), apex, bits);
        let probes = Probes::new(&heights, metric(k).texel_m(&heights), apex == 1, u64::from(bits) + 1);
        let (violations, tightest) = attack(probes, PROBES, |exit| values[place(&heights, exit.texel)]);
        assert_eq!(violations, 0, "{} with {bits} bits, apex {apex}: {tightest:?}", ATTACKED[k]);
    });
}

#[test]
fn a_map_loosened_past_its_tightest_ray_is_caught() {
    for (k, map) in attacked().iter().enumerate() {
        for bits in [8, 16] {
            let (values, heights) = stored(map, metric(k), 0, bits);
            let probes = || Probes::new(&heights, metric(k).texel_m(&heights), false, 3);
            let ratio = |exit: &Exit| values[place(&heights, exit.texel)];
            let (_, tightest) = attack(probes(), PROBES, ratio);
            let tightest = tightest.expect("there are probes");
            if tightest.limit.is_infinite() {
                continue;
            }
            let half = metric(k).tile_m[0].min(metric(k).tile_m[1]) / 8.0;
            let most = f64::from((1u32 << bits) - 1);
            let code = (tightest.limit / (tightest.limit + half)).sqrt() * most;
            let loosened = ((code.floor() + 1.0) / most) as f32;
            let loosened = if loosened < 1.0 { decode(loosened, half) } else { f64::MAX };
            let caught =
                attack(
                    probes(),
                    PROBES,
                    |exit| {
                        if exit.texel == tightest.texel { loosened } else { ratio(exit) }
                    },
                );
            assert!(caught.0 > 0, "{} with {bits} bits: {tightest:?}", ATTACKED[k]);
        }
    }
}

#[test]
fn relaxed_cones_are_wider_and_near_what_rays_allow() {
    for (k, map) in attacked().iter().enumerate() {
        for (region, apex) in
            [(RelaxedApex::Centre, ConeApex::Centre), (RelaxedApex::Footprint, ConeApex::Footprint)]
        {
            let wide = relaxed(map, &metric(k), region);
            let narrow = cone_ratios(map, &metric(k), apex, &Progress::none()).expect("nobody cancels");
            let slope = |ratios: &[f32]| {
                ratios.iter().map(|&m| 1.0 / f64::from(m)).sum::<f64>() / ratios.len() as f64
            };
            // The steepest of many rays that come out, as far as they were found.
            let mut found = vec![0.0f64; wide.len()];
            let probes = Probes::new(map, metric(k).texel_m(map), region == RelaxedApex::Footprint, 9);
            for exit in probes.take(4 * PROBES) {
                let slot = &mut found[place(map, exit.texel)];
                *slot = slot.max(1.0 / exit.limit);
            }
            let found = found.iter().sum::<f64>() / found.len() as f64;
            println!(
                "{} {region:?}: mean slope {:.4}, of `cone` {:.4}, of rays found {found:.4}",
                ATTACKED[k],
                slope(&wide),
                slope(&narrow)
            );
            assert!(
                wide.iter().zip(&narrow).all(|(wide, narrow)| *wide >= narrow * 0.999),
                "{}",
                ATTACKED[k]
            );
        }
    }
}

#[test]
fn tiles_very_much_longer_than_wide_get_plain_cones() {
    // Found by fuzzing: the images near enough to matter were millions.
    let metric = Metric::new([0.00390625, 128.0], 128.0).expect("lengths");
    let rough = |i: u32, j: u32| ((i * 7 + j * 13) % 11) as f32 / 10.0;
    let nearly_level = |i: u32, j: u32| if (i, j) == (1, 0) { 0.1 } else { 0.0 };
    for wrap in [Wrap::Repeat, Wrap::Mirror] {
        for map in [HeightMap::from_fn(16, 16, wrap, rough), HeightMap::from_fn(13, 16, wrap, nearly_level)] {
            let map = map.expect("a valid map");
            let relaxed = relaxed_cone_ratios(&map, &metric, RelaxedApex::Footprint, &Progress::none());
            let plain = cone_ratios(&map, &metric, ConeApex::Footprint, &Progress::none());
            assert_eq!(relaxed.expect("a bake"), plain.expect("a bake"));
        }
    }
}
