//! Figures 6, 7 and 16 of Gumhold and Hüttner 1999 by what the mesher and the filters do, as one SVG.

use std::fmt::Write as _;

use glam::DVec3;
use relief_bake::{Filter, filter_level};
use relief_core::camera::Camera;
use relief_core::{HeightMap, Watch};
use relief_mesh::{GridSpace, View};

use crate::surfaces::bases::cobbles;

/// Width and height of a plot.
const SIZE: [f64; 2] = [420.0, 300.0];

/// What Figure 7 looks at: the depths of the near and the far plane, and the pixels of a side of the picture.
const NEAR_M: f64 = 1.0;
const FAR_M: f64 = 100.0;
const PIXELS: u32 = 300;

/// Colours of lines, one after the other.
const COLORS: [&str; 4] = ["#444", "#d62728", "#1f77b4", "#2ca02c"];

/// Lines over a rectangle, each with a name.
struct Plot<'a> {
    title: &'a str,
    /// From where to where along both axes.
    range: [[f64; 2]; 2],
    lines: Vec<(String, Vec<[f64; 2]>)>,
}

impl Plot<'_> {
    /// Draws it with its upper left corner there.
    fn draw(&self, [left, top]: [f64; 2], svg: &mut String) {
        let [width, height] = SIZE.map(|side| side - 60.0);
        let place = |[x, y]: [f64; 2]| {
            let part = |axis: usize, at: f64| {
                let [from, to] = self.range[axis];
                (at - from) / (to - from)
            };
            [left + 45.0 + width * part(0, x), top + 30.0 + height * (1.0 - part(1, y))]
        };
        let [[x0, x1], [y0, y1]] = self.range;
        let corners = [[x0, y0], [x1, y1]].map(place);
        // What is written to a string does not fail.
        let _ = write!(
            svg,
            "<rect x='{}' y='{}' width='{width}' height='{height}' fill='none' stroke='#999'/>\n\
             <text x='{}' y='{}'>{}</text>\n",
            left + 45.0,
            top + 30.0,
            left + 45.0,
            top + 20.0,
            self.title
        );
        for (at, [x, y], anchor) in [
            (x0, [corners[0][0], corners[0][1] + 14.0], "start"),
            (x1, [corners[1][0], corners[0][1] + 14.0], "end"),
            (y0, [corners[0][0] - 4.0, corners[0][1]], "end"),
            (y1, [corners[0][0] - 4.0, corners[1][1] + 10.0], "end"),
        ] {
            let _ = writeln!(svg, "<text x='{x}' y='{y}' text-anchor='{anchor}'>{at}</text>");
        }
        let mut names: Vec<&str> = Vec::new();
        for (name, points) in &self.lines {
            let known = names.iter().position(|known| known == name);
            let number = known.unwrap_or(names.len());
            let color = COLORS[number % COLORS.len()];
            if known.is_none() {
                names.push(name);
                let y = top + 46.0 + 14.0 * number as f64;
                let x = left + 45.0 + width - 6.0;
                let _ = writeln!(svg, "<text x='{x}' y='{y}' text-anchor='end' fill='{color}'>{name}</text>");
            }
            let points: Vec<String> =
                points.iter().map(|&point| place(point).map(|at| format!("{at:.2}")).join(",")).collect();
            let _ = writeln!(svg, "<polyline points='{}' fill='none' stroke='{color}'/>", points.join(" "));
        }
    }
}

/// Grid space of a picture of the given pixels. Its sides are as far apart as they are away.
fn grid(pixels: u32) -> Result<GridSpace, String> {
    let camera = Camera::new(DVec3::ZERO, DVec3::NEG_Z, 90.0).map_err(|error| error.to_string())?;
    let view = View { near_m: NEAR_M, ..View::new(camera, [pixels, pixels]) };
    view.grid_space().map_err(|error| error.to_string())
}

/// The slices of grid space between the planes, and the sides of its columns: what lies between is as deep as
/// it is wide.
fn voxels() -> Result<Plot<'static>, String> {
    let grid = grid(12)?;
    let far_m = 6.0;
    let slice = |number: f64| grid.near_m * (number / grid.per_doubling).exp2();
    let mut lines = Vec::new();
    let slices = (far_m / grid.near_m).log2() * grid.per_doubling;
    for number in 0..=slices as u32 {
        let depth = slice(number.into());
        lines.push((String::new(), vec![[-depth, depth], [depth, depth]]));
    }
    for column in 0..=12 {
        let across = (f64::from(column) - grid.middle[0]) / grid.per_m;
        lines.push((String::new(), vec![[across * grid.near_m, grid.near_m], [across * far_m, far_m]]));
    }
    Ok(Plot { title: "6: pixels, extended in view direction", range: [[-6.0, 6.0], [0.0, 6.0]], lines })
}

/// Depths between the planes.
fn depths() -> impl Iterator<Item = f64> {
    (0..=200).map(|step| NEAR_M + (FAR_M - NEAR_M) * f64::from(step) / 200.0)
}

/// The depth as screens have it, scaled to as much as a picture has pixels.
fn on_screen(depth: f64) -> f64 {
    f64::from(PIXELS) * FAR_M * (depth - NEAR_M) / (depth * (FAR_M - NEAR_M))
}

/// How much wider than deep voxels are, by tenfolds.
fn shapes() -> Result<Plot<'static>, String> {
    let grid = grid(PIXELS)?;
    let in_grid = |depth: f64| (depth / grid.near_m).log2() * grid.per_doubling;
    let ratio = |of: &dyn Fn(f64) -> f64, depth: f64| {
        let step = 1e-4 * depth;
        let deep = 2.0 * step / (of(depth + step) - of(depth - step));
        (depth / grid.per_m / deep).log10()
    };
    let line = |name: &str, of: &dyn Fn(f64) -> f64| {
        (name.to_owned(), depths().map(|depth| [depth, ratio(of, depth)]).collect())
    };
    let lines = vec![line("screen space", &on_screen), line("grid space", &in_grid)];
    Ok(Plot { title: "7 a: log10 of width over depth of a voxel", range: [[0.0, FAR_M], [-2.0, 2.0]], lines })
}

/// Depths in grid space and on a screen.
fn mapped() -> Result<Plot<'static>, String> {
    let grid = grid(PIXELS)?;
    let last = (FAR_M / grid.near_m).log2() * grid.per_doubling;
    let in_grid = depths().map(|depth| [depth, (depth / grid.near_m).log2() * grid.per_doubling / last]);
    let screen = depths().map(|depth| [depth, on_screen(depth) / on_screen(FAR_M)]);
    let lines = vec![
        ("screen space".to_owned(), screen.collect()),
        (format!("grid space, of {last:.0}"), in_grid.collect()),
    ];
    Ok(Plot { title: "7 b: depths, as parts of the last", range: [[0.0, FAR_M], [0.0, 1.0]], lines })
}

/// A row of cobbles, and what coarser levels are there.
fn simplified() -> Result<Plot<'static>, String> {
    let map = cobbles()?;
    let row = f64::from(map.height()) * 0.37;
    let of = |level: &HeightMap| -> Vec<[f64; 2]> {
        let texels = |at: f64| at / f64::from(map.width()) * f64::from(level.width());
        let down = row / f64::from(map.height()) * f64::from(level.height());
        (0..=480)
            .map(|step| f64::from(step) / 5.0)
            .map(|at| [at, level.height_at_place(texels(at), down)])
            .collect()
    };
    let mut lines = vec![("texels".to_owned(), of(&map))];
    for filter in [Filter::Average, Filter::Variational, Filter::Max] {
        let level = filter_level(&map, 3, filter, &Watch::none()).map_err(|error| error.to_string())?;
        lines.push((filter.name().to_owned(), of(&level)));
    }
    Ok(Plot { title: "16: every eighth texel", range: [[0.0, 96.0], [0.0, 1.2]], lines })
}

/// The plots, two beside two.
pub fn svg() -> Result<String, String> {
    let [width, height] = SIZE;
    let mut svg = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {} {}' \
         font-family='sans-serif' font-size='11'>\n\
         <rect width='100%' height='100%' fill='white'/>\n",
        2.0 * width,
        2.0 * height
    );
    let plots = [voxels()?, shapes()?, mapped()?, simplified()?];
    for (at, plot) in plots.iter().enumerate() {
        plot.draw([width * (at % 2) as f64, height * (at / 2) as f64], &mut svg);
    }
    Ok(svg + "</svg>\n")
}
