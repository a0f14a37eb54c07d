//! A variant chosen for every stage, with its settings.

mod error;
mod numbers;
mod object;

use relief_core::HeightMap;
use relief_core::mesh::QuadricCoefficients;
use relief_core::registry::{
    self, Entry, Guarantee, Guarantees, MAX_PARAMS, MapLevels, MapSetting, Param, RayClass, UnknownName,
};

pub use self::error::SelectionError;
use self::numbers::{
    CELLS, ENVIRONMENT, FACETS, LIGHT_MAP, NO_REFINEMENT, NO_SEARCH, NO_SHADOW, PATCH, RAY, SCENE, SECANT,
    SLICED, SOFT,
};
use crate::Method;
use crate::geometry::{self, Geometry, Tessellated};
use crate::object::Solid;
use crate::slice::{SliceDirection, Slices};
use crate::stages::{
    AMBIENT, DETAIL, GEOMETRY, OBJECT, REFINE, SEARCH, SHADOW, SHADOW_SEARCH, SLICES, STAGES, SURFACE, Stage,
    stage, stage_of_setting,
};
use crate::surface::{PATHS, Paths, Shown};

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
        Self::exact_over(Self::default()).with_search_for_shadows()
    }

    /// The same with the pair that needs no baked map.
    fn exact_over(mut self) -> Self {
        self.choices[SEARCH] = Choice::new(&STAGES[SEARCH], CELLS);
        self.choices[REFINE] = Choice::new(&STAGES[REFINE], PATCH);
        self
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
        let shown = self.shown_by_geometry();
        if self.is_of_images() {
            return self.with_stages_for_object();
        }
        self.choices[OBJECT] = Choice::new(&STAGES[OBJECT], 0);
        if shown == Shown::Relief {
            if self.paths().shown != shown {
                self.choices[SURFACE] = Choice::new(&STAGES[SURFACE], 0);
            }
            return self;
        }
        let (surface, shadow) = if shown == Shown::Slices { (SLICED, RAY) } else { (FACETS, LIGHT_MAP) };
        let chosen = [(SURFACE, surface), (SEARCH, NO_SEARCH), (REFINE, NO_REFINEMENT), (SHADOW, shadow)];
        for (stage, number) in chosen {
            self.choices[stage] = Choice::new(&STAGES[stage], number);
        }
        self.with_search_for_shadows()
    }

    /// The same with the refinement that the slices ask for.
    fn with_refinement_of_slices(mut self) -> Self {
        let Choice { entry, params, .. } = &self.choices[SLICES];
        let steps = entry.param("refine").map_or(0.0, |(place, _)| params[place]);
        let number = if steps > 0.0 { SECANT } else { NO_REFINEMENT };
        self.choices[REFINE] = Choice::new(&STAGES[REFINE], number);
        if let Some((place, _)) = self.choices[REFINE].entry.param("steps") {
            self.choices[REFINE].params[place] = steps;
        }
        self
    }

    /// Whether the geometry is that of an object of images.
    fn is_of_images(&self) -> bool {
        matches!(self.shown_by_geometry(), Shown::Object | Shown::ObjectSlices)
    }

    /// What the triangles of the geometry show.
    fn shown_by_geometry(&self) -> Shown {
        if self.choices[GEOMETRY].entry.name == geometry::OBJECT {
            return Shown::Object;
        }
        match self.geometry() {
            None => Shown::Relief,
            Some(Geometry::Slices(_)) => Shown::Slices,
            Some(Geometry::ObjectSlices(..)) => Shown::ObjectSlices,
            Some(_) => Shown::Triangles,
        }
    }

    /// Which triangles are shown in place of the base's; none where the relief is found pixel by pixel on it.
    pub fn geometry(&self) -> Option<Geometry> {
        let Choice { entry, params, .. } = &self.choices[GEOMETRY];
        match entry.name {
            geometry::VERTEX => Some(Geometry::Texels(params[0] as u32)),
            geometry::REMESH => Some(Geometry::Pixels(params[0])),
            geometry::TESSELLATE => Some(Geometry::Tessellated(Tessellated::of(*params))),
            geometry::SLICES => Some(Geometry::Slices(Slices::of(self.choices[SLICES].params, params[0]))),
            geometry::OBJECT_SLICES => {
                Some(Geometry::ObjectSlices(Slices::of(self.choices[SLICES].params, 0.0), params[0] != 0.0))
            }
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
    /// sees triangles; with that of slices the surface `slices` and no search; with the geometry `none` a
    /// surface that relief lies on.
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
        let (place, stage, name) =
            stage_of_setting(key).ok_or_else(|| SelectionError::Key(key.to_owned()))?;
        if stage.chosen_as == Some(name) {
            let greatest = (stage.entries.len() - 1) as f32;
            let number = checked(key, &whole_to(greatest), value)? as usize;
            // Its variants have the same parameters.
            let chosen = Choice::new(stage, number);
            self.choices[place] = Choice { params: self.choices[place].params, ..chosen };
            if place == OBJECT {
                *self = self.with_search_for_object();
            }
            return Ok(());
        }
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
        if (place, name) == (SLICES, "refine") && self.uses(SLICES) {
            *self = self.with_refinement_of_slices();
        }
        if place == OBJECT {
            *self = self.with_search_for_object();
        }
        Ok(())
    }

    /// The number that a setting's value is, which may be said by a name, as in `slices.test=band`.
    ///
    /// # Errors
    ///
    /// When the text is neither a number nor a name of that setting's.
    pub fn value_of(key: &str, text: &str) -> Result<f64, SelectionError> {
        if let Ok(number) = text.parse() {
            return Ok(number);
        }
        let no_number = || SelectionError::NoNumber { key: key.to_owned(), text: text.to_owned() };
        Self::value_named(key, text)?.ok_or_else(no_number)
    }

    /// The number that a name stands for as a setting's value; none where its values are plain numbers.
    ///
    /// # Errors
    ///
    /// When its values have other names.
    pub fn value_named(key: &str, name: &str) -> Result<Option<f64>, UnknownName> {
        let names = stage_of_setting(key).map_or(Vec::new(), |(_, stage, name)| stage.names_of(name));
        match names.iter().position(|known| *known == name) {
            Some(place) => Ok(Some(place as f64)),
            None if names.is_empty() => Ok(None),
            None => Err(UnknownName::new("value", name, names)),
        }
    }

    /// The name of a setting's value where its values have names.
    pub fn name_of(key: &str, value: f64) -> Option<&'static str> {
        let (_, stage, name) = stage_of_setting(key)?;
        stage.names_of(name).into_iter().enumerate().find_map(|(k, name)| (k as f64 == value).then_some(name))
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

    /// Whether a variant of a stage, with default parameters, goes with all that is chosen for the other
    /// stages. Displaced triangles and objects, for example, read no bent normals: `sky` does not go with
    /// them, `hemisphere` does.
    ///
    /// # Errors
    ///
    /// When there is no such stage or no such variant.
    pub fn goes_with(&self, key: &str, name: &str) -> Result<bool, SelectionError> {
        let mut other = *self;
        other.choose(key, name)?;
        Ok(other.check().is_ok())
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

    /// How far beside a shell its hits may lie, in texels: segments reach as far beyond its sides, so that
    /// nothing passes between neighbours.
    pub fn beside_shells_texels(&self) -> f32 {
        let Choice { entry, params, .. } = &self.choices[SURFACE];
        entry.param("tolerance").map_or(0.0, |(place, _)| 2.0 * params[place])
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

    /// Whether normals are those of a relief, not of triangles or silhouettes.
    pub fn has_normals_of_relief(&self) -> bool {
        self.paths().has_normals_of_relief()
            && !self.object_cells().is_some_and(|object| object.solid == Solid::Hull)
    }

    /// Whether all other stages make something of the surface's segments.
    ///
    /// # Errors
    ///
    /// When one does not.
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
            return error(GEOMETRY, of_geometry.needs().to_owned());
        }
        if let Some(Geometry::Slices(slices)) = self.geometry()
            && slices.by_border
            && slices.direction != SliceDirection::Screen
        {
            return error(GEOMETRY, "a border clips slices at equal depths alone".to_owned());
        }
        if let Some(Geometry::Tessellated(tessellated)) = self.geometry()
            && let Some(reason) = tessellated.refused()
        {
            return error(GEOMETRY, reason.to_owned());
        }
        match (self.is_of_images(), self.choices[OBJECT].number != 0) {
            (true, false) => return error(OBJECT, "choose what the object is of its images".to_owned()),
            (false, true) => return error(OBJECT, "there are no images that it could be made of".to_owned()),
            _ => {}
        }
        if let Some((place, reason)) = self.at_odds_with_object() {
            return error(place, reason.to_owned());
        }
        for (place, (stage, choice)) in STAGES.iter().zip(&self.choices).enumerate() {
            let of_stage = refused.iter().filter(|refused| refused.stage == stage.key);
            if let Some(refused) = of_stage.into_iter().find(|it| it.names.contain(choice.entry)) {
                return error(place, refused.reason.to_owned());
            }
        }
        for place in [SEARCH, REFINE].into_iter().filter(|_| !self.blends_normals()) {
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

    /// Whether a stage is asked for anything: the search for shadows is not where no shadow sends rays,
    /// and the test of slices where there are none.
    pub fn uses(&self, stage: usize) -> bool {
        match stage {
            SHADOW_SEARCH => !self.choices[SHADOW].entry.states.is_empty(),
            SLICES => matches!(self.shown_by_geometry(), Shown::Slices | Shown::ObjectSlices),
            OBJECT => self.is_of_images(),
            _ => true,
        }
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
        self.sends_rays_to_lights() && self.choices[SHADOW_SEARCH].number as usize == CELLS
    }

    /// Whether paths are searched, or what is found of them refined: of bump mapping and of surfaces without a
    /// relief neither is.
    pub fn is_traced(&self) -> bool {
        let chosen = |stage: usize| self.choices[stage].entry.name != "none";
        self.paths().has_relief() && (chosen(SEARCH) || chosen(REFINE))
    }

    /// Whether shadows are those of rays from the hit to the light, or to points of its disc, through the
    /// relief of the same surface.
    pub fn sends_rays_to_lights(&self) -> bool {
        let shadow = self.choices[SHADOW].number as usize;
        shadow == RAY || shadow == SOFT
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
        numbers == [CELLS, PATCH] && !self.uses(OBJECT)
    }
}

/// A number from 0 to that one.
const fn whole_to(max: f32) -> Param {
    Param { name: "", summary: "", unit: "", min: 0.0, max, default: 0.0, integer: true, names: &[] }
}

fn checked(key: &str, param: &Param, value: f64) -> Result<f32, SelectionError> {
    let (min, max) = (f64::from(param.min), f64::from(param.max));
    if !(min..=max).contains(&value) || (param.integer && value.fract() != 0.0) {
        let (min, max, integer) = (param.min, param.max, param.integer);
        return Err(SelectionError::Value { key: key.to_owned(), value, min, max, integer });
    }
    Ok(value as f32)
}

#[cfg(test)]
mod tests;
