//! Draws the kit's mesh with its material, whose shader says hits as colours, and
//! writes the picture's numbers.

mod relief;
mod relief_functions;
mod relief_model;

use std::time::Duration;

use bevy::app::ScheduleRunnerPlugin;
use bevy::camera::{Hdr, RenderTarget};
use bevy::core_pipeline::tonemapping::{DebandDither, Tonemapping};
use bevy::prelude::*;
use bevy::render::RenderPlugin;
use bevy::render::render_resource::TextureFormat;
use bevy::render::view::screenshot::{Screenshot, ScreenshotCaptured};
use bevy::window::ExitCondition;
use bevy::winit::WinitPlugin;

use crate::relief::{ATTRIBUTE_CURVATURE, ATTRIBUTE_TILE, ReliefMaterial, ReliefPlugin, gltf_plugin};
use crate::relief_model::{are_read, material, mesh};

/// Frames between the last file that is read and the picture.
const FRAMES: u32 = 8;

#[derive(Resource)]
struct Job {
    target: Handle<Image>,
    mesh: Handle<Mesh>,
    /// Whether the mesh keeps its own frames.
    frames: bool,
    file: String,
    frame: u32,
}

fn main() -> AppExit {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |place: usize| -> f32 { arguments[place].parse().expect("a number") };
    let [width, height, fov] = [0, 1, 2].map(number);
    let eye = Vec3::new(number(3), number(4), number(5));
    let frames = arguments[6] == "frames";
    let file = arguments[7].clone();
    let mut app = App::new();
    let window =
        WindowPlugin { primary_window: None, exit_condition: ExitCondition::DontExit, ..default() };
    let render = RenderPlugin { synchronous_pipeline_compilation: true, ..default() };
    let plugins = DefaultPlugins
        .set(AssetPlugin { file_path: ".".to_owned(), ..default() })
        .set(gltf_plugin())
        .set(window)
        .set(render)
        .disable::<WinitPlugin>();
    app.add_plugins(plugins)
        .add_plugins(ScheduleRunnerPlugin::run_loop(Duration::from_millis(5)))
        .add_plugins(ReliefPlugin)
        .insert_resource(ClearColor(Color::linear_rgba(0.0, 0.0, 0.0, 0.0)))
        .add_systems(Update, take_picture);
    let target = Image::new_target_texture(width as u32, height as u32, TextureFormat::Rgba32Float, None);
    let target = app.world_mut().resource_mut::<Assets<Image>>().add(target);
    let files = app.world().resource::<AssetServer>().clone();
    let mesh = mesh(&files);
    let shown = app.world_mut().resource_mut::<Assets<ReliefMaterial>>().add(material(&files));
    app.world_mut().spawn((Mesh3d(mesh.clone()), MeshMaterial3d(shown)));
    app.world_mut().spawn((
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
        Transform::from_translation(eye).looking_at(Vec3::ZERO, Vec3::Y),
    ));
    app.insert_resource(Job { target, mesh, frames, file, frame: 0 }).run()
}

fn take_picture(
    mut commands: Commands,
    mut job: ResMut<Job>,
    mut meshes: ResMut<Assets<Mesh>>,
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
    job.frame += 1;
    if job.frame == 1 && !job.frames && let Some(mut mesh) = meshes.get_mut(&job.mesh) {
        mesh.remove_attribute(Mesh::ATTRIBUTE_TANGENT);
        mesh.remove_attribute(ATTRIBUTE_TILE);
        mesh.remove_attribute(ATTRIBUTE_CURVATURE);
    }
    if job.frame == FRAMES {
        let file = job.file.clone();
        commands.spawn(Screenshot::image(job.target.clone())).observe(
            move |captured: On<ScreenshotCaptured>, mut exit: MessageWriter<AppExit>| {
                let bytes = captured.image.data.as_deref().unwrap_or_default();
                std::fs::write(&file, bytes).expect("the file is writable");
                exit.write(AppExit::Success);
            },
        );
    }
}
