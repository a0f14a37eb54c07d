//! Precomputed visibility against the exact tracer, and bounced light computed with it.

use relief_bake::kind::visibility::{KIND, Visibility, views};
use relief_bake::{Collected, bake};
use relief_core::{HeightMap, Metric, Watch, Wrap};
use relief_testing::brute::visibility as brute;
use relief_testing::maps;

/// Distance of the judged texels of each map.
const STRIDE: usize = 7;

fn metrics() -> [Metric; 2] {
    [Metric::unit_tile(0.1).expect("a valid metric"), Metric::new([2.0, 0.7], 0.4).expect("a valid metric")]
}

/// Calls `judge` with each judged texel's path and its baked hit in steps.
fn each_ray(map: &HeightMap, metric: Metric, mut judge: impl FnMut(&relief_core::Path, Option<f64>)) {
    views(map, metric, [10, 3], 4, &Watch::none(), &mut |view| {
        let [x, y, z] = view.direction;
        assert!((x * x + y * y + z * z - 1.0).abs() < 1e-12);
        let step = [0, 1].map(|axis| view.step_uv[axis] * metric.tile_m[axis]);
        let slope = z / x.hypot(y) * step[0].hypot(step[1]) / metric.scale_m;
        // Length of the promised ray: until it is above the map, or four tiles.
        let along_u = view.step_uv[0].abs() * f64::from(map.width()) > 1.0 - 1e-12;
        let side = f64::from(if along_u { map.width() } else { map.height() });
        let reach = (1.0 / slope).min((4.0 * side).max(64.0));
        for texel in (0..map.texels().len()).step_by(STRIDE) {
            let place = [texel as u32 % map.width(), texel as u32 / map.width()];
            let steps = f64::from(view.steps[texel]);
            judge(&brute::path(map, place, view.step_uv, slope, reach), steps.is_finite().then_some(steps));
        }
        Ok(())
    })
    .expect("not cancelled");
}

#[test]
fn every_hit_is_the_first() {
    let (mut rays, mut hits) = (0, 0);
    for named in maps::ALL {
        for wrap in Wrap::ALL {
            let map = named.build(wrap);
            for metric in metrics() {
                each_ray(&map, metric, |path, steps| {
                    rays += 1;
                    hits += usize::from(steps.is_some());
                    // A distance in f32 is off by 2⁻²⁴; ray and surface part by a few heights a
                    // step.
                    let slack = 1e-6 * (1.0 + steps.unwrap_or(0.0) * 0.1) * (1.0 + path.h[1]);
                    let within = steps.is_none_or(|steps| steps <= path.exit);
                    assert!(
                        !within || brute::is_first_hit(&map, path, steps, slack),
                        "{} {wrap}: {steps:?} of {path:?}",
                        named.name
                    );
                });
            }
        }
    }
    assert!(hits > rays / 10, "{hits} of {rays} rays hit");
}

#[test]
fn hits_are_within_a_texel_of_the_exact_tracers() {
    let map = HeightMap::new(96, 96, maps::fractal(3, 96, 96, 0.55), Wrap::Repeat).expect("a valid map");
    let (mut rays, mut off) = (0, 0);
    each_ray(&map, metrics()[0], |path, steps| {
        let exact = brute::first_hit(&map, path, 1e-9);
        rays += 1;
        off += usize::from(match (steps, exact) {
            (Some(a), Some(b)) => (a - b).abs() > 1.0,
            (None, None) => false,
            _ => true,
        });
    });
    assert_eq!(off, 0, "of {rays} rays");
}

#[test]
fn a_hit_a_texel_off_is_noticed() {
    let map = maps::ALL[1].build(Wrap::Repeat);
    let (mut judged, mut noticed, mut lost) = (0, 0, 0);
    each_ray(&map, metrics()[0], |path, steps| {
        if let Some(steps) = steps.filter(|steps| *steps > 0.0) {
            judged += 1;
            noticed += usize::from(!brute::is_first_hit(&map, path, Some(steps + 1.0), 1e-5));
            lost += usize::from(!brute::is_first_hit(&map, path, None, 1e-5));
        }
    });
    assert!(judged > 1000 && noticed == judged && lost == judged, "{noticed}, {lost} of {judged}");
}

#[test]
fn nothing_depends_on_the_number_of_threads() {
    let map = maps::ALL[3].build(Wrap::Mirror);
    let bake_with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        let mut sink = Collected::default();
        pool.install(|| bake(&KIND, &map, metrics()[1], &KIND.defaults(), &Watch::none(), &mut sink))
            .expect("not cancelled");
        sink
    };
    let one = bake_with(1);
    assert_eq!(one, bake_with(2));
    assert_eq!(one, bake_with(3));
    let baked = &one.textures[0];
    assert_eq!(baked.texture.size, [101, 67, 64]);
    assert!(baked.levels[0].iter().flatten().all(|value| (0.0..=1.0).contains(value)));
}

#[test]
fn stored_coordinates_are_those_of_the_hit() {
    for wrap in Wrap::ALL {
        let map = maps::ALL[0].build(wrap);
        let mut settings = KIND.defaults();
        for (name, value) in [("azimuths", 10.0), ("elevations", 3.0), ("bits", 16.0)] {
            settings.set(name, value).expect("in range");
        }
        let mut sink = Collected::default();
        bake(&KIND, &map, metrics()[0], &settings, &Watch::none(), &mut sink).expect("not cancelled");
        let planes = &sink.textures[0].levels[0];
        let mut slice = 0;
        views(&map, metrics()[0], [10, 3], 4, &Watch::none(), &mut |view| {
            for texel in 0..map.texels().len() {
                let [u, v, hit] = [0, 1, 2].map(|k| f64::from(planes[k][slice * map.texels().len() + texel]));
                let seen = view.hit(texel as u32 % 37, texel as u32 / 37);
                assert_eq!(hit == 1.0, seen.is_some());
                if let Some([x, y]) = seen {
                    // The surface is the same at a wrapped place, to the rounding of 16 bits.
                    let (a, b) = (map.height_at(x, y), map.height_at(u, v));
                    let slack = 53.0 * 2.0 / 65535.0;
                    assert!((a - b).abs() < slack, "{wrap}: {x} {y} stored as {u} {v}: {a} {b}");
                }
            }
            slice += 1;
            Ok(())
        })
        .expect("not cancelled");
    }
}

#[test]
fn a_furnace_stays_as_bright_as_it_is() {
    for named in &maps::ALL[..6] {
        let map = named.build(Wrap::Repeat);
        let seen = Visibility::bake(&map, metrics()[1], [8, 4], 2, &Watch::none()).expect("enough memory");
        let (sky, texels) = (vec![1.0; 32], map.texels().len());
        let white = vec![1.0; texels];
        assert_eq!(seen.gather(&sky, &white).expect("the right sizes"), white, "{}", named.name);
        // Each bounce adds light, and never more than there is.
        let mut before = seen.bounce(&sky, &white, 0).expect("the right sizes");
        for bounces in [1, 2, 4, 8] {
            let after = seen.bounce(&sky, &white, bounces).expect("the right sizes");
            assert!(before.iter().zip(&after).all(|(a, b)| a <= b && *b <= 1.0), "{}", named.name);
            before = after;
        }
    }
}

#[test]
fn light_comes_from_where_it_is_seen() {
    let wall = |i, _| if i < 4 { 1.0 } else { 0.0 };
    let map = HeightMap::from_fn(32, 8, Wrap::Repeat, wall).expect("a valid map");
    let metric = Metric::unit_tile(0.2).expect("a valid metric");
    let seen = Visibility::bake(&map, metric, [4, 16], 2, &Watch::none()).expect("enough memory");
    let dark = [0.0; 64];
    let glow: Vec<f32> = map.texels().iter().map(|&height| if height > 0.5 { 1.0 } else { 0.0 }).collect();
    let lit = seen.gather(&dark, &glow).expect("the right sizes");
    assert!(
        lit[8] > lit[12] && lit[12] > lit[16] && lit[16] > 0.0,
        "nearer to the wall is brighter: {:?}",
        &lit[..32]
    );
    assert_eq!(lit[1], 0.0, "the wall's top sees nothing");
    let west = seen.directions().iter().position(|d| d[0] < -0.5).expect("a direction along -u");
    let hit = seen.seen(5, west).expect("the wall is in the way");
    assert!((3..5).contains(&hit), "texel {hit}");
    assert!(seen.gather(&dark[..3], &glow).is_none());
    assert!(seen.bounce(&dark, &[1.0], 1).is_none());
}
