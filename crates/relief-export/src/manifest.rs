//! The manifest of an export: the content of the files' heads for programs.

use std::collections::BTreeMap;

use serde::Serialize;

/// An export. Its JSON is `NAME.json`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Manifest {
    /// The files' name before their endings.
    pub name: String,
    /// The version of relief that wrote it.
    pub relief: String,
    /// The way in which textures are read: `exact` or `fast`.
    pub sampling: &'static str,
    /// The draw call.
    pub draw: Draw,
    /// The variants that are run, stage by stage.
    pub stages: Vec<ChosenStage>,
    /// The bindings, under the names of the WGSL source.
    pub bindings: Vec<Bound>,
    /// The structs of the buffers, by name.
    pub structs: BTreeMap<String, Struct>,
    /// The files, target by target.
    pub targets: Vec<TargetFiles>,
}

/// The draw call of the entry points: triangles without vertex buffers.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Draw {
    /// Vertices for each triangle of the mesh.
    pub vertices_per_triangle: u32,
    /// Number of instances: 1; for boxes around shells, 2 also draws the backs of a two-sided mesh.
    pub instances: &'static str,
    /// Culled faces: `back`, for a two-sided mesh none; `front`; or `none`.
    pub cull: &'static str,
    /// The winding of front faces as seen in the picture.
    pub front_face: &'static str,
    /// Whether fragments give a depth of their own, to be tested.
    pub depth: bool,
    /// How colours are laid over what is behind: `none` replaces it; `premultiplied` adds the colour to
    /// what is behind, times 1 less the alpha. Then triangles are drawn from the farthest to the nearest,
    /// behind what is opaque, and the depth buffer is tested and not written.
    pub blend: &'static str,
}

/// The variant that a stage runs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ChosenStage {
    /// The stage's key.
    pub stage: &'static str,
    /// The variant.
    pub name: &'static str,
    /// A line that says what it does.
    pub summary: &'static str,
    /// Where it was published.
    pub published: String,
    /// The parameters, each a number in a uniform buffer.
    pub params: Vec<ParamPlace>,
}

/// A parameter of a variant.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ParamPlace {
    /// The parameter's name.
    pub name: &'static str,
    /// A line that says what it does.
    pub summary: &'static str,
    /// The unit; empty for plain numbers.
    pub unit: &'static str,
    /// The value to begin with.
    pub value: f32,
    /// The least value.
    pub min: f32,
    /// The greatest value.
    pub max: f32,
    /// Whether only whole numbers make sense.
    pub integer: bool,
    /// The uniform buffer.
    pub uniform: &'static str,
    /// The member of its struct.
    pub member: String,
    /// Offset in the buffer, in bytes, of a 32-bit float.
    pub offset: u32,
}

/// A bound resource.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Bound {
    /// The variable of the WGSL source.
    pub name: &'static str,
    /// The bind group.
    pub group: u32,
    /// The number in the bind group.
    pub binding: u32,
    /// The kind: `uniform`, `storage`, `texture` or `sampler`.
    pub kind: &'static str,
    /// The type in WGSL.
    #[serde(rename = "type")]
    pub of: String,
    /// The content, in words.
    pub holds: &'static str,
    /// The stages that read it: `vertex`, `fragment`.
    pub stages: Vec<&'static str>,
    /// For a texture, requirements on its texels.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub texture: Option<TextureNeed>,
    /// For a buffer, its struct or the struct of its elements.
    #[serde(rename = "struct", skip_serializing_if = "Option::is_none")]
    pub structure: Option<String>,
}

/// Requirements on a texture.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TextureNeed {
    /// `2d` or `2d-array`.
    pub dimension: &'static str,
    /// The formats that it may have, in WebGPU's names; the first holds values as they are baked.
    pub formats: &'static [&'static str],
    /// Whether a sampler filters it.
    pub filtered: bool,
    /// Number of levels, as a number, an expression over the settings, or a sentence.
    pub levels: String,
    /// Number of layers, as a number, an expression over the settings, or a sentence.
    pub layers: String,
    /// The baked map that fills it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bake: Option<Bake>,
}

/// A baked map.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Bake {
    /// The kind of map.
    pub kind: &'static str,
    /// The texture's name among the kind's; empty for its only one.
    pub texture: &'static str,
    /// The kind's settings that are required.
    pub settings: BTreeMap<&'static str, f32>,
    /// The most texels of the longer side of the height map's level that it is baked from; the
    /// finest such level is taken. None: it is baked from the height map itself.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub side: Option<u32>,
    /// The unit of lengths: `texture` units, or the metres of the surface.
    pub metric: &'static str,
    /// Instructions for baking, in the words of the program that exported.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub how: Option<String>,
}

/// A struct in a buffer.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Struct {
    /// Size in bytes, which is also the stride in an array.
    pub size: u32,
    /// The members, in order.
    pub members: Vec<Member>,
}

/// A member of a struct.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Member {
    /// The member's name.
    pub name: String,
    /// Offset from the beginning of the struct, in bytes.
    pub offset: u32,
    /// Size in bytes.
    pub size: u32,
    /// The type in WGSL; for an array the type of its elements.
    #[serde(rename = "type")]
    pub of: String,
    /// For an array, the number of elements and their stride.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub array: Option<ArrayLayout>,
}

/// The layout of an array in a struct.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct ArrayLayout {
    /// Number of elements.
    pub count: u32,
    /// Bytes from one element to the next.
    pub stride: u32,
}

/// The files of a target.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TargetFiles {
    /// The target.
    pub target: &'static str,
    /// The profile.
    pub profile: &'static str,
    /// The files.
    pub files: Vec<ShaderFile>,
}

/// A file of a shader.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ShaderFile {
    /// The file's name.
    pub file: String,
    /// The entry points of a pipeline, under their names in this file.
    pub entry_points: Vec<EntryPoint>,
    /// The bindings, under their names in this file.
    pub bindings: Vec<FileBinding>,
    /// The buffer from which Metal shaders read the sizes of other buffers.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sizes: Option<SizesBuffer>,
}

/// An entry point of a pipeline.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct EntryPoint {
    /// `vertex` or `fragment`.
    pub stage: &'static str,
    /// The function.
    pub name: String,
}

/// A binding in a file.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FileBinding {
    /// The variable of the WGSL source.
    pub name: &'static str,
    /// The name in this file.
    #[serde(rename = "as")]
    pub here: String,
    /// The binding point.
    #[serde(flatten)]
    pub at: BindingPoint,
    /// In GLSL, the sampler whose wrap and filter the texture must have.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sampler: Option<&'static str>,
}

/// A binding point, in a target's terms.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(untagged)]
pub enum BindingPoint {
    /// WGSL.
    Group {
        /// The bind group.
        group: u32,
        /// The number in it.
        binding: u32,
    },
    /// SPIR-V.
    Set {
        /// The descriptor set.
        set: u32,
        /// The number in it.
        binding: u32,
    },
    /// GLSL. OpenGL counts each kind by itself, but no number stands twice.
    Binding {
        /// The number.
        binding: u32,
    },
    /// HLSL.
    Register {
        /// The register, as in `t3`.
        register: String,
        /// The register space.
        space: u32,
    },
    /// MSL: a buffer.
    Buffer {
        /// The buffer's index.
        buffer: u32,
    },
    /// MSL: a texture.
    Texture {
        /// The texture's index.
        texture: u32,
    },
    /// MSL: a sampler.
    Sampler {
        /// The sampler's index.
        sampler_state: u32,
    },
}

/// A buffer of 32-bit numbers: the sizes in bytes of other buffers, as bound.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct SizesBuffer {
    /// The buffer's index.
    pub buffer: u32,
    /// The buffers whose sizes it holds, in order.
    pub of: Vec<&'static str>,
}
