//! `relief bench`: how long the frames of methods take, part by part.

use std::io::Write;

use clap::Args;
use comfy_table::Table;
use comfy_table::presets::ASCII_MARKDOWN;
use relief_compare::{Comparison, MachineRecord, PictureRecord, Records, Timing};

use super::contest::{ContestArguments, as_json, compared, of_comparison};
use crate::failure::Failure;
use crate::interrupt;
use crate::streams::{Files, answer};

/// What `relief bench` is given. Flags override the scene file.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  relief bench                      # all methods on the sample cobbles\n  \
    relief bench scenes/cobbles.toml --methods bump,relief,cone --size 1280x720\n  \
    relief bench --height wall.png --backend cpu,gpu --sampling exact,fast --json\n  \
    relief bench --methods bump,cone --shadow none,ray,soft,horizon\n\n\
    Frames have one sample a pixel. Methods take turns, so that what slows the machine for a while slows \
    all of them; medians are given, and from 6 frames on what the true ones lie between at 95 in 100. \
    Differences that may be 0 for all that is known are in parentheses. Compiling, \
    uploading, baking and reading back are no part of a frame. What finding the surface takes is what a \
    frame takes more than one of bump mapping; where a GPU's own clock times its passes, what the pass takes \
    more that traces."
)]
pub struct Arguments {
    /// Frames of each that count
    #[arg(
        long,
        value_name = "N",
        default_value_t = 64,
        value_parser = clap::value_parser!(u32).range(1..=100_000),
        allow_hyphen_values = true
    )]
    frames: u32,
    /// Frames of each before these that do not
    #[arg(
        long,
        value_name = "N",
        default_value_t = 8,
        value_parser = clap::value_parser!(u32).range(0..=100_000),
        allow_hyphen_values = true
    )]
    warm: u32,
    /// Print all figures as one JSON object
    #[arg(long)]
    pub json: bool,

    #[command(flatten)]
    contest: ContestArguments,
}

impl Arguments {
    /// The files that may be the standard input.
    pub fn files(&mut self) -> Files<'_> {
        Files { read: self.contest.scene.files(), ..Files::default() }
    }

    fn comparison(&self) -> Result<Comparison, Failure> {
        let mut comparison = self.contest.contest()?.comparison(self.json)?;
        (comparison.rays, comparison.flicker_samples) = (0, None);
        comparison.timing = Some(Timing { frames: self.frames, warm: self.warm, pixels: 1 });
        comparison.check().map_err(of_comparison)?;
        Ok(comparison)
    }
}

/// Times and tells.
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

/// What the table does not say by itself.
fn notes(records: &Records) -> Vec<&'static str> {
    let times = || records.pictures.iter().filter_map(|record| record.times.as_ref());
    let few = "-: how sure a median is, fewer than 6 frames do not tell: --frames 6 or more do";
    let noise = "(): below the noise, the true time may be 0: more --frames or a larger --size tell it";
    let is_few = times().any(|times| !times.is_sure());
    let is_noise = times().any(|times| !times.below_noise.is_empty());
    [is_few.then_some(few), is_noise.then_some(noise)].into_iter().flatten().collect()
}

/// Milliseconds of frames and of their parts.
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
        // What may be 0 for all that is known.
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
