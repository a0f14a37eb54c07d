//! Meshes with holes: nothing lies over texels without a value, everything else is there as before, and no
//! vertex is left that no triangle has.

use glam::{DVec2, DVec3};
use rayon::ThreadPoolBuilder;
use relief_core::camera::Camera;
use relief_core::mesh::{Builtin, Mesh, cube, sphere, square, torus};
use relief_core::{HeightMap, TexelMask, Watch, Wrap};
use relief_mesh::{
    CrackTest, Directions, Judge, MeshSettings, Mesher, MesherError, Part, Shading, Stream, View,
};
use relief_testing::maps;

const SCALE_M: f64 = 0.05;

/// Which texels of a map have no value.
type Mask = fn(u32, u32) -> bool;

/// A texel alone, a disc, stripes, the corners of the map, and ragged ones all over it.
const MASKS: &[(&str, Mask)] = &[
    ("one", |i, j| (i, j) == (5, 3)),
    ("disc", |i, j| (i as i32 - 20).pow(2) + (j as i32 - 17).pow(2) < 90),
    ("stripes", |i, _| i % 13 < 2),
    ("corners", |i, j| i < 3 && j < 2),
    ("ragged", |i, j| (i * 7 + j * 13 + i * j) % 11 == 0),
];

/// Hills, and a map of them whose texels are holes.
fn map(size: [u32; 2], wrap: Wrap, mask: Mask) -> HeightMap {
    let height = |i: u32, j: u32| 0.5 + 0.4 * (i as f32 * 0.21).sin() * (j as f32 * 0.17).cos();
    let map = HeightMap::from_fn(size[0], size[1], wrap, height).expect("a map");
    let map = map.with_displacement(SCALE_M, 0.0).expect("lengths");
    map.with_holes(TexelMask::from_fn(size[0], size[1], mask)).expect("of its size")
}

/// Whether a place of a map, in texels from the centre of the first one, lies in a cell with a hole at one of
/// its corners.
fn is_hole(map: &HeightMap, mask: Mask, at: DVec2) -> bool {
    let texel = |i: f64, j: f64| {
        let index = |of: f64, size: u32| map.wrap().index(of as i64, size);
        mask(index(i, map.width()), index(j, map.height()))
    };
    let (i, j) = (at.x.floor(), at.y.floor());
    texel(i, j) || texel(i + 1.0, j) || texel(i, j + 1.0) || texel(i + 1.0, j + 1.0)
}

fn place(map: &HeightMap, uv: DVec2) -> DVec2 {
    uv * DVec2::new(map.width().into(), map.height().into()) - 0.5
}

fn made(base: &Mesh, map: &HeightMap, settings: &MeshSettings) -> Mesh {
    let mesher = Mesher::new(base, map, &MeshSettings { holes: true, ..*settings }).expect("a mesh");
    let mesh = mesher.mesh().expect("finite");
    assert_eq!(mesher.triangles(), mesh.triangles().len() as u64);
    assert_eq!(mesher.vertices(), mesh.vertices().len() as u64);
    mesh
}

/// Texture coordinates of the corners of each triangle.
fn charts(mesh: &Mesh) -> Vec<[DVec2; 3]> {
    let all = 0..mesh.triangles().len() as u32;
    all.map(|triangle| mesh.corners(triangle).map(|corner| corner.uv.as_dvec2())).collect()
}

fn assert_no_hole_is_covered(mesh: &Mesh, map: &HeightMap, mask: Mask, about: &str) {
    for [a, b, c] in charts(mesh) {
        let middle = place(map, (a + b + c) / 3.0);
        // Texture coordinates are rounded.
        let is_near = (middle - middle.round()).abs().min_element() < 1e-4;
        assert!(is_near || !is_hole(map, mask, middle), "{about}: {middle}");
    }
    let mut is_used = vec![false; mesh.vertices().len()];
    mesh.triangles().as_flattened().iter().for_each(|&corner| is_used[corner as usize] = true);
    assert!(is_used.iter().all(|is_used| *is_used), "{about}: a vertex without a triangle");
}

#[test]
fn a_plane_with_a_vertex_every_texel_has_two_triangles_for_each_cell_that_is_no_hole() {
    for (name, mask) in MASKS {
        for wrap in Wrap::ALL {
            let map = map([41, 29], wrap, *mask);
            let mesh = made(&square(1).expect("a mesh"), &map, &MeshSettings::default());
            let about = format!("{name}, {wrap}");
            assert_no_hole_is_covered(&mesh, &map, *mask, &about);
            // Half cells and quarters of them at the border, too.
            let cells = (0..=29).flat_map(|j| (0..=41).map(move |i| DVec2::new(i.into(), j.into()) - 0.75));
            let kept = cells.filter(|cell| !is_hole(&map, *mask, *cell)).count();
            assert_eq!(mesh.triangles().len(), 2 * kept, "{about}");
            // What is left is as it was.
            let whole = Mesher::new(&square(1).expect("a mesh"), &map, &MeshSettings::default());
            let whole = whole.expect("a mesh").mesh().expect("finite");
            let corners = |mesh: &Mesh| -> Vec<[[u32; 3]; 3]> {
                let all = 0..mesh.triangles().len() as u32;
                all.map(|of| mesh.corners(of).map(|corner| corner.position.to_array().map(f32::to_bits)))
                    .collect()
            };
            let (mut left, whole) = (corners(&mesh).into_iter().peekable(), corners(&whole));
            assert!(whole.iter().filter(|corners| left.next_if_eq(*corners).is_some()).count() == 2 * kept);
        }
    }
}

#[test]
fn outlines_are_within_a_texel_where_triangles_are_made_to_an_error() {
    let plane = square(1).expect("a mesh");
    let ring = torus(5, 3).expect("a mesh");
    for (name, mask) in MASKS {
        for (base, on) in [(&plane, "plane"), (&ring, "torus")] {
            for judge in [Judge::Surface, Judge::Texels] {
                // More than a tile of a plane.
                let size = if *name == "disc" { [170, 29] } else { [41, 29] };
                let map = map(size, Wrap::Repeat, *mask);
                let settings = MeshSettings { judge, ..MeshSettings::within(0.02 * SCALE_M) };
                let mesh = made(base, &map, &settings);
                let about = format!("{name}, {on}, {judge}");
                assert_no_hole_is_covered(&mesh, &map, *mask, &about);
                let charts = charts(&mesh);
                for j in 0..size[1] - 1 {
                    for i in 0..size[0] - 1 {
                        let cell = DVec2::new(i.into(), j.into()) + 0.5;
                        let around =
                            (-1..=1).flat_map(|x| (-1..=1).map(move |y| DVec2::new(x.into(), y.into())));
                        let mut around = around.map(|by| is_hole(&map, *mask, cell + by));
                        let is_own = is_hole(&map, *mask, cell);
                        if around.any(|is_other| is_other != is_own) {
                            continue;
                        }
                        // Beside the middle, where two triangles may meet.
                        let uv = (cell + 0.5 + DVec2::new(0.013, 0.007))
                            / DVec2::new(size[0].into(), size[1].into());
                        let covers = |[a, b, c]: &&[DVec2; 3]| {
                            let turns =
                                [(a, b), (b, c), (c, a)].map(|(from, to)| (*to - *from).perp_dot(uv - *from));
                            turns.iter().all(|turn| *turn >= 0.0) || turns.iter().all(|turn| *turn <= 0.0)
                        };
                        let is_covered = charts.iter().any(|chart| covers(&chart));
                        assert_eq!(is_covered, !is_own, "{about}: cell {i}, {j}");
                    }
                }
                // On flat ground there would be far fewer triangles than cells, and around holes there are
                // few.
                let whole = Mesher::new(base, &map, &settings).expect("a mesh").triangles();
                println!("{about}: {} triangles, {whole} without holes", mesh.triangles().len());
            }
        }
    }
}

#[test]
fn the_relief_beside_holes_is_within_the_bound() {
    let mask: Mask = |i, j| (i as i32 - 20).pow(2) + (j as i32 - 17).pow(2) < 90;
    let named = maps::ALL.iter().find(|map| map.name == "natural 101x67").expect("it is listed");
    let map = named.build(Wrap::Clamp).with_displacement(SCALE_M, 0.0).expect("lengths");
    let map = map.with_holes(TexelMask::from_fn(101, 67, mask)).expect("of its size");
    let settings = MeshSettings { holes: true, ..MeshSettings::within(0.02 * SCALE_M) };
    let mesher = Mesher::new(&square(1).expect("a mesh"), &map, &settings).expect("a mesh");
    let error_m = mesher.certificate().expect("made to an error").error_m;
    let mesh = mesher.mesh().expect("finite");
    let mut farthest = 0.0_f64;
    for triangle in 0..mesh.triangles().len() as u32 {
        let corners = mesh.corners(triangle);
        for i in 0..=12 {
            for j in 0..=12 - i {
                let of = [i, j, 12 - i - j].map(|part| f64::from(part) / 12.0);
                let uv: DVec2 = (0..3).map(|k| corners[k].uv.as_dvec2() * of[k]).sum();
                let y: f64 = (0..3).map(|k| f64::from(corners[k].position.y) * of[k]).sum();
                farthest = farthest.max((map.displacement_m(map.height_at(uv.x, uv.y)) - y).abs());
            }
        }
    }
    assert!(error_m <= 0.02 * SCALE_M && farthest <= error_m + 1e-6 * SCALE_M, "{farthest} {error_m}");
    assert!(farthest > 0.5 * error_m, "{farthest} {error_m}");
}

#[test]
fn every_way_to_divide_leaves_out_what_lies_over_holes() {
    let mask = MASKS[1].1;
    let map = map([61, 47], Wrap::Repeat, mask);
    let camera = Camera::new(DVec3::new(0.9, 0.8, 1.1), DVec3::ZERO, 40.0).expect("a camera");
    let view = View::new(camera, [320, 240]);
    let every = MeshSettings::default();
    let mut made_of = 0;
    for base in [square(1), torus(9, 7), sphere(8, 5), cube(2)] {
        let base = base.expect("a mesh");
        for settings in [
            MeshSettings { texels: 3, ..every },
            MeshSettings { shading: Shading::Mesh, directions: Directions::Angle, ..every },
            MeshSettings::seen_by(view),
            MeshSettings::within(0.05 * SCALE_M),
        ] {
            let mesh = made(&base, &map, &settings);
            let about = format!("{}, {}", settings.edges.name, settings.interior.name);
            assert_no_hole_is_covered(&mesh, &map, mask, &about);
            let whole = Mesher::new(&base, &map, &settings).expect("a mesh");
            assert!(mesh.triangles().len() as u64 > whole.triangles() / 4);
            // The search for cracks that goes with making says what the whole mesh does.
            let how = Stream { size: 1.0, check: true, grid: None, cache_order: true, watch: Watch::none() };
            let mesher = Mesher::new(&base, &map, &MeshSettings { holes: true, ..settings }).expect("a mesh");
            let mut next = 0;
            let streamed = mesher.stream(&how, |block| -> Result<(), ()> {
                next += block.vertices.len() as u64;
                Ok(())
            });
            let cracks = streamed.expect("finite").cracks.expect("looked for");
            let again = CrackTest::of_mesh(&mesh);
            assert_eq!(
                (cracks.open, cracks.pieces, next),
                (again.open, again.pieces, mesher.vertices()),
                "{about}"
            );
            assert!(cracks.open > 0);
            made_of += 1;
        }
    }
    assert_eq!(made_of, 16);
}

#[test]
fn parts_fit_together_and_threads_change_no_bit() {
    let map = map([61, 47], Wrap::Clamp, MASKS[4].1);
    let base = Builtin::Plane.build([1.0, 0.8]).expect("a mesh");
    let texels = MeshSettings { holes: true, ..MeshSettings::default() };
    let whole = made(&base, &map, &texels).triangles().len();
    let parts =
        [[0, 0], [1, 0], [0, 1], [1, 1]].map(|at| MeshSettings { part: Part { of: [2, 2], at }, ..texels });
    assert_eq!(parts.map(|part| made(&base, &map, &part).triangles().len()).iter().sum::<usize>(), whole);
    for settings in [texels, MeshSettings { holes: true, ..MeshSettings::within(0.02 * SCALE_M) }] {
        let [alone, together] = [1, 4].map(|threads: usize| {
            let pool = ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
            pool.install(|| made(&base, &map, &settings))
        });
        assert!(alone == together);
    }
}

#[test]
fn maps_without_holes_are_as_they_were_and_those_of_nothing_else_are_refused() {
    let base = square(1).expect("a mesh");
    let level = HeightMap::from_fn(16, 9, Wrap::Repeat, |_, _| 0.5).expect("a map");
    let plain = Mesher::new(&base, &level, &MeshSettings::default()).expect("a mesh").mesh();
    assert!(made(&base, &level, &MeshSettings::default()) == plain.expect("finite"));
    let nothing = level.clone().with_holes(TexelMask::from_fn(16, 9, |_, _| true)).expect("of its size");
    let holes = MeshSettings { holes: true, ..MeshSettings::default() };
    assert_eq!(Mesher::new(&base, &nothing, &holes).err(), Some(MesherError::AllHoles));
    let some = level.with_holes(TexelMask::from_fn(16, 9, |i, _| i == 3)).expect("of its size");
    let solid = MeshSettings { solid_m: Some(0.01), ..holes };
    let grid = square(2).expect("a mesh");
    assert_eq!(Mesher::new(&grid, &some, &solid).err(), Some(MesherError::SolidOfHoles));
    // Holes that nobody asks for are filled.
    assert!(Mesher::new(&base, &some, &MeshSettings { holes: false, ..solid }).is_ok());
}
