#!/usr/bin/env bash
# obvhs 0.4.0 takes time that grows with the square for a plain row of equal cubes.
#
# What one expects: PLOC joins pairs of neighbours in rounds and nearly halves their number in each, so that twice
# as many boxes take about twice as long. What happens: of two neighbours that are equally good the builder takes
# the later one (it compares by "less or equal"). In an evenly spaced row every box so points to the next one. Only
# the last two point to each other, and each round joins a single pair. Boxes that grow along the row, as slices
# through a view do, end the same way without any tie: the best neighbour is always the smaller one.
#
# Shown in one thread with 16,000 boxes: a row of cubes and a row of growing boxes take hundreds of times as long as
# a row with uneven gaps, and eight times the boxes take about 64 times the time. Rows of posts, steps, stacked
# layers and slices are such input. Needs cargo and a registry. Fails where it is no longer so.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir src
cat >Cargo.toml <<'T'
[package]
name = "probe"
version = "0.0.0"
edition = "2024"
[dependencies]
obvhs = { version = "=0.4.0", default-features = false }
T
cat >src/main.rs <<'T'
use obvhs::aabb::Aabb;
use obvhs::ploc::{PlocBuilder, PlocSearchDistance, SortPrecision};
use std::time::Instant;

fn milliseconds(boxes: &[Aabb]) -> f64 {
    let best = (0..3).map(|_| {
        let started = Instant::now();
        let all = (0..boxes.len() as u32).collect();
        let tree = PlocBuilder::new().build(PlocSearchDistance::VeryLow, boxes, all, SortPrecision::U64, 0);
        assert_eq!(tree.nodes.len(), 2 * boxes.len() - 1);
        1e3 * started.elapsed().as_secs_f64()
    });
    best.fold(f64::INFINITY, f64::min)
}

fn main() {
    let aabb = |low: [f32; 3], high: [f32; 3]| Aabb::new(low.into(), high.into());
    let row = |n: usize, cube: &mut dyn FnMut(f32) -> Aabb| (1..=n).map(|k| cube(k as f32)).collect::<Vec<_>>();
    let cubes = |n| row(n, &mut |k| aabb([0.0, 0.0, k], [1.0, 1.0, k + 1.0]));
    let growing = |n| row(n, &mut |k| aabb([-k, -k, k], [k, k, k]));
    let uneven = |n| {
        // A chaotic sequence of gaps, always the same.
        let (mut at, mut gap) = (0.0, 0.3);
        row(n, &mut |_| {
            gap = 3.9 * gap * (1.0 - gap);
            at += 1.0 + gap;
            aabb([0.0, 0.0, at], [1.0, 1.0, at + 1.0])
        })
    };
    let kinds: [(&str, &dyn Fn(usize) -> Vec<Aabb>); 3] =
        [("cubes", &cubes), ("growing", &growing), ("uneven", &uneven)];
    for (name, boxes) in kinds {
        let [few, many] = [2000, 16000].map(|n| milliseconds(&boxes(n)));
        println!("{name}: 2,000 in {few:.2} ms, 16,000 in {many:.2} ms");
        println!("as_number {name} {} {}", many as u64, (many / few) as u64);
    }
}
T
cargo run --release --quiet >said 2>log || { cat log; exit 1; }
grep -v as_number said
number() { awk -v name="$1" -v place="$2" '$1 == "as_number" && $2 == name { print $place }' said; }
uneven=$(number uneven 3)
for name in cubes growing; do
    [ "$(number $name 3)" -ge $((30 * (uneven + 1))) ] || { echo "changed: $name are nearly as quick as an uneven row"; exit 1; }
    [ "$(number $name 4)" -ge 30 ] || { echo "changed: $name no longer take time by their square"; exit 1; }
done
echo 'as described'
