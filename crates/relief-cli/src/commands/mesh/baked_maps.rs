//! Maps of the relief that are baked into the written mesh: normals and occlusion.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use clap::ValueEnum;
use relief_bake::{BakeError, Collected, bake, kind};
use relief_core::{ByteSize, Watch};
use relief_io::{MeshMaterial, NormalTexture, OcclusionTexture, Picture};
use relief_mesh::Shading;
use relief_scene::Surface;

use super::{Arguments, Materials};
use crate::failure::Failure;
use crate::interrupt::cancelled;
use crate::progress::Progress;

/// Bytes per texel while a map is baked and written: planes, the picture, and its file.
const BYTES_PER_TEXEL: u64 = 12 + 16 + 4 + 12;

/// Map that is baked into the mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum MeshMap {
    /// Normals in tangent space, green up.
    Normal,
    /// Part of the light from all around that arrives.
    Occlusion,
}

impl MeshMap {
    /// Name of the kind of baked map.
    fn kind(self) -> &'static str {
        match self {
            MeshMap::Normal => "normal",
            MeshMap::Occlusion => "occlusion",
        }
    }
}

/// Returns the vertices' normals that go with the maps.
pub fn shading(maps: &[MeshMap]) -> Shading {
    if maps.contains(&MeshMap::Normal) { Shading::Base } else { Shading::default() }
}

/// Bakes the maps that are asked for into the materials, or into a grey one if there are none.
pub fn baked(
    arguments: &Arguments,
    surface: &Surface,
    materials: Option<Materials>,
    cancel: &AtomicBool,
) -> Result<Option<Materials>, Failure> {
    if arguments.maps.is_empty() {
        return Ok(materials);
    }
    let map = surface.height_map();
    let needed = BYTES_PER_TEXEL * u64::from(map.width()) * u64::from(map.height());
    if needed > arguments.limit() {
        let (needed, limit) = (ByteSize(needed), ByteSize(arguments.limit()));
        return Err(Failure::Work(format!(
            "--maps: they take {needed} to bake, more than the {limit} allowed: --max-memory raises the limit"
        )));
    }
    let grey = || MeshMaterial { factor: [0.5, 0.5, 0.5, 1.0], ..MeshMaterial::default() };
    let (mut materials, of_base) = materials.unwrap_or_else(|| (vec![grey()], Vec::new()));
    let wrap = [map.wrap(); 2];
    for which in [MeshMap::Normal, MeshMap::Occlusion] {
        if !arguments.maps.contains(&which) {
            continue;
        }
        let picture = Arc::new(picture(which, surface, arguments.json, cancel)?);
        for material in &mut materials {
            let textures = &mut material.values.textures;
            match which {
                MeshMap::Normal => {
                    textures.normal = Some(NormalTexture { picture: Arc::clone(&picture), scale: 1.0, wrap });
                }
                MeshMap::Occlusion => {
                    textures.occlusion = None;
                    let has_others = material.has_placed_pictures();
                    let lies = material.transform == MeshMaterial::IDENTITY && material.wrap == wrap;
                    if has_others && !lies {
                        return Err(Failure::Work(
                            "--maps occlusion: the pictures of the mesh's material lie otherwise than the \
                             height map, and its occlusion would lie as they do: leave occlusion out"
                                .to_owned(),
                        ));
                    }
                    material.wrap = wrap;
                    let occlusion = OcclusionTexture { picture: Arc::clone(&picture), strength: 1.0 };
                    material.values.textures.occlusion = Some(occlusion);
                }
            }
        }
    }
    Ok(Some((materials, of_base)))
}

/// Bakes a map as a picture of 8 bits a channel.
fn picture(which: MeshMap, surface: &Surface, quiet: bool, cancel: &AtomicBool) -> Result<Picture, Failure> {
    let kind = kind(which.kind()).map_err(Failure::work)?;
    let mut settings = kind.defaults();
    if which == MeshMap::Normal {
        settings.set("mips", 0.0).map_err(Failure::work)?;
    }
    let bar = Progress::bar("baking", quiet);
    let tell = |_: &str, part: f32| bar.show(part);
    let watch = Watch::new(&tell, cancel);
    let mut baked = Collected::default();
    let map = surface.height_map();
    bake(kind, map, surface.metric(), &settings, &watch, &mut baked).map_err(|error| match error {
        BakeError::Cancelled(_) => cancelled(),
        error => Failure::work(error),
    })?;
    let planes = baked.textures.first().and_then(|texture| texture.levels.first());
    let planes = planes.map(Vec::as_slice).unwrap_or_default();
    let code = |part: f32| (255.0 * part.clamp(0.0, 1.0)).round() / 255.0;
    let texel = |at: usize| match (which, planes) {
        (MeshMap::Normal, [x, y, z, ..]) => {
            let [x, y, z] = [x, y, z].map(|plane| code(0.5 + 0.5 * plane[at]));
            [x, y, z, 1.0]
        }
        (_, [part, ..]) => {
            let part = code(part[at]);
            [part, part, part, 1.0]
        }
        _ => [1.0; 4],
    };
    let (width, height) = (map.width(), map.height());
    Ok(Picture { width, height, texels: (0..map.texels().len()).map(texel).collect() })
}
