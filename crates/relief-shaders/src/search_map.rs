//! The baked map that a search reads besides the heights.

use relief_core::HeightMap;
use relief_core::registry::MapInput;

use crate::Selection;

/// A baked map as the shaders bind it: four numbers for each texel of the height map, row by row from the top, 0 where
/// the texture has fewer channels.
///
/// It is to be baked from that height map, in its wrap, in texture units and heights as they are: a metric of 1 m for each
/// tile and for the scale. So it is the same map whatever the tile's size and the scale in metres.
#[derive(Clone, Debug, PartialEq)]
pub struct SearchMap {
    input: MapInput,
    size: [u32; 2],
    texels: Vec<[f32; 4]>,
}

/// Why a search has no map to read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SearchMapError {
    /// There is no map, or one of another kind.
    #[error("the search '{search}' reads a baked map of the kind '{kind}', and there is none: bake it first")]
    Missing {
        /// The search.
        search: &'static str,
        /// The kind of map.
        kind: &'static str,
    },
    /// The map is of another size than the height map, or its texels are not as many as its size says.
    #[error("the map of the kind '{kind}' has {given} texels of {size:?}, the height map has {wanted:?}")]
    Size {
        /// The kind of map.
        kind: &'static str,
        /// Columns and rows of the map.
        size: [u32; 2],
        /// Texels of the map.
        given: usize,
        /// Columns and rows of the height map.
        wanted: [u32; 2],
    },
}

impl SearchMap {
    /// A map of so many columns and rows. Nothing is checked before it is used.
    pub fn new(input: MapInput, size: [u32; 2], texels: Vec<[f32; 4]>) -> Self {
        Self { input, size, texels }
    }

    /// Which map it is.
    pub fn input(&self) -> MapInput {
        self.input
    }

    /// Columns and rows.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// The texels.
    pub fn texels(&self) -> &[[f32; 4]] {
        &self.texels
    }
}

impl Selection {
    /// The baked map that the search reads, if it reads one.
    pub fn map_input(&self) -> Option<MapInput> {
        self.search().maps.first().copied()
    }

    /// Of what is given, the map that the search reads over that height map; none for a search that reads none.
    ///
    /// # Errors
    ///
    /// When the map is missing, is of another kind, or does not have the height map's size.
    pub fn map_among<'a>(
        &self,
        given: Option<&'a SearchMap>,
        height_map: &HeightMap,
    ) -> Result<Option<&'a SearchMap>, SearchMapError> {
        let Some(input) = self.map_input() else {
            return Ok(None);
        };
        let missing = SearchMapError::Missing { search: self.search().name, kind: input.kind };
        let map = given.filter(|map| map.input == input).ok_or(missing)?;
        let wanted = [height_map.width(), height_map.height()];
        if map.size != wanted || map.texels.len() != height_map.texels().len() {
            let (kind, size, given) = (input.kind, map.size, map.texels.len());
            return Err(SearchMapError::Size { kind, size, given, wanted });
        }
        Ok(Some(map))
    }
}

#[cfg(test)]
mod tests {
    use relief_core::Wrap;

    use super::*;

    #[test]
    fn a_search_gets_its_own_map_of_the_right_size_or_an_error() {
        let map = HeightMap::from_fn(3, 2, Wrap::Repeat, |_, _| 0.5).expect("a valid map");
        let frustum = Selection::method("frustum").expect("a method");
        let input = frustum.map_input().expect("it reads a map");
        let right = SearchMap::new(input, [3, 2], vec![[0.0; 4]; 6]);
        assert_eq!(frustum.map_among(Some(&right), &map), Ok(Some(&right)));
        let missing = Err(SearchMapError::Missing { search: "frustum", kind: "frustum" });
        assert_eq!(frustum.map_among(None, &map), missing);
        let other = SearchMap::new(MapInput { kind: "cone", texture: "" }, [3, 2], vec![[0.0; 4]; 6]);
        assert_eq!(frustum.map_among(Some(&other), &map), missing);
        for (size, texels) in [([2, 3], 6), ([3, 2], 5)] {
            let wrong = SearchMap::new(input, size, vec![[0.0; 4]; texels]);
            let refused = frustum.map_among(Some(&wrong), &map);
            assert!(matches!(refused, Err(SearchMapError::Size { .. })), "{size:?} {texels}");
        }
        let exact = Selection::method("exact").expect("a method");
        assert_eq!(exact.map_among(Some(&right), &map), Ok(None));
        assert_eq!(exact.map_among(None, &map), Ok(None));
    }
}
