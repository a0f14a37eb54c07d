//! Peak of the command's resident memory. Reading peaks at 8 bytes a texel and 32 MiB above the
//! idle process, a refused header at 32 MiB; rendering and integrating keep to what they count
//! against `--max-memory`, and pictures of any size take a band of rows.
//!
//! The system counts the parent's memory against a child until the child's program has started, so
//! the files are written row by row, and the tests run one after the other.

mod common;

use std::fs::File;
use std::io::{BufWriter, Write};
use std::process::Stdio;
use std::sync::{Mutex, PoisonError};

use common::command::Folder;
use common::files::{Samples, claiming, tiff_header};
use common::maps::Map;
use exr::block::UncompressedBlock;
use exr::block::writer::ChunksWriter;
use exr::meta::header::Header;
use exr::meta::{BlockDescription, MetaData};
use exr::prelude::{ChannelDescription, Compression, LineOrder, SampleType, SmallVec, Text};
use png::{BitDepth, ColorType, Compression as PngCompression, Encoder};
use wait4::Wait4;

const MIB: u64 = 1 << 20;

/// Side of the large maps.
const SIDE: u32 = 4096;
const TEXELS: u64 = SIDE as u64 * SIDE as u64;

/// Memory that anything may take that does not grow with the maps.
const FIXED: u64 = 32 * MIB;

/// Limits in bytes per texel: reading, rendering with the exact tracer, and rendering without it,
/// with levels of detail.
const READ_BYTES: u64 = 8;
const EXACT_BYTES: u64 = 11 + 16;
const METHOD_BYTES: u64 = 8 + 16;

/// Limit in bytes per texel for integrating a normal map: it counts as much against `--max-memory`.
const INTEGRATION_BYTES: u64 = 32;

/// Limit in bytes for rendering a picture of any size: it counts as much against `--max-memory`.
const PICTURE_BYTES: u64 = 64 * MIB;

static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());

/// Runs a test where memory is counted as it expects, alone.
fn alone(test: impl FnOnce(&Folder, u64)) {
    if !cfg!(target_os = "linux") {
        println!("skipped: peaks of resident memory are compared on Linux only");
        return;
    }
    let _turn = ONE_AT_A_TIME.lock().unwrap_or_else(PoisonError::into_inner);
    let folder = Folder::new();
    let (code, idle) = peak(&folder, "--version");
    assert_eq!(code, Some(0));
    assert!((MIB..24 * MIB).contains(&idle), "an idle process takes {idle} bytes: the measurement is wrong");
    test(&folder, idle);
}

/// The exit code and the peak of resident memory of one run, in bytes.
fn peak(folder: &Folder, line: &str) -> (Option<i32>, u64) {
    let mut command = folder.command();
    command.args(line.split_ascii_whitespace()).stdout(Stdio::null()).stderr(Stdio::null());
    // With a user the command is forked. Otherwise it begins in the memory of this process, whose
    // peak counts as its own.
    #[cfg(unix)]
    {
        use std::os::unix::{fs::MetadataExt, process::CommandExt};
        command.uid(std::fs::metadata(folder.path(".")).expect("it is there").uid());
    }
    let used = command.spawn().and_then(Wait4::wait4).expect("the command runs");
    (used.status.code(), used.rusage.maxrss)
}

fn assert_within(folder: &Folder, idle: u64, line: &str, code: i32, least: u64, most: u64) {
    let (found, peak) = peak(folder, line);
    let above = peak.saturating_sub(idle);
    println!("{:.1} MiB: relief {line}", above as f64 / MIB as f64);
    assert_eq!(found, Some(code), "relief {line}");
    assert!(above >= least, "relief {line}: {above} bytes, less than it must hold: the measurement is wrong");
    assert!(above <= most, "relief {line}: {above} bytes, {most} are allowed");
}

/// Rows of hills with a rough surface: not too easy to compress.
fn row(y: u32) -> impl Iterator<Item = u16> {
    (0..SIDE).map(move |x| {
        let hills = (x.min(SIDE - x) + y.min(SIDE - y)) * 14;
        hills as u16 + ((x * 7 + y * 13) & 31) as u16
    })
}

fn create(folder: &Folder, name: &str) -> BufWriter<File> {
    BufWriter::new(File::create(folder.path(name)).expect("the temporary folder is writable"))
}

fn write_rows(out: &mut impl Write, header: &[u8], bytes: fn(u16) -> [u8; 2]) {
    out.write_all(header).expect("there is room");
    for y in 0..SIDE {
        let row: Vec<u8> = row(y).flat_map(bytes).collect();
        out.write_all(&row).expect("there is room");
    }
    out.flush().expect("there is room");
}

fn write_png(folder: &Folder) {
    let mut encoder = Encoder::new(create(folder, "map.png"), SIDE, SIDE);
    encoder.set_color(ColorType::Grayscale);
    encoder.set_depth(BitDepth::Sixteen);
    encoder.set_compression(PngCompression::Fast);
    let mut writer = encoder.write_header().expect("there is room");
    let mut stream = writer.stream_writer().expect("there is room");
    write_rows(&mut stream, &[], u16::to_be_bytes);
    stream.finish().expect("there is room");
}

fn write_exr(folder: &Folder) {
    let mut channels: SmallVec<[ChannelDescription; 5]> = SmallVec::new();
    channels.push(ChannelDescription::new(Text::from("Y"), SampleType::F32, false));
    let header = Header::new(Text::from(""), (SIDE as usize, SIDE as usize), channels).with_encoding(
        Compression::ZIP16,
        BlockDescription::ScanLines,
        LineOrder::Increasing,
    );
    let headers = [header].into_iter().collect();
    exr::block::write(create(folder, "map.exr"), headers, true, |meta: MetaData, chunks| {
        let list = &meta.headers[0].channels;
        let blocks = meta.collect_ordered_block_data(|block| {
            UncompressedBlock::collect_block_data_from_lines(list, block, |line| {
                let samples = row(line.location.position.y() as u32);
                for (bytes, sample) in line.value.chunks_exact_mut(4).zip(samples) {
                    bytes.copy_from_slice(&f32::from(sample).to_ne_bytes());
                }
            })
        });
        let mut compressor = chunks.sequential_blocks_compressor(&meta);
        blocks.into_iter().try_for_each(|(index, block)| compressor.compress_block(index, block))
    })
    .expect("there is room");
}

#[test]
fn reading_and_rendering_large_maps() {
    alone(|folder, idle| {
        let size = [SIDE, SIDE];
        write_png(folder);
        write_exr(folder);
        let tiff = tiff_header(size, 16, Samples::Short, &[]);
        write_rows(&mut create(folder, "map.tif"), &tiff, u16::to_le_bytes);
        let pgm = format!("P5 {SIDE} {SIDE} 65535\n");
        write_rows(&mut create(folder, "map.pgm"), pgm.as_bytes(), u16::to_be_bytes);
        write_rows(&mut create(folder, "map.r16"), &[], u16::to_le_bytes);
        let raw = format!("map.r16 --raw {SIDE}x{SIDE},le");
        let least = 4 * TEXELS;
        for map in ["map.png", "map.exr", "map.tif", "map.pgm", &raw] {
            let most = FIXED + READ_BYTES * TEXELS;
            assert_within(folder, idle, &format!("inspect {map}"), 0, least, most);
        }
        let render = |map: &str, method: &str, bytes: u64| {
            let line = format!("render --backend cpu --size 8x8 -o a.png --height {map} --method {method}");
            assert_within(folder, idle, &line, 0, least, FIXED + bytes * TEXELS);
        };
        render("map.png", "exact", EXACT_BYTES);
        render("map.exr", "exact", EXACT_BYTES);
        render("map.png", "relief", METHOD_BYTES);
        // Refused work does not take the memory: the picture and 8 bytes a texel would fit, 11
        // would not.
        let tight = "render --backend cpu --size 8x8 -o a.png --height map.pgm --max-memory";
        assert_within(folder, idle, &format!("{tight} 100MiB"), 1, 0, FIXED);
        assert_within(folder, idle, &format!("{tight} 170MiB"), 1, 0, FIXED + READ_BYTES * TEXELS);
    });
}

#[test]
fn integrating_takes_what_is_counted_for_it() {
    alone(|folder, idle| {
        let side = 1536;
        let mut encoder = Encoder::new(create(folder, "n.png"), side, side);
        encoder.set_color(ColorType::Rgb);
        encoder.set_compression(PngCompression::Fast);
        let mut writer = encoder.write_header().expect("there is room");
        let mut stream = writer.stream_writer().expect("there is room");
        for y in 0..side {
            let row = (0..side).flat_map(|x| [100 + (x * y % 57) as u8, 100 + ((x + y) % 57) as u8, 240]);
            stream.write_all(&row.collect::<Vec<u8>>()).expect("there is room");
        }
        stream.finish().expect("there is room");
        drop(writer);
        let texels = u64::from(side).pow(2);
        // An unknown green direction takes the most memory.
        let line = "height from-normals n.png -o h.exr --max-misfit 100 --wrap";
        for wrap in ["repeat", "clamp"] {
            let most = FIXED + INTEGRATION_BYTES * texels;
            assert_within(folder, idle, &format!("{line} {wrap}"), 0, 20 * texels, most);
        }
        assert_within(folder, idle, &format!("{line} clamp --max-memory 24MiB"), 1, 0, FIXED);
        assert_within(folder, idle, &format!("{line} clamp --max-memory 70MiB"), 1, 0, FIXED + 12 * texels);
    });
}

#[test]
fn refused_headers_take_next_to_nothing() {
    alone(|folder, idle| {
        for sample in [[100_000, 100_000], [30_000, 30_000], [20_000, 20_000]].into_iter().flat_map(claiming)
        {
            folder.write(&sample.name, &sample.bytes);
            assert_within(folder, idle, &format!("inspect {}", sample.name), 1, 0, FIXED);
            let line = format!("render --backend cpu --size 8x8 -o a.png --height {}", sample.name);
            assert_within(folder, idle, &line, 1, 0, FIXED);
        }
    });
}

#[test]
fn pictures_of_any_size_take_what_is_counted_for_a_band() {
    alone(|folder, idle| {
        folder.write("map.png", Map::hills().png());
        let render = |size: &str, more: &str| {
            format!("render --height map.png --backend cpu -o a.png --aov a.exr --size {size} {more}")
        };
        for size in ["1200x1000", "4000x3000"] {
            let line = render(size, "--method bump --samples 1");
            assert_within(folder, idle, &line, 0, 20 * MIB, FIXED + PICTURE_BYTES);
        }
        assert_within(folder, idle, &render("40000x40000", ""), 2, 0, FIXED);
        assert_within(folder, idle, &render("1200x1000", "--max-memory 60MiB"), 1, 0, FIXED);
    });
}

#[test]
fn pictures_take_a_band_in_every_format() {
    alone(|folder, _| {
        folder.write("map.png", Map::hills().png());
        for size in ["3000x2000", "12000x500"] {
            let taken = |name: &str| {
                let line = format!(
                    "render --height map.png --backend cpu --method bump --shadow none --samples 1 --size \
                     {size} -o {name}"
                );
                let (code, peak) = peak(folder, &line);
                assert_eq!(code, Some(0), "relief {line}");
                peak
            };
            let [png, jpeg] = ["a.png", "a.jpg"].map(taken);
            println!("{size}: {png} {jpeg}");
            // All pixels together take 18 MB.
            assert!(jpeg < png + 8 * MIB, "{size}: {jpeg} bytes where a PNG takes {png}");
        }
    });
}

#[test]
fn surfaces_take_what_is_counted_for_them() {
    alone(|folder, idle| {
        folder.write("n.png", Map::hills().png());
        let scene = |name: &str, count: usize, more: &str| {
            folder
                .write(name, format!("height = 'n.png'\n{}", format!("[[surfaces]]\n{more}").repeat(count)));
            format!("render {name} --backend cpu --size 16x16 --samples 1 --shadow none --no-cache -o a.png")
        };
        for (count, more, of_mesh) in [
            (1500, "", 2 * 640),
            (1500, "mesh = 'cube'\n", 12 * 640),
            (40, "mesh = 'sphere'\n", 16_000 * 640),
        ] {
            let counted = count as u64 * ((64 << 10) + of_mesh);
            let line = scene("s.toml", count, more);
            assert_within(folder, idle, &line, 0, MIB, FIXED + counted + READ_BYTES * 16 * 12 * count as u64);
            // Refused work does not take the memory.
            assert_within(
                folder,
                idle,
                &format!("{line} --max-memory 64MiB"),
                1,
                0,
                FIXED + 4096 * count as u64,
            );
        }
        // A scene file is checked before its memory limit is known.
        let line = scene("s.toml", 600, "mesh = 'torus'\n");
        assert_within(folder, idle, &line, 1, 0, FIXED + 6000 * 600);
        let line = format!("{} --max-memory 64MiB", scene("s.toml", 5000, ""));
        let ran = folder.relief(&line);
        assert_eq!(ran.code, Some(1));
        let words = ["5000 surfaces", "64MiB", "--max-memory"];
        assert!(words.iter().all(|word| ran.stderr.contains(word)), "{}", ran.stderr);
    });
}
