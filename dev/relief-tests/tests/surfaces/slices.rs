//! Slices through the relief: against linear search, which looks at the same heights, and against the truth.
//!
//! Kautz and Seidel 2001, section 3.

use std::sync::Arc;

use relief_core::camera::Camera;
use relief_core::mesh::torus;
use relief_core::{HeightMap, Watch, Wrap};
use relief_maps::Maps;
use relief_render::render;
use relief_scene::BackendChoice::{Cpu, Gpu};
use relief_scene::{Scene, Surface};
use relief_shaders::Selection;
use relief_shaders::cpu::PixelOut;
use relief_shaders::wgsl::Sampling;
use relief_testing::maps;
use relief_testing::maps::fractal;
use relief_tests::accuracy;
use relief_tests::adapter::has_adapter;
use relief_tests::claims::picture_verdicts;
use relief_tests::one_source::cases::Case;
use relief_tests::one_source::compare::Comparison;
use relief_tests::one_source::{adapter, rays};
use relief_tests::slices::{PlaneView, is_in_middle};

const SIZE: u32 = 160;

/// Rays a map and setting.
const RAYS: usize = 10_000;

const METHODS: [&str; 3] = ["slices-surface", "slices-orthogonal", "slices-screen"];

fn map(name: &str, scale_m: f64) -> Arc<HeightMap> {
    let map =
        accuracy::maps().into_iter().find(|map| map.name == name).expect("a map of the accuracy tables").map;
    Arc::new(map.with_displacement(scale_m, -scale_m).expect("lengths"))
}

fn ground(scale_m: f64) -> Arc<HeightMap> {
    let map = HeightMap::new(1024, 1024, fractal(7, 1024, 1024, 0.5), Wrap::Repeat).expect("a map");
    Arc::new(map.with_displacement(scale_m, -scale_m).expect("lengths"))
}

fn view(map: &Arc<HeightMap>, degrees: f64) -> PlaneView<'_> {
    PlaneView { map, degrees, away_m: 2.0, size: SIZE }
}

#[test]
fn slices_of_a_plane_are_the_steps_of_linear_search() {
    for (name, degrees) in [("cobbles", 30.0), ("spikes", 50.0), ("bricks", 70.0)] {
        let map = map(name, 0.08);
        let view = view(&map, degrees);
        for count in [1.0, 7.0, 32.0] {
            let steps = view.pixels("steep", &[("search.steps", count)], Cpu);
            let slices = view.pixels("slices-surface", &[("slices.count", count)], Cpu);
            let same = view.share_within(&steps, &slices, 0.01);
            assert!(same >= 0.999, "{name} {degrees} {count}: {same}");
            // Slices that lie at other heights are noticed.
            let others = view.pixels("slices-surface", &[("slices.count", count + 1.0)], Cpu);
            let noticed = 1.0 - view.share_within(&steps, &others, 0.01);
            assert!(noticed > 0.01, "{name} {degrees} {count}: {noticed}");
        }
    }
}

#[test]
fn what_is_seen_lies_between_the_truth_and_the_slice_after_it() {
    // Broad forms, which no slice misses.
    let map = HeightMap::from_fn(64, 64, Wrap::Repeat, |i, j| {
        let wave = |k: u32| (f64::from(k) / 64.0 * std::f64::consts::TAU * 2.0).sin();
        (0.5 + 0.45 * wave(i) * wave(j)) as f32
    });
    let map = Arc::new(map.expect("a map").with_displacement(0.1, -0.1).expect("lengths"));
    for degrees in [20.0, 60.0] {
        let view = view(&map, degrees);
        let truth = view.pixels("exact", &[], Cpu);
        for method in METHODS {
            let slices = view.pixels(method, &[("slices.count", 64.0)], Cpu);
            let along_m = view.along_m(method, 1.0 / 64.0);
            let seen = view.errors(&truth, &slices, along_m);
            println!("{method} {degrees}: {seen:?}");
            assert!(seen.see_through < 0.003, "{method} {degrees}: {seen:?}");
            let early = truth.iter().zip(&slices).filter(|(truth, slice)| {
                is_in_middle(truth) && slice.hit == 1 && slice.depth < truth.depth - 1e-4
            });
            assert!(early.count() < 30, "{method} {degrees}: hits before the surface");
            // Twice as many slices are twice as near.
            let finer = view.pixels(method, &[("slices.count", 128.0)], Cpu);
            let finer = view.errors(&truth, &finer, along_m).median / seen.median;
            assert!((0.4..0.6).contains(&finer), "{method} {degrees}: {finer}");
        }
    }
}

#[test]
fn error_times_slices_crossed_is_the_same_for_all_ways_to_slice() {
    let map = map("cobbles", 0.15);
    for degrees in [20.0, 60.0, 75.0] {
        let view = view(&map, degrees);
        let truth = view.pixels("exact", &[], Cpu);
        let products = METHODS.map(|method| {
            let slices = view.pixels(method, &[("slices.count", 128.0)], Cpu);
            view.errors(&truth, &slices, 1.0).median * view.fragments(&truth, view.settings(method, 128))
        });
        let [least, most] = [f64::min, f64::max].map(|of| products.into_iter().fold(products[0], of));
        println!("{degrees}: {products:.2?}");
        assert!(most < 1.1 * least, "{degrees}: {products:?}");
    }
}

#[test]
fn sixteen_refined_slices_are_off_less_often_than_sixty_four_plain_ones() {
    // Where 64 slices are less than a texel apart there is nothing to be gained.
    let views = [
        ("ground", ground(0.15), [20.0, 60.0], &METHODS[..]),
        ("cobbles", map("cobbles", 0.15), [50.0, 60.0], &METHODS[..1]),
        ("spikes", map("spikes", 0.15), [50.0, 60.0], &METHODS[..1]),
    ];
    for (name, map, degrees, methods) in &views {
        for degrees in *degrees {
            let view = view(map, degrees);
            let truth = view.pixels("exact", &[], Cpu);
            for method in *methods {
                let off = |set: &[(&str, f64)]| {
                    1.0 - view.share_within(&truth, &view.pixels(method, set, Cpu), 0.5)
                };
                let plain = off(&[("slices.count", 64.0)]);
                let refined = off(&[("slices.count", 16.0), ("slices.refine", 1.0)]);
                println!("{name} {degrees} {method}: {plain:.4} of 64 plain, {refined:.4} of 16 refined");
                assert!(refined < plain, "{name} {degrees} {method}: {refined} and {plain}");
            }
        }
    }
}

#[test]
fn upright_slices_close_what_slices_along_the_base_leave_open() {
    let map = map("spikes", 0.15);
    let view = PlaneView { size: 2 * SIZE, ..view(&map, 78.0) };
    let truth = view.pixels("exact", &[], Cpu);
    let [surface, orthogonal] = ["slices-surface", "slices-orthogonal"].map(|method| {
        let slices = view.pixels(method, &[("slices.count", 16.0), ("slices.test", 0.0)], Cpu);
        1.0 - view.share_within(&truth, &slices, 6.0)
    });
    println!("off by six texels: {surface:.4} along the base, {orthogonal:.4} upright");
    assert!(orthogonal < 0.5 * surface, "{orthogonal} upright, {surface} along the base");
}

#[test]
fn slices_at_equal_depths_come_to_the_tetrahedra_that_they_are_cut_from() {
    let map = Arc::new((*map("cobbles", 0.03)).clone().with_displacement(0.03, 0.0).expect("lengths"));
    let base = Arc::new(torus(32, 16).and_then(|mesh| mesh.tiled([6.0, 3.0].into())).expect("a mesh"));
    let pixels = |selection: Selection| {
        let surface = Surface::new(Arc::clone(&base), Arc::clone(&map)).with_selection(selection);
        let camera = Camera::new([0.6, 1.2, 2.0].into(), [0.0; 3].into(), 28.0).expect("a camera");
        let scene = Scene::builder(surface).camera(camera).size(120, 90).samples(1).backend(Cpu);
        let scene = scene.build().expect("a scene");
        render(&scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture").rendering.pixels
    };
    let mut truth = Selection::exact();
    truth.choose("surface", "tetrahedra").expect("a surface");
    let truth = pixels(truth);
    let apart = |count: f64| {
        let mut selection = Selection::method("slices-screen").expect("a method");
        selection.set("slices.count", count).expect("a setting");
        let slices = pixels(selection);
        let seen = truth.iter().zip(&slices).filter(|(truth, _)| truth.hit == 1);
        // In texels; 256 make a tile.
        let texels = |(a, b): (&PixelOut, &PixelOut)| {
            let [u, v] = [a.uv.x - b.uv.x, a.uv.y - b.uv.y].map(|beside| 256.0 * (beside - beside.round()));
            if b.hit == 1 { u.hypot(v) } else { f32::INFINITY }
        };
        let mut apart: Vec<f32> = seen.map(texels).collect();
        assert!(apart.len() > 2000, "{} pixels", apart.len());
        apart.sort_by(f32::total_cmp);
        apart[apart.len() * 99 / 100]
    };
    let [coarse, fine] = [32.0, 256.0].map(apart);
    println!("{coarse} and {fine} texels");
    // Of tetrahedra that are cut along other diagonals they are seven texels apart, however many there are.
    assert!(coarse < 2.0 && fine < 0.25, "{coarse} {fine}");
}

#[test]
fn a_border_clips_what_sides_cut_off() {
    let map = Arc::new((*map("cobbles", 0.15)).clone().with_wrap(Wrap::Clamp));
    for degrees in [20.0, 70.0] {
        let view = view(&map, degrees);
        for (test, refine) in [("inside", 0.0), ("at-least", 2.0), ("band", 0.0)] {
            let test = Selection::value_of("slices.test", test).expect("a test");
            let set = [("slices.count", 24.0), ("slices.test", test), ("slices.refine", refine)];
            let [volume, border] = [0.0, 1.0].map(|clip| [&set[..], &[("geometry.clip", clip)]].concat());
            let cut_off = view.pixels("slices-screen", &volume, Cpu);
            let clipped = view.pixels("slices-screen", &border, Cpu);
            // All of the plane, with its edges.
            let same = cut_off.iter().zip(&clipped).filter(|(a, b)| match (a.hit, b.hit) {
                (1, 1) => (a.depth - b.depth).abs() < 1e-4,
                (a, b) => a == b,
            });
            let same = same.count() as f64 / clipped.len() as f64;
            println!("{degrees} {test} {refine}: {same}");
            assert!(same >= 0.999, "{degrees} {test} {refine}: {same}");
            if has_adapter() {
                let on_gpu = view.pixels("slices-screen", &border, Gpu);
                assert!(view.share_within(&clipped, &on_gpu, 0.01) >= 0.999, "{degrees} {test} {refine}");
            }
        }
    }
}

#[test]
fn tests_draw_what_they_say() {
    let heights = |i: u32, _: u32| if i % 16 < 4 { 0.0 } else { 1.0 };
    let map = HeightMap::from_fn(64, 64, Wrap::Repeat, heights).expect("a map");
    let map = Arc::new(map.with_displacement(0.1, -0.1).expect("lengths"));
    let view = view(&map, 10.0);
    let shown = |test: f64| {
        let pixels = view.pixels("slices-surface", &[("slices.count", 8.0), ("slices.test", test)], Cpu);
        pixels.iter().filter(|pixel| is_in_middle(pixel)).map(|pixel| pixel.height).collect::<Vec<f32>>()
    };
    let (inside, at_least, band) = (shown(0.0), shown(1.0), shown(2.0));
    // The lowest slice is whole, or masked where heights are 0.
    assert!(at_least.contains(&0.0) && inside.iter().all(|height| *height > 0.0));
    assert!(inside.len() < at_least.len());
    // What lies under the tops is not drawn by bands: neither their sides nor what is seen through them.
    assert!(band.len() < at_least.len() && band.contains(&0.0));
}

#[test]
fn backends_show_the_same_slices() {
    if !has_adapter() {
        return;
    }
    let map = map("cobbles", 0.08);
    let view = view(&map, 55.0);
    for method in METHODS {
        for set in [&[("slices.count", 24.0)][..], &[("slices.count", 12.0), ("slices.refine", 2.0)]] {
            let [cpu, gpu] = [Cpu, Gpu].map(|backend| view.pixels(method, set, backend));
            let same = view.share_within(&cpu, &gpu, 0.001);
            assert!(same >= 0.999, "{method} {set:?}: {same}");
        }
    }
}

#[test]
fn backends_have_the_same_bits_on_single_slices() {
    let Some(mut prober) = adapter::prober() else { return };
    let mut all = Comparison::default();
    for (number, wrap) in Wrap::ALL.into_iter().enumerate() {
        let test = number as f64;
        for (count, steps) in [(16.0, 0.0), (16.0, 1.0), (16.0, 4.0)] {
            let named = maps::ALL.iter().find(|map| map.name == "natural 101x67").expect("a listed map");
            let map = named.build(wrap).with_displacement(0.3, -0.1).expect("lengths");
            let set = [("slices.count", count), ("slices.refine", steps), ("slices.test", test)];
            let case = Case::of_slices("slices-surface", &set, map);
            let rays = rays::sliced_pixels(&case.map, RAYS, 17 + number as u64);
            let cpu = case.on_cpu(&rays);
            let found = cpu.iter().filter(|probe| probe.found == 1).count();
            assert!(found * 5 > rays.len(), "{set:?}: hardly anything is met, {found} of {}", rays.len());
            let gpu = prober.probe(case.surface(), Sampling::Exact, &rays).expect("the probe runs");
            all = all.plus(Comparison::new(&case, &rays, &cpu, &gpu));
        }
    }
    all.check().expect("the same bits");
}

#[test]
fn claims_about_pictures_are_borne_out_or_recorded_as_refuted() {
    for verdict in picture_verdicts() {
        let (claim, [less, more]) = (verdict.claim, verdict.figures);
        println!("{}: {}: {less:.4} and {more:.4}", claim.section, claim.text);
        assert!(less.is_finite() && more > 0.0, "{}", claim.text);
        assert_eq!(verdict.holds(), claim.holds, "{}: {less} and {more}", claim.text);
    }
}
