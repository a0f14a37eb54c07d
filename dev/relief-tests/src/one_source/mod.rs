//! One source, two backends: results of the shaders on a GPU, and of their translation to Rust for the same
//! input.
//!
//! The stages are given the same rays and must give the same bits; pictures must agree to rounding. The GPU
//! is a software adapter, which computes as IEEE 754 says.

pub mod adapter;
pub mod cases;
pub mod compare;
pub mod picture;
pub mod rays;
pub mod shells;

use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use relief_core::{MapFormat, Wrap};
use relief_render::gpu::Prober;
use relief_shaders::field::Solids;
use relief_shaders::wgsl::Sampling;
use relief_shaders::{Entry, Selection, detail, refine, search, shadow};

use cases::Draw;
use compare::Comparison;
use relief_core::rng::Rng;
use relief_testing::maps;

/// Rays over all legal pairs of search and refinement together. Times scale with it.
const RAYS: usize = 1_000_000;

/// Every shadow, with each search that it may send its rays by, or with one where it sends none.
fn shadows() -> Vec<[&'static Entry; 2]> {
    let mut shadows = Vec::new();
    for shadow in shadow::ENTRIES {
        for search in search::ENTRIES {
            let mut selection = Selection::default();
            selection.choose("shadow", shadow.name).expect("a listed name");
            selection.choose("shadow-search", search.name).expect("a listed name");
            let is_first = shadows.last().is_none_or(|[last, _]: &[&Entry; 2]| last.name != shadow.name);
            if selection.check().is_ok() && (is_first || !shadow.states.is_empty()) {
                shadows.push([shadow, search]);
            }
        }
    }
    shadows
}

/// A search and a refinement over every map.
struct Pair {
    /// Their numbers in their lists.
    numbers: [usize; 2],
    /// A draw for each map.
    draws: Vec<Draw>,
}

impl Pair {
    /// All legal pairs, drawn one after the other. Shadows go with the first of them, each with each search
    /// that it may send its rays by.
    fn all() -> Vec<Pair> {
        let mut rng = Rng::new(1);
        let mut pairs = Vec::new();
        let shadows = shadows();
        for (s, search) in search::ENTRIES.iter().enumerate() {
            for (r, refine) in refine::ENTRIES.iter().enumerate() {
                let pair = Selection::pair(search.name, refine.name).expect("listed names");
                if pair.check_pair().is_err() || pair.solids() != Solids::Heights {
                    continue;
                }
                let none = [shadow::ENTRIES.iter().find(|it| it.is_idle()).expect("no shadow"), search];
                let shadow = shadows.get(pairs.len()).copied().unwrap_or(none);
                // Every third in levels of detail, by turns in each way: most of the time goes into compiling
                // programs, and this way a pair has one.
                let in_levels = detail::ENTRIES.iter().skip(1);
                let number = pairs.len();
                let detail = in_levels.cycle().nth(number / 3).filter(|_| number % 3 == 0);
                let detail = detail.unwrap_or(&detail::ENTRIES[0]);
                let draw = |_| Draw::new([search, refine], shadow, detail, &mut rng);
                let draws = maps::ALL.iter().map(draw).collect();
                pairs.push(Pair { numbers: [s, r], draws });
            }
        }
        pairs
    }

    /// What CPU and GPU make of that many rays over each map.
    fn compare(&self, prober: &mut Prober, rays_a_case: usize) -> Comparison {
        let [s, r] = self.numbers;
        let (mut all, mut hits) = (Comparison::default(), 0);
        for (m, (map, draw)) in maps::ALL.iter().zip(&self.draws).enumerate() {
            // Every map in one wrap a pair, every wrap with each search and each refinement.
            let wrap = Wrap::ALL[(s + r + m) % Wrap::ALL.len()];
            let format = MapFormat::ALL[(s + m) % MapFormat::ALL.len()];
            let case = draw.over(map, wrap, format);
            let rays = rays::pixels(&case.map, rays_a_case, draw.seed);
            let cpu = case.on_cpu(&rays);
            let gpu = prober.probe(case.surface(), Sampling::Exact, &rays).expect("the probe runs");
            hits += cpu.iter().filter(|probe| probe.found == 1).count();
            all = all.plus(Comparison::new(&case, &rays, &cpu, &gpu));
        }
        let names = [search::ENTRIES[s].name, refine::ENTRIES[r].name];
        assert!(hits > rays_a_case * maps::ALL.len() / 2, "{names:?}: {hits} hits");
        all
    }
}

/// Number of tests that share the pairs. Most of the time goes into compiling programs.
pub const PARTS: usize = 4;

/// Compares the backends over one part of all legal pairs of search and refinement, by its number and the
/// number of parts. Does nothing without an adapter.
///
/// # Panics
///
/// When the stages have other bits, or an adapter is required and missing.
pub fn compare_part(part: usize) {
    let pairs = Pair::all();
    let rays_a_case = RAYS.div_ceil(pairs.len() * maps::ALL.len());
    let own: Vec<Pair> = pairs.into_iter().skip(part).step_by(PARTS).collect();
    let next = AtomicUsize::new(0);
    // An adapter compiles for one device at a time.
    let on_own_device = || {
        let mut prober = adapter::own_prober()?;
        let mut all = Comparison::default();
        while let Some(pair) = own.get(next.fetch_add(1, Ordering::Relaxed)) {
            all = all.plus(pair.compare(&mut prober, rays_a_case));
        }
        Some(all)
    };
    let compared = thread::scope(|scope| {
        let other = scope.spawn(on_own_device);
        let own = on_own_device();
        let other = other.join().unwrap_or_else(|panic| resume_unwind(panic));
        own.zip(other).map(|(own, other)| own.plus(other))
    });
    let Some(all) = compared else { return };
    println!("{} rays, {} differ, {} unexplained", all.rays, all.different, all.unexplained);
    assert_eq!(all.rays, own.len() * maps::ALL.len() * rays_a_case);
    all.check().expect("the same bits");
}
