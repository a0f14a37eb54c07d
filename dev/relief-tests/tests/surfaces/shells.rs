//! Shells in a file, drawn as a viewer of glTF draws them: by an alpha test and nothing else.
//!
//! Kautz and Seidel 2001, section 3.1.

use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use glam::{DVec2, DVec3, Vec3};
use relief_core::camera::Camera;
use relief_core::mesh::Mesh;
use relief_core::mesh::{square, torus};
use relief_core::raycast::{RayCaster, Sides};
use relief_core::{HeightMap, TexelMask, Watch, Wrap};
use relief_io::{DEFAULT_MAX_BYTES, MeshMaterial, Picture, Shells, WriteProblem, read_picture, write_shells};
use relief_maps::Maps;
use relief_render::render;
use relief_scene::{BackendChoice, Scene, Surface};
use relief_shaders::Selection;
use relief_shaders::cpu::PixelOut;
use serde_json::Value as Json;

/// Columns and rows of the pictures.
const SIZE: [u32; 2] = [160, 120];

/// Shells.
const COUNT: u32 = 12;

/// What a viewer knows of a file.
struct Viewed {
    /// The corners of all triangles: position, and texture coordinates.
    corners: Vec<[(Vec3, DVec2); 3]>,
    /// The material of each.
    materials: Vec<usize>,
    /// The least opacity that each material draws; none where it draws all.
    cutoffs: Vec<Option<f64>>,
    wrap: Wrap,
    picture: Picture,
}

fn number(json: &Json) -> usize {
    json.as_u64().expect("a number") as usize
}

impl Viewed {
    /// Reads a GLB as its format says.
    fn read(path: &Path) -> Self {
        let bytes = std::fs::read(path).expect("a file");
        let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().expect("4 bytes")) as usize;
        assert_eq!((&bytes[..4], word(4), word(8)), (&b"glTF"[..], 2, bytes.len()));
        let json: Json = serde_json::from_slice(&bytes[20..20 + word(12)]).expect("JSON");
        let buffer = &bytes[28 + word(12)..];
        assert_eq!((word(20 + word(12)), buffer.len() % 4), (buffer.len(), 0));
        let view = |place: &Json| {
            let view = &json["bufferViews"][number(place)];
            let first = number(&view["byteOffset"]);
            &buffer[first..first + number(&view["byteLength"])]
        };
        let words = |accessor: &Json| -> Vec<u32> {
            let accessor = &json["accessors"][number(accessor)];
            let words = view(&accessor["bufferView"]).as_chunks::<4>().0;
            words.iter().map(|word| u32::from_le_bytes(*word)).collect()
        };
        let (mut corners, mut materials) = (Vec::new(), Vec::new());
        for primitive in json["meshes"][0]["primitives"].as_array().expect("primitives") {
            let positions = words(&primitive["attributes"]["POSITION"]);
            let uvs = words(&primitive["attributes"]["TEXCOORD_0"]);
            let corner = |index: &u32| {
                let at = |list: &[u32], each: usize, part: usize| {
                    f32::from_bits(list[*index as usize * each + part])
                };
                let position = Vec3::from([0, 1, 2].map(|part| at(&positions, 3, part)));
                (position, DVec2::from([0, 1].map(|part| f64::from(at(&uvs, 2, part)))))
            };
            for triangle in words(&primitive["indices"]).as_chunks::<3>().0 {
                corners.push(triangle.each_ref().map(corner));
                materials.push(number(&primitive["material"]));
            }
        }
        let of_materials = json["materials"].as_array().expect("materials").iter();
        let cutoffs = of_materials.map(|material| {
            (material["alphaMode"] == "MASK").then(|| {
                assert_eq!(material["doubleSided"], true);
                material["alphaCutoff"].as_f64().expect("a cutoff")
            })
        });
        let wrap = match number(&json["samplers"][0]["wrapS"]) {
            10497 => Wrap::Repeat,
            33648 => Wrap::Mirror,
            _ => Wrap::Clamp,
        };
        let png = path.with_extension("png");
        std::fs::write(&png, view(&json["images"][0]["bufferView"])).expect("a file");
        let picture = read_picture(png.as_path(), DEFAULT_MAX_BYTES).expect("a picture");
        Self { corners, materials, cutoffs: cutoffs.collect(), wrap, picture }
    }

    /// The opacity at texture coordinates, between the centres of four texels.
    fn opacity(&self, uv: DVec2) -> f64 {
        let Picture { width, height, texels } = &self.picture;
        let at = uv * DVec2::new(f64::from(*width), f64::from(*height)) - 0.5;
        let (cell, part) = (at.floor(), at - at.floor());
        let texel = |dx: i64, dy: i64| {
            let column = self.wrap.index(cell.x as i64 + dx, *width);
            let row = self.wrap.index(cell.y as i64 + dy, *height);
            f64::from(texels[(row * width + column) as usize][3])
        };
        let [top, bottom] = [0, 1].map(|row| texel(0, row) + (texel(1, row) - texel(0, row)) * part.x);
        top + (bottom - top) * part.y
    }

    /// The texture coordinates at which each pixel's ray first meets what is drawn.
    fn seen(&self, camera: &Camera) -> Vec<Option<DVec2>> {
        let positions = self.corners.iter().map(|corners| corners.map(|(position, _)| position));
        let caster = RayCaster::of_corners(positions);
        let pixel = |number: u32| {
            let ray = camera.ray(number % SIZE[0], number / SIZE[0], SIZE[0], SIZE[1]);
            let drawn = |number: usize, at: DVec3| {
                let [a, b, c] = self.corners[number].map(|(position, _)| position.as_dvec3());
                let normal = (b - a).cross(c - a);
                let weight = |from: DVec3, to: DVec3| {
                    (to - from).cross(at - from).dot(normal) / normal.length_squared()
                };
                let weights = [weight(b, c), weight(c, a), weight(a, b)];
                let uvs = self.corners[number].map(|(_, uv)| uv);
                let uv = weights.iter().zip(uvs).map(|(weight, uv)| uv * *weight).sum::<DVec2>();
                let cutoff = self.cutoffs[self.materials[number]];
                cutoff.is_none_or(|cutoff| self.opacity(uv) >= cutoff).then_some(uv)
            };
            caster.hits(&ray, Sides::Both).find_map(|hit| drawn(hit.triangle as usize, ray.at(hit.t)))
        };
        (0..SIZE[0] * SIZE[1]).map(pixel).collect()
    }
}

/// Writes a surface as shells, and reads them as a viewer does.
fn viewed(mesh: &Mesh, map: &HeightMap, has_holes: bool, color: Option<&Picture>) -> Viewed {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("shells.glb");
    let material = color.map(|picture| MeshMaterial {
        picture: Some(Arc::new(picture.clone())),
        wrap: [map.wrap(); 2],
        ..MeshMaterial::default()
    });
    let color = material.as_ref();
    let shells = Shells { base: mesh, map, has_holes, color, factor: [0.5, 0.25, 1.0], count: COUNT };
    write_shells(&path, &shells, &Watch::none()).expect("a file");
    Viewed::read(&path)
}

/// A map of heights that 8 bits hold.
fn map(wrap: Wrap) -> HeightMap {
    let code = |i: u32, j: u32| (i * 37 + j * 91 + (i / 5) * (j / 7) * 13) % 256;
    let smooth = |i: u32, j: u32| {
        let sum: u32 = (0..5).flat_map(|y| (0..5).map(move |x| code((i + x) % 32, (j + y) % 24))).sum();
        (sum / 25) as f32 / 255.0
    };
    HeightMap::from_fn(32, 24, wrap, smooth).expect("a map").with_displacement(0.12, -0.02).expect("lengths")
}

fn rendered(mesh: &Mesh, map: &HeightMap, camera: Camera) -> Vec<PixelOut> {
    let mut selection = Selection::method("slices-surface").expect("a method");
    selection.set("slices.count", f64::from(COUNT)).expect("a setting");
    let surface = Surface::new(mesh.clone(), map.clone()).with_selection(selection).with_two_sided(true);
    let scene = Scene::builder(surface).camera(camera).size(SIZE[0], SIZE[1]).samples(1);
    let scene = scene.backend(BackendChoice::Cpu).build().expect("a scene");
    render(&scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture").rendering.pixels
}

/// The share of pixels in which both show the same, of those in which either shows something.
fn alike(rendered: &[PixelOut], seen: &[Option<DVec2>]) -> f64 {
    let pairs = || rendered.iter().zip(seen).filter(|(pixel, seen)| pixel.hit == 1 || seen.is_some());
    let is_same = |(pixel, seen): &(&PixelOut, &Option<DVec2>)| {
        let at = DVec2::new(f64::from(pixel.uv.x), f64::from(pixel.uv.y));
        pixel.hit == 1 && seen.is_some_and(|seen| (seen - at).length() < 1e-4)
    };
    assert!(pairs().count() > 3000, "{} pixels", pairs().count());
    pairs().filter(is_same).count() as f64 / pairs().count() as f64
}

#[test]
fn viewers_show_the_slices_that_are_rendered() {
    let camera = |eye| Camera::new(eye, DVec3::ZERO, 36.0).expect("a camera");
    let eyes = [DVec3::new(0.3, 1.2, 1.4), DVec3::new(-1.5, 0.7, 0.6)];
    for (eye, wrap) in eyes.into_iter().zip([Wrap::Repeat, Wrap::Mirror]) {
        for mesh in [square(3).expect("a mesh"), torus(24, 12).expect("a mesh")] {
            let map = map(wrap);
            let viewed = viewed(&mesh, &map, false, None);
            let seen = viewed.seen(&camera(eye));
            let share = alike(&rendered(&mesh, &map, camera(eye)), &seen);
            println!("{wrap:?}: {share:.5} alike");
            assert!(share > 0.995, "{wrap:?}: {share}");
            // Shells a little lower than they are to be are noticed.
            let lower = Viewed {
                cutoffs: viewed.cutoffs.iter().map(|of| of.map(|of| of + 0.04)).collect(),
                ..viewed
            };
            let wrong = alike(&rendered(&mesh, &map, camera(eye)), &lower.seen(&camera(eye)));
            assert!(wrong < 0.97, "{wrap:?}: {wrong}");
        }
    }
}

#[test]
fn holes_are_seen_through_and_colours_lie_where_they_did() {
    let mesh = square(1).expect("a mesh");
    let is_hole = |i: u32, j: u32| i > 20 && j < 10;
    let map = map(Wrap::Clamp).with_holes(TexelMask::from_fn(32, 24, is_hole)).expect("a mask");
    let camera = Camera::new(DVec3::new(0.01, 2.0, 0.02), DVec3::ZERO, 36.0).expect("a camera");
    let [with, without] = [true, false].map(|has_holes| {
        let seen = viewed(&mesh, &map, has_holes, None).seen(&camera);
        seen.iter().filter(|seen| seen.is_some()).count() as f64
    });
    let share = with / without;
    assert!((0.8..0.92).contains(&share), "{share}");
    // A finer picture keeps its texels, and heights lie between theirs.
    let texels = (0..64 * 48).map(|at: u32| [(at % 64) as f32 / 63.0, 0.25, (at / 64) as f32 / 47.0, 1.0]);
    let color = Picture { width: 64, height: 48, texels: texels.collect() };
    let viewed = viewed(&mesh, &map, false, Some(&color));
    assert_eq!([viewed.picture.width, viewed.picture.height], [64, 48]);
    for (seen, texel) in viewed.picture.texels.iter().zip(&color.texels) {
        assert!((0..3).all(|part| (seen[part] - texel[part]).abs() < 0.005), "{seen:?} of {texel:?}");
    }
    for uv in [DVec2::new(0.3, 0.6), DVec2::new(0.71, 0.2)] {
        assert!((viewed.opacity(uv) - map.height_at(uv.x, uv.y)).abs() < 0.02, "{uv}");
    }
}

#[test]
fn shells_that_are_cancelled_leave_no_file() {
    let (mesh, map) = (square(2).expect("a square"), map(Wrap::Repeat));
    let shells =
        Shells { base: &mesh, map: &map, has_holes: false, color: None, factor: [1.0; 3], count: COUNT };
    let folder = tempfile::tempdir().expect("a folder");
    for end in [0.0, 0.5, 1.0] {
        let cancel = AtomicBool::new(end == 0.0);
        let tell = |_: &str, part: f32| {
            cancel.fetch_or(part >= end - 0.25, Ordering::Relaxed);
        };
        let written = write_shells(&folder.path().join("shells.glb"), &shells, &Watch::new(&tell, &cancel));
        let problem = written.map_err(|error| error.problem);
        assert!(matches!(problem, Err(WriteProblem::Cancelled(_))), "{end}: {problem:?}");
        assert_eq!(std::fs::read_dir(folder.path()).expect("a folder").count(), 0, "{end}");
    }
}
