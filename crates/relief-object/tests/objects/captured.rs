//! Built-in shapes as objects: heights compared with closed forms, and files that are read as they
//! were written.

use std::fs;

use glam::{DVec2, DVec3};
use relief_core::Watch;
use relief_core::mesh::{Builtin, Mesh};
use relief_core::object::{JumpCells, View};
use relief_io::{MeshColors, Picture};
use relief_object::{
    Arrangement, CaptureError, CaptureSettings, Captured, Capturer, Cover, ObjectOptions, ObjectWriter,
    read_object,
};

const ALONE: fn(std::time::Duration) -> bool = |_| true;

fn mesh(builtin: Builtin) -> Mesh {
    builtin.build([1.0; 2]).expect("a mesh")
}

fn captured(mesh: &Mesh, settings: CaptureSettings, cover: Cover) -> Captured {
    let capturer = Capturer::new(mesh, None, settings).expect("views");
    capturer.capture(cover, &Watch::none()).expect("images")
}

fn settings(size: u32) -> CaptureSettings {
    CaptureSettings { size, ..CaptureSettings::default() }
}

/// Calls `of` with every texel's view, ray and height.
fn each_texel(captured: &Captured, mut of: impl FnMut(&View, DVec3, DVec3, f64)) {
    for (view, image) in captured.views.iter().zip(&captured.images) {
        let [columns, rows] = view.size();
        for y in 0..rows {
            for x in 0..columns {
                let [u, v] =
                    [(x, columns), (y, rows)].map(|(at, side)| (f64::from(at) + 0.5) / f64::from(side));
                let ray = view.ray(u, v);
                let height = image.heights.texel(i64::from(x), i64::from(y));
                of(view, ray.origin, ray.direction.normalize(), f64::from(height));
            }
        }
    }
}

/// Distance of a point from a solid, negative inside.
type Distance = dyn Fn(DVec3) -> f64;

/// Distance along a ray from outside to a solid. `None` if it misses.
fn march(origin: DVec3, direction: DVec3, distance: &Distance) -> Option<f64> {
    let mut t = 0.0;
    for _ in 0..400 {
        let left = distance(origin + direction * t);
        if left < 1e-9 {
            return Some(t);
        }
        t += left;
        if t > 20.0 {
            return None;
        }
    }
    // The ray passes along the surface.
    None
}

#[test]
fn heights_are_those_of_the_shapes() {
    let cube = |at: DVec3| {
        let beyond = at.abs() - 0.5;
        beyond.max(DVec3::ZERO).length() + beyond.max_element().min(0.0)
    };
    let ball = |at: DVec3| at.length() - 0.5;
    let torus = |at: DVec3| {
        let around = DVec2::new(at.x, at.z).length() - TORUS[0];
        DVec2::new(around, at.y).length() - TORUS[1]
    };
    let shapes: [(Builtin, f64, &Distance); 3] =
        [(Builtin::Cube, 1e-6, &cube), (Builtin::Sphere, 2e-3, &ball), (Builtin::Torus, 2e-3, &torus)];
    for (builtin, most, distance) in shapes {
        for fov_degrees in [None, Some(40.0)] {
            let arrangement = Arrangement::Octahedral(3);
            let settings = CaptureSettings { arrangement, fov_degrees, ..settings(64) };
            let captured = captured(&mesh(builtin), settings, Cover::Centre);
            let (mut both, mut one) = (0, 0);
            each_texel(&captured, |view, origin, direction, height| {
                let expected = march(origin, direction, distance)
                    .map(|t| view.see(origin + direction * t).expect("before the eye").z);
                match (expected, height > 0.0) {
                    (Some(expected), true) => {
                        both += 1;
                        // Where the surface is steep a small step aside is a large one in depth.
                        let near = |part: f64| (height - expected).abs() <= part;
                        one += u32::from(!near(most));
                        assert!(near(0.2), "{builtin}: {height} in place of {expected}");
                    }
                    (None, false) => {}
                    _ => one += 1,
                }
            });
            assert!(both > 5000, "{builtin}: {both}");
            assert!(f64::from(one) < 0.05 * f64::from(both), "{builtin}: {one} of {both} are wrong");
            assert_eq!(captured.backs, 0, "{builtin} is closed");
        }
    }
}

/// Radii of the built-in torus: of its circle and of its tube.
const TORUS: [f64; 2] = [0.35, 0.15];

#[test]
fn a_cube_is_seen_to_its_edges() {
    // The cube is a little less than half as wide as the ball.
    for (cover, least) in [(Cover::Centre, 0.0), (Cover::Pixel, 0.0)] {
        let captured = captured(&mesh(Builtin::Cube), settings(41), cover);
        for (view, image) in captured.views.iter().zip(&captured.images) {
            let front = view.see(view.axes()[2] * 0.5).expect("before the eye").z as f32;
            let expected = |height: f32| height == front || height == least;
            assert!(image.heights.texels().iter().all(|height| expected(*height)), "{cover}");
            let wide = image.heights.texels().iter().filter(|height| **height > 0.0).count();
            let texels = 1.0 / view.texel_m();
            let side = (wide as f64).sqrt();
            let slack = if cover == Cover::Pixel { 0.0..=2.0 } else { -1.0..=1.0 };
            assert!(slack.contains(&(side - texels)), "{cover}: {side} of {texels}");
        }
    }
}

#[test]
fn the_highest_point_of_a_texel_is_at_least_as_high_as_its_middle() {
    for (builtin, fov_degrees, bits) in
        [(Builtin::Torus, None, 32), (Builtin::Sphere, Some(60.0), 8), (Builtin::Cylinder, None, 16)]
    {
        let settings = CaptureSettings { fov_degrees, bits, ..settings(48) };
        let [centre, pixel] = Cover::ALL.map(|cover| captured(&mesh(builtin), settings.clone(), cover));
        let mut more = 0;
        for (a, b) in centre.images.iter().zip(&pixel.images) {
            for (a, b) in a.heights.texels().iter().zip(b.heights.texels()) {
                assert!(b >= a, "{builtin}: {b} below {a}");
                more += u32::from(b > a);
            }
        }
        assert!(more > 100 && pixel.seen > centre.seen, "{builtin}");
    }
}

fn colors() -> MeshColors {
    let texels = (0..16).map(|at| [at as f32 / 15.0, 0.5, 0.25, 1.0]).collect();
    MeshColors::of([1.0, 0.5, 1.0], Some(Picture { width: 4, height: 4, texels }))
}

#[test]
fn what_is_written_is_read_as_it_was() {
    let mesh = mesh(Builtin::Torus);
    let colors = colors();
    for (bits, arrangement) in [
        (32, Arrangement::Cube),
        (16, Arrangement::Octahedral(3)),
        (8, Arrangement::HemiOctahedral(2)),
        (32, Arrangement::Horizontal(5)),
    ] {
        for fov_degrees in [None, Some(35.0)] {
            let arrangement = arrangement.clone();
            let settings = CaptureSettings { bits, arrangement, fov_degrees, ..settings(32) };
            let capturer = Capturer::new(&mesh, Some(&colors), settings).expect("views");
            let captured = capturer.capture(Cover::Pixel, &Watch::none()).expect("images");
            let folder = tempfile::tempdir().expect("a folder");
            let place = folder.path().join("made/torus");
            let writer =
                ObjectWriter::open(&place, captured.files(), false, &mut { ALONE }).expect("a folder");
            let files = writer.write(&captured, None).expect("written");
            let names: Vec<_> = files.iter().filter_map(|file| file.file_name()?.to_str()).collect();
            assert_eq!(names.contains(&"normal-depth.png"), captured.grid.is_some());
            let read = read_object(&place.join("object.toml"), &ObjectOptions::default()).expect("an object");
            assert_eq!(read.object, captured.object(JumpCells::Highest, 4.0).expect("an object"));
            let (color, normal) = (read.color.expect("colours"), read.normal.expect("normals"));
            assert_eq!(normal.degenerate, 0);
            let columns = read.object.layout().size()[0] as usize;
            let step = if bits == 8 { 1.0 / 127.0 } else { 1e-4 };
            for (image, place) in captured.images.iter().zip(read.object.layout().places()) {
                for (at, height) in image.heights.texels().iter().enumerate() {
                    let packed = (place[1] as usize + at / 32) * columns + place[0] as usize + at % 32;
                    let near =
                        |a: &[f32], b: &[f32], most: f32| a.iter().zip(b).all(|(a, b)| (a - b).abs() <= most);
                    let own = image.colors.as_ref().expect("colours")[at];
                    assert!(near(&own, &color.texels[packed][..3], 0.01));
                    assert_eq!(color.texels[packed][3] > 0.0, *height > 0.0);
                    assert!(near(&image.normals[at], &normal.normals[packed], step * 1.5));
                }
            }
        }
    }
}

#[test]
fn the_same_bytes_are_written_whatever_the_threads() {
    let mesh = mesh(Builtin::Torus);
    let bytes = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| {
            let colors = colors();
            let settings = CaptureSettings { arrangement: Arrangement::Octahedral(4), ..settings(40) };
            let capturer = Capturer::new(&mesh, Some(&colors), settings).expect("views");
            let captured = capturer.capture(Cover::Pixel, &Watch::none()).expect("images");
            let folder = tempfile::tempdir().expect("a folder");
            let writer =
                ObjectWriter::open(folder.path(), captured.files(), false, &mut { ALONE }).expect("a folder");
            let files = writer.write(&captured, None).expect("written");
            files.iter().map(|file| fs::read(file).expect("readable")).collect::<Vec<_>>()
        })
    };
    assert_eq!(bytes(1), bytes(3));
}

#[test]
fn another_object_takes_the_place_of_one() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("notes.txt"), "mine").expect("written");
    fs::write(folder.path().join("color.png"), "mine").expect("written");
    let names = |bits: u32| {
        let captured =
            captured(&mesh(Builtin::Cube), CaptureSettings { bits, ..settings(16) }, Cover::Centre);
        let writer =
            ObjectWriter::open(folder.path(), captured.files(), false, &mut { ALONE }).expect("a folder");
        writer.write(&captured, None).expect("written");
        let mut names: Vec<_> = fs::read_dir(folder.path())
            .expect("readable")
            .map(|entry| entry.expect("readable").file_name().into_string().expect("text"))
            .collect();
        names.sort();
        names
    };
    // No object was there: existing files have another owner.
    assert_eq!(names(32), ["color.png", "depth.exr", "normal.png", "notes.txt", "object.toml"]);
    assert_eq!(names(16), ["color.png", "depth.png", "normal.png", "notes.txt", "object.toml"]);
    for name in ["notes.txt", "color.png"] {
        assert_eq!(fs::read(folder.path().join(name)).expect("readable"), b"mine");
    }
}

#[test]
fn what_cannot_be_captured_is_refused() {
    let mesh = mesh(Builtin::Cube);
    let refused = |settings: CaptureSettings| match Capturer::new(&mesh, None, settings) {
        Ok(_) => panic!("it was captured"),
        Err(error) => error,
    };
    let of = |arrangement: Arrangement| CaptureSettings { arrangement, ..settings(16) };
    assert_eq!(refused(settings(7)), CaptureError::BadSize(7));
    assert_eq!(refused(settings(16_385)), CaptureError::BadSize(16_385));
    assert_eq!(refused(of(Arrangement::Octahedral(1))), CaptureError::BadGrid(1));
    assert_eq!(refused(of(Arrangement::Octahedral(33))), CaptureError::BadGrid(33));
    assert_eq!(refused(of(Arrangement::Horizontal(0))), CaptureError::BadCount(0));
    assert_eq!(refused(of(Arrangement::Horizontal(1025))), CaptureError::BadCount(1025));
    assert_eq!(refused(CaptureSettings { bits: 24, ..settings(16) }), CaptureError::BadBits(24));
    for fov in [0.0, 180.0, f64::NAN] {
        let error = refused(CaptureSettings { fov_degrees: Some(fov), ..settings(16) });
        assert!(matches!(error, CaptureError::View { number: 1, .. }));
    }
    let eye = |eye: [f64; 3], fov_degrees: f64| relief_object::ViewSpec::Perspective {
        eye: eye.into(),
        up: None,
        fov_degrees,
    };
    let given = |spec| of(Arrangement::Given(vec![spec]));
    assert!(matches!(refused(given(eye([0.6, 0.0, 0.0], 60.0))), CaptureError::View { number: 1, .. }));
    assert_eq!(refused(given(eye([3.0, 0.0, 0.0], 10.0))), CaptureError::CutOff { number: 1 });
    let both = CaptureSettings { fov_degrees: Some(40.0), ..given(eye([3.0, 0.0, 0.0], 60.0)) };
    assert_eq!(refused(both), CaptureError::OwnFov);
    let little = CaptureSettings { max_bytes: 1 << 20, ..settings(209) };
    assert!(matches!(refused(little), CaptureError::TooMuchMemory { views: 6, size: 209, .. }));
}
