//! Storage of texels: the choice of bits, and rounding to the side that keeps a map's guarantee.

use clap::ValueEnum;
use relief_bake::view_dependent::FACTORS;
use relief_bake::{Channel, Texture};
use relief_core::Rounding;
use relief_core::encoding::half;
use relief_io::TexelFormat;

/// File format of baked maps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum FileFormat {
    /// 32-bit floats in named channels; volumes as slices below each other
    Exr,
    /// 8 or 16-bit integers, up to four channels a file
    Png,
    /// Textures for GPUs: mip chains, volumes, up to four channels a file
    Ktx2,
}

impl FileFormat {
    /// All formats.
    pub const ALL: [FileFormat; 3] = [FileFormat::Exr, FileFormat::Png, FileFormat::Ktx2];

    /// Returns the ending of files' names.
    pub const fn extension(self) -> &'static str {
        match self {
            FileFormat::Exr => "exr",
            FileFormat::Png => "png",
            FileFormat::Ktx2 => "ktx2",
        }
    }

    /// Returns the most channels of a file.
    pub const fn channels(self) -> usize {
        match self {
            FileFormat::Exr => usize::MAX,
            FileFormat::Png | FileFormat::Ktx2 => 4,
        }
    }
}

/// Storage of values, as asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum TexelChoice {
    /// By the kind's `bits`: integers with as many bits, floats for 0; 16 bits in PNG
    Auto,
    /// 32-bit floats
    Float,
    /// 16-bit floats (KTX2)
    Half,
    /// 16-bit integers
    Unorm16,
    /// 8-bit integers
    Unorm8,
    /// Blocks of 4x4 texels (KTX2): BC4 for one channel, BC5 for two, BC7 for more
    Bc,
}

/// Storage of values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Storage {
    /// 32-bit floats.
    Float,
    /// 16-bit floats.
    Half,
    /// Unsigned normalised integers.
    Unorm {
        /// 8 or 16.
        bits: u32,
    },
    /// BC4, BC5 or BC7.
    Block,
}

/// Storage of a bake's files.
#[derive(Clone, Copy)]
pub struct Packing {
    /// File format.
    pub format: FileFormat,
    /// Storage of the texels.
    pub storage: Storage,
    /// Whether KTX2 levels are compressed.
    pub zstd: bool,
}

impl Storage {
    /// Returns the storage that a choice means for a format and a kind's `bits`.
    ///
    /// # Errors
    ///
    /// When the format has no such texels.
    pub fn choose(choice: TexelChoice, format: FileFormat, bits: u32) -> Result<Self, String> {
        let name = format.extension();
        match (choice, format) {
            (TexelChoice::Auto | TexelChoice::Float, FileFormat::Exr) => Ok(Storage::Float),
            (TexelChoice::Auto, FileFormat::Png) if (1..=8).contains(&bits) => Ok(Storage::Unorm { bits: 8 }),
            (TexelChoice::Auto, FileFormat::Png) => Ok(Storage::Unorm { bits: 16 }),
            (TexelChoice::Auto, FileFormat::Ktx2) => Ok(match bits {
                0 => Storage::Float,
                1..=8 => Storage::Unorm { bits: 8 },
                _ => Storage::Unorm { bits: 16 },
            }),
            (TexelChoice::Float, FileFormat::Ktx2) => Ok(Storage::Float),
            (TexelChoice::Half, FileFormat::Ktx2) => Ok(Storage::Half),
            (TexelChoice::Unorm8, FileFormat::Png | FileFormat::Ktx2) => Ok(Storage::Unorm { bits: 8 }),
            (TexelChoice::Unorm16, FileFormat::Png | FileFormat::Ktx2) => Ok(Storage::Unorm { bits: 16 }),
            (TexelChoice::Bc, FileFormat::Ktx2) => Ok(Storage::Block),
            (_, FileFormat::Exr) => Err(format!("{name} files hold 32-bit floats only: leave --texels out")),
            (_, FileFormat::Png) => Err(format!(
                "{name} files hold integers only: use --texels unorm8 or unorm16, or --format ktx2"
            )),
        }
    }

    /// Returns its name in metadata.
    pub const fn name(self) -> &'static str {
        match self {
            Storage::Float => "float32",
            Storage::Half => "float16",
            Storage::Unorm { bits: 8 } => "unorm8",
            Storage::Unorm { .. } => "unorm16",
            Storage::Block => "block-compressed unorm8",
        }
    }

    /// Whether stored texels are fractions of the channel's range.
    pub const fn is_normalised(self) -> bool {
        matches!(self, Storage::Unorm { .. } | Storage::Block)
    }

    /// Returns the texel format of a KTX2 file with `channels` channels.
    pub const fn ktx2(self, channels: usize) -> TexelFormat {
        match (self, channels) {
            (Storage::Float, 0 | 1) => TexelFormat::R32F,
            (Storage::Float, 2) => TexelFormat::Rg32F,
            (Storage::Float, _) => TexelFormat::Rgba32F,
            (Storage::Half, 0 | 1) => TexelFormat::R16F,
            (Storage::Half, 2) => TexelFormat::Rg16F,
            (Storage::Half, _) => TexelFormat::Rgba16F,
            (Storage::Unorm { bits: 8 }, 0 | 1) => TexelFormat::R8,
            (Storage::Unorm { bits: 8 }, 2) => TexelFormat::Rg8,
            (Storage::Unorm { bits: 8 }, _) => TexelFormat::Rgba8,
            (Storage::Unorm { .. }, 0 | 1) => TexelFormat::R16,
            (Storage::Unorm { .. }, 2) => TexelFormat::Rg16,
            (Storage::Unorm { .. }, _) => TexelFormat::Rgba16,
            (Storage::Block, 0 | 1) => TexelFormat::Bc4,
            (Storage::Block, 2) => TexelFormat::Bc5,
            (Storage::Block, _) => TexelFormat::Bc7,
        }
    }

    /// Checks that a texture can be stored like this; `lossy_heights` allows heights in blocks.
    ///
    /// # Errors
    ///
    /// When it cannot; the text says what to do.
    pub fn check(self, format: FileFormat, texture: &Texture, lossy_heights: bool) -> Result<(), String> {
        self.check_depth(format, texture.size[2])?;
        self.check_channels(&texture.channels, lossy_heights)
    }

    /// Checks that textures with `slices` slices can be stored like this.
    ///
    /// # Errors
    ///
    /// When they cannot; the text says what to do.
    pub fn check_depth(self, format: FileFormat, slices: u32) -> Result<(), String> {
        if slices > 1 && format == FileFormat::Png {
            return Err("a PNG file cannot hold a volume: use --format ktx2 or exr".to_owned());
        }
        if slices > 1 && self == Storage::Block {
            return Err("block-compressed texels cannot hold a volume: leave --texels bc out".to_owned());
        }
        Ok(())
    }

    fn check_channels(self, channels: &[Channel], lossy_heights: bool) -> Result<(), String> {
        if self != Storage::Block {
            return Ok(());
        }
        for Channel { name, rounding, .. } in channels {
            if *rounding != Rounding::Nearest {
                return Err(format!(
                    "block compression would break the guarantee of the channel '{name}', whose values may \
                     only be rounded to one side: leave --texels bc out"
                ));
            }
            if name.starts_with(FACTORS) {
                return Err(
                    "block compression would change the scales of a compressed map's products: leave \
                     --texels bc out"
                        .to_owned(),
                );
            }
            if name.contains("height") && !lossy_heights {
                return Err(format!(
                    "block compression keeps 8 levels per block of the channel '{name}', between ends of 8 \
                     bits: give --lossy-heights if another copy of the heights exists"
                ));
            }
        }
        Ok(())
    }

    /// Returns the number that a writer stores for `value`: a fraction of the channel's range if
    /// texels are normalised. A reader computes `range[0] + texel * (range[1] - range[0])` in
    /// `f32`, which lies on the channel's safe side.
    ///
    /// # Errors
    ///
    /// When no stored value lies on that side.
    pub fn texel(self, value: f32, channel: &Channel) -> Result<f32, String> {
        let texel = match self {
            Storage::Float => Some(value),
            Storage::Half => half_texel(value, channel.rounding),
            Storage::Unorm { bits } => unorm_texel(value, channel, (1 << bits) - 1),
            Storage::Block => unorm_texel(value, channel, 255),
        };
        texel.ok_or_else(|| {
            let [least, most] = channel.range;
            format!(
                "the channel '{}' has a value of {value}, which {} cannot hold (range {least} to {most}): \
                 use floats, with --format exr, or ktx2 with --texels float",
                channel.name,
                self.name()
            )
        })
    }
}

fn half_texel(value: f32, rounding: Rounding) -> Option<f32> {
    let stored = half::round(value, rounding);
    // A finite value must not become infinite.
    (!value.is_nan() && (stored.is_finite() || value.is_infinite())).then_some(stored)
}

fn unorm_texel(value: f32, channel: &Channel, most: u32) -> Option<f32> {
    let [zero, one] = channel.range;
    let decode = |code: u32| zero + (f64::from(code) / f64::from(most)) as f32 * (one - zero);
    let exact = (f64::from(value) - f64::from(zero)) / (f64::from(one) - f64::from(zero)) * f64::from(most);
    if exact.is_nan() {
        return None;
    }
    // Codes are tried from the far side of the neighbouring one, since decoding also rounds.
    let code = match channel.rounding {
        Rounding::Nearest => {
            let slack = 1e-3;
            let inside = (-slack..=f64::from(most) + slack).contains(&exact);
            inside.then(|| exact.round().clamp(0.0, f64::from(most)) as u32)
        }
        Rounding::Down => {
            let start = (exact + 1.0).floor().clamp(0.0, f64::from(most)) as u32;
            (start.saturating_sub(3)..=start).rev().find(|&code| decode(code) <= value)
        }
        Rounding::Up => {
            let start = (exact - 1.0).ceil().clamp(0.0, f64::from(most)) as u32;
            (start..=most.min(start + 3)).find(|&code| decode(code) >= value)
        }
    };
    code.map(|code| (f64::from(code) / f64::from(most)) as f32)
}
