//! A variant chosen for every stage, with its settings.

mod check;
mod companions;
mod error;
mod roles;

use relief_core::registry::{Guarantees, MAX_PARAMS, Param, UnknownName};

pub use self::error::SelectionError;
use crate::entry::{Entry, find};
use crate::stages::{
    GEOMETRY, OBJECT, REFINE, SEARCH, SHADOW, SHADOW_SEARCH, SLICES, STAGES, Stage, stage, stage_of_setting,
};
use crate::{METHODS, Method};

/// A stage's variant, and its parameters.
#[derive(Clone, Copy, Debug)]
pub struct Choice {
    /// The variant.
    pub entry: &'static Entry,
    /// The variant's number in the shaders: its place in the stage's list.
    pub number: u32,
    /// The parameters, in the entry's order.
    pub params: [f32; MAX_PARAMS],
}

/// A choice of a variant for every stage, with parameters.
#[derive(Clone, Copy, Debug)]
pub struct Selection {
    /// The choices, in the order of [`STAGES`].
    pub choices: [Choice; STAGES.len()],
    /// Columns, rows and slices of the volume that is shown; 0 without one.
    pub(crate) volume_size: [u32; 3],
}

impl Choice {
    /// The variant of that number, with its default parameters.
    fn new(stage: &'static Stage, number: usize) -> Self {
        let entry = &stage.entries[number];
        Self { entry, number: number as u32, params: entry.defaults() }
    }

    /// The value of the parameter of that name; 0 where the variant has none.
    pub(crate) fn value(&self, name: &str) -> f32 {
        self.entry.param(name).map_or(0.0, |(place, _)| self.params[place])
    }

    /// Sets the parameter of that name, which messages call by its key.
    fn set(&mut self, stage: &Stage, name: &str, key: &str, value: f64) -> Result<(), SelectionError> {
        let Some((place, param)) = self.entry.param(name) else {
            let entries = self.entry.params.iter().map(|param| param.name).collect();
            let (stage, entry, name) = (stage.title, self.entry.name, name.to_owned());
            return Err(SelectionError::NoParam { stage, entry, name, entries });
        };
        self.params[place] = checked(key, param, value)?;
        Ok(())
    }

    /// The guarantee of the variant with these parameters.
    fn promises(&self) -> Guarantees {
        self.entry.promises(&self.params)
    }
}

impl Default for Selection {
    /// Chooses the first variant of every stage, and for shadows a search that can trace them.
    fn default() -> Self {
        let choices = std::array::from_fn(|place| Choice::new(&STAGES[place], 0));
        Self { choices, volume_size: [0; 3] }.with_search_for_shadows()
    }
}

impl Selection {
    /// Chooses a search and a refinement by name, with default parameters, and the first variant of
    /// all other stages.
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

    /// Chooses the pair that has the exact answer without a baked map.
    pub fn exact() -> Self {
        Self::default().with_reference().with_search_for_shadows()
    }

    /// Chooses a method by name, with its settings.
    ///
    /// # Errors
    ///
    /// When the name is unknown.
    pub fn method(name: &str) -> Result<Self, SelectionError> {
        Self::of(crate::method(name)?)
    }

    /// Chooses a method, with its settings.
    ///
    /// # Errors
    ///
    /// When the method names a variant that does not exist.
    pub fn of(method: &Method) -> Result<Self, SelectionError> {
        let mut selection = Self::pair(method.search, method.refine)?;
        selection.choose(STAGES[GEOMETRY].key, method.geometry)?;
        for &(key, value) in method.settings {
            selection.set(key, f64::from(value))?;
        }
        Ok(selection)
    }

    /// Returns the name of the method that it is; of a pair without one, such as `linear+patch`, both names.
    /// Settings distinguish methods of the same variants.
    pub fn method_name(&self) -> String {
        let [geometry, search, refine] =
            [GEOMETRY, SEARCH, REFINE].map(|place| self.choices[place].entry.name);
        let is_same =
            |method: &&Method| (method.geometry, method.search, method.refine) == (geometry, search, refine);
        let has_settings = |method: &&Method| {
            let mut with = *self;
            let is_set = method.settings.iter().all(|(key, value)| with.set(key, f64::from(*value)).is_ok());
            let mut each = with.choices.iter().zip(&self.choices);
            is_set && each.all(|(a, b)| (a.number, a.params) == (b.number, b.params))
        };
        let same = || METHODS.iter().filter(is_same);
        // The one that says most of what it is.
        let found = same().rev().filter(has_settings).max_by_key(|method| method.settings.len());
        let found = found.or_else(|| same().next());
        found.map_or_else(|| format!("{search}+{refine}"), |method| method.name.to_owned())
    }

    /// Chooses a variant by its stage's key and its name, as in `choose("search", "linear")`, with
    /// default parameters. A search or a shadow also chooses the search for shadows: the view's
    /// search, or the reference if the view's cannot trace shadows. To choose another, set
    /// `shadow-search` afterwards. A geometry also chooses its
    /// [companions](crate::geometry::GeometryRole::companions), or a surface that shows its
    /// triangles.
    ///
    /// # Errors
    ///
    /// When there is no such stage or no such variant.
    pub fn choose(&mut self, key: &str, name: &str) -> Result<(), SelectionError> {
        let (place, stage) = stage(key).ok_or_else(|| SelectionError::NoStage(key.to_owned()))?;
        let number = find(stage.title, stage.entries, name)?;
        self.choices[place] = Choice::new(stage, number);
        if place == GEOMETRY {
            *self = self.with_companions_of_geometry()?;
        }
        if place == SEARCH {
            *self = self.with_field_of_search().with_surface_of_search();
        }
        if place == SEARCH || place == SHADOW {
            *self = self.with_search_for_shadows();
        }
        Ok(())
    }

    /// Sets a parameter, as in `set("search.steps", 64.0)`. If the search for shadows is the
    /// view's, with the same parameters, both are set.
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
            // All variants of the stage have the same parameters.
            let chosen = Choice::new(stage, number);
            self.choices[place] = Choice { params: self.choices[place].params, ..chosen };
            if place == OBJECT {
                *self = self.with_companions_of_object()?;
            }
            return Ok(());
        }
        let [view, shadow] = [SEARCH, SHADOW_SEARCH].map(|stage| &self.choices[stage]);
        let follows = place == SEARCH && (view.number, view.params) == (shadow.number, shadow.params);
        self.choices[place].set(stage, name, key, value)?;
        if follows {
            *self = self.with_search_for_shadows();
        }
        if (place, name) == (SLICES, "refine") && self.uses(SLICES) {
            *self = self.with_refinement_of_slices();
        }
        if place == OBJECT {
            *self = self.with_companions_of_object()?;
        }
        Ok(())
    }

    /// Returns the number of a setting's value, which may be given by name, as in
    /// `slices.test=band`.
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

    /// Returns the number that a name stands for as a setting's value; `None` if its values are
    /// plain numbers.
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

    /// Returns the name of a setting's value, if its values have names.
    pub fn name_of(key: &str, value: f64) -> Option<&'static str> {
        let (_, stage, name) = stage_of_setting(key)?;
        stage.names_of(name).into_iter().enumerate().find_map(|(k, name)| (k as f64 == value).then_some(name))
    }
}

/// A whole number from 0 to `max`.
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
