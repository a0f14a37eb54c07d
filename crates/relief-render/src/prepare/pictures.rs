//! Cache of the colour and normal maps of a scene's surfaces, from one scene to the next.

use std::sync::Arc;

use relief_core::HeightMap;
use relief_io::Picture;

use crate::frame_cache::{cached, cached_where};
use crate::mipmaps::Mipmaps;
use relief_scene::Surface;
use relief_scene::material_maps::MaterialMaps;

/// Colour and normal maps of a scene's surfaces, with the mip levels that are bound.
#[derive(Debug, Default)]
pub struct Pictures {
    /// Pictures with their finest level alone.
    finest: Vec<(Arc<Picture>, Arc<Mipmaps>)>,
    /// Pictures with all levels.
    levels: Vec<(Arc<Picture>, Arc<Mipmaps>)>,
    /// Normal maps with all levels.
    normals: Vec<(Arc<Picture>, Arc<Mipmaps>)>,
    /// Maps of materials, each with or without coarser levels.
    materials: Vec<(Arc<MaterialMaps>, Arc<Mipmaps>)>,
    /// Normals derived from height maps, with the tile for which they are derived.
    derived: Vec<(Arc<HeightMap>, [f64; 2], Arc<Mipmaps>)>,
}

impl Pictures {
    /// Returns a picture's mip levels, cached or new.
    pub fn of(&mut self, picture: &Arc<Picture>, levels: bool, before: &Pictures) -> Arc<Mipmaps> {
        if levels {
            let make = || Arc::new(Mipmaps::of(Arc::clone(picture)));
            cached(&mut self.levels, &before.levels, picture, make)
        } else {
            let make = || Arc::new(Mipmaps::finest_only(Arc::clone(picture)));
            cached(&mut self.finest, &before.finest, picture, make)
        }
    }

    /// Returns a normal map's mip levels, cached or new.
    pub fn of_normals(&mut self, picture: &Arc<Picture>, levels: bool, before: &Pictures) -> Arc<Mipmaps> {
        if !levels {
            return self.of(picture, false, before);
        }
        let make = || Arc::new(Mipmaps::of_normals(Arc::clone(picture)));
        cached(&mut self.normals, &before.normals, picture, make)
    }

    /// Returns the mip levels of a material's maps, cached or new.
    pub fn of_materials(
        &mut self,
        maps: &Arc<MaterialMaps>,
        levels: bool,
        before: &Pictures,
    ) -> Arc<Mipmaps> {
        let fits = |made: &Mipmaps| (made.levels() > 1) == levels || made.size() == [1, 1];
        let make = || Arc::new(Mipmaps::of_materials(maps, levels));
        cached_where(&mut self.materials, &before.materials, maps, fits, make)
    }

    /// Returns the normals derived from a surface's height map, from the second level on.
    pub fn derived(&mut self, surface: &Surface, before: &Pictures) -> Option<Arc<Mipmaps>> {
        let (map, metric) = (surface.height_map(), surface.metric());
        let is_same = |(of, tile_m, _): &&(Arc<HeightMap>, [f64; 2], _)| {
            Arc::ptr_eq(of, map) && *tile_m == metric.tile_m
        };
        if let Some((_, _, known)) = self.derived.iter().find(is_same) {
            return Some(Arc::clone(known));
        }
        let made = match before.derived.iter().find(is_same) {
            Some((_, _, known)) => Arc::clone(known),
            None => Arc::new(Mipmaps::of_heights(map, metric)?),
        };
        self.derived.push((Arc::clone(map), metric.tile_m, Arc::clone(&made)));
        Some(made)
    }
}
