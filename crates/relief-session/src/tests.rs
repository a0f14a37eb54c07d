//! Tests of sessions.

use glam::DVec3;
use relief_core::rng::Rng;
use relief_scene::{Form, Key, SceneSpec, keys, viewer_keys};
use relief_shaders::{METHODS, STAGES};

use crate::{Action, Control, Drag, Extent, Kind, Panel, Refused, Seen, Session, Taken};

const START: &str = "height = \"wall.png\"\neye = [0, 1, 3]\ntarget = [0, 0, 0]\nlight = [1, 2, 0]\n";

fn session(text: &str) -> Session {
    Session::new(text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

/// The keys that have a control each.
fn controlled() -> impl Iterator<Item = Key> {
    let has_own = |key: &Key| !matches!(key.form, Form::Settings | Form::Viewer);
    keys().into_iter().filter(has_own).chain(viewer_keys())
}

fn controls(panel: &Panel) -> impl Iterator<Item = &Control> {
    panel.scene.iter().chain(panel.surfaces.iter().flatten())
}

/// A value for a control, proper or not.
fn value(rng: &mut Rng, control: &Control) -> String {
    let number = |rng: &mut Rng| {
        let (least, greatest) = (control.min.unwrap_or(-10.0), control.max.unwrap_or(10.0));
        let part = rng.unit();
        match rng.below(8) {
            0 => 10.0 * (greatest - least) + greatest,
            1 => least,
            2 => greatest,
            _ => least + part * part * part * (greatest - least).min(100.0),
        }
    };
    match (rng.below(30), control.kind) {
        (0, _) => "nan".to_owned(),
        (1, _) => "\"".to_owned(),
        (2, _) => "1\nfov = 3".to_owned(),
        (3, _) => "[1, 2, 3, 4]".to_owned(),
        (_, Kind::Name | Kind::NameOrFile) => {
            let place = rng.below(control.choices.len() as u32 + 1) as usize;
            format!("{:?}", control.choices.get(place).map_or("nothing", |choice| choice.name.as_str()))
        }
        (_, Kind::Flag) => (rng.below(2) == 0).to_string(),
        (_, Kind::Number) => format!("{:?}", number(rng)),
        (_, Kind::Whole) => format!("{}", number(rng).round()),
        (_, Kind::Numbers(count)) => format!("{:?}", (0..count).map(|_| number(rng)).collect::<Vec<_>>()),
        (_, Kind::Text) => "\"file.png\"".to_owned(),
        (_, Kind::Other) => "[0.5, 0.25, 1.0]".to_owned(),
    }
}

fn action(rng: &mut Rng, controls: &[Control]) -> Action {
    let control = &controls[rng.below(controls.len() as u32) as usize];
    let mut pair = || [rng.between(-40.0, 40.0), rng.between(-40.0, 40.0)];
    let (degrees, by) = (pair(), pair());
    match rng.below(40) {
        0 => Action::AddSurface,
        1 => Action::RemoveSurface { number: rng.below(4) as usize },
        2 | 3 => Action::Orbit { degrees },
        4 => Action::Pan { by: by.map(|x| 0.01 * x) },
        5 => Action::Zoom { factor: rng.between(-0.2, 1.8) },
        6 => [Action::Fit, Action::Frame][rng.below(2) as usize].clone(),
        7 => Action::TurnLight { degrees },
        8..=10 => Action::Undo,
        11 | 12 => Action::Redo,
        13 => Action::Reset,
        14..=18 => Action::lose(control.key.clone()),
        19 => Action::lose(format!("surfaces[{}].scale", rng.below(4))),
        20 => Action::set(format!("surfaces[{}].scale", rng.below(4)), "0.25"),
        21 => Action::set("surfaces", "1"),
        22 => Action::set("scal", "1"),
        23 => Action::LookAt { point: [by[0], by[1], degrees[0]].map(|x| 0.01 * x) },
        24 => Action::KeepSecond,
        _ => Action::set(control.key.clone(), value(rng, control)),
    }
}

#[test]
fn any_actions_leave_a_document_that_reads_as_it_is() {
    let mut session = session(START);
    let first = session.text();
    let mut rng = Rng::new(5);
    let mut list: Vec<Control> = controls(&session.panel()).cloned().collect();
    let (mut changes, mut refusals, mut most) = (0, 0, 1);
    for number in 0..10_000 {
        let before = session.text();
        let drag = (rng.below(3) == 0).then_some(Drag(u64::from(rng.below(3))));
        let action = action(&mut rng, &list);
        match session.apply_in(drag, &action) {
            Ok(changed) => {
                assert_eq!(changed.keys.is_empty(), session.text() == before, "{action:?}");
                changes += usize::from(!changed.keys.is_empty());
            }
            Err(refused) => {
                assert!(!refused.to_string().is_empty());
                assert_eq!(session.text(), before, "{action:?}: {refused}");
                refusals += 1;
            }
        }
        most = most.max(session.spec().surfaces.len());
        let again = Session::new(&session.text()).unwrap_or_else(|error| panic!("{action:?}: {error}"));
        assert_eq!(again.spec(), session.spec(), "{action:?}");
        // The controls change with methods and surfaces; they are made anew now and then.
        if number % 200 == 0 {
            list = controls(&session.panel()).cloned().collect();
        }
        if session.spec().surfaces.len() > 4 {
            session.apply(&Action::Reset).expect("the start");
        }
    }
    println!("{changes} changes, {refusals} refusals, {most} surfaces");
    assert!(changes > 2_000 && refusals > 500 && most > 2);
    while session.can_undo()[0] {
        session.apply(&Action::Undo).expect("a change");
    }
    assert_eq!(session.text(), first);
    assert_eq!(session.apply(&Action::Undo), Err(Refused::Nothing("undo")));
}

#[test]
fn every_key_and_setting_has_a_control_that_changes_the_document() {
    for method in METHODS {
        let Ok(session) = Session::new(&format!("height = \"wall.png\"\nmethod = \"{}\"\n", method.name))
        else {
            continue;
        };
        let panel = session.panel();
        let has = |name: &str| controls(&panel).any(|control| control.key == name);
        for key in controlled() {
            assert!(has(key.name), "{}", key.name);
        }
        let selection = session.spec().selections().expect("a selection")[0];
        for (place, stage) in STAGES.iter().enumerate().filter(|(place, _)| selection.uses(*place)) {
            for param in selection.choices[place].entry.params {
                assert!(has(&format!("set.{}.{}", stage.key, param.name)), "{}: {}", method.name, param.name);
            }
        }
    }
    // Each control changes the text, or the reason is one that a user can act on.
    let session_of = || session(START);
    let mut changed = 0;
    for control in controls(&session_of().panel()) {
        let mut session = session_of();
        let [low, high] = [control.min, control.max].map(|end| end.filter(|end| end.abs() < 1e4));
        let number = match (low, high) {
            (Some(low), Some(high)) => 0.75 * low + 0.25 * high,
            (Some(low), None) => low + 1.5,
            (None, Some(high)) => high - 1.5,
            (None, None) => 1.5,
        };
        let value = match control.kind {
            Kind::Number => format!("{number:?}"),
            Kind::Whole => format!("{}", number.round()),
            Kind::Numbers(3) => "[0.5, 0.25, 2.0]".to_owned(),
            Kind::Numbers(_) => "[2, 3]".to_owned(),
            Kind::Flag => (control.default.as_deref() != Some("true")).to_string(),
            Kind::Name | Kind::NameOrFile => {
                let chosen = control.choices.iter().rfind(|choice| choice.refused.is_none());
                // What belongs to other inputs is not to be had at all.
                let Some(chosen) = chosen else { continue };
                format!("{:?}", chosen.name)
            }
            Kind::Text => "\"other.png\"".to_owned(),
            Kind::Other => "[0.5, 0.25, 2.0]".to_owned(),
        };
        assert!(!control.label.is_empty() && !control.about.is_empty(), "{}", control.key);
        match session.apply(&Action::set(control.key.clone(), value.clone())) {
            Ok(keys) if !keys.keys.is_empty() => {
                assert!(session.value(&control.key).is_some(), "{} = {value}", control.key);
                changed += 1;
            }
            Ok(_) => {
                assert_eq!(session.value(&control.key).as_deref(), Some(value.as_str()), "{}", control.key);
            }
            Err(refused) => println!("{} = {value}: {refused}", control.key),
        }
    }
    println!("{changed} controls change the document");
    assert!(changed > 60);
}

#[test]
fn a_name_that_does_not_fit_says_why() {
    let panel = session("height = \"wall.png\"\nsurface = \"prism\"\n").panel();
    let refine = controls(&panel).find(|control| control.key == "refine").expect("a control");
    let refused = refine.choices.iter().filter_map(|choice| choice.refused.as_deref());
    let refused: Vec<&str> = refused.collect();
    assert!(!refused.is_empty() && refused.iter().all(|reason| reason.contains('\'')), "{refused:?}");
    assert!(refine.choices.iter().any(|choice| choice.refused.is_none()));
    let method = controls(&panel).find(|control| control.key == "method").expect("a control");
    assert!(method.choices.iter().all(|choice| !choice.about.is_empty()));
}

#[test]
fn a_drag_is_undone_at_once() {
    let mut session = session(START);
    let first = session.text();
    for _ in 0..20 {
        session.apply_in(Some(Drag(1)), &Action::Orbit { degrees: [3.0, 1.0] }).expect("a turn");
    }
    session.apply_in(Some(Drag(2)), &Action::Zoom { factor: 1.5 }).expect("nearer");
    let eye = session.spec().eye;
    session.apply(&Action::Undo).expect("a change");
    assert_ne!(session.spec().eye, eye);
    session.apply(&Action::Undo).expect("a change");
    assert_eq!(session.text(), first);
    session.apply(&Action::Redo).expect("a change");
    session.apply(&Action::Redo).expect("a change");
    assert_eq!((session.spec().eye, session.can_undo()), (eye, [true, false]));
    // Another change ends what can be made again.
    session.apply(&Action::Undo).expect("a change");
    session.apply(&Action::set("samples", "2")).expect("a change");
    assert_eq!(session.apply(&Action::Redo), Err(Refused::Nothing("redo")));
}

#[test]
fn the_camera_turns_around_its_target() {
    let mut session = session(START);
    session.apply(&Action::Orbit { degrees: [90.0, 0.0] }).expect("a turn");
    let eye = DVec3::from(session.spec().eye.expect("an eye"));
    assert!(eye.distance(DVec3::new(3.0, 1.0, 0.0)) < 1e-9, "{eye}");
    // Not over the pole.
    session.apply(&Action::Orbit { degrees: [0.0, 500.0] }).expect("a turn");
    let eye = DVec3::from(session.spec().eye.expect("an eye"));
    assert!((eye.length() - 10_f64.sqrt()).abs() < 1e-9 && eye.x > 0.0 && eye.y > 3.1, "{eye}");
    session.apply(&Action::Zoom { factor: 2.0 }).expect("nearer");
    let near = DVec3::from(session.spec().eye.expect("an eye"));
    assert!(near.distance(eye / 2.0) < 1e-9);
    session.apply(&Action::TurnLight { degrees: [0.0, 10.0] }).expect("a turn");
    let light = DVec3::from(session.spec().light.expect("a light")).normalize();
    assert!((light.y.asin().to_degrees() - (2_f64.atan2(1.0).to_degrees() + 10.0)).abs() < 1e-9);
    for (action, refused) in [
        (Action::Zoom { factor: 0.0 }, "above 0"),
        (Action::Orbit { degrees: [f64::NAN, 0.0] }, "finite"),
        (Action::Pan { by: [f64::INFINITY, 0.0] }, "finite"),
    ] {
        let said = session.apply(&action).expect_err("a refusal").to_string();
        assert!(said.contains(refused), "{said}");
    }
    // Without a picture nothing is known of a fitted camera.
    let mut fitted = self::session("height = \"wall.png\"\nview = \"top\"\n");
    assert_eq!(fitted.apply(&Action::Orbit { degrees: [1.0, 0.0] }), Err(Refused::NotSeen));
    assert_eq!(fitted.apply(&Action::Frame), Err(Refused::NotSeen));
    fitted.shown(Seen { light: Some(DVec3::X), ..Seen::looking(DVec3::Y * 2.0, DVec3::ZERO) });
    let changed = fitted.apply(&Action::Orbit { degrees: [0.0, -30.0] }).expect("a turn");
    assert_eq!(changed.keys, ["eye", "target", "view"]);
    // A sphere of radius 0.5 around (1, 0, 0) is seen whole, and fills the picture.
    let extent = Some(Extent::sphere(DVec3::X, 0.5));
    fitted.shown(Seen { extent, ..Seen::looking(DVec3::Y * 2.0, DVec3::ZERO) });
    fitted.apply(&Action::Frame).expect("a change");
    let [eye, target] = [fitted.spec().eye, fitted.spec().target].map(|at| DVec3::from(at.expect("a place")));
    let angle = (0.5 / eye.distance(target)).asin().to_degrees();
    assert!(target.distance(DVec3::X) < 1e-9 && angle < 20.0 && angle > 18.0, "{eye} {angle}");
    fitted.apply(&Action::Fit).expect("a change");
    assert_eq!(fitted.spec().eye, None);
}

#[test]
fn keys_get_values_and_lose_them() {
    let mut session = session("height = \"wall.png\"\nmethod = \"relief\"\n");
    let set = |session: &mut Session, key: &str, value: &str| session.apply(&Action::set(key, value));
    assert_eq!(set(&mut session, "set.search.steps", "64").expect("a change").keys, ["set.search.steps"]);
    assert_eq!(session.value("set.search.steps").as_deref(), Some("64.0"));
    assert_eq!(set(&mut session, "scale", "\"5cm\"").expect("a change").keys, ["scale"]);
    assert_eq!(session.value("scale").as_deref(), Some("0.05"));
    assert!(set(&mut session, "scale", "0.05").expect("the same").keys.is_empty());
    assert_eq!(
        session.apply(&Action::lose("set.search.steps")).expect("a change").keys,
        ["set.search.steps"]
    );
    assert!(session.apply(&Action::lose("bias")).expect("nothing").keys.is_empty());
    session.apply(&Action::AddSurface).expect("a surface");
    assert_eq!(set(&mut session, "surfaces[1].scale", "0.1").expect("a change").keys, ["surfaces[1].scale"]);
    // A common value does not replace a surface's own.
    assert_eq!(set(&mut session, "scale", "0.02").expect("a change").keys, ["scale"]);
    session.apply(&Action::RemoveSurface { number: 0 }).expect("a change");
    assert_eq!((session.value("scale").as_deref(), session.spec().surfaces.len()), (Some("0.1"), 0));
    for (key, value, refused) in [
        ("scal", "1", "scale"),
        ("scale", "1\nfov = 3", "one value"),
        ("scale", "", "one value"),
        ("scale", "a, b", "one value"),
        ("search.steps", "4", "set.search.steps"),
        ("samples", "2.5", "samples"),
        ("method", "cones", "cone"),
        ("scale", "-1", "from 0"),
        ("surfaces[3].scale", "1", "no surface 3"),
        ("surfaces[x].scale", "1", "no key"),
        ("surfaces", "1", "no key"),
        ("set.search.step", "1", "steps"),
        ("fov", "400", "180"),
        ("method", "\"cones\"", "cone"),
    ] {
        let said = set(&mut session, key, value).expect_err("a refusal").to_string();
        assert!(said.contains(refused), "{key} = {value}: {said}");
    }
    // A name needs no quotation marks, and the only surface may have its number.
    assert_eq!(set(&mut session, "method", "cone").expect("a change").keys, ["method"]);
    assert_eq!(set(&mut session, "surfaces[0].bias", "1cm").expect("a change").keys, ["bias"]);
    assert_eq!(session.value("bias").as_deref(), Some("0.01"));
    assert!(session.apply(&Action::lose("scal")).expect_err("no key").to_string().contains("scale"));
}

#[test]
fn actions_are_read_from_json() {
    let text = "[{\"do\": \"set\", \"key\": \"scale\", \"value\": \"0.1\"}, {\"do\": \"orbit\", \"degrees\": [10, 5]}, \
                {\"do\": \"undo\"}, {\"do\": \"add-surface\"}]";
    let actions: Vec<Action> = serde_json::from_str(text).expect("actions");
    assert_eq!(actions[0], Action::set("scale", "0.1"));
    assert_eq!(actions[1..3], [Action::Orbit { degrees: [10.0, 5.0] }, Action::Undo]);
    assert!(serde_json::from_str::<Action>("{\"do\": \"jump\"}").is_err());
    for (value, written) in
        [("4", "4"), ("0.5", "0.5"), ("true", "true"), ("[2, 1]", "[2, 1]"), ("\"5cm\"", "5cm")]
    {
        let text = format!("{{\"do\": \"set\", \"key\": \"scale\", \"value\": {value}}}");
        assert_eq!(serde_json::from_str::<Action>(&text).expect("an action"), Action::set("scale", written));
    }
    let each = Action::NAMES.map(|name| serde_json::from_str::<Action>(&format!("{{\"do\": \"{name}\"}}")));
    let is_unknown = |read: &Result<Action, serde_json::Error>| {
        read.as_ref().is_err_and(|error| error.to_string().contains("unknown variant"))
    };
    assert!(!each.iter().any(is_unknown));
    assert!(serde_json::from_str::<Action>("{\"do\": \"lose\", \"key\": \"a\", \"to\": 1}").is_err());
    let panel = serde_json::to_value(session(START).panel()).expect("JSON");
    assert_eq!(
        panel["scene"].as_array().map(Vec::len),
        Some(controlled().filter(|key| !key.of_surface).count())
    );
}

#[test]
fn files_that_come_in_survive_a_reset() {
    let mut session = Session::new("height = \"a.png\"\n").expect("a scene");
    session.apply(&Action::set("scale", "0.2")).expect("a value");
    let taken = session.with_file("color", "\"b.png\"").expect("a file");
    assert_eq!(session.take(taken).keys, ["color"]);
    let taken = session.with_files(&|spec| {
        let mut spec = spec.clone();
        spec.surface.height = Some("c.png".into());
        spec
    });
    assert_eq!(session.take(taken.expect("a file")).keys, ["height"]);
    assert_eq!(session.apply(&Action::Reset).expect("a change").keys, ["scale"]);
    assert_eq!(session.value("height").as_deref(), Some("\"c.png\""));
    for key in ["scale", "height", "color", "scale"] {
        assert_eq!(session.apply(&Action::Undo).expect("a change").keys, [key]);
    }
    assert!(session.with_file("scale", "-1").is_err() && session.with_file("none", "1").is_err());
}

#[test]
fn a_reset_goes_back_to_the_files_that_an_undo_left() {
    let mut session = Session::new("height = \"a.png\"\n").expect("a scene");
    let first = session.text();
    let drop = |session: &mut Session, name: &str| {
        let taken = session.with_file("height", &format!("{name:?}")).expect("a file");
        session.take(taken)
    };
    let height = |session: &Session| session.value("height").expect("a file");
    drop(&mut session, "wrong.png");
    session.apply(&Action::Undo).expect("a drop");
    session.apply(&Action::set("scale", "0.2")).expect("a value");
    session.apply(&Action::Reset).expect("a change");
    assert_eq!(session.text(), first);
    // The undo of a reset does not bring back what was undone before.
    session.apply(&Action::Undo).expect("a reset");
    assert_eq!((height(&session).as_str(), session.value("scale").as_deref()), ("\"a.png\"", Some("0.2")));
    // A drop that is made again is kept again.
    drop(&mut session, "good.png");
    session.apply(&Action::Undo).expect("a drop");
    session.apply(&Action::Redo).expect("a drop");
    assert_eq!(session.apply(&Action::Reset).expect("a change").keys, ["scale"]);
    assert_eq!(height(&session), "\"good.png\"");
    while session.can_undo()[0] {
        session.apply(&Action::Undo).expect("a change");
    }
    assert_eq!(session.text(), first);
    assert!(session.apply(&Action::Reset).expect("nothing").keys.is_empty());
}

#[test]
fn what_a_guard_speaks_against_changes_nothing() {
    let mut session = Session::new("height = \"a.png\"\n").expect("a scene");
    session.guard(|spec| match spec.files().all(|file| file.starts_with("a.png")) {
        true => Ok(()),
        false => Err("another file".to_owned()),
    });
    let before = session.text();
    assert_eq!(session.apply(&Action::set("color", "b.png")), Err(Refused::Value("another file".to_owned())));
    assert!(session.with_file("color", "b.png").is_err());
    assert!(session.text() == before && session.can_undo() == [false; 2]);
    session.apply(&Action::set("color", "a.png")).expect("a file that is given");
}

#[test]
fn search_and_refinement_come_and_go_as_a_pair() {
    let mut session = Session::new("height = \"a.png\"\n").expect("a scene");
    let before = session.text();
    for key in ["search", "refine"] {
        session.apply(&Action::set("search", "linear")).expect("a search");
        assert_eq!(session.apply(&Action::lose(key)).expect("a loss").keys, ["refine", "search"]);
        assert!(session.text() == before);
    }
}

#[test]
fn what_the_second_view_shows_is_kept_and_the_view_closed() {
    let mut session = session("method = \"relief\"\nset.search.steps = 3\nviewer.divider = 0.25\n");
    assert!(session.apply(&Action::KeepSecond).is_err_and(|refused| refused.to_string().contains("second")));
    for (key, value) in [("viewer.second", "cone"), ("viewer.second-show", "steps")] {
        session.apply(&Action::set(key, value)).expect("a value");
    }
    let before = session.text();
    session.apply(&Action::KeepSecond).expect("two views");
    assert_eq!(session.value("method").as_deref(), Some("\"cone\""));
    assert_eq!(session.value("viewer.show").as_deref(), Some("\"steps\""));
    for gone in ["viewer.second", "viewer.second-show", "set.search.steps"] {
        assert_eq!(session.value(gone), None, "{gone}");
    }
    assert_eq!(session.value("viewer.divider").as_deref(), Some("0.25"));
    session.apply(&Action::Undo).expect("one step");
    assert_eq!(session.text(), before);
}

#[test]
fn the_name_of_a_scene_comes_and_goes_with_its_files() {
    let mut session = session("").with_name("first.toml");
    let taken = session.with_files(&|spec| spec.clone()).expect("a document");
    let document = SceneSpec { eye: Some([1.0; 3]), ..taken.document.clone() };
    let other = Taken { document, name: Some("second.toml".to_owned()), ..taken };
    session.take(other);
    assert_eq!(session.name(), Some("second.toml"));
    session.apply(&Action::set("samples", "4")).expect("a value");
    assert_eq!(session.name(), Some("second.toml"));
    session.apply(&Action::Undo).expect("undone");
    session.apply(&Action::Undo).expect("undone");
    assert_eq!(session.name(), Some("first.toml"));
    session.apply(&Action::Redo).expect("done again");
    assert_eq!(session.name(), Some("second.toml"));
}
