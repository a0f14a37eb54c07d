//! `trace`: rays a second of the exact tracer that renderers use, beside the truth, the shaders, parry3d and
//! POV-Ray.
//!
//! Everything is measured in rounds. Each program has a turn in each round, so that other work of the
//! machine affects all alike. Ratios are taken round by round.

mod agreement;
mod maps;
pub mod measure;
mod picture;
mod povray;
mod tracers;
pub mod view;

use std::path::PathBuf;
use std::thread::available_parallelism;
use std::time::{Duration, Instant};

use clap::Args;
use comfy_table::Table;
use cpu_time::ProcessTime;
use rayon::ThreadPool;
use relief_core::HeightMap;
use relief_core::exact::FastTracer;

use maps::{SUBJECTS, Subject};
use measure::{Cursor, Setup};
use tracers::{FAST, PARRY, Rays, TracerSet};
use view::{Ground, SIZE};

use crate::samples::Samples;
use crate::table::table;

/// Numbers of threads that everything is measured with.
const THREADS: [usize; 2] = [1, 2];

/// Aims: millions of rays a second a thread, and how many times as fast as the other programs.
const AIM_MILLIONS: f64 = 10.0;
const AIM_OVER_PARRY: f64 = 10.0;
const AIM_OVER_POVRAY: f64 = 4.0;

/// Arguments of `trace`.
#[derive(Args)]
pub struct Arguments {
    /// Rounds in which everything is measured once
    #[arg(long, default_value_t = 5, value_parser = clap::value_parser!(u16).range(1..=1000))]
    rounds: u16,
    /// Seconds that a tracer has in each round
    #[arg(long, default_value_t = 0.12, value_parser = seconds)]
    turn: f64,
    /// Only these maps
    #[arg(
        long,
        value_parser = clap::builder::PossibleValuesParser::new(SUBJECTS.iter().map(|subject| subject.name))
    )]
    map: Vec<String>,
    /// A folder for the pictures that are compared with POV-Ray's
    #[arg(long)]
    pictures: Option<PathBuf>,
}

fn seconds(text: &str) -> Result<f64, String> {
    let seconds = text.parse().map_err(|_| "it must be a number".to_owned())?;
    if (0.001..=60.0).contains(&seconds) {
        Ok(seconds)
    } else {
        Err("it must be from 0.001 to 60".to_owned())
    }
}

/// What is measured, and by how much it is to be exceeded.
struct Aims {
    millions: Vec<(String, f64)>,
    over_parry: Vec<(String, f64)>,
    over_povray: Vec<(String, f64)>,
}

/// How long the picture takes each program, in seconds.
#[derive(Clone, Default)]
struct Pace {
    ours: Samples,
    theirs: Samples,
    ours_cpu: Samples,
    theirs_cpu: Samples,
}

struct Bench<'a> {
    arguments: &'a Arguments,
    rounds: usize,
    pools: Vec<(usize, ThreadPool)>,
    povray: Option<String>,
    aims: Aims,
}

/// Prints the tables.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    if let Some(folder) = &arguments.pictures {
        std::fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    }
    let pools = THREADS.map(|threads| Ok((threads, measure::pool(threads)?)));
    let mut bench = Bench {
        arguments,
        rounds: usize::from(arguments.rounds),
        pools: pools.into_iter().collect::<Result<_, String>>()?,
        povray: povray::version(),
        aims: Aims { millions: Vec::new(), over_parry: Vec::new(), over_povray: Vec::new() },
    };
    let cores = available_parallelism().map_or(0, usize::from);
    println!("{cores} cores{}. {} rounds; medians, with the least and the greatest.", load(), bench.rounds);
    println!("Rates are rays a second of processor time, summed over the threads.");
    if bench.povray.is_none() {
        println!("POV-Ray is not installed (Debian's package povray): left out.");
    }
    let wanted = |subject: &&Subject| {
        arguments.map.is_empty() || arguments.map.iter().any(|name| name == subject.name)
    };
    for subject in SUBJECTS.iter().filter(wanted) {
        bench.measure(subject)?;
    }
    println!("\n## Aims{}\n", load());
    bench.aims.print();
    Ok(())
}

/// The load of the machine, where the system tells it.
fn load() -> String {
    let text = std::fs::read_to_string("/proc/loadavg").unwrap_or_default();
    text.split_whitespace().next().map(|load| format!(", load {load}")).unwrap_or_default()
}

impl Bench<'_> {
    fn measure(&mut self, subject: &Subject) -> Result<(), String> {
        let map = subject.map()?;
        println!("\n## {}: {}x{}\n", subject.name, map.width(), map.height());
        println!("{}", self.set_ups(&map));
        let tracer_set = TracerSet::new(&map)?;
        let ground = Ground::of(&map);
        let mut rates = table(&[
            "rays",
            "tracer",
            "million rays/s, 1 thread",
            "2 threads",
            "FastTracer's lead, 1 thread",
            "2 threads",
        ]);
        let mut answers =
            table(&["rays", "tracer", "hit %", "truth %", "other answer %", "median texels", "p99"]);
        let scattered = tracers::scattered_rays(&ground);
        let coherent = tracers::picture_rays(&ground)?;
        for (view, shadow) in [(coherent, "picture, shadow"), (scattered, "scattered, shadow")] {
            let shadow = view.shadows(shadow, &ground, &tracer_set);
            for rays in [view, shadow] {
                agreement::check_fast(&tracer_set, &rays)?;
                compare_answers(&tracer_set, &rays, &mut answers);
                self.race(subject, &tracer_set, &rays, &mut rates);
            }
        }
        println!("\n{rates}\n\n{answers}");
        self.pictures(subject, &tracer_set)
    }

    fn set_ups(&self, map: &HeightMap) -> Table {
        let mut table = table(&["set-up", "threads", "milliseconds", "bytes a texel"]);
        let texels = map.texels().len();
        let mut add = |name: &str, threads: usize, setup: &Setup| {
            let bytes = setup.bytes_per_texel.map_or("-".to_owned(), |bytes| format!("{bytes:.2}"));
            table.add_row([name, &threads.to_string(), &setup.seconds.times(1e3).to_string(), &bytes]);
        };
        for (threads, pool) in &self.pools {
            let fast = pool.install(|| measure::set_up(texels, self.rounds, || FastTracer::new(map)));
            add(FAST, *threads, &fast);
        }
        add(PARRY, 1, &measure::set_up(texels, self.rounds, || tracers::parry_field(map)));
        table
    }

    fn race(&mut self, subject: &Subject, tracer_set: &TracerSet, rays: &Rays, table: &mut Table) {
        let turn = Duration::from_secs_f64(self.arguments.turn);
        let tracers = tracer_set.tracers();
        let cursors: Vec<Cursor> = tracers.iter().map(|_| Cursor::default()).collect();
        let mut rates = vec![vec![Samples::default(); tracers.len()]; self.pools.len()];
        for _ in 0..self.rounds {
            for ((_, pool), rates) in self.pools.iter().zip(&mut rates) {
                for (((_, tracer), cursor), rates) in tracers.iter().zip(&cursors).zip(rates) {
                    let trace = |range| tracer.trace(rays, range);
                    rates.push(measure::rays_per_second(pool, tracer.count(rays), cursor, turn, trace));
                }
            }
        }
        for (at, (name, _)) in tracers.iter().enumerate() {
            let leads: Vec<Samples> = rates.iter().map(|rates| rates[0].over(&rates[at])).collect();
            let mut row = vec![rays.name.to_owned(), (*name).to_owned()];
            row.extend(rates.iter().map(|rates| rates[at].times(1e-6).to_string()));
            row.extend(leads.iter().map(|lead| format!("{:.2}", lead.median())));
            table.add_row(row);
            for ((threads, _), (rates, lead)) in self.pools.iter().zip(rates.iter().zip(&leads)) {
                let label = format!("{}, {}, {threads} threads", subject.name, rays.name);
                if *name == FAST {
                    let a_thread = rates[at].median() * 1e-6 / *threads as f64;
                    self.aims.millions.push((label, a_thread));
                } else if *name == PARRY {
                    self.aims.over_parry.push((label, lead.median()));
                }
            }
        }
    }

    fn pictures(&mut self, subject: &Subject, tracer_set: &TracerSet) -> Result<(), String> {
        let stage = picture::Stage::new(tracer_set.map, &tracer_set.fast)?;
        let scene = self.povray.is_some().then(|| povray::Scene::new(tracer_set.map)).transpose()?;
        let mut pace = vec![Pace::default(); self.pools.len()];
        let mut parse = Samples::default();
        let mut shadow_rays = [0; 2];
        for _ in 0..self.rounds {
            for (at, (threads, pool)) in self.pools.iter().enumerate() {
                let (start, cpu_start) = (Instant::now(), ProcessTime::now());
                let picture = stage.render(pool);
                pace[at].ours.push(start.elapsed().as_secs_f64());
                pace[at].ours_cpu.push(cpu_start.elapsed().as_secs_f64() / *threads as f64);
                shadow_rays[0] = picture.shadow_rays;
                if let Some(scene) = &scene {
                    let statistics = scene.time(*threads)?;
                    pace[at].theirs.push(statistics.trace_s);
                    pace[at].theirs_cpu.push(statistics.trace_cpu_s / *threads as f64);
                    parse.push(statistics.parse_s);
                    shadow_rays[1] = statistics.shadow_rays;
                }
            }
        }
        let [width, height] = SIZE;
        println!(
            "\nThe picture of {width}x{height}: seconds for view rays, shadow rays and light, \
             in packets of 16.\n"
        );
        let mut table = table(&["time", "threads", "FastTracer", "POV-Ray", "FastTracer's lead"]);
        for ((threads, _), pace) in self.pools.iter().zip(&pace) {
            let clocks = [
                ("from beginning to end", &pace.ours, &pace.theirs),
                ("processor time a thread", &pace.ours_cpu, &pace.theirs_cpu),
            ];
            for (clock, ours, theirs) in clocks {
                let mut row = vec![clock.to_owned(), threads.to_string(), ours.to_string()];
                if scene.is_some() {
                    let lead = theirs.over(ours).median();
                    row.extend([theirs.to_string(), format!("{lead:.2}")]);
                    self.aims
                        .over_povray
                        .push((format!("{}, {threads} threads, {clock}", subject.name), lead));
                }
                table.add_row(row);
            }
        }
        println!("{table}");
        let picture = stage.render(&self.pools[0].1).grey;
        let file = |program: &str| {
            let folder = self.arguments.pictures.as_ref()?;
            Some(folder.join(format!("{}-{program}.png", subject.name)))
        };
        if let Some(file) = file("relief") {
            picture::write(&file, &picture)?;
        }
        let Some(scene) = scene else { return Ok(()) };
        let (difference, shift) =
            picture::difference(&picture, &scene.picture(THREADS[0], file("povray").as_deref())?);
        println!(
            "\n\
             POV-Ray's parse time: {parse} s. Shadow rays: {} and {}. Mean difference of the pictures: \
             {difference:.4} of white.",
            shadow_rays[0], shadow_rays[1]
        );
        if shift == [0, 0] {
            Ok(())
        } else {
            Err(format!("{}: the pictures do not show the same view: {shift:?} pixels apart", subject.name))
        }
    }
}

fn compare_answers(tracer_set: &TracerSet, rays: &Rays, table: &mut Table) {
    for (name, tracer) in tracer_set.tracers() {
        let agreement = agreement::compare(tracer_set, rays, &tracer);
        let percent = |share: f64| format!("{:.2}", share * 100.0);
        let mut row = vec![
            rays.name.to_owned(),
            name.to_owned(),
            percent(agreement.hits),
            percent(agreement.true_hits),
        ];
        row.extend(match agreement.rays {
            Some(rays) => [
                format!("{:.3}", rays.other_answer * 100.0),
                format!("{:.1e}", rays.texels[0]),
                format!("{:.1e}", rays.texels[1]),
            ],
            None => ["-", "-", "-"].map(str::to_owned),
        });
        table.add_row(row);
    }
}

impl Aims {
    fn print(&self) {
        let aims = [
            (&self.millions, AIM_MILLIONS, "million rays a second a thread"),
            (&self.over_parry, AIM_OVER_PARRY, "times parry3d's rays a second"),
            (&self.over_povray, AIM_OVER_POVRAY, "times as fast as POV-Ray, by either clock"),
        ];
        for (measured, aim, what) in aims {
            let met = measured.iter().filter(|(_, value)| *value >= aim).count();
            let least = measured.iter().min_by(|a, b| a.1.total_cmp(&b.1));
            match least {
                None => println!("- {aim} {what}: not measured"),
                Some((label, least)) => println!(
                    "- {aim} {what}: {}, in {met} of {}; least {least:.2} ({label})",
                    if met == measured.len() { "met" } else { "not met" },
                    measured.len(),
                ),
            }
        }
    }
}
