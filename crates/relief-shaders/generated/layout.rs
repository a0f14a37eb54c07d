// Host-shared structs and their bytes on the GPU. Written by `cargo xtask link`; do not edit.

use super::bytes::Shared;
use super::generated::*;
use super::runtime as rt;

impl Shared for Light {
    const SIZE: usize = 48;

    fn write(&self, bytes: &mut [u8]) {
        self.place.write(&mut bytes[0..]);
        self.color.write(&mut bytes[16..]);
        self.first_view.write(&mut bytes[32..]);
        self.views.write(&mut bytes[36..]);
    }

    fn read(bytes: &[u8]) -> Self {
        Self {
            place: Shared::read(&bytes[0..]),
            color: Shared::read(&bytes[16..]),
            first_view: Shared::read(&bytes[32..]),
            views: Shared::read(&bytes[36..]),
        }
    }
}

impl Shared for LightView {
    const SIZE: usize = 128;

    fn write(&self, bytes: &mut [u8]) {
        self.column.write(&mut bytes[0..]);
        self.row.write(&mut bytes[16..]);
        self.depth.write(&mut bytes[32..]);
        self.corner.write(&mut bytes[48..]);
        self.across.write(&mut bytes[64..]);
        self.along.write(&mut bytes[80..]);
        self.eye.write(&mut bytes[96..]);
        self.near.write(&mut bytes[112..]);
        self.texel_m.write(&mut bytes[116..]);
        self.from_point.write(&mut bytes[120..]);
        self.size.write(&mut bytes[124..]);
    }

    fn read(bytes: &[u8]) -> Self {
        Self {
            column: Shared::read(&bytes[0..]),
            row: Shared::read(&bytes[16..]),
            depth: Shared::read(&bytes[32..]),
            corner: Shared::read(&bytes[48..]),
            across: Shared::read(&bytes[64..]),
            along: Shared::read(&bytes[80..]),
            eye: Shared::read(&bytes[96..]),
            near: Shared::read(&bytes[112..]),
            texel_m: Shared::read(&bytes[116..]),
            from_point: Shared::read(&bytes[120..]),
            size: Shared::read(&bytes[124..]),
        }
    }
}

impl Shared for Frame {
    const SIZE: usize = 6800;

    fn write(&self, bytes: &mut [u8]) {
        self.view_projection.write(&mut bytes[0..]);
        self.eye.write(&mut bytes[64..]);
        self.eye_right.write(&mut bytes[80..]);
        self.eye_down.write(&mut bytes[96..]);
        self.forward.write(&mut bytes[112..]);
        self.corner.write(&mut bytes[128..]);
        self.right.write(&mut bytes[144..]);
        self.down.write(&mut bytes[160..]);
        self.ambient.write(&mut bytes[176..]);
        self.sample_width.write(&mut bytes[192..]);
        self.near.write(&mut bytes[196..]);
        self.clip.write(&mut bytes[208..]);
        self.background.write(&mut bytes[224..]);
        self.background_below.write(&mut bytes[240..]);
        self.lights.write(&mut bytes[256..]);
        self.light_count.write(&mut bytes[640..]);
        self.light_views.write(&mut bytes[656..]);
    }

    fn read(bytes: &[u8]) -> Self {
        Self {
            view_projection: Shared::read(&bytes[0..]),
            eye: Shared::read(&bytes[64..]),
            eye_right: Shared::read(&bytes[80..]),
            eye_down: Shared::read(&bytes[96..]),
            forward: Shared::read(&bytes[112..]),
            corner: Shared::read(&bytes[128..]),
            right: Shared::read(&bytes[144..]),
            down: Shared::read(&bytes[160..]),
            ambient: Shared::read(&bytes[176..]),
            sample_width: Shared::read(&bytes[192..]),
            near: Shared::read(&bytes[196..]),
            clip: Shared::read(&bytes[208..]),
            background: Shared::read(&bytes[224..]),
            background_below: Shared::read(&bytes[240..]),
            lights: Shared::read(&bytes[256..]),
            light_count: Shared::read(&bytes[640..]),
            light_views: Shared::read(&bytes[656..]),
        }
    }
}

impl Shared for Corner {
    const SIZE: usize = 96;

    fn write(&self, bytes: &mut [u8]) {
        self.position.write(&mut bytes[0..]);
        self.normal.write(&mut bytes[16..]);
        self.tangent.write(&mut bytes[32..]);
        self.bitangent.write(&mut bytes[48..]);
        self.uv.write(&mut bytes[64..]);
        self.of_surface.write(&mut bytes[80..]);
    }

    fn read(bytes: &[u8]) -> Self {
        Self {
            position: Shared::read(&bytes[0..]),
            normal: Shared::read(&bytes[16..]),
            tangent: Shared::read(&bytes[32..]),
            bitangent: Shared::read(&bytes[48..]),
            uv: Shared::read(&bytes[64..]),
            of_surface: Shared::read(&bytes[80..]),
        }
    }
}

impl Shared for Shell {
    const SIZE: usize = 32;

    fn write(&self, bytes: &mut [u8]) {
        self.heights.write(&mut bytes[0..]);
        self.order.write(&mut bytes[8..]);
        self.lift.write(&mut bytes[16..]);
    }

    fn read(bytes: &[u8]) -> Self {
        Self {
            heights: Shared::read(&bytes[0..]),
            order: Shared::read(&bytes[8..]),
            lift: Shared::read(&bytes[16..]),
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
/// A base triangle in buffers: the places of its corners among all of the mesh.
pub struct Face {
    pub corners: rt::Vec3<u32>,
    pub shell: Shell,
}

impl Shared for Face {
    const SIZE: usize = 48;

    fn write(&self, bytes: &mut [u8]) {
        self.corners.write(&mut bytes[0..]);
        self.shell.write(&mut bytes[16..]);
    }

    fn read(bytes: &[u8]) -> Self {
        Self {
            corners: Shared::read(&bytes[0..]),
            shell: Shared::read(&bytes[16..]),
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
/// Settings of one pass: some rows of the picture, and one sample of their pixels. The host keeps
/// 256 bytes for each pass, so more members fit.
pub struct PassSettings {
    /// Offset in pixels from a pixel's centre to its sample point.
    pub offset: rt::Vec2<f32>,
    /// From clip space to the clip space of the rows: y is multiplied by the zoom, then the shift is
    /// added.
    pub shift: rt::Vec2<f32>,
    pub zoom: f32,
    /// The weight of the sample in the pixel's colour.
    pub weight: f32,
    /// The rows of the picture that are traced, shaded and read back at once. The records fit the
    /// least buffer that adapters offer.
    pub first_row: u32,
    pub rows: u32,
    /// 1 for the last sample of a pixel.
    pub is_last: u32,
}

impl Shared for PassSettings {
    const SIZE: usize = 40;

    fn write(&self, bytes: &mut [u8]) {
        self.offset.write(&mut bytes[0..]);
        self.shift.write(&mut bytes[8..]);
        self.zoom.write(&mut bytes[16..]);
        self.weight.write(&mut bytes[20..]);
        self.first_row.write(&mut bytes[24..]);
        self.rows.write(&mut bytes[28..]);
        self.is_last.write(&mut bytes[32..]);
    }

    fn read(bytes: &[u8]) -> Self {
        Self {
            offset: Shared::read(&bytes[0..]),
            shift: Shared::read(&bytes[8..]),
            zoom: Shared::read(&bytes[16..]),
            weight: Shared::read(&bytes[20..]),
            first_row: Shared::read(&bytes[24..]),
            rows: Shared::read(&bytes[28..]),
            is_last: Shared::read(&bytes[32..]),
        }
    }
}

impl Shared for Choice {
    const SIZE: usize = 32;

    fn write(&self, bytes: &mut [u8]) {
        self.number.write(&mut bytes[0..]);
        self.params.write(&mut bytes[16..]);
    }

    fn read(bytes: &[u8]) -> Self {
        Self {
            number: Shared::read(&bytes[0..]),
            params: Shared::read(&bytes[16..]),
        }
    }
}

impl Shared for MapSettings {
    const SIZE: usize = 64;

    fn write(&self, bytes: &mut [u8]) {
        self.coded.write(&mut bytes[0..]);
        self.layers.write(&mut bytes[4..]);
        self.texel_bytes.write(&mut bytes[8..]);
        self.first_level.write(&mut bytes[12..]);
        self.low.write(&mut bytes[16..]);
        self.step.write(&mut bytes[32..]);
        self.tile_m.write(&mut bytes[48..]);
    }

    fn read(bytes: &[u8]) -> Self {
        Self {
            coded: Shared::read(&bytes[0..]),
            layers: Shared::read(&bytes[4..]),
            texel_bytes: Shared::read(&bytes[8..]),
            first_level: Shared::read(&bytes[12..]),
            low: Shared::read(&bytes[16..]),
            step: Shared::read(&bytes[32..]),
            tile_m: Shared::read(&bytes[48..]),
        }
    }
}

impl Shared for SurfaceSettings {
    const SIZE: usize = 1200;

    fn write(&self, bytes: &mut [u8]) {
        self.choices.write(&mut bytes[0..]);
        self.maps.write(&mut bytes[384..]);
        self.diffuse.write(&mut bytes[896..]);
        self.specular.write(&mut bytes[912..]);
        self.emission.write(&mut bytes[928..]);
        self.color_u.write(&mut bytes[944..]);
        self.color_v.write(&mut bytes[960..]);
        self.height_size.write(&mut bytes[976..]);
        self.color_size.write(&mut bytes[984..]);
        self.normal_size.write(&mut bytes[992..]);
        self.material_size.write(&mut bytes[1000..]);
        self.height_levels.write(&mut bytes[1008..]);
        self.color_levels.write(&mut bytes[1012..]);
        self.normal_levels.write(&mut bytes[1016..]);
        self.material_levels.write(&mut bytes[1020..]);
        self.color_texels.write(&mut bytes[1024..]);
        self.normal_texels.write(&mut bytes[1028..]);
        self.material_texels.write(&mut bytes[1032..]);
        self.normal_tile_m.write(&mut bytes[1040..]);
        self.wrap.write(&mut bytes[1048..]);
        self.color_wrap_u.write(&mut bytes[1052..]);
        self.color_wrap_v.write(&mut bytes[1056..]);
        self.shininess.write(&mut bytes[1060..]);
        self.roughness.write(&mut bytes[1064..]);
        self.metallic.write(&mut bytes[1068..]);
        self.has_material.write(&mut bytes[1072..]);
        self.has_color.write(&mut bytes[1076..]);
        self.has_normal.write(&mut bytes[1080..]);
        self.has_holes.write(&mut bytes[1084..]);
        self.has_creases.write(&mut bytes[1088..]);
        self.has_vertex_normals.write(&mut bytes[1092..]);
        self.has_shadows.write(&mut bytes[1096..]);
        self.scale_m.write(&mut bytes[1100..]);
        self.bias_m.write(&mut bytes[1104..]);
        self.shell_m.write(&mut bytes[1112..]);
        self.mean_height.write(&mut bytes[1120..]);
        self.transmission.write(&mut bytes[1124..]);
        self.ior.write(&mut bytes[1128..]);
        self.number.write(&mut bytes[1132..]);
        self.environment_side.write(&mut bytes[1136..]);
        self.environment_levels.write(&mut bytes[1140..]);
        self.images.write(&mut bytes[1144..]);
        self.solids.write(&mut bytes[1148..]);
        self.cells.write(&mut bytes[1152..]);
        self.jump.write(&mut bytes[1156..]);
        self.volume.write(&mut bytes[1168..]);
        self.cutoff.write(&mut bytes[1184..]);
        self.translucent.write(&mut bytes[1192..]);
    }

    fn read(bytes: &[u8]) -> Self {
        Self {
            choices: Shared::read(&bytes[0..]),
            maps: Shared::read(&bytes[384..]),
            diffuse: Shared::read(&bytes[896..]),
            specular: Shared::read(&bytes[912..]),
            emission: Shared::read(&bytes[928..]),
            color_u: Shared::read(&bytes[944..]),
            color_v: Shared::read(&bytes[960..]),
            height_size: Shared::read(&bytes[976..]),
            color_size: Shared::read(&bytes[984..]),
            normal_size: Shared::read(&bytes[992..]),
            material_size: Shared::read(&bytes[1000..]),
            height_levels: Shared::read(&bytes[1008..]),
            color_levels: Shared::read(&bytes[1012..]),
            normal_levels: Shared::read(&bytes[1016..]),
            material_levels: Shared::read(&bytes[1020..]),
            color_texels: Shared::read(&bytes[1024..]),
            normal_texels: Shared::read(&bytes[1028..]),
            material_texels: Shared::read(&bytes[1032..]),
            normal_tile_m: Shared::read(&bytes[1040..]),
            wrap: Shared::read(&bytes[1048..]),
            color_wrap_u: Shared::read(&bytes[1052..]),
            color_wrap_v: Shared::read(&bytes[1056..]),
            shininess: Shared::read(&bytes[1060..]),
            roughness: Shared::read(&bytes[1064..]),
            metallic: Shared::read(&bytes[1068..]),
            has_material: Shared::read(&bytes[1072..]),
            has_color: Shared::read(&bytes[1076..]),
            has_normal: Shared::read(&bytes[1080..]),
            has_holes: Shared::read(&bytes[1084..]),
            has_creases: Shared::read(&bytes[1088..]),
            has_vertex_normals: Shared::read(&bytes[1092..]),
            has_shadows: Shared::read(&bytes[1096..]),
            scale_m: Shared::read(&bytes[1100..]),
            bias_m: Shared::read(&bytes[1104..]),
            shell_m: Shared::read(&bytes[1112..]),
            mean_height: Shared::read(&bytes[1120..]),
            transmission: Shared::read(&bytes[1124..]),
            ior: Shared::read(&bytes[1128..]),
            number: Shared::read(&bytes[1132..]),
            environment_side: Shared::read(&bytes[1136..]),
            environment_levels: Shared::read(&bytes[1140..]),
            images: Shared::read(&bytes[1144..]),
            solids: Shared::read(&bytes[1148..]),
            cells: Shared::read(&bytes[1152..]),
            jump: Shared::read(&bytes[1156..]),
            volume: Shared::read(&bytes[1168..]),
            cutoff: Shared::read(&bytes[1184..]),
            translucent: Shared::read(&bytes[1192..]),
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
/// A node of the hierarchy of boxes around the shells of triangles. The root is the first; the two children
/// of a node follow each other, the first at an odd place, and along the node's axis it lies lower.
pub struct ShellNode {
    pub low: rt::Vec3<f32>,
    /// For a node with children the place of the first. For a leaf SHELL_TRIANGLE times its
    /// triangle's number, plus SHELL_BOTH_SIDES if the triangle is seen turned over, too.
    pub first: u32,
    pub high: rt::Vec3<f32>,
    /// 16 times the place of the parent, plus 4 times the parent's axis, plus the node's own axis; a
    /// leaf has 3 as its axis.
    pub above: u32,
}

impl Shared for ShellNode {
    const SIZE: usize = 32;

    fn write(&self, bytes: &mut [u8]) {
        self.low.write(&mut bytes[0..]);
        self.first.write(&mut bytes[12..]);
        self.high.write(&mut bytes[16..]);
        self.above.write(&mut bytes[28..]);
    }

    fn read(bytes: &[u8]) -> Self {
        Self {
            low: Shared::read(&bytes[0..]),
            first: Shared::read(&bytes[12..]),
            high: Shared::read(&bytes[16..]),
            above: Shared::read(&bytes[28..]),
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
/// A pixel as it is read back: 24 words.
pub struct Record {
    pub color: rt::Vec4<f32>,
    pub position: rt::Vec3<f32>,
    pub depth: f32,
    pub normal: rt::Vec3<f32>,
    pub height: f32,
    pub uv: rt::Vec2<f32>,
    pub t: f32,
    /// 0 where the pixel shows no surface, 1 where it does, 3 where the search ran out of steps. To these,
    /// 4 times the level of detail and 256 times the surface's number are added.
    pub hit: u32,
    pub cell: rt::Vec2<i32>,
    pub reads: u32,
    pub steps: u32,
    pub bytes: u32,
    pub lit: f32,
    pub z: f32,
    pub transmittance: f32,
}

impl Shared for Record {
    const SIZE: usize = 96;

    fn write(&self, bytes: &mut [u8]) {
        self.color.write(&mut bytes[0..]);
        self.position.write(&mut bytes[16..]);
        self.depth.write(&mut bytes[28..]);
        self.normal.write(&mut bytes[32..]);
        self.height.write(&mut bytes[44..]);
        self.uv.write(&mut bytes[48..]);
        self.t.write(&mut bytes[56..]);
        self.hit.write(&mut bytes[60..]);
        self.cell.write(&mut bytes[64..]);
        self.reads.write(&mut bytes[72..]);
        self.steps.write(&mut bytes[76..]);
        self.bytes.write(&mut bytes[80..]);
        self.lit.write(&mut bytes[84..]);
        self.z.write(&mut bytes[88..]);
        self.transmittance.write(&mut bytes[92..]);
    }

    fn read(bytes: &[u8]) -> Self {
        Self {
            color: Shared::read(&bytes[0..]),
            position: Shared::read(&bytes[16..]),
            depth: Shared::read(&bytes[28..]),
            normal: Shared::read(&bytes[32..]),
            height: Shared::read(&bytes[44..]),
            uv: Shared::read(&bytes[48..]),
            t: Shared::read(&bytes[56..]),
            hit: Shared::read(&bytes[60..]),
            cell: Shared::read(&bytes[64..]),
            reads: Shared::read(&bytes[72..]),
            steps: Shared::read(&bytes[76..]),
            bytes: Shared::read(&bytes[80..]),
            lit: Shared::read(&bytes[84..]),
            z: Shared::read(&bytes[88..]),
            transmittance: Shared::read(&bytes[92..]),
        }
    }
}

impl Shared for Gathered {
    const SIZE: usize = 32;

    fn write(&self, bytes: &mut [u8]) {
        self.light.write(&mut bytes[0..]);
        self.transmittance.write(&mut bytes[12..]);
        self.entry.write(&mut bytes[16..]);
        self.until_m.write(&mut bytes[20..]);
        self.reach_m.write(&mut bytes[24..]);
        self.pending.write(&mut bytes[28..]);
    }

    fn read(bytes: &[u8]) -> Self {
        Self {
            light: Shared::read(&bytes[0..]),
            transmittance: Shared::read(&bytes[12..]),
            entry: Shared::read(&bytes[16..]),
            until_m: Shared::read(&bytes[20..]),
            reach_m: Shared::read(&bytes[24..]),
            pending: Shared::read(&bytes[28..]),
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
/// Settings of the pass that makes the picture for screens.
pub struct ScreenSettings {
    /// Columns and rows of the picture.
    pub size: rt::Vec2<u32>,
    /// The factor on light, from the exposure.
    pub gain: f32,
    /// The number of the tone curve; 0 is none.
    pub tone: u32,
}

impl Shared for ScreenSettings {
    const SIZE: usize = 16;

    fn write(&self, bytes: &mut [u8]) {
        self.size.write(&mut bytes[0..]);
        self.gain.write(&mut bytes[8..]);
        self.tone.write(&mut bytes[12..]);
    }

    fn read(bytes: &[u8]) -> Self {
        Self {
            size: Shared::read(&bytes[0..]),
            gain: Shared::read(&bytes[8..]),
            tone: Shared::read(&bytes[12..]),
        }
    }
}

impl Shared for PixelIn {
    const SIZE: usize = 352;

    fn write(&self, bytes: &mut [u8]) {
        self.origin.write(&mut bytes[0..]);
        self.direction.write(&mut bytes[16..]);
        self.side.write(&mut bytes[28..]);
        self.a.write(&mut bytes[32..]);
        self.b.write(&mut bytes[128..]);
        self.c.write(&mut bytes[224..]);
        self.shell.write(&mut bytes[320..]);
    }

    fn read(bytes: &[u8]) -> Self {
        Self {
            origin: Shared::read(&bytes[0..]),
            direction: Shared::read(&bytes[16..]),
            side: Shared::read(&bytes[28..]),
            a: Shared::read(&bytes[32..]),
            b: Shared::read(&bytes[128..]),
            c: Shared::read(&bytes[224..]),
            shell: Shared::read(&bytes[320..]),
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
/// Every stage's result for a ray, on the last segment that was traced.
pub struct Probe {
    /// The number of that segment, counted from 1; 0 if there was none.
    pub segment: u32,
    pub entry: rt::Vec2<f32>,
    pub duv: rt::Vec2<f32>,
    pub exit: f32,
    pub base: f32,
    pub h: rt::Vec3<f32>,
    pub status: u32,
    pub near: f32,
    pub far: f32,
    pub found: u32,
    pub exhausted: u32,
    pub uv: rt::Vec2<f32>,
    pub height: f32,
    pub t: f32,
    pub reads: u32,
    pub steps: u32,
    pub bytes: u32,
    /// The part of `mirrored_light` that arrives at the hit.
    pub lit: f32,
    /// The key that orders the hit among others of the ray.
    pub key: f32,
}

impl Shared for Probe {
    const SIZE: usize = 112;

    fn write(&self, bytes: &mut [u8]) {
        self.segment.write(&mut bytes[0..]);
        self.entry.write(&mut bytes[8..]);
        self.duv.write(&mut bytes[16..]);
        self.exit.write(&mut bytes[24..]);
        self.base.write(&mut bytes[28..]);
        self.h.write(&mut bytes[32..]);
        self.status.write(&mut bytes[44..]);
        self.near.write(&mut bytes[48..]);
        self.far.write(&mut bytes[52..]);
        self.found.write(&mut bytes[56..]);
        self.exhausted.write(&mut bytes[60..]);
        self.uv.write(&mut bytes[64..]);
        self.height.write(&mut bytes[72..]);
        self.t.write(&mut bytes[76..]);
        self.reads.write(&mut bytes[80..]);
        self.steps.write(&mut bytes[84..]);
        self.bytes.write(&mut bytes[88..]);
        self.lit.write(&mut bytes[92..]);
        self.key.write(&mut bytes[96..]);
    }

    fn read(bytes: &[u8]) -> Self {
        Self {
            segment: Shared::read(&bytes[0..]),
            entry: Shared::read(&bytes[8..]),
            duv: Shared::read(&bytes[16..]),
            exit: Shared::read(&bytes[24..]),
            base: Shared::read(&bytes[28..]),
            h: Shared::read(&bytes[32..]),
            status: Shared::read(&bytes[44..]),
            near: Shared::read(&bytes[48..]),
            far: Shared::read(&bytes[52..]),
            found: Shared::read(&bytes[56..]),
            exhausted: Shared::read(&bytes[60..]),
            uv: Shared::read(&bytes[64..]),
            height: Shared::read(&bytes[72..]),
            t: Shared::read(&bytes[76..]),
            reads: Shared::read(&bytes[80..]),
            steps: Shared::read(&bytes[84..]),
            bytes: Shared::read(&bytes[88..]),
            lit: Shared::read(&bytes[92..]),
            key: Shared::read(&bytes[96..]),
        }
    }
}

impl Shared for Hit {
    const SIZE: usize = 48;

    fn write(&self, bytes: &mut [u8]) {
        self.found.write(&mut bytes[0..]);
        self.exhausted.write(&mut bytes[4..]);
        self.uv.write(&mut bytes[8..]);
        self.height.write(&mut bytes[16..]);
        self.t.write(&mut bytes[20..]);
        self.cost.write(&mut bytes[32..]);
    }

    fn read(bytes: &[u8]) -> Self {
        Self {
            found: Shared::read(&bytes[0..]),
            exhausted: Shared::read(&bytes[4..]),
            uv: Shared::read(&bytes[8..]),
            height: Shared::read(&bytes[16..]),
            t: Shared::read(&bytes[20..]),
            cost: Shared::read(&bytes[32..]),
        }
    }
}

impl Shared for Path {
    const SIZE: usize = 96;

    fn write(&self, bytes: &mut [u8]) {
        self.uv.write(&mut bytes[0..]);
        self.duv.write(&mut bytes[8..]);
        self.h.write(&mut bytes[16..]);
        self.exit.write(&mut bytes[28..]);
        self.base.write(&mut bytes[32..]);
        self.metric.write(&mut bytes[48..]);
        self.ray.write(&mut bytes[64..]);
        self.level.write(&mut bytes[68..]);
        self.start.write(&mut bytes[72..]);
        self.share.write(&mut bytes[76..]);
        self.bend.write(&mut bytes[80..]);
    }

    fn read(bytes: &[u8]) -> Self {
        Self {
            uv: Shared::read(&bytes[0..]),
            duv: Shared::read(&bytes[8..]),
            h: Shared::read(&bytes[16..]),
            exit: Shared::read(&bytes[28..]),
            base: Shared::read(&bytes[32..]),
            metric: Shared::read(&bytes[48..]),
            ray: Shared::read(&bytes[64..]),
            level: Shared::read(&bytes[68..]),
            start: Shared::read(&bytes[72..]),
            share: Shared::read(&bytes[76..]),
            bend: Shared::read(&bytes[80..]),
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
/// Settings of a pass over a level of a pyramid.
pub struct PyramidPass {
    /// Columns and rows of the previous level of nodes, without padding; zeros for the first level.
    pub nodes_size: rt::Vec2<u32>,
    /// Columns and rows of the level of the height map that is read; zeros if none is.
    pub heights_size: rt::Vec2<u32>,
    /// The column and the row that stand for those after the last.
    pub beyond: rt::Vec2<u32>,
    /// Columns and rows of the height map that a node covers besides its own two: 1 for a pyramid
    /// over dual cells, which reach to the next texels.
    pub reach: u32,
    /// The number of the level of the height map.
    pub level: u32,
}

impl Shared for PyramidPass {
    const SIZE: usize = 32;

    fn write(&self, bytes: &mut [u8]) {
        self.nodes_size.write(&mut bytes[0..]);
        self.heights_size.write(&mut bytes[8..]);
        self.beyond.write(&mut bytes[16..]);
        self.reach.write(&mut bytes[24..]);
        self.level.write(&mut bytes[28..]);
    }

    fn read(bytes: &[u8]) -> Self {
        Self {
            nodes_size: Shared::read(&bytes[0..]),
            heights_size: Shared::read(&bytes[8..]),
            beyond: Shared::read(&bytes[16..]),
            reach: Shared::read(&bytes[24..]),
            level: Shared::read(&bytes[28..]),
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
/// An edge between two vertices of the base.
pub struct BaseEdge {
    /// The ends, in an order that all edges between the same positions agree on.
    pub ends: rt::Vec2<u32>,
    /// The ends of the edge between these positions that gives the points' places.
    pub seen: rt::Vec2<u32>,
    /// The change of u and v along the edge; the greatest among all edges between the same
    /// positions.
    pub along: rt::Vec2<f32>,
    /// The triangles at the edge. An edge with one triangle has it twice; an edge with more than two
    /// has COUNTLESS twice.
    pub patches: rt::Vec2<u32>,
}

impl Shared for BaseEdge {
    const SIZE: usize = 32;

    fn write(&self, bytes: &mut [u8]) {
        self.ends.write(&mut bytes[0..]);
        self.seen.write(&mut bytes[8..]);
        self.along.write(&mut bytes[16..]);
        self.patches.write(&mut bytes[24..]);
    }

    fn read(bytes: &[u8]) -> Self {
        Self {
            ends: Shared::read(&bytes[0..]),
            seen: Shared::read(&bytes[8..]),
            along: Shared::read(&bytes[16..]),
            patches: Shared::read(&bytes[24..]),
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
/// A triangle of the base.
pub struct BasePatch {
    pub corners: rt::Vec3<u32>,
    /// The least displacement on it, in metres.
    pub low_m: f32,
    /// The edges between its corners, from the first on.
    pub edges: rt::Vec3<u32>,
    /// The greatest.
    pub high_m: f32,
}

impl Shared for BasePatch {
    const SIZE: usize = 32;

    fn write(&self, bytes: &mut [u8]) {
        self.corners.write(&mut bytes[0..]);
        self.low_m.write(&mut bytes[12..]);
        self.edges.write(&mut bytes[16..]);
        self.high_m.write(&mut bytes[28..]);
    }

    fn read(bytes: &[u8]) -> Self {
        Self {
            corners: Shared::read(&bytes[0..]),
            low_m: Shared::read(&bytes[12..]),
            edges: Shared::read(&bytes[16..]),
            high_m: Shared::read(&bytes[28..]),
        }
    }
}

impl Shared for BaseVertex {
    const SIZE: usize = 128;

    fn write(&self, bytes: &mut [u8]) {
        self.position.write(&mut bytes[0..]);
        self.seen.write(&mut bytes[12..]);
        self.direction.write(&mut bytes[16..]);
        self.texels_per_m.write(&mut bytes[28..]);
        self.normal.write(&mut bytes[32..]);
        self.tangent.write(&mut bytes[48..]);
        self.bitangent.write(&mut bytes[64..]);
        self.turn_u.write(&mut bytes[80..]);
        self.turn_v.write(&mut bytes[96..]);
        self.uv.write(&mut bytes[112..]);
    }

    fn read(bytes: &[u8]) -> Self {
        Self {
            position: Shared::read(&bytes[0..]),
            seen: Shared::read(&bytes[12..]),
            direction: Shared::read(&bytes[16..]),
            texels_per_m: Shared::read(&bytes[28..]),
            normal: Shared::read(&bytes[32..]),
            tangent: Shared::read(&bytes[48..]),
            bitangent: Shared::read(&bytes[64..]),
            turn_u: Shared::read(&bytes[80..]),
            turn_v: Shared::read(&bytes[96..]),
            uv: Shared::read(&bytes[112..]),
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
/// Totals of all points and triangles, and the arguments of the draw call.
pub struct TessellationTotals {
    /// Vertices, instances, and the first of each.
    pub drawn: rt::Vec4<u32>,
    /// Workgroups that make points, and workgroups that make triangles.
    pub point_groups: rt::Vec4<u32>,
    pub triangle_groups: rt::Vec4<u32>,
    /// Points besides the base's vertices, and triangles.
    pub points: u32,
    pub triangles: u32,
    /// Number of doublings by which the grid is coarser.
    pub level: u32,
    /// 1 when the totals are known.
    pub is_known: u32,
}

impl Shared for TessellationTotals {
    const SIZE: usize = 64;

    fn write(&self, bytes: &mut [u8]) {
        self.drawn.write(&mut bytes[0..]);
        self.point_groups.write(&mut bytes[16..]);
        self.triangle_groups.write(&mut bytes[32..]);
        self.points.write(&mut bytes[48..]);
        self.triangles.write(&mut bytes[52..]);
        self.level.write(&mut bytes[56..]);
        self.is_known.write(&mut bytes[60..]);
    }

    fn read(bytes: &[u8]) -> Self {
        Self {
            drawn: Shared::read(&bytes[0..]),
            point_groups: Shared::read(&bytes[16..]),
            triangle_groups: Shared::read(&bytes[32..]),
            points: Shared::read(&bytes[48..]),
            triangles: Shared::read(&bytes[52..]),
            level: Shared::read(&bytes[56..]),
            is_known: Shared::read(&bytes[60..]),
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
/// The number of points and triangles that an edge or a triangle of the base yields.
pub struct Tally {
    /// For an edge its parts. For a triangle 0 if it is culled, SWEPT if the grid fills it,
    /// otherwise 1.
    pub parts: u32,
    /// Its points and triangles; in the end the points and triangles of all tallies before it.
    pub points: u32,
    pub triangles: u32,
}

impl Shared for Tally {
    const SIZE: usize = 12;

    fn write(&self, bytes: &mut [u8]) {
        self.parts.write(&mut bytes[0..]);
        self.points.write(&mut bytes[4..]);
        self.triangles.write(&mut bytes[8..]);
    }

    fn read(bytes: &[u8]) -> Self {
        Self {
            parts: Shared::read(&bytes[0..]),
            points: Shared::read(&bytes[4..]),
            triangles: Shared::read(&bytes[8..]),
        }
    }
}

impl Shared for Tessellation {
    const SIZE: usize = 208;

    fn write(&self, bytes: &mut [u8]) {
        self.eye.write(&mut bytes[0..]);
        self.right.write(&mut bytes[16..]);
        self.up.write(&mut bytes[32..]);
        self.forward.write(&mut bytes[48..]);
        self.planes.write(&mut bytes[64..]);
        self.middle.write(&mut bytes[144..]);
        self.per_m.write(&mut bytes[152..]);
        self.per_doubling.write(&mut bytes[156..]);
        self.near_m.write(&mut bytes[160..]);
        self.is_parallel.write(&mut bytes[164..]);
        self.levels.write(&mut bytes[168..]);
        self.vertices.write(&mut bytes[172..]);
        self.edges.write(&mut bytes[176..]);
        self.patches.write(&mut bytes[180..]);
        self.most_points.write(&mut bytes[184..]);
        self.most_triangles.write(&mut bytes[188..]);
        self.parts_of_uv.write(&mut bytes[192..]);
        self.is_swept.write(&mut bytes[200..]);
    }

    fn read(bytes: &[u8]) -> Self {
        Self {
            eye: Shared::read(&bytes[0..]),
            right: Shared::read(&bytes[16..]),
            up: Shared::read(&bytes[32..]),
            forward: Shared::read(&bytes[48..]),
            planes: Shared::read(&bytes[64..]),
            middle: Shared::read(&bytes[144..]),
            per_m: Shared::read(&bytes[152..]),
            per_doubling: Shared::read(&bytes[156..]),
            near_m: Shared::read(&bytes[160..]),
            is_parallel: Shared::read(&bytes[164..]),
            levels: Shared::read(&bytes[168..]),
            vertices: Shared::read(&bytes[172..]),
            edges: Shared::read(&bytes[176..]),
            patches: Shared::read(&bytes[180..]),
            most_points: Shared::read(&bytes[184..]),
            most_triangles: Shared::read(&bytes[188..]),
            parts_of_uv: Shared::read(&bytes[192..]),
            is_swept: Shared::read(&bytes[200..]),
        }
    }
}

impl Shared for Voxel {
    const SIZE: usize = 16;

    fn write(&self, bytes: &mut [u8]) {
        self.at.write(&mut bytes[0..]);
        self.share.write(&mut bytes[12..]);
    }

    fn read(bytes: &[u8]) -> Self {
        Self {
            at: Shared::read(&bytes[0..]),
            share: Shared::read(&bytes[12..]),
        }
    }
}
