//! Functions of exports, called for many paths or points by a compute pass of the tests' own.

use std::sync::Arc;

use relief_core::HeightMap;
use relief_export::ExportedFunctions;
use relief_export::functions::FunctionsManifest;
use relief_render::gpu::Prober;
use relief_render::job::JobSurface;
use relief_render::wgpu::{self, TextureViewDimension, util::DeviceExt};
use relief_shaders::Selection;
use relief_shaders::cpu::{Frame, Hit, Path, PixelIn, SurfaceSettings};
use relief_shaders::wgsl::Sampling;

use super::Device;
use super::bound::{texels_of, view_of};
use super::include::{self, Include};
use crate::baked::maps_for;
use crate::compilers::{GLSLANG, run};
use crate::one_source::cases::bare_surface;

/// Invocations of a workgroup.
const GROUP: usize = 64;

/// A point of a mesh, as `ReliefPoint` has it, and the direction toward a light.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// Texture coordinates.
    pub uv: [f32; 2],
    /// Unit direction from the eye.
    pub view: [f32; 3],
    /// Length of a tile along u and v.
    pub tile: [f32; 2],
    /// Coefficients of the mesh beside the point.
    pub curvature: [f32; 3],
    /// Width of the pixel, in texels.
    pub footprint: f32,
    /// Unit direction toward the light.
    pub toward: [f32; 3],
}

/// What `ReliefHit` says of a point, and how much of the light arrives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen {
    /// Whether the ray hits.
    pub hit: bool,
    /// The hit's texture coordinates.
    pub uv: [f32; 2],
    /// Its height.
    pub height: f32,
    /// The way from the point to the hit.
    pub depth: f32,
    /// The unit normal.
    pub normal: [f32; 3],
    /// The part of the light that arrives.
    pub light: f32,
}

/// What `ReliefTriangleHit` says of a ray at a triangle, and how much of the light arrives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeenOver {
    /// Whether the ray hits.
    pub hit: bool,
    /// The hit's texture coordinates.
    pub uv: [f32; 2],
    /// The way to the hit, in lengths of the ray's direction.
    pub depth: f32,
    /// The hit, in the triangle's space.
    pub position: [f32; 3],
    /// The unit normal along the direction to the light.
    pub facing: f32,
    /// The part of the light that arrives.
    pub light: f32,
}

/// The result of search and refinement: whether something is found, the place, and the parameter.
#[derive(Clone, Copy, Debug)]
pub struct OnPath {
    /// Whether something is found.
    pub found: bool,
    /// Its texture coordinates.
    pub uv: [f32; 2],
    /// Its parameter.
    pub t: f32,
}

/// The most cells or steps that a stage may take: see `one_source`.
const LONGEST_LOOP: f64 = 16_384.0;

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
    fn declared(self, name: &str, of: &str, value: &str) -> String {
        match self {
            Dialect::Wgsl => format!("let {name} = {value};"),
            Dialect::Glsl | Dialect::Hlsl | Dialect::Unreal => format!("{of} {name} = {value};"),
        }
    }
}

/// Members of a path and where they lie among its numbers.
const PATH: [(&str, &str); 11] = [
    ("uv", "vec2f(number_at(0u), number_at(1u))"),
    ("duv", "vec2f(number_at(2u), number_at(3u))"),
    ("h", "vec3f(number_at(4u), number_at(5u), number_at(6u))"),
    ("exit", "number_at(7u)"),
    ("base", "number_at(8u)"),
    ("metric", "vec4f(number_at(9u), number_at(10u), number_at(11u), number_at(12u))"),
    ("ray", "u32(number_at(13u))"),
    ("level", "u32(number_at(14u))"),
    ("start", "number_at(15u)"),
    ("share", "number_at(16u)"),
    ("bend", "number_at(17u)"),
];

/// Members of a point and where they lie among its numbers.
pub(super) const POINTS: [(&str, &str); 5] = [
    ("uv", "vec2f(number_at(0u), number_at(1u))"),
    ("view", "vec3f(number_at(2u), number_at(3u), number_at(4u))"),
    ("tile", "vec2f(number_at(5u), number_at(6u))"),
    ("curvature", "vec3f(number_at(7u), number_at(8u), number_at(9u))"),
    ("footprint", "number_at(10u)"),
];

/// Members of a ray and where they lie among the numbers of a triangle.
const RAY: [(&str, &str); 4] = [
    ("origin", "vec3f(number_at(0u), number_at(1u), number_at(2u))"),
    ("direction", "vec3f(number_at(3u), number_at(4u), number_at(5u))"),
    ("side", "number_at(6u)"),
    ("footprint", "0.0"),
];

/// Numbers of a path, of a point, of a ray, of a corner, of a triangle with its ray and a light, and of what
/// comes out.
pub(super) const NUMBERS_OF_PATH: usize = 18;
pub(super) const POINT: usize = 14;
const NUMBERS_OF_RAY: usize = 7;
const CORNER: usize = 17;
const TRIANGLE: usize = NUMBERS_OF_RAY + 3 * CORNER + 6 + 3;
pub(super) const RESULT: usize = 9;

impl Device {
    /// Runs search and refinement of functions over paths, in a language. The first file of the export is
    /// WGSL, the second that language.
    ///
    /// # Panics
    ///
    /// When the functions are none that this device runs.
    pub fn traced(
        &self,
        exported: &ExportedFunctions,
        surface: &JobSurface,
        paths: &[Path],
        dialect: Dialect,
    ) -> Vec<OnPath> {
        let body = body_of_paths(exported, dialect);
        let numbers: Vec<f32> = paths.iter().flat_map(numbers_of).collect();
        let results = self.called(exported, surface, &body, NUMBERS_OF_PATH, &numbers, dialect);
        let found = |of: &[f32]| OnPath { found: of[0] != 0.0, uv: [of[1], of[2]], t: of[3] };
        results.chunks_exact(RESULT).map(found).collect()
    }

    /// Runs the functions over points.
    ///
    /// # Panics
    ///
    /// When the functions are none that this device runs.
    pub fn seen(&self, exported: &ExportedFunctions, surface: &JobSurface, points: &[Point]) -> Vec<Seen> {
        let text = text_of(exported);
        let prefix = &exported.manifest.prefix;
        let point = made(&text, &type_of(exported, "Point"), &POINTS);
        let light = if text.contains(&format!("fn {prefix}_light(")) {
            format!(
                "{prefix}_light(settings, at, hit, vec3f(number_at(11u), number_at(12u), number_at(13u)))"
            )
        } else {
            "1.0".to_owned()
        };
        let body = format!(
            "let settings = own_settings;\n    let at = {point};\n    let hit = {prefix}_hit(settings, at);\n    \
             var light = 0.0;\n    if (hit.hit) {{\n        light = {light};\n    }}\n    \
             results[out_at] = select(0.0, 1.0, hit.hit);\n    results[out_at + 1u] = hit.uv.x;\n    \
             results[out_at + 2u] = hit.uv.y;\n    results[out_at + 3u] = hit.height;\n    \
             results[out_at + 4u] = hit.depth;\n    results[out_at + 5u] = hit.normal.x;\n    \
             results[out_at + 6u] = hit.normal.y;\n    results[out_at + 7u] = hit.normal.z;\n    \
             results[out_at + 8u] = light;"
        );
        let numbers: Vec<f32> = points.iter().flat_map(numbers_of_point).collect();
        let results = self.called(exported, surface, &body, POINT, &numbers, Dialect::Wgsl);
        let seen = |of: &[f32]| Seen {
            hit: of[0] != 0.0,
            uv: [of[1], of[2]],
            height: of[3],
            depth: of[4],
            normal: [of[5], of[6], of[7]],
            light: of[8],
        };
        results.chunks_exact(RESULT).map(seen).collect()
    }

    /// Runs the functions over triangles, each with its ray and the direction to a light.
    ///
    /// # Panics
    ///
    /// When the functions are none that this device runs.
    pub fn seen_over(
        &self,
        exported: &ExportedFunctions,
        surface: &JobSurface,
        rays: &[(PixelIn, [f32; 3])],
    ) -> Vec<SeenOver> {
        let text = text_of(exported);
        let prefix = &exported.manifest.prefix;
        let ray = made(&text, &type_of(exported, "Ray"), &RAY);
        let triangle = triangle_of(&text, exported);
        let toward = vector(TRIANGLE - 3, 3);
        let light = if text.contains(&format!("fn {prefix}_triangle_light(")) {
            format!("{prefix}_triangle_light(settings, ray, hit, {toward})")
        } else {
            "1.0".to_owned()
        };
        let body = format!(
            "let settings = own_settings;\n    let ray = {ray};\n    let at = {triangle};\n    \
             let hit = {prefix}_triangle_hit(settings, at, ray);\n    var light = 0.0;\n    \
             if (hit.hit) {{\n        light = {light};\n    }}\n    \
             results[out_at] = select(0.0, 1.0, hit.hit);\n    results[out_at + 1u] = hit.uv.x;\n    \
             results[out_at + 2u] = hit.uv.y;\n    results[out_at + 3u] = hit.depth;\n    \
             results[out_at + 4u] = hit.position.x;\n    results[out_at + 5u] = hit.position.y;\n    \
             results[out_at + 6u] = hit.position.z;\n    results[out_at + 7u] = dot(hit.normal, {toward});\n    \
             results[out_at + 8u] = light;"
        );
        let numbers: Vec<f32> = rays.iter().flat_map(numbers_of_triangle).collect();
        let results = self.called(exported, surface, &body, TRIANGLE, &numbers, Dialect::Wgsl);
        let seen = |of: &[f32]| SeenOver {
            hit: of[0] != 0.0,
            uv: [of[1], of[2]],
            depth: of[3],
            position: [of[4], of[5], of[6]],
            facing: of[7],
            light: of[8],
        };
        results.chunks_exact(RESULT).map(seen).collect()
    }

    /// Runs a body of statements once for each `count` numbers, which `of` gives.
    fn called(
        &self,
        exported: &ExportedFunctions,
        surface: &JobSurface,
        body: &str,
        count: usize,
        numbers: &[f32],
        dialect: Dialect,
    ) -> Vec<f32> {
        let Self { device, queue } = self;
        let module = self.module(exported, body, count, dialect);
        let views: Vec<_> = exported
            .manifest
            .bindings
            .iter()
            .map(|bound| {
                let name = bound.name.trim_start_matches(&format!("{}_", exported.manifest.prefix));
                let has_layers = bound.of.contains("array");
                let dimension =
                    if has_layers { TextureViewDimension::D2Array } else { TextureViewDimension::D2 };
                (bound.binding, view_of(device, queue, &texels_of(name, surface), dimension), dimension)
            })
            .collect();
        let textures = views.iter().map(|(binding, view, _)| wgpu::BindGroupEntry {
            binding: *binding,
            resource: wgpu::BindingResource::TextureView(view),
        });
        let textures: Vec<_> = textures.collect();
        // What a body does not read is bound all the same.
        let of_texture = |(binding, _, dimension): &(u32, _, TextureViewDimension)| {
            let ty = wgpu::BindingType::Texture {
                sample_type: wgpu::TextureSampleType::Float { filterable: false },
                view_dimension: *dimension,
                multisampled: false,
            };
            laid_out(*binding, ty)
        };
        let buffer_of =
            |ty| wgpu::BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None };
        let kinds = [
            wgpu::BufferBindingType::Storage { read_only: true },
            wgpu::BufferBindingType::Storage { read_only: false },
            wgpu::BufferBindingType::Uniform,
        ];
        let of_buffers: Vec<_> =
            (0..).zip(kinds).map(|(binding, kind)| laid_out(binding, buffer_of(kind))).collect();
        let of_textures: Vec<_> = views.iter().map(of_texture).collect();
        let layouts = [&of_textures, &of_buffers].map(|entries| {
            let descriptor = wgpu::BindGroupLayoutDescriptor { label: None, entries };
            device.create_bind_group_layout(&descriptor)
        });
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: None,
            bind_group_layouts: &[Some(&layouts[0]), Some(&layouts[1])],
            immediate_size: 0,
        });
        let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: None,
            layout: Some(&layout),
            module: &module,
            entry_point: Some("main"),
            compilation_options: Default::default(),
            cache: None,
        });
        let bytes =
            |numbers: &[f32]| numbers.iter().flat_map(|number| number.to_le_bytes()).collect::<Vec<u8>>();
        let buffer = |contents: &[u8], usage| {
            device.create_buffer_init(&wgpu::util::BufferInitDescriptor { label: None, contents, usage })
        };
        let invocations = numbers.len() / count;
        let usage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC;
        let results = buffer(&vec![0; 4 * RESULT * invocations], usage);
        let given = buffer(&bytes(numbers), wgpu::BufferUsages::STORAGE);
        let own = buffer(&settings_of(&exported.manifest, &surface.settings), wgpu::BufferUsages::UNIFORM);
        let group = |layout: &wgpu::BindGroupLayout, entries: &[wgpu::BindGroupEntry<'_>]| {
            device.create_bind_group(&wgpu::BindGroupDescriptor { label: None, layout, entries })
        };
        let of = |binding, buffer: &wgpu::Buffer| (binding, buffer.clone());
        let buffers = [of(0, &given), of(1, &results), of(2, &own)];
        let buffers: Vec<_> = buffers
            .iter()
            .map(|(binding, buffer)| wgpu::BindGroupEntry {
                binding: *binding,
                resource: buffer.as_entire_binding(),
            })
            .collect();
        let groups = [group(&layouts[0], &textures), group(&layouts[1], &buffers)];
        let readable = device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: results.size(),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = device.create_command_encoder(&Default::default());
        let mut pass = encoder.begin_compute_pass(&Default::default());
        pass.set_pipeline(&pipeline);
        for (number, group) in (0..).zip(&groups) {
            pass.set_bind_group(number, group, &[]);
        }
        pass.dispatch_workgroups(invocations.div_ceil(GROUP) as u32, 1, 1);
        drop(pass);
        encoder.copy_buffer_to_buffer(&results, 0, &readable, 0, results.size());
        queue.submit([encoder.finish()]);
        readable.map_async(wgpu::MapMode::Read, .., |mapped| mapped.expect("the numbers are readable"));
        device.poll(wgpu::PollType::wait_indefinitely()).expect("the device works");
        let bytes = readable.get_mapped_range(..).expect("the numbers are mapped");
        bytes.as_chunks().0.iter().map(|bytes| f32::from_le_bytes(*bytes)).collect()
    }
}

impl Device {
    /// The compute shader around a body.
    fn module(
        &self,
        exported: &ExportedFunctions,
        body: &str,
        count: usize,
        dialect: Dialect,
    ) -> wgpu::ShaderModule {
        let settings = type_of(exported, "Settings");
        if dialect == Dialect::Wgsl {
            return self.wgsl(wgsl(&text_of(exported), &settings, body, count).as_bytes());
        }
        let file = &exported.files[1];
        let text = String::from_utf8(file.bytes.clone()).expect("a text");
        if dialect == Dialect::Unreal {
            let include = Include::new(&text);
            let [text, body] = include.in_compute(body);
            let words = include::compiled(&hlsl(&text, &settings, &body, count), "comp");
            return self.spirv(&words.unwrap_or_else(|error| panic!("{}: {error}", file.name)), "main");
        }
        let text = without_derivatives(&text);
        let (text, flags) = match dialect {
            Dialect::Glsl => (glsl(&text, &settings, body, count), &["-V", "-S", "comp"][..]),
            _ => (hlsl(&text, &settings, body, count), &["-D", "-V", "-Od", "-S", "comp", "-e", "main"][..]),
        };
        let folder = tempfile::tempdir().expect("a temporary folder");
        std::fs::write(folder.path().join("given"), text).expect("the folder is writable");
        run(folder.path(), GLSLANG, flags.iter().chain(&["-o", "out.spv", "given"]))
            .unwrap_or_else(|error| panic!("{}: {error}", file.name));
        self.spirv(&std::fs::read(folder.path().join("out.spv")).expect("it was compiled"), "main")
    }
}

/// The statements that search and refine a path, in a language. The first file of the export is WGSL.
///
/// # Panics
///
/// When the functions do not search and refine.
pub fn body_of_paths(exported: &ExportedFunctions, dialect: Dialect) -> String {
    let text = text_of(exported);
    let found = text.split("let found = ").nth(1).and_then(|rest| rest.split(';').next());
    // WGSL alone has commas behind the last argument.
    let found = found.expect("it searches and refines").split_whitespace().collect::<Vec<_>>().join(" ");
    let found = found.replace(", )", ")");
    let [path, hit] = [type_of(exported, "Path"), type_of(exported, "TracedHit")];
    let made = dialect.statement(&made(&text, &path, &PATH), &path);
    format!(
        "{}\n    {}\n    {}\n    results[out_at] = {}(found.found);\n    results[out_at + 1u] = found.uv.x;\n    \
         results[out_at + 2u] = found.uv.y;\n    results[out_at + 3u] = found.t;",
        dialect.declared("settings", &type_of(exported, "Settings"), "own_settings"),
        dialect.declared("path", &path, &made),
        dialect.declared("found", &hit, &found),
        if dialect == Dialect::Wgsl { "f32" } else { "float" },
    )
}

fn wgsl(functions: &str, settings: &str, body: &str, count: usize) -> String {
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

fn glsl(functions: &str, settings: &str, body: &str, count: usize) -> String {
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

fn hlsl(functions: &str, settings: &str, body: &str, count: usize) -> String {
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
fn without_derivatives(text: &str) -> String {
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

/// A binding of compute passes.
fn laid_out(binding: u32, ty: wgpu::BindingType) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry { binding, visibility: wgpu::ShaderStages::COMPUTE, ty, count: None }
}

/// The WGSL of an export.
fn text_of(exported: &ExportedFunctions) -> String {
    String::from_utf8(exported.files[0].bytes.clone()).expect("a text")
}

/// A type's name, with the prefix.
pub(super) fn type_of(exported: &ExportedFunctions, name: &str) -> String {
    let (first, rest) = exported.manifest.prefix.split_at(1);
    format!("{}{rest}{name}", first.to_uppercase())
}

/// A value of a struct, from what stands for each of its members.
pub(super) fn made(text: &str, name: &str, known: &[(&str, &str)]) -> String {
    let declared = text.split(&format!("struct {name} {{\n")).nth(1).expect("a struct");
    let members = declared.lines().take_while(|line| !line.starts_with('}'));
    let members = members.map(str::trim).filter(|line| !line.starts_with("//"));
    let members = members.filter_map(|line| line.split(':').next()).map(|member| {
        let (_, value) = known.iter().find(|(name, _)| *name == member).expect("a known member");
        *value
    });
    format!("{name}({})", members.collect::<Vec<_>>().join(", "))
}

/// A vector of the numbers from a place on.
fn vector(place: usize, count: usize) -> String {
    let numbers: Vec<String> = (place..place + count).map(|place| format!("number_at({place}u)")).collect();
    format!("vec{count}f({})", numbers.join(", "))
}

/// The triangle of the functions, from its numbers.
fn triangle_of(text: &str, exported: &ExportedFunctions) -> String {
    let corner = |number: usize| {
        let begin = NUMBERS_OF_RAY + CORNER * number;
        let members =
            [("position", 0, 3), ("normal", 3, 3), ("tangent", 6, 3), ("bitangent", 9, 3), ("uv", 12, 2)];
        let mut known: Vec<(&str, String)> =
            members.map(|(name, place, count)| (name, vector(begin + place, count))).to_vec();
        known.push(("of_surface", vector(begin + 14, 3)));
        let known: Vec<(&str, &str)> = known.iter().map(|(name, value)| (*name, value.as_str())).collect();
        made(text, &type_of(exported, "Corner"), &known)
    };
    let begin = NUMBERS_OF_RAY + 3 * CORNER;
    let [heights, order, lift] =
        [vector(begin, 2), format!("u32(number_at({}u))", begin + 2), vector(begin + 3, 3)];
    // Surfaces that need nothing of the space above have no such struct.
    let shell = if text.contains(&format!("struct {} {{", type_of(exported, "Shell"))) {
        let known = [("heights", heights.as_str()), ("order", order.as_str()), ("lift", lift.as_str())];
        made(text, &type_of(exported, "Shell"), &known)
    } else {
        String::new()
    };
    let corners = [0, 1, 2].map(corner);
    let known = [("a", &corners[0]), ("b", &corners[1]), ("c", &corners[2]), ("shell", &shell)];
    made(text, &type_of(exported, "Triangle"), &known.map(|(name, value)| (name, value.as_str())))
}

fn numbers_of_triangle((pixel, toward): &(PixelIn, [f32; 3])) -> Vec<f32> {
    let PixelIn { origin, direction, side, a, b, c, shell } = *pixel;
    let of = |v: relief_shaders::cpu::Vec3<f32>| [v.x, v.y, v.z];
    let mut numbers = [&of(origin)[..], &of(direction), &[side]].concat();
    for corner in [a, b, c] {
        for part in [corner.position, corner.normal, corner.tangent, corner.bitangent] {
            numbers.extend(of(part));
        }
        numbers.extend([corner.uv.x, corner.uv.y]);
        numbers.extend(of(corner.of_surface));
    }
    numbers.extend([shell.heights.x, shell.heights.y, shell.order as f32]);
    numbers.extend(of(shell.lift));
    numbers.extend(toward);
    numbers
}

pub(super) fn numbers_of_point(point: &Point) -> [f32; POINT] {
    let Point { uv, view, tile, curvature, footprint, toward } = *point;
    let ([u, v], [x, y, z], [along_u, along_v]) = (uv, view, tile);
    let ([uu, uv, vv], [toward_x, toward_y, toward_z]) = (curvature, toward);
    [u, v, x, y, z, along_u, along_v, uu, uv, vv, footprint, toward_x, toward_y, toward_z]
}

pub(super) fn numbers_of(path: &Path) -> [f32; NUMBERS_OF_PATH] {
    let Path { uv, duv, h, exit, base, metric, ray, level, start, share, bend } = *path;
    [
        uv.x,
        uv.y,
        duv.x,
        duv.y,
        h.x,
        h.y,
        h.z,
        exit,
        base,
        metric.x,
        metric.y,
        metric.z,
        metric.w,
        ray as f32,
        level as f32,
        start,
        share,
        bend,
    ]
}

/// The settings' bytes, as the manifest lays them out.
pub(super) fn settings_of(manifest: &FunctionsManifest, settings: &SurfaceSettings) -> Vec<u8> {
    let mut bytes = vec![0; (manifest.settings_size as usize).next_multiple_of(16)];
    for place in &manifest.settings {
        let words: Vec<u32> = match (place.name.as_str(), place.value) {
            (_, Some(value)) => vec![value.to_bits()],
            ("scale", _) => vec![settings.scale_m.to_bits()],
            ("bias", _) => vec![settings.bias_m.to_bits()],
            ("height_size", _) => vec![settings.height_size.x, settings.height_size.y],
            ("height_levels", _) => vec![settings.height_levels],
            ("mean_height", _) => vec![settings.mean_height.to_bits()],
            ("wrap", _) => vec![settings.wrap],
            ("light_radius", _) => vec![0],
            ("shell", _) => vec![settings.shell_m.x.to_bits(), settings.shell_m.y.to_bits()],
            ("search_layers", _) => vec![settings.maps[1].layers],
            ("shadow_tile", _) => {
                vec![settings.maps[3].tile_m.x.to_bits(), settings.maps[3].tile_m.y.to_bits()]
            }
            (other, _) => panic!("there is no setting {other} here"),
        };
        for (word, at) in words.iter().zip(bytes[place.offset as usize..].chunks_exact_mut(4)) {
            at.copy_from_slice(&word.to_le_bytes());
        }
    }
    bytes
}

/// A selection whose loops end before a software device ends them.
pub fn shortened(mut selection: Selection) -> Selection {
    for stage in ["search", "refine", "shadow-search"] {
        // Some have no limit.
        let _ = selection.set(&format!("{stage}.limit"), LONGEST_LOOP);
    }
    selection
}

/// A surface of a map for a selection, with the baked maps that it reads.
///
/// # Panics
///
/// When a map cannot be baked.
pub fn surface_of(map: HeightMap, selection: Selection) -> JobSurface {
    let map = Arc::new(map);
    bare_surface(Arc::clone(&map), selection, maps_for(&map, &selection))
}

/// Returns the renderer's paths of rays.
pub fn paths_of(surface: &JobSurface, rays: &[PixelIn]) -> Vec<Path> {
    let program = surface.program(Frame::none(), None);
    let path = |ray: &PixelIn| {
        let at = program.enter(*ray);
        (at.segments > 0).then(|| program.segment(*ray, at, 0)).filter(|path| path.exit > 0.0)
    };
    rays.iter().filter_map(path).collect()
}

/// Returns how many hits of functions on the renderer's paths differ in a bit from the renderer's own,
/// on that device.
///
/// # Panics
///
/// When the functions are none that this device runs.
pub fn differing_hits(
    device: &Device,
    prober: &mut Prober,
    text: &ExportedFunctions,
    surface: &JobSurface,
    rays: &[PixelIn],
) -> usize {
    let paths = paths_of(surface, rays);
    let found = device.traced(text, surface, &paths, Dialect::Wgsl);
    let hits = prober.trace(surface, Sampling::Exact, &paths).expect("hits");
    let differs = |(hit, found): &(&Hit, &OnPath)| {
        let bits = [hit.uv.x, hit.uv.y, hit.t].map(f32::to_bits);
        let other = [found.uv[0], found.uv[1], found.t].map(f32::to_bits);
        (hit.found == 1) != found.found || (found.found && bits != other)
    };
    assert_eq!(hits.len(), found.len());
    hits.iter().zip(&found).filter(differs).count()
}

/// Returns the lines and bytes of a text without comments and empty lines.
///
/// # Panics
///
/// When it is no text.
pub fn size_of(exported: &ExportedFunctions) -> [usize; 2] {
    let text = String::from_utf8(exported.files[0].bytes.clone()).expect("a text");
    let code = text.lines().filter(|line| !line.trim().is_empty() && !line.trim().starts_with("//"));
    code.fold([0, 0], |[lines, bytes], line| [lines + 1, bytes + line.len() + 1])
}
