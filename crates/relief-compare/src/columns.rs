//! Columns of tables: one list for the page and for comma-separated values.

use crate::record::{CostRecord, ErrorRecord, MethodRecord, PictureRecord, RayRecord, Records, TimeRecord};

/// Row of a table.
#[derive(Clone, Copy, Debug)]
pub enum Row<'a> {
    /// A method along rays at an angle.
    Rays(&'a RayRecord),
    /// A method in a picture.
    Picture(&'a PictureRecord),
}

/// Content of a cell.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// Empty: the record has no such figure.
    Empty,
    /// A word.
    Text(String),
    /// A number.
    Number(f64),
}

/// Column of a table.
#[derive(Clone, Copy, Debug)]
pub struct Column {
    /// Name for programs, equal to the record's field.
    pub key: &'static str,
    /// Title for people.
    pub title: &'static str,
    /// Explanation in one line.
    pub summary: &'static str,
    /// Factor on the numbers for people, such as 100 for shares that are shown in percent.
    pub factor: f64,
    /// Number of digits after the decimal point for people.
    pub digits: usize,
    /// Function that returns the cell of a row.
    pub cell: fn(&Row) -> Cell,
}

impl<'a> Row<'a> {
    /// Returns all rows of some records.
    pub fn all(records: &'a Records) -> impl Iterator<Item = Row<'a>> {
        records.rays.iter().map(Row::Rays).chain(records.pictures.iter().map(Row::Picture))
    }

    /// Returns the method.
    pub fn method(&self) -> &'a MethodRecord {
        match self {
            Row::Rays(RayRecord { method, .. }) | Row::Picture(PictureRecord { method, .. }) => method,
        }
    }

    /// Returns the errors of its hits, if they were judged.
    pub fn error(&self) -> Option<&'a ErrorRecord> {
        match self {
            Row::Rays(record) => Some(&record.error),
            Row::Picture(record) => record.error.as_ref(),
        }
    }

    /// Returns the cost of its hits, if it was counted.
    pub fn cost(&self) -> Option<&'a CostRecord> {
        match self {
            Row::Rays(record) => Some(&record.cost),
            Row::Picture(record) => record.cost.as_ref(),
        }
    }

    fn rays(&self) -> Option<&'a RayRecord> {
        if let Row::Rays(record) = self { Some(record) } else { None }
    }

    fn picture(&self) -> Option<&'a PictureRecord> {
        if let Row::Picture(record) = self { Some(record) } else { None }
    }
}

fn text(text: impl ToString) -> Cell {
    Cell::Text(text.to_string())
}

fn number(number: Option<f64>) -> Cell {
    number.map_or(Cell::Empty, Cell::Number)
}

fn error(row: &Row, of: fn(&ErrorRecord) -> f64) -> Cell {
    number(row.error().map(of))
}

fn cost(row: &Row, of: fn(&CostRecord) -> f64) -> Cell {
    number(row.cost().map(of))
}

fn times<'a>(row: &Row<'a>) -> Option<&'a TimeRecord> {
    row.picture().and_then(|record| record.times.as_ref())
}

fn time(row: &Row, of: fn(&TimeRecord) -> Option<f64>) -> Cell {
    number(times(row).and_then(of))
}

fn picture(row: &Row, of: fn(&PictureRecord) -> Option<f64>) -> Cell {
    number(row.picture().and_then(of))
}

fn size([columns, rows]: [u32; 2]) -> Cell {
    text(format_args!("{columns}x{rows}"))
}

const fn word(
    key: &'static str,
    title: &'static str,
    summary: &'static str,
    cell: fn(&Row) -> Cell,
) -> Column {
    figure(key, title, summary, 0, cell)
}

const fn figure(
    key: &'static str,
    title: &'static str,
    summary: &'static str,
    digits: usize,
    cell: fn(&Row) -> Cell,
) -> Column {
    Column { key, title, summary, factor: 1.0, digits, cell }
}

const fn share(
    key: &'static str,
    title: &'static str,
    summary: &'static str,
    cell: fn(&Row) -> Cell,
) -> Column {
    Column { factor: 100.0, ..figure(key, title, summary, 3, cell) }
}

/// All columns.
pub static COLUMNS: &[Column] = &[
    word("kind", "kind", "rays at an angle, or the pixels of a picture", |row| {
        text(if row.rays().is_some() { "rays" } else { "picture" })
    }),
    word("method", "method", "name of the displacement method", |row| text(&row.method().method)),
    figure("steps", "steps", "greatest number of steps", 0, |row| number(row.method().steps.map(f64::from))),
    word("steps_key", "steps parameter", "the method's parameter for the number of steps", |row| {
        row.method().steps_key.as_ref().map_or(Cell::Empty, text)
    }),
    word("geometry", "geometry", "triangles that are drawn: the base mesh, or displaced triangles", |row| {
        text(&row.method().geometry)
    }),
    word("search", "search", "stage that brackets the first hit", |row| text(&row.method().search)),
    word("refine", "refinement", "stage that refines the bracket to a hit", |row| text(&row.method().refine)),
    word("promise", "promise", "guarantee for view rays", |row| text(&row.method().promise)),
    word("map_format", "map format", "number format of the method's baked maps", |row| {
        row.method().map_format.as_ref().map_or(Cell::Empty, text)
    }),
    word("shadow", "shadow", "method of computing shadows", |row| {
        row.method().shadow.as_ref().map_or(Cell::Empty, text)
    }),
    word("map_size", "map", "columns and rows of the height map", |row| size(row.method().map_size)),
    figure("map_texels", "map texels", "texels of the height maps", 0, |row| {
        Cell::Number(row.method().map_texels as f64)
    }),
    figure("scale_m", "scale m", "metres between heights 0 and 1", 3, |row| {
        Cell::Number(row.method().scale_m)
    }),
    figure("angle_deg", "angle °", "degrees between ray and normal", 0, |row| {
        number(row.rays().map(|record| record.angle_deg))
    }),
    word("backend", "backend", "processor that made the picture: cpu or gpu", |row| {
        row.picture().map_or(Cell::Empty, |record| text(&record.backend))
    }),
    word("sampling", "sampling", "method of reading textures: exact or fast", |row| {
        row.picture().map_or(Cell::Empty, |record| text(&record.sampling))
    }),
    word("size", "picture", "columns and rows of the picture", |row| {
        row.picture().map_or(Cell::Empty, |record| size(record.size))
    }),
    figure("samples", "samples", "samples per pixel", 0, |row| {
        picture(row, |record| Some(record.samples.into()))
    }),
    figure("distance_m", "distance m", "metres between the camera and its target", 2, |row| {
        picture(row, |record| record.distance_m)
    }),
    figure("rays", "rays", "number of rays that were compared", 0, |row| {
        error(row, |error| error.rays as f64)
    }),
    share(
        "passed",
        "went through %",
        "share of rays that went through the true hit: missed or late",
        |row| error(row, |error| error.passed),
    ),
    share("missed", "missed %", "share of rays that should hit, but were reported as misses", |row| {
        error(row, |error| error.missed)
    }),
    share("false_hits", "false hits %", "share of rays that should miss, but were reported as hits", |row| {
        error(row, |error| error.false_hits)
    }),
    share("late", "late %", "share of hits more than half a texel behind the true one", |row| {
        error(row, |error| error.late)
    }),
    share("early", "early %", "share of hits more than half a texel before the true one", |row| {
        error(row, |error| error.early)
    }),
    share("exhausted", "exhausted %", "share of rays that ran out of steps", |row| {
        error(row, |error| error.exhausted)
    }),
    figure("mean_texels", "mean texels", "mean distance from the true hit, in texels", 4, |row| {
        error(row, |error| error.mean_texels)
    }),
    figure("median_texels", "median texels", "median distance from the true hit, in texels", 4, |row| {
        error(row, |error| error.median_texels)
    }),
    figure(
        "p99_texels",
        "p99 texels",
        "distance from the true hit, in texels, that 99 of 100 rays do not exceed",
        3,
        |row| error(row, |error| error.p99_texels),
    ),
    figure("max_texels", "max texels", "greatest distance from the true hit, in texels", 2, |row| {
        error(row, |error| error.max_texels)
    }),
    figure(
        "p99_depth_m",
        "p99 depth m",
        "difference of depth, in metres, that 99 of 100 rays do not exceed",
        4,
        |row| error(row, |error| error.p99_depth_m),
    ),
    figure("reads", "reads", "mean number of texture reads per ray", 1, |row| cost(row, |cost| cost.reads)),
    figure("p99_reads", "p99 reads", "texture reads that 99 of 100 rays do not exceed", 0, |row| {
        cost(row, |cost| cost.p99_reads)
    }),
    figure(
        "wave_reads",
        "wave reads",
        "mean over tiles of 8 x 4 pixels of the most reads in a tile",
        1,
        |row| picture(row, |record| record.wave_reads),
    ),
    figure("turns", "loop steps", "mean number of steps of search and refinement per ray", 1, |row| {
        cost(row, |cost| cost.turns)
    }),
    figure("bytes", "bytes", "mean number of bytes that a ray's reads fetch", 0, |row| {
        cost(row, |cost| cost.bytes)
    }),
    figure("flip", "FLIP", "mean FLIP difference from the reference: 0 is equal, 1 the greatest", 4, |row| {
        picture(row, |record| Some(record.flip))
    }),
    figure("ssim", "SSIM", "structural similarity to the reference: 1 is equal", 4, |row| {
        picture(row, |record| Some(record.ssim))
    }),
    figure(
        "psnr_db",
        "PSNR dB",
        "peak signal-to-noise ratio in decibels; empty if the pictures are equal",
        1,
        |row| picture(row, |record| record.psnr_db),
    ),
    figure("rms", "RMS", "root mean square error of linear colours", 4, |row| {
        picture(row, |record| Some(record.rms))
    }),
    figure(
        "flicker_rms",
        "flicker RMS",
        "RMS between two frames a tenth of a pixel apart, less the reference's",
        4,
        |row| picture(row, |record| record.flicker_rms),
    ),
    figure(
        "flicker_flip",
        "flicker FLIP",
        "FLIP between the same two frames, less the reference's",
        4,
        |row| picture(row, |record| record.flicker_flip),
    ),
    word("clock", "clock", "clock that timed the frames", |row| {
        times(row).map_or(Cell::Empty, |times| text(&times.clock))
    }),
    word("timed_size", "timed size", "columns and rows of the timed frames", |row| {
        times(row).map_or(Cell::Empty, |times| size(times.timed_size))
    }),
    figure("frame_ms", "frame ms", "median time of a whole frame with one sample per pixel", 2, |row| {
        time(row, |times| Some(times.frame_ms))
    }),
    figure("frame_low_ms", "frame ms low", "lower end of the 95 % interval of the median", 2, |row| {
        time(row, |times| Some(times.frame_low_ms))
    }),
    figure("frame_high_ms", "frame ms high", "upper end of the 95 % interval of the median", 2, |row| {
        time(row, |times| Some(times.frame_high_ms))
    }),
    figure(
        "displacement_ms",
        "displacement ms",
        "extra time over bump mapping, without shadows: of the tracing pass by a GPU's clock, or of the \
         frame",
        2,
        |row| time(row, |times| Some(times.displacement_ms)),
    ),
    figure(
        "displacement_low_ms",
        "displacement ms low",
        "lower end of the 95 % interval of the median",
        2,
        |row| time(row, |times| Some(times.displacement_low_ms)),
    ),
    figure(
        "displacement_high_ms",
        "displacement ms high",
        "upper end of the 95 % interval of the median",
        2,
        |row| time(row, |times| Some(times.displacement_high_ms)),
    ),
    figure("base_ms", "base ms", "time of bump mapping without light", 2, |row| {
        time(row, |times| Some(times.base_ms))
    }),
    figure("shade_ms", "shade ms", "time of lighting", 2, |row| time(row, |times| Some(times.shade_ms))),
    figure("shadow_ms", "shadow ms", "time of shadows", 2, |row| time(row, |times| Some(times.shadow_ms))),
    figure(
        "trace_pass_ms",
        "trace pass ms",
        "time of rasterising and tracing, by the GPU's clock",
        2,
        |row| time(row, |times| times.trace_pass_ms),
    ),
    figure("shade_pass_ms", "shade pass ms", "time of shading, by the GPU's clock", 2, |row| {
        time(row, |times| times.shade_pass_ms)
    }),
    figure(
        "confidence",
        "confidence",
        "probability that a true median lies in its interval, from 0 to 1",
        2,
        |row| time(row, |times| Some(times.confidence)),
    ),
    word(
        "below_noise",
        "below noise",
        "differences that may be 0: the lower end of their interval is not above it",
        |row| times(row).map_or(Cell::Empty, |times| text(times.below_noise.join(" "))),
    ),
    figure("map_bytes", "map bytes", "bytes of the baked maps that the method reads", 0, |row| {
        Cell::Number(row.method().map_bytes as f64)
    }),
    figure("bake_seconds", "bake s", "seconds for baking these maps", 3, |row| {
        Cell::Number(row.method().bake_seconds)
    }),
];
