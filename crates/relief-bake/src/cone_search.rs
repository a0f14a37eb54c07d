//! The search for the slope of every texel's cone, for eight texels at a time.
//!
//! It looks at the cells around the texels first, then outward through a maximum pyramid. The kind `cone`
//! uses it for cones that hold no surface; `relaxed-cone` gives it a [`Sort`] of cone of its own. How both
//! store ratios is here too.

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
pub(crate) use self::field::{Field, Seen};
pub(crate) use self::lanes::{COLUMNS, LANE_BITS, LANES, Lanes, bits_of};
pub(crate) use self::search::{Search, Sort, State};
pub(crate) use self::slope::{Patch, inside_segment, steepest_in_quarter, to_point};
pub(crate) use self::walk::{Bilinear, Group, Look, ProfileVertex};
