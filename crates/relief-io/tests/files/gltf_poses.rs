//! Morph targets and skins of a glTF move its vertices.

use crate::common::gltf_file::{Gltf, Numbers};
use glam::Vec3;
use relief_io::{MeshFile, MeshOptions, ReadError, ReadProblem, Source, read_mesh};

fn read(file: &Gltf) -> Result<MeshFile, ReadError> {
    read_mesh(Source::bytes("a.gltf", &file.json()), &MeshOptions::default())
}

/// The box that a file's mesh fills.
fn bounds(file: &Gltf) -> [Vec3; 2] {
    read(file).unwrap_or_else(|error| panic!("{error}")).mesh.measures().bounds_m
}

fn assert_damaged(what: &str, file: &Gltf) {
    let problem = read(file).map(|_| ()).map_err(|error| error.problem);
    assert!(matches!(problem, Err(ReadProblem::Damaged { .. })), "{what}: {problem:?}");
}

const Z: [f32; 3] = [0.0, 0.0, 1.0];

/// The square with morph targets that move all of it by those vectors.
fn morphed(moves: &[[f32; 3]], of_mesh: &str, of_node: &str) -> Gltf {
    let mut file = Gltf::square();
    let targets: Vec<String> = moves
        .iter()
        .map(|by| {
            let at =
                file.add(Numbers::Floats(&by.repeat(4)), "VEC3", r#", "min": [0, 0, 0], "max": [1, 1, 1]"#);
            format!(r#"{{"POSITION": {at}}}"#)
        })
        .collect();
    file.primitive = format!(r#", "targets": [{}]"#, targets.join(", "));
    (file.mesh, file.node) = (of_mesh.to_owned(), of_node.to_owned());
    file
}

#[test]
fn morph_targets_move_vertices_by_their_weights() {
    let at = |z: f32| [Vec3::new(0.0, 0.0, z), Vec3::new(1.0, 1.0, z)];
    assert_eq!(bounds(&morphed(&[Z], "", r#", "weights": [1]"#)), at(1.0));
    assert_eq!(bounds(&morphed(&[Z], r#", "weights": [0.5]"#, "")), at(0.5));
    // Weights of the node override the mesh's, and without any there is no pose.
    assert_eq!(bounds(&morphed(&[Z], r#", "weights": [0.5]"#, r#", "weights": [2]"#)), at(2.0));
    assert_eq!(bounds(&morphed(&[Z], "", "")), at(0.0));
    let both = morphed(&[Z, [1.0, 0.0, 0.0]], "", r#", "weights": [0.25, 2], "translation": [0, 0, 3]"#);
    assert_eq!(bounds(&both), [Vec3::new(2.0, 0.0, 3.25), Vec3::new(3.0, 1.0, 3.25)]);
    // Normals go along.
    let mut tilted = morphed(&[Z], "", r#", "weights": [1]"#);
    let by = tilted.add(Numbers::Floats(&[0.0, 1.0, -1.0].repeat(4)), "VEC3", "");
    tilted.primitive =
        tilted.primitive.replace(r#"{"POSITION""#, &format!(r#"{{"NORMAL": {by}, "POSITION""#));
    let mesh = read(&tilted).expect("a mesh").mesh;
    assert!(mesh.vertices().iter().all(|vertex| vertex.normal == Vec3::Y));
}

#[test]
fn morph_targets_that_cannot_be_are_refused() {
    let mut missing = morphed(&[Z], "", r#", "weights": [1]"#);
    missing.primitive = r#", "targets": [{"POSITION": 99}]"#.to_owned();
    assert_damaged("a target that is not there", &missing);
    let mut short = Gltf::square();
    let at = short.add(Numbers::Floats(&Z), "VEC3", r#", "min": [0, 0, 0], "max": [1, 1, 1]"#);
    short.primitive = format!(r#", "targets": [{{"POSITION": {at}}}]"#);
    short.node = r#", "weights": [1]"#.to_owned();
    assert_damaged("a target of one vertex", &short);
    assert_damaged("a weight that is no number", &morphed(&[Z], "", r#", "weights": [1e39]"#));
}

/// The square on a node that is far away and large, with a skin of two joints at z = 2 and z = 4.
fn skinned(joints: &[u8], weights: &[f32], skin: &str) -> Gltf {
    let mut file = Gltf::square();
    let of_joints = file.add(Numbers::Bytes(joints), "VEC4", "");
    let of_weights = file.add(Numbers::Floats(weights), "VEC4", "");
    file.attributes = format!(r#", "JOINTS_0": {of_joints}, "WEIGHTS_0": {of_weights}"#);
    file.node = r#", "skin": 0, "translation": [9, 9, 9], "scale": [100, 100, 100]"#.to_owned();
    // The second joint hangs below the first, and neither is in the scene.
    file.nodes = r#", {"translation": [0, 0, 2], "children": [2]}, {"translation": [0, 0, 2]}"#.to_owned();
    file.more = format!(r#", "skins": [{{"joints": [1, 2]{skin}}}]"#);
    file
}

#[test]
fn vertices_of_skins_follow_their_joints_alone() {
    let at = |z: f32| [Vec3::new(0.0, 0.0, z), Vec3::new(1.0, 1.0, z)];
    let first = [1.0, 0.0, 0.0, 0.0].repeat(4);
    assert_eq!(bounds(&skinned(&[0; 16], &first, "")), at(2.0));
    assert_eq!(bounds(&skinned(&[1, 0, 0, 0].repeat(4), &first, "")), at(4.0));
    let halves = skinned(&[0, 1, 0, 0].repeat(4), &[0.5, 0.5, 0.0, 0.0].repeat(4), "");
    assert_eq!(bounds(&halves), at(3.0));
    // Weights are parts of their sum, and where that is 0 the first joint counts.
    let thirds = skinned(&[0, 1, 0, 0].repeat(4), &[0.25, 0.25, 0.0, 0.0].repeat(4), "");
    assert_eq!(bounds(&thirds), at(3.0));
    assert_eq!(bounds(&skinned(&[1, 0, 0, 0].repeat(4), &[0.0; 16], "")), at(4.0));
    // Joints without weight need not exist.
    assert_eq!(bounds(&skinned(&[0, 200, 0, 0].repeat(4), &first, "")), at(2.0));
    // Inverse bind matrices undo the joints' bind pose.
    let mut bound = skinned(&[0, 1, 0, 0].repeat(4), &[0.5, 0.5, 0.0, 0.0].repeat(4), "");
    let undo = |z: f32| [1., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1., 0., 0., 0., -z, 1.];
    let matrices = bound.add(Numbers::Floats(&[undo(2.0), undo(4.0)].concat()), "MAT4", "");
    bound.more = format!(r#", "skins": [{{"joints": [1, 2], "inverseBindMatrices": {matrices}}}]"#);
    assert_eq!(bounds(&bound), at(0.0));
    // A second set of joints.
    let mut more = skinned(&[0; 16], &[0.5, 0.0, 0.0, 0.0].repeat(4), "");
    let joints = more.add(Numbers::Bytes(&[1; 16]), "VEC4", "");
    let weights = more.add(Numbers::Floats(&[0.5, 0.0, 0.0, 0.0].repeat(4)), "VEC4", "");
    more.attributes += &format!(r#", "JOINTS_1": {joints}, "WEIGHTS_1": {weights}"#);
    assert_eq!(bounds(&more), at(3.0));
}

#[test]
fn joints_may_turn_triangles_over() {
    let mut mirrored = skinned(&[0; 16], &[1.0, 0.0, 0.0, 0.0].repeat(4), "");
    mirrored.nodes = r#", {"scale": [-1, 1, 1], "children": [2]}, {}"#.to_owned();
    let mesh = read(&mirrored).expect("a mesh").mesh;
    for triangle in 0..mesh.triangles().len() as u32 {
        let [a, b, c] = mesh.corners(triangle).map(|corner| corner.position);
        assert!((b - a).cross(c - a).z > 0.0 && mesh.corners(triangle)[0].normal == Vec3::Z);
    }
}

#[test]
fn skins_that_cannot_be_are_refused() {
    let first = [1.0, 0.0, 0.0, 0.0].repeat(4);
    assert_damaged("a joint that is not there", &skinned(&[7, 0, 0, 0].repeat(4), &first, ""));
    let mut node = skinned(&[0; 16], &first, "");
    node.more = r#", "skins": [{"joints": [44]}]"#.to_owned();
    assert_damaged("a joint that is no node", &node);
    let mut bare = skinned(&[0; 16], &first, "");
    bare.attributes = String::new();
    assert_damaged("no joints", &bare);
    let mut half = skinned(&[0; 16], &first, "");
    half.attributes = r#", "JOINTS_0": 4"#.to_owned();
    assert_damaged("no weights", &half);
    let mut short = skinned(&[0; 16], &first, "");
    short.attributes = r#", "JOINTS_0": 4, "WEIGHTS_0": 6"#.to_owned();
    short.add(Numbers::Floats(&first[..8]), "VEC4", "");
    assert_damaged("weights of two vertices", &short);
    for weight in [f32::NAN, f32::INFINITY, -0.5] {
        let weights = [weight, 1.0, 0.0, 0.0].repeat(4);
        assert_damaged("a weight", &skinned(&[0; 16], &weights, ""));
    }
    let mut matrices = skinned(&[0; 16], &first, "");
    let one = matrices.add(Numbers::Floats(&[1.0; 16]), "MAT4", "");
    matrices.more = format!(r#", "skins": [{{"joints": [1, 2], "inverseBindMatrices": {one}}}]"#);
    assert_damaged("a matrix too few", &matrices);
}
