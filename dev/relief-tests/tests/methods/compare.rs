//! Comparisons: what is wrong moves the figures, what is not does not, and page, records and values hold the
//! same numbers.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use relief_compare::columns::{COLUMNS, Cell, Row};
use relief_compare::{
    Case, CompareError, Compared, Comparison, Contender, ErrorRecord, Machine, PictureRecord, Records,
    Timing, csv, hits, page,
};
use relief_core::mesh::{Builtin, square};
use relief_core::{HeightMap, Lanes, Watch, Wrap};
use relief_scene::{Sampling, Scene, Surface};
use relief_shaders::Selection;
use relief_shaders::cpu::MethodTracer;
use relief_tests::accuracy::{Named, case, maps};
use relief_tests::adapter::{Leeway, has_adapter};

const SCALE_M: f64 = 0.1;

fn cobbles() -> HeightMap {
    let Named { map, .. } = maps().into_iter().find(|named| named.name == "cobbles").expect("a sample map");
    map
}

fn named(names: &[&str]) -> Vec<Contender> {
    names.iter().map(|name| Contender::named(name).expect("a method")).collect()
}

/// A comparison of a few methods in small pictures of cobbles on a square.
fn comparison(names: &[&str]) -> Comparison {
    let surface = Surface::new(square(1).expect("a square"), cobbles());
    let scene = Scene::builder(surface).size(64, 48).samples(1).build().expect("a scene");
    let mut comparison = Comparison::new("cobbles", scene);
    comparison.contenders = named(names);
    comparison.rays = 1000;
    (comparison.flicker_samples, comparison.timing) = (Some(4), None);
    comparison
}

fn run(comparison: &Comparison) -> Compared {
    comparison.run(&Watch::none()).expect("a comparison")
}

/// How wrong the hits of a picture are.
fn error(picture: &PictureRecord) -> ErrorRecord {
    picture.error.expect("a judge")
}

/// The records without the one figure that is a time.
fn timeless(mut records: Records) -> Records {
    records.rays.iter_mut().for_each(|record| record.method.bake_seconds = 0.0);
    records.pictures.iter_mut().for_each(|record| record.method.bake_seconds = 0.0);
    records
}

#[test]
fn two_runs_and_all_widths_of_lanes_find_the_same() {
    let mut comparison = comparison(&["bump", "relief", "cone", "vertex"]);
    (comparison.rays, comparison.flicker_samples) = (200, None);
    let first = timeless(run(&comparison).records);
    assert_eq!(first, timeless(run(&comparison).records));
    for lanes in Lanes::available() {
        comparison.lanes = lanes;
        assert_eq!(first, timeless(run(&comparison).records), "{lanes} lanes");
    }
}

#[test]
fn exact_methods_are_exact_and_others_are_as_wrong_as_they_are() {
    let Compared { records, .. } = run(&comparison(&["bump", "exact", "cone"]));
    assert_eq!((records.rays.len(), records.pictures.len(), records.left_out.len()), (12, 3, 0));
    for record in &records.rays {
        let (name, error) = (record.method.method.as_str(), record.error);
        if name == "bump" {
            assert!(error.median_texels > 1.0 && record.cost.reads == 0.0, "{record:?}");
        } else {
            assert!(error.passed + error.early + error.false_hits <= 2e-3, "{record:?}");
            assert!(error.p99_texels < 1e-2 && record.cost.reads >= 1.0, "{record:?}");
        }
    }
    let [bump, exact, cone] = &records.pictures[..] else { panic!("three pictures") };
    // The reference is the same picture by the same method.
    assert_eq!((exact.flip, exact.ssim, exact.psnr_db, exact.rms), (0.0, 1.0, None, 0.0));
    assert!(error(exact).max_texels == 0.0 && exact.cost.is_none());
    assert!(cone.flip < 0.01 && bump.flip > 5.0 * cone.flip && error(bump).median_texels > 1.0);
    assert!(cone.cost.is_some_and(|cost| cost.reads > 1.0));
    assert!(cone.wave_reads > cone.cost.map(|cost| cost.reads));
}

#[test]
fn one_step_less_moves_in_the_table() {
    let mut comparison = comparison(&["relief", "bump"]);
    comparison.steps = vec![32, 31];
    let Compared { records, .. } = run(&comparison);
    let of = |steps| records.rays.iter().filter(move |record| record.method.steps == Some(steps));
    assert_eq!((of(32).count(), of(31).count(), records.rays.len()), (4, 4, 12));
    for (more, fewer) in of(32).zip(of(31)) {
        assert!(more.cost.reads > fewer.cost.reads && more.error != fewer.error, "{more:?}");
    }
    assert_ne!(records.pictures[0].flip, records.pictures[1].flip);
}

#[test]
fn a_wrong_wrap_moves_in_the_table() {
    let map = cobbles();
    let clamped = HeightMap::new(map.width(), map.height(), map.texels().to_vec(), Wrap::Clamp)
        .and_then(|map| map.with_displacement(SCALE_M, -SCALE_M))
        .expect("a valid map");
    let (selection, case): (_, Case) = (Selection::exact(), case(&map, 60.0, 2000));
    let judged = |map: &HeightMap| {
        let tracer = MethodTracer::new(map, relief_core::Metric::UNIT, &selection, []).expect("no maps");
        case.judge(&hits(&tracer, &case.paths, Lanes::widest()))
    };
    let (right, wrong) = (judged(&map), judged(&clamped));
    assert!(right.late + right.early + right.missed < 2e-3, "{right:?}");
    assert!(wrong.late + wrong.early + wrong.missed > 1e-2, "{wrong:?}");
}

#[test]
fn page_and_values_hold_the_numbers_of_the_records() {
    let compared = run(&comparison(&["relief", "cone", "remesh"]));
    let html = page(&compared).expect("a page");
    let values = csv(&compared.records);
    let body = html.split("<tbody>").nth(1).and_then(|rest| rest.split("</tbody>").next()).expect("a table");
    let rows: Vec<&str> = body.split("</tr>").filter(|row| row.contains("<td")).collect();
    let lines: Vec<&str> = values.split_terminator("\r\n").skip(1).collect();
    assert_eq!((rows.len(), lines.len()), (11, 11));
    for ((row, html), line) in Row::all(&compared.records).zip(rows).zip(lines) {
        let shown: Vec<&str> = html.split("</td>").filter(|cell| cell.contains("<td")).collect();
        let written: Vec<&str> = line.split(',').collect();
        assert_eq!((shown.len(), written.len()), (COLUMNS.len(), COLUMNS.len()));
        for ((column, shown), written) in COLUMNS.iter().zip(shown).zip(written) {
            match (column.cell)(&row) {
                Cell::Empty => assert!(shown.ends_with("<td>") && written.is_empty(), "{}", column.key),
                Cell::Text(text) => {
                    assert!(shown.ends_with(&format!(">{text}")) && written == text, "{}", column.key);
                }
                Cell::Number(number) => {
                    let said = shown.split("data-value=\"").nth(1).and_then(|rest| rest.split('"').next());
                    assert_eq!(said.and_then(|said| said.parse().ok()), Some(number), "{}", column.key);
                    assert_eq!(written.parse(), Ok(number), "{}", column.key);
                }
            }
        }
    }
    let json = serde_json::to_string(&compared.records).expect("JSON");
    let read: Records = serde_json::from_str(&json).expect("records");
    assert_eq!((read.rays.len(), read.pictures.len()), (8, 3));
    // A picture and its differences for each method, the reference, and a drawing of each method that walks
    // along a ray; nothing comes from elsewhere.
    assert_eq!(html.matches("<img ").count(), 2 * 3 + 1 + 2);
    assert_eq!(html.matches("src=\"data:image/").count(), 2 * 3 + 1 + 2);
    for elsewhere in ["src=\"http", "href=", "url(", "@import", "fetch("] {
        assert!(!html.contains(elsewhere), "{elsewhere}");
    }
}

#[test]
fn curved_meshes_are_judged_in_pictures_alone() {
    let map = cobbles().with_displacement(0.03, -0.03).expect("lengths");
    let mesh = Builtin::Torus.build([1.0, 1.0]).expect("a torus");
    let mut prism = Selection::exact();
    prism.choose("surface", "prism").expect("a surface");
    let surface = Surface::new(mesh, map).with_selection(prism);
    let scene = Scene::builder(surface).size(96, 72).samples(1).build().expect("a scene");
    let mut comparison = Comparison::new("cobbles", scene);
    comparison.contenders = named(&["exact", "steep", "bump", "relaxed-cone-stepping"]);
    (comparison.flicker_samples, comparison.timing) = (None, None);
    let Compared { records, .. } = run(&comparison);
    assert!(records.rays.is_empty());
    let [exact, steep] = &records.pictures[..] else { panic!("two pictures: {:?}", records.left_out) };
    let [exact, steep] = [exact, steep].map(error);
    assert!(exact.passed < 5e-3 && exact.median_texels < 0.05, "{exact:?}");
    assert!(steep.median_texels > 10.0 * exact.median_texels, "{steep:?}");
    // In shells nothing begins at the base, and rays may begin under the relief.
    let left_out: Vec<&str> = records.left_out.iter().map(|left_out| left_out.what.as_str()).collect();
    assert_eq!(left_out, ["bump", "relaxed-cone-stepping"]);
}

#[test]
fn a_comparison_is_cancelled_wherever_it_is() {
    let mut comparison = comparison(&["bump", "cone"]);
    comparison.rays = 100;
    comparison.timing = Some(Timing { frames: 1, warm: 0, pixels: 1 });
    let told = AtomicUsize::new(0);
    let count = |_: &str, _: f32| _ = told.fetch_add(1, Ordering::Relaxed);
    comparison.run(&Watch::telling(&count)).expect("a comparison");
    let all = told.into_inner();
    // Rays and pictures of both methods, the true picture, and times.
    assert_eq!(all, 6);
    for last in 0..all {
        let (told, cancel) = (AtomicUsize::new(0), AtomicBool::new(false));
        let tell = |_: &str, _: f32| {
            let number = told.fetch_add(1, Ordering::Relaxed);
            cancel.store(number == last, Ordering::Relaxed);
        };
        let ended = comparison.run(&Watch::new(&tell, &cancel)).map(drop);
        assert!(matches!(ended, Err(CompareError::Cancelled(_))), "{last}: {ended:?}");
        assert_eq!(told.into_inner(), last + 1);
    }
}

#[test]
fn levels_of_a_map_are_compared_with_their_own_truth() {
    let mut comparison = comparison(&["cone", "relief"]);
    comparison.map_sides = vec![256, 64];
    comparison.machines.clear();
    let Compared { records, .. } = run(&comparison);
    let sides: Vec<u32> = records.rays.iter().map(|record| record.method.map_size[0]).collect();
    assert_eq!(sides, [[256; 8], [64; 8]].concat());
    for record in records.rays.iter().filter(|record| record.method.method == "cone") {
        assert!(record.error.p99_texels < 1e-2, "{record:?}");
        assert_eq!(record.method.bytes_a_texel(), 4.0);
    }
    comparison.map_sides = vec![100];
    let refused = comparison.run(&Watch::none()).map(drop).map_err(|error| error.to_string());
    assert!(refused.is_err_and(|error| error.contains("128")));
}

#[test]
fn both_backends_find_the_same_in_exact_sampling() {
    if !has_adapter() {
        return;
    }
    let mut comparison = comparison(&["bump", "relief", "cone"]);
    (comparison.rays, comparison.flicker_samples) = (0, None);
    comparison.machines = vec![Machine::CPU, Machine::gpu(Sampling::Exact)];
    let Compared { records, .. } = run(&comparison);
    let of = |backend: &str| {
        records.pictures.iter().filter(move |record| record.backend == backend).collect::<Vec<_>>()
    };
    let (cpu, gpu) = (of("cpu"), of("gpu"));
    assert_eq!((cpu.len(), gpu.len()), (3, 3));
    let leeway = Leeway::of_any();
    for (cpu, gpu) in cpu.iter().zip(&gpu) {
        let [one, other] = [cpu, gpu].map(|record| record.error.expect("pixels are judged"));
        let is_near = |a: f64, b: f64| (a - b).abs() <= f64::from(leeway.rounding - 1.0) * 1e-3;
        let shares = [(one.passed, other.passed), (one.missed, other.missed), (one.early, other.early)];
        let texels = [one.mean_texels, one.p99_texels].into_iter().zip([other.mean_texels, other.p99_texels]);
        for (a, b) in shares.into_iter().chain(texels) {
            assert!(is_near(a, b), "{}: {one:?} {other:?}", cpu.method.method);
        }
        let [one, other] = [cpu, gpu].map(|record| record.cost.expect("reads are counted").reads);
        assert!(is_near(other / one.max(1.0), one / one.max(1.0)), "{}: {one} {other}", cpu.method.method);
        assert!((cpu.flip - gpu.flip).abs() < 1e-3, "{}", cpu.method.method);
    }
}
