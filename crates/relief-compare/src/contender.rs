//! What is compared: a method with its settings, under a name.

use relief_render::scene::Surface;
use relief_shaders::{
    GEOMETRY, METHODS, REFINE, SEARCH, SHADOW, SHADOW_SEARCH, SLICES, STAGES, SURFACE, Selection,
    SelectionError,
};

/// A method with its settings, under a name.
#[derive(Clone, Debug)]
pub struct Contender {
    /// The name in tables, such as `relief` or `linear+true-secant`.
    pub name: String,
    /// What it runs: geometry, search and refinement. Of the other stages it has what its scene has.
    pub selection: Selection,
    /// How many steps it takes, where it is compared over these.
    pub steps: Option<u32>,
}

/// The parameters that count the steps of a method, by their keys in the order in which they are looked for.
const STEPS: [&str; 4] = ["slices.count", "search.steps", "search.limit", "refine.steps"];

impl Contender {
    /// A method of the [table](METHODS) by its name, or a search and a refinement as `linear+true-secant`.
    ///
    /// # Errors
    ///
    /// When there is no such method, search or refinement, or the refinement makes nothing of what the search
    /// gives.
    ///
    /// ```
    /// use relief_compare::Contender;
    ///
    /// let steps = Contender::named("relief")?.with_steps(8)?.map(|contender| contender.steps);
    /// assert_eq!(steps, Some(Some(8)));
    /// assert!(Contender::named("bump")?.with_steps(8)?.is_none());
    /// assert_eq!(Contender::named("linear+true-secant")?.name, "linear+true-secant");
    /// # Ok::<(), relief_shaders::SelectionError>(())
    /// ```
    pub fn named(name: &str) -> Result<Self, SelectionError> {
        let selection = match name.split_once('+') {
            Some((search, refine)) => Selection::pair(search, refine)?,
            None => Selection::method(name)?,
        };
        selection.check_pair()?;
        Ok(Self { name: name.to_owned(), selection, steps: None })
    }

    /// Every method of the [table](METHODS), in its order.
    pub fn all() -> Vec<Self> {
        let named = METHODS.iter().map(|method| Self::named(method.name));
        named.filter_map(Result::ok).collect()
    }

    /// The same with so many steps: of its search where that has them, else the search's limit, else those of
    /// its refinement. `None` where it has none of these.
    ///
    /// # Errors
    ///
    /// When so many are not allowed.
    pub fn with_steps(&self, steps: u32) -> Result<Option<Self>, SelectionError> {
        let Some(key) = self.steps_key() else { return Ok(None) };
        let mut with = self.clone();
        with.selection.set(key, f64::from(steps))?;
        with.steps = Some(steps);
        Ok(Some(with))
    }

    /// The key of its steps, as in `search.steps`.
    pub fn steps_key(&self) -> Option<&'static str> {
        STEPS.into_iter().find(|key| self.has(key))
    }

    /// Whether one of its stages has that parameter.
    pub fn has(&self, key: &str) -> bool {
        key.split_once('.').is_some_and(|(stage, param)| {
            let place = STAGES.iter().position(|known| known.key == stage);
            place.is_some_and(|place| {
                self.selection.uses(place) && self.selection.choices[place].entry.param(param).is_some()
            })
        })
    }

    /// The name, with the steps where it has them.
    pub fn label(&self) -> String {
        self.steps.map_or(self.name.clone(), |steps| format!("{} ({steps})", self.name))
    }

    /// Whether it searches along rays; the others make triangles.
    pub fn is_of_rays(&self) -> bool {
        self.selection.geometry().is_none()
    }

    /// What is run on a surface: its own geometry, search and refinement, and all else as the surface has it.
    /// Displaced triangles and slices have a surface of their own, displaced triangles shadows, too. The
    /// search for shadows is the method's own, unless the surface has one that is not its own method's.
    ///
    /// # Errors
    ///
    /// When the method cannot be used on such a surface; the error says why.
    pub(crate) fn on(&self, surface: &Surface) -> Result<Selection, SelectionError> {
        let of_surface = surface.selection();
        let mut selection = *of_surface;
        let own: &[usize] = if self.is_of_rays() {
            &[GEOMETRY, SLICES, SEARCH, REFINE]
        } else {
            &[GEOMETRY, SLICES, SEARCH, REFINE, SURFACE]
        };
        for &place in own {
            selection.choices[place] = self.selection.choices[place];
        }
        let shadow = if self.selection.paths().has_normals_of_relief() || !of_surface.has_shadows() {
            of_surface
        } else {
            &self.selection
        };
        // Chooses the search for shadows, too.
        selection.choose(STAGES[SHADOW].key, shadow.choices[SHADOW].entry.name)?;
        selection.choices[SHADOW] = shadow.choices[SHADOW];
        let another = &of_surface.choices[SHADOW_SEARCH];
        let is_named = ![of_surface.choices[SEARCH].number, Selection::exact().choices[SEARCH].number]
            .contains(&another.number);
        if is_named {
            selection.choices[SHADOW_SEARCH] = *another;
        }
        selection.check()?;
        Ok(selection)
    }
}

#[cfg(test)]
mod tests {
    use relief_core::{HeightMap, Wrap};
    use relief_render::mesh::square;

    use super::*;

    fn surface(shadow: &str) -> Surface {
        let heights = HeightMap::new(1, 1, vec![0.5], Wrap::Repeat).expect("a map");
        let mut selection = Selection::exact();
        selection.choose("shadow", shadow).expect("a shadow");
        Surface::new(square(1).expect("a square"), heights).with_selection(selection)
    }

    #[test]
    fn a_method_is_used_with_the_rest_of_the_surface() {
        let entries = |name: &str, shadow: &str| {
            let selection = Contender::named(name).expect("a method").on(&surface(shadow)).expect("possible");
            [SURFACE, SEARCH, REFINE, SHADOW, SHADOW_SEARCH].map(|place| selection.choices[place].entry.name)
        };
        assert_eq!(entries("cone", "ray"), ["plane", "cone", "patch", "ray", "cone"]);
        assert_eq!(entries("bump", "ray"), ["plane", "none", "none", "ray", "cells"]);
        assert_eq!(entries("relief", "none")[..4], ["plane", "linear", "binary", "none"]);
        assert_eq!(entries("vertex", "ray")[..4], ["facets", "none", "none", "map"]);
        assert_eq!(entries("vertex", "none")[3], "none");
    }

    #[test]
    fn names_that_nothing_has_and_senseless_pairs_are_refused() {
        for name in ["paralax", "linear+nothing", "none+binry", "cells+half-texel"] {
            assert!(Contender::named(name).is_err(), "{name}");
        }
        assert_eq!(Contender::all().len(), METHODS.len());
    }

    #[test]
    fn steps_are_those_of_the_search_its_limit_or_the_refinement() {
        let key = |name: &str| Contender::named(name).expect("a method").steps_key();
        assert_eq!(key("relief"), Some("search.steps"));
        assert_eq!(key("cone"), Some("search.limit"));
        assert_eq!(key("binary-search"), Some("refine.steps"));
        assert_eq!(key("bump"), None);
        let relief = Contender::named("relief").expect("a method");
        assert!(relief.with_steps(0).is_err());
        assert_eq!(relief.with_steps(8).expect("allowed").expect("has steps").label(), "relief (8)");
    }
}
