use super::*;
use crate::mesh::{Builtin, Vertex, cube, cylinder, sphere, torus};
use glam::{Vec2, Vec3};
use proptest::prelude::*;
use std::collections::HashSet;

/// Finds every hit by solving `origin + t d = a + v (b - a) + w (c - a)` for every triangle by
/// Cramer's rule, which shares nothing with the sheared edge test. The second result tells whether
/// two correct methods may differ: the ray passes very near to an edge, or very flatly over the
/// triangle.
fn brute_force(mesh: &Mesh, ray: &Ray, sides: Sides) -> (Vec<SurfaceHit>, bool) {
    let (mut hits, mut doubtful) = (Vec::new(), false);
    for triangle in 0..mesh.triangles().len() as u32 {
        let [a, b, c] = mesh.corners(triangle).map(|corner| corner.position.as_dvec3());
        let (e1, e2, s) = (b - a, c - a, ray.origin - a);
        let normal = e1.cross(e2);
        let determinant = -ray.direction.dot(normal);
        let moment = s.cross(ray.direction);
        let v = e2.dot(moment) / determinant;
        let w = -e1.dot(moment) / determinant;
        let t = s.dot(normal) / determinant;
        let flat = determinant.abs() < 1e-7 * normal.length() * ray.direction.length();
        let least = v.min(w).min(1.0 - v - w);
        doubtful |= flat || least.abs() < 1e-7 || t.abs() < 1e-9;
        let front = determinant > 0.0;
        if least >= 0.0 && t >= 0.0 && (front || sides == Sides::Both) {
            hits.push(SurfaceHit { t, triangle, weights: [1.0 - v - w, v, w], front });
        }
    }
    hits.sort_by(|a, b| a.t.total_cmp(&b.t));
    (hits, doubtful)
}

fn meshes() -> Vec<Mesh> {
    Builtin::ALL.iter().map(|kind| kind.build([1.0, 1.0]).expect("a built-in")).collect()
}

/// Random triangles: overlapping, needle-like, of very different sizes.
fn soup(numbers: &[[f32; 3]]) -> Mesh {
    let vertex = |at: &[f32; 3]| Vertex {
        position: Vec3::from_array(*at),
        normal: Vec3::Y,
        tangent: Vec3::X,
        bitangent: Vec3::Z,
        uv: Vec2::ZERO,
    };
    let vertices: Vec<Vertex> = numbers.iter().map(vertex).collect();
    let triangles = (0..vertices.len() as u32 / 3).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    Mesh::new(vertices, triangles).expect("a proper mesh")
}

/// Fails if the caster's hits differ from brute force on the mesh, unless the ray is doubtful.
fn agree(caster: &RayCaster, mesh: &Mesh, ray: &Ray, sides: Sides) -> Result<(), TestCaseError> {
    let (expected, doubtful) = brute_force(mesh, ray, sides);
    if doubtful {
        return Ok(());
    }
    let found: Vec<SurfaceHit> = caster.hits(ray, sides).collect();
    prop_assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(&expected) {
        prop_assert!((found.t - expected.t).abs() < 1e-7 * (1.0 + expected.t), "{:?} {:?}", found, expected);
        prop_assert_eq!(found.front, expected.front);
        let point = mesh.interpolated(found.triangle, found.weights.map(|weight| weight as f32)).position;
        prop_assert!((point.as_dvec3() - ray.at(found.t)).length() < 1e-5);
    }
    Ok(())
}

#[test]
fn hits_on_built_in_meshes_are_those_of_brute_force() {
    // The rays go from a lattice of origins to a lattice of targets, none of them symmetric.
    for mesh in meshes() {
        let caster = RayCaster::new(&mesh);
        let mut compared = 0;
        for i in 0..600u32 {
            let phase = f64::from(i) * 0.618_033_988;
            let origin =
                DVec3::new((phase * 7.1).sin(), (phase * 3.3).cos() * 1.1, (phase * 5.7).sin()) * 1.7;
            let target = DVec3::new((phase * 2.9).cos(), (phase * 9.1).sin(), (phase * 4.3).cos()) * 0.4;
            let ray = Ray { origin, direction: target - origin };
            for sides in [Sides::Front, Sides::Both] {
                let (expected, doubtful) = brute_force(&mesh, &ray, sides);
                if doubtful {
                    continue;
                }
                compared += 1;
                let found: Vec<u32> = caster.hits(&ray, sides).map(|hit| hit.triangle).collect();
                let expected: Vec<u32> = expected.iter().map(|hit| hit.triangle).collect();
                assert_eq!(found, expected, "ray {i}, {sides:?}");
            }
        }
        assert!(compared > 1000, "only {compared} rays were compared");
    }
}

#[test]
fn hits_on_many_layers_come_in_order_each_once() {
    // Three triangles at each of 400 depths coincide. Their numbers decide the order.
    let layers = (0..1200).flat_map(|number: u32| {
        let y = ((number * 7) % 400) as f32 * -0.01;
        [[-1.0, y, 1.0], [1.0, y, 1.0], [0.0, y, -1.0]]
    });
    let mesh = soup(&layers.collect::<Vec<_>>());
    let caster = RayCaster::new(&mesh);
    let ray = Ray { origin: DVec3::new(0.05, 1.0, 0.1), direction: DVec3::new(0.0, -1.0, 0.0) };
    let found: Vec<SurfaceHit> = caster.hits(&ray, Sides::Both).collect();
    assert_eq!(found.len(), 1200);
    let mut one_by_one = None;
    for hit in &found {
        one_by_one = caster.next_hit(&ray, Sides::Both, one_by_one.as_ref());
        assert_eq!(one_by_one.as_ref(), Some(hit));
    }
    assert_eq!(caster.next_hit(&ray, Sides::Both, one_by_one.as_ref()), None);
}

#[test]
fn a_missing_or_moved_triangle_is_noticed() {
    let mesh = soup(&[
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [1.0, 0.0, 1.0],
        [0.0, 1.0, 1.0],
    ]);
    let ray = Ray { origin: DVec3::new(0.2, 0.3, 5.0), direction: DVec3::NEG_Z };
    let missing = Mesh::new(mesh.vertices().to_vec(), vec![[0, 1, 2]]).expect("a proper mesh");
    let mut vertices = mesh.vertices().to_vec();
    vertices[4].position.z += 1e-4;
    let moved = Mesh::new(vertices, mesh.triangles().to_vec()).expect("a proper mesh");
    let turned = Mesh::new(mesh.vertices().to_vec(), vec![[0, 1, 2], [3, 5, 4]]).expect("a proper mesh");
    assert!(agree(&RayCaster::new(&mesh), &mesh, &ray, Sides::Both).is_ok());
    for other in [missing, moved, turned] {
        assert!(agree(&RayCaster::new(&other), &mesh, &ray, Sides::Both).is_err());
    }
}

#[test]
fn fronts_and_backs_are_told_apart() {
    let mesh = Builtin::Cube.build([1.0, 1.0]).expect("a built-in");
    let caster = RayCaster::new(&mesh);
    let ray = Ray { origin: DVec3::new(0.1, 0.2, 3.0), direction: DVec3::NEG_Z };
    let both: Vec<(f64, bool)> = caster.hits(&ray, Sides::Both).map(|hit| (hit.t, hit.front)).collect();
    assert_eq!(both, [(2.5, true), (3.5, false)]);
    assert_eq!(caster.hits(&ray, Sides::Front).count(), 1);
    // From within, the ray hits only the back. Nothing lies behind the origin.
    let inside = Ray { origin: DVec3::new(0.1, 0.2, 0.0), ..ray };
    assert_eq!(caster.next_hit(&inside, Sides::Front, None), None);
    assert_eq!(caster.hits(&inside, Sides::Both).count(), 1);
    // A mirrored direction meets the opposite face, which is a front as well.
    let other = Ray { origin: -ray.origin, direction: DVec3::Z };
    assert!(caster.next_hit(&other, Sides::Front, None).is_some_and(|hit| hit.front && hit.t == 2.5));
}

/// Number of rays, aimed exactly at edges and corners, that pass through the mesh, and number of
/// rays aimed. From outside only edges and corners amid front faces are targets, since a ray at a
/// silhouette may miss. From inside all are.
fn leaks(mesh: &Mesh, origin: DVec3, inside: bool) -> (u32, u32) {
    let caster = RayCaster::new(mesh);
    let key = |corner: &Vertex| (corner.position + Vec3::ZERO).to_array().map(f32::to_bits);
    let mut at_back = HashSet::new();
    for triangle in 0..mesh.triangles().len() as u32 {
        let corners = mesh.corners(triangle);
        let [a, b, c] = corners.map(|corner| corner.position.as_dvec3());
        if (b - a).cross(c - a).normalize().dot((origin - a).normalize()) < 1e-6 {
            at_back.extend(corners.map(key));
        }
    }
    let (mut leaks, mut aimed) = (0, 0);
    for triangle in 0..mesh.triangles().len() as u32 {
        let corners = mesh.corners(triangle);
        if !inside && corners.iter().any(|corner| at_back.contains(&key(corner))) {
            continue;
        }
        let [a, b, c] = corners.map(|corner| corner.position.as_dvec3());
        for target in [a, (a + b) / 2.0, b + (c - b) * 0.3, c + (a - c) * 1e-9] {
            let ray = Ray { origin, direction: target - origin };
            let sides = if inside { Sides::Both } else { Sides::Front };
            leaks += u32::from(caster.next_hit(&ray, sides, None).is_none_or(|hit| hit.t > 1.0 + 1e-9));
            aimed += 1;
        }
    }
    (leaks, aimed)
}

#[test]
fn no_ray_leaks_through_an_edge_or_a_corner() {
    let meshes = [cube(7), cylinder(64, 9), sphere(100, 100), sphere(27, 19), torus(128, 64), torus(29, 27)];
    for mesh in meshes.map(|mesh| mesh.expect("divisions in range")) {
        // From the first two origins many edges are exactly in line with an axis. The last is an
        // ordinary point of view.
        let mut aimed = 0;
        for origin in [DVec3::Z * 40.0, DVec3::Y * 50.0, DVec3::new(23.1, 17.7, -19.3)] {
            let (leaks, more) = leaks(&mesh, origin, false);
            assert_eq!(leaks, 0, "from {origin}");
            aimed += more;
        }
        assert!(aimed > 400, "only {aimed} rays");
    }
    for kind in [Builtin::Cube, Builtin::Cylinder, Builtin::Sphere] {
        let mesh = kind.build([1.0, 1.0]).expect("a built-in");
        for origin in [DVec3::ZERO, DVec3::new(0.1, -0.17, 0.23)] {
            assert_eq!(leaks(&mesh, origin, true).0, 0, "{kind} from {origin}");
        }
    }
}

#[test]
fn a_leak_is_noticed() {
    let mesh = sphere(24, 12).expect("divisions in range");
    let without_one =
        Mesh::new(mesh.vertices().to_vec(), mesh.triangles()[1..].to_vec()).expect("a proper mesh");
    let origin = DVec3::new(0.1, 0.2, 0.0);
    assert_eq!(leaks(&mesh, origin, true).0, 0);
    assert!(leaks(&without_one, origin, true).0 > 0);
}

#[test]
fn every_triangle_at_a_corner_is_hit_once() {
    // The centre of a cap belongs to all of its triangles.
    let mesh = cylinder(12, 1).expect("divisions in range");
    let caster = RayCaster::new(&mesh);
    let ray = Ray { origin: DVec3::Y * 2.0, direction: DVec3::NEG_Y };
    let hits: Vec<SurfaceHit> = caster.hits(&ray, Sides::Front).collect();
    assert_eq!(hits.len(), 12);
    assert!(hits.windows(2).all(|pair| pair[0].t == 1.5 && pair[0].triangle < pair[1].triangle));
}

#[test]
fn rays_that_are_none_hit_nothing() {
    let mesh = Builtin::Cube.build([1.0, 1.0]).expect("a built-in");
    let caster = RayCaster::new(&mesh);
    let origin = DVec3::new(0.0, 0.0, 3.0);
    for ray in [
        Ray { origin, direction: DVec3::ZERO },
        Ray { origin, direction: DVec3::new(0.0, f64::NAN, -1.0) },
        Ray { origin: DVec3::INFINITY, direction: DVec3::NEG_Z },
    ] {
        assert_eq!(caster.hits(&ray, Sides::Both).count(), 0);
    }
    let empty = RayCaster::new(&Mesh::new(vec![], vec![]).expect("a mesh of nothing"));
    assert_eq!(empty.next_hit(&Ray { origin, direction: DVec3::NEG_Z }, Sides::Both, None), None);
}

#[test]
fn deep_hierarchies_are_walked_too() {
    // Triangles whose positions and sizes double each time pair up into a chain instead of a tree.
    let mut numbers = Vec::new();
    for i in 0..120 {
        let at = 2f32.powi(i - 60);
        numbers.extend([[at, -at, 0.0], [at * 1.2, -at, at], [at, at, at]]);
    }
    let mesh = soup(&numbers);
    let caster = RayCaster::new(&mesh);
    assert!(caster.depth > STACK_DEPTH, "depth {}", caster.depth);
    let ray = Ray { origin: DVec3::ZERO, direction: DVec3::new(1.06, -0.33, 0.66) };
    let found: Vec<SurfaceHit> = caster.hits(&ray, Sides::Both).collect();
    assert_eq!((found.len(), brute_force(&mesh, &ray, Sides::Both).0.len()), (120, 120));
}

#[test]
fn extreme_coordinates_are_survived() {
    let far = f32::MAX;
    let mesh =
        soup(&[[far, 0.0, 0.0], [0.0, far, 0.0], [0.0, 0.0, -far], [1e-45, 0.0, 0.0], [0.0; 3], [0.0; 3]]);
    let caster = RayCaster::new(&mesh);
    // The ray aims at the middle of the vast triangle with a direction far too short for f32.
    let ray = Ray { origin: DVec3::ZERO, direction: DVec3::new(1.0, 1.0, -1.0) * 1e-200 };
    let hit = caster.next_hit(&ray, Sides::Both, None).expect("a hit");
    assert!(
        ray.at(hit.t).distance(DVec3::new(1.0, 1.0, -1.0) * f64::from(far) / 3.0) < 1e-6 * f64::from(far)
    );
    for direction in [DVec3::splat(1e308), DVec3::splat(5e-324), DVec3::new(1e308, 1e-308, 0.0)] {
        assert!(caster.hits(&Ray { origin: DVec3::splat(1e300), direction }, Sides::Both).count() <= 2);
    }
}

#[test]
fn casters_are_shared_between_threads() {
    fn shared<T: Send + Sync>() {}
    shared::<RayCaster>();
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn hits_in_a_triangle_soup_are_those_of_brute_force(
        numbers in prop::collection::vec(prop::array::uniform3(-1.0f32..1.0), 3..300),
        origin in prop::array::uniform3(-2.0..2.0),
        target in prop::array::uniform3(-0.7..0.7),
        back in any::<bool>(),
    ) {
        let ray = Ray { origin: DVec3::from(origin), direction: DVec3::from(target) - DVec3::from(origin) };
        let mesh = soup(&numbers);
        agree(&RayCaster::new(&mesh), &mesh, &ray, if back { Sides::Both } else { Sides::Front })?;
    }

    #[test]
    fn rays_along_the_axes_agree_too(
        numbers in prop::collection::vec(prop::array::uniform3(-1.0f32..1.0), 3..300),
        origin in prop::array::uniform3(-1.0..1.0),
        axis in 0usize..3,
        backward in any::<bool>(),
    ) {
        let direction = DVec3::AXES[axis] * if backward { -1.0 } else { 1.0 };
        let mesh = soup(&numbers);
        agree(&RayCaster::new(&mesh), &mesh, &Ray { origin: DVec3::from(origin), direction }, Sides::Both)?;
    }
}
