//! Sets of textures as ambientCG, Poly Haven, Substance, Unreal and Unity name and pack them, out of the
//! sample maps.

use std::fs::File;
use std::path::Path;

use png::{BitDepth, ColorType};

use Part::{
    Color, Height, MaskMap, MetallicSmoothness, Metalness, NormalDown, NormalUp, Occlusion, Orm, Roughness,
};

/// What a texture holds.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Part {
    Color,
    Height,
    /// Normals whose green points along +v of the picture, and along -v.
    NormalUp,
    NormalDown,
    Occlusion,
    Roughness,
    Metalness,
    /// Occlusion, roughness and metalness in red, green and blue.
    Orm,
    /// Metalness, occlusion, nothing and smoothness.
    MaskMap,
    /// Metalness in the colours, smoothness in the opacity.
    MetallicSmoothness,
}

/// A folder of textures.
pub struct Set {
    pub folder: &'static str,
    /// Name of the sample map that it is made of.
    from: &'static str,
    files: &'static [(Part, &'static str)],
}

impl Set {
    /// How many textures are to be taken: of two normal maps one.
    pub fn taken(&self) -> usize {
        let normals = self.files.iter().filter(|(part, _)| matches!(part, NormalUp | NormalDown)).count();
        self.files.len() - normals.saturating_sub(1)
    }
}

pub const SETS: [Set; 10] = [
    Set {
        folder: "ambientcg-bricks",
        from: "bricks",
        files: &[
            (Color, "Bricks001_1K-PNG_Color"),
            (Height, "Bricks001_1K-PNG_Displacement"),
            (NormalUp, "Bricks001_1K-PNG_NormalGL"),
            (NormalDown, "Bricks001_1K-PNG_NormalDX"),
            (Roughness, "Bricks001_1K-PNG_Roughness"),
            (Occlusion, "Bricks001_1K-PNG_AmbientOcclusion"),
        ],
    },
    Set {
        folder: "ambientcg-metal",
        from: "cobbles",
        files: &[
            (Color, "Ground002_2K_Color"),
            (Height, "Ground002_2K_Displacement"),
            (NormalUp, "Ground002_2K_NormalGL"),
            (Roughness, "Ground002_2K_Roughness"),
            (Metalness, "Ground002_2K_Metalness"),
        ],
    },
    Set {
        folder: "polyhaven",
        from: "cobbles",
        files: &[
            (Color, "stone_floor_diff_1k"),
            (Height, "stone_floor_disp_1k"),
            (NormalUp, "stone_floor_nor_gl_1k"),
            (Roughness, "stone_floor_rough_1k"),
            (Occlusion, "stone_floor_ao_1k"),
        ],
    },
    Set {
        folder: "polyhaven-arm",
        from: "bricks",
        files: &[
            (Color, "old_wall_diff_4k"),
            (Height, "old_wall_disp_4k"),
            (NormalDown, "old_wall_nor_dx_4k"),
            (Orm, "old_wall_arm_4k"),
        ],
    },
    Set {
        folder: "substance",
        from: "cobbles",
        files: &[
            (Color, "street_basecolor"),
            (Height, "street_height"),
            (NormalUp, "street_normal"),
            (Roughness, "street_roughness"),
            (Metalness, "street_metallic"),
            (Occlusion, "street_ambientocclusion"),
        ],
    },
    Set {
        folder: "unreal-packed",
        from: "cobbles",
        files: &[
            (Color, "T_Street_BC"),
            (Height, "T_Street_H"),
            (NormalDown, "T_Street_N"),
            (Orm, "T_Street_ORM"),
        ],
    },
    Set {
        folder: "unreal-single",
        from: "bricks",
        files: &[
            (Color, "T_Wall_D"),
            (Height, "T_Wall_H"),
            (NormalDown, "T_Wall_N"),
            (Roughness, "T_Wall_R"),
            (Metalness, "T_Wall_M"),
            (Occlusion, "T_Wall_AO"),
        ],
    },
    Set {
        folder: "unity-hdrp",
        from: "cobbles",
        files: &[
            (Color, "Stones_BaseMap"),
            (Height, "Stones_HeightMap"),
            (NormalUp, "Stones_Normal"),
            (MaskMap, "Stones_MaskMap"),
        ],
    },
    Set {
        folder: "unity-urp",
        from: "bricks",
        files: &[
            (Color, "Wall_AlbedoTransparency"),
            (Height, "Wall_Height"),
            (NormalUp, "Wall_Normal"),
            (MetallicSmoothness, "Wall_MetallicSmoothness"),
            (Occlusion, "Wall_Occlusion"),
        ],
    },
    Set {
        folder: "unity-single",
        from: "cobbles",
        files: &[
            (Color, "Floor_Albedo"),
            (Height, "Floor_Height"),
            (NormalUp, "Floor_Normal"),
            (Occlusion, "Floor_Occlusion"),
        ],
    },
];

/// Metres between the heights 0 and 1, over a tile of 1 m.
const SCALE: f64 = 0.05;

/// Samples of a sample map's parts.
struct Material {
    size: [u32; 2],
    /// Heights of 16 bits, the high byte first.
    heights: Vec<u8>,
    color: Vec<[u8; 3]>,
    /// Occlusion, roughness and metalness.
    orm: Vec<[u8; 3]>,
}

impl Material {
    fn read(name: &str, data: &Path) -> Result<Self, String> {
        let (size, heights, channels) = read(&data.join(format!("{name}.png")))?;
        let texels = (size[0] * size[1]) as usize;
        if heights.len() != 2 * texels || channels != 1 {
            return Err(format!("{name}.png: is not grey of 16 bits"));
        }
        let three = |file: String| -> Result<Vec<[u8; 3]>, String> {
            let (of, samples, channels) = read(&data.join(&file))?;
            if of != size || channels < 3 || samples.len() != texels * channels {
                return Err(format!("{file}: is not of 8 bits, in the size of the heights"));
            }
            Ok(samples.chunks(channels).map(|sample| [sample[0], sample[1], sample[2]]).collect())
        };
        let color = three(format!("{name}_color.png"))?;
        let orm = match data.join(format!("{name}_orm.png")).is_file() {
            true => three(format!("{name}_orm.png"))?,
            // Rough, and darker in the depths.
            false => heights.chunks(2).map(|height| [128 + height[0] / 2, 200, 0]).collect(),
        };
        Ok(Self { size, heights, color, orm })
    }

    fn height(&self, column: u32, row: u32) -> f64 {
        let place = 2 * (row * self.size[0] + column) as usize;
        f64::from(u16::from_be_bytes([self.heights[place], self.heights[place + 1]])) / f64::from(u16::MAX)
    }

    /// Normals by central differences, repeated at the edges. `green` is 1 or -1.
    fn normals(&self, green: f64) -> Vec<u8> {
        let [width, height] = self.size;
        let texel = |at: u32| {
            let (i, j) = (at % width, at / width);
            let between = |[a, b]: [[u32; 2]; 2], texels: u32| {
                (self.height(b[0], b[1]) - self.height(a[0], a[1])) * f64::from(texels) / 2.0 * SCALE
            };
            let along_u = between([[(i + width - 1) % width, j], [(i + 1) % width, j]], width);
            let along_v = between([[i, (j + height - 1) % height], [i, (j + 1) % height]], height);
            let normal = glam::DVec3::new(-along_u, green * along_v, 1.0).normalize();
            normal.to_array().map(|part| ((part + 1.0) * 127.5).round() as u8)
        };
        (0..width * height).flat_map(texel).collect()
    }

    fn samples(&self, part: Part) -> (ColorType, Vec<u8>) {
        let of = |channel: usize| self.orm.iter().map(|orm| orm[channel]).collect();
        let four = |texel: fn([u8; 3]) -> [u8; 4]| self.orm.iter().flat_map(|orm| texel(*orm)).collect();
        match part {
            Color => (ColorType::Rgb, self.color.as_flattened().to_vec()),
            Height => (ColorType::Grayscale, self.heights.clone()),
            NormalUp => (ColorType::Rgb, self.normals(1.0)),
            NormalDown => (ColorType::Rgb, self.normals(-1.0)),
            Occlusion => (ColorType::Grayscale, of(0)),
            Roughness => (ColorType::Grayscale, of(1)),
            Metalness => (ColorType::Grayscale, of(2)),
            Orm => (ColorType::Rgb, self.orm.as_flattened().to_vec()),
            MaskMap => {
                (ColorType::Rgba, four(|[occlusion, rough, metal]| [metal, occlusion, 0, 255 - rough]))
            }
            MetallicSmoothness => {
                (ColorType::Rgba, four(|[_, rough, metal]| [metal, metal, metal, 255 - rough]))
            }
        }
    }
}

/// Writes a set into a folder, which is made.
pub fn write(set: &Set, data: &Path, folder: &Path) -> Result<(), String> {
    let material = Material::read(set.from, data)?;
    std::fs::create_dir(folder).map_err(|error| error.to_string())?;
    for (part, name) in set.files {
        let file = File::create(folder.join(format!("{name}.png"))).map_err(|error| error.to_string())?;
        let (kind, samples) = material.samples(*part);
        let mut encoder = png::Encoder::new(file, material.size[0], material.size[1]);
        encoder.set_color(kind);
        encoder.set_depth(if *part == Height { BitDepth::Sixteen } else { BitDepth::Eight });
        let written = encoder.write_header().and_then(|mut writer| writer.write_image_data(&samples));
        written.map_err(|error| format!("{name}: {error}"))?;
    }
    Ok(())
}

/// The size, the samples and the number of channels of a PNG.
fn read(path: &Path) -> Result<([u32; 2], Vec<u8>, usize), String> {
    let told = |error: String| format!("{}: {error}", path.display());
    let file = File::open(path).map_err(|error| told(error.to_string()))?;
    let mut reader = png::Decoder::new(std::io::BufReader::new(file))
        .read_info()
        .map_err(|error| told(error.to_string()))?;
    let bytes = reader.output_buffer_size().ok_or_else(|| told("too large".to_owned()))?;
    let mut samples = vec![0; bytes];
    let frame = reader.next_frame(&mut samples).map_err(|error| told(error.to_string()))?;
    samples.truncate(frame.buffer_size());
    Ok(([frame.width, frame.height], samples, frame.color_type.samples()))
}
