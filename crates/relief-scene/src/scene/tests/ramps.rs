//! Surfaces with colours by height.

use super::*;
use crate::{RampChoice, RampError};
use relief_core::TexelMask;
use relief_io::{BuiltinRamp, ColorTable, Source, linear_to_srgb, omissions, read_color_table};

/// Text of a map of four texels: 0, 100, 200 and 250 of 250.
const MAP: &str = "P2 4 1 250 0 100 200 250";

/// Returns the scene of these keys, with a map `map.pgm` and a table `tints.txt` beside it.
fn loaded(table: &str, text: &str) -> Result<Scene, SceneError> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("map.pgm"), MAP).expect("a temporary file");
    fs::write(folder.path().join("tints.txt"), table).expect("a temporary file");
    let path = folder.path().join("scene.toml");
    fs::write(&path, format!("height = 'map.pgm'\n{text}")).expect("a temporary file");
    read_scene(&path)?.load()
}

/// Returns the colours of a surface's texels, as sRGB from 0 to 255.
fn colors(surface: &Surface) -> Vec<[u8; 3]> {
    let encoded = |part: f32| (255.0 * linear_to_srgb(f64::from(part))).round() as u8;
    let color = surface.color().expect("colours");
    color.texels.iter().map(|&[red, green, blue, _]| [red, green, blue].map(encoded)).collect()
}

#[test]
fn a_table_gives_each_texel_the_colour_of_its_elevation() {
    let table = "0 0 0 0\n100 100 50 0\n200 200 50 0\n";
    let scene = loaded(table, "ramp = 'tints.txt'\nunit = 'm'").expect("a scene");
    let surface = &scene.surfaces()[0];
    assert_eq!(colors(surface), [[0, 0, 0], [100, 50, 0], [200, 50, 0], [200, 50, 0]]);
    // A colour map is not darkened.
    assert_eq!(surface.material().diffuse(), Vec3::ONE);
    let scene = loaded("0% black\n100% white\n", "ramp = 'tints.txt'").expect("a scene");
    assert_eq!(colors(&scene.surfaces()[0]), [[0; 3], [102; 3], [204; 3], [255; 3]]);
    let grey = loaded("", "ramp = 'grey'").expect("a scene");
    assert_eq!(colors(&grey.surfaces()[0]), colors(&scene.surfaces()[0]));
    // White is deepest, so heights and elevations run the other way.
    let depth = loaded("0 black\n250 white\n", "ramp = 'tints.txt'\ndepth = true").expect("a scene");
    assert_eq!(colors(&depth.surfaces()[0]), [[0; 3], [102; 3], [204; 3], [255; 3]]);
    let depth = loaded("", "ramp = 'grey'\ndepth = true").expect("a scene");
    assert_eq!(colors(&depth.surfaces()[0]), [[0; 3], [102; 3], [204; 3], [255; 3]]);
}

#[test]
fn surfaces_share_the_colours_of_a_map() {
    let text = "ramp = 'terrain'\n[[surfaces]]\n[[surfaces]]\nposition = [0, 1, 0]";
    let scene = loaded("", text).expect("a scene");
    let [a, b] = scene.surfaces() else { panic!("two surfaces") };
    assert!(Arc::ptr_eq(a.color().expect("colours"), b.color().expect("colours")));
}

#[test]
fn opacities_are_noted_and_not_shown() {
    let scene = loaded("0 0 0 0 9\n250 white\n", "ramp = 'tints.txt'").expect("a scene");
    let notes: Vec<_> = scene.notes().iter().map(|note| note.remark.row).collect();
    assert_eq!(notes, [&omissions::TABLE_OPACITY]);
    assert_eq!(scene.surfaces()[0].cutoff(), 0.0);
}

#[test]
fn holes_have_the_colour_for_them() {
    let hills = HeightMap::new(3, 1, vec![0.0, 0.5, 1.0], Wrap::Clamp).expect("a map");
    let hole = TexelMask::from_fn(3, 1, |column, _| column == 2);
    let hills =
        hills.with_physical_range([100.0, 200.0]).and_then(|map| map.with_holes(hole)).expect("holes");
    let surface = |text: &str| {
        let table = read_color_table(Source::bytes("t", text.as_bytes())).expect("a table");
        Surface::new(square(1).expect("a square"), hills.clone()).with_ramp(&table)
    };
    // Percentages span the texels with a value.
    let with = surface("0% 0 0 0\n100% 100 100 100\nnv 1 2 3 0\n").expect("colours");
    assert_eq!(colors(&with), [[0; 3], [100; 3], [1, 2, 3]]);
    let without = surface("0% 0 0 0\n100% 100 100 100\n").expect("colours");
    assert_eq!(colors(&without)[2], [100; 3]);
}

#[test]
fn elevations_need_a_map_that_has_them() {
    let said = |table: &str, text: &str| loaded(table, text).expect_err(text).to_string();
    let metres = "236 green\n1076 white\n";
    let error = said(metres, "ramp = 'tints.txt'");
    for word in ["map.pgm", "236 to 1076", "0 to 250", "no unit", "50%"] {
        assert!(error.contains(word), "{error}");
    }
    // In metres the same values are a choice.
    assert!(loaded(metres, "ramp = 'tints.txt'\nunit = 'm'").is_ok());
    assert!(loaded("0 green\n300 white\n", "ramp = 'tints.txt'").is_ok());
    let map = HeightMap::new(1, 1, vec![0.0], Wrap::Clamp).expect("a map");
    let surface = Surface::new(square(1).expect("a square"), map);
    let table = read_color_table(Source::bytes("t", metres.as_bytes())).expect("a table");
    let error = surface.clone().with_ramp(&table).expect_err("no elevations");
    assert_eq!(error, RampError::UnknownElevations { table: [236.0, 1076.0] });
    assert!(surface.with_ramp(&ColorTable::from(BuiltinRamp::Viridis)).is_ok());
    let error = said("0 red\n1 2 3\n", "ramp = 'tints.txt'");
    assert!(error.contains("tints.txt: line 2: "), "{error}");
}

#[test]
fn elevations_that_heights_stand_for_have_the_colours_of_a_table() {
    // Texels 0, 0.4, 0.8 and 1 stand for 200, 600, 1000 and 1200 m.
    let table = "200 0 0 0\n600 100 50 0\n1000 200 50 0\n1200 250 50 0\n";
    let scene = loaded(table, "ramp = 'tints.txt'\nelevation = [200, '1.2km']").expect("a scene");
    let surface = &scene.surfaces()[0];
    assert_eq!(colors(surface), [[0, 0, 0], [100, 50, 0], [200, 50, 0], [250, 50, 0]]);
    assert_eq!(surface.height_map().physical_range(), Some([200.0, 1200.0]));
    assert!(scene.notes().is_empty(), "{:?}", scene.notes());
    // On ground of that size the relief has its true proportions.
    let ground = "elevation = [200, 1200]\ntile-size = [4000, 1000]";
    let scene = loaded("", ground).expect("a scene");
    let surface = &scene.surfaces()[0];
    assert!((surface.height_map().scale_m() - 0.25).abs() < 1e-12, "{}", surface.height_map().scale_m());
    // Values that are no metres are noted.
    let scene = loaded("236 green\n1076 white\n", "ramp = 'tints.txt'\nelevation = [0, 20000]");
    let notes: Vec<_> = scene.expect("a scene").notes().iter().map(|note| note.remark.row).collect();
    assert_eq!(notes, [&omissions::OUTSIDE_TABLE]);
    for bad in ["[3, 3]", "[2, 1]", "[1]", "[nan, 1]", "[0, 1e12]", "7"] {
        let error = loaded("", &format!("elevation = {bad}")).expect_err(bad).to_string();
        assert!(error.contains("elevation"), "{bad}: {error}");
    }
}

#[test]
fn a_relief_too_deep_for_its_surface_is_noted() {
    let rows = |text: &str| {
        let scene = loaded("", text).expect(text);
        scene.notes().iter().map(|note| note.remark.row.name).collect::<Vec<_>>()
    };
    assert_eq!(rows("scale = 840"), ["deep-relief"]);
    assert_eq!(rows("scale = 2\nexaggerate = 100"), ["deep-relief"]);
    for fine in ["", "scale = 3", "scale = 840\nmesh-scale = 1000", "elevation = [0, 840]"] {
        assert!(rows(fine).is_empty(), "{fine}: {:?}", rows(fine));
    }
}

#[test]
fn ramp_and_colour_map_exclude_each_other_and_replace_each_other() {
    let error = loaded("", "ramp = 'grey'\ncolor = 'map.pgm'").expect_err("both").to_string();
    assert!(error.contains("ramp: cannot be given together with color"), "{error}");
    let error = loaded("", "ramp = 'terain'").expect_err("a wrong name").to_string();
    assert!(["terain", "terrain", "tints.txt"].iter().all(|word| error.contains(word)), "{error}");
    let [color, ramp] = ["color = 'a.png'", "ramp = 'grey'"].map(|text| read(text).expect("a scene"));
    let both = [color.clone().overridden_by(ramp.clone()).surface, ramp.overridden_by(color).surface];
    assert_eq!(both[0].ramp, Some(RampChoice::Builtin(BuiltinRamp::Grey)));
    assert!(both[0].color.is_none() && both[1].ramp.is_none() && both[1].color.is_some());
    let of_mesh = format!("mesh = {:?}\nramp = 'grey'", shipped("data/pot.obj").to_string_lossy());
    let error = read(&of_mesh).expect_err("no heights").to_string();
    assert!(error.contains("ramp: needs height"), "{error}");
}
