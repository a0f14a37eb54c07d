//! Both backends give the same bits on the surface `prism`.

use relief_shaders::surface::ENTRIES;
use relief_tests::one_source::shells::compare_surface;

#[test]
fn the_backends_have_the_same_bits() {
    compare_surface(ENTRIES.iter().find(|entry| entry.name == "prism").expect("a listed name"));
}
