//! References with which pictures are compared.

use rayon::prelude::*;
use relief_core::camera::Camera;
use relief_core::exact::{DisplacedMesh, ExactHit, Sides};
use relief_core::mesh::Mesh;
use relief_core::{Cost, Hit, Watch, Wrap};
use relief_scene::Surface;
use relief_shaders::cpu::PixelOut;
use relief_shaders::{Choice, Entry, GEOMETRY, STAGES, SURFACE, Selection, SelectionError};

use crate::contender::Contender;
use crate::error::CompareError;

/// Greatest distance of a flat mesh's vertices from its plane, relative to its size; and greatest
/// difference of the cosine between its normals from 1.
const FLAT: f64 = 1e-6;

/// Whether a mesh lies in a plane, with perpendicular normals.
pub fn is_flat(mesh: &Mesh) -> bool {
    let vertices = mesh.vertices();
    let Some(first) = vertices.first() else { return false };
    let (origin, normal) = (first.position.as_dvec3(), first.normal.as_dvec3());
    let size = vertices.iter().map(|vertex| vertex.position.as_dvec3().distance(origin)).fold(0.0, f64::max);
    vertices.iter().all(|vertex| {
        let beside = (vertex.position.as_dvec3() - origin).dot(normal).abs();
        beside <= FLAT * size && vertex.normal.as_dvec3().dot(normal) >= 1.0 - FLAT
    })
}

/// Describes the reference pictures in words.
pub fn words(surfaces: &[Surface]) -> &'static str {
    match surfaces {
        [surface] if is_flat(surface.mesh()) => "the picture of the method exact on the CPU, and its hits",
        [_] => {
            "the picture of the method exact with the surface prism on the CPU, and the hits of the exact \
             tracer of displaced meshes"
        }
        _ => "the picture of the method exact on the CPU, with the surface prism for curved meshes",
    }
}

/// Returns the selection for a surface's reference: the exact method with the given shadow, and
/// shells on curved meshes. Displaced triangles give way to rays from the mesh.
pub fn selection(surface: &Surface, shadow: Choice) -> Result<Selection, SelectionError> {
    let mut selection = *surface.selection();
    if selection.geometry().is_some() {
        let [geometry, base] = [GEOMETRY, SURFACE].map(|place| &STAGES[place]);
        selection.choose(geometry.key, geometry.first(Entry::is_idle).map_or("", |(_, entry)| entry.name))?;
        selection.choose(base.key, base.entries[0].name)?;
    }
    if !is_flat(surface.mesh()) {
        selection.choose(STAGES[SURFACE].key, "prism")?;
    }
    let prepared = surface.clone().with_selection(selection);
    Contender::named("exact")?.with_shadow(shadow).on(&prepared)
}

/// Returns the hit of a pixel's centre; its depth becomes `t`.
pub fn hit_of(pixel: &PixelOut) -> Hit {
    let cost = Cost { reads: pixel.reads, steps: pixel.steps, bytes: pixel.bytes };
    if pixel.hit == 0 {
        return Hit::miss(cost);
    }
    Hit {
        found: true,
        exhausted: pixel.exhausted == 1,
        uv: [pixel.uv.x, pixel.uv.y].map(f64::from),
        height: pixel.height.into(),
        t: pixel.depth.into(),
        cost,
    }
}

/// Turns a hit into a true one.
pub fn truth(hit: Hit) -> ExactHit {
    ExactHit { hit, ..ExactHit::miss(Cost::default(), 0.0) }
}

/// Name of the task of finding the exact hits of a curved mesh.
pub const EXACT_HITS: &str = "exact hits";

/// Rows that are traced between two looks whether the work is cancelled.
const ROWS: u32 = 16;

/// Traces the centre of every pixel with the exact tracer of displaced meshes.
pub fn traced_exactly(
    surface: &Surface,
    camera: &Camera,
    [columns, rows]: [u32; 2],
    watch: &Watch,
) -> Result<Vec<ExactHit>, CompareError> {
    let watch = watch.task(EXACT_HITS);
    watch.at(0.0)?;
    let map = surface.height_map();
    let judge = DisplacedMesh::new(surface.mesh(), map, map.scale_m(), map.bias_m())?;
    let sides = if surface.two_sided() { Sides::Both } else { Sides::Front };
    let traced = |pixel: u32| {
        let ray = camera.ray(pixel % columns, pixel / columns, columns, rows);
        let first = judge.first_hit(ray.origin.to_array(), ray.direction.to_array(), sides);
        truth(first.map_or(Hit::miss(Cost::default()), |first| Hit {
            found: true,
            exhausted: false,
            uv: first.uv,
            height: first.height,
            t: first.t,
            cost: Cost::default(),
        }))
    };
    let mut seen = Vec::with_capacity(columns as usize * rows as usize);
    for first in (0..rows).step_by(ROWS as usize) {
        watch.at(first as f32 / rows as f32)?;
        let last = (first + ROWS).min(rows);
        seen.par_extend((first * columns..last * columns).into_par_iter().map(traced));
    }
    Ok(seen)
}

/// Moves a hit to the tile nearest to the true one: on a repeated map, charts may meet whole tiles
/// apart.
pub fn in_tile_of(hit: Hit, truth: &Hit, wrap: Wrap) -> Hit {
    if wrap != Wrap::Repeat || !(hit.found && truth.found) {
        return hit;
    }
    let uv = [0, 1].map(|axis| hit.uv[axis] - (hit.uv[axis] - truth.uv[axis]).round());
    Hit { uv, ..hit }
}

#[cfg(test)]
mod tests {
    use relief_core::mesh::{Builtin, square};

    use super::*;

    #[test]
    fn planes_are_flat_and_spheres_are_not() {
        assert!(is_flat(&square(3).expect("a square")));
        for shape in [Builtin::Sphere, Builtin::Cube, Builtin::Torus] {
            assert!(!is_flat(&shape.build([1.0, 1.0]).expect("a shape")), "{}", shape.name());
        }
    }
}
