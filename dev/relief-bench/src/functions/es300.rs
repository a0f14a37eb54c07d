//! Functions in GLSL ES 3.00, in a page of WebGL 2: whether they find the renderer's hits.

use std::path::Path as FilePath;
use std::process::ExitCode;

use relief_core::Wrap;
use relief_export::{ExportedFunctions, FunctionOptions, Profile, functions};
use relief_render::gpu::Prober;
use relief_render::job::JobSurface;
use relief_shaders::Selection;
use relief_shaders::cpu::Path;
use relief_shaders::wgsl::Sampling;
use relief_testing::maps;
use relief_tests::exported::fragments::{Fragments, of_paths, of_points, settings_json, textures_of};
use relief_tests::exported::{Device, paths_of, points, shortened, surface_of};
use relief_tests::one_source::rays::pixels;
use relief_tests::pairs;
use serde_json::json;

use super::without_shadow;
use crate::chromium;

/// How near hits are that count as the same, in texels.
const NEAR_TEXELS: f64 = 1.0 / 256.0;

/// Least part of the hits of a program that are as near.
const LEAST: f64 = 0.999;

/// Columns of the pictures that programs draw.
const WIDTH: usize = 500;

/// A hit: whether there is one, its texture coordinates, and the parameter or the depth.
type Found = [f32; 4];

/// A program, and what it reads.
struct Call<'a> {
    exported: &'a ExportedFunctions,
    surface: &'a JobSurface,
    fragments: Fragments,
}

/// Prints how many hits agree. Fails where too few of a program do, or where a wrong program is not noticed.
pub fn run(chromium: &FilePath, rays: usize, every: usize) -> Result<ExitCode, String> {
    let device = Device::open().ok_or("there is no software adapter")?;
    let mut prober = Prober::new(device.gpu());
    wrong_ones_are_noticed(chromium, &device, &mut prober)?;
    let (mut programs, mut all, mut same, mut near, mut least) = (0, 0, 0, 0, 1.0_f64);
    for (number, pair) in pairs::all().enumerate().step_by(every.max(1)) {
        let selection = shortened(without_shadow(pair)?);
        let cases = Wrap::ALL.into_iter().map(|wrap| Case::new(selection, number, wrap, rays));
        let cases = cases.collect::<Result<Vec<Case>, String>>()?;
        let calls: Vec<Call> = cases.iter().map(Case::call).collect();
        let found = called(chromium, &calls).map_err(|error| format!("{}: {error}", pairs::name(&pair)))?;
        for (case, found) in cases.iter().zip(found) {
            let agreed = Agreed::of(&case.hits(&mut prober)?, &found, &case.surface);
            if agreed.near_part() < LEAST {
                let part = 100.0 * agreed.near_part();
                println!("{}, {}: {part:.3} % are near", pairs::name(&pair), case.wrap);
            }
            (programs, all) = (programs + 1, all + agreed.all);
            (same, near, least) = (same + agreed.same, near + agreed.near, least.min(agreed.near_part()));
        }
    }
    println!(
        "{programs} programs, {all} paths: {near} hits within 1/256 texel of the renderer's, {same} the same \
         to the bit; {:.4} % in the program with the fewest",
        100.0 * least
    );
    Ok(if least >= LEAST { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// A pair over a map, and paths through it.
struct Case {
    wrap: Wrap,
    exported: ExportedFunctions,
    surface: JobSurface,
    paths: Vec<Path>,
}

impl Case {
    fn new(selection: Selection, number: usize, wrap: Wrap, rays: usize) -> Result<Self, String> {
        let map = &maps::ALL[(number + wrap as usize) % maps::ALL.len()];
        let heights = map.build(wrap).with_displacement(0.3, -0.3).map_err(|error| error.to_string())?;
        let rays = pixels(&heights, rays, number as u64 + 1);
        let surface = surface_of(heights, selection);
        let paths = paths_of(&surface, &rays);
        Ok(Self { wrap, exported: exported(&selection, wrap)?, surface, paths })
    }

    fn call(&self) -> Call<'_> {
        let fragments = of_paths(&self.exported, &self.paths);
        Call { exported: &self.exported, surface: &self.surface, fragments }
    }

    /// The renderer's hits.
    fn hits(&self, prober: &mut Prober) -> Result<Vec<Found>, String> {
        let hits = prober.trace(&self.surface, Sampling::Exact, &self.paths);
        let hits = hits.map_err(|error| error.to_string())?;
        Ok(hits.iter().map(|hit| [f32::from(hit.found == 1), hit.uv.x, hit.uv.y, hit.t]).collect())
    }
}

/// The functions in WGSL and in GLSL ES 3.00.
fn exported(selection: &Selection, wrap: Wrap) -> Result<ExportedFunctions, String> {
    let profiles = vec![Profile::Wgsl, Profile::Es300];
    let options = FunctionOptions { wrap: Some(wrap), profiles, ..FunctionOptions::default() };
    functions(selection, &options).map_err(|error| error.to_string())
}

/// What programs find, in one page.
fn called(chromium: &FilePath, calls: &[Call]) -> Result<Vec<Vec<Found>>, String> {
    let counts: Vec<usize> = calls.iter().map(|call| call.fragments.count()).collect();
    let rows = counts.iter().max().copied().unwrap_or_default().div_ceil(WIDTH);
    let mut files: Vec<(String, Vec<u8>)> =
        vec![("page.html".to_owned(), include_bytes!("page.html").to_vec())];
    let mut programs = Vec::new();
    for (number, Call { exported, surface, fragments }) in calls.iter().enumerate() {
        let mut textures = Vec::new();
        for (name, array, texels) in textures_of(exported, surface) {
            let file = format!("{number}_{name}.bin");
            textures.push(json!({
                "name": name, "array": array, "size": texels.size, "layers": texels.layers,
                "levels": texels.levels, "channels": texels.channels(), "file": file,
            }));
            files.push((file, texels.bytes));
        }
        let [shader, given] = [format!("{number}.glsl"), format!("{number}.bin")];
        programs.push(json!({
            "shader": shader, "settings": settings_json(exported, surface), "textures": textures,
            "given": given, "texels": fragments.texels,
        }));
        files.push((shader, fragments.shader.clone().into_bytes()));
        // What is over draws the first ones again.
        let numbers = fragments.given.iter().cycle().take(4 * fragments.texels * WIDTH * rows);
        files.push((given, numbers.flat_map(|number| number.to_le_bytes()).collect()));
    }
    let input = json!({ "size": [WIDTH, rows], "programs": programs });
    files.push(("input.json".to_owned(), input.to_string().into_bytes()));
    let files: Vec<(&str, &[u8])> = files.iter().map(|(name, bytes)| (name.as_str(), &bytes[..])).collect();
    let answer = chromium::answer(chromium, &files)?;
    let numbers: Vec<f32> = answer.as_chunks().0.iter().map(|bytes| f32::from_le_bytes(*bytes)).collect();
    if numbers.len() != 4 * WIDTH * rows * calls.len() {
        return Err(format!("the page gives {} numbers", numbers.len()));
    }
    let of = |(pixels, count): (&[f32], usize)| pixels.as_chunks().0[..count].to_vec();
    Ok(numbers.chunks(4 * WIDTH * rows).zip(counts).map(of).collect())
}

/// How many hits agree.
struct Agreed {
    all: usize,
    near: usize,
    same: usize,
}

impl Agreed {
    fn of(ours: &[Found], theirs: &[Found], surface: &JobSurface) -> Self {
        let map = &surface.height_map;
        let sides = [map.width(), map.height()].map(f64::from);
        let off = |a: &Found, b: &Found, k: usize| f64::from(a[k + 1] - b[k + 1]).abs() * sides[k];
        let both = || ours.iter().zip(theirs);
        let is_same_kind = |a: &Found, b: &Found| (a[0] == 1.0) == (b[0] == 1.0);
        let is_near = |(a, b): &(&Found, &Found)| {
            is_same_kind(a, b) && (a[0] != 1.0 || (0..2).all(|k| off(a, b, k) <= NEAR_TEXELS))
        };
        let is_same = |(a, b): &(&Found, &Found)| {
            is_same_kind(a, b) && (a[0] != 1.0 || a.map(f32::to_bits) == b.map(f32::to_bits))
        };
        Self { all: ours.len(), near: both().filter(is_near).count(), same: both().filter(is_same).count() }
    }

    fn near_part(&self) -> f64 {
        self.near as f64 / self.all.max(1) as f64
    }
}

/// Has wrong functions drawn: another wrap, a missed step, a bitangent that is turned over. Fails where one
/// passes, or where the right ones do not.
fn wrong_ones_are_noticed(chromium: &FilePath, device: &Device, prober: &mut Prober) -> Result<(), String> {
    let case = Case::new(
        without_shadow(Selection::method("relief").map_err(|e| e.to_string())?)?,
        0,
        Wrap::Repeat,
        5_000,
    )?;
    let selection = case.surface.selection;
    let other_wrap = exported(&selection, Wrap::Mirror)?;
    let missed = changed(&case.exported, ".exit * (", ".exit * (1.0 / steps + ")?;
    let turned = changed(&case.exported, "vec3(0.0, tile.y, 0.0)", "vec3(0.0, -tile.y, 0.0)")?;
    let points = points(5_000, [1.0, 1.0], 5);
    let on_paths = [&case.exported, &other_wrap, &missed].map(|of| (of, of_paths(of, &case.paths)));
    let on_points = [&case.exported, &turned].map(|of| (of, of_points(of, &points)));
    let calls: Vec<Call> = on_paths
        .into_iter()
        .chain(on_points)
        .map(|(exported, fragments)| Call { exported, surface: &case.surface, fragments })
        .collect();
    let found = called(chromium, &calls)?;
    let seen = device.seen(&case.exported, &case.surface, &points);
    let seen: Vec<Found> =
        seen.iter().map(|seen| [f32::from(seen.hit), seen.uv[0], seen.uv[1], seen.depth]).collect();
    let hits = case.hits(prober)?;
    let truths = [&hits, &hits, &hits, &seen, &seen];
    let names = ["paths", "another wrap", "a missed step", "points", "a bitangent turned over"];
    let is_right = [true, false, false, true, false];
    for (((found, truth), name), is_right) in found.iter().zip(truths).zip(names).zip(is_right) {
        let part = Agreed::of(truth, found, &case.surface).near_part();
        println!("{name}: {:.2} % are near", 100.0 * part);
        if (part >= LEAST) != is_right {
            return Err(format!("{name}: {part} of the hits are near"));
        }
    }
    Ok(())
}

/// An export with another text in place of some of its GLSL.
fn changed(exported: &ExportedFunctions, from: &str, to: &str) -> Result<ExportedFunctions, String> {
    let text = String::from_utf8_lossy(&exported.files[1].bytes).into_owned();
    if !text.contains(from) {
        return Err(format!("there is no '{from}' to change"));
    }
    let mut changed = exported.clone();
    changed.files[1].bytes = text.replace(from, to).into_bytes();
    Ok(changed)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hits_that_are_off_and_missing_ones_are_counted() {
        let method = Selection::method("relief").expect("a method");
        let case = Case::new(without_shadow(method).expect("a shadow"), 0, Wrap::Repeat, 1).expect("a case");
        let texel = 1.0 / case.surface.height_map.width() as f32;
        let hit = |off: f32| [1.0, 0.5 + off * texel, 0.5, 2.0];
        let miss = [0.0; 4];
        let agreed = |a: &[Found], b: &[Found]| {
            let Agreed { all, near, same } = Agreed::of(a, b, &case.surface);
            [all, near, same]
        };
        let ours = [hit(0.0), hit(0.0), hit(0.0), hit(0.0), miss, miss];
        let theirs = [hit(0.0), hit(1.0 / 300.0), hit(1.0 / 200.0), miss, [0.0, 7.0, 7.0, 7.0], hit(0.0)];
        assert_eq!(agreed(&ours, &theirs), [6, 3, 2]);
        assert_eq!(agreed(&ours, &ours), [6, 6, 6]);
    }
}
