//! What does not go well, on a software adapter.

use std::cell::RefCell;

use relief_core::{HeightMap, Wrap};
use relief_shaders::cpu::{Corner, PixelIn, Settings, Triangle};
use relief_shaders::{Selection, SlotMaps};
use wgpu::BufferUsages;

use super::{AdapterChoice, Gpu, GpuError, Sampling};
use crate::job::{Job, TexelMap};

/// A software GPU of the test's own. Without one the test says that it skips, unless the environment variable
/// `RELIEF_REQUIRE_GPU` is 1: then it fails.
fn software() -> Option<Gpu> {
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

fn level_map() -> HeightMap {
    HeightMap::from_fn(4, 4, Wrap::Repeat, |_, _| 0.5).expect("a valid map")
}

fn job<'a>(map: &'a HeightMap, triangles: &'a [Triangle]) -> Job<'a> {
    let selection = Selection::method("relief").expect("a method");
    Job {
        width: 16,
        height: 8,
        settings: Settings::tracing(map, &selection, &SlotMaps::default()),
        triangles,
        view_projection: [[0.0; 4]; 4],
        height_map: map,
        color_map: None,
        normal_map: None,
        maps: SlotMaps::default(),
        two_sided: false,
    }
}

fn ray() -> PixelIn {
    let corner =
        |x: f32, z: f32| Corner::new([x, 0.0, z], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [x, z]);
    PixelIn::new(
        [0.0, 3.0, 0.0],
        [0.0, -1.0, 0.0],
        1.0,
        corner(-1.0, -1.0),
        corner(0.0, 1.0),
        corner(1.0, -1.0),
    )
}

#[test]
fn a_lost_device_is_an_error_from_then_on() {
    let Some(gpu) = software() else { return };
    let map = level_map();
    let job = job(&map, &[]);
    assert_eq!(gpu.probe(&job, Sampling::Exact, &[ray()]).map(|probes| probes[0].found), Ok(1));
    gpu.device.destroy();
    for _ in 0..2 {
        let rendered = gpu.render(&job, Sampling::Exact, &|_| ()).map(|_| ());
        assert!(matches!(rendered, Err(GpuError::Lost(_))), "{rendered:?}");
        let probed = gpu.probe(&job, Sampling::Exact, &[ray()]).map(|_| ());
        assert!(matches!(probed, Err(GpuError::Lost(_))), "{probed:?}");
    }
}

#[test]
fn what_does_not_fit_is_refused_by_name() {
    let Some(gpu) = software() else { return };
    let map = level_map();
    let fits = job(&map, &[]);
    let render = |job: &Job| gpu.render(job, Sampling::Exact, &|_| ()).map(|_| ());
    let limit = gpu.device.limits().max_texture_dimension_2d;
    let wide = Job { width: limit + 1, ..job(&map, &[]) };
    let what = "picture";
    assert_eq!(render(&wide), Err(GpuError::TooLarge { what, width: limit + 1, height: 8, limit }));

    let texels = vec![[0.0; 4]; limit as usize + 1];
    let long = TexelMap { width: 1, height: limit + 1, texels: &texels };
    let what = "colour map";
    let colored = Job { color_map: Some(long), ..job(&map, &[]) };
    assert_eq!(render(&colored), Err(GpuError::TooLarge { what, width: 1, height: limit + 1, limit }));

    let short = TexelMap { width: 3, height: 2, texels: &texels[..5] };
    let what = "normal map";
    let bent = Job { normal_map: Some(short), ..job(&map, &[]) };
    assert_eq!(render(&bent), Err(GpuError::WrongLength { what, width: 3, height: 2, given: 5 }));
    let empty = Job { normal_map: Some(TexelMap { width: 0, height: 0, texels: &[] }), ..job(&map, &[]) };
    assert_eq!(render(&empty), Err(GpuError::WrongLength { what, width: 0, height: 0, given: 0 }));

    assert_eq!(render(&fits), Ok(()));
}

#[test]
fn refused_commands_are_errors_and_the_gpu_goes_on() {
    let Some(gpu) = software() else { return };
    let map = level_map();
    let too_large = gpu.device.limits().max_buffer_size + 4;
    let refused = gpu.guarded(|| Ok(gpu.buffer("too large", too_large, BufferUsages::STORAGE)));
    assert!(matches!(refused, Err(GpuError::Refused(_))), "{refused:?}");
    // What is reported outside of any scope is kept for the next call.
    gpu.buffer("too large", too_large, BufferUsages::STORAGE);
    let next = gpu.probe(&job(&map, &[]), Sampling::Exact, &[ray()]);
    assert!(matches!(next, Err(GpuError::Refused(_))), "{next:?}");
    assert!(gpu.probe(&job(&map, &[]), Sampling::Exact, &[ray()]).is_ok());
}

#[test]
fn nothing_to_draw_gives_an_empty_picture() {
    let Some(gpu) = software() else { return };
    let map = level_map();
    let told = RefCell::new(Vec::new());
    let picture = gpu.render(&job(&map, &[]), Sampling::Exact, &|part| {
        told.borrow_mut().push(part);
    });
    let picture = picture.expect("a picture");
    assert_eq!(picture.pixels.len(), 16 * 8);
    assert!(picture.pixels.iter().all(|pixel| pixel.hit == 0 && pixel.color.w == 0.0));
    assert_eq!(told.into_inner().last(), Some(&1.0));
    for (width, height) in [(0, 8), (16, 0), (0, 0)] {
        let nothing = Job { width, height, ..job(&map, &[]) };
        let picture = gpu.render(&nothing, Sampling::Exact, &|_| ()).expect("a picture");
        assert!(picture.pixels.is_empty() && [picture.width, picture.height] == [width, height]);
    }
    assert_eq!(gpu.probe(&job(&map, &[]), Sampling::Exact, &[]), Ok(Vec::new()));
}

#[test]
fn progress_grows_to_one_over_several_bands() {
    let Some(gpu) = software() else { return };
    let map = level_map();
    let tall = Job { width: 700, height: 1000, ..job(&map, &[]) };
    let told = RefCell::new(Vec::new());
    let picture =
        gpu.render(&tall, Sampling::Exact, &|part| told.borrow_mut().push(part)).expect("a picture");
    let told = told.into_inner();
    assert_eq!(picture.pixels.len(), 700 * 1000);
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
