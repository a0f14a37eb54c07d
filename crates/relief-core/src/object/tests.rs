use glam::DVec3;

use super::{AtlasLayout, ImageObject, JumpCells, ObjectError, View};
use crate::{HeightMap, Wrap};

fn cube_of(maps: &[HeightMap]) -> Result<ImageObject, ObjectError> {
    let axes = [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y, DVec3::Z, DVec3::NEG_Z];
    let views = axes
        .iter()
        .zip(maps)
        .map(|(from, map)| {
            let size = [map.width(), map.height()];
            View::orthographic(DVec3::ZERO, 2.0, *from, None, size).expect("a view")
        })
        .collect();
    ImageObject::new(views, maps, JumpCells::Highest, 4.0)
}

#[test]
fn bounds_hold_the_solid_and_little_more() {
    // The middle half of each image is seen at three quarters of the way: a cube of 2 m.
    let map = HeightMap::from_fn(40, 40, Wrap::Clamp, |x, y| {
        let inside = |at: u32| (10..30).contains(&at);
        if inside(x) && inside(y) { 0.75 } else { 0.0 }
    })
    .expect("a map");
    let object = cube_of(&vec![map; 6]).expect("an object");
    let [low, high] = object.bounds().expect("there is something");
    let texel = 4.0 / 40.0;
    assert!(low.cmple(DVec3::splat(-1.0)).all() && high.cmpge(DVec3::splat(1.0)).all());
    assert!(low.cmpge(DVec3::splat(-1.0 - texel)).all() && high.cmple(DVec3::splat(1.0 + texel)).all());
    assert!((object.jump() - 4.0 / 40.0).abs() < 1e-12);
}

#[test]
fn what_an_image_does_not_see_is_not_there() {
    let empty = HeightMap::new(4, 4, vec![0.0; 16], Wrap::Clamp).expect("a map");
    let full = HeightMap::new(4, 4, vec![1.0; 16], Wrap::Clamp).expect("a map");
    let some = cube_of(&[full.clone(), full.clone()]).expect("an object");
    assert!(some.bounds().is_some());
    assert_eq!(cube_of(&[full, empty]).expect("an object").bounds(), None);
}

#[test]
fn maps_that_do_not_fit_are_refused() {
    let map = HeightMap::new(4, 4, vec![0.5; 16], Wrap::Clamp).expect("a map");
    let view = |size| View::orthographic(DVec3::ZERO, 1.0, DVec3::X, None, size).expect("a view");
    let object = |views: Vec<View>, maps: &[HeightMap], jump| {
        ImageObject::new(views, maps, JumpCells::Bilinear, jump).err()
    };
    let maps = [map.clone()];
    assert_eq!(object(vec![], &[], 4.0), Some(ObjectError::BadCount(0)));
    assert_eq!(
        object(vec![view([4, 4]); 2], &maps, 4.0),
        Some(ObjectError::OtherCount { views: 2, maps: 1 })
    );
    assert!(matches!(object(vec![view([4, 5])], &maps, 4.0), Some(ObjectError::OtherSize { number: 0, .. })));
    assert!(matches!(object(vec![view([4, 4])], &maps, f64::NAN), Some(ObjectError::BadJump(_))));
    assert!(object(vec![view([4, 4])], &maps, f64::INFINITY).is_none());
    let many = vec![view([4, 4]); 1025];
    assert_eq!(object(many, &vec![map; 1025], 4.0), Some(ObjectError::BadCount(1025)));
    assert!(AtlasLayout::new(vec![[4, 4]; 1024]).is_ok());
}
