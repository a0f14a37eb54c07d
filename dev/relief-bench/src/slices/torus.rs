//! Slices over a torus and their costs: beside the relief that `prism` finds, and slices at equal depths
//! beside the relief of `tetrahedra`, from which they are made.

use std::sync::Arc;

use glam::{DVec3, Vec2};
use relief_core::camera::Camera;
use relief_core::mesh::{Mesh, torus};
use relief_core::{HeightMap, Watch};
use relief_maps::Maps;
use relief_mesh::SliceSettings;
use relief_render::render;
use relief_scene::{BackendChoice, Scene, Surface};
use relief_shaders::Selection;
use relief_shaders::cpu::PixelOut;
use relief_tests::curved::quantile;
use relief_tests::slices::{crossings, direction_of};

use super::{Arguments, DEGREES, METHODS, all_maps};
use crate::fit::Fit;
use crate::samples::Samples;
use crate::table::table;

/// Radius of the ring around which the tube runs, in metres.
const RING_M: f64 = 0.35;

/// Metres of displacement. The tube has a radius of 15 cm.
const SCALE_M: f64 = 0.03;

/// Tiles of the map.
const TILES: Vec2 = Vec2::new(6.0, 3.0);

/// Slices over the displacement, and steps of false position.
const COUNTS: [(u32, u32); 4] = [(16, 0), (16, 1), (64, 0), (256, 0)];

/// Quads around the ring and the tube of the torus that is timed, and slices over its displacement.
const TIMED: ([u32; 2], [u32; 4]) = ([25, 25], [15, 20, 25, 50]);

/// Sides of the pictures that are timed.
const SIZES: [u32; 2] = [150, 400];

/// A torus and how it is looked at.
struct Shot {
    map: Arc<HeightMap>,
    mesh: Arc<Mesh>,
    degrees: f64,
    size: u32,
}

impl Shot {
    fn new(map: &Arc<HeightMap>, [around, tube]: [u32; 2], degrees: f64, size: u32) -> Result<Self, String> {
        let mesh =
            torus(around, tube).and_then(|mesh| mesh.tiled(TILES)).map_err(|error| error.to_string())?;
        Ok(Self { map: Arc::clone(map), mesh: Arc::new(mesh), degrees, size })
    }

    fn camera(&self) -> Result<Camera, String> {
        let (sine, cosine) = self.degrees.to_radians().sin_cos();
        let eye = DVec3::new(0.3 * sine, cosine, 0.95 * sine) * 2.5;
        Camera::new(eye, DVec3::ZERO, 28.0).map_err(|error| error.to_string())
    }

    fn scene(&self, selection: Selection, backend: BackendChoice) -> Result<Scene, String> {
        let surface = Surface::new(Arc::clone(&self.mesh), Arc::clone(&self.map)).with_selection(selection);
        let scene = Scene::builder(surface).size(self.size, self.size).samples(1).camera(self.camera()?);
        scene.backend(backend).build().map_err(|error| error.to_string())
    }

    fn pixels(&self, selection: Selection) -> Result<Vec<PixelOut>, String> {
        let scene = self.scene(selection, BackendChoice::Cpu)?;
        let rendered = render(&scene, &mut Maps::in_memory(), &Watch::none());
        Ok(rendered.map_err(|error| error.to_string())?.rendering.pixels)
    }

    /// How many slices there are before and behind each of the pixels that show something, on the mean, and
    /// in all of the picture.
    fn fragments(&self, method: &str, count: u32, truth: &[PixelOut]) -> Result<[f64; 2], String> {
        let camera = self.camera()?;
        let settings = SliceSettings { count, direction: direction_of(method, camera) };
        let crossed = crossings(&self.mesh, &self.map, settings, &camera, self.size);
        let shown = crossed.iter().zip(truth).filter(|(_, pixel)| pixel.hit == 1).map(|(crossed, _)| crossed);
        let (sum, count) = shown.fold((0, 0), |(sum, count), crossed| (sum + crossed, count + 1));
        Ok([sum as f64 / f64::from(count.max(1)), crossed.iter().sum::<usize>() as f64])
    }

    /// How much of a metre slices go along a ray, by the axis of the torus there that faces it most.
    fn faces(&self, method: &str, pixel: &PixelOut) -> Result<f64, String> {
        let at = DVec3::new(pixel.position.x.into(), pixel.position.y.into(), pixel.position.z.into());
        let out = DVec3::new(at.x, 0.0, at.z).normalize_or(DVec3::X);
        let normal = (at - RING_M * out).normalize_or(DVec3::Y);
        let along_ring = DVec3::Y.cross(out);
        let ray = (at - self.camera()?.eye()).normalize();
        let axes = [normal, along_ring, along_ring.cross(normal)].map(|axis| axis.dot(ray).abs());
        Ok(match method {
            "slices-surface" => axes[0],
            "slices-orthogonal" => axes[0].max(axes[1]).max(axes[2]),
            _ => 1.0,
        })
    }
}

fn selection(method: &str, set: &[(&str, f64)]) -> Result<Selection, String> {
    let mut selection = Selection::method(method).map_err(|error| error.to_string())?;
    for (key, value) in set {
        selection.set(key, *value).map_err(|error| error.to_string())?;
    }
    Ok(selection)
}

/// The truth that slices of a method come to.
fn truth(method: &str) -> Result<Selection, String> {
    let surface = if method == "slices-screen" { "tetrahedra" } else { "prism" };
    let mut selection = selection("exact", &[])?;
    selection.choose("surface", surface).map_err(|error| error.to_string())?;
    Ok(selection)
}

/// Prints how far slices are from the relief.
pub fn errors(arguments: &Arguments) -> Result<(), String> {
    let mut rows = table(&[
        "map",
        "degrees",
        "method",
        "slices",
        "steps",
        "through %",
        "late %",
        "median",
        "p99",
        "fragments",
        "median x fragments",
    ]);
    for (name, map) in all_maps()? {
        let size = [map.width(), map.height()].map(f64::from);
        let map = Arc::new(map.with_displacement(SCALE_M, 0.0).map_err(|error| error.to_string())?);
        let texel_m = std::f64::consts::TAU * RING_M / f64::from(TILES.x) / size[0];
        for degrees in DEGREES {
            let shot = Shot::new(&map, [32, 16], degrees, arguments.width)?;
            for method in METHODS {
                let truth = shot.pixels(truth(method)?)?;
                for (count, steps) in COUNTS {
                    let set = [("slices.count", f64::from(count)), ("slices.refine", f64::from(steps))];
                    let slices = shot.pixels(selection(method, &set)?)?;
                    let (mut through, mut late, mut apart) = (0, 0, Vec::new());
                    for (a, b) in truth.iter().zip(&slices).filter(|(a, _)| a.hit == 1) {
                        // Tiles are all alike.
                        let beside = [a.uv.x - b.uv.x, a.uv.y - b.uv.y].map(f64::from);
                        let beside = beside.map(|beside| beside - beside.round());
                        let texels = (beside[0] * size[0]).hypot(beside[1] * size[1]);
                        let step_m = SCALE_M / f64::from(count) / shot.faces(method, a)?;
                        let behind = f64::from(b.depth - a.depth);
                        // Upright slices are not bent between their corners.
                        let is_through = b.hit == 0 || behind > 1.25 * step_m + texel_m;
                        through += u32::from(is_through);
                        late += u32::from(!is_through && behind > 0.0 && texels > 0.5);
                        apart.push(if b.hit == 1 { texels } else { f64::INFINITY });
                    }
                    let seen = apart.len() as f64;
                    let [median, p99] = [0.5, 0.99].map(|part| quantile(&apart, part));
                    let [fragments, _] = shot.fragments(method, count, &truth)?;
                    rows.add_row([
                        name.to_owned(),
                        format!("{degrees}"),
                        method.to_owned(),
                        count.to_string(),
                        steps.to_string(),
                        format!("{:.2}", 100.0 * f64::from(through) / seen),
                        format!("{:.2}", 100.0 * f64::from(late) / seen),
                        format!("{median:.3}"),
                        format!("{p99:.2}"),
                        format!("{fragments:.1}"),
                        format!("{:.1}", median * fragments),
                    ]);
                }
            }
        }
    }
    println!("{rows}");
    Ok(())
}

/// Prints what pictures cost, and the line through it: so much for a slice, so much for a fragment.
pub fn times(arguments: &Arguments) -> Result<(), String> {
    let (_, map) = all_maps()?.into_iter().next().ok_or("no map")?;
    let map = Arc::new(map.with_displacement(SCALE_M, 0.0).map_err(|error| error.to_string())?);
    let mut rows = table(&["method", "backend", "pixels", "slices", "fragments k", "ms", "a second"]);
    let mut lines = Vec::new();
    let gpu = arguments.gpu.then_some(BackendChoice::Gpu);
    for (method, backend) in METHODS
        .into_iter()
        .flat_map(|method| [BackendChoice::Cpu].into_iter().chain(gpu).map(move |on| (method, on)))
    {
        let mut fit = Fit::default();
        for size in SIZES {
            let shot = Shot::new(&map, TIMED.0, 55.0, size)?;
            let truth = shot.pixels(truth(method)?)?;
            for count in TIMED.1 {
                let mut sliced = selection(method, &[("slices.count", f64::from(count))])?;
                sliced.choose("shadow", "none").map_err(|error| error.to_string())?;
                let times = Samples::of_pictures(&shot.scene(sliced, backend)?, backend, arguments.rounds)?;
                let [_, fragments] = shot.fragments(method, count, &truth)?;
                fit.add([f64::from(count), fragments], times.median());
                rows.add_row([
                    method.to_owned(),
                    backend.to_string(),
                    size.to_string(),
                    count.to_string(),
                    format!("{:.0}", fragments / 1e3),
                    times.to_string(),
                    format!("{:.1}", 1e3 / times.median()),
                ]);
            }
        }
        let [a, b] = fit.solved();
        lines.push(format!("{method}, {backend}: {a:.4} ms a slice, {:.1} ns a fragment", b * 1e6));
    }
    println!("{rows}\n\n{}", lines.join("\n"));
    Ok(())
}
