use relief_io::{Ktx2Texture, Metadata, Row, Source, TexelFormat, read_ktx2, read_metadata, write_ktx2};

use super::MAX_BYTES;
use crate::Target;
use crate::common::Folder;

/// Any bytes as a KTX2 file: an error or levels of as many texels as they say, never
/// more memory than allowed.
pub const READ_TEXTURE: Target = Target { name: "read_texture", run, make };

fn run(bytes: &[u8]) -> bool {
    let source = Source::bytes("a.ktx2", bytes);
    let _ = read_metadata(source);
    let Ok(file) = read_ktx2(source, MAX_BYTES) else { return false };
    for level in &file.levels {
        let count = level.size.iter().map(|&side| side as usize).product::<usize>();
        assert!(level.planes.iter().all(|plane| plane.len() == count));
    }
    true
}

fn make() -> Vec<Vec<u8>> {
    let folder = Folder::new();
    let path = folder.path().join("a.ktx2");
    let mut fill = |row: Row, texels: &mut [f32]| {
        for (column, texel) in texels.iter_mut().enumerate() {
            *texel = ((column as u32 * 331 + row.row * 101 + row.channel as u32 * 17) % 256) as f32 / 255.0;
        }
        Ok(())
    };
    let formats = [
        (TexelFormat::R8, [9, 6, 1], 1, false),
        (TexelFormat::Rgba8, [8, 8, 1], 4, true),
        (TexelFormat::R16, [5, 7, 3], 1, true),
        (TexelFormat::Rgba16F, [4, 4, 1], 3, false),
        (TexelFormat::R32F, [9, 6, 1], 1, true),
        (TexelFormat::Bc4, [8, 8, 1], 4, false),
        (TexelFormat::Bc7, [8, 4, 1], 1, true),
    ];
    let mut write = |(format, size, levels, zstd): (TexelFormat, [u32; 3], u32, bool)| {
        let metadata = Metadata::new(vec![("relief.kind".into(), "cone".into())]).expect("one name");
        let texture = Ktx2Texture { format, size, levels, channels: format.channels(), zstd, metadata };
        write_ktx2(&path, &texture, &mut fill).expect("the temporary folder is writable");
        std::fs::read(&path).expect("it has just been written")
    };
    formats.map(&mut write).into()
}
