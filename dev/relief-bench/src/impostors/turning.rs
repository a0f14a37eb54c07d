//! How much pictures of objects change when the eye goes a degree around them, beside those of the mesh.

use std::path::Path;

use glam::DVec3;
use relief_compare::picture::{Image, PIXELS_PER_DEGREE, flip};
use relief_core::Watch;
use relief_io::{MeshColors, MeshOptions, read_mesh, read_picture};
use relief_maps::Maps;
use relief_object::{Arrangement, CaptureSettings, Capturer, Cover, ObjectWriter, even_directions};
use relief_render::picture::Look;
use relief_render::render;
use relief_render::scene::parse_scene;

use crate::surfaces::bases::{data, spot_file};
use crate::table::table;

/// From how many directions.
const DIRECTIONS: u32 = 12;

/// Pixels of a side of the pictures.
const SIZE: u32 = 192;

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
pub fn run() -> Result<(), String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let mut rows = table(&["mesh", "shown", "FLIP of a degree", "less the mesh's", "FLIP beside the mesh"]);
    let spot = spot_file().map(|path| ("spot", path, data("piebald.png"), Cover::Centre));
    let tree = ("tree", data("tree.obj"), data("tree_color.png"), Cover::Pixel);
    for (name, mesh, color, cover) in spot.into_iter().chain([tree]) {
        let folder = folder.path().join(name);
        let (centre, radius) = captured(&folder, &mesh, &color, cover)?;
        let subject = Subject { folder: &folder, mesh: &mesh, color: &color, centre, radius };
        let of_mesh = subject.pairs(None)?;
        let turned_of_mesh = turned(&of_mesh)?;
        rows.add_row([name, "the mesh", &format!("{turned_of_mesh:.4}"), "", ""]);
        for (label, object, keys) in [
            ("six, three colours", "cube", "set.object.color = \"three\""),
            ("six, colours seen", "cube", ""),
            ("16x16, blend of 2 steps", "grid", "method = \"impostor-blend\"\nset.object.steps = 2"),
        ] {
            let pairs = subject.pairs(Some((object, keys)))?;
            let turned = turned(&pairs)?;
            let beside: Result<Vec<f64>, String> =
                pairs.iter().zip(&of_mesh).map(|(own, mesh)| apart(&own[0], &mesh[0])).collect();
            rows.add_row([
                name.to_owned(),
                label.to_owned(),
                format!("{turned:.4}"),
                format!("{:+.4}", turned - turned_of_mesh),
                format!("{:.4}", mean(&beside?)),
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
    let colors = MeshColors { factor: [1.0; 3], picture: Some(picture) };
    let mut ball = (DVec3::ZERO, 1.0);
    for (name, arrangement, size) in
        [("grid", Arrangement::Octahedral(16), 32), ("cube", Arrangement::Cube, 209)]
    {
        let settings = CaptureSettings { arrangement, size, ..CaptureSettings::default() };
        let capturer = Capturer::new(&mesh, Some(&colors), settings).map_err(|error| error.to_string())?;
        ball = capturer.ball();
        let captured = capturer.capture(cover, &Watch::NOBODY).map_err(|error| error.to_string())?;
        let writer = ObjectWriter::open(&folder.join(name), &mut |_| true);
        let written = writer.and_then(|writer| writer.write(&captured, None));
        written.map_err(|error| error.to_string())?;
    }
    std::fs::write(folder.join("flat.pgm"), FLAT).map_err(|error| error.to_string())?;
    Ok(ball)
}

impl Subject<'_> {
    /// Pictures of the mesh, or of an object, shown as keys of a scene say.
    fn pairs(&self, object: Option<(&str, &str)>) -> Result<Pairs, String> {
        let keys = match object {
            None => format!(
                "height = \"flat.pgm\"\nscale = 0.0\nmethod = \"bump\"\ntwo-sided = true\nmesh = {:?}\ncolor = {:?}\n",
                self.mesh, self.color
            ),
            Some((object, keys)) => format!("object = \"{object}/object.toml\"\n{keys}\n"),
        };
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

    fn picture(&self, keys: &str, from: DVec3) -> Result<Image, String> {
        let Self { centre, radius, .. } = *self;
        let eye = centre + from * 4.0 * radius;
        let text = format!(
            "{keys}\nshadow = \"none\"\neye = {:?}\ntarget = {:?}\nsize = [{SIZE}, {SIZE}]\n\
             projection = \"orthographic\"\nview-height = {}\nbackend = \"cpu\"\nlight = [-0.5, 0.7, 0.4]\n\
             samples = 4\n",
            eye.to_array(),
            centre.to_array(),
            2.0 * radius
        );
        let scene = parse_scene(&text, &self.folder.join("scene.toml")).and_then(|spec| spec.load());
        let scene = scene.map_err(|error| format!("{error}: {text}"))?;
        let rendered =
            render(&scene, &mut Maps::in_memory(), &|_, _| {}).map_err(|error| error.to_string())?;
        let look = Look { background: [0.03, 0.07, 0.13], exposure: 0.0, tone: Default::default() };
        Image::of(&rendered.rendering, &look).map_err(|error| error.to_string())
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
