//! Pictures of three.js.

use std::path::Path;

use relief_io::Picture;
use serde_json::{Value, json};

use super::{BASE, Case, HEIGHT_M, LIGHT, Set, Shown};
use crate::chromium;

/// The page, which is run as it is here.
const PAGE: &str = include_str!("page.js");

/// Renders two pictures for every case: as it comes, and without the roughness that three.js adds where
/// normals turn. The text names what rendered.
pub fn pictures(
    set: &Set,
    cases: &[Case],
    around: &[Picture],
    chromium: &Path,
) -> Result<(String, [Vec<Shown>; 2]), String> {
    let answer = chromium::with_three(chromium, PAGE, None, input(set, cases, around))?;
    let answer = String::from_utf8_lossy(&answer);
    let mut lines = answer.lines();
    let about = lines.next().unwrap_or_default().to_owned();
    let shown: Option<Vec<Shown>> = lines.map(shown).collect();
    let mut shown = shown.ok_or("the page's answer is broken")?;
    let pixels = set.size as usize * set.size as usize;
    if shown.len() != 2 * cases.len() || shown.iter().any(|shown| shown.len() != pixels) {
        return Err("the page's answer has not as many pixels as it was asked for".to_owned());
    }
    let plain = shown.split_off(cases.len());
    Ok((about, [shown, plain]))
}

fn input(set: &Set, cases: &[Case], around: &[Picture]) -> Value {
    let vertices = set.mesh.vertices();
    let flat = |part: fn(&relief_core::mesh::Vertex) -> glam::Vec3| -> Vec<f32> {
        vertices.iter().flat_map(|vertex| part(vertex).to_array()).collect()
    };
    let around = around.iter().map(|picture| {
        // Rounded to four digits, so that the text is short.
        let texels = picture.texels.iter().flat_map(|texel| &texel[..3]);
        let texels: Vec<f64> = texels.map(|part| (f64::from(*part) * 1e4).round() / 1e4).collect();
        json!({ "width": picture.width, "height": picture.height, "texels": texels })
    });
    let pictures = [true, false].into_iter().flat_map(|widens| {
        cases.iter().map(move |case| {
            json!({
                "base": BASE.to_array(),
                "metallic": case.metallic,
                "roughness": case.roughness,
                "surroundings": case.around,
                "widens": widens,
            })
        })
    });
    json!({
        "size": set.size,
        "eye": set.camera.eye().to_array(),
        "halfHeight": HEIGHT_M / 2.0,
        "light": LIGHT.to_array(),
        "mesh": {
            "positions": flat(|vertex| vertex.position),
            "normals": flat(|vertex| vertex.normal),
            "triangles": set.mesh.triangles().as_flattened(),
        },
        "surroundings": around.collect::<Vec<_>>(),
        "pictures": pictures.collect::<Vec<_>>(),
    })
}

/// Reads a picture's line: eight digits for each pixel.
fn shown(line: &str) -> Option<Shown> {
    let bytes = line.as_bytes().chunks(8).map(|digits| {
        let text = std::str::from_utf8(digits).ok().filter(|text| text.len() == 8)?;
        let [red, green, blue, covered] = u32::from_str_radix(text, 16).ok()?.to_be_bytes();
        Some((covered == 255).then_some([red, green, blue]))
    });
    bytes.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_pixels_that_are_covered_or_not() {
        assert_eq!(shown("0102ffff00000000"), Some(vec![Some([1, 2, 255]), None]));
        assert_eq!(shown("0102ff"), None);
        assert_eq!(shown("0102fg00"), None);
    }
}
