//! Errors of both quadrics, by the angle between the view and the base's normal.

use comfy_table::Table;
use glam::DVec3;
use indicatif::ProgressBar;
use relief_core::mesh::{Mesh, MeshError, sphere, torus};
use relief_core::rng::Rng;
use relief_render::Renderer;
use relief_scene::BackendChoice;
use relief_tests::curved::{Curved, Drawn, Judged, Picture, quantile};

use crate::surfaces::bases::{TILES, cobbles};
use crate::table::table;

/// Metres between the heights 0 and 1, carved into meshes that are 1 m large.
const SCALE_M: f64 = 0.03;

/// The edges of the ranges of angles, in degrees.
const DEGREES: [f64; 6] = [0.0, 15.0, 30.0, 50.0, 70.0, 90.0];

/// Both have the sampling search that both can have.
const VERTICAL: Drawn = Drawn { method: "relief", ..Drawn::flat("quadric-vertical") };
const PERPENDICULAR: Drawn = Drawn { method: "relief", ..Drawn::flat("quadric-perpendicular") };

/// Distances of hits in texels, of a range of angles.
#[derive(Clone, Default)]
struct Range {
    vertical: Vec<f64>,
    perpendicular: Vec<f64>,
    apart: Vec<f64>,
}

/// Prints, for each range of angles, how far hits are from the judge's and from each other.
pub fn measured(views: u32, width: u32) -> Result<Table, String> {
    let map = cobbles()?;
    let mut rows = table(&[
        "mesh",
        "degrees to the normal",
        "hits",
        "vertical p50",
        "p95",
        "perpendicular p50",
        "p95",
        "of each other p50",
        "p95",
    ]);
    let outward_of_sphere: fn(DVec3) -> DVec3 = |point| point.normalize_or_zero();
    let outward_of_torus: fn(DVec3) -> DVec3 = |point| {
        let level = DVec3::new(point.x, 0.0, point.z).normalize_or_zero();
        (point - level * 0.35).normalize_or_zero()
    };
    let progress = ProgressBar::new(2 * u64::from(views));
    for (name, build, outward) in [
        ("sphere-128x64", sphere as fn(u32, u32) -> Result<Mesh, MeshError>, outward_of_sphere),
        ("torus-128x64", torus, outward_of_torus),
    ] {
        let built = |divisions: [u32; 2]| {
            let mesh = build(divisions[0], divisions[1]).and_then(|mesh| mesh.tiled(TILES));
            mesh.map_err(|error| error.to_string())
        };
        let curved = Curved::new(built([128, 64])?, &map, SCALE_M, -SCALE_M);
        let smooth = Curved::new(built([512, 256])?, &map, SCALE_M, -SCALE_M).judge();
        let mut ranges = vec![Range::default(); DEGREES.len() - 1];
        let (mut rng, mut renderer) = (Rng::new(1), Renderer::on_cpu());
        let size = [width, width * 3 / 4];
        for _ in 0..views {
            let camera = curved.random_camera(&mut rng, 1.0);
            let judged = Judged::new(&smooth, camera, size);
            let [vertical, perpendicular] = [VERTICAL, PERPENDICULAR].map(|drawn| {
                Picture::rendered(&curved.scene(drawn, camera, size, BackendChoice::Cpu), &mut renderer)
            });
            for (pixel, truth) in (0..).zip(&judged.picture.met) {
                let at = pixel as usize;
                let (Some(truth), Some(vertical), Some(perpendicular)) =
                    (truth.as_ref(), vertical.met[at].as_ref(), perpendicular.met[at].as_ref())
                else {
                    continue;
                };
                let ray = camera.ray(pixel % size[0], pixel / size[0], size[0], size[1]);
                let normal = outward(ray.origin + ray.direction * truth.depth_m);
                let degrees = normal.dot(-ray.direction.normalize()).clamp(-1.0, 1.0).acos().to_degrees();
                let range = DEGREES[1..].iter().position(|end| degrees < *end);
                let Some(range) = range.map(|range| &mut ranges[range]) else { continue };
                range.vertical.push(curved.texels(vertical.uv, truth.uv));
                range.perpendicular.push(curved.texels(perpendicular.uv, truth.uv));
                range.apart.push(curved.texels(vertical.uv, perpendicular.uv));
            }
            progress.inc(1);
        }
        for (range, ends) in ranges.iter().zip(DEGREES.windows(2)) {
            let parts = [&range.vertical, &range.perpendicular, &range.apart];
            let numbers = parts
                .into_iter()
                .flat_map(|texels| [0.5, 0.95].map(|part| format!("{:.3}", quantile(texels, part))));
            let first =
                [name.to_owned(), format!("{} to {}", ends[0], ends[1]), range.apart.len().to_string()];
            rows.add_row(first.into_iter().chain(numbers));
        }
    }
    progress.finish_and_clear();
    Ok(rows)
}
