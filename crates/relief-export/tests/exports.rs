//! Tests of the content of exports, without their compilers.

use std::collections::{BTreeSet, HashMap};

use rayon::prelude::*;
use relief_export::{ExportError, Exported, Options, Placement, Profile, Target, export};
use relief_shaders::wgsl::Sampling;
use relief_shaders::{METHODS, REFINE, SEARCH, STAGES, Selection, SelectionError};
use serde_json::Value;

fn method(name: &str) -> Selection {
    Selection::method(name).expect("a method")
}

fn options(profiles: &[Profile]) -> Options {
    Options { profiles: profiles.to_vec(), ..Options::default() }
}

/// The texts of an export, with their profiles and names.
fn texts(exported: &Exported) -> Vec<(&str, &str)> {
    let texts = exported.files.iter().filter(|file| !file.name.ends_with(".spv"));
    texts
        .filter(|file| !file.name.ends_with(".json"))
        .map(|file| (file.name.as_str(), std::str::from_utf8(&file.bytes).expect("text")))
        .collect()
}

/// A text without its comments.
fn code(text: &str) -> String {
    text.lines().map(|line| line.split("//").next().unwrap_or_default()).collect::<Vec<_>>().join("\n")
}

/// The words of a text that are names.
fn names(text: &str) -> impl Iterator<Item = &str> {
    text.split(|letter: char| !letter.is_ascii_alphanumeric() && letter != '_')
}

/// The functions that a text defines: the word before the first `(` of a line that begins at the
/// margin, if a body follows.
fn defined(text: &str) -> Vec<&str> {
    let lines: Vec<&str> = text.lines().collect();
    let mut found = Vec::new();
    for (at, line) in lines.iter().enumerate() {
        let head = line.split('(').next().unwrap_or_default();
        let is_head = line.contains('(')
            && !line.starts_with([' ', '}', '@', '#', ','])
            && !["layout", "struct", "cbuffer", "const ", "var", "static", "typedef", "constant", "uniform"]
                .iter()
                .any(|begin| line.starts_with(begin));
        let body = lines[at..].iter().find(|line| line.ends_with(['{', ';']));
        if is_head && body.is_some_and(|line| line.ends_with('{')) {
            found.extend(names(head).filter(|name| !name.is_empty()).last());
        }
    }
    found
}

/// Functions that a text defines but nothing calls.
fn uncalled<'a>(text: &'a str, entry_points: &BTreeSet<&str>) -> Vec<&'a str> {
    let mut counts = HashMap::new();
    for name in names(text) {
        *counts.entry(name).or_insert(0) += 1;
    }
    defined(text).into_iter().filter(|name| !entry_points.contains(name) && counts[name] < 2).collect()
}

#[test]
fn no_export_holds_a_function_that_it_does_not_call() {
    let methods: Vec<_> = METHODS.iter().filter(|method| method.geometry == "none").collect();
    let counted: Vec<usize> = methods
        .par_iter()
        .flat_map_iter(|of| Sampling::ALL.map(|sampling| (of.name, sampling)))
        .map(|(name, sampling)| {
            let options = Options { sampling, depth: true, ..options(&Profile::ALL) };
            let one_each: [&[Profile]; 2] = [
                &[Profile::Wgsl, Profile::Core450, Profile::Hlsl51, Profile::Msl20],
                &[Profile::Es310, Profile::Hlsl60],
            ];
            let mut functions = 0;
            for profiles in one_each {
                let exported =
                    export(&method(name), &Options { profiles: profiles.to_vec(), ..options.clone() });
                let exported = exported.expect("an export");
                let targets = &exported.manifest.targets;
                let entries =
                    targets.iter().flat_map(|written| &written.files).flat_map(|file| &file.entry_points);
                let entries: BTreeSet<&str> = entries.map(|entry| entry.name.as_str()).collect();
                for (file, text) in texts(&exported) {
                    let text = code(text);
                    assert_eq!(uncalled(&text, &entries), Vec::<&str>::new(), "{file} {sampling}");
                    functions += defined(&text).len();
                }
            }
            functions
        })
        .collect();
    // The vertex stage has two, and a fragment stage dozens.
    assert!(counted.iter().all(|count| *count > 100), "{counted:?}");
}

#[test]
fn a_function_that_nothing_calls_is_seen() {
    let exported = export(&method("steep"), &options(&[Profile::Core450])).expect("an export");
    let [_, (_, fragment)] = texts(&exported)[..] else { panic!("two stages") };
    let text = code(fragment) + "\nfloat left_over(float x) {\n    return x;\n}\n";
    assert_eq!(uncalled(&text, &BTreeSet::from(["main"])), ["left_over"]);
}

#[test]
fn the_manifest_names_what_the_files_hold() {
    for sampling in Sampling::ALL {
        for profile in Profile::ALL {
            let options = Options { sampling, ..options(&[profile]) };
            let exported = export(&method("cone"), &options).expect("an export");
            let json = &exported.files.last().expect("files").bytes;
            let json: Value = serde_json::from_slice(json).expect("JSON");
            assert_eq!(json["name"], "cone-patch");
            let files = json["targets"][0]["files"].as_array().expect("files");
            let written: Vec<_> = exported.files.iter().map(|file| file.name.as_str()).collect();
            let named: Vec<_> = files.iter().filter_map(|file| file["file"].as_str()).collect();
            assert_eq!(written[..written.len() - 1], named);
            for (file, bytes) in files.iter().zip(&exported.files) {
                // Names of SPIR-V stand in it, too.
                let text = String::from_utf8_lossy(&bytes.bytes);
                let bindings = file["bindings"].as_array().expect("bindings");
                let called = bindings.iter().filter_map(|binding| binding["as"].as_str());
                let entries = file["entry_points"].as_array().expect("entries");
                for name in called.chain(entries.iter().filter_map(|entry| entry["name"].as_str())) {
                    let code = text.lines().filter(|line| !line.starts_with("//"));
                    assert!(code.into_iter().any(|line| line.contains(name)), "{profile:?}: {name}");
                }
                let has_sampler = bindings
                    .iter()
                    .any(|binding| binding["name"] == "map_sampler" || binding["sampler"] == "map_sampler");
                let samples = file["entry_points"].to_string().contains("fragment");
                assert_eq!(has_sampler, sampling == Sampling::Fast && samples, "{profile:?}");
            }
        }
    }
}

#[test]
fn parameters_are_values_to_begin_with_at_their_place_in_the_buffer() {
    let mut selection = method("relief");
    selection.set("search.steps", 77.0).expect("a setting");
    let exported = export(&selection, &options(&[Profile::Wgsl])).expect("an export");
    let search = exported.manifest.stages.iter().find(|stage| stage.stage == "search").expect("a search");
    let steps = search.params.iter().find(|param| param.name == "steps").expect("its steps");
    assert_eq!(steps.value, 77.0);
    let settings = &exported.manifest.structs["SurfaceSettings"];
    let choices = settings.members.iter().find(|member| member.name == "choices").expect("choices");
    let within = (steps.offset - choices.offset) % choices.array.expect("an array").stride;
    assert_eq!(within, exported.manifest.structs["Choice"].members[1].offset);
    // The shader is the same one.
    let [before, after] = [method("relief"), selection]
        .map(|selection| export(&selection, &options(&[Profile::Wgsl])).expect("an export").files);
    let [before, after] =
        [&before, &after].map(|files| code(std::str::from_utf8(&files[0].bytes).expect("text")));
    assert_eq!(before, after);
}

#[test]
fn bindings_go_where_they_are_placed() {
    let placement = Some(Placement { group: 3, first_binding: 10 });
    let options = Options { placement, ..options(&[Profile::Wgsl, Profile::Spirv13, Profile::Hlsl51]) };
    let exported = export(&method("cone"), &options).expect("an export");
    for (number, bound) in (10..).zip(&exported.manifest.bindings) {
        assert_eq!((bound.group, bound.binding), (3, number), "{}", bound.name);
    }
    let wgsl = std::str::from_utf8(&exported.files[0].bytes).expect("text");
    assert!(wgsl.contains("@group(3) @binding(11) var height_map") && !wgsl.contains("@group(0)"));
}

#[test]
fn every_run_gives_the_same_bytes() {
    for sampling in Sampling::ALL {
        let profiles = [Profile::Wgsl, Profile::Core450, Profile::Hlsl51, Profile::Msl20, Profile::Spirv13];
        let options = Options { sampling, ..options(&profiles) };
        let [first, second] = [(); 2].map(|()| export(&method("frustum"), &options).expect("an export"));
        assert!(first == second);
    }
}

#[test]
fn shells_write_depth_always() {
    let mut selection = method("cone");
    selection.choose("surface", "prism").expect("a surface");
    let exported = export(&selection, &options(&[Profile::Wgsl])).expect("an export");
    assert!(exported.manifest.draw.depth);
    assert_eq!(exported.manifest.draw.vertices_per_triangle, 36);
    assert!(std::str::from_utf8(&exported.files[0].bytes).expect("text").contains("@builtin(frag_depth)"));
    let flat = export(&method("cone"), &options(&[Profile::Wgsl])).expect("an export");
    assert!(!flat.manifest.draw.depth);
    assert!(!std::str::from_utf8(&flat.files[0].bytes).expect("text").contains("@builtin(frag_depth)"));
}

#[test]
fn slices_are_drawn_from_both_sides() {
    for name in ["slices-surface", "slices-orthogonal", "slices-screen", "visual-hull-slices"] {
        let exported = export(&method(name), &options(&[Profile::Wgsl])).expect("an export");
        let draw = &exported.manifest.draw;
        assert_eq!((draw.vertices_per_triangle, draw.instances, draw.cull), (3, "1", "none"), "{name}");
    }
}

#[test]
fn what_no_shader_can_is_refused() {
    let wgsl = options(&[Profile::Wgsl]);
    let displaced = METHODS.iter().filter(|of| ["vertex", "remesh", "tessellate"].contains(&of.geometry));
    for displaced in displaced {
        let error = export(&method(displaced.name), &wgsl).expect_err("no shader makes triangles");
        assert_eq!(error, ExportError::Displaced { geometry: displaced.geometry });
    }
    let mut counted = method("depth-object-slices");
    counted.set("geometry.pass", 1.0).expect("a setting");
    let error = export(&counted, &wgsl).expect_err("passes are no shader");
    assert_eq!(error, ExportError::Displaced { geometry: "object-slices" });
    let mut scene = method("exact");
    scene.choose("shadow", "scene").expect("a shadow");
    assert!(matches!(export(&scene, &wgsl), Err(ExportError::OnlyCpu { entry: "scene", .. })));
    let [searches, refinements] = [SEARCH, REFINE].map(|stage| STAGES[stage].entries);
    let mut pairs = searches.iter().flat_map(|search| refinements.iter().map(move |refine| (search, refine)));
    let senseless = pairs.find_map(|(search, refine)| {
        Selection::pair(search.name, refine.name).ok().filter(|pair| pair.check_pair().is_err())
    });
    let pair = senseless.expect("a pair that makes no sense");
    assert!(matches!(export(&pair, &wgsl), Err(ExportError::Selection(SelectionError::Pair { .. }))));
    let cone = method("cone");
    assert_eq!(export(&cone, &options(&[])), Err(ExportError::NoTarget));
    for twice in [[Profile::Wgsl; 2], [Profile::Core450, Profile::Es310]] {
        assert!(matches!(export(&cone, &options(&twice)), Err(ExportError::SameFile(_))));
    }
    for name in ["", "a/b", ".hidden", "..", "a\\b", "a\nb"] {
        let options = Options { name: Some(name.to_owned()), ..wgsl.clone() };
        assert_eq!(export(&cone, &options), Err(ExportError::Name(name.to_owned())));
    }
    for (profile, group, first_binding) in [
        (Profile::Wgsl, 4, 0),
        (Profile::Msl20, 0, 30),
        (Profile::Core450, 0, 250),
        (Profile::Core450, 0, u32::MAX),
        (Profile::Spirv13, 0, u32::MAX),
        (Profile::Hlsl51, u32::MAX, u32::MAX),
    ] {
        let placement = Some(Placement { group, first_binding });
        let error =
            export(&cone, &Options { placement, ..options(&[profile]) }).expect_err("beyond the last");
        let ExportError::Placement { target, .. } = error else { panic!("{error}") };
        assert_eq!(target, profile.target());
    }
    assert!(export(&cone, &options(&Target::ALL.map(|target| target.profiles()[0]))).is_ok());
}
