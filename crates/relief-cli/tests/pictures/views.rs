//! `relief view`: two views, what they show, and the errors beside the exact picture.

use serde_json::{Value, json};

use crate::common::aov::Aov;
use crate::common::command::Folder;
use crate::page::{Page, WHOLE, shipped};

const PIXELS: usize = 48 * 36;

/// The views of a picture.
fn views(about: &Value) -> &[Value] {
    about["views"].as_array().expect("views")
}

/// What `relief compare` says of a method's picture.
fn compared(folder: &Folder, scene: &str, method: &str) -> Value {
    let line =
        format!("compare {scene} --look studio --size 48x36 --samples 4 --backend cpu --methods {method}");
    let said = folder.relief(&format!("{line} --rays 1 --json -q -o c.html")).fine().stdout;
    let records: Value = serde_json::from_str(&said).expect("JSON");
    records["pictures"][0].clone()
}

#[test]
fn errors_are_those_of_compare_to_the_last_digit() {
    let folder = Folder::new();
    shipped(&folder, &["cobbles.png"]);
    let mut p99 = Vec::new();
    for scene in ["cobbles.png --scale 0.2", "cobbles.png --scale 0.1 --mesh torus --tile 6,2"] {
        for method in ["relief", "cone"] {
            let compared = compared(&folder, scene, method);
            for (show, figures) in [
                (
                    "error",
                    vec!["median_texels", "p99_texels", "max_texels", "passed", "missed", "false_hits"],
                ),
                ("passed", vec!["p99_texels", "passed"]),
                ("flip", vec!["flip"]),
                ("color-error", vec!["rms", "psnr_db"]),
            ] {
                let page =
                    Page::open(&folder, &format!("{scene} --method {method} --show {show} --backend cpu"));
                let (about, _) = page.picture(WHOLE);
                let view = &views(&about)[0];
                for figure in figures {
                    let own = &view["errors"]["figures"][figure];
                    assert!(own.is_number() || own.is_null(), "{scene} {method} {show}: {view}");
                    assert_eq!(*own, compared[figure], "{scene} {method} {show} {figure}");
                }
                p99.push(view["errors"]["figures"]["p99_texels"].clone());
            }
        }
    }
    // Methods and scenes differ.
    p99.retain(|figure| !figure.is_null());
    let differ: std::collections::BTreeSet<String> = p99.iter().map(ToString::to_string).collect();
    assert_eq!(differ.len(), 4, "{differ:?}");
}

#[test]
fn each_of_two_views_shows_its_own() {
    let folder = Folder::new();
    shipped(&folder, &["cobbles.png"]);
    let alone =
        |flags: &str| Page::open(&folder, &format!("cobbles.png --backend cpu {flags}")).picture(WHOLE).1;
    let (relief, cone) = (alone("--method relief --scale 0.2"), alone("--method cone --scale 0.2"));
    assert!(relief != cone);
    let page = Page::open(&folder, "cobbles.png --backend cpu --scale 0.2 --method relief,cone");
    let (about, both) = page.picture(WHOLE);
    assert_eq!([&views(&about)[0]["method"], &views(&about)[1]["method"]], ["relief", "cone"]);
    assert!(both == [relief.clone(), cone].concat());
    // The scene is the first view's: the second is no part of a picture.
    folder.write("saved.toml", page.get("save?what=scene.toml"));
    folder.relief("render saved.toml -q -o rendered.png").fine();
    let rendered = std::fs::read(folder.path("rendered.png")).expect("a picture");
    assert!(*image::load_from_memory(&rendered).expect("a picture").to_rgb8() == relief);
    // One camera turns both; where they stand side by side changes no picture.
    page.apply(&json!({ "do": "orbit", "degrees": [30, 0] })).expect("it turns");
    let (_, turned) = page.picture(WHOLE);
    assert!(turned[..3 * PIXELS] != both[..3 * PIXELS] && turned[3 * PIXELS..] != both[3 * PIXELS..]);
    for (key, value) in [("viewer.divider", json!(0.25)), ("viewer.swapped", json!(true))] {
        let set = json!({ "do": "set", "key": key, "value": value });
        assert_eq!(page.apply(&set).expect("a change")["changed"], json!([key]));
    }
    assert!(page.picture(WHOLE).1 == turned);
    // Both show the same quantity by one scale.
    page.apply(&json!({ "do": "set", "key": "viewer.show", "value": "error" })).expect("a change");
    let (about, _) = page.picture(WHOLE);
    let legends: Vec<&Value> = views(&about).iter().map(|view| &view["legend"]).collect();
    assert!(legends[0] == legends[1] && legends[0]["ticks"].as_array().is_some_and(|ticks| ticks.len() > 1));
    let saved = String::from_utf8(page.get("save?what=scene.toml")).expect("text");
    let table = "viewer = { show = \"error\", second = \"cone\", divider = 0.25, swapped = true }";
    assert!(saved.contains(table), "{saved}");
}

#[test]
fn a_view_that_cannot_be_drawn_says_why_beside_the_other() {
    let folder = Folder::new();
    shipped(&folder, &["cobbles.png"]);
    folder.relief("capture cube --size 16 --verify 0 --cover centre -q -o cube").fine();
    let two = "height = \"cobbles.png\"\n[[surfaces]]\n[[surfaces]]\nposition = [0, 0.4, 0]\n";
    folder.write("two.toml", two);
    for (scene, said) in [
        ("cube/object.toml --show depth,height", "no relief, or a relief has none"),
        ("cube/object.toml --show picture,flip", "depth object"),
        ("cobbles.png --method relief,visual-hull", "depth objects"),
        ("two.toml --show flip,error", "hide each other"),
    ] {
        let page = Page::open(&folder, &format!("{scene} --samples 1"));
        let (about, pixels) = page.picture(WHOLE);
        let [first, second] = views(&about) else { panic!("{scene}: two views") };
        assert!(first["failed"].is_null() && pixels.len() == 3 * PIXELS, "{scene}: {about}");
        let failed = second["failed"].as_str().expect("a reason");
        assert!(
            !failed.is_empty() && (said.contains("no relief") || failed.contains(said)),
            "{scene}: {failed}"
        );
        assert!(!failed.contains("--"), "a page has no flags: {failed}");
    }
    for (flags, said) in [
        ("--show eror", "'error'"),
        ("--show error,depth,normal", "two"),
        ("--method relief,cone,exact", "two"),
        ("--method relief,conee", "'cone'"),
    ] {
        let refused = folder.relief(&format!("view cobbles.png --no-open {flags}"));
        assert!(refused.code != Some(0) && refused.stderr.contains(said), "{flags}: {}", refused.stderr);
    }
}

#[test]
fn the_pixel_that_is_read_is_that_of_the_aovs() {
    let folder = Folder::new();
    shipped(&folder, &["cobbles.png"]);
    let scene = "cobbles.png --mesh sphere --tile 4,2 --scale 0.2 --size 48x36 --backend cpu";
    let page = Page::open(&folder, &format!("{scene} --method relief,cone --show picture,error"));
    assert_eq!(page.get("pixel?x=20&y=10"), b"null", "nothing is shown yet");
    let (about, _) = page.picture(WHOLE);
    let finest = "--detail none -q -o p.png --aov";
    folder.relief(&format!("render {scene} --method cone {finest} cone.exr")).fine();
    folder.relief(&format!("render {scene} --method relief -q -o p.png --aov relief.exr")).fine();
    let aovs = ["relief.exr", "cone.exr"].map(|name| Aov::read(&folder.path(name)));
    let (mut hits, mut errors) = (0, Vec::new());
    for (x, y) in (0..36).flat_map(|y| (0..48).map(move |x| (x, y))).step_by(7) {
        let read: Value = serde_json::from_slice(&page.get(&format!("pixel?x={x}&y={y}"))).expect("JSON");
        assert_eq!(read["at"], json!([x, y]));
        for (own, aov) in read["views"].as_array().expect("views").iter().zip(&aovs) {
            let pixel = aov.pixel(x, y);
            assert_eq!(own["hit"], json!(pixel.hit > 0.0));
            if pixel.hit > 0.0 {
                hits += 1;
                // JSON is read to within a bit of the last digit.
                let same =
                    |own: &Value, number: f64| own.as_f64().map(|own| own as f32) == Some(number as f32);
                assert!(same(&own["depth_m"], pixel.depth) && same(&own["reads"], pixel.reads), "{own}");
                assert!(same(&own["uv"][0], pixel.uv.x) && same(&own["position_m"][2], pixel.position.z));
            }
        }
        errors.extend(read["views"][1]["error_texels"].as_f64());
    }
    assert!(hits > 100 && errors.iter().any(|error| *error > 0.0), "{hits}");
    // The worst pixel is at least as far off as any that was read.
    let worst: [u32; 2] =
        serde_json::from_value(views(&about)[1]["errors"]["worst"].clone()).expect("a pixel");
    let read = page.get(&format!("pixel?x={}&y={}", worst[0], worst[1]));
    let read: Value = serde_json::from_slice(&read).expect("JSON");
    let most = read["views"][1]["error_texels"].as_f64().expect("a number");
    assert!(errors.iter().all(|error| *error <= most), "{most}: {errors:?}");
    let figures = &views(&about)[1]["errors"]["figures"];
    assert!((most - figures["max_texels"].as_f64().expect("a number")).abs() < 1e-4 * most);
    // What is looked at is in the middle then.
    let point = read["views"][1]["position_m"].clone();
    page.apply(&json!({ "do": "look-at", "point": point })).expect("a change");
    assert_eq!(page.get("pixel?x=99&y=10"), b"null", "outside of the picture");
    page.picture(WHOLE);
    let middle: Value = serde_json::from_slice(&page.get("pixel?x=24&y=18")).expect("JSON");
    for axis in 0..3 {
        let [was, is] =
            [&point, &middle["views"][1]["position_m"]].map(|at| at[axis].as_f64().unwrap_or(9.0));
        assert!((was - is).abs() < 0.2, "{point} {middle}");
    }
}
