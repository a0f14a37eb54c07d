//! Real height, depth and normal maps. All files of one terrain give the same heights, and the conventions
//! of pairs of maps are found.

use std::path::Path;

use crate::common::{channel, read, real_data};
use relief_core::{HeightMap, Wrap};
use relief_io::{
    Convention, CoordinateSystem, DEFAULT_MAX_BYTES, Fill, Format, GreenSign, HeightOptions, ReadProblem,
    detect, inspect, read_height, read_normal_map,
};

const WIDTH: usize = 403;
const HEIGHT: usize = 344;

/// Elevations of the terrain in metres, from the bytes of the headerless file: 236 to 1076 in 16 bits.
fn elevations(data: &Path) -> Vec<f64> {
    let bytes = std::fs::read(data.join("derived/jacksboro_403x344_le.r16")).expect("it is in the folder");
    assert_eq!(bytes.len(), 2 * WIDTH * HEIGHT);
    let (samples, _) = bytes.as_chunks::<2>();
    samples.iter().map(|&b| (236.0 + f64::from(u16::from_le_bytes(b)) / 65535.0 * 840.0).round()).collect()
}

/// Greatest error in metres of the texels that are not skipped. Heights 0 and 1 mean the ends of `range`.
fn worst(map: &HeightMap, range: [f64; 2], expected: &[f64], skip: impl Fn(usize) -> bool) -> f64 {
    assert_eq!((map.width() as usize, map.height() as usize), (WIDTH, HEIGHT));
    let metres = |texel: &f32| range[0] + f64::from(*texel) * (range[1] - range[0]);
    let errors = map.texels().iter().zip(expected).map(|(texel, expected)| (metres(texel) - expected).abs());
    errors.enumerate().filter(|(at, _)| !skip(*at)).map(|(_, error)| error).fold(0.0, f64::max)
}

#[test]
fn every_file_of_the_terrain_gives_the_same_heights() {
    let Some(data) = real_data() else { return };
    let expected = elevations(&data);
    let raw = HeightOptions { raw: "403x344,le".parse().ok(), ..HeightOptions::default() };
    // Half a level of 16 bits, which were rounded; a whole level of 8 bits, which were truncated.
    let (wide_m, narrow_m) = (0.5 * 840.0 / 65535.0, 840.0 / 255.0);
    for (file, options, most_m) in [
        ("jacksboro_403x344_le.r16", raw, wide_m),
        ("jacksboro_u16.png", HeightOptions::default(), wide_m),
        ("jacksboro_u16.pgm", HeightOptions::default(), wide_m),
        ("jacksboro_u8.png", HeightOptions::default(), narrow_m),
    ] {
        let map = read(&data.join("derived").join(file), &options);
        let error = worst(&map, [236.0, 1076.0], &expected, |_| false);
        assert!(error <= most_m + 1e-4, "{file}: {error} m");
    }
    let map = read(&data.join("derived/jacksboro_f32.exr"), &HeightOptions::default());
    assert_eq!(map.physical_range(), Some([236.0, 1076.0]));
    assert!(worst(&map, [236.0, 1076.0], &expected, |_| false) < 1e-4);
    let mut wrong = expected.clone();
    wrong[70_000] += 1.0;
    assert!(worst(&map, [236.0, 1076.0], &wrong, |_| false) > 0.99, "a metre at one texel is seen");

    let terrain = data.join("derived/jacksboro_terrainrgb.png");
    let bytes = ["r", "g", "b"].map(|name| read(&terrain, &channel(name)));
    for (at, expected) in expected.iter().enumerate() {
        let [r, g, b] = [0, 1, 2].map(|c| f64::from(bytes[c].texels()[at]) * 255.0);
        let metres = -10000.0 + 0.1 * (65536.0 * r.round() + 256.0 * g.round() + b.round());
        assert!((metres - expected).abs() < 0.051, "{at}");
    }
}

#[test]
fn every_variant_of_the_geotiff_gives_the_same_heights() {
    let Some(data) = real_data() else { return };
    let expected = elevations(&data);
    let folder = data.join("dem_matrix");
    let filled = HeightOptions { fill: Fill::Always, ..HeightOptions::default() };
    for (file, holes) in [
        ("f32_bigtiff_be.tif", 200),
        ("f32_cog_zstd.tif", 200),
        ("f32_lerc.tif", 200),
        ("f32_lerc_zstd.tif", 200),
        ("f32_tiled_deflate_p3_nodata.tif", 200),
        ("f32_tiled_zstd_p2_nan.tif", 200),
        ("f32_tiled_zstd_p3_nodata.tif", 200),
        ("f64_deflate_p3.tif", 0),
        ("i16_strip_none.tif", 0),
        ("u16_tiled_lzw_p2.tif", 0),
    ] {
        let path = folder.join(file);
        let info = inspect(&path, &HeightOptions::default()).unwrap_or_else(|error| panic!("{error}"));
        let values = info.values.expect("one band");
        assert_eq!(
            (info.format, values.not_finite + values.nodata, values.levels),
            (Format::Tiff, holes, 817),
            "{file}"
        );
        let unfilled = read_height(&path, &HeightOptions::default());
        match unfilled {
            Err(error) => {
                assert!(matches!(error.problem, ReadProblem::Holes { .. }), "{error}");
                assert!(holes > 0);
            }
            Ok(_) => assert_eq!(holes, 0, "{file}"),
        }
        let map = read(&path, &filled);
        let range = map.physical_range().expect("a read map has a range");
        // Only filled texels differ, so there are at most as many as holes.
        let metres = |at: usize| range[0] + f64::from(map.texels()[at]) * (range[1] - range[0]);
        let off: Vec<usize> =
            (0..expected.len()).filter(|&at| (metres(at) - expected[at]).abs() > 0.01).collect();
        assert!(off.len() as u64 <= holes, "{file}: {} texels differ", off.len());
        let error = worst(&map, range, &expected, |at| off.contains(&at));
        assert!(error < 0.01, "{file}: {error} m");
        assert_eq!((range, map.wrap()), ([236.0, 1076.0], Wrap::Clamp), "{file}");
        assert_eq!(map.filled_texels(), holes, "{file}");
        // A texel is 3 seconds of arc at 36 degrees north.
        let [u, v] = map.texel_size_m().expect("it is georeferenced");
        assert!((u - 74.6).abs() < 0.3 && (v - 92.5).abs() < 0.3, "{file}: {u} x {v} m");
    }
    let map = read(&folder.join("f32_sparse.tif"), &filled);
    assert_eq!((map.width(), map.height()), (512, 512));
    let [low, high] = map.physical_range().expect("a read map has a range");
    for (i, j) in [(0, 0), (127, 0), (0, 127), (127, 127), (64, 31)] {
        let metres = low + f64::from(map.texel(i, j)) * (high - low);
        assert!((metres - expected[j as usize * WIDTH + i as usize]).abs() < 0.01, "({i}, {j}): {metres}");
    }
    let error = read_height(&folder.join("i16_lzma.tif"), &filled).expect_err("LZMA is not supported");
    assert!(matches!(error.problem, ReadProblem::Unsupported { .. }), "{error}");
}

#[test]
fn a_projected_geotiff_with_separate_planes() {
    let Some(data) = real_data() else { return };
    let path = data.join("small_dem_3m_merged.tif");
    let info = inspect(&path, &HeightOptions::default()).unwrap_or_else(|error| panic!("{error}"));
    let values = info.values.expect("one band");
    assert_eq!((info.width, info.height, info.texel_size_m), (574, 245, Some([3.0, 3.0])));
    assert_eq!((info.nodata_value, values.nodata), (Some(0.0), 52119));
    assert_eq!(values.range.map(|[_, most]| most), Some(31000.0));
}

#[test]
fn float_and_colour_files() {
    let Some(data) = real_data() else { return };
    let options = HeightOptions::default();
    let map = read(&data.join("t3d_mountain1.exr"), &options);
    let [low, high] = map.physical_range().expect("a read map has a range");
    assert!(low == 0.0 && (high - 1.0049).abs() < 1e-4, "{low} to {high}");
    for (file, size) in [("t3d_terrain1.exr", 512), ("t3d_stones.exr", 512), ("earth-topology.png", 2048)] {
        assert_eq!(read(&data.join(file), &options).width(), size, "{file}");
    }
    // A height map stored as a JPEG in colour, of 26 levels.
    let info = inspect(&data.join("canyon_height.jpg"), &options).unwrap_or_else(|error| panic!("{error}"));
    let values = info.values.expect("its channels are equal");
    assert_eq!((info.width, info.height, values.range, values.levels), (4096, 4096, Some([44.0, 69.0]), 26));
    // A colour picture with the height in its opacity.
    let path = data.join("rock023_alb_ht.png");
    let error = read_height(&path, &options).expect_err("it is in colour");
    assert!(matches!(error.problem, ReadProblem::NotGrey { .. }), "{error}");
    assert_eq!(read(&path, &channel("a")).physical_range(), Some([0.0, 255.0]));
}

#[test]
fn a_real_elevation_model_of_unsigned_integers_uses_its_own_range() {
    let Some(data) = real_data() else { return };
    let path = data.join("small_dem_3m_merged.tif");
    let error = read_height(&path, &HeightOptions::default()).expect_err("it has nodata");
    assert!(matches!(error.problem, ReadProblem::Holes { nodata: 52119, .. }), "{error}");
    let map = read(&path, &HeightOptions { fill: Fill::Elevation, ..HeightOptions::default() });
    assert_eq!((map.width(), map.height(), map.wrap()), (574, 245, Wrap::Clamp));
    assert_eq!((map.filled_texels(), map.texel_size_m()), (52119, Some([3.0, 3.0])));
    let bytes = std::fs::read(&path).expect("it has just been read");
    // Its strips are contiguous.
    let (samples, _) = bytes[426..][..2 * 574 * 245].as_chunks::<2>();
    let heights: Vec<u16> = samples.iter().map(|&sample| u16::from_le_bytes(sample)).collect();
    let least = heights.iter().copied().filter(|&height| height != 0).min().map(f64::from);
    assert_eq!(map.physical_range(), least.map(|least| [least, 31000.0]));
    let georeference = inspect(&path, &HeightOptions::default()).ok().and_then(|info| info.georeference);
    let georeference = georeference.expect("it has one");
    assert_eq!((georeference.system, georeference.epsg), (CoordinateSystem::Projected, Some(26915)));
}

#[test]
fn tiling_maps_are_distinguished_from_cut_outs() {
    let Some(data) = real_data() else { return };
    for (file, name, tiles) in [
        ("rock023_alb_ht.png", "a", [true, true]),
        ("godot_cheese_depth.png", "y", [true, true]),
        ("godot_wool_depth.png", "y", [true, true]),
        ("bevy_cube_depth.png", "y", [true, true]),
        ("earth-topology.png", "y", [true, false]),
        ("canyon_height.jpg", "r", [false, false]),
        ("derived/jacksboro_u16.png", "y", [false, false]),
        ("t3d_terrain1.exr", "R", [false, false]),
    ] {
        let info = inspect(&data.join(file), &channel(name)).unwrap_or_else(|error| panic!("{error}"));
        let tiling = info.values.and_then(|values| values.tiling).expect("every texel has a value");
        assert_eq!(tiling.tiles, tiles, "{file}: {tiling:?}");
    }
}

#[test]
fn real_pairs_show_their_conventions() {
    let Some(data) = real_data() else { return };
    for (height, name, normal, convention, green) in [
        ("bevy_cube_depth.png", "y", "bevy_cube_normal.png", Convention::Depth, GreenSign::PlusY),
        ("rock023_alb_ht.png", "a", "rock023_nrm_rgh.png", Convention::Height, GreenSign::PlusY),
        ("bgfx_parallax_h.png", "r", "bgfx_parallax_n.png", Convention::Depth, GreenSign::MinusY),
        ("godot_cheese_depth.png", "y", "godot_cheese_normal.png", Convention::Depth, GreenSign::PlusY),
    ] {
        let map = read(&data.join(height), &channel(name));
        let normals = read_normal_map(&data.join(normal), GreenSign::PlusY, DEFAULT_MAX_BYTES)
            .unwrap_or_else(|error| panic!("{error}"));
        let found = detect(&map, &normals);
        assert_eq!((found.convention, found.green), (convention, green), "{height}: {found:?}");
        assert!(found.convention_confidence > 0.5 && found.green_confidence > 0.5, "{height}: {found:?}");
    }
}

#[test]
fn sound_maps_are_read_without_notes() {
    let Some(data) = real_data() else { return };
    let (mut looked, mut banded) = (0, 0);
    let folders = [data.clone(), data.join("derived"), data.join("dem_matrix")];
    let entries = folders.iter().flat_map(|folder| std::fs::read_dir(folder).into_iter().flatten());
    for path in entries.map(|entry| entry.expect("an entry").path()).filter(|path| path.is_file()) {
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        for channel in [None, Some("a")] {
            let raw = name.ends_with(".r16").then(|| "403x344,le".parse().expect("a layout"));
            let channel = channel.filter(|_| raw.is_none()).map(str::to_owned);
            let options = HeightOptions { channel, raw, ..HeightOptions::default() };
            let Ok(info) = inspect(&path, &options) else { continue };
            if info.values.is_none() {
                continue;
            }
            let rows: Vec<&str> = info.notes.iter().map(|note| note.remark.row.name).collect();
            // Floats use their least and greatest values, and smooth maps of 8 bits show their steps: neither
            // is a defect.
            let is_fault = |row: &&str| !["fitted-range", "banded"].contains(row);
            banded += usize::from(rows.contains(&"banded"));
            let faults: Vec<&str> = rows.into_iter().filter(is_fault).collect();
            let expected: &[&str] = if name == "canyon_height.jpg" { &["narrow-range"] } else { &[] };
            assert_eq!(faults, expected, "{name}");
            looked += 1;
        }
    }
    assert!(looked >= 20, "{looked} maps");
    assert!((1..looked / 2).contains(&banded), "{banded} of {looked} maps have steps that show");
}
