use glam::DVec3;

use super::{AtlasLayout, EMPTY_HEIGHT, ImageObject, JumpCells, ObjectError, View};
use crate::mesh::Placement;
use crate::raycast::Ray;
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
    // The middle half of each image is at three quarters of the height: a cube of 2 m.
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
    assert!(some.has_solid());
    assert_eq!(cube_of(&[full.clone(), empty]).expect("an object").bounds(), None);
    // A sheet in the middle is shown by images from its front and its back, and by none along it.
    let sheet = HeightMap::new(4, 4, vec![0.5; 16], Wrap::Clamp).expect("a map");
    let empty = HeightMap::new(4, 4, vec![0.0; 16], Wrap::Clamp).expect("a map");
    let card = cube_of(&[empty.clone(), empty.clone(), empty.clone(), empty.clone(), sheet.clone(), sheet]);
    assert!(!card.expect("an object").has_solid());
    assert!(!cube_of(&[empty.clone(), empty]).expect("an object").has_solid());
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

fn block() -> ImageObject {
    // The middle half of each image is at three quarters of the height: a cube of 2 m, whose sides
    // are walls of cells.
    let map = HeightMap::from_fn(40, 40, Wrap::Clamp, |x, y| {
        let inside = |at: u32| (10..30).contains(&at);
        if inside(x) && inside(y) { 0.75 } else { 0.0 }
    })
    .expect("a map");
    cube_of(&vec![map; 6]).expect("an object").with_cells(JumpCells::Nearest, 4.0).expect("a jump")
}

#[test]
fn a_block_is_hit_on_its_faces() {
    let object = block();
    for (number, axis) in [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y].into_iter().enumerate() {
        let aside = DVec3::new(0.31, 0.47, -0.22);
        let origin = axis * 5.0 + (aside - axis * aside.dot(axis));
        let ray = Ray { origin, direction: axis * -2.0 };
        let hit = object.first_hit(&ray).expect("it is on the way");
        assert!((hit.t - 2.0).abs() < 1e-12, "{hit:?}");
        assert!((object.views()[hit.view].point(hit.at) - ray.at(hit.t)).length() < 1e-12);
        assert!(hit.reads > 0 && (hit.view == number || hit.at.z < 0.75), "{hit:?}");
        // 2 m, at 2 m per unit.
        let [[from, to]] = object.intervals(&ray)[..] else { panic!("it is one piece") };
        assert!((from - 2.0).abs() < 1e-11 && (to - 3.0).abs() < 1e-11, "{from} to {to}");
        assert_eq!(object.first_hit(&Ray { direction: axis, ..ray }), None);
        let inside = Ray { origin: aside, direction: axis };
        assert_eq!(object.first_hit(&inside).map(|hit| hit.t), Some(0.0));
    }
    assert!(object.contains(DVec3::splat(0.99)) && !object.contains(DVec3::splat(1.01)));
    assert_eq!(object.height_at(0, 0.5, 0.5), Some(0.75));
    assert_eq!(object.height_at(6, 0.5, 0.5), None);
}

#[test]
fn sheets_that_two_images_see_from_both_sides_are_hit() {
    // The heights add up to exactly 1. Yet the two hits of a ray differ by rounding.
    for height in [0.5_f32, 0.6, 0.7, 0.9] {
        let map = |height| HeightMap::new(8, 8, vec![height; 64], Wrap::Clamp).expect("a map");
        let sheet = cube_of(&[map(height), map(1.0 - height)]).expect("an object");
        let placement = Placement {
            position_m: DVec3::new(0.3, -0.1, 0.7),
            rotation_degrees: DVec3::new(13.0, 77.0, -31.0),
            size: 0.7,
        };
        let turn = placement.turn().expect("a placement");
        let views = sheet.views().iter().map(|view| view.placed(&placement).expect("a placement")).collect();
        let maps = [map(height), map(1.0 - height)];
        let object = ImageObject::new(views, &maps, JumpCells::Bilinear, 4.0).expect("an object");
        for step in 0..100 {
            let aside = f64::from(step) * 0.017;
            for side in [3.0, -3.0] {
                let (origin, to) = (DVec3::new(side, 0.1, 0.2), DVec3::new(0.0, aside - 0.8, aside * 0.3));
                let place = |point: DVec3| turn * point * placement.size + placement.position_m;
                let ray = Ray { origin: place(origin), direction: place(to) - place(origin) };
                assert!(object.first_hit(&ray).is_some(), "{height}: {ray:?}");
            }
        }
    }
}

#[test]
fn rays_that_are_none_miss() {
    let object = block();
    let ray = Ray { origin: DVec3::new(5.0, 0.0, 0.0), direction: DVec3::NEG_X };
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, 1e12] {
        let origin = DVec3::new(bad, 0.0, 0.0);
        assert_eq!(object.first_hit(&Ray { origin, ..ray }), None);
    }
    for bad in [0.0, f64::NAN, f64::INFINITY, 1e-300, 1e300] {
        assert_eq!(object.first_hit(&Ray { direction: DVec3::NEG_X * bad, ..ray }), None);
    }
    for small in [1e-80, 1e80] {
        let hit = object.first_hit(&Ray { direction: DVec3::NEG_X * small, ..ray }).expect("a hit");
        assert!((hit.t * small - 4.0).abs() < 1e-12);
    }
}

#[test]
fn hulls_are_cut_halfway_between_texels() {
    let object = block();
    let ray = Ray { origin: DVec3::new(5.0, 0.31, -0.22), direction: DVec3::NEG_X };
    // The silhouettes' sides are halfway between the last texels that show something and the first
    // that do not.
    let hit = object.hull_first_hit(&ray).expect("it is on the way");
    assert!((hit.t - 4.0).abs() < 1e-12, "{hit:?}");
    let [[from, to]] = object.hull_intervals(&ray)[..] else { panic!("it is one piece") };
    assert!((from - 4.0).abs() < 1e-11 && (to - 6.0).abs() < 1e-11, "{from} to {to}");
    // A single silhouette is bounded by its image's space.
    let map = HeightMap::new(8, 8, vec![1e-3; 64], Wrap::Clamp).expect("a map");
    let one = cube_of(&[map]).expect("an object");
    let [[from, to]] = one.hull_intervals(&ray)[..] else { panic!("it is one piece") };
    let end = 7.0 - 4.0 * EMPTY_HEIGHT;
    assert!((from - 3.0).abs() < 1e-11 && (to - end).abs() < 1e-11, "{from} to {to}");
}
