//! Reading peaks at 8 bytes a texel and 32 MiB; a refused header at 32 MiB. Measured as the peak of the
//! resident memory of a process that reads one file and nothing else, on systems that report it.
#![cfg(target_os = "linux")]

mod common;

use std::path::Path;
use std::process::Command;

use ::exr::prelude::{Compression, SampleType as ExrSample};
use common::files::{Scan, hdr, jpeg, png};
use common::mesh_file::{Ply, glb, gltf, gltf_buffer, obj, ply};
use common::tiff_file::{Tiff, Value};
use common::{Folder, exr_file, landscape};
use png::{BitDepth, ColorType};
use relief_core::mesh::{Mesh, RawMesh, torus};
use relief_io::{Fill, HeightOptions, MeshFormat, MeshOptions, Source, read_height, read_mesh};

const SIDE: u32 = 2600;
const TEXELS: u64 = SIDE as u64 * SIDE as u64;
const MIB: u64 = 1 << 20;
const BUDGET: u64 = 32 * MIB + 8 * TEXELS;

/// The file that the child process reads, the channel, and whether it reads the file's bytes, which it has in
/// memory.
const FILE: &str = "RELIEF_IO_MEMORY_FILE";
const CHANNEL: &str = "RELIEF_IO_MEMORY_CHANNEL";
const BYTES: &str = "RELIEF_IO_MEMORY_BYTES";

fn peak() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").expect("Linux has it");
    let line = status.lines().find(|line| line.starts_with("VmHWM:")).expect("the peak is reported");
    let kib: u64 = line.split_ascii_whitespace().nth(1).and_then(|kib| kib.parse().ok()).expect("a number");
    kib * 1024
}

/// Not a test of its own: what [`measure`] runs in another process. Without its file it has nothing to do.
#[test]
fn child() {
    let Some(file) = std::env::var_os(FILE) else {
        return;
    };
    let channel = std::env::var(CHANNEL).ok().filter(|name| !name.is_empty());
    let raw = channel.as_deref().and_then(|name| name.parse().ok());
    let channel = if raw.is_some() { None } else { channel };
    let options = HeightOptions { channel, raw, fill: Fill::Always, ..HeightOptions::default() };
    let bytes = std::env::var_os(BYTES).map(|_| std::fs::read(&file).expect("the file is there"));
    let source = bytes.as_ref().map_or(Source::from(&file), |bytes| Source::bytes(&file, bytes));
    let idle = peak();
    let read = if MeshFormat::by_name(Path::new(&file)).is_some() {
        read_mesh(source, &MeshOptions::default()).is_ok()
    } else {
        read_height(source, &options).is_ok()
    };
    println!("peak {} read {read}", peak() - idle);
}

/// The peak above the idle process while reading, and whether a map came back.
fn measure(path: &Path, channel: &str) -> (u64, bool) {
    measure_in(|program| program.env(FILE, path).env(CHANNEL, channel))
}

/// Measures a process whose environment `tell` sets.
fn measure_in(tell: impl Fn(&mut Command) -> &mut Command) -> (u64, bool) {
    let mut program = Command::new(std::env::current_exe().expect("the test knows its program"));
    program.args(["--exact", "child", "--nocapture", "--test-threads=1"]);
    let output = tell(&mut program).output().expect("the test can run itself");
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let line = text.lines().find_map(|line| line.split_once("peak ")).map(|(_, rest)| rest);
    let words: Vec<&str> = line.expect("the child reports").split_ascii_whitespace().collect();
    (words[0].parse().expect("a number of bytes"), words[2] == "true")
}

fn assert_within(name: &str, bytes: &[u8], channel: &str, budget: u64) {
    let folder = Folder::new();
    let (peak, read) = measure(&folder.file(name, bytes), channel);
    println!("{name}: {:.1} MiB, {:.2} bytes a texel", peak as f64 / MIB as f64, peak as f64 / TEXELS as f64);
    assert!(read, "{name} is not read");
    assert!(
        peak >= 4 * TEXELS,
        "{name}: {peak} bytes are less than the map itself: the measurement is wrong"
    );
    assert!(peak <= budget, "{name}: {peak} bytes, the budget is {budget}");
}

/// A landscape as bytes; cheap to make, not too cheap to compress.
fn heights() -> Vec<u8> {
    let height = landscape(SIDE / 8, SIDE / 8);
    let texels = (0..SIDE).flat_map(|j| (0..SIDE).map(move |i| (i, j)));
    texels.map(|(i, j)| (height(i / 8, j / 8) * 250.0) as u8 + ((i ^ j) & 1) as u8).collect()
}

#[test]
fn png_and_jpeg() {
    let grey = heights();
    let rgba: Vec<u8> = grey.iter().flat_map(|&h| [h, h / 2, h / 3, h]).collect();
    let wide: Vec<u8> = rgba.iter().flat_map(|&h| [h, h]).collect();
    let file = |colour, depth, data: &[u8]| png(SIDE, SIDE, colour, depth, data);
    assert_within("grey8.png", &file(ColorType::Grayscale, BitDepth::Eight, &grey), "", BUDGET);
    assert_within("rgba8.png", &file(ColorType::Rgba, BitDepth::Eight, &rgba), "a", BUDGET);
    assert_within("rgba16.png", &file(ColorType::Rgba, BitDepth::Sixteen, &wide), "a", BUDGET);
    let three: Vec<u8> = grey.iter().flat_map(|&h| [h; 3]).collect();
    assert_within("colour.jpg", &jpeg(SIDE, SIDE, 3, &three), "", BUDGET);
}

#[test]
fn exr_of_several_channels() {
    let mut values: Vec<f64> = heights().iter().map(|&h| f64::from(h) / 251.0).collect();
    let half: Vec<f64> = values.iter().map(|h| 1.0 - h).collect();
    let channels = |kind| -> [exr_file::Samples<'_>; 4] {
        [("R", kind, &half), ("G", kind, &half), ("B", kind, &half), ("A", kind, &half)]
    };
    for (name, compression) in [("zip", Compression::ZIP16), ("piz", Compression::PIZ)] {
        let bytes = exr_file::exr([SIDE; 2], None, compression, &channels(ExrSample::F32));
        assert_within(&format!("{name}.exr"), &bytes, "A", BUDGET);
    }
    let bytes =
        exr_file::exr([SIDE; 2], Some([256, 256]), Compression::DWAA(None), &channels(ExrSample::F16));
    assert_within("dwa tiles.exr", &bytes, "G", BUDGET);
    // Filling needs a pyramid besides.
    values.chunks_mut(100).step_by(3).for_each(|run| run.fill(f64::NAN));
    let bytes = exr_file::exr([SIDE; 2], None, Compression::RLE, &[("Y", ExrSample::F32, &values)]);
    assert_within("holes.exr", &bytes, "", BUDGET);
}

#[test]
fn tiff_in_small_and_in_large_blocks() {
    let values: Vec<f64> = heights().iter().map(|&h| f64::from(h)).collect();
    let float = Tiff { deflate: true, ..Tiff::grey(SIDE, SIDE, 32, 3) };
    assert_within("strips.tif", &float.bytes(&values), "", BUDGET);
    assert_within("doubles.tif", &Tiff { bits: 64, ..float.clone() }.bytes(&values), "", BUDGET);
    let tiles = Tiff { tile_width: Some(256), block_rows: 256, ..float.clone() };
    assert_within("tiles.tif", &tiles.bytes(&values), "", BUDGET);
    let kind = vec![(254, Value::Long(vec![4]))];
    let mask = Tiff { bits: 1, format: 1, photometric: 4, extra: kind, ..float.clone() };
    let masked = float.bytes_before(&values, &[(mask, values.clone())]);
    assert_within("masked.tif", &masked, "", BUDGET);
    // A single strip is held whole, compressed and not: the documented exception.
    let whole = Tiff { block_rows: SIDE, ..float };
    assert_within("one strip.tif", &whole.bytes(&values), "", 32 * MIB + 16 * TEXELS);
}

#[test]
fn hdr_pgm_and_raw() {
    let grey = heights();
    let texels: Vec<[u8; 4]> = grey.iter().map(|&h| [h, h, h, 130]).collect();
    assert_within("map.hdr", &hdr(SIDE, SIDE, Scan::Components, &texels), "", BUDGET);
    let mut pgm = format!("P5 {SIDE} {SIDE} 255\n").into_bytes();
    pgm.extend(&grey);
    assert_within("map.pgm", &pgm, "", BUDGET);
    let wide: Vec<u8> = grey.iter().flat_map(|&h| [h, h]).collect();
    assert_within("map.r16", &wide, &format!("{SIDE}x{SIDE},le"), BUDGET);
}

#[test]
fn bytes_in_memory_are_read_where_they_are() {
    let folder = Folder::new();
    let values: Vec<f64> = heights().iter().map(|&h| f64::from(h)).collect();
    let wide: Vec<u8> = heights().iter().flat_map(|&h| [h, h]).collect();
    let mut pgm = format!("P5 {SIDE} {SIDE} 65535\n").into_bytes();
    pgm.extend(&wide);
    let exr = exr_file::exr([SIDE; 2], None, Compression::Uncompressed, &[("Y", ExrSample::F32, &values)]);
    let files =
        [("map.tif", Tiff::grey(SIDE, SIDE, 64, 3).bytes(&values)), ("map.pgm", pgm), ("map.exr", exr)];
    for (name, bytes) in files {
        let path = folder.file(name, &bytes);
        let (from_file, _) = measure(&path, "");
        let (from_bytes, read) = measure_in(|program| program.env(FILE, &path).env(BYTES, ""));
        println!("{name}: {from_bytes} bytes, of the file {from_file}");
        assert!(read && from_bytes >= 4 * TEXELS, "{name}: {from_bytes} bytes");
        let length = bytes.len() as u64;
        assert!(from_bytes < from_file + length / 2, "{name}: {from_bytes} bytes, of the file {from_file}");
    }
}

#[test]
fn a_mesh_takes_no_more_than_is_counted() {
    let folder = Folder::new();
    let whole = torus(300, 200).expect("a built-in mesh");
    // Of every triangle for itself, with a texture of its own, there is nothing to share.
    let corners = (0..whole.triangles().len() as u32).flat_map(|triangle| {
        let shift = glam::Vec2::splat((triangle % 64) as f32 * 0.25);
        whole.corners(triangle).map(|corner| relief_core::mesh::Vertex { uv: corner.uv + shift, ..*corner })
    });
    let vertices: Vec<_> = corners.collect();
    let triangles = (0..vertices.len() as u32 / 3).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
    let soup = Mesh::new(vertices, triangles).expect("a mesh");
    for (kind, mesh) in [("whole", &whole), ("soup", &soup)] {
        let files = [
            ("obj", obj(mesh, true).into_bytes()),
            ("ply", ply(mesh, Ply::Big)),
            ("glb", glb(&gltf(mesh, None, ""), &gltf_buffer(mesh))),
        ];
        for (ending, bytes) in files {
            let (peak, read) = measure(&folder.file(&format!("{kind}.{ending}"), &bytes), "");
            let (triangles, positions) = (mesh.triangles().len() as u64, mesh.vertices().len() as u64);
            // A normal and texture coordinates of each position are counted besides.
            let counted = RawMesh::BYTES_PER_TRIANGLE * triangles
                + (RawMesh::BYTES_PER_POSITION + 60) * positions
                + bytes.len() as u64;
            println!(
                "{kind}.{ending}: {:.1} MiB of {:.1}",
                peak as f64 / MIB as f64,
                counted as f64 / MIB as f64
            );
            assert!(read && peak > 68 * triangles, "{kind}.{ending}: {peak} bytes are less than the mesh");
            assert!(peak < counted + 4 * MIB, "{kind}.{ending}: {peak} of {counted} bytes");
        }
    }
}

#[test]
fn refused_headers_take_little_memory() {
    let folder = Folder::new();
    let files = common::broken::broken_files();
    let huge = files
        .iter()
        .filter(|file| file.name.ends_with("of 100000x100000") || file.name.ends_with("of 20000x20000"));
    let mut count = 0;
    for file in huge {
        let (peak, read) = measure(&folder.file(&format!("file.{}", file.extension), &file.bytes), "");
        assert!(!read, "{} is read", file.name);
        assert!(peak <= 32 * MIB, "{}: {peak} bytes", file.name);
        count += 1;
    }
    assert_eq!(count, 16);
}
