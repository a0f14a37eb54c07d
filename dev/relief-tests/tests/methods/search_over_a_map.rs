//! The pairs of stages that promise the exact first hit, as the shaders have them, against it: adversarial
//! rays of the classes for which they promise it, through adversarial maps in all wraps.

use rayon::prelude::*;
use relief_core::exact::{ExactHit, cell_walk, least_gap};
use relief_core::registry::{Guarantee, RayClass};
use relief_core::{BakedMap, Cost, HeightMap, MapFormat, MapTexels, Path, Wrap};
use relief_shaders::cpu::MethodTracer;
use relief_shaders::{MapSlot, Selection, SlotMaps};
use relief_testing::judge::{Tally, Verdict, judge};
use relief_testing::rays::{RayKind, Rays};
use relief_testing::{RAYS_PER_MAP, maps, steepest};
use relief_tests::baked::{maps_for, maps_in, slots};
use relief_tests::pairs::{self, class_of};

/// Roundings that an answer may be off by, of the terms in [`slack`].
const ROUNDINGS: f64 = 2.0;

/// What `f32` may make of heights along a path, in heights: roundings of the path's own heights, and of its
/// places, in texels, where the surface is as steep as the map gets.
fn slack(map: &HeightMap, steepest: f64, path: &Path) -> f64 {
    let heights = path.h[0].abs() + path.exit * (path.h[1].abs() + path.exit * path.h[2].abs());
    let texels = |axis: usize, side: u32| {
        (path.uv[axis].abs() + path.exit * path.duv[axis].abs()) * f64::from(side) + 1.0
    };
    let places = texels(0, map.width()) + texels(1, map.height());
    ROUNDINGS * f64::from(f32::EPSILON) * (1.0 + heights + steepest * places)
}

/// The rays for a map, as a shader is given them.
fn paths(map: &HeightMap, seed: u64) -> impl Iterator<Item = (RayKind, Path)> + '_ {
    let finite = Rays::new(map, seed).filter(|(kind, _)| *kind != RayKind::Endless);
    finite.map(|(kind, path)| (kind, Path::from(&relief_shaders::cpu::Path::from(&path))))
}

/// A shader's answer over a level of detail, whose heights are given, to be judged: where its `t` says, which
/// is checked, and there on the surface. Where a path begins below, the shader has the height of the path.
fn answer(map: &HeightMap, tracer: &MethodTracer, level: u32, path: &Path) -> ExactHit {
    let mut hit = tracer.first_hit_in(level, path);
    if hit.found {
        let [u, v, _] = path.at(hit.t);
        for (axis, place) in [u, v].into_iter().enumerate() {
            let terms = path.uv[axis].abs() + hit.t * path.duv[axis].abs();
            let apart = (place - hit.uv[axis]).abs();
            assert!(apart <= 2.0 * f64::from(f32::EPSILON) * terms, "{path:?} {hit:?}");
        }
        (hit.uv, hit.height) = ([u, v], map.height_at(u, v));
    }
    ExactHit { hit, ..ExactHit::miss(Cost::default(), 0.0) }
}

/// The answers of a pair of stages to the rays for which it promises to be exact, and the reads that they
/// took.
fn trial(map: &HeightMap, selection: &Selection, format: MapFormat, rays: usize) -> (Tally, f64) {
    let baked = maps_in(format, map, selection);
    let tracer = MethodTracer::over(map, selection, slots(map, selection, &baked));
    trial_in((map, 0), selection, &tracer, rays)
}

/// The same over a level of detail, whose heights and number are given.
fn trial_in(
    (map, level): (&HeightMap, u32),
    selection: &Selection,
    tracer: &MethodTracer,
    rays: usize,
) -> (Tally, f64) {
    let (mut tally, mut reads, steepest) = (Tally::default(), 0.0, steepest(map));
    let promised = |path: &Path| selection.guarantee(class_of(path)) == Guarantee::Exact;
    for (kind, path) in paths(map, 1).filter(|(_, path)| promised(path)).take(rays) {
        let truth = cell_walk(map, &path);
        let other = answer(map, tracer, level, &path);
        match judge(map, &path, &truth, &other, slack(map, steepest, &path)) {
            Ok(Verdict::Agree) => {}
            Ok(Verdict::Grazing) => tally.grazing += 1,
            Err(wrong) => panic!("{}, {} {kind:?}: {wrong}", pairs::name(selection), map.wrap()),
        }
        tally.hits += usize::from(truth.hit.found);
        tally.misses += usize::from(!truth.hit.found);
        reads += f64::from(other.hit.cost.reads);
    }
    (tally, reads / rays as f64)
}

#[test]
fn no_first_hit_is_missed_or_passed_on_any_map_in_any_wrap() {
    let exact = pairs::all()
        .filter(|pair| RayClass::ALL.iter().any(|rays| pair.guarantee(*rays) == Guarantee::Exact));
    let exact: Vec<Selection> = exact.collect();
    assert!(exact.len() >= 3, "{} pairs are exact", exact.len());
    let runs = exact.iter().flat_map(|pair| {
        // Without a map there is nothing to store.
        let formats = if pair.map_needs().is_empty() { &MapFormat::ALL[..1] } else { &MapFormat::ALL[..] };
        formats.iter().map(move |format| (pair, *format))
    });
    for (selection, format) in runs {
        let rays = if format == MapFormat::F32 { RAYS_PER_MAP / 2 } else { RAYS_PER_MAP / 5 };
        let cases: Vec<_> = maps::ALL.iter().flat_map(|named| Wrap::ALL.map(|wrap| (named, wrap))).collect();
        let (tally, reads) = cases
            .par_iter()
            .map(|(named, wrap)| {
                let map = named.build(*wrap);
                trial(&map, selection, format, rays)
            })
            .reduce(|| (Tally::default(), 0.0), |(a, x), (b, y)| (a.plus(b), x + y));
        let reads = reads / cases.len() as f64;
        println!("{} {format:?}: {tally:?}, {reads:.1} reads a ray", pairs::name(selection));
        assert!(tally.hits > tally.misses / 4 && tally.misses > tally.hits / 10, "{tally:?}");
        assert!(tally.grazing < (tally.hits + tally.misses) / 10, "{tally:?}");
    }
}

/// Pair whose one map serves all levels of detail, with and without these.
fn quadtree(detail: &str) -> Selection {
    let mut selection = Selection::method("quadtree").expect("a method");
    selection.choose("detail", detail).expect("a listed name");
    selection
}

#[test]
fn one_pyramid_serves_all_levels_of_detail() {
    let selection = quadtree("footprint");
    let cases: Vec<_> = maps::ALL.iter().flat_map(|named| Wrap::ALL.map(|wrap| (named, wrap))).collect();
    let of_case = |(named, wrap): &(&maps::NamedMap, Wrap)| {
        let map = named.build(*wrap);
        let baked = maps_for(&map, &selection);
        let tracer = MethodTracer::over(&map, &selection, slots(&map, &selection, &baked));
        // Each level is judged by its own surface.
        let of_level = |k| trial_in((&map.level(k), k), &selection, &tracer, RAYS_PER_MAP / 8).0;
        (0..map.levels()).map(of_level).fold(Tally::default(), Tally::plus)
    };
    let tally = cases.par_iter().map(of_case).reduce(Tally::default, Tally::plus);
    println!("{tally:?}");
    assert!(tally.hits > tally.misses / 4 && tally.misses > tally.hits / 10, "{tally:?}");
    assert!(tally.grazing < (tally.hits + tally.misses) / 10, "{tally:?}");
}

#[test]
fn a_pyramid_of_the_finest_level_alone_is_noticed_in_others() {
    let selection = quadtree("footprint");
    let map = maps::ALL[3].build(Wrap::Clamp);
    let finest = maps_for(&map, &quadtree("none")).pop().expect("it reads a map");
    let tracer = MethodTracer::over(&map, &selection, SlotMaps::from_iter([(MapSlot::Search, &finest)]));
    for (k, wrong) in [(0, false), (1, true), (2, true)] {
        let level = map.level(k);
        let steepest = steepest(&level);
        let rays = paths(&level, 2).filter(|(_, path)| class_of(path) == RayClass::View).take(20_000);
        let noticed = rays.filter(|(_, path)| {
            let other = answer(&level, &tracer, k, path);
            judge(&level, path, &cell_walk(&level, path), &other, slack(&level, steepest, path)).is_err()
        });
        let noticed = noticed.count();
        println!("level {k}: noticed on {noticed} of 20000 rays");
        assert_eq!(noticed >= 5, wrong, "level {k}: noticed on {noticed} of 20000 rays");
    }
}

/// How a map is made to promise too much, texel by texel.
type Mutation = (&'static str, fn(&mut [f32]));

/// A search, and what is wrong with the maps that it is given.
struct Wrong {
    method: &'static str,
    /// Maps, their wraps, and other wraps in which they are baked. In a mirrored map no two points are nearer
    /// than in the map itself, so cones baked for repeat are safe there.
    foreign: [(usize, Wrap, Wrap); 2],
    mutations: &'static [Mutation],
}

/// Cones half as wide again: the ratio is proportional to v² / (1 - v²).
const WIDENED: Mutation = ("widened by half", |values| {
    values.iter_mut().for_each(|v| *v = (1.5 * *v * *v / (1.0 + 0.5 * *v * *v)).sqrt());
});

const LOWERED: Mutation = ("lowered", |heights| heights.iter_mut().for_each(|height| *height *= 0.8));

const WRONG: [Wrong; 6] = [
    Wrong {
        method: "frustum",
        foreign: [(0, Wrap::Repeat, Wrap::Clamp), (2, Wrap::Mirror, Wrap::Repeat)],
        mutations: &[
            ("lowered", |slopes| slopes.iter_mut().for_each(|slope| *slope *= 0.8)),
            ("swapped", |slopes| slopes.as_chunks_mut::<2>().0.iter_mut().for_each(|pair| pair.swap(0, 1))),
        ],
    },
    Wrong {
        method: "cone",
        foreign: [(0, Wrap::Repeat, Wrap::Clamp), (0, Wrap::Repeat, Wrap::Mirror)],
        mutations: &[WIDENED],
    },
    Wrong {
        method: "quadtree",
        foreign: [(0, Wrap::Repeat, Wrap::Clamp), (2, Wrap::Repeat, Wrap::Mirror)],
        mutations: &[LOWERED],
    },
    Wrong {
        method: "erosion-dilation",
        foreign: [(3, Wrap::Repeat, Wrap::Clamp), (5, Wrap::Repeat, Wrap::Mirror)],
        mutations: &[LOWERED],
    },
    Wrong {
        method: "sphere-tracing",
        foreign: [(0, Wrap::Repeat, Wrap::Clamp), (2, Wrap::Repeat, Wrap::Mirror)],
        mutations: &[("doubled", |lengths| lengths.iter_mut().for_each(|length| *length *= 2.0))],
    },
    Wrong {
        method: "relaxed-cone-stepping",
        foreign: [(0, Wrap::Repeat, Wrap::Clamp), (0, Wrap::Repeat, Wrap::Mirror)],
        mutations: &[WIDENED],
    },
];

/// A map with other values, which are 32-bit floats.
fn mutated(map: &BakedMap, mutate: fn(&mut [f32])) -> BakedMap {
    let MapTexels::F32(mut values) = map.texels().clone() else { panic!("{:?}", map.layout()) };
    mutate(&mut values);
    BakedMap::new(map.identity().clone(), *map.layout(), *map.codes(), MapTexels::F32(values))
        .expect("the same shape")
}

#[test]
fn a_map_that_promises_too_much_and_another_wraps_map_are_noticed() {
    for Wrong { method, foreign, mutations } in WRONG {
        let mut selection = Selection::method(method).expect("a method");
        selection.choose("refine", "patch").expect("a refinement");
        for (at, wrap, other) in foreign {
            let map = maps::ALL[at].build(wrap);
            let steepest = steepest(&map);
            let one = |map: &HeightMap| maps_for(map, &selection).pop().expect("it reads a map");
            let (right, foreign) = (one(&map), one(&map.clone().with_wrap(other)));
            let mut wrong = vec![("another wrap's", foreign)];
            wrong.extend(mutations.iter().map(|(name, mutate)| (*name, mutated(&right, *mutate))));
            for (name, wrong) in wrong {
                // Unchecked: that it is another wrap's would be noticed without a ray.
                let maps = SlotMaps::from_iter([(MapSlot::Search, &wrong)]);
                let tracer = MethodTracer::over(&map, &selection, maps);
                let seen = |path: &Path| selection.guarantee(class_of(path)) == Guarantee::Exact;
                let rays = paths(&map, 2).filter(|(_, path)| seen(path)).take(20_000);
                let noticed = rays.filter(|(_, path)| {
                    let other = answer(&map, &tracer, 0, path);
                    judge(&map, path, &cell_walk(&map, path), &other, slack(&map, steepest, path)).is_err()
                });
                let noticed = noticed.count();
                println!("{method}, {name}, {wrap}: noticed on {noticed} of 20000 rays");
                assert!(noticed >= 5, "{method}, {name}, {wrap}: noticed on {noticed} of 20000 rays");
            }
        }
    }
}

/// How often a pair that may stop early, or find another hit, was off.
#[derive(Clone, Copy, Debug, Default)]
struct Counted {
    hits: usize,
    early: usize,
    passed: usize,
    exhausted: usize,
}

/// Counts the rays of a class on which a hit is early, or missed or late, by more than rounding.
fn count(map: &HeightMap, selection: &Selection, rays: RayClass, number: usize) -> Counted {
    let baked = maps_for(map, selection);
    let tracer = MethodTracer::over(map, selection, slots(map, selection, &baked));
    let steepest = steepest(map);
    let mut counted = Counted::default();
    for (_, path) in paths(map, 3).filter(|(_, path)| class_of(path) == rays).take(number) {
        let truth = cell_walk(map, &path);
        let hit = tracer.first_hit(&path);
        counted.hits += usize::from(truth.hit.found);
        counted.exhausted += usize::from(hit.exhausted);
        let far = if hit.found { hit.t } else { path.exit };
        let slack = slack(map, steepest, &path);
        // What lies before the answer is deeper than rounding.
        let is_passed = truth.hit.found && far > truth.hit.t && -least_gap(map, &path, 0.0, far) > slack;
        counted.passed += usize::from(is_passed);
        let [u, v, height] = path.at(far);
        counted.early += usize::from(hit.found && height - map.height_at(u, v) > slack);
    }
    counted
}

#[test]
fn a_conservative_search_passes_no_hit_and_an_approximate_one_few() {
    for (search, refine, set, most) in [
        // The last number is the share of the hits that may be passed.
        ("cone-moved", "none", &[("search.steps", 64.0)][..], 0.0),
        ("cone-moved", "none", &[("search.steps", 64.0), ("search.apex", 0.0)], 0.25),
        ("sphere", "none", &[("search.patches", 0.0)], 0.0),
        ("relaxed-cone", "patch", &[("search.patches", 0.0)], 0.0),
        ("dilation-erosion", "patch", &[("search.patches", 0.0)], 0.5),
        ("relaxed-cone-resting", "patch", &[], 0.001),
    ] {
        let mut selection = Selection::pair(search, refine).expect("listed names");
        for (key, value) in set {
            selection.set(key, *value).expect("a parameter");
        }
        let choice = &selection.choices[relief_shaders::SEARCH];
        let promise = choice.entry.promises(&choice.params);
        for rays in RayClass::ALL.into_iter().filter(|rays| promise.of(*rays) != Guarantee::Impossible) {
            let cases: Vec<_> =
                maps::ALL.iter().flat_map(|named| Wrap::ALL.map(|wrap| (named, wrap))).collect();
            let counted = cases
                .par_iter()
                .map(|(named, wrap)| count(&named.build(*wrap), &selection, rays, RAYS_PER_MAP / 20));
            let sum = |a: Counted, b: Counted| Counted {
                hits: a.hits + b.hits,
                early: a.early + b.early,
                passed: a.passed + b.passed,
                exhausted: a.exhausted + b.exhausted,
            };
            let counted = counted.reduce(Counted::default, sum);
            println!("{search} {set:?}, {}: {} {counted:?}", rays.name(), promise.of(rays).name());
            assert_eq!(promise.of(rays) == Guarantee::Conservative, most == 0.0, "{search} {set:?}");
            let share = counted.passed as f64 / counted.hits as f64;
            assert!(share <= most && counted.exhausted == 0, "{search} {set:?}, {}: {share}", rays.name());
        }
    }
}

/// The first hit of a path with level columns over the texels, texel by texel.
fn column_hit(map: &HeightMap, path: &Path) -> Option<f64> {
    let size = [map.width(), map.height()].map(f64::from);
    let at = |axis: usize, t: f64| (path.uv[axis] + path.duv[axis] * t) * size[axis];
    let mut borders: Vec<f64> = vec![0.0, path.exit];
    for axis in 0..2 {
        let (a, b) = (at(axis, 0.0), at(axis, path.exit));
        let lines = (a.min(b).ceil() as i64)..=(a.max(b).floor() as i64);
        borders.extend(lines.map(|line| (line as f64 - a) / (b - a) * path.exit).filter(|t| t.is_finite()));
    }
    borders.sort_by(f64::total_cmp);
    borders.windows(2).find_map(|way| {
        let middle = 0.5 * (way[0] + way[1]);
        let texel = [at(0, middle), at(1, middle)].map(|place| place.floor() as i64);
        let height = f64::from(map.texel(texel[0], texel[1]));
        let gap = |t: f64| path.at(t)[2] - height;
        if gap(way[0]) <= 0.0 {
            return Some(way[0]);
        }
        // Straight, so that what is above at both ends is above between.
        (gap(way[1]) <= 0.0).then(|| way[0] + (way[1] - way[0]) * gap(way[0]) / (gap(way[0]) - gap(way[1])))
    })
}

#[test]
fn the_published_pyramid_hits_columns_of_texels() {
    let selection = Selection::method("pyramidal").expect("a method");
    for wrap in Wrap::ALL {
        for named in maps::ALL {
            let map = named.build(wrap);
            let baked = maps_for(&map, &selection);
            let tracer = MethodTracer::over(&map, &selection, slots(&map, &selection, &baked));
            // The others are aimed at lines and corners of cells, and a corner of columns is judged by the
            // last bit.
            let is_random =
                |(kind, path): &(RayKind, Path)| *kind == RayKind::Random && class_of(path) == RayClass::View;
            let rays = paths(&map, 4).filter(is_random).take(1000);
            let differ = rays.filter(|(_, path)| {
                let hit = tracer.first_hit(path);
                match column_hit(&map, path) {
                    None => hit.found,
                    Some(t) => !hit.found || (hit.t - t).abs() > 1e-4 * path.exit,
                }
            });
            let differ = differ.count();
            assert!(differ <= 2, "{} {wrap}: {differ} of 1000 rays", named.name);
        }
    }
}
