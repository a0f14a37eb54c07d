//! Contenders: methods with their settings, under a name.

use relief_core::MapFormat;
use relief_scene::Surface;
use relief_shaders::{
    Choice, GEOMETRY, METHODS, REFINE, SEARCH, SHADOW, SHADOW_SEARCH, SLICES, STAGES, SURFACE, Selection,
    SelectionError,
};

/// Method with its settings, under a name.
#[derive(Clone, Debug)]
pub struct Contender {
    /// Name in tables, such as `relief` or `linear+true-secant`.
    pub name: String,
    /// Geometry, search and refinement that it runs. The scene gives the other stages.
    pub selection: Selection,
    /// Number of steps, if methods are compared by steps.
    pub steps: Option<u32>,
    /// Format of its baked maps, if methods are compared by format. None: 32-bit floats.
    pub map_format: Option<MapFormat>,
    /// Shadow, if methods are compared by shadow. None: the scene's.
    pub shadow: Option<Choice>,
}

/// Names of the methods that are compared by default: one of each family, published classics first.
const USUAL: [&str; 8] = [
    // No displacement: where all others begin.
    "bump",
    // One step along the view, without a search.
    "parallax",
    // Equal steps, then halving: the classic of 2005.
    "relief",
    // Equal steps, then the secant: what most engines have.
    "occlusion",
    // Every cell in turn: the exact first hit, without a map.
    "exact",
    // Empty space from a baked map of cones.
    "cone",
    // Empty space from a pyramid, which GPUs build by themselves.
    "quadtree",
    // Displaced triangles instead of a search.
    "vertex",
];

/// Returns the shadow with the given name and its default settings, for [`Contender::with_shadow`].
///
/// # Errors
///
/// When there is no shadow of that name.
pub fn shadow(name: &str) -> Result<Choice, SelectionError> {
    let mut selection = Selection::default();
    selection.choose(STAGES[SHADOW].key, name)?;
    Ok(selection.choices[SHADOW])
}

/// Keys of the parameters for the number of steps, in the order in which they are tried.
const STEPS: [&str; 4] = ["slices.count", "search.steps", "search.limit", "refine.steps"];

impl Contender {
    /// Creates a contender from a name: a method of the [table](METHODS), or a search and a
    /// refinement such as `linear+true-secant`.
    ///
    /// # Errors
    ///
    /// When there is no such method, search or refinement, or the refinement cannot use the
    /// search's result.
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
        Ok(Self { name: name.to_owned(), selection, steps: None, map_format: None, shadow: None })
    }

    /// Returns the methods that are compared by default: eight, one of each family. All of them
    /// take about a quarter of the time of [all](Self::all).
    pub fn usual() -> Vec<Self> {
        USUAL.iter().map(|name| Self::named(name)).filter_map(Result::ok).collect()
    }

    /// Returns every method of the [table](METHODS) that shows height maps, in its order.
    pub fn all() -> Vec<Self> {
        let named =
            METHODS.iter().filter(|method| method.is_of_reliefs()).map(|method| Self::named(method.name));
        named.filter_map(Result::ok).collect()
    }

    /// Returns a copy with `steps` steps, at least 1: as many slices, else steps of its search, else the
    /// search's limit, else steps of its refinement. `None` if it has none of these.
    ///
    /// # Errors
    ///
    /// When the number is not allowed.
    pub fn with_steps(&self, steps: u32) -> Result<Option<Self>, SelectionError> {
        let Some(key) = self.steps_key() else { return Ok(None) };
        let mut with = self.clone();
        with.selection.set(key, f64::from(steps))?;
        with.steps = Some(steps);
        Ok(Some(with))
    }

    /// Returns a copy whose baked maps have the given format. `None` if it reads none.
    pub fn with_map_format(&self, format: MapFormat) -> Option<Self> {
        let of_method = [GEOMETRY, SEARCH, REFINE].map(|place| &self.selection.choices[place]);
        let reads = of_method.into_iter().chain(&self.shadow).any(|choice| !choice.entry.maps.is_empty());
        reads.then(|| Self { map_format: Some(format), ..self.clone() })
    }

    /// Format of its baked maps.
    pub(crate) fn format(&self) -> MapFormat {
        self.map_format.unwrap_or_default()
    }

    /// Returns a copy with its own [shadow].
    #[must_use]
    pub fn with_shadow(&self, shadow: Choice) -> Self {
        Self { shadow: Some(shadow), ..self.clone() }
    }

    /// Returns the key of its number of steps, such as `search.steps`.
    pub fn steps_key(&self) -> Option<&'static str> {
        STEPS.into_iter().find(|key| self.has(key))
    }

    /// Whether one of its stages has a parameter.
    pub fn has(&self, key: &str) -> bool {
        key.split_once('.').is_some_and(|(stage, param)| {
            let place = STAGES.iter().position(|known| known.key == stage);
            place.is_some_and(|place| {
                self.selection.uses(place) && self.selection.choices[place].entry.param(param).is_some()
            })
        })
    }

    /// Returns the name with the settings by which it is compared: steps, format of maps, shadow.
    pub fn label(&self) -> String {
        let format = self.map_format.map(MapFormat::name);
        labelled(&self.name, self.steps, format, self.shadow.map(|shadow| shadow.entry.name))
    }

    /// Whether it searches along rays. The others generate triangles.
    pub fn is_of_rays(&self) -> bool {
        self.selection.geometry().is_none()
    }

    /// Selects the stages for a surface: the method's geometry, search and refinement, and the
    /// surface's other stages. Displaced triangles and slices have a surface stage of their own,
    /// and displaced triangles also a shadow, unless shadows are compared. The shadow search is the
    /// method's own, unless the surface has one that differs from its own method's search.
    ///
    /// # Errors
    ///
    /// When the method cannot be used on the surface; the error says why.
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
        let has_relief = self.selection.paths().has_normals_of_relief();
        let usual = if has_relief || !of_surface.has_shadows() { of_surface } else { &self.selection };
        let shadow = self.shadow.unwrap_or(usual.choices[SHADOW]);
        // This also selects the shadow search.
        selection.choose(STAGES[SHADOW].key, shadow.entry.name)?;
        selection.choices[SHADOW] = shadow;
        let another = &of_surface.choices[SHADOW_SEARCH];
        let is_named = ![of_surface.choices[SEARCH].number, Selection::exact().choices[SEARCH].number]
            .contains(&another.number);
        if is_named {
            selection.choices[SHADOW_SEARCH] = *another;
        }
        selection.check()?;
        Ok(selection)
    }

    /// Selects the stages for several surfaces: the method where it can be used, and the surface's
    /// own elsewhere. Also returns the indices of the latter, with the reason.
    ///
    /// # Errors
    ///
    /// When it can be used on none; returns the first surface's error.
    pub(crate) fn on_all(&self, surfaces: &[Surface]) -> Result<SurfaceSelections, SelectionError> {
        let mut used = SurfaceSelections { selections: Vec::new(), others: Vec::new() };
        for (number, surface) in surfaces.iter().enumerate() {
            let selection = self.on(surface).unwrap_or_else(|error| {
                used.others.push((number, error));
                *surface.selection()
            });
            used.selections.push(selection);
        }
        if used.others.len() < surfaces.len() {
            return Ok(used);
        }
        used.others.into_iter().next().map_or(Ok(SurfaceSelections::default()), |(_, error)| Err(error))
    }
}

/// Stages selected for several surfaces.
#[derive(Default)]
pub(crate) struct SurfaceSelections {
    /// Selection for each surface.
    pub selections: Vec<Selection>,
    /// Indices of the surfaces on which the method is not used, with the reason.
    pub others: Vec<(usize, SelectionError)>,
}

/// Combines a name with the settings by which it is compared.
pub(crate) fn labelled(
    name: &str,
    steps: Option<u32>,
    map_format: Option<&str>,
    shadow: Option<&str>,
) -> String {
    let steps = steps.map(|steps| steps.to_string());
    let parts: Vec<&str> = [steps.as_deref(), map_format, shadow].into_iter().flatten().collect();
    if parts.is_empty() { name.to_owned() } else { format!("{name} ({})", parts.join(", ")) }
}

#[cfg(test)]
mod tests {
    use relief_core::mesh::square;
    use relief_core::{HeightMap, Wrap};

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
    fn shadow_methods_count_and_are_refused_if_unsuitable() {
        let of = |name: &str, own: &str| {
            let contender = Contender::named(name).expect("a method").with_shadow(shadow(own).expect("one"));
            contender
                .on(&surface("ray"))
                .map(|it| [SHADOW, SHADOW_SEARCH].map(|at| it.choices[at].entry.name))
        };
        assert_eq!(of("cone", "none").ok(), Some(["none", "cone"]));
        assert_eq!(of("cone", "soft").ok(), Some(["soft", "cone"]));
        assert_eq!(of("vertex", "scene").map(|names| names[0]).ok(), Some("scene"));
        assert!(of("vertex", "ray").is_err() && shadow("rays").is_err());
        let [plane, none] = ["ray", "none"].map(surface);
        let used = Contender::named("vertex").expect("a method").on_all(&[plane, none]).expect("possible");
        assert_eq!((used.selections.len(), used.others.len()), (2, 0));
    }

    #[test]
    fn maps_have_formats_if_there_are_any() {
        let half = |name: &str| Contender::named(name).expect("a method").with_map_format(MapFormat::F16);
        assert_eq!(half("cone").map(|it| it.label()).as_deref(), Some("cone (half)"));
        assert!(half("relief").is_none() && half("bump").is_none());
        let bump = Contender::named("bump").expect("a method").with_shadow(shadow("horizon").expect("one"));
        let label = bump.with_map_format(MapFormat::Unorm8).map(|it| it.label());
        assert_eq!(label.as_deref(), Some("bump (unorm8, horizon)"));
    }

    #[test]
    fn unknown_names_and_senseless_pairs_are_refused() {
        for name in ["paralax", "linear+nothing", "none+binry", "cells+half-texel"] {
            assert!(Contender::named(name).is_err(), "{name}");
        }
        assert_eq!(Contender::usual().len(), USUAL.len());
        assert_eq!(Contender::all().len(), METHODS.iter().filter(|method| method.is_of_reliefs()).count());
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
