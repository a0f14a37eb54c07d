//! Heights between two meshes: they are those that the detailed mesh was made with, and displace the simple
//! mesh onto it.

use std::f64::consts::TAU;

use glam::{DVec2, Vec2, Vec3};
use relief_bake::from_meshes::{
    FromMeshesError, Layer, MeshPair, PairedHeights, heights_from_meshes, normals_from_meshes,
};
use relief_core::mesh::{BasePoint, Mesh, Placement, Vertex, cylinder, sphere, square, torus};
use relief_core::raycast::RayCaster;
use relief_core::{HeightMap, Watch, Wrap};
use relief_mesh::{MeshSettings, Mesher, Seams};
use relief_testing::mesh_distance::{apart, corners_of};

/// A height in metres at a place on the map.
type Known = fn(DVec2) -> f64;

/// Waves that tile, and have no symmetry; level at the ends of `v`, where a sphere has its poles.
fn waves(at: DVec2) -> f64 {
    let wave = (TAU * (3.0 * at.x + at.y)).sin() + 0.5 * (TAU * (2.0 * at.y - 5.0 * at.x)).cos();
    0.004 + 0.006 * wave * (0.5 * TAU * at.y).sin().powi(2)
}

/// A base displaced by known heights, so finely that triangles differ by little from them.
fn displaced(base: &Mesh, known: Known, size: [u32; 2]) -> RayCaster {
    let [low, span] = [-0.02, 0.04];
    let texel = |i: u32, j: u32| {
        let at = DVec2::new(f64::from(i) + 0.5, f64::from(j) + 0.5);
        ((known(at / DVec2::new(size[0].into(), size[1].into())) - low) / span) as f32
    };
    let map = HeightMap::from_fn(size[0], size[1], Wrap::Repeat, texel).expect("heights from 0 to 1");
    let map = map.with_displacement(span, low).expect("lengths");
    // At seams of the texture, as between the triangles at a pole, each side keeps its own heights.
    let settings = MeshSettings { seams: Seams::Keep, ..MeshSettings::default() };
    let mesher = Mesher::new(base, &map, &settings).expect("a mesh");
    RayCaster::new(&mesher.mesh().expect("finite"))
}

fn found(low: &Mesh, high: &RayCaster, pair: &MeshPair) -> PairedHeights {
    heights_from_meshes(low, high, pair, &Watch::none()).expect("heights")
}

/// Greatest distance of a map's heights from known ones, in metres, with texel centres moved by the given
/// texels.
fn furthest(heights: &PairedHeights, centres: &[(BasePoint, usize)], moved: f64) -> f64 {
    let moved = DVec2::splat(moved) / DVec2::from(heights.size.map(f64::from));
    let error =
        |(base, at): &(BasePoint, usize)| (f64::from(heights.metres[*at]) - waves(base.uv + moved)).abs();
    centres.iter().map(error).fold(0.0, f64::max)
}

/// The same mesh with other texture coordinates.
fn laid(mesh: &Mesh, uv: impl Fn(Vec2) -> Vec2) -> Mesh {
    let moved = |vertex: &Vertex| Vertex { uv: uv(vertex.uv), ..*vertex };
    Mesh::new(mesh.vertices().iter().map(moved).collect(), mesh.triangles().to_vec()).expect("a mesh")
}

#[test]
fn known_heights_come_back() {
    for (name, base, size) in [
        ("torus", torus(12, 8).expect("a mesh"), [96, 48]),
        ("sphere", sphere(16, 8).expect("a mesh"), [67, 45]),
        ("square", square(3).expect("a mesh"), [48, 40]),
    ] {
        let high = displaced(&base, waves, [768, 512]);
        let heights = found(&base, &high, &MeshPair::new(size));
        // At the poles of a sphere triangles leave corners of the map bare.
        let centres = centres(&base, size);
        assert_eq!((heights.covered, heights.holes), (centres.len() as u64, 0), "{name}");
        assert_eq!((heights.overlaps, heights.without_area, heights.without_value), (0, 0, 0), "{name}");
        let apart = furthest(&heights, &centres, 0.0);
        println!("{name}: {apart:.1e} m");
        assert!(apart < 2e-5, "{name}: {apart}");
        // Half a texel is seen.
        assert!(furthest(&heights, &centres, 0.5) > 20.0 * apart, "{name}");
        let [least, greatest] = heights.range_m;
        let filled = least - 1e-3..=greatest + 1e-3;
        assert!(heights.metres.iter().all(|&metres| filled.contains(&f64::from(metres))), "{name}");
        // Normals that are made unit would give other heights where they bend.
        if name != "square" {
            let mut unit = heights.clone();
            centres.iter().for_each(|(base, at)| unit.metres[*at] *= base.normal.length() as f32);
            assert!(furthest(&unit, &centres, 0.0) > 20.0 * apart, "{name}");
        }
    }
}

/// The base points of texels' centres, by a search of its own.
fn centres(base: &Mesh, [width, height]: [u32; 2]) -> Vec<(BasePoint, usize)> {
    let places = (0..height).flat_map(|row| (0..width).map(move |column| (column, row)));
    let of_place = |(column, row): (u32, u32)| {
        let uv = DVec2::new(f64::from(column) + 0.5, f64::from(row) + 0.5)
            / DVec2::new(width.into(), height.into());
        let point = (0..base.triangles().len() as u32).find_map(|triangle| on(base, triangle, uv))?;
        Some((point, row as usize * width as usize + column as usize))
    };
    places.filter_map(of_place).collect()
}

/// The base point of a place on the map, if that triangle lies there.
fn on(base: &Mesh, triangle: u32, uv: DVec2) -> Option<BasePoint> {
    let corners = base.corners(triangle).map(BasePoint::from);
    let [a, b, c] = corners.map(|corner| corner.uv);
    let area = (b - a).perp_dot(c - a);
    let weights = [(b - uv).perp_dot(c - uv), (c - uv).perp_dot(a - uv), (a - uv).perp_dot(b - uv)];
    let weights = weights.map(|part| part / area);
    weights.iter().all(|weight| *weight >= -1e-12).then(|| BasePoint::weighted(corners, weights))
}

#[test]
fn the_simple_mesh_displaced_lies_on_the_detailed_one() {
    // Of the simple meshes none is the one that was displaced.
    for (name, base, low, size) in [
        ("torus", torus(64, 32), torus(16, 10), [128, 64]),
        ("sphere", sphere(64, 32), sphere(16, 12), [128, 64]),
        (
            "cylinder",
            cylinder(64, 1).map(|mesh| side(&mesh, 64)),
            cylinder(16, 2).map(|mesh| side(&mesh, 32)),
            [128, 40],
        ),
    ] {
        let (base, low) = (base.expect("a mesh"), low.expect("a mesh"));
        let fine = HeightMap::from_fn(256, 128, Wrap::Repeat, |i, j| {
            let at = DVec2::new(f64::from(i) + 0.5, f64::from(j) + 0.5) / DVec2::new(256.0, 128.0);
            ((waves(at) + 0.02) / 0.04) as f32
        });
        let fine = fine.and_then(|map| map.with_displacement(0.04, -0.02)).expect("heights");
        let high =
            Mesher::new(&base, &fine, &MeshSettings::default()).expect("a mesh").mesh().expect("finite");
        let heights = found(&low, &RayCaster::new(&high), &MeshPair::new(size));
        let map = heights.to_map(Wrap::Repeat).expect("every texel has a value");
        let high = corners_of(&high);
        let (all, within) = apart(&low, &high, &map, 0.0);
        let p99 = all[all.len() * 99 / 100];
        println!(
            "{name}: p99 {p99:.3} texels, {:.2} % within half a texel, {} holes",
            100.0 * within,
            heights.holes
        );
        assert!(p99 < 0.5 && within >= 0.95, "{name}: {p99} {within}");
        // A map of other metres is seen.
        assert!(apart(&low, &high, &map, 0.02).1 < 0.5, "{name}");
    }
}

#[test]
fn a_mesh_of_many_charts_lies_on_the_detailed_one() {
    let Some(base) = relief_tests::spot("spot_triangulated.obj") else { return };
    let Some(cage) = relief_tests::spot("spot_control_mesh.obj") else { return };
    let fine = HeightMap::from_fn(512, 512, Wrap::Repeat, |i, j| {
        let at = DVec2::new(f64::from(i) + 0.5, f64::from(j) + 0.5) / 512.0;
        ((waves(at) + 0.02) / 0.04) as f32
    });
    let fine = fine.and_then(|map| map.with_displacement(0.04, -0.02)).expect("heights");
    let high = Mesher::new(&base, &fine, &MeshSettings::default()).expect("a mesh").mesh().expect("finite");
    let (caster, high) = (RayCaster::new(&high), corners_of(&high));
    // The cage of its subdivision is so coarse that its own triangles are folded here and there.
    for (name, low) in [("spot", &base), ("its cage", &cage)] {
        let heights = found(low, &caster, &MeshPair::new([384, 384]));
        let map = heights.to_map(Wrap::Repeat).expect("every texel has a value");
        let (all, within) = apart(low, &high, &map, 0.0);
        let p99 = all[all.len() * 99 / 100];
        let (covered, holes) = (heights.covered, heights.holes);
        println!(
            "{name}: p99 {p99:.3} texels, {:.2} % within half a texel, {holes} holes of {covered}",
            100.0 * within
        );
        assert!(within > 0.95, "{name}: {within}");
    }
}

/// First triangles of a mesh, by the number of pairs: a cylinder's side without its caps.
fn side(mesh: &Mesh, quads: usize) -> Mesh {
    Mesh::new(mesh.vertices().to_vec(), mesh.triangles()[..2 * quads].to_vec()).expect("a mesh")
}

#[test]
fn a_cylinder_of_32_triangles_becomes_round() {
    let low = side(&cylinder(16, 1).expect("a mesh"), 16);
    assert_eq!(low.triangles().len(), 32);
    let high = side(&cylinder(1024, 1).expect("a mesh"), 1024);
    let heights = found(&low, &RayCaster::new(&high), &MeshPair::new([256, 80]));
    assert_eq!((heights.covered, heights.holes), (256 * 80, 0));
    let map = heights.to_map(Wrap::Repeat).expect("every texel has a value");
    let (all, _) = apart(&low, &corners_of(&high), &map, 0.0);
    let flat = HeightMap::from_fn(256, 80, Wrap::Repeat, |_, _| 0.0).expect("a map");
    let (before, _) = apart(&low, &corners_of(&high), &flat, 0.0);
    let [p99, most] = [all[all.len() * 99 / 100], all[all.len() - 1]];
    println!("p99 {p99:.4}, at most {most:.4} texels; flat in the middle {:.3}", before[before.len() / 2]);
    assert!(most < 0.1, "{p99} {most}");
    // Without a map it is nowhere near.
    assert!(before[before.len() / 2] > 0.5);
}

#[test]
fn a_mesh_is_no_distance_from_itself() {
    for mesh in [torus(9, 7), sphere(10, 6), square(2), cylinder(7, 2).map(|mesh| side(&mesh, 14))] {
        let mesh = mesh.expect("a mesh");
        for wrap in Wrap::ALL {
            for layer in Layer::ALL {
                let pair = MeshPair { wrap, layer, cage_m: Some(0.02), ..MeshPair::new([31, 17]) };
                let heights = found(&mesh, &RayCaster::new(&mesh), &pair);
                assert!(heights.metres.iter().all(|&metres| metres == 0.0) && heights.holes == 0, "{wrap}");
                assert_eq!((heights.mean_abs_m, heights.range_m), (0.0, [0.0; 2]));
                let map = heights.to_map(wrap).expect("a map");
                assert_eq!((map.scale_m(), map.bias_m()), (0.0, 0.0));
            }
        }
    }
}

#[test]
fn normals_are_those_of_the_detailed_mesh_in_the_frame_of_the_simple_one() {
    let size = [64, 40];
    let (low, high) = (sphere(16, 10).expect("a mesh"), sphere(128, 64).expect("a mesh"));
    // Its middle lies elsewhere, so that the normals of both differ.
    let middle = Vec3::new(0.01, 0.03, -0.02);
    let aside = Placement { position_m: middle.as_dvec3(), ..Placement::default() };
    let high = high.placed(&aside).expect("a mesh");
    for (low, size) in [(low.clone(), size), (laid(&low, |uv| uv + Vec2::new(1.25, 0.0)), size)] {
        let caster = RayCaster::new(&high);
        let pair = MeshPair::new(size);
        let planes = normals_from_meshes(&low, &high, &caster, &pair, &Watch::none()).expect("normals");
        let heights = found(&low, &caster, &pair);
        let mut met = 0;
        for ((x, y), z) in planes[0].iter().zip(&planes[1]).zip(&planes[2]) {
            assert!((Vec3::new(*x, *y, *z).length() - 1.0).abs() < 1e-6, "{x} {y} {z}");
        }
        // Where the simple mesh is displaced to, the sphere's normal points away from its middle.
        for triangle in 0..low.triangles().len() as u32 {
            for (base, weights, at) in texels_of(&low, triangle, size) {
                let vertex = low.interpolated(triangle, weights.map(|weight| weight as f32));
                let [along_u, along_v, out] =
                    [vertex.tangent, vertex.bitangent, vertex.normal].map(|v| v.as_dvec3().normalize());
                let [x, y, z] = [0, 1, 2].map(|axis| f64::from(planes[axis][at]));
                let world = (along_u * x - along_v * y + out * z).normalize();
                let point = base.displaced(f64::from(heights.metres[at]));
                let expected = (point - middle.as_dvec3()).normalize();
                let apart = world.angle_between(expected).to_degrees();
                assert!(apart < 0.1, "{apart} at {}", base.uv);
                // Green the other way round is seen.
                let wrong = (along_u * x + along_v * y + out * z).angle_between(expected).to_degrees();
                met += usize::from(wrong > 0.5);
            }
        }
        assert!(met > 500, "{met}");
    }
    let own = RayCaster::new(&low);
    let pair = MeshPair::new(size);
    let planes = normals_from_meshes(&low, &low, &own, &pair, &Watch::none()).expect("normals");
    let covered = centres(&low, size);
    assert!(covered.iter().all(|(_, at)| planes[2][*at] > 1.0 - 1e-6));
}

/// The base points of a triangle under texels' centres, with their weights and the texels, tiled.
fn texels_of(mesh: &Mesh, triangle: u32, [width, height]: [u32; 2]) -> Vec<(BasePoint, [f64; 3], usize)> {
    let corners = mesh.corners(triangle).map(BasePoint::from);
    let size = DVec2::new(width.into(), height.into());
    let [a, b, c] = corners.map(|corner| corner.uv * size - 0.5);
    let area = (b - a).perp_dot(c - a);
    let (low, high) = (a.min(b).min(c).ceil().as_ivec2(), a.max(b).max(c).floor().as_ivec2());
    let places = (low.y..=high.y).flat_map(|row| (low.x..=high.x).map(move |column| [column, row]));
    let of_place = |[column, row]: [i32; 2]| {
        let p = DVec2::new(column.into(), row.into());
        let parts = [(b - p).perp_dot(c - p), (c - p).perp_dot(a - p), (a - p).perp_dot(b - p)];
        let weights = parts.map(|part| part / area);
        let column = column.rem_euclid(width as i32) as usize;
        // Well inside, so that no other triangle owns it.
        let is_inside = weights.iter().all(|weight| *weight > 1e-3) && (0..height as i32).contains(&row);
        let at = row.max(0) as usize * width as usize + column;
        is_inside.then(|| (BasePoint::weighted(corners, weights), weights, at))
    };
    places.filter_map(of_place).collect()
}

#[test]
fn heights_are_the_same_bytes_on_any_number_of_threads() {
    let (low, high) = (torus(11, 7).expect("a mesh"), RayCaster::new(&sphere(33, 21).expect("a mesh")));
    let pair = MeshPair { cage_m: Some(0.3), two_sided: true, ..MeshPair::new([61, 47]) };
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| found(&low, &high, &pair))
    };
    let one = with(1);
    assert!(one.holes > 0 && one.holes < one.covered);
    assert_eq!(one, with(3));
}

#[test]
fn charts_may_lie_in_other_tiles_and_be_mirrored() {
    let low = torus(16, 8).expect("a mesh");
    let high = displaced(&low, waves, [512, 256]);
    let size = [64, 32];
    let pair = MeshPair::new(size);
    let plain = found(&low, &high, &pair);
    let texel = |of: &PairedHeights, i: i64, j: i64| {
        let [i, j] = [i.rem_euclid(64), j.rem_euclid(32)];
        f64::from(of.metres[(j * 64 + i) as usize])
    };
    let most = |of: &PairedHeights, map: &dyn Fn(i64, i64) -> [i64; 2]| {
        let places = (0..32).flat_map(|j| (0..64).map(move |i| (i, j)));
        places
            .map(|(i, j)| {
                let [x, y] = map(i, j);
                (texel(of, i, j) - texel(&plain, x, y)).abs()
            })
            .fold(0.0, f64::max)
    };
    // By whole tiles, by parts of one, and turned over: what is mirrored in the texture is no other surface.
    let tiles = found(&laid(&low, |uv| uv + Vec2::new(-3.0, 2.0)), &high, &pair);
    assert!(most(&tiles, &|i, j| [i, j]) < 1e-6);
    let part = found(&laid(&low, |uv| uv + Vec2::new(0.25, -0.5)), &high, &pair);
    assert!(most(&part, &|i, j| [i - 16, j + 16]) < 1e-6);
    assert!(most(&part, &|i, j| [i - 15, j + 16]) > 1e-4, "another column is seen");
    let turned = found(&laid(&low, |uv| Vec2::new(1.0 - uv.x, uv.y)), &high, &pair);
    assert!(most(&turned, &|i, j| [63 - i, j]) < 1e-6);
    for of in [&tiles, &part, &turned] {
        assert_eq!((of.covered, of.overlaps, of.holes), (64 * 32, 0, 0));
    }
    // Twice as many tiles: two places for each texel, and of a mirrored map too.
    for wrap in [Wrap::Repeat, Wrap::Mirror] {
        let twice = MeshPair { wrap, ..pair };
        let tiled = found(&laid(&low, |uv| 2.0 * uv), &high, &twice);
        assert!(tiled.overlaps > 64 * 32 * 3 / 4, "{wrap}: {}", tiled.overlaps);
    }
    let clamped = MeshPair { wrap: Wrap::Clamp, ..pair };
    let error = heights_from_meshes(&laid(&low, |uv| 2.0 * uv), &high, &clamped, &Watch::none());
    assert!(matches!(error, Err(FromMeshesError::Outside { .. })), "{error:?}");
    let error = heights_from_meshes(&laid(&low, |uv| 1e4 * uv), &high, &pair, &Watch::none());
    assert!(matches!(error, Err(FromMeshesError::Tiled { triangle: 0, .. })), "{error:?}");
}

#[test]
fn what_cannot_be_found_is_an_error() {
    let low = torus(8, 6).expect("a mesh");
    let high = RayCaster::new(&low);
    let pair = MeshPair::new([8, 8]);
    let error = |low: &Mesh, high: &RayCaster, pair: &MeshPair| {
        heights_from_meshes(low, high, pair, &Watch::none()).expect_err("no heights")
    };
    let empty = Mesh::new(Vec::new(), Vec::new()).expect("an empty mesh");
    assert_eq!(error(&empty, &high, &pair), FromMeshesError::NothingToLieOn);
    assert_eq!(error(&low, &RayCaster::new(&empty), &pair), FromMeshesError::NothingToFind);
    for cage in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let cage_m = Some(cage);
        assert!(matches!(error(&low, &high, &MeshPair { cage_m, ..pair }), FromMeshesError::BadCage(_)));
    }
    for size in [[0, 8], [8, 0], [u32::MAX, u32::MAX], [1 << 21, 1]] {
        assert!(
            matches!(error(&low, &high, &MeshPair { size, ..pair }), FromMeshesError::Map(_)),
            "{size:?}"
        );
    }
    let speck = laid(&low, |uv| 1e-3 * uv);
    assert_eq!(error(&speck, &high, &MeshPair::new([3, 3])), FromMeshesError::NoTexel);
    let point = laid(&low, |_| Vec2::ZERO);
    assert_eq!(error(&point, &high, &pair), FromMeshesError::NoTexel);
    let cancel = std::sync::atomic::AtomicBool::new(true);
    let watch = Watch::cancelled_by(&cancel);
    let cancelled = heights_from_meshes(&low, &high, &pair, &watch);
    assert!(matches!(cancelled, Err(FromMeshesError::Cancelled(_))));
}
