//! Exported shaders before the compilers of their languages.

use std::collections::BTreeSet;
use std::path::Path;

use naga::valid::{Capabilities, ValidationFlags, Validator};
use rayon::prelude::*;
use relief_export::{Exported, Options, Placement, Profile, export};
use relief_shaders::wgsl::Sampling;
use relief_shaders::{Entry, METHODS, Selection, Stage, refine, search, stage};
use relief_tests::compilers::{self, GLSLANG, SPIRV_VAL, run};
use relief_tests::pairs;

/// The languages that have two versions are written in turns. Of MSL there is no compiler here: that it can
/// be written is all that is seen.
const TURNS: [&[Profile]; 2] = [
    &[Profile::Wgsl, Profile::Core450, Profile::Hlsl51, Profile::Msl20, Profile::Spirv13],
    &[Profile::Es310, Profile::Hlsl60],
];

/// Files that are compiled of a selection in each of these.
const FILES_OF_TURNS: [usize; 2] = [5, 3];

/// Files that are compiled of a selection in all turns and samplings.
const FILES: usize = 2 * (FILES_OF_TURNS[0] + FILES_OF_TURNS[1]);

fn wgsl(text: &str) -> Result<(), String> {
    let module = naga::front::wgsl::parse_str(text).map_err(|error| error.emit_to_string(text))?;
    let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
    validator.validate(&module).map(drop).map_err(|error| error.emit_to_string(text))
}

/// Writes the files of an export into a folder and has each compiled for its stages. How many were.
fn compile(exported: &Exported, folder: &Path) -> Result<usize, String> {
    for file in &exported.files {
        std::fs::write(folder.join(&file.name), &file.bytes).map_err(|error| error.to_string())?;
    }
    let written = exported.manifest.targets.iter();
    let files: Vec<_> = written.flat_map(|written| &written.files).collect();
    let ending = |ending: &'static str| files.iter().copied().filter(move |file| file.file.ends_with(ending));
    let texts = exported.files.iter().filter(|file| file.name.ends_with(".wgsl"));
    texts.clone().try_for_each(|file| wgsl(&String::from_utf8_lossy(&file.bytes)))?;
    let glsl: Vec<&str> = ending(".glsl").map(|file| file.file.as_str()).collect();
    if !glsl.is_empty() {
        run(folder, GLSLANG, &glsl)?;
    }
    for file in ending(".hlsl") {
        for entry in &file.entry_points {
            let stage = if entry.stage == "vertex" { "vert" } else { "frag" };
            let made = format!("{stage}.spv");
            // Without its optimiser, which takes seconds and finds no mistakes.
            let arguments = ["-D", "-V", "-Od", "-S", stage, "-e", &entry.name, "-o", &made, &file.file];
            run(folder, GLSLANG, arguments)?;
        }
    }
    for file in ending(".spv") {
        run(folder, SPIRV_VAL, ["--target-env", "vulkan1.1", &file.file])?;
    }
    Ok(texts.count() + glsl.len() + ending(".hlsl").count() + ending(".spv").count())
}

/// A sampling, and the profiles of a turn.
type Turn = (Sampling, &'static [Profile]);

fn turns() -> Vec<Turn> {
    let of_sampling = |sampling| TURNS.map(|profiles| (sampling, profiles));
    Sampling::ALL.into_iter().flat_map(of_sampling).collect()
}

/// Has each selection exported in every profile and sampling, and compiled. How many files were.
fn validate_all(selections: &[(String, Selection)], depth: bool) -> usize {
    let turns = turns();
    validate(selections.iter().flat_map(|of| turns.iter().map(move |turn| (of, *turn))).collect(), depth)
}

/// Has each selection exported in the profiles and the sampling of its turn, and compiled. How many files
/// were.
fn validate(cases: Vec<(&(String, Selection), Turn)>, depth: bool) -> usize {
    cases
        .into_par_iter()
        .map(|((name, selection), (sampling, profiles))| {
            let folder = tempfile::tempdir().expect("a temporary folder");
            let profiles = profiles.to_vec();
            let options = Options { sampling, profiles, depth, ..Options::default() };
            let exported = export(selection, &options).unwrap_or_else(|error| panic!("{name}: {error}"));
            compile(&exported, folder.path())
                .unwrap_or_else(|error| panic!("{name}, {sampling}, {:?}: {error}", options.profiles))
        })
        .sum()
}

#[test]
fn every_method_compiles_in_every_target() {
    if !compilers::are_there() {
        return;
    }
    let methods = METHODS
        .iter()
        .filter(|method| ["none", "object", "slices", "object-slices"].contains(&method.geometry));
    let methods: Vec<_> =
        methods.map(|of| (of.name.to_owned(), Selection::of(of).expect("its own names"))).collect();
    let files = validate_all(&methods, true);
    println!("{} methods in {files} files", methods.len());
    assert_eq!(files, methods.len() * FILES);
}

#[test]
fn every_pair_compiles() {
    if !compilers::are_there() {
        return;
    }
    // A pair takes one turn, and the next search or refinement the next: most of the time goes into the
    // compilers. Methods take all turns, above.
    let turns = turns();
    let pairs: Vec<_> =
        pairs::all().filter(|pair| pair.check().is_ok()).map(|pair| (pairs::name(&pair), pair)).collect();
    let place =
        |name: &str, entries: &[Entry]| entries.iter().position(|it| it.name == name).expect("listed");
    let of_turn = |(_, pair): &(String, Selection)| {
        let [search, refine] = [pair.search(), pair.refine()];
        turns[(place(search.name, search::ENTRIES) + place(refine.name, refine::ENTRIES)) % turns.len()]
    };
    let files = validate(pairs.iter().map(|pair| (pair, of_turn(pair))).collect(), false);
    println!("{} pairs in {files} files", pairs.len());
    let files_of = |(_, profiles): Turn| FILES_OF_TURNS[usize::from(profiles != TURNS[0])];
    assert_eq!(files, pairs.iter().map(|pair| files_of(of_turn(pair))).sum::<usize>());
}

#[test]
fn every_other_stage_compiles_on_top_of_a_method() {
    if !compilers::are_there() {
        return;
    }
    let mut selections = Vec::new();
    for key in ["surface", "detail", "shadow", "shadow-search", "ambient"] {
        let (_, Stage { entries, .. }) = stage(key).expect("a stage");
        for entry in *entries {
            let mut selection = Selection::method("relief").expect("a method");
            selection.choose(key, entry.name).expect("a listed name");
            if selection.check().is_ok() && selection.rays_through_scene().is_none() {
                selections.push((format!("{key} {}", entry.name), selection));
            }
        }
    }
    let mut facets = Selection::pair("none", "none").expect("names");
    facets.choose("surface", "facets").expect("a surface");
    facets.choose("shadow", "map").expect("a shadow");
    selections.push(("facets".to_owned(), facets));
    let kinds: BTreeSet<&str> = selections.iter().filter_map(|(name, _)| name.split(' ').next()).collect();
    assert_eq!(kinds.len(), 6);
    let files = validate_all(&selections, false);
    println!("{} selections in {files} files", selections.len());
    assert_eq!(files, selections.len() * FILES);
}

#[test]
fn placed_bindings_compile() {
    if !compilers::are_there() {
        return;
    }
    let selection = Selection::method("cone").expect("a method");
    for profiles in TURNS {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let placement = Some(Placement { group: 3, first_binding: 8 });
        let sampling = Sampling::Fast;
        let options = Options { profiles: profiles.to_vec(), placement, sampling, ..Options::default() };
        compile(&export(&selection, &options).expect("an export"), folder.path()).expect("it compiles");
    }
}

#[test]
fn a_broken_export_is_noticed_in_every_language() {
    if !compilers::are_there() {
        return;
    }
    let selection = Selection::method("steep").expect("a method");
    for profile in Profile::ALL.into_iter().filter(|profile| *profile != Profile::Msl20) {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let options = Options { profiles: vec![profile], ..Options::default() };
        let exported = export(&selection, &options).expect("an export");
        assert_eq!(compile(&exported, folder.path()).err(), None, "{profile:?}");
        for at in 0..exported.files.len() - 1 {
            let mut broken = exported.clone();
            let bytes = &mut broken.files[at].bytes;
            if profile == Profile::Spirv13 {
                // The bound of the identifiers.
                bytes[12..16].copy_from_slice(&2u32.to_le_bytes());
            } else {
                let text = String::from_utf8_lossy(bytes).replace("clip_of(", "clip_elsewhere(");
                *bytes = text.replacen("clip_elsewhere(", "clip_of(", 1).into_bytes();
                let text = String::from_utf8_lossy(bytes).replace("search_linear(", "search_elsewhere(");
                *bytes = text.replacen("search_elsewhere(", "search_linear(", 1).into_bytes();
            }
            assert!(compile(&broken, folder.path()).is_err(), "{profile:?} {at}");
        }
    }
}
