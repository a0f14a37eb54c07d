//! Captures a torus in six images with depth, finds out how near they are to it, writes them into a folder
//! and follows a ray to what is read from there.

use std::error::Error;

use relief::capture::{CaptureSettings, Capturer, Cover, OBJECT_FILE, ObjectOptions, ObjectWriter};
use relief::capture::{Verification, read_object};
use relief::raycast::Ray;
use relief::{Watch, mesh};

fn main() -> Result<(), Box<dyn Error>> {
    let torus = mesh::torus(128, 64)?;
    let settings = CaptureSettings { size: 128, ..CaptureSettings::default() };
    let capturer = Capturer::new(&torus, None, settings)?;
    let captured = capturer.capture(Cover::Centre, &Watch::none())?;

    let verification = Verification { views: 8, ..Verification::default() };
    let measured = capturer.verify(&captured, &verification, &Watch::none())?;
    println!("{measured:?}");
    assert!(measured.is_some_and(|measured| measured.iou > 0.98));

    let folder = std::env::temp_dir().join("relief-captured-torus");
    ObjectWriter::open(&folder, captured.files(), false, &mut |_| true)?
        .write(&captured, measured.as_ref())?;
    let read = read_object(&folder.join(OBJECT_FILE), &ObjectOptions::default())?;
    assert_eq!(read.measured, measured);

    // From above onto the tube.
    let ray = Ray { origin: [0.35, 2.0, 0.0].into(), direction: [0.0, -1.0, 0.0].into() };
    let hit = read.object.first_hit(&ray).ok_or("the torus is there")?;
    assert!((hit.t - 1.85).abs() < 1e-3);
    Ok(())
}
