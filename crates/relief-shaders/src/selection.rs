//! A variant chosen for every stage, with its settings.

use relief_core::mesh::QuadricCoefficients;
use relief_core::registry::{
    self, Entry, Guarantee, Guarantees, MAX_PARAMS, MapLevels, MapSetting, Param, RayClass, UnknownName,
};
use relief_core::{FoundState, HeightMap};

use crate::Method;
use crate::geometry::{self, Geometry};
use crate::stages::{
    AMBIENT, DETAIL, GEOMETRY, REFINE, SEARCH, SHADOW, SHADOW_SEARCH, STAGES, SURFACE, Stage, entry_place,
    stage,
};
use crate::surface::{PATHS, Paths};

/// A stage's variant, and its parameters.
#[derive(Clone, Copy, Debug)]
pub struct Choice {
    /// The variant.
    pub entry: &'static Entry,
    /// Its number in the shaders: its place in the stage's list.
    pub number: u32,
    /// Its parameters, in its entry's order.
    pub params: [f32; MAX_PARAMS],
}

/// What to run: a choice for every stage.
#[derive(Clone, Copy, Debug)]
pub struct Selection {
    /// The choices, in the order of [`STAGES`].
    pub choices: [Choice; STAGES.len()],
}

/// Why a selection cannot be made.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SelectionError {
    /// No stage has that key.
    #[error("no stage has the key '{0}'; the keys are {keys}", keys = STAGES.map(|stage| stage.key).join(", "))]
    NoStage(String),
    /// No variant has that name.
    #[error(transparent)]
    Unknown(#[from] UnknownName),
    /// A setting's key has another form.
    #[error("the setting '{0}' must begin with {begin}, as in search.steps=64", begin = beginnings())]
    Key(String),
    /// The variant has no such parameter.
    #[error("the {stage} '{entry}' has no parameter '{name}'{}", known(.entries))]
    NoParam {
        /// The stage's title.
        stage: &'static str,
        /// The chosen variant.
        entry: &'static str,
        /// What was asked for.
        name: String,
        /// What there is.
        entries: Vec<&'static str>,
    },
    /// The value is not accepted.
    #[error("{key} is {value}: it must be {} from {min} to {max}", if *integer { "a whole number" } else { "a number" })]
    Value {
        /// The setting.
        key: String,
        /// The value given.
        value: f64,
        /// Least accepted value.
        min: f32,
        /// Greatest accepted value.
        max: f32,
        /// Whether only whole numbers are accepted.
        integer: bool,
    },
    /// The variant cannot be used for the rays that its stage is given.
    #[error("the {stage} '{entry}' is impossible for {rays} rays: choose another")]
    Impossible {
        /// The stage's title.
        stage: &'static str,
        /// The stage's key.
        key: &'static str,
        /// The chosen variant.
        entry: &'static str,
        /// The rays.
        rays: &'static str,
    },
    /// A surface's segments are of no use to another stage's variant.
    #[error("the {stage} '{entry}' cannot be used with the surface '{surface}': {reason}")]
    Surface {
        /// The other stage's title.
        stage: &'static str,
        /// The other stage's key.
        key: &'static str,
        /// What is chosen for it.
        entry: &'static str,
        /// The chosen surface.
        surface: &'static str,
        /// Why.
        reason: String,
    },
    /// A variant's baked map knows the finest level of detail alone.
    #[error(
        "the {stage} '{entry}' cannot be used with the detail '{detail}': the levels of its map are not \
            levels of detail; choose another, or the detail '{none}'", none = crate::detail::NONE
    )]
    OneLevel {
        /// The title of the stage that reads the map.
        stage: &'static str,
        /// The key of that stage.
        key: &'static str,
        /// What is chosen for it.
        entry: &'static str,
        /// The chosen detail.
        detail: &'static str,
    },
    /// A variant makes nothing of what the search before it gives.
    #[error(
        "the {} '{}' makes nothing of what the {} '{}' gives: it takes {}, not {}",
        title(.taker.0), .taker.1, title(.giver.0), .giver.1, named(.takes), named(.gives)
    )]
    Pair {
        /// The key of the search's stage, and its name.
        giver: (&'static str, &'static str),
        /// The key of the stage that is to go on from there, and what is chosen for it.
        taker: (&'static str, &'static str),
        /// How the search ends.
        gives: &'static [FoundState],
        /// What the other takes.
        takes: &'static [FoundState],
    },
}

/// What messages call a variant of the stage of that key.
fn title(key: &str) -> &str {
    stage(key).map_or(key, |(_, stage)| stage.title)
}

fn named(states: &[FoundState]) -> String {
    states.iter().map(|state| state.description()).collect::<Vec<_>>().join(" or ")
}

/// How settings may begin: the keys of the stages of which a variant has parameters.
fn beginnings() -> String {
    let settable = STAGES.iter().filter(|stage| stage.entries.iter().any(|entry| !entry.params.is_empty()));
    settable.map(|stage| format!("'{}.'", stage.key)).collect::<Vec<_>>().join(" or ")
}

fn known(names: &[&str]) -> String {
    if names.is_empty() { "; it has none".to_owned() } else { format!("; it has {}", names.join(", ")) }
}

impl Choice {
    /// The variant of that number, with its default parameters.
    fn new(stage: &'static Stage, number: usize) -> Self {
        let entry = &stage.entries[number];
        Self { entry, number: number as u32, params: entry.defaults() }
    }

    /// What the variant promises with these parameters.
    fn promises(&self) -> Guarantees {
        self.entry.promises(&self.params)
    }
}

impl Default for Selection {
    /// The first variant of every stage, and for shadows a search that can.
    fn default() -> Self {
        let choices = std::array::from_fn(|place| Choice::new(&STAGES[place], 0));
        Self { choices }.with_search_for_shadows()
    }
}

impl Selection {
    /// A search and a refinement by name, with default parameters; of all other stages the first variant.
    ///
    /// # Errors
    ///
    /// When a name is unknown.
    pub fn pair(search: &str, refine: &str) -> Result<Self, SelectionError> {
        let mut selection = Self::default();
        selection.choose("search", search)?;
        selection.choose("refine", refine)?;
        Ok(selection)
    }

    /// The pair that has the exact answer without a baked map.
    pub fn exact() -> Self {
        let mut selection = Self::default();
        selection.choices[SEARCH] = Choice::new(&STAGES[SEARCH], CELLS);
        selection.choices[REFINE] = Choice::new(&STAGES[REFINE], PATCH);
        selection.with_search_for_shadows()
    }

    /// The same with the search for shadows that goes with the view's: that one with its parameters, or
    /// `cells` where it is of no use for shadows.
    fn with_search_for_shadows(mut self) -> Self {
        self.choices[SHADOW_SEARCH] = self.choices[SEARCH];
        let promised = self.choices[SEARCH].promises().shadow;
        let is_taken = || self.check_taken(SHADOW_SEARCH, SHADOW).is_ok();
        if promised == Guarantee::Impossible || (self.uses(SHADOW_SEARCH) && !is_taken()) {
            self.choices[SHADOW_SEARCH] = Choice::new(&STAGES[SHADOW_SEARCH], CELLS);
        }
        self
    }

    /// The same with a surface, a search and a shadow that go with the geometry.
    fn with_stages_for_geometry(mut self) -> Self {
        if self.geometry().is_none() {
            if self.choices[SURFACE].number as usize == FACETS {
                self.choices[SURFACE] = Choice::new(&STAGES[SURFACE], 0);
            }
            return self;
        }
        let chosen = [(SURFACE, FACETS), (SEARCH, NO_SEARCH), (REFINE, NO_REFINEMENT), (SHADOW, LIGHT_MAP)];
        for (stage, number) in chosen {
            self.choices[stage] = Choice::new(&STAGES[stage], number);
        }
        self.with_search_for_shadows()
    }

    /// Which displaced triangles are shown; none where the relief is found pixel by pixel on the base.
    pub fn geometry(&self) -> Option<Geometry> {
        let Choice { entry, params, .. } = &self.choices[GEOMETRY];
        match entry.name {
            geometry::VERTEX => Some(Geometry::Texels(params[0] as u32)),
            geometry::REMESH => Some(Geometry::Pixels(params[0])),
            _ => None,
        }
    }

    /// A method by name, with its settings.
    ///
    /// # Errors
    ///
    /// When the name is unknown.
    pub fn method(name: &str) -> Result<Self, SelectionError> {
        Self::of(crate::method(name)?)
    }

    /// A method, with its settings.
    ///
    /// # Errors
    ///
    /// When the method names a variant that does not exist.
    pub fn of(method: &Method) -> Result<Self, SelectionError> {
        let mut selection = Self::pair(method.search, method.refine)?;
        if method.geometry != geometry::NONE {
            selection.choose(STAGES[GEOMETRY].key, method.geometry)?;
        }
        for &(key, value) in method.settings {
            selection.set(key, f64::from(value))?;
        }
        Ok(selection)
    }

    /// Chooses a variant by its stage's key and its name, as in `choose("search", "linear")`, with default
    /// parameters. With a search or a shadow the search for shadows is chosen, too: that of the view, or
    /// `cells` where that is of no use for shadows. Another `shadow-search` is chosen after these. With a
    /// geometry of displaced triangles the surface `facets` is chosen, no search, and the shadow `map`, which
    /// sees triangles; with the geometry `none` another surface than `facets`.
    ///
    /// # Errors
    ///
    /// When there is no such stage or no such variant.
    pub fn choose(&mut self, key: &str, name: &str) -> Result<(), SelectionError> {
        let (place, stage) = stage(key).ok_or_else(|| SelectionError::NoStage(key.to_owned()))?;
        let number = registry::find(stage.title, stage.entries, name)?;
        self.choices[place] = Choice::new(stage, number);
        if place == GEOMETRY {
            *self = self.with_stages_for_geometry();
        }
        if place == SEARCH || place == SHADOW {
            *self = self.with_search_for_shadows();
        }
        Ok(())
    }

    /// Sets a parameter, as in `set("search.steps", 64.0)`. Where the search for shadows is that of the view,
    /// with the same parameters, it stays that.
    ///
    /// # Errors
    ///
    /// When the key names no parameter of the chosen variants, or the value is out of range.
    pub fn set(&mut self, key: &str, value: f64) -> Result<(), SelectionError> {
        let parts = key.split_once('.').and_then(|(of, name)| Some((stage(of)?, name)));
        let ((place, stage), name) = parts.ok_or_else(|| SelectionError::Key(key.to_owned()))?;
        let [view, shadow] = [SEARCH, SHADOW_SEARCH].map(|stage| &self.choices[stage]);
        let follows = place == SEARCH && (view.number, view.params) == (shadow.number, shadow.params);
        let Choice { entry, params, .. } = &mut self.choices[place];
        let Some((param_place, param)) = entry.param(name) else {
            let entries = entry.params.iter().map(|param| param.name).collect();
            let (stage, entry, name) = (stage.title, entry.name, name.to_owned());
            return Err(SelectionError::NoParam { stage, entry, name, entries });
        };
        params[param_place] = checked(key, param, value)?;
        if follows {
            *self = self.with_search_for_shadows();
        }
        Ok(())
    }

    /// Whether every chosen variant can be used for the rays that its stage is given, and with the others.
    ///
    /// # Errors
    ///
    /// When one cannot.
    pub fn check(&self) -> Result<(), SelectionError> {
        let used = STAGES.iter().zip(&self.choices).enumerate().filter(|(place, _)| self.uses(*place));
        for (_, (stage, choice)) in used {
            let (entry, promises) = (choice.entry, choice.promises());
            let impossible = |rays: &&RayClass| promises.of(**rays) == Guarantee::Impossible;
            if let Some(rays) = stage.rays.iter().find(impossible) {
                let (stage, key, entry, rays) = (stage.title, stage.key, entry.name, rays.name());
                return Err(SelectionError::Impossible { stage, key, entry, rays });
            }
        }
        self.check_pair()?;
        self.check_levels()?;
        self.check_surface()?;
        if self.uses(SHADOW_SEARCH) { self.check_taken(SHADOW_SEARCH, SHADOW) } else { Ok(()) }
    }

    /// Whether the relief lies on a smooth base in place of flat triangles.
    pub fn has_smooth_base(&self) -> bool {
        let Choice { entry, params, .. } = &self.choices[SURFACE];
        entry.param("lift").is_some_and(|(place, _)| params[place] != 0.0)
    }

    /// The same with segments that run at most so many texels beside their rays, on surfaces that know such a
    /// tolerance.
    #[must_use]
    pub fn with_tolerance_within(mut self, texels: f32) -> Self {
        let Choice { entry, params, .. } = &mut self.choices[SURFACE];
        if let Some((place, _)) = entry.param("tolerance") {
            params[place] = params[place].min(texels);
        }
        self
    }

    /// Which quadrics the surface follows around the corners of its triangles, where it follows any. Its
    /// triangles are moved out along their normals where relief would rise above them.
    pub fn quadrics(&self) -> Option<QuadricCoefficients> {
        let Choice { entry, params, .. } = &self.choices[SURFACE];
        let (place, _) = entry.param("coefficients")?;
        Some(if params[place] < 3.0 { QuadricCoefficients::Two } else { QuadricCoefficients::Three })
    }

    /// What the chosen surface makes of rays.
    pub fn paths(&self) -> &'static Paths {
        &PATHS[self.choices[SURFACE].number as usize]
    }

    /// Whether all other stages make something of the surface's segments.
    ///
    /// # Errors
    ///
    /// When one does not.
    fn check_surface(&self) -> Result<(), SelectionError> {
        let Paths { rays, has_relief, refused, .. } = self.paths();
        let surface = self.choices[SURFACE].entry.name;
        let error = |place: usize, reason| {
            let (Stage { title: stage, key, .. }, entry) = (&STAGES[place], self.choices[place].entry.name);
            Err(SelectionError::Surface { stage, key, entry, surface, reason })
        };
        if self.geometry().is_some() && *has_relief {
            return error(GEOMETRY, geometry::DISPLACED.to_owned());
        }
        for (place, (stage, choice)) in STAGES.iter().zip(&self.choices).enumerate() {
            let of_stage = refused.iter().filter(|refused| refused.stage == stage.key);
            if let Some(refused) = of_stage.into_iter().find(|it| it.names.contain(choice.entry.name)) {
                return error(place, refused.reason.to_owned());
            }
        }
        for place in [SEARCH, REFINE] {
            let promises = self.choices[place].promises();
            let impossible = |rays: &&RayClass| promises.of(**rays) == Guarantee::Impossible;
            if let Some(rays) = rays.iter().find(impossible) {
                return error(place, format!("its segments include {} rays", rays.name()));
            }
        }
        Ok(())
    }

    /// Whether pixels are seen in several levels of detail.
    pub fn has_levels(&self) -> bool {
        self.choices[DETAIL].entry.name != crate::detail::NONE
    }

    /// How many levels of a height map are read.
    pub fn levels_of(&self, map: &HeightMap) -> u32 {
        if self.has_levels() { map.levels() } else { 1 }
    }

    /// Whether all baked maps that are read can have the levels of detail that are seen.
    ///
    /// # Errors
    ///
    /// When one cannot.
    pub fn check_levels(&self) -> Result<(), SelectionError> {
        let used = STAGES.iter().zip(&self.choices).enumerate().filter(|(place, _)| self.uses(*place));
        for (_, (stage, choice)) in used {
            let serves_all = |(_, value): &(_, MapSetting)| matches!(value, MapSetting::Levels(..));
            let of_one = |map: &registry::MapInput| {
                matches!(map.levels, MapLevels::ChainFrom(_)) && !map.settings.iter().any(serves_all)
            };
            if self.has_levels() && choice.entry.maps.iter().any(of_one) {
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

    /// Whether the refinement makes something of what the search gives.
    ///
    /// # Errors
    ///
    /// When it does not.
    pub fn check_pair(&self) -> Result<(), SelectionError> {
        self.check_taken(SEARCH, REFINE)
    }

    /// Whether a stage is asked for anything: the search for shadows is not, where no shadow sends rays.
    pub fn uses(&self, stage: usize) -> bool {
        stage != SHADOW_SEARCH || !self.choices[SHADOW].entry.states.is_empty()
    }

    /// Whether the variant of the stage `taker` makes something of what the search of the stage `giver`
    /// gives.
    fn check_taken(&self, giver: usize, taker: usize) -> Result<(), SelectionError> {
        let [search, other] = [giver, taker].map(|place| self.choices[place].entry);
        if search.states.iter().any(|state| other.states.contains(state)) {
            return Ok(());
        }
        let [giver, taker] =
            [(giver, search.name), (taker, other.name)].map(|(place, name)| (STAGES[place].key, name));
        Err(SelectionError::Pair { giver, taker, gives: search.states, takes: other.states })
    }

    /// The chosen search.
    pub fn search(&self) -> &'static Entry {
        self.choices[SEARCH].entry
    }

    /// The chosen refinement.
    pub fn refine(&self) -> &'static Entry {
        self.choices[REFINE].entry
    }

    /// What search and refinement together promise for a class of rays: the weaker of the two promises.
    pub fn guarantee(&self, rays: RayClass) -> Guarantee {
        let [search, refine] = [SEARCH, REFINE].map(|stage| self.choices[stage].promises().of(rays));
        search.min(refine)
    }

    /// Whether the relief casts shadows.
    pub fn has_shadows(&self) -> bool {
        self.choices[SHADOW].number as usize != NO_SHADOW
    }

    /// Whether the surroundings are seen: in reflections, and through the surface.
    pub fn sees_environment(&self) -> bool {
        self.choices[AMBIENT].number as usize == ENVIRONMENT
    }

    /// Whether shadows are those of rays through the exact search without a baked map.
    pub fn has_exact_shadows(&self) -> bool {
        let [shadow, search] = [SHADOW, SHADOW_SEARCH].map(|stage| self.choices[stage].number as usize);
        (shadow == RAY || shadow == SOFT) && search == CELLS
    }

    /// To how many points of a light's disc shadows send rays: 0 where they send one to its centre, or none.
    pub fn points_of_lights(&self) -> u32 {
        let shadow = &self.choices[SHADOW];
        let samples = shadow.entry.param("samples").filter(|_| shadow.number as usize == SOFT);
        samples.map_or(0, |(place, _)| shadow.params[place] as u32)
    }

    /// The sides, in texels, of what lights are to see, and how many pictures of it there are of a light that
    /// is far away; none where shadows are not looked up there.
    pub fn light_views(&self) -> Option<[u32; 2]> {
        let shadow = &self.choices[SHADOW];
        let [size, cascades, ..] = shadow.params;
        (shadow.number as usize == LIGHT_MAP).then_some([size as u32, cascades as u32])
    }

    /// To how many points of a light's disc rays go through the whole scene; none where shadows are others.
    /// Such rays no surface can trace alone, and no GPU.
    pub fn rays_through_scene(&self) -> Option<u32> {
        let shadow = &self.choices[SHADOW];
        (shadow.number as usize == SCENE).then_some(shadow.params[0] as u32)
    }

    /// Whether this is the pair that has the exact answer without a baked map, whatever its parameters.
    pub fn is_exact(&self) -> bool {
        let numbers = [SEARCH, REFINE].map(|stage| self.choices[stage].number as usize);
        numbers == [CELLS, PATCH]
    }
}

/// The number of the search `cells`.
const CELLS: usize = entry_place(STAGES[SEARCH].entries, "cells");

/// The number of the surface `facets`.
const FACETS: usize = entry_place(STAGES[SURFACE].entries, "facets");

/// The number of the search `none`.
const NO_SEARCH: usize = entry_place(STAGES[SEARCH].entries, "none");

/// The number of the refinement `none`.
const NO_REFINEMENT: usize = entry_place(STAGES[REFINE].entries, "none");

/// The number of the shadow `none`.
const NO_SHADOW: usize = entry_place(STAGES[SHADOW].entries, "none");

/// The number of the ambient light of the surroundings.
const ENVIRONMENT: usize = entry_place(STAGES[AMBIENT].entries, "environment");

/// The number of the shadow `soft`.
const SOFT: usize = entry_place(STAGES[SHADOW].entries, "soft");

/// The number of the shadow `ray`.
const RAY: usize = entry_place(STAGES[SHADOW].entries, "ray");

/// The number of the shadow `map`.
const LIGHT_MAP: usize = entry_place(STAGES[SHADOW].entries, "map");

/// The number of the shadow `scene`.
const SCENE: usize = entry_place(STAGES[SHADOW].entries, "scene");

/// The number of the refinement `patch`.
const PATCH: usize = entry_place(STAGES[REFINE].entries, "patch");

fn checked(key: &str, param: &Param, value: f64) -> Result<f32, SelectionError> {
    let (min, max) = (f64::from(param.min), f64::from(param.max));
    if !(min..=max).contains(&value) || (param.integer && value.fract() != 0.0) {
        let (min, max, integer) = (param.min, param.max, param.integer);
        return Err(SelectionError::Value { key: key.to_owned(), value, min, max, integer });
    }
    Ok(value as f32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::METHODS;

    #[test]
    fn every_method_is_a_valid_selection() {
        for method in METHODS {
            let selection = Selection::of(method).expect("listed names");
            assert_eq!(selection.check(), Ok(()), "{}", method.name);
        }
        assert!(Selection::method("exact").is_ok_and(|selection| selection.is_exact()));
        let exact = Selection::exact();
        assert_eq!((exact.search().name, exact.refine().name), ("cells", "patch"));
    }

    #[test]
    fn a_pair_promises_what_the_weaker_of_the_two_does() {
        let exact = Selection::method("cone").expect("a method");
        let sampled = Selection::pair("linear", "patch").expect("listed names");
        let stepped = Selection::pair("cone", "binary").expect("listed names");
        for rays in RayClass::ALL {
            assert_eq!(exact.guarantee(rays), Guarantee::Exact);
            assert_eq!(sampled.guarantee(rays), Guarantee::Approximate);
            assert_eq!(stepped.guarantee(rays), Guarantee::Approximate);
        }
    }

    #[test]
    fn a_shadow_takes_the_search_of_the_view_where_that_can_and_cells_else() {
        let with_shadow = |method: &str| {
            let mut selection = Selection::method(method).expect("a method");
            selection.choose("shadow", "ray").expect("a shadow");
            selection
        };
        for (method, search) in
            [("cone", "cone"), ("relief", "linear"), ("relaxed", "cells"), ("parallax", "cells")]
        {
            let selection = with_shadow(method);
            assert_eq!(selection.choices[SHADOW_SEARCH].entry.name, search, "{method}");
            assert_eq!(selection.check(), Ok(()), "{method}");
        }
        // The map is needed in both slots, and in none without a shadow.
        let slots =
            |selection: &Selection| selection.map_needs().iter().map(|need| need.slot).collect::<Vec<_>>();
        let mut selection = with_shadow("cone");
        assert_eq!(slots(&selection), [crate::MapSlot::Search, crate::MapSlot::ShadowSearch]);
        assert!(with_shadow("exact").has_exact_shadows() && !selection.has_exact_shadows());
        selection.choose("shadow", "none").expect("a shadow");
        assert_eq!(slots(&selection), [crate::MapSlot::Search]);
        for refused in ["none", "relaxed-cone"] {
            let mut selection = with_shadow("exact");
            selection.choose("shadow-search", refused).expect("a search");
            assert!(selection.check().is_err(), "{refused}");
        }
    }

    #[test]
    fn displaced_triangles_are_shown_by_one_surface_and_searched_by_nothing() {
        let vertex = Selection::method("vertex").expect("a method");
        assert_eq!((vertex.check(), vertex.geometry()), (Ok(()), Some(Geometry::Texels(1))));
        assert_eq!((vertex.paths().has_relief, vertex.light_views()), (false, Some([2048, 1])));
        let mut remesh = Selection::exact();
        remesh.choose("geometry", "remesh").expect("a geometry");
        remesh.set("geometry.pixels", 2.5).expect("a parameter");
        assert_eq!((remesh.check(), remesh.geometry()), (Ok(()), Some(Geometry::Pixels(2.5))));
        remesh.choose("geometry", "none").expect("a geometry");
        assert_eq!((remesh.geometry(), remesh.paths().has_relief), (None, true));
        let refused = [
            ("surface", "prism", "geometry"),
            ("search", "linear", "search"),
            ("refine", "slope", "refine"),
            ("detail", "fade", "detail"),
            ("shadow", "ray", "shadow"),
            ("shadow", "horizon", "shadow"),
            ("ambient", "bent-normal", "ambient"),
        ];
        for (stage, name, expected) in refused {
            let mut selection = vertex;
            selection.choose(stage, name).expect("a listed name");
            let found = selection.check();
            let is_that = matches!(found, Err(SelectionError::Surface { key, .. }) if key == expected);
            assert!(is_that, "{stage} {name}: {found:?}");
        }
        for (stage, name) in [("shadow", "none"), ("shadow", "scene"), ("detail", "footprint")] {
            let mut selection = vertex;
            selection.choose(stage, name).expect("a listed name");
            assert_eq!(selection.check(), Ok(()), "{name}");
        }
        let mut unknown = Selection::default();
        let error = unknown.choose("geometry", "vertx").expect_err("no such geometry").to_string();
        assert!(error.contains("did you mean 'vertex'"), "{error}");
    }

    #[test]
    fn settings_reach_their_place_and_nothing_else_is_accepted() {
        let mut selection = Selection::method("relief").expect("a method");
        selection.set("search.grazing", 4.0).expect("a parameter");
        assert_eq!(selection.choices[SEARCH].params, [32.0, 4.0, 0.0, 0.0]);
        assert!(matches!(selection.set("steps", 4.0), Err(SelectionError::Key(_))));
        assert!(matches!(selection.set("nothing.steps", 4.0), Err(SelectionError::Key(_))));
        assert!(matches!(selection.set("shade.steps", 4.0), Err(SelectionError::NoParam { .. })));
        assert!(matches!(selection.set("search.stepz", 4.0), Err(SelectionError::NoParam { .. })));
        for bad in [0.0, 1.5, f64::NAN, f64::INFINITY, -3.0] {
            assert!(matches!(selection.set("search.steps", bad), Err(SelectionError::Value { .. })), "{bad}");
        }
        assert_eq!(selection.choices[SEARCH].params[0], 32.0);
        assert!(matches!(selection.choose("nothing", "none"), Err(SelectionError::NoStage(_))));
        assert!(matches!(selection.choose("refine", "bianry"), Err(SelectionError::Unknown(_))));
    }

    #[test]
    fn a_variant_that_is_impossible_for_its_stages_rays_is_refused() {
        let mut selection = Selection::default();
        assert_eq!(selection.check(), Ok(()));
        let refused = Box::leak(Box::new(Entry {
            guarantee: Guarantees { view: Guarantee::Impossible, ..Guarantees::all(Guarantee::Exact) },
            ..*selection.search()
        }));
        selection.choices[SEARCH].entry = refused;
        let expected =
            SelectionError::Impossible { stage: "search", key: "search", entry: "none", rays: "view" };
        assert_eq!(selection.check(), Err(expected));
    }
}
