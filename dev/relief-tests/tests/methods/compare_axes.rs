//! Comparisons over shadows, distances, formats of maps and scenes of several surfaces.

use glam::DVec3;
use relief_compare::{
    CompareError, Compared, Comparison, Contender, Machine, MachineBackend, PictureRecord, Records, Timing,
    csv, page, shadow,
};
use relief_core::camera::{Camera, Projection};
use relief_core::mesh::{Builtin, Placement, square};
use relief_core::{MapFormat, Watch};
use relief_render::gpu::{AdapterChoice, Gpu, GpuError};
use relief_render::{RenderError, Renderer};
use relief_scene::{Sampling, Scene, Surface};
use relief_shaders::Selection;
use relief_tests::accuracy::maps;
use relief_tests::adapter::has_adapter;

/// The sample cobbles on a square.
fn surface() -> Surface {
    let map = maps().into_iter().find(|named| named.name == "cobbles").expect("a sample map").map;
    Surface::new(square(1).expect("a square"), map.with_displacement(0.1, -0.1).expect("lengths"))
}

/// A comparison of a few methods in small pictures.
fn comparison(surfaces: Vec<Surface>, names: &[&str]) -> Comparison {
    let [first, rest @ ..] = &surfaces[..] else { panic!("a surface") };
    let scene = Scene::builder(first.clone()).size(64, 48).samples(1);
    let scene = if rest.is_empty() { scene } else { scene.surfaces(surfaces.clone()) };
    let mut comparison = Comparison::new("cobbles", scene.build().expect("a scene"));
    comparison.contenders = names.iter().map(|name| Contender::named(name).expect("a method")).collect();
    comparison.rays = 500;
    (comparison.flicker_samples, comparison.timing) = (None, None);
    comparison
}

fn run(comparison: &Comparison) -> Compared {
    comparison.run(&Watch::none()).expect("a comparison")
}

fn picture<'a>(records: &'a Records, label: &str) -> &'a PictureRecord {
    let found = records.pictures.iter().find(|record| record.method.label() == label);
    found.unwrap_or_else(|| panic!("{label}: {:?}", records.left_out))
}

#[test]
fn shadows_are_compared_with_the_exact_one_of_their_kind() {
    let mut comparison = comparison(vec![surface()], &["exact", "cone", "vertex"]);
    let names = ["none", "ray", "horizon", "soft", "map"];
    comparison.shadows = names.map(|name| shadow(name).expect("a shadow")).to_vec();
    let compared = run(&comparison);
    let records = &compared.records;
    // The sun's disc is what horizons see, too.
    let references: Vec<&str> = compared.references.iter().map(|of| of.shadow.as_str()).collect();
    assert_eq!(references, ["none", "ray", "soft", "scene"]);
    let of = |shown: usize| compared.references[compared.shown[shown].reference].shadow.as_str();
    for (place, record) in records.pictures.iter().enumerate() {
        let truth = match record.method.shadow.as_deref() {
            Some("none") => "none",
            Some("ray") => "ray",
            Some("map") => "scene",
            _ => "soft",
        };
        assert_eq!(of(place), truth, "{record:?}");
    }
    for exact in ["exact (none)", "exact (ray)"] {
        assert_eq!(picture(records, exact).flip, 0.0, "{exact}");
    }
    let [soft, horizon] = ["soft", "horizon"].map(|name| picture(records, &format!("exact ({name})")).flip);
    assert!(soft > 0.0 && horizon > soft && horizon < 0.1, "{soft} {horizon}");
    assert!(picture(records, "cone (ray)").flip < 0.01);
    // Its maps are those that the shadow reads, too.
    let bytes = |label: &str| picture(records, label).method.map_bytes;
    assert!(bytes("exact (ray)") == 0 && bytes("exact (horizon)") > 0);
    assert_eq!(bytes("cone (horizon)"), bytes("cone (none)") + bytes("exact (horizon)"));
    // Rays of the view are compared once, and no relief lies on displaced triangles.
    assert_eq!(records.rays.len(), 2 * comparison.angles_deg.len());
    assert!(records.rays.iter().all(|record| record.method.shadow.is_none()));
    let left_out: Vec<&str> = records.left_out.iter().map(|left| left.what.as_str()).collect();
    assert_eq!(left_out, ["vertex (ray)", "vertex (horizon)", "vertex (soft)"]);
    assert_eq!(csv(records).lines().count(), 1 + records.rays.len() + records.pictures.len());
    assert!(page(&compared).expect("a page").contains("shadow scene"));
}

#[test]
fn rays_through_the_scene_are_left_out_on_a_gpu() {
    if !has_adapter() {
        return;
    }
    let mut comparison = comparison(vec![surface()], &["cone"]);
    comparison.rays = 0;
    comparison.machines = vec![Machine::CPU, Machine::gpu(Sampling::Exact)];
    comparison.shadows = ["scene", "map"].map(|name| shadow(name).expect("a shadow")).to_vec();
    let Compared { records, .. } = run(&comparison);
    let on: Vec<_> = records.pictures.iter().map(|it| (it.method.label(), it.backend.as_str())).collect();
    let [scene, map] = ["cone (scene)", "cone (map)"].map(str::to_owned);
    assert_eq!(on, [(scene, "cpu"), (map.clone(), "cpu"), (map, "gpu")]);
    assert_eq!(records.left_out.len(), 1);
}

#[test]
fn pictures_are_seen_from_every_distance() {
    let mut comparison = comparison(vec![surface()], &["bump", "cone"]);
    let (camera, usual) = (*comparison.scene.camera(), run(&comparison));
    let own_m = (camera.eye() - camera.target()).length();
    comparison.distances_m = vec![own_m, 8.0 * own_m];
    let compared = run(&comparison);
    let distances: Vec<Option<f64>> =
        compared.records.pictures.iter().map(|record| record.distance_m).collect();
    assert_eq!(distances, [own_m, own_m, 8.0 * own_m, 8.0 * own_m].map(Some));
    for (usual, near) in usual.records.pictures.iter().zip(&compared.records.pictures) {
        assert!((usual.flip - near.flip).abs() < 1e-3, "{usual:?} {near:?}");
    }
    // Most of the picture is empty from far away.
    let [near, .., far] = &compared.records.pictures[..] else { panic!("four pictures") };
    assert!(far.flip < 0.3 * near.flip, "{} {}", near.flip, far.flip);
    // Rays have no camera.
    assert_eq!(compared.records.rays.len(), usual.records.rays.len());

    for distance_m in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        comparison.distances_m = vec![distance_m];
        assert!(comparison.check().is_err(), "{distance_m}");
    }
    comparison.distances_m = vec![1.0];
    assert!(comparison.check().is_ok());
    let flat = Projection::Orthographic { height_m: 1.0 };
    let flat = Camera::with(DVec3::new(0.0, 1.0, 1.0), DVec3::ZERO, flat).expect("a camera");
    comparison.scene.set_camera(flat);
    assert!(comparison.check().is_err());
}

#[test]
fn maps_in_fewer_bits_take_fewer_bytes_and_keep_their_promise() {
    let mut comparison = comparison(vec![surface()], &["relief", "cone", "frustum"]);
    comparison.map_formats = MapFormat::ALL.to_vec();
    let Compared { records, .. } = run(&comparison);
    let of = |label: &str| records.rays.iter().filter(|record| record.method.label() == label).collect();
    let bytes = [("cone", 4.0), ("frustum", 16.0)];
    for (method, bytes) in bytes {
        let mut reads = Vec::new();
        for (format, part) in MapFormat::ALL.iter().zip([1.0, 0.5, 0.25]) {
            let label = format!("{method} ({})", format.name());
            let rays: Vec<_> = of(&label);
            assert_eq!(rays.len(), comparison.angles_deg.len(), "{label}");
            for record in &rays {
                assert_eq!(record.method.bytes_a_texel(), part * bytes, "{label}");
                assert!(record.error.passed <= 4e-3 && record.error.p99_texels < 1e-2, "{record:?}");
            }
            assert!(picture(&records, &label).flip < 0.01, "{label}");
            reads.push(rays.iter().map(|record| record.cost.reads).sum::<f64>());
        }
        // What is rounded to the safe side allows shorter steps.
        assert!(reads[2] > reads[0], "{method}: {reads:?}");
    }
    // What reads no map is compared once.
    let relief: Vec<_> = of("relief");
    assert_eq!(relief.len(), comparison.angles_deg.len());
}

#[test]
fn scenes_of_several_surfaces_are_compared_in_pictures() {
    let aside = Placement { position_m: DVec3::new(1.2, 0.1, 0.0), ..Placement::default() };
    let first = surface();
    let map = first.height_map().clone();
    let second = Surface::new(square(1).expect("a square").placed(&aside).expect("a place"), map);
    let mut comparison = comparison(vec![first, second], &["bump", "exact", "cone", "vertex"]);
    comparison.flicker_samples = Some(4);
    comparison.timing = Some(Timing { frames: 3, warm: 1, pixels: 1 });
    let Compared { records, .. } = run(&comparison);
    assert!(records.rays.is_empty() && records.about.surfaces == 2);
    assert_eq!(records.left_out.len(), 1, "{:?}", records.left_out);
    assert!(records.left_out[0].reason.contains("2 surfaces"));
    assert_eq!(records.pictures.len(), 4);
    for record in &records.pictures {
        assert!(record.error.is_none() && record.times.is_some() && record.flicker_rms.is_some());
        // Both have the same map.
        assert_eq!(record.method.map_texels, 256 * 256);
    }
    let flip = |name: &str| picture(&records, name).flip;
    assert!(flip("exact") == 0.0 && flip("cone") < 0.01 && flip("bump") > 5.0 * flip("cone"));
    assert_eq!(picture(&records, "cone").method.bytes_a_texel(), 4.0);
}

#[test]
fn a_method_is_used_on_those_surfaces_that_can_have_it() {
    let mesh = Builtin::Torus.build([1.0, 1.0]).expect("a torus");
    let mut prism = Selection::exact();
    prism.choose("surface", "prism").expect("a surface");
    let ring = Surface::new(mesh, surface().height_map().clone()).with_selection(prism);
    let mut comparison = comparison(vec![surface(), ring.clone()], &["bump", "relief"]);
    comparison.rays = 0;
    let Compared { records, .. } = run(&comparison);
    let left_out: Vec<&str> = records.left_out.iter().map(|left| left.what.as_str()).collect();
    assert_eq!(left_out, ["bump on surface 2"]);
    assert_eq!(records.pictures.len(), 2);
    comparison.scene = comparison.scene.to_builder().surfaces(vec![ring.clone(), ring]).build().expect("two");
    let Compared { records, .. } = run(&comparison);
    assert_eq!((records.left_out[0].what.as_str(), records.pictures.len()), ("bump", 1));
}

#[test]
fn a_device_that_is_lost_in_the_middle_is_an_error() {
    if !has_adapter() {
        return;
    }
    let gpu = Gpu::new(AdapterChoice::Any).expect("an adapter");
    let mut comparison = comparison(vec![surface()], &["bump", "cone"]);
    comparison.rays = 0;
    comparison.machines = vec![Machine::gpu(Sampling::Exact)];
    let make = |machine: Machine| match machine.backend {
        MachineBackend::Cpu => Ok(Renderer::on_cpu()),
        MachineBackend::Gpu => Ok(Renderer::on_gpu(gpu.clone(), machine.sampling)),
    };
    let compared = comparison.run_on(&make, &Watch::none()).expect("a comparison");
    assert_eq!(compared.records.pictures.len(), 2);
    // Before the second method's picture.
    let progress = |what: &str, _: f32| {
        if what == "cone" {
            gpu.device().destroy();
        }
    };
    let watch = Watch::telling(&progress);
    let error = comparison.run_on(&make, &watch).map(drop).expect_err("the device is lost");
    let CompareError::Render { method, source } = error else { panic!("{error}") };
    assert!(method == "cone" && matches!(*source, RenderError::Gpu(GpuError::Lost(_))), "{method}: {source}");
}
