//! Cost of a moving camera: displaced triangles that are made anew for each picture.

use std::time::Instant;

use comfy_table::Table;
use glam::DQuat;
use relief_core::Watch;
use relief_core::camera::{Camera, Projection};
use relief_maps::Maps;
use relief_render::Renderer;
use relief_scene::{BackendChoice, Sampling, Scene, Surface};
use relief_shaders::Selection;

use crate::samples::Samples;
use crate::surfaces::bases::{Base, cobbles};

/// Pictures of each; the median counts.
const ROUNDS: u16 = 7;

/// Methods, and what is set of them.
const METHODS: [(&str, &[(&str, f64)]); 3] =
    [("remesh", &[]), ("tessellate", &[]), ("tessellate", &[("geometry.interior", 1.0)])];

/// A row a backend and method.
pub fn table(width: u32) -> Result<Table, String> {
    let mut rows = crate::table::table(&[
        "backend",
        "method",
        "the camera moved, ms",
        "it stayed, ms",
        "made anew, ms",
        "uploaded, bytes",
    ]);
    for choice in [BackendChoice::Cpu, BackendChoice::Gpu] {
        let renderer = Renderer::new(choice, Sampling::Exact);
        let mut renderer = renderer.map_err(|error| error.to_string())?;
        for (method, settings) in METHODS {
            rows.add_row(row(&mut renderer, method, settings, [width, width * 3 / 4])?);
        }
    }
    Ok(rows)
}

fn row(
    renderer: &mut Renderer,
    method: &str,
    settings: &[(&str, f64)],
    size: [u32; 2],
) -> Result<Vec<String>, String> {
    let scene = scene(method, settings, size)?;
    let mut maps = Maps::in_memory();
    let mut taken = |scene: &Scene, renderer: &mut Renderer| {
        let started = Instant::now();
        let rendered =
            renderer.render(scene, &mut maps, &Watch::none()).map_err(|error| error.to_string())?;
        Ok::<_, String>((1e3 * started.elapsed().as_secs_f64(), rendered.info.device))
    };
    let (_, device) = taken(&scene, renderer)?;
    let (mut moved, mut stayed, mut made, mut uploaded) =
        (Samples::default(), Samples::default(), Samples::default(), 0);
    for round in 0..ROUNDS {
        let camera = scene.camera();
        let turn = DQuat::from_rotation_y(0.02 * f64::from(round + 1));
        let eye = camera.target() + turn * (camera.eye() - camera.target());
        let camera = camera.moved(eye, camera.target()).map_err(|error| error.to_string())?;
        let mut seen = scene.clone();
        seen.set_camera(camera);
        let (other, _) = taken(&seen, renderer)?;
        uploaded = uploaded.max(renderer.last_work().uploaded);
        let (same, _) = taken(&seen, renderer)?;
        moved.push(other);
        stayed.push(same);
        made.push(other - same);
    }
    let set = settings.iter().map(|(key, value)| {
        let value = Selection::name_of(key, *value).map_or_else(|| value.to_string(), str::to_owned);
        format!(" {key}={value}")
    });
    let method = set.fold(method.to_owned(), |method, set| method + &set);
    let cells = [device, method, moved.to_string(), stayed.to_string(), made.to_string()];
    Ok(cells.into_iter().chain([uploaded.to_string()]).collect())
}

/// Cobbles on a torus, without shadows, one sample a pixel.
fn scene(method: &str, settings: &[(&str, f64)], size: [u32; 2]) -> Result<Scene, String> {
    let text = |error: &dyn std::fmt::Display| error.to_string();
    let torus = Base::of("torus-32x16")?.ok_or("there is no torus")?.mesh;
    let map = cobbles()?.with_displacement(0.03, 0.0).map_err(|error| text(&error))?;
    let mut selection = Selection::method(method).map_err(|error| text(&error))?;
    selection.choose("shadow", "none").map_err(|error| text(&error))?;
    for (key, value) in settings {
        selection.set(key, *value).map_err(|error| text(&error))?;
    }
    let projection = Projection::Perspective { fov_degrees: 40.0 };
    let camera = Camera::with([0.3, 0.9, 1.5].into(), [0.2, 0.05, 0.25].into(), projection);
    let builder = Scene::builder(Surface::new(torus, map).with_selection(selection));
    let builder = builder.camera(camera.map_err(|error| text(&error))?).size(size[0], size[1]).samples(1);
    builder.build().map_err(|error| text(&error))
}
