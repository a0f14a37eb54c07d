//! Numbers that paths, points, triangles and settings are passed as, and the structs made from them.

use relief_export::ExportedFunctions;
use relief_export::functions::FunctionsManifest;
use relief_shaders::cpu::{Path, PixelIn, SurfaceSettings};

use super::text::{made, type_of};

/// A point of a mesh, as `ReliefPoint` has it, and the direction toward a light.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// Texture coordinates.
    pub uv: [f32; 2],
    /// Unit direction from the eye.
    pub view: [f32; 3],
    /// Length of a tile along u and v.
    pub tile: [f32; 2],
    /// Coefficients of the mesh beside the point.
    pub curvature: [f32; 3],
    /// Width of the pixel, in texels.
    pub footprint: f32,
    /// Unit direction toward the light.
    pub toward: [f32; 3],
}

/// Members of a path and where they lie among its numbers.
pub(super) const PATH: [(&str, &str); 11] = [
    ("uv", "vec2f(number_at(0u), number_at(1u))"),
    ("duv", "vec2f(number_at(2u), number_at(3u))"),
    ("h", "vec3f(number_at(4u), number_at(5u), number_at(6u))"),
    ("exit", "number_at(7u)"),
    ("base", "number_at(8u)"),
    ("metric", "vec4f(number_at(9u), number_at(10u), number_at(11u), number_at(12u))"),
    ("ray", "u32(number_at(13u))"),
    ("level", "u32(number_at(14u))"),
    ("start", "number_at(15u)"),
    ("share", "number_at(16u)"),
    ("bend", "number_at(17u)"),
];

/// Members of a point and where they lie among its numbers.
pub(super) const POINTS: [(&str, &str); 5] = [
    ("uv", "vec2f(number_at(0u), number_at(1u))"),
    ("view", "vec3f(number_at(2u), number_at(3u), number_at(4u))"),
    ("tile", "vec2f(number_at(5u), number_at(6u))"),
    ("curvature", "vec3f(number_at(7u), number_at(8u), number_at(9u))"),
    ("footprint", "number_at(10u)"),
];

/// Members of a ray and where they lie among the numbers of a triangle.
pub(super) const RAY: [(&str, &str); 4] = [
    ("origin", "vec3f(number_at(0u), number_at(1u), number_at(2u))"),
    ("direction", "vec3f(number_at(3u), number_at(4u), number_at(5u))"),
    ("side", "number_at(6u)"),
    ("footprint", "0.0"),
];

/// Numbers of a path, of a point, of a ray, of a corner, of a triangle with its ray and a light, and of what
/// comes out.
pub(super) const NUMBERS_OF_PATH: usize = 18;
pub(super) const POINT: usize = 14;
const NUMBERS_OF_RAY: usize = 7;
const CORNER: usize = 17;
pub(super) const TRIANGLE: usize = NUMBERS_OF_RAY + 3 * CORNER + 6 + 3;
pub(super) const RESULT: usize = 9;

/// A vector of the numbers from a place on.
pub(super) fn vector(place: usize, count: usize) -> String {
    let numbers: Vec<String> = (place..place + count).map(|place| format!("number_at({place}u)")).collect();
    format!("vec{count}f({})", numbers.join(", "))
}

/// The triangle of the functions, from its numbers.
pub(super) fn triangle_of(text: &str, exported: &ExportedFunctions) -> String {
    let corner = |number: usize| {
        let begin = NUMBERS_OF_RAY + CORNER * number;
        let members =
            [("position", 0, 3), ("normal", 3, 3), ("tangent", 6, 3), ("bitangent", 9, 3), ("uv", 12, 2)];
        let mut known: Vec<(&str, String)> =
            members.map(|(name, place, count)| (name, vector(begin + place, count))).to_vec();
        known.push(("of_surface", vector(begin + 14, 3)));
        let known: Vec<(&str, &str)> = known.iter().map(|(name, value)| (*name, value.as_str())).collect();
        made(text, &type_of(exported, "Corner"), &known)
    };
    let begin = NUMBERS_OF_RAY + 3 * CORNER;
    let [heights, order, lift] =
        [vector(begin, 2), format!("u32(number_at({}u))", begin + 2), vector(begin + 3, 3)];
    // Surfaces that need nothing of the space above have no such struct.
    let shell = if text.contains(&format!("struct {} {{", type_of(exported, "Shell"))) {
        let known = [("heights", heights.as_str()), ("order", order.as_str()), ("lift", lift.as_str())];
        made(text, &type_of(exported, "Shell"), &known)
    } else {
        String::new()
    };
    let corners = [0, 1, 2].map(corner);
    let known = [("a", &corners[0]), ("b", &corners[1]), ("c", &corners[2]), ("shell", &shell)];
    made(text, &type_of(exported, "Triangle"), &known.map(|(name, value)| (name, value.as_str())))
}

pub(super) fn numbers_of_triangle((pixel, toward): &(PixelIn, [f32; 3])) -> Vec<f32> {
    let PixelIn { origin, direction, side, a, b, c, shell } = *pixel;
    let of = |v: relief_shaders::cpu::Vec3<f32>| [v.x, v.y, v.z];
    let mut numbers = [&of(origin)[..], &of(direction), &[side]].concat();
    for corner in [a, b, c] {
        for part in [corner.position, corner.normal, corner.tangent, corner.bitangent] {
            numbers.extend(of(part));
        }
        numbers.extend([corner.uv.x, corner.uv.y]);
        numbers.extend(of(corner.of_surface));
    }
    numbers.extend([shell.heights.x, shell.heights.y, shell.order as f32]);
    numbers.extend(of(shell.lift));
    numbers.extend(toward);
    numbers
}

pub(super) fn numbers_of_point(point: &Point) -> [f32; POINT] {
    let Point { uv, view, tile, curvature, footprint, toward } = *point;
    let ([u, v], [x, y, z], [along_u, along_v]) = (uv, view, tile);
    let ([uu, uv, vv], [toward_x, toward_y, toward_z]) = (curvature, toward);
    [u, v, x, y, z, along_u, along_v, uu, uv, vv, footprint, toward_x, toward_y, toward_z]
}

pub(super) fn numbers_of(path: &Path) -> [f32; NUMBERS_OF_PATH] {
    let Path { uv, duv, h, exit, base, metric, ray, level, start, share, bend } = *path;
    [
        uv.x,
        uv.y,
        duv.x,
        duv.y,
        h.x,
        h.y,
        h.z,
        exit,
        base,
        metric.x,
        metric.y,
        metric.z,
        metric.w,
        ray as f32,
        level as f32,
        start,
        share,
        bend,
    ]
}

/// The settings' bytes, as the manifest lays them out.
pub(super) fn settings_of(manifest: &FunctionsManifest, settings: &SurfaceSettings) -> Vec<u8> {
    let mut bytes = vec![0; (manifest.settings_size as usize).next_multiple_of(16)];
    for place in &manifest.settings {
        let words: Vec<u32> = match (place.name.as_str(), place.value) {
            (_, Some(value)) => vec![value.to_bits()],
            ("scale", _) => vec![settings.scale_m.to_bits()],
            ("bias", _) => vec![settings.bias_m.to_bits()],
            ("height_size", _) => vec![settings.height_size.x, settings.height_size.y],
            ("height_levels", _) => vec![settings.height_levels],
            ("mean_height", _) => vec![settings.mean_height.to_bits()],
            ("wrap", _) => vec![settings.wrap],
            ("light_radius", _) => vec![0],
            ("shell", _) => vec![settings.shell_m.x.to_bits(), settings.shell_m.y.to_bits()],
            ("search_layers", _) => vec![settings.maps[1].layers],
            ("shadow_tile", _) => {
                vec![settings.maps[3].tile_m.x.to_bits(), settings.maps[3].tile_m.y.to_bits()]
            }
            (other, _) => panic!("there is no setting {other} here"),
        };
        for (word, at) in words.iter().zip(bytes[place.offset as usize..].chunks_exact_mut(4)) {
            at.copy_from_slice(&word.to_le_bytes());
        }
    }
    bytes
}
