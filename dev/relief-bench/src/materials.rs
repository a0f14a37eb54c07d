//! `materials`: the time of a frame shaded by `metallic-roughness` with its maps, beside one shaded by
//! `blinn-phong` with a colour map.

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use relief_core::Watch;
use relief_maps::Maps;
use relief_render::Renderer;
use relief_scene::{BackendChoice, Look, PictureSize, Sampling, Scene, SceneSpec, SurfaceSpec};

use crate::samples::Samples;
use crate::table::table;

/// How many times the time of `blinn-phong` a frame with colours and the packed map may take.
const BOUND: f64 = 1.3;

/// Arguments of `materials`.
#[derive(Args)]
pub struct Arguments {
    /// Where frames are made
    #[arg(long, value_delimiter = ',', default_values = ["cpu", "gpu"])]
    backend: Vec<BackendChoice>,
    /// Frames of each on the CPU; medians count. A GPU makes a quarter as many
    #[arg(long, default_value_t = 40, value_parser = clap::value_parser!(u16).range(1..=1000))]
    rounds: u16,
}

/// What is measured; the first is what all others are beside of. The third is what the bound is for.
const CASES: [(&str, [bool; 3]); 4] = [
    ("blinn-phong, colours", [false, false, false]),
    ("metallic-roughness, colours", [true, false, false]),
    ("and occlusion, roughness, metalness", [true, true, false]),
    ("and emission", [true, true, true]),
];

/// A map in the folder of samples.
fn sample(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../data").join(name)
}

/// The scene of a case: `bump` from above at an angle, without shadows.
fn scene([is_rough, has_packed, has_emission]: [bool; 3], backend: BackendChoice) -> Result<Scene, String> {
    let shade = if is_rough { "metallic-roughness" } else { "blinn-phong" };
    let stages = [("shade", shade), ("shadow", "none"), ("ambient", "constant")];
    let surface = SurfaceSpec {
        height: Some(sample("cobbles.png")),
        color: Some(sample("cobbles_color.png")),
        orm: has_packed.then(|| sample("cobbles_orm.png")),
        emission: has_emission.then(|| sample("cobbles_color.png")),
        method: Some("bump".to_owned()),
        stages: stages.map(|(key, name)| (key.to_owned(), name.to_owned())).into(),
        ..SurfaceSpec::default()
    };
    let spec = SceneSpec {
        look: Some(Look::Plain),
        size: Some(PictureSize::Pixels([800, 600])),
        samples: Some(1),
        backend: Some(backend),
        ..SceneSpec::of_surface(surface)
    };
    spec.load().map_err(|error| error.to_string())
}

/// Prints the table. Fails where the bound is missed.
pub fn run(arguments: &Arguments) -> Result<ExitCode, String> {
    let mut table = table(&["backend", "shading and maps", "ms a frame", "over blinn-phong"]);
    let (mut devices, mut missed) = (Vec::new(), Vec::new());
    for &backend in &arguments.backend {
        let of_backend = |error: &dyn std::fmt::Display| format!("{backend}: {error}");
        let mut runners = Vec::new();
        for (name, maps) in CASES {
            let scene = scene(maps, backend)?;
            let renderer = Renderer::new(backend, Sampling::Exact).map_err(|error| of_backend(&error))?;
            runners.push((name, scene, renderer, Maps::in_memory(), Samples::default()));
        }
        let rounds =
            if backend == BackendChoice::Cpu { arguments.rounds } else { arguments.rounds.div_ceil(4) };
        for round in 0..=rounds {
            for (_, scene, renderer, maps, samples) in &mut runners {
                if round == 0 {
                    let first = renderer.render(scene, maps, &Watch::none());
                    devices.push(first.map_err(|error| of_backend(&error))?.info.device);
                }
                let time = renderer.time(scene, maps, &Watch::none()).map_err(|error| of_backend(&error))?;
                if round > 0 {
                    samples.push(1e3 * time.elapsed.as_secs_f64());
                }
            }
        }
        let Some((.., plain)) = runners.first() else { continue };
        for (place, (name, .., samples)) in runners.iter().enumerate() {
            let ratio = samples.over(plain).median();
            if place <= 2 && ratio > BOUND {
                missed.push(format!("{name} on {backend}: {ratio:.2}"));
            }
            table.add_row([
                backend.to_string(),
                (*name).to_owned(),
                samples.to_string(),
                format!("{ratio:.2}"),
            ]);
        }
    }
    devices.dedup();
    println!(
        "Frames of `bump` without shadows, 800x600 pixels, one sample each, in turn; medians, with the least \
         and the greatest. On {}.\n\n{table}\n",
        devices.join(" and ")
    );
    let said = if missed.is_empty() { "held".to_owned() } else { format!("missed by {}", missed.join(", ")) };
    println!("Bound with four maps, {BOUND} times blinn-phong with one: {said}.");
    Ok(if missed.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
