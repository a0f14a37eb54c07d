//! One mesh three times, turned and scaled unevenly: as objects, and as an `InstancedMesh`. The renderer
//! draws one mesh whose vertices are in these places.

use std::path::Path;
use std::sync::Arc;

use glam::{DMat4, Vec3};
use relief_core::mesh::{Mesh, Vertex};
use serde_json::{Value, json};

use super::place::Place;
use super::{drawn, hits};
use crate::kits::{ASIDE_PIXELS, EYE_M, Job, Shown, camera, rendered};

/// How much farther the eye is away than from one mesh.
const FARTHER: f64 = 1.5;

/// The places, from the left to the right.
fn places() -> [Place; 3] {
    [
        Place::new([-0.6, 0.05, 0.4], [25.0, 40.0, 0.0], [0.7, 0.42, 0.98]),
        Place::new([0.0, 0.0, 0.0], [0.0, -30.0, 35.0], [0.49, 0.7, 0.7]),
        Place::new([0.55, -0.05, -0.45], [-20.0, 75.0, 15.0], [0.98, 0.7, 0.42]),
    ]
}

/// A vertex in a place. Normals stay perpendicular to the mesh.
fn moved(vertex: &Vertex, matrix: &DMat4) -> Vertex {
    let way = |along: Vec3| matrix.transform_vector3(along.as_dvec3()).as_vec3();
    let normal = matrix.inverse().transpose().transform_vector3(vertex.normal.as_dvec3());
    Vertex {
        position: matrix.transform_point3(vertex.position.as_dvec3()).as_vec3(),
        normal: normal.normalize().as_vec3(),
        tangent: way(vertex.tangent),
        bitangent: way(vertex.bitangent),
        uv: vertex.uv,
    }
}

/// One mesh of a mesh in several places.
fn merged(mesh: &Mesh, places: &[Place]) -> Result<Mesh, String> {
    let matrices: Vec<DMat4> = places.iter().map(Place::matrix).collect();
    let of = |matrix: &DMat4| -> Vec<Vertex> {
        mesh.vertices().iter().map(|vertex| moved(vertex, matrix)).collect()
    };
    let count = mesh.vertices().len() as u32;
    let later = (0..places.len() as u32).map(|k| k * count);
    let triangles = later.flat_map(|first| mesh.triangles().iter().map(move |of| of.map(|k| k + first)));
    Mesh::new(matrices.iter().flat_map(of).collect(), triangles.collect()).map_err(|error| error.to_string())
}

/// The renderer's hits, in a picture that is moved aside.
fn ours(job: &Job, mesh: &Arc<Mesh>, aside_pixels: f64) -> Result<Shown, String> {
    let camera = camera(EYE_M * FARTHER, aside_pixels, job.size)?;
    rendered::shown(mesh, job.heights, job.selection, camera, job.size)
}

/// The renderer's hits, and its hits moved aside by as much as rasterisers may be.
pub fn exact_of(job: &Job) -> Result<[Shown; 2], String> {
    let mesh = Arc::new(merged(job.mesh, &places())?);
    Ok([ours(job, &mesh, 0.0)?, ours(job, &mesh, ASIDE_PIXELS)?])
}

/// The hits of three.js.
pub fn shown(chromium: &Path, job: &Job, backend: &str, is_instanced: bool) -> Result<Shown, String> {
    let places: Vec<Value> = places().iter().map(Place::json).collect();
    let more = json!({
        "eye": (EYE_M * FARTHER).to_array(),
        "instances": { "instanced": is_instanced, "places": places },
    });
    drawn(chromium, job, backend, more).map(|pixels| hits(&pixels))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kits::{LEAST_FROM_DERIVATIVES, Subject, compare};
    use relief_core::mesh::Builtin;

    #[test]
    fn a_scale_that_is_forgotten_is_seen() {
        let subject = Subject::of(Builtin::Torus, "exact", [192, 144]).expect("a subject");
        let job = subject.job(true);
        let [exact, aside] = exact_of(&job).expect("pictures");
        let side = job.heights.width();
        let itself = compare(&exact, &aside, side);
        let mut forgotten = places();
        forgotten[2].scale = glam::DVec3::splat(0.7);
        let mesh = Arc::new(merged(job.mesh, &forgotten).expect("a mesh"));
        let found = compare(&exact, &ours(&job, &mesh, 0.0).expect("a picture"), side);
        assert!(itself.is_as_near_as(&itself) && !found.is_as_near_as(&itself));
        assert!(found.hits < LEAST_FROM_DERIVATIVES);
    }

    #[test]
    fn normals_stay_perpendicular() {
        let mesh = merged(&Builtin::Sphere.build([1.0, 1.0]).expect("a mesh"), &places()).expect("a mesh");
        for vertex in mesh.vertices() {
            for along in [vertex.tangent, vertex.bitangent] {
                assert!(along.dot(vertex.normal).abs() < 1e-5 * along.length().max(1.0));
            }
        }
    }
}
