//! Rays to motifs: what the search answers, beside the triangles one by one in `f64`.

use relief_core::mesh::RawMesh;
use relief_core::rng::Rng;
use relief_core::{Hit, MotifTree, Path, TileTriangle};
use relief_mesh::motif::{MotifKind, MotifSettings, motif};
use relief_mesh::shell_map::motif_for_rays;
use relief_testing::motifs::Repeated;

/// The mesh of a motif of few triangles.
pub fn motif_mesh(kind: MotifKind) -> RawMesh {
    let count = if kind == MotifKind::Grass { 40 } else { 2 };
    (&motif(&MotifSettings { count, detail: 8, ..MotifSettings::new(kind) }).expect("a motif").mesh).into()
}

/// The tree of a motif of few triangles.
pub fn motif_tree(kind: MotifKind) -> MotifTree {
    motif_for_rays(&motif_mesh(kind)).expect("a motif").tree
}

/// The triangles of a mesh in the space of a tile, but for the caps of threads on the tile's edges: they meet
/// the next tile's caps, inside of the thread.
pub fn tile_triangles(mesh: &RawMesh) -> Vec<TileTriangle> {
    let triangle = |corners: &[relief_core::mesh::RawCorner; 3]| {
        let corners = corners.map(|corner| mesh.positions[corner.position as usize].as_dvec3());
        let turned = corners.map(|at| glam::DVec3::new(at.x, at.z, at.y));
        TileTriangle { corners: turned, normals: [glam::Vec3::Z; 3] }
    };
    let is_cap = |triangle: &TileTriangle| {
        let on_edge = |axis: usize, edge: f64| triangle.corners.iter().all(|corner| corner[axis] == edge);
        [0, 1].into_iter().any(|axis| on_edge(axis, 0.0) || on_edge(axis, 1.0))
    };
    mesh.triangles.iter().map(triangle).filter(|triangle| !is_cap(triangle)).collect()
}

/// Straight paths as the shaders receive them: down through all heights, up as to a light, or between two.
pub fn straight_paths(seed: u64, count: usize) -> Vec<Path> {
    let mut rng = Rng::new(seed);
    let mut path = || {
        let mut at = |height: f64| [rng.between(-2.0, 2.0), rng.between(-2.0, 2.0), height];
        let [low, high] = [at(0.0), at(1.0)];
        let path = match rng.below(4) {
            0 => Path::between(low, high),
            1 => {
                let [a, b] = [rng.unit(), rng.unit()];
                Path::between([low[0], low[1], a], [low[0] + 0.3 * rng.unit(), low[1], b])
            }
            _ => Path::between(high, low),
        };
        Path::from(&relief_shaders::cpu::Path::from(&path))
    };
    (0..count).map(|_| path()).collect()
}

/// How far from a triangle a hit may be, in tiles.
const BESIDE: f64 = 2e-5;

/// How clear of its edges, in weights of its corners, and how steep a path must meet a triangle to be judged:
/// others graze.
const CLEAR: f64 = 1e-3;

/// The paths for which an answer is wrong: past a triangle that they meet clearly, or with a hit beside all
/// of them.
pub fn wrong(triangles: &Repeated, paths: &[Path], hits: &[Hit]) -> usize {
    let is_wrong = |path: &Path, hit: &Hit| {
        let end = if hit.found { hit.t } else { path.exit };
        let tiles_a_unit = path.duv[0].hypot(path.duv[1]).hypot(path.h[1]);
        let is_passed = triangles.meetings(path).into_iter().any(|met| {
            met.inside > CLEAR && met.cosine > CLEAR && (end - met.t) * tiles_a_unit > BESIDE / met.cosine
        });
        is_passed || (hit.found && triangles.distance(path.at(hit.t)) > BESIDE)
    };
    paths.iter().zip(hits).filter(|(path, hit)| is_wrong(path, hit)).count()
}
