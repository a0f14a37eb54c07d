//! Materials of a glTF follow its specification.

use crate::common::files::png;
use crate::common::gltf_file::{Gltf, Numbers};
use crate::common::mesh_file::data_uri;
use image_webp::{ColorType, WebPEncoder};
use relief_core::mesh::UvProjection;
use relief_io::{MeshFile, MeshOptions, ReadError, Source, read_mesh, read_picture};

fn read(file: &Gltf) -> Result<MeshFile, ReadError> {
    let options = MeshOptions { colors: true, ..MeshOptions::default() };
    read_mesh(Source::bytes("a.gltf", &file.json()), &options)
}

/// Lossless WebP with the given numbers of columns and rows.
fn webp(size: [u32; 2], color: ColorType, samples: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::new();
    WebPEncoder::new(&mut bytes).encode(samples, size[0], size[1], color).expect("a WebP");
    bytes
}

/// Square with a texture of the given keys, and an image of the given bytes.
fn textured(texture: &str, image: &[u8], more: &str) -> Gltf {
    let mut file = Gltf::square();
    file.primitive = r#", "material": 0"#.to_owned();
    let uri = data_uri(image);
    file.more = format!(
        r#", "materials": [{{"pbrMetallicRoughness": {{"baseColorTexture": {{"index": 0}}}}}}],
        "textures": [{{{texture}}}], "images": [{{"uri": "{uri}"}}]{more}"#
    );
    file
}

#[test]
fn pictures_by_extensions_are_read_or_left_out_by_name() {
    let red_blue = [255, 0, 0, 0, 0, 255];
    let of_webp = webp([2, 1], ColorType::Rgb8, &red_blue);
    let of_png = png(2, 1, ::png::ColorType::Rgb, ::png::BitDepth::Eight, &red_blue);
    let wanted = [[1.0, 0.0, 0.0, 1.0], [0.0, 0.0, 1.0, 1.0]];
    let required =
        |name: &str| format!(r#", "extensionsRequired": ["{name}"], "extensionsUsed": ["{name}"]"#);
    let by = |name: &str| format!(r#""extensions": {{"{name}": {{"source": 0}}}}"#);
    let texels = |file: &Gltf| {
        let colors = read(file).unwrap_or_else(|error| panic!("{error}")).colors.expect("a material");
        colors.materials[0].picture.as_ref().map(|picture| picture.texels.clone())
    };
    let name = "EXT_texture_webp";
    assert_eq!(texels(&textured(&by(name), &of_webp, &required(name))).as_deref(), Some(&wanted[..]));
    // The fallback for readers without the extension is the second choice.
    let both = format!(r#""source": 7, {}"#, by(name)).replace("7", "0");
    assert_eq!(texels(&textured(&both, &of_webp, "")).as_deref(), Some(&wanted[..]));
    for name in ["KHR_texture_basisu", "EXT_texture_avif", "MSFT_texture_dds"] {
        let file = textured(&by(name), b"unread", &required(name));
        assert_eq!(texels(&file), None, "{name}");
        let read = read(&file).expect("triangles");
        assert!(
            read.mesh.triangles().len() == 2 && read.notes.iter().any(|note| note.text.contains(name)),
            "{name}"
        );
        // A supported picture may be given as well.
        let both = format!(r#""source": 0, {}"#, by(name));
        assert_eq!(texels(&textured(&both, &of_png, "")).as_deref(), Some(&wanted[..]), "{name}");
    }
    let bare = read(&textured("", &of_png, "")).expect("a texture without an image");
    assert!(bare.notes.len() == 1 && bare.colors.is_some_and(|colors| colors.materials[0].picture.is_none()));
    // Errors in the file are errors.
    for source in ["9", "-1", "4000000000"] {
        let texture = by("EXT_texture_webp").replace(": 0", &format!(": {source}"));
        let found = read(&textured(&texture, &of_webp, ""));
        assert!(found.is_err() || found.is_ok_and(|file| !file.notes.is_empty()), "{source}");
    }
}

#[test]
fn webp_is_a_picture_like_any_other() {
    let samples: Vec<u8> = (0..4 * 5 * 3).map(|sample| (sample * 4) as u8).collect();
    let with_opacity = webp([5, 3], ColorType::Rgba8, &samples);
    let same = png(5, 3, ::png::ColorType::Rgba, ::png::BitDepth::Eight, &samples);
    let picture = |name: &str, bytes: &[u8], limit: u64| read_picture(Source::bytes(name, bytes), limit);
    let wanted = picture("a.png", &same, 1 << 30).expect("a PNG");
    assert_eq!(picture("a.webp", &with_opacity, 1 << 30).expect("a WebP"), wanted);
    // By its content, whatever its name.
    assert_eq!(picture("a.png", &with_opacity, 1 << 30).expect("a WebP"), wanted);
    let grey = webp([3, 1], ColorType::L8, &[0, 128, 255]);
    let grey = picture("a.webp", &grey, 1 << 30).expect("a grey WebP");
    assert!(grey.texels.iter().all(|texel| texel[0] == texel[1] && texel[1] == texel[2]));
    let large = webp([512, 512], ColorType::Rgb8, &vec![7; 3 * 512 * 512]);
    assert!(picture("a.webp", &large, 1 << 20).is_err() && picture("a.webp", &large, 1 << 24).is_ok());
    for cut in [13, 20, 30, with_opacity.len() - 3] {
        assert!(picture("a.webp", &with_opacity[..cut], 1 << 30).is_err(), "{cut}");
    }
}

/// A side of the pictures of the tests below, in texels.
const SIDE: usize = 16;

/// The 8-bit colour of a texel: no two are alike.
fn texel([column, row]: [usize; 2]) -> [u8; 4] {
    [(column * 15 + 20) as u8, (row * 15 + 20) as u8, (255 - 9 * column) as u8, 255]
}

fn squares() -> Vec<u8> {
    let samples: Vec<u8> = (0..SIDE * SIDE).flat_map(|at| texel([at % SIDE, at / SIDE])).collect();
    png(SIDE as u32, SIDE as u32, ::png::ColorType::Rgba, ::png::BitDepth::Eight, &samples)
}

/// The colour and the opacity of the square at a point, as 8 bits of sRGB.
fn shown(file: &MeshFile, at: [f64; 2]) -> [f64; 4] {
    let colors = file.colors.as_ref().expect("colours");
    for triangle in 0..file.mesh.triangles().len() as u32 {
        let corners = file.mesh.corners(triangle).map(|corner| corner.position.as_dvec3().truncate());
        let [a, b, c] = corners;
        let point = glam::DVec2::from(at);
        let area = (b - a).perp_dot(c - a);
        let weights = [
            (b - point).perp_dot(c - point),
            (c - point).perp_dot(a - point),
            (a - point).perp_dot(b - point),
        ];
        let weights = weights.map(|weight| weight / area);
        if weights.iter().all(|weight| *weight > -1e-9) {
            let uv = file.mesh.interpolated(triangle, weights.map(|weight| weight as f32)).uv;
            let [red, green, blue, opacity] = colors.at(triangle, weights, uv.as_dvec2().to_array());
            let encoded = |linear: f32| {
                let linear = f64::from(linear);
                let srgb =
                    if linear <= 0.0031308 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 };
                255.0 * srgb
            };
            return [encoded(red), encoded(green), encoded(blue), 255.0 * f64::from(opacity)];
        }
    }
    panic!("no triangle at {at:?}")
}

/// Compares a file with the texels that the specification gives at 64 points of the square. The points are
/// in the middle of some of its `parts` x `parts` parts; columns and rows count from the upper left.
fn assert_shows(what: &str, file: &Gltf, parts: usize, wanted: impl Fn([usize; 2]) -> [usize; 2]) {
    let file = read(file).unwrap_or_else(|error| panic!("{what}: {error}"));
    for point in 0..64 {
        let [i, j] = [point % 8, point / 8].map(|at| (at * parts / 8 + at % 2).min(parts - 1));
        let [x, y] = [i, j].map(|at| (at as f64 + 0.5) / parts as f64);
        let (shown, texel) = (shown(&file, [x, 1.0 - y]), texel(wanted([i, j])));
        for (shown, texel) in shown.iter().zip(texel) {
            assert!((shown - f64::from(texel)).abs() <= 1.0, "{what} at {i}, {j}: {shown} for {texel}");
        }
    }
}

/// The square with the picture, more of its texture's keys and its sampler's.
fn painted(info: &str, sampler: &str, uvs: &[f32]) -> Gltf {
    let mut file = textured(r#""source": 0, "sampler": 0"#, &squares(), "");
    file.more = file.more.replace(r#"{"index": 0}"#, &format!(r#"{{"index": 0{info}}}"#));
    file.more += &format!(r#", "samplers": [{{{sampler}}}]"#);
    let mut painted = Gltf::with_uvs(uvs);
    (painted.primitive, painted.more) = (file.primitive, file.more);
    painted
}

/// Texture coordinates of the square's corners that go from one number to another.
fn tile(from: f32, to: f32) -> [f32; 8] {
    [from, to, to, to, to, from, from, from]
}

#[test]
fn texture_transforms_follow_the_specification() {
    let plain = tile(0.0, 1.0);
    let transform = |text: &str| format!(r#", "extensions": {{"KHR_texture_transform": {{{text}}}}}"#);
    assert_shows("plain", &painted("", "", &plain), 16, |at| at);
    let scale = transform(r#""scale": [2, 2]"#);
    assert_shows("scale", &painted(&scale, "", &plain), 32, |[i, j]| [i % 16, j % 16]);
    let offset = transform(r#""offset": [0.25, 0.5]"#);
    assert_shows("offset", &painted(&offset, "", &plain), 16, |[i, j]| [(i + 4) % 16, (j + 8) % 16]);
    // Counter-clockwise by a quarter.
    let turned = transform(r#""rotation": 1.5707963267948966"#);
    assert_shows("rotation", &painted(&turned, "", &plain), 16, |[i, j]| [j, 15 - i]);
    // The extension's own example: the lower left quadrant of the picture, turned clockwise.
    let quadrant = transform(r#""offset": [0, 1], "rotation": 1.57079632679, "scale": [0.5, 0.5]"#);
    assert_shows("quadrant", &painted(&quadrant, "", &plain), 8, |[i, j]| [j, 15 - i]);
    let [clamp, mirror] = [33071, 33648].map(|wrap| format!(r#""wrapS": {wrap}, "wrapT": {wrap}"#));
    let wide = tile(-1.0, 2.0);
    assert_shows("clamped", &painted("", &clamp, &wide), 48, |at| at.map(|i| i.clamp(16, 31) - 16));
    let fold = |i: usize| if i / 16 == 1 { i % 16 } else { 15 - i % 16 };
    assert_shows("mirrored", &painted("", &mirror, &wide), 48, |at| at.map(fold));
    let mixed = r#""wrapS": 33071, "wrapT": 10497"#;
    assert_shows("mixed", &painted("", mixed, &wide), 48, |[i, j]| [i.clamp(16, 31) - 16, j % 16]);
    for info in [r#", "texCoord": 1"#, &transform(r#""texCoord": 1"#)] {
        let mut second = painted(info, "", &plain);
        let uvs = second.add(Numbers::Floats(&[1.0, 1.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0]), "VEC2", "");
        second.attributes = format!(r#", "TEXCOORD_1": {uvs}"#);
        assert_shows("second", &second, 16, |[i, j]| [15 - i, j]);
    }
}

#[test]
fn colours_lie_by_those_of_the_file_where_coordinates_are_projected() {
    let options = MeshOptions { colors: true, projection: Some(UvProjection::Box), ..MeshOptions::default() };
    let bytes = painted("", "", &tile(0.0, 1.0)).json();
    let file = read_mesh(Source::bytes("a.gltf", &bytes), &options).expect("a mesh");
    let shown = shown(&file, [2.5 / 16.0, 1.0 - 3.5 / 16.0]);
    assert!(shown.iter().zip(texel([2, 3])).all(|(shown, texel)| (shown - f64::from(texel)).abs() <= 1.0));
}

#[test]
fn colours_of_vertices_multiply_the_material() {
    let mut file = Gltf::square();
    let corners = [255, 0, 0, 255, 0, 255, 0, 255, 0, 255, 0, 255, 255, 0, 0, 255];
    let colors = file.add(Numbers::Bytes(&corners), "VEC4", r#", "normalized": true"#);
    file.attributes = format!(r#", "COLOR_0": {colors}"#);
    let half = 255.0 * (1.055 * 0.5f64.powf(1.0 / 2.4) - 0.055);
    let near = |a: [f64; 4], b: [f64; 4]| a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 1.0);
    // Without a material, too.
    let bare = read(&file).expect("a mesh");
    assert!(near(shown(&bare, [0.5, 0.5]), [half, half, 0.0, 255.0]));
    assert!(near(shown(&bare, [0.0, 0.5]), [255.0, 0.0, 0.0, 255.0]));
    file.primitive = r#", "material": 0"#.to_owned();
    file.more =
        r#", "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.5, 1, 0.25]}}]"#.to_owned();
    let both = read(&file).expect("a mesh");
    assert!(near(shown(&both, [0.0, 0.5]), [half, 0.0, 0.0, 255.0 / 4.0]));
    // Three floats are opaque; what is above 1 is 1.
    let mut floats = Gltf::square();
    let colors = floats.add(Numbers::Floats(&[0.0, 0.5, 7.0].repeat(4)), "VEC3", "");
    floats.attributes = format!(r#", "COLOR_0": {colors}"#);
    assert!(near(shown(&read(&floats).expect("a mesh"), [0.3, 0.3]), [0.0, half, 255.0, 255.0]));
    let nan = floats.add(Numbers::Floats(&[f32::NAN, 0.5, 0.0].repeat(4)), "VEC3", "");
    floats.attributes = format!(r#", "COLOR_0": {nan}"#);
    assert!(read(&floats).is_err());
    floats.attributes = r#", "COLOR_0": 3"#.to_owned();
    assert!(read(&floats).is_err());
}

#[test]
fn triangles_keep_their_materials_and_masks() {
    let mut file = Gltf::square();
    let first = file.add(Numbers::Shorts(&[0, 1, 2, 0, 0, 1]), "SCALAR", "");
    let second = file.add(Numbers::Shorts(&[0, 2, 3]), "SCALAR", "");
    // Two primitives have two materials; the first one has a triangle without an area.
    let material =
        |more: &str| format!(r#"{{"pbrMetallicRoughness": {{"baseColorFactor": [1, 0, 0, 0.4]}}{more}}}"#);
    let with = |more: &str| {
        let mut file = Gltf::square();
        file.add(Numbers::Shorts(&[0, 1, 2, 0, 0, 1]), "SCALAR", "");
        file.add(Numbers::Shorts(&[0, 2, 3]), "SCALAR", "");
        file.primitive = format!(
            r#", "material": 0}}, {{"attributes": {{"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}},
            "indices": {second}, "material": 1"#
        );
        file.more = format!(r#", "materials": [{{}}, {}]"#, material(more));
        let json = String::from_utf8(file.json()).expect("text");
        json.replacen(r#""indices": 3"#, &format!(r#""indices": {first}"#), 1).into_bytes()
    };
    let options = MeshOptions { colors: true, ..MeshOptions::default() };
    let read = |more: &str| read_mesh(Source::bytes("a.gltf", &with(more)), &options);
    let seen = |more: &str| {
        let colors = read(more).expect("a mesh").colors.expect("materials");
        assert_eq!((&colors.of_triangles[..], colors.materials.len()), (&[0, 1][..], 2));
        [0, 1].map(|triangle| colors.is_seen(triangle, [0.4, 0.3, 0.3], [0.5, 0.5]))
    };
    assert_eq!(seen(""), [true, true]);
    assert_eq!(seen(r#", "alphaMode": "MASK""#), [true, false]);
    assert_eq!(seen(r#", "alphaMode": "MASK", "alphaCutoff": 0.4"#), [true, true]);
    assert_eq!(seen(r#", "alphaMode": "MASK", "alphaCutoff": 0.41"#), [true, false]);
    // Above 1 nothing is seen.
    assert_eq!(seen(r#", "alphaMode": "MASK", "alphaCutoff": 7"#), [true, false]);
    assert_eq!(seen(r#", "alphaMode": "BLEND""#), [true, false]);
    assert!(
        read(r#", "alphaMode": "BLEND""#).expect("a mesh").notes.iter().any(|note| note.text.contains("0.5"))
    );
    for bad in
        [r#", "alphaMode": "MASK", "alphaCutoff": -1"#, r#", "alphaMode": "MASK", "alphaCutoff": 1e39"#]
    {
        assert!(read(bad).is_err(), "{bad}");
    }
}

#[test]
fn materials_that_cannot_be_are_refused() {
    let refused = |what: &str, file: &Gltf| assert!(read(file).is_err(), "{what}");
    let mut missing = Gltf::square();
    missing.primitive = r#", "material": 3"#.to_owned();
    refused("a material that is not there", &missing);
    let of = |text: &str| {
        let info = format!(r#", "extensions": {{"KHR_texture_transform": {{{text}}}}}"#);
        painted(&info, "", &tile(0.0, 1.0))
    };
    for text in [r#""scale": [1e39, 1]"#, r#""offset": [1, 1e39]"#, r#""rotation": 1e39"#] {
        refused(text, &of(text));
    }
    // Missing coordinates cause a note.
    let file = read(&painted(r#", "texCoord": 5"#, "", &tile(0.0, 1.0))).expect("a mesh");
    assert_eq!(file.notes.len(), 1);
    // Ten thousand materials are read, each with its triangles.
    let mut many = Gltf::square();
    let materials: Vec<String> = (0..10_000)
        .map(|at| {
            format!(
                r#"{{"pbrMetallicRoughness": {{"baseColorFactor": [{}, 0, 0, 1]}}}}"#,
                f64::from(at) / 1e4
            )
        })
        .collect();
    many.more = format!(r#", "materials": [{}]"#, materials.join(", "));
    many.primitive = r#", "material": 9999"#.to_owned();
    let colors = read(&many).expect("a mesh").colors.expect("materials");
    assert_eq!((colors.materials.len(), colors.materials[0].factor[0]), (1, 0.9999));
}
