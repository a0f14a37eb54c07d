use std::f64::consts::TAU;

use glam::{DVec3, Vec3};
use relief_core::mesh::{Mesh, RawCorner, RawMesh, sphere, torus};
use relief_core::rng::Rng;
use relief_core::{HeightMap, Path, PathMetric, Volume, Watch, Wrap};

use super::*;

fn raw(positions: Vec<Vec3>, triangles: &[[u32; 3]]) -> RawMesh {
    let corner = |position| RawCorner { position, normal: RawCorner::NONE, uv: RawCorner::NONE };
    let triangles = triangles.iter().map(|corners| corners.map(corner)).collect();
    RawMesh { positions, triangles, ..RawMesh::default() }
}

fn raw_of(mesh: &Mesh) -> RawMesh {
    let positions = mesh.vertices().iter().map(|vertex| vertex.position).collect();
    raw(positions, mesh.triangles())
}

/// A box with its corners at these coordinates. Opposite sides have the same diagonal.
fn block(low: [f32; 3], high: [f32; 3]) -> RawMesh {
    let corner = |at: u32| {
        let part = |axis: u32| if at >> axis & 1 == 1 { high[axis as usize] } else { low[axis as usize] };
        Vec3::new(part(0), part(1), part(2))
    };
    let sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles: Vec<_> = sides.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    raw((0..8).map(corner).collect(), &triangles)
}

fn tile(size: [u32; 3]) -> MeshVolumeSettings {
    MeshVolumeSettings { fit: Fit::Tile, reach: 0.5, ..MeshVolumeSettings::new(size) }
}

fn made(mesh: &RawMesh, settings: &MeshVolumeSettings) -> MeshVolume {
    volume_from_mesh(mesh, settings, &Watch::none()).expect("a volume")
}

/// Every voxel of a ball is what its distance to the sphere says.
#[test]
fn a_ball_has_the_distances_of_a_sphere() {
    let mesh = raw_of(&sphere(256, 128).expect("a sphere"));
    let settings = MeshVolumeSettings { reach: 2.0, ..MeshVolumeSettings::new([32, 32, 32]) };
    let ball = made(&mesh, &settings);
    assert_eq!((ball.open_edges, ball.odd_columns, ball.solid), (0, 0, Solid::Winding));
    assert!((ball.volume.atlas().scale_m() - 1.0).abs() < 1e-6, "{}", ball.volume.atlas().scale_m());
    for (at, value) in ball.volume.values().into_iter().enumerate() {
        let voxel = [at % 32, at / 32 % 32, at / 1024].map(|part| part as f64 + 0.5 - 16.0);
        let distance = DVec3::from_array(voxel).length() - 15.0;
        let expected = (0.5 - distance / 4.0).clamp(0.0, 1.0);
        assert!((f64::from(value) - expected).abs() < 2e-3, "{at}: {value} {expected}");
    }
}

/// A thread through the whole tile, closed by caps on the tile's edges, has no end when it repeats.
#[test]
fn faces_that_meet_in_the_next_tile_are_no_surface() {
    let thread = block([0.0, 0.3, 0.4], [1.0, 0.7, 0.6]);
    let repeated = made(&thread, &tile([16, 20, 10]));
    assert_eq!((repeated.doubled, repeated.open_edges, repeated.solid), (4, 0, Solid::Winding));
    let slices = |volume: &Volume, i: i64| -> Vec<f32> { (0..10).map(|k| volume.voxel(i, 10, k)).collect() };
    for i in 1..16 {
        assert_eq!(slices(&repeated.volume, i), slices(&repeated.volume, 0));
    }
    assert_eq!(repeated.volume.voxel(0, 10, 5), 1.0);
    // Where nothing repeats, the caps are the ends.
    let clamped = made(&thread, &MeshVolumeSettings { wrap: Wrap::Clamp, ..tile([16, 20, 10]) });
    assert_eq!((clamped.doubled, clamped.open_edges), (0, 0));
    assert_eq!(clamped.volume.voxel(0, 10, 5), 1.0);
}

/// A mesh moved over the tile's edges gives the volume moved by as many voxels.
#[test]
fn parts_beyond_the_edges_come_back_on_the_other_side() {
    let mut mesh = raw_of(&torus(24, 12).expect("a torus"));
    mesh.positions.iter_mut().for_each(|at| *at = (*at * 0.5 + 0.5) * 1.0);
    let still = made(&mesh, &tile([32, 16, 32])).volume;
    mesh.positions.iter_mut().for_each(|at| *at += Vec3::new(0.5, 0.0, -1.25));
    let moved = made(&mesh, &tile([32, 16, 32])).volume;
    for k in 0..32 {
        for j in 0..16 {
            for i in 0..32 {
                let apart = moved.voxel(i + 16, j - 20, k) - still.voxel(i, j, k);
                assert!(apart.abs() < 1e-5, "{i} {j} {k}: {apart}");
            }
        }
    }
}

/// Parts that overlap are one solid by winding, and have a hole by parity.
#[test]
fn overlapping_parts_are_one_solid() {
    let (mut mesh, second) = (block([0.1, 0.1, 0.1], [0.6, 0.6, 0.6]), block([0.3; 3], [0.9; 3]));
    let first = mesh.positions.len() as u32;
    mesh.positions.extend(second.positions);
    let corner = |corner: RawCorner| RawCorner { position: corner.position + first, ..corner };
    mesh.triangles.extend(second.triangles.into_iter().map(|corners| corners.map(corner)));
    let one = made(&mesh, &tile([20, 20, 20])).volume;
    assert_eq!(one.voxel(9, 9, 9), 1.0);
    let holed = MeshVolumeSettings { solid: Some(Solid::Parity), ..tile([20, 20, 20]) };
    assert_eq!(made(&mesh, &holed).volume.voxel(9, 9, 9), 0.0);
}

/// Lines exactly through edges and corners count each crossing once: a block whose diagonals and
/// sides lie on the centres of voxels.
#[test]
fn lines_through_edges_and_corners_are_no_leaks() {
    let low = [5.0 / 32.0, 0.25, 5.0 / 32.0];
    let high = [21.0 / 32.0, 0.75, 21.0 / 32.0];
    for (at, mesh) in [block(low, high), raw_of(&sphere(16, 8).expect("a sphere"))].into_iter().enumerate() {
        let fit = if at == 0 { Fit::Tile } else { Fit::Stretch };
        let block = made(&mesh, &MeshVolumeSettings { fit, ..tile([16, 16, 16]) });
        assert_eq!((block.odd_columns, block.open_edges), (0, 0));
    }
    let inside = made(&block(low, high), &tile([16, 16, 16])).volume;
    assert_eq!([inside.voxel(6, 6, 8), inside.voxel(1, 6, 8)], [1.0, 0.0]);
}

/// A mesh in its tile keeps free voxels below and above, so that its surface lies between voxels,
/// and scale and bias put it where it was.
#[test]
fn a_mesh_in_its_tile_has_free_voxels_below_and_above() {
    for (low, high) in [(0.0, 1.0), (0.0, 0.5), (0.6, 1.0), (0.02, 0.97), (0.25, 0.75)] {
        let settings = MeshVolumeSettings { reach: 1.5, ..tile([16; 3]) };
        let volume = made(&block([0.2, low, 0.2], [0.8, high, 0.8]), &settings).volume;
        let (scale, bias) = (volume.atlas().scale_m(), volume.atlas().bias_m());
        let column: Vec<_> = (0..16).map(|slice| f64::from(volume.voxel(8, 8, slice))).collect();
        assert!(column[0] < Volume::SURFACE && column[15] < Volume::SURFACE, "{low} {high}: {column:?}");
        // The surface along the column, by its values.
        let crossing = |slices: &[usize]| {
            let slice =
                slices.iter().copied().find(|slice| (column[*slice] < 0.5) != (column[*slice + 1] < 0.5));
            let slice = slice.expect("a surface");
            let part = (0.5 - column[slice]) / (column[slice + 1] - column[slice]);
            bias + scale * (slice as f64 + 0.5 + part) / 16.0
        };
        let up: Vec<usize> = (0..15).collect();
        let down: Vec<usize> = (0..15).rev().collect();
        let found = [crossing(&up), crossing(&down)];
        assert!((found[0] - f64::from(low)).abs() < 1e-3, "{low} {high}: {found:?}");
        assert!((found[1] - f64::from(high)).abs() < 1e-3, "{low} {high}: {found:?}");
        let free = [(f64::from(low) - bias) / scale, 1.0 - (f64::from(high) - bias) / scale];
        assert!(free.into_iter().all(|free| 16.0 * free >= 1.0 - 1e-6), "{low} {high}: {free:?}");
    }
    // Nothing is added without a margin, nor where the mesh passes a height itself.
    for (low, high, margin) in [(0.0, 1.0, 0.0), (-0.25, 1.0, 1.0)] {
        let settings = MeshVolumeSettings { margin, ..tile([16; 3]) };
        let volume = made(&block([0.2, low, 0.2], [0.8, high, 0.8]), &settings).volume;
        assert_eq!((volume.atlas().scale_m(), volume.atlas().bias_m()), (1.0, 0.0));
    }
}

/// A plate of half a voxel falls between the voxels' centres; one of three voxels is there.
#[test]
fn thin_parts_are_measured() {
    for (height, thin) in [(0.5 / 16.0, 0.9..=1.0), (3.0 / 16.0, 0.0..=0.1)] {
        // The centres of voxels are at halves.
        let low = 0.5 + 0.6 / 16.0;
        let plate = block([0.2, low, 0.2], [0.8, low + height, 0.8]);
        let made = made(&plate, &MeshVolumeSettings { reach: 1.5, ..tile([16; 3]) });
        assert!(thin.contains(&made.thin), "{height}: {}", made.thin);
    }
}

#[test]
fn open_and_turned_meshes_are_counted() {
    let mut open = block([0.2; 3], [0.8; 3]);
    open.triangles.pop();
    let volume = made(&open, &tile([16, 16, 16]));
    assert_eq!((volume.open_edges, volume.solid), (3, Solid::Parity));
    let mut turned = block([0.2; 3], [0.8; 3]);
    turned.triangles[3].swap(0, 1);
    let volume = made(&turned, &tile([16, 16, 16]));
    assert_eq!((volume.open_edges, volume.turned_edges, volume.odd_columns), (0, 3, 0));
    assert_eq!((volume.solid, volume.volume.voxel(8, 8, 8)), (Solid::Parity, 1.0));
    // A sheet over the whole tile is left on one side only.
    let corners = [[0.0, 0.5, 0.0], [0.0, 0.5, 1.0], [1.0, 0.5, 1.0], [1.0, 0.5, 0.0]].map(Vec3::from);
    let sheet = made(&raw(corners.to_vec(), &[[0, 1, 2], [0, 2, 3]]), &tile([8, 8, 8]));
    assert_eq!((sheet.odd_columns, sheet.volume.voxel(3, 3, 0), sheet.volume.voxel(3, 3, 7)), (64, 1.0, 0.0));
}

#[test]
fn bad_meshes_and_settings_are_refused() {
    let ball = raw_of(&sphere(16, 8).expect("a sphere"));
    let refused = |mesh: &RawMesh, settings| volume_from_mesh(mesh, &settings, &Watch::none()).err();
    let usual = MeshVolumeSettings::new([8, 8, 8]);
    for reach in [0.0, -1.0, f64::NAN, 9.0] {
        let settings = MeshVolumeSettings { reach, ..usual };
        assert!(matches!(refused(&ball, settings), Some(VolumesError::BadSetting { .. })));
    }
    let no_room = MeshVolumeSettings { margin: 4.0, ..usual };
    assert!(matches!(refused(&ball, no_room), Some(VolumesError::NoRoom { .. })));
    let size = MeshVolumeSettings::new([0, 8, 8]);
    assert!(matches!(refused(&ball, size), Some(VolumesError::Volume(_))));
    assert!(matches!(refused(&RawMesh::default(), usual), Some(VolumesError::Mesh(_))));
    let mut far = ball.clone();
    far.positions.iter_mut().for_each(|at| at.x += 20.0);
    assert!(matches!(refused(&far, tile([8, 8, 8])), Some(VolumesError::TooWide { .. })));
    far.positions.iter_mut().for_each(|at| *at = Vec3::new(at.x - 20.0, at.y + 2.0, at.z));
    assert_eq!(refused(&far, tile([8, 8, 8])), Some(VolumesError::Outside));
    far.positions.iter_mut().for_each(|at| at.y = 1.0);
    assert_eq!(refused(&far, usual), Some(VolumesError::Flat { axis: "y" }));
}

/// The surface of a volume of heights is the relief, within a voxel.
#[test]
fn volumes_of_heights_show_the_relief() {
    let mut rng = Rng::new(5);
    let noise: Vec<f32> = (0..24 * 24).map(|_| rng.unit() as f32).collect();
    let waves = HeightMap::from_fn(24, 24, Wrap::Repeat, |i, j| {
        (0.5 + 0.25 * ((i as f64 / 24.0 * TAU).sin() + (j as f64 / 12.0 * TAU).cos())) as f32
    });
    let noise = HeightMap::new(24, 24, noise, Wrap::Mirror);
    for map in [waves, noise].map(|map| map.expect("a map").with_displacement(0.3, -0.1).expect("metres")) {
        let size = [48, 48, 32];
        let volume = volume_from_heights(&map, size, &Watch::none()).expect("a volume");
        let (scale, bias) = (volume.atlas().scale_m(), volume.atlas().bias_m());
        let mut worst: f64 = 0.0;
        for at in 0..1000 {
            let (u, v) = (rng.unit(), rng.unit());
            // The highest place where the field is ½, by steps of a hundredth of a voxel.
            let steps = 100 * size[2];
            let height = (0..steps).rev().map(|step| (f64::from(step) + 0.5) / f64::from(steps));
            let top = height.into_iter().find(|h| volume.value_at([u, v, *h]) >= 0.5).expect("a floor");
            // The relief in voxels of the volume, and the least distance to it.
            let relief = |u: f64, v: f64| {
                (map.bias_m() + map.scale_m() * map.height_at(u, v) - bias) / scale * f64::from(size[2])
            };
            let mut nearest = f64::INFINITY;
            for step in 0..41 * 41 {
                let [x, y] = [step % 41, step / 41].map(|part| f64::from(part) / 20.0 - 1.0);
                let apart = relief(u + x / 48.0, v + y / 48.0) - top * 32.0;
                nearest = nearest.min((x * x + y * y + apart * apart).sqrt());
            }
            assert!(nearest <= 1.0, "{at}: {u} {v} {top}: {nearest}");
            worst = worst.max(nearest);
        }
        println!("within {worst} voxels");
    }
}

#[test]
fn sponges_tile_and_have_a_floor() {
    let sharp = Sponge { reach: 0.5, ..Sponge::default() };
    let sponge = volume_of_sponge(&sharp, [24, 24, 12], &Watch::none()).expect("a sponge");
    assert!((0..24).all(|j| (0..24).all(|i| sponge.voxel(i, j, 0) > 0.9)));
    let solid = sponge.values().iter().filter(|value| **value >= 0.5).count();
    assert!((0.2..0.8).contains(&(solid as f64 / 6912.0)), "{solid}");
    let bad = Sponge { diameter: 0.0, ..Sponge::default() };
    assert!(volume_of_sponge(&bad, [4, 4, 4], &Watch::none()).is_err());
}

/// A search through all cells finds the same distances, with every wrap.
#[test]
fn distances_are_as_a_brute_force_finds() {
    let mut rng = Rng::new(11);
    for wrap in Wrap::ALL {
        for size in [[7, 5, 6], [1, 9, 1], [12, 3, 4], [1, 1, 1]] {
            for share in [0.0, 0.01, 0.05, 1.0] {
                let values: Vec<f32> =
                    (0..size.iter().product()).map(|_| if rng.unit() < share { 0.5 } else { 0.4 }).collect();
                let volume = Volume::new(size, &values, wrap).expect("a volume");
                let distance = volume_distance(&volume, 0.5, &Watch::none()).expect("nobody cancels");
                let [width, rows, slices] = size.map(i64::from);
                let reaches = |i: i64, j: i64, k: i64| {
                    let cell = volume.cell([i, j, k]);
                    cell.low.iter().chain(&cell.high).any(|value| *value >= 0.5)
                };
                for k in 0..slices {
                    for j in 0..rows {
                        for i in 0..width {
                            let mut nearest = 255;
                            for z in 0..slices {
                                for y in j - rows..=j + rows {
                                    for x in i - width..=i + width {
                                        let apart = (x - i).abs().max((y - j).abs()).max((z - k).abs());
                                        if apart < nearest && reaches(x, y, z) {
                                            nearest = apart;
                                        }
                                    }
                                }
                            }
                            let found = distance.cell(i, j, k);
                            assert_eq!(i64::from(found), nearest, "{wrap} {size:?}: {i} {j} {k}");
                        }
                    }
                }
                // Cells outside of the tile never say more than is empty around them.
                for (i, j, k) in
                    [(-1, 2, -1), (-3, -2, 0), (width, rows + 1, slices - 1), (2 * width + 1, -1, -1)]
                {
                    let free = i64::from(distance.cell(i, j, k)).min(4);
                    for (x, y, z) in (1 - free..free).flat_map(|x| {
                        (1 - free..free).flat_map(move |y| (1 - free..free).map(move |z| (x, y, z)))
                    }) {
                        let is_there = (-1..slices).contains(&(k + z));
                        assert!(!is_there || !reaches(i + x, j + y, k + z), "{wrap} {size:?}: {i} {j} {k}");
                    }
                }
            }
        }
    }
}

/// Any number of threads gives the same bytes.
#[test]
fn threads_do_not_change_volumes() {
    let mesh = raw_of(&torus(24, 12).expect("a torus"));
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| made(&mesh, &MeshVolumeSettings::new([20, 20, 12])))
    };
    assert_eq!(with(1), with(5));
}

/// Ways by direction end where the judge's paths hit first, in every wrap.
#[test]
fn ways_end_at_the_first_hit_of_the_judge() {
    let mut rng = Rng::new(5);
    let directions = Directions { azimuths: 8, elevations: 6 };
    for wrap in Wrap::ALL {
        for size in [[9, 7, 8], [1, 9, 1], [16, 12, 5]] {
            let values: Vec<f32> =
                (0..size.iter().product()).map(|_| rng.unit() as f32 * rng.unit() as f32).collect();
            let volume = Volume::new(size, &values, wrap).expect("a volume");
            let distance = volume_distance(&volume, 0.5, &Watch::none()).expect("nobody cancels");
            let width = volume.layout().atlas_size()[0];
            let (mut hits, mut misses) = (0, 0);
            for direction in 0..directions.count() {
                let toward = directions.toward(direction);
                let ways = ways_to_solid(&volume, &distance, toward, 20.0, &Watch::none()).expect("ways");
                for [i, j, k] in [[0, 0, 0], [size[0] - 1, size[1] - 1, size[2] - 1], [0, size[1] / 2, 0]] {
                    let [x, y] = volume.layout().place(k);
                    let way = f64::from(ways[((y + j) * width + x + i) as usize]);
                    let at = [0, 1, 2].map(|axis| (f64::from([i, j, k][axis]) + 0.5) / f64::from(size[axis]));
                    let step = [0, 1, 2].map(|axis| toward[axis] / f64::from(size[axis]));
                    let level = if step[2] > 0.0 { 1.0 } else { 0.0 };
                    let path = Path {
                        uv: [at[0], at[1]],
                        duv: [step[0], step[1]],
                        h: [at[2], step[2], 0.0],
                        exit: ((level - at[2]) / step[2]).min(20.0),
                        base: 0.0,
                        metric: PathMetric::unit(1.0),
                    };
                    let judge = volume.first_hit(&path).map(|hit| hit.t);
                    let is_same = match judge {
                        Some(t) => (t - way).abs() < 1e-5,
                        None => way == f64::INFINITY,
                    };
                    assert!(is_same, "{wrap} {size:?}: {i} {j} {k} towards {toward:?}: {way}, {judge:?}");
                    if judge.is_some_and(|t| t > 0.0) {
                        hits += 1;
                    }
                    misses += i32::from(judge.is_none());
                }
            }
            assert!(
                misses > 5 && (hits > 5 || size[2] == 1),
                "{wrap} {size:?}: {hits} hits, {misses} misses"
            );
        }
    }
}
