//! One source, two backends: what a GPU makes of the shaders and what their translation to Rust makes of the
//! same input.
//!
//! The stages are given the same rays and must give the same bits; pictures must agree to rounding. The GPU
//! is a software adapter, which computes as IEEE 754 says.

mod adapter;
mod cases;
mod compare;
mod picture;
mod rays;

use std::collections::BTreeSet;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use relief_core::registry::Entry;
use relief_core::{HeightMap, MapFormat, Wrap};
use relief_render::gpu::Prober;
use relief_shaders::cpu::{PixelIn, PixelOut, Probe, Shared, write_all};
use relief_shaders::wgsl::Sampling;
use relief_shaders::{Selection, ambient, detail, refine, search, shadow};
use relief_tests::maps::{self, NamedMap};
use relief_tests::rng::Rng;

use cases::{Case, Draw, probe};
use compare::Comparison;
use picture::{Picture, Variation};

/// Rays over all legal pairs of search and refinement together. Times scale with it.
const RAYS: usize = 1_000_000;

fn named(name: &str) -> &'static NamedMap {
    maps::ALL.iter().find(|map| map.name == name).expect("a listed map")
}

/// Every shadow, with each search that it may send its rays by, or with one where it sends none.
fn shadows() -> Vec<[&'static Entry; 2]> {
    let mut shadows = Vec::new();
    for shadow in shadow::ENTRIES {
        for search in search::ENTRIES {
            let mut selection = Selection::default();
            selection.choose("shadow", shadow.name).expect("a listed name");
            selection.choose("shadow-search", search.name).expect("a listed name");
            let is_first = shadows.last().is_none_or(|[last, _]: &[&Entry; 2]| last.name != shadow.name);
            if selection.check().is_ok() && (is_first || !shadow.states.is_empty()) {
                shadows.push([shadow, search]);
            }
        }
    }
    shadows
}

/// A search and a refinement over every map.
struct Pair {
    /// Their numbers in their lists.
    numbers: [usize; 2],
    /// A draw for each map.
    draws: Vec<Draw>,
}

impl Pair {
    /// All legal pairs, drawn one after the other. Shadows go with the first of them, each with each search
    /// that it may send its rays by.
    fn all() -> Vec<Pair> {
        let mut rng = Rng::new(1);
        let mut pairs = Vec::new();
        let shadows = shadows();
        for (s, search) in search::ENTRIES.iter().enumerate() {
            for (r, refine) in refine::ENTRIES.iter().enumerate() {
                let pair = Selection::pair(search.name, refine.name).expect("listed names");
                if pair.check_pair().is_err() {
                    continue;
                }
                let none = [&shadow::none::ENTRY, search];
                let shadow = shadows.get(pairs.len()).copied().unwrap_or(none);
                // Every third in levels of detail, by turns in each way: most of the time goes into compiling
                // programs, and this way a pair has one.
                let in_levels = detail::ENTRIES.iter().skip(1);
                let number = pairs.len();
                let detail = in_levels.cycle().nth(number / 3).filter(|_| number % 3 == 0);
                let detail = detail.unwrap_or(&detail::ENTRIES[0]);
                let draw = |_| Draw::new([search, refine], shadow, detail, &mut rng);
                let draws = maps::ALL.iter().map(draw).collect();
                pairs.push(Pair { numbers: [s, r], draws });
            }
        }
        pairs
    }

    /// What CPU and GPU make of that many rays over each map.
    fn compare(&self, prober: &mut Prober, rays_a_case: usize) -> Comparison {
        let [s, r] = self.numbers;
        let (mut all, mut hits) = (Comparison::default(), 0);
        for (m, (map, draw)) in maps::ALL.iter().zip(&self.draws).enumerate() {
            // Every map in one wrap a pair, every wrap with each search and each refinement.
            let wrap = Wrap::ALL[(s + r + m) % Wrap::ALL.len()];
            let format = MapFormat::ALL[(s + m) % MapFormat::ALL.len()];
            let case = draw.over(map, wrap, format);
            let rays = rays::pixels(&case.map, rays_a_case, draw.seed);
            let cpu = case.on_cpu(&rays);
            let gpu = prober.probe(case.surface(), Sampling::Exact, &rays).expect("the probe runs");
            hits += cpu.iter().filter(|probe| probe.found == 1).count();
            all = all.plus(Comparison::new(&case, &rays, &cpu, &gpu));
        }
        let names = [search::ENTRIES[s].name, refine::ENTRIES[r].name];
        assert!(hits > rays_a_case * maps::ALL.len() / 2, "{names:?}: {hits} hits");
        all
    }
}

#[test]
fn all_stages_have_the_same_bits() {
    let pairs = Pair::all();
    let rays_a_case = RAYS.div_ceil(pairs.len() * maps::ALL.len());
    let next = AtomicUsize::new(0);
    // Most of the time goes into compiling programs, which an adapter does for one device at a time.
    let on_own_device = || {
        let mut prober = adapter::own_prober()?;
        let mut all = Comparison::default();
        while let Some(pair) = pairs.get(next.fetch_add(1, Ordering::Relaxed)) {
            all = all.plus(pair.compare(&mut prober, rays_a_case));
        }
        Some(all)
    };
    let compared = thread::scope(|scope| {
        let other = scope.spawn(on_own_device);
        let own = on_own_device();
        let other = other.join().unwrap_or_else(|panic| resume_unwind(panic));
        own.zip(other).map(|(own, other)| own.plus(other))
    });
    let Some(all) = compared else { return };
    println!("{} rays, {} differ, {} unexplained", all.rays, all.different, all.unexplained);
    assert!(all.rays >= RAYS);
    all.check().expect("the same bits");
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
fn pictures_agree() {
    let Some(mut renderer) = adapter::renderer() else { return };
    // The first is larger than what is shaded at once.
    let cases = [
        (620, 500, "relief", "none", "none", Wrap::Repeat, false, true),
        (211, 160, "exact", "ray", "footprint", Wrap::Clamp, true, false),
        (160, 211, "occlusion", "entry", "none", Wrap::Mirror, true, true),
        (201, 99, "parallax-slope", "visibility", "footprint", Wrap::Clamp, false, false),
        (180, 140, "frustum", "soft", "fade", Wrap::Mirror, false, true),
        (140, 120, "cone", "horizon", "footprint", Wrap::Repeat, false, true),
        (120, 140, "relaxed", "heuristic", "none", Wrap::Repeat, false, false),
    ];
    let ambients = ambient::ENTRIES.iter().cycle();
    for (case, ambient) in cases.into_iter().zip(ambients) {
        let (width, height, method, shadow, detail, wrap, normal_map, two_sided) = case;
        let mut selection = Selection::method(method).expect("a method");
        selection.choose("ambient", ambient.name).expect("an ambient light");
        selection.choose("shadow", shadow).expect("a shadow");
        selection.choose("detail", detail).expect("a detail");
        let variation = Variation { selection: &selection, wrap, normal_map, two_sided };
        let picture = Picture::new(width, height, &variation);
        let rendering = renderer.render(picture.job(), Sampling::Exact, &|_| ()).expect("a picture");
        let levels: BTreeSet<u32> = rendering.pixels.iter().map(|pixel| pixel.level).collect();
        assert_eq!(levels.len() > 1, detail != "none", "{method} {shadow} {wrap}: {levels:?}");
        picture.check(&rendering).unwrap_or_else(|error| panic!("{method} {shadow} {wrap}: {error}"));
        let again = renderer.render(picture.job(), Sampling::Exact, &|_| ()).expect("a picture");
        assert!(rendering == again, "{method} {shadow} {wrap}: the second picture differs");
    }
}

#[test]
fn a_wrong_picture_is_seen() {
    let selection = Selection::method("relief").expect("a method");
    let variation =
        Variation { selection: &selection, wrap: Wrap::Repeat, normal_map: false, two_sided: true };
    let picture = Picture::new(96, 64, &variation);
    let right = picture.on_cpu();
    picture.check(&right).expect("the same picture");
    let hit = right.pixels.iter().position(|pixel| pixel.hit == 1 && pixel.normal.x != 0.0).expect("a hit");
    type Mutation = (&'static str, fn(&mut [PixelOut], usize));
    let mutations: [Mutation; 9] = [
        ("a colour", |pixels, at| pixels[at].color.y += 3e-5),
        ("a normal", |pixels, at| pixels[at].normal.x *= -1.0),
        ("a depth", |pixels, at| pixels[at].depth += 1e-4),
        ("a read", |pixels, at| pixels[at].reads += 1),
        ("a step", |pixels, at| pixels[at].steps += 1),
        ("a byte", |pixels, at| pixels[at].bytes += 1),
        ("a hole", |pixels, at| pixels[at].hit = 0),
        ("upside down", |pixels, _| pixels.reverse()),
        ("a pixel to the right", |pixels, _| pixels.rotate_right(1)),
    ];
    for (what, mutate) in mutations {
        let mut wrong = right.clone();
        mutate(&mut wrong.pixels, hit);
        assert!(picture.check(&wrong).is_err(), "{what} was not seen");
    }
}
