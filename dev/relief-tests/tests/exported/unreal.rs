//! Functions for Unreal's materials: they compile as a Custom node has them, with the hits of WGSL.

use glam::{Vec2, Vec3};
use rayon::prelude::*;
use relief_core::Wrap;
use relief_export::{ExportedFunctions, FunctionOptions, Profile, functions, unreal_node};
use relief_shaders::Selection;
use relief_tests::compilers;
use relief_tests::exported::{
    Dialect, Include, OnPath, Plane, Seen, Sight, compiled_hlsl, device, paths_of, points, shortened,
    surface_of,
};

use super::functions::{in_two, methods, named, pixel_of};

/// Paths of a program.
const PATHS: usize = 2_000;

const SURFACES: [&str; 3] = ["plane", "quadric-vertical", "quadric-perpendicular"];

/// Every method on every surface that has functions there, with a shadow and without.
fn selections() -> Vec<(String, Selection)> {
    let mut selections = Vec::new();
    for surface in SURFACES {
        for (number, (name, selection)) in methods(surface).into_iter().enumerate() {
            for shadow in ["none", ["ray", "soft", "horizon", "heuristic"][number % 4]] {
                let mut selection = selection;
                selection.choose("shadow", shadow).expect("a shadow");
                let mut fading = selection;
                fading.choose("detail", ["footprint", "fade"][number % 2]).expect("a level of detail");
                if number % 3 == 0 && functions(&fading, &FunctionOptions::default()).is_ok() {
                    selection = fading;
                }
                if functions(&selection, &FunctionOptions::default()).is_ok() {
                    selections.push((format!("{name} on {surface}, {shadow}"), selection));
                }
            }
        }
    }
    selections
}

fn exported(selection: &Selection, wrap: Wrap) -> ExportedFunctions {
    let options =
        FunctionOptions { wrap: Some(wrap), profiles: vec![Profile::Unreal5], ..FunctionOptions::default() };
    functions(selection, &options).unwrap_or_else(|error| panic!("{error}"))
}

fn text_of(exported: &ExportedFunctions) -> String {
    String::from_utf8(exported.files[0].bytes.clone()).expect("a text")
}

#[test]
fn every_method_compiles_in_a_custom_node() {
    if !compilers::are_there() {
        return;
    }
    let selections = selections();
    selections.par_iter().enumerate().for_each(|(number, (name, selection))| {
        let exported = exported(selection, Wrap::ALL[number % Wrap::ALL.len()]);
        let text = text_of(&exported);
        assert!(text.contains("#pragma once\n") && !text.contains("register("), "{name}");
        let include = Include::new(&text);
        assert!(include.methods().contains("relief_hit"), "{name}: {:?}", include.methods());
        let node = unreal_node(&exported.manifest, [100.0, 50.0]);
        let program = include.in_node(&node, 3.0, "float4(bent * light, offset) * mask + at.xyxy");
        compiled_hlsl(&program, "frag").unwrap_or_else(|error| panic!("{name}: {error}"));
        if number % 16 == 0 {
            let wrong = program.replace("relief.relief_hit(", "relief.relief_hits(");
            assert!(compiled_hlsl(&wrong, "frag").is_err(), "{name}");
        }
    });
    let with_footprint = selections.iter().filter(|(_, selection)| {
        text_of(&exported(selection, Wrap::Repeat)).contains("#define RELIEF_HAS_FOOTPRINT\n")
    });
    println!("{} selections, {} with a footprint", selections.len(), with_footprint.clone().count());
    assert!(selections.len() > 100 && with_footprint.count() > 10);
}

/// What stands before each question mark, back to the bracket that holds it.
fn conditions(line: &str) -> Vec<&str> {
    let before = |(end, _): (usize, &str)| {
        let mut depth = 0;
        let begin = line[..end].char_indices().rev().find(|(_, letter)| {
            depth += match letter {
                ')' => 1,
                '(' => -1,
                _ => 0,
            };
            depth < 0
        });
        &line[begin.map_or(0, |(place, _)| place)..end]
    };
    line.match_indices(" ? ").map(before).collect()
}

#[test]
fn no_vector_is_a_condition() {
    assert_eq!(conditions("x = f((a > 0) ? b : ((c.x < d) ? e : g))"), ["((a > 0)", "((c.x < d)"]);
    for (number, (name, selection)) in selections().iter().enumerate() {
        let text = text_of(&exported(selection, Wrap::ALL[number % Wrap::ALL.len()]));
        for line in text.lines() {
            for condition in conditions(line) {
                let has_vector =
                    ["float2(", "float3(", "int2(", "bool2"].iter().any(|of| condition.contains(of));
                assert!(!has_vector, "{name}: {line}");
            }
        }
    }
}

/// Holds every other method on a surface to WGSL's hits. How many there are.
fn same_hits_on(surface: &str) -> usize {
    let Some(device) = device().filter(|_| compilers::are_there()) else { return usize::MAX };
    let methods = methods(surface);
    for (number, (name, selection)) in methods.iter().enumerate() {
        let selection = shortened(*selection);
        let wrap = Wrap::ALL[number % Wrap::ALL.len()];
        let map = named("natural 101x67", wrap).with_displacement(0.3, -0.3).expect("proper numbers");
        let side = f64::from(map.width().max(map.height()));
        let mut points = points(PATHS, [1.0, 1.0], 29);
        for point in points.iter_mut().filter(|_| surface != "plane") {
            point.curvature = [0.2, 0.1, -0.1];
        }
        let surface_of = surface_of(map, selection);
        let paths = paths_of(&surface_of, &points.iter().map(pixel_of).collect::<Vec<_>>());
        let both = in_two(&selection, Some(wrap), Profile::Unreal5);
        let [own, other] =
            [Dialect::Wgsl, Dialect::Unreal].map(|of| device.traced(&both, &surface_of, &paths, of));
        let is_far = |(a, b): &(&OnPath, &OnPath)| {
            let off = (0..2).map(|k| f64::from(a.uv[k] - b.uv[k]).abs() * side).fold(0.0, f64::max);
            a.found != b.found || off > 1e-4
        };
        let far = own.iter().zip(&other).filter(is_far).count();
        let hits = own.iter().filter(|hit| hit.found).count();
        println!("{name} on {surface}, {wrap}: {far} of {} far, {hits} hit", own.len());
        assert!(hits > own.len() / 2 && far * 1000 <= own.len(), "{name} on {surface}, {wrap}: {far}");
    }
    methods.len()
}

#[test]
fn methods_of_a_struct_find_the_same_hits() {
    assert!(same_hits_on("plane") > 25);
}

#[test]
fn methods_of_a_struct_find_the_same_hits_on_bent_meshes() {
    assert!(same_hits_on("quadric-vertical") > 20);
}

/// Planes that lie and are turned any way, with frames of both hands.
fn planes() -> [Plane; 3] {
    let plane = |normal: Vec3, turn: f32, hand: f32, eye: [f32; 3]| {
        let normal = normal.normalize();
        let aside = normal.any_orthonormal_vector();
        let along_u = aside * turn.cos() + normal.cross(aside) * turn.sin();
        let along_v = normal.cross(along_u) * hand;
        let [right, up, out] = eye;
        let eye = aside * right + normal.cross(aside) * up + normal * out;
        let sun = (along_u + along_v * 0.4 + normal * 0.2).normalize();
        Plane { along: [along_u, along_v], normal, tile: Vec2::new(1.0, 0.75), eye, sun }
    };
    [
        plane(Vec3::new(0.1, 0.2, 1.0), 0.3, 1.0, [0.4, 0.2, 1.5]),
        plane(Vec3::new(0.7, -0.2, 0.6), 2.0, -1.0, [0.5, -0.9, 1.0]),
        plane(Vec3::new(-0.3, 0.9, 0.2), -1.0, -1.0, [-1.2, 0.1, 0.9]),
    ]
}

#[test]
fn a_custom_node_sees_the_plane_that_functions_see() {
    let Some(device) = device().filter(|_| compilers::are_there()) else { return };
    for (number, plane) in planes().into_iter().enumerate() {
        let method = ["relief", "cone"][number % 2];
        let surface = ["plane", "quadric-vertical"][number / 2];
        let mut selection = shortened(Selection::method(method).expect("a method"));
        selection.choose("surface", surface).expect("a surface");
        selection.choose("shadow", "ray").expect("a shadow");
        let map =
            named("natural 128x128", Wrap::Repeat).with_displacement(0.1, -0.1).expect("proper numbers");
        let texels = map.width() as f32;
        let surface = surface_of(map, selection);
        let both = in_two(&selection, Some(Wrap::Repeat), Profile::Unreal5);
        let points = plane.points();
        let given: Vec<_> = points.iter().map(|(point, ..)| *point).collect();
        let seen = device.seen(&both, &surface, &given);
        let shown = device.seen_by_node(&both, &surface, &plane);
        let agrees = |(((_, way, depth), seen), shown): &((&(_, Vec3, f32), &Seen), &Sight)| {
            let [u, v] = plane.along;
            let [x, y, z] = seen.normal;
            let bent = u * x + v * y + plane.normal * z;
            // The hit's depth along the view axis, to which Unreal adds the offset.
            let hit = (*way + way.normalize() * seen.depth).length() / way.length() * depth;
            shown.mask == 1.0
                && (shown.uv - Vec2::from(seen.uv)).length() * texels < 0.05
                && (shown.bent - bent).length() < 0.01
                && (depth + shown.depth_offset - hit).abs() < 1e-3
                && (shown.light > 0.5) == (seen.light > 0.5)
        };
        let pairs = points.iter().zip(&seen).zip(&shown);
        let agreeing = pairs.filter(agrees).count();
        let lit = shown.iter().filter(|sight| sight.light > 0.5).count();
        println!("{method}, plane {number}: {agreeing} of {} agree, {lit} lit", points.len());
        assert!(agreeing * 100 >= points.len() * 98, "{method}, plane {number}: {agreeing}");
        assert!(lit > points.len() / 10 && lit < points.len() * 9 / 10, "{lit}");
    }
}
