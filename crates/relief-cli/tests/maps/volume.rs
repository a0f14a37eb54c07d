//! `relief volume` and `relief motif`: volumes come back as they were made, and bad input is refused.

use crate::common::aov::Aov;
use crate::common::command::{Folder, json_of};
use crate::common::maps::{Map, encoded};
use crate::common::meshes::obj;
use image::{GrayImage, ImageFormat, Luma, Rgba, RgbaImage};
use relief_core::mesh::sphere;
use relief_core::{Volume, Wrap};
use relief_io::{VolumeOptions, read_volume};

fn read(folder: &Folder, name: &str) -> Volume {
    read_volume(folder.path(name).as_path(), &VolumeOptions::default()).expect("a volume").volume
}

#[test]
fn a_motif_becomes_a_volume_that_tiles() {
    let folder = Folder::new();
    for kind in ["mail", "weave", "grass"] {
        let motif = json_of(&folder.relief(&format!("motif {kind} -o {kind}.glb --json")).fine());
        let depth = motif["depth"].as_f64().expect("a depth");
        let about = json_of(
            &folder.relief(&format!("volume {kind}.glb --size 48x48x24 -o {kind}.ktx2 --json")).fine(),
        );
        let zero = ["open_edges", "turned_edges", "odd_columns", "beyond"].map(|name| about[name].as_u64());
        assert_eq!(zero, [Some(0); 4], "{about}");
        assert_eq!((about["fit"].as_str(), about["solid_by"].as_str()), (Some("tile"), Some("winding")));
        let volume = read(&folder, &format!("{kind}.ktx2"));
        assert_eq!((volume.size(), volume.wrap()), ([48, 48, 24], Wrap::Repeat));
        // A voxel is free below and above, for which the volume reaches beyond the motif's depth.
        let (scale, bias) = (volume.atlas().scale_m(), volume.atlas().bias_m());
        let least = f64::min(scale * 23.0 / 24.0, depth);
        assert!((least..1.1 * depth).contains(&scale) && (-0.05 * depth..=0.0).contains(&bias), "{about}");
        let is_free =
            |k| (0..48).all(|j| (0..48).all(|i| f64::from(volume.voxel(i, j, k)) < Volume::SURFACE));
        assert!(is_free(0) && is_free(23), "{kind}");
        let solid = about["solid"].as_f64().expect("a share");
        assert!((0.005..0.7).contains(&solid), "{kind}: {solid}");
        // Steps over the tile's edge are no greater than inside.
        let step = |i: i64| -> f64 {
            let all = (0..24).flat_map(|k| (0..48).map(move |j| (j, k)));
            all.map(|(j, k)| f64::from((volume.voxel(i, j, k) - volume.voxel(i + 1, j, k)).abs())).sum()
        };
        let inside = (0..47).map(step).fold(0.0, f64::max);
        assert!(step(47) <= 1.2 * inside, "{kind}: {} {inside}", step(47));
    }
    let told = folder.relief("inspect mail.ktx2").fine().stdout;
    assert!(
        told.contains("48x48x24 voxels") && told.contains("16-bit") && told.contains("--wrap repeat"),
        "{told}"
    );
}

#[test]
fn the_same_command_gives_the_same_bytes() {
    let folder = Folder::new();
    folder.relief("motif mail -o a.glb").fine();
    folder.relief("motif mail -o b.glb").fine();
    let bytes = |name: &str| std::fs::read(folder.path(name)).expect("a file");
    assert_eq!(bytes("a.glb"), bytes("b.glb"));
    folder.relief("volume a.glb --size 24x20x12 --threads 1 -q -o a.ktx2").fine();
    folder.relief("volume a.glb --size 24x20x12 --threads 4 -q -o b.ktx2").fine();
    assert_eq!(bytes("a.ktx2"), bytes("b.ktx2"));
}

#[test]
fn meshes_keep_their_proportions_and_open_ones_are_told() {
    let folder = Folder::new();
    let ball = obj(&sphere(32, 16).expect("a sphere"));
    folder.write("ball.obj", &ball);
    let about =
        json_of(&folder.relief("volume ball.obj --size 32x32x32 --tile 2 -o ball.ktx2 --json").fine());
    let [scale, solid] = ["scale_m", "solid"].map(|name| about[name].as_f64().expect("a number"));
    // A ball of 30 of 32 voxels in a tile of 2 m.
    assert!((scale - 2.0).abs() < 0.05 && (solid - 0.43).abs() < 0.02, "{about}");
    let faces = ball.lines().filter(|line| line.starts_with("f ")).count();
    let mut left = faces - 3;
    let open: String = ball
        .lines()
        .filter(|line| {
            left = left.saturating_sub(usize::from(line.starts_with("f ")));
            !line.starts_with("f ") || left > 0
        })
        .map(|line| format!("{line}\n"))
        .collect();
    folder.write("open.obj", open);
    let ran = folder.relief("volume open.obj --size 16x16x16 -o open.ktx2");
    assert!(ran.code == Some(0) && ran.stderr.contains("edges are open"), "{}", ran.stderr);
}

#[test]
fn height_maps_keep_their_metres() {
    let folder = Folder::new();
    folder.write("hills.png", Map::hills().png());
    folder.relief("volume hills.png --size 32x32x16 --scale 10cm --bias -2cm -o hills.ktx2").fine();
    let volume = read(&folder, "hills.ktx2");
    let (scale, bias) = (volume.atlas().scale_m(), volume.atlas().bias_m());
    // Height 0 of the map lies a voxel above the floor, and height 1 a voxel below the top.
    assert!((bias + scale / 16.0 + 0.02).abs() < 1e-12 && (bias + scale * 15.0 / 16.0 - 0.08).abs() < 1e-12);
}

#[test]
fn numbered_pictures_are_slices() {
    let folder = Folder::new();
    for number in 1..=4u8 {
        let grey = GrayImage::from_fn(6, 5, |x, _| Luma([number * 10 + x as u8]));
        folder.write(&format!("grey{number}.png"), encoded(&grey.into(), ImageFormat::Png));
        let clear = RgbaImage::from_fn(6, 5, |x, _| Rgba([255, 0, 0, number * 10 + x as u8]));
        folder.write(&format!("clear{number}.png"), encoded(&clear.into(), ImageFormat::Png));
    }
    for name in ["grey", "clear"] {
        // Values below one half are nothing to be seen, which is said.
        let ran = folder.relief(&format!("volume {name}%d.png --bits 8 -o {name}.ktx2"));
        assert!(ran.code == Some(0) && ran.stderr.contains("no value is"), "{}", ran.stderr);
        let volume = read(&folder, &format!("{name}.ktx2"));
        assert_eq!(volume.size(), [6, 5, 4]);
        assert_eq!(volume.voxel(3, 2, 1), 23.0 / 255.0);
    }
    folder.write("grey3.png", encoded(&GrayImage::new(6, 4).into(), ImageFormat::Png));
    let ran = folder.relief("volume grey%d.png -o other.ktx2");
    assert!(ran.code == Some(1) && ran.stderr.contains("one size"), "{}", ran.stderr);
}

#[test]
fn bad_input_is_refused_and_leaves_no_file() {
    let folder = Folder::new();
    folder.write("ball.obj", obj(&sphere(16, 8).expect("a sphere")));
    folder.write("hills.png", Map::hills().png());
    for (line, code, expected) in [
        ("volume ball.obj --size 0x8x8", 2, "at least one voxel"),
        ("volume ball.obj --size 8x8", 2, "WxHxD"),
        ("volume ball.obj --size 100000x100000x4000", 2, "too large"),
        ("volume ball.obj --size 8x8x5000", 2, "4096 slices"),
        ("volume ball.obj --size 512x512x512 --max-memory 64MiB", 1, "--max-memory"),
        ("volume ball.obj --size 8x8x8 --margin 4", 1, "margin"),
        ("volume ball.obj --reach 0", 2, "the reach is 0"),
        ("volume ball.obj --pores 3", 2, "--pores is for the sponge"),
        ("volume hills.png --fit stretch", 2, "--fit is for meshes"),
        ("volume ball.obj --channel r", 2, "--channel is for height maps"),
        ("volume ball.obj --scale -1", 2, "--scale"),
        ("volume ball.obj --tile 0", 2, "--tile"),
        ("volume sponge --pores 0", 2, "from 1 to 10000"),
        ("volume missing.obj", 1, "missing.obj"),
        ("volume grass", 2, "relief motif grass"),
        ("volume slice_%03d.png", 1, "slice_000.png"),
        ("volume hills.png --size 8x8x2", 2, "at least 3"),
        ("volume ball.obj --bits 12", 2, "12"),
    ] {
        let ran = folder.relief(&format!("{line} -o out.ktx2"));
        assert_eq!(ran.code, Some(code), "{line}: {}", ran.stderr);
        assert!(ran.stderr.contains(expected), "{line}: {}", ran.stderr);
        assert!(!folder.path("out.ktx2").exists(), "{line}");
    }
    for (line, expected) in [
        ("motif mail --links 0", "from 1 to 128"),
        ("motif weave --yarns 3", "an even number"),
        ("motif grass --thickness 2", "thickness"),
        ("motif mail --yarns 4", "--yarns is for weave"),
        ("motif knit", "knit"),
        ("motif weave --yarns 256 --detail 64", "--detail"),
    ] {
        let ran = folder.relief(&format!("{line} -o out.glb"));
        assert_eq!(ran.code, Some(2), "{line}: {}", ran.stderr);
        assert!(ran.stderr.contains(expected) && !folder.path("out.glb").exists(), "{line}: {}", ran.stderr);
    }
    let ran = folder.relief("motif mail -o out.obj");
    assert_eq!(ran.code, Some(2), "{}", ran.stderr);
}

#[test]
fn what_takes_no_volume_says_what_does() {
    let folder = Folder::new();
    folder.relief("volume sponge --size 8x8x8 -o sponge.ktx2").fine();
    folder.write("hills.png", Map::hills().png());
    let bytes = std::fs::read(folder.path("sponge.ktx2")).expect("the volume");
    folder.write("cut.ktx2", &bytes[..5]);
    for (line, code, expected) in [
        ("render sponge.ktx2 --method bump -o out.png", 2, "'voxels'"),
        ("render sponge.ktx2 --method cone -o out.png", 2, "'voxels'"),
        ("render hills.png --search voxels --refine trilinear -o out.png", 2, "give a volume"),
        ("render hills.png --method generalised -o out.png", 2, "give a volume"),
        ("explain sponge.ktx2 -o out.svg", 2, "volume"),
        ("compare sponge.ktx2 -o out.html", 1, "volume"),
        ("mesh sponge.ktx2 -o out.glb", 2, "volume"),
        ("height deband sponge.ktx2 -o out.png", 1, "KTX2"),
        ("render --height sponge.ktx2 -o out.png", 1, "KTX2"),
        ("inspect cut.ktx2", 1, "ends too early"),
        ("render cut.ktx2 -o out.png", 1, "ends too early"),
    ] {
        let ran = folder.relief(line);
        assert_eq!(ran.code, Some(code), "{line}: {}", ran.stderr);
        assert!(ran.stderr.contains(expected), "{line}: {}", ran.stderr);
        // Nothing is named that does not work either.
        let wrong =
            ["'cone',", "or 'none'", "--height:", "--raw"].into_iter().find(|it| ran.stderr.contains(it));
        assert_eq!(wrong, None, "{line}: {}", ran.stderr);
    }
}

/// A volume that light shines through: how dense it is, what is refused, and what is behind it.
#[test]
fn a_translucent_volume_lets_through_what_its_extinction_says() {
    let folder = Folder::new();
    folder.relief("volume sponge --size 9x9x9 -o sponge.ktx2").fine();
    let small = "--backend cpu --size 24x18 --samples 1 --tile-size 1,1 --scale 0.1";
    let mean = |flags: &str| {
        folder
            .relief(&format!("render sponge.ktx2 --method translucent {small} {flags} -o a.png --aov a.exr"))
            .fine();
        let aov = Aov::read(&folder.path("a.exr"));
        let values = aov.plane("transmittance");
        values.iter().map(|value| f64::from(*value)).sum::<f64>() / values.len() as f64
    };
    let [clear, thin, usual, dense] = ["--extinction 0", "--extinction 5", "", "--extinction 500"].map(mean);
    assert!(
        clear == 1.0 && 1.0 > thin && thin > usual && usual > dense && dense > 0.0,
        "{clear} {thin} {usual} {dense}"
    );
    // Without the flag it is 8 over the scale.
    assert_eq!(usual, mean("--extinction 80"));
    assert_eq!(usual, mean("--set search.extinction=80"));
    folder.write("hills.png", Map::hills().png());
    for (line, expected) in [
        ("--method translucent --extinction -1", "from 0 to 1e12"),
        ("--method translucent --extinction nan", "from 0 to 1e12"),
        ("--method translucent --extinction 5 --set search.extinction=6", "extinction"),
        ("--method voxels --extinction 5", "translucent"),
        ("--method translucent --surface plane", "'prism'"),
        ("--method translucent --shadow soft", "'map'"),
    ] {
        let ran = folder.relief(&format!("render sponge.ktx2 {small} {line} -o b.png"));
        assert!(ran.code == Some(2) && ran.stderr.contains(expected), "{line}: {ran:?}");
        assert!(!folder.path("b.png").exists(), "{line}");
    }
    let ran = folder.relief(&format!("render hills.png {small} --method translucent -o b.png"));
    assert!(ran.code == Some(2) && ran.stderr.contains("give a volume"), "{ran:?}");
}

/// Blades thinner than a voxel break into pieces, which the command says; thick links do not.
#[test]
fn parts_thinner_than_a_voxel_are_told() {
    let folder = Folder::new();
    folder.relief("motif grass -o grass.glb").fine();
    folder.relief("motif mail -o mail.glb").fine();
    let told = folder.relief("volume grass.glb -o grass.ktx2");
    assert!(told.code == Some(0) && told.stderr.contains("--size"), "{told:?}");
    let about = json_of(&folder.relief("volume mail.glb -o mail.ktx2 --json").fine());
    assert!(about["thin"].as_f64().is_some_and(|thin| thin < 0.01), "{about}");
}

#[test]
fn a_volume_without_anything_solid_is_told() {
    let folder = Folder::new();
    folder.relief("motif weave -o weave.glb").fine();
    let ran = folder.relief("volume weave.glb --size 1x1x3 --margin 0 -o one.ktx2");
    assert!(ran.code == Some(0) && ran.stderr.contains("--size"), "{}", ran.stderr);
    folder.relief("volume weave.glb --size 32x32x16 -o cloth.ktx2").fine();
}
