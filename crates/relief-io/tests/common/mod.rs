//! Shared parts of the tests: a landscape of heights, files of every format made from it, and
//! broken files.

// Each test binary compiles this module and uses a part of it.
#![allow(dead_code)]

pub mod broken;
pub mod broken_mesh;
pub mod exr_file;
pub mod files;
pub mod gltf_file;
pub mod mesh_file;
pub mod tiff_file;

use std::path::{Path, PathBuf};

use relief_core::HeightMap;
use relief_io::{HeightOptions, Source, read_height};

/// Temporary folder of a test, removed at the end.
pub struct Folder(tempfile::TempDir);

impl Folder {
    pub fn new() -> Self {
        Self(tempfile::tempdir().expect("a temporary folder"))
    }

    pub fn path(&self) -> &Path {
        self.0.path()
    }

    /// Writes a file into it.
    pub fn file(&self, name: &str, bytes: &[u8]) -> PathBuf {
        let path = self.0.path().join(name);
        std::fs::write(&path, bytes).expect("the temporary folder is writable");
        path
    }
}

/// Folder of real data; none, with a message, if it is not set.
pub fn real_data() -> Option<PathBuf> {
    let folder = std::env::var_os("RELIEF_DATA").map(PathBuf::from).filter(|folder| folder.is_dir());
    if folder.is_none() {
        println!("skipped: RELIEF_DATA does not name the folder of real data");
    }
    folder
}

/// A smooth landscape with detail in `0..=1`, defined for every size.
pub fn landscape(width: u32, height: u32) -> impl Fn(u32, u32) -> f64 {
    move |i, j| {
        let (u, v) = ((f64::from(i) + 0.5) / f64::from(width), (f64::from(j) + 0.5) / f64::from(height));
        let hills = (9.0 * u).sin() * (7.0 * v + 1.0).cos() + 0.3 * (31.0 * u * v).sin();
        0.5 + 0.38 * hills
    }
}

/// The samples of [`landscape`], scaled to `0..=maximum`.
pub fn samples(width: u32, height: u32, maximum: f64) -> Vec<f64> {
    let height_at = landscape(width, height);
    let texels = (0..height).flat_map(|j| (0..width).map(move |i| (i, j)));
    texels.map(|(i, j)| (height_at(i, j) * maximum).round()).collect()
}

/// Options that choose a channel.
pub fn channel(name: &str) -> HeightOptions {
    HeightOptions { channel: Some(name.into()), ..HeightOptions::default() }
}

/// A small generator of numbers that is the same everywhere (xorshift64*).
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    /// A number below `limit`.
    pub fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 33) as usize % limit.max(1)
    }
}

/// The size of most files: odd, prime, and no multiple of a block.
pub const SIZE: [u32; 2] = [61, 37];

/// Options as they are.
pub fn default() -> HeightOptions {
    HeightOptions::default()
}

/// Raw values of a map's texels.
fn raw_values(map: &HeightMap) -> Vec<f64> {
    let [zero, one] = map.physical_range().expect("a read map has a range");
    map.texels().iter().map(|&texel| zero + f64::from(texel) * (one - zero)).collect()
}

/// Reads a map from a file and from its bytes, and checks that both are equal.
pub fn read(path: &Path, options: &HeightOptions) -> HeightMap {
    let map = read_height(path, options).unwrap_or_else(|error| panic!("{error}"));
    let bytes = std::fs::read(path).expect("it has just been read");
    let from_bytes = read_height(Source::bytes(path, &bytes), options);
    assert!(from_bytes.is_ok_and(|from_bytes| from_bytes == map), "{}: its bytes differ", path.display());
    map
}

/// Fails unless the file and its bytes are read as the expected raw values.
pub fn assert_reads(path: &Path, options: &HeightOptions, expected: &[f64], tolerance: f64) {
    let map = read(path, options);
    assert_eq!(map.texels().len(), expected.len(), "{}", path.display());
    for (at, (value, expected)) in raw_values(&map).iter().zip(expected).enumerate() {
        assert!(
            (value - expected).abs() <= tolerance,
            "{} texel {at}: {value}, not {expected}",
            path.display()
        );
    }
}
