//! `relief bench`: times frames of methods, part by part.

use std::io::Write;

use clap::Args;
use comfy_table::Table;
use comfy_table::presets::ASCII_MARKDOWN;
use relief_compare::{Comparison, MachineRecord, PictureRecord, Records, Timing};

use super::method_set::{MethodSetArguments, Unnamed, as_json, compared, of_comparison};
use crate::failure::Failure;
use crate::interrupt;
use crate::streams::{Files, answer};

/// Arguments of `relief bench`. Flags override the scene file.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  relief bench                      # all methods on the sample cobbles\n  \
    relief bench scenes/cobbles.toml --methods bump,relief,cone --size 1280x720\n  \
    relief bench --height wall.png --backend cpu,gpu --sampling exact,fast --json\n  \
    relief bench --methods bump,cone --shadow none,ray,soft,horizon\n\n\
    Frames have one sample per pixel. Methods take turns, so that a slow moment of the machine slows all of \
    them. Times are medians, with their 95 % confidence interval from 6 frames on. Differences that may be 0 \
    are in parentheses.\n\n\
    Compiling, uploading, baking and reading back are not part of a frame. The time of displacement is how \
    much longer a frame takes than with bump mapping. Where a GPU's own clock times its passes, it is how \
    much longer the pass that traces takes."
)]
pub struct Arguments {
    /// Frames per method that count, 1 to 100000
    #[arg(
        long,
        value_name = "N",
        default_value_t = 64,
        value_parser = clap::value_parser!(u32).range(1..=100_000),
        allow_hyphen_values = true
    )]
    frames: u32,
    /// Frames per method before them that do not count, 0 to 100000
    #[arg(
        long,
        value_name = "N",
        default_value_t = 8,
        value_parser = clap::value_parser!(u32).range(0..=100_000),
        allow_hyphen_values = true
    )]
    warm: u32,
    /// Print the result as one JSON object: all figures
    #[arg(long)]
    pub json: bool,

    #[command(flatten)]
    method_set: MethodSetArguments,
}

impl Arguments {
    /// Returns the files that may be standard input.
    pub fn files(&mut self) -> Files<'_> {
        Files { read: self.method_set.scene.files(), ..Files::default() }
    }

    fn comparison(&self) -> Result<Comparison, Failure> {
        let mut comparison = self.method_set.method_set(Unnamed::All)?.comparison(self.json)?;
        (comparison.rays, comparison.flicker_samples) = (0, None);
        comparison.timing = Some(Timing { frames: self.frames, warm: self.warm, pixels: 1 });
        comparison.check().map_err(of_comparison)?;
        Ok(comparison)
    }
}

/// Times the methods and prints the table.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let cancel = interrupt::catch()?;
    let comparison = arguments.comparison()?;
    let compared = compared("timing", &comparison, arguments.json, cancel)?;
    let records = &compared.records;
    answer(|out| {
        if arguments.json {
            return Ok(out.write_all(as_json(records)?.as_bytes())?);
        }
        for MachineRecord { backend, sampling, device } in &records.about.machines {
            writeln!(out, "{backend}, {sampling}: {device}")?;
        }
        writeln!(out, "{}", table(records))?;
        Ok(notes(records).iter().try_for_each(|note| writeln!(out, "{note}"))?)
    })
}

/// Returns the notes on the table's signs.
fn notes(records: &Records) -> Vec<&'static str> {
    let times = || records.pictures.iter().filter_map(|record| record.times.as_ref());
    let few = "-: fewer than 6 frames give no confidence interval: use --frames 6 or more";
    let noise = "(): below the noise, the true time may be 0: use more --frames or a larger --size";
    let is_few = times().any(|times| !times.is_sure());
    let is_noise = times().any(|times| !times.below_noise.is_empty());
    [is_few.then_some(few), is_noise.then_some(noise)].into_iter().flatten().collect()
}

/// Returns the table of milliseconds of frames and of their parts.
fn table(records: &Records) -> Table {
    let mut table = Table::new();
    table.load_style(ASCII_MARKDOWN).set_header([
        "method",
        "on",
        "frame ms",
        "95 % sure",
        "over bump",
        "base",
        "shade",
        "displacement ms",
        "95 % sure",
        "shadow",
        "trace pass",
        "shade pass",
    ]);
    let bump = |of: &PictureRecord| {
        let same = |record: &&PictureRecord| {
            record.method.method == "bump"
                && (&record.backend, &record.sampling, &record.method.shadow)
                    == (&of.backend, &of.sampling, &of.method.shadow)
        };
        records.pictures.iter().find(same).and_then(|record| record.times.as_ref())
    };
    for record in &records.pictures {
        let Some(times) = &record.times else { continue };
        let ms = |ms: f64| format!("{ms:.2}");
        // Times that may be 0 are in parentheses.
        let part = |key: &str, ms: f64| match times.below_noise.iter().any(|noise| noise == key) {
            true => format!("({ms:.2})"),
            false => format!("{ms:.2}"),
        };
        let sure = |low: f64, high: f64| match times.is_sure() {
            true => format!("{low:.2} to {high:.2}"),
            false => "-".to_owned(),
        };
        let pass = |pass: Option<f64>| pass.map_or("-".to_owned(), ms);
        table.add_row([
            record.method.label(),
            format!("{} {}", record.backend, record.sampling),
            ms(times.frame_ms),
            sure(times.frame_low_ms, times.frame_high_ms),
            bump(record).map_or("-".to_owned(), |bump| ms(times.frame_ms / bump.frame_ms)),
            ms(times.base_ms),
            part("shade_ms", times.shade_ms),
            part("displacement_ms", times.displacement_ms),
            sure(times.displacement_low_ms, times.displacement_high_ms),
            part("shadow_ms", times.shadow_ms),
            pass(times.trace_pass_ms),
            pass(times.shade_pass_ms),
        ]);
    }
    table
}
