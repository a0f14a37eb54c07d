//! Pictures of numbers: heights, depths, costs and errors in colours, with a legend.
//!
//! [`QUANTITIES`] lists what can be shown of a picture's pixels. [`Gathered`] collects the values
//! of some quantities while a scene is rendered. A [`Sheet`] draws them side by side: each picture
//! with its name, and each quantity with a legend. All pictures of a quantity share one scale,
//! whose ends are the least and the greatest value.
//!
//! ```
//! use relief_core::{HeightMap, Watch, Wrap, mesh::square};
//! use relief_maps::Maps;
//! use relief_render::Renderer;
//! use relief_render::false_color::{Gathered, Group, Sheet, quantity};
//! use relief_scene::{Scene, Surface};
//!
//! let heights = HeightMap::from_fn(64, 64, Wrap::Repeat, |i, j| ((i ^ j) & 8) as f32 / 8.0)?;
//! let surface = Surface::new(square(1)?, heights.with_displacement(0.05, 0.0)?);
//! let scene = Scene::builder(surface).size(64, 48).build()?;
//! let shown = [quantity("height")?, quantity("steps")?];
//! let sheet = Sheet::new(scene.size(), shown.map(|of| Group::of(Some(of), &[of.name])).to_vec())?;
//! let mut gathered = Gathered::new(&scene, &shown.map(Some));
//! Renderer::on_cpu().render_bands(&scene, &mut Maps::in_memory(), true, &Watch::none(), &mut |band| {
//!     gathered.add(band);
//!     Ok(())
//! })?;
//! let panels = gathered.finish().into_iter().map(|content| vec![content]).collect();
//! let canvas = sheet.draw(panels)?;
//! assert_eq!(canvas.size(), sheet.size());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod canvas;
mod gather;
mod legend;
mod palette;
mod quantity;
mod scale;
mod sheet;

pub use canvas::{Canvas, hatched};
pub use gather::{Content, Gathered, Judge};
pub use legend::PALETTE;
pub use palette::Palette;
pub use quantity::{Form, NotOfObjects, QUANTITIES, Quantity, ValueOf, quantity, quantity_of};
pub use scale::{NO_SURFACE, NOT_COMPARABLE, Scale, Tick};
pub use sheet::{Group, Sheet, SheetError};
