//! The distance field against a search, and its bound under attack.

use relief_bake::kind::distance::{DistanceField, KIND};
use relief_bake::{BakeError, Collected, bake};
use relief_core::rng::Rng;
use relief_core::{HeightMap, Metric, Watch, Wrap};
use relief_testing::brute::distance::{boxes, to_surface};
use relief_testing::maps;
use relief_testing::probes::distance::Field;
use relief_tests::probes::{run, stored};

/// Probes a map, wrap and number of bits.
const PROBES: usize = 100_000;

fn metrics() -> [Metric; 2] {
    [
        Metric::unit_tile(0.2).expect("positive lengths"),
        Metric::new([2.0, 0.6], 0.4).expect("positive lengths"),
    ]
}

fn baked(map: &HeightMap, metric: Metric, slices: u32, bits: u32) -> Vec<f32> {
    let set = [("slices", f64::from(slices)), ("bits", f64::from(bits))];
    let texture = stored::textures(&KIND, map, metric, &set).expect("nothing cancels it").remove(0);
    assert_eq!(texture.texture.size, [map.width(), map.height(), slices]);
    let [low, high] = texture.texture.channels[0].range;
    let values = texture.levels.into_iter().flatten().flatten().collect::<Vec<f32>>();
    assert!(values.iter().all(|value| (low..=high).contains(value)), "a value is out of {low} to {high}");
    values
}

/// Returns whether a value is right for a distance to the boxes: below the bound by no more than
/// rounding.
fn is_bound(value: f32, distance: f64, half_diagonal: f64) -> bool {
    let over = distance * distance - half_diagonal * half_diagonal;
    let most = if over <= half_diagonal * half_diagonal { over / half_diagonal } else { over.sqrt() };
    let least = most - half_diagonal / 127.0 - 4e-6 * (most.abs() + half_diagonal);
    (least..most).contains(&f64::from(value))
}

#[test]
fn it_is_the_distance_to_the_boxes() {
    for named in maps::ALL {
        for wrap in Wrap::ALL {
            let map = named.build(wrap);
            for metric in metrics().into_iter().skip(usize::from(wrap != Wrap::Repeat)) {
                let slices = 4;
                let field = DistanceField::new(&map, metric, slices);
                let half = field.half_diagonal_m();
                let values = baked(&map, metric, slices, 0);
                for (k, slice) in values.chunks(map.texels().len()).enumerate() {
                    let level = if k == 0 { 0.0 } else { (k as f64 + 0.5) / f64::from(slices) };
                    let exact = boxes(&map, metric.tile_m, metric.scale_m, level);
                    for (at, (&value, &distance)) in slice.iter().zip(&exact).enumerate() {
                        assert!(
                            is_bound(value, distance, half),
                            "{} {wrap}, slice {k}, texel {at}: {value} for {distance}",
                            named.name
                        );
                    }
                    // The comparison would notice the distances of another texel.
                    let shifted = slice.iter().zip(exact.iter().cycle().skip(1));
                    let noticed = shifted.filter(|&(&value, &distance)| !is_bound(value, distance, half));
                    let expected = k == 3 && named.name.starts_with("white noise");
                    assert!(!expected || noticed.count() > 0, "{} {wrap}, slice {k}", named.name);
                }
            }
        }
    }
}

#[test]
fn a_fetch_is_never_more_than_the_distance_to_the_surface() {
    for case in [0, 8, 16].into_iter().flat_map(|bits| run::cases(KIND.name, bits)) {
        let outcome = run::run(&case, PROBES, &|_| {}).expect("a bake");
        assert_eq!(outcome.violations, 0, "{case:?}: {outcome:?}");
    }
}

#[test]
fn a_field_looser_than_its_tightest_contact_is_caught() {
    let Metric { tile_m, scale_m } = metrics()[0];
    for (place, (name, wrap)) in run::MAPS.into_iter().enumerate() {
        for bits in [0, 8, 16] {
            let original = run::map(place);
            let values = baked(&original, metrics()[0], 24, bits);
            let map = stored::heights(&original, bits).expect("a map");
            let field = Field { map: &map, tile_m, scale_m, slices: 24, values: &values };
            let (room, tightest) = field.attack(PROBES, 1).tightest.expect("there are probes");
            // By a step of 16 bits.
            let step = (room + scale_m / 65_535.0) as f32;
            let loose: Vec<f32> = values.iter().map(|value| value + step).collect();
            let caught = Field { values: &loose, ..field }.contact(tightest.from, tightest.surface);
            assert!(caught.slack_m < 0.0, "{name} {wrap} {bits} bits: not caught, {caught:?}");
        }
    }
}

#[test]
fn what_was_given_away_is_known() {
    // Leaving out the dilation, or storing distances as they are, breaks the bound, and the probes
    // find it.
    let map = maps::ALL[0].build(Wrap::Repeat);
    let metric = metrics()[0];
    let undiminished: Vec<f32> = (0..24)
        .flat_map(|k| boxes(&map, metric.tile_m, metric.scale_m, (f64::from(k) + 0.5) / 24.0))
        .map(|distance| distance as f32)
        .collect();
    let Metric { tile_m, scale_m } = metric;
    let field = Field { map: &map, tile_m, scale_m, slices: 24, values: &undiminished };
    assert!(field.attack(PROBES, 2).violations > 0, "no probe finds a fetch that is too long");
}

#[test]
fn a_fetch_is_near_the_distance_to_the_surface() {
    let map = maps::ALL[2].build(Wrap::Repeat);
    let metric = metrics()[0];
    let values = baked(&map, metric, 64, 0);
    let Metric { tile_m, scale_m } = metric;
    let field = Field { map: &map, tile_m, scale_m, slices: 64, values: &values };
    let half = DistanceField::new(&map, metric, 64).half_diagonal_m();
    let mut rng = Rng::new(6);
    let (mut fetched, mut simple, mut distances) = (0.0, 0.0, 0.0);
    for _ in 0..1500 {
        let [u, v] = [rng.unit(), rng.unit()];
        let ground = map.height_at(u, v);
        let from = [u, v, rng.between(ground, 1.0)];
        let distance = to_surface(&map, tile_m, scale_m, from);
        let fetch = field.fetch(from);
        assert!(fetch <= distance, "{from:?}: {fetch} m, more than {distance} m");
        fetched += fetch.max(0.0);
        simple += (distance - half).max(0.0);
        distances += distance;
    }
    println!(
        "mean fetch {:.3} of the distance, half a diagonal off it {:.3}",
        fetched / distances,
        simple / distances
    );
    assert!(fetched > 0.7 * distances, "{fetched} m of {distances} m are given away");
}

#[test]
fn threads_do_not_change_a_bit_and_cancelling_ends_it() {
    let map = maps::ALL[0].build(Wrap::Repeat);
    let metric = metrics()[1];
    let pool = |threads| rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
    let one = pool(1).install(|| baked(&map, metric, 9, 0));
    assert_eq!(one, pool(3).install(|| baked(&map, metric, 9, 0)));
    let flag = std::sync::atomic::AtomicBool::new(true);
    let ended =
        bake(&KIND, &map, metric, &KIND.defaults(), &Watch::cancelled_by(&flag), &mut Collected::default());
    assert!(matches!(ended, Err(BakeError::Cancelled(_))));
}

#[test]
fn lengths_beyond_floats_are_refused() {
    let map = maps::ALL[0].build(Wrap::Clamp);
    for scale in [1e-60, 1e60] {
        let metric = Metric { tile_m: [scale; 2], scale_m: scale };
        let refused = bake(&KIND, &map, metric, &KIND.defaults(), &Watch::none(), &mut Collected::default());
        assert!(matches!(refused, Err(BakeError::Impossible { .. })));
    }
}
