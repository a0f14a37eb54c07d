use std::path::Path;

use super::*;
use crate::stages::{
    AMBIENT, DETAIL, FIELD, GEOMETRY, OBJECT, REFINE, SEARCH, SHADE, SHADOW, SHADOW_SEARCH, SLICES, STAGES,
    SURFACE, Stage, stage,
};
use crate::surface::Shown;
use crate::{METHODS, Selection, SelectionError};

/// The stages that can be left out.
const LEFT_OUT: [usize; 7] = [GEOMETRY, OBJECT, FIELD, DETAIL, SEARCH, REFINE, SHADOW];

/// The faults in the roles of the entries in these stages.
fn faults(stages: &[Stage]) -> Vec<String> {
    let mut faults = Vec::new();
    for (place, Stage { key, entries, .. }) in stages.iter().enumerate() {
        for entry in *entries {
            let mut wrong = |what: String| faults.push(format!("{key} {}: {what}", entry.name));
            if !fits(entry, place) {
                wrong(format!("{:?} is no role of this stage", entry.role));
            }
            for name in named_params(entry) {
                if entry.param(name).is_none() {
                    wrong(format!("it has no parameter {name}"));
                }
            }
            for companion in companions(entry) {
                if let Some(what) = fault_of_companion(companion, stages) {
                    wrong(what);
                }
            }
        }
        let mut count = |what: &str, wanted: usize, is_meant: fn(&Entry) -> bool| {
            let found = entries.iter().filter(|entry| is_meant(entry)).count();
            if found != wanted {
                faults.push(format!("{key}: {found} {what}, not {wanted}"));
            }
        };
        count("entries that do nothing", usize::from(is_left_out(place)), Entry::is_idle);
        if [SEARCH, REFINE, SHADOW_SEARCH].contains(&place) {
            count("references", 1, |entry| entry.tracing().is_reference);
        }
        if place == REFINE {
            count("refinements between slices", 1, |entry| entry.tracing().joins_slices);
        }
        if place == AMBIENT {
            count("lights of the surroundings", 1, Entry::sees_surroundings);
        }
        if place == SHADE {
            count("shadings that read materials", 1, Entry::reads_materials);
        }
        if place == SHADOW {
            use ShadowRole::{LightViews, ThroughScene, ToLights};
            count("shadows by rays", 1, |it| matches!(it.shadow(), Some(ToLights { rays: None })));
            count("shadows of discs by rays", 1, |it| {
                matches!(it.shadow(), Some(ToLights { rays: Some(_) }))
            });
            count("shadows of light views", 1, |it| matches!(it.shadow(), Some(LightViews { .. })));
            count("shadows through the scene", 1, |it| matches!(it.shadow(), Some(ThroughScene { .. })));
        }
    }
    faults
}

fn is_left_out(place: usize) -> bool {
    LEFT_OUT.contains(&place) || place == SHADOW_SEARCH
}

/// Whether an entry has a role of the stage at that place.
fn fits(entry: &Entry, place: usize) -> bool {
    match entry.role {
        Role::Plain => place != GEOMETRY && place != OBJECT,
        Role::Idle => is_left_out(place),
        Role::Geometry(_) => place == GEOMETRY,
        Role::Surface(_) => place == SURFACE,
        Role::NearSurface => place == SLICES,
        Role::Object(_) => place == OBJECT,
        Role::Field(_) => place == FIELD,
        Role::Flattened => place == DETAIL,
        Role::Tracing(_) => [SEARCH, REFINE, SHADOW_SEARCH].contains(&place),
        Role::Shadow(_) => place == SHADOW,
        Role::ReadsMaterials => place == SHADE,
        Role::Surroundings => place == AMBIENT,
    }
}

/// The parameters that an entry's role names.
fn named_params(entry: &Entry) -> Vec<&'static str> {
    let of_geometry = entry.geometry().stencil.into_iter();
    let of_shadow = match entry.shadow() {
        Some(ShadowRole::ToLights { rays }) => rays.into_iter().collect(),
        Some(ShadowRole::LightViews { size, cascades }) => vec![size, cascades],
        Some(ShadowRole::ThroughScene { rays }) => vec![rays],
        Some(ShadowRole::Discs | ShadowRole::FromEntry) | None => Vec::new(),
    };
    of_geometry.chain(of_shadow).collect()
}

fn companions(entry: &Entry) -> &'static [Companion] {
    entry.object().map_or(entry.geometry().companions, |object| object.companions)
}

fn fault_of_companion(companion: &Companion, stages: &[Stage]) -> Option<String> {
    let Companion { stage: key, name, settings } = companion;
    let Some(stage) = stages.iter().find(|stage| stage.key == *key) else {
        return Some(format!("there is no stage {key}"));
    };
    let Some((_, other)) = stage.first(|entry| entry.name == *name) else {
        return Some(format!("there is no {key} {name}"));
    };
    settings.iter().find_map(|(name, value)| match other.param(name) {
        None => Some(format!("its companion {} has no parameter {name}", other.name)),
        Some((_, param)) if !(param.min..=param.max).contains(value) => {
            Some(format!("{name} = {value} is out of the range of its companion {}", other.name))
        }
        Some(_) => None,
    })
}

/// The table with another role for a variant.
fn with_role(key: &str, name: &str, role: Role) -> Vec<Stage> {
    let mut stages = STAGES.to_vec();
    let (place, stage) = stage(key).expect("a stage");
    let mut entries = stage.entries.to_vec();
    let entry = entries.iter_mut().find(|entry| entry.name == name).expect("a variant");
    entry.role = role;
    stages[place].entries = Vec::leak(entries);
    stages
}

/// The table with other companions of the geometry `slices`.
fn with_companion(companion: Companion) -> Vec<Stage> {
    let slices = STAGES[GEOMETRY].first(|entry| entry.name == "slices").expect("a geometry").1;
    let companions = vec![companion].leak();
    with_role("geometry", "slices", Role::Geometry(GeometryRole { companions, ..slices.geometry() }))
}

#[test]
fn roles_fit_their_stage_and_name_what_there_is() {
    assert_eq!(faults(&STAGES), Vec::<String>::new());
}

#[test]
fn a_wrong_role_is_found() {
    let ray = |rays| Role::Shadow(ShadowRole::ToLights { rays });
    let wrong = [
        with_companion(Companion::new("surfaces", "slices")),
        with_companion(Companion::new("surface", "slice")),
        with_companion(Companion::new("shadow", "map").with(&[("sizes", 512.0)])),
        with_companion(Companion::new("shadow", "map").with(&[("size", 1.0)])),
        with_role("shadow", "soft", ray(Some("sample"))),
        with_role("shadow", "soft", ray(None)),
        with_role("shadow", "ray", Role::Surroundings),
        with_role("search", "none", Role::Plain),
        with_role("search", "linear", Role::Idle),
        with_role("search", "cells", Role::Plain),
        with_role("refine", "patch", Role::Plain),
        with_role("refine", "secant", Role::Plain),
        with_role("geometry", "vertex", Role::Plain),
        with_role("object", "depth", Role::Plain),
        with_role("ambient", "environment", Role::Plain),
        with_role("shade", "blinn-phong", Role::Idle),
        with_role("shade", "metallic-roughness", Role::Plain),
        with_role("shadow", "ray", Role::ReadsMaterials),
    ];
    for (number, stages) in wrong.iter().enumerate() {
        assert!(!faults(stages).is_empty(), "mutation {number} is not found");
    }
}

#[test]
fn a_geometry_goes_with_its_companions_and_with_surfaces_that_show_the_same() {
    for method in METHODS {
        for geometry in STAGES[GEOMETRY].entries {
            let mut selection = Selection::of(method).expect("listed names");
            selection.choose("geometry", geometry.name).expect("a geometry");
            let shown = geometry.geometry().shown;
            assert_eq!(selection.paths().shown, shown, "{} {}", method.name, geometry.name);
            if !geometry.geometry().companions.is_empty() {
                assert_eq!(selection.check(), Ok(()), "{} {}", method.name, geometry.name);
            }
            for surface in STAGES[SURFACE].entries {
                selection.choose("surface", surface.name).expect("a surface");
                let of_geometry =
                    matches!(selection.check(), Err(SelectionError::Surface { key: "geometry", .. }));
                // Triangles may be displaced already where the base is drawn.
                let other = surface.paths().shown;
                let goes = other == shown || (other == Shown::Triangles && geometry.is_idle());
                assert_eq!(of_geometry, !goes, "{} on {}", surface.name, geometry.name);
            }
        }
    }
}

#[test]
fn what_is_made_of_images_goes_with_its_companions() {
    let images = STAGES[GEOMETRY].entries.iter().filter(|entry| entry.geometry().shown.is_of_images());
    for geometry in images {
        for (number, object) in STAGES[OBJECT].entries.iter().enumerate() {
            let mut selection = Selection::default();
            selection.choose("geometry", geometry.name).expect("a geometry");
            selection.set("object.solid", number as f64).expect("a listed solid");
            // Slices are asked of all images, and blends of a grid.
            let is_refused =
                object.is_idle() || (geometry.geometry().shown.is_sliced() && object.name == "blend");
            assert_eq!(selection.check().is_err(), is_refused, "{} {}", geometry.name, object.name);
        }
    }
}

#[test]
fn surfaces_refuse_what_their_rules_say_and_name_what_they_take() {
    let mut refusals = 0;
    for geometry in STAGES[GEOMETRY].entries {
        for surface in STAGES[SURFACE].entries {
            let mut fitting = Selection::exact();
            fitting.choose("geometry", geometry.name).expect("a geometry");
            fitting.choose("surface", surface.name).expect("a surface");
            if surface.paths().shown != geometry.geometry().shown {
                continue;
            }
            for rule in surface.paths().refused {
                let (_, stage) = stage(rule.stage).expect("a stage");
                for entry in stage.entries {
                    let mut selection = fitting;
                    selection.choose(rule.stage, entry.name).expect("a listed name");
                    let is_refused = (rule.refuses)(entry);
                    let found = selection.check();
                    assert!(!is_refused || found.is_err(), "{}: {} {}", surface.name, stage.key, entry.name);
                    let Err(SelectionError::Surface { key, reason, .. }) = found else { continue };
                    if key != rule.stage || !is_refused {
                        continue;
                    }
                    refusals += 1;
                    let quoted = |entry: &&Entry| reason.contains(&format!("'{}'", entry.name));
                    for named in stage.entries.iter().filter(quoted) {
                        assert!(!(rule.refuses)(named), "{}: {reason}", surface.name);
                    }
                }
            }
        }
    }
    assert!(refusals > 50, "{refusals} refusals");
}

/// The lines on which source asks for a variant by its name, but for tests.
fn asks_by_name(source: &str) -> Vec<usize> {
    let asks = ["entry.name == \"", "entry.name != \"", "match entry.name", "entry_place("];
    let lines = source.lines().take_while(|line| !line.contains("#[cfg(test)]")).enumerate();
    lines.filter(|(_, line)| asks.iter().any(|ask| line.contains(ask))).map(|(at, _)| at + 1).collect()
}

#[test]
fn no_variant_is_asked_for_by_its_name() {
    // Where named methods are, which are lists of names, and what finds them.
    const PRESETS: [&str; 2] = ["methods.rs", "stages.rs"];
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let (mut folders, mut found, mut files) = (vec![crates.join("relief-shaders/src")], Vec::new(), 0);
    folders.extend(["render", "compare", "export", "cli"].map(|it| crates.join(format!("relief-{it}/src"))));
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).expect("a readable folder") {
            let path = entry.expect("a readable folder").path();
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            if path.is_dir() {
                folders.extend((name != "tests").then_some(path));
            } else if name.ends_with(".rs") && name != "tests.rs" && !PRESETS.contains(&&*name) {
                files += 1;
                let lines = asks_by_name(&std::fs::read_to_string(&path).expect("source is text"));
                found.extend(lines.into_iter().map(|line| format!("{}:{line}", path.display())));
            }
        }
    }
    assert!(files > 200, "{files} files");
    assert!(found.is_empty(), "read an entry's role in place of its name:\n{}", found.join("\n"));
}

#[test]
fn a_question_for_a_name_is_seen() {
    let source = "fn a(entry: &Entry) -> bool {\n    entry.name == \"ray\" || choice.entry.name != \"none\"\n\
        }\n\
        fn b() { match entry.name { _ => {} } }\nfn c(name: &str) -> bool { entry.name == name }\n\
        #[cfg(test)]\nmod tests { fn d() -> bool { entry.name == \"map\" } }\n";
    assert_eq!(asks_by_name(source), [2, 4]);
}
