//! Choices that follow from another choice.

use super::{Choice, Selection, SelectionError};
use crate::entry::{Companion, Entry, find};
use crate::field::Solids;
use crate::object::{ObjectCells, Solid};
use crate::stages::{
    FIELD, GEOMETRY, OBJECT, REFINE, SEARCH, SHADOW, SHADOW_SEARCH, SLICES, STAGES, SURFACE, stage,
};
use crate::surface::{Proposal, Shown};
use relief_core::registry::{Guarantee, RayClass};

impl Choice {
    /// The first variant of a stage for which `holds` is true, with its default parameters; without
    /// any, the stage's first. Tests check that there is one for every call.
    fn first(place: usize, holds: impl Fn(&Entry) -> bool) -> Self {
        let number = STAGES[place].first(holds).map_or(0, |(number, _)| number);
        Self::new(&STAGES[place], number)
    }
}

impl Selection {
    /// Chooses the search and the refinement that have the exact answer without a baked map.
    pub(super) fn with_reference(mut self) -> Self {
        for place in [SEARCH, REFINE] {
            self.choices[place] = Choice::first(place, |entry| entry.tracing().is_reference);
        }
        self
    }

    /// Chooses the search for shadows that goes with the view's: the same search with its
    /// parameters, or the reference if that cannot trace shadows.
    pub(super) fn with_search_for_shadows(mut self) -> Self {
        self.choices[SHADOW_SEARCH] = self.choices[SEARCH];
        let promised = self.choices[SEARCH].promises().shadow;
        let is_impossible = promised == Guarantee::Impossible;
        let is_taken = || self.check_taken(SHADOW_SEARCH, SHADOW).is_ok();
        let shown = self.solids();
        if shown != Solids::Heights {
            let finds = self.search().tracing().solids.has(shown) && !self.search().is_idle();
            if is_impossible || !finds {
                let of_shown = |entry: &Entry| {
                    entry.tracing().solids == shown && entry.guarantee.shadow != Guarantee::Impossible
                };
                self.choices[SHADOW_SEARCH] = Choice::first(SHADOW_SEARCH, of_shown);
            }
        } else if is_impossible || (self.uses(SHADOW_SEARCH) && !is_taken()) {
            self.choices[SHADOW_SEARCH] = Choice::first(SHADOW_SEARCH, |entry| entry.tracing().is_reference);
        }
        self
    }

    /// Chooses the field whose solids the search finds; keeps the chosen one if it finds several.
    pub(super) fn with_field_of_search(mut self) -> Self {
        let solids = self.search().tracing().solids;
        if solids.is_one() {
            self.choices[FIELD] = Choice::first(FIELD, |entry| entry.field() == solids);
        }
        self
    }

    /// Chooses shells for a search that needs them, unless they are chosen: where light is gathered, or where
    /// motifs stand out of the base.
    pub(super) fn with_surface_of_search(mut self) -> Self {
        let tracing = self.search().tracing();
        let is_straight = |entry: &Entry| !entry.paths().rays.contains(&RayClass::Bent);
        let serves = |entry: &Entry| gathers_on(entry) && (tracing.gathers || is_straight(entry));
        let needs_shells = tracing.gathers || tracing.solids == Solids::Motifs;
        if needs_shells && !serves(self.choices[SURFACE].entry) {
            self.choices[SURFACE] = Choice::first(SURFACE, serves);
        }
        self
    }

    /// Returns the selection for a surface with heights, a volume or a motif. Search and refinement stay:
    /// where they do not find its solids, [`check`](Self::check) says so.
    #[must_use]
    pub fn with_solids(mut self, solids: Solids) -> Self {
        self.choices[FIELD] = Choice::first(FIELD, |entry| entry.field() == solids);
        self.with_search_for_shadows()
    }

    /// Returns the selection for a volume of that many columns, rows and slices, for
    /// which its maps are baked.
    #[must_use]
    pub fn with_volume_size(self, volume_size: [u32; 3]) -> Self {
        Self { volume_size, ..self }
    }

    /// Returns the selection without shadows.
    #[must_use]
    pub fn without_shadows(&self) -> Self {
        let mut without = *self;
        without.choices[SHADOW] = Choice::first(SHADOW, Entry::is_idle);
        without.with_search_for_shadows()
    }

    /// Chooses the geometry's companions, or a surface that shows its triangles.
    pub(super) fn with_companions_of_geometry(mut self) -> Result<Self, SelectionError> {
        let geometry = self.choices[GEOMETRY].entry.geometry();
        self.choices[OBJECT] = Choice::first(OBJECT, Entry::is_idle);
        if !geometry.companions.is_empty() {
            // Triangles and images are made of heights.
            self.choices[FIELD] = Choice::first(FIELD, |entry| entry.field() == Solids::Heights);
            return Ok(self.with_companions(geometry.companions)?.with_search_for_shadows());
        }
        if self.paths().shown != geometry.shown {
            self.choices[SURFACE] = Choice::first(SURFACE, |entry| entry.paths().shown == geometry.shown);
        }
        Ok(self)
    }

    /// Chooses variants that serve an object of images, in place of chosen ones that do not.
    pub(super) fn with_companions_of_object(self) -> Result<Self, SelectionError> {
        let (Some(role), Some(object)) = (self.object_role(), self.object_cells()) else { return Ok(self) };
        let is_searched = role.solid != Solid::Blend;
        let is_served =
            self.search().is_idle() != is_searched && !(is_searched && self.searches_beyond_texels(&object));
        if is_served || self.shown_by_geometry().is_sliced() {
            return Ok(self);
        }
        let mut with = self.with_companions(role.companions)?;
        if is_searched && with.searches_beyond_texels(&object) {
            with = with.with_reference();
        }
        Ok(with.with_search_for_shadows())
    }

    /// Whether the search's map bounds heights between texels, but the cells of that object are
    /// others.
    pub(super) fn searches_beyond_texels(&self, object: &ObjectCells) -> bool {
        let search = self.search();
        search.tracing().serves_images && !search.maps.is_empty() && !object.is_under_texels()
    }

    /// Chooses the refinement that the slices ask for.
    pub(super) fn with_refinement_of_slices(mut self) -> Self {
        let steps = self.choices[SLICES].value("refine");
        self.choices[REFINE] = if steps > 0.0 {
            Choice::first(REFINE, |entry| entry.tracing().joins_slices)
        } else {
            Choice::first(REFINE, Entry::is_idle)
        };
        if let Some((place, _)) = self.choices[REFINE].entry.param("steps") {
            self.choices[REFINE].params[place] = steps;
        }
        self
    }

    /// Chooses variants by name.
    fn with_companions(mut self, companions: &[Companion]) -> Result<Self, SelectionError> {
        for Companion { stage: key, name, settings } in companions {
            let (place, stage) = stage(key).ok_or_else(|| SelectionError::NoStage((*key).to_owned()))?;
            self.choices[place] = Choice::new(stage, find(stage.title, stage.entries, name)?);
            for (name, value) in *settings {
                self.choices[place].set(stage, name, &format!("{key}.{name}"), f64::from(*value))?;
            }
        }
        Ok(self)
    }
}

/// Whether light is gathered on a surface: in shells, which rays go through one after the other.
pub(super) fn gathers_on(surface: &Entry) -> bool {
    let paths = surface.paths();
    paths.proposal == Proposal::Shells && paths.shown == Shown::Relief
}
