//! Search for the slope of every texel's cone, eight texels at a time.
//!
//! The cells around the texels come first, then the rest outward through a maximum pyramid. The
//! kind `cone` uses the search for cones that hold no surface. `relaxed-cone` gives it a
//! [`ConeType`] of its own. The encoding of ratios, which both share, is here, too.

mod apexes;
mod block;
mod empty;
mod encoding;
mod field;
mod lanes;
mod near;
mod point;
mod search;
mod slope;
mod tie;
mod walk;

pub(crate) use self::apexes::{Apexes, Region};
pub(crate) use self::block::{Block, cells_of_block, is_in_block, offset_of};
pub(crate) use self::empty::Empty;
pub(crate) use self::encoding::texture;
pub(crate) use self::field::{Field, RelativeCell};
pub(crate) use self::lanes::{COLUMNS, LANE_BITS, LANES, Lanes, bits_of};
pub(crate) use self::search::{ConeType, Search, State};
pub(crate) use self::slope::{Patch, inside_segment, steepest_in_quarter, to_point};
pub(crate) use self::walk::{Bilinear, Group, ProfileVertex, VertexVisitor};
