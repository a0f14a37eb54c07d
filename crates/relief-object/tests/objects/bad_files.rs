//! Bad files of objects. Each is refused with its name, line and view.

use std::fs;
use std::path::Path;

use relief_io::{PngColour, write_exr, write_png8, write_png16};
use relief_object::{ObjectFileError, ObjectOptions, read_object};

/// Two views side by side in an atlas of 8 x 4 texels.
const GOOD: &str = r#"kind = "orthographic"
centre = [0, 0, 0]
radius = 1.0
depth = "depth.exr"
[[view]]
from = [1, 0, 0]
rect = [0, 0, 4, 4]
[[view]]
from = [0, 0, 1]
up = [0, 1, 0]
rect = [4, 0, 4, 4]
"#;

const PERSPECTIVE: &str = r#"kind = "perspective"
centre = [0, 0, 0]
radius = 1.0
depth = "depth.exr"
[[view]]
eye = [3, 0, 0]
fov = 45
rect = [0, 0, 4, 4]
"#;

const MEASURED: &str = r#"[measured]
views = 2
size = 64
cells = "highest"
jump = 4
iou = 0.99
depth-error = 0.1
worst-from = [1, 0, 0]
worst-iou = 0.98
worst-depth-error = 0.2
"#;

fn atlas(folder: &Path, name: &str, heights: &[f32]) {
    write_exr(&folder.join(name), 8, heights.len() as u32 / 8, &[("Y", heights)]).expect("written");
}

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    atlas(folder.path(), "depth.exr", &[0.5; 32]);
    folder
}

fn refused(folder: &Path, text: &str) -> String {
    let path = folder.join("object.toml");
    fs::write(&path, text).expect("written");
    match read_object(&path, &ObjectOptions::default()) {
        Ok(_) => panic!("this was read:\n{text}"),
        Err(error) => error.to_string(),
    }
}

#[test]
fn good_files_are_read() {
    let folder = folder();
    for (text, views) in [
        (GOOD.to_owned(), 2),
        (PERSPECTIVE.to_owned(), 1),
        (format!("{GOOD}{MEASURED}"), 2),
        (GOOD.replace("[0, 0, 4, 4]", "[0, 0, 4, 2]"), 2),
    ] {
        let path = folder.path().join("object.toml");
        fs::write(&path, &text).expect("written");
        let file = read_object(&path, &ObjectOptions::default()).expect(&text);
        assert_eq!(file.object.views().len(), views);
        assert_eq!(file.measured.is_some(), text.contains("measured"));
    }
}

#[test]
fn what_the_text_says_is_refused_by_line_and_view() {
    let folder = folder();
    let many = "[[view]]\nfrom = [1, 0, 0]\nrect = [0, 0, 1, 1]\n".repeat(1025);
    let head = GOOD.split("[[view]]").next().expect("a head");
    // Text to replace, its replacement, and parts of the error message.
    let changed: [(&str, &str, &[&str]); 27] = [
        ("kind = \"orthographic\"", "kind = \"ortographic\"", &["line 1", "did you mean 'orthographic'"]),
        ("kind = \"orthographic\"\n", "", &["kind"]),
        ("kind =", "kin =", &["line 1", "did you mean 'kind'"]),
        ("kind = \"orthographic\"", "kind = \"perspective\"", &["view 1", "line 5", "'from'"]),
        ("centre = [0, 0, 0]", "centre = [0, 0]", &["line 2", "2 numbers"]),
        ("centre = [0, 0, 0]", "centre = [0, nan, 0]", &["centre", "finite"]),
        ("radius = 1.0", "radius = 0", &["radius"]),
        ("radius = 1.0", "radius = -2", &["radius"]),
        ("radius = 1.0", "radius = inf", &["radius", "finite"]),
        ("radius = 1.0", "radius = \"wide\"", &["line 3"]),
        ("from = [1, 0, 0]", "from = [0, 0, 0]", &["view 1", "line 5", "from"]),
        ("from = [1, 0, 0]", "from = [nan, 0, 0]", &["view 1", "from"]),
        ("from = [1, 0, 0]", "from = [1, 0]", &["view 1", "'from' has 2"]),
        ("from = [1, 0, 0]\n", "", &["view 1", "'from' is missing"]),
        ("from = [1, 0, 0]", "form = [1, 0, 0]", &["view 1", "line 6", "did you mean 'from'"]),
        ("from = [1, 0, 0]", "eye = [9, 0, 0]", &["view 1", "'eye'"]),
        ("from = [1, 0, 0]", "from = [1, 0, 0]\nfov = 3", &["view 1", "'fov'"]),
        ("up = [0, 1, 0]", "up = [0, 0, -2]", &["view 2", "line 8", "up"]),
        ("up = [0, 1, 0]", "up = [0, 1, 0, 0]", &["view 2", "'up' has 4"]),
        ("rect = [0, 0, 4, 4]\n", "", &["view 1", "'rect' is missing"]),
        ("rect = [0, 0, 4, 4]", "rect = [0, 0, 4]", &["view 1", "'rect' has 3"]),
        ("rect = [0, 0, 4, 4]", "rect = [-1, 0, 4, 4]", &["line 7"]),
        ("rect = [0, 0, 4, 4]", "rect = [0, 0, 0, 4]", &["view 1", "rect", "0x4"]),
        ("rect = [4, 0, 4, 4]", "rect = [3, 1, 4, 3]", &["view 2", "line 8", "overlaps", "view 1"]),
        ("rect = [4, 0, 4, 4]", "rect = [5, 0, 4, 4]", &["view 2", "beyond", "depth.exr", "8x4"]),
        ("rect = [4, 0, 4, 4]", "rect = [4294967295, 0, 4, 4]", &["view 2", "beyond"]),
        ("rect = [4, 0, 4, 4]", "rect = [4, 0, 4294967295, 4294967295]", &["view 2", "too large"]),
    ];
    for (from, to, names) in changed {
        assert!(GOOD.contains(from), "{from}");
        let said = refused(folder.path(), &GOOD.replacen(from, to, 1));
        for name in names.iter().chain(&["object.toml"]) {
            assert!(said.contains(name), "{to}: '{name}' is not in: {said}");
        }
    }
    for (text, name) in [
        (String::new(), "object.toml"),
        (head.to_owned(), "this one 0"),
        (format!("{head}{many}"), "this one 1025"),
        ("kind = [".to_owned(), "line 1"),
        (format!("{GOOD}# {}\n", "long ".repeat(1 << 18)), "too long"),
        (format!("{GOOD}view = 3\n"), "object.toml"),
        (GOOD.replace("[[view]]", "[view]"), "object.toml"),
        (PERSPECTIVE.replace("[3, 0, 0]", "[0.5, 0, 0]"), "inside of the ball"),
        (PERSPECTIVE.replace("fov = 45", "fov = 180"), "field of view"),
        (PERSPECTIVE.replace("fov = 45\n", ""), "'fov' is missing"),
        (format!("{GOOD}{}", MEASURED.replace("iou = 0.99", "iou = 1.5")), "from 0 to 1"),
        (format!("{GOOD}{}", MEASURED.replace("\"highest\"", "\"hihest\"")), "did you mean 'highest'"),
        (format!("{GOOD}{}", MEASURED.replace("views =", "view =")), "did you mean 'views'"),
    ] {
        let said = refused(folder.path(), &text);
        assert!(said.contains(name) && said.contains("object.toml"), "'{name}' is not in: {said}");
    }
}

#[test]
fn files_elsewhere_are_refused() {
    let outer = tempfile::tempdir().expect("a folder");
    let folder = outer.path().join("object");
    fs::create_dir(&folder).expect("made");
    atlas(outer.path(), "depth.exr", &[0.5; 32]);
    let absolute = outer.path().join("depth.exr");
    for name in ["../depth.exr", &absolute.to_string_lossy(), "missing.exr", ""] {
        let said = refused(&folder, &GOOD.replace("depth.exr", name));
        assert!(said.contains("object.toml"), "{name}: {said}");
    }
    assert!(refused(&folder, &GOOD.replace("depth.exr", ".")).contains("folder"));
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(&absolute, folder.join("link.exr")).expect("a link");
        assert!(refused(&folder, &GOOD.replace("depth.exr", "link.exr")).contains("not in its folder"));
    }
    // The object's file is missing, or is a folder.
    for path in [folder.join("nothing.toml"), folder] {
        let error = read_object(&path, &ObjectOptions::default());
        assert!(matches!(error, Err(ObjectFileError::Io { .. })));
    }
}

#[test]
fn pictures_that_cannot_be_are_refused() {
    let folder = folder();
    let at = folder.path();
    for (bad, name) in [(f32::NAN, "NaN"), (-0.1, "range"), (1.5, "range"), (f32::INFINITY, "infinite")] {
        let mut heights = [0.5; 32];
        heights[9] = bad;
        atlas(at, "bad.exr", &heights);
        let said = refused(at, &GOOD.replace("depth.exr", "bad.exr"));
        assert!(said.contains("bad.exr") && said.contains(name), "{bad}: {said}");
    }
    fs::write(at.join("text.exr"), "no picture").expect("written");
    assert!(refused(at, &GOOD.replace("depth.exr", "text.exr")).contains("text.exr"));
    let rgb: Vec<u8> = (0..32).flat_map(|texel| [texel * 8, 0, 255]).collect();
    write_png8(&at.join("color.png"), 8, 4, PngColour::Rgb, &rgb).expect("written");
    assert!(refused(at, &GOOD.replace("depth.exr", "color.png")).contains("color.png"));
    // Colours and normals with another size than the depths.
    write_png8(&at.join("small.png"), 4, 4, PngColour::Rgb, &rgb[..48]).expect("written");
    for key in ["color", "normal"] {
        let text =
            GOOD.replace("[[view]]\nfrom = [1", &format!("{key} = \"small.png\"\n[[view]]\nfrom = [1"));
        let said = refused(at, &text);
        assert!(said.contains("small.png") && said.contains("4x4") && said.contains("8x4"), "{said}");
    }
    // A claim of many texels does not allocate memory.
    let wide = GOOD.replace("rect = [4, 0, 4, 4]", "rect = [4, 0, 16384, 16384]");
    fs::write(at.join("object.toml"), wide).expect("written");
    let options = ObjectOptions { max_bytes: 1 << 20, ..ObjectOptions::default() };
    let error = read_object(&at.join("object.toml"), &options);
    assert!(matches!(error, Err(ObjectFileError::TooMuchMemory { needed, .. }) if needed >= 1 << 30));
}

#[test]
fn pictures_are_laid_out_as_the_object_is() {
    let folder = folder();
    let at = folder.path();
    let heights: Vec<u16> = (0..32).map(|texel| texel * 2000).collect();
    write_png16(&at.join("depth.png"), 8, 4, &heights).expect("written");
    let rgb: Vec<u8> = (0..32).flat_map(|texel| [texel * 8, 0, 255]).collect();
    write_png8(&at.join("color.png"), 8, 4, PngColour::Rgb, &rgb).expect("written");
    let normal: Vec<u8> = (0..32).flat_map(|texel| [128, 128 + 2 * texel, 250]).collect();
    write_png8(&at.join("normal.png"), 8, 4, PngColour::Rgb, &normal).expect("written");
    let text = GOOD.replace("depth.exr\"", "depth.png\"\ncolor = \"color.png\"\nnormal = \"normal.png\"");
    fs::write(at.join("object.toml"), text).expect("written");
    let file = read_object(&at.join("object.toml"), &ObjectOptions::default()).expect("an object");
    let (color, normal) = (file.color.expect("colours"), file.normal.expect("normals"));
    let [width, height] = file.object.layout().size();
    assert_eq!(
        ([color.width, color.height], [normal.width, normal.height]),
        ([width, height], [width, height])
    );
    for (number, place) in file.object.layout().places().iter().enumerate() {
        for y in 0..4u32 {
            for x in 0..4u32 {
                let texel = y * 8 + x + 4 * number as u32;
                let [column, row] = [place[0] + x, place[1] + y];
                let packed = (row * width + column) as usize;
                let stored = file.object.heights().texel(i64::from(column), i64::from(row));
                assert_eq!(stored, (f64::from(texel * 2000) / 65535.0) as f32);
                let red = relief_io::srgb_to_linear(f64::from(texel * 8) / 255.0) as f32;
                assert_eq!(color.texels[packed], [red, 0.0, 1.0, 1.0]);
                let [_, y, z] = normal.normals[packed];
                assert!((y / z - (2.0 * (128.0 + 2.0 * texel as f32) - 255.0) / 245.0).abs() < 1e-5);
            }
        }
        // Around each image its edge is repeated in colours, and heights are 0.
        let [x, y] = place.map(|at| at - 1);
        let beside = (y * width + x) as usize;
        assert_eq!(color.texels[beside], color.texels[((y + 1) * width + x + 1) as usize]);
        assert_eq!(file.object.heights().texel(i64::from(x), i64::from(y)), 0.0);
    }
}
