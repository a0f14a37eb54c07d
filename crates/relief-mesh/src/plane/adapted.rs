//! Planes in tiles that are filled with as few triangles as a tolerance allows.

use std::sync::atomic::{AtomicU64, Ordering};

use glam::Vec3;
use rayon::prelude::*;
use relief_core::Watch;
use relief_core::mesh::Vertex;

use super::span::{Span, TILE, spans};
use super::{BorderPoint, Rectangle};
use crate::edge::{Along, Knot, LONGEST, divided};
use crate::error::MOST;
use crate::filling::{FillBudget, Filling, least_tolerance};
use crate::interior::{Distances, Filled, Gap, STEPS, Window};
use crate::surface::{Relief, twist_of};
use crate::{Certificate, Judge, MeshSettings, MesherError};

/// Bytes of a tile of two triangles, with its sides.
const BYTES_PER_TILE: u64 = 400;

/// Rectangle in filled tiles.
#[derive(Debug)]
pub struct Adapted {
    rectangle: Rectangle,
    spans: [Vec<Span>; 2],
    /// Points along the sides, without corners of tiles: the sides across `u` row by row, then the
    /// sides across `v`.
    sides: Vec<Vec<(i32, f32)>>,
    /// Number of the first vertex of each side, and the end of the last side.
    first_of_side: Vec<u32>,
    tiles: Vec<Filled>,
    /// Amount by which all heights are raised.
    raise: f64,
    /// Number of the first vertex within each tile, and the end of the last tile.
    first_of_tile: Vec<u32>,
    certificate: Certificate,
}

impl Adapted {
    /// Fills the tiles of a rectangle.
    pub fn new(
        rectangle: Rectangle,
        relief: &Relief,
        settings: &MeshSettings,
        filling: Filling,
        watch: &Watch,
    ) -> Result<Self, MesherError> {
        let Filling { fill, side: divide, .. } = filling;
        let range = rectangle.range(relief, settings.part)?;
        check_tiles(range, settings.max_bytes)?;
        let spans = range.map(|[from, to]| spans(from, to));
        // Height 1 of the map in metres.
        let metres = relief.map().scale_m() * relief.reach(rectangle.reach());
        let tolerance = relief.tolerance(settings.error_m, rectangle.reach());
        let part = settings.side.part();
        let tolerance = part * tolerance;
        let least = least_tolerance(relief, settings.judge);
        if tolerance < least {
            let (error_m, least_m) = (settings.error_m, least * metres / part);
            return Err(MesherError::TooFine { error_m, least_m });
        }
        let mut adapted = Self {
            rectangle,
            spans,
            sides: Vec::new(),
            first_of_side: Vec::new(),
            tiles: Vec::new(),
            raise: settings.side.sign() * tolerance,
            first_of_tile: Vec::new(),
            certificate: Certificate::exact(settings.judge),
        };
        let [across, down] = adapted.across();
        let sides = 0..2 * across * down + across + down;
        adapted.sides =
            sides.into_par_iter().map(|side| adapted.side(relief, side, divide, tolerance)).collect();
        let mut vertices = ((across + 1) * (down + 1)) as u64;
        for side in &adapted.sides {
            adapted.first_of_side.push(numbered(vertices, 0)?);
            vertices += side.len() as u64;
        }
        adapted.first_of_side.push(numbered(vertices, 0)?);
        let done = AtomicU64::new(0);
        let budget = FillBudget::new(settings, filling.most, *watch);
        let tiles: Result<Vec<Filled>, MesherError> = (0..across * down)
            .into_par_iter()
            .map(|tile| {
                watch.check()?;
                let request = budget.request(tolerance);
                let filled =
                    (fill.tile)(&adapted.window(relief, tile), &adapted.border(relief, tile), request);
                let filled = budget.admit(filled)?;
                watch.at((done.fetch_add(1, Ordering::Relaxed) + 1) as f32 / (across * down) as f32)?;
                Ok(filled)
            })
            .collect();
        adapted.tiles = tiles?;
        let triangles = budget.triangles();
        for tile in 0..across * down {
            adapted.first_of_tile.push(numbered(vertices, triangles)?);
            vertices += (adapted.tiles[tile].points.len() - adapted.border_count(tile)) as u64;
        }
        adapted.first_of_tile.push(numbered(vertices, triangles)?);
        adapted.certify(relief, metres);
        adapted.certificate.check(settings.error_m)?;
        Ok(adapted)
    }

    /// Collects the errors of the tiles.
    fn certify(&mut self, relief: &Relief, metres: f64) {
        // Returns the greatest distance of the relief from the raised triangles, and its place.
        let farthest = |distances: &Distances| -> Gap {
            let [above, below] =
                [distances.above, distances.below].map(|gap| (gap.height - self.raise, gap.place));
            let (height, place) = if above.0.abs() >= below.0.abs() { above } else { below };
            Gap { height, place }
        };
        let gap = |tile: usize| farthest(&self.tiles[tile].distances).height.abs();
        let all = 0..self.tiles.len();
        let Some(worst) = all.reduce(|worst, tile| if gap(tile) > gap(worst) { tile } else { worst }) else {
            return;
        };
        let Gap { height, place } = farthest(&self.tiles[worst].distances);
        let (spans, sides) = (self.spans_of(worst), relief.sides());
        let uv = [0, 1].map(|axis| {
            let span: Span = spans[axis];
            // Between two steps. The ends of a span may have places of their own.
            let step = place[axis].floor();
            let [here, next] = [step, step + 1.0].map(|step| span.place(step as i32));
            let part = place[axis] - step;
            (if part == 0.0 { here } else { here + (next - here) * part }) / sides[axis]
        });
        let distances =
            self.tiles.iter().fold(Distances::NOTHING, |distances, tile| distances.with(&tile.distances));
        let count = distances.count.max(1) as f64;
        // On one side all distances have the same sign.
        let mean = if self.raise == 0.0 {
            distances.sum / count
        } else {
            (self.raise - distances.signed / count).abs()
        };
        let judge = self.certificate.judge;
        let error_m = height.abs() * metres;
        self.certificate = Certificate { error_m, uv, mean_m: metres * mean, ..Certificate::exact(judge) };
    }

    /// Returns the certificate.
    pub fn certificate(&self) -> &Certificate {
        &self.certificate
    }

    /// Returns the number of vertices at corners of tiles.
    pub fn corner_count(&self) -> u32 {
        let [across, down] = self.across();
        ((across + 1) * (down + 1)) as u32
    }

    /// Returns the number of sides of tiles.
    pub fn side_count(&self) -> u32 {
        self.sides.len() as u32
    }

    /// Returns the number of vertices along a side, without its ends.
    pub fn points_of_side(&self, side: u32) -> u32 {
        self.sides[side as usize].len() as u32
    }

    /// Returns the number of tiles.
    pub fn tile_count(&self) -> u32 {
        self.tiles.len() as u32
    }

    /// Returns the numbers of vertices within a tile, and of its triangles.
    pub fn counts(&self, tile: u32) -> [u32; 2] {
        let [first, last] = [0, 1].map(|more| self.first_of_tile[tile as usize + more]);
        [last - first, self.tiles[tile as usize].triangles.len() as u32]
    }

    /// Returns the number of vertices of all tiles.
    pub fn vertices(&self) -> u64 {
        u64::from(self.first_of_tile[self.tiles.len()])
    }

    /// Returns the number of bytes in use.
    pub fn bytes(&self) -> u64 {
        let of_tile = |tile: &Filled| {
            size_of_val(&tile.points[..]) + size_of_val(&tile.heights[..]) + size_of_val(&tile.triangles[..])
        };
        let of_side = |side: &Vec<(i32, f32)>| size_of_val(&side[..]);
        (self.tiles.iter().map(of_tile).sum::<usize>() + self.sides.iter().map(of_side).sum::<usize>()) as u64
    }

    pub fn is_turned(&self) -> bool {
        self.rectangle.is_turned
    }

    /// Returns the rectangle.
    pub fn rectangle(&self) -> &Rectangle {
        &self.rectangle
    }

    /// Returns the border, in the order of [`Solid`](super::Solid).
    pub fn walls(&self, relief: &Relief) -> [Vec<BorderPoint>; 4] {
        let [across, down] = self.across();
        let corner = |i: usize, j: usize| {
            let number = j * (across + 1) + i;
            let (place, height) = self.corner(relief, number);
            (place, f64::from(height) + self.raise, number as u32)
        };
        // The corners and the points between them, as places grow.
        let level = |j: usize| -> Vec<BorderPoint> {
            let side = |i: usize| [corner(i, j)].into_iter().chain(self.points_on(j * across + i));
            (0..across).flat_map(side).chain([corner(across, j)]).collect()
        };
        let upright = |i: usize| -> Vec<BorderPoint> {
            let first = across * (down + 1) + i;
            let side = |j: usize| [corner(i, j)].into_iter().chain(self.points_on(first + j * (across + 1)));
            (0..down).flat_map(side).chain([corner(i, down)]).collect()
        };
        let back = |mut wall: Vec<BorderPoint>| {
            wall.reverse();
            wall
        };
        [level(0), upright(across), back(level(down)), back(upright(0))]
    }

    /// Returns the points of a side, without its ends.
    fn points_on(&self, side: usize) -> impl Iterator<Item = BorderPoint> {
        (self.first_of_side[side]..).zip(&self.sides[side]).map(move |(number, &(step, height))| {
            (self.place_on(side, step), f64::from(height) + self.raise, number)
        })
    }

    /// Returns the vertex at a corner of tiles.
    pub fn corner_vertex(&self, relief: &Relief, number: u32) -> Vertex {
        let (place, height) = self.corner(relief, number as usize);
        self.rectangle.vertex_at(relief, place, f64::from(height) + self.raise)
    }

    /// Returns a vertex along a side.
    pub fn side_vertex(&self, relief: &Relief, side: u32, at: u32) -> Vertex {
        let (step, height) = self.sides[side as usize][at as usize];
        self.rectangle.vertex_at(relief, self.place_on(side as usize, step), f64::from(height) + self.raise)
    }

    /// Returns the place of a point of a tile in texels: `i + ½` is the centre of texel `i`. The
    /// points of the border come first.
    pub fn place(&self, tile: u32, at: u32) -> [f64; 2] {
        let steps = self.tiles[tile as usize].points[at as usize].map(i32::from);
        let spans = self.spans_of(tile as usize);
        [0, 1].map(|axis| spans[axis].place(steps[axis]))
    }

    /// Returns a vertex within a tile.
    pub fn inner_vertex(&self, relief: &Relief, tile: u32, at: u32) -> Vertex {
        let at = self.border_count(tile as usize) as u32 + at;
        let height = self.tiles[tile as usize].heights[at as usize];
        self.rectangle.vertex_at(relief, self.place(tile, at), f64::from(height) + self.raise)
    }

    /// Returns the border of a tile, in the order of its points: numbers and positions.
    pub fn border_points(&self, relief: &Relief, tile: u32) -> Vec<(u32, Vec3)> {
        let tile = tile as usize;
        let mut all = Vec::with_capacity(self.border_count(tile));
        for corner in self.corners_of(tile) {
            let (place, height) = self.corner(relief, corner);
            all.push((corner as u32, self.rectangle.position(relief, place, f64::from(height) + self.raise)));
        }
        for side in self.sides_of(tile) {
            for (number, &(step, height)) in (self.first_of_side[side]..).zip(&self.sides[side]) {
                let place = self.place_on(side, step);
                all.push((number, self.rectangle.position(relief, place, f64::from(height) + self.raise)));
            }
        }
        all
    }

    /// Returns the number of the first vertex along a side.
    pub fn first_of_side(&self, side: u32) -> u32 {
        self.first_of_side[side as usize]
    }

    /// Returns the number of the first vertex within a tile.
    pub fn first_of_tile(&self, tile: u32) -> u32 {
        self.first_of_tile[tile as usize]
    }

    /// Returns the triangles of a tile by its points: first the border's points, then its own.
    pub fn triangles(&self, tile: u32) -> &[[u32; 3]] {
        &self.tiles[tile as usize].triangles
    }

    /// Returns the number of tiles along `u` and `v`.
    fn across(&self) -> [usize; 2] {
        self.spans.each_ref().map(Vec::len)
    }

    fn spans_of(&self, tile: usize) -> [Span; 2] {
        let across = self.across()[0];
        [self.spans[0][tile % across], self.spans[1][tile / across]]
    }

    /// Returns the place of line `number` across an axis.
    fn line(&self, axis: usize, number: usize) -> f64 {
        let spans = &self.spans[axis];
        spans.get(number).map_or_else(|| spans[number - 1].ends[1], |span| span.ends[0])
    }

    /// Returns place and height of a corner of tiles.
    fn corner(&self, relief: &Relief, number: usize) -> ([f64; 2], f32) {
        let corners = self.across()[0] + 1;
        let place = [self.line(0, number % corners), self.line(1, number / corners)];
        (place, relief.height(place) as f32)
    }

    /// Returns the corners of a tile, by rows.
    fn corners_of(&self, tile: usize) -> [usize; 4] {
        let across = self.across()[0];
        let first = tile / across * (across + 1) + tile % across;
        [first, first + 1, first + across + 1, first + across + 2]
    }

    /// Returns the sides of a tile: where `v` is least and greatest, then where `u` is.
    fn sides_of(&self, tile: usize) -> [usize; 4] {
        let [across, down] = self.across();
        let (i, j) = (tile % across, tile / across);
        let upright = across * (down + 1) + j * (across + 1) + i;
        [tile, tile + across, upright, upright + 1]
    }

    /// Returns the axis that a side runs along, its span, and the place of its line across the
    /// other axis.
    fn along(&self, side: usize) -> (usize, Span, f64) {
        let [across, down] = self.across();
        let level = across * (down + 1);
        if side < level {
            (0, self.spans[0][side % across], self.line(1, side / across))
        } else {
            let (i, j) = ((side - level) % (across + 1), (side - level) / (across + 1));
            (1, self.spans[1][j], self.line(0, i))
        }
    }

    fn place_on(&self, side: usize, step: i32) -> [f64; 2] {
        let (axis, span, line) = self.along(side);
        if axis == 0 { [span.place(step), line] } else { [line, span.place(step)] }
    }

    /// Returns the points of a side, without its ends.
    fn side(&self, relief: &Relief, side: usize, divide: Along, tolerance: f64) -> Vec<(i32, f32)> {
        let (axis, span, line) = self.along(side);
        let [first, last] = span.steps;
        let twist_after = |step: i32| -> f64 {
            // In the cells beside the line: two, if it runs between cells.
            let along = (span.place(step) + span.place(step + 1)) / 2.0;
            let twist = |beside: f64| {
                let place = if axis == 0 { [along, beside] } else { [beside, along] };
                twist_at(relief, place)
            };
            twist(line - 1e-3).max(twist(line + 1e-3))
        };
        let mut steps = Vec::new();
        let mut step = first;
        while step < last {
            let next = ((step / STEPS + 1) * STEPS).min(last);
            let twist = if self.certificate.judge == Judge::Surface { twist_after(step) } else { 0.0 };
            // As finely as a chord beside this twist may need.
            let pieces = (twist / (LONGEST * tolerance)).ceil().clamp(1.0, f64::from(STEPS)) as u32;
            let every = STEPS / pieces.next_power_of_two() as i32;
            let mut at = step;
            while at < next {
                steps.push((at, twist));
                at = (at / every + 1) * every;
            }
            step = next;
        }
        steps.push((last, 0.0));
        let knot = |&(step, twist): &(i32, f64)| {
            let place = self.place_on(side, step);
            // Rounded as it is stored.
            let height = f64::from(relief.height(place) as f32);
            Knot { place: span.place(step), height, twist }
        };
        let knots: Vec<Knot> = steps.iter().map(knot).collect();
        let is_hole = |step: i32| {
            let along = (span.place(step) + span.place(step + 1)) / 2.0;
            [line - 1e-3, line + 1e-3].map(|beside| {
                let [x, y] = if axis == 0 { [along, beside] } else { [beside, along] };
                relief.is_hole([x - 0.5, y - 0.5])
            })
        };
        let ends_a_hole = |&at: &usize| is_hole(steps[at - 1].0) != is_hole(steps[at].0);
        let fixed: Vec<usize> =
            if relief.has_holes() { (1..steps.len() - 1).filter(ends_a_hole).collect() } else { Vec::new() };
        let chosen = divided(divide, &[&knots], &fixed, tolerance);
        let inner = &chosen[1..chosen.len() - 1];
        inner.iter().map(|&at| (steps[at].0, knots[at].height as f32)).collect()
    }

    fn border_count(&self, tile: usize) -> usize {
        4 + self.sides_of(tile).map(|side| self.sides[side].len()).iter().sum::<usize>()
    }

    /// Returns the border of a tile: its corners, by rows, and the points along its sides.
    fn border(&self, relief: &Relief, tile: usize) -> Vec<([i32; 2], f32)> {
        let [across, down] = self.spans_of(tile).map(|span| span.steps);
        let corners = self.corners_of(tile).map(|corner| self.corner(relief, corner).1);
        let places = [[across[0], down[0]], [across[1], down[0]], [across[0], down[1]], [across[1], down[1]]];
        let mut border: Vec<([i32; 2], f32)> = places.into_iter().zip(corners).collect();
        for (k, side) in self.sides_of(tile).into_iter().enumerate() {
            let line = if k < 2 { down[k] } else { across[k - 2] };
            let point = |step: i32| if k < 2 { [step, line] } else { [line, step] };
            border.extend(self.sides[side].iter().map(|&(step, height)| (point(step), height)));
        }
        border
    }

    /// Returns the heights of a tile.
    fn window(&self, relief: &Relief, tile: usize) -> Window {
        let spans = self.spans_of(tile);
        let [from, to] = [0, 1].map(|end| spans.map(|span| span.steps[end]));
        if let [Some(i0), Some(j0)] = spans.map(|span| span.first_texel()) {
            let map = relief.map();
            let window = Window::new(from, to, |[i, j]| map.texel(i0 + i as i64, j0 + j as i64));
            return if relief.has_holes() {
                window.with_holes(|[i, j]| map.is_hole(i0 + i as i64, j0 + j as i64))
            } else {
                window
            };
        }
        let place = |axis: usize, corner: usize| {
            let (span, step) = (&spans[axis], corner as i32 * STEPS);
            // Places beyond the ends have texels, too.
            if span.steps.contains(&step) {
                span.place(step)
            } else {
                span.origin + f64::from(step) * span.step
            }
        };
        let window = Window::new(from, to, |[i, j]| relief.height([place(0, i), place(1, j)]) as f32);
        if !relief.has_holes() {
            return window;
        }
        let middle = |axis: usize, cell: usize| (place(axis, cell) + place(axis, cell + 1)) / 2.0 - 0.5;
        window.with_holes(|[i, j]| relief.is_hole([middle(0, i), middle(1, j)]))
    }
}

/// Returns an error if these texels have too many tiles, before memory is taken for them.
fn check_tiles(range: [[f64; 2]; 2], max_bytes: u64) -> Result<(), MesherError> {
    let tiles = range.map(|[from, to]| (from - to).abs() / TILE + 1.0);
    let count = (tiles[0] * tiles[1]) as u64;
    if count > MOST / 2 {
        return Err(MesherError::TooLarge { vertices: count, triangles: count.saturating_mul(2) });
    }
    if count.saturating_mul(BYTES_PER_TILE) > max_bytes {
        return Err(MesherError::NoMemory { limit: max_bytes });
    }
    Ok(())
}

/// Returns the number of vertices as `u32`, or an error if there are too many.
fn numbered(vertices: u64, triangles: u64) -> Result<u32, MesherError> {
    if vertices.max(triangles) > MOST {
        return Err(MesherError::TooLarge { vertices, triangles });
    }
    Ok(vertices as u32)
}

/// Returns the twist of the cell at a place.
fn twist_at(relief: &Relief, [x, y]: [f64; 2]) -> f64 {
    twist_of(relief.map().cell((x - 0.5).floor() as i64, (y - 0.5).floor() as i64))
}
