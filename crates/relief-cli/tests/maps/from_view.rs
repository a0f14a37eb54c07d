//! `relief height from-view`: an image of an object is a height map, which shows what the image
//! saw.

use crate::common::aov::Aov;
use crate::common::command::{Folder, json_of};
use crate::common::refused::{OUT, assert_refused, entries, with_out};
use glam::DVec3;
use relief_io::read_height;

/// Texels of a side of the images.
const SIDE: usize = 64;

/// A folder with a captured ball. The built-in sphere has a radius of half a metre.
fn folder() -> Folder {
    let folder = with_out();
    folder.relief(&format!("capture sphere --size {SIDE} --cover centre --verify 1 -q -o ball")).fine();
    folder
}

#[test]
fn a_captured_face_gives_its_picture_back() {
    let folder = folder();
    let line = "height from-view ball/object.toml --view 3 -o face.exr --normals n.exr --json";
    let about = json_of(&folder.relief(line).fine());
    let number = |key: &str| about[key].as_f64().expect("a number");
    assert_eq!([number("width"), number("bias_m")], [SIDE as f64, -1.0]);
    assert!(about["tile_m"][0] == 1.0 && about["from"][1] == 1.0, "{about}");
    let map = read_height(&folder.path("face.exr"), &Default::default()).expect("a map");
    assert_eq!([map.width(), map.height()], [SIDE as u32; 2]);
    let seen = map.texels().iter().filter(|texel| **texel > 0.0).count();
    assert_eq!(number("seen"), seen as f64);

    // On the plane the map is a metre wide: all is that much smaller, and lies below the plane.
    let (radius, half_a_texel) = (0.5 / number("width_m"), 0.5 / SIDE as f64);
    let centre = DVec3::new(0.0, -0.5, 0.0);
    for (eye, least) in [("0,3,0", 800), ("1.2,3,0.9", 500), ("-1.5,2,1.1", 400)] {
        let line = format!("render --height face.exr --wrap clamp --method exact --shadow none --eye {eye}");
        let line = format!("{line} --target 0,-0.3,0 --size 90x90 --samples 1 --backend cpu");
        folder.relief(&format!("{line} --aov a.exr -o a.png")).fine();
        let (mut of_ball, mut off) = (0, 0);
        for (_, _, pixel) in Aov::read(&folder.path("a.exr")).pixels() {
            // Only texels that the image saw well: not the wall below the outline, nor the floor.
            if pixel.hit == 1.0 && pixel.position.y > centre.y + 0.3 * radius {
                of_ball += 1;
                off += usize::from(((pixel.position - centre).length() - radius).abs() > half_a_texel);
            }
        }
        assert!(of_ball > least && off * 100 <= of_ball, "{eye}: {off} of {of_ball} are off");
    }
}

#[test]
fn what_sees_nothing_is_the_floor_or_a_hole() {
    let folder = folder();
    let view = "height from-view ball/object.toml --view 1";
    folder.relief(&format!("{view} -o floor.png")).fine();
    folder.relief(&format!("{view} --holes -o holes.exr")).fine();
    let covered = |flags: &str| {
        let line = format!("render {flags} --eye 0,3,0 --size 60x60 --backend cpu --json");
        json_of(&folder.relief(&format!("{line} -o a.png")).fine())["covered"].as_u64().expect("a number")
    };
    let (floor, holes) = (covered("--height floor.png"), covered("--height holes.exr --holes"));
    assert!(holes > 400 && floor > holes + 200, "{floor} {holes}");
}

#[test]
fn colours_lie_where_the_image_has_them() {
    let folder = with_out();
    // Halves of two colours, by the texture coordinates of a plane.
    let texels = [[200, 10, 10], [10, 10, 200]].concat();
    relief_io::write_png8(&folder.path("c.png"), 2, 1, relief_io::PngColour::Rgb, &texels).expect("writable");
    folder.relief("capture plane --color c.png --size 32 --verify 1 -q -o flat").fine();
    folder.relief("height from-view flat/object.toml --view 3 -o h.exr --albedo a.png").fine();
    let picture = image::open(folder.path("a.png")).expect("a picture").to_rgb8();
    assert_eq!(picture.dimensions(), (32, 32));
    let (left, right) = (picture.get_pixel(9, 16), picture.get_pixel(22, 16));
    assert!(left[0] > 150 && left[2] < 100 && right[0] < 100 && right[2] > 150, "{left:?} {right:?}");
}

#[test]
fn what_is_no_height_map_is_refused() {
    let folder = folder();
    folder.relief("capture sphere --size 16 --perspective 40 --verify 1 -q -o eyes").fine();
    let view = "height from-view ball/object.toml --view 1";
    for (line, code, words) in [
        ("height from-view ball/object.toml --view 0 -o out/a.exr".to_owned(), 2, &["1 to 6"][..]),
        ("height from-view ball/object.toml --view 7 -o out/a.exr".to_owned(), 2, &["--view", "1 to 6"]),
        ("height from-view ball/object.toml --view x -o out/a.exr".to_owned(), 2, &["--view"]),
        ("height from-view eyes/object.toml --view 1 -o out/a.exr".to_owned(), 1, &["perspective"]),
        ("height from-view no/object.toml --view 1 -o out/a.exr".to_owned(), 1, &["no/object.toml"]),
        (format!("{view} -o out/a.jpg"), 2, &["--output", "jpg"]),
        (format!("{view} -o no/a.exr"), 1, &["no"]),
        (format!("{view} --holes -o out/a.png"), 2, &["--holes", "EXR"]),
        (format!("{view} -o out/a.exr --normals out/a.exr"), 2, &["two outputs"]),
        (format!("{view} -o out/a.exr --albedo out/c.png"), 1, &["colours", "--albedo"]),
        (format!("{view} -o out/a.exr --max-memory 1KiB"), 1, &["memory"]),
    ] {
        assert_refused(&folder, &folder.relief(&line), code, words);
        assert_eq!(entries(&folder.path(OUT)), Vec::<String>::new(), "{line}");
    }
}
