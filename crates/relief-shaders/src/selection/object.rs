//! What goes with objects of images.

use super::numbers::{
    CELLS, FRAMES, IMAGES, LIGHT_MAP, NO_REFINEMENT, NO_SEARCH, NO_SHADOW, OBJECT_SHADOW_SIZE, OF_DEPTH,
    PATCH, PYRAMID, SLICED_IMAGES,
};
use super::{Choice, OBJECT, REFINE, SEARCH, SHADOW, STAGES, SURFACE, Selection, Shown};
use crate::geometry::Geometry;
use crate::object::{ObjectCells, Solid};

impl Selection {
    /// How the images of an object are read, where one is shown.
    pub fn object_cells(&self) -> Option<ObjectCells> {
        let Choice { entry, params, .. } = &self.choices[OBJECT];
        self.is_of_images().then(|| ObjectCells::of(entry.name, *params))
    }

    /// Whether all images of an object are asked, and not only some of them that a grid tells.
    pub fn asks_all_images(&self) -> bool {
        let is_of_all = matches!(self.choices[SURFACE].number as usize, IMAGES | SLICED_IMAGES);
        self.object_cells().is_some() && is_of_all
    }

    /// Whether the images of an object are counted in a stencil buffer, which GPUs alone have.
    pub fn counts_in_stencil(&self) -> bool {
        matches!(self.geometry(), Some(Geometry::ObjectSlices(_, true)))
    }

    /// Whether frames of a grid are asked, which an object's images must make.
    pub fn needs_grid(&self) -> bool {
        let is_of_frames = self.choices[SURFACE].number as usize == FRAMES;
        self.object_cells().is_some_and(|object| is_of_frames || object.has_blended_colors)
    }

    /// Whether normals are blended of several images'.
    pub fn blends_normals(&self) -> bool {
        self.object_cells().is_some_and(|object| object.solid == Solid::Blend)
    }

    /// The same with a surface, a search and a shadow for the intersection of what images see.
    pub(super) fn with_stages_for_object(mut self) -> Self {
        let [surface, search, refine, shadow] = if self.shown_by_geometry() == Shown::ObjectSlices {
            [SLICED_IMAGES, NO_SEARCH, NO_REFINEMENT, NO_SHADOW]
        } else {
            [IMAGES, PYRAMID, PATCH, LIGHT_MAP]
        };
        let chosen =
            [(SURFACE, surface), (OBJECT, OF_DEPTH), (SEARCH, search), (REFINE, refine), (SHADOW, shadow)];
        for (stage, number) in chosen {
            self.choices[stage] = Choice::new(&STAGES[stage], number);
        }
        if let Some((place, _)) = self.choices[SHADOW].entry.param("size") {
            self.choices[SHADOW].params[place] = OBJECT_SHADOW_SIZE;
        }
        self.with_search_for_shadows()
    }

    /// The same with a surface and a search that serve what is made of the images, where those that are
    /// chosen do not.
    pub(super) fn with_search_for_object(mut self) -> Self {
        let Some(object) = self.object_cells() else { return self };
        if self.shown_by_geometry() == Shown::ObjectSlices {
            return self;
        }
        let is_blended = self.choices[SEARCH].number as usize == NO_SEARCH;
        if object.solid == Solid::Blend && !is_blended {
            // What lights see of blends lies elsewhere than what eyes do, and would shade all of it.
            let chosen =
                [(SURFACE, FRAMES), (SEARCH, NO_SEARCH), (REFINE, NO_REFINEMENT), (SHADOW, NO_SHADOW)];
            for (stage, number) in chosen {
                self.choices[stage] = Choice::new(&STAGES[stage], number);
            }
            return self.with_search_for_shadows();
        }
        if object.solid == Solid::Blend {
            return self;
        }
        let search = self.choices[SEARCH].number as usize;
        if search == NO_SEARCH || (search == PYRAMID && !object.is_under_texels()) {
            let number = if object.is_under_texels() { PYRAMID } else { CELLS };
            self.choices[SEARCH] = Choice::new(&STAGES[SEARCH], number);
            self.choices[REFINE] = Choice::new(&STAGES[REFINE], PATCH);
            return self.with_search_for_shadows();
        }
        self
    }

    /// The stage that does not go with what is made of the images, and why.
    pub(super) fn at_odds_with_object(&self) -> Option<(usize, &'static str)> {
        let object = self.object_cells()?;
        let [surface, search, refine] = [SURFACE, SEARCH, REFINE].map(|at| self.choices[at].number as usize);
        if object.solid == Solid::Blend {
            let blended = "frames are blended without one: choose 'none'";
            return (surface != FRAMES)
                .then_some((OBJECT, "only the surface 'frames' has frames that can be blended"))
                .or((search != NO_SEARCH).then_some((SEARCH, blended)))
                .or((refine != NO_REFINEMENT).then_some((REFINE, blended)));
        }
        if surface == SLICED_IMAGES {
            return None;
        }
        let nodes = "its nodes bound heights between texels, not silhouettes or steps: choose 'cells'";
        (search == NO_SEARCH)
            .then_some((SEARCH, "images are searched: choose 'cells' or 'pyramid'"))
            .or((refine == NO_REFINEMENT)
                .then_some((REFINE, "heights jump from cell to cell: choose 'patch'")))
            .or((search == PYRAMID && !object.is_under_texels()).then_some((SEARCH, nodes)))
    }
}
