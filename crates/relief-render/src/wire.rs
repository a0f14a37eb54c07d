//! The edges of base meshes, drawn over a finished picture.

use glam::{DVec2, DVec3};
use relief_shaders::cpu::PixelOut;

use relief_core::camera::Camera;
use relief_scene::Scene;

/// The lines' linear colour, visible on grey, white and black.
const COLOR: [f32; 3] = [1.0, 0.25, 0.0];

/// Share of the line in the colour of a pixel that lies wholly on it: in front of the visible
/// surface, and behind it.
const SHOWN: f32 = 0.9;
const HIDDEN: f32 = 0.2;

/// Distance behind the visible surface at which an edge becomes fainter, in pixel widths. At twice
/// the distance it is faint. The surface is known at one point of a pixel only: with a smaller
/// distance, edges on inclined surfaces are broken.
const SLACK: f64 = 4.0;

/// Least depth of a drawn point, as a part of the greatest depth. No drawn point lies behind the
/// eye.
const LEAST_DEPTH: f64 = 1e-6;

/// Margin around the picture in which lines begin and end, in pixels.
const BESIDE: f64 = 2.0;

/// Draws the edges of a scene's base meshes over its picture, row by row, as rows come from a
/// renderer.
///
/// Lines are a pixel wide and fade to both sides. They are faint behind the visible surface, by the
/// depth along the view axis. The edges belong to the flat base triangles: where the relief rises
/// above its base, they lie behind it.
///
/// ```
/// use relief_core::mesh::square;
/// use relief_render::picture::Display;
/// use relief_scene::{Scene, Surface};
/// use relief_render::{Wire, render};
///
/// let heights = relief_core::HeightMap::new(1, 1, vec![1.0], relief_core::Wrap::Repeat)?;
/// let heights = heights.with_displacement(0.1, -0.1)?;
/// let scene = Scene::builder(Surface::new(square(2)?, heights)).size(64, 48).build()?;
/// let mut maps = relief_maps::Maps::in_memory();
/// let picture = render(&scene, &mut maps, &relief_core::Watch::none())?.rendering;
/// let mut wire = Wire::new(&scene);
/// let display = Display::of(&scene);
/// for (row, pixels) in (0..).zip(picture.pixels.chunks(64)) {
///     let mut colors = display.linear_row(row, pixels);
///     wire.next_row(pixels, &mut colors);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Wire {
    /// Lines, sorted by the row in which they begin.
    lines: Vec<Line>,
    /// The first line that has not begun.
    next: usize,
    /// The numbers of those that have begun and not ended.
    active: Vec<usize>,
    row: u32,
    is_orthographic: bool,
    /// Metres that a pixel is wide: at a depth of 1 m in perspective.
    pixel_m: f64,
    /// The part of each pixel's colour that is the line's.
    parts: Vec<f32>,
}

/// An edge in the picture.
#[derive(Clone, Copy, Debug)]
struct Line {
    /// Ends in pixels from the picture's top-left corner, the upper one first.
    ends: [DVec2; 2],
    /// Values at the ends that are linear along the line: the depth of parallel rays, its inverse
    /// in perspective.
    depths: [f64; 2],
}

/// Points in the picture of a camera.
struct View<'a> {
    camera: &'a Camera,
    size: DVec2,
}

impl View<'_> {
    fn depth(&self, point: DVec3) -> f64 {
        self.camera.forward().dot(point - self.camera.eye())
    }

    /// Returns the line of an edge, clipped to the picture and to depths of at least `least`.
    fn line(&self, ends: [DVec3; 2], least: f64) -> Option<Line> {
        let (ends, depths) = in_front(ends, ends.map(|end| self.depth(end)), least)?;
        let camera = self.camera;
        let scale = self.size.y / (2.0 * camera.half_height());
        let place = |at: usize| {
            let aside = ends[at] - camera.eye();
            let away = if camera.is_orthographic() { 1.0 } else { depths[at] };
            let across = DVec2::new(camera.right().dot(aside), -camera.up().dot(aside));
            0.5 * self.size + across * (scale / away)
        };
        let depths = if camera.is_orthographic() { depths } else { depths.map(f64::recip) };
        let mut line = Line { ends: [place(0), place(1)], depths }.within(self.size)?;
        if line.ends[1].y < line.ends[0].y {
            line.ends.swap(0, 1);
            line.depths.swap(0, 1);
        }
        Some(line)
    }
}

/// Returns the part of an edge at depths of at least `least`, with the depths of its ends.
fn in_front(ends: [DVec3; 2], depths: [f64; 2], least: f64) -> Option<([DVec3; 2], [f64; 2])> {
    if depths[0].max(depths[1]) <= least {
        return None;
    }
    let moved = |at: usize| {
        if depths[at] >= least {
            return (ends[at], depths[at]);
        }
        let part = (least - depths[at]) / (depths[1 - at] - depths[at]);
        (ends[at].lerp(ends[1 - at], part), least)
    };
    let [a, b] = [moved(0), moved(1)];
    Some(([a.0, b.0], [a.1, b.1]))
}

impl Line {
    /// Clips the line to a picture of a size, with a margin (Liang and Barsky 1984, *A new concept
    /// and method for line clipping*).
    fn within(self, size: DVec2) -> Option<Self> {
        let [from, to] = self.ends;
        let along = to - from;
        let (mut first, mut last) = (0.0f64, 1.0f64);
        for axis in 0..2 {
            let [low, high] = [-BESIDE - from[axis], size[axis] + BESIDE - from[axis]];
            if along[axis] == 0.0 {
                if low > 0.0 || high < 0.0 {
                    return None;
                }
                continue;
            }
            let [one, other] = [low / along[axis], high / along[axis]];
            first = first.max(one.min(other));
            last = last.min(one.max(other));
        }
        let line =
            Self { ends: [self.at(first), self.at(last)], depths: [first, last].map(|t| self.depth(t)) };
        let numbers = line.ends.iter().flat_map(DVec2::to_array).chain(line.depths);
        (first <= last && numbers.into_iter().all(f64::is_finite)).then_some(line)
    }

    fn at(&self, part: f64) -> DVec2 {
        self.ends[0].lerp(self.ends[1], part)
    }

    /// Returns the value of [`Self::depths`] at a part of the line.
    fn depth(&self, part: f64) -> f64 {
        self.depths[0] + (self.depths[1] - self.depths[0]) * part
    }

    /// Returns the range of columns in which pixel centres of a row may lie nearer than a pixel to
    /// the line. `y` is the row's middle.
    fn columns(&self, y: f64) -> [f64; 2] {
        let [from, to] = self.ends;
        let fall = to.y - from.y;
        let part = |y: f64| if fall > 0.0 { ((y - from.y) / fall).clamp(0.0, 1.0) } else { 0.0 };
        let (first, last) = (part(y - 1.0), if fall > 0.0 { part(y + 1.0) } else { 1.0 });
        let [a, b] = [self.at(first).x, self.at(last).x];
        [a.min(b) - 1.0, a.max(b) + 1.0]
    }

    /// Returns the point of the line nearest to `point`, as a part of its length, and the distance
    /// in pixels.
    fn nearest(&self, point: DVec2) -> (f64, f64) {
        let along = self.ends[1] - self.ends[0];
        let square = along.length_squared();
        let part = if square > 0.0 { (point - self.ends[0]).dot(along) / square } else { 0.0 };
        let part = part.clamp(0.0, 1.0);
        (part, self.at(part).distance(point))
    }
}

impl Wire {
    /// Collects the edges of all base meshes of a scene, each once.
    pub fn new(scene: &Scene) -> Self {
        let camera = scene.camera();
        let view = View { camera, size: DVec2::from(scene.size().map(f64::from)) };
        let meshes = scene.surfaces().iter().map(|surface| surface.mesh());
        let points = meshes.clone().flat_map(|mesh| mesh.vertices());
        let farthest = points.map(|vertex| view.depth(vertex.position.as_dvec3())).fold(0.0, f64::max);
        let least = farthest * LEAST_DEPTH;
        let mut lines = Vec::new();
        for mesh in meshes {
            let points = mesh.welded();
            let sides = mesh.triangles().iter().flat_map(|[a, b, c]| [[a, b], [b, c], [c, a]]);
            let mut edges: Vec<[u32; 2]> = sides
                .map(|side| side.map(|corner| points[*corner as usize]))
                .map(|[a, b]| [a.min(b), a.max(b)])
                .collect();
            edges.sort_unstable();
            edges.dedup();
            let place = |point: u32| mesh.vertices()[point as usize].position.as_dvec3();
            lines.extend(edges.into_iter().filter_map(|edge| view.line(edge.map(place), least)));
        }
        lines.sort_by(|a, b| a.ends[0].y.total_cmp(&b.ends[0].y));
        Self {
            lines,
            next: 0,
            active: Vec::new(),
            row: 0,
            is_orthographic: camera.is_orthographic(),
            pixel_m: 2.0 * camera.half_height() / view.size.y,
            parts: Vec::new(),
        }
    }

    /// Draws over the next row of the picture, from the top. `pixels` are the row's rendered
    /// pixels, `colors` their linear colours.
    pub fn next_row(&mut self, pixels: &[PixelOut], colors: &mut [[f32; 3]]) {
        let y = f64::from(self.row) + 0.5;
        self.row += 1;
        while self.lines.get(self.next).is_some_and(|line| line.ends[0].y < y + 1.0) {
            self.active.push(self.next);
            self.next += 1;
        }
        self.active.retain(|number| self.lines[*number].ends[1].y > y - 1.0);
        self.parts.clear();
        self.parts.resize(pixels.len(), 0.0);
        for line in self.active.iter().map(|number| &self.lines[*number]) {
            let [first, last] = line.columns(y).map(|x| (x.max(0.0) as usize).min(pixels.len()));
            let last = (last + 1).min(pixels.len());
            for (column, pixel) in (first..last).zip(&pixels[first..last]) {
                let (part, distance) = line.nearest(DVec2::new(column as f64 + 0.5, y));
                if distance < 1.0 {
                    let part = (1.0 - distance) as f32 * self.strength(line.depth(part), pixel);
                    self.parts[column] = self.parts[column].max(part);
                }
            }
        }
        for (color, part) in colors.iter_mut().zip(&self.parts).filter(|(_, part)| **part > 0.0) {
            *color = [0, 1, 2].map(|at| color[at] + (COLOR[at] - color[at]) * part);
        }
    }

    /// Returns the share of a line in a pixel's colour, by whether it lies in front of the pixel's
    /// surface. `depth` is a value of [`Line::depths`].
    fn strength(&self, depth: f64, pixel: &PixelOut) -> f32 {
        if pixel.hit == 0 {
            return SHOWN;
        }
        let (depth, width) = if self.is_orthographic {
            (depth, self.pixel_m)
        } else {
            (depth.recip(), self.pixel_m * depth.recip())
        };
        let behind = (depth - f64::from(pixel.depth)) / (SLACK * width);
        SHOWN + (HIDDEN - SHOWN) * (behind - 1.0).clamp(0.0, 1.0) as f32
    }
}
