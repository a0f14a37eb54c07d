//! Rays through the shells of triangles: slivers, twisted and nearly folded ones among them.

use glam::{DVec2, DVec3};
use relief_core::{HeightMap, MapFormat, Wrap};
use relief_shaders::cpu::{Corner, PixelIn, Shell};
use relief_shaders::wgsl::Sampling;
use relief_shaders::{Entry, Selection, detail, refine, search, shadow};

use super::adapter;
use super::cases::{Draw, LEAST_SHELL_M};
use super::compare::Comparison;
use relief_core::rng::Rng;
use relief_testing::maps;

/// Rays for a surface.
const RAYS: usize = 1_000_000;

/// Pairs of a search and a refinement that go with every surface; programs take time to compile.
const PAIRS: [[&str; 2]; 5] =
    [["cells", "patch"], ["pyramid", "patch"], ["cone", "patch"], ["linear", "binary"], ["frustum", "patch"]];

/// Rays through shells as thick as the relief of a map.
pub fn pixels(map: &HeightMap, count: usize, seed: u64) -> Vec<PixelIn> {
    let mut rng = Rng::new(seed);
    (0..count).map(|_| pixel(&mut rng, map)).collect()
}

/// A vector of that length at most along each axis.
fn within(rng: &mut Rng, most: f64) -> DVec3 {
    DVec3::new(rng.between(-most, most), rng.between(-most, most), rng.between(-most, most))
}

/// A ray through a point of the shell of some triangle.
fn pixel(rng: &mut Rng, map: &HeightMap) -> PixelIn {
    let thick = map.scale_m().max(LEAST_SHELL_M.into());
    // From triangles that are much wider than their shell to shells that are as high as twenty triangles.
    let size = thick * rng.pick(&[30.0, 5.0, 1.0, 1.0, 0.3, 0.05]);
    let centre = within(rng, 3.0);
    let thin = rng.pick(&[1.0, 1.0, 1.0, 0.01]);
    let (x, z) = loop {
        let (x, z) = (within(rng, 1.0), within(rng, 1.0));
        if let (Some(x), Some(z)) = (x.try_normalize(), x.cross(z).try_normalize()) {
            break (x, z);
        }
    };
    let y = z.cross(x);
    let flat = [DVec2::new(-0.6, -0.4), DVec2::new(0.7, -0.3), DVec2::new(0.1, 0.8 * thin)];
    let places = flat.map(|at| centre + (x * at.x + y * at.y) * size);
    // Twisted as far as normals can be before most shells fold.
    let twist = rng.pick(&[0.0, 0.05, 0.3, 0.7]) * (size / thick).min(1.0);
    let normals = flat.map(|_| (z + within(rng, twist)).normalize());
    let tile = size * rng.pick(&[0.3, 1.0, 4.0, 20.0]);
    let tangents = flat.map(|_| x * tile + within(rng, 0.1 * tile));
    let bitangents = flat.map(|_| y * tile + within(rng, 0.1 * tile));
    let origin_uv = DVec2::new(rng.between(-2.0, 2.0), rng.between(-2.0, 2.0));
    let corners: [Corner; 3] = std::array::from_fn(|at| {
        let uv = if map.wrap() == Wrap::Clamp {
            flat[at] * 0.5 + 0.5
        } else {
            origin_uv + flat[at] * (size / tile)
        };
        let [position, normal] = [places[at], normals[at]].map(|v| v.as_vec3().to_array());
        let [tangent, bitangent] = [tangents[at], bitangents[at]].map(|v| v.as_vec3().to_array());
        Corner::new(position, normal, tangent, bitangent, uv.as_vec2().to_array(), [0.0; 3])
    });

    // To a point of the shell, or to one of its edges or corners.
    let mut weights = [rng.unit(), rng.unit(), rng.unit()];
    for weight in &mut weights {
        if rng.below(8) == 0 {
            *weight = 0.0;
        }
    }
    let sum = weights.iter().sum::<f64>().max(1e-9);
    let between = rng.unit();
    let offset = map.bias_m() + map.scale_m() * rng.pick(&[0.0, 1.0, between, between]);
    let inside: DVec3 = (0..3).map(|at| (places[at] + normals[at] * offset) * (weights[at] / sum)).sum();
    // From above, from all around, and along the shell.
    let from = match rng.below(4) {
        0 => z + within(rng, 0.5),
        1 => within(rng, 1.0),
        2 => x + within(rng, 0.05),
        _ => places[1] - places[0] + z * (0.02 * size),
    };
    let from = from.try_normalize().unwrap_or(z);
    let far = (size + thick) * rng.pick(&[0.1, 2.0, 2.0, 10.0]);
    let direction = -from * rng.between(-3.0, 3.0).exp2();
    let [origin, direction] = [inside + from * far, direction].map(|v| v.as_vec3().to_array());
    let numbers = [0, 1, 2].map(|_| rng.below(1000));
    let lift = [0, 1, 2].map(|_| (rng.between(-0.1, 0.1) * thick) as f32);
    let shell = Shell::between([0.0, 1.0], Shell::places_of(numbers), lift);
    let shell = if rng.below(10) == 0 { shell.folded() } else { shell };
    let side = rng.pick(&[1.0, 1.0, -1.0]);
    let [a, b, c] = corners;
    PixelIn::new(origin, direction, side, a, b, c, shell)
}

/// Compares the backends on a surface of shells. Nothing where there is no adapter.
///
/// # Panics
///
/// When the stages have other bits, or an adapter is required and missing.
pub fn compare_surface(surface: &Entry) {
    let Some(mut prober) = adapter::own_prober() else { return };
    let mut rng = Rng::new(11);
    let rays_a_case = RAYS.div_ceil(PAIRS.len() * maps::ALL.len());
    let (mut all, mut hits, mut cases) = (Comparison::default(), 0, 0);
    for (number, names) in PAIRS.iter().enumerate() {
        let find = |entries: &'static [Entry], name: &str| {
            entries.iter().find(|entry| entry.name == name).expect("a listed name")
        };
        let pair = [find(search::ENTRIES, names[0]), find(refine::ENTRIES, names[1])];
        let shadow = [find(shadow::ENTRIES, "none"), pair[0]];
        let mut selection = Selection::pair(names[0], names[1]).expect("listed names");
        selection.choose("surface", surface.name).expect("a listed name");
        selection.check().expect("a legal pair");
        for (m, map) in maps::ALL.iter().enumerate() {
            let draw = Draw::on(surface, pair, shadow, &detail::ENTRIES[0], &mut rng);
            let wrap = Wrap::ALL[(number + m) % Wrap::ALL.len()];
            let case = draw.over(map, wrap, MapFormat::F32);
            let rays = pixels(&case.map, rays_a_case, draw.seed);
            let cpu = case.on_cpu(&rays);
            let gpu = prober.probe(case.surface(), Sampling::Exact, &rays).expect("the probe runs");
            hits += cpu.iter().filter(|probe| probe.found == 1).count();
            all = all.plus(Comparison::new(&case, &rays, &cpu, &gpu));
            cases += 1;
        }
    }
    println!(
        "{}: {} rays, {hits} hits, {} differ, {} unexplained",
        surface.name, all.rays, all.different, all.unexplained
    );
    assert_eq!(all.rays, cases * rays_a_case);
    assert!(hits > all.rays / 4, "{hits} hits");
    all.check().expect("the same bits");
}
