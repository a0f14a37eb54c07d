use super::*;
use crate::mesh::{Builtin, MeshError, cube, cylinder, sphere, square, torus};
use glam::{Quat, Vec2, Vec3};

/// Second fundamental form of a surface at a vertex: curvature times length squared, positive
/// outward.
type Form = fn(&Vertex, DVec3, DVec3) -> f64;

fn of_sphere(_: &Vertex, a: DVec3, b: DVec3) -> f64 {
    -a.dot(b) / 0.5
}

fn of_cylinder(vertex: &Vertex, a: DVec3, b: DVec3) -> f64 {
    let around = |v: DVec3| v.cross(vertex.normal.as_dvec3()).y;
    if vertex.normal.y == 0.0 { -around(a) * around(b) / 0.5 } else { 0.0 }
}

fn of_torus(vertex: &Vertex, a: DVec3, b: DVec3) -> f64 {
    let p = vertex.position.as_dvec3();
    let distance = p.x.hypot(p.z);
    let ring = DVec3::new(p.z, 0.0, -p.x) / distance;
    let tube = ring.cross(vertex.normal.as_dvec3());
    let cos = (distance - 0.35) / 0.15;
    -cos / distance * ring.dot(a) * ring.dot(b) - tube.dot(a) * tube.dot(b) / 0.15
}

/// Exact coefficients at a vertex.
fn exact(vertex: &Vertex, form: Form) -> [f64; 3] {
    let [t, b] = [vertex.tangent, vertex.bitangent].map(|v| v.as_dvec3());
    [0.5 * form(vertex, t, t), form(vertex, t, b), 0.5 * form(vertex, b, b)]
}

/// Difference between coefficients in curvatures (1/m), as Frobenius' norm of the second
/// fundamental form. It is the root of the mean square over a mesh, relative to the norm of the
/// true curvatures.
fn error(mesh: &Mesh, quadrics: &[[f32; 3]], form: Form) -> f64 {
    let [mut wrong, mut all] = [0.0; 2];
    for (vertex, quadric) in mesh.vertices().iter().zip(quadrics) {
        let [t, b] = [vertex.tangent, vertex.bitangent].map(|v| f64::from(v.length()));
        let exact = exact(vertex, form);
        for (i, metres) in [t * t, t * b * 2f64.sqrt(), b * b].into_iter().enumerate() {
            wrong += ((f64::from(quadric[i]) - exact[i]) / metres).powi(2);
            all += (exact[i] / metres).powi(2);
        }
    }
    (wrong / all).sqrt()
}

/// Graph of a height over a grid around the origin, `u` along `x` and `v` along `z`, with the given
/// tile along each.
fn graph(n: i32, step: f64, [t, b]: [DVec3; 2], height: impl Fn(f64, f64) -> f64) -> Mesh {
    let at = |i: i32, j: i32| {
        let [x, z] = [i, j].map(|k| f64::from(k) * step);
        DVec3::new(x, height(x, z), z)
    };
    let mut vertices = Vec::new();
    let mut triangles = Vec::new();
    for j in -n..=n {
        for i in -n..=n {
            let [x, z] = [i, j].map(|k| f64::from(k) * step);
            let slope = |dx: f64, dz: f64| (height(x + dx, z + dz) - height(x - dx, z - dz)) / 2e-4;
            let [by_x, by_z] = [slope(1e-4, 0.0), slope(0.0, 1e-4)];
            let raised = |v: DVec3| DVec3::new(v.x, by_x * v.x + by_z * v.z, v.z).as_vec3();
            vertices.push(Vertex {
                position: at(i, j).as_vec3(),
                normal: DVec3::new(-by_x, 1.0, -by_z).normalize().as_vec3(),
                tangent: raised(t),
                bitangent: raised(b),
                uv: Vec2::ZERO,
            });
        }
    }
    let width = 2 * n as u32 + 1;
    for j in 0..width - 1 {
        for i in 0..width - 1 {
            let corner = j * width + i;
            triangles.push([corner, corner + width, corner + width + 1]);
            triangles.push([corner, corner + width + 1, corner + 1]);
        }
    }
    Mesh::new(vertices, triangles).expect("a mesh")
}

fn middle(mesh: &Mesh, coefficients: QuadricCoefficients) -> [f32; 3] {
    mesh.quadrics(coefficients)[mesh.vertices().len() / 2]
}

fn is_near(found: [f32; 3], expected: [f64; 3], within: f64) -> bool {
    (0..3).all(|i| (f64::from(found[i]) - expected[i]).abs() < within)
}

#[test]
fn quadrics_are_those_of_the_true_surface() {
    let cases: [(&str, Result<Mesh, MeshError>, Form, f64); 8] = [
        ("sphere 8x4", sphere(8, 4), of_sphere, 1e-5),
        ("sphere 128x64", sphere(128, 64), of_sphere, 1e-4),
        ("torus 16x8", torus(16, 8), of_torus, 0.08),
        ("torus 32x16", torus(32, 16), of_torus, 0.02),
        ("torus 128x64", torus(128, 64), of_torus, 1.5e-3),
        ("cylinder 12x1", cylinder(12, 1), of_cylinder, 5e-3),
        ("cylinder 128x1", cylinder(128, 1), of_cylinder, 1e-4),
        ("cylinder 64x16", cylinder(64, 16), of_cylinder, 1e-3),
    ];
    for (name, mesh, form, most) in cases {
        let mesh = mesh.expect("a mesh");
        let mut quadrics = mesh.quadrics(QuadricCoefficients::Three);
        let three = error(&mesh, &quadrics, form);
        let two = error(&mesh, &mesh.quadrics(QuadricCoefficients::Two), form);
        println!("{name}: {three:.2e} with three coefficients, {two:.2e} with two");
        // These textures run along the principal directions, so two coefficients suffice.
        assert!(three < most && two < most, "{name}: {three} {two}");
        // Another sign or factor is noticed.
        for factor in [-1.0, 0.5, 1.1] {
            let wrong: Vec<_> = quadrics.iter().map(|quadric| quadric.map(|x| x * factor)).collect();
            assert!(error(&mesh, &wrong, form) > most, "{name}: {factor}");
        }
        for quadric in &mut quadrics {
            quadric.swap(0, 2);
        }
        assert!(error(&mesh, &quadrics, form) > most, "{name}: swapped");
    }
}

#[test]
fn tori_are_saddles_within_and_convex_without() {
    let mesh = torus(32, 16).expect("a mesh");
    let quadrics = mesh.quadrics(QuadricCoefficients::Three);
    for (vertex, [a, b, c]) in mesh.vertices().iter().zip(quadrics) {
        let outward = vertex.position.with_y(0.0).length() - 0.35;
        assert!(c < 0.0 && (outward.abs() < 0.05 || (a < 0.0) == (outward > 0.0)));
        assert!(b.abs() < 0.05 * c.abs());
    }
}

#[test]
fn flat_faces_have_none() {
    for mesh in [square(1), square(5), cube(3)].map(|mesh| mesh.expect("a mesh")) {
        for coefficients in [QuadricCoefficients::Two, QuadricCoefficients::Three] {
            assert!(mesh.quadrics(coefficients).iter().flatten().all(|&x| x == 0.0));
        }
    }
}

#[test]
fn only_three_coefficients_keep_a_saddle() {
    let saddle = graph(2, 0.02, [DVec3::X, DVec3::Z], |x, z| x * z);
    assert!(is_near(middle(&saddle, QuadricCoefficients::Three), [0.0, 1.0, 0.0], 1e-3));
    assert!(is_near(middle(&saddle, QuadricCoefficients::Two), [0.0; 3], 0.2));
    // The same saddle in axes in which two coefficients represent it.
    let axes = [DVec3::new(1.0, 0.0, 1.0), DVec3::new(-1.0, 0.0, 1.0)];
    let turned = graph(2, 0.02, axes, |x, z| x * z);
    for coefficients in [QuadricCoefficients::Two, QuadricCoefficients::Three] {
        assert!(is_near(middle(&turned, coefficients), [1.0, 0.0, -1.0], 1e-2));
    }
}

#[test]
fn sheared_stretched_and_mirrored_textures_have_the_same_surface() {
    let height = |x: f64, z: f64| -0.5 * x * x + 0.3 * x * z + 0.2 * z * z;
    let t = DVec3::new(3.0, 0.0, 0.5);
    for b in [DVec3::new(1.0, 0.0, 0.4), DVec3::new(0.2, 0.0, -2.0)] {
        let mesh = graph(2, 0.01, [t, b], height);
        // Heights along u, along v and along both.
        let expected = [
            height(t.x, t.z),
            height(t.x + b.x, t.z + b.z) - height(t.x, t.z) - height(b.x, b.z),
            height(b.x, b.z),
        ];
        assert!(is_near(middle(&mesh, QuadricCoefficients::Three), expected, 3e-3));
        assert_eq!(middle(&mesh, QuadricCoefficients::Two)[1], 0.0);
    }
    // Two coefficients are exact in sheared axes, too, if the surface has only two in them.
    let b = DVec3::new(1.0, 0.0, 0.4);
    let height = |x: f64, z: f64| {
        let v = (z * t.x - x * t.z) / (t.x * b.z - b.x * t.z);
        let u = (x - v * b.x) / t.x;
        0.5 * u * u - 0.25 * v * v
    };
    let mesh = graph(2, 0.005, [t, b], height);
    for coefficients in [QuadricCoefficients::Two, QuadricCoefficients::Three] {
        assert!(is_near(middle(&mesh, coefficients), [0.5, 0.0, -0.25], 5e-3));
    }
    let mirrored = graph(2, 0.005, [-t, b], |x, z| x * z);
    let plain = graph(2, 0.005, [t, b], |x, z| x * z);
    let [[a, b, c], other] = [plain, mirrored].map(|mesh| middle(&mesh, QuadricCoefficients::Three));
    assert!(is_near(other, [a, -b, c].map(f64::from), 1e-5));
}

#[test]
fn both_sides_of_a_seam_have_the_same() {
    let mut mesh = torus(16, 8).expect("a mesh");
    // The right half of the seam is mirrored, and its tiles are half as long.
    for vertex in &mut mesh.vertices {
        if vertex.uv.x == 1.0 {
            vertex.tangent *= -0.5;
        }
    }
    for coefficients in [QuadricCoefficients::Two, QuadricCoefficients::Three] {
        let quadrics = mesh.quadrics(coefficients);
        let mut met = 0;
        for (at, vertex) in mesh.vertices().iter().enumerate().filter(|(_, vertex)| vertex.uv.x == 0.0) {
            let is_other = |other: &Vertex| other.position == vertex.position && other.uv.x == 1.0;
            let others = mesh.vertices().iter().zip(&quadrics).filter(|(other, _)| is_other(other));
            for (_, &[a, b, c]) in others {
                let [a, b] = [4.0 * a, -2.0 * b];
                assert!(is_near([a, b, c], quadrics[at].map(f64::from), 1e-5 * f64::from(c.abs())));
                met += 1;
            }
        }
        assert!(met >= 9, "{met}");
    }
}

#[test]
fn a_hard_edge_parts_stars() {
    // Each side of the roof is flat, and remains so with separate normals.
    let roof = |normals: [Vec3; 2]| {
        let mut mesh = graph(1, 1.0, [DVec3::X, DVec3::Z], |x, _| -x.abs());
        let mut vertices = mesh.vertices.clone();
        for (at, corners) in mesh.triangles.iter_mut().enumerate() {
            let side = usize::from(at % 4 >= 2);
            for corner in corners {
                let mut vertex = mesh.vertices[*corner as usize];
                vertex.normal = normals[side];
                *corner = vertices.len() as u32;
                vertices.push(vertex);
            }
        }
        Mesh::new(vertices, mesh.triangles).expect("a mesh").quadrics(QuadricCoefficients::Three)
    };
    let [left, right] = [Vec3::new(-1.0, 1.0, 0.0), Vec3::new(1.0, 1.0, 0.0)].map(Vec3::normalize);
    assert!(roof([left, right]).iter().flatten().all(|x| x.abs() < 1e-6));
    // With a common normal it is a bend.
    assert!(roof([Vec3::Y; 2]).iter().any(|[a, ..]| *a < -0.3));
}

#[test]
fn what_a_star_leaves_open_is_0() {
    let vertex = |position: DVec3, normal: DVec3| Vertex {
        position: position.as_vec3(),
        normal: normal.as_vec3(),
        tangent: Vec3::X,
        bitangent: Vec3::Z,
        uv: Vec2::ZERO,
    };
    // Three points around a cylinder of radius 1 along z. They determine only the bend along x.
    let on = |angle: f64| {
        let (sin, cos) = angle.sin_cos();
        vertex(DVec3::new(sin, cos, 0.0), DVec3::new(sin, cos, 0.0))
    };
    let mesh = Mesh::new(vec![on(0.0), on(0.1), on(-0.2)], vec![[0, 1, 2]]).expect("a mesh");
    assert!(is_near(mesh.quadrics(QuadricCoefficients::Three)[0], [-0.5, 0.0, 0.0], 1e-6));
    assert!(is_near(mesh.quadrics(QuadricCoefficients::Two)[0], [-0.5, 0.0, 0.0], 1e-6));
    // Neighbours on the same point, straight above, and no neighbours at all.
    let point = vertex(DVec3::ZERO, DVec3::Y);
    let above = vertex(DVec3::Y, DVec3::Y);
    let hard = vertex(DVec3::ZERO, DVec3::X);
    let mesh = Mesh::new(vec![point, above, hard, point], vec![[0, 0, 0], [0, 1, 3], [2, 3, 0]]);
    let quadrics = mesh.expect("a mesh").quadrics(QuadricCoefficients::Three);
    assert!(quadrics[0] == [0.0; 3] && quadrics[3] == [0.0; 3]);
    let alone = Mesh::new(vec![point], Vec::new()).expect("a mesh");
    assert_eq!(alone.quadrics(QuadricCoefficients::Three), [[0.0; 3]]);
}

#[test]
fn extreme_meshes_have_finite_quadrics() {
    let numbers = [0.0f32, 1e-45, 1e-30, 1.0, -1e20, 3e38];
    let mut next = 0usize;
    let mut number = || {
        next = (next * 1_103_515_245 + 12_345) % (1 << 31);
        numbers[(next >> 8) % numbers.len()]
    };
    for _ in 0..200 {
        let mut mesh = square(2).expect("a mesh");
        for vertex in &mut mesh.vertices {
            for vector in
                [&mut vertex.position, &mut vertex.normal, &mut vertex.tangent, &mut vertex.bitangent]
            {
                if number() > 0.0 {
                    *vector = Vec3::new(number(), number(), number());
                }
            }
        }
        for coefficients in [QuadricCoefficients::Two, QuadricCoefficients::Three] {
            assert!(mesh.quadrics(coefficients).iter().flatten().all(|x| x.is_finite()));
        }
    }
}

#[test]
fn turning_a_mesh_changes_nothing() {
    let plain = torus(12, 7).expect("a mesh");
    let mut turned = plain.clone();
    let turn = Quat::from_scaled_axis(Vec3::new(0.4, -1.3, 0.8));
    for vertex in &mut turned.vertices {
        for vector in [&mut vertex.position, &mut vertex.normal, &mut vertex.tangent, &mut vertex.bitangent] {
            *vector = turn * *vector;
        }
    }
    for coefficients in [QuadricCoefficients::Two, QuadricCoefficients::Three] {
        let pairs = plain.quadrics(coefficients).into_iter().zip(turned.quadrics(coefficients));
        for (plain, turned) in pairs {
            assert!(is_near(turned, plain.map(f64::from), 1e-4));
        }
    }
}

#[test]
fn finer_tiles_have_smaller_quadrics() {
    for kind in Builtin::ALL {
        let mesh = kind.build([1.0, 1.0]).expect("a mesh");
        let plain = mesh.quadrics(QuadricCoefficients::Three);
        let tiled = mesh.tiled(Vec2::new(4.0, 2.0)).expect("factors").quadrics(QuadricCoefficients::Three);
        for ([a, b, c], tiled) in plain.into_iter().zip(tiled) {
            assert!(is_near(tiled, [a / 16.0, b / 8.0, c / 4.0].map(f64::from), 1e-5));
        }
    }
}
