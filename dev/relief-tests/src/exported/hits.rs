//! Hits of functions on the renderer's own paths, beside the renderer's.

use std::sync::Arc;

use relief_core::HeightMap;
use relief_export::ExportedFunctions;
use relief_render::gpu::Prober;
use relief_render::job::JobSurface;
use relief_shaders::Selection;
use relief_shaders::cpu::{Frame, Hit, Path, PixelIn};
use relief_shaders::wgsl::Sampling;

use super::Device;
use super::called::OnPath;
use super::dialect::Dialect;
use crate::baked::maps_for;
use crate::one_source::cases::bare_surface;

/// The most cells or steps that a stage may take: see `one_source`.
const LONGEST_LOOP: f64 = 16_384.0;

/// A selection whose loops end before a software device ends them.
pub fn shortened(mut selection: Selection) -> Selection {
    for stage in ["search", "refine", "shadow-search"] {
        // Some have no limit.
        let _ = selection.set(&format!("{stage}.limit"), LONGEST_LOOP);
    }
    selection
}

/// A surface of a map for a selection, with the baked maps that it reads.
///
/// # Panics
///
/// When a map cannot be baked.
pub fn surface_of(map: HeightMap, selection: Selection) -> JobSurface {
    let map = Arc::new(map);
    bare_surface(Arc::clone(&map), selection, maps_for(&map, &selection))
}

/// Returns the renderer's paths of rays.
pub fn paths_of(surface: &JobSurface, rays: &[PixelIn]) -> Vec<Path> {
    let program = surface.program(Frame::none(), None);
    let path = |ray: &PixelIn| {
        let at = program.enter(*ray);
        (at.segments > 0).then(|| program.segment(*ray, at, 0)).filter(|path| path.exit > 0.0)
    };
    rays.iter().filter_map(path).collect()
}

/// Returns how many hits of functions on the renderer's paths differ in a bit from the renderer's own,
/// on that device.
///
/// # Panics
///
/// When the functions are none that this device runs.
pub fn differing_hits(
    device: &Device,
    prober: &mut Prober,
    text: &ExportedFunctions,
    surface: &JobSurface,
    rays: &[PixelIn],
) -> usize {
    let paths = paths_of(surface, rays);
    let found = device.traced(text, surface, &paths, Dialect::Wgsl);
    let hits = prober.trace(surface, Sampling::Exact, &paths).expect("hits");
    let differs = |(hit, found): &(&Hit, &OnPath)| {
        let bits = [hit.uv.x, hit.uv.y, hit.t].map(f32::to_bits);
        let other = [found.uv[0], found.uv[1], found.t].map(f32::to_bits);
        (hit.found == 1) != found.found || (found.found && bits != other)
    };
    assert_eq!(hits.len(), found.len());
    hits.iter().zip(&found).filter(differs).count()
}
