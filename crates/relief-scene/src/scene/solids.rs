//! Volumes and motifs on surfaces: the level maps under them, and the shells that fold.

use super::Surface;
use super::error::{ValueError, ValueProblem};
use relief_core::{HeightMap, Wrap};
use relief_io::{Remark, VolumeFile, omissions};
use relief_mesh::shell_map::folded_shells;
use relief_shaders::surface::Proposal;

/// Returns a remark on shells that fold, where a motif or a volume is shown in shells.
pub(super) fn folded_remark(surface: &Surface) -> Option<Remark> {
    if surface.selection().paths().proposal != Proposal::Shells {
        return None;
    }
    let map = surface.height_map();
    let folded = folded_shells(surface.mesh(), [map.bias_m(), map.bias_m() + map.scale_m()]).len();
    let what = format!(
        "the shells of {folded} triangles of the mesh fold, as they are deeper than its curvature allows"
    );
    (folded > 0).then(|| Remark::new(&omissions::FOLDED_SHELLS, what))
}

/// Returns a level map of one texel for a motif between those heights above the base, on such tiles.
pub(super) fn ground_of_motif(heights_m: [f64; 2], tile_m: [f64; 2]) -> Result<HeightMap, ValueError> {
    let ground = || {
        let map = HeightMap::new(1, 1, vec![0.0], Wrap::Repeat)?;
        map.with_texel_size_m(tile_m)?.with_stated_displacement_m(heights_m)
    };
    ground().map_err(|error: relief_core::HeightMapError| ValueProblem::from(error).of("motif"))
}

/// Returns a level map that has the columns, rows, wrap, tile and displacement of a volume.
pub(super) fn ground_of(file: &VolumeFile) -> Result<HeightMap, ValueError> {
    let VolumeFile { volume, tile_m, .. } = file;
    let [width, height, _] = volume.size();
    let ground = || {
        let map = HeightMap::new(width, height, vec![0.0; width as usize * height as usize], volume.wrap())?;
        let Some([u, v]) = tile_m else { return Ok(map) };
        let (scale_m, bias_m) = (volume.atlas().scale_m(), volume.atlas().bias_m());
        map.with_texel_size_m([u / f64::from(width), v / f64::from(height)])?
            .with_stated_displacement_m([bias_m, bias_m + scale_m])
    };
    ground().map_err(|error: relief_core::HeightMapError| ValueProblem::from(error).of("volume"))
}
