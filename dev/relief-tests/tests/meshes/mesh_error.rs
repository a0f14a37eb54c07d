//! Meshes that are made to an error: no point of the relief is farther from them than they say, they have no
//! crack, and the comparator that says so notices a vertex out of its place.

use std::collections::HashMap;

use glam::{DVec2, Vec2, Vec3};
use rayon::ThreadPoolBuilder;
use relief_core::mesh::{Mesh, rectangle, torus};
use relief_core::{HeightMap, Watch, Wrap};
use relief_mesh::{
    Certificate, CrackTest, Fit, Judge, MeshSettings, Mesher, MesherError, Part, Shading, Side,
};
use relief_testing::maps;

/// Metres of displacement between heights 0 and 1.
const SCALE_M: f64 = 0.08;

/// The displacement of height 0.
const BIAS_M: f64 = -0.03;

/// What stored positions may be wrong by, as a part of the scale.
const ROUNDING: f64 = 1e-6;

fn displaced(map: &HeightMap) -> HeightMap {
    map.clone().with_displacement(SCALE_M, BIAS_M).expect("lengths")
}

fn plane() -> Mesh {
    rectangle([1.0, 1.0], 1).expect("a mesh")
}

fn made(map: &HeightMap, settings: &MeshSettings) -> (Mesh, Certificate) {
    let mesher = Mesher::new(&plane(), map, settings).expect("a mesh");
    (mesher.mesh().expect("finite"), *mesher.certificate().expect("made to an error"))
}

/// A triangle as the comparator sees it: places in texels, on the lattice that they were made on, and heights
/// in metres.
type Piece = [(DVec2, f64); 3];

fn pieces(map: &HeightMap, mesh: &Mesh) -> Vec<Piece> {
    let sides = DVec2::new(f64::from(map.width()), f64::from(map.height()));
    let corner = |at: u32| {
        let vertex = &mesh.vertices()[at as usize];
        // Texture coordinates of f32 are rounded, places on the lattice are not.
        let place = (vertex.uv.as_dvec2() * sides * 16.0).round() / 16.0;
        (place, f64::from(vertex.position.y))
    };
    mesh.triangles().iter().map(|corners| corners.map(corner)).collect()
}

/// How far the relief lies above a piece at a place, if the place is in the piece.
fn gap(map: &HeightMap, [(a, za), (b, zb), (c, zc)]: Piece, at: DVec2) -> Option<f64> {
    let area = (b - a).perp_dot(c - a);
    let [of_b, of_c] = [(at - a).perp_dot(c - a) / area, (b - a).perp_dot(at - a) / area];
    let of_a = 1.0 - of_b - of_c;
    if of_a.min(of_b).min(of_c) < -1e-9 {
        return None;
    }
    let relief = map.displacement_m(map.height_at_place(at.x - 0.5, at.y - 0.5));
    Some(relief - (of_a * za + of_b * zb + of_c * zc))
}

/// The farthest that samples of the relief are from the mesh, `per_texel`² to a texel, and how many of them
/// some triangle covers.
fn farthest(map: &HeightMap, pieces: &[Piece], per_texel: u32) -> (f64, usize) {
    let n = f64::from(per_texel);
    let columns = (map.width() * per_texel) as usize;
    let mut is_covered = vec![false; columns * (map.height() * per_texel) as usize];
    let mut farthest = 0.0_f64;
    for piece in pieces {
        let places = piece.map(|(place, _)| place * n);
        let [low, high] =
            [places[0].min(places[1]).min(places[2]).ceil(), places[0].max(places[1]).max(places[2]).floor()];
        for j in low.y as usize..=high.y as usize {
            for i in low.x as usize..=high.x as usize {
                let found = gap(map, *piece, DVec2::new(i as f64, j as f64) / n);
                farthest = found.map_or(farthest, |gap| farthest.max(gap.abs()));
                if let (Some(_), Some(covered)) = (found, is_covered.get_mut(j * columns + i)) {
                    *covered |= i < columns;
                }
            }
        }
    }
    (farthest, is_covered.into_iter().filter(|covered| *covered).count())
}

/// The farthest at the middle of a piece and of its edges.
fn at_a_few(map: &HeightMap, piece: Piece) -> f64 {
    let [a, b, c] = piece.map(|(place, _)| place);
    let places = [(a + b + c) / 3.0, (a + b) / 2.0, (b + c) / 2.0, (c + a) / 2.0];
    places.into_iter().filter_map(|at| gap(map, piece, at)).fold(0.0, |most, gap| most.max(gap.abs()))
}

/// The farthest at 64² places around some piece.
fn farthest_in(map: &HeightMap, piece: Piece) -> f64 {
    let places = piece.map(|(place, _)| place);
    let low = places[0].min(places[1]).min(places[2]);
    let size = places[0].max(places[1]).max(places[2]) - low;
    let at = |k: u32| low + size * DVec2::new(f64::from(k % 64), f64::from(k / 64)) / 63.0;
    (0..64 * 64).filter_map(|k| gap(map, piece, at(k))).fold(0.0, |most, gap| most.max(gap.abs()))
}

#[test]
fn no_sample_is_farther_than_the_mesh_says() {
    let mut turn = 0;
    // Of the two white noises the smaller one shows as much.
    for named in maps::ALL.iter().filter(|named| named.name != "white noise 128x128") {
        for wrap in Wrap::ALL {
            let map = displaced(&named.build(wrap));
            for fit in Fit::ALL {
                let error_m = [0.02, 0.05][turn % 2] * SCALE_M;
                turn += 1;
                let settings = MeshSettings { fit: *fit, ..MeshSettings::within(error_m) };
                let (mesh, certificate) = made(&map, &settings);
                let about = format!("{}, {wrap}, {fit}: {certificate:?}", named.name);
                assert!(certificate.error_m <= error_m, "{about}");
                let pieces = pieces(&map, &mesh);
                // At the stated place the error is the stated one.
                let uv = DVec2::from(certificate.uv);
                let place = uv * DVec2::new(f64::from(map.width()), f64::from(map.height()));
                let there = pieces.iter().filter_map(|piece| gap(&map, *piece, place));
                let there = there.fold(0.0_f64, |most, gap| most.max(gap.abs()));
                assert!((there - certificate.error_m).abs() <= ROUNDING * SCALE_M, "{about}: {there}");
                // And nowhere more, with every sample under some triangle.
                let (found, covered) = farthest(&map, &pieces, 8);
                assert!(found <= certificate.error_m + ROUNDING * SCALE_M, "{about}: {found}");
                assert_eq!(covered as u32, map.width() * map.height() * 64, "{about}");
                let mut worst: Vec<(f64, Piece)> =
                    pieces.iter().map(|piece| (at_a_few(&map, *piece), *piece)).collect();
                worst.sort_by(|(a, _), (b, _)| b.total_cmp(a));
                for (_, piece) in worst.into_iter().take(100) {
                    let found = farthest_in(&map, piece);
                    assert!(found <= certificate.error_m + ROUNDING * SCALE_M, "{about}: {found}");
                }
            }
        }
    }
}

#[test]
fn nothing_sinks_into_a_mesh_above_the_relief() {
    for named in ["natural 101x67", "single spike 33x31", "steps 61x40", "constant half 16x9"] {
        let named = maps::ALL.iter().find(|map| map.name == named).expect("a map");
        let map = displaced(&named.build(Wrap::Mirror));
        let error_m = 0.03 * SCALE_M;
        for side in [Side::Above, Side::Below] {
            let (mesh, certificate) = made(&map, &MeshSettings { side, ..MeshSettings::within(error_m) });
            let about = format!("{}, {side}: {certificate:?}", named.name);
            assert!(certificate.error_m <= error_m && certificate.mean_m <= certificate.error_m, "{about}");
            let sign = if side == Side::Above { -1.0 } else { 1.0 };
            let pieces = pieces(&map, &mesh);
            let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
            for piece in &pieces {
                let [a, b, c] = piece.map(|(place, _)| place);
                for k in 0..=64 {
                    let (i, j) = (f64::from(k % 8) / 8.0, f64::from(k / 8) / 8.0);
                    let at = a + (b - a) * i + (c - a) * (j * (1.0 - i));
                    let distance = gap(&map, *piece, at).map(|gap| gap * sign);
                    least = distance.map_or(least, |distance| least.min(distance));
                    most = distance.map_or(most, |distance| most.max(distance));
                }
            }
            assert!(least >= -ROUNDING * SCALE_M, "{about}: {least}");
            assert!(most <= certificate.error_m + ROUNDING * SCALE_M, "{about}: {most}");
            let there = DVec2::from(certificate.uv) * DVec2::new(map.width().into(), map.height().into());
            let there = pieces.iter().filter_map(|piece| gap(&map, *piece, there));
            let there = there.fold(0.0_f64, |most, gap| most.max(gap * sign));
            assert!((there - certificate.error_m).abs() <= ROUNDING * SCALE_M, "{about}: {there}");
        }
    }
}

#[test]
fn a_vertex_out_of_its_place_is_noticed() {
    let natural = maps::ALL.iter().find(|named| named.name == "natural 101x67").expect("a map");
    let map = displaced(&natural.build(Wrap::Repeat));
    let error_m = 0.02 * SCALE_M;
    let settings = MeshSettings { fit: Fit::None, ..MeshSettings::within(error_m) };
    let (mesh, certificate) = made(&map, &settings);
    for number in [0, mesh.vertices().len() / 2, mesh.vertices().len() - 1] {
        let mut vertices = mesh.vertices().to_vec();
        vertices[number].position.y += (2.0 * error_m) as f32;
        let raised = Mesh::new(vertices, mesh.triangles().to_vec()).expect("a mesh");
        // As finely as vertices may lie.
        let found = farthest(&map, &pieces(&map, &raised), 16).0;
        assert!(found > certificate.error_m + ROUNDING * SCALE_M, "{number}: {found}");
    }
}

#[test]
fn judged_at_texels_the_error_holds_there_and_not_between() {
    let mut is_farther_between = false;
    for named in maps::ALL {
        let map = displaced(&named.build(Wrap::Clamp));
        let error_m = 0.02 * SCALE_M;
        let settings = MeshSettings { judge: Judge::Texels, ..MeshSettings::within(error_m) };
        let (mesh, certificate) = made(&map, &settings);
        let pieces = pieces(&map, &mesh);
        let (mut most, mut sum) = (0.0_f64, 0.0);
        for j in 0..map.height() {
            for i in 0..map.width() {
                let centre = DVec2::new(f64::from(i) + 0.5, f64::from(j) + 0.5);
                let gaps = pieces.iter().filter_map(|piece| gap(&map, *piece, centre));
                let gap = gaps.map(f64::abs).fold(0.0, f64::max);
                most = most.max(gap);
                sum += gap;
            }
        }
        assert!(most <= certificate.error_m + ROUNDING * SCALE_M, "{}: {most} {certificate:?}", named.name);
        assert!((most - certificate.error_m).abs() <= ROUNDING * SCALE_M, "{}", named.name);
        let mean = sum / f64::from(map.width() * map.height());
        assert!((mean - certificate.mean_m).abs() <= 0.02 * error_m + ROUNDING * SCALE_M, "{}", named.name);
        is_farther_between |= farthest(&map, &pieces, 4).0 > 1.2 * error_m;
    }
    assert!(is_farther_between, "no map is twisted: this test shows nothing");
}

/// Edges that have no opposite, by the bits of their ends.
fn open_edges(triangles: &[[Vec3; 3]]) -> Vec<[Vec3; 2]> {
    let mut edges: HashMap<[[u32; 3]; 2], ([Vec3; 2], i32)> = HashMap::new();
    for corners in triangles {
        for k in 0..3 {
            let ends = [corners[k], corners[(k + 1) % 3]];
            let bits = ends.map(|end| end.to_array().map(f32::to_bits));
            let (key, sign) = if bits[0] < bits[1] { (bits, 1) } else { ([bits[1], bits[0]], -1) };
            edges.entry(key).or_insert((ends, 0)).1 += sign;
        }
    }
    edges.into_values().filter(|(_, sum)| *sum != 0).map(|(ends, _)| ends).collect()
}

fn triangles(mesh: &Mesh) -> Vec<[Vec3; 3]> {
    let position = |corner: u32| mesh.vertices()[corner as usize].position;
    mesh.triangles().iter().map(|corners| corners.map(position)).collect()
}

/// Whether an edge lies on the border of the unit plane.
fn is_on_border([a, b]: [Vec3; 2]) -> bool {
    [0, 2].into_iter().any(|axis| a[axis].abs() == 0.5 && a[axis] == b[axis])
}

#[test]
fn planes_have_no_crack_but_their_border_and_their_parts_meet() {
    let steep = HeightMap::from_fn(300, 131, Wrap::Repeat, |i, j| {
        (0.5 + 0.3 * (i as f32 * 0.11).sin() * (j as f32 * 0.23).cos()).fract()
    });
    let map = displaced(&steep.expect("a map"));
    for tiles in [[1.0, 1.0], [1.37, 0.61], [2.000_03, 1.0], [0.004, 0.003], [0.25, 1.5]] {
        let base = plane().tiled(Vec2::from(tiles)).expect("tiled");
        let settings = MeshSettings::within(0.01 * SCALE_M);
        let whole = Mesher::new(&base, &map, &settings).expect("a mesh").mesh().expect("finite");
        for mesh in [triangles(&whole), parts(&base, &map, &settings, [3, 2])] {
            let open = open_edges(&mesh);
            assert!(open.iter().all(|edge| is_on_border(*edge)), "{tiles:?}: {open:?}");
            let area: f32 =
                mesh.iter().map(|[a, b, c]| 0.5 * (b - a).with_y(0.0).cross((c - a).with_y(0.0)).y).sum();
            assert!((area - 1.0).abs() < 1e-3, "{tiles:?}: {area}");
        }
        let folded = triangles(&whole).iter().filter(|[a, b, c]| (b - a).cross(c - a).y < -1e-9).count();
        assert_eq!(folded, 0, "{tiles:?}");
    }
}

/// The triangles of all parts; none where they are too small to be cut.
fn parts(base: &Mesh, map: &HeightMap, settings: &MeshSettings, of: [u32; 2]) -> Vec<[Vec3; 3]> {
    let part = |at: [u32; 2]| {
        let settings = MeshSettings { part: Part { of, at }, ..*settings };
        match Mesher::new(base, map, &settings) {
            Ok(mesher) => triangles(&mesher.mesh().expect("finite")),
            Err(MesherError::TooManyParts { .. }) if at == [0, 0] => triangles(
                &Mesher::new(base, map, &MeshSettings { part: Part::WHOLE, ..settings })
                    .expect("whole")
                    .mesh()
                    .expect("finite"),
            ),
            Err(MesherError::TooManyParts { .. }) => Vec::new(),
            Err(error) => panic!("{error}"),
        }
    };
    (0..of[0] * of[1]).flat_map(|number| part([number % of[0], number / of[0]])).collect()
}

#[test]
fn parts_of_a_grid_meet_too() {
    let map = displaced(&maps::ALL[0].build(Wrap::Repeat));
    for texels in [1, 3] {
        let settings = MeshSettings { texels, ..MeshSettings::default() };
        let open = open_edges(&parts(&plane(), &map, &settings, [2, 3]));
        assert!(open.iter().all(|edge| is_on_border(*edge)), "{texels}: {open:?}");
    }
}

#[test]
fn solids_are_closed_and_as_thick_as_they_say() {
    let map = displaced(&maps::ALL[0].build(Wrap::Repeat));
    for (tiles, mirrored) in [([1.0, 1.0], false), ([1.37, 0.61], false), ([1.0, 1.0], true)] {
        let mut base = plane().tiled(Vec2::from(tiles)).expect("tiled");
        if mirrored {
            let mut vertices = base.vertices().to_vec();
            vertices.iter_mut().for_each(|vertex| vertex.uv.x = 1.0 - vertex.uv.x);
            base = Mesh::new(vertices, base.triangles().to_vec()).expect("a mesh");
        }
        let within = MeshSettings::within(0.05 * SCALE_M);
        for settings in [within, MeshSettings { texels: 2, ..MeshSettings::default() }] {
            for part in [Part::WHOLE, Part { of: [2, 1], at: [1, 0] }] {
                let settings = MeshSettings { solid_m: Some(0.01), part, ..settings };
                let mesher = Mesher::new(&base, &map, &settings).expect("a mesh");
                let mesh = mesher.mesh().expect("finite");
                let about = format!("{tiles:?} {mirrored} {}", settings.edges.name);
                assert_eq!(mesh.vertices().len() as u64, mesher.vertices());
                assert_eq!(mesh.triangles().len() as u64, mesher.triangles());
                let cracks = CrackTest::of_mesh(&mesh);
                assert!(cracks.is_closed() && cracks.pieces == 1, "{about}: {cracks:?}");
                // As much as lies between the relief and the bottom, and the right way round.
                let volume: f64 = triangles(&mesh)
                    .iter()
                    .map(|[a, b, c]| a.as_dvec3().dot(b.as_dvec3().cross(c.as_dvec3())) / 6.0)
                    .sum();
                let bottom = mesh.vertices().iter().map(|vertex| vertex.position.y).fold(f32::MAX, f32::min);
                let [low, _] = map.extremes().map(|height| map.displacement_m(f64::from(height)));
                let thick = low - f64::from(bottom);
                let asked = 0.01 - 1e-6..0.01 + 0.05 * SCALE_M + 1e-6;
                assert!(asked.contains(&thick), "{about}: {thick}");
                let mean = map.displacement_m(f64::from(map.mean())) - f64::from(bottom);
                let area = if part == Part::WHOLE { 1.0 } else { 0.5 };
                assert!((volume - mean * area).abs() < 0.15 * mean * area, "{about}: {volume} {mean}");
                for (corners, vertices) in triangles(&mesh).iter().zip(mesh.triangles()) {
                    let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
                    let walls = vertices.map(|at| mesh.vertices()[at as usize].normal);
                    let is_face = walls[0] == walls[1] && walls[1] == walls[2] && walls[0].y.abs() != 1.0;
                    assert!(!is_face || normal.dot(walls[0]) >= 0.0, "{about}: {corners:?}");
                }
            }
        }
    }
    let ring = torus(16, 8).expect("a mesh");
    let solid = |solid_m: f64| MeshSettings { solid_m: Some(solid_m), ..MeshSettings::default() };
    let refused = |base: &Mesh, settings| Mesher::new(base, &map, &settings).expect_err("refused");
    assert!(matches!(refused(&ring, solid(0.01)), MesherError::SolidOfClosed));
    for solid_m in [0.0, -1.0, f64::NAN] {
        assert!(matches!(refused(&plane(), solid(solid_m)), MesherError::BadSolid { .. }));
    }
}

#[test]
fn smooth_relief_needs_few_triangles_and_a_fit_fewer() {
    let level = displaced(&HeightMap::from_fn(200, 90, Wrap::Clamp, |_, _| 0.25).expect("a map"));
    let (mesh, certificate) = made(&level, &MeshSettings::within(1e-4 * SCALE_M));
    // Two for each tile.
    assert_eq!((mesh.triangles().len(), certificate.error_m), (4, 0.0));
    let hills = |i: u32, j: u32| 0.5 + 0.25 * (i as f32 * 0.07).sin() + 0.25 * (j as f32 * 0.05).cos();
    let map = displaced(&HeightMap::from_fn(160, 120, Wrap::Clamp, hills).expect("a map"));
    let count = |fit: Fit| {
        made(&map, &MeshSettings { fit, ..MeshSettings::within(0.002 * SCALE_M) }).0.triangles().len()
    };
    let [fitted, plain] = [Fit::Heights, Fit::None].map(count);
    assert!(fitted * 10 < plain * 9, "{fitted} {plain}");
    assert!(plain < 160 * 120 / 4, "{plain}");
}

#[test]
fn so_many_triangles_are_used_and_no_more() {
    let natural = maps::ALL.iter().find(|named| named.name == "natural 101x67").expect("a map");
    let map = displaced(&natural.build(Wrap::Clamp));
    let settings = MeshSettings::within(f64::NAN);
    let mut before = f64::INFINITY;
    for most in [300, 1000, 4000] {
        let mesher = Mesher::with_at_most(&plane(), &map, &settings, most, &Watch::none()).expect("a mesh");
        let error_m = mesher.certificate().expect("made to an error").error_m;
        assert!(
            mesher.triangles() <= most && mesher.triangles() * 10 >= most * 9,
            "{most}: {}",
            mesher.triangles()
        );
        assert!(error_m < before);
        before = error_m;
    }
    let none = Mesher::with_at_most(&plane(), &map, &settings, 1, &Watch::none());
    assert!(matches!(none, Err(MesherError::MoreThan { most: 1 })));
}

#[test]
fn the_same_bits_whatever_the_number_of_threads() {
    let map = displaced(
        &HeightMap::from_fn(260, 270, Wrap::Repeat, |i, j| ((i * j) % 17) as f32 / 16.0).expect("a map"),
    );
    let settings = MeshSettings { shading: Shading::Mesh, ..MeshSettings::within(0.2 * SCALE_M) };
    let with = |threads: usize| {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| made(&map, &settings))
    };
    let (alone, certificate) = with(1);
    let (together, same) = with(4);
    assert_eq!(alone.triangles(), together.triangles());
    assert_eq!(triangles(&alone), triangles(&together));
    assert_eq!(certificate, same);
}

#[test]
fn what_cannot_be_made_is_refused() {
    let map = displaced(&maps::ALL[0].build(Wrap::Repeat));
    let refused =
        |base: &Mesh, settings: MeshSettings| Mesher::new(base, &map, &settings).expect_err("refused");
    for error_m in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = refused(&plane(), MeshSettings::within(error_m));
        assert!(matches!(error, MesherError::BadTolerance { .. }), "{error}");
    }
    let fine = refused(&plane(), MeshSettings::within(1e-9 * SCALE_M));
    let MesherError::TooFine { least_m, .. } = fine else { panic!("{fine}") };
    assert!(least_m > 1e-9 * SCALE_M && least_m < 0.1 * SCALE_M);
    let ring = torus(16, 8).expect("a mesh");
    let within = MeshSettings::within(0.01);
    let part = |of: [u32; 2], at: [u32; 2]| MeshSettings { part: Part { of, at }, ..within };
    assert!(matches!(refused(&plane(), part([2, 2], [2, 0])), MesherError::NoPart { .. }));
    assert!(matches!(refused(&plane(), part([4000, 1], [0, 0])), MesherError::TooManyParts { .. }));
    let parted = MeshSettings { part: Part { of: [2, 1], at: [0, 0] }, ..MeshSettings::default() };
    assert!(matches!(refused(&ring, parted), MesherError::PartOfNoPlane));
    let held = MeshSettings { max_bytes: 1000, ..within };
    assert!(matches!(refused(&plane(), held), MesherError::NoMemory { limit: 1000 }));
}
