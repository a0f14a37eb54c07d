//! What can go wrong on a GPU.

use relief_core::Cancelled;
use relief_shaders::shadow::of_light_views;

use super::AdapterChoice;

/// Why the GPU gave no result.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum GpuError {
    /// The machine has no adapter of the wanted kind.
    #[error("{}{}", no_adapter(*.wanted), seen(.found))]
    NoAdapter {
        /// What was asked for.
        wanted: AdapterChoice,
        /// The adapters that there are, of other kinds.
        found: Vec<String>,
    },
    /// The adapter is there and refuses to work.
    #[error("the GPU {adapter} cannot be used: {reason}; update its driver, or render on the CPU")]
    Device {
        /// Name of the adapter.
        adapter: String,
        /// What the driver said.
        reason: String,
    },
    /// The driver gave up on the device: it hung, was reset or unplugged. A new `Gpu` has to be made.
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
    /// A surface's shadows are rays through all surfaces of the scene, which the shaders do not have at once.
    #[error(
        "the shadows of surface {} are rays through the whole scene, which the CPU alone traces; choose the \
         shadow {}, or the CPU", surface + 1, of_light_views().or()
    )]
    RaysThroughScene {
        /// The surface's number in the scene.
        surface: usize,
    },
    /// The images of an object are to be counted in a stencil buffer, and this GPU has none beside 32 bits of
    /// depth, or the device was opened without the feature `DEPTH32FLOAT_STENCIL8`.
    #[error(
        "surface {}: this GPU has no stencil buffer beside 32 bits of depth; set 'geometry.pass' to \
         'product'", surface + 1
    )]
    NoStencil {
        /// The surface's number in the scene.
        surface: usize,
    },
    /// A picture without pixels, or of nothing, cannot stay on the GPU.
    #[error("a picture without pixels, or that shows no surface, cannot stay on the GPU")]
    EmptyPicture,
    /// The driver or wgpu refused a command; a defect, of Relief or of the driver.
    #[error("the GPU refused a command: {0}")]
    Refused(String),
    /// The rendering was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

fn no_adapter(wanted: AdapterChoice) -> &'static str {
    match wanted {
        AdapterChoice::Real => {
            "no hardware GPU was found; install its Vulkan driver, allow software adapters, or render on the CPU"
        }
        AdapterChoice::Software => {
            "no software GPU was found; install one (Mesa's lavapipe: mesa-vulkan-drivers on Debian and Ubuntu)"
        }
        AdapterChoice::Any => {
            "no GPU was found; install a Vulkan driver (mesa-vulkan-drivers on Debian and Ubuntu), or render on the CPU"
        }
    }
}

fn seen(found: &[String]) -> String {
    if found.is_empty() { String::new() } else { format!(" (there is: {})", found.join(", ")) }
}
