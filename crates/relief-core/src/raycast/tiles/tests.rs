use super::*;
use crate::camera::{Camera, Projection};
use crate::mesh::{Mesh, cube, rectangle, sphere, torus};

/// Rays of a camera's picture.
fn rays_of(camera: &Camera, [width, height]: [u32; 2]) -> PictureRays {
    let at = |x, y| camera.ray(x, y, width, height);
    let [first, right, down] = [at(0, 0), at(1, 0), at(0, 1)];
    let steps = |of: fn(&Ray) -> DVec3| {
        let (right, down) = (of(&right) - of(&first), of(&down) - of(&first));
        [of(&first) - (right + down) * 0.5, right, down].map(|along| along.as_vec3())
    };
    PictureRays { origin: steps(|ray| ray.origin), direction: steps(|ray| ray.direction) }
}

fn perspective(eye: [f64; 3], target: [f64; 3], fov_degrees: f64) -> Camera {
    Camera::new(eye.into(), target.into(), fov_degrees).expect("a proper camera")
}

fn orthographic(eye: [f64; 3], target: [f64; 3], height_m: f64) -> Camera {
    let projection = Projection::Orthographic { height_m };
    Camera::with(eye.into(), target.into(), projection).expect("a proper camera")
}

/// Division of a picture into areas.
#[derive(Clone, Copy)]
struct Way<'a> {
    size: [u32; 2],
    /// Rows of an area.
    rows: u32,
    offsets: &'a [[f32; 2]],
}

/// Offsets from the corner and the middle of a pixel to its end, without symmetry.
const OFFSETS: [[f32; 2]; 3] = [[0.0; 2], [-0.49, 0.3], [0.45, -0.13]];

impl Way<'_> {
    const PLAIN: Way<'static> = Way { size: [161, 90], rows: 24, offsets: &[[0.0; 2]] };

    /// Least and greatest offset.
    fn reach(&self) -> [[f32; 2]; 2] {
        let of = |by: fn(f32, f32) -> f32, none: f32| {
            [0, 1].map(|axis| self.offsets.iter().map(|offset| offset[axis]).fold(none, by))
        };
        [of(f32::min, f32::INFINITY), of(f32::max, f32::NEG_INFINITY)]
    }
}

/// Counts of a comparison.
#[derive(Clone, Copy, Debug, Default)]
struct Compared {
    rays: u64,
    hits: u64,
    /// Rays whose hits are not all the same, in the same order.
    differing: u64,
    /// Rays of tiles that were cast one by one.
    one_by_one: u64,
}

impl Compared {
    fn add(&mut self, other: Self) {
        self.rays += other.rays;
        self.hits += other.hits;
        self.differing += other.differing;
        self.one_by_one += other.one_by_one;
    }
}

/// Compares all hits of a picture's rays with the hits from the BVH. `change` and `change_bins` may
/// alter the caster and the bins first.
fn compared_with(
    caster: &RayCaster,
    rays: PictureRays,
    sides: Sides,
    lanes: Lanes,
    way: Way,
    change: &dyn Fn(&mut TileCaster),
    change_bins: &dyn Fn(&mut Bins),
) -> Compared {
    let mut tiles = TileCaster::new(caster, rays, way.size, sides, lanes);
    change(&mut tiles);
    let mut compared = Compared::default();
    let (mut bins, mut hits) = (Bins::new(), TileHits::new());
    let bits = |t: f64, triangle: u32, front: bool| (t.to_bits(), triangle, front);
    for first in (0..way.size[1]).step_by(way.rows as usize) {
        let rows = way.rows.min(way.size[1] - first);
        tiles.bin(Area { first: [0, first], size: [way.size[0], rows] }, way.reach(), &mut bins);
        change_bins(&mut bins);
        let [across, down] = bins.area().tiles();
        for number in 0..across * down {
            let tile = [number % across, number / across];
            for offset in way.offsets {
                tiles.cast(&bins, tile, *offset, &mut hits);
                for point in 0..TILE_POINTS {
                    let [x, y] = bins.area().pixel(tile);
                    let pixel = [x + (point % TILE) as u32, y + (point / TILE) as u32];
                    if pixel[0] >= way.size[0] || pixel[1] >= first + rows {
                        continue;
                    }
                    let ray = rays.ray(PictureRays::point(pixel, *offset));
                    let expected = caster.hits(&ray, sides).map(|hit| bits(hit.t, hit.triangle, hit.front));
                    let expected: Vec<_> = expected.collect();
                    let found = tiles.hits(&hits, point);
                    let is_same =
                        found.map(|hit| bits(hit.t, hit.triangle, hit.front)).eq(expected.iter().copied());
                    compared.add(Compared {
                        rays: 1,
                        hits: expected.len() as u64,
                        differing: u64::from(!is_same),
                        one_by_one: u64::from(hits.one_by_one),
                    });
                    assert!(!(is_same && hits.is_miss(point) && !expected.is_empty()), "no miss");
                }
            }
        }
    }
    compared
}

/// Fails unless all hits in all widths are equal to the hits from the BVH.
fn agree(mesh: &Mesh, camera: &Camera, way: Way) -> Compared {
    let caster = RayCaster::new(mesh);
    let rays = rays_of(camera, way.size);
    let mut all = Compared::default();
    for sides in [Sides::Front, Sides::Both] {
        for lanes in Lanes::available().filter(|lanes| *lanes != Lanes::One) {
            let compared = compared_with(&caster, rays, sides, lanes, way, &|_| {}, &|_| {});
            assert_eq!(compared.differing, 0, "{camera:?}, {sides:?}, {lanes} lanes: {compared:?}");
            all.add(compared);
        }
    }
    all
}

/// Pseudo-random numbers from -1 to 1.
fn noise(seed: u32) -> impl FnMut() -> f32 {
    let mut state = u64::from(seed) ^ 0x9e37_79b9_7f4a_7c15;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f32 / (1u32 << 23) as f32 - 1.0
    }
}

/// Scattered triangles of all sizes: slivers, triangles without area, and duplicates.
fn soup(seed: u32, count: usize) -> Vec<[Vec3; 3]> {
    let mut next = noise(seed);
    let mut point = move |size: f32| Vec3::new(next() * size, next() * size, next() * size);
    let mut triangles: Vec<[Vec3; 3]> = Vec::new();
    for number in 0..count {
        let a = point(1.0);
        let size = 10f32.powi(-((number % 4) as i32));
        let (b, c) = (a + point(size), a + point(size));
        triangles.push(match number % 16 {
            // A sliver, an edge, a point, and a triangle on a line.
            3 => [a, b, b + point(1e-6)],
            7 => [a, b, b],
            9 => [a, a, a],
            11 => [a, b, a + (b - a) * 0.5],
            13 => triangles[number / 2],
            // A triangle in a plane across an axis.
            15 => [a, Vec3::new(b.x, b.y, a.z), Vec3::new(c.x, c.y, a.z)],
            _ => [a, b, c],
        });
    }
    triangles
}

fn agree_on_soup(triangles: &[[Vec3; 3]], camera: &Camera, way: Way) -> Compared {
    let caster = RayCaster::of_corners(triangles.iter().copied());
    let mut all = Compared::default();
    for sides in [Sides::Front, Sides::Both] {
        for lanes in Lanes::available() {
            let rays = rays_of(camera, way.size);
            let compared = compared_with(&caster, rays, sides, lanes, way, &|_| {}, &|_| {});
            assert_eq!(compared.differing, 0, "{camera:?}, {sides:?}, {lanes} lanes: {compared:?}");
            all.add(compared);
        }
    }
    all
}

#[test]
fn built_in_meshes_are_hit_as_by_the_hierarchy() {
    let meshes =
        [rectangle([1.0, 0.7], 1), rectangle([1.0, 0.7], 64), sphere(96, 48), torus(96, 48), cube(7)];
    let cameras = [
        perspective([0.3, 0.9, 1.2], [0.0; 3], 45.0),
        // Views along an axis, with edges through the middles of pixels, and very near to a plane.
        perspective([0.0, 0.0, 2.0], [0.0; 3], 30.0),
        perspective([0.0, 1.5, 0.0], [0.0; 3], 60.0),
        perspective([0.4, 0.05, 0.3], [-0.5, 0.0, -0.4], 70.0),
        // A view so wide that directions are longest along several axes.
        perspective([0.1, 0.2, 0.05], [-0.5, 0.0, -0.4], 150.0),
        orthographic([1.0, 1.5, 0.6], [0.0; 3], 1.3),
        orthographic([0.0, 0.0, 3.0], [0.0; 3], 1.0),
    ];
    let mut all = Compared::default();
    for mesh in meshes {
        let mesh = mesh.expect("divisions in range");
        for camera in &cameras {
            all.add(agree(&mesh, camera, Way::PLAIN));
        }
        let way = Way { offsets: &OFFSETS, ..Way::PLAIN };
        all.add(agree(&mesh, &cameras[0], way));
        all.add(agree(&mesh, &cameras[5], way));
    }
    // Each available width except one casts all rays.
    let widths = Lanes::available().count() as u64 - 1;
    if widths > 0 {
        assert!(all.rays > 1_500_000 * widths && all.hits > 700_000 * widths, "{all:?}");
        assert!(all.one_by_one * 5 < all.rays, "{all:?}");
    }
}

#[test]
fn pictures_of_any_size_and_any_bands_are_cast() {
    let mesh = sphere(24, 16).expect("divisions in range");
    let camera = perspective([0.3, 0.9, 1.2], [0.0; 3], 45.0);
    for size in [[1, 1], [7, 13], [8, 8], [9, 64], [64, 9], [65, 33]] {
        for rows in [1, 3, 8, 11, 64] {
            agree(&mesh, &camera, Way { size, rows, offsets: &OFFSETS });
        }
    }
}

#[test]
fn the_eye_may_be_anywhere_in_or_on_the_mesh() {
    let way = Way { size: [81, 60], rows: 17, offsets: &OFFSETS[..2] };
    let plane = rectangle([1.0, 1.0], 8).expect("divisions in range");
    // The eye is in a triangle, on an edge or at a corner, and looks along the plane or at it.
    for at in [[0.03, 0.0, 0.01], [0.0625, 0.0, 0.0625], [0.0, 0.0, 0.0], [0.1, 0.0, 0.125]] {
        for target in [[0.5, 0.0, 0.2], [0.1, -1.0, 0.1], [0.7, 0.2, 0.0]] {
            agree(&plane, &perspective(at, target, 80.0), way);
            agree(&plane, &orthographic(at, target, 0.8), way);
        }
    }
    for mesh in [cube(3), sphere(24, 16), torus(24, 16)] {
        let mesh = mesh.expect("divisions in range");
        for at in [[0.0; 3], [0.1, -0.17, 0.23], [0.5, 0.0, 0.0], [0.5, 0.5, 0.5], [0.0, 0.5, 1e-9]] {
            for target in [[0.3, 1.0, -0.7], [-1.0, 0.01, 0.02]] {
                agree(&mesh, &perspective(at, target, 100.0), way);
            }
        }
    }
}

#[test]
fn strewn_triangles_are_hit_as_by_the_hierarchy() {
    let way = Way { size: [57, 43], rows: 16, offsets: &OFFSETS[..2] };
    let mut all = Compared::default();
    for seed in 0..12u32 {
        let triangles = soup(seed, 300);
        let mut next = noise(seed + 1000);
        let mut place = |size: f64| [f64::from(next()) * size, f64::from(next()) * size, f64::from(next())];
        // Views from amid the triangles, so that some are behind and around the eye; from afar; and
        // at a corner of one.
        let corner = triangles[0][1].as_dvec3().to_array();
        let cameras = [
            perspective(place(0.7), place(0.7), 75.0),
            perspective(place(4.0), place(0.2), 50.0),
            perspective(corner, place(0.2), 60.0),
            orthographic(place(1.0), place(1.0), 1.5),
            orthographic(place(9.0), place(0.1), 2.0),
        ];
        for camera in cameras {
            all.add(agree_on_soup(&triangles, &camera, way));
        }
    }
    assert!(all.rays > 800_000 && all.hits > 1_000_000, "{all:?}");
}

#[test]
fn edges_and_corners_in_the_middle_of_pixels_are_met_as_by_the_hierarchy() {
    // The corners lie at whole and half pixels, in exact numbers.
    let triangles: Vec<[Vec3; 3]> = (0..16u32)
        .flat_map(|number| {
            let [x, y] = [(number % 4) as f32 * 4.0 - 8.0, (number / 4) as f32 * 4.0 - 8.0];
            let at = |dx: f32, dy: f32| Vec3::new(x + dx + 0.5, y + dy + 0.5, 0.0);
            [[at(0.0, 0.0), at(4.0, 0.0), at(4.0, 4.0)], [at(0.0, 0.0), at(4.0, 4.0), at(0.0, 4.0)]]
        })
        .collect();
    let way = Way { size: [24, 24], rows: 8, offsets: &[[0.0; 2], [0.5, 0.5], [0.25, -0.25]] };
    for height in [12.0, 24.0, 48.0] {
        agree_on_soup(&triangles, &orthographic([0.0, 0.0, 16.0], [0.0; 3], height), way);
    }
    agree_on_soup(&triangles, &perspective([0.0, 0.0, 12.0], [0.0; 3], 90.0), way);
}

#[test]
fn views_that_are_none_are_cast_one_by_one() {
    let mesh = sphere(24, 16).expect("divisions in range");
    let caster = RayCaster::new(&mesh);
    let camera = perspective([0.3, 0.9, 1.2], [0.0; 3], 45.0);
    let way = Way { size: [24, 24], ..Way::PLAIN };
    let plain = rays_of(&camera, way.size);
    // Rays without a direction, equal rays, rays with different origins and ends, and a view so
    // narrow that single precision does not distinguish its pixels.
    let nothing = PictureRays { direction: [Vec3::ZERO; 3], ..plain };
    let not_finite = PictureRays { direction: plain.direction.map(|along| along * f32::NAN), ..plain };
    let same = PictureRays { direction: [plain.direction[0], Vec3::ZERO, Vec3::ZERO], ..plain };
    let both = PictureRays { origin: [plain.origin[0], Vec3::X * 0.01, Vec3::Y * 0.01], ..plain };
    let narrow = rays_of(&perspective([0.3, 0.9, 1.2], [0.0; 3], 1e-6), way.size);
    let far = rays_of(&orthographic([1e7, 1e7, 1e7], [0.0; 3], 1.0), way.size);
    for rays in [nothing, not_finite, same, both, narrow, far] {
        for lanes in Lanes::available() {
            let compared = compared_with(&caster, rays, Sides::Both, lanes, way, &|_| {}, &|_| {});
            assert_eq!((compared.differing, compared.one_by_one), (0, compared.rays), "{rays:?}");
        }
    }
}

#[test]
fn tiles_with_very_many_triangles_are_cast_one_by_one() {
    // Many triangles all over a picture, and in a spot of it.
    for (around, down, size, distance) in [(512, 256, [24, 24], 1.5), (128, 64, [400, 16], 4.0)] {
        let mesh = sphere(around, down).expect("divisions in range");
        let caster = RayCaster::new(&mesh);
        let camera = perspective([0.0, 0.3, distance], [0.0; 3], 45.0);
        let way = Way { size, rows: 64, offsets: &OFFSETS };
        for lanes in Lanes::available() {
            let rays = rays_of(&camera, size);
            let compared = compared_with(&caster, rays, Sides::Front, lanes, way, &|_| {}, &|_| {});
            assert!(compared.differing == 0 && compared.one_by_one > 0, "{compared:?}");
            let mut bins = Bins::new();
            let tiles = TileCaster::new(&caster, rays, size, Sides::Front, lanes);
            let area = Area { first: [0, 0], size };
            tiles.bin(area, way.reach(), &mut bins);
            let tiles = area.tiles().map(|side| side as usize);
            assert!(bins.bytes() <= tiles[0] * tiles[1] * Bins::MOST_BYTES_PER_TILE, "{}", bins.bytes());
        }
    }
}

#[test]
fn bins_that_are_not_grown_and_triangles_left_out_are_noticed() {
    let mesh = sphere(96, 48).expect("divisions in range");
    let caster = RayCaster::new(&mesh);
    let camera = perspective([0.3, 0.9, 1.2], [0.0; 3], 45.0);
    let rays = rays_of(&camera, Way::PLAIN.size);
    let in_the_middle = rays.ray([80.5, 45.5]);
    let seen = caster.next_hit(&in_the_middle, Sides::Front, None).expect("a hit").triangle;
    for lanes in Lanes::available().filter(|lanes| *lanes != Lanes::One) {
        let with = |change: &dyn Fn(&mut TileCaster), change_bins: &dyn Fn(&mut Bins)| {
            compared_with(&caster, rays, Sides::Front, lanes, Way::PLAIN, change, change_bins).differing
        };
        assert_eq!(with(&|_| {}, &|_| {}), 0);
        assert!(with(&|_| {}, &|bins| bins.forget(seen)) > 0);
        let shrink = |tiles: &mut TileCaster| {
            if let Some(view) = &mut tiles.view {
                view.grow(-0.25);
            }
        };
        assert!(with(&shrink, &|_| {}) > 0);
        let other_sides = |tiles: &mut TileCaster| tiles.sides = Sides::Both;
        assert!(with(&other_sides, &|_| {}) > 0);
    }
}
