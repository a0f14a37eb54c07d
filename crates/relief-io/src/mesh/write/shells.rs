//! Shells over a mesh as binary glTF: the mesh several times, ever farther out along its normals, of which an
//! alpha test keeps what is high enough. Any viewer shows a displaced surface by them, without a shader.
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

/// Bytes of the file's header, and before the JSON and the buffer.
const HEADERS: [u64; 2] = [20, 8];

/// The most shells of a file, each of which viewers draw by itself.
pub const MAX_SHELLS: u32 = 4096;

/// The codes of heights.
const LEVELS: f64 = 255.0;

/// Shells over a mesh, and what lies on it.
///
/// Of `count` shells the first lies at height 0, the last one below height 1 by as much as they are apart.
/// Where a picture of colours is finer than the height map, heights are interpolated to its texels.
#[derive(Clone, Copy, Debug)]
pub struct Shells<'a> {
    /// The mesh.
    pub base: &'a Mesh,
    /// The heights, and how far out they are.
    pub map: &'a HeightMap,
    /// Whether nothing is drawn where the map has holes.
    pub has_holes: bool,
    /// Colours in linear light, and a mask; white without them.
    pub color: Option<&'a MeshMaterial>,
    /// What colours are multiplied by, in linear light.
    pub factor: [f32; 3],
    /// How many shells there are: 1 to [`MAX_SHELLS`].
    pub count: u32,
}

/// A shell.
#[derive(Clone, Copy, Debug)]
struct Shell {
    /// The least opacity that is drawn; none where all is.
    cutoff: Option<f64>,
    /// Metres along the normals.
    offset_m: f64,
}

/// Where something lies in the buffer: its first byte, and how many there are.
type Place = [u64; 2];

/// Where everything lies.
struct Layout {
    normals: Place,
    tangents: Place,
    uvs: Place,
    indices: Place,
    /// Those of the first shell; others follow.
    positions: Place,
    picture: Place,
    /// The picture of normals.
    relief: Place,
    bytes: u64,
}

impl Shells<'_> {
    /// Vertices and triangles of all shells.
    pub fn counts(&self) -> MeshCounts {
        let all = |count: usize| (count as u64).saturating_mul(u64::from(self.count));
        let base = self.base;
        MeshCounts { vertices: all(base.vertices().len()), triangles: all(base.triangles().len()) }
    }

    /// Columns and rows of the picture on them.
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

    /// The opacity below which nothing is drawn.
    fn mask(&self) -> Option<f32> {
        self.color.and_then(|color| color.cutoff)
    }

    /// Whether there are places at which nothing is drawn.
    fn shows_through(&self) -> bool {
        self.holes().is_some() || self.mask().is_some()
    }

    fn holes(&self) -> Option<&TexelMask> {
        self.map.holes().filter(|_| self.has_holes).map(Arc::as_ref)
    }

    /// The picture: colours in sRGB, and the heights, which are 0 in holes alone where there are any.
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
        let mut place = |bytes: u64, times: u64| {
            let first = next;
            next += bytes.saturating_mul(times).next_multiple_of(4);
            [first, bytes]
        };
        let (normals, tangents) = (place(12 * vertices, 1), place(16 * vertices, 1));
        let (uvs, indices) = (place(8 * vertices, 1), place(12 * triangles, 1));
        let positions = place(12 * vertices, u64::from(self.count));
        let [picture, relief] = pictures.map(|bytes| place(bytes, 1));
        Layout { normals, tangents, uvs, indices, positions, picture, relief, bytes: next }
    }

    /// Whether there may be so many shells, and a file may hold them.
    fn check(&self) -> Result<(), WriteProblem> {
        let (vertices, triangles) = (self.base.vertices().len() as u64, self.base.triangles().len() as u64);
        check_counts(MeshCounts { vertices, triangles })?;
        if !(1..=MAX_SHELLS).contains(&self.count) {
            let what = format!("{} shells: there are 1 to {MAX_SHELLS}", self.count);
            return Err(WriteProblem::NotStorable(what));
        }
        self.checked(self.layout([0; 2]).bytes).map(drop)
    }

    /// So many bytes, if a GLB may be as long.
    fn checked(&self, bytes: u64) -> Result<u32, WriteProblem> {
        u32::try_from(bytes).map_err(|_| {
            let (count, MeshCounts { triangles, .. }) = (self.count, self.counts());
            WriteProblem::NotStorable(format!(
                "{count} shells of {triangles} triangles in all take {bytes} bytes as GLB, which ends at \
                 4 GiB: choose fewer, or a coarser mesh"
            ))
        })
    }

    /// The mesh so far out.
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
            view(layout.relief, None),
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
                let what = "a shell lies beyond what 32-bit numbers hold: choose a smaller displacement";
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

    /// The normals of the relief in tangent space, green upward, by central differences over two texels.
    fn relief(&self) -> Vec<u8> {
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

    /// The picture that lies on the shells, and that of normals, as PNG.
    fn pictures(&self) -> Result<[Vec<u8>; 2], WriteProblem> {
        let [columns, rows] = self.picture_size();
        Ok([
            png(columns, rows, ColorType::Rgba, &self.texels())?,
            png(self.map.width(), self.map.height(), ColorType::Rgb, &self.relief())?,
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

fn view([first, bytes]: Place, target: Option<u32>) -> String {
    let target = target.map_or(String::new(), |target| format!(r#","target":{target}"#));
    format!(r#"{{"buffer":0,"byteOffset":{first},"byteLength":{bytes}{target}}}"#)
}

/// Writes shells over a mesh as a GLB: one mesh with a primitive and a material for each shell, which share
/// normals, texture coordinates, triangles and the picture. Heights are the picture's opacity, in 8 bits, and
/// the material's `alphaCutoff` is the shell's height; the shell at height 0 is opaque but for holes. Normals
/// are those of the mesh, and a normal map has the relief's.
///
/// The same input gives the same bytes. Besides the pictures a shell is held at once.
///
/// # Errors
///
/// When there is no shell, or more than [`MAX_SHELLS`], when the file would be longer than the 4 GiB at which
/// a GLB ends, when a shell lies farther out than 32-bit numbers hold, when it cannot be written, or when it
/// is cancelled. Nothing is left behind then.
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
