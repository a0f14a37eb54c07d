//! Times of a prism's renderer and of the exact judge for the same relief.

use std::time::Duration;

use cpu_time::ProcessTime;
use rayon::ThreadPool;
use relief_core::camera::{Camera, Ray};
use relief_core::exact::{DisplacedMesh, Sides};
use relief_core::{HeightMap, Watch};
use relief_maps::Maps;
use relief_render::Renderer;
use relief_scene::{BackendChoice, Scene};
use relief_tests::curved::{Curved, Drawn};

use super::shuffled;
use crate::memory;
use crate::samples::Samples;
use crate::trace::measure::{Cursor, pool, rays_per_second};

/// How long the judge has in each run and for each set of rays.
const TURN: Duration = Duration::from_millis(1500);

/// Where rays come from.
pub struct Views {
    /// The picture's, row by row.
    pub picture: Vec<Ray>,
    /// Rays of small pictures, shuffled.
    pub scattered: Vec<Ray>,
    /// The picture's camera.
    pub camera: Camera,
    /// Columns and rows of the picture.
    pub size: [u32; 2],
    /// Cameras of the small pictures.
    pub cameras: Vec<Camera>,
    /// Columns and rows of the small pictures.
    pub small: [u32; 2],
}

/// Times of one of our tracers on one thread.
pub struct Ours {
    /// Name of the tracer.
    pub name: String,
    /// All that it holds: mesh, heights, and what it made of them.
    pub bytes: usize,
    /// Seconds of processor time until the first ray is known, from the mesh and the heights on.
    pub prepared_s: Samples,
    /// Rays a second of the picture, in its order.
    pub picture: Samples,
    /// Rays a second of the picture, shuffled, where the tracer takes rays in any order.
    pub shuffled: Option<Samples>,
    /// Rays a second of the small pictures.
    pub scattered: Samples,
    /// Where the picture's rays hit, in metres along the view axis.
    pub depths: Vec<Option<f64>>,
}

/// Measures prisms with all methods, and the judge.
pub fn measured(
    curved: &Curved,
    methods: &[String],
    views: &Views,
    rounds: u16,
) -> Result<Vec<Ours>, String> {
    let pool = pool(1)?;
    let mut all = Vec::new();
    for method in methods {
        let method = relief_shaders::method(method).map_err(|error| error.to_string())?.name;
        let drawn = Drawn { method, ..Drawn::flat("prism") };
        all.push(pool.install(|| prism(curved, drawn, views, rounds))?);
    }
    all.push(judge(curved, views, rounds, &pool));
    Ok(all)
}

/// Everything that a frame needs.
struct Kit {
    scene: Scene,
    renderer: Renderer,
    maps: Maps,
}

impl Kit {
    /// All of it from the mesh and the heights on, which are copied: with a picture of one pixel.
    fn new(curved: &Curved, drawn: Drawn, camera: Camera) -> Result<Self, String> {
        let map = curved.map();
        let heights = HeightMap::new(map.width(), map.height(), map.texels().to_vec(), map.wrap())
            .map_err(|error| error.to_string())?;
        let own = Curved::new(curved.mesh().clone(), &heights, map.scale_m(), map.bias_m());
        let scene = own.scene(drawn, camera, [1, 1], BackendChoice::Cpu);
        let mut kit = Self { scene, renderer: Renderer::on_cpu(), maps: Maps::in_memory() };
        kit.frame(camera, [1, 1])?;
        Ok(kit)
    }

    /// Seconds of processor time of a picture, and its depths.
    fn frame(&mut self, camera: Camera, size: [u32; 2]) -> Result<(f64, Vec<Option<f64>>), String> {
        let scene = self.scene.to_builder().camera(camera).size(size[0], size[1]).build();
        let scene = scene.map_err(|error| error.to_string())?;
        let start = ProcessTime::now();
        let rendered = self.renderer.render(&scene, &mut self.maps, &Watch::none());
        let seconds = start.elapsed().as_secs_f64();
        let pixels = rendered.map_err(|error| error.to_string())?.rendering.pixels;
        let depths = pixels.iter().map(|pixel| (pixel.hit == 1).then_some(f64::from(pixel.depth)));
        Ok((seconds, depths.collect()))
    }
}

fn prism(curved: &Curved, drawn: Drawn, views: &Views, rounds: u16) -> Result<Ours, String> {
    let (mut prepared_s, mut picture, mut scattered) =
        (Samples::default(), Samples::default(), Samples::default());
    let (mut bytes, mut depths) = (0, Vec::new());
    for _ in 0..rounds {
        let start = ProcessTime::now();
        let (kit, held) = memory::held(|| Kit::new(curved, drawn, views.camera));
        prepared_s.push(start.elapsed().as_secs_f64());
        let mut kit = kit?;
        bytes = held;
        let (seconds, found) = kit.frame(views.camera, views.size)?;
        picture.push(views.picture.len() as f64 / seconds);
        depths = found;
        let mut seconds = 0.0;
        for camera in &views.cameras {
            seconds += kit.frame(*camera, views.small)?.0;
        }
        scattered.push(views.scattered.len() as f64 / seconds);
    }
    let name = format!("prism, {}", drawn.method);
    Ok(Ours { name, bytes, prepared_s, picture, shuffled: None, scattered, depths })
}

fn judge(curved: &Curved, views: &Views, rounds: u16, pool: &ThreadPool) -> Ours {
    let first = |judge: &DisplacedMesh, ray: &Ray| {
        judge.first_hit(ray.origin.to_array(), ray.direction.to_array(), Sides::Front).map(|hit| hit.t)
    };
    let mixed = shuffled(&views.picture);
    let sets = [&views.picture, &mixed, &views.scattered];
    let (mut prepared_s, mut rates) = (Samples::default(), sets.map(|_| Samples::default()));
    let cursors = sets.map(|_| Cursor::default());
    let (mut bytes, mut depths) = (0, Vec::new());
    for _ in 0..rounds {
        let start = ProcessTime::now();
        let (judge, held) = memory::held(|| curved.judge());
        prepared_s.push(start.elapsed().as_secs_f64());
        // It shares the heights, which are counted for all.
        bytes = held + size_of_val(curved.map().texels());
        for ((rays, rates), cursor) in sets.iter().zip(&mut rates).zip(&cursors) {
            rates.push(rays_per_second(pool, rays.len(), cursor, TURN, |range| {
                rays[range].iter().filter(|ray| first(&judge, ray).is_some()).count()
            }));
        }
        if depths.is_empty() {
            depths = views.picture.iter().map(|ray| first(&judge, ray)).collect();
        }
    }
    let [picture, shuffled, scattered] = rates;
    let name = "exact::DisplacedMesh".to_owned();
    Ours { name, bytes, prepared_s, picture, shuffled: Some(shuffled), scattered, depths }
}
