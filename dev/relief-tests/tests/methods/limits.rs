//! Everything runs within the limits that small devices have, on a device that the caller has opened.

use relief_core::mesh::torus;
use relief_core::object::GridMapping;
use relief_core::{Volume, Watch, Wrap};
use relief_maps::Maps;
use relief_mesh::motif::MotifKind;
use relief_render::Renderer;
use relief_render::block_on;
use relief_render::gpu::Gpu;
use relief_render::wgpu::{DeviceDescriptor, Features, Instance, Limits, RequestAdapterOptions};
use relief_scene::{Scene, Surface};
use relief_shaders::field::Solids;
use relief_shaders::shadow::ShadowRole;
use relief_shaders::wgsl::Sampling;
use relief_shaders::{METHODS, OBJECT, SLICES, Selection, ambient, detail, shadow, surface};
use relief_testing::maps;
use relief_tests::adapter::has_adapter;
use relief_tests::motif_rays::motif_tree;
use relief_tests::spheres::grid_of_spheres;

/// A device of exactly those limits, and no feature.
fn opened(limits: Limits) -> Option<Gpu> {
    if !has_adapter() {
        return None;
    }
    let adapter = block_on(Instance::default().request_adapter(&RequestAdapterOptions::default()));
    let descriptor = DeviceDescriptor {
        required_features: Features::empty(),
        required_limits: limits,
        ..DeviceDescriptor::default()
    };
    let (device, queue) =
        block_on(adapter.expect("there is one").request_device(&descriptor)).expect("a device");
    Some(Gpu::of_device(device, queue, "the caller's own"))
}

/// Every method, and every other stage with one of them.
fn selections() -> Vec<Selection> {
    // What lights see need not be fine, and slices need not be many.
    let coarse = |mut selection: Selection| {
        if selection.light_views().is_some() {
            selection.set("shadow.size", 64.0).expect("a setting of this shadow");
        }
        if selection.uses(SLICES) {
            let count = if selection.uses(OBJECT) { 24.0 } else { 4.0 };
            selection.set("slices.count", count).expect("a setting of slices");
        }
        selection
    };
    let methods = METHODS.iter().map(|method| coarse(Selection::of(method).expect("a method")));
    let stages = [("shadow", shadow::ENTRIES), ("ambient", ambient::ENTRIES), ("detail", detail::ENTRIES)];
    let others = stages.into_iter().flat_map(|(stage, entries)| {
        // Rays through the whole scene are traced by the CPU alone.
        let entries =
            entries.iter().filter(|it| !matches!(it.shadow(), Some(ShadowRole::ThroughScene { .. })));
        entries.map(move |entry| {
            let mut selection = Selection::method("cone").expect("a method");
            selection.choose(stage, entry.name).expect("a listed name");
            coarse(selection)
        })
    });
    // The method that every surface under a relief can be used with.
    let under_relief = surface::ENTRIES.iter().filter(|entry| entry.paths().has_relief());
    let surfaces = under_relief.map(|entry| {
        let mut selection = Selection::method("relief").expect("a method");
        selection.choose("surface", entry.name).expect("a listed name");
        selection
    });
    methods.chain(others).chain(surfaces).collect()
}

/// Renders everything within these limits and looks whether there is something to be seen. Samplings take
/// turns, beginning with the one of that number: most of the time goes into compiling.
fn runs_within(limits: Limits, first: usize) {
    let Some(gpu) = opened(limits) else { return };
    let map = maps::ALL[2].build(Wrap::Repeat).with_displacement(0.05, -0.05).expect("lengths");
    for (turn, sampling) in Sampling::ALL.into_iter().enumerate() {
        let mut renderer = Renderer::on_gpu(gpu.clone(), sampling);
        let mut kept = Maps::in_memory();
        let is_its_turn = |number: usize| (number + first) % Sampling::ALL.len() == turn;
        for (_, selection) in selections().into_iter().enumerate().filter(|(number, _)| is_its_turn(*number))
        {
            let surface = match selection.object_cells() {
                None if selection.solids() == Solids::Motifs => {
                    let weave = motif_tree(MotifKind::Weave);
                    let torus = torus(32, 16).expect("a mesh");
                    Surface::new(torus, map.clone()).with_motif(weave, 0.05, -0.05).expect("lengths")
                }
                None if selection.solids() == Solids::Volumes => {
                    let ball = |[u, v, h]: [f64; 3]| {
                        0.5 + 8.0
                            * (0.3 - [u, v, h].map(|x| (x - 0.5) * (x - 0.5)).iter().sum::<f64>().sqrt())
                    };
                    let volume = Volume::from_fn([16; 3], Wrap::Repeat, ball).expect("a volume");
                    let volume = volume.with_displacement(0.05, -0.05).expect("lengths");
                    Surface::new(torus(32, 16).expect("a mesh"), map.clone()).with_volume(volume)
                }
                None => Surface::new(torus(32, 16).expect("a mesh"), map.clone()),
                Some(_) => {
                    let object = grid_of_spheres(GridMapping::Octahedral, 6, 32);
                    Surface::of_object(object).expect("something to see")
                }
            };
            let surface = surface.with_selection(selection);
            let scene = Scene::builder(surface).size(90, 70).samples(1).build().expect("a proper scene");
            let picture = renderer.render(&scene, &mut kept, &Watch::none()).expect("a picture").rendering;
            let covered = picture.pixels.iter().filter(|pixel| pixel.color.w > 0.0).count();
            let name = selection.choices.map(|choice| choice.entry.name);
            assert!(covered > 800, "{name:?} {sampling}: {covered} pixels");
        }
    }
}

#[test]
fn everything_runs_within_the_least_limits() {
    runs_within(Limits::downlevel_defaults(), 0);
}

#[test]
fn everything_runs_within_the_limits_of_the_web() {
    runs_within(Limits::defaults(), 1);
}
