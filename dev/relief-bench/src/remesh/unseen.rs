//! Part of a mesh for a view that is left out because the view does not see it.

use std::time::Instant;

use comfy_table::Table;
use glam::DVec3;
use relief_core::HeightMap;
use relief_core::camera::{Camera, Projection};
use relief_core::mesh::{Builtin, Mesh};
use relief_mesh::{Cull, MeshSettings, Mesher, Outside, View};
use relief_tests::accuracy::maps;

use crate::surfaces::bases::{Base, cobbles};

/// Texels of the map that a voxel is wide at least, as in pictures.
const FINEST_TEXELS: f64 = 0.25;

/// Metres above the highest ground at which is walked, and how far ahead is looked.
const ABOVE_M: f64 = 0.01;
const AHEAD_M: f64 = 0.3;

/// Places on the way across the ground.
const PLACES: u32 = 8;

/// What is looked at, and from where: the pictures of a row.
struct Subject {
    what: String,
    mesh: Mesh,
    map: HeightMap,
    /// Metres of a texel, where it is least.
    texel_m: f64,
    cameras: Vec<Camera>,
}

/// What is made in all pictures.
#[derive(Default)]
struct Sums {
    all: u64,
    unseen: u64,
    left: u64,
    seconds: [f64; 2],
}

/// A row a subject.
pub fn table(width: u32) -> Result<Table, String> {
    let size = [width, width * 3 / 4];
    let mut rows = crate::table::table(&[
        "pictures",
        "triangles",
        "of which are seen",
        "that are made",
        "left out of those that are not",
        "s for all",
        "s for those",
    ]);
    for subject in subjects()? {
        let mut sums = Sums::default();
        for camera in &subject.cameras {
            sums.add(&subject, camera, size)?;
        }
        let Sums { all, unseen, left, seconds: [whole, culled] } = sums;
        rows.add_row([
            subject.what,
            all.to_string(),
            (all - unseen).to_string(),
            left.to_string(),
            format!("{:.1} %", 100.0 * (all - left) as f64 / unseen.max(1) as f64),
            format!("{whole:.2}"),
            format!("{culled:.2}"),
        ]);
    }
    Ok(rows)
}

fn subjects() -> Result<Vec<Subject>, String> {
    let text = |error: &dyn std::fmt::Display| error.to_string();
    let camera = |eye: [f64; 3], target: [f64; 3], fov_degrees: f64| {
        Camera::with(eye.into(), target.into(), Projection::Perspective { fov_degrees })
    };
    let torus = Base::of("torus-32x16")?.ok_or("there is no torus")?.mesh;
    let cobbles = cobbles()?.with_displacement(0.03, 0.0).map_err(|error| text(&error))?;
    let mut subjects = Vec::new();
    for (what, fov_degrees) in [("a torus", 40.0), ("a torus, zoomed in", 6.0)] {
        let camera = camera([0.3, 0.9, 1.5], [0.2, 0.05, 0.25], fov_degrees).map_err(|error| text(&error))?;
        let (mesh, map) = (torus.clone(), cobbles.clone());
        // Three tiles around the tube of a metre and a half.
        let texel_m = 0.5 / f64::from(map.height());
        subjects.push(Subject { what: what.to_owned(), mesh, map, texel_m, cameras: vec![camera] });
    }
    let found = maps().into_iter().find(|named| named.name == "jacksboro");
    let map = found.ok_or("there is no elevation model")?.map;
    let map = map.with_displacement(0.1056, -0.1056).map_err(|error| text(&error))?;
    let mesh = Builtin::Plane.build([1.0, 1.0]).map_err(|error| text(&error))?;
    let walk = (0..PLACES).map(|place| {
        let along = 0.8 * f64::from(place) / f64::from(PLACES - 1) - 0.4;
        let eye = DVec3::new(along, ABOVE_M, 0.3 * (7.0 * along).sin());
        let ahead = DVec3::new(1.0, -0.25, 2.1 * (7.0 * along).cos()).normalize() * AHEAD_M;
        camera(eye.to_array(), (eye + ahead).to_array(), 50.0)
    });
    let cameras = walk.collect::<Result<Vec<Camera>, _>>().map_err(|error| text(&error))?;
    let texel_m = 1.0 / f64::from(map.width().max(map.height()));
    subjects.push(Subject {
        what: format!("{PLACES} on a walk over jacksboro"),
        mesh,
        map,
        texel_m,
        cameras,
    });
    Ok(subjects)
}

impl Sums {
    fn add(&mut self, subject: &Subject, camera: &Camera, size: [u32; 2]) -> Result<(), String> {
        let view = View::new(*camera, size);
        let voxel = 2.0 * camera.half_height() / f64::from(size[1]);
        let view = View { near_m: view.near_m.max(FINEST_TEXELS * subject.texel_m / voxel), ..view };
        for (k, cull) in [None, Some(Cull { outside: Outside::ALL, backs: true })].into_iter().enumerate() {
            let settings = MeshSettings { cull, ..MeshSettings::seen_by(view) };
            let started = Instant::now();
            let made = Mesher::new(&subject.mesh, &subject.map, &settings);
            let made = made.map_err(|error| error.to_string())?;
            let mesh = made.mesh().map_err(|error| error.to_string())?;
            self.seconds[k] += started.elapsed().as_secs_f64();
            let count = mesh.triangles().len() as u64;
            if cull.is_some() {
                self.left += count;
            } else {
                self.all += count;
                self.unseen +=
                    mesh.triangles().iter().filter(|corners| is_unseen(&view, &mesh, **corners)).count()
                        as u64;
            }
        }
        Ok(())
    }
}

/// Whether a triangle turns its back, or all of it lies beyond one side of the picture or behind the eye.
fn is_unseen(view: &View, mesh: &Mesh, corners: [u32; 3]) -> bool {
    let camera = &view.camera;
    let [a, b, c] = corners.map(|at| mesh.vertices()[at as usize].position.as_dvec3() - camera.eye());
    let aspect = f64::from(view.size[0]) / f64::from(view.size[1]);
    let places = [a, b, c].map(|at| {
        let depth = camera.forward().dot(at);
        let half = camera.half_height() * depth;
        [camera.right().dot(at), camera.up().dot(at), depth, half * aspect, half]
    });
    let beyond = |is: fn(&[f64; 5]) -> bool| places.iter().all(is);
    (b - a).cross(c - a).dot(-a) <= 0.0
        || beyond(|[x, _, _, wide, _]| x > wide)
        || beyond(|[x, _, _, wide, _]| -x > *wide)
        || beyond(|[_, y, _, _, tall]| y > tall)
        || beyond(|[_, y, _, _, tall]| -y > *tall)
        || beyond(|[_, _, depth, ..]| *depth <= 0.0)
}
