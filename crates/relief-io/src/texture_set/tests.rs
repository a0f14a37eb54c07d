//! Names of real sets, and of folders that are none.

use std::error::Error;
use std::fs;

use tempfile::TempDir;

use super::TextureRole::*;
use super::*;

type Outcome = Result<(), Box<dyn Error>>;

const UP: Option<GreenSign> = Some(GreenSign::PlusY);
const DOWN: Option<GreenSign> = Some(GreenSign::MinusY);

/// Folder with empty files.
fn folder(names: &[&str]) -> std::io::Result<TempDir> {
    let folder = tempfile::tempdir()?;
    for name in names {
        fs::write(folder.path().join(name), "")?;
    }
    Ok(folder)
}

fn find(names: &[&str]) -> Result<TextureSet, Box<dyn Error>> {
    Ok(find_textures(folder(names)?.path(), None)?)
}

fn find_tile(names: &[&str], tile: u32) -> Result<TextureSet, Box<dyn Error>> {
    Ok(find_textures(folder(names)?.path(), Some(tile))?)
}

fn error(names: &[&str]) -> String {
    message(find(names))
}

/// Error of an outcome, as text.
fn message<T: fmt::Debug, E: fmt::Display>(outcome: Result<T, E>) -> String {
    outcome.map_or_else(|error| error.to_string(), |value| format!("no error but {value:?}"))
}

/// Files of a set, each with its role.
fn taken(set: &TextureSet) -> Vec<(String, TextureRole)> {
    set.textures.iter().map(|texture| (file_name(&texture.path), texture.role)).collect()
}

/// Files that were left, each with the reason.
fn left(set: &TextureSet) -> Vec<String> {
    set.left.iter().map(|(path, reason)| format!("{}: {reason}", file_name(path))).collect()
}

/// Checks that a set has exactly these files, in the order of the roles.
fn check(name: &str, files: &[(&str, TextureRole, Option<GreenSign>)]) -> Outcome {
    let names: Vec<&str> = files.iter().map(|(name, ..)| *name).collect();
    let set = find(&names)?;
    let found: Vec<(String, TextureRole, Option<GreenSign>)> =
        set.textures.iter().map(|texture| (file_name(&texture.path), texture.role, texture.green)).collect();
    let wanted: Vec<_> = files.iter().map(|(name, role, green)| (name.to_string(), *role, *green)).collect();
    assert_eq!((set.name.as_str(), found, left(&set)), (name, wanted, Vec::new()));
    Ok(())
}

/// Returns the role of a file that is alone in its folder.
fn role(name: &str) -> Option<(TextureRole, Option<GreenSign>)> {
    let textures = find(&[name]).map(|set| set.textures).unwrap_or_default();
    textures.first().map(|texture| (texture.role, texture.green))
}

#[test]
fn ambient_cg() -> Outcome {
    let files = [
        ("Bricks090_2K-PNG_Color.png", Color, None),
        ("Bricks090_2K-PNG_Displacement.png", Height, None),
        ("Bricks090_2K-PNG_NormalGL.png", Normal, UP),
        ("Bricks090_2K-PNG_Roughness.png", Roughness, None),
        ("Bricks090_2K-PNG_Metalness.png", Metallic, None),
        ("Bricks090_2K-PNG_AmbientOcclusion.png", Occlusion, None),
        ("Bricks090_2K-PNG_Emission.png", Emission, None),
        ("Bricks090_2K-PNG_Opacity.png", Opacity, None),
    ];
    check("Bricks090", &files)?;
    // Its archives also have the other normal map, a preview and descriptions.
    let set = find(&[
        "MetalPlates003_1K-JPG_Color.jpg",
        "MetalPlates003_1K-JPG_NormalDX.jpg",
        "MetalPlates003_1K-JPG_NormalGL.jpg",
        "MetalPlates003.png",
        "MetalPlates003_1K-JPG.usdc",
    ])?;
    assert_eq!(taken(&set).len(), 2);
    assert_eq!(
        left(&set),
        [
            "MetalPlates003.png: has no name of a texture",
            "MetalPlates003_1K-JPG.usdc: is not named as a picture that is read",
            "MetalPlates003_1K-JPG_NormalDX.jpg: \
             MetalPlates003_1K-JPG_NormalGL.jpg has the other direction of green",
        ]
    );
    assert_eq!(role("MetalPlates003_1K-JPG_NormalDX.jpg"), Some((Normal, DOWN)));
    Ok(())
}

#[test]
fn poly_haven() -> Outcome {
    let files = [
        ("brick_wall_003_diff_4k.jpg", Color, None),
        ("brick_wall_003_disp_4k.png", Height, None),
        ("brick_wall_003_nor_gl_4k.exr", Normal, UP),
        ("brick_wall_003_rough_4k.exr", Roughness, None),
        ("brick_wall_003_metal_4k.exr", Metallic, None),
        ("brick_wall_003_ao_4k.jpg", Occlusion, None),
        ("brick_wall_003_emission_4k.png", Emission, None),
        ("brick_wall_003_alpha_4k.png", Opacity, None),
        ("brick_wall_003_spec_4k.png", Specular, None),
    ];
    check("brick_wall_003", &files)?;
    assert_eq!(role("brick_wall_003_nor_dx_4k.exr"), Some((Normal, DOWN)));
    assert_eq!(role("brick_wall_003_arm_4k.jpg"), Some((Orm, None)));
    // Names of assets are no roles.
    for preview in ["rusty_metal_02.png", "rough_plaster_03.png", "metal_plate_preview.png"] {
        assert_eq!(role(preview), None, "{preview}");
    }
    Ok(())
}

#[test]
fn substance() -> Outcome {
    let files = [
        ("Rock_Base_Color.png", Color, None),
        ("Rock_Height.png", Height, None),
        ("Rock_Normal_OpenGL.png", Normal, UP),
        ("Rock_Roughness.png", Roughness, None),
        ("Rock_Metallic.png", Metallic, None),
        ("Rock_Mixed_AO.png", Occlusion, None),
        ("Rock_Emissive.png", Emission, None),
    ];
    check("Rock", &files)?;
    check(
        "Rock",
        &[("Rock_BaseColor.png", Color, None), ("Rock_OcclusionRoughnessMetallic.png", Orm, None)],
    )?;
    assert_eq!(role("Rock_Normal_DirectX.png"), Some((Normal, DOWN)));
    assert_eq!(role("Rock_Normal.png"), Some((Normal, None)));
    assert_eq!(role("Rock_AmbientOcclusion.png"), Some((Occlusion, None)));
    Ok(())
}

#[test]
fn unreal() -> Outcome {
    let files = [
        ("T_Rock_D.png", Color, None),
        ("T_Rock_H.png", Height, None),
        ("T_Rock_N.png", Normal, DOWN),
        ("T_Rock_E.png", Emission, None),
        ("T_Rock_ORM.png", Orm, None),
    ];
    check("T_Rock", &files)?;
    let files = [
        ("T_Rock_BC_01.png", Color, None),
        ("T_Rock_R_01.png", Roughness, None),
        ("T_Rock_M_01.png", Metallic, None),
        ("T_Rock_AO_01.png", Occlusion, None),
    ];
    check("T_Rock", &files)?;
    for other in ["Rock_D.png", "Rock_N.png", "Rock_BC.png"] {
        assert_eq!(role(other), None, "{other}");
    }
    let two = error(&["T_Sand_BC_01.png", "T_Sand_N_01.png", "T_Sand_BC_02.png", "T_Sand_N_02.png"]);
    assert!(two.contains("several sets, T_Sand 1, T_Sand 2:"), "{two}");
    Ok(())
}

#[test]
fn unity() -> Outcome {
    let files = [
        ("Wall_AlbedoTransparency.png", Color, None),
        ("Wall_Height.png", Height, None),
        ("Wall_Normal.png", Normal, None),
        ("Wall_Occlusion.png", Occlusion, None),
        ("Wall_Emission.png", Emission, None),
        ("Wall_MetallicSmoothness.png", MetallicSmoothness, None),
    ];
    check("Wall", &files)?;
    check("Wall", &[("Wall_Albedo.tif", Color, None), ("Wall_MaskMap.tif", MaskMap, None)])?;
    assert_eq!(role("Wall_Smoothness.png"), Some((Glossiness, None)));
    assert_eq!(role("Wall_SpecularSmoothness.png"), Some((Specular, None)));
    // A packed map that is not known is not taken for its last part.
    assert_eq!(role("Wall_MetallicOcclusionSmoothness.png"), None);
    assert_eq!(role("Wall_MetallicSmoothnessMaps.png"), Some((MetallicSmoothness, None)));
    Ok(())
}

#[test]
fn poliigon_writes_the_workflow_last() -> Outcome {
    let set = find(&[
        "MetalSpotty001_COL_2K_METALNESS.jpg",
        "MetalSpotty001_DISP16_2K_METALNESS.tif",
        "MetalSpotty001_DISP_2K_METALNESS.jpg",
        "MetalSpotty001_METALNESS_2K_METALNESS.jpg",
        "MetalSpotty001_NRM_2K_METALNESS.jpg",
        "MetalSpotty001_Sphere.jpg",
    ])?;
    assert_eq!(set.name, "MetalSpotty001");
    assert_eq!(
        taken(&set).iter().map(|(_, role)| *role).collect::<Vec<_>>(),
        [Color, Height, Normal, Metallic]
    );
    assert!(set.height()?.path.ends_with("MetalSpotty001_DISP16_2K_METALNESS.tif"));
    Ok(())
}

#[test]
fn german() -> Outcome {
    let files = [
        ("Ziegel_Farbe.png", Color, None),
        ("Ziegel_Hoehe.png", Height, None),
        ("Ziegel_Normale.png", Normal, None),
        ("Ziegel_Rauheit.png", Roughness, None),
        ("Ziegel_Metall.png", Metallic, None),
        ("Ziegel_Umgebungsverdeckung.png", Occlusion, None),
    ];
    check("Ziegel", &files)?;
    for height in ["Ziegel_Höhe.png", "Ziegel_Ho\u{308}he.png", "ZIEGEL-HÖHE.PNG"] {
        assert_eq!(role(height), Some((Height, None)), "{height}");
    }
    assert_eq!(role("Ziegel_Rauigkeit.png"), Some((Roughness, None)));
    Ok(())
}

#[test]
fn names_are_read_in_any_order_and_case() {
    for (name, wanted) in [
        ("wall height.png", Some(Height)),
        ("WALL-HEIGHT-V2.PNG", Some(Height)),
        ("wallHeight.png", Some(Height)),
        ("wall01Height.png", Some(Height)),
        ("Wall_HeightMap_2048x2048.tif", Some(Height)),
        ("height.exr", Some(Height)),
        ("wall_normal-ogl.png", Some(Normal)),
        ("wall_height_final.png", Some(Height)),
        ("wall_color_height_final.png", None),
        ("heightless.png", None),
        ("wall_depth.png", None),
        ("wall_height", None),
        ("wall_height.raw", None),
    ] {
        assert_eq!(role(name).map(|(role, _)| role), wanted, "{name}");
    }
}

#[test]
fn the_finest_file_is_taken() -> Outcome {
    let set = find(&["w_disp_1k.exr", "w_disp_4k.png", "w_disp_4k.jpg", "w_diff_8k.jpg", "w_bump_8k.png"])?;
    assert_eq!(taken(&set), [("w_diff_8k.jpg".to_owned(), Color), ("w_disp_4k.png".to_owned(), Height)]);
    assert_eq!(
        left(&set),
        [
            "w_bump_8k.png: w_disp_4k.png was taken for its role",
            "w_disp_1k.exr: w_disp_4k.png is finer",
            "w_disp_4k.jpg: w_disp_4k.png was taken for its role",
        ]
    );
    Ok(())
}

#[test]
fn packed_maps_give_what_no_other_map_gives() -> Outcome {
    let set = find(&["w_ARM.png", "w_roughness.png"])?;
    assert_eq!(taken(&set).len(), 2);
    assert_eq!(set.channel(Metallic).map(|(texture, channel)| (texture.role, channel)), Some((Orm, 2)));
    assert_eq!(set.channel(Roughness), None);

    let set = find(&["w_ao.png", "w_metal.png", "w_ORM.png", "w_rough.png"])?;
    assert_eq!(left(&set), ["w_ORM.png: its values are in w_ao.png, w_rough.png, w_metal.png"]);
    let set = find(&["w_MaskMap.png", "w_ORM.png", "w_MetallicSmoothness.png"])?;
    assert_eq!(
        left(&set),
        [
            "w_MaskMap.png: its values are in w_ORM.png",
            "w_MetallicSmoothness.png: its values are in w_ORM.png"
        ]
    );
    let set = find(&["w_gloss.png", "w_roughness.png"])?;
    assert_eq!(left(&set), ["w_gloss.png: its values are in w_roughness.png"]);
    Ok(())
}

#[test]
fn a_height_map_must_be_clear() -> Outcome {
    let set = find(&["w_albedo.png", "w_normal.png", "notes.png"])?;
    let text = message(set.height());
    let wanted = "the set 'w' has no height map, which is needed; it has w_albedo.png (colour), \
                  w_normal.png (normals): if notes.png is the height map, name it as the height, or rename \
                  it as in NAME_height.png";
    assert_eq!(text, wanted);
    for two in [
        ["w_height.png", "w_displacement.png"],
        ["w_height.png", "w_height_1k.png"],
        ["w_height.png", "w_height (1).png"],
    ] {
        let set = find(&two)?;
        assert!(set.textures.is_empty());
        let text = message(set.height());
        assert!(two.iter().all(|name| text.contains(name)) && text.contains("name the one"), "{text}");
    }
    let set = find(&["w_albedo.png", "w_diffuse.png"])?;
    assert_eq!(left(&set), ["w_diffuse.png: w_albedo.png was taken for its role"]);
    Ok(())
}

#[test]
fn tiles_are_chosen_by_number() -> Outcome {
    let names =
        ["w_Height.1001.exr", "w_Height.1002.exr", "w_Height.1024.exr", "w_Color.1002.png", "w_ao.png"];
    let text = error(&names);
    assert!(text.ends_with("has the UDIM tiles 1001, 1002, 1024: choose one"), "{text}");
    let set = find_tile(&names, 1002)?;
    assert_eq!(
        set.textures.iter().map(|texture| texture.udim).collect::<Vec<_>>(),
        [Some(1002), Some(1002), None]
    );
    assert_eq!(
        left(&set),
        ["w_Height.1001.exr: is of the UDIM tile 1001", "w_Height.1024.exr: is of the UDIM tile 1024"]
    );
    let text = message(find_tile(&names, 1003));
    assert!(text.ends_with("tile 1003; its tiles are 1001, 1002, 1024: choose one"), "{text}");
    let text = message(find_tile(&["w_Height.png"], 1001));
    assert!(text.ends_with("its names have no tiles: give no number"), "{text}");
    // One tile needs no choice, and a resolution alone is no tile.
    assert_eq!(find(&["w_1001_height.png"])?.height()?.udim, Some(1001));
    assert_eq!(find(&["w_1024_height.png"])?.height()?.udim, None);
    Ok(())
}

#[test]
fn several_sets_are_refused() -> Outcome {
    let text = error(&["Bricks090_1K_Color.png", "Bricks091_1K_Color.png", "wood_disp.png", "height.png"]);
    assert!(text.contains("several sets, Bricks090, Bricks091, wood: put each"), "{text}");
    let text = error(&["w_ao.png", "w_normal.png", "w_ao_2.png", "w_normal_2.png"]);
    assert!(text.contains("several sets, w, w 2:"), "{text}");
    let text = error(&["x_color_wood.png", "x_disp_wood.png", "x_color_tin.png", "x_disp_tin.png"]);
    assert!(text.contains("several sets, x tin, x wood:"), "{text}");
    assert_eq!(
        left(&find(&["w_ao.png", "w_ao_old.png"])?),
        ["w_ao_old.png: w_ao.png was taken for its role"]
    );
    assert!(find(&["w_height_old.png", "w_height.png"])?.height()?.path.ends_with("w_height.png"));
    assert_eq!(find(&["color_wall.png", "height_wall.png"])?.name, "wall");
    // Files named by their role alone belong to the set beside them, or to the folder's.
    assert_eq!(find(&["Brick_Color.png", "brick-normal.png", "height.png"])?.name, "Brick");
    let files = folder(&["color.png", "height.png"])?;
    assert_eq!(find_textures(files.path(), None)?.name, file_name(files.path()));
    Ok(())
}

#[test]
fn folders_without_a_set_give_clear_errors() -> Outcome {
    assert!(error(&[]).contains("has no file that is named as a picture"));
    assert!(error(&["notes.txt", ".w_height.png"]).contains("has no file that is named as a picture"));
    let files = folder(&["w_height.png", ".w_color.png", "._w_height.png"])?;
    fs::create_dir(files.path().join("w_normal.png"))?;
    let set = find_textures(files.path(), None)?;
    assert_eq!((set.textures.len(), left(&set)), (1, Vec::new()));

    let file = files.path().join("w_height.png");
    let text = message(find_textures(&file, None));
    assert!(text.contains("w_height.png: cannot be read as a folder ("), "{text}");
    assert!(matches!(find_textures(&files.path().join("none"), None), Err(TextureSetError::Folder { .. })));

    let many: Vec<String> = (0..5000).map(|number| format!("{number}.png")).collect();
    let text = error(&many.iter().map(String::as_str).collect::<Vec<_>>());
    assert!(text.contains("has more than 4096 entries"), "{text}");
    Ok(())
}

#[test]
fn no_name_makes_a_panic() {
    let parts = [
        "t_",
        "_",
        "É",
        "1k",
        "\u{308}",
        "Map",
        "METALNESS",
        "🧱",
        "Normal",
        "99999999999",
        "x",
        "0x0",
        "1001",
    ];
    let count = parts.len();
    for number in 0..count.pow(4) {
        let part = |place: u32| parts[number / count.pow(place) % count];
        let name = [part(0), part(1), part(2), part(3)].concat();
        assert!(FileName::read(&name).is_none_or(|read| read.stem.len() <= name.len()), "{name}");
    }
}
