//! Tests of errors, of the cache from frame to frame, and of the least limits, on a software
//! adapter.

use std::sync::{Arc, Mutex};

use glam::{DVec3, Vec3};
use relief_core::{HeightMap, Watch, Wrap};
use relief_io::Picture;
use relief_maps::Maps;
use relief_shaders::cpu::{Corner, Frame, PixelIn, Shell, SurfaceSettings};
use relief_shaders::wgsl::Sampling;
use relief_shaders::{Selection, SlotMaps};
use wgpu::{BufferUsages, DeviceDescriptor, Features, Limits};

use super::{AdapterChoice, Gpu, GpuError, GpuRenderer, Prober, Work};
use crate::block_on;
use crate::job::{Job, JobSurface, LightViews, Rendering};
use crate::mipmaps::Mipmaps;
use crate::picture::linear;
use crate::{Renderer, cpu::CpuRenderer};
use relief_core::camera::Camera;
use relief_core::mesh::{Mesh, Placement, square, torus};
use relief_scene::background::Background;
use relief_scene::depth_buffer::DepthBuffer;
use relief_scene::{BackendChoice, Scene, Surface};

mod prepass;
mod screen;
mod shells;
mod tessellate;

/// Opens a software GPU for a test. Without one the test reports that it skips, unless the
/// environment variable `RELIEF_REQUIRE_GPU` is 1: then it fails.
pub(super) fn software() -> Option<Gpu> {
    match Gpu::new(AdapterChoice::Software) {
        Ok(gpu) => Some(gpu),
        Err(error) if std::env::var_os("RELIEF_REQUIRE_GPU").is_some_and(|value| value == "1") => {
            panic!("RELIEF_REQUIRE_GPU is 1: {error}")
        }
        Err(error) => {
            println!("skipped: {error}");
            None
        }
    }
}

/// Opens the software adapter as a caller does, with exactly those limits and no feature.
pub(super) fn own(limits: Limits) -> Option<Gpu> {
    software()?;
    let adapter = block_on(AdapterChoice::Software.find()).expect("there is one");
    let descriptor = DeviceDescriptor {
        required_features: Features::empty(),
        required_limits: limits,
        ..Default::default()
    };
    let (device, queue) = block_on(adapter.request_device(&descriptor)).expect("a device");
    Some(Gpu::of_device(device, queue, "the caller's own"))
}

fn level_map() -> Arc<HeightMap> {
    Arc::new(HeightMap::from_fn(4, 4, Wrap::Repeat, |_, _| 0.5).expect("a valid map"))
}

fn surface(map: &Arc<HeightMap>) -> JobSurface {
    let selection = Selection::method("relief").expect("a method");
    JobSurface {
        settings: SurfaceSettings::tracing(map, &selection, &SlotMaps::default()),
        selection,
        triangles: Arc::default(),
        height_map: Arc::clone(map),
        color: None,
        normal_map: None,
        material_maps: None,
        maps: Vec::new(),
        two_sided: false,
    }
}

fn job(surface: JobSurface) -> Job {
    let light_views = LightViews::default();
    Job { width: 16, height: 8, samples: 1, frame: Frame::none(), light_views, surfaces: vec![surface] }
}

fn ray() -> PixelIn {
    let corner = |x: f32, z: f32| {
        Corner::new([x, 0.0, z], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [x, z], [0.0; 3])
    };
    PixelIn::new(
        [0.0, 3.0, 0.0],
        [0.0, -1.0, 0.0],
        1.0,
        corner(-1.0, -1.0),
        corner(0.0, 1.0),
        corner(1.0, -1.0),
        Shell::whole(),
    )
}

#[test]
fn a_lost_device_is_an_error_from_then_on() {
    let Some(gpu) = software() else { return };
    let surface = surface(&level_map());
    let (mut prober, mut renderer) = (Prober::new(gpu.clone()), GpuRenderer::new(gpu.clone()));
    assert_eq!(prober.probe(&surface, Sampling::Exact, &[ray()]).map(|probes| probes[0].found), Ok(1));
    gpu.device().destroy();
    let job = job(surface.clone());
    for _ in 0..2 {
        let rendered = renderer.render(&job, Sampling::Exact, &Watch::none()).map(|_| ());
        assert!(matches!(rendered, Err(GpuError::Lost(_))), "{rendered:?}");
        let drawn = block_on(renderer.draw(&job, Sampling::Exact)).map(|_| ());
        assert!(matches!(drawn, Err(GpuError::Lost(_))), "{drawn:?}");
        let probed = prober.probe(&surface, Sampling::Exact, &[ray()]).map(|_| ());
        assert!(matches!(probed, Err(GpuError::Lost(_))), "{probed:?}");
    }
}

#[test]
fn what_does_not_fit_is_refused_by_name() {
    let Some(gpu) = software() else { return };
    let map = level_map();
    let limit = gpu.device().limits().max_texture_dimension_2d;
    let mut renderer = GpuRenderer::new(gpu);
    let mut render = |job: &Job| renderer.render(job, Sampling::Exact, &Watch::none()).map(|_| ());
    let wide = Job { width: limit + 1, ..job(surface(&map)) };
    let what = "picture";
    assert_eq!(render(&wide), Err(GpuError::TooLarge { what, width: limit + 1, height: 8, limit }));

    let picture = |width: u32, height: u32, texels: usize| {
        let picture = Picture { width, height, texels: vec![[0.0; 4]; texels] };
        Some(Arc::new(Mipmaps::finest_only(Arc::new(picture))))
    };
    let what = "colour map";
    let long = picture(1, limit + 1, limit as usize + 1);
    let colored = job(JobSurface { color: long, ..surface(&map) });
    assert_eq!(render(&colored), Err(GpuError::TooLarge { what, width: 1, height: limit + 1, limit }));

    let what = "normal map";
    let bent = job(JobSurface { normal_map: picture(3, 2, 5), ..surface(&map) });
    assert_eq!(render(&bent), Err(GpuError::WrongLength { what, width: 3, height: 2, given: 5 }));
    let empty = job(JobSurface { normal_map: picture(0, 0, 0), ..surface(&map) });
    assert_eq!(render(&empty), Err(GpuError::WrongLength { what, width: 0, height: 0, given: 0 }));

    assert_eq!(render(&job(surface(&map))), Ok(()));
}

#[test]
fn refused_commands_are_errors_and_the_gpu_goes_on() {
    let Some(gpu) = software() else { return };
    let surface = surface(&level_map());
    let too_large = gpu.device().limits().max_buffer_size + 4;
    let refused = block_on(gpu.guarded(|| Ok(gpu.buffer("too large", too_large, BufferUsages::STORAGE))));
    assert!(matches!(refused, Err(GpuError::Refused(_))), "{refused:?}");
    // What is reported outside of any scope is kept for the next call.
    gpu.buffer("too large", too_large, BufferUsages::STORAGE);
    let mut prober = Prober::new(gpu);
    let next = prober.probe(&surface, Sampling::Exact, &[ray()]);
    assert!(matches!(next, Err(GpuError::Refused(_))), "{next:?}");
    assert!(prober.probe(&surface, Sampling::Exact, &[ray()]).is_ok());
}

#[test]
fn nothing_to_draw_gives_an_empty_picture() {
    let Some(gpu) = software() else { return };
    let map = level_map();
    let mut renderer = GpuRenderer::new(gpu.clone());
    for job in [job(surface(&map)), Job { surfaces: Vec::new(), ..job(surface(&map)) }] {
        let told = Mutex::new(Vec::new());
        let tell = |_: &str, part: f32| told.lock().expect("a list").push(part);
        let picture = renderer.render(&job, Sampling::Exact, &Watch::telling(&tell));
        let picture = picture.expect("a picture");
        assert_eq!(picture.pixels.len(), 16 * 8);
        assert!(picture.pixels.iter().all(|pixel| pixel.hit == 0 && pixel.color.w == 0.0));
        assert_eq!(told.into_inner().expect("a list").last(), Some(&1.0));
    }
    for (width, height) in [(0, 8), (16, 0), (0, 0)] {
        let nothing = Job { width, height, ..job(surface(&map)) };
        let picture = renderer.render(&nothing, Sampling::Exact, &Watch::none()).expect("a picture");
        assert!(picture.pixels.is_empty() && [picture.width, picture.height] == [width, height]);
        let drawn = block_on(renderer.draw(&nothing, Sampling::Exact)).map(|_| ());
        assert_eq!(drawn, Err(GpuError::EmptyPicture));
    }
    assert_eq!(Prober::new(gpu).probe(&surface(&map), Sampling::Exact, &[]), Ok(Vec::new()));
}

#[test]
fn progress_grows_to_one_over_several_bands() {
    let Some(gpu) = software() else { return };
    let tall = Job { width: 700, height: 1000, ..job(surface(&level_map())) };
    let told = Mutex::new(Vec::new());
    let tell = |_: &str, part: f32| told.lock().expect("a list").push(part);
    let picture = GpuRenderer::new(gpu).render(&tall, Sampling::Exact, &Watch::telling(&tell));
    let told = told.into_inner().expect("a list");
    assert_eq!(picture.expect("a picture").pixels.len(), 700 * 1000);
    assert!(told.len() > 1 && told.is_sorted() && told.last() == Some(&1.0), "{told:?}");
}

#[test]
fn a_real_gpu_is_hardware_or_there_is_none() {
    match Gpu::new(AdapterChoice::Real) {
        Ok(gpu) => assert!(!gpu.description().to_lowercase().contains("llvmpipe"), "{}", gpu.description()),
        Err(GpuError::NoAdapter { wanted, .. }) => assert_eq!(wanted, AdapterChoice::Real),
        Err(error) => println!("skipped: {error}"),
    }
}

pub(super) fn hills(width: u32, height: u32, wrap: Wrap) -> Arc<HeightMap> {
    let texel = |i: u32, j: u32| ((i * 5 + j * 3) % 23) as f32 / 22.0;
    let map = HeightMap::from_fn(width, height, wrap, texel).expect("a valid map");
    Arc::new(map.with_displacement(0.06, -0.05).expect("proper numbers"))
}

fn mesh(mesh: Result<Mesh, relief_core::mesh::MeshError>, placement: Placement) -> Arc<Mesh> {
    Arc::new(mesh.and_then(|mesh| mesh.placed(&placement)).expect("a proper mesh"))
}

/// Three surfaces that pass through each other, of two maps and three methods, one of them seen from both
/// sides.
pub(super) fn three_surfaces() -> Vec<Surface> {
    let (one, other) = (hills(37, 21, Wrap::Repeat), hills(16, 24, Wrap::Mirror));
    let leaning = Placement { rotation_degrees: [70.0, 20.0, 0.0].into(), ..Placement::default() };
    let small = Placement { position_m: [0.2, 0.05, 0.1].into(), size: 0.8, ..Placement::default() };
    let with =
        |surface: Surface, method: &str| surface.with_selection(Selection::method(method).expect("a method"));
    vec![
        with(Surface::new(mesh(square(1), Placement::default()), Arc::clone(&one)), "relief"),
        with(Surface::new(mesh(square(1), leaning), other), "cone").with_two_sided(true),
        with(Surface::new(mesh(torus(32, 16), small), one), "frustum"),
    ]
}

pub(super) fn scene(surfaces: Vec<Surface>) -> Scene {
    let eye = DVec3::new(0.6, 0.9, 1.1);
    let camera = Camera::new(eye, DVec3::ZERO, 40.0).expect("a proper camera");
    let mut builder = Scene::builder(surfaces[0].clone()).size(90, 70).samples(1).camera(camera);
    // The planes do not go by what is there.
    let planes = DepthBuffer { near_m: Some(0.1), far_m: Some(10.0), ..DepthBuffer::default() };
    builder = builder.surfaces(surfaces).backend(BackendChoice::Cpu).depth_buffer(planes);
    builder.build().expect("a proper scene")
}

pub(super) fn rendered(renderer: &mut Renderer, scene: &Scene, maps: &mut Maps) -> Rendering {
    renderer.render(scene, maps, &Watch::none()).expect("a picture").rendering
}

/// The pictures of the surfaces apart, merged by depth; the first of equally near ones counts.
fn merged(pictures: &[Rendering]) -> Rendering {
    let mut all = pictures[0].clone();
    for picture in &pictures[1..] {
        for (pixel, other) in all.pixels.iter_mut().zip(&picture.pixels) {
            if other.hit == 1 && (pixel.hit == 0 || other.depth < pixel.depth) {
                *pixel = *other;
            }
        }
    }
    all
}

#[test]
fn several_surfaces_are_those_rendered_apart_and_merged_by_depth() {
    let gpu = software();
    let renderers = [Some(Renderer::on_cpu()), gpu.map(|gpu| Renderer::on_gpu(gpu, Sampling::Exact))];
    let mut pictures = Vec::new();
    for mut renderer in renderers.into_iter().flatten() {
        let mut maps = Maps::in_memory();
        let surfaces = three_surfaces();
        let together = rendered(&mut renderer, &scene(surfaces.clone()), &mut maps);
        let mut one_by_one: Vec<Rendering> = surfaces
            .iter()
            .map(|surface| rendered(&mut renderer, &scene(vec![surface.clone()]), &mut maps))
            .collect();
        // Their numbers are those in the whole scene.
        for (number, picture) in (0..).zip(&mut one_by_one) {
            picture.pixels.iter_mut().filter(|pixel| pixel.hit == 1).for_each(|pixel| pixel.surface = number);
        }
        let shown = one_by_one.iter().enumerate().map(|(number, picture)| {
            let same = together.pixels.iter().zip(&picture.pixels);
            (number, same.filter(|(all, one)| one.hit == 1 && all == one).count())
        });
        for (number, pixels) in shown {
            assert!(pixels > 300, "surface {number} is seen in {pixels} pixels");
        }
        // The rasteriser's planes enclose the whole scene, which moves its depths, not the hits.
        let merged = merged(&one_by_one);
        let other = together.pixels.iter().zip(&merged.pixels).filter(|(a, b)| a != b).count();
        assert!(other * 1000 <= merged.pixels.len(), "{other} pixels differ");
        pictures.push(together);
    }
    if let [cpu, gpu] = pictures.as_slice() {
        let other =
            cpu.pixels.iter().zip(&gpu.pixels).filter(|(a, b)| a.hit != b.hit || (a.t - b.t).abs() > 1e-5);
        let other = other.count();
        assert!(other * 200 <= cpu.pixels.len(), "{other} pixels differ between the backends");
    }
}

#[test]
fn of_equally_near_surfaces_the_first_is_seen() {
    let mut renderers = vec![Renderer::on_cpu()];
    renderers.extend(software().map(|gpu| Renderer::on_gpu(gpu, Sampling::Exact)));
    let surface = three_surfaces().swap_remove(0);
    let material = |brightness: f32| {
        relief_scene::material::Material::new(Vec3::splat(brightness), Vec3::ZERO, 1).expect("a material")
    };
    let (bright, dark) = (surface.clone().with_material(material(1.0)), surface.with_material(material(0.0)));
    for renderer in &mut renderers {
        let mut maps = Maps::in_memory();
        let alone = rendered(renderer, &scene(vec![bright.clone()]), &mut maps);
        assert_eq!(rendered(renderer, &scene(vec![bright.clone(), dark.clone()]), &mut maps), alone);
        assert_ne!(rendered(renderer, &scene(vec![dark.clone(), bright.clone()]), &mut maps), alone);
    }
}

#[test]
fn a_second_frame_uploads_a_camera_and_compiles_nothing() {
    let Some(gpu) = software() else { return };
    let mut renderer = Renderer::on_gpu(gpu, Sampling::Exact);
    let mut maps = Maps::in_memory();
    let mut scene = scene(three_surfaces());
    rendered(&mut renderer, &scene, &mut maps);
    let first = renderer.last_work();
    assert!(first.compiled >= 4 && first.uploaded > 10_000, "{first:?}");
    let still = rendered(&mut renderer, &scene, &mut maps);
    assert_eq!(renderer.last_work(), Work::default());

    scene.set_camera(Camera::new([0.7, 0.8, 1.0].into(), DVec3::ZERO, 40.0).expect("a camera"));
    let moved = rendered(&mut renderer, &scene, &mut maps);
    let second = renderer.last_work();
    assert!(second.compiled == 0 && (1..=1024).contains(&second.uploaded), "{second:?}");
    assert_ne!(moved, still);
    // What is kept is what a renderer that knows nothing makes.
    let fresh =
        rendered(&mut Renderer::on_gpu(software().expect("again"), Sampling::Exact), &scene, &mut maps);
    assert_eq!(moved, fresh);

    // Another material of one surface is another uniform, another height map that map.
    let [first, rest @ ..] = scene.surfaces() else { panic!("three surfaces") };
    let changed = first.clone().with_two_sided(false).with_height_map(hills(64, 64, Wrap::Repeat));
    let surfaces: Vec<Surface> = [changed].into_iter().chain(rest.iter().cloned()).collect();
    let changed = scene.to_builder().surfaces(surfaces).build().expect("a proper scene");
    rendered(&mut renderer, &changed, &mut maps);
    let third = renderer.last_work();
    assert!(third.compiled == 0 && (64 * 64 * 4..64 * 64 * 4 + 2048).contains(&third.uploaded), "{third:?}");
    // Fewer surfaces and another size are no reason to upload the others again.
    let fewer = changed.to_builder().surfaces(changed.surfaces()[..1].to_vec()).size(50, 40);
    rendered(&mut renderer, &fewer.build().expect("a proper scene"), &mut maps);
    assert!(renderer.last_work().uploaded <= 2048, "{:?}", renderer.last_work());
}

#[test]
fn maps_of_fewer_bits_give_the_same_exact_picture() {
    let Some(gpu) = software() else { return };
    let scene = scene(three_surfaces());
    let picture = |format| {
        let mut maps = Maps::in_memory().with_format(format);
        rendered(&mut Renderer::on_gpu(gpu.clone(), Sampling::Exact), &scene, &mut maps)
    };
    let full = picture(relief_core::MapFormat::F32);
    for format in [relief_core::MapFormat::F16, relief_core::MapFormat::Unorm8] {
        let fewer = picture(format);
        let other = full.pixels.iter().zip(&fewer.pixels);
        let other = other.filter(|(a, b)| a.hit != b.hit || (a.t - b.t).abs() > 1e-5).count();
        assert!(other * 500 <= full.pixels.len(), "{format:?}: {other} pixels differ");
        assert_ne!(full, fewer, "{format:?}: the reads are others");
    }
}

#[test]
fn a_picture_that_stays_on_the_gpu_has_the_colours_that_are_read_back() {
    let Some(gpu) = software() else { return };
    let base = scene(three_surfaces()).to_builder().size(300, 1000);
    let gradient = Background::Gradient([Vec3::new(0.1, 0.4, 0.9), Vec3::new(0.7, 0.2, 0.3)]);
    let mut renderer = GpuRenderer::new(gpu.clone());
    for background in [Background::Color(Vec3::new(0.1, 0.2, 0.3)), gradient, Background::Environment] {
        let scene = base.clone().background(background).build().expect("a proper scene");
        let (mut maps, mut preparer) = (Maps::in_memory(), crate::prepare::Preparer::default());
        preparer.provide(&scene, &mut maps, &|_| false, &Watch::none()).expect("a bake");
        let job = preparer.job(&scene, &Watch::none()).expect("a job");
        let rendered = renderer.render(&job, Sampling::Exact, &Watch::none()).expect("a picture");
        let expected = linear(&rendered, &scene);
        let picture = block_on(renderer.draw(&job, Sampling::Exact)).expect("a picture").clone();
        for (place, (given, wanted)) in texels(&gpu, &picture).iter().zip(expected).enumerate() {
            for (given, wanted) in given.iter().zip(wanted) {
                let is_near = (given - wanted).abs() <= 1e-3 * wanted.abs() + 1e-4;
                assert!(is_near, "{background}, {}, {}: {given} for {wanted}", place % 300, place / 300);
            }
            assert_eq!(given[3], 1.0);
        }
    }
}

/// The texels of a picture of 16-bit floats, row by row.
fn texels(gpu: &Gpu, picture: &wgpu::Texture) -> Vec<[f32; 4]> {
    let size = picture.size();
    let row = (size.width * 8).next_multiple_of(256);
    let usage = BufferUsages::COPY_DST | BufferUsages::MAP_READ;
    let buffer = gpu.buffer("to read", u64::from(row) * u64::from(size.height), usage);
    let mut encoder = gpu.device().create_command_encoder(&Default::default());
    let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(row), rows_per_image: None };
    let into = wgpu::TexelCopyBufferInfo { buffer: &buffer, layout };
    encoder.copy_texture_to_buffer(picture.as_image_copy(), into, size);
    gpu.queue().submit([encoder.finish()]);
    let mut bytes = Vec::new();
    block_on(gpu.read(&buffer, buffer.size(), |read| bytes.extend_from_slice(read))).expect("it is read");
    let half = |at: &[u8; 2]| relief_core::encoding::half::value(u16::from_le_bytes(*at));
    let rows = bytes.chunks(row as usize).map(|row| row.as_chunks::<8>().0);
    let texels = rows.flat_map(|texels| texels.iter().take(size.width as usize));
    texels
        .map(|texel| {
            let parts = texel.as_chunks::<2>().0;
            [0, 1, 2, 3].map(|at| half(&parts[at]))
        })
        .collect()
}

#[test]
fn a_callers_error_handlers_are_his_own() {
    let Some(gpu) = own(Limits::downlevel_defaults()) else { return };
    let told = Arc::new(Mutex::new(0));
    let noted = Arc::clone(&told);
    gpu.device().on_uncaptured_error(Arc::new(move |_| *noted.lock().expect("no panic") += 1));
    // Errors of this work are results; the caller's handler receives none.
    let limit = gpu.device().limits().max_texture_dimension_2d;
    let too_large = gpu.device().limits().max_buffer_size + 4;
    let refused = block_on(gpu.guarded(|| Ok(gpu.buffer("too large", too_large, BufferUsages::STORAGE))));
    assert!(matches!(refused, Err(GpuError::Refused(_))), "{refused:?}");
    let mut renderer = GpuRenderer::new(gpu.clone());
    let wide = Job { width: limit + 1, ..job(surface(&level_map())) };
    assert!(renderer.render(&wide, Sampling::Exact, &Watch::none()).is_err());
    assert_eq!(*told.lock().expect("no panic"), 0);
    // What the caller does himself is.
    gpu.buffer("too large", too_large, BufferUsages::STORAGE);
    assert_eq!(*told.lock().expect("no panic"), 1);
    assert!(renderer.render(&job(surface(&level_map())), Sampling::Exact, &Watch::none()).is_ok());
}

#[test]
fn the_cpu_keeps_its_hierarchies_as_long_as_they_are_needed() {
    let (mut maps, mut preparer) = (Maps::in_memory(), crate::prepare::Preparer::default());
    let exact = three_surfaces().into_iter().map(|surface| surface.with_selection(Selection::exact()));
    let scene = scene(exact.collect());
    let mut renderer = CpuRenderer::new();
    let mut jobs = || {
        preparer.provide(&scene, &mut maps, &|_| false, &Watch::none()).expect("a bake");
        preparer.job(&scene, &Watch::none()).expect("a job")
    };
    let first = renderer.render(&jobs(), &Watch::none());
    let kept = format!("{:?}", renderer.cached());
    assert_eq!(renderer.render(&jobs(), &Watch::none()), first);
    assert_eq!(format!("{:?}", renderer.cached()), kept);
    // Two surfaces share a height map, and so its hierarchy.
    assert_eq!(renderer.cached().map(|list| list.len()), [3, 2]);
    renderer.render(&Job { surfaces: Vec::new(), ..jobs() }, &Watch::none()).expect("a picture");
    assert_eq!(renderer.cached().map(|list| list.len()), [0, 0]);
}
