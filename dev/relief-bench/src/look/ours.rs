//! Pictures of Relief: a sphere without a relief, shaded by `metallic-roughness`.

use std::sync::Arc;

use glam::Vec3;
use relief_core::{HeightMap, Watch, Wrap};
use relief_io::Picture;
use relief_maps::Maps;
use relief_render::{Renderer, picture};
use relief_scene::environment::Environment;
use relief_scene::light::Light;
use relief_scene::material::Material;
use relief_scene::tone::Tone;
use relief_scene::{Look, Scene, Surface};
use relief_shaders::Selection;

use super::{BASE, Case, LIGHT, Set, Shown};

/// Renders a picture for every case.
pub fn pictures(set: &Set, cases: &[Case], around: &[Picture]) -> Result<Vec<Shown>, String> {
    let around: Result<Vec<_>, _> = around.iter().map(Environment::from_equirectangular).collect();
    let around: Vec<_> = around.map_err(|error| error.to_string())?.into_iter().map(Arc::new).collect();
    let (mut renderer, mut maps) = (Renderer::on_cpu(), Maps::in_memory());
    let shown = cases.iter().map(|case| {
        let scene = scene(set, case, &around)?;
        let rendered = renderer.render(&scene, &mut maps, &Watch::none());
        let rendering = rendered.map_err(|error| error.to_string())?.rendering;
        let bytes = picture::srgb8(&rendering, &scene);
        let colours = bytes.as_chunks::<3>().0.iter();
        let covered = rendering.pixels.iter().map(|pixel| pixel.hit == 1);
        Ok(colours.zip(covered).map(|(colour, covered)| covered.then_some(*colour)).collect())
    });
    shown.collect()
}

fn scene(set: &Set, case: &Case, around: &[Arc<Environment>]) -> Result<Scene, String> {
    let text = |error: &dyn std::fmt::Display| error.to_string();
    let mut selection = Selection::method("bump").map_err(|error| text(&error))?;
    let ambient = if case.around.is_some() { "environment" } else { "constant" };
    for (key, name) in
        [("detail", "none"), ("shade", "metallic-roughness"), ("shadow", "none"), ("ambient", ambient)]
    {
        selection.choose(key, name).map_err(|error| text(&error))?;
    }
    let flat = HeightMap::new(1, 1, vec![1.0], Wrap::Repeat).map_err(|error| text(&error))?;
    let flat = flat.with_displacement(0.1, -0.1).map_err(|error| text(&error))?;
    let material = Material::metallic_roughness(BASE.as_vec3(), case.metallic, case.roughness);
    let surface = Surface::new(Arc::clone(&set.mesh), flat)
        .with_selection(selection)
        .with_material(material.map_err(|error| text(&error))?);
    let mut scene = Scene::builder(surface)
        .look(Look::Plain)
        .camera(set.camera)
        .size(set.size, set.size)
        .samples(1)
        .exposure(0.0)
        .tone(Tone::None)
        .ambient(Vec3::ZERO)
        .background(Vec3::ZERO);
    scene = match case.around {
        Some(place) => scene.lights(Vec::new()).environment(Arc::clone(&around[place])),
        None => {
            let light = Light::directional(LIGHT, Vec3::ONE).map_err(|error| text(&error))?;
            scene.lights(vec![light])
        }
    };
    scene.build().map_err(|error| text(&error))
}
