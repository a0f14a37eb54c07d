//! Difference between a real mesh and its object. The mesh is not part of the project. Without a
//! folder of data in `RELIEF_DATA` the test prints a note and tests nothing.

use relief_core::mesh::Builtin;
use relief_core::object::JumpCells;
use relief_core::{Cancelled, Watch};
use relief_io::{MeshOptions, read_mesh};
use relief_object::even_directions;
use relief_object::{Arrangement, CaptureError, CaptureSettings, Capturer, Cover, Measured, Verification};

fn measured(capturer: &Capturer, cover: Cover, cells: JumpCells) -> Measured {
    let captured = capturer.capture(cover, &Watch::none()).expect("images");
    let verification = Verification { cells, ..Verification::default() };
    capturer.verify(&captured, &verification, &Watch::none()).expect("pictures").expect("some")
}

#[test]
fn six_images_show_spot() {
    let Some(data) = std::env::var_os("RELIEF_DATA") else {
        println!("left out: RELIEF_DATA names no folder of data");
        return;
    };
    let path = std::path::Path::new(&data).join("spot/spot_triangulated.obj");
    let mesh = read_mesh(&path, &MeshOptions::default()).expect("a mesh").mesh;
    let capturer = Capturer::new(&mesh, None, CaptureSettings::default()).expect("views");
    let highest = measured(&capturer, Cover::Centre, JumpCells::Highest);
    println!("{highest:?}");
    assert!(highest.iou >= 0.99, "{highest:?}");
    assert!(highest.depth_error_percent.is_some_and(|percent| percent <= 0.1), "{highest:?}");
    // Bilinear cells cut off parts that are visible from their side.
    let bilinear = measured(&capturer, Cover::Centre, JumpCells::Bilinear);
    assert!(bilinear.iou < highest.iou, "{bilinear:?}");
    // Silhouettes are too wide if texels count that are less than half covered.
    let pixel = measured(&capturer, Cover::Pixel, JumpCells::Highest);
    assert!(pixel.iou < highest.iou && highest.is_nearer_than(&pixel), "{pixel:?}");
}

#[test]
fn what_images_show_of_convex_shapes_is_all_of_them() {
    for (builtin, least, most_percent) in [(Builtin::Cube, 0.995, 0.01), (Builtin::Sphere, 0.985, 0.3)] {
        let mesh = builtin.build([1.0; 2]).expect("a mesh");
        for fov_degrees in [None, Some(30.0)] {
            let settings = CaptureSettings { fov_degrees, size: 129, ..CaptureSettings::default() };
            let capturer = Capturer::new(&mesh, None, settings).expect("views");
            let measured = measured(&capturer, Cover::Centre, JumpCells::Highest);
            assert!(measured.iou > least, "{builtin} {fov_degrees:?}: {measured:?}");
            assert!(
                measured.depth_error_percent.is_some_and(|percent| percent < most_percent),
                "{measured:?}"
            );
            assert!(measured.worst_iou <= measured.iou);
        }
    }
}

#[test]
fn what_a_few_pictures_state_many_others_bear_out() {
    let mesh = Builtin::Torus.build([1.0; 2]).expect("a mesh");
    let settings = CaptureSettings { size: 209, ..Default::default() };
    let capturer = Capturer::new(&mesh, None, settings).expect("views");
    let captured = capturer.capture(Cover::Centre, &Watch::none()).expect("images");
    let [stated, found] = [(32, 128), (1000, 64)].map(|(views, size)| {
        let verification = Verification { views, size, ..Verification::default() };
        capturer.verify(&captured, &verification, &Watch::none()).expect("pictures").expect("some")
    });
    let silhouettes = (1.0 - stated.iou) / (1.0 - found.iou);
    let depths = stated.depth_error_percent.zip(found.depth_error_percent).map(|(a, b)| a / b);
    println!("of silhouettes {silhouettes:.3}, of depths {depths:.3?}");
    assert!((0.8..1.25).contains(&silhouettes), "{silhouettes}: {stated:?} {found:?}");
    assert!(depths.is_some_and(|ratio| (0.8..1.25).contains(&ratio)), "{depths:?}: {stated:?} {found:?}");
    assert_eq!(even_directions(40)[..32], even_directions(32), "some of the same");
}

#[test]
fn comparisons_repeat_and_end_when_they_are_told_to() {
    let mesh = Builtin::Torus.build([1.0; 2]).expect("a mesh");
    let settings =
        CaptureSettings { arrangement: Arrangement::Octahedral(3), size: 48, ..Default::default() };
    let capturer = Capturer::new(&mesh, None, settings).expect("views");
    let captured = capturer.capture(Cover::Pixel, &Watch::none()).expect("images");
    let verify = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        let verification = Verification { views: 5, ..Verification::default() };
        pool.install(|| capturer.verify(&captured, &verification, &Watch::none()).expect("pictures"))
    };
    assert_eq!(verify(1), verify(3));
    let none = Verification { views: 0, ..Verification::default() };
    assert_eq!(capturer.verify(&captured, &none, &Watch::none()), Ok(None));
    let many = Verification { views: 5000, ..Verification::default() };
    let error = capturer.verify(&captured, &many, &Watch::none());
    assert!(matches!(error, Err(CaptureError::BadPictures { views: 5000, .. })));
    let cancel = std::sync::atomic::AtomicBool::new(true);
    let watch = Watch::cancelled_by(&cancel);
    assert_eq!(capturer.capture(Cover::Centre, &watch), Err(CaptureError::Cancelled(Cancelled)));
    assert_eq!(
        capturer.verify(&captured, &Verification::default(), &watch),
        Err(CaptureError::Cancelled(Cancelled))
    );
}
