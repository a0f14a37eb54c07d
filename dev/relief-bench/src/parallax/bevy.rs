//! Bevy's own parallax mapping beside Relief's methods in its material, in one run for each method.

use std::fs;
use std::sync::Arc;

use glam::DVec3;
use relief_core::HeightMap;
use relief_core::mesh::Mesh;
use relief_io::write_exr;

use super::{Arguments, FOV_DEGREES, SCALE_M, SHOWN_WITHIN, byte, ours, p99, value_of};
use crate::kits::bevy::{Project, words};
use crate::kits::rendered::Shown;
use crate::table::table;

/// Methods in the kit.
const METHODS: [&str; 4] = ["relief", "occlusion", "cone", "exact"];

/// Bevy's own ways, in the order in which its program draws them.
const OWN: [&str; 9] = [
    "flat",
    "Bevy, occlusion, 8 layers",
    "Bevy, occlusion, 16 layers",
    "Bevy, occlusion, 32 layers",
    "Bevy, occlusion, 64 layers",
    "Bevy, relief, 8 layers",
    "Bevy, relief, 16 layers",
    "Bevy, relief, 32 layers",
    "Bevy, relief, 64 layers",
];

/// What a way shows from each place: errors in texels, and milliseconds over a flat material.
struct Seen {
    name: String,
    errors: Vec<f64>,
    over_flat_ms: Vec<f64>,
}

pub fn of_map(
    arguments: &Arguments,
    heights: &HeightMap,
    mesh: &Arc<Mesh>,
    eyes: &[DVec3],
    size: [u32; 2],
) -> Result<String, String> {
    let mut all: Vec<Seen> = Vec::new();
    for method in METHODS {
        let seen = of_method(arguments, heights, mesh, eyes, size, method)?;
        // Bevy's own are the same in each run.
        let own = if all.is_empty() { 0 } else { OWN.len() };
        all.extend(seen.into_iter().skip(own));
    }
    let mut rows = table(&["way", "p99 at 30°", "60°", "80°", "ms over flat at 30°", "60°", "80°"]);
    for Seen { name, errors, over_flat_ms } in all {
        let errors = errors.into_iter().map(|error| format!("{error:.2}"));
        let costs = over_flat_ms.into_iter().map(|cost| format!("{cost:.1}"));
        rows.add_row([name].into_iter().chain(errors).chain(costs));
    }
    Ok(rows.to_string())
}

fn of_method(
    arguments: &Arguments,
    heights: &HeightMap,
    mesh: &Arc<Mesh>,
    eyes: &[DVec3],
    size: [u32; 2],
    method: &str,
) -> Result<Vec<Seen>, String> {
    let said = |error: std::io::Error| error.to_string();
    let folder = tempfile::tempdir().map_err(said)?;
    let (width, height) = (heights.width(), heights.height());
    let file = folder.path().join("heights.exr");
    write_exr(&file, width, height, &[("Y", heights.texels())]).map_err(|error| error.to_string())?;
    let flags = format!(
        "--mesh square --scale {SCALE_M} --tile-size 1,1 --wrap repeat --range 0,1 --shadow none --surface \
         plane --method {method}"
    );
    let project = Project::new(&arguments.relief, &file, &words(&flags))?;
    let depths: Vec<u8> = heights.texels().iter().map(|height| 255 - byte(*height)).collect();
    let depths_file = folder.path().join("depths.bin");
    fs::write(&depths_file, [&width.to_le_bytes()[..], &height.to_le_bytes(), &depths].concat())
        .map_err(said)?;
    project.replace("main.rs", include_str!("bevy_main.rs"))?;
    let answer = folder.path().join("answer.bin");
    let mut given: Vec<String> =
        [f64::from(size[0]), f64::from(size[1]), FOV_DEGREES, SCALE_M].map(|of| of.to_string()).into();
    given.extend([&answer, &depths_file].map(|file| file.display().to_string()));
    given.extend(eyes.iter().map(|eye| format!("{},{},{}", eye.x, eye.y, eye.z)));
    project.run(&given)?;

    let bytes = fs::read(&answer).map_err(said)?;
    let (pixels, ways) = ((size[0] * size[1]) as usize, OWN.len() + 1);
    let (pictures, times) =
        bytes.split_at_checked(16 * pixels * 2 * ways * eyes.len()).ok_or("Bevy's answer is short")?;
    let times: Vec<f64> = serde_json::from_slice(times).map_err(|error| error.to_string())?;
    let names = OWN.iter().map(|name| (*name).to_owned()).chain([format!("Relief, {method}")]);
    let mut seen: Vec<Seen> =
        names.map(|name| Seen { name, errors: Vec::new(), over_flat_ms: Vec::new() }).collect();
    let texels = f64::from(width);
    for (number, eye) in eyes.iter().enumerate() {
        let exact = ours("exact", mesh, heights, *eye, size)?;
        let base = ours("bump", mesh, heights, *eye, size)?;
        for (at, seen) in seen.iter_mut().enumerate() {
            let first = 2 * (number * ways + at);
            let shown = decoded(&pictures[16 * pixels * first..][..32 * pixels], pixels);
            if at == 0 && p99(&base, &shown) > SHOWN_WITHIN {
                return Err(format!("the plane's coordinates are shown {} tiles off", p99(&base, &shown)));
            }
            seen.errors.push(texels * p99(&exact, &shown));
            // The pictures of u and of v cost the same.
            let of =
                |way: usize| 0.5 * (times[2 * (number * ways + way)] + times[2 * (number * ways + way) + 1]);
            seen.over_flat_ms.push(1e3 * (of(at) - of(0)));
        }
    }
    Ok(seen)
}

/// The coordinates of two pictures of floats, u and v.
fn decoded(bytes: &[u8], pixels: usize) -> Shown {
    let numbers: Vec<f64> =
        bytes.as_chunks().0.iter().map(|bytes| f64::from(f32::from_le_bytes(*bytes))).collect();
    let texels = numbers.as_chunks::<4>().0;
    let value = |[coarse, fine, ahead, _]: [f64; 4]| value_of([coarse, fine, ahead]);
    let seen = |at: usize| (texels[at][3] > 0.5).then(|| [value(texels[at]), value(texels[pixels + at])]);
    (0..pixels).map(seen).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_of_floats_are_read() {
        let texel = |of: [f32; 4]| of.map(f32::to_le_bytes).concat();
        // A quarter of the tile is 8 rises and falls: both waves are at their ends.
        let u = [texel([0.25, 0.0, 0.5, 1.0]), texel([0.0; 4])].concat();
        let shown = decoded(&[u.clone(), u].concat(), 2);
        let [u, v] = shown[0].expect("a hit");
        assert!((u - 0.25).abs() < 1e-9 && (v - 0.25).abs() < 1e-9, "{u} {v}");
        assert_eq!(shown[1], None);
    }
}
