use relief_core::{Volume, Wrap};
use relief_io::{Source, TexelFormat, VolumeFormat, VolumeOptions, read_volume, write_volume};

use super::MAX_BYTES;
use crate::Target;
use crate::common::Folder;

/// Any bytes as a volume's file: an error or as many values from 0 to 1 as its size says, never more memory
/// than allowed.
pub const READ_VOLUME: Target = Target { name: "read_volume", run, make };

fn run(bytes: &[u8]) -> bool {
    let options = VolumeOptions { max_bytes: MAX_BYTES, ..VolumeOptions::default() };
    let Ok(file) = read_volume(Source::bytes("a.ktx2", bytes), &options) else { return false };
    let values = file.volume.values();
    assert_eq!(values.len() as u64, file.volume.layout().voxels());
    assert!(values.iter().all(|value| (0.0..=1.0).contains(value)));
    assert!(file.tile_m.is_none_or(|tile| tile.iter().all(|side| *side > 0.0 && side.is_finite())));
    true
}

fn make() -> Vec<Vec<u8>> {
    let folder = Folder::new();
    let path = folder.path().join("a.ktx2");
    let forms = [
        (TexelFormat::R16, [9, 6, 5], true, Wrap::Repeat),
        (TexelFormat::R16, [4, 3, 7], false, Wrap::Clamp),
        (TexelFormat::R8, [8, 8, 4], false, Wrap::Mirror),
        (TexelFormat::R8, [1, 5, 1], true, Wrap::Repeat),
        (TexelFormat::R32F, [3, 4, 5], false, Wrap::Repeat),
    ];
    let mut write = |(texel, size, zstd, wrap): (TexelFormat, [u32; 3], bool, Wrap)| {
        let slab = Volume::from_fn(size, wrap, |[u, v, h]| 0.4 + 0.3 * (7.0 * u + 3.0 * v).sin() - 0.5 * h);
        let slab = slab.expect("a small volume").with_displacement(0.05, -0.05).expect("metres");
        let format = VolumeFormat { texel, zstd, ..VolumeFormat::default() };
        write_volume(&path, &slab, &format).expect("the temporary folder is writable");
        std::fs::read(&path).expect("it has just been written")
    };
    forms.map(&mut write).into()
}
