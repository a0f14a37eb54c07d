//! The pairs of search and refinement, and which rays each is held to the exact answer for: the registry says
//! it.

use relief_core::Path;
use relief_core::registry::{Guarantee, RayClass};
use relief_shaders::field::Solids;
use relief_shaders::{Selection, refine, search};

/// Every pair that makes sense over heights, with default parameters.
///
/// # Panics
///
/// Never: the names come from the lists.
pub fn all() -> impl Iterator<Item = Selection> {
    let names = search::ENTRIES.iter().flat_map(|a| refine::ENTRIES.iter().map(move |b| (a.name, b.name)));
    names
        .map(|(search, refine)| Selection::pair(search, refine).unwrap_or_else(|error| panic!("{error}")))
        .filter(|pair| pair.check_pair().is_ok() && pair.solids() == Solids::Heights)
}

/// The pairs that promise the exact answer for a class of rays.
pub fn exact_for(rays: RayClass) -> impl Iterator<Item = Selection> {
    all().filter(move |selection| selection.guarantee(rays) == Guarantee::Exact)
}

/// The class that a path belongs to.
pub fn class_of(path: &Path) -> RayClass {
    match path.h {
        [_, _, bend] if bend != 0.0 => RayClass::Bent,
        [_, rise, _] if rise > 0.0 => RayClass::Shadow,
        _ => RayClass::View,
    }
}

/// The names of a pair, for messages.
pub fn name(selection: &Selection) -> String {
    format!("{} + {}", selection.search().name, selection.refine().name)
}
