//! An object that is known in closed form: some spheres, seen by parallel rays from around.

use glam::DVec3;
use relief_core::camera::Ray;
use relief_core::object::{GridMapping, ImageObject, JumpCells, View};
use relief_core::{HeightMap, Wrap};

/// Spheres: centres and radii in metres.
pub const SPHERES: [(DVec3, f64); 4] = [
    (DVec3::new(0.0, -0.15, 0.0), 0.5),
    (DVec3::new(0.1, 0.5, 0.1), 0.3),
    (DVec3::new(-0.6, 0.1, 0.3), 0.25),
    (DVec3::new(0.45, -0.3, -0.5), 0.3),
];

/// The radius of the ball that the images show.
pub const RADIUS: f64 = 1.0;

/// The directions that the images of a cube look from.
pub const CUBE: [DVec3; 6] = [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y, DVec3::Z, DVec3::NEG_Z];

/// The first point of a ray on the spheres.
pub fn first_on_spheres(ray: &Ray) -> Option<f64> {
    let hits = SPHERES.iter().filter_map(|(centre, radius)| {
        let (to, along) = (ray.origin - *centre, ray.direction);
        let (a, b, c) = (along.length_squared(), to.dot(along), to.length_squared() - radius * radius);
        let root = b * b - a * c;
        (root >= 0.0).then(|| (-b - root.sqrt()) / a).filter(|t| *t >= 0.0)
    });
    hits.min_by(f64::total_cmp)
}

/// The unit normal of the sphere that a point lies nearest to.
pub fn normal_on_spheres(point: DVec3) -> DVec3 {
    let off = |(centre, radius): &&(DVec3, f64)| ((point - *centre).length() - radius).abs();
    let nearest = SPHERES.iter().min_by(|one, other| off(one).total_cmp(&off(other)));
    nearest.map_or(DVec3::Y, |(centre, _)| (point - *centre).normalize())
}

/// Image of the spheres in a view.
pub fn map_of_spheres(view: &View) -> HeightMap {
    let [columns, rows] = view.size();
    let map = HeightMap::from_fn(columns, rows, Wrap::Clamp, |x, y| {
        let [u, v] = [(x, columns), (y, rows)].map(|(at, side)| (f64::from(at) + 0.5) / f64::from(side));
        let ray = view.ray(u, v);
        let seen = first_on_spheres(&ray).and_then(|t| view.see(ray.at(t)));
        seen.map_or(0.0, |seen| seen.z.clamp(0.0, 1.0) as f32)
    });
    map.expect("a map")
}

/// Orthographic views of the spheres from these directions, with the given texels a side, and their images.
pub fn views_of_spheres(directions: &[DVec3], side: u32) -> (Vec<View>, Vec<HeightMap>) {
    let view = |from: &DVec3| {
        let view = View::orthographic(DVec3::ZERO, RADIUS, *from, None, [side, side]).expect("a view");
        let map = map_of_spheres(&view);
        (view, map)
    };
    directions.iter().map(view).unzip()
}

/// Views from eyes at the given distance in metres, into which the spheres fit. Every other view is
/// orthographic.
pub fn eyes_on_spheres(directions: &[DVec3], away_m: f64, side: u32) -> (Vec<View>, Vec<HeightMap>) {
    let fov = 2.0 * (RADIUS / away_m).asin().to_degrees();
    let view = |(place, from): (usize, &DVec3)| {
        let size = [side, side];
        let view = match place % 2 {
            0 => View::perspective(DVec3::ZERO, RADIUS, *from * away_m, None, fov, size),
            _ => View::orthographic(DVec3::ZERO, RADIUS, *from, None, size),
        };
        let view = view.expect("a view");
        let map = map_of_spheres(&view);
        (view, map)
    };
    directions.iter().enumerate().map(view).unzip()
}

/// The object of images by parallel rays.
pub fn object_of_spheres(directions: &[DVec3], side: u32, cells: JumpCells) -> ImageObject {
    let (views, maps) = views_of_spheres(directions, side);
    ImageObject::new(views, &maps, cells, 4.0).expect("an object")
}

/// Views of a grid with the given frames a side.
pub fn grid_of_spheres(mapping: GridMapping, frames: u32, side: u32) -> ImageObject {
    let part = |at: u32| f64::from(at) / f64::from(frames - 1);
    let from = |at: u32| mapping.direction([part(at % frames), part(at / frames)]);
    let directions: Vec<DVec3> = (0..frames * frames).map(from).collect();
    object_of_spheres(&directions, side, JumpCells::Highest)
}
