//! `relief height from-normals`: there and back through files, on natural maps.

use std::path::{Path, PathBuf};
use std::process::Stdio;
use std::time::{Duration, Instant};

use crate::common::command::{Folder, Ran, json_of};
use crate::common::files::exr;
use crate::common::maps::encoded;
use image::{DynamicImage, ImageFormat, RgbImage};
use relief_core::{HeightMap, Wrap};
use relief_io::{HeightOptions, read_height, read_metadata};
use serde_json::{Value, json};

fn sample(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(name)
}

fn map(path: &Path) -> HeightMap {
    read_height(path, &HeightOptions::default()).expect("it is a height map")
}

/// The heights of a map in metres.
fn metres(map: &HeightMap, [zero, one]: [f64; 2]) -> Vec<f64> {
    map.texels().iter().map(|&texel| zero + f64::from(texel) * (one - zero)).collect()
}

fn noted_metres(path: &Path) -> Vec<f64> {
    let map = map(path);
    metres(&map, map.physical_range().expect("the file says it"))
}

/// The root mean square difference of heights whose means are made equal, as a part of `relief_m`.
fn difference(a: &[f64], b: &[f64], relief_m: f64) -> f64 {
    assert_eq!(a.len(), b.len());
    let mean = a.iter().zip(b).map(|(a, b)| a - b).sum::<f64>() / a.len() as f64;
    let sum = a.iter().zip(b).map(|(a, b)| (a - b - mean).powi(2)).sum::<f64>();
    (sum / a.len() as f64).sqrt() / relief_m
}

/// Bakes normals of `map.png` into the folder and gives their file.
fn bake(folder: &Folder, format: &str, flags: &str) -> String {
    let line =
        format!("bake map.png --kind normal --set normal.mips=0 -o . --force --format {format} {flags}");
    folder.relief(&line).fine();
    format!("map.normal.{format}")
}

fn with_map(name: &str) -> Folder {
    let folder = Folder::new();
    std::fs::copy(sample(name), folder.path("map.png")).expect("the temporary folder is writable");
    folder
}

/// A picture of the same samples, without what the file said of them.
fn without_metadata(folder: &Folder, name: &str) {
    let picture = image::open(folder.path(name)).expect("a picture");
    folder.write(name, encoded(&picture, ImageFormat::Png));
    assert!(read_metadata(&folder.path(name)).expect("a PNG").iter().next().is_none());
}

#[test]
fn heights_come_back_through_files() {
    // Scale and tile in metres; one of both maps is no power of two, and its texels are no squares.
    for (name, scale_m, tile) in [("cobbles.png", 0.05, "1,1"), ("jacksboro.png", 840.0, "30100,31800")] {
        let folder = with_map(name);
        let original = metres(&map(&folder.path("map.png")), [0.0, scale_m]);
        for wrap in Wrap::ALL {
            // A tiled map of even size loses the waves that change their sign from texel to texel.
            let lost = if wrap == Wrap::Repeat { 2e-4 } else { 0.0 };
            for (format, bits, most) in [("exr", "0", 1e-7), ("png", "0", 1e-5), ("png", "8", 2e-3)] {
                let flags =
                    format!("--wrap {wrap} --scale {scale_m} --tile-size {tile} --set normal.bits={bits}");
                let normals = bake(&folder, format, &flags);
                for output in ["back.exr", "back.png"] {
                    let about = format!("{name} {wrap} {format} {bits} {output}");
                    let line = format!("height from-normals {normals} -o {output} --json");
                    let said = json_of(&folder.relief(&line).fine());
                    assert_eq!(
                        (&said["wrap"], &said["green"]["said_by"]),
                        (&json!(wrap.name()), &json!("the file"))
                    );
                    let back = noted_metres(&folder.path(output));
                    let error = difference(&back, &original, scale_m);
                    let rounding = if output == "back.png" { 1e-5 } else { 0.0 };
                    assert!(error < most + lost + rounding, "{about}: {error} of the relief");
                }
                // The comparison notices green that is turned over.
                folder.relief(&format!("height from-normals {normals} -o wrong.exr --green down")).fine();
                let wrong = difference(&noted_metres(&folder.path("wrong.exr")), &original, scale_m);
                assert!(wrong > 0.02, "{name} {wrap} {format}: {wrong}");
            }
        }
    }
}

#[test]
fn green_is_told_by_the_normals_themselves() {
    for name in ["cobbles.png", "bricks.png", "jacksboro.png"] {
        let folder = with_map(name);
        let original = metres(&map(&folder.path("map.png")), [0.0, 0.05]);
        let mut heights = Vec::new();
        for (down, way, other) in [("0", "up", "down"), ("1", "down", "up")] {
            let flags = format!(
                "--scale 0.05 --tile-size 1,1 --wrap clamp --set normal.bits=8 --set normal.green_down={down}"
            );
            let normals = bake(&folder, "png", &flags);
            let said =
                json_of(&folder.relief(&format!("height from-normals {normals} -o a.exr --json")).fine());
            assert_eq!((&said["green"]["way"], &said["green"]["said_by"]), (&json!(way), &json!("the file")));
            without_metadata(&folder, &normals);
            let [u, v] = {
                let picture = image::open(folder.path(&normals)).expect("a picture");
                [picture.width(), picture.height()].map(|side| 1.0 / f64::from(side))
            };
            let line =
                format!("height from-normals {normals} -o a.exr --json --wrap clamp --texel-size {u},{v}");
            let said = json_of(&folder.relief(&line).fine());
            assert_eq!(
                (&said["green"]["way"], &said["green"]["said_by"]),
                (&json!(way), &Value::Null),
                "{name}"
            );
            assert!(said["green"]["confidence"].as_f64() > Some(0.8), "{name} {way}: {said}");
            heights.push(noted_metres(&folder.path("a.exr")));
            let error = difference(&heights[heights.len() - 1], &original, 0.05);
            assert!(error < 5e-3, "{name} {way}: {error}");
            // Naming the same direction changes nothing; naming the other does.
            for (green, least, most) in [(way, 0.0, 1e-6), (other, 0.02, f64::INFINITY)] {
                folder.relief(&format!("{line} --green {green}").replace("a.exr", "said.exr")).fine();
                let said = noted_metres(&folder.path("said.exr"));
                let apart = difference(&said, &heights[heights.len() - 1], 0.05);
                assert!((least..most).contains(&apart), "{name} {way} {green}: {apart}");
            }
        }
        assert!(difference(&heights[0], &heights[1], 0.05) < 3e-3);
        let text = folder.relief("height from-normals map.normal.png -o a.exr --green=-y").fine().stdout;
        assert!(text.contains("green") && text.contains("down"), "{text}");
    }
}

#[test]
fn normals_in_world_space_are_read_as_what_they_are() {
    let folder = with_map("cobbles.png");
    let normals = bake(&folder, "exr", "--scale 0.05 --wrap mirror --set normal.world=1");
    folder.relief(&format!("height from-normals {normals} -o back.exr")).fine();
    let original = metres(&map(&folder.path("map.png")), [0.0, 0.05]);
    assert!(difference(&noted_metres(&folder.path("back.exr")), &original, 0.05) < 1e-7);
    let refused = folder.relief(&format!("height from-normals {normals} -o x.exr --green up"));
    assert_eq!(refused.code, Some(2), "{}", refused.stderr);
}

#[test]
fn other_commands_know_what_the_heights_mean() {
    let folder = with_map("cobbles.png");
    let normals = bake(&folder, "png", "--scale 0.125 --tile-size 2,3 --wrap clamp");
    for output in ["h.png", "h.exr"] {
        let said =
            json_of(&folder.relief(&format!("height from-normals {normals} -o {output} --json")).fine());
        assert_eq!(
            (&said["tile_m"], &said["width"], &said["height"]),
            (&json!([2.0, 3.0]), &json!(256), &json!(256))
        );
        let scale_m = said["scale_m"].as_f64().expect("a number");
        assert!((scale_m - 0.125).abs() < 1e-4, "{scale_m}");
        let seen = json_of(&folder.relief(&format!("inspect {output} --json")).fine());
        assert_eq!((&seen["scale_m"], &seen["bias_m"]), (&said["scale_m"], &said["bias_m"]));
        assert_eq!(seen["texel_m"], json!([2.0 / 256.0, 3.0 / 256.0]));
        let baked = json_of(&folder.relief(&format!("bake {output} --kind pyramid -o . --json")).fine());
        assert_eq!(baked["tile_m"], json!([2.0, 3.0]));
        assert!((baked["scale_m"].as_f64().expect("a number") - scale_m).abs() < 1e-9);
        folder.relief(&format!("render --height {output} --backend cpu --size 8x8 -o seen.png")).fine();
        let metadata = read_metadata(&folder.path(output)).expect("it has metadata");
        for (key, value) in
            [("kind", "height"), ("wrap", "clamp"), ("channels", "height"), ("source_green", "up")]
        {
            assert_eq!(metadata.get(&format!("relief.{key}")), Some(value), "{output}: {key}");
        }
        let text = folder.relief(&format!("inspect {output}")).fine().stdout;
        assert!(text.contains("relief ") && text.contains("--scale 0.12"), "{text}");
    }
}

#[test]
fn level_normals_are_a_level_map() {
    let folder = Folder::new();
    let level = |name: &str, code: u8| {
        let picture = RgbImage::from_pixel(9, 6, image::Rgb([code, code, 255]));
        folder.write(name, encoded(&DynamicImage::ImageRgb8(picture), ImageFormat::Png));
    };
    level("a.png", 128);
    level("b.png", 127);
    let plane = |value: f32| vec![value; 54];
    folder.write("c.exr", exr([9, 6], &[("R", plane(0.0)), ("G", plane(0.0)), ("B", plane(1.0))]));
    for name in ["a.png", "b.png", "c.exr"] {
        for wrap in Wrap::ALL {
            let line = format!("height from-normals {name} -o h.png --wrap {wrap}");
            let said = json_of(&folder.relief(&format!("{line} --json")).fine());
            assert_eq!((&said["scale_m"], &said["misfit"]), (&json!(0.0), &Value::Null), "{name} {wrap}");
            assert!(map(&folder.path("h.png")).texels().iter().all(|&texel| texel == 0.0));
            assert!(folder.relief(&line).fine().stdout.contains("none"));
        }
    }
    folder.relief("bake h.png --kind cone -o .").fine();
}

#[test]
fn normals_with_faults_are_refused_mended_or_counted() {
    let folder = with_map("cobbles.png");
    let normals = bake(&folder, "exr", "--scale 0.05 --wrap clamp");
    let planes = ["x", "y", "z"].map(|channel| {
        let options = HeightOptions {
            channel: Some(channel.to_owned()),
            range: Some([-1.0, 1.0].into()),
            ..HeightOptions::default()
        };
        let map = read_height(&folder.path(&normals), &options).expect("a channel");
        map.texels().iter().map(|&texel| 2.0 * texel - 1.0).collect::<Vec<f32>>()
    });
    let write = |change: &dyn Fn(&mut [Vec<f32>; 3])| {
        let mut planes = planes.clone();
        change(&mut planes);
        let [x, y, z] = planes;
        folder.write("broken.exr", exr([256, 256], &[("R", x), ("G", y), ("B", z)]));
    };
    let line = "height from-normals broken.exr -o h.exr --wrap clamp --damping 0 --json";
    let original = metres(&map(&folder.path("map.png")), [0.0, 0.05]);
    let faults = |flags: &str, most: f64| {
        let said = json_of(&folder.relief(&format!("{line} {flags}")).fine());
        let error = difference(&noted_metres(&folder.path("h.exr")), &original, 0.05);
        assert!(error < most, "{flags}: {error} of the relief");
        said["normals"].clone()
    };
    // A hole of 3x3 texels in one stone, NaN and nought.
    write(&|planes| {
        for at in (0..9).map(|at| (100 + at / 3) * 256 + 50 + at % 3) {
            planes.iter_mut().for_each(|plane| plane[at] = if at % 2 == 0 { f32::NAN } else { 0.0 });
        }
    });
    // PNG holds no holes.
    let refused = folder.relief(&line.replace("h.exr", "h.png"));
    assert_eq!(refused.code, Some(1));
    assert!(refused.stderr.contains("--fill") && refused.stderr.contains("(50, 100)"), "{}", refused.stderr);
    assert!(!folder.path("h.png").exists());
    assert_eq!(faults("--fill", 5e-3)["without_direction"], 9);
    write(&|planes| planes.iter_mut().flatten().for_each(|value| *value *= 3.0));
    let said = faults("", 1e-6);
    assert_eq!((&said["not_unit"], &said["below_horizon"]), (&json!(256 * 256), &json!(0)));
    write(&|planes| planes[2][7000] = -planes[2][7000]);
    assert_eq!(faults("", 0.2)["below_horizon"], 1);
    // Normals below the surface everywhere, or without blue, are no relief's.
    write(&|planes| planes[2].iter_mut().for_each(|z| *z = -*z));
    let refused = folder.relief(line);
    assert_eq!(refused.code, Some(1));
    assert!(refused.stderr.contains("blue"), "{}", refused.stderr);
}

#[test]
fn the_number_of_threads_changes_no_byte() {
    let folder = with_map("jacksboro.png");
    let normals = bake(&folder, "png", "--set normal.bits=8");
    without_metadata(&folder, &normals);
    let with = |threads: &str| {
        let line = format!("height from-normals {normals} -o h.exr --wrap mirror");
        let mut command = folder.command();
        let output = command.args(line.split(' ')).env("RAYON_NUM_THREADS", threads).output();
        Ran::new(&line, &output.expect("the command starts")).fine();
        std::fs::read(folder.path("h.exr")).expect("it was written")
    };
    let one = with("1");
    assert_eq!(one, with("2"));
    assert_eq!(one, with("5"));
}

#[cfg(unix)]
#[test]
fn an_interrupt_leaves_nothing_or_a_whole_file() {
    let folder = with_map("bricks.png");
    std::fs::create_dir(folder.path("out")).expect("the temporary folder is writable");
    let normals = bake(&folder, "png", "--set normal.bits=8");
    let tile = image::open(folder.path(&normals)).expect("a picture").to_rgb8();
    let large = RgbImage::from_fn(2048, 2048, |x, y| *tile.get_pixel(x % 256, y % 256));
    folder.write("large.png", encoded(&DynamicImage::ImageRgb8(large), ImageFormat::Png));
    let entries = || std::fs::read_dir(folder.path("out")).expect("the folder is there").count();
    // Interrupted at once while reading, on the way, and as soon as something is written.
    for wait in [Duration::ZERO, Duration::from_millis(300), Duration::from_secs(60)] {
        let mut child = folder
            .command()
            .args(["height", "from-normals", "large.png", "-o", "out/h.exr"])
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("the command starts");
        let started = Instant::now();
        while started.elapsed() < wait
            && entries() == 0
            && child.try_wait().expect("the command can be waited for").is_none()
        {
            std::thread::sleep(Duration::from_millis(2));
        }
        let pid = child.id().to_string();
        let kill = std::process::Command::new("kill").args(["-INT", &pid]).stderr(Stdio::null()).status();
        kill.expect("kill is there");
        let status = child.wait().expect("the command ends");
        if status.success() {
            assert_eq!(map(&folder.path("out/h.exr")).width(), 2048);
            std::fs::remove_file(folder.path("out/h.exr")).expect("it is there");
        }
        assert_eq!(entries(), 0, "{wait:?}: {status}");
    }
}

#[test]
fn normal_maps_of_other_programs_give_their_heights() {
    let Some(data) = std::env::var_os("RELIEF_DATA").map(PathBuf::from).filter(|data| data.is_dir()) else {
        println!("skipped: RELIEF_DATA is not set to a folder of real maps");
        return;
    };
    let folder = Folder::new();
    for (normals, heights, channel, depth, green) in [
        ("bevy_cube_normal.png", "bevy_cube_depth.png", None, true, "up"),
        ("rock023_nrm_rgh.png", "rock023_alb_ht.png", Some("a"), false, "up"),
        ("bgfx_parallax_n.png", "bgfx_parallax_h.png", Some("r"), true, "down"),
        ("godot_cheese_normal.png", "godot_cheese_depth.png", None, true, "up"),
    ] {
        let line = format!("height from-normals {} -o h.exr --json", data.join(normals).display());
        let said = json_of(&folder.relief(&line).fine());
        assert_eq!(said["green"]["way"], green, "{normals}");
        assert!(said["green"]["confidence"].as_f64() > Some(0.4), "{normals}: {said}");
        let convention = if depth { relief_io::Convention::Depth } else { relief_io::Convention::Height };
        let options = HeightOptions {
            channel: channel.map(str::to_owned),
            convention: Some(convention),
            ..HeightOptions::default()
        };
        let theirs = metres(&read_height(&data.join(heights), &options).expect("a height map"), [0.0, 1.0]);
        let correlation = correlation(&noted_metres(&folder.path("h.exr")), &theirs);
        println!("{normals}: correlation {correlation:.4}");
        assert!(correlation > 0.95, "{normals}: {correlation}");
    }
}

fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let (mean_a, mean_b) = (mean(a), mean(b));
    let product =
        |f: fn(f64, f64) -> f64| a.iter().zip(b).map(|(a, b)| f(a - mean_a, b - mean_b)).sum::<f64>();
    product(|a, b| a * b) / (product(|a, _| a * a) * product(|_, b| b * b)).sqrt()
}

#[test]
fn a_picture_is_true_to_the_metres_of_the_file() {
    let folder = with_map("cobbles.png");
    let normals = bake(&folder, "exr", "--scale 3 --tile-size 50,20");
    folder.relief(&format!("height from-normals {normals} -o heights.exr")).fine();
    let (_, span_m) = map(&folder.path("heights.exr")).stated_lengths_m().expect("the file says it");
    let of = |flags: &str| {
        let line = format!("render --height heights.exr --size 40x30 --backend cpu -o out.png {flags}");
        let said = json_of(&folder.relief(&format!("{line} --json")).fine());
        let [scale_m, bias_m] =
            ["scale_m", "bias_m"].map(|key| said["surfaces"][0][key].as_f64().expect("a number"));
        assert_eq!(bias_m, -scale_m, "{flags}");
        (scale_m, folder.relief(&line).fine().stdout.contains("--exaggerate"))
    };
    // A tile of 50 m by 20 m on a plane of 1 m by 0.4 m.
    let (once, is_said) = of("");
    assert!(is_said && (once * 50.0 / span_m - 1.0).abs() < 1e-6, "{once} for {span_m}");
    // On a square it is the mean of both directions.
    let (square, _) = of("--mesh square");
    assert!((square * 1000f64.sqrt() / span_m - 1.0).abs() < 1e-12, "{square} for {span_m}");
    let (twice, _) = of("--tile 2,2");
    assert!((twice / once - 0.5).abs() < 1e-6, "{twice} and {once}");
    assert_eq!(of("--scale 0.07"), (0.07, false));
    // A file that states nothing.
    let folder_map =
        folder.relief("render --height map.png --size 40x30 --backend cpu -o out.png --json").fine();
    assert_eq!(json_of(&folder_map)["surfaces"][0]["scale_m"], 0.05);
}
