//! Claims about triangles in grid space.

use comfy_table::Table;
use relief_core::rng::Rng;

/// The camera of the paper's figure 7: near 1, 90 degrees, 300 pixels.
const VOXEL: f64 = 2.0 / 300.0;

/// Corners in grid space.
type Triangle = [[i32; 3]; 3];

/// A row a claim: what is said, and what is found.
pub fn table(triangles: u32) -> Table {
    let mut rows = crate::table::table(&["claim", "found"]);
    rows.add_row(["every triangle has a primary edge", &primary_edges(triangles)]);
    rows.add_row([
        "the tangent between triangle and remeshing plane is at most 1.414",
        &stretches(triangles),
    ]);
    rows.add_row(["voxels are as deep as they are wide", &depths()]);
    rows.add_row(["a table over z holds equation 4", &tables()]);
    rows.add_row(["edges do not crack", &sums()]);
    rows.add_row(["512.2 KB for 512² heights and a cylinder of 34 vertices", &bytes()]);
    rows
}

fn length(triangle: &Triangle, k: usize, axis: usize) -> i32 {
    (triangle[(k + 1) % 3][axis] - triangle[k][axis]).abs()
}

/// The main direction of an edge: the first of those in which it is longest.
fn main(triangle: &Triangle, k: usize) -> usize {
    (0..3).rev().max_by_key(|&axis| length(triangle, k, axis)).unwrap_or_default()
}

fn is_primary(triangle: &Triangle, k: usize) -> bool {
    let axis = main(triangle, k);
    let [from, to, third] = [0, 1, 2].map(|next| triangle[(k + next) % 3][axis]);
    (from.min(to)..=from.max(to)).contains(&third)
}

fn random(random: &mut Rng, size: i32) -> Triangle {
    let mut corner = || [0; 3].map(|_: i32| (random.unit() * f64::from(size)) as i32);
    [corner(), corner(), corner()]
}

/// Triangles without a primary edge: random ones of three sizes, and all of a small lattice, which has many
/// ties.
fn primary_edges(count: u32) -> String {
    let mut numbers = Rng::new(1);
    let has_one = |triangle: &Triangle| (0..3).any(|k| is_primary(triangle, k));
    let sizes = [5, 50, 1000];
    let mut without = 0;
    for at in 0..count {
        without += u32::from(!has_one(&random(&mut numbers, sizes[at as usize % sizes.len()])));
    }
    let corner = |code: i32| [code % 5, code / 5 % 5, code / 25];
    let lattice = 125 * 125 * 125;
    for code in 0..lattice {
        let triangle = [corner(code % 125), corner(code / 125 % 125), corner(code / (125 * 125))];
        without += u32::from(!has_one(&triangle));
    }
    format!("{without} of {} have none", u64::from(count) + lattice as u64)
}

/// The tangent of the angle between a triangle and its remeshing plane: how much a footprint is stretched.
fn stretches(count: u32) -> String {
    let mut numbers = Rng::new(2);
    let (mut greatest, mut beyond, mut all) = (0.0_f64, 0, 0);
    for _ in 0..count {
        let triangle = random(&mut numbers, 1000);
        let [a, b, c] = triangle.map(|corner| corner.map(f64::from));
        let [p, q] = [b, c].map(|to| [0, 1, 2].map(|axis| to[axis] - a[axis]));
        let normal = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
        let size = normal.iter().map(|along| along * along).sum::<f64>().sqrt();
        let primary = (0..3).filter(|&k| is_primary(&triangle, k));
        let Some(primary) = primary.max_by_key(|&k| length(&triangle, k, main(&triangle, k))) else {
            continue;
        };
        let sweep = main(&triangle, primary);
        // The planes that hold the sweep: at right angles to one of the two other axes.
        let across = [(sweep + 1) % 3, (sweep + 2) % 3].map(|axis| normal[axis].abs());
        let widest = across[0].max(across[1]);
        if widest > 0.0 {
            let stretch = (size * size - widest * widest).max(0.0).sqrt() / widest;
            greatest = greatest.max(stretch);
            beyond += u32::from(stretch > std::f64::consts::SQRT_2 + 1e-9);
            all += 1;
        }
    }
    let percent = 100.0 * f64::from(beyond) / f64::from(all);
    format!("up to {greatest:.3}, beyond 1.414 of {percent:.1} % (at most the root of 5)")
}

/// Width over depth of voxels from z = 1 to 100.
fn depths() -> String {
    let places = || (0..=1000).map(|k| 100.0_f64.powf(f64::from(k) / 1000.0));
    let range = |of: &dyn Fn(f64) -> f64| {
        let [least, greatest] = places()
            .map(of)
            .fold([f64::INFINITY, 0.0], |[least, greatest]: [f64; 2], of| [least.min(of), greatest.max(of)]);
        format!("{least:.3} to {greatest:.3}")
    };
    // The depth of a voxel is one over the derivative of its number.
    let in_grid = range(&|z| VOXEL * z / ((1.0 + VOXEL).ln() * z));
    // As deep as it is wide at 10, and the same everywhere.
    let constant = range(&|z| z / 10.0);
    // Screen space: 1/z, as deep as it is wide at 10.
    let screen = range(&|z| z * 10.0 / (z * z));
    format!("width over depth: grid space {in_grid}, a constant step {constant}, screen space {screen}")
}

/// How far off a table of 4,096 numbers over z is, between which is interpolated.
fn tables() -> String {
    let number = |z: f64| z.ln() / (1.0 + VOXEL).ln();
    let off = |far: f64| {
        let at = |k: u32| 1.0 + (far - 1.0) * f64::from(k) / 4095.0;
        let between = |k: u32, part: f64| {
            let z = at(k) + (at(k + 1) - at(k)) * part;
            let found = number(at(k)) + (number(at(k + 1)) - number(at(k))) * part;
            (found - number(z)).abs()
        };
        let all = (0..4095).flat_map(|k| (1..64).map(move |part| between(k, f64::from(part) / 64.0)));
        all.fold(0.0, f64::max)
    };
    let [near, far] = [1e2, 1e4].map(off);
    format!("4,096 numbers: {near:.3} voxels off where far/near is 100, {far:.1} where it is 10,000")
}

/// Points of edges that are other bits from the other end, in 32 bits.
fn sums() -> String {
    let mut numbers = Rng::new(3);
    let mut of = |steps: u16| {
        let (mut summed, mut weighed, mut all) = (0, 0, 0);
        for _ in 0..2000 {
            let [a, b] = [numbers.unit() as f32, numbers.unit() as f32];
            let [forth, back] = [(a, b), (b, a)].map(|(from, to)| {
                let step = (to - from) / f32::from(steps);
                let sums = std::iter::successors(Some(from), |at| Some(at + step));
                let weighed =
                    (0..=steps).map(|k| (from * f32::from(steps - k) + to * f32::from(k)) / f32::from(steps));
                (sums.take(usize::from(steps) + 1).collect::<Vec<f32>>(), weighed.collect::<Vec<f32>>())
            });
            for k in 0..=usize::from(steps) {
                let other = usize::from(steps) - k;
                summed += u32::from(forth.0[k] != back.0[other]);
                weighed += u32::from(forth.1[k] != back.1[other]);
                all += 1;
            }
        }
        [summed, weighed].map(|different| 100.0 * f64::from(different) / f64::from(all))
    };
    let found = [4, 16, 64, 1024].map(|steps| (steps, of(steps)));
    let summed: Vec<String> =
        found.iter().map(|(steps, [summed, _])| format!("{summed:.1} % at {steps} parts")).collect();
    let weighed = found.iter().map(|(_, [_, weighed])| *weighed).fold(0.0, f64::max);
    format!("added up, other bits from the other end on {}; by weights on {weighed} %", summed.join(", "))
}

/// What map and base take, and what a strip of the same triangles.
fn bytes() -> String {
    let map = 512.0 * 512.0 * 2.0 + 34.0 * 12.0;
    // Two vertices a quad of three coordinates of two bytes.
    let strip = 512.0 * 512.0 * 2.0 * 6.0;
    format!("{:.1} KiB; a strip of three coordinates of two bytes {:.2} MiB", map / 1024.0, strip / 1048576.0)
}
