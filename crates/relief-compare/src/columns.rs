//! The columns of tables: one list, from which the page and comma-separated values are made.

use crate::record::{CostRecord, ErrorRecord, MethodRecord, PictureRecord, RayRecord, Records, TimeRecord};

/// A row of a table.
#[derive(Clone, Copy, Debug)]
pub enum Row<'a> {
    /// A method along rays at an angle.
    Rays(&'a RayRecord),
    /// A method in a picture.
    Picture(&'a PictureRecord),
}

/// What stands in a row in a column.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// Nothing: the record has no such figure.
    Empty,
    /// A word.
    Text(String),
    /// A number.
    Number(f64),
}

/// A column.
#[derive(Clone, Copy, Debug)]
pub struct Column {
    /// Its name for programs: that of the record's field.
    pub key: &'static str,
    /// Its name for people.
    pub title: &'static str,
    /// What it is, in a line.
    pub summary: &'static str,
    /// By what its numbers are multiplied for people, as 100 of shares that are shown in percent.
    pub factor: f64,
    /// Digits after the point for people.
    pub digits: usize,
    /// What it has of a row.
    pub cell: fn(&Row) -> Cell,
}

impl<'a> Row<'a> {
    /// All rows of some records.
    pub fn all(records: &'a Records) -> impl Iterator<Item = Row<'a>> {
        records.rays.iter().map(Row::Rays).chain(records.pictures.iter().map(Row::Picture))
    }

    /// The method.
    pub fn method(&self) -> &'a MethodRecord {
        match self {
            Row::Rays(RayRecord { method, .. }) | Row::Picture(PictureRecord { method, .. }) => method,
        }
    }

    /// How wrong its hits are, if that was judged.
    pub fn error(&self) -> Option<&'a ErrorRecord> {
        match self {
            Row::Rays(record) => Some(&record.error),
            Row::Picture(record) => record.error.as_ref(),
        }
    }

    /// What these cost, if that was counted.
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
    word("method", "method", "the method", |row| text(&row.method().method)),
    figure("steps", "steps", "steps that it is allowed", 0, |row| number(row.method().steps.map(f64::from))),
    word("steps_key", "steps are", "the parameter that says so", |row| {
        row.method().steps_key.as_ref().map_or(Cell::Empty, text)
    }),
    word("geometry", "geometry", "what is drawn: the base, or displaced triangles", |row| {
        text(&row.method().geometry)
    }),
    word("search", "search", "how the first hit is bracketed", |row| text(&row.method().search)),
    word("refine", "refinement", "how the bracket is refined", |row| text(&row.method().refine)),
    word("promise", "promise", "what it promises for view rays", |row| text(&row.method().promise)),
    word("map_format", "maps are", "how the values of its baked maps are stored", |row| {
        row.method().map_format.as_ref().map_or(Cell::Empty, text)
    }),
    word("shadow", "shadow", "what part of a light arrives", |row| {
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
    word("backend", "backend", "where the picture was made", |row| {
        row.picture().map_or(Cell::Empty, |record| text(&record.backend))
    }),
    word("sampling", "sampling", "how textures were read", |row| {
        row.picture().map_or(Cell::Empty, |record| text(&record.sampling))
    }),
    word("size", "picture", "columns and rows of the picture", |row| {
        row.picture().map_or(Cell::Empty, |record| size(record.size))
    }),
    figure("samples", "samples", "samples of a pixel", 0, |row| {
        picture(row, |record| Some(record.samples.into()))
    }),
    figure("distance_m", "distance m", "metres between the eye and what it looks at", 2, |row| {
        picture(row, |record| record.distance_m)
    }),
    figure("rays", "rays", "rays that were compared", 0, |row| error(row, |error| error.rays as f64)),
    share("passed", "passed %", "rays that passed the first hit: missed, or late", |row| {
        error(row, |error| error.passed)
    }),
    share("missed", "missed %", "rays given as misses that truly hit", |row| {
        error(row, |error| error.missed)
    }),
    share("false_hits", "false %", "rays given as hits that truly miss", |row| {
        error(row, |error| error.false_hits)
    }),
    share("late", "late %", "hits more than half a texel behind the true one", |row| {
        error(row, |error| error.late)
    }),
    share("early", "early %", "hits more than half a texel before the true one", |row| {
        error(row, |error| error.early)
    }),
    share("exhausted", "exhausted %", "rays that ran out of steps", |row| {
        error(row, |error| error.exhausted)
    }),
    figure("mean_texels", "mean texels", "mean distance from the true hit", 4, |row| {
        error(row, |error| error.mean_texels)
    }),
    figure("median_texels", "median texels", "median distance from the true hit", 4, |row| {
        error(row, |error| error.median_texels)
    }),
    figure("p99_texels", "p99 texels", "distance from the true hit that 99 of 100 keep", 3, |row| {
        error(row, |error| error.p99_texels)
    }),
    figure("max_texels", "max texels", "greatest distance from the true hit", 2, |row| {
        error(row, |error| error.max_texels)
    }),
    figure("p99_depth_m", "p99 depth m", "difference of depth that 99 of 100 keep", 4, |row| {
        error(row, |error| error.p99_depth_m)
    }),
    figure("reads", "reads", "mean reads of a ray", 1, |row| cost(row, |cost| cost.reads)),
    figure("p99_reads", "p99 reads", "reads that 99 of 100 rays keep", 0, |row| {
        cost(row, |cost| cost.p99_reads)
    }),
    figure("wave_reads", "wave reads", "mean of the most reads in tiles of 8 x 4 pixels", 1, |row| {
        picture(row, |record| record.wave_reads)
    }),
    figure("turns", "turns", "mean turns of loops of a ray", 1, |row| cost(row, |cost| cost.turns)),
    figure("bytes", "bytes", "mean bytes that a ray's reads fetch", 0, |row| cost(row, |cost| cost.bytes)),
    figure("flip", "FLIP", "mean FLIP to the reference", 4, |row| picture(row, |record| Some(record.flip))),
    figure("ssim", "SSIM", "structural similarity to the reference", 4, |row| {
        picture(row, |record| Some(record.ssim))
    }),
    figure(
        "psnr_db",
        "PSNR dB",
        "peak signal to noise ratio; empty where the pictures are the same",
        1,
        |row| picture(row, |record| record.psnr_db),
    ),
    figure("rms", "RMS", "root of the mean squared error of linear colours", 4, |row| {
        picture(row, |record| Some(record.rms))
    }),
    figure(
        "flicker_rms",
        "flicker RMS",
        "between frames a tenth of a pixel apart, beyond the truth's",
        4,
        |row| picture(row, |record| record.flicker_rms),
    ),
    figure("flicker_flip", "flicker FLIP", "the same in FLIP", 4, |row| {
        picture(row, |record| record.flicker_flip)
    }),
    word("clock", "clock", "what told the time", |row| {
        times(row).map_or(Cell::Empty, |times| text(&times.clock))
    }),
    word("timed_size", "timed", "columns and rows of the frames that were timed", |row| {
        times(row).map_or(Cell::Empty, |times| size(times.timed_size))
    }),
    figure("frame_ms", "frame ms", "a whole frame of one sample a pixel: median", 2, |row| {
        time(row, |times| Some(times.frame_ms))
    }),
    figure("frame_low_ms", "frame ms from", "what the true median is not below, at 95 in 100", 2, |row| {
        time(row, |times| Some(times.frame_low_ms))
    }),
    figure("frame_high_ms", "frame ms to", "what it is not above", 2, |row| {
        time(row, |times| Some(times.frame_high_ms))
    }),
    figure(
        "displacement_ms",
        "displacement ms",
        "more than bump mapping without shadows: by a GPU's clock the pass that traces, else the frame",
        2,
        |row| time(row, |times| Some(times.displacement_ms)),
    ),
    figure(
        "displacement_low_ms",
        "displacement ms from",
        "what its true median is not below, at 95 in 100",
        2,
        |row| time(row, |times| Some(times.displacement_low_ms)),
    ),
    figure("displacement_high_ms", "displacement ms to", "what it is not above", 2, |row| {
        time(row, |times| Some(times.displacement_high_ms))
    }),
    figure("base_ms", "base ms", "bump mapping without light", 2, |row| {
        time(row, |times| Some(times.base_ms))
    }),
    figure("shade_ms", "shade ms", "lighting", 2, |row| time(row, |times| Some(times.shade_ms))),
    figure("shadow_ms", "shadow ms", "shadows", 2, |row| time(row, |times| Some(times.shadow_ms))),
    figure("trace_pass_ms", "trace pass ms", "rasterising and tracing, by the GPU's clock", 2, |row| {
        time(row, |times| times.trace_pass_ms)
    }),
    figure("shade_pass_ms", "shade pass ms", "shading, by the GPU's clock", 2, |row| {
        time(row, |times| times.shade_pass_ms)
    }),
    figure(
        "confidence",
        "sure",
        "part of all cases in which true medians lie between their ends",
        2,
        |row| time(row, |times| Some(times.confidence)),
    ),
    word("below_noise", "below noise", "differences that may be 0 for all that is known", |row| {
        times(row).map_or(Cell::Empty, |times| text(times.below_noise.join(" ")))
    }),
    figure("map_bytes", "map bytes", "bytes of the baked maps that it reads", 0, |row| {
        Cell::Number(row.method().map_bytes as f64)
    }),
    figure("bake_seconds", "bake s", "seconds that baking them took", 3, |row| {
        Cell::Number(row.method().bake_seconds)
    }),
];
