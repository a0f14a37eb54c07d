//! One texture of a bake in memory, as shaders take it.

use relief_core::HeightMap;

use crate::{BakeError, Kind, Metric, Progress, Settings, Sink, SinkError, Texture, bake};

/// Bakes a map of that kind and keeps the finest level of the texture of that name: four numbers a texel, row by row from
/// the top, 0 where the texture has fewer channels. Besides what the bake itself needs that takes 16 bytes a texel.
///
/// # Errors
///
/// As [`bake`](crate::bake), and when the kind has no texture of that name, or one that is a volume or has more than four
/// channels.
pub fn texels(
    kind: &Kind,
    texture: &str,
    map: &HeightMap,
    metric: Metric,
    settings: &Settings,
    progress: &Progress,
) -> Result<Vec<[f32; 4]>, BakeError> {
    let mut kept = Kept { wanted: texture, wants: false, missing: true, texels: Vec::new() };
    bake(kind, map, metric, settings, progress, &mut kept)?;
    if kept.missing {
        let reason = format!("it has no texture '{texture}'");
        return Err(BakeError::Impossible { kind: kind.name, reason });
    }
    Ok(kept.texels)
}

/// The sink that keeps one slice.
struct Kept<'a> {
    wanted: &'a str,
    /// Whether the next slice is the wanted one.
    wants: bool,
    missing: bool,
    texels: Vec<[f32; 4]>,
}

impl Sink for Kept<'_> {
    fn begin(&mut self, texture: &Texture) -> Result<(), SinkError> {
        self.wants = texture.name == self.wanted;
        if self.wants && (texture.size[2] > 1 || texture.channels.len() > 4) {
            let name = texture.name;
            return Err(SinkError(format!("the texture '{name}' is no picture of at most four channels")));
        }
        Ok(())
    }

    fn slice(&mut self, planes: &[&[f32]]) -> Result<(), SinkError> {
        if std::mem::take(&mut self.wants) {
            self.missing = false;
            self.texels = vec![[0.0; 4]; planes.first().map_or(0, |plane| plane.len())];
            for (channel, plane) in planes.iter().enumerate() {
                for (texel, value) in self.texels.iter_mut().zip(*plane) {
                    texel[channel] = *value;
                }
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use relief_core::Wrap;

    use super::*;
    use crate::{Collected, kind};

    #[test]
    fn the_texels_are_those_of_the_bake() {
        let map = HeightMap::from_fn(7, 5, Wrap::Mirror, |i, j| ((i * 3 + j * 5) % 7) as f32 / 7.0);
        let map = map.expect("a valid map");
        for (name, texture) in [("frustum", "slopes"), ("frustum", "top"), ("pyramid", "")] {
            let kind = kind(name).expect("a kind");
            let of = |texture: &str| {
                texels(kind, texture, &map, Metric::UNIT, &kind.defaults(), &Progress::none())
            };
            let mut collected = Collected::default();
            bake(kind, &map, Metric::UNIT, &kind.defaults(), &Progress::none(), &mut collected)
                .expect("a bake");
            let found = collected.textures.iter().find(|found| found.texture.name == texture);
            let planes = &found.expect("the texture").levels[0];
            let texels = of(texture).expect("a bake");
            assert_eq!(texels.len(), 35);
            for (at, texel) in texels.iter().enumerate() {
                let planes =
                    std::array::from_fn(|channel| planes.get(channel).map_or(0.0, |plane| plane[at]));
                assert_eq!(*texel, planes, "{name} {texture} {at}");
            }
            assert!(matches!(of("no such texture"), Err(BakeError::Impossible { .. })));
        }
    }

    #[test]
    fn a_volume_is_refused() {
        let map = HeightMap::from_fn(4, 4, Wrap::Repeat, |_, _| 0.5).expect("a valid map");
        let kind = kind("distance").expect("a kind");
        let refused = texels(kind, "", &map, Metric::UNIT, &kind.defaults(), &Progress::none());
        assert!(matches!(refused, Err(BakeError::Sink(_))), "{refused:?}");
    }
}
