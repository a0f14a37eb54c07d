use std::sync::atomic::AtomicBool;

use glam::{DVec3, DVec4, Vec3};
use relief_core::camera::{Camera, Projection};
use relief_core::mesh::{Builtin, Mesh, Vertex, cube, cylinder, sphere, torus};
use relief_core::raycast::{RayCaster, Sides};
use relief_core::{Cancelled, HeightMap, Watch, Wrap};

use super::*;
use crate::error::MOST;
use crate::interior::{Cut, Fills, Pattern};
use crate::patch::PatchPoint;
use crate::plane::Rectangle;
use crate::triangles::{Inside, PatchBorder};
use crate::{CrackTest, Cull, Directions, Mesher, Outside, Part, Seams, Shading, Stream, View};

const SIZE: [u32; 2] = [96, 72];

/// Returns a map of bumps, with a few needles that coarser levels lack.
fn rough(wrap: Wrap, scale_m: f64) -> HeightMap {
    let map = HeightMap::from_fn(48, 40, wrap, |i, j| {
        let waves = (i as f32 * 0.7).sin() * (j as f32 * 0.5).cos() * 0.25 + 0.4;
        if (i * 7 + j * 13) % 61 == 0 { 1.0 } else { waves }
    });
    map.expect("heights from 0 to 1").with_displacement(scale_m, -scale_m / 3.0).expect("lengths")
}

/// Returns cameras around the origin: beside the mesh, within its relief, and close to it.
fn cameras() -> Vec<Camera> {
    let perspective = |fov_degrees| Projection::Perspective { fov_degrees };
    let parallel = |height_m| Projection::Orthographic { height_m };
    [
        ([0.7, 1.0, 1.3], [0.0, 0.0, 0.0], perspective(40.0)),
        ([0.3, 0.4, 0.9], [0.3, 0.1, 0.2], perspective(15.0)),
        ([0.9, -0.6, -1.1], [0.2, 0.1, 0.0], perspective(30.0)),
        ([0.35, 0.02, 0.3], [0.9, 0.0, -0.4], perspective(60.0)),
        ([0.0, 0.001, 0.5], [0.3, 0.0, 0.1], perspective(90.0)),
        ([0.0, 2.0, 0.1], [0.0, 0.0, 0.0], perspective(6.0)),
        ([0.0, 3.0, 0.0], [0.1, 6.0, 0.0], perspective(40.0)),
        ([1.0, 1.0, 1.0], [0.2, 0.0, 0.1], parallel(0.5)),
        ([0.1, 0.3, -2.0], [0.0, 0.3, 0.0], parallel(0.9)),
        ([0.0, -1.0, 0.0], [0.0, 0.0, 0.05], parallel(1.5)),
    ]
    .map(|(eye, target, projection)| {
        Camera::with(DVec3::from(eye), DVec3::from(target), projection).expect("a camera")
    })
    .to_vec()
}

/// A base, a relief and a view of them.
struct Case {
    what: String,
    mesh: Mesh,
    map: HeightMap,
    relief: Relief,
    settings: MeshSettings,
}

impl Case {
    fn pattern(&self) -> Pattern {
        match self.settings.interior.fills {
            Fills::Patch(pattern) => pattern,
            Fills::Ground(_) => panic!("patterns alone are for views"),
        }
    }

    /// Returns all patches, including the ones left out.
    fn whole(&self) -> Triangles {
        let settings = MeshSettings { cull: Some(Cull::default()), ..self.settings };
        let made = Triangles::new(&self.mesh, &self.relief, &settings, MOST, &Watch::none());
        made.expect("patches")
    }

    fn view(&self) -> View {
        self.settings.view.expect("it has a view")
    }

    /// Returns the numbers of the remaining patches.
    fn remaining(&self, outside: Outside) -> Vec<u32> {
        let settings = MeshSettings { cull: Some(Cull { outside, backs: true }), ..self.settings };
        let mut whole = self.whole();
        // Parts of a triangle are distinct.
        whole.whole = (0..whole.count()).collect();
        let culled = whole.culled(&self.relief, &settings, &Watch::none());
        culled.expect("patches").whole
    }

    fn mesher(&self, cull: Option<Cull>) -> Mesher {
        let coarser: Vec<HeightMap> = self.relief.levels().skip(1).cloned().collect();
        let settings = MeshSettings { cull, ..self.settings };
        let mesher = Mesher::with_levels(&self.mesh, &self.map, &coarser, &settings, &Watch::none());
        mesher.expect("a mesh")
    }

    /// Returns the triangles of each patch.
    fn triangles(&self) -> Vec<Vec<[DVec3; 3]>> {
        let (base, pattern) = (self.whole(), self.pattern());
        let of_patch = |patch: u32| {
            let (shape, mut cut) = (base.patch(patch), Cut::default());
            (pattern.cut)(&shape, 0..(pattern.steps)(&shape), 0, &mut cut);
            let border = PatchBorder::new(&base, &self.relief, patch);
            let inside = Inside::new(&base, patch);
            let position = |at: u32| match cut.points[at as usize] {
                PatchPoint::Border { side, at } => border.point(side, at).1,
                PatchPoint::Inner { weights, .. } => inside.position(&self.relief, weights),
            };
            cut.triangles.iter().map(|corners| corners.map(|at| position(at).as_dvec3())).collect()
        };
        (0..base.count()).into_par_iter().map(of_patch).collect()
    }
}

fn cases() -> Vec<Case> {
    let bases = [
        ("torus", torus(16, 8)),
        ("fine torus", torus(48, 24)),
        ("sphere", sphere(14, 8)),
        ("cube", cube(3)),
        ("cylinder", cylinder(12, 3)),
        ("plane", Builtin::Plane.build([1.2, 0.9])),
        ("tiles", Builtin::Plane.build([1.2, 0.9])),
    ];
    let mut cases = Vec::new();
    for (b, (name, mesh)) in bases.into_iter().enumerate() {
        let mesh = mesh.expect("a mesh");
        for (c, camera) in cameras().into_iter().enumerate() {
            let at = b + c;
            let map = rough(Wrap::ALL[at % Wrap::ALL.len()], [0.15, 0.02, 0.1][c % 3]);
            let (mesh, map) = match name {
                // Many texels give more than one tile.
                "tiles" => {
                    let map = HeightMap::from_fn(700, 500, Wrap::Clamp, |i, j| {
                        map.height_at_place(f64::from(i) / 9.0, f64::from(j) / 9.0) as f32
                    });
                    (mesh.clone(), map.expect("heights").with_displacement(0.1, -0.03).expect("lengths"))
                }
                _ => (mesh.clone(), map),
            };
            // Bases that reach behind the eye have few points there.
            let view = View { pixels: [2.0, 5.0][c % 2], near_m: 0.1, ..View::new(camera, SIZE) };
            let settings = MeshSettings {
                base: BaseSurface::ALL[at % 5 % 3],
                directions: Directions::ALL[if at % 7 == 3 { 1 + at / 7 % 2 } else { 0 }],
                seams: Seams::ALL[usize::from(at % 4 == 1)],
                ..MeshSettings::seen_by(view)
            };
            let coarser: Vec<HeightMap> =
                if at % 3 == 1 { (1..map.levels()).map(|k| map.level(k)).collect() } else { Vec::new() };
            let relief = Relief::new(&map, settings.directions, settings.shading).with_levels(&coarser);
            let mesh = match Rectangle::of_mesh(&mesh) {
                Some(plane) => plane.tiles(&relief, Part::WHOLE).expect("tiles"),
                None => mesh,
            };
            let what = format!("{name}, camera {c}, {}, {}", settings.base, settings.directions);
            cases.push(Case { what, mesh, map, relief, settings });
        }
    }
    cases
}

/// Returns whether any part of a triangle is in the picture, by clipping at each plane of clip
/// space.
fn is_in_picture(view: &View, corners: [DVec3; 3]) -> bool {
    let camera = &view.camera;
    let [width, height] = view.size.map(f64::from);
    let place = |point: DVec3| {
        let from_eye = point - camera.eye();
        let depth = camera.forward().dot(from_eye);
        let w = if camera.is_orthographic() { 1.0 } else { depth };
        let half = camera.half_height();
        let (x, y) = (camera.right().dot(from_eye) * height / width / half, camera.up().dot(from_eye) / half);
        DVec4::new(x, y, depth, w)
    };
    let mut polygon: Vec<DVec4> = corners.map(place).to_vec();
    let planes: [fn(DVec4) -> f64; 5] = [|p| p.w - p.x, |p| p.w + p.x, |p| p.w - p.y, |p| p.w + p.y, |p| p.z];
    for inside in planes {
        let mut rest = Vec::new();
        for (k, &to) in polygon.iter().enumerate() {
            let from = polygon[(k + polygon.len() - 1) % polygon.len()];
            let (a, b) = (inside(from), inside(to));
            if (a < 0.0) != (b < 0.0) {
                rest.push(from + (to - from) * (a / (a - b)));
            }
            if b >= 0.0 {
                rest.push(to);
            }
        }
        polygon = rest;
    }
    !polygon.is_empty()
}

fn is_front(view: &View, [a, b, c]: [DVec3; 3]) -> bool {
    let camera = &view.camera;
    let toward = if camera.is_orthographic() { -camera.forward() } else { camera.eye() - a };
    (b - a).cross(c - a).dot(toward) > 0.0
}

/// Numbers of items that are left out though visible, left out, and not visible.
#[derive(Clone, Copy, Debug, Default)]
struct Tally {
    seen: usize,
    out: usize,
    unseen: usize,
}

impl Tally {
    fn add(&mut self, is_out: bool, is_seen: bool) {
        self.seen += usize::from(is_out && is_seen);
        self.out += usize::from(is_out);
        self.unseen += usize::from(!is_seen);
    }
}

const CHOICES: [Cull; 3] = [
    Cull { outside: Outside::ALL, backs: false },
    Cull { outside: Outside::NOTHING, backs: true },
    Cull { outside: Outside::ALL, backs: true },
];

/// Returns whether brute force sees any triangle.
fn sees(view: &View, cull: Cull, triangles: &[[DVec3; 3]]) -> bool {
    triangles.iter().any(|corners| {
        (cull.outside == Outside::NOTHING || is_in_picture(view, *corners))
            && (!cull.backs || is_front(view, *corners))
    })
}

#[test]
fn no_visible_patch_is_left_out_and_most_others_are() {
    let mut all = Tally::default();
    for case in cases() {
        let (view, made) = (case.view(), case.triangles());
        assert!(case.remaining(Outside::NOTHING).into_iter().eq(0..made.len() as u32), "{}", case.what);
        let rest = case.remaining(Outside::ALL);
        let mut tally = Tally::default();
        for (patch, triangles) in made.iter().enumerate() {
            let is_out = rest.binary_search(&(patch as u32)).is_err();
            tally.add(is_out, sees(&view, CHOICES[0], triangles));
        }
        assert_eq!(tally.seen, 0, "{}: {tally:?}", case.what);
        (all.out, all.unseen) = (all.out + tally.out, all.unseen + tally.unseen);
    }
    println!("{all:?}");
    assert!(2 * all.out > all.unseen && all.out > 1000, "{all:?}");
}

#[test]
fn unmoved_planes_and_backs_of_the_base_leave_out_visible_patches() {
    let [mut unmoved, mut corners_alone] = [(); 2].map(|()| Tally::default());
    for case in cases() {
        let (view, base) = (case.view(), case.whole());
        let volume = ViewVolume::new(&view);
        let flat = case.map.clone().with_displacement(0.0, 0.0).expect("lengths");
        let flat = Relief::new(&flat, case.settings.directions, Shading::Exact);
        let bounds = Bounds { relief: &flat, levels: vec![HeightBounds::new(&case.map)] };
        for (patch, triangles) in (0u32..).zip(case.triangles()) {
            let hull = Hull { radius_m: 0.0, ..base.hull(&bounds, patch) };
            unmoved.add(volume.misses(&hull, &Outside::ALL), sees(&view, CHOICES[0], &triangles));
            let corners = base.triangles[patch as usize].map(|vertex| base.corners.vertex(vertex).position);
            let is_back = volume.is_back(corners);
            corners_alone.add(is_back, sees(&view, CHOICES[1], &triangles));
        }
    }
    println!("{unmoved:?} {corners_alone:?}");
    assert!(unmoved.seen > 5 && corners_alone.seen > 50, "{unmoved:?} {corners_alone:?}");
}

/// Returns the triangles by their vertices.
fn by_vertices(mesher: &Mesher) -> Vec<[Vertex; 3]> {
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    let watch = Watch::none();
    let how = Stream { size: 1.0, check: false, grid: None, cache_order: false, watch };
    let streamed = mesher.stream(&how, |block| {
        vertices.extend_from_slice(&block.vertices);
        triangles.extend_from_slice(&block.triangles);
        Ok::<(), ()>(())
    });
    assert!(streamed.is_ok());
    assert_eq!([vertices.len() as u64, triangles.len() as u64], [mesher.vertices(), mesher.triangles()]);
    let mut is_used = vec![false; vertices.len()];
    triangles.as_flattened().iter().for_each(|&at: &u32| is_used[at as usize] = true);
    assert!(is_used.into_iter().all(|is_used| is_used), "a vertex of no triangle");
    triangles.into_iter().map(|corners: [u32; 3]| corners.map(|at| vertices[at as usize])).collect()
}

#[test]
fn no_visible_triangle_is_left_out_and_the_rest_has_the_same_bits() {
    let mut sums = [(); 3].map(|()| Tally::default());
    let (mut empty, mut uncut) = (0, 0);
    for case in cases() {
        let (whole, plain) = (case.mesher(Some(Cull::default())), case.mesher(None));
        let triangles = by_vertices(&whole);
        assert!(plain.full_bounds().is_none());
        if case.whole().triangles.len() == case.mesh.triangles().len() {
            assert!(triangles == by_vertices(&plain), "{}", case.what);
            uncut += 1;
        }
        let view = case.view();
        let [near, far] = whole.full_bounds().expect("it is for a view").depths_m;
        for corner in triangles.iter().flatten() {
            let depth = view.camera.forward().dot(corner.position.as_dvec3() - view.camera.eye());
            assert!((near..=far).contains(&depth), "{}: {depth} of {near} to {far}", case.what);
        }
        for (cull, sums) in CHOICES.into_iter().zip(&mut sums) {
            let culled = case.mesher(Some(cull));
            assert!(culled.full_bounds() == whole.full_bounds(), "{}", case.what);
            let rest = by_vertices(&culled);
            let (mut left, mut tally) = (rest.iter().peekable(), Tally::default());
            for corners in &triangles {
                let is_there = left.next_if_eq(&corners).is_some();
                let positions = corners.map(|corner| corner.position.as_dvec3());
                tally.add(!is_there, sees(&view, cull, &[positions]));
            }
            assert!(left.next().is_none(), "{}: {cull:?}", case.what);
            println!("{}: {cull:?}: {tally:?}", case.what);
            assert_eq!(tally.seen, 0, "{}: {cull:?}: {tally:?}", case.what);
            // Culling of backs knows nothing of the space behind the eye, and pictures have a
            // margin.
            let few = cull.outside == Outside::NOTHING || 10 * tally.unseen < triangles.len();
            assert!(few || 2 * tally.out > tally.unseen, "{}: {cull:?}: {tally:?}", case.what);
            (sums.out, sums.unseen) = (sums.out + tally.out, sums.unseen + tally.unseen);
            empty += usize::from(rest.is_empty());
        }
    }
    println!("{sums:?}, {empty} empty, {uncut} uncut");
    assert!(sums.iter().all(|sums| sums.out > 100_000), "{sums:?}");
    assert!([sums[0], sums[2]].iter().all(|sums| 10 * sums.out > 9 * sums.unseen), "{sums:?}");
    assert!(empty > 0 && uncut > 15, "{empty} {uncut}");
}

#[test]
fn nothing_is_left_out_where_there_is_no_view_or_normals_need_all_triangles() {
    let mesh = torus(6, 4).expect("a mesh");
    let map = rough(Wrap::Repeat, 0.1);
    let cull = Some(CHOICES[2]);
    let refused = |settings: MeshSettings| Mesher::new(&mesh, &map, &settings).expect_err("it is refused");
    assert_eq!(
        refused(MeshSettings { cull, ..MeshSettings::default() }),
        MesherError::CullOfNoView { edges: "texels" }
    );
    let view = View::new(cameras()[0], SIZE);
    let settings = MeshSettings { cull, ..MeshSettings::seen_by(view) };
    let of_mesh = MeshSettings { shading: Shading::Mesh, ..settings };
    assert_eq!(refused(of_mesh), MesherError::CullOfMeshNormals);
    let cancel = AtomicBool::new(true);
    let stopped = Watch::cancelled_by(&cancel);
    let stopped = Mesher::watched(&mesh, &map, &settings, &stopped);
    assert_eq!(stopped.err(), Some(MesherError::Cancelled(Cancelled)));
}

#[test]
fn nothing_between_visible_points_and_lights_is_left_out() {
    let lights = [
        [DVec4::new(0.3, 0.9, 0.2, 0.0), DVec4::new(-0.7, 0.4, 0.5, 0.0)],
        [DVec4::new(0.2, 1.5, 0.4, 1.0), DVec4::new(0.1, 1.0, 0.9, 0.0)],
        [DVec4::new(0.0, -0.3, 0.9, 0.0), DVec4::new(1.5, 0.2, -0.3, 1.0)],
    ];
    let (mut ways, mut out, mut met_by_all) = (0, 0, 0);
    for (at, case) in cases().into_iter().enumerate().filter(|(at, _)| at % 4 == 1) {
        let (view, made, lights) = (case.view(), case.triangles(), lights[at % 3]);
        let outside = Outside::of_light_paths(lights, &view, 0.0);
        let of = |outside: Outside| -> Vec<usize> {
            let rest = case.remaining(outside);
            (0..made.len()).filter(|patch| rest.binary_search(&(*patch as u32)).is_err()).collect()
        };
        let meet = |patches: &[usize], from: DVec3, light: DVec4| {
            let way = light.truncate() - from * light.w;
            let all = patches.iter().flat_map(|patch| &made[*patch]);
            all.clone().any(|corners| meets(from, way, light.w, *corners))
        };
        let [left_out, beside] = [of(outside), of(Outside::ALL)];
        assert!(left_out.iter().all(|patch| beside.contains(patch)), "{}", case.what);
        out += left_out.len();
        let seen = made.iter().flatten().map(|[a, b, c]| (*a + *b + *c) / 3.0);
        let seen = seen.filter(|point| is_in_picture(&view, [*point; 3])).step_by(29);
        for from in seen {
            for light in lights {
                assert!(!meet(&left_out, from, light), "{}: {from} {light}", case.what);
                met_by_all += usize::from(meet(&beside, from, light));
                ways += 1;
            }
        }
    }
    println!("{ways} ways, {out} patches left out; what is only beside is met {met_by_all} times");
    assert!(ways > 1000 && out > 300 && met_by_all > 10, "{ways} {out} {met_by_all}");
}

/// Returns whether the way from a point meets a triangle: along all of it, or up to a light at a
/// point.
fn meets(from: DVec3, way: DVec3, w: f64, [a, b, c]: [DVec3; 3]) -> bool {
    let (ab, ac) = (b - a, c - a);
    let across = way.cross(ac);
    let volume = ab.dot(across);
    let (aside, up) = (from - a, (from - a).cross(ab));
    let [u, v, t] = [aside.dot(across), way.dot(up), ac.dot(up)].map(|part| part / volume);
    volume != 0.0 && u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 1e-9 && (w == 0.0 || t < 1.0)
}

#[test]
fn triangles_that_rounding_may_turn_over_are_no_backs() {
    let camera = Camera::new(DVec3::Z, DVec3::ZERO, 90.0).expect("a camera");
    let volume = ViewVolume::new(&View::new(camera, [200, 200]));
    let [a, b] = [Vec3::ZERO, Vec3::X];
    // A hundred pixels to a metre at this depth.
    assert!(!volume.is_back([a, b, Vec3::Y]) && volume.is_back([b, a, Vec3::Y]));
    assert!(!volume.is_back([b, a, Vec3::Y * 1e-4]) && volume.is_back([b, a, Vec3::Y * 1e-3]));
    // A triangle without an area is not visible. One that reaches behind the eye has no place in
    // the picture.
    assert!(volume.is_back([a, b, b]) && !volume.is_back([b, a, Vec3::new(0.0, 1.0, 3.0)]));
}

#[test]
fn bases_that_reach_behind_the_eye_are_cut_without_a_crack() {
    let eyes = [([0.1, 0.55, 0.2], [0.4, 0.5, 0.1]), ([0.51, 0.1, 0.3], [0.5, -0.3, -0.2])];
    for (eye, target) in eyes {
        let camera = Camera::new(DVec3::from(eye), DVec3::from(target), 50.0).expect("a camera");
        let view = View { pixels: 3.0, near_m: 0.03, ..View::new(camera, SIZE) };
        let waves = |i: u32, j: u32| (i as f32 * 0.4).sin() * (j as f32 * 0.3).cos() * 0.5 + 0.5;
        let map = HeightMap::from_fn(48, 40, Wrap::Mirror, waves).expect("heights");
        let (mesh, map) = (cube(1).expect("a mesh"), map.with_displacement(0.03, -0.01).expect("lengths"));
        let mesher = |cull: Option<Cull>| {
            let settings = MeshSettings { cull, ..MeshSettings::seen_by(view) };
            Mesher::new(&mesh, &map, &settings).expect("a mesh")
        };
        let [whole, cut, seen] = [None, Some(Cull::default()), Some(CHOICES[2])].map(mesher);
        println!("{} triangles, {} cut, {} seen", whole.triangles(), cut.triangles(), seen.triangles());
        assert!(10 * seen.triangles() < whole.triangles() && 2 * cut.triangles() > whole.triangles());
        let cut = cut.mesh().expect("finite");
        let cracks = CrackTest::of_mesh(&cut);
        assert!(cracks.is_closed() && cracks.pieces == 1, "{cracks:?}");
        // The surface is the same, but its points are elsewhere.
        let [whole, seen] = [&whole, &seen].map(|mesher| RayCaster::new(&mesher.mesh().expect("finite")));
        let (mut hits, mut apart) = (0, 0);
        for at in 0..SIZE[0] * SIZE[1] {
            let ray = camera.ray(at % SIZE[0], at / SIZE[0], SIZE[0], SIZE[1]);
            let [a, b] = [&whole, &seen].map(|caster| caster.next_hit(&ray, Sides::Front, None));
            let depths = [a, b].map(|hit| hit.map_or(f64::INFINITY, |hit| hit.t));
            hits += u32::from(depths[0].is_finite());
            apart += u32::from(depths[0] != depths[1] && (depths[0] - depths[1]).abs() > 0.01);
        }
        println!("{apart} of {hits} apart");
        assert!(hits > 1000 && apart * 20 < hits, "{apart} of {hits}");
    }
}
