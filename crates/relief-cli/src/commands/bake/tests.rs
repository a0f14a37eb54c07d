//! The command with kinds made for the tests.

#[cfg(unix)]
mod disk;
mod kinds;
#[cfg(target_os = "linux")]
mod memory;

use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use clap::Parser;
use relief_bake::{Channel, Shape};
use relief_core::{HeightMap, Rounding};
use relief_io::{TexelFormat, read_height, read_ktx2, read_metadata, write_png16};
use serde_json::{Value, json};

use self::kinds::{find, shade};
use super::storage::{Packing, Storage};
use super::*;

const WIDTH: u32 = 20;
const HEIGHT: u32 = 12;

#[derive(Parser)]
struct Line {
    #[command(flatten)]
    arguments: Arguments,
}

/// Folder with a height map.
struct MapFolder {
    dir: tempfile::TempDir,
    map: PathBuf,
}

impl MapFolder {
    fn new() -> Self {
        Self::of([WIDTH, HEIGHT])
    }

    fn of([width, height]: [u32; 2]) -> Self {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let map = folder.path().join("map.png");
        let texels: Vec<u16> = (0..width * height).map(|at| (at * 271) as u16).collect();
        write_png16(&map, width, height, &texels).expect("the folder is writable");
        Self { dir: folder, map }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.dir.path().join(name)
    }

    fn bake_unless(&self, cancel: bool, line: &str) -> Result<Value, Failure> {
        let words = ["bake", self.map.to_str().expect("UTF-8"), "--json"].into_iter();
        let output = ["-o", self.dir.path().to_str().expect("UTF-8")];
        let words: Vec<&str> = words.chain(line.split_whitespace()).chain(output).collect();
        let line = Line::try_parse_from(words).map_err(Failure::usage)?;
        let mut out = Vec::new();
        let kinds = choose(&line.arguments, find)?;
        let (job, map) = Job::new(&line.arguments, kinds)?;
        job.run(map, &AtomicBool::new(cancel), &mut out)?;
        Ok(serde_json::from_slice(&out).expect("JSON"))
    }

    fn bake(&self, line: &str) -> Value {
        self.bake_unless(false, line).expect("it can be baked")
    }

    /// Returns the names of the files besides the map and the manifest.
    fn files(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.dir.path()).expect("the folder is there");
        let mut names: Vec<String> = entries
            .map(|entry| entry.expect("readable").file_name().to_string_lossy().into_owned())
            .filter(|name| name != "map.png" && name != "map.relief-manifest")
            .collect();
        names.sort();
        names
    }

    fn heights(&self) -> HeightMap {
        read_height(&self.map, &relief_io::HeightOptions::default()).expect("it is a map")
    }
}

fn up_to_date(baked: &Value) -> bool {
    baked["baked"][0]["up_to_date"] == json!(true)
}

fn plane(path: &Path) -> Vec<f32> {
    read_ktx2(path, 1 << 24).expect("a texture").levels[0].planes[0].clone()
}

#[test]
fn each_format_holds_the_texels_and_what_they_mean() {
    let folder = MapFolder::new();
    for format in ["exr", "png", "ktx2"] {
        folder.bake(&format!("--kind shade --wrap clamp --tile-size 2,3 --scale 0.25 --format {format}"));
        let path = folder.path(&format!("map.shade.{format}"));
        let metadata = read_metadata(&path).expect("it has metadata");
        for (key, value) in [
            ("kind", "shade"),
            ("wrap", "clamp"),
            ("tile_m", "2 3"),
            ("scale_m", "0.25"),
            ("settings", "bits=0"),
            ("channels", "shade"),
            ("ranges", "0,2"),
            ("rounding", "down"),
            ("size", "20 12 1"),
            ("note.reach", "0 texels"),
        ] {
            assert_eq!(metadata.get(&format!("relief.{key}")), Some(value), "{format}: {key}");
        }
        for key in ["source", "key", "convention", "units", "generator", "decode", "guarantee", "stored_as"] {
            assert!(metadata.get(&format!("relief.{key}")).is_some_and(|value| !value.is_empty()), "{key}");
        }
        let range = Some(if format == "exr" { [0.0, 2.0] } else { [0.0, 65535.0] }.into());
        let options = relief_io::HeightOptions { range, ..Default::default() };
        let expected: Vec<f32> = folder.heights().texels().iter().map(|&texel| shade(texel)).collect();
        let found: Vec<f32> = match format {
            "ktx2" => plane(&path),
            _ => {
                read_height(&path, &options).expect("it is a map").texels().iter().map(|t| 2.0 * t).collect()
            }
        };
        for (found, expected) in found.iter().zip(&expected) {
            let lost = expected - found;
            let most = if format == "png" { 2.01 / 65535.0 } else { 0.0 };
            assert!((0.0..=most).contains(&lost), "{format}: {found} for {expected}");
        }
    }
    assert_eq!(folder.files(), ["map.shade.exr", "map.shade.ktx2", "map.shade.png"]);
}

#[test]
fn bits_and_choices_decide_the_texel_format() {
    let folder = MapFolder::new();
    for (line, expected) in [
        ("--set shade.bits=8", TexelFormat::R8),
        ("--set shade.bits=16 --zstd", TexelFormat::R16),
        ("--texels half", TexelFormat::R16F),
        ("", TexelFormat::R32F),
    ] {
        assert!(!up_to_date(&folder.bake(&format!("--kind shade --format ktx2 {line}"))));
        let file = read_ktx2(&folder.path("map.shade.ktx2"), 1 << 24).expect("a texture");
        assert_eq!((file.format, file.zstd), (expected, line.contains("zstd")));
    }
}

#[test]
fn a_second_run_does_nothing_until_an_input_changes() {
    let folder = MapFolder::new();
    let line = "--kind levels,shade --format ktx2";
    let first = folder.bake(line);
    let bytes =
        || folder.files().iter().map(|name| std::fs::read(folder.path(name)).ok()).collect::<Vec<_>>();
    let before = bytes();
    let second = folder.bake(line);
    assert!(!up_to_date(&first) && up_to_date(&second));
    assert_eq!(first["baked"][0]["files"], second["baked"][0]["files"]);
    assert!(!up_to_date(&folder.bake(&format!("{line} --force"))));
    assert_eq!(before, bytes(), "baking again gives the same bytes");
    for changed in ["--wrap mirror", "--scale 2", "--tile-size 1,2", "--zstd", "--depth", "--texels unorm16"]
    {
        assert!(!up_to_date(&folder.bake(&format!("{line} {changed}"))), "{changed}");
        assert!(up_to_date(&folder.bake(&format!("{line} {changed}"))), "{changed}");
    }
    // A set that is not whole is baked again.
    folder.bake(line);
    std::fs::remove_file(folder.path("map.levels.odd.ktx2")).expect("it was written");
    assert!(!up_to_date(&folder.bake(line)));
    std::fs::write(folder.path("map.levels.odd.ktx2"), b"something else").expect("writable");
    assert!(!up_to_date(&folder.bake(line)));
    // Only what is damaged.
    let path = folder.path("map.shade.ktx2");
    let whole = std::fs::read(&path).expect("it was written");
    std::fs::write(&path, &whole[..whole.len() / 2]).expect("writable");
    let third = folder.bake(line);
    assert!(up_to_date(&third) && third["baked"][1]["up_to_date"] == json!(false));
    assert_eq!((std::fs::read(&path).expect("it was written"), before), (whole, bytes()));
}

#[test]
fn channels_and_levels_go_where_the_format_has_room() {
    let folder = MapFolder::new();
    folder.bake("--kind levels --format ktx2");
    let expected = ["five.channels0-3", "five.channels4-4", "odd"];
    assert_eq!(folder.files(), expected.map(|name| format!("map.levels.{name}.ktx2")));
    let file = read_ktx2(&folder.path("map.levels.five.channels0-3.ktx2"), 1 << 24).expect("a texture");
    assert_eq!((file.levels.len(), file.format), (3, TexelFormat::Rgba32F));
    assert!(
        (0..3).all(|level| file.levels[level].planes[2].iter().all(|&v| v == (level as f32 + 2.0) / 8.0))
    );
    let file = read_ktx2(&folder.path("map.levels.odd.ktx2"), 1 << 24).expect("a texture");
    // Sides that are rounded up have room in a larger finest level; the last row and column are
    // repeated.
    let sizes: Vec<[u32; 3]> = file.levels.iter().map(|level| level.size).collect();
    assert_eq!(sizes, [[22, 14, 1], [11, 7, 1]]);
    assert_eq!(file.metadata.get("relief.level_sizes"), Some(format!("{WIDTH}x{HEIGHT} 11x7").as_str()));
    assert_eq!(file.metadata.get("relief.size"), Some(format!("{WIDTH} {HEIGHT} 1").as_str()));
    for (level, file) in file.levels.iter().enumerate() {
        assert!(file.planes[0].iter().all(|&value| value == level as f32 / 8.0), "{level}");
    }
    let files: Vec<String> =
        serde_json::from_str(file.metadata.get("relief.files").expect("it names them")).expect("JSON");
    assert_eq!(files, folder.files());

    let folder = MapFolder::new();
    folder.bake("--kind volume --format exr");
    folder.bake("--kind volume --format ktx2 --zstd");
    let file = read_ktx2(&folder.path("map.volume.ktx2"), 1 << 24).expect("a texture");
    assert_eq!(file.levels[0].size, [WIDTH, HEIGHT, 3]);
    let tall = read_height(&folder.path("map.volume.exr"), &Default::default()).expect("it is a map");
    assert_eq!((tall.width(), tall.height()), (WIDTH, 3 * HEIGHT));
    for (at, texel) in tall.texels().iter().enumerate() {
        let slice = at as u32 / (WIDTH * HEIGHT);
        assert_eq!((*texel, file.levels[0].planes[0][at]), (slice as f32 / 2.0, slice as f32));
    }
}

#[test]
fn a_normal_map_is_one_picture_unless_mips_are_asked_for() {
    let bake = |line: &str| {
        let folder = MapFolder::new();
        let arguments = format!("bake {} -o {} {line}", folder.map.display(), folder.dir.path().display());
        let line = Line::try_parse_from(arguments.split_whitespace()).expect("it can be parsed");
        let kinds = choose(&line.arguments, relief_bake::kind).expect("kinds that there are");
        let (job, map) = Job::new(&line.arguments, kinds).expect("they can be baked");
        job.run(map, &AtomicBool::new(false), &mut Vec::new()).expect("it can be written");
        folder
    };
    let folder = bake("--kind normal,occlusion,cone");
    assert_eq!(folder.files(), ["map.cone.exr", "map.normal.png", "map.occlusion.png"]);
    let file = std::fs::File::open(folder.path("map.normal.png")).expect("it was written");
    let reader = png::Decoder::new(io::BufReader::new(file)).read_info().expect("a picture");
    assert_eq!(reader.output_color_type(), (png::ColorType::Rgb, png::BitDepth::Sixteen));
    assert_eq!(bake("--kind normal --texels float").files(), ["map.normal.exr"]);

    // The moments are a texture of their own beside the colour, which is opaque.
    let folder = bake("--kind normal --format ktx2");
    assert_eq!(folder.files(), ["map.normal.channels0-2.ktx2", "map.normal.channels3-5.ktx2"]);
    for name in folder.files() {
        let file = read_ktx2(&folder.path(&name), 1 << 24).expect("a texture");
        assert_eq!((file.levels.len(), file.levels[0].planes.len()), (5, 4), "{name}");
        assert!(file.levels.iter().all(|level| level.planes[3].iter().all(|texel| *texel == 1.0)));
    }
    let folder = bake("--kind normal --set normal.mips=1");
    let levels = (0..5).map(|level| format!("map.normal.channels0-2.level{level}.png"));
    let moments = (0..5).map(|level| format!("map.normal.channels3-5.level{level}.png"));
    assert_eq!(folder.files(), levels.chain(moments).collect::<Vec<_>>());
}

#[test]
fn slices_that_one_picture_cannot_hold_go_into_several() {
    // Two columns of this height below each other are as tall as a picture may be.
    let tall = relief_core::MAX_SIDE / 2;
    let folder = MapFolder::of([1, tall]);
    folder.bake("--kind volume --format exr");
    assert_eq!(folder.files(), ["map.volume.slices0-1.exr", "map.volume.slices2-2.exr"]);
    let options = relief_io::HeightOptions { range: Some([0.0, 2.0].into()), ..Default::default() };
    for (name, slices, first) in [("slices0-1", 0..2u32, "0"), ("slices2-2", 2..3, "2")] {
        let path = folder.path(&format!("map.volume.{name}.exr"));
        let found = read_height(&path, &options).expect("it is a map");
        let expected = slices.clone().flat_map(|slice| (0..tall).map(move |_| slice as f32 / 2.0));
        assert!(found.texels().iter().copied().eq(expected), "{name}");
        let metadata = read_metadata(&path).expect("it has metadata");
        assert_eq!(metadata.get("relief.first_slice"), Some(first));
        assert_eq!(metadata.get("relief.size"), Some(format!("1 {tall} {}", slices.len()).as_str()));
    }
    // The default horizon of a large map.
    let shape = Shape { name: "", size: [16384, 16384, 16], mips: Vec::new(), channels: 1 };
    let shapes = [shape];
    let plans = files::plan("map.horizon", FileFormat::Exr, &shapes);
    let packing = Packing { format: FileFormat::Exr, storage: Storage::Float, zstd: false };
    assert_eq!(plans.len(), 4);
    early::check_files(&plans, packing, &shapes).expect("they can be written");
}

#[test]
fn cancelled_bakes_leave_nothing() {
    // One kind asks whether it is cancelled; of the other the files are what is cancelled.
    for line in
        ["--kind shade", "--kind levels", "--kind volume --format ktx2 --zstd", "--kind shade --format png"]
    {
        let folder = MapFolder::new();
        let failure = folder.bake_unless(true, line).expect_err("it was cancelled");
        assert!(matches!(&failure, Failure::Work(text) if text.starts_with("cancelled")), "{failure:?}");
        assert_eq!(folder.files(), [""; 0], "{line}");
        // What was there stays, and is not said to be gone.
        folder.bake(line);
        let before = folder.files();
        folder.bake_unless(true, &format!("{line} --scale 3")).expect_err("it was cancelled");
        assert_eq!(folder.files(), before);
        assert!(up_to_date(&folder.bake(line)));
    }
}

#[test]
fn what_fails_leaves_nothing() {
    let folder = MapFolder::new();
    let work = [
        "--kind short",
        "--kind outside --format png",
        "--kind volume --format png",
        "--kind volume --format ktx2 --texels bc",
        "--kind levels --format ktx2 --texels bc",
        "--kind shade --format ktx2 --texels bc",
        "--kind shade --max-memory 2KiB",
    ];
    for line in work {
        let failure = folder.bake_unless(false, line).expect_err(line);
        assert!(matches!(failure, Failure::Work(_)), "{line}: {failure:?}");
        assert_eq!(folder.files(), [""; 0], "{line}");
    }
    let usage = [
        "--kind shadw",
        "--kind shade --set shade.bots=1",
        "--kind shade --set levels.bits=8",
        "--kind shade --set shade.bits=99",
        "--kind shade --set bits=8",
        "--kind shade --scale 0",
        "--kind shade --zstd",
        "--kind shade --tile-size -1,2",
        "--kind shade --texels half",
        "--kind shade --format png --texels float",
    ];
    for line in usage {
        let failure = folder.bake_unless(false, line).expect_err(line);
        assert!(matches!(failure, Failure::Usage(_)), "{line}: {failure:?}");
    }
    let nearest = folder.bake_unless(false, "--kind shadw").expect_err("unknown");
    assert!(matches!(nearest, Failure::Usage(text) if text.contains("did you mean 'shade'")));
    // Heights in blocks only when asked for twice.
    folder.bake("--kind levels --format ktx2 --texels bc --lossy-heights");
    let file = read_ktx2(&folder.path("map.levels.odd.ktx2"), 1 << 24).expect("a texture");
    assert_eq!(file.format, TexelFormat::Bc4);

    std::fs::create_dir(folder.path("map.shade.exr")).expect("the folder is writable");
    assert!(folder.bake_unless(false, "--kind shade").is_err());
    let gone = MapFolder { map: folder.map.clone(), dir: tempfile::tempdir().expect("a temporary folder") };
    std::fs::remove_dir(gone.dir.path()).expect("it is empty");
    assert!(matches!(gone.bake_unless(true, "--kind shade"), Err(Failure::Work(_))));
    assert!(!gone.dir.path().exists(), "a folder that was made is removed again");
    gone.bake("--kind shade");
    assert_eq!(gone.files(), ["map.shade.exr"]);
}

#[test]
fn stored_values_lie_on_the_safe_side() {
    let storages = [Storage::Unorm { bits: 8 }, Storage::Unorm { bits: 16 }, Storage::Half, Storage::Float];
    for range in [[0.0, 1.0], [-1.0, 1.0], [0.3, 7.1]] {
        for rounding in [Rounding::Nearest, Rounding::Down, Rounding::Up] {
            let channel = Channel { name: "x", unit: "1", range, rounding };
            for storage in storages {
                for k in 0..=4000u32 {
                    let value = range[0] + (k as f32 / 4000.0) * (range[1] - range[0]);
                    let texel = storage.texel(value, &channel).expect("inside the range");
                    let span = range[1] - range[0];
                    let found = if storage.is_normalised() { range[0] + texel * span } else { texel };
                    let most = match storage {
                        Storage::Unorm { bits: 8 } => span / 254.0,
                        Storage::Unorm { .. } => span / 65500.0,
                        Storage::Half | Storage::Block => range[1] / 1000.0,
                        Storage::Float => 0.0,
                    };
                    assert!((found - value).abs() <= most, "{storage:?} {rounding:?}: {found} for {value}");
                    assert!(rounding != Rounding::Down || found <= value, "{storage:?}: {found} > {value}");
                    assert!(rounding != Rounding::Up || found >= value, "{storage:?}: {found} < {value}");
                }
            }
            let outside = [range[0] - 1.0, range[1] + 1.0];
            let held = outside.map(|value| Storage::Unorm { bits: 8 }.texel(value, &channel).is_ok());
            let expected = match rounding {
                Rounding::Nearest => [false, false],
                Rounding::Down => [false, true],
                Rounding::Up => [true, false],
            };
            assert_eq!(held, expected, "{range:?} {rounding:?}");
            assert!(storages[..3].iter().all(|storage| storage.texel(f32::NAN, &channel).is_err()));
        }
    }
}
