//! The materials of a glTF are what its specification says.

mod common;

use common::files::png;
use common::gltf_file::Gltf;
use common::mesh_file::data_uri;
use image_webp::{ColorType, WebPEncoder};
use relief_io::{MeshFile, MeshOptions, ReadError, Source, read_mesh, read_picture};

fn read(file: &Gltf) -> Result<MeshFile, ReadError> {
    let options = MeshOptions { colors: true, ..MeshOptions::default() };
    read_mesh(Source::bytes("a.gltf", &file.json()), &options)
}

/// A WebP without loss of so many columns and rows.
fn webp(size: [u32; 2], color: ColorType, samples: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::new();
    WebPEncoder::new(&mut bytes).encode(samples, size[0], size[1], color).expect("a WebP");
    bytes
}

/// The square with a texture of those keys, and an image of those bytes.
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
        colors.picture.map(|picture| picture.texels)
    };
    let name = "EXT_texture_webp";
    assert_eq!(texels(&textured(&by(name), &of_webp, &required(name))).as_deref(), Some(&wanted[..]));
    // What is to be read where the extension is not known is the second choice.
    let both = format!(r#""source": 7, {}"#, by(name)).replace("7", "0");
    assert_eq!(texels(&textured(&both, &of_webp, "")).as_deref(), Some(&wanted[..]));
    for name in ["KHR_texture_basisu", "EXT_texture_avif", "MSFT_texture_dds"] {
        let file = textured(&by(name), b"unread", &required(name));
        assert_eq!(texels(&file), None, "{name}");
        let read = read(&file).expect("triangles");
        assert!(
            read.mesh.triangles().len() == 2 && read.notes.iter().any(|note| note.contains(name)),
            "{name}"
        );
        // One that is read may stand beside it.
        let both = format!(r#""source": 0, {}"#, by(name));
        assert_eq!(texels(&textured(&both, &of_png, "")).as_deref(), Some(&wanted[..]), "{name}");
    }
    let bare = read(&textured("", &of_png, "")).expect("a texture without an image");
    assert!(bare.notes.len() == 1 && bare.colors.is_some_and(|colors| colors.picture.is_none()));
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
