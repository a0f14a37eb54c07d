//! Values of the host by their members' names, and their bytes as a manifest lays them out.

use relief_render::job::Job;
use relief_shaders::cpu::{
    Choice, Corner, Face, Frame, Light, LightView, MapSettings, Shell, SurfaceSettings, Vec2, Vec3, Vec4,
};
use serde_json::Value as Json;

/// A value.
pub enum Value {
    /// A number or a vector: its 32-bit words.
    Words(Vec<u32>),
    /// An array.
    Array(Vec<Value>),
    /// A struct: its members by name.
    Struct(Vec<(&'static str, Value)>),
}

/// Subject that has the value.
pub trait Valued {
    fn value(&self) -> Value;
}

impl Valued for u32 {
    fn value(&self) -> Value {
        Value::Words(vec![*self])
    }
}

impl Valued for f32 {
    fn value(&self) -> Value {
        Value::Words(vec![self.to_bits()])
    }
}

/// The words of numbers.
fn words<T: Valued>(numbers: &[T]) -> Value {
    let each = numbers.iter().flat_map(|number| match number.value() {
        Value::Words(words) => words,
        _ => Vec::new(),
    });
    Value::Words(each.collect())
}

impl<T: Valued + Copy> Valued for Vec2<T> {
    fn value(&self) -> Value {
        words(&[self.x, self.y])
    }
}

impl<T: Valued + Copy> Valued for Vec3<T> {
    fn value(&self) -> Value {
        words(&[self.x, self.y, self.z])
    }
}

impl<T: Valued + Copy> Valued for Vec4<T> {
    fn value(&self) -> Value {
        words(&[self.x, self.y, self.z, self.w])
    }
}

impl<T: Valued, const N: usize> Valued for [T; N] {
    fn value(&self) -> Value {
        Value::Array(self.iter().map(Valued::value).collect())
    }
}

macro_rules! structs {
    ($($name:ident { $($member:ident),* $(,)? })*) => {$(
        impl Valued for $name {
            fn value(&self) -> Value {
                // Whole, so that a new member is missed here, where it is to be named.
                let Self { $($member),* } = self;
                Value::Struct(vec![$((stringify!($member), $member.value())),*])
            }
        }
    )*};
}

structs! {
    Choice { number, params }
    MapSettings { coded, layers, texel_bytes, first_level, low, step, tile_m }
    SurfaceSettings {
        choices, maps, diffuse, specular, height_size, color_size, normal_size, height_levels, color_levels,
        normal_levels, color_texels, normal_texels, normal_tile_m, wrap, shininess, has_color, has_normal,
        has_holes, has_creases, has_vertex_normals, has_shadows, scale_m, bias_m, shell_m, mean_height,
        transmission, ior, number, emission, material_size, material_levels, material_texels, roughness,
        metallic, has_material, environment_side, environment_levels, images, solids,
        cells, jump, volume, color_u, color_v, color_wrap_u, color_wrap_v, cutoff,
        translucent,
    }
    Light { place, color, first_view, views }
    LightView { column, row, depth, corner, across, along, eye, near, texel_m, from_point, size }
    Frame {
        view_projection, eye, eye_right, eye_down, forward, corner, right, down, ambient, sample_width, near,
        clip, background, background_below, lights, light_count, light_views,
    }
    Corner { position, normal, tangent, bitangent, uv, of_surface }
    Shell { heights, order, lift }
    Face { corners, shell }
}

/// The bytes of what a buffer of that name holds.
///
/// # Panics
///
/// When the manifest names a buffer or a member that there is not.
pub fn bytes_of(manifest: &Json, binding: &Json, job: &Job) -> Vec<u8> {
    let surface = &job.surfaces[0];
    let name = binding["name"].as_str().expect("a name");
    let elements: Vec<Value> = match name {
        "frame" => vec![job.frame.value()],
        "surface_settings" => vec![surface.settings.value()],
        "mesh_faces" => surface.triangles.faces().iter().map(Valued::value).collect(),
        "mesh_corners" => surface.triangles.corners().iter().map(Valued::value).collect(),
        other => panic!("there is no buffer {other}"),
    };
    let structure = binding["struct"].as_str().expect("a struct");
    let size = manifest["structs"][structure]["size"].as_u64().expect("a size") as usize;
    let mut bytes = vec![0; size * elements.len()];
    for (element, place) in elements.iter().zip(bytes.chunks_exact_mut(size)) {
        write(manifest, structure, element, place);
    }
    bytes
}

/// Writes a value of that type to where the manifest has its parts.
fn write(manifest: &Json, of: &str, value: &Value, bytes: &mut [u8]) {
    match value {
        Value::Words(words) => {
            for (word, place) in words.iter().zip(bytes.chunks_exact_mut(4)) {
                place.copy_from_slice(&word.to_le_bytes());
            }
        }
        Value::Array(_) => panic!("{of} is no array"),
        Value::Struct(members) => {
            for member in manifest["structs"][of]["members"].as_array().expect("members") {
                let name = member["name"].as_str().expect("a name");
                let (_, value) = members.iter().find(|(known, _)| *known == name).expect("the same members");
                let number = |json: &Json| json.as_u64().expect("a number") as usize;
                let place = &mut bytes[number(&member["offset"])..];
                let of = member["type"].as_str().expect("a type");
                match value {
                    Value::Array(elements) => {
                        let array = &member["array"];
                        assert_eq!(number(&array["count"]), elements.len(), "{name}");
                        let stride = number(&array["stride"]);
                        for (k, element) in elements.iter().enumerate() {
                            write(manifest, of, element, &mut place[k * stride..]);
                        }
                    }
                    value => write(manifest, of, value, place),
                }
            }
        }
    }
}
