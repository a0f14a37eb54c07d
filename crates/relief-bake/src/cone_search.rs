//! The search for the slopes of cones: the steepest from the apexes of every texel, for eight texels at a time.
//!
//! It looks at the cells around the texels first, then outward through a maximum pyramid. The kind `cone` uses it for cones
//! that hold no surface, and `relaxed-cone` brings a [`Sort`] of cone of its own. How ratios are stored is also here.

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
mod walk;

pub(crate) use self::apexes::{Apexes, Region};
pub(crate) use self::block::{Block, cells_of_block, is_in_block, offset_of};
pub(crate) use self::empty::Empty;
pub(crate) use self::encoding::texture;
pub(crate) use self::field::{Field, Seen};
pub(crate) use self::lanes::{COLUMNS, LANE_BITS, LANES, Lanes, bits_of};
pub(crate) use self::search::{Search, Sort, State};
pub(crate) use self::slope::{Patch, inside_segment, steepest_in_quarter, to_point};
pub(crate) use self::walk::{Group, Look};
