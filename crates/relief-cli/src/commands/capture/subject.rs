//! Subject of a capture: a mesh and its colours.

use std::path::{Path, PathBuf};

use glam::Vec2;
use relief_core::ByteSize;
use relief_core::mesh::{Mesh, Placement, UvProjection, Vertex};
use relief_io::{
    MeshColors, MeshFile, MeshMaterial, MeshOptions, Picture, Remark, Up, omissions, read_mesh, read_picture,
};
use relief_mesh::{MeshSettings, Mesher};
use relief_scene::{Look, MeshChoice, SceneSpec, SurfaceSpec, read_scene};

use super::Arguments;
use crate::commands::maps::{self, By};
use crate::commands::numbered::{Numbering, ONE_FRAME, files};
use crate::commands::scene_arguments::of_scene_file;
use crate::failure::Failure;

/// Mesh with its colours.
pub struct Subject {
    pub mesh: Mesh,
    pub colors: Option<MeshColors>,
    /// Files that were read.
    pub inputs: Vec<PathBuf>,
    /// Notes on what a user may not expect.
    pub notes: Vec<String>,
}

/// Proportions of a plane without a map.
const SQUARE: [f64; 2] = [1.0, 1.0];

impl Subject {
    /// Reads a built-in mesh, the mesh of a file, or the mesh of a scene's surface, displaced if it
    /// has a height map.
    pub fn read(arguments: &Arguments) -> Result<Self, Failure> {
        let is_scene = arguments.input.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml"));
        let mut inputs = vec![arguments.input.clone()];
        let surface = if is_scene {
            let spec = read_scene(&arguments.input).map_err(of_scene_file)?;
            Numbering::of(Some(&arguments.input)).refuse(&spec, ONE_FRAME)?;
            let surface = only_surface(&spec, &arguments.input)?;
            inputs.extend(files(&spec));
            if surface.height.is_some() {
                return displaced(spec, &surface, inputs, arguments);
            }
            surface
        } else {
            of_mesh(&arguments.input)?
        };
        inputs.extend(arguments.color.clone());
        let max_bytes = arguments.max_bytes();
        let mut notes = Vec::new();
        let (mesh, own) = match surface.mesh.clone().unwrap_or_default() {
            MeshChoice::Builtin(builtin) => (builtin.build(SQUARE).map_err(Failure::work)?, None),
            MeshChoice::File(path) => {
                of_mesh_file(&path, (surface.project, surface.mesh_up), max_bytes, &mut notes)?
            }
        };
        let at = |error| Failure::Work(format!("{}: {error}", arguments.input.display()));
        let tile = Vec2::from(surface.tile.unwrap_or([1.0, 1.0]));
        let placement = Placement {
            position_m: surface.position.unwrap_or_default().into(),
            rotation_degrees: surface.rotation.unwrap_or_default().into(),
            size: surface.mesh_scale.unwrap_or(1.0),
        };
        let mesh = mesh.tiled(tile).and_then(|mesh| mesh.placed(&placement)).map_err(at)?;
        let colors = match arguments.color.as_ref().or(surface.color.as_ref()) {
            Some(path) => {
                let picture = read_picture(path, max_bytes).map_err(Failure::of_picture)?;
                notes.extend(maps::of_picture(path).iter().map(ToString::to_string));
                Some(with_picture(picture, &surface))
            }
            None => own,
        };
        Ok(Self { mesh, colors, inputs, notes })
    }
}

/// Returns the colours of a picture, times the diffuse colour of the surface's material.
fn with_picture(picture: Picture, surface: &SurfaceSpec) -> MeshColors {
    let diffuse = surface.material.as_ref().and_then(|material| material.diffuse);
    MeshColors::of(diffuse.unwrap_or([1.0; 3]), Some(picture))
}

/// Returns a surface with a mesh by its name or file.
fn of_mesh(path: &Path) -> Result<SurfaceSpec, Failure> {
    let mesh: MeshChoice = path.to_string_lossy().parse().map_err(Failure::usage)?;
    Ok(SurfaceSpec { mesh: Some(mesh), ..SurfaceSpec::default() })
}

/// Returns the only surface of a scene file.
fn only_surface(spec: &SceneSpec, path: &Path) -> Result<SurfaceSpec, Failure> {
    let refused = |what: &str| Err(Failure::Work(format!("{}: {what}", path.display())));
    let mut surfaces = spec.each_surface();
    match (surfaces.pop(), surfaces.is_empty()) {
        (Some(surface), true) if surface.object.is_some() => {
            refused("its surface is a depth object already, which has no triangles: give a mesh")
        }
        (Some(surface), true) => Ok(surface),
        _ => refused("it has several surfaces, and an object has one mesh: give the mesh's file"),
    }
}

/// Returns the mesh of a scene's surface, displaced by its height map, with one vertex per texel
/// along its edges.
fn displaced(
    spec: SceneSpec,
    surface: &SurfaceSpec,
    mut inputs: Vec<PathBuf>,
    arguments: &Arguments,
) -> Result<Subject, Failure> {
    let max_memory = Some(ByteSize(arguments.max_bytes()));
    // Nothing is rendered.
    let (size, samples, look) = (Some([1, 1].into()), Some(1), Some(Look::Plain));
    let spec = SceneSpec { max_memory, size, samples, look, ..spec };
    let scene = spec.load().map_err(of_scene_file)?;
    let [shown] = scene.surfaces() else {
        return Err(Failure::work("the scene has several surfaces: give the mesh's file"));
    };
    let settings = MeshSettings { max_bytes: arguments.max_bytes(), ..MeshSettings::default() };
    let at = |error: &dyn std::fmt::Display| {
        let input = arguments.input.display();
        Failure::Work(format!("{input}: its surface cannot be displaced: {error}"))
    };
    let mesher = Mesher::new(shown.mesh(), shown.height_map(), &settings).map_err(|error| at(&error))?;
    let needed = mesher.bytes() + mesher.vertices() * size_of::<Vertex>() as u64 + mesher.triangles() * 12;
    if needed > arguments.max_bytes() {
        let (triangles, limit) = (mesher.triangles(), ByteSize(arguments.max_bytes()));
        return Err(at(&format!(
            "its {triangles} triangles take {} MiB, more than the {limit} allowed: --max-memory raises the \
             limit, and `relief mesh` makes coarser meshes for capture to read",
            needed.div_ceil(1 << 20)
        )));
    }
    let mesh = mesher.mesh().map_err(|error| at(&error))?;
    let own = shown.color_material();
    let colors = match (&arguments.color, own) {
        (Some(path), _) => {
            let picture = read_picture(path, arguments.max_bytes()).map_err(Failure::of_picture)?;
            Some(with_picture(picture, surface))
        }
        (None, Some(material)) => {
            let given = surface.material.as_ref().and_then(|material| material.diffuse);
            let [red, green, blue] = match surface.color {
                Some(_) => given.unwrap_or([1.0; 3]),
                None => shown.material().diffuse().to_array(),
            };
            let factor = [red, green, blue, 1.0];
            Some(MeshColors::from(MeshMaterial { factor, ..material }))
        }
        (None, None) => None,
    };
    inputs.extend(arguments.color.clone());
    let mut notes = maps::of_reading(&spec, &scene, By::Keys);
    notes.extend(arguments.color.iter().flat_map(|path| maps::of_picture(path)));
    let is_left_out = colors.is_none() && shown.file_colors().is_some_and(|colors| colors.colored() > 0);
    if is_left_out {
        let what = "the colours of its mesh's materials are left out, since the mesh is displaced";
        let remark = Remark::new(&omissions::LEFT_OUT_COLORS, what);
        notes.insert(By::Keys.note(&remark.of(&arguments.input)));
    }
    Ok(Subject { mesh, colors, inputs, notes: notes.iter().map(ToString::to_string).collect() })
}

/// Reads the mesh of a file, and its colours if it has any.
fn of_mesh_file(
    path: &Path,
    (projection, up): (Option<UvProjection>, Option<Up>),
    max_bytes: u64,
    notes: &mut Vec<String>,
) -> Result<(Mesh, Option<MeshColors>), Failure> {
    let options = MeshOptions { projection, up, colors: true, max_bytes, ..MeshOptions::default() };
    let MeshFile { mesh, colors, notes: of_file, .. } = match read_mesh(path, &options) {
        Err(error) if error.problem.is_of_texture_coordinates() && projection.is_none() => {
            // Without texture coordinates no picture is laid on it, and nothing else needs them.
            let projected = MeshOptions { projection: Some(UvProjection::Box), ..options };
            read_mesh(path, &projected).map_err(Failure::of_mesh)?
        }
        other => other.map_err(Failure::of_mesh)?,
    };
    notes.extend(of_file.into_iter().map(|remark| By::Flags.note(&remark.of(path)).to_string()));
    Ok((mesh, colors))
}
