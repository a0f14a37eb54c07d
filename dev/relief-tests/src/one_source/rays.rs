//! Adversarial rays, in the world and each with a base triangle of its own, as the shaders take them.

use glam::{DMat3, DQuat, DVec2, DVec3, Vec3};
use relief_core::rng::Rng;
use relief_core::{HeightMap, Path, SliceAxis};
use relief_shaders::cpu::{Corner, PixelIn, Shell};
use relief_testing::rays::{RayKind, Rays};

/// The kinds of paths that can be view rays; those that do not descend are left out one by one.
const KINDS: [RayKind; 7] = [
    RayKind::Random,
    RayKind::Tangent,
    RayKind::Vertices,
    RayKind::Edge,
    RayKind::Diagonal,
    RayKind::Grazing,
    RayKind::Vertical,
];

/// Rays that take adversarial paths through a map, from straight down to grazing, over frames of many sizes.
pub fn pixels(map: &HeightMap, count: usize, seed: u64) -> Vec<PixelIn> {
    let mut paths = Rays::new(map, seed);
    let mut rng = Rng::new(!seed);
    let mut pixels = Vec::with_capacity(count);
    let mut turn = 0;
    while pixels.len() < count {
        let path = paths.of_kind(KINDS[turn % KINDS.len()]);
        turn += 1;
        if path.h[1] < 0.0 {
            pixels.push(pixel(&mut rng, map, &path));
        }
    }
    pixels
}

/// The same rays over a base that is bent: each corner has a quadric of its own, all of one form, by which
/// the ray is bent from hardly at all to more than it takes to come out of the relief again.
pub fn bent_pixels(map: &HeightMap, count: usize, seed: u64) -> Vec<PixelIn> {
    let mut rng = Rng::new(seed ^ 0x5bd1);
    let mut pixels = pixels(map, count, seed);
    for pixel in &mut pixels {
        let of = |v: relief_shaders::cpu::Vec3<f32>| Vec3::new(v.x, v.y, v.z).as_dvec3();
        let [t, b, n] = [pixel.a.tangent, pixel.a.bitangent, pixel.a.normal].map(of);
        let along = of(pixel.direction).normalize();
        let offset = DMat3::from_cols(t, b, n).inverse() * along;
        let descent = n.dot(along).abs();
        let scale_m = if map.scale_m() > 0.0 { map.scale_m() } else { 0.1 };
        // At -1/4 a ray touches the floor.
        let amount = rng.pick(&[-0.25, 0.25, -1.0, 1.0, -0.2, 0.01, -0.01, 4.0]) * rng.between(0.5, 1.5);
        let form = [rng.between(-1.0, 1.0), rng.between(-1.0, 1.0), rng.between(-1.0, 1.0)];
        let terms = [offset.x.powi(2), offset.x * offset.y, offset.y.powi(2)];
        let terms = [0, 1, 2].map(|k| form[k] * terms[k]);
        let (value, all) = (terms.iter().sum::<f64>(), terms.iter().map(|term| term.abs()).sum::<f64>());
        // The terms may cancel, but not so far that nothing is left of the bits of `f32`.
        let factor = amount * descent.powi(2) / scale_m / value.abs().max(0.1 * all + 1e-9) * value.signum();
        for corner in [&mut pixel.a, &mut pixel.b, &mut pixel.c] {
            let own = factor * rng.between(0.8, 1.2) * f64::from(pixel.side);
            corner.of_surface = form.map(|number| (number * own).clamp(-1e6, 1e6) as f32).into();
        }
    }
    pixels
}

/// Rays at triangles that are slices through the relief. The slices lie aslant in it, and differ along each
/// of the axes in turn.
pub fn sliced_pixels(map: &HeightMap, count: usize, seed: u64) -> Vec<PixelIn> {
    let mut rng = Rng::new(seed ^ 0x51ce);
    let mut pixels = pixels(map, count, seed);
    for pixel in &mut pixels {
        let (step, axis) = (rng.between(0.001, 0.3) as f32, rng.below(SliceAxis::ALL.len() as u32) as f32);
        for corner in [&mut pixel.a, &mut pixel.b, &mut pixel.c] {
            corner.of_surface = [rng.between(-0.1, 1.1) as f32, step, axis].into();
        }
    }
    pixels
}

/// A ray that takes a straight, descending path through the relief on some triangle.
fn pixel(rng: &mut Rng, map: &HeightMap, path: &Path) -> PixelIn {
    let frame = frame(rng);
    // A relief without height is level; its rays are as steep as on one of 10 cm.
    let scale_m = if map.scale_m() > 0.0 { map.scale_m() } else { 0.1 };
    let base = (-map.bias_m() / scale_m - path.h[0]) / path.h[1];
    let uv = DVec2::from(path.uv) + DVec2::from(path.duv) * base;
    let point = DVec3::new(rng.between(-3.0, 3.0), rng.between(-3.0, 3.0), rng.between(-3.0, 3.0));
    let along = frame * DVec3::new(path.duv[0], path.duv[1], path.h[1] * scale_m);
    // Before the entry as a rule, now and then inside of the relief, in paths' lengths.
    let before = rng.pick(&[0.0, 0.01, 0.5, 1.0, 1.0, 10.0, 100.0, -0.3]) * path.exit;
    let origin = point - along * (base + before);
    let direction = along * rng.between(-6.0, 6.0).exp2();
    let side = rng.pick(&[1.0, 1.0, 1.0, -1.0]);
    let size = rng.pick(&[0.01, 1.0, 1.0, 9.0]);
    let corner = |u: f64, v: f64| {
        let aside = DVec2::new(u, v) * size;
        let position = point + frame * aside.extend(0.0);
        let [position, normal] = [position, frame.z_axis * side].map(|v| v.as_vec3().to_array());
        let [tangent, bitangent] = [frame.x_axis, frame.y_axis].map(|v| v.as_vec3().to_array());
        Corner::new(position, normal, tangent, bitangent, (uv + aside).as_vec2().to_array(), [0.0; 3])
    };
    let [origin, direction] = [origin, direction].map(|v| v.as_vec3().to_array());
    let turned = rng.unit();
    let (a, b, c) = (corner(-0.3, -0.2 - turned), corner(0.9, turned), corner(-0.1, 0.8));
    PixelIn::new(origin, direction, side as f32, a, b, c, Shell::whole())
}

/// Tangent, bitangent (as long as one tile) and unit normal.
fn frame(rng: &mut Rng) -> DMat3 {
    let plane = DMat3::from_cols(DVec3::X, DVec3::Z, DVec3::Y);
    if rng.below(4) == 0 {
        return plane;
    }
    let axis = DVec3::new(rng.between(-1.0, 1.0), rng.between(-1.0, 1.0), 0.5).normalize();
    let turn = DMat3::from_quat(DQuat::from_axis_angle(axis, rng.between(0.0, 6.0)));
    let [u, v] = [rng.between(-5.0, 5.0), rng.between(-5.0, 5.0)].map(f64::exp2);
    let shear = if rng.below(2) == 0 { 0.0 } else { rng.between(-0.7, 0.7) };
    let skewed = DMat3::from_cols(DVec3::X * u, DVec3::new(shear, 1.0, 0.0) * v, DVec3::Z);
    turn * skewed
}
