//! Maps of materials: occlusion, roughness, metalness and emission.

use relief_core::{ByteSize, Wrap};
use relief_io::Picture;

/// Number of kinds of material maps.
const KINDS: usize = 8;

/// A picture for each kind of material map, in the order of [`MaterialMap::ALL`].
pub type MaterialPictures = [Option<Picture>; KINDS];

/// Kind of a material map. Its value is its place in [`MaterialMap::ALL`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MaterialMap {
    /// Occlusion, roughness and metalness in red, green and blue, which engines call ORM or ARM.
    Packed,
    /// Metalness in red, occlusion in green and smoothness, 1 less the roughness, in opacity: the mask
    /// map of Unity's HDRP.
    Mask,
    /// Metalness in red and smoothness in opacity, as in Unity's standard material.
    MetallicSmoothness,
    /// Part of the light from all around that arrives, from 0 to 1, in red.
    Occlusion,
    /// Roughness from 0 to 1, in red.
    Roughness,
    /// Glossiness or smoothness from 0 to 1, in red: 1 less the roughness.
    Glossiness,
    /// Metalness from 0 to 1, in red.
    Metallic,
    /// Light that the surface gives by itself, linear red, green and blue, at least 0.
    Emission,
}

/// Reason why a picture cannot be a material map.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MaterialMapError {
    /// A texel is out of range.
    #[error("texel {column}, {row} is {value}: {must}")]
    OutOfRange {
        /// Column of the texel.
        column: u32,
        /// Row of the texel.
        row: u32,
        /// Its value.
        value: f32,
        /// The range.
        must: &'static str,
    },
    /// The number of texels does not fit the sides, or a side is 0.
    #[error("the picture has {texels} texels, and its sides are {width} x {height}")]
    WrongLength {
        /// Columns.
        width: u32,
        /// Rows.
        height: u32,
        /// Texels.
        texels: usize,
    },
    /// The maps need more memory than is left.
    #[error(
        "the material maps need {needed}, and {left} are left of the limit: use smaller maps or raise it"
    )]
    Memory {
        /// Bytes needed.
        needed: ByteSize,
        /// Bytes left.
        left: ByteSize,
    },
}

impl MaterialMap {
    /// All kinds.
    pub const ALL: [Self; KINDS] = [
        Self::Packed,
        Self::Mask,
        Self::MetallicSmoothness,
        Self::Occlusion,
        Self::Roughness,
        Self::Glossiness,
        Self::Metallic,
        Self::Emission,
    ];

    /// Channels of the picture, the parts of a texel of [`MaterialMaps`] that they give, and whether a
    /// part is 1 less the channel.
    const fn channels(self) -> &'static [(usize, usize, bool)] {
        match self {
            Self::Packed => &[(0, 0, false), (1, 1, false), (2, 2, false)],
            Self::Mask => &[(0, 2, false), (1, 0, false), (3, 1, true)],
            Self::MetallicSmoothness => &[(0, 2, false), (3, 1, true)],
            Self::Occlusion => &[(0, 0, false)],
            Self::Roughness => &[(0, 1, false)],
            Self::Glossiness => &[(0, 1, true)],
            Self::Metallic => &[(0, 2, false)],
            Self::Emission => &[(0, 4, false), (1, 5, false), (2, 6, false)],
        }
    }

    /// Checks a picture of this kind.
    fn check(self, picture: &Picture) -> Result<(), MaterialMapError> {
        let &Picture { width, height, ref texels } = picture;
        let count = u64::from(width) * u64::from(height);
        if count == 0 || count != texels.len() as u64 {
            return Err(MaterialMapError::WrongLength { width, height, texels: texels.len() });
        }
        let (most, must) = match self {
            Self::Emission => (f32::MAX, "light must be at least 0"),
            _ => (1.0, "it must be from 0 to 1"),
        };
        for (place, texel) in texels.iter().enumerate() {
            let values = self.channels().iter().map(|(channel, ..)| texel[*channel]);
            if let Some(value) = values.into_iter().find(|value| !(0.0..=most).contains(value)) {
                let [column, row] = [place as u32 % width, place as u32 / width];
                return Err(MaterialMapError::OutOfRange { column, row, value, must });
            }
        }
        Ok(())
    }
}

/// Maps of a material, one beside the other.
///
/// All have the sides of the largest picture. Smaller ones are interpolated between the centres of
/// their texels. Values of maps that are not given are 1.
///
/// # Examples
///
/// ```
/// use relief_core::Wrap;
/// use relief_io::Picture;
/// use relief_scene::material_maps::{MaterialMap, MaterialMaps, MaterialPictures};
///
/// let worn = Picture { width: 2, height: 1, texels: vec![[0.2; 4], [0.9; 4]] };
/// let mut pictures = MaterialPictures::default();
/// pictures[MaterialMap::Roughness as usize] = Some(worn);
/// let maps = MaterialMaps::new(&pictures, Wrap::Repeat).map_err(|(_, error)| error)?;
/// assert_eq!((maps.size(), maps.has_emission()), ([2, 1], false));
/// assert_eq!(maps.texels()[0], [1.0, 0.2, 1.0, 0.0, 1.0, 1.0, 1.0, 0.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialMaps {
    size: [u32; 2],
    has_surface: bool,
    has_emission: bool,
    texels: Vec<[f32; 8]>,
}

impl MaterialMaps {
    /// Bytes per texel: of this, and of what renderers make of it, with coarser levels.
    pub const BYTES_PER_TEXEL: u64 = 32 + 43;

    /// Combines pictures, in the order of [`MaterialMap::ALL`]. Later ones replace channels of earlier
    /// ones, so a map of its own goes before a packed one. `wrap` continues smaller pictures beyond their
    /// edges.
    ///
    /// # Errors
    ///
    /// When a picture's texels do not fit its sides, or a value is out of its kind's range. The error
    /// names the kind.
    pub fn new(pictures: &MaterialPictures, wrap: Wrap) -> Result<Self, (MaterialMap, MaterialMapError)> {
        let given =
            || MaterialMap::ALL.into_iter().zip(pictures).filter_map(|(kind, of)| Some((kind, of.as_ref()?)));
        for (kind, picture) in given() {
            kind.check(picture).map_err(|error| (kind, error))?;
        }
        let size = Self::size_of(pictures);
        let white = [1.0, 1.0, 1.0, 0.0];
        let mut texels = vec![[0.0; 8]; size[0] as usize * size[1] as usize];
        for texel in &mut texels {
            texel[..4].copy_from_slice(&white);
            texel[4..].copy_from_slice(&white);
        }
        for (kind, picture) in given() {
            let [columns, rows] = [(size[0], picture.width), (size[1], picture.height)]
                .map(|(to, from)| places(to, from, wrap));
            for (row, texels) in rows.iter().zip(texels.chunks_exact_mut(columns.len())) {
                for (column, texel) in columns.iter().zip(texels) {
                    let at =
                        |row: usize, column: usize| picture.texels[row * picture.width as usize + column];
                    let corners = [
                        [at(row.first, column.first), at(row.first, column.second)],
                        [at(row.second, column.first), at(row.second, column.second)],
                    ];
                    for &(channel, part, is_inverted) in kind.channels() {
                        let between =
                            |[a, b]: [[f32; 4]; 2]| a[channel] + (b[channel] - a[channel]) * column.part;
                        let [upper, lower] = corners.map(between);
                        let value = upper + (lower - upper) * row.part;
                        texel[part] = if is_inverted { 1.0 - value } else { value };
                    }
                }
            }
        }
        let has = |of: &dyn Fn(MaterialMap) -> bool| given().any(|(kind, _)| of(kind));
        let has_emission = has(&|kind| kind == MaterialMap::Emission);
        let has_surface = has(&|kind| kind != MaterialMap::Emission);
        Ok(Self { size, has_surface, has_emission, texels })
    }

    /// Returns the columns and rows that maps of these pictures have: the most of all. 1 without
    /// pictures.
    pub fn size_of(pictures: &MaterialPictures) -> [u32; 2] {
        let largest = |[width, height]: [u32; 2], picture: &Picture| {
            [width.max(picture.width), height.max(picture.height)]
        };
        pictures.iter().flatten().fold([1, 1], largest)
    }

    /// Returns columns and rows.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Returns the texels, row by row from the top: occlusion, roughness, metalness, 0, then
    /// emission in red, green and blue, 0.
    pub fn texels(&self) -> &[[f32; 8]] {
        &self.texels
    }

    /// Whether there is a map of occlusion, roughness or metalness.
    pub fn has_surface(&self) -> bool {
        self.has_surface
    }

    /// Whether there is a map of emission.
    pub fn has_emission(&self) -> bool {
        self.has_emission
    }
}

/// Place between two texels of a row.
struct Place {
    first: usize,
    second: usize,
    /// Weight of the second.
    part: f32,
}

/// Returns the places of the centres of `to` texels in a row of `from` texels.
fn places(to: u32, from: u32, wrap: Wrap) -> Vec<Place> {
    let place = |at: u32| {
        let point = (f64::from(at) + 0.5) * f64::from(from) / f64::from(to) - 0.5;
        let first = point.floor();
        let index = |at: f64| wrap.index(at as i64, from) as usize;
        Place { first: index(first), second: index(first + 1.0), part: (point - first) as f32 }
    };
    (0..to).map(place).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(width: u32, height: u32, texels: &[[f32; 4]]) -> Picture {
        Picture { width, height, texels: texels.to_vec() }
    }

    #[test]
    fn smaller_maps_are_interpolated_and_single_ones_go_first() {
        let packed =
            picture(4, 1, &[[0.1, 0.2, 0.3, 1.0], [0.5, 0.6, 0.7, 1.0], [0.1, 0.2, 0.3, 1.0], [0.0; 4]]);
        let rough = picture(2, 1, &[[0.0; 4], [1.0; 4]]);
        let mut pictures = MaterialPictures::default();
        pictures[MaterialMap::Packed as usize] = Some(packed);
        pictures[MaterialMap::Roughness as usize] = Some(rough);
        let part = |wrap, channel: usize| {
            let maps = MaterialMaps::new(&pictures, wrap).expect("maps");
            maps.texels().iter().map(|texel| texel[channel]).collect::<Vec<_>>()
        };
        assert_eq!(part(Wrap::Repeat, 1), [0.25, 0.25, 0.75, 0.75]);
        assert_eq!(part(Wrap::Clamp, 1), [0.0, 0.25, 0.75, 1.0]);
        assert_eq!(part(Wrap::Clamp, 2), [0.3, 0.7, 0.3, 0.0]);
        assert_eq!(part(Wrap::Clamp, 4), [1.0; 4]);
    }

    #[test]
    fn smoothness_is_1_less_the_roughness() {
        for (kind, right) in [
            (MaterialMap::Mask, [0.5, 0.25, 0.125]),
            (MaterialMap::MetallicSmoothness, [1.0, 0.25, 0.125]),
            (MaterialMap::Glossiness, [1.0, 0.875, 1.0]),
            (MaterialMap::Packed, [0.125, 0.5, 0.0]),
        ] {
            let mut pictures = MaterialPictures::default();
            pictures[kind as usize] = Some(picture(1, 1, &[[0.125, 0.5, 0.0, 0.75]]));
            let maps = MaterialMaps::new(&pictures, Wrap::Repeat).expect("maps");
            assert_eq!(maps.texels()[0][..3], right, "{kind:?}");
        }
    }

    #[test]
    fn texels_out_of_range_are_named() {
        for (kind, value) in
            [(MaterialMap::Roughness, 1.5), (MaterialMap::Emission, -0.5), (MaterialMap::Packed, f32::NAN)]
        {
            let mut pictures = MaterialPictures::default();
            pictures[kind as usize] = Some(picture(2, 1, &[[0.5; 4], [value; 4]]));
            let error = MaterialMaps::new(&pictures, Wrap::Repeat).expect_err("a value out of range");
            assert!(matches!(error, (of, MaterialMapError::OutOfRange { column: 1, .. }) if of == kind));
        }
        let mut pictures = MaterialPictures::default();
        pictures[MaterialMap::Emission as usize] = Some(picture(2, 2, &[[0.5; 4]]));
        let error = MaterialMaps::new(&pictures, Wrap::Repeat).expect_err("missing texels");
        assert!(matches!(error.1, MaterialMapError::WrongLength { texels: 1, .. }));
    }
}
