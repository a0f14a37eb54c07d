//! Depth objects and slices that cannot be shown: the error says what is wrong, and nothing is
//! written. Objects at the limits are shown.

use crate::common::command::{Folder, json_of};
use crate::common::refused::{OUT, assert_refused, entries, with_out};

/// A folder with a ball in six images, in 9x9 frames and from eyes.
fn folder() -> Folder {
    let folder = with_out();
    for (name, flags) in [
        ("six", ""),
        ("grid", "--views octahedral --grid 9"),
        ("eyes", "--perspective 40"),
        ("eyes_grid", "--views octahedral --grid 3 --perspective 40"),
    ] {
        let line = format!("capture sphere --size 16 --cover centre --verify 0 {flags} -q -o {name}");
        folder.relief(&line).fine();
    }
    folder
}

#[test]
fn what_cannot_be_shown_is_refused() {
    let folder = folder();
    let text = std::fs::read_to_string(folder.path("six/object.toml")).expect("a description");
    let views = text.find("[[view]]").expect("a view");
    let edited = |name: &str, text: String| {
        std::fs::write(folder.path(format!("six/{name}.toml")), text).expect("a file");
    };
    edited("empty", text[..views].to_owned());
    edited("singular", text.replacen("from = [1, 0, 0]", "from = [0, 0, 0]", 1));
    edited("outside", text.replacen("rect = [0, 0, 16, 16]", "rect = [0, 0, 1600, 16]", 1));
    edited("twice", text.replacen("rect = [16, 0, 16, 16]", "rect = [15, 0, 16, 16]", 1));
    edited("away", text.replacen("depth.exr", "../grid/depth.exr", 1));
    edited("small", text.replacen("radius = ", "radius = -", 1));
    let of = |name: &str| format!("render --object six/{name}.toml");
    let six = of("object");
    let slices = format!("{six} --method depth-object-slices --set");
    let map = "render --height b.pgm --method";
    let bench = folder.relief("bench --object six/object.toml --methods depth-object");
    assert_refused(&folder, &bench, 2, &["height maps", "object"]);
    for (line, code, words) in [
        (of("empty"), 1, &["view"][..]),
        (of("singular"), 1, &["view 1", "from"]),
        (of("outside"), 1, &["view 1", "outside"]),
        (of("twice"), 1, &["view 2", "overlaps"]),
        (of("away"), 1, &["folder"]),
        (of("small"), 1, &["radius"]),
        (of("missing"), 1, &["missing.toml"]),
        ("render --object grid/object.toml --method depth-object".to_owned(), 2, &["64", "81", "frames"]),
        ("render --object grid/object.toml --method depth-object-slices".to_owned(), 2, &["64", "81"]),
        (format!("{six} --method impostor-blend"), 2, &["grid"]),
        ("render --object eyes_grid/object.toml --method impostor-blend".to_owned(), 2, &["grid"]),
        (format!("{six} --method cone"), 2, &["depth-object"]),
        (format!("{six} --method depth-object --height ball.png"), 2, &["--height", "object"]),
        (format!("{slices} slices.count=1e9"), 1, &["memory", "slices.count"]),
        (format!("{slices} slices.count=1e10"), 2, &["slices.count"]),
        (format!("{slices} slices.count=1.5"), 2, &["whole number"]),
        (format!("{slices} slices.refine=1"), 2, &["refine"]),
        (format!("{slices} slices.test=band"), 2, &["band"]),
        (format!("{slices} geometry.pass=stencil"), 1, &["GPU", "product"]),
        (format!("{six} --set object.cells=smooth"), 2, &["highest"]),
        (format!("{six} --set object.jump=-1"), 2, &["object.jump"]),
        (format!("{six} --detail fade"), 2, &["detail"]),
        (format!("{map} slices-screen --set slices.count=1e9"), 1, &["slices.count"]),
        (format!("{map} slices-surface --set slices.direction=d"), 2, &["screen"]),
        (format!("{map} slices-screen --set geometry.clip=border"), 1, &["clamp"]),
        (format!("{map} slices-surface --set geometry.clip=border"), 2, &["border"]),
        (format!("{map} slices-screen --set geometry.clip=border --wrap clamp --mesh torus"), 1, &["flat"]),
        ("render --height b.pgm --scale 0 --method slices-orthogonal".to_owned(), 1, &["displacement"]),
        ("render --object six/object_%d.toml --frames 1..2".to_owned(), 2, &["--output"]),
    ] {
        std::fs::write(folder.path("b.pgm"), "P2\n2 2\n9\n0 9 9 0\n").expect("a map");
        let line = format!("{line} --size 16x16 --backend cpu -o out/a.png");
        assert_refused(&folder, &folder.relief(&line), code, words);
        assert_eq!(entries(&folder.path(OUT)), Vec::<String>::new(), "{line}");
    }
}

#[test]
fn what_is_at_the_edge_is_shown() {
    let folder = folder();
    std::fs::write(folder.path("b.pgm"), "P2\n2 2\n9\n0 9 9 0\n").expect("a map");
    let six = "render --object six/object.toml --method depth-object-slices";
    let map = "render --height b.pgm --scale 0.1";
    for line in [
        format!("{six} --set slices.count=0"),
        format!("{six} --set slices.count=1"),
        // Along the slices, and from within.
        format!("{six} --set slices.direction=a --eye 0,0,3 --target 0,0,0"),
        "render --object six/object.toml --eye 0.1,0,0 --target 1,0,0".to_owned(),
        "render --object eyes/object.toml --method visual-hull".to_owned(),
        "render --object grid/object.toml --method impostor-blend".to_owned(),
        format!("{map} --method slices-surface --set slices.count=0"),
        format!("{map} --method slices-surface --set slices.count=1"),
        format!("{map} --method slices-orthogonal --set slices.direction=b --eye 0,0,3 --target 0,0,0"),
        format!("{map} --method slices-screen --set slices.count=1 --eye 0,0.05,0 --target 1,0,0"),
        format!("{map} --wrap clamp --method slices-screen --set geometry.clip=border"),
    ] {
        let ran = folder.relief(&format!("{line} --size 16x16 --backend cpu --json -o out/a.png"));
        let about = json_of(&ran.fine());
        assert_eq!(about["width"], 16, "{line}: {about}");
    }
}
