//! Blocks: planes with walls.

use super::*;
use relief_shaders::surface::Proposal;
use relief_shaders::{AMBIENT, SHADE, SHADOW, SURFACE};

/// Returns the scene of a map of 3 x 2 texels with these keys.
fn block(text: &str) -> Result<Scene, SceneError> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("map.pgm"), "P2 3 2 10 0 5 10 5 5 5").expect("a temporary file");
    let path = folder.path().join("scene.toml");
    fs::write(&path, format!("height = 'map.pgm'\n{text}")).expect("a temporary file");
    read_scene(&path)?.load()
}

fn variant(surface: &Surface, stage: usize) -> &'static str {
    surface.selection().choices[stage].entry.name
}

#[test]
fn a_block_is_a_relief_in_a_shell_and_walls_behind_all_surfaces() {
    let scene = block("walls = true\nscale = 0.1\nbase = '50%'").expect("a scene");
    let [relief, walls] = scene.surfaces() else { panic!("{} surfaces", scene.surfaces().len()) };
    assert_eq!(relief.selection().paths().proposal, Proposal::Shells);
    assert_eq!((relief.height_map().wrap(), walls.height_map().scale_m()), (Wrap::Clamp, 0.0));
    assert_eq!(variant(relief, SHADE), variant(walls, SHADE));
    // The relief keeps its own shadows, and nothing is beside the walls.
    assert_eq!([relief, walls].map(|surface| variant(surface, SHADOW)), ["ray", "none"]);
    let lowest = walls.mesh().vertices().iter().map(|vertex| vertex.position.y).fold(0.0, f32::min);
    // The plane is 1 m by 2/3 m, and its lowest texel 0.1 m below it.
    assert!((lowest + 0.1 + 1.0 / 3.0).abs() < 1e-6, "{lowest}");
    let two = "scale = 0.1\n[[surfaces]]\nwalls = true\nbase = 0.25\n[[surfaces]]\nposition = [0, 1, 0]";
    let scene = block(two).expect("a scene");
    let names: Vec<_> = scene.surfaces().iter().map(|surface| variant(surface, SURFACE)).collect();
    assert_eq!(
        (&names[..], variant(&scene.surfaces()[2], SHADOW)),
        (&["prism", "plane", "plane"][..], "map")
    );
    assert_eq!(block("").expect("a scene").surfaces().len(), 1);
    assert_eq!(block("walls = false").expect("a scene").surfaces().len(), 1);
}

#[test]
fn walls_follow_the_light_of_their_scene() {
    let scene = block("walls = true\nambient = 'environment'").expect("a scene");
    assert!(scene.surfaces().iter().all(|surface| surface.selection().sees_environment()));
    let scene = block("walls = true\nlook = 'plain'").expect("a scene");
    assert_eq!(variant(&scene.surfaces()[1], AMBIENT), "constant");
    let scene = block("walls = true\nmaterial = { shininess = 9 }").expect("a scene");
    assert_eq!(variant(&scene.surfaces()[1], SHADE), "blinn-phong");
}

#[test]
fn tiles_of_a_block_repeat() {
    let scene = block("walls = true\ntile = [2, 1]").expect("a scene");
    assert_eq!(scene.surfaces()[0].height_map().wrap(), Wrap::Repeat);
    let scene = block("walls = true\nwrap = 'mirror'").expect("a scene");
    assert_eq!(scene.surfaces()[0].height_map().wrap(), Wrap::Mirror);
    assert!(block("walls = true\nmethod = 'vertex'").is_ok());
}

#[test]
fn walls_that_would_not_fit_are_refused() {
    for (text, words) in [
        ("walls = true\nmesh = 'sphere'", &["walls", "plane and square"][..]),
        ("walls = true\nmethod = 'bump'", &["walls", "seen from the side", "prism"]),
        ("walls = true\nsurface = 'plane'", &["walls", "prism"]),
        ("walls = true\nmethod = 'slices-surface'", &["walls", "prism"]),
        ("base = 1", &["base", "needs walls"]),
        ("walls = true\nbase = 0", &["base: 0 is not possible", "above 0"]),
        ("walls = true\nbase = '-5%'", &["base: -0.05", "above 0"]),
        ("walls = true\nbase = nan", &["base", "above 0"]),
        ("walls = true\nbase = 'thick'", &["5%"]),
        ("walls = true\nobject = 'object.toml'", &["object"]),
        ("walls = true\nmax-memory = '200MiB'\ntile = [1e5, 1e5]", &["map.pgm", "memory"]),
    ] {
        let said = block(text).expect_err(text).to_string();
        assert!(words.iter().all(|word| said.contains(word)), "{text}: {said}");
    }
}
