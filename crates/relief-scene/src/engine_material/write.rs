//! Writing of the textures of a material for an engine.

use std::io;
use std::path::Path;

use relief_core::{ByteSize, Watch};
use relief_io::{
    Convention, Curve, EngineTexture, GreenSign, Metadata, NormalVectors, Picture, PngTexture, Row, SHORTEST,
    SurfaceChannel, TextureContent, TextureRole, linear_to_srgb, read_normal_vectors, read_picture,
    read_picture_as, write_png_colours, write_png_rows,
};

use super::{EngineMaterial, EngineMaterialError, WrittenFacts};
use crate::material_maps::{MaterialMap, MaterialMapError, MaterialMaps, MaterialPictures};

/// Roughness of a surface without a map of it, as in glTF's and Relief's default material.
const ROUGHNESS: f32 = 0.5;

/// Bytes of a texel of a picture that has been read.
const PICTURE_BYTES: u64 = 16;

/// Texels of a texture: a value for each texel and channel.
struct Texels<'a> {
    size: [u32; 2],
    channels: usize,
    value: Box<dyn Fn(usize, usize) -> f32 + 'a>,
}

impl EngineMaterial<'_> {
    /// Writes a texture into a file at `path`. `normals` are the normals of the heights, with green
    /// up: the planes of `x`, `y` and `z`. They are needed where the set has no normal map.
    ///
    /// # Errors
    ///
    /// When a picture of the set cannot be read or holds values out of range, when the file cannot
    /// be written, or when the work is cancelled.
    pub fn write(
        &self,
        texture: &EngineTexture,
        normals: Option<[&[f32]; 3]>,
        path: &Path,
        metadata: &Metadata,
        facts: &mut WrittenFacts,
        watch: &Watch,
    ) -> Result<(), EngineMaterialError> {
        let texels = match texture.content {
            TextureContent::Color => self.color(facts)?,
            TextureContent::Normal => self.normals(normals, facts)?,
            TextureContent::Surface(channels) => self.surface(channels, facts)?,
            TextureContent::Height(convention) => self.heights(convention),
            TextureContent::Emission => self.emission(facts)?,
        };
        let Texels { size: [width, height], channels, value } = texels;
        let png = PngTexture { width, height, channels, bits: texture.bits };
        let mut cancelled = None;
        let mut rows = |row: Row, texels: &mut [f32]| -> io::Result<()> {
            let start = row.row as usize * width as usize;
            for (at, texel) in texels.iter_mut().enumerate() {
                *texel = value(start + at, row.channel);
            }
            watch.at((row.row + 1) as f32 / height as f32).map_err(|error| {
                cancelled = Some(error);
                io::Error::other(error)
            })
        };
        let written = if texture.is_srgb() {
            write_png_colours(path, &png, metadata, &mut rows)
        } else {
            write_png_rows(path, &png, metadata, &mut rows)
        };
        match cancelled {
            Some(error) => Err(error.into()),
            None => Ok(written?),
        }
    }

    fn picture(&self, role: TextureRole, curve: Option<Curve>) -> Result<Picture, EngineMaterialError> {
        let path = self.texture(role).map(|texture| texture.path.as_path()).unwrap_or(Path::new(""));
        Ok(match curve {
            Some(curve) => read_picture_as(path, curve, self.max_bytes)?,
            None => read_picture(path, self.max_bytes)?,
        })
    }

    fn color(&self, facts: &mut WrittenFacts) -> Result<Texels<'static>, EngineMaterialError> {
        let Picture { width, height, texels } = self.picture(TextureRole::Color, None)?;
        facts.has_opacity = texels.iter().any(|texel| texel[3] < 1.0);
        let channels = if facts.has_opacity { 4 } else { 3 };
        let value = move |texel: usize, channel: usize| {
            let value = texels[texel][channel];
            if channel == 3 { value } else { encoded(value) }
        };
        Ok(Texels { size: [width, height], channels, value: Box::new(value) })
    }

    fn emission(&self, facts: &mut WrittenFacts) -> Result<Texels<'static>, EngineMaterialError> {
        let Picture { width, height, texels } = self.picture(TextureRole::Emission, Some(Curve::Srgb))?;
        let brightest = texels.iter().flat_map(|texel| &texel[..3]).copied().fold(1.0, f32::max);
        facts.emission_strength = brightest;
        let value = move |texel: usize, channel: usize| encoded(texels[texel][channel] / brightest);
        Ok(Texels { size: [width, height], channels: 3, value: Box::new(value) })
    }

    /// Returns normals with the engine's green. A set's normals keep their length, so that integers
    /// stay the same or, in green, are turned over.
    fn normals<'n>(
        &self,
        of_heights: Option<[&'n [f32]; 3]>,
        facts: &mut WrittenFacts,
    ) -> Result<Texels<'n>, EngineMaterialError> {
        let sign_from = |green: GreenSign| if green == self.engine.green { 1.0 } else { -1.0 };
        let unorm = |value: f32| 0.5 + 0.5 * value;
        if let Some(planes) = of_heights {
            let sign = sign_from(GreenSign::PlusY);
            let value = move |texel: usize, channel: usize| {
                let value = planes[channel][texel];
                unorm(if channel == 1 { sign * value } else { value })
            };
            let size = [self.heights.width(), self.heights.height()];
            return Ok(Texels { size, channels: 3, value: Box::new(value) });
        }
        let path = self.normal_map().map(|texture| texture.path.as_path()).unwrap_or(Path::new(""));
        let NormalVectors { width, height, mut vectors, .. } = read_normal_vectors(path, self.max_bytes)?;
        for vector in &mut vectors {
            let length = vector.iter().map(|part| part * part).sum::<f32>().sqrt();
            if !(length.is_finite() && length >= SHORTEST) {
                facts.degenerate_normals += 1;
                *vector = [0.0, 0.0, 1.0];
            } else if vector.iter().any(|part| part.abs() > 1.0) {
                *vector = vector.map(|part| part / length);
            }
        }
        let sign = sign_from(self.green);
        let value = move |texel: usize, channel: usize| {
            let value = vectors[texel][channel];
            unorm(if channel == 1 { sign * value } else { value })
        };
        Ok(Texels { size: [width, height], channels: 3, value: Box::new(value) })
    }

    fn heights(&self, convention: Convention) -> Texels<'_> {
        let texels = self.heights.texels();
        let value = move |texel: usize, _: usize| match convention {
            Convention::Height => texels[texel],
            Convention::Depth => 1.0 - texels[texel],
        };
        Texels { size: [self.heights.width(), self.heights.height()], channels: 1, value: Box::new(value) }
    }

    fn surface(
        &self,
        channels: &'static [SurfaceChannel],
        facts: &mut WrittenFacts,
    ) -> Result<Texels<'static>, EngineMaterialError> {
        let mut pictures = MaterialPictures::default();
        let mut left = self.max_bytes;
        let path_of = |map: MaterialMap| {
            let found = self.surface_files().find(|(known, _)| *known == map);
            found.map(|(_, texture)| texture.path.clone()).unwrap_or_default()
        };
        for (map, texture) in self.surface_files() {
            let picture = read_picture_as(&texture.path, Curve::Linear, left)?;
            left = left.saturating_sub(PICTURE_BYTES * picture.texels.len() as u64);
            pictures[map as usize] = Some(picture);
        }
        let size = MaterialMaps::size_of(&pictures);
        let needed = MaterialMaps::BYTES_PER_TEXEL * u64::from(size[0]) * u64::from(size[1]);
        if needed > left {
            let problem = MaterialMapError::Memory { needed: ByteSize(needed), left: ByteSize(left) };
            let first = self.surface_files().next().map(|(_, texture)| texture.path.clone());
            return Err(EngineMaterialError::Map { path: first.unwrap_or_default(), problem });
        }
        let is_smaller = |picture: &Picture| [picture.width, picture.height] != size;
        facts.resampled = pictures.iter().flatten().any(is_smaller).then_some(size);
        let maps = MaterialMaps::new(&pictures, self.heights.wrap())
            .map_err(|(map, problem)| EngineMaterialError::Map { path: path_of(map), problem })?;
        let [has_roughness, is_metal] =
            [SurfaceChannel::Roughness, SurfaceChannel::Metalness].map(|part| self.has(part));
        let value = move |texel: usize, channel: usize| {
            let [occlusion, roughness, metalness, ..] = maps.texels()[texel];
            let roughness = if has_roughness { roughness } else { ROUGHNESS };
            match channels[channel] {
                SurfaceChannel::Occlusion => occlusion,
                SurfaceChannel::Roughness => roughness,
                SurfaceChannel::Smoothness => 1.0 - roughness,
                SurfaceChannel::Metalness if is_metal => metalness,
                SurfaceChannel::Metalness | SurfaceChannel::Unused => 0.0,
            }
        };
        Ok(Texels { size, channels: channels.len(), value: Box::new(value) })
    }
}

fn encoded(linear: f32) -> f32 {
    linear_to_srgb(f64::from(linear)) as f32
}
