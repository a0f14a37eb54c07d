//! `relief inspect` against maps whose content is known.

use crate::common::command::Folder;
use crate::common::files::{Samples, tiff};
use crate::common::maps::{Map, encoded};
use image::{DynamicImage, ImageFormat, RgbImage};
use relief_io::write_exr;
use serde_json::{Value, json};

fn inspect(folder: &Folder, line: &str) -> Value {
    let ran = folder.relief(&format!("inspect --json {line}")).fine();
    serde_json::from_str(&ran.stdout).expect("JSON")
}

/// The normal map of a map that tiles, in OpenGL's convention: green up in the picture.
fn normals(map: &Map) -> RgbImage {
    let at = |x: i64, y: i64| {
        let [x, y] = [x.rem_euclid(i64::from(map.width)), y.rem_euclid(i64::from(map.height))];
        f64::from(map.texels[(y * i64::from(map.width) + x) as usize]) / 65535.0
    };
    RgbImage::from_fn(map.width, map.height, |x, y| {
        let (x, y) = (i64::from(x), i64::from(y));
        let [du, dv] = [at(x + 1, y) - at(x - 1, y), at(x, y + 1) - at(x, y - 1)];
        let length = (du * du + dv * dv + 0.25).sqrt();
        image::Rgb([-du, dv, 0.5].map(|part| ((part / length * 0.5 + 0.5) * 255.0).round() as u8))
    })
}

#[test]
fn size_depth_range_levels_and_histogram_are_those_of_the_map() {
    let folder = Folder::new();
    // Sixteen levels, each as often as the others; the last column is far above the first.
    let steps = Map::new(16, 8, |x, _| 1000 + 2000 * x as u16);
    folder.write("steps.png", steps.png());
    let about = inspect(&folder, "steps.png");
    assert_eq!(about["format"], "PNG");
    assert_eq!((&about["width"], &about["height"]), (&json!(16), &json!(8)));
    assert_eq!(about["channels"], json!([{ "name": "y", "sample": "16-bit unsigned" }]));
    let values = &about["values"];
    assert_eq!(values["range"], json!([1000.0, 31000.0]));
    assert_eq!(values["normalised_range"], json!([0.0, 65535.0]));
    assert_eq!(values["levels"], 16);
    let histogram: Vec<u64> = serde_json::from_value(values["histogram"].clone()).expect("numbers");
    assert_eq!(histogram.iter().sum::<u64>(), 128);
    assert_eq!(histogram.iter().filter(|&&count| count == 8).count(), 16);
    assert_eq!(values["tiling"]["tiles"], json!([false, true]));

    let text = folder.relief("inspect steps.png").fine().stdout;
    for part in ["steps.png", "16x8", "16-bit", "1000", "31000", "16 levels", "does not tile", "tiles"] {
        assert!(text.contains(part), "'{part}' is missing:\n{text}");
    }
}

#[test]
fn maps_that_tile_are_told_from_those_that_do_not() {
    let folder = Folder::new();
    folder.write("hills.png", Map::hills().png());
    assert_eq!(inspect(&folder, "hills.png")["values"]["tiling"]["tiles"], json!([true, true]));
    folder.write("ramp.png", Map::new(9, 64, |_, y| 1000 * y as u16).png());
    assert_eq!(inspect(&folder, "ramp.png")["values"]["tiling"]["tiles"], json!([true, false]));
}

#[test]
fn floats_keep_their_units_and_holes_are_counted() {
    let folder = Folder::new();
    let texels = [236.5, 300.0, f32::NAN, 1076.0, f32::INFINITY, 300.0];
    let path = folder.path("dem.exr");
    write_exr(&path, 3, 2, &[("metres", &texels), ("other", &[0.5; 6])]).expect("an EXR");
    let about = inspect(&folder, "dem.exr --channel metres");
    let values = &about["values"];
    assert_eq!((&values["channel"], &values["not_finite"]), (&json!("metres"), &json!(2)));
    assert_eq!(values["range"], json!([236.5, 1076.0]));
    assert_eq!((&values["levels"], &values["tiling"]), (&json!(3), &Value::Null));
    // Nothing says which of two channels is the height.
    assert_eq!(inspect(&folder, "dem.exr")["values"], Value::Null);
    assert!(folder.relief("inspect dem.exr").fine().stdout.contains("--channel"));
}

#[test]
fn height_and_depth_and_both_greens_are_told_apart() {
    let folder = Folder::new();
    let (map, up) = (Map::hills(), normals(&Map::hills()));
    let mut down = up.clone();
    down.pixels_mut().for_each(|pixel| pixel.0[1] = 255 - pixel.0[1]);
    folder.write("height.png", map.png());
    folder.write("depth.png", Map { texels: map.texels.iter().map(|&h| 65535 - h).collect(), ..map }.png());
    for (name, image) in [("up.png", up), ("down.png", down)] {
        folder.write(name, encoded(&DynamicImage::ImageRgb8(image), ImageFormat::Png));
    }
    for (kind, normal, green) in
        [("height", "up", "+y"), ("height", "down", "-y"), ("depth", "up", "+y"), ("depth", "down", "-y")]
    {
        let found = inspect(&folder, &format!("{kind}.png --normal {normal}.png"));
        let found = &found["detection"];
        assert_eq!((&found["convention"], &found["green"]), (&json!(kind), &json!(green)), "{kind} {normal}");
        for confidence in ["convention_confidence", "green_confidence"] {
            let sure = found[confidence].as_f64().expect("a number");
            assert!((0.9..=1.0).contains(&sure), "{kind} {normal}: {confidence} {sure}");
        }
        let text = folder.relief(&format!("inspect {kind}.png --normal {normal}.png")).fine().stdout;
        assert!(text.contains(kind) && text.contains(green) && text.contains('%'), "{text}");
        assert_eq!(text.contains("--depth"), kind == "depth", "{text}");
    }
    assert_eq!(inspect(&folder, "height.png")["detection"], Value::Null);
}

#[test]
fn orientations_and_pages_are_told() {
    let folder = Folder::new();
    let data: Vec<u8> = (0..24u16 * 16).flat_map(|texel| (texel * 50).to_le_bytes()).collect();
    let tagged = |orientation: u16| {
        tiff([24, 16], Samples::Short, &data, &[(274, 3, orientation.to_le_bytes().to_vec())])
    };
    for (orientation, width, turned, noted) in [
        (1, 24, false, false),
        (3, 24, true, false),
        (6, 16, true, false),
        (0, 24, false, true),
        (9, 24, false, true),
    ] {
        folder.write("map.tif", tagged(orientation));
        let ran = folder.relief("inspect map.tif");
        assert_eq!(ran.code, Some(0), "{ran:?}");
        assert!(ran.stdout.contains(&format!("{width}x")), "{ran:?}");
        assert_eq!(ran.stdout.contains("turned"), turned, "{ran:?}");
        assert_eq!(ran.stdout.contains(" note "), noted, "{ran:?}");
        let about = inspect(&folder, "map.tif");
        let followed = if turned { orientation } else { 1 };
        assert_eq!(about["orientation"], json!(followed));
        assert_eq!(about["notes"].as_array().map(Vec::len), Some(usize::from(noted)));
        for line in [
            "render --height map.tif --size 8x8 --backend cpu -o a.png",
            "render --height map.tif --color map.tif --size 8x8 --backend cpu -o a.png",
            "bake map.tif --kind normal -o out",
            "mesh map.tif -o a.ply",
        ] {
            let ran = folder.relief(line);
            assert_eq!(ran.code, Some(0), "{ran:?}");
            assert_eq!(ran.stderr.matches("names the orientation").count(), usize::from(noted), "{ran:?}");
            let quiet = folder.relief(&format!("{line} -q"));
            assert!(quiet.code == Some(0) && quiet.stderr.is_empty(), "{quiet:?}");
        }
    }
}

#[test]
fn scenes_and_objects_are_named() {
    let folder = Folder::new();
    folder.write("scene.toml", "height = 'map.png'\n");
    folder.write("ball/object.toml", "[[view]]\n");
    for (file, named) in [("scene.toml", "scene"), ("ball/object.toml", "object")] {
        let ran = folder.relief(&format!("inspect {file}"));
        let has_all = [file, named, "render"].iter().all(|word| ran.stderr.contains(word));
        assert!(ran.code == Some(1) && has_all && !ran.stderr.contains("--raw"), "{}", ran.stderr);
    }
}

#[test]
fn folders_of_textures_are_listed() {
    let folder = Folder::new();
    let orm = DynamicImage::ImageRgb8(RgbImage::new(8, 4));
    folder.write("wall/wall_Height.png", Map::hills().png());
    folder.write("wall/wall_NormalDX.png", encoded(&orm, ImageFormat::Png));
    folder.write("wall/wall_ARM.png", encoded(&orm, ImageFormat::Png));
    folder.write("wall/wall_Bump.png", Map::hills().png());
    folder.write("wall/readme.txt", "");
    let about = inspect(&folder, "wall");
    assert_eq!(about["name"], "wall");
    let textures = about["textures"].as_array().expect("a list");
    let of = |file: &str| textures.iter().find(|texture| texture["file"] == file).expect("it is found");
    assert_eq!(textures.len(), 3);
    assert_eq!((&of("wall_Height.png")["width"], &of("wall_Height.png")["height"]), (&json!(16), &json!(12)));
    assert_eq!(
        (&of("wall_NormalDX.png")["green"], &of("wall_NormalDX.png")["role"]),
        (&json!("-y"), &json!("normals"))
    );
    assert_eq!(of("wall_ARM.png")["channels"][1], json!({ "channel": "green", "role": "roughness" }));
    let left = about["left"].as_array().expect("a list");
    assert_eq!(left.len(), 2);
    assert_eq!(left[1]["reason"], "wall_Height.png was taken for its role");

    let text = folder.relief("inspect wall").fine().stdout;
    for part in
        ["3 textures of the material wall", "height, PNG, 16x12", "blue: metalness", "readme.txt (is not"]
    {
        assert!(text.contains(part), "'{part}' is missing:\n{text}");
    }
    folder.write("two/a_Height.1001.png", Map::hills().png());
    folder.write("two/a_Height.1002.png", Map::hills().png());
    folder.write("bad/a_Color.png", "no picture");
    for (line, code, part) in [
        ("two", 1, "use --udim"),
        ("bad", 1, "a_Color.png"),
        ("wall --normal wall/wall_NormalDX.png", 2, "--normal is for height maps"),
        ("wall/wall_Height.png --udim 1001", 2, "--udim is for folders"),
    ] {
        let ran = folder.relief(&format!("inspect {line}"));
        assert!(ran.code == Some(code) && ran.stderr.contains(part), "{line}: {}", ran.stderr);
    }
    assert_eq!(inspect(&folder, "two --udim 1002")["textures"][0]["udim"], 1002);
}
