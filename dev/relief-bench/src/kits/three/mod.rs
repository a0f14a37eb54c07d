//! The kit of three.js, on WebGPU and on WebGL 2.

mod cut;
mod instances;
mod mask;
mod place;
pub mod scene;
mod shadow;

use std::path::Path;

use relief_export::{FunctionOptions, Profile, functions};
use serde_json::{Value, json};

use super::{BEYOND, Job, Shown};
use crate::chromium;

/// The kit, as it is shipped.
pub const KIT: &str = include_str!("../../../../../crates/relief-cli/engines/three/relief.js");

/// The backends of its renderer.
pub const BACKENDS: [&str; 2] = ["webgpu", "webgl"];

/// What three.js draws of a job, from its camera.
pub fn shown(chromium: &Path, job: &Job, backend: &str) -> Result<Shown, String> {
    drawn(chromium, job, backend, json!({})).map(|pixels| hits(&pixels))
}

/// Draws with three.js. `more` adds to the job, or takes the place of its parts. Returns each pixel's floats,
/// from the upper row down: `u`, `v`, depth and 1 for a hit.
fn drawn(chromium: &Path, job: &Job, backend: &str, more: Value) -> Result<Vec<[f32; 4]>, String> {
    let profiles = vec![Profile::Wgsl, Profile::Es300];
    let options = FunctionOptions { wrap: Some(job.heights.wrap()), profiles, ..FunctionOptions::default() };
    let exported = functions(job.selection, &options).map_err(|error| error.to_string())?;
    let text = |place: usize| String::from_utf8_lossy(&exported.files[place].bytes).into_owned();
    let mut input = job.json();
    input["backend"] = backend.into();
    input["functions"] = json!({
        "about": exported.manifest,
        "texts": { "wgsl": text(0), "glsl": text(1) },
    });
    for (name, value) in more.as_object().into_iter().flatten() {
        input[name] = value.clone();
    }
    let answer = chromium::with_three(chromium, include_str!("page.js"), Some(KIT), input)?;
    decode(&answer, job.size, backend)
}

/// The page's pixels.
fn decode(answer: &[u8], [width, height]: [u32; 2], backend: &str) -> Result<Vec<[f32; 4]>, String> {
    let numbers: Vec<f32> = answer.as_chunks().0.iter().map(|bytes| f32::from_le_bytes(*bytes)).collect();
    let pixels = numbers.as_chunks::<4>().0;
    if pixels.len() != (width * height) as usize {
        return Err(format!("the page says: {}", String::from_utf8_lossy(&answer[..answer.len().min(4000)])));
    }
    let mut rows: Vec<&[[f32; 4]]> = pixels.chunks(width as usize).collect();
    // WebGL reads from the lowest row up.
    if backend == "webgl" {
        rows.reverse();
    }
    Ok(rows.concat())
}

/// The hits of pixels.
fn hits(pixels: &[[f32; 4]]) -> Shown {
    let hit = |pixel: &[f32; 4]| (pixel[3] > 0.5).then(|| [0, 1].map(|k| f64::from(pixel[k]) - BEYOND));
    pixels.iter().map(hit).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_of_webgl_are_turned_over() {
        let pixels: Vec<f32> = vec![4.25, 4.5, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
        let bytes: Vec<u8> = pixels.iter().flat_map(|number| number.to_le_bytes()).collect();
        let hit = Some([0.25, 0.5]);
        let hits_of = |backend| decode(&bytes, [1, 2], backend).map(|pixels| hits(&pixels));
        assert_eq!(hits_of("webgpu"), Ok(vec![hit, None]));
        assert_eq!(hits_of("webgl"), Ok(vec![None, hit]));
        assert!(decode(b"error", [1, 2], "webgl").is_err());
    }
}
