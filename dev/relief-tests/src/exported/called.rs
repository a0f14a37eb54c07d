//! Functions of exports, called for many paths, points or triangles on a device.

use relief_export::ExportedFunctions;
use relief_render::job::JobSurface;
use relief_shaders::cpu::{Path, PixelIn};

use super::Device;
use super::dialect::Dialect;
use super::numbers::{
    NUMBERS_OF_PATH, PATH, POINT, POINTS, Point, RAY, RESULT, TRIANGLE, numbers_of, numbers_of_point,
    numbers_of_triangle, triangle_of, vector,
};
use super::text::{made, text_of, type_of};

/// What `ReliefHit` says of a point, and how much of the light arrives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen {
    /// Whether the ray hits.
    pub hit: bool,
    /// The hit's texture coordinates.
    pub uv: [f32; 2],
    /// Its height.
    pub height: f32,
    /// The way from the point to the hit.
    pub depth: f32,
    /// The unit normal.
    pub normal: [f32; 3],
    /// The part of the light that arrives.
    pub light: f32,
}

/// What `ReliefTriangleHit` says of a ray at a triangle, and how much of the light arrives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeenOver {
    /// Whether the ray hits.
    pub hit: bool,
    /// The hit's texture coordinates.
    pub uv: [f32; 2],
    /// The way to the hit, in lengths of the ray's direction.
    pub depth: f32,
    /// The hit, in the triangle's space.
    pub position: [f32; 3],
    /// The unit normal along the direction to the light.
    pub facing: f32,
    /// The part of the light that arrives.
    pub light: f32,
}

/// The result of search and refinement: whether something is found, the place, and the parameter.
#[derive(Clone, Copy, Debug)]
pub struct OnPath {
    /// Whether something is found.
    pub found: bool,
    /// Its texture coordinates.
    pub uv: [f32; 2],
    /// Its parameter.
    pub t: f32,
}

impl Device {
    /// Runs search and refinement of functions over paths, in a language. The first file of the export is
    /// WGSL, the second that language.
    ///
    /// # Panics
    ///
    /// When the functions are none that this device runs.
    pub fn traced(
        &self,
        exported: &ExportedFunctions,
        surface: &JobSurface,
        paths: &[Path],
        dialect: Dialect,
    ) -> Vec<OnPath> {
        let body = body_of_paths(exported, dialect);
        let numbers: Vec<f32> = paths.iter().flat_map(numbers_of).collect();
        let results = self.called(exported, surface, &body, NUMBERS_OF_PATH, &numbers, dialect);
        let found = |of: &[f32]| OnPath { found: of[0] != 0.0, uv: [of[1], of[2]], t: of[3] };
        results.chunks_exact(RESULT).map(found).collect()
    }

    /// Runs the functions over points.
    ///
    /// # Panics
    ///
    /// When the functions are none that this device runs.
    pub fn seen(&self, exported: &ExportedFunctions, surface: &JobSurface, points: &[Point]) -> Vec<Seen> {
        let text = text_of(exported);
        let prefix = &exported.manifest.prefix;
        let point = made(&text, &type_of(exported, "Point"), &POINTS);
        let light = if text.contains(&format!("fn {prefix}_light(")) {
            format!(
                "{prefix}_light(settings, at, hit, vec3f(number_at(11u), number_at(12u), number_at(13u)))"
            )
        } else {
            "1.0".to_owned()
        };
        let body = format!(
            "let settings = own_settings;\n    let at = {point};\n    \
             let hit = {prefix}_hit(settings, at);\n    \
             var light = 0.0;\n    if (hit.hit) {{\n        light = {light};\n    }}\n    \
             results[out_at] = select(0.0, 1.0, hit.hit);\n    results[out_at + 1u] = hit.uv.x;\n    \
             results[out_at + 2u] = hit.uv.y;\n    results[out_at + 3u] = hit.height;\n    \
             results[out_at + 4u] = hit.depth;\n    results[out_at + 5u] = hit.normal.x;\n    \
             results[out_at + 6u] = hit.normal.y;\n    results[out_at + 7u] = hit.normal.z;\n    \
             results[out_at + 8u] = light;"
        );
        let numbers: Vec<f32> = points.iter().flat_map(numbers_of_point).collect();
        let results = self.called(exported, surface, &body, POINT, &numbers, Dialect::Wgsl);
        let seen = |of: &[f32]| Seen {
            hit: of[0] != 0.0,
            uv: [of[1], of[2]],
            height: of[3],
            depth: of[4],
            normal: [of[5], of[6], of[7]],
            light: of[8],
        };
        results.chunks_exact(RESULT).map(seen).collect()
    }

    /// Runs the functions over triangles, each with its ray and the direction to a light.
    ///
    /// # Panics
    ///
    /// When the functions are none that this device runs.
    pub fn seen_over(
        &self,
        exported: &ExportedFunctions,
        surface: &JobSurface,
        rays: &[(PixelIn, [f32; 3])],
    ) -> Vec<SeenOver> {
        let text = text_of(exported);
        let prefix = &exported.manifest.prefix;
        let ray = made(&text, &type_of(exported, "Ray"), &RAY);
        let triangle = triangle_of(&text, exported);
        let toward = vector(TRIANGLE - 3, 3);
        let light = if text.contains(&format!("fn {prefix}_triangle_light(")) {
            format!("{prefix}_triangle_light(settings, ray, hit, {toward})")
        } else {
            "1.0".to_owned()
        };
        let body = format!(
            "let settings = own_settings;\n    let ray = {ray};\n    let at = {triangle};\n    \
             let hit = {prefix}_triangle_hit(settings, at, ray);\n    var light = 0.0;\n    \
             if (hit.hit) {{\n        light = {light};\n    }}\n    \
             results[out_at] = select(0.0, 1.0, hit.hit);\n    results[out_at + 1u] = hit.uv.x;\n    \
             results[out_at + 2u] = hit.uv.y;\n    results[out_at + 3u] = hit.depth;\n    \
             results[out_at + 4u] = hit.position.x;\n    results[out_at + 5u] = hit.position.y;\n    \
             results[out_at + 6u] = hit.position.z;\n    \
             results[out_at + 7u] = dot(hit.normal, {toward});\n    \
             results[out_at + 8u] = light;"
        );
        let numbers: Vec<f32> = rays.iter().flat_map(numbers_of_triangle).collect();
        let results = self.called(exported, surface, &body, TRIANGLE, &numbers, Dialect::Wgsl);
        let seen = |of: &[f32]| SeenOver {
            hit: of[0] != 0.0,
            uv: [of[1], of[2]],
            depth: of[3],
            position: [of[4], of[5], of[6]],
            facing: of[7],
            light: of[8],
        };
        results.chunks_exact(RESULT).map(seen).collect()
    }
}

/// The statements that search and refine a path, in a language. The first file of the export is WGSL.
///
/// # Panics
///
/// When the functions do not search and refine.
pub fn body_of_paths(exported: &ExportedFunctions, dialect: Dialect) -> String {
    let text = text_of(exported);
    let found = text.split("let found = ").nth(1).and_then(|rest| rest.split(';').next());
    // WGSL alone has commas behind the last argument.
    let found = found.expect("it searches and refines").split_whitespace().collect::<Vec<_>>().join(" ");
    let found = found.replace(", )", ")");
    let [path, hit] = [type_of(exported, "Path"), type_of(exported, "TracedHit")];
    let made = dialect.statement(&made(&text, &path, &PATH), &path);
    format!(
        "{}\n    {}\n    {}\n    results[out_at] = {}(found.found);\n    \
         results[out_at + 1u] = found.uv.x;\n    \
         results[out_at + 2u] = found.uv.y;\n    results[out_at + 3u] = found.t;",
        dialect.declared("settings", &type_of(exported, "Settings"), "own_settings"),
        dialect.declared("path", &path, &made),
        dialect.declared("found", &hit, &found),
        if dialect == Dialect::Wgsl { "f32" } else { "float" },
    )
}
