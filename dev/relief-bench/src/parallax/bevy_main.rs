//! Draws the kit's plane with Bevy's own parallax mapping and with the kit's material, from several
//! places. Unlit textures whose colours are coordinates say where each ray ends. Writes all pictures, and
//! then the times of frames.

mod relief;
mod relief_functions;
mod relief_model;

use std::time::{Duration, Instant};

use bevy::app::ScheduleRunnerPlugin;
use bevy::asset::RenderAssetUsages;
use bevy::camera::{Hdr, RenderTarget};
use bevy::core_pipeline::tonemapping::{DebandDither, Tonemapping};
use bevy::image::{ImageAddressMode, ImageSampler, ImageSamplerDescriptor};
use bevy::pbr::ParallaxMappingMethod;
use bevy::prelude::*;
use bevy::render::RenderPlugin;
use bevy::render::render_resource::{Extent3d, TextureDimension, TextureFormat};
use bevy::render::view::screenshot::{Screenshot, ScreenshotCaptured};
use bevy::window::ExitCondition;
use bevy::winit::WinitPlugin;

use crate::relief::{ReliefMaterial, ReliefPlugin, gltf_plugin};
use crate::relief_model::{are_read, material, mesh};

/// Frames before times are taken, and frames that are timed.
const WARM: u32 = 4;
const TIMED: u32 = 9;

/// Columns of the textures of coordinates.
const COLUMNS: u32 = 2048;

/// Rises and falls of the fine part over a tile, and how far the second is ahead, as the reader has them.
const FINE: f32 = 32.0;
const AHEAD: f32 = 0.5;

#[derive(Resource)]
struct Job {
    target: Handle<Image>,
    /// The entities of a way: one that shows u, one that shows v.
    ways: Vec<[Entity; 2]>,
    camera: Entity,
    eyes: Vec<Vec3>,
    file: String,
    at: usize,
    frame: u32,
    before: Instant,
    times: Vec<f64>,
    medians: Vec<f64>,
    bytes: Vec<u8>,
    is_waiting: bool,
}

fn main() -> AppExit {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |text: &str| -> f32 { text.parse().expect("a number") };
    let [width, height, fov, scale] = [0, 1, 2, 3].map(|place: usize| number(&arguments[place]));
    let (file, heights) = (arguments[4].clone(), arguments[5].clone());
    let eyes: Vec<Vec3> = arguments[6..]
        .iter()
        .map(|eye| {
            let numbers: Vec<f32> = eye.split(',').map(number).collect();
            Vec3::new(numbers[0], numbers[1], numbers[2])
        })
        .collect();
    let mut app = App::new();
    let window = WindowPlugin { primary_window: None, exit_condition: ExitCondition::DontExit, ..default() };
    let plugins = DefaultPlugins
        .set(AssetPlugin { file_path: ".".to_owned(), ..default() })
        .set(gltf_plugin())
        .set(window)
        .set(RenderPlugin { synchronous_pipeline_compilation: true, ..default() })
        .disable::<WinitPlugin>();
    app.add_plugins(plugins)
        .add_plugins(ScheduleRunnerPlugin::run_loop(Duration::ZERO))
        .add_plugins(ReliefPlugin)
        .insert_resource(ClearColor(Color::linear_rgba(0.0, 0.0, 0.0, 0.0)))
        .add_systems(Update, draw);
    let world = app.world_mut();
    let files = world.resource::<AssetServer>().clone();
    let target = Image::new_target_texture(width as u32, height as u32, TextureFormat::Rgba32Float, None);
    let mut images = world.resource_mut::<Assets<Image>>();
    let target = images.add(target);
    let shown = [images.add(coordinates(true)), images.add(coordinates(false))];
    let depths = images.add(depths(&std::fs::read(&heights).expect("the depths")));
    let mesh = mesh(&files);
    let mut ways = Vec::new();
    // Bevy's own: without depths, and two methods with several numbers of layers.
    let mut own: Vec<(f32, ParallaxMappingMethod)> = vec![(0.0, ParallaxMappingMethod::Occlusion)];
    for method in [ParallaxMappingMethod::Occlusion, ParallaxMappingMethod::Relief { max_steps: 5 }] {
        own.extend([8.0, 16.0, 32.0, 64.0].map(|layers| (layers, method)));
    }
    for (layers, method) in own {
        ways.push([0, 1].map(|axis: usize| {
            let material = StandardMaterial {
                unlit: true,
                base_color_texture: Some(shown[axis].clone()),
                depth_map: (layers > 0.0).then(|| depths.clone()),
                parallax_depth_scale: scale,
                max_parallax_layer_count: layers,
                parallax_mapping_method: method,
                ..default()
            };
            let material = world.resource_mut::<Assets<StandardMaterial>>().add(material);
            world.spawn((Mesh3d(mesh.clone()), MeshMaterial3d(material), Visibility::Hidden)).id()
        }));
    }
    ways.push([0, 1].map(|axis: usize| {
        let mut ours: ReliefMaterial = material(&files);
        ours.base =
            StandardMaterial { unlit: true, base_color_texture: Some(shown[axis].clone()), ..default() };
        let ours = world.resource_mut::<Assets<ReliefMaterial>>().add(ours);
        world.spawn((Mesh3d(mesh.clone()), MeshMaterial3d(ours), Visibility::Hidden)).id()
    }));
    let camera = world.spawn((
        Camera3d::default(),
        Hdr,
        Msaa::Off,
        Tonemapping::None,
        DebandDither::Disabled,
        RenderTarget::Image(target.clone().into()),
        Projection::from(PerspectiveProjection {
            fov: fov.to_radians(),
            near: 0.01,
            far: 100.0,
            ..default()
        }),
        Transform::default(),
    ));
    let camera = camera.id();
    app.insert_resource(Job {
        target,
        ways,
        camera,
        eyes,
        file,
        at: 0,
        frame: 0,
        before: Instant::now(),
        times: Vec::new(),
        medians: Vec::new(),
        bytes: Vec::new(),
        is_waiting: false,
    })
    .run()
}

/// A texture whose colours are a coordinate: it rises over the tile; it rises and falls; the same, ahead.
fn coordinates(is_of_u: bool) -> Image {
    let mut bytes = Vec::new();
    for column in 0..COLUMNS {
        let along = (column as f32 + 0.5) / COLUMNS as f32;
        let fine = |ahead: f32| 1.0 - ((FINE * along + ahead).rem_euclid(2.0) - 1.0).abs();
        for part in [along, fine(0.0), fine(AHEAD), 1.0] {
            bytes.extend(half(part).to_le_bytes());
        }
    }
    let (width, height) = if is_of_u { (COLUMNS, 1) } else { (1, COLUMNS) };
    image_of(width, height, bytes, TextureFormat::Rgba16Float)
}

/// A number from 0 to 1 in 16 bits.
fn half(number: f32) -> u16 {
    let bits = number.to_bits();
    let exponent = ((bits >> 23) & 0xff) as i32 - 112;
    if exponent <= 0 {
        // Less than any difference that is read.
        return 0;
    }
    // Rounded; a mantissa that overflows raises the exponent, as it should.
    (((exponent as u32) << 10) + (((bits & 0x7f_ffff) + 0x1000) >> 13)) as u16
}

/// The depths: columns, rows, and a byte each.
fn depths(bytes: &[u8]) -> Image {
    let size = |place: usize| u32::from_le_bytes(bytes[place..place + 4].try_into().expect("four bytes"));
    image_of(size(0), size(4), bytes[8..].to_vec(), TextureFormat::R8Unorm)
}

fn image_of(width: u32, height: u32, bytes: Vec<u8>, format: TextureFormat) -> Image {
    let size = Extent3d { width, height, depth_or_array_layers: 1 };
    let mut image = Image::new(size, TextureDimension::D2, bytes, format, RenderAssetUsages::RENDER_WORLD);
    image.sampler = ImageSampler::Descriptor(ImageSamplerDescriptor {
        address_mode_u: ImageAddressMode::Repeat,
        address_mode_v: ImageAddressMode::Repeat,
        ..ImageSamplerDescriptor::linear()
    });
    image
}

fn draw(
    mut commands: Commands,
    mut job: ResMut<Job>,
    mut seen: Query<&mut Visibility>,
    mut places: Query<&mut Transform>,
    files: Res<AssetServer>,
    mut exit: MessageWriter<AppExit>,
) {
    let is_read = are_read(&files);
    if is_read.is_none() {
        exit.write(AppExit::error());
    }
    if is_read != Some(true) || job.is_waiting {
        return;
    }
    let job = &mut *job;
    let phases = 2 * job.ways.len() * job.eyes.len();
    if job.at == phases {
        let times: Vec<String> = job.medians.iter().map(|time| format!("{time:?}")).collect();
        let mut all = std::mem::take(&mut job.bytes);
        all.extend(format!("[{}]", times.join(",")).into_bytes());
        std::fs::write(&job.file, all).expect("the file is writable");
        exit.write(AppExit::Success);
        return;
    }
    let (axis, way) = (job.at % 2, job.at / 2 % job.ways.len());
    let now = Instant::now();
    if job.frame == 0 {
        for (number, pair) in job.ways.iter().enumerate() {
            for (of, entity) in pair.iter().enumerate() {
                let is_shown = number == way && of == axis;
                if let Ok(mut visibility) = seen.get_mut(*entity) {
                    *visibility = if is_shown { Visibility::Visible } else { Visibility::Hidden };
                }
            }
        }
        let eye = job.eyes[job.at / 2 / job.ways.len()];
        if let Ok(mut place) = places.get_mut(job.camera) {
            *place = Transform::from_translation(eye).looking_at(Vec3::ZERO, Vec3::Y);
        }
        job.times.clear();
    } else if job.frame > WARM {
        job.times.push((now - job.before).as_secs_f64());
    }
    job.before = now;
    job.frame += 1;
    if job.frame > WARM + TIMED {
        job.times.sort_by(f64::total_cmp);
        job.medians.push(job.times[job.times.len() / 2]);
        job.is_waiting = true;
        commands.spawn(Screenshot::image(job.target.clone())).observe(
            |captured: On<ScreenshotCaptured>, mut job: ResMut<Job>| {
                let bytes = captured.image.data.as_deref().unwrap_or_default();
                job.bytes.extend_from_slice(bytes);
                job.at += 1;
                job.frame = 0;
                job.is_waiting = false;
            },
        );
    }
}
