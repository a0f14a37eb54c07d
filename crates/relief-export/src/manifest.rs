//! What an export says of itself to programs: the same as its heads say to people.

use std::collections::BTreeMap;

use serde::Serialize;

/// An export. Its JSON is `NAME.json`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Manifest {
    /// What the files are called before their endings.
    pub name: String,
    /// The version of relief that wrote it.
    pub relief: String,
    /// How textures are read: `exact` or `fast`.
    pub sampling: &'static str,
    /// How it is drawn.
    pub draw: Draw,
    /// What is run, stage by stage.
    pub stages: Vec<ChosenStage>,
    /// What is bound, under the names of the WGSL source.
    pub bindings: Vec<Bound>,
    /// The structs of the buffers, by name.
    pub structs: BTreeMap<String, Struct>,
    /// The files, target by target.
    pub targets: Vec<Written>,
}

/// How the entry points are drawn: triangles without vertex buffers.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Draw {
    /// Vertices for each triangle of the mesh.
    pub vertices_per_triangle: u32,
    /// 1; 2 also draws the backs of a two-sided mesh.
    pub instances: &'static str,
    /// Which faces are culled: `back`, of a two-sided mesh none; `front`; or `none`.
    pub cull: &'static str,
    /// The winding of front faces, as they are seen in the picture.
    pub front_face: &'static str,
    /// Whether fragments write depth.
    pub depth: bool,
}

/// The variant that a stage runs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ChosenStage {
    /// The stage's key.
    pub stage: &'static str,
    /// The variant.
    pub name: &'static str,
    /// What it does.
    pub summary: &'static str,
    /// Where it was published.
    pub published: String,
    /// Its parameters, each a number in a uniform buffer.
    pub params: Vec<ParamPlace>,
}

/// A parameter of a variant.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ParamPlace {
    /// Its name.
    pub name: &'static str,
    /// What it does.
    pub summary: &'static str,
    /// Its unit; empty for plain numbers.
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
    /// Where it lies in the buffer, in bytes; a 32-bit float.
    pub offset: u32,
}

/// Something bound.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Bound {
    /// The variable of the WGSL source.
    pub name: &'static str,
    /// Its bind group.
    pub group: u32,
    /// Its number there.
    pub binding: u32,
    /// What it is: `uniform`, `storage`, `texture` or `sampler`.
    pub kind: &'static str,
    /// Its type in WGSL.
    #[serde(rename = "type")]
    pub of: String,
    /// What it holds, for people.
    pub holds: &'static str,
    /// The stages that read it: `vertex`, `fragment`.
    pub stages: Vec<&'static str>,
    /// Of a texture, what is known of its texels.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub texture: Option<TextureNeed>,
    /// Of a buffer, the struct or its elements.
    #[serde(rename = "struct", skip_serializing_if = "Option::is_none")]
    pub structure: Option<String>,
}

/// What a texture must be.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TextureNeed {
    /// `2d` or `2d-array`.
    pub dimension: &'static str,
    /// The formats that it may have, in WebGPU's names; the first holds values as they are baked.
    pub formats: &'static [&'static str],
    /// Whether a sampler filters it.
    pub filtered: bool,
    /// How many levels it has.
    pub levels: String,
    /// How many layers it has.
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
    /// Its texture among those of the kind; empty for the only one.
    pub texture: &'static str,
    /// The kind's settings that it needs.
    pub settings: BTreeMap<&'static str, f32>,
    /// The most texels of the longer side of the height map's level that it is baked from: of the finest such
    /// level. None: it is baked from the height map itself.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub side: Option<u32>,
    /// In what it is baked: `texture` units, or the metres of the surface.
    pub metric: &'static str,
    /// How it is baked, in the words of the program that exported.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub how: Option<String>,
}

/// A struct in a buffer.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Struct {
    /// Its bytes, and those from one to the next in an array.
    pub size: u32,
    /// Its members, in order.
    pub members: Vec<Member>,
}

/// A member of a struct.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Member {
    /// Its name.
    pub name: String,
    /// Where it begins, in bytes from the struct.
    pub offset: u32,
    /// Its bytes.
    pub size: u32,
    /// Its type in WGSL: of an array that of its elements.
    #[serde(rename = "type")]
    pub of: String,
    /// Of an array how many elements, and the bytes from one to the next.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub array: Option<Repeated>,
}

/// An array in a struct.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Repeated {
    /// How many elements.
    pub count: u32,
    /// The bytes from one to the next.
    pub stride: u32,
}

/// What was written for a target.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Written {
    /// The target.
    pub target: &'static str,
    /// The profile.
    pub profile: &'static str,
    /// Its files.
    pub files: Vec<ShaderFile>,
}

/// A file of a shader.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ShaderFile {
    /// Its name.
    pub file: String,
    /// The functions that a pipeline begins with, under their names in this file.
    pub entry_points: Vec<EntryPoint>,
    /// What is bound, under its name in this file.
    pub bindings: Vec<Renamed>,
    /// The buffer that Metal shaders take the sizes of other buffers from.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sizes: Option<SizesBuffer>,
}

/// Where a pipeline begins.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct EntryPoint {
    /// `vertex` or `fragment`.
    pub stage: &'static str,
    /// The function.
    pub name: String,
}

/// A binding as a file has it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Renamed {
    /// The variable of the WGSL source.
    pub name: &'static str,
    /// What it is called here.
    #[serde(rename = "as")]
    pub here: String,
    /// Where it is bound.
    #[serde(flatten)]
    pub at: At,
    /// In GLSL, the sampler whose wrap and filter the texture is to have.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sampler: Option<&'static str>,
}

/// Where something is bound.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(untagged)]
pub enum At {
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
    /// GLSL: each kind is counted by OpenGL for itself, but no number stands twice.
    Binding {
        /// The number.
        binding: u32,
    },
    /// HLSL.
    Register {
        /// The register, as in `t3`.
        register: String,
        /// Its space.
        space: u32,
    },
    /// MSL: a buffer.
    Buffer {
        /// Its index.
        buffer: u32,
    },
    /// MSL: a texture.
    Texture {
        /// Its index.
        texture: u32,
    },
    /// MSL: a sampler.
    Sampler {
        /// Its index.
        sampler_state: u32,
    },
}

/// A buffer of 32-bit numbers: the bytes of other buffers, as far as they are bound.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct SizesBuffer {
    /// Its index.
    pub buffer: u32,
    /// Of which buffers, in order.
    pub of: Vec<&'static str>,
}
