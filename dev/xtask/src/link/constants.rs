//! The module of constants that the shaders share with the host, written from the host's own.

use std::fmt::Write as _;

use relief_core::encoding::cone::HALF_RATIO;
use relief_core::encoding::seen_normal;
use relief_core::object::{EMPTY_HEIGHT, JumpCells, LEAST_COVER, LEAST_FACING};
use relief_core::{FoundState, RayUse, SliceAxis, TREE_SHIFT, Wrap};
use relief_shaders::object::MASK_CELLS;
use relief_shaders::{
    LightRayState, MAX_LIGHT_VIEWS, MAX_LIGHTS, MapSlot, SEARCH, SHADOW, STAGES, SURFACE, surface, wgsl,
};

/// The module's source.
pub fn module() -> String {
    let mut text = String::new();
    let mut constant = |name: &str, value: u32| {
        let _ = writeln!(text, "const {name} = {value}u;");
    };
    for state in FoundState::ALL {
        constant(&format!("FOUND_{}", state.name()), state as u32);
    }
    for wrap in Wrap::ALL {
        constant(&format!("WRAP_{}", wrap.name().to_uppercase()), wrap as u32);
    }
    for ray in RayUse::ALL {
        constant(&format!("RAY_{}", ray.name()), ray as u32);
    }
    for axis in SliceAxis::ALL {
        constant(&format!("SLICES_ALONG_{}", axis.name()), axis as u32);
    }
    for state in LightRayState::ALL {
        constant(&format!("LIGHT_RAY_{}", state.name()), state as u32);
    }
    for slot in MapSlot::ALL {
        constant(&format!("SLOT_{}", slot.key().to_uppercase()), slot as u32);
    }
    constant("MAP_SLOTS", MapSlot::ALL.len() as u32);
    constant("MAX_LIGHTS", MAX_LIGHTS as u32);
    constant("MAX_LIGHT_VIEWS", MAX_LIGHT_VIEWS as u32);
    constant("SHADE_GROUP", wgsl::SHADE_GROUP);
    constant("PROBE_GROUP", wgsl::PROBE_GROUP);
    constant("PROBE_ROW", wgsl::PROBE_ROW);
    constant("TESSELLATE_GROUP", wgsl::TESSELLATE_GROUP);
    constant("TESSELLATE_ROW", wgsl::TESSELLATE_ROW);
    constant("TESSELLATE_BLOCK", wgsl::TESSELLATE_BLOCK);
    constant("COARSEST", wgsl::TESSELLATE_COARSEST);
    constant("INSIDE", wgsl::TESSELLATE_INSIDE);
    constant("COUNTLESS", wgsl::TESSELLATE_COUNTLESS);
    constant("BOX_VERTICES", wgsl::BOX_VERTICES);
    constant("SHELL_FOLDED", surface::FOLDED);
    constant("SHELL_BOTH_SIDES", wgsl::SHELL_BOTH_SIDES);
    constant("SHELL_TRIANGLE", wgsl::SHELL_TRIANGLE);
    constant("SEEN_AZIMUTHS", seen_normal::AZIMUTHS);
    constant("SEEN_ELEVATIONS", seen_normal::ELEVATIONS);
    for cells in JumpCells::ALL {
        constant(&format!("CELLS_{}", cells.name().to_uppercase()), cells as u32);
    }
    constant("CELLS_MASK", MASK_CELLS);
    constant("TREE_SHIFT", TREE_SHIFT);
    constant("TREE_COLUMNS", 1 << TREE_SHIFT);
    constant("STAGES", STAGES.len() as u32);
    constant("SURFACE_STAGE", SURFACE as u32);
    constant("SEARCH_STAGE", SEARCH as u32);
    constant("SHADOW_STAGE", SHADOW as u32);
    let _ = writeln!(text, "const SHELL_SLACK = {:?};", surface::SHELL_SLACK as f32);
    let _ = writeln!(text, "const DEPTH_SLACK = {:?};", surface::DEPTH_SLACK as f32);
    let _ = writeln!(text, "const EMPTY_HEIGHT = {:?};", EMPTY_HEIGHT as f32);
    let _ = writeln!(text, "const LEAST_FRAME_FACING = {:?};", LEAST_FACING as f32);
    let _ = writeln!(text, "const LEAST_FRAME_COVER = {:?};", LEAST_COVER as f32);
    let _ = writeln!(text, "const CONE_HALF_RATIO = {HALF_RATIO:?};");
    text
}
