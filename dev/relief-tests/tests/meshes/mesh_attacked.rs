//! Meshes to an error over random bases: slivers, sheared and huge textures, normals that turn far, on maps
//! of all kinds, smooth or flat, on one side or both, with holes and without. What cannot be made is refused;
//! what is made keeps what it says.

use glam::{DVec3, Vec2, Vec3};
use rayon::prelude::*;
use relief_core::mesh::{BasePoint, Mesh, Vertex};
use relief_core::rng::Rng;
use relief_core::{HeightMap, TexelMask, Wrap};
use relief_mesh::{
    BaseSurface, CrackTest, Directions, Fit, Judge, MeshSettings, Mesher, MesherError, Seams, Side,
};
use relief_testing::smooth_base::{curved_point, lift_m};

/// How many bases are made. Twenty thousand were, once.
const ROUNDS: u64 = 800;

/// A map, with holes or without.
fn map(rng: &mut Rng) -> HeightMap {
    let size = [rng.pick(&[1, 2, 5, 16, 33]), rng.pick(&[1, 3, 8, 21])];
    let kind = rng.pick(&[0, 1, 2, 3]);
    let seed = rng.unit();
    let texel = |i: u32, j: u32| match kind {
        0 => (f64::from(i * 73 + j * 191) * (0.618 + seed)).fract() as f32,
        1 => 0.5 + 0.4 * (f64::from(i) * 0.7 + f64::from(j) * 0.4 + seed).sin() as f32,
        2 => f32::from(i == size[0] / 2 && j == size[1] / 2),
        _ => 0.25,
    };
    let map = HeightMap::from_fn(size[0], size[1], rng.pick(&Wrap::ALL), texel).expect("a map");
    let scale_m = rng.pick(&[0.0, 1e-3, 0.05, 0.3]);
    let map = map.with_displacement(scale_m, rng.pick(&[0.0, -0.5 * scale_m, 0.02])).expect("lengths");
    if rng.unit() < 0.7 {
        return map;
    }
    let every = rng.pick(&[2, 3, 7]);
    map.with_holes(TexelMask::from_fn(size[0], size[1], |i, j| (i + 2 * j) % every == 0))
        .expect("of its size")
}

/// Two triangles that share a side, each on a chart of its own: the second one's lies far from the first
/// one's, or goes on where that ends.
fn base(rng: &mut Rng) -> Mesh {
    let flat = rng.pick(&[1.0, 0.1, 1e-3]);
    let turn = rng.pick(&[0.0, 0.2, 1.0]);
    let texels = rng.pick(&[0.01, 0.3, 2.0, 9.0]);
    let point = |x: f64, z: f64, rng: &mut Rng| {
        let mut some = |by: f64| rng.between(-by, by);
        let position = DVec3::new(x + some(0.2), some(0.1), (z + some(0.2)) * flat);
        let normal = DVec3::new(some(turn), 1.0, some(turn)).normalize();
        let uv = Vec2::new((x + some(0.3)) as f32, (z + some(0.3)) as f32) * texels as f32;
        let [tangent, bitangent] = [DVec3::X, DVec3::Z].map(|axis| (axis / texels).as_vec3());
        Vertex { position: position.as_vec3(), normal: normal.as_vec3(), tangent, bitangent, uv }
    };
    let corners = [(0.0, 0.0), (0.0, 1.0), (1.0, 0.0), (1.0, 1.0)];
    let vertices: Vec<Vertex> = corners.into_iter().map(|(x, z)| point(x, z, rng)).collect();
    Mesh::new(vertices, vec![[0, 1, 2], [2, 1, 3]]).expect("a mesh")
}

fn settings(rng: &mut Rng, map: &HeightMap) -> MeshSettings {
    let error = rng.pick(&[0.02, 0.1, 0.5]) * map.scale_m().max(0.01);
    MeshSettings {
        base: rng.pick(BaseSurface::ALL),
        directions: rng.pick(Directions::ALL),
        side: if rng.unit() < 0.5 { Side::Both } else { rng.pick(Side::ALL) },
        fit: rng.pick(Fit::ALL),
        judge: if rng.unit() < 0.8 { Judge::Surface } else { Judge::Texels },
        seams: rng.pick(Seams::ALL),
        holes: rng.unit() < 0.7,
        max_bytes: 64 << 20,
        ..MeshSettings::within(error)
    }
}

/// The weights of texture coordinates in a base triangle.
fn weights(corners: &[Vertex; 3], uv: Vec2) -> [f64; 3] {
    let [a, b, c] = corners.map(|corner| corner.uv.as_dvec2());
    let (area, at) = ((b - a).perp_dot(c - a), uv.as_dvec2());
    let [of_b, of_c] = [(at - a).perp_dot(c - a) / area, (b - a).perp_dot(at - a) / area];
    [1.0 - of_b - of_c, of_b, of_c]
}

/// The displaced point of a base triangle.
fn relief(corners: &[Vertex; 3], at: [f64; 3], map: &HeightMap, settings: &MeshSettings) -> DVec3 {
    let mut point = BasePoint::weighted(corners.map(|corner| (&corner).into()), at);
    let mut metres = map.displacement_m(map.height_at(point.uv.x, point.uv.y));
    match settings.base {
        BaseSurface::Flat => {}
        BaseSurface::Lift => metres += lift_m(corners, at),
        BaseSurface::Pn => point.position = curved_point(corners, at),
    }
    if settings.directions == Directions::Unit {
        point.normal = point.normal.normalize();
    }
    point.displaced(metres)
}

/// Least and greatest displacement of a piece's samples over their own base points, less the relief's
/// displacement there. Samples over no point of the triangle are left out.
fn above(base: &[Vertex; 3], corners: [&Vertex; 3], map: &HeightMap, is_lifted: bool) -> [f64; 2] {
    let point = |at: [f64; 3]| BasePoint::weighted(base.map(|corner| (&corner).into()), at);
    let [p, n] = [0, 1].map(|of| {
        base.map(|corner| if of == 0 { corner.position.as_dvec3() } else { corner.normal.as_dvec3() })
    });
    let mut range = [f64::INFINITY, f64::NEG_INFINITY];
    for i in 0..=5 {
        for j in 0..=5 - i {
            let of = [i, j, 5 - i - j].map(|part| part as f32 / 5.0);
            let uv: Vec2 = (0..3).map(|k| corners[k].uv * of[k]).sum();
            let there: DVec3 = (0..3).map(|k| (corners[k].position * of[k]).as_dvec3()).sum();
            let mut at = weights(base, uv);
            let mut metres = map.displacement_m(map.height_at(f64::from(uv.x), f64::from(uv.y)));
            // Newton's method: the base point and the displacement that lead there.
            for _ in 0..20 {
                let off = there - point(at).displaced(metres);
                let along = [1, 2].map(|k| p[k] - p[0] + (n[k] - n[0]) * metres);
                let up = point(at).normal;
                let volume = along[0].cross(along[1]).dot(up);
                let [b, c] = [off.cross(along[1]).dot(up) / volume, along[0].cross(off).dot(up) / volume];
                at = [at[0] - b - c, at[1] + b, at[2] + c];
                metres += along[0].cross(along[1]).dot(off) / volume;
            }
            let is_over =
                at.iter().all(|weight| *weight >= 0.0) && point(at).displaced(metres).distance(there) < 1e-9;
            if is_over {
                let uv = point(at).uv;
                let lift_m = if is_lifted { lift_m(base, at) } else { 0.0 };
                let above = metres - map.displacement_m(map.height_at(uv.x, uv.y)) - lift_m;
                range = [range[0].min(above), range[1].max(above)];
            }
        }
    }
    range
}

/// What came of a base.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Outcome {
    /// With the farthest sample, in what it may be.
    Made(f64),
    Refused,
}

fn attack(round: u64) -> Outcome {
    let rng = &mut Rng::new(0x5eed + round);
    let (map, base) = (map(rng), base(rng));
    let settings = settings(rng, &map);
    let about = || format!("round {round}: {settings:?}, {map:?}, {base:?}");
    let mesher = match Mesher::new(&base, &map, &settings) {
        Ok(mesher) => mesher,
        Err(
            MesherError::OnPlanesAlone { .. }
            | MesherError::TooFine { .. }
            | MesherError::NotReached { .. }
            | MesherError::NoMemory { .. }
            | MesherError::SideOfFold { .. }
            | MesherError::SideOfSeams { .. }
            | MesherError::AllHoles,
        ) => return Outcome::Refused,
        Err(other) => panic!("{other}: {}", about()),
    };
    let mesh = mesher.mesh().expect("finite");
    let certificate = *mesher.certificate().expect("made to an error");
    assert!(certificate.error_m <= settings.error_m * (1.0 + 1e-9), "{certificate:?}, {}", about());
    let holes = settings.holes && map.holes().is_some();
    let cracks = CrackTest::of_mesh(&mesh);
    assert!(cracks.branching == 0 || holes, "{cracks:?}, {}", about());
    let triangles: Vec<[Vertex; 3]> =
        (0..2).map(|triangle| base.corners(triangle).map(|corner| *corner)).collect();
    // Both charts may overlap: a piece is of the one on which its own corners lie.
    let area = |corners: &[Vertex; 3]| {
        let [a, b, c] = corners.map(|corner| corner.uv.as_dvec2());
        (b - a).perp_dot(c - a)
    };
    if triangles
        .iter()
        .any(|corners| area(corners).abs() < 1e-3 * f64::from(corners[0].uv.length().max(1e-3)))
    {
        return Outcome::Made(0.0);
    }
    // What texture coordinates and positions are rounded by.
    let texel = f64::from(map.width().max(map.height()));
    let uv_most = triangles.as_flattened().iter().map(|corner| corner.uv.length()).fold(0.0, f32::max);
    let rounding = 1e-6 + map.scale_m() * texel * f64::from(uv_most) * 1e-5;
    let mut worst = 0.0_f64;
    for piece in 0..mesh.triangles().len() as u32 {
        let corners = mesh.corners(piece);
        let of_base = |base: &&[Vertex; 3]| {
            corners.iter().all(|corner| weights(base, corner.uv).iter().all(|weight| *weight > -1e-4))
        };
        let possible: Vec<&[Vertex; 3]> = triangles.iter().filter(of_base).collect();
        let farthest = |base: &[Vertex; 3]| {
            let mut most = 0.0_f64;
            for i in 0..=5 {
                for j in 0..=5 - i {
                    let of = [i, j, 5 - i - j].map(|part| part as f32 / 5.0);
                    let uv: Vec2 = (0..3).map(|k| corners[k].uv * of[k]).sum();
                    let at: Vec3 = (0..3).map(|k| corners[k].position * of[k]).sum();
                    let there = relief(base, weights(base, uv), &map, &settings);
                    most = most.max(there.distance(at.as_dvec3()));
                }
            }
            most
        };
        let nearest = possible.iter().copied().map(farthest).fold(f64::INFINITY, f64::min);
        // At texels alone it may be farther between them.
        if settings.judge == Judge::Texels || !nearest.is_finite() {
            continue;
        }
        let bound = certificate.error_m + certificate.seams_m + rounding;
        assert!(nearest <= bound, "{nearest} beyond {bound}, {certificate:?}, {}", about());
        worst = worst.max(nearest / bound);
        if let (Side::Above | Side::Below, [base]) = (settings.side, &possible[..]) {
            let [low, high] = above(base, corners, &map, settings.base == BaseSurface::Lift);
            let is_there = if settings.side == Side::Above { low >= -rounding } else { high <= rounding };
            assert!(is_there, "{low} to {high} {}: {}", settings.side, about());
        }
    }
    Outcome::Made(worst)
}

#[test]
fn what_is_made_keeps_what_it_says() {
    let outcomes: Vec<Outcome> = (0..ROUNDS).into_par_iter().map(attack).collect();
    let made: Vec<f64> = outcomes
        .into_iter()
        .filter_map(|outcome| if let Outcome::Made(part) = outcome { Some(part) } else { None })
        .collect();
    let near = made.iter().filter(|part| **part > 0.5).count();
    println!("{} of {ROUNDS} made, {near} nearly as far as they may be", made.len());
    assert!(made.len() as u64 * 4 > ROUNDS && near * 4 > made.len(), "{} {near}", made.len());
}
