//! What is said of displaced meshes besides their cracks, and the ways in which they are stored.

use std::collections::BTreeMap;

use glam::{DVec3, Vec3};
use relief_core::mesh::{Mesh, MeshBlock, PositionGrid, cube, cylinder, rectangle, sphere, square, torus};
use relief_core::{HeightMap, Watch, Wrap};
use relief_io::{GlbLayout, GlbLevel, GlbNode, MeshCounts, Quantization, read_raw_mesh, write_glb};
use relief_mesh::{
    CrackTest, Directions, Folds, MeshSettings, Mesher, Part, Seams, Shading, Stream, Streamed, cache_misses,
};
use relief_tests::glb;
use serde_json::{Value, json};

/// Moves everything by a distance in metres.
fn moved(by_m: f64) -> HeightMap {
    let map = HeightMap::from_fn(64, 32, Wrap::Repeat, |_, _| 1.0).expect("a map");
    map.with_displacement(0.0, by_m).expect("lengths")
}

fn hills(scale_m: f64) -> HeightMap {
    let height = |i: u32, j: u32| 0.5 + 0.25 * ((0.4 * i as f32).sin() + (0.3 * j as f32).cos());
    let map = HeightMap::from_fn(64, 32, Wrap::Repeat, height).expect("a map");
    map.with_displacement(scale_m, 0.0).expect("lengths")
}

fn streamed(mesher: &Mesher, size: f64) -> Streamed {
    let how = Stream { size, check: true, grid: None, cache_order: false, watch: Watch::none() };
    mesher.stream(&how, |_| Ok::<(), ()>(())).expect("finite")
}

fn folds(base: &Mesh, map: &HeightMap, settings: &MeshSettings) -> Folds {
    streamed(&Mesher::new(base, map, settings).expect("a mesh"), 1.0).folds
}

#[test]
fn a_cylinder_turned_inside_out_is_folded_where_it_has_a_side() {
    let base = cylinder(24, 2).expect("a mesh");
    let upright = (0..base.triangles().len()).filter(|&at| {
        let corners = base.triangles()[at].map(|corner| base.vertices()[corner as usize]);
        corners.iter().all(|corner| corner.normal.y.abs() < 0.1)
    });
    let upright = upright.count() as u64;
    for directions in Directions::ALL {
        // Each side by itself, so that no corner is drawn down by the ends.
        let settings = MeshSettings {
            texels: 4,
            seams: Seams::Keep,
            directions: *directions,
            ..MeshSettings::default()
        };
        // Within its radius of half a metre nothing folds, beyond the axis all of its sides do.
        for by_m in [-0.4, 0.0, 0.3] {
            assert_eq!(folds(&base, &moved(by_m), &settings), Folds::default(), "{by_m}");
        }
        let turned = folds(&base, &moved(-0.8), &settings);
        assert_eq!(turned.base_triangles, upright, "{turned:?}");
        assert!(turned.triangles > turned.base_triangles && turned.first.len() == Folds::FIRST);
    }
}

#[test]
fn folds_are_those_that_brute_force_finds() {
    let base = torus(16, 12).expect("a mesh");
    let map = hills(0.5);
    for settings in [MeshSettings { texels: 2, ..MeshSettings::default() }, MeshSettings::within(0.02)] {
        let mesher = Mesher::new(&base, &map, &settings).expect("a mesh");
        let found = streamed(&mesher, 1.0).folds;
        // The directions of a torus point away from the circle in its middle. The base's directions,
        // interpolated over flat triangles, are near enough to find what is far from either.
        let mesh = mesher.mesh().expect("finite");
        let [mut certain, mut possible] = [0, 0];
        for corners in mesh.triangles() {
            let corners = corners.map(|corner| mesh.vertices()[corner as usize]);
            let [a, b, c] = corners.map(|corner| corner.position.as_dvec3());
            let along: DVec3 = corners.iter().map(|corner| direction(&base, corner.uv.into())).sum();
            let cosine = (b - a).cross(c - a).normalize_or_zero().dot(along.normalize());
            certain += u64::from(cosine < -0.2);
            possible += u64::from(cosine < 0.2);
        }
        println!("{}: {certain} to {possible}, {}", settings.interior.name, found.triangles);
        assert!(certain > 50 && (certain..=possible).contains(&found.triangles), "{found:?}");
        let of_base = found.first.iter().map(|base| base.pieces).sum::<u64>();
        assert!(found.first.len() == Folds::FIRST && of_base <= found.triangles);
        assert!(found.first.windows(2).all(|pair| pair[0].triangle < pair[1].triangle));
        for folded in &found.first {
            let corners = base.triangles()[folded.triangle as usize];
            let sum: Vec3 = corners.map(|corner| base.vertices()[corner as usize].position).iter().sum();
            assert!(folded.middle_m.distance(sum.as_dvec3() / 3.0) < 1e-6);
        }
        // Places belong to the mesh that is written.
        let larger = streamed(&mesher, 3.0).folds;
        assert_eq!(larger.first[0].middle_m, found.first[0].middle_m * 3.0);
        assert_eq!((larger.triangles, larger.base_triangles), (found.triangles, found.base_triangles));
    }
}

/// The normal of a base at texture coordinates.
fn direction(base: &Mesh, uv: [f32; 2]) -> DVec3 {
    let mut best = (f32::INFINITY, DVec3::ZERO);
    for vertex in base.vertices() {
        let distance = (vertex.uv.x - uv[0]).abs() + (vertex.uv.y - uv[1]).abs();
        if distance < best.0 {
            best = (distance, vertex.normal.as_dvec3());
        }
    }
    best.1
}

#[test]
fn what_moves_along_one_direction_does_not_fold() {
    let settings = MeshSettings { texels: 1, ..MeshSettings::default() };
    for base in [square(1), square(3), rectangle([1.0, 0.2], 2)] {
        assert_eq!(folds(&base.expect("a mesh"), &hills(30.0), &settings), Folds::default());
    }
    assert_eq!(folds(&square(1).expect("a mesh"), &hills(3.0), &MeshSettings::within(0.1)), Folds::default());
    // A ball that is only made larger does not, either.
    assert_eq!(folds(&sphere(32, 16).expect("a mesh"), &hills(0.05), &settings), Folds::default());
}

#[test]
fn folds_do_not_depend_on_threads_or_blocks() {
    let base = torus(6, 4).expect("a mesh").tiled([40.0, 20.0].into()).expect("tiled");
    // A few large triangles are cut apart into several blocks.
    let mesher = Mesher::new(&base, &hills(0.6), &MeshSettings::default()).expect("a mesh");
    let found = streamed(&mesher, 1.0).folds;
    assert!(mesher.triangles() > 200_000 && found.base_triangles <= 48, "{found:?}");
    let by_base: BTreeMap<u32, u64> = found.first.iter().map(|base| (base.triangle, base.pieces)).collect();
    assert_eq!(by_base.len(), found.first.len());
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a pool");
    assert_eq!(pool.install(|| streamed(&mesher, 1.0)).folds, found);
}

/// Mesh on a lattice of the given bits: its blocks and its report.
fn rounded(mesher: &Mesher, grid: Option<PositionGrid>) -> (Vec<MeshBlock>, Streamed) {
    let how = Stream { size: 1.0, check: true, grid, cache_order: false, watch: Watch::none() };
    let mut blocks = Vec::new();
    let streamed = mesher.stream(&how, |block| {
        blocks.push(block.clone());
        Ok::<(), ()>(())
    });
    (blocks, streamed.expect("finite"))
}

fn counts(mesher: &Mesher) -> MeshCounts {
    MeshCounts { vertices: mesher.vertices(), triangles: mesher.triangles() }
}

fn level(mesher: &Mesher, coverage: f64) -> GlbLevel {
    GlbLevel { counts: counts(mesher), coverage }
}

#[test]
fn integers_are_read_as_the_lattice_and_open_no_crack() {
    let folder = tempfile::tempdir().expect("a folder");
    let ring = torus(24, 12).and_then(|ring| ring.tiled([4.0, 3.0].into()));
    for (at, base) in [ring, sphere(24, 12), cube(3)].into_iter().enumerate() {
        let base = base.expect("a mesh");
        let settings = MeshSettings { texels: 1, ..MeshSettings::default() };
        let mesher = Mesher::new(&base, &hills(0.06), &settings).expect("a mesh");
        let (exact, plain) = rounded(&mesher, None);
        assert_eq!(plain.rounded, None);
        for bits in [8, 9, 12, 13, 16] {
            let bounds = mesher.bounds(1.0, &Watch::none()).expect("finite");
            assert_eq!(bounds.positions_m, plain.bounds_m);
            let grid = PositionGrid::around(&[bounds.positions_m], bits).expect("finite")[0];
            let (blocks, streamed) = rounded(&mesher, Some(grid));
            let found = streamed.rounded.expect("it was rounded");
            let cracks = streamed.cracks.expect("it was looked at");
            assert_eq!(cracks.open, 0, "{at} {bits} {cracks:?}");
            // What is said of vertices and triangles is what a comparison finds.
            let (mut farthest, mut lost) = (0.0_f64, 0);
            let has_area = |[a, b, c]: [Vec3; 3]| (b - a).as_dvec3().cross((c - a).as_dvec3()).length() > 0.0;
            for (before, after) in exact.iter().zip(&blocks) {
                for (a, b) in before.vertices.iter().zip(&after.vertices) {
                    farthest = farthest.max(a.position.as_dvec3().distance(b.position.as_dvec3()));
                }
                for (a, b) in before.positions().zip(after.positions()) {
                    lost += u64::from(has_area(a) && !has_area(b));
                }
            }
            assert_eq!((found.greatest_m, found.without_area), (farthest, lost), "{at} {bits}");
            assert!(farthest > 0.2 * grid.step_m() && farthest < 0.867 * grid.step_m());
            assert!(bits > 8 || at > 0 || lost > 0);
            // The file holds these floats, from rounded positions and from others.
            let uvs = bounds.uvs[0].min_element() >= 0.0 && bounds.uvs[1].max_element() <= 1.0;
            let quantization = Some(Quantization { grid, uvs });
            let layout = GlbLayout {
                levels: vec![level(&mesher, 0.0)],
                quantization,
                strips: false,
                node: GlbNode::default(),
                materials: None,
            };
            let paths = [(&blocks, "a.glb"), (&exact, "b.glb")].map(|(blocks, name)| {
                let path = folder.path().join(name);
                write_glb(&path, &layout, |sink| blocks.iter().try_for_each(&mut *sink)).expect("written");
                path
            });
            let [a, b] = paths.each_ref().map(|path| std::fs::read(path).expect("written"));
            assert!(a == b && a.len() as u64 == layout.bytes());
            let read = read_raw_mesh(paths[0].as_path(), 1 << 30).expect("read");
            let vertices = || blocks.iter().flat_map(|block| &block.vertices);
            assert_eq!(read.positions, vertices().map(|vertex| vertex.position).collect::<Vec<_>>());
            let off = if bits < 13 { 0.008 } else { 0.00005 };
            for (vertex, (normal, uv)) in vertices().zip(read.normals.iter().zip(&read.uvs)) {
                assert!(normal.distance(vertex.normal) < off, "{bits}");
                assert!((*uv - vertex.uv).abs().max_element() <= if uvs { 0.50001 / 65535.0 } else { 0.0 });
            }
            let corners = read.triangles.iter().map(|corners| corners.map(|corner| corner.position));
            assert!(corners.eq(blocks.iter().flat_map(|block| block.triangles.iter().copied())));
        }
    }
}

#[test]
fn parts_on_one_lattice_meet() {
    let base = rectangle([1.0, 0.5], 1).expect("a mesh");
    let map = hills(0.1);
    let part = |at: u32| {
        let settings = MeshSettings { part: Part { of: [2, 1], at: [at, 0] }, ..MeshSettings::within(0.001) };
        Mesher::new(&base, &map, &settings).expect("a mesh")
    };
    let parts = [part(0), part(1)];
    let boxes = parts.each_ref().map(|part| part.bounds(1.0, &Watch::none()).expect("finite").positions_m);
    let grids = PositionGrid::around(&boxes, 10).expect("finite");
    let triangles = |part: usize| {
        let (blocks, streamed) = rounded(&parts[part], Some(grids[part]));
        let points: Vec<[Vec3; 3]> = blocks.iter().flat_map(|block| block.positions()).collect();
        (points, streamed.cracks.expect("looked at").open)
    };
    let ((left, open_left), (right, open_right)) = (triangles(0), triangles(1));
    let both = CrackTest::of_triangles(left.into_iter().chain(right));
    let shared = open_left + open_right - both.open;
    assert!(both.pieces == 1 && shared > 10 && shared.is_multiple_of(2), "{both:?} {shared}");
    assert_eq!(grids[0].step_m(), grids[1].step_m());
}

#[test]
fn a_file_of_integers_that_would_be_wrong_is_not_written() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.glb");
    let base = torus(8, 6).expect("a mesh").tiled([2.0, 1.0].into()).expect("tiled");
    let mesher = Mesher::new(&base, &hills(0.02), &MeshSettings::default()).expect("a mesh");
    let (blocks, Streamed { bounds_m, .. }) = rounded(&mesher, None);
    let small = [bounds_m[0], bounds_m[0] + (bounds_m[1] - bounds_m[0]) * 0.5];
    for (around, uvs) in [(small, false), (bounds_m, true)] {
        let grid = PositionGrid::around(&[around], 12).expect("finite")[0];
        let quantization = Some(Quantization { grid, uvs });
        let layout = GlbLayout {
            levels: vec![level(&mesher, 0.0)],
            quantization,
            strips: false,
            node: GlbNode::default(),
            materials: None,
        };
        let written = write_glb(&path, &layout, |sink| blocks.iter().try_for_each(&mut *sink));
        let problem = written.expect_err("it lies beyond").problem.to_string();
        assert!(problem.contains("outside"), "{problem}");
    }
    assert_eq!(std::fs::read_dir(folder.path()).expect("a folder").count(), 0);
}

#[test]
fn levels_of_detail_are_meshes_of_one_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.glb");
    let base = torus(24, 12).expect("a mesh");
    let finest = MeshSettings { texels: 1, ..MeshSettings::default() };
    let map = hills(0.05);
    let meshers = [0, 1, 2].map(|level| Mesher::new(&base, &map, &finest.coarser(level)).expect("a mesh"));
    let all = meshers.each_ref().map(counts);
    let levels = GlbLevel::of(&all);
    assert!(levels.windows(2).all(|pair| pair[1].coverage <= pair[0].coverage / 2.0), "{levels:?}");
    assert_eq!(levels[2].coverage, 0.0);
    let bounds = meshers.each_ref().map(|mesher| mesher.bounds(1.0, &Watch::none()).expect("finite"));
    let around = bounds[0].with(&bounds[1]).with(&bounds[2]).positions_m;
    let grid = PositionGrid::around(&[around], 14).expect("finite")[0];
    for quantization in [None, Some(Quantization { grid, uvs: true })] {
        let layout = GlbLayout {
            levels: levels.clone(),
            quantization,
            strips: false,
            node: GlbNode::default(),
            materials: None,
        };
        let grid = quantization.map(|how| how.grid);
        let blocks = meshers.each_ref().map(|mesher| rounded(mesher, grid).0);
        write_glb(&path, &layout, |sink| blocks.iter().flatten().try_for_each(&mut *sink)).expect("written");
        let bytes = std::fs::read(&path).expect("written");
        assert_eq!(bytes.len() as u64, layout.bytes());
        let (json, buffer) = glb::parts(&bytes);
        assert_eq!(json["scenes"][0]["nodes"], json!([0]));
        assert_eq!(json["nodes"][0]["extensions"]["MSFT_lod"]["ids"], json!([1, 2]));
        let coverages = json["nodes"][0]["extras"]["MSFT_screencoverage"].as_array().expect("a list");
        let promised = levels.iter().map(|level| Some(level.coverage));
        assert!(coverages.iter().map(Value::as_f64).eq(promised), "{coverages:?}");
        assert_eq!(json["buffers"][0]["byteLength"], buffer.len());
        for (at, blocks) in blocks.iter().enumerate() {
            // Each level's own lists hold its own mesh.
            assert_eq!(json["nodes"][at]["mesh"], at);
            let primitive = &json["meshes"][at]["primitives"][0];
            let list = |accessor: &Value| {
                let accessor = &json["accessors"][accessor.as_u64().expect("a number") as usize];
                let view = &json["bufferViews"][accessor["bufferView"].as_u64().expect("a number") as usize];
                let number = |of: &Value, name: &str| of[name].as_u64().unwrap_or_default() as usize;
                let from = number(view, "byteOffset");
                let stride = number(view, "byteStride").max(4);
                let bytes = &buffer[from..from + number(view, "byteLength")];
                (bytes.chunks_exact(stride), number(accessor, "count"))
            };
            let (vertices, count) = list(&primitive["attributes"]["POSITION"]);
            assert_eq!((vertices.len(), count as u64), (count, all[at].vertices));
            let wanted = blocks.iter().flat_map(|block| &block.vertices).map(|vertex| vertex.position);
            for (bytes, wanted) in vertices.zip(wanted) {
                match &quantization {
                    None => {
                        let floats = wanted.to_array().map(f32::to_le_bytes);
                        assert_eq!(&bytes[..12], floats.as_flattened());
                    }
                    Some(how) => {
                        let codes = how.grid.code(wanted).expect("within").map(u16::to_le_bytes);
                        assert_eq!(&bytes[..6], codes.as_flattened());
                    }
                }
            }
            let (indices, count) = list(&primitive["indices"]);
            assert_eq!((indices.len(), count as u64), (count, 3 * all[at].triangles));
            let wanted = blocks.iter().flat_map(|block| block.triangles.as_flattened());
            assert!(indices.eq(wanted.map(|corner| corner.to_le_bytes())), "level {at}");
        }
        // Who knows nothing of levels shows the finest.
        let read = read_raw_mesh(path.as_path(), 1 << 30).expect("read");
        assert_eq!(read.triangles.len() as u64, all[0].triangles);
        // A level that ends too early, or goes on, is none.
        for wrong in [&blocks[0][..], &blocks[1][..]] {
            let mixed = wrong.iter().chain(&blocks[0]).chain(&blocks[2]);
            let written = write_glb(&path, &layout, |sink| mixed.clone().try_for_each(&mut *sink));
            assert!(written.is_err());
        }
        assert_eq!(std::fs::read(&path).expect("as it was"), bytes);
    }
    let same = GlbLayout {
        levels: vec![level(&meshers[0], 0.1), level(&meshers[1], 0.1)],
        quantization: None,
        strips: false,
        node: GlbNode::default(),
        materials: None,
    };
    assert!(same.check().is_err());
    assert!(
        GlbLayout {
            levels: Vec::new(),
            quantization: None,
            strips: false,
            node: GlbNode::default(),
            materials: None
        }
        .check()
        .is_err()
    );
}

#[test]
fn triangles_in_cache_order_are_the_same_ones_and_find_more_corners() {
    let ring = torus(12, 8).and_then(|ring| ring.tiled([4.0, 3.0].into())).expect("a mesh");
    let coarse = torus(3, 3).and_then(|ring| ring.tiled([4.0, 4.0].into())).expect("a mesh");
    let plane = rectangle([1.0, 0.5], 1).and_then(|plane| plane.tiled([4.0, 4.0].into())).expect("a mesh");
    let every = MeshSettings { texels: 1, ..MeshSettings::default() };
    let normals = MeshSettings { shading: Shading::Mesh, ..every };
    for (name, base, settings, most) in [
        ("torus", &ring, every, 0.72),
        ("torus, normals of triangles", &ring, normals, 0.72),
        ("torus of large triangles", &coarse, every, 0.72),
        ("plane", &plane, every, 0.75),
        ("plane to an error", &plane, MeshSettings::within(1e-4), 0.85),
    ] {
        let mesher = Mesher::new(base, &hills(0.05), &settings).expect("a mesh");
        let blocks = |cache_order: bool| {
            let how = Stream { size: 1.0, check: true, grid: None, cache_order, watch: Watch::none() };
            let mut blocks = Vec::new();
            let streamed = mesher.stream(&how, |block| {
                blocks.push(block.clone());
                Ok::<(), ()>(())
            });
            (blocks, streamed.expect("finite"))
        };
        let ((plain, of_plain), (ordered, of_ordered)) = (blocks(false), blocks(true));
        assert_eq!(of_plain, of_ordered, "{name}");
        assert_eq!(blocks(true).0, ordered, "{name}");
        for (a, b) in plain.iter().zip(&ordered) {
            assert_eq!(a.vertices, b.vertices, "{name}");
            let sorted = |block: &MeshBlock| {
                let bits = |points: [Vec3; 3]| points.map(|point| point.to_array().map(f32::to_bits));
                let points = block.positions().map(bits);
                let mut all: Vec<_> = block.triangles.iter().copied().zip(points).collect();
                all.sort_unstable();
                all
            };
            assert!(sorted(a) == sorted(b), "{name}");
        }
        let misses = |blocks: &[MeshBlock], cache: usize| {
            cache_misses(blocks.iter().flat_map(|block| block.triangles.iter().copied()), cache)
        };
        let found = [16, 32].map(|cache| [misses(&plain, cache), misses(&ordered, cache)]);
        println!("{name}: {} triangles, caches of 16 and 32: {found:.3?}", mesher.triangles());
        assert!(mesher.triangles() > 10_000 && found[0][1] < most && found[0][1] <= found[0][0], "{name}");
        // Rows are as long as triangles are large.
        assert!(name.starts_with("torus,") || name == "torus" || found[0][1] < 0.8 * found[0][0], "{name}");
    }
}
