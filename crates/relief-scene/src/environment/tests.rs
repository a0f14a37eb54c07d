use glam::DVec3;
use relief_core::MapTexels;

use super::*;

/// A picture of what is seen in each direction.
fn picture(width: u32, seen: impl Fn(DVec3) -> [f32; 3]) -> Picture {
    let sphere_row = |row: u32| (f64::from(row) + 0.5) / f64::from(width / 2) * std::f64::consts::PI;
    let texels = (0..width / 2).flat_map(|row| {
        let (flat, up) = sphere_row(row).sin_cos();
        let texel = |column: u32| {
            let angle = ((f64::from(column) + 0.5) / f64::from(width) - 0.5) * std::f64::consts::TAU;
            let [red, green, blue] = seen(DVec3::new(angle.sin() * flat, up, -angle.cos() * flat));
            [red, green, blue, 1.0]
        };
        (0..width).map(texel).collect::<Vec<_>>()
    });
    Picture { width, height: width / 2, texels: texels.collect() }
}

/// All texels, with their level, their side and their direction.
fn texels(environment: &Environment) -> Vec<(u32, u32, DVec3, [f32; 3])> {
    let layout = environment.map.layout();
    let MapTexels::F32(values) = environment.map.texels() else { panic!("the values are floats") };
    let mut values = values.as_chunks::<4>().0.iter();
    let mut all = Vec::new();
    for level in 0..layout.levels {
        let side = layout.level_size(level)[0];
        let directions = cube::faces(side, |toward| toward.as_vec3().to_array());
        for ([x, y, z, _], &[red, green, blue, _]) in directions.into_iter().zip(&mut values) {
            all.push((level, side, DVec3::new(x.into(), y.into(), z.into()), [red, green, blue]));
        }
    }
    assert_eq!(values.len(), 0);
    all
}

#[test]
fn uniform_surroundings_are_so_in_all_lobes() {
    for width in [2, 30, 64, 130, 512] {
        let picture = picture(width, |_| [1.0, 0.5, 2.0]);
        let environment = Environment::from_equirectangular(&picture).expect("surroundings");
        for (level, side, toward, light) in texels(&environment) {
            let worst = light.iter().zip([1.0, 0.5, 2.0]).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
            assert!(worst < 1e-6, "{width}, level {level} of {side}, {toward}: {light:?}");
        }
    }
}

#[test]
fn light_comes_from_where_the_picture_shows_it() {
    // Light that grows along an axis stays so within a lobe, and is as much less as the lobe's mean cosine.
    let seen = |toward: DVec3| [toward.x, toward.y, toward.z].map(|part| (1.0 + part) as f32);
    for width in [64, 400] {
        let environment = Environment::from_equirectangular(&picture(width, seen)).expect("surroundings");
        for (level, side, toward, light) in texels(&environment) {
            let mean = if level == 0 { 1.0 } else { 1.0 - lobes::reach(side) / 3.0 };
            for (light, part) in light.into_iter().zip(toward.to_array()) {
                let right = 1.0 + mean * part;
                assert!((f64::from(light) - right).abs() < 0.01, "{level}, {toward}: {light} for {right}");
            }
        }
    }
}

#[test]
fn a_small_light_keeps_its_power_in_every_lobe() {
    // One texel, off the middle of everything.
    let width = 256u32;
    let [column, row] = [37u32, 51];
    let lit = |at: u32| if at == row * width + column { [1000.0, 0.0, 0.0, 1.0] } else { [0.0; 4] };
    let picture = Picture { width, height: width / 2, texels: (0..width * width / 2).map(lit).collect() };
    let environment = Environment::from_equirectangular(&picture).expect("surroundings");
    let [above, below] = [row, row + 1].map(|edge| f64::from(edge) / 128.0 * std::f64::consts::PI);
    let power = 1000.0 * (above.cos() - below.cos()) / 2.0 / f64::from(width);
    let layout = *environment.map.layout();
    let all = texels(&environment);
    for level in 1..layout.levels {
        // Over the sphere: each texel for the part that it covers, those at edges by half.
        let (mut sum, mut parts) = (0.0, 0.0);
        for (_, side, toward, light) in all.iter().filter(|(of, ..)| *of == level) {
            let size = toward.abs();
            let largest = size.max_element();
            let on_edges = [size.x, size.y, size.z].iter().filter(|part| largest - **part < 1e-6).count();
            let part = largest.powi(3) / on_edges as f64 / f64::from(side - 1).powi(2);
            sum += part * f64::from(light[0]);
            parts += part;
        }
        let ratio = sum / parts / power;
        assert!((ratio - 1.0).abs() < 0.03, "level {level}: {ratio}");
    }
}

#[test]
fn faces_that_meet_have_the_same_texels_there() {
    let environment = Environment::from_equirectangular(&picture(130, |toward| {
        [(9.0 * toward.x).sin().abs(), (7.0 * toward.y).cos().abs(), toward.z.abs()].map(|part| part as f32)
    }));
    let all = texels(&environment.expect("surroundings"));
    let mut met = 0;
    for (place, (level, _, toward, light)) in all.iter().enumerate() {
        for (of, _, other, same) in &all[place + 1..] {
            if of == level && toward == other {
                assert_eq!(light, same, "level {level}, {toward}");
                met += 1;
            }
        }
    }
    // Twelve edges, and at each corner a third texel.
    assert!(met >= 12 * (32 - 2) + 8 * 3, "{met}");
}

#[test]
fn what_shows_no_surroundings_is_refused() {
    let of = |width: u32, height: u32, texels: usize| {
        Environment::from_equirectangular(&Picture { width, height, texels: vec![[0.5; 4]; texels] })
    };
    for (width, height) in [(1, 1), (0, 0), (3, 2), (64, 64), (64, 33)] {
        let texels = width as usize * height as usize;
        assert_eq!(of(width, height, texels), Err(EnvironmentError::Proportions { width, height }));
    }
    assert_eq!(of(4, 2, 7), Err(EnvironmentError::Length { width: 4, height: 2, given: 7 }));
    assert!(of(2, 1, 2).is_ok());
    for bad in [f32::NAN, f32::INFINITY] {
        let mut picture = picture(64, |_| [1.0; 3]);
        picture.texels[64 * 3 + 5][1] = bad;
        let error = Environment::from_equirectangular(&picture);
        assert_eq!(error, Err(EnvironmentError::NotFinite { column: 5, row: 3 }));
    }
    // Colours below 0, which filters of other programs leave, count as none.
    let below = Environment::from_equirectangular(&picture(64, |_| [-1.0, 0.0, 1.0])).expect("surroundings");
    assert!(texels(&below).iter().all(|(.., [red, _, blue])| *red == 0.0 && (*blue - 1.0).abs() < 1e-6));
}
