//! Command-line description of a scene: a scene file and the flags that override it.

mod failure;
mod spec;

pub use self::failure::{of_scene, of_scene_file};

use std::path::{Path, PathBuf};

use clap::Args;
use relief_core::ByteSize;
use relief_io::GreenSign;
use relief_scene::background::Background;
use relief_scene::depth_buffer::Clip;
use relief_scene::motif::VectorAxes;
use relief_scene::tone::Tone;
use relief_scene::{
    BackendChoice, BaseThickness, LightDirection, LightSpec, Look, PictureSize, ProjectionChoice, RampChoice,
    Sampling, SceneSpec, View,
};
use relief_shaders::METHODS;

use super::maps::HeightArguments;
use super::material_arguments::MaterialArguments;
use super::placement::PlacementArguments;
use super::stages::StageArguments;
use crate::file_kind::FileKind;
use crate::{units, values};

/// Flags that choose the backend and the sampling.
#[derive(Args)]
#[command(next_help_heading = "Machine")]
pub struct MachineArguments {
    /// Backend that computes the picture. auto: a GPU if there is one, else the CPU; gpu: also a
    /// software adapter [default: auto]
    #[arg(long, value_name = "auto|cpu|gpu")]
    backend: Option<BackendChoice>,
    /// Texture reads. exact: the same bits on every machine; fast: through the GPU's texture
    /// sampler [default: exact]
    #[arg(long, value_name = "exact|fast", hide_short_help = true)]
    sampling: Option<Sampling>,
}

impl MachineArguments {
    /// Whether the command line names a backend or a sampling.
    pub fn is_named(&self) -> bool {
        self.sampling.is_some() || self.backend.is_some()
    }

    /// Returns `spec` with the flags' values in place of its own.
    pub fn over(&self, spec: SceneSpec) -> SceneSpec {
        spec.overridden_by(SceneSpec {
            backend: self.backend,
            sampling: self.sampling,
            ..SceneSpec::default()
        })
    }
}

/// Scene file and flags that describe a scene.
#[derive(Args)]
pub struct SceneArguments {
    /// File to render: a scene (TOML), a height map, a volume (KTX2), a mesh, or an object.toml.
    /// Keys of a scene are named like the flags, and flags override them. Paths in a scene file
    /// start at its folder; with - (standard input) they start at the current folder
    #[arg(value_name = "FILE")]
    scene: Option<PathBuf>,
    /// Width and height of the picture in pixels, 1 to 32768 each. map: one pixel per texel, with
    /// --view top --projection orthographic [default: 800x600; in compare 320x240, with --quick 160x120;
    /// with that view and projection, 800 pixels on the longer side]
    #[arg(long, value_name = "WxH|map", allow_hyphen_values = true)]
    size: Option<PictureSize>,
    /// Samples per pixel, 1 to 1024; more of them smooth edges and distant texels [default: 4]
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    samples: Option<u32>,
    /// Preset of light, background, tone curve and camera; other flags override it. studio: a key
    /// light from the camera's upper left, soft sky, bright backdrop; sun: low, warm sun before a
    /// blue sky; overcast: sky light alone; plain: one light, dark background, used by `relief
    /// compare`. Replaces a scene file's own light, background and tone curve [default: studio]
    #[arg(long, value_name = "NAME")]
    look: Option<Look>,
    /// Exposure in stops, -32 to 32; each stop doubles the light [default: the look's]
    #[arg(long, value_name = "STOPS", allow_hyphen_values = true)]
    exposure: Option<f32>,
    /// Tone curve. none: clips bright values; agx: desaturates them. EXR files have none [default:
    /// the look's]
    #[arg(long, value_name = "none|agx")]
    tone: Option<Tone>,
    /// Background: R,G,B in linear light, gradient (a bright backdrop), or environment (the file of
    /// --environment, or a generated sky) [default: the look's]
    #[arg(long, value_name = "R,G,B|NAME", allow_hyphen_values = true, hide_short_help = true)]
    background: Option<Background>,

    /// Height map: PNG, JPEG, EXR, TIFF, GeoTIFF, HDR, PGM or headerless 16-bit raw
    #[arg(long, value_name = "FILE", help_heading = "Maps and mesh")]
    height: Option<PathBuf>,
    /// Volume to render instead of a height map: a KTX2 file of `relief volume`
    #[arg(
        long,
        value_name = "FILE",
        help_heading = "Maps and mesh",
        conflicts_with_all = ["height", "object"]
    )]
    volume: Option<PathBuf>,
    /// Motif to render instead of a height map: a mesh of `relief motif`, or another closed mesh in a tile,
    /// which repeats on --mesh. x and z are 0 to 1 along the tile, y is the height from 0 to 1. Or a vector
    /// displacement map (EXR, PNG or TIFF with R, G and B), whose vectors of length 1 are as long as --scale,
    /// or as a tile
    #[arg(
        long,
        value_name = "FILE",
        help_heading = "Maps and mesh",
        conflicts_with_all = ["height", "volume", "object"]
    )]
    motif: Option<PathBuf>,
    /// What R, G and B of a vector displacement map are: tnb, tangent, normal, bitangent; or tbn,
    /// tangent, bitangent, normal, as in Blender's brushes [default: tnb]
    #[arg(
        long,
        value_name = "tnb|tbn",
        help_heading = "Maps and mesh",
        requires = "motif",
        hide_short_help = true
    )]
    axes: Option<VectorAxes>,
    /// Depth object to render instead of a height map on a mesh: an object.toml of `relief capture`
    #[arg(long, value_name = "FILE", help_heading = "Maps and mesh", conflicts_with = "height")]
    object: Option<PathBuf>,
    /// Colour map in sRGB [default: none, the material alone]
    #[arg(long, value_name = "FILE", help_heading = "Maps and mesh")]
    color: Option<PathBuf>,
    /// Colours by height: terrain, viridis, grey, or a table for `gdaldem color-relief`, whose
    /// elevations are in metres or percent. Built-in colours span the map's range [default: none]
    #[arg(long, value_name = "NAME|FILE", help_heading = "Maps and mesh", conflicts_with = "color")]
    ramp: Option<RampChoice>,
    /// Tangent-space normal map [default: normals from the height map]
    #[arg(long, value_name = "FILE", help_heading = "Maps and mesh")]
    normal: Option<PathBuf>,
    /// Direction of the normal map's green channel: +y (up in the picture) or -y (down) [default:
    /// +y]
    #[arg(
        long,
        value_name = "SIGN",
        allow_hyphen_values = true,
        help_heading = "Maps and mesh",
        hide_short_help = true
    )]
    green: Option<GreenSign>,
    /// Show holes (texels of the height map without a value) as openings. Shadows still treat them
    /// as filled [default: holes are filled]
    #[arg(long, help_heading = "Maps and mesh", hide_short_help = true)]
    holes: bool,
    /// Break normals from the height map at creases, where the slope changes by about 27 to 45
    /// degrees at once, instead of smearing them
    #[arg(long, help_heading = "Maps and mesh", hide_short_help = true)]
    creases: bool,
    #[command(flatten)]
    placement: PlacementArguments,
    /// Close the plane to a block, with walls and a bottom. The relief is then traced in the plane's
    /// shell (--surface prism), and clamped at its edges
    #[arg(long, help_heading = "Maps and mesh")]
    walls: bool,
    /// Thickness of the block below its lowest texel, as in 2cm, or in percent of the plane's shorter
    /// side. Needs --walls [default: 5%]
    #[arg(
        long,
        value_name = "M|P%",
        allow_hyphen_values = true,
        help_heading = "Maps and mesh",
        hide_short_help = true
    )]
    base: Option<BaseThickness>,
    #[command(flatten)]
    material: MaterialArguments,
    /// Also draw back faces, with their normals turned over
    #[arg(long, help_heading = "Maps and mesh", hide_short_help = true)]
    two_sided: bool,
    #[command(flatten)]
    reading: HeightArguments,

    #[arg(
        long,
        value_name = "NAME",
        conflicts_with_all = ["search", "refine"],
        help_heading = "Method",
        help = method_help(),
    )]
    method: Option<String>,
    #[command(flatten)]
    stages: StageArguments,
    /// Setting of a stage, as in search.steps=64; repeatable. `relief methods` lists all settings
    #[arg(
        long,
        value_name = "STAGE.NAME=VALUE",
        value_parser = values::setting,
        help_heading = "Method",
        hide_short_help = true,
    )]
    set: Vec<(String, f64)>,

    /// Camera preset that shows the whole scene: corner, three-quarter, top, front or right
    /// [default: the look's]
    #[arg(
        long,
        value_name = "VIEW",
        conflicts_with_all = ["eye", "target"],
        help_heading = "Camera and light",
    )]
    view: Option<View>,
    /// Camera position in metres [default: fitted to scene and picture; with --target, 0.6,0.9,1.1]
    #[arg(
        long,
        value_name = "X,Y,Z",
        value_parser = values::point,
        allow_hyphen_values = true,
        help_heading = "Camera and light",
    )]
    eye: Option<[f64; 3]>,
    /// Point that the camera looks at, in metres [default: fitted; with --eye, 0,0,0]
    #[arg(
        long,
        value_name = "X,Y,Z",
        value_parser = values::point,
        allow_hyphen_values = true,
        help_heading = "Camera and light",
    )]
    target: Option<[f64; 3]>,
    /// Projection: perspective or orthographic [default: perspective]
    #[arg(long, value_name = "NAME", help_heading = "Camera and light")]
    projection: Option<ProjectionChoice>,
    /// Vertical field of view of a perspective camera in degrees, above 0 and below 180 [default:
    /// 40]
    #[arg(long, value_name = "DEGREES", allow_hyphen_values = true, help_heading = "Camera and light")]
    fov: Option<f64>,
    /// Height in metres that an orthographic picture covers [default: fitted; required with --eye
    /// or --target]
    #[arg(
        long,
        value_name = "M",
        value_parser = units::length,
        allow_hyphen_values = true,
        help_heading = "Camera and light",
        hide_short_help = true,
    )]
    view_height: Option<f64>,
    /// Depth convention of the AOV z: standard (0 is near) or reversed (1 is near) [default:
    /// standard]
    #[arg(long, value_name = "NAME", help_heading = "Camera and light", hide_short_help = true)]
    clip: Option<Clip>,
    /// Near plane of the AOV z, in metres from the camera [default: in front of the scene]
    #[arg(
        long,
        value_name = "M",
        value_parser = units::length,
        allow_hyphen_values = true,
        help_heading = "Camera and light",
        hide_short_help = true,
    )]
    near: Option<f64>,
    /// Far plane of the AOV z, in metres from the camera, or inf [default: behind the scene]
    #[arg(
        long,
        value_name = "M|inf",
        value_parser = units::length_or_infinity,
        allow_hyphen_values = true,
        help_heading = "Camera and light",
        hide_short_help = true,
    )]
    far: Option<f64>,
    /// Direction toward a directional light: a vector, or degrees clockwise from north (-z) and
    /// above the horizon, as in az=315,alt=45. Its colour is the look's [default: the look's light]
    #[arg(
        long,
        value_name = "X,Y,Z|az=A,alt=B",
        allow_hyphen_values = true,
        help_heading = "Camera and light"
    )]
    light: Option<LightDirection>,
    /// Point light: position in metres, and intensity in linear red, green and blue (1 lights a
    /// white surface fully from 1 m). Repeatable, also beside --light [default intensity: 1,1,1]
    #[arg(
        long,
        value_name = "X,Y,Z[,R,G,B]",
        value_parser = values::point_light,
        allow_hyphen_values = true,
        help_heading = "Camera and light",
        hide_short_help = true,
    )]
    point_light: Vec<LightSpec>,
    /// Angular diameter of a directional light in degrees, 0 to 90, for soft shadows [default:
    /// 0.53, the sun's]
    #[arg(
        long,
        value_name = "DEGREES",
        allow_hyphen_values = true,
        help_heading = "Camera and light",
        hide_short_help = true
    )]
    light_angle: Option<f64>,
    /// Colour of the ambient light in linear red, green and blue [default: the look's]
    #[arg(
        long,
        value_name = "R,G,B",
        value_parser = values::point,
        allow_hyphen_values = true,
        help_heading = "Camera and light",
        hide_short_help = true,
    )]
    ambient_color: Option<[f64; 3]>,
    /// Environment map that lights the scene: an equirectangular EXR, HDR or PNG picture, twice as
    /// wide as high, with -z in the middle [default: a generated sky, with --ambient environment]
    #[arg(long, value_name = "FILE", help_heading = "Camera and light")]
    environment: Option<PathBuf>,

    /// Memory limit, as in 512MiB; work that needs more is refused [default: 4GiB]
    #[arg(
        long,
        value_name = "SIZE",
        allow_hyphen_values = true,
        help_heading = "Machine",
        hide_short_help = true
    )]
    max_memory: Option<ByteSize>,
}

fn method_help() -> String {
    let names: Vec<&str> = METHODS.iter().map(|method| method.name).collect();
    format!("Method: {} [default: exact]", names.join(", "))
}

impl SceneArguments {
    /// Returns the files that may be standard input.
    pub fn files(&mut self) -> Vec<&mut PathBuf> {
        let Self { scene, height, volume, motif, color, ramp, normal, material, environment, .. } = self;
        let files = [scene, height, volume, motif, color, normal, environment].into_iter().flatten();
        let ramp = ramp.iter_mut().filter_map(|ramp| match ramp {
            RampChoice::File(path) => Some(path),
            RampChoice::Builtin(_) => None,
        });
        files.chain(ramp).chain(material.files()).collect()
    }

    /// Returns the scene file, if the file that is shown is one.
    pub fn file(&self) -> Option<&Path> {
        self.scene.as_deref().filter(|path| matches!(FileKind::of(path), Ok(FileKind::Scene)))
    }

    /// Returns the file that is shown, to be replaced.
    pub fn file_mut(&mut self) -> Option<&mut PathBuf> {
        self.scene.as_mut()
    }

    /// Returns the scene as words of a command line: its file, or its height map.
    pub fn words(&self) -> String {
        match (&self.scene, &self.height, &self.object) {
            (Some(scene), ..) => scene.display().to_string(),
            (None, Some(height), _) => format!("--height {}", height.display()),
            (None, None, Some(object)) => format!("--object {}", object.display()),
            (None, None, None) => match (&self.volume, &self.motif) {
                (Some(volume), _) => format!("--volume {}", volume.display()),
                (None, Some(motif)) => format!("--motif {}", motif.display()),
                (None, None) => "--height MAP".to_owned(),
            },
        }
    }

    /// Whether a method is named on the command line.
    pub fn names_method(&self) -> bool {
        self.method.is_some()
    }

    /// Returns the scene file, if one is named. It may lack some of its files.
    pub fn scene_file(&self) -> Option<&Path> {
        self.scene.as_deref().filter(|file| matches!(FileKind::of(file), Ok(FileKind::Scene)))
    }

    /// Returns the settings that `--set` gives.
    pub fn settings(&self) -> &[(String, f64)] {
        &self.set
    }
}
