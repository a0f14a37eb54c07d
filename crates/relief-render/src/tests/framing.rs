//! Cameras fitted to the visible surfaces.

use relief_core::mesh::{Placement, Vertex, rectangle, sphere};
use relief_core::object::{ImageObject, JumpCells, View as ImageView};
use relief_core::{HeightMap, TexelMask, Watch};
use relief_maps::Maps;
use relief_shaders::cpu::PixelOut;

use super::*;
use crate::renderer::Renderer;
use relief_core::mesh::Mesh;

/// The part of a picture's side by which opposite margins may differ.
const EQUAL: f64 = 0.02;

/// Hills of heights from 0.3 to 0.7.
fn hills(scale_m: f64) -> HeightMap {
    let map = HeightMap::from_fn(64, 64, Wrap::Repeat, |i, j| {
        let [u, v] = [i, j].map(|at| (at as f32 + 0.5) / 64.0 * std::f32::consts::TAU);
        0.5 + 0.1 * (3.0 * u).sin() + 0.1 * (2.0 * v).cos()
    });
    map.and_then(|map| map.with_displacement(scale_m, -scale_m)).expect("a map")
}

fn built(mesh: Builtin) -> Mesh {
    mesh.build([1.0, 1.0]).expect("a mesh")
}

fn by_method(mesh: Mesh, map: HeightMap, method: &str) -> Surface {
    Surface::new(mesh, map).with_selection(Selection::method(method).expect("a method"))
}

fn on_surface(mesh: Mesh, map: HeightMap, surface: &str) -> Surface {
    let mut selection = Selection::exact();
    selection.choose("surface", surface).expect("a surface");
    Surface::new(mesh, map).with_selection(selection)
}

/// A ball with a thorn that reaches far to one side.
fn thorny() -> Mesh {
    let ball = sphere(12, 8).expect("a mesh");
    let mut vertices = ball.vertices().to_vec();
    let end = vertices.iter_mut().find(|vertex| vertex.position.x > 0.4);
    end.expect("a vertex on the right").position *= 5.0;
    Mesh::new(vertices, ball.triangles().to_vec()).expect("a mesh")
}

/// A ball of radius 0.5 as six images see it, beside the middle of the ball of radius 1.2 that they show.
fn captured() -> Surface {
    let (centre, radius) = (DVec3::new(0.5, -0.2, 0.3), 0.5);
    let sides = [DVec3::X, DVec3::Y, DVec3::Z].into_iter().flat_map(|axis| [axis, -axis]);
    let views: Vec<ImageView> = sides
        .map(|from| ImageView::orthographic(DVec3::ZERO, 1.2, from, None, [96, 96]).expect("a view"))
        .collect();
    let map = |view: &ImageView| {
        HeightMap::from_fn(96, 96, Wrap::Clamp, |i, j| {
            let ray = view.ray((f64::from(i) + 0.5) / 96.0, (f64::from(j) + 0.5) / 96.0);
            let toward = ray.origin - centre;
            let (half, rest) = (toward.dot(ray.direction), toward.length_squared() - radius * radius);
            let root = (half * half - rest).sqrt();
            let seen = view.see(ray.at(-half - root)).filter(|at| at.z.is_finite());
            seen.map_or(0.0, |at| at.z as f32)
        })
        .expect("a map")
    };
    let maps: Vec<HeightMap> = views.iter().map(map).collect();
    let object = ImageObject::new(views, &maps, JumpCells::Highest, 4.0).expect("an object");
    Surface::of_object(object).expect("a surface")
}

/// A scene that is fitted to what is seen, or to all space of the reliefs.
fn framed(surface: Surface, framing: Framing, view: View, size: [u32; 2]) -> SceneBuilder {
    let builder = Scene::builder(surface).fitted_camera(view, 40.0);
    builder.framing(framing).size(size[0], size[1]).samples(1).backend(BackendChoice::Cpu)
}

fn pixels(builder: SceneBuilder) -> Vec<PixelOut> {
    let scene = builder.build().expect("a scene");
    let rendered = Renderer::on_cpu().render(&scene, &mut Maps::in_memory(), &Watch::none());
    rendered.expect("a picture").rendering.pixels
}

/// The margins of a picture, in pixels: left, right, above and below.
fn margins(pixels: &[PixelOut], [width, height]: [u32; 2]) -> [u32; 4] {
    let mut margins = [width, width, height, height];
    for (at, _) in pixels.iter().enumerate().filter(|(_, pixel)| pixel.hit == 1) {
        let (x, y) = (at as u32 % width, at as u32 / width);
        let here = [x, width - 1 - x, y, height - 1 - y];
        margins = std::array::from_fn(|side| margins[side].min(here[side]));
    }
    margins
}

/// By how much opposite margins differ, as parts of the picture's sides, beyond the rounding to pixels.
fn differ([left, right, above, below]: [u32; 4], [width, height]: [u32; 2]) -> f64 {
    let part = |a: u32, b: u32, side: u32| f64::from(a.abs_diff(b).saturating_sub(1)) / f64::from(side);
    part(left, right, width).max(part(above, below, height))
}

fn check(what: &str, surface: &Surface, view: View, size: [u32; 2]) {
    check_within(what, surface, view, size, 0.02);
}

/// Checks framing where margins may be wider by at most a part of the picture.
fn check_within(what: &str, surface: &Surface, view: View, size: [u32; 2], wider: f64) {
    for parallel in [false, true] {
        let builder = framed(surface.clone(), Framing::Visible, view, size);
        let builder = if parallel { builder.fitted_orthographic_camera(view) } else { builder };
        let margins = margins(&pixels(builder), size);
        let differ = differ(margins, size);
        assert!(differ <= EQUAL, "{what}, {view}, {size:?}, parallel {parallel}: {margins:?}");
        // One pair is what the fit leaves: 6 %, or nothing from above.
        let [width, height] = size.map(f64::from);
        let [left, right, above, below] = margins.map(f64::from);
        let least = ((left + right) / width).min((above + below) / height);
        let rounding = 3.0 / width.min(height);
        let most = if parallel && view == View::Top { 0.0 } else { 0.06 };
        assert!(
            (most - 0.02 - rounding..=most + wider + rounding).contains(&least),
            "{what}, {view}, {size:?}, {parallel}: {margins:?}"
        );
    }
}

#[test]
fn what_is_seen_lies_in_the_middle_of_the_picture() {
    let size = [320, 240];
    for depth_m in [0.05, 0.6] {
        let deep = Surface::new(built(Builtin::Plane), hills(depth_m));
        for view in [View::ThreeQuarter, View::Corner, View::Top] {
            check(&format!("{depth_m} m deep"), &deep, view, size);
        }
        // By the space down to height 0 the same picture is not in the middle.
        let margins = margins(&pixels(framed(deep, Framing::Volume, View::ThreeQuarter, size)), size);
        assert!(differ(margins, size) > EQUAL, "{depth_m} m deep: {margins:?}");
    }
    for mesh in Builtin::ALL {
        check(mesh.name(), &Surface::new(built(mesh), hills(0.05)), View::ThreeQuarter, size);
    }
    check("thorn", &Surface::new(thorny(), hills(0.05)), View::ThreeQuarter, size);
    check("thorn", &Surface::new(thorny(), hills(0.05)), View::Front, size);
}

#[test]
fn reliefs_beside_their_mesh_lie_in_the_middle() {
    let size = [320, 240];
    let ball = || built(Builtin::Sphere);
    for surface in ["prism", "tetrahedra"] {
        let surface_of = on_surface(ball(), hills(0.3), surface);
        check_within(surface, &surface_of, View::ThreeQuarter, size, 0.05);
        // The backs of its far side are seen over the mesh.
        check_within(surface, &surface_of.with_two_sided(true), View::ThreeQuarter, size, 0.05);
    }
    for method in ["vertex", "remesh", "tessellate"] {
        check_within(method, &by_method(ball(), hills(0.3), method), View::ThreeQuarter, size, 0.05);
    }
    check_within(
        "quadric-vertical",
        &on_surface(ball(), hills(0.1), "quadric-vertical"),
        View::Right,
        size,
        0.05,
    );
}

#[test]
fn objects_fill_the_picture_as_their_images_show_them() {
    for view in [View::ThreeQuarter, View::Top, View::Right] {
        check("object", &captured(), view, [240, 180]);
    }
    let selection = Selection::method("visual-hull").expect("a method");
    check("hull", &captured().with_selection(selection), View::ThreeQuarter, [240, 180]);
}

#[test]
fn all_views_and_proportions_of_pictures_are_centred() {
    for size in [[400, 100], [100, 400], [150, 150]] {
        for view in View::ALL {
            check("torus", &Surface::new(built(Builtin::Torus), hills(0.05)), view, size);
        }
        check("plane", &Surface::new(built(Builtin::Plane), hills(0.6)), View::ThreeQuarter, size);
    }
}

#[test]
fn a_map_covers_much_of_the_picture_and_a_cube_shows_three_faces() {
    let size = [800, 600];
    let plane = Surface::new(built(Builtin::Plane), hills(0.05));
    let hits = |pixels: &[PixelOut]| pixels.iter().filter(|pixel| pixel.hit == 1).count();
    let covered = hits(&pixels(framed(plane, Framing::Visible, View::ThreeQuarter, size))) as f64 / 480_000.0;
    assert!((0.45..0.6).contains(&covered), "{covered}");
    let flat = HeightMap::new(1, 1, vec![1.0], Wrap::Repeat).expect("a map");
    let cube = framed(Surface::new(built(Builtin::Cube), flat), Framing::Visible, View::ThreeQuarter, size);
    let faces = pixels(cube);
    for face in [Vec3::X, Vec3::Y, Vec3::Z] {
        let is_there = |pixel: &&PixelOut| {
            let normal = Vec3::new(pixel.normal.x, pixel.normal.y, pixel.normal.z);
            pixel.hit == 1 && normal.dot(face) > 0.99
        };
        let count = faces.iter().filter(is_there).count();
        assert!(count > hits(&faces) / 20, "{face}: {count} pixels");
    }
}

#[test]
fn degenerate_scenes_have_a_camera() {
    let constant = |width: u32, height: u32, texel: f32| {
        let texels = vec![texel; (width * height) as usize];
        let map = HeightMap::new(width, height, texels, Wrap::Clamp).expect("a map");
        map.with_displacement(0.2, -0.2).expect("lengths")
    };
    let holes = TexelMask::from_fn(4, 4, |_, _| true);
    let empty = constant(4, 4, 0.0).with_holes(holes).expect("holes");
    let scaled = |size: f64, at: f64| {
        let placement = Placement { position_m: DVec3::splat(at), size, ..Placement::default() };
        built(Builtin::Plane).placed(&placement).expect("a mesh")
    };
    let surfaces = [
        Surface::new(built(Builtin::Plane), constant(8, 8, 0.0)),
        Surface::new(built(Builtin::Plane), constant(8, 8, 1.0)),
        Surface::new(built(Builtin::Plane), constant(1, 1, 0.5)),
        Surface::new(rectangle([0.01, 1.0], 1).expect("a mesh"), constant(1, 100, 0.5)),
        Surface::new(rectangle([1.0, 0.01], 1).expect("a mesh"), constant(100, 1, 0.5)),
        Surface::new(built(Builtin::Plane), empty).with_holes(true),
        Surface::new(scaled(1e6, 0.0), constant(8, 8, 0.5)),
        Surface::new(scaled(1e-6, 0.0), constant(8, 8, 1.0)),
        Surface::new(scaled(1.0, 1e4), constant(8, 8, 0.5)),
        by_method(built(Builtin::Plane), constant(1, 1, 0.5), "vertex"),
        on_surface(built(Builtin::Cube), constant(1, 7, 0.0), "prism"),
    ];
    for (number, surface) in surfaces.into_iter().enumerate() {
        for view in View::ALL {
            for parallel in [false, true] {
                let builder = framed(surface.clone(), Framing::Visible, view, [64, 48]);
                let builder = if parallel { builder.fitted_orthographic_camera(view) } else { builder };
                let scene = builder.build();
                let camera = *scene.unwrap_or_else(|error| panic!("{number}, {view}: {error}")).camera();
                assert!(camera.eye().is_finite() && camera.half_height() > 0.0, "{number}, {view}");
            }
        }
    }
    let narrow = framed(flat(), Framing::Visible, View::ThreeQuarter, [64, 48]);
    let error = narrow.fitted_camera(View::ThreeQuarter, 0.0).build().expect_err("no field of view");
    assert_eq!(error.key, "fov");
}

proptest! {
    #[test]
    fn points_reach_as_far_to_one_side_as_to_the_other(
        points in prop::collection::vec(prop::array::uniform3(-1.0f32..1.0), 3..60),
        stretch in prop::array::uniform3(0.3f32..3.0),
        size in prop::sample::select(vec![[800, 600], [90, 600], [600, 90]]),
        fov in 5.0..150.0,
        view in prop::sample::select(View::ALL.to_vec()),
    ) {
        let stretch = Vec3::from(stretch);
        let template = built(Builtin::Plane).vertices()[0];
        let vertices: Vec<Vertex> = points
            .iter()
            .map(|point| Vertex { position: Vec3::from(*point) * stretch, ..template })
            .collect();
        let triangles = (2..vertices.len() as u32).map(|last| [0, last - 1, last]).collect();
        let Ok(mesh) = Mesh::new(vertices, triangles) else { return Ok(()) };
        let surface = Surface::new(mesh.clone(), hills(0.1));
        let scene = framed(surface, Framing::Visible, view, size).fitted_camera(view, fov).build();
        let scene = scene.expect("a scene");
        let camera = scene.camera();
        let [width, height] = size.map(f64::from);
        let mut ends = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        let mut nearest = f64::INFINITY;
        for vertex in mesh.vertices() {
            let way = vertex.position.as_dvec3() - camera.eye();
            let depth = way.dot(camera.forward());
            nearest = nearest.min(depth);
            let half = camera.half_height() * depth;
            let place = [way.dot(camera.right()) / (half * width / height), way.dot(camera.up()) / half];
            for (ends, place) in ends.iter_mut().zip(place) {
                *ends = [ends[0].min(place), ends[1].max(place)];
            }
        }
        for [low, high] in ends {
            prop_assert!((low + high).abs() < 1e-6, "{low} and {high}");
        }
        let most = ends[0][1].max(ends[1][1]);
        // What is seen from its edge is as near as it can be.
        prop_assert!(most < 0.94 + 1e-6 && (most > 0.94 - 1e-6 || nearest < 0.01), "{most}, {nearest}");
    }
}
