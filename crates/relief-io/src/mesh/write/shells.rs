//! Writer of shells over a mesh as binary glTF: copies of the mesh at increasing distances along
//! its normals. An alpha test removes texels of a shell above the surface. Any viewer can show a
//! displaced surface this way, without a shader.
//!
//! Source: Kautz and Seidel 2001, section 3.1.

use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::Path;
use std::sync::Arc;

use glam::{DVec3, Vec3};
use png::{BitDepth, ColorType, Encoder};
use relief_core::mesh::{Mesh, Vertex};
use relief_core::{HeightMap, TexelMask, Watch, Wrap};

use super::glb::tangent;
use super::{MeshCounts, check_counts, floats};
use crate::write_whole::write_file;
use crate::{MeshMaterial, WriteError, WriteProblem, linear_to_srgb};

/// Bytes of the file's and the JSON's headers, and of the buffer's header.
const HEADERS: [u64; 2] = [20, 8];

/// Greatest number of shells in a file. Viewers draw each separately.
pub const MAX_SHELLS: u32 = 4096;

/// Greatest code of a height.
const LEVELS: f64 = 255.0;

/// Shells over a mesh, with heights and colours.
///
/// Of `count` shells the first is at height 0, and the last is one spacing below height 1. If a
/// picture of colours is finer than the height map, heights are interpolated to its texels.
#[derive(Clone, Copy, Debug)]
pub struct Shells<'a> {
    /// Base mesh.
    pub base: &'a Mesh,
    /// Height map, with scale and bias.
    pub map: &'a HeightMap,
    /// Whether the map's holes are open.
    pub has_holes: bool,
    /// Colours in linear light, and a mask; white if none.
    pub color: Option<&'a MeshMaterial>,
    /// Factor of the colours in linear light.
    pub factor: [f32; 3],
    /// Number of shells, from 1 to [`MAX_SHELLS`].
    pub count: u32,
}

/// Single shell.
#[derive(Clone, Copy, Debug)]
struct Shell {
    /// Least opacity that is drawn; none if everything is drawn.
    cutoff: Option<f64>,
    /// Offset along the normals in metres.
    offset_m: f64,
}

/// Range in the buffer: offset of the first byte, and number of bytes.
type ByteRange = [u64; 2];

/// Layout of the buffer.
struct Layout {
    normals: ByteRange,
    tangents: ByteRange,
    uvs: ByteRange,
    indices: ByteRange,
    /// Positions of the first shell; the other shells follow.
    positions: ByteRange,
    picture: ByteRange,
    /// Normal map of the relief.
    normal_map: ByteRange,
    bytes: u64,
}

impl Shells<'_> {
    /// Returns the numbers of vertices and triangles of all shells.
    pub fn counts(&self) -> MeshCounts {
        let all = |count: usize| (count as u64).saturating_mul(u64::from(self.count));
        let base = self.base;
        MeshCounts { vertices: all(base.vertices().len()), triangles: all(base.triangles().len()) }
    }

    /// Returns the columns and rows of the picture on the shells.
    pub fn picture_size(&self) -> [u32; 2] {
        let picture = self.color.and_then(|color| color.picture.as_ref());
        let color = picture.map_or([1, 1], |picture| [picture.width, picture.height]);
        [self.map.width().max(color[0]), self.map.height().max(color[1])]
    }

    fn shells(&self) -> impl Iterator<Item = Shell> + '_ {
        (0..self.count).map(|number| {
            let height = f64::from(number) / f64::from(self.count);
            let cutoff = match number {
                0 => self.shows_through().then_some(0.5 / LEVELS),
                _ => Some(height),
            };
            Shell { cutoff, offset_m: self.map.displacement_m(height) }
        })
    }

    /// Opacity of the colours below which nothing is drawn.
    fn mask(&self) -> Option<f32> {
        self.color.and_then(|color| color.cutoff)
    }

    /// Whether the surface has openings.
    fn shows_through(&self) -> bool {
        self.holes().is_some() || self.mask().is_some()
    }

    fn holes(&self) -> Option<&TexelMask> {
        self.map.holes().filter(|_| self.has_holes).map(Arc::as_ref)
    }

    /// Picture of colours in sRGB, with heights as opacity. If there are openings, only they have
    /// opacity 0.
    fn texels(&self) -> Vec<u8> {
        let [columns, rows] = self.picture_size();
        let is_same = [columns, rows] == [self.map.width(), self.map.height()];
        let mut texels = Vec::with_capacity(4 * columns as usize * rows as usize);
        for (y, x) in (0..rows).flat_map(|y| (0..columns).map(move |x| (y, x))) {
            let [u, v] = [(x, columns), (y, rows)].map(|(at, side)| (f64::from(at) + 0.5) / f64::from(side));
            let texel = |at: f64, side: u32| ((at * f64::from(side)) as u32).min(side - 1);
            let [red, green, blue, opacity] = self.color.map_or([1.0; 4], |color| color.picture_at([u, v]));
            let is_masked = self.mask().is_some_and(|cutoff| opacity < cutoff);
            let height = if is_same {
                f64::from(self.map.texel(i64::from(x), i64::from(y)))
            } else {
                self.map.height_at(u, v)
            };
            let (column, row) = (texel(u, self.map.width()), texel(v, self.map.height()));
            let is_hole = self.holes().is_some_and(|holes| holes.contains(column, row));
            let least = (!(is_hole || is_masked)).then_some(f64::from(self.shows_through()));
            let code = least.map_or(0.0, |least: f64| (LEVELS * height).round().max(least));
            let encode = |part: f32| (LEVELS * linear_to_srgb(f64::from(part).clamp(0.0, 1.0))).round() as u8;
            texels.extend([red, green, blue].map(encode));
            texels.push(code as u8);
        }
        texels
    }

    fn layout(&self, pictures: [u64; 2]) -> Layout {
        let (vertices, triangles) = (self.base.vertices().len() as u64, self.base.triangles().len() as u64);
        let mut next = 0;
        let mut range = |bytes: u64, times: u64| {
            let first = next;
            next += bytes.saturating_mul(times).next_multiple_of(4);
            [first, bytes]
        };
        let (normals, tangents) = (range(12 * vertices, 1), range(16 * vertices, 1));
        let (uvs, indices) = (range(8 * vertices, 1), range(12 * triangles, 1));
        let positions = range(12 * vertices, u64::from(self.count));
        let [picture, normal_map] = pictures.map(|bytes| range(bytes, 1));
        Layout { normals, tangents, uvs, indices, positions, picture, normal_map, bytes: next }
    }

    /// Checks the number of shells, and whether a file can hold them.
    fn check(&self) -> Result<(), WriteProblem> {
        let (vertices, triangles) = (self.base.vertices().len() as u64, self.base.triangles().len() as u64);
        check_counts(MeshCounts { vertices, triangles })?;
        if !(1..=MAX_SHELLS).contains(&self.count) {
            let what = format!("{} shells cannot be written: choose 1 to {MAX_SHELLS}", self.count);
            return Err(WriteProblem::NotStorable(what));
        }
        self.checked(self.layout([0; 2]).bytes).map(drop)
    }

    /// Checks that a GLB can have `bytes` bytes.
    fn checked(&self, bytes: u64) -> Result<u32, WriteProblem> {
        u32::try_from(bytes).map_err(|_| {
            let (count, MeshCounts { triangles, .. }) = (self.count, self.counts());
            WriteProblem::NotStorable(format!(
                "{count} shells of {triangles} triangles in all need {bytes} bytes, but a GLB has at most \
                 4 GiB: choose fewer shells, or a coarser mesh"
            ))
        })
    }

    /// Positions of the mesh, moved along its normals.
    fn positions(&self, offset_m: f64) -> impl Iterator<Item = Vec3> + '_ {
        let moved = move |vertex: &Vertex| {
            let out: DVec3 = vertex.normal.as_dvec3() * offset_m;
            (vertex.position.as_dvec3() + out).as_vec3()
        };
        self.base.vertices().iter().map(moved)
    }

    fn json(&self, layout: &Layout) -> Result<String, WriteProblem> {
        let (vertices, indices) = (self.base.vertices().len(), 3 * self.base.triangles().len());
        let mut views = vec![
            view(layout.normals, Some(34962)),
            view(layout.tangents, Some(34962)),
            view(layout.uvs, Some(34962)),
            view(layout.indices, Some(34963)),
            view(layout.picture, None),
            view(layout.normal_map, None),
        ];
        let mut accessors = vec![
            format!(r#"{{"bufferView":0,"componentType":5126,"count":{vertices},"type":"VEC3"}}"#),
            format!(r#"{{"bufferView":1,"componentType":5126,"count":{vertices},"type":"VEC4"}}"#),
            format!(r#"{{"bufferView":2,"componentType":5126,"count":{vertices},"type":"VEC2"}}"#),
            format!(r#"{{"bufferView":3,"componentType":5125,"count":{indices},"type":"SCALAR"}}"#),
        ];
        let (mut materials, mut primitives) = (Vec::new(), Vec::new());
        let [first, bytes] = layout.positions;
        let [red, green, blue] = self.factor;
        for (number, Shell { cutoff, offset_m }) in (0u64..).zip(self.shells()) {
            let nothing = [Vec3::INFINITY, Vec3::NEG_INFINITY];
            let [least, most] =
                self.positions(offset_m).fold(nothing, |[least, most], at| [least.min(at), most.max(at)]);
            if !(least.is_finite() && most.is_finite()) {
                let what = "a shell lies outside the range of 32-bit floats: choose a smaller displacement";
                return Err(WriteProblem::NotStorable(what.to_owned()));
            }
            let [least, most] =
                [least, most].map(|corner| corner.to_array().map(|number| format!("{number:e}")).join(","));
            accessors.push(
                format!(r#"{{"bufferView":{},"componentType":5126,"count":{vertices},"#, views.len())
                    + &format!(r#""type":"VEC3","min":[{least}],"max":[{most}]}}"#),
            );
            views.push(view([first + number * bytes, bytes], Some(34962)));
            let test = cutoff.map(|cutoff| format!(r#","alphaMode":"MASK","alphaCutoff":{cutoff:e}"#));
            materials.push(
                format!(r#"{{"pbrMetallicRoughness":{{"baseColorFactor":[{red:e},{green:e},{blue:e},1],"#)
                    + r#""baseColorTexture":{"index":0},"metallicFactor":0},"#
                    + r#""normalTexture":{"index":1},"doubleSided":true"#
                    + &test.unwrap_or_default()
                    + "}",
            );
            primitives.push(
                format!(
                    r#"{{"attributes":{{"POSITION":{},"NORMAL":0,"TANGENT":1,"TEXCOORD_0":2}},"#,
                    4 + number
                ) + &format!(r#""indices":3,"material":{number}}}"#),
            );
        }
        let beyond = match self.map.wrap() {
            Wrap::Repeat => 10497,
            Wrap::Clamp => 33071,
            Wrap::Mirror => 33648,
        };
        let version = env!("CARGO_PKG_VERSION");
        Ok(format!(r#"{{"asset":{{"version":"2.0","generator":"relief {version}"}},"#)
            + r#""scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"#
            + &format!(r#""meshes":[{{"primitives":[{}]}}],"#, primitives.join(","))
            + &format!(
                r#""materials":[{}],"textures":[{{"source":0,"sampler":0}},{{"source":1,"sampler":0}}],"#,
                materials.join(",")
            )
            + &format!(
                r#""samplers":[{{"magFilter":9729,"minFilter":9987,"wrapS":{beyond},"wrapT":{beyond}}}],"#
            )
            + r#""images":[{"bufferView":4,"mimeType":"image/png"},{"bufferView":5,"mimeType":"image/png"}],"#
            + &format!(r#""buffers":[{{"byteLength":{}}}],"#, layout.bytes)
            + &format!(r#""bufferViews":[{}],"accessors":[{}]}}"#, views.join(","), accessors.join(",")))
    }

    /// Normal map of the relief in tangent space, green upward, by central differences over two
    /// texels.
    fn normal_map(&self) -> Vec<u8> {
        let (map, [tile_u, tile_v]) = (self.map, self.base.tile_m());
        let size = [map.width(), map.height()].map(f64::from);
        let per_m = |texels: f64, tile_m: f64| if tile_m > 0.0 { 0.5 * texels / tile_m } else { 0.0 };
        let rate = [per_m(size[0], tile_u), per_m(size[1], tile_v)].map(|rate| rate * map.scale_m());
        let mut texels = Vec::with_capacity(3 * map.width() as usize * map.height() as usize);
        for (y, x) in (0..map.height()).flat_map(|y| (0..map.width()).map(move |x| (y, x))) {
            let at = |dx: i64, dy: i64| f64::from(map.texel(i64::from(x) + dx, i64::from(y) + dy));
            let [u, v] = [at(1, 0) - at(-1, 0), at(0, 1) - at(0, -1)];
            let normal = DVec3::new(-u * rate[0], v * rate[1], 1.0).normalize_or(DVec3::Z);
            texels.extend(normal.to_array().map(|part| (LEVELS * (0.5 + 0.5 * part)).round() as u8));
        }
        texels
    }

    /// Picture on the shells and normal map, as PNG.
    fn pictures(&self) -> Result<[Vec<u8>; 2], WriteProblem> {
        let [columns, rows] = self.picture_size();
        Ok([
            png(columns, rows, ColorType::Rgba, &self.texels())?,
            png(self.map.width(), self.map.height(), ColorType::Rgb, &self.normal_map())?,
        ])
    }

    /// Writes the buffer.
    fn buffer(
        &self,
        out: &mut BufWriter<&File>,
        pictures: &[Vec<u8>; 2],
        watch: &Watch,
    ) -> Result<(), WriteProblem> {
        let vertices = self.base.vertices();
        let mut bytes = Vec::new();
        let normals = vertices.iter().map(|vertex| vertex.normal.normalize_or(Vec3::Y));
        floats(&mut bytes, normals.flat_map(|normal| normal.to_array()));
        floats(&mut bytes, vertices.iter().flat_map(tangent));
        floats(&mut bytes, vertices.iter().flat_map(|vertex| vertex.uv.to_array()));
        bytes.extend(self.base.triangles().as_flattened().iter().flat_map(|corner| corner.to_le_bytes()));
        out.write_all(&bytes)?;
        for (number, shell) in (1u32..).zip(self.shells()) {
            bytes.clear();
            floats(&mut bytes, self.positions(shell.offset_m).flat_map(|at| at.to_array()));
            out.write_all(&bytes)?;
            watch.at(number as f32 / self.count as f32)?;
        }
        for picture in pictures {
            out.write_all(picture)?;
            out.write_all(&[0; 4][..picture.len().next_multiple_of(4) - picture.len()])?;
        }
        Ok(())
    }
}

fn png(columns: u32, rows: u32, color: ColorType, texels: &[u8]) -> Result<Vec<u8>, WriteProblem> {
    let problem = |error: png::EncodingError| WriteProblem::NotStorable(error.to_string());
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, columns, rows);
    encoder.set_color(color);
    encoder.set_depth(BitDepth::Eight);
    let mut writer = encoder.write_header().map_err(problem)?;
    writer.write_image_data(texels).map_err(problem)?;
    writer.finish().map_err(problem)?;
    Ok(bytes)
}

fn view([first, bytes]: ByteRange, target: Option<u32>) -> String {
    let target = target.map_or(String::new(), |target| format!(r#","target":{target}"#));
    format!(r#"{{"buffer":0,"byteOffset":{first},"byteLength":{bytes}{target}}}"#)
}

/// Writes shells over a mesh as a GLB: one mesh with a primitive and a material for each shell. The
/// shells share normals, texture coordinates, triangles and the picture. Heights are the picture's
/// opacity, in 8 bits, and a material's `alphaCutoff` is its shell's height. The shell at height 0
/// is opaque except for openings. Vertex normals are the mesh's; a normal map holds the relief's.
///
/// The same input gives the same bytes. Memory holds the pictures and one shell.
///
/// # Errors
///
/// When there is no shell, or more than [`MAX_SHELLS`]; when the file would be longer than a GLB's
/// 4 GiB; when a shell lies outside the range of 32-bit floats; when the file cannot be written; or
/// when writing is cancelled. Nothing is left behind then.
pub fn write_shells(path: &Path, shells: &Shells, watch: &Watch) -> Result<(), WriteError> {
    shells.check().map_err(|problem| problem.at(path))?;
    write_file(path, |out| {
        let pictures = shells.pictures()?;
        let layout = shells.layout(pictures.each_ref().map(|picture| picture.len() as u64));
        let mut json = shells.json(&layout)?.into_bytes();
        json.resize(json.len().next_multiple_of(4), b' ');
        let bytes = HEADERS[0] + json.len() as u64 + HEADERS[1] + layout.bytes;
        let all = shells.checked(bytes)?;
        let mut head = b"glTF\x02\0\0\0".to_vec();
        head.extend(all.to_le_bytes());
        head.extend((json.len() as u32).to_le_bytes());
        head.extend(b"JSON");
        head.extend(json);
        head.extend((layout.bytes as u32).to_le_bytes());
        head.extend(b"BIN\0");
        out.write_all(&head)?;
        shells.buffer(out, &pictures, watch)
    })
}
