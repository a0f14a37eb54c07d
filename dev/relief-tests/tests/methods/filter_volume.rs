//! Filter levels of real maps: how much nearer to the relief they are than averages.

use relief_bake::{Filter, filter_level};
use relief_core::{HeightMap, Watch, Wrap};
use relief_io::{HeightOptions, read_height};
use relief_tests::{accuracy, data_dir};

/// The most volume over the average's that is promised of natural maps whose heights have more than 8 bits.
const MOST: f64 = 0.85;

/// Side of the part of each map that is looked at.
const SIDE: u32 = 192;

/// Points a texel of the map along either axis.
const POINTS: u32 = 5;

/// The volume between the surfaces.
fn volume(map: &HeightMap, level: &HeightMap) -> f64 {
    let [columns, rows] = [map.width() * POINTS, map.height() * POINTS];
    let points = (0..rows).flat_map(|row| (0..columns).map(move |column| [column, row]));
    let apart = points.map(|[column, row]| {
        let u = (f64::from(column) + 0.5) / f64::from(columns);
        let v = (f64::from(row) + 0.5) / f64::from(rows);
        (level.height_at(u, v) - map.height_at(u, v)).abs()
    });
    apart.sum::<f64>() / f64::from(columns) / f64::from(rows)
}

#[test]
fn variational_levels_of_natural_maps_are_nearer_than_averages() {
    let mut files = vec![accuracy::sample_maps().join("jacksboro.png")];
    match data_dir() {
        Some(folder) => {
            let names = ["t3d_terrain1.exr", "t3d_mountain1.exr", "t3d_stones.exr", "godot_wool_depth.png"];
            files.extend(names.map(|name| folder.join(name)));
        }
        None => println!("skipped but for a shipped map: RELIEF_DATA names no folder of data"),
    }
    for file in files {
        let map = read_height(&file, &HeightOptions::default()).expect("a map");
        let size = [map.width(), map.height()].map(|side| side.min(SIDE));
        let part = HeightMap::from_fn(size[0], size[1], Wrap::Clamp, |i, j| map.texel(i.into(), j.into()));
        let part = part.expect("a valid map");
        for number in 1..=3 {
            let of = |filter| {
                let level = filter_level(&part, number, filter, &Watch::none()).expect("not cancelled");
                volume(&part, &level)
            };
            let [average, squares, variational] =
                [Filter::Average, Filter::LeastSquares, Filter::Variational].map(of);
            let ratios = [squares / average, variational / average];
            println!("{}, level {number}: {ratios:.3?}", file.display());
            assert!(
                ratios[1] <= MOST && variational <= squares,
                "{}, level {number}: {ratios:?}",
                file.display()
            );
        }
    }
}
