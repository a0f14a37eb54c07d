//! Rays over quadrics: their paths beside the same in `f64`, what searches find on them, and the backends'
//! bits.

use glam::{DMat3, DVec2, DVec3, Vec3};
use relief_core::registry::RayClass;
use relief_core::rng::Rng;
use relief_core::{HeightMap, Path, Wrap};
use relief_shaders::cpu::{Corner, PixelIn, Probe};
use relief_shaders::field::Solids;
use relief_shaders::wgsl::Sampling;
use relief_shaders::{Selection, refine, search};
use relief_testing::maps;
use relief_tests::one_source::cases::Case;
use relief_tests::one_source::compare::Comparison;
use relief_tests::one_source::{adapter, rays};
use relief_tests::pairs;

/// Rays a map and a displacement. All times scale with it.
const RAYS: usize = 3_000;

/// Scale and bias: carved, carved below the base, and outward, for which the base is moved.
const DISPLACEMENTS: [[f64; 2]; 4] = [[1.0, -1.0], [0.3, -0.39], [0.02, -0.02], [0.3, 0.1]];

fn map(wrap: Wrap, [scale_m, bias_m]: [f64; 2]) -> HeightMap {
    let named = maps::ALL.iter().find(|map| map.name == "natural 101x67").expect("a listed map");
    named.build(wrap).with_displacement(scale_m, bias_m).expect("proper numbers")
}

fn of(v: relief_shaders::cpu::Vec3<f32>) -> DVec3 {
    Vec3::new(v.x, v.y, v.z).as_dvec3()
}

/// A ray over a quadric, by the definition.
struct Bent {
    /// Metres from the eye to the base point.
    distance: f64,
    /// What a metre of the ray changes: the texture coordinates, and the height along the normal.
    rate: DVec3,
    /// The inverse of the frame: from the world to texture coordinates and heights.
    to_frame: DMat3,
    along: DVec3,
    normal: DVec3,
    quadric: [f64; 3],
    scale_m: f64,
    /// The height of the base point.
    begin: f64,
    /// How narrow the triangle is: rounding turns its plane by as many times as much.
    narrow: f64,
}

impl Bent {
    fn new(pixel: &PixelIn, map: &HeightMap, turned: f64) -> Self {
        let corners = [&pixel.a, &pixel.b, &pixel.c];
        let [a, b, c] = corners.map(|corner| of(corner.position));
        let along = of(pixel.direction).normalize();
        let face = (b - a).cross(c - a);
        let distance = face.dot(a - of(pixel.origin)) / face.dot(along);
        let point = of(pixel.origin) + along * distance;
        let weight =
            |from: DVec3, to: DVec3| (to - from).cross(point - from).dot(face) / face.length_squared();
        let weights = [weight(b, c), weight(c, a), weight(a, b)];
        let side = f64::from(pixel.side);
        let quadric = [0, 1, 2].map(|place| {
            let number = |corner: &Corner| of(corner.of_surface)[place];
            corners.iter().zip(weights).map(|(corner, weight)| number(corner) * weight).sum::<f64>() * side
        });
        let normal = of(pixel.a.normal).normalize() * side;
        let to_frame = DMat3::from_cols(of(pixel.a.tangent), of(pixel.a.bitangent), normal).inverse();
        let base = -map.bias_m() / map.scale_m();
        let moved = if side > 0.0 { 1.0 } else { 2.0 * base - 1.0 };
        Self {
            distance,
            rate: to_frame * along,
            to_frame,
            along,
            normal,
            quadric: quadric.map(|number| number * turned),
            scale_m: map.scale_m(),
            begin: if base < 1.0 { moved } else { base },
            narrow: (b - a).length() * (c - a).length() / face.length(),
        }
    }

    /// The quadric's height at an offset in texture coordinates.
    fn quadric(&self, at: DVec2) -> f64 {
        let [a, b, c] = self.quadric;
        a * at.x * at.x + b * at.x * at.y + c * at.y * at.y
    }

    /// The height in the relief, by the distance along the normal, that many metres behind the base point.
    fn height(&self, t: f64) -> f64 {
        let at = self.rate * t;
        self.begin + (at.z - self.quadric(at.truncate())) / self.scale_m
    }
}

/// The same ray, with others whose numbers differ by two roundings of `f32`: how far these are from it is
/// what arithmetic in `f32` may make of it.
struct Blurred {
    bent: Bent,
    beside: Vec<Bent>,
}

impl Blurred {
    fn new(pixel: &PixelIn, map: &HeightMap, rng: &mut Rng) -> Self {
        let mut moved = |v: &mut relief_shaders::cpu::Vec3<f32>| {
            let size = of(*v).length() as f32;
            for number in [&mut v.x, &mut v.y, &mut v.z] {
                *number += size * f32::EPSILON * rng.between(-2.0, 2.0) as f32;
            }
        };
        let beside = (0..8).map(|_| {
            let mut pixel = *pixel;
            moved(&mut pixel.origin);
            moved(&mut pixel.direction);
            for corner in [&mut pixel.a, &mut pixel.b, &mut pixel.c] {
                let Corner { position, normal, tangent, bitangent, .. } = corner;
                for vector in [position, normal, tangent, bitangent] {
                    moved(vector);
                }
            }
            Bent::new(&pixel, map, 1.0)
        });
        Self { beside: beside.collect(), bent: Bent::new(pixel, map, 1.0) }
    }

    /// By how much a height may be off that has been computed in `f32`, with texels this steep.
    fn slack(&self, ts: [f64; 2], slope: f64) -> f64 {
        let at = |t: f64| {
            let off = |other: &Bent| {
                let same = t + self.bent.distance - other.distance;
                let aside = (self.bent.rate * t - other.rate * same).truncate().length();
                (self.bent.height(t) - other.height(same)).abs() + slope * aside
            };
            self.beside.iter().map(off).fold(0.0, f64::max)
        };
        3e-5 + 8.0 * (1.0 + self.bent.narrow) * at(ts[0]).max(at(ts[1]))
    }
}

#[test]
fn paths_are_those_of_the_definition() {
    let mut rng = Rng::new(17);
    let [mut paths, mut silhouettes, mut none, mut noticed, mut blurred] = [0; 5];
    for displacement in DISPLACEMENTS {
        let case = Case::on("quadric-vertical", "cells", "patch", map(Wrap::Repeat, displacement));
        let program = case.program();
        for pixel in rays::bent_pixels(&case.map, RAYS, 3) {
            let blurred_ray = Blurred::new(&pixel, &case.map, &mut rng);
            let bent = &blurred_ray.bent;
            let at = program.enter(pixel);
            let path = program.segment(pixel, at, 0);
            let long = bent.scale_m / bent.rate.z.abs();
            if at.segments == 0 || path.exit <= 0.0 {
                // The ray never comes down into the relief in front of the eye.
                none += 1;
                if bent.begin >= 1.0 && bent.distance >= 0.0 {
                    let mut heights = (0..2000).map(|k| bent.height(long * 0.002 * f64::from(k)));
                    assert!(!heights.any(|h| h < 1.0 - 1e-3 && h > 0.0), "{pixel:?}");
                }
                continue;
            }
            paths += 1;
            let core = Path::from(&path);
            let start = f64::from(path.start) - bent.distance;
            let numbers = [core.uv[0], core.duv[0], core.h[0], core.h[1], core.h[2], core.exit];
            assert!(numbers.iter().all(|number| number.is_finite()), "{path:?}");
            let slack = blurred_ray.slack([start, start + core.exit], 0.0);
            blurred += usize::from(slack > 1e-2);
            if slack > 1e-2 {
                continue;
            }
            let height = |part: f64| core.at(core.exit * part)[2];
            for k in 0..=32 {
                let part = f64::from(k) / 32.0;
                let expected = bent.height(start + core.exit * part);
                assert!((height(part) - expected).abs() <= slack, "{part} {expected} {slack} {path:?}");
                assert!(height(part) < 1.0 + slack, "{path:?}");
                assert!(k == 32 || height(part) > -slack, "{path:?}");
                let wrong = Bent::new(&pixel, &case.map, -1.0).height(start + core.exit * part);
                noticed += usize::from(k == 32 && (wrong - expected).abs() > 10.0 * slack);
            }
            assert!((height(0.0) - 1.0).abs() < slack || (bent.distance + start).abs() < 1e-3 * long);
            let end = height(1.0);
            assert!(end < 0.0 || (end - 1.0).abs() < slack, "{end} {path:?}");
            silhouettes += usize::from(end > 0.5);
        }
    }
    println!(
        "{paths} paths, {blurred} of them blurred, {silhouettes} silhouettes, \
            {none} without a path, {noticed} notice a sign"
    );
    assert!(paths > 2 * RAYS && silhouettes > RAYS / 4 && noticed > paths / 2);
}

/// Szirmay-Kalos and Umenhoffer 2008, section 6.3, takes the curvature along a view by Euler's formula, of
/// the two principal curvatures and the angle between.
#[test]
fn paths_bend_by_eulers_formula() {
    let case = Case::on("quadric-vertical", "cells", "patch", map(Wrap::Repeat, DISPLACEMENTS[0]));
    let program = case.program();
    let mut rng = Rng::new(19);
    let [mut paths, mut sharp, mut noticed] = [0; 3];
    for pixel in rays::bent_pixels(&case.map, RAYS, 3) {
        let path = program.segment(pixel, program.enter(pixel), 0);
        if path.exit <= 0.0 {
            continue;
        }
        let Blurred { bent, beside } = Blurred::new(&pixel, &case.map, &mut rng);
        // The base is the quadric's height below the tangent plane: twice the quadric of a unit vector is the
        // curvature along it.
        let tangent = of(pixel.a.tangent).normalize();
        let across = bent.normal.cross(tangent).normalize();
        let along = |way: DVec3| 2.0 * bent.quadric((bent.to_frame * way).truncate());
        let both = 0.5 * (along(tangent + across) - along(tangent) - along(across));
        let (mean, half) = (0.5 * (along(tangent) + along(across)), 0.5 * (along(tangent) - along(across)));
        let [most, least] = [mean + half.hypot(both), mean - half.hypot(both)];
        let view = bent.along - bent.normal * bent.along.dot(bent.normal);
        let angle = view.dot(across).atan2(view.dot(tangent)) - 0.5 * both.atan2(half);
        let euler = |most: f64, least: f64| most * angle.cos().powi(2) + least * angle.sin().powi(2);
        let bend = |curvature: f64| -0.5 * curvature * view.length_squared() / bent.scale_m;
        let expected = bend(euler(most, least));
        let defined = |bent: &Bent| -bent.quadric(bent.rate.truncate()) / bent.scale_m;
        let greatest = bend(most).abs().max(bend(least).abs());
        assert!((expected - defined(&bent)).abs() <= 1e-6 * greatest, "{expected} {pixel:?}");
        // What arithmetic in `f32` may make of it.
        let spread = beside.iter().map(|other| (defined(other) - defined(&bent)).abs()).fold(0.0, f64::max);
        let slack = 1e-5 * greatest + 8.0 * (1.0 + bent.narrow) * spread;
        let found = Path::from(&path).h[2];
        assert!((found - expected).abs() <= slack, "{found} {expected} {slack} {path:?}");
        paths += 1;
        if slack < 1e-2 * greatest {
            sharp += 1;
            noticed += usize::from((found - bend(euler(least, most))).abs() > 10.0 * slack);
        }
    }
    println!("{paths} paths, {sharp} of them sharp, {noticed} notice that the curvatures are exchanged");
    assert!(paths > RAYS / 2 && sharp > paths / 2 && noticed > sharp / 2, "{paths} {sharp} {noticed}");
}

/// Heights a tile by which the map changes at most: texels differ by up to a fifth of the relief.
const STEEP: f64 = 20.0;

/// Whether what was found is the first crossing by a march along the definition, from that many metres behind
/// the base point on: on the surface to the slack in heights, and not behind where the march is in it.
fn is_first(bent: &Bent, map: &HeightMap, path: &Path, [from, slack]: [f64; 2], hit: Option<f64>) -> bool {
    const STEPS: u32 = 4000;
    let gap = |t: f64| {
        let uv = DVec2::from(path.uv) + bent.rate.truncate() * (t - from);
        bent.height(t) - map.height_at(uv.x, uv.y)
    };
    let at = |k: u32| from + path.exit * f64::from(k) / f64::from(STEPS);
    let first = (0..=STEPS).map(at).find(|t| gap(*t) < -slack);
    match (hit, first) {
        (None, None) => true,
        (None, Some(_)) => false,
        // On the surface, and not behind where the march is in it.
        (Some(t), first) => gap(t).abs() < slack && first.is_none_or(|first| t <= first + 1e-6 * path.exit),
    }
}

#[test]
fn exact_pairs_find_what_a_march_finds() {
    let mut rng = Rng::new(17);
    let mut judged = 0;
    for selection in pairs::exact_for(RayClass::Bent) {
        let (search, refine) = (selection.search().name, selection.refine().name);
        let count = if (search, refine) == ("cells", "patch") { RAYS / 2 } else { RAYS / 10 };
        let case = Case::on("quadric-vertical", search, refine, map(Wrap::Repeat, DISPLACEMENTS[1]));
        let program = case.program();
        let (mut hits, mut misses, mut wrong, mut noticed) = (0, 0, 0, 0);
        for pixel in rays::bent_pixels(&case.map, count, 5) {
            let ray = Blurred::new(&pixel, &case.map, &mut rng);
            let path = program.segment(pixel, program.enter(pixel), 0);
            let core = Path::from(&path);
            let from = f64::from(path.start) - ray.bent.distance;
            // A march needs more than is left of the bits of f32 where they are few, and to begin outside.
            let is_outside = core.clearance(&case.map, 0.0) > -1e-4;
            let slack = ray.slack([from, from + core.exit], STEEP);
            if !(path.exit > 0.0 && is_outside) || slack > 5e-3 {
                continue;
            }
            let hit = program.trace(path);
            let found = (hit.found == 1).then(|| from + f64::from(hit.t));
            hits += usize::from(found.is_some());
            misses += usize::from(found.is_none());
            wrong += usize::from(!is_first(&ray.bent, &case.map, &core, [from, slack], found));
            let turned = Bent::new(&pixel, &case.map, -1.0);
            noticed += usize::from(!is_first(&turned, &case.map, &core, [from, slack], found));
        }
        println!("{search} {refine}: {hits} hits, {misses} misses, {wrong} wrong, {noticed} notice a sign");
        assert!(noticed * 5 > hits, "{search} {refine}: a turned quadric is not noticed");
        assert!(hits > count / 3 && misses > count / 50, "{search} {refine}");
        assert!(wrong * 200 <= hits + misses, "{search} {refine}: {wrong} wrong");
        judged += 1;
    }
    assert!(judged >= 5, "{judged} pairs");
}

#[test]
fn distances_across_the_view_are_those_of_the_definition() {
    let mut rng = Rng::new(17);
    let (mut across, mut along) = (0, 0);
    for displacement in DISPLACEMENTS {
        let case = Case::on("quadric-perpendicular", "linear", "binary", map(Wrap::Repeat, displacement));
        let program = case.program();
        for pixel in rays::bent_pixels(&case.map, RAYS / 4, 7) {
            let blurred_ray = Blurred::new(&pixel, &case.map, &mut rng);
            let bent = &blurred_ray.bent;
            let sine = (bent.normal - bent.along * bent.normal.dot(bent.along)).length();
            let at = program.enter(pixel);
            // Near the normal the line across the view is not defined.
            if sine < 0.05 || blurred_ray.slack([at.span.x.into(), at.span.y.into()], 0.0) > 1e-3 {
                continue;
            }
            let up = (bent.normal - bent.along * bent.normal.dot(bent.along)) / sine;
            let up = bent.to_frame * up;
            for number in 0..at.segments {
                let path = program.segment(pixel, at, number);
                let core = Path::from(&path);
                assert!(core.exit >= 0.0 && core.h.iter().all(|number| number.is_finite()), "{path:?}");
                // The last chord ends on the floor.
                let parts: &[f64] = if number + 1 < at.segments { &[0.0, 0.5, 1.0] } else { &[0.0] };
                for part in parts {
                    let t = f64::from(path.start) - bent.distance + core.exit * part;
                    let depth = (bent.begin - core.at(core.exit * part)[2]) * bent.scale_m;
                    let (p, r) = (bent.rate * t, bent.rate * t + up * depth);
                    let by_across = (r.z - bent.quadric(r.truncate())).abs();
                    let by_along = (bent.quadric(p.truncate()) - p.z - depth).abs();
                    let slack = 2e-3 * (bent.scale_m + depth.abs());
                    assert!(
                        by_across.min(by_along) <= slack,
                        "{number} {part} {by_across} {by_along} {path:?}"
                    );
                    across += usize::from(by_across <= slack);
                    along += usize::from(by_across > slack);
                }
            }
        }
    }
    println!("{across} by equation 6, {along} by equation 7");
    assert!(across > RAYS && along > 0);
}

#[test]
fn a_plane_is_as_deep_across_the_view_as_equation_6_says() {
    let level = HeightMap::from_fn(4, 4, Wrap::Repeat, |_, _| 0.9).expect("a map");
    let map = level.with_displacement(1.0, -1.0).expect("proper numbers");
    let mut case = Case::on("quadric-perpendicular", "linear", "binary", map);
    case.set("surface.chords", 64.0);
    for degrees in [5.0f64, 20.0, 45.0, 80.0] {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        let corner = |x: f32, y: f32| {
            Corner::new([x, y, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [x, y], [0.0; 3])
        };
        let direction = [sine as f32, 0.0, -cosine as f32];
        let origin = direction.map(|number| -number);
        let (a, b, c) = (corner(-1.0, -1.0), corner(1.0, -1.0), corner(0.0, 1.0));
        let pixel = PixelIn::new(origin, direction, 1.0, a, b, c, relief_shaders::cpu::Shell::whole());
        let probes: Vec<Probe> = case.on_cpu(&[pixel]);
        let program = case.program();
        let path = program.segment(pixel, program.enter(pixel), probes[0].segment - 1);
        // The depth is the ray's descent over the sine.
        let t = f64::from(path.start) + f64::from(probes[0].t) - 1.0;
        let expected = 0.1 * sine / cosine;
        assert!(probes[0].found == 1 && (t - expected).abs() < 2e-3 * expected, "{degrees}: {t} {expected}");
    }
}

#[test]
fn the_backends_have_the_same_bits() {
    let Some(mut prober) = adapter::prober() else { return };
    let stages = [
        ("quadric-vertical", "cells", "patch"),
        ("quadric-vertical", "linear", "binary"),
        ("quadric-vertical", "none", "offset-limited"),
        ("quadric-perpendicular", "linear", "secant"),
    ];
    let mut all = Comparison::default();
    for (number, (surface, search, refine)) in stages.into_iter().enumerate() {
        for (wrap, displacement) in [Wrap::Clamp, Wrap::Repeat].into_iter().zip(&DISPLACEMENTS[1..]) {
            let case = Case::on(surface, search, refine, map(wrap, *displacement));
            let rays = rays::bent_pixels(&case.map, 5 * RAYS, 11 + number as u64);
            let gpu = prober.probe(case.surface(), Sampling::Exact, &rays).expect("the probe runs");
            let one = Comparison::new(&case, &rays, &case.on_cpu(&rays), &gpu);
            println!("{surface} {search} {refine}: {} of {} differ", one.different, one.rays);
            all = all.plus(one);
        }
    }
    all.check().expect("the same bits");
}

#[test]
fn what_cannot_be_used_with_quadrics_is_refused() {
    let with = |surface: &str, key: &str, name: &str| {
        let mut selection = Selection::pair("linear", "binary").expect("listed names");
        selection.choose("surface", surface).expect("a surface");
        selection.choose(key, name).expect("a listed name");
        selection.check_pair().is_err() || selection.check().is_ok()
    };
    for surface in ["quadric-vertical", "quadric-perpendicular"] {
        assert!(!with(surface, "shadow", "entry") && with(surface, "shadow", "ray"), "{surface}");
        for entry in refine::ENTRIES {
            assert!(with(surface, "refine", entry.name), "{surface} {}", entry.name);
        }
    }
    for entry in search::ENTRIES.iter().filter(|entry| entry.tracing().solids.has(Solids::Heights)) {
        let bends = entry.guarantee.bent != relief_core::registry::Guarantee::Impossible;
        let pair = pairs::all().find(|pair| pair.search().name == entry.name).expect("a pair");
        for (surface, expected) in
            [("quadric-vertical", bends), ("quadric-perpendicular", entry.name == "linear")]
        {
            let mut selection = pair;
            selection.choose("surface", surface).expect("a surface");
            assert_eq!(selection.check().is_ok(), expected, "{surface} {}", entry.name);
        }
    }
}
