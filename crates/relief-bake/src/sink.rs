//! Sinks, which receive baked textures, and the textures' shapes.

use relief_core::Rounding;

/// A channel of a texture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Channel {
    /// Name in files, such as `height` or `cone`.
    pub name: &'static str,
    /// Unit of its values: `m`, `heights` for fractions of the relief's depth, `heights/texel`,
    /// `tiles` for texture coordinates, `1` for pure numbers.
    pub unit: &'static str,
    /// Values that 0 and 1 stand for when the channel is stored as integers.
    pub range: [f32; 2],
    /// Side to round to when the channel is stored in fewer bits.
    pub rounding: Rounding,
}

/// The shape of a texture, known before anything is baked.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shape {
    /// Name after the kind's, for kinds of several textures; empty for the only one.
    pub name: &'static str,
    /// Columns, rows and slices (1 for a 2-D texture) of mip level 0.
    pub size: [u32; 3],
    /// Size of each further mip level; empty without mips.
    pub mips: Vec<[u32; 3]>,
    /// Channels of a texel.
    pub channels: u32,
}

impl Shape {
    /// Creates the shape of a texture of one level with `slices` slices.
    pub(crate) fn slices(name: &'static str, [width, height]: [u32; 2], slices: u32, channels: u32) -> Self {
        Self { name, size: [width, height, slices], mips: Vec::new(), channels }
    }

    /// Returns columns, rows and slices of a mip level; 0 is the finest.
    pub fn level_size(&self, level: usize) -> [u32; 3] {
        level_size(self.size, &self.mips, level)
    }

    /// Returns the least size of a GPU mip chain that has room for the levels from `first` on. In
    /// such a chain, each level has half the sides of the previous one, rounded down, and at least
    /// 1.
    pub fn chain_size(&self, first: usize) -> [u32; 2] {
        let sizes = (first..=self.mips.len()).map(|level| self.level_size(level)).enumerate();
        sizes.fold([1, 1], |chain, (level, size)| {
            [0, 1].map(|axis| {
                let room = if size[axis] == 1 { 1 } else { size[axis] << level };
                chain[axis].max(room)
            })
        })
    }

    /// Returns the number of values of all levels, texels and channels.
    pub fn values(&self) -> u64 {
        let of = |size: &[u32; 3]| size.iter().map(|&side| u64::from(side)).product::<u64>();
        (of(&self.size) + self.mips.iter().map(of).sum::<u64>()) * u64::from(self.channels)
    }
}

/// Description of a texture, sent before its texels.
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    /// Name after the kind's, for kinds of several textures; empty for the only one.
    pub name: &'static str,
    /// Columns, rows and slices (1 for a 2-D texture) of mip level 0.
    pub size: [u32; 3],
    /// Size of each further mip level; empty without mips.
    pub mips: Vec<[u32; 3]>,
    /// The channels.
    pub channels: Vec<Channel>,
    /// Further facts for readers, as names and values.
    pub notes: Vec<(&'static str, String)>,
}

impl Texture {
    /// Returns the texture's shape.
    pub fn shape(&self) -> Shape {
        let Self { name, size, mips, channels, .. } = self;
        Shape { name, size: *size, mips: mips.clone(), channels: channels.len() as u32 }
    }

    /// Returns the size of a mip level; 0 is the finest.
    pub fn level_size(&self, level: usize) -> [u32; 3] {
        level_size(self.size, &self.mips, level)
    }
}

fn level_size(finest: [u32; 3], mips: &[[u32; 3]], level: usize) -> [u32; 3] {
    if level == 0 { finest } else { mips[level - 1] }
}

/// Reason why a sink failed.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub struct SinkError(pub String);

/// Receives textures: first a description, then the slices in order, level by level from the
/// finest.
pub trait Sink {
    /// Begins a texture; its slices follow.
    ///
    /// # Errors
    ///
    /// Fails when the sink cannot take the texture.
    fn begin(&mut self, texture: &Texture) -> Result<(), SinkError>;

    /// Takes the next slice: for each channel a plane of texels, row by row from the top.
    ///
    /// # Errors
    ///
    /// Fails when the sink cannot take the slice.
    fn slice(&mut self, planes: &[&[f32]]) -> Result<(), SinkError>;
}

/// A texture in memory.
#[derive(Clone, Debug, PartialEq)]
pub struct CollectedTexture {
    /// Description of the texture.
    pub texture: Texture,
    /// Texels of each mip level and channel, slice after slice, row by row from the top.
    pub levels: Vec<Vec<Vec<f32>>>,
}

/// Sink that keeps everything in memory.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Collected {
    /// The textures, in the order in which they were baked.
    pub textures: Vec<CollectedTexture>,
}

impl Sink for Collected {
    fn begin(&mut self, texture: &Texture) -> Result<(), SinkError> {
        let empty = vec![Vec::new(); texture.channels.len()];
        self.textures
            .push(CollectedTexture { texture: texture.clone(), levels: vec![empty; texture.mips.len() + 1] });
        Ok(())
    }

    fn slice(&mut self, planes: &[&[f32]]) -> Result<(), SinkError> {
        let last =
            self.textures.last_mut().ok_or_else(|| SinkError("a slice before its texture".to_owned()))?;
        let CollectedTexture { texture, levels } = last;
        let unfinished = levels.iter_mut().enumerate().find(|(level, channels)| {
            let texels: usize = texture.level_size(*level).iter().map(|&side| side as usize).product();
            channels.iter().any(|channel| channel.len() < texels)
        });
        let (_, channels) = unfinished.ok_or_else(|| SinkError("more slices than announced".to_owned()))?;
        for (channel, plane) in channels.iter_mut().zip(planes) {
            channel.extend_from_slice(plane);
        }
        Ok(())
    }
}
