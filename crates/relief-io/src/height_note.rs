//! Note on the real size of a height map, in files that Relief wrote.

use crate::layout::{Format, Layout};
use crate::{Metadata, Source, WriteProblem, read_metadata};

/// Value of `relief.displacement` in a map made for a mesh.
const OF_MESH: &str = "of the mesh";

/// Value of `relief.kind` in such a file.
const KIND: &str = "height";

/// Real size of a height map whose texels are in `[0, 1]`, stored as metadata of its file.
/// `relief.kind` is `height`. `relief.tile_m` holds the tile's lengths along `u` and `v`.
/// `relief.scale_m` is the displacement of texel 1 above texel 0, and `relief.bias_m` the
/// displacement of texel 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeightNote {
    /// Lengths of the tile along `u` and `v` in metres.
    pub tile_m: [f64; 2],
    /// Displacement of texel 1 above texel 0 in metres; 0 for a level map.
    pub scale_m: f64,
    /// Displacement of texel 0 in metres.
    pub bias_m: f64,
    /// Whether the displacements belong to the mesh that the map was made for, whatever its tile.
    /// Then `relief.displacement` is `of the mesh`.
    pub of_mesh: bool,
}

impl HeightNote {
    /// Returns the metadata of a file with this note and the entries `more`, whose names are given
    /// without `relief.`.
    ///
    /// # Errors
    ///
    /// When `more` holds an invalid entry, or a name that the note uses itself.
    pub fn metadata(&self, more: Vec<(&str, String)>) -> Result<Metadata, WriteProblem> {
        let [tile_u, tile_v] = self.tile_m;
        let own = [
            ("kind", KIND.to_owned()),
            ("tile_m", format!("{tile_u} {tile_v}")),
            ("scale_m", self.scale_m.to_string()),
            ("bias_m", self.bias_m.to_string()),
        ];
        let of_mesh = self.of_mesh.then(|| ("displacement", OF_MESH.to_owned()));
        let entries = own.into_iter().chain(of_mesh).chain(more);
        Metadata::new(entries.map(|(name, value)| (format!("relief.{name}"), value)).collect())
    }

    /// Reads the note of a file, if it has one. A note with impossible numbers counts as none.
    pub(crate) fn of_file(source: Source<'_>, layout: &Layout) -> Option<Self> {
        if !matches!(layout.format, Format::Png | Format::Exr) {
            return None;
        }
        let note = Self::of(&read_metadata(source).ok()?)?;
        Some(Self { tile_m: layout.orientation.shown(note.tile_m), ..note })
    }

    fn of(metadata: &Metadata) -> Option<Self> {
        if metadata.get("relief.kind") != Some(KIND) {
            return None;
        }
        let number = |text: &str| text.parse::<f64>().ok().filter(|number| number.is_finite());
        let (u, v) = metadata.get("relief.tile_m")?.split_once(' ')?;
        let tile_m = [number(u)?, number(v)?];
        let [scale_m, bias_m] =
            [number(metadata.get("relief.scale_m")?)?, number(metadata.get("relief.bias_m")?)?];
        let of_mesh = metadata.get("relief.displacement") == Some(OF_MESH);
        let can_be = tile_m.iter().all(|side| *side > 0.0) && scale_m >= 0.0;
        can_be.then_some(Self { tile_m, scale_m, bias_m, of_mesh })
    }

    /// Returns the size of a texel along `u` and `v` in metres, for a map of the given size.
    pub(crate) fn texel_size_m(&self, [width, height]: [u32; 2]) -> [f64; 2] {
        [self.tile_m[0] / f64::from(width), self.tile_m[1] / f64::from(height)]
    }

    /// Converts a texel value to its displacement in metres.
    pub(crate) fn metres(&self, texel: f64) -> f64 {
        self.bias_m + self.scale_m * texel
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn valid_notes_are_read_and_nonsense_is_refused() {
        let note = HeightNote { tile_m: [2.0, 0.3], scale_m: 0.125, bias_m: -0.1, of_mesh: false };
        let metadata = note.metadata(vec![("wrap", "clamp".to_owned())]).expect("plain text");
        assert_eq!(HeightNote::of(&metadata), Some(note));
        let of_mesh = HeightNote { of_mesh: true, ..note };
        let more = of_mesh.metadata(Vec::new()).expect("plain text");
        assert_eq!(HeightNote::of(&more), Some(of_mesh));
        assert_eq!(metadata.get("relief.wrap"), Some("clamp"));
        assert!(note.metadata(vec![("kind", "cone".to_owned())]).is_err());
        for (key, value) in [
            ("kind", "normal"),
            ("tile_m", "1"),
            ("tile_m", "0 1"),
            ("tile_m", "nan 1"),
            ("scale_m", "-1"),
            ("scale_m", "inf"),
            ("bias_m", ""),
        ] {
            let entries = metadata.iter().map(|(name, old)| {
                let new = if name == format!("relief.{key}") { value } else { old };
                (name.to_owned(), new.to_owned())
            });
            let changed = Metadata::new(entries.collect()).expect("plain text");
            assert_eq!(HeightNote::of(&changed), None, "{key} = {value}");
        }
    }
}
