//! The sample maps and meshes in `data/`.
//!
//! All but the elevation model are computed, from `+ - * /`, `sqrt` and integers alone, so that every machine
//! gets the same texels.

use crate::output::Generated;
use std::path::Path;

mod bricks;
mod cobbles;
mod jacksboro;
mod lathe;
mod lattice;
mod logo;
mod mushrooms;
mod noise;
mod picture;
mod piebald;
mod spikes;
mod tree;

/// Every file that is generated.
///
/// # Errors
///
/// When the elevation model, from which its colours are made, cannot be read, or a picture cannot be encoded.
pub fn files(root: &Path) -> Result<Vec<Generated>, String> {
    let (bricks, bricks_color) = bricks::maps();
    let (cobbles, cobbles_color, cobbles_orm) = cobbles::maps();
    let elevation = picture::read_grey(&root.join("data/jacksboro.png"))?;
    let maps = [
        ("data/bricks.png", bricks.heights()),
        ("data/bricks_color.png", bricks_color.colours()),
        ("data/cobbles.png", cobbles.heights()),
        // A crate of its own ships what it compares methods on.
        ("crates/relief-compare/data/cobbles.png", cobbles.heights()),
        ("data/cobbles_color.png", cobbles_color.colours()),
        ("data/cobbles_orm.png", cobbles_orm.colours()),
        ("data/spikes.png", spikes::map().heights()),
        ("data/logo.png", logo::map().heights()),
        ("data/noise.png", noise::map().heights()),
        ("data/piebald.png", piebald::colours().colours()),
        ("data/tree_color.png", tree::colours().colours()),
        ("data/jacksboro_color.png", jacksboro::colours(&elevation).colours()),
    ];
    let maps = maps.into_iter().map(|(path, image)| {
        let bytes = picture::encoded(&root.join(path), &image).map_err(|error| format!("{path}: {error}"))?;
        Ok(Generated { path: path.into(), bytes })
    });
    let meshes = [
        ("data/column.obj", lathe::column()),
        ("data/pot.obj", lathe::pot()),
        ("data/tree.obj", tree::mesh()),
    ];
    let meshes = meshes.map(|(path, text)| Ok(Generated { path: path.into(), bytes: text.into_bytes() }));
    let vectors = "data/mushrooms.exr";
    let bytes = mushrooms::encoded(&root.join(vectors)).map_err(|error| format!("{vectors}: {error}"));
    let vectors = bytes.map(|bytes| Generated { path: vectors.into(), bytes });
    maps.chain(meshes).chain([vectors]).collect()
}

#[cfg(test)]
mod tests;
