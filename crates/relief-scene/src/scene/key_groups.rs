//! The groups of keys: what an editor shows together.

use relief_shaders::STAGES;

use super::viewer::VIEWER;

/// A group of keys.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum KeyGroup {
    /// What is displaced, and how far.
    Relief,
    /// The method that finds hits, and the variants of its stages.
    Method,
    /// The mesh under the relief, its tiles and its place.
    Mesh,
    /// Colours, normals and other maps, and the material.
    Material,
    /// The way in which the values of a file become heights.
    Reading,
    /// Where the eye is.
    Camera,
    /// Lights, and what is around the scene.
    Light,
    /// Size, samples and tone of the picture, and the machine that draws it.
    Picture,
    /// What a viewer shows.
    Views,
}

impl KeyGroup {
    /// All groups, in the order in which an editor shows them.
    pub const ALL: [KeyGroup; 9] = [
        Self::Relief,
        Self::Method,
        Self::Mesh,
        Self::Material,
        Self::Reading,
        Self::Camera,
        Self::Light,
        Self::Picture,
        Self::Views,
    ];

    /// Returns the name, as a title.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Relief => "Relief",
            Self::Method => "Method",
            Self::Mesh => "Mesh",
            Self::Material => "Material",
            Self::Reading => "Reading of heights",
            Self::Camera => "Camera",
            Self::Light => "Light",
            Self::Picture => "Picture",
            Self::Views => "Views",
        }
    }
}

/// The keys of each group, what is changed most first. [`KeyGroup::Method`] has the stages', too.
const GROUPS: [(KeyGroup, &[&str]); 9] = [
    (
        KeyGroup::Relief,
        &[
            "height",
            "scale",
            "textures",
            "object",
            "volume",
            "motif",
            "wrap",
            "bias",
            "exaggerate",
            "extinction",
        ],
    ),
    (KeyGroup::Method, &["method", "set"]),
    (
        KeyGroup::Mesh,
        &[
            "mesh",
            "tile",
            "tile-size",
            "position",
            "rotation",
            "mesh-scale",
            "walls",
            "base",
            "project",
            "mesh-up",
            "two-sided",
        ],
    ),
    (
        KeyGroup::Material,
        &[
            "color",
            "ramp",
            "normal",
            "green",
            "creases",
            "roughness",
            "metallic",
            "occlusion",
            "orm",
            "mask-map",
            "metallic-smoothness",
            "glossiness",
            "emission",
            "material",
            "transmission",
            "ior",
        ],
    ),
    (
        KeyGroup::Reading,
        &["channel", "depth", "range", "elevation", "nodata", "unit", "raw", "fill", "holes", "axes", "udim"],
    ),
    (KeyGroup::Camera, &["view", "eye", "target", "projection", "fov", "view-height", "clip", "near", "far"]),
    (
        KeyGroup::Light,
        &["look", "light", "lights", "light-angle", "ambient-color", "environment", "background"],
    ),
    (KeyGroup::Picture, &["size", "samples", "exposure", "tone", "backend", "sampling", "max-memory"]),
    (KeyGroup::Views, &[VIEWER]),
];

/// Returns a key's place in its group; stages stand at the end of theirs.
pub(super) fn rank_of(key: &str) -> usize {
    GROUPS.iter().find_map(|(_, keys)| keys.iter().position(|name| *name == key)).unwrap_or(usize::MAX)
}

/// Returns the group of a key.
pub(super) fn group_of(key: &str) -> KeyGroup {
    let is_stage = STAGES.iter().any(|stage| stage.has_key() && stage.key == key);
    let found = GROUPS.iter().find(|(_, keys)| keys.contains(&key));
    match found {
        Some((group, _)) => *group,
        // A key of the scene that nobody has put into a group yet.
        None if !is_stage => KeyGroup::Picture,
        None => KeyGroup::Method,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::keys;

    #[test]
    fn every_key_is_in_one_group() {
        let listed: Vec<&str> = GROUPS.iter().flat_map(|(_, keys)| *keys).copied().collect();
        for key in keys() {
            let is_stage = STAGES.iter().any(|stage| stage.has_key() && stage.key == key.name);
            let count = listed.iter().filter(|name| **name == key.name).count();
            assert_eq!(count, usize::from(!is_stage), "{}", key.name);
        }
        assert!(listed.iter().all(|name| keys().iter().any(|key| key.name == *name)));
        assert_eq!(GROUPS.map(|(group, _)| group), KeyGroup::ALL);
    }
}
