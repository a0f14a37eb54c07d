//! Outlines of meshes that are made for a view, beside outlines of meshes of all texels.

use comfy_table::Table;
use glam::{DVec3, Vec2};
use rayon::prelude::*;
use relief_bake::{Filter, filter_levels};
use relief_core::camera::Camera;
use relief_core::mesh::{Mesh, square};
use relief_core::raycast::{RayCaster, Sides};
use relief_core::{HeightMap, Watch};
use relief_mesh::{MeshSettings, Mesher, View};
use relief_testing::outline::{Mask, distances, overlap};

use crate::surfaces::bases::{Base, cobbles};

/// Filters of the levels that coarse meshes have heights of; none is the map itself.
const FILTERS: [Option<Filter>; 6] = [
    None,
    Some(Filter::Average),
    Some(Filter::LeastSquares),
    Some(Filter::Variational),
    Some(Filter::Max),
    Some(Filter::Min),
];

/// Pixels to a voxel.
const PIXELS: [f64; 6] = [1.0, 2.0, 3.0, 5.0, 10.0, 20.0];

/// A row a base and a number of pixels.
pub fn table(width: u32) -> Result<Table, String> {
    let size = [width, width * 3 / 4];
    let map = cobbles()?.with_displacement(0.03, 0.0).map_err(|error| error.to_string())?;
    let mut made: Vec<(Filter, Vec<HeightMap>)> = Vec::new();
    for filter in FILTERS.into_iter().flatten() {
        let levels = filter_levels(&map, filter, &Watch::none()).map_err(|error| error.to_string())?;
        made.push((filter, levels[1..].to_vec()));
    }
    let levels = |filter: Option<Filter>| -> Result<&[HeightMap], String> {
        let known = filter.map(|filter| made.iter().find(|(of, _)| *of == filter));
        match known {
            None => Ok(&[]),
            Some(Some((_, levels))) => Ok(levels),
            Some(None) => Err("a filter that is not listed".to_owned()),
        }
    };
    let mut rows = crate::table::table(&[
        "base",
        "filter",
        "pixels",
        "triangles",
        "outline off, p50",
        "p95",
        "greatest",
        "pixels that change",
    ]);
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
        let mask = |settings: &MeshSettings, levels: &[HeightMap], camera: &Camera| {
            let mesher = match levels {
                [] => Mesher::new(&base, &map, settings),
                _ => Mesher::with_levels(&base, &map, levels, settings, &Watch::none()),
            };
            let mesh =
                mesher.map_err(|error| error.to_string())?.mesh().map_err(|error| error.to_string())?;
            Ok::<_, String>((mesh.triangles().len(), seen(&mesh, camera, size)))
        };
        // A tenth of a pixel aside, at the depth of the middle.
        let pixel_m = 2.0 * camera.half_height() * eye.length() / f64::from(size[1]);
        let aside = camera.right() * (0.1 * pixel_m);
        let moved = camera.moved(eye + aside, aside).map_err(|error| error.to_string())?;
        let changed = |a: &Mask, b: &Mask| {
            let [both, either] = overlap(a, b);
            (either - both).to_string()
        };
        let every = MeshSettings::default();
        let ((triangles, truth), (_, next)) = (mask(&every, &[], &camera)?, mask(&every, &[], &moved)?);
        let [empty, all] = [String::new(), "every texel".to_owned()];
        let nothing = || empty.clone();
        rows.add_row([
            name.to_owned(),
            nothing(),
            all,
            triangles.to_string(),
            nothing(),
            nothing(),
            nothing(),
            changed(&truth, &next),
        ]);
        let filters = FILTERS.iter().flat_map(|filter| PIXELS.map(|pixels| (*filter, pixels)));
        for (filter, pixels) in filters.filter(|(filter, pixels)| filter.is_none() || *pixels > 3.0) {
            let seen_by = |camera: &Camera| {
                let view = View { pixels, ..View::new(*camera, size) };
                mask(&MeshSettings::seen_by(view), levels(filter)?, camera)
            };
            let ((triangles, found), (_, next)) = (seen_by(&camera)?, seen_by(&moved)?);
            let mut off = distances(&truth, &found);
            off.sort_by(f64::total_cmp);
            let at = |part: usize| format!("{:.2}", off[(off.len() - 1) * part / 100]);
            rows.add_row([
                name.to_owned(),
                filter.map_or("none", Filter::name).to_owned(),
                pixels.to_string(),
                triangles.to_string(),
                at(50),
                at(95),
                at(100),
                changed(&found, &next),
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
