//! Translucent volumes: optical depths and colours beside closed forms and quadrature in `f64`.

use glam::{DVec3, Vec3};
use rayon::prelude::*;
use relief_core::camera::Camera;
use relief_core::mesh::{Mesh, Placement, square, torus};
use relief_core::{HeightMap, Path, Volume, Watch, Wrap};
use relief_maps::Maps;
use relief_mesh::motif::MotifKind;
use relief_render::job::Rendering;
use relief_render::render;
use relief_scene::light::Light;
use relief_scene::material::Material;
use relief_scene::{BackendChoice, Scene, SceneBuilder, Surface};
use relief_shaders::Selection;
use relief_shaders::cpu::{MethodTracer, PixelOut};
use relief_testing::volumes;
use relief_tests::adapter::{Leeway, has_adapter};
use relief_tests::translucent::{THICK_M, depth_error, full, seen, translucent, under, ways_in_box};
use relief_tests::volume_rays::{baked, motif_volume, paths};

/// Rays over a volume in one wrap. Times scale with it.
const RAYS: usize = 2_000;

/// Columns and rows of pictures.
const SIZE: [u32; 2] = [96, 72];

/// A square at a height.
fn raised(divisions: u32, height: f64) -> Mesh {
    let placement = Placement { position_m: DVec3::new(0.0, height, 0.0), ..Placement::default() };
    square(divisions).expect("a mesh").placed(&placement).expect("a placement")
}

/// A plain surface of heights, whose top is its mesh.
fn opaque(mesh: Mesh, base: Vec3) -> Surface {
    let ground = HeightMap::new(1, 1, vec![1.0], Wrap::Repeat).expect("a map");
    let material = Material::metallic_roughness(base, 0.0, 1.0).expect("a material");
    Surface::new(mesh, ground.with_displacement(0.01, -0.01).expect("lengths")).with_material(material)
}

/// See [`seen`].
fn in_view(surface: Surface) -> SceneBuilder {
    seen(surface, SIZE)
}

fn rendered(scene: SceneBuilder) -> (Scene, Rendering) {
    let scene = scene.build().expect("a proper scene");
    let rendering = render(&scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture").rendering;
    (scene, rendering)
}

fn pixels(scene: SceneBuilder) -> Vec<PixelOut> {
    rendered(scene).1.pixels
}

#[test]
fn the_exponential_function_errs_by_a_rounding() {
    let volume = full();
    let selection = translucent(1.0, &[]);
    let maps = baked(&volume, &selection);
    let tracer =
        MethodTracer::of_volume(&volume, &selection, maps.iter().map(|map| &**map)).expect("its maps");
    // Every 61st float from 0 to 90.
    let last = 90.0f32.to_bits();
    let error = |bits: u32| {
        let depth = f32::from_bits(bits);
        (f64::from(tracer.transmittance(depth)) - (-f64::from(depth)).exp()).abs()
    };
    let worst = (0..last / 61).into_par_iter().map(|step| error(61 * step)).reduce(|| 0.0, f64::max);
    println!("{worst:e}");
    assert!(worst <= 1.5e-7, "{worst:e}");
    assert_eq!([0.0, -1.0].map(|depth| tracer.transmittance(depth)), [1.0; 2]);
    assert_eq!([80.0, f32::INFINITY, f32::NAN].map(|depth| tracer.transmittance(depth)), [0.0; 3]);
}

#[test]
fn optical_depths_are_the_judges() {
    for (number, named) in volumes::ALL.iter().enumerate() {
        for wrap in Wrap::ALL {
            let volume = named.build(wrap).expect("a volume");
            let worst = depth_error(&volume, &volume, &paths(number as u64, RAYS));
            println!("{} {wrap}: {worst:e}", named.name);
            assert!(worst <= 1e-5, "{} {wrap}: {worst:e}", named.name);
        }
    }
}

#[test]
fn a_voxel_that_is_a_thousandth_denser_is_noticed() {
    let volume = volumes::ALL[0].build(Wrap::Repeat).expect("a volume");
    let mut values = volume.values();
    values[100] += if values[100] > 0.5 { -1e-3 } else { 1e-3 };
    let changed = Volume::new(volume.size(), &values, Wrap::Repeat).expect("a volume");
    assert!(depth_error(&changed, &volume, &paths(0, RAYS)) > 2e-5);
}

/// Szirmay-Kalos and Umenhoffer 2008, section 5.2: what is absorbed across many triangles.
#[test]
fn shells_let_through_what_the_way_in_them_does() {
    for surface_name in ["tetrahedra", "prism"] {
        for extinction in [1.0, 5.0, 20.0] {
            let selection = translucent(extinction, &[("surface", surface_name)]);
            let mesh = square(16).expect("a mesh");
            let (scene, rendering) = rendered(in_view(under(mesh, &full(), selection)));
            let ways = ways_in_box(&scene, 0.0, THICK_M);
            let truths = ways.iter().map(|way| (-extinction * way).exp());
            let off = rendering.pixels.iter().zip(truths).map(|(pixel, truth)| {
                assert_eq!(pixel.hit, 0);
                // Without light it is black, and hides what is behind.
                assert_eq!(pixel.color, [0.0, 0.0, 0.0, 1.0 - pixel.transmittance].into());
                (f64::from(pixel.transmittance) - truth).abs()
            });
            // Shells reach beyond the mesh's edge by rounding, some 4e-6 of its size.
            let worst = off.fold(0.0, f64::max);
            let inside = ways.iter().filter(|way| **way > 0.0).count();
            println!("{surface_name} {extinction}: {worst:e} over {inside} pixels");
            assert!(worst < 1e-4 && inside > 2000, "{surface_name} {extinction}: {worst:e}, {inside} pixels");
        }
    }
}

#[test]
fn a_dense_volume_hides_all_behind_every_value_above_zero() {
    let volume = Volume::from_fn([24, 24, 12], Wrap::Repeat, volumes::weave).expect("a volume");
    let selection = translucent(1e9, &[("surface", "tetrahedra")]);
    let (scene, rendering) = rendered(in_view(under(square(1).expect("a mesh"), &volume, selection)));
    let [width, height] = SIZE;
    let mut seen = [0; 2];
    for (at, pixel) in (0..).zip(&rendering.pixels) {
        let ray = scene.camera().ray(at % width, at / width, width, height);
        let along = ray.direction.normalize();
        let [a, b] =
            [[-0.5, 0.0, -0.5], [0.5, THICK_M, 0.5]].map(|corner| (DVec3::from(corner) - ray.origin) / along);
        let (enter, leave) = (a.min(b).max_element(), a.max(b).min_element());
        // From the world into the tile: v goes with z.
        let place = |t: f64| {
            let point = ray.origin + along * t;
            [point.x + 0.5, point.z + 0.5, point.y / THICK_M]
        };
        let depth = if leave > enter {
            let [from, to] = [enter, leave].map(place);
            volume.integral_along(&Path::between(from, to), 1e-9) * (leave - enter)
        } else {
            0.0
        };
        if depth > 1e-6 {
            // Rays end where less than this comes through.
            assert!(pixel.transmittance < 6.2e-5, "pixel {at}: {depth}");
            seen[0] += 1;
        } else if depth == 0.0 {
            assert_eq!(pixel.transmittance, 1.0, "pixel {at}");
            seen[1] += 1;
        }
    }
    assert!(seen[0] > 1000 && seen[1] > 1000, "{seen:?}");
}

/// Two translucent boxes with an opaque square between them, in light from all around. All is in closed form.
#[test]
fn what_lies_between_two_volumes_is_composed_in_the_order_of_the_ray() {
    let extinctions = [12.0, 5.0];
    let colors = [Vec3::new(0.8, 0.4, 0.1), Vec3::new(0.1, 0.5, 0.9)];
    let around = Vec3::new(0.5, 0.7, 0.9);
    let [upper, lower] = [0, 1].map(|which| {
        let mesh = raised(2, [0.2, -0.3][which]);
        let material = Material::metallic_roughness(colors[which], 0.0, 1.0).expect("a material");
        let selection =
            translucent(extinctions[which], &[("ambient", "constant"), ("surface", "tetrahedra")]);
        under(mesh, &full(), selection).with_material(material)
    });
    let mut between = opaque(square(1).expect("a mesh"), Vec3::splat(0.5));
    let mut plain = *between.selection();
    plain.choose("ambient", "constant").expect("a listed name");
    between = between.with_selection(plain);
    let alone = pixels(in_view(between.clone()).ambient(around));
    let mut pictures = Vec::new();
    for order in [[0, 1, 2], [2, 1, 0], [1, 2, 0]] {
        let all = [&upper, &between, &lower];
        let surfaces = order.map(|which| all[which].clone()).to_vec();
        let (scene, rendering) = rendered(in_view(upper.clone()).surfaces(surfaces).ambient(around));
        let ways = [0.2, -0.3].map(|low| ways_in_box(&scene, low, low + THICK_M));
        let mut opaque_pixels = 0;
        for (at, pixel) in rendering.pixels.iter().enumerate() {
            let seen = [0, 1].map(|which| (-extinctions[which] * ways[which][at]).exp());
            let hit = pixel.hit == 1;
            assert_eq!(hit, alone[at].hit == 1);
            opaque_pixels += usize::from(hit && ways[0][at] > 0.01);
            // What is between hides the lower box where it is hit.
            let behind = if hit {
                let color = alone[at].color;
                (Vec3::new(color.x, color.y, color.z), 1.0)
            } else {
                (colors[1] * around * (1.0 - seen[1]) as f32, (1.0 - seen[1]) as f32)
            };
            let expected = colors[0] * around * (1.0 - seen[0]) as f32 + behind.0 * seen[0] as f32;
            let color = Vec3::new(pixel.color.x, pixel.color.y, pixel.color.z);
            assert!((color - expected).abs().max_element() < 1e-4, "pixel {at}: {color} for {expected}");
            let alpha = 1.0 - seen[0] as f32 * (1.0 - behind.1);
            assert!((pixel.color.w - alpha).abs() < 1e-4, "pixel {at}: {} for {alpha}", pixel.color.w);
        }
        assert!(opaque_pixels > 300, "{opaque_pixels}");
        pictures.push(rendering.pixels.iter().map(|pixel| pixel.color).collect::<Vec<_>>());
    }
    assert!(pictures.iter().all(|picture| *picture == pictures[0]));
}

/// A light straight above a box: it is absorbed on its way down as the view is on its way up.
#[test]
fn each_effect_changes_the_picture_as_the_judge_says() {
    let albedo = Vec3::new(0.8, 0.6, 0.4);
    let irradiance = Vec3::splat(2.0);
    let extinction = 15.0;
    let picture = |others: &[(&str, &str)], extinction: f64| {
        let mut chosen = translucent(extinction, others);
        chosen.set("search.looks", 256.0).expect("a number of looks");
        let material = Material::metallic_roughness(albedo, 0.0, 1.0).expect("a material");
        let shown = under(square(4).expect("a mesh"), &full(), chosen).with_material(material);
        let light = Light::directional(DVec3::Y, irradiance).expect("a light");
        rendered(in_view(shown).lights(vec![light]))
    };
    let tetrahedra = ("surface", "tetrahedra");
    let check = |(scene, rendering): &(Scene, Rendering), truth: &dyn Fn(f64, f64) -> f64| {
        let ways = ways_in_box(scene, 0.0, THICK_M);
        let mut counted = 0;
        for (at, pixel) in (0..).zip(&rendering.pixels) {
            let ray = scene.camera().ray(at % SIZE[0], at / SIZE[0], SIZE[0], SIZE[1]);
            let fall = -ray.direction.normalize().y;
            let way = ways[at as usize];
            // Rays that come in at the top, so that the depth below it is known.
            let top = ray.origin + ray.direction * ((THICK_M - ray.origin.y) / ray.direction.y);
            if way > 0.0 && top.x.abs().max(top.z.abs()) < 0.5 {
                let expected = f64::from(albedo.x * irradiance.x * 0.25) * truth(way, fall);
                let found = f64::from(pixel.color.x);
                assert!((found - expected).abs() < 2e-4, "pixel {at}: {found} for {expected}");
                counted += 1;
            }
        }
        assert!(counted > 1500, "{counted}");
    };
    // Absorbed on both ways: the integral of s e^(-s t (1 + fall)) over t from 0 to the way.
    let whole = picture(&[tetrahedra], extinction);
    check(&whole, &|way, fall| {
        let both = 1.0 + fall;
        (1.0 - (-extinction * both * way).exp()) / both
    });
    // Without its own shadow: what the ray does not let through.
    let unshadowed = picture(&[tetrahedra, ("shadow", "none")], extinction);
    check(&unshadowed, &|way, _| 1.0 - (-extinction * way).exp());
    // Without absorption nothing is seen.
    let (_, clear) = picture(&[tetrahedra], 0.0);
    assert!(clear.pixels.iter().all(|pixel| pixel.transmittance == 1.0 && pixel.color.w == 0.0));
}

/// A weave on a torus, in the light of a look, over an opaque torus that throws shadows.
fn on_torus(
    surface_name: &str,
    shadow: &str,
    [looks, samples]: [u32; 2],
    backend: BackendChoice,
) -> Vec<PixelOut> {
    let volume = motif_volume(MotifKind::Weave, [24, 24, 12]);
    let mut chosen = translucent(120.0, &[("surface", surface_name), ("shadow", shadow)]);
    chosen.set("search.looks", looks.into()).expect("a number of looks");
    let mesh = || torus(24, 12).expect("a mesh").tiled([6.0, 3.0].into()).expect("tiles");
    let camera = Camera::new([0.5, 0.9, 1.0].into(), [0.0; 3].into(), 40.0).expect("a camera");
    let base = opaque(mesh(), Vec3::new(0.5, 0.3, 0.2));
    let scene = Scene::builder(under(mesh(), &volume, chosen)).surface(base).camera(camera);
    pixels(scene.size(SIZE[0], SIZE[1]).samples(samples).backend(backend))
}

#[test]
fn the_backends_gather_the_same_light() {
    for (surface_name, shadow) in [("tetrahedra", "map"), ("prism", "ray")] {
        let cpu = on_torus(surface_name, shadow, [24, 1], BackendChoice::Cpu);
        let through = cpu.iter().filter(|pixel| pixel.transmittance < 0.9).count();
        assert!(through > 1000, "{surface_name}: {through} pixels");
        if has_adapter() {
            let gpu = on_torus(surface_name, shadow, [24, 1], BackendChoice::Gpu);
            let bits = |pixel: &PixelOut| {
                let color = pixel.color;
                [color.x, color.y, color.z, color.w, pixel.transmittance].map(f32::to_bits)
            };
            let alike = cpu.iter().zip(&gpu).filter(|(a, b)| bits(a) == bits(b)).count();
            let share = alike as f64 / cpu.len() as f64;
            println!("{surface_name} {shadow}: {share:.5} alike");
            assert!(share >= Leeway::of_any().share(0.999), "{surface_name} {shadow}: {share}");
        }
    }
}

/// Half the looks change hardly a pixel by a quarter of a step of the screen, and none by two steps:
/// where a shadow's edge lies between two looks.
#[test]
fn half_of_the_looks_hardly_move_a_pixel() {
    let [half, whole] = [32, 64].map(|looks| on_torus("tetrahedra", "ray", [looks, 4], BackendChoice::Cpu));
    let srgb = |pixel: &PixelOut| {
        let color = pixel.color;
        relief_render::picture::srgb([color.x, color.y, color.z])
    };
    let apart = half.iter().zip(&whole).map(|(a, b)| {
        let (a, b) = (srgb(a), srgb(b));
        [0, 1, 2].map(|channel| 255.0 * (a[channel] - b[channel]).abs()).into_iter().fold(0.0, f32::max)
    });
    let mut apart: Vec<f32> = apart.collect();
    apart.sort_by(f32::total_cmp);
    let [p99, worst] = [0.99, 1.0].map(|part| apart[(part * (apart.len() - 1) as f64) as usize]);
    println!("of 255: p99 {p99}, worst {worst}");
    assert!(p99 < 0.25 && worst < 2.0 && half != whole, "{p99} {worst}");
}

/// Light that goes through the volume onto the base: by rays through the scene, on the CPU.
#[test]
fn a_volume_throws_its_own_shadow_along_rays_through_the_scene() {
    let picture = |with_volume: bool| {
        let mut base = opaque(square(1).expect("a mesh"), Vec3::ONE);
        let mut chosen = *base.selection();
        chosen.choose("shadow", "scene").expect("a listed name");
        chosen.choose("ambient", "constant").expect("a listed name");
        base = base.with_selection(chosen);
        // Above the base, so that it is seen below the volume's edge.
        let cover = raised(3, 0.6);
        let cover = under(cover, &full(), translucent(8.0, &[("surface", "tetrahedra")]));
        let light = Light::directional(DVec3::Y, Vec3::ONE).expect("a light");
        let surfaces = if with_volume { vec![base, cover] } else { vec![base] };
        pixels(in_view(opaque(square(1).expect("a mesh"), Vec3::ONE)).surfaces(surfaces).lights(vec![light]))
    };
    let [alone, covered] = [false, true].map(picture);
    let mut counted = 0;
    for (alone, covered) in alone.iter().zip(&covered) {
        if alone.hit == 1 && covered.transmittance == 1.0 {
            let expected = (-8.0 * THICK_M).exp();
            let found = f64::from(covered.lit / alone.lit);
            assert!((found - expected).abs() < 1e-4, "{found} for {expected}");
            counted += 1;
        }
    }
    assert!(counted > 500, "{counted}");
}

#[test]
fn what_translucent_volumes_cannot_do_is_refused_with_what_they_can() {
    let volume = Selection::method("translucent").expect("a method");
    assert_eq!(volume.check(), Ok(()));
    for (key, name) in [("surface", "plane"), ("shadow", "soft"), ("shadow", "scene"), ("refine", "binary")] {
        assert_eq!(volume.goes_with(key, name), Ok(false), "{key} {name}");
    }
    for (key, name) in [
        ("surface", "prism"),
        ("surface", "tetrahedra"),
        ("shadow", "none"),
        ("shadow", "map"),
        ("ambient", "hemisphere"),
    ] {
        assert_eq!(volume.goes_with(key, name), Ok(true), "{key} {name}");
    }
}
