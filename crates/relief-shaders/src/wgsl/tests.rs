//! Tests of assembled shaders.

use super::*;
use crate::{refine, search};

fn pairs() -> impl Iterator<Item = Selection> {
    let names = search::ENTRIES.iter().flat_map(|a| refine::ENTRIES.iter().map(move |b| (a.name, b.name)));
    names.map(|(search, refine)| Selection::pair(search, refine).expect("listed names"))
}

fn validate(text: &str) -> Result<(), String> {
    let module = naga::front::wgsl::parse_str(text).map_err(|error| error.emit_to_string(text))?;
    let (flags, capabilities) = (naga::valid::ValidationFlags::all(), naga::valid::Capabilities::empty());
    let valid = naga::valid::Validator::new(flags, capabilities).validate(&module);
    valid.map(drop).map_err(|error| error.emit_to_string(text))
}

#[test]
fn every_pair_gives_a_valid_shader_and_the_same_one_again() {
    for (number, selection) in pairs().enumerate() {
        // Samplings take turns, from root to root and from pair to pair.
        for (turn, root) in (number..).zip(Root::ALL) {
            // Other surfaces have no functions.
            if root == Root::Functions && !selection.paths().through_frame {
                continue;
            }
            let sampling = Sampling::ALL[turn % Sampling::ALL.len()];
            let text = assemble(&selection, root, sampling);
            let name = || format!("{} {} {root:?}", selection.search().name, selection.refine().name);
            validate(&text).unwrap_or_else(|error| panic!("{}: {error}", name()));
            assert_eq!(text, assemble(&selection, root, sampling), "{}", name());
        }
    }
}

#[test]
fn a_broken_shader_is_noticed() {
    let text = assemble(&Selection::default(), Root::Functions, Sampling::Exact);
    assert!(validate(&text.replace("fn height_at", "fn height_elsewhere")).is_err());
}

#[test]
fn a_shader_holds_what_its_root_reaches_and_nothing_else() {
    let cone = Selection::method("cone").expect("a method");
    let trace = assemble(&cone, Root::Trace, Sampling::Exact);
    for there in ["fn search_cone(", "fn refine_patch(", "// Cone stepping", "search_map, the baked map"] {
        assert!(trace.contains(there), "{there}");
    }
    for gone in ["search_linear", "frustum", "shade_", "normal_map", "map_sampler", "override", "switch"] {
        assert!(!trace.contains(gone), "{gone}");
    }
    // Shading without rays to the lights is the same whatever the search.
    let frustum = Selection::method("frustum").expect("a method");
    let shade = |selection: &Selection, shadow| {
        let mut selection = *selection;
        selection.choose("shadow", shadow).expect("a shadow");
        assemble(&selection, Root::Shade, Sampling::Exact)
    };
    assert_eq!(shade(&cone, "none"), shade(&frustum, "none"));
    assert!(shade(&frustum, "ray").contains("fn search_frustum("));
    assert!(assemble(&cone, Root::Shade, Sampling::Fast).contains("map_sampler"));
}
