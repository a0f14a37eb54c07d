// Blocks of the shaders' structs. Written by `cargo xtask link`; do not edit.

use super::*;

/// Sixteen of [`Path`], each number of theirs in a row.
#[derive(Clone, Copy, Debug)]
pub struct PathBlock {
    pub uv: [[f32; BLOCK]; 2],
    pub duv: [[f32; BLOCK]; 2],
    pub h: [[f32; BLOCK]; 3],
    pub exit: [f32; BLOCK],
    pub base: [f32; BLOCK],
    pub metric: [[f32; BLOCK]; 4],
    pub ray: [u32; BLOCK],
    pub level: [u32; BLOCK],
    pub start: [f32; BLOCK],
    pub share: [f32; BLOCK],
    pub bend: [f32; BLOCK],
}

impl Default for PathBlock {
    fn default() -> Self {
        Self {
            uv: [[0f32; BLOCK]; 2],
            duv: [[0f32; BLOCK]; 2],
            h: [[0f32; BLOCK]; 3],
            exit: [0f32; BLOCK],
            base: [0f32; BLOCK],
            metric: [[0f32; BLOCK]; 4],
            ray: [0u32; BLOCK],
            level: [0u32; BLOCK],
            start: [0f32; BLOCK],
            share: [0f32; BLOCK],
            bend: [0f32; BLOCK],
        }
    }
}

impl PathBlock {
    /// Puts one in a place.
    #[inline]
    pub fn set(&mut self, at: usize, value: &Path) {
        self.uv[0][at] = value.uv.x;
        self.uv[1][at] = value.uv.y;
        self.duv[0][at] = value.duv.x;
        self.duv[1][at] = value.duv.y;
        self.h[0][at] = value.h.x;
        self.h[1][at] = value.h.y;
        self.h[2][at] = value.h.z;
        self.exit[at] = value.exit;
        self.base[at] = value.base;
        self.metric[0][at] = value.metric.x;
        self.metric[1][at] = value.metric.y;
        self.metric[2][at] = value.metric.z;
        self.metric[3][at] = value.metric.w;
        self.ray[at] = value.ray;
        self.level[at] = value.level;
        self.start[at] = value.start;
        self.share[at] = value.share;
        self.bend[at] = value.bend;
    }

    /// The one in a place.
    #[inline]
    pub fn get(&self, at: usize) -> Path {
        Path {
            uv: Vec2 { x: self.uv[0][at], y: self.uv[1][at] },
            duv: Vec2 { x: self.duv[0][at], y: self.duv[1][at] },
            h: Vec3 { x: self.h[0][at], y: self.h[1][at], z: self.h[2][at] },
            exit: self.exit[at],
            base: self.base[at],
            metric: Vec4 { x: self.metric[0][at], y: self.metric[1][at], z: self.metric[2][at], w: self.metric[3][at] },
            ray: self.ray[at],
            level: self.level[at],
            start: self.start[at],
            share: self.share[at],
            bend: self.bend[at],
        }
    }
}

/// Sixteen of [`Hit`], each number of theirs in a row.
#[derive(Clone, Copy, Debug)]
pub struct HitBlock {
    pub found: [u32; BLOCK],
    pub exhausted: [u32; BLOCK],
    pub uv: [[f32; BLOCK]; 2],
    pub height: [f32; BLOCK],
    pub t: [f32; BLOCK],
    pub cost: [[u32; BLOCK]; 3],
}

impl Default for HitBlock {
    fn default() -> Self {
        Self {
            found: [0u32; BLOCK],
            exhausted: [0u32; BLOCK],
            uv: [[0f32; BLOCK]; 2],
            height: [0f32; BLOCK],
            t: [0f32; BLOCK],
            cost: [[0u32; BLOCK]; 3],
        }
    }
}

impl HitBlock {
    /// Puts one in a place.
    #[inline]
    pub fn set(&mut self, at: usize, value: &Hit) {
        self.found[at] = value.found;
        self.exhausted[at] = value.exhausted;
        self.uv[0][at] = value.uv.x;
        self.uv[1][at] = value.uv.y;
        self.height[at] = value.height;
        self.t[at] = value.t;
        self.cost[0][at] = value.cost.x;
        self.cost[1][at] = value.cost.y;
        self.cost[2][at] = value.cost.z;
    }

    /// The one in a place.
    #[inline]
    pub fn get(&self, at: usize) -> Hit {
        Hit {
            found: self.found[at],
            exhausted: self.exhausted[at],
            uv: Vec2 { x: self.uv[0][at], y: self.uv[1][at] },
            height: self.height[at],
            t: self.t[at],
            cost: Vec3 { x: self.cost[0][at], y: self.cost[1][at], z: self.cost[2][at] },
        }
    }
}

/// Sixteen of [`Entered`], each number of theirs in a row.
#[derive(Clone, Copy, Debug)]
pub struct EnteredBlock {
    pub segments: [u32; BLOCK],
    pub point: [[f32; BLOCK]; 3],
    pub uv: [[f32; BLOCK]; 2],
    pub tangent: [[f32; BLOCK]; 3],
    pub bitangent: [[f32; BLOCK]; 3],
    pub normal: [[f32; BLOCK]; 3],
    pub metric: [[f32; BLOCK]; 4],
    pub level: [u32; BLOCK],
    pub facing: [[f32; BLOCK]; 3],
    pub span: [[f32; BLOCK]; 2],
    pub of_surface: [[f32; BLOCK]; 4],
    pub footprint: [f32; BLOCK],
    pub fade: [f32; BLOCK],
    pub depth: [f32; BLOCK],
}

impl Default for EnteredBlock {
    fn default() -> Self {
        Self {
            segments: [0u32; BLOCK],
            point: [[0f32; BLOCK]; 3],
            uv: [[0f32; BLOCK]; 2],
            tangent: [[0f32; BLOCK]; 3],
            bitangent: [[0f32; BLOCK]; 3],
            normal: [[0f32; BLOCK]; 3],
            metric: [[0f32; BLOCK]; 4],
            level: [0u32; BLOCK],
            facing: [[0f32; BLOCK]; 3],
            span: [[0f32; BLOCK]; 2],
            of_surface: [[0f32; BLOCK]; 4],
            footprint: [0f32; BLOCK],
            fade: [0f32; BLOCK],
            depth: [0f32; BLOCK],
        }
    }
}

impl EnteredBlock {
    /// Puts one in a place.
    #[inline]
    pub fn set(&mut self, at: usize, value: &Entered) {
        self.segments[at] = value.segments;
        self.point[0][at] = value.point.x;
        self.point[1][at] = value.point.y;
        self.point[2][at] = value.point.z;
        self.uv[0][at] = value.uv.x;
        self.uv[1][at] = value.uv.y;
        self.tangent[0][at] = value.tangent.x;
        self.tangent[1][at] = value.tangent.y;
        self.tangent[2][at] = value.tangent.z;
        self.bitangent[0][at] = value.bitangent.x;
        self.bitangent[1][at] = value.bitangent.y;
        self.bitangent[2][at] = value.bitangent.z;
        self.normal[0][at] = value.normal.x;
        self.normal[1][at] = value.normal.y;
        self.normal[2][at] = value.normal.z;
        self.metric[0][at] = value.metric.x;
        self.metric[1][at] = value.metric.y;
        self.metric[2][at] = value.metric.z;
        self.metric[3][at] = value.metric.w;
        self.level[at] = value.level;
        self.facing[0][at] = value.facing.x;
        self.facing[1][at] = value.facing.y;
        self.facing[2][at] = value.facing.z;
        self.span[0][at] = value.span.x;
        self.span[1][at] = value.span.y;
        self.of_surface[0][at] = value.of_surface.x;
        self.of_surface[1][at] = value.of_surface.y;
        self.of_surface[2][at] = value.of_surface.z;
        self.of_surface[3][at] = value.of_surface.w;
        self.footprint[at] = value.footprint;
        self.fade[at] = value.fade;
        self.depth[at] = value.depth;
    }

    /// The one in a place.
    #[inline]
    pub fn get(&self, at: usize) -> Entered {
        Entered {
            segments: self.segments[at],
            point: Vec3 { x: self.point[0][at], y: self.point[1][at], z: self.point[2][at] },
            uv: Vec2 { x: self.uv[0][at], y: self.uv[1][at] },
            tangent: Vec3 { x: self.tangent[0][at], y: self.tangent[1][at], z: self.tangent[2][at] },
            bitangent: Vec3 { x: self.bitangent[0][at], y: self.bitangent[1][at], z: self.bitangent[2][at] },
            normal: Vec3 { x: self.normal[0][at], y: self.normal[1][at], z: self.normal[2][at] },
            metric: Vec4 { x: self.metric[0][at], y: self.metric[1][at], z: self.metric[2][at], w: self.metric[3][at] },
            level: self.level[at],
            facing: Vec3 { x: self.facing[0][at], y: self.facing[1][at], z: self.facing[2][at] },
            span: Vec2 { x: self.span[0][at], y: self.span[1][at] },
            of_surface: Vec4 { x: self.of_surface[0][at], y: self.of_surface[1][at], z: self.of_surface[2][at], w: self.of_surface[3][at] },
            footprint: self.footprint[at],
            fade: self.fade[at],
            depth: self.depth[at],
        }
    }
}

/// Sixteen of [`PixelOut`], each number of theirs in a row.
#[derive(Clone, Copy, Debug)]
pub struct PixelOutBlock {
    pub color: [[f32; BLOCK]; 4],
    pub hit: [u32; BLOCK],
    pub exhausted: [u32; BLOCK],
    pub uv: [[f32; BLOCK]; 2],
    pub height: [f32; BLOCK],
    pub position: [[f32; BLOCK]; 3],
    pub normal: [[f32; BLOCK]; 3],
    pub depth: [f32; BLOCK],
    pub t: [f32; BLOCK],
    pub cell: [[i32; BLOCK]; 2],
    pub reads: [u32; BLOCK],
    pub steps: [u32; BLOCK],
    pub bytes: [u32; BLOCK],
    pub lit: [f32; BLOCK],
    pub level: [u32; BLOCK],
    pub z: [f32; BLOCK],
    pub surface: [u32; BLOCK],
    pub transmittance: [f32; BLOCK],
}

impl Default for PixelOutBlock {
    fn default() -> Self {
        Self {
            color: [[0f32; BLOCK]; 4],
            hit: [0u32; BLOCK],
            exhausted: [0u32; BLOCK],
            uv: [[0f32; BLOCK]; 2],
            height: [0f32; BLOCK],
            position: [[0f32; BLOCK]; 3],
            normal: [[0f32; BLOCK]; 3],
            depth: [0f32; BLOCK],
            t: [0f32; BLOCK],
            cell: [[0i32; BLOCK]; 2],
            reads: [0u32; BLOCK],
            steps: [0u32; BLOCK],
            bytes: [0u32; BLOCK],
            lit: [0f32; BLOCK],
            level: [0u32; BLOCK],
            z: [0f32; BLOCK],
            surface: [0u32; BLOCK],
            transmittance: [0f32; BLOCK],
        }
    }
}

impl PixelOutBlock {
    /// Puts one in a place.
    #[inline]
    pub fn set(&mut self, at: usize, value: &PixelOut) {
        self.color[0][at] = value.color.x;
        self.color[1][at] = value.color.y;
        self.color[2][at] = value.color.z;
        self.color[3][at] = value.color.w;
        self.hit[at] = value.hit;
        self.exhausted[at] = value.exhausted;
        self.uv[0][at] = value.uv.x;
        self.uv[1][at] = value.uv.y;
        self.height[at] = value.height;
        self.position[0][at] = value.position.x;
        self.position[1][at] = value.position.y;
        self.position[2][at] = value.position.z;
        self.normal[0][at] = value.normal.x;
        self.normal[1][at] = value.normal.y;
        self.normal[2][at] = value.normal.z;
        self.depth[at] = value.depth;
        self.t[at] = value.t;
        self.cell[0][at] = value.cell.x;
        self.cell[1][at] = value.cell.y;
        self.reads[at] = value.reads;
        self.steps[at] = value.steps;
        self.bytes[at] = value.bytes;
        self.lit[at] = value.lit;
        self.level[at] = value.level;
        self.z[at] = value.z;
        self.surface[at] = value.surface;
        self.transmittance[at] = value.transmittance;
    }

    /// The one in a place.
    #[inline]
    pub fn get(&self, at: usize) -> PixelOut {
        PixelOut {
            color: Vec4 { x: self.color[0][at], y: self.color[1][at], z: self.color[2][at], w: self.color[3][at] },
            hit: self.hit[at],
            exhausted: self.exhausted[at],
            uv: Vec2 { x: self.uv[0][at], y: self.uv[1][at] },
            height: self.height[at],
            position: Vec3 { x: self.position[0][at], y: self.position[1][at], z: self.position[2][at] },
            normal: Vec3 { x: self.normal[0][at], y: self.normal[1][at], z: self.normal[2][at] },
            depth: self.depth[at],
            t: self.t[at],
            cell: Vec2 { x: self.cell[0][at], y: self.cell[1][at] },
            reads: self.reads[at],
            steps: self.steps[at],
            bytes: self.bytes[at],
            lit: self.lit[at],
            level: self.level[at],
            z: self.z[at],
            surface: self.surface[at],
            transmittance: self.transmittance[at],
        }
    }
}
