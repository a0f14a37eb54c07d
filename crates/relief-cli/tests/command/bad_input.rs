//! Wrong input of any kind: the command reports it in one paragraph, ends with the right code, and
//! leaves nothing behind.

use crate::common::command::Folder;
use crate::common::files::{Sample, claiming, every_format, exr};
use crate::common::maps::{Map, encoded};
use crate::common::refused::{OUT, assert_refused, entries, make_read_only, with_out};
use image::{DynamicImage, GrayImage, ImageFormat};

/// Damaged files a format.
const ROUNDS: usize = 60;

/// The command line that renders a map, without its own flags.
fn render(flags: &str) -> String {
    format!("render --backend cpu --size 4x4 -o out/a.png --aov out/a.exr {flags}")
}

#[test]
fn wrong_command_lines_are_refused_with_the_flag_named() {
    let folder = with_out();
    folder.write("map.png", Map::hills().png());
    let table: &[(&str, &[&str])] = &[
        ("--method relif", &["--method", "relief"]),
        ("--method 'relief'", &["--method", "relief"]),
        ("--search liner --refine none", &["--search", "linear"]),
        ("--search linear --refine bianry", &["--refine", "binary"]),
        ("--search linear", &["--search", "--refine"]),
        ("--refine binary", &["--refine", "--search"]),
        ("--method relief --search linear --refine binary", &["--method", "--search"]),
        ("--method relief --set serch.steps=4", &["--set", "search."]),
        ("--method relief --set search.step=4", &["--set", "steps"]),
        ("--method relief --set search.steps=0", &["search.steps", "4096"]),
        ("--method relief --set search.steps=1e9", &["search.steps", "4096"]),
        ("--method relief --set search.steps=1.5", &["search.steps", "whole"]),
        ("--method relief --set search.steps=nan", &["--set", "finite"]),
        ("--method relief --set search.steps", &["--set"]),
        ("--set steps=4", &["--set", "search."]),
        ("--mesh spere", &["--mesh", "sphere"]),
        ("--wrap mirrored", &["--wrap", "mirror"]),
        ("--backend cuda", &["--backend", "gpu"]),
        ("--sampling quick", &["--sampling", "fast"]),
        ("--sampling fast", &["fast", "CPU"]),
        ("--scale -1", &["--scale"]),
        ("--scale nan", &["--scale"]),
        ("--scale 1e300", &["--scale"]),
        ("--scale deep", &["--scale"]),
        ("--bias inf", &["--bias"]),
        ("--bias -1e30", &["--bias"]),
        ("--tile 0,0", &["--tile"]),
        ("--tile -1,1", &["--tile"]),
        ("--tile 1e30,1e30", &["--tile"]),
        ("--tile nan,1", &["--tile", "finite"]),
        ("--tile 3", &["--tile", "U,V"]),
        ("--eye 0,0,0", &["--eye"]),
        ("--target 0.6,0.9,1.1", &["--target"]),
        ("--eye nan,0,0", &["--eye", "finite"]),
        ("--eye 1e30,0,0", &["--eye"]),
        ("--target 1e200,0,0", &["--target"]),
        ("--eye 1,2", &["--eye", "X,Y,Z"]),
        ("--fov 0", &["--fov"]),
        ("--fov 180", &["--fov"]),
        ("--fov -40", &["--fov"]),
        ("--fov nan", &["--fov"]),
        ("--light 0,0,0", &["--light"]),
        ("--light inf,0,0", &["--light", "finite"]),
        ("--size 0x0", &["--size"]),
        ("--size 0x7", &["--size"]),
        ("--size 100000x100000", &["--size", "32768"]),
        ("--size 800", &["--size", "WxH"]),
        ("--size -8x6", &["--size"]),
        ("--range 5,5", &["--range"]),
        ("--range 9,1", &["--range"]),
        ("--range 0,nan", &["--range", "finite"]),
        ("--green sideways", &["--green", "+y"]),
        ("--raw 0x0,le", &["--raw"]),
        ("--raw 4x4,middle", &["--raw", "le"]),
        ("--shadow rey", &["--shadow", "ray"]),
        ("--shadow none --set shadow.samples=4", &["--set", "none"]),
        ("--shadow soft --set shadow.samples=0", &["shadow.samples", "256"]),
        ("--shadow horizon --set shadow.azimuths=3", &["shadow.azimuths", "256"]),
        ("--shadow horizon --shadow-search cone", &["--shadow-search", "rays"]),
        ("--shadow none --set shadow-search.limit=4", &["--set", "rays"]),
        ("--shadow-search relaxed-cone", &["--shadow-search", "impossible"]),
        ("--shadow-search cels", &["--shadow-search", "cells"]),
        ("--detail footprnt", &["--detail", "footprint"]),
        ("--detail footprint --set detail.anisotropy=0.5", &["detail.anisotropy", "64"]),
        ("--detail none --set detail.anisotropy=2", &["--set", "none"]),
        ("--detail footprint --search pyramid-texels --refine none", &["--search", "footprint", "none"]),
        ("--detail footprint --shadow-search pyramid-texels", &["--shadow-search", "footprint", "none"]),
        ("--ambient environmnt", &["--ambient", "environment"]),
        ("--ambient environment --set ambient.intensity=-1", &["ambient.intensity", "0"]),
        ("--environment a.exr --ambient bounce", &["--environment", "--ambient environment"]),
        ("--transmission 1 --ambient constant", &["--transmission", "--ambient environment"]),
        ("--transmission 1.5", &["--transmission", "0 to 1"]),
        ("--transmission nan", &["--transmission"]),
        ("--ior 0.9 --ambient environment", &["--ior", "1 to 4"]),
        ("--ior nan --ambient environment", &["--ior"]),
        ("--ior 2 --shade blinn-phong", &["--ior", "--ambient environment"]),
        ("--size map", &["--size", "--view top"]),
        ("--size map --view corner --projection orthographic", &["--size", "--view top"]),
        ("--size map --view top", &["--size", "--projection orthographic"]),
        ("--size map --view top --projection orthographic --mesh sphere", &["--size", "plane"]),
        ("--size map --view top --projection orthographic --rotation 0,90,0", &["--size", "rotation"]),
        ("--size map --view top --projection orthographic --tile-size 2,1", &["--size", "tile-size"]),
        ("--size maps", &["--size", "WxH", "map"]),
        ("--look stduio", &["--look", "studio"]),
        (
            "--look sun --view top --point-light 0,1,0 --ambient constant --ambient-color 1,1,1 --background \
             gradient --tone none --exposure 1",
            &["--look", "sun", "leave the look out"],
        ),
        ("--light az=,alt=45", &["--light", "az=315,alt=45"]),
        ("--light az=315,alt=-1", &["--light", "0 (the horizon)"]),
        ("--light az=315,alt=91", &["--light", "90 (straight up)"]),
        ("--background gradiant", &["--background", "gradient"]),
        ("--background 0.1,0.2", &["--background", "R,G,B"]),
        ("--light-angle -1", &["--light-angle", "90"]),
        ("--light-angle 90.5", &["--light-angle", "90"]),
        ("--light-angle nan", &["--light-angle"]),
        ("--max-memory 4GB", &["--max-memory", "GiB"]),
        ("--max-memory -1", &["--max-memory"]),
        ("--heigth map.png", &["--height"]),
        ("a.toml b.toml", &["b.toml"]),
        ("--output out/a.bmp", &["--output"]),
        ("--aov out/a.png", &["--aov"]),
    ];
    for (flags, words) in table {
        // A flag may be given once, so one that is in the table takes the place of the common one.
        let flag = |name: &str, value: &str| {
            if flags.contains(name) { String::new() } else { format!("{name} {value} ") }
        };
        let line = format!(
            "render --height map.png {}{}{}{}{flags}",
            flag("--backend", "cpu"),
            flag("--size", "4x4"),
            flag("--output", "out/a.png"),
            flag("--aov", "out/a.exr"),
        );
        assert_refused(&folder, &folder.relief(&line), 2, words);
    }
    assert_refused(&folder, &folder.relief(&render("")), 2, &["--height"]);
    let line = "--height map.png --shadow visibility --set shadow.azimuths=256 --set shadow.elevations=2";
    assert_refused(&folder, &folder.relief(&render(line)), 2, &["--set", "visibility", "256"]);
}

#[test]
fn files_that_cannot_be_used_are_refused_with_their_name() {
    let folder = with_out();
    folder.write("map.png", Map::hills().png());
    folder.write("empty.png", []);
    folder.write("empty.exr", []);
    folder.write("text.png", "This is no picture.\n");
    folder.write("unknown.r16", [7; 64]);
    folder
        .write("array.npy", b"\x93NUMPY\x01\0v\0{'descr': '<f4', 'fortran_order': False, 'shape': (4, 4), }");
    folder.write("grid.asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n3 4\n");
    let tile: Vec<u8> = (0..1201u32 * 1201).flat_map(|at| (100 + (at % 900) as i16).to_be_bytes()).collect();
    folder.write("N46E007.hgt", &tile);
    folder.write("zeros.tif", [0; 4096]);
    folder.write("folder.png/inside", []);
    let colour = image::RgbImage::from_fn(8, 8, |x, y| image::Rgb([x as u8, y as u8, 7]));
    folder.write("colour.png", encoded(&colour.into(), ImageFormat::Png));
    let one = image::RgbImage::from_pixel(1, 1, image::Rgb([7; 3]));
    folder.write("one.png", encoded(&one.into(), ImageFormat::Png));
    for (name, value) in [("nan", f32::NAN), ("inf", f32::INFINITY), ("minus", f32::NEG_INFINITY)] {
        let mut texels = vec![0.5; 64];
        texels[9] = value;
        folder.write(&format!("{name}.exr"), exr([8, 8], &[("Y", texels)]));
    }
    folder.write("nothing.exr", exr([8, 8], &[("Y", vec![f32::NAN; 64])]));
    folder.write("two.exr", exr([2, 2], &[("a", vec![0.5; 4]), ("b", vec![0.5; 4])]));
    let table: &[(&str, &[&str])] = &[
        ("--height missing.png", &["missing.png"]),
        ("--height .", &["folder"]),
        ("--height folder.png", &["folder.png", "folder"]),
        ("--height empty.png", &["empty.png", "empty"]),
        ("--height empty.exr", &["empty.exr", "empty"]),
        ("--height text.png", &["text.png", "PNG"]),
        ("--height zeros.tif", &["zeros.tif"]),
        ("--height unknown.r16", &["unknown.r16", "--raw"]),
        ("--height array.npy", &["array.npy", "NumPy", "imwrite"]),
        ("--height grid.asc", &["grid.asc", "Arc ASCII", "gdal_translate"]),
        ("--height N46E007.hgt", &["N46E007.hgt", "SRTM", "--raw 1201x1201,be --nodata 32768"]),
        ("--height unknown.r16 --raw 5x7,le", &["unknown.r16", "70"]),
        ("--height unknown.r16 --raw 100000x100000,le", &["unknown.r16"]),
        ("--height map.png --channel q", &["map.png", "'q'"]),
        ("--height map.png --channel alpha", &["map.png", "alpha"]),
        ("--height colour.png", &["colour.png", "--channel"]),
        ("--height two.exr", &["two.exr", "--channel"]),
        ("--height nan.exr", &["nan.exr", "--fill"]),
        ("--height inf.exr", &["inf.exr", "--fill"]),
        ("--height minus.exr", &["minus.exr", "--fill"]),
        ("--height nothing.exr --fill", &["nothing.exr"]),
        ("--height map.png --range 100,200", &["map.png", "range"]),
        ("--height map.png --color missing.png", &["missing.png"]),
        ("--height map.png --color text.png", &["text.png"]),
        ("--height map.png --color nan.exr", &["nan.exr"]),
        ("--height map.png --environment missing.exr", &["missing.exr"]),
        ("--height map.png --environment text.png", &["text.png"]),
        ("--height map.png --environment nan.exr", &["nan.exr", "finite"]),
        ("--height map.png --environment colour.png", &["colour.png", "8x8", "twice as wide as high"]),
        ("--height map.png --environment one.png", &["one.png", "1x1", "twice as wide as high"]),
        ("--height map.png --normal missing.png", &["missing.png"]),
        ("--height map.png --normal map.png", &["map.png", "normal"]),
        ("--height map.png --max-memory 0", &["--max-memory"]),
        ("--height map.png --max-memory 1KiB", &["--max-memory"]),
        ("missing.toml", &["missing.toml"]),
        ("text.png", &["text.png"]),
        ("out", &["out"]),
    ];
    for (flags, words) in table {
        assert_refused(&folder, &folder.relief(&render(flags)), 1, words);
    }
    // The command that is named reads the tile.
    let ran = folder.relief("inspect N46E007.hgt --raw 1201x1201,be --nodata 32768");
    assert!(ran.code == Some(0) && ran.stdout.contains("100 to 999"), "{ran:?}");
    // Headerless samples are heights alone.
    for (flag, is_height) in [("--height", true), ("--color", false), ("--environment", false)] {
        let height = if is_height { "" } else { "--height map.png" };
        let ran = folder.relief(&render(&format!("{height} {flag} text.png")));
        assert_eq!(ran.stderr.contains("--raw"), is_height, "{flag}: {}", ran.stderr);
    }
    for (line, word) in [
        ("missing.png", "missing.png"),
        ("text.png", "text.png"),
        ("map.png --channel q", "'q'"),
        ("map.png --normal map.png", "normal"),
        ("map.png --max-memory 100", "map.png"),
        ("folder.png", "folder of textures"),
    ] {
        assert_refused(&folder, &folder.relief(&format!("inspect {line}")), 1, &[word]);
    }
}

#[test]
fn mistakes_in_a_scene_are_refused_with_file_and_line() {
    let folder = with_out();
    folder.write("map.png", Map::hills().png());
    let table = [
        ("= 5", "line 2"),
        ("heigth = 'x.png'", "line 2"),
        ("mesh = 'shpere'", "sphere"),
        ("method = 'relif'", "relief"),
        ("search = 'linear'", "line 2"),
        ("search = 'lineer'\nrefine = 'none'", "linear"),
        ("[set]\nsearch.stepz = 4", "line 2"),
        ("[set]\nsearch.steps = 'many'", "line 3"),
        ("scale = -1", "line 2"),
        ("scale = nan", "line 2"),
        ("tile = [0, 0]", "line 2"),
        ("eye = [0, 0, 0]", "line 2"),
        ("fov = 180", "line 2"),
        ("light = [0, 0, 0]", "line 2"),
        ("size = [0, 0]", "line 2"),
        ("size = 'maps'", "map"),
        ("size = 'map'", "view top"),
        ("size = 'map'\nview = 'top'", "projection orthographic"),
        ("size = 'map'\nview = 'top'\nprojection = 'orthographic'\nmesh = 'sphere'", "plane"),
        ("size = 'map'\nview = 'top'\nprojection = 'orthographic'\nrotation = [0, 5, 0]", "rotation"),
        ("size = [100000, 100000]", "line 2"),
        ("max-memory = 'much'", "line 2"),
        ("lights = [{ position = [1e30, 0, 0] }]", "line 2"),
        ("lights = [{}]", "line 2"),
        ("lights = [{ direction = [0, 1, 0], position = [0, 1, 0] }]", "line 2"),
        ("lights = 'sun'", "line 2"),
        ("samples = 0", "line 2"),
        ("samples = 4.5", "line 2"),
        ("samples = 9223372036854775807", "line 2"),
        ("exposure = nan", "line 2"),
        ("exposure = 1e30", "line 2"),
        ("tone = 'filmic'", "agx"),
        ("view = 'above'", "top"),
        ("view = 'top'\neye = [1, 1, 1]", "line 2"),
        ("projection = 'isometric'", "orthographic"),
        ("view-height = 1", "line 2"),
        ("projection = 'orthographic'\neye = [1, 1, 1]", "s.toml"),
        ("projection = 'orthographic'\nfov = 40", "line 3"),
        ("tile-size = [0, 1]", "line 2"),
        ("tile-size = [1e-320, 1]", "line 2"),
        ("tile-size = [1e300, 1e300]", "line 2"),
        ("ambient = [nan, 0, 0]", "line 2"),
        ("background = [1, 1]", "line 2"),
        ("material = { diffuse = [2, 0, 0] }", "line 2"),
        ("material = { shininess = 0 }", "line 2"),
        ("material = { gloss = 1 }", "line 2"),
        ("surfaces = []\nsurface = 3", "line 3"),
        ("surfaces = [{ mesh = 'shpere' }]", "sphere"),
        ("surfaces = [{ size = 0 }]", "line 2"),
        ("surfaces = [{ size = 1e30 }]", "line 2"),
        ("height = 'again.png'", "line 2"),
        ("range = [5, 5]", "line 2"),
        ("wrap = 3", "line 2"),
        ("raw = '4x4'", "line 2"),
    ];
    for (mistake, word) in table {
        folder.write("s.toml", format!("height = 'map.png'\n{mistake}\n"));
        let ran = folder.relief("render s.toml --backend cpu -o out/a.png --aov out/a.exr");
        assert_refused(&folder, &ran, 1, &["s.toml", word]);
    }
    folder.write("s.toml", "height = 'nowhere/map.png'\n");
    assert_refused(&folder, &folder.relief(&render("s.toml")), 1, &["nowhere/map.png"]);
    folder.write("s.toml", [0xff, 0xfe, 0x00]);
    assert_refused(&folder, &folder.relief(&render("s.toml")), 1, &["s.toml"]);
    folder.write("s.toml", "#".repeat(2 << 20));
    assert_refused(&folder, &folder.relief(&render("s.toml")), 1, &["s.toml"]);
    folder.write("s.toml", "");
    assert_refused(&folder, &folder.relief(&render("s.toml")), 2, &["--height"]);
}

#[test]
fn outputs_that_cannot_be_written_are_refused() {
    let folder = with_out();
    folder.write("map.png", Map::hills().png());
    folder.write("file", "");
    folder.write("folder.png/inside", "");
    folder.write("folder.exr/inside", "");
    let refused = |line: &str, word: &str| {
        let ran = folder.relief(&format!("render --height map.png --backend cpu --size 4x4 {line}"));
        assert_refused(&folder, &ran, 1, &[word]);
    };
    refused("-o nowhere/a.png", "nowhere");
    refused("-o out/a.png --aov nowhere/a.exr", "nowhere");
    refused("-o file/a.png", "file");
    refused("-o folder.png", "folder.png");
    refused("-o out/a.png --aov folder.exr", "folder.exr");
    assert_eq!(entries(&folder.path("folder.png")), ["inside"]);
    #[cfg(target_os = "linux")]
    refused("-o /proc/a.png", "/proc/a.png");
    if make_read_only(&folder) {
        refused("-o out/a.png", "out/a.png");
    }
}

#[test]
fn sizes_that_headers_claim_are_refused() {
    let folder = with_out();
    let sizes = [[0, 0], [0, 9], [100_000, 100_000], [30_000, 30_000]];
    for sample in sizes.into_iter().flat_map(claiming) {
        folder.write(&sample.name, &sample.bytes);
        let ran = folder.relief(&render(&format!("--height {}", sample.name)));
        assert_refused(&folder, &ran, 1, &[&sample.name]);
        let ran = folder.relief(&format!("inspect {}", sample.name));
        assert_refused(&folder, &ran, 1, &[&sample.name]);
    }
}

#[test]
fn the_smallest_maps_are_fine() {
    let folder = with_out();
    for [width, height] in [[1, 1], [1, 13], [13, 1]] {
        let size = [width, height];
        let grey = DynamicImage::ImageLuma8(GrayImage::from_fn(width, height, |x, y| {
            image::Luma([20 * (x + y) as u8])
        }));
        folder.write("map.png", encoded(&grey, ImageFormat::Png));
        folder.write("map.jpg", encoded(&grey, ImageFormat::Jpeg));
        let values = (0..width * height).map(|at| at as f32 / 12.0).collect();
        folder.write("map.exr", exr(size, &[("Y", values)]));
        folder.write("map.pgm", [format!("P5 {width} {height} 255\n").as_bytes(), grey.as_bytes()].concat());
        folder.write("map.r16", vec![5; 2 * (width * height) as usize]);
        let raw = format!("map.r16 --raw {width}x{height},le");
        for map in ["map.png", "map.jpg", "map.exr", "map.pgm", &raw] {
            for method in ["exact", "relief", "parallax-iterative"] {
                folder.relief(&render(&format!("--height {map} --method {method} --wrap mirror"))).fine();
            }
            folder.relief(&format!("inspect {map}")).fine();
        }
        for shadow in ["ray", "none", "entry", "soft", "heuristic", "horizon", "visibility"] {
            for wrap in ["repeat", "clamp", "mirror"] {
                let flags = format!("--height map.png --shadow {shadow} --wrap {wrap} --light-angle 20");
                folder.relief(&render(&flags)).fine();
            }
        }
    }
}

/// A generator of numbers that is the same everywhere (xorshift64).
struct Random(u64);

impl Random {
    fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % limit as u64) as usize
    }
}

/// Renders or inspects a file that may be damaged, and fails if that ends in anything but an error
/// or both outputs.
fn survives(folder: &Folder, sample: &Sample, render_it: bool) -> bool {
    folder.write(&sample.name, &sample.bytes);
    let map = format!("{} {}", sample.name, sample.flags);
    let line = if render_it { render(&format!("--height {map}")) } else { format!("inspect {map}") };
    let ran = folder.relief(&line);
    if ran.code != Some(0) {
        assert_refused(folder, &ran, 1, &[&sample.name]);
        return false;
    }
    // What was damaged may be left out, which is noted.
    assert!(ran.stderr.lines().all(|said| said.starts_with("note: ")), "{line}: {}", ran.stderr);
    if render_it {
        let mut left = entries(&folder.path(OUT));
        left.sort_unstable();
        assert_eq!(left, ["a.exr", "a.png"]);
        left.iter().for_each(|name| std::fs::remove_file(folder.path(OUT).join(name)).expect("it is there"));
    }
    true
}

#[test]
fn whole_files_are_read_and_files_cut_off_refused() {
    let folder = with_out();
    for sample in every_format() {
        assert!(survives(&folder, &sample, true) && survives(&folder, &sample, false), "{}", sample.format);
        let len = sample.bytes.len();
        for cut in [1, 5, 20, len / 4, len / 2, len * 3 / 4, len - 1] {
            let cut_off = Sample { bytes: sample.bytes[..cut].to_vec(), ..sample.clone() };
            assert!(!survives(&folder, &cut_off, cut % 2 == 0), "{} cut at {cut}", sample.format);
        }
    }
}

#[test]
fn flipped_bits_give_an_error_or_a_picture() {
    let folder = with_out();
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    for sample in every_format() {
        let mut read = 0;
        for round in 0..ROUNDS {
            let mut flipped = sample.clone();
            // Half of the flips hit the first bytes, where headers are.
            let within = if round % 4 < 2 { flipped.bytes.len().min(300) } else { flipped.bytes.len() };
            for _ in 0..=random.below(3) {
                flipped.bytes[random.below(within)] ^= 1 << random.below(8);
            }
            read += usize::from(survives(&folder, &flipped, round % 2 == 0));
        }
        println!("{}: {read} of {ROUNDS} are still read", sample.format);
    }
}
