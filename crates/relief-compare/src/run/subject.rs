//! Subjects of a comparison: the surfaces of a scene at a scale and a level of their maps, and the
//! views of them.

use std::sync::Arc;

use relief_core::HeightMap;
use relief_core::camera::Camera;
use relief_scene::{Scene, Surface};
use relief_shaders::Selection;

use crate::comparison::Comparison;
use crate::error::CompareError;

/// Surfaces at a scale and a level of their maps.
pub struct Subject {
    pub surfaces: Vec<Surface>,
    /// Columns and rows of the map, and its scale; of the first one if there are several.
    pub map_size: [u32; 2],
    pub scale_m: f64,
}

impl Subject {
    fn new(surfaces: Vec<Surface>) -> Self {
        let first = surfaces.first().map(Surface::height_map);
        let map_size = first.map_or([0; 2], |map| [map.width(), map.height()]);
        Self { map_size, scale_m: first.map_or(0.0, |map| map.scale_m()), surfaces }
    }

    /// Returns the surface if it is the only one. With several, rays and hits cannot be assigned to
    /// a map.
    pub fn only(&self) -> Option<&Surface> {
        if let [surface] = &self.surfaces[..] { Some(surface) } else { None }
    }

    /// Number of texels of all height maps; a shared one counts once.
    pub fn map_texels(&self) -> u64 {
        let mut maps: Vec<&Arc<HeightMap>> = Vec::new();
        for map in self.surfaces.iter().map(Surface::height_map) {
            if !maps.iter().any(|known| Arc::ptr_eq(known, map)) {
                maps.push(map);
            }
        }
        maps.iter().map(|map| u64::from(map.width()) * u64::from(map.height())).sum()
    }
}

/// Returns the scene with the given selections on its surfaces.
pub fn with_selections(
    scene: &Scene,
    surfaces: &[Surface],
    selections: &[Selection],
    samples: u32,
) -> Result<Scene, CompareError> {
    let each = surfaces.iter().zip(selections);
    let surfaces = each.map(|(surface, selection)| surface.clone().with_selection(*selection)).collect();
    Ok(scene.to_builder().surfaces(surfaces).samples(samples).build()?)
}

impl Comparison {
    /// Returns the surfaces at each scale and each level of their maps. Surfaces that share a map
    /// share its levels.
    pub(super) fn subjects(&self) -> Result<Vec<Subject>, CompareError> {
        let scales: Vec<Option<f64>> = if self.scales_m.is_empty() {
            vec![None]
        } else {
            self.scales_m.iter().copied().map(Some).collect()
        };
        let levels = self.map_sides.len().max(1);
        let mut subjects = Vec::with_capacity(levels * scales.len());
        for place in 0..levels {
            for &scale_m in &scales {
                subjects.push(Subject::new(self.displaced(place, scale_m)?));
            }
        }
        Ok(subjects)
    }

    /// Returns the surfaces with maps of one of the requested levels, displaced by the scale.
    fn displaced(&self, place: usize, scale_m: Option<f64>) -> Result<Vec<Surface>, CompareError> {
        type Known<'a> = (&'a Arc<HeightMap>, Arc<HeightMap>);
        let mut known: Vec<Known> = Vec::new();
        let mut surfaces = Vec::new();
        for surface in self.scene.surfaces() {
            let heights = surface.height_map();
            let found = known.iter().find(|(from, _)| Arc::ptr_eq(from, heights));
            let made = match found {
                Some((_, made)) => made.clone(),
                None => {
                    let (own_scale, own_bias) = (heights.scale_m(), heights.bias_m());
                    let scale_m = scale_m.unwrap_or(own_scale);
                    // The ratio of bias and scale stays the same.
                    let lift = if own_scale == 0.0 { -1.0 } else { own_bias / own_scale };
                    let level = self.levels(heights)?.get(place).copied().unwrap_or(0);
                    let made = heights.level(level).with_displacement(scale_m, lift * scale_m)?;
                    let made = Arc::new(made);
                    known.push((heights, made.clone()));
                    made
                }
            };
            surfaces.push(surface.clone().with_height_map(made));
        }
        Ok(surfaces)
    }

    /// Returns the scene from each requested distance, or unchanged.
    pub(super) fn views(&self) -> Result<Vec<(Option<f64>, Scene)>, CompareError> {
        if self.distances_m.is_empty() {
            return Ok(vec![(None, self.scene.clone())]);
        }
        let camera = self.scene.camera();
        let (target, back) = (camera.target(), (camera.eye() - camera.target()).normalize());
        let from = |&distance_m: &f64| {
            let camera: Camera = camera.moved(target + back * distance_m, target)?;
            Ok((Some(distance_m), self.scene.to_builder().camera(camera).build()?))
        };
        self.distances_m.iter().map(from).collect()
    }
}
