//! Both backends give the same bits: the stages of all legal pairs, in parts of bearable
//! length, and surfaces of shells.

use relief_shaders::surface::ENTRIES;
use relief_tests::one_source::compare_part;
use relief_tests::one_source::shells::compare_surface;

#[test]
fn the_first_part_of_all_stages_has_the_same_bits() {
    compare_part(0);
}

#[test]
fn the_second_part_of_all_stages_has_the_same_bits() {
    compare_part(1);
}

#[test]
fn the_third_part_of_all_stages_has_the_same_bits() {
    compare_part(2);
}

#[test]
fn the_last_part_of_all_stages_has_the_same_bits() {
    compare_part(3);
}

fn check_surface(name: &str) {
    compare_surface(ENTRIES.iter().find(|entry| entry.name == name).expect("a listed name"));
}

#[test]
fn the_surface_prism_has_the_same_bits() {
    check_surface("prism");
}

#[test]
fn the_surface_tetrahedra_has_the_same_bits() {
    check_surface("tetrahedra");
}
