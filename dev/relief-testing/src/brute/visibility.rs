//! Judges the first hit of a ray from a texel's centre by the exact tracer's arithmetic.

use relief_core::exact::{cell_walk, least_gap};
use relief_core::{HeightMap, Path};

/// The ray from a texel's centre, in texture space, with `t` in steps from 0 to `reach`; `step_uv` and
/// `slope` are the changes of texture coordinates and of height a step.
pub fn path(map: &HeightMap, texel: [u32; 2], step_uv: [f64; 2], slope: f64, reach: f64) -> Path {
    let size = [f64::from(map.width()), f64::from(map.height())];
    let uv = [0, 1].map(|axis| (f64::from(texel[axis]) + 0.5) / size[axis]);
    let height = f64::from(map.texel(i64::from(texel[0]), i64::from(texel[1])));
    let mut path = Path::between([uv[0], uv[1], height], [uv[0], uv[1], height]);
    path.duv = step_uv;
    path.h[1] = slope;
    path.exit = reach;
    path
}

/// The distance to the first hit after the start in steps, in closed form; `None` for none. The start is
/// lifted by `lift` heights off the surface that it lies on.
pub fn first_hit(map: &HeightMap, path: &Path, lift: f64) -> Option<f64> {
    let mut lifted = *path;
    lifted.h[0] += lift;
    let hit = cell_walk(map, &lifted).hit;
    hit.found.then_some(hit.t)
}

/// Whether `steps` is the distance to the first point where the ray goes below the surface, give or take
/// `slack` heights of surface: the ray is on the surface there, and nowhere before below it; a ray that hits
/// where it starts is below it right behind, and one that hits nothing never is.
pub fn is_first_hit(map: &HeightMap, path: &Path, steps: Option<f64>, slack: f64) -> bool {
    match steps {
        None => least_gap(map, path, 0.0, path.exit) >= -slack,
        Some(0.0) => path.clearance(map, 1e-3) < slack,
        Some(t) => path.clearance(map, t).abs() <= slack && least_gap(map, path, 0.0, t) >= -slack,
    }
}
