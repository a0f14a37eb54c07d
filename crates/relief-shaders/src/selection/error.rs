//! Reasons why a selection cannot be made.

use relief_core::registry::UnknownName;
use relief_core::{FoundState, MAX_LAYERS};

use crate::stages::{DETAIL, STAGES, SURFACE, stage};
use crate::{Entry, Variants};

/// Reason why a selection cannot be made.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SelectionError {
    /// No stage has that key.
    #[error(
        "no stage has the key '{0}'; the keys are {keys}",
        keys = STAGES.map(|stage| stage.key).join(", ")
    )]
    NoStage(String),
    /// No variant has that name.
    #[error(transparent)]
    Unknown(#[from] UnknownName),
    /// A setting's key does not begin with a stage.
    #[error("the setting '{0}' must begin with {begin}, as in search.steps=64", begin = beginnings())]
    Key(String),
    /// The variant has no such parameter.
    #[error("the {stage} '{entry}' has no parameter '{name}'{}", known(.entries))]
    NoParam {
        /// The stage's title.
        stage: &'static str,
        /// The chosen variant.
        entry: &'static str,
        /// The name that was asked for.
        name: String,
        /// The names that exist.
        entries: Vec<&'static str>,
    },
    /// The value is not a number.
    #[error("{key} is '{text}': it must be a number")]
    NoNumber {
        /// The setting.
        key: String,
        /// The value given.
        text: String,
    },
    /// The value is not accepted.
    #[error(
        "{key} is {value}: it must be {} from {min} to {max}",
        if *integer { "a whole number" } else { "a number" }
    )]
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
        /// The ray class.
        rays: &'static str,
    },
    /// Another stage's variant cannot handle the surface's segments.
    #[error("the {stage} '{entry}' cannot be used with the surface '{surface}': {reason}")]
    Surface {
        /// The other stage's title.
        stage: &'static str,
        /// The other stage's key.
        key: &'static str,
        /// The variant chosen for it.
        entry: &'static str,
        /// The chosen surface.
        surface: &'static str,
        /// The reason, with a remedy.
        reason: String,
    },
    /// A variant does not find or show what is solid.
    #[error("the {stage} '{entry}' cannot be used with {shown}: choose {}", others.or())]
    Field {
        /// The stage's title.
        stage: &'static str,
        /// The stage's key.
        key: &'static str,
        /// The variant chosen for it.
        entry: &'static str,
        /// What the surface shows.
        shown: &'static str,
        /// The variants that can be used.
        others: Variants,
    },
    /// A variant's baked map has only the finest level of detail.
    #[error(
        "the {stage} '{entry}' cannot be used with the detail '{detail}': the levels of its map are not \
         levels of detail; choose another {stage}, or the detail {none}",
        none = Variants::of(DETAIL, Entry::is_idle).or()
    )]
    OneLevel {
        /// The title of the stage that reads the map.
        stage: &'static str,
        /// The key of that stage.
        key: &'static str,
        /// The variant chosen for it.
        entry: &'static str,
        /// The chosen detail.
        detail: &'static str,
    },
    /// The map of a variant would have a layer for more directions than a map has layers.
    #[error(
        "{key}.azimuths times {key}.elevations are {directions}: the map of the {stage} '{entry}' has a \
            layer for each, and a map at most {MAX_LAYERS}: take fewer"
    )]
    Directions {
        /// The title of the stage that reads the map.
        stage: &'static str,
        /// The key of that stage.
        key: &'static str,
        /// The variant chosen for it.
        entry: &'static str,
        /// The directions.
        directions: f32,
    },
    /// A variant does not take the results of the search before it.
    #[error(
        "the {} '{}' cannot use the result of the {} '{}': it takes {}, not {}",
        title(.taker.0), .taker.1, title(.giver.0), .giver.1, named(.takes), named(.gives)
    )]
    Pair {
        /// The key of the search's stage, and the search.
        giver: (&'static str, &'static str),
        /// The key of the next stage, and the variant chosen for it.
        taker: (&'static str, &'static str),
        /// The results with which the search ends.
        gives: &'static [FoundState],
        /// The results that the other variant takes.
        takes: &'static [FoundState],
    },
}

impl SelectionError {
    /// Returns the keys of the stages whose variants do not go together; empty if a single value is
    /// wrong.
    pub fn keys(&self) -> Vec<&'static str> {
        match self {
            SelectionError::Impossible { key, .. } => vec![key],
            SelectionError::Surface { key, .. } => vec![key, STAGES[SURFACE].key],
            SelectionError::Field { key, .. } => vec![key],
            SelectionError::OneLevel { key, .. } => vec![key, STAGES[DETAIL].key],
            SelectionError::Pair { giver, taker, .. } => vec![taker.0, giver.0],
            _ => Vec::new(),
        }
    }
}

/// The title of a stage in messages, by its key.
fn title(key: &str) -> &str {
    stage(key).map_or(key, |(_, stage)| stage.title)
}

fn named(states: &[FoundState]) -> String {
    states.iter().map(|state| state.description()).collect::<Vec<_>>().join(" or ")
}

/// The beginnings of settings: the keys of all stages that have parameters.
fn beginnings() -> String {
    let settable = STAGES.iter().filter(|stage| stage.entries.iter().any(|entry| !entry.params.is_empty()));
    settable.map(|stage| format!("'{}.'", stage.key)).collect::<Vec<_>>().join(" or ")
}

fn known(names: &[&str]) -> String {
    if names.is_empty() { "; it has none".to_owned() } else { format!("; it has {}", names.join(", ")) }
}
