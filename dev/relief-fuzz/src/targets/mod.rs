//! The targets, one a file.

mod bake;
mod mesh;
mod object;
mod read_height;
mod read_mesh;
mod read_normals;
mod read_picture;
mod read_texture;
mod read_volume;
mod scene;

use crate::Target;

pub use bake::BAKE;
pub use mesh::MESH;
pub use object::OBJECT;
pub use read_height::READ_HEIGHT;
pub use read_mesh::READ_MESH;
pub use read_normals::READ_NORMALS;
pub use read_picture::READ_PICTURE;
pub use read_texture::READ_TEXTURE;
pub use read_volume::READ_VOLUME;
pub use scene::SCENE;

/// All targets. `fuzz/fuzz_targets/` has a file for each.
pub const TARGETS: &[Target] = &[
    READ_HEIGHT,
    READ_NORMALS,
    READ_PICTURE,
    READ_TEXTURE,
    READ_VOLUME,
    READ_MESH,
    OBJECT,
    SCENE,
    BAKE,
    MESH,
];

/// The most memory that a reader may take, in bytes: enough for every small file, and far below the limit of
/// a fuzzer.
const MAX_BYTES: u64 = 64 << 20;

/// A file behind the byte that chooses the options.
fn with_choice(choice: u8, file: &[u8]) -> Vec<u8> {
    [&[choice], file].concat()
}
