use std::convert::Infallible;

use glam::{DVec3, Vec2, Vec3};
use relief_core::camera::Camera;
use relief_core::mesh::{Mesh, RawCorner, RawMesh, cube, rectangle};
use relief_core::{HeightMap, TexelMask, Watch, Wrap};
use relief_mesh::{
    BaseSurface, Cull, Directions, EDGE_RULES, Fit, INTERIORS, Judge, MeshSettings, Mesher, Seams, Shading,
    Side, Stream, View,
};

use crate::Target;
use crate::common::Random;

/// Any small map over any few triangles with any settings: an error or a mesh of as many finite vertices and
/// triangles as was counted before.
pub const MESH: Target = Target { name: "mesh", run, make };

/// The longest side of a map, in texels: every wrap shows on small maps, and large ones only cost time.
const MOST: u32 = 24;

/// Meshes of more triangles are counted, and not made: they only cost time.
const MOST_TRIANGLES: u64 = 50_000;

/// Enough for every mesh of so few triangles.
const MAX_BYTES: u64 = 8 << 20;

/// Numbers, one byte each; 0 when there are no more.
struct Bytes<'a>(&'a [u8]);

impl Bytes<'_> {
    fn next(&mut self) -> u8 {
        let Some((&first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        first
    }

    fn of<'a, T>(&mut self, all: &'a [T]) -> &'a T {
        &all[usize::from(self.next()) % all.len()]
    }

    /// From -1 to 1.
    fn signed(&mut self) -> f32 {
        f32::from(self.next()) / 127.5 - 1.0
    }

    fn place(&mut self) -> Vec3 {
        Vec3::new(self.signed(), self.signed(), self.signed())
    }
}

fn map(bytes: &mut Bytes) -> Option<HeightMap> {
    let wrap = *bytes.of(Wrap::ALL.as_slice());
    let [width, height] = [bytes.next(), bytes.next()].map(|side| u32::from(side) % MOST + 1);
    let [scale_m, bias_m] = [*bytes.of(&[0.05, 0.0, 1e-3, 1.0, 1e6]), f64::from(bytes.signed())];
    let holes = bytes.next();
    let seed = bytes.next();
    let map = HeightMap::from_fn(width, height, wrap, |i, j| {
        let mixed =
            (i * 73 + j * 191).wrapping_mul(u32::from(seed) | 1).wrapping_add(u32::from(bytes.next()));
        (mixed % 256) as f32 / 255.0
    });
    let map = map.ok()?.with_displacement(scale_m, bias_m).ok()?;
    if holes < 170 {
        return Some(map);
    }
    map.with_holes(TexelMask::from_fn(width, height, |i, j| (i + 2 * j) % u32::from(holes % 7 + 1) == 0)).ok()
}

/// A plane, a cube, or triangles anywhere with textures anyhow.
fn base(bytes: &mut Bytes) -> Option<Mesh> {
    let tiles = *bytes.of(&[1.0, 0.1, 3.7, 1e-6]);
    let mesh = match bytes.next() % 4 {
        0 => rectangle([1.0, *bytes.of(&[1.0, 0.3])], 1).ok()?,
        1 => cube(1).ok()?,
        _ => {
            let count = usize::from(bytes.next() % 6) + 3;
            let positions = (0..count).map(|_| bytes.place()).collect();
            let uvs = (0..count).map(|_| Vec2::new(bytes.signed(), bytes.signed())).collect();
            let mut corner = || RawCorner::all(u32::from(bytes.next()) % count as u32);
            let mut triangles = vec![[RawCorner::all(0), RawCorner::all(1), RawCorner::all(2)]];
            triangles.extend((0..4).map(|_| [corner(), corner(), corner()]));
            RawMesh { positions, uvs, triangles, ..RawMesh::default() }.framed().ok()?.mesh
        }
    };
    mesh.tiled(Vec2::splat(tiles)).ok()
}

/// The settings; `error_m` is a part of the map's height.
fn settings(bytes: &mut Bytes) -> Option<MeshSettings> {
    let (edges, interior) = (bytes.of(EDGE_RULES), bytes.of(INTERIORS));
    let camera = Camera::new(bytes.place().as_dvec3() * 3.0, DVec3::ZERO, 40.0).ok()?;
    let view = View { pixels: *bytes.of(&[1.0, 4.0, 0.5]), ..View::new(camera, [64, 48]) };
    Some(MeshSettings {
        edges,
        interior,
        texels: u32::from(bytes.next() % 5) + 1,
        view: Some(view),
        cull: *bytes.of(&[None, Some(Cull { backs: true, ..Cull::default() })]),
        error_m: *bytes.of(&[0.1, 0.5, 0.01, 1e-9]),
        judge: *bytes.of(Judge::ALL),
        fit: *bytes.of(Fit::ALL),
        side: *bytes.of(Side::ALL),
        solid_m: *bytes.of(&[None, Some(0.01), Some(0.0)]),
        max_bytes: MAX_BYTES,
        base: *bytes.of(BaseSurface::ALL),
        directions: *bytes.of(Directions::ALL),
        shading: *bytes.of(Shading::ALL),
        seams: *bytes.of(Seams::ALL),
        holes: *bytes.of(&[false, true]),
        ..MeshSettings::default()
    })
}

fn run(bytes: &[u8]) -> bool {
    let mut bytes = Bytes(bytes);
    let Some(mut settings) = settings(&mut bytes) else { return false };
    let Some(mesh) = base(&mut bytes) else { return false };
    let Some(map) = map(&mut bytes) else { return false };
    settings.error_m *= map.scale_m();
    let Ok(mesher) = Mesher::new(&mesh, &map, &settings) else { return false };
    if mesher.triangles() > MOST_TRIANGLES {
        return false;
    }
    let how = Stream { size: 1.0, check: true, grid: None, cache_order: false, watch: Watch::none() };
    let (mut vertices, mut triangles) = (0, 0);
    let streamed = mesher.stream(&how, |block| {
        assert!(block.vertices.iter().all(|vertex| vertex.position.is_finite() && vertex.normal.is_finite()));
        vertices += block.vertices.len() as u64;
        triangles += block.triangles.len() as u64;
        assert!(block.triangles.iter().flatten().all(|&corner| u64::from(corner) < mesher.vertices()));
        Ok::<(), Infallible>(())
    });
    if streamed.is_err() {
        return false;
    }
    assert_eq!([vertices, triangles], [mesher.vertices(), mesher.triangles()]);
    true
}

/// For each edge rule and interior an input that they mesh, where one of a few is found.
fn make() -> Vec<Vec<u8>> {
    let mut random = Random::new(1);
    let mut inputs = Vec::new();
    for edges in 0..EDGE_RULES.len() {
        for interior in 0..INTERIORS.len() {
            let mut input = || {
                let rest = (0..120).map(|_| random.below(256) as u8);
                [edges as u8, interior as u8].into_iter().chain(rest).collect::<Vec<u8>>()
            };
            inputs.extend((0..100).map(|_| input()).find(|input| run(input)));
        }
    }
    inputs
}
