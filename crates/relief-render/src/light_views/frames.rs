//! Comparison of small frames with the same frames under shadow maps of the full size.

use std::sync::Arc;

use glam::{DVec3, Vec2, Vec3};
use relief_core::mesh::{Builtin, Mesh, Placement, sphere};
use relief_core::{HeightMap, Watch, Wrap};
use relief_maps::Maps;
use relief_shaders::Selection;
use relief_shaders::cpu::PixelOut;

use super::shadow_map_side;
use crate::cpu::CpuRenderer;
use crate::job::{Job, LightViews};
use crate::picture::srgb;
use crate::prepare::Preparer;
use relief_core::camera::Camera;
use relief_scene::light::Light;
use relief_scene::{Scene, Surface};

/// The default of `shadow.size`.
const FULL: u32 = 2048;

/// Resolution of the frame that locates shadow edges, as a multiple along either axis.
const FINER: u32 = 4;

/// Greatest difference of colours, of 255, that counts as equal.
const SAME: f32 = 16.0;

/// By how much less light arrives beyond a shadow's edge: a filter makes half shadows.
const STEP_OF_LIGHT: f32 = 0.03;

/// Part of the pixels that may differ, and how far from a shadow's edge, in pixels: all but single ones,
/// where light grazes a slope, lie within 1.5.
const FEW: f64 = 0.007;
const NEAR_EDGE: f64 = 3.5;

/// Hills of several sizes.
fn hills(side: u32, scale_m: f64) -> Arc<HeightMap> {
    let map = HeightMap::from_fn(side, side, Wrap::Repeat, |i, j| {
        let [u, v] = [i, j].map(|at| (at as f32 + 0.5) / side as f32 * std::f32::consts::TAU);
        0.5 + 0.24 * (2.0 * u).sin() * v.cos()
            + 0.16 * (3.0 * u - 2.0 * v).sin()
            + 0.08 * (7.0 * (u + v)).sin()
    });
    Arc::new(map.expect("a map").with_displacement(scale_m, 0.0).expect("lengths"))
}

/// A mesh under a map by a method, with some settings.
fn surface(mesh: Mesh, map: &Arc<HeightMap>, method: &str, set: &[(&str, f64)]) -> Surface {
    let mut selection = Selection::method(method).expect("a method");
    selection.choose("shadow", "map").expect("a shadow");
    for (key, value) in set {
        selection.set(key, *value).expect("a setting");
    }
    Surface::new(Arc::new(mesh), Arc::clone(map)).with_selection(selection)
}

fn plane() -> Mesh {
    Builtin::Plane.build([1.0, 1.0]).expect("a mesh")
}

fn placed(
    mesh: Result<Mesh, relief_core::mesh::MeshError>,
    tiles: [f32; 2],
    at: [f64; 3],
    size: f64,
) -> Mesh {
    let placement = Placement { position_m: at.into(), size, ..Placement::default() };
    mesh.and_then(|mesh| mesh.tiled(Vec2::from(tiles)))
        .and_then(|mesh| mesh.placed(&placement))
        .expect("a mesh")
}

/// A scene: what it is called, its surfaces, its light and from where it is seen.
struct Case {
    name: &'static str,
    surfaces: Vec<Surface>,
    light: Light,
    eye: [f64; 3],
}

impl Case {
    fn all() -> Vec<Self> {
        let sun = |toward: [f64; 3]| Light::directional(toward.into(), Vec3::ONE).expect("a light");
        let lamp = |at: [f64; 3]| Light::point(at.into(), Vec3::ONE).expect("a light");
        let (ground, fine) = (hills(128, 0.16), hills(64, 0.02));
        let case = |name, surfaces, light, eye| Self { name, surfaces, light, eye };
        let flat = |map, method, set: &[(&str, f64)]| surface(plane(), map, method, set);
        let smooth = hills(64, 0.008);
        let round = || placed(sphere(24, 12), [3.0, 2.0], [0.1, 0.3, 0.0], 0.3);
        let ball = || surface(round(), &fine, "vertex", &[]);
        let smooth_ball = surface(round(), &smooth, "vertex", &[]);
        let (above, aside) = ([0.7, 0.9, 1.2], [0.8, 1.0, 1.2]);
        vec![
            case("hills", vec![flat(&ground, "vertex", &[])], sun([0.6, 0.5, 0.3]), aside),
            case("ball", vec![flat(&fine, "vertex", &[]), ball()], sun([-0.4, 0.8, 0.3]), above),
            case(
                "ball in cascades",
                vec![flat(&fine, "remesh", &[("shadow.cascades", 3.0)]), ball()],
                sun([-0.4, 0.8, 0.3]),
                above,
            ),
            case(
                "ball under a lamp",
                vec![flat(&smooth, "vertex", &[]), smooth_ball],
                lamp([-0.25, 0.8, 0.15]),
                above,
            ),
            case(
                "ball over slices",
                vec![flat(&fine, "slices-surface", &[("slices.count", 12.0)]), ball()],
                sun([0.4, 0.9, 0.2]),
                above,
            ),
        ]
    }

    fn scene(&self, [width, height]: [u32; 2]) -> Scene {
        let camera = Camera::new(DVec3::from(self.eye), DVec3::new(0.0, 0.08, 0.0), 38.0).expect("a camera");
        let builder = Scene::builder(self.surfaces[0].clone()).surfaces(self.surfaces.clone());
        let builder = builder.camera(camera).lights(vec![self.light]).samples(1);
        builder.size(width, height).build().expect("a scene")
    }

    /// The pixels of a frame whose shadow maps have that side, or the one that it asks for.
    fn pixels(&self, state: &mut State, size: [u32; 2], side: Option<u32>) -> Vec<PixelOut> {
        let scene = self.scene(size);
        let mut job = state.job(&scene);
        assert_eq!(job.light_views.size, shadow_map_side(FULL, size), "{}", self.name);
        if let Some(side) = side {
            job.light_views =
                LightViews::of_side(side, scene.lights(), scene.camera(), size, &mut job.surfaces);
            job.light_views.write_into(&mut job.frame);
        }
        state.renderer.render(&job, &Watch::none()).expect("memory").pixels
    }
}

/// State kept from frame to frame, because shadow maps of the full size take long.
#[derive(Default)]
struct State {
    preparer: Preparer,
    renderer: CpuRenderer,
}

impl State {
    fn job(&mut self, scene: &Scene) -> Job {
        let mut maps = Maps::in_memory();
        self.preparer.provide(scene, &mut maps, &|_| false, &Watch::none()).expect("maps");
        self.preparer.job(scene, &Watch::none()).expect("a job")
    }
}

/// Which pixels of a frame differ in colour.
fn differences(a: &[PixelOut], b: &[PixelOut]) -> Vec<bool> {
    let code = |pixel: &PixelOut| srgb([pixel.color.x, pixel.color.y, pixel.color.z]);
    let differ = |(a, b): (&PixelOut, &PixelOut)| {
        code(a).iter().zip(code(b)).any(|(a, b)| 255.0 * (a - b).abs() > SAME)
    };
    a.iter().zip(b).map(differ).collect()
}

/// The places, in pixels of a frame, where the light changes in a finer frame of the same view.
fn edges(finer: &[PixelOut], columns: usize) -> Vec<[f64; 2]> {
    let light = |place: usize| if finer[place].hit == 1 { finer[place].lit } else { 1.0 };
    let beside = |place: usize| {
        let right = (place % columns + 1 < columns).then_some(place + 1);
        [right, Some(place + columns).filter(|below| *below < finer.len())]
    };
    let is_edge = |place: &usize| {
        beside(*place).into_iter().flatten().any(|other| (light(other) - light(*place)).abs() > STEP_OF_LIGHT)
    };
    let scaled = |at: usize| (at as f64 + 0.5) / f64::from(FINER);
    (0..finer.len()).filter(is_edge).map(|place| [scaled(place % columns), scaled(place / columns)]).collect()
}

fn part(differ: &[bool]) -> f64 {
    differ.iter().filter(|differs| **differs).count() as f64 / differ.len() as f64
}

#[test]
fn small_frames_have_the_shadows_of_maps_of_the_full_size() {
    let (mut coarse_fail, mut wrong) = (0, Vec::new());
    for case in Case::all() {
        let mut state = State::default();
        let full = [[64, 48], [96, 72]].map(|size| {
            let finer = case.pixels(&mut state, size.map(|side| FINER * side), Some(FULL));
            (size, case.pixels(&mut state, size, Some(FULL)), finer)
        });
        for (size, full, finer) in full {
            let differ = differences(&case.pixels(&mut state, size, None), &full);
            let edges = edges(&finer, (FINER * size[0]) as usize);
            let farthest = (0..differ.len()).filter(|place| differ[*place]).map(|place| {
                let [x, y] = [place as u32 % size[0], place as u32 / size[0]].map(|at| f64::from(at) + 0.5);
                edges.iter().map(|[u, v]| (x - u).hypot(y - v)).fold(f64::INFINITY, f64::min)
            });
            let farthest = farthest.fold(0.0, f64::max);
            // Maps of a quarter of the side are too coarse.
            let coarse = part(&differences(
                &case.pixels(&mut state, size, Some(shadow_map_side(FULL, size) / 4)),
                &full,
            ));
            let (name, few) = (case.name, part(&differ));
            println!("{name} {size:?}: {few:.4} differ, the farthest by {farthest:.2}, coarse {coarse:.4}");
            wrong.extend((edges.len() < 40 * FINER as usize).then(|| format!("{name} {size:?}: no shadows")));
            wrong.extend((few > FEW).then(|| format!("{name} {size:?}: {few} of the pixels differ")));
            wrong.extend((farthest > NEAR_EDGE).then(|| format!("{name} {size:?}: {farthest} from edges")));
            coarse_fail += usize::from(coarse > FEW);
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(coarse_fail >= 7, "only {coarse_fail} frames with coarse maps have other shadows");
}
