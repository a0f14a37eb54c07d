//! Rays through volumes: what methods answer, beside the judge of volumes in `f64`.

use std::sync::Arc;

use relief_bake::volumes::{Fit, MeshVolumeSettings, volume_from_mesh};
use relief_core::mesh::{RawCorner, RawMesh};
use relief_core::rng::Rng;
use relief_core::{BakedMap, Hit, Lanes, Metric, Path, Volume, Watch};
use relief_maps::Maps;
use relief_mesh::motif::{MotifKind, MotifSettings, motif};
use relief_shaders::Selection;
use relief_shaders::cpu::MethodTracer;
use relief_shaders::field::Solids;

/// The volume of a motif with its default settings.
pub fn motif_volume(kind: MotifKind, size: [u32; 3]) -> Volume {
    let mesh = motif(&MotifSettings::new(kind)).expect("a motif").mesh;
    let corner = |position| RawCorner { position, normal: RawCorner::NONE, uv: RawCorner::NONE };
    let raw = RawMesh {
        positions: mesh.vertices().iter().map(|vertex| vertex.position).collect(),
        triangles: mesh.triangles().iter().map(|corners| corners.map(corner)).collect(),
        ..RawMesh::default()
    };
    let settings = MeshVolumeSettings { fit: Fit::Tile, ..MeshVolumeSettings::new(size) };
    volume_from_mesh(&raw, &settings, &Watch::none()).expect("a volume").volume
}

/// How far above the surface's value a passed place may be, and for how many voxels.
const PASSED: f64 = 1e-4;
const PASSED_VOXELS: f64 = 1e-3;

/// How far from the surface's value a hit may be.
const BESIDE: f64 = 1e-3;

/// A path as the shaders receive it: from above or the side, straight or bent, some that turn.
fn path(rng: &mut Rng) -> Path {
    let mut at = |high: f64| [rng.between(-2.0, 2.0), rng.between(-2.0, 2.0), high];
    let mut path = Path::between(at(1.0), at(0.0));
    if rng.below(4) == 0 {
        path = Path::between(
            [path.uv[0], path.uv[1], rng.unit()],
            [path.uv[0] + rng.unit(), path.uv[1], rng.unit()],
        );
    }
    if rng.below(2) == 0 {
        let bend = rng.between(-3.0, 3.0);
        path.h = [path.h[0], path.h[1] - bend, bend];
    }
    Path::from(&relief_shaders::cpu::Path::from(&path))
}

/// That many paths of all kinds, by a seed.
pub fn paths(seed: u64, count: usize) -> Vec<Path> {
    let mut rng = Rng::new(seed);
    (0..count).map(|_| path(&mut rng)).collect()
}

/// The greatest value above the surface's on the way between two parameters, and the voxels of that way.
fn passed(volume: &Volume, path: &Path, from: f64, to: f64) -> (f64, f64) {
    let at = |part: f64| path.at(from + (to - from) * part);
    let most = (0..=64).map(|k| volume.value_at(at(f64::from(k) / 64.0))).fold(0.0, f64::max);
    let [a, b] = [at(0.0), at(1.0)];
    let apart =
        (0..3).map(|axis| ((a[axis] - b[axis]) * f64::from(volume.size()[axis])).powi(2)).sum::<f64>();
    (most - Volume::SURFACE, apart.sqrt())
}

/// The rays that an answer is wrong for: passed the surface, or hit beside it.
pub fn wrong(volume: &Volume, paths: &[Path], hits: &[Hit]) -> usize {
    let is_wrong = |path: &Path, hit: &Hit| {
        let judge = volume.first_hit(path);
        let end = if hit.found { hit.t } else { path.exit };
        let is_passed = judge.is_some_and(|judge| {
            let (above, voxels) = passed(volume, path, judge.t, end);
            end > judge.t && above > PASSED && voxels > PASSED_VOXELS
        });
        let value = volume.value_at(path.at(hit.t)) - Volume::SURFACE;
        let begins_inside = hit.t == 0.0 && value > 0.0;
        is_passed || (hit.found && value.abs() > BESIDE && !begins_inside)
    };
    paths.iter().zip(hits).filter(|(path, hit)| is_wrong(path, hit)).count()
}

/// The maps that a method reads over a volume.
pub fn baked(volume: &Volume, selection: &Selection) -> Vec<Arc<BakedMap>> {
    let selection = selection.with_solids(Solids::Volumes).with_volume_size(volume.size());
    let provided = Maps::in_memory().provide(&selection, volume.atlas(), Metric::UNIT, &Watch::none());
    provided.expect("maps").into_parts().0.into_iter().map(|(_, map)| map).collect()
}

/// The hits of a method with a volume, over maps that are baked for it.
pub fn hits(volume: &Volume, selection: &Selection, paths: &[Path], lanes: Lanes) -> Vec<Hit> {
    hits_over(volume, selection, &baked(volume, selection), paths, lanes)
}

/// The hits of a method with a volume over these maps.
pub fn hits_over(
    volume: &Volume,
    selection: &Selection,
    maps: &[Arc<BakedMap>],
    paths: &[Path],
    lanes: Lanes,
) -> Vec<Hit> {
    let mut hits = vec![Hit::miss(Default::default()); paths.len()];
    let tracer = MethodTracer::of_volume(volume, selection, maps.iter().map(|map| &**map)).expect("its maps");
    tracer.first_hits(paths, lanes, &mut hits);
    hits
}

/// A straight ray into a volume from above, at least that steep, with a parameter in voxels.
pub fn ray_from_above(rng: &mut Rng, size: [f64; 3], least_up: f64) -> Path {
    let up = rng.between(-1.0, -least_up);
    let across = (1.0 - up * up).sqrt();
    let (sin, cos) = (rng.unit() * std::f64::consts::TAU).sin_cos();
    let toward = [across * cos / size[0], across * sin / size[1], up / size[2]];
    let mut path = Path::between([rng.unit(), rng.unit(), 1.0], [0.0, 0.0, 0.0]);
    path.duv = [toward[0], toward[1]];
    path.h = [1.0, toward[2], 0.0];
    path.exit = -1.0 / toward[2];
    Path::from(&relief_shaders::cpu::Path::from(&path))
}

/// The parts of rays whose hit is more than this number of voxels off, or that hit where the judge's miss, or
/// the other way round.
pub fn parts_off(volume: &Volume, paths: &[Path], hits: &[Hit], voxels: f64) -> f64 {
    let is_off = |(path, hit): (&Path, &Hit)| match (volume.first_hit(path), hit.found) {
        (Some(judge), true) => (judge.t - hit.t).abs() > voxels,
        (judge, found) => judge.is_some() || found,
    };
    paths.iter().zip(hits).filter(|pair| is_off(*pair)).count() as f64 / paths.len() as f64
}
