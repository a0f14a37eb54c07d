//! The work of a comparison: rays first, then pictures, for each level of the map and each scale.

mod pictures;
mod rays;
mod reference;
mod times;

use relief_core::registry::RayClass;
use relief_core::{HeightMap, MapIdentity, Metric};
use relief_maps::{Maps, Origin, Provided, Watch as MapWatch};
use relief_render::scene::Surface;
use relief_shaders::{GEOMETRY, REFINE, SEARCH, Selection};

use crate::comparison::{Comparison, Watch};
use crate::contender::Contender;
use crate::error::CompareError;
use crate::picture::{Flip, Image};
use crate::record::{About, LeftOut, MethodRecord, Records};

/// What a comparison finds.
#[derive(Clone, Debug, Default)]
pub struct Compared {
    /// The numbers.
    pub records: Records,
    /// The pictures, one for each of [`Records::pictures`] in their order.
    pub shown: Vec<Shown>,
    /// What these are compared with.
    pub references: Vec<Reference>,
}

/// A picture of a method.
#[derive(Clone, Debug)]
pub struct Shown {
    /// The picture.
    pub image: Image,
    /// How it differs from its reference.
    pub difference: Flip,
    /// Its reference's place among [`Compared::references`].
    pub reference: usize,
}

/// A picture that others are compared with.
#[derive(Clone, Debug)]
pub struct Reference {
    /// Columns and rows of the height map.
    pub map_size: [u32; 2],
    /// Metres between heights 0 and 1.
    pub scale_m: f64,
    /// The picture.
    pub image: Image,
}

/// The maps that methods read, and how long each took to bake.
struct Baked {
    maps: Maps,
    seconds: Vec<(MapIdentity, f64)>,
}

/// The maps of a method.
struct MapsOf {
    provided: Provided,
    /// What they take together.
    bytes: u64,
    /// How long they took when they were baked.
    seconds: f64,
}

impl Baked {
    fn new() -> Self {
        Self { maps: Maps::in_memory(), seconds: Vec::new() }
    }

    /// The maps of a method.
    fn provide(
        &mut self,
        selection: &Selection,
        heights: &HeightMap,
        watch: &Watch,
    ) -> Result<MapsOf, CompareError> {
        watch.check()?;
        let map_watch = MapWatch { cancel: watch.cancel, ..MapWatch::none() };
        let provided = self.maps.provide(selection, heights, Metric::UNIT, &map_watch);
        // A bake that was ended is no bake that failed.
        let provided = provided.map_err(|error| watch.check().err().unwrap_or(error.into()))?;
        let mut different: Vec<&MapIdentity> = Vec::new();
        let mut bytes = 0;
        for (_, map) in provided.maps() {
            if !different.contains(&map.identity()) {
                different.push(map.identity());
                bytes += map.layout().bytes();
            }
        }
        let mut seconds = 0.0;
        for (identity, account) in different.into_iter().zip(provided.accounts()) {
            if account.origin == Origin::Bake {
                self.seconds.push((identity.clone(), account.elapsed.as_secs_f64()));
            }
            let known = self.seconds.iter().find(|(known, _)| known == identity);
            seconds += known.map_or(0.0, |(_, seconds)| *seconds);
        }
        Ok(MapsOf { provided, bytes, seconds })
    }
}

impl Comparison {
    /// Compares.
    ///
    /// # Errors
    ///
    /// When a number is not possible, there is nothing to compare, a map cannot be baked, a picture cannot be
    /// made, or the work was ended. Methods that cannot be used on the surface are
    /// [left out](Records::left_out), with the reason.
    pub fn run(&self, watch: &Watch) -> Result<Compared, CompareError> {
        self.check()?;
        let surface = self.surface()?;
        let mut compared = Compared::default();
        let mut usable = Vec::new();
        for contender in self.entrants()? {
            match contender.on(surface) {
                Ok(_) => usable.push(contender),
                Err(error) => {
                    let (what, reason) = (contender.label(), error.to_string());
                    compared.records.left_out.push(LeftOut { what, reason });
                }
            }
        }
        let subjects = self.subjects(surface)?;
        let is_flat = reference::is_flat(surface.mesh());
        let of_rays = if is_flat && self.rays > 0 { usable.len() } else { 0 };
        let of_pictures =
            if self.machines.is_empty() { 0 } else { 1 + (usable.len() + 1) * self.machines.len() };
        let mut baked = Baked::new();
        let mut done = Done { parts: subjects.len() * (of_rays + of_pictures), done: 0 };
        if of_rays > 0 {
            for subject in &subjects {
                self.rays(subject, &usable, &mut baked, &mut done, watch, &mut compared.records)?;
            }
        }
        self.pictures(&subjects, &usable, &mut baked, &mut done, watch, &mut compared)?;
        let heights = surface.height_map();
        compared.records.about = About {
            map: self.name.clone(),
            map_size: [heights.width(), heights.height()],
            tile_m: surface.metric().tile_m,
            program: format!("relief {}", env!("CARGO_PKG_VERSION")),
            reference: reference::words(is_flat).to_owned(),
            ..compared.records.about
        };
        Ok(compared)
    }

    /// The surface at each scale of each level of its map.
    fn subjects(&self, surface: &Surface) -> Result<Vec<Surface>, CompareError> {
        let heights = surface.height_map();
        let (own_scale, own_bias) = (heights.scale_m(), heights.bias_m());
        let scales = if self.scales_m.is_empty() { vec![own_scale] } else { self.scales_m.clone() };
        // The relief lies as high above the mesh as it did, in scales.
        let lift = if own_scale == 0.0 { -1.0 } else { own_bias / own_scale };
        let mut subjects = Vec::new();
        for level in self.levels(heights)? {
            for &scale_m in &scales {
                let heights = heights.level(level).with_displacement(scale_m, lift * scale_m)?;
                subjects.push(surface.clone().with_height_map(heights));
            }
        }
        Ok(subjects)
    }
}

/// How much of the work is done.
struct Done {
    parts: usize,
    done: usize,
}

impl Done {
    /// Says what comes next.
    fn next(&mut self, watch: &Watch, what: &str) {
        (watch.progress)(what, self.done as f32 / self.parts.max(1) as f32);
        self.done += 1;
    }
}

impl MethodRecord {
    fn of(contender: &Contender, heights: &HeightMap, maps: &MapsOf) -> Self {
        let name = |place: usize| contender.selection.choices[place].entry.name.to_owned();
        Self {
            method: contender.name.clone(),
            steps: contender.steps,
            steps_key: contender.steps.and(contender.steps_key()).map(str::to_owned),
            geometry: name(GEOMETRY),
            search: name(SEARCH),
            refine: name(REFINE),
            promise: contender.selection.guarantee(RayClass::View).name().to_owned(),
            map_size: [heights.width(), heights.height()],
            scale_m: heights.scale_m(),
            map_bytes: maps.bytes,
            bake_seconds: maps.seconds,
        }
    }
}
