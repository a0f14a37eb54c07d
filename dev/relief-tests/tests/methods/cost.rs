//! What a ray costs, where it can be counted by hand.

use relief_core::exact::{FastTracer, PyramidTracer, cell_walk};
use relief_core::{Cost, HeightMap, MapFormat, Path, Wrap};
use relief_shaders::Selection;
use relief_shaders::cpu::MethodTracer;
use relief_tests::baked::{maps_in, slots};

/// A plain at half height.
fn plain(side: u32) -> HeightMap {
    HeightMap::from_fn(side, side, Wrap::Repeat, |_, _| 0.5).expect("a valid map")
}

/// A path that stays above the plain and goes through three cells in a row of a map of 16 columns.
fn over() -> Path {
    Path::between([0.3, 0.3, 1.0], [0.45, 0.3, 0.8])
}

/// A path straight down that meets the plain half way.
fn down() -> Path {
    Path::between([0.3, 0.3, 1.0], [0.3, 0.3, 0.0])
}

fn cost(reads: u32, steps: u32, bytes: u32) -> Cost {
    Cost { reads, steps, bytes }
}

/// What a search and a refinement with those settings pay for a path over the plain.
fn paid(pair: [&str; 2], settings: &[(&str, f64)], format: MapFormat, path: &Path) -> Cost {
    let mut selection = Selection::pair(pair[0], pair[1]).expect("listed names");
    for (name, value) in settings {
        selection.set(name, *value).expect("a setting");
    }
    let heights = plain(16);
    let maps = maps_in(format, &heights, &selection);
    MethodTracer::over(&heights, &selection, slots(&heights, &selection, &maps)).first_hit(path).cost
}

#[test]
fn reads_of_heights_are_of_sixteen_bytes() {
    let of =
        |pair: [&str; 2], settings: &[(&str, f64)], path: &Path| paid(pair, settings, MapFormat::F32, path);
    let eight = [("search.steps", 8.0)];
    assert_eq!(of(["none", "none"], &[], &down()), cost(0, 0, 0));
    assert_eq!(of(["none", "offset"], &[], &down()), cost(1, 0, 16));
    // The beginning of the path is read before the first step.
    assert_eq!(of(["linear", "none"], &eight, &over()), cost(9, 8, 144));
    assert_eq!(of(["linear", "none"], &eight, &down()), cost(5, 4, 80));
    assert_eq!(of(["linear", "binary"], &[eight[0], ("refine.steps", 5.0)], &down()), cost(10, 9, 160));
    assert_eq!(of(["cells", "patch"], &[], &over()), cost(3, 3, 48));
    // A cell of the search, and the same one of the refinement.
    assert_eq!(of(["cells", "patch"], &[], &down()), cost(2, 2, 32));
}

#[test]
fn reads_of_a_map_are_of_its_texels() {
    let step = |search, refine, [channels, texels, reads_of_heights, reads_of_map]: [u32; 4]| {
        for format in MapFormat::ALL {
            let bytes = 16 * reads_of_heights + texels * channels * format.bytes() as u32;
            let expected = cost(reads_of_heights + reads_of_map, 1, bytes);
            assert_eq!(paid([search, refine], &[], format, &over()), expected, "{search} {format:?}");
        }
    };
    // All of these pass over the plain in one step: a cone reads a height and a texel.
    step("cone", "patch", [1, 1, 1, 1]);
    step("frustum", "patch", [4, 1, 1, 1]);
    step("pyramid", "patch", [2, 1, 0, 1]);
    step("dilation-erosion", "patch", [2, 1, 0, 1]);
    // Between four texels, in one slice and in two.
    step("cone-moved", "none", [1, 4, 1, 1]);
    step("sphere", "patch", [1, 8, 0, 2]);
    // The height where the path ends tells whether a relaxed cone was entered.
    step("relaxed-cone", "patch", [1, 1, 2, 1]);
    step("relaxed-cone-resting", "patch", [1, 1, 2, 1]);
}

#[test]
fn a_pyramid_over_texels_ends_at_a_single_height() {
    // Four nodes of two floats, and a texel of the 16.
    let paid = paid(["pyramid-texels", "none"], &[], MapFormat::F32, &down());
    assert_eq!(paid, cost(5, 5, 4 * 8 + 4));
}

#[test]
fn a_pyramid_over_texels_ends_where_it_is_told_to() {
    let paid = |level| paid(["pyramid-texels", "none"], &[("search.level", level)], MapFormat::F32, &down());
    assert_eq!((paid(2.0), paid(20.0)), (cost(3, 3, 3 * 8), cost(1, 1, 8)));
}

#[test]
fn exact_tracers_count_nodes_and_cells() {
    assert_eq!(cell_walk(&plain(16), &over()).hit.cost, cost(3, 3, 48));
    let heights = plain(4);
    // A piece of the path with its node, and a cell.
    assert_eq!(PyramidTracer::new(&heights).trace(&down()).hit.cost, cost(2, 2, 4 + 16));
    // A block of nodes, a tile and a cell.
    assert_eq!(FastTracer::new(&heights).trace(&down()).hit.cost, cost(3, 3, 64 + 100 + 16));
}
