//! GeoTIFF elevation models: a tent of known slopes in metres is read correctly however the file
//! stores it. Impossible georeferences are refused.

use std::path::{Path, PathBuf};

use crate::common::files::png;
use crate::common::tiff_file::{Tiff, Value};
use crate::common::{Folder, default};
use relief_core::{HeightMap, Wrap};
use relief_io::{
    CoordinateSystem, Fill, HeightOptions, ReadProblem, Source, SourceInfo, inspect, read_ground, read_height,
};

const WIDTH: u32 = 24;
const HEIGHT: u32 = 18;

/// Texel of the tent's top: nearer to the west and to the north.
const TOP: [u32; 2] = [7, 5];

/// Tags of a georeference, for `Tiff::extra`.
type Tags = Vec<(u16, Value)>;

/// A tent in metres: it falls by 45 degrees to each side of the top's column and of its row.
fn tent(texel_m: [f64; 2], top_m: f64) -> Vec<f64> {
    let texels = (0..HEIGHT).flat_map(|j| (0..WIDTH).map(move |i| [i, j]));
    let away = |at: u32, top: u32, side: f64| f64::from(at.abs_diff(top)) * side;
    texels.map(|[i, j]| top_m - away(i, TOP[0], texel_m[0]) - away(j, TOP[1], texel_m[1])).collect()
}

fn scale(x: f64, y: f64) -> (u16, Value) {
    (33550, Value::Double(vec![x, y, 0.0]))
}

/// The coordinates of the first texel's corner.
fn tie(x: f64, y: f64) -> (u16, Value) {
    (33922, Value::Double(vec![0.0, 0.0, 0.0, x, y, 0.0]))
}

fn keys(keys: &[[u16; 2]]) -> (u16, Value) {
    let mut directory = vec![1, 1, 0, keys.len() as u16];
    keys.iter().for_each(|[key, value]| directory.extend([*key, 0, 1, *value]));
    (34735, Value::Short(directory))
}

fn matrix(rows: [[f64; 4]; 2]) -> (u16, Value) {
    let [x, y] = rows;
    (34264, Value::Double([x, y, [0.0; 4], [0.0, 0.0, 0.0, 1.0]].concat()))
}

/// The metadata that GDAL writes for these items of band, role and text.
fn metadata(items: &[(usize, &str, &str)]) -> (u16, Value) {
    let items: String = items
        .iter()
        .map(|(band, role, text)| {
            format!(
                "  <Item name=\"{}\" sample=\"{band}\" role=\"{role}\">{text}</Item>\n",
                role.to_uppercase()
            )
        })
        .collect();
    (
        42112,
        Value::Text(format!("<GDALMetadata>\n  <Item name=\"AREA\">all</Item>\n{items}</GDALMetadata>\n")),
    )
}

/// A projected system in metres with texels of that size, and more.
fn projected(size: [f64; 2], more: Tags) -> Tags {
    let ground = [scale(size[0], size[1]), tie(5e5, 4e6), keys(&[[1024, 1], [3072, 32617], [3076, 9001]])];
    let replaced = |tag: &(u16, Value)| more.iter().any(|(other, _)| *other == tag.0);
    let kept = ground.into_iter().filter(|tag| !replaced(tag)).collect::<Tags>();
    [kept, more].concat()
}

fn grey(bits: u16, format: u16, extra: Tags) -> Tiff {
    Tiff { extra, block_rows: 5, ..Tiff::grey(WIDTH, HEIGHT, bits, format) }
}

fn write(folder: &Folder, tiff: &Tiff, values: &[f64]) -> PathBuf {
    folder.file("dem.tif", &tiff.bytes(values))
}

fn read(path: &Path, options: &HeightOptions) -> HeightMap {
    read_height(path, options).unwrap_or_else(|error| panic!("{error}"))
}

fn look(path: &Path) -> SourceInfo {
    inspect(path, &default()).unwrap_or_else(|error| panic!("{error}"))
}

/// Fails unless the map is the tent with these texels. Checks its top in metres, and its slopes in degrees
/// along `u` and `v` at all texels that are not skipped.
fn assert_tent(map: &HeightMap, texel_m: [f64; 2], top_m: f64, skip: impl Fn(u32, u32) -> bool) {
    let size = map.texel_size_m().expect("the size of a texel is known");
    let [zero, one] = map.physical_range().expect("the metres are known");
    for axis in 0..2 {
        assert!((size[axis] / texel_m[axis] - 1.0).abs() < 1e-4, "texels of {size:?} m, not {texel_m:?} m");
    }
    let metres = |i: u32, j: u32| zero + f64::from(map.texel(i64::from(i), i64::from(j))) * (one - zero);
    let mut compared = 0;
    for (i, j) in (0..HEIGHT).flat_map(|j| (0..WIDTH).map(move |i| (i, j))) {
        for (axis, (k, l)) in [(i + 1, j), (i, j + 1)].into_iter().enumerate() {
            if k == WIDTH || l == HEIGHT || skip(i, j) || skip(k, l) {
                continue;
            }
            let degrees = ((metres(k, l) - metres(i, j)) / size[axis]).atan().to_degrees();
            let rises = if axis == 0 { i < TOP[0] } else { j < TOP[1] };
            let expected = if rises { 45.0 } else { -45.0 };
            assert!((degrees - expected).abs() < 0.1, "({i}, {j}) axis {axis}: {degrees} degrees");
            compared += 1;
        }
    }
    assert!(compared > 400, "{compared} slopes");
    assert!((metres(TOP[0], TOP[1]) - top_m).abs() < 1e-3, "the top is at {} m", metres(TOP[0], TOP[1]));
    assert_eq!(map.wrap(), Wrap::Clamp);
}

fn nowhere(_: u32, _: u32) -> bool {
    false
}

#[test]
fn a_tent_in_metres_and_one_of_oblong_texels() {
    let folder = Folder::new();
    for size in [[2.0, 2.0], [6.0, 2.0], [2.0, 6.0]] {
        let path = write(&folder, &grey(32, 3, projected(size, vec![])), &tent(size, 1234.5));
        assert_tent(&read(&path, &default()), size, 1234.5, nowhere);
    }
}

#[test]
fn a_tent_in_degrees() {
    let folder = Folder::new();
    // A thousandth of a degree at 45 degrees north, on the WGS 84 ellipsoid.
    let size = [78.846_805, 111.131_745];
    let top = 45.0 + 0.001 * f64::from(HEIGHT) / 2.0;
    let ground = vec![scale(0.001, 0.001), tie(7.0, top), keys(&[[1024, 2], [2048, 4326], [2054, 9102]])];
    let path = write(&folder, &grey(32, 3, ground), &tent(size, 3000.0));
    assert_tent(&read(&path, &default()), size, 3000.0, nowhere);
    let georeference = look(&path).georeference.expect("it has one");
    assert_eq!((georeference.system, georeference.epsg), (CoordinateSystem::Geographic, Some(4326)));
}

#[test]
fn a_tent_in_web_mercator() {
    let folder = Folder::new();
    // At 60 degrees north its metres are twice too long.
    let middle = 6_378_137.0 * (1.0f64 / 0.5).acosh();
    let ground = |y: f64| vec![scale(10.0, 10.0), tie(0.0, y + 90.0), keys(&[[1024, 1], [3072, 3857]])];
    for y in [middle, -middle] {
        let path = write(&folder, &grey(32, 3, ground(y)), &tent([5.0; 2], 300.0));
        assert_tent(&read(&path, &default()), [5.0; 2], 300.0, nowhere);
        let georeference = look(&path).georeference.expect("it has one");
        assert_eq!((georeference.system, georeference.epsg), (CoordinateSystem::WebMercator, Some(3857)));
    }
}

#[test]
fn a_tent_whose_heights_are_in_feet() {
    let folder = Folder::new();
    let (foot, survey_foot) = (0.3048, 1200.0 / 3937.0);
    let ground = [[1024, 1], [3072, 32617], [3076, 9001]];
    let with = |more: &[[u16; 2]]| keys(&[ground.as_slice(), more].concat());
    for (more, metres, unit) in [
        (vec![with(&[[4099, 9002]])], foot, "ft"),
        (vec![with(&[[4096, 5703], [4099, 9003]])], survey_foot, "us-ft"),
        (vec![with(&[[4096, 6360]])], survey_foot, "us-ft"),
        (vec![with(&[[4096, 5703], [4099, 9001]])], 1.0, "m"),
        (vec![metadata(&[(0, "unittype", "ft")])], foot, "ft"),
        (vec![metadata(&[(0, "unittype", " US survey foot ")])], survey_foot, "US survey foot"),
        // A band's unit takes precedence over the system's.
        (vec![metadata(&[(0, "unittype", "metre")]), with(&[[4099, 9002]])], 1.0, "metre"),
        (vec![metadata(&[(0, "unittype", "km")])], 1000.0, "km"),
    ] {
        let values: Vec<f64> = tent([3.0; 2], 150.0).iter().map(|height| height / metres).collect();
        let path = write(&folder, &grey(64, 3, projected([3.0; 2], more)), &values);
        assert_tent(&read(&path, &default()), [3.0; 2], 150.0, nowhere);
        let elevation = look(&path).values.and_then(|values| values.elevation).expect("it is one");
        assert_eq!(elevation.unit.as_deref(), Some(unit));
        let found = elevation.metres_per_unit.expect("it is known");
        assert!((found / metres - 1.0).abs() < 1e-14, "{found} m, not {metres} m");
    }
}

#[test]
fn a_tent_on_a_grid_in_feet() {
    let folder = Folder::new();
    for (unit, metres) in [(9002, 0.3048), (9003, 1200.0 / 3937.0), (9036, 1000.0)] {
        let ground = projected([30.0; 2], vec![keys(&[[1024, 1], [3072, 2263], [3076, unit], [4099, 9001]])]);
        let size = [30.0 * metres; 2];
        let path = write(&folder, &grey(32, 3, ground), &tent(size, 40.0));
        assert_tent(&read(&path, &default()), size, 40.0, nowhere);
    }
    // A unit that the file defines itself.
    let (tag, directory) =
        (34735, vec![1, 1, 0, 4, 1024, 0, 1, 1, 3076, 0, 1, 32767, 3077, 34736, 1, 0, 4099, 0, 1, 9001]);
    let own = vec![(tag, Value::Short(directory)), (34736, Value::Double(vec![0.5]))];
    let path = write(&folder, &grey(32, 3, projected([30.0; 2], own)), &tent([15.0; 2], 40.0));
    assert_tent(&read(&path, &default()), [15.0; 2], 40.0, nowhere);
}

#[test]
fn a_tent_with_scale_and_offset() {
    let folder = Folder::new();
    let raw: Vec<f64> = tent([3.0; 2], 150.0).iter().map(|height| (height - 500.0) / 0.25).collect();
    let items = [(0, "offset", "500"), (0, "scale", "0.25"), (0, "unittype", "m"), (7, "scale", "9")];
    let path = write(&folder, &grey(16, 2, projected([3.0; 2], vec![metadata(&items)])), &raw);
    let map = read(&path, &default());
    assert_tent(&map, [3.0; 2], 150.0, nowhere);
    // A range is one of raw values, and becomes metres.
    let ranged = read(&path, &HeightOptions { range: Some([-2000.0, 2000.0].into()), ..default() });
    assert_eq!(ranged.physical_range(), Some([0.0, 1000.0]));
    assert_tent(&ranged, [3.0; 2], 150.0, nowhere);

    // Without a georeference the values have metres, and texels have no size. Each band has its own.
    let two: Vec<f64> = raw.iter().flat_map(|&raw| [raw, 2.0 * raw]).collect();
    let items = [items.as_slice(), &[(1, "scale", "0.125")]].concat();
    let tiff = Tiff { bands: 2, ..grey(16, 2, vec![metadata(&items)]) };
    let path = write(&folder, &tiff, &two);
    let band = |name| read(&path, &HeightOptions { channel: Some(name), ..default() });
    let (first, second) = (band("band1".to_owned()), band("band2".to_owned()));
    assert_eq!((first.physical_range(), first.wrap()), (map.physical_range(), Wrap::Clamp));
    assert_eq!(first.texel_size_m(), None);
    assert_eq!(second.physical_range(), map.physical_range().map(|r| r.map(|metres| metres - 500.0)));
}

#[test]
fn a_tent_with_a_mask() {
    let folder = Folder::new();
    let masked = |i: u32, j: u32| i >= 20 && j >= 12;
    let mut values = tent([2.0; 2], 90.0);
    let texels = || (0..HEIGHT).flat_map(|j| (0..WIDTH).map(move |i| (i, j)));
    let mask: Vec<f64> = texels().map(|(i, j)| f64::from(u8::from(!masked(i, j)))).collect();
    // Masked texels have values that would spoil the range.
    for (value, mask) in values.iter_mut().zip(&mask).filter(|(_, mask)| **mask == 0.0) {
        *value = -3.4e38 + mask;
    }
    let tiff = grey(32, 3, projected([2.0; 2], vec![]));
    let kinds = |kind: u32| vec![(254, Value::Long(vec![kind]))];
    let bits = Tiff { photometric: 4, ..grey(1, 1, kinds(4)) };
    let bytes = Tiff { photometric: 4, deflate: true, ..grey(8, 1, kinds(4)) };
    let reduced = Tiff { photometric: 4, ..Tiff { extra: kinds(5), ..Tiff::grey(3, 3, 1, 1) } };
    let filled = HeightOptions { fill: Fill::Elevation, ..default() };
    let count = 4 * 6;
    let assert_masked = |path: &Path| {
        let error = read_height(path, &default()).expect_err("texels have no value");
        assert!(
            matches!(
                error.problem,
                ReadProblem::Holes { masked: 24, nodata: 0, not_finite: 0, column: 20, row: 12 }
            ),
            "{error}"
        );
        let map = read(path, &filled);
        assert_eq!(map.filled_texels(), count);
        assert_tent(&map, [2.0; 2], 90.0, masked);
        assert_eq!(look(path).values.map(|values| values.masked), Some(count));
    };
    for mask_tiff in [bits, bytes] {
        let more = [(reduced.clone(), vec![0.0; 9]), (mask_tiff, mask.clone())];
        let whole = tiff.bytes_before(&values, &more);
        let path = folder.file("dem.tif", &whole);
        assert_masked(&path);
        let from_bytes = read_height(Source::bytes("dem.tif", &whole), &filled).expect("it is read");
        assert_eq!(from_bytes, read(&path, &filled));
    }
    // A mask beside the file, as GDAL writes it.
    let whole: Vec<f64> = mask.iter().map(|mask| 255.0 * mask).collect();
    let path = folder.file("beside.tif", &tiff.bytes(&values));
    folder.file("beside.tif.msk", &grey(8, 1, vec![]).bytes(&whole));
    assert_masked(&path);
    // A mask leaves no texel: there is no map.
    folder.file("beside.tif.msk", &grey(8, 1, vec![]).bytes(&vec![0.0; values.len()]));
    let error = read_height(&path, &filled).expect_err("nothing is left");
    assert!(matches!(error.problem, ReadProblem::AllHoles), "{error}");

    let small = Tiff::grey(WIDTH, HEIGHT - 1, 8, 1);
    for bytes in [small.bytes(&mask), b"II*\0nonsense".to_vec(), Vec::new()] {
        folder.file("beside.tif.msk", &bytes);
        let error = read_height(&path, &filled).expect_err("the mask is of no use");
        assert!(matches!(&error.problem, ReadProblem::Mask { mask, .. } if mask.ends_with("beside.tif.msk")));
        assert!(inspect(&path, &default()).is_err());
    }
    let wrong = tiff.bytes_before(&values, &[(Tiff { extra: kinds(4), ..small }, mask)]);
    let error = read_height(&folder.file("wrong.tif", &wrong), &filled).expect_err("the sizes differ");
    assert!(error.to_string().contains("24x17") && error.to_string().contains("24x18"), "{error}");
}

#[test]
fn a_tent_stored_from_the_south() {
    let folder = Folder::new();
    let size = [3.0, 5.0];
    let values = tent(size, 70.0);
    let rows = |values: &[f64]| values.chunks(WIDTH as usize).rev().flatten().copied().collect::<Vec<f64>>();
    let columns = |values: &[f64]| {
        values.chunks(WIDTH as usize).flat_map(|row| row.iter().rev().copied()).collect::<Vec<f64>>()
    };
    let keys = || keys(&[[1024, 1], [3076, 9001]]);
    let [x, y] = size;
    let by_matrix = |x: f64, y: f64| vec![matrix([[x, 0.0, 0.0, 5e5], [0.0, y, 0.0, 4e6]]), keys()];
    for (ground, stored, turned) in [
        (by_matrix(x, -y), values.clone(), [false, false]),
        (by_matrix(x, y), rows(&values), [false, true]),
        (by_matrix(-x, -y), columns(&values), [true, false]),
        (by_matrix(-x, y), rows(&columns(&values)), [true, true]),
        (vec![scale(x, -y), tie(0.0, 0.0), keys()], rows(&values), [false, true]),
    ] {
        for tile_width in [None, Some(16)] {
            let tiff = Tiff { tile_width, block_rows: 16, ..grey(32, 3, ground.clone()) };
            let path = write(&folder, &tiff, &stored);
            assert_tent(&read(&path, &default()), size, 70.0, nowhere);
            assert_eq!(look(&path).georeference.map(|found| found.turned_over), Some(turned));
        }
    }
    // A mask is flipped with its map.
    let mut mask = vec![1.0; values.len()];
    mask[0] = 0.0;
    let mask_tiff = Tiff { photometric: 4, ..grey(8, 1, vec![(254, Value::Long(vec![4]))]) };
    let bytes = grey(32, 3, by_matrix(x, y)).bytes_before(&rows(&values), &[(mask_tiff, mask)]);
    let error = read_height(&folder.file("mask.tif", &bytes), &default()).expect_err("a texel is masked");
    assert!(matches!(error.problem, ReadProblem::Holes { masked: 1, column: 0, row: 17, .. }), "{error}");
}

#[test]
fn a_tent_of_unsigned_integers() {
    let folder = Folder::new();
    for (bits, top) in [(8, 230.0), (16, 3000.0)] {
        let values = tent([3.0; 2], top);
        let path = write(&folder, &grey(bits, 1, projected([3.0; 2], vec![])), &values);
        let map = read(&path, &default());
        assert_tent(&map, [3.0; 2], top, nowhere);
        let least = values.iter().copied().fold(f64::INFINITY, f64::min);
        assert_eq!(map.physical_range(), Some([least, top]));
        assert_eq!(look(&path).values.and_then(|values| values.normalised_range), Some([least, top]));
        // 0 as white is for pictures.
        let white = Tiff { photometric: 0, ..grey(bits, 1, projected([3.0; 2], vec![])) };
        assert_tent(&read(&write(&folder, &white, &values), &default()), [3.0; 2], top, nowhere);
        // Nodata is no value.
        let more = projected([3.0; 2], vec![(42113, Value::Text("0".into()))]);
        let mut holes = values.clone();
        holes[WIDTH as usize - 1] = 0.0;
        let path = write(&folder, &grey(bits, 1, more), &holes);
        let filled = read(&path, &HeightOptions { fill: Fill::Always, ..default() });
        assert_eq!((filled.filled_texels(), filled.physical_range()), (1, Some([least, top])));
        assert_tent(&filled, [3.0; 2], top, |i, j| (i, j) == (WIDTH - 1, 0));
    }
}

#[test]
fn a_tent_on_a_rotated_grid() {
    let folder = Folder::new();
    let (sin, cos) = (0.6, 0.8);
    let size = [6.0, 2.0];
    // Columns go 37 degrees north of east, rows to the right of that.
    let turned = [[6.0 * cos, 2.0 * sin, 0.0, 5e5], [6.0 * sin, -2.0 * cos, 0.0, 4e6]];
    let path = write(&folder, &grey(32, 3, projected_by(turned)), &tent(size, 70.0));
    assert_tent(&read(&path, &default()), size, 70.0, nowhere);
    // Texels that are not rectangles have no usable size along u and v.
    let sheared = [[6.0, 1.0, 0.0, 5e5], [0.0, -2.0, 0.0, 4e6]];
    let path = write(&folder, &grey(32, 3, projected_by(sheared)), &tent(size, 70.0));
    assert_eq!(read(&path, &default()).texel_size_m(), None);
    let reason = look(&path).georeference.map(|found| found.texel_size_m);
    assert_eq!(reason, Some(Err("its texels are not rectangles".to_owned())));
}

fn projected_by(rows: [[f64; 4]; 2]) -> Tags {
    vec![matrix(rows), keys(&[[1024, 1], [3072, 32617], [3076, 9001]])]
}

#[test]
fn the_corners_of_a_map_are_where_its_file_places_them() {
    let folder = Folder::new();
    let [width, height] = [f64::from(WIDTH), f64::from(HEIGHT)];
    let keys = |raster_type| keys(&[[1024, 1], [1025, raster_type], [3072, 32617], [3076, 9001]]);
    let scaled = |raster_type, at: [f64; 6]| {
        vec![scale(2.0, 3.0), (33922, Value::Double(at.to_vec())), keys(raster_type)]
    };
    let by_matrix = |raster_type, x: [f64; 3], y: [f64; 3]| {
        let row = |[column, row, at]: [f64; 3]| [column, row, 0.0, at];
        vec![matrix([row(x), row(y)]), keys(raster_type)]
    };
    let (turned_x, turned_y) = ([4.8, 1.2, 5e5], [3.6, -1.6, 4e6]);
    // The corners in the north-west and in the south-east of a map that is upright.
    let [west, east] = [5e5, 5e5 + 2.0 * width];
    let [north, south] = [4e6, 4e6 - 3.0 * height];
    for (ground, corners) in [
        (scaled(1, [0.0, 0.0, 0.0, west, north, 0.0]), [[west, north], [east, south]]),
        (scaled(2, [0.0, 0.0, 0.0, west + 1.0, north - 1.5, 0.0]), [[west, north], [east, south]]),
        (scaled(1, [4.0, 2.0, 0.0, west + 8.0, north - 6.0, 0.0]), [[west, north], [east, south]]),
        (by_matrix(1, [2.0, 0.0, west], [0.0, 3.0, south]), [[west, north], [east, south]]),
        (by_matrix(1, [-2.0, 0.0, east], [0.0, -3.0, north]), [[west, north], [east, south]]),
        (by_matrix(2, [-2.0, 0.0, east - 1.0], [0.0, 3.0, south + 1.5]), [[west, north], [east, south]]),
        (
            by_matrix(1, turned_x, turned_y),
            [[5e5, 4e6], [5e5 + 4.8 * width + 1.2 * height, 4e6 + 3.6 * width - 1.6 * height]],
        ),
    ] {
        let path = write(&folder, &grey(32, 3, ground), &tent([2.0, 3.0], 70.0));
        let found = read_ground(&path, &default()).unwrap_or_else(|error| panic!("{error}"));
        let georeference = found.georeference.expect("it is georeferenced");
        let transform = georeference.transform.expect("the file places its grid");
        assert_eq!([transform.at([0.0, 0.0]), transform.at([width, height])], corners);
        assert_eq!((georeference.metres_per_unit, georeference.row_lengths), (Some([1.0; 2]), [1.0; 2]));
        let map = read(&path, &default());
        assert_eq!((found.tile_m, found.size), (map.stated_tile_m(), [map.width(), map.height()]));
    }
    // Rows of a degree each, the first from 60 to 59 degrees north, the last from 43 to 42.
    let keys = self::keys(&[[1024, 2], [2048, 4326]]);
    let degrees = vec![scale(1.0, 1.0), tie(7.0, 60.0), keys];
    let path = write(&folder, &grey(32, 3, degrees), &tent([1.0; 2], 70.0));
    let found = look(&path).georeference.expect("it is georeferenced");
    // On a sphere, which is nearly as round.
    let cosine = |degrees: f64| degrees.to_radians().cos();
    for (found, latitude) in found.row_lengths.into_iter().zip([60.0, 42.0]) {
        assert!((found - cosine(latitude) / cosine(51.0)).abs() < 1e-3, "{found} at {latitude}");
    }
    assert_eq!(found.transform.map(|transform| transform.at([1.0, 18.0])), Some([8.0, 42.0]));
}

#[test]
fn points_and_areas_read_alike() {
    let folder = Folder::new();
    for raster_type in [1, 2] {
        let ground = projected([2.0; 2], vec![keys(&[[1024, 1], [1025, raster_type], [3076, 9001]])]);
        let path = write(&folder, &grey(32, 3, ground), &tent([2.0; 2], 10.0));
        assert_tent(&read(&path, &default()), [2.0; 2], 10.0, nowhere);
    }
}

#[test]
fn nodata_values_are_read_in_every_spelling() {
    let folder = Folder::new();
    let values = tent([2.0; 2], 90.0);
    for (nodata, hole) in [
        (Value::Text("-9999".into()), -9999.0),
        (Value::Text(" -9999.0 ".into()), -9999.0),
        (Value::Text("-3.4028234663852886e+38".into()), f64::from(f32::MIN)),
        (Value::Text("-3.40282346638529e+38".into()), f64::from(f32::MIN)),
        (Value::Text("0.1".into()), 0.1),
        (Value::Text("nan".into()), f64::NAN),
        (Value::Text("1.#QNAN".into()), f64::NAN),
        (Value::Text("-inf".into()), f64::NEG_INFINITY),
        (Value::Double(vec![-9999.0]), -9999.0),
    ] {
        let name = format!("{nodata:?}");
        let mut values = values.clone();
        values[0] = hole;
        let path = write(&folder, &grey(32, 3, projected([2.0; 2], vec![(42113, nodata)])), &values);
        let error = read_height(&path, &default()).expect_err(&name);
        assert!(matches!(error.problem, ReadProblem::Holes { column: 0, row: 0, .. }), "{name}: {error}");
        let map = read(&path, &HeightOptions { fill: Fill::Elevation, ..default() });
        assert_eq!(map.filled_texels(), 1, "{name}");
        assert_tent(&map, [2.0; 2], 90.0, |i, j| (i, j) == (0, 0));
    }
}

#[test]
fn only_elevation_models_are_clamped_and_filled_unasked() {
    let folder = Folder::new();
    let grey_png = png(4, 4, ::png::ColorType::Grayscale, ::png::BitDepth::Eight, &[7; 16]);
    let filled = HeightOptions { fill: Fill::Elevation, ..default() };
    assert_eq!(read(&folder.file("grey.png", &grey_png), &filled).wrap(), Wrap::Repeat);
    let mut values = tent([2.0; 2], 90.0);
    let path = write(&folder, &grey(32, 3, vec![]), &values);
    assert_eq!(read(&path, &default()).wrap(), Wrap::Repeat);
    let elevation = grey(32, 3, projected([2.0; 2], vec![]));
    let mirrored = HeightOptions { wrap: Some(Wrap::Mirror), ..default() };
    assert_eq!(read(&write(&folder, &elevation, &values), &mirrored).wrap(), Wrap::Mirror);
    values[3] = f64::NAN;
    let path = write(&folder, &grey(32, 3, vec![]), &values);
    let error = read_height(&path, &filled).expect_err("it is no elevation model");
    assert!(matches!(error.problem, ReadProblem::Holes { .. }), "{error}");
}

#[test]
fn unknown_units_have_a_note_and_no_metres() {
    let folder = Folder::new();
    let values = tent([2.0; 2], 90.0);
    let grid = [scale(2.0, 2.0), tie(5e5, 4e6)];
    let with = |more: Tags| [grid.to_vec(), more].concat();
    for (ground, reason) in [
        (with(vec![]), "names no coordinate system"),
        (with(vec![keys(&[[1024, 3]])]), "kind of its coordinate system"),
        (with(vec![keys(&[[1024, 32767]])]), "kind of its coordinate system"),
        (with(vec![keys(&[[1024, 1], [3076, 9999]])]), "EPSG:9999"),
        (with(vec![keys(&[[1024, 2], [2054, 9999]])]), "EPSG:9999"),
        (vec![keys(&[[1024, 1], [3072, 32617]])], "gives no grid"),
        (vec![scale(2.0, 2.0), keys(&[[1024, 2]])], "the position of its grid"),
    ] {
        let path = write(&folder, &grey(32, 3, ground), &values);
        let map = read(&path, &default());
        assert_eq!((map.texel_size_m(), map.wrap()), (None, Wrap::Clamp), "{reason}");
        let found = look(&path).georeference.expect("it has one").texel_size_m.expect_err(reason);
        assert!(found.contains(reason), "{found}");
    }
    for more in [metadata(&[(0, "unittype", "kelvin")]), keys(&[[1024, 1], [4099, 9102]])] {
        let path = write(&folder, &grey(32, 3, projected([2.0; 2], vec![more])), &values);
        let map = read(&path, &default());
        assert_eq!((map.physical_range(), map.stated_lengths_m()), (None, None));
        let elevation = look(&path).values.and_then(|values| values.elevation).expect("it is one");
        assert!(elevation.unit.is_some() && elevation.metres_per_unit.is_none(), "{elevation:?}");
    }
}

#[test]
fn impossible_keys_and_values_are_refused() {
    let folder = Folder::new();
    let values = tent([2.0; 2], 90.0);
    let doubles = |tag, numbers: &[f64]| (tag, Value::Double(numbers.to_vec()));
    let nan = f64::NAN;
    let own_unit = |size: f64| {
        let directory = vec![1, 1, 0, 3, 1024, 0, 1, 1, 3076, 0, 1, 32767, 3077, 34736, 1, 0];
        vec![(34735, Value::Short(directory)), doubles(34736, &[size])]
    };
    let mut refused = vec![
        vec![scale(0.0, 2.0)],
        vec![scale(2.0, 0.0)],
        vec![scale(nan, 2.0)],
        vec![scale(2.0, f64::INFINITY)],
        vec![scale(1e300, 1e300)],
        vec![scale(1e-300, 1e-300)],
        vec![doubles(33550, &[2.0])],
        vec![doubles(33922, &[0.0, 0.0, 0.0, 5e5])],
        vec![doubles(33922, &[0.0, nan, 0.0, 5e5, 4e6, 0.0])],
        vec![scale(1.0, 1.0), tie(0.0, 500.0), keys(&[[1024, 2]])],
        vec![tie(0.0, f64::MAX), keys(&[[1024, 2]])],
        vec![tie(0.0, f64::MAX), keys(&[[1024, 1], [3072, 3857]])],
        vec![(34735, Value::Short(vec![1, 1, 0, 9, 1024, 0, 1, 1]))],
        vec![(34735, Value::Short(vec![1, 1]))],
        vec![(34735, Value::Double(vec![1.0; 8]))],
        own_unit(0.0),
        own_unit(-1.0),
        own_unit(nan),
        vec![(34735, Value::Short(vec![1, 1, 0, 3, 1024, 0, 1, 1, 3076, 0, 1, 32767, 3077, 34736, 1, 7]))],
        vec![(42113, Value::Text("nothing".into()))],
        vec![metadata(&[(0, "offset", "nan")])],
        vec![metadata(&[(0, "offset", "1e999")])],
    ];
    refused.extend(["0", "-1", "nan", "inf", "", "one"].map(|text| vec![metadata(&[(0, "scale", text)])]));
    let check = |tags: Tags| {
        let name = format!("{tags:?}");
        let path = write(&folder, &grey(32, 3, tags), &values);
        for problem in [read_height(&path, &default()).map(drop), inspect(&path, &default()).map(drop)] {
            let error = problem.expect_err(&name);
            assert!(matches!(error.problem, ReadProblem::Georeference { .. }), "{name}: {error}");
            println!("{error}");
        }
        // Pictures are read regardless of their georeference.
        let picture = relief_io::read_picture(&path, relief_io::DEFAULT_MAX_BYTES);
        assert!(picture.is_ok(), "{name}: {picture:?}");
    };
    refused.into_iter().for_each(|tags| check(projected([2.0; 2], tags)));
    for rows in [[[0.0; 4]; 2], [[2.0, 4.0, 0.0, 0.0], [1.0, 2.0, 0.0, 0.0]], [[nan, 0.0, 0.0, 0.0]; 2]] {
        check(projected_by(rows));
    }
    check(vec![doubles(34264, &[2.0, 0.0, 0.0, 0.0, 0.0, -2.0, 0.0, 0.0])]);
    // Damaged metadata are ignored.
    for text in ["<GDALMetadata", "<Item sample=\"0\" role=\"scale\">", "<Item sample=0 role=scale>0</Item>"]
    {
        let path = write(
            &folder,
            &grey(32, 3, projected([2.0; 2], vec![(42112, Value::Text(text.into()))])),
            &values,
        );
        assert_tent(&read(&path, &default()), [2.0; 2], 90.0, nowhere);
    }
}
