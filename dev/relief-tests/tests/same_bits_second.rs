//! The stages have the same bits on both backends: the second of four parts of all legal pairs.

#[test]
fn all_stages_have_the_same_bits() {
    relief_tests::one_source::compare_part(1);
}
