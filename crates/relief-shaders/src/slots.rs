//! The slots that the shaders read baked maps from.

/// A slot: a texture of layers and levels that one stage reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MapSlot {
    /// What is seen of normals that are far away.
    Detail,
    /// What the search of view rays reads.
    Search,
    /// What the search of shadow rays reads.
    ShadowSearch,
    /// What shadows are looked up in: horizons, visibility.
    Shadow,
    /// Light from all around: occlusion, bent normals, bounced light.
    Ambient,
    /// The surroundings, on the faces of a cube.
    Environment,
    /// What lights see.
    Lights,
    /// The images of an object.
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

    /// Its key in names.
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

    /// The texture's name in the shaders.
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

    /// What it holds, for people.
    pub const fn holds(self) -> &'static str {
        match self {
            MapSlot::Detail => "the baked map of the normals that are seen from fixed directions",
            MapSlot::Search => "the baked map that the search of view rays reads",
            MapSlot::ShadowSearch => "the baked map that the search of shadow rays reads",
            MapSlot::Shadow => "the baked map that shadows are looked up in",
            MapSlot::Ambient => "the baked map of light from all around",
            MapSlot::Environment => "the surroundings, the faces of a cube as layers",
            MapSlot::Lights => "what lights see, a layer for each view: near / (near + depth)",
            MapSlot::Object => "how the images of an object look at it, a row for each",
        }
    }

    /// The texture's binding in group 0.
    pub const fn binding(self) -> u32 {
        FIRST_BINDING + self as u32
    }
}

/// The binding of the first slot; the others follow.
const FIRST_BINDING: u32 = 5;
