#!/usr/bin/env bash
# The crate png 0.18.1 reads a PNG's gamma into one field of `Info` and writes it from another.
#
# What one expects: the `Info` that the decoder gives can be handed to the encoder (`Encoder::with_info` takes it), and
# the new file says the same of its samples. What happens: the decoder fills `gama_chunk` and leaves `source_gamma` empty,
# the encoder looks at `source_gamma` alone. A linear picture (gAMA 1.0) that is decoded and encoded so loses the chunk
# without an error, and programs take its samples for sRGB.
#
# Shown by a picture of one texel that is written with `source_gamma`, read, and written again with the `Info` that was
# read. Needs cargo and a registry. Fails where it is no longer so.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir src
cat >Cargo.toml <<'T'
[package]
name = "probe"
version = "0.0.0"
edition = "2024"
[dependencies]
png = "=0.18.1"
T
cat >src/main.rs <<'T'
use png::{BitDepth, ColorType, Decoder, Encoder, Info, ScaledFloat};
use std::io::Cursor;

fn written(info: Info) -> Vec<u8> {
    let mut file = Vec::new();
    let mut writer = Encoder::with_info(&mut file, info).unwrap().write_header().unwrap();
    writer.write_image_data(&[128, 0]).unwrap();
    writer.finish().unwrap();
    file
}

fn has_chunk(file: &[u8]) -> bool {
    file.windows(4).any(|four| four == b"gAMA")
}

fn main() {
    let mut info = Info::with_size(1, 1);
    info.bit_depth = BitDepth::Sixteen;
    info.color_type = ColorType::Grayscale;
    info.source_gamma = Some(ScaledFloat::new(1.0));
    let first = written(info);
    let reader = Decoder::new(Cursor::new(first.clone())).read_info().unwrap();
    let info = reader.info().clone();
    println!("first file: gAMA {}", has_chunk(&first));
    println!("read: gama_chunk {}, source_gamma {}", info.gama_chunk.is_some(), info.source_gamma.is_some());
    println!("second file: gAMA {}", has_chunk(&written(info)));
}
T
cargo run --release --quiet >said 2>log || { cat log; exit 1; }
cat said
[ "$(tr '\n' ';' <said)" = 'first file: gAMA true;read: gama_chunk true, source_gamma false;second file: gAMA false;' ] \
    || { echo 'changed: gamma is kept, or lost in another way'; exit 1; }
echo 'as described'
