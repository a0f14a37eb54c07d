//! Comparison of displacement methods with the truth and with each other: errors of hits, their
//! costs, and pictures.
//!
//! A [`Comparison`] is a scene with the methods and settings to compare. It produces [`Records`],
//! the figures, and the pictures that they describe. [`page`] makes a self-contained HTML page of
//! both.
//!
//! ```
//! use relief_compare::{Comparison, Contender};
//! use relief_core::{HeightMap, Wrap};
//! use relief_core::mesh::square;
//! use relief_scene::{Scene, Surface};
//!
//! let heights = HeightMap::from_fn(64, 64, Wrap::Repeat, |i, j| ((i ^ j) & 8) as f32 / 8.0)?;
//! let surface = Surface::new(square(1)?, heights.with_displacement(0.05, -0.05)?);
//! let mut comparison = Comparison::new("steps", Scene::builder(surface).size(32, 24).build()?);
//! comparison.contenders = vec![Contender::named("relief")?, Contender::named("cone")?];
//! comparison.rays = 500;
//! (comparison.flicker_samples, comparison.timing) = (None, None);
//! let compared = comparison.run(&relief_core::Watch::none())?;
//! let p99 = |method: &str| {
//!     let of_method = compared.records.rays.iter().filter(|record| record.method.method == method);
//!     of_method.map(|record| record.error.p99_texels).fold(0.0, f64::max)
//! };
//! assert!(p99("cone") < p99("relief"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod case;
mod choose;
pub mod columns;
mod comparison;
mod contender;
mod csv;
mod error;
mod exact_hits;
mod exact_picture;
pub mod explain;
pub mod figure;
mod page;
pub mod picture;
pub mod rays;
mod record;
mod run;
mod spread;

/// Height map for trying methods: a PNG of 256 x 256 texels of 16 bits, computed cobbles that tile.
pub const COBBLES_PNG: &[u8] = include_bytes!("../data/cobbles.png");

pub use case::{Case, cost, hits, judged};
pub use choose::{Candidate, Goal, Ranking, choose, with_other_steps};
pub use comparison::{Comparison, Machine, MachineBackend, Timing};
pub use contender::{Contender, shadow};
pub use csv::csv;
pub use error::CompareError;
pub use exact_hits::ExactHits;
pub use exact_picture::ExactPicture;
pub use page::page;
pub use record::{
    About, CostRecord, ErrorRecord, LeftOut, MachineRecord, MethodRecord, PictureRecord, RayRecord, Records,
    TimeRecord,
};
pub use run::reference::EXACT_HITS;
pub use run::{Compared, MethodDrawing, MethodPicture, Reference, Renderers};
