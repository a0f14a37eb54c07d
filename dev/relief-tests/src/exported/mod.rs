//! Draws exported shaders as another program would: bound and filled by nothing but what their manifest says.

mod bound;
mod drawn;
mod values;

pub use drawn::{Device, Language, draw};
