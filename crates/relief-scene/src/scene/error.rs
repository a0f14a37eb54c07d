//! Errors of reading, completing and loading a scene.

use super::material_spec::metallic_roughness;
use super::{Look, MapSizeProblem, ObjectProblem, RampError};
use crate::environment::EnvironmentError;
use crate::light::LightError;
use crate::material::MaterialError;
use crate::material_maps::MaterialMapError;
use crate::motif::MotifFileError;
use relief_core::camera::CameraError;
use relief_core::mesh::MeshError;
use relief_core::{ByteSize, HeightMapError, MotifTreeError, VolumeError, Wrap};
use relief_io::{ReadError, TextureSetError};
use relief_maps::MapsError;
use relief_mesh::shell_map::ShellMapError;
use relief_object::ObjectFileError;
use relief_shaders::shadow::of_light_views;
use relief_shaders::surface::Proposal;
use relief_shaders::{SHADE, STAGES, SURFACE, SelectionError, Variants};
use std::path::PathBuf;

/// Reason why a scene cannot be read, completed or loaded.
#[derive(Debug, thiserror::Error)]
pub enum SceneError {
    /// The scene file cannot be read.
    #[error("{}: cannot be read: {source}", path.display())]
    Io {
        /// Path of the scene file.
        path: PathBuf,
        /// Error of the operating system.
        source: std::io::Error,
    },
    /// The scene file is not TOML, has an unknown key, or has a value of the wrong type.
    #[error("{}: {source}", path.display())]
    Toml {
        /// Path of the scene file.
        path: PathBuf,
        /// Error of the TOML reader, with the line.
        source: Box<toml::de::Error>,
    },
    /// The scene file has an unknown key, or `surfaces` is not a list of tables.
    #[error("{}, line {line}: {what}", path.display())]
    Key {
        /// Path of the scene file.
        path: PathBuf,
        /// Line of the key, counted from 1.
        line: usize,
        /// Description of the problem.
        what: String,
    },
    /// A key of the scene file has a value that cannot be used.
    #[error("{}, line {line}: {source}", path.display())]
    InFile {
        /// Path of the scene file.
        path: PathBuf,
        /// Line of the value, counted from 1.
        line: usize,
        /// Description of the problem.
        source: ValueError,
    },
    /// The file of a mesh has keys for its surface that cannot be used.
    #[error("{}: extras.relief of its material: {what}", path.display())]
    MeshKeys {
        /// Path of the mesh's file.
        path: PathBuf,
        /// Description of the problem, with the key.
        what: String,
    },
    /// A value cannot be used.
    #[error(transparent)]
    Value(#[from] ValueError),
    /// No height map is named.
    #[error(
        "the scene has no height map{}: name one by the key 'height'",
        .0.map_or(String::new(), |number| format!(" for surface {}", number + 1))
    )]
    NoHeightMap(
        /// Index of the surface without a height map, if the scene has several.
        Option<usize>,
    ),
    /// A height map cannot be read.
    #[error(transparent)]
    Read(#[from] ReadError),
    /// A colour map, a table of colours, a normal map or an environment map cannot be read.
    #[error(transparent)]
    Picture(ReadError),
    /// The textures of a folder cannot be used.
    #[error(transparent)]
    Textures(#[from] TextureSetError),
    /// A material map cannot be used.
    #[error("{}: {source}", path.display())]
    MaterialMap {
        /// Path of the map.
        path: PathBuf,
        /// Description of the problem.
        source: MaterialMapError,
    },
    /// The height map cannot have the colours of a table.
    #[error("{}: {source}", path.display())]
    Ramp {
        /// Path of the height map.
        path: PathBuf,
        /// Description of the problem.
        source: RampError,
    },
    /// A base mesh cannot be read.
    #[error(transparent)]
    Mesh(ReadError),
    /// A volume cannot be read.
    #[error(transparent)]
    Volume(ReadError),
    /// A motif cannot be read.
    #[error(transparent)]
    Motif(#[from] MotifFileError),
    /// A motif cannot be shown.
    #[error("{}: {source}", path.display())]
    NoMotif {
        /// Path of the motif.
        path: PathBuf,
        /// Description of the problem.
        source: ShellMapError,
    },
    /// An object cannot be read.
    #[error(transparent)]
    Object(#[from] ObjectFileError),
    /// A picture is no environment map.
    #[error("{}: {source}", path.display())]
    Environment {
        /// Path of the picture.
        path: PathBuf,
        /// Description of the problem.
        source: EnvironmentError,
    },
    /// A map that a surface reads cannot be baked.
    #[error(transparent)]
    Maps(#[from] MapsError),
    /// The picture would need more memory than the limit.
    #[error(
        "a picture of {width}x{height} pixels needs {} MiB of memory, {limit} are allowed: make it smaller \
         or raise the limit",
        mebibytes(*needed)
    )]
    TooMuchMemory {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
        /// Bytes that rendering needs for its pixels.
        needed: u64,
        /// Memory limit.
        limit: ByteSize,
    },
    /// The surfaces themselves, without their maps, would need more memory than the limit.
    #[error(
        "{count} surfaces need {} MiB of memory, {limit} are allowed: use fewer surfaces or raise the limit",
        needed.div_ceil(1 << 20)
    )]
    TooManySurfaces {
        /// Number of surfaces.
        count: usize,
        /// Bytes that the surfaces need.
        needed: u64,
        /// Memory limit.
        limit: ByteSize,
    },
    /// The shadow maps would need more memory than the limit.
    #[error(
        "shadow maps need {} MiB of memory, {} MiB of the {limit} allowed are left for them: choose fewer \
         texels for the shadow {}, or raise the limit",
        mebibytes(*needed), left / BYTES_PER_MEBIBYTE, of_light_views().or()
    )]
    TooMuchForShadowMaps {
        /// Bytes that the shadow maps need.
        needed: u64,
        /// Bytes left by the picture.
        left: u64,
        /// Memory limit.
        limit: ByteSize,
    },
    /// Rendering the height map would need more memory than the limit.
    #[error(
        "{}: rendering {width}x{height} texels needs {} MiB of memory, {} MiB of the {limit} allowed are \
         left for them: use a smaller map or picture, or raise the limit",
        path.display(), mebibytes(*needed), left / BYTES_PER_MEBIBYTE
    )]
    TooMuchToTrace {
        /// Path of the height map.
        path: PathBuf,
        /// Width in texels.
        width: u32,
        /// Height in texels.
        height: u32,
        /// Bytes for the map and what is built on it.
        needed: u64,
        /// Bytes left by the picture.
        left: u64,
        /// Memory limit.
        limit: ByteSize,
    },
}

const BYTES_PER_MEBIBYTE: u64 = 1 << 20;

/// Mebibytes for messages, rounded up.
fn mebibytes(bytes: u64) -> u64 {
    bytes.div_ceil(BYTES_PER_MEBIBYTE)
}

/// Value that cannot be used, with its key in scene files.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{}{key}: {problem}", .surface.map_or(String::new(), |number| format!("surface {}: ", number + 1)))]
pub struct ValueError {
    /// Index of the surface, if the value belongs to one of several.
    pub surface: Option<usize>,
    /// Key in scene files.
    pub key: &'static str,
    /// Problem of the value.
    pub problem: ValueProblem,
}

/// Problem of a value.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ValueProblem {
    /// A number is NaN, infinite or out of range.
    #[error("{value} is not possible: it must be {must}")]
    Number {
        /// The number.
        value: f64,
        /// Valid values.
        must: &'static str,
    },
    /// Nothing has that name.
    #[error(transparent)]
    UnknownName(Box<relief_core::registry::UnknownName>),
    /// The picture has no pixels, or too many along a side.
    #[error(
        "{width}x{height} pixels are not possible: each side must be from 1 to {}",
        super::limits::MAX_IMAGE_SIDE
    )]
    Size {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
    },
    /// The picture cannot have one pixel per texel.
    #[error(transparent)]
    MapSize(#[from] MapSizeProblem),
    /// The scene shows nothing.
    #[error("a scene needs at least one surface")]
    NoSurface,
    /// Every part of the look is overridden.
    #[error(
        "'{0}' has no effect, as camera, lights, ambient light and its colour, background, exposure and tone \
         curve are given as well: leave the look out"
    )]
    NothingOfLook(Look),
    /// Two keys that exclude each other are given.
    #[error("cannot be given together with {0}: leave one out")]
    Excludes(&'static str),
    /// A key is given without another that it needs.
    #[error("needs {0} as well")]
    Needs(&'static str),
    /// Values of two shading models are given for a material.
    #[error(
        "has {plain}, of the shading {}, and {rough}, of {}: leave one of them out",
        STAGES[SHADE].entries[0].name, metallic_roughness()
    )]
    MixedMaterial {
        /// Value of the shading `blinn-phong`.
        plain: &'static str,
        /// Value or map of the shading `metallic-roughness`.
        rough: &'static str,
    },
    /// A value of a material is given that the named shading does not read.
    #[error("has {part}, which the shading {shading} does not read: leave it out, or leave the shading out")]
    NotOfShading {
        /// Name of the value or the map.
        part: &'static str,
        /// Name of the shading.
        shading: &'static str,
    },
    /// Walls are asked for around another mesh than a plane.
    #[error("closes the built-in plane and square, and no other mesh: leave the walls or the mesh out")]
    WallsOfMesh,
    /// Walls are asked for around a relief that does not show its sides.
    #[error(
        "needs a relief that is seen from the side: choose a method with a search, and the surface {}, or \
         displaced triangles",
        shells().or()
    )]
    WallsOfBase,
    /// A search for shadow rays is given, but the shadow variant has no rays.
    #[error(
        "is for shadows with rays toward the light, and the chosen shadow has none: leave it out or choose \
         another shadow"
    )]
    NoShadowRays,
    /// A normal map or creases are given, but the surface uses its vertices' normals.
    #[error(
        "is for normals per pixel, and the surface {} uses the normals of its triangles' vertices: leave it \
         out, or choose a method that finds the relief pixel by pixel",
        Variants::of(SURFACE, |entry| !entry.paths().has_normals_of_relief()).or()
    )]
    VertexNormals,
    /// A method for depth objects is chosen for a height map on a mesh.
    #[error(
        "the method shows depth objects, and the surface is a height map on a mesh: choose another method"
    )]
    NoObject,
    /// A method for height maps is chosen for a depth object.
    #[error("the method shows height maps, and the surface is a depth object: choose 'depth-object'")]
    Object,
    /// An extinction is given for what is no translucent volume.
    #[error("is of translucent volumes: choose the method 'translucent' for a volume, or leave it out")]
    NotTranslucent,
    /// A method for volumes is chosen for a height map.
    #[error(
        "the method shows volumes, and the surface has none: give a volume (a KTX2 file), or choose another \
         method"
    )]
    NoVolume,
    /// A method for other surfaces is chosen for a volume.
    #[error("the method shows no volumes, and the surface has one: choose 'voxels'")]
    Volume,
    /// A method for motifs is chosen for another surface.
    #[error(
        "the method shows motifs, and the surface has none: give a motif (a mesh), or choose another method"
    )]
    NoMotif,
    /// A method for other surfaces is chosen for a motif.
    #[error("the method shows no motifs, and the surface has one: choose 'shell-map'")]
    Motif,
    /// A motif repeats, and nothing else.
    #[error("is '{0}', and a motif repeats: leave it out")]
    WrapOfMotif(Wrap),
    /// A normal map is given for a motif.
    #[error(
        "is for height maps, and the surface has a motif, whose triangles give the normals: leave it out"
    )]
    NormalsOfMotif,
    /// A normal map is given for a volume.
    #[error("is for height maps, and the surface has a volume, whose field gives the normals: leave it out")]
    NormalsOfVolume,
    /// The object cannot be shown.
    #[error(transparent)]
    ObjectOf(#[from] ObjectProblem),
    /// The camera is invalid.
    #[error(transparent)]
    Camera(#[from] CameraError),
    /// A light is invalid.
    #[error(transparent)]
    Light(#[from] LightError),
    /// The material is invalid.
    #[error(transparent)]
    Material(#[from] MaterialError),
    /// The mesh is invalid.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The displacement is invalid.
    #[error(transparent)]
    HeightMap(#[from] HeightMapError),
    /// The motif is invalid.
    #[error(transparent)]
    MotifTriangles(#[from] MotifTreeError),
    /// The volume is invalid.
    #[error(transparent)]
    VolumeValues(#[from] VolumeError),
    /// The method, search, refinement or a setting is not available.
    #[error(transparent)]
    Selection(#[from] Box<SelectionError>),
}

/// Surfaces that show a relief from the side.
fn shells() -> Variants {
    Variants::of(SURFACE, |entry| entry.paths().has_relief() && entry.paths().proposal == Proposal::Shells)
}

impl ValueError {
    /// Returns this error with the index of a surface.
    pub(crate) fn of_surface(self, surface: Option<usize>) -> Self {
        Self { surface, ..self }
    }
}

impl ValueProblem {
    /// Returns the error of this problem with a key.
    pub(crate) fn of(self, key: &'static str) -> ValueError {
        ValueError { surface: None, key, problem: self }
    }
}
