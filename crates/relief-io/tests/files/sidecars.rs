//! Sidecar files of a map: world files, `.prj` and `.aux.xml`, for TIFF, PNG and JPEG.

use std::path::{Path, PathBuf};

use crate::common::files::{jpeg, png};
use crate::common::tiff_file::{Tiff, Value};
use crate::common::{Folder, default};
use relief_core::{HeightMap, Wrap};
use relief_io::{
    CoordinateSystem, Fill, HeightOptions, ReadProblem, Source, SourceInfo, UnitOrigin, inspect, read_height,
};

const SIZE: [u32; 2] = [40, 24];

const FOOT: f64 = 0.3048;

const WORLD: &str = "10\n0\n0\n-10\n500005\n4999995\n";

fn utm(unit: &str) -> String {
    format!(
        "PROJCS[\"WGS 84 / UTM zone 33N\",GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,\
         298.257223563]],PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]],\
         PROJECTION[\"Transverse_Mercator\"],PARAMETER[\"central_meridian\",15],UNIT[{unit}]]"
    )
}

fn pam(more: &str) -> String {
    format!(
        "<PAMDataset>\n  <SRS>EPSG:32633</SRS>\n  <GeoTransform>5e5, 10,0,5e6,0, -10</GeoTransform>\n{more}\
         </PAMDataset>\n"
    )
}

/// Hills from 100 to 200. The first texel is the lowest, the last one the highest.
fn heights() -> Vec<f64> {
    let last = f64::from(SIZE[0] * SIZE[1] - 1);
    (0..SIZE[0] * SIZE[1]).map(|at| 100.0 + (100.0 * f64::from(at) / last).round()).collect()
}

fn tiff(folder: &Folder, name: &str, extra: Vec<(u16, Value)>) -> PathBuf {
    let tiff = Tiff { extra, ..Tiff::grey(SIZE[0], SIZE[1], 32, 3) };
    folder.file(name, &tiff.bytes(&heights()))
}

fn read(path: &Path) -> HeightMap {
    read_height(path, &default()).unwrap_or_else(|error| panic!("{error}"))
}

fn look(path: &Path) -> SourceInfo {
    inspect(path, &default()).unwrap_or_else(|error| panic!("{error}"))
}

fn assert_lengths(map: &HeightMap, tile: [f64; 2], span: f64, what: &str) {
    let (found, found_span) = map.stated_lengths_m().unwrap_or_else(|| panic!("{what}: lengths are known"));
    for (found, expected) in [(found[0], tile[0]), (found[1], tile[1]), (found_span, span)] {
        assert!((found / expected - 1.0).abs() < 1e-9, "{what}: {found} m, not {expected} m");
    }
}

#[test]
fn world_files_place_maps_of_every_format() {
    let folder = Folder::new();
    let bytes: Vec<u8> = heights().iter().map(|height| *height as u8).collect();
    for (map, world, prj) in [
        ("a.tif", "a.tfw", "a.prj"),
        ("b.tif", "b.tifw", "b.prj"),
        ("c.tif", "c.wld", "c.PRJ"),
        ("d.tiff", "d.tfw", "d.prj"),
        ("e.TIF", "e.TFW", "e.prj"),
        ("f.png", "f.pgw", "f.prj"),
        ("g.png", "g.pngw", "g.prj"),
        ("h.jpg", "h.jgw", "h.prj"),
        ("i.jpeg", "i.jgw", "i.prj"),
    ] {
        let is_jpeg = map.contains(".jp");
        let path = match map {
            _ if map.ends_with("png") => {
                let png = png(SIZE[0], SIZE[1], ::png::ColorType::Grayscale, ::png::BitDepth::Eight, &bytes);
                folder.file(map, &png)
            }
            _ if is_jpeg => folder.file(map, &jpeg(SIZE[0], SIZE[1], 1, &bytes)),
            _ => tiff(&folder, map, vec![]),
        };
        assert_eq!(read(&path).texel_size_m(), None, "{map}");
        folder.file(world, WORLD.as_bytes());
        folder.file(prj, utm("\"metre\",1").as_bytes());
        let map = read(&path);
        let span = map.physical_range().map_or(0.0, |[least, greatest]| greatest - least);
        assert!((span - 100.0).abs() < if is_jpeg { 12.0 } else { 1e-9 }, "{world}: {span}");
        assert_lengths(&map, [400.0, 240.0], span, world);
        assert_eq!(map.wrap(), Wrap::Clamp);
        let georeference = look(&path).georeference.expect("it is placed");
        assert_eq!(georeference.grid_file.as_deref(), Some(world));
        assert_eq!(georeference.unit_origin, UnitOrigin::Beside(prj.to_owned()));
        assert_eq!(georeference.transform.map(|grid| grid.origin), Some([5e5, 5e6]), "{world}");
    }
    // Bytes in memory have no sidecar files.
    let bytes = std::fs::read(folder.path().join("a.tif")).expect("it is there");
    let map = read_height(Source::bytes("a.tif", &bytes), &default()).expect("it is read");
    assert_eq!(map.texel_size_m(), None);
}

#[test]
fn systems_are_read_as_text() {
    let folder = Folder::new();
    let path = tiff(&folder, "dem.tif", vec![]);
    folder.file("dem.tfw", WORLD.as_bytes());
    let projected = |unit: &str| {
        format!(
            "PROJCRS[\"own\",BASEGEOGCRS[\"own\",DATUM[\"own\",ELLIPSOID[\"own\",6378137,0,LENGTHUNIT[\"metre\",1]]]],\
             CONVERSION[\"own\"],CS[Cartesian,2],\
             AXIS[\"(E)\",east,ORDER[1],{unit}],AXIS[\"(N)\",north,ORDER[2],{unit}]]"
        )
    };
    let vertical = "VERT_CS[\"NAVD88\",VERT_DATUM[\"NAVD88\",2005],UNIT[\"foot\",0.3048],AXIS[\"Up\",UP]]";
    let depth = "VERT_CS[\"depth\",VERT_DATUM[\"sea\",2005],UNIT[\"metre\",1],AXIS[\"Depth\",DOWN]]";
    for (text, ground, upward) in [
        (utm("\"metre\",1"), 1.0, 1.0),
        (utm("\"US survey foot\",0.3048006096012192"), 0.304_800_609_601_219_2, 0.304_800_609_601_219_2),
        (utm("\"my own\",0.25"), 0.25, 0.25),
        (format!("COMPD_CS[\"both\",{},{vertical}]", utm("\"metre\",1")), 1.0, FOOT),
        (format!("COMPD_CS[\"both\",{},{depth}]", utm("\"foot\",0.3048")), FOOT, 1.0),
        (format!("\u{feff}{}\r\n", utm(" \"metre\" , 1 ")), 1.0, 1.0),
        (projected("LENGTHUNIT[\"foot\",0.3048]"), FOOT, FOOT),
        ("PROJCS[\"by number\",AUTHORITY[\"EPSG\",\"2222\"]]".to_owned(), FOOT, FOOT),
        ("EPSG:2222".to_owned(), FOOT, FOOT),
        ("EPSG:32633+8228".to_owned(), 1.0, FOOT),
        ("LOCAL_CS[\"site\",UNIT[\"Meter\",1.0]]".to_owned(), 1.0, 1.0),
        (
            format!(
                "{},VERTCS[\"h\",VDATUM[\"h\"],PARAMETER[\"Direction\",-1.0],UNIT[\"Foot\",0.3048]]",
                utm("\"Meter\",1")
            ),
            1.0,
            FOOT,
        ),
    ] {
        folder.file("dem.prj", text.as_bytes());
        assert_lengths(&read(&path), [400.0 * ground, 240.0 * ground], 100.0 * upward, &text);
        let is_depth = text.contains("DOWN") || text.contains("-1.0");
        assert_eq!(read(&path).texel(0, 0), f32::from(u8::from(is_depth)), "{text}");
    }
    // Web Mercator is recognised by its name, degrees by the kind of system.
    let web = "PROJCS[\"WGS_1984_Web_Mercator_Auxiliary_Sphere\",PROJECTION[\"Mercator_Auxiliary_Sphere\"],\
               UNIT[\"Meter\",1.0]]";
    let degrees = "GEOGCS[\"WGS 84\",UNIT[\"degree\",0.0174532925199433]]";
    for (text, world, system) in [
        (web, WORLD, CoordinateSystem::WebMercator),
        (degrees, "0.001\n0\n0\n-0.001\n7\n46\n", CoordinateSystem::Geographic),
    ] {
        folder.file("dem.prj", text.as_bytes());
        folder.file("dem.tfw", world.as_bytes());
        let georeference = look(&path).georeference.expect("it is placed");
        assert!(georeference.system == system && georeference.texel_size_m.is_ok(), "{georeference:?}");
    }
    // Without a system all lengths share a unit, unless the ground may be in degrees.
    folder.file("dem.prj", b"");
    std::fs::remove_file(folder.path().join("dem.prj")).expect("it was there");
    assert_eq!(read(&path).stated_lengths(), None);
    folder.file("dem.tfw", WORLD.as_bytes());
    let map = read(&path);
    assert_eq!((map.stated_lengths(), map.stated_lengths_m()), (Some(([400.0, 240.0], 100.0)), None));
}

#[test]
fn aux_xml_wins_over_the_file() {
    let folder = Folder::new();
    let path = tiff(&folder, "aux.tif", vec![]);
    let band = |text: &str| format!("<PAMRasterBand band=\"1\">{text}</PAMRasterBand>");
    folder.file("aux.tif.aux.xml", pam(&band("<NoDataValue>100</NoDataValue>")).as_bytes());
    let error = read_height(&path, &default()).expect_err("texels have no value");
    assert!(matches!(error.problem, ReadProblem::Holes { nodata: 5, column: 0, row: 0, .. }), "{error}");
    let filled = HeightOptions { fill: Fill::Elevation, ..default() };
    assert_lengths(&read_height(&path, &filled).expect("it is filled"), [400.0, 240.0], 99.0, "nodata");
    for (said, span) in [
        ("<Scale>0.5</Scale><Offset>-10</Offset>", 50.0),
        ("<UnitType>ft</UnitType>", 100.0 * FOOT),
        ("<Scale>2</Scale><UnitType> m </UnitType>", 200.0),
        ("<UnitType></UnitType><NoDataValue>nan</NoDataValue><Histograms/>", 100.0),
    ] {
        folder.file("aux.tif.aux.xml", pam(&band(said)).as_bytes());
        assert_lengths(&read(&path), [400.0, 240.0], span, said);
    }
    // It wins over tags, and over world files.
    let scale = (33550, Value::Double(vec![3.0, 3.0, 0.0]));
    let tie = (33922, Value::Double(vec![0.0, 0.0, 0.0, 1e5, 1e6, 0.0]));
    let keys = (34735, Value::Short(vec![1, 1, 0, 2, 1024, 0, 1, 1, 3072, 0, 1, 2222]));
    let tagged = tiff(&folder, "tagged.tif", vec![scale, tie, keys]);
    assert_lengths(&read(&tagged), [120.0 * FOOT, 72.0 * FOOT], 100.0 * FOOT, "tags");
    folder.file("tagged.tfw", WORLD.as_bytes());
    assert_lengths(&read(&tagged), [120.0 * FOOT, 72.0 * FOOT], 100.0 * FOOT, "tags and a world file");
    folder.file("tagged.tif.aux.xml", pam("").as_bytes());
    assert_lengths(&read(&tagged), [400.0, 240.0], 100.0, "aux.xml");
    // A picture without georeference stays a picture.
    let grey = png(2, 2, ::png::ColorType::Grayscale, ::png::BitDepth::Eight, &[10, 20, 30, 40]);
    let grey = folder.file("grey.png", &grey);
    let statistics = "<PAMDataset><SRS>EPSG:32633</SRS><PAMRasterBand band=\"1\"><Metadata><MDI \
                      key=\"STATISTICS_MEAN\">3</MDI></Metadata></PAMRasterBand></PAMDataset>";
    folder.file("grey.png.aux.xml", statistics.as_bytes());
    assert_eq!((read(&grey).physical_range(), read(&grey).wrap()), (Some([0.0, 255.0]), Wrap::Repeat));
}

#[test]
fn maps_are_flipped_as_a_sidecar_says() {
    let folder = Folder::new();
    let bytes: Vec<u8> = heights().iter().map(|height| *height as u8).collect();
    let grey = png(SIZE[0], SIZE[1], ::png::ColorType::Grayscale, ::png::BitDepth::Eight, &bytes);
    let maps = [folder.file("grey.png", &grey), tiff(&folder, "dem.tif", vec![])];
    for (sides, lowest) in
        [([10, -10], [0, 0]), ([10, 10], [0, 23]), ([-10, -10], [39, 0]), ([-10, 10], [39, 23])]
    {
        let world = format!("{}\n0\n0\n{}\n500005\n4999995\n", sides[0], sides[1]);
        for path in &maps {
            folder.file(if path.ends_with("grey.png") { "grey.pgw" } else { "dem.tfw" }, world.as_bytes());
            let map = read(path);
            assert_eq!(map.texel(lowest[0], lowest[1]), 0.0, "{sides:?} {}", path.display());
            assert_eq!(map.texel(39 - lowest[0], 23 - lowest[1]), 1.0, "{sides:?} {}", path.display());
        }
    }
}

#[test]
fn impossible_sidecars_are_refused_with_their_names() {
    let folder = Folder::new();
    let path = tiff(&folder, "dem.tif", vec![]);
    let deep = "A[".repeat(100_000);
    let nested = format!("<PAMDataset>{}", "<a>".repeat(50_000));
    let many = pam(&"<a/>".repeat(200_000));
    let huge = pam(&" ".repeat(9 << 20));
    let bands = |text: &str| pam(&format!("<PAMRasterBand {text}</PAMRasterBand>"));
    let refused: Vec<(&str, Vec<u8>)> = vec![
        ("dem.tfw", b"10\n0\n0\n-10\n500005\n".to_vec()),
        ("dem.tfw", b"".to_vec()),
        ("dem.tfw", b"10\n0\nnan\n-10\n500005\n4999995\n".to_vec()),
        ("dem.tfw", b"10\n0\n0\ninf\n500005\n4999995\n".to_vec()),
        ("dem.tfw", b"0\n0\n0\n-10\n500005\n4999995\n".to_vec()),
        ("dem.tfw", b"0\n0\n0\n0\n0\n0\n".to_vec()),
        ("dem.tfw", b"ten\n0\n0\n-10\n500005\n4999995\n".to_vec()),
        ("dem.tfw", vec![0xff; 64]),
        ("dem.tfw", vec![b' '; 70 << 10]),
        ("dem.prj", b"PROJCS[\"cut".to_vec()),
        ("dem.prj", b"PROJCS[\"cut\",".to_vec()),
        ("dem.prj", utm("\"metre\",0").into_bytes()),
        ("dem.prj", utm("\"metre\",nan").into_bytes()),
        ("dem.prj", deep.into_bytes()),
        ("dem.tif.aux.xml", pam("").as_bytes()[..90].to_vec()),
        ("dem.tif.aux.xml", b"<PAMDataset>".to_vec()),
        ("dem.tif.aux.xml", nested.into_bytes()),
        ("dem.tif.aux.xml", many.into_bytes()),
        ("dem.tif.aux.xml", huge.into_bytes()),
        ("dem.tif.aux.xml", pam("<GeoTransform>1,2,3,4,5</GeoTransform>").into_bytes()),
        ("dem.tif.aux.xml", pam("<GeoTransform>1,0,0,1,0,0</GeoTransform>").into_bytes()),
        ("dem.tif.aux.xml", pam("<GeoTransform>1,nan,0,1,0,1</GeoTransform>").into_bytes()),
        ("dem.tif.aux.xml", bands("band=\"2\">").into_bytes()),
        ("dem.tif.aux.xml", bands("band=\"0\">").into_bytes()),
        ("dem.tif.aux.xml", bands("band=\"1\"><Scale>0</Scale>").into_bytes()),
        ("dem.tif.aux.xml", bands("band=\"1\"><Offset>inf</Offset>").into_bytes()),
        ("dem.tif.aux.xml", bands("band=\"1\"><NoDataValue>none</NoDataValue>").into_bytes()),
        (
            "dem.tif.aux.xml",
            pam("")
                .replacen("<PAMDataset", "<PAMDataset rasterXSize=\"40\" rasterYSize=\"23\"", 1)
                .into_bytes(),
        ),
        ("dem.tif.aux.xml", pam("").replacen("EPSG:32633", "PROJCS[", 1).into_bytes()),
    ];
    for (name, bytes) in refused {
        let shown = String::from_utf8_lossy(&bytes[..bytes.len().min(80)]).into_owned();
        if name == "dem.prj" {
            folder.file("dem.tfw", WORLD.as_bytes());
        }
        let sidecar = folder.file(name, &bytes);
        for problem in [read_height(&path, &default()).map(drop), inspect(&path, &default()).map(drop)] {
            let error = problem.expect_err(&shown);
            assert!(matches!(error.problem, ReadProblem::Georeference { .. }), "{shown}: {error}");
            assert!(error.to_string().contains(name), "{shown}: {error}");
        }
        // Pictures ignore sidecar files.
        assert!(relief_io::read_picture(&path, relief_io::DEFAULT_MAX_BYTES).is_ok(), "{shown}");
        std::fs::remove_file(sidecar).expect("it was there");
    }
    // A text that is not well-known text names no system.
    folder.file("dem.tfw", WORLD.as_bytes());
    folder.file("dem.prj", b"Projection UTM\nUnits FEET\n");
    let reason = look(&path).georeference.and_then(|found| found.texel_size_m.err());
    assert!(reason.is_some_and(|reason| reason.contains("dem.prj")));
}
