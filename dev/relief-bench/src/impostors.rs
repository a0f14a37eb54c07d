//! `impostors`: objects of images beside the meshes that they were captured from, intersected and as engines
//! blend them.

use clap::Args;
use glam::{DVec3, Vec2, Vec3};
use rayon::prelude::*;
use relief_core::Watch;
use relief_core::mesh::{Mesh, Vertex};
use relief_core::object::{DEFAULT_JUMP_TEXELS, ImageObject, JumpCells, ObjectFrames, View};
use relief_core::raycast::{Ray, RayCaster, Sides};
use relief_core::rng::Rng;
use relief_object::{Arrangement, CaptureSettings, Capturer, Cover};

use crate::surfaces::bases::spot;
use crate::table::table;

/// What `impostors` is given.
#[derive(Args)]
pub struct Arguments {
    /// Pictures that are compared, from random directions that are the same each time
    #[arg(long, default_value_t = 32)]
    views: u32,
    /// Pixels of a side of each, which is as wide as the ball
    #[arg(long, default_value_t = 128)]
    size: u32,
}

/// Grids of frames, and texels of a side of each, that fit 512 x 512 texels.
const GRIDS: [(u32, u32); 5] = [(4, 128), (6, 85), (8, 64), (12, 42), (16, 32)];

/// A finer grid, of 2048 x 2048 texels.
const FINE: (u32, u32) = (16, 128);

/// How often blends move a place in a frame.
const STEPS: [u32; 4] = [0, 1, 2, 3];

/// What is made of the images.
#[derive(Clone, Copy)]
enum Made<'a> {
    All(&'a ImageObject),
    Three(ObjectFrames<'a>),
    Blend(ObjectFrames<'a>, u32),
}

impl Made<'_> {
    fn hit(self, ray: &Ray) -> Option<f64> {
        match self {
            Made::All(object) => object.first_hit(ray).map(|hit| hit.t),
            Made::Three(frames) => frames.first_hit(ray).map(|hit| hit.t),
            Made::Blend(frames, steps) => frames.blended(ray, steps),
        }
    }
}

/// Prints the table.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let mut rows =
        table(&["mesh", "images", "made of them", "cover", "texels", "IoU", "worst IoU", "apart %"]);
    let meshes = spot()?.map(|mesh| ("spot", mesh)).into_iter().chain([("tree", tree()?)]);
    for (name, mesh) in meshes {
        let caster = RayCaster::new(&mesh);
        let mut line = |label: String, made: &str, cover: Cover, texels: usize, error: [f64; 3]| {
            let [iou, worst, apart] = error;
            rows.add_row([
                name.to_owned(),
                label,
                made.to_owned(),
                cover.name().to_owned(),
                format!("{} k", texels / 1000),
                format!("{iou:.4}"),
                format!("{worst:.4}"),
                format!("{apart:.3}"),
            ]);
        };
        for cover in Cover::ALL {
            let mut all = |arrangement: Arrangement, size: u32, cells: JumpCells| {
                let label = format!("{} x {size}²", arrangement.count());
                let object = captured(&mesh, arrangement, size, cover, cells)?;
                let error = arguments.beside(&caster, &object, Made::All(&object))?;
                line(label, &format!("all, {}", cells.name()), cover, texels(&object), error);
                Ok::<(), String>(())
            };
            all(Arrangement::Cube, 209, JumpCells::Highest)?;
            all(Arrangement::Octahedral(7), 64, JumpCells::Highest)?;
            all(Arrangement::Octahedral(7), 64, JumpCells::Bilinear)?;
            for (side, size) in GRIDS.into_iter().chain([FINE]) {
                let label = format!("{side}x{side} x {size}²");
                let object = captured(&mesh, Arrangement::Octahedral(side), size, cover, JumpCells::Highest)?;
                let frames = object.frames().ok_or("an octahedral capture makes a grid")?;
                let error = arguments.beside(&caster, &object, Made::Three(frames))?;
                line(label.clone(), "three, highest", cover, texels(&object), error);
                for steps in STEPS {
                    let error = arguments.beside(&caster, &object, Made::Blend(frames, steps))?;
                    line(label.clone(), &format!("blend, {steps} steps"), cover, texels(&object), error);
                }
            }
        }
    }
    println!("{rows}");
    Ok(())
}

fn texels(object: &ImageObject) -> usize {
    object.views().iter().map(|view| view.size().map(|side| side as usize).iter().product::<usize>()).sum()
}

/// The object of images of a mesh, of so many texels a side.
pub fn captured(
    mesh: &Mesh,
    arrangement: Arrangement,
    size: u32,
    cover: Cover,
    cells: JumpCells,
) -> Result<ImageObject, String> {
    let settings = CaptureSettings { arrangement, size, ..CaptureSettings::default() };
    let capturer = Capturer::new(mesh, None, settings).map_err(|error| error.to_string())?;
    let captured = capturer.capture(cover, &Watch::NOBODY).map_err(|error| error.to_string())?;
    captured.object(cells, DEFAULT_JUMP_TEXELS).map_err(|error| error.to_string())
}

impl Arguments {
    /// Pixels that show both of those that show either, over all pictures and in the worst, and how far apart
    /// both are in percent of the ball's diameter.
    fn beside(&self, caster: &RayCaster, object: &ImageObject, made: Made) -> Result<[f64; 3], String> {
        let (centre, radius) = object.views()[0].ball();
        let mut rng = Rng::new(2001);
        let directions: Vec<DVec3> = (0..self.views).map(|_| rng.direction()).collect();
        let of_view = |from: &DVec3| {
            let view = View::orthographic(centre, radius, *from, None, [self.size; 2]);
            let view = view.map_err(|error| error.to_string())?;
            let side = f64::from(self.size);
            let (mut both, mut either, mut apart) = (0.0, 0.0, 0.0);
            for at in 0..self.size * self.size {
                let [x, y] = [at % self.size, at / self.size].map(|at| (f64::from(at) + 0.5) / side);
                let ray = view.ray(x, y);
                let mesh = caster.next_hit(&ray, Sides::Both, None).map(|hit| hit.t);
                let seen = made.hit(&ray);
                either += f64::from(u8::from(mesh.is_some() || seen.is_some()));
                if let (Some(mesh), Some(seen)) = (mesh, seen) {
                    both += 1.0;
                    apart += (mesh - seen).abs();
                }
            }
            Ok([both, either, apart])
        };
        let views = directions.par_iter().map(of_view).collect::<Result<Vec<_>, String>>()?;
        let sum = |part: usize| views.iter().map(|view| view[part]).sum::<f64>();
        let worst = views.iter().map(|view| view[0] / view[1]).fold(1.0, f64::min);
        Ok([sum(0) / sum(1), worst, 100.0 * sum(2) / sum(0) / (2.0 * radius)])
    }
}

/// Cards of the tree's crown.
const CARDS: usize = 2000;

/// A tree of square leaf cards around a crown, turned at random, on a stem of eight sides.
fn tree() -> Result<Mesh, String> {
    let mut rng = Rng::new(1);
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    let mut quad = |corner: DVec3, right: DVec3, up: DVec3| {
        let first = vertices.len() as u32;
        let normal = right.cross(up).normalize_or(DVec3::Y).as_vec3();
        for (u, v) in [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)] {
            vertices.push(Vertex {
                position: (corner + right * u + up * v).as_vec3(),
                normal,
                tangent: right.as_vec3(),
                bitangent: -up.as_vec3(),
                uv: Vec2::new(u as f32, 1.0 - v as f32),
            });
        }
        triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
    };
    for _ in 0..CARDS {
        // More leaves stand outside than within.
        let place = rng.direction() * rng.unit().powf(0.25) * DVec3::new(0.6, 0.55, 0.6);
        let (facing, beside) = (rng.direction(), rng.direction());
        let right = facing.cross(beside).normalize_or(DVec3::X) * rng.between(0.05, 0.09);
        let up = facing.cross(right);
        quad(place + DVec3::Y * 0.45 - 0.5 * (right + up), right, up);
    }
    for side in 0..8 {
        let [a, b] = [side, side + 1].map(|at| {
            let (sin, cos) = (std::f64::consts::TAU * f64::from(at) / 8.0).sin_cos();
            DVec3::new(0.06 * sin, -0.6, 0.06 * cos)
        });
        quad(a, b - a, Vec3::Y.as_dvec3());
    }
    Mesh::new(vertices, triangles).map_err(|error| error.to_string())
}
