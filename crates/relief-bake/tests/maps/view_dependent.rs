//! View-dependent maps against exact tracers: first hits, and ways that no ray may be stopped on.

use std::f64::consts::TAU;

use relief_bake::view_dependent::{
    Axes, MOST_SCALE, Matrix, TOUCHING, bend, free_ways, truncated_svd, whole_way,
};
use relief_bake::{BakeError, Collected, Settings, bake, kind};
use relief_core::exact::{PyramidTracer, cell_walk};
use relief_core::rng::Rng;
use relief_core::{HeightMap, Metric, Path, PathMetric, Watch, Wrap};
use relief_testing::maps;

const AXES: Axes = Axes { azimuths: 8, elevations: 4, bends: 4, depth: 0.1 };

fn settings(name: &str, axes: Axes, bits: f64) -> Settings {
    let mut settings = kind(name).expect("a kind").defaults();
    for (name, value) in [
        ("azimuths", f64::from(axes.azimuths)),
        ("elevations", f64::from(axes.elevations)),
        ("bends", f64::from(axes.bends)),
        ("depth", axes.depth),
        ("bits", bits),
    ] {
        settings.set(name, value).expect("a setting");
    }
    settings
}

fn baked(name: &str, map: &HeightMap, axes: Axes, bits: f64) -> Vec<f32> {
    let mut sink = Collected::default();
    let metric = Metric::unit_tile(0.1).expect("a metric");
    bake(kind(name).expect("a kind"), map, metric, &settings(name, axes, bits), &Watch::none(), &mut sink)
        .expect("a bake");
    sink.textures.remove(0).levels.remove(0).remove(0)
}

/// A path that comes in at the top, with the way as its parameter, and its place on the axes.
struct Drawn {
    path: Path,
    /// Azimuth, elevation and place of the bend, from 0 to 1.
    at: [f64; 3],
}

/// Draws a path; without bends a straight one.
fn draw(rng: &mut Rng, axes: &Axes) -> Drawn {
    let at = [rng.unit(), rng.unit().min(0.999), rng.unit()];
    let (angle, length) = (TAU * at[0], axes.depth * at[1] / (1.0 - at[1]));
    let place = 2.0 * at[2] - 1.0;
    let bend = if axes.bends == 1 { 0.0 } else { TOUCHING * place / (1.0 - place.abs()) };
    let path = Path {
        uv: [3.0 * rng.unit() - 1.0, 3.0 * rng.unit() - 1.0],
        duv: [length * angle.cos(), length * angle.sin()],
        h: [1.0, -1.0, bend],
        exit: whole_way(bend),
        base: 0.0,
        metric: PathMetric::unit(1.0),
    };
    Drawn { path, at }
}

impl Drawn {
    /// The stored way of the cell that the path comes in at, as a part of its whole way.
    fn stored(&self, map: &HeightMap, axes: &Axes, values: &[f32]) -> f64 {
        let size = [map.width(), map.height()];
        let mut turn = self.at[0];
        let [column, row] = [0, 1].map(|axis| {
            let at = (self.path.uv[axis] * f64::from(size[axis])).floor() as i64;
            if map.wrap() == Wrap::Mirror && self.path.uv[axis].floor().rem_euclid(2.0) == 1.0 {
                turn = if axis == 0 { 0.5 - turn } else { -turn };
            }
            map.wrap().index(at, size[axis])
        });
        let step = |at: f64, count: u32| ((at * f64::from(count)) as u32).min(count - 1);
        let azimuth = step(turn.rem_euclid(1.0), axes.azimuths);
        let layer = azimuth * axes.elevations + step(self.at[1], axes.elevations);
        let rows = size[1] * axes.bends;
        let row = row + step(self.at[2], axes.bends) * size[1];
        let part = f64::from(values[((layer * rows + row) * size[0] + column) as usize]);
        // Of the longest way of its step of bends, at most all of its own.
        let longest = axes.ranges(0, step(self.at[2], axes.bends)).longest;
        (part * longest / self.path.exit).min(1.0)
    }

    /// Whether it is free on the stored part of its whole way.
    fn is_free(&self, map: &HeightMap, stored: f64) -> bool {
        // Touching at the end is no hit before it.
        let exit = stored * self.path.exit * (1.0 - 1e-9);
        exit == 0.0 || !cell_walk(map, &Path { exit, ..self.path }).hit.found
    }
}

/// The paths of a map that are stopped too early, and the mean of the stored parts of the ways to hits.
fn judge(map: &HeightMap, axes: Axes, values: &[f32], count: usize) -> (usize, f64) {
    let mut rng = Rng::new(7);
    let (mut late, mut part) = (0, 0.0);
    for _ in 0..count {
        let drawn = draw(&mut rng, &axes);
        if map.wrap() == Wrap::Clamp && drawn.path.uv.iter().any(|at| !(0.0..1.0).contains(at)) {
            continue;
        }
        let stored = drawn.stored(map, &axes, values);
        late += usize::from(!drawn.is_free(map, stored));
        part += stored;
    }
    (late, part / count as f64)
}

#[test]
fn no_ray_meets_anything_on_a_free_way() {
    for named in maps::ALL {
        for wrap in Wrap::ALL {
            let map = named.build(wrap);
            for (bends, bits) in [(1, 0.0), (4, 8.0), (3, 16.0)] {
                let axes = Axes { bends, ..AXES };
                let values = baked("view-dependent-free", &map, axes, bits);
                let (late, _) = judge(&map, axes, &values, 4000);
                assert_eq!(late, 0, "{} {wrap} {bends} bends, {bits} bits", named.name);
            }
        }
    }
}

/// Longer ways than those stored stop rays: the judge sees an eighth more, and azimuths one step off.
#[test]
fn ways_that_are_too_long_are_noticed() {
    let map = maps::ALL[0].build(Wrap::Repeat);
    let values = baked("view-dependent-free", &map, AXES, 8.0);
    let longer: Vec<f32> = values.iter().map(|way| (way + 0.125).min(1.0)).collect();
    assert!(judge(&map, AXES, &longer, 20_000).0 > 0);
    let layer = values.len() / AXES.layers() as usize;
    let turned: Vec<f32> = values.iter().cycle().skip(3 * 4 * layer).take(values.len()).copied().collect();
    assert!(judge(&map, AXES, &turned, 20_000).0 > 0);
}

/// The bound is of use: over a bumpy map rays are free for a fifth of their way on average, over a flat
/// one for nearly all of it.
#[test]
fn free_ways_are_long() {
    let bumpy = HeightMap::from_fn(64, 64, Wrap::Repeat, |i, j| {
        let [x, y] = [i, j].map(|at| (TAU * f64::from(at) / 16.0).sin());
        (0.5 + 0.25 * (x + y)) as f32
    });
    let flat = HeightMap::from_fn(16, 16, Wrap::Repeat, |_, _| 0.0);
    let axes = Axes { azimuths: 16, elevations: 8, bends: 1, depth: 0.1 };
    for (map, least) in [(bumpy.expect("a map"), 0.2), (flat.expect("a map"), 0.97)] {
        let values = baked("view-dependent-free", &map, axes, 8.0);
        let (late, mean) = judge(&map, axes, &values, 20_000);
        assert!(late == 0 && mean > least, "{late} {mean}");
    }
}

#[test]
fn hits_are_those_of_another_exact_tracer() {
    for named in maps::ALL {
        let map = named.build(Wrap::Mirror);
        let values = baked("view-dependent", &map, AXES, 0.0);
        let tracer = PyramidTracer::new(&map);
        let mut rng = Rng::new(3);
        for _ in 0..2000 {
            let [column, row] = [map.width(), map.height()].map(|side| rng.below(side));
            let layer = rng.below(AXES.layers());
            let step = rng.below(AXES.bends);
            let uv = [
                (f64::from(column) + 0.5) / f64::from(map.width()),
                (f64::from(row) + 0.5) / f64::from(map.height()),
            ];
            let path = AXES.path(uv, layer, step);
            let hit = tracer.trace(&Path { exit: path.exit * (1.0 + 1e-6), ..path }).hit;
            let expected = if hit.found { (hit.t / path.exit).min(254.0 / 255.0) } else { 1.0 };
            let at = (layer * AXES.bends + step) * map.height() + row;
            let found = f64::from(values[(at * map.width() + column) as usize]);
            assert!((found - expected).abs() < 1e-6, "{} {layer} {step}: {found} for {expected}", named.name);
        }
    }
}

/// The sums of the products of a compressed map's factors, view by view.
fn sums(map: &HeightMap, axes: Axes, settings: &[(&str, f64)], bits: f64) -> Vec<f32> {
    let mut all = settings_of_ways(axes, bits);
    settings.iter().for_each(|(name, value)| all.set(name, *value).expect("a setting"));
    let mut sink = Collected::default();
    let metric = Metric::unit_tile(0.1).expect("a metric");
    bake(kind("view-dependent").expect("a kind"), map, metric, &all, &Watch::none(), &mut sink)
        .expect("a bake");
    let baked = sink.textures.remove(0);
    let [columns, rows, layers] = baked.texture.size.map(|side| side as usize);
    let channels = &baked.levels[0];
    let is_clustered = settings.iter().any(|(name, _)| *name == "clusters");
    let texels = map.texels().len();
    let views = (axes.layers() * axes.bends) as usize;
    let value = |layer: usize, channel: usize, place: usize| {
        f64::from(channels[channel][layer * columns * rows + place])
    };
    let signed = |value: f64| if is_clustered { value } else { 2.0 * value - 1.0 };
    let mut sums = vec![0.0; views * texels];
    for texel in 0..texels {
        let cluster = if is_clustered { (value(0, 0, texel) * 255.0).round() as usize } else { 0 };
        let first = texels + cluster * (views + 2);
        for layer in usize::from(is_clustered)..layers {
            for channel in 0..4 {
                let at = |place| value(layer, channel, place);
                let root = at(first + views) + at(first + views + 1) / 255.0;
                let scaled = signed(at(texel)) * f64::from(MOST_SCALE) * root * root;
                for view in 0..views {
                    sums[view * texels + texel] += scaled * signed(at(first + view));
                }
            }
        }
    }
    sums.into_iter().map(|sum| sum as f32).collect()
}

fn settings_of_ways(axes: Axes, bits: f64) -> Settings {
    settings("view-dependent", axes, bits)
}

/// The squares of what sums are off from ways, where a way that meets nothing is 1.25.
fn off(ways: &[f32], sums: &[f32]) -> f64 {
    let target = |way: f32| if way >= 1.0 { 1.25 } else { way };
    ways.iter().zip(sums).map(|(&way, &sum)| f64::from(target(way) - sum).powi(2)).sum()
}

#[test]
fn factors_of_all_ranks_are_the_ways_and_fewer_leave_out_what_their_singular_values_say() {
    let map = maps::ALL[0].build(Wrap::Repeat);
    for bends in [1, 3] {
        let axes = Axes { bends, ..AXES };
        let ways = baked("view-dependent", &map, axes, 0.0);
        let views = (axes.layers() * bends) as usize;
        let all = sums(&map, axes, &[("rank", views.min(256) as f64)], 0.0);
        let worst = off(&ways, &all).sqrt() / (ways.len() as f64).sqrt();
        assert!(worst < 1e-4, "{bends} bends: {worst}");
        let matrix = Matrix {
            columns: map.texels().len(),
            values: ways.iter().map(|&way| if way >= 1.0 { 1.25 } else { way }).collect(),
        };
        let exact = truncated_svd(&matrix, views, &Watch::none()).expect("a decomposition");
        let mut before = f64::INFINITY;
        for rank in [1, 4, 9, 16] {
            let dropped: f64 = exact.singular[rank..].iter().map(|value| value * value).sum();
            let left = off(&ways, &sums(&map, axes, &[("rank", rank as f64)], 0.0));
            assert!((left - dropped).abs() < 1e-3 * dropped, "{bends} {rank}: {left} for {dropped}");
            let coded = off(&ways, &sums(&map, axes, &[("rank", rank as f64)], 8.0));
            assert!(
                coded < 1.1 * dropped + 1e-4 * ways.len() as f64,
                "{bends} {rank}: {coded} for {dropped}"
            );
            assert!(left < before);
            before = left;
        }
    }
}

#[test]
fn more_clusters_and_terms_leave_out_less() {
    let map = maps::ALL[0].build(Wrap::Repeat);
    let ways = baked("view-dependent", &map, AXES, 0.0);
    let left = [[1, 2], [1, 6], [6, 6], [40, 6]].map(|[clusters, rank]| {
        off(&ways, &sums(&map, AXES, &[("rank", f64::from(rank)), ("clusters", f64::from(clusters))], 8.0))
    });
    assert!(left.windows(2).all(|pair| pair[1] < pair[0]), "{left:?}");
    assert!(left[3] < 0.5 * left[0], "{left:?}");
}

/// More terms and clusters than there are texels, and texels that are all alike.
#[test]
fn maps_of_few_texels_have_fewer_terms_and_clusters() {
    for (size, height) in [([1, 1], 0.5), ([2, 1], 0.0), ([5, 3], 1.0)] {
        for wrap in Wrap::ALL {
            let map = HeightMap::from_fn(size[0], size[1], wrap, |_, _| height).expect("a map");
            let ways = baked("view-dependent", &map, AXES, 0.0);
            for changed in [&[("rank", 30.0)][..], &[("rank", 5.0), ("clusters", 40.0)]] {
                let worst = off(&ways, &sums(&map, AXES, changed, 8.0)).sqrt() / (ways.len() as f64).sqrt();
                assert!(worst < 0.02, "{size:?} {height} {wrap} {changed:?}: {worst}");
            }
        }
    }
}

#[test]
fn compressions_that_cannot_be_are_refused_with_a_remedy() {
    let map = maps::ALL[0].build(Wrap::Repeat);
    let metric = Metric::unit_tile(0.1).expect("a metric");
    for (changed, word) in [
        (&[("rank", 200.0)][..], "128"),
        (&[("clusters", 3.0)], "rank"),
        (&[("rank", 2.0), ("clusters", 256.0), ("bends", 64.0), ("elevations", 16.0)], "rows"),
    ] {
        let mut all = settings_of_ways(AXES, 8.0);
        changed.iter().for_each(|(name, value)| all.set(name, *value).expect("a setting"));
        let mut sink = Collected::default();
        let narrow = HeightMap::from_fn(1, 2, Wrap::Repeat, |_, _| 0.5).expect("a map");
        let map = if word == "rows" { &narrow } else { &map };
        let refused =
            bake(kind("view-dependent").expect("a kind"), map, metric, &all, &Watch::none(), &mut sink);
        assert!(
            matches!(&refused, Err(BakeError::Impossible { reason, .. }) if reason.contains(word)),
            "{changed:?}: {refused:?}"
        );
        assert!(sink.textures.is_empty());
    }
}

/// The axes' own places lead back to the middles of the steps.
#[test]
fn paths_lie_in_the_middle_of_their_steps() {
    for layer in 0..AXES.layers() {
        for step in 0..AXES.bends {
            let path = AXES.path([0.0; 2], layer, step);
            let [du, dv] = path.duv;
            let turn = dv.atan2(du).rem_euclid(TAU) / TAU * f64::from(AXES.azimuths);
            let elevation = AXES.elevation(du.hypot(dv)) * f64::from(AXES.elevations);
            let place = (0.5 + 0.5 * bend(path.h[2])) * f64::from(AXES.bends);
            for (at, number) in
                [(turn, layer / AXES.elevations), (elevation, layer % AXES.elevations), (place, step)]
            {
                assert!((at - f64::from(number) - 0.5).abs() < 1e-9, "{layer} {step}: {at}");
            }
            let [_, _, end] = path.at(path.exit);
            assert!(end.abs() < 1e-12 || (end - 1.0).abs() < 1e-12, "{end}");
        }
    }
}

#[test]
fn too_many_directions_are_refused_and_work_can_be_stopped() {
    let map = maps::ALL[0].build(Wrap::Clamp);
    let metric = Metric::unit_tile(0.1).expect("a metric");
    for name in ["view-dependent", "view-dependent-free"] {
        let mut sink = Collected::default();
        let many = settings(name, Axes { azimuths: 32, elevations: 16, ..AXES }, 0.0);
        let refused = bake(kind(name).expect("a kind"), &map, metric, &many, &Watch::none(), &mut sink);
        assert!(
            matches!(&refused, Err(BakeError::Impossible { reason, .. }) if reason.contains("512")),
            "{refused:?}"
        );
        let stop = std::sync::atomic::AtomicBool::new(true);
        let watch = Watch::new(&|_, _| {}, &stop);
        let stopped =
            bake(kind(name).expect("a kind"), &map, metric, &settings(name, AXES, 0.0), &watch, &mut sink);
        assert!(matches!(stopped, Err(BakeError::Cancelled(_))), "{stopped:?}");
    }
    let ranges = AXES.ranges(0, 0);
    assert!(free_ways(&map, &ranges, &Watch::none()).is_ok_and(|free| free.len() == map.texels().len()));
}
