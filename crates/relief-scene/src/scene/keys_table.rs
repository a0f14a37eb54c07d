//! Every key of a scene file: what it holds and what it means. Scene files with comments, and schemas for
//! editors, are made of it.

use std::fmt::Write;

use relief_core::Wrap;
use relief_io::{HeightRange, Up};

use super::{
    BackendChoice, Look, PictureSize, ProjectionChoice, Sampling, SceneSpec, SurfaceSpec, UvProjection, View,
};
use crate::background::Background;
use crate::depth_buffer::Clip;
use crate::tone::Tone;
use relief_core::mesh::Builtin;
use relief_shaders::{METHODS, STAGES, Selection};

/// What a key holds.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// A text: a file's name, say.
    Text,
    /// One of these names.
    Name(Vec<&'static str>),
    /// One of these names of built-in meshes, or a file's name.
    Mesh(Vec<&'static str>),
    /// True or false.
    Flag,
    /// A number.
    Number,
    /// A whole number.
    Whole,
    /// The given number of numbers.
    Numbers(usize),
    /// A number of metres, or a text with a unit, such as `"5cm"`.
    Length,
    /// The given number of lengths.
    Lengths(usize),
    /// The given number of whole numbers.
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
    /// A table of numbers for each stage.
    Settings,
    /// A table of `diffuse`, `specular` and `shininess`.
    Material,
    /// A list of tables of `direction` and `angle`, or `position` and `radius`, and `color` and `intensity`.
    Lights,
}

/// A key.
#[derive(Clone, Debug, PartialEq)]
pub struct Key {
    /// Its name.
    pub name: &'static str,
    /// Whether each surface may have its own; others belong to the scene.
    pub of_surface: bool,
    /// What it holds.
    pub form: Form,
    /// What it is when nothing is said, as it would be written; empty where nothing can be written for it.
    pub default: &'static str,
    /// One line on what it means.
    pub about: &'static str,
}

fn scene(name: &'static str, form: Form, default: &'static str, about: &'static str) -> Key {
    Key { name, of_surface: false, form, default, about }
}

fn surface(name: &'static str, form: Form, default: &'static str, about: &'static str) -> Key {
    Key { name, of_surface: true, form, default, about }
}

/// All keys, in the order in which a scene file has them best.
pub fn keys() -> Vec<Key> {
    let builtins = Builtin::ALL.map(Builtin::name).to_vec();
    let methods = METHODS.iter().map(|method| method.name).collect();
    let mut keys = vec![
        surface("height", Form::Text, "", "height map: PNG, JPEG, EXR, TIFF, GeoTIFF, HDR, PGM or raw"),
        surface(
            "object",
            Form::Text,
            "",
            "object of images with depth: object.toml, in place of height and mesh",
        ),
        surface("channel", Form::Text, "", "channel of that file; else the only one, or the grey"),
        surface("depth", Form::Flag, "false", "whether white is deep"),
        surface("range", Form::Range, "", "values of the file that become heights 0 and 1, or \"auto\""),
        surface("nodata", Form::Number, "", "value of texels without one, beside what the file declares"),
        surface(
            "unit",
            Form::Text,
            "",
            "unit of the heights, or units of heights and ground, as in \"cm\" or \"cm,ft\"",
        ),
        surface("raw", Form::Text, "", "size and byte order of a headerless file, as in \"403x344,le\""),
        surface(
            "fill",
            Form::Flag,
            "",
            "whether texels without a value are filled; of elevation models and with nodata they are",
        ),
        surface("holes", Form::Flag, "false", "whether texels without a value are holes to be seen through"),
        surface(
            "wrap",
            Form::Name(Wrap::ALL.map(Wrap::name).to_vec()),
            "",
            "how maps go on beyond their edges",
        ),
        surface(
            "scale",
            Form::Length,
            "",
            "metres between heights 0 and 1; else as the file states, or 0.05",
        ),
        surface("bias", Form::Length, "", "displacement of height 0 in metres; else minus the scale"),
        surface("exaggerate", Form::Number, "1", "factor on the scale, 1e-6 to 1e6"),
        surface("creases", Form::Flag, "false", "whether normals of the heights end at creases"),
        surface("color", Form::Text, "", "colour map, in sRGB"),
        surface("normal", Form::Text, "", "tangent-space normal map"),
        surface("green", Form::Name(vec!["+y", "-y"]), "\"+y\"", "where the normal map's green points"),
        surface("mesh", Form::Mesh(builtins), "\"plane\"", "base mesh, or a glTF, OBJ, PLY or STL file"),
        surface(
            "project",
            Form::Name(UvProjection::ALL.map(UvProjection::name).to_vec()),
            "",
            "texture coordinates for a mesh of a file, in place of its own",
        ),
        surface(
            "mesh-up",
            Form::Name(Up::ALL.map(Up::name).to_vec()),
            "",
            "axis of the mesh's file that points up; else z in STL, y in others",
        ),
        surface("tile", Form::Numbers(2), "[1, 1]", "tiles along u and v"),
        surface(
            "tile-size",
            Form::Lengths(2),
            "",
            "metres of a tile; else as the file states, or square texels",
        ),
        surface("position", Form::Lengths(3), "[0, 0, 0]", "where the mesh's origin lies, in metres"),
        surface("rotation", Form::Numbers(3), "[0, 0, 0]", "degrees about x, then y, then z"),
        surface("mesh-scale", Form::Number, "1", "how many times as large the mesh is; the relief stays"),
        surface("method", Form::Name(methods), "\"exact\"", "how hits are found; or search and refine"),
        surface("set", Form::Settings, "", "settings of what is run, as in set.search.steps = 64"),
        surface("material", Form::Material, "", "diffuse and specular colour (linear), shininess"),
        surface("transmission", Form::Number, "0", "part of the light that is refracted, 0 to 1"),
        surface("ior", Form::Number, "1.5", "index of refraction, 1 to 4"),
        surface("two-sided", Form::Flag, "false", "whether back faces are drawn, too"),
    ];
    keys.extend(STAGES.iter().filter(|stage| stage.has_key()).map(|stage| {
        let names = stage.entries.iter().map(|entry| entry.name).collect();
        surface(stage.key, Form::Name(names), "", "variant of a stage, in place of the method's")
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
            "camera, light, background and tone curve where nothing else is said",
        ),
        scene("view", Form::Name(views), "", "from where the camera looks that sees all; else the look's"),
        scene("eye", Form::Lengths(3), "", "position of the eye in metres, in place of a view"),
        scene("target", Form::Lengths(3), "", "point looked at"),
        scene("projection", Form::Name(projections), "\"perspective\"", "how space becomes a picture"),
        scene("fov", Form::Number, "40", "vertical field of view of a perspective in degrees"),
        scene("view-height", Form::Length, "", "metres from edge to edge of an orthographic picture"),
        scene(
            "clip",
            Form::Name(clips),
            "\"standard\"",
            "which end of the depth buffer is near, for the AOV z",
        ),
        scene("near", Form::Length, "", "metres to that buffer's near plane; else before the scene"),
        scene("far", Form::Length, "", "metres to its far plane, or inf; else behind the scene"),
        scene("size", Form::Size, "[800, 600]", "pixels of the picture, or \"map\": one a texel, from above"),
        scene("samples", Form::Whole, "4", "samples of a pixel, 1 to 1024"),
        scene("exposure", Form::Number, "", "stops by which light is brightened; else the look's"),
        scene("tone", Form::Name(tones), "", "tone curve; else the look's"),
        scene("light", Form::Direction, "", "direction toward the only light; else the look's light"),
        scene("lights", Form::Lights, "", "all lights, in place of it"),
        scene("light-angle", Form::Number, "0.53", "diameter of lights far away in degrees, 0 to 90"),
        scene("ambient-color", Form::Numbers(3), "", "light from all around, linear; else the look's"),
        scene("environment", Form::Text, "", "surroundings, a picture 2:1; else a generated sky"),
        scene(
            "background",
            Form::Background,
            "",
            "linear colour beside the surfaces, \"gradient\" or \"environment\"; else the look's",
        ),
        scene("backend", Form::Name(backends), "\"auto\"", "what computes the picture"),
        scene("sampling", Form::Name(samplings), "\"exact\"", "how textures are read"),
        scene("max-memory", Form::Memory, "\"4GiB\"", "the most memory for maps and picture"),
    ]);
    keys
}

impl SceneSpec {
    /// A scene file that says the same, with every key: those that say nothing as comments, with their
    /// defaults. Surfaces of their own come last.
    pub fn to_toml(&self) -> String {
        let mut text = String::from(
            "# A scene of relief. Keys behind a # say nothing: what stands there is the default.\n",
        );
        let _ = writeln!(text, "\n# The surface, or what all surfaces have in common.");
        let (of_surface, of_scene): (Vec<Key>, Vec<Key>) = keys().into_iter().partition(|key| key.of_surface);
        // What is a table ends with its key's line, so that all of these stay in the table of the file
        // itself.
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
        Form::Name(names) | Form::Mesh(names) => format!(": {}", names.join(", ")),
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
        "object" => path(&spec.object),
        "color" => path(&spec.color),
        "normal" => path(&spec.normal),
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
        "nodata" => spec.nodata.map(|nodata| format!("{nodata:?}")),
        "unit" => spec.unit.map(|unit| quoted(&unit.to_string())),
        "raw" => spec.raw.map(|raw| quoted(&raw.to_string())),
        "wrap" => spec.wrap.map(|wrap| quoted(wrap.name())),
        "scale" => spec.scale.map(|scale| format!("{scale:?}")),
        "bias" => spec.bias.map(|bias| format!("{bias:?}")),
        "exaggerate" => spec.exaggerate.map(|factor| format!("{factor:?}")),
        "green" => spec.green.map(|green| quoted(green.name())),
        "mesh" => spec.mesh.as_ref().map(|mesh| quoted(&mesh.to_string())),
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
        _ => None,
    }
}
