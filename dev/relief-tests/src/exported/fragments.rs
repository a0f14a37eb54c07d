//! Functions of exports in a fragment shader of WebGL 2, with a pixel for each path or point.

use relief_export::ExportedFunctions;
use relief_export::functions::{BoundTexture, SettingPlace};
use relief_render::job::JobSurface;
use relief_shaders::cpu::Path;
use serde_json::{Value, json};

use super::bound::{Texels, texels_of};
use super::called::body_of_paths;
use super::dialect::Dialect;
use super::numbers::{
    NUMBERS_OF_PATH, POINT, POINTS, Point, RESULT, numbers_of, numbers_of_point, settings_of,
};
use super::text::{made, type_of};

/// Numbers of a texel.
const TEXEL: usize = 4;

/// A fragment shader that calls functions once for each pixel, and the numbers that it reads.
pub struct Fragments {
    /// The shader. It reads a texture `given`, writes four numbers, and has the settings in `own_settings`.
    pub shader: String,
    /// Texels of `given` for a pixel, which lie beside each other.
    pub texels: usize,
    /// The numbers of all of them.
    pub given: Vec<f32>,
}

impl Fragments {
    /// How many paths or points there are.
    pub fn count(&self) -> usize {
        self.given.len() / (TEXEL * self.texels)
    }
}

/// Search and refinement over paths: whether something is found, its texture coordinates, and the parameter.
///
/// The export's first file is WGSL, the second GLSL ES 3.00.
///
/// # Panics
///
/// When the functions do not search and refine.
pub fn of_paths(exported: &ExportedFunctions, paths: &[Path]) -> Fragments {
    let given = padded(paths.iter().map(numbers_of), NUMBERS_OF_PATH);
    fragments(exported, &body_of_paths(exported, Dialect::Glsl), NUMBERS_OF_PATH, given)
}

/// The functions over points: whether something is hit, its texture coordinates, and the depth.
///
/// The export's first file is WGSL, the second GLSL ES 3.00.
///
/// # Panics
///
/// When the functions take no points.
pub fn of_points(exported: &ExportedFunctions, points: &[Point]) -> Fragments {
    let [settings, of, hit] = ["Settings", "Point", "Hit"].map(|name| type_of(exported, name));
    let point = made(&text_of(exported, 0), &of, &POINTS);
    let body = format!(
        "{settings} settings = own_settings;\n    {of} at = {};\n    {hit} hit = {}_hit(settings, at);\n    \
         results[0] = hit.hit ? 1.0 : 0.0;\n    results[1] = hit.uv.x;\n    results[2] = hit.uv.y;\n    \
         results[3] = hit.depth;",
        Dialect::Glsl.statement(&point, &of),
        exported.manifest.prefix,
    );
    fragments(exported, &body, POINT, padded(points.iter().map(numbers_of_point), POINT))
}

/// Numbers, each group of them in whole texels.
fn padded<const N: usize>(groups: impl Iterator<Item = [f32; N]>, count: usize) -> Vec<f32> {
    let rest = vec![0.0; count.next_multiple_of(TEXEL) - count];
    groups.flat_map(|group| [&group[..], &rest].concat()).collect()
}

fn fragments(exported: &ExportedFunctions, body: &str, count: usize, given: Vec<f32>) -> Fragments {
    let texels = count.div_ceil(TEXEL);
    let (functions, settings) = (text_of(exported, 1), type_of(exported, "Settings"));
    let shader = format!(
        "#version 300 es\nprecision highp float;\nprecision highp int;\n{functions}\n\
         uniform highp sampler2D given;\nuniform {settings} own_settings;\nout vec4 result;\n\n\
         float number_at(uint place) {{\n    \
         ivec2 first = ivec2(gl_FragCoord.xy) * ivec2({texels}, 1);\n    \
         return texelFetch(given, first + ivec2(int(place) / {TEXEL}, 0), 0)[int(place) % {TEXEL}];\n}}\n\n\
         void main() {{\n    float results[{RESULT}];\n    uint out_at = 0u;\n    {body}\n    \
         result = vec4(results[0], results[1], results[2], results[3]);\n}}\n"
    );
    Fragments { shader, texels, given }
}

fn text_of(exported: &ExportedFunctions, place: usize) -> String {
    String::from_utf8_lossy(&exported.files[place].bytes).into_owned()
}

/// The values of the settings, as bits of 32, by name and type.
pub fn settings_json(exported: &ExportedFunctions, surface: &JobSurface) -> Value {
    let bytes = settings_of(&exported.manifest, &surface.settings);
    let value = |place: &SettingPlace| {
        let from = &bytes[place.offset as usize..];
        let bits: Vec<u32> =
            from.as_chunks().0.iter().take(4).map(|bytes| u32::from_le_bytes(*bytes)).collect();
        json!({ "name": place.name, "type": place.of, "bits": bits })
    };
    exported.manifest.settings.iter().map(value).collect()
}

/// The textures that functions read, by name, and how many channels each has.
pub fn textures_of(exported: &ExportedFunctions, surface: &JobSurface) -> Vec<(String, bool, Texels)> {
    let prefix = format!("{}_", exported.manifest.prefix);
    let texture = |bound: &BoundTexture| {
        let texels = texels_of(bound.name.trim_start_matches(&prefix), surface);
        (bound.name.clone(), bound.of.contains("array"), texels)
    };
    exported.manifest.bindings.iter().map(texture).collect()
}
