use relief_core::registry::{Guarantee, RayClass};

use super::*;
use crate::field::Solids;
use crate::geometry::Geometry;
use crate::slice::{SliceDirection, Slices};
use crate::{AMBIENT, METHODS, REFINE, SURFACE};

#[test]
fn every_method_is_a_valid_selection() {
    for method in METHODS {
        let selection = Selection::of(method).expect("listed names");
        assert_eq!(selection.check(), Ok(()), "{}", method.name);
    }
    let name = |method| Selection::of(method).expect("listed names").method_name();
    assert!(METHODS.iter().all(|method| name(method) == method.name));
    let pair = Selection::pair("linear", "patch").expect("listed names");
    assert_eq!(pair.method_name(), "linear+patch");
    assert!(Selection::method("exact").is_ok_and(|selection| selection.is_exact()));
    let exact = Selection::exact();
    assert_eq!((exact.search().name, exact.refine().name), ("cells", "patch"));
}

#[test]
fn a_pair_promises_what_the_weaker_of_the_two_does() {
    let exact = Selection::method("cone").expect("a method");
    let sampled = Selection::pair("linear", "patch").expect("listed names");
    let stepped = Selection::pair("cone", "binary").expect("listed names");
    for rays in RayClass::ALL {
        assert_eq!(exact.guarantee(rays), Guarantee::Exact);
        assert_eq!(sampled.guarantee(rays), Guarantee::Approximate);
        assert_eq!(stepped.guarantee(rays), Guarantee::Approximate);
    }
}

#[test]
fn a_shadow_takes_the_search_of_the_view_where_that_can_and_cells_else() {
    let with_shadow = |method: &str| {
        let mut selection = Selection::method(method).expect("a method");
        selection.choose("shadow", "ray").expect("a shadow");
        selection
    };
    for (method, search) in
        [("cone", "cone"), ("relief", "linear"), ("relaxed", "cells"), ("parallax", "cells")]
    {
        let selection = with_shadow(method);
        assert_eq!(selection.choices[SHADOW_SEARCH].entry.name, search, "{method}");
        assert_eq!(selection.check(), Ok(()), "{method}");
    }
    // The map is needed in both slots, and in none without a shadow.
    let slots =
        |selection: &Selection| selection.map_needs().iter().map(|need| need.slot).collect::<Vec<_>>();
    let mut selection = with_shadow("cone");
    assert_eq!(slots(&selection), [crate::MapSlot::Search, crate::MapSlot::ShadowSearch]);
    assert!(with_shadow("exact").has_exact_shadows() && !selection.has_exact_shadows());
    selection.choose("shadow", "none").expect("a shadow");
    assert_eq!(slots(&selection), [crate::MapSlot::Search]);
    for refused in ["none", "relaxed-cone"] {
        let mut selection = with_shadow("exact");
        selection.choose("shadow-search", refused).expect("a search");
        assert!(selection.check().is_err(), "{refused}");
    }
}

#[test]
fn displaced_triangles_are_shown_by_one_surface_and_searched_by_nothing() {
    let vertex = Selection::method("vertex").expect("a method");
    assert_eq!((vertex.check(), vertex.geometry()), (Ok(()), Some(Geometry::Texels(1))));
    assert_eq!((vertex.paths().has_relief(), vertex.light_views()), (false, Some([2048, 1])));
    let mut remesh = Selection::exact();
    remesh.choose("geometry", "remesh").expect("a geometry");
    remesh.set("geometry.pixels", 2.5).expect("a parameter");
    assert_eq!((remesh.check(), remesh.geometry()), (Ok(()), Some(Geometry::Pixels(2.5))));
    remesh.choose("geometry", "none").expect("a geometry");
    assert_eq!((remesh.geometry(), remesh.paths().has_relief()), (None, true));
    let refused = [
        ("surface", "prism", "geometry"),
        ("search", "linear", "search"),
        ("refine", "slope", "refine"),
        ("detail", "fade", "detail"),
        ("shadow", "ray", "shadow"),
        ("shadow", "horizon", "shadow"),
        ("ambient", "bent-normal", "ambient"),
        ("ambient", "sky", "ambient"),
    ];
    for (stage, name, expected) in refused {
        let mut selection = vertex;
        selection.choose(stage, name).expect("a listed name");
        let found = selection.check();
        let is_that = matches!(found, Err(SelectionError::Surface { key, .. }) if key == expected);
        assert!(is_that, "{stage} {name}: {found:?}");
    }
    for (stage, name) in [("shadow", "none"), ("shadow", "scene"), ("detail", "footprint")] {
        let mut selection = vertex;
        selection.choose(stage, name).expect("a listed name");
        assert_eq!(selection.check(), Ok(()), "{name}");
    }
    let mut unknown = Selection::default();
    let error = unknown.choose("geometry", "vertx").expect_err("no such geometry").to_string();
    assert!(error.contains("did you mean 'vertex'"), "{error}");
}

#[test]
fn slices_have_a_surface_of_their_own_and_settings_that_are_told_by_names() {
    let mut slices = Selection::method("slices-surface").expect("a method");
    assert_eq!((slices.check(), slices.uses(SLICES)), (Ok(()), true));
    let expected = |count, direction, with_eye| {
        Some(Geometry::Slices(Slices { count, direction, with_eye, by_border: false }))
    };
    assert_eq!(slices.geometry(), expected(64, SliceDirection::A, true));
    assert_eq!(slices.choices[SLICES].entry.name, "at-least");
    for (key, name) in [("slices.test", "band"), ("slices.direction", "screen"), ("slices.anchor", "object")]
    {
        let value = Selection::value_of(key, name).expect("a name");
        assert_eq!(Selection::name_of(key, value), Some(name));
        slices.set(key, value).expect("a setting");
    }
    slices.set("slices.count", 9.0).expect("a setting");
    assert_eq!(slices.geometry(), expected(9, SliceDirection::Screen, false));
    assert_eq!(slices.choices[SLICES].entry.name, "band");
    slices.set("slices.refine", 3.0).expect("a setting");
    assert_eq!((slices.refine().name, slices.choices[REFINE].params[0]), ("secant", 3.0));
    slices.set("slices.refine", 0.0).expect("a setting");
    assert_eq!((slices.refine().name, slices.check()), ("none", Ok(())));
    slices.set("geometry.clip", 1.0).expect("a setting");
    assert_eq!(slices.check(), Ok(()));
    assert!(matches!(slices.geometry(), Some(Geometry::Slices(Slices { by_border: true, .. }))));
    slices.set("slices.direction", 0.0).expect("a setting");
    assert!(matches!(slices.check(), Err(SelectionError::Surface { .. })), "upright slices have no border");
    slices.set("geometry.clip", 0.0).expect("a setting");
    for (stage, name) in [("surface", "plane"), ("search", "linear"), ("detail", "fade"), ("shadow", "entry")]
    {
        let mut selection = slices;
        selection.choose(stage, name).expect("a listed name");
        assert!(matches!(selection.check(), Err(SelectionError::Surface { .. })), "{stage} {name}");
    }
    // Without slices nothing shows them, and their settings change nothing.
    let mut exact = Selection::exact();
    exact.set("slices.refine", 3.0).expect("a setting");
    assert_eq!((exact.refine().name, exact.uses(SLICES)), ("patch", false));
    exact.choose("surface", "slices").expect("a listed name");
    assert!(matches!(exact.check(), Err(SelectionError::Surface { .. })));
    slices.choose("geometry", "none").expect("a geometry");
    assert_eq!((slices.check(), slices.paths().has_relief()), (Ok(()), true));
    let unknown = Selection::value_of("slices.test", "insid").expect_err("no such test").to_string();
    assert!(unknown.contains("did you mean 'inside'"), "{unknown}");
    assert!(matches!(Selection::value_of("search.steps", "many"), Err(SelectionError::NoNumber { .. })));
    for bad in [-1.0, 0.5, 3.0, f64::NAN] {
        assert!(matches!(slices.set("slices.test", bad), Err(SelectionError::Value { .. })), "{bad}");
    }
}

#[test]
fn settings_reach_their_place_and_nothing_else_is_accepted() {
    let mut selection = Selection::method("relief").expect("a method");
    selection.set("search.grazing", 4.0).expect("a parameter");
    assert_eq!(selection.choices[SEARCH].params[..4], [32.0, 4.0, 0.0, 0.0]);
    assert!(matches!(selection.set("steps", 4.0), Err(SelectionError::Key(_))));
    assert!(matches!(selection.set("nothing.steps", 4.0), Err(SelectionError::Key(_))));
    assert!(matches!(selection.set("shade.steps", 4.0), Err(SelectionError::NoParam { .. })));
    assert!(matches!(selection.set("search.stepz", 4.0), Err(SelectionError::NoParam { .. })));
    for bad in [0.0, 1.5, f64::NAN, f64::INFINITY, -3.0] {
        assert!(matches!(selection.set("search.steps", bad), Err(SelectionError::Value { .. })), "{bad}");
    }
    assert_eq!(selection.choices[SEARCH].params[0], 32.0);
    assert!(matches!(selection.choose("nothing", "none"), Err(SelectionError::NoStage(_))));
    assert!(matches!(selection.choose("refine", "bianry"), Err(SelectionError::Unknown(_))));
}

#[test]
fn a_variant_that_is_impossible_for_its_stages_rays_is_refused() {
    let mut selection = Selection::default();
    assert_eq!(selection.check(), Ok(()));
    let refused = Box::leak(Box::new(Entry {
        guarantee: Guarantees { view: Guarantee::Impossible, ..Guarantees::all(Guarantee::Exact) },
        ..*selection.search()
    }));
    selection.choices[SEARCH].entry = refused;
    let expected = SelectionError::Impossible { stage: "search", key: "search", entry: "none", rays: "view" };
    assert_eq!(selection.check(), Err(expected));
}

#[test]
fn objects_are_of_images_and_reliefs_are_not() {
    let solid = |method: &str, value: f64| {
        let mut selection = Selection::method(method).expect("a method");
        selection.set("object.solid", value).expect("a listed value");
        selection.check()
    };
    for (method, none) in [("exact", Ok(())), ("vertex", Ok(())), ("slices-surface", Ok(()))] {
        assert_eq!(solid(method, 0.0), none, "{method}");
        assert!(matches!(solid(method, 1.0), Err(SelectionError::Surface { key: "object", .. })), "{method}");
    }
    for method in ["depth-object", "visual-hull"] {
        assert!(matches!(solid(method, 0.0), Err(SelectionError::Surface { key: "object", .. })), "{method}");
        assert_eq!((solid(method, 1.0), solid(method, 2.0)), (Ok(()), Ok(())));
        let mut selection = Selection::method(method).expect("a method");
        for (stage, name) in [("search", "linear"), ("detail", "footprint"), ("shadow", "ray")] {
            let before = selection;
            selection.choose(stage, name).expect("a listed name");
            assert!(matches!(selection.check(), Err(SelectionError::Surface { .. })), "{method} {name}");
            selection = before;
        }
        selection.choose("geometry", "none").expect("a listed name");
        assert_eq!((selection.check(), selection.object_cells()), (Ok(()), None));
    }
}

#[test]
fn objects_have_a_search_that_serves_what_is_made_of_their_images() {
    let with = |method: &str, settings: &[(&str, f64)]| {
        let mut selection = Selection::method(method).expect("a method");
        for (key, value) in settings {
            selection.set(key, *value).expect("a listed value");
        }
        assert_eq!(selection.check(), Ok(()), "{method} {settings:?}");
        let names = [SURFACE, SEARCH, REFINE].map(|stage| selection.choices[stage].entry.name);
        (names, selection)
    };
    let (pyramid, cells) = (["object", "pyramid", "patch"], ["object", "cells", "patch"]);
    let blend = ["frames", "none", "none"];
    // By place: highest and step cells; depth, hull and blend.
    for (method, settings, names) in [
        ("depth-object", &[][..], pyramid),
        ("depth-object", &[("object.cells", 1.0)], cells),
        ("depth-object", &[("object.solid", 2.0)], cells),
        ("depth-object", &[("object.solid", 3.0)], blend),
        ("visual-hull", &[], cells),
        ("impostor-blend", &[], blend),
        ("impostor-blend", &[("object.solid", 1.0)], ["frames", "pyramid", "patch"]),
        ("impostor-blend", &[("object.solid", 2.0)], ["frames", "cells", "patch"]),
    ] {
        assert_eq!(with(method, settings).0, names, "{method} {settings:?}");
    }
    for (method, stage, name) in [
        ("impostor-blend", "surface", "object"),
        ("impostor-blend", "search", "cells"),
        ("impostor-blend", "refine", "patch"),
        ("depth-object", "search", "none"),
        ("depth-object", "refine", "none"),
        ("visual-hull", "search", "pyramid"),
    ] {
        let (_, mut selection) = with(method, &[]);
        selection.choose(stage, name).expect("a listed name");
        assert!(matches!(selection.check(), Err(SelectionError::Surface { .. })), "{method} {name}");
    }
    // A shadow that was chosen for a blend stays.
    let (_, mut selection) = with("impostor-blend", &[]);
    assert!(!selection.has_shadows());
    selection.choose("shadow", "map").expect("a listed name");
    selection.set("object.steps", 1.0).expect("a setting");
    assert!(selection.has_shadows() && selection.check().is_ok());
    let asks = |method: &str| {
        let selection = with(method, &[]).1;
        (selection.asks_all_images(), selection.needs_grid())
    };
    assert_eq!(asks("depth-object"), (true, false));
    assert_eq!(asks("impostor-blend"), (false, true));
    assert_eq!(asks("exact"), (false, false));
}

#[test]
fn a_sky_goes_with_reliefs_and_a_hemisphere_with_everything() {
    for method in METHODS {
        let selection = Selection::of(method).expect("listed names");
        let goes = |name| selection.goes_with("ambient", name).expect("an ambient light");
        let is_of_relief =
            selection.paths().has_normals_of_relief() && !selection.paths().shown.is_of_images();
        let is_of_relief = is_of_relief && selection.solids() == Solids::Heights;
        let names = ["constant", "hemisphere", "sky", "bent-normal"].map(goes);
        assert_eq!(names, [true, true, is_of_relief, is_of_relief], "{}", method.name);
        // What is shown without being asked for does not change.
        assert_eq!(selection.choices[AMBIENT].entry.name, "constant");
    }
    let mut facets = Selection::pair("none", "none").expect("listed names");
    facets.choose("surface", "facets").expect("a surface");
    facets.choose("shadow", "map").expect("a shadow");
    assert_eq!(facets.goes_with("ambient", "sky"), Ok(false));
    assert_eq!(facets.goes_with("ambient", "hemisphere"), Ok(true));
    for surface in ["plane", "prism", "tetrahedra", "quadric-vertical", "quadric-perpendicular"] {
        let mut relief = Selection::method("relief").expect("a method");
        relief.choose("surface", surface).expect("a surface");
        assert_eq!(relief.goes_with("ambient", "sky"), Ok(true), "{surface}");
    }
    assert!(facets.goes_with("ambient", "skye").is_err() && facets.goes_with("ambience", "sky").is_err());
}

/// Where a surface's rays are none for a method, every surface that the message names
/// serves, and no other does.
#[test]
fn surfaces_that_a_refusal_names_serve() {
    let mut refused = 0;
    for (method, surface) in METHODS
        .iter()
        .flat_map(|method| STAGES[SURFACE].entries.iter().map(move |surface| (method, surface.name)))
    {
        let mut selection = Selection::of(method).expect("listed names");
        selection.choose("surface", surface).expect("a surface");
        let Err(error @ SelectionError::Surface { .. }) = selection.check() else { continue };
        let text = error.to_string();
        let Some((_, named)) = text.split_once("choose the surface ") else { continue };
        refused += 1;
        for other in STAGES[SURFACE].entries {
            let serves = selection.goes_with("surface", other.name).expect("a surface");
            let is_named = named.contains(&format!("'{}'", other.name));
            assert_eq!(is_named, serves, "{}, {surface}: {other:?}: {text}", method.name, other = other.name);
        }
    }
    assert!(refused > 4, "{refused}");
}

#[test]
fn more_directions_than_a_map_has_layers_are_refused() {
    for method in ["view-dependent", "view-dependent-free", "generalised"] {
        let mut selection = Selection::method(method).expect("a method");
        selection.set("search.azimuths", 16.0).expect("a setting");
        selection.set("search.elevations", 16.0).expect("a setting");
        assert_eq!(selection.check(), Ok(()), "{method}");
        selection.set("search.azimuths", 17.0).expect("a setting");
        let refused = selection.check();
        assert!(matches!(refused, Err(SelectionError::Directions { directions: 272.0, .. })), "{refused:?}");
    }
    let mut gathered = Selection::method("relief").expect("a method");
    gathered.choose("ambient", "bounce").expect("an ambient light");
    gathered.set("ambient.azimuths", 256.0).expect("a setting");
    assert_eq!(gathered.check(), Ok(()), "one layer holds what comes from all directions");
}
