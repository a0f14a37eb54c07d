use png::{BitDepth, ColorType};
use relief_io::{GreenSign, Source, read_normal_map};

use super::{MAX_BYTES, with_choice};
use crate::Target;
use crate::common::exr_file::{self, COMPRESSIONS};
use crate::common::files::{jpeg, png};
use crate::common::samples;
use crate::common::tiff_file::Tiff;

/// Any bytes as a normal map's file: an error or unit vectors, never more memory than allowed.
pub const READ_NORMALS: Target = Target { name: "read_normals", run, make };

fn run(bytes: &[u8]) -> bool {
    let Some((&choice, bytes)) = bytes.split_first() else { return false };
    let green = if choice & 1 == 0 { GreenSign::PlusY } else { GreenSign::MinusY };
    let Ok(map) = read_normal_map(Source::bytes("a", bytes), green, MAX_BYTES) else { return false };
    assert_eq!(map.normals.len(), map.width as usize * map.height as usize);
    for [x, y, z] in map.normals {
        assert!(((x * x + y * y + z * z).sqrt() - 1.0).abs() < 1e-5, "{x} {y} {z}");
    }
    true
}

fn make() -> Vec<Vec<u8>> {
    let size @ [width, height] = [13, 11];
    // Slopes of up to 45 degrees.
    let normals: Vec<[f64; 3]> =
        samples(width, height, 255.0).iter().map(|sample| [sample / 255.0 - 0.5, 0.25, 0.9]).collect();
    let codes = |most: f64| -> Vec<f64> {
        normals.as_flattened().iter().map(|part| ((part + 1.0) / 2.0 * most).round()).collect()
    };
    let bytes: Vec<u8> = codes(255.0).iter().map(|&code| code as u8).collect();
    let opaque: Vec<u8> = bytes.chunks(3).flat_map(|rgb| [rgb[0], rgb[1], rgb[2], 255]).collect();
    let wide: Vec<u8> = codes(65535.0).iter().flat_map(|&code| (code as u16).to_be_bytes()).collect();
    let part = |axis: usize| -> Vec<f64> { normals.iter().map(|normal| normal[axis]).collect() };
    let [x, y, z] = [0, 1, 2].map(part);
    let float = exr::prelude::SampleType::F32;
    let (_, compression, _) = COMPRESSIONS[3];
    let channels: [exr_file::Samples<'_>; 3] = [("R", float, &x), ("G", float, &y), ("B", float, &z)];
    let tiff = Tiff { bands: 3, photometric: 2, ..Tiff::grey(width, height, 16, 1) };
    let files = [
        png(width, height, ColorType::Rgb, BitDepth::Eight, &bytes),
        png(width, height, ColorType::Rgba, BitDepth::Eight, &opaque),
        png(width, height, ColorType::Rgb, BitDepth::Sixteen, &wide),
        jpeg(width, height, 3, &bytes),
        exr_file::exr(size, None, compression, &channels),
        tiff.bytes(&codes(65535.0)),
    ];
    files.iter().zip(0..).map(|(file, choice)| with_choice(choice, file)).collect()
}
