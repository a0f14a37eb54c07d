//! Optical depths and transmittances of translucent volumes beside the judge's.

use relief_core::mesh::square;
use relief_core::{Volume, Watch, Wrap};
use relief_maps::Maps;
use relief_render::render;
use relief_testing::volumes;
use relief_tests::translucent::{THICK_M, depth_error, full, seen, translucent, under, ways_in_box};
use relief_tests::volume_rays::paths;

use crate::table::table;

/// Greatest difference of an optical depth, relative above 1, and of a transmittance.
const DEPTH: f64 = 1e-5;
const TRANSMITTANCE: f64 = 1e-4;

/// Most rays over a volume with a spoiled voxel, in each wrap.
const SPOILED: usize = 500;

/// Columns and rows of a picture, whose pixels are the rays across triangles.
const SIZE: [u32; 2] = [2400, 1200];

/// Divisions of the square that they cross.
const DIVISIONS: u32 = 32;

/// Extinctions of the box over it, per metre.
const EXTINCTIONS: [f64; 3] = [1.0, 5.0, 20.0];

/// Prints both tables, and returns whether all is within its bound. The volumes share the rays.
pub fn run(all_rays: usize) -> Result<bool, String> {
    let mut holds = true;
    let rays = all_rays / volumes::ALL.len();
    let mut rows = table(&["volume", "rays", "optical depth off by", "a voxel 0.001 off is"]);
    for (number, named) in volumes::ALL.iter().enumerate() {
        let (mut worst, mut spoiled) = (0.0f64, f64::INFINITY);
        for wrap in Wrap::ALL {
            let volume = named.build(wrap).map_err(|error| error.to_string())?;
            let paths = paths(number as u64, rays / Wrap::ALL.len());
            let few = &paths[..paths.len().min(SPOILED)];
            worst = worst.max(depth_error(&volume, &volume, &paths));
            let mut values = volume.values();
            let voxel = values.len() / 2;
            values[voxel] += if values[voxel] > 0.5 { -1e-3 } else { 1e-3 };
            let changed = Volume::new(volume.size(), &values, wrap).map_err(|error| error.to_string())?;
            spoiled = spoiled.min(depth_error(&changed, &volume, few));
        }
        holds &= worst <= DEPTH;
        rows.add_row([
            named.name.to_owned(),
            rays.to_string(),
            format!("{worst:.1e}"),
            format!("{spoiled:.1e}"),
        ]);
    }
    println!("{rows}\n");
    let mut rows = table(&["surface", "extinction", "rays in the box", "transmittance off by"]);
    for surface in ["tetrahedra", "prism"] {
        for extinction in EXTINCTIONS {
            let selection = translucent(extinction, &[("surface", surface)]);
            let mesh = square(DIVISIONS).map_err(|error| error.to_string())?;
            let scene =
                seen(under(mesh, &full(), selection), SIZE).build().map_err(|error| error.to_string())?;
            let rendered = render(&scene, &mut Maps::in_memory(), &Watch::none());
            let pixels = rendered.map_err(|error| error.to_string())?.rendering.pixels;
            let ways = ways_in_box(&scene, 0.0, THICK_M);
            let inside = ways.iter().filter(|way| **way > 0.0).count();
            let off = pixels.iter().zip(&ways);
            let worst = off
                .map(|(pixel, way)| (f64::from(pixel.transmittance) - (-extinction * way).exp()).abs())
                .fold(0.0, f64::max);
            holds &= worst <= TRANSMITTANCE;
            rows.add_row([
                surface.to_owned(),
                extinction.to_string(),
                inside.to_string(),
                format!("{worst:.1e}"),
            ]);
        }
    }
    println!("{rows}\n");
    Ok(holds)
}
