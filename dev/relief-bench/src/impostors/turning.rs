//! Changes of pictures of depth objects when the eye moves a degree around them, and their costs, beside
//! the mesh's pictures.

use std::path::Path;

use glam::{DVec3, Vec3};
use relief_compare::picture::{Image, PIXELS_PER_DEGREE, flip};
use relief_core::Watch;
use relief_io::{MeshColors, MeshOptions, read_mesh, read_picture};
use relief_maps::Maps;
use relief_object::{Arrangement, CaptureSettings, Capturer, Cover, ObjectWriter, even_directions};
use relief_render::job::Rendering;
use relief_render::render;
use relief_scene::{BackendChoice, Scene, parse_scene};

use super::Arguments;
use crate::samples::Samples;
use crate::surfaces::bases::{data, spot_file};
use crate::table::table;

/// From how many directions.
const DIRECTIONS: u32 = 12;

/// Pixels of a side of the pictures.
const SIZE: u32 = 192;

/// Pictures that are timed.
const TIMED: u32 = 7;

/// A height map without heights, under which a mesh is seen as it is.
const FLAT: &str = "P2\n2 2\n255\n0 0 0 0\n";

/// Pictures, each from a direction and a degree beside it.
type Pairs = Vec<[Image; 2]>;

/// A mesh with its colours, and the folder in which its objects are.
struct Subject<'a> {
    folder: &'a Path,
    mesh: &'a Path,
    color: &'a Path,
    centre: DVec3,
    radius: f64,
}

/// Prints the table.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let mut rows = table(&[
        "mesh",
        "shown",
        "FLIP of a degree",
        "less the mesh's",
        "FLIP beside the mesh",
        "reads",
        "CPU ms",
        "GPU ms",
    ]);
    let spot = spot_file().map(|path| ("spot", path, data("piebald.png"), Cover::Centre));
    let tree = ("tree", data("tree.obj"), data("tree_color.png"), Cover::Pixel);
    for (name, mesh, color, cover) in spot.into_iter().chain([tree]) {
        let folder = folder.path().join(name);
        let (centre, radius) = captured(&folder, &mesh, &color, cover)?;
        let subject = Subject { folder: &folder, mesh: &mesh, color: &color, centre, radius };
        let of_mesh = subject.pairs(None)?;
        let turned_of_mesh = turned(&of_mesh)?;
        let [reads, cpu, gpu] = subject.costs(None, arguments)?;
        rows.add_row([name, "the mesh", &format!("{turned_of_mesh:.4}"), "", "", &reads, &cpu, &gpu]);
        for (label, object, keys) in [
            ("six, three colours", "cube", "set.object.color = \"three\""),
            ("six, colours seen", "cube", ""),
            ("16x16, blend of 2 steps", "grid", "method = \"impostor-blend\"\nset.object.steps = 2"),
        ] {
            let pairs = subject.pairs(Some((object, keys)))?;
            let turned = turned(&pairs)?;
            let beside: Result<Vec<f64>, String> =
                pairs.iter().zip(&of_mesh).map(|(own, mesh)| apart(&own[0], &mesh[0])).collect();
            let [reads, cpu, gpu] = subject.costs(Some((object, keys)), arguments)?;
            rows.add_row([
                name.to_owned(),
                label.to_owned(),
                format!("{turned:.4}"),
                format!("{:+.4}", turned - turned_of_mesh),
                format!("{:.4}", mean(&beside?)),
                reads,
                cpu,
                gpu,
            ]);
        }
    }
    println!("{rows}");
    Ok(())
}

/// Writes the objects of a mesh, in about as many texels, and returns the ball around it.
fn captured(folder: &Path, mesh: &Path, color: &Path, cover: Cover) -> Result<(DVec3, f64), String> {
    let mesh = read_mesh(mesh, &MeshOptions::default()).map_err(|error| error.to_string())?.mesh;
    let picture = read_picture(color, relief_io::DEFAULT_MAX_BYTES).map_err(|error| error.to_string())?;
    let colors = MeshColors::of([1.0; 3], Some(picture));
    let mut ball = (DVec3::ZERO, 1.0);
    for (name, arrangement, size) in
        [("grid", Arrangement::Octahedral(16), 32), ("cube", Arrangement::Cube, 209)]
    {
        let settings = CaptureSettings { arrangement, size, ..CaptureSettings::default() };
        let capturer = Capturer::new(&mesh, Some(&colors), settings).map_err(|error| error.to_string())?;
        ball = capturer.ball();
        let captured = capturer.capture(cover, &Watch::none()).map_err(|error| error.to_string())?;
        let writer = ObjectWriter::open(&folder.join(name), captured.files(), false, &mut |_| true);
        let written = writer.and_then(|writer| writer.write(&captured, None));
        written.map_err(|error| error.to_string())?;
    }
    std::fs::write(folder.join("flat.pgm"), FLAT).map_err(|error| error.to_string())?;
    Ok(ball)
}

impl Subject<'_> {
    /// Pictures of the mesh, or of an object, shown as keys of a scene say.
    fn pairs(&self, object: Option<(&str, &str)>) -> Result<Pairs, String> {
        let keys = self.keys(object);
        let degree = 1f64.to_radians();
        even_directions(DIRECTIONS)
            .into_iter()
            .map(|from| {
                let around = if from.y.abs() < 0.9 { DVec3::Y } else { DVec3::X };
                let beside = from * degree.cos() + around.cross(from).normalize() * degree.sin();
                Ok([self.picture(&keys, from)?, self.picture(&keys, beside)?])
            })
            .collect()
    }

    /// The keys of a scene of the mesh, or of an object.
    fn keys(&self, object: Option<(&str, &str)>) -> String {
        match object {
            None => format!(
                "height = \"flat.pgm\"\nscale = 0.0\nmethod = \"bump\"\ntwo-sided = true\nmesh = {:?}\n\
                 color = {:?}\n",
                self.mesh, self.color
            ),
            Some((object, keys)) => format!("object = \"{object}/object.toml\"\n{keys}\n"),
        }
    }

    /// Reads of a pixel that shows something, and milliseconds of a picture on the CPU and on a GPU, at a
    /// sample a pixel.
    fn costs(&self, object: Option<(&str, &str)>, arguments: &Arguments) -> Result<[String; 3], String> {
        let (keys, from) = (self.keys(object) + "samples = 1\n", even_directions(1)[0]);
        let time = |backend: BackendChoice| {
            let times = Samples::of_pictures(&self.scene(&keys, from, backend)?, backend, TIMED)?;
            Ok::<String, String>(times.to_string())
        };
        let rendered = self.rendered(&keys, from)?;
        let shown: Vec<f64> = rendered
            .pixels
            .iter()
            .filter(|pixel| pixel.hit == 1)
            .map(|pixel| f64::from(pixel.reads))
            .collect();
        let on_gpu = if arguments.gpu { time(BackendChoice::Gpu)? } else { String::new() };
        Ok([format!("{:.1}", mean(&shown)), time(BackendChoice::Cpu)?, on_gpu])
    }

    fn picture(&self, keys: &str, from: DVec3) -> Result<Image, String> {
        let rendered = self.rendered(&format!("{keys}samples = 4\n"), from)?;
        let scene = self.scene(keys, from, BackendChoice::Cpu)?.to_builder();
        let scene =
            scene.background(Vec3::new(0.03, 0.07, 0.13)).build().map_err(|error| error.to_string())?;
        Image::of(&rendered, &scene).map_err(|error| error.to_string())
    }

    fn rendered(&self, keys: &str, from: DVec3) -> Result<Rendering, String> {
        let scene = self.scene(keys, from, BackendChoice::Cpu)?;
        let rendered = render(&scene, &mut Maps::in_memory(), &Watch::none());
        Ok(rendered.map_err(|error| error.to_string())?.rendering)
    }

    fn scene(&self, keys: &str, from: DVec3, backend: BackendChoice) -> Result<Scene, String> {
        let Self { centre, radius, .. } = *self;
        let eye = centre + from * 4.0 * radius;
        let text = format!(
            "look = \"plain\"\n{keys}shadow = \"none\"\neye = {:?}\ntarget = {:?}\nsize = [{SIZE}, {SIZE}]\n\
             projection = \"orthographic\"\nview-height = {}\nbackend = \"{backend}\"\n\
             light = [-0.5, 0.7, 0.4]\n",
            eye.to_array(),
            centre.to_array(),
            2.0 * radius
        );
        let scene = parse_scene(&text, &self.folder.join("scene.toml")).and_then(|spec| spec.load());
        scene.map_err(|error| format!("{error}: {text}"))
    }
}

/// How much pictures change on the mean when the eye goes a degree around.
fn turned(pairs: &Pairs) -> Result<f64, String> {
    let each = pairs.iter().map(|[one, other]| apart(one, other)).collect::<Result<Vec<_>, _>>()?;
    Ok(mean(&each))
}

fn apart(one: &Image, other: &Image) -> Result<f64, String> {
    Ok(flip(one, other, PIXELS_PER_DEGREE).map_err(|error| error.to_string())?.mean())
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}
