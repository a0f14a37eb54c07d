//! Search and refinement over lanes have the answers of the single numbers, to the last bit.

use rayon::prelude::*;
use relief_core::{Cost, HeightMap, Hit, Lanes, MapFormat, Path, Wrap};
use relief_shaders::Selection;
use relief_shaders::cpu::MethodTracer;
use relief_testing::maps;
use relief_testing::rays::{RayKind, Rays};
use relief_tests::baked::{maps_in, slots};
use relief_tests::pairs;

/// Paths of a pair, map, wrap and format.
const PATHS: usize = 160;

/// All numbers of a hit, as bits.
fn bits(hit: &Hit) -> [u64; 8] {
    let Hit { found, exhausted, uv, height, t, cost } = hit;
    [
        u64::from(*found) + 2 * u64::from(*exhausted),
        uv[0].to_bits(),
        uv[1].to_bits(),
        height.to_bits(),
        t.to_bits(),
        u64::from(cost.reads),
        u64::from(cost.steps),
        u64::from(cost.bytes),
    ]
}

/// Adversarial paths, and some values that are no paths at all.
fn paths(map: &HeightMap) -> Vec<Path> {
    let broken = |(number, mut path): (usize, Path)| {
        match number % 97 {
            5 => path.uv[0] = f64::NAN,
            17 => path.h[1] = f64::NAN,
            53 => path.exit = -1.0,
            _ => {}
        }
        path
    };
    // Paths without an end are walked to the limits of every search, which takes long.
    let finite = Rays::new(map, 11).filter(|(kind, _)| *kind != RayKind::Endless);
    finite.map(|(_, path)| path).take(PATHS).enumerate().map(broken).collect()
}

/// First hit over lanes that differs from another tracer's.
fn first_different(
    tracer: &MethodTracer,
    oracle: &MethodTracer,
    paths: &[Path],
    lanes: Lanes,
) -> Option<usize> {
    let mut hits = vec![Hit::miss(Cost::default()); paths.len()];
    tracer.first_hits(paths, lanes, &mut hits);
    (0..paths.len()).find(|&at| bits(&hits[at]) != bits(&oracle.first_hit(&paths[at])))
}

#[test]
fn every_pair_has_the_bits_of_one_by_one() {
    let all: Vec<Selection> = pairs::all().collect();
    let cases: Vec<_> = maps::ALL.iter().flat_map(|named| Wrap::ALL.map(|wrap| (named, wrap))).collect();
    let hits: usize = cases
        .par_iter()
        .enumerate()
        .map(|(number, (named, wrap))| {
            let map = named.build(*wrap);
            let paths = paths(&map);
            let mut hits = 0;
            // Every pair on every third map and wrap.
            for (place, selection) in all.iter().enumerate().skip(number % 3).step_by(3) {
                // Every format of some map in turn.
                let format = MapFormat::ALL[(place + number) % MapFormat::ALL.len()];
                let baked = maps_in(format, &map, selection);
                let tracer = MethodTracer::over(&map, selection, slots(&map, selection, &baked));
                hits += paths.iter().filter(|path| tracer.first_hit(path).found).count();
                for lanes in Lanes::available().filter(|lanes| *lanes != Lanes::One) {
                    // Blocks that are not full, too.
                    for paths in [&paths[..], &paths[3..PATHS - 5]] {
                        let different = first_different(&tracer, &tracer, paths, lanes);
                        let path = different.map(|at| (at, paths[at]));
                        let pair = pairs::name(selection);
                        assert!(
                            different.is_none(),
                            "{pair} {format:?}, {} {wrap}, {lanes} lanes: {path:?}",
                            named.name
                        );
                    }
                }
            }
            hits
        })
        .sum();
    let paths = all.len() * cases.len() * PATHS / 3;
    println!("{} pairs, {hits} hits of about {paths} paths", all.len());
    assert!(hits > paths / 5 && hits < paths * 9 / 10, "{hits} of {paths}");
}

#[test]
fn paths_that_every_search_gives_up_have_the_same_bits() {
    let named = maps::ALL.iter().find(|map| map.name == "white noise 37x53").expect("it is listed");
    let map = named.build(Wrap::Repeat);
    let path = Path::between([0.3, 0.2, 1.0], [0.9, 0.6, 0.0]);
    let paths = [
        Path { duv: [path.duv[0], f64::NEG_INFINITY], ..path },
        Path { exit: f64::NAN, h: [0.999, 0.0, 0.0], ..path },
        Path { exit: f64::INFINITY, h: [0.999, 0.0, 0.0], ..path },
    ];
    pairs::all().collect::<Vec<_>>().par_iter().for_each(|selection| {
        let baked = maps_in(MapFormat::F32, &map, selection);
        let tracer = MethodTracer::over(&map, selection, slots(&map, selection, &baked));
        for lanes in Lanes::available() {
            let different = first_different(&tracer, &tracer, &paths, lanes);
            assert_eq!(different, None, "{}, {lanes} lanes", pairs::name(selection));
        }
    });
}

#[test]
fn a_texel_that_is_another_one_is_noticed() {
    let texel = |i: u32, j: u32| ((i * 7 + j * 5) % 11) as f32 / 10.0;
    let map = HeightMap::from_fn(40, 30, Wrap::Repeat, texel).expect("a map");
    let moved = |i, j| if (i, j) == (9, 12) { (texel(i, j) + 0.01).min(1.0) } else { texel(i, j) };
    let other = HeightMap::from_fn(40, 30, Wrap::Repeat, moved).expect("a map");
    let relief = Selection::method("relief").expect("a method");
    let [own, wrong] = [&map, &other].map(|map| MethodTracer::over(map, &relief, slots(map, &relief, &[])));
    let paths: Vec<Path> = Rays::new(&map, 3).map(|(_, path)| path).take(4000).collect();
    for lanes in Lanes::available() {
        assert!(first_different(&own, &own, &paths, lanes).is_none());
        assert!(first_different(&wrong, &own, &paths, lanes).is_some(), "{lanes}");
    }
}
