//! The parallax of Babylon.js beside Relief's methods in the kit of three.js: one page draws both on WebGL 2,
//! in turn.

use std::sync::Arc;

use glam::DVec3;
use relief_core::HeightMap;
use relief_core::mesh::Mesh;
use relief_export::Profile;
use serde_json::{Value, json};

use super::{
    Arguments, FOV_DEGREES, METHODS, SCALE_M, SHOWN_WITHIN, byte, decode, exported_of, of_texels, ours, part,
};
use crate::chromium::{npm, with_three};
use crate::kits::THREE_KIT;
use crate::kits::rendered::{Shown, mesh_json};
use crate::table::table;

/// Numbers of layers that Babylon's shader gets in place of its own.
const LAYERS: [u32; 4] = [8, 16, 32, 64];

/// The way whose cost is 1.
const UNIT: &str = "Babylon, occlusion";

/// How far a way is off from a place, in texels, and what it costs over a flat material, in milliseconds.
struct Seen {
    median: f64,
    p99: f64,
    over_flat: f64,
}

pub fn of_map(
    arguments: &Arguments,
    heights: &HeightMap,
    mesh: &Arc<Mesh>,
    eyes: &[DVec3; 3],
    size: [u32; 2],
) -> Result<String, String> {
    let ways = ways(heights)?;
    let texels: Vec<u8> = heights.texels().iter().map(|at| byte(*at)).collect();
    let input = json!({
        "babylon": npm::BABYLON, "width": size[0], "height": size[1], "fov": FOV_DEGREES, "scale": SCALE_M,
        "eyes": eyes.map(|eye| eye.to_array()),
        "ways": ways,
        "mesh": mesh_json(mesh, false),
        "heights": of_texels(heights, &json!(heights.texels())),
        "heights8": of_texels(heights, &json!(texels)),
    });
    let answer = with_three(&arguments.chromium, include_str!("babylon.js"), Some(THREE_KIT), input)?;

    let pixels = (size[0] * size[1]) as usize;
    let pictures = 6 * pixels * ways.len();
    let (shown, times) =
        answer.split_at_checked(pictures * eyes.len()).ok_or("the page's answer is short")?;
    let times: Vec<Vec<Vec<f64>>> = serde_json::from_slice(times).map_err(|error| error.to_string())?;
    let mut seen = Vec::new();
    for ((eye, shown), times) in eyes.iter().zip(shown.chunks(pictures)).zip(times) {
        let shown: Vec<Shown> = shown.chunks(6 * pixels).map(|bytes| decode(bytes, pixels)).collect();
        let [exact, base] =
            [ours("exact", mesh, heights, *eye, size)?, ours("bump", mesh, heights, *eye, size)?];
        seen.push(of_eye(&ways, &shown, &times, [&exact, &base], heights.width())?);
    }
    Ok(rows(&ways, &seen))
}

/// All that is drawn: each engine's flat material is before its other ways.
fn ways(heights: &HeightMap) -> Result<Vec<Value>, String> {
    let mut ways = vec![
        json!({ "engine": "babylon", "name": "Babylon, flat" }),
        json!({ "engine": "babylon", "name": UNIT, "occlusion": true }),
        // The default of its textures.
        json!({ "engine": "babylon", "name": "Babylon, anisotropy 4", "occlusion": true, "anisotropy": 4 }),
    ];
    ways.extend(LAYERS.map(|layers| {
        let name = format!("{UNIT}, {layers} layers");
        json!({ "engine": "babylon", "name": name, "occlusion": true, "layers": layers })
    }));
    ways.push(json!({ "engine": "three", "name": "three.js, flat" }));
    for method in METHODS {
        let (exported, map) = exported_of(method, heights, Profile::Es300)?;
        let text = String::from_utf8_lossy(&exported.files[0].bytes).into_owned();
        let mut way = json!({
            "engine": "three",
            "name": format!("Relief, {method}"),
            "functions": { "about": exported.manifest, "texts": { "glsl": text } },
        });
        if let Some(map) = map {
            way["map"] = map;
        }
        ways.push(way);
    }
    Ok(ways)
}

/// What all ways show from one place. Fails where one shows other coordinates than it should.
fn of_eye(
    ways: &[Value],
    shown: &[Shown],
    times: &[Vec<f64>],
    [exact, base]: [&Shown; 2],
    side: u32,
) -> Result<Vec<Seen>, String> {
    let mut flat = 0;
    let mut seen = Vec::new();
    for (at, way) in ways.iter().enumerate() {
        let name = way["name"].as_str().unwrap_or_default();
        if is_flat(way) {
            flat = at;
            let off = part(base, &shown[at], 0.99);
            if off > SHOWN_WITHIN {
                return Err(format!("{name}: the plane's coordinates are shown {off} tiles off"));
            }
        } else {
            moves_along(name, exact, [&shown[flat], &shown[at]])?;
        }
        let off = |of: f64| f64::from(side) * part(exact, &shown[at], of);
        seen.push(Seen { median: off(0.5), p99: off(0.99), over_flat: over(&times[at], &times[flat]) });
    }
    Ok(seen)
}

fn is_flat(way: &Value) -> bool {
    way.get("occlusion").is_none() && way.get("functions").is_none()
}

/// Fails where hits are farther from the exact ones than the flat plane is: they moved another way.
fn moves_along(name: &str, exact: &Shown, [flat, seen]: [&Shown; 2]) -> Result<(), String> {
    let [flat, seen] = [flat, seen].map(|shown| part(exact, shown, 0.5));
    match seen < flat {
        true => Ok(()),
        false => Err(format!("{name}: the median is {seen} tiles off, and {flat} without any relief")),
    }
}

/// The median of the differences of times that were taken in turn.
fn over(times: &[f64], flat: &[f64]) -> f64 {
    let mut over: Vec<f64> = times.iter().zip(flat).map(|(time, flat)| time - flat).collect();
    over.sort_by(f64::total_cmp);
    over.get(over.len() / 2).copied().unwrap_or(f64::NAN)
}

/// A table: errors, and costs beside Babylon's own.
fn rows(ways: &[Value], seen: &[Vec<Seen>]) -> String {
    let columns =
        ["way", "median at 30°", "60°", "80°", "p99 at 30°", "60°", "80°", "cost at 30°", "60°", "80°"];
    let mut rows = table(&columns);
    let unit = ways.iter().position(|way| way["name"] == UNIT).unwrap_or_default();
    for (at, way) in ways.iter().enumerate() {
        let texels = |of: fn(&Seen) -> f64| seen.iter().map(move |ways| format!("{:.2}", of(&ways[at])));
        let costs = seen.iter().map(|ways| match is_flat(way) {
            true => "0".to_owned(),
            false => format!("{:.1}", ways[at].over_flat / ways[unit].over_flat),
        });
        let name = way["name"].as_str().unwrap_or_default().to_owned();
        rows.add_row(
            [name].into_iter().chain(texels(|of| of.median)).chain(texels(|of| of.p99)).chain(costs),
        );
    }
    rows.to_string()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_1_SQRT_2;

    use relief_core::mesh::{Vertex, square};
    use relief_core::{HeightMap, Wrap};

    use super::*;

    /// A plane, and what of its frame is turned over.
    fn plane(turned: fn(&mut Vertex)) -> Arc<Mesh> {
        let plane = square(1).expect("a plane");
        let mut vertices = plane.vertices().to_vec();
        vertices.iter_mut().for_each(turned);
        Arc::new(Mesh::new(vertices, plane.triangles().to_vec()).expect("a mesh"))
    }

    #[test]
    fn hits_that_move_another_way_are_refused() {
        let texels = (0..64 * 64).map(|at| 0.5 + 0.5 * (f64::from(at % 64) * 0.3).sin() as f32).collect();
        let heights = HeightMap::new(64, 64, texels, Wrap::Repeat).expect("a map");
        let heights = heights.with_displacement(SCALE_M, -SCALE_M).expect("a relief");
        let eye = DVec3::new(0.0, FRAC_1_SQRT_2, FRAC_1_SQRT_2);
        let drawn =
            |method: &str, mesh: &Arc<Mesh>| ours(method, mesh, &heights, eye, [64, 48]).expect("hits");
        let right = plane(|_| ());
        let [exact, flat] = ["exact", "bump"].map(|method| drawn(method, &right));
        let check = |mesh: &Arc<Mesh>| moves_along("relief", &exact, [&flat, &drawn("relief", mesh)]);
        assert_eq!(check(&right), Ok(()));
        assert!(check(&plane(|vertex| vertex.bitangent = -vertex.bitangent)).is_err());
        assert!(moves_along("flat", &exact, [&flat, &flat]).is_err());
    }

    #[test]
    fn costs_are_differences_in_turn() {
        assert_eq!(over(&[5.0, 9.0, 4.0], &[1.0, 6.0, 2.0]), 3.0);
    }
}
