use super::*;
use crate::TangentFrame;
use proptest::prelude::*;
use std::collections::HashMap;

/// The built-in mesh of this kind with about `n` divisions.
fn build(kind: Builtin, n: u32) -> Mesh {
    match kind {
        Builtin::Plane | Builtin::Square => square(n),
        Builtin::Cube => cube(n),
        Builtin::Cylinder => cylinder(n.max(3), n),
        Builtin::Sphere => sphere(n.max(3), n.max(2)),
        Builtin::Torus => torus(n.max(3), n.max(3)),
    }
    .expect("divisions in range")
}

/// Key of a position: equal exactly if the positions are, with -0 and 0 alike.
fn key(position: Vec3) -> [u32; 3] {
    (position + Vec3::ZERO).to_array().map(f32::to_bits)
}

/// True frame of a triangle, from its positions and texture coordinates alone.
fn own_frame(mesh: &Mesh, triangle: u32) -> TangentFrame {
    let corners = mesh.corners(triangle);
    let positions = corners.map(|corner| corner.position.as_dvec3());
    let uvs = corners.map(|corner| corner.uv.as_dvec2());
    TangentFrame::of_triangle(positions, uvs).expect("no degenerate triangle")
}

/// Largest difference between a triangle's own frame and the mean of its corners' frames, relative
/// to the longest tangent and bitangent of the mesh. Tangents at a pole are left out: they are
/// chosen, not derived.
fn frame_error(mesh: &Mesh) -> f64 {
    let mut worst = 0.0f64;
    let longest =
        |vector: fn(&Vertex) -> Vec3| mesh.vertices().iter().map(|v| vector(v).length()).fold(0.0, f32::max);
    let longest_tangent = f64::from(longest(|vertex| vertex.tangent));
    let longest_bitangent = f64::from(longest(|vertex| vertex.bitangent));
    for triangle in 0..mesh.triangles().len() as u32 {
        let own = own_frame(mesh, triangle);
        let mean = mesh.interpolated(triangle, [1.0 / 3.0; 3]);
        let at_pole = mesh
            .corners(triangle)
            .iter()
            .any(|corner| corner.position.x == 0.0 && corner.position.z == 0.0 && corner.tangent != Vec3::X);
        let error = |own: glam::DVec3, mean: Vec3| (own - mean.as_dvec3()).length();
        if !at_pole {
            worst = worst.max(error(own.tangent, mean.tangent) / longest_tangent);
        }
        worst = worst.max(error(own.bitangent, mean.bitangent) / longest_bitangent);
        worst = worst.max(error(own.normal, mean.normal));
    }
    worst
}

fn is_watertight(mesh: &Mesh) -> bool {
    let mut edges: HashMap<_, i32> = HashMap::new();
    for triangle in 0..mesh.triangles().len() as u32 {
        let [a, b, c] = mesh.corners(triangle).map(|corner| key(corner.position));
        for (from, to) in [(a, b), (b, c), (c, a)] {
            // Its two triangles run through each edge once in each direction.
            *edges.entry((from, to)).or_default() += 1;
        }
    }
    edges.iter().all(|(&(from, to), &count)| count == 1 && edges.get(&(to, from)) == Some(&1))
}

#[test]
fn frames_are_the_derivatives_of_the_position() {
    for kind in Builtin::ALL {
        let (coarse, fine) = (frame_error(&build(kind, 100)), frame_error(&build(kind, 400)));
        // Flat faces agree to rounding; curved ones converge as their triangles shrink.
        assert!(fine < 1e-4 || fine < 0.4 * coarse, "{kind}: {coarse} at 100 divisions, {fine} at 400");
        assert!(fine < 0.02, "{kind}: {fine}");
    }
}

#[test]
fn a_wrong_tangent_is_noticed() {
    let mut mesh = build(Builtin::Torus, 100);
    for vertex in &mut mesh.vertices {
        vertex.tangent *= 1.05;
    }
    assert!(frame_error(&mesh) > 0.04);
}

#[test]
fn closed_meshes_have_no_holes() {
    for kind in [Builtin::Cube, Builtin::Cylinder, Builtin::Sphere, Builtin::Torus] {
        assert!(is_watertight(&kind.build([1.0, 1.0]).expect("a built-in")), "{kind}");
        let mut open = build(kind, 9);
        open.triangles.pop();
        assert!(!is_watertight(&open), "{kind} without a triangle");
    }
    assert!(!is_watertight(&build(Builtin::Plane, 2)));
}

#[test]
fn every_built_in_fills_the_unit_cube() {
    for kind in Builtin::ALL {
        let mesh = kind.build([1.0, 1.0]).expect("a built-in");
        let least = mesh.vertices().iter().fold(Vec3::MAX, |least, v| least.min(v.position));
        let most = mesh.vertices().iter().fold(Vec3::MIN, |most, v| most.max(v.position));
        assert!(least.min_element() >= -0.5 && most.max_element() <= 0.5, "{kind}: {least} to {most}");
        assert_eq!((least.x, most.x, least.z, most.z), (-0.5, 0.5, -0.5, 0.5), "{kind}");
    }
}

#[test]
fn textures_stand_upright_in_front() {
    // Seen from +z with y up, u grows to the right and v downward on every upright mesh.
    for kind in [Builtin::Cube, Builtin::Cylinder, Builtin::Sphere, Builtin::Torus] {
        let mesh = build(kind, 16);
        let forwardness = |vertex: &Vertex| vertex.normal.z + vertex.position.z;
        let front = mesh.vertices().iter().max_by(|a, b| forwardness(a).total_cmp(&forwardness(b)));
        let front = front.expect("a mesh has vertices");
        assert!(front.tangent.x > 0.0 && front.bitangent.y < 0.0, "{kind}: {front:?}");
    }
}

#[test]
fn names_lead_back_to_their_mesh() {
    for kind in Builtin::ALL {
        assert_eq!(kind.name().parse(), Ok(kind));
    }
    let error = "shpere".parse::<Builtin>().expect_err("no such mesh");
    assert_eq!(error.nearest.as_deref(), Some("sphere"));
}

#[test]
fn impossible_meshes_are_refused() {
    assert!(matches!(square(0), Err(MeshError::BadDivisions { given: 0, .. })));
    assert!(sphere(3, 1).is_err() && torus(2, 3).is_err() && cylinder(3, MAX_DIVISIONS + 1).is_err());
    let mesh = build(Builtin::Plane, 1);
    let impossible = [
        Vec2::new(0.0, 1.0),
        Vec2::new(1.0, -2.0),
        Vec2::new(f32::NAN, 1.0),
        Vec2::splat(1e-45),
        // Tangents whose squares are not normal numbers in `f32`.
        Vec2::splat(1e-25),
        Vec2::splat(1e25),
        Vec2::new(1.0, 1e20),
    ];
    for tile in impossible {
        assert!(matches!(mesh.clone().tiled(tile), Err(MeshError::BadTile(..))), "{tile}");
    }
    let error = Mesh::new(mesh.vertices.clone(), vec![[0, 1, 4]]);
    assert!(matches!(error, Err(MeshError::NoSuchVertex { triangle: 0, index: 4, vertices: 4 })));
    let mut broken = mesh.vertices.clone();
    broken[2].normal.x = f32::INFINITY;
    assert_eq!(Mesh::new(broken, mesh.triangles), Err(MeshError::NotFinite(2)));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn every_triangle_faces_outward_with_a_right_handed_frame(n in 1u32..40, which in 0usize..5) {
        let mesh = build(Builtin::ALL[which], n);
        for triangle in 0..mesh.triangles().len() as u32 {
            let own = own_frame(&mesh, triangle);
            prop_assert!(own.handedness() > 0.0);
            for corner in mesh.corners(triangle) {
                prop_assert!((corner.normal.length() - 1.0).abs() < 1e-6);
                // Each corner's normal is within the angle that the faces around it span.
                prop_assert!(own.normal.dot(corner.normal.as_dvec3()) > 0.0);
                prop_assert!(corner.normal.dot(corner.bitangent.cross(corner.tangent)) > 0.0);
                prop_assert!(corner.normal.dot(corner.tangent).abs() < 1e-5);
                prop_assert!(corner.normal.dot(corner.bitangent).abs() < 1e-5);
            }
        }
    }

    #[test]
    fn tiling_keeps_frames_true(u in 0.1f32..20.0, v in 0.1f32..20.0, which in 0usize..5) {
        let mesh = build(Builtin::ALL[which], 50).tiled(Vec2::new(u, v)).expect("positive factors");
        prop_assert!(frame_error(&mesh) < 0.1);
        let most = mesh.vertices().iter().fold(Vec2::ZERO, |most, vertex| most.max(vertex.uv));
        prop_assert!((most - Vec2::new(u, v)).abs().max_element() < 1e-4);
    }
}

#[test]
fn the_length_of_a_tile_is_that_of_the_tangents() {
    let is_near = |[u, v]: [f64; 2], [x, y]: [f64; 2]| (u - x).abs() < 1e-6 && (v - y).abs() < 1e-6;
    assert!(is_near(build(Builtin::Plane, 3).tile_m(), [1.0, 1.0]));
    let tiled = build(Builtin::Plane, 3).tiled(Vec2::new(4.0, 0.5)).expect("positive factors");
    assert!(is_near(tiled.tile_m(), [0.25, 2.0]));
    for kind in [Builtin::Cube, Builtin::Cylinder, Builtin::Sphere, Builtin::Torus] {
        let mesh = build(kind, 24);
        let lengths = mesh.vertices().iter().map(|vertex| f64::from(vertex.tangent.length()));
        let (least, most) = lengths.fold((f64::MAX, 0.0f64), |(least, most), x| (least.min(x), most.max(x)));
        let [u, v] = mesh.tile_m();
        assert!(u >= least - 1e-6 && u <= most + 1e-6 && v > 0.0, "{kind:?}: {u} {v}, {least} to {most}");
    }
    assert_eq!(Mesh::new(Vec::new(), Vec::new()).expect("an empty mesh").tile_m(), [0.0; 2]);
}
