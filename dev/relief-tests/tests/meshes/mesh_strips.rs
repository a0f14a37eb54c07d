//! Triangle strips of GLBs: they decode to the very triangles, each as it turns, and the comparison that says
//! so notices one that is turned over.

use glam::DVec3;
use relief_core::camera::Camera;
use relief_core::mesh::{Mesh, MeshBlock, PositionGrid, cube, rectangle, torus};
use relief_core::{HeightMap, Watch, Wrap};
use relief_io::{GlbLayout, GlbLevel, GlbNode, MeshCounts, Quantization, read_raw_mesh, write_glb};
use relief_mesh::{MeshSettings, Mesher, Stream, View};
use relief_testing::maps;
use relief_tests::glb;

/// Triangles with their least corner first, in order.
fn sorted(triangles: impl IntoIterator<Item = [u32; 3]>) -> Vec<[u32; 3]> {
    let turned = |[a, b, c]: [u32; 3]| [[a, b, c], [b, c, a], [c, a, b]].into_iter().min();
    let mut all: Vec<[u32; 3]> = triangles.into_iter().filter_map(turned).collect();
    all.sort_unstable();
    all
}

/// The triangles of a strip as glTF has them, without those that name a vertex twice.
fn decoded(indices: &[u32]) -> Vec<[u32; 3]> {
    let triangles = indices.windows(3).enumerate();
    let triangles = triangles.map(|(at, window)| [window[0], window[1 + at % 2], window[2 - at % 2]]);
    sorted(triangles.filter(|[a, b, c]| a != b && b != c && c != a))
}

fn blocks(mesher: &Mesher, grid: Option<PositionGrid>) -> Vec<MeshBlock> {
    let how = Stream { size: 1.0, check: false, grid, cache_order: false, watch: Watch::none() };
    let mut blocks = Vec::new();
    mesher
        .stream(&how, |block| {
            blocks.push(block.clone());
            Ok::<(), ()>(())
        })
        .expect("finite");
    blocks
}

fn counts(mesher: &Mesher) -> MeshCounts {
    MeshCounts { vertices: mesher.vertices(), triangles: mesher.triangles() }
}

fn map() -> HeightMap {
    let natural = maps::ALL.iter().find(|map| map.name == "natural 101x67").expect("it is listed");
    natural.build(Wrap::Repeat).with_displacement(0.05, 0.0).expect("lengths")
}

/// Meshes of all interiors, and the most indices that a triangle of each may take.
fn meshes() -> Vec<(&'static str, Mesher, f64)> {
    let [ring, plane] = [torus(24, 12), rectangle([1.0, 0.7], 1)].map(|mesh| mesh.expect("a mesh"));
    let camera = Camera::new(DVec3::new(1.0, 1.2, 1.6), DVec3::ZERO, 45.0).expect("a camera");
    let view = MeshSettings::seen_by(View::new(camera, [200, 150]));
    let (dice, error) = (MeshSettings::default(), MeshSettings::within(0.0005));
    let solid = MeshSettings { solid_m: Some(0.05), ..error };
    let made = |base: &Mesh, settings: MeshSettings| Mesher::new(base, &map(), &settings).expect("a mesh");
    vec![
        ("dice", made(&ring, MeshSettings { texels: 2, ..dice }), 1.9),
        ("dice of large triangles", made(&torus(5, 4).expect("a mesh"), dice), 1.2),
        ("plane", made(&plane, dice), 1.05),
        ("plane to an error", made(&plane, solid), 1.6),
        ("adapt", made(&ring, error), 1.7),
        ("sweep", made(&ring, view), 1.8),
        ("cube", made(&cube(2).expect("a mesh"), MeshSettings { texels: 1000, ..dice }), 3.0),
    ]
}

#[test]
fn strips_decode_to_the_very_triangles() {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, mesher, most) in meshes() {
        let bounds = mesher.bounds(1.0, &Watch::none()).expect("finite").positions_m;
        let grid = PositionGrid::around(&[bounds], 12).expect("finite")[0];
        for quantization in [None, Some(Quantization { grid, uvs: false })] {
            let blocks = blocks(&mesher, quantization.map(|how| how.grid));
            let level = GlbLevel { counts: counts(&mesher), coverage: 0.0 };
            let plain = GlbLayout {
                levels: vec![level],
                quantization,
                strips: false,
                node: GlbNode::default(),
                materials: None,
            };
            let layout = GlbLayout { strips: true, ..plain.clone() };
            let written = |layout: &GlbLayout, file: &str| {
                let path = folder.path().join(file);
                let counts = write_glb(&path, layout, |sink| blocks.iter().try_for_each(&mut *sink));
                (counts.expect("written"), std::fs::read(&path).expect("written"))
            };
            let [(all, lists), (count, strips)] = [written(&plain, "a.glb"), written(&layout, "b.glb")];
            assert_eq!((all, lists.len() as u64), (vec![3 * mesher.triangles()], plain.bytes()));
            assert!(strips.len() < lists.len() && strips.len() as u64 <= layout.bytes(), "{name}");
            assert_eq!(strips, written(&layout, "b.glb").1, "{name}");
            let (json, buffer) = glb::parts(&strips);
            assert_eq!(json["meshes"][0]["primitives"][0]["mode"], 5);
            assert_eq!(json["buffers"][0]["byteLength"], buffer.len());
            let mut indices = glb::indices(&json, buffer, 0);
            assert_eq!(count, [indices.len() as u64]);
            let of_each = indices.len() as f64 / mesher.triangles() as f64;
            println!("{name}: {} triangles, {of_each:.3} indices each", mesher.triangles());
            assert!(of_each < most, "{name}: {of_each}");
            let wanted = sorted(blocks.iter().flat_map(|block| block.triangles.iter().copied()));
            assert_eq!(decoded(&indices), wanted, "{name}");
            // The lists are the same triangles, and the vertices the same bytes.
            let (of_lists, lists) = glb::parts(&lists);
            let listed = glb::indices(&of_lists, lists, 0);
            assert_eq!(sorted(listed.as_chunks().0.iter().copied()), wanted, "{name}");
            let of_vertices = of_lists["bufferViews"][0]["byteLength"].as_u64().expect("a number") as usize;
            assert_eq!(buffer[..of_vertices], lists[..of_vertices], "{name}");
            // The reader leaves out what joins.
            let read = read_raw_mesh(folder.path().join("b.glb").as_path(), 1 << 30).expect("read");
            assert_eq!(read.triangles.len(), wanted.len(), "{name}");
            // An index more or less turns over all that follow; two that change places, some.
            indices.insert(0, indices[0]);
            assert_ne!(decoded(&indices), wanted, "{name}");
            indices.remove(0);
            let is_triangle = |at: &usize| {
                let [a, b, c] = [indices[*at], indices[at + 1], indices[at + 2]];
                a != b && b != c && c != a
            };
            let middle = (indices.len() / 2..).find(is_triangle).expect("a triangle");
            indices.swap(middle, middle + 1);
            assert_ne!(decoded(&indices), wanted, "{name}");
        }
    }
}

#[test]
fn levels_have_strips_of_their_own() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.glb");
    let base = torus(24, 12).expect("a mesh");
    let meshers = [0, 1, 2]
        .map(|level| Mesher::new(&base, &map(), &MeshSettings::default().coarser(level)).expect("a mesh"));
    let levels = GlbLevel::of(&meshers.each_ref().map(counts));
    let layout =
        GlbLayout { levels, quantization: None, strips: true, node: GlbNode::default(), materials: None };
    let blocks = meshers.each_ref().map(|mesher| blocks(mesher, None));
    let written = write_glb(&path, &layout, |sink| blocks.iter().flatten().try_for_each(&mut *sink));
    let bytes = std::fs::read(&path).expect("written");
    let (json, buffer) = glb::parts(&bytes);
    for (at, (blocks, count)) in blocks.iter().zip(written.expect("written")).enumerate() {
        let indices = glb::indices(&json, buffer, at);
        assert_eq!(indices.len() as u64, count);
        let wanted = sorted(blocks.iter().flat_map(|block| block.triangles.iter().copied()));
        assert_eq!(decoded(&indices), wanted, "level {at}");
    }
    // Without a triangle there is no strip, and no file.
    let vertices = blocks[0][0].vertices[..2].to_vec();
    let block = MeshBlock { vertices, triangles: vec![[0, 1, 0]], ..MeshBlock::default() };
    let level = GlbLevel { counts: MeshCounts { vertices: 2, triangles: 1 }, coverage: 0.0 };
    let layout = GlbLayout { levels: vec![level], ..layout };
    let none = folder.path().join("none.glb");
    assert!(write_glb(&none, &layout, |sink| sink(&block)).is_err() && !none.exists());
}
