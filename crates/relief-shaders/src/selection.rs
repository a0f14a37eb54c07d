//! A chosen surface, search, refinement and shading with their settings.

use relief_core::registry::{self, Entry, MAX_PARAMS, Param, UnknownName};

use crate::{Method, refine, search, shade, surface};

/// What to run: one variant of every stage, and the parameters of search and refinement.
#[derive(Clone, Copy, Debug)]
pub struct Selection {
    /// The surface.
    pub surface: &'static Entry,
    /// The search.
    pub search: &'static Entry,
    /// The refinement.
    pub refine: &'static Entry,
    /// The shading.
    pub shade: &'static Entry,
    /// The search's parameters, in its entry's order.
    pub search_params: [f32; MAX_PARAMS],
    /// The refinement's parameters, in its entry's order.
    pub refine_params: [f32; MAX_PARAMS],
}

/// Why a selection cannot be made.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SelectionError {
    /// No variant has that name.
    #[error(transparent)]
    Unknown(#[from] UnknownName),
    /// A setting's key has another form.
    #[error("the setting '{0}' must begin with 'search.' or 'refine.', as in search.steps=64")]
    Key(String),
    /// The variant has no such parameter.
    #[error("the {stage} '{entry}' has no parameter '{name}'{}", known(.entries))]
    NoParam {
        /// "search" or "refinement".
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
}

fn known(names: &[&str]) -> String {
    if names.is_empty() { "; it has none".to_owned() } else { format!("; it has {}", names.join(", ")) }
}

impl Selection {
    /// A search and a refinement by name, on a plane, with default parameters.
    ///
    /// # Errors
    ///
    /// When a name is unknown.
    pub fn pair(search: &str, refine: &str) -> Result<Self, SelectionError> {
        let search = registry::find("search", search::ENTRIES, search)?;
        let refine = registry::find("refinement", refine::ENTRIES, refine)?;
        Ok(Self {
            surface: &surface::ENTRIES[0],
            search,
            refine,
            shade: &shade::ENTRIES[0],
            search_params: search.defaults(),
            refine_params: refine.defaults(),
        })
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
        for &(key, value) in method.settings {
            selection.set(key, f64::from(value))?;
        }
        Ok(selection)
    }

    /// Sets a parameter, as in `set("search.steps", 64.0)`.
    ///
    /// # Errors
    ///
    /// When the key names no parameter of the chosen variants, or the value is out of range.
    pub fn set(&mut self, key: &str, value: f64) -> Result<(), SelectionError> {
        let (stage, name) = key.split_once('.').ok_or_else(|| SelectionError::Key(key.to_owned()))?;
        let (stage, entry, values) = match stage {
            "search" => ("search", self.search, &mut self.search_params),
            "refine" => ("refinement", self.refine, &mut self.refine_params),
            _ => return Err(SelectionError::Key(key.to_owned())),
        };
        let Some((place, param)) = entry.param(name) else {
            let entries = entry.params.iter().map(|param| param.name).collect();
            return Err(SelectionError::NoParam { stage, entry: entry.name, name: name.to_owned(), entries });
        };
        values[place] = checked(key, param, value)?;
        Ok(())
    }

    /// Whether this is the pair that has the exact answer, whatever its parameters.
    pub fn is_exact(&self) -> bool {
        self.search.name == "cells" && self.refine.name == "patch"
    }
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
mod tests {
    use super::*;
    use crate::METHODS;

    #[test]
    fn every_method_is_a_valid_selection() {
        for method in METHODS {
            assert!(Selection::of(method).is_ok(), "{}", method.name);
        }
        assert!(Selection::method("exact").is_ok_and(|selection| selection.is_exact()));
    }

    #[test]
    fn settings_reach_their_place_and_nothing_else_is_accepted() {
        let mut selection = Selection::method("relief").expect("a method");
        selection.set("search.grazing", 4.0).expect("a parameter");
        assert_eq!(selection.search_params, [32.0, 4.0, 0.0, 0.0]);
        assert!(matches!(selection.set("steps", 4.0), Err(SelectionError::Key(_))));
        assert!(matches!(selection.set("search.stepz", 4.0), Err(SelectionError::NoParam { .. })));
        for bad in [0.0, 1.5, f64::NAN, f64::INFINITY, -3.0] {
            assert!(matches!(selection.set("search.steps", bad), Err(SelectionError::Value { .. })), "{bad}");
        }
        assert_eq!(selection.search_params[0], 32.0);
    }
}
