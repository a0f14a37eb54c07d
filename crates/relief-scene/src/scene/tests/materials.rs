//! Materials of scenes: which shading they have, and which values and maps go together.

use super::*;
use crate::material::ShadingModel;
use crate::material_maps::MaterialMapError;

/// Returns the scene of a description over a flat map of one texel.
fn loaded(folder: &Path, text: &str) -> Result<Scene, SceneError> {
    let map = folder.join("flat.pgm");
    fs::write(&map, "P2 1 1 255 255").expect("a temporary file");
    let path = folder.join("scene.toml");
    fs::write(&path, format!("height = 'flat.pgm'\n{text}")).expect("a temporary file");
    read_scene(&path)?.load()
}

fn shading(scene: &Scene) -> &'static str {
    scene.surfaces()[0].selection().choices[relief_shaders::SHADE].entry.name
}

#[test]
fn the_shading_follows_from_the_look_and_from_the_values() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (plain, rough) = ("blinn-phong", "metallic-roughness");
    for (text, name) in [
        ("", rough),
        ("look = 'sun'", rough),
        ("look = 'plain'", plain),
        ("material = { diffuse = [1, 0, 0] }", plain),
        ("material = { shininess = 7 }", plain),
        ("look = 'plain'\nmaterial = { roughness = 0.25 }", rough),
        ("look = 'plain'\nmaterial = { emission = [1, 1, 1] }", rough),
        ("shade = 'blinn-phong'", plain),
        ("look = 'plain'\nshade = 'metallic-roughness'", rough),
        ("look = 'plain'\nroughness = 'flat.pgm'", rough),
    ] {
        let scene = loaded(folder.path(), text).unwrap_or_else(|error| panic!("{text}: {error}"));
        assert_eq!(shading(&scene), name, "{text}");
    }
    // Surfaces of programs: made for a model, or for any.
    let made = Material::new(Vec3::ONE, Vec3::ZERO, 3).expect("a material");
    let metal = Material::metallic_roughness(Vec3::ONE, 1.0, 0.5).expect("a material");
    for (material, look, name) in [
        (Material::default(), Look::Studio, rough),
        (Material::default(), Look::Plain, plain),
        (made, Look::Studio, plain),
        (metal, Look::Plain, rough),
    ] {
        let scene = Scene::builder(flat().with_material(material)).look(look).build().expect("a scene");
        assert_eq!(shading(&scene), name, "{:?} in {look}", material.model());
    }
}

#[test]
fn values_of_two_shadings_do_not_go_together() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (text, key) in [
        ("material = { shininess = 9, roughness = 0.5 }", "material"),
        ("material = { diffuse = [1, 1, 1] }\norm = 'flat.pgm'", "orm"),
        ("shade = 'blinn-phong'\nmaterial = { metallic = 1 }", "material"),
        ("shade = 'blinn-phong'\nemission = 'flat.pgm'", "emission"),
        ("shade = 'metallic-roughness'\nmaterial = { specular = [1, 1, 1] }", "material"),
        ("material = { base = [1, 1, 1.5] }", "material"),
        ("material = { roughness = -0.5 }", "material"),
        ("material = { roughness = nan }", "material"),
        ("material = { metallic = 1.5 }", "material"),
        ("material = { emission = [0, -1, 0] }", "material"),
        ("shade = 'blinn-phong'\nior = 1.4", "ior"),
    ] {
        match loaded(folder.path(), text) {
            Err(SceneError::Value(error) | SceneError::InFile { source: error, .. }) => {
                assert_eq!(error.key, key, "{text}");
            }
            other => panic!("{text}: {other:?}"),
        }
    }
}

#[test]
fn values_that_override_drop_those_of_the_other_shading() {
    let spec = |text: &str| toml::from_str::<MaterialSpec>(text).expect("a material");
    let plain = spec("diffuse = [1, 0, 0]\nshininess = 3");
    let over = spec("roughness = 0.5");
    assert_eq!(plain.clone().overridden_by(over.clone()), over);
    assert_eq!(over.clone().overridden_by(plain.clone()), plain);
    let both = over.overridden_by(spec("metallic = 1"));
    assert_eq!((both.roughness, both.metallic), (Some(0.5), Some(1.0)));
}

#[test]
fn maps_are_read_as_numbers_and_multiplied_by_1() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("half.pgm"), "P2 2 1 255 51 255").expect("a temporary file");
    let scene =
        loaded(folder.path(), "roughness = 'half.pgm'\nmaterial = { metallic = 0.5 }").expect("a scene");
    let surface = &scene.surfaces()[0];
    let maps = surface.material_maps().expect("maps");
    assert_eq!((maps.size(), maps.has_surface(), maps.has_emission()), ([2, 1], true, false));
    assert_eq!(maps.texels()[0][..3], [1.0, 0.2, 1.0]);
    let material = surface.material();
    assert_eq!((material.roughness(), material.metallic()), (1.0, 0.5));
    assert_eq!(material.model(), Some(ShadingModel::MetallicRoughness));
    // An emission is a colour in sRGB, and shows by itself.
    let scene = loaded(folder.path(), "emission = 'half.pgm'").expect("a scene");
    let surface = &scene.surfaces()[0];
    let emission = surface.material_maps().expect("maps").texels()[0][4];
    assert!((emission - 0.0331).abs() < 1e-4 && surface.material().emission() == Vec3::ONE, "{emission}");
}

#[test]
fn maps_beyond_memory_are_refused() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let texels = " 255".repeat(300 * 300);
    fs::write(folder.path().join("large.pgm"), format!("P2 300 300 255{texels}")).expect("a temporary file");
    let error = loaded(folder.path(), "size = [8, 8]\nmax-memory = '3MiB'\nroughness = 'large.pgm'");
    let Err(SceneError::MaterialMap { path, source: MaterialMapError::Memory { .. } }) = error else {
        panic!("{error:?}");
    };
    assert!(path.ends_with("large.pgm"));
}
