//! Tests whether the chosen variants go together.

use relief_core::MAX_LAYERS;
use relief_core::registry::{Guarantee, MapInput, MapLevels, MapSetting, RayClass};

use super::companions::gathers_on;
use super::{Selection, SelectionError};
use crate::Variants;
use crate::entry::Entry;
use crate::field::Solids;
use crate::object::Solid;
use crate::shadow::ShadowRole;
use crate::stages::{
    AMBIENT, DETAIL, GEOMETRY, OBJECT, REFINE, SEARCH, SHADOW, SHADOW_SEARCH, STAGES, SURFACE, Stage,
};
use crate::surface::{AskedImages, Paths, Refused, Shown};

/// A stage, and whether a variant of it serves.
type Rule<'a> = (usize, &'a dyn Fn(&Entry) -> bool);

impl Selection {
    /// Checks that every chosen variant can trace the rays of its stage, and goes with the others.
    ///
    /// # Errors
    ///
    /// When one does not.
    pub fn check(&self) -> Result<(), SelectionError> {
        let used = STAGES.iter().zip(&self.choices).enumerate().filter(|(place, _)| self.uses(*place));
        for (place, (stage, choice)) in used {
            let (entry, promises) = (choice.entry, choice.promises());
            let impossible = |rays: &&RayClass| promises.of(**rays) == Guarantee::Impossible;
            if let Some(rays) = stage.rays.iter().find(impossible) {
                let (stage, key, entry, rays) = (stage.title, stage.key, entry.name, rays.name());
                return Err(SelectionError::Impossible { stage, key, entry, rays });
            }
            let steps = |name| entry.param(name).map(|(place, _)| choice.params[place]);
            // An ambient light gathers all directions into one layer.
            if let (Some(azimuths), Some(elevations)) = (steps("azimuths"), steps("elevations"))
                && place != AMBIENT
                && azimuths * elevations > MAX_LAYERS as f32
            {
                let (stage, key, entry) = (stage.title, stage.key, entry.name);
                let directions = azimuths * elevations;
                return Err(SelectionError::Directions { stage, key, entry, directions });
            }
        }
        self.check_pair()?;
        self.check_field()?;
        self.check_levels()?;
        self.check_surface()?;
        if self.uses(SHADOW_SEARCH) {
            self.check_solids(&[SHADOW_SEARCH])?;
        }
        if self.uses(SHADOW_SEARCH) { self.check_taken(SHADOW_SEARCH, SHADOW) } else { Ok(()) }
    }

    /// Whether a variant of a stage, with default parameters, goes with the choices for all other
    /// stages. Displaced triangles and objects, for example, read no bent normals: `sky` does not
    /// go with them, `hemisphere` does.
    ///
    /// # Errors
    ///
    /// When there is no such stage or no such variant.
    pub fn goes_with(&self, key: &str, name: &str) -> Result<bool, SelectionError> {
        let mut other = *self;
        other.choose(key, name)?;
        Ok(other.check().is_ok())
    }

    /// Checks that all other stages can handle the surface's segments.
    ///
    /// # Errors
    ///
    /// When one cannot.
    fn check_surface(&self) -> Result<(), SelectionError> {
        let Paths { rays, shown, refused, .. } = self.paths();
        let surface = self.choices[SURFACE].entry.name;
        let error = |place: usize, reason| {
            let (Stage { title: stage, key, .. }, entry) = (&STAGES[place], self.choices[place].entry.name);
            Err(SelectionError::Surface { stage, key, entry, surface, reason })
        };
        // Triangles may be displaced already where no geometry displaces them.
        let of_geometry = self.shown_by_geometry();
        if *shown != of_geometry && (*shown, of_geometry) != (Shown::Triangles, Shown::Relief) {
            return error(GEOMETRY, of_geometry.needs(*shown));
        }
        if let Some(reason) = self.geometry().and_then(|geometry| geometry.refused()) {
            return error(GEOMETRY, reason.to_owned());
        }
        match (self.is_of_images(), !self.choices[OBJECT].entry.is_idle()) {
            (true, false) => return error(OBJECT, "choose how the object is made of its images".to_owned()),
            (false, true) => return error(OBJECT, "the geometry shows no images".to_owned()),
            _ => {}
        }
        if let Some((place, reason)) = self.at_odds_with_object() {
            return error(place, reason);
        }
        for (place, (stage, choice)) in STAGES.iter().zip(&self.choices).enumerate() {
            let mut of_stage = refused.iter().filter(|refused| refused.stage == stage.key);
            if let Some(refused) = of_stage.find(|refused| (refused.refuses)(choice.entry)) {
                let others = Variants::of(place, |entry| !(refused.refuses)(entry));
                return error(place, (refused.reason)(&others));
            }
        }
        if self.is_translucent() && !gathers_on(self.choices[SURFACE].entry) {
            let surfaces = Variants::of(SURFACE, gathers_on).or();
            return error(
                SEARCH,
                format!("its light is gathered from shell to shell: choose the surface {surfaces}"),
            );
        }
        for place in [SEARCH, REFINE].into_iter().filter(|_| !self.blends_normals()) {
            let promises = self.choices[place].promises();
            let impossible = |rays: &&RayClass| promises.of(**rays) == Guarantee::Impossible;
            if let Some(rays) = rays.iter().find(impossible) {
                let what = match rays {
                    RayClass::View => "rays come from above there",
                    RayClass::Bent => "rays bend there",
                    RayClass::Shadow => "rays begin inside of the relief there, as rays to a light do",
                };
                let can = |entry: &Entry| {
                    let Paths { rays, shown, refused, .. } = entry.paths();
                    let goes = |place: &usize| {
                        let promises = self.choices[*place].promises();
                        rays.iter().all(|rays| promises.of(*rays) != Guarantee::Impossible)
                    };
                    let stages = || STAGES.iter().zip(&self.choices);
                    let is_taken = |refused: &Refused| {
                        let mut of_stage = stages().filter(|(stage, _)| stage.key == refused.stage);
                        of_stage.all(|(_, choice)| !(refused.refuses)(choice.entry))
                    };
                    (*shown == of_geometry || (*shown, of_geometry) == (Shown::Triangles, Shown::Relief))
                        && [SEARCH, REFINE].iter().all(goes)
                        && refused.iter().all(is_taken)
                };
                let (surfaces, stage) = (Variants::of(SURFACE, can).or(), STAGES[place].title);
                return error(
                    place,
                    format!(
                        "{what}, which it cannot follow: choose the surface {surfaces}, or another {stage}"
                    ),
                );
            }
        }
        Ok(())
    }

    /// Checks that all baked maps that are read can have levels of detail, if the selection has
    /// any.
    ///
    /// # Errors
    ///
    /// When one cannot.
    pub fn check_levels(&self) -> Result<(), SelectionError> {
        let used = STAGES.iter().zip(&self.choices).enumerate().filter(|(place, _)| self.uses(*place));
        for (_, (stage, choice)) in used {
            let serves_all = |(_, value): &(_, MapSetting)| matches!(value, MapSetting::Levels(..));
            let of_one = |map: &MapInput| {
                matches!(map.levels, MapLevels::ChainFrom(_)) && !map.settings.iter().any(serves_all)
            };
            // The bends of paths lie below each other in a map, so it has no levels of the height map's
            // sizes.
            let is_in_blocks = choice.entry.tracing().begins_at_top;
            if self.has_levels() && (is_in_blocks || choice.entry.maps.iter().any(of_one)) {
                let (stage, key, entry) = (stage.title, stage.key, choice.entry.name);
                return Err(SelectionError::OneLevel {
                    stage,
                    key,
                    entry,
                    detail: self.choices[DETAIL].entry.name,
                });
            }
        }
        Ok(())
    }

    /// Checks that the refinement takes the search's results.
    ///
    /// # Errors
    ///
    /// When it does not.
    pub fn check_pair(&self) -> Result<(), SelectionError> {
        if self.is_translucent() && !self.refine().is_idle() {
            return Err(self.not_in_field(REFINE, &Entry::is_idle));
        }
        self.check_solids(&[SEARCH, REFINE])?;
        self.check_taken(SEARCH, REFINE)
    }

    /// Checks that the variants of these stages find the solids of the field.
    fn check_solids(&self, places: &[usize]) -> Result<(), SelectionError> {
        for &place in places {
            let finds = |entry: &Entry| {
                let is_missing = place != REFINE && entry.is_idle() && self.solids() != Solids::Heights;
                entry.tracing().solids.has(self.solids()) && !is_missing
            };
            if !finds(self.choices[place].entry) {
                return Err(self.not_in_field(place, &finds));
            }
        }
        Ok(())
    }

    /// Checks that all other stages can handle a volume or a motif, if one is shown.
    fn check_field(&self) -> Result<(), SelectionError> {
        if self.solids() == Solids::Heights {
            return Ok(());
        }
        let is_base = |entry: &Entry| entry.geometry().shown == Shown::Relief && entry.is_idle();
        let reads_no_heights = |entry: &Entry| entry.maps.is_empty();
        let shadows = |entry: &Entry| {
            entry.maps.is_empty()
                && !matches!(entry.shadow(), Some(ShadowRole::Discs | ShadowRole::FromEntry))
        };
        let rules: [Rule; 4] = [
            (GEOMETRY, &is_base),
            (DETAIL, &Entry::is_idle),
            (SHADOW, &shadows),
            (AMBIENT, &reads_no_heights),
        ];
        if let Some((place, serves)) =
            rules.into_iter().find(|(place, serves)| !serves(self.choices[*place].entry))
        {
            return Err(self.not_in_field(place, serves));
        }
        let shadows = |entry: &Entry| {
            let looks = matches!(entry.shadow(), Some(ShadowRole::LightViews { .. }));
            looks || entry.is_idle() || matches!(entry.shadow(), Some(ShadowRole::ToLights { rays: None }))
        };
        if self.is_translucent() && !shadows(self.choices[SHADOW].entry) {
            return Err(self.not_in_field(SHADOW, &shadows));
        }
        Ok(())
    }

    /// The error for a variant that cannot be used with the field; `serves` says which of its stage can.
    fn not_in_field(&self, place: usize, serves: &dyn Fn(&Entry) -> bool) -> SelectionError {
        SelectionError::Field {
            stage: STAGES[place].title,
            key: STAGES[place].key,
            entry: self.choices[place].entry.name,
            shown: match self.solids() {
                Solids::Volumes if self.is_translucent() => "a translucent volume",
                solids => solids.in_words(),
            },
            others: Variants::of(place, serves),
        }
    }

    /// Checks that the variant of the stage `taker` takes the results of the search of the stage
    /// `giver`.
    pub(super) fn check_taken(&self, giver: usize, taker: usize) -> Result<(), SelectionError> {
        let [search, other] = [giver, taker].map(|place| self.choices[place].entry);
        if search.states.iter().any(|state| other.states.contains(state)) {
            return Ok(());
        }
        let [giver, taker] =
            [(giver, search.name), (taker, other.name)].map(|(place, name)| (STAGES[place].key, name));
        Err(SelectionError::Pair { giver, taker, gives: search.states, takes: other.states })
    }

    /// The stage that does not go with the object of images, and the reason.
    fn at_odds_with_object(&self) -> Option<(usize, String)> {
        let object = self.object_cells()?;
        let [search, refine] = [self.search(), self.refine()];
        let named = |place: usize, is_named: fn(&Entry) -> bool| Variants::of(place, is_named);
        if object.solid == Solid::Blend {
            let of_grid = |entry: &Entry| entry.paths().images == Some(AskedImages::OfGrid);
            let needs_grid = || {
                let surfaces = named(SURFACE, of_grid);
                format!("only the surface {} has frames that can be blended", surfaces.or())
            };
            let blended = |place: usize| {
                format!("frames are blended without one: choose {}", named(place, Entry::is_idle).or())
            };
            let first_active = [SEARCH, REFINE].into_iter().find(|at| !self.choices[*at].entry.is_idle());
            return (self.paths().images != Some(AskedImages::OfGrid))
                .then(|| (OBJECT, needs_grid()))
                .or_else(|| first_active.map(|place| (place, blended(place))));
        }
        if self.paths().shown == Shown::ObjectSlices {
            return None;
        }
        let serving = |place: usize| named(place, |entry| entry.tracing().serves_images);
        if search.is_idle() {
            return Some((SEARCH, format!("images are searched: choose {}", serving(SEARCH).or())));
        }
        if refine.is_idle() {
            let reason = format!("heights jump from cell to cell: choose {}", serving(REFINE).or());
            return Some((REFINE, reason));
        }
        self.searches_beyond_texels(&object).then(|| {
            let others = named(SEARCH, |entry| entry.tracing().serves_images && entry.maps.is_empty());
            let nodes = "its nodes bound heights between texels, not silhouettes or steps";
            (SEARCH, format!("{nodes}: choose {}", others.or()))
        })
    }
}
