//! The fuzz targets over seeded changes of their corpora, for some minutes: panics, inputs that take long,
//! and inputs that take much memory.

use std::fs::{self, File};
use std::io::{Seek, SeekFrom, Write};
use std::panic;
use std::path::{Path, PathBuf};
use std::process::{ExitCode, exit};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use clap::Args;
use relief_fuzz::{Corpus, TARGETS, Target};

use crate::memory;
use crate::table::table;

/// An input that takes longer is a failure.
const LONG: Duration = Duration::from_secs(10);

/// An input that takes longer ends the run, since it may never end.
const ENDLESS: Duration = Duration::from_secs(120);

/// An input that takes more memory is a failure: twice what the readers are allowed, and what they may take
/// beside it.
const MUCH_MEMORY: usize = 256 << 20;

/// Failures after which a target is left.
const MOST_FAILURES: usize = 10;

/// Arguments of `fuzz`.
#[derive(Args)]
pub struct Arguments {
    /// Minutes, over all targets together
    #[arg(long, value_name = "N", default_value_t = 10.0)]
    minutes: f64,
    /// Run this target alone
    #[arg(long, value_name = "NAME")]
    target: Option<String>,
    /// First seed: the others follow it
    #[arg(long, value_name = "N", default_value_t = 0)]
    seed: u64,
    /// Folder for inputs that fail
    #[arg(short, long, value_name = "DIR", default_value = "target/fuzz")]
    output: PathBuf,
    /// Run one input from a file, such as one that failed
    #[arg(long, value_name = "FILE", requires = "target", conflicts_with_all = ["minutes", "seed"])]
    input: Option<PathBuf>,
}

/// Runs the targets in turn and prints what each took; fails where an input does.
pub fn run(arguments: &Arguments) -> Result<ExitCode, String> {
    let targets = targets(arguments.target.as_deref())?;
    if let (Some(path), [target]) = (&arguments.input, targets.as_slice()) {
        let input = fs::read(path).map_err(|error| format!("{}: {error}", path.display()))?;
        let what = if (target.run)(&input) { "valid" } else { "refused" };
        println!("{}: {} bytes, {what}", target.name, input.len());
        return Ok(ExitCode::SUCCESS);
    }
    if !(arguments.minutes > 0.0 && arguments.minutes.is_finite()) {
        return Err(format!("--minutes is {}; give a number above 0", arguments.minutes));
    }
    fs::create_dir_all(&arguments.output)
        .map_err(|error| format!("{}: {error}", arguments.output.display()))?;
    let each = Duration::from_secs_f64(arguments.minutes * 60.0 / targets.len() as f64);
    // A panic is reported with its seed.
    panic::set_hook(Box::new(|_| {}));
    let mut table = table(&["target", "inputs", "valid", "failures", "longest, ms", "most memory, MiB"]);
    let (mut inputs, mut failures) = (0, 0);
    for target in &targets {
        let tally = Fuzzed::run(target, each, arguments)?;
        let row = [tally.inputs, tally.valid, tally.failures as u64];
        let row = row.iter().map(u64::to_string);
        let costs = [tally.longest.as_millis().to_string(), (tally.most_memory >> 20).to_string()];
        table.add_row([target.name.to_owned()].into_iter().chain(row).chain(costs));
        (inputs, failures) = (inputs + tally.inputs, failures + tally.failures);
    }
    println!("{table}\n\n{inputs} inputs from seed {} on, {failures} failures", arguments.seed);
    Ok(if failures == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn targets(name: Option<&str>) -> Result<Vec<Target>, String> {
    let Some(name) = name else { return Ok(TARGETS.to_vec()) };
    let found: Vec<Target> = TARGETS.iter().copied().filter(|target| target.name == name).collect();
    if found.is_empty() {
        let names: Vec<&str> = TARGETS.iter().map(|target| target.name).collect();
        return Err(format!("there is no target '{name}'; give one of {}", names.join(", ")));
    }
    Ok(found)
}

/// What came of a target's inputs.
#[derive(Default)]
struct Fuzzed {
    inputs: u64,
    valid: u64,
    failures: usize,
    longest: Duration,
    most_memory: usize,
}

impl Fuzzed {
    fn run(target: &Target, time: Duration, arguments: &Arguments) -> Result<Self, String> {
        let corpus = target.corpus();
        let mut fuzzed = Self::default();
        let watch = Watchdog::over(target, &arguments.output)?;
        let start = Instant::now();
        for seed in arguments.seed.. {
            if start.elapsed() >= time || fuzzed.failures >= MOST_FAILURES {
                break;
            }
            watch.begins(seed)?;
            if let Some(failure) = fuzzed.attempt(target, &corpus, seed) {
                fuzzed.failures += 1;
                let path = arguments.output.join(format!("{}-{seed}", target.name));
                println!("{}, seed {seed}: {failure}; the input is in {}", target.name, path.display());
                fs::write(&path, corpus.mutated(seed)).map_err(|error| error.to_string())?;
            }
        }
        watch.ends()?;
        Ok(fuzzed)
    }

    /// Runs one input and says how it fails, if it does.
    fn attempt(&mut self, target: &Target, corpus: &Corpus, seed: u64) -> Option<String> {
        let input = corpus.mutated(seed);
        memory::reset();
        let start = Instant::now();
        let attempt = target.attempt(&input);
        let (elapsed, most_memory) = (start.elapsed(), memory::peak());
        self.inputs += 1;
        self.longest = self.longest.max(elapsed);
        self.most_memory = self.most_memory.max(most_memory);
        match attempt {
            Err(message) => Some(message),
            Ok(_) if elapsed > LONG => Some(format!("{:.1} s", elapsed.as_secs_f64())),
            Ok(_) if most_memory > MUCH_MEMORY => Some(format!("{} MiB of memory", most_memory >> 20)),
            Ok(is_valid) => {
                self.valid += u64::from(is_valid);
                None
            }
        }
    }
}

/// Keeps the seed of the running input in a file, for the case that the program aborts, and ends the program
/// when an input takes too long.
struct Watchdog {
    file: File,
    path: PathBuf,
    /// Milliseconds since the start at which the running input began; 0 when all are done.
    began: Arc<AtomicU64>,
    start: Instant,
}

impl Watchdog {
    fn over(target: &Target, folder: &Path) -> Result<Self, String> {
        let path = folder.join(format!("{}-running", target.name));
        let file = File::create(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        let (began, start) = (Arc::new(AtomicU64::new(1)), Instant::now());
        let watched = Arc::clone(&began);
        let told = path.display().to_string();
        thread::spawn(move || {
            loop {
                thread::sleep(Duration::from_secs(1));
                match watched.load(Ordering::Relaxed) {
                    0 => return,
                    began if start.elapsed() > ENDLESS + Duration::from_millis(began) => {
                        println!("an input takes more than {} s; its seed is in {told}", ENDLESS.as_secs());
                        exit(1);
                    }
                    _ => {}
                }
            }
        });
        Ok(Self { file, path, began, start })
    }

    fn begins(&self, seed: u64) -> Result<(), String> {
        self.began.store(self.start.elapsed().as_millis() as u64 + 1, Ordering::Relaxed);
        let mut file = &self.file;
        let written =
            file.seek(SeekFrom::Start(0)).and_then(|_| file.write_all(format!("{seed}\n").as_bytes()));
        written.map_err(|error| format!("{}: {error}", self.path.display()))
    }

    fn ends(self) -> Result<(), String> {
        self.began.store(0, Ordering::Relaxed);
        fs::remove_file(&self.path).map_err(|error| format!("{}: {error}", self.path.display()))
    }
}
