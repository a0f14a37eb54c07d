//! Registry entry of the search `view-dependent-free`.

use relief_core::FoundState;
use relief_core::registry::{Guarantee, Guarantees, MapInput, MapSetting, Publication};

use super::{AZIMUTHS, BENDS, DEPTH, ELEVATIONS};
use crate::entry::{Entry, Role, TracingRole};

/// Over the way on which all rays from a texel's square in nearly the same direction are free.
pub const ENTRY: Entry = Entry {
    name: "view-dependent-free",
    summary: "steps once, over the way on which all rays from there in nearly the same direction are free",
    publication: Publication { paper: "Relief", section: "" },
    maps: &[MapInput::new("view-dependent-free", "").with(&[
        ("azimuths", MapSetting::Param("azimuths")),
        ("elevations", MapSetting::Param("elevations")),
        ("bends", MapSetting::Param("bends")),
        ("depth", MapSetting::Param("depth")),
        ("bits", MapSetting::Fixed(8.0)),
    ])],
    params: &[AZIMUTHS, ELEVATIONS, BENDS, DEPTH],
    states: &[FoundState::Above],
    guarantee: Guarantees { view: Guarantee::Exact, bent: Guarantee::Exact, shadow: Guarantee::Impossible },
    weakened: &[],
    argument: "The map holds 0.998 of a way on which no path of the same cell of all axes touches the \
        surface, which is less by more than f32 may be off. A path whose cell f32 cannot tell, or that does \
        not come in at the top, takes no step. So whatever `patch` does from there on is what it does from \
        the beginning. A ray to a light begins at the surface, where the map knows nothing.",
    role: Role::Tracing(TracingRole { begins_at_top: true, ..TracingRole::PLAIN }),
};
