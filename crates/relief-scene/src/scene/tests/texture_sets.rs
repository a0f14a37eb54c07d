//! Surfaces whose maps are found in a folder.

use super::*;
use relief_io::omissions;

/// Writes pictures of one grey texel with these names into a folder.
fn write_set(folder: &Path, names: &[&str]) {
    fs::create_dir_all(folder).expect("a temporary folder");
    for (number, name) in names.iter().enumerate() {
        fs::write(folder.join(name), format!("P2 1 1 255 {}", 10 * (number + 1))).expect("a temporary file");
    }
}

/// Returns the scene with these keys, with a folder `set` of these files beside it.
fn loaded(names: &[&str], text: &str) -> Result<Scene, SceneError> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    write_set(&folder.path().join("set"), names);
    fs::write(folder.path().join("own.pgm"), "P2 1 1 255 255").expect("a temporary file");
    let path = folder.path().join("scene.toml");
    fs::write(&path, format!("textures = 'set'\n{text}")).expect("a temporary file");
    read_scene(&path)?.load()
}

#[test]
fn maps_are_taken_by_their_names() {
    let names = ["Wall_Height.pgm", "Wall_Color.pgm", "Wall_Roughness.pgm", "Wall_Opacity.pgm", "readme.txt"];
    let scene = loaded(&names, "").expect("a scene");
    let surface = &scene.surfaces()[0];
    assert_eq!(surface.height_map().texels(), [10.0 / 255.0]);
    assert!(surface.color().is_some() && surface.normal_map().is_none());
    let maps = surface.material_maps().expect("maps");
    assert_eq!(maps.texels()[0][..3], [1.0, 30.0 / 255.0, 1.0]);
    let said = |row| {
        let of_row = scene.notes().iter().filter(|note| *note.remark.row == row);
        of_row.map(|note| note.remark.text.clone()).collect::<Vec<_>>()
    };
    let [taken] = &said(omissions::TEXTURE_SET)[..] else { panic!("one note") };
    assert!(names[..3].iter().all(|name| taken.contains(name)), "{taken}");
    let [left] = &said(omissions::LEFT_TEXTURES)[..] else { panic!("one note") };
    assert!(names[3..].iter().all(|name| left.contains(name)), "{left}");
}

#[test]
fn given_maps_go_before_those_of_a_set() {
    let names = ["Wall_Height.pgm", "Wall_Roughness.pgm", "Wall_ORM.pgm"];
    let scene = loaded(&names, "height = 'own.pgm'\nmetallic = 'own.pgm'").expect("a scene");
    let surface = &scene.surfaces()[0];
    assert_eq!(surface.height_map().texels(), [1.0]);
    let packed = 30.0 / 255.0;
    assert_eq!(surface.material_maps().expect("maps").texels()[0][..3], [packed, 20.0 / 255.0, 1.0]);
    let taken = |scene: &Scene| scene.notes()[0].remark.text.clone();
    assert!(taken(&scene).ends_with(": roughness from Wall_Roughness.pgm, occlusion from Wall_ORM.pgm"));
    // Blinn-Phong reads none of them.
    let scene = loaded(&names, "material = { shininess = 3 }").expect("a scene");
    assert!(scene.surfaces()[0].material_maps().is_none());
}

#[test]
fn surfaces_have_sets_of_their_own() {
    let text = "[[surfaces]]\n[[surfaces]]\ntextures = 'other'";
    let folder = tempfile::tempdir().expect("a temporary folder");
    write_set(&folder.path().join("set"), &["A_Height.pgm"]);
    write_set(&folder.path().join("other"), &["B_Color.pgm", "B_Height.pgm"]);
    let path = folder.path().join("scene.toml");
    fs::write(&path, format!("textures = 'set'\n{text}")).expect("a temporary file");
    let scene = read_scene(&path).and_then(|spec| spec.load()).expect("a scene");
    let heights: Vec<f32> = scene.surfaces().iter().map(|surface| surface.height_map().texels()[0]).collect();
    assert_eq!(heights, [10.0 / 255.0, 20.0 / 255.0]);
    assert!(scene.surfaces()[0].color().is_none());
}

#[test]
fn unclear_folders_are_refused() {
    for (names, text) in [
        (&["Wall_Color.pgm"][..], ""),
        (&[][..], ""),
        (&["Wall_Height.1001.pgm", "Wall_Height.1002.pgm"][..], ""),
        (&["Wall_Height.1001.pgm"][..], "udim = 1003"),
    ] {
        let error = loaded(names, text).expect_err("no clear set");
        assert!(matches!(error, SceneError::Textures(_)), "{names:?}: {error}");
    }
    let scene = loaded(&["Wall_Height.1001.pgm", "Wall_Height.1002.pgm"], "udim = 1002").expect("a scene");
    assert_eq!(scene.surfaces()[0].height_map().texels(), [20.0 / 255.0]);
}

#[test]
fn a_map_of_a_set_can_be_dropped() {
    let names = ["Wall_Height.pgm", "Wall_Color.pgm", "Wall_Roughness.pgm", "Wall_Metallic.pgm"];
    let scene = loaded(&names, "color = 'none'\nroughness = 'none'").expect("a scene");
    let surface = &scene.surfaces()[0];
    assert!(surface.color().is_none());
    assert_eq!(surface.material_maps().expect("maps").texels()[0][..3], [1.0, 1.0, 40.0 / 255.0]);
    let left = &scene.notes()[1].remark.text;
    assert!(
        left.contains("Wall_Color.pgm (colour is dropped), Wall_Roughness.pgm (roughness is dropped)"),
        "{left}"
    );
    // Without maps of a material the shading is free.
    let text = "roughness = 'none'\nmetallic = 'none'\nshade = 'blinn-phong'";
    assert!(loaded(&names, text).expect("a scene").surfaces()[0].material_maps().is_none());
    // A height map is needed.
    assert!(matches!(loaded(&names, "height = 'none'"), Err(SceneError::Read(_))));
}
