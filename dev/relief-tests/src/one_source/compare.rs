//! Whether two backends gave the same answers.

use relief_core::Path;
use relief_shaders::cpu::{PixelIn, Probe, Program, Shared};

use super::cases::{Case, probe};

/// Number of rays among which fewer than one may have other bits.
const RAYS_PER_DIFFERENCE: usize = 10_000;

/// How far a ray whose bits differ may be from the decision that came out differently, in heights. It must be
/// as large as the rounding of a few operations on heights near 1; larger would excuse answers that are
/// wrong.
const MARGIN: f64 = ROUNDINGS as f64 * f32::EPSILON as f64;

/// The roundings of a height near 1 by which a path is moved, at most, to find the other side of a decision:
/// the margin.
const ROUNDINGS: i8 = 16;

/// Relative difference that rounding makes in a path or an interval.
const RELATIVE: f64 = 1e-5;

/// Numbers of compared rays and of their differences.
#[derive(Clone, Debug, Default)]
pub struct Comparison {
    /// Rays that were compared.
    pub rays: usize,
    /// Rays with other bits.
    pub different: usize,
    /// Differences that no decision within the margin explains.
    pub unexplained: usize,
    /// The first of these, or else of the different ones.
    pub example: Option<String>,
}

impl Comparison {
    /// Compares the answers of two backends to the same rays.
    pub fn new(case: &Case, rays: &[PixelIn], cpu: &[Probe], gpu: &[Probe]) -> Self {
        assert_eq!([cpu.len(), gpu.len()], [rays.len(); 2], "an answer a ray");
        let program = case.program();
        let mut comparison = Self { rays: rays.len(), ..Self::default() };
        for (number, (cpu, gpu)) in cpu.iter().zip(gpu).enumerate() {
            if bits(cpu) == bits(gpu) {
                continue;
            }
            comparison.different += 1;
            let explained = is_explained(case, &program, &rays[number], gpu);
            let first = comparison.unexplained == 0;
            comparison.unexplained += usize::from(!explained);
            if comparison.example.is_none() || (first && !explained) {
                let example = format!("{}, ray {number}:\n  CPU {cpu:?}\n  GPU {gpu:?}", case.name);
                comparison.example = Some(example);
            }
        }
        comparison
    }

    /// Both comparisons together.
    pub fn plus(self, other: Self) -> Self {
        let (first, second) =
            if self.unexplained > 0 { (self.example, other.example) } else { (other.example, self.example) };
        Self {
            rays: self.rays + other.rays,
            different: self.different + other.different,
            unexplained: self.unexplained + other.unexplained,
            example: first.or(second),
        }
    }

    /// Whether the backends agree; the error says where not.
    pub fn check(&self) -> Result<(), String> {
        if self.unexplained == 0 && self.different * RAYS_PER_DIFFERENCE < self.rays.max(1) {
            return Ok(());
        }
        let Self { rays, different, unexplained, example } = self;
        let example = example.as_deref().unwrap_or_default();
        Err(format!("of {rays} rays {different} differ, {unexplained} beyond the margin; {example}"))
    }
}

/// The bits of an answer, with one sign of zero, which shaders need not keep (WGSL, section "Floating point
/// accuracy").
fn bits(probe: &Probe) -> [u8; Probe::SIZE] {
    let mut probe = *probe;
    let floats = [
        &mut probe.entry.x,
        &mut probe.entry.y,
        &mut probe.duv.x,
        &mut probe.duv.y,
        &mut probe.exit,
        &mut probe.base,
        &mut probe.h.x,
        &mut probe.h.y,
        &mut probe.h.z,
        &mut probe.near,
        &mut probe.far,
        &mut probe.uv.x,
        &mut probe.uv.y,
        &mut probe.height,
        &mut probe.t,
        &mut probe.lit,
        &mut probe.key,
    ];
    for float in floats {
        *float += 0.0;
    }
    let mut bytes = [0; Probe::SIZE];
    probe.write(&mut bytes);
    bytes
}

/// Whether an answer is right for a path that lies at most the margin above or below the ray's own.
fn is_explained(case: &Case, program: &Program, ray: &PixelIn, gpu: &Probe) -> bool {
    let moved = (-ROUNDINGS..=ROUNDINGS).map(|by| probe(program, ray, f32::from(by) * f32::EPSILON));
    let alike: Vec<Option<Probe>> = moved
        .map(|near| Some(near).filter(|near| same_path(near, gpu) && decided(near) == decided(gpu)))
        .collect();
    if gpu.found == 0 {
        return alike.iter().flatten().any(|near| same_miss(near, gpu));
    }
    let at = program.enter(*ray);
    let path = Path::from(&program.segment(*ray, at, gpu.segment.max(1) - 1));
    // Where the path runs along the surface, paths that barely differ end far apart, with all of the surface
    // between.
    let between = alike.windows(2).any(|pair| match pair {
        [Some(a), Some(b)] => {
            (a.t.min(b.t)..=a.t.max(b.t)).contains(&gpu.t) && on_surface(case, &path, [a, b, gpu])
        }
        _ => false,
    });
    let here = |near: &Probe| close(near.t, gpu.t, RELATIVE * path.exit);
    alike.iter().flatten().any(|near| (between || here(near)) && same_place(&path, near, gpu))
}

fn close(a: f32, b: f32, slack: f64) -> bool {
    (f64::from(a) - f64::from(b)).abs() <= slack
}

/// What search and refinement decided.
fn decided(probe: &Probe) -> [u32; 3] {
    [probe.status, probe.found, probe.exhausted]
}

/// Whether the surface stage gave the same path, to rounding.
fn same_path(a: &Probe, b: &Probe) -> bool {
    let numbers = |p: &Probe| [p.entry.x, p.entry.y, p.duv.x, p.duv.y, p.exit, p.base, p.h.x, p.h.y, p.h.z];
    let relative = |(a, b): (f32, f32)| close(a, b, RELATIVE * f64::from(a).abs().max(1e-6));
    a.segment == b.segment && numbers(a).into_iter().zip(numbers(b)).all(relative)
}

/// Whether two searches without a hit ended alike, to rounding.
fn same_miss(a: &Probe, b: &Probe) -> bool {
    let slack = RELATIVE * f64::from(a.exit);
    close(a.near, b.near, slack) && close(a.far, b.far, slack)
}

/// Whether answers lie as high above the surface as each other, in `f64`.
fn on_surface(case: &Case, path: &Path, answers: [&Probe; 3]) -> bool {
    let [a, b, c] = answers.map(|answer| path.clearance(&case.map, answer.t.into()));
    (a - c).abs() <= MARGIN && (b - c).abs() <= MARGIN
}

/// Whether two hits are as far apart as their parameters say.
fn same_place(path: &Path, a: &Probe, b: &Probe) -> bool {
    let apart = (f64::from(a.t) - f64::from(b.t)).abs();
    let aside = |axis: usize| apart * path.duv[axis].abs() + RELATIVE * (1.0 + path.uv[axis].abs());
    close(a.uv.x, b.uv.x, aside(0))
        && close(a.uv.y, b.uv.y, aside(1))
        && close(a.height, b.height, apart * path.h[1].abs() + MARGIN)
}
