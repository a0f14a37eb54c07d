//! `object-slices`: slices through an object of six images, beside the object that they are of.

use std::sync::Arc;

use clap::Args;
use glam::DVec3;
use relief_core::Watch;
use relief_core::camera::Camera;
use relief_core::object::{ImageObject, JumpCells};
use relief_core::raycast::{RayCaster, Sides};
use relief_maps::Maps;
use relief_mesh::{BoxSlicer, SliceAnchor, SliceDirection};
use relief_object::{Arrangement, Cover};
use relief_render::render;
use relief_scene::{BackendChoice, Scene, Surface};
use relief_shaders::Selection;
use relief_shaders::cpu::PixelOut;

use crate::fit::Fit;
use crate::impostors::captured;
use crate::samples::Samples;
use crate::surfaces::bases::spot;
use crate::table::table;

/// Arguments of `object-slices`.
#[derive(Args)]
pub struct Arguments {
    /// Time pictures in place of comparing them
    #[arg(long)]
    times: bool,
    /// Pictures that are timed of each; the median counts
    #[arg(long, default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=1000))]
    rounds: u32,
    /// Time a GPU, too: its product of all images, and its passes
    #[arg(long)]
    gpu: bool,
}

/// Sides of the pictures, as in the paper. The object is about as wide as a picture.
const SIZES: [u32; 2] = [150, 400];

/// Slices over the ball that the images show.
const COUNTS: [u32; 5] = [35, 70, 150, 300, 600];

/// From where it is seen: along an axis, between two and between three.
const FROM: [DVec3; 3] =
    [DVec3::Z, DVec3::new(std::f64::consts::FRAC_1_SQRT_2, 0.0, std::f64::consts::FRAC_1_SQRT_2), THIRD];

const THIRD: DVec3 = DVec3::splat(0.577_350_269_189_625_8);

/// The methods, each with what it comes nearer to.
const METHODS: [[&str; 2]; 2] =
    [["depth-object-slices", "depth-object"], ["visual-hull-slices", "visual-hull"]];

/// An object and how it is looked at.
struct Shot<'a> {
    object: &'a Arc<ImageObject>,
    from: DVec3,
    size: u32,
}

impl Shot<'_> {
    fn camera(&self) -> Result<Camera, String> {
        let (centre, radius) = self.object.views()[0].ball();
        let degrees: f64 = 24.0;
        let away = radius / (0.5 * degrees).to_radians().sin();
        Camera::new(centre + self.from * away, centre, degrees).map_err(|error| error.to_string())
    }

    fn scene(&self, method: &str, set: &[(&str, f64)], backend: BackendChoice) -> Result<Scene, String> {
        let mut selection = Selection::method(method).map_err(|error| error.to_string())?;
        selection.choose("shadow", "none").map_err(|error| error.to_string())?;
        for (key, value) in set {
            selection.set(key, *value).map_err(|error| error.to_string())?;
        }
        let surface = Surface::of_object(Arc::clone(self.object)).map_err(|error| error.to_string())?;
        let scene = Scene::builder(surface.with_selection(selection)).size(self.size, self.size).samples(1);
        scene.camera(self.camera()?).backend(backend).build().map_err(|error| error.to_string())
    }

    fn pixels(&self, method: &str, set: &[(&str, f64)]) -> Result<Vec<PixelOut>, String> {
        let scene = self.scene(method, set, BackendChoice::Cpu)?;
        let rendered =
            render(&scene, &mut Maps::in_memory(), &Watch::none()).map_err(|error| error.to_string())?;
        Ok(rendered.rendering.pixels)
    }

    /// Milliseconds of a picture.
    fn time(
        &self,
        method: &str,
        set: &[(&str, f64)],
        backend: BackendChoice,
        rounds: u32,
    ) -> Result<Samples, String> {
        Samples::of_pictures(&self.scene(method, set, backend)?, backend, rounds)
    }

    /// How many pixels all slices show together, drawn or not.
    fn fragments(&self, direction: SliceDirection, count: u32) -> Result<f64, String> {
        let (_, radius) = self.object.views()[0].ball();
        let bounds = self.object.bounds().ok_or("there is nothing to see")?;
        let slicer = BoxSlicer::new(bounds, 2.0 * radius / f64::from(count), direction);
        let slicer = slicer.map_err(|error| error.to_string())?;
        let mut corners = Vec::new();
        let take = |slice: &relief_mesh::BoxSlice| {
            let at = |place: usize| slice[place].as_vec3();
            corners.extend((2..slice.len()).map(|k| [at(0), at(k - 1), at(k)]));
        };
        slicer.each(&Watch::none(), take).map_err(|error| error.to_string())?;
        let (caster, camera) = (RayCaster::of_corners(corners.into_iter()), self.camera()?);
        let crossed = (0..self.size * self.size).map(|number| {
            let ray = camera.ray(number % self.size, number / self.size, self.size, self.size);
            caster.hits(&ray, Sides::Both).count()
        });
        Ok(crossed.sum::<usize>() as f64)
    }

    /// How the slices run, as programs say it and as settings do.
    fn directions(&self) -> Result<[(&'static str, f64, SliceDirection); 2], String> {
        let camera = self.camera()?;
        Ok([
            ("auto", 0.0, SliceDirection::Facing(camera)),
            ("screen", 4.0, SliceDirection::Screen(camera, SliceAnchor::Eye)),
        ])
    }

    /// How wide a pixel is at the middle of the object, in metres.
    fn pixel_m(&self) -> Result<f64, String> {
        let camera = self.camera()?;
        Ok(2.0 * camera.half_height() * (self.object.views()[0].ball().0 - camera.eye()).length()
            / f64::from(self.size))
    }
}

/// Prints a table.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let Some(mesh) = spot()? else { return Ok(()) };
    let object = Arc::new(captured(&mesh, Arrangement::Cube, 209, Cover::Centre, JumpCells::Highest)?);
    if arguments.times { times(&object, arguments) } else { errors(&object) }
}

/// How far slices are behind what they are of.
fn errors(object: &Arc<ImageObject>) -> Result<(), String> {
    let mut rows = table(&[
        "method",
        "pixels",
        "from",
        "direction",
        "slices",
        "IoU",
        "through %",
        "behind, pixels",
        "p99",
        "fragments",
        "behind x fragments",
    ]);
    for ([method, whole], size) in METHODS.iter().flat_map(|pair| SIZES.map(|size| (*pair, size))) {
        for from in FROM {
            let shot = Shot { object, from, size };
            let truth = shot.pixels(whole, &[])?;
            let covered = truth.iter().filter(|pixel| pixel.hit == 1).count();
            for (name, number, direction) in shot.directions()? {
                for count in COUNTS {
                    let set = [("slices.count", f64::from(count)), ("slices.direction", number)];
                    let slices = shot.pixels(method, &set)?;
                    let fragments = shot.fragments(direction, count)? / f64::from(size * size);
                    let pairs = || truth.iter().zip(&slices);
                    let both = pairs().filter(|(a, b)| a.hit == 1 && b.hit == 1).count();
                    let either = pairs().filter(|(a, b)| a.hit == 1 || b.hit == 1).count();
                    let pixel_m = shot.pixel_m()?;
                    let seen = pairs().filter(|(a, b)| a.hit == 1 && b.hit == 1);
                    let mut behind: Vec<f64> =
                        seen.map(|(a, b)| f64::from(b.depth - a.depth) / pixel_m).collect();
                    behind.sort_by(f64::total_cmp);
                    let at =
                        |part: f64| behind.get((behind.len() as f64 * part) as usize).copied().unwrap_or(0.0);
                    // By how much a ray goes on from one slice to the next.
                    let forward = shot.camera()?.forward();
                    let faces = if name == "auto" { forward.abs().max_element() } else { 1.0 };
                    let step = 2.0 * object.views()[0].ball().1 / f64::from(count) / faces / pixel_m;
                    let through =
                        behind.iter().filter(|behind| **behind > 1.25 * step).count() + covered - both;
                    rows.add_row([
                        method.to_owned(),
                        size.to_string(),
                        format!("{:.1} {:.1} {:.1}", from.x, from.y, from.z),
                        name.to_owned(),
                        count.to_string(),
                        format!("{:.4}", both as f64 / either as f64),
                        format!("{:.2}", 100.0 * through as f64 / covered as f64),
                        format!("{:.3}", at(0.5)),
                        format!("{:.2}", at(0.99)),
                        format!("{fragments:.1}"),
                        format!("{:.1}", at(0.5) * fragments),
                    ]);
                }
            }
        }
    }
    println!("{rows}\n");
    Ok(())
}

/// What slices cost, and the line through it: so much for a slice, and so much for each of its pixels.
fn times(object: &Arc<ImageObject>, arguments: &Arguments) -> Result<(), String> {
    let mut rows = table(&[
        "method",
        "backend",
        "pass",
        "pixels",
        "from",
        "slices",
        "fragments k",
        "ms",
        "whole object ms",
    ]);
    let cpu = [(BackendChoice::Cpu, 0.0)];
    let gpu = [(BackendChoice::Gpu, 0.0), (BackendChoice::Gpu, 1.0)];
    let ways = cpu.into_iter().chain(gpu.into_iter().filter(|_| arguments.gpu));
    let mut lines = Vec::new();
    for ([method, whole], (backend, pass)) in
        METHODS.iter().flat_map(|pair| ways.clone().map(|way| (*pair, way)))
    {
        let way = format!("{method}, {backend}, {}", if pass == 0.0 { "product" } else { "stencil" });
        let mut fit = Fit::default();
        for (from, size) in FROM.into_iter().flat_map(|from| SIZES.map(|size| (from, size))) {
            let shot = Shot { object, from, size };
            let entire = shot.time(whole, &[], backend, arguments.rounds)?;
            for count in [35, 70, 150] {
                let set = [("slices.count", f64::from(count)), ("geometry.pass", pass)];
                let sliced = shot.time(method, &set, backend, arguments.rounds)?;
                let fragments = shot.fragments(shot.directions()?[0].2, count)?;
                fit.add([f64::from(count), fragments], sliced.median());
                rows.add_row([
                    method.to_owned(),
                    backend.to_string(),
                    if pass == 0.0 { "product" } else { "stencil" }.to_owned(),
                    size.to_string(),
                    format!("{:.1} {:.1} {:.1}", from.x, from.y, from.z),
                    count.to_string(),
                    format!("{:.0}", fragments / 1e3),
                    sliced.to_string(),
                    entire.to_string(),
                ]);
            }
        }
        let [a, b] = fit.solved();
        lines.push(format!("{way}: {a:.4} ms a slice, {:.1} ns a fragment", b * 1e6));
    }
    println!("{rows}\n\n{}", lines.join("\n"));
    Ok(())
}
