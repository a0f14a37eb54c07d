//! Pictures that are kept: samples, cameras that see all, and bands of rows.

use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

use glam::DVec3;
use relief_core::camera::Projection;
use relief_core::mesh::{Builtin, square};
use relief_core::{Cancelled, HeightMap, Watch, Wrap};
use relief_maps::Maps;
use relief_render::job::Rendering;
use relief_render::{RENDERING, RenderError, Renderer, block_on, render};
use relief_scene::{BackendChoice, Look, Scene, SceneSpec, Surface, SurfaceSpec, View, read_scene};
use relief_shaders::Selection;
use relief_shaders::cpu::PixelOut;
use relief_tests::adapter::has_adapter;

/// The backends of this machine.
fn backends() -> Vec<BackendChoice> {
    if has_adapter() { vec![BackendChoice::Cpu, BackendChoice::Gpu] } else { vec![BackendChoice::Cpu] }
}

/// A shipped scene, changed.
fn scene(file: &str, over: SceneSpec) -> Scene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes").join(file);
    read_scene(&path).expect("a shipped scene").overridden_by(over).load().expect("a shipped map")
}

fn picture(scene: &Scene) -> Rendering {
    render(scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture").rendering
}

/// The root of the mean square by which the covered parts of silhouettes' pixels are off.
fn silhouette_error(found: &Rendering, reference: &Rendering) -> f64 {
    let pairs = found.pixels.iter().zip(&reference.pixels);
    let edges = pairs.filter(|(_, expected)| expected.color.w > 0.0 && expected.color.w < 1.0);
    let squares: Vec<f64> =
        edges.map(|(found, expected)| f64::from(found.color.w - expected.color.w).powi(2)).collect();
    assert!(squares.len() > 100, "hardly any silhouette");
    (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
}

#[test]
fn silhouettes_converge_faster_than_by_chance() {
    let of = |samples| {
        let size = Some([72, 54].into());
        let backend = Some(BackendChoice::Cpu);
        let over = SceneSpec { samples: Some(samples), size, backend, ..SceneSpec::default() };
        picture(&scene("cobbles.toml", over))
    };
    let reference = of(1024);
    let errors = [1, 4, 16, 64].map(|samples| silhouette_error(&of(samples), &reference));
    println!("{errors:?}");
    for pair in errors[1..].windows(2) {
        assert!(pair[0] >= 2.5 * pair[1], "{errors:?}");
    }
    assert!(errors[0] > 2.5 * errors[1], "{errors:?}");
}

#[test]
fn samples_change_colours_alone() {
    for backend in backends() {
        let of = |samples| {
            let size = Some([80, 60].into());
            // In one detail, whatever the number of samples.
            let stages = [("detail".to_owned(), "none".to_owned())].into();
            let surface = SurfaceSpec { stages, ..SurfaceSpec::default() };
            let (samples, backend) = (Some(samples), Some(backend));
            let over = SceneSpec { samples, size, backend, ..SceneSpec::of_surface(surface) };
            picture(&scene("still-life.toml", over))
        };
        let [one, many] = [1, 9].map(of);
        let mut mixed = 0;
        for (a, b) in one.pixels.iter().zip(&many.pixels) {
            assert_eq!(PixelOut { color: b.color, ..*a }, *b, "{backend}");
            assert!(a.color.w == 0.0 || a.color.w == 1.0);
            mixed += usize::from(b.color.w > 0.01 && b.color.w < 0.99);
            // Inside of a surface and of the background nothing changes much.
            assert!((-1e-5..=1.0 + 1e-5).contains(&b.color.w));
        }
        assert!(mixed > 100, "{backend}: {mixed}");
    }
}

#[test]
fn both_backends_resolve_the_same_colours() {
    let backends = backends();
    let [_, _] = backends[..] else { return };
    let pictures = [BackendChoice::Cpu, BackendChoice::Gpu].map(|backend| {
        let surface = SurfaceSpec { method: Some("cone".to_owned()), ..SurfaceSpec::default() };
        let over = SceneSpec {
            samples: Some(4),
            size: Some([120, 90].into()),
            backend: Some(backend),
            ..SceneSpec::of_surface(surface)
        };
        picture(&scene("bricks.toml", over))
    });
    let pairs = pictures[0].pixels.iter().zip(&pictures[1].pixels);
    let off = pairs.filter(|(a, b)| {
        let [a, b] = [a.color, b.color];
        [a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w].iter().any(|apart| apart.abs() > 1e-3)
    });
    // A sample on the edge of two triangles may belong to either.
    let off = off.count();
    assert!(off < 40, "{off}");
}

#[test]
fn an_even_slope_has_one_normal_up_to_the_edge_of_a_clamped_map() {
    let slope = |i: u32, j: u32| 0.2 + (3.0 * i as f32 + 2.0 * j as f32) / 64.0;
    let map = HeightMap::from_fn(9, 7, Wrap::Clamp, slope).expect("a valid map");
    let map = map.with_displacement(1.0, -0.2).expect("lengths");
    // On a square of 1 m: 64ths of a metre over a ninth and a seventh.
    let expected = DVec3::new(-27.0 / 64.0, 1.0, -14.0 / 64.0).normalize();
    for backend in backends() {
        for (method, has_creases) in
            [("bump", false), ("exact", false), ("exact", true), ("tessellate", false)]
        {
            let surface = Surface::new(square(1).expect("a mesh"), map.clone())
                .with_selection(Selection::method(method).expect("a method"))
                .with_creases(has_creases);
            let camera = Scene::builder(surface).fitted_orthographic_camera(View::Top);
            let scene = camera.size(80, 80).samples(1).backend(backend).build().expect("a scene");
            let pixels = picture(&scene).pixels;
            let hits: Vec<DVec3> = pixels
                .iter()
                .filter(|pixel| pixel.hit == 1)
                .map(|pixel| {
                    DVec3::from_array([pixel.normal.x, pixel.normal.y, pixel.normal.z].map(f64::from))
                })
                .collect();
            assert!(hits.len() > 3000, "{backend} {method}: {}", hits.len());
            let off = hits.iter().map(|normal| normal.angle_between(expected)).fold(0.0, f64::max);
            assert!(off < 1e-3, "{backend} {method}, creases {has_creases}: {off} rad");
        }
    }
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let over = SceneSpec {
        samples: Some(5),
        size: Some([90, 70].into()),
        backend: Some(BackendChoice::Cpu),
        ..SceneSpec::default()
    };
    let scene = scene("cobbles.toml", over);
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| picture(&scene))
    };
    let expected = with(1);
    assert!([2, 3, 7].into_iter().all(|threads| with(threads) == expected));
}

#[test]
fn bands_are_the_rows_of_the_whole_picture() {
    for backend in backends() {
        // More than a band of 2^18 pixels, the last one of few rows.
        let over = SceneSpec {
            samples: Some(2),
            size: Some([701, 400].into()),
            backend: Some(backend),
            ..SceneSpec::of_surface(SurfaceSpec { method: Some("bump".to_owned()), ..SurfaceSpec::default() })
        };
        let scene = scene("still-life.toml", over);
        let whole = picture(&scene);
        let mut renderer = Renderer::new(scene.backend(), scene.sampling()).expect("a renderer");
        let mut maps = Maps::in_memory();
        for numbers in [true, false] {
            let (mut all, mut bands) = (Vec::new(), 0);
            let made = renderer.render_bands(&scene, &mut maps, numbers, &Watch::none(), &mut |band| {
                assert_eq!(band.len() % 701, 0);
                all.extend_from_slice(band);
                bands += 1;
                Ok(())
            });
            made.expect("a picture");
            assert!(bands > 1);
            if numbers {
                assert!(all == whole.pixels, "{backend}");
            } else {
                let colours = |pixels: &[PixelOut]| -> Vec<_> { pixels.iter().map(|p| p.color).collect() };
                assert!(colours(&all) == colours(&whole.pixels), "{backend}");
            }
        }
        let mut rows_of = |rows| {
            let mut some = Vec::new();
            let mut sink = |band: &[PixelOut]| {
                some.extend_from_slice(band);
                Ok(())
            };
            let quiet = Watch::none();
            let drawn = renderer.render_rows_async(&scene, &mut maps, rows, true, &quiet, &mut sink);
            block_on(drawn).expect("rows");
            some
        };
        assert!(rows_of(37..390) == whole.pixels[37 * 701..390 * 701], "{backend}");
        assert!(rows_of(390..u32::MAX) == whole.pixels[390 * 701..] && rows_of(400..500).is_empty());
        // Whoever has enough gets no more.
        let mut bands = 0;
        let stopped = renderer.render_bands(&scene, &mut maps, false, &Watch::none(), &mut |_| {
            bands += 1;
            Err(Cancelled)
        });
        assert!(matches!(stopped, Err(RenderError::Cancelled(_))) && bands == 1, "{bands}");
        let cancel = AtomicBool::new(true);
        let cancelled = Watch::cancelled_by(&cancel);
        let stopped = renderer
            .render_bands(&scene, &mut maps, false, &cancelled, &mut |_| panic!("it was cancelled before"));
        assert!(matches!(stopped, Err(RenderError::Cancelled(_))));
    }
}

#[test]
fn a_watch_hears_of_bakes_then_of_the_picture_and_ends_either() {
    for backend in backends() {
        // More than a band.
        let over = SceneSpec {
            samples: Some(1),
            size: Some([701, 400].into()),
            backend: Some(backend),
            ..SceneSpec::of_surface(SurfaceSpec { method: Some("cone".to_owned()), ..SurfaceSpec::default() })
        };
        let scene = scene("cobbles.toml", over);
        let mut renderer = Renderer::new(scene.backend(), scene.sampling()).expect("a renderer");
        let heard = Mutex::new(Vec::new());
        let tell = |task: &str, part: f32| heard.lock().expect("a list").push((task.to_owned(), part));
        let made = renderer.render(&scene, &mut Maps::in_memory(), &Watch::telling(&tell));
        made.expect("a picture");
        let heard = heard.into_inner().expect("a list");
        let mut tasks: Vec<&str> = heard.iter().map(|(task, _)| task.as_str()).collect();
        tasks.dedup();
        assert_eq!(tasks, ["cone", RENDERING], "{backend}");
        for task in tasks {
            let of_task = heard.iter().filter(|(told, _)| told == task).map(|(_, part)| *part);
            let [least, most] = of_task.fold([1.0f32, 0.0], |[a, b], part| [a.min(part), b.max(part)]);
            assert!(least >= 0.0 && (most - 1.0).abs() < 1e-5, "{backend} {task}: {least} to {most}");
            let cancel = AtomicBool::new(false);
            let tell = |told: &str, _: f32| cancel.store(told == task, Ordering::Relaxed);
            let watch = Watch::new(&tell, &cancel);
            let ended = renderer.render(&scene, &mut Maps::in_memory(), &watch).map(drop);
            assert!(matches!(ended, Err(RenderError::Cancelled(_))), "{backend} {task}: {ended:?}");
        }
        let cancel = AtomicBool::new(true);
        let timed = renderer.time(&scene, &mut Maps::in_memory(), &Watch::cancelled_by(&cancel));
        assert!(matches!(timed, Err(RenderError::Cancelled(_))), "{backend}: {timed:?}");
    }
}

#[test]
fn a_fitted_camera_sees_all_as_large_as_it_can() {
    let height = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/spikes.png");
    let meshes = [Builtin::Plane, Builtin::Cube, Builtin::Sphere, Builtin::Torus, Builtin::Cylinder];
    for mesh in meshes {
        for size in [[120, 80], [60, 110], [100, 100]] {
            for view in View::ALL {
                for projection in ["perspective", "orthographic"] {
                    let surface = SurfaceSpec {
                        height: Some(height.clone()),
                        mesh: Some(mesh.into()),
                        position: Some([3.0, -2.0, 7.0]),
                        rotation: Some([10.0, 20.0, 30.0]),
                        mesh_scale: Some(2.5),
                        scale: Some(0.3),
                        two_sided: Some(true),
                        ..SurfaceSpec::default()
                    };
                    // The look whose cameras go by all of the relief's depth.
                    let over = SceneSpec {
                        look: Some(Look::Plain),
                        view: Some(view),
                        projection: projection.parse().ok(),
                        size: Some(size.into()),
                        samples: Some(1),
                        backend: Some(BackendChoice::Cpu),
                        ..SceneSpec::of_surface(surface)
                    };
                    let scene = over.load().expect("a scene");
                    let what = format!("{mesh} {size:?} {view} {projection}");
                    let [across, along] = reach(&scene);
                    let most = across.max(along);
                    assert!((0.9..=0.95).contains(&most), "{what}: {across} {along}");
                    let seen = picture(&scene).pixels.iter().filter(|pixel| pixel.hit == 1).count();
                    assert!(seen > 200, "{what}: {seen} pixels");
                }
            }
        }
    }
}

/// How far the relief of a scene reaches from the middle of the picture, in parts of its half width and
/// height.
fn reach(scene: &Scene) -> [f64; 2] {
    let camera = scene.camera();
    let [width, height] = scene.size().map(f64::from);
    let mut most = [0.0f64; 2];
    for surface in scene.surfaces() {
        let map = surface.height_map();
        for vertex in surface.mesh().vertices() {
            for height_m in [map.bias_m(), map.bias_m() + map.scale_m()] {
                let point: DVec3 =
                    vertex.position.as_dvec3() + vertex.normal.as_dvec3() * height_m - camera.eye();
                let depth = point.dot(camera.forward());
                assert!(depth > 0.0, "behind the eye");
                let half = match camera.projection() {
                    Projection::Perspective { .. } => camera.half_height() * depth,
                    Projection::Orthographic { .. } => camera.half_height(),
                };
                let place =
                    [point.dot(camera.right()) / (half * width / height), point.dot(camera.up()) / half];
                most = [0, 1].map(|axis| most[axis].max(place[axis].abs()));
            }
        }
    }
    most
}

#[test]
fn an_orthographic_picture_is_a_perspective_from_far_away() {
    let height = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/cobbles.png");
    for backend in backends() {
        let direction = DVec3::new(0.5, 0.7, 0.4).normalize();
        let of = |projection: &str, distance: f64, fov, view_height| {
            let surface = SurfaceSpec {
                height: Some(height.clone()),
                tile: Some([2.0, 2.0]),
                ..SurfaceSpec::default()
            };
            let over = SceneSpec {
                eye: Some((direction * distance).to_array()),
                projection: projection.parse().ok(),
                fov,
                view_height,
                size: Some([90, 90].into()),
                samples: Some(1),
                backend: Some(backend),
                ..SceneSpec::of_surface(surface)
            };
            picture(&over.load().expect("a scene"))
        };
        let fov = 2.0 * (0.5f64 * 1.2 / 300.0).atan().to_degrees();
        let far = of("perspective", 300.0, Some(fov), None);
        let parallel = of("orthographic", 3.0, None, Some(1.2));
        let both = far.pixels.iter().zip(&parallel.pixels).filter(|(a, b)| a.hit == 1 && b.hit == 1);
        let texels = both.map(|(a, b)| 256.0 * (a.uv.x - b.uv.x).hypot(a.uv.y - b.uv.y));
        let mut texels: Vec<f32> = texels.collect();
        texels.sort_unstable_by(f32::total_cmp);
        let (median, most) = (texels[texels.len() / 2], texels[texels.len() * 98 / 100]);
        assert!(texels.len() > 2000 && median < 0.6 && most < 4.0, "{backend}: {median} {most}");
        // Depths are metres along the axis, whatever the projection.
        let (a, b) = (far.pixels[45 * 90 + 45], parallel.pixels[45 * 90 + 45]);
        assert!((a.depth - 297.0 - b.depth).abs() < 0.01, "{} {}", a.depth, b.depth);
    }
}
