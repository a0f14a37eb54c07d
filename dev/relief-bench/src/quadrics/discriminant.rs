//! Where a line across the ray meets the quadric, and what happens where it does not.

use comfy_table::Table;
use glam::DVec3;
use relief_core::rng::Rng;
use relief_tests::curved::quantile;

use crate::table::table;

/// Points of a ray that are looked at.
const SAMPLES: u32 = 64;

/// How long a ray may be, in depths of the relief.
const LONGEST: f64 = 20.0;

/// Prints how often the discriminant of equation 6 is negative, for quadrics whose curvatures have these
/// signs: the paper's, positive where the base is convex. The relief is 1 deep.
pub fn measured(rays: u32) -> Table {
    let mut rows = table(&[
        "curvatures",
        "points in the relief",
        "discriminant below 0",
        "rays that change over",
        "jump p50",
        "p95",
    ]);
    for (name, signs) in [
        ("convex", [1.0, 1.0]),
        ("cylinder", [1.0, 0.0]),
        ("saddle", [1.0, -1.0]),
        ("concave", [-1.0, -1.0]),
        ("hollow cylinder", [-1.0, 0.0]),
    ] {
        let mut rng = Rng::new(3);
        let [mut inside, mut negative, mut changing] = [0_u64; 3];
        let mut jumps = Vec::new();
        for _ in 0..rays {
            let [a, b] = signs.map(|sign| sign * rng.between(0.01_f64.ln(), 1.0_f64.ln()).exp());
            let mut ray = rng.direction();
            ray.z = ray.z.abs();
            let points = along([a, b], ray);
            inside += points.len() as u64;
            negative += points.iter().filter(|point| point.across.is_none()).count() as u64;
            let changes =
                points.windows(2).filter(|pair| pair[0].across.is_some() != pair[1].across.is_some());
            let mut changes_over = false;
            for pair in changes {
                changes_over = true;
                let there = pair.iter().find_map(|point| Some((point.across? - point.below).abs()));
                jumps.extend(there);
            }
            changing += u64::from(changes_over);
        }
        rows.add_row([
            name.to_owned(),
            inside.to_string(),
            format!("{:.2} %", 100.0 * negative as f64 / inside.max(1) as f64),
            format!("{:.2} %", 100.0 * changing as f64 / f64::from(rays)),
            format!("{:.3}", quantile(&jumps, 0.5)),
            format!("{:.3}", quantile(&jumps, 0.95)),
        ]);
    }
    rows
}

/// A point of a ray in the relief.
struct Point {
    /// How far it is below the quadric along the normal (equation 7).
    below: f64,
    /// How far it is from the quadric across the ray (equation 6), where the line across meets it.
    across: Option<f64>,
}

/// The points of a ray that are in the relief, from where it enters the base to where it first leaves.
fn along([a, b]: [f64; 2], ray: DVec3) -> Vec<Point> {
    let normal = DVec3::Z;
    let across = (ray * ray.dot(normal) - normal).normalize_or_zero();
    let form = |p: DVec3, q: DVec3| a * p.x * q.x + b * p.y * q.y;
    let point = |step: u32| {
        let at = ray * (LONGEST * f64::from(step) / f64::from(SAMPLES));
        let below = at.z - form(at, at);
        // The point `at + s across` lies on the quadric, the nearer one outward.
        let [two, one, none] = [form(across, across), 2.0 * form(at, across) - across.z, -below];
        let discriminant = one * one - 4.0 * two * none;
        let across = (discriminant >= 0.0).then(|| {
            let root = discriminant.sqrt();
            if one + root == 0.0 { below } else { -2.0 * none / (one + root) }
        });
        Point { below, across }
    };
    (1..=SAMPLES).map(point).take_while(|point| (0.0..=1.0).contains(&point.below)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_from_a_plane_are_those_of_geometry() {
        let ray = DVec3::new(0.6, 0.0, 0.8);
        for point in along([0.0, 0.0], ray) {
            // Across the ray a plane is farther away by one over the sine of the angle to its normal.
            let across = point.across.expect("a plane is met");
            assert!((across * 0.6 - point.below).abs() < 1e-12, "{across} {}", point.below);
        }
    }

    #[test]
    fn lines_across_always_meet_a_convex_quadric() {
        let mut rng = Rng::new(5);
        for _ in 0..1000 {
            let mut ray = rng.direction();
            ray.z = ray.z.abs();
            assert!(along([rng.unit(), rng.unit()], ray).iter().all(|point| point.across.is_some()));
        }
    }
}
