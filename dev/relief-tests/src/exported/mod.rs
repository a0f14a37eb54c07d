//! Draws exported shaders as another program would: bound and filled by nothing but what their manifest says.

mod beside;
mod bound;
mod called;
mod computed;
mod drawn;
pub mod fragments;
mod include;
mod languages;
mod node;
mod points;
mod values;

pub use beside::{Difference, compare, device, exported, rendered};
pub use called::{
    Dialect, OnPath, Point, Seen, SeenOver, differing_hits, paths_of, shortened, size_of, surface_of,
};
pub use drawn::{Device, Language, draw};
pub use include::{Include, compiled as compiled_hlsl};
pub use languages::compiled;
pub use node::{Plane, Sight};
pub use points::points;
