//! A mesh with a relief, in Bevy. Drag turns it, the wheel comes nearer. `-- --picture FILE.png` writes a
//! picture without a window.
//!
//! SPDX-License-Identifier: MIT OR Apache-2.0

mod relief;
mod relief_functions;
mod relief_model;

use std::path::PathBuf;
use std::time::Duration;

use bevy::app::ScheduleRunnerPlugin;
use bevy::camera::RenderTarget;
use bevy::image::{ImageAddressMode, ImagePlugin, ImageSamplerDescriptor};
use bevy::input::mouse::{AccumulatedMouseMotion, AccumulatedMouseScroll};
use bevy::light::CascadeShadowConfigBuilder;
use bevy::prelude::*;
use bevy::render::RenderPlugin;
use bevy::render::render_resource::TextureFormat;
use bevy::render::view::screenshot::{Screenshot, ScreenshotCaptured, save_to_disk};
use bevy::window::ExitCondition;
use bevy::winit::WinitPlugin;

use crate::relief::{ReliefMaterial, ReliefPlugin, gltf_plugin};
use crate::relief_model::{CENTER, HEIGHT, RADIUS, are_read, material, mesh};

/// The direction from the middle to the camera, and to the sun.
const CAMERA: Vec3 = Vec3::new(0.6, 0.7, 1.0);
const SUN: Vec3 = Vec3::new(-0.8, 0.9, 0.7);

/// Frames between the last file that is read and a picture without a window.
const FRAMES: u32 = 8;

/// Where a picture goes.
#[derive(Resource, Clone)]
struct Picture {
    file: PathBuf,
    target: Handle<Image>,
    frame: u32,
}

fn main() -> AppExit {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let picture = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => None,
        ["--picture", file] => Some(PathBuf::from(file)),
        _ => {
            eprintln!("relief-bevy [--picture FILE.png]");
            return AppExit::from_code(2);
        }
    };
    // Relief is repeated, and so are its colours.
    let sampler = ImageSamplerDescriptor {
        address_mode_u: ImageAddressMode::Repeat,
        address_mode_v: ImageAddressMode::Repeat,
        ..ImageSamplerDescriptor::linear()
    };
    let plugins = DefaultPlugins
        .set(AssetPlugin { file_path: ".".to_owned(), ..default() })
        .set(ImagePlugin { default_sampler: sampler })
        .set(gltf_plugin());
    let mut app = App::new();
    match &picture {
        None => app.add_plugins(plugins).add_systems(Update, turn),
        Some(_) => {
            let window = WindowPlugin {
                primary_window: None,
                exit_condition: ExitCondition::DontExit,
                ..default()
            };
            // A frame waits for its pipelines.
            let render = RenderPlugin { synchronous_pipeline_compilation: true, ..default() };
            app.add_plugins(plugins.set(window).set(render).disable::<WinitPlugin>())
                .add_plugins(ScheduleRunnerPlugin::run_loop(Duration::from_millis(5)))
                .add_systems(Update, take_picture)
        }
    };
    if let Some(file) = picture {
        let target = Image::new_target_texture(1280, 960, TextureFormat::Rgba8UnormSrgb, None);
        let target = app.world_mut().resource_mut::<Assets<Image>>().add(target);
        app.insert_resource(Picture { file, target, frame: 0 });
    }
    app.add_plugins(ReliefPlugin)
        .insert_resource(ClearColor(Color::srgb(0.5, 0.6, 0.7)))
        .insert_resource(GlobalAmbientLight { brightness: 700.0, ..default() })
        .add_systems(Startup, set_up)
        .run()
}

fn set_up(
    mut commands: Commands,
    files: Res<AssetServer>,
    mut meshes: ResMut<Assets<Mesh>>,
    mut plain: ResMut<Assets<StandardMaterial>>,
    mut reliefs: ResMut<Assets<ReliefMaterial>>,
    picture: Option<Res<Picture>>,
) {
    commands.spawn((Mesh3d(mesh(&files)), MeshMaterial3d(reliefs.add(material(&files)))));
    // A floor for the shadow of what stands on it.
    if HEIGHT > 0.1 * RADIUS {
        commands.spawn((
            Mesh3d(meshes.add(Plane3d::new(Vec3::Y, Vec2::splat(3.0 * RADIUS)))),
            MeshMaterial3d(plain.add(StandardMaterial {
                perceptual_roughness: 1.0,
                ..Color::srgb(0.6, 0.6, 0.6).into()
            })),
            Transform::from_translation(CENTER - Vec3::Y * (HEIGHT / 2.0)),
        ));
    }
    commands.spawn((
        DirectionalLight { illuminance: 8_000.0, shadow_maps_enabled: true, ..default() },
        Transform::from_translation(SUN).looking_at(Vec3::ZERO, Vec3::Y),
        CascadeShadowConfigBuilder {
            num_cascades: 1,
            first_cascade_far_bound: 8.0 * RADIUS,
            maximum_distance: 8.0 * RADIUS,
            minimum_distance: 0.01 * RADIUS,
            ..default()
        }
        .build(),
    ));
    let place = CENTER + CAMERA.normalize() * (3.2 * RADIUS);
    let mut camera = commands.spawn((
        Camera3d::default(),
        Projection::from(PerspectiveProjection {
            fov: 40_f32.to_radians(),
            near: 0.01 * RADIUS,
            far: 100.0 * RADIUS,
            ..default()
        }),
        Transform::from_translation(place).looking_at(CENTER, Vec3::Y),
    ));
    if let Some(picture) = picture {
        camera.insert(RenderTarget::Image(picture.target.clone().into()));
    }
}

/// Turns the camera around the middle.
fn turn(
    mut cameras: Query<&mut Transform, With<Camera3d>>,
    buttons: Res<ButtonInput<MouseButton>>,
    motion: Res<AccumulatedMouseMotion>,
    wheel: Res<AccumulatedMouseScroll>,
) {
    for mut camera in &mut cameras {
        let away = camera.translation - CENTER;
        let mut turned = away;
        if buttons.pressed(MouseButton::Left) {
            let aside = Quat::from_rotation_y(-0.006 * motion.delta.x);
            let up = Quat::from_axis_angle(*camera.right(), -0.006 * motion.delta.y);
            turned = aside * up * away;
            // Not over the pole.
            if turned.normalize().y.abs() > 0.99 {
                turned = aside * away;
            }
        }
        turned *= (-0.1 * wheel.delta.y.clamp(-3.0, 3.0)).exp();
        *camera = Transform::from_translation(CENTER + turned).looking_at(CENTER, Vec3::Y);
    }
}

/// Takes the picture when all is there, and ends.
fn take_picture(
    mut commands: Commands,
    mut picture: ResMut<Picture>,
    files: Res<AssetServer>,
    mut exit: MessageWriter<AppExit>,
) {
    let is_read = are_read(&files);
    if is_read.is_none() {
        exit.write(AppExit::error());
    }
    if is_read != Some(true) {
        return;
    }
    picture.frame += 1;
    if picture.frame == FRAMES {
        commands
            .spawn(Screenshot::image(picture.target.clone()))
            .observe(save_to_disk(picture.file.clone()))
            .observe(|_: On<ScreenshotCaptured>, mut exit: MessageWriter<AppExit>| {
                exit.write(AppExit::Success);
            });
    }
}
