//! Displaced meshes without cracks, from a height map and a base mesh.
//!
//! The base is cut into *patches*: its triangles, or on a plane tiles of 128² texels. An [edge
//! rule](EdgeRule) divides the sides of patches. Its points depend on a side's two ends alone. An
//! [interior](Interior) fills a patch between its divided sides. So both patches at a side have the
//! same points there, and all patches are made in parallel. Points are counted first and made
//! afterwards: a [`Mesher`] knows the size of its mesh before it makes any block, and then streams
//! it block by block.
//!
//! A point of a side is `(a (n - k) + b k) / n`. The order of the ends depends on the ends alone,
//! so that both patches have the same bits. A point is displaced by the formula of
//! [`BasePoint`](relief_core::mesh::BasePoint), as in the exact tracer of displaced meshes.
//! [`CrackTest`] checks that the triangles fit together.
//!
//! Per-vertex displacement is section 3 of Szirmay-Kalos and Umenhoffer 2008. The edge constraint,
//! by which a side's points follow from the side alone, is section 3 of Gumhold and Hüttner 1999.
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
mod mesher;
pub mod motif;
mod patch;
mod plan;
mod plane;
mod point;
mod settings;
pub mod shell_map;
mod slices;
mod smooth;
mod stream;
mod surface;
mod triangle_budget;
mod triangles;
mod vertex_set;
mod view;

pub use cache_order::cache_misses;
pub use certificate::Certificate;
pub use choices::{BaseSurface, Directions, Fit, Judge, Seams, Shading, Side};
pub use crack::{CrackPart, CrackTest, Cracks};
pub use cull::{Cull, FullBounds, Outside};
pub use edge::{EDGE_RULES, EdgeRule, Spacing, Weights, edge_rule};
pub use error::{MesherError, StreamError};
pub use folds::{FoldedBase, Folds};
pub use interior::{INTERIORS, Interior, check_pair, interior};
pub use mesher::Mesher;
pub use settings::{MeshSettings, Part, Pose};
pub use slices::{
    BoxSlice, BoxSlicer, SliceAnchor, SliceBlock, SliceDirection, SliceError, SliceSettings, SliceVertex,
    Slicer,
};
pub use stream::{Bounds, Rounded, Stream, Streamed};
pub use triangles::{BaseTables, TableEdge, TablePatch, TableVertex};
pub use view::{GridSpace, View};
