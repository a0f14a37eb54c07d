//! The bits of pictures and baked maps, held to those that were recorded: a change that is to change none of
//! them is seen to change none.
//!
//! What is recorded are hashes of values, not of files. They are kept beside this file and written anew with
//! `RELIEF_RECORD=1 cargo test --release --test recorded`, by a change that means to change them. Maps are
//! keyed by the revision of their kind, which such a change raises.

mod bakes;
mod hash;
mod pictures;
mod record;

use record::Record;

/// Whether the recorded bits hold on this machine. Cosines and the like come from the system's library,
/// which differs elsewhere.
fn is_recorded_here() -> bool {
    let here = cfg!(all(target_os = "linux", target_arch = "x86_64", target_env = "gnu"));
    if !here {
        println!("skipped: the bits are recorded for Linux with glibc on x86-64");
    }
    here
}

#[test]
fn pictures_keep_their_bits() {
    if is_recorded_here() {
        Record::new("pictures.txt").settle(&pictures::all());
    }
}

#[test]
fn baked_maps_keep_their_bits() {
    if is_recorded_here() {
        Record::new("bakes.txt").settle(&bakes::all());
    }
}
