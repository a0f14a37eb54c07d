//! Materials of a mesh's file in pictures and captures.

use crate::common::command::{Folder, json_of};
use crate::common::maps::{Map, encoded};
use crate::common::meshes::{factor, folded, part, square};
use image::{DynamicImage, ImageFormat, Rgb, RgbImage, Rgba, RgbaImage};
use relief_io::{MeshOptions, read_mesh};
use relief_object::{ObjectOptions, read_object};

/// Renders a mesh from the front, lit so that its colours are the material's, and returns the
/// picture.
fn rendered(folder: &Folder, mesh: &str, backend: &str, more: &str) -> RgbImage {
    let samples = if more.contains("--samples") { "" } else { " --samples 1" };
    let line = format!(
        "render --height flat.png --mesh {mesh} --scale 0.000001 --projection orthographic --eye 0.5,0.5,3 \
         --target 0.5,0.5,0 --view-height 1 --size 40x40 --shadow none --look plain --light 0,0,1 \
         --ambient-color 0,0,0 --material specular=0,0,0 --backend {backend} {more}{samples} -o {mesh}.png"
    );
    let ran = folder.relief(&line);
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    image::open(folder.path(format!("{mesh}.png"))).expect("a picture").into_rgb8()
}

fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("flat.png", Map::constant(0.5).png());
    folder
}

#[test]
fn each_triangle_has_the_colours_of_its_material() {
    let folder = folder();
    let picture = RgbImage::from_fn(2, 2, |_, _| Rgb([0, 200, 0]));
    folder.write("green.png", encoded(&DynamicImage::ImageRgb8(picture), ImageFormat::Png));
    let green = r#"{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}"#;
    let pictures = r#", "images": [{"uri": "green.png"}], "textures": [{"source": 0}]"#;
    let parts = [part(2, 0), part(3, 1)].join(", ");
    let more = |second: &str| format!(r#", "materials": [{}, {second}]{pictures}"#, factor("1, 0, 0, 1"));
    square(&folder, "two.gltf", &parts, &more(&factor("0, 0, 1, 1")));
    square(&folder, "green.gltf", &parts, &more(green));
    // The lower triangle, right of the diagonal, and the upper one.
    for (mesh, upper) in [("two.gltf", [0, 0, 255]), ("green.gltf", [0, 200, 0])] {
        let shown = rendered(&folder, mesh, "cpu", "");
        for (at, wanted) in
            [([30, 20], [255, 0, 0]), ([20, 30], [255, 0, 0]), ([10, 20], upper), ([20, 10], upper)]
        {
            let pixel = shown.get_pixel(at[0], at[1]).0;
            let near = pixel.iter().zip(wanted).all(|(a, b)| a.abs_diff(b) <= 1);
            assert!(near, "{mesh} at {at:?}: {pixel:?}, not {wanted:?}");
        }
        let line = format!("capture {mesh} --size 32 --verify 2 -o object");
        let ran = folder.relief(&line);
        assert_eq!(ran.code, Some(0), "{}", ran.stderr);
        let object = read_object(&folder.path("object/object.toml"), &ObjectOptions::default()).expect("one");
        let texels = object.color.expect("colours").texels;
        let seen = |channel: usize| {
            let is =
                |texel: &&[f32; 4]| texel[3] > 0.0 && (0..3).all(|at| (texel[at] > 0.3) == (at == channel));
            texels.iter().filter(is).count()
        };
        let channel = if mesh == "two.gltf" { 2 } else { 1 };
        assert!(seen(0) > 300 && seen(channel) > 300, "{mesh}: {} and {}", seen(0), seen(channel));
        std::fs::remove_dir_all(folder.path("object")).expect("it is there");
    }
    // A given colour map colours all triangles.
    let given = rendered(&folder, "two.gltf", "cpu", "--color green.png");
    assert_eq!(given.get_pixel(30, 20), given.get_pixel(10, 20));
}

#[test]
fn both_backends_show_the_same_materials() {
    let folder = folder();
    folder.write("hills.png", Map::hills().png());
    let parts = [part(2, 0), part(3, 1)].join(", ");
    let materials = format!(r#", "materials": [{}, {}]"#, factor("1, 0, 0, 1"), factor("0, 1, 1, 1"));
    square(&folder, "two.gltf", &parts, &materials);
    let lines = ["cpu", "gpu"].map(|backend| {
        let line = format!(
            "render --height hills.png --mesh two.gltf --scale 0.1 --size 60x44 --samples 2 --shadow map \
             --backend {backend} --aov {backend}.exr -o {backend}.png"
        );
        folder.relief(&line)
    });
    if lines[1].code != Some(0) && std::env::var_os("RELIEF_REQUIRE_GPU").is_none() {
        println!("skipped: {}", lines[1].stderr);
        return;
    }
    for ran in &lines {
        assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    }
    let [cpu, gpu] =
        ["cpu.png", "gpu.png"].map(|name| image::open(folder.path(name)).expect("a picture").into_rgb8());
    let most = cpu.as_raw().iter().zip(gpu.as_raw()).map(|(a, b)| a.abs_diff(*b)).max();
    assert!(most <= Some(1), "{most:?}");
    let count = |is: fn(&Rgb<u8>) -> bool| cpu.pixels().filter(|pixel| is(pixel)).count();
    assert!(count(|pixel| pixel.0[0] > 2 * pixel.0[1].max(40)) > 200);
    assert!(count(|pixel| pixel.0[1] > 2 * pixel.0[0].max(40)) > 200);
}

#[test]
fn colours_of_vertices_are_shown() {
    let folder = folder();
    let attributes = r#"{"POSITION": 0, "TEXCOORD_0": 1, "COLOR_0": 5}"#;
    square(&folder, "yellow.gltf", &format!(r#"{{"attributes": {attributes}, "indices": 4}}"#), "");
    let shown = rendered(&folder, "yellow.gltf", "cpu", "");
    assert!(shown.pixels().all(|pixel| pixel.0 == [255, 255, 0]));
}

/// Blocks along a side of a picture of blocks, each of another colour.
const BLOCKS: u32 = 5;

/// The colour of a block.
fn block([i, j]: [u32; 2]) -> [u8; 3] {
    [i * 60, j * 60, 255 - 30 * (i + j)].map(|part| part as u8)
}

/// Holds a picture to what the specification has in the middles of its pixels. `wanted` makes
/// coordinates of the picture from 0 to 1 of a place on the square, from its upper left corner;
/// points beside the borders of blocks are left out.
fn assert_lies(what: &str, shown: &RgbImage, wanted: impl Fn([f64; 2]) -> [f64; 2]) {
    let mut points = 0;
    for (x, y, pixel) in shown.enumerate_pixels() {
        let at = wanted([x, y].map(|at| (f64::from(at) + 0.5) / 40.0)).map(|at| at * f64::from(BLOCKS));
        if at.iter().any(|at| (at - at.round()).abs() < 0.1) {
            continue;
        }
        let colour = block(at.map(|at| at as u32));
        let near = pixel.0.iter().zip(colour).all(|(a, b)| a.abs_diff(b) <= 1);
        assert!(near, "{what} at {x}, {y}: {:?}, not {colour:?}", pixel.0);
        points += 1;
    }
    assert!(points >= 400, "{what}: {points}");
}

#[test]
fn pictures_lie_where_the_specification_has_them() {
    let folder = folder();
    let blocks = RgbImage::from_fn(80, 80, |x, y| Rgb(block([x / 16, y / 16])));
    folder.write("blocks.png", encoded(&DynamicImage::ImageRgb8(blocks), ImageFormat::Png));
    let has_gpu = std::env::var_os("RELIEF_REQUIRE_GPU").is_some();
    let lies = |name: &str, uvs: u32, info: &str, sampler: &str, wanted: &dyn Fn([f64; 2]) -> [f64; 2]| {
        let attributes = format!(r#"{{"POSITION": 0, "TEXCOORD_0": {uvs}, "TEXCOORD_1": 6}}"#);
        let part = format!(r#"{{"attributes": {attributes}, "indices": 4, "material": 0}}"#);
        let more = format!(
            r#", "materials": [{{"pbrMetallicRoughness": {{"baseColorTexture": {{"index": 0{info}}}}}}}],
            "images": [{{"uri": "blocks.png"}}], "textures": [{{"source": 0, "sampler": 0}}],
            "samplers": [{{{sampler}}}]"#
        );
        square(&folder, name, &part, &more);
        assert_lies(name, &rendered(&folder, name, "cpu", ""), wanted);
        for sampling in ["exact", "fast"].into_iter().filter(|_| has_gpu) {
            let shown = rendered(&folder, name, "gpu", &format!("--sampling {sampling}"));
            assert_lies(&format!("{name} on a GPU, {sampling}"), &shown, wanted);
        }
    };
    let transform = |text: &str| format!(r#", "extensions": {{"KHR_texture_transform": {{{text}}}}}"#);
    let wraps = |wrap: u32| format!(r#""wrapS": {wrap}, "wrapT": {wrap}"#);
    let (clamp, mirror) = (wraps(33071), wraps(33648));
    let clamped = |at: f64| at.clamp(0.1, 0.9);
    let mirrored = |at: f64| 1.0 - (at.rem_euclid(2.0) - 1.0).abs();
    let repeated = |at: f64| at.rem_euclid(1.0);
    lies("plain.gltf", 1, "", "", &|at| at);
    lies("scale.gltf", 1, &transform(r#""scale": [2, 3]"#), "", &|[u, v]| [2.0 * u, 3.0 * v].map(repeated));
    let offset = transform(r#""offset": [0.3, -0.5]"#);
    let moved = |[u, v]: [f64; 2]| [u + 0.3, v - 0.5];
    lies("offset.gltf", 1, &offset, "", &|at| moved(at).map(repeated));
    lies("moved.gltf", 1, &offset, &clamp, &|at| moved(at).map(clamped));
    lies("folded.gltf", 1, &offset, &mirror, &|at| moved(at).map(mirrored));
    let turned = transform(r#""offset": [0, 1], "rotation": 1.57079632679, "scale": [0.5, 0.5]"#);
    lies("turned.gltf", 1, &turned, "", &|[u, v]| [0.5 * v, 1.0 - 0.5 * u]);
    let second = r#", "texCoord": 1"#;
    lies("second.gltf", 1, second, "", &|[u, v]| [1.0 - u, v]);
    lies("set.gltf", 1, &transform(r#""texCoord": 1"#), "", &|[u, v]| [1.0 - u, v]);
    lies("wide.gltf", 7, "", "", &|[u, v]| [repeated(3.0 * u - 1.0), v]);
    lies("clamped.gltf", 7, "", &clamp, &|[u, v]| [clamped(3.0 * u - 1.0), v]);
    lies("mirrored.gltf", 7, "", &mirror, &|[u, v]| [mirrored(3.0 * u - 1.0), v]);
}

/// A card with a disc of radius 25 of 64 texels on it, of that alpha mode.
fn card(folder: &Folder, mode: &str) -> String {
    let leaf = RgbaImage::from_fn(64, 64, |x, y| {
        let [x, y] = [x, y].map(|at| f64::from(at) - 31.5);
        Rgba([40, 180, 40, if x * x + y * y < 625.0 { 255 } else { 0 }])
    });
    folder.write("leaf.png", encoded(&DynamicImage::ImageRgba8(leaf), ImageFormat::Png));
    let material = format!(
        r#", "materials": [{{"pbrMetallicRoughness": {{"baseColorTexture": {{"index": 0}}}},
        "alphaMode": "{mode}", "doubleSided": true}}], "images": [{{"uri": "leaf.png"}}],
        "textures": [{{"source": 0}}]"#
    );
    let name = format!("{mode}.gltf");
    square(folder, &name, &part(4, 0), &material);
    name
}

/// Returns the share of a picture that shows the leaf, which is green.
fn green(picture: &RgbImage) -> f64 {
    let is_green = |pixel: &&Rgb<u8>| u32::from(pixel.0[1]) > 20 + 2 * u32::from(pixel.0[0]);
    picture.pixels().filter(is_green).count() as f64 / (picture.width() * picture.height()) as f64
}

/// The disc of the card: its opacity is 0.5 at a radius of 25 texels.
const DISC: f64 = std::f64::consts::PI * 625.0 / 4096.0;

#[test]
fn pictures_show_what_is_behind_a_mask() {
    let folder = folder();
    for backend in ["cpu", "gpu"] {
        if backend == "gpu" && std::env::var_os("RELIEF_REQUIRE_GPU").is_none() {
            continue;
        }
        for (mode, wanted) in [("OPAQUE", 1.0), ("MASK", DISC), ("BLEND", DISC)] {
            let mesh = card(&folder, mode);
            for more in ["", "--samples 4", "--method vertex", "--surface prism"] {
                let shown = green(&rendered(&folder, &mesh, backend, more));
                assert!((shown - wanted).abs() < 0.02, "{mode} {backend} {more}: {shown}, not {wanted}");
            }
        }
    }
    // With the factor's opacity alone; with a cutoff above 1 nothing is seen.
    for (name, factor, cutoff, wanted) in [
        ("a.gltf", "0, 1, 0, 0.4", 0.5, 0.0),
        ("b.gltf", "0, 1, 0, 0.4", 0.4, 1.0),
        ("c.gltf", "0, 1, 0, 1", 1.5, 0.0),
        ("d.gltf", "0, 1, 0, 0", 0.0, 1.0),
    ] {
        let material = format!(
            r#", "materials": [{{"pbrMetallicRoughness": {{"baseColorFactor": [{factor}]}},
            "alphaMode": "MASK", "alphaCutoff": {cutoff}}}]"#
        );
        square(&folder, name, &part(4, 0), &material);
        let shown = green(&rendered(&folder, name, "cpu", ""));
        assert!(shown == wanted, "{factor} {cutoff}: {shown}");
    }
}

#[test]
fn light_goes_through_masks() {
    let folder = folder();
    folder.write("plane.png", Map::constant(0.5).png());
    let lit = |mode: &str| {
        let mesh = card(&folder, mode);
        folder.write(
            "scene.toml",
            format!(
                "look = 'plain'\nsize = [48, 48]\nsamples = 1\nprojection = 'orthographic'\n\
                 eye = [0.5, 0.5, 3]\n\
                 target = [0.5, 0.5, -1]\nview-height = 3\nbackend = 'cpu'\n\
                 lights = [{{ direction = [1, 0, 1] }}]\n\
                 [[surfaces]]\nheight = 'plane.png'\nscale = 0.000001\nrotation = [90, 0, 0]\n\
                 position = [0.5, 0.5, -1]\nsize = 3\nshadow = 'map'\n\
                 [[surfaces]]\nmesh = '{mesh}'\n"
            ),
        );
        let ran = folder.relief("render scene.toml -o shadow.png");
        assert_eq!(ran.code, Some(0), "{}", ran.stderr);
        let picture = image::open(folder.path("shadow.png")).expect("a picture").into_luma8();
        picture.pixels().filter(|pixel| pixel.0[0] < 90).count()
    };
    let [opaque, masked] = ["OPAQUE", "MASK"].map(lit);
    assert!(masked > 20 && masked * 10 < opaque * 7, "{masked} of {opaque}");
}

#[test]
fn an_impostor_of_a_leaf_is_as_large_as_its_disc() {
    let folder = folder();
    let mesh = card(&folder, "MASK");
    let ran = folder.relief(&format!("capture {mesh} --views octahedral --size 64 --verify 0 -o leaf"));
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    let line = "render --object leaf/object.toml --method impostor-blend --projection orthographic --eye \
                0.5,0.5,3 --target 0.5,0.5,0 --view-height 1 --size 80x80 --samples 1 --look plain --light \
                0,0,1 --backend cpu -o impostor.png";
    let ran = folder.relief(line);
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    let picture = image::open(folder.path("impostor.png")).expect("a picture").into_rgb8();
    let background = *picture.get_pixel(0, 0);
    let shown = picture.pixels().filter(|pixel| **pixel != background).count() as f64 / 6400.0;
    assert!((shown - DISC).abs() < 0.05 * DISC, "{shown}, not {DISC}");
}

#[test]
fn captures_see_through_what_masks_leave_out() {
    let folder = folder();
    let seen = |mode: &str, flags: &str| {
        let mesh = card(&folder, mode);
        let ran = folder.relief(&format!("capture {mesh} --size 64 --verify 2 {flags} -o {mode}"));
        assert_eq!(ran.code, Some(0), "{}", ran.stderr);
        let object = read_object(&folder.path(format!("{mode}/object.toml")), &ObjectOptions::default());
        let object = object.expect("an object");
        let (count, columns) = (64 * 64, object.object.layout().size()[0] as usize);
        // The images from the front and from behind.
        let heights = object.object.heights();
        let places = object.object.layout().places().to_vec();
        let of_image = |place: &[u32; 2]| {
            let texel = |at: usize| {
                heights.texels()[(place[1] as usize + at / 64) * columns + place[0] as usize + at % 64]
            };
            (0..count).filter(|at| texel(*at) > 0.0).count()
        };
        let counts: Vec<usize> = places.iter().map(of_image).collect();
        (counts.into_iter().max().unwrap_or_default() as f64, ran.stderr)
    };
    for cover in ["", "--cover centre", "--cover pixel"] {
        let (all, _) = seen("OPAQUE", cover);
        let disc = (0..4096).filter(|at| {
            let [x, y] = [at % 64, at / 64].map(|at| f64::from(at) - 31.5);
            x * x + y * y < 625.0
        });
        let part = disc.count() as f64 / 4096.0;
        for mode in ["MASK", "BLEND"] {
            let (masked, said) = seen(mode, cover);
            assert!((masked / all - part).abs() < 0.02, "{mode} {cover}: {masked} of {all}, not {part}");
            assert_eq!(said.contains("BLEND"), mode == "BLEND", "{said}");
        }
    }
}

#[test]
fn what_is_not_shown_or_written_is_said() {
    let folder = folder();
    let mesh = card(&folder, "MASK");
    let ran = folder.relief(&format!("mesh flat.png --mesh {mesh} -o a.stl"));
    assert!(ran.code == Some(0) && ran.stderr.contains("materials"), "{}", ran.stderr);
    let parts = [part(2, 0), part(3, 1)].join(", ");
    let materials = format!(r#", "materials": [{}, {}]"#, factor("1, 0, 0, 1"), factor("0, 1, 1, 1"));
    square(&folder, "two.gltf", &parts, &materials);
    let line = "render --height flat.png --mesh two.gltf --method vertex --size 8x8 --backend cpu -o a.png";
    let ran = folder.relief(line);
    assert!(ran.code == Some(0) && ran.stderr.contains("2 materials"), "{}", ran.stderr);
}

/// The folder with a folded strip of three materials, one of a single material, and hills.
fn strips() -> Folder {
    let folder = folder();
    card(&folder, "MASK");
    folder.write("hills.png", Map::hills().png());
    folded(&folder, "three.gltf", true);
    folded(&folder, "one.gltf", false);
    folder
}

#[test]
fn a_displaced_mesh_keeps_the_materials_of_its_base() {
    let folder = strips();
    let options = MeshOptions { colors: true, ..MeshOptions::default() };
    let read = |name: &str| read_mesh(folder.path(name).as_path(), &options).expect("a mesh");
    let base = read("three.gltf").colors.expect("materials");
    for flags in
        ["--texels 4", "--error 1%", "--quantize 14 --texels 2", "--texels 2 --lods 2", "--solid 0.1"]
    {
        let ran = folder.relief(&format!("mesh hills.png --mesh three.gltf --scale 0.1 {flags} -o out.glb"));
        assert_eq!(ran.code, Some(0), "{flags}: {}", ran.stderr);
        assert!(!ran.stderr.contains("not written"), "{flags}: {}", ran.stderr);
        let file = read("out.glb");
        let made = file.colors.expect("materials");
        assert_eq!(made.materials.len(), 3, "{flags}");
        for (made, of_base) in made.materials.iter().zip(&base.materials) {
            assert_eq!((&made.name, made.factor), (&of_base.name, of_base.factor), "{flags}");
            assert_eq!((made.cutoff, made.wrap), (of_base.cutoff, of_base.wrap), "{flags}");
            let pairs = made.transform.as_flattened().iter().zip(of_base.transform.as_flattened());
            assert!(pairs.into_iter().all(|(a, b)| (a - b).abs() < 1e-5), "{flags}: {:?}", made.transform);
            let sizes = [made, of_base].map(|of| of.picture.as_ref().map(|of| [of.width, of.height]));
            assert_eq!(sizes[0], sizes[1], "{flags}");
            let texels = [made, of_base].map(|of| of.picture.iter().flat_map(|of| &of.texels));
            let [texels, wanted] = texels.map(|of| of.copied().collect::<Vec<_>>());
            let near = |(a, b): (&[f32; 4], &[f32; 4])| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-6);
            assert!(texels.iter().zip(&wanted).all(near), "{flags}");
        }
        // Each triangle that is displaced lies over its square of the strip.
        for triangle in 0..file.mesh.triangles().len() as u32 {
            let corners = file.mesh.corners(triangle);
            if !flags.starts_with("--solid") {
                let middle = corners.iter().map(|corner| corner.uv.x).sum::<f32>() / 3.0;
                assert_eq!(made.of_triangles[triangle as usize], middle as u32, "{flags}: {middle}");
            }
        }
    }
    // The base may also have one material. A format that cannot hold materials is noted.
    let ran = folder.relief("mesh hills.png --mesh one.gltf --scale 0.1 --texels 4 --strips -o one.glb");
    assert_eq!((ran.code, ran.stderr.contains("not written")), (Some(0), false), "{}", ran.stderr);
    let one = read("one.glb").colors.expect("a material");
    assert_eq!(one.materials[0].name.as_deref(), Some("red @ \"home\""));
    for line in [
        "mesh hills.png --mesh three.gltf --texels 2 -o out.ply",
        "mesh hills.png --mesh three.gltf --texels 2 -o out.obj",
        "mesh hills.png --mesh one.gltf --texels 2 -o out.stl",
        "mesh hills.png --mesh three.gltf --texels 2 --strips -o strips.glb",
    ] {
        let ran = folder.relief(line);
        assert!(
            ran.code == Some(0) && ran.stderr.contains("materials are not written"),
            "{line}: {}",
            ran.stderr
        );
    }
}

#[test]
fn a_displaced_base_of_three_materials_has_no_crack() {
    let folder = strips();
    for flags in ["--texels 4", "--error 1%", "--texels 2 --quantize 12"] {
        let open = ["three.gltf", "one.gltf"].map(|mesh| {
            let line = format!("mesh hills.png --mesh {mesh} --scale 0.1 {flags} -o out.glb --json");
            let about = json_of(&folder.relief(&line));
            ["open_edges", "branching_edges", "pieces", "triangles"].map(|key| about[key].as_u64())
        });
        assert_eq!(open[0], open[1], "{flags}");
        assert_eq!(open[0][1..3], [Some(0), Some(1)], "{flags}");
        let ran = folder.relief("inspect out.glb --json");
        assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    }
    // A picture of three materials covers exactly the pixels that a picture of one material covers.
    let text = std::fs::read_to_string(folder.path("three.gltf")).expect("it was written");
    folder.write("three.gltf", text.replace("MASK", "OPAQUE"));
    for more in ["", "--surface prism", "--surface tetrahedra"] {
        let covered = ["three.gltf", "one.gltf"].map(|mesh| {
            let line = format!(
                "render --height hills.png --mesh {mesh} --scale 0.1 --size 90x70 --samples 1 --backend cpu \
                 --two-sided {more} -o shown.png"
            );
            let ran = folder.relief(&line);
            assert_eq!(ran.code, Some(0), "{}", ran.stderr);
            let shown = image::open(folder.path("shown.png")).expect("a picture").into_rgb8();
            let background = *shown.get_pixel(0, 0);
            shown.pixels().map(|pixel| *pixel != background).collect::<Vec<bool>>()
        });
        assert!(covered[0] == covered[1], "{more}");
        assert!(covered[0].iter().filter(|is_covered| **is_covered).count() > 700, "{more}");
    }
}
