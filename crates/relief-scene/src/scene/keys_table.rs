//! Table of all keys of scene files: type, default and meaning. It generates commented scene files
//! and schemas for editors.

use crate::motif::VectorAxes;
use std::fmt::Write;

use relief_core::Wrap;
use relief_io::{BuiltinRamp, HeightRange, Up};

use super::key_groups::{KeyGroup, group_of, rank_of};
use super::key_numbers::{KeyNumber, number_of};
use super::viewer::VIEWER;
use super::{
    BackendChoice, Look, PictureSize, ProjectionChoice, Sampling, SceneSpec, SurfaceSpec, UvProjection, View,
};
use crate::background::Background;
use crate::depth_buffer::Clip;
use crate::tone::Tone;
use relief_core::mesh::Builtin;
use relief_shaders::{METHODS, STAGES, Selection};

/// Type of a key's value.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// A text.
    Text,
    /// A file's name.
    File,
    /// A folder's name.
    Folder,
    /// One of these names.
    Name(Vec<&'static str>),
    /// One of these names of built-in meshes, or a file's name.
    Mesh(Vec<&'static str>),
    /// One of these names of built-in tables of colours, or a file's name.
    Ramp(Vec<&'static str>),
    /// True or false.
    Flag,
    /// A number.
    Number,
    /// A whole number.
    Whole,
    /// This many numbers.
    Numbers(usize),
    /// A number of metres, or a text with a unit, such as `"5cm"`.
    Length,
    /// This many lengths.
    Lengths(usize),
    /// This many whole numbers.
    Wholes(usize),
    /// Two whole numbers, or `"map"`.
    Size,
    /// Two numbers, or `"auto"`.
    Range,
    /// Three numbers, or a text such as `"az=315,alt=45"`.
    Direction,
    /// Three numbers, `"gradient"` or `"environment"`.
    Background,
    /// A number of bytes, or a text such as `"512MiB"`.
    Memory,
    /// A table with a table of numbers for each stage.
    Settings,
    /// A table of the values of a material, for one of two shading models.
    Material,
    /// A list of tables. Each has `direction` and `angle`, or `position` and `radius`, and also
    /// `color` and `intensity`.
    Lights,
    /// A table of [what a viewer shows](super::viewer_keys).
    Viewer,
}

/// Key of a scene file.
#[derive(Clone, Debug, PartialEq)]
pub struct Key {
    /// Name.
    pub name: &'static str,
    /// Whether each surface may have its own value. Other keys belong to the scene.
    pub of_surface: bool,
    /// Group of keys that are shown together.
    pub group: KeyGroup,
    /// Place in the group: what is changed most comes first.
    pub rank: usize,
    /// Type of the value.
    pub form: Form,
    /// Default in TOML. Empty if no TOML value expresses it.
    pub default: &'static str,
    /// Meaning in one line, with unit and range.
    pub about: &'static str,
    /// Unit, range and step of its number, or of each of its numbers; none if its values are no numbers.
    pub number: Option<KeyNumber>,
}

fn scene(name: &'static str, form: Form, default: &'static str, about: &'static str) -> Key {
    Key {
        name,
        of_surface: false,
        group: group_of(name),
        rank: rank_of(name),
        form,
        default,
        about,
        number: number_of(name),
    }
}

fn surface(name: &'static str, form: Form, default: &'static str, about: &'static str) -> Key {
    Key {
        name,
        of_surface: true,
        group: group_of(name),
        rank: rank_of(name),
        form,
        default,
        about,
        number: number_of(name),
    }
}

/// Returns all keys in the recommended order of a scene file: first keys of surfaces, then keys
/// of the scene.
pub fn keys() -> Vec<Key> {
    let builtins = Builtin::ALL.map(Builtin::name).to_vec();
    let methods = METHODS.iter().map(|method| method.name).collect();
    let mut keys = vec![
        surface(
            "height",
            Form::File,
            "",
            "file of the height map: PNG, JPEG, EXR, TIFF, GeoTIFF, HDR, PGM or raw",
        ),
        surface("volume", Form::File, "", "file of a volume, KTX2, in place of a height map"),
        surface(
            "motif",
            Form::File,
            "",
            "file of a motif, in place of a height map: a mesh in a tile, or a vector displacement map",
        ),
        surface(
            "axes",
            Form::Name(VectorAxes::ALL.map(VectorAxes::name).to_vec()),
            "",
            "what red, green and blue of a vector displacement map are: tnb, tangent, normal, bitangent \
             (default), or tbn",
        ),
        surface("textures", Form::Folder, "", "folder of a material's maps, recognised by their names"),
        surface("udim", Form::Whole, "", "UDIM tile whose maps are taken, from 1001 on"),
        surface("object", Form::File, "", "file of a depth object, object.toml, in place of height and mesh"),
        surface(
            "channel",
            Form::Text,
            "",
            "channel of the height map's file (default: its only channel, or grey)",
        ),
        surface("depth", Form::Flag, "false", "whether the file holds depth: white is deepest"),
        surface(
            "range",
            Form::Range,
            "",
            "two values of the file that become heights 0 and 1, or \"auto\": its least and greatest",
        ),
        surface(
            "elevation",
            Form::Lengths(2),
            "",
            "elevations in metres that heights 0 and 1 stand for (default: the file's, if it states metres)",
        ),
        surface(
            "nodata",
            Form::Number,
            "",
            "stored value of texels without a height, in addition to the one that the file declares",
        ),
        surface(
            "unit",
            Form::Text,
            "",
            "unit of the heights, as in \"cm\", or of heights and ground, as in \"cm,ft\" (default: the \
             file's)",
        ),
        surface("raw", Form::Text, "", "size and byte order of a headerless file, as in \"403x344,le\""),
        surface(
            "fill",
            Form::Flag,
            "",
            "whether texels without a height are filled (default: in elevation models, with nodata or holes)",
        ),
        surface("holes", Form::Flag, "false", "whether texels without a height are open holes"),
        surface(
            "wrap",
            Form::Name(Wrap::ALL.map(Wrap::name).to_vec()),
            "",
            "wrap of maps beyond their edges (default: clamp for elevation models, otherwise repeat)",
        ),
        surface(
            "scale",
            Form::Length,
            "",
            "displacement in metres between heights 0 and 1 (default: as the file states, or 0.05)",
        ),
        surface("bias", Form::Length, "", "displacement of height 0 in metres (default: minus the scale)"),
        surface(
            "extinction",
            Form::Number,
            "",
            "optical depth of a metre of a translucent volume where it is 1 (default: 8 over the scale)",
        ),
        surface("exaggerate", Form::Number, "1", "factor on the scale, from 1e-6 to 1e6"),
        surface("creases", Form::Flag, "false", "whether normals from the heights end at creases"),
        surface("color", Form::File, "", "file of the colour map, in sRGB"),
        surface(
            "ramp",
            Form::Ramp(BuiltinRamp::ALL.map(BuiltinRamp::name).to_vec()),
            "",
            "colours by height, in place of color: a built-in table, or a file for gdaldem color-relief",
        ),
        surface("normal", Form::File, "", "file of the tangent-space normal map"),
        surface(
            "green",
            Form::Name(vec!["+y", "-y"]),
            "\"+y\"",
            "direction of the normal map's green: up (+y) or down (-y)",
        ),
        surface("roughness", Form::File, "", "file of the roughness map, 0 smooth to 1 rough"),
        surface("metallic", Form::File, "", "file of the metalness map, 1 for metal"),
        surface(
            "occlusion",
            Form::File,
            "",
            "file of the occlusion map, 1 for open, for light from all around",
        ),
        surface(
            "orm",
            Form::File,
            "",
            "file of occlusion, roughness and metalness in red, green and blue; single maps replace channels",
        ),
        surface(
            "mask-map",
            Form::File,
            "",
            "file of metalness, occlusion and smoothness in red, green and opacity (Unity's HDRP)",
        ),
        surface(
            "metallic-smoothness",
            Form::File,
            "",
            "file of metalness in red and smoothness in opacity (Unity)",
        ),
        surface("glossiness", Form::File, "", "file of the glossiness map: 1 less the roughness"),
        surface("emission", Form::File, "", "file of the emission map, in sRGB: light of the surface itself"),
        surface(
            "mesh",
            Form::Mesh(builtins),
            "\"plane\"",
            "base mesh: a glTF, OBJ, PLY or STL file, or a built-in one",
        ),
        surface("walls", Form::Flag, "false", "whether walls and a bottom close the plane to a block"),
        surface(
            "base",
            Form::Length,
            "",
            "thickness of the block below its lowest texel, or its part of the shorter side (default: 5%)",
        ),
        surface(
            "project",
            Form::Name(UvProjection::ALL.map(UvProjection::name).to_vec()),
            "",
            "projection that replaces the texture coordinates of a mesh file",
        ),
        surface(
            "mesh-up",
            Form::Name(Up::ALL.map(Up::name).to_vec()),
            "",
            "axis of the mesh file that points up (default: z in STL, y in other formats)",
        ),
        surface("tile", Form::Numbers(2), "[1, 1]", "number of tiles along u and v, from 1e-6 to 1e6"),
        surface(
            "tile-size",
            Form::Lengths(2),
            "",
            "size of a tile in metres along u and v (default: as the file states, or square texels)",
        ),
        surface("position", Form::Lengths(3), "[0, 0, 0]", "position of the mesh's origin in metres"),
        surface("rotation", Form::Numbers(3), "[0, 0, 0]", "rotation in degrees about x, then y, then z"),
        surface(
            "mesh-scale",
            Form::Number,
            "1",
            "factor on the mesh's size, from 1e-6 to 1e6; the relief's depth stays",
        ),
        surface(
            "method",
            Form::Name(methods),
            "\"exact\"",
            "method that finds hits, in place of search and refine",
        ),
        surface("set", Form::Settings, "", "settings of the chosen variants, as in set.search.steps = 64"),
        surface(
            "material",
            Form::Material,
            "",
            "base, roughness, metallic, emission; or diffuse, specular and shininess (1 to 1024)",
        ),
        surface("transmission", Form::Number, "0", "part of the light that is refracted, from 0 to 1"),
        surface("ior", Form::Number, "1.5", "index of refraction, from 1 to 4"),
        surface("two-sided", Form::Flag, "false", "whether triangles seen from behind are drawn"),
    ];
    keys.extend(STAGES.iter().filter(|stage| stage.has_key()).map(|stage| {
        let names = stage.entries.iter().map(|entry| entry.name).collect();
        surface(stage.key, Form::Name(names), "", about_stage(stage.key))
    }));
    let looks = Look::ALL.map(Look::name).to_vec();
    let views = View::ALL.map(View::name).to_vec();
    let projections = ProjectionChoice::ALL.map(ProjectionChoice::name).to_vec();
    let clips = Clip::ALL.map(Clip::name).to_vec();
    let backends = BackendChoice::ALL.map(BackendChoice::name).to_vec();
    let samplings = Sampling::ALL.map(Sampling::name).to_vec();
    let tones = Tone::ALL.map(Tone::name).to_vec();
    keys.extend([
        scene(
            "look",
            Form::Name(looks),
            "\"studio\"",
            "defaults of camera, light, background, exposure and tone curve",
        ),
        scene(
            "view",
            Form::Name(views),
            "",
            "side from which the camera shows the whole scene (default: the look's)",
        ),
        scene("eye", Form::Lengths(3), "", "position of the eye in metres, in place of view"),
        scene("target", Form::Lengths(3), "", "point in metres at which the camera looks"),
        scene("projection", Form::Name(projections), "\"perspective\"", "projection of the camera"),
        scene(
            "fov",
            Form::Number,
            "40",
            "vertical field of view in degrees, above 0 and below 180, in perspective",
        ),
        scene("view-height", Form::Length, "", "height of an orthographic picture in metres"),
        scene(
            "clip",
            Form::Name(clips),
            "\"standard\"",
            "near end of the depth buffer for the AOV z, 0 (standard) or 1 (reversed)",
        ),
        scene(
            "near",
            Form::Length,
            "",
            "distance to the depth buffer's near plane in metres (default: before the scene)",
        ),
        scene(
            "far",
            Form::Length,
            "",
            "distance to the depth buffer's far plane in metres, or inf (default: behind the scene)",
        ),
        scene(
            "size",
            Form::Size,
            "[800, 600]",
            "width and height in pixels, or \"map\": one pixel per texel, from above",
        ),
        scene("samples", Form::Whole, "4", "samples per pixel, from 1 to 1024"),
        scene("exposure", Form::Number, "", "exposure in stops, from -32 to 32 (default: the look's)"),
        scene("tone", Form::Name(tones), "", "tone curve (default: the look's)"),
        scene("light", Form::Direction, "", "direction toward the only light (default: the look's)"),
        scene("lights", Form::Lights, "", "all lights, in place of light (default: the look's)"),
        scene(
            "light-angle",
            Form::Number,
            "0.53",
            "apparent diameter of directional lights in degrees, from 0 to 90",
        ),
        scene("ambient-color", Form::Numbers(3), "", "ambient light, linear (default: the look's)"),
        scene(
            "environment",
            Form::File,
            "",
            "file of the environment map, twice as wide as high (default: a generated sky)",
        ),
        scene(
            "background",
            Form::Background,
            "",
            "linear colour, \"gradient\" or \"environment\" behind the surfaces (default: the look's)",
        ),
        scene("backend", Form::Name(backends), "\"auto\"", "backend that computes the picture"),
        scene("sampling", Form::Name(samplings), "\"exact\"", "sampling of textures"),
        scene("max-memory", Form::Memory, "\"4GiB\"", "memory limit for maps and picture"),
        scene(
            VIEWER,
            Form::Viewer,
            "",
            "what `relief view` shows, as in viewer.show = \"error\"; pictures do not depend on it",
        ),
    ]);
    keys
}

/// What the key of a stage chooses.
fn about_stage(key: &str) -> &'static str {
    match key {
        "geometry" => "how triangles are displaced, with no search along rays (default: the method's)",
        "surface" => "where rays enter the relief, and how it follows the mesh (default: the method's)",
        "slices" => "how slices through the relief are placed (default: the method's)",
        "object" => "how the images of an object are read (default: the method's)",
        "field" => "what rays are searched for: heights, or another field (default: the method's)",
        "detail" => "how a distant relief is simplified (default: the method's)",
        "search" => "how rays find the first hit, roughly; with refine, in place of the method",
        "refine" => "how the hit of the search becomes exact; with search, in place of the method",
        "shade" => "how light makes colour on the material (default: the material's)",
        "shadow" => "how the relief casts shadows on itself (default: the method's)",
        "shadow-search" => "how rays toward the light find what is in their way (default: the view's search)",
        "ambient" => "how much light from all around reaches a point (default: the look's)",
        _ => "variant of a stage (default: the method's)",
    }
}

impl SceneSpec {
    /// Returns a scene file with the same values. It lists every key; keys without a value are
    /// comments with their defaults. `[[surfaces]]` come last.
    pub fn to_toml(&self) -> String {
        let mut text =
            String::from("# A scene of Relief. A key behind a # has its default. Remove the # to set it.\n");
        let _ = writeln!(text, "\n# The surface, or common values of all surfaces.");
        let (of_surface, of_scene): (Vec<Key>, Vec<Key>) = keys().into_iter().partition(|key| key.of_surface);
        // Tables are inline, on their key's line, so all keys stay in the file's top-level table.
        for key in &of_surface {
            line(&mut text, key, surface_value(&self.surface, key.name));
        }
        let _ = writeln!(text, "\n# Camera, light and picture.");
        for key in &of_scene {
            line(&mut text, key, scene_value(self, key.name));
        }
        for surface in &self.surfaces {
            let _ = writeln!(text, "\n[[surfaces]]");
            let values = of_surface.iter().map(|key| (key.name, surface_value(surface, key.name)));
            for (name, value) in values {
                if let Some(value) = value {
                    let _ = writeln!(text, "{name} = {value}");
                }
            }
        }
        text
    }
}

fn line(text: &mut String, key: &Key, value: Option<String>) {
    let Key { name, default, about, form, .. } = key;
    let choices = match form {
        Form::Name(names) | Form::Mesh(names) | Form::Ramp(names) => format!(": {}", names.join(", ")),
        _ => String::new(),
    };
    let _ = match value {
        Some(value) => writeln!(text, "{name} = {value}  # {about}{choices}"),
        None if default.is_empty() => writeln!(text, "# {name} = ...  # {about}{choices}"),
        None => writeln!(text, "# {name} = {default}  # {about}{choices}"),
    };
}

fn quoted(text: &str) -> String {
    toml::Value::String(text.to_owned()).to_string()
}

fn list<T: std::fmt::Debug>(numbers: &[T]) -> String {
    format!("{numbers:?}")
}

fn surface_value(spec: &SurfaceSpec, key: &str) -> Option<String> {
    let path = |path: &Option<std::path::PathBuf>| Some(quoted(&path.as_ref()?.to_string_lossy()));
    match key {
        "height" => path(&spec.height),
        "volume" => path(&spec.volume),
        "motif" => path(&spec.motif),
        "axes" => spec.axes.map(|axes| quoted(axes.name())),
        "object" => path(&spec.object),
        "textures" => path(&spec.textures),
        "udim" => spec.udim.map(|tile| tile.to_string()),
        "color" => path(&spec.color),
        "ramp" => spec.ramp.as_ref().map(|ramp| quoted(&ramp.to_string())),
        "normal" => path(&spec.normal),
        "roughness" => path(&spec.roughness),
        "metallic" => path(&spec.metallic),
        "occlusion" => path(&spec.occlusion),
        "orm" => path(&spec.orm),
        "mask-map" => path(&spec.mask_map),
        "metallic-smoothness" => path(&spec.metallic_smoothness),
        "glossiness" => path(&spec.glossiness),
        "emission" => path(&spec.emission),
        "channel" => spec.channel.as_deref().map(quoted),
        "depth" => spec.depth.map(|flag| flag.to_string()),
        "fill" => spec.fill.map(|flag| flag.to_string()),
        "holes" => spec.holes.map(|flag| flag.to_string()),
        "creases" => spec.creases.map(|flag| flag.to_string()),
        "transmission" => spec.transmission.map(|part| format!("{part:?}")),
        "ior" => spec.ior.map(|ior| format!("{ior:?}")),
        "two-sided" => spec.two_sided.map(|flag| flag.to_string()),
        "range" => spec.range.map(|range| match range {
            HeightRange::Between(range) => list(&range),
            auto @ HeightRange::Extremes => quoted(&auto.to_string()),
        }),
        "elevation" => spec.elevation.map(|both| list(&both)),
        "nodata" => spec.nodata.map(|nodata| format!("{nodata:?}")),
        "unit" => spec.unit.map(|unit| quoted(&unit.to_string())),
        "raw" => spec.raw.map(|raw| quoted(&raw.to_string())),
        "wrap" => spec.wrap.map(|wrap| quoted(wrap.name())),
        "scale" => spec.scale.map(|scale| format!("{scale:?}")),
        "bias" => spec.bias.map(|bias| format!("{bias:?}")),
        "extinction" => spec.extinction.map(|extinction| format!("{extinction:?}")),
        "exaggerate" => spec.exaggerate.map(|factor| format!("{factor:?}")),
        "green" => spec.green.map(|green| quoted(green.name())),
        "mesh" => spec.mesh.as_ref().map(|mesh| quoted(&mesh.to_string())),
        "walls" => spec.walls.map(|flag| flag.to_string()),
        "base" => spec.base.map(|base| quoted(&base.to_string())),
        "project" => spec.project.map(|projection| quoted(projection.name())),
        "mesh-up" => spec.mesh_up.map(|up| quoted(up.name())),
        "tile" => spec.tile.map(|tile| list(&tile)),
        "tile-size" => spec.tile_size.map(|size| list(&size)),
        "position" => spec.position.map(|position| list(&position)),
        "rotation" => spec.rotation.map(|rotation| list(&rotation)),
        "mesh-scale" => spec.mesh_scale.map(|scale| format!("{scale:?}")),
        "method" => spec.method.as_deref().map(quoted),
        "set" if !spec.set.is_empty() => {
            let settings = spec.set.iter().map(|(key, value)| match Selection::name_of(key, *value) {
                Some(name) => format!("{key} = {name:?}"),
                None => format!("{key} = {value:?}"),
            });
            Some(format!("{{ {} }}", settings.collect::<Vec<_>>().join(", ")))
        }
        "material" => spec.material.as_ref().map(|material| {
            let parts = [
                material.diffuse.map(|color| format!("diffuse = {}", list(&color))),
                material.specular.map(|color| format!("specular = {}", list(&color))),
                material.shininess.map(|shininess| format!("shininess = {shininess}")),
                material.base.map(|color| format!("base = {}", list(&color))),
                material.roughness.map(|value| format!("roughness = {value:?}")),
                material.metallic.map(|value| format!("metallic = {value:?}")),
                material.emission.map(|color| format!("emission = {}", list(&color))),
            ];
            format!("{{ {} }}", parts.into_iter().flatten().collect::<Vec<_>>().join(", "))
        }),
        stage => spec.stages.get(stage).map(|name| quoted(name)),
    }
}

fn scene_value(spec: &SceneSpec, key: &str) -> Option<String> {
    match key {
        "look" => spec.look.map(|look| quoted(look.name())),
        "view" => spec.view.map(|view| quoted(view.name())),
        "eye" => spec.eye.map(|eye| list(&eye)),
        "target" => spec.target.map(|target| list(&target)),
        "projection" => spec.projection.map(|projection| quoted(projection.name())),
        "fov" => spec.fov.map(|fov| format!("{fov:?}")),
        "view-height" => spec.view_height.map(|height| format!("{height:?}")),
        "clip" => spec.clip.map(|clip| quoted(clip.name())),
        "near" => spec.near.map(|metres| format!("{metres:?}")),
        "far" => spec.far.map(|metres| format!("{metres:?}")),
        "size" => spec.size.map(|size| match size {
            PictureSize::Pixels(size) => list(&size),
            map @ PictureSize::Map => quoted(&map.to_string()),
        }),
        "samples" => spec.samples.map(|samples| samples.to_string()),
        "exposure" => spec.exposure.map(|exposure| format!("{exposure:?}")),
        "tone" => spec.tone.map(|tone| quoted(tone.name())),
        "light" => spec.light.map(|light| list(&light)),
        "lights" => spec.lights.as_ref().map(|lights| {
            let each = lights.iter().map(|light| {
                let parts = [
                    light.direction.map(|direction| format!("direction = {}", list(&direction))),
                    light.position.map(|position| format!("position = {}", list(&position))),
                    light.color.map(|color| format!("color = {}", list(&color))),
                    light.intensity.map(|intensity| format!("intensity = {intensity:?}")),
                    light.angle.map(|angle| format!("angle = {angle:?}")),
                    light.radius.map(|radius| format!("radius = {radius:?}")),
                ];
                format!("{{ {} }}", parts.into_iter().flatten().collect::<Vec<_>>().join(", "))
            });
            format!("[{}]", each.collect::<Vec<_>>().join(", "))
        }),
        "light-angle" => spec.light_angle.map(|angle| format!("{angle:?}")),
        "ambient-color" => spec.ambient_color.map(|color| list(&color)),
        "environment" => spec.environment.as_ref().map(|path| quoted(&path.to_string_lossy())),
        "background" => spec.background.map(|background| match background {
            Background::Color(colour) => list(&colour.to_array()),
            named => quoted(&named.to_string()),
        }),
        "backend" => spec.backend.map(|backend| quoted(backend.name())),
        "sampling" => spec.sampling.map(|sampling| quoted(sampling.name())),
        "max-memory" => spec.max_memory.map(|limit| limit.0.to_string()),
        VIEWER => {
            let values = spec.viewer.values();
            let parts: Vec<String> = values.iter().map(|(key, value)| format!("{key} = {value}")).collect();
            (!parts.is_empty()).then(|| format!("{{ {} }}", parts.join(", ")))
        }
        _ => None,
    }
}
