//! A camera, a bilinear surface on the built-in plane and its first hits, written down from the
//! conventions alone, in `f64`.

use std::fmt::Write;

use glam::{DVec2, DVec3};

use super::maps::Map;

/// Points of a ray that are tried between the top and the bottom of the relief.
const STEPS: u32 = 2000;

#[derive(Clone, Copy, Debug)]
pub struct View {
    pub eye: DVec3,
    pub target: DVec3,
    pub fov_degrees: f64,
    pub size: [usize; 2],
}

impl View {
    pub fn flags(&self) -> String {
        let Self { eye, target, fov_degrees, size: [width, height] } = self;
        let point = |p: &DVec3| format!("{},{},{}", p.x, p.y, p.z);
        format!("--eye {} --target {} --fov {fov_degrees} --size {width}x{height}", point(eye), point(target))
    }

    pub fn forward(&self) -> DVec3 {
        (self.target - self.eye).normalize()
    }

    /// Through the centre of a pixel; row 0 is on top.
    pub fn ray(&self, x: usize, y: usize) -> DVec3 {
        let right = self.forward().cross(DVec3::Y).normalize();
        let up = right.cross(self.forward());
        let [width, height] = self.size.map(|side| side as f64);
        let half = (self.fov_degrees / 2.0).to_radians().tan();
        let across = ((x as f64 + 0.5) / width * 2.0 - 1.0) * half * width / height;
        let upward = (1.0 - (y as f64 + 0.5) / height * 2.0) * half;
        self.forward() + right * across + up * upward
    }
}

/// Continuation of a map beyond its edges.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Continuation {
    Repeat,
    Clamp,
    Mirror,
}

/// A height map on the unit square of the plane `y = 0`.
#[derive(Clone, Debug)]
pub struct Relief {
    pub map: Map,
    pub scale_m: f64,
    pub bias_m: f64,
    pub tile: [f64; 2],
    pub wrap: Continuation,
}

impl Relief {
    pub fn new(map: Map) -> Self {
        Self { map, scale_m: 0.05, bias_m: -0.05, tile: [1.0; 2], wrap: Continuation::Repeat }
    }

    pub fn flags(&self) -> String {
        let mut flags = format!("--scale {} --tile {},{}", self.scale_m, self.tile[0], self.tile[1]);
        let wrap = format!("{:?}", self.wrap).to_lowercase();
        write!(flags, " --wrap {wrap} --bias {}", self.bias_m).expect("strings grow");
        flags
    }

    fn texel(&self, column: i64, row: i64) -> f64 {
        let place = |at: i64, side: u32| {
            let side = i64::from(side);
            let within = match self.wrap {
                Continuation::Repeat => at.rem_euclid(side),
                Continuation::Clamp => at.clamp(0, side - 1),
                Continuation::Mirror => {
                    let there_and_back = at.rem_euclid(2 * side);
                    there_and_back.min(2 * side - 1 - there_and_back)
                }
            };
            within as usize
        };
        let (column, row) = (place(column, self.map.width), place(row, self.map.height));
        f64::from(self.map.texels[row * self.map.width as usize + column]) / 65535.0
    }

    /// Bilinear between texel centres.
    pub fn height(&self, uv: DVec2) -> f64 {
        let at = uv * DVec2::new(f64::from(self.map.width), f64::from(self.map.height)) - 0.5;
        let (cell, part) = (at.floor(), at - at.floor());
        let texel = |i: i64, j: i64| self.texel(cell.x as i64 + i, cell.y as i64 + j);
        let top = texel(0, 0) * (1.0 - part.x) + texel(1, 0) * part.x;
        let bottom = texel(0, 1) * (1.0 - part.x) + texel(1, 1) * part.x;
        top * (1.0 - part.y) + bottom * part.y
    }

    /// The point of the surface at texture coordinates.
    pub fn point(&self, uv: DVec2) -> DVec3 {
        let level = self.bias_m + self.scale_m * self.height(uv);
        DVec3::new(uv.x / self.tile[0] - 0.5, level, uv.y / self.tile[1] - 0.5)
    }

    /// By central differences over two texels; of a clamped map over what of them lies between its
    /// outermost centres.
    pub fn normal(&self, uv: DVec2) -> DVec3 {
        let texel = 1.0 / DVec2::new(f64::from(self.map.width), f64::from(self.map.height));
        let inside = |at: DVec2| match self.wrap {
            Continuation::Clamp => at.clamp(0.5 * texel, 1.0 - 0.5 * texel),
            Continuation::Repeat | Continuation::Mirror => at,
        };
        // Clamped along the axis of the step alone.
        let across = |axis: DVec2| {
            let place = |sign: f64| uv + (inside(uv + sign * axis * texel) - uv) * axis;
            (self.point(place(1.0)) - self.point(place(-1.0))).normalize()
        };
        across(DVec2::Y).cross(across(DVec2::X)).normalize()
    }

    fn uv(&self, point: DVec3) -> DVec2 {
        DVec2::new((point.x + 0.5) * self.tile[0], (point.z + 0.5) * self.tile[1])
    }

    /// The first point of the surface on a ray that meets the polygon from above.
    pub fn first_hit(&self, eye: DVec3, ray: DVec3) -> Option<DVec3> {
        let at_level = |level: f64| (level - eye.y) / ray.y;
        let base = eye + ray * at_level(0.0);
        if ray.y >= 0.0 || base.x.abs() > 0.5 || base.z.abs() > 0.5 {
            return None;
        }
        let above = |t: f64| {
            let point = eye + ray * t;
            point.y - self.bias_m - self.scale_m * self.height(self.uv(point))
        };
        let inside = |t: f64| {
            let uv = self.uv(eye + ray * t);
            self.wrap != Continuation::Clamp || (uv.min_element() >= 0.0 && uv.max_element() <= 1.0)
        };
        let (top, bottom) = (at_level(self.bias_m + self.scale_m), at_level(self.bias_m));
        let place = |step: u32| top + (bottom - top) * f64::from(step) / f64::from(STEPS);
        let below = (0..=STEPS).map(place).find(|&t| inside(t) && above(t) <= 0.0)?;
        let (mut near, mut far) = (below - (bottom - top) / f64::from(STEPS), below);
        for _ in 0..50 {
            let middle = 0.5 * (near + far);
            if above(middle) > 0.0 { near = middle } else { far = middle }
        }
        Some(eye + ray * far)
    }
}
