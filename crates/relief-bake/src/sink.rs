//! Where baked textures go.

use relief_core::Rounding;

/// A channel of a texture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Channel {
    /// Its name in files, such as `height` or `cone`.
    pub name: &'static str,
    /// The unit of its values: `m`, `heights` for fractions of the relief's depth, `heights/texel`, `tiles`
    /// for texture coordinates, `1` for pure numbers.
    pub unit: &'static str,
    /// The values that 0 and 1 stand for when it is stored as an integer.
    pub range: [f32; 2],
    /// The side to round to when it is stored in fewer bits.
    pub rounding: Rounding,
}

/// The shape of a texture, known before anything is baked.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shape {
    /// Its name after the kind's, for kinds of several textures; empty for the only one.
    pub name: &'static str,
    /// Columns, rows and slices (1 for a 2-D texture) of mip level 0.
    pub size: [u32; 3],
    /// Size of each further mip level; empty without mips.
    pub mips: Vec<[u32; 3]>,
    /// How many channels a texel has.
    pub channels: u32,
}

impl Shape {
    /// A texture of one level with that many slices.
    pub(crate) fn slices(name: &'static str, [width, height]: [u32; 2], slices: u32, channels: u32) -> Self {
        Self { name, size: [width, height, slices], mips: Vec::new(), channels }
    }

    /// Columns, rows and slices of a mip level; 0 is the finest.
    pub fn level_size(&self, level: usize) -> [u32; 3] {
        level_size(self.size, &self.mips, level)
    }

    /// The least columns and rows such that a mip chain of GPUs, where every level has half the sides of the
    /// one before, rounded down, and at least 1, has room for the levels from that one on.
    pub fn chain_size(&self, first: usize) -> [u32; 2] {
        let sizes = (first..=self.mips.len()).map(|level| self.level_size(level)).enumerate();
        sizes.fold([1, 1], |chain, (level, size)| {
            [0, 1].map(|axis| {
                let room = if size[axis] == 1 { 1 } else { size[axis] << level };
                chain[axis].max(room)
            })
        })
    }

    /// Values of all texels.
    pub fn values(&self) -> u64 {
        let of = |size: &[u32; 3]| size.iter().map(|&side| u64::from(side)).product::<u64>();
        (of(&self.size) + self.mips.iter().map(of).sum::<u64>()) * u64::from(self.channels)
    }
}

/// What a texture is, said before its texels.
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    /// Its name after the kind's, for kinds of several textures; empty for the only one.
    pub name: &'static str,
    /// Columns, rows and slices (1 for a 2-D texture) of mip level 0.
    pub size: [u32; 3],
    /// Size of each further mip level; empty without mips.
    pub mips: Vec<[u32; 3]>,
    /// The channels.
    pub channels: Vec<Channel>,
    /// What else a reader must know, as names and values.
    pub notes: Vec<(&'static str, String)>,
}

impl Texture {
    /// Its shape.
    pub fn shape(&self) -> Shape {
        let Self { name, size, mips, channels, .. } = self;
        Shape { name, size: *size, mips: mips.clone(), channels: channels.len() as u32 }
    }

    /// Size of a mip level.
    pub fn level_size(&self, level: usize) -> [u32; 3] {
        level_size(self.size, &self.mips, level)
    }
}

fn level_size(finest: [u32; 3], mips: &[[u32; 3]], level: usize) -> [u32; 3] {
    if level == 0 { finest } else { mips[level - 1] }
}

/// A sink that failed.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub struct SinkError(pub String);

/// Takes textures: first what one is, then its slices in order, level by level from the finest.
pub trait Sink {
    /// A texture begins; its slices follow.
    ///
    /// # Errors
    ///
    /// When the sink cannot take it.
    fn begin(&mut self, texture: &Texture) -> Result<(), SinkError>;

    /// The next slice: for each channel a plane of texels, row by row from the top.
    ///
    /// # Errors
    ///
    /// When the sink cannot take it.
    fn slice(&mut self, planes: &[&[f32]]) -> Result<(), SinkError>;
}

/// A texture in memory.
#[derive(Clone, Debug, PartialEq)]
pub struct CollectedTexture {
    /// What it is.
    pub texture: Texture,
    /// For each mip level and channel its texels, slice after slice, row by row from the top.
    pub levels: Vec<Vec<Vec<f32>>>,
}

/// The sink that keeps everything in memory.
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
