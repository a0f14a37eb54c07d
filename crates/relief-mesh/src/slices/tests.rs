use std::collections::HashMap;
use std::sync::atomic::AtomicBool;

use relief_core::camera::{Camera, Projection};
use relief_core::mesh::{cube, square, torus};
use relief_core::raycast::{RayCaster, Sides, SurfaceHit};
use relief_core::{Cancelled, Wrap};

use super::*;

fn map(scale_m: f64, bias_m: f64) -> HeightMap {
    let map = HeightMap::from_fn(8, 8, Wrap::Repeat, |i, _| i as f32 / 7.0).expect("a map");
    map.with_displacement(scale_m, bias_m).expect("lengths")
}

fn camera() -> Camera {
    Camera::new(DVec3::new(0.7, 0.9, 1.6), DVec3::ZERO, 40.0).expect("a camera")
}

fn slicer<'a>(base: &'a Mesh, map: &HeightMap, count: u32, direction: SliceDirection) -> Slicer<'a> {
    Slicer::new(base, map, SliceSettings { count, direction }).expect("slices")
}

fn blocks(slicer: &Slicer) -> Vec<SliceBlock> {
    let mut blocks = Vec::new();
    slicer.each(&Watch::none(), |block| blocks.push(block.clone())).expect("slices");
    let count = |of: fn(&SliceBlock) -> usize| blocks.iter().map(of).sum::<usize>() as u64;
    assert!(count(|block| block.vertices.len()) <= slicer.vertices());
    assert!(count(|block| block.triangles.len()) <= slicer.triangles());
    blocks
}

/// Returns the position of the base under a corner.
fn below(corner: &SliceVertex, map: &HeightMap) -> DVec3 {
    let metres = map.bias_m() + map.scale_m() * f64::from(corner.height);
    corner.vertex.position.as_dvec3() - corner.vertex.normal.as_dvec3() * metres
}

#[test]
fn slices_of_the_surface_lie_at_equal_heights_down_to_the_floor() {
    let (base, map) = (torus(12, 8).expect("a mesh"), map(0.03, -0.01));
    let slicer = slicer(&base, &map, 5, SliceDirection::Surface);
    let blocks = blocks(&slicer);
    let heights: Vec<f32> = blocks.iter().map(|block| block.vertices[0].height).collect();
    assert_eq!(heights, [0.8, 0.6, 0.4, 0.2, 0.0].map(|height: f64| height as f32));
    for block in &blocks {
        for (corner, of_base) in block.vertices.iter().zip(base.vertices()) {
            let out = of_base.normal.dot(corner.vertex.position - of_base.position);
            assert!((out - (0.03 * corner.height - 0.01)).abs() < 1e-7, "{out} {}", corner.height);
        }
        assert_eq!(block.triangles, base.triangles());
    }
    assert_eq!(slicer.vertices(), 5 * base.vertices().len() as u64);
}

#[test]
fn upright_slices_lie_at_equal_u_or_v_from_the_floor_to_the_top_and_meet() {
    let (base, map) = (torus(12, 8).expect("a mesh"), map(0.03, -0.01));
    for (direction, axis) in [(SliceDirection::AcrossU, 0), (SliceDirection::AcrossV, 1)] {
        let slicer = slicer(&base, &map, 7, direction);
        let step = 0.03 / 7.0 / base.tile_m()[axis];
        let mut ends: HashMap<[u32; 3], u32> = HashMap::new();
        let mut seen = 0;
        for block in blocks(&slicer) {
            for quad in block.vertices.chunks(4) {
                let lines = quad.iter().map(|corner| f64::from(corner.vertex.uv[axis]) / step);
                for line in lines {
                    assert!((line - line.round()).abs() < 1e-3, "{line}");
                }
                assert_eq!([0, 1, 2, 3].map(|at: usize| quad[at].height), [0.0, 0.0, 1.0, 1.0]);
                for corner in &quad[..2] {
                    let place = corner.vertex.position.to_array().map(f32::to_bits);
                    *ends.entry(place).or_default() += 1;
                }
                seen += 1;
            }
        }
        // On a closed mesh each line goes on in the next triangle, from the same point. At the seam it
        // may not.
        let open = ends.values().filter(|count| **count % 2 == 1).count();
        assert!(seen > 1000 && open * 50 < ends.len(), "{seen} slices, {open} of {} ends", ends.len());
    }
}

#[test]
fn slices_of_the_screen_lie_at_equal_depths_in_the_space_over_their_triangle() {
    let (base, map, camera) = (torus(12, 8).expect("a mesh"), map(0.3, -0.1), camera());
    for anchor in [SliceAnchor::Eye, SliceAnchor::Object] {
        let slicer = slicer(&base, &map, 9, SliceDirection::Screen(camera, anchor));
        let depth = |point: DVec3| camera.forward().dot(point - camera.eye());
        let start = if anchor == SliceAnchor::Eye { 0.0 } else { depth(DVec3::ZERO) };
        let mut area = 0.0;
        for block in blocks(&slicer) {
            for corner in &block.vertices {
                let plane = (depth(corner.vertex.position.as_dvec3()) - start) / (0.3 / 9.0);
                assert!((plane - plane.round()).abs() < 1e-4, "{plane}");
                assert!((-1e-6..=1.0 + 1e-6).contains(&corner.height), "{}", corner.height);
                assert!(below(corner, &map).is_finite());
            }
            for triangle in &block.triangles {
                let [a, b, c] = triangle.map(|at| block.vertices[at as usize].vertex.position.as_dvec3());
                area += 0.5 * (b - a).cross(c - a).length();
            }
        }
        // The area of the slices, times their distance, is about the volume of the space.
        let volume = area * 0.3 / 9.0;
        let [mut expected, flat] = [0.0, 0.4];
        for number in 0..base.triangles().len() as u32 {
            let [a, b, c] = base.corners(number).map(|corner| corner.position.as_dvec3());
            let normal = base.corners(number)[0].normal.as_dvec3();
            expected += 0.3 * 0.5 * (b - a).cross(c - a).dot(normal).abs();
        }
        assert!((volume / expected - 1.0).abs() < flat, "{volume} of {expected}");
    }
}

#[test]
fn quads_lie_at_equal_depths_around_what_a_border_clips() {
    let (map, camera) = (map(0.3, -0.1).with_wrap(Wrap::Clamp), camera());
    for (base, polygons) in [(square(1), 1), (square(3), 1), (cube(1), 6)] {
        let base = base.expect("a mesh");
        let slicer = slicer(&base, &map, 9, SliceDirection::Quads(camera, SliceAnchor::Eye));
        let blocks = blocks(&slicer);
        assert_eq!(blocks.len(), polygons);
        for block in &blocks {
            assert_eq!(block.vertices.len() as u64 * blocks.len() as u64 % 4, 0);
            let sides = |quad: &[SliceVertex]| {
                [1, 3].map(|at: usize| quad[0].vertex.position.distance(quad[at].vertex.position))
            };
            let size = sides(&block.vertices[..4]);
            for quad in block.vertices.chunks(4) {
                assert!(sides(quad).iter().zip(size).all(|(a, b)| (a - b).abs() < 1e-5 * b), "of one size");
                for corner in quad {
                    let place = corner.vertex.position.as_dvec3();
                    let plane = camera.forward().dot(place - camera.eye()) / (0.3 / 9.0);
                    assert!((plane - plane.round()).abs() < 1e-4, "{plane}");
                    // The texture coordinates are taken from the point of the plane under it.
                    let (at, of) = (below(corner, &map), &base.vertices()[base.triangles()[0][0] as usize]);
                    if polygons == 1 {
                        let uv = corner.vertex.uv - of.uv;
                        let there = of.position + of.tangent * uv.x + of.bitangent * uv.y;
                        assert!(at.distance(there.as_dvec3()) < 1e-5, "{at} {there}");
                    }
                }
            }
        }
    }
    let refused = |base: Result<Mesh, _>, wrap| {
        let (base, map): (Mesh, HeightMap) = (Result::expect(base, "a mesh"), map.clone().with_wrap(wrap));
        let direction = SliceDirection::Quads(camera, SliceAnchor::Eye);
        Slicer::new(&base, &map, SliceSettings { count: 3, direction }).map(|_| ())
    };
    assert_eq!(refused(torus(12, 8), Wrap::Clamp), Err(SliceError::NoBorder));
    assert_eq!(refused(square(1), Wrap::Repeat), Err(SliceError::NoBorder));
    let tiled = square(1).map(|mesh| mesh.tiled([2.0, 1.0].into()).expect("a mesh"));
    assert_eq!(refused(tiled, Wrap::Clamp), Err(SliceError::NoBorder));
}

#[test]
fn what_faces_the_camera_is_chosen_triangle_by_triangle() {
    let (base, map) = (square(1).expect("a mesh"), map(0.1, 0.0));
    let from = |eye: [f64; 3]| {
        let camera = Camera::new(eye.into(), DVec3::ZERO, 40.0).expect("a camera");
        let blocks = blocks(&slicer(&base, &map, 4, SliceDirection::Facing(camera)));
        blocks.iter().flat_map(|block| &block.vertices).map(|corner| corner.axis).collect::<Vec<_>>()
    };
    for (eye, axis) in [
        ([0.1, 9.0, 0.2], SliceAxis::Height),
        ([9.0, 0.9, 0.1], SliceAxis::U),
        ([0.1, 0.9, 9.0], SliceAxis::V),
    ] {
        let axes = from(eye);
        assert!(!axes.is_empty() && axes.iter().all(|found| *found == axis), "{eye:?}: {axes:?}");
    }
}

#[test]
fn without_a_count_slices_are_a_texel_apart() {
    let (base, map) = (square(1).expect("a mesh"), map(0.5, 0.0));
    let count = |direction| slicer(&base, &map, 0, direction).triangles();
    assert_eq!(count(SliceDirection::Surface), 4 * 2);
    // Lines at 0 to 8 eighths over both triangles, two triangles each.
    assert_eq!(count(SliceDirection::AcrossU), 9 * 2 * 2);
}

#[test]
fn without_a_count_a_ray_goes_at_most_a_texel_aside_from_slice_to_slice() {
    let base = square(1).expect("a mesh");
    let map = HeightMap::new(64, 64, vec![0.5; 64 * 64], Wrap::Repeat).expect("a map");
    let map = map.with_displacement(0.2, -0.2).expect("lengths");
    for eye in [[0.1, 2.0, 0.2], [1.5, 1.4, 0.1], [0.8, 0.9, 1.1], [0.2, 0.3, 2.0]] {
        // In perspective the rays of a triangle differ from the ray of its middle.
        let parallel = Projection::Orthographic { height_m: 0.6 };
        let camera = Camera::with(eye.into(), DVec3::ZERO, parallel).expect("a camera");
        for direction in [SliceDirection::Facing(camera), SliceDirection::Screen(camera, SliceAnchor::Eye)] {
            let slicer = slicer(&base, &map, 0, direction);
            let mut triangles = Vec::new();
            for block in blocks(&slicer) {
                let corners = |triangle: &[u32; 3]| triangle.map(|at| block.vertices[at as usize].vertex);
                triangles.extend(block.triangles.iter().map(corners));
            }
            let of_places = triangles.iter().map(|corners| corners.map(|corner| corner.position));
            let caster = RayCaster::of_corners(of_places);
            let mut steps = 0;
            for pixel in 0..64u32 {
                let ray = camera.ray(pixel % 8, pixel / 8, 8, 8);
                let mut places: Vec<_> = caster.hits(&ray, Sides::Both).collect();
                places.sort_by(|one, other| one.t.total_cmp(&other.t));
                let uv = |hit: &SurfaceHit| {
                    let corners = &triangles[hit.triangle as usize];
                    (0..3).map(|at| corners[at].uv.as_dvec2() * hit.weights[at]).sum::<glam::DVec2>()
                };
                for pair in places.windows(2) {
                    let aside = (uv(&pair[1]) - uv(&pair[0])).abs().max_element() * 64.0;
                    assert!(aside < 1.01, "{eye:?} {direction:?}: {aside}");
                    steps += 1;
                }
            }
            assert!(steps > 200, "{eye:?} {direction:?}: {steps}");
        }
    }
}

#[test]
fn what_cannot_be_sliced_is_refused_and_what_is_cancelled_ends() {
    let base = square(1).expect("a mesh");
    let flat = map(0.0, 0.0);
    let refused = |direction| Slicer::new(&base, &flat, SliceSettings { count: 3, direction }).map(|_| ());
    assert_eq!(refused(SliceDirection::AcrossU), Err(SliceError::NoSpacing));
    assert_eq!(refused(SliceDirection::Screen(camera(), SliceAnchor::Eye)), Err(SliceError::NoSpacing));
    assert_eq!(refused(SliceDirection::Surface), Ok(()));
    let usual = map(0.1, 0.0);
    for direction in [SliceDirection::Surface, SliceDirection::AcrossV, SliceDirection::Facing(camera())] {
        let many = slicer(&base, &usual, 1_000_000_000, direction);
        assert!(many.triangles() > 1_000_000_000, "{direction:?}: {}", many.triangles());
        let cancel = AtomicBool::new(true);
        let stopped = many.each(&Watch::cancelled_by(&cancel), |_| unreachable!("nothing is made"));
        assert_eq!(stopped, Err(SliceError::Cancelled(Cancelled)));
    }
    let far = map(1e39, 0.0);
    let slicer = slicer(&base, &far, 2, SliceDirection::Surface);
    assert_eq!(slicer.each(&Watch::none(), |_| {}), Err(SliceError::NotFinite));
}
