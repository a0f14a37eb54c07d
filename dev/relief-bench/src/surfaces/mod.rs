//! `surfaces`: pictures of every surface on curved meshes, beside the exact judge of displaced meshes.

pub mod bases;
mod rims;

use clap::builder::PossibleValuesParser;
use clap::{Args, ValueEnum};
use indicatif::ProgressBar;
use relief_core::HeightMap;
use relief_core::rng::Rng;
use relief_render::Renderer;
use relief_scene::BackendChoice;
use relief_tests::curved::{Comparison, Curved, Drawn, Judged, Picture, quantile};

use crate::table::table;
use bases::{Base, NAMES, cobbles};

/// Arguments of `surfaces`.
#[derive(Args)]
pub struct Arguments {
    /// Random views of each mesh
    #[arg(long, default_value_t = 4)]
    views: u32,
    /// Width of the pictures; they are three quarters as high
    #[arg(long, default_value_t = 800)]
    width: u32,
    /// Metres between the heights 0 and 1, on meshes that are 1 m large
    #[arg(long, default_value_t = 0.03)]
    scale: f64,
    /// Where the relief lies [default: both]
    #[arg(long, value_enum)]
    relief: Option<Lies>,
    /// Only these meshes
    #[arg(long, value_delimiter = ',', value_parser = PossibleValuesParser::new(NAMES))]
    mesh: Vec<String>,
    /// Only these surfaces
    #[arg(long, value_delimiter = ',',
        value_parser = PossibleValuesParser::new(SURFACES.map(|row| row.name)))]
    surface: Vec<String>,
}

/// Where a relief lies.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Lies {
    /// Height 1 on the mesh.
    Carved,
    /// Height 0 on the mesh.
    Outward,
}

impl Lies {
    /// Both, or the one that is asked for.
    pub fn chosen(asked: Option<Self>) -> Vec<Self> {
        asked.map_or_else(|| vec![Self::Carved, Self::Outward], |one| vec![one])
    }

    /// Name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Carved => "carved",
            Self::Outward => "outward",
        }
    }

    /// Metres from the mesh to height 0.
    pub fn bias_m(self, scale_m: f64) -> f64 {
        match self {
            Self::Carved => -scale_m,
            Self::Outward => 0.0,
        }
    }
}

/// What a surface is compared with.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Beside {
    /// The displaced mesh itself.
    Itself,
    /// The displaced smooth surface, or where there is none the displaced mesh.
    Smooth,
    /// Both.
    Both,
}

/// A surface that is measured.
struct Measured {
    name: &'static str,
    drawn: Drawn,
    beside: Beside,
    /// Whether hits at silhouettes are counted apart, beside the mesh itself. This takes long if most hits
    /// differ.
    hits: bool,
}

const PRISM: Drawn = Drawn::flat("prism");
const VERTICAL: Drawn = Drawn::flat("quadric-vertical");

const fn row(name: &'static str, drawn: Drawn, beside: Beside, hits: bool) -> Measured {
    Measured { name, drawn, beside, hits }
}

const SURFACES: [Measured; 8] = [
    row("plane", Drawn::flat("plane"), Beside::Both, false),
    row("tetrahedra", Drawn::flat("tetrahedra"), Beside::Itself, true),
    row("prism", PRISM, Beside::Both, true),
    row("prism-lifted", Drawn { lifted: true, ..PRISM }, Beside::Smooth, false),
    row("quadric-vertical", VERTICAL, Beside::Smooth, false),
    row("quadric-vertical-two", Drawn { two_coefficients: true, ..VERTICAL }, Beside::Smooth, false),
    row("quadric-vertical-lifted", Drawn { lifted: true, ..VERTICAL }, Beside::Smooth, false),
    row(
        "quadric-perpendicular",
        Drawn { method: "relief", ..Drawn::flat("quadric-perpendicular") },
        Beside::Smooth,
        false,
    ),
];

/// A surface beside one of the truths, over all views.
struct Row<'a> {
    of: &'a Measured,
    smooth: bool,
    comparison: Comparison,
    /// Distances of outlines near rims.
    rims: Vec<f64>,
}

/// Prints the table.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let map = cobbles()?;
    let is_asked = |asked: &[String], name: &str| asked.is_empty() || asked.iter().any(|one| one == name);
    let surfaces: Vec<&Measured> =
        SURFACES.iter().filter(|one| is_asked(&arguments.surface, one.name)).collect();
    let mut rows = table(&[
        "mesh",
        "relief",
        "surface",
        "beside",
        "outline p50",
        "p95",
        "p99",
        "overlap",
        "all hits p50",
        "all beyond half",
        "hits p50",
        "p99",
        "beyond half",
        "depth p99",
        "open",
        "behind",
        "of all",
    ]);
    let mut at_rims = table(&["mesh", "relief", "surface", "beside", "near rims p50", "p95", "p99"]);
    let names: Vec<&str> = NAMES.iter().copied().filter(|name| is_asked(&arguments.mesh, name)).collect();
    let lies = Lies::chosen(arguments.relief);
    let progress = ProgressBar::new(names.len() as u64 * lies.len() as u64 * u64::from(arguments.views));
    for name in names {
        let Some(base) = Base::of(name)? else { continue };
        for lies in &lies {
            for row in compared(arguments, &map, &base, *lies, &surfaces, &progress) {
                let beside = if row.smooth { "the smooth one" } else { "itself" };
                let first = [base.name, lies.name(), row.of.name, beside].map(str::to_owned);
                if base.has_rims {
                    let parts = [0.5, 0.95, 0.99].map(|part| format!("{:.2}", quantile(&row.rims, part)));
                    at_rims.add_row(first.iter().cloned().chain(parts));
                }
                rows.add_row(first.into_iter().chain(row.numbers()));
            }
        }
    }
    progress.finish_and_clear();
    println!("{rows}");
    if !at_rims.is_empty() {
        println!("\n{at_rims}");
    }
    Ok(())
}

impl Row<'_> {
    /// Whether hits at silhouettes are counted apart.
    fn hits(&self) -> bool {
        self.of.hits && !self.smooth
    }

    fn numbers(&self) -> Vec<String> {
        let Comparison { inside, all, .. } = &self.comparison;
        let mut numbers = vec![
            format!("{:.2}", self.comparison.outline_at(0.5)),
            format!("{:.2}", self.comparison.outline_at(0.95)),
            format!("{:.2}", self.comparison.outline_at(0.99)),
            format!("{:.4}", self.comparison.overlap()),
            format!("{:.5}", all.texels_at(0.5)),
            format!("{:.3} %", 100.0 * all.beyond_half()),
        ];
        if self.hits() {
            numbers.extend([
                format!("{:.5}", inside.texels_at(0.5)),
                format!("{:.4}", inside.texels_at(0.99)),
                format!("{:.3} %", 100.0 * inside.beyond_half()),
                format!("{:.5}", inside.depths_at(0.99)),
                self.comparison.open.to_string(),
                self.comparison.behind.to_string(),
                self.comparison.all_behind.to_string(),
            ]);
        } else {
            numbers.extend(["-"; 7].map(str::to_owned));
        }
        numbers
    }
}

/// What each surface shows of a mesh, beside the judge of that mesh or of the smooth one.
fn compared<'a>(
    arguments: &Arguments,
    map: &HeightMap,
    base: &Base,
    lies: Lies,
    surfaces: &[&'a Measured],
    progress: &ProgressBar,
) -> Vec<Row<'a>> {
    let Arguments { views, width, scale, .. } = *arguments;
    let size = [width, width * 3 / 4];
    let bias = lies.bias_m(scale);
    let curved = Curved::new(base.mesh.clone(), map, scale, bias);
    let has_smooth = base.smooth.is_some();
    let truths = |of: &Measured| match of.beside {
        Beside::Itself => vec![false],
        Beside::Smooth => vec![has_smooth],
        Beside::Both if has_smooth => vec![false, true],
        Beside::Both => vec![false],
    };
    let row = |of: &'a Measured, smooth| Row { of, smooth, comparison: Comparison::default(), rims: vec![] };
    let mut rows: Vec<Row> =
        surfaces.iter().flat_map(|of| truths(of).into_iter().map(|smooth| row(of, smooth))).collect();
    let needs = |smooth: bool| rows.iter().any(|row| row.smooth == smooth);
    let own = needs(false).then(|| curved.judge());
    let smooth = base.smooth.as_ref().filter(|_| needs(true));
    let smooth = smooth.map(|mesh| Curved::new(mesh.clone(), map, scale, bias).judge());

    let (mut rng, mut renderer) = (Rng::new(1), Renderer::on_cpu());
    for _ in 0..views {
        let camera = curved.random_camera(&mut rng, 1.0);
        let judges =
            [&own, &smooth].map(|judge| judge.as_ref().map(|judge| Judged::new(judge, camera, size)));
        let mut shown: Option<(&str, Picture)> = None;
        for row in &mut rows {
            let hits = row.hits();
            let Row { of, smooth, comparison, rims } = row;
            // Rows of one surface follow each other.
            let picture = match shown.take().filter(|(name, _)| *name == of.name) {
                Some((_, picture)) => picture,
                None => {
                    let scene = curved.scene(of.drawn, camera, size, BackendChoice::Cpu);
                    Picture::rendered(&scene, &mut renderer)
                }
            };
            if let Some(truth) = &judges[usize::from(*smooth)] {
                if hits {
                    comparison.add(&picture, truth, &curved);
                } else {
                    comparison.add_outline(&picture, &truth.picture);
                    comparison.add_all_hits(&picture, truth, &curved);
                }
                if base.has_rims {
                    rims.extend(rims::distances(&picture, &truth.picture, camera, scale));
                }
            }
            shown = Some((of.name, picture));
        }
        progress.inc(1);
    }
    rows
}
