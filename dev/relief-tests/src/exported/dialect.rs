//! Languages in which functions are called: their statements, and the compute shader around these.

use super::numbers::RESULT;

/// Invocations of a workgroup.
pub(super) const GROUP: usize = 64;

/// A language in which functions are called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dialect {
    /// As it is.
    Wgsl,
    /// GLSL of Vulkan, compiled to SPIR-V by somebody else's compiler.
    Glsl,
    /// The same.
    Hlsl,
    /// HLSL of Unreal's materials, whose functions are methods of a struct.
    Unreal,
}

impl Dialect {
    /// A statement of WGSL in this language: declarations of one of these types, and vectors.
    pub(super) fn statement(self, text: &str, constructs: &str) -> String {
        let vectors = |text: String, of: [&str; 3]| {
            let names = ["vec2f(", "vec3f(", "vec4f("];
            names.iter().zip(of).fold(text, |text, (from, to)| text.replace(from, &format!("{to}(")))
        };
        let numbers = |text: &str| text.replace("f32(", "float(").replace("u32(", "uint(");
        match self {
            Dialect::Wgsl => text.to_owned(),
            Dialect::Glsl => vectors(numbers(text), ["vec2", "vec3", "vec4"]),
            Dialect::Hlsl | Dialect::Unreal => {
                let text = text.replace(&format!("{constructs}("), &format!("Construct{constructs}("));
                vectors(numbers(&text), ["float2", "float3", "float4"])
            }
        }
    }

    /// The declaration of a value of a type.
    pub(super) fn declared(self, name: &str, of: &str, value: &str) -> String {
        match self {
            Dialect::Wgsl => format!("let {name} = {value};"),
            Dialect::Glsl | Dialect::Hlsl | Dialect::Unreal => format!("{of} {name} = {value};"),
        }
    }
}

pub(super) fn wgsl(functions: &str, settings: &str, body: &str, count: usize) -> String {
    format!(
        "{functions}\n@group(1) @binding(0) var<storage, read> given: array<f32>;\n\
         @group(1) @binding(1) var<storage, read_write> results: array<f32>;\n\
         @group(1) @binding(2) var<uniform> own_settings: {settings};\n\n\
         var<private> first: u32;\n\nfn number_at(place: u32) -> f32 {{\n    \
         return given[first + place];\n}}\n\n\
         @compute @workgroup_size({GROUP})\n\
         fn main(@builtin(global_invocation_id) id: vec3u) {{\n    \
         if (id.x * {count}u >= arrayLength(&given)) {{\n        return;\n    }}\n    \
         first = id.x * {count}u;\n    let out_at = id.x * {RESULT}u;\n    {body}\n}}\n"
    )
}

pub(super) fn glsl(functions: &str, settings: &str, body: &str, count: usize) -> String {
    // The device has textures without samplers, as texels alone are loaded.
    let functions = functions.replace("sampler2D", "texture2D");
    format!(
        "#version 450\n#extension GL_EXT_samplerless_texture_functions : require\n{functions}\n\
         layout(local_size_x = {GROUP}) in;\n\
         layout(set = 1, binding = 0) readonly buffer Given {{ float given[]; }};\n\
         layout(set = 1, binding = 1) buffer Results {{ float results[]; }};\n\
         layout(set = 1, binding = 2) uniform Own {{ {settings} own_settings; }};\n\
         uint first;\nfloat number_at(uint place) {{ return given[first + place]; }}\n\
         void main() {{\n    uint invocation = gl_GlobalInvocationID.x;\n    \
         if (invocation * {count}u >= given.length()) {{ return; }}\n    first = invocation * {count}u;\n    \
         uint out_at = invocation * {RESULT}u;\n    {body}\n}}\n"
    )
}

pub(super) fn hlsl(functions: &str, settings: &str, body: &str, count: usize) -> String {
    format!(
        "{functions}\nStructuredBuffer<float> given : register(t0, space1);\n\
         RWStructuredBuffer<float> results : register(u1, space1);\n\
         cbuffer Own : register(b2, space1) {{ {settings} own_settings; }}\n\
         static uint first;\nfloat number_at(uint place) {{ return given[first + place]; }}\n\
         [numthreads({GROUP}, 1, 1)]\nvoid main(uint3 id : SV_DispatchThreadID) {{\n    \
         uint all;\n    uint stride;\n    given.GetDimensions(all, stride);\n    \
         if (id.x * {count}u >= all) {{ return; }}\n    first = id.x * {count}u;\n    \
         uint out_at = id.x * {RESULT}u;\n    {body}\n}}\n"
    )
}

/// A text without the functions that take derivatives, which compute shaders have not.
pub(super) fn without_derivatives(text: &str) -> String {
    let mut kept = String::new();
    let mut rest = text;
    while let Some(end) = rest.find("\n}\n") {
        let (declared, after) = rest.split_at(end + 3);
        let takes = ["dFdx(", "ddx(", "ddx_coarse("].iter().any(|name| declared.contains(name));
        if !takes {
            kept += declared;
        }
        rest = after;
    }
    kept + rest
}
