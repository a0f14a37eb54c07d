//! The slots in which the shaders find baked maps.

/// A slot: a texture of layers and levels that one stage reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MapSlot {
    /// Visible normals of distant surfaces.
    Detail,
    /// The map of the search of view rays.
    Search,
    /// The map of the search of shadow rays.
    ShadowSearch,
    /// The map of shadows: horizons, or visibility.
    Shadow,
    /// The map of ambient light: occlusion, bent normals, or bounced light.
    Ambient,
    /// The environment map, on the faces of a cube.
    Environment,
    /// The shadow maps.
    Lights,
    /// The images of an object, or the tree of a motif.
    Object,
}

impl MapSlot {
    /// Every slot, in the order of the settings' array.
    pub const ALL: [MapSlot; 8] = [
        MapSlot::Detail,
        MapSlot::Search,
        MapSlot::ShadowSearch,
        MapSlot::Shadow,
        MapSlot::Ambient,
        MapSlot::Environment,
        MapSlot::Lights,
        MapSlot::Object,
    ];

    /// Returns the key in names.
    pub const fn key(self) -> &'static str {
        match self {
            MapSlot::Detail => "detail",
            MapSlot::Search => "search",
            MapSlot::ShadowSearch => "shadow_search",
            MapSlot::Shadow => "shadow",
            MapSlot::Ambient => "ambient",
            MapSlot::Environment => "environment",
            MapSlot::Lights => "lights",
            MapSlot::Object => "object",
        }
    }

    /// Returns the texture's name in the shaders.
    pub const fn name(self) -> &'static str {
        match self {
            MapSlot::Detail => "detail_map",
            MapSlot::Search => "search_map",
            MapSlot::ShadowSearch => "shadow_search_map",
            MapSlot::Shadow => "shadow_texels",
            MapSlot::Ambient => "ambient_map",
            MapSlot::Environment => "environment_map",
            MapSlot::Lights => "light_map",
            MapSlot::Object => "object_map",
        }
    }

    /// Returns the content, in words.
    pub const fn holds(self) -> &'static str {
        match self {
            MapSlot::Detail => "the baked map of visible normals from fixed directions",
            MapSlot::Search => "the baked map that the search of view rays reads",
            MapSlot::ShadowSearch => "the baked map that the search of shadow rays reads",
            MapSlot::Shadow => "the baked map that the shadow reads",
            MapSlot::Ambient => "the baked map of ambient light",
            MapSlot::Environment => "the environment map, the faces of a cube as layers",
            MapSlot::Lights => "shadow maps, a layer for each: near / (near + depth)",
            MapSlot::Object => "the views of an object's images, a row for each; or the tree of a motif",
        }
    }

    /// Returns the texture's binding in group 0.
    pub const fn binding(self) -> u32 {
        FIRST_BINDING + self as u32
    }
}

/// The binding of the first slot; the others follow.
const FIRST_BINDING: u32 = 5;
