//! Errors of the GPU backend.

use relief_core::Cancelled;
use relief_shaders::shadow::of_light_views;

use super::AdapterChoice;

/// Reason why the GPU gave no result.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum GpuError {
    /// The machine has no adapter of the wanted kind.
    #[error("{}{}", no_adapter(*.wanted), others_found(.found))]
    NoAdapter {
        /// Kind of adapter that was asked for.
        wanted: AdapterChoice,
        /// Adapters of other kinds that were found.
        found: Vec<String>,
    },
    /// The adapter was found, and its driver refused to open a device.
    #[error("the GPU {adapter} cannot be used: {reason}; update its driver, or render on the CPU")]
    Device {
        /// Name of the adapter.
        adapter: String,
        /// Reason that the driver gave.
        reason: String,
    },
    /// The driver gave up on the device: it hung, was reset or unplugged. Open a new
    /// [`Gpu`](super::Gpu).
    #[error("the GPU was lost: {0}; render again, with fewer steps or on the CPU if it happens again")]
    Lost(String),
    /// Memory of the GPU, or of the host for what is read back, ran out.
    #[error("out of memory; render a smaller picture or use a smaller height map")]
    OutOfMemory,
    /// The picture or a map has a longer side than the adapter's textures may have.
    #[error(
        "the {what} is {width}x{height}, the GPU takes at most {limit} a side; use a smaller one or the CPU"
    )]
    TooLarge {
        /// "picture", "height map" and so on.
        what: &'static str,
        /// Columns.
        width: u32,
        /// Rows.
        height: u32,
        /// The most columns or rows.
        limit: u32,
    },
    /// A row of the picture, with what it sees of every translucent surface, does not fit a buffer.
    #[error(
        "{surfaces} translucent surfaces in a picture {width} pixels wide are more than the GPU takes; use \
         fewer surfaces, a smaller picture or the CPU"
    )]
    TooManyTranslucent {
        /// Translucent surfaces.
        surfaces: u32,
        /// Columns.
        width: u32,
    },
    /// The settings of all bands and samples do not fit the adapter's buffers.
    #[error(
        "{samples} samples of {width}x{height} pixels are more than the GPU takes; use fewer samples, a \
         smaller picture or the CPU"
    )]
    TooManyPasses {
        /// Samples of a pixel.
        samples: usize,
        /// Columns.
        width: u32,
        /// Rows.
        height: u32,
    },
    /// The mesh does not fit the adapter's buffers.
    #[error(
        "the mesh has {count} triangles, the GPU takes at most {limit}; use a coarser mesh, fewer \
         slices or the CPU"
    )]
    TooManyTriangles {
        /// Triangles of the mesh.
        count: usize,
        /// The most that fit.
        limit: u64,
    },
    /// The mesh's vertices do not fit the adapter's buffers.
    #[error(
        "the mesh has {count} vertices, the GPU takes at most {limit}; use a coarser mesh, fewer \
         slices or the CPU"
    )]
    TooManyVertices {
        /// Vertices of the mesh.
        count: usize,
        /// The most that fit.
        limit: u64,
    },
    /// A map is empty, or has not as many texels as its size says.
    #[error("the {what} of {width}x{height} texels has {given} texels")]
    WrongLength {
        /// "colour map", "normal map" or "search's map".
        what: &'static str,
        /// Columns.
        width: u32,
        /// Rows.
        height: u32,
        /// Texels given.
        given: usize,
    },
    /// A surface's shadow rays go through all surfaces of the scene, which the shaders cannot bind
    /// at once.
    #[error(
        "the shadows of surface {} are rays through the whole scene, which the CPU alone traces; choose the \
         shadow {}, or the CPU", surface + 1, of_light_views().or()
    )]
    RaysThroughScene {
        /// The surface's number in the scene.
        surface: usize,
    },
    /// The images of an object are counted in a stencil buffer, and this device has none beside 32
    /// bits of depth. The GPU cannot do it, or the feature `DEPTH32FLOAT_STENCIL8` was not
    /// requested.
    #[error(
        "surface {}: this GPU has no stencil buffer beside 32 bits of depth; set 'geometry.pass' to \
         'product'", surface + 1
    )]
    NoStencil {
        /// The surface's number in the scene.
        surface: usize,
    },
    /// The picture has no pixels or shows no surface, and so cannot stay on the GPU.
    #[error("a picture without pixels, or that shows no surface, cannot stay on the GPU")]
    EmptyPicture,
    /// The driver or wgpu refused a command. This is a defect of Relief or of the driver.
    #[error("the GPU refused a command: {0}")]
    Refused(String),
    /// The rendering was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

fn no_adapter(wanted: AdapterChoice) -> &'static str {
    if cfg!(target_arch = "wasm32") {
        return "this browser offers no GPU by WebGPU; render on the CPU, or use another browser";
    }
    match wanted {
        AdapterChoice::Real => {
            "no hardware GPU was found; install its Vulkan driver, allow software adapters, or render on the \
             CPU"
        }
        AdapterChoice::Software => {
            "no software GPU was found; install one (Mesa's lavapipe: mesa-vulkan-drivers on Debian and \
             Ubuntu)"
        }
        AdapterChoice::Any => {
            "no GPU was found; install a Vulkan driver (mesa-vulkan-drivers on Debian and Ubuntu), or render \
             on the CPU"
        }
    }
}

fn others_found(found: &[String]) -> String {
    if found.is_empty() { String::new() } else { format!(" (there is: {})", found.join(", ")) }
}
