//! How a method finds its hit, as a drawing: a cut along the ray with the surface, every turn of the
//! method's loops and what it looked at, the method's hit and the true one.
//!
//! ```
//! use relief_compare::explain::{Cut, Ray};
//! use relief_core::{HeightMap, Metric, Wrap};
//! use relief_shaders::Selection;
//! use relief_shaders::cpu::MethodTracer;
//!
//! let heights = HeightMap::from_fn(64, 64, Wrap::Repeat, |i, j| ((i ^ j) & 8) as f32 / 8.0)?;
//! let heights = heights.with_displacement(0.1, -0.1)?;
//! let ray = Ray { at: [0.1, 0.2], angle_deg: 60.0, direction_deg: 30.0, radius_m: None };
//! let path = ray.path(&heights, Metric::UNIT)?;
//! let tracer = MethodTracer::new(&heights, Metric::UNIT, &Selection::method("relief")?, [])?;
//! let cut = Cut::new("relief", &heights, path, tracer.explain(&path));
//! assert!(cut.figure(None).svg().starts_with("<svg"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod cut;
mod legend;
mod ray;
mod view;
mod volume;

pub use cut::Cut;
pub use ray::{Ray, RayError};
