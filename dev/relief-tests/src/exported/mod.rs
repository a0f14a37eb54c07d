//! Draws exported shaders as another program would: bound and filled by nothing but what their manifest says.

mod beside;
mod bound;
mod computed;
mod drawn;
mod values;

pub use beside::{Difference, compare, device, exported, rendered};
pub use drawn::{Device, Language, draw};
