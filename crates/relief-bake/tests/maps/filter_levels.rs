//! Filter levels against the map's surface, by separate sums and samples.

use std::sync::atomic::AtomicBool;

use relief_bake::kind::filter_levels::{KIND, difference_volume, difference_volume_gradient};
use relief_bake::{BakeError, Filter, filter_level, filter_levels, quantise};
use relief_core::rng::Rng;
use relief_core::{HeightMap, Metric, Rounding, Watch, Wrap};
use relief_testing::maps;
use relief_tests::probes::stored;

/// Points compared for each map, wrap and level.
const POINTS: usize = 4_000;

/// Distance by which a point may lie below a bound in `f64`, by the rounding of both surfaces.
const ROUNDED: f64 = 1e-13;

/// Returns the levels of a map, with the default settings besides the filter.
fn levels(map: &HeightMap, filter: Filter) -> Vec<HeightMap> {
    filter_levels(map, filter, &Watch::none()).expect("not cancelled")
}

fn level(map: &HeightMap, level: u32, filter: Filter) -> HeightMap {
    filter_level(map, level, filter, &Watch::none()).expect("not cancelled")
}

/// Every adversarial map in every wrap.
fn all() -> impl Iterator<Item = (String, HeightMap)> {
    let named = maps::ALL.iter().flat_map(|named| Wrap::ALL.map(|wrap| (named, wrap)));
    named.map(|(named, wrap)| (format!("{} {wrap}", named.name), named.build(wrap)))
}

/// Points of the square and beyond its edges: anywhere, and near lines through centres of either
/// grid, where supports end.
fn points(map: &HeightMap, level: &HeightMap, count: usize, seed: u64) -> Vec<[f64; 2]> {
    let mut rng = Rng::new(seed);
    let sides = [[map.width(), level.width()], [map.height(), level.height()]];
    let mut along = |sides: [u32; 2]| match rng.below(3) {
        0 => rng.between(-0.5, 1.5),
        which => {
            let side = sides[which as usize - 1];
            let line = (f64::from(rng.below(side + 2)) - 0.5) / f64::from(side);
            line + [0.0, 1e-9, -1e-9, 1e-3, -1e-3][rng.below(5) as usize] / f64::from(side)
        }
    };
    (0..count).map(|_| sides.map(&mut along)).collect()
}

/// Returns the greatest distance of the level on the wrong side of the map.
fn trespass(map: &HeightMap, level: &HeightMap, filter: Filter, seed: u64) -> f64 {
    let apart = points(map, level, POINTS, seed).into_iter().map(|[u, v]| {
        let above = level.height_at(u, v) - map.height_at(u, v);
        if filter == Filter::Max { -above } else { above }
    });
    apart.fold(f64::NEG_INFINITY, f64::max)
}

/// Returns the level of the greatest texels of blocks, as usual in mip chains.
fn block_maximum(map: &HeightMap) -> HeightMap {
    let [width, height] = [map.width() / 2, map.height() / 2];
    let texel = |i: u32, j: u32| {
        let of_block = [[0, 0], [1, 0], [0, 1], [1, 1]]
            .map(|[x, y]| map.texel(i64::from(2 * i + x), i64::from(2 * j + y)));
        of_block.into_iter().fold(0.0, f32::max)
    };
    HeightMap::from_fn(width, height, map.wrap(), texel).expect("a valid map")
}

#[test]
fn levels_have_the_sizes_and_the_lie_of_the_maps_own() {
    for (name, map) in all() {
        let map = map.with_displacement(0.25, -0.5).expect("lengths");
        for filter in Filter::ALL {
            let levels = levels(&map, filter);
            assert_eq!(levels.len() as u32, map.levels(), "{name}");
            for (number, found) in (0..).zip(&levels) {
                let own = map.level(number);
                assert_eq!([found.width(), found.height()], [own.width(), own.height()], "{name}");
                let lie = |map: &HeightMap| (map.wrap(), map.scale_m(), map.bias_m());
                assert_eq!(lie(found), lie(&map), "{name} {filter}");
                assert!(number > 0 || found.shares_texels(&map), "{name}: level 0 is the map");
                assert!(filter != Filter::Average || *found == own, "{name}, level {number}");
            }
            assert!(level(&map, 99, filter) == levels[levels.len() - 1], "beyond the last level is the last");
        }
    }
}

#[test]
fn every_filter_leaves_a_level_map_as_it_is() {
    for wrap in Wrap::ALL {
        for height in [0.0, 0.3, 1.0] {
            let map = HeightMap::from_fn(23, 9, wrap, |_, _| height).expect("a valid map");
            for found in Filter::ALL.iter().flat_map(|&filter| levels(&map, filter)) {
                let off = found.texels().iter().map(|texel| (texel - height).abs()).fold(0.0, f32::max);
                assert!(off <= 6e-8, "{height} became {off} more or less");
            }
            let bounds = [Filter::Max, Filter::Min].map(|filter| levels(&map, filter));
            assert!(bounds.iter().flatten().all(|found| found.texels().iter().all(|&texel| texel == height)));
        }
    }
}

#[test]
fn the_surface_is_on_the_right_side_of_every_bound() {
    for (at, (name, map)) in (0..).zip(all()) {
        for filter in [Filter::Max, Filter::Min] {
            for (number, found) in levels(&map, filter).iter().enumerate() {
                let by = trespass(&map, found, filter, at);
                assert!(by <= ROUNDED, "{name} {filter}, level {number}: {by}");
            }
        }
    }
}

#[test]
fn blocks_of_texels_bound_nothing_between_them() {
    let mut broken = 0;
    for (at, (_, map)) in (0..).zip(all()) {
        if map.width().min(map.height()) > 1 {
            broken += usize::from(trespass(&map, &block_maximum(&map), Filter::Max, at) > ROUNDED);
        }
    }
    assert!(broken >= 20, "the points find only {broken} maximum chains that are below the surface");
}

#[test]
fn bounds_are_attained_where_supports_are_cut() {
    // The support of the first of four texels is cut at 2.5 along both axes: its highest point is
    // there.
    let map = HeightMap::from_fn(4, 4, Wrap::Clamp, |i, j| if [i, j] == [3, 3] { 1.0 } else { 0.0 });
    let map = map.expect("a valid map");
    let found = level(&map, 1, Filter::Max);
    let is_just = |found: &[f32], expected: [f32; 4], by: fn(f32) -> f32| {
        found.iter().zip(expected).all(|(&found, expected)| found == expected || found == by(expected))
    };
    assert!(is_just(found.texels(), [0.25, 0.5, 0.5, 1.0], f32::next_up), "{found:?}");
    let upside_down = HeightMap::from_fn(4, 4, Wrap::Clamp, |i, j| 1.0 - map.texel(i.into(), j.into()));
    let found = level(&upside_down.expect("a valid map"), 1, Filter::Min);
    assert!(is_just(found.texels(), [0.75, 0.5, 0.5, 0.0], f32::next_down), "{found:?}");
}

#[test]
fn bounds_hold_in_any_bits() {
    let metric = Metric::unit_tile(0.1).expect("a length");
    for (at, (name, map)) in (0..).zip(all()) {
        for (bits, filter) in [(8, Filter::Max), (8, Filter::Min), (16, Filter::Max)] {
            let set = [("bits", f64::from(bits)), ("filter", f64::from(filter as u32))];
            let baked = stored::textures(&KIND, &map, metric, &set).expect("a bake").remove(0);
            let decoded = stored::heights(&map, bits).expect("a valid map");
            assert_eq!(baked.levels[0][0], decoded.texels(), "{name}: level 0 is the map");
            for (number, channels) in baked.levels.iter().enumerate() {
                let [width, height, _] = baked.texture.level_size(number);
                let own = |value: f32| quantise::unorm(value, bits, Rounding::Nearest) == value;
                assert!(channels[0].iter().all(|&value| own(value)), "{name}: no value of {bits} bits");
                let found = HeightMap::new(width, height, channels[0].clone(), map.wrap());
                let by = trespass(&decoded, &found.expect("a valid map"), filter, at);
                assert!(by <= ROUNDED, "{name} {filter} in {bits} bits, level {number}: {by}");
            }
        }
    }
}

/// Returns the hat of a texel of a level, at a point of the square.
fn hat(level: &HeightMap, [i, j]: [u32; 2], [u, v]: [f64; 2]) -> f64 {
    let along = |at: f64, texel: u32, side: u32| {
        let place = at * f64::from(side) - 0.5;
        let (before, part) = (place.floor() as i64, place - place.floor());
        let of = |index: i64, share: f64| if level.wrap().index(index, side) == texel { share } else { 0.0 };
        of(before, 1.0 - part) + of(before + 1, part)
    };
    along(u, i, level.width()) * along(v, j, level.height())
}

/// Returns the exact integral over the square of a function, by Simpson's rule. Between the lines
/// through the centres of both grids, the function must be at most of the second degree along
/// either axis, such as products of two of their surfaces.
fn integral(map: &HeightMap, level: &HeightMap, value: impl Fn([f64; 2]) -> f64) -> f64 {
    let [across, down] = [[map.width(), level.width()], [map.height(), level.height()]].map(|sides| {
        let centres = sides
            .into_iter()
            .flat_map(|side| (0..side).map(move |texel| (f64::from(texel) + 0.5) / f64::from(side)));
        let mut lines: Vec<f64> = centres.chain([0.0, 1.0]).collect();
        lines.sort_by(f64::total_cmp);
        let points = |pair: &[f64]| {
            let (from, to) = (pair[0], pair[1]);
            [(from, 1.0), (0.5 * (from + to), 4.0), (to, 1.0)]
                .map(|(at, share)| (at, share * (to - from) / 6.0))
        };
        lines.windows(2).flat_map(points).collect::<Vec<_>>()
    });
    let rows = down
        .iter()
        .map(|&(v, row)| row * across.iter().map(|&(u, column)| column * value([u, v])).sum::<f64>());
    rows.sum()
}

/// The integral of the squared difference.
fn squares(map: &HeightMap, level: &HeightMap) -> f64 {
    integral(map, level, |[u, v]| (level.height_at(u, v) - map.height_at(u, v)).powi(2))
}

#[test]
fn the_residual_of_least_squares_is_orthogonal_to_every_hat() {
    let small = [("noise", 6, 7), ("odd", 9, 5), ("one row", 11, 1), ("one column", 1, 6), ("even", 8, 4)];
    let mut at_bounds = 0;
    for (seed, (name, width, height)) in (1..).zip(small) {
        for wrap in Wrap::ALL {
            let mut rng = Rng::new(seed);
            let map = HeightMap::from_fn(width, height, wrap, |_, _| rng.between(-0.3, 1.3) as f32);
            let map = map.expect("a valid map");
            for number in 1..map.levels() {
                let found = level(&map, number, Filter::LeastSquares);
                let texels = (0..found.height()).flat_map(|j| (0..found.width()).map(move |i| [i, j]));
                for texel in texels {
                    let product = |[u, v]: [f64; 2]| {
                        (found.height_at(u, v) - map.height_at(u, v)) * hat(&found, texel, [u, v])
                    };
                    let size = integral(&map, &found, |at| hat(&found, texel, at));
                    let mean = integral(&map, &found, product) / size;
                    let height = found.texel(i64::from(texel[0]), i64::from(texel[1]));
                    // A height at its limit would go further.
                    let is_right = match height {
                        0.0 => mean > -1e-6,
                        1.0 => mean < 1e-6,
                        _ => mean.abs() < 1e-6,
                    };
                    at_bounds += usize::from(height == 0.0 || height == 1.0);
                    assert!(is_right, "{name} {wrap}, level {number}, {texel:?}: {height}, {mean}");
                }
            }
        }
    }
    assert!(at_bounds > 0, "no height is at a bound");
}

/// Returns a map of white noise between those heights.
fn noise(size: [u32; 2], wrap: Wrap, seed: u64, [low, high]: [f64; 2]) -> HeightMap {
    let mut rng = Rng::new(seed);
    HeightMap::from_fn(size[0], size[1], wrap, |_, _| rng.between(low, high) as f32).expect("a valid map")
}

/// Returns the level with a texel moved by `by`, if this stays in range.
fn moved(level: &HeightMap, at: usize, by: f32) -> Option<HeightMap> {
    let mut texels = level.texels().to_vec();
    texels[at] += by;
    HeightMap::new(level.width(), level.height(), texels, level.wrap()).ok()
}

#[test]
fn any_small_change_of_a_texel_raises_the_squared_error() {
    let mut at_bounds = 0;
    for wrap in Wrap::ALL {
        let cases =
            [([12, 10], [0.2, 0.8]), ([13, 7], [0.0, 1.0]), ([9, 1], [0.0, 1.0]), ([16, 16], [0.0, 1.0])];
        let spike = HeightMap::from_fn(10, 11, wrap, |i, j| if [i, j] == [4, 5] { 1.0 } else { 0.0 });
        let maps = cases.map(|(size, heights)| noise(size, wrap, 5, heights));
        for map in maps.into_iter().chain([spike.expect("a valid map")]) {
            for number in 1..map.levels() {
                let found = level(&map, number, Filter::LeastSquares);
                let least = squares(&map, &found);
                let average = squares(&map, &map.level(number));
                assert!(
                    least <= average + 1e-12,
                    "{wrap}, level {number}: {least} beside the average's {average}"
                );
                for at in 0..found.texels().len() {
                    at_bounds += usize::from([0.0, 1.0].contains(&found.texels()[at]));
                    for other in [1e-4, -1e-4].into_iter().filter_map(|by| moved(&found, at, by)) {
                        let more = squares(&map, &other);
                        assert!(more > least, "{wrap}, level {number}, texel {at}: {more} below {least}");
                    }
                }
            }
        }
    }
    assert!(at_bounds > 0, "no height is at a bound");
}

/// Returns the volume between the surfaces, by `points` points a texel of the map along either
/// axis.
fn volume(map: &HeightMap, level: &HeightMap, points: u32) -> f64 {
    let [columns, rows] = [map.width() * points, map.height() * points];
    let mut sum = 0.0;
    for row in 0..rows {
        let v = (f64::from(row) + 0.5) / f64::from(rows);
        for column in 0..columns {
            let u = (f64::from(column) + 0.5) / f64::from(columns);
            sum += (level.height_at(u, v) - map.height_at(u, v)).abs();
        }
    }
    sum / f64::from(columns) / f64::from(rows)
}

#[test]
fn the_variational_volume_is_the_least_of_all() {
    let mut ratios = Vec::new();
    for (name, map) in all() {
        for number in 1..map.levels().min(5) {
            let of = |filter| {
                let found = level(&map, number, filter);
                [volume(&map, &found, 6), difference_volume(&map, &found)]
            };
            let [average, squares, variational] =
                [Filter::Average, Filter::LeastSquares, Filter::Variational].map(of);
            for other in [average, squares] {
                assert!(variational[1] <= other[1], "{name}, level {number}: {variational:?}, {other:?}");
                // By other points it differs by as much as the two sums differ.
                let off = (other[0] - other[1]).abs() + 1e-7;
                assert!(
                    variational[0] <= other[0] + off,
                    "{name}, level {number}: {variational:?}, {other:?}"
                );
            }
            let most = if name.starts_with("natural") { 0.03 } else { 0.34 };
            let off = (variational[0] - variational[1]).abs();
            assert!(off <= most * variational[0] + 1e-7, "{name}, level {number}: {variational:?}");
            if name.starts_with("natural") && number <= 3 {
                ratios.push(variational[0] / average[0]);
            }
        }
    }
    ratios.sort_by(f64::total_cmp);
    assert!(ratios.len() == 18 && ratios[ratios.len() - 1] <= 0.85, "over the average's: {ratios:?}");
}

#[test]
fn no_small_change_of_texels_lowers_the_volume_much() {
    for wrap in Wrap::ALL {
        let map = maps::ALL.iter().find(|named| named.name == "natural 101x67").expect("a map").build(wrap);
        for number in 1..4 {
            let found = level(&map, number, Filter::Variational);
            let least = difference_volume(&map, &found);
            let average = difference_volume(&map, &map.level(number));
            let mut rng = Rng::new(3);
            for _ in 0..40 {
                let size = rng.between(1e-4, 1e-2);
                let texels = found
                    .texels()
                    .iter()
                    .map(|texel| (f64::from(*texel) + rng.between(-size, size)).clamp(0.0, 1.0) as f32);
                let other = HeightMap::new(found.width(), found.height(), texels.collect(), wrap);
                let other = difference_volume(&map, &other.expect("a valid map"));
                assert!(other > least - 2e-3 * average, "{wrap}, level {number}: {other} below {least}");
            }
        }
    }
}

#[test]
fn the_gradient_is_that_of_finite_differences() {
    for (size, wrap) in [([16, 12], Wrap::Repeat), ([13, 9], Wrap::Clamp), ([11, 7], Wrap::Mirror)] {
        let map = noise(size, wrap, 11, [0.1, 0.9]);
        for number in 1..map.levels() {
            let average = map.level(number);
            let gradient = difference_volume_gradient(&map, &average);
            for (at, &slope) in gradient.iter().enumerate() {
                let by = 1e-6;
                let [more, less] =
                    [by, -by].map(|by| moved(&average, at, by).expect("heights within the range"));
                let rise = f64::from(more.texels()[at]) - f64::from(less.texels()[at]);
                let found = (difference_volume(&map, &more) - difference_volume(&map, &less)) / rise;
                // No point changes sides within so short a way.
                assert!((found - slope).abs() < 1e-8, "{wrap}, level {number}, {at}: {found} {slope}");
            }
        }
    }
}

#[test]
fn levels_are_the_same_bits_with_any_number_of_threads() {
    let map = HeightMap::new(301, 203, maps::fractal(3, 301, 203, 0.6), Wrap::Repeat).expect("a valid map");
    for filter in Filter::ALL {
        let with = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
            pool.install(|| levels(&map, filter))
        };
        let one = with(1);
        for threads in [2, 5] {
            for (one, other) in one.iter().zip(with(threads)) {
                let bits = |map: &HeightMap| map.texels().iter().map(|t| t.to_bits()).collect::<Vec<_>>();
                assert_eq!(bits(one), bits(&other), "{filter} with {threads} threads");
            }
        }
    }
}

#[test]
fn a_cancelled_bake_ends_and_progress_rises_to_the_end() {
    let map = HeightMap::new(64, 48, maps::fractal(3, 64, 48, 0.6), Wrap::Clamp).expect("a valid map");
    for filter in Filter::ALL.into_iter().filter(|filter| *filter != Filter::Average) {
        let cancel = AtomicBool::new(true);
        let cancelled = filter_levels(&map, filter, &Watch::cancelled_by(&cancel));
        assert!(matches!(cancelled, Err(BakeError::Cancelled(_))), "{filter}");
        let last = std::sync::Mutex::new(0.0f32);
        let keep = |_: &str, part: f32| {
            let mut last = last.lock().expect("no panic while it is held");
            *last = last.max(part);
        };
        filter_levels(&map, filter, &Watch::telling(&keep)).expect("not cancelled");
        let last = *last.lock().expect("no panic while it was held");
        assert!((last - 1.0).abs() < 1e-5, "{filter}: {last}");
    }
}

#[test]
fn filters_have_names_and_the_nearest_is_suggested() {
    for filter in Filter::ALL {
        assert_eq!(filter.name().parse::<Filter>().expect("its own name"), filter);
        assert_eq!(Filter::ALL[filter as usize], filter);
    }
    let error = "variationel".parse::<Filter>().expect_err("no filter").to_string();
    assert!(error.contains("variational"), "{error}");
}
