//! Looks: what they say of a scene, and what takes their place.

use super::*;
use crate::background::Background;
use relief_shaders::{AMBIENT, SHADOW};

fn surface() -> Surface {
    let bumps = |i: u32, j: u32| ((i * 7 + j * 3) % 11) as f32 / 10.0;
    let map = HeightMap::from_fn(16, 16, Wrap::Repeat, bumps).expect("a map");
    let map = map.with_displacement(0.05, -0.05).expect("a displacement");
    Surface::new(Builtin::Plane.build([1.0, 1.0]).expect("a mesh"), map)
}

fn scene(look: Look) -> Scene {
    Scene::builder(surface()).look(look).build().expect("a scene")
}

/// The names of the ambient light and of the shadow of each surface.
fn stages(scene: &Scene) -> Vec<[&'static str; 2]> {
    let of = |surface: &Surface| [AMBIENT, SHADOW].map(|at| surface.selection().choices[at].entry.name);
    scene.surfaces().iter().map(of).collect()
}

/// The scene of a file that shows the noise map, once for each of these surfaces.
fn loaded(toml: &str) -> Scene {
    let map = shipped("data/noise.png");
    let text = format!("height = {:?}\n{toml}", map.to_string_lossy());
    read(&text).and_then(|spec| spec.load()).unwrap_or_else(|error| panic!("{error} in:\n{text}"))
}

#[test]
fn the_key_light_comes_from_the_upper_left_before_the_camera() {
    for look in [Look::Studio, Look::Sun] {
        for view in View::ALL {
            let scene = Scene::builder(surface()).look(look).fitted_camera(view, 40.0).build();
            let scene = scene.expect("a scene");
            let camera = scene.camera();
            let [Light::Directional { toward, .. }] = scene.lights() else { panic!("one light far away") };
            let [right, up, away] =
                [camera.right(), camera.up(), camera.forward()].map(|axis| toward.dot(axis));
            assert!(right < -0.3 && up > 0.3 && away < -0.1, "{look}, {view}: {right}, {up}, {away}");
        }
    }
    assert!(scene(Look::Overcast).lights().is_empty());
}

#[test]
fn a_look_is_what_nothing_else_says() {
    let studio = scene(Look::Studio);
    let sky = Vec3::new(0.1, 0.2, 0.3);
    let light = Light::directional(DVec3::Y, Vec3::ONE).expect("a light");
    let builder = Scene::builder(surface());
    let other = builder
        .lights(vec![light])
        .ambient(sky)
        .background(sky)
        .exposure(1.0)
        .tone(Tone::None)
        .look(Look::Studio)
        .build()
        .expect("a scene");
    assert_eq!((other.lights(), other.ambient()), (&[light][..], sky));
    assert_eq!((other.background(), other.exposure(), other.tone()), (sky.into(), 1.0, Tone::None));
    assert_eq!(other.camera(), studio.camera());
    assert_ne!((studio.ambient(), studio.background()), (sky, sky.into()));
    // The light keeps its direction and takes another diameter.
    let wide = Scene::builder(surface()).look(Look::Studio).light_angle(9.0).build().expect("a scene");
    let [Light::Directional { diameter_deg, .. }] = wide.lights() else { panic!("one light far away") };
    assert_eq!(*diameter_deg, 9.0);
    for bad in [-1.0, 91.0, f64::NAN] {
        let error =
            Scene::builder(surface()).look(Look::Studio).light_angle(bad).build().expect_err("no disc");
        assert_eq!(error.key, "light-angle");
    }
}

#[test]
fn a_direction_leaves_the_looks_light_its_colour() {
    let irradiance = |scene: &Scene| match scene.lights() {
        [Light::Directional { toward, irradiance, .. }] => (*toward, *irradiance),
        others => panic!("{others:?}"),
    };
    let (_, of_sun) = irradiance(&loaded("look = 'sun'"));
    assert_eq!(irradiance(&loaded("look = 'sun'\nlight = [0, 2, 0]")), (DVec3::Y, of_sun));
    assert!(of_sun.x > of_sun.z, "it is warm");
    for look in ["plain", "overcast"] {
        let (toward, white) = irradiance(&loaded(&format!("look = '{look}'\nlight = 'az=0,alt=90'")));
        assert!((toward - DVec3::Y).length() < 1e-12 && white == Vec3::ONE, "{look}");
    }
    for bad in [DVec3::ZERO, DVec3::NAN] {
        assert!(Scene::builder(surface()).look(Look::Sun).light_toward(bad).build().is_err(), "{bad}");
    }
}

#[test]
fn plain_is_what_programs_and_old_files_have() {
    let plain = scene(Look::Plain);
    let default = Scene::builder(surface()).build().expect("a scene");
    assert_eq!(format!("{plain:?}"), format!("{default:?}"));
    assert_eq!(
        plain.lights(),
        [Light::directional(DVec3::new(-0.6, 0.6, -0.1), Vec3::ONE).expect("a light")]
    );
    assert_eq!((plain.ambient(), plain.background()), (Vec3::splat(0.12), Vec3::splat(0.05).into()));
    assert_eq!((plain.tone(), stages(&plain)), (Tone::None, vec![["constant", "ray"]]));
}

#[test]
fn surfaces_see_the_sky_unless_they_name_another_light() {
    assert_eq!(stages(&loaded(""))[0][0], "sky");
    for (toml, expected) in [
        ("look = 'plain'", "constant"),
        ("look = 'overcast'", "sky"),
        ("ambient = 'constant'", "constant"),
        ("ambient = 'occlusion'", "occlusion"),
        ("ambient = [0.1, 0.1, 0.1]", "constant"),
        ("ambient-color = [0.1, 0.1, 0.1]", "sky"),
        ("ambient = [0.1, 0.1, 0.1]\ntransmission = 0.5", "environment"),
        ("set.ambient.azimuths = 16", "sky"),
        ("transmission = 0.5", "environment"),
        ("method = 'vertex'", "hemisphere"),
    ] {
        assert_eq!(stages(&loaded(toml))[0][0], expected, "{toml}");
    }
    // Of a flat map nothing hides the sky.
    let flat = HeightMap::new(1, 1, vec![1.0], Wrap::Repeat).expect("a map");
    let flat = Surface::new(square(1).expect("a mesh"), flat.with_displacement(0.0, 0.0).expect("none"));
    let built = Scene::builder(flat).look(Look::Studio).build().expect("a scene");
    assert_eq!(stages(&built)[0][0], "hemisphere");
}

#[test]
fn several_surfaces_throw_shadows_on_each_other_unless_plain() {
    let two = "[[surfaces]]\n[[surfaces]]\nmesh = 'sphere'\n";
    for (toml, expected) in [
        ("", "map"),
        ("look = 'plain'\n", "ray"),
        ("shadow = 'none'\n", "none"),
        ("shadow-search = 'linear'\n", "ray"),
        ("set.shadow-search.limit = 64\n", "ray"),
        ("set.shadow.size = 512\n", "map"),
    ] {
        let scene = loaded(&format!("{toml}{two}"));
        assert!(stages(&scene).iter().all(|[_, shadow]| *shadow == expected), "{toml}: {:?}", stages(&scene));
    }
    assert_eq!(stages(&loaded(""))[0][1], "ray");
    let both = Scene::builder(surface()).surface(surface());
    let both = both.look(Look::Studio).build().expect("a scene");
    assert_eq!(stages(&both), vec![["sky", "map"]; 2]);
}

#[test]
fn another_look_takes_the_place_of_what_a_file_says_of_light() {
    let file = "light = [0, 1, 0]\nambient = 'occlusion'\nambient-color = [1, 1, 1]\nbackground = [0, 0, 0]\n\
        exposure = 2\ntone = 'none'\neye = [1, 2, 3]\nlight-angle = 3\n";
    let over = |toml: &str| read(file).expect("a scene").overridden_by(read(toml).expect("keys"));
    let sun = over("look = 'sun'");
    let expected = SceneSpec { look: Some(Look::Sun), eye: Some([1.0, 2.0, 3.0]), ..SceneSpec::default() };
    assert_eq!(sun, expected);
    assert_eq!(over("tone = 'agx'").light, Some([0.0, 1.0, 0.0]));
    let both = over("look = 'sun'\nbackground = 'gradient'");
    assert_eq!(both.background, Some(Background::GRADIENT));
}

#[test]
fn looks_of_which_nothing_is_left_and_unknown_ones_are_refused() {
    let all = "view = 'top'\nlights = [{ direction = [0, 1, 0] }]\nambient = 'constant'\n\
        ambient-color = [1, 1, 1]\nbackground = 'gradient'\nexposure = 2\ntone = 'none'\n";
    assert!(read(all).is_ok());
    let error = read(&format!("look = 'studio'\n{all}")).expect_err("nothing is left of the look");
    assert!(error.to_string().contains("'studio' has no effect"), "{error}");
    for line in all.lines() {
        let but_one: String =
            all.lines().filter(|other| *other != line).map(|line| format!("{line}\n")).collect();
        read(&format!("look = 'studio'\n{but_one}")).unwrap_or_else(|error| panic!("{line}: {error}"));
    }
    let error = read("look = 'stduio'\n").expect_err("a typing error").to_string();
    assert!(error.contains("did you mean 'studio'"), "{error}");
    for bad in ["background = 'gradiant'\n", "background = 3\n", "background = [1, 2]\n"] {
        assert!(read(bad).is_err(), "{bad}");
    }
}
