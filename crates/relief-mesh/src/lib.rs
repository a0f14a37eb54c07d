//! Displaced meshes: a height map and a base mesh go in, triangles come out, without a crack between them.
//!
//! The base is cut into *patches*: its triangles, or on a plane tiles of 128² texels. An [edge
//! rule](EdgeRule) says at which points the sides of patches are divided, and depends on a side's two ends
//! alone; an [interior](Interior) fills a patch between them. So both patches at a side have the same points
//! there, each patch is made by itself, and all of them in parallel. Points are counted first and written
//! then: a [`Mesher`] knows how large its mesh is before it makes any of it, and hands it over block by
//! block.
//!
//! A point of a side is `(a (n - k) + b k) / n`, the ends in an order of their own, so that both sides have
//! the same bits; the displacement is that of [`BasePoint`](relief_core::mesh::BasePoint), which the exact
//! tracer of displaced meshes has, too. The [`CrackTest`] finds out whether it all fits.
//!
//! Per-vertex displacement is section 3 of Szirmay-Kalos and Umenhoffer 2008; that a side's points follow
//! from the side alone is the edge constraint of Gumhold and Hüttner 1999 (section 3).
//!
//! ```
//! use relief_core::{HeightMap, Wrap, mesh::torus};
//! use relief_mesh::{CrackTest, MeshSettings, Mesher};
//!
//! let map = HeightMap::from_fn(64, 32, Wrap::Repeat, |i, j| ((i ^ j) & 8) as f32 / 8.0)?;
//! let map = map.with_displacement(0.02, 0.0)?;
//! let mesher = Mesher::new(&torus(16, 8)?, &map, &MeshSettings { texels: 2, ..MeshSettings::default() })?;
//! let mesh = mesher.mesh()?;
//! assert_eq!(mesh.triangles().len() as u64, mesher.triangles());
//! assert!(CrackTest::of_mesh(&mesh).is_closed());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod at_most;
mod cache_order;
mod certificate;
mod choices;
mod crack;
mod cubic;
mod cull;
mod direction;
mod edge;
mod error;
mod filling;
mod folds;
mod interior;
mod kept;
mod mesher;
mod patch;
mod plan;
mod plane;
mod point;
mod settings;
mod slices;
mod smooth;
mod stream;
mod surface;
mod triangles;
mod view;

pub use cache_order::cache_misses;
pub use certificate::Certificate;
pub use choices::{BaseSurface, Directions, Fit, Judge, Seams, Shading, Side};
pub use crack::{CrackPart, CrackTest, Cracks};
pub use cull::{Cull, Everything, Outside};
pub use edge::{EDGE_RULES, EdgeRule, Spacing, Weights, edge_rule};
pub use error::{MesherError, StreamError};
pub use folds::{FoldedBase, Folds};
pub use interior::{INTERIORS, Interior, check_pair, interior};
pub use mesher::Mesher;
pub use settings::{MeshSettings, Part, Put};
pub use slices::{
    BoxSlice, BoxSlicer, SliceAnchor, SliceBlock, SliceDirection, SliceError, SliceSettings, SliceVertex,
    Slicer,
};
pub use stream::{Bounds, Rounded, Stream, Streamed};
pub use triangles::{BaseTables, TableEdge, TablePatch, TableVertex};
pub use view::{GridSpace, View};
