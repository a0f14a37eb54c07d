//! Methods as functions: the same hits as the renderer's to the bit, on a software device; small, and without
//! anything that is not used.

use naga::valid::{Capabilities, ValidationFlags, Validator};
use rayon::prelude::*;
use relief_core::exact::FastTracer;
use relief_core::rng::Rng;
use relief_core::{HeightMap, Path, PathMetric, Wrap};
use relief_export::{ExportError, ExportedFunctions, FunctionOptions, Profile, functions};
use relief_render::gpu::Prober;
use relief_render::job::JobSurface;
use relief_shaders::cpu::{Corner, Frame, PixelIn, Program, Shell};
use relief_shaders::field::Solids;
use relief_shaders::{METHODS, Selection};
use relief_testing::maps;
use relief_tests::compilers;
use relief_tests::exported::{
    Dialect, OnPath, Point, Seen, compiled, device, differing_hits as differing, paths_of, points, shortened,
    size_of, surface_of,
};
use relief_tests::one_source::rays::{bent_pixels, pixels};
use relief_tests::pairs;

/// Paths of a program.
const PATHS: usize = 100_000;

/// Methods that have functions on a surface, over heights.
pub fn methods(surface: &str) -> Vec<(&'static str, Selection)> {
    let selections =
        METHODS.iter().map(|method| (method.name, Selection::of(method).expect("its own names")));
    let on = |(name, mut selection): (&'static str, Selection)| {
        selection.choose("shadow", "none").expect("a shadow");
        selection.choose("surface", surface).ok()?;
        let is_of_heights = selection.solids() == Solids::Heights;
        let exported = functions(&selection, &FunctionOptions::default());
        (is_of_heights && exported.is_ok()).then_some((name, selection))
    };
    selections.filter_map(on).collect()
}

fn exported(selection: &Selection, wrap: Option<Wrap>) -> ExportedFunctions {
    let options = FunctionOptions { wrap, ..FunctionOptions::default() };
    functions(selection, &options).unwrap_or_else(|error| panic!("{error}"))
}

pub fn named(name: &str, wrap: Wrap) -> HeightMap {
    maps::ALL.iter().find(|map| map.name == name).expect("a map").build(wrap)
}

/// Holds the functions of every method on a surface to the renderer's bits. How many there are.
fn same_bits_on(surface: &str, count: usize) -> usize {
    let Some(device) = device() else { return usize::MAX };
    let mut prober = Prober::new(device.gpu());
    let methods = methods(surface);
    for (number, (name, selection)) in methods.iter().enumerate() {
        let selection = shortened(*selection);
        let wrap = Wrap::ALL[number % Wrap::ALL.len()];
        // The wrap is fixed in two of three.
        let fixed = Some(wrap).filter(|_| number / Wrap::ALL.len() % 3 != 2);
        let map = named("natural 101x67", wrap).with_displacement(0.3, -0.3).expect("proper numbers");
        let rays = if surface == "plane" { pixels(&map, count, 7) } else { bent_pixels(&map, count, 7) };
        let surface_of = surface_of(map, selection);
        let text = exported(&selection, fixed);
        let differing = differing(&device, &mut prober, &text, &surface_of, &rays);
        assert_eq!(differing, 0, "{name} on {surface}, {wrap}");
    }
    methods.len()
}

#[test]
fn functions_find_the_renderers_hits_to_the_bit() {
    assert!(same_bits_on("plane", PATHS) > 25);
}

#[test]
fn functions_on_bent_meshes_find_the_renderers_hits_to_the_bit() {
    assert!(same_bits_on("quadric-vertical", PATHS / 10) > 20);
    assert!(same_bits_on("quadric-perpendicular", PATHS / 10) > 3);
}

/// An export with another text in place of some of its text.
fn changed(exported: &ExportedFunctions, from: &str, to: &str) -> ExportedFunctions {
    let text = String::from_utf8(exported.files[0].bytes.clone()).expect("a text");
    assert!(text.contains(from), "{from}");
    let mut changed = exported.clone();
    changed.files[0].bytes = text.replace(from, to).into_bytes();
    changed
}

#[test]
fn wrong_functions_are_noticed() {
    let Some(device) = device() else { return };
    let mut prober = Prober::new(device.gpu());
    let mut relief = Selection::method("relief").expect("a method");
    relief.choose("shadow", "none").expect("a shadow");
    let map = named("natural 101x67", Wrap::Repeat).with_displacement(0.3, -0.3).expect("proper numbers");
    let rays = pixels(&map, 2_000, 3);
    let surface = surface_of(map, relief);
    let right = exported(&relief, Some(Wrap::Repeat));
    assert_eq!(differing(&device, &mut prober, &right, &surface, &rays), 0);
    let wrong_wrap = exported(&relief, Some(Wrap::Mirror));
    assert!(differing(&device, &mut prober, &wrong_wrap, &surface, &rays) > 10);
    let missed_step =
        changed(&right, "let t = path.exit * (k / steps);", "let t = path.exit * ((k + 1.0) / steps);");
    assert!(differing(&device, &mut prober, &missed_step, &surface, &rays) > 10);
    // From points: the bitangent turned over.
    let points = points(4_000, [1.0, 1.0], 5);
    let flipped = changed(&right, "vec3f(0.0, tile.y, 0.0)", "vec3f(0.0, -tile.y, 0.0)");
    let far = |seen: &[Seen]| errors(&surface, &points, seen).iter().filter(|error| **error > 1.0).count();
    let [right, flipped] = [&right, &flipped].map(|text| far(&device.seen(text, &surface, &points)));
    assert!(flipped > 10 * right.max(1), "{flipped} and {right}");
}

/// The way of a point's ray through the relief, in `f64`.
fn path_of(point: &Point, map: &HeightMap) -> Path {
    let [view, uv] =
        [&point.view[..], &point.uv].map(|v| v.iter().map(|x| f64::from(*x)).collect::<Vec<f64>>());
    let tile = point.tile.map(f64::from);
    let (scale, bias) = (map.scale_m(), map.bias_m());
    let at = |height: f64| (bias + height * scale) / view[2];
    let (begin, end) = (at(1.0), at(0.0));
    let place = |k: usize, t: f64| uv[k] + t * view[k] / tile[k];
    Path {
        uv: [place(0, begin), place(1, begin)],
        duv: [view[0] / tile[0], view[1] / tile[1]],
        h: [1.0, view[2] / scale, 0.0],
        exit: end - begin,
        base: -begin,
        metric: PathMetric { uu: tile[0] * tile[0], uv: 0.0, vv: tile[1] * tile[1], scale_m: scale },
    }
}

/// How many texels hits are off from the exact ones; a hit that is missed, or a miss that is hit, is far off.
fn errors(surface: &JobSurface, points: &[Point], seen: &[Seen]) -> Vec<f64> {
    let map = &surface.height_map;
    let tracer = FastTracer::new(map);
    let off = |(point, seen): (&Point, &Seen)| {
        let exact = tracer.trace(&path_of(point, map)).hit;
        if exact.found != seen.hit {
            return 1e9;
        }
        let off = |k: usize, side: u32| (exact.uv[k] - f64::from(seen.uv[k])) * f64::from(side);
        off(0, map.width()).hypot(off(1, map.height()))
    };
    points.par_iter().zip(seen.par_iter()).map(off).collect()
}

/// A point's ray, and a triangle with the same frame.
pub fn pixel_of(point: &Point) -> PixelIn {
    let Point { uv, view, tile, curvature, .. } = *point;
    let corner = |u: f32, v: f32| {
        let place = [u * tile[0], v * tile[1], 0.0];
        let at = [uv[0] + u, uv[1] + v];
        Corner::new(place, [0.0, 0.0, 1.0], [tile[0], 0.0, 0.0], [0.0, tile[1], 0.0], at, curvature)
    };
    let (a, b, c) = (corner(-0.5, -0.5), corner(0.5, -0.5), corner(0.0, 0.5));
    PixelIn::new(view.map(|x| -16.0 * x), view, 1.0, a, b, c, Shell::whole())
}

/// The renderer's hits for points.
fn rendered(program: &Program<'_>, points: &[Point]) -> Vec<Seen> {
    let seen = |point: &Point| {
        let view = point.view;
        let origin = view.map(|x| -16.0 * x);
        let pixel = pixel_of(point);
        let at = program.enter(pixel);
        let first = program.first_hit(pixel, at);
        let placed = program.place(pixel, at, first.segment, first.hit);
        let hit = first.hit;
        let depth = ((placed.point.x - origin[0]) * view[0]
            + (placed.point.y - origin[1]) * view[1]
            + (placed.point.z - origin[2]) * view[2])
            - 16.0;
        Seen {
            hit: hit.found == 1,
            uv: [hit.uv.x, hit.uv.y],
            height: hit.height,
            depth,
            normal: [placed.normal.x, placed.normal.y, placed.normal.z],
            light: 0.0,
        }
    };
    points.par_iter().map(seen).collect()
}

/// The number at a part of sorted ones.
fn at_part(mut numbers: Vec<f64>, part: f64) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers[((numbers.len() - 1) as f64 * part) as usize]
}

#[test]
fn hits_from_points_are_as_near_the_truth_as_the_renderers() {
    let Some(device) = device() else { return };
    for (method, tile) in
        [("relief", [1.0, 1.0]), ("cone", [2.0, 0.5]), ("exact", [0.3, 0.3]), ("occlusion", [1.0, 2.0])]
    {
        let mut selection = shortened(Selection::method(method).expect("a method"));
        selection.choose("shadow", "none").expect("a shadow");
        let map =
            named("natural 128x128", Wrap::Repeat).with_displacement(0.1, -0.1).expect("proper numbers");
        let surface = surface_of(map, selection);
        let points = points(20_000, tile, 11);
        let own = errors(
            &surface,
            &points,
            &device.seen(&exported(&selection, Some(Wrap::Repeat)), &surface, &points),
        );
        let program = surface.program(Frame::none(), None);
        let theirs = errors(&surface, &points, &rendered(&program, &points));
        for part in [0.5, 0.99] {
            let [own, theirs] = [&own, &theirs].map(|errors| at_part(errors.clone(), part));
            println!("{method}, {part}: {own:.6} and {theirs:.6} texels");
            assert!(own <= 1.5 * theirs, "{method}, {part}: {own} and {theirs}");
        }
    }
}

#[test]
fn bent_meshes_show_what_the_renderer_shows() {
    let Some(device) = device() else { return };
    for surface in ["quadric-vertical", "quadric-perpendicular"] {
        let mut selection = Selection::method("relief").expect("a method");
        selection.choose("shadow", "none").expect("a shadow");
        selection.choose("surface", surface).expect("a surface");
        let map =
            named("natural 128x128", Wrap::Repeat).with_displacement(0.1, -0.1).expect("proper numbers");
        let of_map = surface_of(map, selection);
        let mut points = points(20_000, [1.0, 1.0], 13);
        let mut rng = Rng::new(17);
        for point in &mut points {
            point.curvature = [0, 1, 2].map(|_| rng.between(-0.5, 0.5) as f32);
        }
        let own = device.seen(&exported(&selection, Some(Wrap::Repeat)), &of_map, &points);
        let program = of_map.program(Frame::none(), None);
        let theirs = rendered(&program, &points);
        let agrees = |(own, theirs): &(&Seen, &Seen)| {
            let near = |a: f32, b: f32, most: f32| (a - b).abs() <= most;
            own.hit == theirs.hit
                && (!own.hit || (0..2).all(|k| near(own.uv[k], theirs.uv[k], 1e-4)))
                && (!own.hit || near(own.depth, theirs.depth, 1e-3))
        };
        let agreeing = own.iter().zip(&theirs).filter(agrees).count();
        let misses = own.iter().filter(|seen| !seen.hit).count();
        println!("{surface}: {agreeing} of {} agree, {misses} pass", points.len());
        assert!(agreeing * 1000 >= points.len() * 998, "{surface}: {agreeing} of {}", points.len());
        assert!(misses > 100, "{surface} has no silhouettes");
    }
}

#[test]
fn light_arrives_where_nothing_is_between() {
    let Some(device) = device() else { return };
    for method in ["relief", "cone"] {
        let mut selection = shortened(Selection::method(method).expect("a method"));
        selection.choose("shadow", "ray").expect("a shadow");
        let map =
            named("natural 128x128", Wrap::Repeat).with_displacement(0.2, -0.2).expect("proper numbers");
        let surface = surface_of(map, selection);
        let points = points(20_000, [1.0, 1.0], 19);
        let seen = device.seen(&exported(&selection, Some(Wrap::Repeat)), &surface, &points);
        let map = &surface.height_map;
        let tracer = FastTracer::new(map);
        // A ray that begins a little above the hit, in `f64`.
        let is_free = |(point, seen): (&Point, &Seen)| {
            let toward = point.toward.map(f64::from);
            let begin = f64::from(seen.height) + 2e-4;
            let rise = toward[2] / map.scale_m();
            let path = Path {
                uv: seen.uv.map(f64::from),
                duv: [toward[0], toward[1]],
                h: [begin, rise, 0.0],
                exit: (1.0 - begin).max(0.0) / rise,
                base: 0.0,
                metric: PathMetric::unit(map.scale_m()),
            };
            !tracer.is_blocked(&path)
        };
        let hits: Vec<_> = points.iter().zip(&seen).filter(|(_, seen)| seen.hit).collect();
        let right = hits.iter().filter(|(point, seen)| is_free((point, seen)) == (seen.light > 0.5)).count();
        let lit = hits.iter().filter(|(_, seen)| seen.light > 0.5).count();
        println!("{method}: {right} of {} lights are right, {lit} arrive", hits.len());
        assert!(right * 100 >= hits.len() * 99, "{method}: {right} of {}", hits.len());
        assert!(lit > hits.len() / 4 && lit < hits.len() * 99 / 100);
    }
}

#[test]
fn functions_are_small() {
    let of = |method: &str, surface: &str, shadow: &str| {
        let mut selection = Selection::method(method).expect("a method");
        selection.choose("surface", surface).expect("a surface");
        selection.choose("shadow", shadow).expect("a shadow");
        size_of(&exported(&selection, Some(Wrap::Repeat)))
    };
    let within =
        |[lines, bytes]: [usize; 2], most: [f64; 2]| lines as f64 <= most[0] && bytes as f64 <= most[1];
    let [relief, cone] = ["relief", "cone"].map(|method| of(method, "plane", "none"));
    assert!(within(relief, [280.0, 10_000.0]), "{relief:?}");
    assert!(within(cone, [450.0, 17_000.0]), "{cone:?}");
    for (method, plain) in [("relief", relief), ("cone", cone)] {
        let lit = of(method, "plane", "ray");
        assert!(within(lit, plain.map(|size| 1.6 * size as f64)), "{method}: {lit:?} over {plain:?}");
        let bent = of(method, "quadric-vertical", "none");
        let most = [plain[0] as f64 + 130.0, plain[1] as f64 + 5_000.0];
        assert!(within(bent, most), "{method}: {bent:?} over {plain:?}");
    }
}

/// What a text declares and does not use, by its words.
fn unused(exported: &ExportedFunctions) -> Vec<String> {
    let text = String::from_utf8(exported.files[0].bytes.clone()).expect("a text");
    let code: String =
        text.lines().filter(|line| !line.trim().starts_with("//")).map(|line| format!("{line}\n")).collect();
    let words = |text: &str| -> Vec<String> {
        text.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).map(str::to_owned).collect()
    };
    let all = words(&code);
    let is_once = |name: &String| all.iter().filter(|word| *word == name).count() < 2;
    let lent: Vec<&str> = exported.manifest.functions.iter().map(|lent| lent.declaration.as_str()).collect();
    let mut unused = Vec::new();
    for declared in code.split("\nfn ").skip(1) {
        let name = declared.split('(').next().unwrap_or_default().to_owned();
        let is_lent = lent.iter().any(|lent| lent.starts_with(&format!("fn {name}(")));
        if !is_lent && is_once(&name) {
            unused.push(name.clone());
        }
        let (head, body) = declared.split_once("{\n").expect("a body");
        let body = words(body.split("\n}").next().unwrap_or_default());
        for parameter in head.split(['(', ',']).skip(1).filter_map(|of| of.split_once(':')) {
            let parameter = parameter.0.trim().to_owned();
            if !body.contains(&parameter) {
                unused.push(format!("{name}: {parameter}"));
            }
        }
        for local in body.windows(2).filter(|pair| pair[0] == "let" || pair[0] == "var").map(|pair| &pair[1])
        {
            if body.iter().filter(|word| *word == local).count() < 2 {
                unused.push(format!("{name}: {local}"));
            }
        }
    }
    for declared in code.lines().filter_map(|line| line.strip_prefix("const ")) {
        let name = declared.split(' ').next().unwrap_or_default().to_owned();
        if is_once(&name) {
            unused.push(name);
        }
    }
    unused
}

#[test]
fn nothing_in_functions_is_unused() {
    let mut selections: Vec<(String, Selection)> = Vec::new();
    for surface in ["plane", "quadric-vertical", "quadric-perpendicular"] {
        for (place, (name, mut selection)) in methods(surface).into_iter().enumerate() {
            let shadow = ["none", "ray", "soft", "heuristic", "horizon", "visibility"][place % 6];
            selection.choose("shadow", shadow).expect("a shadow");
            selections.push((format!("{name}, {surface}, {shadow}"), selection));
        }
    }
    // Every other pair; `relief-bench functions` runs all.
    for pair in pairs::all().step_by(2) {
        let mut selection = pair;
        selection.choose("shadow", "none").expect("a shadow");
        selections.push((pairs::name(&pair), selection));
    }
    selections.par_iter().enumerate().for_each(|(number, (name, selection))| {
        let mut selection = *selection;
        if number % 3 == 0 {
            let mut fading = selection;
            fading.choose("detail", ["footprint", "fade"][number % 2]).expect("a level of detail");
            if functions(&fading, &FunctionOptions::default()).is_ok() {
                selection = fading;
            }
        }
        let wrap = [Some(Wrap::Repeat), Some(Wrap::Clamp), None, Some(Wrap::Mirror)][number % 4];
        let options = FunctionOptions { wrap, holes: number % 2 == 0, ..FunctionOptions::default() };
        let exported = match functions(&selection, &options) {
            Ok(exported) => exported,
            Err(ExportError::Invalid(said)) => panic!("{name}: {said}"),
            Err(_) => return,
        };
        let text = String::from_utf8(exported.files[0].bytes.clone()).expect("a text");
        let module = naga::front::wgsl::parse_str(&text).unwrap_or_else(|error| panic!("{name}: {error}"));
        let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
        validator.validate(&module).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(unused(&exported), Vec::<String>::new(), "{name}");
        if number % 8 == 0 {
            assert_eq!(functions(&selection, &options), Ok(exported), "{name} is the same again");
        }
    });
    println!("{} selections", selections.len());
    assert!(selections.len() > 100);
}

#[test]
fn what_has_no_functions_is_refused() {
    let refused = |change: &dyn Fn(&mut Selection, &mut FunctionOptions)| {
        let mut selection = Selection::method("relief").expect("a method");
        let mut options = FunctionOptions::default();
        change(&mut selection, &mut options);
        functions(&selection, &options).expect_err("a refusal").to_string()
    };
    let choose = |key: &'static str, name: &'static str| {
        refused(&move |selection, _| selection.choose(key, name).expect("a name"))
    };
    assert!(choose("surface", "prism").contains("'plane'"));
    assert!(choose("shadow", "map").contains("'ray'"));
    assert!(
        refused(&|selection, _| *selection = Selection::method("vertex").expect("a method"))
            .contains("vertex")
    );
    let translucent = |selection: &mut Selection, _: &mut FunctionOptions| {
        *selection = Selection::method("translucent").expect("a method");
        selection.choose("surface", "plane").expect("a surface");
    };
    println!("{}", refused(&translucent));
    assert!(refused(&translucent).contains("nothing is hit"));
    for prefix in ["", "9", "Relief", "a b", "gl", "while", "a__b", "a_"] {
        let said = refused(&|_, options| options.prefix = prefix.to_owned());
        assert!(said.contains("prefix"), "{prefix}: {said}");
    }
}

#[test]
fn the_documents_shader_calls_functions() {
    let page = include_str!("../../../../docs/functions.md");
    let shader = page.split("```wgsl\n").nth(1).and_then(|rest| rest.split("```").next()).expect("a shader");
    let mut cone = Selection::method("cone").expect("a method");
    cone.choose("shadow", "ray").expect("a shadow");
    let text = String::from_utf8(exported(&cone, Some(Wrap::Repeat)).files[0].bytes.clone()).expect("a text");
    let validated = |shader: &str| {
        let module =
            naga::front::wgsl::parse_str(&format!("{text}\n{shader}")).map_err(|error| error.to_string())?;
        let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
        validator.validate(&module).map(drop).map_err(|error| error.to_string())
    };
    assert_eq!(validated(shader), Ok(()));
    assert!(validated(&shader.replace("relief_hit(", "relief_hits(")).is_err());
}

/// The functions of a selection in WGSL and another profile.
pub fn in_two(selection: &Selection, wrap: Option<Wrap>, profile: Profile) -> ExportedFunctions {
    let profiles = vec![Profile::Wgsl, profile];
    let options = FunctionOptions { wrap, profiles, ..FunctionOptions::default() };
    functions(selection, &options).unwrap_or_else(|error| panic!("{error}"))
}

/// Holds the functions of every method on a surface in other languages to WGSL's hits. How many there are.
fn same_hits_on(surface: &str) -> usize {
    let Some(device) = device().filter(|_| compilers::are_there()) else { return usize::MAX };
    let methods = methods(surface);
    for (number, (name, selection)) in methods.iter().enumerate() {
        let selection = shortened(*selection);
        let wrap = Wrap::ALL[number % Wrap::ALL.len()];
        let map = named("natural 101x67", wrap).with_displacement(0.3, -0.3).expect("proper numbers");
        let count = PATHS / 50;
        let rays = if surface == "plane" { pixels(&map, count, 9) } else { bent_pixels(&map, count, 9) };
        let side = f64::from(map.width().max(map.height()));
        let surface_of = surface_of(map, selection);
        let paths = paths_of(&surface_of, &rays);
        let fixed = Some(wrap).filter(|_| number % 3 != 2);
        let glsl = in_two(&selection, fixed, Profile::Vulkan450);
        let own = device.traced(&glsl, &surface_of, &paths, Dialect::Wgsl);
        let bits = |hit: &OnPath| (hit.found, [hit.uv[0], hit.uv[1], hit.t].map(f32::to_bits));
        let same = device.traced(&glsl, &surface_of, &paths, Dialect::Glsl);
        let differing = own.iter().zip(&same).filter(|(a, b)| bits(a) != bits(b)).count();
        assert_eq!(differing, 0, "{name} in GLSL on {surface}, {wrap}");
        // HLSL rounds otherwise: of rays that graze something on purpose more than a thousandth would differ.
        let mut points = points(count, [1.0, 1.0], 23);
        for point in points.iter_mut().filter(|_| surface != "plane") {
            point.curvature = [0.2, 0.1, -0.1];
        }
        let paths = paths_of(&surface_of, &points.iter().map(pixel_of).collect::<Vec<_>>());
        let own = device.traced(&glsl, &surface_of, &paths, Dialect::Wgsl);
        let hlsl = in_two(&selection, fixed, Profile::Hlsl51);
        let other = device.traced(&hlsl, &surface_of, &paths, Dialect::Hlsl);
        let is_far = |(a, b): &(&OnPath, &OnPath)| {
            let off = (0..2).map(|k| f64::from(a.uv[k] - b.uv[k]).abs() * side).fold(0.0, f64::max);
            a.found != b.found || off > 1e-4
        };
        let far = own.iter().zip(&other).filter(is_far).count();
        assert!(far * 1000 <= own.len(), "{name} in HLSL on {surface}, {wrap}: {far} of {}", own.len());
    }
    methods.len()
}

#[test]
fn other_languages_find_the_same_hits() {
    assert!(same_hits_on("plane") > 25);
}

#[test]
fn other_languages_find_the_same_hits_on_bent_meshes() {
    assert!(same_hits_on("quadric-vertical") > 20);
}

#[test]
fn every_language_compiles_and_is_not_much_longer() {
    if !compilers::are_there() {
        return;
    }
    let mut cases: Vec<(String, Selection)> = Vec::new();
    for (place, surface) in ["plane", "quadric-vertical", "quadric-perpendicular"].into_iter().enumerate() {
        for (number, (name, mut selection)) in methods(surface).into_iter().enumerate() {
            selection.choose("shadow", ["none", "ray", "soft", "horizon"][number % 4]).expect("a shadow");
            // The next surface takes the others.
            let is_taken = (number + place) % 2 == 0;
            if is_taken && functions(&selection, &FunctionOptions::default()).is_ok() {
                cases.push((format!("{name} on {surface}"), selection));
            }
        }
    }
    // Each takes two in turns.
    let profiles = [Profile::Core330, Profile::Es300, Profile::Vulkan450, Profile::Hlsl51, Profile::Msl20];
    cases.par_iter().enumerate().for_each(|(number, (name, selection))| {
        let wrap = Some(Wrap::ALL[number % 3]).filter(|_| number % 4 != 3);
        let size = |exported: &ExportedFunctions, place: usize| {
            let alone = ExportedFunctions { files: vec![exported.files[place].clone()], ..exported.clone() };
            size_of(&alone)[1]
        };
        for profile in [profiles[number % 5], profiles[(number + 2) % 5]] {
            let exported = in_two(selection, wrap, profile);
            let [own, other] = [0, 1].map(|place| size(&exported, place));
            println!("{name}, {}: {:.2}", profile.name(), other as f64 / own as f64);
            assert!(other as f64 <= 1.8 * own as f64, "{name} in {}: {other} of {own}", profile.name());
            let text = String::from_utf8(exported.files[1].bytes.clone()).expect("a text");
            for foreign in ["_group_", "_fs2p", "void main", "_entry("] {
                assert!(!text.contains(foreign), "{name} in {}: {foreign}", profile.name());
            }
            assert!(text.contains("// Where the ray through a point of the mesh meets the relief first."));
            compiled(&text, profile, &|vector| calls(&text, vector))
                .unwrap_or_else(|error| panic!("{name} in {}: {error}", profile.name()));
        }
    });
    println!("{} selections", cases.len());
    assert!(cases.len() > 20);
}

/// What a fragment shader does with the functions of a text.
fn calls(text: &str, vector: &str) -> String {
    let has = |function: &str| text.contains(&format!(" {function}("));
    let bent =
        if has("relief_curvature") { "at.curvature = relief_curvature(place, place, at.uv);" } else { "" };
    let light = if has("relief_light") { "sum *= relief_light(settings, at, hit, at.view);" } else { "" };
    format!(
        "ReliefPoint at;\n    at.uv = {vector}2(0.5, 0.25);\n    at.view = {vector}3(0.0, 0.6, -0.8);\n    \
         {vector}3 place = {vector}3(at.uv, 1.0);\n    at.tile = relief_tile(place, at.uv);\n    {bent}\n    \
         ReliefHit hit = relief_hit(settings, at);\n    float sum = hit.depth + hit.height;\n    {light}\n"
    )
}
