//! Draws exported shaders as another program would: bound and filled by nothing but what their manifest says.

mod beside;
mod bound;
mod called;
mod computed;
mod drawn;
mod values;

pub use beside::{Difference, compare, device, exported, rendered};
pub use called::{Dialect, OnPath, Point, Seen, differing_hits, paths_of, shortened, size_of, surface_of};
pub use drawn::{Device, Language, draw};
