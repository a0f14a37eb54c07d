//! The proportions of planes and tiles.

use super::*;
use crate::scene::surface_selection::SceneContext;

/// A map of tents of 45 degrees along both axes, as a file in metres states it.
fn tents() -> HeightMap {
    let tent = |at: u32, side: u32| at.min(side - at) as f64;
    let texel_m = [3.0, 7.0];
    // Along `u` in the upper half, along `v` in the lower one.
    let height_m =
        |i: u32, j: u32| if j < 50 { tent(i, 400) * texel_m[0] } else { tent(j, 100) * texel_m[1] };
    let highest = 200.0 * texel_m[0];
    HeightMap::from_fn(400, 100, Wrap::Clamp, |i, j| (height_m(i, j) / highest) as f32)
        .and_then(|map| map.with_texel_size_m(texel_m))
        .and_then(|map| map.with_physical_range([0.0, highest]))
        .expect("a valid map")
}

#[test]
fn a_plane_has_the_proportions_of_what_lies_on_it() {
    for (tile, tile_size, sides) in [
        ([1.0, 1.0], None, [1.0, 700.0 / 1200.0]),
        ([1.0, 3.0], None, [1200.0 / 2100.0, 1.0]),
        ([0.5, 0.5], None, [1.0, 700.0 / 1200.0]),
        ([1.0, 1.0], Some([50.0, 100.0]), [0.5, 1.0]),
    ] {
        let spec = SurfaceSpec { tile: Some(tile), tile_size, ..SurfaceSpec::default() };
        let surface = spec
            .parts(1, &SceneContext::default())
            .and_then(|parts| spec.with_heights(parts, tents()))
            .expect("a surface");
        let corners = surface.mesh().vertices().iter().map(|vertex| vertex.position.as_dvec3());
        let most = corners.fold(DVec3::ZERO, DVec3::max);
        assert!((2.0 * most.x - sides[0]).abs() < 1e-6 && (2.0 * most.z - sides[1]).abs() < 1e-6, "{most}");
        if tile_size.is_none() {
            // As steep on the mesh as in the world, along both axes.
            let metric = surface.metric();
            let texel_m = metric.texel_m(surface.height_map());
            let rise = |length_m: f64| metric.scale_m * length_m / 600.0;
            for (axis, length_m) in [(0, 3.0), (1, 7.0)] {
                let degrees = (rise(length_m) / texel_m[axis]).atan().to_degrees();
                assert!((degrees - 45.0).abs() < 1e-3, "{tile:?}, axis {axis}: {degrees}");
            }
        }
    }
}

#[test]
fn a_square_stays_one_and_square_texels_are_the_default() {
    let long = HeightMap::new(8, 2, vec![0.5; 16], Wrap::Repeat).expect("a valid map");
    for (mesh, sides) in [(Builtin::Square, [1.0, 1.0]), (Builtin::Plane, [1.0, 0.25])] {
        let spec = SurfaceSpec { mesh: Some(mesh.into()), ..SurfaceSpec::default() };
        let surface =
            spec.parts(1, &SceneContext::default()).and_then(|parts| spec.with_heights(parts, long.clone()));
        let tile_m = surface.expect("a surface").metric().tile_m;
        assert!((tile_m[0] - sides[0]).abs() < 1e-6 && (tile_m[1] - sides[1]).abs() < 1e-6, "{tile_m:?}");
    }
}

#[test]
fn a_tile_of_no_length_is_refused() {
    for bad in [0.0, -1.0, 1e-320, f64::NAN, f64::INFINITY, 1e30] {
        let spec = SurfaceSpec { tile_size: Some([bad, 1.0]), ..SurfaceSpec::default() };
        assert!(spec.parts(1, &SceneContext::default()).is_err(), "{bad}");
    }
}
