//! Bindings of the shaders: one table, which gives the shaders' declarations, the header of every
//! assembled shader and the GPU backend's layouts.

use std::fmt::Write as _;

use crate::slots::MapSlot;

/// A binding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Binding {
    /// The bind group.
    pub group: u32,
    /// The binding's number in the group.
    pub number: u32,
    /// The variable's name.
    pub name: &'static str,
    /// The kind of resource.
    pub kind: BindingKind,
    /// The content, in words.
    pub holds: &'static str,
}

/// A kind of resource.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BindingKind {
    /// A uniform buffer of the named struct.
    Uniform(&'static str),
    /// A storage buffer of an array of structs.
    Storage {
        /// The struct.
        of: &'static str,
        /// Whether the shaders only read it.
        read_only: bool,
    },
    /// A texture of floats.
    Texture {
        /// Whether it has layers.
        layers: bool,
        /// Whether fast sampling reads it through the sampler.
        filtered: bool,
    },
    /// A texture of integers.
    IntegerTexture,
    /// The sampler of fast sampling; there is none in exact sampling.
    Sampler,
    /// A storage texture of 16-bit floats, written by the shaders.
    Picture,
}

const fn filtered(number: u32, name: &'static str, layers: bool, holds: &'static str) -> Binding {
    Binding { group: 0, number, name, kind: BindingKind::Texture { layers, filtered: true }, holds }
}

const fn uniform(number: u32, name: &'static str, of: &'static str, holds: &'static str) -> Binding {
    Binding { group: 0, number, name, kind: BindingKind::Uniform(of), holds }
}

const fn storage(
    group: u32,
    number: u32,
    name: &'static str,
    of: &'static str,
    read_only: bool,
    holds: &'static str,
) -> Binding {
    Binding { group, number, name, kind: BindingKind::Storage { of, read_only }, holds }
}

const fn slot(slot: MapSlot) -> Binding {
    let kind = BindingKind::Texture { layers: true, filtered: false };
    Binding { group: 0, number: slot.binding(), name: slot.name(), kind, holds: slot.holds() }
}

const fn traced(number: u32, name: &'static str, kind: BindingKind, holds: &'static str) -> Binding {
    Binding { group: 2, number, name, kind, holds }
}

/// All bindings. Group 0 is the same for every program. Of the other groups a program binds the
/// variables that it uses.
pub static BINDINGS: [Binding; 47] = [
    uniform(0, "surface_settings", "SurfaceSettings", "settings of the surface"),
    filtered(1, "height_map", false, "heights"),
    filtered(2, "color_map", false, "linear colours; a single texel if the settings turn them off"),
    filtered(3, "normal_map", true, "tangent-space normals; a single texel if the settings turn them off"),
    Binding {
        group: 0,
        number: 4,
        name: "map_sampler",
        kind: BindingKind::Sampler,
        holds: "bilinear, with the wrap of the height map",
    },
    slot(MapSlot::Detail),
    slot(MapSlot::Search),
    slot(MapSlot::ShadowSearch),
    slot(MapSlot::Shadow),
    slot(MapSlot::Ambient),
    slot(MapSlot::Environment),
    slot(MapSlot::Lights),
    slot(MapSlot::Object),
    uniform(13, "frame", "Frame", "settings of the frame"),
    uniform(14, "pass_settings", "PassSettings", "settings of the pass"),
    Binding {
        group: 0,
        number: 15,
        name: "hole_map",
        kind: BindingKind::Texture { layers: false, filtered: false },
        holds: "holes, the texels above 0; a single texel if the settings turn them off",
    },
    filtered(
        16,
        "material_map",
        true,
        "occlusion, roughness and metalness, then emission; a single texel if the settings turn them off",
    ),
    storage(1, 0, "mesh_faces", "Face", true, "the base mesh's triangles"),
    storage(1, 1, "mesh_corners", "Corner", true, "the base mesh's corners, shared by triangles"),
    storage(1, 8, "pixels", "PixelIn", true, "rays to probe"),
    storage(1, 2, "probes", "Probe", false, "the stages' results for these rays"),
    storage(1, 19, "given_paths", "Path", true, "paths to trace"),
    storage(1, 20, "found_hits", "Hit", false, "the hits of these paths"),
    traced(0, "traced_hit", BindingKind::Texture { layers: false, filtered: false }, "the first pass's hits"),
    traced(1, "traced_what", BindingKind::IntegerTexture, "the first pass's triangles and costs"),
    storage(2, 2, "records", "Record", false, "every pixel's record"),
    storage(2, 3, "sums", "vec4f", false, "the colours of every pixel's samples so far, added up"),
    storage(2, 4, "shell_nodes", "ShellNode", true, "the BVH of the base mesh's shells"),
    storage(2, 5, "gathered", "Gathered", false, "what every pixel sees of each translucent surface"),
    storage(1, 3, "shown_records", "Record", true, "every pixel's record, to be shown"),
    Binding { group: 1, number: 4, name: "picture", kind: BindingKind::Picture, holds: "the linear picture" },
    Binding {
        group: 1,
        number: 5,
        name: "finer_level",
        kind: BindingKind::Texture { layers: false, filtered: false },
        holds: "the level of a pyramid before the one that is built",
    },
    Binding {
        group: 1,
        number: 6,
        name: "heights_below",
        kind: BindingKind::Texture { layers: false, filtered: false },
        holds: "the height map that a pyramid is built from",
    },
    Binding {
        group: 1,
        number: 7,
        name: "pyramid_pass",
        kind: BindingKind::Uniform("PyramidPass"),
        holds: "settings of a level of a pyramid",
    },
    Binding {
        group: 1,
        number: 9,
        name: "tessellation",
        kind: BindingKind::Uniform("Tessellation"),
        holds: "the view that a base is tessellated for, and the base's sizes",
    },
    storage(1, 10, "base_vertices", "BaseVertex", true, "the vertices of a tessellated base"),
    storage(1, 11, "base_edges", "BaseEdge", true, "the edges of a tessellated base"),
    storage(1, 12, "base_patches", "BasePatch", true, "the triangles of a tessellated base"),
    storage(1, 13, "voxels", "Voxel", false, "the base's vertices in grid space"),
    storage(1, 14, "tallies", "Tally", false, "the yield of each of the base's edges, then of its triangles"),
    storage(1, 15, "tally_blocks", "vec2u", false, "points and triangles of blocks of tallies"),
    storage(
        1,
        16,
        "made_totals",
        "TessellationTotals",
        false,
        "the number of points and triangles that are made, and the draw call's arguments",
    ),
    storage(1, 17, "made_corners", "Corner", false, "the points that are made"),
    storage(1, 18, "made_faces", "Face", false, "the triangles that are made"),
    Binding {
        group: 1,
        number: 21,
        name: "point_settings",
        kind: BindingKind::Uniform("PointSettings"),
        holds: "settings of a method as a function",
    },
    Binding {
        group: 1,
        number: 22,
        name: "screen_settings",
        kind: BindingKind::Uniform("ScreenSettings"),
        holds: "settings of the picture for screens",
    },
    storage(1, 23, "screen", "u32", false, "the picture for screens: red, green, blue and 255 of each pixel"),
];

impl Binding {
    /// Returns the binding of a variable, by its name.
    pub fn named(name: &str) -> Option<&'static Binding> {
        BINDINGS.iter().find(|binding| binding.name == name)
    }

    /// Returns the declaration in WGSL.
    pub fn declaration(&self) -> String {
        let Self { group, number, name, kind, .. } = self;
        let (space, kind) = match kind {
            BindingKind::Uniform(of) => ("<uniform>", (*of).to_owned()),
            BindingKind::Storage { of, read_only: true } => ("<storage, read>", format!("array<{of}>")),
            BindingKind::Storage { of, read_only: false } => {
                ("<storage, read_write>", format!("array<{of}>"))
            }
            BindingKind::Texture { layers: false, .. } => ("", "texture_2d<f32>".to_owned()),
            BindingKind::Texture { layers: true, .. } => ("", "texture_2d_array<f32>".to_owned()),
            BindingKind::IntegerTexture => ("", "texture_2d<i32>".to_owned()),
            BindingKind::Sampler => ("", "sampler".to_owned()),
            BindingKind::Picture => ("", "texture_storage_2d<rgba16float, write>".to_owned()),
        };
        format!("@group({group}) @binding({number}) var{space} {name}: {kind};")
    }

    /// Returns the name of a buffer's struct; `None` for other kinds.
    pub fn structure(&self) -> Option<&'static str> {
        match self.kind {
            BindingKind::Uniform(of) | BindingKind::Storage { of, .. } => Some(of),
            _ => None,
        }
    }
}

/// Lists bindings in a comment for the head of a shader, one line each.
pub fn table(bindings: &[Binding]) -> String {
    let mut text = String::new();
    for Binding { group, number, name, holds, .. } in bindings {
        let _ = writeln!(text, "//   group {group}, binding {number}: {name}, {holds}");
    }
    text
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn every_binding_has_its_own_number_and_name() {
        let numbers: BTreeSet<_> = BINDINGS.iter().map(|binding| (binding.group, binding.number)).collect();
        let names: BTreeSet<_> = BINDINGS.iter().map(|binding| binding.name).collect();
        assert_eq!((numbers.len(), names.len()), (BINDINGS.len(), BINDINGS.len()));
        assert_eq!(
            Binding::named("frame").map(Binding::declaration).as_deref(),
            Some("@group(0) @binding(13) var<uniform> frame: Frame;")
        );
        assert_eq!(Binding::named("nothing"), None);
    }
}
