//! Tests of the camera and the light.

use glam::DVec3;

use crate::{Action, Extent, Refused, Seen, Session};

fn session(text: &str) -> Session {
    Session::new(text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

#[test]
fn a_zoom_stays_near_the_scene_and_a_frame_fills_the_picture() {
    let mut session = session("height = \"wall.png\"\n");
    let seen = Seen { extent: Some(Extent::sphere(DVec3::X, 0.5)), ..Seen::looking(DVec3::Z, DVec3::ZERO) };
    session.shown(seen);
    let away = |session: &Session| {
        let [eye, target] = [session.spec().eye, session.spec().target];
        DVec3::from(eye.expect("an eye")).distance(target.expect("a target").into())
    };
    let zoom = |session: &mut Session, factor: f64| {
        while !session.apply(&Action::Zoom { factor }).expect("a zoom").keys.is_empty() {}
        away(session)
    };
    let near = zoom(&mut session, 1.7);
    assert!(near > 1e-5 && near < 1e-3, "{near}");
    // The first frame is the same from there as from afar.
    session.apply(&Action::Frame).expect("a frame");
    let framed = away(&session);
    let far = zoom(&mut session, 0.6);
    assert!(far > 10.0 && far < 1e3, "{far}");
    session.apply(&Action::Frame).expect("a frame");
    assert!((away(&session) - framed).abs() < 1e-6 * framed, "{framed}");
    // A flat box fills the width or the height of its picture.
    for (eye, aspect) in [(DVec3::Y, 4.0 / 3.0), (DVec3::new(1.0, 1.0, 2.0), 2.0), (DVec3::Z, 0.5)] {
        let half = DVec3::new(1.0, 0.05, 0.5);
        let extent = Extent { middle: DVec3::X, radius: half.length(), half };
        let seen = Seen { extent: Some(extent), aspect, ..Seen::looking(DVec3::X + eye, DVec3::X) };
        let (eye, target, height_m) = seen.framed().expect("a frame");
        let back = (eye - target).normalize();
        let right = DVec3::Y.cross(back).try_normalize().unwrap_or(DVec3::X);
        let tan = 0.5 * height_m / eye.distance(target);
        let corners = (0..8).map(|corner| {
            let sides = [0, 1, 2].map(|axis| f64::from((corner >> axis & 1) * 2 - 1));
            let ray = DVec3::X + half * DVec3::from(sides) - eye;
            let place = DVec3::new(ray.dot(right) / aspect, ray.dot(back.cross(right)), 0.0) / ray.dot(-back);
            place.abs().max_element() / tan
        });
        let most = corners.fold(0.0, f64::max);
        assert!((most - 0.94).abs() < 1e-9, "{most}");
    }
}

#[test]
fn a_scene_without_a_light_says_that_none_can_be_turned() {
    let mut session = session("height = \"wall.png\"\nlook = \"overcast\"\n");
    let turn = Action::TurnLight { degrees: [10.0, 0.0] };
    assert_eq!(session.apply(&turn), Err(Refused::NotSeen));
    session.shown(Seen::looking(DVec3::Z, DVec3::ZERO));
    assert_eq!(session.apply(&turn), Err(Refused::NoLight));
    session.apply(&Action::set("light", "\"az=20,alt=30\"")).expect("a light");
    session.apply(&turn).expect("a turn");
}
