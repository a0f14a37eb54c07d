//! The stages of a pixel: one table, the source of selections, settings, the shaders' dispatch,
//! help and tests.

use relief_core::registry::RayClass;

use crate::entry::Entry;
use crate::slots::MapSlot;
use crate::{ambient, detail, field, geometry, object, refine, search, shade, shadow, slice, surface};

/// A stage: a list of variants that do the same task in different ways.
///
/// A variant is a pair of files in the stage's folder: the shader, and the registry entry beside
/// it. For a stage that renderers run before any shader it is the entry alone.
///
/// The shader's function is named after the folder and the variant, as in `search_linear`. If a
/// stage has several functions, their own names follow, as in `surface_plane_enter`. A function
/// takes the stage's inputs, then the variant's parameters, a `vec4f`.
#[derive(Clone, Copy, Debug)]
pub struct Stage {
    /// The key in settings and scenes, as in `search.steps`.
    pub key: &'static str,
    /// The folder of its variants, with which their functions' names begin. Two stages may share
    /// one.
    pub folder: &'static str,
    /// The name of one variant in messages.
    pub title: &'static str,
    /// The name of all variants in tables.
    pub plural: &'static str,
    /// The variants; the place of each is its number in the shaders.
    pub entries: &'static [Entry],
    /// The setting that chooses the variant, as in `slices.test`; `None` if the stage's key itself
    /// does.
    pub chosen_as: Option<&'static str>,
    /// The functions that each variant has; empty if no shader runs it.
    pub calls: &'static [Call],
    /// The slot in which its variants find baked maps, if they may read any.
    pub slot: Option<MapSlot>,
    /// The rays that it gets when a picture is rendered. A variant whose guarantee for one of these
    /// is `impossible` is refused.
    pub rays: &'static [RayClass],
}

/// A function that each variant of a stage has.
#[derive(Clone, Copy, Debug)]
pub struct Call {
    /// The end of its name, after the variant's; empty if it is the stage's only one.
    pub name: &'static str,
    /// The inputs: names and types, as WGSL writes them.
    pub inputs: &'static [(&'static str, &'static str)],
    /// The type of the result, as WGSL writes it.
    pub returns: &'static str,
    /// The variants that have it; `None`: all of them.
    pub only: Option<fn(&Entry) -> bool>,
}

/// The only function of a variant.
const fn only(inputs: &'static [(&'static str, &'static str)], returns: &'static str) -> Call {
    call("", inputs, returns)
}

/// A function that each variant has.
const fn call(
    name: &'static str,
    inputs: &'static [(&'static str, &'static str)],
    returns: &'static str,
) -> Call {
    Call { name, inputs, returns, only: None }
}

/// A function of the surfaces whose rays go through the frame of a base point.
const fn of_frame(
    name: &'static str,
    inputs: &'static [(&'static str, &'static str)],
    returns: &'static str,
) -> Call {
    Call { name, inputs, returns, only: Some(goes_through_frame) }
}

/// Whether a surface's rays go through the frame of a base point.
fn goes_through_frame(entry: &Entry) -> bool {
    entry.paths().through_frame
}

/// All stages, in the order in which a pixel goes through them.
pub static STAGES: [Stage; 12] = [
    Stage {
        key: "geometry",
        folder: "geometry",
        title: "geometry",
        plural: "geometries",
        entries: geometry::ENTRIES,
        chosen_as: None,
        calls: &[],
        slot: None,
        rays: &[],
    },
    Stage {
        key: "surface",
        folder: "surface",
        title: "surface",
        plural: "surfaces",
        entries: surface::ENTRIES,
        chosen_as: None,
        calls: &[
            call("enter", &[("pixel", "PixelIn")], "Entered"),
            call("segment", &[("pixel", "PixelIn"), ("at", "Entered"), ("k", "u32")], "Path"),
            call(
                "polish",
                &[("pixel", "PixelIn"), ("at", "Entered"), ("path", "Path"), ("hit", "Hit")],
                "Hit",
            ),
            call(
                "place",
                &[("pixel", "PixelIn"), ("at", "Entered"), ("path", "Path"), ("hit", "Hit")],
                "Entered",
            ),
            of_frame("crossed", &[("at", "Entered"), ("direction", "vec3f"), ("eye", "f32")], "Entered"),
            of_frame(
                "way",
                &[
                    ("at", "Entered"),
                    ("direction", "vec3f"),
                    ("distance", "f32"),
                    ("eye", "f32"),
                    ("k", "u32"),
                ],
                "Path",
            ),
            of_frame("frame", &[("at", "Entered"), ("aside", "vec2f")], "Entered"),
        ],
        slot: None,
        rays: &[RayClass::View],
    },
    Stage {
        key: "slices",
        folder: "slice",
        title: "slice test",
        plural: "slice tests",
        entries: slice::ENTRIES,
        chosen_as: Some("test"),
        calls: &[only(&[("map", "f32"), ("slice", "f32"), ("spacing", "f32")], "bool")],
        slot: None,
        rays: &[],
    },
    Stage {
        key: "object",
        folder: "object",
        title: "object",
        plural: "objects",
        entries: object::ENTRIES,
        chosen_as: Some("solid"),
        calls: &[
            only(&[("pixel", "PixelIn"), ("at", "Entered")], "FirstHit"),
            call("parts", &[("level", "u32")], "i32"),
            call("cell", &[("cell", "vec2i"), ("level", "u32")], "vec4f"),
            call("color", &[("at", "Entered"), ("hit", "Hit"), ("view", "vec3f")], "vec3f"),
        ],
        slot: None,
        rays: &[],
    },
    Stage {
        key: "field",
        folder: "field",
        title: "field",
        plural: "fields",
        entries: field::ENTRIES,
        chosen_as: Some("kind"),
        calls: &[
            call("gap", &[("path", "Path"), ("t", "f32")], "f32"),
            call("cost", &[("level", "u32")], "vec3u"),
            call("is_ground", &[("level", "u32")], "bool"),
            call("height", &[("uv", "vec2f"), ("height", "f32"), ("level", "u32")], "f32"),
            call("normals", &[("at", "Entered"), ("hit", "Hit"), ("view", "vec3f")], "SeenNormals"),
            call("normal", &[("at", "Entered"), ("hit", "Hit"), ("view", "vec3f")], "vec3f"),
            call("patch_normal", &[("at", "Entered"), ("hit", "Hit")], "vec3f"),
            call("light_ray", &[("at", "Entered"), ("hit", "Hit"), ("light", "Toward")], "LightRay"),
        ],
        slot: None,
        rays: &[],
    },
    Stage {
        key: "detail",
        folder: "detail",
        title: "detail",
        plural: "levels of detail",
        entries: detail::ENTRIES,
        chosen_as: None,
        calls: &[
            only(&[("pixel", "PixelIn"), ("at", "Entered")], "Detail"),
            call("of_footprint", &[("at", "Entered"), ("footprint", "f32")], "Detail"),
        ],
        slot: Some(MapSlot::Detail),
        rays: &[],
    },
    Stage {
        key: "search",
        folder: "search",
        title: "search",
        plural: "searches",
        entries: search::ENTRIES,
        chosen_as: None,
        calls: &[only(&[("path", "Path")], "SearchResult")],
        slot: Some(MapSlot::Search),
        rays: &[RayClass::View],
    },
    Stage {
        key: "refine",
        folder: "refine",
        title: "refinement",
        plural: "refinements",
        entries: refine::ENTRIES,
        chosen_as: None,
        calls: &[only(&[("path", "Path"), ("found", "SearchResult")], "Hit")],
        slot: None,
        rays: &[RayClass::View],
    },
    Stage {
        key: "shade",
        folder: "shade",
        title: "shading",
        plural: "shadings",
        entries: shade::ENTRIES,
        chosen_as: None,
        calls: &[
            call(
                "material",
                &[
                    ("at", "Entered"),
                    ("hit", "Hit"),
                    ("normal", "vec3f"),
                    ("mean", "f32"),
                    ("view", "vec3f"),
                    ("color", "vec3f"),
                ],
                "Material",
            ),
            call(
                "light",
                &[
                    ("material", "Material"),
                    ("normal", "vec3f"),
                    ("mean", "f32"),
                    ("cosine", "f32"),
                    ("view", "vec3f"),
                    ("toward", "vec3f"),
                ],
                "vec3f",
            ),
            call("mirrored", &[("material", "Material"), ("mean", "f32"), ("cosine", "f32")], "Mirrored"),
        ],
        slot: None,
        rays: &[],
    },
    Stage {
        key: "shadow",
        folder: "shadow",
        title: "shadow",
        plural: "shadows",
        entries: shadow::ENTRIES,
        chosen_as: None,
        calls: &[only(&[("at", "Entered"), ("hit", "Hit"), ("light", "Toward")], "f32")],
        slot: Some(MapSlot::Shadow),
        rays: &[],
    },
    Stage {
        key: "shadow-search",
        folder: "search",
        title: "shadow search",
        plural: "shadow searches",
        entries: search::ENTRIES,
        chosen_as: None,
        calls: &[only(&[("path", "Path")], "SearchResult")],
        slot: Some(MapSlot::ShadowSearch),
        rays: &[RayClass::Shadow],
    },
    Stage {
        key: "ambient",
        folder: "ambient",
        title: "ambient light",
        plural: "ambient lights",
        entries: ambient::ENTRIES,
        chosen_as: None,
        calls: &[only(
            &[
                ("at", "Entered"),
                ("hit", "Hit"),
                ("normal", "vec3f"),
                ("view", "vec3f"),
                ("material", "Material"),
            ],
            "vec3f",
        )],
        slot: Some(MapSlot::Ambient),
        rays: &[],
    },
];

/// Place of the stage `geometry` in [`STAGES`].
pub const GEOMETRY: usize = place("geometry");

/// Place of the stage `surface` in [`STAGES`].
pub const SURFACE: usize = place("surface");

/// Place of the stage `slices` in [`STAGES`].
pub const SLICES: usize = place("slices");

/// Place of the stage `object` in [`STAGES`].
pub const OBJECT: usize = place("object");

/// Place of the stage `field` in [`STAGES`].
pub const FIELD: usize = place("field");

/// Place of the stage `detail` in [`STAGES`].
pub const DETAIL: usize = place("detail");

/// Place of the stage `search` in [`STAGES`].
pub const SEARCH: usize = place("search");

/// Place of the stage `refine` in [`STAGES`].
pub const REFINE: usize = place("refine");

/// Place of the stage `shade` in [`STAGES`].
pub const SHADE: usize = place("shade");

/// Place of the stage `shadow` in [`STAGES`].
pub const SHADOW: usize = place("shadow");

/// Place of the stage `shadow-search` in [`STAGES`].
pub const SHADOW_SEARCH: usize = place("shadow-search");

/// Place of the stage `ambient` in [`STAGES`].
pub const AMBIENT: usize = place("ambient");

impl Stage {
    /// Returns the first variant for which `holds` is true, and its number.
    pub fn first(&self, holds: impl Fn(&Entry) -> bool) -> Option<(usize, &'static Entry)> {
        self.entries.iter().enumerate().find(|(_, entry)| holds(entry))
    }

    /// Whether scenes choose its variant by its key; if not, a setting does.
    pub fn has_key(&self) -> bool {
        self.chosen_as.is_none()
    }

    /// Returns the names of a setting's values, from 0 on: names of variants if it chooses one,
    /// otherwise the parameter's names. Empty if its values are plain numbers.
    pub fn names_of(&self, setting: &str) -> Vec<&'static str> {
        if self.chosen_as == Some(setting) {
            return self.entries.iter().map(|entry| entry.name).collect();
        }
        let param = self.entries.iter().find_map(|entry| entry.param(setting));
        param.map_or(Vec::new(), |(_, param)| param.names.to_vec())
    }

    /// Returns the functions through which the shaders call it.
    pub fn functions(&self) -> impl Iterator<Item = String> {
        self.calls.iter().map(|call| self.function(call))
    }

    /// Returns the function through which the shaders call one of its functions.
    pub fn function(&self, call: &Call) -> String {
        format!("{}{}_stage", self.key.replace('-', "_"), call.ending())
    }

    /// Returns the variants that have one of its functions, with their numbers.
    pub fn entries_with(&self, call: &Call) -> impl Iterator<Item = (usize, &'static Entry)> {
        let only = call.only;
        self.entries.iter().enumerate().filter(move |(_, entry)| only.is_none_or(|has| has(entry)))
    }

    /// Returns the name of a variant's function.
    pub fn function_of(&self, call: &Call, entry: &Entry) -> String {
        format!("{}_{}{}", self.folder, entry.name.replace('-', "_"), call.ending())
    }
}

impl Call {
    /// The end of functions' names.
    fn ending(&self) -> String {
        if self.name.is_empty() { String::new() } else { format!("_{}", self.name) }
    }
}

/// Returns the stage of a setting such as `search.steps`, its place in [`STAGES`], and the
/// setting's own name.
pub fn stage_of_setting(key: &str) -> Option<(usize, &'static Stage, &str)> {
    let (of, name) = key.split_once('.')?;
    let (place, stage) = stage(of)?;
    Some((place, stage, name))
}

/// Returns the stage of that key and its place in [`STAGES`].
pub fn stage(key: &str) -> Option<(usize, &'static Stage)> {
    STAGES.iter().enumerate().find(|(_, stage)| stage.key == key)
}

/// The place of a stage that is known to exist.
const fn place(key: &str) -> usize {
    let mut place = 0;
    while !is_same(STAGES[place].key.as_bytes(), key.as_bytes()) {
        place += 1;
    }
    place
}

/// The place of an entry that is known to exist.
pub(crate) const fn entry_place(entries: &[Entry], name: &str) -> usize {
    let mut place = 0;
    while !is_same(entries[place].name.as_bytes(), name.as_bytes()) {
        place += 1;
    }
    place
}

const fn is_same(a: &[u8], b: &[u8]) -> bool {
    let mut at = 0;
    while at < a.len() && at < b.len() && a[at] == b[at] {
        at += 1;
    }
    at == a.len() && at == b.len()
}
