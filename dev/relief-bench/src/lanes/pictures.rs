//! Whole pictures on the CPU, on one thread and on all, beside the machine's adapter, which on machines
//! without a GPU is a software one on the same cores.

use std::time::Instant;

use relief_core::mesh::{rectangle, torus};
use relief_core::{Lanes, Watch, Wrap};
use relief_maps::Maps;
use relief_render::Renderer;
use relief_scene::{BackendChoice, Sampling, Scene, Surface};
use relief_shaders::Selection;

use super::frames::scene;
use super::rays::ground;
use crate::samples::Samples;
use crate::table::table;

const SIZE: [u32; 2] = [1280, 720];

/// Texels along a side of the map.
const SIDE: u32 = 512;

/// Metres between the heights 0 and 1.
const SCALE_M: f64 = 0.06;

const METHODS: [&str; 4] = ["bump", "relief", "cone", "exact"];

/// How many times as fast all threads are to be as one, and of how many threads that is asked.
const AIM_THREADS: (usize, f64) = (2, 1.8);

/// What makes a picture, and the milliseconds that it took each time.
struct Timed<'a> {
    renderer: Renderer,
    maps: Maps,
    pool: Option<&'a rayon::ThreadPool>,
    taken: Samples,
}

impl<'a> Timed<'a> {
    fn on_cpu(lanes: Lanes, pool: Option<&'a rayon::ThreadPool>) -> Self {
        let mut renderer = Renderer::on_cpu();
        renderer.set_lanes(lanes);
        Self { renderer, maps: Maps::in_memory(), pool, taken: Samples::default() }
    }

    fn on_adapter(sampling: Sampling) -> Result<Self, String> {
        let renderer = Renderer::new(BackendChoice::Gpu, sampling).map_err(|error| error.to_string())?;
        Ok(Self { renderer, maps: Maps::in_memory(), pool: None, taken: Samples::default() })
    }

    /// Makes a picture, and says what it was made on.
    fn make(&mut self, scene: &Scene, counts: bool) -> Result<String, String> {
        let start = Instant::now();
        let mut render = || self.renderer.render(scene, &mut self.maps, &Watch::none());
        let made = match self.pool {
            Some(pool) => pool.install(render),
            None => render(),
        };
        if counts {
            self.taken.push(1e3 * start.elapsed().as_secs_f64());
        }
        made.map(|made| made.info.device).map_err(|error| error.to_string())
    }
}

pub fn run(rounds: u16) -> Result<(), String> {
    let mut rows = table(&[
        "mesh",
        "method",
        "shadows",
        "one lane ms",
        "most lanes ms",
        "on one thread ms",
        "adapter, exact ms",
        "adapter, fast ms",
        "one thread over all",
        "exact over CPU",
        "fast over CPU",
    ]);
    let one_thread =
        rayon::ThreadPoolBuilder::new().num_threads(1).build().map_err(|error| error.to_string())?;
    let mut devices = Vec::new();
    let mut missed = Vec::new();
    for (mesh_name, mesh) in [("plane", rectangle([1.0, 1.0], 1)), ("torus", torus(96, 48))] {
        let mesh = mesh.map_err(|error| error.to_string())?;
        for method in METHODS {
            // Without relief nothing throws a shadow.
            let shadows: &[&str] = if method == "bump" { &["none"] } else { &["none", "ray"] };
            for &shadow in shadows {
                let mut selection = Selection::method(method).map_err(|error| error.to_string())?;
                selection.choose("shadow", shadow).map_err(|error| error.to_string())?;
                let map = ground(SIDE, Wrap::Repeat)?.with_displacement(SCALE_M, -SCALE_M);
                let map = map.map_err(|error| error.to_string())?;
                let scene = scene(Surface::new(mesh.clone(), map).with_selection(selection), SIZE)?;
                let mut ways = [
                    Timed::on_cpu(Lanes::One, None),
                    Timed::on_cpu(Lanes::default(), None),
                    Timed::on_cpu(Lanes::default(), Some(&one_thread)),
                    Timed::on_adapter(Sampling::Exact)?,
                    Timed::on_adapter(Sampling::Fast)?,
                ];
                for round in 0..=rounds {
                    for way in &mut ways {
                        let device = way.make(&scene, round > 0)?;
                        if !devices.contains(&device) {
                            devices.push(device);
                        }
                    }
                }
                let [one_lane, cpu, single, exact, fast] = &ways.map(|way| way.taken);
                let (threads, of_exact, of_fast) = (single.over(cpu), exact.over(cpu), fast.over(cpu));
                let what = format!("{method} on {mesh_name}, shadows {shadow}");
                if of_exact.median() < 1.0 || of_fast.median() < 1.0 {
                    missed.push(format!("{what}: the adapter is faster"));
                }
                if rayon::current_num_threads() == AIM_THREADS.0 && threads.median() < AIM_THREADS.1 {
                    missed.push(format!("{what}: two threads bring {:.2}", threads.median()));
                }
                let mut row = vec![mesh_name.to_owned(), method.to_owned(), shadow.to_owned()];
                row.extend([one_lane, cpu, single, exact, fast].map(Samples::to_string));
                row.extend([threads, of_exact, of_fast].map(|times| format!("{:.2}", times.median())));
                rows.add_row(row);
            }
        }
    }
    println!(
        "Second pictures of {}x{} pixels, one sample each, of a map of {SIDE} texels: medians of {rounds} \
         rounds with the least and the greatest, all ways in turn; {} threads, {} lanes. On {}.\n\n{rows}\n",
        SIZE[0],
        SIZE[1],
        rayon::current_num_threads(),
        Lanes::default(),
        devices.join(" and on "),
    );
    println!(
        "Aim: as fast as the adapter in every picture, and two threads {} times as fast as one. {}",
        AIM_THREADS.1,
        if missed.is_empty() {
            "Reached everywhere.".to_owned()
        } else {
            format!("Missed: {}.", missed.join("; "))
        }
    );
    Ok(())
}
