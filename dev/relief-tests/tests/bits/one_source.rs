//! The comparison of the two backends: what it notices, and what it explains; sampling and uploads.

use relief_core::{HeightMap, Wrap};
use relief_shaders::cpu::{PixelIn, Probe, Shared, write_all};
use relief_shaders::wgsl::Sampling;
use relief_testing::maps::{self, NamedMap};
use relief_tests::one_source::cases::{Case, probe};
use relief_tests::one_source::compare::Comparison;
use relief_tests::one_source::{adapter, rays};

fn named(name: &str) -> &'static NamedMap {
    maps::ALL.iter().find(|map| map.name == name).expect("a listed map")
}

/// A case and rays for the tests of the comparison, with their answers.
fn sample(search: &str, refine: &str) -> (Case, Vec<PixelIn>, Vec<Probe>) {
    let map = named("white noise 37x53").build(Wrap::Repeat).with_displacement(0.3, -0.1);
    let case = Case::of(search, refine, map.expect("proper numbers"));
    let rays = rays::pixels(&case.map, 10_000, 7);
    let answers = case.on_cpu(&rays);
    (case, rays, answers)
}

#[test]
fn one_flipped_bit_in_ten_thousand_answers_is_seen() {
    let (case, rays, cpu) = sample("cells", "patch");
    let same = Comparison::new(&case, &rays, &cpu, &cpu);
    assert!(same.check().is_ok() && same.different == 0);
    let at =
        cpu.iter().position(|probe| probe.found == 1 && probe.t > 0.0 && probe.near > 0.0).expect("a hit");
    let mut flipped = 0;
    for place in 0..8 * Probe::SIZE {
        let mut bytes = write_all(&cpu[at..=at]);
        bytes[place / 8] ^= 1 << (place % 8);
        let mut gpu = cpu.clone();
        gpu[at] = Probe::read(&bytes);
        // Bytes between the fields are no answer, and the sign of a zero is none either.
        if gpu[at] == cpu[at] {
            continue;
        }
        flipped += 1;
        assert!(Comparison::new(&case, &rays, &cpu, &gpu).check().is_err(), "bit {place} was not seen");
    }
    assert!(flipped >= 32 * 19, "only {flipped} bits were flipped");
}

#[test]
fn a_wrong_wrap_is_seen() {
    for wrap in Wrap::ALL {
        for other in Wrap::ALL.into_iter().filter(|other| *other != wrap) {
            let map = named("white noise 37x53").build(wrap);
            let case = Case::of("linear", "binary", map.clone());
            let rays = rays::pixels(&case.map, 10_000, 3);
            let wrong = Case::of("linear", "binary", map.with_wrap(other)).on_cpu(&rays);
            let seen = Comparison::new(&case, &rays, &case.on_cpu(&rays), &wrong);
            assert!(seen.check().is_err() && seen.unexplained > 0, "{other} for {wrap}: {seen:?}");
        }
    }
}

#[test]
fn only_differences_within_the_margin_are_explained() {
    for (search, refine) in [("cells", "patch"), ("linear", "binary")] {
        let (case, rays, cpu) = sample(search, refine);
        let program = case.program();
        let moved = |roundings: f32| {
            let gpu: Vec<Probe> =
                rays.iter().map(|ray| probe(&program, ray, roundings * f32::EPSILON)).collect();
            Comparison::new(&case, &rays, &cpu, &gpu)
        };
        let slightly = moved(2.5);
        assert!(slightly.different > 100 && slightly.unexplained == 0, "{search} {refine}: {slightly:?}");
        // Too many differ all the same.
        assert!(slightly.check().is_err());
        let far = moved(1000.0);
        assert!(far.unexplained * 2 > far.different, "{search} {refine}: {far:?}");
    }
}

#[test]
fn maps_and_lists_larger_than_one_upload_arrive_whole() {
    let Some(mut prober) = adapter::prober() else { return };
    let texel =
        |i: u32, j: u32| (i.wrapping_mul(0x9e37_79b1) ^ j.wrapping_mul(0x85eb_ca6b)) as f32 / u32::MAX as f32;
    let map = HeightMap::from_fn(2100, 2101, Wrap::Repeat, texel).expect("a valid map");
    let case = Case::of("none", "offset-limited", map);
    let rays = rays::pixels(&case.map, 300_000, 5);
    let answers = prober.probe(case.surface(), Sampling::Exact, &rays).expect("the probe runs");
    Comparison::new(&case, &rays, &case.on_cpu(&rays), &answers).check().expect("the same bits");
}

#[test]
fn fast_sampling_reads_the_same_surface_in_every_wrap() {
    /// A sampler has 8 bits of fraction, two texels of white noise differ by up to 1, in both directions.
    const PRECISION: f32 = 2.0 / 256.0 + 1e-4;
    let Some(mut prober) = adapter::prober() else { return };
    for wrap in Wrap::ALL {
        let map = named("white noise 37x53").build(wrap).with_displacement(0.3, 0.0).expect("proper numbers");
        // The height of the hit is the one height that this pair reads.
        let case = Case::of("none", "offset-limited", map);
        let mut rays = rays::pixels(&case.map, 20_000, 11);
        let exact = case.on_cpu(&rays);
        let fast = prober.probe(case.surface(), Sampling::Fast, &rays).expect("the probe runs");
        let mut compared = 0;
        for (ray, (exact, fast)) in rays.drain(..).zip(exact.iter().zip(&fast)) {
            // Far from the origin f32 has not the fraction of a texel left.
            let base = case.program().enter(ray).uv;
            if exact.found == 0 || fast.found == 0 || base.x.abs().max(base.y.abs()) > 8.0 {
                continue;
            }
            compared += 1;
            assert!((exact.height - fast.height).abs() <= PRECISION, "{wrap}: {exact:?}\n{fast:?}");
        }
        assert!(compared > 10_000, "{wrap}: only {compared}");
    }
}

#[test]
fn paths_without_a_pixel_end_where_the_translation_says() {
    let Some(mut prober) = adapter::prober() else { return };
    for (search, refine) in [("linear", "binary"), ("cells", "patch"), ("pyramid", "patch"), ("cone", "none")]
    {
        for wrap in Wrap::ALL {
            let map = named("white noise 37x53").build(wrap).with_displacement(0.3, -0.1);
            let case = Case::of(search, refine, map.expect("proper numbers"));
            let program = case.program();
            let rays = rays::pixels(&case.map, 5_000, 13);
            let paths: Vec<_> =
                rays.iter().map(|ray| program.segment(*ray, program.enter(*ray), 0)).collect();
            let hits = prober.trace(case.surface(), Sampling::Exact, &paths).expect("the paths are traced");
            let found = hits.iter().filter(|hit| hit.found == 1).count();
            assert!(found > 1_000, "{search} {wrap}: {found} hits");
            for (path, hit) in paths.iter().zip(&hits) {
                let own = program.refine(*path, program.search(*path));
                assert_eq!(*hit, own, "{search}, {refine}, {wrap}: {path:?}");
            }
        }
    }
    let case = Case::of("linear", "binary", named("white noise 37x53").build(Wrap::Repeat));
    assert_eq!(prober.trace(case.surface(), Sampling::Exact, &[]), Ok(Vec::new()));
}
