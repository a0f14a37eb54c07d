//! Normal maps against slopes in `f64`, against surfaces whose normals are known, and their
//! filtered moments.

use std::f64::consts::TAU;

use relief_bake::kind::normal::{Axes, Derivative, KIND, normals};
use relief_bake::{BakeError, Collected, CollectedTexture, bake};
use relief_core::{HeightMap, Metric, Watch, Wrap};
use relief_testing::brute::normal as brute;
use relief_testing::maps;

fn metric(tile_m: [f64; 2], scale_m: f64) -> Metric {
    Metric::new(tile_m, scale_m).expect("positive lengths")
}

fn baked(map: &HeightMap, metric: Metric, set: &[(&str, f64)]) -> CollectedTexture {
    let mut settings = KIND.defaults();
    for &(name, value) in set {
        settings.set(name, value).expect("an accepted value");
    }
    let mut out = Collected::default();
    bake(&KIND, map, metric, &settings, &Watch::none(), &mut out).expect("nothing cancels it");
    out.textures.remove(0)
}

fn at(planes: &[Vec<f32>], texel: usize) -> [f64; 3] {
    [0, 1, 2].map(|channel| f64::from(planes[channel][texel]))
}

fn places(map: &HeightMap) -> impl Iterator<Item = (usize, [i64; 2])> {
    let width = map.width() as usize;
    (0..map.texels().len()).map(move |at| (at, [(at % width) as i64, (at / width) as i64]))
}

#[test]
fn normals_are_those_of_the_slopes() {
    for named in maps::ALL {
        for wrap in Wrap::ALL {
            let map = named.build(wrap);
            for metric in [metric([1.0, 1.0], 0.1), metric([3.0, 0.5], 0.4)] {
                let central = baked(&map, metric, &[("mips", 0.0)]);
                let patches = baked(&map, metric, &[("mips", 0.0), ("patches", 1.0)]);
                let mut flipped: f64 = 0.0;
                for (texel, place) in places(&map) {
                    let slopes = brute::patch_slopes(&map, metric.tile_m, metric.scale_m, place);
                    let expected = brute::normal(brute::mean(&slopes));
                    let off = brute::angle(at(&central.levels[0], texel), expected);
                    assert!(off < 4e-7, "{} {wrap} {place:?}: {off} rad", named.name);
                    let off = brute::angle(at(&patches.levels[0], texel), brute::mean_normal(&slopes));
                    let steepest =
                        slopes.as_flattened().iter().fold(0.0f64, |most, slope| most.max(slope.abs()));
                    assert!(
                        off < 4e-7 * (1.0 + steepest),
                        "{} {wrap} {place:?}, patches: {off} rad",
                        named.name
                    );
                    let [x, y, z] = at(&central.levels[0], texel);
                    flipped = flipped.max(brute::angle([x, -y, z], expected));
                }
                // The other sign of green would be noticed. (Central differences skip a
                // checkerboard.)
                let level = ["constant", "checkerboard"].iter().any(|name| named.name.contains(name))
                    || map.height() == 1;
                assert!(level || flipped > 1e-3, "{} {wrap}: green down was not noticed", named.name);
            }
        }
    }
}

#[test]
fn an_even_slope_has_one_normal_everywhere() {
    for [x, y] in [[1.0, 0.0], [0.0, -0.5], [0.7, 0.7], [-0.3, 0.9]] {
        for [width, height] in [[8u32, 5u32], [2, 2], [3, 9]] {
            let rise = |i, j| 0.5 + (x * f64::from(i) + y * f64::from(j)) / 64.0;
            let map = HeightMap::from_fn(width, height, Wrap::Clamp, |i, j| rise(i, j) as f32);
            let map = map.expect("a valid map");
            let metric = metric([width, height].map(f64::from), 64.0);
            let expected = brute::normal([x, y]);
            for patches in [0.0, 1.0] {
                let texture = baked(&map, metric, &[("patches", patches)]);
                for planes in &texture.levels {
                    for texel in 0..planes[0].len() {
                        let off = brute::angle(at(planes, texel), expected);
                        assert!(off < 1e-5, "{x} {y}, {width}x{height}, texel {texel}: {off} rad");
                    }
                }
            }
        }
    }
    // A mirrored map does turn at its edges.
    let map = HeightMap::from_fn(8, 8, Wrap::Mirror, |i, _| i as f32 / 64.0).expect("a valid map");
    let texture = baked(&map, metric([8.0; 2], 64.0), &[("mips", 0.0)]);
    let off = brute::angle(at(&texture.levels[0], 0), brute::normal([0.5, 0.0]));
    assert!(off < 1e-5, "half as steep: {off} rad");
}

#[test]
fn axes_follow_the_conventions() {
    // A hill in the middle: left of it the ground rises along +u, above it in the picture along +v.
    let map = HeightMap::from_fn(16, 16, Wrap::Repeat, |i, j| {
        let away = (f64::from(i) - 8.0).powi(2) + (f64::from(j) - 8.0).powi(2);
        (-away / 16.0).exp() as f32
    })
    .expect("a valid map");
    let metric = metric([1.0, 1.0], 0.3);
    let texture = |set: &[(&str, f64)]| baked(&map, metric, set).levels.remove(0);
    let (left, above) = (8 * 16 + 5, 5 * 16 + 8);
    let tangent = texture(&[]);
    assert!(at(&tangent, left)[0] < -0.3, "left of the hill the normal points left");
    assert!(at(&tangent, above)[1] > 0.3, "above the hill the normal points up in the picture");
    assert!(tangent[2].iter().all(|&z| z > 0.0));
    let down = texture(&[("green_down", 1.0)]);
    let world = texture(&[("world", 1.0)]);
    let frame = relief_core::TangentFrame {
        tangent: [metric.tile_m[0], 0.0, 0.0].into(),
        bitangent: [0.0, 0.0, metric.tile_m[1]].into(),
        normal: [0.0, 1.0, 0.0].into(),
    };
    for (texel, place) in places(&map) {
        let [x, y, z] = at(&tangent, texel);
        assert_eq!(at(&down, texel), [x, -y, z]);
        assert_eq!(at(&world, texel), [x, z, -y]);
        // The frame's eq. 9, from slopes in metres for a texture unit.
        let [u, v] = brute::mean(&brute::patch_slopes(&map, metric.tile_m, metric.scale_m, place));
        let expected = frame.mesostructure_normal([u * metric.tile_m[0], v * metric.tile_m[1]].into());
        assert!(brute::angle(at(&world, texel), expected.to_array()) < 4e-7);
    }
}

/// Waves on a tile: returns the height in `[0, 1]` and the slopes by texture unit at `(u, v)`.
fn waves(u: f64, v: f64) -> (f64, [f64; 2]) {
    let (a, b) = (TAU * u, TAU * 2.0 * v);
    (0.5 + 0.3 * a.sin() * b.cos(), [TAU * 0.3 * a.cos() * b.cos(), -TAU * 0.6 * a.sin() * b.sin()])
}

#[test]
fn the_angle_to_the_true_normal_falls_with_the_square_of_the_texel() {
    let metric = metric([1.0, 2.5], 0.4);
    let worst = |size: [u32; 2], derivative| {
        let uv = |i: u32, j: u32| {
            [(f64::from(i) + 0.5) / f64::from(size[0]), (f64::from(j) + 0.5) / f64::from(size[1])]
        };
        let map = HeightMap::from_fn(size[0], size[1], Wrap::Repeat, |i, j| {
            let [u, v] = uv(i, j);
            waves(u, v).0 as f32
        })
        .expect("a valid map");
        let (planes, _) =
            normals(&map, metric, derivative, Axes::Tangent, &Watch::none()).expect("nobody cancels");
        places(&map).fold(0.0f64, |worst, (texel, [i, j])| {
            let [u, v] = uv(i as u32, j as u32);
            let slope = waves(u, v).1;
            let slope = [0, 1].map(|axis| slope[axis] * metric.scale_m / metric.tile_m[axis]);
            worst.max(brute::angle(at(&planes, texel), brute::normal(slope)))
        })
    };
    for derivative in [Derivative::Central, Derivative::Patches] {
        let mut before = None;
        for side in [32u32, 64, 128, 256] {
            let size = [side, side + side / 2];
            let angle = worst(size, derivative);
            if derivative == Derivative::Central {
                let scale = metric.scale_m;
                let texel = [0, 1].map(|axis| metric.tile_m[axis] / f64::from(size[axis]));
                let third = [0.3 * TAU.powi(3), 0.3 * (2.0 * TAU).powi(3)];
                let taylor = [0, 1].map(|axis| {
                    texel[axis].powi(2) * third[axis] * scale / metric.tile_m[axis].powi(3) / 6.0
                });
                let rounding = 4e-7 + 1.2e-7 * scale * (1.0 / texel[0] + 1.0 / texel[1]);
                let bound = taylor[0].hypot(taylor[1]) + rounding;
                assert!(angle <= bound, "{size:?}: {angle} rad, more than {bound}");
                assert!(angle > 0.3 * bound, "{size:?}: {angle} rad, the bound of {bound} is not tight");
            }
            if let Some(before) = before {
                let order = f64::log2(before / angle);
                assert!((1.9..2.1).contains(&order), "{derivative:?} {size:?}: order {order}");
            }
            before = Some(angle);
        }
    }
}

#[test]
fn mip_levels_hold_mean_and_moments_of_what_they_cover() {
    for named in maps::ALL {
        for wrap in [Wrap::Repeat, Wrap::Clamp] {
            let map = named.build(wrap);
            let metric = metric([1.0, 0.7], 0.2);
            let texture = baked(&map, metric, &[]);
            let slopes: Vec<_> = places(&map)
                .map(|(_, place)| {
                    brute::mean(&brute::patch_slopes(&map, metric.tile_m, metric.scale_m, place))
                })
                .collect();
            let mut noticed = false;
            for (level, planes) in texture.levels.iter().enumerate() {
                let size = texture.texture.level_size(level).map(|side| side as usize);
                assert!(planes.iter().all(|plane| plane.len() == size[0] * size[1]));
                if level == 0 {
                    assert!(planes[3..].iter().flatten().all(|&moment| moment == 0.0));
                }
                let mut check = |column: usize, row: usize| {
                    let covered = covered(&map, level, [column, row]);
                    let mean = [0, 1].map(|axis| {
                        covered.iter().map(|&(texel, share)| share * slopes[texel][axis]).sum::<f64>()
                    });
                    let moment = |a: usize, b: usize| {
                        let product = |&(texel, share): &(usize, f64)| {
                            let slope: [f64; 2] = slopes[texel];
                            share * (slope[a] - mean[a]) * (slope[b] - mean[b])
                        };
                        covered.iter().map(product).sum::<f64>()
                    };
                    let texel = row * size[0] + column;
                    let off = brute::angle(at(planes, texel), brute::normal(mean));
                    assert!(off < 3e-6, "{} {wrap} level {level} ({column}, {row}): {off} rad", named.name);
                    let size = moment(0, 0) + moment(1, 1);
                    for (channel, moment) in [(3, moment(0, 0)), (4, moment(0, 1)), (5, moment(1, 1))] {
                        let stored = f64::from(planes[channel][texel]);
                        let raw = moment + mean[(channel - 3) / 2] * mean[(channel - 2) / 2];
                        noticed |= (stored - raw).abs() > 1e-3 * size;
                        assert!(
                            (stored - moment).abs() <= 2e-6 * size + 1e-12,
                            "{} {wrap} level {level} ({column}, {row}): {stored} for {moment}",
                            named.name
                        );
                    }
                };
                for (column, row) in [(0, 0), (size[0] / 2, size[1] / 3), (size[0] - 1, size[1] - 1)] {
                    check(column, row);
                }
            }
            // The comparison would notice moments that are not centred.
            assert!(noticed || !named.name.starts_with("natural"), "{} {wrap}", named.name);
            let last = texture.levels.last().expect("there is level 0");
            assert_eq!(last[0].len(), 1);
            if wrap == Wrap::Repeat && map.texels().len() > 1 {
                // Differences around a tile cancel.
                assert!(brute::angle(at(last, 0), [0.0, 0.0, 1.0]) < 1e-5, "{}", named.name);
            }
        }
    }
}

/// Returns the texels of level 0 that a texel of a level covers, and their shares: halved by area,
/// level by level.
fn covered(map: &HeightMap, level: usize, place: [usize; 2]) -> Vec<(usize, f64)> {
    let width = map.width() as usize;
    let along = |side: u32, place: usize| {
        let mut sides = vec![side as usize];
        for _ in 0..level {
            sides.push((sides[sides.len() - 1] / 2).max(1));
        }
        let mut shares = vec![(place, 1.0)];
        for pair in sides.windows(2).rev() {
            let (fine, coarse) = (pair[0] as f64, pair[1] as f64);
            let mut finer: Vec<(usize, f64)> = Vec::new();
            for (at, share) in shares {
                let [low, high] = [at as f64 * fine / coarse, (at + 1) as f64 * fine / coarse];
                for texel in low as usize..(high.ceil() as usize).min(pair[0]) {
                    let part = (high.min(texel as f64 + 1.0) - low.max(texel as f64)).max(0.0);
                    finer.push((texel, share * part / (high - low)));
                }
            }
            shares = finer;
        }
        shares
    };
    let (across, down) = (along(map.width(), place[0]), along(map.height(), place[1]));
    down.iter().flat_map(|&(j, b)| across.iter().map(move |&(i, a)| (j * width + i, a * b))).collect()
}

#[test]
fn fewer_bits_cost_no_more_than_the_stated_angle() {
    let map = maps::ALL[2].build(Wrap::Repeat);
    let metric = metric([1.0, 1.0], 0.2);
    let exact = baked(&map, metric, &[]);
    for (bits, degrees) in [(8.0, 0.39), (16.0, 0.0015)] {
        let stored = baked(&map, metric, &[("bits", bits)]);
        let steps = 2.0f64.powi(bits as i32) - 1.0;
        for (level, (stored_planes, planes)) in stored.levels.iter().zip(&exact.levels).enumerate() {
            for texel in 0..planes[0].len() {
                let off = brute::angle(at(stored_planes, texel), at(planes, texel)).to_degrees();
                assert!(off <= degrees, "{bits} bits: {off}° at level {level}, texel {texel}");
            }
            for (channel, (a, b)) in
                stored.texture.channels.iter().zip(stored_planes.iter().zip(planes)).skip(3)
            {
                let [low, high] = channel.range;
                let step = f64::from(high - low) / steps;
                for (a, b) in a.iter().zip(b) {
                    assert!((low..=high).contains(b), "{}: {b} is out of {low} to {high}", channel.name);
                    assert!(f64::from((a - b).abs()) <= 0.51 * step, "{}: {a} for {b}", channel.name);
                }
            }
        }
    }
}

#[test]
fn threads_do_not_change_a_bit_and_cancelling_ends_it() {
    let map = maps::ALL[0].build(Wrap::Mirror);
    let metric = metric([1.0, 1.0], 0.2);
    let pool = |threads| rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
    assert_eq!(pool(1).install(|| baked(&map, metric, &[])), pool(3).install(|| baked(&map, metric, &[])));
    let flag = std::sync::atomic::AtomicBool::new(true);
    let watch = Watch::cancelled_by(&flag);
    let ended = bake(&KIND, &map, metric, &KIND.defaults(), &watch, &mut Collected::default());
    assert!(matches!(ended, Err(BakeError::Cancelled(_))));
}
