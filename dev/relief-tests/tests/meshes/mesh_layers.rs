//! Heights between two meshes where there are several layers, holes, borders of charts, or nothing to look
//! at.

use glam::{Vec2, Vec3};
use relief_bake::from_meshes::{FromMeshesError, Layer, MeshPair, PairedHeights, heights_from_meshes};
use relief_core::mesh::{BasePoint, Mesh, Vertex, cube};
use relief_core::raycast::RayCaster;
use relief_core::{Watch, Wrap};

fn found(low: &Mesh, high: &RayCaster, pair: &MeshPair) -> PairedHeights {
    heights_from_meshes(low, high, pair, &Watch::none()).expect("heights")
}

/// Flat triangles at a height over the plane, with texture coordinates and straight normals.
fn flat(points: &[[f32; 3]], uvs: &[[f32; 2]], triangles: &[[u32; 3]]) -> Mesh {
    let vertex = |(point, uv): (&[f32; 3], &[f32; 2])| Vertex {
        position: Vec3::from(*point),
        normal: Vec3::Y,
        tangent: Vec3::X,
        bitangent: Vec3::Z,
        uv: Vec2::from(*uv),
    };
    Mesh::new(points.iter().zip(uvs).map(vertex).collect(), triangles.to_vec()).expect("a mesh")
}

/// A rectangle of two triangles that look up, and with its corners the other way round down.
fn sheet(side: [f32; 2], height: impl Fn(f32, f32) -> f32, is_up: bool) -> Mesh {
    let points = [[-1.0f32, -1.0], [-1.0, 1.0], [1.0, 1.0], [1.0, -1.0]]
        .map(|[x, z]| [x * side[0], height(x * side[0], z * side[1]), z * side[1]]);
    let triangles = if is_up { [[0, 1, 2], [0, 2, 3]] } else { [[0, 2, 1], [0, 3, 2]] };
    flat(&points, &[[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]], &triangles)
}

/// All triangles of several meshes.
fn together(meshes: &[Mesh]) -> RayCaster {
    RayCaster::of_corners(meshes.iter().flat_map(|mesh| {
        (0..mesh.triangles().len() as u32)
            .map(|triangle| mesh.corners(triangle).map(|corner| corner.position))
    }))
}

#[test]
fn the_surface_is_right_up_to_the_border_of_a_chart() {
    // Two charts that lie askew, with other parts of the map between them. Heights rise in a straight line,
    // so that interpolation is exact.
    let points = [[-1.0, 0.0, -1.0], [-1.0, 0.0, 1.0], [1.0, 0.0, 1.0], [1.0, 0.0, -1.0]];
    let uvs = [[0.13, 0.11], [0.08, 0.83], [0.42, 0.89], [0.47, 0.17]];
    let far = points.map(|[x, y, z]: [f32; 3]| [x + 2.0, y, z]);
    let far_uvs = uvs.map(|[u, v]: [f32; 2]| [0.97 - 0.8 * u, v + 0.04]);
    let low = flat(
        &[points, far].concat(),
        &[uvs, far_uvs].concat(),
        &[[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]],
    );
    let slope = |x: f32, z: f32| 0.05 + 0.1 * x - 0.07 * z;
    let high = together(&[sheet([4.0, 2.0], slope, true)]);
    let mut last_without = 0;
    for gutter in [None, Some(3), Some(0)] {
        let pair = MeshPair { gutter, ..MeshPair::new([40, 36]) };
        let heights = found(&low, &high, &pair);
        assert_eq!((heights.holes, heights.overlaps), (0, 0));
        assert!(heights.without_value > last_without || gutter.is_none());
        last_without = heights.without_value;
        let texel = |i: i64, j: i64| {
            let at = Wrap::Repeat.index(j, 36) as usize * 40 + Wrap::Repeat.index(i, 40) as usize;
            f64::from(heights.metres[at])
        };
        let (mut most, mut places) = (0.0f64, 0);
        for triangle in 0..4 {
            let corners = low.corners(triangle).map(BasePoint::from);
            for i in 0..=60 {
                for j in 0..=60 - i {
                    let [wb, wc] = [i, j].map(|k| f64::from(k) / 60.0);
                    let base = BasePoint::weighted(corners, [1.0 - wb - wc, wb, wc]);
                    let [x, y] = [base.uv.x * 40.0 - 0.5, base.uv.y * 36.0 - 0.5];
                    let (i, j) = (x.floor() as i64, y.floor() as i64);
                    let [fx, fy] = [x - x.floor(), y - y.floor()];
                    let row = |j: i64| (1.0 - fx) * texel(i, j) + fx * texel(i + 1, j);
                    let metres = (1.0 - fy) * row(j) + fy * row(j + 1);
                    let exact = slope(base.position.x as f32, base.position.z as f32);
                    most = most.max((metres - f64::from(exact)).abs());
                    places += 1;
                }
            }
        }
        println!("{gutter:?}: {most:.1e} m at {places} places, {} without", heights.without_value);
        // A texel is worth 0.01 m here. NaN is never at most anything.
        assert!(most < 2e-6 && places > 7000, "{gutter:?}: {most}");
    }
}

#[test]
fn of_several_layers_the_right_one_is_taken() {
    let low = sheet([1.0, 1.0], |_, _| 0.0, true);
    let at = |height: f32, is_up: bool| sheet([2.0, 2.0], move |_, _| height, is_up);
    // A thin plate whose back is nearer, and a strap above it; all far within the cage.
    let plate = [at(0.03, true), at(0.01, false)];
    let strap = [at(0.08, true), at(0.06, false)];
    let high = together(&[plate.as_slice(), strap.as_slice()].concat());
    let pair = MeshPair { cage_m: Some(0.2), ..MeshPair::new([8, 8]) };
    let height = |high: &RayCaster, pair: &MeshPair| {
        let heights = found(&low, high, pair);
        assert_eq!((heights.covered, heights.holes), (64, 0));
        assert!(heights.range_m[0] == heights.range_m[1]);
        heights.range_m[0]
    };
    let is = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-8, "{found} {expected}");
    is(height(&high, &pair), 0.03);
    is(height(&high, &MeshPair { layer: Layer::Outermost, ..pair }), 0.08);
    is(height(&high, &MeshPair { layer: Layer::Outermost, cage_m: Some(0.05), ..pair }), 0.03);
    is(height(&high, &MeshPair { two_sided: true, ..pair }), 0.01);
    // Inward too, and the nearer of both ways.
    let below = [at(-0.02, true), at(-0.04, false)];
    is(height(&together(&below), &pair), -0.02);
    is(height(&together(&below), &MeshPair { layer: Layer::Outermost, ..pair }), -0.02);
    is(height(&together(&[at(0.05, true), at(-0.02, true)]), &pair), -0.02);
    is(height(&together(&[at(0.05, true), at(-0.06, true)]), &pair), 0.05);
    // Only backs.
    let look =
        |pair: &MeshPair| heights_from_meshes(&low, &together(&[at(0.02, false)]), pair, &Watch::none());
    let error = look(&pair).expect_err("a back");
    assert!(matches!(error, FromMeshesError::NothingFound { texels: 64, behind: 64, .. }), "{error:?}");
    assert!(look(&MeshPair { two_sided: true, ..pair }).is_ok());
    let error = look(&MeshPair { cage_m: Some(0.01), ..pair }).expect_err("beyond the cage");
    assert!(matches!(error, FromMeshesError::NothingFound { behind: 0, .. }), "{error:?}");
}

#[test]
fn holes_are_counted_and_filled() {
    let low = sheet([1.0, 1.0], |_, _| 0.0, true);
    // The detailed mesh ends in the middle, where its back lies a little farther.
    let half = sheet([1.0, 1.0], |x, _| 0.05 + 0.02 * x, true);
    let half = laid_at(&half, |p| Vec3::new(0.5 * p.x - 0.5, p.y, 1.2 * p.z));
    let back = laid_at(&sheet([0.25, 1.2], |_, _| -0.03, false), |p| p + Vec3::X * 0.75);
    let high = together(&[half, back]);
    let pair = MeshPair { wrap: Wrap::Clamp, ..MeshPair::new([32, 16]) };
    let heights = found(&low, &high, &pair);
    assert_eq!((heights.covered, heights.holes, heights.behind), (512, 256, 128));
    let [least, greatest] = heights.range_m;
    assert!(heights.metres.iter().all(|m| (least - 1e-6..=greatest + 1e-6).contains(&f64::from(*m))));
    assert!(least > 0.02 && greatest < 0.08 && heights.mean_abs_m > least);
}

/// The same mesh with other positions.
fn laid_at(mesh: &Mesh, at: impl Fn(Vec3) -> Vec3) -> Mesh {
    let moved = |vertex: &Vertex| Vertex { position: at(vertex.position), ..*vertex };
    Mesh::new(mesh.vertices().iter().map(moved).collect(), mesh.triangles().to_vec()).expect("a mesh")
}

#[test]
fn triangles_without_an_area_are_no_trouble() {
    let points = [[-1.0, 0.0, -1.0], [-1.0, 0.0, 1.0], [1.0, 0.0, 1.0], [1.0, 0.0, -1.0], [1.0, 0.0, 1.0]];
    let uvs = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.5, 0.5]];
    // One is a line in the texture, one a point in space, and one both.
    let triangles = [[0, 2, 4], [2, 4, 3], [1, 1, 2], [0, 1, 2], [0, 2, 3]];
    let low = flat(&points, &uvs, &triangles);
    let high = together(&[sheet([1.0, 1.0], |_, _| 0.01, true)]);
    let heights = found(&low, &high, &MeshPair::new([9, 9]));
    assert_eq!((heights.covered, heights.without_area), (81, 2));
    // A base whose normals vanish has no line to look along.
    let mut vertices = low.vertices().to_vec();
    vertices.iter_mut().for_each(|vertex| vertex.normal = Vec3::ZERO);
    let without = Mesh::new(vertices, triangles.to_vec()).expect("a mesh");
    let error = heights_from_meshes(&without, &high, &MeshPair::new([9, 9]), &Watch::none());
    assert!(matches!(error, Err(FromMeshesError::NothingFound { .. })), "{error:?}");
}

#[test]
fn a_cube_whose_sides_share_the_map_is_told_of() {
    let low = cube(1).expect("a mesh");
    let high = RayCaster::new(&laid_at(&low, |p| 1.1 * p));
    let heights = found(&low, &high, &MeshPair::new([16, 16]));
    // Those on the diagonal lie at the borders of all triangles.
    assert_eq!((heights.covered, heights.overlaps, heights.holes), (256, 256 - 16, 0));
    assert!(heights.metres.iter().all(|metres| (metres - 0.05).abs() < 1e-7));
}
