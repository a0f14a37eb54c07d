//! How near outlines of meshes that are made for a view come to those of all texels.

use comfy_table::Table;
use glam::{DVec3, Vec2};
use rayon::prelude::*;
use relief_core::camera::Camera;
use relief_core::mesh::{Mesh, square};
use relief_mesh::{MeshSettings, Mesher, View};
use relief_render::raycast::{RayCaster, Sides};
use relief_tests::outline::{Mask, distances};

use crate::surfaces::bases::{Base, cobbles};

/// Pixels to a voxel.
const PIXELS: [f64; 6] = [1.0, 2.0, 3.0, 5.0, 10.0, 20.0];

/// A row a base and a number of pixels.
pub fn table(width: u32) -> Result<Table, String> {
    let size = [width, width * 3 / 4];
    let map = cobbles()?.with_displacement(0.03, 0.0).map_err(|error| error.to_string())?;
    let mut rows =
        crate::table::table(&["base", "pixels", "triangles", "outline off, p50", "p95", "greatest"]);
    for name in ["ground", "torus-32x16", "sphere-32x16"] {
        let base = match name {
            "ground" => square(1).and_then(|mesh| mesh.tiled(Vec2::splat(4.0))).map_err(|e| e.to_string())?,
            _ => match Base::of(name)? {
                Some(base) => base.mesh,
                None => continue,
            },
        };
        let eye = if name == "ground" { DVec3::new(0.1, 0.12, 0.9) } else { DVec3::new(0.3, 0.9, 1.5) };
        let camera = Camera::new(eye, DVec3::ZERO, 40.0).map_err(|error| error.to_string())?;
        let mask = |settings: &MeshSettings| -> Result<(usize, Mask), String> {
            let mesher = Mesher::new(&base, &map, settings).map_err(|error| error.to_string())?;
            let mesh = mesher.mesh().map_err(|error| error.to_string())?;
            Ok((mesh.triangles().len(), seen(&mesh, &camera, size)))
        };
        let (triangles, truth) = mask(&MeshSettings::default())?;
        rows.add_row([name.to_owned(), "every texel".to_owned(), triangles.to_string()]);
        for pixels in PIXELS {
            let view = View { pixels, ..View::new(camera, size) };
            let (triangles, found) = mask(&MeshSettings::seen_by(view))?;
            let mut off = distances(&truth, &found);
            off.sort_by(f64::total_cmp);
            let at = |part: usize| format!("{:.2}", off[(off.len() - 1) * part / 100]);
            rows.add_row([
                name.to_owned(),
                pixels.to_string(),
                triangles.to_string(),
                at(50),
                at(95),
                at(100),
            ]);
        }
    }
    Ok(rows)
}

/// The pixels that a mesh covers.
fn seen(mesh: &Mesh, camera: &Camera, [width, height]: [u32; 2]) -> Mask {
    let caster = RayCaster::new(mesh);
    let row = |y: u32| {
        let caster = &caster;
        (0..width)
            .map(move |x| caster.next_hit(&camera.ray(x, y, width, height), Sides::Both, None).is_some())
    };
    Mask::new([width, height], (0..height).into_par_iter().flat_map_iter(row).collect())
}
