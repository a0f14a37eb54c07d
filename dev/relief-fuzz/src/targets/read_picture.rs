use image_webp::{ColorType as WebpColor, WebPEncoder};
use png::{BitDepth, ColorType};
use relief_io::{Curve, Source, read_metadata, read_notes, read_picture, read_picture_as};

use super::{MAX_BYTES, with_choice};
use crate::Target;
use crate::common::broken::valid_files;
use crate::common::files::{exif, jpeg, png, png_with, with_chunk, with_exif};

/// Any bytes as a picture's file: an error or as many texels as its size says, never
/// more memory than allowed.
pub const READ_PICTURE: Target = Target { name: "read_picture", run, make };

fn run(bytes: &[u8]) -> bool {
    let Some((&choice, bytes)) = bytes.split_first() else { return false };
    let source = Source::bytes("a", bytes);
    let _ = read_notes(source);
    let _ = read_metadata(source);
    let picture = match choice & 1 {
        0 => read_picture(source, MAX_BYTES),
        _ => read_picture_as(source, Curve::Linear, MAX_BYTES),
    };
    let Ok(picture) = picture else { return false };
    assert_eq!(picture.texels.len(), picture.width as usize * picture.height as usize);
    true
}

fn make() -> Vec<Vec<u8>> {
    let [width, height] = [9, 7];
    let count = (width * height) as usize;
    let bytes: Vec<u8> = (0..count * 4).map(|at| (at * 37) as u8).collect();
    let palette = |encoder: &mut png::Encoder<'_, &mut Vec<u8>>| {
        encoder.set_palette(bytes[..12].to_vec());
        encoder.set_trns(bytes[..3].to_vec());
        encoder.set_source_gamma(png::ScaledFloat::new(0.45));
    };
    let packed = vec![0b0001_1011; 3 * height as usize];
    let rgb = png(width, height, ColorType::Rgb, BitDepth::Eight, &bytes[..3 * count]);
    let mut webp = Vec::new();
    let encoded = WebPEncoder::new(&mut webp).encode(&bytes, width, height, WebpColor::Rgba8);
    encoded.expect("a valid picture");
    let mut files = vec![
        png_with(width, height, ColorType::Indexed, BitDepth::Two, &packed, palette),
        png(width, height, ColorType::GrayscaleAlpha, BitDepth::Sixteen, &bytes),
        with_chunk(&rgb, b"eXIf", &exif(6, true), b"IDAT"),
        with_chunk(&rgb, b"tEXt", b"a note\0of some words", b"IDAT"),
        with_exif(&jpeg(width, height, 3, &bytes[..3 * count]), &exif(8, false)),
        rgb,
        webp,
    ];
    // No pictures are headerless samples, and no colours are in a channel named `single`.
    let other = |name: &str| name != "raw" && !name.ends_with("exr");
    files.extend(valid_files().into_iter().filter(|file| other(&file.name)).map(|file| file.bytes));
    files.iter().zip(0..).map(|(file, choice)| with_choice(choice, file)).collect()
}
