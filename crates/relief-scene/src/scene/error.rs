//! What can be wrong with a scene.

use super::{Look, MapSizeProblem, ObjectProblem};
use crate::environment::EnvironmentError;
use crate::light::LightError;
use crate::material::MaterialError;
use relief_core::camera::CameraError;
use relief_core::mesh::MeshError;
use relief_core::{ByteSize, HeightMapError};
use relief_io::ReadError;
use relief_maps::MapsError;
use relief_object::ObjectFileError;
use relief_shaders::shadow::of_light_views;
use relief_shaders::{SURFACE, SelectionError, Variants};
use std::path::PathBuf;

/// Why a scene cannot be read, completed or loaded.
#[derive(Debug, thiserror::Error)]
pub enum SceneError {
    /// The scene file cannot be read.
    #[error("{}: cannot be read: {source}", path.display())]
    Io {
        /// The scene file.
        path: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// The scene file is no TOML, has an unknown key, or a value of the wrong kind.
    #[error("{}: {source}", path.display())]
    Toml {
        /// The scene file.
        path: PathBuf,
        /// What is wrong, with the line.
        source: Box<toml::de::Error>,
    },
    /// The scene file has an unknown key, or surfaces that are none.
    #[error("{}, line {line}: {what}", path.display())]
    Key {
        /// The scene file.
        path: PathBuf,
        /// The line of the key, counted from 1.
        line: usize,
        /// What is wrong.
        what: String,
    },
    /// A key of the scene file has a value that cannot be used.
    #[error("{}, line {line}: {source}", path.display())]
    InFile {
        /// The scene file.
        path: PathBuf,
        /// The line of the value, counted from 1.
        line: usize,
        /// What is wrong.
        source: ValueError,
    },
    /// The file of a mesh has keys of its surface that cannot be used.
    #[error("{}: extras.relief of its material: {what}", path.display())]
    MeshKeys {
        /// The mesh's file.
        path: PathBuf,
        /// What is wrong, with the key.
        what: String,
    },
    /// A value cannot be used.
    #[error(transparent)]
    Value(#[from] ValueError),
    /// No height map is named.
    #[error("the scene has no height map{}: name one by the key 'height'", .0.map_or(String::new(), |number| format!(" for surface {}", number + 1)))]
    NoHeightMap(
        /// The number of the surface that has none, where the scene has several.
        Option<usize>,
    ),
    /// A height map cannot be read.
    #[error(transparent)]
    Read(#[from] ReadError),
    /// A colour map, a normal map or surroundings cannot be read.
    #[error(transparent)]
    Picture(ReadError),
    /// A base mesh cannot be read.
    #[error(transparent)]
    Mesh(ReadError),
    /// An object cannot be read.
    #[error(transparent)]
    Object(#[from] ObjectFileError),
    /// A picture shows no surroundings.
    #[error("{}: {source}", path.display())]
    Environment {
        /// The picture.
        path: PathBuf,
        /// What is wrong.
        source: EnvironmentError,
    },
    /// A map that a surface reads cannot be baked.
    #[error(transparent)]
    Maps(#[from] MapsError),
    /// The picture would take more memory than allowed.
    #[error(
        "a picture of {width}x{height} pixels needs {} MiB of memory, {limit} are allowed: make it smaller or raise the limit",
        mebibytes(*needed)
    )]
    TooMuchMemory {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
        /// Bytes that rendering needs for its pixels.
        needed: u64,
        /// Bytes that may be used.
        limit: ByteSize,
    },
    /// The surfaces would take more memory than allowed, whatever lies on them.
    #[error(
        "{count} surfaces need {} MiB of memory, {limit} are allowed: use fewer surfaces or raise the limit",
        needed.div_ceil(1 << 20)
    )]
    TooManySurfaces {
        /// How many surfaces.
        count: usize,
        /// Bytes that they need.
        needed: u64,
        /// What is allowed.
        limit: ByteSize,
    },
    /// What lights see would take more memory than allowed.
    #[error(
        "what lights see needs {} MiB of memory, {} MiB of the {limit} allowed are left for it: choose fewer \
         texels for the shadow {}, or raise the limit",
        mebibytes(*needed), left / BYTES_PER_MEBIBYTE, of_light_views().or()
    )]
    TooMuchForLights {
        /// Bytes that it needs.
        needed: u64,
        /// Bytes that the picture leaves for it.
        left: u64,
        /// Bytes that may be used in all.
        limit: ByteSize,
    },
    /// The height map can be read, and rendering it would take more memory than allowed.
    #[error(
        "{}: rendering {width}x{height} texels needs {} MiB of memory, {} MiB of the {limit} allowed are left for them: use a smaller map or picture, or raise the limit",
        path.display(), mebibytes(*needed), left / BYTES_PER_MEBIBYTE
    )]
    TooMuchToTrace {
        /// The height map.
        path: PathBuf,
        /// Width in texels.
        width: u32,
        /// Height in texels.
        height: u32,
        /// Bytes that the map and what is built on it need.
        needed: u64,
        /// Bytes that the picture leaves for it.
        left: u64,
        /// Bytes that may be used in all.
        limit: ByteSize,
    },
}

const BYTES_PER_MEBIBYTE: u64 = 1 << 20;

/// For people: no less than what is needed.
fn mebibytes(bytes: u64) -> u64 {
    bytes.div_ceil(BYTES_PER_MEBIBYTE)
}

/// Value that cannot be used, with its key: a scene file's, or the same name elsewhere.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{}{key}: {problem}", .surface.map_or(String::new(), |number| format!("surface {}: ", number + 1)))]
pub struct ValueError {
    /// The number of the surface, where the scene has several and the value is one of theirs.
    pub surface: Option<usize>,
    /// The key.
    pub key: &'static str,
    /// What is wrong with it.
    pub problem: ValueProblem,
}

/// What is wrong with a value.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ValueProblem {
    /// A number is NaN, infinite or out of range.
    #[error("{value} is not possible: it must be {must}")]
    Number {
        /// The number.
        value: f64,
        /// What it must be.
        must: &'static str,
    },
    /// The picture has no pixels, or too many a side.
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
    /// The picture cannot have one pixel for each texel.
    #[error(transparent)]
    MapSize(#[from] MapSizeProblem),
    /// The scene shows nothing.
    #[error("a scene needs at least one surface")]
    NoSurface,
    /// All parts of a look are given by themselves.
    #[error(
        "nothing of '{0}' is left, as camera, lights, ambient light and its colour, background, exposure and \
         tone curve are given as well: leave the look out"
    )]
    NothingOfLook(Look),
    /// Two keys that exclude each other are given.
    #[error("cannot be given together with {0}")]
    Excludes(&'static str),
    /// A key is given without another that it needs.
    #[error("needs {0} as well")]
    Needs(&'static str),
    /// A search for the rays of a shadow is given, and the shadow sends none.
    #[error(
        "is for a shadow that sends rays to the light, and the one that is chosen sends none: choose another"
    )]
    NoShadowRays,
    /// Normals are chosen for pixels, but the surface uses its vertices' normals.
    #[error(
        "is for normals of pixels, but the surface {} uses the normals of its triangles' vertices: leave it out, or \
         choose a method that finds the relief pixel by pixel",
        Variants::of(SURFACE, |entry| !entry.paths().has_normals_of_relief()).or()
    )]
    VertexNormals,
    /// A method for objects is chosen for a relief.
    #[error(
        "the method shows objects that are known from images, and the surface has a height map on a mesh"
    )]
    NoObject,
    /// A method for reliefs is chosen for an object.
    #[error("the surface is an object that is known from images: choose 'depth-object'")]
    Object,
    /// The object cannot be shown.
    #[error(transparent)]
    ObjectOf(#[from] ObjectProblem),
    /// The camera is impossible.
    #[error(transparent)]
    Camera(#[from] CameraError),
    /// A light is impossible.
    #[error(transparent)]
    Light(#[from] LightError),
    /// The material is impossible.
    #[error(transparent)]
    Material(#[from] MaterialError),
    /// The mesh is impossible.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The displacement is impossible.
    #[error(transparent)]
    HeightMap(#[from] HeightMapError),
    /// The method, search, refinement or a setting is not available.
    #[error(transparent)]
    Selection(#[from] Box<SelectionError>),
}

impl ValueError {
    /// The same of a surface.
    pub(crate) fn of_surface(self, surface: Option<usize>) -> Self {
        Self { surface, ..self }
    }
}

impl ValueProblem {
    /// The error of this problem with the value of that key.
    pub(crate) fn of(self, key: &'static str) -> ValueError {
        ValueError { surface: None, key, problem: self }
    }
}
