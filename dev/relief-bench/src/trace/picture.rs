//! Picture with the same parts as the other renderer's: view ray, smooth normal, one shadow
//! ray a hit, Lambert's light.

use std::path::Path as FilePath;

use glam::{DVec2, DVec3};
use rayon::ThreadPool;
use rayon::prelude::*;
use relief_core::camera::Camera;
use relief_core::exact::{FastTracer, HitPacket, PathPacket};
use relief_core::{HeightMap, Lanes};
use relief_io::{PngColour, write_png8};

use super::view::{Ground, SCALE_M, SIZE, camera, sun};

/// Light that reaches every point, and light of the sun, as shares of white.
pub const AMBIENT: f64 = 0.15;
/// See [`AMBIENT`].
pub const DIFFUSE: f64 = 0.85;

/// Rows that a thread takes at a time.
const ROWS: usize = 8;

/// Pixels along a side of the blocks whose rays are traced together.
const SIDE: usize = 4;

const _: () = assert!(SIDE * SIDE == PathPacket::LEN && ROWS.is_multiple_of(SIDE));

/// A picture in linear light, row by row from the top.
pub struct Picture {
    /// One value a pixel, white is 1.
    pub grey: Vec<f32>,
    /// Number of traced shadow rays: one a hit.
    pub shadow_rays: usize,
}

/// Rendered scene.
pub struct Stage<'a> {
    map: &'a HeightMap,
    tracer: &'a FastTracer,
    ground: Ground,
    camera: Camera,
    sun: DVec3,
}

impl<'a> Stage<'a> {
    /// The one view of a map.
    pub fn new(map: &'a HeightMap, tracer: &'a FastTracer) -> Result<Self, String> {
        let camera = camera().map_err(|error| error.to_string())?;
        Ok(Self { map, tracer, ground: Ground::of(map), camera, sun: sun() })
    }

    /// Renders on the threads of a pool.
    pub fn render(&self, pool: &ThreadPool) -> Picture {
        let width = SIZE[0] as usize;
        let mut grey = vec![0.0f32; width * SIZE[1] as usize];
        let bands = grey.par_chunks_mut(ROWS * width).enumerate().map(|(band, pixels)| {
            let rows = pixels.len() / width;
            let blocks = (0..rows).step_by(SIDE).flat_map(|y| (0..width).step_by(SIDE).map(move |x| [x, y]));
            blocks.map(|block| self.block(block, band * ROWS, pixels)).sum::<usize>()
        });
        let shadow_rays = pool.install(|| bands.sum());
        Picture { grey, shadow_rays }
    }

    /// Renders the pixels from one of a band on, and says how many of them have a hit.
    #[inline]
    fn block(&self, [left, top]: [usize; 2], first_row: usize, pixels: &mut [f32]) -> usize {
        let width = SIZE[0] as usize;
        let place = |lane: usize| [left + lane % SIDE, top + lane / SIDE];
        let pixel = |[x, y]: [usize; 2]| y * width + x;
        let is_inside = |[x, y]: [usize; 2]| x < width && pixel([x, y]) < pixels.len();
        let (mut view, mut to_sun) = (PathPacket::EMPTY, PathPacket::EMPTY);
        for lane in (0..PathPacket::LEN).filter(|lane| is_inside(place(*lane))) {
            let [x, y] = place(lane);
            let ray = self.camera.ray(x as u32, (first_row + y) as u32, SIZE[0], SIZE[1]);
            if let Some(path) = self.ground.path(ray.origin, ray.direction) {
                view.set(lane, &path);
            }
        }
        let mut hits = [HitPacket::MISSES];
        self.tracer.trace_packets(&[view], Lanes::widest(), &mut hits);
        let [hits] = hits;
        let found = |lane: &usize| hits.found >> lane & 1 == 1;
        for lane in (0..HitPacket::LEN).filter(found) {
            let point = Ground::point(hits.uv.map(|row| row[lane]), hits.height[lane]);
            if let Some(path) = self.ground.path_to_sun(point, self.sun) {
                to_sun.set(lane, &path);
            }
        }
        let [blocked] = self.tracer.blocked_packets(&[to_sun], Lanes::widest());
        for lane in (0..HitPacket::LEN).filter(found) {
            let normal = || smooth_normal(self.map, hits.uv.map(|row| row[lane]));
            let facing = if blocked >> lane & 1 == 1 { 0.0 } else { normal().dot(self.sun).max(0.0) };
            pixels[pixel(place(lane))] = (AMBIENT + DIFFUSE * facing) as f32;
        }
        hits.found.count_ones() as usize
    }
}

/// The unit normal between those at the texels around, which are of central differences.
fn smooth_normal(map: &HeightMap, uv: [f64; 2]) -> DVec3 {
    let size = [map.width(), map.height()];
    let place = [0, 1].map(|axis| uv[axis] * f64::from(size[axis]) - 0.5);
    let cell = place.map(|place| place.floor() as i64);
    let [fx, fy] = [0, 1].map(|axis| place[axis] - cell[axis] as f64);
    // Three texels before the cell to two after it, along both axes.
    let [columns, rows] =
        [0, 1].map(|axis| [-1, 0, 1, 2].map(|by| map.wrap().index(cell[axis] + by, size[axis]) as usize));
    let texels = rows.map(|row| {
        let row = &map.texels()[row * size[0] as usize..];
        columns.map(|column| f64::from(row[column]))
    });
    let slope = |i: usize, j: usize| {
        DVec2::new(texels[j][i + 1] - texels[j][i - 1], texels[j + 1][i] - texels[j - 1][i])
    };
    let top = slope(1, 1).lerp(slope(2, 1), fx);
    let bottom = slope(1, 2).lerp(slope(2, 2), fx);
    let metres = DVec2::new(f64::from(size[0]), f64::from(size[1])) * (SCALE_M / 2.0);
    let slope = top.lerp(bottom, fy) * metres;
    DVec3::new(-slope.x, 1.0, -slope.y).normalize()
}

/// Writes a picture as an sRGB PNG.
pub fn write(path: &FilePath, grey: &[f32]) -> Result<(), String> {
    let bytes: Vec<u8> = grey.iter().map(|&grey| srgb_byte(grey)).collect();
    write_png8(path, SIZE[0], SIZE[1], PngColour::Grey, &bytes).map_err(|error| error.to_string())
}

/// A linear value as an sRGB byte (IEC 61966-2-1).
fn srgb_byte(linear: f32) -> u8 {
    let linear = linear.clamp(0.0, 1.0);
    let curved = if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 };
    (curved * 255.0).round() as u8
}

/// Pixels by which one picture is moved over the other to see whether they show the same view.
const SHIFTS: i64 = 2;

/// Mean absolute difference of two pictures, white is 1, and the shift of whole pixels at which it is least.
pub fn difference(one: &[f32], other: &[f32]) -> (f64, [i64; 2]) {
    let [width, height] = SIZE.map(i64::from);
    let shifted = |[right, down]: [i64; 2]| {
        let (mut sum, mut count) = (0.0, 0.0);
        for y in SHIFTS..height - SHIFTS {
            for x in SHIFTS..width - SHIFTS {
                let (at, beside) = (y * width + x, (y + down) * width + x + right);
                sum += f64::from((one[at as usize] - other[beside as usize]).abs());
                count += 1.0;
            }
        }
        sum / count
    };
    let shifts = (-SHIFTS..=SHIFTS).flat_map(|down| (-SHIFTS..=SHIFTS).map(move |right| [right, down]));
    let least = shifts.map(|shift| (shifted(shift), shift)).min_by(|a, b| a.0.total_cmp(&b.0));
    (shifted([0, 0]), least.map_or([0, 0], |(_, shift)| shift))
}

#[cfg(test)]
mod tests {
    use super::*;
    use relief_core::Wrap;

    #[test]
    fn the_normal_of_a_ramp_is_the_ramps() {
        let ramp = HeightMap::from_fn(20, 10, Wrap::Clamp, |i, j| 0.02 * i as f32 + 0.03 * j as f32);
        let normal = smooth_normal(&ramp.expect("a valid size"), [0.47, 0.61]);
        let expected = DVec3::new(-0.02 * 20.0 * SCALE_M, 1.0, -0.03 * 10.0 * SCALE_M).normalize();
        assert!((normal - expected).length() < 1e-6, "{normal} instead of {expected}");
    }

    #[test]
    fn a_moved_picture_is_noticed() {
        let [width, height] = SIZE.map(|side| side as usize);
        let pixel = |x: usize, y: usize| ((x * 7 + y * 13) % 101) as f32 / 101.0;
        let picture = |right: usize| -> Vec<f32> {
            (0..width * height).map(|at| pixel(at % width + right, at / width)).collect()
        };
        assert_eq!(difference(&picture(0), &picture(0)), (0.0, [0, 0]));
        let (difference, shift) = difference(&picture(0), &picture(1));
        assert!(difference > 0.05 && shift == [-1, 0], "{difference} at {shift:?}");
    }
}
