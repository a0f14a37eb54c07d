//! Descriptions laid over one another, and what they replace.

use super::*;
use crate::scene::surface_selection::SceneContext;

#[test]
fn surroundings_are_seen_where_they_are_asked_for() {
    let seen = |toml: &str, over: &str| {
        let [base, over] = [toml, over].map(|toml| read(toml).expect("a proper scene"));
        let spec = base.overridden_by(over);
        spec.check().expect("a possible scene");
        let around = SceneContext { has_environment: spec.environment.is_some(), ..SceneContext::default() };
        let parts = spec.surface.parts(1, &around).expect("a proper surface");
        let map = HeightMap::new(1, 1, vec![0.5], Wrap::Repeat).expect("a map");
        let surface = spec.surface.with_heights(parts, map).expect("a surface");
        (surface.selection().sees_environment(), spec.environment.is_some())
    };
    assert_eq!(seen("", ""), (false, false));
    assert_eq!(seen("environment = 'a.hdr'", ""), (true, true));
    for key in ["transmission = 0.5", "ambient = 'environment'"] {
        assert_eq!(seen(key, ""), (true, false), "{key}");
        // What is laid over a scene takes the place of what excludes it.
        assert_eq!(seen("ambient = 'occlusion'\nset.ambient.azimuths = 8", key), (true, false), "{key}");
    }
    assert_eq!(
        seen("ambient = 'occlusion'\nset.ambient.azimuths = 8", "environment = 'a.hdr'"),
        (true, true)
    );
    assert_eq!(seen("environment = 'a.hdr'\ntransmission = 1", "ambient = 'occlusion'"), (false, false));
    let bright = "ambient = 'environment'\nset.ambient.intensity = 2";
    assert_eq!(seen(bright, "transmission = 0.5\nior = 2"), (true, false));
}

#[test]
fn what_is_said_later_wins() {
    let file = read(FULL).expect("a proper scene");
    assert_eq!(file.clone().overridden_by(SceneSpec::default()), file);
    let mesh = SurfaceSpec { mesh: Some(Builtin::Plane.into()), ..SurfaceSpec::default() };
    let flags = SceneSpec { fov: Some(20.0), ..of(mesh) };
    let both = file.clone().overridden_by(flags);
    // A projection, and what points up in a file, are for the mesh that they were given with.
    let mesh = Some(Builtin::Plane.into());
    let surface = SurfaceSpec { mesh, project: None, mesh_up: None, ..file.surface.clone() };
    assert_eq!(both, SceneSpec { fov: Some(20.0), surface, ..file });
}

#[test]
fn what_belongs_to_something_replaced_goes_with_it() {
    let file = read(FULL).expect("a proper scene");
    let with = |over: SurfaceSpec| {
        let both = file.clone().overridden_by(of(over));
        both.check().expect("still a proper scene");
        both.surface
    };

    let both =
        with(SurfaceSpec { height: Some("new.png".into()), fill: Some(true), ..SurfaceSpec::default() });
    assert_eq!((both.raw, both.channel, both.depth, both.range), (None, None, None, None));
    assert_eq!((both.fill, both.wrap), (Some(true), Some(Wrap::Mirror)));

    let both = with(SurfaceSpec { normal: Some("new.png".into()), ..SurfaceSpec::default() });
    assert_eq!(both.green, None);

    let both = with(SurfaceSpec { scale: Some(0.5), ..SurfaceSpec::default() });
    assert_eq!(both.bias, None);

    let both = with(SurfaceSpec { method: Some("parallax".into()), ..SurfaceSpec::default() });
    let others = [
        ("shade", "metallic-roughness"),
        ("shadow", "soft"),
        ("shadow-search", "frustum"),
        ("ambient", "environment"),
    ];
    assert_eq!(both.stages, stages(others));
    assert!(both.set.is_empty());

    let set = [("refine.steps".to_owned(), 9.0)].into_iter().collect();
    let both = with(SurfaceSpec { stages: stages([("search", "cells")]), set, ..SurfaceSpec::default() });
    let [shade, shadow, shadow_search, ambient] = others;
    let named = stages([("search", "cells"), ("refine", "binary"), shade, shadow, shadow_search, ambient]);
    assert_eq!(both.stages, named);
    assert_eq!(both.set.into_iter().collect::<Vec<_>>(), [("refine.steps".to_owned(), 9.0)]);

    let stages_of_shadow = stages([("shadow", "horizon")]);
    let both = with(SurfaceSpec { stages: stages_of_shadow, ..SurfaceSpec::default() });
    assert_eq!(both.stages.get("shadow").map(String::as_str), Some("horizon"));
    assert_eq!(both.stages.get("shadow-search"), None);

    let light = SceneSpec { light: Some([0.0, 1.0, 0.0]), ..SceneSpec::default() };
    let both = file.clone().overridden_by(light);
    both.check().expect("still a proper scene");
    assert_eq!(both.lights, None);
}
