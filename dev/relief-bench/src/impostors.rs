//! `impostors`: objects of images beside the meshes that they were captured from, intersected and as engines
//! blend them.

use clap::Args;
use glam::DVec3;
use rayon::prelude::*;
use relief_core::Watch;
use relief_core::mesh::Mesh;
use relief_core::object::{DEFAULT_JUMP_TEXELS, ImageObject, JumpCells, ObjectFrames, View};
use relief_core::raycast::{Ray, RayCaster, Sides};
use relief_object::{Arrangement, CaptureSettings, Capturer, Cover, even_directions};

use crate::surfaces::bases::{spot, tree};
use crate::table::table;

mod turning;

/// Arguments of `impostors`.
#[derive(Args)]
pub struct Arguments {
    /// Pictures that are compared, from directions that are the same each time
    #[arg(long, default_value_t = 32)]
    views: u32,
    /// Pixels of a side of each, which is as wide as the ball
    #[arg(long, default_value_t = 128)]
    size: u32,
    /// In place of the table, how much pictures change when the eye goes a degree around, and what they cost
    #[arg(long)]
    turning: bool,
    /// Time a GPU, too
    #[arg(long)]
    gpu: bool,
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
    if arguments.turning {
        return turning::run(arguments);
    }
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

/// Depth object of a mesh, with images of the given number of texels a side.
pub fn captured(
    mesh: &Mesh,
    arrangement: Arrangement,
    size: u32,
    cover: Cover,
    cells: JumpCells,
) -> Result<ImageObject, String> {
    let settings = CaptureSettings { arrangement, size, ..CaptureSettings::default() };
    let capturer = Capturer::new(mesh, None, settings).map_err(|error| error.to_string())?;
    let captured = capturer.capture(cover, &Watch::none()).map_err(|error| error.to_string())?;
    captured.object(cells, DEFAULT_JUMP_TEXELS).map_err(|error| error.to_string())
}

impl Arguments {
    /// Pixels that show both of those that show either, over all pictures and in the worst, and how far apart
    /// both are in percent of the ball's diameter.
    fn beside(&self, caster: &RayCaster, object: &ImageObject, made: Made) -> Result<[f64; 3], String> {
        let (centre, radius) = object.views()[0].ball();
        let directions = even_directions(self.views);
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
