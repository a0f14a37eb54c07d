//! Units of elevation models: units of coordinate systems by EPSG code, heights of tie points,
//! depths, unknown and missing units, and units that a user gives.

use std::path::{Path, PathBuf};

use crate::common::files::png;
use crate::common::tiff_file::{Tiff, Value};
use crate::common::{Folder, default};
use relief_core::HeightMap;
use relief_io::{
    Convention, Elevation, Georeference, GivenUnits, HeightOptions, ReadProblem, SourceInfo, UnitOrigin,
    inspect, read_height,
};

const WIDTH: u32 = 40;
const HEIGHT: u32 = 24;

const FOOT: f64 = 0.3048;
const SURVEY_FOOT: f64 = 1200.0 / 3937.0;

/// Ramp that rises by 10 per texel.
fn ramp() -> Vec<f64> {
    (0..WIDTH * HEIGHT).map(|at| 500.0 + 10.0 * f64::from(at % WIDTH)).collect()
}

fn keys(keys: &[[u16; 2]]) -> (u16, Value) {
    let mut directory = vec![1, 1, 1, keys.len() as u16];
    keys.iter().for_each(|[key, value]| directory.extend([*key, 0, 1, *value]));
    (34735, Value::Short(directory))
}

/// Tags for texels of 10 units at (2,000,000, 300,000), or in degrees at (7, 46), with a tie point's height.
fn placed([scale_z, tie_z]: [f64; 2], numbers: &[[u16; 2]]) -> Vec<(u16, Value)> {
    let is_geographic = numbers.contains(&[1024, 2]);
    let (side, [x, y]) = if is_geographic { (0.001, [7.0, 46.0]) } else { (10.0, [2e6, 3e5]) };
    vec![
        (33550, Value::Double(vec![side, side, scale_z])),
        (33922, Value::Double(vec![0.0, 0.0, 0.0, x, y, tie_z])),
        keys(numbers),
    ]
}

fn file(folder: &Folder, extra: Vec<(u16, Value)>, values: &[f64]) -> PathBuf {
    folder.file("dem.tif", &Tiff { extra, ..Tiff::grey(WIDTH, HEIGHT, 32, 3) }.bytes(values))
}

fn write(folder: &Folder, heights: [f64; 2], numbers: &[[u16; 2]]) -> PathBuf {
    file(folder, placed(heights, numbers), &ramp())
}

fn read(path: &Path, options: &HeightOptions) -> HeightMap {
    read_height(path, options).unwrap_or_else(|error| panic!("{error}"))
}

fn look(path: &Path, options: &HeightOptions) -> SourceInfo {
    inspect(path, options).unwrap_or_else(|error| panic!("{error}"))
}

fn parts(info: SourceInfo) -> (Georeference, Elevation) {
    let elevation = info.values.and_then(|values| values.elevation).expect("it is an elevation model");
    (info.georeference.expect("it lies on the ground"), elevation)
}

fn given(units: &str) -> HeightOptions {
    HeightOptions { unit: Some(units.parse::<GivenUnits>().expect("units")), ..default() }
}

fn near(found: f64, expected: f64) -> bool {
    (found / expected - 1.0).abs() < 1e-9
}

#[test]
fn feet_are_known_by_epsg_codes() {
    let folder = Folder::new();
    // The ground's number, more keys, and metres of a unit along the ground and upward.
    for (number, more, ground, upward) in [
        (2271, &[[4096u16, 6360]] as &[_], SURVEY_FOOT, SURVEY_FOOT),
        (6597, &[[4096, 6360]], SURVEY_FOOT, SURVEY_FOOT),
        (2263, &[[4096, 6360]], SURVEY_FOOT, SURVEY_FOOT),
        (3089, &[[4096, 6360]], SURVEY_FOOT, SURVEY_FOOT),
        (2222, &[[4096, 6360]], FOOT, SURVEY_FOOT),
        (2222, &[[4096, 8228]], FOOT, FOOT),
        (2263, &[[3076, 9003], [4096, 5703]], SURVEY_FOOT, 1.0),
        (2263, &[[3076, 9001], [4096, 5703]], 1.0, 1.0),
        (32617, &[[4096, 6360]], 1.0, SURVEY_FOOT),
        (32617, &[[4096, 5754]], 1.0, 0.304_800_749_1),
        (27700, &[[4096, 5701]], 1.0, 1.0),
        (24382, &[[4096, 5703]], 0.914_398_530_744_440_8, 1.0),
        (2314, &[[4096, 5703], [4099, 9002]], 0.304_797_265_4, FOOT),
        (32617, &[[4096, 4979]], 1.0, 1.0),
        // A vertical system without a unit shares the ground's unit.
        (2263, &[[4096, 5103]], SURVEY_FOOT, SURVEY_FOOT),
        (2263, &[], SURVEY_FOOT, SURVEY_FOOT),
        (2222, &[], FOOT, FOOT),
        (32617, &[], 1.0, 1.0),
    ] {
        let path = write(&folder, [0.0; 2], &[&[[1024, 1], [3072, number]], more].concat());
        let map = read(&path, &default());
        let ([tile, _], span) = map.stated_lengths_m().expect("it is known");
        assert!(near(tile, 400.0 * ground), "EPSG:{number}: {tile} m");
        assert!(near(span, 390.0 * upward), "EPSG:{number} {more:?}: {span} m");
        let (georeference, elevation) = parts(look(&path, &default()));
        assert!(matches!(georeference.unit_origin, UnitOrigin::Epsg(_) | UnitOrigin::Key(3076)));
        let shares = more.is_empty() || more == [[4096, 5103]];
        assert_eq!(elevation.origin == UnitOrigin::Shared, shares, "{more:?}: {:?}", elevation.origin);
    }
}

#[test]
fn degrees_and_grads_are_known_by_epsg_codes() {
    let folder = Folder::new();
    let width = |numbers: &[[u16; 2]]| {
        let map = read(&write(&folder, [0.0; 2], numbers), &default());
        map.texel_size_m().expect("it is known")[1]
    };
    let [degrees, grads] = [4326, 4807].map(|number| width(&[[1024, 2], [2048, number]]));
    let by_key = width(&[[1024, 2], [2048, 4807], [2054, 9102]]);
    // The meridian is a little longer at 46 degrees than at 46 grads.
    assert!((grads / degrees - 0.9).abs() < 1e-3 && by_key == degrees, "{degrees} {grads} {by_key}");
    // Heights over degrees are metres, or what their system says.
    for (more, metres) in [(&[] as &[[u16; 2]], 1.0), (&[[4096, 6360]], SURVEY_FOOT), (&[[4096, 5773]], 1.0)]
    {
        let path = write(&folder, [0.0; 2], &[&[[1024, 2], [2048, 4326]], more].concat());
        let (_, elevation) = parts(look(&path, &default()));
        assert!(near(elevation.metres_per_unit.expect("it is known"), metres), "{more:?}: {elevation:?}");
        assert_eq!(elevation.origin == UnitOrigin::Assumed, more.is_empty());
    }
}

#[test]
fn unknown_epsg_codes_have_no_known_unit() {
    let folder = Folder::new();
    for number in [1, 31_000, 32_770, 4326, 5703, 40_000] {
        let path = write(&folder, [0.0; 2], &[[1024, 1], [3072, number], [4096, 5703]]);
        let map = read(&path, &default());
        assert_eq!((map.texel_size_m(), map.stated_lengths_m()), (None, None), "EPSG:{number}");
        let (georeference, _) = parts(look(&path, &default()));
        let reason = georeference.texel_size_m.expect_err("it is not known");
        assert!(reason.contains(&format!("EPSG:{number}")), "{reason}");
        // A given unit of heights is also the ground's if that has none.
        let lengths = read(&path, &given("ft")).stated_lengths_m().expect("it is given");
        assert!(near(lengths.0[0], 400.0 * FOOT) && near(lengths.1, 390.0 * FOOT), "{lengths:?}");
    }
    for number in [9999, 1, 2263] {
        let path = write(&folder, [0.0; 2], &[[1024, 1], [3072, 32617], [4096, number]]);
        let map = read(&path, &default());
        assert_eq!((map.physical_range(), map.stated_tile_m().is_some()), (None, true), "EPSG:{number}");
        let (_, elevation) = parts(look(&path, &default()));
        assert!(elevation.metres_per_unit.is_none() && elevation.unit.is_some(), "{elevation:?}");
    }
    let path = write(&folder, [0.0; 2], &[[1024, 2], [2048, 4978]]);
    assert_eq!(read(&path, &default()).texel_size_m(), None);
}

#[test]
fn proportions_are_known_without_a_unit() {
    let folder = Folder::new();
    let path = write(&folder, [0.0; 2], &[[1024, 1], [3072, 32767]]);
    let map = read(&path, &default());
    assert_eq!((map.texel_size_m(), map.stated_tile_m(), map.stated_lengths_m()), (None, None, None));
    assert_eq!(map.stated_lengths(), Some(([400.0, 240.0], 390.0)));
    assert_eq!(map.proportions(), [1.0, 0.6]);
    // The unit of heights is also the ground's.
    let path = write(&folder, [0.0; 2], &[[1024, 1], [3072, 32767], [4099, 9002]]);
    let (tile, span) = read(&path, &default()).stated_lengths_m().expect("it is known");
    assert!(near(tile[0], 400.0 * FOOT) && near(span, 390.0 * FOOT), "{tile:?} {span}");
    assert_eq!(parts(look(&path, &default())).0.unit_origin, UnitOrigin::Shared);
}

#[test]
fn given_units_win_over_the_file() {
    let folder = Folder::new();
    let feet = [[1024, 1], [3072, 2263], [4096, 6360]];
    let metres = [[1024, 1], [3072, 32617]];
    let nameless = [[1024, 1], [3072, 32767]];
    for (numbers, units, ground, upward) in [
        (feet.as_slice(), "m", SURVEY_FOOT, 1.0),
        (&feet, "cm,m", 1.0, 0.01),
        (&metres, "dm", 1.0, 0.1),
        (&metres, "ft,us-ft", SURVEY_FOOT, FOOT),
        (&nameless, "ft", FOOT, FOOT),
        (&nameless, "cm,m", 1.0, 0.01),
    ] {
        let path = write(&folder, [0.0; 2], numbers);
        let (tile, span) = read(&path, &given(units)).stated_lengths_m().expect("it is given");
        assert!(near(tile[0], 400.0 * ground) && near(span, 390.0 * upward), "{units}: {tile:?} {span}");
        assert_eq!(parts(look(&path, &given(units))).1.origin, UnitOrigin::Given);
    }
    // A picture becomes an elevation model by its unit, and degrees stay degrees.
    let path = folder
        .file("grey.png", &png(2, 2, ::png::ColorType::Grayscale, ::png::BitDepth::Eight, &[10, 20, 30, 40]));
    assert_eq!(read(&path, &given("dm")).physical_range(), Some([1.0, 4.0]));
    assert_eq!(read(&path, &default()).physical_range(), Some([0.0, 255.0]));
    let path = write(&folder, [0.0; 2], &[[1024, 2], [2048, 4326]]);
    let sizes = ["m", "ft", "cm,ft"].map(|units| read(&path, &given(units)).texel_size_m());
    assert!(sizes[0].is_some() && sizes.iter().all(|size| *size == sizes[0]), "{sizes:?}");
}

#[test]
fn tie_points_have_heights_if_there_is_a_vertical_system() {
    let folder = Folder::new();
    let with = [[1024, 1], [3072, 32633], [4096, 5773]];
    let without = [[1024, 1], [3072, 32633]];
    for (heights, numbers, expected) in [
        ([0.1, 50.0], with.as_slice(), [100.0, 139.0]),
        ([0.1, 50.0], &without, [500.0, 890.0]),
        ([0.0, 50.0], &with, [500.0, 890.0]),
        ([1.0, 0.0], &with, [500.0, 890.0]),
        ([1.0, -32.0], &with, [468.0, 858.0]),
        ([0.1, 50.0], &[[1024, 1], [3072, 32633], [4099, 9002]], [100.0 * FOOT, 139.0 * FOOT]),
        ([0.5, 0.0], &[[1024, 2], [2048, 4979]], [500.0, 890.0]),
    ] {
        let [least, greatest] =
            read(&write(&folder, heights, numbers), &default()).physical_range().expect("it is known");
        assert!(near(least, expected[0]) && near(greatest, expected[1]), "{heights:?}: {least} {greatest}");
    }
    // The raw value of the tie point has that height.
    let mut tags = placed([0.1, 50.0], &with);
    tags[1].1 = Value::Double(vec![0.0, 0.0, 500.0, 5e5, 4e6, 50.0]);
    let tied = |tags: Vec<(u16, Value)>| read(&file(&folder, tags, &ramp()), &default()).physical_range();
    let range = tied(tags.clone()).expect("it is known");
    assert!(near(range[0], 50.0) && near(range[1], 89.0), "{range:?}");
    // A matrix gives the same, and GDAL's entry for the band wins over both.
    let rows = [[10.0, 0.0, 0.0, 5e5], [0.0, -10.0, 0.0, 4e6], [0.0, 0.0, 0.1, 50.0], [0.0, 0.0, 0.0, 1.0]];
    let matrix = vec![(34264, Value::Double(rows.concat())), keys(&with)];
    let range = tied(matrix.clone()).expect("it is known");
    assert!(near(range[0], 100.0) && near(range[1], 139.0), "{range:?}");
    let item = "<GDALMetadata><Item sample=\"0\" role=\"scale\">2</Item></GDALMetadata>";
    let noted = [matrix, vec![(42112, Value::Text(item.into()))]].concat();
    assert_eq!(tied(noted), Some([1000.0, 1780.0]));
    for z in [-0.1, f64::NAN, f64::INFINITY] {
        let path = write(&folder, [z, 0.0], &with);
        let error = read_height(&path, &default()).expect_err("no such scale");
        assert!(matches!(error.problem, ReadProblem::Georeference { .. }), "{error}");
    }
}

#[test]
fn values_that_count_downward_are_depths() {
    let folder = Folder::new();
    for (vertical, more, metres) in [
        (5715, &[] as &[[u16; 2]], 1.0),
        (6357, &[], 1.0),
        (6359, &[], SURVEY_FOOT),
        (5614, &[], FOOT),
        (5715, &[[4099, 9002]], FOOT),
    ] {
        let path = write(&folder, [0.0; 2], &[&[[1024, 1], [3072, 32617], [4096, vertical]], more].concat());
        let map = read(&path, &default());
        assert_eq!((map.texel(0, 0), map.texel(39, 0)), (1.0, 0.0), "EPSG:{vertical}");
        let [deepest, shallowest] = map.physical_range().expect("it is known");
        assert!(near(deepest, -890.0 * metres) && near(shallowest, -500.0 * metres), "{deepest}");
        let asked = HeightOptions { convention: Some(Convention::Depth), ..default() };
        assert_eq!(read(&path, &asked), map);
        let heights = HeightOptions { convention: Some(Convention::Height), ..default() };
        assert_eq!(read(&path, &heights).texel(0, 0), 0.0);
        assert!(parts(look(&path, &default())).1.downward);
    }
    let path = write(&folder, [0.0; 2], &[[1024, 1], [3072, 32617], [4096, 5714]]);
    assert_eq!(read(&path, &default()).texel(0, 0), 0.0);
}
