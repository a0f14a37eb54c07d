//! Draws exported shaders as another program would: bound and filled by nothing but what their manifest says.

mod beside;
mod bound;
mod called;
mod compute_pass;
mod computed;
mod dialect;
mod drawn;
pub mod fragments;
mod hits;
mod include;
mod languages;
mod node;
mod numbers;
mod points;
mod text;
mod values;

pub use beside::{Difference, compare, device, exported, rendered};
pub use called::{OnPath, Seen, SeenOver};
pub use dialect::Dialect;
pub use drawn::{Device, Language, draw};
pub use hits::{differing_hits, paths_of, shortened, surface_of};
pub use include::{Include, compiled as compiled_hlsl};
pub use languages::compiled;
pub use node::{Plane, Sight};
pub use numbers::Point;
pub use points::points;
pub use text::size_of;
