//! `look`: a sphere in the shading `metallic-roughness` beside three.js, and both beside the model that
//! is integrated over all directions of the light.

mod differences;
mod integral;
mod ours;
mod sheet;
mod surroundings;
mod theirs;

use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;

use clap::Args;
use glam::DVec3;
use rayon::prelude::*;
use relief_core::camera::{Camera, Projection};
use relief_core::mesh::{Mesh, sphere};
use relief_io::linear_to_srgb;

use self::differences::{Differences, inside};
use crate::chromium::npm;
use crate::table::table;

/// Arguments of `look`.
#[derive(Args)]
pub struct Arguments {
    /// Columns and rows of the pictures
    #[arg(long, value_name = "N", default_value_t = 480,
        value_parser = clap::value_parser!(u32).range(16..=2048))]
    size: u32,
    /// The browser that runs three.js
    #[arg(long, value_name = "FILE", default_value = "chromium")]
    chromium: PathBuf,
    /// Sheet of all pictures to write, PNG or JPEG: Relief, three.js, and eight times what is between them
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

const ROUGHNESSES: [f32; 5] = [0.1, 0.3, 0.5, 0.75, 1.0];

/// The linear base colour.
const BASE: DVec3 = DVec3::new(0.9, 0.6, 0.3);

/// Where the eye is, in metres. It looks at the sphere's centre.
const EYE_M: DVec3 = DVec3::new(1.0, 1.5, 4.0);

/// Direction toward the light.
const LIGHT: DVec3 = DVec3::new(-1.0, 3.0, 3.0);

/// Height of the view, and radius of the sphere.
const HEIGHT_M: f64 = 1.1;
const RADIUS_M: f64 = 0.5;

/// The part of the pixels that lie within the bounds, which are parts of 255: of a light, and of
/// surroundings.
const SHARE: f64 = 0.99;
const BOUNDS: [u8; 2] = [2, 5];

/// The integral is computed for one pixel of a block of this many columns and rows.
const STEP: usize = 6;

/// A picture: sRGB bytes where it shows the sphere.
type Shown = Vec<Option<[u8; 3]>>;

/// A material, and the place of its surroundings; a directional light without them.
struct Case {
    metallic: f32,
    roughness: f32,
    around: Option<usize>,
}

impl Case {
    fn bound(&self) -> u8 {
        BOUNDS[usize::from(self.around.is_some())]
    }

    /// The cells that name it in a table.
    fn names(&self) -> [String; 3] {
        let light = self.around.map_or("light", |place| surroundings::ALL[place].0);
        let kind = if self.metallic > 0.0 { "metal" } else { "no metal" };
        [light.to_owned(), kind.to_owned(), self.roughness.to_string()]
    }
}

/// What all pictures have in common.
struct Set {
    size: u32,
    camera: Camera,
    mesh: Arc<Mesh>,
}

/// Prints the tables, and fails where a bound is missed.
pub fn run(arguments: &Arguments) -> Result<ExitCode, String> {
    let camera = Camera::with(EYE_M, DVec3::ZERO, Projection::Orthographic { height_m: HEIGHT_M });
    let camera = camera.map_err(|error| error.to_string())?;
    let mesh = Arc::new(sphere(256, 128).map_err(|error| error.to_string())?);
    let set = Set { size: arguments.size, camera, mesh };
    let cases = cases();
    let around: Vec<_> = surroundings::ALL.iter().map(|(_, light)| surroundings::picture(*light)).collect();
    let (about, [theirs, plain]) = theirs::pictures(&set, &cases, &around, &arguments.chromium)?;
    let ours = ours::pictures(&set, &cases, &around)?;

    let mut beside = table(&[
        "light",
        "material",
        "roughness",
        "bound",
        "within",
        "50 % / 99 % / all",
        "verdict",
        "within, not widened",
        "50 % / 99 % / all",
    ]);
    let mut truth = table(&[
        "light",
        "material",
        "roughness",
        "Relief within",
        "50 % / 99 % / all",
        "three.js within",
        "50 % / 99 % / all",
        "not widened within",
        "50 % / 99 % / all",
    ]);
    let (mut holds, mut least) = (true, usize::MAX);
    for (at, case) in cases.iter().enumerate() {
        let bound = case.bound();
        let places = inside(&ours[at], &theirs[at], set.size as usize);
        least = least.min(places.len());
        let all = [&theirs, &plain].map(|theirs| Differences::of(&ours[at], &theirs[at], &places));
        let kept = all[0].within(bound) >= SHARE;
        holds &= kept;
        let [found, unwidened] = all.map(|all| [percent(all.within(bound)), all.spread()]);
        let [within, spread] = found;
        let verdict = if kept { "PASS" } else { "MISS" }.to_owned();
        let cells = [vec![bound.to_string(), within, spread, verdict], unwidened.to_vec()].concat();
        beside.add_row(case.names().into_iter().chain(cells));

        let few = sampled(&places, set.size as usize);
        let integral = integrated(&set, case, &few);
        let cells = [&ours, &theirs, &plain].map(|shown| {
            let all = Differences::of(&integral, &shown[at], &few);
            [percent(all.within(bound)), all.spread()]
        });
        truth.add_row(case.names().into_iter().chain(cells.into_iter().flatten()));
    }
    println!(
        "Relief beside three.js {} in {about}: at least {least} pixels of each picture of {size}x{size}. \
         *Within*: the share of the pixels whose colours differ by at most the bound, of 255; at least {:.0} \
         %. *Not widened*: three.js without the roughness that it adds where normals turn.\n\n{beside}\n",
        npm::THREE,
        100.0 * SHARE,
        size = set.size
    );
    println!("Both beside the integral, one pixel of {} in the same bounds.\n\n{truth}", STEP * STEP);
    if let Some(output) = &arguments.output {
        sheet::write(&set, &ours, &theirs, output)?;
    }
    Ok(if holds { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn cases() -> Vec<Case> {
    let lights = std::iter::once(None).chain((0..surroundings::ALL.len()).map(Some));
    let of = |around| {
        [0.0, 1.0].into_iter().flat_map(move |metallic| {
            ROUGHNESSES.into_iter().map(move |roughness| Case { metallic, roughness, around })
        })
    };
    lights.flat_map(of).collect()
}

/// One place of every few columns and rows.
fn sampled(places: &[usize], columns: usize) -> Vec<usize> {
    let is_one = |place: &usize| [place % columns, place / columns].iter().all(|at| at.is_multiple_of(STEP));
    places.iter().copied().filter(is_one).collect()
}

/// The picture of the integral at these places; elsewhere there is none.
fn integrated(set: &Set, case: &Case, places: &[usize]) -> Shown {
    let columns = set.size as usize;
    let view = -set.camera.forward();
    let colour = |place: &usize| {
        let ray = set.camera.ray((place % columns) as u32, (place / columns) as u32, set.size, set.size);
        // Where the ray comes nearest to the centre, and from there to the front.
        let nearest = ray.origin + ray.direction * -ray.origin.dot(ray.direction);
        let half = (RADIUS_M * RADIUS_M - nearest.length_squared()).max(0.0).sqrt();
        let normal = ((nearest + view * half) / RADIUS_M).normalize();
        let light = match case.around {
            Some(at) => integral::of_surroundings(case, BASE, [normal, view], surroundings::ALL[at].1),
            None => integral::of_light(case, BASE, [normal, view, LIGHT.normalize()]),
        };
        light.to_array().map(|part| (255.0 * linear_to_srgb(part.clamp(0.0, 1.0))).round() as u8)
    };
    let colours: Vec<_> = places.par_iter().map(colour).collect();
    let mut shown = vec![None; columns * columns];
    for (place, colour) in places.iter().zip(colours) {
        shown[*place] = Some(colour);
    }
    shown
}

fn percent(share: f64) -> String {
    format!("{:.2} %", 100.0 * share)
}
